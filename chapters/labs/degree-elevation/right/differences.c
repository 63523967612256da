/* With other operations: edges, and alternating sums. */
static double choose(int n, int k) { return k == 0 ? 1 : choose(n - 1, k - 1) * n / k; }

void elevate(int n, const double *p, double *q)
{
    q[0] = p[0];
    for (int i = 1; i <= n; i++)
        q[i] = p[i] - i * (p[i] - p[i - 1]) / (n + 1.0);
    q[n + 1] = p[n];
}

/* C(n, i) p_i = C(n+1, i) q_i - C(n+1, i-1) q_(i-1) + ..., since the scaled points are a product with 1 + x. */
void lower(int n, const double *q, double *p)
{
    for (int i = 0; i <= n; i++) {
        double s = 0;
        for (int j = 0; j <= i; j++)
            s = choose(n + 1, j) * q[j] - s;
        p[i] = s / choose(n, i);
    }
}
