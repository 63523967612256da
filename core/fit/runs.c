#include "core/fit/cagd_fit.h"
#include "core/fit/keyed.h"
#include "core/require.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

/* runs.c -- whether the residuals of neighbours are independent. */

/* P(X >= k), X binomial with n trials of probability 1/2, from its logarithms. */
static double upper_tail(int n, int k)
{
    double sum = 0;
    for (int j = k; j <= n; j++)
        sum += exp(lgamma(n + 1.0) - lgamma(j + 1.0) - lgamma(n - j + 1.0) - n * log(2));
    return fmin(1, sum);
}

/* ---- the distances of points in order -------------------------------------------------------------------- */

enum { SHORTEST = 4, PER_WINDOW = 4, LEAST = 16 };
static const double CLIPPED = 2.5; /* standard deviations: one point alone says nothing of its neighbours */

/* The distances of points in the order of their feet, in standard deviations and clipped, in the plane with their sign; and the sums of those
 * before, and of half the squares of the steps from one to the next. */
typedef struct sequence {
    int count, dim;
    double *foot, *value, *sum, *square; /* value[i*dim + c], sum[i*dim + c] */
} sequence;

/* The standard deviation of a coordinate in units of given ones, as the distances have it. */
static double scale_of(const cagd_fit_data *data, const cagd_fit_options *options, const cagd_fit_result *r)
{
    double sum = 0;
    if (options->loss != CAGD_FIT_SQUARES)
        return r->deviation;
    for (int i = 0; i < r->count; i++) {
        const double d = r->distances[i] / (data->sigma != NULL ? data->sigma[i] : 1);
        sum += d * d;
    }
    return r->degrees_of_freedom > 0 ? sqrt(sum / r->degrees_of_freedom) : 0;
}

/* Without outliers and the ends, whose distances are along the curve as well. */
static void fill(const cagd_fit_data *data, const cagd_fit_result *r, double scale, const keyed list[], sequence *s)
{
    const int dim = s->dim;
    for (int k = 0; k < r->count; k++) {
        const int i = list[k].index, j = s->count;
        const double unit = scale * (data->sigma != NULL ? data->sigma[i] : 1), size = fabs(r->distances[i]) / unit,
                     part = size > CLIPPED ? CLIPPED / size : 1;
        if (i == r->end_points[0] || i == r->end_points[1] || r->foot_at_end[i] ||
            (r->outlier != NULL && r->outlier[i]))
            continue;
        s->foot[j] = list[k].key;
        for (int c = 0; c < dim; c++)
            s->value[j * dim + c] = part / unit * (dim == 1 ? r->distances[i] : r->residuals[i * dim + c]);
        s->count++;
    }
}

/* The sums. */
static void add_up(sequence *s)
{
    const int dim = s->dim;
    for (int j = 0; j < s->count; j++) {
        double square = 0;
        for (int c = 0; c < dim; c++) {
            const int k = j * dim + c;
            const double step = j > 0 ? s->value[k] - s->value[k - dim] : 0;
            s->sum[k + dim] = s->sum[k] + s->value[k];
            square += step * step;
        }
        s->square[j + 1] = s->square[j] + square / 2;
    }
}

/* ---- a wave ----------------------------------------------------------------------------------------------- */

/* The sum of the products of the distances of points that are k apart, over its standard deviation.  Of independent errors that are as likely on one
 * side as on the other, however large they are here and there, the signs of the products are independent, and as often + as -; *correlation: the sum
 * over that of the squares. */
static double togetherness(const sequence *s, int k, double *correlation)
{
    double sum = 0, square = 0, all = 0;
    for (int j = 0; j < s->count; j++) {
        double product = 0;
        for (int c = 0; c < s->dim; c++) {
            const double here = s->value[j * s->dim + c];
            product += j + k < s->count ? here * s->value[(j + k) * s->dim + c] : 0;
            all += here * here;
        }
        sum += product, square += product * product;
    }
    *correlation = all > 0 ? sum / all : 0;
    return square > 0 ? sum / sqrt(square) : 0;
}

/* Whether the distances of neighbours are alike, and those of points that are k apart, k = 2, ..., a third of all: as of a wave of k points, which
 * goes to the other side so often that counting neighbours says nothing.  Asked for all k at once the probability is at most their sum. */
static void find_wave(const sequence *s, cagd_fit_runs *runs)
{
    double correlation, most = 0;
    runs->next_probability = erfc(togetherness(s, 1, &runs->next_correlation) / sqrt(2)) / 2;
    for (int k = 2; 3 * k <= s->count; k++) {
        const double z = togetherness(s, k, &correlation);
        if (z > most)
            most = z, runs->lag = k, runs->lag_correlation = correlation;
    }
    runs->lag_probability = fmin(1, (s->count / 3 - 1) * erfc(most / sqrt(2)) / 2);
}

/* ---- a part of the curve that passes its points by ------------------------------------------------------- */

/* The mean of m of them from i on over its standard deviation: in that of all, or where these and AROUND more on either side scatter more, by the
 * steps from one to the next, in theirs: errors along one axis are larger where the curve is across it. */
static double excess(const sequence *s, int i, int m)
{
    enum { AROUND = 32 };
    const int low = i > AROUND ? i - AROUND : 0, high = i + m + AROUND < s->count ? i + m + AROUND : s->count;
    double square = 0;
    for (int c = 0; c < s->dim; c++) {
        const double sum = s->sum[(i + m) * s->dim + c] - s->sum[i * s->dim + c];
        square += sum * sum;
    }
    const double scatter = (s->square[high] - s->square[low + 1]) / (high - low - 1) / (s->dim == 1 ? 1 : s->dim - 1);
    return sqrt(square / m / fmax(1, scatter));
}

/* The curvature at t, of the curve from the origin of the fit; infinite where it has none. */
static double curvature_at(const cagd_fit_result *r, double t)
{
    cagd_spline near = r->curve;
    double D[3 * 3], first = 0, second = 0, both = 0;
    near.points = r->relative;
    const cagd_side side = t < near.knots[near.count] ? CAGD_RIGHT : CAGD_LEFT;
    if (cagd_spline_derivatives(&near, t, side, 2, D) != CAGD_OK)
        return INFINITY;
    for (int c = 0; c < near.dim; c++) {
        first += D[near.dim + c] * D[near.dim + c];
        second += D[2 * near.dim + c] * D[2 * near.dim + c];
        both += D[near.dim + c] * D[2 * near.dim + c];
    }
    return first > 0 ? sqrt(fmax(0, first * second - both * both) / (first * first * first)) : INFINITY;
}

/* What is left of the excess of m points when the bend of the curve is taken off: of errors of one deviation s, alike in all directions, those
 * on the inner side spread over more of the curve, so that their mean at a foot is -s times (s times the curvature).  Nothing is left where the
 * curve turns on a radius of less than five deviations. */
static double without_bend(const cagd_fit_result *r, double from, double to, double deviation, int m, double z)
{
    const double most_bent = 0.2;
    double bend = 0;
    for (int k = 0; k <= 2; k++)
        bend = fmax(bend, deviation * curvature_at(r, from + (to - from) * k / 2));
    return bend < most_bent ? z - bend * sqrt(m) : 0;
}

/* The most exceptional of windows of 4, 8, 16, ... points, each a quarter of its length behind the one before; their number. */
static double find_part(const cagd_fit_result *r, double deviation, const sequence *s, cagd_fit_runs *runs)
{
    double windows = 0;
    for (int m = SHORTEST; 2 * m <= s->count; m *= 2)
        for (int i = 0; i + m <= s->count; i += m / PER_WINDOW, windows++) {
            double z = excess(s, i, m);
            if (z > runs->excess)
                z = without_bend(r, s->foot[i], s->foot[i + m - 1], deviation, m, z);
            if (z > runs->excess) {
                runs->excess = z, runs->points = m;
                runs->from = s->foot[i], runs->to = s->foot[i + m - 1];
            }
        }
    return windows;
}

/* Whether some window reaches that excess. */
static int reaches(const sequence *s, double most)
{
    for (int m = SHORTEST; 2 * m <= s->count; m *= 2)
        for (int i = 0; i + m <= s->count; i += m / PER_WINDOW)
            if (excess(s, i, m) >= most)
                return 1;
    return 0;
}

/* Another order of the distances, each as likely as every other; by splitmix64. */
static void shuffle(sequence *s, uint64_t *state)
{
    for (int j = s->count - 1; j > 0; j--) {
        uint64_t z = *state += 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        const int k = (int)((z ^ (z >> 31)) % (uint64_t)(j + 1));
        for (int c = 0; c < s->dim; c++) {
            const double value = s->value[j * s->dim + c];
            s->value[j * s->dim + c] = s->value[k * s->dim + c];
            s->value[k * s->dim + c] = value;
        }
    }
}

/* The probability that by chance some window has such an excess.  Of independent errors of one distribution every order is as likely: of DRAWN
 * orders the part in which some window reaches the excess; drawing ends with the ENOUGH-th of them, when the probability is not small.  The
 * values are changed.  Source: besag-clifford-1991. */
static double chance_of(sequence *s, double most)
{
    enum { DRAWN = 499, ENOUGH = 5 };
    uint64_t state = 1;
    int reached = 0;
    for (int drawn = 1; drawn <= DRAWN; drawn++) {
        shuffle(s, &state);
        add_up(s);
        reached += reaches(s, most);
        if (reached == ENOUGH)
            return (double)ENOUGH / drawn;
    }
    return (reached + 1.0) / (DRAWN + 1);
}

/* At most the sum of the probabilities of all windows, which is enough where it is small.  They have so much in common that it is too much
 * otherwise: of 100 to 400 points it is less than 0.01 once in 10^4 times. */
static void find_local(const cagd_fit_result *r, double deviation, sequence *s, cagd_fit_runs *runs)
{
    const double small = 0.001;
    add_up(s);
    const double windows = find_part(r, deviation, s, runs), z = runs->excess;
    runs->local_probability =
        windows == 0 ? NAN : fmin(1, windows * (s->dim == 1 ? erfc(z / sqrt(2)) : exp(-z * z / 2)));
    if (runs->local_probability > small)
        runs->local_probability = z > 0 ? fmin(runs->local_probability, chance_of(s, z)) : 1;
}

/* The sequence is made of the points in the order of their feet. */
static cagd_status look_at_parts(const cagd_fit_data *data, const cagd_fit_options *options, const cagd_fit_result *r,
                                 const keyed list[], cagd_fit_runs *runs)
{
    const int dim = r->curve.dim == 2 ? 1 : r->curve.dim;
    const double scale = scale_of(data, options, r);
    REQUIRE(r->count >= LEAST && scale > 0 && isfinite(scale), CAGD_OK);
    const size_t n = (size_t)r->count + 1;
    double *numbers = calloc(n * (size_t)(2 * dim + 2), sizeof *numbers);
    REQUIRE(numbers != NULL, CAGD_NO_MEMORY);
    sequence s = {0, dim, numbers, numbers + n, numbers + n * (size_t)(dim + 1), numbers + n * (size_t)(2 * dim + 1)};
    fill(data, r, scale, list, &s);
    if (s.count >= LEAST)
        find_wave(&s, runs);
    find_local(r, fmax(r->rms, scale * (data->sigma != NULL ? 0 : 1)), &s, runs);
    free(numbers);
    return CAGD_OK;
}

cagd_status cagd_fit_runs_of(const cagd_fit_data *data, const cagd_fit_options *options, const cagd_fit_result *r,
                             cagd_fit_runs *runs)
{
    const int n = r->count, dim = r->curve.dim;
    keyed *list = malloc(((size_t)n + 1) * sizeof *list);
    *runs =
        (cagd_fit_runs){.probability = NAN, .local_probability = NAN, .next_probability = NAN, .lag_probability = NAN};
    REQUIRE(list != NULL, CAGD_NO_MEMORY);
    for (int i = 0; i < n; i++)
        list[i] = (keyed){r->feet[i], i};
    qsort(list, (size_t)n, sizeof *list, fit_by_key);
    for (int i = 1; i < n; i++) {
        const int a = list[i - 1].index, b = list[i].index;
        double inner = r->distances[a] * r->distances[b];
        if (dim == 3) {
            inner = 0;
            for (int c = 0; c < dim; c++)
                inner += r->residuals[a * dim + c] * r->residuals[b * dim + c];
        }
        runs->pairs += inner != 0;
        runs->same += inner > 0;
    }
    if (runs->pairs > 0)
        runs->probability = upper_tail(runs->pairs, runs->same);
    const cagd_status status = look_at_parts(data, options, r, list, runs);
    free(list);
    return status;
}
