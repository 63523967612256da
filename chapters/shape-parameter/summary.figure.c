/* summary.figure.c -- drawings for summary.claims.h. */
#include "chapters/shape-parameter/drawing.h"

FIGURE(petals)
{
    svg *s =
        svg_new("petals", "Closed curves of several beta",
                "A polygon whose first and last point coincide, and the nine closed curves of β = 1, 0, -1, ..., -7.");
    static const int from[] = {0, 0, -6, 3, -6, 9, -1, 12, 1, 12, 6, 9, 6, 3, 0, 0};
    num_q P[16];
    points(8, from, P);
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
