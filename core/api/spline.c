#include "core/spline.h"
#include "core/api/checks.h"

#include <limits.h>

static cagd_status all_finite(int count, const double x[], int *where)
{
    for (int i = 0; i < count; i++)
        if (!isfinite(x[i])) {
            *where = i;
            return CAGD_NOT_FINITE;
        }
    return CAGD_OK;
}

/* Degree, count and knots; nothing is read of the points. */
static cagd_status basis_check(const cagd_spline *s, int *where)
{
    *where = -1;
    REQUIRE(s != NULL && s->knots != NULL, CAGD_NULL);
    REQUIRE(in(0, s->degree, MAX_DEGREE), CAGD_DEGREE);
    REQUIRE(in(s->degree + 1, s->count, INT_MAX / (2 * MAX_DIM)), CAGD_COUNT);
    PASS(all_finite(s->count + s->degree + 1, s->knots, where));
    cagd_status status = check_knots_d(s->count, s->degree, s->knots, where);
    if (status == CAGD_OK)
        *where = -1;
    return status;
}

cagd_status cagd_spline_check(const cagd_spline *s, int *where)
{
    int ignored;
    if (where == NULL)
        where = &ignored;
    PASS(basis_check(s, where));
    REQUIRE(s->points != NULL, CAGD_NULL);
    REQUIRE(in(1, s->dim, CAGD_MAX_DIM), CAGD_DIMENSION);
    PASS(all_finite(s->count * s->dim, s->points, where));
    return s->weights == NULL ? CAGD_OK : all_finite(s->count, s->weights, where);
}

/* The span of t, after basis_check. */
static cagd_status span_at(const cagd_spline *s, double t, cagd_side side, int *span)
{
    REQUIRE(isfinite(t), CAGD_NOT_FINITE);
    return spline_span_d(s, t, side, span);
}

cagd_status cagd_spline_span(const cagd_spline *s, double t, cagd_side side, int *span)
{
    int where;
    REQUIRE(span != NULL, CAGD_NULL);
    PASS(basis_check(s, &where));
    return span_at(s, t, side, span);
}

cagd_status cagd_spline_basis(const cagd_spline *s, double t, cagd_side side, int order, int *span, double *values)
{
    int where;
    REQUIRE(span != NULL && values != NULL, CAGD_NULL);
    PASS(basis_check(s, &where));
    REQUIRE(in(0, order, MAX_DEGREE), CAGD_ORDER);
    PASS(span_at(s, t, side, span));
    bspline_basis_derivatives_d(s->degree, s->knots, *span, t, order, values);
    return result((order + 1) * (s->degree + 1), values);
}

cagd_status cagd_spline_point(const cagd_spline *s, double t, cagd_side side, double *point)
{
    return cagd_spline_derivatives(s, t, side, 0, point);
}

cagd_status cagd_spline_derivatives(const cagd_spline *s, double t, cagd_side side, int order, double *derivatives)
{
    int mu;
    REQUIRE(derivatives != NULL, CAGD_NULL);
    PASS(cagd_spline_check(s, NULL));
    REQUIRE(in(0, order, MAX_DEGREE), CAGD_ORDER);
    PASS(span_at(s, t, side, &mu));
    return spline_derivatives_d(s, mu, t, order, derivatives);
}

cagd_status cagd_spline_curvature(const cagd_spline *s, double t, cagd_side side, double *curvature)
{
    double D[3 * MAX_DIM];
    REQUIRE(s != NULL && curvature != NULL, CAGD_NULL);
    REQUIRE(s->dim != 1, CAGD_DIMENSION);
    PASS(cagd_spline_derivatives(s, t, side, 2, D));
    return curvature_of_derivatives(s->dim, D + s->dim, D + 2 * s->dim, curvature);
}

cagd_status cagd_spline_torsion(const cagd_spline *s, double t, cagd_side side, double *torsion)
{
    double D[4 * 3];
    REQUIRE(s != NULL && torsion != NULL, CAGD_NULL);
    REQUIRE(s->dim == 3, CAGD_DIMENSION);
    PASS(cagd_spline_derivatives(s, t, side, 3, D));
    return torsion_of_derivatives(D + 3, D + 6, D + 9, torsion);
}

cagd_status cagd_spline_insert(const cagd_spline *s, double x, double *new_knots, double *new_points,
                               double *new_weights)
{
    int where;
    PASS(cagd_spline_check(s, NULL));
    REQUIRE(new_knots != NULL && new_points != NULL && (s->weights == NULL || new_weights != NULL), CAGD_NULL);
    REQUIRE(isfinite(x), CAGD_NOT_FINITE);
    return spline_insert_d(s, x, &(struct spline_room_d){new_knots, new_points, new_weights}, &where);
}

cagd_status cagd_spline_bezier(const cagd_spline *s, int span, double *bezier_points, double *bezier_weights)
{
    int where;
    PASS(cagd_spline_check(s, NULL));
    REQUIRE(bezier_points != NULL && (s->weights == NULL || bezier_weights != NULL), CAGD_NULL);
    return spline_bezier_d(s, span, &(struct spline_room_d){NULL, bezier_points, bezier_weights}, &where);
}

cagd_status cagd_spline_split_counts(const cagd_spline *s, double t, int *left_count, int *right_count)
{
    int where;
    REQUIRE(left_count != NULL && right_count != NULL, CAGD_NULL);
    PASS(basis_check(s, &where));
    REQUIRE(isfinite(t), CAGD_NOT_FINITE);
    return spline_split_counts_d(s, t, left_count, right_count);
}

cagd_status cagd_spline_split(const cagd_spline *s, double t, double *left_knots, double *left, double *left_weights,
                              double *right_knots, double *right, double *right_weights)
{
    int where;
    PASS(cagd_spline_check(s, NULL));
    REQUIRE(left_knots != NULL && left != NULL && right_knots != NULL && right != NULL, CAGD_NULL);
    REQUIRE(s->weights == NULL || (left_weights != NULL && right_weights != NULL), CAGD_NULL);
    REQUIRE(isfinite(t), CAGD_NOT_FINITE);
    return spline_split_d(s, t, &(struct spline_room_d){left_knots, left, left_weights},
                          &(struct spline_room_d){right_knots, right, right_weights}, &where);
}

cagd_status cagd_spline_elevated_count(const cagd_spline *s, int *count)
{
    int where;
    REQUIRE(count != NULL, CAGD_NULL);
    PASS(basis_check(s, &where));
    REQUIRE(s->degree < MAX_DEGREE, CAGD_DEGREE);
    *count = spline_elevated_count_d(s);
    return CAGD_OK;
}

cagd_status cagd_spline_elevate(const cagd_spline *s, double *new_knots, double *new_points, double *new_weights)
{
    int where;
    PASS(cagd_spline_check(s, NULL));
    REQUIRE(new_knots != NULL && new_points != NULL && (s->weights == NULL || new_weights != NULL), CAGD_NULL);
    return spline_elevate_d(s, &(struct spline_room_d){new_knots, new_points, new_weights}, &where);
}
