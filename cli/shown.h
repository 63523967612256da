/* shown.h -- what a claim shows: numbers under their names, and what was compared. */
#ifndef CAGD_SHOWN_H
#define CAGD_SHOWN_H

#include "chapters/judge/run.h"

/* The sentence of a claim: "given ...", "let ...", "then ...", a line each. */
void print_sentence(const claim *c, int indent);
/* A counterexample: its sentence, which says what its letters are, its numbers, and what was compared. */
void print_counterexample(const claim_result *r);
/* The numbers alone: of what is true nothing is compared and found to differ. */
void print_numbers(const claim_result *r, int indent);
/* The same under a heading, and a small instance of an identity that fails unexpectedly, if one was found. */
void print_failure(const claim_result *r);
#endif
