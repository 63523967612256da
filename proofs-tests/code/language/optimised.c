/* Compiled with optimisation: plain operations, vectors, select and phi. */
double dot(int n, const double *a, const double *b)
{
    double s = 0;
    for (int i = 0; i < n; i++)
        s += a[i] * b[i];
    return s;
}
double horner(int n, const double *a, double x)
{
    double s = a[n];
    while (n-- > 0)
        s = s * x + a[n];
    return s;
}
double largest(int n, const double *a)
{
    double m = a[0];
    for (int i = 1; i < n; i++)
        m = a[i] > m ? a[i] : m;
    return m;
}
void scale(int n, double *restrict a, double x)
{
    for (int i = 0; i < n; i++)
        a[i] *= x;
}
/* Every operation that has an instruction of its own. */
double every(double x, double y, int n, unsigned m)
{
    return x + y - x / y + (int)x + (unsigned)y + n + m + (float)(x / 3);
}
