#include "chapters/nurbs/bspline-figures.h"

FIGURE(bspline_elevation)
{
    enum { p = 2, n = 4, m = 6 };
    static const int knot[n + p + 1] = {0, 0, 0, 2, 5, 5, 5}, finer[m + p + 2] = {0, 0, 0, 0, 2, 2, 5, 5, 5, 5};
    static const int point[2 * n] = {0, 0, 2, 7, 9, 7, 11, 0};
    num_q u[n + p + 1], v[m + p + 2], c[2 * n], d[2 * m];
    int span[m];
    integers(n + p + 1, knot, u);
    integers(m + p + 2, finer, v);
    integers(2 * n, point, c);
    (void)spans_of_points_q(n, p, u, m, p + 1, v, span);
    bspline_elevate_q(&(cagd_spline_q){p, n, 2, u, c, NULL}, m, v, span, d);
    svg *s = svg_new("bspline_elevation", "Elevation of the degree",
                     "A quadratic curve of two segments with its polygon, and the polygon of the same curve in degree "
                     "3, where the inner "
                     "knot is double.");
    svg_panel(s, svg_integer_window(-1, -1, 12, 8), 500, 0,
              "A curve of degree 2 over 0, 2, 5 and the same in degree 3;\nthe knot 2 is now double.");
    svg_polyline(s, n, c, SVG_MUTED);
    svg_polyline(s, m, d, SVG_POLYGON);
    draw_bspline(s, n, p, u, c, SVG_CURVE);
    static const enum svg_direction side[n] = {SVG_S, SVG_NW, SVG_NE, SVG_S};
    for (int i = 0; i < n; i++) {
        char name[8];
        snprintf(name, sizeof name, "c_%d", i);
        svg_mark(s, svg_pair(c + 2 * i), SVG_MUTED, SVG_RING);
        svg_label(s, svg_pair(c + 2 * i), side[i], SVG_POINT, name);
    }
    static const enum svg_direction towards[m] = {SVG_E, SVG_W, SVG_N, SVG_N, SVG_NE, SVG_E};
    for (int j = 1; j + 1 < m; j++) {
        char name[8];
        snprintf(name, sizeof name, "d_%d", j);
        svg_mark(s, svg_pair(d + 2 * j), SVG_RIGHT, SVG_USUAL);
        svg_label(s, svg_pair(d + 2 * j), towards[j], SVG_RIGHT, name);
    }
    svg_legend_line(s, SVG_MUTED, "degree 2");
    svg_legend_line(s, SVG_POLYGON, "degree 3");
    return s;
}
