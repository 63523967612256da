#include "chapters/rational-bezier/envelope-figures.h"

FIGURE(envelope_families)
{
    svg *s =
        svg_new("envelope_families", "A curve touches the members of its families",
                "A rational cubic with the points (0, 0), (1, 3), (4, 3), (5, 0) and weights 1, 2, 1, 1.  Left the "
                "quadratic members r = 1, right the linear members r = 2, for eleven values of c; each touches the "
                "cubic in the point of parameter c.");
    static const int points[8] = {0, 0, 1, 3, 4, 3, 5, 0};
    num_q R[8], w[4] = {q(1), q(2), q(1), q(1)}, P[2];
    integers(8, points, R);
    rational_point_q(3, 2, R, w, r(2, 5), P);
    for (int level = 1; level <= 2; level++) {
        svg_panel(s, window(r(-1, 2), r(-1, 2), r(11, 2), r(7, 2)), 330, 0,
                  level == 1 ? "$r=1$: members of degree 2" : "$r=2$: members of degree 1, the tangents");
        svg_control_polygon(s, 3, R, "R");
        put_family(s, 3, R, w, level, 10);
        put_member(s, 3, R, w, level, r(2, 5), SVG_CURVE_2);
        svg_rational(s, 3, R, w, SVG_CURVE);
        svg_mark(s, svg_pair(P), SVG_POINT, SVG_USUAL);
        svg_label(s, svg_pair(P), SVG_S, SVG_POINT, "R(c)");
    }
    svg_legend_line(s, SVG_CURVE, "the cubic");
    svg_legend_line(s, SVG_CURVE_2, "the member of $c=2/5$");
    svg_legend_line(s, SVG_FAMILY, "other members");
    return s;
}

FIGURE(envelope_cusp)
{
    svg *s = svg_new("envelope_cusp", "At a cusp the tangent member is a point",
                     "The cubic (τ², τ³) for τ from -1 to 1 and its members r = 2.  They are segments of its tangents; "
                     "at the cusp, the origin, the member shrinks to a point.");
    static const int points[8] = {3, -3, -1, 3, -1, -3, 3, 3};
    num_q R[8], w[4];
    fractions(8, points, 3, R);
    ones(3, w);
    svg_panel(s, window(r(-3, 5), r(-6, 5), r(6, 5), r(6, 5)), 290, 0,
              "$(τ^2,τ^3)$, $r=2$: the cusp\nis at $τ=0$, that is $c=1/2$");
    svg_control_polygon(s, 3, R, "R");
    put_family(s, 3, R, w, 2, 16);
    svg_bezier(s, 3, R, SVG_CURVE);
    svg_mark(s, svg_at(0, 0), SVG_WRONG, SVG_USUAL);
    svg_label(s, svg_at(0, 0), SVG_W, SVG_WRONG, "R^{[1]}(t,c)");
    svg_legend_line(s, SVG_CURVE, "the cubic");
    svg_legend_line(s, SVG_FAMILY, "members of degree 1");
    svg_legend_mark(s, SVG_WRONG, SVG_USUAL, "the member of the cusp: no tangent");
    return s;
}
