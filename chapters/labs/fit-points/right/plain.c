double middle(int m, const double *t, const double *q)
{
    double ab = 0, bb = 0;
    for (int j = 1; j < m - 1; j++) {
        double s = 1 - t[j], b = 2 * s * t[j];
        double a = q[j] - s * s * q[0] - t[j] * t[j] * q[m - 1];
        ab += a * b;
        bb += b * b;
    }
    return ab / bb;
}

void inside(int m, const double *t, const double *q, double *p)
{
    double n[2][2] = {{0, 0}, {0, 0}}, r[2] = {0, 0};
    for (int j = 1; j < m - 1; j++) {
        double s = 1 - t[j];
        double b[2] = {3 * s * s * t[j], 3 * s * t[j] * t[j]};
        double a = q[j] - s * s * s * q[0] - t[j] * t[j] * t[j] * q[m - 1];
        for (int i = 0; i < 2; i++) {
            for (int k = 0; k < 2; k++)
                n[i][k] += b[i] * b[k];
            r[i] += a * b[i];
        }
    }
    double d = n[0][0] * n[1][1] - n[0][1] * n[1][0];
    p[0] = (r[0] * n[1][1] - r[1] * n[0][1]) / d;
    p[1] = (n[0][0] * r[1] - n[1][0] * r[0]) / d;
}

double squares(int m, const double *t, const double *q, const double *p)
{
    double sum = 0;
    for (int j = 0; j < m; j++) {
        double s = 1 - t[j];
        double e = s * (s * p[0] + t[j] * p[1]) + t[j] * (s * p[1] + t[j] * p[2]) - q[j];
        sum += e * e;
    }
    return sum;
}
