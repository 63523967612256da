/* Figures of the section on convexity. */
#include "chapters/rational-bezier/polygon.h"
#include "exact/record/roots.h"

static void draw(svg *s, struct polygon p)
{
    svg_area(s, p.n + 1, p.R, SVG_FILL);
    svg_segment(s, svg_pair(p.R), svg_pair(p.R + 2 * p.n), SVG_MUTED);
    svg_control_polygon(s, p.n, p.R, "R");
    svg_rational(s, p.n, p.R, p.w, SVG_CURVE);
}

static void mark(svg *s, struct polygon p, num_q t) { svg_mark(s, point_at(p, t), SVG_WRONG, SVG_USUAL); }

FIGURE(convex_polygon_convex_curve)
{
    svg *s = svg_new(
        "convex_polygon_convex_curve", "When a convex polygon has a convex curve",
        "Left: a polygon that is convex with its chord, and its convex curve. Middle: a polygon that always turns "
        "left but is not convex with its chord; its curve has two inflections, shown again near its end. Right: a "
        "square with weights 4, "
        "-1, 4, 4, whose curve has two inflections.");
    static const long round[] = {0, 1, 1, 0, 5, 0, 6, 3, 3, 5};
    static const long round_weights[] = {1, 2, 1, 3, 1};
    svg_panel(s, svg_integer_window(-1, -1, 7, 6), 220, 0, "convex with its chord,\npositive weights");
    svg_heading(s, SVG_RIGHT, "the curve is convex");
    draw(s, polygon_of(4, round, round_weights));
    svg_panel(s, svg_integer_window(-1, -2, 13, 6), 220, 0,
              "always to the left, not convex\nwith its chord: two inflections");
    svg_heading(s, SVG_WRONG, "turns of one sign suffice");
    struct polygon p = polygon_of_claim(3, "turns_of_one_sign_are_not_enough");
    draw(s, p);
    svg_panel(s, (svg_window){from_int_q(10), from_ratio_q(3, 2), from_ratio_q(23, 2), from_int_q(3)}, 220, 0,
              "the same near $R_3$: between the crosses\nthe curve turns right");
    svg_polyline(s, 4, p.R, SVG_POLYGON);
    svg_rational(s, p.n, p.R, p.w, SVG_CURVE);
    svg_mark(s, svg_at(11, 2), SVG_POLYGON, SVG_USUAL);
    svg_label(s, svg_at(11, 2), SVG_S, SVG_POINT, "R_3");
    mark(s, p, from_ratio_q(2, 3));
    mark(s, p, from_ratio_q(10, 11));
    svg_frame(s);
    p = polygon_of_claim(3, "mixed_weights_lose_convexity");
    svg_panel(s, (svg_window){from_ratio_q(-1, 2), from_ratio_q(-3, 8), from_ratio_q(3, 2), from_ratio_q(11, 8)}, 220,
              0, "a square, weights $4, -1, 4, 4$:\ntwo inflections");
    svg_heading(s, SVG_WRONG, "weights of both signs");
    draw(s, p);
    /* det(P, P', P'') is a positive multiple of -(1-t)^3 - t (1-t)^2 + 4 t^2 (1-t) - t^3. */
    num_q b[] = {from_int_q(-1), from_ratio_q(-1, 3), from_ratio_q(4, 3), from_int_q(-1)};
    struct cagd_root inflection[3];
    int inflections = isolate_roots(poly_from_bernstein(3, b), from_int_q(0), from_int_q(1), inflection, 3);
    for (int k = 0; k < inflections; k++)
        mark(s, p, refine_root(inflection[k], from_ratio_q(1, 4096)).lo);
    svg_legend_line(s, SVG_CURVE, "curve");
    svg_legend_line(s, SVG_POLYGON, "polygon");
    svg_legend_line(s, SVG_MUTED, "chord");
    svg_legend_mark(s, SVG_WRONG, SVG_USUAL, "inflection");
    return s;
}

FIGURE(convex_halves)
{
    svg *s =
        svg_new("convex_halves", "Subdivision cuts corners and keeps a polygon convex",
                "A convex polygon of four points, the polygons of the two halves of its curve, joined, and those of "
                "the four quarters.");
    static const long point[] = {0, 0, 1, 4, 5, 4, 6, 0}, weight[] = {1, 1, 3, 1};
    struct polygon p = polygon_of(3, point, weight), half[2], quarter[4];
    num_q middle = from_ratio_q(1, 2);
    rational_split_q(3, 2, p.R, p.w, middle, half[0].R, half[0].w, half[1].R, half[1].w);
    svg_panel(s, svg_integer_window(-1, -1, 7, 5), 480, 0, "every polygon is the one before with corners cut off");
    svg_control_polygon(s, p.n, p.R, "R");
    for (int k = 0; k < 2; k++) {
        svg_polyline(s, 4, half[k].R, SVG_RIGHT);
        rational_split_q(3, 2, half[k].R, half[k].w, middle, quarter[2 * k].R, quarter[2 * k].w, quarter[2 * k + 1].R,
                         quarter[2 * k + 1].w);
        svg_polyline(s, 4, quarter[2 * k].R, SVG_CURVE_2);
        svg_polyline(s, 4, quarter[2 * k + 1].R, SVG_CURVE_2);
    }
    svg_rational(s, p.n, p.R, p.w, SVG_CURVE);
    svg_legend_line(s, SVG_POLYGON, "polygon");
    svg_legend_line(s, SVG_RIGHT, "of the halves");
    svg_legend_line(s, SVG_CURVE_2, "of the quarters");
    svg_legend_line(s, SVG_CURVE, "curve");
    return s;
}
