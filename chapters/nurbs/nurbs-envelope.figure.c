/* nurbs-envelope.figure.c -- drawings for nurbs-envelope.claims.h. */
#include "chapters/nurbs/family-figures.h"

static struct nurbs rational_cubic(void)
{
    static const int knot[9] = {0, 0, 0, 0, 1, 2, 2, 2, 2};
    static const int point[15] = {-4, -2, 1, -3, 5, 1, 3, 8, 2, 10, 4, 1, 9, -3, 1};
    return nurbs_of(5, 3, knot, point, 1);
}

FIGURE(nurbs_envelope_families)
{
    svg *s =
        svg_new("nurbs_envelope_families", "A NURBS curve touches the members of its families",
                "A rational cubic spline with two spans, five points, clamped knots and weights 1, 1, 2, 1, 1.  On "
                "every span nine members: left conics, r = 1, right lines, r = 2.  Each touches the curve in the "
                "point of its parameter.");
    struct nurbs c = rational_cubic();
    num_q tau = r(3, 5);
    for (int level = 1; level <= 2; level++) {
        svg_panel(s, window(q(-5), q(-3), q(11), q(9)), 400, 0,
                  level == 1 ? "$k=4$, $r=1$: members of order 3" : "$r=2$: members of order 2, the lines");
        for (int mu = 3; mu < 5; mu++)
            put_family(s, &c, mu, level, 8);
        put_polygon(s, &c, "R");
        put_member(s, &c, 3, level, tau, SVG_CURVE_2);
        put_curve(s, &c, SVG_CURVE);
        svg_mark(s, point_of(&c, 4, c.u[4]), SVG_MUTED, SVG_USUAL);
        svg_mark(s, point_of(&c, 3, tau), SVG_POINT, SVG_USUAL);
    }
    svg_legend_line(s, SVG_CURVE, "the curve");
    svg_legend_line(s, SVG_CURVE_2, "the member of $τ=3/5$");
    svg_legend_line(s, SVG_FAMILY, "other members");
    svg_legend_mark(s, SVG_MUTED, SVG_USUAL, "the knot inside");
    svg_legend_mark(s, SVG_POINT, SVG_USUAL, "the point of contact");
    return s;
}

FIGURE(nurbs_envelope_whole)
{
    svg *s = svg_new(
        "nurbs_envelope_whole", "A member of the whole curve may run to infinity",
        "A quadratic curve with two spans.  Left the weights are 1: every polygon of the family touches the curve and "
        "goes on over the other span.  Right the last weight is 5: the leg of the polygon of the first parameter over "
        "the second span leaves in one direction and comes back from the other.");
    static const int knot[7] = {1, 2, 3, 4, 5, 6, 7};
    static const int point[2][12] = {{0, 0, 1, 1, 3, 1, 4, 3, 1, 5, 0, 1}, {0, 0, 1, 1, 3, 1, 4, 3, 1, 5, 0, 5}};
    for (int k = 0; k < 2; k++) {
        struct nurbs c = nurbs_of(4, 2, knot, point[k], 1);
        svg_window field = k == 0 ? window(r(-1, 4), r(-7, 10), r(21, 4), r(59, 10)) : window(q(-2), q(-6), q(8), q(6));
        svg_panel(s, field, 330, 0,
                  k == 0 ? "$k=3$, $r=1$, weights 1, 1, 1, 1:\nall polygons exist"
                         : "weights 1, 1, 1, 5:\n$w_3^{[1]}=1$ and $w_4^{[1]}=-1$ at $τ=t_3$");
        for (int i = 1; i < 8; i++)
            for (int mu = 2; mu < 4 && k == 0; mu++)
                put_member(s, &c, mu, 1, add_q(q(3), r(i, 4)), SVG_FAMILY);
        put_polygon(s, &c, NULL);
        put_curve(s, &c, SVG_CURVE);
        put_member(s, &c, 2, 1, q(3), SVG_CURVE_2);
        put_member(s, &c, 3, 1, q(3), k == 0 ? SVG_CURVE_2 : SVG_WRONG);
        svg_mark(s, point_of(&c, 2, q(3)), SVG_POINT, SVG_USUAL);
        svg_frame(s);
    }
    svg_legend_line(s, SVG_CURVE, "the curve");
    svg_legend_line(s, SVG_CURVE_2, "the polygon of $τ=t_3$");
    svg_legend_line(s, SVG_WRONG, "its leg, broken at infinity");
    svg_legend_line(s, SVG_FAMILY, "other polygons");
    return s;
}

FIGURE(nurbs_envelope_contact)
{
    svg *s = svg_new("nurbs_envelope_contact", "Curve and members touch, they do not osculate",
                     "One span of a curve of order 5 and its members of order 4, 3 and 2 at one parameter.  The lower "
                     "the order, the flatter the member; "
                     "the curvatures at the contact have the ratios 8/9, 2/3 and 0 to that of the curve.");
    static const int x[5] = {0, 1}, y[5] = {0, 0, 3, 0, 2};
    struct nurbs c = one_span(4, 1, x, y);
    svg_panel(s, window(q(-1), r(-1, 4), q(1), r(3, 2)), 560, 330,
              "$k=5$, $τ=0$: $κ_{k-r}/κ$ is 8/9, 2/3, 0 for $r=1,2,3$");
    svg_axes(s, r(1, 2), r(1, 2), "x", "y");
    put_member(s, &c, 4, 1, q(0), SVG_FAMILY);
    put_member(s, &c, 4, 2, q(0), SVG_CURVE_2);
    put_member(s, &c, 4, 3, q(0), SVG_RIGHT);
    put_curve(s, &c, SVG_CURVE);
    svg_mark(s, svg_at(0, 0), SVG_POINT, SVG_USUAL);
    svg_legend_line(s, SVG_CURVE, "the curve");
    svg_legend_line(s, SVG_FAMILY, "$r=1$");
    svg_legend_line(s, SVG_CURVE_2, "$r=2$");
    svg_legend_line(s, SVG_RIGHT, "$r=3$, the tangent");
    return s;
}

/* The same family, growing: the parameter goes through the two spans. */
FIGURE(nurbs_envelope_growing)
{
    svg *s = svg_new(
        "nurbs_envelope_growing", "The curve appears out of its family",
        "Four pictures of the rational cubic of two spans and of its members of order 3.  The parameter τ runs through "
        "a "
        "quarter, a half, three quarters and the whole of the domain; what was met before stays, the newest member is "
        "emphasized, and the curve is there as far as the members have come.");
    struct nurbs c = rational_cubic();
    static const char *const caption[] = {"$τ=1/2$", "$τ=1$", "$τ=3/2$", "$τ=2$"};
    for (int k = 1; k <= 4; k++) {
        svg_panel(s, window(q(-5), q(-3), q(11), q(9)), 220, 0, caption[k - 1]);
        put_polygon(s, &c, NULL);
        for (int m = 0; m < 6 * k; m++)
            put_member(s, &c, m < 12 ? 3 : 4, 1, r(m, 12), SVG_FAMILY);
        put_member(s, &c, k < 3 ? 3 : 4, 1, r(k, 2), SVG_CURVE_2);
        for (int mu = 3; mu < 5; mu++) { /* from the beginning of the span as far as k/2 */
            num_q H[12], R[8], w[4], from = c.u[mu], to = mu == 3 && k > 2 ? q(1) : r(k, 2), x[3];
            if (!(mu == 3 || k > 2))
                continue;
            for (int i = 0; i <= 3; i++) {
                for (int m = 0; m < 3; m++)
                    x[m] = m < 3 - i ? from : to;
                bspline_blossom_q(3, 3, c.u, mu, c.H, x, H + 3 * i);
            }
            rational_dehomogenize_q(3, 2, H, R, w);
            svg_rational(s, 3, R, w, SVG_CURVE);
        }
        svg_mark(s, point_of(&c, k < 3 ? 3 : 4, r(k, 2)), SVG_POINT, SVG_USUAL);
    }
    svg_legend_line(s, SVG_CURVE, "the curve up to $τ$");
    svg_legend_line(s, SVG_CURVE_2, "the member of $τ$");
    svg_legend_line(s, SVG_FAMILY, "the members before");
    return s;
}
