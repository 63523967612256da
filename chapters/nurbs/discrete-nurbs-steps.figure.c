/* discrete-nurbs-steps.figure.c -- drawings for discrete-nurbs-steps.claims.h. */
#include "chapters/nurbs/curve-of-claim.h"

static const int hill[] = {0, 0, 1, 6, 7, 7, 10, 2, 13, 4}, hill_knots[] = {0, 0, 0, 0, 3, 6, 6, 6, 6};
static const int hill_weights[] = {1, 2, 1, 2, 1};
static const enum svg_direction hill_sides[] = {SVG_SW, SVG_NW, SVG_N, SVG_S, SVG_E};

FIGURE(insertions_commute)
{
    svg *s = svg_new("insertions_commute", "Knots inserted in either order",
                     "A cubic NURBS curve, into whose knots 1 and 4 are inserted.  Left 1 first, right 4 first: after "
                     "both the polygons are the same. Each "
                     "step cuts corners.");
    spline c = spline_of(5, 3, hill_knots, 1, hill, 1, hill_weights);
    for (int order = 0; order < 2; order++) {
        spline one = with_knot(c, q(order ? 4 : 1)), both = with_knot(one, q(order ? 1 : 4));
        svg_panel(s, svg_integer_window(-1, -1, 14, 8), 360, 0,
                  order ? "knots 0, 0, 0, 0, 3, 6, 6, 6, 6: first 4, then 1"
                        : "knots 0, 0, 0, 0, 3, 6, 6, 6, 6: first 1, then 4");
        draw_polygon(s, c, "r", hill_sides, SVG_POLYGON);
        draw_polygon(s, one, NULL, NULL, SVG_CURVE_2);
        draw_polygon(s, both, NULL, NULL, SVG_RIGHT);
        draw_spline(s, c, SVG_CURVE);
    }
    svg_legend_line(s, SVG_CURVE, "the curve");
    svg_legend_line(s, SVG_POLYGON, "its polygon");
    svg_legend_line(s, SVG_CURVE_2, "after one knot");
    svg_legend_line(s, SVG_RIGHT, "after both: the same");
    return s;
}

FIGURE(insertion_to_the_curve)
{
    static const enum svg_direction other[] = {SVG_SW, SVG_NW, SVG_NE, SVG_SE};
    svg *s = svg_new("insertion_to_the_curve", "A knot inserted up to the curve",
                     "Left a cubic curve, into which t' = 4 is inserted three times: a vertex of the last polygon is "
                     "the point of the curve.  Right a "
                     "curve of order 2 with a double knot: the printed vertex is the limit from the left, the value of "
                     "the curve that from the right.");
    spline c = spline_of(5, 3, hill_knots, 1, hill, 1, hill_weights), d = c;
    svg_panel(s, svg_integer_window(-1, -1, 14, 8), 400, 0, "$k=4$, $t\\'=4$ in $(t_5,t_6]$, inserted $k-1=3$ times");
    svg_heading(s, SVG_RIGHT, "$r_5=r(t\\')$");
    draw_polygon(s, c, NULL, NULL, SVG_POLYGON);
    for (int times = 1; times <= 3; times++) {
        d = with_knot(d, q(4));
        draw_polygon(s, d, NULL, NULL, times == 3 ? SVG_CURVE_2 : SVG_MUTED);
    }
    draw_spline(s, c, SVG_CURVE);
    svg_mark(s, svg_pair(d.R + 8), SVG_RIGHT, SVG_USUAL);
    svg_label(s, svg_pair(d.R + 8), SVG_S, SVG_RIGHT, "r_5");
    c = spline_of_claim("left_value_at_a_k_fold_knot", 4, 1);
    svg_panel(s, window(r(-1, 2), r(-1, 2), r(7, 2), r(2, 1)), 320, 0,
              "$k=2$, knots 0, 0, 1, 1, 2, 2; $t\\'=1$ in $(t_2,t_3]$");
    svg_heading(s, SVG_WRONG, "$r_2≠r(1)$");
    draw_polygon(s, c, NULL, NULL, SVG_MUTED);
    draw_spline(s, c, SVG_CURVE);
    svg_mark(s, svg_pair(c.R + 2), SVG_WRONG, SVG_USUAL);
    svg_mark(s, svg_pair(c.R + 4), SVG_RIGHT, SVG_USUAL);
    svg_label(s, svg_pair(c.R + 2), other[1], SVG_WRONG, "r_2");
    svg_label(s, svg_pair(c.R + 4), other[2], SVG_RIGHT, "r(1)");
    svg_legend_line(s, SVG_CURVE, "the curve");
    svg_legend_line(s, SVG_POLYGON, "its polygon");
    svg_legend_line(s, SVG_CURVE_2, "the polygon after three insertions");
    return s;
}
