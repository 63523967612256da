/* nurbs-convergence.figure.c -- drawings for nurbs-convergence.claims.h. */
#include "chapters/nurbs/curve-of-claim.h"

FIGURE(nurbs_polygons_converge)
{
    static const int point[] = {0, 0, 1, 7, 6, 8, 8, 0, 13, 5}, knot[] = {0, 0, 0, 0, 4, 8, 8, 8, 8},
                     weight[] = {1, 2, 1, 3, 1};
    svg *s = svg_new("nurbs_polygons_converge", "The polygons converge",
                     "A cubic NURBS curve with its polygon, and with the polygons after every gap of the knots has "
                     "been halved once and twice. The distance is "
                     "divided by about four each time.");
    spline c = spline_of(5, 3, knot, 1, point, 1, weight), d = c;
    for (int step = 0; step < 3; step++) {
        static const char *const caption[] = {"$T$: gaps 4", "gaps 2", "gaps 1"};
        int gap = 8 >> step;
        for (int t = gap / 2; step > 0 && t < 8; t += gap)
            d = with_knot(d, q(t));
        svg_panel(s, svg_integer_window(-1, -1, 14, 9), 250, 0, caption[step]);
        draw_polygon(s, d, NULL, NULL, SVG_POLYGON);
        draw_spline(s, c, SVG_CURVE);
    }
    svg_legend_line(s, SVG_CURVE, "the curve");
    svg_legend_line(s, SVG_POLYGON, "the polygon over $T⊕T_m\\'$");
    return s;
}

FIGURE(no_convergence)
{
    svg *s = svg_new(
        "no_convergence", "Polygons that do not converge",
        "Left seven knots are inserted on one side of a quadratic curve: the corner (2, 2) of the other side stays.  "
        "Right a quadratic segment over simple "
        "knots, every gap halved three times: the polygon still begins in r1 and ends in r3, away from the curve.");
    const char *one_side = "knots_on_one_side_do_not_converge";
    spline c = spline_of_claim(one_side, 4, 2), d = c;
    num_q added[7];
    data_of(one_side, "T'", 7, 1, added);
    for (int i = 0; i < 7; i++)
        d = with_knot(d, added[i]);
    svg_panel(s, window(r(-1, 2), r(-1, 2), r(5, 2), r(5, 2)), 280, 0, "seven knots inserted in $(0,1)$ only");
    svg_heading(s, SVG_WRONG, "corner");
    draw_polygon(s, c, NULL, NULL, SVG_MUTED);
    draw_polygon(s, d, NULL, NULL, SVG_POLYGON);
    draw_spline(s, c, SVG_CURVE);
    svg_mark(s, svg_at(2, 2), SVG_WRONG, SVG_USUAL);
    svg_label(s, svg_at(2, 2), SVG_N, SVG_WRONG, "(2,2)");
    /* Eight parts of each of the gaps -2, ..., 3: the curve over all six knots, extended by points that begin and end it. */
    int parts = 8, count = 0;
    num_q polygon[2 * (5 * 8 + 2)];
    spline e = spline_of_claim("first_vertex_stays_off_the_curve", 3, 2);
    /* Vertex j of the refined polygon is sum alpha_i(j) r_i, sum over the three points there are; where one span has fewer than
     * three of them the others count 0, weight and all. */
    spline wide = {.n = 7, .p = 2};
    for (int i = 0; i < 10; i++)
        wide.u[i] = q(i - 4);
    num_q H[3 * 7], x[2], vertex[3];
    for (int i = 0; i < 7; i++) {
        int inside = 2 <= i && i <= 4;
        H[3 * i] = inside ? e.R[2 * (i - 2)] : q(0);
        H[3 * i + 1] = inside ? e.R[2 * (i - 2) + 1] : q(0);
        H[3 * i + 2] = q(inside);
    }
    for (int j = 0; j + 3 <= 5 * parts; j++, count++) {
        x[0] = r(j + 1 - 2 * parts, parts);
        x[1] = r(j + 2 - 2 * parts, parts);
        int mu = find_span_q(wide.n, wide.p, wide.u, r(2 * (j + 1) - 4 * parts + 1, 2 * parts));
        bspline_blossom_q(on_span_q(2, 3, wide.u, mu, H), x, vertex);
        polygon[2 * count] = div_q(vertex[0], vertex[2]);
        polygon[2 * count + 1] = div_q(vertex[1], vertex[2]);
    }
    svg_panel(s, window(r(-1, 2), r(-1, 2), r(5, 2), r(5, 2)), 280, 0, "knots from −2 to 3, every gap cut in eight");
    svg_heading(s, SVG_WRONG, "ends");
    svg_polyline(s, 3, e.R, SVG_MUTED);
    svg_polyline(s, count, polygon, SVG_POLYGON);
    draw_spline(s, e, SVG_CURVE);
    svg_mark(s, svg_at(0, 0), SVG_WRONG, SVG_USUAL);
    svg_label(s, svg_at(0, 0), SVG_W, SVG_WRONG, "r_1");
    svg_mark(s, svg_at(2, 0), SVG_WRONG, SVG_USUAL);
    svg_label(s, svg_at(2, 0), SVG_E, SVG_WRONG, "r_3");
    svg_legend_line(s, SVG_CURVE, "the curve");
    svg_legend_line(s, SVG_POLYGON, "the polygon over $T⊕T_m\\'$");
    svg_legend_line(s, SVG_MUTED, "the first polygon");
    return s;
}
