/* Figures of the section on continuity. */
#include "chapters/hermite-coons/drawing.h"

FIGURE(differentiable_without_continuity)
{
    svg *s = svg_new("differentiable_without_continuity", "A derivative at 0 that is no limit of derivatives",
                     "The function made of Hermite cubics between 1, 1/2, 1/3, ... with slopes -1 and 1 in turn lies "
                     "between two curves that touch the axis at 0; its slope there is 0, and does not tend to 0.");
    svg_panel(s, window(q(0), r(-3, 20), r(21, 20), r(3, 20)), 560, 240, "$f(\\1/n)=0$, slopes $(-1)^n$");
    svg_axes(s, r(1, 2), r(1, 10), "x", NULL);
    for (int n = 1; n <= 40; n++) {
        num_q slope = q(n % 2 == 0 ? 1 : -1), f[4] = {q(0), q(0), neg_q(slope), slope};
        put_hermite_graph(s, r(1, n + 1), r(1, n), f, SVG_CURVE);
    }
    for (int n = 1; n <= 4; n++) {
        num_q x = r(1, n), rise = mul_q(r(n % 2 == 0 ? 1 : -1, 1), r(1, 14)), run = r(1, 14);
        svg_segment(s, at(sub_q(x, run), neg_q(rise)), at(add_q(x, run), rise), SVG_MUTED);
    }
    svg_mark(s, svg_at(0, 0), SVG_WRONG, SVG_USUAL);
    svg_legend_line(s, SVG_CURVE, "$f$");
    svg_legend_line(s, SVG_MUTED, "tangents of slope 1 and $-1$");
    svg_legend_mark(s, SVG_WRONG, SVG_USUAL, "$f'=0$ from the right and from the left");
    return s;
}

FIGURE(upright_cube_root)
{
    svg *s = svg_new("upright_cube_root", "The graph of the cube root",
                     "A smooth curve with an upright tangent at the origin, where the function has no derivative; "
                     "chords from the origin become steeper without bound.");
    svg_panel(s, window(r(-6, 5), r(-6, 5), r(6, 5), r(6, 5)), 320, 0, "$y=x^{\\1/3}$, the curve $(s^3,s)$");
    svg_axes(s, q(1), q(1), "x", "y");
    num_q R[8] = {q(-1), q(-1), q(1), r(-1, 3), q(-1), r(1, 3), q(1), q(1)};
    svg_bezier(s, 3, R, SVG_CURVE);
    for (int k = 1; k <= 3; k++) {
        num_q y = r(1, k == 1 ? 1 : 2 * k - 2);
        svg_segment(s, svg_at(0, 0), at(mul_q(y, mul_q(y, y)), y), SVG_MUTED);
    }
    svg_arrow(s, svg_at(0, 0), svg_at(0, 1), SVG_RIGHT);
    svg_mark(s, svg_at(0, 0), SVG_WRONG, SVG_USUAL);
    svg_legend_line(s, SVG_CURVE, "the graph");
    svg_legend_line(s, SVG_MUTED, "chords, of slopes 1, 4, 16");
    svg_legend_line(s, SVG_RIGHT, "$P'(0)=(0,1)$");
    svg_legend_mark(s, SVG_WRONG, SVG_USUAL, "no derivative");
    return s;
}

FIGURE(proportional_derivatives)
{
    svg *s =
        svg_new("proportional_derivatives", "Proportional derivatives, and continuous curvature",
                "A parabola up to the origin with P' = (1, 0), P'' = (0, 1), and four second pieces: with Q'' = "
                "3 P''; with Q' = 2 P', Q'' = 2 P''; with Q'' = - P''; and the same parabola in another parameter, "
                "whose second derivative (1, 1) is not proportional.");
    static const char *const captions[4] = {"$Q\\'=P\\'$, $Q\\'\\'=3P\\'\\'$:\ncurvatures 1 and 3",
                                            "$Q\\'=2P\\'$, $Q\\'\\'=2P\\'\\'$:\ncurvatures 1 and 1/2",
                                            "$Q\\'=P\\'$, $Q\\'\\'=-P\\'\\'$:\ncurvatures 1 and $-1$",
                                            "$Q\\'=P\\'$, $Q\\'\\'=P\\'\\'+P\\'$:\none parabola"};
    /* Bézier points of Q = Q' u + Q'' u^2/2, in halves */
    static const int second[3][6] = {{0, 0, 1, 0, 2, 3}, {0, 0, 2, 0, 4, 2}, {0, 0, 1, 0, 2, -1}};
    static const int first[6] = {-2, 1, -1, 0, 0, 0};
    for (int k = 0; k < 4; k++) {
        svg_panel(s, window(r(-6, 5), r(-11, 10), r(8, 5), r(11, 5)), 172, 0, captions[k]);
        svg_circle(s, svg_at(0, 1), q(1), SVG_MUTED);
        if (k < 3)
            svg_circle(s,
                       at(q(0), k == 0   ? r(1, 3)
                                : k == 1 ? q(2)
                                         : q(-1)),
                       k == 0 ? r(1, 3) : q(k == 1 ? 2 : 1), SVG_FAMILY);
        put_bezier(s, 2, first, 2, SVG_CURVE);
        if (k == 3) {
            /* u + u^2/2 is of degree 2, so Q is of degree 4: Q = (phi, phi^2/2) */
            num_q power[5] = {q(0), q(1), r(1, 2), q(0), q(0)}, square[5] = {q(0), q(0), r(1, 2), r(1, 2), r(1, 8)},
                  R[10];
            bernstein_from_power_q(4, power, power);
            bernstein_from_power_q(4, square, square);
            for (int i = 0; i <= 4; i++)
                R[2 * i] = power[i], R[2 * i + 1] = square[i];
            svg_bezier(s, 4, R, SVG_RIGHT);
        } else {
            put_bezier(s, 2, second[k], 2, SVG_WRONG);
        }
        svg_mark(s, svg_at(0, 0), SVG_POINT, SVG_USUAL);
        svg_frame(s);
    }
    svg_legend_line(s, SVG_CURVE, "first piece");
    svg_legend_line(s, SVG_WRONG, "proportional, not $G^2$");
    svg_legend_line(s, SVG_RIGHT, "$G^2$, not proportional");
    svg_legend_line(s, SVG_MUTED, "circle of curvature before the joint");
    svg_legend_line(s, SVG_FAMILY, "and after it");
    return s;
}
