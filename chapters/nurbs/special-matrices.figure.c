/* special-matrices.figure.c -- drawings for special-matrices.claims.h. */
#include "chapters/nurbs/matrix-figures.h"

/* The three quadratic B-splines of a span, and what (4.4.23) gives with its factors as printed and the exponent put right. */
FIGURE(simple_knots_sign)
{
    enum { p = 2, k = 3 };
    static const int from[2 * k] = {-2, -1, 0, 2, 3, 5};
    num_q u[2 * k], A[k * k], c[k];
    svg *s = svg_new(
        "simple_knots_sign", "For odd orders the printed factors give the negative matrix",
        "The three quadratic B-splines on the span from 0 to 2 of simple knots, all positive, and the functions "
        "of the matrix with the printed factors and the exponent k-1-j, which are their negatives.");
    integers(2 * k, from, u);
    bspline_matrix_simple_q(p, u, p, A);
    svg_panel(s, window(r(-1, 4), r(-1, 1), r(9, 4), r(1, 1)), 420, 260, "$k=3$, knots $-2,-1,0,2,3,5$, span $[0,2)$");
    svg_axes(s, r(1, 2), r(1, 2), "t", NULL);
    for (int i = 0; i < k; i++) {
        column_of(p, A, i, q(1), c);
        put_polynomial(s, p, c, q(0), q(2), SVG_RIGHT);
        column_of(p, A, i, q(-1), c); /* as printed: the factor (-1)^k */
        put_polynomial(s, p, c, q(0), q(2), SVG_WRONG);
    }
    svg_legend_line(s, SVG_RIGHT, "factors $t_l-t_α$: $N_{i,3}$");
    svg_legend_line(s, SVG_WRONG, "factors $t_α-t_l$, as printed");
    return s;
}
