void differences(int n, const double *x, const double *f, double *d)
{
    for (int i = 0; i <= n; i++)
        d[i] = f[i];
    for (int k = 1; k <= n; k++)
        for (int i = n; i >= k; i--)
            d[i] = (d[i] - d[i - 1]) / (x[i] - x[i - k]);
}

double value(int n, const double *x, const double *f, double t)
{
    double d[n + 1];
    differences(n, x, f, d);
    double s = d[n];
    for (int i = n - 1; i >= 0; i--)
        s = s * (t - x[i]) + d[i];
    return s;
}
