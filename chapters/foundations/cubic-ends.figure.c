/* Figures of the section on a cubic by its ends. */
#include "chapters/foundations/cubic-figures.h"

FIGURE(lengths_of_the_tangents)
{
    svg *s = svg_new("lengths_of_the_tangents", "The lengths of the tangents change the shape",
                     "Cubics with the same ends and the same directions of the tangents, and with tangents of five "
                     "lengths; the parabola "
                     "is one of them.  The triangle of the ends and the directions is drawn.");
    svg_panel(s, window(r(-1, 5), r(-1, 10), r(6, 5), r(9, 10)), 480, 0, "$\\α=\\β=1/2, 1, 3/2, 2, 3$");
    for (int k = 0; k < 5; k++) {
        static const int halves[5] = {1, 2, 3, 4, 6};
        num_q c[8], length = r(halves[k], 2);
        cubic_of_triangle(r(3, 5), length, length, c);
        put_power_curve(s, 3, c, q(0), q(1), k == 1 ? SVG_CURVE_2 : k == 4 ? SVG_CURVE : SVG_FAMILY);
    }
    svg_polyline(s, 3, (num_q[]){q(0), q(0), r(1, 2), r(3, 5), q(1), q(0)}, SVG_MUTED);
    static const char *const names[3] = {"Q_0", "M", "Q_1"};
    for (int k = 0; k < 3; k++) {
        svg_point P = at(r(k, 2), k == 1 ? r(3, 5) : q(0));
        svg_mark(s, P, SVG_POINT, SVG_USUAL);
        svg_label(s, P, k == 0 ? SVG_W : k == 1 ? SVG_S : SVG_E, SVG_POINT, names[k]);
    }
    svg_legend_line(s, SVG_CURVE_2, "$α=β=1$, a parabola");
    svg_legend_line(s, SVG_CURVE, "$α=β=3$, a cusp");
    svg_legend_line(s, SVG_FAMILY, "other lengths");
    return s;
}

FIGURE(exchanged_lengths)
{
    svg *s = svg_new("exchanged_lengths", "Two lengths exchanged: the same shape",
                     "A cubic with the tangents (1, 1) and (2, 2) at its ends, and one with (2, 2) and (1, 1): each is "
                     "the other, turned by two right angles about the middle of the chord.");
    static const int coefficients[2][8] = {{0, 0, 1, 1, -1, -4, 1, 3}, {0, 0, 2, 2, -2, -5, 1, 3}};
    static const enum svg_role roles[2] = {SVG_CURVE, SVG_CURVE_2};
    svg_panel(s, window(r(-1, 10), r(-3, 10), r(11, 10), r(3, 10)), 480, 0, "");
    svg_segment(s, svg_at(0, 0), svg_at(1, 0), SVG_MUTED);
    for (int k = 0; k < 2; k++) {
        num_q c[8];
        integers(8, coefficients[k], c);
        put_power_curve(s, 3, c, q(0), q(1), roles[k]);
        svg_mark(s, svg_at(k, 0), SVG_POINT, SVG_USUAL);
        svg_label(s, svg_at(k, 0), k ? SVG_E : SVG_W, SVG_POINT, k ? "Q_1" : "Q_0");
    }
    svg_mark(s, at(r(1, 2), q(0)), SVG_MUTED, SVG_USUAL);
    svg_legend_line(s, SVG_CURVE, "tangents $(1,1)$, $(2,2)$");
    svg_legend_line(s, SVG_CURVE_2, "tangents $(2,2)$, $(1,1)$");
    return s;
}

FIGURE(ends_with_lost_letters)
{
    svg *s = svg_new("ends_with_lost_letters", "The coefficients of a cubic with points that have got dots",
                     "The data 0 and 1 with the tangents 1 belong to the straight graph.  With the printed A the curve "
                     "ends at 3, with the printed B at -2, and with the printed D it begins at 1.");
    static const int coefficients[4][4] = {{0, 1, 0, 0}, {0, 1, 0, 2}, {0, 1, -3, 0}, {1, 1, 0, 0}};
    svg_panel(s, window(r(-1, 8), r(-9, 4), r(9, 8), r(13, 4)), 280, 320, "$Q_0=0$, $Q_1=1$, both tangents 1");
    svg_axes(s, q(1), q(1), "t", NULL);
    for (int k = 3; k >= 0; k--) {
        num_q c[8];
        for (int m = 0; m < 4; m++)
            c[2 * m] = q(m == 1), c[2 * m + 1] = q(coefficients[k][m]);
        put_power_curve(s, 3, c, q(0), q(1), k ? SVG_WRONG : SVG_RIGHT);
    }
    svg_mark(s, svg_at(0, 0), SVG_POINT, SVG_USUAL);
    svg_mark(s, svg_at(1, 1), SVG_POINT, SVG_USUAL);
    svg_label(s, svg_at(0, 0), SVG_SW, SVG_POINT, "Q_0");
    svg_label(s, svg_at(1, 1), SVG_E, SVG_POINT, "Q_1");
    static const int ends[3][2] = {{1, 3}, {1, -2}, {0, 1}};
    static const char *const names[3] = {"A", "B", "D"};
    for (int k = 0; k < 3; k++) {
        svg_mark(s, svg_at(ends[k][0], ends[k][1]), SVG_WRONG, SVG_USUAL);
        svg_label(s, svg_at(ends[k][0], ends[k][1]), k == 2 ? SVG_W : SVG_E, SVG_WRONG, names[k]);
    }
    svg_legend_line(s, SVG_RIGHT, "corrected");
    svg_legend_line(s, SVG_WRONG, "$A$, $B$ or $D$ as printed");
    return s;
}
