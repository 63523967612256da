#include "core/fit/rank.h"

#include "core/fit/ceres.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

void fit_rank_free(fit_rank *r)
{
    free(r->scale);
    memset(r, 0, sizeof *r);
}

double fit_rank_threshold(int n, int rows, int roundings) { return DBL_EPSILON / 2 * sqrt(n) * (rows + roundings); }

int fit_rank_inverse(int n, int rows, int roundings, const double R[], int stride, double W[])
{
    double norm = 0;
    memset(W, 0, (size_t)n * (size_t)n * sizeof *W);
    for (int i = n - 1; i >= 0; i--) {
        W[i * n + i] = 1;
        for (int j = i + 1; j < n; j++)
            for (int k = j; k < n; k++)
                W[i * n + k] -= R[i * stride + j] * W[j * n + k];
        for (int k = i; k < n; k++)
            W[i * n + k] /= R[i * stride + i];
    }
    for (int k = 0; k < n; k++) {
        double column = 0, row = 0;
        for (int i = 0; i <= k; i++)
            column += R[i * stride + k] * R[i * stride + k];
        for (int i = k; i < n; i++)
            row += W[k * n + i] * W[k * n + i];
        norm += column * row;
    }
    return fit_rank_threshold(n, rows, roundings) * sqrt(n * norm) < 1;
}

/* Householder's reflections make a triangle of A, n^2 numbers by rows. */
static void triangulate(int n, double A[])
{
    for (int k = 0; k < n; k++) {
        double square = 0;
        for (int i = k + 1; i < n; i++)
            square += A[i * n + k] * A[i * n + k];
        if (square == 0)
            continue;
        const double at = A[k * n + k], length = sqrt(at * at + square), head = at > 0 ? at + length : at - length;
        for (int j = k + 1; j < n; j++) {
            double share = head * A[k * n + j];
            for (int i = k + 1; i < n; i++)
                share += A[i * n + k] * A[i * n + j];
            share *= 2 / (head * head + square);
            A[k * n + j] -= share * head;
            for (int i = k + 1; i < n; i++)
                A[i * n + j] -= share * A[i * n + k];
        }
        A[k * n + k] = at > 0 ? -length : length;
    }
}

int fit_rank_regular(int n, int rows, int roundings, const double A[], int stride, double covariance[])
{
    const size_t nn = (size_t)n * (size_t)n;
    double *W = malloc(2 * nn * sizeof *W), *R = W + nn;
    if (W == NULL)
        return -1;
    for (int i = 0; i < n; i++)
        memcpy(R + i * n, A + i * stride, (size_t)n * sizeof *R);
    triangulate(n, R);
    const int regular = fit_rank_inverse(n, rows, roundings, R, n, W);
    for (int a = 0; a < n && regular; a++)
        for (int b = a; b < n; b++) {
            double sum = 0;
            for (int k = b; k < n; k++)
                sum += W[a * n + k] * W[b * n + k];
            covariance[a * n + b] = covariance[b * n + a] = sum;
        }
    free(W);
    return regular;
}

int fit_rank_of(int n, int rows, int roundings, const double R[], int stride, const int fixed[], fit_rank *r)
{
    size_t nn = (size_t)n * (size_t)n;
    r->n = n;
    r->scale = malloc((3 * nn + 2 * (size_t)n) * sizeof *r->scale);
    if (r->scale == NULL)
        return 0;
    r->s = r->scale + n, r->U = r->s + n, r->V = r->U + nn;
    double *A = r->V + nn;
    int held = 0;
    for (int k = 0; k < n; k++) {
        double square = 0;
        for (int i = 0; i < n; i++)
            square += R[i * stride + k] * R[i * stride + k];
        r->scale[k] = square > 0 ? sqrt(square) : 1;
        for (int i = 0; i < n; i++)
            A[i * n + k] = fixed[k] ? 0 : R[i * stride + k] / r->scale[k];
        held += fixed[k] != 0;
    }
    if (!fit_svd(n, A, r->U, r->s, r->V)) {
        fit_rank_free(r);
        return 0;
    }
    r->smallest = fit_rank_threshold(n, rows, roundings) * r->s[0];
    r->rank = 0;
    while (r->rank < n && r->s[r->rank] > r->smallest)
        r->rank++;
    r->flat = n - held - r->rank;
    return 1;
}

void fit_rank_report(const fit_rank *r, const int fixed[], double covariance[], double flat[], int determined[])
{
    int n = r->n, count = 0;
    for (int a = 0; a < n; a++)
        for (int b = 0; b < n; b++) {
            double sum = 0;
            for (int j = 0; j < r->rank; j++)
                sum += r->V[a * n + j] / r->s[j] * (r->V[b * n + j] / r->s[j]);
            covariance[a * n + b] = sum / r->scale[a] / r->scale[b];
        }
    /* The flat directions are known up to the smallest singular value that counts, against those that do not. */
    double uncertainty = r->rank > 0 ? r->smallest / r->s[r->rank - 1] : 0;
    for (int k = 0; k < n; k++)
        determined[k] = !fixed[k];
    for (int j = r->rank; j < n && count < r->flat; j++) {
        /* A fixed column, which is zero, has a direction of its own, along the unknown itself. */
        double *x = flat + count * n, outside = 0, length = 0;
        for (int k = 0; k < n; k++) {
            outside += fixed[k] ? r->V[k * n + j] * r->V[k * n + j] : 0;
            if (!fixed[k] && fabs(r->V[k * n + j]) > uncertainty)
                determined[k] = 0;
            x[k] = fixed[k] ? 0 : r->V[k * n + j] / r->scale[k];
        }
        if (outside > 0.5)
            continue;
        for (int twice = 0; twice < 2; twice++)
            for (int i = 0; i < count; i++) {
                double along = 0;
                for (int k = 0; k < n; k++)
                    along += x[k] * flat[i * n + k];
                for (int k = 0; k < n; k++)
                    x[k] -= along * flat[i * n + k];
            }
        for (int k = 0; k < n; k++)
            length += x[k] * x[k];
        for (int k = 0; k < n; k++)
            x[k] /= sqrt(length);
        count++;
    }
}
