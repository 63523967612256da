#include "chapters/judge/figure.h"
#include "figures/words.h"

/* w_1^2/w_2 = I for w_0 = 1: (w_1, w_1^2/I) as a parabola from w_1 = 0 to w_1 = 2. */
static void put_valley(svg *s, num_q I, enum svg_role role)
{
    num_q zero = from_int_q(0), two = from_int_q(2),
          P[] = {zero, zero, from_int_q(1), zero, two, div_q(mul_q(two, two), I)};
    svg_bezier(s, 2, P, role);
}

FIGURE(gauge_valley)
{
    num_q R[] = {from_int_q(65), from_int_q(0), from_int_q(65), from_int_q(65), from_int_q(0), from_int_q(65)};
    num_q one = from_int_q(1), w[] = {one, one, from_int_q(2)};
    static const int place[8][2] = {{63, 16}, {60, 25}, {56, 33}, {52, 39}, {39, 52}, {33, 56}, {25, 60}, {16, 63}};
    static const int eighths[] = {1, 2, 6, 8};
    svg *s = svg_new(
        "gauge_valley", "The valley of the cost along the gauge",
        "Left the plane of the weights w1 and w2 of a conic with first weight 1: the cost is the same along every "
        "parabola of equal invariant, and least along one of them.  Right the conics of these parabolas with the "
        "measured points: one parabola is one curve.");
    svg_panel(s, (svg_window){from_int_q(0), from_int_q(0), r(9, 5), from_int_q(4)}, 330, 330,
              "all weights free: $F$ is constant along $w_1^2/w_2$,\nthe bottom of its valley is a whole curve");
    svg_axes(s, r(1, 2), one, "w_1", "w_2");
    for (int k = 0; k < 4; k++)
        put_valley(s, r(eighths[k], 8), SVG_FAMILY);
    put_valley(s, r(1, 2), SVG_CURVE);
    svg_segment(s, (svg_point){from_int_q(0), one}, (svg_point){r(9, 5), one}, SVG_CURVE_2);
    svg_mark(s, (svg_point){one, from_int_q(2)}, SVG_CURVE, SVG_USUAL);
    svg_note(s, (svg_point){one, from_int_q(2)}, SVG_E, SVG_CURVE, "$(1,2)$");
    svg_frame(s);
    svg_panel(s, svg_integer_window(-4, -4, 72, 72), 330, 0, "the conics of $I_1 = 1/8, 1/4, 1/2, 3/4, 1$");
    svg_polyline(s, 3, R, SVG_POLYGON);
    for (int k = 0; k < 4; k++) {
        w[2] = div_q(one, r(eighths[k], 8));
        svg_rational(s, 2, R, w, SVG_FAMILY);
    }
    w[2] = from_int_q(2);
    svg_rational(s, 2, R, w, SVG_CURVE);
    for (int i = 0; i < 8; i++)
        svg_mark(s, svg_at(place[i][0], place[i][1]), SVG_POINT, SVG_RING);
    svg_legend_line(s, SVG_CURVE, "the bottom, $I_1 = 1/2$");
    svg_legend_line(s, SVG_FAMILY, "others of equal $I_1$ each");
    svg_legend_line(s, SVG_CURVE_2, "the gauge $w_0 = w_2 = 1$");
    return s;
}

FIGURE(sliding_ends)
{
    /* the arc of the circle x^2 + y^2 = 1 from the angle 2 atan(a) to 2 atan(b) */
    static const int from[3][2] = {{0, 1}, {-1, 5}, {1, 10}}, to[3][2] = {{1, 1}, {6, 5}, {3, 4}};
    static const enum svg_role role[3] = {SVG_CURVE, SVG_CURVE_2, SVG_FAMILY};
    svg *s = svg_new("sliding_ends", "Ends that slide along the conic",
                     "Three arcs of one circle with their control polygons; the measured points lie on all of them.");
    svg_panel(s, (svg_window){r(-2, 5), r(-1, 2), r(17, 10), r(7, 5)}, 420, 0,
              "as far as the points can tell,\nthese are one curve: two directions are free");
    for (int k = 0; k < 3; k++) {
        num_q one = from_int_q(1), a = r(from[k][0], from[k][1]), b = r(to[k][0], to[k][1]);
        /* (1-t^2, 2t, 1+t^2) in its polar form at (a,a), (a,b), (b,b) */
        num_q x[3] = {a, a, b}, y[3] = {a, b, b}, R[6], w[3];
        for (int m = 0; m < 3; m++) {
            w[m] = add_q(one, mul_q(x[m], y[m]));
            R[2 * m] = div_q(sub_q(one, mul_q(x[m], y[m])), w[m]);
            R[2 * m + 1] = div_q(add_q(x[m], y[m]), w[m]);
        }
        svg_rational(s, 2, R, w, role[k]);
        svg_polyline(s, 3, R, k == 0 ? SVG_POLYGON : role[k]);
        for (int m = 0; m < 3; m++)
            svg_mark(s, svg_pair(R + 2 * m), k == 0 ? SVG_POLYGON : role[k], SVG_USUAL);
    }
    for (int i = 2; i < 12; i++) {
        num_q t = r(i, 16), one = from_int_q(1), below = add_q(one, mul_q(t, t));
        num_q P[] = {div_q(sub_q(one, mul_q(t, t)), below), div_q(mul_q(from_int_q(2), t), below)};
        svg_mark(s, svg_pair(P), SVG_POINT, SVG_RING);
    }
    svg_legend_line(s, SVG_CURVE, "the arc of a right angle");
    svg_legend_line(s, SVG_CURVE_2, "both ends farther out");
    svg_legend_line(s, SVG_FAMILY, "both ends farther in");
    svg_legend_mark(s, SVG_POINT, SVG_RING, "measured points");
    return s;
}
