#include "core/fit/batch.h"

#include "core/fit/wide.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* Vectors are returned only by functions that become parts of others, so that it does not matter how processors
 * return them. */
#pragma GCC diagnostic ignored "-Wpsabi"

enum { LOOKS = 5 };

#define NAME(name) name##_2
#define LANES      2
#define TARGET
#include "core/fit/batch.tmpl.h"
#undef NAME
#undef LANES
#undef TARGET

#ifdef FIT_WIDER
#define NAME(name) name##_4
#define LANES      4
#define TARGET     __attribute__((target("avx2")))
#include "core/fit/batch.tmpl.h"
#undef NAME
#undef LANES
#undef TARGET

#define NAME(name) name##_8
#define LANES      8
#define TARGET     __attribute__((target("avx512f")))
#include "core/fit/batch.tmpl.h"
#undef NAME
#undef LANES
#undef TARGET
#endif

int fit_batch_widest(void)
{
#ifdef FIT_WIDER
    return __builtin_cpu_supports("avx512f") ? 8 : __builtin_cpu_supports("avx2") ? 4 : 2;
#else
    return 2;
#endif
}

int fit_batch(fit_objective *o, int i, int weighted, double loss[])
{
    const fit_problem *p = o->problem;
    int newton = weighted && o->newton;
    if (o->width == 0 || p->dim != 2 || p->count != p->degree + 1 || p->degree < 2 || p->degree > 3 ||
        p->loss != CAGD_FIT_SQUARES || i + FIT_BATCH > p->points)
        return 0;
#ifdef FIT_WIDER
    if (o->width == 8)
        return points_8(o, i, newton, loss);
    if (o->width == 4)
        return points_4(o, i, newton, loss);
#endif
    return points_2(o, i, newton, loss);
}
