/* See README.md.  Any functions of your own and any header of the C library may be added. */

double hermite(double a, double b, const double *y, const double *m, double t)
{
    return 0;
}

void slopes(int n, const double *u, const double *y, double first, double last, double *m)
{
    for (int i = 0; i <= n; i++)
        m[i] = 0;
}
