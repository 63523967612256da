#include "core/fit/model.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void fit_model_free(fit_model *m)
{
    fit_rank_free(&m->rank);
    free(m->L);
    memset(m, 0, sizeof *m);
}

static double product(int n, const double a[], const double b[])
{
    double sum = 0;
    for (int k = 0; k < n; k++)
        sum += a[k] * b[k];
    return sum;
}

/* M, below the diagonal of L; `half` has room for n^2 numbers. */
static void relative_curvature(const fit_rank *r, const double S[], double half[], double L[])
{
    int n = r->n;
    for (int j = 0; j < r->rank; j++)
        for (int k = 0; k < n; k++) {
            double sum = 0;
            for (int i = 0; i < n; i++)
                sum += r->V[i * n + j] / r->scale[i] * S[i * n + k];
            half[j * n + k] = sum / r->s[j];
        }
    for (int j = 0; j < r->rank; j++)
        for (int i = 0; i <= j; i++) {
            double sum = 0;
            for (int k = 0; k < n; k++)
                sum += half[j * n + k] * r->V[k * n + i] / r->scale[k];
            L[j * n + i] = sum / r->s[i];
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
    int n = p->unknowns;
    size_t nn = (size_t)n * (size_t)n;
    memset(m, 0, sizeof *m);
    m->L = malloc((2 * nn + 2 * (size_t)n) * sizeof *m->L);
    if (m->L == NULL ||
        !fit_rank_of(n, fit_problem_equations(p), fit_problem_roundings(p), f->triangle, n + 1, fixed, &m->rank)) {
        fit_model_free(m);
        return 0;
    }
    double *half = m->L + nn, z;
    m->y = half + nn, m->v = m->y + n;
    relative_curvature(&m->rank, f->curvature, half, m->L);
    for (int newton = root(n, m->rank.rank, m->L);; newton = 0) {
        for (int j = 0; j < m->rank.rank; j++) {
            for (int i = 0; !newton && i <= j; i++)
                m->L[j * n + i] = i == j;
            z = 0;
            for (int i = 0; i < n; i++)
                z += m->rank.U[i * n + j] * f->triangle[i * (n + 1) + n];
            m->y[j] = z;
        }
        m->left = forward(n, m->rank.rank, m->L, m->y);
        if (!newton || m->left * m->left <= 2 * f->cost)
            break;
    }
    return 1;
}

void fit_model_jacobian(const fit_model *m, double J[])
{
    const fit_rank *r = &m->rank;
    int n = r->n;
    memset(J, 0, (size_t)n * (size_t)n * sizeof *J);
    for (int j = 0; j < r->rank; j++)
        for (int i = 0; i <= j; i++)
            for (int k = 0; k < n; k++)
                J[i * n + k] += m->L[j * n + i] * r->s[j] * r->V[k * n + j] * r->scale[k];
}

void fit_model_step(const fit_model *m, double x[])
{
    const fit_rank *r = &m->rank;
    int n = r->n;
    for (int k = 0; k < n; k++)
        x[k] = 0;
    for (int j = r->rank - 1; j >= 0; j--) { /* L^T v = y, from the last one up */
        double v = m->y[j];
        for (int i = j + 1; i < r->rank; i++)
            v -= m->L[i * n + j] * m->v[i];
        m->v[j] = v /= m->L[j * n + j];
        for (int k = 0; k < n; k++)
            x[k] -= v / r->s[j] * r->V[k * n + j] / r->scale[k];
    }
}
