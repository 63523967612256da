/* Figures of the section on the points of a cubic. */
#include "chapters/foundations/figures.h"
#include "exact/record/number.h"

#include "core/kernels/kernels_d.h"

FIGURE(infinite_slope_and_two_values)
{
    svg *s = svg_new("infinite_slope_and_two_values", "A curve with a vertical tangent and two values",
                     "The parabola ((2t-1) squared, t).  Over x = 1/4 it has two points, and at t = 1/2 its slope is "
                     "infinite, while "
                     "its derivative with respect to t is (0, 1).");
    const int coefficients[6] = {1, 0, -4, 1, 4, 0};
    num_q c[6];
    integers(6, coefficients, c);
    svg_panel(s, window(r(-1, 4), r(-1, 10), r(5, 4), r(11, 10)), 360, 0, "$P(t)=((2t-1)^2,t)$");
    svg_axes(s, r(1, 4), r(1, 4), "x", "y");
    svg_segment(s, at(r(1, 4), r(-1, 10)), at(r(1, 4), r(11, 10)), SVG_MUTED);
    put_power_curve(s, 2, c, q(0), q(1), SVG_CURVE);
    svg_arrow(s, at(q(0), r(1, 2)), at(q(0), r(9, 10)), SVG_POINT);
    svg_label(s, at(q(0), r(9, 10)), SVG_E, SVG_POINT, "P'");
    for (int k = 1; k <= 3; k += 2)
        svg_mark(s, at(r(1, 4), r(k, 4)), SVG_POINT, SVG_USUAL);
    svg_legend_line(s, SVG_CURVE, "the curve");
    svg_legend_line(s, SVG_MUTED, "$x=1/4$");
    return s;
}

FIGURE(forward_differences)
{
    svg *s = svg_new("forward_differences", "A table of forward differences",
                     "A cubic at equidistant parameters.  The first forward difference leads from a point to the next "
                     "one; the printed "
                     "one, with t - delta, leads back.");
    const int coefficients[8] = {0, 0, 3, 4, 0, -9, 0, 6};
    num_q c[8];
    integers(8, coefficients, c);
    svg_panel(s, window(r(-1, 4), r(-1, 4), r(13, 4), r(3, 2)), 560, 0, "$δ=1/4$");
    put_power_curve(s, 3, c, q(0), q(1), SVG_CURVE);
    static const char *const names[5] = {"P_0", "P_1", "P_2", "P_3", "P_4"};
    for (int k = 0; k <= 4; k++) {
        svg_point P = power_curve_point(3, c, r(k, 4));
        svg_mark(s, P, SVG_POINT, SVG_USUAL);
        svg_label(s, P, k == 0 ? SVG_W : k < 3 ? SVG_N : k == 3 ? SVG_S : SVG_E, SVG_POINT, names[k]);
    }
    svg_arrow(s, power_curve_point(3, c, r(1, 4)), power_curve_point(3, c, r(2, 4)), SVG_RIGHT);
    svg_arrow(s, power_curve_point(3, c, r(1, 4)), power_curve_point(3, c, q(0)), SVG_WRONG);
    svg_legend_line(s, SVG_CURVE, "the cubic");
    svg_legend_line(s, SVG_RIGHT, "$ΔP_1=P(t+δ)-P(t)$");
    svg_legend_line(s, SVG_WRONG, "$P(t-δ)-P(t)$, as printed");
    return s;
}

/* The base-two logarithm of |x|, rounded down; 0 for x = 0. */
static long log2_of(num_q x)
{
    long k = 0;
    num_q size = sign_q(x) < 0 ? neg_q(x) : x;
    if (is_zero_q(size))
        return 0;
    for (; compare_q(size, q(2)) >= 0; k++)
        size = mul_q(size, r(1, 2));
    return k;
}

FIGURE(stepping_and_rounding)
{
    svg *s = svg_new(
        "stepping_and_rounding", "What rounding does to a table of differences",
        "The error of the point after i of n steps along 1 + t cubed in binary64, in bits, that is the logarithm of "
        "the "
        "error in units of 2 to the -53.  For n = 1000 it grows with the cube of the number of steps; for n = 1024 "
        "there is none.");
    svg_panel(s, window(q(0), q(0), q(1000), q(30)), 480, 280, "bits of error after $i$ steps, $P(t)=1+t^3$");
    svg_axes(s, q(250), q(10), "i", NULL);
    static const int pieces[2] = {1000, 1024};
    static const enum svg_role roles[2] = {SVG_WRONG, SVG_RIGHT};
    for (int k = 0; k < 2; k++) {
        double c[4] = {1, 0, 0, 1}, d[4];
        num_q points[2 * 251];
        int count = 0;
        power_differences_d(3, 1, c, 1.0 / pieces[k], d);
        for (int i = 0; i <= 1000; i++, power_difference_step_d(3, 1, d))
            if (i % 4 == 0) {
                num_q t = r(i, pieces[k]), error = sub_q(from_double_q(d[0]), add_q(q(1), mul_q(t, mul_q(t, t))));
                points[2 * count] = q(i);
                points[2 * count++ + 1] = q(log2_of(mul_q(error, from_double_q(0x1p53))));
            }
        svg_polyline(s, count, points, roles[k]);
    }
    svg_legend_line(s, SVG_WRONG, "step $1/1000$");
    svg_legend_line(s, SVG_RIGHT, "step $1/1024$: no error");
    return s;
}

FIGURE(degrees_two_and_three)
{
    svg *s = svg_new("degrees_two_and_three", "What a quadratic curve is, and what it is not",
                     "The parabola (t, t squared) is a polynomial curve of degree two, and bends to one side.  A cubic "
                     "is the first that can bend to the other side: (t, t cubed) does so at t = 0.");
    const int coefficients[2][8] = {{0, 0, 1, 0, 0, 1, 0, 0}, {0, 0, 1, 0, 0, 0, 0, 1}};
    for (int panel = 0; panel < 2; panel++) {
        num_q c[8];
        integers(8, coefficients[panel], c);
        svg_panel(s, window(q(-1), q(-1), q(1), q(1)), 240, 0, panel ? "$(t,t^3)$" : "$(t,t^2)$");
        svg_axes(s, q(1), q(1), NULL, NULL);
        svg_line(s, at(r(panel ? 0 : -1, 2), panel ? q(0) : r(1, 4)), at(q(panel), q(0)), SVG_MUTED);
        if (!panel)
            svg_line(s, at(r(1, 2), r(1, 4)), at(r(1, 4), q(0)), SVG_MUTED);
        put_power_curve(s, 3, c, q(-1), q(1), SVG_CURVE);
        svg_mark(s, panel ? svg_at(0, 0) : at(r(-1, 2), r(1, 4)), SVG_POINT, SVG_USUAL);
        if (!panel)
            svg_mark(s, at(r(1, 2), r(1, 4)), SVG_POINT, SVG_USUAL);
    }
    svg_legend_line(s, SVG_CURVE, "the curve");
    svg_legend_line(s, SVG_MUTED, "tangents: on one side, and crossed");
    return s;
}
