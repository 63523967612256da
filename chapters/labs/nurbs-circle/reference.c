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

/* The sum of B_i^n(t) w_i x_i, n <= 2; without x, of B_i^n(t) w_i. */
static double blend(int n, const double *w, const double *x, double t)
{
    double s = 0;
    for (int i = 0; i <= n; i++) {
        double b = i == 1 && n == 2 ? 2 : 1;
        for (int k = 0; k < n; k++)
            b *= k < i ? t : 1 - t;
        s += b * w[i] * (x ? x[i] : 1);
    }
    return s;
}

void point(const double *x, const double *y, const double *w, double t, double *at)
{
    int k = t < 1 ? 0 : t < 2 ? 2 : t < 3 ? 4 : 6;
    double s = t - k / 2, below = blend(2, w + k, 0, s);
    at[0] = blend(2, w + k, x + k, s) / below;
    at[1] = blend(2, w + k, y + k, s) / below;
}
