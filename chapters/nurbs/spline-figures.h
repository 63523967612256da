/* spline-figures.h -- what the drawings of NURBS curves have in common. */
#ifndef CAGD_NURBS_SPLINE_FIGURES_H
#define CAGD_NURBS_SPLINE_FIGURES_H

#include "chapters/judge/figure.h"
#include "exact/record/span.h"
#include "figures/words.h"

#include <stdio.h>

enum { MOST_POINTS = 40 };

/* A NURBS curve of the plane: n points of degree p, n+p+1 knots. */
typedef struct spline {
    int n, p;
    num_q u[2 * MOST_POINTS], R[2 * MOST_POINTS], w[MOST_POINTS];
} spline;

/* Knots in units of 1/knot_unit, coordinates in units of 1/unit; weight NULL: all 1. */
static inline spline spline_of(int n, int p, const int knot[], long knot_unit, const int point[], long unit,
                               const int weight[])
{
    spline s = {.n = n, .p = p};
    for (int i = 0; i <= n + p; i++)
        s.u[i] = r(knot[i], knot_unit);
    for (int i = 0; i < n; i++) {
        s.R[2 * i] = r(point[2 * i], unit);
        s.R[2 * i + 1] = r(point[2 * i + 1], unit);
        s.w[i] = q(weight != NULL ? weight[i] : 1);
    }
    return s;
}

/* The window with the corners (x0, y0) and (x1, y1), in units of 1/scale. */
static inline svg_window scaled_window(long x0, long y0, long x1, long y1, long scale)
{
    return (svg_window){from_ratio_q(x0, scale), from_ratio_q(y0, scale), from_ratio_q(x1, scale),
                        from_ratio_q(y1, scale)};
}

/* The segment of a span over its own interval, as a rational Bézier curve. */
static inline void draw_segment(svg *s, spline c, int mu, enum svg_role colour)
{
    num_q H[3 * MOST_POINTS], b[3 * (MAX_DEGREE + 1)], P[2 * (MAX_DEGREE + 1)], v[MAX_DEGREE + 1];
    rational_homogenize_q(c.n - 1, 2, c.R, c.w, H);
    bspline_to_bezier_q(on_span_q(c.p, 3, c.u, mu, H), b);
    rational_dehomogenize_q(c.p, 2, b, P, v);
    svg_rational(s, c.p, P, v, colour);
}

static inline void draw_spline(svg *s, spline c, enum svg_role colour)
{
    for (int mu = c.p; mu < c.n; mu++)
        if (before_q(c.u[mu], c.u[mu + 1]))
            draw_segment(s, c, mu, colour);
}

/* The point of parameter t, for a knot the limit from the right. */
static inline svg_point spline_point(spline c, num_q t)
{
    num_q P[2];
    nurbs_point_q(nurbs_on_span_q(c.p, 2, c.u, find_span_q(c.n, c.p, c.u, t), c.R, c.w), t, P);
    return svg_pair(P);
}

/* The points where the segments join. */
static inline void mark_knots(svg *s, spline c, enum svg_role colour)
{
    for (int i = c.p; i <= c.n; i++)
        if (i == c.n || before_q(c.u[i], c.u[i + 1]))
            svg_mark(s, spline_point(c, c.u[i]), colour, SVG_SQUARE);
}

/* The polygon with its points, labelled letter_1, ..., letter_n as in the source, on the given sides; without labels for letter
 * NULL and where the side is SVG_HERE. */
static inline void draw_polygon(svg *s, spline c, const char *letter, const enum svg_direction side[],
                                enum svg_role colour)
{
    svg_polyline(s, c.n, c.R, colour);
    for (int i = 0; i < c.n; i++) {
        char name[24];
        svg_mark(s, svg_pair(c.R + 2 * i), colour, SVG_USUAL);
        if (letter == NULL || side[i] == SVG_HERE)
            continue;
        snprintf(name, sizeof name, "%s_%d", letter, i + 1);
        svg_label(s, svg_pair(c.R + 2 * i), side[i], SVG_POINT, name);
    }
}

/* The curve with one knot more. */
static inline spline with_knot(spline c, num_q x)
{
    spline d = {.n = c.n + 1, .p = c.p};
    nurbs_insert_q(&(struct spline_q){c.p, c.n, 2, c.u, c.R, c.w}, find_span_q(c.n, c.p, c.u, x), x, d.u, d.R, d.w);
    return d;
}
#endif
