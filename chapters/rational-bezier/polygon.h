/* polygon.h -- what the figures of the polygon's properties have in common. */
#ifndef CAGD_RATIONAL_BEZIER_POLYGON_H
#define CAGD_RATIONAL_BEZIER_POLYGON_H

#include "chapters/judge/figure.h"
#include "chapters/judge/figure_data.h"
#include "exact/kernels_q.h"
#include "figures/svg.h"

enum { LARGEST = 32 }; /* degree */

/* The control polygon of a rational curve of the plane. */
struct polygon {
    int n;
    num_q R[2 * (LARGEST + 1)], w[LARGEST + 1];
};

static inline struct polygon polygon_of(int n, const long point[], const long weight[])
{
    struct polygon p = {.n = n};
    for (int i = 0; i <= n; i++) {
        p.w[i] = from_int_q(weight[i]);
        p.R[2 * i] = from_int_q(point[2 * i]);
        p.R[2 * i + 1] = from_int_q(point[2 * i + 1]);
    }
    return p;
}

/* The one whose points R and weights ω stand in the data of a claim. */
static inline struct polygon polygon_of_claim(int n, const char *claim_name)
{
    struct polygon p = {.n = n};
    data_of(claim_name, "R", n + 1, 2, p.R);
    data_of(claim_name, "ω", n + 1, 1, p.w);
    return p;
}

static inline svg_point point_at(struct polygon p, num_q t)
{
    num_q P[2];
    rational_point_q(p.n, 2, p.R, p.w, t, P);
    return svg_pair(P);
}

/* The polygon with its labels in given directions, where a curve would run through the usual ones. */
static inline void draw_labelled(svg *s, struct polygon p, const char *const name[], const enum svg_direction side[])
{
    svg_polyline(s, p.n + 1, p.R, SVG_POLYGON);
    for (int i = 0; i <= p.n; i++) {
        svg_mark(s, svg_pair(p.R + 2 * i), SVG_POLYGON, SVG_USUAL);
        svg_label(s, svg_pair(p.R + 2 * i), side[i], SVG_POINT, name[i]);
    }
}

/* A triangle whose labels stand clear of what leaves its ends downwards. */
static inline void draw_triangle(svg *s, struct polygon p)
{
    static const enum svg_direction side[] = {SVG_W, SVG_N, SVG_E};
    svg_control_polygon_towards(s, 2, p.R, "R", side);
}
#endif
