/* With other operations: the quadratic as the same resultant of degree 2, freed of its sign; the symmetric determinant written out. */
static double edge(const double *x, const double *y, const double *f, int i, int j, double X, double Y)
{
    return f[i] * f[j] * ((x[i] - X) * (y[j] - Y) - (x[j] - X) * (y[i] - Y));
}

double quadratic(const double *x, const double *y, const double *w, double X, double Y)
{
    double one[3] = {1, 1, 1};
    double a = edge(x, y, one, 0, 1, X, Y), b = edge(x, y, one, 0, 2, X, Y), c = edge(x, y, one, 1, 2, X, Y);
    return w[0] * w[2] * b * b - 4 * w[1] * w[1] * a * c;
}

double cubic(const double *x, const double *y, const double *w, double X, double Y)
{
    double f[4] = {w[0], 3 * w[1], 3 * w[2], w[3]};
    double a = edge(x, y, f, 0, 1, X, Y), b = edge(x, y, f, 0, 2, X, Y), c = edge(x, y, f, 0, 3, X, Y),
           d = c + edge(x, y, f, 1, 2, X, Y), e = edge(x, y, f, 1, 3, X, Y), g = edge(x, y, f, 2, 3, X, Y);
    return a * d * g + 2 * b * c * e - a * e * e - b * b * g - c * c * d;
}
