/* shown.h -- what a claim shows: numbers under their names, and what was compared. */
#ifndef CAGD_SHOWN_H
#define CAGD_SHOWN_H

#include "chapters/judge/run.h"

void print_exhibits(const claim_result *r);
#endif
