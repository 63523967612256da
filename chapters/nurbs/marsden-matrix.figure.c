/* marsden-matrix.figure.c -- drawings for marsden-matrix.claims.h. */
#include "chapters/nurbs/matrix-figures.h"

/* G, and the matrix by Marsden's identity beside that by divided differences, for a span with a double end. */
FIGURE(both_matrices)
{
    enum { p = 3, k = 4 };
    static const int from[2 * k] = {-4, -2, 0, 0, 2, 3, 5, 6}, group[2 * k] = {0, 1, 2, 2, 3, 4, 5, 6};
    num_q u[2 * k], g[k * k], A[k * k], B[k * k];
    svg *s = svg_new(
        "both_matrices", "Two ways to one matrix",
        "For the knots -2, 0, 0, 2, 3, 5 and the span from 0 to 2: the matrix G, which gives the powers of t from the "
        "B-splines, and the coefficient matrix by its inverse and by divided differences.  The last two are equal.");
    integers(2 * k, from, u);
    marsden_matrix_q(p, u, p, g);
    bspline_matrix_by_marsden_q(p, u, p, A);
    bspline_matrix_by_differences_q(p, u, group, p, B);
    put_matrix(s, k, g, 64, "the matrix $G$ of (4.4.18)");
    put_matrix(s, k, A, 64, "(4.4.17), from the cofactors of $G$");
    put_matrix(s, k, B, 64, "(4.4.12), from divided differences");
    return s;
}
