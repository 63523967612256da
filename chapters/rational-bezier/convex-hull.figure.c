/* Figures of the section on the convex hull. */
#include "chapters/judge/figure.h"
#include "chapters/judge/figure_data.h"
#include "exact/record/hull.h"
#include "figures/words.h"

static void draw_hull(svg *s, int n, const num_q R[])
{
    int vertex[16];
    num_q P[2 * 16];
    int count = convex_hull_2d(n + 1, R, vertex);
    for (int k = 0; k < count; k++) {
        P[2 * k] = R[2 * vertex[k]];
        P[2 * k + 1] = R[2 * vertex[k] + 1];
    }
    svg_area(s, count, P, SVG_FILL);
}

FIGURE(convex_hull)
{
    svg *s = svg_new(
        "convex_hull", "The curve stays in the hull of its points while no share is negative",
        "Left, quartics of one zigzag polygon with three sets of positive weights, all in the convex hull.  Right, the "
        "quadratic with weights 1, -1/2, 1, separated from the triangle by its base line, and the segment continued to "
        "t = 2.");
    num_q R[] = {q(0), q(1), q(1), q(4), q(3), q(0), q(5), q(4), q(6), q(1)};
    static const enum svg_direction clear[] = {SVG_W, SVG_N, SVG_E}, below[] = {SVG_S, SVG_S};
    static const long weights[3][5] = {{1, 1, 1, 1, 1}, {1, 9, 1, 9, 1}, {1, 1, 9, 1, 1}};
    svg_panel(s, svg_integer_window(-1, -1, 7, 5), 380, 0, "one polygon, three sets of positive weights,\none hull");
    svg_heading(s, SVG_RIGHT, "positive weights");
    draw_hull(s, 4, R);
    svg_control_polygon(s, 4, R, "R");
    for (int k = 2; k >= 0; k--) {
        num_q w[5];
        for (int i = 0; i <= 4; i++)
            w[i] = q(weights[k][i]);
        svg_rational(s, 4, R, w, k == 0 ? SVG_CURVE : k == 1 ? SVG_CURVE_2 : SVG_RIGHT);
    }
    num_q Q[6], w[3], x[2];
    data_of("curve_leaves_hull_with_negative_weight", "R", 3, 2, Q);
    data_of("curve_leaves_hull_with_negative_weight", "ω", 3, 1, w);
    svg_panel(s, (svg_window){q(-1), r(-5, 2), q(3), r(5, 2)}, 240, 0,
              "weights $1, -1/2, 1$: $R(1/2) = (1, -2)$ is\nbelow the line $y = 0$, the triangle above");
    svg_heading(s, SVG_WRONG, "a negative weight");
    draw_hull(s, 2, Q);
    svg_line(s, svg_at(0, 0), svg_at(1, 0), SVG_MUTED);
    svg_control_polygon_towards(s, 2, Q, "R", clear);
    svg_rational(s, 2, Q, w, SVG_WRONG);
    rational_point_q(2, 2, Q, w, r(1, 2), x);
    svg_mark(s, svg_pair(x), SVG_WRONG, SVG_USUAL);
    svg_label(s, svg_pair(x), SVG_S, SVG_WRONG, "R(1/2)");
    num_q line[] = {q(0), q(0), q(1), q(0)};
    svg_panel(s, (svg_window){r(-1, 4), r(-9, 8), r(9, 4), r(9, 8)}, 280, 0,
              "the hull of $R_0$, $R_1$ is the segment;\nfor $t = 2$ the point is beyond it");
    svg_heading(s, SVG_WRONG, "outside $0 ≤ t ≤ 1$");
    num_q band[] = {q(0), r(-1, 12), q(1), r(-1, 12), q(1), r(1, 12), q(0), r(1, 12)};
    svg_area(s, 4, band, SVG_FILL);
    for (int k = 1; k < 4; k++) {
        svg_mark(s, (svg_point){r(k, 2), q(0)}, k > 2 ? SVG_WRONG : SVG_CURVE, SVG_USUAL);
        svg_note(s, (svg_point){r(k, 2), r(1, 12)}, SVG_N, SVG_POINT,
                 k == 1   ? "$t=1/2$"
                 : k == 2 ? "$t=1$"
                          : "$t=3/2$");
    }
    svg_control_polygon_towards(s, 1, line, "R", below);
    svg_segment(s, svg_at(1, 0), svg_at(2, 0), SVG_WRONG);
    svg_segment(s, svg_at(0, 0), svg_at(1, 0), SVG_CURVE);
    svg_mark(s, svg_at(2, 0), SVG_WRONG, SVG_USUAL);
    svg_label(s, svg_at(2, 0), SVG_S, SVG_WRONG, "R(2)");
    svg_legend_line(s, SVG_CURVE, "weights $1$");
    svg_legend_line(s, SVG_CURVE_2, "$1, 9, 1, 9, 1$");
    svg_legend_line(s, SVG_RIGHT, "$1, 1, 9, 1, 1$");
    svg_legend_line(s, SVG_WRONG, "outside the hull");
    svg_legend_area(s, SVG_FILL, "convex hull");
    return s;
}
