/* beta at the end of the printed range. */
void counterexample(double *x)
{
    x[0] = -7;
    x[1] = 1;
    x[1] /= 20;
}

double lowest(void) { return -5.25; }

double corrected(double t)
{
    double b = lowest(), f = 21 + 4 * b - 9 * b * t;
    for (int k = 0; k < 7; k++)
        f *= k < 2 ? t : 1 - t;
    return f;
}
