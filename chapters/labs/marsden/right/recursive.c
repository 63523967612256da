/* e_j(u_1..u_p) = e_j(u_1..u_(p-1)) + u_p e_(j-1)(u_1..u_(p-1)). */
static double symmetric(int j, int p, const double *u)
{
    if (j == 0)
        return 1;
    return j > p ? 0 : symmetric(j, p - 1, u) + u[p - 1] * symmetric(j - 1, p - 1, u);
}

static double choose(int n, int k) { return k == 0 ? 1 : choose(n - 1, k - 1) * n / k; }

double coefficient(int i, int p, int j, const double *u) { return symmetric(j, p, &u[i + 1]) / choose(p, j); }

double greville(int i, int p, const double *u) { return coefficient(i, p, 1, u); }

void spline(int n, int p, const double *u, const double *a, double *c)
{
    if (n == 0)
        return;
    c[n - 1] = 0;
    for (int j = p; j >= 0; j--)
        c[n - 1] += a[j] * coefficient(n - 1, p, j, u);
    spline(n - 1, p, u, a, c);
}
