/* With other operations: every new point is a sum of old points with discrete B-splines. */
static double discrete(int i, int p, const double *u, const double *v, int j)
{
    if (p == 0)
        return u[i] <= v[j] && v[j] < u[i + 1];
    double s = 0;
    if (u[i + p] > u[i])
        s += (v[j + p] - u[i]) / (u[i + p] - u[i]) * discrete(i, p - 1, u, v, j);
    if (u[i + p + 1] > u[i + 1])
        s += (u[i + p + 1] - v[j + p]) / (u[i + p + 1] - u[i + 1]) * discrete(i + 1, p - 1, u, v, j);
    return s;
}

void refine(int n, int p, const double *u, const double *c, int m, const double *tau, double *v, double *d)
{
    int k = 0;
    for (int i = 0; i <= n + p; i++) {
        while (k < m && tau[k] < u[i]) {
            v[i + k] = tau[k];
            k++;
        }
        v[i + k] = u[i];
    }
    for (int j = 0; j < n + m; j++) {
        d[j] = 0;
        for (int i = 0; i < n; i++)
            d[j] += discrete(i, p, u, v, j) * c[i];
    }
}

void insert(int n, int p, const double *u, const double *c, double tau, double *v, double *d)
{
    refine(n, p, u, c, 1, &tau, v, d);
}
