/* Figures of the section on values and derivatives. */
#include "chapters/hermite-coons/drawing.h"

FIGURE(hermite_blending_functions)
{
    svg *s = svg_new("hermite_blending_functions", "The four cubics of Hermite over the unit interval",
                     "Two functions carry the values at 0 and 1, two carry the derivatives; the latter are four "
                     "twenty-sevenths high at most.");
    static const char *const caption[2] = {"the values: $q_{00}$ and $q_{01}$",
                                           "the derivatives: $q_{10}$ and $q_{11}$"};
    static const char *const name[4] = {"q_{00}", "q_{01}", "q_{10}", "q_{11}"};
    for (int panel = 0; panel < 2; panel++) {
        svg_panel(s, window(q(0), panel ? r(-1, 5) : q(0), q(1), panel ? r(1, 5) : q(1)), 300, 220, caption[panel]);
        svg_axes(s, q(1), panel ? r(1, 10) : q(1), "u", NULL);
        for (int i = 0; i < 2; i++) {
            num_q unit[4];
            for (int k = 0; k < 4; k++)
                unit[k] = q(k == 2 * panel + i);
            put_hermite_graph(s, q(0), q(1), unit, i ? SVG_CURVE_2 : SVG_CURVE);
            num_q B[4], u = i ? r(3, 4) : r(1, 4);
            hermite_blending_q(q(0), q(1), u, 0, B);
            svg_label(s, at(u, B[2 * panel + i]), panel == 0 ? (i ? SVG_SE : SVG_SW) : (i ? SVG_S : SVG_N),
                      i ? SVG_CURVE_2 : SVG_CURVE, name[2 * panel + i]);
            if (panel == 1) { /* the extremes, at u = 1/3 and 2/3 */
                svg_point top = at(r(1 + i, 3), r(i ? -4 : 4, 27));
                svg_mark(s, top, i ? SVG_CURVE_2 : SVG_CURVE, SVG_USUAL);
                svg_note(s, top, i ? SVG_SW : SVG_NE, SVG_POINT, i ? "$-4/27$ at $u=2/3$" : "$4/27$ at $u=1/3$");
            }
        }
    }
    return s;
}

FIGURE(square_without_its_prime)
{
    svg *s = svg_new("square_without_its_prime", "A prime that is missing in the coefficient of the square",
                     "The data of the constant 1 over the unit interval.  With f(t0) for its derivative in one term "
                     "the curve ends at -1 or at 3, by the sign of the term, and with the derivative at 1.");
    svg_panel(s, window(r(-1, 4), r(-5, 4), r(5, 4), r(13, 4)), 260, 300, "$f(0)=f(1)=1$, $f'(0)=f'(1)=0$");
    svg_axes(s, q(1), q(1), "t", NULL);
    for (int sign = -1; sign <= 1; sign++) {
        num_q f[4] = {q(1), q(1 + 2 * sign), q(0), q(4 * sign)};
        put_hermite_graph(s, q(0), q(1), f, sign == 0 ? SVG_RIGHT : SVG_WRONG);
        if (sign != 0)
            svg_mark(s, svg_at(1, 1 + 2 * sign), SVG_WRONG, SVG_USUAL);
    }
    svg_mark(s, svg_at(0, 1), SVG_POINT, SVG_USUAL);
    svg_mark(s, svg_at(1, 1), SVG_POINT, SVG_USUAL);
    svg_legend_line(s, SVG_WRONG, "with $\\±2f(t_0)t_1^2$");
    svg_legend_line(s, SVG_RIGHT, "with $-2f'(t_0)t_1^2$");
    return s;
}

struct node_number {
    int i;
};

static svg_point lagrange_graph(num_q t, const void *data)
{
    num_q tau[4] = {q(0), q(1), q(2), q(3)}, g[4];
    lagrange_blending_q(3, tau, t, g);
    return at(t, g[((const struct node_number *)data)->i]);
}

FIGURE(lagrange_blending_functions)
{
    svg *s = svg_new("lagrange_blending_functions", "The four cubics of Lagrange",
                     "For the nodes 0, 1, 2, 3: each is 1 at one node and 0 at the others.");
    svg_panel(s, window(q(0), r(-1, 2), q(3), r(5, 4)), 420, 240, "the nodes 0, 1, 2, 3");
    svg_axes(s, q(1), r(1, 2), "t", NULL);
    static const char *const name[4] = {"g_0", "g_1", "g_2", "g_3"};
    static const enum svg_role role[4] = {SVG_CURVE_2, SVG_CURVE, SVG_CURVE, SVG_CURVE_2};
    for (int i = 0; i < 4; i++) {
        struct node_number node = {i};
        svg_plot(s, lagrange_graph, &node, q(0), q(3), 24, role[i]);
        svg_mark(s, svg_at(i, 1), SVG_POINT, SVG_USUAL);
        svg_label(s, svg_at(i, 1), i < 2 ? SVG_NE : SVG_NW, SVG_POINT, name[i]);
    }
    return s;
}

FIGURE(worked_hermite_curve)
{
    svg *s = svg_new("worked_hermite_curve", "The worked Hermite curve",
                     "From (1,1) with the tangent (1,1) to (4,2) with the tangent (1,-1).");
    svg_panel(s, window(r(1, 2), r(1, 2), r(11, 2), q(3)), 420, 0, NULL);
    svg_axes(s, q(1), q(1), "x", "y");
    num_q data[8] = {q(1), q(1), q(4), q(2), q(1), q(1), q(1), q(-1)};
    put_hermite(s, data, SVG_CURVE);
    svg_arrow(s, svg_at(1, 1), svg_at(2, 2), SVG_POINT);
    svg_arrow(s, svg_at(4, 2), svg_at(5, 1), SVG_POINT);
    svg_mark(s, svg_at(1, 1), SVG_POINT, SVG_USUAL);
    svg_mark(s, svg_at(4, 2), SVG_POINT, SVG_USUAL);
    svg_label(s, svg_at(1, 1), SVG_SE, SVG_POINT, "P_0");
    svg_label(s, svg_at(4, 2), SVG_NE, SVG_POINT, "P_1");
    svg_label(s, svg_at(2, 2), SVG_N, SVG_POINT, "P'_0");
    svg_label(s, svg_at(5, 1), SVG_E, SVG_POINT, "P'_1");
    return s;
}

FIGURE(nodes_that_meet)
{
    svg *s =
        svg_new("nodes_that_meet", "Two nodes that approach each other",
                "The cubics with the values 0 and 1 at two nodes and the derivatives 0, for nodes in the distances 1, "
                "1/2, 1/4 and 1/8.  In the limit one node would have two values, and there is no cubic.");
    svg_panel(s, window(q(0), r(-1, 8), q(1), r(9, 8)), 380, 240, "$f(t_0)=0$, $f(t_1)=1$, $f'(t_0)=f'(t_1)=0$");
    svg_axes(s, r(1, 4), q(1), "t", NULL);
    for (int k = 3; k >= 0; k--) {
        num_q half = r(1, 2L << k), t0 = sub_q(r(1, 2), half), t1 = add_q(r(1, 2), half);
        num_q f[4] = {q(0), q(1), q(0), q(0)};
        put_hermite_graph(s, t0, t1, f, k == 0 ? SVG_CURVE : SVG_FAMILY);
        svg_mark(s, at(t0, q(0)), SVG_FAMILY, SVG_USUAL);
        svg_mark(s, at(t1, q(1)), SVG_FAMILY, SVG_USUAL);
    }
    svg_segment(s, at(r(1, 2), q(0)), at(r(1, 2), q(1)), SVG_WRONG);
    svg_legend_line(s, SVG_CURVE, "distance 1");
    svg_legend_line(s, SVG_FAMILY, "1/2, 1/4, 1/8");
    svg_legend_line(s, SVG_WRONG, "equal nodes: no cubic");
    return s;
}
