/* test_cylinders.c -- algebraic points whose coordinates are known otherwise; implications that are true by construction, that are false at a point that was
 * planted, and random ones against a grid of points. */
#include "unit_exact.h"

#include "exact/decide/cylinders.h"
#include "exact/words.h"

#include "core/clock.h"

#include <math.h>

enum { SURE = 1000, TRIALS = 400 }; /* SURE: seconds that no test takes */

static num_f X, Y, Z;
static void open_field(void)
{
    field_open(8);
    X = variable_f("x"), Y = variable_f("y"), Z = variable_f("z");
}
static num_f whole(long m) { return from_int_f(m); }
static num_f square(num_f a) { return mul_f(a, a); }

/* The greatest root of p over the point, as a further coordinate. */
static cagd_algebraic_point with_greatest_root(cagd_algebraic_point a, num_f p)
{
    cagd_root_over_k root[16];
    num_f x[] = {X, Y, Z};
    cagd_over_k over = cagd_algebraic_polynomial(&a, p, x);
    int count = cagd_roots_over_k(&a, 1, &over, 16, root);
    assert_true(count > 0);
    return cagd_algebraic_with_root(&a, &root[count - 1], X);
}

static void roots_over_roots_are_the_numbers_they_are(void **state)
{
    (void)state;
    open_field();
    num_f x[] = {X, Y, Z};
    /* x = sqrt 2, y = sqrt(1 + x), z = x + y + 1. */
    cagd_algebraic_point a = with_greatest_root(cagd_algebraic_origin(), sub_f(square(X), whole(2)));
    a = with_greatest_root(a, sub_f(square(Y), add_f(whole(1), X)));
    a = with_greatest_root(a, sub_f(Z, add_f(add_f(X, Y), whole(1))));
    assert_int_equal(cagd_poly_degree(a.theta.factor), 4);
    assert_int_equal(cagd_algebraic_sign(&a, cagd_algebraic_value(&a, sub_f(square(X), whole(2)), x)), 0);
    num_f zero = sub_f(square(sub_f(sub_f(Z, X), whole(1))), add_f(X, whole(1)));
    assert_int_equal(cagd_algebraic_sign(&a, cagd_algebraic_value(&a, zero, x)), 0);
    double value[] = {sqrt(2), sqrt(1 + sqrt(2)), sqrt(2) + sqrt(1 + sqrt(2)) + 1};
    for (int k = 0; k < 3; k++) {
        struct cagd_root r = cagd_refine_root(cagd_algebraic_coordinate(&a, k), from_ratio_q(1, 1000000000));
        assert_true(fabs(cagd_to_double_q(r.lo) - value[k]) < 1e-8); /* the root is between lo and lo + 1e-9 */
        num_f above = sub_f(x[k], from_rational_f(sub_q(r.lo, from_ratio_q(1, 1000)))),
              below = sub_f(x[k], from_rational_f(add_q(r.hi, from_ratio_q(1, 1000))));
        assert_int_equal(cagd_algebraic_sign(&a, cagd_algebraic_value(&a, above, x)), 1);
        assert_int_equal(cagd_algebraic_sign(&a, cagd_algebraic_value(&a, below, x)), -1);
    }
    /* Over x^3 = 9 the greatest root of y^2 + xy + 1, which is negative: at y = 0 this has another degree in x than elsewhere. */
    cagd_algebraic_point c = cagd_algebraic_origin();
    assert_int_equal(c.theta.multiplicity, 1);
    c = with_greatest_root(c, sub_f(mul_f(X, square(X)), whole(9)));
    zero = add_f(add_f(square(Y), mul_f(X, Y)), whole(1));
    c = with_greatest_root(c, zero);
    assert_int_equal(region_faults, 0);
    assert_int_equal(cagd_poly_degree(c.theta.factor), 6);
    assert_int_equal(cagd_algebraic_sign(&c, cagd_algebraic_value(&c, zero, x)), 0);
    struct cagd_root negative = cagd_refine_root(cagd_algebraic_coordinate(&c, 1), from_ratio_q(1, 1000000000));
    assert_int_equal(region_faults, 0);
    assert_true(fabs(cagd_to_double_q(negative.lo) - (sqrt(cbrt(81) - 4) - cbrt(9)) / 2) < 1e-8);
    /* A root that is in the field already: y^2 = 2 over sqrt 2 makes no larger one. */
    cagd_algebraic_point b = with_greatest_root(cagd_algebraic_origin(), sub_f(square(X), whole(2)));
    b = with_greatest_root(b, sub_f(square(Y), whole(2)));
    assert_int_equal(cagd_poly_degree(b.theta.factor), 2);
    assert_int_equal(cagd_algebraic_sign(&b, cagd_algebraic_value(&b, sub_f(X, Y), x)), 0);
}

static void roots_of_several_polynomials_are_told_apart(void **state)
{
    (void)state;
    open_field();
    num_f x[] = {X, Y};
    cagd_algebraic_point a = with_greatest_root(cagd_algebraic_origin(), sub_f(square(X), whole(2)));
    /* y^2 - 2 and (y - x)(y - 1) have sqrt 2 in common; (y - 1)^3 has one root. */
    num_f p[] = {sub_f(square(Y), whole(2)), mul_f(sub_f(Y, X), sub_f(Y, whole(1))),
                 mul_f(square(sub_f(Y, whole(1))), sub_f(Y, whole(1)))};
    cagd_over_k over[3];
    cagd_root_over_k root[8];
    for (int i = 0; i < 3; i++)
        over[i] = cagd_algebraic_polynomial(&a, p[i], x);
    assert_int_equal(cagd_roots_over_k(&a, 3, over, 8, root), 3); /* -sqrt 2, 1, sqrt 2 */
    assert_true(cagd_compare_q(root[0].hi, root[1].lo) < 0 && cagd_compare_q(root[1].hi, root[2].lo) < 0);
    assert_true(cagd_compare_q(root[1].lo, from_int_q(1)) <= 0 && cagd_compare_q(root[1].hi, from_int_q(1)) >= 0);
    assert_int_equal(cagd_roots_over_k(&a, 3, over, 2, root), -1);
    /* 0 and numbers have none. */
    cagd_over_k more[] = {cagd_algebraic_polynomial(&a, whole(0), x), cagd_algebraic_polynomial(&a, X, x), over[0]};
    assert_int_equal(more[0].degree, -1);
    assert_int_equal(more[1].degree, 0);
    assert_int_equal(cagd_roots_over_k(&a, 3, more, 8, root), 2);
}

static num_f power(num_f a, int n) { return n == 0 ? whole(1) : mul_f(a, power(a, n - 1)); }

/* The limits, and on each the last that is within. */
static void what_is_too_large_is_refused(void **state)
{
    (void)state;
    open_field();
    num_f x[] = {X, Y, Z};
    cagd_algebraic_point origin = cagd_algebraic_origin(), a = with_greatest_root(origin, sub_f(square(X), whole(2)));
    assert_int_equal(cagd_algebraic_polynomial(&origin, power(X, CAGD_MOST_OVER_K), x).degree, CAGD_MOST_OVER_K);
    assert_int_equal(region_faults, 0);
    assert_int_equal(cagd_algebraic_polynomial(&origin, power(X, CAGD_MOST_OVER_K + 1), x).degree, -1);
    expect_fault(FAULT_UNABLE);
    /* A variable that is no coordinate; an element that was not reduced, which no interval tells from 0. */
    cagd_algebraic_value(&a, add_f(X, Z), x);
    expect_fault(FAULT_UNABLE);
    cagd_algebraic_sign(&a, a.theta.factor);
    expect_fault(FAULT_UNABLE);
    /* 0 has no inverse. */
    cagd_over_k no_root = {.degree = 1, .c = {poly_constant(from_int_q(1)), poly_constant(from_int_q(0))}};
    cagd_root_over_k nowhere = {from_int_q(0), from_int_q(1), &no_root};
    cagd_algebraic_with_root(&a, &nowhere, X);
    expect_fault(FAULT_UNDEFINED);
    /* One coordinate more than there is room for, as a number and as a root. */
    cagd_algebraic_point full = a;
    while (full.count < CAGD_MOST_COORDINATES)
        full = cagd_algebraic_with_number(&full, from_int_q(full.count));
    assert_int_equal(region_faults, 0);
    assert_int_equal(cagd_algebraic_with_number(&full, from_int_q(8)).count, CAGD_MOST_COORDINATES);
    expect_fault(FAULT_UNABLE);
    cagd_over_k over = cagd_algebraic_polynomial(&a, sub_f(square(Y), X), x);
    cagd_root_over_k root[4];
    assert_int_equal(cagd_roots_over_k(&a, 1, &over, 4, root), 2);
    assert_int_equal(cagd_algebraic_with_root(&full, &root[1], X).count, CAGD_MOST_COORDINATES);
    expect_fault(FAULT_UNABLE);
}

/* 48 is the highest degree over Q, and 24 that of m and D together.  A number is one in whatever polynomial it is a root of. */
static void fields_of_too_high_degree_are_refused(void **state)
{
    (void)state;
    open_field();
    static const struct {
        int over, degree, is_good;
    } list[] = {{2, 3, 1}, {5, 10, 0}, {2, 23, 0}, {6, 7, 1}};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        num_f x[] = {X, Y};
        cagd_algebraic_point a = with_greatest_root(cagd_algebraic_origin(), sub_f(power(X, list[k].over), whole(2)));
        num_f p = sub_f(power(Y, list[k].degree), X), numbers = mul_f(sub_f(Y, whole(3)), p);
        cagd_root_over_k root[4];
        cagd_over_k over = cagd_algebraic_polynomial(&a, p, x);
        int count = cagd_roots_over_k(&a, 1, &over, 4, root);
        cagd_algebraic_point b = cagd_algebraic_with_root(&a, &root[count - 1], X);
        expect_fault(list[k].is_good ? 0 : FAULT_UNABLE);
        if (list[k].is_good) {
            assert_int_equal(cagd_poly_degree(b.theta.factor), list[k].over * list[k].degree);
            assert_int_equal(cagd_algebraic_sign(&b, cagd_algebraic_value(&b, p, x)), 0);
        }
        over = cagd_algebraic_polynomial(&a, numbers, x); /* its greatest root is 3 */
        count = cagd_roots_over_k(&a, 1, &over, 4, root);
        cagd_root_over_k three = {from_int_q(3), from_int_q(3), root[count - 1].of};
        assert_true(cagd_compare_q(root[count - 1].lo, three.lo) <= 0 &&
                    cagd_compare_q(root[count - 1].hi, three.lo) >= 0);
        b = cagd_algebraic_with_root(&a, &three, X);
        assert_int_equal(region_faults, 0);
        assert_int_equal(b.count, 2);
        assert_true(cagd_equal_q(poly_coefficient(b.coordinate[1], 0), from_int_q(3)));
    }
}

/* Among the y = -jx, j in S, over the square root of 2, eta + c theta is no primitive element where -2c is a sum of two elements
 * of -S.  With 1, 3, ..., 11 that is so for all c up to 11; with 13 for 12, too, and no further one is tried. */
static void a_primitive_element_is_looked_for(void **state)
{
    (void)state;
    for (int last = 11; last <= 13; last += 2) {
        open_field();
        num_f x[] = {X, Y}, p = whole(1);
        cagd_algebraic_point a = with_greatest_root(cagd_algebraic_origin(), sub_f(square(X), whole(2)));
        for (int j = 1; j <= last; j += 2)
            p = mul_f(p, add_f(Y, mul_f(whole(j), X)));
        cagd_root_over_k root[8];
        cagd_over_k over = cagd_algebraic_polynomial(&a, p, x);
        assert_int_equal(cagd_roots_over_k(&a, 1, &over, 8, root), (last + 1) / 2);
        cagd_algebraic_point b = cagd_algebraic_with_root(&a, &root[0], X);
        expect_fault(last == 11 ? 0 : FAULT_UNABLE);
        if (last == 11) {
            num_f zero = add_f(Y, mul_f(whole(last), X));
            assert_int_equal(cagd_poly_degree(b.theta.factor), 2);
            assert_int_equal(cagd_algebraic_sign(&b, cagd_algebraic_value(&b, zero, x)), 0);
        }
    }
}

/* A root in an open interval, at whose lower end there is another: y(y^2 - 2) and y(y - 1) in (0,2). */
static void another_root_at_the_end_is_left_out(void **state)
{
    (void)state;
    open_field();
    num_f x[] = {X};
    cagd_algebraic_point origin = cagd_algebraic_origin();
    for (int is_number = 0; is_number < 2; is_number++) {
        num_f p = mul_f(X, is_number ? sub_f(X, whole(1)) : sub_f(square(X), whole(2)));
        cagd_over_k over = cagd_algebraic_polynomial(&origin, p, x);
        cagd_root_over_k root = {from_int_q(0), from_int_q(2), &over};
        cagd_algebraic_point a = cagd_algebraic_with_root(&origin, &root, X);
        assert_int_equal(region_faults, 0);
        assert_int_equal(cagd_poly_degree(a.theta.factor), is_number ? 1 : 2);
        assert_int_equal(cagd_algebraic_sign(&a, cagd_algebraic_value(&a, p, x)), 0);
        assert_int_equal(cagd_algebraic_sign(&a, cagd_algebraic_value(&a, X, x)), 1);
    }
}

static unsigned at_least(void) { return CAGD_IS_ZERO | CAGD_IS_POSITIVE; }

static enum cagd_implication ask(int count, const cagd_sign_condition given[], num_f claim, unsigned signs,
                                 int variables)
{
    num_f x[] = {X, Y, Z};
    cagd_algebraic_point at;
    return cagd_implies(count, given, (cagd_sign_condition){claim, signs}, variables, x, cagd_seconds() + SURE, &at);
}

/* Means, norms and the circle: inequalities that are equalities somewhere, and the same with < in the place of <=. */
static void what_touches_is_decided(void **state)
{
    (void)state;
    open_field();
    cagd_sign_condition mean[] = {{sub_f(square(Z), mul_f(X, Y)), CAGD_IS_ZERO}, {X, at_least()}, {Y, at_least()}};
    num_f gap = sub_f(add_f(X, Y), mul_f(whole(2), Z));
    assert_int_equal(ask(3, mean, gap, at_least(), 3), CAGD_IMPLIED);
    assert_int_equal(ask(3, mean, gap, CAGD_IS_POSITIVE, 3), CAGD_NOT_IMPLIED);
    assert_int_equal(ask(1, mean, gap, at_least(), 3), CAGD_NOT_IMPLIED); /* without the signs of x and y */
    cagd_sign_condition circle[] = {{sub_f(add_f(square(X), square(Y)), whole(1)), CAGD_IS_ZERO},
                                    {sub_f(square(Z), whole(2)), CAGD_IS_ZERO},
                                    {Z, CAGD_IS_POSITIVE}};
    gap = sub_f(Z, add_f(X, Y));
    assert_int_equal(ask(3, circle, gap, at_least(), 3), CAGD_IMPLIED);
    assert_int_equal(ask(3, circle, gap, CAGD_IS_POSITIVE, 3), CAGD_NOT_IMPLIED);
    assert_int_equal(ask(2, circle, gap, at_least(), 3), CAGD_NOT_IMPLIED); /* z = -sqrt 2 */
    /* Where nothing is given that can be true, everything is implied. */
    cagd_sign_condition none[] = {{add_f(square(X), square(Y)), CAGD_IS_NEGATIVE}};
    assert_int_equal(ask(1, none, X, CAGD_IS_ZERO, 2), CAGD_IMPLIED);
    /* One point: x^2 + y^2 = 0. */
    none[0].signs = CAGD_IS_ZERO;
    assert_int_equal(ask(1, none, X, CAGD_IS_ZERO, 2), CAGD_IMPLIED);
    assert_int_equal(ask(1, none, X, CAGD_IS_POSITIVE, 2), CAGD_NOT_IMPLIED);
    /* A polynomial that is 0 for all z where x = y = 0. */
    cagd_sign_condition fibre[] = {{sub_f(mul_f(X, Z), Y), CAGD_IS_ZERO}, {X, CAGD_IS_ZERO}};
    assert_int_equal(ask(2, fibre, Y, CAGD_IS_ZERO, 3), CAGD_IMPLIED);
    assert_int_equal(ask(2, fibre, Z, CAGD_IS_ZERO, 3), CAGD_NOT_IMPLIED);
    /* The time is over. */
    num_f x[] = {X, Y, Z};
    cagd_algebraic_point at;
    assert_int_equal(cagd_implies(3, mean, (cagd_sign_condition){gap, at_least()}, 3, x, cagd_seconds() - 1, &at),
                     CAGD_IMPLICATION_NOT_KNOWN);
}

/* More variables, conditions, polynomials, roots and higher degrees than are looked at; on each limit the last that is decided. */
static void what_is_too_much_is_not_known(void **state)
{
    (void)state;
    enum { MOST = 60 };
    open_field();
    num_f x[] = {X, Y, Z};
    cagd_algebraic_point at;
    cagd_sign_condition c[MOST], claim = {X, at_least()};
    const double until = cagd_seconds() + SURE;
    assert_int_equal(cagd_implies(0, c, claim, 0, x, until, &at), CAGD_IMPLICATION_NOT_KNOWN);
    assert_int_equal(cagd_implies(0, c, (cagd_sign_condition){whole(1), at_least()}, 0, x, until, &at),
                     CAGD_IMPLICATION_NOT_KNOWN);
    assert_int_equal(cagd_implies(0, c, claim, CAGD_MOST_COORDINATES + 1, x, until, &at), CAGD_IMPLICATION_NOT_KNOWN);
    assert_int_equal(cagd_implies(0, c, claim, 1, x, until, &at), CAGD_NOT_IMPLIED);
    /* x > k for many k, each with the number before. */
    for (int k = 0; k < MOST; k++)
        c[k] = (cagd_sign_condition){sub_f(X, whole(k)), CAGD_IS_POSITIVE};
    assert_int_equal(ask(MOST - 1, c, X, CAGD_IS_POSITIVE, 1), CAGD_IMPLIED);
    assert_int_equal(ask(MOST, c, X, CAGD_IS_POSITIVE, 1), CAGD_IMPLICATION_NOT_KNOWN);
    for (int k = 0; k < MOST / 2; k++)
        c[k].p = mul_f(sub_f(X, whole(2 * k)), sub_f(X, whole(2 * k + 1)));
    assert_int_equal(ask(MOST / 2, c, square(X), at_least(), 1), CAGD_IMPLIED);
    assert_int_equal(ask(MOST / 2, c, sub_f(X, whole(-1)), at_least(), 1), CAGD_IMPLICATION_NOT_KNOWN);
    /* (x + 1)y - 1 has a leading coefficient that is one more, and so has the resultant of y - x and y + x + 2; y - 7 has none. */
    num_f coefficient = sub_f(mul_f(add_f(X, whole(1)), Y), whole(1));
    assert_int_equal(ask(MOST / 2, c, coefficient, at_least(), 2), CAGD_IMPLICATION_NOT_KNOWN);
    c[MOST / 2] = (cagd_sign_condition){sub_f(Y, X), CAGD_IS_POSITIVE};
    assert_int_equal(ask(MOST / 2 + 1, c, add_f(Y, add_f(X, whole(2))), at_least(), 2), CAGD_IMPLICATION_NOT_KNOWN);
    assert_int_equal(ask(MOST / 2 + 1, c, Y, at_least(), 2), CAGD_NOT_IMPLIED);
    /* (1 + x + y + z)^30 + 1/3 has more than 4000 terms. */
    num_f large = add_f(power(add_f(add_f(X, Y), add_f(Z, whole(1))), 30), from_ratio_f(1, 3));
    assert_int_equal(ask(0, c, large, CAGD_IS_POSITIVE, 3), CAGD_IMPLICATION_NOT_KNOWN);
    /* y^12 + x^12 + 1 > 0, and the same with 14. */
    for (int n = 12; n <= 14; n += 2)
        assert_int_equal(ask(0, c, add_f(add_f(power(X, n), power(Y, n)), whole(1)), CAGD_IS_POSITIVE, 2),
                         n == 12 ? CAGD_IMPLIED : CAGD_IMPLICATION_NOT_KNOWN);
    /* x^4 - 10 x^2 + 1 has the roots +-sqrt 2 +- sqrt 3: 50 of them, moved, have 200 together, and 51 have too many. */
    for (int k = 0; k < 51; k++) {
        num_f moved = square(sub_f(X, whole(7 * k)));
        c[k] = (cagd_sign_condition){add_f(sub_f(square(moved), mul_f(whole(10), moved)), whole(1)), CAGD_IS_POSITIVE};
    }
    assert_int_equal(ask(49, c, c[49].p, CAGD_IS_POSITIVE, 1), CAGD_NOT_IMPLIED);
    assert_int_equal(ask(50, c, c[50].p, CAGD_IS_POSITIVE, 1), CAGD_IMPLICATION_NOT_KNOWN);
}

/* Conditions that are numbers: a false one implies everything, a true one nothing; a claim that is a number is what it is wherever there is a
 * point. */
static void numbers_are_conditions(void **state)
{
    (void)state;
    open_field();
    static const unsigned signs[] = {CAGD_IS_NEGATIVE, CAGD_IS_ZERO, CAGD_IS_POSITIVE};
    for (int c = -1; c <= 1; c++)
        for (int s = 0; s < 3; s++) {
            const int is_true = s == c + 1;
            for (int after = 0; after < 2; after++) {
                cagd_sign_condition given[2];
                given[after] = (cagd_sign_condition){whole(7 * c), signs[s]};
                given[!after] = (cagd_sign_condition){X, CAGD_IS_POSITIVE};
                assert_int_equal(ask(2, given, X, CAGD_IS_NEGATIVE, 1), is_true ? CAGD_NOT_IMPLIED : CAGD_IMPLIED);
                assert_int_equal(ask(2, given, X, CAGD_IS_POSITIVE, 2), CAGD_IMPLIED);
            }
            cagd_sign_condition some = {sub_f(X, Y), CAGD_IS_ZERO},
                                none = {add_f(square(X), whole(1)), CAGD_IS_ZERO | CAGD_IS_NEGATIVE};
            for (int variables = 1; variables <= 3; variables++) {
                assert_int_equal(ask(0, NULL, whole(7 * c), signs[s], variables),
                                 is_true ? CAGD_IMPLIED : CAGD_NOT_IMPLIED);
                assert_int_equal(ask(1, &none, whole(7 * c), signs[s], variables), CAGD_IMPLIED);
                if (variables > 1)
                    assert_int_equal(ask(1, &some, whole(7 * c), signs[s], variables),
                                     is_true ? CAGD_IMPLIED : CAGD_NOT_IMPLIED);
            }
        }
}

/* Each root of several, and each interval between them, may be the only counterexample. */
static void every_root_and_every_interval_is_looked_at(void **state)
{
    (void)state;
    open_field();
    enum { ROOTS = 4 };
    static const int root[ROOTS] = {-2, 1, 2, 5};
    num_f p = whole(1), x[] = {X};
    for (int k = 0; k < ROOTS; k++)
        p = mul_f(p, sub_f(X, whole(root[k])));
    cagd_algebraic_point at;
    for (int k = 0; k < ROOTS; k++) {
        cagd_sign_condition given = {p, CAGD_IS_ZERO},
                            claim = {sub_f(X, whole(root[k])), CAGD_IS_NEGATIVE | CAGD_IS_POSITIVE};
        assert_int_equal(cagd_implies(1, &given, claim, 1, x, cagd_seconds() + SURE, &at), CAGD_NOT_IMPLIED);
        struct cagd_root r = cagd_algebraic_coordinate(&at, 0);
        assert_true(cagd_equal_q(r.lo, from_int_q(root[k])) && cagd_equal_q(r.hi, r.lo) && r.multiplicity == 1);
        assert_true(cagd_poly_equal(r.factor, poly_from_q(2, (num_q[]){from_int_q(-root[k]), from_int_q(1)})));
        /* and the square roots of -1 + root[k]^2 */
        cagd_sign_condition two[] = {given, {sub_f(square(Y), whole((long)root[k] * root[k] + 1)), CAGD_IS_ZERO}};
        for (unsigned side = CAGD_IS_NEGATIVE; side <= CAGD_IS_POSITIVE; side += 3)
            assert_int_equal(ask(2, two, Y, side, 2), CAGD_NOT_IMPLIED);
        assert_int_equal(ask(2, two, Y, CAGD_IS_NEGATIVE | CAGD_IS_POSITIVE, 2), CAGD_IMPLIED);
    }
    for (int k = 0; k <= ROOTS; k++) {
        cagd_sign_condition given[] = {{k > 0 ? sub_f(X, whole(root[k - 1])) : whole(1), CAGD_IS_POSITIVE},
                                       {k < ROOTS ? sub_f(X, whole(root[k])) : whole(-1), CAGD_IS_NEGATIVE}};
        const unsigned is = (ROOTS - k) % 2 ? CAGD_IS_NEGATIVE : CAGD_IS_POSITIVE;
        assert_int_equal(ask(2, given, p, is, 1), CAGD_IMPLIED);
        assert_int_equal(ask(2, given, p, CAGD_IS_ZERO, 1), CAGD_NOT_IMPLIED);
    }
}

/* Four lines: every two of them meet in a point at which the others are not. */
static void every_two_polynomials_are_projected(void **state)
{
    (void)state;
    open_field();
    enum { LINES = 4 };
    static const int a[LINES] = {1, -1, 3, 0}, b[LINES] = {31, 207, -490, -533}; /* y = a x + b/100 */
    for (int i = 0; i < LINES; i++)
        for (int j = 0; j < i; j++)
            for (int turn = 0; turn < LINES; turn++) {
                cagd_sign_condition given[LINES];
                for (int k = 0; k < LINES; k++) {
                    num_f line = sub_f(Y, add_f(mul_f(whole(a[k]), X), from_ratio_f(b[k], 100)));
                    given[(k + turn) % LINES] = (cagd_sign_condition){
                        line, k == i || k == j ? CAGD_IS_ZERO : CAGD_IS_NEGATIVE | CAGD_IS_POSITIVE};
                }
                num_f there = sub_f(mul_f(whole(a[i] - a[j]), X), from_ratio_f(b[j] - b[i], 100));
                /* a height at which no two of them meet, above and below: nothing but the lines tells of the place */
                num_f x_there = from_ratio_f(b[j] - b[i], 100L * (a[i] - a[j])),
                      height = add_f(mul_f(whole(a[i]), x_there), from_ratio_f(b[i], 100));
                num_f above = sub_f(Y, add_f(height, from_ratio_f(3, 7)));
                assert_int_equal(ask(LINES, given, above, CAGD_IS_POSITIVE, 2), CAGD_NOT_IMPLIED);
                assert_int_equal(ask(LINES, given, above, CAGD_IS_NEGATIVE, 2), CAGD_IMPLIED);
                assert_int_equal(ask(LINES, given, there, CAGD_IS_ZERO, 2), CAGD_IMPLIED);
                assert_int_equal(ask(LINES, given, there, CAGD_IS_NEGATIVE | CAGD_IS_POSITIVE, 2), CAGD_NOT_IMPLIED);
            }
}

/* xz - y is 0 for all z where x = y = 0; y = 0 follows from no other polynomial.  Beside it another polynomial is 0 nowhere, before or
 * behind it.  With w the place is a line and no point, or z is not the last variable: then nothing is known of what is implied. */
static void what_vanishes_over_a_point_or_a_line(void **state)
{
    (void)state;
    open_field();
    num_f W = variable_f("w"), vanishes = sub_f(mul_f(X, Z), Y), other = sub_f(add_f(X, Z), whole(1)),
          positive = add_f(square(Z), whole(1));
    for (int turn = 0; turn < 2; turn++) {
        cagd_sign_condition c[4] = {{X, CAGD_IS_ZERO}};
        c[1 + turn] = (cagd_sign_condition){vanishes, CAGD_IS_ZERO};
        c[2 - turn] = (cagd_sign_condition){other, CAGD_IS_NEGATIVE};
        assert_int_equal(ask(3, c, Y, CAGD_IS_ZERO, 3), CAGD_IMPLIED);
        assert_int_equal(ask(3, c, positive, CAGD_IS_POSITIVE, 3), CAGD_IMPLIED);
        assert_int_equal(ask(3, c, add_f(Z, whole(1)), CAGD_IS_NEGATIVE, 3), CAGD_NOT_IMPLIED);
        assert_int_equal(ask(3, c, sub_f(Z, whole(1)), CAGD_IS_NEGATIVE, 3), CAGD_IMPLIED);
        /* y = 0 is told by xz - y alone, which has no y but in its last coefficient */
        c[1] = (cagd_sign_condition){vanishes, CAGD_IS_ZERO};
        assert_int_equal(ask(2, c, add_f(Y, whole(7)), CAGD_IS_NEGATIVE, 3), CAGD_NOT_IMPLIED);
        assert_int_equal(ask(2, c, add_f(Y, whole(7)), CAGD_IS_POSITIVE, 3), CAGD_IMPLIED);
        c[1 + turn] = (cagd_sign_condition){vanishes, CAGD_IS_ZERO};
        c[2 - turn] = (cagd_sign_condition){other, CAGD_IS_NEGATIVE};
        cagd_algebraic_point at;
        for (int place = 0; place < 4; place++) {
            num_f x[4] = {X, Y, Z};
            for (int k = 3; k > place; k--)
                x[k] = x[k - 1];
            x[place] = W;
            c[3] = (cagd_sign_condition){sub_f(W, whole(1)), CAGD_IS_POSITIVE};
            enum cagd_implication answer = cagd_implies(
                4, c, (cagd_sign_condition){sub_f(Z, whole(1)), CAGD_IS_NEGATIVE}, 4, x, cagd_seconds() + SURE, &at);
            assert_int_equal(answer, CAGD_IMPLICATION_NOT_KNOWN);
            answer = cagd_implies(4, c, (cagd_sign_condition){W, CAGD_IS_NEGATIVE}, 4, x, cagd_seconds() + SURE, &at);
            assert_int_equal(answer, CAGD_NOT_IMPLIED);
        }
    }
}

/* Minimal polynomials have the leading coefficient 1, and coordinates are the numbers that they are however they are written. */
static void minimal_polynomials_are_monic(void **state)
{
    (void)state;
    open_field();
    num_f x[] = {X, Y, Z};
    static const int of[][2] = {{2, 1}, {3, 2}, {12, 7}, {1, 1000}};
    for (int n = 2; n <= 3; n++)
        for (size_t k = 0; k < sizeof of / sizeof *of; k++) { /* of[0] x^n = of[1] */
            cagd_algebraic_point a = with_greatest_root(cagd_algebraic_origin(),
                                                        sub_f(mul_f(whole(of[k][0]), power(X, n)), whole(of[k][1])));
            int degree = cagd_poly_degree(a.theta.factor);
            assert_int_equal(degree, n == 3 && of[k][1] == 1000 ? 1 : n);
            assert_true(cagd_equal_q(poly_coefficient(a.theta.factor, degree), from_int_q(1)));
            num_f p = sub_f(mul_f(whole(3), square(Y)), add_f(X, whole(1)));
            a = with_greatest_root(a, p);
            assert_int_equal(region_faults, 0);
            degree = cagd_poly_degree(a.theta.factor);
            assert_true(cagd_equal_q(poly_coefficient(a.theta.factor, degree), from_int_q(1)));
            assert_int_equal(cagd_algebraic_sign(&a, cagd_algebraic_value(&a, p, x)), 0);
            double first = pow(of[k][1] / (double)of[k][0], 1.0 / n), value[] = {first, sqrt((first + 1) / 3)};
            for (int c = 0; c < 2; c++) {
                struct cagd_root r = cagd_refine_root(cagd_algebraic_coordinate(&a, c), from_ratio_q(1, 1000000000));
                assert_true(fabs(cagd_to_double_q(r.lo) - value[c]) < 1e-8);
                degree = cagd_poly_degree(r.factor);
                assert_true(cagd_equal_q(poly_coefficient(r.factor, degree), from_int_q(1)));
            }
        }
    /* a root that no bisection meets, 1/3 of (3x - 1)(x^2 - 2), and -1/3 */
    for (int sign = -1; sign <= 1; sign += 2) {
        cagd_algebraic_point origin = cagd_algebraic_origin();
        num_f p = mul_f(sub_f(mul_f(whole(3), X), whole(sign)), sub_f(square(X), whole(2)));
        cagd_over_k over = cagd_algebraic_polynomial(&origin, p, x);
        cagd_root_over_k root[4];
        assert_int_equal(cagd_roots_over_k(&origin, 1, &over, 4, root), 3);
        cagd_algebraic_point a = cagd_algebraic_with_root(&origin, &root[1], X);
        struct cagd_root r = cagd_algebraic_coordinate(&a, 0);
        assert_true(cagd_equal_q(r.lo, from_ratio_q(sign, 3)) && cagd_equal_q(r.hi, r.lo));
        assert_true(cagd_poly_equal(r.factor, poly_from_q(2, (num_q[]){from_ratio_q(-sign, 3), from_int_q(1)})));
        assert_true(cagd_poly_degree(a.theta.factor) == 1 && a.count == 1 && cagd_poly_degree(a.coordinate[0]) == 0);
    }
    /* a rational coordinate over a field, and one beyond 100 */
    cagd_algebraic_point a = with_greatest_root(cagd_algebraic_origin(), sub_f(square(X), whole(2)));
    a = cagd_algebraic_with_number(&a, from_ratio_q(-7, 3));
    a = with_greatest_root(a, sub_f(Z, mul_f(whole(100), X)));
    struct cagd_root r = cagd_algebraic_coordinate(&a, 1);
    assert_true(cagd_equal_q(r.lo, from_ratio_q(-7, 3)) && cagd_equal_q(r.hi, r.lo) && r.multiplicity == 1);
    assert_true(cagd_poly_equal(r.factor, poly_from_q(2, (num_q[]){from_ratio_q(7, 3), from_int_q(1)})));
    r = cagd_refine_root(cagd_algebraic_coordinate(&a, 2), from_ratio_q(1, 1000000));
    assert_true(fabs(cagd_to_double_q(r.lo) - 100 * sqrt(2)) < 1e-5 && r.multiplicity == 1);
}

/* A root is a number lo = hi or between lo and hi, which are not it; wherever halving meets it, and in whatever order the polynomials that
 * have it come, with others in common. */
static void roots_are_between_their_ends(void **state)
{
    (void)state;
    open_field();
    enum { ROOTS = 7 };
    num_f x[] = {X, Y};
    cagd_algebraic_point a = with_greatest_root(cagd_algebraic_origin(), sub_f(square(X), whole(2)));
    num_q known[ROOTS] = {from_int_q(-4), from_int_q(-1), from_int_q(0), from_ratio_q(1, 2),
                          from_int_q(1),  from_int_q(2),  from_int_q(3)};
    num_f factor[ROOTS];
    for (int k = 0; k < ROOTS; k++)
        factor[k] = sub_f(Y, from_rational_f(known[k]));
    for (int turn = 0; turn < ROOTS; turn++)
        for (int several = 0; several < 3; several++) {
            cagd_over_k p[ROOTS];
            int count = 0;
            num_f all = whole(1);
            for (int k = 0; k < ROOTS; k++) {
                num_f one = factor[(k + turn) % ROOTS], next = factor[(k + turn + 1) % ROOTS];
                all = mul_f(all, one);
                if (several > 0) /* alone, or with the next one in common */
                    p[count++] = cagd_algebraic_polynomial(&a, several == 1 ? one : mul_f(one, next), x);
            }
            if (several == 0)
                p[count++] = cagd_algebraic_polynomial(&a, mul_f(all, sub_f(square(Y), X)), x);
            cagd_root_over_k root[ROOTS + 2];
            int found = cagd_roots_over_k(&a, count, p, ROOTS + 2, root), places = 0;
            assert_int_equal(found, several == 0 ? ROOTS + 2 : ROOTS);
            for (int i = 0; i < found; i++) {
                int order = cagd_compare_q(root[i].lo, root[i].hi), in = 0;
                assert_true(order <= 0 && (i == 0 || cagd_compare_q(root[i - 1].hi, root[i].lo) < 0));
                for (int k = 0; k < ROOTS; k++)
                    in += order == 0
                              ? cagd_equal_q(root[i].lo, known[k])
                              : cagd_compare_q(root[i].lo, known[k]) < 0 && cagd_compare_q(known[k], root[i].hi) < 0;
                assert_true(in <= 1);
                places += in;
            }
            assert_int_equal(places, ROOTS);
        }
}

/* Elements of a field have the sign of their values, though they are 0 at an end of the interval in which theta is enclosed, or near. */
static void signs_near_the_ends_of_an_interval(void **state)
{
    (void)state;
    open_field();
    num_f x[] = {X};
    for (int e = 2; e <= 3; e++) {
        cagd_algebraic_point a = with_greatest_root(cagd_algebraic_origin(), sub_f(power(X, e), whole(5)));
        const num_q end[] = {a.theta.lo, a.theta.hi};
        for (int k = 0; k < 2; k++)
            for (int times = 1; times <= 3; times++) {
                num_f away = sub_f(X, from_rational_f(end[k]));
                const int sign = k == 0 || times % 2 == 0 ? 1 : -1;
                assert_int_equal(cagd_algebraic_sign(&a, cagd_algebraic_value(&a, power(away, times), x)), sign);
                assert_int_equal(cagd_algebraic_sign(&a, cagd_algebraic_value(&a, neg_f(power(away, times)), x)),
                                 -sign);
            }
        assert_int_equal(cagd_algebraic_sign(&a, poly_from_q(0, NULL)), 0);
        for (int c = -1; c <= 1; c++)
            assert_int_equal(cagd_algebraic_sign(&a, poly_constant(from_int_q(3 * c))), c);
    }
}

static num_f random_polynomial(int variables, int degree)
{
    num_f x[] = {X, Y, Z}, p = whole(random_int(-2, 2));
    for (int terms = random_int(1, 3); terms > 0; terms--) {
        num_f t = whole(random_int(0, 1) ? random_int(1, 3) : -random_int(1, 3));
        for (int e = random_int(1, degree); e > 0; e--)
            t = mul_f(t, x[random_int(0, variables - 1)]);
        p = add_f(p, t);
    }
    return p;
}

static int is_true_at(const cagd_algebraic_point *at, const cagd_sign_condition *c, const num_f x[])
{
    int sign = cagd_algebraic_sign(at, cagd_algebraic_value(at, c->p, x));
    return (c->signs & (sign < 0 ? CAGD_IS_NEGATIVE : sign > 0 ? CAGD_IS_POSITIVE : CAGD_IS_ZERO)) != 0;
}

/* Whether the claim is false at some point of a grid at which all that is given is true. */
static int fails_on_grid(int count, const cagd_sign_condition c[], int variables)
{
    enum { SIDE = 13 };
    num_f x[] = {X, Y, Z};
    for (int m = 0; m < SIDE * SIDE * (variables == 3 ? SIDE : 1); m++) {
        region_mark mark = region_open();
        cagd_algebraic_point at = cagd_algebraic_origin();
        int place[] = {m % SIDE, m / SIDE % SIDE, m / SIDE / SIDE}, is = 1;
        for (int k = 0; k < variables; k++)
            at = cagd_algebraic_with_number(&at, from_ratio_q(place[k] - SIDE / 2, 2));
        for (int i = 0; i < count && is; i++)
            is = is_true_at(&at, &c[i], x);
        is = is && !is_true_at(&at, &c[count], x);
        region_drop(mark);
        if (is)
            return 1;
    }
    return 0;
}

static void random_implications_are_those_of_a_grid(void **state)
{
    (void)state;
    static const unsigned some[] = {CAGD_IS_ZERO, CAGD_IS_POSITIVE, CAGD_IS_ZERO | CAGD_IS_POSITIVE,
                                    CAGD_IS_NEGATIVE | CAGD_IS_POSITIVE};
    int seen[3] = {0}, irrational = 0;
    for (int k = 0; k < TRIALS; k++) {
        open_field();
        num_f x[] = {X, Y, Z};
        int variables = k % 4 == 0 ? 3 : 2, count = random_int(1, 2);
        cagd_sign_condition c[3];
        cagd_algebraic_point at;
        for (int i = 0; i <= count; i++)
            c[i] = (cagd_sign_condition){random_polynomial(variables, variables == 3 ? 2 : 3), some[random_int(0, 3)]};
        if (random_int(0, 2) == 0) /* a square, which touches */
            c[count] = (cagd_sign_condition){square(c[count].p), some[random_int(1, 2)]};
        enum cagd_implication answer = cagd_implies(count, c, c[count], variables, x, cagd_seconds() + SURE, &at);
        seen[answer]++;
        assert_int_equal(region_faults, 0);
        if (answer == CAGD_IMPLIED)
            assert_false(fails_on_grid(count, c, variables));
        if (answer == CAGD_NOT_IMPLIED) {
            irrational += cagd_poly_degree(at.theta.factor) > 1;
            for (int i = 0; i < count; i++)
                assert_true(is_true_at(&at, &c[i], x));
            assert_false(is_true_at(&at, &c[count], x));
        }
        region_drop((region_mark){.precision = 128});
    }
    assert_true(seen[CAGD_IMPLIED] > TRIALS / 20 && seen[CAGD_NOT_IMPLIED] > TRIALS / 3);
    assert_true(irrational > 0 && seen[CAGD_IMPLICATION_NOT_KNOWN] < TRIALS / 10);
    print_message("implied %d, not %d (%d with roots), not known %d\n", seen[0], seen[1], irrational, seen[2]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {unit(roots_over_roots_are_the_numbers_they_are),
                                       unit(roots_of_several_polynomials_are_told_apart),
                                       unit(what_is_too_large_is_refused),
                                       unit(fields_of_too_high_degree_are_refused),
                                       unit(a_primitive_element_is_looked_for),
                                       unit(another_root_at_the_end_is_left_out),
                                       unit(what_touches_is_decided),
                                       unit(what_is_too_much_is_not_known),
                                       unit(numbers_are_conditions),
                                       unit(every_root_and_every_interval_is_looked_at),
                                       unit(every_two_polynomials_are_projected),
                                       unit(what_vanishes_over_a_point_or_a_line),
                                       unit(minimal_polynomials_are_monic),
                                       unit(roots_are_between_their_ends),
                                       unit(signs_near_the_ends_of_an_interval),
                                       unit(random_implications_are_those_of_a_grid)};
    return run_unit_tests(tests);
}
