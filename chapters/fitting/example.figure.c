#include "chapters/fitting/circle.h"
#include "chapters/judge/figure.h"
#include "chapters/judge/figure_data.h"
#include "figures/words.h"

/* The example as its claim has it. */
static struct circle_example circle_of_pairs(void)
{
    static const char owner[] = "pairs_about_a_circle_have_the_circle_as_minimum";
    struct circle_example E;
    data_of(owner, "R", 3, 2, E.R);
    data_of(owner, "ω", 3, 1, E.w);
    data_of(owner, "places", PAIRS, 2, E.place);
    data_of(owner, "share", 1, 1, &E.share);
    put_pairs(&E);
    return E;
}

static void put_circle(svg *s, const struct circle_example *E)
{
    svg_control_polygon(s, 2, E->R, "P");
    svg_rational(s, 2, E->R, E->w, SVG_CURVE);
}

/* The measured points, each joined to the point of the curve at its parameter. */
static void put_points(svg *s, const struct circle_example *E, enum svg_role colour)
{
    for (int i = 0; i < 2 * PAIRS; i++) {
        num_q C[2];
        rational_point_q(2, 2, E->R, E->w, E->t[i], C);
        svg_segment(s, svg_pair(E->Q + 2 * i), svg_pair(C), colour);
        svg_mark(s, svg_pair(C), colour, SVG_DISC);
    }
    for (int i = 0; i < 2 * PAIRS; i++)
        svg_mark(s, svg_pair(E->Q + 2 * i), SVG_POINT, SVG_RING);
}

FIGURE(feet_and_parameters)
{
    struct circle_example E = circle_of_pairs();
    svg_window window = svg_integer_window(-4, -4, 74, 74);
    svg *s =
        svg_new("feet_and_parameters", "Points, their feet, and given parameters",
                "A quarter of a circle with eight pairs of measured points.  Left every point is joined to its "
                "foot, at right angles to the circle.  Right every pair is joined to the point of the circle whose "
                "parameter is an even fraction of the whole: the segments are oblique.");
    svg_panel(s, window, 370, 0, "feet: the residuals of a pair cancel,\nthe circle is the minimum");
    put_circle(s, &E);
    put_points(s, &E, SVG_RIGHT);
    num_q t[PAIRS];
    data_of("given_parameters_find_the_same_curve", "t", PAIRS, 1, t);
    for (int i = 0; i < 2 * PAIRS; i++)
        E.t[i] = t[i / 2];
    svg_panel(s, window, 370, 0,
              "parameters $1/9, ..., 8/9$: the residuals point along\nthe circle, and pull it elsewhere");
    put_circle(s, &E);
    put_points(s, &E, SVG_WRONG);
    svg_legend_mark(s, SVG_POINT, SVG_RING, "measured points");
    svg_legend_line(s, SVG_RIGHT, "to the foot");
    svg_legend_line(s, SVG_WRONG, "to the point of the given parameter");
    return s;
}

/* level - x^T M x, M a symmetric 2 by 2 matrix in axes of the figure. */
struct quadratic {
    num_q M[3], level;
};
static num_q below_level(svg_point at, const void *data)
{
    const struct quadratic *f = data;
    num_q value = add_q(mul_q(f->M[0], mul_q(at.x, at.x)), mul_q(f->M[2], mul_q(at.y, at.y)));
    value = add_q(value, mul_q(from_int_q(2), mul_q(f->M[1], mul_q(at.x, at.y))));
    return sub_q(f->level, value);
}

/* The 95 % intervals: 2.160369 is t of 13 degrees of freedom, and the mean square of the residuals is 16 (65/16)^2/13. */
FIGURE(weight_and_point_confidence)
{
    struct circle_example E = circle_of_pairs();
    num_q gradient[UNKNOWNS], H[UNKNOWNS * UNKNOWNS], A[UNKNOWNS * UNKNOWNS];
    derivatives_of_circle(&E, gradient, H, A);
    num_q t = r(2160369, 1000000), level = mul_q(mul_q(t, t), r(65 * 65, 16 * 13));
    /* of lambda_1 and d, the shift of P_1 along the bisector: x_1 and y_1 shift alike */
    num_q lambda = inverse_entry(A, 0, 0), both = inverse_entry(A, 0, 1), zero = from_int_q(0);
    num_q shift = mul_q(r(1, 2), add_q(inverse_entry(A, 1, 1), inverse_entry(A, 1, 2)));
    num_q det = sub_q(mul_q(lambda, shift), mul_q(both, both));
    struct quadratic region = {{div_q(shift, det), div_q(neg_q(both), det), div_q(lambda, det)}, level};
    struct quadratic alone = {{div_q(from_int_q(1), lambda), zero, zero}, level};
    struct quadratic given = {{A[0], zero, zero}, level};
    svg *s = svg_new(
        "weight_and_point_confidence", "What is known of the weight and of its point",
        "The region of confidence of the logarithm of the weight and of the place of the middle point of the "
        "example is a thin oblique ellipse; the interval of the weight alone is its shadow, and the interval for a "
        "given point is the small piece that the axis cuts off.");
    svg_panel(s, (svg_window){from_int_q(-3), from_int_q(-60), from_int_q(3), from_int_q(60)}, 460, 330,
              "95 % intervals of $λ_1$, and the region of $λ_1$ and the shift $d$\nof $P_1 = (65 + d, 65 + d)$ whose "
              "shadow is the wider one");
    svg_axes(s, from_int_q(1), from_int_q(20), "λ_1", "d");
    svg_region(s, below_level, &region, 300, SVG_FILL);
    svg_implicit(s, below_level, &region, 300, SVG_CURVE);
    svg_implicit(s, below_level, &alone, 120, SVG_CURVE_2);
    svg_implicit(s, below_level, &given, 120, SVG_RIGHT);
    svg_frame(s);
    svg_legend_line(s, SVG_CURVE, "both together");
    svg_legend_line(s, SVG_CURVE_2, "$P_1$ free");
    svg_legend_line(s, SVG_RIGHT, "$P_1$ given");
    return s;
}
