/* Without a triangle: sums of Bernstein polynomials. */
#include <math.h>

static double sum(int n, const double *p, double t)
{
    double s = 0, c = 1;
    for (int i = 0; i <= n; i++) {
        s += c * pow(t, i) * pow(1 - t, n - i) * p[i];
        c = c * (n - i) / (i + 1);
    }
    return s;
}

double point(int n, const double *p, double t) { return sum(n, p, t); }

void split(int n, const double *p, double t, double *left, double *right)
{
    for (int k = 0; k <= n; k++) {
        left[k] = sum(k, p, t);
        right[k] = sum(n - k, &p[k], t);
    }
}
