/* tangent-ratios.figure.c -- drawings for tangent-ratios.claims.h. */
#include "chapters/rational-bezier/conic-figures.h"

/* With the weights 1, 1/2, 1 the ratios are g_1 = 2 (1-t)/t and g_2 = 2 t/(1-t); A and B are at g/(1+g).
 * At t = 1/3: g_1 = 4, g_2 = 1; at t = 3/4: g_1 = 2/3, g_2 = 6. */
FIGURE(tangent_ratios)
{
    svg *s =
        svg_new("tangent_ratios", "The two ratios of a point",
                "The tangent at a point R of the arc inside the triangle cuts the side R1R0 in A and the side R1R2 in "
                "B.  The ratios are g1 = R1A : R0A = 4 : 1 and g2 = R1B : R2B = 1 : 1.  At another point they are 2/3 "
                "and 6: the product is 4 again.");
    num_q R[6] = {q(0), q(0), q(2), q(5), q(8), q(1)}, w[3] = {q(1), r(1, 2), q(1)}, P[2], Q[2];
    rational_point_q(2, 2, R, w, r(1, 3), P);
    rational_point_q(2, 2, R, w, r(3, 4), Q);
    svg_window window = {r(-1, 2), r(-1, 2), r(17, 2), r(11, 2)};
    svg_panel(s, window, 560, 0, "at $R$: $g_1=4$, $g_2=1$; at $Q$: $g_1=2/3$, $g_2=6$; both products are 4");
    put_triangle(s, R, SVG_SW, SVG_N, SVG_SE);
    svg_rational(s, 2, R, w, SVG_CURVE);
    svg_segment(s, between(R + 2, R, r(2, 5)), between(R + 2, R + 4, r(6, 7)), SVG_FAMILY);
    svg_mark(s, svg_pair(Q), SVG_FAMILY, SVG_USUAL);
    svg_label(s, svg_pair(Q), SVG_SW, SVG_FAMILY, "Q");
    svg_point A = between(R + 2, R, r(4, 5)), B = between(R + 2, R + 4, r(1, 2));
    svg_segment(s, A, B, SVG_POINT);
    svg_mark(s, A, SVG_POINT, SVG_USUAL);
    svg_mark(s, B, SVG_POINT, SVG_USUAL);
    svg_mark(s, svg_pair(P), SVG_CURVE, SVG_USUAL);
    svg_label(s, A, SVG_W, SVG_POINT, "A");
    svg_label(s, B, SVG_NE, SVG_POINT, "B");
    svg_label(s, svg_pair(P), SVG_SE, SVG_CURVE, "R");
    svg_note(s, between(R + 2, R, r(2, 5)), SVG_W, SVG_POLYGON, "4");
    svg_note(s, between(R + 2, R, r(9, 10)), SVG_W, SVG_POLYGON, "1");
    svg_note(s, between(R + 2, R + 4, r(1, 4)), SVG_NE, SVG_POLYGON, "1");
    svg_note(s, between(R + 2, R + 4, r(3, 4)), SVG_NE, SVG_POLYGON, "1");
    svg_legend_line(s, SVG_CURVE, "weights 1, 1/2, 1");
    svg_legend_line(s, SVG_POINT, "tangent at $R$");
    svg_legend_line(s, SVG_FAMILY, "tangent at $Q$");
    return s;
}

/* x y + 4 (x + y - 1)^2, the member of lambda = 4/3 up to a factor. */
static num_q hyperbola(svg_point at, const void *data)
{
    (void)data;
    num_q t = sub_q(add_q(at.x, at.y), q(1));
    return add_q(mul_q(at.x, at.y), mul_q(q(4), mul_q(t, t)));
}

FIGURE(ratio_product_extra)
{
    svg *s =
        svg_new("ratio_product_extra", "A member whose ratios have a negative product",
                "The hyperbola of λ = 4/3 in the frame R0 = (1, 0), R1 = (0, 0), R2 = (0, 1).  Its tangent at R = "
                "(2, -2) cuts the first side inside, in A = (4/5, 0), and the second outside, in B = (0, 4/3): g1 = 4 "
                "and g2 = -4.");
    num_q R[6] = {q(1), q(0), q(0), q(0), q(0), q(1)};
    svg_panel(s, svg_integer_window(-2, -3, 4, 2), 560, 0, "$g_1=4$, $g_2=-4$: their product is not positive");
    svg_area(s, 3, R, SVG_FILL);
    svg_axes(s, q(1), q(1), "x", "y");
    svg_implicit(s, hyperbola, NULL, 240, SVG_CURVE);
    svg_point A = {r(4, 5), q(0)}, B = {q(0), r(4, 3)}, P = svg_at(2, -2);
    svg_line(s, B, P, SVG_POINT);
    for (int i = 0; i < 3; i++)
        svg_mark(s, svg_pair(R + 2 * i), SVG_POLYGON, SVG_USUAL);
    svg_mark(s, A, SVG_POINT, SVG_USUAL);
    svg_mark(s, B, SVG_WRONG, SVG_USUAL);
    svg_mark(s, P, SVG_CURVE, SVG_USUAL);
    svg_label(s, svg_pair(R), SVG_NE, SVG_POLYGON, "R_0");
    svg_label(s, svg_pair(R + 2), SVG_NW, SVG_POLYGON, "R_1");
    svg_label(s, svg_pair(R + 4), SVG_SW, SVG_POLYGON, "R_2");
    svg_label(s, A, SVG_SW, SVG_POINT, "A");
    svg_label(s, B, SVG_E, SVG_WRONG, "B");
    svg_label(s, P, SVG_NE, SVG_CURVE, "R");
    svg_legend_line(s, SVG_CURVE, "the member of $λ=4/3$, $xy+4(x+y-1)^2=0$");
    return s;
}
