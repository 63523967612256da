/* See README.md.  Any functions of your own and any header of the C library may be added. */

void differences(int n, const double *x, const double *f, double *d)
{
    for (int i = 0; i <= n; i++)
        d[i] = 0;
}

double value(int n, const double *x, const double *f, double t)
{
    return 0;
}
