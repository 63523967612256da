/* With other operations: the blossom of t^j, whose value at equal arguments is t^j, built one argument after the other. */
static double mean(int left, int j, const double *u)
{
    /* the mean over all choices of j out of the `left` first knots */
    if (j == 0)
        return 1;
    double with = u[left - 1] * mean(left - 1, j - 1, u), share = (double)j / left;
    return j == left ? with : share * with + (1 - share) * mean(left - 1, j, u);
}

double coefficient(int i, int p, int j, const double *u) { return mean(p, j, u + i + 1); }

double greville(int i, int p, const double *u)
{
    double g = u[i + 1];
    for (int k = 2; k <= p; k++)
        g += (u[i + k] - g) / k;
    return g;
}

void spline(int n, int p, const double *u, const double *a, double *c)
{
    for (int i = n - 1; i >= 0; i--) {
        c[i] = a[0];
        for (int j = 1; j <= p; j++)
            c[i] += a[j] * mean(p, j, u + i + 1);
    }
}
