/* plane-figures.h -- polynomials in x and y, for drawings of where they are 0. */
#ifndef CAGD_RATIONAL_BEZIER_PLANE_FIGURES_H
#define CAGD_RATIONAL_BEZIER_PLANE_FIGURES_H

#include "chapters/judge/figure.h"
#include "chapters/judge/figure_data.h"
#include "figures/words.h"

enum { MOST_DRAWN_TERMS = 6 };

/* A polynomial in x and y by its terms: the sum of term[3k] x^term[3k+1] y^term[3k+2]. */
struct terms {
    int count;
    num_q term[3 * MOST_DRAWN_TERMS];
};

/* The polynomial that a claim has in its data under the name. */
static inline struct terms terms_of(const char *claim_name, const char *name, int count)
{
    struct terms F = {.count = count};
    data_of(claim_name, name, count, 3, F.term);
    return F;
}

static inline num_q value_of(svg_point p, const void *data)
{
    const struct terms *F = data;
    num_q sum = q(0);
    for (int k = 0; k < F->count; k++) {
        num_q product = F->term[3 * k];
        for (int axis = 0; axis < 2; axis++)
            for (int j = (int)to_double_q(F->term[3 * k + 1 + axis]); j > 0; j--)
                product = mul_q(product, axis == 0 ? p.x : p.y);
        sum = add_q(sum, product);
    }
    return sum;
}
#endif
