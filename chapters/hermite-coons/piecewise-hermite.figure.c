/* Figures of the section on curves made of pieces. */
#include "chapters/hermite-coons/drawing.h"

FIGURE(piecewise_base_functions)
{
    svg *s =
        svg_new("piecewise_base_functions", "The two functions of an inner node",
                "Nodes 0, 1, 2, 3: the functions of the value and of the derivative at 1 are 0 beyond the neighbours.");
    svg_panel(s, window(q(0), r(-1, 4), q(3), r(5, 4)), 420, 200, "the node $t_1=1$ among $0,1,2,3$");
    svg_axes(s, q(1), r(1, 2), "t", NULL);
    for (int order = 0; order < 2; order++) {
        for (int i = 0; i < 3; i++) {
            num_q f[4] = {q(0), q(0), q(0), q(0)};
            if (i < 2)
                f[2 * order + 1 - i] = q(1);
            put_hermite_graph(s, q(i), q(i + 1), f, order ? SVG_CURVE_2 : SVG_CURVE);
        }
    }
    svg_label(s, svg_at(1, 1), SVG_N, SVG_CURVE, "a_{1,0}");
    svg_label(s, at(r(4, 3), r(4, 27)), SVG_N, SVG_CURVE_2, "a_{1,1}");
    return s;
}

FIGURE(piecewise_is_not_c2)
{
    svg *s = svg_new("piecewise_is_not_c2", "A jump of the second derivative",
                     "Nodes 0, 1, 2, values 0, 1, 1, derivatives 0: the curve has one tangent at 1, but the second "
                     "derivative jumps from -6 to 0.");
    svg_panel(s, window(q(0), r(-1, 4), q(2), r(5, 4)), 270, 220, "$P$");
    svg_axes(s, q(1), q(1), "t", NULL);
    num_q rise[4] = {q(0), q(1), q(0), q(0)}, flat[4] = {q(1), q(1), q(0), q(0)};
    put_hermite_graph(s, q(0), q(1), rise, SVG_CURVE);
    put_hermite_graph(s, q(1), q(2), flat, SVG_CURVE);
    for (int i = 0; i < 3; i++)
        svg_mark(s, svg_at(i, i > 0), SVG_POINT, SVG_USUAL);
    svg_panel(s, svg_integer_window(0, -7, 2, 7), 270, 220, "$P''$");
    svg_axes(s, q(1), q(6), "t", NULL);
    svg_segment(s, svg_at(0, 6), svg_at(1, -6), SVG_CURVE_2);
    svg_segment(s, svg_at(1, 0), svg_at(2, 0), SVG_CURVE_2);
    svg_mark(s, svg_at(1, -6), SVG_CURVE_2, SVG_USUAL);
    svg_mark(s, svg_at(1, 0), SVG_CURVE_2, SVG_USUAL);
    svg_segment(s, svg_at(1, -6), svg_at(1, 0), SVG_MUTED);
    return s;
}

FIGURE(one_tangent_two_lengths)
{
    svg *s = svg_new("one_tangent_two_lengths", "One scaled tangent for two intervals of different lengths",
                     "Nodes 0, 1, 3, values 0, 1, 1, derivatives 1, 1, 0.  If the second piece takes over the scaled "
                     "tangent of the first, the slope at 1 falls to one half.");
    svg_panel(s, window(q(0), q(0), q(3), r(3, 2)), 420, 0, NULL);
    svg_axes(s, q(1), q(1), "t", NULL);
    num_q first[4] = {q(0), q(1), q(1), q(1)}, right[4] = {q(1), q(1), q(1), q(0)};
    num_q wrong[4] = {q(1), q(1), r(1, 2), q(0)};
    put_hermite_graph(s, q(0), q(1), first, SVG_CURVE);
    put_hermite_graph(s, q(1), q(3), right, SVG_RIGHT);
    put_hermite_graph(s, q(1), q(3), wrong, SVG_WRONG);
    for (int i = 0; i < 3; i++)
        svg_mark(s, svg_at(i + (i == 2), i > 0), SVG_POINT, SVG_USUAL);
    svg_legend_line(s, SVG_RIGHT, "$P_1'=f'(t_1)(t_2-t_1)$");
    svg_legend_line(s, SVG_WRONG, "$P_1'=f'(t_1)(t_1-t_0)$");
    return s;
}
