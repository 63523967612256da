/* test_stationary_parts.c -- what the check in intervals is made of, by numbers that hands compute: where the check itself would show a
 * fault in its last digits alone. */
#include "unit_exact.h"

#include "exact/curve/spline.h"
#include "exact/fit/stationary.c" /* for what is its own */

/* With W = (2) and V = (1/4), V W = 1/2: |y| <= |V| u + |y|/2, so |y| <= u/2 for the unit u. */
static void the_extent_of_a_box(void **state)
{
    (void)state;
    const double W[] = {2}, V[] = {0.25}, unit[] = {3}, no_inverse[] = {0};
    assert_true(extent(1, 1, W, V, unit) == 1.5);
    assert_true(isinf(extent(1, 1, W, no_inverse, unit)));
    const double W2[] = {2, 0, 1, 1}, V2[] = {0.5, 0, -0.5, 1}, units[] = {1, 1}; /* an inverse */
    double r = extent(2, 2, W2, V2, units);
    assert_true(r >= 1.5 && r < 1.5 + 0x1p-40);
}

static void what_a_radius_reaches(void **state)
{
    (void)state;
    const double W[] = {1, -2, 4, 0.5};
    double reach[2];
    reaches(2, 2, W, reach);
    assert_true(reach[0] > 3 && reach[0] < 3 + 0x1p-40);
    assert_true(reach[1] > 4.5 && reach[1] < 4.5 + 0x1p-40);
}

/* The least and the largest coordinate in any place, of each number of dimensions. */
static void the_size_of_points(void **state)
{
    (void)state;
    for (int dim = 1; dim <= 3; dim++)
        for (int least = 0; least < 5; least++)
            for (int most = 0; most < 5; most++)
                for (int c = 0; c < dim; c++) {
                    double points[15] = {0};
                    cagd_fit_data data = {5, dim, points, NULL};
                    points[least * dim + c] -= 3, points[most * dim + c] += 4;
                    assert_true(size_of_data(&data) == (least != most ? 7 : 1)); /* 0 for the same, with 1 more */
                }
}

static void ways_are_added_upward(void **state)
{
    (void)state;
    const cagd_fit_unknown unknown[] = {{1, 1, 0}, {0, 1, 0}};
    const cagd_stationary_problem problem = {.unknowns = 2, .unknown = unknown};
    const double moved[] = {0x1p-60, 0x1p-70};
    cagd_stationary_verdict v = {.weight_radius = 1, .point_radius = 1, .weight_alone = 2, .point_alone = 2};
    add_way(&problem, moved, 1, &v);
    assert_true(v.weight_radius > 1 && v.weight_radius < 1 + 0x1p-50);
    assert_true(v.point_radius > 1 && v.point_radius < 1 + 0x1p-50);
    assert_true(v.weight_alone < 2 && v.point_alone < 2 && v.weight_alone > 1.99 && v.point_alone > 1.99);
}

/* The largest of several ways, not the last; in the unit of the coordinates, and nothing below 0. */
static void the_longest_way_counts(void **state)
{
    (void)state;
    static const struct {
        double way[4], unit, less; /* of two weights, then of two coordinates */
    } list[] = {{{0.5, 0.25, 0, 0}, 4, 0.5}, {{0, 0, 1, 0.5}, 4, 0.25},      {{0.25, 0.5, 0.5, 1}, 4, 0.5},
                {{0.5, 0.25, 6, 4}, 4, 1.5}, {{0.125, 0, 0, 0.25}, 0.25, 1}, {{3, 1, 1, 1}, 8, 3},
                {{0, 0, 0, 0}, 4, 0}};
    const cagd_fit_unknown unknown[] = {{1, 1, 0}, {1, 2, 0}, {0, 1, 0}, {0, 1, 1}};
    const cagd_stationary_problem problem = {.unknowns = 4, .unknown = unknown};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        const double *way = list[k].way, tiny = 0x1p-40;
        cagd_stationary_verdict v = {.weight_radius = 1, .point_radius = 2, .weight_alone = 2, .point_alone = 5};
        add_way(&problem, way, list[k].unit, &v);
        double weight = 1 + fmax(way[0], way[1]), point = 2 + fmax(way[2], way[3]);
        assert_true(v.weight_radius >= weight && v.weight_radius < weight + tiny);
        assert_true(v.point_radius >= point && v.point_radius < point + tiny);
        weight = fmax(0, 2 - list[k].less), point = fmax(0, 5 - list[k].less * list[k].unit);
        assert_true(v.weight_alone <= weight && v.weight_alone > weight - tiny && v.weight_alone >= 0);
        assert_true(v.point_alone <= point && v.point_alone > point - tiny && v.point_alone >= 0);
        if (list[k].less == 0)
            assert_true(v.weight_radius == 1 && v.point_radius == 2 && v.weight_alone == 2 && v.point_alone == 5);
    }
    assert_true(radius_of(1, 0.5) == 2 && radius_of(3, 0) == 3 && radius_of(1, 0.75) == 4);
    double third = radius_of(1, 0.625); /* 8/3, rounded up */
    assert_true(third * 3 >= 8 && third < 8 / 3.0 + 0x1p-40);
    assert_true(product_up(2, 3) > 6 && product_up(2, 3) < 6 + 0x1p-40);
}

/* A box of three unknowns with a Hessian and a gradient that are given. */
static void fill(struct box *b, const double low[9], const double high[9], const double gradient[3])
{
    for (int m = 0; m < 9; m++)
        mpfr_set_d(b->hessian[m].lo, low[m], MPFR_RNDD), mpfr_set_d(b->hessian[m].hi, high[m], MPFR_RNDU);
    for (int a = 0; a < 3; a++)
        mpfr_set_d(b->gradient[a].lo, gradient[a], MPFR_RNDD), mpfr_set_d(b->gradient[a].hi, gradient[a], MPFR_RNDU);
}

/* 1 - S W^T H W with its largest row in any place, and half of the widths of W^T H W; W^T g and W S W^T g. */
static void contractions_and_steps(void **state)
{
    (void)state;
    static const double knot[] = {0, 0, 1, 1}, points[] = {0, 0, 1, 1};
    static const cagd_fit_unknown unknown[] = {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}};
    const cagd_spline curve = {1, 2, 2, knot, points, NULL};
    const cagd_fit_data data = {.dim = 2};
    const cagd_stationary_problem problem = {.data = &data, .curve = &curve, .unknowns = 3, .unknown = unknown};
    struct box b;
    assert_true(cagd_stationary_box_new(&b, &problem));
    /* W has the columns e_0, e_1 + e_2, which are exchanged, too; with H of diagonal 1, -1/4, -1/2 and others 1/16, 1/8, 1/32:
     * W^T H W is (1, 3/16; 3/16, -3/4 + 2/32). */
    static const double H[9] = {1, 0.0625, 0.125, 0.0625, -0.25, 0.03125, 0.125, 0.03125, -0.5}, g[3] = {1, -3, 0.5};
    for (int exchanged = 0; exchanged < 2; exchanged++) {
        double W[9] = {0}, newton[3], step[3], wide[9];
        int sign[2] = {exchanged ? -1 : 1, exchanged ? 1 : -1};
        W[exchanged] = 1, W[3 + !exchanged] = W[6 + !exchanged] = 1;
        fill(&b, H, H, g);
        assert_true(fabs(contraction(&b, 2, W, sign) - (0.1875 + 0.3125)) < 0x1p-40);
        assert_true(fabs(contraction(&b, 2, W, NULL)) < 0x1p-40);
        int positive[2] = {1, 1}; /* 1 + 3/4 - 1/16 */
        assert_true(fabs(contraction(&b, 2, W, positive) - (0.1875 + 1.6875)) < 0x1p-40);
        for (int m = 0; m < 9; m++)
            wide[m] = H[m] + (m == 0 ? 0.25 : m == 1 || m == 3 ? 0.5 : 0);
        fill(&b, H, wide, g);
        assert_true(fabs(contraction(&b, 2, W, NULL) - (0.125 + 0.25)) < 0x1p-40);
        for (int m = 0; m < 9; m++)
            wide[m] = H[m] + (m == 8 ? 2 : 0);
        fill(&b, H, wide, g);
        assert_true(fabs(contraction(&b, 2, W, NULL) - 1) < 0x1p-40);
        fill(&b, H, H, g);
        assert_true(fabs(gradient_size(&b, 2, W, sign, newton, step) - 2.5) < 0x1p-40); /* of 1 and -5/2 */
        static const double way[3] = {-1, -2.5, -2.5};                                  /* -(1, 5/2, 5/2) */
        for (int a = 0; a < 3; a++)
            assert_true(fabs(newton[a] - way[a]) < 0x1p-40 && step[a] >= fabs(way[a]) &&
                        step[a] < fabs(way[a]) + 0x1p-40);
    }
    static const double large[3] = {-7, 1, 1};
    double W[9] = {1, 0, 0, 0, 1, 0, 0, 1, 0}, newton[3], step[3];
    W[3 * 0 + 0] = 1, W[3 * 1 + 1] = 1;
    fill(&b, H, H, large);
    assert_true(gradient_size(&b, 1, W, (int[]){1}, newton, step) >= 7);
    cagd_stationary_box_free(&b);
}

static num_q absolute(num_q x) { return cagd_sign_q(x) < 0 ? neg_q(x) : x; }

/* Steps of every size, one after the other.  A coordinate is the sum of two binary64, which a step moves by itself but for 2^-50 of it
 * and 2^-100 of the coordinate; what is said to be moved is at least the way from where it was at first, by rationals, and more by a
 * few times the smaller of the two numbers.  A weight v that began as w is moved by at least |log(v/w)|, which for numbers above 0 is
 * less than |v - w|/min(v, w).  What is held stays. */
static void the_centre_moves_no_farther_than_is_told(void **state)
{
    (void)state;
    enum { POINTS = 3, UNKNOWNS = 2 * POINTS + 1, HELD = 4, MOVES = 4 };
    for (int n = 0; n < 400; n++) {
        double points[2 * POINTS], weights[POINTS] = {1, 0.375 + random_int(0, 99), 1};
        cagd_fit_unknown unknown[UNKNOWNS];
        int held[UNKNOWNS] = {0};
        held[HELD] = CAGD_STATIONARY_HELD;
        for (int a = 0; a < 2 * POINTS; a++) {
            unknown[a] = (cagd_fit_unknown){0, a / 2, a % 2};
            points[a] = ldexp(random_int(-(1 << 30), 1 << 30), random_int(-60, 10));
        }
        unknown[2 * POINTS] = (cagd_fit_unknown){1, 1, 0};
        const cagd_spline curve = {2, POINTS, 2, NULL, points, n % 2 ? weights : NULL};
        const cagd_fit_data data = {.dim = 2};
        const cagd_stationary_problem problem = {
            .data = &data, .curve = &curve, .unknowns = UNKNOWNS, .unknown = unknown, .held = held};
        struct workspace s = {0};
        assert_true(workspace_new(&s, &problem));
        for (int move = 0; move < MOVES; move++) {
            num_q before[2 * POINTS];
            double weight = s.weights[1];
            for (int a = 0; a < UNKNOWNS; a++) {
                s.newton[a] = ldexp(random_int(-(1 << 30), 1 << 30), random_int(-110, a < 2 * POINTS ? 10 : -40));
                if (a < 2 * POINTS)
                    before[a] = add_q(from_double_q(s.points[a]), from_double_q(s.rest[a]));
            }
            move_centre(&problem, &s);
            for (int a = 0; a < 2 * POINTS; a++) {
                num_q now = add_q(from_double_q(s.points[a]), from_double_q(s.rest[a]));
                num_q step = sub_q(now, before[a]), way = sub_q(now, from_double_q(points[a]));
                if (a == HELD) {
                    assert_true(cagd_is_zero_q(way) && s.moved[a] == 0);
                    continue;
                }
                num_q off = sub_q(step, from_double_q(s.newton[a])), told = from_double_q(s.moved[a]);
                num_q room =
                    add_q(mul_q(absolute(step), from_double_q(0x1p-50)), mul_q(absolute(now), from_double_q(0x1p-100)));
                assert_true(cagd_compare_q(absolute(off), room) <= 0);
                assert_true(cagd_compare_q(told, absolute(way)) >= 0);
                num_q most =
                    add_q(mul_q(absolute(way), from_double_q(1 + 0x1p-40)), from_double_q(3 * fabs(s.rest[a])));
                assert_true(cagd_compare_q(told, most) <= 0);
            }
            double first = n % 2 ? weights[1] : 1, v = s.weights[1];
            assert_true(fabs(log(v / weight) - s.newton[2 * POINTS]) <= 0x1p-50);
            assert_true(cagd_compare_q(mul_q(from_double_q(s.moved[2 * POINTS]), from_double_q(fmin(v, first))),
                                       absolute(sub_q(from_double_q(v), from_double_q(first)))) >= 0);
        }
        free(s.memory);
        free(s.sign);
    }
}

/* What is added to the points of the curve belongs to the centre: derivatives are those of the curve that was moved there. */
static void the_rest_belongs_to_the_centre(void **state)
{
    (void)state;
    enum { UNKNOWNS = 3 };
    static const double knot[] = {0, 0, 0, 1, 1, 1}, points[] = {0, 0, 4, 7, 8, 0},
                        rest[] = {0.25, 0, -0.5, 0.125, 0, 1}, measured[] = {1.75, 3, 3.75, 4.25, 6, 3.5},
                        feet[] = {0.25, 0.5, 0.75}, none[UNKNOWNS] = {0};
    double moved[6];
    for (int m = 0; m < 6; m++)
        moved[m] = points[m] + rest[m];
    const cagd_fit_unknown unknown[UNKNOWNS] = {{1, 1, 0}, {0, 1, 0}, {0, 2, 1}};
    const cagd_fit_data data = {3, 2, measured, NULL};
    const cagd_spline curve[2] = {{2, 3, 2, knot, points, NULL}, {2, 3, 2, knot, moved, NULL}};
    struct box b[2];
    for (int k = 0; k < 2; k++) {
        const cagd_stationary_problem problem = {
            .data = &data, .loss_scale = 1, .curve = &curve[k], .feet = feet, .unknowns = UNKNOWNS, .unknown = unknown};
        assert_true(cagd_stationary_box_new(&b[k], &problem));
        b[k].rest = k == 0 ? rest : NULL;
        assert_true(cagd_stationary_enclose(&b[k], none, 1));
    }
    for (int a = 0; a < UNKNOWNS; a++) {
        assert_true(mpfr_equal_p(b[0].gradient[a].lo, b[1].gradient[a].lo) &&
                    mpfr_equal_p(b[0].gradient[a].hi, b[1].gradient[a].hi));
        assert_true(fabs(mpfr_get_d(b[0].gradient[a].lo, MPFR_RNDN)) > 0x1p-10);
    }
    for (int k = 0; k < 2; k++)
        cagd_stationary_box_free(&b[k]);
}

static void the_nearer_bound(void **state)
{
    (void)state;
    const cagd_fit_options options = {.weight_low = 0.5, .weight_high = 8, .tolerance = 0.01};
    assert_int_equal(bound_of(&options, log(0.5)), CAGD_STATIONARY_AT_LOW);
    assert_int_equal(bound_of(&options, log(1.9)), CAGD_STATIONARY_AT_LOW);
    assert_int_equal(bound_of(&options, log(2.1)), CAGD_STATIONARY_AT_HIGH);
    assert_int_equal(bound_of(&options, log(8)), CAGD_STATIONARY_AT_HIGH);
}

/* ---- The smoothing term, of which the check has a formula in Bernstein polynomials, by quadrature ----- */

enum { MOST_POINTS = 8, MOST_NODES = 9 };

/* weight[j] of the nodes (j+1)/(count+1) of [0,1], which integrate polynomials of a degree < count: each is the integral of the
 * polynomial that is 1 at its node and 0 at the others. */
static void quadrature(int count, num_q node[], num_q weight[])
{
    for (int j = 0; j < count; j++)
        node[j] = from_ratio_q(j + 1, count + 1);
    for (int j = 0; j < count; j++) {
        num_q a[MOST_NODES + 1] = {from_int_q(1)};
        for (int m = 0, degree = 0; m < count; m++) {
            if (m == j)
                continue;
            num_q scale = div_q(from_int_q(1), sub_q(node[j], node[m]));
            a[++degree] = from_int_q(0);
            for (int k = degree; k >= 0; k--)
                a[k] = mul_q(scale, sub_q(k > 0 ? a[k - 1] : from_int_q(0), mul_q(node[m], a[k])));
        }
        weight[j] = from_int_q(0);
        for (int k = 0; k < count; k++)
            weight[j] = add_q(weight[j], div_q(a[k], from_int_q(k + 1)));
    }
}

/* A curve of the test: of a closed one point i is number i - shift, modulo the period, of the unknown ones, and the first and last
 * `shift` spans are of the domain once more. */
struct smoothed {
    int degree, count, period, shift;
    double knot[2 * MOST_POINTS];
};

/* G[i n + k] = integral N_i'' N_k'' over the domain; N_i is coordinate i of a curve with the points of a unit matrix, some columns
 * of it at a time. */
static void integrals(const struct smoothed *s, num_q G[])
{
    enum { PART = CAGD_MAX_DIM };
    const int p = s->degree, n = s->count;
    num_q u[2 * MOST_POINTS], P[MOST_POINTS * PART], node[MOST_NODES], weight[MOST_NODES];
    quadrature(2 * p - 1, node, weight);
    for (int k = 0; k < n * n; k++)
        G[k] = from_int_q(0);
    for (int k = 0; k <= n + p; k++)
        u[k] = from_double_q(s->knot[k]);
    for (int mu = p + s->shift; mu < n - s->shift; mu++)
        for (int j = 0; j < 2 * p - 1 && s->knot[mu] < s->knot[mu + 1]; j++) {
            num_q length = sub_q(u[mu + 1], u[mu]), t = add_q(u[mu], mul_q(length, node[j])),
                  second[MOST_POINTS + PART];
            for (int first = 0; first < n; first += PART) {
                num_q d[3 * PART];
                for (int k = 0; k < n * PART; k++)
                    P[k] = from_int_q(k / PART == first + k % PART);
                const cagd_spline_q columns = {p, n, PART, u, P, NULL};
                assert_int_equal(cagd_spline_derivatives_q(&columns, t, CAGD_RIGHT, 2, d), CAGD_OK);
                for (int c = 0; c < PART; c++)
                    second[first + c] = d[2 * PART + c];
            }
            for (int i = 0; i < n; i++)
                for (int k = 0; k < n; k++)
                    G[i * n + k] = add_q(G[i * n + k], mul_q(mul_q(weight[j], length), mul_q(second[i], second[k])));
        }
}

static int is_tight(double low, num_q x, double high)
{
    return cagd_compare_q(from_double_q(low), x) <= 0 && cagd_compare_q(x, from_double_q(high)) <= 0 &&
           high - low <= 0x1p-30 * (1 + fabs(high));
}

static int own(const struct smoothed *s, int i) { return s->period > 0 ? (i - s->shift + s->period) % s->period : i; }

/* The sum of G over the places of two unknowns; with the points of the second one, where they are given. */
static num_q sum_of(const struct smoothed *s, const num_q G[], cagd_fit_unknown a, int b, int dim,
                    const double points[])
{
    num_q sum = from_int_q(0);
    for (int i = 0; i < s->count; i++)
        for (int k = 0; own(s, i) == a.index && k < s->count; k++)
            if (points != NULL)
                sum = add_q(sum, mul_q(G[i * s->count + k], from_double_q(points[dim * k + a.coordinate])));
            else if (own(s, k) == b)
                sum = add_q(sum, G[i * s->count + k]);
    return sum;
}

/* Gradient lambda L^3 G P and Hessian lambda L^3 G, for all coordinates and for some of them unknown; half of it for each of two
 * shares. */
static void the_smoothing_term(void **state)
{
    (void)state;
    static const struct smoothed of[] = {
        {2, 4, 0, 0, {0, 0, 0, 0.375, 1, 1, 1}},
        {3, 4, 0, 0, {0, 0, 0, 0, 2, 2, 2, 2}},
        {3, 6, 0, 0, {0, 0, 0, 0, 0.5, 0.75, 3, 3, 3, 3}},
        {3, 7, 0, 0, {-1, 0, 0.25, 1, 2, 2, 2.5, 4, 5, 5.5, 7}},
        {4, 7, 0, 0, {0, 0, 0, 0, 0, 0.25, 0.25, 1, 1, 1, 1, 1}},
        {5, 8, 0, 0, {0, 0, 0, 0, 0, 0, 0.125, 0.5, 1, 1, 1, 1, 1, 1}},
        {2,
         7,
         3,
         1,
         {-3, -2, -1, 0, 0.5, 2, 3, 3.5, 5, 6}}, /* the spans between 0 and 3, and one more on either side */
    };
    enum { N = 3 * MOST_POINTS };
    const double lambda = 0.625, none[N] = {0};
    for (size_t c = 0; c < sizeof of / sizeof *of; c++)
        for (int skip = 0; skip <= 1; skip++) {
            const struct smoothed *s = &of[c];
            const int n = s->count, free_points = s->period > 0 ? s->period : n, dim = 2 + (int)(c + (size_t)skip) % 2;
            double points[N], low[N], high[N], H_low[N * N], H_high[N * N];
            cagd_fit_unknown unknown[N];
            num_q G[MOST_POINTS * MOST_POINTS];
            int unknowns = 0, where = 7;
            for (int k = 0; k < dim * n; k++)
                points[k] = random_int(-64, 64) / 16.0;
            for (int i = 0; i < dim * n; i++)
                points[i] = points[dim * (own(s, i / dim) + s->shift) + i % dim];
            for (int k = 0; k < dim * free_points; k++)
                if (!skip || k % 4 > 0)
                    unknown[unknowns++] = (cagd_fit_unknown){0, k / dim, k % dim};
            const cagd_fit_data data = {.dim = dim, .points = points};
            const cagd_spline curve = {s->degree, n, dim, s->knot, points, NULL};
            const cagd_stationary_problem problem = {.data = &data,
                                                     .loss_scale = 1,
                                                     .smooth = lambda,
                                                     .curve = &curve,
                                                     .period = s->period,
                                                     .shift = s->shift,
                                                     .unknowns = unknowns,
                                                     .unknown = unknown};
            assert_true(cagd_stationary_enclosures(&problem, none, low, high, H_low, H_high, &where));
            assert_int_equal(where, -1);
            struct box half;
            assert_true(cagd_stationary_box_new(&half, &problem) && cagd_stationary_enclose(&half, none, 2));
            integrals(s, G);
            num_q L = from_double_q(s->knot[n - s->shift] - s->knot[s->degree + s->shift]),
                  factor = mul_q(from_double_q(lambda), mul_q(L, mul_q(L, L)));
            for (int a = 0; a < unknowns; a++) {
                num_q slope = mul_q(factor, sum_of(s, G, unknown[a], 0, dim, points));
                assert_true(is_tight(low[a], slope, high[a]));
                assert_true(is_tight(2 * mpfr_get_d(half.gradient[a].lo, MPFR_RNDD), slope,
                                     2 * mpfr_get_d(half.gradient[a].hi, MPFR_RNDU)));
                for (int b = 0; b < unknowns; b++) {
                    num_q entry = unknown[a].coordinate != unknown[b].coordinate
                                      ? from_int_q(0)
                                      : mul_q(factor, sum_of(s, G, unknown[a], unknown[b].index, dim, NULL));
                    assert_true(is_tight(H_low[a * unknowns + b], entry, H_high[a * unknowns + b]));
                }
            }
            cagd_stationary_box_free(&half);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {unit(the_smoothing_term),
                                       unit(the_extent_of_a_box),
                                       unit(what_a_radius_reaches),
                                       unit(the_size_of_points),
                                       unit(ways_are_added_upward),
                                       unit(the_longest_way_counts),
                                       unit(contractions_and_steps),
                                       unit(the_nearer_bound),
                                       unit(the_rest_belongs_to_the_centre),
                                       unit(the_centre_moves_no_farther_than_is_told)};
    return run_unit_tests(tests);
}
