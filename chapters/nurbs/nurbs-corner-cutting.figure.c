/* nurbs-corner-cutting.figure.c -- drawings for nurbs-corner-cutting.claims.h. */
#include "chapters/nurbs/curve-of-claim.h"
#include "exact/record/roots.h"

FIGURE(cutting_corners)
{
    svg *s = svg_new("cutting_corners", "The insertion of a knot puts one vertex on each edge",
                     "Left: a convex polygon of a cubic curve and the polygon with one knot more; the ratios in which "
                     "the new vertices divide the edges depend on the weights. Right: the same knot inserted three "
                     "times, so that a point of the curve is a vertex.");
    static const int point[] = {0, 2, 1, 0, 5, 0, 7, 2, 6, 5, 3, 6}, weight[] = {1, 4, 1, 1, 3, 1};
    static const int knot[] = {0, 0, 0, 0, 2, 4, 6, 6, 6, 6};
    static const enum svg_direction side[] = {SVG_W, SVG_SW, SVG_SE, SVG_E, SVG_NE, SVG_NW};
    spline c = spline_of(6, 3, knot, 2, point, 1, weight), cut = with_knot(c, from_ratio_q(3, 2));
    svg_panel(s, svg_integer_window(-1, -1, 8, 7), 330, 0, "one knot $3/2$: three new vertices,\ntwo corners cut");
    draw_polygon(s, c, "r", side, SVG_POLYGON);
    draw_polygon(s, cut, NULL, NULL, SVG_RIGHT);
    draw_spline(s, c, SVG_CURVE);
    for (int times = 0; times < 2; times++)
        cut = with_knot(cut, from_ratio_q(3, 2));
    svg_panel(s, svg_integer_window(-1, -1, 8, 7), 330, 0, "three times: $r(3/2)$ is a vertex");
    draw_polygon(s, c, "r", side, SVG_POLYGON);
    draw_polygon(s, cut, NULL, NULL, SVG_RIGHT);
    draw_spline(s, c, SVG_CURVE);
    svg_mark(s, spline_point(c, from_ratio_q(3, 2)), SVG_CURVE, SVG_USUAL);
    svg_label(s, spline_point(c, from_ratio_q(3, 2)), SVG_NW, SVG_CURVE, "r(3/2)");
    svg_legend_line(s, SVG_CURVE, "curve");
    svg_legend_line(s, SVG_POLYGON, "polygon");
    svg_legend_line(s, SVG_RIGHT, "with knots inserted");
    return s;
}

/* Marks the parameters of the first interval where det(P, P', P'') changes its sign. */
static void mark_inflections(svg *s, spline c)
{
    num_q H[3 * MOST_POINTS], b[3 * MOST_POINTS];
    rational_homogenize_q(c.n - 1, 2, c.R, c.w, H);
    bspline_to_bezier_q(on_span_q(c.p, 3, c.u, c.p, H), b);
    poly P[3][3], sum = poly_constant(from_int_q(0));
    for (int k = 0; k < 3; k++) {
        num_q one[MOST_POINTS];
        for (int i = 0; i <= c.p; i++)
            one[i] = b[3 * i + k];
        P[0][k] = poly_from_bernstein(c.p, one);
        P[1][k] = poly_derivative(P[0][k]);
        P[2][k] = poly_derivative(P[1][k]);
    }
    for (int k = 0; k < 3; k++) {
        int i = (k + 1) % 3, j = (k + 2) % 3;
        sum = poly_add(sum, poly_mul(P[0][k], poly_sub(poly_mul(P[1][i], P[2][j]), poly_mul(P[1][j], P[2][i]))));
    }
    struct cagd_root found[16];
    num_q length = sub_q(c.u[c.p + 1], c.u[c.p]);
    int roots = isolate_roots(sum, from_int_q(0), from_int_q(1), found, 16);
    for (int k = 0; k < roots; k++) {
        num_q local = refine_root(found[k], from_ratio_q(1, 4096)).lo;
        svg_mark(s, spline_point(c, add_q(c.u[c.p], mul_q(length, local))), SVG_WRONG, SVG_USUAL);
    }
}

FIGURE(mixed_weights_and_convexity)
{
    svg *s = svg_new(
        "mixed_weights_and_convexity", "Weights of both signs",
        "Left: a square with weights 4, -1, 4, 4 and the knot 1/2 inserted; two new vertices are beside their "
        "edges, and the new polygon is not convex. Right: a convex polygon of five points with weights 8, -1, 8, "
        "8, 8 and its cubic spline with inflections.");
    static const enum svg_direction side[] = {SVG_S, SVG_E, SVG_E, SVG_W};
    static const enum svg_direction around[] = {SVG_S, SVG_SE, SVG_E, SVG_N, SVG_W};
    const char *beside = "mixed_weights_cut_beside_the_edges";
    spline c = spline_of_claim(beside, 4, 3), cut = with_knot(c, number_of_claim(beside, "τ"));
    svg_panel(s, scaled_window(-3, -2, 7, 7, 4), 280, 0,
              "weights $4, -1, 4, 4$, knot $1/2$:\n$s_2 = -1/3$ and $s_3 = 4/3$");
    svg_heading(s, SVG_WRONG, "vertices beside the edges");
    draw_polygon(s, c, "r", side, SVG_POLYGON);
    svg_polyline(s, cut.n, cut.R, SVG_WRONG);
    draw_spline(s, c, SVG_CURVE);
    svg_mark(s, svg_pair(cut.R + 2), SVG_WRONG, SVG_USUAL);
    svg_mark(s, svg_pair(cut.R + 4), SVG_WRONG, SVG_USUAL);
    svg_label(s, svg_pair(cut.R + 2), SVG_N, SVG_WRONG, "r_2'");
    svg_label(s, svg_pair(cut.R + 4), SVG_N, SVG_WRONG, "r_3'");
    c = spline_of_claim("mixed_weights_bend_both_ways", 5, 3);
    svg_panel(s, svg_integer_window(-2, -1, 4, 5), 280, 0, "weights $8, -1, 8, 8, 8$:\nthe curve bends both ways");
    svg_heading(s, SVG_WRONG, "a curve that is not convex");
    draw_polygon(s, c, "r", around, SVG_POLYGON);
    draw_spline(s, c, SVG_CURVE);
    mark_inflections(s, c);
    svg_legend_line(s, SVG_CURVE, "curve");
    svg_legend_line(s, SVG_POLYGON, "polygon");
    svg_legend_line(s, SVG_WRONG, "with the knot");
    svg_legend_mark(s, SVG_WRONG, SVG_USUAL, "inflection; vertex off its edge");
    return s;
}

FIGURE(hulls_of_knot_sets)
{
    svg *s = svg_new("hulls_of_knot_sets", "Hulls decrease when knots are added",
                     "Left: the hulls of the polygons of the knots 1/4, then 1/4 and 3/4, then 1/4, 1/2 and 3/4, each "
                     "in the one before. "
                     "Right: the polygons of the knot 1/4 and of the knot 3/4; neither hull contains the other.");
    static const enum svg_direction side[] = {SVG_SW, SVG_SE, SVG_NW};
    const char *unrelated = "hulls_of_unrelated_knots_are_not_nested";
    num_q tau[2];
    data_of(unrelated, "τ", 2, 1, tau);
    spline c = spline_of_claim(unrelated, 3, 2), low = with_knot(c, tau[0]);
    spline high = with_knot(c, tau[1]), both = with_knot(low, tau[1]);
    spline three = with_knot(both, from_ratio_q(1, 2));
    svg_panel(s, svg_integer_window(-1, -1, 5, 5), 260, 0, "$\\{1/4\\}$, $\\{1/4, 3/4\\}$, $\\{1/4, 1/2, 3/4\\}$");
    svg_heading(s, SVG_RIGHT, "$T'_1 ⊆ T'_2 ⊆ T'_3$");
    svg_area(s, low.n, low.R, SVG_FILL);
    svg_area(s, both.n, both.R, SVG_FILL);
    svg_area(s, three.n, three.R, SVG_FILL);
    draw_polygon(s, c, "r", side, SVG_POLYGON);
    svg_polyline(s, low.n, low.R, SVG_RIGHT);
    svg_polyline(s, both.n, both.R, SVG_RIGHT);
    draw_polygon(s, three, NULL, NULL, SVG_RIGHT);
    draw_spline(s, c, SVG_CURVE);
    svg_panel(s, svg_integer_window(-1, -1, 5, 5), 260, 0,
              "$\\{1/4\\}$ and $\\{3/4\\}$: the vertex $(3,0)$\nis in one hull only");
    svg_heading(s, SVG_WRONG, "sets of knots without order");
    svg_area(s, low.n, low.R, SVG_FILL);
    draw_polygon(s, c, "r", side, SVG_POLYGON);
    draw_polygon(s, low, NULL, NULL, SVG_RIGHT);
    draw_polygon(s, high, NULL, NULL, SVG_WRONG);
    draw_spline(s, c, SVG_CURVE);
    svg_legend_line(s, SVG_CURVE, "curve");
    svg_legend_line(s, SVG_POLYGON, "polygon");
    svg_legend_line(s, SVG_RIGHT, "with knots inserted");
    svg_legend_line(s, SVG_WRONG, "with the knot $3/4$");
    return s;
}
