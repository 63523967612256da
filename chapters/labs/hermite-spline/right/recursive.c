/* Bezier points of the cubic; the system by a recursion that says each slope as a + b times the next. */
static double casteljau(int n, const double *p, double s)
{
    return n == 0 ? p[0] : (1 - s) * casteljau(n - 1, p, s) + s * casteljau(n - 1, p + 1, s);
}

double hermite(double a, double b, const double *y, const double *m, double t)
{
    double h = (b - a) / 3, p[4] = {y[0], y[0] + h * m[0], y[1] - h * m[1], y[1]};
    return casteljau(3, p, (t - a) / (b - a));
}

static double solve(int i, int n, const double *u, const double *y, double a, double b, double *m)
{
    m[i] = i == n ? m[n] : 0;
    if (i == n)
        return m[n];
    /* m[i-1] = a + b m[i] */
    double g = u[i] - u[i - 1], h = u[i + 1] - u[i], d = 2 * (g + h) + h * b;
    double r = 3 * (h / g * (y[i] - y[i - 1]) + g / h * (y[i + 1] - y[i])) - h * a;
    double next = solve(i + 1, n, u, y, r / d, -g / d, m);
    return m[i] = r / d - g / d * next;
}

void slopes(int n, const double *u, const double *y, double first, double last, double *m)
{
    m[n] = last;
    if (n > 0)
        solve(1, n, u, y, first, 0, m);
    m[0] = first;
}
