/* envelope-uniqueness-proof.figure.c -- drawings for envelope-uniqueness-proof.claims.h. */
#include "chapters/nurbs/family-figures.h"

FIGURE(order_and_level)
{
    svg *s =
        svg_new("order_and_level", "An order is not a level",
                "The curve (t, t³, t⁴ + 1) of order 7 in the projection (x, y), r = 5, τ = 0.  The member of level 4 "
                "is straight, as the proof needs it; the member of order 4, which the printed superscript names, is "
                "a cubic.");
    static const int x[7] = {0, 1}, y[7] = {0, 0, 0, 1};
    struct nurbs c = one_span(6, 1, x, y);
    svg_panel(s, window(r(-3, 5), r(-3, 50), r(3, 5), r(3, 50)), 440, 270,
              "$k=7$, $r=5$, $τ=0$; the heights are stretched");
    svg_axes(s, r(1, 5), r(1, 50), "x", "y");
    put_curve(s, &c, SVG_CURVE);
    put_member(s, &c, 6, 4, q(0), SVG_RIGHT);
    put_member(s, &c, 6, 3, q(0), SVG_WRONG);
    svg_legend_line(s, SVG_CURVE, "the curve");
    svg_legend_line(s, SVG_RIGHT, "the member of level $r-1=4$");
    svg_legend_line(s, SVG_WRONG, "the member of order $r-1=4$");
    return s;
}
