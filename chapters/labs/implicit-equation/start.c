/* See README.md.  Any functions of your own and any header of the C library may be added. */

double quadratic(const double *x, const double *y, const double *w, double X, double Y)
{
    return 0;
}

double cubic(const double *x, const double *y, const double *w, double X, double Y)
{
    return 0;
}
