/* terms.h -- trees as products of binomial coefficients, factorials, powers and rational functions of n and k (only for every.c and
 * closed.c). */
#ifndef CAGD_TERMS_H
#define CAGD_TERMS_H

#include "exact/decide/sums.h"
#include "exact/expression/evaluate.h"

/* A product of powers of trees, as it is taken apart: ratios of neighbours, and the product of the factors that are rational
 * functions of n and k. */
typedef struct cagd_product {
    cagd_term ratio;
    cagd_num_f rational;
} cagd_product;

/* What stands for b^n, (p n)!, or a sum or product of f(k) over k = low, ..., p n: a variable w of the field, which satisfies
 * w(n+1) = times w(n) + plus, both free of w, in n and earlier variables.  Powers and factorials are transcendental over the rational
 * functions of n. */
typedef enum cagd_growth_kind { CAGD_OF_POWER, CAGD_OF_FACTORIAL, CAGD_OF_SUM, CAGD_OF_PRODUCT } cagd_growth_kind;
typedef struct cagd_growth {
    cagd_growth_kind kind;
    int by;          /* p, of a power 1         */
    cagd_num_f base; /* b, of a power           */
    long low;        /* of a sum, of a product  */
    const cagd_tree *of;
    cagd_num_f w, times, plus;
} cagd_growth;
enum { CAGD_MOST_GROWTHS = 12, CAGD_MOST_CLOSED = 4, CAGD_MOST_DIVISORS = 64 };

/* What a sum of terms F rests on: its letter k, and a F(k) = G(k+1) - G(k), G = R F; where F is a polynomial in k, G itself stands in R. */
typedef struct cagd_closed_sum {
    const char *k;
    cagd_num_f a, R;
    int is_polynomial;
} cagd_closed_sum;

/* Made by cagd_search_begin.  n and k are variables of the field; the name of n is bound in the context, where it is at least `from`. */
typedef struct cagd_search {
    cagd_context c;
    cagd_num_f n, k, j; /* j: the letter of a product over a range */
    int depth;
    int from; /* a value is asked for whole n >= from */
    cagd_growth growth[CAGD_MOST_GROWTHS];
    int growths;
    cagd_closed_sum closed[CAGD_MOST_CLOSED]; /* the sums with closed forms that were met */
    int closed_sums;
    cagd_num_f divisor[CAGD_MOST_DIVISORS]; /* by which was divided since they were checked: c.divisors */
} cagd_search;

void cagd_search_begin(cagd_search *s, const cagd_scope *scope, const char *n, int from);
cagd_num_f cagd_power_f(cagd_num_f a, int e);
/* In the letters of the statement, n and k being those of the search. */
const char *cagd_in_letters(const cagd_search *s, cagd_num_f a, const char *n, const char *k);

/* The value as a rational function of n and k; 0 where it is none. */
int cagd_value_in(cagd_search *s, const cagd_tree *t, const cagd_frame *f, cagd_num_f *out);
/* v as p n + q k + c with small whole p and q, and c free of n and k; 0 where it is not. */
int cagd_linear_in(cagd_search *s, cagd_num_f v, int *p, int *q, cagd_num_f *c);
/* k from low_by n + low to by n + last, by > low_by. */
typedef struct cagd_range {
    int low_by, by;
    long low, last;
} cagd_range;
/* The same from `low` to n + `last`. */
cagd_range cagd_range_to_n(long low, long last);
/* Whether the denominator of a is 0 for no whole k of the range, n >= s->from, where there is one: of n alone, for no such n. */
int cagd_divides_in_range(const cagd_search *s, cagd_num_f a, cagd_range range);
/* Whether none of the divisors is 0 there; they are forgotten.  So that (n-9)/(n-9) is not taken for 1. */
int cagd_divisors_are_not_zero(cagd_search *s, cagd_range range);
/* What the name t stands for, in the frame *inner whose nodes are room[]: NULL where it has no definition that fits, or is derived. */
const cagd_tree *cagd_called_body(cagd_search *s, const cagd_tree *t, const cagd_frame *f, cagd_frame room[],
                                  const cagd_frame **inner);
/* The product times t^e; 0 where t is no product of that kind. */
int cagd_take(cagd_search *s, const cagd_tree *t, const cagd_frame *f, int e, cagd_product *out);
/* The same with e = 1, of the term of a sum: k is a whole number of the range. */
int cagd_take_within(cagd_search *s, const cagd_tree *t, const cagd_frame *f, cagd_range range, cagd_product *out);
#endif
