#include "core/fit/foot.h"

#include "core/fit/wide.h"
#include "core/number/limits.h"

#include <float.h>
#include <math.h>

static inline double inner(int dim, const double a[], const double b[])
{
    return a[0] * b[0] + a[1] * b[1] + (dim == 3 ? a[2] * b[2] : 0);
}

#define NAME(name) name##_conic
#define DIM        2
#define DEGREE     2
#include "core/fit/foot.tmpl.h"
#undef NAME
#undef DEGREE
#define NAME(name) name##_cubic
#define DEGREE     3
#include "core/fit/foot.tmpl.h"
#undef NAME
#undef DIM
#define NAME(name) name##_space_cubic
#define DIM        3
#include "core/fit/foot.tmpl.h"
#undef NAME
#undef DIM
#undef DEGREE
#define NAME(name) name##_any
#define DIM        (curve->spline.dim)
#define DEGREE     (curve->spline.degree)
#include "core/fit/foot.tmpl.h"
#undef NAME
#undef DIM
#undef DEGREE

static int shape_of(const fit_curve *c) { return c->spline.dim * 100 + c->spline.degree; }

void fit_curve_derivatives(const fit_curve *c, double t, double D[])
{
    switch (shape_of(c)) {
    case 202:
        derivatives_conic(c, t, D);
        break;
    case 203:
        derivatives_cubic(c, t, D);
        break;
    case 303:
        derivatives_space_cubic(c, t, D);
        break;
    default:
        derivatives_any(c, t, D);
    }
}

void fit_curve_point(const fit_curve *c, double t, double P[])
{
    switch (shape_of(c)) {
    case 202:
        point_conic(c, t, P);
        break;
    case 203:
        point_cubic(c, t, P);
        break;
    case 303:
        point_space_cubic(c, t, P);
        break;
    default:
        point_any(c, t, P);
    }
}

static fit_foot_kind foot_inside(const fit_curve *c, const double q[], double limit, double *t, double D[])
{
    int shape = shape_of(c);
    return shape == 202   ? newton_conic(c, q, limit, t, D)
           : shape == 203 ? newton_cubic(c, q, limit, t, D)
           : shape == 303 ? newton_space_cubic(c, q, limit, t, D)
                          : newton_any(c, q, limit, t, D);
}

fit_foot_kind fit_foot_near(const fit_curve *c, const double q[], double limit, double *t, double D[])
{
    fit_foot_kind kind = foot_inside(c, q, limit, t, D);
    if (kind != FOOT_AT_END || c->period == 0)
        return kind;
    *t = *t == fit_curve_start(c) ? fit_curve_end(c) : fit_curve_start(c);
    kind = foot_inside(c, q, limit, t, D);
    return kind == FOOT_AT_END && c->spline.degree > 1 ? FOOT_ORTHOGONAL : kind;
}

fit_foot_kind fit_foot(const fit_curve *c, const double q[], double *t, double D[])
{
    return fit_foot_near(c, q, FOOT_EXACT, t, D);
}
