void scale(int n, const double *w, double a, double *v)
{
    double power = 1;
    for (int i = 0; i <= n; i++) {
        v[i] = w[i] * power / w[0];
        power *= a;
    }
}

double invariant(int n, const double *w, int i)
{
    (void)n;
    return (w[i - 1] * w[i + 1]) / (w[i] * w[i]);
}

double parameter(double a, double t)
{
    double left = a * (1 - t), right = t;
    return right / (left + right);
}
