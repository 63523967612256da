/* test_sign.c -- the sign of a polynomial on an interval against its planted roots. */
#include "unit_roots.h"

#include "exact/decide/sign.h"
#include "exact/words.h"

/* The sign at a point: of the leading coefficient times (-1)^(roots of odd multiplicity above it). */
static int planted_sign(const struct planted *f, num_q t)
{
    int s = cagd_sign_q(f->leading);
    for (int k = 0; k < f->count; k++) {
        int side = cagd_compare_q(t, f->at[k]);
        s *= side == 0 ? 0 : side < 0 && f->multiplicity[k] % 2 ? -1 : 1;
    }
    return s;
}

/* Every sign that occurs is that of an end, of a root, or of the middle between neighbours of these. */
static enum cagd_sign_pattern planted_pattern(const struct planted *f, num_q a, num_q b, enum cagd_ends ends)
{
    num_q place[PLANTED + 2];
    int count = 0, seen[3] = {0};
    place[count++] = a;
    for (int k = 0; k < f->count; k++)
        if (cagd_compare_q(f->at[k], a) > 0 && cagd_compare_q(f->at[k], b) < 0)
            place[count++] = f->at[k];
    place[count++] = b;
    for (int k = 0; k + 1 < count; k++)
        seen[1 + planted_sign(f, mul_q(from_ratio_q(1, 2), add_q(place[k], place[k + 1])))]++;
    for (int k = 0; k < count; k++) {
        int included =
            (k > 0 || ends == CLOSED || ends == OPEN_RIGHT) && (k + 1 < count || ends == CLOSED || ends == OPEN_LEFT);
        seen[1 + planted_sign(f, place[k])] += included;
    }
    return seen[0] && seen[2] ? SIGN_MIXED
           : seen[2]          ? (seen[1] ? SIGN_NONNEGATIVE : SIGN_POSITIVE)
                              : (seen[1] ? SIGN_NONPOSITIVE : SIGN_NEGATIVE);
}

static void planted_signs(void **state)
{
    (void)state;
    int met[6] = {0};
    for (int k = 0; k < 1000; k++) {
        region_mark m = region_open();
        struct planted f = plant();
        num_q a = f.count > 0 && k % 2 ? f.at[random_int(0, f.count - 1)] : coarse_q(3, 7);
        num_q b = f.count > 0 && k % 3 ? f.at[random_int(0, f.count - 1)] : coarse_q(3, 7);
        if (cagd_compare_q(a, b) < 0)
            for (enum cagd_ends e = CLOSED; e <= OPEN_RIGHT; e++) {
                enum cagd_sign_pattern s = cagd_sign_on(f.p, a, b, e);
                assert_int_equal(cagd_is_nonnegative(s),
                                 s != SIGN_MIXED && s != SIGN_NEGATIVE && s != SIGN_NONPOSITIVE);
                assert_int_equal(s, planted_pattern(&f, a, b, e));
                if (e == CLOSED)
                    assert_int_equal(cagd_is_nonnegative_on(f.p, a, b), cagd_is_nonnegative(s));
                met[s]++;
            }
        region_drop(m);
    }
    for (enum cagd_sign_pattern s = SIGN_POSITIVE; s <= SIGN_MIXED; s++)
        assert_true(met[s] > 0); /* nothing tested is a failure */
}

static void edges(void **state)
{
    (void)state;
    num_q zero = from_int_q(0), one = from_int_q(1);
    assert_int_equal(cagd_sign_on(poly_from_q(0, NULL), zero, one, OPEN), SIGN_ZERO);
    assert_int_equal(cagd_sign_on(poly_variable(), zero, zero, CLOSED), SIGN_ZERO);
    assert_int_equal(cagd_sign_on(poly_variable(), one, one, CLOSED), SIGN_POSITIVE);
    assert_int_equal(cagd_sign_on(poly_variable(), neg_q(one), neg_q(one), CLOSED), SIGN_NEGATIVE);
    /* 0 is not negative, on an interval and in a point, with both ends and without */
    assert_true(cagd_is_nonnegative(SIGN_ZERO));
    assert_true(cagd_is_nonnegative_on(poly_from_q(0, NULL), zero, one));
    assert_true(cagd_is_nonnegative_on(poly_variable(), zero, zero));
    assert_false(cagd_is_nonnegative_on(poly_variable(), neg_q(one), neg_q(one)));
    for (enum cagd_ends e = CLOSED; e <= OPEN_RIGHT; e++)
        assert_int_equal(cagd_sign_on(poly_from_q(0, NULL), zero, one, e), SIGN_ZERO);
    cagd_sign_on(poly_from_q(0, NULL), one, zero, CLOSED);
    expect_fault(FAULT_UNDEFINED);
    for (enum cagd_ends e = CLOSED; e <= OPEN_RIGHT; e++)
        if (e != CLOSED) { /* [0,0) and (0,0] are no intervals either */
            cagd_sign_on(poly_variable(), zero, zero, e);
            expect_fault(FAULT_UNDEFINED);
        }
    cagd_sign_on(poly_variable(), one, zero, CLOSED);
    expect_fault(FAULT_UNDEFINED);
}

int main(void)
{
    const struct CMUnitTest tests[] = {unit(planted_signs), unit(edges)};
    return run_unit_tests(tests);
}
