#include "core/fit/by_feet.h"

#include "core/fit/keyed.h"
#include "core/require.h"

#include <stdlib.h>
#include <string.h>

/* Room for all arrays: they are told in s->data and s->result. */
static int make_room(const cagd_fit_data *data, const cagd_fit_result *r, fit_by_feet *s)
{
    const size_t n = (size_t)r->count, dim = (size_t)data->dim;
    s->numbers = malloc((n * (2 * dim + 3) + 1) * sizeof *s->numbers);
    s->marks = malloc((2 * n + 1) * sizeof *s->marks);
    REQUIRE(s->numbers != NULL && s->marks != NULL, 0);
    double *points = s->numbers, *sigma = points + n * dim;
    s->data = (cagd_fit_data){r->count, data->dim, points, data->sigma != NULL ? sigma : NULL};
    s->result.feet = sigma + n;
    s->result.distances = s->result.feet + n;
    s->result.residuals = s->result.distances + n;
    s->result.foot_at_end = s->marks;
    s->result.outlier = r->outlier != NULL ? s->marks + n : NULL;
    return 1;
}

/* What belongs to the point `from` goes to the place `to`. */
static void put(const cagd_fit_data *data, const cagd_fit_result *r, int from, int to, fit_by_feet *s)
{
    const size_t dim = (size_t)data->dim, i = (size_t)from, j = (size_t)to;
    double *points = s->numbers, *sigma = points + (size_t)r->count * dim;
    memcpy(points + j * dim, data->points + i * dim, dim * sizeof *points);
    if (data->sigma != NULL)
        sigma[j] = data->sigma[i];
    s->result.feet[j] = r->feet[i];
    s->result.distances[j] = r->distances[i];
    memcpy(s->result.residuals + j * dim, r->residuals + i * dim, dim * sizeof *r->residuals);
    s->result.foot_at_end[j] = r->foot_at_end[i];
    if (r->outlier != NULL)
        s->result.outlier[j] = r->outlier[i];
    for (int end = 0; end < 2; end++)
        if (r->end_points[end] == from)
            s->result.end_points[end] = to;
    if (r->largest_at == from)
        s->result.largest_at = to;
}

int fit_by_feet_of(const cagd_fit_data *data, const cagd_fit_result *r, fit_by_feet *s)
{
    const int n = r->count;
    *s = (fit_by_feet){.result = *r};
    keyed *list = malloc(((size_t)n + 1) * sizeof *list);
    const int good = list != NULL && make_room(data, r, s);
    for (int i = 0; good && i < n; i++)
        list[i] = (keyed){r->feet[i], i};
    if (good)
        qsort(list, (size_t)n, sizeof *list, fit_by_key);
    for (int j = 0; good && j < n; j++)
        put(data, r, list[j].index, j, s);
    free(list);
    return good;
}

void fit_by_feet_free(fit_by_feet *s)
{
    free(s->numbers);
    free(s->marks);
}
