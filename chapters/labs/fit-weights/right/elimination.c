#include <string.h>

/* The normal equations for any number of weights, by elimination. */
static void solve(int n, double a[3][4], double *x)
{
    for (int k = 0; k < n; k++)
        for (int i = k + 1; i < n; i++) {
            double f = a[i][k] / a[k][k];
            for (int j = k; j <= n; j++)
                a[i][j] -= f * a[k][j];
        }
    for (int k = n - 1; k >= 0; k--) {
        x[k] = a[k][n];
        for (int j = k + 1; j < n; j++)
            x[k] -= a[k][j] * x[j];
        x[k] /= a[k][k];
    }
}

static void fit(int n, int m, const double *p, const double *t, const double *q, double *w)
{
    double a[3][4];
    memset(a, 0, sizeof a);
    for (int j = 0; j < m; j++) {
        double f[4], row[4];
        for (int i = 0; i <= n; i++) {
            f[i] = n == 2 && i == 1 ? 2 : n == 3 && (i == 1 || i == 2) ? 3 : 1;
            for (int k = 0; k < n; k++)
                f[i] *= k < i ? t[j] : 1 - t[j];
            f[i] *= p[i] - q[j];
        }
        for (int i = 1; i < n; i++)
            row[i - 1] = f[i];
        row[n - 1] = -f[0] - f[n];
        for (int i = 0; i < n - 1; i++)
            for (int k = 0; k < n; k++)
                a[i][k] += row[i] * row[k];
    }
    solve(n - 1, a, w);
}

double weight(int m, const double *p, const double *t, const double *q)
{
    double w[1];
    fit(2, m, p, t, q, w);
    return w[0];
}

void weights(int m, const double *p, const double *t, const double *q, double *w) { fit(3, m, p, t, q, w); }
