/* test_crossings.c -- curves and polygons against lines: planted common points, and definitions. */
#include "unit_roots.h"

#include "exact/decide/crossings.h"
#include "exact/words.h"

static num_q q(long m) { return from_int_q(m); }
static struct cagd_line line(long a, long b, long c) { return (struct cagd_line){q(a), q(b), q(c)}; }

/* Points and weights of the curve x = X/W, y = Y/W; 0 when a weight of degree n would be 0. */
static int bezier_form(int n, poly X, poly Y, poly W, num_q R[], num_q w[])
{
    num_q x[64], y[64];
    poly_to_bernstein(X, n, q(0), q(1), x);
    poly_to_bernstein(Y, n, q(0), q(1), y);
    poly_to_bernstein(W, n, q(0), q(1), w);
    for (int i = 0; i <= n; i++) {
        if (cagd_is_zero_q(w[i]))
            return 0;
        R[2 * i] = div_q(x[i], w[i]);
        R[2 * i + 1] = div_q(y[i], w[i]);
    }
    return 1;
}

/* Y is made so that slope X + Y + shear W = g: the line is any line, the roots of g and W are known. */
static void planted_meetings(void **state)
{
    (void)state;
    int tested = 0, jumps = 0, poles = 0;
    for (int k = 0; k < 300; k++) {
        region_mark mark = region_open();
        struct planted g = plant(), W = plant();
        num_q zero = q(0), one = q(1), R[128], w[64], shear = random_q(), slope = random_q();
        poly X = poly_add(poly_mul(poly_variable(), W.p), poly_constant(random_q())); /* no common factor with W */
        poly height = g.p, Y = poly_sub(height, poly_add(poly_scale(X, slope), poly_scale(W.p, shear)));
        int n = cagd_poly_degree(X) > cagd_poly_degree(Y) ? cagd_poly_degree(X) : cagd_poly_degree(Y);
        if (bezier_form(n, X, Y, W.p, R, w)) {
            struct cagd_curve_meets_line m = cagd_curve_meets_line(n, R, w, (struct cagd_line){slope, q(1), shear});
            int closed = 0, open = 0, crossings = 0, changes = 0;
            for (int j = 0; j < g.count; j++) {
                int in_closed = cagd_compare_q(g.at[j], zero) >= 0 && cagd_compare_q(g.at[j], one) <= 0;
                int in_open = cagd_compare_q(g.at[j], zero) > 0 && cagd_compare_q(g.at[j], one) < 0,
                    parity = g.multiplicity[j];
                int affine = 1;
                for (int i = 0; i < W.count; i++)
                    if (cagd_equal_q(W.at[i], g.at[j])) {
                        affine = 0;
                        parity += W.multiplicity[i];
                    }
                closed += affine && in_closed;
                open += affine && in_open;
                crossings += affine && in_open && parity % 2;
                changes += !affine && in_open && parity % 2;
            }
            for (int i = 0; i < W.count; i++) {
                int alone = 1;
                for (int j = 0; j < g.count; j++)
                    alone &= !cagd_equal_q(W.at[i], g.at[j]);
                changes += alone && W.multiplicity[i] % 2 && cagd_compare_q(W.at[i], zero) > 0 &&
                           cagd_compare_q(W.at[i], one) < 0;
            }
            assert_int_equal(m.contained, 0);
            assert_int_equal(m.common_closed, closed);
            assert_int_equal(m.common_open, open);
            assert_int_equal(m.crossings, crossings);
            assert_int_equal(m.touches, open - crossings);
            assert_int_equal(m.poles, planted_count(&W, zero, one, CLOSED).distinct);
            assert_int_equal(m.jumps, changes);
            tested++;
            jumps += m.jumps;
            poles += m.poles;
        }
        region_drop(mark);
    }
    assert_true(tested > 100 && jumps > 20 && poles > 40);
}

/* The quarter circle touches x = 1 in its end, crosses x = y, and a parabola touches its tangent. */
static void crossing_is_not_common_point(void **state)
{
    (void)state;
    num_q quarter[6] = {q(1), q(0), q(1), q(1), q(0), q(1)}, w[3] = {q(1), q(1), q(2)};
    struct cagd_curve_meets_line m = cagd_curve_meets_line(2, quarter, w, line(1, 0, -1));
    assert_int_equal(m.common_closed, 1);
    assert_int_equal(m.common_open, 0);
    assert_int_equal(m.crossings, 0);
    m = cagd_curve_meets_line(2, quarter, w, line(1, -1, 0));
    assert_int_equal(m.crossings, 1);
    num_q parabola[6] = {q(-1), q(1), q(0), q(-1), q(1), q(1)}, ones[3] = {q(1), q(1), q(1)};
    m = cagd_curve_meets_line(2, parabola, ones, line(0, 1, 0));
    assert_int_equal(m.common_open, 1);
    assert_int_equal(m.touches, 1);
    assert_int_equal(m.crossings, 0);
    num_q flat[6] = {q(1), q(2), q(2), q(4), q(-5), q(-10)};
    m = cagd_curve_meets_line(2, flat, ones, line(2, -1, 0));
    const struct cagd_curve_meets_line on_it = {.contained = 1};
    assert_memory_equal(&m, &on_it, sizeof m);
    /* first weight 0: the curve starts at its second point, t = 0 is no pole */
    num_q lost[3] = {q(0), q(1), q(1)};
    m = cagd_curve_meets_line(2, parabola, lost, line(0, 1, 1));
    assert_int_equal(m.poles, 0);
    assert_int_equal(m.common_closed, 1);
    /* y = 1 has a pole at 1/2 where its sign does not change: no jump over y = 0, and one over y = x */
    num_q level[4] = {q(-2), q(1), q(2), q(1)}, turned[2] = {q(-1), q(1)};
    m = cagd_curve_meets_line(1, level, turned, line(0, 1, 0));
    assert_true(m.poles == 1 && m.jumps == 0 && m.common_closed == 0);
    m = cagd_curve_meets_line(1, level, turned, line(1, -1, 0));
    assert_true(m.poles == 1 && m.jumps == 1);
    /* last weight 0, likewise */
    num_q ended[3] = {q(1), q(1), q(0)};
    assert_int_equal(cagd_curve_meets_line(2, parabola, ended, line(0, 1, 1)).poles, 0);
}

/* w = t, 1 - t, and both: the points at the ends, and nowhere else, are at infinity. */
static void poles_at_the_ends(void **state)
{
    (void)state;
    /* Homogeneous points that are not 0 where the weight is: (x, y) = (X/w, Y/w) with the weights w and X, Y of degree 2 above them. */
    poly t = poly_variable(), one = poly_constant(q(1)), back = poly_sub(one, t);
    poly W[4] = {t, back, poly_mul(t, back), poly_add(poly_mul(t, t), one)};
    const int poles[4] = {1, 1, 2, 0};
    for (int k = 0; k < 4; k++) {
        /* in degree 3 with the factor t + 1, so that no weight of the Bernstein form is 0 but the end ones */
        poly w = poly_mul(W[k], poly_add(t, one)), X = poly_add(poly_mul(t, t), poly_constant(q(3)));
        num_q R[8], c[4], x[4];
        poly_to_bernstein(w, 3, q(0), q(1), c);
        poly_to_bernstein(X, 3, q(0), q(1), x);
        int lost = 0;
        for (int i = 0; i <= 3; i++) {
            lost += cagd_is_zero_q(c[i]);
            R[2 * i] = cagd_is_zero_q(c[i]) ? q(0) : div_q(x[i], c[i]);
            R[2 * i + 1] = q(i);
        }
        struct cagd_curve_meets_line m = cagd_curve_meets_line(3, R, c, line(1, 0, 1000));
        /* a weight 0 takes the point with it: numerator and denominator are both without that term, and what is left may vanish too */
        poly X0 = poly_constant(q(0)), Y0 = X0;
        num_q a[4], b[4];
        for (int i = 0; i <= 3; i++)
            a[i] = mul_q(c[i], R[2 * i]), b[i] = mul_q(c[i], R[2 * i + 1]);
        X0 = poly_from_bernstein(3, a), Y0 = poly_from_bernstein(3, b);
        int expected = 0;
        for (int end = 0; end <= 1; end++)
            expected += cagd_is_zero_q(poly_value(w, q(end))) &&
                        !(cagd_is_zero_q(poly_value(X0, q(end))) && cagd_is_zero_q(poly_value(Y0, q(end))));
        assert_int_equal(lost, poles[k]);
        assert_int_equal(m.poles, expected);
    }
    /* negative and positive end weights over a pole inside, and one exactly at t = 1: w = 1 - t, x = 1/(1 - t), in degree 1 */
    num_q P[4] = {q(1), q(2), q(5), q(7)}, w[2] = {q(-1), q(1)};
    assert_int_equal(cagd_curve_meets_line(1, P, w, line(1, 0, 9)).poles, 1);
    /* the weights 1, -1, 1 of degree 2: w = 1 - 4 t + 4 t^2 = (1 - 2 t)^2 */
    num_q Q[6] = {q(1), q(2), q(5), q(7), q(2), q(2)}, v[3] = {q(1), q(-1), q(1)};
    assert_int_equal(cagd_curve_meets_line(2, Q, v, line(1, 0, 9)).poles, 1);
}

/* What is undefined is answered with zeros alone, and the region is as before. */
static void undefined_says_nothing(void **state)
{
    (void)state;
    num_q parabola[6] = {q(-1), q(1), q(0), q(-1), q(1), q(1)}, ones[3] = {q(1), q(1), q(1)},
          none[3] = {q(0), q(0), q(0)};
    const struct cagd_curve_meets_line nothing = {0};
    region_mark before = region_open();
    struct cagd_curve_meets_line m = cagd_curve_meets_line(2, parabola, none, line(0, 1, 1));
    expect_fault(FAULT_UNDEFINED);
    assert_memory_equal(&m, &nothing, sizeof m);
    m = cagd_curve_meets_line(2, parabola, ones, line(0, 0, 1));
    expect_fault(FAULT_UNDEFINED);
    assert_memory_equal(&m, &nothing, sizeof m);
    const struct cagd_polygon_meets_line no_points = {0};
    struct cagd_polygon_meets_line p = cagd_polygon_meets_line(2, parabola, line(0, 0, 0));
    expect_fault(FAULT_UNDEFINED);
    assert_memory_equal(&p, &no_points, sizeof p);
    region_drop(before);
}

/* With positive weights a line crosses the curve no more often than the control polygon. */
static void variation_diminishes(void **state)
{
    (void)state;
    int less = 0;
    for (int k = 0; k < 200; k++) {
        region_mark mark = region_open();
        int n = random_int(1, 9);
        num_q R[20], w[10];
        for (int i = 0; i <= n; i++) {
            R[2 * i] = coarse_q(5, 3);
            R[2 * i + 1] = coarse_q(5, 3);
            w[i] = from_ratio_q(random_int(1, 9), random_int(1, 9));
        }
        struct cagd_line l = line(random_int(1, 5), random_int(-5, 5), random_int(-3, 3));
        struct cagd_curve_meets_line m = cagd_curve_meets_line(n, R, w, l);
        if (!m.contained) {
            int polygon = cagd_polygon_crossings(n, R, l);
            assert_true(m.crossings <= polygon && (m.crossings - polygon) % 2 == 0);
            assert_true(m.poles == 0 && m.jumps == 0);
            less += m.crossings < polygon;
        }
        region_drop(mark);
    }
    assert_true(less > 20);
}

/* One part of polygon and line y = 0: the two ends of the part of an edge on it.  Small integers. */
struct part {
    num_q from, to;
};

/* The definitions, read aloud: edge after edge, then components by joining parts that meet. */
static void polygons_by_definition(void **state)
{
    (void)state;
    int several = 0;
    for (int k = 0; k < 2000; k++) {
        region_mark mark = region_open();
        int n = random_int(0, 8), parts = 0, signs[9], change = 0, runs = 0, edges = 0;
        num_q R[18], x[9], y[9];
        struct cagd_line l = line(3, 2, 1); /* of the point (x,y) below: 3 X + 2 Y + 1 = y */
        for (int i = 0; i <= n; i++) {
            x[i] = q(random_int(-2, 2));
            y[i] = q(random_int(-1, 1) * random_int(1, 3));
            R[2 * i] = add_q(x[i], from_ratio_q(1, 7));
            R[2 * i + 1] = div_q(sub_q(sub_q(y[i], q(1)), mul_q(q(3), R[2 * i])), q(2));
            if (k % 3 == 1) /* the y-axis */
                R[2 * i] = y[i], R[2 * i + 1] = x[i], l = line(2, 0, 0);
            if (k % 3 == 2) /* the x-axis, from the other side */
                R[2 * i] = x[i], R[2 * i + 1] = y[i], l = line(0, -3, 0);
            signs[i] = cagd_sign_q(y[i]);
        }
        struct part part[20];
        int group[20];
        for (int i = 0; i <= n; i++)
            if (signs[i] == 0) {
                int with_next = i < n && signs[i + 1] == 0;
                num_q a = x[i], b = with_next ? x[i + 1] : x[i];
                part[parts++] = cagd_compare_q(a, b) < 0 ? (struct part){a, b} : (struct part){b, a};
                edges += with_next && !cagd_equal_q(a, b);
                runs += !with_next; /* a run ends here */
            } else if (i < n && signs[i] * signs[i + 1] < 0) {
                num_q share = div_q(y[i], sub_q(y[i], y[i + 1])),
                      hit = add_q(x[i], mul_q(share, sub_q(x[i + 1], x[i])));
                part[parts++] = (struct part){hit, hit};
                runs++;
            }
        for (int i = 0; i <= n; i++) /* a change from i to the next nonzero sign */
            for (int j = i + 1, found = 0; j <= n && !found && signs[i] != 0; j++)
                if (signs[j] != 0) {
                    change += signs[i] != signs[j];
                    found = 1;
                }
        int components = parts;
        for (int i = 0; i < parts; i++)
            group[i] = i;
        for (int i = 0; i < parts; i++)
            for (int j = 0; j < i; j++)
                if (cagd_compare_q(part[i].from, part[j].to) <= 0 && cagd_compare_q(part[j].from, part[i].to) <= 0 &&
                    group[i] != group[j]) {
                    int old = group[i], now = group[j];
                    for (int h = 0; h < parts; h++)
                        group[h] = group[h] == old ? now : group[h];
                    components--;
                }
        struct cagd_polygon_meets_line m = cagd_polygon_meets_line(n, R, l);
        assert_int_equal(m.crossings, change);
        assert_int_equal(m.common_runs, runs);
        assert_int_equal(m.components, components);
        assert_int_equal(m.contained_edges, edges);
        several += components > 2 && edges > 0;
        region_drop(mark);
    }
    assert_true(several > 20);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        unit(planted_meetings),       unit(crossing_is_not_common_point), unit(poles_at_the_ends),
        unit(undefined_says_nothing), unit(variation_diminishes),         unit(polygons_by_definition),
    };
    return run_unit_tests(tests);
}
