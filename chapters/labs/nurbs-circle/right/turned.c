/* Each quarter is the one before, turned by a right angle. */
void circle(double r, double s, double *x, double *y, double *w)
{
    x[0] = x[1] = r;
    y[0] = 0;
    y[1] = r;
    w[0] = 1;
    w[1] = s;
    for (int i = 2; i < 9; i++) {
        x[i] = -y[i - 2];
        y[i] = x[i - 2];
        w[i] = w[i - 2];
    }
}

void knots(double *u)
{
    const double all[] = {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4};
    for (int i = 0; i < 12; i++)
        u[i] = all[i];
}

static double between(double a, double b, double t) { return a + t * (b - a); }

static double casteljau(double a, double b, double c, double t)
{
    return between(between(a, b, t), between(b, c, t), t);
}

void point(const double *x, const double *y, const double *w, double t, double *at)
{
    int k = t < 2 ? t >= 1 : 2 + (t >= 3);
    const double *p = w + 2 * k, *a = x + 2 * k, *b = y + 2 * k;
    double W = casteljau(p[0], p[1], p[2], t - k);
    at[0] = casteljau(p[0] * a[0], p[1] * a[1], p[2] * a[2], t - k) / W;
    at[1] = casteljau(p[0] * b[0], p[1] * b[1], p[2] * b[2], t - k) / W;
}
