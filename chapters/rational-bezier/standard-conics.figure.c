/* standard-conics.figure.c -- drawings for standard-conics.claims.h. */
#include "chapters/judge/figure_data.h"
#include "chapters/rational-bezier/conic-figures.h"

/* The printed t of equal weights against u: u = v^2/(v^2 + (1-v)^2) has t = v. */
static svg_point printed(num_q v, const void *data)
{
    (void)data;
    num_q s = sub_q(q(1), v), vv = mul_q(v, v);
    return (svg_point){div_q(vv, add_q(vv, mul_q(s, s))), v};
}

FIGURE(standard_parameter)
{
    svg *s =
        svg_new("standard_parameter", "The change of parameter, printed and right",
                "For equal weights the right change of parameter is t = u; the printed one, with roots over the "
                "parameter too, gives t = 3/7 at u = 9/25.  Right, the points of these parameters on the curve with "
                "the points (-1, 0), (0, 1), (1, 0).");
    static const char claim_name[] = "roots_over_the_parameter_are_wrong";
    num_q u, t = r(3, 7), R[6], w[3], P[2];
    data_of(claim_name, "u", 1, 1, &u);
    data_of(claim_name, "R", 3, 2, R);
    data_of(claim_name, "ω", 3, 1, w);
    svg_panel(s, svg_integer_window(0, 0, 1, 1), 280, 0, "$t$ as a function of $u$, weights 1, 1, 1");
    svg_axes(s, r(1, 2), r(1, 2), "u", "t");
    svg_segment(s, svg_at(0, 0), svg_at(1, 1), SVG_RIGHT);
    svg_plot(s, printed, NULL, q(0), q(1), 32, SVG_WRONG);
    svg_segment(s, (svg_point){u, q(0)}, (svg_point){u, t}, SVG_MUTED);
    svg_mark(s, (svg_point){u, u}, SVG_RIGHT, SVG_USUAL);
    svg_mark(s, (svg_point){u, t}, SVG_WRONG, SVG_USUAL);

    svg_window window = {r(-5, 4), r(-1, 5), r(5, 4), r(6, 5)};
    svg_panel(s, window, 400, 0, "the points of $u=9/25$");
    svg_control_polygon(s, 2, R, "R");
    svg_rational(s, 2, R, w, SVG_CURVE);
    rational_point_q(2, 2, R, w, u, P);
    svg_mark(s, svg_pair(P), SVG_RIGHT, SVG_USUAL);
    svg_label(s, svg_pair(P), SVG_SE, SVG_RIGHT, "R^*(9/25)");
    rational_point_q(2, 2, R, w, t, P);
    svg_mark(s, svg_pair(P), SVG_WRONG, SVG_USUAL);
    svg_label(s, svg_pair(P), SVG_N, SVG_WRONG, "R(3/7)");
    svg_legend_line(s, SVG_RIGHT, "roots over the weights alone");
    svg_legend_line(s, SVG_WRONG, "as printed, roots over the parameter too");
    return s;
}
