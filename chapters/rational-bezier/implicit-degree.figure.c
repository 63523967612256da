#include "chapters/rational-bezier/implicit-figures.h"

FIGURE(implicit_degree)
{
    svg *s = svg_new(
        "implicit_degree", "The equation of a cubic curve has degree three",
        "The rational cubic with the points (0, 0), (1, 2), (2, -2), (3, 0) and the weights 1, 2, 2, 1, and all "
        "points where its determinant F vanishes.  The line y = 0 meets F = 0 in three points, the parameters 0, "
        "1/2 and 1, and no line that is not part of it meets it in more.");
    static const int point[8] = {0, 0, 1, 2, 2, -2, 3, 0}, weight[4] = {1, 2, 2, 1};
    num_q R[8], w[4];
    for (int i = 0; i < 4; i++) {
        R[2 * i] = q(point[2 * i]);
        R[2 * i + 1] = q(point[2 * i + 1]);
        w[i] = q(weight[i]);
    }
    struct implicit_curve F = {3, R, w};
    svg_panel(s, window(q(-1), r(-5, 2), q(4), r(5, 2)), 420, 0, "a line meets $F(x,y)=0$ at most $n=3$ times");
    svg_implicit(s, determinant_at, &F, 160, SVG_CURVE_2);
    svg_control_polygon(s, 3, R, "R");
    svg_rational(s, 3, R, w, SVG_CURVE);
    svg_line(s, at(q(-1), q(0)), at(q(4), q(0)), SVG_MUTED);
    for (int k = 0; k <= 2; k++) {
        num_q P[2];
        rational_point_q(3, 2, R, w, r(k, 2), P);
        svg_mark(s, svg_pair(P), SVG_RIGHT, SVG_USUAL);
    }
    svg_legend_line(s, SVG_CURVE, "the curve, $0≤t≤1$");
    svg_legend_line(s, SVG_CURVE_2, "$F=0$");
    svg_legend_mark(s, SVG_RIGHT, SVG_USUAL, "common points with $y=0$");
    return s;
}

/* x^2 - y^2 - 4y, the determinant with the printed recursion. */
static num_q printed_at(svg_point p, const void *data)
{
    (void)data;
    num_q y = p.y;
    return sub_q(mul_q(p.x, p.x), add_q(mul_q(y, y), mul_q(q(4), y)));
}

FIGURE(implicit_recursion)
{
    svg *s = svg_new(
        "implicit_recursion", "The printed recursion changes the curve",
        "The parabola with the points (0, 0), (1, 0), (1, 1) and weights 1.  The determinant is (x + y)² - 4y; with "
        "the printed recursion for its entries it becomes x² - y² - 4y, a hyperbola.");
    num_q R[6] = {q(0), q(0), q(1), q(0), q(1), q(1)}, w[3] = {q(1), q(1), q(1)};
    struct implicit_curve F = {2, R, w};
    svg_panel(s, window(r(-3, 2), r(-1, 2), r(5, 2), r(3, 2)), 460, 0, "$n=2$, weights 1");
    svg_implicit(s, determinant_at, &F, 160, SVG_RIGHT);
    svg_implicit(s, printed_at, NULL, 160, SVG_WRONG);
    static const enum svg_direction side[3] = {SVG_S, SVG_SE, SVG_E};
    static const char *const name[3] = {"R_0", "R_1", "R_2"};
    svg_polyline(s, 3, R, SVG_POLYGON);
    for (int i = 0; i < 3; i++) {
        svg_mark(s, svg_pair(R + 2 * i), SVG_POLYGON, SVG_USUAL);
        svg_label(s, svg_pair(R + 2 * i), side[i], SVG_POINT, name[i]);
    }
    svg_legend_line(s, SVG_RIGHT, "$(x+y)^2-4y=0$: the curve and its continuation");
    svg_legend_line(s, SVG_WRONG, "$x^2-y^2-4y=0$: as printed");
    return s;
}
