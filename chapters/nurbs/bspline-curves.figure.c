#include "chapters/nurbs/bspline-figures.h"

FIGURE(bspline_deboor_triangle)
{
    enum { p = 3, n = 4 };
    static const int knot[n + p + 1] = {0, 1, 2, 3, 5, 6, 7, 8}, point[2 * n] = {0, 0, 2, 7, 9, 8, 11, 1};
    num_q u[n + p + 1], c[2 * n], d[2 * n], t = from_int_q(4);
    integers(n + p + 1, knot, u);
    integers(2 * n, point, c);
    for (int i = 0; i < 2 * n; i++)
        d[i] = c[i];
    svg *s = svg_new("bspline_deboor_triangle", "De Boor's algorithm",
                     "A cubic segment over [3, 5] with knots 1, 2, 3, 5, 6, 7 around; the levels of de Boor's triangle "
                     "at t = 4, which "
                     "end in the point of the curve.");
    svg_panel(s, svg_integer_window(-1, -1, 12, 9), 520, 0,
              "A segment over $[u_3, u_4] = [3, 5]$ at $t = 4$.\nThe points of level $r$ are polar values with $r$ "
              "arguments $t$.");
    svg_control_polygon(s, n - 1, c, "c");
    draw_bspline(s, n, p, u, c, SVG_CURVE);
    static const enum svg_direction towards[p + 1][p] = {{SVG_N}, {SVG_W, SVG_N, SVG_E}, {SVG_NW, SVG_NE}, {SVG_S}};
    for (int r = 1; r <= p; r++) {
        bspline_deboor_level_q(on_span_q(p, 2, u, p, NULL), r, d, t);
        svg_polyline(s, p + 1 - r, d, SVG_FAMILY);
        for (int m = 0; m <= p - r; m++) {
            char name[16];
            snprintf(name, sizeof name, "d_%d^%d", r + m, r);
            svg_mark(s, svg_pair(d + 2 * m), r == p ? SVG_CURVE : SVG_POINT, SVG_USUAL);
            svg_label(s, svg_pair(d + 2 * m), towards[r][m], r == p ? SVG_CURVE : SVG_POINT, name);
        }
    }
    return s;
}
