/* The functions of degree p - 1 that do not vanish in the span, by their triangle; then the differences of the points. */
double derivative(int n, int p, const double *u, const double *c, double t, int side)
{
    int m = p;
    for (int k = p; k < n; k++)
        if (side > 0 ? u[k] <= t && u[k] < u[k + 1] : u[k] < t && u[k] < u[k + 1])
            m = k;
    double f[8] = {1}, sum = 0;
    for (int q = 1; q < p; q++)
        for (int j = q; j >= 0; j--) {
            int i = m - q + j;
            double s = 0;
            if (j > 0)
                s += (t - u[i]) / (u[i + q] - u[i]) * f[j - 1];
            if (j < q)
                s += (u[i + q + 1] - t) / (u[i + q + 1] - u[i + 1]) * f[j];
            f[j] = s;
        }
    for (int j = 0; j < p; j++) {
        int i = m - p + 1 + j;
        sum += p * (c[i] - c[i - 1]) / (u[i + p] - u[i]) * f[j];
    }
    return sum;
}
