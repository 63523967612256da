#include <stdlib.h>

/* Columns and the right-hand side of the equations, m long each. */
static double dot(int m, const double *a, const double *b)
{
    double s = 0;
    while (m-- > 0)
        s += a[m] * b[m];
    return s;
}

double middle(int m, const double *t, const double *q)
{
    double *column = malloc(2 * m * sizeof *column), *right = column + m;
    for (int j = 0; j < m; j++) {
        column[j] = 2 * (t[j] - t[j] * t[j]);
        right[j] = q[j] - q[0] + 2 * t[j] * q[0] - t[j] * t[j] * (q[0] + q[m - 1]);
    }
    double x = dot(m, column, right) / dot(m, column, column);
    free(column);
    return x;
}

void inside(int m, const double *t, const double *q, double *p)
{
    double c[3][m];
    for (int j = 0; j < m; j++) {
        double x = t[j], y = 1 - x;
        c[0][j] = 3 * x * y * y;
        c[1][j] = 3 * x * x * y;
        c[2][j] = q[j] - y * y * y * q[0] - x * x * x * q[m - 1];
    }
    double a = dot(m, c[0], c[0]), b = dot(m, c[0], c[1]), d = dot(m, c[1], c[1]), f = b / a;
    double x = dot(m, c[0], c[2]), y = dot(m, c[1], c[2]) - f * x;
    p[1] = y / (d - f * b);
    p[0] = (x - b * p[1]) / a;
}

double squares(int m, const double *t, const double *q, const double *p)
{
    if (m == 0)
        return 0;
    double x = t[m - 1], e = p[0] + 2 * x * (p[1] - p[0]) + x * x * (p[0] - 2 * p[1] + p[2]) - q[m - 1];
    return squares(m - 1, t, q, p) + e * e;
}
