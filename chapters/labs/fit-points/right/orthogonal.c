static double product(int m, const double *a, const double *b)
{
    return m == 0 ? 0 : product(m - 1, a, b) + a[m - 1] * b[m - 1];
}

static double between(double a, double b, double t) { return (1 - t) * a + t * b; }

double middle(int m, const double *t, const double *q)
{
    double a[m], b[m];
    for (int j = 0; j < m; j++) {
        a[j] = q[j] - between(between(q[0], 0, t[j]), between(0, q[m - 1], t[j]), t[j]);
        b[j] = between(between(0, 1, t[j]), between(1, 0, t[j]), t[j]);
    }
    return product(m, a, b) / product(m, b, b);
}

void inside(int m, const double *t, const double *q, double *p)
{
    double a[m], b[m], c[m];
    for (int j = 0; j < m; j++) {
        double x = t[j], y = 1 - x;
        a[j] = q[j] - y * y * y * q[0] - x * x * x * q[m - 1];
        b[j] = 3 * x * y * y;
        c[j] = 3 * x * x * y;
    }
    double f = product(m, b, c) / product(m, b, b), first = product(m, a, b) / product(m, b, b);
    for (int j = 0; j < m; j++)
        c[j] -= f * b[j];
    p[1] = product(m, a, c) / product(m, c, c);
    p[0] = first - f * p[1];
}

double squares(int m, const double *t, const double *q, const double *p)
{
    double e[m];
    for (int j = 0; j < m; j++)
        e[j] = between(between(p[0], p[1], t[j]), between(p[1], p[2], t[j]), t[j]) - q[j];
    return product(m, e, e);
}
