#include "chapters/nurbs/bspline-figures.h"

enum { CUBIC = 3, POINTS = 6 };

static void example(num_q u[], num_q c[])
{
    static const int knot[POINTS + CUBIC + 1] = {0, 0, 0, 0, 2, 4, 6, 6, 6, 6};
    static const int point[2 * POINTS] = {0, 0, 1, 6, 5, 9, 10, 8, 13, 3, 11, -1};
    integers(POINTS + CUBIC + 1, knot, u);
    integers(2 * POINTS, point, c);
}

FIGURE(bspline_bezier_segments)
{
    num_q u[POINTS + CUBIC + 1], c[2 * POINTS], b[2 * (CUBIC + 1)];
    example(u, c);
    svg *s = svg_new("bspline_bezier_segments", "The Bézier polygons of the segments",
                     "A cubic B-spline curve of three segments, its polygon, and the Bézier polygons of the segments, "
                     "whose points lie on "
                     "the edges of the polygon and between them.");
    svg_panel(s, svg_integer_window(-1, -2, 14, 10), 540, 0,
              "Three cubic segments over $[0,2]$, $[2,4]$ and $[4,6]$; every segment has four Bézier points.");
    svg_polyline(s, POINTS, c, SVG_MUTED);
    for (int mu = CUBIC; mu < POINTS; mu++) {
        enum svg_role role = mu % 2 == 1 ? SVG_CURVE : SVG_CURVE_2;
        bspline_to_bezier_q(on_span_q(CUBIC, 2, u, mu, c), b);
        svg_bezier(s, CUBIC, b, role);
        svg_polyline(s, CUBIC + 1, b, SVG_POLYGON);
        for (int i = 0; i <= CUBIC; i++)
            svg_mark(s, svg_pair(b + 2 * i), i == 0 || i == CUBIC ? SVG_POINT : role, SVG_USUAL);
    }
    static const enum svg_direction side[POINTS] = {SVG_SW, SVG_W, SVG_NW, SVG_NE, SVG_E, SVG_S};
    for (int i = 0; i < POINTS; i++) {
        char name[8];
        snprintf(name, sizeof name, "c_%d", i);
        svg_mark(s, svg_pair(c + 2 * i), SVG_MUTED, SVG_RING);
        svg_label(s, svg_pair(c + 2 * i), side[i], SVG_POINT, name);
    }
    svg_legend_line(s, SVG_MUTED, "the B-spline polygon");
    svg_legend_line(s, SVG_POLYGON, "Bézier polygons");
    return s;
}

FIGURE(bspline_split)
{
    num_q u[POINTS + CUBIC + 1], c[2 * POINTS], v[2 * POINTS + CUBIC], w[2 * POINTS + CUBIC], left[4 * POINTS],
        right[4 * POINTS];
    enum { mu = 4, lefts = mu + 1, rights = POINTS - mu + CUBIC };
    example(u, c);
    bspline_split_q(&(struct spline_q){CUBIC, POINTS, 2, u, c, NULL}, mu, 0, from_int_q(3), v, left, w, right);
    svg *s = svg_new(
        "bspline_split", "A curve cut at a parameter",
        "A cubic B-spline curve cut at t = 3; each part has its own polygon, which ends in the point of the cut.");
    svg_panel(s, svg_integer_window(-1, -2, 14, 10), 540, 0,
              "Cut at $t = 3$: the new points are the two sides of de Boor's triangle.");
    svg_polyline(s, POINTS, c, SVG_MUTED);
    draw_bspline(s, lefts, CUBIC, v, left, SVG_CURVE);
    draw_bspline(s, rights, CUBIC, w, right, SVG_CURVE_2);
    svg_polyline(s, lefts, left, SVG_POLYGON);
    svg_polyline(s, rights, right, SVG_POLYGON);
    for (int i = 0; i < rights; i++)
        svg_mark(s, svg_pair(right + 2 * i), SVG_CURVE_2, SVG_USUAL);
    for (int i = 0; i < lefts; i++)
        svg_mark(s, svg_pair(left + 2 * i), SVG_CURVE, SVG_USUAL);
    svg_label(s, svg_pair(right), SVG_S, SVG_POINT, "s(3)");
    svg_legend_line(s, SVG_CURVE, "over $[0,3]$");
    svg_legend_line(s, SVG_CURVE_2, "over $[3,6]$");
    svg_legend_line(s, SVG_MUTED, "the polygon before");
    return s;
}

FIGURE(bspline_periodic)
{
    enum { m = 6 };
    static const int knot[m + 1] = {0, 1, 2, 4, 5, 6, 8}, point[2 * m] = {0, 0, 5, -2, 9, 2, 8, 7, 3, 8, -1, 5};
    num_q u[m + 1], c[2 * m], v[m + 2 * CUBIC + 1], d[2 * (m + CUBIC)], P[2];
    integers(m + 1, knot, u);
    integers(2 * m, point, c);
    bspline_periodic_q(m, CUBIC, 2, u, c, v, d);
    svg *s = svg_new("bspline_periodic", "A closed curve",
                     "A closed cubic curve of six points; the seam, where the parameter begins and ends, is as smooth "
                     "as the other knots.");
    svg_panel(s, svg_integer_window(-2, -3, 10, 9), 440, 0,
              "Six points, one period of knots 0, 1, 2, 4, 5, 6, 8;\nthe discs are the knots, the square the seam.");
    svg_polyline(s, m + 1, d, SVG_POLYGON);
    draw_bspline(s, m + CUBIC, CUBIC, v, d, SVG_CURVE);
    for (int i = 0; i < m; i++) {
        char name[8];
        snprintf(name, sizeof name, "c_%d", i);
        static const enum svg_direction side[m] = {SVG_SW, SVG_S, SVG_E, SVG_NE, SVG_N, SVG_W};
        svg_mark(s, svg_pair(c + 2 * i), SVG_POLYGON, SVG_USUAL);
        svg_label(s, svg_pair(c + 2 * i), side[i], SVG_POLYGON, name);
        bspline_deboor_q(on_span_q(CUBIC, 2, v, CUBIC + i, d), u[i], P);
        svg_mark(s, svg_pair(P), i == 0 ? SVG_CURVE_2 : SVG_CURVE, SVG_USUAL);
    }
    return s;
}
