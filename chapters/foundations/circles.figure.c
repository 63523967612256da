/* Figures of the section on the three ways to turn a point. */
#include "chapters/foundations/figures.h"

/* P M^n with exact steps, as pairs; M = (M_0 M_1; M_2 M_3). */
static void orbit(int n, const num_q M[], num_q P[])
{
    for (int k = 0; k < n; k++)
        for (int j = 0; j < 2; j++)
            P[2 * k + 2 + j] = add_q(mul_q(P[2 * k], M[j]), mul_q(P[2 * k + 1], M[2 + j]));
}

/* The rotation with the tangent a of half its angle, the first and the second way with the step e. */
static void generator(int way, num_q e, num_q M[])
{
    num_q one = q(1), ee = mul_q(e, e), below = add_q(one, ee);
    M[0] = M[3] = way == 0 ? div_q(sub_q(one, ee), below) : one;
    M[1] = way == 0 ? div_q(mul_q(q(2), e), below) : e;
    M[2] = neg_q(M[1]);
    if (way == 2)
        M[3] = sub_q(one, ee);
}

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

/* 4(x^2 + y^2 - 2 s xy) - 4(1 - s^2) for s = 1/2: the printed equation with r = 1. */
static num_q printed_ellipse(svg_point P, const void *data)
{
    (void)data;
    num_q squares = add_q(mul_q(P.x, P.x), mul_q(P.y, P.y));
    return sub_q(sub_q(squares, mul_q(P.x, P.y)), r(3, 4));
}

FIGURE(ellipse_of_the_second_way)
{
    svg *s = svg_new("ellipse_of_the_second_way", "The ellipse of the second way leaves the circle in both directions",
                     "The printed ellipse for sine one half, which is epsilon 1, so that the deviation can be seen, "
                     "and the circle.  On one "
                     "diagonal the ellipse is outside by the root of 3/2 minus 1, about 0.22, on the other inside by 1 "
                     "minus the root of "
                     "1/2, about 0.29.  The six points of the closed orbit are marked.");
    svg_panel(s, window(r(-7, 5), r(-7, 5), r(7, 5), r(7, 5)), 400, 0, "$s$ = sin($Δθ/2$) = 1/2, $r$ = 1");
    svg_axes(s, q(1), q(1), "x", "y");
    svg_line(s, svg_at(-1, -1), svg_at(1, 1), SVG_MUTED);
    svg_line(s, svg_at(-1, 1), svg_at(1, -1), SVG_MUTED);
    svg_circle(s, svg_at(0, 0), q(1), SVG_CURVE_2);
    svg_implicit(s, printed_ellipse, NULL, 160, SVG_CURVE);
    num_q M[4], P[14] = {q(1), r(1, 2)};
    generator(2, q(1), M);
    orbit(6, M, P);
    for (int k = 0; k < 6; k++)
        svg_mark(s, svg_pair(P + 2 * k), SVG_POINT, SVG_USUAL);
    svg_note(s, at(r(9, 10), r(23, 20)), SVG_HERE, SVG_CURVE, "outwards $\\√(3/2)-1$");
    svg_note(s, at(r(9, 10), r(-23, 20)), SVG_HERE, SVG_CURVE, "inwards $1-\\√(1/2)$");
    svg_legend_line(s, SVG_CURVE, "the printed ellipse");
    svg_legend_line(s, SVG_CURVE_2, "the circle");
    svg_legend_mark(s, SVG_POINT, SVG_USUAL, "points of the orbit, $ε=1$");
    return s;
}

/* (s, sqrt(1+s) - 1), through the parameter E: s = (1+E)^2 - 1. */
static svg_point true_error(num_q E, const void *data)
{
    (void)data;
    num_q side = add_q(q(1), E);
    return at(mul_q(q(100), sub_q(mul_q(side, side), q(1))), mul_q(q(100), E));
}
/* (s, 1 - sqrt(1-s)) */
static svg_point inner_error(num_q E, const void *data)
{
    (void)data;
    num_q side = sub_q(q(1), E);
    return at(mul_q(q(100), sub_q(q(1), mul_q(side, side))), mul_q(q(100), E));
}

FIGURE(error_of_the_second_way)
{
    svg *s = svg_new("error_of_the_second_way", "The printed approximation is twice the error",
                     "The error of the ellipse in per cent against the sine s, which is one half of epsilon.  The "
                     "printed approximation is "
                     "the line E = s, twice too steep; half the sine, E = s/2, lies between the outer and the inner "
                     "error.  The marks "
                     "are m = 4, 3 and 2.");
    svg_panel(s, window(q(0), q(0), q(14), q(10)), 420, 300, "error in per cent, against $100s=100\\·2^{-m-1}$");
    svg_axes(s, q(2), q(2), "100s", "100E");
    svg_segment(s, svg_at(0, 0), svg_at(10, 10), SVG_WRONG);
    svg_segment(s, svg_at(0, 0), svg_at(14, 7), SVG_RIGHT);
    svg_plot(s, true_error, NULL, q(0), r(7, 100), 24, SVG_CURVE);
    svg_plot(s, inner_error, NULL, q(0), r(3, 40), 24, SVG_CURVE_2);
    static const char *const names[3] = {"m=2", "m=3", "m=4"};
    for (int m = 4; m >= 2; m--) {
        num_q x = r(100, 1L << (m + 1)), half = mul_q(r(1, 2), x);
        svg_mark(s, at(x, half), SVG_RIGHT, SVG_USUAL);
        svg_label(s, at(x, half), SVG_SE, SVG_RIGHT, names[m - 2]);
        if (m > 2)
            svg_mark(s, at(x, x), SVG_WRONG, SVG_USUAL);
    }
    svg_legend_line(s, SVG_WRONG, "printed: $2^{-(m+1)}$");
    svg_legend_line(s, SVG_RIGHT, "$2^{-(m+2)}$");
    svg_legend_line(s, SVG_CURVE, "$E$, outwards");
    svg_legend_line(s, SVG_CURVE_2, "inwards");
    return s;
}

FIGURE(step_of_the_third_way)
{
    svg *s = svg_new("step_of_the_third_way", "At height one the second point is more than one away",
                     "A circle of radius 5/4.  The point at height 1 is farther than 1 from the first point: the "
                     "circle of radius 1 about "
                     "the first point meets the circle below it.");
    num_q radius = r(5, 4);
    svg_panel(s, window(r(-1, 4), r(-1, 4), r(5, 2), r(5, 4)), 420, 0, "$r=5/4$: $|A_0A_1|=\\√5/2$ at height 1");
    svg_circle(s, svg_at(0, 0), radius, SVG_CURVE);
    svg_circle(s, at(radius, q(0)), q(1), SVG_MUTED);
    svg_line(s, svg_at(0, 1), svg_at(1, 1), SVG_FAMILY);
    svg_point first = at(radius, q(0)), second = at(r(3, 4), q(1));
    svg_segment(s, first, second, SVG_WRONG);
    svg_segment(s, svg_at(0, 0), first, SVG_POLYGON);
    svg_segment(s, svg_at(0, 0), second, SVG_POLYGON);
    svg_mark(s, first, SVG_POINT, SVG_USUAL);
    svg_label(s, first, SVG_SE, SVG_POINT, "A_0");
    svg_mark(s, second, SVG_WRONG, SVG_USUAL);
    svg_label(s, second, SVG_N, SVG_WRONG, "A_1");
    svg_legend_line(s, SVG_CURVE, "the circle");
    svg_legend_line(s, SVG_MUTED, "distance 1 from $A_0$");
    svg_legend_line(s, SVG_FAMILY, "height 1");
    svg_legend_line(s, SVG_WRONG, "the distance of the two points");
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
