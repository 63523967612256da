/* foot.c -- interval Newton for the foot of one point; the ends of the domain and the knots. */
#include "exact/fit/foot.h"

#include "exact/fit/words.h"

#include <math.h>
static const char *const no_foot =
    "the foot of this point is not a nearest point of the curve, or not the only one near";
static const char *const at_end = "the foot of this point cannot be told from the end of the curve";
static const char *const at_corner = "the foot of this point is at a knot where the curve may have a corner";

/* The span of t: the last one at the end of the domain. */
static int span_of(const cagd_spline *curve, mpfr_srcptr t)
{
    int mu = curve->degree;
    for (int i = curve->degree; i < curve->count; i++)
        if (curve->knots[i] < curve->knots[i + 1] && mpfr_cmp_d(t, curve->knots[i]) >= 0)
            mu = i;
    return mu;
}

/* Whether the tangent vector is continuous between two spans: no knot of multiplicity p or more in between. */
static int is_smooth_between(const cagd_spline *curve, int low, int high)
{
    for (int i = low + 1; i <= high; i++) {
        int many = 0;
        for (int k = low + 1; k <= high; k++)
            many += curve->knots[k] == curve->knots[i];
        if (many >= curve->degree)
            return 0;
    }
    return 1;
}

static int look(struct box *b, int i, num_i t, struct view *v)
{
    const cagd_spline *curve = b->problem->curve;
    int p = curve->degree, dim = curve->dim, low = span_of(curve, t.at->lo), high = span_of(curve, t.at->hi);
    const double *Q = b->problem->data->points + (size_t)i * (size_t)dim;
    v->first = low - p;
    v->width = p + 1 + high - low;
    if (high - low > MORE_SPANS || !is_smooth_between(curve, low, high)) {
        b->reason = at_corner;
        return 0;
    }
    for (int mu = low; mu <= high;
         mu++) { /* several spans: the hull of their segments, 0 where a point does not count */
        num_i R[3 * (MAX_DEGREE + 1)];
        if (curve->knots[mu] == curve->knots[mu + 1])
            continue;
        nurbs_basis_i(nurbs_on_span_i(p, 0, b->knot, mu, NULL, b->weight), t, 2, R);
        for (int r = 0; r < 3; r++)
            for (int m = 0; m < v->width; m++) {
                int k = m - (mu - low);
                num_i value = k >= 0 && k <= p ? R[r * (p + 1) + k] : from_double_i(0);
                v->R[r][m] = mu == low ? value : hull_i(v->R[r][m], value);
            }
    }
    for (int c = 0; c < dim; c++) {
        num_i q = from_double_i(Q[c]), sum[3];
        for (int m = 0; m < v->width; m++) {
            v->X[m * dim + c] = sub_i(b->point[(v->first + m) * dim + c], q);
            for (int r = 0; r < 3; r++) {
                num_i term = mul_i(v->R[r][m], v->X[m * dim + c]);
                sum[r] = m == 0 ? term : add_i(sum[r], term);
            }
        }
        v->D[c] = sum[0];
        v->C1[c] = sum[1];
        v->C2[c] = sum[2];
    }
    v->phi = inner_i(dim, v->D, v->C1);
    v->slope = inner_i(dim, v->D, v->C2);
    for (int c = 0; c < dim; c++)
        v->slope = add_i(v->slope, square_i(v->C1[c]));
    return 1;
}

/* Whether the curve ends in Q whatever the unknowns are: then the point adds 0 to F, and nothing to its derivatives. */
static int is_fixed_end(const struct box *b, int i, int end)
{
    const cagd_spline *curve = b->problem->curve;
    int p = curve->degree, at = end == 0 ? 0 : curve->count - 1, first = end == 0 ? 0 : curve->count;
    for (int k = 0; k < p; k++)
        if (curve->knots[first + k] != curve->knots[first + k + 1])
            return 0;
    for (int c = 0; c < curve->dim; c++)
        if (b->of_coordinate[at * curve->dim + c] >= 0 ||
            curve->points[at * curve->dim + c] != b->problem->data->points[i * curve->dim + c])
            return 0;
    return 1;
}

/* The foot of point i for all unknowns of the box, near t; v is what is seen from there.  The width of the result is
 * proportional to the way from t: from farther away than 2^-45 of the domain it is gone once more, which the caller
 * sees by *again.
 *
 * NEAR_END: phi increases on an interval T that begins or finishes at an end of the domain, and has the right sign
 * at the other end of T: the only nearest point in T is the zero of phi, or the end where phi has none there.  v is
 * what is seen from T. */
static enum foot enclose_foot_near(struct box *b, int i, double t, struct view *v, double *again)
{
    const cagd_spline *curve = b->problem->curve;
    double first = curve->knots[curve->degree], last = curve->knots[curve->count];
    b->where = i;
    if (!(first <= t && t <= last)) {
        b->reason = no_foot;
        return NO_FOOT;
    }
    const int *held = b->problem->end_points;
    int end = t == first ? 0 : t == last ? 1 : -1;
    if (end >= 0 && is_fixed_end(b, i, end))
        return FOOT_ON_FIXED_END;
    num_i here = from_double_i(t), phi;
    if (!look(b, i, here, v))
        return NO_FOOT;
    if (end >= 0 && held != NULL && held[end] == i)
        return FOOT_AT_END;
    if (end >= 0 && sign_i(v->phi) == (end == 0 ? 1 : -1))
        return FOOT_AT_END;
    if (sign_i(v->slope) <= 0) {
        b->reason = end >= 0 ? at_end : no_foot;
        return NO_FOOT;
    }
    phi = v->phi;
    double h = 2 * size_i(div_i(phi, v->slope)) + ldexp(last - first, (int)(-cagd_region_precision() / 2));
    for (int attempt = 0; attempt < 4; attempt++, h *= 4) {
        num_i T = nearest_in_i(between_i(first, last), add_i(here, between_i(-h, h)));
        int below = mpfr_cmp_d(T.at->lo, first) <= 0, above = mpfr_cmp_d(T.at->hi, last) >= 0;
        if (!look(b, i, T, v))
            return NO_FOOT;
        if (sign_i(v->slope) <= 0)
            break;
        num_i next = sub_i(here, div_i(phi, v->slope));
        *again = lower_i(next) / 2 + upper_i(next) / 2;
        int from_end = below && !mpfr_greater_p(next.at->lo, T.at->lo);
        int to_end = above && !mpfr_less_p(next.at->hi, T.at->hi);
        if ((from_end || mpfr_greater_p(next.at->lo, T.at->lo)) && (to_end || mpfr_less_p(next.at->hi, T.at->hi))) {
            if (from_end || to_end) {
                *again = from_end ? first : last;
                next = nearest_in_i(T, next);
            }
            if (b->is_point && !look(b, i, next, v)) /* of a box T is seen, which is not much wider */
                return NO_FOOT;
            return from_end || to_end ? FOOT_NEAR_END : FOOT_INSIDE;
        }
    }
    b->reason = no_foot;
    return NO_FOOT;
}

enum foot cagd_stationary_enclose_foot(struct box *b, int i, struct view *v)
{
    const cagd_spline *curve = b->problem->curve;
    double t = b->problem->feet[i], again = t,
           far = ldexp(curve->knots[curve->count] - curve->knots[curve->degree], -45);
    enum foot foot = enclose_foot_near(b, i, t, v, &again);
    int nearer = (foot == FOOT_INSIDE && fabs(again - t) > far) || (foot == FOOT_NEAR_END && again != t);
    return nearer ? enclose_foot_near(b, i, again, v, &again) : foot;
}
