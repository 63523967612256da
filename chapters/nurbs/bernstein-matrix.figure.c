/* bernstein-matrix.figure.c -- drawings for bernstein-matrix.claims.h. */
#include "chapters/nurbs/matrix-figures.h"

/* The printed matrix of the knots of Bernstein, the right one, and the functions that they give. */
FIGURE(bernstein_matrix)
{
    enum { p = 3, k = 4 };
    num_q A[k * k], B[k * k], c[k];
    svg *s = svg_new(
        "bernstein_matrix", "The matrix of the Bernstein basis",
        "Left the printed matrix of order 4, triangular on the wrong side and with quotients of binomial coefficients; "
        "in the middle the right one; right the four functions of each: the Bernstein polynomials, and others.");
    bernstein_matrix_q(p, A);
    for (int j = 0; j < k; j++)
        for (int i = 0; i < k; i++)
            B[j * k + i] = i < j ? q(0) : r((i + j) % 2 == 0 ? binomial(p, i) : -binomial(p, i), binomial(i, j));
    put_matrix(s, k, B, 56, "printed: $(-1)^{i+j}C(3,i)/C(i,j)$");
    svg_heading(s, SVG_WRONG, "$i≥j$");
    put_matrix(s, k, A, 56, "right: $(-1)^{i+j}C(3,j)C(j,i)$");
    svg_heading(s, SVG_RIGHT, "$j≥i$");
    svg_panel(s, window(q(0), r(-16, 5), q(1), r(24, 5)), 260, 225, "the functions of the columns");
    svg_axes(s, r(1, 2), q(1), "t", NULL);
    for (int i = 0; i < k; i++) {
        column_of(p, B, i, q(1), c);
        put_polynomial(s, p, c, q(0), q(1), SVG_WRONG);
        column_of(p, A, i, q(1), c);
        put_polynomial(s, p, c, q(0), q(1), SVG_RIGHT);
    }
    svg_legend_line(s, SVG_RIGHT, "$B_i^3(t)$");
    svg_legend_line(s, SVG_WRONG, "the columns of the printed matrix");
    return s;
}
