/* nurbs-envelope-whole.figure.c -- drawings for nurbs-envelope-whole.claims.h. */
#include "chapters/nurbs/family-figures.h"

FIGURE(nurbs_envelope_whole)
{
    svg *s = svg_new(
        "nurbs_envelope_whole", "A member of the whole curve may run to infinity",
        "A quadratic curve with two spans.  Left the weights are 1: every polygon of the family touches the curve and "
        "goes on over the other span.  Right the last weight is 5: the leg of the polygon of the first parameter over "
        "the second span leaves in one direction and comes back from the other.");
    static const int knot[7] = {1, 2, 3, 4, 5, 6, 7};
    static const int point[2][12] = {{0, 0, 1, 1, 3, 1, 4, 3, 1, 5, 0, 1}, {0, 0, 1, 1, 3, 1, 4, 3, 1, 5, 0, 5}};
    for (int k = 0; k < 2; k++) {
        struct nurbs c = nurbs_of(4, 2, knot, point[k], 1);
        svg_window field = k == 0 ? window(r(-1, 4), r(-7, 10), r(21, 4), r(59, 10)) : window(q(-2), q(-6), q(8), q(6));
        svg_panel(s, field, 330, 0,
                  k == 0 ? "$k=3$, $r=1$, weights 1, 1, 1, 1:\nall polygons exist"
                         : "weights 1, 1, 1, 5:\n$w_3^{[1]}=1$ and $w_4^{[1]}=-1$ at $τ=t_3$");
        for (int i = 1; i < 8; i++)
            for (int mu = 2; mu < 4 && k == 0; mu++)
                put_member(s, &c, mu, 1, add_q(q(3), r(i, 4)), SVG_FAMILY);
        put_polygon(s, &c, NULL);
        put_curve(s, &c, SVG_CURVE);
        put_member(s, &c, 2, 1, q(3), SVG_CURVE_2);
        put_member(s, &c, 3, 1, q(3), k == 0 ? SVG_CURVE_2 : SVG_WRONG);
        svg_mark(s, point_of(&c, 2, q(3)), SVG_POINT, SVG_USUAL);
        svg_frame(s);
    }
    svg_legend_line(s, SVG_CURVE, "the curve");
    svg_legend_line(s, SVG_CURVE_2, "the polygon of $τ=t_3$");
    svg_legend_line(s, SVG_WRONG, "its leg, broken at infinity");
    svg_legend_line(s, SVG_FAMILY, "other polygons");
    return s;
}
