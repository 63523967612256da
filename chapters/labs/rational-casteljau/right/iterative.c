/* Points and weights in two arrays. */
void level(int n, int r, const double *p, const double *w, double t, double *q, double *v)
{
    double a[n + 1], b[n + 1];
    for (int i = 0; i <= n; i++) {
        a[i] = p[i];
        b[i] = w[i];
    }
    for (int k = 1; k <= r; k++)
        for (int i = 0; i <= n - k; i++) {
            double left = (1 - t) * b[i], right = t * b[i + 1];
            b[i] = left + right;
            a[i] = (left * a[i] + right * a[i + 1]) / b[i];
        }
    for (int i = 0; i <= n - r; i++) {
        q[i] = a[i];
        v[i] = b[i];
    }
}

void homogeneous(int n, const double *p, const double *w, double t, double *h)
{
    double a[n + 1], b[n + 1];
    for (int i = 0; i <= n; i++) {
        a[i] = w[i] * p[i];
        b[i] = w[i];
    }
    for (int r = 1; r <= n; r++)
        for (int i = 0; i <= n - r; i++) {
            a[i] += t * (a[i + 1] - a[i]);
            b[i] += t * (b[i + 1] - b[i]);
        }
    h[0] = a[0];
    h[1] = b[0];
}

double point(int n, const double *p, const double *w, double t)
{
    double q[1], v[1];
    level(n, n, p, w, t, q, v);
    return q[0];
}
