#include "chapters/judge/figure.h"
#include "exact/kernels_q.h"
#include "figures/svg.h"

#include <stdio.h>

/* The graph of B_i^n is the Bezier curve of the points (j/n, 1 if j = i): linear precision. */
static void graph(svg *s, int n, int i, enum svg_role role)
{
    num_q P[2 * (MAX_DEGREE + 1)];
    for (int j = 0; j <= n; j++)
        P[2 * j] = from_ratio_q(j, n), P[2 * j + 1] = from_int_q(j == i);
    svg_bezier(s, n, P, role);
}

/* The maximum of B_i^n, at i/n. */
static svg_point top(int n, int i)
{
    num_q B[MAX_DEGREE + 1], t = from_ratio_q(i, n);
    bernstein_basis_q(n, t, B);
    return (svg_point){t, B[i]};
}

FIGURE(bernstein_basis)
{
    svg *s = svg_new("bernstein_basis", "Bernstein polynomials",
                     "The Bernstein polynomials of degree 3 and of degree 6 over the unit interval. Each is largest at "
                     "i/n, marked by a point on its graph.");
    for (int n = 3; n <= 6; n += 3) {
        char words[64];
        snprintf(words, sizeof words, "$n = %d$: each $B_i^%d$ is largest at $i/%d$", n, n, n);
        svg_panel(s, svg_integer_window(0, 0, 1, 1), 330, 230, words);
        svg_axes(s, from_ratio_q(1, n == 3 ? 3 : 6), from_ratio_q(1, 2), "t", NULL);
        for (int i = 0; i <= n; i++) {
            graph(s, n, i, i % 2 == 0 ? SVG_CURVE : SVG_CURVE_2);
            svg_mark(s, top(n, i), i % 2 == 0 ? SVG_CURVE : SVG_CURVE_2, SVG_USUAL);
            snprintf(words, sizeof words, "B_%d^%d", i, n);
            svg_label(s, top(n, i),
                      i == 0   ? SVG_NE
                      : i == n ? SVG_NW
                               : SVG_N,
                      i % 2 == 0 ? SVG_CURVE : SVG_CURVE_2, words);
        }
    }
    return s;
}
