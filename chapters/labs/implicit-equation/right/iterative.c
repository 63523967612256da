/* Points moved so that X is the origin: every determinant has two rows. */
double quadratic(const double *x, const double *y, const double *w, double X, double Y)
{
    double a[3], b[3], d[3];
    for (int i = 0; i < 3; i++) {
        a[i] = x[i] - X;
        b[i] = y[i] - Y;
    }
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        d[i] = a[j] * b[k] - a[k] * b[j];
    }
    return w[0] * w[2] * d[1] * d[1] - 4 * w[1] * w[1] * d[0] * d[2];
}

double cubic(const double *x, const double *y, const double *w, double X, double Y)
{
    double a[4], b[4], m[3][3], f[4] = {w[0], 3 * w[1], 3 * w[2], w[3]};
    for (int i = 0; i < 4; i++) {
        a[i] = f[i] * (x[i] - X);
        b[i] = f[i] * (y[i] - Y);
    }
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            m[i][j] = 0;
            for (int k = 0; k <= i && k <= j; k++) {
                int l = i + j + 1 - k;
                if (l <= 3)
                    m[i][j] += a[k] * b[l] - a[l] * b[k];
            }
        }
    double det = 0;
    for (int k = 0; k < 3; k++) {
        int p = (k + 1) % 3, q = (k + 2) % 3;
        det += m[0][k] * (m[1][p] * m[2][q] - m[1][q] * m[2][p]);
    }
    return det;
}
