/* Without a triangle: Horner's rule in the Bernstein form, for numerator and denominator. */
static double horner(int n, const double *p, const double *w, double t)
{
    double s = 1 - t, power = 1, choose = 1, sum = 0;
    for (int i = 0; i <= n; i++) {
        sum = sum * s + choose * power * w[i] * (p ? p[i] : 1);
        power *= t;
        choose *= (n - i) / (i + 1.0);
    }
    return sum;
}

void homogeneous(int n, const double *p, const double *w, double t, double *h)
{
    h[0] = horner(n, p, w, t);
    h[1] = horner(n, 0, w, t);
}

double point(int n, const double *p, const double *w, double t) { return horner(n, p, w, t) / horner(n, 0, w, t); }

void level(int n, int r, const double *p, const double *w, double t, double *q, double *v)
{
    for (int i = n - r; i >= 0; i--) {
        v[i] = horner(r, 0, w + i, t);
        q[i] = horner(r, p + i, w + i, t) / v[i];
    }
}
