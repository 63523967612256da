/* text.c -- a fit in words. */
#include "chapters/judge/memory_text.h"
#include "cli/fit/fit.h"
#include "cli/input.h"
#include "cli/layout.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

enum {
    WIDTH = 100,          /* of the text                                                   */
    MOST_CORRELATIONS = 8 /* are printed; all of them are in the JSON                      */
};
static const double LARGE = 0.9; /* correlations that are printed */

/* ---- numbers in a table ---------------------------------------------------------------------------- */

/* The same in a column that ends at `width`. */
static void put_column(double origin, double value, double error, int width)
{
    char *text;
    size_t size;
    FILE *out = text_open(&text, &size);
    put_rounded(out, origin, value, error);
    text_close(out, &text);
    printf("%*s", width, text);
    free(text);
}

static void put_interval(cagd_fit_estimate e)
{
    fputs("     ", stdout);
    if (isfinite(e.error) && isinf(e.high)) { /* only weights and invariants, through their logarithms */
        fputs("as good as every number > 0", stdout);
        return;
    }
    put_rounded(stdout, e.origin, e.low, e.error);
    fputs(" to ", stdout);
    put_rounded(stdout, e.origin, e.high, e.error);
}

static const char *plural(int n) { return n == 1 ? "" : "s"; }

/* ---- the text -------------------------------------------------------------------------------------- */

/* A line of the report: its name, and words that are filled into the column beside it. */
struct cagd_line {
    FILE *out;
    char *text;
    size_t size;
};

static FILE *begin(struct cagd_line *l) { return l->out = text_open(&l->text, &l->size); }

static void end(struct cagd_line *l, const char *name)
{
    enum { INDENT = 20 };
    char *filled;
    size_t size;
    text_close(l->out, &l->text);
    FILE *out = text_open(&filled, &size);
    put_paragraph(out, l->text, INDENT, WIDTH);
    text_close(out, &filled);
    printf("%-*s%s", INDENT, name, filled + INDENT);
    free(filled);
    free(l->text);
}

void say(const char *name, const char *format, ...)
{
    struct cagd_line l;
    va_list list;
    va_start(list, format);
    vfprintf(begin(&l), format, list);
    va_end(list);
    end(&l, name);
}

void print_number(const char *name, cagd_fit_number x)
{
    printf("  %-18s", name);
    put_column(0, x.value, x.error, 18);
    if (isfinite(x.error) && x.error > 0) {
        put_column(0, x.error, x.error, 18);
        fputs("     ", stdout);
        if (isfinite(x.low) && isfinite(x.high)) {
            put_rounded(stdout, 0, x.low, x.error);
            fputs(" to ", stdout);
            put_rounded(stdout, 0, x.high, x.error);
        } else
            fputs("none", stdout);
    }
    puts("");
}

/* What was read otherwise than as a plain table. */
static void print_reading(const struct fit *f)
{
    const struct points *p = &f->points;
    struct cagd_line l;
    int table = strcmp(p->format, "table") == 0;
    if (table && p->notes == 0)
        return;
    FILE *out = begin(&l);
    fputs(table ? "" : p->format, out);
    for (int k = 0; k < p->notes; k++)
        fprintf(out, "%s%s", k > 0 || !table ? "; " : "", p->note[k]);
    end(&l, "Read");
}

static void print_heading(const struct fit *f)
{
    const cagd_fit_result *r = f->result;
    const cagd_spline *c = &r->curve;
    int segments = 0;
    for (int mu = c->degree; mu < c->count; mu++)
        segments += c->knots[mu] < c->knots[mu + 1];
    say("Points", "%d in %s, from %s%s", f->data.count, f->data.dim == 2 ? "the plane" : "space",
        name_of_input(f->path),
        f->data.sigma == NULL ? ""
        : f->sigma_given      ? ", with one standard deviation"
                              : ", each with its standard deviation");
    struct cagd_line l;
    print_reading(f);
    FILE *out = begin(&l);
    if (is_ellipse(f))
        fprintf(out, "%s; as a NURBS curve of degree 2 with %d segments",
                r->found.ellipse.whole    ? r->found.ellipse.circle ? "a whole circle" : "a whole ellipse"
                : r->found.ellipse.circle ? "an arc of a circle"
                                          : "an arc of an ellipse",
                segments);
    else if (r->period > 0)
        fprintf(out,
                "closed NURBS curve of degree %d with %d segments and as many control points, %s at the seam as at "
                "every knot",
                c->degree, segments,
                c->degree == 1   ? "continuous"
                : c->degree == 2 ? "with continuous tangents"
                                 : "with continuous curvature");
    else if (segments == 1)
        fprintf(out, "rational Bézier curve of degree %d", c->degree);
    else
        fprintf(out, "NURBS curve of degree %d with %d segments and %d control points", c->degree, segments, c->count);
    static const char *const part[] = {"weights", "inner points", "end points"};
    fputs(is_ellipse(f) ? "" : nothing_is_free(f) ? "; nothing is free" : "; free: ", out);
    for (int k = 0, said = 0; k < 3 && !is_ellipse(f); k++)
        if (k == 0 ? fits_weights(f)
                   : (f->options.free & 1 << k) && !(k == 2 && r->period > 0) && !(k == 1 && c->count == 2))
            fprintf(out, "%s%s", said++ > 0 ? ", " : "", r->period > 0 && k == 1 ? "points" : part[k]);
    if (r->end_points[0] >= 0 && (f->options.unordered || r->left_out[0] + r->left_out[1] > 0))
        fprintf(out, "; points %d and %d are measurements of its ends", r->end_points[0] + 1, r->end_points[1] + 1);
    else if (r->end_points[0] >= 0)
        fputs("; the first and the last point are measurements of its ends", out);
    if (f->options.initial == NULL && !(f->options.free & CAGD_FIT_END_POINTS) && r->period == 0 && !is_ellipse(f))
        fprintf(out, "; it begins and ends in %s",
                f->options.unordered ? "two of the points" : "the first and the last point");
    end(&l, "Curve");
    print_choice(f);
    if (nothing_is_free(f)) {
        say("Feet", "the nearest points of the whole curve");
        return;
    }
    if (f->options.loss == CAGD_FIT_SQUARES)
        say("Minimised", "half the sum of the squared orthogonal distances%s%s",
            f->data.sigma != NULL ? " over the squared standard deviations" : "",
            r->roughness > 0 ? ", and the smoothing term" : "");
    else
        say("Minimised", "half the sum of the orthogonal distances%s by the loss of %s, scale %.3g%s",
            f->data.sigma != NULL ? " in standard deviations" : "",
            f->options.loss == CAGD_FIT_HUBER ? "Huber" : "Cauchy", r->loss_scale,
            f->options.loss_scale == 0 ? ", estimated from the median of the distances" : "");
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

/* x rounded up or down to a power of ten; nothing below 1e-300 is told apart. */
static const char *power_of_ten(double x, double towards(double), char text[16])
{
    if (x > 0)
        snprintf(text, 16, "1e%.0f", fmax(towards(log10(x)), -300));
    else
        strcpy(text, "0");
    return text;
}

/* Whether there is a power of ten between. */
static int is_farther(double x, double y) { return x > 0 && (y == 0 || floor(log10(x)) > ceil(log10(y))); }

/* How near the minimum is, and how far away there is no other: for coordinates and for logarithms of weights, whose
 * units may be so different that one number does not do for both. */
struct reach {
    int apart;
    double point, weight, point_alone, weight_alone;
};
static struct reach reach_of(const struct fit *f)
{
    const cagd_stationary_verdict *v = &f->verdict;
    struct reach r = {0, v->point_radius, v->weight_radius, v->point_alone, v->weight_alone};
    int points = 0, weights = 0;
    for (int k = 0; k < f->result->unknowns; k++)
        if (!f->result->at_bound[k])
            *(f->result->unknown[k].is_weight ? &weights : &points) = 1;
    r.apart = points && weights && r.point > 0 && r.weight > 0 && fabs(log10(r.point / r.weight)) > 3;
    if (!r.apart) {
        r.point = r.weight = fmax(r.point, r.weight);
        r.point_alone = !points ? r.weight_alone : !weights ? r.point_alone : fmin(r.point_alone, r.weight_alone);
        r.weight_alone = r.point_alone;
    }
    return r;
}

static void put_reach(const struct fit *f, FILE *out)
{
    const cagd_stationary_verdict *v = &f->verdict;
    struct reach r = reach_of(f);
    char point[16], weight[16];
    power_of_ten(r.point, ceil, point);
    if (r.apart)
        fprintf(out, "%s of these coordinates and %s of these logarithms of weights", point,
                power_of_ten(r.weight, ceil, weight));
    else
        fprintf(out, "%s of these coordinates and logarithms of weights", point);
    if (!is_farther(r.point_alone, r.point) || !is_farther(r.weight_alone, r.weight))
        return;
    fprintf(out, ", and is the only %s within %s",
            v->bounds != CAGD_STATIONARY_NO_BOUNDS ? "one with these weights on their bounds" : "stationary point",
            power_of_ten(r.point_alone, floor, point));
    if (r.apart)
        fprintf(out, " and %s of them", power_of_ten(r.weight_alone, floor, weight));
}

/* What the check in intervals found of the feet. */
static void print_nearest(const struct fit *f)
{
    const cagd_nearest_verdict *n = &f->nearest;
    char text[16];
    if (n->verified)
        say("Verification",
            "verified in intervals: no point of the curve is nearer to any of the points than its foot by more than "
            "%s%s",
            power_of_ten(n->excess, ceil, text),
            is_ellipse(f) ? "; the minimum over all ellipses is that of the minimiser, in binary64" : "");
    else
        say("Verification", "%s: %s (point %d, line %d)", n->refuted ? "refuted in intervals" : "not verified",
            n->reason, n->where + 1, f->points.line[n->where]);
}

/* What the check in intervals found. */
static void print_verdict(const struct fit *f)
{
    const cagd_stationary_verdict *v = &f->verdict;
    if (!f->checked)
        return;
    if (nothing_is_free(f) || is_ellipse(f)) {
        print_nearest(f);
        return;
    }
    struct cagd_line l;
    FILE *out = begin(&l);
    int bounds = v->bounds != CAGD_STATIONARY_NO_BOUNDS;
    char name[32] = "";
    if (v->bound >= 0)
        unknown_name(f->result, v->bound, name);
    if (v->verified) {
        fprintf(out, "verified in intervals: %s",
                v->minimum ? bounds ? "a strict local minimum within the bounds" : "a strict local minimum"
                : bounds   ? "among the curves with these weights on their bounds a stationary point"
                           : "a stationary point that is NO minimum");
        int dimension = f->result->rank + f->result->flat;
        if (dimension == 0) {
            fputs(", with all weights on bounds", out);
        } else {
            fprintf(out, "%s lies within ", v->dimension < dimension ? ", up to the free directions," : "");
            put_reach(f, out);
        }
        if (v->bounds == CAGD_STATIONARY_FALLS)
            fprintf(out, "; it is NO minimum: the cost falls when %s leaves its bound", name);
        if (v->bounds == CAGD_STATIONARY_OPEN)
            fprintf(out, "; whether the cost grows or falls when %s leaves its bound is not known", name);
    } else {
        fprintf(out, "not verified: %s", v->reason);
        if (v->where >= 0)
            fprintf(out, " (point %d, line %d)", v->where + 1, f->points.line[v->where]);
    }
    end(&l, "Verification");
}

/* Whether binary64 holds a weight or an invariant, which are positive. */
static int is_held(double x) { return x > 0 && isfinite(x); }

static void print_estimates(const struct fit *f)
{
    const cagd_fit_result *r = f->result;
    int minimum = cagd_fit_is_minimum(f->result);
    if (r->unknowns > 0 && minimum)
        printf("\n%12s%17s%18s%s\n", "", "estimate", "standard error",
               r->interval_by[0] == CAGD_FIT_INTERVAL_NOT_SOUGHT ? "" : "     95 % interval");
    else if (r->unknowns > 0)
        printf("\n%12s%17s\n", "", "reached");
    else
        puts("");
    for (int k = 0; k < r->unknowns; k++) {
        char name[32];
        cagd_fit_estimate e = cagd_fit_unknown_estimate(f->result, k);
        unknown_name(r, k, name);
        printf("  %-10s", name);
        put_column(e.origin, e.value, e.error, 17);
        if (r->at_bound[k]) {
            puts("  on its bound");
        } else if (r->unknown[k].is_weight && !is_held(e.value)) {
            puts("  beyond the range of numbers");
        } else if (!minimum) {
            puts("");
        } else if (!r->determined[k]) {
            puts("  not determined");
        } else if (e.by == CAGD_FIT_INTERVAL_NONE) {
            puts("  hardly determined");
        } else if (!isfinite(e.error)) {
            puts("  no standard error");
        } else {
            put_column(0, e.error, e.error, 18);
            if (e.by != CAGD_FIT_INTERVAL_NOT_SOUGHT)
                put_interval(e);
            puts(e.by == CAGD_FIT_INTERVAL_PROFILE ? " *" : "");
        }
    }
    for (int j = 0; j < r->invariants && r->unknowns > 0; j++) {
        char name[32];
        cagd_fit_estimate e = cagd_fit_invariant_estimate(f->result, j);
        snprintf(name, sizeof name, "I%d", j + 1);
        printf("  %-10s", name);
        put_column(0, e.value, e.error, 17);
        if (isfinite(e.error) && e.error > 0) {
            put_column(0, e.error, e.error, 18);
            if (e.by != CAGD_FIT_INTERVAL_NOT_SOUGHT)
                put_interval(e);
            fputs(e.by == CAGD_FIT_INTERVAL_PROFILE ? " *" : "", stdout);
        } else if (e.by == CAGD_FIT_INTERVAL_NONE && minimum)
            fputs("  hardly determined", stdout);
        else if (!is_held(e.value))
            fputs("  beyond the range of numbers", stdout);
        else if (minimum && !(e.error == 0))
            fputs("  not determined", stdout);
        puts("");
    }
}

static int are_one(const cagd_spline *c)
{
    int one = 1;
    for (int j = 0; j < c->count; j++)
        one = one && c->weights[j] == 1;
    return one;
}

/* What is given is not estimated. */
static void print_fixed(const struct fit *f)
{
    const cagd_spline *c = &f->result->curve;
    struct cagd_line l;
    int said = 0;
    if (is_ellipse(f))
        return;
    FILE *out = begin(&l);
    const int same_weights = !nothing_is_free(f) && !fits_weights(f) && are_one(c);
    for (int j = 0; j < own_points(f); j++) {
        int weight = same_weights, point = 0;
        for (int k = 0; k < f->result->unknowns; k++)
            if (f->result->unknown[k].index == j) {
                weight |= f->result->unknown[k].is_weight;
                point |= !f->result->unknown[k].is_weight;
            }
        if (!point) {
            fprintf(out, "%sP%d = (", said++ > 0 ? ", " : "", j);
            for (int x = 0; x < c->dim; x++) {
                fputs(x > 0 ? ", " : "", out);
                put_given(out, f->result->origin[x], c->points[j * c->dim + x]);
            }
            fputs(")", out);
        }
        if (!weight)
            fprintf(out, "%sw%d = %.10g", said++ > 0 ? ", " : "", j, c->weights[j]);
    }
    if (same_weights)
        fprintf(out, "%sall weights 1", said++ > 0 ? ", " : "");
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
            struct pair p = {j, i, cagd_fit_correlation(r, i, j)};
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
    struct cagd_line l;
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

/* The unknowns that a free direction moves most, and how. */
static void print_free_directions(const cagd_fit_result *r)
{
    enum { MOST = 6 };
    int free = r->rank + r->flat, flat = r->flat;
    if (flat <= 0) {
        say("Rank", "%d of %d: the points%s determine every unknown", r->rank, free,
            r->roughness > 0 ? " and the smoothing term" : "");
        return;
    }
    say("Rank", "%d of %d: the distances stay what they are, to first order, along %s", r->rank, free,
        flat == 1 ? "one direction, which moves" : "several directions, which move");
    for (int d = 0; d < flat; d++) {
        const double *v = r->free_directions + (size_t)d * (size_t)r->unknowns;
        double largest = 0;
        for (int k = 0; k < r->unknowns; k++)
            largest = fmax(largest, fabs(v[k]));
        struct cagd_line l;
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

static void print_distances(const struct fit *f)
{
    const cagd_fit_result *r = f->result;
    struct cagd_line l;
    FILE *out = begin(&l);
    fprintf(out, "root mean square %.4g, largest %.4g at point %d (line %d)", r->rms, r->largest, r->largest_at + 1,
            f->points.line[r->largest_at]);
    if (r->feet_at_ends > 0)
        fprintf(out, "; %d foot point%s at an end of the curve", r->feet_at_ends, plural(r->feet_at_ends));
    if (r->out_of_order > 0)
        fprintf(out, "; %d of the feet overtake%s the one before", r->out_of_order, r->out_of_order == 1 ? "s" : "");
    if (f->options.monotone && r->tied > 0)
        fprintf(out, "; %d point%s share%s the foot of the one before, which theirs would fall behind", r->tied,
                plural(r->tied), r->tied == 1 ? "s" : "");
    else if (f->options.monotone && r->out_of_order == 0)
        fprintf(out, "; every foot lies behind the one before by itself");
    end(&l, "Distances");
}

/* The measured ends follow their points, and of these alone a small distance says nothing. */
static void say_ends(FILE *out, const struct fit *f)
{
    const cagd_fit_result *r = f->result;
    int said = 0;
    if (r->end_is_judged[0] || r->end_is_judged[1])
        fprintf(out,
                "; the %s, which a measured end would follow, %s judged by the curve of the others, and left out where "
                "outside of %.2g standard deviations, its own and that of this curve, which goes on behind its end",
                !r->end_is_judged[1]   ? "first point"
                : !r->end_is_judged[0] ? "last point"
                                       : "first and the last point",
                r->end_is_judged[0] && r->end_is_judged[1] ? "are" : "is", r->end_limit);
    for (int end = 0; end < 2; end++) {
        const int i = r->end_points[end];
        if (i >= 0 && !r->outlier[i] && !r->end_is_judged[end])
            fprintf(out, "%s point %d (line %d)", said++ ? " and" : ";", i + 1, f->points.line[i]);
    }
    if (said > 0)
        fputs(said == 1 ? " measures an end of the curve, which follows it: whether it is an outlier the distance does "
                          "not tell, but a fit without it"
                        : " measure the ends of the curve, which follow them: whether one of them is an outlier the "
                          "distance does not tell, but a fit without it",
              out);
}

/* The points that a robust loss has found to be farther from the curve than chance puts them. */
static void print_outliers(const struct fit *f)
{
    enum { MOST = 12 };
    const cagd_fit_result *r = f->result;
    struct cagd_line l;
    if (f->options.loss == CAGD_FIT_SQUARES || !(r->deviation > 0))
        return;
    FILE *out = begin(&l);
    const char *unit = f->data.sigma != NULL ? " of the given ones" : "";
    if (r->outliers == 0)
        fprintf(out, "none: no point is farther than %.2g standard deviations of %.2g%s", r->outlier_limit,
                r->deviation, unit);
    for (int i = 0, said = 0; i < r->count && r->outliers > 0; i++)
        if (r->outlier[i] && said++ < MOST)
            fprintf(out, "%spoint %d (line %d)", said > 1 ? ", " : "", i + 1, f->points.line[i]);
    if (r->outliers > MOST)
        fprintf(out, ", and %d more", r->outliers - MOST);
    if (r->outliers > 0)
        fprintf(out, "; farther than %.2g standard deviations of %.2g%s; root mean square of the other distances %.4g",
                r->outlier_limit, r->deviation, unit, r->rms_of_others);
    fputs("; the standard deviation is estimated from the median of the distances", out);
    say_ends(out, f);
    end(&l, "Outliers");
}

/* Errors that standard errors do not know of: the measured coordinates are no finer than binary64 is so far from 0. */
static void print_spacing(const struct fit *f)
{
    const cagd_fit_result *r = f->result;
    double widest;
    int finest = cagd_fit_finest_unknown(r, &widest);
    if (finest < 0)
        return;
    char name[32];
    unknown_name(r, finest, name);
    say("Far from 0",
        "in binary64 the coordinates of the points are rounded to steps of %.2g, which is more than standard errors, "
        "%.2g of %s: "
        "what the roundings have in common is not in these; estimates are from an origin nearby, so that nothing more "
        "is lost",
        widest, cagd_fit_unknown_estimate(f->result, finest).error, name);
}

static const char *hardly_because(const struct fit *f)
{
    return f->options.weight_low > 0 || isfinite(f->options.weight_high)
               ? "the cost is far from quadratic over the interval that the standard error says, and weights are "
                 "bounded"
           : f->result->curve.count > f->result->curve.degree + 1
               ? "points of several segments can slide along the curve, so that the cost is far from quadratic over "
                 "the "
                 "interval that the standard error says; more points, or smaller errors, determine more"
               : "the cost is far from quadratic over the interval that the standard error says, and its profile does "
                 "not "
                 "come to an end, or there are too many unknowns to follow it; more points, or fewer unknowns (--free "
                 "inner,ends), determine more";
}

/* What is true of a minimum only. */
static void print_statistics(const struct fit *f)
{
    const char *of_what = is_ellipse(f) ? ", moved by what errors along the curve make of the estimates"
                                        : ", for weights and invariants of the logarithms";
    const cagd_fit_result *r = f->result;
    int known = r->scale_is_given;
    struct cagd_line l;
    FILE *out = begin(&l);
    if (f->options.loss == CAGD_FIT_SQUARES) {
        fprintf(out, "%.4g on %d degree%s of freedom", r->chi_squared, r->degrees_of_freedom,
                plural(r->degrees_of_freedom));
        if (isfinite(r->reduced_chi_squared))
            fprintf(out, "; reduced %.4g", r->reduced_chi_squared);
        if (isfinite(r->aic) && isfinite(r->bic))
            fprintf(out, "; AIC %.2f, BIC %.2f", r->aic, r->bic);
        end(&l, "Chi-squared");
    } else {
        fprintf(out, "%.6g, the sum over all points%s, which is twice what was minimised; %d degree%s of freedom",
                r->chi_squared, r->left_out[0] + r->left_out[1] > 0 ? " that are not left out" : "",
                r->degrees_of_freedom, plural(r->degrees_of_freedom));
        end(&l, "Loss");
    }
    if (nothing_is_free(f)) {
        if (!known && r->scale_squared > 0)
            say("Deviation", "standard deviation %.4g%s, estimated from the distances", sqrt(r->scale_squared),
                f->data.sigma != NULL ? " of the given ones" : "");
    } else if (known)
        say("Standard errors",
            "from the given standard deviations; 95 %% intervals: %.4g of them to either side (normal distribution%s)",
            r->quantile, of_what);
    else if (r->scale_squared > 0 && isfinite(r->scale_squared))
        say("Standard errors",
            "%s %.4g, estimated from the distances%s; 95 %% intervals: %.4g of them to either side (Student's t%s)",
            f->data.sigma != NULL ? "from the given standard deviations times" : "from a standard deviation of",
            sqrt(r->scale_squared), r->found.weights == 2 ? " that weights would leave" : "", r->quantile, of_what);
    else
        say("Standard errors", "none: the distances leave nothing to estimate a standard deviation from");
    int by[CAGD_FIT_INTERVAL_NOT_SOUGHT + 1] = {0};
    for (int q = 0; q < r->unknowns + r->invariants; q++)
        by[r->interval_by[q]]++;
    if (by[CAGD_FIT_INTERVAL_PROFILE] > 0)
        say("Intervals *",
            "by the profile of the cost, which is far from quadratic so far from its minimum: the standard error alone "
            "would not cover 95 %%");
    if (by[CAGD_FIT_INTERVAL_NONE] > 0)
        say("No intervals", "of what is hardly determined: %s", hardly_because(f));
    if (by[CAGD_FIT_INTERVAL_NOT_SOUGHT] > 0)
        say("No intervals", "%s",
            r->found.smoothed || f->options.smooth > 0
                ? "how far smoothing moves the curve by itself is in no standard error"
            : r->tied > 0 ? "which feet are shared was decided by these points, and standard errors for given ones "
                            "know nothing of "
                            "that"
            : r->found.weights == 1
                ? "that weights are fitted was decided by these points, and standard errors know nothing of that: they "
                  "are "
                  "too small; with --free weights,inner,ends intervals are sought (not tried)"
            : r->found.weights == 2 && !r->found.knots_chosen ? "weights would explain something, so that this is not "
                                                                "the curve of the points, whatever their errors are"
            : r->found.count_chosen
                ? "the knots were chosen by these points, and standard errors for given knots know nothing of that: "
                  "they are too small; with --knots intervals are sought (not tried)"
                : "the knots were placed by these points, and standard errors for given knots know nothing of that: "
                  "they are too small; with --knots intervals are sought (not tried)");
    if (!known && f->result->points_on_curve && r->scale_squared > 0)
        say("Rounding",
            "the distances are no larger than the roundings of binary64: the points lie on the curve, and %s "
            "the arithmetic, not of a measurement",
            nothing_is_free(f) ? "the deviation is that of" : "the standard errors are those of");
    print_spacing(f);
    if (f->result->ends_are_exact)
        say("Ends",
            "%s are taken as exact: their errors move the whole curve, weights with it, and "
            "are not in the standard errors; --ends measured, or ends in --free, takes them for measurements as the "
            "others are",
            f->options.unordered ? "two of the points, at the ends," : "the first and the last point");
    double cusp;
    if (!nothing_is_free(f) && cagd_fit_has_cusp(r, &cusp))
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
    print_circle(f);
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
    if (is_ellipse(f))
        print_ellipse(f);
    else
        print_estimates(f);
    print_fixed(f);
    puts("");
    print_distances(f);
    print_outliers(f);
    print_quality(f);
    if (cagd_fit_is_minimum(f->result))
        print_statistics(f);
    else
        say("No statistics",
            "%s; standard errors, 95 %% intervals, rank, correlations and the type of a conic belong to a minimum",
            nothing_is_free(f) ? "a foot was verified not to be the nearest point of the curve"
            : f->result->termination == CAGD_FIT_CONVERGED
                ? "the curve was verified to be no minimum"
                : "the minimiser did not come to its end, and the numbers are those of the last curve that it reached");
}
