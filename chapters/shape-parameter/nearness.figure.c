/* nearness.figure.c -- drawings for nearness.claims.h. */
#include "chapters/shape-parameter/drawing.h"
#include "exact/record/number.h"

/* The point of the curve, among those of t = m/64, that is farthest from the polygon, with the nearest point of it. */
static void put_largest_distance(svg *s, int n, const num_q P[], num_q beta, enum svg_role paint)
{
    num_q worst = q(-1), from[2] = {q(0), q(0)}, to[2] = {q(0), q(0)};
    for (int m = 1; m < 64; m++) {
        num_q X[2], best = q(-1), foot[2] = {q(0), q(0)};
        shape_point_q(n, 2, P, beta, r(m, 64), X);
        for (int i = 0; i < n; i++) {
            const num_q *A = P + 2 * i;
            num_q d[2] = {sub_q(A[2], A[0]), sub_q(A[3], A[1])}, w[2] = {sub_q(X[0], A[0]), sub_q(X[1], A[1])};
            num_q size = norm_squared_q(2, d), u = is_zero_q(size) ? q(0) : div_q(dot_q(2, d, w), size);
            u = sign_q(u) < 0 ? q(0) : compare_q(u, q(1)) > 0 ? q(1) : u;
            num_q F[2] = {add_q(A[0], mul_q(u, d[0])), add_q(A[1], mul_q(u, d[1]))};
            num_q gap[2] = {sub_q(X[0], F[0]), sub_q(X[1], F[1])}, value = norm_squared_q(2, gap);
            if (i == 0 || compare_q(value, best) < 0)
                best = value, foot[0] = F[0], foot[1] = F[1];
        }
        if (compare_q(best, worst) > 0)
            worst = best, from[0] = X[0], from[1] = X[1], to[0] = foot[0], to[1] = foot[1];
    }
    svg_segment(s, svg_pair(from), svg_pair(to), SVG_POINT);
    svg_mark(s, svg_pair(from), paint, SVG_USUAL);
}

FIGURE(closer_or_not)
{
    svg *s = svg_new(
        "closer_or_not", "A larger beta can take the curve away from its polygon",
        "Left a convex polygon of eight points with the curves of β = -21/4 and β = 1: the largest distance of "
        "the curve from the polygon, drawn as a segment, grows from less than 2 to more than 2.  Right a convex "
        "polygon of four points with the cubic case for β = 0 and β = 1: it grows too.");
    num_q P[16];
    data_of("larger_beta_is_worse_for_a_convex_polygon", "P", 8, 2, P);
    svg_panel(s, window(q(-5), q(-4), q(5), q(5)), 360, 0, "$n=7$, $β=-21/4$ and $β=1$");
    static const enum svg_direction of_seven[] = {SVG_SW, SVG_SE, SVG_E, SVG_E, SVG_NW, SVG_W, SVG_SW, SVG_E};
    svg_control_polygon_towards(s, 7, P, "P", of_seven);
    put_curve(s, 0, 7, P, r(-21, 4), SVG_CURVE_2);
    put_curve(s, 0, 7, P, q(1), SVG_CURVE);
    put_largest_distance(s, 7, P, r(-21, 4), SVG_CURVE_2);
    put_largest_distance(s, 7, P, q(1), SVG_CURVE);
    data_of("convex_cubic_of_larger_beta_is_farther", "P", 4, 2, P);
    svg_panel(s, window(r(-3, 2), q(-5), q(3), q(5)), 180, 0, "$n=3$, $β=0$ and $β=1$");
    static const enum svg_direction of_three[] = {SVG_N, SVG_SW, SVG_S, SVG_E};
    svg_control_polygon_towards(s, 3, P, "P", of_three);
    put_curve(s, 0, 3, P, q(0), SVG_CURVE_2);
    put_curve(s, 0, 3, P, q(1), SVG_CURVE);
    put_largest_distance(s, 3, P, q(0), SVG_CURVE_2);
    put_largest_distance(s, 3, P, q(1), SVG_CURVE);
    svg_legend_line(s, SVG_CURVE, "the larger $β$");
    svg_legend_line(s, SVG_CURVE_2, "the smaller $β$");
    svg_legend_line(s, SVG_POINT, "the largest distance from the polygon");
    return s;
}
