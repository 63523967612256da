/* With other operations: powers of t. */
void counterexample(double *x)
{
    double beta = -13;
    x[0] = (beta + 1) / 2;
    x[1] = 2.0 / 50;
}

double lowest(void) { return (1 - 22.0) / (1 + 3); }

double corrected(double t)
{
    return 47.25 * (t * t * t) * (1 + t * (-5 + t * (10 + t * (-10 + t * (5 - t)))));
}
