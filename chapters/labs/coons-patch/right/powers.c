/* With other operations: differences to the corners, and coefficients of powers. */
double patch(const double *c, const double *d, const double *corner, double u, double v)
{
    double along = d[0] + u * (d[1] - d[0]);
    double low = c[0] - corner[0] - u * (corner[2] - corner[0]), high = c[1] - corner[1] - u * (corner[3] - corner[1]);
    return along + low + v * (high - low);
}

static double cubic(const double *h, int step, double t)
{
    double a = h[0], b = h[step], c = h[2 * step], d = h[3 * step];
    return ((((2 * a - 2 * b) + c + d) * t + (3 * (b - a) - 2 * c - d)) * t + c) * t + a;
}

double bicubic(const double *m, double u, double v)
{
    double row[4];
    for (int j = 0; j < 4; j++)
        row[j] = cubic(m + j, 4, u);
    return cubic(row, 1, v);
}
