/* Differences in place, then the triangle. */
#include <string.h>

void hodograph(int n, const double *p, double *d)
{
    for (int i = 0; i < n; i++)
        d[i] = n * (p[i + 1] - p[i]);
}

double derivative(int n, int r, const double *p, double t)
{
    double b[n + 1];
    memcpy(b, p, sizeof b);
    if (r > n)
        return 0;
    for (int k = 0; k < r; k++)
        for (int i = 0; i < n - k; i++)
            b[i] = (n - k) * (b[i + 1] - b[i]);
    for (int k = n - r; k > 0; k--)
        for (int i = 0; i < k; i++)
            b[i] = (1 - t) * b[i] + t * b[i + 1];
    return b[0];
}

double curvature2(int n, const double *x, const double *y, const double *w)
{
    double ax = x[1] - x[0], ay = y[1] - y[0], bx = x[2] - x[1], by = y[2] - y[1];
    double c = (n - 1.0) / n * w[0] * w[2] / (w[1] * w[1]) * (ax * by - ay * bx), l = ax * ax + ay * ay;
    return c * c / (l * l * l);
}
