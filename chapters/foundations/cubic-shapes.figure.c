/* The figure of the section on the shapes of a cubic. */
#include "chapters/foundations/cubic-figures.h"
#include "exact/record/number.h"

/* The turning at the ends, up to a positive factor, and the cusps: 3 - 2y, 3 - 2x, (x-2)(y-2) - 1. */
static num_q one_inflection(svg_point P, const void *data)
{
    (void)data;
    return neg_q(mul_q(sub_q(q(3), mul_q(q(2), P.x)), sub_q(q(3), mul_q(q(2), P.y))));
}

static num_q branch(svg_point P, const void *data)
{
    (void)data;
    return sub_q(mul_q(sub_q(P.x, q(2)), sub_q(P.y, q(2))), q(1));
}

static num_q loop(svg_point P, const void *data)
{
    num_q value = branch(P, data);
    return compare_q(P.x, q(2)) > 0 ? value : neg_q(mul_q(value, value));
}

static num_q cusp(svg_point P, const void *data) { return compare_q(P.x, q(2)) > 0 ? branch(P, data) : q(-1); }

FIGURE(forms_of_a_cubic)
{
    svg *s = svg_new(
        "forms_of_a_cubic", "What a cubic does, by the lengths of its tangents",
        "The plane of the lengths alpha and beta of the tangents, in units in which 1, 1 is the parabola.  Below 3/2 "
        "in both "
        "no inflection; one above and one below, one inflection; both above, two inflections until the branch of the "
        "hyperbola (alpha-2)(beta-2)=1 of the cusps, and a loop beyond it.  Beside it a curve of every part.");
    svg_panel(s, window(q(0), q(0), q(5), q(5)), 360, 0, "the plane of the lengths");
    svg_axes(s, q(1), q(1), "α", "β");
    svg_region(s, one_inflection, NULL, 100, SVG_FILL);
    svg_region(s, loop, NULL, 100, SVG_RIGHT);
    svg_segment(s, at(r(3, 2), q(0)), at(r(3, 2), q(5)), SVG_MUTED);
    svg_segment(s, at(q(0), r(3, 2)), at(q(5), r(3, 2)), SVG_MUTED);
    svg_implicit(s, cusp, NULL, 100, SVG_WRONG);
    svg_mark(s, svg_at(1, 1), SVG_POINT, SVG_USUAL);
    svg_note(s, svg_at(1, 1), SVG_NW, SVG_POINT, "parabola");
    static const int lengths[5][2] = {{1, 1}, {1, 3}, {2, 2}, {3, 3}, {4, 4}};
    static const char *const places[5] = {"0", "1", "2", "cusp", "loop"};
    svg_note(s, at(r(3, 4), r(1, 4)), SVG_HERE, SVG_POINT, "none");
    svg_note(s, at(r(3, 4), q(3)), SVG_HERE, SVG_POINT, "one");
    svg_note(s, at(q(3), r(3, 4)), SVG_HERE, SVG_POINT, "one");
    svg_note(s, at(q(2), q(2)), SVG_HERE, SVG_POINT, "two");
    svg_note(s, at(q(4), q(4)), SVG_HERE, SVG_POINT, "loop");
    svg_panel(s, window(r(-1, 4), r(-1, 8), r(5, 4), r(27, 8)), 260, 360, "$(α,β)=(1,1),(1,3),(2,2),(3,3),(4,4)$");
    for (int k = 0; k < 5; k++) {
        num_q c[8];
        cubic_of_triangle(r(1, 3), q(lengths[k][0]), q(lengths[k][1]), c);
        c[1] = k < 3 ? r(30 - 4 * k, 10) : r(54 - 13 * k, 10);
        put_power_curve(s, 3, c, q(0), q(1), SVG_CURVE);
        svg_note(s, at(q(1), c[1]), SVG_E, SVG_POINT, places[k]);
    }
    svg_legend_area(s, SVG_FILL, "one inflection");
    svg_legend_area(s, SVG_RIGHT, "a loop");
    svg_legend_line(s, SVG_WRONG, "cusps");
    return s;
}
