/* case.h -- one case of one claim in one number type: what run.c repeats and certificate.c records. */
#ifndef CAGD_CASE_H
#define CAGD_CASE_H

#include "chapters/judge/claim.h"

struct plan {
    const claim *claim;
    number_type type;
    int deep;
};

/* Run case k; the degree is that of the claim's range with the number k, taken in turn.  The faults are returned in
 * region_faults.  The names of the field's variables, and of those taken to be positive, go to *variables and *positive,
 * if wanted; the caller frees both, and the exhibits of the trial. */
trial run_case(const struct plan *p, int k, int planted, char **variables, char **positive);
/* Entries of the claim's data that this case had to ask for and did not become mistakes. */
void look_for_unused(trial *T);
void forget_exhibits(exhibit *shown, int count);
#endif
