#include "chapters/nurbs/bspline-figures.h"
#include "exact/record/number.h"

FIGURE(knot_removal_defect)
{
    enum { p = 3, n = 6, removed = 4 };
    static const int knot[n + p + 1] = {0, 0, 0, 0, 2, 4, 6, 6, 6, 6};
    static const int point[2 * n] = {0, 0, 1, 6, 5, 9, 10, 8, 13, 3, 11, -1};
    num_q u[n + p + 1], v[n + p + 1], w[n + p + 1], c[2 * n], b[2 * n], d[2 * n], defect[2];
    integers(n + p + 1, knot, u);
    integers(2 * n, point, c);
    bspline_remove_q(&(struct spline_q){p, n, 2, u, c, NULL}, removed, 1, v, b, defect);
    bspline_insert_q(&(struct spline_q){p, n - 1, 2, v, b, NULL}, removed - 1, u[removed], w, d);
    svg *s = svg_new("knot_removal_defect", "Removal of a knot and its defect",
                     "A cubic curve and the curve without the knot 2; inserting the knot again gives back all points "
                     "but one, which is "
                     "off by the defect.");
    svg_panel(s, svg_integer_window(-3, -2, 14, 14), 540, 0,
              "The knot 2 is taken out: the new curve is another one. Inserted again, the knot gives\n"
              "back all points but $c_2$; the arrow is the defect, and it is 0 exactly for a removable knot.");
    draw_bspline(s, n, p, u, c, SVG_CURVE);
    draw_bspline(s, n - 1, p, v, b, SVG_CURVE_2);
    svg_polyline(s, n, c, SVG_POLYGON);
    svg_polyline(s, n - 1, b, SVG_MUTED);
    static const enum svg_direction side[n] = {SVG_SW, SVG_W, SVG_W, SVG_NE, SVG_E, SVG_S};
    static const enum svg_direction other[n] = {SVG_SE, SVG_NW, SVG_N, SVG_NE, SVG_S};
    for (int i = 0; i < n; i++) {
        char name[8];
        snprintf(name, sizeof name, "c_%d", i);
        svg_mark(s, svg_pair(c + 2 * i), SVG_POLYGON, SVG_RING);
        svg_label(s, svg_pair(c + 2 * i), side[i], SVG_POLYGON, name);
        if (!equal_q(c[2 * i], d[2 * i]) || !equal_q(c[2 * i + 1], d[2 * i + 1]))
            svg_arrow(s, svg_pair(d + 2 * i), svg_pair(c + 2 * i), SVG_WRONG);
    }
    for (int i = 1; i < 3; i++) {
        char name[8];
        snprintf(name, sizeof name, "b_%d", i);
        svg_mark(s, svg_pair(b + 2 * i), SVG_CURVE_2, SVG_USUAL);
        svg_label(s, svg_pair(b + 2 * i), other[i], SVG_CURVE_2, name);
    }
    svg_legend_line(s, SVG_CURVE, "with the knot");
    svg_legend_line(s, SVG_CURVE_2, "without it");
    svg_legend_line(s, SVG_WRONG, "defect");
    return s;
}
