#include "chapters/judge/figure_data.h"
#include "chapters/rational-bezier/envelope-figures.h"

FIGURE(envelope_extra)
{
    svg *s =
        svg_new("envelope_extra", "Envelopes beside the curve",
                "Left the quadratic members of the cubic (τ, τ³): they touch the cubic and also the axis y = 0.  Right "
                "the quadratic members of the convex quartic (τ, τ⁴ + 3τ²/2): many of them touch the parabola y = x² - "
                "1/16 below it.");
    num_q R[10], w[5];
    data_of("cubic_family_has_another_envelope", "R", 4, 2, R);
    ones(4, w);
    svg_panel(s, window(r(-3, 5), r(-1, 6), r(3, 5), r(1, 6)), 380, 285,
              "$n=3$, $r=1$: the cubic $(τ,τ^3)$ has an inflection\n($y$ stretched)");
    put_family(s, 3, R, w, 1, 24);
    svg_bezier(s, 3, R, SVG_CURVE);
    svg_segment(s, at(r(-1, 3), q(0)), at(r(1, 3), q(0)), SVG_WRONG);
    svg_mark(s, at(r(1, 6), q(0)), SVG_WRONG, SVG_USUAL);
    svg_label(s, at(r(1, 6), q(0)), SVG_S, SVG_WRONG, "(1/6,0)");
    svg_frame(s);
    data_of("convex_quartic_has_another_envelope", "R", 5, 2, R);
    svg_panel(s, window(r(-3, 5), r(-3, 20), r(3, 5), r(3, 4)), 380, 0,
              "$n=4$, $r=2$: the quartic $(τ,τ^4+3τ^2/2)$ is convex");
    put_family(s, 4, R, w, 2, 24);
    svg_bezier(s, 4, R, SVG_CURVE);
    num_q parabola[6] = {r(-3, 8), r(5, 64), q(0), r(-13, 64), r(3, 8), r(5, 64)};
    svg_bezier(s, 2, parabola, SVG_WRONG);
    svg_mark(s, at(q(0), r(-1, 16)), SVG_WRONG, SVG_USUAL);
    svg_label(s, at(q(0), r(-1, 16)), SVG_S, SVG_WRONG, "(0,-1/16)");
    svg_frame(s);
    svg_legend_line(s, SVG_CURVE, "the curve");
    svg_legend_line(s, SVG_FAMILY, "its members");
    svg_legend_line(s, SVG_WRONG, "the other envelope");
    return s;
}
