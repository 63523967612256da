/* Values by recursion of powers; the functions as curves of degree 8; the range by its two ends. */
#include <math.h>

static double power(double x, int n) { return n == 0 ? 1 : x * power(x, n - 1); }

void basis(double beta, double t, double *b)
{
    double s = 1 - t;
    b[0] = (1 - beta * t) * power(s, 7);
    b[1] = (7 + beta - 5 * beta * t) * power(s, 6) * t;
    b[2] = (21 + 4 * beta - 9 * beta * t) * power(s, 5) * power(t, 2);
    b[3] = (35 + 5 * beta * s) * power(s, 4) * power(t, 3);
    b[4] = (35 + 5 * beta * t) * power(s, 3) * power(t, 4);
    b[5] = (21 - 5 * beta + 9 * beta * t) * power(s, 2) * power(t, 5);
    b[6] = (7 - 4 * beta + 5 * beta * t) * s * power(t, 6);
    b[7] = (1 - beta * s) * power(t, 7);
}

void points(double beta, const double *p, double *q)
{
    q[0] = p[0];
    q[8] = p[7];
    q[1] = p[1] + (1 - beta) / 8 * (p[0] - p[1]);
    q[7] = p[6] + (1 - beta) / 8 * (p[7] - p[6]);
    q[2] = p[2] + (7 - 4 * beta) / 28 * (p[1] - p[2]);
    q[6] = p[5] + (7 - 4 * beta) / 28 * (p[6] - p[5]);
    q[3] = p[3] + (21 - 5 * beta) / 56 * (p[2] - p[3]);
    q[5] = p[4] + (21 - 5 * beta) / 56 * (p[5] - p[4]);
    q[4] = (p[3] + p[4]) / 2;
}

int allowed(double beta)
{
    if (beta > 1)
        return 0;
    return beta >= -21.0 / 4;
}
