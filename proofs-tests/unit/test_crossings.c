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
    assert_true(cagd_curve_meets_line(2, flat, ones, line(2, -1, 0)).contained);
    /* first weight 0: the curve starts at its second point, t = 0 is no pole */
    num_q lost[3] = {q(0), q(1), q(1)};
    m = cagd_curve_meets_line(2, parabola, lost, line(0, 1, 1));
    assert_int_equal(m.poles, 0);
    assert_int_equal(m.common_closed, 1);
    num_q none[3] = {q(0), q(0), q(0)};
    cagd_curve_meets_line(2, parabola, none, line(0, 1, 1));
    expect_fault(FAULT_UNDEFINED);
    cagd_curve_meets_line(2, parabola, ones, line(0, 0, 1));
    expect_fault(FAULT_UNDEFINED);
    cagd_polygon_meets_line(2, parabola, line(0, 0, 1));
    expect_fault(FAULT_UNDEFINED);
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
            y[i] = q(random_int(-1, 1));
            R[2 * i] = add_q(x[i], from_ratio_q(1, 7));
            R[2 * i + 1] = div_q(sub_q(sub_q(y[i], q(1)), mul_q(q(3), R[2 * i])), q(2));
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
                num_q middle = div_q(add_q(x[i], x[i + 1]), q(2)); /* y = +-1 at the ends */
                part[parts++] = (struct part){middle, middle};
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
        unit(planted_meetings),
        unit(crossing_is_not_common_point),
        unit(variation_diminishes),
        unit(polygons_by_definition),
    };
    return run_unit_tests(tests);
}
