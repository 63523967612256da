/* With t/(1 - t) = a s/(1 - s) the term w_i B_i^n(t) is (1 - t)^n/(1 - s)^n times a^i w_i B_i^n(s). */
void scale(int n, const double *w, double a, double *v)
{
    for (int i = 0; i <= n; i++) {
        v[i] = w[i] / w[0];
        for (int k = 0; k < i; k++)
            v[i] *= a;
    }
}

double invariant(int n, const double *w, int i) { (void)n; return w[i - 1] * w[i + 1] / (w[i] * w[i]); }

double parameter(double a, double t) { return t / (t + a * (1 - t)); }
