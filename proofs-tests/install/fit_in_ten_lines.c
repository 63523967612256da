/* Six points of a circle: the weight of the quarter circle, sqrt(1/2). */
#include <cagd_fit.h>
#include <stdio.h>
int main(void)
{
    const double points[] = {1, 0, 0.96, 0.28, 0.8, 0.6, 0.6, 0.8, 0.28, 0.96, 0, 1};
    cagd_fit_data data = {6, 2, points, NULL};
    cagd_fit_options options = cagd_fit_defaults();
    cagd_fit_result *fit;
    cagd_status status = cagd_fit(&data, &options, &fit, NULL);
    return status ? puts(cagd_status_text(status)), 1 : (printf("%.9f\n", fit->curve.weights[1]), cagd_fit_free(fit), 0);
}
