#include "chapters/judge/figure.h"
#include "chapters/judge/figure_data.h"
#include "figures/words.h"

FIGURE(cut_leaves_the_edge)
{
    static const int point[] = {0, 0, 3, 3, 6, 0};
    num_q R[6], w[3], lambda, P[4], v[2];
    integers(6, point, R);
    data_of("negative_weight_breaks_convexity", "ω", 3, 1, w);
    data_of("negative_weight_breaks_convexity", "λ", 1, 1, &lambda);
    rational_casteljau_q(2, 2, R, w, lambda, 1, P, v);
    svg *s = svg_new(
        "cut_leaves_the_edge", "With a negative weight the new points leave the edges",
        "The quadratic with weights 1, -1/4, 1 is a regular arc, but the points of the first level at 1/2 lie on the "
        "edges produced beyond the end points.");
    svg_panel(s, svg_integer_window(-3, -3, 9, 4), 520, 0,
              "weights 1, $-$1/4, 1, $λ = 1/2$:  $R_1^1 = (4/3) R_0 - (1/3) R_1$");
    svg_line(s, svg_pair(R), svg_pair(R + 2), SVG_MUTED);
    svg_line(s, svg_pair(R + 2), svg_pair(R + 4), SVG_MUTED);
    static const char *const name[] = {"R_0", "R_1", "R_2"};
    static const enum svg_direction towards[] = {SVG_NW, SVG_N, SVG_NE};
    svg_polyline(s, 3, R, SVG_POLYGON);
    for (int i = 0; i < 3; i++) {
        svg_mark(s, svg_pair(R + 2 * i), SVG_POLYGON, SVG_USUAL);
        svg_label(s, svg_pair(R + 2 * i), towards[i], SVG_POINT, name[i]);
    }
    svg_rational(s, 2, R, w, SVG_CURVE);
    svg_segment(s, svg_pair(P), svg_pair(P + 2), SVG_FAMILY);
    svg_mark(s, svg_pair(P), SVG_WRONG, SVG_USUAL);
    svg_label(s, svg_pair(P), SVG_W, SVG_WRONG, "R_1^1");
    svg_mark(s, svg_pair(P + 2), SVG_WRONG, SVG_USUAL);
    svg_label(s, svg_pair(P + 2), SVG_E, SVG_WRONG, "R_2^1");
    return s;
}
