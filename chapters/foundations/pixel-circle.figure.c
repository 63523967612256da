/* The figure of the section on steps of one pixel. */
#include "chapters/foundations/figures.h"

FIGURE(step_of_the_third_way)
{
    svg *s = svg_new("step_of_the_third_way", "At height one the second point is more than one away",
                     "A circle of radius 5/4.  The point at height 1 is farther than 1 from the first point: the "
                     "circle of radius 1 about "
                     "the first point meets the circle below it.");
    num_q radius = r(5, 4);
    svg_panel(s, window(r(-1, 4), r(-1, 4), r(5, 2), r(5, 4)), 420, 0, "$r=5/4$: $|A_0A_1|=\\√5/2$ at height 1");
    svg_circle(s, svg_at(0, 0), radius, SVG_CURVE);
    svg_circle(s, at(radius, q(0)), q(1), SVG_MUTED);
    svg_line(s, svg_at(0, 1), svg_at(1, 1), SVG_FAMILY);
    svg_point first = at(radius, q(0)), second = at(r(3, 4), q(1));
    svg_segment(s, first, second, SVG_WRONG);
    svg_segment(s, svg_at(0, 0), first, SVG_POLYGON);
    svg_segment(s, svg_at(0, 0), second, SVG_POLYGON);
    svg_mark(s, first, SVG_POINT, SVG_USUAL);
    svg_label(s, first, SVG_SE, SVG_POINT, "A_0");
    svg_mark(s, second, SVG_WRONG, SVG_USUAL);
    svg_label(s, second, SVG_N, SVG_WRONG, "A_1");
    svg_legend_line(s, SVG_CURVE, "the circle");
    svg_legend_line(s, SVG_MUTED, "distance 1 from $A_0$");
    svg_legend_line(s, SVG_FAMILY, "height 1");
    svg_legend_line(s, SVG_WRONG, "the distance of the two points");
    return s;
}
