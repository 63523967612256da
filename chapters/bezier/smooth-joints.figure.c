/* Figures of the section on cubics that are joined. */
#include "chapters/judge/figure.h"
#include "figures/words.h"

/* Two cubics with their polygons, drawn dimly, and the joint. */
static void put_joint(svg *s, const int before[8], const int after[8], enum svg_role role)
{
    num_q p[8], q[8];
    integers(8, before, p);
    integers(8, after, q);
    svg_polyline(s, 4, p, SVG_POLYGON);
    svg_polyline(s, 4, q, SVG_POLYGON);
    svg_bezier(s, 3, p, SVG_CURVE);
    svg_bezier(s, 3, q, role);
    for (int i = 0; i <= 3; i++) {
        svg_mark(s, svg_pair(p + 2 * i), SVG_POLYGON, SVG_USUAL);
        svg_mark(s, svg_pair(q + 2 * i), SVG_POLYGON, SVG_USUAL);
    }
}

FIGURE(joint_of_cubics)
{
    svg *s = svg_new("joint_of_cubics", "Two cubics with one tangent at the joint",
                     "The joint divides the segment from P2 to Q1 in the ratio 1 : a, here a = 2; with a = -1/2 the "
                     "second cubic turns back.");
    static const int before[8] = {-5, 0, -4, 3, -2, 1, 0, 0}, after[8] = {0, 0, 4, -2, 6, 1, 8, -1};
    static const int back[8] = {0, 0, -1, 0, -3, -2, -1, -4};
    svg_panel(s, window(q(-6), q(-3), q(9), q(4)), 460, 0, "$Q_1-Q_0=2(P_3-P_2)$");
    put_joint(s, before, after, SVG_CURVE_2);
    svg_label(s, svg_at(-2, 1), SVG_SW, SVG_POLYGON, "P_2");
    svg_label(s, svg_at(0, 0), SVG_NE, SVG_POINT, "P_3=Q_0");
    svg_label(s, svg_at(4, -2), SVG_S, SVG_POLYGON, "Q_1");
    static const int turned[8] = {-5, 3, -4, 3, -2, 0, 0, 0};
    svg_panel(s, window(q(-6), q(-5), q(2), q(4)), 250, 0, "a negative $a$");
    put_joint(s, turned, back, SVG_WRONG);
    svg_label(s, svg_at(-2, 0), SVG_W, SVG_POLYGON, "P_2");
    svg_label(s, svg_at(0, 0), SVG_NE, SVG_POINT, "P_3=Q_0");
    svg_label(s, svg_at(-1, 0), SVG_N, SVG_WRONG, "Q_1");
    svg_legend_line(s, SVG_CURVE, "first cubic");
    svg_legend_line(s, SVG_CURVE_2, "second cubic, $G^1$");
    svg_legend_line(s, SVG_WRONG, "$a<0$: it turns back");
    return s;
}

FIGURE(corner_without_edges)
{
    svg *s = svg_new("corner_without_edges", "The condition satisfied by edges of length 0",
                     "The points P2, P3, Q0, Q1 coincide: both derivatives are 0 and proportional, and the curve has a "
                     "corner.");
    static const int before[8] = {-3, 2, -2, 0, 0, 0, 0, 0}, after[8] = {0, 0, 0, 0, 0, 2, 2, 3};
    svg_panel(s, window(q(-4), q(-1), q(3), q(4)), 340, 0, "$P_2=P_3=Q_0=Q_1$");
    put_joint(s, before, after, SVG_WRONG);
    svg_label(s, svg_at(-2, 0), SVG_S, SVG_POLYGON, "P_1");
    svg_label(s, svg_at(0, 2), SVG_W, SVG_POLYGON, "Q_2");
    svg_legend_line(s, SVG_CURVE, "first cubic");
    svg_legend_line(s, SVG_WRONG, "second cubic: a corner");
    return s;
}

FIGURE(second_derivatives_alone)
{
    svg *s = svg_new("second_derivatives_alone", "Equal second derivatives without equal first ones",
                     "After the same first cubic, left the second cubic with a = 2 and Q2 = P1 + 2(Q1 - P2): the "
                     "curvature falls to a quarter; right with a = 1, where the joint is C2.");
    static const int before[8] = {-3, 3, -2, 1, -1, 0, 0, 0};
    static const int wrong[8] = {0, 0, 2, 0, 4, 1, 6, 3}, good[8] = {0, 0, 1, 0, 2, 1, 3, 3};
    for (int k = 0; k < 2; k++) {
        svg_panel(s, window(q(-4), q(-1), q(7), q(4)), 360, 0,
                  k ? "$a=1$: curvature 2/3 on both sides" : "$a=2$: curvatures 2/3 and 1/6");
        svg_circle(s, at(q(0), r(3, 2)), r(3, 2), SVG_MUTED);
        if (k == 0)
            svg_circle(s, svg_at(0, 6), q(6), SVG_FAMILY);
        put_joint(s, before, k ? good : wrong, k ? SVG_RIGHT : SVG_WRONG);
        svg_label(s, svg_at(-1, 0), SVG_S, SVG_POLYGON, "P_2");
        svg_label(s, svg_at(k ? 1 : 2, 0), SVG_S, SVG_POLYGON, "Q_1");
        svg_label(s, svg_at(k ? 2 : 4, 1), SVG_SE, SVG_POLYGON, "Q_2");
        svg_frame(s);
    }
    svg_legend_line(s, SVG_CURVE, "first cubic");
    svg_legend_line(s, SVG_WRONG, "$P\\'\\'(1)=Q\\'\\'(0)$ alone");
    svg_legend_line(s, SVG_RIGHT, "$P\\'(1)=Q\\'(0)$ as well");
    svg_legend_line(s, SVG_MUTED, "circle of curvature before the joint");
    svg_legend_line(s, SVG_FAMILY, "and after it");
    return s;
}
