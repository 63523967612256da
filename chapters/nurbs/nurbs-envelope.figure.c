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
                bspline_blossom_q(on_span_q(3, 3, c.u, mu, c.H), x, H + 3 * i);
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
