struct vector {
    double x, y;
};

static struct vector turned(struct vector a, double c, double s)
{
    struct vector b = {c * a.x - s * a.y, s * a.x + c * a.y};
    return b;
}

double kind(const double *w)
{
    double d = (w[1] * w[1] - w[0] * w[2]) * 4;
    return (d > 0) - (d < 0);
}

void arc(double r, double u, double *x, double *y, double *w)
{
    double c = 1 - 2 * u * u / (1 + u * u), s = u + u * c;
    struct vector end = {r, 0}, up = turned(end, c, s), down = turned(end, c, -s);
    x[0] = down.x, y[0] = down.y;
    x[1] = r / c, y[1] = 0;
    x[2] = up.x, y[2] = up.y;
    w[0] = w[2] = c / c, w[1] = c;
}

double shoulder(const double *w)
{
    double middle = (w[0] + w[2]) / 2;
    return 1 / (1 + middle / w[1]);
}
