/* From the left. */
void elevate(int n, const double *p, double *q)
{
    q[0] = p[0];
    for (int i = 1; i <= n; i++) {
        double a = (double)i / (n + 1);
        q[i] = a * p[i - 1] + (1 - a) * p[i];
    }
    q[n + 1] = p[n];
}

void lower(int n, const double *q, double *p)
{
    p[0] = q[0];
    for (int i = 1; i <= n; i++)
        p[i] = ((n + 1) * q[i] - i * p[i - 1]) / (n + 1 - i);
}
