/* The three lines of the algorithm; refinement one knot after the other. */
#include <string.h>

void insert(int n, int p, const double *u, const double *c, double tau, double *v, double *d)
{
    int m = n - 1;
    while (m > p && tau < u[m])
        m--;
    for (int i = 0; i <= n + p + 1; i++)
        v[i] = i <= m ? u[i] : i == m + 1 ? tau : u[i - 1];
    for (int i = 0; i <= n; i++) {
        if (i <= m - p) {
            d[i] = c[i];
        } else if (i <= m) {
            double a = (tau - u[i]) / (u[i + p] - u[i]);
            d[i] = (1 - a) * c[i - 1] + a * c[i];
        } else {
            d[i] = c[i - 1];
        }
    }
}

void refine(int n, int p, const double *u, const double *c, int m, const double *tau, double *v, double *d)
{
    double knots[n + p + m + 1], points[n + m];
    memcpy(v, u, (n + p + 1) * sizeof *v);
    memcpy(d, c, n * sizeof *d);
    for (int k = 0; k < m; k++) {
        memcpy(knots, v, (n + p + k + 1) * sizeof *v);
        memcpy(points, d, (n + k) * sizeof *d);
        insert(n + k, p, knots, points, tau[k], v, d);
    }
}
