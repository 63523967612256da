/* numbers.c -- estimates, intervals and counts, by the formulas that cagd_fit.h states for its result. */
#include "cli/fit/fit.h"

#include <float.h>
#include <math.h>
#include <mpfr.h>
#include <stdlib.h>
#include <string.h>

int in_range(double positive) { return positive > 0 && isfinite(positive); }

int is_minimum(const struct fit *f)
{
    const cagd_stationary_verdict *v = &f->verdict;
    int refuted = f->checked && v->verified && !v->minimum && v->bounds != CAGD_STATIONARY_OPEN;
    refuted |= f->checked && f->nearest.refuted;
    return f->result->termination == CAGD_FIT_CONVERGED && !refuted;
}

int is_on_curve(const struct fit *f)
{
    const cagd_fit_result *r = f->result;
    const cagd_spline *curve = &r->curve;
    double size = 0, rounding = 0;
    for (int m = 0; m < curve->count * curve->dim; m++)
        size = fmax(size, fabs(r->relative[m]));
    for (int m = 0; m < f->data.count * f->data.dim; m++)
        size = fmax(size, fabs(f->data.points[m] - r->origin[m % f->data.dim]));
    for (int c = 0; c < f->data.dim; c++)
        rounding = hypot(rounding, spacing_of(f, c) / 2);
    return r->rms <= (2 * curve->degree + 2) * DBL_EPSILON * size + rounding;
}

double spacing_of(const struct fit *f, int c)
{
    double size = 0;
    for (int i = 0; i < f->data.count; i++)
        size = fmax(size, fabs(f->data.points[i * f->data.dim + c]));
    return nextafter(size, INFINITY) - size;
}

int is_finer_than_its_points(const struct fit *f, int k)
{
    struct estimate e = unknown_estimate(f, k);
    const cagd_fit_unknown *u = &f->result->unknown[k];
    return !u->is_weight && e.error > 0 && spacing_of(f, u->coordinate) > e.error;
}

double deviation_of(const struct fit *f, int i)
{
    return f->data.sigma != NULL ? f->data.sigma[i] : is_minimum(f) ? sqrt(f->result->scale_squared) : NAN;
}

struct estimate unknown_estimate(const struct fit *f, int k)
{
    const cagd_fit_result *r = f->result;
    const cagd_fit_unknown *u = &r->unknown[k];
    double value = u->is_weight ? r->value[k] : r->relative[u->index * r->curve.dim + u->coordinate], error = NAN;
    if (!r->at_bound[k] && r->determined[k] && is_minimum(f))
        error = sqrt(r->covariance[(size_t)k * (size_t)r->unknowns + (size_t)k]);
    struct estimate e = {value, error, value - r->quantile * error, value + r->quantile * error,
                         u->is_weight ? 0 : r->origin[u->coordinate]};
    if (u->is_weight) {
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
        return (struct estimate){value, NAN, NAN, NAN, 0};
    double factor = exp(r->quantile * error / value);
    return (struct estimate){value, error, value / factor, value * factor, 0};
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

/* origin + value, to so many decimals of the form e or f; the sum of two binary64 has less than 2200 bits. */
static void put_sum(FILE *out, char form, int decimals, double origin, double value)
{
    char format[] = "%.*RNf", text[100];
    mpfr_t sum;
    mpfr_init2(sum, 2200);
    mpfr_set_d(sum, origin, MPFR_RNDN);
    mpfr_add_d(sum, sum, value, MPFR_RNDN);
    format[5] = form;
    mpfr_snprintf(text, sizeof text, format, decimals, sum);
    fputs(text, out);
    mpfr_clear(sum);
}

void put_given(FILE *out, double origin, double x)
{
    char text[40];
    for (int digits = 10; digits <= 17; digits++) {
        snprintf(text, sizeof text, "%.*g", digits, x);
        if (origin == 0 || strtod(text, NULL) == x)
            break;
    }
    fputs(text, out);
}

void put_rounded(FILE *out, double origin, double value, double error)
{
    enum { LONGEST = 12, MOST_ZEROS = 4, EXACT = 17, MOST = 40 };
    double whole_value = origin + value;
    if (!isfinite(error) || !(error > 0)) {
        put_given(out, origin, whole_value);
        return;
    }
    int places = 1 - exponent_of(error, 1); /* of the second digit of the error, as it is rounded */
    double size = fmax(fabs(whole_value), fabs(error));
    int whole = size > 0 ? exponent_of(size, 1) : 0;
    if (-MOST_ZEROS <= places && -MOST_ZEROS <= whole && places + whole < EXACT && whole < LONGEST) {
        put_sum(out, 'f', places > 0 ? places : 0, origin, value);
        return;
    }
    int decimals = whole_value != 0 ? places + exponent_of(whole_value, 1) : 1, most = origin != 0 ? MOST : EXACT;
    put_sum(out, 'e', decimals < 1 ? 1 : decimals > most ? most : decimals, origin, value);
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
