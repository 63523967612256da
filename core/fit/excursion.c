#include "core/fit/cagd_fit.h"

#include <math.h>
#include <stddef.h>

enum { PER_PIECE = 256 }; /* sides of the inscribed polygon over a piece */

static double distance(int dim, const double a[], const double b[])
{
    double sum = 0;
    for (int c = 0; c < dim; c++)
        sum += (a[c] - b[c]) * (a[c] - b[c]);
    return sqrt(sum);
}

static double length_of_points(const cagd_fit_data *data)
{
    double length = 0;
    for (int i = 1; i < data->count; i++) {
        const double *Q = data->points + (size_t)i * (size_t)data->dim;
        length += distance(data->dim, Q - data->dim, Q);
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
    return length_of_curve(&near) / length_of_points(data);
}
