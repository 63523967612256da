/* The product (1 + u x)...(1 + u x), factor by factor. */
double greville(int i, int p, const double *u)
{
    double sum = 0;
    for (int k = 1; k <= p; k++)
        sum += u[i + k];
    return sum / p;
}

double coefficient(int i, int p, int j, const double *u)
{
    double e[p + 1], choose = 1;
    e[0] = 1;
    for (int k = 1; k <= p; k++) {
        e[k] = 0;
        for (int m = k; m >= 1; m--)
            e[m] += u[i + k] * e[m - 1];
    }
    for (int k = 0; k < j; k++)
        choose = choose * (p - k) / (k + 1);
    return e[j] / choose;
}

void spline(int n, int p, const double *u, const double *a, double *c)
{
    for (int i = 0; i < n; i++) {
        double sum = 0;
        for (int j = 0; j <= p; j++)
            sum += a[j] * coefficient(i, p, j, u);
        c[i] = sum;
    }
}
