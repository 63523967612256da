/* irrational.h -- a counterexample of which one number is no rational one: x^2 = 2 for the inequality x^2 \ne 2. */
#ifndef CAGD_IRRATIONAL_H
#define CAGD_IRRATIONAL_H

#include "exact/expression/evaluate.h"

typedef struct cagd_irrational_example {
    int of;                /* the binding whose value is the root; -1 where there are several, numbers of the formula */
    struct cagd_root root; /* of an irreducible polynomial        */
    cagd_num_q value[CAGD_MOST_UNKNOWNS]; /* of the other ones that have no value */
    int order;                            /* the sign of left - right there      */
} cagd_irrational_example;

/* The sides of a relation: n/m is left - right, and none of the divisors is 0 where they are defined. */
enum { CAGD_MOST_DIVISORS_OF_SIDES = 64 };
typedef struct cagd_relation_sides {
    cagd_num_f n, m, divisor[CAGD_MOST_DIVISORS_OF_SIDES];
    int divisors;
    cagd_relation relation;
} cagd_relation_sides;

/* Those of the relation k of the chain t, whose names have all been met; 0 where they are not computed. */
int cagd_find_sides(const cagd_context *c, const cagd_tree *t, int k, cagd_relation_sides *s);

/* Whether the relation k of the chain t is found false for a root of what separates its sides, or for the root near which a name is
 * (tie.h), all others having simple numbers.  Nothing is found where names are tied in other ways. */
int cagd_find_irrational_example(const cagd_context *c, const cagd_tree *t, int k, cagd_irrational_example *out);
/* Simple numbers within their bounds for all names that have none, another choice in every round. */
void cagd_choose_numbers(const cagd_context *c, int round, cagd_num_q value[]);
/* The same root between simple numbers; in the region. */
const struct cagd_root *cagd_told_root(struct cagd_root r);
#endif
