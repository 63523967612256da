/* By the definition; the system by elimination from above. */
double hermite(double a, double b, const double *y, const double *m, double t)
{
    double h = b - a, s = (t - a) / h;
    return (2 * s * s * s - 3 * s * s + 1) * y[0] + (-2 * s * s * s + 3 * s * s) * y[1] +
           h * (s * s * s - 2 * s * s + s) * m[0] + h * (s * s * s - s * s) * m[1];
}

void slopes(int n, const double *u, const double *y, double first, double last, double *m)
{
    double factor[n + 1];
    m[0] = first;
    m[n] = last;
    factor[0] = 0;
    for (int i = 1; i < n; i++) {
        double low = u[i] - u[i - 1], high = u[i + 1] - u[i];
        double right = 3 * (high * (y[i] - y[i - 1]) / low + low * (y[i + 1] - y[i]) / high);
        double pivot = 2 * (low + high) - high * factor[i - 1];
        factor[i] = low / pivot;
        m[i] = (right - high * m[i - 1]) / pivot;
    }
    for (int i = n - 1; i >= 1; i--)
        m[i] -= factor[i] * m[i + 1];
}
