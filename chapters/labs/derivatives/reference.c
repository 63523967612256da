/* The r-th derivative by n!/(n-r)! and r-th differences; the curvature from first and second derivatives of the quotient. */
static double choose(int n, int k) { return k == 0 ? 1 : choose(n - 1, k - 1) * n / k; }

static double bernstein(int n, int i, double t)
{
    double b = choose(n, i);
    for (int k = 0; k < n; k++)
        b *= k < i ? t : 1 - t;
    return b;
}

static double difference(int r, const double *p)
{
    return r == 0 ? p[0] : difference(r - 1, p + 1) - difference(r - 1, p);
}

void hodograph(int n, const double *p, double *d)
{
    for (int i = 0; i < n; i++)
        d[i] = n * difference(1, p + i);
}

/* n!/(n-r)! */
static double factor(int n, int r) { return r == 0 ? 1 : n * factor(n - 1, r - 1); }

double derivative(int n, int r, const double *p, double t)
{
    double s = 0;
    if (r > n)
        return 0;
    for (int i = 0; i <= n - r; i++)
        s += bernstein(n - r, i, t) * difference(r, p + i);
    return factor(n, r) * s;
}

/* f = g/w: f' = (g' - f w')/w, f'' = (g'' - 2 f' w' - f w'')/w, at 0. */
static void quotient(int n, const double *p, const double *w, double *first, double *second)
{
    double g0 = w[0] * p[0], g1 = w[1] * p[1], g2 = w[2] * p[2], f = p[0];
    double w1 = n * (w[1] - w[0]), w2 = n * (n - 1) * (w[2] - 2 * w[1] + w[0]);
    *first = (n * (g1 - g0) - f * w1) / w[0];
    *second = (n * (n - 1) * (g2 - 2 * g1 + g0) - 2 * *first * w1 - f * w2) / w[0];
}

double curvature2(int n, const double *x, const double *y, const double *w)
{
    double x1, x2, y1, y2;
    quotient(n, x, w, &x1, &x2);
    quotient(n, y, w, &y1, &y2);
    double cross = x1 * y2 - y1 * x2, square = x1 * x1 + y1 * y1;
    return cross * cross / (square * square * square);
}
