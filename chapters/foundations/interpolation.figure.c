/* Figures of the section on interpolation and approximation. */
#include "chapters/foundations/figures.h"

FIGURE(through_and_near)
{
    svg *s = svg_new("through_and_near", "A curve through three data, and the line nearest to them",
                     "The data 0, 1, 0 at t = 0, 1, 2; the parabola through them, and the line of height one third, "
                     "for which the sum of "
                     "the squares of the distances is least.");
    svg_panel(s, window(r(-1, 4), r(-1, 4), r(9, 4), r(5, 4)), 400, 0, "the data $0,1,0$ at $t=0,1,2$");
    svg_axes(s, q(1), r(1, 2), "t", NULL);
    num_q c[6] = {q(0), q(0), q(1), q(2), q(0), q(-1)};
    put_power_curve(s, 2, c, q(0), q(2), SVG_CURVE);
    svg_segment(s, at(q(0), r(1, 3)), at(q(2), r(1, 3)), SVG_CURVE_2);
    for (int t = 0; t <= 2; t++) {
        svg_segment(s, at(q(t), q(t == 1)), at(q(t), r(1, 3)), SVG_MUTED);
        svg_mark(s, svg_at(t, t == 1), SVG_POINT, SVG_USUAL);
    }
    svg_legend_line(s, SVG_CURVE, "interpolation");
    svg_legend_line(s, SVG_CURVE_2, "approximation");
    svg_legend_line(s, SVG_MUTED, "the distances");
    return s;
}
