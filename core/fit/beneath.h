/* beneath.h -- distances that are smaller than what the points are given to.
 *
 * Structure in such distances says nothing about the thing that was measured.  All of them are beneath
 *
 *   digits       half the diagonal of a cell, sqrt(dim)/2 units of the last decimal place that is written: rounding moves no point farther
 *   deviations   the given standard deviations: of 16 errors that have these all are so once in 450 times
 *   size         10^-5 of the extent of the points, the diagonal of their box, and 10^-4 of their width.  The finest grade of tolerances of
 *                workpieces, IT01 of ISO 286-1, is from 0.8 10^-5 (of 500 mm) to 10^-4 (of 3 mm) of the size.  The width, twice the largest distance
 *                from the main axis, keeps the form of points that are nearly straight, whose distances are small against their extent.  Where
 *                standard deviations are given they say what the points are given to, and not the size. */
#ifndef CAGD_FIT_BENEATH_H
#define CAGD_FIT_BENEATH_H

#include "core/fit/cagd_fit.h"

static const double FIT_OF_EXTENT = 1e-5, FIT_OF_WIDTH = 1e-4;

cagd_fit_beneath fit_beneath(const cagd_fit_data *data, const cagd_fit_result *result);

/* The diagonal of the box about the points, and its middle. */
double fit_extent_of(const cagd_fit_data *data, double middle[]);
#endif
