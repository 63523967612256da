/* envelope-uniqueness.figure.c -- drawings for envelope-uniqueness.claims.h. */
#include "chapters/nurbs/family-figures.h"

FIGURE(nurbs_second_line)
{
    svg *s = svg_new(
        "nurbs_second_line", "The line that every member touches",
        "The cubic (t, t³) on one span of uniform knots, r = 1.  Left the square of the pairs (t, τ): the condition of "
        "the envelope holds on the diagonal "
        "and on the line t = 0.  Right the members, parabolas and, for τ = 0, the axis y = 0: each parabola touches "
        "the "
        "cubic once and the axis once.");
    static const int x[4] = {0, 1}, y[4] = {0, 0, 0, 1};
    struct nurbs c = one_span(3, 1, x, y);
    svg_panel(s, svg_integer_window(-1, -1, 1, 1), 240, 0, "where the condition holds");
    svg_axes(s, q(1), q(1), "t", "τ");
    svg_frame(s);
    svg_segment(s, svg_at(-1, -1), svg_at(1, 1), SVG_CURVE);
    svg_segment(s, svg_at(0, -1), svg_at(0, 1), SVG_WRONG);
    svg_mark(s, at(q(0), r(1, 2)), SVG_WRONG, SVG_USUAL);
    svg_panel(s, window(r(-3, 5), r(-1, 6), r(3, 5), r(1, 6)), 420, 300,
              "$k=4$, $r=1$: the cubic $(t,t^3)$ and its parabolas");
    put_family(s, &c, 3, 1, 20);
    put_curve(s, &c, SVG_CURVE);
    svg_segment(s, at(r(-1, 3), q(0)), at(r(1, 3), q(0)), SVG_WRONG);
    put_member(s, &c, 3, 1, r(1, 2), SVG_CURVE_2);
    svg_mark(s, at(r(1, 6), q(0)), SVG_WRONG, SVG_USUAL);
    svg_label(s, at(r(1, 6), q(0)), SVG_S, SVG_WRONG, "(1/6,0)");
    svg_mark(s, at(r(1, 2), r(1, 8)), SVG_POINT, SVG_USUAL);
    svg_frame(s);
    svg_legend_line(s, SVG_CURVE, "$τ=t$, the curve");
    svg_legend_line(s, SVG_WRONG, "$t=0$, the second envelope");
    svg_legend_line(s, SVG_CURVE_2, "the member of $τ=1/2$");
    svg_legend_line(s, SVG_FAMILY, "other members");
    return s;
}

/* (r', A, p'') of the curve (t, t², t³ + 1), k = 4, with A = p + (τ-t)/3 p', times τ - t. */
static num_q triple_with_second(svg_point P, const void *data)
{
    (void)data;
    num_q t = P.x, tt = mul_q(t, t), gap = sub_q(P.y, t), third = div_q(gap, q(3));
    num_q d1[3] = {q(1), mul_q(q(2), t), mul_q(q(3), tt)}, d2[3] = {q(0), q(2), mul_q(q(6), t)};
    num_q A[3] = {t, tt, add_q(mul_q(tt, t), q(1))};
    for (int c = 0; c < 3; c++)
        A[c] = add_q(A[c], mul_q(third, d1[c]));
    return mul_q(gap, det3_q(d1, A, d2));
}

FIGURE(product_that_says_nothing)
{
    svg *s =
        svg_new("product_that_says_nothing", "A product that loses the equation",
                "Two squares of pairs (t, τ) for the twisted cubic (t, t², t³ + 1) with equal weights.  The scalar "
                "product of both sides with the second derivative is 0 = 0 in the whole square.  The equation said "
                "to follow from it holds on the diagonal and, because the osculating plane contains the origin there, "
                "on the edge t = -1 only.");
    num_q square[8] = {q(-1), q(-1), q(1), q(-1), q(1), q(1), q(-1), q(1)};
    for (int k = 0; k < 2; k++) {
        svg_panel(s, svg_integer_window(-1, -1, 1, 1), 250, 0,
                  k == 0 ? "the product with $p''$: $0=0$" : "$(τ-t)(r',A,p'')=0$");
        svg_heading(s, k == 0 ? SVG_WRONG : SVG_RIGHT, k == 0 ? "every pair" : "the diagonal and $t=-1$");
        if (k == 0)
            svg_area(s, 4, square, SVG_WRONG);
        svg_axes(s, q(1), q(1), "t", "τ");
        svg_frame(s);
        if (k == 1) {
            svg_implicit(s, triple_with_second, NULL, 81, SVG_RIGHT);
            svg_segment(s, svg_at(-1, -1), svg_at(-1, 1), SVG_RIGHT);
        }
        svg_mark(s, (svg_point){q(0), from_ratio_q(1, 2)}, k == 0 ? SVG_WRONG : SVG_MUTED, SVG_USUAL);
    }
    svg_legend_area(s, SVG_WRONG, "where the first equation holds");
    svg_legend_line(s, SVG_RIGHT, "where the second one does");
    svg_legend_mark(s, SVG_WRONG, SVG_USUAL, "the counterexample, $t=0$, $τ=1/2$");
    return s;
}
