/* conic-classification.figure.c -- drawings for conic-classification.claims.h. */
#include "chapters/rational-bezier/conic-figures.h"

FIGURE(classification_by_weight)
{
    svg *s = svg_new("classification_by_weight", "Ellipse, parabola, hyperbola",
                     "One triangle with three weights.  For ω = 1/3 the arc belongs to an ellipse, for ω = 1 to a "
                     "parabola, for ω = 3 to a hyperbola, whose other branch is on the far side of the vertex.");
    num_q R[6] = {q(-2), q(0), r(1, 2), q(3), q(2), q(0)}, shoulder[2];
    static const struct {
        int m, n;
        const char *heading, *caption;
    } kind[] = {{1, 3, "ellipse", "$ω=1/3$, $I_1=1/9$"},
                {1, 1, "parabola", "$ω=1$, $I_1=1$"},
                {3, 1, "hyperbola", "$ω=3$, $I_1=9$"}};
    for (int k = 0; k < 3; k++) {
        num_q w[3] = {q(1), r(kind[k].m, kind[k].n), q(1)}, other[3] = {q(1), r(-kind[k].m, kind[k].n), q(1)};
        svg_panel(s, svg_integer_window(-4, -3, 4, 6), 240, 0, kind[k].caption);
        svg_heading(s, SVG_POINT, kind[k].heading);
        svg_frame(s);
        svg_area(s, 3, R, SVG_FILL);
        svg_rational(s, 2, R, other, SVG_FAMILY);
        put_triangle(s, R, SVG_NW, SVG_N, SVG_NE);
        svg_rational(s, 2, R, w, SVG_CURVE);
        conic_shoulder_point_q(R, w, shoulder);
        svg_mark(s, svg_pair(shoulder), SVG_CURVE, SVG_USUAL);
    }
    svg_legend_line(s, SVG_CURVE, "weights $1,ω,1$");
    svg_legend_line(s, SVG_FAMILY, "weights $1,-ω,1$: the rest of the conic");
    svg_legend_mark(s, SVG_CURVE, SVG_USUAL, "the shoulder point");
    return s;
}

/* On the axis x = 0, for l = 1, R_1 = (0, 1), omega = 1: the polynomial is 2 y - 1, the determinant 4 times that. */
FIGURE(determinant_factor)
{
    svg *s = svg_new("determinant_factor", "The determinant is four times the polynomial",
                     "For l = 1, R1 = (0, 1) and ω = 1, along the axis x = 0: the printed polynomial is 2y - 1 and the "
                     "determinant 8y - 4.  They vanish together, at y = 1/2 on the curve.");
    num_q zero = q(0), R[6] = {q(-1), zero, zero, q(1), q(1), zero}, w[3] = {q(1), q(1), q(1)}, S[6];
    conic_of_bezier_q(R, w, S);
    num_q low = q(-1), high = q(2), a = conic_value_q(S, zero, low), b = conic_value_q(S, zero, high), four = q(4);
    svg_panel(s, svg_integer_window(-1, -12, 2, 12), 420, 280, "along the axis $x=0$");
    svg_axes(s, r(1, 2), q(4), "y", "$value$");
    svg_segment(s, (svg_point){low, mul_q(four, a)}, (svg_point){high, mul_q(four, b)}, SVG_RIGHT);
    svg_segment(s, (svg_point){low, a}, (svg_point){high, b}, SVG_WRONG);
    svg_mark(s, (svg_point){r(1, 2), zero}, SVG_CURVE, SVG_USUAL);
    svg_legend_line(s, SVG_RIGHT, "the determinant");
    svg_legend_line(s, SVG_WRONG, "the polynomial of (3.5.4)");
    svg_legend_mark(s, SVG_CURVE, SVG_USUAL, "the curve");
    return s;
}
