/* Figures of the section on the end points. */
#include "chapters/judge/figure.h"
#include "chapters/rational-bezier/conic-figures.h"
#include "exact/record/number.h"
#include "figures/words.h"

/* A triangle, its curve, and an arrow that is a third of the first derivative at t = 0 that is not 0. */
static void draw_start(svg *s, const num_q w[3], const char *caption, enum svg_role role)
{
    num_q R[] = {q(0), q(0), q(1), q(2), q(2), q(0)}, D[6];
    svg_panel(s, (svg_window){r(-3, 4), q(-2), r(11, 4), r(5, 2)}, 190, 0, caption);
    put_triangle(s, R, SVG_W, SVG_N, SVG_E);
    svg_rational(s, 2, R, w, SVG_CURVE);
    if (is_zero_q(w[0]))
        return;
    rational_derivatives_q(2, 2, R, w, q(0), 2, D);
    const num_q *d = is_zero_q(D[2]) && is_zero_q(D[3]) ? D + 4 : D + 2;
    svg_arrow(s, svg_at(0, 0), (svg_point){mul_q(r(1, 3), d[0]), mul_q(r(1, 3), d[1])}, role);
}

FIGURE(end_tangents)
{
    svg *s = svg_new("end_tangents", "Where the curve goes at its first point",
                     "The quadratic with points (0,0), (1,2), (2,0): with weights 1, 1, 1 it starts towards R_1, with "
                     "1, 0, 1 along the "
                     "chord, with 1, -1/2, 1 away from R_1, and with 0, 1, 1 it does not start in R_0 at all.");
    num_q right[] = {q(1), q(1), q(1)}, zero[] = {q(1), q(0), q(1)};
    num_q negative[] = {q(1), r(-1, 2), q(1)}, lost[] = {q(0), q(1), q(1)};
    draw_start(s, right, "weights $1, 1, 1$:\n$R'(0)$ along $R_0R_1$", SVG_RIGHT);
    draw_start(s, zero, "$1, 0, 1$: $R'(0) = 0$,\n$R''(0)$ along $R_0R_2$", SVG_WRONG);
    draw_start(s, negative, "$1, -1/2, 1$: $R'(0)$\naway from $R_1$", SVG_WRONG);
    draw_start(s, lost, "$0, 1, 1$: the curve is\nthe segment $R_1R_2$", SVG_WRONG);
    svg_legend_line(s, SVG_CURVE, "the curve");
    svg_legend_line(s, SVG_RIGHT, "one third of its derivative, along the edge");
    svg_legend_line(s, SVG_WRONG, "one third of it, not along the edge");
    return s;
}

/* The graph of the cubic or quadratic with ordinates b over [0,1], as a plane Bézier curve. */
static void draw_graph(svg *s, int n, const num_q b[])
{
    num_q P[2 * 4];
    for (int i = 0; i <= n; i++) {
        P[2 * i] = r(i, n);
        P[2 * i + 1] = b[i];
    }
    svg_bezier(s, n, P, SVG_CURVE);
}

/* The graph of y + d (t - 1) + e (t - 1)^2 over [u, v]. */
static void draw_taylor(svg *s, num_q y, num_q d, num_q e, num_q u, num_q v, enum svg_role role)
{
    num_q a = sub_q(u, q(1)), b = sub_q(v, q(1)), half = r(1, 2);
    num_q left = add_q(y, add_q(mul_q(d, a), mul_q(e, mul_q(a, a)))),
          right = add_q(y, add_q(mul_q(d, b), mul_q(e, mul_q(b, b))));
    /* the polar form at (u, v) */
    num_q middle = add_q(y, add_q(mul_q(d, mul_q(half, add_q(a, b))), mul_q(e, mul_q(a, b))));
    num_q P[] = {u, left, mul_q(half, add_q(u, v)), middle, v, right};
    svg_bezier(s, 2, P, role);
}

FIGURE(end_derivatives)
{
    svg *s = svg_new(
        "end_derivatives", "The two slips of the printed derivative at t = 1",
        "Left, R(t) = 2t - t^2 with the parabola of the printed R''(1) = 2, which curves to the wrong side.  Right, "
        "R(t) = 3t^2 - t^3 with the line of the printed slope R'(1) = 6 and the true tangent of slope 3.");
    num_q quadratic[] = {q(0), q(1), q(1)}, cubic[] = {q(0), q(0), q(1), q(2)};
    svg_panel(s, (svg_window){q(0), q(0), r(3, 2), q(2)}, 280, 280,
              "points $0, 1, 1$, weights $1$ ($k = 1$, $h = 2$):\nprinted $R''(1) = 2$, true $R''(1) = -2$");
    svg_heading(s, SVG_WRONG, "sign");
    svg_axes(s, r(1, 2), q(1), "t", "R");
    draw_taylor(s, q(1), q(0), q(1), q(0), r(3, 2), SVG_WRONG);
    draw_taylor(s, q(1), q(0), q(-1), q(1), r(3, 2), SVG_RIGHT);
    draw_graph(s, 2, quadratic);
    svg_mark(s, svg_at(1, 1), SVG_CURVE, SVG_USUAL);
    svg_panel(s, (svg_window){q(0), q(0), r(3, 2), q(4)}, 280, 280,
              "points $0, 0, 1, 2$, weights $1$ ($k = 2$, $h = 1$):\nprinted $R'(1) = 6$, true $R'(1) = 3$");
    svg_heading(s, SVG_WRONG, "factor");
    svg_axes(s, r(1, 2), q(1), "t", "R");
    draw_taylor(s, q(2), q(6), q(0), q(0), r(3, 2), SVG_WRONG);
    draw_taylor(s, q(2), q(3), q(0), r(1, 3), r(3, 2), SVG_RIGHT);
    draw_graph(s, 3, cubic);
    svg_mark(s, svg_at(1, 2), SVG_CURVE, SVG_USUAL);
    svg_legend_line(s, SVG_CURVE, "$R(t)$");
    svg_legend_line(s, SVG_RIGHT, "its Taylor polynomial of order $h$ at $1$");
    svg_legend_line(s, SVG_WRONG, "with the printed derivative");
    return s;
}
