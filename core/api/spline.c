#include "core/api/checks.h"
#include "core/kernels/span.h"

static cagd_status status_of_knots(knot_fault fault)
{
    switch (fault) {
    case KNOTS_GOOD:
        return CAGD_OK;
    case KNOTS_TOO_FEW:
        return CAGD_COUNT;
    case KNOTS_DECREASE:
        return CAGD_KNOTS_DECREASE;
    case KNOTS_TOO_MULTIPLE:
        return CAGD_KNOTS_MULTIPLE;
    case KNOTS_NO_DOMAIN:
        return CAGD_KNOTS_EMPTY;
    }
    return CAGD_KNOTS_EMPTY;
}

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
    REQUIRE(s->count > s->degree, CAGD_COUNT);
    PASS(all_finite(s->count + s->degree + 1, s->knots, where));
    cagd_status status = status_of_knots(check_knots_d(s->count, s->degree, s->knots, where));
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
    int (*find)(int, int, const double[], double) = side == CAGD_LEFT ? find_span_left_d : find_span_d;
    int mu = find(s->count, s->degree, s->knots, t);
    REQUIRE(mu >= 0, CAGD_OUTSIDE_DOMAIN);
    *span = mu;
    return CAGD_OK;
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
    bspline_basis_derivatives_d(s->degree, s->knots, *span, t, order + 1, values);
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
    if (s->weights == NULL) {
        bspline_derivatives_d(s->degree, s->dim, s->knots, mu, s->points, t, order + 1, derivatives);
    } else {
        double total = nurbs_weight_d(s->degree, s->knots, mu, s->weights, t);
        REQUIRE(total != 0, CAGD_UNDEFINED);
        PASS(result(1, &total));
        nurbs_derivatives_d(s->degree, s->dim, s->knots, mu, s->points, s->weights, t, order, derivatives);
    }
    return result((order + 1) * s->dim, derivatives);
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

/* The points and the weights of a curve as a result, of which the first `count` were computed. */
static cagd_status curve_result(const cagd_spline *s, int count, const double points[], const double weights[])
{
    if (s->weights != NULL) {
        PASS(nonzero(count, weights));
        PASS(result(count, weights));
    }
    return result(count * s->dim, points);
}

/* t strictly inside the domain, with its span and its multiplicity. */
static cagd_status inner_parameter(const cagd_spline *s, double t, int *mu, int *multiplicity)
{
    PASS(span_at(s, t, CAGD_RIGHT, mu));
    REQUIRE(s->knots[s->degree] < t && t < s->knots[s->count], CAGD_OUTSIDE_DOMAIN);
    *multiplicity = multiplicity_d(s->count + s->degree + 1, s->knots, t);
    return CAGD_OK;
}

cagd_status cagd_spline_insert(const cagd_spline *s, double x, double *new_knots, double *new_points,
                               double *new_weights)
{
    int mu;
    PASS(cagd_spline_check(s, NULL));
    REQUIRE(new_knots != NULL && new_points != NULL && (s->weights == NULL || new_weights != NULL), CAGD_NULL);
    PASS(span_at(s, x, CAGD_RIGHT, &mu));
    REQUIRE(x < s->knots[s->count], CAGD_OUTSIDE_DOMAIN);
    int multiplicity = multiplicity_d(s->count + s->degree + 1, s->knots, x);
    REQUIRE(multiplicity <= s->degree, CAGD_KNOTS_MULTIPLE);
    if (s->weights == NULL)
        bspline_insert_d(s->count, s->degree, s->dim, s->knots, mu, s->points, x, new_knots, new_points);
    else
        nurbs_insert_d(s->count, s->degree, s->dim, s->knots, mu, s->points, s->weights, x, new_knots, new_points,
                       new_weights);
    return curve_result(s, s->count + 1, new_points, new_weights);
}

/* The p+1 points that count on a span: with their weights homogeneous, else as they are.  Returns their dimension.
 * With the knots from u_{mu-p} on they are a spline of one span, which has the number p. */
static int points_of_span(const cagd_spline *s, int mu, double H[])
{
    int p = s->degree, dim = s->dim;
    if (s->weights != NULL) {
        nurbs_homogenize_d(p, dim, mu, s->points, s->weights, H);
        return dim + 1;
    }
    for (int m = 0; m < (p + 1) * dim; m++)
        H[m] = s->points[(mu - p) * dim + m];
    return dim;
}

/* `count` computed points back into points and weights. */
static void put_points(const cagd_spline *s, int count, const double H[], double points[], double weights[])
{
    if (s->weights != NULL)
        rational_dehomogenize_d(count - 1, s->dim, H, points, weights);
    else
        for (int m = 0; m < count * s->dim; m++)
            points[m] = H[m];
}

cagd_status cagd_spline_bezier(const cagd_spline *s, int span, double *bezier_points, double *bezier_weights)
{
    double H[(MAX_DEGREE + 1) * MAX_DIM], B[(MAX_DEGREE + 1) * MAX_DIM];
    PASS(cagd_spline_check(s, NULL));
    REQUIRE(bezier_points != NULL && (s->weights == NULL || bezier_weights != NULL), CAGD_NULL);
    REQUIRE(in(s->degree, span, s->count - 1) && s->knots[span] < s->knots[span + 1], CAGD_OUTSIDE_DOMAIN);
    int p = s->degree, dim = points_of_span(s, span, H);
    bspline_to_bezier_d(p, dim, s->knots + span - p, p, H, B);
    put_points(s, p + 1, B, bezier_points, bezier_weights);
    return curve_result(s, p + 1, bezier_points, bezier_weights);
}

cagd_status cagd_spline_split_counts(const cagd_spline *s, double t, int *left_count, int *right_count)
{
    int where, mu, multiplicity;
    REQUIRE(left_count != NULL && right_count != NULL, CAGD_NULL);
    PASS(basis_check(s, &where));
    PASS(inner_parameter(s, t, &mu, &multiplicity));
    *left_count = mu - multiplicity + 1;
    *right_count = s->count - mu + s->degree;
    return CAGD_OK;
}

cagd_status cagd_spline_split(const cagd_spline *s, double t, double *left_knots, double *left, double *left_weights,
                              double *right_knots, double *right, double *right_weights)
{
    double H[(MAX_DEGREE + 1) * MAX_DIM], L[(MAX_DEGREE + 1) * MAX_DIM], Q[(MAX_DEGREE + 1) * MAX_DIM],
        ends[2 * (2 * MAX_DEGREE + 2)];
    int mu, multiplicity;
    PASS(cagd_spline_check(s, NULL));
    REQUIRE(left_knots != NULL && left != NULL && right_knots != NULL && right != NULL, CAGD_NULL);
    REQUIRE(s->weights == NULL || (left_weights != NULL && right_weights != NULL), CAGD_NULL);
    PASS(inner_parameter(s, t, &mu, &multiplicity));
    int p = s->degree, lefts = mu - multiplicity + 1, rights = s->count - mu + p, first = mu - p;
    /* The span by itself: its knots u_{mu-p}, ..., u_{mu+p+1} and p+1 points are split; the rest is copied. */
    int dim = points_of_span(s, mu, H);
    bspline_split_d(p + 1, p, dim, s->knots + first, p, multiplicity, H, t, ends, L, ends + 2 * MAX_DEGREE + 2, Q);
    for (int i = 0; i < lefts && i < first; i++) {
        for (int c = 0; c < s->dim; c++)
            left[i * s->dim + c] = s->points[i * s->dim + c];
        if (s->weights != NULL)
            left_weights[i] = s->weights[i];
    }
    if (lefts > first)
        put_points(s, lefts - first, L, left + first * s->dim, s->weights != NULL ? left_weights + first : NULL);
    put_points(s, p + 1, Q, right, right_weights);
    for (int i = p + 1; i < rights; i++) {
        for (int c = 0; c < s->dim; c++)
            right[i * s->dim + c] = s->points[(mu - p + i) * s->dim + c];
        if (s->weights != NULL)
            right_weights[i] = s->weights[mu - p + i];
    }
    for (int i = 0; i < lefts + p + 1; i++)
        left_knots[i] = i < lefts ? s->knots[i] : t;
    for (int i = 0; i < rights + p + 1; i++)
        right_knots[i] = i <= p ? t : s->knots[mu + i - p];
    PASS(curve_result(s, lefts, left, left_weights));
    return curve_result(s, rights, right, right_weights);
}

cagd_status cagd_spline_elevated_count(const cagd_spline *s, int *count)
{
    int where;
    REQUIRE(count != NULL, CAGD_NULL);
    PASS(basis_check(s, &where));
    REQUIRE(s->degree < MAX_DEGREE, CAGD_DEGREE);
    *count = raised_knots_d(s->count, s->degree, s->knots, NULL);
    return CAGD_OK;
}

cagd_status cagd_spline_elevate(const cagd_spline *s, double *new_knots, double *new_points, double *new_weights)
{
    double H[(MAX_DEGREE + 1) * MAX_DIM], P[MAX_DIM];
    PASS(cagd_spline_check(s, NULL));
    REQUIRE(new_knots != NULL && new_points != NULL && (s->weights == NULL || new_weights != NULL), CAGD_NULL);
    REQUIRE(s->degree < MAX_DEGREE, CAGD_DEGREE);
    int n = s->count, p = s->degree, count = raised_knots_d(n, p, s->knots, new_knots);
    for (int j = 0; j < count; j++) {
        int mu = span_of_point_d(n, p, s->knots, count, p + 1, new_knots, j), dim = points_of_span(s, mu, H);
        bspline_elevate_d(p, dim, s->knots + mu - p, H, 1, new_knots + j, &p, P);
        put_points(s, 1, P, new_points + j * s->dim, s->weights != NULL ? new_weights + j : NULL);
    }
    return curve_result(s, count, new_points, new_weights);
}
