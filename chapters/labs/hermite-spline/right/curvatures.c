/* With other operations: divided differences for the cubic; second derivatives for the spline, from which the slopes follow. */
double hermite(double a, double b, const double *y, const double *m, double t)
{
    double d = (y[1] - y[0]) / (b - a), c = (d - m[0]) / (b - a), e = (m[1] - d) / (b - a);
    return y[0] + (t - a) * (m[0] + (t - a) * (c + (t - b) * (e - c) / (b - a)));
}

void slopes(int n, const double *u, const double *y, double first, double last, double *m)
{
    double q[n + 1], z[n + 1];
    for (int i = 0; i <= n; i++) {
        double g = i > 0 ? u[i] - u[i - 1] : 0, h = i < n ? u[i + 1] - u[i] : 0;
        double left = i > 0 ? (y[i] - y[i - 1]) / g : first, right = i < n ? (y[i + 1] - y[i]) / h : last;
        double d = 2 * (g + h) - (i > 0 ? g * q[i - 1] : 0);
        z[i] = (6 * (right - left) - (i > 0 ? g * z[i - 1] : 0)) / d;
        q[i] = h / d;
    }
    for (int i = n - 1; i >= 0; i--)
        z[i] -= q[i] * z[i + 1];
    for (int i = 0; i < n; i++)
        m[i] = (y[i + 1] - y[i]) / (u[i + 1] - u[i]) - (u[i + 1] - u[i]) * (2 * z[i] + z[i + 1]) / 6;
    m[n] = last;
}
