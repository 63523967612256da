static double difference(int n, const double *x, const double *f)
{
    if (n == 0)
        return f[0];
    return (difference(n - 1, x + 1, f + 1) - difference(n - 1, x, f)) / (x[n] - x[0]);
}

void differences(int n, const double *x, const double *f, double *d)
{
    for (int k = 0; k <= n; k++)
        d[k] = difference(k, x, f);
}

/* Aitken and Neville: between two polynomials of one degree less. */
double value(int n, const double *x, const double *f, double t)
{
    if (n == 0)
        return f[0];
    double a = (t - x[0]) / (x[n] - x[0]);
    return (1 - a) * value(n - 1, x, f, t) + a * value(n - 1, x + 1, f + 1, t);
}
