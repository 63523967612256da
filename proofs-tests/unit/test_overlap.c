/* test_overlap.c -- what the contracts of kernels permit, tried in just that way: results that overlap what they are made of give what they
 * give apart; what is not read is NULL; leading coefficients are 0; degrees are 0, or different ones; orders are beyond the degree; knots and
 * nodes have every multiplicity. */
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

/* ---- every degree, order and multiplicity ---------------------------------------------------------------- */

static num_q zero(void) { return from_int_q(0); }
static num_q one(void) { return from_int_q(1); }
static num_q power(num_q x, int n)
{
    num_q r = one();
    for (int k = 0; k < n; k++)
        r = mul_q(r, x);
    return r;
}
static num_q choose(int n, int k)
{
    num_q r = k < 0 || k > n ? zero() : one();
    for (int i = 0; i < k && k <= n; i++)
        r = div_q(mul_q(r, from_int_q(n - i)), from_int_q(i + 1));
    return r;
}
/* n (n-1) ... (n-k+1) */
static num_q falling(int n, int k)
{
    num_q r = one();
    for (int i = 0; i < k; i++)
        r = mul_q(r, from_int_q(n - i));
    return r;
}
/* The k-th derivative of B_i^n at t, by Leibniz's rule. */
static num_q bernstein(int i, int n, num_q t, int k)
{
    num_q sum = zero(), s = sub_q(one(), t);
    for (int j = 0; j <= k; j++) /* j derivatives of t^i, k - j of (1-t)^(n-i) */
        if (j <= i && k - j <= n - i) {
            num_q term =
                mul_q(mul_q(falling(i, j), power(t, i - j)), mul_q(falling(n - i, k - j), power(s, n - i - k + j)));
            term = mul_q(choose(k, j), term);
            sum = (k - j) % 2 == 0 ? add_q(sum, term) : sub_q(sum, term);
        }
    return mul_q(choose(n, i), sum);
}

/* A product of degrees n and m, equal or not and 0 among them, has the product of the values. */
static void products_of_any_degrees(void **state)
{
    (void)state;
    for (int n = 0; n <= 5; n++)
        for (int m = 0; m <= 5; m++) {
            num_q a[6], b[6], c[11], t = from_ratio_q(-3, 7), x, y, z;
            fill(n + 1, a), fill(m + 1, b);
            bernstein_product_q(n, a, m, b, c);
            for (int k = 0; k <= n + m; k++, t = add_q(t, from_ratio_q(2, 9))) {
                bezier_casteljau_q(n, 1, a, t, &x), bezier_casteljau_q(m, 1, b, t, &y),
                    bezier_casteljau_q(n + m, 1, c, t, &z);
                assert_true(cagd_equal_q(mul_q(x, y), z));
            }
        }
}

/* Bases and curves of degree 0 to 4 with derivatives up to two more: sums over the basis by its definition. */
static void curves_of_every_degree(void **state)
{
    (void)state;
    enum { MOST = 4, ROWS = MOST + 3 };
    for (int n = 0; n <= MOST; n++)
        for (int dim = 1; dim <= MAX_DIM; dim++)
            for (int r = 0; r <= n + 2; r++) {
                region_mark mark = region_open();
                num_q t = from_ratio_q(5, 7), b[(MOST + 1) * MAX_DIM], B[ROWS * (MOST + 1)], D[ROWS * MAX_DIM],
                      c[(MOST + 1) * MAX_DIM], E[ROWS * MAX_DIM];
                fill((n + 1) * dim, b);
                bernstein_derivatives_q(n, t, r, B);
                bezier_derivatives_q(n, dim, b, t, r, D);
                for (int k = 0; k <= r; k++) {
                    for (int i = 0; i <= n; i++)
                        assert_true(cagd_equal_q(B[k * (n + 1) + i], bernstein(i, n, t, k)));
                    for (int m = 0; m < dim; m++) {
                        num_q sum = zero();
                        for (int i = 0; i <= n; i++)
                            sum = add_q(sum, mul_q(bernstein(i, n, t, k), b[i * dim + m]));
                        assert_true(cagd_equal_q(D[k * dim + m], sum));
                    }
                }
                bernstein_basis_q(n, t, B);
                for (int i = 0; i <= n; i++)
                    assert_true(cagd_equal_q(B[i], bernstein(i, n, t, 0)));
                bezier_horner_q(n, dim, b, t, E);
                same(dim, D, E);
                /* the same in powers, coordinate by coordinate */
                for (int m = 0; m < dim; m++) {
                    num_q one_of[MOST + 1], in_powers[MOST + 1];
                    for (int i = 0; i <= n; i++)
                        one_of[i] = b[i * dim + m];
                    bernstein_to_power_q(n, one_of, in_powers);
                    for (int i = 0; i <= n; i++)
                        c[i * dim + m] = in_powers[i];
                }
                power_derivatives_q(n, dim, c, t, r, E);
                same((r + 1) * dim, D, E);
                power_point_q(n, dim, c, t, E);
                same(dim, D, E);
                /* over a part of it, turned round */
                num_q u = from_ratio_q(9, 4), v = from_ratio_q(-1, 3), s = div_q(sub_q(t, u), sub_q(v, u)),
                      part[(MOST + 1) * MAX_DIM];
                bezier_on_interval_q(n, dim, b, u, v, part);
                bezier_casteljau_q(n, dim, part, s, E);
                same(dim, D, E);
                power_on_interval_q(n, dim, c, u, v, part);
                power_point_q(n, dim, part, s, E);
                same(dim, D, E);
                region_drop(mark);
            }
}

/* w R = P: by Leibniz's rule for derivatives of every order up to 9, of Bézier and of NURBS curves, which here are one. */
static void derivatives_of_quotients(void **state)
{
    (void)state;
    enum { MOST = 4, ORDER = 9 };
    for (int n = 0; n <= MOST; n++)
        for (int dim = 1; dim < MAX_DIM; dim++) {
            region_mark mark = region_open();
            num_q R[(MOST + 1) * MAX_DIM], w[MOST + 1], H[(MOST + 1) * MAX_DIM], D[(ORDER + 1) * MAX_DIM],
                Q[(ORDER + 1) * MAX_DIM], N[(ORDER + 1) * MAX_DIM];
            num_q t = from_ratio_q(3, 8), u[2 * MOST + 2], basis[(ORDER + 1) * (MOST + 1)],
                  by[(ORDER + 1) * (MOST + 1) * MAX_DIM], twice[(MOST + 1) * (MOST + 1) * MAX_DIM],
                  once[(MOST + 1) * (MOST + 1)];
            fill((n + 1) * dim, R), fill(n + 1, w);
            rational_homogenize_q(n, dim, R, w, H);
            bezier_derivatives_q(n, dim + 1, H, t, ORDER, D);
            rational_derivatives_q(n, dim, R, w, t, ORDER, Q);
            for (int k = 0; k <= ORDER; k++)
                for (int c = 0; c < dim; c++) {
                    num_q sum = zero();
                    for (int j = 0; j <= k; j++)
                        sum = add_q(sum, mul_q(choose(k, j), mul_q(D[j * (dim + 1) + dim], Q[(k - j) * dim + c])));
                    assert_true(cagd_equal_q(sum, D[k * (dim + 1) + c]));
                }
            for (int i = 0; i < 2 * n + 2; i++)
                u[i] = from_int_q(i > n);
            struct curve_span_q s = nurbs_on_span_q(n, dim, u, n, R, w);
            nurbs_derivatives_q(s, t, ORDER, N);
            same((ORDER + 1) * dim, Q, N);
            nurbs_point_q(s, t, N);
            same(dim, Q, N);
            nurbs_deboor_q(s, t, N);
            same(dim, Q, N);
            rational_point_q(n, dim, R, w, t, N);
            same(dim, Q, N);
            assert_true(cagd_equal_q(nurbs_weight_q(s, t), D[dim]) && cagd_equal_q(rational_weight_q(n, w, t), D[dim]));
            /* R_m is the curve of the points 0, ..., 1, ..., 0; dR/dlambda_m = R_m (P_m - R), and what that is after derivatives by t */
            nurbs_basis_q(s, t, ORDER, basis);
            nurbs_by_weights_q(s, t, ORDER, by);
            nurbs_basis_by_weights_q(s, t, once);
            nurbs_by_two_weights_q(s, t, twice);
            for (int m = 0; m <= n; m++) {
                num_q unit_points[MOST + 1], of_one[ORDER + 1];
                for (int i = 0; i <= n; i++)
                    unit_points[i] = from_int_q(i == m);
                rational_derivatives_q(n, 1, unit_points, w, t, ORDER, of_one);
                for (int k = 0; k <= ORDER; k++) {
                    assert_true(cagd_equal_q(basis[k * (n + 1) + m], of_one[k]));
                    for (int c = 0; c < dim; c++) {
                        num_q sum = mul_q(of_one[k], R[m * dim + c]);
                        for (int j = 0; j <= k; j++)
                            sum = sub_q(sum, mul_q(choose(k, j), mul_q(basis[(k - j) * (n + 1) + m], Q[j * dim + c])));
                        assert_true(cagd_equal_q(by[(k * (n + 1) + m) * dim + c], sum));
                    }
                }
                for (int l = 0; l <= n; l++) {
                    num_q of_both = sub_q(from_int_q(l == m), basis[l]);
                    assert_true(cagd_equal_q(once[m * (n + 1) + l], mul_q(basis[m], of_both)));
                    for (int c = 0; c < dim; c++) { /* the derivative of R_m (P_m - R) by lambda_l */
                        num_q sum = mul_q(once[m * (n + 1) + l], sub_q(R[m * dim + c], Q[c]));
                        sum = sub_q(sum, mul_q(basis[m], by[l * dim + c]));
                        assert_true(cagd_equal_q(twice[(m * (n + 1) + l) * dim + c], sum));
                    }
                }
            }
            /* split, elevated, in another parameter: the same values */
            num_q L[(MOST + 2) * MAX_DIM], l[MOST + 2], Rr[(MOST + 2) * MAX_DIM], r[MOST + 2], at = from_ratio_q(2, 3);
            rational_split_q(n, dim, R, w, at, L, l, Rr, r);
            rational_point_q(n, dim, L, l, div_q(t, at), N);
            same(dim, Q, N);
            rational_point_q(n, dim, Rr, r, div_q(sub_q(t, at), sub_q(one(), at)), N);
            same(dim, Q, N);
            rational_elevate_q(n, dim, R, w, L, l);
            rational_point_q(n + 1, dim, L, l, t, N);
            same(dim, Q, N);
            num_q a = from_ratio_q(-7, 3), b = from_ratio_q(5, 4),
                  v = div_q(mul_q(b, t), add_q(mul_q(b, t), mul_q(a, sub_q(one(), t))));
            rational_reparametrize_q(n, w, a, b, l);
            rational_point_q(n, dim, R, l, v, N);
            same(dim, Q, N);
            region_drop(mark);
        }
}

/* Nets of n+1 times m+1 points, n and m from 0 to 3, with derivatives of orders 0 to r and s by their definition. */
static void surfaces_of_any_degrees(void **state)
{
    (void)state;
    enum { MOST = 3, ORDER = 4 };
    for (int n = 0; n <= MOST; n++)
        for (int m = 0; m <= MOST; m++)
            for (int dim = 1; dim <= MAX_DIM; dim++) {
                region_mark mark = region_open();
                int count = (n + 1) * (m + 1) * dim;
                num_q P[16 * MAX_DIM], Q[16 * MAX_DIM], out[(ORDER + 1) * (ORDER + 1) * MAX_DIM],
                    u = from_ratio_q(2, 5), w = from_ratio_q(-3, 4), x[MAX_DIM];
                fill(count, P);
                const struct net_q net = {n, m, dim, P};
                for (int r = 0; r <= ORDER; r++)
                    for (int s = 0; s <= ORDER; s += r == 0 || r == ORDER || r == 2 ? 1 : 3) {
                        bezier_surface_derivatives_q(net, u, w, r, s, out);
                        for (int k = 0; k <= r; k++)
                            for (int l = 0; l <= s; l++)
                                for (int c = 0; c < dim && (k == r || l == s); c++) {
                                    num_q sum = zero();
                                    for (int i = 0; i <= n; i++)
                                        for (int j = 0; j <= m; j++)
                                            sum = add_q(sum, mul_q(mul_q(bernstein(i, n, u, k), bernstein(j, m, w, l)),
                                                                   P[(i * (m + 1) + j) * dim + c]));
                                    assert_true(cagd_equal_q(out[(k * (s + 1) + l) * dim + c], sum));
                                }
                    }
                bezier_surface_point_q(net, u, w, x);
                bezier_surface_derivatives_q(net, u, w, 0, 0, out);
                same(dim, x, out);
                bezier_surface_transpose_q(net, Q);
                bezier_surface_point_q((struct net_q){m, n, dim, Q}, w, u, x);
                same(dim, x, out);
                bezier_surface_line_q(net, u, Q);
                bezier_casteljau_q(m, dim, Q, w, x);
                same(dim, x, out);
                const num_q ends[4] = {from_ratio_q(9, 4), from_ratio_q(-1, 3), from_ratio_q(1, 7), from_int_q(2)};
                bezier_surface_part_q(net, ends[0], ends[1], ends[2], ends[3], Q);
                bezier_surface_point_q((struct net_q){n, m, dim, Q}, div_q(sub_q(u, ends[0]), sub_q(ends[1], ends[0])),
                                       div_q(sub_q(w, ends[2]), sub_q(ends[3], ends[2])), x);
                same(dim, x, out);
                region_drop(mark);
            }
}

/* Polynomials of degree 3 are what the four cubics make of their values and slopes, over [a, b] and turned round, with derivatives up to
 * order 5; of degree n, what Lagrange's make of n+1 values, n from 0 on. */
static void interpolation_of_polynomials(void **state)
{
    (void)state;
    const num_q ends[][2] = {
        {from_ratio_q(1, 3), from_ratio_q(9, 4)}, {from_ratio_q(5, 2), from_int_q(-1)}, {zero(), one()}};
    const num_q t = from_ratio_q(7, 5);
    for (int e = 0; e < 3; e++)
        for (int r = 0; r <= 5; r++) {
            num_q B[4 * 6], out[6 * 4], data[4 * 4];
            hermite_blending_q(ends[e][0], ends[e][1], t, r, B);
            for (int q = 0; q <= 3; q++)
                for (int i = 0; i < 4; i++)
                    data[i * 4 + q] = i < 2    ? power(ends[e][i], q)
                                      : q == 0 ? zero()
                                               : mul_q(from_int_q(q), power(ends[e][i - 2], q - 1));
            hermite_cubic_q(4, ends[e][0], ends[e][1], data, t, r, out);
            for (int k = 0; k <= r; k++)
                for (int q = 0; q <= 3; q++) {
                    num_q expected = k > q ? zero() : mul_q(falling(q, k), power(t, q - k)), sum = zero();
                    for (int i = 0; i < 4; i++)
                        sum = add_q(sum, mul_q(B[4 * k + i], data[i * 4 + q]));
                    assert_true(cagd_equal_q(sum, expected) && cagd_equal_q(out[k * 4 + q], expected));
                }
        }
    for (int n = 0; n <= 6; n++) {
        num_q tau[7], g[7];
        for (int i = 0; i <= n; i++)
            tau[i] = from_ratio_q(7 * i - 3, i + 2);
        lagrange_blending_q(n, tau, t, g);
        for (int q = 0; q <= n; q++) {
            num_q sum = zero();
            for (int i = 0; i <= n; i++)
                sum = add_q(sum, mul_q(g[i], power(tau[i], q)));
            assert_true(cagd_equal_q(sum, power(t, q)));
        }
    }
    /* f(u) g(w) for f, g = powers 0 to 3 has M_ij = f_i g_j: values at 0 and 1, then slopes */
    for (int code = 0; code < 256; code++) {
        int f = code % 4, g = code / 4 % 4, r = code / 16 % 4, s = code / 64, dim = 1 + code % 3;
        num_q M[16 * 3], out[3], u = from_ratio_q(2, 7), w = from_ratio_q(5, 3);
        const int at[4][4] = {{1, 1, 0, 0}, {0, 1, 1, 1}, {0, 1, 0, 2}, {0, 1, 0, 3}};
        for (int i = 0; i < 4; i++)
            for (int j = 0; j < 4; j++)
                for (int c = 0; c < dim; c++)
                    M[(4 * i + j) * dim + c] = from_int_q((c + 2) * at[f][i] * at[g][j]);
        hermite_tensor_q(dim, M, u, w, r, s, out);
        num_q left = r > f ? zero() : mul_q(falling(f, r), power(u, f - r)),
              right = s > g ? zero() : mul_q(falling(g, s), power(w, g - s));
        for (int c = 0; c < dim; c++)
            assert_true(cagd_equal_q(out[c], mul_q(from_int_q(c + 2), mul_q(left, right))));
        if (r > 0 || s > 0) /* Coons's patch of the same frame, as a value alone */
            continue;
        num_q a[4 * 2], A[4 * 3], B[4 * 3];
        hermite_blending_q(zero(), one(), u, 0, a), hermite_blending_q(zero(), one(), w, 0, a + 4);
        for (int i = 0; i < 4; i++)
            for (int c = 0; c < dim; c++) {
                A[i * dim + c] = mul_q(from_int_q((c + 2) * at[f][i]), right);
                B[i * dim + c] = mul_q(from_int_q((c + 2) * at[g][i]), left);
            }
        coons_patch_q(4, dim, a, a + 4, A, B, M, out);
        for (int c = 0; c < dim; c++)
            assert_true(cagd_equal_q(out[c], mul_q(from_int_q(c + 2), mul_q(left, right))));
    }
}

/* Three nodes of every multiplicity 1 to 4: the differences of powers, the weights, the matrix and its determinant, the interpolant. */
static void nodes_of_every_multiplicity(void **state)
{
    (void)state;
    enum { MOST = 12 };
    const num_q tau[3] = {from_ratio_q(1, 2), from_ratio_q(-2, 3), from_ratio_q(5, 4)};
    for (int code = 0; code < 4 + 16 + 64; code++) {
        region_mark mark = region_open();
        int d = code < 4    ? 1
                : code < 20 ? 2
                            : 3,
            rest = code < 4    ? code
                   : code < 20 ? code - 4
                               : code - 20,
            l[3], count = 0;
        for (int i = 0; i < d; i++, rest /= 4)
            count += l[i] = 1 + rest % 4;
        num_q symmetric[3] = {one(), zero(), zero()}; /* complete symmetric functions of the nodes: 1, h_1, h_2 */
        for (int i = 0; i < d; i++)
            for (int j = 0; j < l[i]; j++)
                for (int k = 1; k < 3; k++)
                    symmetric[k] = add_q(symmetric[k], mul_q(tau[i], symmetric[k - 1]));
        num_q f[MOST], alpha[MOST], H[MOST * MOST], c[MOST];
        divided_weights_q(d, l, tau, alpha);
        confluent_vandermonde_q(d, l, tau, H);
        assert_true(cagd_equal_q(confluent_vandermonde_determinant_q(d, l, tau), determinant_q(count, H)));
        for (int q = 0; q < count + 2; q++) { /* f = t^q */
            num_q sum = zero();
            for (int i = 0, at = 0; i < d; i++)
                for (int j = 0; j < l[i]; j++, at++) {
                    f[at] = j > q ? zero() : mul_q(falling(q, j), power(tau[i], q - j));
                    sum = add_q(sum, mul_q(alpha[at], f[at]));
                    if (q < count)
                        assert_true(cagd_equal_q(H[at * count + q], f[at]));
                }
            num_q expected = q < count - 1 ? zero() : symmetric[q - count + 1];
            assert_true(cagd_equal_q(sum, expected) && cagd_equal_q(divided_difference_q(d, l, tau, f), expected));
            hermite_interpolant_q(d, l, tau, f, c);
            for (int k = 0; k < count && q < count; k++)
                assert_true(cagd_equal_q(c[k], from_int_q(k == q)));
        }
        region_drop(mark);
    }
}

/* Resultants of degrees 0 to 4 and 0 to 4 from the roots, a_0^n b_0^m prod (alpha_i - beta_j); Bézout's for equal degrees up to 6. */
static void resultants_of_any_degrees(void **state)
{
    (void)state;
    enum { MOST = 6 };
    for (int m = 0; m <= MOST; m++)
        for (int n = 0; n <= MOST; n++) {
            if (m + n == 0 || (m != n && m + n > 8))
                continue;
            region_mark mark = region_open();
            num_q a[MOST + 1] = {from_ratio_q(-3, 2)}, b[MOST + 1] = {from_ratio_q(5, 3)}, alpha[MOST], beta[MOST],
                           expected = mul_q(power(a[0], n), power(b[0], m));
            for (int i = 0; i < m; i++) {
                alpha[i] = from_ratio_q(i * i - 3, i + 2), a[i + 1] = zero();
                for (int k = i + 1; k > 0; k--)
                    a[k] = sub_q(a[k], mul_q(alpha[i], a[k - 1]));
            }
            for (int j = 0; j < n; j++) {
                beta[j] = from_ratio_q(2 * j + 1, 3 * j + 1), b[j + 1] = zero();
                for (int k = j + 1; k > 0; k--)
                    b[k] = sub_q(b[k], mul_q(beta[j], b[k - 1]));
                for (int i = 0; i < m; i++)
                    expected = mul_q(expected, sub_q(alpha[i], beta[j]));
            }
            assert_true(cagd_equal_q(resultant_q(m, a, n, b), expected));
            if (m == n)
                assert_true(cagd_equal_q(bezout_resultant_q(n, a, b), expected));
            region_drop(mark);
        }
}

/* (x - t)^p = sum omega_i(x) N_i(t) with omega_i(x) = (x - u_{i+1}) ... (x - u_{i+p}), over knots of every multiplicity, clamped or not, in degrees
 * 0 to 4: what the kernels make of these points is what the same formula says. */
static num_q omega(int p, const num_q u[], int i, num_q x)
{
    num_q r = one();
    for (int k = 1; k <= p; k++)
        r = mul_q(r, sub_q(x, u[i + k]));
    return r;
}
static void marsdens_identity(void **state)
{
    (void)state;
    enum { MOST = 4, KNOTS = 24, TRIED = 60, DIM = 3 };
    const num_q x[MOST + 2] = {from_ratio_q(-4, 3), from_ratio_q(1, 2), from_ratio_q(9, 2),
                               from_ratio_q(23, 3), from_int_q(-7),     from_ratio_q(31, 2)};
    for (int trial = 0; trial < TRIED; trial++) {
        region_mark mark = region_open();
        int p = trial % (MOST + 1), n = p + 1 + random_int(0, 5), group[KNOTS], dim = 1 + trial / 5 % DIM,
            most =
                p + 1 > dim ? p + 1 : dim; /* as many x as tell the p+1 functions apart, and one for each coordinate */
        num_q u[KNOTS];
        for (int i = 0, run = 1; i <= n + p; i++) {
            int next = i == 0 || run == p + 1 || random_int(0, 2) == 0 || (i == n && group[n - 1] == group[p]);
            group[i] = i == 0 ? 0 : group[i - 1] + next;
            u[i] = i == 0 ? from_ratio_q(-5, 2) : next ? add_q(u[i - 1], from_ratio_q(random_int(1, 9), 4)) : u[i - 1];
            run = next ? 1 : run + 1;
        }
        num_q c[KNOTS * DIM];
        for (int i = 0; i < n; i++)
            for (int k = 0; k < dim; k++)
                c[i * dim + k] = omega(p, u, i, x[k]);
        const struct spline_q s = {p, n, dim, u, c, NULL};
        for (int mu = p; mu < n; mu++) {
            if (group[mu] == group[mu + 1])
                continue;
            num_q N[(MOST + 3) * (MOST + 1)], out[(MOST + 3) * DIM], b[(MOST + 1) * DIM], y[MOST + 1], A[25], again[25];
            for (int place = -1; place <= 5;
                 place++) { /* from before the span, over both ends and its inside, to behind it */
                num_q t = add_q(u[mu], mul_q(from_ratio_q(place, 4), sub_q(u[mu + 1], u[mu])));
                bspline_basis_derivatives_q(p, u, mu, t, p + 2, N);
                bspline_derivatives_q(span_of_curve_q(&s, mu), t, p + 2, out);
                for (int k = 0; k <= p + 2; k++)
                    for (int m = 0; m < most; m++) {
                        num_q sum = zero(), value = k > p ? zero() : mul_q(falling(p, k), power(sub_q(x[m], t), p - k));
                        value = k % 2 == 0 ? value : neg_q(value);
                        for (int i = 0; i <= p; i++)
                            sum = add_q(sum, mul_q(N[k * (p + 1) + i], omega(p, u, mu - p + i, x[m])));
                        assert_true(cagd_equal_q(sum, value));
                        if (m < dim)
                            assert_true(cagd_equal_q(out[k * dim + m], value));
                    }
                bspline_basis_q(p, u, mu, t, again);
                same(p + 1, N, again);
                bspline_deboor_q(span_of_curve_q(&s, mu), t, b);
                same(dim, out, b);
                /* the matrix in powers of the local parameter */
                bspline_matrix_q(p, u, mu, A);
                for (int i = 0; i <= p; i++) {
                    num_q sum = zero();
                    for (int j = p; j >= 0; j--)
                        sum = add_q(mul_q(sum, from_ratio_q(place, 4)), A[j * (p + 1) + i]);
                    assert_true(cagd_equal_q(sum, N[i]));
                }
            }
            bspline_matrix_by_differences_q(p, u, group, mu, again);
            same((p + 1) * (p + 1), A, again);
            bspline_matrix_by_marsden_q(p, u, mu, again);
            same((p + 1) * (p + 1), A, again);
            int simple = 1; /* the knots to the right of the span, whatever those to the left */
            for (int i = mu + 1; i < mu + p + 1; i++)
                simple &= group[i] != group[i + 1];
            if (simple) {
                bspline_matrix_simple_q(p, u, mu, again);
                same((p + 1) * (p + 1), A, again);
            }
            marsden_matrix_q(p, u, mu, again);
            assert_true(cagd_equal_q(marsden_determinant_q(p, u, mu), determinant_q(p + 1, again)));
            for (int i = 0; i < p; i++)
                y[i] = from_ratio_q(3 * i - 4, i + 2);
            bspline_discrete_q(p, u, mu, y, N);
            bspline_blossom_q(span_of_curve_q(&s, mu), y, out);
            bspline_to_bezier_q(span_of_curve_q(&s, mu), b);
            for (int m = 0; m < dim; m++) {
                num_q product = one(), sum = zero();
                for (int i = 0; i < p; i++)
                    product = mul_q(product, sub_q(x[m], y[i]));
                for (int i = 0; i <= p; i++) {
                    sum = add_q(sum, mul_q(N[i], c[(mu - p + i) * dim + m]));
                    num_q bezier = mul_q(power(sub_q(x[m], u[mu]), p - i), power(sub_q(x[m], u[mu + 1]), i));
                    assert_true(cagd_equal_q(b[i * dim + m], bezier));
                }
                assert_true(cagd_equal_q(out[m], product) && cagd_equal_q(sum, product));
            }
            num_q back[DIM];
            bspline_point_of_bezier_q(p, dim, b, u[mu], u[mu + 1], y, back);
            same(dim, out, back);
            num_q W[MOST + 1];
            marsden_coefficients_q(p, u, mu, x[4], W);
            for (int i = 0; i <= p; i++)
                assert_true(cagd_equal_q(W[i], omega(p, u, mu - p + i, x[4])));
        }
        int inner = 0; /* an inner knot p+1 times, at which the curve may jump */
        for (int i = 1; i + p < n + p; i++)
            inner |= group[i] == group[i + p];
        if (p > 0 && !inner) { /* -p (x - t)^{p-1} over the same knots without the first and the last */
            num_q e[KNOTS * DIM];
            bspline_difference_q(n, p, dim, u, c, e);
            for (int i = 0; i < n - 1; i++)
                for (int m = 0; m < dim; m++)
                    assert_true(cagd_equal_q(e[i * dim + m], mul_q(from_int_q(-p), omega(p - 1, u + 1, i, x[m]))));
        }
        for (int i = 0; i < n && p > 0; i++) { /* t itself: the mean of p knots */
            num_q sum = zero();
            for (int k = 1; k <= p; k++)
                sum = add_q(sum, u[i + k]);
            assert_true(cagd_equal_q(mul_q(from_int_q(p), bspline_greville_q(p, u, i)), sum));
        }
        /* in degree p+1 (x - t)^p is the mean of p+1 products that leave one knot out; back in degree p it is what it was */
        num_q v[3 * KNOTS], d[2 * KNOTS * DIM], lower[KNOTS], reduced[KNOTS * DIM];
        int span[2 * KNOTS], m = raised_knots_q(n, p, u, v);
        assert_true(spans_of_points_q(n, p, u, m, p + 1, v, span));
        bspline_elevate_q(&s, m, v, span, d);
        for (int j = 0; j < m; j++)
            for (int k = 0; k < dim; k++) {
                num_q sum = zero();
                for (int out = 1; out <= p + 1; out++) {
                    num_q product = one();
                    for (int i = 1; i <= p + 1; i++)
                        product = i == out ? product : mul_q(product, sub_q(x[k], v[j + i]));
                    sum = add_q(sum, product);
                }
                assert_true(cagd_equal_q(mul_q(from_int_q(p + 1), d[j * dim + k]), sum));
            }
        int count = lowered_knots_q(m, p + 1, v, lower);
        assert_true(spans_of_points_q(m, p + 1, v, count, p, lower, span));
        bspline_reduce_q(&(struct spline_q){p + 1, m, dim, v, d, NULL}, count, lower, span, reduced);
        for (int j = 0; j < count; j++)
            for (int k = 0; k < dim; k++)
                assert_true(cagd_equal_q(reduced[j * dim + k], omega(p, lower, j, x[k])));
        /* over a refinement in which some knots of the domain have more copies, and there are others between */
        int times = 0, more = 0;
        for (int i = 0; i <= n + p; i++) {
            v[more++] = u[i];
            times = i > 0 && group[i] == group[i - 1] ? times + 1 : 1;
            if (group[p] <= group[i] && i < n + p && group[i] < group[i + 1] && group[i + 1] <= group[n]) {
                if (times <= p && i % 2 == 0)
                    v[more++] = u[i];
                v[more++] = mul_q(from_ratio_q(1, 3), add_q(u[i], add_q(u[i + 1], u[i + 1])));
            }
        }
        int finer = more - p - 1, has_all = spans_of_points_q(n, p, u, finer, p, v, span);
        for (int j = 0; j < finer; j++) {
            if (!has_all && span[j] < 0)
                continue; /* beside the domain */
            num_q point[DIM];
            const struct spline_q at = s;
            bspline_refine_q(&at, 1, v + j, span + j, point);
            for (int k = 0; k < dim; k++)
                assert_true(cagd_equal_q(point[k], omega(p, v, j, x[k])));
        }
        if (has_all) {
            bspline_refine_q(&s, finer, v, span, d);
            for (int j = 0; j < finer; j++)
                for (int k = 0; k < dim; k++)
                    assert_true(cagd_equal_q(d[j * dim + k], omega(p, v, j, x[k])));
        }
        region_drop(mark);
    }
}

/* S(x, y) = l_1(x, y) l_2(x, y) of two lines, and what stands on it; Gram's determinant in every dimension; surfaces with two shape parameters and unequal degrees. */
static void what_stands_on_other_kernels(void **state)
{
    (void)state;
    for (int trial = 0; trial < 20; trial++) {
        region_mark mark = region_open();
        num_q l[9], S[6], x = random_q(), y = random_q(), v[3], lambda = random_q(), a[4], b[4], g[2];
        fill(9, l), fill(4, a), fill(4, b);
        for (int k = 0; k < 3; k++)
            v[k] = add_q(add_q(mul_q(l[3 * k], x), mul_q(l[3 * k + 1], y)), l[3 * k + 2]);
        line_pair_q(l, l + 3, S);
        assert_true(cagd_equal_q(conic_value_q(S, x, y), mul_q(v[0], v[1])));
        conic_gradient_q(S, x, y, g);
        for (int k = 0; k < 2; k++)
            assert_true(cagd_equal_q(g[k], add_q(mul_q(v[0], l[3 + k]), mul_q(v[1], l[k]))));
        assert_true(cagd_is_zero_q(conic_determinant_q(S)));
        conic_liming_q(lambda, l, l + 3, l + 6, S);
        num_q expected = add_q(mul_q(sub_q(one(), lambda), mul_q(v[0], v[1])), mul_q(lambda, mul_q(v[2], v[2])));
        assert_true(cagd_equal_q(conic_value_q(S, x, y), expected));
        for (int dim = 1; dim <= MAX_DIM; dim++) {
            num_q aa = zero(), ab = zero(), bb = zero();
            for (int c = 0; c < dim; c++)
                aa = add_q(aa, mul_q(a[c], a[c])), ab = add_q(ab, mul_q(a[c], b[c])), bb = add_q(bb, mul_q(b[c], b[c]));
            assert_true(cagd_equal_q(gram_q(dim, a, b), sub_q(mul_q(aa, bb), mul_q(ab, ab))));
            if (dim > 1)
                assert_true(cagd_equal_q(curvature_squared_q(dim, a, b),
                                         div_q(sub_q(mul_q(aa, bb), mul_q(ab, ab)), power(aa, 3))));
        }
        int n = 2 + trial % 3, m = 2 + trial / 3 % 4, dim = 1 + trial % MAX_DIM;
        num_q P[5 * 6 * MAX_DIM], beta = random_q(), gamma = random_q(), u = from_ratio_q(2, 7),
                                  w = from_ratio_q(-3, 5), B[6], C[6], near[6], far[6], out[MAX_DIM], Q[7 * MAX_DIM];
        fill((n + 1) * (m + 1) * dim, P);
        shape_basis_q(n, beta, u, B), shape_basis_q(m, gamma, w, C);
        shape_factors_q(m, gamma, near, far);
        for (int j = 0; j <= m; j++) { /* the basis by its definition */
            num_q factor = add_q(mul_q(near[j], sub_q(one(), w)), mul_q(far[j], w));
            assert_true(cagd_equal_q(C[j], mul_q(factor, mul_q(power(sub_q(one(), w), m - j), power(w, j)))));
            num_q own = sub_q(choose(m - 2, j - 1), j >= 2 ? choose(m - 2, j - 2) : zero());
            assert_true(cagd_equal_q(near[j], add_q(choose(m, j), mul_q(gamma, own))));
            assert_true(cagd_equal_q(far[j], near[m - j]));
        }
        shape_surface_point_q(n, m, dim, P, beta, gamma, u, w, out);
        for (int c = 0; c < dim; c++) {
            num_q sum = zero();
            for (int i = 0; i <= n; i++)
                for (int j = 0; j <= m; j++)
                    sum = add_q(sum, mul_q(mul_q(B[i], C[j]), P[(i * (m + 1) + j) * dim + c]));
            assert_true(cagd_equal_q(out[c], sum));
        }
        num_q row[MAX_DIM]; /* a row of the net as a curve, and its Bézier points in degree m+1 */
        shape_point_q(m, dim, P, gamma, w, out);
        shape_bezier_points_q(m, dim, P, gamma, Q);
        bezier_casteljau_q(m + 1, dim, Q, w, row);
        same(dim, out, row);
        for (int c = 0; c < dim; c++) {
            num_q sum = zero();
            for (int j = 0; j <= m; j++)
                sum = add_q(sum, mul_q(C[j], P[j * dim + c]));
            assert_true(cagd_equal_q(out[c], sum));
        }
        region_drop(mark);
    }
}

/* The span of t among knots of every multiplicity, at both ends too: of those that are not empty the last that begins at or before t, from the left the
 * first that ends at or behind it. */
static void spans_by_their_definition(void **state)
{
    (void)state;
    enum { KNOTS = 16 };
    for (int trial = 0; trial < 200; trial++) {
        int p = trial % 4, n = p + 1 + random_int(0, 6), where, group[KNOTS];
        num_q u[KNOTS];
        for (int i = 0, run = 1; i <= n + p; i++) {
            int next = i == 0 || run == p + 1 || random_int(0, 2) == 0 || (i == n && group[n - 1] == group[p]);
            group[i] = i == 0 ? 0 : group[i - 1] + next;
            u[i] = from_ratio_q(2 * group[i], 3);
            run = next ? 1 : run + 1;
        }
        assert_int_equal(check_knots_q(n, p, u, &where), CAGD_OK);
        for (int twice = -1; twice <= 2 * group[n + p] + 1; twice++) { /* at the knots and between */
            num_q t = from_ratio_q(twice, 3);
            int right = -1, left = -1, times = 0;
            for (int mu = p; mu < n; mu++)
                if (group[mu] < group[mu + 1]) {
                    right = 2 * group[mu] <= twice ? mu : right;
                    left = left < 0 && twice <= 2 * group[mu + 1] ? mu : left;
                }
            for (int i = 0; i <= n + p; i++)
                times += 2 * group[i] == twice;
            int inside = 2 * group[p] <= twice && twice <= 2 * group[n];
            assert_int_equal(find_span_q(n, p, u, t), inside ? right : -1);
            assert_int_equal(find_span_left_q(n, p, u, t), inside ? left : -1);
            assert_int_equal(multiplicity_q(n + p + 1, u, t), times);
        }
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
                                       unit(a_period_is_repeated),
                                       unit(products_of_any_degrees),
                                       unit(curves_of_every_degree),
                                       unit(derivatives_of_quotients),
                                       unit(surfaces_of_any_degrees),
                                       unit(interpolation_of_polynomials),
                                       unit(nodes_of_every_multiplicity),
                                       unit(resultants_of_any_degrees),
                                       unit(marsdens_identity),
                                       unit(what_stands_on_other_kernels),
                                       unit(spans_by_their_definition)};
    return run_unit_tests(tests);
}
