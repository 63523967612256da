/* The triangle as a recursion: a point of the curve is between points of two curves of one degree less. */
double point(int n, const double *p, double t)
{
    if (n == 0)
        return p[0];
    return (1 - t) * point(n - 1, p, t) + t * point(n - 1, p + 1, t);
}

void split(int n, const double *p, double t, double *left, double *right)
{
    for (int k = 0; k <= n; k++) {
        left[k] = point(k, p, t);
        right[k] = point(n - k, p + k, t);
    }
}
