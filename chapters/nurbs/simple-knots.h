/* simple-knots.h -- formula (4.4.23) for simple knots by its letter, for the sections on simple and on equidistant knots. */
#include "chapters/nurbs/spans.h"

#include "chapters/judge/claims_on.h"

/* The product over all m = i, ..., i+k but l of t_m - t_l (as printed), or of t_l - t_m. */
static inline num G(product_of_differences)(const num t[], int i, int k, int l, int as_printed)
{
    num product = from_int(1);
    for (int m = i; m <= i + k; m++)
        if (m != l)
            product = mul(product, as_printed ? sub(t[m], t[l]) : sub(t[l], t[m]));
    return product;
}

/* (4.4.23) by its letter, but for the exponent, which is given: k-1-j, or k-l-j with the number l of the knot. */
static inline num G(printed_entry)(const struct G(span) * S, int i, int j, int letter, int as_printed)
{
    int k = S->k, r = S->r;
    num sum = from_int(0), step = sub(S->t[r], S->t[r + 1]);
    for (int l = r + 1; l <= i + k; l++) {
        int exponent = letter ? k - l - j : k - 1 - j;
        num gap = sub(S->t[l], S->t[r]);
        num power = exponent >= 0 ? G(power)(gap, exponent) : div(from_int(1), G(power)(gap, -exponent));
        sum = add(sum, div(power, G(product_of_differences)(S->t, i, k, l, as_printed)));
    }
    return mul(mul(G(choose)(k - 1, j), sub(S->t[i + k], S->t[i])), mul(G(power)(step, j), sum));
}

#include "chapters/judge/claims_off.h"
