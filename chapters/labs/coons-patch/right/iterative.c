/* Loops over the corners, and the functions in an array. */
double patch(const double *c, const double *d, const double *corner, double u, double v)
{
    double a[2] = {1 - u, u}, b[2] = {1 - v, v}, s = 0;
    for (int k = 0; k < 2; k++)
        s += b[k] * c[k] + a[k] * d[k];
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++)
            s -= a[i] * b[j] * corner[2 * i + j];
    return s;
}

static void functions(double t, double *f)
{
    f[1] = t * t * (3 - 2 * t);
    f[0] = 1 - f[1];
    f[2] = t * (1 - t) * (1 - t);
    f[3] = t * t * (t - 1);
}

double bicubic(const double *m, double u, double v)
{
    double f[4], g[4], s = 0;
    functions(u, f);
    functions(v, g);
    for (int i = 0; i < 4; i++) {
        double row = 0;
        for (int j = 0; j < 4; j++)
            row += m[4 * i + j] * g[j];
        s += f[i] * row;
    }
    return s;
}
