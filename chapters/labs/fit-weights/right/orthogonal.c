/* The second column is made orthogonal to the first one, and its weight is found first. */
static double product(int m, const double *a, const double *b)
{
    double s = 0;
    for (int j = 0; j < m; j++)
        s += a[j] * b[j];
    return s;
}

double weight(int m, const double *p, const double *t, const double *q)
{
    double a[m], b[m];
    for (int j = 0; j < m; j++) {
        a[j] = (1 - t[j]) * (1 - t[j]) * (q[j] - p[0]) + t[j] * t[j] * (q[j] - p[2]);
        b[j] = 2 * (1 - t[j]) * t[j] * (p[1] - q[j]);
    }
    return product(m, a, b) / product(m, b, b);
}

void weights(int m, const double *p, const double *t, const double *q, double *w)
{
    double a[m], b[m], c[m], d[m];
    for (int j = 0; j < m; j++) {
        double x = t[j], y = 1 - x;
        a[j] = y * y * y * (q[j] - p[0]) + x * x * x * (q[j] - p[3]);
        b[j] = 3 * x * y * y * (p[1] - q[j]);
        c[j] = 3 * x * x * y * (p[2] - q[j]);
    }
    double f = product(m, b, c) / product(m, b, b);
    for (int j = 0; j < m; j++)
        d[j] = c[j] - f * b[j];
    w[1] = product(m, a, d) / product(m, d, d);
    w[0] = product(m, a, b) / product(m, b, b) - f * w[1];
}
