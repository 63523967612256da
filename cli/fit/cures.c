/* cures.c -- what was tried where a fit is not good, and what came of it. */
#include "chapters/judge/memory_text.h"
#include "cli/fit/fit.h"

#include <stdlib.h>

/* What quality says, shortly, from its lowest bit on. */
const char *const problem_name[MOST_PROBLEMS] = {"excursions",
                                                 "loops",
                                                 "gaps",
                                                 "structure in the distances",
                                                 "a control point far outside",
                                                 "feet that go back",
                                                 "large distances",
                                                 "a curve that is too simple",
                                                 "distances too large for the given deviations"};

/* Whether it has to be said which degree is meant: without one, other options ask for another. */
static int needs_degree(const cagd_fit_trial *t) { return !t->choices.form && !t->choices.degree; }

static void put_count(FILE *out, const cagd_fit_trial *t)
{
    if (t->choices.count)
        fputs("--control-points auto", out);
    else
        fprintf(out, "--control-points %d", t->options.count);
}

/* The options that ask for a trial when they are put behind those that the fit was asked with. */
static void put_options(FILE *out, const cagd_fit_trial *t)
{
    const int degree = t->options.degree;
    switch (t->cure) {
    case CAGD_FIT_CURE_ITERATIONS:
        fprintf(out, "--max-iterations %d", t->options.max_iterations);
        break;
    case CAGD_FIT_CURE_STARTS:
        fprintf(out, "--starts %d", t->options.starts);
        break;
    case CAGD_FIT_CURE_INNER:
        fprintf(out, "--free %s", t->options.free & CAGD_FIT_END_POINTS ? "inner,ends" : "inner");
        break;
    case CAGD_FIT_CURE_BOUNDS:
        fprintf(out, "--weights-between %g:%g", t->options.weight_low, t->options.weight_high);
        break;
    case CAGD_FIT_CURE_HUBER:
        fputs("--loss huber", out);
        break;
    case CAGD_FIT_CURE_HUBER_AUTO:
        fprintf(out, "--loss huber --degree %d ", degree);
        put_count(out, t);
        break;
    case CAGD_FIT_CURE_UNORDERED:
        fputs("--unordered", out);
        break;
    case CAGD_FIT_CURE_MONOTONE:
        if (needs_degree(t) && t->options.initial == NULL)
            fprintf(out, "--degree %d ", degree);
        fputs("--monotone", out);
        break;
    case CAGD_FIT_CURE_SMOOTH:
    case CAGD_FIT_CURE_LIGHTER:
        if (needs_degree(t))
            fprintf(out, "--degree %d ", degree);
        if (t->cure == CAGD_FIT_CURE_SMOOTH)
            fputs("--smooth auto", out);
        else
            fprintf(out, "--smooth %.15g", t->options.smooth);
        break;
    case CAGD_FIT_CURE_COUNT:
    case CAGD_FIT_CURE_AUTO:
        fprintf(out, "--degree %d ", degree);
        put_count(out, t);
        break;
    case CAGD_FIT_CURE_DEGREE:
        fprintf(out, "--degree %d", degree);
        break;
    case CAGD_FIT_CURE_DEGREES:
        fputs("--degree auto", out);
        break;
    }
}

void put_cure(FILE *out, const struct fit *f, int problem)
{
    const cagd_fit_cures *c = &f->cures;
    int found = c->best;
    for (int k = 0; k < c->count && found < 0; k++)
        if (c->trial[k].minimum && !(c->trial[k].problems & problem) && !(c->trial[k].problems & ~f->quality.problems))
            found = k;
    if (found < 0)
        return;
    fputs(" (not so with ", out);
    put_options(out, &c->trial[found]);
    fputs(")", out);
}

static void put_outcome(FILE *out, const struct fit *f, const cagd_fit_trial *t)
{
    int said = 0;
    if (!t->minimum) {
        fputs("no minimum", out);
        return;
    }
    if (t->problems == 0)
        fputs("nothing is found against that fit", out);
    for (int k = 0; k < MOST_PROBLEMS; k++)
        if (t->problems & 1 << k)
            fprintf(out, "%s%s%s", said++ > 0 ? ", " : "", f->quality.problems & 1 << k ? "still " : "",
                    problem_name[k]);
    fprintf(out, ", rms %.3g%s", t->rms, t->options.loss == CAGD_FIT_SQUARES ? "" : " without outliers");
}

void print_cures(const struct fit *f)
{
    const cagd_fit_cures *c = &f->cures;
    char *text;
    size_t size;
    if (c->too_many)
        say("Tried", "nothing else, which takes long with more than %d points or %d control points",
            CAGD_FIT_MOST_TRIED, CAGD_FIT_MOST_TRIED_CONTROL_POINTS);
    if (c->count == 0)
        return;
    FILE *out = text_open(&text, &size);
    for (int k = 0; k < c->count; k++) {
        fputs(k > 0 ? "; " : "", out);
        put_options(out, &c->trial[k]);
        fputs(": ", out);
        put_outcome(out, f, &c->trial[k]);
    }
    if (c->best < 0)
        fputs("; none of these helps", out);
    if (f->checked)
        fputs("; not verified in intervals", out);
    text_close(out, &text);
    say("Tried", "%s", text);
    free(text);
}

json_t *cures_json(const struct fit *f)
{
    json_t *list = json_array();
    for (int k = 0; k < f->cures.count; k++) {
        const cagd_fit_trial *t = &f->cures.trial[k];
        json_t *problems = json_array();
        char *text;
        size_t size;
        FILE *out = text_open(&text, &size);
        put_options(out, t);
        text_close(out, &text);
        for (int j = 0; j < MOST_PROBLEMS && t->minimum; j++)
            if (t->problems & 1 << j)
                json_array_append_new(problems, json_string(problem_name[j]));
        json_array_append_new(list, json_pack("{s:s, s:b, s:o, s:o}", "options", text, "converged", t->minimum,
                                              "problems", problems, "rms", json_real(t->rms)));
        free(text);
    }
    return list;
}
