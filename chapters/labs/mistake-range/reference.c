/* 21 + 4 beta < 0 just when beta < -21/4, and then B2 is negative near t = 0: for beta = -6 where -3 + 54 t < 0. */
void counterexample(double *x)
{
    x[0] = -7;
    x[1] = 1.0 / 10;
}

double lowest(void) { return -21.0 / 4; }

double corrected(double t)
{
    double s = 1 - t;
    return 189.0 / 4 * t * t * t * s * s * s * s * s;
}
