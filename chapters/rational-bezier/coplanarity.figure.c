/* The figure of the section on plane curves. */
#include "chapters/judge/figure.h"
#include "chapters/judge/figure_data.h"
#include "exact/kernels_q.h"
#include "exact/record/number.h"
#include "figures/svg.h"

enum { N = 3 };

/* A parallel projection of space: x to the right and down, y to the right and up, z up. */
static void project(const num_q P[3], num_q out[2])
{
    out[0] = add_q(P[0], mul_q(from_ratio_q(3, 4), P[1]));
    out[1] = add_q(mul_q(from_ratio_q(1, 2), sub_q(P[1], mul_q(from_ratio_q(1, 2), P[0]))), P[2]);
}

/* The cubic with these weights; the plane z = 0 is shaded. */
static void panel(svg *s, const num_q w[], const char *caption)
{
    static const long corner[3 * 4] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    static const enum svg_direction side[] = {SVG_W, SVG_N, SVG_S, SVG_NE};
    static const char *const name[] = {"R_0", "R_1", "R_2", "R_3"};
    num_q point[3 * (N + 1)], R[2 * (N + 1)], plane[2 * 4], P[3];
    data_of("vertex_of_weight_zero_leaves_the_plane", "R", N + 1, 3, point);
    for (int i = 0; i <= N; i++) {
        project(point + 3 * i, R + 2 * i);
        for (int c = 0; c < 3; c++)
            P[c] = from_int_q(corner[3 * i + c]);
        project(P, plane + 2 * i);
    }
    svg_panel(s, (svg_window){from_ratio_q(-1, 2), from_ratio_q(-1, 2), from_int_q(2), from_ratio_q(3, 2)}, 300, 0,
              caption);
    svg_area(s, 4, plane, SVG_FILL);
    svg_polyline(s, N + 1, R, SVG_POLYGON);
    svg_rational(s, N, R, w, SVG_CURVE);
    for (int i = 0; i <= N; i++) {
        int hidden = is_zero_q(w[i]);
        svg_mark(s, svg_pair(R + 2 * i), hidden ? SVG_WRONG : SVG_POLYGON, SVG_USUAL);
        svg_label(s, svg_pair(R + 2 * i), side[i], hidden ? SVG_WRONG : SVG_POLYGON, name[i]);
    }
}

FIGURE(weight_zero_out_of_plane)
{
    svg *s =
        svg_new("weight_zero_out_of_plane", "A vertex of weight 0 may be out of the plane of the curve",
                "Two cubics of space with the same four vertices, three of them in the plane z = 0. Left: the second "
                "vertex, above the plane, has weight 0, and the curve is in the plane. Right: it has weight 1, and the "
                "curve rises from the plane.");
    num_q w[N + 1];
    data_of("vertex_of_weight_zero_leaves_the_plane", "ω", N + 1, 1, w);
    panel(s, w, "weights $1, 0, 1, 1$: a curve in $z = 0$\nwhose vertices are not coplanar");
    svg_heading(s, SVG_WRONG, "the vertices are coplanar");
    w[1] = from_int_q(1);
    panel(s, w, "weights $1, 1, 1, 1$: not a plane curve");
    svg_legend_line(s, SVG_CURVE, "curve");
    svg_legend_line(s, SVG_POLYGON, "polygon");
    svg_legend_area(s, SVG_FILL, "in the plane $z = 0$");
    return s;
}
