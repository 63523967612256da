double kind(const double *w)
{
    double inside = w[1] * w[1], outside = w[0] * w[2];
    if (inside < outside)
        return -1;
    if (inside > outside)
        return 1;
    return 0;
}

void arc(double r, double u, double *x, double *y, double *w)
{
    double n = 1 + u * u;
    double c = (1 - u * u) / n;
    double s = 2 * u / n;
    x[0] = x[2] = r * c;
    x[1] = r / c;
    y[0] = -r * s;
    y[1] = 0;
    y[2] = r * s;
    w[0] = w[2] = 1;
    w[1] = c;
}

double shoulder(const double *w)
{
    double below = w[0] + 2 * w[1] + w[2];
    return 2 * w[1] / below;
}
