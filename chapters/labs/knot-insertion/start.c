/* See README.md.  Any functions of your own and any header of the C library may be added. */

void insert(int n, int p, const double *u, const double *c, double tau, double *v, double *d)
{
    for (int i = 0; i <= n + p + 1; i++)
        v[i] = 0;
    for (int i = 0; i <= n; i++)
        d[i] = 0;
}

void refine(int n, int p, const double *u, const double *c, int m, const double *tau, double *v, double *d)
{
    for (int i = 0; i <= n + p + m; i++)
        v[i] = 0;
    for (int i = 0; i < n + m; i++)
        d[i] = 0;
}
