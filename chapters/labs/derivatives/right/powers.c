/* With other operations: coefficients of powers of t, and their derivatives. */
void hodograph(int n, const double *p, double *d)
{
    for (int i = n - 1; i >= 0; i--) {
        d[i] = p[i + 1];
        d[i] -= p[i];
        d[i] *= n;
    }
}

double derivative(int n, int r, const double *p, double t)
{
    double c[n + 1], choose = 1, s = 0;
    for (int i = 0; i <= n; i++)
        c[i] = p[i];
    for (int k = 0; k <= n; k++) {
        for (int i = n; i > k; i--)
            c[i] -= c[i - 1];
    }
    for (int k = 0; k <= n; k++) {
        c[k] *= choose;
        choose = choose * (n - k) / (k + 1);
    }
    for (int k = n; k >= r; k--) {
        double falling = 1;
        for (int j = 0; j < r; j++)
            falling *= k - j;
        s = s * t + falling * c[k];
    }
    return s;
}

double curvature2(int n, const double *x, const double *y, const double *w)
{
    double u = x[1] - x[0], v = y[1] - y[0], h = u * (y[2] - y[0]) - v * (x[2] - x[0]), m = w[0] * w[2] / w[1] / w[1];
    double square = u * u + v * v;
    return (n - 1) * (n - 1) * m * m * h * h / (n * n * square * square * square);
}
