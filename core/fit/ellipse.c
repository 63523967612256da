#include "core/fit/ellipse.h"

#include "core/fit/ceres.h"
#include "core/fit/reduction.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 9, STEPS = 200, SAMPLES = 32 };

static const double PI = 3.14159265358979323846;

static double inner(int dim, const double a[], const double b[])
{
    return a[0] * b[0] + a[1] * b[1] + (dim == 3 ? a[2] * b[2] : 0);
}

/* E, E' and E'' at phi. */
static void ellipse_at(int dim, const double x[], double phi, double E[3][3])
{
    const double u = cos(phi), v = sin(phi), *a = x + dim, *b = a + dim;
    for (int c = 0; c < dim; c++) {
        E[0][c] = x[c] + u * a[c] + v * b[c];
        E[1][c] = v * -a[c] + u * b[c];
        E[2][c] = x[c] - E[0][c];
    }
}

/* The points that the search for a foot begins with. */
static void sample(int dim, const double x[], double at[SAMPLES][3])
{
    double E[3][3];
    for (int k = 0; k < SAMPLES; k++) {
        ellipse_at(dim, x, 2 * PI * k / SAMPLES, E);
        memcpy(at[k], E[0], sizeof E[0]);
    }
}

static double distance_squared(int dim, const double a[], const double b[])
{
    double sum = 0;
    for (int c = 0; c < dim; c++)
        sum += (a[c] - b[c]) * (a[c] - b[c]);
    return sum;
}

/* The foot of q: Newton's method for (E - q) E' = 0 from the nearest sample, between the samples beside it. */
static double foot_of(int dim, const double x[], double at[SAMPLES][3], const double q[], double E[3][3])
{
    int best = 0;
    for (int k = 1; k < SAMPLES; k++)
        best = distance_squared(dim, at[k], q) < distance_squared(dim, at[best], q) ? k : best;
    double phi = 2 * PI * best / SAMPLES, low = phi - 2 * PI / SAMPLES, high = phi + 2 * PI / SAMPLES;
    for (int look = 0; look < 60; look++) {
        double off[3] = {0};
        ellipse_at(dim, x, phi, E);
        for (int c = 0; c < dim; c++)
            off[c] = E[0][c] - q[c];
        double f = inner(dim, off, E[1]), slope = inner(dim, E[1], E[1]) + inner(dim, off, E[2]);
        *(f < 0 ? &low : &high) = phi;
        double next = slope > 0 ? phi - f / slope : low;
        if (!(low < next && next < high))
            next = low + (high - low) / 2;
        if (fabs(next - phi) <= DBL_EPSILON * 4)
            break;
        phi = next;
    }
    return phi > PI ? phi - 2 * PI : phi < -PI ? phi + 2 * PI : phi;
}

/* ---- one evaluation ---------------------------------------------------------------------------------- */

typedef struct work {
    const cagd_fit_data *data; /* in working coordinates */
    int dim, n;                /* n = 3 dim              */
    fit_support support;
    int first[2], unknown[MOST];
    fit_reduction *rows;
    double R[(MOST + 1) * (MOST + 1)], cost;
    double square;         /* the sum of the squared distances, not over s_i^2 */
    double T[MOST * MOST]; /* the directions in which x may move, as columns: m of them */
    int m;
} work;

/* Directions orthogonal to E'. */
static int normals(int dim, const double tangent[], double n[2][3])
{
    double length = sqrt(inner(dim, tangent, tangent)), T[3];
    for (int c = 0; c < dim; c++)
        T[c] = tangent[c] / length;
    if (dim == 2) {
        n[0][0] = -T[1], n[0][1] = T[0];
        return 1;
    }
    int small = fabs(T[0]) <= fabs(T[1]) ? 0 : 1;
    small = fabs(T[2]) < fabs(T[small]) ? 2 : small;
    double square = 0;
    for (int c = 0; c < 3; c++) {
        n[0][c] = (c == small) - T[small] * T[c];
        square += n[0][c] * n[0][c];
    }
    for (int c = 0; c < 3; c++)
        n[0][c] /= sqrt(square);
    for (int c = 0; c < 3; c++)
        n[1][c] = T[(c + 1) % 3] * n[0][(c + 2) % 3] - T[(c + 2) % 3] * n[0][(c + 1) % 3];
    return 2;
}

/* Feet, cost and triangle (R z) at x: residuals n.(Q - E), rows -n.dE. */
static void evaluate(work *w, const double x[], double phi[])
{
    double at[SAMPLES][3], E[3][3], n[2][3], lost = 0;
    const int dim = w->dim;
    sample(dim, x, at);
    fit_reduction_clear(w->rows);
    w->cost = w->square = 0;
    for (int i = 0; i < w->data->count; i++) {
        const double *q = w->data->points + (size_t)i * (size_t)dim, precision = 1 / w->data->sigma[i];
        phi[i] = foot_of(dim, x, at, q, E);
        const double share[3] = {1, cos(phi[i]), sin(phi[i])};
        const int count = normals(dim, E[1], n);
        for (int r = 0; r < count; r++) {
            double left = 0;
            int stride;
            double *row = fit_reduction_row(w->rows, 0, &stride);
            for (int c = 0; c < dim; c++)
                left += n[r][c] * (q[c] - E[0][c]);
            for (int k = 0; k < w->n; k++, row += stride)
                *row = -precision * share[k / dim] * n[r][k % dim];
            *row = precision * left;
            w->square += left * left;
            double more = precision * left * precision * left - lost, sum = w->cost + more;
            lost = (sum - w->cost) - more;
            w->cost = sum;
        }
    }
    memcpy(w->R, fit_reduction_triangle(w->rows), (size_t)((w->n + 1) * (w->n + 1)) * sizeof *w->R);
}

/* T: the identity for an ellipse; for a circle the centre, the radius, and in space the turns of its plane. */
static void directions_of(work *w, int circle, const double x[])
{
    const int dim = w->dim, n = w->n;
    memset(w->T, 0, sizeof w->T);
    w->m = n;
    for (int k = 0; k < (circle ? dim : n); k++)
        w->T[k * n + k] = 1;
    if (!circle)
        return;
    const double *a = x + dim, *b = a + dim, r = sqrt(inner(dim, a, a));
    w->m = dim == 2 ? 3 : 6;
    for (int c = 0; c < dim; c++) {
        w->T[(dim + c) * n + dim] = a[c] / r;
        w->T[(2 * dim + c) * n + dim] = b[c] / r;
        if (dim == 3) {
            double normal = (a[(c + 1) % 3] * b[(c + 2) % 3] - a[(c + 2) % 3] * b[(c + 1) % 3]) / r;
            w->T[(dim + c) * n + 4] = normal;
            w->T[(2 * dim + c) * n + 5] = normal;
        }
    }
}

/* Makes |a| = |b| and a.b = 0 again. */
static void make_round(int dim, double x[])
{
    double *a = x + dim, *b = a + dim, along = inner(dim, a, b) / inner(dim, a, a);
    double r = (sqrt(inner(dim, a, a)) + sqrt(inner(dim, b, b))) / 2, length = sqrt(inner(dim, a, a));
    for (int c = 0; c < dim; c++)
        b[c] -= along * a[c];
    double other = sqrt(inner(dim, b, b));
    for (int c = 0; c < dim; c++)
        a[c] *= r / length, b[c] *= r / other;
}

/* The singular values of R T, and U^T z.  Returns 0 when there is no memory. */
static int decompose(const work *w, double s[], double V[], double z[])
{
    const int n = w->n;
    double A[MOST * MOST] = {0}, U[MOST * MOST];
    for (int i = 0; i < n; i++)
        for (int j = 0; j < w->m; j++)
            for (int k = i; k < n; k++)
                A[i * n + j] += w->R[i * (n + 1) + k] * w->T[k * n + j];
    if (!fit_svd(n, A, U, s, V))
        return 0;
    for (int k = 0; k < n; k++) {
        z[k] = 0;
        for (int i = 0; i < n; i++)
            z[k] += U[i * n + k] * w->R[i * (n + 1) + n];
    }
    return 1;
}

/* x + T y, y = -V diag(s/(s^2 + damping^2)) U^T z. */
static void step_by(const work *w, int circle, const double s[], const double V[], const double z[], double damping,
                    const double x[], double next[])
{
    const int n = w->n;
    const double smallest = s[0] * DBL_EPSILON * n * 64;
    for (int k = 0; k < n; k++) {
        next[k] = x[k];
        for (int j = 0; j < w->m; j++) {
            double y = 0;
            for (int i = 0; i < n; i++)
                if (s[i] > smallest)
                    y -= V[j * n + i] * s[i] / (s[i] * s[i] + damping * damping) * z[i];
            next[k] += w->T[k * n + j] * y;
        }
    }
    if (circle)
        make_round(w->dim, next);
}

/* ---- the way to the minimum -------------------------------------------------------------------------- */

/* The circle u^2 + v^2 = 2 g u + 2 h v + k by linear least squares, in the two coordinates of the points along the columns of `axes`. */
static int first_ellipse(const work *w, double x[])
{
    const int dim = w->dim, count = w->data->count;
    double scatter[9] = {0}, U[9], s[3], axes[9], centre[3] = {0}, A[9] = {0}, right[3] = {0}, V[9];
    for (int i = 0; i < count; i++)
        for (int c = 0; c < dim; c++)
            centre[c] += w->data->points[i * dim + c] / count;
    for (int i = 0; i < count; i++)
        for (int c = 0; c < dim; c++)
            for (int d = 0; d < dim; d++)
                scatter[c * dim + d] +=
                    (w->data->points[i * dim + c] - centre[c]) * (w->data->points[i * dim + d] - centre[d]) / count;
    if (!fit_svd(dim, scatter, U, s, axes))
        return 0;
    double scale[2] = {sqrt(s[0]), sqrt(s[1])};
    if (!(scale[1] > 0))
        scale[1] = scale[0];
    for (int i = 0; i < count; i++) {
        double u[3] = {0, 0, 1};
        for (int c = 0; c < dim; c++)
            for (int k = 0; k < 2; k++)
                u[k] += (w->data->points[i * dim + c] - centre[c]) * axes[c * dim + k] / scale[k];
        for (int k = 0; k < 3; k++) {
            for (int l = 0; l < 3; l++)
                A[k * 3 + l] += u[k] * u[l];
            right[k] += u[k] * (u[0] * u[0] + u[1] * u[1]);
        }
    }
    double U3[9], s3[3], g[3] = {0};
    if (!fit_svd(3, A, U3, s3, V))
        return 0;
    for (int k = 0; k < 3; k++)
        for (int l = 0; l < 3; l++)
            for (int j = 0; s3[l] > s3[0] * DBL_EPSILON * 64 && j < 3; j++)
                g[k] += V[k * 3 + l] / s3[l] * U3[j * 3 + l] * right[j];
    double r = sqrt(fmax(g[2] + g[0] * g[0] / 4 + g[1] * g[1] / 4, 0.25));
    for (int c = 0; c < dim; c++) {
        x[c] = centre[c] + axes[c * dim] * scale[0] * g[0] / 2 + axes[c * dim + 1] * scale[1] * g[1] / 2;
        x[dim + c] = axes[c * dim] * scale[0] * r;
        x[2 * dim + c] = axes[c * dim + 1] * scale[1] * r;
    }
    return 1;
}

/* a and b become principal: orthogonal, the longer one first. */
static void make_principal(int dim, double x[])
{
    double *a = x + dim, *b = a + dim;
    double turn = atan2(2 * inner(dim, a, b), inner(dim, a, a) - inner(dim, b, b)) / 2, u = cos(turn), v = sin(turn);
    for (int c = 0; c < dim; c++) {
        double A = u * a[c] + v * b[c], B = u * b[c] - v * a[c];
        a[c] = A, b[c] = B;
    }
}

/* From x to the minimum.  A step that does not lower the cost is damped more; where no step does any more, that is the end.  Returns 0 when there is no
 * memory. */
static int descend(work *w, int circle, double x[], double phi[], fit_ellipse *e)
{
    double s[MOST], V[MOST * MOST], z[MOST], next[MOST], damping = 0;
    evaluate(w, x, phi);
    for (e->iterations = 0; e->iterations < STEPS && isfinite(w->cost); e->iterations++) {
        directions_of(w, circle, x);
        if (!decompose(w, s, V, z))
            return 0;
        double cost = w->cost, promised = 0;
        for (int k = 0; k < w->n; k++)
            promised += s[k] > s[0] * DBL_EPSILON * w->n * 64 ? z[k] * z[k] : 0;
        int better = 0;
        for (int try = 0; try < 40 && !better; try++) {
            step_by(w, circle, s, V, z, damping, x, next);
            evaluate(w, next, phi);
            better = w->cost < cost;
            damping = better ? (damping < s[0] * 1e-6 ? 0 : damping / 8) : damping > 0 ? 4 * damping : s[0] * 1e-4;
            if (!better && promised <= cost * 1e-13)
                break;
        }
        if (!better) {
            e->converged = 1; /* no step lowers the cost */
            evaluate(w, x, phi);
            break;
        }
        memcpy(x, next, sizeof next);
        if (cost - w->cost <= cost * 1e-15 && promised <= cost * 1e-13) {
            e->converged = 1;
            break;
        }
    }
    return 1;
}

/* (J^T J)^+ from R T: T V s^-2 V^T T^T. */
static int fill_inverse(work *w, int circle, const double x[], fit_ellipse *e)
{
    double s[MOST], V[MOST * MOST], z[MOST], TV[MOST * MOST] = {0};
    const int n = w->n;
    directions_of(w, circle, x);
    if (!decompose(w, s, V, z))
        return 0;
    for (int k = 0; k < n; k++)
        for (int i = 0; i < n; i++)
            for (int j = 0; j < w->m; j++)
                TV[k * n + i] += w->T[k * n + j] * V[j * n + i];
    memset(e->inverse, 0, sizeof e->inverse);
    e->unknowns = 0;
    const int most = circle ? w->m : n - 1; /* the phase does not count */
    for (int i = 0; i < most; i++) {
        if (!(s[i] > s[0] * DBL_EPSILON * n * 64))
            continue;
        e->unknowns++;
        for (int k = 0; k < n; k++)
            for (int l = 0; l < n; l++)
                e->inverse[k * n + l] += TV[k * n + i] * TV[l * n + i] / (s[i] * s[i]);
    }
    return 1;
}

/* -(J^T J)^+ J^T b, b_i = -s_i n.E''/(2 |E'|^2) in the directions n across the curve. */
static void fill_bias(const work *w, const double x[], const double phi[], fit_ellipse *e)
{
    const int dim = w->dim;
    double E[3][3], n[2][3], g[MOST] = {0};
    for (int i = 0; i < w->data->count; i++) {
        ellipse_at(dim, x, phi[i], E);
        const double share[3] = {1, cos(phi[i]), sin(phi[i])};
        const int count = normals(dim, E[1], n);
        for (int r = 0; r < count; r++) {
            const double off =
                -inner(dim, n[r], E[2]) / (2 * inner(dim, E[1], E[1])); /* over s_i^2, as the row is times s_i */
            for (int k = 0; k < w->n; k++)
                g[k] -= share[k / dim] * n[r][k % dim] * off;
        }
    }
    for (int k = 0; k < w->n; k++) {
        e->bias[k] = 0;
        for (int l = 0; l < w->n; l++)
            e->bias[k] -= e->inverse[k * w->n + l] * g[l];
    }
}

int fit_ellipse_of(const cagd_fit_data *data, int circle, const fit_ellipse *from, fit_ellipse *e, double phi[])
{
    const int dim = data->dim, count = data->count;
    const size_t numbers = (size_t)count * (size_t)dim;
    double low[3], high[3], unit = 0, *Q = malloc((numbers + (size_t)count) * sizeof *Q), *sigma = Q + numbers;
    work w = {.dim = dim, .n = 3 * dim};
    *e = (fit_ellipse){.dim = dim, .circle = circle};
    for (int k = 0; k < w.n; k++)
        w.unknown[k] = k;
    w.first[1] = w.n;
    w.support = (fit_support){w.n, 1, w.first, w.unknown};
    w.rows = fit_reduction_new(&w.support, 1);
    int good = Q != NULL && w.rows != NULL;
    for (int c = 0; c < dim && good; c++) {
        low[c] = INFINITY, high[c] = -INFINITY;
        for (int i = 0; i < count; i++) {
            low[c] = fmin(low[c], data->points[i * dim + c]);
            high[c] = fmax(high[c], data->points[i * dim + c]);
        }
        unit = fmax(unit, high[c] / 2 - low[c] / 2);
    }
    for (size_t m = 0; good && m < numbers; m++) {
        size_t c = m % (size_t)dim;
        Q[m] = (data->points[m] - (low[c] / 2 + high[c] / 2)) / unit;
    }
    for (int i = 0; good && i < count; i++)
        sigma[i] = data->sigma != NULL ? data->sigma[i] / unit : 1 / unit;
    cagd_fit_data near = {count, dim, Q, sigma};
    double x[MOST] = {0};
    w.data = &near;
    for (int k = 0; from != NULL && k < w.n; k++)
        x[k] = (from->x[k] - (k < dim ? low[k] / 2 + high[k] / 2 : 0)) / unit;
    good = good && (from != NULL || first_ellipse(&w, x));
    if (good && circle)
        make_round(dim, x);
    good = good && descend(&w, circle, x, phi, e);
    if (good) {
        make_principal(dim, x);
        evaluate(&w, x, phi);
        e->chi_squared = w.cost;
        e->rms = unit * sqrt(w.square / count);
        good = fill_inverse(&w, circle, x, e);
        fill_bias(&w, x, phi, e);
    }
    for (int k = 0; good && k < w.n; k++) {
        e->x[k] = x[k] * unit + (k < dim ? low[k] / 2 + high[k] / 2 : 0);
        e->bias[k] *= unit;
        for (int l = 0; l < w.n; l++)
            e->inverse[k * w.n + l] *= unit * unit;
        e->converged = e->converged && isfinite(e->x[k]);
    }
    fit_reduction_free(w.rows);
    free(Q);
    return good;
}

int fit_ellipse_curve(const fit_ellipse *e, double phi0, double phi1, cagd_spline *curve, double **points)
{
    const int dim = e->dim, whole = phi1 - phi0 >= 2 * PI,
              segments = whole ? 4 : (int)fmax(1, ceil((phi1 - phi0) / (PI / 2) - 1e-9)), count = 2 * segments + 1;
    double *P = malloc((size_t)(count * (dim + 2) + 3) * sizeof *P), *weights = P + count * dim,
           *knots = weights + count, half = (phi1 - phi0) / (2 * segments), E[3][3];
    *points = P;
    if (P == NULL)
        return 0;
    for (int k = 0; k < count; k++) {
        double scale = k % 2 == 1 ? 1 / cos(half) : 1, phi = phi0 + k * half;
        ellipse_at(dim, e->x, phi, E);
        for (int c = 0; c < dim; c++)
            P[k * dim + c] = k == count - 1 && whole ? P[c] : e->x[c] + scale * (E[0][c] - e->x[c]);
        weights[k] = k % 2 == 1 ? cos(half) : 1;
    }
    for (int i = 0; i < count + 3; i++)
        knots[i] = i < 3 ? 0 : i >= count ? 1 : (double)((i - 1) / 2) / segments;
    *curve = (cagd_spline){2, count, dim, knots, P, weights};
    return 1;
}
