#include "core/fit/curve.h"

#include "core/kernels_d.h"

#include <stdlib.h>
#include <string.h>

void fit_curve_free(fit_curve *c)
{
    if (c == NULL)
        return;
    free(c->knots);
    free(c->points);
    free(c->weights);
    free(c->span);
    free(c->bezier);
    free(c);
}

fit_curve *fit_curve_new(int degree, int count, int dim, const double knots[])
{
    fit_curve *c = calloc(1, sizeof *c);
    if (c == NULL)
        return NULL;
    size_t n = (size_t)count, p = (size_t)degree, d = (size_t)dim;
    c->degree = degree, c->count = count, c->dim = dim;
    c->knots = malloc((n + p + 1) * sizeof *c->knots);
    c->points = calloc(n * d, sizeof *c->points);
    c->weights = malloc(n * sizeof *c->weights);
    c->span = malloc(n * sizeof *c->span);
    c->bezier = malloc((n - p) * (p + 1) * (d + 1) * sizeof *c->bezier);
    if (!c->knots || !c->points || !c->weights || !c->span || !c->bezier) {
        fit_curve_free(c);
        return NULL;
    }
    memcpy(c->knots, knots, (n + p + 1) * sizeof *knots);
    for (int i = 0; i < count; i++)
        c->weights[i] = 1;
    for (int mu = degree; mu < count; mu++)
        if (knots[mu] < knots[mu + 1])
            c->span[c->pieces++] = mu;
    return c;
}

void fit_curve_copy(fit_curve *to, const fit_curve *from)
{
    memcpy(to->points, from->points, (size_t)(from->count * from->dim) * sizeof *to->points);
    memcpy(to->weights, from->weights, (size_t)from->count * sizeof *to->weights);
    fit_curve_update(to);
}

/* The polar form of the homogeneous curve, at the ends of each piece. */
void fit_curve_update(fit_curve *c)
{
    int p = c->degree, d = c->dim;
    for (int k = 0; k < c->pieces; k++) {
        double H[(MAX_DEGREE + 1) * MAX_DIM], x[MAX_DEGREE + 1], *b = c->bezier + k * (p + 1) * (d + 1);
        int mu = c->span[k];
        nurbs_homogenize_d(p, d, mu, c->points, c->weights, H);
        for (int i = 0; i <= p; i++) {
            for (int r = 0; r < p; r++)
                x[r] = c->knots[r < p - i ? mu : mu + 1];
            blossom_of_span_d(p, d + 1, c->knots, mu, H, x, b + i * (d + 1));
        }
    }
}

int fit_curve_piece(const fit_curve *c, double t)
{
    int low = 0, high = c->pieces;
    while (high - low > 1) {
        int middle = low + (high - low) / 2;
        if (t < c->knots[c->span[middle]])
            high = middle;
        else
            low = middle;
    }
    return low;
}

/* De Casteljau's triangle at s, broken off where the last three, two and one points give the derivatives:
 *     A'' = p (p-1) (b_2 - 2 b_1 + b_0),   A' = p (l_1 - l_0),   A = (1-s) l_0 + s l_1,   l_i = (1-s) b_i + s b_{i+1},
 * and C = A/w, C' = (A' - w' C)/w, C'' = (A'' - 2 w' C' - w'' C)/w.  dim is a constant where this is expanded. */
static inline void derivatives(const fit_curve *c, const int dim, double t, double D[])
{
    int p = c->degree, h = dim + 1, k = c->pieces == 1 ? 0 : fit_curve_piece(c, t), mu = c->span[k];
    double b[(MAX_DEGREE + 1) * MAX_DIM], length = c->knots[mu + 1] - c->knots[mu];
    double s = (t - c->knots[mu]) / length, r = (c->knots[mu + 1] - t) / length;
    double A[MAX_DIM], A1[MAX_DIM], A2[MAX_DIM], first = p / length, second = p * (p - 1) / (length * length);
    memcpy(b, c->bezier + k * (p + 1) * h, (size_t)((p + 1) * h) * sizeof *b);
    for (int n = p; n > 2; n--)
        for (int m = 0; m < n * h; m++)
            b[m] = r * b[m] + s * b[m + h];
    for (int j = 0; j < h; j++) {
        double l0 = r * b[j] + s * b[h + j], l1 = b[h + j];
        A2[j] = 0;
        if (p == 1) {
            A[j] = l0;
            A1[j] = first * (l1 - b[j]);
            continue;
        }
        l1 = r * b[h + j] + s * b[2 * h + j];
        A[j] = r * l0 + s * l1;
        A1[j] = first * (l1 - l0);
        A2[j] = second * (b[2 * h + j] - 2 * b[h + j] + b[j]);
    }
    double w = 1 / A[dim], w1 = A1[dim], w2 = A2[dim];
    for (int j = 0; j < dim; j++) {
        D[j] = A[j] * w;
        D[dim + j] = (A1[j] - w1 * D[j]) * w;
        D[2 * dim + j] = (A2[j] - 2 * w1 * D[dim + j] - w2 * D[j]) * w;
    }
}

void fit_curve_derivatives(const fit_curve *c, double t, double D[])
{
    if (c->dim == 2)
        derivatives(c, 2, t, D);
    else
        derivatives(c, 3, t, D);
}

void fit_curve_shares(const fit_curve *c, int piece, double t, double R[])
{
    int p = c->degree, mu = c->span[piece];
    double total = 0;
    bspline_basis_d(p, c->knots, mu, t, R);
    for (int m = 0; m <= p; m++) {
        R[m] *= c->weights[mu - p + m];
        total += R[m];
    }
    for (int m = 0; m <= p; m++)
        R[m] /= total;
}
