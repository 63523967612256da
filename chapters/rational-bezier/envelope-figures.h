/* envelope-figures.h -- the members of the families of a curve, drawn. */
#ifndef CAGD_RATIONAL_BEZIER_ENVELOPE_FIGURES_H
#define CAGD_RATIONAL_BEZIER_ENVELOPE_FIGURES_H

#include "chapters/judge/figure.h"
#include "figures/words.h"

/* The members of level `level` of the curve (R, w) for c = 0, 1/pieces, ..., 1. */
static inline void put_family(svg *s, int n, const num_q R[], const num_q w[], int level, int pieces)
{
    num_q Rr[2 * MAX_DEGREE + 2], wr[MAX_DEGREE + 1];
    for (int k = 0; k <= pieces; k++) {
        rational_casteljau_q(n, 2, R, w, r(k, pieces), level, Rr, wr);
        if (n - level == 1)
            svg_segment(s, svg_pair(Rr), svg_pair(Rr + 2), SVG_FAMILY);
        else
            svg_rational(s, n - level, Rr, wr, SVG_FAMILY);
    }
}

/* One member, in a role, with its control polygon. */
static inline void put_member(svg *s, int n, const num_q R[], const num_q w[], int level, num_q c,
                              enum svg_role drawn_as)
{
    num_q Rr[2 * MAX_DEGREE + 2], wr[MAX_DEGREE + 1];
    rational_casteljau_q(n, 2, R, w, c, level, Rr, wr);
    if (n - level == 1)
        svg_segment(s, svg_pair(Rr), svg_pair(Rr + 2), drawn_as);
    else
        svg_rational(s, n - level, Rr, wr, drawn_as);
}

static inline void ones(int n, num_q w[])
{
    for (int i = 0; i <= n; i++)
        w[i] = q(1);
}
#endif
