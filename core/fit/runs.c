#include "core/fit/cagd_fit.h"
#include "core/fit/keyed.h"
#include "core/require.h"

#include <math.h>
#include <stdlib.h>

/* runs.c -- whether the residuals of neighbours are independent. */

/* P(X >= k), X binomial with n trials of probability 1/2, from its logarithms. */
static double upper_tail(int n, int k)
{
    double sum = 0;
    for (int j = k; j <= n; j++)
        sum += exp(lgamma(n + 1.0) - lgamma(j + 1.0) - lgamma(n - j + 1.0) - n * log(2));
    return fmin(1, sum);
}

cagd_status cagd_fit_runs_of(const cagd_fit_result *r, cagd_fit_runs *runs)
{
    const int n = r->count, dim = r->curve.dim;
    keyed *list = malloc(((size_t)n + 1) * sizeof *list);
    *runs = (cagd_fit_runs){0, 0, NAN};
    REQUIRE(list != NULL, CAGD_NO_MEMORY);
    for (int i = 0; i < n; i++)
        list[i] = (keyed){r->feet[i], i};
    qsort(list, (size_t)n, sizeof *list, fit_by_key);
    for (int i = 1; i < n; i++) {
        const int a = list[i - 1].index, b = list[i].index;
        double inner = r->distances[a] * r->distances[b];
        if (dim == 3) {
            inner = 0;
            for (int c = 0; c < dim; c++)
                inner += r->residuals[a * dim + c] * r->residuals[b * dim + c];
        }
        runs->pairs += inner != 0;
        runs->same += inner > 0;
    }
    if (runs->pairs > 0)
        runs->probability = upper_tail(runs->pairs, runs->same);
    free(list);
    return CAGD_OK;
}
