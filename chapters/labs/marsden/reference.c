/* Sums over all subsets, counted by the bits of a number. */
double coefficient(int i, int p, int j, const double *u)
{
    double sum = 0;
    int count = 0;
    for (int set = 0; set < 1 << p; set++) {
        double product = 1;
        int members = 0;
        for (int k = 0; k < p; k++)
            if (set >> k & 1) {
                product *= u[i + 1 + k];
                members++;
            }
        if (members == j) {
            sum += product;
            count++;
        }
    }
    return sum / count;
}

double greville(int i, int p, const double *u) { return coefficient(i, p, 1, u); }

void spline(int n, int p, const double *u, const double *a, double *c)
{
    for (int i = 0; i < n; i++) {
        c[i] = 0;
        for (int j = 0; j <= p; j++)
            c[i] += a[j] * coefficient(i, p, j, u);
    }
}
