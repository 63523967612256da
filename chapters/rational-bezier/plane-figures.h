/* plane-figures.h -- polynomials in x and y, for drawings of where they are 0. */
#ifndef CAGD_RATIONAL_BEZIER_PLANE_FIGURES_H
#define CAGD_RATIONAL_BEZIER_PLANE_FIGURES_H

#include "chapters/judge/figure.h"
#include "figures/words.h"

/* A polynomial in x and y: the sum of t[k][0] x^t[k][1] y^t[k][2]. */
struct terms {
    int count, t[8][3];
};
static inline num_q value_of(svg_point p, const void *data)
{
    const struct terms *F = data;
    num_q sum = q(0);
    for (int k = 0; k < F->count; k++) {
        num_q term = q(F->t[k][0]);
        for (int j = 0; j < F->t[k][1]; j++)
            term = mul_q(term, p.x);
        for (int j = 0; j < F->t[k][2]; j++)
            term = mul_q(term, p.y);
        sum = add_q(sum, term);
    }
    return sum;
}
#endif
