/* fit_report.c -- a fit in words, as JSON, and its residuals as a table. */
#include "cli/fit.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

enum {
    WIDTH = 100,          /* of the text                                                   */
    MOST_CORRELATIONS = 8 /* are printed; all of them are in the JSON                      */
};
static const double LARGE = 0.9; /* correlations that are printed */

static const char coordinate[] = "xyz";

/* ---- estimates ------------------------------------------------------------------------------------- */

/* Whether binary64 has a number for a weight, or for I_j. */
static int in_range(double positive) { return positive > 0 && isfinite(positive); }

struct estimate unknown_estimate(const cagd_fit_result *r, int k)
{
    double value = r->value[k], error = NAN;
    if (!r->at_bound[k] && r->determined[k])
        error = sqrt(r->covariance[(size_t)k * (size_t)r->unknowns + (size_t)k]);
    struct estimate e = {value, error, value - r->quantile * error, value + r->quantile * error};
    if (r->unknown[k].is_weight) {
        e.value = exp(value);
        e.error = e.value * error;
        e.low = exp(e.low);
        e.high = exp(e.high);
        if (!in_range(e.value))
            e.error = NAN;
    }
    return e;
}

/* By the error of log I_j, as for weights. */
struct estimate invariant_estimate(const cagd_fit_result *r, int j)
{
    double value = r->invariant[j], error = isfinite(r->invariant_error[j]) ? r->invariant_error[j] : NAN;
    if (!in_range(value))
        return (struct estimate){value, NAN, NAN, NAN};
    double factor = exp(r->quantile * error / value);
    return (struct estimate){value, error, value / factor, value * factor};
}

void unknown_name(const cagd_fit_result *r, int k, char name[32])
{
    const cagd_fit_unknown *u = &r->unknown[k];
    if (u->is_weight)
        snprintf(name, 32, "w%d", u->index);
    else
        snprintf(name, 32, "P%d %c", u->index, coordinate[u->coordinate]);
}

static double correlation(const cagd_fit_result *r, int i, int j)
{
    size_t n = (size_t)r->unknowns, a = (size_t)i, b = (size_t)j;
    return r->covariance[a * n + b] / sqrt(r->covariance[a * n + a] * r->covariance[b * n + b]);
}

/* ---- numbers in words ------------------------------------------------------------------------------ */

void put_rounded(FILE *out, double value, double error)
{
    enum { LONGEST = 12 };
    if (!isfinite(error) || !(error > 0)) {
        fprintf(out, "%.10g", value);
        return;
    }
    char digits[32];
    snprintf(digits, sizeof digits, "%.1e", error); /* whose exponent is that of the rounded error */
    int places = 1 - atoi(strchr(digits, 'e') + 1);
    double size = fmax(fabs(value), fabs(error));
    int whole = size > 0 ? (int)floor(log10(size)) : 0;
    if (places >= 0 && places <= LONGEST && whole < LONGEST)
        fprintf(out, "%.*f", places, value);
    else if (places < 0 && whole < LONGEST)
        fprintf(out, "%.0f", value);
    else
        fprintf(out, "%.*e",
                value != 0 && places + (int)floor(log10(fabs(value))) > 0 ? places + (int)floor(log10(fabs(value))) : 1,
                value);
}

/* The same in a column that ends at `width`. */
static void put_column(double value, double error, int width)
{
    char *text;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    put_rounded(out, value, error);
    fclose(out);
    printf("%*s", width, text);
    free(text);
}

static void put_interval(struct estimate e)
{
    fputs("     ", stdout);
    if (isfinite(e.error) && isinf(e.high)) { /* only weights and invariants, through their logarithms */
        fputs("as good as every number > 0", stdout);
        return;
    }
    put_rounded(stdout, e.low, e.error);
    fputs(" to ", stdout);
    put_rounded(stdout, e.high, e.error);
}

static const char *plural(int n) { return n == 1 ? "" : "s"; }

/* ---- the text -------------------------------------------------------------------------------------- */

/* A line of the report: its name, and words that are filled into the column beside it. */
struct line {
    FILE *out;
    char *text;
    size_t size;
};

static FILE *begin(struct line *l) { return l->out = open_memstream(&l->text, &l->size); }

static void end(struct line *l, const char *name)
{
    enum { INDENT = 20 };
    char *filled;
    size_t size;
    fclose(l->out);
    FILE *out = open_memstream(&filled, &size);
    put_paragraph(out, l->text, INDENT, WIDTH);
    fclose(out);
    printf("%-*s%s", INDENT, name, filled + INDENT);
    free(filled);
    free(l->text);
}

static void say(const char *name, const char *format, ...) __attribute__((format(printf, 2, 3)));
static void say(const char *name, const char *format, ...)
{
    struct line l;
    va_list list;
    va_start(list, format);
    vfprintf(begin(&l), format, list);
    va_end(list);
    end(&l, name);
}

static const char *const loss_name[] = {"squares", "huber", "cauchy"};

static void print_heading(const struct fit *f)
{
    const cagd_fit_result *r = f->result;
    const cagd_spline *c = &r->curve;
    int segments = 0;
    for (int mu = c->degree; mu < c->count; mu++)
        segments += c->knots[mu] < c->knots[mu + 1];
    say("Points", "%d in %s, from %s%s", f->data.count, f->data.dim == 2 ? "the plane" : "space",
        strcmp(f->path, "-") == 0 ? "standard input" : f->path,
        f->data.sigma == NULL ? ""
        : f->sigma_given      ? ", with one standard deviation"
                              : ", each with its standard deviation");
    struct line l;
    FILE *out = begin(&l);
    if (segments == 1)
        fprintf(out, "rational Bézier curve of degree %d", c->degree);
    else
        fprintf(out, "NURBS curve of degree %d with %d segments and %d control points", c->degree, segments, c->count);
    static const char *const part[] = {"weights", "inner points", "end points"};
    fputs("; free: ", out);
    for (int k = 0, said = 0; k < 3; k++)
        if (f->options.free & 1 << k)
            fprintf(out, "%s%s", said++ > 0 ? ", " : "", part[k]);
    if (f->options.initial == NULL && !(f->options.free & CAGD_FIT_END_POINTS))
        fputs("; it begins and ends in the first and the last point", out);
    end(&l, "Curve");
    if (f->options.loss == CAGD_FIT_SQUARES)
        say("Minimised", "half the sum of the squared orthogonal distances%s",
            f->data.sigma != NULL ? " over the squared standard deviations" : "");
    else
        say("Minimised", "half the sum of the orthogonal distances%s by the loss of %s, scale %g",
            f->data.sigma != NULL ? " in standard deviations" : "",
            f->options.loss == CAGD_FIT_HUBER ? "Huber" : "Cauchy", f->options.loss_scale);
    out = begin(&l);
    fputs(r->termination == CAGD_FIT_CONVERGED       ? "converged"
          : r->termination == CAGD_FIT_NOT_CONVERGED ? "NOT converged"
                                                     : "FAILED",
          out);
    if (r->termination != CAGD_FIT_CONVERGED)
        fprintf(out, ": %s", r->message);
    if (f->options.starts > 1)
        fprintf(out, "; %d of %d starts came to this minimum", r->agreeing_starts, f->options.starts);
    end(&l, "Minimiser");
}

/* Those that do not stand on a bound. */
static int free_unknowns(const cagd_fit_result *r)
{
    int count = 0;
    for (int k = 0; k < r->unknowns; k++)
        count += !r->at_bound[k];
    return count;
}

/* x rounded up or down to a power of ten. */
static const char *power_of_ten(double x, double towards(double), char text[16])
{
    if (x > 0)
        snprintf(text, 16, "1e%.0f", towards(log10(x)));
    else
        strcpy(text, "0");
    return text;
}

/* A stationary point is that one if no coordinate and no logarithm of a weight is farther away than this; 0 where nothing
 * is said. */
static double alone_within(const struct fit *f)
{
    double alone = INFINITY;
    for (int k = 0; k < f->result->unknowns; k++)
        if (!f->result->at_bound[k])
            alone = fmin(alone, f->result->unknown[k].is_weight ? f->verdict.weight_alone : f->verdict.point_alone);
    return isfinite(alone) ? alone : 0;
}

/* What the check in intervals found. */
static void print_verdict(const struct fit *f)
{
    const stationary_verdict *v = &f->verdict;
    if (!f->checked)
        return;
    struct line l;
    FILE *out = begin(&l);
    double near = fmax(v->point_radius, v->weight_radius), alone = alone_within(f);
    char within[16], only[16];
    if (v->verified) {
        fprintf(out, "verified in intervals: %s%s lies within %s of these coordinates and logarithms of weights",
                v->minimum ? "a strict local minimum" : "a stationary point",
                v->dimension < free_unknowns(f->result) ? ", up to the free directions," : "",
                power_of_ten(near, ceil, within));
        if (alone > 0 && (near == 0 || floor(log10(alone)) > ceil(log10(near))))
            fprintf(out, ", and is the only stationary point within %s", power_of_ten(alone, floor, only));
    } else {
        fprintf(out, "not verified: %s", v->reason);
        if (v->where >= 0)
            fprintf(out, " (point %d, line %d)", v->where + 1, f->points.line[v->where]);
    }
    end(&l, "Verification");
}

static void print_estimates(const struct fit *f)
{
    const cagd_fit_result *r = f->result;
    if (r->unknowns > 0)
        printf("\n%12s%17s%18s     %s\n", "", "estimate", "standard error", "95 % interval");
    for (int k = 0; k < r->unknowns; k++) {
        char name[32];
        struct estimate e = unknown_estimate(r, k);
        unknown_name(r, k, name);
        printf("  %-10s", name);
        put_column(e.value, e.error, 17);
        if (r->at_bound[k]) {
            puts("  on its bound");
        } else if (r->unknown[k].is_weight && !in_range(e.value)) {
            puts("  beyond the range of numbers");
        } else if (!r->determined[k]) {
            puts("  not determined");
        } else if (!isfinite(e.error)) {
            puts("  no standard error");
        } else {
            put_column(e.error, e.error, 18);
            put_interval(e);
            puts("");
        }
    }
    for (int j = 0; j < r->invariants; j++) {
        char name[32];
        struct estimate e = invariant_estimate(r, j);
        snprintf(name, sizeof name, "I%d", j + 1);
        printf("  %-10s", name);
        put_column(e.value, e.error, 17);
        if (isfinite(e.error) && e.error > 0) {
            put_column(e.error, e.error, 18);
            put_interval(e);
        } else if (!in_range(e.value))
            fputs("  beyond the range of numbers", stdout);
        else if (!(e.error == 0))
            fputs("  not determined", stdout);
        puts("");
    }
}

/* What is given is not estimated. */
static void print_fixed(const struct fit *f)
{
    const cagd_spline *c = &f->result->curve;
    struct line l;
    FILE *out = begin(&l);
    int said = 0;
    for (int j = 0; j < c->count; j++) {
        int weight = 0, point = 0;
        for (int k = 0; k < f->result->unknowns; k++)
            if (f->result->unknown[k].index == j) {
                weight |= f->result->unknown[k].is_weight;
                point |= !f->result->unknown[k].is_weight;
            }
        if (!point) {
            fprintf(out, "%sP%d = (", said++ > 0 ? ", " : "", j);
            for (int x = 0; x < c->dim; x++)
                fprintf(out, "%s%.10g", x > 0 ? ", " : "", c->points[j * c->dim + x]);
            fputs(")", out);
        }
        if (!weight)
            fprintf(out, "%sw%d = %.10g", said++ > 0 ? ", " : "", j, c->weights[j]);
    }
    end(&l, "  Given");
}

/* Pairs of unknowns with large correlations, the largest first. */
static void print_correlations(const cagd_fit_result *r)
{
    struct pair {
        int i, j;
        double r;
    } best[MOST_CORRELATIONS];
    int count = 0, all = 0;
    for (int i = 0; i < r->unknowns; i++)
        for (int j = 0; j < i; j++) {
            struct pair p = {j, i, correlation(r, i, j)};
            if (!(fabs(p.r) >= LARGE) || !r->determined[i] || !r->determined[j])
                continue;
            all++;
            int at = count < MOST_CORRELATIONS ? count++ : count;
            for (; at > 0 && fabs(best[at - 1].r) < fabs(p.r); at--)
                if (at < MOST_CORRELATIONS)
                    best[at] = best[at - 1];
            if (at < MOST_CORRELATIONS)
                best[at] = p;
        }
    if (all == 0) {
        say("Correlations", "none of %g or more", LARGE);
        return;
    }
    struct line l;
    FILE *out = begin(&l);
    for (int k = 0; k < count; k++) {
        char a[32], b[32];
        unknown_name(r, best[k].i, a);
        unknown_name(r, best[k].j, b);
        fprintf(out, "%s%s and %s %.3f", k > 0 ? ", " : "", a, b, best[k].r);
    }
    if (all > count)
        fprintf(out, ", and %d more of %g or more", all - count, LARGE);
    end(&l, "Correlations");
}

/* Measured points at which the curve has to begin and end, although the others do not lie on it. */
static int ends_taken_as_exact(const struct fit *f)
{
    return f->options.initial == NULL && !(f->options.free & CAGD_FIT_END_POINTS) &&
           (f->data.sigma != NULL || f->result->scale_squared > 0);
}

/* The unknowns that a free direction moves most, and how. */
static void print_free_directions(const cagd_fit_result *r)
{
    enum { MOST = 6 };
    int free = free_unknowns(r);
    int flat = free - r->rank;
    if (flat <= 0) {
        say("Rank", "%d of %d: the points determine every unknown", r->rank, free);
        return;
    }
    say("Rank", "%d of %d: the distances stay what they are, to first order, along %s", r->rank, free,
        flat == 1 ? "one direction, which moves" : "several directions, which move");
    for (int d = 0; d < flat; d++) {
        const double *v = r->free_directions + (size_t)d * (size_t)r->unknowns;
        double largest = 0;
        for (int k = 0; k < r->unknowns; k++)
            largest = fmax(largest, fabs(v[k]));
        struct line l;
        FILE *out = begin(&l);
        int said = 0;
        for (int k = 0; k < r->unknowns; k++)
            if (fabs(v[k]) >= largest / 20 && said++ < MOST) {
                char name[32];
                unknown_name(r, k, name);
                fprintf(out, "%s%s%s by %+.3f", said > 1 ? ", " : "", r->unknown[k].is_weight ? "log " : "", name,
                        v[k]);
            }
        if (said > MOST)
            fprintf(out, ", and %d more", said - MOST);
        end(&l, "");
    }
}

static void print_statistics(const struct fit *f)
{
    const cagd_fit_result *r = f->result;
    int known = f->data.sigma != NULL && f->options.loss == CAGD_FIT_SQUARES;
    struct line l;
    FILE *out = begin(&l);
    fprintf(out, "root mean square %.4g, largest %.4g at point %d (line %d)", r->rms, r->largest, r->largest_at + 1,
            f->points.line[r->largest_at]);
    int ends = 0;
    for (int i = 0; i < r->count; i++)
        ends += r->foot_at_end[i];
    if (ends > 0)
        fprintf(out, "; %d foot point%s at an end of the curve", ends, plural(ends));
    if (r->out_of_order > 0)
        fprintf(out, "; %d of the feet overtake%s the one before", r->out_of_order, r->out_of_order == 1 ? "s" : "");
    end(&l, "Distances");
    out = begin(&l);
    fprintf(out, "%.6g on %d degree%s of freedom", r->chi_squared, r->degrees_of_freedom,
            plural(r->degrees_of_freedom));
    if (isfinite(r->reduced_chi_squared))
        fprintf(out, "; reduced %.4g", r->reduced_chi_squared);
    if (isfinite(r->aic) && isfinite(r->bic))
        fprintf(out, "; AIC %.6g, BIC %.6g", r->aic, r->bic);
    end(&l, "Chi-squared");
    if (known)
        say("Standard errors",
            "from the given standard deviations; 95 %% intervals: %.4g of them to either side (normal distribution, "
            "for weights and invariants of the logarithms)",
            r->quantile);
    else if (r->scale_squared > 0 && isfinite(r->scale_squared))
        say("Standard errors",
            "%s %.4g, estimated from the distances; 95 %% intervals: %.4g of them to either side (Student's t, for "
            "weights and invariants of the logarithms)",
            f->data.sigma != NULL ? "from the given standard deviations times" : "from a standard deviation of",
            sqrt(r->scale_squared), r->quantile);
    else
        say("Standard errors", "none: the distances leave nothing to estimate a standard deviation from");
    if (ends_taken_as_exact(f))
        say("Ends",
            "the first and the last point are taken as exact: their errors move the whole curve, weights with it, and "
            "are not in the standard errors; --free %sinner,ends fits the ends too, which then slide along the curve",
            f->options.free & CAGD_FIT_WEIGHTS ? "weights," : "");
    double cusp;
    if (cagd_fit_has_cusp(r, &cusp))
        say("Cusp",
            "at t = %.6g the curve turns on a radius no larger than the distances, as at a cusp: standard errors, rank "
            "and free directions, which take the curve as smooth there, cannot be relied on",
            cusp);
    if (r->unknowns > 0) {
        print_free_directions(r);
        print_correlations(r);
    }
    cagd_fit_conic conic = cagd_fit_conic_of(r);
    if (conic.kind != CAGD_FIT_NOT_QUADRATIC)
        say("Conic", "%s", conic.text);
}

static void print_history(const cagd_fit_result *r)
{
    printf("\n  %9s %24s %12s %12s %12s\n", "iteration", "cost", "gradient", "step", "trust radius");
    for (int k = 0; k < r->steps; k++) {
        const cagd_fit_step *s = &r->history[k];
        printf("  %9d %24.17g %12.3e %12.3e %12.3e%s\n", s->iteration, s->cost, s->gradient_norm, s->step_norm,
               s->trust_radius, s->accepted ? "" : "  rejected");
    }
    printf("  %s\n", r->message);
}

void print_fit(const struct fit *f, int verbose)
{
    print_heading(f);
    print_verdict(f);
    if (verbose)
        print_history(f->result);
    print_estimates(f);
    print_fixed(f);
    puts("");
    print_statistics(f);
}

/* ---- JSON ------------------------------------------------------------------------------------------ */

static json_t *real(double x) { return isfinite(x) ? json_real(x) : json_null(); }

static json_t *reals(int count, const double x[])
{
    json_t *array = json_array();
    for (int i = 0; i < count; i++)
        json_array_append_new(array, real(x[i]));
    return array;
}

json_t *fitted_curve_json(const cagd_spline *c)
{
    int bezier = c->count == c->degree + 1;
    for (int i = 0; i < c->count + c->degree + 1; i++)
        bezier = bezier && c->knots[i] == (i > c->degree);
    json_t *points = json_array();
    for (int j = 0; j < c->count; j++)
        json_array_append_new(points, reals(c->dim, c->points + j * c->dim));
    json_t *curve = json_pack("{s:s, s:i, s:o, s:o}", "kind", bezier ? "rational-bezier" : "nurbs", "degree", c->degree,
                              "points", points, "weights", reals(c->count, c->weights));
    if (!bezier)
        json_object_set_new(curve, "knots", reals(c->count + c->degree + 1, c->knots));
    return curve;
}

static json_t *estimate_json(struct estimate e)
{
    return json_pack("{s:o, s:o, s:o, s:o}", "value", real(e.value), "standard_error", real(e.error), "low",
                     real(e.low), "high", real(e.high));
}

static json_t *unknowns_json(const cagd_fit_result *r)
{
    json_t *list = json_array();
    for (int k = 0; k < r->unknowns; k++) {
        const cagd_fit_unknown *u = &r->unknown[k];
        char name[32];
        unknown_name(r, k, name);
        json_t *j =
            json_pack("{s:s, s:s, s:i}", "name", name, "kind", u->is_weight ? "weight" : "point", "index", u->index);
        if (!u->is_weight)
            json_object_set_new(j, "coordinate", json_integer(u->coordinate));
        json_t *estimate = estimate_json(unknown_estimate(r, k));
        json_object_update(j, estimate);
        json_decref(estimate);
        json_object_set_new(j, "determined", json_boolean(r->determined[k]));
        json_object_set_new(j, "at_bound", json_boolean(r->at_bound[k]));
        json_array_append_new(list, j);
    }
    return list;
}

static json_t *correlations_json(const cagd_fit_result *r)
{
    json_t *rows = json_array();
    for (int i = 0; i < r->unknowns; i++) {
        json_t *row = json_array();
        for (int j = 0; j < r->unknowns; j++)
            json_array_append_new(row, real(correlation(r, i, j)));
        json_array_append_new(rows, row);
    }
    return rows;
}

static json_t *matrix_json(int rows, int columns, const double a[])
{
    json_t *list = json_array();
    for (int i = 0; i < rows; i++)
        json_array_append_new(list, reals(columns, a + (size_t)i * (size_t)columns));
    return list;
}

static json_t *conic_json(const cagd_fit_result *r)
{
    static const char *const kind[] = {"", "unknown", "straight", "undecided", "certain"};
    static const char *const type[] = {"ellipse", "parabola", "hyperbola"};
    cagd_fit_conic c = cagd_fit_conic_of(r);
    if (c.kind == CAGD_FIT_NOT_QUADRATIC)
        return json_null();
    return json_pack("{s:s, s:s, s:s, s:o, s:o}", "verdict", c.text, "kind", kind[c.kind], "type", type[c.type],
                     "log_invariant", real(c.log_invariant), "standard_error", real(c.error));
}

static json_t *verdict_json(const struct fit *f)
{
    const stationary_verdict *v = &f->verdict;
    if (!f->checked)
        return json_pack("{s:s}", "status", "not asked");
    if (v->verified)
        return json_pack("{s:s, s:b, s:i, s:o, s:o, s:o, s:o}", "status", "verified", "strict_minimum", v->minimum,
                         "dimension", v->dimension, "weight_radius", real(v->weight_radius), "point_radius",
                         real(v->point_radius), "weight_alone", real(v->weight_alone), "point_alone",
                         real(v->point_alone));
    return json_pack("{s:s, s:s, s:o}", "status", "not verified", "reason", v->reason, "point",
                     v->where >= 0 ? json_integer(v->where + 1) : json_null());
}

static json_t *history_json(const cagd_fit_result *r)
{
    json_t *list = json_array();
    for (int k = 0; k < r->steps; k++) {
        const cagd_fit_step *s = &r->history[k];
        json_array_append_new(list, json_pack("{s:i, s:b, s:o, s:o, s:o, s:o}", "iteration", s->iteration, "accepted",
                                              s->accepted, "cost", real(s->cost), "gradient", real(s->gradient_norm),
                                              "step", real(s->step_norm), "trust_radius", real(s->trust_radius)));
    }
    return list;
}

json_t *fit_json(const struct fit *f)
{
    static const char *const termination[] = {"converged", "not converged", "failed"};
    static const char *const part[] = {"weights", "inner", "ends"};
    const cagd_fit_result *r = f->result;
    const cagd_fit_options *o = &f->options;
    json_t *free = json_array(), *invariants = json_array();
    for (int k = 0; k < 3; k++)
        if (o->free & 1 << k)
            json_array_append_new(free, json_string(part[k]));
    for (int j = 0; j < r->invariants; j++)
        json_array_append_new(invariants, estimate_json(invariant_estimate(r, j)));
    int flat = free_unknowns(r) - r->rank, ends = 0;
    for (int i = 0; i < r->count; i++)
        ends += r->foot_at_end[i];
    json_t *points =
        json_pack("{s:s, s:i, s:i, s:s}", "file", f->path, "count", f->data.count, "dimension", f->data.dim, "sigma",
                  f->data.sigma == NULL ? "unknown"
                  : f->sigma_given      ? "one"
                                        : "column");
    json_t *options =
        json_pack("{s:o, s:s, s:o, s:b, s:o, s:o, s:i, s:I, s:o, s:i}", "free", free, "loss", loss_name[o->loss],
                  "scale", o->loss == CAGD_FIT_SQUARES ? json_null() : real(o->loss_scale), "unordered", o->unordered,
                  "weight_low", real(o->weight_low), "weight_high", real(o->weight_high), "starts", o->starts, "seed",
                  (json_int_t)o->seed, "tolerance", real(o->tolerance), "max_iterations", o->max_iterations);
    json_t *minimiser =
        json_pack("{s:s, s:s, s:i, s:i, s:i, s:o, s:o, s:o, s:o}", "termination", termination[r->termination],
                  "message", r->message, "iterations", r->iterations, "best_start", r->best_start, "agreeing_starts",
                  r->agreeing_starts, "initial_cost", real(r->initial_cost), "cost", real(r->cost), "gradient",
                  real(r->gradient_norm), "history", history_json(r));
    json_t *distances = json_pack("{s:o, s:o, s:i, s:i, s:i, s:i}", "rms", real(r->rms), "largest", real(r->largest),
                                  "largest_point", r->largest_at + 1, "largest_line", f->points.line[r->largest_at],
                                  "feet_at_ends", ends, "feet_out_of_order", r->out_of_order);
    double cusp;
    int has_cusp = cagd_fit_has_cusp(r, &cusp);
    json_t *statistics =
        json_pack("{s:o, s:o, s:i, s:o, s:o, s:o, s:s, s:f, s:o}", "chi_squared", real(r->chi_squared),
                  "reduced_chi_squared", real(r->reduced_chi_squared), "degrees_of_freedom", r->degrees_of_freedom,
                  "aic", real(r->aic), "bic", real(r->bic), "scale_squared", real(r->scale_squared), "scaled_by",
                  f->data.sigma != NULL && o->loss == CAGD_FIT_SQUARES ? "the given standard deviations"
                                                                       : "the scatter of the points",
                  "level", 0.95, "quantile", real(r->quantile));
    return json_pack(
        "{s:s, s:b, s:o, s:o, s:o, s:o, s:o, s:i, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:b, s:o, s:o}", "schema",
        "cagd-fit-1", "converged", r->termination == CAGD_FIT_CONVERGED, "points", points, "options", options,
        "minimiser", minimiser, "curve", fitted_curve_json(&r->curve), "unknowns", unknowns_json(r), "rank", r->rank,
        "free_directions", matrix_json(flat, r->unknowns, r->free_directions), "covariance",
        matrix_json(r->unknowns, r->unknowns, r->covariance), "correlations", correlations_json(r), "invariants",
        invariants, "conic", conic_json(r), "statistics", statistics, "distances", distances, "ends_taken_as_exact",
        ends_taken_as_exact(f), "cusp", has_cusp ? real(cusp) : json_null(), "verification", verdict_json(f));
}

/* ---- files ----------------------------------------------------------------------------------------- */

int write_curve(const struct fit *f, const char *path)
{
    json_t *curve = fitted_curve_json(&f->result->curve);
    char *text = json_dumps(curve, JSON_INDENT(2) | JSON_REAL_PRECISION(17));
    struct output *o = output_open(path);
    if (o != NULL)
        fprintf(output_stream(o), "%s\n", text);
    int code = o == NULL ? -1 : output_close(o);
    free(text);
    json_decref(curve);
    return code;
}

/* One row a point: its number, its line in the file, its coordinates, the parameter of the foot and the foot, the
 * residual in every coordinate, the distance, and that over the standard deviation, which is the estimated one where
 * none is given. */
int write_residuals(const struct fit *f, const char *path)
{
    const cagd_fit_result *r = f->result;
    int dim = f->data.dim;
    struct output *o = output_open(path);
    if (o == NULL)
        return -1;
    FILE *out = output_stream(o);
    fputs("row,line", out);
    for (int x = 0; x < dim; x++)
        fprintf(out, ",%c", coordinate[x]);
    fputs(",t", out);
    for (int x = 0; x < dim; x++)
        fprintf(out, ",foot_%c", coordinate[x]);
    for (int x = 0; x < dim; x++)
        fprintf(out, ",residual_%c", coordinate[x]);
    fputs(",distance,standardised\n", out);
    for (int i = 0; i < r->count; i++) {
        const double *Q = f->data.points + i * dim, *e = r->residuals + i * dim;
        double sigma = f->data.sigma != NULL ? f->data.sigma[i] : sqrt(r->scale_squared);
        fprintf(out, "%d,%d", i + 1, f->points.line[i]);
        for (int x = 0; x < dim; x++)
            fprintf(out, ",%.17g", Q[x]);
        fprintf(out, ",%.17g", r->feet[i]);
        for (int x = 0; x < dim; x++)
            fprintf(out, ",%.17g", Q[x] - e[x]);
        for (int x = 0; x < dim; x++)
            fprintf(out, ",%.17g", e[x]);
        fprintf(out, ",%.17g,", r->distances[i]);
        if (isfinite(sigma) && sigma > 0)
            fprintf(out, "%.17g", r->distances[i] / sigma);
        fputs("\n", out);
    }
    return output_close(o);
}
