/* cagd_stationary_directions.c -- eigenvectors of the scaled Hessian, in binary64: approximate, and what is chosen is
 * then taken as exact, so that nothing here has to be right for the verdict to be. */
#include "exact/fit/directions.h"
#include "exact/fit/words.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The eigenvalues of the symmetric matrix A (n x n), which is destroyed, and the eigenvectors as columns of U:
 * cyclic Jacobi rotations until they change nothing. */
static void eigen(int n, double A[], double value[], double U[])
{
    for (int k = 0; k < n * n; k++)
        U[k] = k / n == k % n;
    for (int sweep = 0, changed = 1; changed && sweep < 64; sweep++) {
        changed = 0;
        for (int p = 0; p < n; p++)
            for (int q = p + 1; q < n; q++) {
                double off = A[p * n + q], gap = A[q * n + q] - A[p * n + p];
                if (fabs(gap) + 100 * fabs(off) == fabs(gap) && fabs(A[p * n + p]) + fabs(off) == fabs(A[p * n + p]))
                    continue;
                if (off == 0)
                    continue;
                changed = 1;
                double theta = gap / (2 * off), t = (theta < 0 ? -1 : 1) / (fabs(theta) + hypot(theta, 1));
                double c = 1 / hypot(t, 1), s = t * c;
                for (int k = 0; k < n; k++) {
                    double x = A[k * n + p], y = A[k * n + q];
                    A[k * n + p] = c * x - s * y;
                    A[k * n + q] = s * x + c * y;
                }
                for (int k = 0; k < n; k++) {
                    double x = A[p * n + k], y = A[q * n + k];
                    A[p * n + k] = c * x - s * y;
                    A[q * n + k] = s * x + c * y;
                    x = U[k * n + p], y = U[k * n + q];
                    U[k * n + p] = c * x - s * y;
                    U[k * n + q] = s * x + c * y;
                }
            }
    }
    for (int k = 0; k < n; k++)
        value[k] = A[k * n + k];
}

/* Columns of V: first orthonormal ones that span those of the given `rows` (rows x n, destroyed), then orthonormal
 * ones of the complement, from the unit vectors that are farthest from what is spanned already.  allowed[a] = 0:
 * unit vector a is not used.  Returns how many columns the complement has, which start at column *start. */
static int complement(int n, int rows, double row[], const int allowed[], double V[], int *start)
{
    int columns = 0, wanted = 0, spanned;
    for (int a = 0; a < n; a++)
        wanted += allowed[a];
    for (int pass = 0; pass < rows; pass++) {
        double *x = row + pass * n, norm = 0;
        for (int twice = 0; twice < 2; twice++)
            for (int k = 0; k < columns; k++) {
                double along = 0;
                for (int a = 0; a < n; a++)
                    along += x[a] * V[a * n + k];
                for (int a = 0; a < n; a++)
                    x[a] -= along * V[a * n + k];
            }
        for (int a = 0; a < n; a++)
            norm = hypot(norm, x[a]);
        for (int a = 0; a < n && norm > 0; a++)
            V[a * n + columns] = x[a] / norm;
        columns += norm > 0;
    }
    *start = spanned = columns;
    while (columns < wanted) {
        int best = -1;
        double rest = 0;
        for (int a = 0; a < n; a++) {
            double left = 1;
            for (int k = 0; k < columns; k++)
                left -= V[a * n + k] * V[a * n + k];
            if (allowed[a] && left > rest) {
                rest = left;
                best = a;
            }
        }
        if (best < 0)
            break;
        for (int a = 0; a < n; a++)
            V[a * n + columns] = a == best;
        for (int twice = 0; twice < 2; twice++)
            for (int k = 0; k < columns; k++) {
                double along = 0;
                for (int a = 0; a < n; a++)
                    along += V[a * n + columns] * V[a * n + k];
                for (int a = 0; a < n; a++)
                    V[a * n + columns] -= along * V[a * n + k];
            }
        double norm = 0;
        for (int a = 0; a < n; a++)
            norm = hypot(norm, V[a * n + columns]);
        for (int a = 0; a < n; a++)
            V[a * n + columns] /= norm;
        columns++;
    }
    return columns - spanned;
}

int cagd_stationary_directions(const struct box *b, double W[], double inverse[], int sign[])
{
    const cagd_stationary_problem *problem = b->problem;
    int n = b->n, start, k = -1, f = problem->free_count;
    size_t nn = (size_t)n * (size_t)n;
    double *H = malloc(nn * sizeof(double)), *V = malloc(nn * sizeof(double)), *U = malloc(nn * sizeof(double));
    double *scale = malloc((size_t)n * sizeof(double)), *value = malloc((size_t)n * sizeof(double));
    double *row = malloc(((size_t)f * (size_t)n + 1) * sizeof(double));
    int *allowed = malloc((size_t)n * sizeof(int));
    if (H == NULL || V == NULL || U == NULL || scale == NULL || value == NULL || row == NULL || allowed == NULL)
        goto done; /* without memory */
    for (int m = 0; m < n * n; m++)
        H[m] = (mpfr_get_d(b->hessian[m].lo, MPFR_RNDN) + mpfr_get_d(b->hessian[m].hi, MPFR_RNDN)) / 2;
    for (int a = 0; a < n; a++) { /* unit diagonal, by powers of 2 */
        double d = fabs(H[a * n + a]);
        allowed[a] = !is_held(problem, a);
        scale[a] = d > 0 ? ldexp(1, -(int)lround(log2(d) / 2)) : 1;
    }
    for (int m = 0; m < f * n; m++)
        row[m] = allowed[m % n] ? problem->free_directions[m] / scale[m % n] : 0;
    k = complement(n, f, row, allowed, V, &start);
    for (int i = 0; i < k; i++)
        for (int j = 0; j < k; j++) { /* U = V^T scale H scale V, k x k, here as a workspace */
            double sum = 0;
            for (int a = 0; a < n; a++)
                for (int c = 0; c < n; c++)
                    sum += V[a * n + start + i] * scale[a] * H[a * n + c] * scale[c] * V[c * n + start + j];
            U[i * k + j] = sum;
        }
    memcpy(H, U, (size_t)k * (size_t)k * sizeof(double));
    eigen(k, H, value, U);
    double largest = 0;
    for (int j = 0; j < k; j++)
        largest = fmax(largest, fabs(value[j]));
    for (int j = 0; j < k; j++) {
        double root = sqrt(fabs(value[j]));
        sign[j] = value[j] < 0 ? -1 : 1;
        if (!(root > 0)) {
            k = 0;
            break;
        }
        for (int a = 0; a < n; a++) {
            double sum = 0;
            for (int i = 0; i < k; i++)
                sum += V[a * n + start + i] * U[i * k + j];
            W[a * n + j] = scale[a] * sum / root;
            inverse[j * n + a] = sum * root / scale[a];
        }
    }
done:
    free(H), free(V), free(U), free(scale), free(value), free(row), free(allowed);
    return k;
}
