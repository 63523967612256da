/* shape-figures.h -- what the figures of the sections on the shape of NURBS curves have in common. */
#ifndef CAGD_NURBS_SHAPE_FIGURES_H
#define CAGD_NURBS_SHAPE_FIGURES_H

#include "chapters/judge/figure.h"
#include "exact/kernels_q.h"
#include "exact/record/span.h"
#include "figures/svg.h"

enum { LARGEST = 40 }; /* points */

/* A NURBS curve of the plane: n points of degree p, all indices from 0. */
struct nurbs {
    int n, p;
    num_q u[2 * LARGEST], R[2 * LARGEST], w[LARGEST];
};

/* weight NULL: all 1.  Knots are given in halves. */
static inline struct nurbs nurbs_of(int n, int p, const long point[], const long weight[], const long half_knot[])
{
    struct nurbs s = {.n = n, .p = p};
    for (int i = 0; i < n; i++) {
        s.w[i] = from_int_q(weight != NULL ? weight[i] : 1);
        s.R[2 * i] = from_int_q(point[2 * i]);
        s.R[2 * i + 1] = from_int_q(point[2 * i + 1]);
    }
    for (int i = 0; i <= n + p; i++)
        s.u[i] = from_ratio_q(half_knot[i], 2);
    return s;
}

/* The same curve with one more knot, inside the domain. */
static inline struct nurbs with_knot(struct nurbs s, num_q x)
{
    struct nurbs out = {.n = s.n + 1, .p = s.p};
    nurbs_insert_q(s.n, s.p, 2, s.u, find_span_q(s.n, s.p, s.u, x), s.R, s.w, x, out.u, out.R, out.w);
    return out;
}

static inline svg_point nurbs_at(struct nurbs s, num_q t)
{
    num_q P[2];
    nurbs_point_q(s.p, 2, s.u, find_span_q(s.n, s.p, s.u, t), s.R, s.w, t, P);
    return svg_pair(P);
}

/* The curve, interval by interval, as rational Bézier curves. */
static inline void draw_nurbs(svg *s, struct nurbs c, enum svg_role role)
{
    for (int mu = c.p; mu < c.n; mu++)
        if (compare_q(c.u[mu], c.u[mu + 1]) < 0) {
            num_q H[3 * LARGEST], b[3 * LARGEST], R[2 * LARGEST], w[LARGEST];
            rational_homogenize_q(c.n - 1, 2, c.R, c.w, H);
            bspline_to_bezier_q(c.p, 3, c.u, mu, H, b);
            rational_dehomogenize_q(c.p, 2, b, R, w);
            svg_rational(s, c.p, R, w, role);
        }
}

/* The polygon with labels r_1, ..., r_n in given directions; SVG_HERE for none. */
static inline void draw_numbered(svg *s, struct nurbs c, const enum svg_direction side[])
{
    static const char *const name[] = {"r_1", "r_2", "r_3", "r_4", "r_5", "r_6", "r_7"};
    svg_polyline(s, c.n, c.R, SVG_POLYGON);
    for (int i = 0; i < c.n; i++) {
        svg_mark(s, svg_pair(c.R + 2 * i), SVG_POLYGON, SVG_USUAL);
        if (side[i] != SVG_HERE)
            svg_label(s, svg_pair(c.R + 2 * i), side[i], SVG_POINT, name[i]);
    }
}

/* A polygon with its vertices marked. */
static inline void draw_marked(svg *s, struct nurbs c, enum svg_role role)
{
    svg_polyline(s, c.n, c.R, role);
    for (int i = 0; i < c.n; i++)
        svg_mark(s, svg_pair(c.R + 2 * i), role, SVG_USUAL);
}
#endif
