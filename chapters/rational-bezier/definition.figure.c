/* Figures of the section on the definition. */
#include "chapters/judge/figure.h"
#include "chapters/rational-bezier/conic-figures.h"
#include "figures/words.h"

static svg_point point_of(int n, const num_q R[], const num_q w[], num_q t)
{
    num_q P[2];
    rational_point_q(n, 2, R, w, t, P);
    return svg_pair(P);
}

/* The segment from the origin through P up to the height `top`. */
static void draw_ray(svg *s, const num_q P[2], num_q top)
{
    num_q scale = div_q(top, P[1]);
    svg_segment(s, svg_at(0, 0), (svg_point){mul_q(scale, P[0]), top}, SVG_MUTED);
}

FIGURE(homogeneous_line)
{
    svg *s = svg_new(
        "homogeneous_line", "A rational curve is the shadow of a polynomial one",
        "The homogeneous points (w x, w) of a rational quadratic on the line and the polynomial curve of these "
        "points in the plane; seen from the origin on the line w = 1, they are the points R_i and the rational curve.");
    num_q R[] = {q(-2), r(1, 2), q(2)}, w[] = {q(1), q(2), r(3, 2)}, H[6], P[2], t = r(2, 3);
    rational_homogenize_q(2, 1, R, w, H);
    svg_panel(s, (svg_window){r(-13, 4), q(0), r(15, 4), r(9, 4)}, 560, 0,
              "$H_i = (ω_i x_i, ω_i)$, $n = 2$, weights $1, 2, 3/2$; the line $ω = 1$ shows\n"
              "what an eye at the origin sees: $R_i = x_i$, and $R(t)$ on the ray of $H(t)$");
    svg_axes(s, q(1), q(1), "ωx", "ω");
    svg_line(s, svg_at(-1, 1), svg_at(1, 1), SVG_MUTED);
    for (int i = 0; i <= 2; i++)
        draw_ray(s, H + 2 * i, H[2 * i + 1]);
    bezier_casteljau_q(2, 2, H, t, P);
    draw_ray(s, P, P[1]);
    svg_polyline(s, 3, H, SVG_POLYGON);
    svg_segment(s, (svg_point){R[0], q(1)}, (svg_point){R[2], q(1)}, SVG_RIGHT);
    svg_bezier(s, 2, H, SVG_CURVE);
    static const char *const high[] = {"R_0 = H_0", "H_1", "H_2"}, *const low[] = {"", "R_1", "R_2"};
    static const enum svg_direction side[] = {SVG_NW, SVG_NW, SVG_NE};
    for (int i = 0; i <= 2; i++) {
        svg_mark(s, svg_pair(H + 2 * i), SVG_POLYGON, SVG_USUAL);
        svg_label(s, svg_pair(H + 2 * i), side[i], SVG_POLYGON, high[i]);
        svg_mark(s, (svg_point){R[i], q(1)}, SVG_RIGHT, SVG_USUAL);
        svg_label(s, (svg_point){R[i], q(1)}, SVG_SE, SVG_RIGHT, low[i]);
    }
    svg_mark(s, svg_pair(P), SVG_CURVE, SVG_USUAL);
    svg_label(s, svg_pair(P), SVG_SE, SVG_CURVE, "H(t)");
    svg_point foot = {div_q(P[0], P[1]), q(1)};
    svg_mark(s, foot, SVG_RIGHT, SVG_USUAL);
    svg_label(s, foot, SVG_SE, SVG_RIGHT, "R(t)");
    svg_legend_line(s, SVG_CURVE, "polynomial curve $H(t)$");
    svg_legend_line(s, SVG_RIGHT, "rational curve $R(t)$");
    return s;
}

/* The graph of sum w_i B_i^2 over [0,1]. */
static void draw_graph(svg *s, const num_q w[3], enum svg_role role)
{
    num_q b[] = {q(0), w[0], r(1, 2), w[1], q(1), w[2]};
    svg_bezier(s, 2, b, role);
}

FIGURE(weights_and_poles)
{
    svg *s =
        svg_new("weights_and_poles", "The denominator for weights 1, v, 1",
                "For v = 1/2 and v = -1/2 the denominator has no zero, for v = -2 it has two; the curve for v = -1/2 "
                "leaves the triangle, the one for v = -2 goes through infinity.");
    num_q R[] = {q(0), q(0), q(1), q(2), q(2), q(0)};
    num_q middle[] = {r(1, 2), r(-1, 2), q(-2)};
    static const enum svg_role role[] = {SVG_CURVE, SVG_CURVE_2, SVG_WRONG};
    svg_panel(s, (svg_window){q(0), r(-1, 2), q(1), r(5, 4)}, 260, 260, "the denominator $ω(t)$");
    svg_axes(s, r(1, 2), r(1, 2), "t", "ω");
    for (int k = 0; k < 3; k++) {
        num_q w[] = {q(1), middle[k], q(1)};
        draw_graph(s, w, role[k]);
    }
    svg_panel(s, svg_integer_window(-3, -3, 5, 6), 300, 0, "the curves over $0 ≤ t ≤ 1$");
    svg_area(s, 3, R, SVG_FILL);
    put_triangle(s, R, SVG_W, SVG_N, SVG_E);
    for (int k = 2; k >= 0; k--) {
        num_q w[] = {q(1), middle[k], q(1)};
        svg_rational(s, 2, R, w, role[k]);
    }
    svg_legend_line(s, SVG_CURVE, "weights $1, 1/2, 1$");
    svg_legend_line(s, SVG_CURVE_2, "$1, -1/2, 1$: no pole, but not in the hull");
    svg_legend_line(s, SVG_WRONG, "$1, -2, 1$: two poles");
    return s;
}

FIGURE(growing_weight)
{
    svg *s = svg_new(
        "growing_weight", "A growing weight draws every point straight to its vertex",
        "Cubics with the weight of R_1 equal to 1/4, 1, 4 and 16; the points of equal parameters lie on straight lines "
        "to R_1.  Where the denominator is negative the pull becomes a push.");
    num_q R[] = {q(0), q(0), q(1), q(4), q(5), q(3), q(6), q(0)};
    static const long quarters[] = {1, 4, 16, 64};
    svg_panel(s, svg_integer_window(-1, -1, 7, 5), 400, 0,
              "weights $1, ω_1, 1, 1$ with $ω_1 = 1/4, 1, 4, 16$;\nthe dotted lines belong to $t = 1/8, …, 7/8$");
    for (int j = 1; j <= 7; j++) {
        num_q first[] = {q(1), r(1, 4), q(1), q(1)};
        svg_segment(s, point_of(3, R, first, r(j, 8)), svg_pair(R + 2), SVG_MUTED);
    }
    svg_control_polygon(s, 3, R, "R");
    for (int k = 0; k < 4; k++) {
        num_q w[] = {q(1), r(quarters[k], 4), q(1), q(1)};
        svg_rational(s, 3, R, w, k == 1 ? SVG_CURVE : SVG_FAMILY);
        for (int j = 1; j <= 7; j++)
            svg_mark(s, point_of(3, R, w, r(j, 8)), k == 1 ? SVG_CURVE : SVG_FAMILY, SVG_USUAL);
    }
    svg_panel(s, (svg_window){r(-1, 4), q(-1), r(5, 4), q(1)}, 260, 300,
              "weights $-1, -1$, then $-1, -1/2$: $R(1/2)$ moves\nfrom $1/2$ to $1/3$, away from $R_1$");
    svg_heading(s, SVG_WRONG, "without positive weights");
    num_q line[] = {q(0), q(0), q(1), q(0)};
    svg_control_polygon(s, 1, line, "R");
    num_q before[] = {q(-1), q(-1)}, after[] = {q(-1), r(-1, 2)};
    svg_point a = point_of(1, line, before, r(1, 2)), b = point_of(1, line, after, r(1, 2));
    svg_mark(s, a, SVG_CURVE, SVG_USUAL);
    svg_mark(s, b, SVG_WRONG, SVG_USUAL);
    svg_label(s, a, SVG_N, SVG_CURVE, "1/2");
    svg_label(s, b, SVG_N, SVG_WRONG, "1/3");
    svg_point tail = {a.x, r(-1, 6)}, head = {b.x, r(-1, 6)};
    svg_arrow(s, tail, head, SVG_WRONG);
    svg_legend_line(s, SVG_CURVE, "$ω_1 = 1$");
    svg_legend_line(s, SVG_FAMILY, "other $ω_1$");
    svg_legend_line(s, SVG_MUTED, "equal parameters");
    return s;
}

FIGURE(affine_image)
{
    svg *s = svg_new("affine_image", "Affine maps belong to the points, not to the homogeneous points",
                     "Left, a cubic and its image under an affine map of its points, the weights kept.  Right, the "
                     "homogeneous points "
                     "of a segment moved by 1: the end of the curve moves from 1 to 3/2, not to 2.");
    num_q R[] = {q(0), q(0), q(1), q(3), q(3), q(3), q(4), q(1)}, Q[8];
    num_q w[] = {q(1), q(3), q(1), q(2)};
    for (int i = 0; i <= 3; i++) { /* (x, y) -> (x/2 - y + 9, x/2 + y/2 - 1) */
        Q[2 * i] = add_q(sub_q(mul_q(r(1, 2), R[2 * i]), R[2 * i + 1]), q(9));
        Q[2 * i + 1] = add_q(mul_q(r(1, 2), add_q(R[2 * i], R[2 * i + 1])), q(-1));
    }
    svg_panel(s, svg_integer_window(-1, -2, 10, 4), 420, 0,
              "$R'_i = f(R_i)$ for an affine map $f$, weights $1, 3, 1, 2$\nfor both; marked: $t = 1/4, 1/2, 3/4$");
    svg_heading(s, SVG_RIGHT, "the map applied to the points");
    svg_control_polygon(s, 3, R, "R");
    svg_control_polygon(s, 3, Q, "R'");
    svg_rational(s, 3, R, w, SVG_CURVE);
    svg_rational(s, 3, Q, w, SVG_CURVE_2);
    for (int k = 1; k <= 3; k++) {
        svg_mark(s, point_of(3, R, w, r(k, 4)), SVG_CURVE, SVG_USUAL);
        svg_mark(s, point_of(3, Q, w, r(k, 4)), SVG_CURVE_2, SVG_USUAL);
    }
    num_q H[] = {q(0), q(1), q(2), q(2)}, moved[] = {q(1), q(1), q(3), q(2)};
    svg_panel(s, (svg_window){r(-1, 2), q(0), r(7, 2), r(5, 2)}, 320, 0,
              "$H_i = (0,1), (2,2)$ moved to $(1,1), (3,2)$: on the line $ω = 1$\nthe end $1$ goes to $3/2$; moved by "
              "$1$ it would be at $2$");
    svg_heading(s, SVG_WRONG, "applied to the homogeneous points");
    svg_axes(s, q(1), q(1), "ωx", "ω");
    svg_line(s, svg_at(0, 1), svg_at(1, 1), SVG_MUTED);
    draw_ray(s, H + 2, H[3]);
    draw_ray(s, moved + 2, moved[3]);
    svg_polyline(s, 2, H, SVG_CURVE);
    svg_polyline(s, 2, moved, SVG_WRONG);
    svg_label(s, svg_pair(H), SVG_NW, SVG_CURVE, "H_0");
    svg_label(s, svg_pair(H + 2), SVG_N, SVG_CURVE, "H_1");
    svg_mark(s, svg_pair(H), SVG_CURVE, SVG_USUAL);
    svg_mark(s, svg_pair(H + 2), SVG_CURVE, SVG_USUAL);
    svg_mark(s, svg_pair(moved), SVG_WRONG, SVG_USUAL);
    svg_mark(s, svg_pair(moved + 2), SVG_WRONG, SVG_USUAL);
    svg_mark(s, (svg_point){r(3, 2), q(1)}, SVG_WRONG, SVG_USUAL);
    svg_mark(s, svg_at(2, 1), SVG_RIGHT, SVG_USUAL);
    svg_label(s, (svg_point){r(3, 2), q(1)}, SVG_S, SVG_WRONG, "3/2");
    svg_label(s, svg_at(2, 1), SVG_SE, SVG_RIGHT, "2");
    svg_legend_line(s, SVG_CURVE, "before");
    svg_legend_line(s, SVG_CURVE_2, "the image of the curve, and the curve of the images");
    svg_legend_line(s, SVG_WRONG, "homogeneous points moved");
    return s;
}

FIGURE(reversed_polygon)
{
    svg *s = svg_new("reversed_polygon", "Reversed points need reversed weights",
                     "A cubic with weights 1, 5, 1, 1; points and weights reversed give the same curve, the points "
                     "alone another one.");
    num_q R[] = {q(0), q(0), q(1), q(4), q(5), q(4), q(6), q(0)}, Q[8], v[4];
    num_q w[] = {q(1), q(5), q(1), q(1)};
    for (int i = 0; i <= 3; i++) {
        Q[2 * i] = R[2 * (3 - i)];
        Q[2 * i + 1] = R[2 * (3 - i) + 1];
        v[i] = w[3 - i];
    }
    svg_panel(s, svg_integer_window(-1, -1, 7, 5), 340, 0,
              "$R_3, R_2, R_1, R_0$ with weights $1, 1, 5, 1$:\nthe same curve, at $t$ the point $R(1-t)$");
    svg_heading(s, SVG_RIGHT, "points and weights reversed");
    svg_control_polygon(s, 3, R, "R");
    svg_rational(s, 3, Q, v, SVG_CURVE);
    for (int k = 0; k <= 8; k++)
        svg_mark(s, point_of(3, Q, v, r(k, 8)), SVG_CURVE, SVG_USUAL);
    svg_panel(s, svg_integer_window(-1, -1, 7, 5), 340, 0,
              "$R_3, R_2, R_1, R_0$ with weights $1, 5, 1, 1$:\nnow the weight $5$ pulls to $R_2$");
    svg_heading(s, SVG_WRONG, "points alone reversed");
    svg_control_polygon(s, 3, R, "R");
    svg_rational(s, 3, R, w, SVG_CURVE);
    svg_rational(s, 3, Q, w, SVG_WRONG);
    svg_legend_line(s, SVG_CURVE, "weights $1, 5, 1, 1$ of $R_0, …, R_3$; marked: $t = 0, 1/8, …, 1$");
    svg_legend_line(s, SVG_WRONG, "weights $1, 1, 5, 1$ of $R_0, …, R_3$");
    return s;
}
