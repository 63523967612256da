/* surface.figure.c -- drawings for surface.claims.h. */
#include "chapters/judge/counting.h"
#include "chapters/shape-parameter/drawing.h"

/* The kernels of Bézier curves in the type that counts. */
#define G(name) name##_c
#include "core/kernels/bezier.tmpl.h"
#undef G

#include <stdio.h>

FIGURE(petals)
{
    svg *s =
        svg_new("petals", "Closed curves of several beta",
                "A polygon whose first and last point coincide, and the nine closed curves of β = 1, 0, -1, ..., -7.");
    static const int from[] = {0, 0, -6, 3, -6, 9, -1, 12, 1, 12, 6, 9, 6, 3, 0, 0};
    num_q P[16];
    integers(2 * 8, from, P);
    svg_panel(s, window(q(-8), q(-1), q(8), q(13)), 380, 0, NULL);
    svg_polyline(s, 8, P, SVG_POLYGON);
    nine_curves(s, P);
    return s;
}

/* The picture of a point of space: the shear that takes z = xy to z = (x - 7/2)(y - 7/2), seen from the side. */
static void project(const num_q X[], num_q out[])
{
    num_q x = sub_q(X[0], r(7, 2)), y = sub_q(X[1], r(7, 2));
    num_q height = sub_q(sub_q(X[2], mul_q(r(7, 2), add_q(X[0], X[1]))), r(-49, 4));
    out[0] = sub_q(x, mul_q(r(4, 5), y));
    out[1] = add_q(div_q(add_q(x, y), q(4)), div_q(height, q(6)));
}

FIGURE(shape_surface)
{
    svg *s =
        svg_new("shape_surface", "A net of straight rows and columns and its saddle",
                "The points (i, j, ij), i and j from 0 to 7, in parallel projection: rows and columns of the net are "
                "straight.  The surface of β = -5, drawn by its parameter lines, lies on the saddle z = xy.");
    num_q P[8 * 8 * 3], line[2 * 8], X[3];
    for (int i = 0; i <= 7; i++)
        for (int j = 0; j <= 7; j++) {
            P[(i * 8 + j) * 3] = q(i);
            P[(i * 8 + j) * 3 + 1] = q(j);
            P[(i * 8 + j) * 3 + 2] = q(i * j);
        }
    for (int surface = 0; surface <= 1; surface++) {
        svg_panel(s, window(q(-7), r(-5, 2), q(7), q(4)), 330, 0,
                  surface ? "the parameter lines of $β=-5$" : "the net");
        for (int direction = 0; direction < 2; direction++)
            for (int i = 0; i <= 7; i++) {
                for (int j = 0; j <= 7; j++) {
                    int row = direction ? j : i, column = direction ? i : j;
                    if (surface)
                        shape_surface_point_q(7, 7, 3, P, q(-5), q(-5), r(row, 7), r(column, 7), X);
                    project(surface ? X : P + (row * 8 + column) * 3, line + 2 * j);
                }
                svg_polyline(s, 8, line, i % 7 == 0 ? SVG_CURVE : SVG_FAMILY);
            }
    }
    return s;
}

FIGURE(operations_for_a_point)
{
    svg *s =
        svg_new("operations_for_a_point", "The operations for a point of a curve of the plane",
                "Bars for the products and the sums: Horner's rule in the degrees 7 and 8, de Casteljau's algorithm in "
                "the degrees 7 and 8.  By either method the degree 8 takes more; by Horner's rule it takes less than "
                "half of what de Casteljau's algorithm takes in degree 7.");
    static const char *const name[4] = {"Horner\\'s rule, $n=7$", "Horner\\'s rule, $n=8$", "de Casteljau, $n=7$",
                                        "de Casteljau, $n=8$"};
    svg_panel(s, window(q(-60), r(-1, 2), q(165), r(15, 2)), 560, 220, "operations for one point, two coordinates");
    for (int tick = 0; tick <= 150; tick += 50)
        svg_line(s, svg_at(tick, 0), svg_at(tick, 1), SVG_MUTED);
    for (int bar = 0; bar < 4; bar++) {
        num_c b[2 * (MAX_DEGREE + 1)] = {{0}}, P[2], t = {0};
        counted = (struct operations){0};
        (bar < 2 ? bezier_horner_c : bezier_casteljau_c)(7 + bar % 2, 2, b, t, P);
        for (int sums = 0; sums <= 1; sums++) {
            char number[16];
            int count = sums ? counted.additions : counted.multiplications + counted.shifts;
            num_q high = sub_q(q(7 - 2 * bar), r(7 * sums, 10)), low = sub_q(high, r(3, 5));
            num_q box[8] = {q(0), low, q(count), low, q(count), high, q(0), high};
            svg_area(s, 4, box, sums ? SVG_CURVE_2 : SVG_CURVE);
            svg_polyline(s, 4, box, sums ? SVG_CURVE_2 : SVG_CURVE);
            snprintf(number, sizeof number, "%d", count);
            svg_label(s, at(q(count), div_q(add_q(low, high), q(2))), SVG_E, SVG_POINT, number);
        }
        svg_note(s, at(q(0), sub_q(q(7 - 2 * bar), r(13, 20))), SVG_W, SVG_POINT, name[bar]);
    }
    svg_legend_area(s, SVG_CURVE, "products");
    svg_legend_area(s, SVG_CURVE_2, "sums");
    return s;
}
