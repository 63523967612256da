/* verdict.c -- what was chosen for the points and why, and whether the fit is good. */
#include "chapters/judge/memory_text.h"
#include "cli/fit/fit.h"
#include "cli/memory.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

int fits_weights(const struct fit *f)
{
    int weights = 0;
    for (int k = 0; k < f->result->unknowns; k++)
        weights |= f->result->unknown[k].is_weight;
    return weights || (f->result->unknowns == 0 && !is_ellipse(f) && f->options.free & CAGD_FIT_WEIGHTS);
}

/* ---- what was chosen ----------------------------------------------------------------------------------- */

static void print_closing(const struct fit *f)
{
    const cagd_fit_result *r = f->result;
    const int asked = f->choices.closed == 1;
    switch (r->found.closing) {
    case CAGD_FIT_REPEATED:
        say("Closed", "the last point repeats the first one and is left out; the curve is closed (--open: it is not)");
        break;
    case CAGD_FIT_AROUND:
        say("Closed", "%s; the curve is closed%s",
            f->options.unordered ? "the points lie around their centre"
                                 : "from the last point back to the first one it is no farther than between neighbours",
            asked ? "" : " (--open: it is not)");
        break;
    case CAGD_FIT_CORNER:
        say("Corner", "the points come back to where they began, with a corner there%s",
            r->period > 0 || r->found.ellipse.whole ? ", which the closed curve rounds off"
                                                    : ": the curve is open (--closed rounds the corner off)");
        break;
    case CAGD_FIT_OPEN:
        if (r->period > 0)
            say("Closed", "as asked, though the points do not come back to where they began");
        break;
    }
}

/* Whether of the curves that were tried and have a score the chosen one is good and others are not. */
static int some_are_not_good(const cagd_fit_found *found)
{
    int some = 0;
    for (int k = 1; k < found->candidates; k++)
        some |= isfinite(found->candidate[k].score) && found->candidate[k].problems != 0;
    return some && found->candidate[0].problems == 0;
}

/* The kinds of curve that were tried, the chosen one first. */
static void print_candidates(const struct fit *f)
{
    const cagd_fit_found *found = &f->result->found;
    char text[700];
    size_t at = 0;
    for (int k = 0; k < found->candidates && at < sizeof text; k++) {
        const cagd_fit_candidate *c = &found->candidate[k];
        at += (size_t)snprintf(text + at, sizeof text - at, "%s%s (%d unknowns, rms %.3g, %s",
                               k == 0   ? ""
                               : k == 1 ? "; tried and left: "
                                        : ", ",
                               c->name, c->unknowns, c->rms,
                               isfinite(c->score)                      ? "score "
                               : c->converged && f->choices.within > 0 ? "farther than the distance)"
                               : c->converged                          ? "with excursions that no points show)"
                                                                       : "no minimum)");
        if (isfinite(c->score) && at < sizeof text)
            at += (size_t)snprintf(text + at, sizeof text - at, "%.4g%s)", c->score,
                                   c->problems == CAGD_FIT_SIMPLE ? ", too simple beside another"
                                   : c->problems                  ? ", not good"
                                                                  : "");
    }
    if (found->candidates > 1)
        say("Chosen", "%s; %s (--degree or --control-points choose otherwise)", text,
            f->choices.degree && f->choices.within > 0
                ? "the fewest control points that keep every point within the distance are best"
            : some_are_not_good(found) ? "of those that are good, as under Fit, the smallest score, Schwarz's "
                                         "criterion for few points, is best"
                                       : "the smallest score, Schwarz's criterion for few points, is best");
}

static void print_weights_test(const struct fit *f)
{
    const cagd_fit_found *found = &f->result->found;
    const char *test = "an F test";
    if (found->weights_number == 0)
        return;
    if (found->weights == 1)
        say("Weights",
            "are fitted: by %s they explain something (F = %.3g with %d and %d degrees of freedom, probability %.2g by "
            "chance)",
            test, found->weights_ratio, found->weights_number, found->weights_freedom, found->weights_probability);
    else if (found->weights == 2)
        say("Weights",
            "are 1: by %s they would explain something (F = %.3g with %d and %d degrees of freedom), but the fit with "
            "weights between 1/16 and 16 "
            "comes to no better minimum",
            test, found->weights_ratio, found->weights_number, found->weights_freedom);
    else if (found->weights == 0)
        say("Weights",
            "are left out: by %s they explain nothing (F = %.3g with %d and %d degrees of freedom, probability %.2g by "
            "chance); --free weights,inner,ends "
            "fits them",
            test, found->weights_ratio, found->weights_number, found->weights_freedom, found->weights_probability);
}

static void print_smoothing(const struct fit *f)
{
    const cagd_fit_result *r = f->result;
    const double lambda = f->options.smooth > 0 ? f->options.smooth : r->found.smooth;
    if (!(lambda > 0))
        return;
    say("Smoothing",
        "%.3g/2 times the integral of the squared second derivative is added%s; the points determine %.1f of %d "
        "unknowns, which counts in degrees of "
        "freedom and criteria; standard errors are those of the smoothed curve, and how far smoothing moves it is not "
        "in them",
        lambda,
        r->found.smoothed == 2 ? ", its weight by cross-validation, since without it the fit did not converge or had "
                                 "excursions (fewer control points are another way, which was not tried)"
        : r->found.smoothed == 3 && r->found.within < 0
            ? ", without which no curve was found that comes as near to all points"
        : r->found.smoothed == 3
            ? ", its weight as large, to a factor of 10, as lets the curve keep within the distance, "
              "which no curve without it was found to do"
        : r->found.smoothed == 1 ? ", its weight by cross-validation"
                                 : "",
        r->effective, r->unknowns);
}

void print_choice(const struct fit *f)
{
    if (nothing_is_free(f))
        return;
    print_closing(f);
    print_candidates(f);
    if (f->result->found.within != 0)
        say("Tolerance", "%s: the largest distance is %.4g, %s %.4g, with %d control points",
            f->result->found.within > 0 ? "met" : "NOT met", f->result->largest,
            f->result->found.within > 0 ? "within" : "more than", f->choices.within, own_points(f));
    if (f->result->found.knots_chosen && !f->result->found.count_chosen)
        say("Knots",
            "placed by the points, where the distances were largest: over even knots the fit did not converge or "
            "had loops or excursions");
    print_weights_test(f);
    print_smoothing(f);
}

/* ---- an ellipse ------------------------------------------------------------------------------------------ */

/* A number with its error, or as it was reached where that is no minimum. */
static void print_reached(int minimum, const char *name, cagd_fit_number x)
{
    if (!minimum)
        x.error = NAN;
    print_number(name, x);
}

void print_ellipse(const struct fit *f)
{
    const cagd_fit_ellipse *e = &f->result->found.ellipse;
    static const char *const centre[] = {"centre x", "centre y", "centre z"};
    const int minimum = cagd_fit_is_minimum(f->result);
    if (minimum)
        printf("\n%20s%18s%18s     %s\n", "", "estimate", "standard error", "95 % interval");
    else
        printf("\n%20s%18s\n", "", "reached");
    for (int c = 0; c < f->data.dim; c++)
        print_reached(minimum, centre[c], e->circle ? e->circle_centre[c] : e->centre[c]);
    if (e->circle) {
        print_reached(minimum, "radius", e->radius);
    } else {
        print_reached(minimum, "semi-major axis", e->major);
        print_reached(minimum, "semi-minor axis", e->minor);
        if (f->data.dim == 2)
            print_reached(minimum, "angle in degrees", e->angle);
    }
    puts("");
    if (minimum && isnan(e->radius.low) && isfinite(e->radius.error))
        say("No intervals",
            "the distances are more than a twentieth of the smallest radius of curvature: errors along the arc smear "
            "its points, and standard errors are too small by as much as a tenth (more of the circle)");
    else if (minimum && !e->circle && f->data.dim == 2 && isnan(e->angle.low) && isfinite(e->angle.error))
        say("No interval", "of the angle, which is hardly determined");
    if (!e->whole)
        say("Arc", "of %.4g degrees", e->sweep);
    if (e->circle)
        say("Conic", "a circle, as far as can be told (F = %.3g with 2 and %d degrees of freedom against an ellipse)",
            fmax(0, e->ratio), e->freedom);
    else
        say("Conic",
            "an ellipse, no circle, at 95 %% (F = %.3g with 2 and %d degrees of freedom); the circle that comes "
            "closest has the radius %.6g and leaves "
            "rms %.3g",
            e->ratio, e->freedom, e->radius.value, e->circle_rms);
}

/* ---- whether it is good ------------------------------------------------------------------------------------ */

/* A sentence, and what cures that problem. */
static void add(const struct fit *f, int problem, char *sentence[], int *count, const char *format, ...)
    __attribute__((format(printf, 5, 6)));
static void add(const struct fit *f, int problem, char *sentence[], int *count, const char *format, ...)
{
    va_list list;
    size_t size;
    FILE *out = text_open(&sentence[*count], &size);
    va_start(list, format);
    vfprintf(out, format, list);
    va_end(list);
    put_cure(out, f, problem);
    text_close(out, &sentence[(*count)++]);
}

/* What is not as of noise.  To be freed. */
static char *structure_of(const cagd_fit_runs *runs, int with_mean)
{
    char *text;
    size_t size;
    FILE *out = text_open(&text, &size);
    const int counted = runs->probability < 0.01, local = runs->local_probability < 0.01;
    if (local && runs->local_probability < runs->probability) {
        fprintf(out, "from t = %.4g to %.4g the curve passes %d points by on one side", runs->from, runs->to,
                runs->points);
        if (with_mean)
            fprintf(out, ", their mean is %.2g of its standard deviations from 0", runs->excess);
        fprintf(out, ", by chance that is so somewhere with probability %.1g", runs->local_probability);
    } else if (counted)
        fprintf(out, "%d of %d neighbours lie on the same side, by chance that is so with probability %.1g", runs->same,
                runs->pairs, runs->probability);
    else if (runs->next_probability < 0.01)
        fprintf(out,
                "the distance of a point and that of the next have the correlation %.2f, by chance that is so with "
                "probability %.1g",
                runs->next_correlation, runs->next_probability);
    else
        fprintf(out,
                "the distances of points that are %d apart have the correlation %.2f, as of a wave, by chance that is "
                "so with probability %.1g",
                runs->lag, runs->lag_correlation, runs->lag_probability);
    text_close(out, &text);
    return text;
}

int problems_of(const struct fit *f, char *sentence[MOST_PROBLEMS])
{
    const cagd_fit_quality *q = &f->quality;
    int count = 0;
    if (nothing_is_free(f))
        return 0;
    if (q->problems & CAGD_FIT_EXCURSIONS && q->detour > 0)
        add(f, CAGD_FIT_EXCURSIONS, sentence, &count,
            "from t = %.4g to %.4g, between two neighbouring points, it makes a detour of length %.3g that no points "
            "show",
            q->detour_from, q->detour_to, q->detour);
    else if (q->problems & CAGD_FIT_EXCURSIONS)
        add(f, CAGD_FIT_EXCURSIONS, sentence, &count,
            "it is %.3g times as long as the polygon of the points in their order, with loops or excursions that no "
            "points show",
            q->length_ratio);
    if (q->problems & CAGD_FIT_LOOPS)
        add(f, CAGD_FIT_LOOPS, sentence, &count, "it crosses itself %d time%s, the polygon of the points %d",
            q->crossings, q->crossings == 1 ? "" : "s", q->crossings_of_points);
    if (q->problems & CAGD_FIT_GAPS)
        add(f, CAGD_FIT_GAPS, sentence, &count,
            "from t = %.4g to %.4g, %.2g of its length, it has no points and is only interpolation", q->gap_from,
            q->gap_to, q->gap);
    if (q->problems & CAGD_FIT_STRUCTURE) {
        char *text = structure_of(&q->runs, 1);
        add(f, CAGD_FIT_STRUCTURE, sentence, &count, "the distances are no noise: %s", text);
        free(text);
    }
    if (q->problems & CAGD_FIT_FAR)
        add(f, CAGD_FIT_FAR, sentence, &count, "control point P%d lies far outside of the points", q->far);
    if (q->problems & CAGD_FIT_BACKWARDS)
        add(f, CAGD_FIT_BACKWARDS, sentence, &count, "%d of the feet go%s back by more than six times the rms",
            q->backwards, q->backwards == 1 ? "es" : "");
    if (q->problems & CAGD_FIT_COARSE && f->result->roughness > 0)
        add(f, CAGD_FIT_COARSE, sentence, &count,
            "the distances are large against the points, and the smoothing term may be what holds the curve away from "
            "them");
    else if (q->problems & CAGD_FIT_COARSE)
        add(f, CAGD_FIT_COARSE, sentence, &count,
            "the distances are large, and too few points, without standard deviations, say whether they are noise or "
            "the curve is too simple");
    if (q->problems & CAGD_FIT_DEVIATIONS)
        add(f, CAGD_FIT_DEVIATIONS, sentence, &count,
            "the distances are %.3g times as large as the given standard deviations say, by chance that is so less "
            "than once in a thousand times: these "
            "are too small, and with them standard errors and intervals, or the curve is too simple",
            sqrt(f->result->reduced_chi_squared));
    return count;
}

/* What is said of distances with structure that is no problem, or NULL. */
static const char *beneath_what(const struct fit *f)
{
    switch (f->quality.beneath) {
    case CAGD_FIT_BENEATH_DIGITS:
        return "all of them are within half a cell of the last decimal place";
    case CAGD_FIT_BENEATH_DEVIATIONS:
        return "all of them are within the given standard deviations";
    case CAGD_FIT_BENEATH_SIZE:
        return "all of them are within a hundred-thousandth of the extent of the points";
    case CAGD_FIT_BENEATH_NOTHING:
        break;
    }
    return NULL;
}

/* Structure that is told and not held against the fit. */
static void print_beneath(const struct fit *f)
{
    const cagd_fit_runs *runs = &f->quality.runs;
    const char *what = beneath_what(f);
    if (what == NULL)
        return;
    char *text = structure_of(runs, 0);
    say("Structure", "%s; not held against the fit, since %s", text, what);
    free(text);
}

/* Deviations that are given too large; not held against the curve. */
static void print_too_large(const struct fit *f)
{
    if (f->quality.too_large)
        say("Deviations",
            "the distances are %.2g times as large as the given standard deviations say, by chance that is so less "
            "than once in a thousand times: "
            "these are too large, and with them standard errors and intervals",
            sqrt(f->result->reduced_chi_squared));
}

/* Points that squares follow, though their errors are of another kind. */
static void print_strays(const struct fit *f)
{
    const cagd_fit_quality *q = &f->quality;
    char *text;
    size_t size;
    if (q->strays == 0)
        return;
    FILE *out = text_open(&text, &size);
    for (int k = 0; k < q->strays && k < CAGD_FIT_STRAYS; k++)
        fprintf(out, "%spoint %d (line %d)", k > 0 ? ", " : "", q->stray[k] + 1, f->points.line[q->stray[k]]);
    if (q->strays > CAGD_FIT_STRAYS)
        fprintf(out, " and %d more", q->strays - CAGD_FIT_STRAYS);
    text_close(out, &text);
    say("Far off",
        "%s: farther than ten standard deviations, as the median of the distances has them; the curve follows %s", text,
        q->strays == 1 ? "it" : "them");
    free(text);
}

void print_quality(const struct fit *f)
{
    char *sentence[MOST_PROBLEMS], *text;
    size_t size;
    if (nothing_is_free(f))
        return;
    int count = problems_of(f, sentence);
    FILE *out = text_open(&text, &size);
    for (int k = 0; k < count; k++) {
        fprintf(out, "; %s", sentence[k]);
        free(sentence[k]);
    }
    text_close(out, &text);
    if (count == 0 && f->result->degrees_of_freedom <= 0)
        say("Fit", "nothing can be said of the distances: there are as many unknowns as equations, so the curve "
                   "follows whatever "
                   "errors the points have; no loops or excursions, no gaps");
    else if (count == 0)
        say("Fit", "nothing was found against it: no loops or excursions, no gaps%s",
            beneath_what(f) != NULL ? "; structure as below" : ", no structure in the distances");
    else
        say("Fit", "NOT good, whatever is said of the minimum%s", text);
    free(text);
    print_beneath(f);
    print_strays(f);
    print_too_large(f);
    print_cures(f);
}
