/* The figure of the section on the chain of the variation diminishing property. */
#include "chapters/rational-bezier/polygon.h"

/* sum b_i B_i^n as a graph over t. */
static svg_point over_t(num_q t, const void *data)
{
    const struct polygon *p = data;
    num_q y[LARGEST + 1], value;
    for (int i = 0; i <= p->n; i++)
        y[i] = p->R[2 * i + 1];
    bezier_casteljau_q(p->n, 1, y, t, &value);
    return (svg_point){t, value};
}

/* sum C(n,i) b_i s^i as a graph over s. */
static svg_point over_s(num_q s, const void *data)
{
    const struct polygon *p = data;
    num_q sum = from_int_q(0);
    for (int i = p->n; i >= 0; i--)
        sum = add_q(mul_q(sum, s), mul_q(from_int_q(binomial(p->n, i)), p->R[2 * i + 1]));
    return (svg_point){s, sum};
}

FIGURE(roots_and_the_substitution)
{
    svg *s = svg_new(
        "roots_and_the_substitution", "The roots in 0 < t < 1 and the roots s > 0",
        "Left: a cubic polynomial over t from 0 to 1 with the three roots 1/3, 1/2, 2/3. Right: the polynomial of "
        "the same coefficients in s = t/(1-t), with the roots 1/2, 1 and 2.");
    /* (2s - 1)(s - 1)(s - 2) = 2 s^3 - 7 s^2 + 7 s - 2, divided by the binomial coefficients, times 3 */
    static const long point[] = {0, -6, 0, 7, 0, -7, 0, 6}, weight[] = {1, 1, 1, 1};
    struct polygon p = polygon_of(3, point, weight);
    num_q zero = from_int_q(0), one = from_int_q(1), half = from_ratio_q(1, 2), five_halves = from_ratio_q(5, 2);
    svg_panel(s, (svg_window){zero, neg_q(one), one, one}, 300, 200,
              "three roots in $0 < t < 1$; with the range\n$0 < t < l$, $l = 1/2$, only one is left");
    svg_axes(s, from_ratio_q(1, 4), one, "t", "y");
    svg_plot(s, over_t, &p, zero, one, 32, SVG_CURVE);
    static const long root[3][2] = {{1, 3}, {1, 2}, {2, 3}};
    for (int k = 0; k < 3; k++)
        svg_mark(s, (svg_point){from_ratio_q(root[k][0], root[k][1]), zero}, k == 0 ? SVG_RIGHT : SVG_WRONG, SVG_USUAL);
    svg_segment(s, (svg_point){half, neg_q(one)}, (svg_point){half, one}, SVG_WRONG);
    svg_label(s, (svg_point){half, one}, SVG_E, SVG_WRONG, "t=l");
    svg_panel(s, (svg_window){zero, from_int_q(-3), five_halves, from_int_q(3)}, 300, 200,
              "three roots $s > 0$, $s = t/(1-t)$: as many as\nthe coefficients have changes of sign");
    svg_axes(s, half, one, "s", NULL);
    svg_plot(s, over_s, &p, zero, five_halves, 32, SVG_CURVE);
    static const long image[3][2] = {{1, 2}, {1, 1}, {2, 1}};
    for (int k = 0; k < 3; k++)
        svg_mark(s, (svg_point){from_ratio_q(image[k][0], image[k][1]), zero}, SVG_RIGHT, SVG_USUAL);
    return s;
}
