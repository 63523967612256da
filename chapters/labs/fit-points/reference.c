/* The sum of squares is least where its derivatives by the points inside vanish. */
static double power(double x, int n) { return n == 0 ? 1 : x * power(x, n - 1); }

double middle(int m, const double *t, const double *q)
{
    double above = 0, below = 0;
    for (int j = 0; j < m; j++) {
        double b = 2 * t[j] * (1 - t[j]);
        above += b * (q[j] - power(1 - t[j], 2) * q[0] - power(t[j], 2) * q[m - 1]);
        below += b * b;
    }
    return above / below;
}

void inside(int m, const double *t, const double *q, double *p)
{
    double A = 0, B = 0, C = 0, X = 0, Y = 0;
    for (int j = 0; j < m; j++) {
        double b = 3 * t[j] * power(1 - t[j], 2), c = 3 * power(t[j], 2) * (1 - t[j]);
        double a = q[j] - power(1 - t[j], 3) * q[0] - power(t[j], 3) * q[m - 1];
        A += b * b, B += b * c, C += c * c, X += a * b, Y += a * c;
    }
    p[0] = (X * C - Y * B) / (A * C - B * B);
    p[1] = (A * Y - B * X) / (A * C - B * B);
}

double squares(int m, const double *t, const double *q, const double *p)
{
    double s = 0;
    for (int j = 0; j < m; j++)
        s += power(power(1 - t[j], 2) * p[0] + 2 * t[j] * (1 - t[j]) * p[1] + power(t[j], 2) * p[2] - q[j], 2);
    return s;
}
