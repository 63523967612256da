/* Figures of the section on regular and singular points. */
#include "chapters/foundations/figures.h"

#include "exact/record/roots.h"

FIGURE(regular_double_point)
{
    svg *s = svg_new("regular_double_point", "A double point with two tangents, both of them regular",
                     "The loop (t squared minus 1, t cubed minus t).  It passes the origin at t = -1 and at t = 1, "
                     "with the derivatives "
                     "(-2, 2) and (2, 2).");
    const int coefficients[8] = {-1, 0, 0, -1, 1, 0, 0, 1};
    num_q c[8];
    integers(8, coefficients, c);
    svg_panel(s, window(r(-5, 4), r(-1, 1), q(1), q(1)), 360, 0, "$P(t)=(t^2-1,t^3-t)$");
    put_power_curve(s, 3, c, r(-3, 2), r(3, 2), SVG_CURVE);
    svg_arrow(s, svg_at(0, 0), at(r(1, 2), r(1, 2)), SVG_POINT);
    svg_arrow(s, svg_at(0, 0), at(r(-1, 2), r(1, 2)), SVG_POINT);
    svg_label(s, at(r(1, 2), r(1, 2)), SVG_SE, SVG_POINT, "P'(1)");
    svg_label(s, at(r(-1, 2), r(1, 2)), SVG_N, SVG_POINT, "P'(-1)");
    svg_mark(s, svg_at(0, 0), SVG_WRONG, SVG_USUAL);
    svg_legend_line(s, SVG_CURVE, "the curve");
    svg_legend_mark(s, SVG_WRONG, SVG_USUAL, "one point, two regular parameters");
    return s;
}

FIGURE(cusp_and_its_derivative)
{
    svg *s = svg_new(
        "cusp_and_its_derivative", "A cusp, and the derivative that passes zero without a jump",
        "Left the cubic with a cusp at (0.5, 0.75), with the limits of the direction before and after the cusp, up and "
        "down.  Right the derivative as a curve of its own, a parabola that passes the origin at t = 1/2: it is "
        "continuous.");
    const int coefficients[8] = {0, 0, 3, 3, -6, -3, 4, 0};
    num_q c[8], d[6];
    integers(8, coefficients, c);
    for (int m = 0; m < 6; m++)
        d[m] = mul_q(q(m / 2 + 1), c[m + 2]);
    svg_panel(s, window(r(-1, 10), r(-1, 10), r(11, 10), r(21, 20)), 340, 0, "the curve");
    svg_axes(s, r(1, 4), r(1, 4), "x", "y");
    put_power_curve(s, 3, c, q(0), q(1), SVG_CURVE);
    svg_arrow(s, at(r(1, 2), r(3, 4)), at(r(1, 2), r(19, 20)), SVG_POINT);
    svg_arrow(s, at(r(1, 2), r(3, 4)), at(r(1, 2), r(11, 20)), SVG_POINT);
    svg_note(s, at(r(1, 2), r(19, 20)), SVG_W, SVG_POINT, "before");
    svg_note(s, at(r(1, 2), r(11, 20)), SVG_S, SVG_POINT, "after");
    svg_mark(s, at(r(1, 2), r(3, 4)), SVG_RIGHT, SVG_USUAL);
    svg_label(s, at(r(1, 2), r(3, 4)), SVG_E, SVG_RIGHT, "P(1/2)");
    svg_panel(s, window(r(-1, 2), r(-7, 2), r(7, 2), r(7, 2)), 240, 0, "its derivative $P'(t)$");
    svg_axes(s, q(1), q(1), "x'", "y'");
    put_power_curve(s, 2, d, q(0), q(1), SVG_CURVE_2);
    svg_mark(s, svg_at(0, 0), SVG_RIGHT, SVG_USUAL);
    svg_label_at(s, svg_at(0, 0), SVG_END, -36, 68, SVG_RIGHT, "P'(1/2)");
    svg_legend_line(s, SVG_CURVE, "the curve");
    svg_legend_line(s, SVG_CURVE_2, "its derivative");
    svg_legend_mark(s, SVG_RIGHT, SVG_USUAL, "the cusp");
    return s;
}

/* (t, 10 t^3 - 15 t^2 + 6 t) */
static svg_point phi(num_q t, const void *data)
{
    (void)data;
    num_q value = mul_q(t, add_q(q(6), mul_q(t, add_q(q(-15), mul_q(q(10), t)))));
    return at(t, value);
}

FIGURE(one_line_two_parameters)
{
    svg *s = svg_new(
        "one_line_two_parameters", "One segment, run through in two ways",
        "The place on the segment x = y against the parameter: the natural parameter goes forward all the way; the "
        "cubic parameter goes forward to its first singular point, back to its second one, and forward again.");
    svg_panel(s, window(q(0), q(0), q(1), q(1)), 340, 0, "the place $x=y$ against $t$");
    svg_axes(s, r(1, 4), r(1, 4), "t", "x");
    svg_segment(s, svg_at(0, 0), svg_at(1, 1), SVG_CURVE_2);
    svg_plot(s, phi, NULL, q(0), q(1), 48, SVG_CURVE);
    num_q slope[3] = {q(6), q(-30), q(30)};
    struct cagd_root found[2];
    int count = isolate_roots(poly_from_q(3, slope), q(0), q(1), found, 2);
    static const char *const names[2] = {"t_1", "t_2"};
    for (int k = 0; k < count; k++) {
        struct cagd_root fine = refine_root(found[k], r(1, 1000000));
        svg_point P = phi(mul_q(r(1, 2), add_q(fine.lo, fine.hi)), NULL);
        svg_mark(s, P, SVG_WRONG, SVG_USUAL);
        svg_label(s, P, k ? SVG_S : SVG_N, SVG_WRONG, names[k]);
    }
    svg_legend_line(s, SVG_CURVE_2, "$x=y=t$");
    svg_legend_line(s, SVG_CURVE, "$x=y=φ(t)$");
    svg_legend_mark(s, SVG_WRONG, SVG_USUAL, "the singular points");
    return s;
}

/* (t, 4t^3 - 6t^2 + 3t) */
static svg_point standing(num_q t, const void *data)
{
    (void)data;
    num_q slope = add_q(q(3), mul_q(t, add_q(q(-6), mul_q(q(4), t))));
    return at(t, mul_q(t, slope));
}

FIGURE(singular_point_of_a_segment)
{
    svg *s = svg_new("singular_point_of_a_segment", "A segment with a singular point that is not seen",
                     "Left the place on the segment x = y against the parameter: it stands still for t = 1/2 and goes "
                     "forward before and after.  Right the curve: a segment, with the points of the parameters t = 0, "
                     "1/4, ..., 1.");
    svg_panel(s, window(q(0), q(0), q(1), q(1)), 300, 0, "the place $x=y$ against $t$");
    svg_axes(s, r(1, 4), r(1, 4), "t", "x");
    svg_plot(s, standing, NULL, q(0), q(1), 32, SVG_CURVE);
    svg_mark(s, at(r(1, 2), r(1, 2)), SVG_WRONG, SVG_USUAL);
    svg_panel(s, window(r(-1, 10), r(-1, 10), r(11, 10), r(11, 10)), 300, 0, "the curve");
    svg_segment(s, svg_at(0, 0), svg_at(1, 1), SVG_CURVE);
    for (int k = 0; k <= 4; k++) {
        num_q place = standing(r(k, 4), NULL).y;
        svg_mark(s, at(place, place), k == 2 ? SVG_WRONG : SVG_POINT, SVG_USUAL);
    }
    svg_legend_line(s, SVG_CURVE, "$x=y=φ_1(t)$");
    svg_legend_mark(s, SVG_WRONG, SVG_USUAL, "the singular point");
    return s;
}
