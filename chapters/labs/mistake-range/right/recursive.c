/* By a recursion of powers. */
static double power(double x, int n) { return n == 0 ? 1 : x * power(x, n - 1); }

double lowest(void) { return -21 / 4.0; }

void counterexample(double *x)
{
    x[0] = -6;
    x[1] = 1.0 / 20;
}

double corrected(double t) { return (21 + 4 * lowest() - 9 * lowest() * t) * power(1 - t, 5) * power(t, 2); }
