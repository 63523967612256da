/* box.c -- gradient and Hessian of the cost over a box of unknowns, point by point. */
#include "exact/fit/box.h"

#include "exact/fit/foot.h"
#include "exact/fit/smooth.h"
#include "exact/fit/words.h"

#include <math.h>
#include <stdlib.h>

enum { ENTRIES = WIDTH * MAX_DIM }; /* unknowns that count at one point */

static const char *const pole = "the derivatives at this point cannot be enclosed";

/* ---- the box -------------------------------------------------------------------------------------- */

int cagd_stationary_box_new(struct box *b, const cagd_stationary_problem *problem)
{
    const cagd_spline *curve = problem->curve;
    size_t count = (size_t)curve->count, dim = (size_t)curve->dim, n = (size_t)problem->unknowns;
    *b = (struct box){.problem = problem, .n = problem->unknowns, .where = -1};
    b->of_weight = malloc(count * sizeof(int));
    b->of_coordinate = malloc(count * dim * sizeof(int));
    b->knot = malloc((count + (size_t)curve->degree + 1) * sizeof(num_i));
    b->point = malloc(count * dim * sizeof(num_i));
    b->weight = malloc(count * sizeof(num_i));
    b->gradient = malloc((n + 1) * sizeof(struct cagd_interval));
    b->hessian = malloc((n * n + 1) * sizeof(struct cagd_interval));
    if (b->gradient != NULL)
        cagd_sums_init(b->n, b->gradient);
    if (b->hessian != NULL)
        cagd_sums_init(b->n * b->n, b->hessian);
    if (b->of_weight == NULL || b->of_coordinate == NULL || b->knot == NULL || b->point == NULL || b->weight == NULL ||
        b->gradient == NULL || b->hessian == NULL)
        return 0;
    for (size_t i = 0; i < count; i++)
        b->of_weight[i] = -1;
    for (size_t m = 0; m < count * dim; m++)
        b->of_coordinate[m] = -1;
    for (int a = 0; a < b->n; a++) {
        const cagd_fit_unknown *u = &problem->unknown[a];
        for (int i = 0; i < curve->count; i++)
            if (own_point(problem, i) == u->index)
                *(u->is_weight ? &b->of_weight[i] : &b->of_coordinate[i * curve->dim + u->coordinate]) = a;
    }
    return 1;
}

void cagd_stationary_box_free(struct box *b)
{
    if (b->gradient != NULL)
        cagd_sums_clear(b->n, b->gradient);
    if (b->hessian != NULL)
        cagd_sums_clear(b->n * b->n, b->hessian);
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
        b->knot[i] = from_double_i(curve->knots[i]);
    for (int i = 0; i < curve->count; i++) {
        double w = curve->weights != NULL ? curve->weights[i] : 1;
        b->weight[i] =
            b->of_weight[i] < 0 ? from_double_i(w) : mul_i(from_double_i(w), exp_around_i(radius[b->of_weight[i]]));
    }
    for (int m = 0; m < curve->count * curve->dim; m++) {
        int a = b->of_coordinate[m];
        b->point[m] = a < 0 ? from_double_i(curve->points[m]) : around_i(curve->points[m], radius[a]);
        if (b->rest != NULL)
            b->point[m] = add_i(b->point[m], from_double_i(b->rest[m]));
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

/* ---- what a point adds ------------------------------------------------------------------------------ */

/* rho'(s) and rho''(s), the latter the hull of both one-sided values where it jumps. */
static void loss_derivatives(const cagd_stationary_problem *problem, num_i s, num_i *first, num_i *second)
{
    num_i one = from_double_i(1), a = from_double_i(problem->loss_scale), aa = mul_i(a, a);
    *first = one;
    *second = from_double_i(0);
    if (problem->loss == CAGD_FIT_CAUCHY) {
        *first = div_i(one, add_i(one, div_i(s, aa)));
        *second = neg_i(div_i(mul_i(*first, *first), aa));
    }
    if (problem->loss == CAGD_FIT_HUBER && sign_i(sub_i(s, aa)) >= 0 && !mpfr_lessequal_p(s.at->hi, aa.at->lo)) {
        num_i outside = hull_i(aa, from_double_i(INFINITY)), beyond = nearest_in_i(outside, s),
              root = root_i(2, beyond);
        num_i slope = div_i(a, root), bend = neg_i(div_i(slope, mul_i(from_double_i(2), beyond)));
        int straddles = mpfr_less_p(s.at->lo, aa.at->hi);
        *first = straddles ? hull_i(one, slope) : slope;
        *second = straddles ? hull_i(from_double_i(0), bend) : bend;
    }
}

/* An unknown that counts at this point. */
struct entry {
    int unknown, m, c;     /* c = -1: the weight of m                                             */
    num_i slope, turn;     /* D.C_a, and C_a.C' + D.C_a' at phi = 0                               */
    num_i along, lean;     /* these two, C_a.C' and D.C_a'                                        */
    num_i across[MAX_DIM]; /* C_a x C', of the plane one number                               */
};

/* C_a = R_m d, C_a' = R_m' d and what is made of them: d is P_m - C, of a weight, or e_c. */
static struct entry entry_of(const struct view *v, int dim, int unknown, int m, int c, const num_i d[], num_i inner)
{
    struct entry e = {.unknown = unknown, .m = m, .c = c};
    e.slope = mul_i(v->R[0][m], inner);
    e.along = mul_i(v->R[0][m], c < 0 ? inner_i(dim, v->C1, d) : v->C1[c]);
    e.lean = mul_i(v->R[1][m], inner);
    e.turn = add_i(e.along, e.lean);
    for (int k = 0; k < (dim == 2 ? 1 : 3); k++) {
        const int x = dim == 2 ? 0 : (k + 1) % 3, y = dim == 2 ? 1 : (k + 2) % 3;
        e.across[k] = mul_i(v->R[0][m], sub_i(mul_i(d[x], v->C1[y]), mul_i(d[y], v->C1[x])));
    }
    return e;
}

/* What does not cancel of C_e.C_f - (C_e.C' + D.C_e')(C_f.C' + D.C_f')/phi', the same by
 *
 *     (C_e x C').(C_f x C')/|C'|^2 + (C_e.C')(C_f.C') D.C''/(|C'|^2 phi') - (C_e.C' D.C_f' + D.C_e' (C_f.C' + D.C_f'))/phi'.
 *
 * Where one coordinate is much larger than the other, most of C_e.C_f is along the curve.  speed: |C'|^2; bend: D.C''/(|C'|^2 phi'). */
static num_i across_part(const struct view *v, int dim, num_i speed, num_i bend, const struct entry *e,
                         const struct entry *f)
{
    num_i sum = e == f && dim == 2 ? square_i(e->across[0]) : inner_i(dim == 2 ? 1 : 3, e->across, f->across);
    sum = add_i(div_i(sum, speed), mul_i(mul_i(e->along, f->along), bend));
    return sub_i(sum, div_i(add_i(mul_i(e->along, f->lean), mul_i(e->lean, f->turn)), v->slope));
}

/* C_e.C_f for e <= f. */
static num_i first_part(const struct view *v, int dim, const num_i *away, const struct entry *e, const struct entry *f)
{
    const num_i both = mul_i(v->R[0][e->m], v->R[0][f->m]);
    if (e->c >= 0 && f->c >= 0)
        return e->c == f->c ? both : from_double_i(0);
    if (e->c < 0 && f->c < 0)
        return mul_i(both, inner_i(dim, away + e->m * dim, away + f->m * dim));
    return mul_i(both, away[(e->c < 0 ? e->m : f->m) * dim + (e->c < 0 ? f->c : e->c)]);
}

/* D.C_ef for e <= f. */
static num_i second_part(const struct view *v, const num_i *A, const struct entry *e, const struct entry *f)
{
    if (e->c >= 0 && f->c >= 0)
        return from_double_i(0);
    const num_i both = mul_i(v->R[0][e->m], v->R[0][f->m]);
    if (e->c < 0 && f->c < 0) {
        const num_i sum = neg_i(mul_i(both, add_i(A[e->m], A[f->m])));
        return e->m == f->m ? add_i(sum, mul_i(v->R[0][e->m], A[e->m])) : sum;
    }
    const struct entry *w = e->c < 0 ? e : f, *x = e->c < 0 ? f : e;
    const num_i sum = neg_i(mul_i(both, v->D[x->c]));
    return w->m == x->m ? add_i(sum, mul_i(v->R[0][x->m], v->D[x->c])) : sum;
}

/* Adds what point i adds to gradient and Hessian. */
static int add_point(struct box *b, int i)
{
    const cagd_stationary_problem *problem = b->problem;
    struct view v;
    struct entry entry[ENTRIES];
    num_i away[WIDTH * MAX_DIM], A[WIDTH], first, second, speed = from_double_i(0), unit[MAX_DIM][MAX_DIM];
    int dim = problem->curve->dim, entries = 0;
    enum foot foot = cagd_stationary_enclose_foot(b, i, &v);
    if (foot == NO_FOOT || foot == FOOT_ON_FIXED_END)
        return foot == FOOT_ON_FIXED_END;
    num_i sigma = from_double_i(problem->data->sigma != NULL ? problem->data->sigma[i] : 1), s = from_double_i(0);
    num_i precision = div_i(from_double_i(1), square_i(sigma));
    for (int c = 0; c < dim; c++) {
        s = add_i(s, square_i(v.D[c]));
        speed = add_i(speed, square_i(v.C1[c]));
        for (int k = 0; k < dim; k++)
            unit[c][k] = from_double_i(k == c);
    }
    const int inside = foot == FOOT_INSIDE && sign_i(speed) > 0;
    const num_i bend_along = inside ? div_i(inner_i(dim, v.D, v.C2), mul_i(speed, v.slope)) : from_double_i(0);
    loss_derivatives(problem, mul_i(s, precision), &first, &second);
    first = mul_i(first, precision);
    second = mul_i(mul_i(from_double_i(2), second), square_i(precision));
    for (int m = 0; m < v.width; m++) {
        int index = v.first + m, a = b->of_weight[index];
        if (a >= 0) {
            for (int c = 0; c < dim; c++)
                away[m * dim + c] = sub_i(v.X[m * dim + c], v.D[c]);
            A[m] = inner_i(dim, v.D, away + m * dim);
            entry[entries++] = entry_of(&v, dim, a, m, -1, away + m * dim, A[m]);
        }
        for (int c = 0; c < dim; c++) {
            a = b->of_coordinate[index * dim + c];
            if (a >= 0)
                entry[entries++] = entry_of(&v, dim, a, m, c, unit[c], v.D[c]);
        }
    }
    for (int k = 0; k < entries; k++) {
        struct entry *e = &entry[k];
        cagd_accumulate(&b->gradient[e->unknown], mul_i(first, e->slope));
        int moves = foot == FOOT_INSIDE || foot == FOOT_NEAR_END;
        num_i turn = moves && !inside ? div_i(e->turn, v.slope) : from_double_i(0);
        num_i bend = mul_i(second, e->slope);
        for (int l = k; l < entries; l++) {
            struct entry *f = &entry[l];
            int low = e->unknown < f->unknown ? e->unknown : f->unknown, high = e->unknown + f->unknown - low;
            num_i part = second_part(&v, A, e, f);
            part =
                add_i(part, inside ? across_part(&v, dim, speed, bend_along, e, f) : first_part(&v, dim, away, e, f));
            if (moves && !inside) {
                num_i quotient = k == l ? div_i(square_i(e->turn), v.slope) : mul_i(turn, f->turn);
                part = sub_i(part, foot == FOOT_INSIDE ? quotient : hull_i(from_double_i(0), quotient));
            }
            part = mul_i(first, part);
            if (problem->loss != CAGD_FIT_SQUARES)
                part = add_i(part, mul_i(bend, f->slope));
            if (k != l && low == high) /* two places of the same unknown of a closed curve: (e, f) and (f, e) */
                part = add_i(part, part);
            cagd_accumulate(&b->hessian[low * b->n + high], part);
        }
    }
    return 1;
}

int cagd_stationary_enclose(struct box *b, const double radius[], int stride)
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
    if (good && b->problem->smooth > 0)
        cagd_stationary_smooth(b, stride);
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

int cagd_stationary_enclosures(const cagd_stationary_problem *problem, const double radius[], double gradient_low[],
                               double gradient_high[], double hessian_low[], double hessian_high[], int *where)
{
    struct box b;
    int good = cagd_stationary_box_new(&b, problem) && cagd_stationary_enclose(&b, radius, 1);
    *where = b.where;
    for (int a = 0; good && a < b.n; a++) {
        gradient_low[a] = mpfr_get_d(b.gradient[a].lo, MPFR_RNDD);
        gradient_high[a] = mpfr_get_d(b.gradient[a].hi, MPFR_RNDU);
        for (int k = a * b.n; k < (a + 1) * b.n; k++) {
            hessian_low[k] = mpfr_get_d(b.hessian[k].lo, MPFR_RNDD);
            hessian_high[k] = mpfr_get_d(b.hessian[k].hi, MPFR_RNDU);
        }
    }
    cagd_stationary_box_free(&b);
    return good;
}
