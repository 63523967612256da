/* implicit-figures.h -- the determinant (3.4.1) of a curve, for drawings of where it is 0. */
#ifndef CAGD_RATIONAL_BEZIER_IMPLICIT_FIGURES_H
#define CAGD_RATIONAL_BEZIER_IMPLICIT_FIGURES_H

#include "chapters/judge/figure.h"
#include "figures/words.h"

/* A curve whose determinant (3.4.1) is drawn. */
struct implicit_curve {
    int n;
    const num_q *R, *w;
};
static inline num_q determinant_at(svg_point p, const void *data)
{
    const struct implicit_curve *c = data;
    return implicit_value_q(c->n, c->R, c->w, p.x, p.y);
}
#endif
