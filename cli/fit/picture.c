/* picture.c -- the picture of a fit: points, curve, control polygon; below, the distances over the parameter. */
#include "chapters/judge/memory_text.h"
#include "cli/fit/fit.h"
#include "cli/refuse.h"
#include "cli/ticks.h"
#include "figures/svg.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    WIDTH = 600,          /* of the row of views, in output units      */
    VIEW_WIDTH = 270,     /* of each of two views                      */
    MARGIN = 36,          /* around what a view shows                  */
    LOWEST = 220,         /* a view is from so high ...                */
    HIGHEST = 460,        /* ... to so high                            */
    TICKS = 45,           /* ticks are at least so far apart           */
    RESIDUALS_HIGH = 140, /* the window of the distances               */
    MOST_MARKS = 60,      /* more points than these are a cloud        */
    MOST_LARGE = 600,     /* more points than these are a cloud of small dots */
    MOST_LABELS = 10,     /* control points with names                 */
    MOST_WEIGHTS = 6      /* control points with their weights         */
};

/* An interval of the line, and the step of its ticks; from 10^exponent times what the numbers are. */
struct scale {
    double low, high;
    num_q step;
};

static void include(struct scale *s, double x)
{
    s->low = fmin(s->low, x);
    s->high = fmax(s->high, x);
}

/* The power of ten by which numbers of this size are divided to be read without many zeros. */
static int power_of(double size)
{
    int e = size > 0 ? (int)floor(log10(size)) : 0;
    return e >= 6 || e <= -4 ? e : 0;
}

static num_q times_power(num_q x, int e)
{
    num_q ten = from_int_q(10);
    for (int i = 0; i < abs(e); i++)
        x = e > 0 ? mul_q(x, ten) : div_q(x, ten);
    return x;
}

/* x 10^-e exactly, x a binary64. */
static num_q scaled(double x, int e) { return times_power(from_double_q(x), -e); }

/* What is subtracted from coordinates of an interval that is so far from 0 that ticks would have more than some five digits: a number
 * with few digits that is no farther from it than ten times its length. */
static double base_of(const struct scale *s, double size)
{
    double far = fmin(fabs(s->low), fabs(s->high)), unit = pow(10, ceil(log10(size)));
    return s->low * s->high > 0 && far > 2e4 * size ? unit * 10 * trunc(s->low / (10 * unit)) : 0;
}

/* ---- a view: two coordinates, to one scale --------------------------------------------------------- */

struct view {
    const struct fit *f;
    int a, b;          /* the coordinates that are shown        */
    double base[2];    /* what is subtracted from them          */
    int power;         /* and what is left is divided by 10^power */
    struct scale x, y; /* in numbers as shown                   */
};

/* A length. */
static num_q shown(const struct view *v, double x) { return scaled(x, v->power); }

/* The point with these coordinates from the origin, NULL: from 0. */
static svg_point shown_from(const struct view *v, const double origin[], const double P[])
{
    num_q at[2];
    for (int k = 0; k < 2; k++) {
        int c = k == 0 ? v->a : v->b;
        num_q x = sub_q(from_double_q(P[c]), from_double_q(v->base[k]));
        x = origin != NULL ? add_q(x, from_double_q(origin[c])) : x;
        at[k] = times_power(x, -v->power);
    }
    return svg_pair(at);
}

static svg_point shown_at(const struct view *v, const double P[]) { return shown_from(v, NULL, P); }

/* Control point j. */
static svg_point control_point(const struct view *v, int j)
{
    const cagd_fit_result *r = v->f->result;
    return shown_from(v, r->origin, r->relative + j * r->curve.dim);
}

static int inside(const struct view *v, int j)
{
    svg_point at = control_point(v, j);
    double x = to_double_q(at.x), y = to_double_q(at.y);
    return v->x.low <= x && x <= v->x.high && v->y.low <= y && y <= v->y.high;
}

/* Where a control point that the window does not show is marked. */
struct beyond {
    double at[2];        /* on the border, in numbers as shown                  */
    double direction[2]; /* from there to the point, of the window's longer side */
};

/* The ray to control point j from the middle of its neighbours that are shown, or of the window, and where it leaves the window. */
static struct beyond beyond_border(const struct view *v, int j)
{
    const double low[2] = {v->x.low, v->y.low}, high[2] = {v->x.high, v->y.high};
    double from[2] = {0, 0}, to[2], part = 1, longer = fmax(high[0] - low[0], high[1] - low[1]), length;
    int seen = 0;
    struct beyond b;
    for (int k = j - 1; k <= j + 1; k += 2)
        if (k >= 0 && k < v->f->result->curve.count && inside(v, k)) {
            svg_point at = control_point(v, k);
            from[0] += to_double_q(at.x), from[1] += to_double_q(at.y);
            seen++;
        }
    svg_point at = control_point(v, j);
    to[0] = to_double_q(at.x), to[1] = to_double_q(at.y);
    for (int c = 0; c < 2; c++)
        from[c] = seen > 0 ? from[c] / seen : (low[c] + high[c]) / 2;
    for (int c = 0; c < 2; c++) {
        if (to[c] > high[c])
            part = fmin(part, (high[c] - from[c]) / (to[c] - from[c]));
        if (to[c] < low[c])
            part = fmin(part, (low[c] - from[c]) / (to[c] - from[c]));
    }
    length = hypot(to[0] - from[0], to[1] - from[1]);
    for (int c = 0; c < 2; c++) {
        b.at[c] = from[c] + part * (to[c] - from[c]);
        b.direction[c] = (to[c] - from[c]) / length * longer;
    }
    return b;
}

static svg_point shown_double(double x, double y) { return (svg_point){from_double_q(x), from_double_q(y)}; }

/* Points and feet; and the control points unless the window would become more than twice as large. */
static struct view new_view(const struct fit *f, int a, int b, int width)
{
    const cagd_spline *c = &f->result->curve;
    struct view v = {f, a, b, {0, 0}, 0, {INFINITY, -INFINITY, {0}}, {INFINITY, -INFINITY, {0}}};
    int dim = c->dim;
    for (int i = 0; i < f->data.count; i++)
        for (int k = 0; k < 2; k++) {
            int at = i * dim + (k == 0 ? a : b);
            double q = f->data.points[at], foot = q - f->result->residuals[at];
            struct scale *s = k == 0 ? &v.x : &v.y;
            include(s, q);
            include(s, foot);
        }
    struct scale x = v.x, y = v.y;
    for (int j = 0; j < c->count; j++) {
        include(&x, c->points[j * dim + a]);
        include(&y, c->points[j * dim + b]);
    }
    if (fmax(x.high - x.low, y.high - y.low) <= 2 * fmax(v.x.high - v.x.low, v.y.high - v.y.low)) {
        v.x = x;
        v.y = y;
    }
    double extent = fmax(v.x.high - v.x.low, v.y.high - v.y.low);
    v.power = power_of(extent);
    v.base[0] = base_of(&v.x, extent);
    v.base[1] = base_of(&v.y, extent);
    double unit = pow(10, v.power), room = extent / unit * MARGIN / width;
    v.x = (struct scale){(v.x.low - v.base[0]) / unit - room, (v.x.high - v.base[0]) / unit + room, {0}};
    v.y = (struct scale){(v.y.low - v.base[1]) / unit - room, (v.y.high - v.base[1]) / unit + room, {0}};
    return v;
}

/* Widens the window to the shape of a panel of that width whose height is between the bounds. */
static void shape(struct view *v, int width)
{
    double dx = v->x.high - v->x.low, dy = v->y.high - v->y.low, middle;
    if (dy < dx * LOWEST / width) {
        middle = (v->y.low + v->y.high) / 2;
        dy = dx * LOWEST / width;
        v->y.low = middle - dy / 2;
        v->y.high = middle + dy / 2;
    } else if (dy > dx * HIGHEST / width) {
        middle = (v->x.low + v->x.high) / 2;
        dx = dy * width / HIGHEST;
        v->x.low = middle - dx / 2;
        v->x.high = middle + dx / 2;
    }
    v->x.step = v->y.step = nice_step(dx, width / TICKS);
}

static void draw_curve(svg *s, const struct view *v)
{
    cagd_spline near = v->f->result->curve;
    const cagd_spline *c = &near;
    near.points = v->f->result->relative;
    int p = c->degree;
    double P[(CAGD_MAX_DEGREE + 1) * CAGD_MAX_DIM], w[CAGD_MAX_DEGREE + 1];
    for (int mu = p; mu < c->count; mu++) {
        if (!(c->knots[mu] < c->knots[mu + 1]) || cagd_spline_bezier(c, mu, P, w) != CAGD_OK)
            continue;
        region_mark mark = region_open();
        num_q R[2 * (CAGD_MAX_DEGREE + 1)], W[CAGD_MAX_DEGREE + 1];
        for (int i = 0; i <= p; i++) {
            svg_point at = shown_from(v, v->f->result->origin, P + i * c->dim);
            R[2 * i] = at.x;
            R[2 * i + 1] = at.y;
            W[i] = from_double_q(w[i]);
        }
        svg_rational(s, p, R, W, SVG_CURVE);
        region_drop(mark);
    }
}

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
    const int sides = (c->count - c->degree) * PER_SEGMENT < MOST_PLACES ? (c->count - c->degree) * PER_SEGMENT : MOST_PLACES;
    double *point = region_bytes(2 * (size_t)(n + own) * sizeof *point);
    double *place = region_bytes(2 * (size_t)(sides + 1 + legs * PER_LEG) * sizeof *place), at[CAGD_MAX_DIM];
    svg_crowd crowd = {0, 0, point, place};
    for (int i = 0; i < n; i++)
        keep_at(point, crowd.points++, shown_at(v, v->f->data.points + i * v->f->data.dim));
    for (int j = 0; j < own; j++)
        keep_at(point, crowd.points++, control_point(v, j));
    const double start = c->knots[c->degree], end = c->knots[c->count];
    for (int k = 0; k <= sides; k++)
        if (cagd_spline_point(c, k < sides ? start + (end - start) * k / sides : end, k < sides ? CAGD_RIGHT : CAGD_LEFT,
                              at) == CAGD_OK)
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
        svg_label_clear(s, on[1], fabs(b.direction[0]) > fabs(b.direction[1]) ? SVG_S : SVG_E, crowd, SVG_POLYGON, name);
}

static int any_beyond(const struct view *v)
{
    for (int j = 0; j < own_points(v->f); j++)
        if (!inside(v, j))
            return 1;
    return 0;
}

static void draw_polygon(svg *s, const struct view *v)
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

/* One standard deviation to either side, in both coordinates. */
static void draw_bars(svg *s, const struct view *v)
{
    const cagd_fit_data *d = &v->f->data;
    for (int i = 0; i < d->count; i++) {
        const double *Q = d->points + i * d->dim;
        svg_point at = shown_at(v, Q);
        num_q e = shown(v, d->sigma[i]);
        svg_segment(s, (svg_point){sub_q(at.x, e), at.y}, (svg_point){add_q(at.x, e), at.y}, SVG_AXIS);
        svg_segment(s, (svg_point){at.x, sub_q(at.y, e)}, (svg_point){at.x, add_q(at.y, e)}, SVG_AXIS);
    }
}

/* As marks where they are few, as dots, the smaller the more there are, where they are many. */
static void put_points(svg *s, int count, const num_q P[])
{
    if (count > MOST_MARKS)
        svg_cloud(s, count, P, count > MOST_LARGE ? 190 : 420, SVG_POINT);
    for (int i = 0; i < count && count <= MOST_MARKS; i++)
        svg_mark(s, svg_pair(P + 2 * i), SVG_POINT, SVG_USUAL);
}

/* The outliers among the points, which stand at P. */
static void mark_outliers(svg *s, const struct fit *f, const num_q P[])
{
    for (int i = 0; i < f->result->count; i++)
        if (f->result->outlier[i])
            svg_mark(s, svg_pair(P + 2 * i), SVG_WRONG, SVG_USUAL);
}

static void draw_points(svg *s, const struct view *v)
{
    const cagd_fit_data *d = &v->f->data;
    num_q *P = region_bytes((size_t)(2 * d->count) * sizeof *P);
    for (int i = 0; i < d->count; i++) {
        svg_point at = shown_at(v, d->points + i * d->dim);
        P[2 * i] = at.x;
        P[2 * i + 1] = at.y;
    }
    put_points(s, d->count, P);
    mark_outliers(s, v->f, P);
}

static void axis_name(char name[64], const char *what, int power)
{
    if (power == 0)
        snprintf(name, 64, "%s", what);
    else
        snprintf(name, 64, "%s/10^{%s%d}", what, power < 0 ? "-" : "", abs(power));
}

/* What the view shows, and from where its coordinates are counted. */
static char *caption_of(const struct view *v, const char *what, const char *const coordinate[])
{
    char *text;
    size_t size;
    FILE *out = text_open(&text, &size);
    fputs(what, out);
    const char *before = *what != '\0' ? "; " : "";
    for (int k = 0; k < 2; k++)
        if (v->base[k] != 0) {
            fprintf(out, "%s$%s$ from $%.15g$", before, coordinate[k == 0 ? v->a : v->b], v->base[k]);
            before = ", ";
        }
    text_close(out, &text);
    return text;
}

/* Whether control points lie beyond the border. */
static int draw_view(svg *s, const struct fit *f, int a, int b, int width, const char *what)
{
    static const char *const coordinate[] = {"x", "y", "z"};
    region_mark mark = region_open();
    struct view v = new_view(f, a, b, width);
    shape(&v, width);
    svg_window window = {from_double_q(v.x.low), from_double_q(v.y.low), from_double_q(v.x.high),
                         from_double_q(v.y.high)};
    char x_name[64], y_name[64];
    axis_name(x_name, coordinate[a], v.power);
    axis_name(y_name, coordinate[b], v.power);
    char *caption = caption_of(&v, what, coordinate);
    svg_panel(s, window, width, 0, *caption != '\0' ? caption : NULL);
    free(caption);
    svg_grid(s, v.x.step, v.y.step);
    svg_scales(s, v.x.step, v.y.step, x_name, y_name);
    if (f->data.sigma != NULL && f->data.count <= MOST_MARKS)
        draw_bars(s, &v);
    draw_points(s, &v);
    draw_polygon(s, &v);
    draw_curve(s, &v);
    const int beyond = any_beyond(&v);
    region_drop(mark);
    return beyond;
}

/* ---- the distances --------------------------------------------------------------------------------- */

/* Over the parameter, in standard deviations where these are given, else as they are; with the band of two standard
 * deviations. */
static void draw_distances(svg *s, const struct fit *f)
{
    const cagd_fit_result *r = f->result;
    const cagd_spline *c = &r->curve;
    region_mark mark = region_open();
    int standardised = f->data.sigma != NULL, plane = f->data.dim == 2;
    double band = 2 * (standardised ? 1 : cagd_fit_deviation(&f->data, f->result, 0)), size = 0;
    double *d = region_bytes((size_t)r->count * sizeof *d);
    for (int i = 0; i < r->count; i++) {
        d[i] = r->distances[i] / (standardised ? f->data.sigma[i] : 1);
        size = fmax(size, fabs(d[i]));
    }
    if (isfinite(band))
        size = fmax(size, band);
    if (!(size > 0))
        size = 1;
    int power = power_of(size);
    double top = 1.12 * size / pow(10, power), start = c->knots[c->degree], end = c->knots[c->count];
    double room = 0.03 * (end - start);
    num_q low = plane ? from_double_q(-top) : from_double_q(-0.06 * top), high = from_double_q(top);
    svg_window window = {from_double_q(start - room), low, from_double_q(end + room), high};
    char name[64];
    axis_name(name, standardised ? "d/s" : "d", power);
    svg_row(s);
    svg_panel(s, window, WIDTH, RESIDUALS_HIGH,
              standardised
                  ? plane ? "signed distance in standard deviations over the parameter of the foot; + on the left"
                          : "distance in standard deviations over the parameter of the foot"
              : plane ? "signed distance over the parameter of the foot; + on the left"
                      : "distance over the parameter of the foot");
    num_q step_t = nice_step(end - start, 10), step = nice_step(plane ? 2 * top : top, 5);
    if (isfinite(band)) {
        num_q two = scaled(band, power), bottom = plane ? neg_q(two) : from_int_q(0);
        svg_area(s, 4, (num_q[]){window.x0, bottom, window.x1, bottom, window.x1, two, window.x0, two}, SVG_FILL);
    }
    svg_grid(s, step_t, step);
    svg_scales(s, step_t, step, "t", name);
    num_q *P = region_bytes((size_t)(2 * r->count) * sizeof *P);
    for (int i = 0; i < r->count; i++) {
        P[2 * i] = from_double_q(r->feet[i]);
        P[2 * i + 1] = scaled(d[i], power);
    }
    svg_segment(s, (svg_point){window.x0, from_int_q(0)}, (svg_point){window.x1, from_int_q(0)}, SVG_AXIS);
    for (int i = 0; i < r->count && r->count <= MOST_MARKS; i++)
        svg_segment(s, (svg_point){P[2 * i], from_int_q(0)}, svg_pair(P + 2 * i), SVG_AXIS);
    put_points(s, r->count, P);
    mark_outliers(s, f, P);
    int k = r->largest_at;
    if (r->largest > 0) {
        char line[32];
        snprintf(line, sizeof line, "line %d", f->points.line[k]);
        double *point = region_bytes(2 * (size_t)r->count * sizeof *point);
        for (int i = 0; i < r->count; i++)
            keep_at(point, i, svg_pair(P + 2 * i));
        svg_note_clear(s, svg_pair(P + 2 * k), 2 * r->feet[k] < start + end ? SVG_E : SVG_W,
                       &(svg_crowd){.points = r->count, .point = point}, SVG_POINT, line);
    }
    region_drop(mark);
}

/* ---- the picture ----------------------------------------------------------------------------------- */

static void describe(const struct fit *f, FILE *out)
{
    const cagd_fit_result *r = f->result;
    fprintf(out,
            "%d measured points %s; %s rational curve of degree %d with %d control points%s, "
            "with its control polygon; below, the %s of every point over the parameter of its foot%s. "
            "Root mean square distance %.3g, largest %.3g.",
            f->data.count, f->data.dim == 2 ? "in the plane" : "in space, from above and from the front",
            cagd_fit_is_minimum(f->result) && !nothing_is_free(f) ? "the" : "a", r->curve.degree, r->curve.count,
            nothing_is_free(f)               ? " that is given"
            : cagd_fit_is_minimum(f->result) ? " that comes closest to them"
                                             : " that the minimiser reached, not known to be a minimum",
            f->data.dim == 2 ? "signed distance" : "distance",
            isfinite(cagd_fit_deviation(&f->data, f->result, 0)) ? ", with a band of two standard deviations" : "",
            r->rms, r->largest);
}

/* beyond: control points lie beyond the border of a view. */
static void legend(svg *s, const struct fit *f, int beyond)
{
    int bars = f->data.sigma != NULL && f->data.count <= MOST_MARKS;
    svg_legend_mark(s, SVG_POINT, SVG_USUAL, bars ? "measured $± s$" : "measured");
    svg_legend_line(s, SVG_CURVE,
                    nothing_is_free(f)               ? "given curve"
                    : cagd_fit_is_minimum(f->result) ? "fitted curve"
                                                     : "curve, no minimum");
    svg_legend_mark(s, SVG_POLYGON, SVG_USUAL,
                    beyond ? "control points; arrows: to those beyond the frame" : "control points");
    if (f->result->outliers > 0)
        svg_legend_mark(s, SVG_WRONG, SVG_USUAL, "outliers");
    if (isfinite(cagd_fit_deviation(&f->data, f->result, 0)))
        svg_legend_area(s, SVG_FILL, f->data.dim == 2 ? "$± 2 s$" : "up to $2 s$");
}

int write_picture(const struct fit *f, const char *path)
{
    char *description;
    size_t size;
    FILE *out = text_open(&description, &size);
    describe(f, out);
    text_close(out, &description);
    svg *s = svg_new("fit",
                     nothing_is_free(f) ? "Measured points and a given rational curve"
                                        : "A rational curve fitted to measured points",
                     description);
    free(description);
    int beyond = 0;
    if (f->data.dim == 2) {
        beyond = draw_view(s, f, 0, 1, WIDTH, "");
    } else {
        beyond = draw_view(s, f, 0, 1, VIEW_WIDTH, "from above");
        beyond |= draw_view(s, f, 0, 2, VIEW_WIDTH, "from the front");
    }
    draw_distances(s, f);
    legend(s, f, beyond);
    int code = -1;
    const char *text = svg_text(s);
    if (text == NULL)
        refuse_line("%s: the picture cannot be drawn: %s", path, svg_failed(s));
    else
        code = write_text_file(path, text);
    svg_free(s);
    return code;
}
