/* With other operations: the functions as Bezier curves of degree 8 whose points are 0 but for two. */
void points(double beta, const double *p, double *q)
{
    static const int a[9] = {0, 1, 4, 5, 0, -5, -4, -1, 0}, c[8] = {1, 7, 21, 35, 35, 21, 7, 1};
    double scaled[9] = {0}, choose = 1;
    for (int i = 0; i < 8; i++) {
        scaled[i] += (c[i] + beta * a[i]) * p[i];
        scaled[i + 1] += (c[i] - beta * a[i + 1]) * p[i];
    }
    for (int i = 0; i <= 8; i++) {
        q[i] = scaled[i] / choose;
        choose = choose * (8 - i) / (i + 1);
    }
}

void basis(double beta, double t, double *b)
{
    for (int i = 0; i < 8; i++) {
        double p[8] = {0}, q[9];
        p[i] = 1;
        points(beta, p, q);
        for (int r = 8; r > 0; r--)
            for (int k = 0; k < r; k++)
                q[k] += t * (q[k + 1] - q[k]);
        b[i] = q[0];
    }
}

int allowed(double beta) { return !(beta > 1 || beta < -5.25); }
