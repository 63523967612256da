/* The point of a quarter circle that halves its parameter: (3/5, 4/5). */
#include <cagd.h>
#include <stdio.h>
int main(void)
{
    const double points[] = {1, 0, 1, 1, 0, 1}, weights[] = {1, 1, 2};
    double p[2];
    cagd_status status = cagd_rational_point(2, 2, points, weights, 0.5, p);
    return status != CAGD_OK ? puts(cagd_status_text(status)), 1 : (printf("%.15g %.15g\n", p[0], p[1]), 0);
}
