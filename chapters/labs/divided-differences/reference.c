/* By Lagrange's form: the divided difference of k + 1 values is the sum of f_i over the products of x_i - x_j. */
static double divided(int k, const double *x, const double *f)
{
    double s = 0;
    for (int i = 0; i <= k; i++) {
        double product = 1;
        for (int j = 0; j <= k; j++)
            if (j != i)
                product *= x[i] - x[j];
        s += f[i] / product;
    }
    return s;
}

void differences(int n, const double *x, const double *f, double *d)
{
    for (int k = 0; k <= n; k++)
        d[k] = divided(k, x, f);
}

double value(int n, const double *x, const double *f, double t)
{
    double s = 0;
    for (int i = 0; i <= n; i++) {
        double l = f[i];
        for (int j = 0; j <= n; j++)
            if (j != i)
                l *= (t - x[j]) / (x[i] - x[j]);
        s += l;
    }
    return s;
}
