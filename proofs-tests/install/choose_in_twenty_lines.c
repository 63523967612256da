/* Points around a circle with the radius 5, about (1, 2): what curve they ask for. */
#include <cagd_fit.h>
#include <stdio.h>
int main(void)
{
    const double points[] = {6, 2, 5, 5, 4, 6, 1, 7, -2, 6, -3, 5, -4, 2, -3, -1, -2, -2, 1, -3, 4, -2, 5, -1};
    cagd_fit_data data = {12, 2, points, NULL};
    cagd_fit_options options = cagd_fit_defaults();
    cagd_fit_choices choices = cagd_fit_choices_all();
    cagd_fit_result *fit;
    cagd_status status = cagd_fit_choose(&data, &options, &choices, &fit, NULL);
    if (status != CAGD_OK)
        return puts(cagd_status_text(status)), 1;
    const cagd_fit_ellipse *e = &fit->found.ellipse;
    printf("%s, radius %.9f\n", fit->found.candidate[0].name, e->radius.value);
    for (int j = 0; j < fit->curve.count; j++)
        printf("%.6f %.6f %.6f\n", fit->curve.points[2 * j], fit->curve.points[2 * j + 1], fit->curve.weights[j]);
    return cagd_fit_free(fit), 0;
}
