/* By the definition. */
static double area(double ax, double ay, double bx, double by, double cx, double cy)
{
    return ax * (by - cy) + bx * (cy - ay) + cx * (ay - by);
}

double quadratic(const double *x, const double *y, const double *w, double X, double Y)
{
    double d0 = area(X, Y, x[1], y[1], x[2], y[2]), d1 = area(x[0], y[0], X, Y, x[2], y[2]),
           d2 = area(x[0], y[0], x[1], y[1], X, Y);
    return w[0] * w[2] * d1 * d1 - 4 * w[1] * w[1] * d0 * d2;
}

double cubic(const double *x, const double *y, const double *w, double X, double Y)
{
    static const int choose[4] = {1, 3, 3, 1};
    double l[4][4];
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            l[i][j] = choose[i] * choose[j] * w[i] * w[j] * area(X, Y, x[i], y[i], x[j], y[j]);
    double m = l[0][3] + l[1][2];
    return l[0][1] * (m * l[2][3] - l[1][3] * l[1][3]) - l[0][2] * (l[0][2] * l[2][3] - l[1][3] * l[0][3]) +
           l[0][3] * (l[0][2] * l[1][3] - m * l[0][3]);
}
