/* See README.md.  Any functions of your own and any header of the C library may be added. */

void elevate(int n, const double *p, double *q)
{
    for (int i = 0; i <= n + 1; i++)
        q[i] = 0;
}

void lower(int n, const double *q, double *p)
{
    for (int i = 0; i <= n; i++)
        p[i] = 0;
}
