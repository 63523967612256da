#include "core/fit/cagd_fit.h"

#include <float.h>
#include <math.h>
#include <stddef.h>

/* Places between two knots that are looked at, for each degree: |C'|^2 is N/w^4, N of degree 4p-4 and w of degree p,
 * hence has less than 8p places where it is stationary, every other one a minimum. */
enum { PER_DEGREE = 16 };

/* C'.C'' at t, half the derivative of |C'|^2; also the squares of both. */
static double change_of_speed(const cagd_spline *curve, double t, cagd_side side, double squares[2])
{
    double D[3 * 3], product = 0;
    squares[0] = squares[1] = 0;
    if (cagd_spline_derivatives(curve, t, side, 2, D) != CAGD_OK)
        return NAN;
    for (int c = 0; c < curve->dim; c++) {
        double first = D[curve->dim + c], second = D[2 * curve->dim + c];
        product += first * second;
        squares[0] += first * first;
        squares[1] += second * second;
    }
    return product;
}

/* The zero of C'.C'' between low and high, where it changes from - to +, to the last bit. */
static double slowest(const cagd_spline *curve, double low, double high, double squares[2])
{
    for (;;) {
        double middle = low + (high - low) / 2;
        if (!(low < middle && middle < high))
            break;
        if (change_of_speed(curve, middle, CAGD_RIGHT, squares) < 0)
            low = middle;
        else
            high = middle;
    }
    double other[2];
    change_of_speed(curve, low, CAGD_RIGHT, other);
    change_of_speed(curve, high, CAGD_LEFT, squares);
    if (other[0] < squares[0]) {
        squares[0] = other[0];
        squares[1] = other[1];
        return low;
    }
    return high;
}

/* What a coordinate of the curve is off by: p steps of de Casteljau on homogeneous coordinates and a division. */
static double rounding(const cagd_spline *curve)
{
    double size = 0;
    for (int m = 0; m < curve->count * curve->dim; m++)
        size = fmax(size, fabs(curve->points[m]));
    return (2 * curve->degree + 2) * DBL_EPSILON * size;
}

int cagd_fit_has_cusp(const cagd_fit_result *result, double *t)
{
    cagd_spline near = result->curve; /* the same curve where binary64 is finest */
    const cagd_spline *curve = &near;
    near.points = result->relative != NULL ? result->relative : near.points;
    double smallest = fmax(result->rms, rounding(curve)), squares[2];
    int found = 0, places = PER_DEGREE * curve->degree;
    for (int mu = curve->degree; mu < curve->count; mu++) {
        double a = curve->knots[mu], b = curve->knots[mu + 1];
        for (int i = 0; i < places && a < b; i++) {
            double low = a + (b - a) * i / places, high = i + 1 < places ? a + (b - a) * (i + 1) / places : b;
            if (!(change_of_speed(curve, low, CAGD_RIGHT, squares) < 0) ||
                !(change_of_speed(curve, high, CAGD_LEFT, squares) >= 0))
                continue;
            double at = slowest(curve, low, high, squares), radius = squares[0] / sqrt(squares[1]);
            if (squares[1] > 0 && radius <= smallest) {
                smallest = radius;
                *t = at;
                found = 1;
            }
        }
    }
    return found;
}
