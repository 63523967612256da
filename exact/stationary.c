#include "exact/stationary.h"

#include "core/number/limits.h"
#include "exact/kernels_i.h"
#include "exact/region.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MORE_SPANS = 2, WIDTH = MAX_DEGREE + 1 + MORE_SPANS, ENTRIES = WIDTH * MAX_DIM };

static const char *const no_foot =
    "the foot of this point is not a nearest point of the curve, or not the only one near";
static const char *const at_end = "the foot of this point cannot be told from the end of the curve";
static const char *const at_corner = "the foot of this point is at a knot where the curve may have a corner";
static const char *const pole = "the derivatives at this point cannot be enclosed";
static const char *const no_memory = "there is not enough memory";

/* ---- Intervals ------------------------------------------------------------------------------------ */

static num_i between(double low, double high)
{
    struct interval *r = region_slot(SLOT_INTERVAL);
    mpfr_set_d(r->lo, low, MPFR_RNDD);
    mpfr_set_d(r->hi, high, MPFR_RNDU);
    return (num_i){r};
}
static num_i number(double x) { return between(x, x); }

/* x - r <= x <= x + r, and the same of the factor exp(x), |x| <= r <= 1: 1 - r <= exp(x) <= 1 + r + r^2. */
static num_i around(double x, double r) { return add_i(number(x), between(-r, r)); }
static num_i factor_around(double w, double r)
{
    struct interval *f = region_slot(SLOT_INTERVAL);
    mpfr_set_d(f->lo, r, MPFR_RNDU);
    mpfr_ui_sub(f->lo, 1, f->lo, MPFR_RNDD);
    mpfr_set_d(f->hi, r, MPFR_RNDU);
    mpfr_sqr(f->hi, f->hi, MPFR_RNDU);
    mpfr_add_d(f->hi, f->hi, r, MPFR_RNDU);
    mpfr_add_ui(f->hi, f->hi, 1, MPFR_RNDU);
    return mul_i(number(w), (num_i){f});
}

static num_i hull(num_i a, num_i b)
{
    struct interval *r = region_slot(SLOT_INTERVAL);
    mpfr_min(r->lo, a.at->lo, b.at->lo, MPFR_RNDD);
    mpfr_max(r->hi, a.at->hi, b.at->hi, MPFR_RNDU);
    return (num_i){r};
}

static num_i square(num_i a)
{
    struct interval *r = region_slot(SLOT_INTERVAL);
    mpfr_srcptr far = mpfr_cmpabs(a.at->lo, a.at->hi) > 0 ? a.at->lo : a.at->hi;
    mpfr_srcptr near = far == a.at->lo ? a.at->hi : a.at->lo;
    mpfr_sqr(r->hi, far, MPFR_RNDU);
    if (contains_zero_i(a))
        mpfr_set_zero(r->lo, 1);
    else
        mpfr_sqr(r->lo, near, MPFR_RNDD);
    return (num_i){r};
}

/* A number no smaller than any |x|, x of a. */
static double size_of(num_i a) { return fmax(-lower_i(a), upper_i(a)); }

/* The numbers of T that are nearest to those of a. */
static num_i within(num_i T, num_i a)
{
    struct interval *r = region_slot(SLOT_INTERVAL);
    mpfr_max(r->lo, a.at->lo, T.at->lo, MPFR_RNDD);
    mpfr_min(r->lo, r->lo, T.at->hi, MPFR_RNDD);
    mpfr_min(r->hi, a.at->hi, T.at->hi, MPFR_RNDU);
    mpfr_max(r->hi, r->hi, T.at->lo, MPFR_RNDU);
    return (num_i){r};
}

static num_i inner(int dim, const num_i a[], const num_i b[])
{
    num_i sum = mul_i(a[0], b[0]);
    for (int c = 1; c < dim; c++)
        sum = add_i(sum, mul_i(a[c], b[c]));
    return sum;
}

/* Sums that outlive the regions of their terms. */
static void sums_init(int count, struct interval sum[])
{
    for (int k = 0; k < count; k++) {
        mpfr_init2(sum[k].lo, INTERVAL_PRECISION);
        mpfr_init2(sum[k].hi, INTERVAL_PRECISION);
        mpfr_set_zero(sum[k].lo, 1);
        mpfr_set_zero(sum[k].hi, 1);
    }
}
static void sums_clear(int count, struct interval sum[])
{
    for (int k = 0; k < count; k++) {
        mpfr_clear(sum[k].lo);
        mpfr_clear(sum[k].hi);
    }
}
static void accumulate(struct interval *sum, num_i x)
{
    mpfr_add(sum->lo, sum->lo, x.at->lo, MPFR_RNDD);
    mpfr_add(sum->hi, sum->hi, x.at->hi, MPFR_RNDU);
}

/* ---- The curves of a box --------------------------------------------------------------------------- */

struct box {
    const stationary_problem *problem;
    int n;                               /* unknowns                                                        */
    const double *radius;                /* of each unknown                                                 */
    int *of_weight, *of_coordinate;      /* the unknown that a weight or coordinate is, or -1               */
    num_i *knot, *point, *weight;        /* in intervals                                                    */
    struct interval *gradient, *hessian; /* of which the upper triangle is filled                         */
    int is_point;                        /* all radii are 0                                               */
    const char *reason;
    int where;
};

static int is_held(const stationary_problem *problem, int a) { return problem->held != NULL && problem->held[a]; }

/* Takes memory for everything; the intervals are those of one region. */
static int box_new(struct box *b, const stationary_problem *problem)
{
    const cagd_spline *curve = problem->curve;
    size_t count = (size_t)curve->count, dim = (size_t)curve->dim, n = (size_t)problem->unknowns;
    *b = (struct box){.problem = problem, .n = problem->unknowns, .where = -1};
    b->of_weight = malloc(count * sizeof(int));
    b->of_coordinate = malloc(count * dim * sizeof(int));
    b->knot = malloc((count + (size_t)curve->degree + 1) * sizeof(num_i));
    b->point = malloc(count * dim * sizeof(num_i));
    b->weight = malloc(count * sizeof(num_i));
    b->gradient = malloc((n + 1) * sizeof(struct interval));
    b->hessian = malloc((n * n + 1) * sizeof(struct interval));
    if (b->gradient != NULL)
        sums_init(b->n, b->gradient);
    if (b->hessian != NULL)
        sums_init(b->n * b->n, b->hessian);
    if (b->of_weight == NULL || b->of_coordinate == NULL || b->knot == NULL || b->point == NULL || b->weight == NULL ||
        b->gradient == NULL || b->hessian == NULL)
        return 0;
    for (size_t i = 0; i < count; i++)
        b->of_weight[i] = -1;
    for (size_t m = 0; m < count * dim; m++)
        b->of_coordinate[m] = -1;
    for (int a = 0; a < b->n; a++) {
        const cagd_fit_unknown *u = &problem->unknown[a];
        if (u->is_weight)
            b->of_weight[u->index] = a;
        else
            b->of_coordinate[u->index * curve->dim + u->coordinate] = a;
    }
    return 1;
}

static void box_free(struct box *b)
{
    if (b->gradient != NULL)
        sums_clear(b->n, b->gradient);
    if (b->hessian != NULL)
        sums_clear(b->n * b->n, b->hessian);
    free(b->of_weight);
    free(b->of_coordinate);
    free(b->knot);
    free(b->point);
    free(b->weight);
    free(b->gradient);
    free(b->hessian);
}

static void box_fill(struct box *b, const double radius[])
{
    const cagd_spline *curve = b->problem->curve;
    b->radius = radius;
    b->is_point = 1;
    for (int a = 0; a < b->n; a++)
        b->is_point &= radius[a] == 0;
    b->reason = NULL;
    b->where = -1;
    for (int i = 0; i < curve->count + curve->degree + 1; i++)
        b->knot[i] = number(curve->knots[i]);
    for (int i = 0; i < curve->count; i++) {
        double w = curve->weights != NULL ? curve->weights[i] : 1;
        b->weight[i] = b->of_weight[i] < 0 ? number(w) : factor_around(w, radius[b->of_weight[i]]);
    }
    for (int m = 0; m < curve->count * curve->dim; m++) {
        int a = b->of_coordinate[m];
        b->point[m] = a < 0 ? number(curve->points[m]) : around(curve->points[m], radius[a]);
    }
    for (int a = 0; a < b->n; a++) {
        mpfr_set_zero(b->gradient[a].lo, 1);
        mpfr_set_zero(b->gradient[a].hi, 1);
    }
    for (int m = 0; m < b->n * b->n; m++) {
        mpfr_set_zero(b->hessian[m].lo, 1);
        mpfr_set_zero(b->hessian[m].hi, 1);
    }
}

/* ---- One point -------------------------------------------------------------------------------------- */

/* What is seen from Q_i at the parameters of an interval: the points that count are first, ..., first + width - 1. */
struct view {
    int first, width;
    num_i R[3][WIDTH];                          /* rational basis, and its derivatives by t                     */
    num_i X[WIDTH * MAX_DIM];                   /* P_m - Q                                                       */
    num_i D[MAX_DIM], C1[MAX_DIM], C2[MAX_DIM]; /* C - Q = sum R_m (P_m - Q), C', C''                 */
    num_i phi, slope;                           /* D.C' and its derivative |C'|^2 + D.C''                        */
};

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
        nurbs_basis_i(p, b->knot, mu, b->weight, t, 3, R);
        for (int r = 0; r < 3; r++)
            for (int m = 0; m < v->width; m++) {
                int k = m - (mu - low);
                num_i value = k >= 0 && k <= p ? R[r * (p + 1) + k] : number(0);
                v->R[r][m] = mu == low ? value : hull(v->R[r][m], value);
            }
    }
    for (int c = 0; c < dim; c++) {
        num_i q = number(Q[c]), sum[3];
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
    v->phi = inner(dim, v->D, v->C1);
    v->slope = inner(dim, v->D, v->C2);
    for (int c = 0; c < dim; c++)
        v->slope = add_i(v->slope, square(v->C1[c]));
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

enum foot { NO_FOOT, FOOT_INSIDE, FOOT_AT_END, FOOT_NEAR_END, FOOT_ON_FIXED_END };

/* The foot of point i for all unknowns of the box, near t; v is what is seen from there.  The width of the result is proportional
 * to the way from t: from farther away than 2^-45 of the domain it is gone once more, which the caller sees by *again.
 *
 * NEAR_END: phi increases on an interval T that begins or finishes at an end of the domain, and has the right sign at the other
 * end of T: the only nearest point in T is the zero of phi, or the end where phi has none there.  v is what is seen from T. */
static enum foot enclose_foot_near(struct box *b, int i, double t, struct view *v, double *again)
{
    const cagd_spline *curve = b->problem->curve;
    double first = curve->knots[curve->degree], last = curve->knots[curve->count];
    b->where = i;
    if (!(first <= t && t <= last)) {
        b->reason = no_foot;
        return NO_FOOT;
    }
    int end = t == first ? 0 : t == last ? 1 : -1;
    if (end >= 0 && is_fixed_end(b, i, end))
        return FOOT_ON_FIXED_END;
    num_i here = number(t), phi;
    if (!look(b, i, here, v))
        return NO_FOOT;
    if (end >= 0 && sign_i(v->phi) == (end == 0 ? 1 : -1))
        return FOOT_AT_END;
    if (sign_i(v->slope) <= 0) {
        b->reason = end >= 0 ? at_end : no_foot;
        return NO_FOOT;
    }
    phi = v->phi;
    double h = 2 * size_of(div_i(phi, v->slope)) + ldexp(last - first, -INTERVAL_PRECISION / 2);
    for (int attempt = 0; attempt < 4; attempt++, h *= 4) {
        num_i T = within(between(first, last), add_i(here, between(-h, h)));
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
                next = within(T, next);
            }
            if (b->is_point && !look(b, i, next, v)) /* of a box T is seen, which is not much wider */
                return NO_FOOT;
            return from_end || to_end ? FOOT_NEAR_END : FOOT_INSIDE;
        }
    }
    b->reason = no_foot;
    return NO_FOOT;
}

static enum foot enclose_foot(struct box *b, int i, struct view *v)
{
    const cagd_spline *curve = b->problem->curve;
    double t = b->problem->feet[i], again = t,
           far = ldexp(curve->knots[curve->count] - curve->knots[curve->degree], -45);
    enum foot foot = enclose_foot_near(b, i, t, v, &again);
    int nearer = (foot == FOOT_INSIDE && fabs(again - t) > far) || (foot == FOOT_NEAR_END && again != t);
    return nearer ? enclose_foot_near(b, i, again, v, &again) : foot;
}

/* rho'(s) and rho''(s), the latter the hull of both one-sided values where it jumps. */
static void loss_derivatives(const stationary_problem *problem, num_i s, num_i *first, num_i *second)
{
    num_i one = number(1), a = number(problem->loss_scale), aa = mul_i(a, a);
    *first = one;
    *second = number(0);
    if (problem->loss == CAGD_FIT_CAUCHY) {
        *first = div_i(one, add_i(one, div_i(s, aa)));
        *second = neg_i(div_i(mul_i(*first, *first), aa));
    }
    if (problem->loss == CAGD_FIT_HUBER && sign_i(sub_i(s, aa)) >= 0 && !mpfr_lessequal_p(s.at->hi, aa.at->lo)) {
        struct interval *outside = region_slot(SLOT_INTERVAL); /* of s: where it is not less than a^2 */
        mpfr_max(outside->lo, s.at->lo, aa.at->lo, MPFR_RNDD);
        mpfr_set(outside->hi, s.at->hi, MPFR_RNDU);
        num_i beyond = {outside}, root = root_i(2, beyond);
        num_i slope = div_i(a, root), bend = neg_i(div_i(slope, mul_i(number(2), beyond)));
        int straddles = mpfr_less_p(s.at->lo, aa.at->hi);
        *first = straddles ? hull(one, slope) : slope;
        *second = straddles ? hull(number(0), bend) : bend;
    }
}

/* An unknown that counts at this point. */
struct entry {
    int unknown, m, c; /* c = -1: the weight of m                                             */
    num_i slope, turn; /* D.C_a, and C_a.C' + D.C_a' at phi = 0                               */
};

/* C_e.C_f + D.C_ef for e <= f. */
static num_i second_part(const struct view *v, int dim, const num_i *away, const num_i *A, const struct entry *e,
                         const struct entry *f)
{
    num_i both = mul_i(v->R[0][e->m], v->R[0][f->m]), sum;
    if (e->c >= 0 && f->c >= 0)
        return e->c == f->c ? both : number(0);
    if (e->c < 0 && f->c < 0) {
        sum = inner(dim, away + e->m * dim, away + f->m * dim);
        sum = mul_i(both, sub_i(sum, add_i(A[e->m], A[f->m])));
        return e->m == f->m ? add_i(sum, mul_i(v->R[0][e->m], A[e->m])) : sum;
    }
    const struct entry *w = e->c < 0 ? e : f, *x = e->c < 0 ? f : e;
    sum = mul_i(both, sub_i(away[w->m * dim + x->c], v->D[x->c]));
    return w->m == x->m ? add_i(sum, mul_i(v->R[0][x->m], v->D[x->c])) : sum;
}

/* Adds what point i adds to gradient and Hessian. */
static int add_point(struct box *b, int i)
{
    const stationary_problem *problem = b->problem;
    struct view v;
    struct entry entry[ENTRIES];
    num_i away[WIDTH * MAX_DIM], A[WIDTH], first, second;
    int dim = problem->curve->dim, entries = 0;
    enum foot foot = enclose_foot(b, i, &v);
    if (foot == NO_FOOT || foot == FOOT_ON_FIXED_END)
        return foot == FOOT_ON_FIXED_END;
    num_i sigma = number(problem->data->sigma != NULL ? problem->data->sigma[i] : 1), s = number(0);
    num_i precision = div_i(number(1), square(sigma));
    for (int c = 0; c < dim; c++)
        s = add_i(s, square(v.D[c]));
    loss_derivatives(problem, mul_i(s, precision), &first, &second);
    first = mul_i(first, precision);
    second = mul_i(mul_i(number(2), second), square(precision));
    for (int m = 0; m < v.width; m++) {
        int index = v.first + m, a = b->of_weight[index];
        if (a >= 0) {
            for (int c = 0; c < dim; c++)
                away[m * dim + c] = sub_i(v.X[m * dim + c], v.D[c]);
            A[m] = inner(dim, v.D, away + m * dim);
            num_i turn = mul_i(v.R[0][m], inner(dim, v.C1, away + m * dim));
            turn = add_i(turn, mul_i(v.R[1][m], A[m]));
            entry[entries++] = (struct entry){a, m, -1, mul_i(v.R[0][m], A[m]), turn};
        }
        for (int c = 0; c < dim; c++) {
            a = b->of_coordinate[index * dim + c];
            if (a >= 0) {
                num_i turn = add_i(mul_i(v.R[0][m], v.C1[c]), mul_i(v.R[1][m], v.D[c]));
                entry[entries++] = (struct entry){a, m, c, mul_i(v.R[0][m], v.D[c]), turn};
            }
        }
    }
    for (int k = 0; k < entries; k++) {
        struct entry *e = &entry[k];
        accumulate(&b->gradient[e->unknown], mul_i(first, e->slope));
        int moves = foot == FOOT_INSIDE || foot == FOOT_NEAR_END;
        num_i turn = moves ? div_i(e->turn, v.slope) : number(0);
        num_i bend = mul_i(second, e->slope);
        for (int l = k; l < entries; l++) {
            struct entry *f = &entry[l];
            int low = e->unknown < f->unknown ? e->unknown : f->unknown, high = e->unknown + f->unknown - low;
            num_i part = second_part(&v, dim, away, A, e, f);
            if (moves) {
                num_i quotient = k == l ? div_i(square(e->turn), v.slope) : mul_i(turn, f->turn);
                part = sub_i(part, foot == FOOT_INSIDE ? quotient : hull(number(0), quotient));
            }
            part = mul_i(first, part);
            if (problem->loss != CAGD_FIT_SQUARES)
                part = add_i(part, mul_i(bend, f->slope));
            accumulate(&b->hessian[low * b->n + high], part);
        }
    }
    return 1;
}

/* Gradient and Hessian over the box, summed over every stride-th point; on failure reason and where say why not. */
static int enclose_some(struct box *b, const double radius[], int stride)
{
    region_mark mark = region_open();
    unsigned before = region_faults;
    int good = 1;
    region_faults = 0;
    box_fill(b, radius);
    for (int i = stride / 2; good && i < b->problem->data->count; i += stride) {
        region_mark one = region_open();
        good = add_point(b, i);
        if (good && region_faults != 0) {
            b->reason = pole;
            good = 0;
        }
        region_drop(one);
    }
    for (int a = 0; good && a < b->n; a++)
        for (int k = 0; k < a; k++) {
            mpfr_set(b->hessian[a * b->n + k].lo, b->hessian[k * b->n + a].lo, MPFR_RNDD);
            mpfr_set(b->hessian[a * b->n + k].hi, b->hessian[k * b->n + a].hi, MPFR_RNDU);
        }
    region_drop(mark);
    region_faults = before;
    if (good) {
        b->reason = NULL;
        b->where = -1;
    }
    return good;
}

static int enclose(struct box *b, const double radius[]) { return enclose_some(b, radius, 1); }

int stationary_enclosures(const stationary_problem *problem, const double radius[], double gradient_low[],
                          double gradient_high[], double hessian_low[], double hessian_high[], int *where)
{
    struct box b;
    int good = box_new(&b, problem) && enclose(&b, radius);
    *where = b.where;
    for (int a = 0; good && a < b.n; a++) {
        gradient_low[a] = mpfr_get_d(b.gradient[a].lo, MPFR_RNDD);
        gradient_high[a] = mpfr_get_d(b.gradient[a].hi, MPFR_RNDU);
        for (int k = a * b.n; k < (a + 1) * b.n; k++) {
            hessian_low[k] = mpfr_get_d(b.hessian[k].lo, MPFR_RNDD);
            hessian_high[k] = mpfr_get_d(b.hessian[k].hi, MPFR_RNDU);
        }
    }
    box_free(&b);
    return good;
}

/* ---- Directions: approximate, in binary64; what is chosen is then taken as exact -------------------- */

/* The eigenvalues of the symmetric matrix A (n x n), which is destroyed, and the eigenvectors as columns of U: cyclic Jacobi
 * rotations until they change nothing. */
static void eigen(int n, double A[], double value[], double U[])
{
    for (int k = 0; k < n * n; k++)
        U[k] = k / n == k % n;
    for (int sweep = 0, changed = 1; changed && sweep < 64; sweep++) {
        changed = 0;
        for (int p = 0; p < n; p++)
            for (int q = p + 1; q < n; q++) {
                double off = A[p * n + q], gap = A[q * n + q] - A[p * n + p];
                if (fabs(gap) + 100 * fabs(off) == fabs(gap) && fabs(A[p * n + p]) + fabs(off) == fabs(A[p * n + p]))
                    continue;
                if (off == 0)
                    continue;
                changed = 1;
                double theta = gap / (2 * off), t = (theta < 0 ? -1 : 1) / (fabs(theta) + hypot(theta, 1));
                double c = 1 / hypot(t, 1), s = t * c;
                for (int k = 0; k < n; k++) {
                    double x = A[k * n + p], y = A[k * n + q];
                    A[k * n + p] = c * x - s * y;
                    A[k * n + q] = s * x + c * y;
                }
                for (int k = 0; k < n; k++) {
                    double x = A[p * n + k], y = A[q * n + k];
                    A[p * n + k] = c * x - s * y;
                    A[q * n + k] = s * x + c * y;
                    x = U[k * n + p], y = U[k * n + q];
                    U[k * n + p] = c * x - s * y;
                    U[k * n + q] = s * x + c * y;
                }
            }
    }
    for (int k = 0; k < n; k++)
        value[k] = A[k * n + k];
}

/* Columns of V: first orthonormal ones that span those of the given `rows` (rows x n, destroyed), then orthonormal ones of the
 * complement, from the unit vectors that are farthest from what is spanned already.  allowed[a] = 0: unit vector a is
 * not used.  Returns how many columns the complement has, which start at column *start. */
static int complement(int n, int rows, double row[], const int allowed[], double V[], int *start)
{
    int columns = 0, wanted = 0, spanned;
    for (int a = 0; a < n; a++)
        wanted += allowed[a];
    for (int pass = 0; pass < rows; pass++) {
        double *x = row + pass * n, norm = 0;
        for (int twice = 0; twice < 2; twice++)
            for (int k = 0; k < columns; k++) {
                double along = 0;
                for (int a = 0; a < n; a++)
                    along += x[a] * V[a * n + k];
                for (int a = 0; a < n; a++)
                    x[a] -= along * V[a * n + k];
            }
        for (int a = 0; a < n; a++)
            norm = hypot(norm, x[a]);
        for (int a = 0; a < n && norm > 0; a++)
            V[a * n + columns] = x[a] / norm;
        columns += norm > 0;
    }
    *start = spanned = columns;
    while (columns < wanted) {
        int best = -1;
        double rest = 0;
        for (int a = 0; a < n; a++) {
            double left = 1;
            for (int k = 0; k < columns; k++)
                left -= V[a * n + k] * V[a * n + k];
            if (allowed[a] && left > rest) {
                rest = left;
                best = a;
            }
        }
        if (best < 0)
            break;
        for (int a = 0; a < n; a++)
            V[a * n + columns] = a == best;
        for (int twice = 0; twice < 2; twice++)
            for (int k = 0; k < columns; k++) {
                double along = 0;
                for (int a = 0; a < n; a++)
                    along += V[a * n + columns] * V[a * n + k];
                for (int a = 0; a < n; a++)
                    V[a * n + columns] -= along * V[a * n + k];
            }
        double norm = 0;
        for (int a = 0; a < n; a++)
            norm = hypot(norm, V[a * n + columns]);
        for (int a = 0; a < n; a++)
            V[a * n + columns] /= norm;
        columns++;
    }
    return columns - spanned;
}

/* W (n x k by columns, W[a*n + j]) and the signs, such that W^T H W is nearly the diagonal of signs; k, or 0 where H is
 * singular as far as binary64 can see.  inverse[j*n + a]: nearly a left inverse of W. */
static int directions(const struct box *b, double W[], double inverse[], int sign[])
{
    const stationary_problem *problem = b->problem;
    int n = b->n, start, k = 0, f = problem->free_count;
    size_t nn = (size_t)n * (size_t)n;
    double *H = malloc(nn * sizeof(double)), *V = malloc(nn * sizeof(double)), *U = malloc(nn * sizeof(double));
    double *scale = malloc((size_t)n * sizeof(double)), *value = malloc((size_t)n * sizeof(double));
    double *row = malloc(((size_t)f * (size_t)n + 1) * sizeof(double));
    int *allowed = malloc((size_t)n * sizeof(int));
    if (H == NULL || V == NULL || U == NULL || scale == NULL || value == NULL || row == NULL || allowed == NULL)
        goto done;
    for (int m = 0; m < n * n; m++)
        H[m] = (mpfr_get_d(b->hessian[m].lo, MPFR_RNDN) + mpfr_get_d(b->hessian[m].hi, MPFR_RNDN)) / 2;
    for (int a = 0; a < n; a++) { /* unit diagonal, by powers of 2 */
        double d = fabs(H[a * n + a]);
        allowed[a] = !is_held(problem, a);
        scale[a] = d > 0 ? ldexp(1, -(int)lround(log2(d) / 2)) : 1;
    }
    for (int m = 0; m < f * n; m++)
        row[m] = allowed[m % n] ? problem->free_directions[m] / scale[m % n] : 0;
    k = complement(n, f, row, allowed, V, &start);
    for (int i = 0; i < k; i++)
        for (int j = 0; j < k; j++) { /* U = V^T scale H scale V, k x k, here as a workspace */
            double sum = 0;
            for (int a = 0; a < n; a++)
                for (int c = 0; c < n; c++)
                    sum += V[a * n + start + i] * scale[a] * H[a * n + c] * scale[c] * V[c * n + start + j];
            U[i * k + j] = sum;
        }
    memcpy(H, U, (size_t)k * (size_t)k * sizeof(double));
    eigen(k, H, value, U);
    double largest = 0;
    for (int j = 0; j < k; j++)
        largest = fmax(largest, fabs(value[j]));
    for (int j = 0; j < k; j++) {
        double root = sqrt(fabs(value[j]));
        sign[j] = value[j] < 0 ? -1 : 1;
        if (!(root > 0)) {
            k = 0;
            break;
        }
        for (int a = 0; a < n; a++) {
            double sum = 0;
            for (int i = 0; i < k; i++)
                sum += V[a * n + start + i] * U[i * k + j];
            W[a * n + j] = scale[a] * sum / root;
            inverse[j * n + a] = sum * root / scale[a];
        }
    }
done:
    free(H), free(V), free(U), free(scale), free(value), free(row), free(allowed);
    return k;
}

/* ---- Krawczyk ---------------------------------------------------------------------------------------- */

/* The largest row sum of sizes of 1 - S W^T H W; or, without signs, of half the widths of W^T H W. */
static double contraction(const struct box *b, int k, const double W[], const int sign[])
{
    int n = b->n;
    double worst = 0;
    for (int i = 0; i < k; i++) {
        region_mark mark = region_open();
        num_i *WH = region_bytes((size_t)n * sizeof(num_i));
        for (int c = 0; c < n; c++)
            for (int a = 0; a < n; a++) {
                num_i term = mul_i(number(W[a * n + i]), (num_i){&b->hessian[a * n + c]});
                WH[c] = a == 0 ? term : add_i(WH[c], term);
            }
        num_i row = number(0);
        for (int j = 0; j < k; j++) {
            num_i sum = number(0);
            for (int c = 0; c < n; c++)
                sum = add_i(sum, mul_i(WH[c], number(W[c * n + j])));
            double size =
                sign == NULL ? width_i(sum) / 2 : size_of(sub_i(number(i == j), sign[i] < 0 ? neg_i(sum) : sum));
            row = add_i(row, number(size));
        }
        worst = fmax(worst, upper_i(row));
        region_drop(mark);
    }
    return worst;
}

/* The largest size of a component of W^T g; newton[a], nearly component a of Newton's step -W S W^T g, and step[a], no smaller than
 * its size. */
static double gradient_size(const struct box *b, int k, const double W[], const int sign[], double newton[],
                            double step[])
{
    double worst = 0;
    region_mark mark = region_open();
    num_i *y = region_bytes((size_t)k * sizeof(num_i));
    for (int j = 0; j < k; j++) {
        y[j] = number(0);
        for (int a = 0; a < b->n; a++)
            y[j] = add_i(y[j], mul_i(number(W[a * b->n + j]), (num_i){&b->gradient[a]}));
        worst = fmax(worst, size_of(y[j]));
    }
    for (int a = 0; a < b->n; a++) {
        num_i sum = number(0);
        for (int j = 0; j < k; j++)
            sum = add_i(sum, mul_i(number(sign[j] * W[a * b->n + j]), y[j]));
        step[a] = size_of(sum);
        newton[a] = -(lower_i(sum) / 2 + upper_i(sum) / 2);
    }
    region_drop(mark);
    return worst;
}

/* What |y| <= r means for unknown a: |theta_a - theta_0a| <= reach_a r. */
static void reaches(int n, int k, const double W[], double reach[])
{
    for (int a = 0; a < n; a++) {
        reach[a] = 0;
        for (int j = 0; j < k; j++)
            reach[a] = nextafter(reach[a] + fabs(W[a * n + j]), INFINITY);
    }
}

/* A number r with |y| <= r for all y with |W y|_a <= unit_a:  y = V W y + (1 - V W) y, V nearly a left inverse of W, gives
 * |y| <= |V| unit + e |y|, where e is the norm of 1 - V W; infinite for e >= 1. */
static double extent(int n, int k, const double W[], const double inverse[], const double unit[])
{
    double most = 0, e = 0;
    region_mark mark = region_open();
    for (int i = 0; i < k; i++) {
        num_i row = number(0), reach = number(0);
        for (int j = 0; j < k; j++) {
            num_i sum = number(i == j);
            for (int a = 0; a < n; a++)
                sum = sub_i(sum, mul_i(number(inverse[i * n + a]), number(W[a * n + j])));
            row = add_i(row, number(size_of(sum)));
        }
        for (int a = 0; a < n; a++)
            reach = add_i(reach, mul_i(number(fabs(inverse[i * n + a])), number(unit[a])));
        e = fmax(e, upper_i(row));
        most = fmax(most, upper_i(reach));
    }
    double r = e < 1 ? upper_i(div_i(number(most), sub_i(number(1), number(e)))) : INFINITY;
    region_drop(mark);
    return r;
}

/* eta/(1-q), rounded up. */
static double radius_of(double eta, double q)
{
    region_mark mark = region_open();
    double r = upper_i(div_i(number(eta), sub_i(number(1), number(q))));
    region_drop(mark);
    return r;
}

/* The size of the measured points: the unit in which radii of coordinates are chosen. */
static double size_of_data(const cagd_fit_data *data)
{
    double size = 0;
    for (int c = 0; c < data->dim; c++) {
        double low = data->points[c], high = low;
        for (int i = 1; i < data->count; i++) {
            low = fmin(low, data->points[i * data->dim + c]);
            high = fmax(high, data->points[i * data->dim + c]);
        }
        size = fmax(size, high - low);
    }
    return size > 0 ? size : 1;
}

static double product_up(double a, double b) { return nextafter(a * b, INFINITY); }

/* An estimate of the contraction for the radius r, from a thousand of many points. */
static double estimated_contraction(struct box *b, int k, double r, const double W[], const double reach[],
                                    double radius[])
{
    int stride = b->problem->data->count / 1000;
    for (int a = 0; a < b->n; a++)
        radius[a] = is_held(b->problem, a) ? 0 : r * reach[a];
    return enclose_some(b, radius, stride) ? stride * contraction(b, k, W, NULL) : NAN;
}

/* The stationary point y is -S W^T g + (1 - S W^T H W) y for some H of the box: it is as far away as Newton's step, but for
 * q |y|.  Radii are tried: first 2^-24 of the unit, farther where the contraction leaves room, nearer where it fails.  q is nearly
 * proportional to the radius. */
static void try_radii(struct box *b, int k, double eta, const double W[], const double inverse[], const int sign[],
                      const double unit[], const double reach[], const double step[], double radius[],
                      stationary_verdict *verdict)
{
    int n = b->n;
    double largest = 0, size = extent(n, k, W, inverse, unit);
    for (int a = 0; a < n; a++)
        largest = fmax(largest, reach[a] / unit[a]);
    double r = fmax(0x1p-24 / largest, 4 * eta), verified = 0, q_verified = 1;
    int many = b->problem->data->count >= 4000;
    if (many) { /* every attempt is dear: the first one is to be the last */
        double q = estimated_contraction(b, k, r, W, reach, radius);
        r = q > 0 ? fmax(r * fmin(0.25 / q, 0x1p16), 4 * eta) : r;
    }
    for (int attempt = 0; attempt < 5; attempt++) {
        double q = INFINITY;
        for (int a = 0; a < n; a++)
            radius[a] = is_held(b->problem, a) ? 0 : product_up(reach[a], r);
        int small = product_up(largest, r) <= 0.5;
        if (small && enclose(b, radius))
            q = contraction(b, k, W, sign);
        int good = q < 1 && radius_of(eta, q) < r;
        if (good) {
            verified = r;
            q_verified = fmin(q, q_verified);
            if (q > 0.125 || attempt > 0 || many)
                break;
            r *= fmin(0.5 / q, 0x1p16);
        } else {
            if (verified > 0)
                break;
            verdict->reason = !small ? "the gradient is too large" : b->reason;
            verdict->where = b->where;
            if (verdict->reason == NULL)
                verdict->reason = "the derivatives vary too much near the reported curve, or its gradient is too large";
            r *= q < INFINITY ? 0.25 / q : 0x1p-8;
            if (r <= eta)
                break;
        }
    }
    if (!(verified > 0))
        return;
    verdict->verified = 1;
    verdict->minimum = 1;
    verdict->reason = NULL;
    verdict->where = -1;
    for (int j = 0; j < k; j++)
        verdict->minimum &= sign[j] > 0;
    double near = radius_of(eta, q_verified), alone = nextafter(verified / size, 0), data_unit = 0;
    for (int a = 0; a < n; a++) {
        if (is_held(b->problem, a))
            continue;
        double *to = b->problem->unknown[a].is_weight ? &verdict->weight_radius : &verdict->point_radius;
        *to = fmax(*to, nextafter(step[a] + product_up(reach[a], product_up(q_verified, near)), INFINITY));
        if (!b->problem->unknown[a].is_weight)
            data_unit = unit[a];
    }
    verdict->weight_alone = alone;
    verdict->point_alone = nextafter(alone * data_unit, 0);
}

/* What the check works with, besides the box; arrays of unknowns numbers each, in one piece of memory. */
struct workspace {
    double *W, *inverse, *radius, *reach, *step, *newton, *unit, *moved, *points, *weights, *memory;
    int *sign;
};

static int workspace_new(struct workspace *s, const stationary_problem *problem)
{
    size_t n = (size_t)problem->unknowns, count = (size_t)problem->curve->count, dim = (size_t)problem->curve->dim;
    s->memory = calloc(2 * n * n + 6 * n + count * (dim + 1) + 1, sizeof(double));
    s->sign = malloc((n + 1) * sizeof(int));
    if (s->memory == NULL || s->sign == NULL)
        return 0;
    s->W = s->memory;
    s->inverse = s->W + n * n;
    s->radius = s->inverse + n * n;
    s->reach = s->radius + n;
    s->step = s->reach + n;
    s->newton = s->step + n;
    s->unit = s->newton + n;
    s->moved = s->unit + n;
    s->points = s->moved + n;
    s->weights = s->points + count * dim;
    memcpy(s->points, problem->curve->points, count * dim * sizeof(double));
    for (size_t i = 0; i < count; i++)
        s->weights[i] = problem->curve->weights != NULL ? problem->curve->weights[i] : 1;
    return 1;
}

/* The centre moves by Newton's step, in binary64; moved[a] is no smaller than the way from the reported unknown to it:
 * for a weight |log(v/w)| <= |v - w|/min(v, w). */
static void move_centre(const stationary_problem *problem, struct workspace *s)
{
    for (int a = 0; a < problem->unknowns; a++) {
        const cagd_fit_unknown *u = &problem->unknown[a];
        double *x = u->is_weight ? &s->weights[u->index] : &s->points[u->index * problem->curve->dim + u->coordinate];
        double from = !u->is_weight                     ? problem->curve->points[x - s->points]
                      : problem->curve->weights != NULL ? problem->curve->weights[u->index]
                                                        : 1;
        if (is_held(problem, a))
            continue;
        *x = u->is_weight ? *x * exp(s->newton[a]) : *x + s->newton[a];
        s->moved[a] = nextafter(fabs(*x - from), INFINITY);
        if (u->is_weight)
            s->moved[a] = nextafter(s->moved[a] / fmin(*x, from), INFINITY);
    }
}

/* The radii are those from the reported unknowns, not from the centre. */
static void add_way(const stationary_problem *problem, const double moved[], double data_unit,
                    stationary_verdict *verdict)
{
    double weights = 0, coordinates = 0;
    for (int a = 0; a < problem->unknowns; a++) {
        double *way = problem->unknown[a].is_weight ? &weights : &coordinates;
        *way = fmax(*way, moved[a]);
    }
    verdict->weight_radius = nextafter(verdict->weight_radius + weights, INFINITY);
    verdict->point_radius = nextafter(verdict->point_radius + coordinates, INFINITY);
    double less = nextafter(fmax(weights, nextafter(coordinates / data_unit, INFINITY)), INFINITY);
    verdict->weight_alone = fmax(0, nextafter(verdict->weight_alone - less, 0));
    verdict->point_alone = fmax(0, nextafter(verdict->point_alone - less * data_unit, 0));
}

stationary_verdict stationary_check(const stationary_problem *problem)
{
    enum { MOVES = 4 };
    stationary_verdict verdict = {.where = -1, .reason = no_memory};
    struct workspace s = {0};
    cagd_spline centre = *problem->curve;
    stationary_problem moving = *problem;
    moving.curve = &centre;
    struct box b;
    int room = box_new(&b, &moving) & workspace_new(&s, problem);
    double size = size_of_data(problem->data), largest = 0;
    centre.points = s.points;
    centre.weights = s.weights;
    for (int a = 0; room && a < b.n; a++)
        s.unit[a] = problem->unknown[a].is_weight ? 1 : size;
    for (int move = 0; room && !verdict.verified && move <= MOVES; move++) {
        for (int a = 0; a < b.n; a++)
            s.radius[a] = 0;
        if (!enclose(&b, s.radius)) {
            if (move == 0) {
                verdict.reason = b.n == 0 ? "nothing is free" : b.reason;
                verdict.where = b.where;
            }
            break;
        }
        verdict.dimension = directions(&b, s.W, s.inverse, s.sign);
        if (verdict.dimension == 0) {
            verdict.reason = b.n == 0 ? "nothing is free" : "the Hessian is singular";
            break;
        }
        reaches(b.n, verdict.dimension, s.W, s.reach);
        double eta = gradient_size(&b, verdict.dimension, s.W, s.sign, s.newton, s.step), step = 0;
        try_radii(&b, verdict.dimension, eta, s.W, s.inverse, s.sign, s.unit, s.reach, s.step, s.radius, &verdict);
        for (int a = 0; a < b.n; a++)
            step = fmax(step, s.step[a] / s.unit[a]);
        if (verdict.verified || !(step < 0x1p-10) || (move > 0 && !(step < largest / 2)))
            break;
        largest = step;
        move_centre(problem, &s);
    }
    if (verdict.verified)
        add_way(problem, s.moved, size, &verdict);
    box_free(&b);
    free(s.memory);
    free(s.sign);
    return verdict;
}

stationary_verdict stationary_check_fit(const cagd_fit_data *data, const cagd_fit_options *options,
                                        const cagd_fit_result *result)
{
    int held = 0;
    for (int a = 0; a < result->unknowns; a++)
        held += result->at_bound[a] != 0;
    stationary_problem problem = {.data = data,
                                  .loss = options->loss,
                                  .loss_scale = options->loss_scale,
                                  .curve = &result->curve,
                                  .feet = result->feet,
                                  .unknowns = result->unknowns,
                                  .unknown = result->unknown,
                                  .held = result->at_bound,
                                  .free_count = result->unknowns - held - result->rank,
                                  .free_directions = result->free_directions};
    return stationary_check(&problem);
}
