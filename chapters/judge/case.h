/* case.h -- one case of one claim in one number type: what run.c repeats and certificate.c records. */
#ifndef CAGD_CASE_H
#define CAGD_CASE_H

#include "chapters/judge/claim.h"

struct plan {
    const claim *claim;
    number_type type;
    int deep;
    struct small_data *small; /* see trial.small */
};

/* Run case k; the degree is that of the claim's range with the number k, taken in turn.  The faults are returned in
 * region_faults.  The names of the field's variables, and of those taken to be positive, go to *variables and *positive,
 * if wanted; the caller frees both, and the exhibits of the trial. */
trial run_case(const struct plan *p, int k, int planted, char **variables, char **positive);
/* The outcome of a case that was just run: undefined, unable and false are three answers; a case that compared nothing
 * fails, and one whose block says otherwise. */
outcome judged_case(trial *T);
/* A failing case is told with its degree, in the letter of the claim, unless it shows that itself. */
void show_degree(const claim *c, trial *T);
/* Entries of the claim's data that this case had to ask for and did not become mistakes. */
void look_for_unused(trial *T);
void forget_exhibits(exhibit *shown, int count);
#endif
