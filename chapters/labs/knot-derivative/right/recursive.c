/* The derivative by the blossom: p times the difference of two blossoms over the length of the span. */
static double blossom(int p, int i, int r, const double *u, const double *c, const double *t)
{
    if (r == 0)
        return c[i];
    double a = (t[r - 1] - u[i]) / (u[i + p + 1 - r] - u[i]);
    return (1 - a) * blossom(p, i - 1, r - 1, u, c, t) + a * blossom(p, i, r - 1, u, c, t);
}

double derivative(int n, int p, const double *u, const double *c, double t, int side)
{
    int m = p;
    while (m < n - 1 && (side > 0 ? !(t < u[m + 1]) : u[m + 1] < t))
        m++;
    double low[8], high[8];
    for (int k = 0; k < p; k++)
        low[k] = high[k] = t;
    low[0] = u[m];
    high[0] = u[m + 1];
    return p * (blossom(p, m, p, u, c, high) - blossom(p, m, p, u, c, low)) / (u[m + 1] - u[m]);
}
