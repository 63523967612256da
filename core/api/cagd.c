#include "core/api/checks.h"

#include "core/kernels/kernels_d.h"

_Static_assert((int)CAGD_MAX_DEGREE == MAX_DEGREE, "the header states the kernels' limit");
_Static_assert((int)CAGD_MAX_DIM + 1 == MAX_DIM, "one coordinate is left for the weight");

/* The arguments that every curve has, of a degree and a dimension already found good. */
static cagd_status polynomial_arguments(int degree, int dim, const double points[], double t)
{
    return finite((degree + 1) * dim, points) && isfinite(t) ? CAGD_OK : CAGD_NOT_FINITE;
}
static cagd_status rational_arguments(int degree, int dim, const double points[], const double weights[], double t)
{
    REQUIRE(finite(degree + 1, weights), CAGD_NOT_FINITE);
    return polynomial_arguments(degree, dim, points, t);
}

/* Whether one can divide by the total weight at t. */
static cagd_status total_weight(int degree, const double weights[], double t)
{
    double total = rational_weight_d(degree, weights, t);
    REQUIRE(total != 0, CAGD_UNDEFINED);
    return result(1, &total);
}

/* A rational curve as a result: it has no point at infinity. */
static cagd_status rational_result(int degree, int dim, const double points[], const double weights[])
{
    PASS(nonzero(degree + 1, weights));
    PASS(result(degree + 1, weights));
    return result((degree + 1) * dim, points);
}

/* New weights that are 0 only where the old ones are: none was lost to underflow. */
static cagd_status scaled_weights(int degree, const double weights[], const double scaled[])
{
    for (int i = 0; i <= degree; i++)
        REQUIRE(scaled[i] != 0 || weights[i] == 0, CAGD_OVERFLOW);
    return result(degree + 1, scaled);
}

cagd_status cagd_bernstein(int degree, double t, double *values)
{
    REQUIRE(values != NULL, CAGD_NULL);
    REQUIRE(in(0, degree, MAX_DEGREE), CAGD_DEGREE);
    REQUIRE(isfinite(t), CAGD_NOT_FINITE);
    bernstein_basis_d(degree, t, values);
    return result(degree + 1, values);
}

cagd_status cagd_bezier_point(int degree, int dim, const double *points, double t, double *point)
{
    REQUIRE(points != NULL && point != NULL, CAGD_NULL);
    REQUIRE(in(0, degree, MAX_DEGREE), CAGD_DEGREE);
    REQUIRE(in(1, dim, CAGD_MAX_DIM), CAGD_DIMENSION);
    PASS(polynomial_arguments(degree, dim, points, t));
    bezier_casteljau_d(degree, dim, points, t, point);
    return result(dim, point);
}

cagd_status cagd_bezier_derivatives(int degree, int dim, const double *points, double t, int order, double *derivatives)
{
    REQUIRE(points != NULL && derivatives != NULL, CAGD_NULL);
    REQUIRE(in(0, degree, MAX_DEGREE), CAGD_DEGREE);
    REQUIRE(in(1, dim, CAGD_MAX_DIM), CAGD_DIMENSION);
    REQUIRE(in(0, order, MAX_DEGREE), CAGD_ORDER);
    PASS(polynomial_arguments(degree, dim, points, t));
    bezier_derivatives_d(degree, dim, points, t, order, derivatives);
    return result((order + 1) * dim, derivatives);
}

cagd_status cagd_bezier_split(int degree, int dim, const double *points, double t, double *left, double *right)
{
    REQUIRE(points != NULL && left != NULL && right != NULL, CAGD_NULL);
    REQUIRE(in(0, degree, MAX_DEGREE), CAGD_DEGREE);
    REQUIRE(in(1, dim, CAGD_MAX_DIM), CAGD_DIMENSION);
    PASS(polynomial_arguments(degree, dim, points, t));
    bezier_split_d(degree, dim, points, t, left, right);
    PASS(result((degree + 1) * dim, left));
    return result((degree + 1) * dim, right);
}

cagd_status cagd_bezier_elevate(int degree, int dim, const double *points, double *elevated)
{
    REQUIRE(points != NULL && elevated != NULL, CAGD_NULL);
    REQUIRE(in(0, degree, MAX_DEGREE - 1), CAGD_DEGREE);
    REQUIRE(in(1, dim, CAGD_MAX_DIM), CAGD_DIMENSION);
    PASS(polynomial_arguments(degree, dim, points, 0));
    bezier_elevate_d(degree, dim, points, elevated);
    return result((degree + 2) * dim, elevated);
}

cagd_status cagd_rational_point(int degree, int dim, const double *points, const double *weights, double t,
                                double *point)
{
    return cagd_rational_derivatives(degree, dim, points, weights, t, 0, point);
}

cagd_status cagd_rational_derivatives(int degree, int dim, const double *points, const double *weights, double t,
                                      int order, double *derivatives)
{
    REQUIRE(points != NULL && weights != NULL && derivatives != NULL, CAGD_NULL);
    REQUIRE(in(0, degree, MAX_DEGREE), CAGD_DEGREE);
    REQUIRE(in(1, dim, CAGD_MAX_DIM), CAGD_DIMENSION);
    REQUIRE(in(0, order, MAX_DEGREE), CAGD_ORDER);
    PASS(rational_arguments(degree, dim, points, weights, t));
    PASS(total_weight(degree, weights, t));
    rational_derivatives_d(degree, dim, points, weights, t, order, derivatives);
    return result((order + 1) * dim, derivatives);
}

cagd_status cagd_rational_curvature(int degree, int dim, const double *points, const double *weights, double t,
                                    double *curvature)
{
    double D[3 * MAX_DIM];
    REQUIRE(curvature != NULL, CAGD_NULL);
    REQUIRE(dim != 1, CAGD_DIMENSION);
    PASS(cagd_rational_derivatives(degree, dim, points, weights, t, 2, D));
    return curvature_of_derivatives(dim, D + dim, D + 2 * dim, curvature);
}

cagd_status cagd_rational_torsion(int degree, const double *points, const double *weights, double t, double *torsion)
{
    double D[4 * 3];
    REQUIRE(torsion != NULL, CAGD_NULL);
    PASS(cagd_rational_derivatives(degree, 3, points, weights, t, 3, D));
    return torsion_of_derivatives(D + 3, D + 6, D + 9, torsion);
}

cagd_status cagd_rational_split(int degree, int dim, const double *points, const double *weights, double t,
                                double *left, double *left_weights, double *right, double *right_weights)
{
    REQUIRE(points != NULL && weights != NULL, CAGD_NULL);
    REQUIRE(left != NULL && left_weights != NULL && right != NULL && right_weights != NULL, CAGD_NULL);
    REQUIRE(in(0, degree, MAX_DEGREE), CAGD_DEGREE);
    REQUIRE(in(1, dim, CAGD_MAX_DIM), CAGD_DIMENSION);
    PASS(rational_arguments(degree, dim, points, weights, t));
    rational_split_d(degree, dim, points, weights, t, left, left_weights, right, right_weights);
    PASS(rational_result(degree, dim, left, left_weights));
    return rational_result(degree, dim, right, right_weights);
}

cagd_status cagd_rational_elevate(int degree, int dim, const double *points, const double *weights, double *elevated,
                                  double *elevated_weights)
{
    REQUIRE(points != NULL && weights != NULL && elevated != NULL && elevated_weights != NULL, CAGD_NULL);
    REQUIRE(in(0, degree, MAX_DEGREE - 1), CAGD_DEGREE);
    REQUIRE(in(1, dim, CAGD_MAX_DIM), CAGD_DIMENSION);
    PASS(rational_arguments(degree, dim, points, weights, 0));
    rational_elevate_d(degree, dim, points, weights, elevated, elevated_weights);
    return rational_result(degree + 1, dim, elevated, elevated_weights);
}

cagd_status cagd_rational_reparametrize(int degree, const double *weights, double a, double b, double *new_weights)
{
    REQUIRE(weights != NULL && new_weights != NULL, CAGD_NULL);
    REQUIRE(in(0, degree, MAX_DEGREE), CAGD_DEGREE);
    REQUIRE(finite(degree + 1, weights) && isfinite(a) && isfinite(b), CAGD_NOT_FINITE);
    REQUIRE(a > 0 && b > 0, CAGD_SIGN);
    rational_reparametrize_d(degree, weights, a, b, new_weights);
    return scaled_weights(degree, weights, new_weights);
}

cagd_status cagd_rational_standard_form(int degree, const double *weights, double *new_weights)
{
    REQUIRE(weights != NULL && new_weights != NULL, CAGD_NULL);
    REQUIRE(in(1, degree, MAX_DEGREE), CAGD_DEGREE);
    REQUIRE(finite(degree + 1, weights), CAGD_NOT_FINITE);
    double first = weights[0], last = weights[degree];
    REQUIRE((first > 0 && last > 0) || (first < 0 && last < 0), CAGD_SIGN);
    REQUIRE(isnormal(first / last), CAGD_OVERFLOW);
    rational_standard_form_d(degree, weights, new_weights);
    return scaled_weights(degree, weights, new_weights);
}

cagd_status cagd_rational_invariants(int degree, const double *weights, double *invariants)
{
    REQUIRE(weights != NULL && invariants != NULL, CAGD_NULL);
    REQUIRE(in(2, degree, MAX_DEGREE), CAGD_DEGREE);
    REQUIRE(finite(degree + 1, weights), CAGD_NOT_FINITE);
    PASS(nonzero(degree - 1, weights));
    PASS(nonzero(degree - 1, weights + 2));
    rational_invariants_d(degree, weights, invariants);
    return result(degree - 1, invariants);
}

cagd_status cagd_conic_implicit(const double points[6], const double weights[3], double conic[6])
{
    REQUIRE(points != NULL && weights != NULL && conic != NULL, CAGD_NULL);
    PASS(rational_arguments(2, 2, points, weights, 0));
    conic_of_bezier_d(points, weights, conic);
    return result(6, conic);
}

/* The sign of a c - b^2, exactly.  Scaling by powers of two brings a and c into [1/2, 2) without changing
 * it; rounding is monotone, so different rounded products have the order of the exact ones, and where they
 * are equal the rounding errors, which fma gives exactly, decide. */
static int sign_of_delta(double a, double b, double c)
{
    int i, j;
    if (a == 0 || c == 0)
        return b == 0 ? 0 : -1;
    a = frexp(a, &i);
    c = frexp(c, &j);
    if ((i + j) % 2 != 0) {
        c = 2 * c;
        j = j - 1;
    }
    b = ldexp(b, -((i + j) / 2));
    double p = a * c, q = b * b, p_error = fma(a, c, -p), q_error = fma(b, b, -q);
    return p != q ? (p > q) - (p < q) : (p_error > q_error) - (p_error < q_error);
}

static cagd_conic_type type_of_delta(int sign)
{
    return sign > 0 ? CAGD_ELLIPSE : sign < 0 ? CAGD_HYPERBOLA : CAGD_PARABOLA;
}

cagd_status cagd_conic_classify(const double conic[6], cagd_conic_type *type)
{
    REQUIRE(conic != NULL && type != NULL, CAGD_NULL);
    REQUIRE(finite(6, conic), CAGD_NOT_FINITE);
    REQUIRE(conic[0] != 0 || conic[1] != 0 || conic[2] != 0, CAGD_UNDEFINED);
    *type = type_of_delta(sign_of_delta(conic[0], conic[1], conic[2]));
    return CAGD_OK;
}

cagd_status cagd_conic_classify_weights(const double weights[3], cagd_conic_type *type)
{
    REQUIRE(weights != NULL && type != NULL, CAGD_NULL);
    REQUIRE(finite(3, weights), CAGD_NOT_FINITE);
    REQUIRE(weights[0] != 0 && weights[1] != 0 && weights[2] != 0, CAGD_SIGN);
    *type = type_of_delta(sign_of_delta(weights[0], weights[1], weights[2]));
    return CAGD_OK;
}
