/* test_overlap.c -- what the contracts of kernels permit of their arrays, tried in just that way: results that overlap what they are made
 * of give what they give apart; what is not read is NULL; leading coefficients are 0; knots have every multiplicity. */
#include "unit_exact.h"

#include "core/number/limits.h"
#include "exact/kernels_q.h"
#include "exact/span.h"
#include "exact/words.h"

#include <string.h>

enum { MOST_N = 6, MOST_D = 3, ROOM = 4 * (MOST_N + 2) * MOST_D };

static num_q apart[ROOM], together[ROOM], given[ROOM];

static void fill(int count, num_q a[])
{
    for (int k = 0; k < count; k++)
        a[k] = random_q();
}
static void same(int count, const num_q a[], const num_q b[])
{
    for (int k = 0; k < count; k++)
        assert_true(cagd_equal_q(a[k], b[k]));
}
/* The array b at its place in `together`, where out lies `by` places further, or before it. */
static num_q *laid(int count, const num_q b[])
{
    memcpy(together + ROOM / 2, b, (size_t)count * sizeof *b);
    return together + ROOM / 2;
}

/* bezier.tmpl.h: out may overlap b, which is at every distance at which they meet. */
static void points_of_a_curve(void **state)
{
    (void)state;
    num_q t[] = {from_ratio_q(2, 7), from_ratio_q(-5, 3), from_ratio_q(9, 4)}, u[MOST_N];
    for (int n = 0; n <= MOST_N; n++)
        for (int dim = 1; dim <= MOST_D; dim++) {
            int count = (n + 1) * dim;
            fill(count, given), fill(MOST_N, u);
            for (int by = 1 - dim; by < count; by++)
                for (int k = 0; k < 3; k++) {
                    num_q *b = laid(count, given);
                    bezier_casteljau_q(n, dim, given, t[k], apart);
                    bezier_casteljau_q(n, dim, b, t[k], b + by);
                    same(dim, apart, b + by);
                    b = laid(count, given);
                    bezier_blossom_q(n, dim, given, u, apart);
                    bezier_blossom_q(n, dim, b, u, b + by);
                    same(dim, apart, b + by);
                }
            for (int r = 0; r <= n; r++) {
                int rest = (n - r + 1) * dim;
                for (int by = 1 - rest; by < count; by++) {
                    num_q *b = laid(count, given);
                    bezier_differences_q(n, dim, given, r, apart);
                    bezier_differences_q(n, dim, b, r, b + by);
                    same(rest, apart, b + by);
                }
            }
        }
}

/* bernstein.tmpl.h: a factor twice; a basis changed in place. */
static void polynomials(void **state)
{
    (void)state;
    for (int n = 0; n <= MOST_N; n++) {
        num_q copy[MOST_N + 1];
        fill(n + 1, given);
        memcpy(copy, given, sizeof copy);
        bernstein_product_q(n, given, n, copy, apart);
        bernstein_product_q(n, given, n, given, together);
        same(2 * n + 1, apart, together);
        bernstein_to_power_q(n, given, apart);
        bernstein_to_power_q(n, given, given);
        same(n + 1, apart, given);
        bernstein_from_power_q(n, given, apart);
        bernstein_from_power_q(n, given, given);
        same(n + 1, apart, given);
        same(n + 1, copy, given);
    }
}

/* rational.tmpl.h: weights changed in place.  With w_0 = 2^n w_n the standard form has a rational root. */
static void weights_in_place(void **state)
{
    (void)state;
    for (int n = 1; n <= MOST_N; n++) {
        fill(n + 1, given);
        num_q a = random_q(), b = neg_q(random_q());
        rational_reparametrize_q(n, given, a, b, apart);
        num_q *w = laid(n + 1, given);
        rational_reparametrize_q(n, w, a, b, w);
        same(n + 1, apart, w);
        given[0] = mul_q(from_int_q(1 << n), given[n]);
        rational_standard_form_q(n, given, apart);
        w = laid(n + 1, given);
        rational_standard_form_q(n, w, w);
        same(n + 1, apart, w);
    }
}

static void a_line_twice(void **state)
{
    (void)state;
    num_q l[3], again[3];
    fill(3, l);
    memcpy(again, l, sizeof l);
    line_pair_q(l, again, apart);
    line_pair_q(l, l, together);
    same(6, apart, together);
}

/* determinant.tmpl.h: a leading coefficient that is 0 takes the other polynomial's leading one out of the resultant:
 * res(0 x^m + a, b) = (-1)^n b_0 res(a, b), a of degree m - 1. */
static void leading_coefficients_that_are_zero(void **state)
{
    (void)state;
    for (int m = 1; m <= 3; m++)
        for (int n = 1; n <= 3; n++) {
            num_q a[4], b[4], M[36];
            fill(m + 1, a), fill(n + 1, b);
            a[0] = from_int_q(0);
            sylvester_q(m, a, n, b, M);
            num_q whole = determinant_q(m + n, M);
            sylvester_q(m - 1, a + 1, n, b, M);
            num_q rest = mul_q(b[0], determinant_q(m - 1 + n, M));
            assert_true(cagd_equal_q(whole, n % 2 == 0 ? rest : neg_q(rest)));
        }
}

/* span.tmpl.h: the knots of raised and of lowered degree are counted without a place for them.  span_type.tmpl.h: the basis functions
 * ask for no points, those of a B-spline for no weights. */
static void what_is_not_read(void **state)
{
    (void)state;
    static const int u[] = {0, 0, 0, 1, 2, 2, 3, 3, 3};
    num_q knots[9], v[20];
    enum { N = 6, P = 2 };
    for (int i = 0; i < 9; i++)
        knots[i] = from_int_q(u[i]);
    assert_int_equal(raised_knots_q(N, P, knots, NULL), raised_knots_q(N, P, knots, v));
    assert_int_equal(lowered_knots_q(N, P, knots, NULL), lowered_knots_q(N, P, knots, v));
    num_q points[N], weights[N], t = from_ratio_q(1, 2), sum = from_int_q(0), at, one = from_int_q(1);
    fill(N, points);
    for (int i = 0; i < N; i++)
        weights[i] = one;
    nurbs_basis_q(nurbs_on_span_q(P, 0, knots, 2, NULL, weights), t, 0, apart);
    bspline_derivatives_q(on_span_q(P, 1, knots, 2, points), t, 0, &at);
    for (int m = 0; m <= P; m++)
        sum = add_q(sum, mul_q(apart[m], points[m]));
    assert_true(cagd_equal_q(sum, at));
}

/* What stands behind an array, and is still there when something was written to the array. */
static void guard(num_q a[], int count) { a[count] = from_int_q(4711); }
static void is_guarded(const num_q a[], int count) { assert_true(cagd_equal_q(a[count], from_int_q(4711))); }

static void is_on(const struct spline_q *whole, const struct spline_q *part, num_q t)
{
    num_q x[MOST_D], y[MOST_D];
    int mu = find_span_q(part->count, part->degree, part->knots, t);
    assert_true(mu >= part->degree);
    bspline_deboor_q(span_of_curve_q(part, mu), t, x);
    bspline_deboor_q(span_of_curve_q(whole, find_span_q(whole->count, whole->degree, whole->knots, t)), t, y);
    same(whole->dim, x, y);
}

/* bspline.tmpl.h: a curve is split at a knot of every multiplicity 0 <= s <= p+1, and at the beginning of its domain, where there is
 * nothing on the left.  Nothing is written behind the parts. */
static void split_at_a_knot_of_every_multiplicity(void **state)
{
    (void)state;
    enum { P = 4, KNOTS = 3 * (P + 2), POINTS = KNOTS * MOST_D };
    num_q u[KNOTS], left_knots[KNOTS + 1], right_knots[KNOTS + 1], left[POINTS + 1], right[POINTS + 1];
    for (int p = 0; p <= P; p++)
        for (int s = 0; s <= p + 1; s++)
            for (int at_start = 0; at_start <= (s == p + 1); at_start++)
                for (int dim = 1; dim <= MOST_D; dim++) {
                    int before = at_start ? 0 : p + 2, count = before + s + p + 2, n = count - p - 1;
                    for (int i = 0; i < count; i++)
                        u[i] = from_int_q(i < before ? i - 50 : i < before + s ? 3 : i + 50);
                    num_q t = from_int_q(3);
                    int mu = before + s - 1, lefts = mu - s + 1, rights = n - mu + p;
                    fill(n * dim, given);
                    struct spline_q whole = {p, n, dim, u, given, NULL};
                    assert_int_equal(mu, find_span_q(n, p, u, t));
                    guard(left_knots, lefts + p + 1), guard(right_knots, rights + p + 1);
                    guard(left, lefts * dim), guard(right, rights * dim);
                    bspline_split_q(&whole, mu, s, t, left_knots, left, right_knots, right);
                    is_guarded(left_knots, lefts + p + 1), is_guarded(right_knots, rights + p + 1);
                    is_guarded(left, lefts * dim), is_guarded(right, rights * dim);
                    assert_int_equal(multiplicity_q(lefts + p + 1, left_knots, t), p + 1);
                    assert_int_equal(multiplicity_q(rights + p + 1, right_knots, t), p + 1);
                    struct spline_q below = {p, lefts, dim, left_knots, left, NULL},
                                    above = {p, rights, dim, right_knots, right, NULL};
                    is_on(&whole, &above, t);
                    for (int k = 1; k < 8; k++) {
                        num_q part = from_ratio_q(k, 8), low = at_start ? t : u[p], high = u[n];
                        is_on(&whole, &above, add_q(t, mul_q(part, sub_q(high, t))));
                        if (!at_start)
                            is_on(&whole, &below, add_q(low, mul_q(part, sub_q(t, low))));
                    }
                }
}

/* A knot that was inserted is taken out again, of every multiplicity that it has then and in every degree, 0 among them. */
static void a_knot_in_and_out(void **state)
{
    (void)state;
    enum { P = 4, KNOTS = 3 * (P + 2), POINTS = KNOTS * MOST_D };
    num_q u[KNOTS], v[KNOTS], back[KNOTS + 1], d[POINTS], c[POINTS + 1], defect[MOST_D + 1];
    for (int p = 0; p <= P; p++)
        for (int s = 1; s <= p + 1; s++)
            for (int dim = 1; dim <= MOST_D; dim++) {
                int count = 2 * (p + 2) + s - 1, n = count - p - 1;
                for (int i = 0; i < count; i++)
                    u[i] = from_int_q(i < p + 2 ? i - 50 : i < p + 1 + s ? 3 : i + 50);
                num_q t = from_int_q(3);
                fill(n * dim, given);
                bspline_insert_q(&(struct spline_q){p, n, dim, u, given, NULL}, p + s, t, v, d);
                guard(back, count), guard(c, n * dim), guard(defect, dim);
                struct spline_q longer = {p, n + 1, dim, v, d, NULL};
                bspline_remove_q(&longer, p + 1 + s, s, back, c, defect);
                is_guarded(back, count), is_guarded(c, n * dim), is_guarded(defect, dim);
                same(count, u, back);
                same(n * dim, given, c);
                for (int k = 0; k < dim; k++)
                    assert_true(cagd_is_zero_q(defect[k]));
                int moved = p + 1; /* a point on which the knot counts */
                d[moved * dim] = add_q(d[moved * dim], from_int_q(1));
                bspline_remove_q(&longer, p + 1 + s, s, back, c, defect);
                assert_false(cagd_is_zero_q(defect[0]));
            }
}

/* The knots and points of a periodic spline repeat, also where one period has as few as its degree. */
static void a_period_is_repeated(void **state)
{
    (void)state;
    for (int m = 1; m <= MOST_N; m++)
        for (int p = 0; p <= m; p++)
            for (int dim = 1; dim <= MOST_D; dim++) {
                num_q u[MOST_N + 1], v[3 * MOST_N + 2], d[2 * MOST_N * MOST_D + 1];
                for (int i = 0; i <= m; i++)
                    u[i] = from_int_q(i * i + 2 * i - 7);
                fill(m * dim, given);
                guard(v, m + 2 * p + 1), guard(d, (m + p) * dim);
                bspline_periodic_q(m, p, dim, u, given, v, d);
                is_guarded(v, m + 2 * p + 1), is_guarded(d, (m + p) * dim);
                same(m + 1, u, v + p);
                same(m * dim, given, d);
                for (int i = 0; i + m < m + 2 * p + 1; i++)
                    assert_true(cagd_equal_q(v[i + m], add_q(v[i], sub_q(u[m], u[0]))));
                same(p * dim, d, d + m * dim);
            }
}

int main(void)
{
    const struct CMUnitTest tests[] = {unit(points_of_a_curve),
                                       unit(polynomials),
                                       unit(weights_in_place),
                                       unit(a_line_twice),
                                       unit(what_is_not_read),
                                       unit(leading_coefficients_that_are_zero),
                                       unit(split_at_a_knot_of_every_multiplicity),
                                       unit(a_knot_in_and_out),
                                       unit(a_period_is_repeated)};
    return run_unit_tests(tests);
}
