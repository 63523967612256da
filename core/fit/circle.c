/* circle.c -- the circle as a conic of which the points say no more: an F test, and intervals of centre and radius of short arcs. */
#include "core/fit/ellipse.h"
#include "core/fit/quantile.h"
#include "core/require.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

static const double PI = 3.14159265358979323846;

enum { K, H, THETA, LOCAL };

/* The circle about M, its point in the middle of the points, where h = 0: k the curvature, n from M to the centre, t the tangent; the
 * covariance of k, h and theta, and centre and radius with theirs. */
typedef struct arc {
    double centre[2], radius, k, n[2], t[2];
    double joint[3][3];         /* of the centre's coordinates and the radius */
    double local[LOCAL][LOCAL]; /* of k, h, theta                             */
} arc;

/* The joint covariance from that of c, a, b:  dR = a.da/R. */
static void fill_joint(const fit_ellipse *e, double scale_squared, arc *s)
{
    double g[3][6] = {{1}, {0, 1}};
    for (int c = 0; c < 2; c++)
        g[2][2 + c] = e->x[2 + c] / s->radius;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            s->joint[i][j] = 0;
            for (int k = 0; k < 6; k++)
                for (int l = 0; l < 6; l++)
                    s->joint[i][j] += scale_squared * g[i][k] * e->inverse[k * 6 + l] * g[j][l];
        }
}

/* dk = -dR/R^2,  dh = n.dc - dR,  dtheta = t.dc/R. */
static void fill_local(arc *s)
{
    const double R = s->radius,
                 g[LOCAL][3] = {{0, 0, -1 / (R * R)}, {s->n[0], s->n[1], -1}, {s->t[0] / R, s->t[1] / R, 0}};
    for (int i = 0; i < LOCAL; i++)
        for (int j = 0; j < LOCAL; j++) {
            s->local[i][j] = 0;
            for (int k = 0; k < 3; k++)
                for (int l = 0; l < 3; l++)
                    s->local[i][j] += g[i][k] * s->joint[k][l] * g[j][l];
        }
}

/* Without its bias, seen from the mean of the points. */
static arc arc_of(const cagd_fit_data *data, const fit_ellipse *e, double scale_squared)
{
    arc s = {.radius = hypot(e->x[2], e->x[3])};
    double mean[2] = {0};
    for (int i = 0; i < data->count; i++)
        for (int c = 0; c < 2; c++)
            mean[c] += (data->points[2 * i + c] - e->x[c]) / data->count;
    fill_joint(e, scale_squared, &s);
    s.radius -= scale_squared * (e->x[2] * e->bias[2] + e->x[3] * e->bias[3]) / s.radius;
    const double length = hypot(mean[0], mean[1]);
    for (int c = 0; c < 2; c++) {
        s.centre[c] = e->x[c] - scale_squared * e->bias[c];
        s.n[c] = length > 0 ? -mean[c] / length : c == 0;
    }
    s.t[0] = -s.n[1], s.t[1] = s.n[0];
    s.k = 1 / s.radius;
    fill_local(&s);
    return s;
}

/* Where (X k - n)^2 <= q^2 g^T V g, the gradient g = (X, -k n, -t) of X k - (1 + k h) n by k, h and theta, X = x - M; as A X^2 - 2 B X + C <= 0, an
 * interval where A > 0. */
static void centre_interval(const arc *s, int c, double quantile, cagd_fit_number *x)
{
    const double n = s->n[c], u = -s->k * n, v = -s->t[c], q2 = quantile * quantile;
    const double across = u * s->local[K][H] + v * s->local[K][THETA];
    const double rest = u * u * s->local[H][H] + 2 * u * v * s->local[H][THETA] + v * v * s->local[THETA][THETA];
    const double A = s->k * s->k - q2 * s->local[K][K], B = s->k * n + q2 * across, C = n * n - q2 * rest,
                 under = B * B - A * C, M = s->centre[c] - s->radius * n;
    if (A > 0 && under >= 0) {
        x->low = M + (B - sqrt(under)) / A;
        x->high = M + (B + sqrt(under)) / A;
    }
}

static void fill_intervals(const arc *s, double quantile, cagd_fit_circle *circle)
{
    const double wide = quantile * sqrt(s->local[K][K]); /* < k */
    circle->radius.low = 1 / (s->k + wide);
    circle->radius.high = 1 / (s->k - wide);
    for (int c = 0; c < 2; c++)
        centre_interval(s, c, quantile, &circle->centre[c]);
}

/* In degrees, of the points as they are seen from the centre. */
static double sweep_of(const cagd_fit_data *data, const arc *s)
{
    double low = 0, high = 0;
    for (int i = 0; i < data->count; i++) {
        const double x = data->points[2 * i] - s->centre[0], y = data->points[2 * i + 1] - s->centre[1],
                     angle = atan2(-(s->t[0] * x + s->t[1] * y), -(s->n[0] * x + s->n[1] * y));
        low = fmin(low, angle), high = fmax(high, angle);
    }
    return (high - low) * 180 / PI;
}

/* Whether the result is what a circle is compared with: a conic in one segment by squares, of which nothing is held. */
static int is_free_conic(const cagd_fit_data *data, const cagd_fit_options *options, const cagd_fit_result *r)
{
    const int all = CAGD_FIT_WEIGHTS | CAGD_FIT_INNER_POINTS | CAGD_FIT_END_POINTS;
    int bound = 0;
    for (int a = 0; a < r->unknowns; a++)
        bound |= r->at_bound[a];
    return data->dim == 2 && r->curve.degree == 2 && r->curve.count == 3 && r->count == data->count && !bound &&
           r->unknowns == 7 && options->free == all && options->loss == CAGD_FIT_SQUARES && !(options->smooth > 0) &&
           !options->monotone && cagd_fit_is_minimum(r) && data->count > 5;
}

/* The roundings of the coordinates, beneath which distances say nothing. */
static double rounding_of(const cagd_fit_data *data)
{
    double largest = 0;
    for (int i = 0; i < data->count * data->dim; i++)
        largest = fmax(largest, fabs(data->points[i]));
    return 8 * DBL_EPSILON * largest;
}

/* The circle, where the test against the conic does not reject it. */
static void judge(const cagd_fit_data *data, const cagd_fit_result *r, const fit_ellipse *round, cagd_fit_circle *to)
{
    const int d = data->count - 5, known = r->scale_is_given;
    const double ratio = fmax(0, round->chi_squared - r->chi_squared) / 2 / (r->chi_squared / d);
    const double probability = fit_f_probability(ratio, 2, d);
    const int rounded = data->sigma == NULL && round->rms <= rounding_of(data);
    if (!round->converged || round->unknowns < 3 || !(rounded || probability > FIT_NO_CIRCLE))
        return;
    const double scale_squared = known ? 1 : round->chi_squared / (data->count - 3);
    const double quantile = known ? fit_normal_quantile() : fit_student_quantile(data->count - 3);
    const arc s = arc_of(data, round, scale_squared);
    if (!(quantile * sqrt(s.local[K][K]) < s.k)) /* not told from a straight line */
        return;
    *to = (cagd_fit_circle){1, .ratio = ratio, .freedom = d, .probability = probability};
    for (int c = 0; c < 2; c++)
        to->centre[c] = (cagd_fit_number){round->x[c], sqrt(s.joint[c][c]), NAN, NAN};
    to->radius = (cagd_fit_number){hypot(round->x[2], round->x[3]), sqrt(s.joint[2][2]), NAN, NAN};
    to->sweep = sweep_of(data, &s);
    to->rms = round->rms;
    if (to->rms <= FIT_BENT * to->radius.value)
        fill_intervals(&s, quantile, to);
}

cagd_status cagd_fit_circle_of(const cagd_fit_data *data, const cagd_fit_options *options,
                               const cagd_fit_result *result, cagd_fit_circle *circle)
{
    fit_ellipse round;
    *circle = (cagd_fit_circle){0};
    REQUIRE(is_free_conic(data, options, result), CAGD_OK);
    double *phi = malloc((size_t)data->count * sizeof *phi);
    const int good = phi != NULL && fit_ellipse_of(data, 1, NULL, &round, phi);
    free(phi);
    REQUIRE(good, CAGD_NO_MEMORY);
    judge(data, result, &round, circle);
    return CAGD_OK;
}
