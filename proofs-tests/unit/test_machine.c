/* test_machine.c -- what rewritten code calls, one call at a time: arithmetic at the ends of ranges, whole numbers, classes, what the
 * conditions of a way say about signs, and which addresses are those of an object. */
#include "proofs-tests/unit/unit_exact.h"

#include "exact/code/objects.h"
#include "exact/code/process.h"
#include "exact/code/value.h"
#include "exact/record/trace.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

enum { SAME = 1, GREATER = 2, LESS = 4, ANY = 7 };

/* In the process of a run: where it is not so, the run crashes with the line. */
#define check(condition)                                                                                               \
    ((condition) ? (void)0 : cagd_code_stop(CAGD_CODE_CRASHED, "line %d: %s", __LINE__, #condition))

/* The body, as a run of the job; the outcome is to be freed. */
static struct cagd_code_outcome *outcome_of(void (*body)(void), const struct cagd_code_job *job)
{
    struct cagd_code_job bounded = cagd_code_bounded(job);
    size_t bytes;
    struct cagd_code_outcome *o = cagd_code_shared_room(&bytes);
    assert_non_null(o);
    pid_t child = fork();
    if (child == 0) {
        cagd_code_tell_into(o, bytes, &bounded);
        if (job->numbers == CAGD_CODE_FIELD)
            field_open(16);
        cagd_code_values_open();
        body();
        cagd_code_check_faults();
        o->end = CAGD_CODE_FINISHED;
        _exit(0);
    }
    assert_true(child > 0);
    assert_int_equal(waitpid(child, NULL, 0), child);
    return o;
}

/* The body ends so, with a message that begins so. */
static void ends(void (*body)(void), const struct cagd_code_job *job, enum cagd_code_end end, const char *message)
{
    struct cagd_code_outcome *o = outcome_of(body, job);
    if (o->end != end || (end != CAGD_CODE_FINISHED && strncmp(o->message, message, strlen(message)) != 0))
        fail_msg("end %d, not %d: %s", (int)o->end, (int)end, o->message);
    cagd_code_outcome_free(o);
}

static const struct cagd_code_job in_rationals = {.numbers = CAGD_CODE_RATIONAL},
                                  in_field = {.numbers = CAGD_CODE_FIELD};

/* ---- arithmetic ------------------------------------------------------------------------------------------- */

static double dividend;
static void divided_by_zero(void)
{
    cagd_code_div(dividend, cagd_code_sub(dividend == 0 ? 1 : 2, dividend == 0 ? 1 : 2));
}
static void nothing_is_divided_by_zero(void **state)
{
    (void)state;
    static const double list[] = {1, -1, 0, (double)INFINITY, -(double)INFINITY, (double)NAN};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        dividend = list[k];
        ends(divided_by_zero, &in_rationals, CAGD_CODE_UNDEFINED, "a division by zero");
    }
}

/* Squares only: the first of more bits than are allowed ends the run, of numerator and
 * denominator together. */
static double base;
static void high_power(void) { cagd_code_power(cagd_code_div(base, 7), 1 << 28); }
static void high_inverse_power(void) { cagd_code_power(cagd_code_div(1, base), 1 << 28); }
static void a_power_ends_where_it_has_too_many_bits(void **state)
{
    (void)state;
    const struct cagd_code_job job = {.numbers = CAGD_CODE_RATIONAL, .most_bits = 1000};
    void (*const bodies[])(void) = {high_power, high_inverse_power};
    for (int k = 0; k < 2; k++)
        for (base = 3; base < 100; base += 2) {
            if (fmod(base, 7) == 0)
                continue;
            struct cagd_code_outcome *o = outcome_of(bodies[k], &job);
            assert_int_equal(o->end, CAGD_CODE_BOUND);
            double bits = log2(base) + (k == 0 ? log2(7) : 0);
            int squares = (int)ceil(log2(1000 / bits));
            assert_in_range(o->operations, 1 + squares - 1, 1 + squares + 1); /* and the division */
            cagd_code_outcome_free(o);
        }
}

static void powers(void)
{
    static const int exponents[] = {0, 1, 2, 3, 7, 8, 31, -1, -2, -5};
    for (size_t k = 0; k < sizeof exponents / sizeof *exponents; k++)
        for (int m = 1; m <= 5; m++) {
            num_q q = from_ratio_q(-2, m), wanted = from_int_q(1);
            int n = exponents[k];
            for (int j = 0; j < (n < 0 ? -n : n); j++)
                wanted = mul_q(wanted, q);
            if (n < 0)
                wanted = div_q(from_int_q(1), wanted);
            check(cagd_equal_q(cagd_code_value_of(cagd_code_power(cagd_code_div(-2, m), n)).q, wanted));
        }
    check(cagd_code_power(1, INT32_MIN) == 1 && cagd_code_power(-1, INT32_MIN) == 1);
    check(cagd_code_power(-1, INT32_MAX) == -1);
}
static void powers_are_products(void **state)
{
    (void)state;
    ends(powers, &in_rationals, CAGD_CODE_FINISHED, "");
}

/* ---- classes and whole numbers ---------------------------------------------------------------------------- */

/* Signaling NaN, quiet NaN, -inf, -normal, -subnormal, -0, 0, subnormal, normal, inf.  An exact number is normal or 0, of which nobody
 * knows the sign; a NaN may be of either kind. */
static void classes(void)
{
    const struct {
        double x;
        int classes;
    } list[] = {{(double)NAN, 3},
                {-(double)INFINITY, 4},
                {-3, 8},
                {cagd_code_div(-1, 3), 8},
                {0, 32 | 64},
                {cagd_code_sub(cagd_code_div(1, 3), cagd_code_div(1, 3)), 32 | 64},
                {cagd_code_div(1, 3), 256},
                {5, 256},
                {(double)INFINITY, 512}};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++)
        for (int which = 0; which < 1024; which++)
            check(cagd_code_class(list[k].x, which) == ((which & list[k].classes) != 0));
}
static void classes_are_those_of_the_number(void **state)
{
    (void)state;
    ends(classes, &in_rationals, CAGD_CODE_FINISHED, "");
}

static void integers(void)
{
    for (int bits = 8; bits <= 64; bits *= 2) {
        uint64_t unsigned_most = bits == 64 ? UINT64_MAX : ((uint64_t)1 << bits) - 1, most = unsigned_most / 2;
        for (uint64_t below = 0; below < 3; below++) {
            check((uint64_t)cagd_code_to_integer(cagd_code_from_unsigned(unsigned_most - below), bits, 0) ==
                  unsigned_most - below);
            check(cagd_code_to_integer(cagd_code_from_unsigned(most - below), bits, 1) == (int64_t)(most - below));
            int64_t n = -(int64_t)most - 1 + (int64_t)below;
            check(cagd_code_to_integer(cagd_code_from_signed(n), bits, 1) == n);
            check(cagd_code_to_integer(cagd_code_from_unsigned(below), bits, 0) == (int64_t)below);
        }
    }
    for (int k = 50; k < 64; k++) /* numbers that no binary64 is, too */
        for (int d = -3; d <= 3; d++) {
            uint64_t n = ((uint64_t)1 << k) + (uint64_t)d;
            check(mpz_cmp_ui(mpq_numref(cagd_code_value_of(cagd_code_from_unsigned(n)).q.at), n) == 0);
        }
    check(cagd_code_to_integer(cagd_code_div(-7, 2), 8, 1) == -3 &&
          cagd_code_to_integer(cagd_code_div(7, 2), 8, 0) == 3);
    check(cagd_code_to_integer(cagd_code_div(-7, 8), 8, 0) == 0);
}
static int too_large_bits, too_large_signed, too_small;
static void too_large(void)
{
    double end = cagd_code_from_unsigned((uint64_t)1 << (too_large_bits - 1));
    double x = too_large_signed ? end : cagd_code_mul(end, 2);
    if (too_small)
        x = too_large_signed ? cagd_code_sub(-1, x) : -1;
    cagd_code_to_integer(x, too_large_bits, too_large_signed);
}
static void integers_have_their_ranges(void **state)
{
    (void)state;
    ends(integers, &in_rationals, CAGD_CODE_FINISHED, "");
    for (too_large_bits = 8; too_large_bits <= 64; too_large_bits *= 2)
        for (too_large_signed = 0; too_large_signed < 2; too_large_signed++)
            for (too_small = 0; too_small < 2; too_small++)
                ends(too_large, &in_rationals, CAGD_CODE_REFUSED, "a number outside the range of");
}

/* What IEEE 754 says of infinities and NaN beside numbers, where nothing else than their signs counts; 0 has none. */
static void specials(void)
{
    static const double list[] = {1, -1, 2, -0.5, 0, (double)INFINITY, -(double)INFINITY, (double)NAN};
    enum { MANY = sizeof list / sizeof *list };
    double (*const operation[])(double, double) = {cagd_code_add, cagd_code_sub, cagd_code_mul, cagd_code_div};
    for (int i = 0; i < MANY; i++)
        for (int j = 0; j < MANY; j++) {
            double a = list[i], b = list[j], wanted[] = {a + b, a - b, a * b, a / b};
            if (isfinite(a) && isfinite(b))
                continue;
            for (int k = 0; k < 4; k++) {
                if (k == 3 && b == 0)
                    continue;
                double x = operation[k](a, b);
                check(isnan(x) ? isnan(wanted[k]) : x == wanted[k]);
            }
        }
    check(cagd_code_neg((double)INFINITY) == -(double)INFINITY && isnan(cagd_code_neg((double)NAN)));
    check(cagd_code_neg(-(double)INFINITY) == (double)INFINITY);
}
/* In which relation two numbers are: 1 equal, 2 greater, 4 less, 8 none; a predicate is a sum of them. */
static void comparisons(void)
{
    double third = cagd_code_div(1, 3);
    const double list[] = {-(double)INFINITY, -1, 0, third, 0.5, 2, (double)INFINITY};
    enum { MANY = sizeof list / sizeof *list };
    for (int predicate = 0; predicate < 16; predicate++) {
        for (int i = 0; i < MANY; i++) {
            for (int j = 0; j < MANY; j++) {
                int relation = i == j ? SAME : i > j ? GREATER : LESS;
                check(cagd_code_compare(list[i], list[j], predicate) == ((relation & predicate) != 0));
            }
            check(cagd_code_compare(list[i], (double)NAN, predicate) == ((8 & predicate) != 0));
            check(cagd_code_compare((double)NAN, list[i], predicate) == ((8 & predicate) != 0));
        }
        check(cagd_code_compare((double)NAN, (double)NAN, predicate) == ((8 & predicate) != 0));
        check(cagd_code_compare(cagd_code_div(2, 6), third, predicate) == ((SAME & predicate) != 0));
    }
}
static void signs_and_bits(void)
{
    const struct {
        double x;
        int below, sign;
    } list[] = {{cagd_code_div(-1, 3), 1, -1},
                {cagd_code_div(1, 3), 0, 1},
                {0, 0, 0},
                {-0.0, 1, 0},
                {-2, 1, -1},
                {2, 0, 1},
                {(double)INFINITY, 0, 1},
                {-(double)INFINITY, 1, -1},
                {(double)NAN, 0, 0},
                {-(double)NAN, 1, 0},
                {cagd_code_sub(1, 1), 0, 0}};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        check(cagd_code_sign_bits(list[k].x) == -list[k].below);
        check(cagd_code_sign(cagd_code_value_of(list[k].x)) == list[k].sign);
    }
    /* the sizes of numbers are all that of 1 */
    const double sizes[][2] = {{cagd_code_div(-1, 3), 1},
                               {-2, 1},
                               {1, 1},
                               {-(double)INFINITY, (double)INFINITY},
                               {(double)INFINITY, (double)INFINITY}};
    for (size_t k = 0; k < sizeof sizes / sizeof *sizes; k++) {
        int64_t wide;
        int32_t narrow;
        float single = (float)sizes[k][1];
        memcpy(&wide, &sizes[k][1], sizeof wide);
        memcpy(&narrow, &single, sizeof narrow);
        check(cagd_code_size_bits(sizes[k][0], 64) == wide);
        check(cagd_code_size_bits(sizes[k][0], 32) == narrow);
    }
}
static void what_has_no_order_is_as_in_binary64(void **state)
{
    (void)state;
    ends(specials, &in_rationals, CAGD_CODE_FINISHED, "");
    ends(comparisons, &in_rationals, CAGD_CODE_FINISHED, "");
    ends(signs_and_bits, &in_rationals, CAGD_CODE_FINISHED, "");
}

/* The integers nearest to quarters, of which the rounding chooses one. */
static enum cagd_code_numbers rounded_in;
static void roundings(void)
{
    for (int n = -18; n <= 18; n++) {
        double x = n / 4.;
        const struct {
            enum cagd_code_rounding how;
            double wanted;
        } list[] = {{CAGD_CODE_TRUNC, trunc(x)},
                    {CAGD_CODE_FLOOR, floor(x)},
                    {CAGD_CODE_CEIL, ceil(x)},
                    {CAGD_CODE_ROUND, round(x)},
                    {CAGD_CODE_EVEN, rint(x)}};
        for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
            cagd_code_value v = cagd_code_whole(cagd_code_value_of(x), list[k].how);
            check(cagd_equal_q(v.q, from_double_q(list[k].wanted)));
            check(rounded_in != CAGD_CODE_ROUNDING || v.d == list[k].wanted);
            check(v.shares == 0);
        }
    }
    check(isnan(cagd_code_whole(cagd_code_special((double)NAN), CAGD_CODE_FLOOR).d));
    check(cagd_code_whole(cagd_code_special(-(double)INFINITY), CAGD_CODE_CEIL).d == -(double)INFINITY);
}
static void numbers_are_rounded_in_five_ways(void **state)
{
    (void)state;
    for (rounded_in = CAGD_CODE_RATIONAL; rounded_in <= CAGD_CODE_ROUNDING; rounded_in++)
        ends(roundings, &(struct cagd_code_job){.numbers = rounded_in}, CAGD_CODE_FINISHED, "");
}

/* ---- texts and floats -------------------------------------------------------------------------------------- */

static void texts(void)
{
    check(strcmp(cagd_code_text(cagd_code_value_of(cagd_code_div(-3, 7))), "-3/7") == 0);
    check(strcmp(cagd_code_text(cagd_code_value_of(2)), "2") == 0);
    check(strcmp(cagd_code_text(cagd_code_special((double)INFINITY)), "inf") == 0);
    check(strcmp(cagd_code_field_text(cagd_code_special(-(double)INFINITY)), "-inf") == 0);
    check(strcmp(cagd_code_text(cagd_code_enclosed(cagd_hull_i(cagd_from_double_i(0.5), cagd_from_double_i(1.25)))),
                 "in [0.5, 1.25]") == 0);
    check(strcmp(cagd_code_field_text(cagd_code_value_of(cagd_code_div(-3, 7))), "-3/7") == 0);
    float third = cagd_code_narrow(cagd_code_div(1, 3)), half = cagd_code_narrow(0.5), tenth = cagd_code_narrow(0.1);
    check(half == 0.5f && cagd_code_widen(half) == 0.5); /* what is a float is one */
    check(cagd_equal_q(cagd_code_value_of(cagd_code_widen(third)).q, from_ratio_q(1, 3)));
    check(cagd_code_widen(tenth) == 0.1); /* what is none stays what it is */
    check(cagd_code_widen(0.1f) == (double)0.1f);
    check(cagd_code_narrow((double)INFINITY) == (float)INFINITY && isnan(cagd_code_narrow((double)NAN)));
    uint32_t bits, more;
    memcpy(&bits, &third, sizeof bits);
    memcpy(&more, &half, sizeof more);
    check(cagd_code_is_single(bits) && !cagd_code_is_single(more) && !cagd_code_is_single(bits + 7));
    double x = cagd_code_div(1, 3);
    uint64_t wide;
    memcpy(&wide, &x, sizeof wide);
    check(cagd_code_is_one(wide) && !cagd_code_is_one(wide + 1000) && !cagd_code_is_one(0));
}
static void in_floats_with_rounding(void)
{
    static const struct cagd_code_place here = {"a.c", "f", 3};
    cagd_code_at = &here;
    double third = cagd_code_div(1, 3);
    cagd_code_value v = cagd_code_value_of(cagd_code_widen(cagd_code_narrow(third)));
    check(v.d == (double)(float)(1 / 3.) && cagd_equal_q(v.q, from_ratio_q(1, 3)));
    double sum = 0;
    for (int k = 0; k < v.shares; k++)
        sum += v.share[k].amount;
    check(fabs(sum - to_double_q(cagd_sub_q(from_double_q(v.d), v.q))) < 1e-18 && sum != 0);
}
static const char *never;
static void never_computed(void)
{
    double x;
    float f;
    memset(&x, *never, sizeof x);
    memset(&f, *never, sizeof f);
    if (never[1] == 'd')
        cagd_code_value_of(x);
    else
        cagd_code_widen(f);
}
static void values_have_texts_and_floats(void **state)
{
    (void)state;
    ends(texts, &in_rationals, CAGD_CODE_FINISHED, "");
    ends(in_floats_with_rounding, &(struct cagd_code_job){.numbers = CAGD_CODE_ROUNDING}, CAGD_CODE_FINISHED, "");
    static const char *const list[][2] = {{"\xFF"
                                           "d",
                                           "a value that was never computed"},
                                          {"\xAA"
                                           "d",
                                           "a value that was never computed"},
                                          {"\xFE"
                                           "d",
                                           "a value from outside an array"},
                                          {"\xFF"
                                           "f",
                                           "a value that was never computed"},
                                          {"\xAA"
                                           "f",
                                           "a value that was never computed"},
                                          {"\xFE"
                                           "f",
                                           "a value from outside an array"}};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        never = list[k][0];
        ends(never_computed, &in_rationals, CAGD_CODE_REFUSED, list[k][1]);
    }
}
static double small_bits;
static void bits_of_an_integer(void) { cagd_code_value_of(small_bits); }
static void bits_of_integers_are_no_numbers(void **state)
{
    (void)state;
    static const uint64_t refused[] = {1, 5, 0xFFFFFFFF, 0x8000000000000001},
                          known[] = {0, 0x8000000000000000, 0x100000000};
    for (size_t k = 0; k < sizeof refused / sizeof *refused; k++) {
        memcpy(&small_bits, &refused[k], sizeof small_bits);
        ends(bits_of_an_integer, &in_rationals, CAGD_CODE_REFUSED, "the bits of an integer as a number");
    }
    for (size_t k = 0; k < sizeof known / sizeof *known; k++) {
        memcpy(&small_bits, &known[k], sizeof small_bits);
        ends(bits_of_an_integer, &in_rationals, CAGD_CODE_FINISHED, "");
    }
}

/* So many numbers are none too many, and one more is. */
static int how_many;
static void some_numbers(void)
{
    for (int k = 0; k < how_many; k++)
        cagd_code_div(1, 3);
}
static void so_many_bits(void) { cagd_code_number(cagd_code_constant(from_ratio_q(1, 1L << how_many))); }
static void bounds_are_those_of_the_job(void **state)
{
    (void)state;
    const struct cagd_code_job job = {.numbers = CAGD_CODE_RATIONAL, .most_values = 10, .most_bits = 22};
    for (how_many = 9; how_many <= 11; how_many++)
        ends(some_numbers, &job, how_many <= 10 ? CAGD_CODE_FINISHED : CAGD_CODE_BOUND, "more than 10 numbers");
    for (how_many = 19; how_many <= 22; how_many++) /* of 2^-n the denominator has n + 1 bits, the numerator one */
        ends(so_many_bits, &job, how_many <= 20 ? CAGD_CODE_FINISHED : CAGD_CODE_BOUND,
             "a number of more than 22 bits");
}

/* ---- the way --------------------------------------------------------------------------------------------- */

/* The paths of all decisions of up to four truths, each at one of two lines, are different ones. */
static void ways(void)
{
    enum { MOST = 4 };
    static unsigned long long seen[4 + 16 + 64 + 256];
    static const struct cagd_code_place line[2] = {{"a.c", "f", 3}, {"a.c", "f", 4}};
    int count = 0;
    for (int length = 1; length <= MOST; length++)
        for (int bits = 0; bits < 1 << (2 * length); bits++) {
            cagd_code_machine.outcome->path = 0;
            for (int k = 0; k < length; k++) {
                cagd_code_at = &line[bits >> (2 * k + 1) & 1];
                cagd_code_follow(bits >> (2 * k) & 1);
            }
            unsigned long long path = cagd_code_machine.outcome->path;
            for (int k = 0; k < count; k++)
                check(seen[k] != path);
            seen[count++] = path;
        }
    cagd_code_at = NULL;
    for (long n = -5; n <= 5; n++)
        for (long m = -5; m < n; m++) {
            unsigned long long first;
            cagd_code_machine.outcome->path = 1;
            cagd_code_follow(n);
            first = cagd_code_machine.outcome->path;
            cagd_code_machine.outcome->path = 1;
            cagd_code_follow(m);
            check(cagd_code_machine.outcome->path != first);
        }
}
static void ways_that_decide_otherwise_are_others(void **state)
{
    (void)state;
    ends(ways, &in_rationals, CAGD_CODE_FINISHED, "");
}

static const char *const at_x[] = {"1/3", "1/3", "3"};
static const int alike[] = {0, 0, 2};
static const struct cagd_code_input x_of_three = {"x", 3, at_x, alike, 1};

static void inputs(void)
{
    double x[3];
    cagd_code_input("x", 3, x);
    num_f f[3];
    for (int k = 0; k < 3; k++)
        f[k] = cagd_code_function(cagd_code_value_of(x[k]));
    check(cagd_equal_f(f[0], f[1]) && !cagd_equal_f(f[0], f[2]));
    check(cagd_equal_f(f[0], variable_f("x[0]")) && cagd_equal_f(f[2], variable_f("x[2]")));
}
static void inputs_that_are_alike_are_one_variable(void **state)
{
    (void)state;
    ends(inputs, &(struct cagd_code_job){.numbers = CAGD_CODE_FIELD, .inputs = 1, .input = &x_of_three},
         CAGD_CODE_FINISHED, "");
}

/* What is noted of a comparison is the sign of the difference. */
static double compared_with;
static void noted_order(void)
{
    double x[3];
    cagd_trace_open(1000);
    cagd_trace_values(cagd_code_value_at_point);
    cagd_code_input("x", 3, x);
    cagd_code_compare(x[2], compared_with, LESS);
    strncpy(cagd_code_machine.outcome->message, cagd_trace_steps(), 300);
}
static void noted_orders_are_signs(void **state)
{
    (void)state;
    const struct cagd_code_job job = {.numbers = CAGD_CODE_FIELD, .certify = 1, .inputs = 1, .input = &x_of_three};
    for (int with = 2; with <= 4; with += 2) {
        char wanted[20];
        compared_with = with;
        struct cagd_code_outcome *o = outcome_of(noted_order, &job);
        assert_int_equal(o->end, CAGD_CODE_FINISHED);
        snprintf(wanted, sizeof wanted, "\"is\":%d", with < 3 ? 1 : -1);
        if (strstr(o->message, "\"order\"") == NULL || strstr(o->message, wanted) == NULL)
            fail_msg("3 and %d: %s", with, o->message);
        cagd_code_outcome_free(o);
    }
}

/* ---- angles ----------------------------------------------------------------------------------------------- */

double cagd_code_lib_sin(double x);
double cagd_code_lib_cos(double x);
static void angles(void)
{
    double x[3];
    cagd_code_input("x", 3, x);
    double s = cagd_code_lib_sin(x[0]), c = cagd_code_lib_cos(x[0]);
    double near = 1e-15;
    check(fabs(cagd_code_real(cagd_code_value_of(s)) - sin(1 / 3.)) < near);
    check(fabs(cagd_code_real(cagd_code_value_of(c)) - cos(1 / 3.)) < near);
    check(fabs(cagd_code_real(cagd_code_value_of(cagd_code_lib_sin(x[2]))) - sin(3)) < near);
    check(fabs(cagd_code_real(cagd_code_value_of(cagd_code_lib_cos(x[2]))) - cos(3)) < near);
    double one = cagd_code_add(cagd_code_mul(s, s), cagd_code_mul(c, c));
    check(cagd_code_vanishes(sub_f(cagd_code_function(cagd_code_value_of(one)), from_int_f(1))));
}
static void angles_have_their_sine_and_cosine(void **state)
{
    (void)state;
    ends(angles, &(struct cagd_code_job){.numbers = CAGD_CODE_FIELD, .inputs = 1, .input = &x_of_three},
         CAGD_CODE_FINISHED, "");
}

/* ---- signs ------------------------------------------------------------------------------------------------ */

static num_f x, y;
static void two_variables(int p, int q)
{
    x = cagd_code_variable("x", from_int_q(p)).f;
    y = cagd_code_variable("y", from_int_q(q)).f;
}

/* What is known of f and of -f together: as sets of signs. */
static void both_ways(void)
{
    two_variables(1, 2);
    int c = 0;
    for (int first = 1; first < 8; first++)
        for (int second = 1; second < 8; second++) {
            num_f f = sub_f(x, from_int_f(c++)), minus = sub_f(from_int_f(c - 1), x);
            int turned = (second & SAME) | (second & LESS ? GREATER : 0) | (second & GREATER ? LESS : 0);
            int wanted = first & turned;
            int wanted_turned = (wanted & SAME) | (wanted & LESS ? GREATER : 0) | (wanted & GREATER ? LESS : 0);
            cagd_code_know_sign(f, first);
            cagd_code_know_sign(minus, second);
            check(cagd_code_signs_here(f) == wanted);
            check(cagd_code_signs_here(minus) == wanted_turned);
        }
}
static void a_sign_and_its_opposite_are_one_condition(void **state)
{
    (void)state;
    ends(both_ways, &in_field, CAGD_CODE_FINISHED, "");
}

/* Conditions a x + b y + c, and a product of such forms: the signs that it takes on a grid where they hold.  Point: of the run. */
struct form {
    int a, b, c, holding;
};
static const struct signs {
    struct form condition[3];
    int conditions, p, q;
    struct form factor[3];
    int factors, signs;
} * asked,
    of_products[] = {
        {{{1, 0, 0, GREATER}}, 1, 1, 2, {{1, 0, 0, 0}, {1, 0, 1, 0}}, 2, GREATER},
        {{{1, 0, 0, GREATER | SAME}}, 1, 1, 2, {{1, 0, 0, 0}, {1, 0, 1, 0}}, 2, GREATER | SAME},
        {{{1, 0, 0, GREATER | SAME}}, 1, 1, 2, {{1, 0, 1, 0}, {-1, 0, -2, 0}}, 2, LESS},
        {{{1, 0, -2, GREATER}, {1, 0, -1, GREATER}}, 2, 3, 0, {{1, 0, -1, 0}, {1, 0, -2, 0}}, 2, GREATER},
        {{{1, 0, -1, GREATER}, {1, 0, -2, GREATER}}, 2, 3, 0, {{1, 0, -1, 0}, {1, 0, -2, 0}}, 2, GREATER},
        {{{1, 0, -2, GREATER | SAME}, {1, 0, -1, GREATER}}, 2, 3, 0, {{1, 0, -1, 0}, {1, 0, -2, 0}}, 2, GREATER | SAME},
        {{{1, 0, -2, GREATER}, {1, 0, -2, GREATER | SAME}}, 2, 3, 0, {{1, 0, -1, 0}, {1, 0, -2, 0}}, 2, GREATER},
        {{{-1, 0, 2, LESS}, {1, 0, -1, GREATER}}, 2, 3, 0, {{1, 0, -1, 0}, {1, 0, -2, 0}}, 2, GREATER},
        {{{1, 0, 0, GREATER}, {-1, 1, 0, GREATER}}, 2, 1, 2, {{1, 1, 0, 0}, {1, -1, 0, 0}}, 2, LESS},
        {{{1, 0, 0, GREATER}, {-1, 1, 0, GREATER | SAME}}, 2, 1, 2, {{1, 1, 0, 0}, {1, -1, 0, 0}}, 2, LESS | SAME},
        {{{1, 0, 0, GREATER}, {1, -1, 0, LESS}}, 2, 1, 2, {{0, 1, 0, 0}, {-1, 1, 0, 0}, {1, 0, 0, 0}}, 3, GREATER},
        {{{0, 1, 0, GREATER}, {1, -1, 0, GREATER}}, 2, 2, 1, {{1, 1, 0, 0}, {1, -1, 0, 0}}, 2, GREATER},
        {{{1, 0, 0, GREATER}}, 1, 1, 2, {{1, 0, 0, 0}, {0, 1, 0, 0}}, 2, ANY},
        {{{1, 0, 0, GREATER}}, 1, 1, 2, {{1, 0, 0, 0}, {1, 0, -1, 0}}, 2, ANY}};

static num_f function_of(struct form f)
{
    return add_f(add_f(mul_f(from_int_f(f.a), x), mul_f(from_int_f(f.b), y)), from_int_f(f.c));
}
static int sign_of(long n) { return n == 0 ? SAME : n > 0 ? GREATER : LESS; }

static void signs_of_product(void)
{
    two_variables(asked->p, asked->q);
    for (int k = 0; k < asked->conditions; k++)
        cagd_code_know_sign(function_of(asked->condition[k]), asked->condition[k].holding);
    num_f f = from_int_f(1);
    for (int k = 0; k < asked->factors; k++)
        f = mul_f(f, function_of(asked->factor[k]));
    int told = cagd_code_signs_here(f), seen = 0;
    for (long i = -20; i <= 20; i++)
        for (long j = -20; j <= 20; j++) {
            int holds = 1;
            long value = 1;
            for (int k = 0; k < asked->conditions; k++) {
                struct form c = asked->condition[k];
                holds = holds && (sign_of(c.a * i + c.b * j + c.c * 2) & c.holding) != 0; /* of halves */
            }
            for (int k = 0; k < asked->factors; k++)
                value *= asked->factor[k].a * i + asked->factor[k].b * j + asked->factor[k].c * 2;
            seen |= holds ? sign_of(value) : 0;
        }
    check((seen & ~told) == 0); /* sound */
    check(seen == asked->signs && told == asked->signs);
}
static void signs_follow_from_conditions(void **state)
{
    (void)state;
    for (size_t k = 0; k < sizeof of_products / sizeof *of_products; k++) {
        asked = &of_products[k];
        ends(signs_of_product, &in_field, CAGD_CODE_FINISHED, "");
    }
}

/* Only what is said to be 0 is solved for a variable. */
static void zeros(void)
{
    for (int sign = 1; sign < 8; sign++) {
        char name[4] = {'v', (char)('0' + sign), 0};
        two_variables(1, 2);
        num_f v = cagd_code_variable(name, from_int_q(1)).f, f = sub_f(mul_f(from_int_f(2), v), add_f(x, y));
        cagd_code_know_sign(f, sign);
        check(cagd_code_vanishes_here(f) == (sign == SAME));
        check(cagd_code_vanishes_here(mul_f(f, add_f(x, v))) == (sign == SAME));
        check(!cagd_code_vanishes_here(add_f(f, from_int_f(1))));
        check(!cagd_code_vanishes_here(div_f(x, f)));
    }
}
static void what_is_said_to_be_zero_is_zero(void **state)
{
    (void)state;
    ends(zeros, &in_field, CAGD_CODE_FINISHED, "");
}

/* Each variable in which a function is linear with a number before it can be solved for, wherever it stands among others. */
static void solved(void)
{
    two_variables(1, 2);
    num_f z = cagd_code_variable("z", from_int_q(3)).f, v[] = {x, y, z}, variable, value;
    for (int k = 0; k < 3; k++) {
        num_f a = v[(k + 1) % 3], b = v[(k + 2) % 3];
        num_f f = sub_f(mul_f(from_int_f(-3), v[k]), add_f(mul_f(a, a), mul_f(a, mul_f(b, b)))); /* -3v = a^2 + a b^2 */
        check(cagd_code_solve(f, &variable, &value) && cagd_equal_f(variable, v[k]));
        check(cagd_is_zero_f(cagd_substitute_f(f, variable, value)));
        f = mul_f(v[k], add_f(a, from_int_f(1))); /* what stands before it is no number */
        check(!cagd_code_solve(f, &variable, &value));
        check(!cagd_code_solve(mul_f(v[k], v[k]), &variable, &value));
    }
    check(!cagd_code_solve(from_int_f(5), &variable, &value));
    num_q at;
    check(cagd_code_variable_count() == 3);
    for (int k = 0; k < 3; k++)
        check(cagd_equal_f(cagd_code_variable_at(k, &at), v[k]) && cagd_equal_q(at, from_int_q(k + 1)));
    cagd_code_variable("y", from_int_q(2)); /* the same once more */
    check(cagd_code_variable_count() == 3);
    check(cagd_equal_q(cagd_code_at_point(div_f(sub_f(x, z), add_f(y, from_int_f(1)))), from_ratio_q(-2, 3)));
    num_f r = cagd_code_new_root(add_f(x, from_int_f(1)), cagd_code_enclosed(cagd_root_i(2, cagd_from_int_i(2))), 1).f;
    num_f s = cagd_code_new_root(add_f(x, from_int_f(1)), cagd_code_enclosed(cagd_root_i(2, cagd_from_int_i(2))), 0).f,
          t = cagd_code_new_root(add_f(x, from_int_f(1)), cagd_code_enclosed(cagd_root_i(2, cagd_from_int_i(2))), 1).f;
    check(cagd_equal_f(r, t) && !cagd_equal_f(r, s));
    num_f without[] = {x, mul_f(x, y), div_f(x, z), from_int_f(2)},
          with[] = {r, mul_f(x, r), div_f(x, r), add_f(x, s), div_f(r, z)};
    for (int k = 0; k < 4; k++)
        check(!cagd_code_has_others(without[k]));
    for (int k = 0; k < 5; k++)
        check(cagd_code_has_others(with[k]) && cagd_code_at_point(with[k]).at == NULL);
    check(cagd_code_has_roots() && cagd_code_enclosed_count() == 2);
    /* what is 0 by the squares of roots, and what is not */
    num_f one = from_int_f(1), e = add_f(x, one);
    num_f zero[] = {sub_f(mul_f(r, r), e),
                    sub_f(mul_f(r, mul_f(r, r)), mul_f(e, r)),
                    sub_f(mul_f(s, s), mul_f(r, r)),
                    div_f(sub_f(mul_f(r, r), e), y),
                    sub_f(x, x),
                    sub_f(div_f(one, r), div_f(r, e))};
    num_f other[] = {r,
                     sub_f(r, s),
                     add_f(r, s),
                     sub_f(mul_f(r, r), x),
                     sub_f(mul_f(r, s), e),
                     sub_f(r, one),
                     sub_f(mul_f(r, mul_f(r, r)), r)};
    for (int k = 0; k < 6; k++)
        check(cagd_code_vanishes(zero[k]));
    for (int k = 0; k < 7; k++)
        check(!cagd_code_vanishes(other[k]));
}
static void functions_are_solved_and_roots_have_their_squares(void **state)
{
    (void)state;
    ends(solved, &in_field, CAGD_CODE_FINISHED, "");
}

/* What is divided by is told once, in its order, unless it cannot be 0; of a quotient its numerator. */
static void divisors(void)
{
    two_variables(1, 2);
    num_f one = from_int_f(1), d = sub_f(x, y);
    num_f list[] = {add_f(d, one),           d,       x, add_f(d, one), mul_f(x, y), d, x, y, div_f(x, add_f(y, one)),
                    add_f(x, from_int_f(5)), neg_f(x)};
    cagd_code_know_sign(y, GREATER);
    cagd_code_know_sign(add_f(x, from_int_f(5)), GREATER | LESS);
    for (size_t k = 0; k < sizeof list / sizeof *list; k++)
        cagd_code_note_divisor(list[k]);
    check(strcmp(cagd_code_machine.outcome->denominators, "x-y+1\nx-y\nx\nx*y\n-x\n") == 0);
}
static void what_is_divided_by_is_told_once(void **state)
{
    (void)state;
    ends(divisors, &in_field, CAGD_CODE_FINISHED, "");
}

/* Conditions as they are told: two names without a sign between them, each condition once, and a polynomial of the same sign, for which the
 * denominator counts as what is known of its sign. */
static int known_denominator; /* -1, 1; 0: nothing is known of it */
static void told_conditions(void)
{
    two_variables(1, known_denominator < 0 ? -2 : 2);
    double u = cagd_code_number(cagd_code_variable("x", from_int_q(1))),
           v = cagd_code_number(cagd_code_variable("y", from_int_q(known_denominator < 0 ? -2 : 2)));
    if (known_denominator != 0)
        cagd_code_compare(v, 0, LESS);
    for (int k = 0; k < 2; k++)
        cagd_code_compare(cagd_code_div(u, v), 3, GREATER);
    cagd_code_compare(u, v, SAME);
    cagd_code_compare(v, u, GREATER | SAME);
    cagd_code_compare(cagd_code_sub(u, v), 0, SAME); /* once more */
    const struct cagd_code_condition *c = cagd_code_machine.outcome->conditions;
    if (known_denominator != 0) {
        check(strcmp(c->left, "y") == 0 && strcmp(c->relation, known_denominator < 0 ? "<" : ">=") == 0 &&
              strcmp(c->right, "0") == 0);
        check(strcmp(c->polynomial, "y") == 0 && c->holding == (known_denominator < 0 ? LESS : GREATER | SAME));
        c = c->next;
    }
    check(strcmp(c->left, "x/y") == 0 && strcmp(c->relation, "<=") == 0 && strcmp(c->right, "3") == 0 &&
          c->holding == (LESS | SAME));
    const char *polynomial = known_denominator < 0 ? "-x+3*y" : known_denominator > 0 ? "x-3*y" : "x*y-3*y^2";
    check(strcmp(c->polynomial, polynomial) == 0);
    c = c->next;
    check(strcmp(c->left, "x") == 0 && strcmp(c->relation, "!=") == 0 && strcmp(c->right, "y") == 0 &&
          c->holding == (LESS | GREATER));
    check(strcmp(c->difference, "x-y") == 0 && strcmp(c->opposite, "-x+y") == 0 && strcmp(c->polynomial, "x-y") == 0);
    if (known_denominator >= 0) {
        c = c->next;
        check(strcmp(c->left, "y") == 0 && strcmp(c->relation, ">=") == 0 && strcmp(c->right, "x") == 0);
        check(strcmp(c->difference, "-x+y") == 0 && strcmp(c->opposite, "x-y") == 0 && !c->given);
    }
}
static void conditions_are_told_once(void **state)
{
    (void)state;
    for (known_denominator = -1; known_denominator <= 1; known_denominator++)
        ends(told_conditions, &in_field, CAGD_CODE_FINISHED, "");
}

/* What two functions are where others are 0, whatever the order of those conditions. */
static int conditions_turned;
static void equal_where(void)
{
    two_variables(1, 1);
    num_f z = cagd_code_variable("z", from_int_q(1)).f;
    num_f zero[] = {sub_f(x, y), sub_f(mul_f(from_int_f(2), z), add_f(x, y))}; /* x = y, 2z = x + y */
    for (int k = 0; k < 2; k++)
        cagd_code_know_sign(zero[conditions_turned ? 1 - k : k], SAME);
    cagd_code_know_sign(sub_f(x, from_int_f(7)), LESS);
    check(cagd_code_equal_here(x, y) && cagd_code_equal_here(z, y) && cagd_code_equal_here(mul_f(x, z), mul_f(y, y)));
    check(cagd_code_vanishes_here(sub_f(x, z)) && cagd_code_vanishes_here(sub_f(mul_f(z, z), mul_f(x, y))));
    check(!cagd_code_equal_here(x, from_int_f(7)) && !cagd_code_equal_here(x, neg_f(y)) && !cagd_code_vanishes_here(x));
    check(!cagd_code_vanishes_here(div_f(from_int_f(1), sub_f(x, y)))); /* a pole, where nothing is known */
}
static void functions_are_equal_where_others_are_zero(void **state)
{
    (void)state;
    for (conditions_turned = 0; conditions_turned < 2; conditions_turned++)
        ends(equal_where, &in_field, CAGD_CODE_FINISHED, "");
}

/* ---- objects ---------------------------------------------------------------------------------------------- */

enum { SIZE = 16, BEFORE = 8, BEHIND = 64 };
static char room[256];
static long reached_at, reached_bytes;
static void reach(void)
{
    cagd_code_object(room + 100, SIZE, BEFORE, BEHIND, "it", CAGD_CODE_MEMORY);
    cagd_code_reach(room + 100 + reached_at, reached_bytes, 0);
}
/* Wherever it begins within the margins, it is refused unless it is all within the object; beyond them it is nobody's. */
static void objects_have_their_margins(void **state)
{
    (void)state;
    for (reached_at = -BEFORE - 4; reached_at <= SIZE + BEHIND + 4; reached_at++)
        for (reached_bytes = 1; reached_bytes <= SIZE + 1; reached_bytes += 5) {
            int is_inside = reached_at >= 0 && reached_at + reached_bytes <= SIZE,
                is_far = reached_at < -BEFORE || reached_at >= SIZE + BEHIND;
            char wanted[100];
            if (reached_at < 0)
                snprintf(wanted, sizeof wanted, "a value from outside an array: %ld bytes before the beginning of it,",
                         -reached_at);
            else if (reached_at >= SIZE)
                snprintf(wanted, sizeof wanted, "a value from outside an array: %ld bytes behind the end of it,",
                         reached_at - SIZE);
            else
                snprintf(wanted, sizeof wanted, "a value from outside an array: %ld bytes from byte %ld of it on,",
                         reached_bytes, reached_at);
            ends(reach, &in_rationals, is_inside || is_far ? CAGD_CODE_FINISHED : CAGD_CODE_REFUSED, wanted);
        }
}

/* A variable that ends at or below the frame of what is called now belonged to a function that has returned.  Frames are multiples of
 * 16 bytes: the last end at which it is gone is one. */
static long ends_above;
static void variable_near_the_frame(void)
{
    char *here = __builtin_frame_address(0);
    char *end = here - (uintptr_t)here % 16 - 512 + ends_above;
    cagd_code_local(end - 64, 64, 0, "v");
    cagd_code_reach(end - 32, 8, 0);
}
static void variables_end_with_their_function(void **state)
{
    (void)state;
    long last_gone = -1;
    for (ends_above = 0; ends_above <= 640; ends_above++) {
        struct cagd_code_outcome *o = outcome_of(variable_near_the_frame, &in_rationals);
        if (o->end == CAGD_CODE_REFUSED) {
            assert_non_null(strstr(o->message, "a variable of a function that has returned"));
            assert_int_equal(last_gone, ends_above - 1);
            last_gone = ends_above;
        } else {
            assert_int_equal(o->end, CAGD_CODE_FINISHED);
        }
        cagd_code_outcome_free(o);
    }
    assert_in_range(last_gone, 0, 639);
    assert_int_equal(last_gone % 16, 0);
}

static long released;
static void release(const char *start, size_t before)
{
    (void)start;
    released += before == 16;
}
/* Memory that is given back goes to the system when there are 2^14 pieces of it, or 2^28 bytes, margins included. */
static void give_back(void)
{
    char *at = (char *)(uintptr_t)0x100000000000, *first = at, *last = at + ((size_t)1 << 40);
    size_t size;
    cagd_code_object(first, 32, 16, 16, NULL, CAGD_CODE_MEMORY); /* what is not given back stays, before and behind */
    cagd_code_object(last, 48, 16, 16, NULL, CAGD_CODE_MEMORY);
    at += 64;
    for (long k = 0; k < 1 << 14; k++, at += 64) {
        check(released == 0);
        cagd_code_object(at, 32, 16, 16, NULL, CAGD_CODE_MEMORY);
        cagd_code_memory_dies(at, release);
    }
    check(released == 1 << 14 && cagd_code_memory_count() == 2);
    released = 0;
    const size_t quarter = (size_t)1 << 26;
    for (int k = 0; k < 4; k++, at += quarter) {
        check(released == 0);
        cagd_code_object(at, quarter - 32, 16, 16, NULL, CAGD_CODE_MEMORY);
        cagd_code_memory_dies(at, release);
    }
    check(released == 4 && cagd_code_memory_count() == 2);
    check(cagd_code_memory_at(first, &size) && size == 32);
    check(cagd_code_memory_at(last, &size) && size == 48);
    check(!cagd_code_memory_at(first + 64, &size)); /* what was released is nobody's */
}
static void memory_goes_back_to_the_system(void **state)
{
    (void)state;
    ends(give_back, &in_rationals, CAGD_CODE_FINISHED, "");
}

/* ---- what rounding costs in functions -------------------------------------------------------------------------- */

#define FUNCTIONS(F)                                                                                                   \
    F(fabs)                                                                                                            \
    F(sqrt)                                                                                                            \
    F(cbrt)                                                                                                            \
    F(exp)                                                                                                             \
    F(exp2)                                                                                                            \
    F(expm1)                                                                                                           \
    F(log)                                                                                                             \
    F(log2)                                                                                                            \
    F(log10)                                                                                                           \
    F(log1p)                                                                                                           \
    F(sin) F(cos) F(tan) F(asin) F(acos) F(atan) F(sinh) F(cosh) F(tanh) F(floor) F(ceil) F(trunc) F(round) F(rint)
#define PROTOTYPE(name) double cagd_code_lib_##name(double x);
FUNCTIONS(PROTOTYPE)
#undef PROTOTYPE
double cagd_code_lib_fmin(double x, double y), cagd_code_lib_fmax(double x, double y),
    cagd_code_lib_fdim(double x, double y);
double cagd_code_lib_copysign(double x, double y), cagd_code_lib_fmod(double x, double y),
    cagd_code_lib_remainder(double x, double y);
double cagd_code_lib_hypot(double x, double y), cagd_code_lib_atan2(double x, double y),
    cagd_code_lib_fma(double x, double y, double z);
double cagd_code_lib_ldexp(double x, int n), cagd_code_lib_frexp(double x, int *n),
    cagd_code_lib_modf(double x, double *whole);

/* The binary64 less the exact number is the sum of what arose at each line, but for a rounding of the function itself where it is allowed; and
 * the binary64 is that of the C library. */
static double of_size = 1e-6; /* by which the slope of a function is known */
static void shares_are(double number, double computed, double allowed)
{
    cagd_code_value v = cagd_code_value_of(number);
    double sum = 0, size = 0, error;
    for (int k = 0; k < v.shares; k++)
        sum += v.share[k].amount, size += fabs(v.share[k].amount);
    if (v.q.at != NULL)
        error = to_double_q(cagd_sub_q(from_double_q(v.d), v.q));
    else
        error = cagd_code_real(cagd_code_enclosed(cagd_sub_i(cagd_from_double_i(v.d), v.i)));
    check(v.d == computed);
    if (!(fabs(sum - error) <= of_size * size + allowed * fabs(computed) * 0x1p-52))
        cagd_code_stop(CAGD_CODE_CRASHED, "%.17g: %g of %g", computed, sum, error);
}
static int from_line;
static double quotient(int p, int q)
{
    static const struct cagd_code_place place[] = {{"a.c", "f", 1}, {"a.c", "f", 2}, {"a.c", "f", 3}, {"a.c", "f", 4}};
    cagd_code_at = &place[from_line++ % 4];
    double made = cagd_code_div(p, q);
    cagd_code_at = &place[from_line % 4];
    return made;
}
static void costs_of_functions(void)
{
    static const int list[][2] = {{1, 3}, {-1, 3}, {2, 7}, {-5, 11}, {27, 49}};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        int p = list[k][0], q = list[k][1], n;
        double a = quotient(p, q), b = quotient(5, 7), c = quotient(-3, 13), u = (double)p / q, v = 5. / 7,
               w = -3. / 13, whole;
#define ONE(name)                                                                                                      \
    if (isfinite(name(u)))                                                                                             \
        shares_are(cagd_code_lib_##name(a), name(u), 1);
        FUNCTIONS(ONE)
#undef ONE
        shares_are(cagd_code_lib_fmin(a, b), fmin(u, v), 0);
        shares_are(cagd_code_lib_fmax(a, b), fmax(u, v), 0);
        shares_are(cagd_code_lib_fdim(b, a), fdim(v, u), 0);
        shares_are(cagd_code_lib_copysign(a, c), copysign(u, w), 0);
        shares_are(cagd_code_lib_fmod(cagd_code_mul(a, 7), b), fmod(u * 7, v), 0);
        shares_are(cagd_code_lib_remainder(cagd_code_mul(a, 7), b), remainder(u * 7, v), 0);
        shares_are(cagd_code_lib_sqrt(b), sqrt(v), 0);
        shares_are(cagd_code_lib_hypot(a, b), sqrt(u * u + v * v), 0);
        shares_are(cagd_code_lib_atan2(a, b), atan(u / v), 1);
        shares_are(cagd_code_lib_fma(a, b, c), fma(u, v, w), 0);
        shares_are(cagd_code_lib_fma(a, b, cagd_code_neg(cagd_code_mul(a, b))), fma(u, v, -(u * v)), 0);
        shares_are(cagd_code_lib_ldexp(a, 30), ldexp(u, 30), 0);
        shares_are(cagd_code_lib_frexp(a, &n), frexp(u, &n), 0);
        shares_are(cagd_code_lib_modf(cagd_code_mul(a, 7), &whole), modf(u * 7, &v), 0);
        shares_are(cagd_code_power(a, 5), u * ((u * u) * (u * u)), 0);
        shares_are(cagd_code_power(a, -2), 1 / (u * u), 0);
        shares_are(cagd_code_widen(cagd_code_narrow(a)), (double)(float)u, 0);
        shares_are(cagd_code_neg(a), -u, 0);
        shares_are(cagd_code_sub(cagd_code_mul(a, 3), b), u * 3 - 5. / 7, 0);
    }
    /* exactly, though the product alone would be rounded */
    shares_are(cagd_code_lib_fma(1 + 0x1p-30, 1 - 0x1p-30, -1), -0x1p-60, 0);
    shares_are(cagd_code_lib_fmod(1e17, 0.1), fmod(1e17, 0.1), 0);
    shares_are(cagd_code_lib_remainder(1e17, 0.1), remainder(1e17, 0.1), 0);
    for (int k = 50; k < 64; k++)
        for (int d = -3; d <= 3; d++) {
            uint64_t n = ((uint64_t)1 << k) + (uint64_t)d;
            shares_are(cagd_code_from_unsigned(n), (double)n, 0);
            if (k < 63)
                shares_are(cagd_code_from_signed(-(int64_t)n), -(double)n, 0);
        }
}
/* A comparison is turned by rounding where its answer is another one; the first is told. */
static void turned_comparisons(void)
{
    static const struct cagd_code_place place[] = {{"a.c", "f", 1}, {"a.c", "f", 2}, {"a.c", "g", 3}};
    struct cagd_code_outcome *o = cagd_code_machine.outcome;
    static const double exact[] = {1, 0.5, 2}, computed[] = {1, 0.5, 2};
    long turned = 0;
    for (int predicate = 0; predicate < 16; predicate++)
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++) {
                double number =
                    cagd_code_number((cagd_code_value){.q = from_double_q(exact[i]), .d = computed[j], .made = 1});
                int is = exact[i] == 1  ? SAME
                         : exact[i] > 1 ? GREATER
                                        : LESS,
                    seems = computed[j] == 1  ? SAME
                            : computed[j] > 1 ? GREATER
                                              : LESS;
                cagd_code_at = &place[turned < 2 ? 0 : 1 + (turned > 3)];
                check(cagd_code_compare(number, 1, predicate) == ((seems & predicate) != 0)); /* as the code decides */
                int is_turned = ((is & predicate) != 0) != ((seems & predicate) != 0);
                turned += is_turned;
                check(o->decided_otherwise == turned);
            }
    check(turned > 20 && o->turned.line == 1 && strcmp(o->turned.file, "a.c") == 0 &&
          strcmp(o->turned.function, "f") == 0);
}

/* Of a result what is told: its error in ulps, and the line with most of it, whatever the signs. */
static void told_results(void)
{
    static const struct cagd_code_place place[] = {{"a.c", "f", 1}, {"a.c", "f", 2}, {"b.c", "f", 3}};
    static const double amounts[][3] = {{0x1p-54, -3 * 0x1p-54, 0x1p-54},
                                        {0x1p-54, 3 * 0x1p-54, -0x1p-54},
                                        {3 * 0x1p-54, 0x1p-54, 0x1p-54},
                                        {-0x1p-54, 0x1p-54, -3 * 0x1p-54}};
    static const int worst[] = {1, 1, 0, 2};
    double list[4];
    for (int k = 0; k < 4; k++) {
        struct cagd_code_share *share = cagd_region_array(3, 1, sizeof *share);
        double sum = 0;
        for (int j = 0; j < 3; j++)
            share[j] = (struct cagd_code_share){&place[j], amounts[k][j]}, sum += amounts[k][j];
        list[k] = cagd_code_number(
            (cagd_code_value){.q = sub_q(from_int_q(3), from_double_q(sum)), .d = 3, .share = share, .shares = 3});
    }
    cagd_code_output("r", 4, list);
    cagd_code_output("s", 1, list + 1);
    const struct cagd_code_result *r = cagd_code_machine.outcome->results;
    for (int k = 0; k < 5; k++, r = r->next) {
        char name[8], line[8];
        int of = k < 4 ? k : 1;
        double sum = 0;
        for (int j = 0; j < 3; j++)
            sum += amounts[of][j];
        snprintf(name, sizeof name, k < 4 ? "r[%d]" : "s", k);
        snprintf(line, sizeof line, "%s:%d", place[worst[of]].file, place[worst[of]].line);
        check(strcmp(r->name, name) == 0 && strcmp(r->worst_line, line) == 0);
        check(r->computed == 3 && r->worst_part == 0.6 && r->wanted == NULL);
        check(r->ulps == fabs(sum) / 0x1p-51); /* 3 has ulps of 2^-51 */
        for (int order = 0; order < CAGD_CODE_ORDERS; order++)
            check(r->in_order[order] == r->ulps);
    }
    check(r == NULL);
    cagd_code_at = &place[0];
    double nothing = cagd_code_sub(cagd_code_div(1, 3), cagd_code_div(1, 3)), special = (double)INFINITY;
    cagd_code_output("zero", 1, &nothing);
    cagd_code_output("infinite", 1, &special);
    for (r = cagd_code_machine.outcome->results; strcmp(r->name, "zero") != 0;)
        r = r->next;
    check(r->ulps == 0 && r->worst_line == NULL && strcmp(r->got, "0") == 0);
    check(strcmp(r->next->got, "inf") == 0 && r->next->worst_line == NULL);
}

/* Of an argument that is far from exact the error goes through with the slope, where the function has one. */
static void errors_of_arguments(void)
{
    static const struct cagd_code_place here = {"a.c", "f", 1};
    static const int list[][2] = {{1, 3}, {-1, 3}, {2, 7}, {-5, 11}, {27, 49}, {6, 7}};
    cagd_code_at = &here;
    of_size = 0x1p-8;
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        cagd_code_value v = {.q = from_ratio_q(list[k][0], list[k][1])};
        v.d = (double)list[k][0] / list[k][1] * (1 + 0x1p-16);
        struct cagd_code_share share = {&here, to_double_q(sub_q(from_double_q(v.d), v.q))};
        v.share = &share, v.shares = 1;
        double a = cagd_code_number(v);
#define ONE(name)                                                                                                      \
    if (isfinite(name(v.d)))                                                                                           \
        shares_are(cagd_code_lib_##name(a), name(v.d), 1);
        FUNCTIONS(ONE)
#undef ONE
    }
    for (int n = -7; n <= 7; n++) /* beside a half, where the binary64 is on the other side of it */
        for (int side = -1; side <= 1; side += 2) {
            cagd_code_value v = {.q = from_ratio_q(n, 2), .d = n / 2. + side * 0x1p-40};
            struct cagd_code_share share = {&here, side * 0x1p-40};
            v.share = &share, v.shares = 1;
            double a = cagd_code_number(v);
            shares_are(cagd_code_lib_floor(a), floor(v.d), 0);
            shares_are(cagd_code_lib_ceil(a), ceil(v.d), 0);
            shares_are(cagd_code_lib_trunc(a), trunc(v.d), 0);
            shares_are(cagd_code_lib_round(a), round(v.d), 0);
            shares_are(cagd_code_lib_rint(a), rint(v.d), 0);
            shares_are(cagd_code_lib_fmod(a, 1), fmod(v.d, 1), 0);
            shares_are(cagd_code_lib_remainder(a, 1), remainder(v.d, 1), 0);
            if (n != 0)
                shares_are(cagd_code_lib_fabs(a), fabs(v.d), 0);
        }
    double e = cagd_code_sub(cagd_code_div(1, 3), cagd_code_div(1, 3)); /* 0 */
    shares_are(cagd_code_lib_exp(e), 1, 0);
}
static void functions_pass_errors_on(void **state)
{
    (void)state;
    ends(costs_of_functions, &(struct cagd_code_job){.numbers = CAGD_CODE_ROUNDING}, CAGD_CODE_FINISHED, "");
    ends(turned_comparisons, &(struct cagd_code_job){.numbers = CAGD_CODE_ROUNDING}, CAGD_CODE_FINISHED, "");
    ends(told_results, &(struct cagd_code_job){.numbers = CAGD_CODE_ROUNDING}, CAGD_CODE_FINISHED, "");
    ends(errors_of_arguments, &(struct cagd_code_job){.numbers = CAGD_CODE_ROUNDING}, CAGD_CODE_FINISHED, "");
}

/* Elements and the one behind the last, of which only the address is taken. */
static long index_of, count_of;
static int index_is_used;
static void element(void) { cagd_code_index(index_of, count_of, index_is_used); }
static void indices_are_those_of_the_array(void **state)
{
    (void)state;
    for (count_of = 0; count_of <= 3; count_of++)
        for (index_of = -2; index_of <= 5; index_of++)
            for (index_is_used = 0; index_is_used < 2; index_is_used++) {
                char message[100];
                int is_good = index_of >= 0 && (index_is_used ? index_of < count_of : index_of <= count_of);
                snprintf(message, sizeof message, "a value from outside an array: element %ld of %ld", index_of,
                         count_of);
                ends(element, &in_rationals, is_good ? CAGD_CODE_FINISHED : CAGD_CODE_REFUSED, message);
            }
}

/* Two objects, at 100 and at 1100, and one of the libraries at 2000: where steps from one address to another lead. */
static char places[4096];
static const struct walk {
    int from[3], to[3], reached; /* -1: no step, or nothing is read at last */
    const char *message;         /* NULL: none */
} * walked,
    walks[] = {{{100, -1}, {108, -1}, 108, NULL},
               {{100, -1}, {116, -1}, -1, NULL},
               {{100, -1},
                {116, -1},
                116,
                "a value from outside an array: 0 bytes behind the end of first, which has 16 bytes"},
               {{100, -1},
                {92, -1},
                92,
                "a value from outside an array: 8 bytes before the beginning of first, which has 16 bytes"},
               {{100, -1}, {600, -1}, -1, NULL},
               {{100, -1},
                {600, -1},
                600,
                "a value from outside an array: 484 bytes behind the end of first, which has 16 bytes"},
               {{1100, -1},
                {600, -1},
                600,
                "a value from outside an array: 500 bytes before the beginning of second, which has 32 bytes"},
               {{100, 600, -1}, {600, 108, -1}, 108, NULL}, /* back again */
               {{100, 600, 604}, {600, 604, 112}, 112, NULL},
               {{100, 600, -1},
                {600, 1100, -1},
                -1,
                "an address far outside an array: 984 bytes behind the end of first, which has 16 bytes"},
               {{100, -1},
                {1100, -1},
                -1,
                "an address far outside an array: 984 bytes behind the end of first, which has 16 bytes"},
               {{1100, -1},
                {100, -1},
                -1,
                "an address far outside an array: 1000 bytes before the beginning of second, which has 32 bytes"},
               {{2000, -1}, {100, -1}, -1, "an address far outside an array: computed from one that is in none"},
               {{2000, -1}, {2008, -1}, 2008, NULL},
               {{100, 1100, -1}, {600, 600, -1}, -1, "an address far outside of two arrays"},
               {{100, 100, -1}, {600, 600, -1}, -1, NULL},
               {{100, 2000, -1}, {600, 600, -1}, 600, NULL}}; /* now of the libraries */
static void walk(void)
{
    static const struct cagd_code_place here = {"a.c", "f", 3};
    cagd_code_object(places + 100, 16, 8, 16, "first", CAGD_CODE_MEMORY);
    cagd_code_object(places + 1100, 32, 8, 16, "second", CAGD_CODE_MEMORY);
    cagd_code_at = &here;
    for (int k = 0; k < 3 && walked->from[k] > 0; k++)
        cagd_code_step(places + walked->from[k], places + walked->to[k]);
    if (walked->reached > 0)
        cagd_code_reach(places + walked->reached, 4, 0);
}
static void many_strays(void)
{
    cagd_code_object(places + 100, 16, 8, 16, "first", CAGD_CODE_MEMORY);
    cagd_code_object(places + 3900, 16, 8, 16, "second", CAGD_CODE_MEMORY);
    for (int k = 200; k < 3800; k++)
        cagd_code_step(places + (k % 3 ? 100 : 3900), places + k);
    for (int k = 200; k < 3800; k++) /* each belongs where it came from */
        cagd_code_step(places + k, places + (k % 3 ? 100 : 3900));
}
static void addresses_belong_where_they_come_from(void **state)
{
    (void)state;
    for (size_t k = 0; k < sizeof walks / sizeof *walks; k++) {
        walked = &walks[k];
        ends(walk, &in_rationals, walked->message == NULL ? CAGD_CODE_FINISHED : CAGD_CODE_REFUSED, walked->message);
    }
    ends(many_strays, &in_rationals, CAGD_CODE_FINISHED, "");
}

static int together[2], is_dead, is_written;
static void are_compared(void)
{
    cagd_code_object(places + 100, 16, 8, 16, "first", CAGD_CODE_MEMORY);
    cagd_code_object(places + 1100, 32, 8, 16, "second", CAGD_CODE_MEMORY);
    cagd_code_together(together[0] ? places + together[0] : NULL, together[1] ? places + together[1] : NULL);
}
static void addresses_of_two_objects_have_no_order(void **state)
{
    (void)state;
    static const struct {
        int a, b, refused;
    } list[] = {{100, 108, 0}, {100, 1100, 1}, {1108, 104, 1}, {100, 2000, 1}, {2000, 3000, 0},
                {0, 100, 0},   {100, 0, 0},    {100, 100, 0},  {1100, 1132, 0}};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++)
        for (int one_object = 0; one_object < 2; one_object++) {
            const struct cagd_code_job job = {.numbers = CAGD_CODE_RATIONAL, .one_object = one_object};
            together[0] = list[k].a, together[1] = list[k].b;
            ends(are_compared, &job, one_object && list[k].refused ? CAGD_CODE_REFUSED : CAGD_CODE_FINISHED,
                 "addresses of different arrays are compared");
        }
}

/* What is said of objects with and without a name, and with the place at which they were made. */
static const char *object_name;
static int object_has_place;
static enum cagd_code_life object_life;
static void put_outside(void)
{
    static const struct cagd_code_place here = {"a.c", "f", 3};
    cagd_code_at = object_has_place ? &here : NULL;
    cagd_code_object(places + 100, 16, 8, 16, object_name, object_life);
    if (is_dead)
        cagd_code_memory_dies(places + 100, release);
    cagd_code_reach(places + 100 + (is_dead ? 4 : 16), 4, is_written);
}
static void objects_are_called_by_their_names(void **state)
{
    (void)state;
    for (int named = 0; named < 3; named++)
        for (object_has_place = 0; object_has_place < 2; object_has_place++)
            for (int memory = 0; memory < 2; memory++)
                for (is_written = 0; is_written < 2; is_written++)
                    for (is_dead = 0; is_dead <= memory; is_dead++) {
                        char what[50], wanted[200];
                        object_name = named == 2 ? "it" : named == 1 ? "" : NULL;
                        object_life = memory ? CAGD_CODE_MEMORY : CAGD_CODE_GLOBAL;
                        snprintf(what, sizeof what, "%s%s",
                                 named == 2         ? "it"
                                 : !memory          ? "a variable"
                                 : object_has_place ? "the memory"
                                                    : "memory",
                                 named < 2 && object_has_place ? " of a.c:3" : "");
                        if (is_dead)
                            snprintf(wanted, sizeof wanted,
                                     "%s memory that was given back: 4 bytes from byte 4 of %s on, which has 16 bytes",
                                     is_written ? "something is put into" : "a value from", what);
                        else
                            snprintf(wanted, sizeof wanted,
                                     "%s outside an array: 0 bytes behind the end of %s, which has 16 bytes",
                                     is_written ? "something is put" : "a value from", what);
                        ends(put_outside, &in_rationals, CAGD_CODE_REFUSED, wanted);
                    }
}

/* The first variable of static storage that is put into is told of, by the code and by others. */
static const struct kept {
    const char *name, *called;
    int by_code, entered;
} * kept_now,
    kept[] = {
        {"n", "n", 1, 1},       {"f.calls", "calls", 1, 1}, {"f.calls.2", "calls", 1, 1}, {"calls.12", "calls", 1, 1},
        {"a.b.c3", "c3", 1, 1}, {"n", "n", 0, 1},           {"f.calls.2", "calls", 0, 1}, {"n", "", 1, 0},
        {"n", "", 2, 1}};
static void put_into_static(void)
{
    static const struct cagd_code_place here = {"a.c", "f", 7};
    static char one[16], two[16], three[8];
    cagd_code_at = &here;
    cagd_code_global(one, sizeof one, 0, "untouched");
    cagd_code_global(two, sizeof two, 0, kept_now->name);
    cagd_code_global(three, sizeof three, 0, "later");
    if (kept_now->entered)
        cagd_code_watch_globals();
    if (kept_now->by_code == 1) {
        cagd_code_reach(two + 8, 8, 1);
        cagd_code_reach(three, 8, kept_now->entered);
    } else if (kept_now->by_code == 0) {
        two[15] = 1;
    } else {
        cagd_code_reach(two + 8, 8, 0);
    }
    if (kept_now->entered)
        cagd_code_compare_globals();
}
static void what_is_kept_is_told(void **state)
{
    (void)state;
    for (size_t k = 0; k < sizeof kept / sizeof *kept; k++) {
        kept_now = &kept[k];
        struct cagd_code_outcome *o = outcome_of(put_into_static, &in_rationals);
        assert_int_equal(o->end, CAGD_CODE_FINISHED);
        assert_string_equal(o->kept, kept[k].called);
        assert_int_equal(o->kept_line, kept[k].by_code == 1 && kept[k].entered ? 7 : 0);
        cagd_code_outcome_free(o);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {unit(nothing_is_divided_by_zero),
                                       unit(a_power_ends_where_it_has_too_many_bits),
                                       unit(powers_are_products),
                                       unit(classes_are_those_of_the_number),
                                       unit(integers_have_their_ranges),
                                       unit(what_has_no_order_is_as_in_binary64),
                                       unit(numbers_are_rounded_in_five_ways),
                                       unit(values_have_texts_and_floats),
                                       unit(bits_of_integers_are_no_numbers),
                                       unit(bounds_are_those_of_the_job),
                                       unit(ways_that_decide_otherwise_are_others),
                                       unit(inputs_that_are_alike_are_one_variable),
                                       unit(noted_orders_are_signs),
                                       unit(angles_have_their_sine_and_cosine),
                                       unit(a_sign_and_its_opposite_are_one_condition),
                                       unit(signs_follow_from_conditions),
                                       unit(what_is_said_to_be_zero_is_zero),
                                       unit(functions_are_solved_and_roots_have_their_squares),
                                       unit(what_is_divided_by_is_told_once),
                                       unit(conditions_are_told_once),
                                       unit(functions_are_equal_where_others_are_zero),
                                       unit(objects_have_their_margins),
                                       unit(variables_end_with_their_function),
                                       unit(functions_pass_errors_on),
                                       unit(indices_are_those_of_the_array),
                                       unit(addresses_belong_where_they_come_from),
                                       unit(addresses_of_two_objects_have_no_order),
                                       unit(objects_are_called_by_their_names),
                                       unit(what_is_kept_is_told),
                                       unit(memory_goes_back_to_the_system)};
    return run_unit_tests(tests);
}
