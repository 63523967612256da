/* Figures of the section on the convexity of NURBS curves. */
#include "chapters/nurbs/spline-figures.h"
#include "exact/record/roots.h"

static svg_window scaled_window(long x0, long y0, long x1, long y1, long scale)
{
    return (svg_window){from_ratio_q(x0, scale), from_ratio_q(y0, scale), from_ratio_q(x1, scale),
                        from_ratio_q(y1, scale)};
}

static const int two_intervals[] = {0, 0, 0, 2, 4, 4, 4}, three_intervals[] = {0, 0, 0, 2, 4, 6, 6, 6},
                 one_interval[] = {0, 0, 0, 0, 2, 2, 2, 2};

FIGURE(what_convex_must_mean)
{
    svg *s =
        svg_new("what_convex_must_mean", "When the polygon of a NURBS curve is convex",
                "Left: a polygon that goes from the origin to (1,0), back to the origin and up; as a set it is two "
                "sides of a triangle, but its curve is not convex. Middle: a polygon that runs round a triangle "
                "and over its first side again; with one corner cut it is not convex. Right: a "
                "polygon that runs through the boundary of a convex set once, and its convex curve.");
    static const int back[] = {0, 0, 1, 0, 0, 0, 0, 1}, over[] = {0, 0, 2, 0, 0, 2, 0, 0, 2, 0},
                     once[] = {0, 0, 4, 0, 4, 3, 1, 4};
    static const enum svg_direction back_side[] = {SVG_SW, SVG_E, SVG_HERE, SVG_N};
    static const enum svg_direction over_side[] = {SVG_SW, SVG_E, SVG_N, SVG_HERE, SVG_HERE};
    static const enum svg_direction once_side[] = {SVG_SW, SVG_SE, SVG_NE, SVG_N};
    spline c = spline_of(4, 2, two_intervals, 2, back, 1, NULL), cut = with_knot(c, from_ratio_q(3, 2));
    svg_panel(s, scaled_window(-1, -1, 6, 6, 5), 230, 0,
              "$r_1 = r_3$: there and back;\n$r(3/2)$ is inside the hull of the curve");
    svg_heading(s, SVG_WRONG, "a set: turning back");
    num_q triangle[6];
    const num_q where[] = {from_int_q(0), from_ratio_q(2, 3), from_int_q(2)};
    for (int i = 0; i < 3; i++) {
        svg_point P = spline_point(c, where[i]);
        triangle[2 * i] = P.x;
        triangle[2 * i + 1] = P.y;
    }
    svg_area(s, 3, triangle, SVG_FILL);
    draw_polygon(s, c, "r", back_side, SVG_POLYGON);
    svg_polyline(s, cut.n, cut.R, SVG_CURVE_2);
    draw_spline(s, c, SVG_CURVE);
    svg_mark(s, spline_point(c, from_ratio_q(3, 2)), SVG_WRONG, SVG_USUAL);
    svg_label(s, spline_point(c, from_ratio_q(3, 2)), SVG_NE, SVG_WRONG, "r(3/2)");

    c = spline_of(5, 2, three_intervals, 2, over, 1, NULL);
    cut = with_knot(c, from_ratio_q(1, 2));
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
    bspline_to_bezier_q(c.p, 3, c.u, c.p, H, b);
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
    static const int square[] = {0, 0, 1, 0, 1, 1, 0, 1}, weight[] = {4, -1, 4, 4};
    static const int point[] = {0, 0, 2, 0, 3, 2, 1, 4, 0, 3}, mixed[] = {8, -1, 8, 8, 8};
    static const int knot[] = {0, 0, 0, 0, 2, 4, 4, 4, 4};
    static const enum svg_direction side[] = {SVG_S, SVG_E, SVG_E, SVG_W};
    static const enum svg_direction around[] = {SVG_S, SVG_SE, SVG_E, SVG_N, SVG_W};
    spline c = spline_of(4, 3, one_interval, 2, square, 1, weight), cut = with_knot(c, from_ratio_q(1, 2));
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
    c = spline_of(5, 3, knot, 2, point, 1, mixed);
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

FIGURE(convex_polygon_convex_spline)
{
    svg *s = svg_new("convex_polygon_convex_spline", "A convex polygon has a convex NURBS curve",
                     "Left: a convex polygon, polygons with knots inserted in the middle of all intervals once and "
                     "twice, and the curve. Middle: a convex polygon of five points, closed, and its periodic cubic "
                     "curve. Right: with a knot of multiplicity two the curve of order two is two "
                     "opposite sides of a square, and not continuous.");
    static const int point[] = {0, 2, 1, 0, 5, 0, 7, 2, 6, 5, 3, 6}, weight[] = {1, 1, 4, 1, 3, 1};
    static const int knot[] = {0, 1, 2, 4, 6, 8, 10, 11, 12, 13};
    static const enum svg_direction side[] = {SVG_W, SVG_SW, SVG_SE, SVG_E, SVG_NE, SVG_NW};
    spline c = spline_of(6, 3, knot, 2, point, 1, weight), first = c, second;
    for (long i = 5; i <= 7; i += 2)
        first = with_knot(first, from_ratio_q(i, 2));
    second = first;
    for (long i = 9; i <= 15; i += 2)
        second = with_knot(second, from_ratio_q(i, 4));
    svg_panel(s, svg_integer_window(-1, -1, 8, 7), 380, 0,
              "corners cut and cut again; the ends of the domain\nare simple knots");
    svg_heading(s, SVG_RIGHT, "convex polygon, convex curve");
    draw_polygon(s, c, "r", side, SVG_POLYGON);
    svg_polyline(s, second.n, second.R, SVG_CURVE_2);
    svg_polyline(s, first.n, first.R, SVG_RIGHT);
    draw_spline(s, c, SVG_CURVE);
    static const int ring[] = {0, 0, 4, 0, 5, 3, 2, 5, 0, 1, 0, 0, 4, 0, 5, 3};
    static const int ring_knot[] = {-6, -4, -2, 0, 2, 4, 6, 8, 10, 12, 14, 16};
    static const enum svg_direction around[] = {SVG_SW, SVG_SE, SVG_E, SVG_N, SVG_W, SVG_HERE, SVG_HERE, SVG_HERE};
    c = spline_of(8, 3, ring_knot, 2, ring, 1, NULL);
    svg_panel(s, svg_integer_window(-1, -1, 6, 6), 230, 0, "$r_6, r_7, r_8 = r_1, r_2, r_3$:\na periodic cubic");
    svg_heading(s, SVG_RIGHT, "a closed convex polygon");
    draw_polygon(s, c, "r", around, SVG_POLYGON);
    draw_spline(s, c, SVG_CURVE);
    static const int square[] = {0, 0, 1, 0, 1, 1, 0, 1}, torn[] = {0, 0, 2, 2, 4, 4};
    static const enum svg_direction corner[] = {SVG_SW, SVG_SE, SVG_NE, SVG_NW};
    svg_panel(s, scaled_window(-1, -1, 3, 3, 2), 210, 0,
              "$k = 2$, knots $0, 0, 1, 1, 2, 2$:\nthe curve jumps at $t = 1$");
    svg_heading(s, SVG_WRONG, "a $k$-fold knot");
    c = spline_of(4, 1, torn, 2, square, 1, NULL);
    draw_polygon(s, c, "r", corner, SVG_POLYGON);
    draw_spline(s, c, SVG_CURVE);
    svg_legend_line(s, SVG_CURVE, "curve");
    svg_legend_line(s, SVG_POLYGON, "polygon");
    svg_legend_line(s, SVG_RIGHT, "knots inserted once");
    svg_legend_line(s, SVG_CURVE_2, "and again");
    return s;
}

FIGURE(hulls_of_knot_sets)
{
    svg *s = svg_new("hulls_of_knot_sets", "Hulls decrease when knots are added",
                     "Left: the hulls of the polygons of the knots 1/4, then 1/4 and 3/4, then 1/4, 1/2 and 3/4, each "
                     "in the one before. "
                     "Right: the polygons of the knot 1/4 and of the knot 3/4; neither hull contains the other.");
    static const int point[] = {0, 0, 4, 0, 0, 4}, knot[] = {0, 0, 0, 2, 2, 2};
    static const enum svg_direction side[] = {SVG_SW, SVG_SE, SVG_NW};
    spline c = spline_of(3, 2, knot, 2, point, 1, NULL), low = with_knot(c, from_ratio_q(1, 4));
    spline high = with_knot(c, from_ratio_q(3, 4)), both = with_knot(low, from_ratio_q(3, 4));
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
    for (long h = 1; h <= 64; h *= 2) {
        num_q R[] = {from_int_q(0), from_int_q(0),      from_int_q(1), from_int_q(0),
                     from_int_q(1), from_ratio_q(1, h), from_int_q(0), from_ratio_q(1, h)};
        svg_polyline(s, 4, R, h == 1 ? SVG_POLYGON : SVG_FAMILY);
    }
    svg_segment(s, svg_at(0, 0), svg_at(1, 0), SVG_WRONG);

    static const int dent[] = {0, 0, 3, 0, 1, 1, 0, 3}, square_knot[] = {0, 0, 2, 4, 6, 6};
    static const enum svg_direction dent_side[] = {SVG_S, SVG_SE, SVG_NE, SVG_NW};
    spline c = spline_of(4, 1, square_knot, 2, dent, 1, NULL);
    num_q triangle[] = {from_int_q(0), from_int_q(0), from_int_q(3), from_int_q(0), from_int_q(0), from_int_q(3)};
    svg_panel(s, svg_integer_window(-1, -1, 4, 4), 170, 0, "$r_3$ is inside every\nconvex set about them");
    svg_heading(s, SVG_WRONG, "not convex");
    svg_area(s, 3, triangle, SVG_FILL);
    draw_polygon(s, c, "r", dent_side, SVG_POLYGON);
    svg_mark(s, svg_at(1, 1), SVG_WRONG, SVG_USUAL);

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

    static const int base[] = {0, 0, 1, 0, 2, 2}, mixed[] = {2, -1, 2}, bezier[] = {0, 0, 0, 2, 2, 2};
    static const enum svg_direction base_side[] = {SVG_S, SVG_S, SVG_E};
    c = spline_of(3, 2, bezier, 2, base, 1, mixed);
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
