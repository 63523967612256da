/* The figure of the section on the table of differences. */
#include "chapters/foundations/figures.h"

FIGURE(forward_differences)
{
    svg *s = svg_new("forward_differences", "A table of forward differences",
                     "A cubic at equidistant parameters.  The first forward difference leads from a point to the next "
                     "one; the printed "
                     "one, with t - delta, leads back.");
    const int coefficients[8] = {0, 0, 3, 4, 0, -9, 0, 6};
    num_q c[8];
    integers(8, coefficients, c);
    svg_panel(s, window(r(-1, 4), r(-1, 4), r(13, 4), r(3, 2)), 560, 0, "$δ=1/4$");
    put_power_curve(s, 3, c, q(0), q(1), SVG_CURVE);
    static const char *const names[5] = {"P_0", "P_1", "P_2", "P_3", "P_4"};
    for (int k = 0; k <= 4; k++) {
        svg_point P = power_curve_point(3, c, r(k, 4));
        svg_mark(s, P, SVG_POINT, SVG_USUAL);
        svg_label(s, P, k == 0 ? SVG_W : k < 3 ? SVG_N : k == 3 ? SVG_S : SVG_E, SVG_POINT, names[k]);
    }
    svg_arrow(s, power_curve_point(3, c, r(1, 4)), power_curve_point(3, c, r(2, 4)), SVG_RIGHT);
    svg_arrow(s, power_curve_point(3, c, r(1, 4)), power_curve_point(3, c, q(0)), SVG_WRONG);
    svg_legend_line(s, SVG_CURVE, "the cubic");
    svg_legend_line(s, SVG_RIGHT, "$ΔP_1=P(t+δ)-P(t)$");
    svg_legend_line(s, SVG_WRONG, "$P(t-δ)-P(t)$, as printed");
    return s;
}
