/* Figures of the section on crossings with a line. */
#include "chapters/rational-bezier/polygon.h"

static void draw(svg *s, struct polygon p)
{
    svg_control_polygon(s, p.n, p.R, "R");
    svg_rational(s, p.n, p.R, p.w, SVG_CURVE);
}

FIGURE(line_crossings)
{
    svg *s = svg_new(
        "line_crossings", "A line crosses the curve no more often than the polygon",
        "Left: a curve that a line crosses once, its polygon three times. Middle: a polygon that crosses itself "
        "on the line; it has one point there, the curve has two, but both cross the line twice. Right: with "
        "weights 2, -1, 2 the curve crosses a line that the polygon does not meet.");
    static const long wave[] = {0, -3, 1, 2, 3, -2, 4, 3}, wave_weights[] = {1, 1, 1, 1};
    static const long bow[] = {-1, 1, 1, -1, -1, -1, 1, 1}, bow_weights[] = {2, 1, 1, 2};
    static const long roof[] = {-1, 2, 0, 5, 1, 2}, roof_weights[] = {2, -1, 2};
    svg_panel(s, svg_integer_window(-1, -4, 5, 4), 260, 0, "the polygon crosses the line\nthree times, the curve once");
    svg_heading(s, SVG_RIGHT, "crossings, positive weights");
    svg_line(s, svg_at(0, 0), svg_at(1, 0), SVG_MUTED);
    draw(s, polygon_of(3, wave, wave_weights));
    svg_label(s, svg_at(5, 0), SVG_N, SVG_MUTED, "L");

    struct polygon p = polygon_of(3, bow, bow_weights);
    svg_panel(s, (svg_window){from_ratio_q(-3, 2), from_int_q(-2), from_ratio_q(3, 2), from_int_q(2)}, 260, 0,
              "one point of the polygon on the line,\ntwo of the curve; crossings: two and two");
    svg_heading(s, SVG_WRONG, "points of the plane");
    svg_line(s, svg_at(0, 0), svg_at(1, 0), SVG_MUTED);
    draw(s, p);
    svg_mark(s, svg_at(0, 0), SVG_POLYGON, SVG_USUAL);
    for (int k = 1; k <= 2; k++)
        svg_mark(s, point_at(p, from_ratio_q(k, 3)), SVG_WRONG, SVG_USUAL);

    p = polygon_of(2, roof, roof_weights);
    svg_panel(s, svg_integer_window(-3, -2, 3, 6), 260, 0,
              "weights $2, -1, 2$: the curve crosses\nthe line twice, the polygon never");
    svg_heading(s, SVG_WRONG, "weights of both signs");
    svg_line(s, svg_at(0, 0), svg_at(1, 0), SVG_MUTED);
    draw_triangle(s, p);
    svg_rational(s, p.n, p.R, p.w, SVG_CURVE);
    for (int k = 1; k <= 2; k++)
        svg_mark(s, point_at(p, from_ratio_q(k, 3)), SVG_WRONG, SVG_USUAL);
    svg_legend_line(s, SVG_CURVE, "curve");
    svg_legend_line(s, SVG_POLYGON, "polygon");
    svg_legend_line(s, SVG_MUTED, "line $L$");
    return s;
}

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
