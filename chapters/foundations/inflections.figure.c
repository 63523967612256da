/* Figures of the section on inflections and curvature. */
#include "chapters/foundations/figures.h"

/* (t, K) of (3t, 3t^2, 2t^3) with the speed 3 + 6t^2 below, or, as printed, with the length 3t + 2t^3. */
static svg_point curvature_at(num_q t, const void *data)
{
    num_q tt = mul_q(t, t), top = mul_q(q(18), add_q(q(1), mul_q(q(2), tt)));
    num_q below = data != NULL ? mul_q(t, add_q(q(3), mul_q(q(2), tt))) : add_q(q(3), mul_q(q(6), tt));
    return at(t, div_q(top, mul_q(below, mul_q(below, below))));
}

FIGURE(curvature_and_the_speed)
{
    static const int printed = 1;
    svg *s =
        svg_new("curvature_and_the_speed", "The curvature, and the quotient with the length of the arc",
                "The twisted cubic (3t, 3t squared, 2t cubed) on [0, 1]: its curvature falls from 2/3 to 2/27.  The "
                "printed quotient, with the length of the arc from t = 0 in the place of the speed, falls from "
                "infinity to 54/125.");
    svg_panel(s, window(q(0), q(0), q(1), q(2)), 420, 260, NULL);
    svg_axes(s, r(1, 4), r(1, 2), "t", "K");
    svg_plot(s, curvature_at, NULL, q(0), q(1), 48, SVG_RIGHT);
    svg_plot(s, curvature_at, &printed, r(1, 4), q(1), 48, SVG_WRONG);
    svg_mark(s, at(q(1), r(2, 27)), SVG_RIGHT, SVG_USUAL);
    svg_label(s, at(q(1), r(2, 27)), SVG_N, SVG_RIGHT, "2/27");
    svg_mark(s, at(q(1), r(54, 125)), SVG_WRONG, SVG_USUAL);
    svg_label(s, at(q(1), r(54, 125)), SVG_E, SVG_WRONG, "54/125");
    svg_legend_line(s, SVG_RIGHT, "with the speed");
    svg_legend_line(s, SVG_WRONG, "with the length of the arc");
    return s;
}

/* (t, torsion) of (t, t^2, t^3): 12 over the square of the vector product. */
static svg_point torsion_of_powers(num_q t, const void *data)
{
    num_q tt = mul_q(t, t), square = mul_q(q(36), mul_q(tt, tt));
    (void)data;
    return at(t, div_q(q(12), add_q(square, add_q(mul_q(q(36), tt), q(4)))));
}

FIGURE(derivatives_with_lost_dots)
{
    svg *s =
        svg_new("derivatives_with_lost_dots", "A second derivative in the place of the third",
                "Left the second derivative of t squared, which is 2, and 6A, which is 0.  Right the torsion of (t, "
                "t squared, t cubed), which is 3 at t = 0, and the quotient with the second derivative twice, which "
                "is 0 everywhere.");
    for (int panel = 0; panel < 2; panel++) {
        svg_panel(s, window(q(0), r(-1, 4), q(1), q(panel ? 3 : 2)), 240, 220, panel ? "the torsion" : "$P(t)=t^2$");
        svg_axes(s, q(1), q(1), "t", NULL);
        if (panel)
            svg_plot(s, torsion_of_powers, NULL, q(0), q(1), 48, SVG_RIGHT);
        else
            svg_segment(s, svg_at(0, 2), svg_at(1, 2), SVG_RIGHT);
        svg_segment(s, svg_at(0, 0), svg_at(1, 0), SVG_WRONG);
    }
    svg_legend_line(s, SVG_RIGHT, "$P''$, and the torsion");
    svg_legend_line(s, SVG_WRONG, "$6A$, and twice $P''$");
    return s;
}
