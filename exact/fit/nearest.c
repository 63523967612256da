/* cagd_stationary_nearest.c -- whether feet are the nearest points of a whole curve: branch and bound in intervals. */
#include "core/number/limits.h"
#include "exact/fit/stationary.h"
#include "exact/fit/words.h"
#include "exact/kernels_i.h"

#include <math.h>

static const char *const undecided =
    "the curve could not be divided into parts so small that their distances are known";

/* What is searched: the curve in intervals, one point Q, its foot, and the distance of that, in an interval. */
struct hunt {
    const cagd_spline *curve;
    const num_i *knot, *point, *weight;
    const double *Q;
    double foot, excess; /* the excess that is allowed                     */
    num_i distance;
    double most; /* of the excess so far                          */
    int nearer;  /* a point of the curve is nearer by more than that */
    int parts;   /* that may still be looked at                   */
};

/* The square of D = C - Q over the parameters t of span mu, phi = D.C' and its derivative.  0 where they cannot be enclosed. */
static int see(const struct hunt *h, int mu, num_i t, num_i *square_of_D, num_i *phi, num_i *slope)
{
    const cagd_spline *curve = h->curve;
    int p = curve->degree, dim = curve->dim;
    num_i R[3 * (MAX_DEGREE + 1)], D[3][MAX_DIM];
    nurbs_basis_i(nurbs_on_span_i(p, 0, h->knot, mu, NULL, h->weight), t, 2, R);
    for (int r = 0; r < 3; r++)
        for (int c = 0; c < dim; c++) {
            num_i q = from_double_i(h->Q[c]);
            for (int m = 0; m <= p; m++) {
                num_i term = mul_i(R[r * (p + 1) + m], sub_i(h->point[(mu - p + m) * dim + c], q));
                D[r][c] = m == 0 ? term : add_i(D[r][c], term);
            }
        }
    *square_of_D = *slope = from_double_i(0);
    for (int c = 0; c < dim; c++) {
        *square_of_D = add_i(*square_of_D, square_i(D[0][c]));
        *slope = add_i(*slope, square_i(D[1][c]));
    }
    *phi = inner_i(dim, D[0], D[1]);
    *slope = add_i(*slope, inner_i(dim, D[0], D[2]));
    int good = region_faults == 0;
    region_faults = 0;
    return good;
}

/* The numbers of a that are not negative, from 0 on where there are others. */
static num_i no_less_than_0(num_i a) { return nearest_in_i(between_i(0, INFINITY), a); }

/* Over low <= t <= high, C of span mu: with m in this interval |D(t)|^2 lies in |D(m)|^2 + 2 phi(T) (T - m), and where the slope is at least
 * s > 0 it is no less than |D(m)|^2 - phi(m)^2/s.  The first is better where m is no foot, the second where it is.  A part in which the
 * distance may be smaller than that of the foot by more than is allowed is halved. */
static void search(struct hunt *h, int mu, double low, double high)
{
    num_i T = between_i(low, high), all, phi, slope, at, phi_at, slope_at;
    double middle = low <= h->foot && h->foot <= high ? h->foot : low + (high - low) / 2;
    region_mark mark = region_open();
    double excess = INFINITY;
    if (--h->parts >= 0 && !h->nearer && see(h, mu, from_double_i(middle), &at, &phi_at, &slope_at)) {
        if (upper_i(sub_i(root_i(2, at), h->distance)) < -h->excess)
            h->nearer = 1;
        if (see(h, mu, T, &all, &phi, &slope)) {
            num_i bound = add_i(at, mul_i(mul_i(from_double_i(2), phi), sub_i(T, from_double_i(middle))));
            excess = upper_i(sub_i(h->distance, root_i(2, no_less_than_0(all))));
            excess = fmin(excess, upper_i(sub_i(h->distance, root_i(2, no_less_than_0(bound)))));
            if (sign_i(slope) > 0) {
                bound = sub_i(at, div_i(square_i(phi_at), slope));
                excess = fmin(excess, upper_i(sub_i(h->distance, root_i(2, no_less_than_0(bound)))));
            }
        }
    }
    region_drop(mark);
    double half = low + (high - low) / 2;
    if (excess <= h->excess)
        h->most = fmax(h->most, excess);
    else if (h->parts > 0 && !h->nearer && low < half && half < high) {
        search(h, mu, low, half);
        search(h, mu, half, high);
    } else
        h->parts = -1;
}

/* The widest side of a box with all points, those of the curve included. */
static double extent_of(const cagd_fit_data *data, const cagd_spline *curve)
{
    double widest = 0;
    for (int c = 0; c < data->dim; c++) {
        double low = curve->points[c], high = low;
        for (int i = 0; i < data->count + curve->count; i++) {
            double x = i < data->count ? data->points[(size_t)i * (size_t)data->dim + (size_t)c]
                                       : curve->points[(i - data->count) * data->dim + c];
            low = fmin(low, x);
            high = fmax(high, x);
        }
        widest = fmax(widest, high - low);
    }
    return widest;
}

/* The span in which t lies, the last one at the end of the domain. */
static int span_of(const cagd_spline *curve, double t)
{
    int mu = curve->degree;
    for (int i = mu; i < curve->count; i++)
        if (curve->knots[i] < curve->knots[i + 1] && curve->knots[i] <= t)
            mu = i;
    return mu;
}

cagd_nearest_verdict cagd_stationary_nearest(const cagd_fit_data *data, const cagd_spline *curve, const double feet[])
{
    enum { MOST_PARTS = 4096 };
    cagd_nearest_verdict verdict = {.verified = 1, .where = -1};
    region_mark mark = region_open();
    unsigned before = region_faults;
    int n = curve->count, p = curve->degree, dim = curve->dim;
    num_i *knot = cagd_region_array(1, (long)n + p + 1, sizeof *knot),
          *point = cagd_region_array(n, dim, sizeof *point), *weight = cagd_region_array(1, n, sizeof *weight);
    if (knot == NULL || point == NULL || weight == NULL) {
        region_faults = before;
        return (cagd_nearest_verdict){.where = -1, .reason = "there is not enough memory"};
    }
    for (int i = 0; i <= n + p; i++)
        knot[i] = from_double_i(curve->knots[i]);
    for (int i = 0; i < n; i++)
        weight[i] = from_double_i(curve->weights != NULL ? curve->weights[i] : 1);
    for (int m = 0; m < n * dim; m++)
        point[m] = from_double_i(curve->points[m]);
    region_faults = 0;
    struct hunt h = {
        .curve = curve, .knot = knot, .point = point, .weight = weight, .excess = ldexp(extent_of(data, curve), -44)};
    for (int i = 0; verdict.verified && i < data->count; i++) {
        region_mark one = region_open();
        num_i at, phi, slope;
        h.Q = data->points + (size_t)i * (size_t)dim;
        h.foot = feet[i];
        h.parts = MOST_PARTS * n;
        if (!(curve->knots[p] <= h.foot && h.foot <= curve->knots[n]) ||
            !see(&h, span_of(curve, h.foot), from_double_i(h.foot), &at, &phi, &slope))
            h.parts = -1;
        else
            h.distance = root_i(2, at);
        for (int mu = p; mu < n && h.parts >= 0; mu++)
            if (curve->knots[mu] < curve->knots[mu + 1])
                search(&h, mu, curve->knots[mu], curve->knots[mu + 1]);
        if (h.parts < 0) {
            verdict.verified = 0;
            verdict.refuted = h.nearer;
            verdict.where = i;
            verdict.reason = h.nearer ? "another point of the curve is nearer to this point" : undecided;
        }
        region_drop(one);
    }
    region_faults = before;
    region_drop(mark);
    verdict.excess = h.most;
    return verdict;
}
