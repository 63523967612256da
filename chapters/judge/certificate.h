/* certificate.h -- evidence for others (证书): what a claim computed, in a form that a program which shares nothing with
 * this one can compute again; and how the verdict of a statement follows from its claims. */
#ifndef CAGD_CERTIFICATE_H
#define CAGD_CERTIFICATE_H

#include "chapters/judge/run.h"

/* A case that a certificate has: how many inputs and nodes its program has, how many comparisons it made, how many of
 * these were of a node with itself or with one of the same text, which are true whatever the program computes, and how many facts
 * it noted. */
struct recorded_case {
    number_type type;
    int degree, inputs, nodes, compared, of_the_same, facts;
};
enum { MOST_RECORDED = 2 };

/* JSON, to be freed by the caller.  A certificate of a claim has cases: the straight-line program of the case, in rational
 * functions if the claim is proved in them and otherwise in rationals, its inputs, and the steps that were taken on its values,
 * comparisons and exact decisions (exact/record/trace.h).  Of the degrees that the field visits it has the lowest, and the
 * highest whose program is not too long.  Their number goes to *count, what they have to `recorded`: with it a manifest says what
 * a certificate must have. */
char *certificate_of_claim(const claim_result *r, int *count, struct recorded_case recorded[MOST_RECORDED]);
char *certificate_of_statement(const statement_result *r);
#endif
