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

/* Whether the foot of one of the points i, ..., i + FIT_BATCH - 1 is held. */
static int has_end_point(const fit_problem *p, int i)
{
    const int *at = p->end_point;
    return (at[0] >= i && at[0] < i + FIT_BATCH) || (at[1] >= i && at[1] < i + FIT_BATCH);
}

/* Whether these points can be taken together at all. */
static int can_batch(const fit_problem *p, int width, int i)
{
    return !has_end_point(p, i) && width > 0 && p->dim == 2 && p->count == p->degree + 1 && p->degree >= 2 &&
           p->degree <= 3 && i + FIT_BATCH <= p->points;
}

int fit_batch(fit_objective *o, int i, fit_extent extent, double loss[])
{
    if (!can_batch(o->problem, o->width, i) || o->problem->loss != CAGD_FIT_SQUARES)
        return 0;
#ifdef FIT_WIDER
    if (o->width == 8)
        return points_8(o, i, extent, loss);
    if (o->width == 4)
        return points_4(o, i, extent, loss);
#endif
    return points_2(o, i, extent, loss);
}

int fit_batch_feet(const fit_problem *p, const fit_curve *curve, int width, int i, double feet[], double D[][6])
{
    if (!can_batch(p, width, i))
        return 0;
#ifdef FIT_WIDER
    if (width == 8)
        return only_feet_8(p, curve, i, feet, D);
    if (width == 4)
        return only_feet_4(p, curve, i, feet, D);
#endif
    return only_feet_2(p, curve, i, feet, D);
}
