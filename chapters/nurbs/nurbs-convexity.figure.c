/* nurbs-convexity.figure.c -- drawings for nurbs-convexity.claims.h. */
#include "chapters/nurbs/curve-of-claim.h"

FIGURE(what_convex_must_mean)
{
    svg *s =
        svg_new("what_convex_must_mean", "When the polygon of a NURBS curve is convex",
                "Left: a polygon that goes from the origin to (1,0), back to the origin and up; as a set it is two "
                "sides of a triangle, but its curve is not convex. Middle: a polygon that runs round a triangle "
                "and over its first side again; with one corner cut it is not convex. Right: a "
                "polygon that runs through the boundary of a convex set once, and its convex curve.");
    static const int two_intervals[] = {0, 0, 0, 2, 4, 4, 4}, once[] = {0, 0, 4, 0, 4, 3, 1, 4};
    static const enum svg_direction back_side[] = {SVG_SW, SVG_E, SVG_HERE, SVG_N};
    static const enum svg_direction over_side[] = {SVG_SW, SVG_E, SVG_N, SVG_HERE, SVG_HERE};
    static const enum svg_direction once_side[] = {SVG_SW, SVG_SE, SVG_NE, SVG_N};
    const char *back = "polygon_that_turns_back_loses_convexity",
               *over = "polygon_that_overlaps_itself_loses_convexity";
    const char *back_curve = "curve_of_a_polygon_that_turns_back_is_not_convex";
    spline c = spline_of_claim(back, 4, 2), cut = with_knot(c, number_of_claim(back, "τ"));
    svg_panel(s, scaled_window(-1, -1, 6, 6, 5), 230, 0,
              "$r_1 = r_3$: there and back;\n$r(3/2)$ is inside the hull of the curve");
    svg_heading(s, SVG_WRONG, "a set: turning back");
    num_q triangle[6], where[3], inside = number_of_claim(back_curve, "τ");
    data_of(back_curve, "t", 3, 1, where);
    for (int i = 0; i < 3; i++) {
        svg_point P = spline_point(c, where[i]);
        triangle[2 * i] = P.x;
        triangle[2 * i + 1] = P.y;
    }
    svg_area(s, 3, triangle, SVG_FILL);
    draw_polygon(s, c, "r", back_side, SVG_POLYGON);
    svg_polyline(s, cut.n, cut.R, SVG_CURVE_2);
    draw_spline(s, c, SVG_CURVE);
    svg_mark(s, spline_point(c, inside), SVG_WRONG, SVG_USUAL);
    svg_label(s, spline_point(c, inside), SVG_NE, SVG_WRONG, "r(3/2)");

    c = spline_of_claim(over, 5, 2);
    cut = with_knot(c, number_of_claim(over, "τ"));
    svg_panel(s, scaled_window(-2, -2, 12, 12, 5), 230, 0,
              "$r_4 = r_1$, $r_5 = r_2$; with the knot $1/2$\nan edge is inside the hull");
    svg_heading(s, SVG_WRONG, "a set: overlapping");
    svg_area(s, 3, c.R, SVG_FILL);
    draw_polygon(s, c, "r", over_side, SVG_POLYGON);
    draw_polygon(s, cut, NULL, NULL, SVG_CURVE_2);
    draw_spline(s, c, SVG_CURVE);

    c = spline_of(4, 2, two_intervals, 2, once, 1, NULL);
    cut = with_knot(with_knot(c, from_ratio_q(1, 2)), from_ratio_q(3, 2));
    svg_panel(s, scaled_window(-1, -1, 5, 5, 1), 230, 0,
              "every polygon and the curve\nare on the boundary of their hulls");
    svg_heading(s, SVG_RIGHT, "run through once");
    svg_area(s, c.n, c.R, SVG_FILL);
    draw_polygon(s, c, "r", once_side, SVG_POLYGON);
    draw_polygon(s, cut, NULL, NULL, SVG_CURVE_2);
    draw_spline(s, c, SVG_CURVE);
    svg_legend_line(s, SVG_CURVE, "curve");
    svg_legend_line(s, SVG_POLYGON, "polygon");
    svg_legend_line(s, SVG_CURVE_2, "with knots inserted");
    svg_legend_area(s, SVG_FILL, "convex hull");
    return s;
}

FIGURE(where_hypotheses_are_needed)
{
    svg *s = svg_new(
        "where_hypotheses_are_needed", "What goes wrong without the hypotheses",
        "From left to right: convex polygons flatten to a segment that is run through twice; a polygon with "
        "a point inside its hull has no convex set with it on the boundary; a knot before the domain asks "
        "for a point before the first, here tried in two places; with weights 2, -1, 2 the new vertex on the first "
        "line goes to infinity as the knot approaches 2/3.");
    svg_panel(s, scaled_window(-1, -2, 6, 6, 5), 170, 0, "the limit goes\nthere and back");
    svg_heading(s, SVG_WRONG, "flat limit");
    num_q h[7];
    data_of("limit_of_convex_polygons_may_run_back", "h", 7, 1, h);
    for (int m = 0; m < 7; m++) {
        num_q R[] = {from_int_q(0), from_int_q(0), from_int_q(1), from_int_q(0),
                     from_int_q(1), h[m],          from_int_q(0), h[m]};
        svg_polyline(s, 4, R, m == 0 ? SVG_POLYGON : SVG_FAMILY);
    }
    svg_segment(s, svg_at(0, 0), svg_at(1, 0), SVG_WRONG);

    static const enum svg_direction dent_side[] = {SVG_S, SVG_SE, SVG_NE, SVG_NW};
    spline c = {.n = 4, .p = 1};
    data_of("curve_inside_its_hull_has_no_smallest_set", "r", 4, 2, c.R);
    num_q triangle[] = {c.R[0], c.R[1], c.R[2], c.R[3], c.R[6], c.R[7]};
    svg_panel(s, svg_integer_window(-1, -1, 4, 4), 170, 0, "$r_3$ is inside every\nconvex set about them");
    svg_heading(s, SVG_WRONG, "not convex");
    svg_area(s, 3, triangle, SVG_FILL);
    draw_polygon(s, c, "r", dent_side, SVG_POLYGON);
    svg_mark(s, svg_pair(c.R + 4), SVG_WRONG, SVG_USUAL);

    static const int point[] = {2, 0, 5, 1, 4, 4}, simple[] = {2, 4, 6, 8, 10, 12}, before[2][2] = {{0, 3}, {-1, 1}};
    static const enum svg_direction side[] = {SVG_S, SVG_SE, SVG_N};
    c = spline_of(3, 2, simple, 2, point, 1, NULL);
    svg_panel(s, svg_integer_window(-2, -1, 6, 5), 190, 0, "$t_i = i$, $τ = 3/2$:\n$r_1' = 3/4 r_0 + 1/4 r_1$");
    svg_heading(s, SVG_WRONG, "outside the domain");
    for (int i = 0; i < 2; i++) {
        num_q quarter = from_ratio_q(1, 4), rest = from_ratio_q(3, 4), P[2];
        for (int k = 0; k < 2; k++)
            P[k] = add_q(mul_q(rest, from_int_q(before[i][k])), mul_q(quarter, c.R[k]));
        svg_segment(s, svg_at(before[i][0], before[i][1]), svg_pair(c.R), SVG_MUTED);
        svg_mark(s, svg_at(before[i][0], before[i][1]), SVG_MUTED, SVG_USUAL);
        svg_label(s, svg_at(before[i][0], before[i][1]), SVG_N, SVG_MUTED, "r_0");
        svg_mark(s, svg_pair(P), SVG_WRONG, SVG_USUAL);
    }
    draw_polygon(s, c, "r", side, SVG_POLYGON);
    draw_spline(s, c, SVG_CURVE);

    static const int base[] = {0, 0, 1, 0, 2, 2}, bezier[] = {0, 0, 0, 2, 2, 2};
    static const enum svg_direction base_side[] = {SVG_S, SVG_S, SVG_E};
    c = spline_of(3, 2, bezier, 2, base, 1, NULL);
    data_of("vanishing_weight_loses_the_new_point", "w", 3, 1, c.w);
    svg_panel(s, svg_integer_window(-4, -2, 3, 4), 210, 0,
              "$r_2'$ for $τ = 1/4, 1/2, 3/5$;\nfor $τ = 2/3$ there is none");
    svg_heading(s, SVG_WRONG, "a new weight $0$");
    draw_polygon(s, c, "r", base_side, SVG_POLYGON);
    draw_spline(s, c, SVG_CURVE);
    static const int knot[3][2] = {{1, 4}, {1, 2}, {3, 5}};
    for (int i = 0; i < 3; i++)
        svg_mark(s, svg_pair(with_knot(c, from_ratio_q(knot[i][0], knot[i][1])).R + 2), SVG_WRONG, SVG_USUAL);
    svg_arrow(s, svg_at(-3, 0), svg_at(-4, 0), SVG_WRONG);
    svg_legend_line(s, SVG_POLYGON, "polygon");
    svg_legend_line(s, SVG_CURVE, "curve");
    svg_legend_mark(s, SVG_WRONG, SVG_USUAL, "what is asked for");
    svg_legend_area(s, SVG_FILL, "convex hull");
    return s;
}
