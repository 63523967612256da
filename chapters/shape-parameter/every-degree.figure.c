/* every-degree.figure.c -- drawings for every-degree.claims.h. */
#include "chapters/shape-parameter/drawing.h"
#include "exact/record/number.h"

#include <stdio.h>

/* A bar from a to b in row y, and its name at the left. */
static void bar(svg *s, int y, num_q a, num_q b, enum svg_role paint, const char *name)
{
    num_q corner[8] = {a, sub_q(q(y), r(1, 5)), b, sub_q(q(y), r(1, 5)),
                       b, add_q(q(y), r(1, 5)), a, add_q(q(y), r(1, 5))};
    svg_area(s, 4, corner, paint);
    svg_segment(s, at(a, q(y)), at(b, q(y)), paint);
    svg_note(s, at(q(-8), q(y)), SVG_W, SVG_POINT, name);
}

FIGURE(ranges_of_beta)
{
    svg *s = svg_new(
        "ranges_of_beta", "For which beta each property is true",
        "Bars over the axis of β from -8 to 2: nonnegativity, one maximum, hull, rule of signs, variation "
        "diminution and convexity hold from -21/4 to 1 for the corrected functions, where at -21/4 a sum may be "
        "0 and a curve on a line; sum, symmetry and affine invariance for all β; with the printed functions "
        "sum, symmetry, hull, invariance, variation diminution and, in the range of the text, convexity only "
        "for β = 0.");
    static const struct {
        const char *name;
        int from, to, printed_fails; /* quarters of beta */
    } row[] = {{"range in the text", -28, 4, 0},
               {"nonnegative (2.1)", -21, 4, 0},
               {"sum, symmetry (2.2, 2.3)", -32, 8, 1},
               {"one maximum (2.5)", -21, 4, 0},
               {"ends (2.4, 3.1)", -32, 8, 0},
               {"convex hull (3.2)", -21, 4, 1},
               {"affine invariance (3.4)", -32, 8, 1},
               {"rule of signs (15)", -21, 4, 0},
               {"variation diminishing (3.6)", -21, 4, 1},
               {"convexity (3.7)", -21, 4, 1}};
    enum { ROWS = sizeof row / sizeof row[0] };
    svg_panel(s, window(r(-27, 2), q(-ROWS - 1), q(2), q(0)), 620, 300, NULL);
    for (int beta = -8; beta <= 2; beta++) {
        char number[8];
        snprintf(number, sizeof number, "$%d$", beta);
        svg_segment(s, svg_at(beta, -ROWS - 1), svg_at(beta, 0), beta == 0 ? SVG_AXIS : SVG_MUTED);
        svg_note(s, svg_at(beta, -ROWS - 1), SVG_S, SVG_AXIS, number);
    }
    svg_label(s, svg_at(2, -ROWS - 1), SVG_E, SVG_POINT, "β");
    for (int k = 0; k < ROWS; k++) {
        bar(s, -k - 1, r(row[k].from, 4), r(row[k].to, 4), k == 0 ? SVG_WRONG : SVG_RIGHT, row[k].name);
        if (row[k].printed_fails)
            svg_mark(s, svg_at(0, -k - 1), SVG_WRONG, SVG_CROSS);
    }
    svg_legend_area(s, SVG_RIGHT, "true, corrected functions");
    svg_legend_mark(s, SVG_WRONG, SVG_CROSS, "printed functions: only $β=0$");
    svg_legend_area(s, SVG_WRONG, "what the text allows");
    return s;
}

FIGURE(ranges_of_every_degree)
{
    svg *s = svg_new(
        "ranges_of_every_degree", "The true range of beta in every degree",
        "For n from 2 to 12 the range of β in which the functions are nonnegative: from -n to 1 up to n = 5, then "
        "shorter than that; the lower ends stay above -8.");
    svg_panel(s, window(q(-13), q(1), q(2), q(13)), 420, 300, NULL);
    svg_grid(s, q(2), q(40));
    svg_axes(s, q(2), q(1), "β", "n");
    for (int n = 2; n <= 12; n++) {
        num_q near[14], far[14], slope[14], unused[14], low = q(-n * n);
        shape_factors_q(n, q(0), near, far);
        shape_factors_q(n, q(1), slope, unused);
        for (int k = 1; 2 * k < n + 1; k++) {
            num_q zero = neg_q(div_q(near[k], sub_q(slope[k], near[k])));
            low = compare_q(zero, low) > 0 ? zero : low;
        }
        svg_segment(s, svg_at(-n, n), at(low, q(n)), SVG_WRONG);
        svg_segment(s, at(low, q(n)), svg_at(1, n), SVG_RIGHT);
        svg_mark(s, at(low, q(n)), SVG_RIGHT, SVG_USUAL);
    }
    svg_segment(s, svg_at(-8, 1), svg_at(-8, 13), SVG_MUTED);
    svg_legend_line(s, SVG_RIGHT, "nonnegative, totally positive");
    svg_legend_line(s, SVG_WRONG, "the rest of $-n≤β≤1$");
    svg_legend_line(s, SVG_MUTED, "$β=-8$");
    return s;
}

FIGURE(blend_of_three_points)
{
    svg *s =
        svg_new("blend_of_three_points", "What beta does to a point of the curve",
                "A polygon of five points and t = 2/5.  Two levels of de Casteljau's triangle leave three points; the "
                "points of the curves of β = -2, -1, 0, 1 stand on a straight line from the chord towards the middle "
                "one of the three.");
    static const int from[] = {0, 0, 1, 6, 6, 9, 11, 6, 12, 0};
    num_q P[10], w[10], X[2], t = r(2, 5), ends[4];
    integers(2 * 5, from, P);
    for (int m = 0; m < 10; m++)
        w[m] = P[m];
    svg_panel(s, window(q(-1), q(-1), q(13), q(10)), 460, 0, "$n=4$, $t=2/5$");
    svg_control_polygon(s, 4, P, "P");
    bezier_casteljau_level_q(4, 2, w, t);
    svg_polyline(s, 4, w, SVG_FAMILY);
    bezier_casteljau_level_q(3, 2, w, t);
    svg_area(s, 3, w, SVG_FILL);
    svg_polyline(s, 3, w, SVG_POINT);
    put_curve(s, 0, 4, P, q(-2), SVG_FAMILY);
    put_curve(s, 0, 4, P, q(0), SVG_CURVE_2);
    put_curve(s, 0, 4, P, q(1), SVG_CURVE);
    for (int j = 0; j < 3; j++) {
        static const enum svg_direction side[] = {SVG_W, SVG_N, SVG_E};
        char name[8];
        snprintf(name, sizeof name, "b_%d", j);
        svg_mark(s, svg_pair(w + 2 * j), SVG_POINT, SVG_USUAL);
        svg_label(s, svg_pair(w + 2 * j), side[j], SVG_POINT, name);
    }
    shape_point_q(4, 2, P, q(-2), t, ends);
    shape_point_q(4, 2, P, q(1), t, ends + 2);
    svg_segment(s, svg_pair(ends), svg_pair(ends + 2), SVG_RIGHT);
    for (int beta = -2; beta <= 1; beta++) {
        shape_point_q(4, 2, P, q(beta), t, X);
        svg_mark(s, svg_pair(X), SVG_RIGHT, SVG_USUAL);
    }
    svg_legend_line(s, SVG_CURVE, "$β=1$");
    svg_legend_line(s, SVG_CURVE_2, "$β=0$");
    svg_legend_line(s, SVG_FAMILY, "$β=-2$; level 1 of the triangle");
    svg_legend_mark(s, SVG_RIGHT, SVG_USUAL, "$q_β(t)$ for $β=-2,-1,0,1$");
    return s;
}
