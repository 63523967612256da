/* One knot, and the others by the function itself. */
#include <stdlib.h>

static int span(int low, int high, const double *u, double t)
{
    if (high - low == 1)
        return low;
    int middle = (low + high) / 2;
    return u[middle] <= t ? span(middle, high, u, t) : span(low, middle, u, t);
}

void insert(int n, int p, const double *u, const double *c, double tau, double *v, double *d)
{
    int m = span(p, n, u, tau), i = 0;
    for (; i <= m - p; i++)
        d[i] = c[i];
    for (; i <= m; i++)
        d[i] = ((u[i + p] - tau) * c[i - 1] + (tau - u[i]) * c[i]) / (u[i + p] - u[i]);
    for (; i <= n; i++)
        d[i] = c[i - 1];
    for (i = 0; i <= m; i++)
        v[i] = u[i];
    v[i] = tau;
    for (; i <= n + p; i++)
        v[i + 1] = u[i];
}

void refine(int n, int p, const double *u, const double *c, int m, const double *tau, double *v, double *d)
{
    if (m == 0) {
        for (int i = 0; i <= n + p; i++)
            v[i] = u[i];
        for (int i = 0; i < n; i++)
            d[i] = c[i];
        return;
    }
    double *a = malloc((n + p + 2) * sizeof *a), *b = malloc((n + 1) * sizeof *b);
    insert(n, p, u, c, tau[0], a, b);
    refine(n + 1, p, a, b, m - 1, tau + 1, v, d);
    free(a);
    free(b);
}
