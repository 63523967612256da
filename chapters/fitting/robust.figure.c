#include "chapters/judge/figure.h"
#include "exact/record/number.h"
#include "figures/words.h"

/* The pull rho'(r^2) r at the distance r for a = 1: squares, Huber, Cauchy. */
static svg_point pull(num_q x, const void *data)
{
    const int *loss = data;
    num_q one = from_int_q(1), y = x;
    if (*loss == 1 && compare_q(x, one) > 0)
        y = one;
    if (*loss == 2)
        y = div_q(x, add_q(one, mul_q(x, x)));
    return (svg_point){x, y};
}

/* exp(2 F/a^2) = (1 + (x-3)^2/a^2)(1 + (x+3)^2/a^2), which has its minima where F has them, over its value at 0. */
static svg_point cost(num_q x, const void *data)
{
    const num_q *aa = data;
    num_q three = from_int_q(3), one = from_int_q(1), left = sub_q(x, three), right = add_q(x, three);
    num_q at_zero = add_q(one, div_q(from_int_q(9), *aa));
    num_q value = mul_q(add_q(one, div_q(mul_q(left, left), *aa)), add_q(one, div_q(mul_q(right, right), *aa)));
    return (svg_point){x, div_q(value, mul_q(at_zero, at_zero))};
}

FIGURE(robust_losses)
{
    static const int squares = 0, huber = 1, cauchy = 2;
    num_q small = from_int_q(1), large = from_int_q(16), zero = from_int_q(0), four = from_int_q(4);
    svg *s = svg_new(
        "robust_losses", "Losses: the pull of a point, and its price",
        "Left the pull of a point on the curve over its distance: without end for squares, constant beyond 1 for "
        "Huber's loss, fading for Cauchy's.  Right the cost of fitting one number to -3 and 3 with Cauchy's loss: two "
        "minima for the scale 1, one for the scale 4.");
    svg_panel(s, (svg_window){zero, zero, four, from_int_q(2)}, 360, 220,
              "the pull of a point at the distance $r$, $a = 1$");
    svg_axes(s, small, r(1, 2), "r", NULL);
    svg_plot(s, pull, &squares, zero, four, 4, SVG_CURVE_2);
    svg_plot(s, pull, &huber, zero, four, 8, SVG_CURVE);
    svg_plot(s, pull, &cauchy, zero, four, 16, SVG_RIGHT);
    svg_frame(s);
    svg_panel(s, (svg_window){from_int_q(-5), zero, from_int_q(5), from_int_q(3)}, 360, 220,
              "fitting $x$ to $-3$ and $3$: $\\e\\x\\p(2F/a^2)$ over its value at 0");
    svg_axes(s, from_int_q(3), small, "x", NULL);
    svg_plot(s, cost, &small, from_int_q(-5), from_int_q(5), 24, SVG_WRONG);
    svg_plot(s, cost, &large, from_int_q(-5), from_int_q(5), 24, SVG_RIGHT);
    svg_frame(s);
    svg_legend_line(s, SVG_CURVE_2, "squares");
    svg_legend_line(s, SVG_CURVE, "Huber");
    svg_legend_line(s, SVG_RIGHT, "Cauchy; right with $a = 4$");
    svg_legend_line(s, SVG_WRONG, "Cauchy with $a = 1$: two minima");
    return s;
}
