/* picture.c -- the picture of a fit: points, curve, control polygon; below, the distances over the parameter. */
#include "cli/fit/picture.h"
#include "chapters/judge/memory_text.h"
#include "cli/refuse.h"
#include "cli/ticks.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    WIDTH = 600,          /* of the row of views, in output units      */
    VIEW_WIDTH = 270,     /* of each of two views                      */
    RESIDUALS_HIGH = 140, /* the window of the distances               */
    MOST_MARKS = 60,      /* more points than these are a cloud        */
    MOST_LARGE = 600      /* more points than these are a cloud of small dots */
};

/* ---- a view ----------------------------------------------------------------------------------------- */

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

/* One standard deviation to either side, in both coordinates. */
static void draw_bars(svg *s, const struct view *v)
{
    const cagd_fit_data *d = &v->f->data;
    for (int i = 0; i < d->count; i++) {
        const double *Q = d->points + i * d->dim;
        svg_point at = shown_from(v, NULL, Q);
        num_q e = shown(v, d->sigma[i]);
        svg_segment(s, (svg_point){sub_q(at.x, e), at.y}, (svg_point){add_q(at.x, e), at.y}, SVG_AXIS);
        svg_segment(s, (svg_point){at.x, sub_q(at.y, e)}, (svg_point){at.x, add_q(at.y, e)}, SVG_AXIS);
    }
}

static int diameter_of(int count) { return count > MOST_LARGE ? 190 : 420; }

/* As marks where they are few, as dots, the smaller the more there are, where they are many. */
static void put_points(svg *s, int count, const num_q P[])
{
    if (count > MOST_MARKS)
        svg_cloud(s, count, P, diameter_of(count), SVG_POINT);
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
        svg_point at = shown_from(v, NULL, d->points + i * d->dim);
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
    const struct view v = view_of(f, a, b, width);
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
        if (r->count > MOST_MARKS && !r->outlier[k])
            svg_mark(s, svg_pair(P + 2 * k), SVG_POINT, SVG_USUAL);
        double *point = region_bytes(2 * (size_t)r->count * sizeof *point);
        for (int i = 0; i < r->count; i++)
            point[2 * i] = to_double_q(P[2 * i]), point[2 * i + 1] = to_double_q(P[2 * i + 1]);
        svg_note_clear(s, svg_pair(P + 2 * k), 2 * r->feet[k] < start + end ? SVG_E : SVG_W,
                       &(svg_crowd){.points = r->count, .point = point}, SVG_POINT, line);
    }
    region_drop(mark);
}

/* ---- from where points of space are seen ------------------------------------------------------------- */

enum views { TOP_FRONT, TOP_SIDE, FRONT_SIDE };

/* The smaller eigenvalue of the covariance of two coordinates of the points, how far they are from a straight line. */
static double breadth(const cagd_fit_data *d, int a, int b)
{
    double mean[2] = {0}, xx = 0, xy = 0, yy = 0;
    for (int i = 0; i < d->count; i++)
        mean[0] += d->points[i * d->dim + a] / d->count, mean[1] += d->points[i * d->dim + b] / d->count;
    for (int i = 0; i < d->count; i++) {
        double x = d->points[i * d->dim + a] - mean[0], y = d->points[i * d->dim + b] - mean[1];
        xx += x * x, xy += x * y, yy += y * y;
    }
    return ((xx + yy) - hypot(xx - yy, 2 * xy)) / (2 * d->count);
}

/* From above and from the front, unless from the side the points are twice as broad as from one of them. */
static enum views views_of_space(const struct fit *f)
{
    const double top = breadth(&f->data, 0, 1), front = breadth(&f->data, 0, 2), side = breadth(&f->data, 1, 2);
    return side > 4 * fmin(top, front) ? top < front ? FRONT_SIDE : TOP_SIDE : TOP_FRONT;
}

/* ---- the picture ----------------------------------------------------------------------------------- */

/* Whether the weights are not all 1. */
static int is_rational(const struct fit *f)
{
    int rational = fits_weights(f);
    for (int j = 0; j < f->result->curve.count; j++)
        rational |= f->result->curve.weights[j] != 1;
    return rational;
}

static void describe(const struct fit *f, FILE *out)
{
    const cagd_fit_result *r = f->result;
    fprintf(out,
            "%d measured points %s; %s%s curve of degree %d with %d control points%s, "
            "with its control polygon; below, the %s of every point over the parameter of its foot%s. "
            "Root mean square distance %.3g, largest %.3g.",
            f->data.count,
            f->data.dim == 2                  ? "in the plane"
            : views_of_space(f) == TOP_SIDE   ? "in space, from above and from the side"
            : views_of_space(f) == FRONT_SIDE ? "in space, from the front and from the side"
                                              : "in space, from above and from the front",
            cagd_fit_is_minimum(f->result) && !nothing_is_free(f) ? "the" : "a", is_rational(f) ? " rational" : "",
            r->curve.degree, r->curve.count,
            nothing_is_free(f)               ? " that is given"
            : cagd_fit_is_minimum(f->result) ? " that comes closest to them"
                                             : " that the minimiser reached, not known to be a minimum",
            f->data.dim == 2 ? "signed distance" : "distance",
            isfinite(cagd_fit_deviation(&f->data, f->result, 0)) ? ", with a band of two standard deviations" : "",
            r->rms, r->largest);
    char *sentence[MOST_PROBLEMS];
    const int problems = problems_of(f, sentence);
    for (int k = 0; k < problems; k++) {
        fprintf(out, "%s%s", k == 0 ? " The fit is NOT good: " : "; ", sentence[k]);
        free(sentence[k]);
    }
    fputs(problems > 0 ? "." : "", out);
}

/* What the picture is of, and what speaks against it. */
static void entitle(const struct fit *f, FILE *out)
{
    const cagd_fit_result *r = f->result;
    const int conic = is_ellipse(f), segments = r->curve.count > r->curve.degree + 1;
    if (nothing_is_free(f)) {
        fputs("Measured points and a given curve", out);
        return;
    }
    fprintf(out, "%s fitted to measured points",
            conic && r->found.ellipse.circle    ? r->found.ellipse.whole ? "A circle" : "An arc of a circle"
            : conic                             ? r->found.ellipse.whole ? "An ellipse" : "An arc of an ellipse"
            : tells_circle(f)                   ? "An arc of a circle"
            : r->curve.degree == 1 && !segments ? "A straight line"
            : r->curve.degree == 2 && !segments ? is_rational(f) ? "An arc of a conic" : "An arc of a parabola"
            : is_rational(f)                    ? "A rational curve"
            : segments || r->period > 0         ? "A spline curve"
                                                : "A Bézier curve");
    for (int k = 0, said = 0; k < MOST_PROBLEMS; k++)
        if (f->quality.problems & 1 << k)
            fprintf(out, "%s%s", said++ > 0 ? ", " : ", NOT good: ", problem_name[k]);
}

/* beyond: control points lie beyond the border of a view. */
static void legend(svg *s, const struct fit *f, int beyond)
{
    int bars = f->data.sigma != NULL && f->data.count <= MOST_MARKS;
    if (f->data.count > MOST_MARKS)
        svg_legend_dot(s, SVG_POINT, diameter_of(f->data.count), "measured");
    else
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
    char *title;
    out = text_open(&title, &size);
    entitle(f, out);
    text_close(out, &title);
    svg *s = svg_new("fit", title, description);
    free(title);
    free(description);
    int beyond = 0;
    if (f->data.dim == 2) {
        beyond = draw_view(s, f, 0, 1, WIDTH, "");
    } else {
        const enum views views = views_of_space(f);
        if (views != FRONT_SIDE)
            beyond |= draw_view(s, f, 0, 1, VIEW_WIDTH, "from above");
        if (views != TOP_SIDE)
            beyond |= draw_view(s, f, 0, 2, VIEW_WIDTH, "from the front");
        if (views != TOP_FRONT)
            beyond |= draw_view(s, f, 1, 2, VIEW_WIDTH, "from the side");
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
