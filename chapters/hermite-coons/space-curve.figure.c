/* Figures of the section on a space curve and two cylinders. */
#include "chapters/hermite-coons/drawing.h"

/* The point (cos, sin, +-sin) of an ellipse, half of it by the parameter of the circle; drawn in a parallel projection. */
struct ellipse {
    int sign, half;
};
static svg_point seen(num_q x, num_q y, num_q z)
{
    return at(add_q(y, mul_q(r(-1, 2), x)), add_q(z, mul_q(r(-1, 8), x)));
}
static svg_point on_ellipse(num_q t, const void *data)
{
    const struct ellipse *e = data;
    num_q tt = mul_q(t, t), below = add_q(q(1), tt);
    num_q x = mul_q(q(e->half), div_q(sub_q(q(1), tt), below)), y = div_q(mul_q(q(2), t), below);
    return seen(x, y, mul_q(q(e->sign), y));
}
/* A circle of the cylinder x^2 + y^2 = 1 (along_z) or x^2 + z^2 = 1 at the height `level`. */
struct ring {
    int along_z, half;
    num_q level;
};
static svg_point on_ring(num_q t, const void *data)
{
    const struct ring *c = data;
    num_q tt = mul_q(t, t), below = add_q(q(1), tt);
    num_q x = mul_q(q(c->half), div_q(sub_q(q(1), tt), below)), y = div_q(mul_q(q(2), t), below);
    return c->along_z ? seen(x, y, c->level) : seen(x, c->level, y);
}

/* A half of the circle x^2 + y^2 + z^2 = 2, x + y + z = 0, without a plane, or of the ellipse that two of the cylinders
 * over its projections also have in common, in the plane where the coordinates other than `plane` are equal.  Both have
 * two coordinates with a^2 + ab + b^2 = 1: with 1 - t + t^2 below, these are t^2 - 1 and 2t - t^2, or 1 - t^2 and 2t - 1. */
struct common {
    int plane, half;
};
static svg_point seen_from_below(const num_q x[3])
{
    return at(sub_q(x[1], div_q(x[0], q(3))), add_q(x[2], div_q(x[0], q(3))));
}
static svg_point on_common(num_q t, const void *data)
{
    const struct common *c = data;
    num_q x[3], tt = mul_q(t, t), twice = mul_q(q(2), t), below = add_q(sub_q(q(1), t), tt);
    num_q a = div_q(mul_q(q(c->half), sub_q(q(1), tt)), below);
    num_q b = div_q(c->half > 0 ? sub_q(twice, q(1)) : sub_q(twice, tt), below);
    int first = c->plane < 0 ? 0 : c->plane;
    x[first] = a;
    x[(first + 1) % 3] = b;
    x[(first + 2) % 3] = c->plane < 0 ? neg_q(add_q(a, b)) : b;
    return seen_from_below(x);
}

FIGURE(two_cylinders)
{
    svg *s =
        svg_new("two_cylinders", "Two cylinders and what they have in common",
                "Left, the cylinders over the projections of the ellipse z = y meet in two ellipses; the point "
                "(0, 1, -1) is on both cylinders and not on the ellipse.  Right, the circle x² + y² + z² = 2 in the "
                "plane x + y + z = 0 with the three ellipses of which two of its three cylinders always hold one more; "
                "the points (1, 0, 0), (0, 1, 0), (0, 0, 1) are on them.");
    svg_panel(s, window(r(-8, 5), r(-3, 2), r(8, 5), r(3, 2)), 350, 0, "the ellipse of $x^2+y^2=1$, $z=y$");
    for (int along_z = 0; along_z < 2; along_z++)
        for (int half = -1; half <= 1; half += 2)
            for (int level = -2; level <= 2; level++) {
                struct ring c = {along_z, half, r(level, 2)}; /* heights from -1 to 1 */
                svg_plot(s, on_ring, &c, q(-1), q(1), 8, SVG_FAMILY);
            }
    for (int half = -1; half <= 1; half += 2) {
        struct ellipse curve = {1, half}, other = {-1, half};
        svg_plot(s, on_ellipse, &curve, q(-1), q(1), 8, SVG_CURVE);
        svg_plot(s, on_ellipse, &other, q(-1), q(1), 8, SVG_WRONG);
    }
    svg_point extra = seen(q(0), q(1), q(-1));
    svg_mark(s, extra, SVG_WRONG, SVG_USUAL);
    svg_label(s, extra, SVG_SE, SVG_WRONG, "(0,1,-1)");
    svg_panel(s, window(r(-8, 5), r(-8, 5), r(8, 5), r(8, 5)), 330, 0, "the circle of $x^2+y^2+z^2=2$, $x+y+z=0$");
    for (int plane = -1; plane < 3; plane++)
        for (int half = -1; half <= 1; half += 2) {
            struct common curve = {plane, half};
            svg_plot(s, on_common, &curve, q(-1), q(1), 8, plane < 0 ? SVG_CURVE : SVG_WRONG);
        }
    static const char *const corner[3] = {"(1,0,0)", "(0,1,0)", "(0,0,1)"};
    static const enum svg_direction beside[3] = {SVG_SE, SVG_E, SVG_S};
    for (int k = 0; k < 3; k++) {
        num_q x[3] = {q(k == 0), q(k == 1), q(k == 2)};
        svg_mark(s, seen_from_below(x), SVG_WRONG, SVG_USUAL);
        svg_label(s, seen_from_below(x), beside[k], SVG_WRONG, corner[k]);
    }
    svg_legend_line(s, SVG_CURVE, "the curve");
    svg_legend_line(s, SVG_WRONG, "also on two of its cylinders");
    svg_legend_line(s, SVG_FAMILY, "circles of the cylinders");
    return s;
}
