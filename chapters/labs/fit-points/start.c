/* See README.md.  Any functions of your own and any header of the C library may be added. */

double middle(int m, const double *t, const double *q)
{
    return 0;
}

void inside(int m, const double *t, const double *q, double *p)
{
    p[0] = p[1] = 0;
}

double squares(int m, const double *t, const double *q, const double *p)
{
    return 0;
}
