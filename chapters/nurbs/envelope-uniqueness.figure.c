/* envelope-uniqueness.figure.c -- drawings for envelope-uniqueness.claims.h. */
#include "chapters/nurbs/family-figures.h"

FIGURE(nurbs_second_line)
{
    svg *s = svg_new(
        "nurbs_second_line", "The line that every member touches",
        "The cubic (t, t³) on one span of uniform knots, r = 1.  Left the square of the pairs (t, τ): the condition of "
        "the envelope holds on the diagonal "
        "and on the line t = 0.  Right the members, parabolas: each touches the cubic once and the axis y = 0 once.");
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

FIGURE(nurbs_folded_line)
{
    svg *s = svg_new("nurbs_folded_line", "On a line every pair is a solution",
                     "A quadratic segment whose points are on a line, drawn with its parameter upwards: it runs from "
                     "1/2 to 3/4 and back.  The member of the parameter 2 runs "
                     "from 1/2 to 1.");
    svg_panel(s, window(q(0), q(2), r(11, 10), q(3)), 420, 240,
              "$k=3$, points 0, 1, 0 on a line; $t$ upwards, the point to the right");
    svg_axes(s, r(1, 4), r(1, 2), "x", "t");
    num_q curve[6] = {r(1, 2), q(2), q(1), r(5, 2), r(1, 2), q(3)};
    svg_bezier(s, 2, curve, SVG_CURVE);
    svg_segment(s, at(r(1, 2), q(2)), at(q(1), q(3)), SVG_WRONG);
    svg_mark(s, at(r(7, 8), r(11, 4)), SVG_WRONG, SVG_USUAL);
    svg_label(s, at(r(7, 8), r(11, 4)), SVG_E, SVG_WRONG, "7/8");
    svg_legend_line(s, SVG_CURVE, "$r(t)$, at most $3/4$");
    svg_legend_line(s, SVG_WRONG, "the member of $τ=2$, a solution $τ(t)=2$");
    return s;
}
