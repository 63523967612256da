#include "core/fit/cagd_fit.h"

#include <math.h>
#include <stddef.h>

enum {
    PER_PIECE = 256,  /* sides of the inscribed polygon over a piece       */
    FEWEST_MEANS = 16 /* that the polygon of the points is made of at least */
};

static double distance(int dim, const double a[], const double b[])
{
    double sum = 0;
    for (int c = 0; c < dim; c++)
        sum += (a[c] - b[c]) * (a[c] - b[c]);
    return sqrt(sum);
}

/* The length of the polygon of the means of each `size` points in their order, closed if the curve is; *steps: of its sides. */
static double length_of_means(const cagd_fit_data *data, int size, int closed, int *steps)
{
    const int n = data->count, groups = n / size, dim = data->dim;
    double length = 0, first[3] = {0}, before[3] = {0};
    for (int g = 0; g < groups; g++) {
        const int low = (int)((long)n * g / groups), high = (int)((long)n * (g + 1) / groups);
        double mean[3] = {0};
        for (int i = low; i < high; i++)
            for (int c = 0; c < dim; c++) /* from the first point, which loses nothing far from the origin */
                mean[c] += (data->points[(size_t)i * (size_t)dim + (size_t)c] - data->points[c]) / (high - low);
        length += g > 0 ? distance(dim, before, mean) : 0;
        for (int c = 0; c < dim; c++)
            before[c] = mean[c], first[c] = g > 0 ? first[c] : mean[c];
    }
    *steps = groups - 1 + closed;
    return length + (closed ? distance(dim, before, first) : 0);
}

/* Of the means of as few points as makes the sides four times as long as the errors of their ends, which grow with the root mean square of the
 * distances: a polygon of neighbours that scatter by more than they are apart is as long as one likes. */
static double length_of_points(const cagd_fit_data *data, const cagd_fit_result *r)
{
    double length = 0;
    for (int size = 1, steps; size == 1 || data->count / size >= FEWEST_MEANS; size *= 2) {
        length = length_of_means(data, size, r->period > 0, &steps);
        if (length >= 4 * steps * r->rms * sqrt(2.0 / size))
            break;
    }
    return length;
}

static double length_of_curve(const cagd_spline *curve)
{
    double length = 0, P[2][CAGD_MAX_DIM];
    for (int mu = curve->degree; mu < curve->count; mu++) {
        const double a = curve->knots[mu], b = curve->knots[mu + 1];
        for (int i = 0; i <= PER_PIECE && a < b; i++) {
            double t = i < PER_PIECE ? a + (b - a) * i / PER_PIECE : b;
            if (cagd_spline_point(curve, t, i < PER_PIECE ? CAGD_RIGHT : CAGD_LEFT, P[i % 2]) != CAGD_OK)
                return NAN;
            length += i > 0 ? distance(curve->dim, P[0], P[1]) : 0;
        }
    }
    return length;
}

double cagd_fit_length_ratio(const cagd_fit_data *data, const cagd_fit_result *result)
{
    cagd_spline near = result->curve; /* the same curve where binary64 is finest */
    near.points = result->relative;
    return length_of_curve(&near) / length_of_points(data, result);
}
