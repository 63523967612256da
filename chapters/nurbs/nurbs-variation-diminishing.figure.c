/* Figures of the section on the intersections of NURBS curves with a line. */
#include "chapters/nurbs/spline-figures.h"

static const int two_intervals[] = {0, 0, 0, 2, 4, 4, 4}, one_interval[] = {0, 0, 0, 0, 2, 2, 2, 2};

static void draw_axis(svg *s) { svg_line(s, svg_at(0, 0), svg_at(1, 0), SVG_MUTED); }

FIGURE(line_and_cut_corners)
{
    svg *s =
        svg_new("line_and_cut_corners", "Cutting corners adds no crossing",
                "A line crosses a polygon five times, the polygon with three knots inserted three times, and the cubic "
                "curve once.");
    static const int point[] = {0, -3, 1, 1, 3, -2, 5, 4, 7, -1, 8, 3}, weight[] = {1, 1, 1, 1, 1, 1};
    static const int knot[] = {0, 0, 0, 0, 2, 4, 6, 6, 6, 6};
    spline c = spline_of(6, 3, knot, 2, point, 1, weight), cut = c;
    for (long i = 1; i <= 5; i += 2)
        cut = with_knot(cut, from_ratio_q(i, 2));
    static const enum svg_direction side[] = {SVG_S, SVG_N, SVG_S, SVG_N, SVG_S, SVG_N};
    svg_panel(s, svg_integer_window(-1, -4, 9, 5), 480, 0, NULL);
    draw_axis(s);
    draw_polygon(s, c, "r", side, SVG_POLYGON);
    draw_polygon(s, cut, NULL, NULL, SVG_RIGHT);
    draw_spline(s, c, SVG_CURVE);
    svg_label(s, svg_at(9, 0), SVG_N, SVG_MUTED, "L");
    svg_legend_line(s, SVG_CURVE, "curve");
    svg_legend_line(s, SVG_POLYGON, "polygon");
    svg_legend_line(s, SVG_RIGHT, "knots inserted");
    svg_legend_line(s, SVG_MUTED, "line");
    return s;
}

FIGURE(what_must_be_counted)
{
    svg *s = svg_new(
        "what_must_be_counted", "What the number of intersections must mean",
        "Left: a polygon that crosses itself on the line has one point there, its curve two. Middle: a polygon "
        "with an edge on the line and no other common point; the curve crosses the line. Right: weights 2, -1, 2; "
        "the polygon with the knot 1/2 inserted crosses a line that the polygon does not meet.");
    static const int bow[] = {-1, 1, 1, -1, -1, -1, 1, 1}, heavy[] = {3, 1, 1, 3};
    static const int edge[] = {0, 1, 1, 0, 2, 0, 3, -1}, roof[] = {-1, 2, 0, 5, 1, 2}, mixed[] = {2, -1, 2};
    static const int quadratic[] = {0, 0, 0, 2, 2, 2};
    static const enum svg_direction bow_side[] = {SVG_N, SVG_S, SVG_S, SVG_N};
    static const enum svg_direction edge_side[] = {SVG_W, SVG_S, SVG_N, SVG_E};
    static const enum svg_direction roof_side[] = {SVG_W, SVG_N, SVG_E};
    spline c = spline_of(4, 2, two_intervals, 2, bow, 1, heavy);
    svg_panel(s, (svg_window){from_ratio_q(-3, 2), from_ratio_q(-7, 4), from_ratio_q(3, 2), from_ratio_q(7, 4)}, 240, 0,
              "points of the plane: the polygon has one,\nthe curve two");
    svg_heading(s, SVG_WRONG, "points of the plane");
    draw_axis(s);
    draw_polygon(s, c, "r", bow_side, SVG_POLYGON);
    draw_spline(s, c, SVG_CURVE);
    svg_mark(s, svg_at(0, 0), SVG_POLYGON, SVG_USUAL);
    svg_mark(s, spline_point(c, from_ratio_q(1, 2)), SVG_WRONG, SVG_USUAL);
    svg_mark(s, spline_point(c, from_ratio_q(3, 2)), SVG_WRONG, SVG_USUAL);
    c = spline_of(4, 3, one_interval, 2, edge, 1, NULL);
    svg_panel(s, (svg_window){from_ratio_q(-1, 2), from_ratio_q(-7, 4), from_ratio_q(7, 2), from_ratio_q(7, 4)}, 260, 0,
              "without its edge $r_2r_3$ the polygon\ndoes not meet the line");
    svg_heading(s, SVG_WRONG, "edges left out");
    draw_axis(s);
    draw_polygon(s, c, "r", edge_side, SVG_POLYGON);
    draw_polygon(s, with_knot(c, from_ratio_q(1, 2)), NULL, NULL, SVG_CURVE_2);
    draw_spline(s, c, SVG_CURVE);
    svg_mark(s, spline_point(c, from_ratio_q(1, 2)), SVG_WRONG, SVG_USUAL);
    c = spline_of(3, 2, quadratic, 2, roof, 1, mixed);
    svg_panel(s, svg_integer_window(-3, -2, 3, 6), 220, 0, "weights $2, -1, 2$: new vertices\nbelow the line");
    svg_heading(s, SVG_WRONG, "weights of both signs");
    draw_axis(s);
    draw_polygon(s, c, "r", roof_side, SVG_POLYGON);
    draw_polygon(s, with_knot(c, from_ratio_q(1, 2)), NULL, NULL, SVG_CURVE_2);
    draw_spline(s, c, SVG_CURVE);
    svg_legend_line(s, SVG_CURVE, "curve");
    svg_legend_line(s, SVG_POLYGON, "polygon");
    svg_legend_line(s, SVG_CURVE_2, "with $1/2$ inserted");
    svg_legend_line(s, SVG_MUTED, "line");
    return s;
}

FIGURE(points_of_the_line_as_vertices)
{
    svg *s = svg_new(
        "points_of_the_line_as_vertices", "Points of intersection become vertices",
        "Two parabolas with the knots 0, 0, 0, 1, 2, 2, 2 cross a line at the parameters 3/5, 1 and 7/5. With each of "
        "them inserted twice the polygon goes through these points and crosses there.");
    static const int point[] = {0, -3, 2, 1, 4, -1, 6, 3};
    static const enum svg_direction side[] = {SVG_W, SVG_N, SVG_S, SVG_E};
    spline c = spline_of(4, 2, two_intervals, 2, point, 1, NULL), cut = c;
    const num_q root[] = {from_ratio_q(3, 5), from_int_q(1), from_ratio_q(7, 5)};
    for (int j = 0; j < 3; j++)
        for (int times = 0; times < 2; times++)
            cut = with_knot(cut, root[j]);
    svg_panel(s, svg_integer_window(-1, -4, 7, 4), 540, 320,
              "The points of the line have the parameters $3/5$, $1$ and $7/5$.");
    draw_axis(s);
    draw_polygon(s, c, "r", side, SVG_POLYGON);
    draw_polygon(s, cut, NULL, NULL, SVG_RIGHT);
    draw_spline(s, c, SVG_CURVE);
    static const char *const name[] = {"3/5", "1", "7/5"};
    static const enum svg_direction beside[] = {SVG_SE, SVG_NE, SVG_NW};
    for (int j = 0; j < 3; j++) {
        svg_mark(s, spline_point(c, root[j]), SVG_CURVE, SVG_USUAL);
        svg_label(s, spline_point(c, root[j]), beside[j], SVG_CURVE, name[j]);
    }
    svg_legend_line(s, SVG_CURVE, "curve");
    svg_legend_line(s, SVG_POLYGON, "polygon");
    svg_legend_line(s, SVG_RIGHT, "knots inserted");
    svg_legend_line(s, SVG_MUTED, "line");
    return s;
}
