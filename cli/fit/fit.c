/* fit.c -- cagd fit: reads points and curve, fits, verifies, and has the result told. */
#include "cli/fit/fit.h"
#include "cli/input.h"
#include "cli/progress.h"
#include "cli/refuse.h"
#include "cli/waiting.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static double *doubles(int count) { return region_bytes((size_t)count * sizeof(double)); }

static double *rounded(int count, const num_q x[])
{
    double *y = doubles(count);
    for (int i = 0; i < count; i++)
        y[i] = to_double_q(x[i]);
    return y;
}

/* The curve to begin with, in binary64; a curve without weights has the weights 1. */
static int read_initial(const struct fit_arguments *a, int dim, cagd_spline *spline)
{
    cagd_spline_q c;
    struct input_error error;
    if (read_curve(a->initial, &c, &error) != 0) {
        report_input_error(a->initial, &error);
        return -1;
    }
    if (c.dim != dim) {
        refuse_line("%s: the points of the curve have %d coordinate%s, those of %s %d", a->initial, c.dim,
                    c.dim == 1 ? "" : "s", a->asked.path, dim);
        return -1;
    }
    double *weights = c.weights != NULL ? rounded(c.count, c.weights) : doubles(c.count);
    for (int j = 0; j < c.count && c.weights == NULL; j++)
        weights[j] = 1;
    *spline = (cagd_spline){.degree = c.degree,
                            .count = c.count,
                            .dim = dim,
                            .knots = rounded(c.count + c.degree + 1, c.knots),
                            .points = rounded(c.count * dim, c.points),
                            .weights = weights};
    for (int j = 0; j < c.count; j++)
        if (!(weights[j] > 0)) {
            refuse_line("%s: weights[%d]: %g, expected a number > 0", a->initial, j, weights[j]);
            return -1;
        }
    return 0;
}

/* 0, ..., 0, the inner knots, 1, ..., 1. */
static void give_knots(const struct fit_arguments *a, cagd_fit_options *o)
{
    if (a->knots == NULL)
        return;
    int p = o->degree;
    o->count = p + 1 + a->inner_knots;
    double *knots = doubles(o->count + p + 1);
    for (int i = 0; i < o->count + p + 1; i++)
        knots[i] = i <= p ? 0 : i >= o->count ? 1 : a->inner[i - p - 1];
    o->knots = knots;
}

/* Whether the curve is to be closed, by the options or because the points come back to their beginning; *repeated: whether their last one
 * is the first one. */
static int is_closed(const struct fit *f, int *repeated)
{
    const cagd_fit_options *o = &f->options;
    const int may_close = f->choices.closed != 0 && o->initial == NULL && o->free != 0;
    const enum cagd_fit_closing closing = may_close ? cagd_fit_closing_of(&f->data, o->unordered) : CAGD_FIT_OPEN;
    *repeated = closing == CAGD_FIT_REPEATED;
    return f->choices.closed == 1 || *repeated || closing == CAGD_FIT_AROUND;
}

/* How many unknowns the simplest open curve has that the options ask for: the first weight is given, and the last one of a curve of one
 * span. */
static int unknowns_of_open(const cagd_fit_options *o, int dim)
{
    int n = o->initial != NULL ? o->initial->count : o->count != 0 ? o->count : o->degree + 1;
    int p = o->initial != NULL ? o->initial->degree : o->degree;
    int weights = n - (n == p + 1 ? 2 : 1);
    return (o->free & CAGD_FIT_WEIGHTS ? weights : 0) + (o->free & CAGD_FIT_INNER_POINTS ? (n - 2) * dim : 0) +
           (o->free & CAGD_FIT_END_POINTS ? 2 * dim : 0);
}

/* The same of a closed curve: an ellipse, 5 in the plane and 8 in space, or a spline of p+2 points unless their number is given. */
static int unknowns_of_closed(const struct fit *f)
{
    const cagd_fit_options *o = &f->options;
    const int dim = f->data.dim, n = o->count != 0 ? o->count : o->degree + 2;
    return f->choices.form ? 3 * dim - 1 : n * dim + (o->count != 0 && o->free & CAGD_FIT_WEIGHTS ? n - 1 : 0);
}

/* Whether two of the points are measurements of the ends, with an equation each along the curve. */
static int has_measured_ends(const cagd_fit_options *o)
{
    return o->free & CAGD_FIT_END_POINTS && o->ends == CAGD_FIT_ENDS_MEASURED;
}

/* Whether other wishes lead to a minimum: with ends that are free or exact, closed or not. */
static int fits(const struct fit *f, int ends, int closed)
{
    cagd_fit_options o = f->options;
    cagd_fit_choices c = f->choices;
    cagd_fit_result *r;
    o.free = (o.free & ~CAGD_FIT_END_POINTS) | (o.free & ends);
    o.without_intervals = 1;
    o.after_start = NULL;
    c.closed = closed;
    if (cagd_fit_choose(&f->data, &o, &c, &r, NULL) != CAGD_OK)
        return 0;
    const int minimum = cagd_fit_is_minimum(r);
    cagd_fit_free(r);
    return minimum;
}

/* Each point gives dim-1 equations; an ellipse is fitted to two more than it has unknowns. */
static void refuse_too_few(const struct fit *f)
{
    int repeated;
    const int dim = f->data.dim, closed = is_closed(f, &repeated), n = f->data.count - repeated,
              asked = closed ? unknowns_of_closed(f) : unknowns_of_open(&f->options, dim),
              more = !closed && has_measured_ends(&f->options) ? 2 : 0, equations = n * (dim - 1) + more,
              needed = asked - more + (closed && f->choices.form ? 2 : 0),
              least = needed <= 2 * (dim - 1) ? 2 : (needed + dim - 2) / (dim - 1);
    const char *name = name_of_input(f->path), *where = dim == 2 ? "in the plane" : "in space",
               *cure = closed && f->choices.closed < 0 && fits(f, CAGD_FIT_END_POINTS, 0)
                           ? "; they come back to their beginning: --open fits an open one"
                       : more && fits(f, 0, f->choices.closed)
                           ? "; --ends exact, which takes the first and the last one for the ends, fits"
                           : "";
    if (n >= least)
        refuse_line("%s: too few points: %d %s do not determine the curve that is asked for", name, n, where);
    else if (closed && f->choices.form)
        refuse_line(
            "%s: too few points for a closed curve: %d %s, expected at least %d, since an ellipse has %d unknowns%s",
            name, n, where, least, asked, cure);
    else
        refuse_line("%s: too few points%s: %d %s give%s %d equation%s for %d unknown%s, expected at least %d points%s",
                    name, closed ? " for a closed curve" : "", n, where, n == 1 ? "s" : "", equations,
                    equations == 1 ? "" : "s", asked, asked == 1 ? "" : "s", least, cure);
}

static int complain(const struct fit *f, cagd_status status, int where)
{
    const char *name = name_of_input(f->path);
    const int asked = unknowns_of_open(&f->options, f->data.dim);
    if (status == CAGD_TOO_FEW)
        refuse_too_few(f);
    else if (status == CAGD_BAD_OPTION && asked == 0 && f->options.free != 0)
        refuse_line("%s: nothing is free: of what --free names the curve has nothing that could move", name);
    else if (status == CAGD_BAD_DATA && where >= 0)
        refuse_line("%s: line %d: %s", name, f->points.line[where], cagd_status_text(status));
    else if (status == CAGD_OVERFLOW)
        refuse_line("%s: coordinates or standard deviations are so large or so small that squared distances leave the "
                    "range of numbers",
                    name);
    else
        refuse_line("%s: %s", name, cagd_status_text(status));
    return status == CAGD_NO_MEMORY ? EXIT_INTERNAL : EXIT_USAGE;
}

static int write_and_print(const struct fit_arguments *a, const struct fit *f)
{
    if ((a->curve != NULL && write_curve(f, a->curve) != 0) ||
        (a->residuals != NULL && write_residuals(f, a->residuals) != 0) ||
        (a->svg != NULL && write_picture(f, a->svg) != 0))
        return EXIT_INTERNAL;
    if (a->asked.json)
        print_json_exactly(fit_json(f));
    else
        print_fit(f, a->verbose);
    return cagd_fit_is_minimum(f->result) ? EXIT_AS_EXPECTED : EXIT_NOT_AS_EXPECTED;
}

/* Whether the check in intervals has found that the curve is no minimum, or that a foot is no nearest point. */
static int is_refuted(const struct fit *f)
{
    const cagd_stationary_verdict *v = &f->verdict;
    return f->nearest.refuted || (v->verified && !v->minimum && v->bounds != CAGD_STATIONARY_OPEN);
}

/* On a terminal. */
static void tell_starts(void *context, int ended, int starts)
{
    (void)context;
    waiting_at(ended, starts, "starts");
}

static int fit_points(const struct fit_arguments *a, struct fit *f)
{
    cagd_spline initial;
    cagd_fit_result *result;
    int where = -1;
    f->sigma_given = a->sigma != 0;
    if (f->sigma_given && f->points.sigma != NULL) {
        refuse_line("%s: there is a column of standard deviations; --sigma does not go with it", f->path);
        return EXIT_USAGE;
    }
    double *sigma = f->points.sigma;
    if (f->sigma_given) {
        sigma = doubles(f->points.count);
        for (int i = 0; i < f->points.count; i++)
            sigma[i] = a->sigma;
    }
    const cagd_fit_data all = {f->points.count, f->points.dim, f->points.at, sigma};
    f->data = all;
    if (a->initial != NULL) {
        if (read_initial(a, f->points.dim, &initial) != 0)
            return EXIT_USAGE;
        f->options.initial = &initial;
    }
    give_knots(a, &f->options);
    waiting_begin("fitting");
    if (f->options.starts > 1) {
        f->options.after_start = tell_starts;
        waiting_at(0, f->options.starts, "starts");
    }
    cagd_status status = cagd_fit_choose(&f->data, &f->options, &a->choices, &result, &where);
    waiting_end();
    if (status != CAGD_OK)
        return complain(f, status, where);
    f->result = result;
    f->data.count = result->count; /* a point that repeats the first one is left out */
    f->checked = a->verify;
    if (f->checked && is_terminal(stderr))
        fputs("verifying in intervals ...", stderr);
    if (f->checked && (nothing_is_free(f) || is_ellipse(f)))
        f->nearest = cagd_stationary_nearest(&f->data, &result->curve, result->feet);
    else if (f->checked)
        f->verdict = cagd_stationary_check_fit(&f->data, &f->options, result);
    end_progress();
    if (is_refuted(f))
        cagd_fit_refute(result);
    status = cagd_fit_quality_of(&f->data, &f->options, result, &f->quality);
    if (status == CAGD_OK)
        status = cagd_fit_circle_of(&f->data, &f->options, result, &f->circle);
    if (status == CAGD_OK) {
        waiting_begin("trying what cures it");
        status = cagd_fit_cures_of(&all, &f->options, &a->choices, result, &f->quality, &f->cures);
        waiting_end();
    }
    if (status != CAGD_OK)
        return complain(f, status, -1);
    int code = write_and_print(a, f);
    cagd_fit_free(result);
    return code;
}

int run_fit(const struct call *call)
{
    region_mark mark = region_open();
    struct fit_arguments a = read_fit_arguments(call);
    struct fit f = {.path = a.asked.path, .options = a.options, .choices = a.choices};
    int code = EXIT_USAGE;
    struct input_error error;
    if (read_points(a.asked.path, &a.columns, &f.points, &error) == 0) {
        code = fit_points(&a, &f);
        free_points(&f.points);
    } else {
        report_input_error(a.asked.path, &error);
    }
    free(a.inner);
    region_drop(mark);
    cagd_thread_end();
    return code;
}
