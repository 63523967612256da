/* preface.figure.c -- drawings for preface.claims.h. */
#include "chapters/nurbs/curve-of-claim.h"

#include "chapters/nurbs/counting.h"

FIGURE(nurbs_circle)
{
    static const int knot[] = {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4};
    static const enum svg_direction side[] = {SVG_E, SVG_NE, SVG_N, SVG_NW, SVG_W, SVG_SW, SVG_S, SVG_SE};
    svg *s =
        svg_new("nurbs_circle", "A circle as one NURBS curve",
                "The unit circle as a quadratic NURBS curve: nine points on the square around it, with the weights "
                "1, 1, 2, 1, 1, 1, 2, 1, 1, the first and the last point being one.");
    spline c = {.n = 9, .p = 2};
    data_of("circle_is_a_nurbs_curve", "r", 9, 2, c.R);
    data_of("circle_is_a_nurbs_curve", "w", 9, 1, c.w);
    for (int i = 0; i < 12; i++)
        c.u[i] = q(knot[i]);
    svg_panel(s, window(r(-8, 5), r(-3, 2), r(8, 5), r(3, 2)), 330, 0,
              "$k=3$, knots $0,0,0,1,1,2,2,3,3,4,4,4$;\nat each point its weight");
    draw_polygon(s, c, NULL, NULL, SVG_POLYGON);
    draw_spline(s, c, SVG_CURVE);
    for (int i = 0; i < 8; i++) {
        const char *name = i == 0 ? "1, 1" : to_string_q(c.w[i]);
        svg_label(s, svg_pair(c.R + 2 * i), side[i], SVG_POINT, name);
    }
    svg_legend_line(s, SVG_CURVE, "the circle, exactly");
    svg_legend_line(s, SVG_POLYGON, "its control polygon");
    return s;
}

FIGURE(recursion_steps)
{
    enum { first = 2, last = 12 };
    svg *s =
        svg_new("recursion_steps", "How many operations a point takes",
                "The number of operations for one point of a plane NURBS curve against the order k from 2 to 12: the "
                "algorithm that keeps its points grows like k², the plain recursion leaves the picture after k = 6, "
                "Horner's rule for a segment in the power basis grows like k.");
    num_q kept[2 * last], again[2 * last], horner[2 * last];
    int count = 0;
    for (int k = first; k <= last; k++, count++) {
        long cost[3], tree;
        counted_work(k - 1, 2, cost, &tree);
        kept[2 * count] = again[2 * count] = horner[2 * count] = q(k);
        kept[2 * count + 1] = q(cost[0]);
        again[2 * count + 1] = q(tree);
        horner[2 * count + 1] = q(3 * 2 * (k - 1));
    }
    svg_panel(s, svg_integer_window(2, 0, 12, 1200), 430, 300, "Operations for one point, against the order $k$");
    svg_grid(s, q(1), q(200));
    svg_axes(s, q(1), q(200), "k", NULL);
    svg_polyline(s, count, again, SVG_WRONG);
    svg_polyline(s, count, kept, SVG_CURVE);
    svg_polyline(s, count, horner, SVG_CURVE_2);
    for (int i = 0; i < count; i++) {
        if (before_q(again[2 * i + 1], q(1200)))
            svg_mark(s, svg_pair(again + 2 * i), SVG_WRONG, SVG_USUAL);
        svg_mark(s, svg_pair(kept + 2 * i), SVG_CURVE, SVG_USUAL);
        svg_mark(s, svg_pair(horner + 2 * i), SVG_CURVE_2, SVG_USUAL);
    }
    svg_frame(s);
    svg_legend_line(s, SVG_CURVE, "de Boor's algorithm, level after level: quadratic");
    svg_legend_line(s, SVG_WRONG, "the recursion that forgets its points: exponential");
    svg_legend_line(s, SVG_CURVE_2, "Horner's rule on one segment: linear");
    return s;
}
