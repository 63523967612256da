/* See README.md.  Any functions of your own and any header of the C library may be added. */

double point(int n, const double *p, double t)
{
    return 0;
}

void split(int n, const double *p, double t, double *left, double *right)
{
    for (int i = 0; i <= n; i++)
        left[i] = right[i] = 0;
}
