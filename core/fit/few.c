#include "core/fit/few.h"

#include "core/fit/feet.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void fit_few_free(fit_problem *p)
{
    free(p->Q);
    free(p->precision);
}

int fit_few_thinned(const fit_problem *p, int stride, fit_problem *few)
{
    size_t dim = (size_t)p->dim;
    *few = *p;
    few->points = (p->points - 1) / stride + 1 + ((p->points - 1) % stride != 0);
    few->Q = malloc((size_t)few->points * dim * sizeof *few->Q);
    few->precision = malloc((size_t)few->points * sizeof *few->precision);
    if (few->Q == NULL || few->precision == NULL) {
        fit_few_free(few);
        return 0;
    }
    for (int k = 0; k < few->points; k++) {
        int i = k < few->points - 1 ? k * stride : p->points - 1;
        memcpy(few->Q + (size_t)k * dim, p->Q + (size_t)i * dim, dim * sizeof *few->Q);
        few->precision[k] = p->precision[i];
    }
    fit_problem_round(few);
    return 1;
}

int fit_few_means(const fit_problem *p, const fit_curve *curve, const double t[], int groups, fit_problem *few,
                  double feet[])
{
    int dim = p->dim, count = 0;
    double start = fit_curve_start(curve), part = (fit_curve_end(curve) - start) / groups, D[9];
    *few = *p;
    few->Q = calloc((size_t)groups * (size_t)dim, sizeof *few->Q);
    few->precision = calloc((size_t)groups, sizeof *few->precision);
    if (few->Q == NULL || few->precision == NULL) {
        fit_few_free(few);
        return 0;
    }
    for (int g = 0; g < groups; g++)
        feet[g] = 0;
    for (int i = 0; i < p->points; i++) {
        double share = p->precision[i] * p->precision[i];
        int g = (int)((t[i] - start) / part);
        g = g < 0 ? 0 : g < groups ? g : groups - 1;
        fit_curve_derivatives(curve, t[i], D);
        for (int c = 0; c < dim; c++)
            few->Q[g * dim + c] += share * (p->Q[(size_t)i * (size_t)dim + (size_t)c] - D[c]);
        feet[g] += share * (t[i] - start);
        few->precision[g] += share;
    }
    for (int g = 0; g < groups; g++) {
        double all = few->precision[g];
        if (!(all > 0))
            continue;
        feet[count] = start + feet[g] / all;
        fit_curve_derivatives(curve, feet[count], D);
        for (int c = 0; c < dim; c++)
            few->Q[count * dim + c] = D[c] + few->Q[g * dim + c] / all;
        few->precision[count++] = sqrt(all);
    }
    few->points = count;
    fit_problem_round(few);
    return 1;
}
