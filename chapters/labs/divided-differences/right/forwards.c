/* A value at a time: Newton's polynomial so far is asked for it. */
void differences(int n, const double *x, const double *f, double *d)
{
    for (int k = 0; k <= n; k++) {
        double so_far = 0, product = 1;
        for (int i = 0; i < k; i++) {
            so_far += d[i] * product;
            product *= x[k] - x[i];
        }
        d[k] = (f[k] - so_far) / product;
    }
}

double value(int n, const double *x, const double *f, double t)
{
    double d[16], s = 0, product = 1;
    differences(n, x, f, d);
    for (int i = 0; i <= n; i++, product *= t - x[i - 1])
        s += d[i] * product;
    return s;
}
