/* taylor.h -- functions of a parameter as their Taylor polynomials of order 3 at a point: sums, products, quotients,
 * derivatives and scalar products of vectors.
 *
 * For the other side of comparisons with derivatives: nothing here follows the kernels.  Generic text; a section includes it
 * for its one number type. */
#ifndef CAGD_RATIONAL_BEZIER_TAYLOR_H
#define CAGD_RATIONAL_BEZIER_TAYLOR_H

#include "chapters/judge/claims_on.h"

/* c[0] + c[1] e + c[2] e^2 + c[3] e^3, up to higher powers of e. */
typedef struct G(series) {
    num c[4];
} G(series);

static inline G(series) G(series_add)(G(series) a, G(series) b)
{
    for (int k = 0; k < 4; k++)
        a.c[k] = add(a.c[k], b.c[k]);
    return a;
}
static inline G(series) G(series_mul)(G(series) a, G(series) b)
{
    G(series) p;
    for (int k = 0; k < 4; k++) {
        p.c[k] = mul(a.c[0], b.c[k]);
        for (int j = 1; j <= k; j++)
            p.c[k] = add(p.c[k], mul(a.c[j], b.c[k - j]));
    }
    return p;
}
static inline G(series) G(series_div)(G(series) a, G(series) b)
{
    G(series) q;
    for (int k = 0; k < 4; k++) {
        q.c[k] = a.c[k];
        for (int j = 1; j <= k; j++)
            q.c[k] = sub(q.c[k], mul(b.c[j], q.c[k - j]));
        q.c[k] = div(q.c[k], b.c[0]);
    }
    return q;
}
/* One order is lost: the last coefficient is not known any more. */
static inline G(series) G(series_derivative)(G(series) a)
{
    for (int k = 0; k < 3; k++)
        a.c[k] = mul(from_int(k + 1), a.c[k + 1]);
    a.c[3] = from_int(0);
    return a;
}
static inline G(series) G(series_dot)(int dim, const G(series) a[], const G(series) b[])
{
    G(series) sum = G(series_mul)(a[0], b[0]);
    for (int c = 1; c < dim; c++)
        sum = G(series_add)(sum, G(series_mul)(a[c], b[c]));
    return sum;
}
#include "chapters/judge/claims_off.h"
#endif
