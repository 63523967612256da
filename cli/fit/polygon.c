/* polygon.c -- the control polygon in the picture of a fit, and the names of its points. */
#include "chapters/judge/memory_text.h"
#include "cli/fit/picture.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum {
    MOST_LABELS = 10, /* control points with names       */
    MOST_WEIGHTS = 6  /* control points with their weights */
};

/* ---- what names must not cover ----------------------------------------------------------------------- */

enum { PER_SEGMENT = 24, MOST_PLACES = 2000, PER_LEG = 12 };

static void keep_at(double P[], int at, svg_point x)
{
    P[2 * at] = to_double_q(x.x);
    P[2 * at + 1] = to_double_q(x.y);
}

/* The points and control points of a view, and places of its curve and its polygon. */
static svg_crowd crowd_of(const struct view *v)
{
    const cagd_fit_result *r = v->f->result;
    cagd_spline near = r->curve;
    const cagd_spline *c = &near;
    near.points = r->relative;
    const int n = v->f->data.count, own = own_points(v->f), legs = c->count - 1;
    const int sides =
        (c->count - c->degree) * PER_SEGMENT < MOST_PLACES ? (c->count - c->degree) * PER_SEGMENT : MOST_PLACES;
    double *point = region_bytes(2 * (size_t)(n + own) * sizeof *point);
    double *place = region_bytes(2 * (size_t)(sides + 1 + legs * PER_LEG) * sizeof *place), at[CAGD_MAX_DIM];
    svg_crowd crowd = {0, 0, point, place};
    for (int i = 0; i < n; i++)
        keep_at(point, crowd.points++, shown_from(v, NULL, v->f->data.points + i * v->f->data.dim));
    for (int j = 0; j < own; j++)
        keep_at(point, crowd.points++, control_point(v, j));
    const double start = c->knots[c->degree], end = c->knots[c->count];
    for (int k = 0; k <= sides; k++)
        if (cagd_spline_point(c, k < sides ? start + (end - start) * k / sides : end,
                              k < sides ? CAGD_RIGHT : CAGD_LEFT, at) == CAGD_OK)
            keep_at(place, crowd.places++, shown_from(v, r->origin, at));
    for (int j = 0; j < legs; j++) {
        double leg[4];
        keep_at(leg, 0, control_point(v, j));
        keep_at(leg, 1, control_point(v, j + 1));
        for (int k = 1; k <= PER_LEG; k++, crowd.places++)
            for (int x = 0; x < 2; x++)
                place[2 * crowd.places + x] = leg[x] + (leg[2 + x] - leg[x]) * k / (PER_LEG + 1);
    }
    return crowd;
}

/* ---- names and marks -------------------------------------------------------------------------------- */

/* The direction in which a label stands away from the polygon at its point j. */
static enum svg_direction away(const struct view *v, int j)
{
    const cagd_spline *c = &v->f->result->curve;
    const double *P = v->f->result->relative + j * c->dim;
    double x = 0, y = 0;
    for (int k = -1; k <= 1; k += 2)
        if (j + k >= 0 && j + k < c->count) {
            const double *Q = P + k * c->dim;
            double dx = P[v->a] - Q[v->a], dy = P[v->b] - Q[v->b], length = hypot(dx, dy);
            x += length > 0 ? dx / length : 0;
            y += length > 0 ? dy / length : 0;
        }
    if (!(hypot(x, y) > 0.1)) /* a straight polygon: above it */
        return SVG_N;
    return svg_direction_of(svg_at(0, 0), (svg_point){from_double_q(x), from_double_q(y)});
}

/* Its name; in the plane and among few also its weight if that is not 1, unless it is an end or there is no room. */
static void label_control_point(svg *s, const struct view *v, const svg_crowd *crowd, int j)
{
    const cagd_fit_result *r = v->f->result;
    int dim = r->curve.dim;
    char *text;
    size_t size;
    FILE *out = text_open(&text, &size);
    fprintf(out, "P_{%d}", j);
    if (dim == 2 && r->curve.count <= MOST_WEIGHTS && j > 0 && j < r->curve.count - 1 && r->curve.weights[j] != 1) {
        cagd_fit_estimate e = {r->curve.weights[j], NAN, NAN, NAN, 0, CAGD_FIT_INTERVAL_NONE};
        for (int k = 0; k < r->unknowns; k++)
            if (r->unknown[k].is_weight && r->unknown[k].index == j)
                e = cagd_fit_unknown_estimate(v->f->result, k);
        fprintf(out, ",  w_{%d} = ", j);
        if (isfinite(e.error)) {
            put_rounded(out, 0, e.value, e.error);
            fputs(" ± ", out);
            put_rounded(out, 0, e.error, e.error);
        } else
            fprintf(out, "%.4g", e.value);
    }
    text_close(out, &text);
    char name[32];
    snprintf(name, sizeof name, "P_{%d}", j);
    if (!svg_label_clear(s, control_point(v, j), away(v, j), crowd, SVG_POLYGON, text))
        svg_label_clear(s, control_point(v, j), away(v, j), crowd, SVG_POLYGON, name);
    free(text);
}

static svg_point shown_double(double x, double y) { return (svg_point){from_double_q(x), from_double_q(y)}; }

/* A control point that the window does not show: an arrow to the border, towards it. */
static void mark_beyond(svg *s, const struct view *v, const svg_crowd *crowd, int j, int named)
{
    const double LONG = 0.035; /* of the longer side: shorter than the margin about the points */
    const struct beyond b = beyond_border(v, j);
    svg_point on[3]; /* the border, and half and all of the arrow before it */
    for (int k = 0; k < 3; k++)
        on[k] = shown_double(b.at[0] - LONG * k / 2 * b.direction[0], b.at[1] - LONG * k / 2 * b.direction[1]);
    char name[32];
    svg_arrow(s, on[2], on[0], SVG_POLYGON);
    snprintf(name, sizeof name, "P_{%d}", j);
    if (named) /* beside the arrow, within the frame */
        svg_label_clear(s, on[1], fabs(b.direction[0]) > fabs(b.direction[1]) ? SVG_S : SVG_E, crowd, SVG_POLYGON,
                        name);
}

void draw_polygon(svg *s, const struct view *v)
{
    const cagd_spline *c = &v->f->result->curve;
    num_q *P = region_bytes((size_t)(2 * c->count) * sizeof *P);
    for (int j = 0; j < c->count; j++) {
        svg_point at = control_point(v, j);
        P[2 * j] = at.x;
        P[2 * j + 1] = at.y;
    }
    for (int j = 1; j < c->count; j++) /* a leg between points that are not seen would only puzzle */
        if (inside(v, j - 1) || inside(v, j))
            svg_polyline(s, 2, P + 2 * j - 2, SVG_POLYGON);
    const int named = own_points(v->f) <= MOST_LABELS && !is_ellipse(v->f);
    const svg_crowd crowd = named ? crowd_of(v) : (svg_crowd){0};
    for (int j = 0; j < own_points(v->f); j++)
        if (inside(v, j)) {
            svg_mark(s, svg_pair(P + 2 * j), SVG_POLYGON, SVG_USUAL);
            if (named)
                label_control_point(s, v, &crowd, j);
        } else
            mark_beyond(s, v, &crowd, j, named);
}
