/* See README.md.  Any functions of your own and any header of the C library may be added. */

double kind(const double *w)
{
    return 2;
}

void arc(double r, double u, double *x, double *y, double *w)
{
    for (int i = 0; i < 3; i++)
        x[i] = y[i] = w[i] = 0;
}

double shoulder(const double *w)
{
    return 0;
}
