/* Figures of the section on a point that is turned by a small angle. */
#include "chapters/foundations/turning-figures.h"

static void put_orbit(svg *s, int n, const num_q P[], enum svg_role role)
{
    svg_polyline(s, n + 1, P, role);
    for (int k = 0; k <= n; k++)
        svg_mark(s, svg_pair(P + 2 * k), role, SVG_USUAL);
}

FIGURE(three_generators)
{
    svg *s = svg_new(
        "three_generators", "A rotation, a spiral and an ellipse",
        "Three ways to turn a point, 26 steps each: the rotation keeps it on the circle, the simplified step with "
        "epsilon a quarter drives it outwards on a spiral, and the second way with the same epsilon keeps it on an "
        "ellipse.");
    const char *const captions[3] = {"rotation by 2 arctan(1/8)", "first way, simplified, $ε=1/4$",
                                     "second way, $ε=1/4$"};
    for (int way = 0; way < 3; way++) {
        num_q M[4], P[2 * 30] = {q(1), q(0)};
        generator(way, way == 0 ? r(1, 8) : r(1, 4), M);
        orbit(26, M, P);
        svg_panel(
            s, way == 1 ? window(r(-9, 4), r(-9, 4), r(11, 4), r(9, 4)) : window(r(-5, 4), r(-5, 4), r(5, 4), r(5, 4)),
            way == 1 ? 300 : 240, 0, captions[way]);
        svg_circle(s, svg_at(0, 0), q(1), SVG_MUTED);
        put_orbit(s, 26, P, way == 1 ? SVG_WRONG : way == 0 ? SVG_RIGHT : SVG_CURVE);
        svg_mark(s, svg_at(1, 0), SVG_POINT, SVG_RING);
    }
    svg_legend_line(s, SVG_MUTED, "the circle");
    svg_legend_mark(s, SVG_POINT, SVG_RING, "the first point");
    return s;
}

FIGURE(radius_of_the_first_way)
{
    svg *s = svg_new(
        "radius_of_the_first_way", "The radius of the simplified circle grows with every step",
        "The square of the radius after n steps of the first way, the power of 1 + epsilon squared, for epsilon 1/8, "
        "1/16 and 1/32 and up to 200 steps; the square of the radius of the second way stays between two bounds.");
    svg_panel(s, window(q(0), q(0), q(200), q(5)), 480, 280, "the square of the radius after $n$ steps");
    svg_axes(s, q(50), q(1), "n", NULL);
    static const enum svg_role roles[3] = {SVG_WRONG, SVG_CURVE_2, SVG_FAMILY};
    static const char *const names[3] = {"first way, $ε=1/8$", "first way, $ε=1/16$", "first way, $ε=1/32$"};
    num_q points[2 * 201];
    for (int k = 0; k < 3; k++) {
        num_q factor = add_q(q(1), r(1, 64L << (2 * k))), radius = q(1);
        for (int n = 0; n <= 200; n++, radius = mul_q(radius, factor)) {
            points[2 * n] = q(n);
            points[2 * n + 1] = from_double_q(to_double_q(radius));
        }
        svg_polyline(s, 201, points, roles[k]);
        svg_legend_line(s, roles[k], names[k]);
    }
    num_q M[4], P[2 * 201] = {q(1), q(0)};
    generator(2, r(1, 8), M);
    for (int n = 0; n <= 200; n++) {
        points[2 * n] = q(n);
        points[2 * n + 1] = from_double_q(to_double_q(norm_squared_q(2, P + 2 * n)));
        if (n < 200)
            orbit(1, M, P + 2 * n);
    }
    svg_polyline(s, 201, points, SVG_RIGHT);
    svg_legend_line(s, SVG_RIGHT, "second way, $ε=1/8$");
    return s;
}

FIGURE(circles_in_integers)
{
    svg *s = svg_new("circles_in_integers", "The simplified circle with bits that are shifted out",
                     "Steps of the first way with epsilon 1/16.  Exact steps from (40,0) run outwards on a spiral; in "
                     "integers, where a shift drops the bits, the points go another way, and from (10,0) they do not "
                     "move at all.");
    num_q M[4], P[2 * 101] = {q(40), q(0)}, whole[2 * 101];
    int x = 40, y = 0;
    generator(1, r(1, 16), M);
    orbit(100, M, P);
    for (int k = 0; k <= 100; k++) {
        whole[2 * k] = q(x);
        whole[2 * k + 1] = q(y);
        int down = y >= 0 ? y / 16 : -((-y + 15) / 16), up = x >= 0 ? x / 16 : -((-x + 15) / 16); /* rounded down */
        x -= down;
        y += up;
    }
    svg_panel(s, window(q(-60), q(-56), q(60), q(56)), 400, 0, "100 steps with $ε=1/16$");
    svg_axes(s, q(20), q(20), "x", "y");
    svg_polyline(s, 101, P, SVG_RIGHT);
    svg_polyline(s, 101, whole, SVG_WRONG);
    svg_mark(s, svg_at(40, 0), SVG_POINT, SVG_RING);
    svg_mark(s, svg_at(10, 0), SVG_WRONG, SVG_USUAL);
    svg_note(s, svg_at(10, 0), SVG_NE, SVG_WRONG, "stays here");
    svg_legend_line(s, SVG_RIGHT, "exact");
    svg_legend_line(s, SVG_WRONG, "in integers");
    return s;
}
