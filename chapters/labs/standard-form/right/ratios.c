/* Neighbours' ratios are multiplied by a; an invariant is a ratio of ratios. */
void scale(int n, const double *w, double a, double *v)
{
    v[0] = 1;
    for (int i = 1; i <= n; i++)
        v[i] = v[i - 1] * (w[i] / w[i - 1]) * a;
}

double invariant(int n, const double *w, int i)
{
    double before = w[i] / w[i - 1], behind = w[i + 1] / w[i];
    return i > 0 && i < n ? behind / before : 0;
}

double parameter(double a, double t) { return 1 - a * (1 - t) / (a + (1 - a) * t); }
