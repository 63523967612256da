#include "chapters/nurbs/bspline-figures.h"

FIGURE(boehm_insertion)
{
    enum { p = 3, n = 6 };
    static const int knot[n + p + 1] = {0, 0, 0, 0, 2, 4, 6, 6, 6, 6};
    static const int point[2 * n] = {0, 0, 1, 6, 5, 9, 10, 8, 13, 3, 11, -1};
    num_q u[n + p + 1], v[n + p + 2], c[2 * n], d[2 * (n + 1)];
    integers(n + p + 1, knot, u);
    integers(2 * n, point, c);
    bspline_insert_q(&(struct spline_q){p, n, 2, u, c, NULL}, 4, from_int_q(3), v, d);
    svg *s = svg_new("boehm_insertion", "Insertion of a knot",
                     "A cubic curve with knots 0, 2, 4, 6; the knot 3 is inserted. Three points are new, on the edges "
                     "of the polygon, "
                     "and two corners are cut.");
    svg_panel(s, svg_integer_window(-1, -2, 14, 10), 540, 0,
              "The knot 3 goes into $[2, 4]$: $p = 3$ new points on the edges\ncut two corners, and the curve stays.");
    svg_polyline(s, n, c, SVG_MUTED);
    draw_bspline(s, n, p, u, c, SVG_CURVE);
    svg_polyline(s, n + 1, d, SVG_POLYGON);
    static const enum svg_direction old_side[n] = {SVG_SW, SVG_W, SVG_NW, SVG_NE, SVG_E, SVG_S};
    static const enum svg_direction new_side[n + 1] = {SVG_SE, SVG_E, SVG_NW, SVG_N, SVG_NE, SVG_W, SVG_W};
    for (int i = 0; i < n; i++) {
        char name[8];
        snprintf(name, sizeof name, "c_%d", i);
        svg_mark(s, svg_pair(c + 2 * i), SVG_MUTED, SVG_RING);
        svg_label(s, svg_pair(c + 2 * i), old_side[i], SVG_POINT, name);
    }
    for (int i = 2; i <= 4; i++) {
        char name[8];
        snprintf(name, sizeof name, "d_%d", i);
        svg_mark(s, svg_pair(d + 2 * i), SVG_RIGHT, SVG_USUAL);
        svg_label(s, svg_pair(d + 2 * i), new_side[i], SVG_RIGHT, name);
    }
    svg_legend_line(s, SVG_MUTED, "the polygon before");
    svg_legend_line(s, SVG_POLYGON, "the polygon after");
    svg_legend_mark(s, SVG_RIGHT, SVG_USUAL, "new points");
    return s;
}
