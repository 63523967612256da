#include "chapters/rational-bezier/envelope-figures.h"

FIGURE(envelope_contact)
{
    svg *s =
        svg_new("envelope_contact", "Curve and member touch, they do not osculate",
                "Left the cubic (τ, τ³) and its quadratic member of c = 1: they touch at (1, 1), with different "
                "curvatures.  Right the quartic (τ, τ⁴ + 3τ²/2) at τ = 0 with its members r = 1, 2, 3 and the circles "
                "of curvature of the quartic, of radius 1/3, and of the member r = 2, of radius 1/2.");
    static const int cubic[8] = {0, 0, 1, 0, 2, 0, 3, 3}, quartic[10] = {-2, 5, -1, -2, 0, 1, 1, -2, 2, 5};
    num_q R[10], w[5];
    ones(4, w);
    fractions(8, cubic, 3, R);
    svg_panel(s, window(q(0), r(-1, 10), r(11, 10), r(11, 10)), 350, 0,
              "$n=3$, $r=1$, $c=1$: $y\\'\\'=6$ and $y\\'\\'=9/2$");
    svg_axes(s, r(1, 2), r(1, 2), "x", "y");
    svg_bezier(s, 3, R, SVG_CURVE);
    put_member(s, 3, R, w, 1, q(1), SVG_CURVE_2);
    svg_mark(s, svg_at(1, 1), SVG_POINT, SVG_USUAL);
    svg_label(s, svg_at(1, 1), SVG_W, SVG_POINT, "R(1)");
    fractions(10, quartic, 2, R);
    svg_panel(s, window(r(-4, 5), r(-1, 5), r(4, 5), r(11, 10)), 430, 0,
              "$n=4$, $τ=0$, $c=1/2$: the curvatures are 3, 8/3, 2 and 0");
    svg_circle(s, at(q(0), r(1, 3)), r(1, 3), SVG_MUTED);
    svg_circle(s, at(q(0), r(1, 2)), r(1, 2), SVG_MUTED);
    put_member(s, 4, R, w, 1, r(1, 2), SVG_FAMILY);
    put_member(s, 4, R, w, 3, r(1, 2), SVG_FAMILY);
    svg_bezier(s, 4, R, SVG_CURVE);
    put_member(s, 4, R, w, 2, r(1, 2), SVG_CURVE_2);
    svg_mark(s, svg_at(0, 0), SVG_POINT, SVG_USUAL);
    svg_label(s, svg_at(0, 0), SVG_S, SVG_POINT, "R(c)");
    svg_note(s, at(r(1, 4), r(0, 1)), SVG_SE, SVG_FAMILY, "$r=3$");
    svg_legend_line(s, SVG_CURVE, "the curve");
    svg_legend_line(s, SVG_CURVE_2, "the member with $n-r=2$");
    svg_legend_line(s, SVG_FAMILY, "the members $r=1$ and $r=3$");
    svg_legend_line(s, SVG_MUTED, "circles of curvature");
    return s;
}
