/* Figures of the section on the programs. */
#include "chapters/judge/figure.h"
#include "exact/record/number.h"
#include "figures/words.h"

/* x, rounded to binary64. */
static num_q binary64(num_q x) { return from_double_q(to_double_q(x)); }

FIGURE(last_parameter)
{
    svg *s =
        svg_new("last_parameter", "The last parameter of the program",
                "For 1 to 64 steps, how far the sum of as many rounded steps 1/npoints is from 1, in units of 2 to "
                "the power of -53.  It is 1 for twelve of these numbers.");
    svg_panel(s, window(q(0), q(-18), q(65), q(15)), 560, 260,
              "the last parameter less 1, in units of $2^{-53}$,\nfor $npoints=1,...,64$");
    svg_axes(s, q(8), q(5), NULL, NULL);
    for (int steps = 1; steps <= 64; steps++) {
        num_q step = binary64(r(1, steps)), t = q(0);
        for (int i = 0; i < steps; i++)
            t = binary64(add_q(t, step));
        num_q gap = div_q(sub_q(t, q(1)), from_double_q(0x1p-53));
        int right = is_zero_q(gap);
        svg_segment(s, svg_at(steps, 0), at(q(steps), gap), SVG_FAMILY);
        svg_mark(s, at(q(steps), gap), right ? SVG_RIGHT : SVG_WRONG, SVG_USUAL);
    }
    svg_legend_mark(s, SVG_RIGHT, SVG_USUAL, "it is 1");
    svg_legend_mark(s, SVG_WRONG, SVG_USUAL, "it is not");
    return s;
}

FIGURE(one_place_too_many)
{
    svg *s = svg_new("one_place_too_many", "Five points in an array of four",
                     "A cubic with the five points of four steps; below, an array of four places as the comment of the "
                     "program asks for, and the fifth number beyond its end.");
    static const int from[8] = {1, 1, 2, 3, 4, 3, 3, 1};
    num_q b[8], P[2];
    integers(8, from, b);
    svg_panel(s, window(r(1, 2), r(-1, 2), r(11, 2), r(13, 5)), 460, 0,
              "$npoints=4$: the places of the array, and the points");
    svg_bezier(s, 3, b, SVG_CURVE);
    for (int k = 0; k <= 4; k++) {
        char name[8] = {(char)('0' + k)};
        num_q x = add_q(q(1), mul_q(r(4, 5), q(k))), next = add_q(x, r(4, 5)), low = r(-1, 5), high = r(3, 10);
        num_q box[10] = {x, low, next, low, next, high, x, high, x, low};
        bezier_casteljau_q(3, 2, b, r(k, 4), P);
        enum svg_role role = k == 4 ? SVG_WRONG : SVG_POINT;
        if (k == 4)
            svg_area(s, 5, box, SVG_WRONG);
        svg_polyline(s, 5, box, k == 4 ? SVG_WRONG : SVG_AXIS);
        svg_mark(s, svg_pair(P), role, SVG_USUAL);
        svg_label(s, svg_pair(P), k < 2 ? SVG_NW : k < 4 ? SVG_NE : SVG_W, role, name);
        svg_label(s, at(div_q(add_q(x, next), q(2)), div_q(add_q(low, high), q(2))), SVG_HERE, role, name);
    }
    svg_legend_line(s, SVG_CURVE, "the curve");
    svg_legend_area(s, SVG_WRONG, "written beyond the end");
    return s;
}

FIGURE(last_point_lost)
{
    svg *s = svg_new("last_point_lost", "What the program makes of the last point",
                     "A segment from 1 to P_1, for P_1 = 0 to 8 in units of 2 to the power of -54: the result of the "
                     "program at t = 1, rounded after each operation, is P_1 only for the even numbers.");
    num_q unit = from_double_q(0x1p-54);
    svg_panel(s, window(q(0), q(0), q(9), q(9)), 330, 0, "the result at $t=1$ against $P_1$, in units of $2^{-54}$");
    svg_axes(s, q(2), q(2), "P_1", NULL);
    svg_segment(s, svg_at(0, 0), svg_at(9, 9), SVG_MUTED);
    for (int m = 0; m <= 8; m++) {
        num_q result = binary64(add_q(q(1), binary64(sub_q(mul_q(q(m), unit), q(1)))));
        num_q place = div_q(result, unit);
        int right = compare_q(place, q(m)) == 0;
        svg_segment(s, svg_at(m, m), at(q(m), place), SVG_FAMILY);
        svg_mark(s, at(q(m), place), right ? SVG_RIGHT : SVG_WRONG, SVG_USUAL);
    }
    svg_legend_mark(s, SVG_RIGHT, SVG_USUAL, "it is $P_1$");
    svg_legend_mark(s, SVG_WRONG, SVG_USUAL, "it is not");
    return s;
}
