/* By the letter of the definition. */
double basis(int i, int p, const double *u, double t)
{
    if (p == 0)
        return u[i] <= t && t < u[i + 1] ? 1 : 0;
    double s = 0;
    if (u[i + p] != u[i])
        s += (t - u[i]) / (u[i + p] - u[i]) * basis(i, p - 1, u, t);
    if (u[i + p + 1] != u[i + 1])
        s += (u[i + p + 1] - t) / (u[i + p + 1] - u[i + 1]) * basis(i + 1, p - 1, u, t);
    return s;
}

int span(int n, int p, const double *u, double t)
{
    int last = p;
    for (int m = p; m < n; m++) {
        if (u[m] < u[m + 1])
            last = m;
        if (u[m] <= t && t < u[m + 1])
            return m;
    }
    return last;
}
