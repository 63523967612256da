#include "core/fit/arguments.h"

#include <math.h>
#include <stddef.h>

cagd_status fit_check_options(const cagd_fit_options *o)
{
    const int all = CAGD_FIT_WEIGHTS | CAGD_FIT_INNER_POINTS | CAGD_FIT_END_POINTS;
    REQUIRE((o->free & ~all) == 0, CAGD_BAD_OPTION);
    REQUIRE(o->ends == CAGD_FIT_ENDS_MEASURED || o->ends == CAGD_FIT_ENDS_SLIDE, CAGD_BAD_OPTION);
    REQUIRE(o->loss == CAGD_FIT_SQUARES || o->loss == CAGD_FIT_HUBER || o->loss == CAGD_FIT_CAUCHY, CAGD_BAD_OPTION);
    REQUIRE(isfinite(o->loss_scale) && o->loss_scale >= 0, CAGD_BAD_OPTION);
    REQUIRE(o->weight_low >= 0 && o->weight_low < 1 && o->weight_high > 1, CAGD_BAD_OPTION);
    REQUIRE(o->starts >= 1 && o->starts <= CAGD_FIT_MAX_STARTS && o->max_iterations >= 1, CAGD_BAD_OPTION);
    REQUIRE(isfinite(o->tolerance) && o->tolerance > 0, CAGD_BAD_OPTION);
    REQUIRE(isfinite(o->smooth) && o->smooth >= 0 && (o->closed == 0 || o->closed == 1), CAGD_BAD_OPTION);
    REQUIRE(o->smooth == 0 || !(o->free & CAGD_FIT_WEIGHTS), CAGD_BAD_OPTION);
    REQUIRE(o->monotone == 0 || (o->monotone == 1 && o->free != 0 && !o->unordered && o->loss == CAGD_FIT_SQUARES),
            CAGD_BAD_OPTION);
    REQUIRE(o->count <= CAGD_FIT_MAX_CONTROL_POINTS, CAGD_BAD_OPTION);
    REQUIRE(o->initial == NULL || o->initial->count <= CAGD_FIT_MAX_CONTROL_POINTS, CAGD_BAD_CURVE);
    REQUIRE(o->initial != NULL || (o->free & CAGD_FIT_INNER_POINTS) || (o->free != 0 && o->degree == 1),
            CAGD_BAD_OPTION);
    return CAGD_OK;
}

cagd_status fit_check_data(const cagd_fit_data *data, int nothing_free, int *where)
{
    REQUIRE(data->count >= 0 && data->count <= CAGD_FIT_MAX_POINTS && (data->dim == 2 || data->dim == 3),
            CAGD_BAD_DATA);
    int equal = 1;
    for (int i = 0; i < data->count; i++)
        for (int c = 0; c < data->dim; c++) {
            double x = data->points[(size_t)i * (size_t)data->dim + (size_t)c];
            *where = i;
            REQUIRE(isfinite(x), CAGD_BAD_DATA);
            equal = equal && x == data->points[c];
        }
    for (int i = 0; data->sigma != NULL && i < data->count; i++) {
        *where = i;
        REQUIRE(isfinite(data->sigma[i]) && data->sigma[i] > 0, CAGD_BAD_DATA);
    }
    *where = -1;
    REQUIRE(data->count >= (nothing_free ? 1 : 2), CAGD_TOO_FEW);
    REQUIRE(!equal || nothing_free, CAGD_ALL_EQUAL);
    return CAGD_OK;
}
