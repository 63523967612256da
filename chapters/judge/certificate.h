/* certificate.h -- evidence for others (证书): what a claim computed, in a form that a program which shares nothing with
 * this one can compute again; and how the verdict of a statement follows from its claims. */
#ifndef CAGD_CERTIFICATE_H
#define CAGD_CERTIFICATE_H

#include "chapters/judge/run.h"

/* JSON, to be freed by the caller.  A certificate of a claim has cases: the straight-line program of the case, in
 * rational functions if the claim is proved in them and otherwise in rationals, its inputs, and the steps that were taken on its values, comparisons and exact decisions (exact/record/trace.h).  Of
 * the degrees that the field visits it has the lowest, and the highest whose program is not too long. */
char *certificate_of_claim(const claim_result *r);
char *certificate_of_statement(const statement_result *r);
#endif
