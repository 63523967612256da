#include "core/fit/curve.h"

#include "core/spline.h"

#include <stdlib.h>
#include <string.h>

void fit_curve_free(fit_curve *c)
{
    if (c == NULL)
        return;
    free((void *)c->spline.knots);
    free(c->points);
    free(c->weights);
    free(c->span);
    free(c->inverse);
    free(c->begin);
    free(c->bezier);
    free(c->choose);
    free(c);
}

fit_curve *fit_curve_new(int degree, int count, int period, int dim, const double knots[])
{
    fit_curve *c = calloc(1, sizeof *c);
    if (c == NULL)
        return NULL;
    size_t n = (size_t)count, p = (size_t)degree, d = (size_t)dim;
    double *u = malloc((n + p + 1) * sizeof *u);
    c->points = calloc(n * d, sizeof *c->points);
    c->weights = malloc(n * sizeof *c->weights);
    c->span = malloc(n * sizeof *c->span);
    c->choose = malloc(p * sizeof *c->choose);
    c->inverse = malloc(n * sizeof *c->inverse);
    c->begin = malloc(n * sizeof *c->begin);
    c->bezier = malloc((n - p) * (p + 1) * (d + 1) * sizeof *c->bezier);
    c->spline = (cagd_spline){degree, count, dim, u, c->points, c->weights};
    c->period = period;
    if (!u || !c->points || !c->weights || !c->span || !c->inverse || !c->begin || !c->bezier || !c->choose) {
        fit_curve_free(c);
        return NULL;
    }
    memcpy(u, knots, (n + p + 1) * sizeof *knots);
    for (int i = 0; i < count; i++)
        c->weights[i] = 1;
    for (int i = 0; i < degree; i++)
        c->choose[i] = (double)binomial(degree - 1, i);
    for (int mu = degree; mu < count; mu++)
        if (knots[mu] < knots[mu + 1]) {
            c->begin[c->pieces] = knots[mu];
            c->inverse[c->pieces] = 1 / (knots[mu + 1] - knots[mu]);
            c->span[c->pieces++] = mu;
        }
    return c;
}

void fit_curve_copy(fit_curve *to, const fit_curve *from)
{
    memcpy(to->points, from->points, (size_t)(from->spline.count * from->spline.dim) * sizeof *to->points);
    memcpy(to->weights, from->weights, (size_t)from->spline.count * sizeof *to->weights);
    fit_curve_update(to);
}

void fit_curve_update(fit_curve *c)
{
    const int p = c->spline.degree, dimension = c->spline.dim, size = (p + 1) * (dimension + 1);
    for (int i = c->period; c->period > 0 && i < c->spline.count; i++) {
        memcpy(c->points + i * dimension, c->points + (i - c->period) * dimension,
               (size_t)dimension * sizeof *c->points);
        c->weights[i] = c->weights[i - c->period];
    }
    for (int k = 0; k < c->pieces; k++) {
        double H[(MAX_DEGREE + 1) * MAX_DIM];
        int mu = c->span[k], dim = spline_points_of_span_d(&c->spline, mu, H);
        bspline_to_bezier_d(span_alone_d(p, dim, c->spline.knots, mu, H), c->bezier + k * size);
    }
}

int fit_curve_piece(const fit_curve *c, double t)
{
    int low = 0;
    for (int left = c->pieces; left > 1;) { /* one of the pieces low, ..., low + left - 1; no branch to guess */
        const int half = left / 2;
        low += t >= c->begin[low + half] ? half : 0;
        left -= half;
    }
    return low;
}

/* Bernstein's polynomials of degree p-1 give those of degree p, B_m = r b_m + s b_{m-1}, and B_m' = p (b_{m-1} -
 * b_m)/length. */
static inline void bernstein(const fit_curve *c, double t, double N[], double N1[])
{
    const int p = c->spline.degree, mu = c->span[0];
    const double s = (t - c->spline.knots[mu]) * c->inverse[0], r = (c->spline.knots[mu + 1] - t) * c->inverse[0];
    const double factor = p * c->inverse[0];
    double b[MAX_DEGREE], power = 1, before = 0;
    for (int m = 0; m < p; m++, power *= s)
        b[m] = c->choose[m] * power;
    power = 1;
    for (int m = p - 1; m >= 0; m--, power *= r)
        b[m] *= power;
    for (int m = 0; m < p; m++) {
        N[m] = r * b[m] + s * before;
        N1[m] = factor * (before - b[m]);
        before = b[m];
    }
    N[p] = s * before;
    N1[p] = factor * before;
}

void fit_curve_shares(const fit_curve *c, int piece, double t, double R[], double R1[])
{
    const int p = c->spline.degree, mu = c->span[piece];
    const double *w = c->weights + mu - p;
    double N[2 * (MAX_DEGREE + 1)], *N1 = N + p + 1, total = 0, slope = 0;
    if (c->spline.count == p + 1)
        bernstein(c, t, N, N1);
    else
        bspline_basis_derivatives_d(p, c->spline.knots, mu, t, 1, N);
    for (int m = 0; m <= p; m++) {
        R[m] = N[m] * w[m];
        R1[m] = N1[m] * w[m];
        total += R[m];
        slope += R1[m];
    }
    total = 1 / total;
    for (int m = 0; m <= p; m++) {
        R[m] *= total;
        R1[m] = (R1[m] - R[m] * slope) * total;
    }
}
