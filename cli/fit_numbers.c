/* fit_numbers.c -- estimates, intervals and counts, by the formulas that cagd_fit.h states for its result. */
#include "cli/fit.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

int in_range(double positive) { return positive > 0 && isfinite(positive); }

int is_minimum(const struct fit *f)
{
    const stationary_verdict *v = &f->verdict;
    int refuted = f->checked && v->verified && !v->minimum && v->bounds != STATIONARY_OPEN;
    refuted |= f->checked && f->nearest.refuted;
    return f->result->termination == CAGD_FIT_CONVERGED && !refuted;
}

int is_on_curve(const struct fit *f)
{
    const cagd_spline *c = &f->result->curve;
    double size = 0;
    for (int m = 0; m < c->count * c->dim; m++)
        size = fmax(size, fabs(c->points[m]));
    for (int m = 0; m < f->data.count * f->data.dim; m++)
        size = fmax(size, fabs(f->data.points[m]));
    return f->result->rms <= (2 * c->degree + 2) * DBL_EPSILON * size;
}

double deviation_of(const struct fit *f, int i)
{
    return f->data.sigma != NULL ? f->data.sigma[i] : is_minimum(f) ? sqrt(f->result->scale_squared) : NAN;
}

struct estimate unknown_estimate(const struct fit *f, int k)
{
    const cagd_fit_result *r = f->result;
    double value = r->value[k], error = NAN;
    if (!r->at_bound[k] && r->determined[k] && is_minimum(f))
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
struct estimate invariant_estimate(const struct fit *f, int j)
{
    const cagd_fit_result *r = f->result;
    double value = r->invariant[j],
           error = is_minimum(f) && isfinite(r->invariant_error[j]) ? r->invariant_error[j] : NAN;
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
        snprintf(name, 32, "P%d %c", u->index, "xyz"[u->coordinate]);
}

double correlation(const cagd_fit_result *r, int i, int j)
{
    size_t n = (size_t)r->unknowns, a = (size_t)i, b = (size_t)j;
    return r->covariance[a * n + b] / sqrt(r->covariance[a * n + a] * r->covariance[b * n + b]);
}

int free_unknowns(const cagd_fit_result *r)
{
    int count = 0;
    for (int k = 0; k < r->unknowns; k++)
        count += !r->at_bound[k];
    return count;
}

int ends_taken_as_exact(const struct fit *f)
{
    return f->options.initial == NULL && !(f->options.free & CAGD_FIT_END_POINTS) &&
           (f->data.sigma != NULL || f->result->scale_squared > 0);
}

/* The exponent of x as %.*e with so many decimals writes it. */
static int exponent_of(double x, int decimals)
{
    char digits[48];
    snprintf(digits, sizeof digits, "%.*e", decimals, x);
    return atoi(strchr(digits, 'e') + 1);
}

void put_rounded(FILE *out, double value, double error)
{
    enum { LONGEST = 12, MOST_ZEROS = 4, EXACT = 17 };
    if (!isfinite(error) || !(error > 0)) {
        fprintf(out, "%.10g", value);
        return;
    }
    int places = 1 - exponent_of(error, 1); /* of the second digit of the error, as it is rounded */
    double size = fmax(fabs(value), fabs(error));
    int whole = size > 0 ? exponent_of(size, 1) : 0;
    if (-MOST_ZEROS <= places && -MOST_ZEROS <= whole && places + whole < EXACT && whole < LONGEST) {
        fprintf(out, "%.*f", places > 0 ? places : 0, value);
        return;
    }
    int decimals = value != 0 ? places + exponent_of(value, 1) : 1;
    fprintf(out, "%.*e", decimals < 1 ? 1 : decimals > EXACT ? EXACT : decimals, value);
}

/* How many bytes the character of UTF-8 that begins at s has; 0 where none does. */
static size_t character(const char *s)
{
    for (size_t length = 1; length <= 4 && s[length - 1] != '\0'; length++) {
        json_t *one = json_stringn(s, length);
        json_decref(one);
        if (one != NULL)
            return length;
    }
    return 0;
}

json_t *path_json(const char *path)
{
    char *text;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    for (size_t length; *path != '\0'; path += length > 0 ? length : 1) {
        length = character(path);
        fprintf(out, "%.*s", length > 0 ? (int)length : 3, length > 0 ? path : "\xEF\xBF\xBD");
    }
    fclose(out);
    json_t *json = json_string(text);
    free(text);
    return json;
}
