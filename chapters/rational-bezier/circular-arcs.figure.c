/* circular-arcs.figure.c -- drawings for circular-arcs.claims.h. */
#include "chapters/judge/figure_data.h"
#include "chapters/rational-bezier/conic-figures.h"

/* The data of two claims: the other arc of a circle, and an ellipse in the place of a circle. */
static const char other_arc[] = "negative_weight_gives_the_other_arc",
                  ellipse[] = "isosceles_triangle_with_another_angle";

/* An angle at the point, by an arc of that radius from the direction of parameter a to that of b, of
 * ((1 - t²)/(1 + t²), 2t/(1 + t²)) turned by a quarter where it is upright. */
static void put_angle(svg *s, svg_point corner, num_q radius, num_q a, num_q b, int upright)
{
    enum { PARTS = 12 };
    num_q P[2 * (PARTS + 1)];
    for (int k = 0; k <= PARTS; k++) {
        num_q t = add_q(a, mul_q(r(k, PARTS), sub_q(b, a))), whole = add_q(q(1), mul_q(t, t));
        num_q along = div_q(mul_q(radius, sub_q(q(1), mul_q(t, t))), whole),
              across = div_q(mul_q(radius, mul_q(q(2), t)), whole);
        P[2 * k] = add_q(corner.x, upright ? across : along);
        P[2 * k + 1] = add_q(corner.y, upright ? along : across);
    }
    svg_polyline(s, PARTS + 1, P, SVG_POINT);
}

FIGURE(circular_arc)
{
    svg *s =
        svg_new("circular_arc", "A circular arc and its complement",
                "The triangle (-1, 0), (0, 4/3), (1, 0) has a base angle θ with cos θ = 3/5.  With the weights 1, 3/5, "
                "1 the curve is the arc of central angle 2θ and radius 5/4 about (0, -3/4); with 1, -3/5, 1 it is the "
                "rest of the circle.");
    num_q R[6], w[3], other[3], C[2];
    data_of(other_arc, "R", 3, 2, R);
    data_of(other_arc, "ω", 3, 1, other);
    data_of(ellipse, "ω", 3, 1, w);
    svg_window window = {r(-8, 5), r(-21, 10), r(8, 5), r(8, 5)};
    circular_arc_circle_q(R, C);
    svg_panel(s, window, 400, 0, "$l=1$, $\\c\\o\\s θ=3/5$, $r=l \\c\\s\\c θ=5/4$");
    put_triangle(s, R, SVG_W, SVG_N, SVG_E);
    svg_segment(s, svg_pair(R), svg_pair(R + 4), SVG_MUTED);
    svg_segment(s, svg_pair(C), svg_pair(R), SVG_MUTED);
    svg_segment(s, svg_pair(C), svg_pair(R + 4), SVG_MUTED);
    svg_rational(s, 2, R, other, SVG_WRONG);
    svg_rational(s, 2, R, w, SVG_CURVE);
    svg_mark(s, svg_pair(C), SVG_POINT, SVG_USUAL);
    svg_label(s, svg_pair(C), SVG_S, SVG_POINT, "C");
    svg_mark(s, svg_at(0, 0), SVG_MUTED, SVG_USUAL);
    svg_label(s, (svg_point){r(1, 2), r(-3, 8)}, SVG_SE, SVG_POINT, "r");
    svg_label(s, (svg_point){r(1, 2), q(0)}, SVG_N, SVG_POINT, "l");
    /* tan θ/2 = 1/2, for cos θ = 3/5 */
    put_angle(s, svg_pair(R), r(1, 4), q(0), r(1, 2), 0);
    put_angle(s, svg_pair(C), r(1, 4), r(-1, 2), r(1, 2), 1);
    svg_label(s, (svg_point){r(-3, 4), r(1, 20)}, SVG_E, SVG_POINT, "θ");
    svg_label(s, (svg_point){q(0), r(-1, 2)}, SVG_N, SVG_POINT, "2θ");
    svg_legend_line(s, SVG_CURVE, "weights 1, 3/5, 1: the arc of angle $2θ$");
    svg_legend_line(s, SVG_WRONG, "weights 1, $-3/5$, 1: the arc of angle $2π-2θ$");
    return s;
}

FIGURE(circular_arc_extra)
{
    svg *s = svg_new(
        "circular_arc_extra", "Three equations that do not make a circle",
        "Both triangles are isosceles with the base 2 and both curves have the weights 1, 3/5, 1.  The left one, "
        "with the vertex (0, 1), is an arc of an ellipse and leaves the circle that the theorem claims; the "
        "right one, whose base angle has the cosine 3/5, is that circle's arc.");
    num_q w[3], good[6], bad[6], C[2], radius = r(5, 4);
    data_of(other_arc, "R", 3, 2, good);
    data_of(ellipse, "R", 3, 2, bad);
    data_of(ellipse, "ω", 3, 1, w);
    circular_arc_circle_q(good, C);
    svg_window window = {r(-3, 2), r(-2, 5), r(3, 2), r(8, 5)};
    for (int k = 0; k < 2; k++) {
        const num_q *R = k == 0 ? bad : good;
        svg_panel(s, window, 330, 0,
                  k == 0 ? "$R_1=(0,1)$: base angle 45°, $\\c\\o\\s^2 θ=I_1=9/25$"
                         : "$R_1=(0,4/3)$: base angle $θ$, $\\c\\o\\s^2 θ=I_1=9/25$");
        svg_heading(s, k == 0 ? SVG_WRONG : SVG_RIGHT, k == 0 ? "an ellipse" : "a circle");
        svg_frame(s);
        svg_circle(s, svg_pair(C), radius, k == 0 ? SVG_WRONG : SVG_MUTED);
        put_triangle(s, R, SVG_W, SVG_N, SVG_E);
        svg_rational(s, 2, R, w, SVG_CURVE);
    }
    svg_legend_line(s, SVG_CURVE, "weights 1, 3/5, 1");
    svg_legend_line(s, SVG_WRONG, "the circle of radius $l \\c\\s\\c θ=5/4$ that is claimed");
    return s;
}
