/* See README.md.  Any functions of your own and any header of the C library may be added. */

double point(int n, const double *p, const double *w, double t)
{
    return 0;
}

void homogeneous(int n, const double *p, const double *w, double t, double *h)
{
    h[0] = h[1] = 0;
}

void level(int n, int r, const double *p, const double *w, double t, double *q, double *v)
{
    for (int i = 0; i <= n - r; i++)
        q[i] = v[i] = 0;
}
