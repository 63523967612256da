/* The sum of (w1 b_j - a_j)^2 is least where its derivative vanishes: by Lagrange's identity, or as a quotient of sums. */
static double power(double x, int n) { return n == 0 ? 1 : x * power(x, n - 1); }

double weight(int m, const double *p, const double *t, const double *q)
{
    double above = 0, below = 0;
    for (int j = 0; j < m; j++) {
        double a = power(1 - t[j], 2) * (q[j] - p[0]) + power(t[j], 2) * (q[j] - p[2]), b = 2 * t[j] * (1 - t[j]) * (p[1] - q[j]);
        above += a * b;
        below += b * b;
    }
    return above / below;
}

void weights(int m, const double *p, const double *t, const double *q, double *w)
{
    double A = 0, B = 0, C = 0, X = 0, Y = 0;
    for (int j = 0; j < m; j++) {
        double b = 3 * t[j] * power(1 - t[j], 2) * (p[1] - q[j]), c = 3 * power(t[j], 2) * (1 - t[j]) * (p[2] - q[j]);
        double a = power(1 - t[j], 3) * (q[j] - p[0]) + power(t[j], 3) * (q[j] - p[3]);
        A += b * b, B += b * c, C += c * c, X += a * b, Y += a * c;
    }
    w[0] = (X * C - Y * B) / (A * C - B * B);
    w[1] = (A * Y - B * X) / (A * C - B * B);
}
