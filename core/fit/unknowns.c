#include "core/fit/unknowns.h"

#include <math.h>

/* phi(y) = 1 + y, from -1/2 on; below it falls like an exponential function and stays positive. */
static double phi(double y) { return y >= -0.5 ? 1 + y : exp(2 * y + 1) / 2; }
static double phi_inverse(double x) { return x >= 0.5 ? x - 1 : (log(2 * x) - 1) / 2; }

double fit_weight_slope(double y) { return y >= -0.5 ? 1 : exp(2 * y + 1); }
double fit_weight_bend(double y) { return y >= -0.5 ? 0 : 2; }

void fit_unknowns_to_curve(const fit_problem *p, const fit_curve *base, const double x[], fit_curve *curve)
{
    for (int k = 0; k < p->unknowns; k++) { /* the weight of a point before its coordinates */
        int j = p->unknown[k].index, c = j * p->dim + p->unknown[k].coordinate;
        double *w = &curve->weights[j], b = base->weights[j];
        if (!p->unknown[k].is_weight)
            curve->points[c] = base->points[c] + x[k] / *w;
        else if (x[k] <= phi_inverse(p->low / b))
            *w = p->low;
        else if (x[k] >= phi_inverse(p->high / b))
            *w = p->high;
        else
            *w = fmin(fmax(b * phi(x[k]), p->low), p->high);
    }
    fit_curve_update(curve);
}

void fit_unknowns_of_curve(const fit_problem *p, const fit_curve *base, const fit_curve *curve, double x[])
{
    for (int k = 0; k < p->unknowns; k++) {
        int j = p->unknown[k].index, c = j * p->dim + p->unknown[k].coordinate;
        double w = curve->weights[j];
        x[k] = p->unknown[k].is_weight ? phi_inverse(w / base->weights[j]) : w * (curve->points[c] - base->points[c]);
    }
}

void fit_unknowns_bounds(const fit_problem *p, const fit_curve *base, double low[], double high[])
{
    for (int k = 0; k < p->unknowns; k++) {
        double b = base->weights[p->unknown[k].index];
        low[k] = p->unknown[k].is_weight ? phi_inverse(p->low / b) : -INFINITY;
        high[k] = p->unknown[k].is_weight ? phi_inverse(p->high / b) : INFINITY;
    }
}

int fit_unknown_is_on_bound(const fit_problem *p, int k, const fit_curve *curve)
{
    double w = curve->weights[p->unknown[k].index];
    return p->unknown[k].is_weight && (w == p->low || w == p->high);
}
