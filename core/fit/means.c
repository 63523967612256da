#include "core/fit/means.h"

#include "core/fit/wide.h"
#include "core/require.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { FEWEST = 20 }; /* groups, below which nothing is seen of a curve */

/* A polygon through a curve is hardly shorter than one with three times as many corners.  Where points scatter across it by s, and have the
 * distance h along it, a side has the length sqrt(h^2 + 2 s^2) in the mean; with three taken together 3 h and s/sqrt(3).  Points that go
 * back a part of the way shorten it as well, once, by less than SCATTERED says. */
static const double SCATTERED = 0.75, SHORTER = 0.9;

/* The means of group g of `groups`, a coordinate each, in `dim` dimensions, a constant for the compiler; returns the sum of the
 * weights there. */
INLINE double means_of(const cagd_fit_data *data, const int dim, int neighbours, int groups, int g, double mean[3])
{
    const int low = g * neighbours, high = g + 1 < groups ? low + neighbours : data->count;
    const double *q = data->points + (size_t)low * (size_t)dim;
    double sum = 0;
    for (int c = 0; c < dim; c++)
        mean[c] = 0;
    for (int i = low; i < high; i++, q += dim) {
        const double weight = data->sigma != NULL ? 1 / (data->sigma[i] * data->sigma[i]) : 1;
        for (int c = 0; c < dim; c++)
            mean[c] += weight * q[c];
        sum += weight;
    }
    for (int c = 0; c < dim && sum != 1; c++)
        mean[c] /= sum;
    return sum;
}

/* The length of the polygon of the means. */
INLINE double length_in(const cagd_fit_data *data, const int dim, int neighbours)
{
    const int groups = data->count / neighbours;
    double length = 0, before[3] = {0}, here[3];
    for (int g = 0; g < groups; g++) {
        means_of(data, dim, neighbours, groups, g, here);
        double square = 0;
        for (int c = 0; c < dim; c++) {
            square += (here[c] - before[c]) * (here[c] - before[c]);
            before[c] = here[c];
        }
        length += g > 0 ? sqrt(square) : 0;
    }
    return length;
}

static double length_of(const cagd_fit_data *data, int neighbours)
{
    return data->dim == 2 ? length_in(data, 2, neighbours) : length_in(data, 3, neighbours);
}

int fit_neighbours(const cagd_fit_data *data)
{
    int neighbours = 1;
    for (double length = length_of(data, 1); data->count / (3 * neighbours) >= FEWEST;) {
        const double next = length_of(data, 3 * neighbours);
        if (!(next < (neighbours == 1 ? SCATTERED : SHORTER) * length))
            break;
        length = next;
        neighbours *= 3;
    }
    return neighbours;
}

cagd_status fit_means(const cagd_fit_data *data, int neighbours, cagd_fit_data *means)
{
    const int groups = data->count / neighbours;
    double *points = malloc((size_t)groups * (size_t)(data->dim + 1) * sizeof *points),
           *sigma = points != NULL ? points + (size_t)groups * (size_t)data->dim : NULL;
    *means = (cagd_fit_data){groups, data->dim, points, data->sigma != NULL ? sigma : NULL};
    REQUIRE(points != NULL, CAGD_NO_MEMORY);
    for (int g = 0; g < groups; g++) {
        double mean[3];
        sigma[g] = 1 / sqrt(data->dim == 2 ? means_of(data, 2, neighbours, groups, g, mean)
                                           : means_of(data, 3, neighbours, groups, g, mean));
        memcpy(points + (size_t)g * (size_t)data->dim, mean, (size_t)data->dim * sizeof *mean);
    }
    return CAGD_OK;
}

void fit_means_free(cagd_fit_data *means)
{
    free((double *)means->points);
    *means = (cagd_fit_data){0};
}
