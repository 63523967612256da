/* nurbs-envelope-contact.figure.c -- drawings for nurbs-envelope-contact.claims.h. */
#include "chapters/nurbs/family-figures.h"

FIGURE(nurbs_envelope_contact)
{
    svg *s = svg_new("nurbs_envelope_contact", "Curve and members touch, they do not osculate",
                     "One span of a curve of order 5 and its members of order 4, 3 and 2 at one parameter.  The lower "
                     "the order, the flatter the member; "
                     "the curvatures at the contact have the ratios 8/9, 2/3 and 0 to that of the curve.");
    static const int x[5] = {0, 1}, y[5] = {0, 0, 3, 0, 2};
    struct nurbs c = one_span(4, 1, x, y);
    svg_panel(s, window(q(-1), r(-1, 4), q(1), r(3, 2)), 560, 330,
              "$k=5$, $τ=0$: $κ_{k-r}/κ$ is 8/9, 2/3, 0 for $r=1,2,3$");
    svg_axes(s, r(1, 2), r(1, 2), "x", "y");
    put_member(s, &c, 4, 1, q(0), SVG_FAMILY);
    put_member(s, &c, 4, 2, q(0), SVG_CURVE_2);
    put_member(s, &c, 4, 3, q(0), SVG_RIGHT);
    put_curve(s, &c, SVG_CURVE);
    svg_mark(s, svg_at(0, 0), SVG_POINT, SVG_USUAL);
    svg_legend_line(s, SVG_CURVE, "the curve");
    svg_legend_line(s, SVG_FAMILY, "$r=1$");
    svg_legend_line(s, SVG_CURVE_2, "$r=2$");
    svg_legend_line(s, SVG_RIGHT, "$r=3$, the tangent");
    return s;
}
