/* Figures of the section on the curvature and torsion at the ends. */
#include "chapters/judge/figure.h"
#include "chapters/judge/figure_data.h"
#include "figures/words.h"

FIGURE(end_curvature)
{
    svg *s = svg_new("end_curvature", "The circles of curvature at both ends, from the polygon",
                     "A rational cubic with weights 1, 1, 2, 1 and the circles through its ends whose curvature is "
                     "given by the first two "
                     "and the last two edges.");
    num_q R[] = {q(0), q(0), q(0), q(3), q(6), q(4), q(6), q(1)};
    num_q w[] = {q(1), q(1), q(2), q(1)};
    static const enum svg_direction side[] = {SVG_W, SVG_NW, SVG_NE, SVG_E};
    /* both cross products are 18 and both edges 3: 2/3 * 2 * 18/27 = 8/9 and 2/3 * 1/4 * 18/27 = 1/9 */
    num_q at_zero = r(9, 8), at_one = q(9);
    svg_panel(s, svg_integer_window(-1, -2, 8, 5), 420, 0,
              "weights $1, 1, 2, 1$, edges $(0,3)$, $(6,1)$, $(0,-3)$:\n$κ(0) = 2/3 · 2 · 18/27 = 8/9$ and "
              "$κ(1) = 2/3 · 1/4 · 18/27 = 1/9$");
    svg_circle(s, (svg_point){at_zero, q(0)}, at_zero, SVG_RIGHT);
    svg_circle(s, (svg_point){sub_q(q(6), at_one), q(1)}, at_one, SVG_RIGHT);
    svg_control_polygon_towards(s, 3, R, "R", side);
    svg_rational(s, 3, R, w, SVG_CURVE);
    svg_legend_line(s, SVG_CURVE, "the curve");
    svg_legend_line(s, SVG_RIGHT, "circles of the curvature of (3.2.5), radii $9/8$ and $9$");
    return s;
}

/* (x, y, z) seen obliquely. */
static void oblique(int count, const num_q P[], num_q out[])
{
    for (int i = 0; i < count; i++) {
        out[2 * i] = add_q(P[3 * i], mul_q(r(1, 2), P[3 * i + 1]));
        out[2 * i + 1] = add_q(P[3 * i + 2], mul_q(r(1, 3), P[3 * i + 1]));
    }
}

FIGURE(end_formulas_undetermined)
{
    svg *s =
        svg_new("end_formulas_undetermined", "Where the formulas say 0/0 or have the wrong sign",
                "A parabola that starts with a repeated point and has curvature 2; a space curve whose first three "
                "points are on a "
                "line and that has torsion 2; a cubic with a negative weight, whose printed curvature is negative.");
    num_q zero = q(0), one = q(1);
    num_q parabola[10], equal[5];
    data_of("repeated_first_points_leave_curvature_undetermined", "R", 5, 2, parabola);
    data_of("repeated_first_points_leave_curvature_undetermined", "ω", 5, 1, equal);
    svg_panel(s, (svg_window){r(-3, 4), r(-1, 4), r(5, 4), r(5, 4)}, 250, 0,
              "$x = t^2$, $y = t^4$: $R_0 = R_1$; $κ → 2$, the circle,\nfor $t → 0$, and (3.2.5) says $0/0$");
    svg_circle(s, (svg_point){zero, r(1, 2)}, r(1, 2), SVG_RIGHT);
    svg_polyline(s, 5, parabola, SVG_POLYGON);
    svg_rational(s, 4, parabola, equal, SVG_CURVE);
    static const char *const name[] = {"R_0 = R_1", "", "R_2", "R_3", "R_4"};
    for (int i = 0; i < 5; i++) {
        svg_mark(s, svg_pair(parabola + 2 * i), SVG_POLYGON, SVG_USUAL);
        svg_label(s, svg_pair(parabola + 2 * i), i == 0 ? SVG_SW : i == 4 ? SVG_N : SVG_S, SVG_POINT, name[i]);
    }
    num_q space[15];
    data_of("collinear_first_points_leave_torsion_undetermined", "R", 5, 3, space);
    num_q flat[10], axes[] = {zero, zero, zero, one, zero, zero, zero, one, zero, zero, zero, one}, ends[8];
    oblique(5, space, flat);
    oblique(4, axes, ends);
    svg_panel(
        s, (svg_window){r(-1, 4), r(-1, 4), r(7, 4), r(3, 2)}, 250, 0,
        "$(t, t^3, t^4)$ seen obliquely: $R_0, R_1, R_2$ on a line;\n$τ → 2$ for $t → 0$, and (3.2.6) says $0/0$");
    static const char *const axis[] = {"", "x", "y", "z"};
    for (int i = 1; i < 4; i++) {
        svg_arrow(s, svg_pair(ends), svg_pair(ends + 2 * i), SVG_AXIS);
        svg_label(s, svg_pair(ends + 2 * i), i == 3 ? SVG_W : i == 2 ? SVG_N : SVG_SE, SVG_AXIS, axis[i]);
    }
    static const enum svg_direction obliquely[] = {SVG_S, SVG_S, SVG_S, SVG_E, SVG_NE};
    svg_control_polygon_towards(s, 4, flat, "R", obliquely);
    svg_bezier(s, 4, flat, SVG_CURVE);
    num_q square[8], w[4];
    data_of("negative_weight_makes_printed_curvature_negative", "R", 4, 2, square);
    data_of("negative_weight_makes_printed_curvature_negative", "ω", 4, 1, w);
    svg_panel(s, (svg_window){r(-1, 2), r(-1, 2), r(3, 2), r(5, 4)}, 250, 0,
              "weights $1, 1, -1/4, 1$: $κ(0) = 1/6$, the circle;\n(3.2.5) says $-1/6$");
    svg_circle(s, (svg_point){zero, q(-6)}, q(6), SVG_RIGHT);
    static const enum svg_direction above[] = {SVG_NW, SVG_NE, SVG_NE, SVG_W};
    svg_control_polygon_towards(s, 3, square, "R", above);
    svg_rational(s, 3, square, w, SVG_CURVE);
    svg_legend_line(s, SVG_CURVE, "the curve");
    svg_legend_line(s, SVG_RIGHT, "its circle of curvature at $t = 0$");
    return s;
}
