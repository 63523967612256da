/* See README.md.  Any functions of your own and any header of the C library may be added. */

double greville(int i, int p, const double *u)
{
    return 0;
}

double coefficient(int i, int p, int j, const double *u)
{
    return 0;
}

void spline(int n, int p, const double *u, const double *a, double *c)
{
    for (int i = 0; i < n; i++)
        c[i] = 0;
}
