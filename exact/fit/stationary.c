/* stationary.c -- Krawczyk's test around the reported curve: which radii are tried, and what the verdict says. */
#include "exact/fit/stationary.h"

#include "exact/fit/box.h"
#include "exact/fit/directions.h"
#include "exact/fit/words.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char *const no_memory = "there is not enough memory";

/* ---- Krawczyk's test -------------------------------------------------------------------------------- */

/* The largest row sum of sizes of 1 - S W^T H W; or, without signs, of half the widths of W^T H W. */
static double contraction(const struct box *b, int k, const double W[], const int sign[])
{
    int n = b->n;
    double worst = 0;
    for (int i = 0; i < k; i++) {
        region_mark mark = region_open();
        num_i *WH = cagd_region_array(1, n, sizeof *WH);
        if (WH == NULL)
            return INFINITY;
        for (int c = 0; c < n; c++)
            for (int a = 0; a < n; a++) {
                num_i term = mul_i(from_double_i(W[a * n + i]), (num_i){&b->hessian[a * n + c]});
                WH[c] = a == 0 ? term : add_i(WH[c], term);
            }
        num_i row = from_double_i(0);
        for (int j = 0; j < k; j++) {
            num_i sum = from_double_i(0);
            for (int c = 0; c < n; c++)
                sum = add_i(sum, mul_i(WH[c], from_double_i(W[c * n + j])));
            double size =
                sign == NULL ? width_i(sum) / 2 : size_i(sub_i(from_double_i(i == j), sign[i] < 0 ? neg_i(sum) : sum));
            row = add_i(row, from_double_i(size));
        }
        worst = fmax(worst, upper_i(row));
        region_drop(mark);
    }
    return worst;
}

/* The largest size of a component of W^T g; newton[a], nearly component a of Newton's step -W S W^T g, and step[a],
 * no smaller than its size. */
static double gradient_size(const struct box *b, int k, const double W[], const int sign[], double newton[],
                            double step[])
{
    double worst = 0;
    region_mark mark = region_open();
    num_i *y = cagd_region_array(1, k, sizeof *y);
    if (y == NULL)
        return INFINITY;
    for (int j = 0; j < k; j++) {
        y[j] = from_double_i(0);
        for (int a = 0; a < b->n; a++)
            y[j] = add_i(y[j], mul_i(from_double_i(W[a * b->n + j]), (num_i){&b->gradient[a]}));
        worst = fmax(worst, size_i(y[j]));
    }
    for (int a = 0; a < b->n; a++) {
        num_i sum = from_double_i(0);
        for (int j = 0; j < k; j++)
            sum = add_i(sum, mul_i(from_double_i(sign[j] * W[a * b->n + j]), y[j]));
        step[a] = size_i(sum);
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

/* A number r with |y| <= r for all y with |W y|_a <= unit_a:  y = V W y + (1 - V W) y, V nearly a left inverse of W,
 * gives |y| <= |V| unit + e |y|, where e is the norm of 1 - V W; infinite for e >= 1. */
static double extent(int n, int k, const double W[], const double inverse[], const double unit[])
{
    double most = 0, e = 0;
    region_mark mark = region_open();
    for (int i = 0; i < k; i++) {
        num_i row = from_double_i(0), reach = from_double_i(0);
        for (int j = 0; j < k; j++) {
            num_i sum = from_double_i(i == j);
            for (int a = 0; a < n; a++)
                sum = sub_i(sum, mul_i(from_double_i(inverse[i * n + a]), from_double_i(W[a * n + j])));
            row = add_i(row, from_double_i(size_i(sum)));
        }
        for (int a = 0; a < n; a++)
            reach = add_i(reach, mul_i(from_double_i(fabs(inverse[i * n + a])), from_double_i(unit[a])));
        e = fmax(e, upper_i(row));
        most = fmax(most, upper_i(reach));
    }
    double r = e < 1 ? upper_i(div_i(from_double_i(most), sub_i(from_double_i(1), from_double_i(e)))) : INFINITY;
    region_drop(mark);
    return r;
}

/* eta/(1-q), rounded up. */
static double radius_of(double eta, double q)
{
    region_mark mark = region_open();
    double r = upper_i(div_i(from_double_i(eta), sub_i(from_double_i(1), from_double_i(q))));
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
    return cagd_stationary_enclose(b, radius, stride) ? stride * contraction(b, k, W, NULL) : NAN;
}

/* The signs of the multipliers over the box; when it cannot be enclosed they are not known. */
static void leave_bounds(struct box *b, const double radius[], cagd_stationary_verdict *verdict)
{
    int enclosed = -1; /* not tried */
    for (int a = 0; a < b->n; a++) {
        int hold = is_held(b->problem, a) ? b->problem->held[a] : CAGD_STATIONARY_FREE, sign = 0;
        if (hold != CAGD_STATIONARY_AT_LOW && hold != CAGD_STATIONARY_AT_HIGH)
            continue;
        if (enclosed < 0)
            enclosed = cagd_stationary_enclose(b, radius, 1);
        if (enclosed)
            sign = sign_i((num_i){&b->gradient[a]}) * (hold == CAGD_STATIONARY_AT_LOW ? 1 : -1);
        enum cagd_stationary_bounds now = sign > 0   ? CAGD_STATIONARY_GROWS
                                          : sign < 0 ? CAGD_STATIONARY_FALLS
                                                     : CAGD_STATIONARY_OPEN;
        if (verdict->bounds == CAGD_STATIONARY_NO_BOUNDS || (now == CAGD_STATIONARY_FALLS && verdict->bounds != now) ||
            (now == CAGD_STATIONARY_OPEN && verdict->bounds == CAGD_STATIONARY_GROWS)) {
            verdict->bounds = now;
            verdict->bound = now == CAGD_STATIONARY_GROWS ? -1 : a;
        }
        verdict->minimum &= now == CAGD_STATIONARY_GROWS;
    }
}

/* The stationary point y is -S W^T g + (1 - S W^T H W) y for some H of the box: it is as far away as Newton's step,
 * but for q |y|.  Radii are tried: first 2^-24 of the unit, farther where the contraction leaves room, nearer where
 * it fails.  q is nearly proportional to the radius. */
static void try_radii(struct box *b, int k, double eta, const double W[], const double inverse[], const int sign[],
                      const double unit[], const double reach[], const double step[], double radius[],
                      cagd_stationary_verdict *verdict)
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
        if (small && cagd_stationary_enclose(b, radius, 1))
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
    for (int a = 0; a < n; a++)
        radius[a] = is_held(b->problem, a) ? 0 : product_up(reach[a], near);
    leave_bounds(b, radius, verdict);
}

/* No unknown is free, and some stand on bounds: the curve is what it is, and the multipliers decide. */
static void check_bounds_alone(struct box *b, double radius[], cagd_stationary_verdict *verdict)
{
    int at_bound = 0;
    for (int a = 0; a < b->n; a++) {
        radius[a] = 0;
        if (!is_held(b->problem, a))
            return;
        at_bound |= b->problem->held[a] != CAGD_STATIONARY_HELD;
    }
    if (!at_bound)
        return;
    verdict->verified = verdict->minimum = 1;
    verdict->reason = NULL;
    leave_bounds(b, radius, verdict);
}

/* What the check works with, besides the box; arrays of unknowns numbers each, in one piece of memory. */
struct workspace {
    double *W, *inverse, *radius, *reach, *step, *newton, *unit, *moved, *points, *rest, *weights, *memory;
    int *sign;
};

static int workspace_new(struct workspace *s, const cagd_stationary_problem *problem)
{
    size_t n = (size_t)problem->unknowns, count = (size_t)problem->curve->count, dim = (size_t)problem->curve->dim;
    s->memory = calloc(2 * n * n + 6 * n + count * (2 * dim + 1) + 1, sizeof(double));
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
    s->rest = s->points + count * dim;
    s->weights = s->rest + count * dim;
    memcpy(s->points, problem->curve->points, count * dim * sizeof(double));
    for (size_t i = 0; i < count; i++)
        s->weights[i] = problem->curve->weights != NULL ? problem->curve->weights[i] : 1;
    return 1;
}

/* The centre moves by Newton's step: a coordinate is the sum of two numbers in binary64, since where one coordinate is much larger than the
 * other one number would not come near enough.  moved[a] is no smaller than the way from the reported unknown to it: for a weight
 * |log(v/w)| <= |v - w|/min(v, w). */
static void move_centre(const cagd_stationary_problem *problem, struct workspace *s)
{
    for (int a = 0; a < problem->unknowns; a++) {
        const cagd_fit_unknown *u = &problem->unknown[a];
        const int at = u->index + problem->shift;
        double *x = u->is_weight ? &s->weights[at] : &s->points[at * problem->curve->dim + u->coordinate];
        double from = !u->is_weight                     ? problem->curve->points[x - s->points]
                      : problem->curve->weights != NULL ? problem->curve->weights[at]
                                                        : 1;
        if (is_held(problem, a))
            continue;
        if (u->is_weight) {
            *x *= exp(s->newton[a]);
            s->moved[a] = nextafter(nextafter(fabs(*x - from), INFINITY) / fmin(*x, from), INFINITY);
        } else {
            double *rest = &s->rest[x - s->points], before = *x, way = *rest + s->newton[a];
            *x += way;
            *rest = (before - *x) + way;
            s->moved[a] = nextafter(nextafter(fabs(*x - from), INFINITY) + fabs(*rest), INFINITY);
        }
    }
    const int dim = problem->curve->dim;
    for (int i = 0; problem->period > 0 && i < problem->curve->count; i++) { /* the same points once more */
        const int from = own_point(problem, i) + problem->shift;
        memmove(s->points + i * dim, s->points + from * dim, (size_t)dim * sizeof *s->points);
        memmove(s->rest + i * dim, s->rest + from * dim, (size_t)dim * sizeof *s->rest);
        s->weights[i] = s->weights[from];
    }
}

/* The radii are those from the reported unknowns, not from the centre. */
static void add_way(const cagd_stationary_problem *problem, const double moved[], double data_unit,
                    cagd_stationary_verdict *verdict)
{
    double weights = 0, coordinates = 0;
    for (int a = 0; a < problem->unknowns; a++) {
        double *way = problem->unknown[a].is_weight ? &weights : &coordinates;
        *way = fmax(*way, moved[a]);
    }
    if (weights == 0 && coordinates == 0)
        return;
    verdict->weight_radius = nextafter(verdict->weight_radius + weights, INFINITY);
    verdict->point_radius = nextafter(verdict->point_radius + coordinates, INFINITY);
    double less = nextafter(fmax(weights, nextafter(coordinates / data_unit, INFINITY)), INFINITY);
    verdict->weight_alone = fmax(0, nextafter(verdict->weight_alone - less, 0));
    verdict->point_alone = fmax(0, nextafter(verdict->point_alone - less * data_unit, 0));
}

cagd_stationary_verdict cagd_stationary_check(const cagd_stationary_problem *problem)
{
    enum { MOVES = 4 };
    cagd_stationary_verdict verdict = {.bound = -1, .where = -1, .reason = no_memory};
    struct workspace s = {0};
    cagd_spline centre = *problem->curve;
    cagd_stationary_problem moving = *problem;
    moving.curve = &centre;
    struct box b;
    int room = cagd_stationary_box_new(&b, &moving) & workspace_new(&s, problem);
    double size = size_of_data(problem->data), largest = 0;
    centre.points = s.points;
    centre.weights = s.weights;
    b.rest = s.rest;
    for (int a = 0; room && a < b.n; a++)
        s.unit[a] = problem->unknown[a].is_weight ? 1 : size;
    for (int move = 0; room && !verdict.verified && move <= MOVES; move++) {
        for (int a = 0; a < b.n; a++)
            s.radius[a] = 0;
        if (!cagd_stationary_enclose(&b, s.radius, 1)) {
            if (move == 0) {
                verdict.reason = b.n == 0 ? "nothing is free" : b.reason;
                verdict.where = b.where;
            }
            break;
        }
        verdict.dimension = cagd_stationary_directions(&b, s.W, s.inverse, s.sign);
        if (verdict.dimension < 0) {
            verdict.dimension = 0;
            verdict.reason = no_memory;
            break;
        }
        if (verdict.dimension == 0) {
            int free_ones = 0;
            for (int a = 0; a < b.n; a++)
                free_ones += !is_held(&moving, a);
            verdict.reason = free_ones == 0 ? "nothing is free" : "the Hessian is singular";
            check_bounds_alone(&b, s.radius, &verdict);
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
    cagd_stationary_box_free(&b);
    free(s.memory);
    free(s.sign);
    return verdict;
}

/* The bound on which weight a stands: the nearer one. */
static int bound_of(const cagd_fit_options *options, double log_weight)
{
    double below = log_weight - log(options->weight_low), above = log(options->weight_high) - log_weight;
    return below < above ? CAGD_STATIONARY_AT_LOW : CAGD_STATIONARY_AT_HIGH;
}

/* The closed curve with one more span on both sides of its domain.  The array belongs to the caller; NULL when there is no memory. */
static double *extend(const cagd_fit_result *result, cagd_spline *curve)
{
    const cagd_spline *c = &result->curve;
    const int n = result->period, p = c->degree, count = c->count + 2, dim = c->dim;
    const double length = c->knots[c->count] - c->knots[p];
    double *knots = malloc((size_t)(count * (dim + 2) + p + 1) * sizeof *knots), *weights = knots + count + p + 1,
           *points = weights + count;
    if (knots == NULL)
        return NULL;
    memcpy(knots + 1, c->knots, (size_t)(c->count + p + 1) * sizeof *knots);
    knots[0] = c->knots[n - 1] - length;
    knots[count + p] = c->knots[2 * p + 1] + length;
    for (int i = 0; i < count; i++) {
        const int from = (i - 1 + n) % n;
        weights[i] = c->weights[from];
        memcpy(points + i * dim, result->relative + from * dim, (size_t)dim * sizeof *points);
    }
    *curve = (cagd_spline){p, count, dim, knots, points, weights};
    return knots;
}

cagd_stationary_verdict cagd_stationary_check_fit(const cagd_fit_data *data, const cagd_fit_options *options,
                                                  const cagd_fit_result *result)
{
    if (result->tied > 0)
        return (cagd_stationary_verdict){
            .bound = -1, .where = -1, .reason = "points share a foot, and the verification takes every foot by itself"};
    const int first = result->left_out[0],
              end_points[2] = {result->end_points[0] - first, result->end_points[1] - first};
    cagd_fit_data near = {data->count - first - result->left_out[1], data->dim, NULL,
                          data->sigma != NULL ? data->sigma + first : NULL};
    size_t numbers = (size_t)near.count * (size_t)data->dim, start = (size_t)first * (size_t)data->dim;
    int count = 0, *held = malloc(((size_t)result->unknowns + 1) * sizeof *held);
    double *points = malloc(numbers * sizeof *points), *extended = NULL;
    cagd_spline curve = result->curve;
    curve.points = result->relative;
    if (result->period > 0)
        extended = extend(result, &curve);
    if (held == NULL || points == NULL || (result->period > 0 && extended == NULL)) {
        free(held);
        free(points);
        free(extended);
        return (cagd_stationary_verdict){.bound = -1, .where = -1, .reason = no_memory};
    }
    for (size_t m = 0; m < numbers; m++)
        points[m] = data->points[start + m] - result->origin[m % (size_t)data->dim]; /* exactly */
    near.points = points;
    for (int a = 0; a < result->unknowns; a++) {
        held[a] = result->at_bound[a] ? bound_of(options, result->value[a]) : CAGD_STATIONARY_FREE;
        count += held[a] != CAGD_STATIONARY_FREE;
    }
    cagd_stationary_problem problem = {.data = &near,
                                       .loss = options->loss,
                                       .loss_scale = result->loss_scale,
                                       .smooth = options->smooth > 0 ? options->smooth : result->found.smooth,
                                       .curve = &curve,
                                       .period = result->period,
                                       .shift = result->period > 0,
                                       .feet = result->feet + first,
                                       .end_points = end_points,
                                       .unknowns = result->unknowns,
                                       .unknown = result->unknown,
                                       .held = held,
                                       .free_count = result->unknowns - count - result->rank,
                                       .free_directions = result->free_directions};
    cagd_stationary_verdict verdict = cagd_stationary_check(&problem);
    free(held);
    free(points);
    free(extended);
    return verdict;
}
