static double times(double x, double a, int n) { return n == 0 ? x : times(x * a, a, n - 1); }

void scale(int n, const double *w, double a, double *v)
{
    if (n > 0)
        scale(n - 1, w, a, v);
    v[n] = times(w[n] / w[0], a, n);
}

double invariant(int n, const double *w, int i) { return i > 1 ? invariant(n - 1, w + 1, i - 1) : w[0] * w[2] / (w[1] * w[1]); }

double parameter(double a, double t)
{
    double s = t;
    s /= a + t - a * t;
    return s;
}
