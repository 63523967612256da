/* By the definition: the coefficients of t^k are those of the expanded Bernstein polynomials; back by the solution of that system. */
static double choose(int n, int k) { return k < 0 || k > n ? 0 : k == 0 ? 1 : choose(n - 1, k - 1) * n / k; }

void powers(int n, const double *p, double *a)
{
    for (int k = 0; k <= n; k++) {
        a[k] = 0;
        for (int i = 0; i <= k; i++)
            a[k] += ((k - i) % 2 == 0 ? 1 : -1) * choose(n, i) * choose(n - i, k - i) * p[i];
    }
}

void points(int n, const double *a, double *p)
{
    for (int i = 0; i <= n; i++) { /* row i has the points up to i alone */
        double known[16] = {0}, s[16];
        for (int k = 0; k < i; k++)
            known[k] = p[k];
        powers(n, known, s);
        p[i] = (a[i] - s[i]) / choose(n, i);
    }
}
