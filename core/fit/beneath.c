#include "core/fit/beneath.h"

#include <float.h>
#include <math.h>
#include <stddef.h>

static const double COARSE = 0.02; /* of the extent: coordinates of one or two digits are no rounded ones */

double fit_extent_of(const cagd_fit_data *data, double middle[])
{
    double extent = 0;
    const int dim = data->dim;
    for (int c = 0; c < dim; c++) {
        double low = data->points[c], high = low;
        for (int i = 1; i < data->count; i++) {
            low = fmin(low, data->points[(size_t)i * (size_t)dim + (size_t)c]);
            high = fmax(high, data->points[(size_t)i * (size_t)dim + (size_t)c]);
        }
        middle[c] = low / 2 + high / 2;
        extent = hypot(extent, high - low);
    }
    return extent;
}

/* The main axis of the points about their mean, a unit vector: the eigenvector of sum (Q_i - m)(Q_i - m)^T with the largest eigenvalue, by powers. */
static void main_axis(const cagd_fit_data *data, double mean[3], double axis[3])
{
    enum { POWERS = 60 };
    const int dim = data->dim;
    double A[3][3] = {{0}}, low[3];
    fit_extent_of(data, low); /* near the points, so that nothing is lost far from the origin */
    for (int c = 0; c < dim; c++)
        mean[c] = 0, axis[c] = 0;
    for (int i = 0; i < data->count; i++)
        for (int c = 0; c < dim; c++)
            mean[c] += (data->points[i * dim + c] - low[c]) / data->count;
    int widest = 0;
    for (int c = 0; c < dim; c++)
        mean[c] += low[c];
    for (int i = 0; i < data->count; i++)
        for (int a = 0; a < dim; a++)
            for (int b = 0; b < dim; b++)
                A[a][b] += (data->points[i * dim + a] - mean[a]) * (data->points[i * dim + b] - mean[b]);
    for (int c = 1; c < dim; c++)
        widest = A[c][c] > A[widest][widest] ? c : widest;
    axis[widest] = 1;
    for (int k = 0; k < POWERS; k++) {
        double next[3] = {0}, length = 0;
        for (int a = 0; a < dim; a++) {
            for (int b = 0; b < dim; b++)
                next[a] += A[a][b] * axis[b];
            length = hypot(length, next[a]);
        }
        for (int c = 0; c < dim && length > 0; c++)
            axis[c] = next[c] / length;
    }
}

/* Twice the largest distance of a point from the main axis. */
static double width_of(const cagd_fit_data *data)
{
    const int dim = data->dim;
    double mean[3], axis[3], farthest = 0;
    main_axis(data, mean, axis);
    for (int i = 0; i < data->count; i++) {
        double along = 0, square = 0;
        for (int c = 0; c < dim; c++)
            along += (data->points[i * dim + c] - mean[c]) * axis[c];
        for (int c = 0; c < dim; c++) {
            const double across = data->points[i * dim + c] - mean[c] - along * axis[c];
            square += across * across;
        }
        farthest = fmax(farthest, sqrt(square));
    }
    return 2 * farthest;
}

/* The unit of the last decimal place of the coordinates, at most nine behind the point; 0 where there are more. */
static double unit_of(const cagd_fit_data *data)
{
    double scale = 1;
    for (int places = 0; places <= 9; places++, scale *= 10) {
        int k = 0;
        while (k < data->count * data->dim && fabs(data->points[k] * scale - rint(data->points[k] * scale)) <=
                                                  4 * DBL_EPSILON * fabs(data->points[k] * scale))
            k++;
        if (k == data->count * data->dim)
            return 1 / scale;
    }
    return 0;
}

/* Whether rounding to the places that are written explains all distances.  Which side of the curve neighbours lie on is that of rounding then,
 * which goes on for many where the curve is nearly along an axis. */
static int are_rounding(const cagd_fit_data *data, const cagd_fit_result *r)
{
    double middle[3];
    const double unit = unit_of(data);
    return unit <= COARSE * fit_extent_of(data, middle) && r->largest <= unit * sqrt(data->dim) / 2;
}

/* Whether every point keeps within its standard deviation. */
static int are_within_deviations(const cagd_fit_data *data, const cagd_fit_result *r)
{
    int within = data->sigma != NULL;
    for (int i = 0; within && i < r->count; i++)
        within = fabs(r->distances[i]) <= data->sigma[i];
    return within;
}

cagd_fit_beneath fit_beneath(const cagd_fit_data *data, const cagd_fit_result *r)
{
    double middle[3];
    if (are_rounding(data, r))
        return CAGD_FIT_BENEATH_DIGITS;
    if (data->sigma != NULL)
        return are_within_deviations(data, r) ? CAGD_FIT_BENEATH_DEVIATIONS : CAGD_FIT_BENEATH_NOTHING;
    return r->largest <= FIT_OF_EXTENT * fit_extent_of(data, middle) && r->largest <= FIT_OF_WIDTH * width_of(data)
               ? CAGD_FIT_BENEATH_SIZE
               : CAGD_FIT_BENEATH_NOTHING;
}
