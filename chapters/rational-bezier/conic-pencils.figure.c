/* conic-pencils.figure.c -- drawings for conic-pencils.claims.h. */
#include "chapters/rational-bezier/conic-figures.h"

/* (1-lambda)(x^2-1) + lambda (y^2-1), data = lambda */
static num_q member(svg_point at, const void *data)
{
    const num_q *lambda = data;
    num_q first = sub_q(mul_q(at.x, at.x), q(1)), second = sub_q(mul_q(at.y, at.y), q(1));
    return add_q(mul_q(sub_q(q(1), *lambda), first), mul_q(*lambda, second));
}

/* (1-lambda) x y + lambda (x+y-1)^2, data = lambda */
static num_q touching_member(svg_point at, const void *data)
{
    const num_q *lambda = data;
    num_q line = sub_q(add_q(at.x, at.y), q(1));
    return add_q(mul_q(sub_q(q(1), *lambda), mul_q(at.x, at.y)), mul_q(*lambda, mul_q(line, line)));
}

FIGURE(pencil_of_conics)
{
    svg *s =
        svg_new("pencil_of_conics", "Every member passes through the common points",
                "Members of the pencil of x² - 1 = 0 and y² - 1 = 0: ellipses, hyperbolas and two pairs of lines "
                "through the four points (±1, ±1).  One further point P singles out the circle of λ = 1/2.  The "
                "diagonals pass through the four points and have no λ.  Right, members of the pencil of xy = 0 and "
                "(x + y - 1)² = 0, with two common points only: all touch the axes there, and the lines x = 0 and "
                "x + y = 1 together, a conic through both points, do not.");
    svg_panel(s, svg_integer_window(-2, -2, 2, 2), 400, 0,
              "$(1-λ)(x^2-1)+λ(y^2-1)=0$: at the four points every $λ$ fits");
    svg_frame(s);
    const num_q lambda[] = {q(-2),   r(-1, 2), r(-1, 8), q(0),    r(1, 8), r(1, 3),
                            r(2, 3), r(7, 8),  q(1),     r(9, 8), r(3, 2), q(3)};
    for (size_t k = 0; k < sizeof lambda / sizeof *lambda; k++)
        svg_implicit(s, member, &lambda[k], 80, SVG_FAMILY);
    num_q half = r(1, 2);
    svg_implicit(s, member, &half, 80, SVG_CURVE);
    svg_line(s, svg_at(-1, -1), svg_at(1, 1), SVG_WRONG);
    svg_line(s, svg_at(-1, 1), svg_at(1, -1), SVG_WRONG);
    for (int k = 0; k < 4; k++)
        svg_mark(s, svg_at(k < 2 ? 1 : -1, k % 2 ? 1 : -1), SVG_POINT, SVG_USUAL);
    svg_point P = {r(7, 5), r(1, 5)};
    svg_mark(s, P, SVG_RIGHT, SVG_USUAL);
    svg_label(s, P, SVG_E, SVG_RIGHT, "P");
    svg_panel(s, svg_integer_window(-1, -1, 2, 2), 400, 0,
              "$(1-λ)xy+λ(x+y-1)^2=0$: two common points,\nand conics through them that are no members");
    svg_frame(s);
    const num_q touching[] = {q(-1), r(-1, 4), r(-1, 20), q(0), r(1, 20), r(1, 9), r(1, 5), r(1, 3), r(3, 5), r(3, 2)};
    for (size_t k = 0; k < sizeof touching / sizeof *touching; k++)
        svg_implicit(s, touching_member, &touching[k], 120, SVG_FAMILY);
    svg_line(s, svg_at(0, 0), svg_at(0, 1), SVG_WRONG);
    svg_line(s, svg_at(1, 0), svg_at(0, 1), SVG_WRONG);
    svg_mark(s, svg_at(1, 0), SVG_POINT, SVG_USUAL);
    svg_mark(s, svg_at(0, 1), SVG_POINT, SVG_USUAL);
    svg_legend_line(s, SVG_FAMILY, "members");
    svg_legend_line(s, SVG_CURVE, "$λ=1/2$, fixed by $P$");
    svg_legend_line(s, SVG_WRONG, "$x^2-y^2=0$ and $x(x+y-1)=0$: no $λ$");
    return s;
}
