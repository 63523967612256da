/* sums.h -- sums of hypergeometric terms for every n, by creative telescoping (超几何和, 创造性伸缩法).
 *
 * A term F(n,k) is hypergeometric when F(n+1,k)/F(n,k) and F(n,k+1)/F(n,k) are rational functions of n and k: products of
 * binomial coefficients, factorials and powers are.  The variables n and k, and any others, are variables of the field.  For a
 * proper term there are polynomials a_0(n), ..., a_J(n), not all 0, and a rational function R(n,k) with
 *
 *     sum_j a_j(n) F(n+j,k) = G(n,k+1) - G(n,k),   G = R F,
 *
 * which everybody can check by dividing by F: it is one identity of rational functions.  Summed over k it becomes a recurrence
 * for the sums.  Sources: M. Petkovšek, H. Wilf, D. Zeilberger, A = B, ch. 5 and 6; W. Koepf, Hypergeometric Summation, ch. 5
 * and 7. */
#ifndef CAGD_SUMS_H
#define CAGD_SUMS_H

#include "exact/number/field.h"

enum { CAGD_TELESCOPER_ORDER = 6 };

/* F(n+1,k)/F(n,k) and F(n,k+1)/F(n,k). */
typedef struct cagd_term {
    cagd_num_f by_n, by_k;
} cagd_term;

typedef struct cagd_telescoper {
    int order;                               /* J */
    cagd_num_f a[CAGD_TELESCOPER_ORDER + 1]; /* a_0, ..., a_J: polynomials, free of k, of which a_J is not 0     */
    cagd_num_f R;
} cagd_telescoper;

/* The term 1, and a term times (e)!, times base^e, with e = p n + q k + c for whole p and q and any c free of n and k; n and k
 * are variables of the field.  A binomial coefficient is three factorials.  `power` of a factorial: +1, -1, ... */
cagd_term cagd_term_one(void);
cagd_term cagd_term_times_factorial(cagd_term F, cagd_num_f n, cagd_num_f k, int p, int q, cagd_num_f c, int power);
cagd_term cagd_term_times_power(cagd_term F, cagd_num_f base, int p, int q);
/* F times a rational function r of n and k. */
cagd_term cagd_term_times_rational(cagd_term F, cagd_num_f n, cagd_num_f k, cagd_num_f r);
/* (n choose k): e!/(f! (e-f)!) with e = p n + q k + c, f = r n + s k + d. */
cagd_term cagd_term_times_binomial(cagd_term F, cagd_num_f n, cagd_num_f k, int p, int q, cagd_num_f c, int r, int s,
                                   cagd_num_f d);

/* The telescoper of lowest order J <= most <= CAGD_TELESCOPER_ORDER; 0 where there is none, and 1 with *T filled. */
int cagd_telescope(cagd_term F, cagd_num_f n, cagd_num_f k, int most, cagd_telescoper *T);
/* Whether the identity above is one of rational functions: all that has to be believed of T. */
int cagd_telescoper_holds(cagd_term F, cagd_num_f n, cagd_num_f k, const cagd_telescoper *T);

/* Whether the polynomial p is, for no whole n >= k >= 0 with n >= from >= 0, the function 0 of the variables besides n and k; 0 also
 * where that cannot be told. */
int cagd_is_never_zero(cagd_num_f p, cagd_num_f n, cagd_num_f k, int from);

/* A sum over k = 0, ..., N with N = p n + e, 0 <= e < p; n itself for p = 1.  With G(n,k) = R F the telescoped identity, summed over k = 0, ..., N - 1, is
 *
 *     sum_j a_j S(n+j) = G(n,N) - G(n,0) + sum_j a_j (F(n+j,N) + ... + F(n+j,N+p j)),
 *
 * whose right side has to be 0.  It is S(n) with S(n+1)/S(n) = ratio for every n >= from when both satisfy the recurrence and agree for
 * n = from, ..., from+J-1.  Steps that cannot be decided make the answer UNDECIDED; so does a factor that vanishes somewhere for
 * 0 <= k <= N.  Variables besides n and k stand for positive values wherever a sign is needed. */
enum cagd_sum_answer { CAGD_SUM_PROVED, CAGD_SUM_REFUTED, CAGD_SUM_UNDECIDED };
typedef struct cagd_sum {
    cagd_term F;
    cagd_num_f first; /* F(from,0)                                                           */
    cagd_num_f ratio; /* S(n+1)/S(n); what the sum is said to be                             */
    cagd_num_f start; /* S(from)                                                             */
    int from;         /* at least 0                                                          */
    int generic;      /* whether S(n) is meant as a rational function of the variables besides n and k, and not for
                         each of their positive values: what is 0 for some of them alone is no harm                   */
    int by, beyond;   /* p, 0 standing for 1, and e                                          */
} cagd_sum;
enum cagd_sum_answer cagd_sum_for_every_n(const cagd_sum *s, cagd_num_f n, cagd_num_f k, int most, cagd_telescoper *T);
#endif
