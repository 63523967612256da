/* nurbs-definition.figure.c -- drawings for nurbs-definition.claims.h. */
#include "chapters/nurbs/spline-figures.h"

FIGURE(nurbs_definition)
{
    static const int point[] = {0, 0, 1, 4, 4, 5, 6, 1, 9, 1, 10, 5}, knot[] = {0, 0, 0, 0, 1, 2, 3, 3, 3, 3};
    static const int heavy[] = {1, 1, 4, 1, 1, 1};
    static const enum svg_direction side[] = {SVG_SW, SVG_W, SVG_N, SVG_S, SVG_SE, SVG_E};
    svg *s = svg_new(
        "nurbs_definition", "A NURBS curve",
        "A cubic NURBS curve with six control points, with the weights 1 and with the weight of r3 raised to 4. "
        "Squares mark where the segments join.");
    spline c = spline_of(6, 3, knot, 1, point, 1, NULL), d = spline_of(6, 3, knot, 1, point, 1, heavy);
    svg_panel(s, svg_integer_window(-1, -1, 11, 6), 460, 0, "$k=4$, $n=6$, knots $0,0,0,0,1,2,3,3,3,3$");
    draw_spline(s, d, SVG_CURVE_2);
    draw_spline(s, c, SVG_CURVE);
    mark_knots(s, d, SVG_CURVE_2);
    mark_knots(s, c, SVG_CURVE);
    draw_polygon(s, c, "r", side, SVG_POLYGON);
    svg_legend_line(s, SVG_CURVE, "all weights 1");
    svg_legend_line(s, SVG_CURVE_2, "$w_3=4$: nearer to $r_3$");
    svg_legend_line(s, SVG_POLYGON, "the control polygon");
    return s;
}

/* N_i over the knots of c at t, as a point of a graph. */
struct function {
    spline c;
    int i, mu;
};
static svg_point graph_point(num_q t, const void *data)
{
    const struct function *f = data;
    num_q N[MAX_DEGREE + 1];
    bspline_basis_q(f->c.p, f->c.u, f->mu, t, N);
    return at(t, N[f->i - f->mu + f->c.p]);
}

FIGURE(missing_end)
{
    static const int knot[] = {0, 0, 0, 1, 2, 2, 2}, point[8] = {0};
    svg *s = svg_new(
        "missing_end", "The right end of the domain",
        "The four quadratic B-splines over the knots 0, 0, 0, 1, 2, 2, 2.  At t = 2 their sum has the limit 1 from the "
        "left, but by the half-open intervals of the definition all of them are 0 there.");
    spline c = spline_of(4, 2, knot, 1, point, 1, NULL);
    svg_panel(s, window(q(0), r(-1, 10), r(12, 5), r(11, 10)), 400, 240,
              "$N_{1,3}$, …, $N_{4,3}$ and their sum, $t_5=t_6=t_7=2$");
    svg_axes(s, q(1), r(1, 2), "t", NULL);
    for (int mu = 2; mu < 4; mu++)
        for (int i = mu - 2; i <= mu; i++) {
            struct function f = {c, i, mu};
            svg_plot(s, graph_point, &f, c.u[mu], c.u[mu + 1], 24, SVG_CURVE);
        }
    svg_segment(s, svg_at(0, 1), svg_at(2, 1), SVG_RIGHT);
    svg_segment(s, svg_at(2, 0), at(r(12, 5), q(0)), SVG_WRONG);
    svg_mark(s, svg_at(2, 1), SVG_RIGHT, SVG_USUAL);
    svg_mark(s, svg_at(2, 0), SVG_WRONG, SVG_USUAL);
    svg_legend_line(s, SVG_CURVE, "the four B-splines");
    svg_legend_line(s, SVG_RIGHT, "their sum, from the left");
    svg_legend_mark(s, SVG_WRONG, SVG_USUAL, "their sum at $t=2$ by the letter: 0");
    return s;
}

FIGURE(idle_point)
{
    static const int point[] = {0, 0, 2, 2, 4, 3, 6, 2, 8, 0}, threefold[] = {0, 0, 1, 1, 1, 2, 2};
    static const int simple[] = {0, 0, 1, 2, 3, 4, 4};
    static const enum svg_direction side[] = {SVG_S, SVG_NW, SVG_N, SVG_NE, SVG_S};
    svg *s = svg_new("idle_point", "A point without influence",
                     "Curves of order 2 with the same five points.  Over the knots 0, 0, 1, 1, 1, 2, 2, of which one "
                     "is threefold, the "
                     "point r3 has no share: the curve is two segments.  Over simple knots it is the whole polygon.");
    for (int good = 0; good < 2; good++) {
        spline c = spline_of(5, 1, good ? simple : threefold, 1, point, 1, NULL);
        svg_panel(s, svg_integer_window(-1, -1, 9, 4), 320, 0,
                  good ? "knots $0,0,1,2,3,4,4$" : "knots $0,0,1,1,1,2,2$: $t_3=t_5$, $N_{3,2}=0$");
        svg_heading(s, good ? SVG_RIGHT : SVG_WRONG, good ? "used" : "idle");
        draw_polygon(s, c, "r", side, SVG_MUTED);
        draw_spline(s, c, SVG_CURVE);
        svg_mark(s, svg_pair(c.R + 4), good ? SVG_RIGHT : SVG_WRONG, SVG_USUAL);
    }
    svg_legend_line(s, SVG_CURVE, "the curve, $k=2$");
    svg_legend_line(s, SVG_MUTED, "the control polygon");
    return s;
}

FIGURE(bezier_knots)
{
    static const int point[] = {0, 0, 1, 4, 5, 4, 6, 0}, weight[] = {1, 2, 1, 1};
    static const int threefold[] = {-1, 0, 0, 0, 1, 1, 1, 2}, simple[] = {-3, -2, -1, 0, 1, 2, 3, 4};
    static const enum svg_direction side[] = {SVG_SW, SVG_NW, SVG_NE, SVG_SE};
    svg *s = svg_new(
        "bezier_knots", "When a NURBS curve is a rational Bézier curve",
        "n = k = 4, the same points and weights.  Over threefold knots the curve is the rational Bézier curve of "
        "the data, over simple knots a shorter arc with other Bézier points.");
    for (int good = 1; good >= 0; good--) {
        spline c = spline_of(4, 3, good ? threefold : simple, 1, point, 1, weight);
        num_q H[12], b[12], P[8], v[4];
        svg_panel(s, svg_integer_window(-1, -1, 7, 5), 300, 0,
                  good ? "$t_2=t_3=t_4<t_5=t_6=t_7$" : "simple knots: other Bézier points");
        draw_polygon(s, c, "r", side, SVG_POLYGON);
        draw_spline(s, c, SVG_CURVE);
        mark_knots(s, c, SVG_CURVE);
        if (good)
            continue;
        rational_homogenize_q(3, 2, c.R, c.w, H);
        bspline_to_bezier_q(on_span_q(3, 3, c.u, 3, H), b);
        rational_dehomogenize_q(3, 2, b, P, v);
        svg_polyline(s, 4, P, SVG_CURVE_2);
        for (int i = 0; i < 4; i++)
            svg_mark(s, svg_pair(P + 2 * i), SVG_CURVE_2, SVG_USUAL);
    }
    svg_legend_line(s, SVG_CURVE, "the curve, weights 1, 2, 1, 1");
    svg_legend_line(s, SVG_CURVE_2, "its Bézier points $r_i^*$");
    return s;
}

FIGURE(polygon_begun_elsewhere)
{
    static const int point[] = {0, 0, 2, 2, 4, 0}, knot[] = {0, 0, 0, 1, 1, 1};
    static const enum svg_direction side[] = {SVG_SW, SVG_N, SVG_SE};
    svg *s =
        svg_new("polygon_begun_elsewhere", "A polygon that begins with the wrong point",
                "Three points of a quadratic curve that begins in the first of them.  As printed the polygon begins "
                "with the point of an undetermined index i; with i = 2 its first leg is missing.");
    spline c = spline_of(3, 2, knot, 1, point, 1, NULL);
    for (int good = 0; good < 2; good++) {
        svg_panel(s, svg_integer_window(-1, -1, 5, 3), 290, 0, good ? "$r_1r_2r_3$" : "$r_ir_2r_3$ with $i=2$");
        svg_heading(s, good ? SVG_RIGHT : SVG_WRONG, good ? "$r_1r_2⋯r_n$" : "$r_ir_2⋯r_n$");
        draw_spline(s, c, SVG_CURVE);
        draw_polygon(s, c, "r", side, SVG_MUTED);
        svg_polyline(s, good ? 3 : 2, c.R + (good ? 0 : 2), good ? SVG_RIGHT : SVG_WRONG);
        svg_mark(s, svg_pair(c.R + (good ? 0 : 2)), good ? SVG_RIGHT : SVG_WRONG, SVG_USUAL);
    }
    svg_legend_line(s, SVG_CURVE, "the curve, $k=3$");
    svg_legend_line(s, SVG_WRONG, "the printed polygon");
    svg_legend_line(s, SVG_RIGHT, "the control polygon");
    return s;
}
