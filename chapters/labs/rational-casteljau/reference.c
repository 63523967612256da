/* By the definition: sums of Bernstein polynomials; level r at i is the curve of degree r of the points from i on. */
static double bernstein(int n, int i, double t)
{
    double b = 1;
    for (int k = 0; k < i; k++)
        b = b * (n - k) / (k + 1) * t;
    for (int k = i; k < n; k++)
        b *= 1 - t;
    return b;
}

/* The sum of B_i^n(t) w_i p_i; without points, of B_i^n(t) w_i. */
static double blend(int n, const double *p, const double *w, double t)
{
    double s = 0;
    for (int i = 0; i <= n; i++)
        s += bernstein(n, i, t) * w[i] * (p ? p[i] : 1);
    return s;
}

void homogeneous(int n, const double *p, const double *w, double t, double *h)
{
    h[0] = blend(n, p, w, t);
    h[1] = blend(n, 0, w, t);
}

double point(int n, const double *p, const double *w, double t)
{
    double h[2];
    homogeneous(n, p, w, t, h);
    return h[0] / h[1];
}

void level(int n, int r, const double *p, const double *w, double t, double *q, double *v)
{
    for (int i = 0; i <= n - r; i++) {
        double h[2];
        homogeneous(r, p + i, w + i, t, h);
        q[i] = h[0] / h[1];
        v[i] = h[1];
    }
}
