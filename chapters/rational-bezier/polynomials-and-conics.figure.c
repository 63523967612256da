/* polynomials-and-conics.figure.c -- drawings for polynomials-and-conics.claims.h. */
#include "chapters/rational-bezier/conic-figures.h"

/* The quarter circle and the quadratic Bézier curve with the same points; an arc of y = x^2. */
FIGURE(polynomial_on_conics)
{
    svg *s =
        svg_new("polynomial_on_conics", "Polynomial curves and conics",
                "Left, the points (1, 0), (1, 1), (0, 1) give a quarter circle with the weights 1, 1, 2, while the "
                "polynomial Bézier curve with these points runs outside the circle.  Right, an arc of the "
                "parabola y = x² is a polynomial Bézier curve exactly.");
    num_q R[6] = {q(1), q(0), q(1), q(1), q(0), q(1)}, w[3] = {q(1), q(1), q(2)};
    svg_window left = {r(-1, 5), r(-1, 5), r(5, 4), r(5, 4)};
    svg_panel(s, left, 330, 0, "no polynomial arc lies on a circle");
    svg_axes(s, q(1), q(1), "x", "y");
    svg_control_polygon(s, 2, R, "R");
    svg_rational(s, 2, R, w, SVG_CURVE);
    svg_bezier(s, 2, R, SVG_WRONG);

    num_q a = q(-1), b = r(3, 2), P[6] = {a, mul_q(a, a), r(1, 4), mul_q(a, b), b, mul_q(b, b)};
    num_q c = q(-2), d = q(2), whole[6] = {c, mul_q(c, c), q(0), mul_q(c, d), d, mul_q(d, d)};
    svg_window right = {r(-8, 5), q(-2), r(9, 5), r(14, 5)};
    svg_panel(s, right, 260, 0, "every arc of a parabola is polynomial");
    svg_axes(s, q(1), q(1), "x", "y");
    svg_bezier(s, 2, whole, SVG_FAMILY);
    svg_control_polygon(s, 2, P, "R");
    svg_bezier(s, 2, P, SVG_CURVE);
    svg_legend_line(s, SVG_CURVE, "left: weights 1, 1, 2; right: weights 1, 1, 1");
    svg_legend_line(s, SVG_WRONG, "weights 1, 1, 1");
    return s;
}
