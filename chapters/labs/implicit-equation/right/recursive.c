/* Determinants by expansion along their first row. */
static double determinant(int n, double m[4][4])
{
    double s = 0, sign = 1, minor[4][4];
    if (n == 1)
        return m[0][0];
    for (int c = 0; c < n; c++, sign = -sign) {
        for (int i = 1; i < n; i++)
            for (int j = 0, k = 0; j < n; j++)
                if (j != c)
                    minor[i - 1][k++] = m[i][j];
        s += sign * m[0][c] * determinant(n - 1, minor);
    }
    return s;
}

static double bracket(double ax, double ay, double bx, double by, double cx, double cy)
{
    double m[4][4] = {{ax, ay, 1}, {bx, by, 1}, {cx, cy, 1}};
    return determinant(3, m);
}

double quadratic(const double *x, const double *y, const double *w, double X, double Y)
{
    double d1 = bracket(x[0], y[0], X, Y, x[2], y[2]);
    double d02 = bracket(X, Y, x[1], y[1], x[2], y[2]) * bracket(x[0], y[0], x[1], y[1], X, Y);
    return w[0] * w[2] * d1 * d1 - 4 * w[1] * w[1] * d02;
}

double cubic(const double *x, const double *y, const double *w, double X, double Y)
{
#define L(i, j) ((i % 3 ? 3 : 1) * (j % 3 ? 3 : 1) * w[i] * w[j] * bracket(X, Y, x[i], y[i], x[j], y[j]))
    double m[4][4] = {{L(0, 1), L(0, 2), L(0, 3)}, {L(0, 2), L(0, 3) + L(1, 2), L(1, 3)}, {L(0, 3), L(1, 3), L(2, 3)}};
    return determinant(3, m);
}
