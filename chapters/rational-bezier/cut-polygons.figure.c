#include "chapters/judge/figure.h"
#include "chapters/judge/figure_data.h"
#include "figures/words.h"

/* The polygons of all pieces of the quadratic after k cuts at lambda. */
static void draw_pieces(svg *s, int k, const num_q R[], const num_q w[], num_q lambda, enum svg_role drawn_as)
{
    if (k == 0) {
        svg_polyline(s, 3, R, drawn_as);
        for (int i = 0; i < 3; i++)
            svg_mark(s, svg_pair(R + 2 * i), drawn_as, SVG_USUAL);
        return;
    }
    num_q P[2][6], v[2][3];
    rational_split_q(2, 2, R, w, lambda, P[0], v[0], P[1], v[1]);
    for (int half = 0; half < 2; half++)
        draw_pieces(s, k - 1, P[half], v[half], lambda, drawn_as);
}

FIGURE(cut_polygons_converge)
{
    static const int unit[] = {1, 1, 1};
    num_q R[6], w[3], one[3], zero = from_int_q(0), half = from_ratio_q(1, 2);
    num_q low = from_ratio_q(-3, 20), high = from_ratio_q(23, 20);
    data_of("quarter_circle_error_is_quartered", "R", 3, 2, R);
    data_of("quarter_circle_error_is_quartered", "ω", 3, 1, w);
    integers(3, unit, one);
    svg *s = svg_new(
        "cut_polygons_converge", "Polygons that converge, and polygons that do not",
        "Left, a quarter circle and its polygons after one and two cuts in the middle.  Right, a parabola cut more and "
        "more closely to the beginning of its last piece, which keeps a length above one half.");
    svg_panel(s, (svg_window){low, low, high, high}, 340, 0,
              "quarter circle cut in the middle:\nafter $k$ cuts the error is $4^{-k}$");
    draw_pieces(s, 0, R, w, half, SVG_POLYGON);
    draw_pieces(s, 1, R, w, half, SVG_CURVE_2);
    draw_pieces(s, 2, R, w, half, SVG_RIGHT);
    svg_rational(s, 2, R, w, SVG_CURVE);

    svg_panel(s, (svg_window){low, from_ratio_q(-1, 4), high, from_ratio_q(21, 20)}, 340, 0,
              "parabola, its last piece cut at 1/4, 1/8, 1/16, ...:\na vertex stays more than 1/16 below");
    num_q P[] = {zero, zero, half, zero, one[0], one[0]}, Pl[6], wl[3], Pr[6], wr[3], last[6];
    for (int m = 0; m < 6; m++)
        last[m] = P[m];
    svg_polyline(s, 3, P, SVG_POLYGON);
    for (int k = 1; k <= 6; k++) {
        rational_split_q(2, 2, last, one, from_ratio_q(1, 2L << k), Pl, wl, Pr, wr);
        for (int m = 0; m < 6; m++)
            last[m] = Pr[m];
        svg_polyline(s, 3, last, SVG_WRONG);
    }
    svg_rational(s, 2, P, one, SVG_CURVE);
    svg_mark(s, svg_pair(last + 2), SVG_WRONG, SVG_USUAL);
    svg_legend_line(s, SVG_CURVE, "the curve");
    svg_legend_line(s, SVG_POLYGON, "$k = 0$");
    svg_legend_line(s, SVG_CURVE_2, "$k = 1$");
    svg_legend_line(s, SVG_RIGHT, "$k = 2$");
    svg_legend_line(s, SVG_WRONG, "the last pieces");
    return s;
}
