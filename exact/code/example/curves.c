/* Curves as people write them: loops, searches, comparisons, memory. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The point at t of the Bezier curve with n + 1 coefficients. */
double casteljau(int n, const double *p, double t)
{
    double *b = malloc((n + 1) * sizeof *b);
    memcpy(b, p, (n + 1) * sizeof *b);
    for (int r = 1; r <= n; r++)
        for (int i = 0; i <= n - r; i++)
            b[i] = (1 - t) * b[i] + t * b[i + 1];
    double point = b[0];
    free(b);
    return point;
}

/* The same by Horner's scheme, with fewer operations. */
double horner(int n, const double *p, double t)
{
    double s = 1 - t, power = 1, sum = p[0] * s;
    int binomial = 1;
    for (int i = 1; i < n; i++) {
        power *= t;
        binomial = binomial * (n - i + 1) / i;
        sum = (sum + power * binomial * p[i]) * s;
    }
    return sum + power * t * p[n];
}

/* The same, where somebody was in a hurry: the powers of 1 - t are divided out, which ends at t = 1. */
double horner_divided(int n, const double *p, double t)
{
    double u = t / (1 - t), sum = p[n];
    for (int i = n - 1; i >= 0; i--)
        sum = sum * u * (i + 1) / (n - i) + p[i];
    return sum * pow(1 - t, n);
}

/* The index j with k[j] <= t < k[j+1]; at the end of the last span that is not empty. */
static int find_span(int n, int degree, const double *k, double t)
{
    int low = degree, high = n + 1;
    if (t >= k[n + 1])
        return n;
    while (high - low > 1) {
        int middle = (low + high) / 2;
        if (t < k[middle])
            high = middle;
        else
            low = middle;
    }
    return low;
}

/* The point at t of the B-spline with coefficients c[0..n] and knots k[0..n+degree+1]. */
double deboor(int n, int degree, const double *k, const double *c, double t)
{
    double d[8];
    int j = find_span(n, degree, k, t);
    for (int i = 0; i <= degree; i++)
        d[i] = c[j - degree + i];
    for (int r = 1; r <= degree; r++)
        for (int i = degree; i >= r; i--) {
            double a = (t - k[j - degree + i]) / (k[j + 1 + i - r] - k[j - degree + i]);
            d[i] = (1 - a) * d[i - 1] + a * d[i];
        }
    return d[degree];
}

/* N_{i,degree}(t), by its recursion. */
double basis(int i, int degree, const double *k, double t)
{
    double left = 0, right = 0;
    if (degree == 0)
        return k[i] <= t && t < k[i + 1];
    if (fabs(k[i + degree] - k[i]) > 0)
        left = (t - k[i]) / (k[i + degree] - k[i]) * basis(i, degree - 1, k, t);
    if (fabs(k[i + degree + 1] - k[i + 1]) > 0)
        right = (k[i + degree + 1] - t) / (k[i + degree + 1] - k[i + 1]) * basis(i + 1, degree - 1, k, t);
    return left + right;
}
