/* Figures of the section on shapes that do not know their coordinates. */
#include "chapters/foundations/figures.h"

/* D, C, B, A of (1-t)^3 P_0 + t^3 P_1 */
static void two_cubes(const num_q P[], num_q c[])
{
    const int binomials[4] = {1, -3, 3, -1};
    for (int k = 0; k <= 3; k++)
        for (int j = 0; j < 2; j++) {
            c[2 * k + j] = mul_q(q(binomials[k]), P[j]);
            if (k == 3)
                c[2 * k + j] = add_q(c[2 * k + j], P[2 + j]);
        }
}

static void put_two_cubes(svg *s, const num_q P[], enum svg_role role)
{
    num_q c[8];
    two_cubes(P, c);
    put_power_curve(s, 3, c, q(0), q(1), role);
}

static void put_point(svg *s, svg_point P, enum svg_direction towards, enum svg_role role, const char *name)
{
    svg_mark(s, P, role, SVG_USUAL);
    svg_label(s, P, towards, role, name);
}

FIGURE(two_cubes_and_their_image)
{
    svg *s = svg_new(
        "two_cubes_and_their_image", "One formula, two systems of coordinates, two shapes",
        "The points (0, 0) and (10, 10) with the factors (1-t) cubed and t cubed.  Left in the first coordinates "
        "the formula gives the segment between them; right in coordinates with the origin (3, 2) it gives an arc "
        "that leaves the segment.");
    const int first[4] = {0, 0, 10, 10}, second[4] = {-3, -2, 7, 8};
    for (int k = 0; k < 2; k++) {
        num_q P[4];
        integers(4, k ? second : first, P);
        svg_panel(s, k ? svg_integer_window(-4, -3, 8, 9) : svg_integer_window(-1, -1, 11, 11), 330, 0,
                  k ? "in the coordinates with the origin $(3,2)$" : "in the first coordinates");
        svg_axes(s, q(2), q(2), k ? "x^*" : "x", k ? "y^*" : "y");
        if (k)
            svg_segment(s, svg_pair(P), svg_pair(P + 2), SVG_MUTED);
        put_two_cubes(s, P, k ? SVG_WRONG : SVG_CURVE);
        put_point(s, svg_pair(P), k ? SVG_SW : SVG_SE, SVG_POINT, k ? "P_0^*" : "P_0");
        put_point(s, svg_pair(P + 2), SVG_NW, SVG_POINT, k ? "P_1^*" : "P_1");
        if (k)
            put_point(s, at(r(1, 2), r(3, 4)), SVG_SE, SVG_WRONG, "P^*(1/2)");
    }
    svg_legend_line(s, SVG_CURVE, "$(1-t)^3P_0+t^3P_1$");
    svg_legend_line(s, SVG_WRONG, "the same formula");
    svg_legend_line(s, SVG_MUTED, "the segment");
    return s;
}

FIGURE(rotations_of_the_example)
{
    svg *s = svg_new(
        "rotations_of_the_example", "A rotation about the origin, and one about another point",
        "The curve of two cubes with the points (3, 0) and (2, 3).  Left its points are turned by a right angle about "
        "the origin, and the curve of the turned points is the turned curve.  Right they are turned about (3, 1), "
        "and it is not.");
    const int points[4] = {3, 0, 2, 3};
    for (int k = 0; k < 2; k++) {
        num_q P[4], turned[4], centre[2] = {q(k ? 3 : 0), q(k ? 1 : 0)}, c[8], image[8];
        integers(4, points, P);
        for (int i = 0; i < 2; i++) {
            turned[2 * i] = sub_q(centre[0], sub_q(P[2 * i + 1], centre[1]));
            turned[2 * i + 1] = add_q(centre[1], sub_q(P[2 * i], centre[0]));
        }
        two_cubes(P, c);
        for (int m = 0; m <= 3; m++) { /* the coefficients turn, the centre is added to the constant one */
            image[2 * m] = neg_q(c[2 * m + 1]);
            image[2 * m + 1] = c[2 * m];
        }
        image[0] = add_q(image[0], add_q(centre[0], centre[1]));
        image[1] = add_q(image[1], sub_q(centre[1], centre[0]));
        svg_panel(s, k ? window(r(-1, 2), r(-3, 2), q(5), r(7, 2)) : window(r(-7, 2), r(-1, 2), r(7, 2), r(7, 2)),
                  k ? 300 : 360, 0, k ? "about $(3,1)$" : "about the origin");
        svg_axes(s, q(1), q(1), "x", "y");
        put_two_cubes(s, P, SVG_CURVE);
        put_power_curve(s, 3, image, q(0), q(1), k ? SVG_CURVE_2 : SVG_RIGHT);
        if (k)
            put_two_cubes(s, turned, SVG_WRONG);
        svg_mark(s, svg_pair(centre), SVG_POINT, SVG_RING);
        for (int i = 0; i < 2; i++) {
            put_point(s, svg_pair(P + 2 * i), SVG_E, SVG_POINT, i ? "P_1" : "P_0");
            put_point(s, svg_pair(turned + 2 * i), k && i ? SVG_S : SVG_NW, SVG_POINT, i ? "P_1^*" : "P_0^*");
        }
    }
    svg_legend_line(s, SVG_CURVE, "the curve");
    svg_legend_line(s, SVG_RIGHT, "turned, either way");
    svg_legend_line(s, SVG_CURVE_2, "the curve turned");
    svg_legend_line(s, SVG_WRONG, "the curve of the turned points");
    return s;
}

/* (t, (1-t)^3 + t^3) and (t, 1) */
static svg_point sum_of_cubes(num_q t, const void *data)
{
    (void)data;
    num_q s = sub_q(q(1), t);
    return at(t, sub_q(q(1), mul_q(q(3), mul_q(s, t))));
}

FIGURE(sums_of_functions)
{
    svg *s = svg_new(
        "sums_of_functions", "Sums of functions, and what a translation does",
        "Left the sum of the two cubes, which is 1 at the ends only, and falls to a quarter; the sum 1 of the "
        "Bernstein functions; and the sum 2 of their doubles.  Right a parabola with doubled Bernstein functions: its "
        "points are translated by (1, 1/2), and the curve by (2, 1); the shape is kept, the place is not.");
    svg_panel(s, window(q(0), q(0), q(1), r(9, 4)), 230, 230, "sums of the functions");
    svg_axes(s, r(1, 2), r(1, 4), "t", NULL);
    svg_plot(s, sum_of_cubes, NULL, q(0), q(1), 64, SVG_WRONG);
    svg_segment(s, svg_at(0, 1), svg_at(1, 1), SVG_RIGHT);
    svg_segment(s, svg_at(0, 2), svg_at(1, 2), SVG_CURVE_2);
    const int points[6] = {0, 0, 1, 3, 2, 1};
    num_q R[6], doubled[6], moved[6], shifted[6];
    for (int m = 0; m < 6; m++) {
        num_q step = m % 2 ? r(1, 2) : q(1);
        R[m] = r(points[m], 2);
        doubled[m] = mul_q(q(2), R[m]);
        shifted[m] = add_q(R[m], step);
        moved[m] = mul_q(q(2), shifted[m]);
    }
    svg_panel(s, window(r(-1, 4), r(-1, 4), r(17, 4), r(13, 4)), 330, 0, "$φ_i=2B_i^2$, translation $m=(1,1/2)$");
    svg_polyline(s, 3, R, SVG_POLYGON);
    svg_polyline(s, 3, shifted, SVG_MUTED);
    svg_bezier(s, 2, doubled, SVG_CURVE);
    svg_bezier(s, 2, moved, SVG_CURVE_2);
    svg_arrow(s, svg_pair(R), svg_pair(shifted), SVG_POINT);
    svg_label(s, at(r(1, 2), r(1, 4)), SVG_SE, SVG_POINT, "m");
    svg_arrow(s, svg_pair(doubled + 4), svg_pair(moved + 4), SVG_POINT);
    svg_label(s, at(q(3), r(3, 2)), SVG_SE, SVG_POINT, "2m");
    svg_legend_line(s, SVG_WRONG, "$(1-t)^3+t^3$");
    svg_legend_line(s, SVG_RIGHT, "$B_0^n+...+B_n^n$");
    svg_legend_line(s, SVG_CURVE_2, "doubled, translated");
    svg_legend_line(s, SVG_CURVE, "doubled");
    svg_legend_line(s, SVG_POLYGON, "the points $Q_i$");
    return s;
}

FIGURE(projective_image_of_a_parabola)
{
    svg *s = svg_new(
        "projective_image_of_a_parabola", "A projective map of the points is not one of the curve",
        "The parabola with the control points (0, 0), (1, 0), (1, 1) and its image under (x, y) to (x/(1+y), y/(1+y)). "
        " "
        "The polynomial curve of the images of the control points is another curve; with the weights 1, 1, 2 it is "
        "the image.");
    const int points[6] = {0, 0, 1, 0, 1, 1};
    num_q R[6], image[6], w[3];
    integers(6, points, R);
    for (int i = 0; i < 3; i++) {
        w[i] = add_q(q(1), R[2 * i + 1]);
        for (int j = 0; j < 2; j++)
            image[2 * i + j] = div_q(R[2 * i + j], w[i]);
    }
    svg_panel(s, window(r(-1, 10), r(-1, 10), r(6, 5), r(11, 10)), 300, 0, "the parabola");
    svg_control_polygon(s, 2, R, "R");
    svg_bezier(s, 2, R, SVG_CURVE);
    svg_panel(s, window(r(-1, 10), r(-1, 10), r(6, 5), r(3, 5)), 480, 0, "its image");
    svg_control_polygon(s, 2, image, "S");
    svg_bezier(s, 2, image, SVG_WRONG);
    svg_rational(s, 2, image, w, SVG_RIGHT);
    svg_legend_line(s, SVG_CURVE, "the curve");
    svg_legend_line(s, SVG_WRONG, "polynomial, of the images");
    svg_legend_line(s, SVG_RIGHT, "image of the curve: weights $1,1,2$");
    return s;
}
