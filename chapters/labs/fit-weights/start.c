/* See README.md.  Any functions of your own and any header of the C library may be added. */

double weight(int m, const double *p, const double *t, const double *q)
{
    return 0;
}

void weights(int m, const double *p, const double *t, const double *q, double *w)
{
    w[0] = w[1] = 0;
}
