void circle(double r, double s, double *x, double *y, double *w)
{
    x[0] = r, x[1] = r, x[2] = 0, x[3] = -r, x[4] = -r, x[5] = -r, x[6] = 0, x[7] = r, x[8] = r;
    y[0] = 0, y[1] = r, y[2] = r, y[3] = r, y[4] = 0, y[5] = -r, y[6] = -r, y[7] = -r, y[8] = 0;
    for (int i = 0; i < 9; i++)
        w[i] = i % 2 == 0 ? 1 : s;
}

void knots(double *u)
{
    u[0] = 0;
    for (int k = 0; k < 5; k++)
        u[2 * k + 1] = u[2 * k + 2 < 12 ? 2 * k + 2 : 11] = k;
    u[11] = 4;
}

void point(const double *x, const double *y, const double *w, double t, double *at)
{
    int k = 0;
    while (k < 3 && t >= k + 1)
        k++;
    double f[3] = {(k + 1 - t) * (k + 1 - t), 2 * (t - k) * (k + 1 - t), (t - k) * (t - k)};
    double X = 0, Y = 0, W = 0;
    for (int i = 0; i < 3; i++) {
        X += f[i] * w[2 * k + i] * x[2 * k + i];
        Y += f[i] * w[2 * k + i] * y[2 * k + i];
        W += f[i] * w[2 * k + i];
    }
    at[0] = X / W;
    at[1] = Y / W;
}
