/* A triangle of functions of rising degrees. */
double basis(int i, int p, const double *u, double t)
{
    double b[p + 1];
    for (int j = 0; j <= p; j++)
        b[j] = t >= u[i + j] && t < u[i + j + 1];
    for (int k = 1; k <= p; k++)
        for (int j = 0; j <= p - k; j++) {
            double s = 0;
            if (u[i + j + k] > u[i + j])
                s += (t - u[i + j]) / (u[i + j + k] - u[i + j]) * b[j];
            if (u[i + j + k + 1] > u[i + j + 1])
                s += (u[i + j + k + 1] - t) / (u[i + j + k + 1] - u[i + j + 1]) * b[j + 1];
            b[j] = s;
        }
    return b[0];
}

int span(int n, int p, const double *u, double t)
{
    int m = n - 1;
    while (m > p && (t < u[m] || u[m] == u[m + 1]))
        m--;
    return m;
}
