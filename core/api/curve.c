#include "core/api/checks.h"
#include "core/spline.h"

#include <stdlib.h>
#include <string.h>

/* n points H of `size` coordinates, homogeneous for a rational curve: then size = dim + 1. */
struct cagd_curve {
    int degree, count, dim, size;
    const double *knots, *H;
    double numbers[];
};

cagd_curve *cagd_curve_new(const cagd_spline *s, cagd_status *status, int *where)
{
    cagd_status found = cagd_spline_check(s, where);
    cagd_curve *curve = NULL;
    if (found == CAGD_OK) {
        size_t knots = (size_t)s->count + (size_t)s->degree + 1, points = (size_t)s->count;
        int size = s->dim + (s->weights != NULL);
        curve = malloc(sizeof *curve + (knots + points * (size_t)size) * sizeof(double));
        if (curve == NULL) {
            found = CAGD_NO_MEMORY;
        } else {
            double *u = curve->numbers, *H = u + knots;
            *curve = (cagd_curve){s->degree, s->count, s->dim, size, u, H};
            memcpy(u, s->knots, knots * sizeof *u);
            if (s->weights != NULL)
                rational_homogenize_d(s->count - 1, s->dim, s->points, s->weights, H);
            else
                memcpy(H, s->points, points * (size_t)size * sizeof *H);
        }
    }
    if (status != NULL)
        *status = found;
    return curve;
}

void cagd_curve_free(cagd_curve *curve) { free(curve); }

/* The span of t, beginning with the guess, which is any span: at neighbouring parameters it is the right one. */
static inline cagd_status find(const cagd_curve *c, double t, cagd_side side, int guess, int *mu)
{
    const double *u = c->knots;
    if (side != CAGD_LEFT && u[guess] <= t && t < u[guess + 1]) {
        *mu = guess;
        return CAGD_OK;
    }
    if (!(u[c->degree] <= t && t <= u[c->count]))
        return isfinite(t) ? CAGD_OUTSIDE_DOMAIN : CAGD_NOT_FINITE;
    *mu = (side == CAGD_LEFT ? find_span_left_d : find_span_d)(c->count, c->degree, u, t);
    return CAGD_OK;
}

/* De Boor's triangle at t on the p+1 points of a span, of `size` coordinates.  p and size are constants for the compiler where
 * the curve is of low degree, which it usually is. */
static inline void triangle(int p, int size, const cagd_curve *c, int mu, double t, double out[])
{
    double d[(MAX_DEGREE + 1) * MAX_DIM];
    for (int m = 0; m < (p + 1) * size; m++)
        d[m] = c->H[(mu - p) * size + m];
    for (int r = 1; r <= p; r++)
        bspline_deboor_level_d(on_span_d(p, size, c->knots, mu, NULL), r, d, t);
    for (int k = 0; k < size; k++)
        out[k] = d[k];
}

static inline void triangle_of_size(int size, const cagd_curve *c, int mu, double t, double out[])
{
    switch (c->degree) {
    case 2:
        triangle(2, size, c, mu, t, out);
        break;
    case 3:
        triangle(3, size, c, mu, t, out);
        break;
    default:
        triangle(c->degree, size, c, mu, t, out);
    }
}

static inline cagd_status point(const cagd_curve *c, double t, int mu, double out[])
{
    double P[MAX_DIM];
    int dim = c->dim;
    switch (c->size) {
    case 1:
        triangle_of_size(1, c, mu, t, P);
        break;
    case 2:
        triangle_of_size(2, c, mu, t, P);
        break;
    case 3:
        triangle_of_size(3, c, mu, t, P);
        break;
    default:
        triangle_of_size(4, c, mu, t, P);
    }
    if (c->size > dim) {
        REQUIRE(P[dim] != 0, CAGD_UNDEFINED);
        REQUIRE(isfinite(P[dim]), CAGD_OVERFLOW);
        for (int k = 0; k < dim; k++)
            P[k] = P[k] / P[dim];
    }
    for (int k = 0; k < dim; k++)
        out[k] = P[k];
    return result(dim, out);
}

static cagd_status derivatives(const cagd_curve *c, double t, int mu, int order, double out[])
{
    double D[(MAX_DEGREE + 1) * MAX_DIM];
    int p = c->degree, dim = c->dim;
    const double *span = c->H + (mu - p) * c->size;
    if (c->size > dim) {
        bspline_derivatives_d(span_alone_d(p, c->size, c->knots, mu, span), t, order, D);
        REQUIRE(D[dim] != 0, CAGD_UNDEFINED);
        REQUIRE(isfinite(D[dim]), CAGD_OVERFLOW);
        rational_quotient_derivatives_d(dim, D, order, out);
    } else {
        bspline_derivatives_d(span_alone_d(p, dim, c->knots, mu, span), t, order, out);
    }
    return result((order + 1) * dim, out);
}

/* What is asked for at a parameter. */
enum quantity { POINT, DERIVATIVES, CURVATURE, TORSION };

/* Whether the curve has it, in any order of derivation. */
static cagd_status has(const cagd_curve *c, enum quantity quantity, int order, const double out[])
{
    REQUIRE(c != NULL && out != NULL, CAGD_NULL);
    REQUIRE(in(0, order, MAX_DEGREE), CAGD_ORDER);
    REQUIRE(quantity != CURVATURE || c->dim > 1, CAGD_DIMENSION);
    REQUIRE(quantity != TORSION || c->dim == 3, CAGD_DIMENSION);
    return CAGD_OK;
}

static inline cagd_status evaluate(const cagd_curve *c, enum quantity quantity, int order, double t, int mu,
                                   double out[])
{
    double D[4 * MAX_DIM];
    int dim = c->dim;
    switch (quantity) {
    case POINT:
        return point(c, t, mu, out);
    case DERIVATIVES:
        return derivatives(c, t, mu, order, out);
    case CURVATURE:
        PASS(derivatives(c, t, mu, 2, D));
        return curvature_of_derivatives(dim, D + dim, D + 2 * dim, out);
    case TORSION:
        PASS(derivatives(c, t, mu, 3, D));
        return torsion_of_derivatives(D + 3, D + 6, D + 9, out);
    }
    return CAGD_OK;
}

static inline cagd_status at_one(const cagd_curve *c, enum quantity quantity, int order, double t, cagd_side side,
                                 double out[])
{
    int mu;
    PASS(has(c, quantity, order, out));
    PASS(find(c, t, side, c->degree, &mu));
    return evaluate(c, quantity, order, t, mu, out);
}

static inline cagd_status at_all(const cagd_curve *c, enum quantity quantity, int order, int count, const double t[],
                                 cagd_side side, double out[], int *where)
{
    int ignored;
    if (where == NULL)
        where = &ignored;
    *where = -1;
    PASS(has(c, quantity, order, out));
    REQUIRE(t != NULL, CAGD_NULL);
    REQUIRE(count >= 0, CAGD_COUNT);
    int mu = c->degree;
    size_t width = quantity == POINT || quantity == DERIVATIVES ? (size_t)(order + 1) * (size_t)c->dim : 1;
    for (int i = 0; i < count; i++) {
        cagd_status status = find(c, t[i], side, mu, &mu);
        if (status == CAGD_OK)
            status = evaluate(c, quantity, order, t[i], mu, out + (size_t)i * width);
        if (status != CAGD_OK) {
            *where = i;
            return status;
        }
    }
    return CAGD_OK;
}

cagd_status cagd_curve_point(const cagd_curve *c, double t, cagd_side side, double *out)
{
    return at_one(c, POINT, 0, t, side, out);
}

cagd_status cagd_curve_derivatives(const cagd_curve *c, double t, cagd_side side, int order, double *out)
{
    return at_one(c, DERIVATIVES, order, t, side, out);
}

cagd_status cagd_curve_curvature(const cagd_curve *c, double t, cagd_side side, double *out)
{
    return at_one(c, CURVATURE, 0, t, side, out);
}

cagd_status cagd_curve_torsion(const cagd_curve *c, double t, cagd_side side, double *out)
{
    return at_one(c, TORSION, 0, t, side, out);
}

cagd_status cagd_curve_points(const cagd_curve *c, int count, const double *t, cagd_side side, double *out, int *where)
{
    return at_all(c, POINT, 0, count, t, side, out, where);
}

cagd_status cagd_curve_all_derivatives(const cagd_curve *c, int count, const double *t, cagd_side side, int order,
                                       double *out, int *where)
{
    return at_all(c, DERIVATIVES, order, count, t, side, out, where);
}

cagd_status cagd_curve_curvatures(const cagd_curve *c, int count, const double *t, cagd_side side, double *out,
                                  int *where)
{
    return at_all(c, CURVATURE, 0, count, t, side, out, where);
}

cagd_status cagd_curve_torsions(const cagd_curve *c, int count, const double *t, cagd_side side, double *out,
                                int *where)
{
    return at_all(c, TORSION, 0, count, t, side, out, where);
}
