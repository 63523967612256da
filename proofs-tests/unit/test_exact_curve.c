/* test_exact_curve.c -- the exact curve: every form of a curve has the points of the curve, on both sides of every knot; what
 * was added can be taken away again; what cannot is refused, and no fault of the region is set. */
#include "proofs-tests/unit/unit_exact.h"

#include "exact/curve/spline.h"

enum { MOST = 24, DIM = 3, ORDER = 2, TRIALS = 60 };

/* A curve over knots 0, 1, ... of random multiplicities: sixty trials have each of the degrees 0 to 4, the dimensions 1 to 3, with weights
 * and without, clamped and not. */
static cagd_spline_q random_curve(int trial)
{
    int p = trial % 5, dim = 1 + trial / 5 % 3, clamped = trial / 30 % 2, n = p + 1 + random_int(0, 6), where;
    num_q *knots = region_bytes(MOST * sizeof *knots), *points = region_bytes(DIM * MOST * sizeof *points);
    num_q *weights = region_bytes(MOST * sizeof *weights);
    cagd_spline_q s = {p, n, dim, knots, points, trial / 15 % 2 == 0 ? weights : NULL};
    for (int m = 0; m < DIM * MOST; m++)
        points[m] = random_q();
    for (int i = 0; i < MOST; i++)
        weights[i] = from_ratio_q(random_int(1, 9999), random_int(1, 9999));
    do
        for (int i = 0, u = 0; i < n + p + 1; i++) {
            int inner = p < i && i < n;
            u += clamped && !inner ? i == n : random_int(0, 9) < 6;
            knots[i] = from_ratio_q(u, 7);
        }
    while (cagd_spline_check_q(&s, &where) != CAGD_OK);
    return s;
}

static void same_value(const cagd_spline_q *s, const cagd_spline_q *r, num_q t)
{
    for (int side = CAGD_RIGHT; side <= CAGD_LEFT; side++) {
        num_q D[(ORDER + 1) * DIM], E[(ORDER + 1) * DIM];
        assert_int_equal(cagd_spline_derivatives_q(s, t, (cagd_side)side, ORDER, D), CAGD_OK);
        assert_int_equal(cagd_spline_derivatives_q(r, t, (cagd_side)side, ORDER, E), CAGD_OK);
        for (int m = 0; m < (ORDER + 1) * s->dim; m++)
            assert_true(cagd_equal_q(D[m], E[m]));
    }
}

/* The part of s over the domain of r is r: at every knot of r and at three places between. */
static void same_curve(const cagd_spline_q *s, const cagd_spline_q *r)
{
    for (int i = r->degree; i < r->count; i++)
        for (int k = i == r->degree; k < 4; k++) {
            num_q step = mul_q(from_ratio_q(k, 4), sub_q(r->knots[i + 1], r->knots[i]));
            same_value(s, r, add_q(r->knots[i], step));
        }
}

static void identical(const cagd_spline_q *s, const cagd_spline_q *r)
{
    assert_int_equal(s->degree, r->degree);
    assert_int_equal(s->count, r->count);
    assert_int_equal(s->dim, r->dim);
    assert_int_equal(s->weights == NULL, r->weights == NULL);
    for (int i = 0; i < s->count + s->degree + 1; i++)
        assert_true(cagd_equal_q(s->knots[i], r->knots[i]));
    for (int m = 0; m < s->count * s->dim; m++)
        assert_true(cagd_equal_q(s->points[m], r->points[m]));
    for (int i = 0; i < s->count && s->weights != NULL; i++)
        assert_true(cagd_equal_q(s->weights[i], r->weights[i]));
}

/* Between two knots: the knots are sevenths. */
static num_q inner_parameter(const cagd_spline_q *s)
{
    num_q from = s->knots[s->degree], to = s->knots[s->count];
    return add_q(from, mul_q(from_ratio_q(random_int(1, 996), 997), sub_q(to, from)));
}

static void inserted_knots_are_removed_again(void **state)
{
    (void)state;
    for (int trial = 0; trial < TRIALS; trial++) {
        cagd_spline_q s = random_curve(trial), finer, back;
        num_q x = inner_parameter(&s);
        int where;
        assert_int_equal(cagd_spline_insert_q(&s, x, &finer, &where), CAGD_OK);
        assert_int_equal(where, -1);
        same_curve(&s, &finer);
        assert_int_equal(cagd_spline_remove_q(&finer, x, &back, &where), CAGD_OK);
        identical(&s, &back);
        assert_int_equal(cagd_spline_remove_q(&s, x, &back, &where), CAGD_NO_KNOT);
        assert_int_equal(cagd_spline_remove_q(&s, s.knots[s.degree], &back, &where), CAGD_NO_KNOT);
        assert_int_equal(cagd_spline_insert_q(&s, s.knots[s.count], &back, &where), CAGD_OUTSIDE_DOMAIN);
        for (int i = s.degree + 1; i < s.count; i++) /* random points leave no knot without effect */
            if (cagd_compare_q(s.knots[s.degree], s.knots[i]) < 0 && cagd_compare_q(s.knots[i], s.knots[s.count]) < 0)
                assert_int_equal(cagd_spline_remove_q(&s, s.knots[i], &back, &where), CAGD_CHANGES);
    }
}

/* Of points at the origin the weights alone say that a knot counts: 1, 1/2, 1/3, ... are none of a polynomial of that degree. */
static void weights_alone_hold_a_knot(void **state)
{
    (void)state;
    for (int p = 1; p <= 4; p++)
        for (int dim = 1; dim <= DIM; dim++) {
            num_q knots[12], points[6 * DIM], weights[6];
            int where;
            for (int i = 0; i < 2 * p + 3; i++)
                knots[i] = from_int_q(i <= p ? 0 : i == p + 1 ? 1 : 2);
            for (int m = 0; m < (p + 2) * dim; m++)
                points[m] = from_int_q(0);
            for (int i = 0; i < p + 2; i++)
                weights[i] = from_ratio_q(1, i + 1);
            const cagd_spline_q s = {p, p + 2, dim, knots, points, weights};
            cagd_spline_q back;
            assert_int_equal(cagd_spline_remove_q(&s, from_int_q(1), &back, &where), CAGD_CHANGES);
        }
}

static void raised_degrees_are_lowered_again(void **state)
{
    (void)state;
    for (int trial = 0; trial < TRIALS; trial++) {
        cagd_spline_q s = random_curve(trial), higher, back;
        int where;
        assert_int_equal(cagd_spline_elevate_q(&s, &higher, &where), CAGD_OK);
        assert_int_equal(higher.degree, s.degree + 1);
        same_curve(&s, &higher);
        assert_int_equal(cagd_spline_reduce_q(&higher, &back, &where), CAGD_OK);
        assert_int_equal(back.degree, s.degree);
        same_curve(&s, &back);
        where = 7;
        assert_int_equal(cagd_spline_reduce_q(&s, &back, &where), s.degree > 0 ? CAGD_CHANGES : CAGD_DEGREE);
        if (s.degree > 0) /* the first segment is not of the lower degree, nor is any other */
            assert_true(cagd_equal_q(s.knots[where], s.knots[s.degree]) &&
                        cagd_compare_q(s.knots[where], s.knots[where + 1]) < 0);
        else
            assert_int_equal(where, -1);
    }
}

static void parts_and_segments_are_the_curve(void **state)
{
    (void)state;
    for (int trial = 0; trial < TRIALS; trial++) {
        cagd_spline_q s = random_curve(trial), left, right, segment;
        int where, segments = 0;
        num_q t = inner_parameter(&s);
        assert_int_equal(cagd_spline_split_q(&s, t, &left, &right, &where), CAGD_OK);
        assert_true(cagd_equal_q(left.knots[left.count], t) && cagd_equal_q(right.knots[right.degree], t));
        assert_true(cagd_equal_q(left.knots[left.degree], s.knots[s.degree]));
        assert_true(cagd_equal_q(right.knots[right.count], s.knots[s.count]));
        same_curve(&s, &left);
        same_curve(&s, &right);
        assert_int_equal(cagd_spline_split_q(&s, s.knots[s.degree], &left, &right, &where), CAGD_OUTSIDE_DOMAIN);
        for (int mu = s.degree; mu < s.count; mu++) {
            int empty = cagd_equal_q(s.knots[mu], s.knots[mu + 1]);
            assert_int_equal(cagd_spline_segment_q(&s, mu, &segment, &where), empty ? CAGD_OUTSIDE_DOMAIN : CAGD_OK);
            if (empty)
                continue;
            segments++;
            same_curve(&s, &segment);
            assert_int_equal(segment.count, s.degree + 1);
            for (int i = 0; i < 2 * s.degree + 2; i++)
                assert_true(cagd_equal_q(segment.knots[i], s.knots[i <= s.degree ? mu : mu + 1]));
        }
        assert_true(segments > 0);
        assert_int_equal(cagd_spline_segment_q(&s, s.degree - 1, &segment, &where), CAGD_OUTSIDE_DOMAIN);
        assert_int_equal(cagd_spline_segment_q(&s, s.count, &segment, &where), CAGD_OUTSIDE_DOMAIN);
    }
}

/* The quarter of the unit circle, x = (1-t^2)/(1+t^2), y = 2t/(1+t^2). */
static void a_circle_has_one_curvature_and_no_pole(void **state)
{
    (void)state;
    const num_q zero = from_int_q(0), one = from_int_q(1), two = from_int_q(2);
    const num_q knots[] = {zero, zero, zero, one, one, one}, points[] = {one, zero, one, one, zero, one};
    const num_q weights[] = {one, one, two}, turned[] = {one, from_int_q(-1), one};
    cagd_spline_q s = {2, 3, 2, knots, points, weights}, out;
    num_q x, D[2];
    int where;
    for (int k = 0; k <= 8; k++) {
        assert_int_equal(cagd_spline_curvature_squared_q(&s, from_ratio_q(k, 8), CAGD_RIGHT, &x), CAGD_OK);
        assert_true(cagd_equal_q(x, one));
    }
    assert_int_equal(cagd_spline_torsion_q(&s, one, CAGD_RIGHT, &x), CAGD_DIMENSION);
    assert_int_equal(cagd_spline_derivatives_q(&s, two, CAGD_RIGHT, 0, D), CAGD_OUTSIDE_DOMAIN);
    assert_int_equal(cagd_spline_derivatives_q(&s, one, CAGD_RIGHT, -1, D), CAGD_ORDER);
    assert_false(cagd_spline_has_poles_q(&s));
    int turn;
    for (int k = 0; k <= 8; k++) {
        assert_int_equal(cagd_spline_turn_q(&s, from_ratio_q(k, 8), CAGD_RIGHT, &turn), CAGD_OK);
        assert_int_equal(turn, 1);
    }
    assert_int_equal(cagd_spline_turn_q(&s, two, CAGD_RIGHT, &turn), CAGD_OUTSIDE_DOMAIN);
    assert_int_equal(cagd_spline_derivatives_q(&s, one, CAGD_RIGHT, CAGD_MAX_DEGREE + 1, D), CAGD_ORDER);
    s.weights = turned; /* (1-t)^2 - 2t(1-t) + t^2 = (1-2t)^2 */
    assert_true(cagd_spline_has_poles_q(&s));
    assert_int_equal(cagd_spline_derivatives_q(&s, from_ratio_q(1, 2), CAGD_LEFT, 0, D), CAGD_UNDEFINED);
    assert_int_equal(cagd_spline_insert_q(&s, from_ratio_q(1, 2), &out, &where), CAGD_UNDEFINED);
    assert_int_equal(where, 1);
    s.degree = -1;
    assert_int_equal(cagd_spline_check_q(&s, &where), CAGD_DEGREE);
}

/* The homogeneous points (1,0;1), (3,2;0), (5,7;1) are no curve, as a weight is 0.  With the knot 1/2 they are one, and in degree 3, too;
 * neither is taken back.  Nor is a curve split where the weight of a point would be 0. */
static void a_weight_that_would_be_zero_is_named(void **state)
{
    (void)state;
    const num_q zero = from_int_q(0), one = from_int_q(1), half = from_ratio_q(1, 2), third = from_ratio_q(1, 3);
    cagd_spline_q out = {0}, right = {0};
    const num_q finer[] = {zero, zero, zero, half, one, one, one}, of_finer[] = {one, half, half, one};
    const num_q cubic[] = {zero, zero, zero, zero, one, one, one, one}, of_cubic[] = {one, third, third, one};
    const num_q quadratic[] = {zero, zero, zero, one, one, one}, of_quadratic[] = {one, from_int_q(-1), one};
    const int place[][8] = {{1, 0, 4, 2, 8, 9, 5, 7}, {1, 0, 7, 4, 11, 11, 5, 7}};
    num_q P[2][8];
    for (int m = 0; m < 8; m++)
        P[0][m] = from_int_q(place[0][m]), P[1][m] = from_int_q(place[1][m]);
    int where = 7;
    cagd_spline_q s = {2, 4, 2, finer, P[0], of_finer};
    assert_int_equal(cagd_spline_remove_q(&s, half, &out, &where), CAGD_UNDEFINED);
    assert_int_equal(where, 1);
    s = (cagd_spline_q){3, 4, 2, cubic, P[1], of_cubic}, where = 7;
    assert_int_equal(cagd_spline_reduce_q(&s, &out, &where), CAGD_UNDEFINED);
    assert_int_equal(where, 1);
    s = (cagd_spline_q){2, 3, 2, quadratic, P[0], of_quadratic}, where = 7;
    assert_int_equal(cagd_spline_split_q(&s, half, &out, &right, &where), CAGD_UNDEFINED);
    assert_int_equal(where, 1);
    s.weights = (const num_q[]){one, from_ratio_q(-1, 2), one}, where = 7; /* (1 + 2 (-1/2))/3 */
    assert_int_equal(cagd_spline_elevate_q(&s, &out, &where), CAGD_UNDEFINED);
    assert_int_equal(where, 1);
    /* from 0 to 1 the last weight is (1 - 1)/2; the knot 1 once more makes a span without length */
    const num_q two = from_int_q(2), minus = from_int_q(-1), of_two[] = {one, one, minus, one, one};
    const num_q once[] = {zero, zero, zero, one, two, two, two}, twice[] = {zero, zero, zero, one, one, two, two, two};
    num_q five[10];
    for (int m = 0; m < 10; m++)
        five[m] = from_int_q(m);
    s = (cagd_spline_q){2, 4, 2, once, P[0], of_two}, where = 7;
    assert_int_equal(cagd_spline_segment_q(&s, 2, &out, &where), CAGD_UNDEFINED);
    assert_int_equal(where, 2);
    assert_true(cagd_spline_has_poles_q(&s));
    s.weights = NULL;
    assert_false(cagd_spline_has_poles_q(&s));
    s = (cagd_spline_q){2, 5, 2, twice, five, (const num_q[]){one, one, two, one, one}};
    assert_false(cagd_spline_has_poles_q(&s));
}

/* *where is -1 where nothing is meant, whatever stood there before; of a curve in space the curvature is that of its definition. */
static void what_is_refused(void **state)
{
    (void)state;
    const num_q zero = from_int_q(0), one = from_int_q(1);
    const num_q knots[] = {zero, one, one, one}, points[] = {one, zero, one, one, from_int_q(3), from_ratio_q(5, 2)};
    cagd_spline_q s = {0, 1, 3, knots, points, NULL}, left = {0}, right = {0};
    int where = 7;
    assert_int_equal(cagd_spline_reduce_q(&s, &left, &where), CAGD_DEGREE);
    assert_int_equal(where, -1);
    where = 7;
    assert_int_equal(cagd_spline_split_q(&s, zero, &left, &right, &where), CAGD_OUTSIDE_DOMAIN);
    assert_int_equal(where, -1);
    where = 7;
    s.degree = CAGD_MAX_DEGREE + 1;
    assert_int_equal(cagd_spline_check_q(&s, &where), CAGD_DEGREE);
    assert_int_equal(where, -1);
    s.degree = 0;
    for (int dim = 0; dim <= CAGD_MAX_DIM + 1; dim += CAGD_MAX_DIM + 1) {
        s.dim = dim, where = 7;
        assert_int_equal(cagd_spline_check_q(&s, &where), CAGD_DIMENSION);
        assert_int_equal(where, -1);
    }
    num_q curvature;
    s.dim = 1; /* a curve on a line has no curvature */
    assert_int_equal(cagd_spline_curvature_squared_q(&s, zero, CAGD_RIGHT, &curvature), CAGD_DIMENSION);
    s.dim = 3, s.degree = CAGD_MAX_DEGREE, where = 7;
    assert_int_equal(cagd_spline_elevate_q(&s, &left, &where), CAGD_DEGREE);
    assert_int_equal(where, -1);
    s.degree = 0;
    s.dim = CAGD_MAX_DIM, where = 7;
    assert_int_equal(cagd_spline_check_q(&s, &where), CAGD_OK);
    assert_int_equal(where, -1);
    s.count = 0, where = 7;
    assert_int_equal(cagd_spline_check_q(&s, &where), CAGD_COUNT);
    assert_int_equal(where, -1);
}

/* The twisted cubic (t, t^2, t^3): k^2 = 4 (9 t^4 + 9 t^2 + 1)/(9 t^4 + 4 t^2 + 1)^3, torsion 3/(9 t^4 + 9 t^2 + 1). */
static void curvature_and_torsion_in_space(void **state)
{
    (void)state;
    const num_q zero = from_int_q(0), one = from_int_q(1), third = from_ratio_q(1, 3), two = from_ratio_q(2, 3);
    const num_q knots[] = {zero, zero, zero, zero, one, one, one, one};
    const num_q points[] = {zero, zero, zero, third, zero, zero, two, third, zero, one, one, one};
    cagd_spline_q s = {3, 4, 3, knots, points, NULL};
    for (int k = 0; k <= 4; k++) {
        num_q t = from_ratio_q(k, 4), t2 = mul_q(t, t), t4 = mul_q(t2, t2), nine = from_int_q(9), x;
        num_q a = add_q(add_q(mul_q(nine, t4), mul_q(nine, t2)), one),
              b = add_q(add_q(mul_q(nine, t4), mul_q(from_int_q(4), t2)), one);
        assert_int_equal(cagd_spline_curvature_squared_q(&s, t, CAGD_RIGHT, &x), CAGD_OK);
        assert_true(cagd_equal_q(mul_q(x, mul_q(b, mul_q(b, b))), mul_q(from_int_q(4), a)));
        assert_int_equal(cagd_spline_torsion_q(&s, t, CAGD_RIGHT, &x), CAGD_OK);
        assert_true(cagd_equal_q(mul_q(x, a), from_int_q(3)));
    }
}

/* A knot inside a polynomial of degree p is inserted p times, and removed from each multiplicity again. */
static void knots_of_every_multiplicity_are_removed(void **state)
{
    (void)state;
    enum { DEGREES = 7 };
    for (int p = 1; p < DEGREES; p++) {
        num_q knots[2 * DEGREES + 2], points[2 * DEGREES];
        for (int i = 0; i <= 2 * p + 1; i++)
            knots[i] = from_int_q(i > p);
        for (int i = 0; i < 2 * (p + 1); i++)
            points[i] = from_ratio_q((i * i * 37 + i * 11 + 5) % 23 - 11, i + 2);
        cagd_spline_q chain[DEGREES + 1] = {{.degree = p, .count = p + 1, .dim = 2, .knots = knots, .points = points}},
                                      back;
        int where;
        for (int m = 0; m < p; m++)
            assert_int_equal(cagd_spline_insert_q(&chain[m], from_ratio_q(2, 5), &chain[m + 1], &where), CAGD_OK);
        for (int m = p; m > 0; m--) {
            assert_int_equal(cagd_spline_remove_q(&chain[m], from_ratio_q(2, 5), &back, &where), CAGD_OK);
            assert_int_equal(back.count, chain[m - 1].count);
            for (int i = 0; i < 2 * back.count; i++)
                assert_true(cagd_equal_q(back.points[i], chain[m - 1].points[i]));
            for (int i = 0; i <= back.count + p; i++)
                assert_true(cagd_equal_q(back.knots[i], chain[m - 1].knots[i]));
        }
    }
}

/* At a knot of every multiplicity: one more of it, and the parts on both sides, whose knots are those on that side and t itself p+1 times. */
static void knots_and_parts_at_a_knot(void **state)
{
    (void)state;
    int full = 0;
    for (int trial = 0; trial < TRIALS; trial++) {
        cagd_spline_q s = random_curve(trial), finer, left, right;
        int p = s.degree, n = s.count, where;
        for (int k = p; k <= n; k++) {
            num_q t = s.knots[k];
            int before = 0, times = 0;
            for (int i = 0; i <= n + p; i++) {
                before += cagd_compare_q(s.knots[i], t) < 0;
                times += cagd_equal_q(s.knots[i], t);
            }
            int at_end = cagd_equal_q(t, s.knots[n]), inside = !at_end && !cagd_equal_q(t, s.knots[p]);
            cagd_status expected = at_end ? CAGD_OUTSIDE_DOMAIN : times > p ? CAGD_KNOTS_MULTIPLE : CAGD_OK;
            assert_int_equal(cagd_spline_insert_q(&s, t, &finer, &where), expected);
            assert_int_equal(where, -1);
            if (expected == CAGD_OK) {
                assert_int_equal(finer.count, n + 1);
                same_curve(&s, &finer);
                for (int i = 0; i <= n + p + 1; i++)
                    assert_true(cagd_equal_q(finer.knots[i], s.knots[i <= before ? i : i - 1]));
            }
            assert_int_equal(cagd_spline_split_q(&s, t, &left, &right, &where), inside ? CAGD_OK : CAGD_OUTSIDE_DOMAIN);
            assert_int_equal(where, -1);
            if (!inside)
                continue;
            full += times > p;
            assert_int_equal(left.count, before);
            assert_int_equal(right.count, n + p + 1 - before - times);
            for (int i = 0; i <= before + p; i++)
                assert_true(cagd_equal_q(left.knots[i], i < before ? s.knots[i] : t));
            for (int i = 0; i <= right.count + p; i++)
                assert_true(cagd_equal_q(right.knots[i], i <= p ? t : s.knots[before + times + i - p - 1]));
            same_curve(&s, &left);
            same_curve(&s, &right);
        }
    }
    assert_true(full > 5);
}

/* The parabola (t, t^2) turns left, (t, -t^2) right, and of a line there is no turn; (t^2, t^3) stands still at t = 0. */
static void turns_and_tangents(void **state)
{
    (void)state;
    const num_q zero = from_int_q(0), one = from_int_q(1), half = from_ratio_q(1, 2), third = from_ratio_q(1, 3);
    const num_q knots[] = {zero, zero, zero, one, one, one}, four[] = {zero, zero, zero, zero, one, one, one, one};
    for (int side = -1; side <= 1; side++)
        for (int turned = 0; turned < 2; turned++) { /* with the axes exchanged it is the other side */
            const num_q end = from_int_q(side);
            num_q points[] = {zero, zero, half, zero, one, end}, exchanged[6], x;
            for (int m = 0; m < 6; m++)
                exchanged[m] = points[m ^ 1];
            const cagd_spline_q s = {2, 3, 2, knots, turned ? exchanged : points, NULL};
            for (int k = 0; k <= 4; k++) {
                int turn = 7;
                assert_int_equal(cagd_spline_turn_q(&s, from_ratio_q(k, 4), CAGD_RIGHT, &turn), CAGD_OK);
                assert_int_equal(turn, turned ? -side : side);
            }
            assert_int_equal(cagd_spline_curvature_squared_q(&s, zero, CAGD_LEFT, &x), CAGD_OK);
            assert_true(cagd_equal_q(x, from_int_q(4 * side * side)));
        }
    const num_q cusp[] = {zero, zero, zero, zero, third, zero, one, one};
    const cagd_spline_q still = {3, 4, 2, four, cusp, NULL};
    int turn = 7;
    num_q x = one;
    assert_int_equal(cagd_spline_turn_q(&still, zero, CAGD_RIGHT, &turn), CAGD_UNDEFINED);
    assert_int_equal(cagd_spline_curvature_squared_q(&still, zero, CAGD_RIGHT, &x), CAGD_UNDEFINED);
    assert_int_equal(turn, 7);
    assert_true(cagd_equal_q(x, one));
    assert_int_equal(cagd_spline_turn_q(&still, one, CAGD_RIGHT, &turn), CAGD_OK);
    assert_int_equal(turn, 1);
    for (int dim = 1; dim <= 3; dim += 2) {
        const cagd_spline_q other = {0, 1, dim, (const num_q[]){zero, one}, four, NULL};
        assert_int_equal(cagd_spline_turn_q(&other, zero, CAGD_RIGHT, &turn), CAGD_DIMENSION);
    }
}

/* A line along each axis and diagonal of space has curvature 0 and no torsion, a plane curve has torsion 0; derivatives of every order up to the greatest. */
static void lines_and_planes_in_space(void **state)
{
    (void)state;
    const num_q zero = from_int_q(0), one = from_int_q(1);
    const num_q knots[] = {zero, zero, zero, zero, one, one, one, one};
    for (int way = 1; way < 8; way++) {
        num_q points[12], flat[12], x = one;
        for (int m = 0; m < 12; m++) {
            int along = (way >> m % 3 & 1) * (m / 3) * (m / 3 + 1);
            points[m] = from_int_q(along);
            flat[m] = from_int_q(along + (m / 3 == 3 && m % 3 == (way % 3))); /* once beside the line */
        }
        const cagd_spline_q line = {3, 4, 3, knots, points, NULL};
        assert_int_equal(cagd_spline_torsion_q(&line, one, CAGD_RIGHT, &x), CAGD_UNDEFINED);
        assert_true(cagd_equal_q(x, one));
        assert_int_equal(cagd_spline_curvature_squared_q(&line, one, CAGD_RIGHT, &x), CAGD_OK);
        assert_true(cagd_is_zero_q(x));
        const cagd_spline_q plane = {3, 4, 3, knots, flat, NULL};
        if (way == 7 || !(way >> way % 3 & 1) || way == 3 || way == 6 || way == 5) {
            assert_int_equal(cagd_spline_torsion_q(&plane, one, CAGD_RIGHT, &x), CAGD_OK);
            assert_true(cagd_is_zero_q(x));
        }
        num_q D[(CAGD_MAX_DEGREE + 1) * 3];
        assert_int_equal(cagd_spline_derivatives_q(&plane, one, CAGD_RIGHT, CAGD_MAX_DEGREE, D), CAGD_OK);
        for (int m = 4 * 3; m < (CAGD_MAX_DEGREE + 1) * 3; m++)
            assert_true(cagd_is_zero_q(D[m]));
        for (int c = 0; c < 3; c++)
            assert_true(cagd_equal_q(D[c], flat[9 + c]));
    }
}

/* Poles at the start, at an inner knot, between and at the end; weights that are all negative have none; neither has one beside the domain. */
static void poles_wherever_they_are(void **state)
{
    (void)state;
    const int knots_of[] = {0, 0, 1, 2, 3, 3}, outer[] = {0, 1, 2, 3, 4, 5};
    num_q knots[2][6], points[4];
    for (int i = 0; i < 6; i++)
        knots[0][i] = from_int_q(knots_of[i]), knots[1][i] = from_int_q(outer[i]);
    for (int i = 0; i < 4; i++)
        points[i] = from_int_q(i);
    for (int code = 0; code < 81; code++) {
        num_q weights[4];
        int sign[4], poles = 0;
        for (int i = 0, rest = code; i < 4; i++, rest /= 3)
            weights[i] = from_int_q(sign[i] = rest % 3 - 1);
        for (int i = 0; i < 3; i++) /* between points that are not of one sign */
            poles |= sign[i] * sign[i + 1] <= 0;
        for (int clamped = 0; clamped < 2; clamped++) {
            const cagd_spline_q s = {1, 4, 1, knots[!clamped], points, weights};
            assert_int_equal(cagd_spline_has_poles_q(&s) != 0, poles);
        }
    }
    /* lines and parabolas that vanish where the next segment has begun */
    const num_q beside[] = {from_int_q(1), from_int_q(3), from_int_q(1), from_int_q(5)};
    for (int p = 1; p <= 2; p++)
        for (int clamped = 0; clamped < 2; clamped++) {
            const cagd_spline_q s = {p, 5 - p, 1, knots[!clamped], points, beside};
            int where;
            if (cagd_spline_check_q(&s, &where) == CAGD_OK)
                assert_false(cagd_spline_has_poles_q(&s));
        }
}

/* What is refused leaves a result as it was. */
static void nothing_is_written_without_a_result(void **state)
{
    (void)state;
    const num_q zero = from_int_q(0), one = from_int_q(1), half = from_ratio_q(1, 2);
    const num_q knots[] = {zero, zero, half, one, one}, points[] = {zero, one, zero}, weights[] = {one, zero, one};
    const cagd_spline_q s = {1, 3, 1, knots, points, NULL}, w = {1, 3, 1, knots, points, weights};
    const cagd_spline_q before = {-7, -8, -9, knots + 1, points + 1, weights + 1};
    cagd_spline_q a = before, b = before;
    int where;
    assert_int_equal(cagd_spline_insert_q(&s, one, &a, &where), CAGD_OUTSIDE_DOMAIN);
    assert_int_equal(cagd_spline_insert_q(&s, zero, &a, &where), CAGD_KNOTS_MULTIPLE);
    assert_int_equal(cagd_spline_remove_q(&s, one, &a, &where), CAGD_NO_KNOT);
    assert_int_equal(cagd_spline_remove_q(&s, half, &a, &where), CAGD_CHANGES);
    assert_int_equal(cagd_spline_reduce_q(&s, &a, &where), CAGD_CHANGES);
    assert_int_equal(cagd_spline_segment_q(&s, 3, &a, &where), CAGD_OUTSIDE_DOMAIN);
    assert_int_equal(cagd_spline_split_q(&s, zero, &a, &b, &where), CAGD_OUTSIDE_DOMAIN);
    assert_int_equal(cagd_spline_elevate_q(&w, &a, &where), CAGD_UNDEFINED);
    assert_int_equal(cagd_spline_segment_q(&w, 1, &a, &where), CAGD_UNDEFINED);
    assert_int_equal(where, 1);
    assert_int_equal(cagd_spline_split_q(&w, from_ratio_q(1, 4), &a, &b, &where), CAGD_UNDEFINED);
    assert_memory_equal(&a, &before, sizeof a);
    assert_memory_equal(&b, &before, sizeof b);
}

/* In degree 1 the points of an elevated curve are R_0, (R_0 + R_1)/2, R_1, ...: whichever weight is 0 is named, be it in one of the later segments. */
static void the_weight_that_is_zero_is_named_wherever_it_is(void **state)
{
    (void)state;
    enum { N = 5 };
    num_q knots[N + 2], points[N];
    for (int i = 0; i < N + 2; i++)
        knots[i] = from_int_q(i < 1 ? 0 : i > N ? N - 1 : i - 1);
    for (int i = 0; i < N; i++)
        points[i] = from_int_q(i * i);
    for (int zero = 0; zero < 2 * N - 1; zero++) { /* at a point, or between two of them by opposite weights */
        num_q weights[N];
        for (int i = 0; i < N; i++)
            weights[i] = from_int_q(zero % 2 == 0 ? i != zero / 2 : i <= zero / 2 ? 1 : -1);
        const cagd_spline_q s = {1, N, 1, knots, points, weights};
        cagd_spline_q out, right;
        int where = 7;
        assert_int_equal(cagd_spline_elevate_q(&s, &out, &where), CAGD_UNDEFINED);
        assert_int_equal(where, zero);
        num_q middle = from_ratio_q(zero / 2 * 2 + 1, 2); /* of opposite weights */
        if (zero % 2 == 1) {
            assert_int_equal(cagd_spline_insert_q(&s, middle, &out, &where), CAGD_UNDEFINED);
            assert_int_equal(where, zero / 2 + 1);
            assert_int_equal(cagd_spline_split_q(&s, middle, &out, &right, &where), CAGD_UNDEFINED);
            assert_int_equal(where, zero / 2 + 1);
        }
        for (int mu = 1; mu < N; mu++) {
            int has = zero % 2 == 0 && (zero / 2 == mu || zero / 2 == mu - 1);
            assert_int_equal(cagd_spline_segment_q(&s, mu, &out, &where), has ? CAGD_UNDEFINED : CAGD_OK);
            assert_int_equal(where, !has ? -1 : zero / 2 == mu);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        unit(knots_of_every_multiplicity_are_removed),
        unit(inserted_knots_are_removed_again),
        unit(weights_alone_hold_a_knot),
        unit(raised_degrees_are_lowered_again),
        unit(parts_and_segments_are_the_curve),
        unit(a_circle_has_one_curvature_and_no_pole),
        unit(a_weight_that_would_be_zero_is_named),
        unit(what_is_refused),
        unit(curvature_and_torsion_in_space),
        unit(knots_and_parts_at_a_knot),
        unit(turns_and_tangents),
        unit(lines_and_planes_in_space),
        unit(poles_wherever_they_are),
        unit(nothing_is_written_without_a_result),
        unit(the_weight_that_is_zero_is_named_wherever_it_is),
    };
    return run_unit_tests(tests);
}
