/* See README.md.  Numbers are written as 3 or -13.0 / 2. */

void counterexample(double *x)
{
    x[0] = 0; /* beta */
    x[1] = 0; /* t    */
}

double lowest(void)
{
    return 0;
}

double corrected(double t)
{
    return 0;
}
