/* readings.h -- the ways to read a statement, what is known of each, and which one is meant. */
#ifndef CAGD_READINGS_H
#define CAGD_READINGS_H

#include "chapters/judge/run.h"

int has_reading(const statement *s);
/* The verdict, what is true first: "True: an envelope (1). False: the envelope (2); the same without inflections (3)." */
void print_undecided(const statement *s, const claim_result *results, int count);
/* Which of several readings the text itself has, and by what one knows. */
void print_meant(const statement *s);
/* The ways to read it, with their numbers: behind whether it is true, how that is known. */
void print_readings(const statement *s, const claim_result *results, int count);
/* The claims by which readings are true, where no step of the page is the same claim. */
void print_deciding_claims(const statement *s, const claim_result *results, int count);
/* The numbers that show of a reading that it fails. */
void print_failing_readings(const statement *s, const claim_result *results, int count);
#endif
