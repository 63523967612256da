#include "core/fit/detour.h"

#include "core/require.h"

#include <math.h>
#include <stdlib.h>

enum { FEW = 5, MANY = 40 }; /* sides of the polygon over a chord, at first and where that is too long */

static const double OF_RMS = 10;

/* The places of the feet on the curve in the order of their parameters. */
typedef struct path {
    const cagd_curve *curve;
    int count, dim, closed;
    double low, high; /* the domain */
    double *t, *at;   /* foot i: at[i*dim + c] */
} path;

static int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double inner(int dim, const double a[], const double b[])
{
    double sum = 0;
    for (int c = 0; c < dim; c++)
        sum += a[c] * b[c];
    return sum;
}

static void point_at(const path *p, double t, double x[])
{
    const double inside = p->closed && t > p->high ? t - (p->high - p->low) : t;
    if (cagd_curve_point(p->curve, inside, inside < p->high ? CAGD_RIGHT : CAGD_LEFT, x) != CAGD_OK)
        for (int c = 0; c < p->dim; c++)
            x[c] = NAN;
}

/* The chord from foot i to the next one, 0 beyond the ends of an open curve. */
static void chord(const path *p, int i, double u[])
{
    const int n = p->count, none = !p->closed && (i < 0 || i + 1 >= n);
    for (int c = 0; c < p->dim; c++)
        u[c] = none ? 0 : p->at[(i + 1 + n) % n * p->dim + c] - p->at[(i + n) % n * p->dim + c];
}

/* The angle between two chords; 0 where one of them is beyond an end. */
static double angle(int dim, const double a[], const double b[])
{
    const double product = sqrt(inner(dim, a, a) * inner(dim, b, b));
    return product > 0 ? acos(fmax(-1, fmin(1, inner(dim, a, b) / product))) : 0;
}

/* How long the curve is from foot i to the next one if it turns no more than the chords do; infinite where these turn by a half turn or more. */
static double longest(const path *p, int i)
{
    double u[3][3];
    for (int k = 0; k < 3; k++)
        chord(p, i - 1 + k, u[k]);
    const double half = (angle(p->dim, u[0], u[1]) + angle(p->dim, u[1], u[2])) / 2;
    return cos(half) > 0 && half < acos(-1) / 2 ? sqrt(inner(p->dim, u[1], u[1])) / cos(half) : INFINITY;
}

/* The length of the polygon with so many sides that is inscribed in the curve from foot i to the next one. */
static double length_over(const path *p, int i, int sides)
{
    const double from = p->t[i], to = i + 1 < p->count ? p->t[i + 1] : p->t[0] + p->high - p->low;
    double x[2][3], length = 0;
    point_at(p, from, x[0]);
    for (int s = 1; s <= sides; s++) {
        double step[3];
        point_at(p, s < sides ? from + (to - from) * s / sides : to, x[s % 2]);
        for (int c = 0; c < p->dim; c++)
            step[c] = x[s % 2][c] - x[1 - s % 2][c];
        length += sqrt(inner(p->dim, step, step));
    }
    return length;
}

static void find(const path *p, double rms, fit_detour *detour)
{
    for (int i = 0; i + !p->closed < p->count; i++) {
        const double most = longest(p, i);
        if (!isfinite(most) || !(length_over(p, i, FEW) > most))
            continue;
        const double length = length_over(p, i, MANY), excess = length - most;
        if (excess > detour->excess && length > CAGD_FIT_LONGEST_RATIO * most && excess > OF_RMS * rms)
            *detour = (fit_detour){length, excess, p->t[i], i + 1 < p->count ? p->t[i + 1] : p->t[0]};
    }
}

cagd_status fit_detour_of(const cagd_fit_result *r, int closed, fit_detour *detour)
{
    const int n = r->count, dim = r->curve.dim;
    cagd_spline near = r->curve; /* the same curve where binary64 is finest */
    cagd_status status = CAGD_OK;
    double *t = malloc(((size_t)n * (size_t)(dim + 1) + 1) * sizeof *t);
    *detour = (fit_detour){0, 0, 0, 0};
    REQUIRE(t != NULL, CAGD_NO_MEMORY);
    near.points = r->relative;
    cagd_curve *curve = cagd_curve_new(&near, &status, NULL);
    if (status == CAGD_OK) {
        path p = {curve, n, dim, closed, near.knots[near.degree], near.knots[near.count], t, t + n};
        for (int i = 0; i < n; i++)
            t[i] = r->feet[i];
        qsort(t, (size_t)n, sizeof *t, by_size);
        p.count = n > 0;
        for (int i = 1; i < n; i++) /* feet in one place are one */
            if (t[i] > t[p.count - 1])
                t[p.count++] = t[i];
        for (int i = 0; i < p.count; i++)
            point_at(&p, t[i], p.at + i * dim);
        find(&p, r->rms, detour);
    }
    cagd_curve_free(curve);
    free(t);
    return status == CAGD_NO_MEMORY ? status : CAGD_OK;
}
