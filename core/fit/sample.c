#include "core/fit/sample.h"

#include "core/fit/feet.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void fit_sample_free(fit_problem *s)
{
    free(s->Q);
    free(s->precision);
}

/* The problem with so many points, which are 0 and have the precision 0.  Returns 0 when there is no memory. */
static int sample_new(const fit_problem *p, int points, fit_problem *s)
{
    *s = *p;
    s->points = points;
    s->Q = calloc((size_t)points * (size_t)p->dim, sizeof *s->Q);
    s->precision = calloc((size_t)points, sizeof *s->precision);
    if (s->Q == NULL || s->precision == NULL) {
        fit_sample_free(s);
        return 0;
    }
    return 1;
}

int fit_sample_every(const fit_problem *p, int stride, fit_problem *s)
{
    size_t dim = (size_t)p->dim;
    int last = p->points - 1;
    if (!sample_new(p, last / stride + 1 + (last % stride != 0), s))
        return 0;
    s->smooth *= (double)s->points / p->points; /* against fewer points */
    for (int k = 0; k < s->points; k++) {
        int i = k < s->points - 1 ? k * stride : last;
        memcpy(s->Q + (size_t)k * dim, p->Q + (size_t)i * dim, dim * sizeof *s->Q);
        s->precision[k] = p->precision[i];
    }
    for (int end = 0; end < 2; end++) { /* among the points of the sample, or nowhere */
        int i = p->end_point[end];
        s->end_point[end] = i < 0 ? -1 : i == last ? s->points - 1 : i % stride == 0 ? i / stride : -1;
    }
    fit_problem_look_at_points(s);
    return 1;
}

/* Sums over the points of every group, weighted with the squares of their precision: of Q_i - C(t_i) in Q, of t_i
 * less the start of the domain in feet, and of the weights in precision. */
static void sum_groups(const fit_problem *p, const fit_curve *curve, const double t[], int groups, fit_problem *s,
                       double feet[])
{
    const int dim = p->dim, last = groups - 1;
    const double start = fit_curve_start(curve), part = (fit_curve_end(curve) - start) / groups;
    double C[3];
    for (int g = 0; g <= last; g++)
        feet[g] = 0;
    for (int i = 0; i < p->points; i++) {
        double weight = p->precision[i] * p->precision[i];
        if (fit_end_of(p, i) >= 0)
            continue;
        int g = (int)((t[i] - start) / part);
        g = g < 0 ? 0 : g < last ? g : last;
        fit_curve_point(curve, t[i], C);
        for (int c = 0; c < dim; c++)
            s->Q[g * dim + c] += weight * (p->Q[(size_t)i * (size_t)dim + (size_t)c] - C[c]);
        feet[g] += weight * (t[i] - start);
        s->precision[g] += weight;
    }
}

/* The points of the ends as they are, behind the means. */
static void keep_end_points(const fit_problem *p, const fit_curve *curve, fit_problem *s, double feet[])
{
    const size_t dim = (size_t)p->dim;
    for (int end = 0; end < 2; end++) {
        const int i = p->end_point[end], at = s->points;
        if (i < 0)
            continue;
        memcpy(s->Q + (size_t)at * dim, fit_point(p, i), dim * sizeof *s->Q);
        s->precision[at] = p->precision[i];
        feet[at] = end == 0 ? fit_curve_start(curve) : fit_curve_end(curve);
        s->end_point[end] = s->points++;
    }
}

/* Means from the sums; groups without points are left out. */
static void divide_groups(const fit_curve *curve, int groups, fit_problem *s, double feet[])
{
    const int dim = s->dim;
    const double start = fit_curve_start(curve);
    double C[3];
    int count = 0;
    for (int g = 0; g < groups; g++) {
        double weight = s->precision[g];
        if (!(weight > 0))
            continue;
        feet[count] = start + feet[g] / weight;
        fit_curve_point(curve, feet[count], C);
        for (int c = 0; c < dim; c++)
            s->Q[count * dim + c] = C[c] + s->Q[g * dim + c] / weight;
        s->precision[count++] = sqrt(weight);
    }
    s->points = count;
}

int fit_sample_means(const fit_problem *p, const fit_curve *curve, const double t[], int groups, fit_problem *s,
                     double feet[])
{
    if (!sample_new(p, groups + 2, s))
        return 0;
    sum_groups(p, curve, t, groups, s, feet);
    divide_groups(curve, groups, s, feet);
    keep_end_points(p, curve, s, feet);
    fit_problem_look_at_points(s);
    return 1;
}
