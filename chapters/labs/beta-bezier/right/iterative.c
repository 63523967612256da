/* The linear factors in a table: constant, beta, beta t. */
static const double factor[8][3] = {{1, 0, -1}, {7, 1, -5}, {21, 4, -9}, {35, 5, -5}, {35, 0, 5}, {21, -5, 9}, {7, -4, 5}, {1, -1, 1}};
static const double eight[9] = {1, 8, 28, 56, 70, 56, 28, 8, 1};

void basis(double beta, double t, double *b)
{
    for (int i = 0; i < 8; i++) {
        b[i] = factor[i][0] + beta * (factor[i][1] + factor[i][2] * t);
        for (int k = 0; k < 7; k++)
            b[i] *= k < i ? t : 1 - t;
    }
}

void points(double beta, const double *p, double *q)
{
    for (int i = 0; i <= 8; i++) {
        double low = i < 8 ? factor[i][0] + beta * factor[i][1] : 0;
        double high = i > 0 ? factor[i - 1][0] + beta * (factor[i - 1][1] + factor[i - 1][2]) : 0;
        q[i] = 0;
        if (i < 8)
            q[i] += low / eight[i] * p[i];
        if (i > 0)
            q[i] += high / eight[i] * p[i - 1];
    }
}

int allowed(double beta) { return 4 * beta >= -21 && beta <= 1; }
