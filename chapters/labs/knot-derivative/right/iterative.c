/* de Boor's algorithm for the points of the derivative, in the span on the wanted side of t. */
double derivative(int n, int p, const double *u, const double *c, double t, int side)
{
    int m = p;
    if (side > 0)
        while (m < n - 1 && u[m + 1] <= t)
            m++;
    else
        while (m < n - 1 && u[m + 1] < t)
            m++;
    double d[p + 1];
    for (int i = m - p + 1; i <= m; i++)
        d[i - m + p] = p * (c[i] - c[i - 1]) / (u[i + p] - u[i]);
    for (int r = 1; r < p; r++)
        for (int i = m; i > m - p + r; i--) {
            double a = (t - u[i]) / (u[i + p - r] - u[i]);
            d[i - m + p] = (1 - a) * d[i - m + p - 1] + a * d[i - m + p];
        }
    return d[p];
}
