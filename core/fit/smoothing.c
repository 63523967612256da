#include "core/fit/smoothing.h"

#include "core/kernels/kernels_d.h"
#include "core/number/limits.h"

#include <math.h>
#include <string.h>

int fit_smoothing_nodes(const fit_problem *p) { return p->smooth > 0 ? p->degree - 1 : 0; }

/* Node k of n of Gauss and Legendre in [0, 1], and its weight: the zeros of P_n by Newton's method, 2/((1-x^2) P_n'^2). */
static double gauss_node(int n, int k, double *weight)
{
    double x = cos(acos(-1) * (k + 0.75) / (n + 0.5)), slope = 1;
    for (int step = 0; step < 8; step++) {
        double before = 1, value = x;
        for (int j = 2; j <= n; j++) {
            double next = ((2 * j - 1) * x * value - (j - 1) * before) / j;
            before = value;
            value = next;
        }
        slope = n == 1 ? 1 : n * (x * value - before) / (x * x - 1);
        x -= value / slope;
    }
    *weight = 1 / ((1 - x * x) * slope * slope);
    return (1 + x) / 2;
}

void fit_smoothing_row(const fit_problem *p, const fit_curve *curve, int piece, int g, double row[])
{
    const int mu = curve->span[piece], d = p->degree;
    const double *u = curve->spline.knots, length = fit_curve_end(curve) - fit_curve_start(curve);
    double N[3 * (MAX_DEGREE + 1)], weight, at = gauss_node(d - 1, g, &weight);
    bspline_basis_derivatives_d(d, u, mu, u[mu] + at * (u[mu + 1] - u[mu]), 2, N);
    const double factor = length * length * sqrt(p->smooth * weight * (u[mu + 1] - u[mu]) / length);
    for (int m = 0; m <= d; m++)
        row[m] = factor * N[2 * (d + 1) + m];
}

double fit_smoothing_residual(const fit_problem *p, const fit_curve *curve, int piece, const double row[], int c)
{
    const double *P = curve->points + (curve->span[piece] - p->degree) * p->dim;
    double sum = 0;
    for (int m = 0; m <= p->degree; m++)
        sum += row[m] * P[m * p->dim + c];
    return sum;
}

double fit_smoothing_square(const fit_problem *p, const fit_curve *curve)
{
    const int nodes = fit_smoothing_nodes(p);
    double sum = 0, row[MAX_DEGREE + 1];
    for (int piece = 0; piece < curve->pieces && nodes > 0; piece++)
        for (int g = 0; g < nodes; g++) {
            fit_smoothing_row(p, curve, piece, g, row);
            for (int c = 0; c < p->dim; c++) {
                double r = fit_smoothing_residual(p, curve, piece, row, c);
                sum += r * r;
            }
        }
    return sum;
}

/* H = L L^T, L below the diagonal; 0 where H is not positive definite. */
static int factor(int n, double H[])
{
    for (int j = 0; j < n; j++)
        for (int i = j; i < n; i++) {
            double sum = H[i * n + j];
            for (int k = 0; k < j; k++)
                sum -= H[i * n + k] * H[j * n + k];
            if (i == j && !(sum > 0))
                return 0;
            H[i * n + j] = i == j ? sqrt(sum) : sum / H[j * n + j];
        }
    return 1;
}

/* x becomes H^-1 x; its numbers are `stride` apart. */
static void solve(int n, const double L[], double x[], int stride)
{
    for (int i = 0; i < n; i++) {
        for (int k = 0; k < i; k++)
            x[i * stride] -= L[i * n + k] * x[k * stride];
        x[i * stride] /= L[i * n + i];
    }
    for (int i = n - 1; i >= 0; i--) {
        for (int k = i + 1; k < n; k++)
            x[i * stride] -= L[k * n + i] * x[k * stride];
        x[i * stride] /= L[i * n + i];
    }
}

double fit_smoothing_sandwich(int n, double normal[], const double smooth[], double H[], int sandwich)
{
    double trace = 0;
    for (int m = 0; m < n * n; m++)
        H[m] = normal[m] + smooth[m];
    if (!factor(n, H))
        return NAN;
    for (int j = 0; j < n; j++) {
        solve(n, H, normal + j, n);
        trace += normal[j * n + j];
    }
    for (int i = 0; sandwich && i < n; i++)
        solve(n, H, normal + (size_t)i * (size_t)n, 1);
    return trace;
}
