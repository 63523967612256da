/* B_i^n = (n+1-i)/(n+1) B_i^(n+1) + (i+1)/(n+1) B_(i+1)^(n+1): each point is given to two. */
void elevate(int n, const double *p, double *q)
{
    for (int i = 0; i <= n + 1; i++)
        q[i] = 0;
    for (int i = 0; i <= n; i++) {
        q[i] += (n + 1.0 - i) / (n + 1) * p[i];
        q[i + 1] += (i + 1.0) / (n + 1) * p[i];
    }
}

void lower(int n, const double *q, double *p)
{
    p[0] = q[0];
    for (int i = 1; i <= n; i++)
        p[i] = ((n + 1) * q[i] - i * p[i - 1]) / (n + 1 - i);
}
