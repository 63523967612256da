/* The curve of degree 2 meets the line at infinity where w0 (1-t)^2 + 2 w1 t(1-t) + w2 t^2 = 0, whose discriminant is 4 (w1^2 - w0 w2). */
double kind(const double *w)
{
    double d = w[1] * w[1] - w[0] * w[2];
    return d > 0 ? 1 : d < 0 ? -1 : 0;
}

void arc(double r, double u, double *x, double *y, double *w)
{
    double c = (1 - u * u) / (1 + u * u), s = 2 * u / (1 + u * u);
    x[0] = r * c, y[0] = -r * s, w[0] = 1;
    x[1] = r * c + r * s * s / c, y[1] = 0, w[1] = c; /* where the tangents at both ends meet */
    x[2] = r * c, y[2] = r * s, w[2] = 1;
}

double shoulder(const double *w) { return w[1] / (w[1] + (w[0] + w[2]) / 2); }
