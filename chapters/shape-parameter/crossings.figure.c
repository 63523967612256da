/* crossings.figure.c -- drawings for crossings.claims.h. */
#include "chapters/shape-parameter/drawing.h"

static const int triangle[] = {0, 0, 0, 0, 1, 1, 2, 0, 2, 0, 2, 0, 2, 0, 2, 0};

static void put_triangle(svg *s, num_q level)
{
    num_q P[16];
    integers(2 * 8, triangle, P);
    svg_polyline(s, 8, P, SVG_POLYGON);
    put_curve(s, 0, 7, P, r(-21, 4), SVG_RIGHT);
    put_curve(s, 0, 7, P, q(-7), SVG_WRONG);
    svg_line(s, at(q(0), level), at(q(1), level), SVG_POINT);
    svg_frame(s);
}

FIGURE(crossings_off_the_polygon)
{
    svg *s = svg_new(
        "crossings_off_the_polygon", "Lines that meet the curve and not its polygon",
        "Left eight points on the line y = 1 and the printed curve of β = 1, which sinks below the line y = 63/64. "
        " Right a triangle, enlarged near its first corner: the curve of β = -7 crosses the line y = -1/200 "
        "below the triangle twice, that of β = -21/4 does not.");
    num_q P[16];
    for (int i = 0; i <= 7; i++)
        P[2 * i] = q(i), P[2 * i + 1] = q(1);
    svg_panel(s, window(q(0), r(24, 25), q(7), r(101, 100)), 360, 250, "as printed, $β=1$ ($y$ stretched)");
    svg_axes(s, q(1), r(1, 100), "x", "y");
    svg_polyline(s, 8, P, SVG_POLYGON);
    put_curve(s, 1, 7, P, q(1), SVG_WRONG);
    svg_line(s, at(q(0), r(63, 64)), at(q(1), r(63, 64)), SVG_POINT);
    svg_panel(s, window(r(-1, 100), r(-3, 200), r(3, 25), r(1, 25)), 360, 250,
              "corrected, $β=-7$ and $β=-21/4$, near $P_0=P_1$");
    put_triangle(s, r(-1, 200));
    svg_legend_line(s, SVG_POLYGON, "the polygon");
    svg_legend_line(s, SVG_WRONG, "crosses the line");
    svg_legend_line(s, SVG_RIGHT, "$β=-21/4$");
    svg_legend_line(s, SVG_POINT, "the line");
    return s;
}

FIGURE(convexity_lost)
{
    svg *s =
        svg_new("convexity_lost", "Convex polygons whose curves are not convex",
                "Left the triangle (0,0), (1,1), (2,0) with the curve of β = -7, which meets the base three times, and "
                "that of β = -21/4, which is convex.  Right a flat convex polygon at height 100, the printed curve of "
                "β = 1, which crosses a line four times, and the corrected one.");
    num_q P[16];
    svg_panel(s, window(r(-1, 10), r(-1, 10), r(21, 10), r(11, 10)), 380, 0, "$P_0=P_1$, $P_2$, $P_3=...=P_7$");
    put_triangle(s, q(0));
    for (int i = 0; i <= 7; i++)
        P[2 * i] = q(i), P[2 * i + 1] = q(i == 0 || i == 7 ? 100 : 101);
    svg_panel(s, window(r(-1, 4), r(193, 2), r(29, 4), r(203, 2)), 340, 230, "$β=1$, $y$ from 96.5 to 101.5");
    svg_polyline(s, 8, P, SVG_POLYGON);
    put_curve(s, 1, 7, P, q(1), SVG_WRONG);
    put_curve(s, 0, 7, P, q(1), SVG_RIGHT);
    svg_line(s, at(q(0), r(401, 4)), at(q(1), r(401, 4)), SVG_POINT);
    svg_frame(s);
    svg_legend_line(s, SVG_POLYGON, "the polygon");
    svg_legend_line(s, SVG_WRONG, "$β=-7$; as printed");
    svg_legend_line(s, SVG_RIGHT, "$β=-21/4$; corrected");
    svg_legend_line(s, SVG_POINT, "a line");
    return s;
}

FIGURE(roots_at_minus_seven)
{
    svg *s =
        svg_new("roots_at_minus_seven", "More roots than changes of sign",
                "Sums of the printed functions with the coefficients 1, 1, 200, 1, 1, 1, 1 and 1 or -1.  For β = -7 "
                "the first has two roots and no change of sign in its coefficients, the second three roots and one "
                "change; for β = -21/4 there are none, and one.");
    for (int last = 1; last >= -1; last -= 2) {
        num_q near[8], far[8], a[8];
        for (int i = 0; i <= 7; i++)
            a[i] = q(i == 2 ? 200 : i == 7 ? last : 1);
        svg_panel(s, window(q(0), q(-2), q(1), q(4)), 320, 240,
                  last > 0 ? "$k=(1,1,200,1,1,1,1,1)$" : "$k=(1,1,200,1,1,1,1,-1)$");
        svg_axes(s, r(1, 4), q(1), "t", NULL);
        factors(1, 7, r(-21, 4), near, far);
        put_graph(s, 7, near, far, a, SVG_RIGHT);
        factors(1, 7, q(-7), near, far);
        put_graph(s, 7, near, far, a, SVG_WRONG);
    }
    svg_legend_line(s, SVG_WRONG, "$β=-7$");
    svg_legend_line(s, SVG_RIGHT, "$β=-21/4$");
    return s;
}

FIGURE(line_along_an_edge)
{
    svg *s =
        svg_new("line_along_an_edge", "A line that contains an edge of the polygon",
                "The convex polygon of the points (i, i(7-i)).  The line y = 12 contains the edge from P₃ to P₄ and "
                "has it on no side; the line y = 8 crosses two edges.");
    num_q P[16];
    for (int i = 0; i <= 7; i++)
        P[2 * i] = q(i), P[2 * i + 1] = q(i * (7 - i));
    svg_panel(s, window(q(-1), q(-1), q(8), q(14)), 380, 260, NULL);
    svg_polyline(s, 8, P, SVG_POLYGON);
    static const char *const names[8] = {"P_0", "P_1", "P_2", "P_3", "P_4", "P_5", "P_6", "P_7"};
    for (int i = 0; i <= 7; i++) {
        svg_mark(s, svg_pair(P + 2 * i), SVG_POLYGON, SVG_USUAL);
        svg_label(s, svg_pair(P + 2 * i), i == 3 || i == 4 ? SVG_N : i < 3 ? SVG_W : SVG_E, SVG_POLYGON, names[i]);
    }
    svg_line(s, svg_at(0, 12), svg_at(1, 12), SVG_WRONG);
    svg_line(s, svg_at(0, 8), svg_at(1, 8), SVG_RIGHT);
    svg_legend_line(s, SVG_WRONG, "contains an edge");
    svg_legend_line(s, SVG_RIGHT, "crosses two edges");
    return s;
}

FIGURE(polygon_crossing_itself)
{
    svg *s =
        svg_new("polygon_crossing_itself", "A polygon that crosses itself on a line",
                "A polygon of eight points whose first and last edges meet the x-axis in the same point: it changes "
                "sides twice and has one point on the line.");
    static const int vertex[16] = {-2, 2, 2, -2, 2, -3, 1, -3, -1, -3, -2, -3, -2, -2, 2, 2};
    static const enum svg_direction towards[] = {SVG_NW, SVG_E, SVG_E, SVG_S, SVG_S, SVG_W, SVG_W, SVG_NE};
    num_q P[16];
    integers(2 * 8, vertex, P);
    svg_panel(s, window(r(-7, 2), r(-7, 2), r(7, 2), r(5, 2)), 380, 0, "$SA=2$, one point on $L$");
    svg_line(s, svg_at(0, 0), svg_at(1, 0), SVG_RIGHT);
    svg_label(s, svg_at(3, 0), SVG_N, SVG_RIGHT, "L");
    svg_control_polygon_towards(s, 7, P, "P", towards);
    svg_mark(s, svg_at(0, 0), SVG_WRONG, SVG_USUAL);
    svg_legend_line(s, SVG_POLYGON, "the polygon");
    svg_legend_mark(s, SVG_WRONG, SVG_USUAL, "the point, passed twice");
    return s;
}

FIGURE(zero_at_the_beginning)
{
    svg *s = svg_new(
        "zero_at_the_beginning", "A sum whose first coefficient is 0",
        "The sum of the corrected functions of β = 1 with the coefficients 0, -1, 1, 1, 1, 1, 1, 1: it is 0 at t = "
        "0, negative at first, as its first coefficient that is not 0 is, and has one root.");
    num_q near[8], far[8], a[8];
    for (int i = 0; i <= 7; i++)
        a[i] = q(i == 0 ? 0 : i == 1 ? -1 : 1);
    svg_panel(s, window(q(0), r(-1, 2), q(1), q(1)), 360, 240, "$k=(0,-1,1,1,1,1,1,1)$, $β=1$");
    svg_axes(s, r(1, 4), r(1, 2), "t", NULL);
    factors(0, 7, q(1), near, far);
    put_graph(s, 7, near, far, a, SVG_CURVE);
    svg_mark(s, svg_at(0, 0), SVG_WRONG, SVG_USUAL);
    svg_label(s, svg_at(0, 0), SVG_NE, SVG_WRONG, "f(0)=0");
    return s;
}
