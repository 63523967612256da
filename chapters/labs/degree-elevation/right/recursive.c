/* Each point by itself; back from the right. */
static double elevated(int n, const double *p, int i)
{
    if (i == 0 || i == n + 1)
        return i == 0 ? p[0] : p[n];
    return (i * p[i - 1] + (n + 1 - i) * p[i]) / (n + 1);
}

void elevate(int n, const double *p, double *q)
{
    for (int i = n + 1; i >= 0; i--)
        q[i] = elevated(n, p, i);
}

static double lowered(int n, const double *q, int i)
{
    return i == n ? q[n + 1] : ((n + 1) * q[i + 1] - (n - i) * lowered(n, q, i + 1)) / (i + 1);
}

void lower(int n, const double *q, double *p)
{
    for (int i = 0; i <= n; i++)
        p[i] = lowered(n, q, i);
}
