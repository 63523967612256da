/* By the definition. */
double patch(const double *c, const double *d, const double *corner, double u, double v)
{
    double s = (1 - v) * c[0] + v * c[1] + (1 - u) * d[0] + u * d[1];
    return s - (1 - u) * (1 - v) * corner[0] - (1 - u) * v * corner[1] - u * (1 - v) * corner[2] - u * v * corner[3];
}

static double hermite(int k, double t)
{
    switch (k) {
    case 0:
        return 2 * t * t * t - 3 * t * t + 1;
    case 1:
        return -2 * t * t * t + 3 * t * t;
    case 2:
        return t * t * t - 2 * t * t + t;
    default:
        return t * t * t - t * t;
    }
}

double bicubic(const double *m, double u, double v)
{
    double s = 0;
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            s += hermite(i, u) * m[4 * i + j] * hermite(j, v);
    return s;
}
