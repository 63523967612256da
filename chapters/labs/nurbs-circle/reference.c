/* Four quarters: the corners of the square around the circle have the weight s, the cosine of half a right angle. */
void circle(double r, double s, double *x, double *y, double *w)
{
    static const int cx[9] = {1, 1, 0, -1, -1, -1, 0, 1, 1}, cy[9] = {0, 1, 1, 1, 0, -1, -1, -1, 0};
    for (int i = 0; i < 9; i++) {
        x[i] = r * cx[i];
        y[i] = r * cy[i];
        w[i] = i % 2 == 1 ? s : 1;
    }
}

void knots(double *u)
{
    for (int i = 0; i < 12; i++)
        u[i] = i == 0 ? 0 : i == 11 ? 4 : (i - 1) / 2;
}

static double bernstein(const double *b, double t) { return b[0] * (1 - t) * (1 - t) + 2 * b[1] * t * (1 - t) + b[2] * t * t; }

void point(const double *x, const double *y, const double *w, double t, double *at)
{
    int k = t < 1 ? 0 : t < 2 ? 2 : t < 3 ? 4 : 6;
    double X[3], Y[3], s = t - k / 2;
    for (int i = 0; i < 3; i++) {
        X[i] = w[k + i] * x[k + i];
        Y[i] = w[k + i] * y[k + i];
    }
    at[0] = bernstein(X, s) / bernstein(w + k, s);
    at[1] = bernstein(Y, s) / bernstein(w + k, s);
}
