/* every.h -- equalities for every n (对每个 n 的等式), of terms that are products of binomial coefficients, factorials, powers and rational
 * functions: c sum_{k=low}^{p n+d} F(n,k) = S(n) by creative telescoping (exact/decide/sums.h), and sides that have closed forms. */
#ifndef CAGD_EVERY_H
#define CAGD_EVERY_H

#include "exact/expression/terms.h"

enum { CAGD_MOST_REWRITTEN = 16 };

/* What proves it.  By telescoping (closed = 0): sum_j a_j(n) F(n+j,k) = G(n,k+1) - G(n,k), G = R F, in the letters n and k of the statement, as texts; the recurrence
 * that the sum and S both satisfy, for every n from `from` on; the numbers before that are looked at one by one.  By closed forms: of each of so
 * many sums a_0(n) F(k) = G(k+1) - G(k), in the letter k of that sum; of no sum where n stands in exponents and factorials alone.  real: it was decided
 * for every real n >= from.  Of a chain a = b = c each link with a sum has its own: `of`, and the next one; so has each of several equalities. */
typedef struct cagd_every {
    int closed, order, real, counted; /* counted: k is counted from the first term, of which n is a part */
    long from;
    const char *n, *k, *a[CAGD_TELESCOPER_ORDER + 1], *R;
    int sums;
    struct cagd_closed_text {
        const char *k, *a, *R, *G; /* one of R and G, the other is NULL */
    } sum[CAGD_MOST_CLOSED];

    /* Where the closed forms differ by what has the numerator E, E(n+1) = ratio E(n), induction.h; NULL otherwise.  Its variables, and what is known of each:
     * name(n+1) = times name(n) + plus; it stands for power_of^n, for the sum or product `of` up to `by` n, or for (by n)!. */
    const char *E, *ratio;
    int variables;
    struct cagd_variable_text {
        const char *name, *power_of, *times, *plus;
        const cagd_tree *of;
        int by;
    } variable[CAGD_MOST_GROWTHS];

    /* By similar terms (similar.h): what was written as a factor times another term, in the letters of the statement. */
    int similar, by_factorials, rewritten;
    struct cagd_rewriting {
        const char *from, *factor, *to;
    } rewriting[CAGD_MOST_REWRITTEN];

    const cagd_tree *of; /* the link of a chain, or one of several, that it proves; NULL: the whole statement */
    const struct cagd_every *next;
} cagd_every;

/* Whether it holds for every n >= the lower end of the range of n, the first `checked` of them being known; 1 and *out, or 0. */
int cagd_holds_for_every(const cagd_scope *scope, const cagd_tree *statement, const cagd_variable *n, long low,
                         int checked, cagd_every *out);
/* The same, of telescoping alone, where a trace is open: the fact {"fact":"sum_for_every_n"}, with which others can check it, is noted, and 1; 0 and nothing
 * noted where it is not proved.  In the letters of exact/decide/sums.h, after k and n were shifted so that k runs from 0 to p n + e: p and e as "by" and "beyond",
 * where it is not n itself; the nodes "n" and "k"; of numerator and denominator "by_n", "by_k", "ratio", "R"; "a": a_0, ..., a_J; "first" = F(from,0); "from";
 * "left" and "right": both sides of the statement at the numbers that stand for n = from, ..., from+J+1.  The denominators in this order and a_J
 * are "rest" times so many ("counts") of the "factors" to the "powers", which are not 0 where they are needed. */
int cagd_note_for_every(const cagd_scope *scope, const cagd_tree *statement, const cagd_variable *n, long low,
                        int checked);
#endif
