/* steps.h -- the steps that decide a statement: claims, arguments in words, cited theorems. */
#ifndef CAGD_STEPS_H
#define CAGD_STEPS_H

#include "chapters/judge/run.h"

/* "Two identities and an argument in words decide it together." */
void print_deciders(const statement *s, role wanted, const claim_result *results, int count);
/* Each step: the claims of a role, with how they are known where that is not what is known of all together; then, if they
 * belong there, the words. */
void print_steps(const statement *s, role wanted, const finding *together, int with_words, const claim_result *results,
                 int count);
#endif
