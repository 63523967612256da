/* By the definition: N' = p N(i,p-1)/(u(i+p)-u(i)) - p N(i+1,p-1)/(u(i+p+1)-u(i+1)), summed; the functions of degree 0 belong to the span
 * that begins at t (side 1) or ends there (side -1). */
static double basis(int p, int i, const double *u, double t, int side)
{
    if (p == 0)
        return side > 0 ? u[i] <= t && t < u[i + 1] : u[i] < t && t <= u[i + 1];
    double s = 0;
    if (u[i] < u[i + p])
        s += (t - u[i]) / (u[i + p] - u[i]) * basis(p - 1, i, u, t, side);
    if (u[i + 1] < u[i + p + 1])
        s += (u[i + p + 1] - t) / (u[i + p + 1] - u[i + 1]) * basis(p - 1, i + 1, u, t, side);
    return s;
}

double derivative(int n, int p, const double *u, const double *c, double t, int side)
{
    double s = 0;
    for (int i = 0; i < n; i++) {
        if (u[i] < u[i + p])
            s += c[i] * p / (u[i + p] - u[i]) * basis(p - 1, i, u, t, side);
        if (u[i + 1] < u[i + p + 1])
            s -= c[i] * p / (u[i + p + 1] - u[i + 1]) * basis(p - 1, i + 1, u, t, side);
    }
    return s;
}
