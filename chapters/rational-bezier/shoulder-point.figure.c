/* shoulder-point.figure.c -- drawings for shoulder-point.claims.h. */
#include "chapters/rational-bezier/conic-figures.h"

FIGURE(shoulder_point)
{
    svg *s =
        svg_new("shoulder_point", "The curve divides the median",
                "The curve with the standard weight ω = 1/2 meets the median R1M in the shoulder point, so that R1Rs : "
                "RsM = 1 : 1/2.  With ω = 1 and 2 the ratios are 1 : 1 and 1 : 2.");
    num_q R[6] = {q(-3), q(0), q(1), q(4), q(3), q(0)}, w[3] = {q(1), r(1, 2), q(1)}, P[2];
    svg_window window = {r(-7, 2), r(-3, 4), r(7, 2), r(23, 5)};
    svg_panel(s, window, 520, 0, NULL);
    svg_control_polygon(s, 2, R, "R");
    svg_point vertex = svg_pair(R + 2), base = svg_at(0, 0);
    svg_segment(s, svg_pair(R), svg_pair(R + 4), SVG_MUTED);
    svg_segment(s, vertex, base, SVG_POINT);
    for (int k = 1; k < 3; k++) {
        num_q other[3] = {q(1), q(k), q(1)};
        svg_rational(s, 2, R, other, SVG_CURVE_2);
        conic_shoulder_point_q(R, other, P);
        svg_mark(s, svg_pair(P), SVG_CURVE_2, SVG_USUAL);
        svg_label(s, svg_pair(P), SVG_NW, SVG_CURVE_2, k == 1 ? "ω=1" : "ω=2");
    }
    svg_rational(s, 2, R, w, SVG_CURVE);
    conic_shoulder_point_q(R, w, P);
    svg_point shoulder = svg_pair(P);
    svg_mark(s, shoulder, SVG_CURVE, SVG_USUAL);
    svg_mark(s, base, SVG_POINT, SVG_USUAL);
    svg_label(s, shoulder, SVG_SE, SVG_CURVE, "R_s");
    svg_label(s, shoulder, SVG_NW, SVG_CURVE, "ω=1/2");
    svg_label(s, base, SVG_S, SVG_POINT, "M");
    svg_label(s, between(R + 2, P, r(1, 4)), SVG_E, SVG_POINT, "1");
    svg_label(s, (svg_point){div_q(P[0], q(2)), div_q(P[1], q(2))}, SVG_E, SVG_POINT, "ω");
    svg_legend_line(s, SVG_CURVE, "ellipse, $ω=1/2$: $R_1R_s:R_sM=1:ω$");
    svg_legend_line(s, SVG_CURVE_2, "parabola, $ω=1$, and hyperbola, $ω=2$");
    return s;
}
