/* The figure of the section on crossings with a line. */
#include "chapters/rational-bezier/polygon.h"

static void draw(svg *s, struct polygon p)
{
    svg_control_polygon(s, p.n, p.R, "R");
    svg_rational(s, p.n, p.R, p.w, SVG_CURVE);
}

FIGURE(line_crossings)
{
    svg *s = svg_new(
        "line_crossings", "A line crosses the curve no more often than the polygon",
        "Left: a curve that a line crosses once, its polygon three times. Middle: a polygon that crosses itself "
        "on the line; it has one point there, the curve has two, but both cross the line twice. Right: with "
        "weights 2, -1, 2 the curve crosses a line that the polygon does not meet.");
    static const long wave[] = {0, -3, 1, 2, 3, -2, 4, 3}, wave_weights[] = {1, 1, 1, 1};
    svg_panel(s, svg_integer_window(-1, -4, 5, 4), 260, 0, "the polygon crosses the line\nthree times, the curve once");
    svg_heading(s, SVG_RIGHT, "crossings, positive weights");
    svg_line(s, svg_at(0, 0), svg_at(1, 0), SVG_MUTED);
    draw(s, polygon_of(3, wave, wave_weights));
    svg_label(s, svg_at(5, 0), SVG_N, SVG_MUTED, "L");

    struct polygon p = polygon_of_claim(3, "self_crossing_polygon_meets_the_line_once");
    svg_panel(s, (svg_window){from_ratio_q(-3, 2), from_int_q(-2), from_ratio_q(3, 2), from_int_q(2)}, 260, 0,
              "one point of the polygon on the line,\ntwo of the curve; crossings: two and two");
    svg_heading(s, SVG_WRONG, "points of the plane");
    svg_line(s, svg_at(0, 0), svg_at(1, 0), SVG_MUTED);
    draw(s, p);
    svg_mark(s, svg_at(0, 0), SVG_POLYGON, SVG_USUAL);
    for (int k = 1; k <= 2; k++)
        svg_mark(s, point_at(p, from_ratio_q(k, 3)), SVG_WRONG, SVG_USUAL);

    p = polygon_of_claim(2, "mixed_weights_cross_more");
    svg_panel(s, svg_integer_window(-3, -2, 3, 6), 260, 0,
              "weights $2, -1, 2$: the curve crosses\nthe line twice, the polygon never");
    svg_heading(s, SVG_WRONG, "weights of both signs");
    svg_line(s, svg_at(0, 0), svg_at(1, 0), SVG_MUTED);
    draw_triangle(s, p);
    svg_rational(s, p.n, p.R, p.w, SVG_CURVE);
    for (int k = 1; k <= 2; k++)
        svg_mark(s, point_at(p, from_ratio_q(k, 3)), SVG_WRONG, SVG_USUAL);
    svg_legend_line(s, SVG_CURVE, "curve");
    svg_legend_line(s, SVG_POLYGON, "polygon");
    svg_legend_line(s, SVG_MUTED, "line $L$");
    return s;
}
