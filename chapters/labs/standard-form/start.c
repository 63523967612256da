/* See README.md.  Any functions of your own and any header of the C library may be added. */

void scale(int n, const double *w, double a, double *v)
{
    for (int i = 0; i <= n; i++)
        v[i] = 0;
}

double invariant(int n, const double *w, int i)
{
    return 0;
}

double parameter(double a, double t)
{
    return 0;
}
