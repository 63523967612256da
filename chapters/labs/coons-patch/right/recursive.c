/* Means of means; the cubic of two values and two slopes by de Casteljau's recursion, in one direction and then in the other. */
static double mean(double a, double b, double t) { return a + t * (b - a); }

double patch(const double *c, const double *d, const double *corner, double u, double v)
{
    return mean(c[0], c[1], v) + mean(d[0], d[1], u) -
           mean(mean(corner[0], corner[1], v), mean(corner[2], corner[3], v), u);
}

static double casteljau(int n, const double *p, double t)
{
    return n == 0 ? p[0] : mean(casteljau(n - 1, p, t), casteljau(n - 1, p + 1, t), t);
}

static double cubic(double a, double b, double c, double d, double t)
{
    double p[4] = {a, a + c / 3, b - d / 3, b};
    return casteljau(3, p, t);
}

double bicubic(const double *m, double u, double v)
{
    double column[4];
    for (int i = 0; i < 4; i++)
        column[i] = cubic(m[4 * i], m[4 * i + 1], m[4 * i + 2], m[4 * i + 3], v);
    return cubic(column[0], column[1], column[2], column[3], u);
}
