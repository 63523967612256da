/* B_i = C(7,i) s^(7-i) t^i + beta (a_i s^(8-i) t^i - a_(i+1) s^(7-i) t^(i+1)), a_i = C(5,i-1) - C(5,i-2). */
static double choose(int n, int k) { return k < 0 || k > n ? 0 : k == 0 ? 1 : choose(n - 1, k - 1) * n / k; }

static double shift(int i) { return choose(5, i - 1) - choose(5, i - 2); }

static double term(int a, int b, double t)
{
    double x = 1;
    for (int k = 0; k < a; k++)
        x *= 1 - t;
    for (int k = 0; k < b; k++)
        x *= t;
    return x;
}

void basis(double beta, double t, double *b)
{
    for (int i = 0; i < 8; i++)
        b[i] = choose(7, i) * term(7 - i, i, t) + beta * (shift(i) * term(8 - i, i, t) - shift(i + 1) * term(7 - i, i + 1, t));
}

/* s^(7-i) t^i = s^(8-i) t^i + s^(7-i) t^(i+1) */
void points(double beta, const double *p, double *q)
{
    for (int i = 0; i < 9; i++)
        q[i] = 0;
    for (int i = 0; i < 8; i++) {
        q[i] += (choose(7, i) + beta * shift(i)) / choose(8, i) * p[i];
        q[i + 1] += (choose(7, i) - beta * shift(i + 1)) / choose(8, i + 1) * p[i];
    }
}

/* A linear factor is not negative on [0, 1] when it is not at the ends. */
int allowed(double beta)
{
    for (int i = 0; i < 8; i++)
        if (choose(7, i) + beta * shift(i) < 0 || choose(7, i) - beta * shift(i + 1) < 0)
            return 0;
    return 1;
}
