/* By the definition: B_i^n(t) = n!/(i! (n-i)!) t^i (1-t)^(n-i); the parts by Bernstein polynomials of lower degrees. */
static double factorial(int n) { return n < 2 ? 1 : n * factorial(n - 1); }

static double power(double x, int n) { return n == 0 ? 1 : x * power(x, n - 1); }

double point(int n, const double *p, double t)
{
    double s = 0;
    for (int i = 0; i <= n; i++)
        s += factorial(n) / (factorial(i) * factorial(n - i)) * power(t, i) * power(1 - t, n - i) * p[i];
    return s;
}

void split(int n, const double *p, double t, double *left, double *right)
{
    for (int k = 0; k <= n; k++) {
        left[k] = point(k, p, t);
        right[n - k] = point(k, p + (n - k), t);
    }
}
