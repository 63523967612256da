double weight(int m, const double *p, const double *t, const double *q)
{
    double ab = 0, bb = 0;
    for (int j = 0; j < m; j++) {
        double s = 1 - t[j];
        double a = s * s * (p[0] - q[j]) + t[j] * t[j] * (p[2] - q[j]);
        double b = 2 * s * t[j] * (p[1] - q[j]);
        ab += a * b;
        bb += b * b;
    }
    return -ab / bb;
}

void weights(int m, const double *p, const double *t, const double *q, double *w)
{
    double n[2][2] = {{0, 0}, {0, 0}}, r[2] = {0, 0};
    for (int j = 0; j < m; j++) {
        double s = 1 - t[j];
        double b[2] = {3 * s * s * t[j] * (p[1] - q[j]), 3 * s * t[j] * t[j] * (p[2] - q[j])};
        double a = s * s * s * (p[0] - q[j]) + t[j] * t[j] * t[j] * (p[3] - q[j]);
        for (int i = 0; i < 2; i++) {
            for (int k = 0; k < 2; k++)
                n[i][k] += b[i] * b[k];
            r[i] -= a * b[i];
        }
    }
    double d = n[0][0] * n[1][1] - n[0][1] * n[1][0];
    w[0] = (r[0] * n[1][1] - r[1] * n[0][1]) / d;
    w[1] = (n[0][0] * r[1] - n[1][0] * r[0]) / d;
}
