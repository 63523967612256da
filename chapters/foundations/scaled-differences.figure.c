/* The figure of the section on the table in a machine. */
#include "chapters/foundations/figures.h"
#include "exact/record/number.h"

#include "core/kernels/kernels_d.h"

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
