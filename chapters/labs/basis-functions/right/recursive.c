/* The recursion with a helper for 0/0 = 0. */
static double ratio(double a, double b) { return b == 0 ? 0 : a / b; }

double basis(int i, int p, const double *u, double t)
{
    if (t < u[i] || t >= u[i + p + 1])
        return 0;
    if (p == 0)
        return 1;
    return ratio(t - u[i], u[i + p] - u[i]) * basis(i, p - 1, u, t) +
           ratio(u[i + p + 1] - t, u[i + p + 1] - u[i + 1]) * basis(i + 1, p - 1, u, t);
}

static int down(int m, int p, const double *u, double t)
{
    return m == p || (u[m] <= t && u[m] < u[m + 1]) ? m : down(m - 1, p, u, t);
}

int span(int n, int p, const double *u, double t) { return down(n - 1, p, u, t); }
