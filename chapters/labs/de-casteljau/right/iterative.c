/* The triangle in one array. */
#include <string.h>

double point(int n, const double *p, double t)
{
    double b[n + 1];
    memcpy(b, p, sizeof b);
    for (int r = 1; r <= n; r++)
        for (int i = 0; i <= n - r; i++)
            b[i] = (1 - t) * b[i] + t * b[i + 1];
    return b[0];
}

void split(int n, const double *p, double t, double *left, double *right)
{
    double b[n + 1];
    memcpy(b, p, sizeof b);
    for (int r = 0; r <= n; r++) {
        left[r] = b[0];
        right[n - r] = b[n - r];
        for (int i = 0; i < n - r; i++)
            b[i] += t * (b[i + 1] - b[i]);
    }
}
