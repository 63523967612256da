/* The derivative of the curve is the curve of the hodograph. */
void hodograph(int n, const double *p, double *d)
{
    if (n == 0)
        return;
    d[n - 1] = n * (p[n] - p[n - 1]);
    for (int i = 0; i < n - 1; i++)
        d[i] = n * p[i + 1] - n * p[i];
}

static double value(int n, const double *p, double t)
{
    return n == 0 ? p[0] : (1 - t) * value(n - 1, p, t) + t * value(n - 1, p + 1, t);
}

double derivative(int n, int r, const double *p, double t)
{
    if (r == 0)
        return value(n, p, t);
    if (n == 0)
        return 0;
    double d[n];
    hodograph(n, p, d);
    return derivative(n - 1, r - 1, d, t);
}

double curvature2(int n, const double *x, const double *y, const double *w)
{
    double area = (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]);
    double edge = (x[1] - x[0]) * (x[1] - x[0]) + (y[1] - y[0]) * (y[1] - y[0]);
    double k = (n - 1) * w[0] * w[2] * area / (n * w[1] * w[1]);
    return k * k / edge / edge / edge;
}
