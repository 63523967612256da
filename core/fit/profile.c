#include "core/fit/profile.h"

#include "core/fit/feet.h"
#include "core/fit/invariant.h"
#include "core/fit/sample.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MEANS_PER_UNKNOWN = 10, MOST_UNKNOWNS = 32, LOOKS = 16, STEPS = 60 };
static const double LEAST = 0.85, MOST = 1.23; /* of r: see the header             */
static const double SCATTER = 0.12;            /* of r from draw to draw           */
static const double LEVEL = 0.005;             /* to which the level is reached    */

typedef struct profile {
    const fit_problem *problem;
    const cagd_fit_result *result;
    fit_objective *objective;
    fit_curve *curve;
    const fit_curve *lowest; /* the curve of the minimum, and its feet, cost  */
    const double *feet;
    fit_curve *side[2];                            /* at the ends of a linear interval           */
    int steady;                                    /* whether the scatter of r is bounded, too   */
    double cost, unit;                             /* unit: of the cost, q^2 scale_squared/2 */
    double *theta, *trial, *g, *u, *w, *c, *H, *L; /* log w_j and P_j in working coordinates */
    double *at;                                    /* feet                              */
} profile;

static void profile_free(profile *s)
{
    fit_objective_free(s->objective);
    fit_curve_free(s->curve);
    fit_curve_free(s->side[0]);
    fit_curve_free(s->side[1]);
    free(s->theta);
    free(s->at);
}

/* Returns 0 when there is no memory; profile_free is to be called all the same. */
static int profile_new(const fit_problem *p, const fit_curve *lowest, const double feet[], const cagd_fit_result *r,
                       profile *s)
{
    size_t n = (size_t)p->unknowns, points = (size_t)p->points;
    *s = (profile){.problem = p, .result = r, .lowest = lowest, .feet = feet};
    s->unit = r->quantile * r->quantile * r->scale_squared / 2;
    s->objective = fit_objective_new(p);
    s->curve = fit_curve_new(p->degree, p->count, p->period, p->dim, p->knots);
    for (int end = 0; end < 2; end++)
        s->side[end] = fit_curve_new(p->degree, p->count, p->period, p->dim, p->knots);
    s->theta = malloc((2 * n * n + 6 * n) * sizeof *s->theta);
    s->at = malloc(points * sizeof *s->at);
    if (!s->objective || !s->curve || !s->side[0] || !s->side[1] || !s->theta || !s->at)
        return 0;
    s->trial = s->theta + n, s->g = s->trial + n, s->u = s->g + n, s->w = s->u + n, s->c = s->w + n;
    s->H = s->c + n, s->L = s->H + n * n;
    return 1;
}

static double product(int n, const double a[], const double b[])
{
    double sum = 0;
    for (int k = 0; k < n; k++)
        sum += a[k] * b[k];
    return sum;
}

/* Theta of the minimum. */
static void begin(const fit_problem *p, const fit_curve *lowest, double theta[])
{
    for (int k = 0; k < p->unknowns; k++) {
        cagd_fit_unknown u = p->unknown[k];
        theta[k] = u.is_weight ? log(lowest->weights[u.index]) : lowest->points[u.index * p->dim + u.coordinate];
    }
}

static void set_curve(const fit_problem *p, const fit_curve *lowest, const double theta[], fit_curve *curve)
{
    fit_curve_copy(curve, lowest);
    for (int k = 0; k < p->unknowns; k++) {
        cagd_fit_unknown u = p->unknown[k];
        if (u.is_weight)
            curve->weights[u.index] = exp(theta[k]);
        else
            curve->points[u.index * p->dim + u.coordinate] = theta[k];
    }
    fit_curve_update(curve);
}

/* The quantity phi number q: an unknown, or, behind these, the logarithm of an invariant; c: its derivatives. */
static void quantity(const profile *s, int q, double c[])
{
    const fit_problem *p = s->problem;
    int j = q - p->unknowns + 1;
    for (int k = 0; k < p->unknowns; k++)
        c[k] = q < p->unknowns ? k == q : fit_log_invariant_derivative(&p->unknown[k], &j);
}

/* d: from the minimum to an end of the linear interval of c . theta, q C c/sqrt(c.C c); its reach c . d. */
static double linear_reach(const profile *s, const double c[], double d[])
{
    const cagd_fit_result *r = s->result;
    const int n = r->unknowns;
    double variance = 0;
    for (int k = 0; k < n; k++) {
        double unit = s->problem->unknown[k].is_weight ? 1 : s->problem->unit;
        d[k] = 0;
        for (int i = 0; i < n; i++)
            d[k] +=
                r->covariance[k * n + i] * c[i] / (unit * (s->problem->unknown[i].is_weight ? 1 : s->problem->unit));
        variance += c[k] * d[k];
    }
    for (int k = 0; k < n; k++)
        d[k] *= r->quantile / sqrt(variance);
    return r->quantile * sqrt(variance);
}

/* ---- Whether the cost is quadratic ------------------------------------------------------------------- */

/* The foot of point i of the sample, sought from t: D. */
static void foot_of(const fit_problem *sample, const fit_curve *curve, int i, double t, double D[])
{
    if (!fit_held_foot(sample, curve, i, &t, D))
        fit_foot(curve, fit_point(sample, i), &t, D);
}

/* The cost of the sample on the curve; feet are sought from those given. */
static double cost_of(const fit_problem *sample, const fit_curve *curve, const double feet[])
{
    double cost = 0, D[9], slope;
    for (int i = 0; i < sample->points; i++) {
        const double precision = sample->precision[i];
        foot_of(sample, curve, i, feet[i], D);
        cost +=
            fit_problem_loss(sample, precision * precision * fit_distance_squared(sample->dim, D, fit_point(sample, i)),
                             &slope) /
            2;
    }
    return cost;
}

/* The sum of the squares of e_i(theta+d) + e_i(theta-d) - 2 e_i(theta) across the curve, e_i the scaled distances. */
static double bend_of(const fit_problem *sample, const fit_curve *middle, const fit_curve *const side[2],
                      const double feet[])
{
    double sum = 0;
    for (int i = 0; i < sample->points; i++) {
        double D[9], other[9], bend[3] = {0}, along = 0, speed = 0;
        foot_of(sample, middle, i, feet[i], D);
        for (int k = 0; k < 2; k++) {
            foot_of(sample, side[k], i, feet[i], other);
            for (int c = 0; c < sample->dim; c++)
                bend[c] += sample->precision[i] * (D[c] - other[c]);
        }
        for (int c = 0; c < sample->dim; c++) {
            along += bend[c] * D[sample->dim + c];
            speed += D[sample->dim + c] * D[sample->dim + c];
        }
        for (int c = 0; c < sample->dim; c++)
            sum += bend[c] * bend[c];
        sum -= along * along / speed;
    }
    return sum;
}

/* Whether r lies between the bounds at both ends of the linear interval of the quantity; `rows` is evaluated at the
 * minimum, by theta. */
static int is_quadratic(const profile *s, const fit_objective *rows, int q)
{
    const fit_problem *sample = rows->problem;
    const int n = sample->unknowns;
    double *d = s->u, square = 0, slope = 0;
    quantity(s, q, s->c);
    linear_reach(s, s->c, d);
    for (int i = 0; i < n; i++) {
        double along = product(n, rows->triangle + i * (n + 1), d);
        square += along * along;
        slope += along * rows->triangle[i * (n + 1) + n];
    }
    for (int end = 0; end < 2; end++) {
        const int sign = 2 * end - 1;
        for (int k = 0; k < n; k++)
            s->trial[k] = s->theta[k] + sign * d[k];
        set_curve(sample, s->lowest, s->trial, s->side[end]);
        double grown = cost_of(sample, s->side[end], rows->feet) - rows->cost - sign * slope, r = 2 * grown / square;
        if (!(r >= LEAST && r <= MOST))
            return 0;
    }
    const fit_curve *const side[2] = {s->side[0], s->side[1]};
    const double scatter = sqrt(bend_of(sample, s->lowest, side, rows->feet) * s->result->scale_squared) / square;
    return !s->steady || scatter <= SCATTER;
}

/* linear[q]: whether the interval of quantity q is linear; s is at the minimum. */
static void find_linear(profile *s, int quantities, int linear[])
{
    fit_objective_by_theta(s->objective);
    for (int q = 0; q < quantities; q++)
        linear[q] = is_quadratic(s, s->objective, q);
}

/* ---- The profile ------------------------------------------------------------------------------------- */

/* Cholesky's factor L of H with its diagonal multiplied by 1 + more; 0 if there is none. */
static int factor(int n, const double H[], double more, double L[])
{
    for (int j = 0; j < n; j++)
        for (int i = 0; i <= j; i++) {
            double x = H[j * n + i] * (i == j ? 1 + more : 1) - product(i, L + j * n, L + i * n);
            if (i == j && !(x > 0 && isfinite(x)))
                return 0;
            L[j * n + i] = i == j ? sqrt(x) : x / L[i * n + i];
        }
    return 1;
}

static void solve(int n, const double L[], const double b[], double x[])
{
    for (int j = 0; j < n; j++)
        x[j] = (b[j] - product(j, L + j * n, x)) / L[j * n + j];
    for (int j = n - 1; j >= 0; j--) {
        for (int i = j + 1; i < n; i++)
            x[j] -= L[i * n + j] * x[i];
        x[j] /= L[j * n + j];
    }
}

/* The cost at theta, from the feet s->at, which become those there. */
static double evaluate(profile *s, const double theta[])
{
    fit_objective *f = s->objective;
    set_curve(s->problem, s->lowest, theta, s->curve);
    fit_objective_begin(f, s->curve, s->at);
    return f->cost;
}

/* H = J^T J and g = J^T r by theta, where the objective was evaluated; its feet are kept. */
static void normal_equations(profile *s)
{
    fit_objective *f = s->objective;
    const int n = s->problem->unknowns;
    fit_objective_by_theta(f);
    for (int j = 0; j < n; j++) {
        s->g[j] = fit_objective_gradient(f, j);
        for (int i = 0; i <= j; i++) {
            double sum = 0;
            for (int k = 0; k < n; k++)
                sum += f->triangle[k * (n + 1) + i] * f->triangle[k * (n + 1) + j];
            s->H[j * n + i] = s->H[i * n + j] = sum;
        }
    }
    memcpy(s->at, f->feet, (size_t)s->problem->points * sizeof *s->at);
}

/* F(v), from theta and the feet there, which become those of F(v), by Levenberg and Marquardt's steps on the plane c . theta = v; infinite where they do not
 * come to an end. */
static double cost_at(profile *s, double v)
{
    const int n = s->problem->unknowns;
    double more = 0;
    double cost = evaluate(s, s->theta);
    if (!isfinite(cost))
        return HUGE_VAL;
    normal_equations(s);
    for (int step = 0; step < STEPS; step++) {
        if (!factor(n, s->H, more, s->L))
            return HUGE_VAL;
        solve(n, s->L, s->g, s->u);
        solve(n, s->L, s->c, s->w);
        double along = (v - product(n, s->c, s->theta) + product(n, s->c, s->u)) / product(n, s->c, s->w), expected = 0;
        for (int k = 0; k < n; k++) {
            double move = along * s->w[k] - s->u[k];
            s->trial[k] = s->theta[k] + move;
            expected -= s->g[k] * move;
        }
        double next = evaluate(s, s->trial);
        if (step == 0 || next < cost) { /* the first step goes to the plane */
            double gain = cost - next;
            if (!isfinite(next))
                return HUGE_VAL;
            memcpy(s->theta, s->trial, (size_t)n * sizeof *s->theta);
            cost = next;
            more = more > 1e-6 ? more / 8 : 0;
            if (step > 0 && gain < LEVEL / 8 * s->unit)
                return cost;
            normal_equations(s);
        } else {
            if (fabs(expected) < LEVEL / 8 * s->unit)
                return cost;
            more = more > 0 ? 8 * more : 1e-3;
        }
    }
    return HUGE_VAL;
}

/* Back to the minimum. */
static void go_back(profile *s)
{
    begin(s->problem, s->lowest, s->theta);
    memcpy(s->at, s->feet, (size_t)s->problem->points * sizeof *s->at);
}

/* Where the profile of s->c comes to its level, on this side of phi; NaN where it does not. */
static double end_of(profile *s, double phi, double reach)
{
    double v = phi + reach, low = phi, root_low = 0, high = NAN, root_high = 1;
    go_back(s);
    for (int look = 0; look < LOOKS; look++) {
        double cost = cost_at(s, v), root = sqrt(fmax(0, cost - s->cost) / s->unit); /* 1 at the end */
        if (isinf(cost))
            go_back(s);
        if (fabs(root - 1) < LEVEL)
            return v;
        if (root < 1)
            low = v, root_low = root;
        else
            high = v, root_high = root;
        if (isnan(high)) /* farther, by at most three times */
            v = phi + (v - phi) * fmin(3, 1 / fmax(root, 0.1));
        else if (isinf(root_high) || look % 4 == 3)
            v = low + (high - low) / 2;
        else
            v = low + (high - low) * (1 - root_low) / (root_high - root_low);
        if (!isfinite(v))
            break;
    }
    return NAN;
}

/* The interval of quantity q, in the units of the result. */
static void find_interval(profile *s, int q)
{
    const fit_problem *p = s->problem;
    const cagd_fit_result *r = s->result;
    double *interval = r->interval + 2 * q, unit = q < p->unknowns && !p->unknown[q].is_weight ? p->unit : 1;
    quantity(s, q, s->c);
    begin(p, s->lowest, s->theta);
    double reach = linear_reach(s, s->c, s->u), phi = product(p->unknowns, s->c, s->theta);
    interval[0] = unit * end_of(s, phi, -reach);
    interval[1] = unit * end_of(s, phi, reach);
    int found = isfinite(interval[0]) && isfinite(interval[1]);
    r->interval_by[q] = found ? CAGD_FIT_INTERVAL_PROFILE : CAGD_FIT_INTERVAL_NONE;
}

/* Whether the statistics rest on a quadratic cost around a minimum with all unknowns determined. */
static int is_asked(const fit_problem *p, const cagd_fit_result *r)
{
    int free = p->unknowns > 0 && p->smooth == 0 && p->loss == CAGD_FIT_SQUARES && r->rank == p->unknowns &&
               r->termination == CAGD_FIT_CONVERGED && !r->points_on_curve;
    return free && r->scale_squared > 0 && isfinite(r->scale_squared) && isfinite(r->quantile);
}

/* Which intervals are linear, and those that are not, from the points of p; feet: of those.  Returns 0 when there is no
 * memory. */
static int find_intervals(const fit_problem *p, const fit_curve *lowest, const double feet[], int follow,
                          cagd_fit_result *r)
{
    const int quantities = p->unknowns + r->invariants;
    profile s;
    int *linear = calloc((size_t)quantities, sizeof *linear);
    const int good = profile_new(p, lowest, feet, r, &s) && linear != NULL;
    if (good) {
        go_back(&s);
        s.steady = !follow;
        s.cost = evaluate(&s, s.theta);
        find_linear(&s, quantities, linear);
    }
    for (int q = 0; good && q < quantities; q++) {
        r->interval_by[q] = linear[q] ? CAGD_FIT_INTERVAL_LINEAR : CAGD_FIT_INTERVAL_NONE;
        if (!linear[q] && follow)
            find_interval(&s, q);
    }
    profile_free(&s);
    free(linear);
    return good;
}

int fit_profile(const fit_problem *p, const fit_minimum *m, cagd_fit_result *r)
{
    const fit_curve *lowest = m->attempt.objective->curve;
    const int one = p->count == p->degree + 1,
              follow = one && p->unknowns <= MOST_UNKNOWNS && p->low == 0 && isinf(p->high),
              groups = MEANS_PER_UNKNOWN * p->unknowns;
    fit_problem means;
    const int sought = !p->options->without_intervals && !(p->smooth > 0);
    for (int q = 0; !sought && q < p->unknowns + r->invariants; q++)
        r->interval_by[q] = CAGD_FIT_INTERVAL_NOT_SOUGHT;
    if (!sought || !is_asked(p, r))
        return 1;
    if (p->points <= 2 * groups)
        return find_intervals(p, lowest, r->feet, follow, r);
    double *feet = malloc(((size_t)groups + 2) * sizeof *feet);
    int good = feet != NULL && fit_sample_means(p, lowest, r->feet, groups, &means, feet);
    if (good) {
        good = find_intervals(&means, lowest, feet, follow, r);
        fit_sample_free(&means);
    }
    free(feet);
    return good;
}
