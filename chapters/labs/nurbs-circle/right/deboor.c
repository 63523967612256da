/* de Boor's algorithm in homogeneous coordinates, with the knots of the circle. */
void knots(double *u)
{
    for (int i = 0; i < 12; i++)
        u[i] = i < 3 ? 0 : i > 8 ? 4 : (i - 1) / 2;
}

void circle(double r, double s, double *x, double *y, double *w)
{
    for (int i = 0; i < 9; i++) {
        int side = i % 8;
        x[i] = side < 2 || side > 6 ? r : side == 2 || side == 6 ? 0 : -r;
        y[i] = side > 0 && side < 4 ? r : side == 0 || side == 4 ? 0 : -r;
        w[i] = 1 - i % 2 + i % 2 * s;
    }
}

static double deboor(const double *u, const double *c, int m, double t)
{
    double d[3] = {c[m - 2], c[m - 1], c[m]};
    for (int r = 1; r <= 2; r++)
        for (int j = 2; j >= r; j--) {
            int i = m - 2 + j;
            double a = (t - u[i]) / (u[i + 3 - r] - u[i]);
            d[j] = (1 - a) * d[j - 1] + a * d[j];
        }
    return d[2];
}

void point(const double *x, const double *y, const double *w, double t, double *at)
{
    double u[12], X[9], Y[9];
    int m = 2;
    knots(u);
    while (m < 8 && t >= u[m + 1])
        m++;
    for (int i = 0; i < 9; i++) {
        X[i] = w[i] * x[i];
        Y[i] = w[i] * y[i];
    }
    at[0] = deboor(u, X, m, t) / deboor(u, w, m, t);
    at[1] = deboor(u, Y, m, t) / deboor(u, w, m, t);
}
