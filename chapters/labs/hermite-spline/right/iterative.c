/* The functions factorised; the system in three arrays. */
double hermite(double a, double b, const double *y, const double *m, double t)
{
    double h = b - a, s = (t - a) / h, r = 1 - s;
    double rise = s * s * (3 - 2 * s);
    return y[0] * (1 - rise) + y[1] * rise + h * s * r * (r * m[0] - s * m[1]);
}

void slopes(int n, const double *u, const double *y, double first, double last, double *m)
{
    double below[n + 1], middle[n + 1], above[n + 1];
    middle[0] = 1, above[0] = 0, m[0] = first;
    below[n] = 0, middle[n] = 1, m[n] = last;
    for (int i = 1; i < n; i++) {
        double g = u[i] - u[i - 1], h = u[i + 1] - u[i];
        below[i] = h;
        middle[i] = 2 * (g + h);
        above[i] = g;
        m[i] = 3 * (h * (y[i] - y[i - 1]) / g + g * (y[i + 1] - y[i]) / h);
    }
    for (int i = 1; i <= n; i++) {
        double f = below[i] / middle[i - 1];
        middle[i] -= f * above[i - 1];
        m[i] -= f * m[i - 1];
    }
    m[n] /= middle[n];
    for (int i = n - 1; i >= 0; i--)
        m[i] = (m[i] - above[i] * m[i + 1]) / middle[i];
}
