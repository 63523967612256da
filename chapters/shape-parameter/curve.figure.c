/* curve.figure.c -- drawings for curve.claims.h. */
#include "chapters/shape-parameter/drawing.h"

/* The nine values of the figures of the source; those outside the true range as wrong. */
static void nine_curves(svg *s, const num_q P[])
{
    for (int beta = -7; beta <= 1; beta++)
        put_curve(s, 0, 7, P, q(beta), beta < -5 ? SVG_WRONG : beta == 0 ? SVG_CURVE_2 : SVG_FAMILY);
    put_curve(s, 0, 7, P, q(1), SVG_CURVE);
    svg_legend_line(s, SVG_CURVE, "$β=1$");
    svg_legend_line(s, SVG_CURVE_2, "$β=0$, the Bézier curve");
    svg_legend_line(s, SVG_FAMILY, "$β=-1,...,-5$");
    svg_legend_line(s, SVG_WRONG, "$β=-6,-7$, outside the true range");
}

FIGURE(curves_for_several_beta)
{
    svg *s = svg_new(
        "curves_for_several_beta", "The curves of several beta for one polygon",
        "One polygon of eight points and the nine curves of β = 1, 0, -1, ..., -7.  For fixed t the nine points "
        "stand on a straight segment in equal distances; three such segments are drawn.");
    static const int from[] = {0, 0, 0, 5, 3, 8, 6, 8, 9, 8, 12, 8, 15, 5, 15, 0};
    num_q P[16], ends[4];
    points(8, from, P);
    svg_panel(s, window(q(-1), q(-1), q(16), q(9)), 500, 0, NULL);
    svg_control_polygon(s, 7, P, "P");
    nine_curves(s, P);
    for (int k = 1; k <= 3; k++) {
        shape_point_q(7, 2, P, q(-7), r(k, 4), ends);
        shape_point_q(7, 2, P, q(1), r(k, 4), ends + 2);
        svg_segment(s, svg_pair(ends), svg_pair(ends + 2), SVG_POINT);
    }
    svg_legend_line(s, SVG_POINT, "the points of $t=1/4,1/2,3/4$");
    return s;
}

FIGURE(petals)
{
    svg *s =
        svg_new("petals", "Closed curves of several beta",
                "A polygon whose first and last point coincide, and the nine closed curves of β = 1, 0, -1, ..., -7.");
    static const int from[] = {0, 0, -6, 3, -6, 9, -1, 12, 1, 12, 6, 9, 6, 3, 0, 0};
    num_q P[16];
    points(8, from, P);
    svg_panel(s, window(q(-8), q(-1), q(8), q(13)), 380, 0, NULL);
    svg_polyline(s, 8, P, SVG_POLYGON);
    nine_curves(s, P);
    return s;
}

FIGURE(end_edges)
{
    svg *s =
        svg_new("end_edges", "The tangent at the end of the curve",
                "The beginning of the curves of β = 1, -5 and -7.  The first two leave P₀ along the edge to P₁; the "
                "curve of β = -7 leaves it towards (5P₁ - P₂)/4, below the edge.");
    static const int from[] = {0, 0, 1, 0, 2, 2, 3, 3, 4, 3, 5, 2, 6, 0, 7, 0};
    num_q P[16];
    points(8, from, P);
    svg_panel(s, window(r(-1, 10), r(-1, 5), r(3, 2), r(4, 5)), 440, 0, NULL);
    svg_polyline(s, 8, P, SVG_POLYGON);
    put_curve(s, 0, 7, P, q(1), SVG_CURVE);
    put_curve(s, 0, 7, P, q(-5), SVG_CURVE_2);
    put_curve(s, 0, 7, P, q(-7), SVG_WRONG);
    svg_point towards = at(r(3, 4), r(-1, 2));
    svg_segment(s, svg_at(0, 0), towards, SVG_MUTED);
    svg_mark(s, svg_at(0, 0), SVG_POLYGON, SVG_USUAL);
    svg_label(s, svg_at(0, 0), SVG_NW, SVG_POLYGON, "P_0");
    svg_mark(s, svg_at(1, 0), SVG_POLYGON, SVG_USUAL);
    svg_label(s, svg_at(1, 0), SVG_SE, SVG_POLYGON, "P_1");
    svg_frame(s);
    svg_legend_line(s, SVG_CURVE, "$β=1$");
    svg_legend_line(s, SVG_CURVE_2, "$β=-5$");
    svg_legend_line(s, SVG_WRONG, "$β=-7$");
    svg_legend_line(s, SVG_MUTED, "from $P_0$ towards $(5P_1-P_2)/4$");
    return s;
}

FIGURE(hull_and_sum)
{
    svg *s =
        svg_new("hull_and_sum", "The printed curve depends on the place of the origin",
                "Left a polygon near the origin with the printed and the corrected curve of β = 1, nearly the same.  "
                "Right the polygon moved up by 100: the corrected curve has moved with it, the printed one falls out "
                "of the convex hull.");
    static const int from[] = {0, 0, 1, 4, 2, 5, 3, 5, 4, 5, 5, 5, 6, 4, 7, 0};
    for (int far = 0; far <= 1; far++) {
        num_q P[16], up = q(100 * far);
        points(8, from, P);
        for (int i = 0; i <= 7; i++)
            P[2 * i + 1] = add_q(P[2 * i + 1], up);
        svg_panel(s, window(r(-1, 2), sub_q(up, r(1, 2)), r(15, 2), add_q(up, r(11, 2))), 340, 0,
                  far ? "the points $P_i+(0,100)$" : "the points $P_i$");
        svg_area(s, 8, P, SVG_FILL);
        svg_polyline(s, 8, P, SVG_POLYGON);
        put_curve(s, 1, 7, P, q(1), SVG_WRONG);
        put_curve(s, 0, 7, P, q(1), SVG_RIGHT);
        svg_frame(s);
    }
    svg_legend_line(s, SVG_WRONG, "the printed curve, $β=1$");
    svg_legend_line(s, SVG_RIGHT, "the corrected curve, $β=1$");
    svg_legend_area(s, SVG_FILL, "convex hull");
    return s;
}

/* The point of the curve, among those of t = m/64, that is farthest from the polygon, with the nearest point of it. */
static void put_largest_distance(svg *s, int n, const num_q P[], num_q beta, enum svg_role role)
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
    svg_mark(s, svg_pair(from), role, SVG_USUAL);
}

FIGURE(closer_or_not)
{
    svg *s = svg_new(
        "closer_or_not", "A larger beta can take the curve away from its polygon",
        "Left a convex polygon of eight points with the curves of β = -21/4 and β = 1: the largest distance of "
        "the curve from the polygon, drawn as a segment, grows from less than 2 to more than 2.  Right a convex "
        "polygon of four points with the cubic case for β = 0 and β = 1: it grows too.");
    static const int seven[] = {-1, -2, 2, 0, 3, 1, 4, 3, -2, 4, -4, -2, -4, -3, -3, -3};
    static const int three[] = {2, 4, -1, -4, 1, -4, 2, 3};
    num_q P[16];
    points(8, seven, P);
    svg_panel(s, window(q(-5), q(-4), q(5), q(5)), 360, 0, "$n=7$, $β=-21/4$ and $β=1$");
    svg_control_polygon(s, 7, P, "P");
    put_curve(s, 0, 7, P, r(-21, 4), SVG_CURVE_2);
    put_curve(s, 0, 7, P, q(1), SVG_CURVE);
    put_largest_distance(s, 7, P, r(-21, 4), SVG_CURVE_2);
    put_largest_distance(s, 7, P, q(1), SVG_CURVE);
    points(4, three, P);
    svg_panel(s, window(r(-3, 2), q(-5), q(3), q(5)), 180, 0, "$n=3$, $β=0$ and $β=1$");
    svg_control_polygon(s, 3, P, "P");
    put_curve(s, 0, 3, P, q(0), SVG_CURVE_2);
    put_curve(s, 0, 3, P, q(1), SVG_CURVE);
    put_largest_distance(s, 3, P, q(0), SVG_CURVE_2);
    put_largest_distance(s, 3, P, q(1), SVG_CURVE);
    svg_legend_line(s, SVG_CURVE, "the larger $β$");
    svg_legend_line(s, SVG_CURVE_2, "the smaller $β$");
    svg_legend_line(s, SVG_POINT, "the largest distance from the polygon");
    return s;
}

/* The picture of a point of space: the shear that takes z = xy to z = (x - 7/2)(y - 7/2), seen from the side. */
static void project(const num_q X[], num_q out[])
{
    num_q x = sub_q(X[0], r(7, 2)), y = sub_q(X[1], r(7, 2));
    num_q height = sub_q(sub_q(X[2], mul_q(r(7, 2), add_q(X[0], X[1]))), r(-49, 4));
    out[0] = sub_q(x, mul_q(r(4, 5), y));
    out[1] = add_q(div_q(add_q(x, y), q(4)), div_q(height, q(6)));
}

FIGURE(shape_surface)
{
    svg *s =
        svg_new("shape_surface", "A net of straight rows and columns and its saddle",
                "The points (i, j, ij), i and j from 0 to 7, in parallel projection: rows and columns of the net are "
                "straight.  The surface of β = -5, drawn by its parameter lines, lies on the saddle z = xy.");
    num_q P[8 * 8 * 3], line[2 * 8], X[3];
    for (int i = 0; i <= 7; i++)
        for (int j = 0; j <= 7; j++) {
            P[(i * 8 + j) * 3] = q(i);
            P[(i * 8 + j) * 3 + 1] = q(j);
            P[(i * 8 + j) * 3 + 2] = q(i * j);
        }
    for (int surface = 0; surface <= 1; surface++) {
        svg_panel(s, window(q(-7), r(-5, 2), q(7), q(4)), 330, 0,
                  surface ? "the parameter lines of $β=-5$" : "the net");
        for (int direction = 0; direction < 2; direction++)
            for (int i = 0; i <= 7; i++) {
                for (int j = 0; j <= 7; j++) {
                    int row = direction ? j : i, column = direction ? i : j;
                    if (surface)
                        shape_surface_point_q(7, 7, 3, P, q(-5), q(-5), r(row, 7), r(column, 7), X);
                    project(surface ? X : P + (row * 8 + column) * 3, line + 2 * j);
                }
                svg_polyline(s, 8, line, i % 7 == 0 ? SVG_CURVE : SVG_FAMILY);
            }
    }
    return s;
}
