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
                                       unit(roots_of_several_polynomials_are_told_apart), unit(what_touches_is_decided),
                                       unit(random_implications_are_those_of_a_grid)};
    return run_unit_tests(tests);
}
