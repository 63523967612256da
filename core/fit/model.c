#include "core/fit/model.h"

#include "core/fit/rank.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void fit_model_free(fit_model *m)
{
    free(m->W);
    memset(m, 0, sizeof *m);
}

static double product(int n, const double a[], const double b[])
{
    double sum = 0;
    for (int k = 0; k < n; k++)
        sum += a[k] * b[k];
    return sum;
}

/* W = D^-1 V s^-1, and U^T z, of the singular values that count; the rank, or -1 when there is no memory. */
static int decompose(const fit_problem *p, int n, const double R[], const int fixed[], double W[], double z[])
{
    fit_rank r;
    if (!fit_rank_of(n, fit_problem_equations(p), fit_problem_roundings(p), R, n + 1, fixed, &r))
        return -1;
    for (int j = 0; j < r.rank; j++) {
        z[j] = 0;
        for (int i = 0; i < n; i++) {
            W[i * n + j] = r.V[i * n + j] / r.s[j] / r.scale[i];
            z[j] += r.U[i * n + j] * R[i * (n + 1) + n];
        }
    }
    int rank = r.rank;
    fit_rank_free(&r);
    return rank;
}

/* M, below the diagonal of L; `half` has room for n^2 numbers.  Where T is R, W is a triangle, `upper`. */
static void relative_curvature(const fit_model *m, const double S[], int upper, double half[])
{
    const int n = m->n;
    memset(half, 0, (size_t)m->rank * (size_t)n * sizeof *half);
    memset(m->L, 0, (size_t)m->rank * (size_t)n * sizeof *m->L);
    for (int j = 0; j < m->rank; j++) {
        for (int i = 0; i < (upper ? j + 1 : n); i++)
            for (int k = 0; k < n; k++)
                half[j * n + k] += m->W[i * n + j] * S[i * n + k];
        for (int k = 0; k < (upper ? j + 1 : n); k++)
            for (int i = upper ? k : 0; i <= j; i++)
                m->L[j * n + i] += half[j * n + k] * m->W[k * n + i];
    }
}

/* Cholesky: 1 + M = L L^T, in place; 0 if there is no such L. */
static int root(int n, int rank, double L[])
{
    for (int j = 0; j < rank; j++) {
        for (int i = 0; i < j; i++)
            L[j * n + i] = (L[j * n + i] - product(i, L + j * n, L + i * n)) / L[i * n + i];
        double pivot = 1 + L[j * n + j] - product(j, L + j * n, L + j * n);
        if (!(pivot > 0 && isfinite(pivot)))
            return 0;
        L[j * n + j] = sqrt(pivot);
    }
    return 1;
}

/* y = L^-1 z, in place; returns its length. */
static double forward(int n, int rank, const double L[], double y[])
{
    for (int j = 0; j < rank; j++)
        y[j] = (y[j] - product(j, L + j * n, y)) / L[j * n + j];
    return sqrt(product(rank, y, y));
}

int fit_model_of(const fit_objective *f, const int fixed[], fit_model *m)
{
    const fit_problem *p = f->problem;
    int n = p->unknowns, held = 0;
    size_t nn = (size_t)n * (size_t)n;
    *m = (fit_model){.n = n, .W = malloc((3 * nn + 3 * (size_t)n) * sizeof *m->W)};
    if (m->W == NULL)
        return 0;
    m->L = m->W + nn, m->z = m->L + 2 * nn, m->y = m->z + n, m->v = m->y + n;
    for (int k = 0; k < n; k++) {
        held = held || fixed[k];
        m->z[k] = f->triangle[k * (n + 1) + n];
    }
    const int regular =
        held == 0 && fit_rank_inverse(n, fit_problem_equations(p), fit_problem_roundings(p), f->triangle, n + 1, m->W);
    m->rank = regular ? n : decompose(p, n, f->triangle, fixed, m->W, m->z);
    if (m->rank < 0) {
        fit_model_free(m);
        return 0;
    }
    relative_curvature(m, f->curvature, regular, m->L + nn);
    for (int newton = root(n, m->rank, m->L);; newton = 0) {
        for (int j = 0; j < m->rank; j++) {
            for (int i = 0; !newton && i <= j; i++)
                m->L[j * n + i] = i == j;
            m->y[j] = m->z[j];
        }
        m->decrement = forward(n, m->rank, m->L, m->y);
        if (!newton || m->decrement * m->decrement <= 2 * f->cost)
            break;
    }
    return 1;
}

void fit_model_step(const fit_model *m, double x[])
{
    int n = m->n;
    for (int k = 0; k < n; k++)
        x[k] = 0;
    for (int j = m->rank - 1; j >= 0; j--) { /* L^T v = y, from the last one up */
        double v = m->y[j];
        for (int i = j + 1; i < m->rank; i++)
            v -= m->L[i * n + j] * m->v[i];
        m->v[j] = v /= m->L[j * n + j];
        for (int k = 0; k < n; k++)
            x[k] -= v * m->W[k * n + j];
    }
}
