/* Figures of the section on the ellipse of the second way. */
#include "chapters/foundations/turning-figures.h"

/* 4(x^2 + y^2 - 2 s xy) - 4(1 - s^2) for s = 1/2: the printed equation with r = 1. */
static num_q printed_ellipse(svg_point P, const void *data)
{
    (void)data;
    num_q squares = add_q(mul_q(P.x, P.x), mul_q(P.y, P.y));
    return sub_q(sub_q(squares, mul_q(P.x, P.y)), r(3, 4));
}

FIGURE(ellipse_of_the_second_way)
{
    svg *s = svg_new("ellipse_of_the_second_way", "The ellipse of the second way leaves the circle in both directions",
                     "The printed ellipse for sine one half, which is epsilon 1, so that the deviation can be seen, "
                     "and the circle.  On one "
                     "diagonal the ellipse is outside by the root of 3/2 minus 1, about 0.22, on the other inside by 1 "
                     "minus the root of "
                     "1/2, about 0.29.  The six points of the closed orbit are marked.");
    svg_panel(s, window(r(-7, 5), r(-7, 5), r(7, 5), r(7, 5)), 400, 0, "$s$ = sin($Δθ/2$) = 1/2, $r$ = 1");
    svg_axes(s, q(1), q(1), "x", "y");
    svg_line(s, svg_at(-1, -1), svg_at(1, 1), SVG_MUTED);
    svg_line(s, svg_at(-1, 1), svg_at(1, -1), SVG_MUTED);
    svg_circle(s, svg_at(0, 0), q(1), SVG_CURVE_2);
    svg_implicit(s, printed_ellipse, NULL, 160, SVG_CURVE);
    num_q M[4], P[14] = {q(1), r(1, 2)};
    generator(2, q(1), M);
    orbit(6, M, P);
    for (int k = 0; k < 6; k++)
        svg_mark(s, svg_pair(P + 2 * k), SVG_POINT, SVG_USUAL);
    svg_note(s, at(r(9, 10), r(23, 20)), SVG_HERE, SVG_CURVE, "outwards $\\√(3/2)-1$");
    svg_note(s, at(r(9, 10), r(-23, 20)), SVG_HERE, SVG_CURVE, "inwards $1-\\√(1/2)$");
    svg_legend_line(s, SVG_CURVE, "the printed ellipse");
    svg_legend_line(s, SVG_CURVE_2, "the circle");
    svg_legend_mark(s, SVG_POINT, SVG_USUAL, "points of the orbit, $ε=1$");
    return s;
}

/* (s, sqrt(1+s) - 1), through the parameter E: s = (1+E)^2 - 1. */
static svg_point true_error(num_q E, const void *data)
{
    (void)data;
    num_q side = add_q(q(1), E);
    return at(mul_q(q(100), sub_q(mul_q(side, side), q(1))), mul_q(q(100), E));
}

/* (s, 1 - sqrt(1-s)) */
static svg_point inner_error(num_q E, const void *data)
{
    (void)data;
    num_q side = sub_q(q(1), E);
    return at(mul_q(q(100), sub_q(q(1), mul_q(side, side))), mul_q(q(100), E));
}

FIGURE(error_of_the_second_way)
{
    svg *s = svg_new("error_of_the_second_way", "The printed approximation is twice the error",
                     "The error of the ellipse in per cent against the sine s, which is one half of epsilon.  The "
                     "printed approximation is "
                     "the line E = s, twice too steep; half the sine, E = s/2, lies between the outer and the inner "
                     "error.  The marks "
                     "are m = 4, 3 and 2.");
    svg_panel(s, window(q(0), q(0), q(14), q(10)), 420, 300, "error in per cent, against $100s=100\\·2^{-m-1}$");
    svg_axes(s, q(2), q(2), "100s", "100E");
    svg_segment(s, svg_at(0, 0), svg_at(10, 10), SVG_WRONG);
    svg_segment(s, svg_at(0, 0), svg_at(14, 7), SVG_RIGHT);
    svg_plot(s, true_error, NULL, q(0), r(7, 100), 24, SVG_CURVE);
    svg_plot(s, inner_error, NULL, q(0), r(3, 40), 24, SVG_CURVE_2);
    static const char *const names[3] = {"m=2", "m=3", "m=4"};
    for (int m = 4; m >= 2; m--) {
        num_q x = r(100, 1L << (m + 1)), half = mul_q(r(1, 2), x);
        svg_mark(s, at(x, half), SVG_RIGHT, SVG_USUAL);
        svg_label(s, at(x, half), SVG_SE, SVG_RIGHT, names[m - 2]);
        if (m > 2)
            svg_mark(s, at(x, x), SVG_WRONG, SVG_USUAL);
    }
    svg_legend_line(s, SVG_WRONG, "printed: $2^{-(m+1)}$");
    svg_legend_line(s, SVG_RIGHT, "$2^{-(m+2)}$");
    svg_legend_line(s, SVG_CURVE, "$E$, outwards");
    svg_legend_line(s, SVG_CURVE_2, "inwards");
    return s;
}
