/* operations.c -- arithmetic, order and conversions of values; see value.h and machine.h. */
#include "exact/code/orders.h"
#include "exact/code/value.h"
#include "exact/number/recorder.h"
#include "exact/record/trace.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { SAME = 1, GREATER = 2, LESS = 4, UNORDERED = 8, MOST_IN_CONDITION = 2000, MOST_IN_POLYNOMIAL = 40000 };

/* ---- what rounding cost ------------------------------------------------------------------------------ */

double cagd_code_real(cagd_code_value v)
{
    if (v.special)
        return v.d;
    return v.q.at != NULL ? cagd_to_double_q(v.q) : cagd_lower_i(v.i) / 2 + cagd_upper_i(v.i) / 2;
}

static int add_share(struct cagd_code_share share[], int count, const struct cagd_code_place *place, double amount)
{
    if (amount == 0)
        return count;
    for (int k = 0; k < count; k++)
        if (share[k].place->line == place->line && strcmp(share[k].place->file, place->file) == 0) {
            share[k].amount += amount;
            return count;
        }
    share[count] = (struct cagd_code_share){place, amount};
    return count + 1;
}

void cagd_code_shared(cagd_code_value *v, cagd_code_value a, double c, cagd_code_value b, double e, double rounded)
{
    v->made = 0;
    if (a.shares + b.shares == 0 && rounded == 0)
        return;
    struct cagd_code_share *share = cagd_region_array(a.shares + b.shares + 1, 1, sizeof *share);
    cagd_code_check_faults();
    int count = 0;
    for (int k = 0; k < a.shares; k++)
        count = add_share(share, count, a.share[k].place, c * a.share[k].amount);
    for (int k = 0; k < b.shares; k++)
        count = add_share(share, count, b.share[k].place, e * b.share[k].amount);
    v->shares = add_share(share, count, cagd_code_at, rounded);
    v->share = share;
}

/* ---- arithmetic --------------------------------------------------------------------------------------- */

struct arithmetic {
    cagd_num_q (*q)(cagd_num_q, cagd_num_q);
    cagd_num_i (*i)(cagd_num_i, cagd_num_i);
    cagd_num_f (*f)(cagd_num_f, cagd_num_f);
};

static const void *operation; /* where the code called for arithmetic last */

/* The result becomes known, where the job asks for it. */
static void note_result(cagd_code_value v)
{
    enum { MOST_RESULTS = 1 << 12 };
    static struct cagd_code_computed *last;
    static long count;
    struct cagd_code_outcome *o = cagd_code_machine.outcome;
    if (!cagd_code_machine.job->note_results || ++count > MOST_RESULTS) {
        o->computed = NULL; /* some are not all */
        return;
    }
    struct cagd_code_computed *c = cagd_code_room(sizeof *c);
    const char *file = cagd_code_at != NULL ? cagd_code_at->file : "";
    int line = cagd_code_at != NULL ? (int)cagd_code_at->line : 0,
        is_near = last != NULL && strcmp(last->file, file) == 0;
    *c = (struct cagd_code_computed){NULL, cagd_code_keep(cagd_code_text(v)),
                                     is_near ? last->file : cagd_code_keep(file), line, (uintptr_t)operation};
    *(last != NULL ? &last->next : &o->computed) = c;
    last = c;
}

/* All parts but the binary64. */
static cagd_code_value combine(const struct arithmetic *o, cagd_code_value a, cagd_code_value b)
{
    const enum cagd_code_numbers numbers = cagd_code_machine.job->numbers;
    cagd_code_value v = {.special = 0};
    cagd_code_machine.outcome->operations++;
    int at_point = a.f.at != NULL || b.f.at != NULL; /* what happens at the point is not noted */
    if (at_point)
        cagd_trace_pause();
    if (numbers != CAGD_CODE_INTERVAL && a.q.at != NULL && b.q.at != NULL)
        v.q = o->q(a.q, b.q);
    else
        v.i = o->i(cagd_code_interval(a), cagd_code_interval(b));
    if (at_point)
        cagd_trace_resume();
    if (a.f.at != NULL || b.f.at != NULL)
        v.f = o->f(cagd_code_function(a), cagd_code_function(b));
    cagd_code_check_faults();
    note_result(v);
    return v;
}

/* Beside an infinity or a NaN, as IEEE 754 has it, a number can be any other one: in sums; in products and quotients any of its sign, which is
 * a condition of the way where the other operand is an infinity. */
static double in_sum(cagd_code_value v) { return v.special ? v.d : 0; }
static double in_product(cagd_code_value v, cagd_code_value other)
{
    return v.special ? v.d : isnan(other.d) ? 1 : (double)cagd_code_sign(v);
}

static int rounding(void) { return cagd_code_machine.job->numbers == CAGD_CODE_ROUNDING; }

/* x + y = fl(x + y) - this, exactly. */
static double lost_in_sum(double x, double y)
{
    double s = x + y, t = s - x;
    double lost = (x - (s - t)) + (y - t);
    return isfinite(lost) ? -lost : 0;
}

cagd_code_value cagd_code_sum(cagd_code_value a, cagd_code_value b)
{
    static const struct arithmetic o = {cagd_add_q, cagd_add_i, cagd_add_f};
    if (a.special || b.special)
        return cagd_code_special(in_sum(a) + in_sum(b));
    cagd_code_value v = combine(&o, a, b);
    if (rounding()) {
        v.d = a.d + b.d;
        cagd_code_shared(&v, a, 1, b, 1, lost_in_sum(a.d, b.d));
        cagd_code_note_made(&v, '+', a, b);
    }
    return v;
}

cagd_code_value cagd_code_difference(cagd_code_value a, cagd_code_value b)
{
    static const struct arithmetic o = {cagd_sub_q, cagd_sub_i, cagd_sub_f};
    if (a.special || b.special)
        return cagd_code_special(in_sum(a) - in_sum(b));
    cagd_code_value v = combine(&o, a, b);
    if (rounding()) {
        v.d = a.d - b.d;
        cagd_code_shared(&v, a, 1, b, -1, lost_in_sum(a.d, -b.d));
        cagd_code_note_made(&v, '-', a, b);
    }
    return v;
}

cagd_code_value cagd_code_product(cagd_code_value a, cagd_code_value b)
{
    static const struct arithmetic o = {cagd_mul_q, cagd_mul_i, cagd_mul_f};
    if (a.special || b.special)
        return cagd_code_special(in_product(a, b) * in_product(b, a));
    cagd_code_value v = combine(&o, a, b);
    if (rounding()) { /* x^ y^ - x y = y (x^ - x) + x^ (y^ - y) */
        v.d = a.d * b.d;
        cagd_code_shared(&v, a, cagd_code_real(b), b, a.d, -fma(a.d, b.d, -v.d));
        cagd_code_note_made(&v, '*', a, b);
    }
    return v;
}

static void note_denominator(cagd_num_f f)
{
    struct cagd_code_outcome *o = cagd_code_machine.outcome;
    const char *text = cagd_to_string_f(cagd_numerator_f(f));
    size_t length = strlen(text), had = o->denominators ? strlen(o->denominators) : 0;
    cagd_code_check_faults();
    if (length > 300)
        text = "(a long expression)", length = strlen(text);
    for (const char *at = o->denominators; at != NULL && *at != 0;) {
        const char *end = strchr(at, '\n');
        if ((size_t)(end - at) == length && strncmp(at, text, length) == 0)
            return;
        at = end + 1;
    }
    char *list = cagd_code_room(had + length + 2);
    if (had > 0)
        memcpy(list, o->denominators, had);
    memcpy(list + had, text, length);
    memcpy(list + had + length, "\n", 2);
    o->denominators = list;
}

void cagd_code_note_divisor(cagd_num_f f)
{
    cagd_trace_pause();
    if ((cagd_code_signs_here(f) & SAME) != 0)
        note_denominator(f);
    cagd_trace_resume();
}

cagd_code_value cagd_code_quotient(cagd_code_value a, cagd_code_value b)
{
    static const struct arithmetic o = {cagd_div_q, cagd_div_i, cagd_div_f};
    if (a.special || b.special) {
        double x = in_product(a, b), y = b.special ? b.d : (double)cagd_code_sign(b);
        if (!b.special && y == 0)
            cagd_code_stop(CAGD_CODE_UNDEFINED, "a division by zero");
        return cagd_code_special(x / y);
    }
    if (b.q.at != NULL && cagd_is_zero_q(b.q))
        cagd_code_stop(CAGD_CODE_UNDEFINED, "a division by zero");
    if (b.f.at != NULL)
        cagd_code_note_divisor(b.f);
    cagd_code_value v = combine(&o, a, b);
    if (rounding()) { /* x^/y^ - x/y = (x^ - x)/y^ - x/(y y^) (y^ - y) */
        v.d = a.d / b.d;
        double y = cagd_code_real(b), lost = b.d != 0 ? fma(v.d, b.d, -a.d) / b.d : 0;
        cagd_code_shared(&v, a, 1 / b.d, b, -cagd_code_real(a) / y / b.d, lost);
        cagd_code_note_made(&v, '/', a, b);
    }
    return v;
}

cagd_code_value cagd_code_negative(cagd_code_value a)
{
    cagd_code_value v = a;
    if (a.special)
        return cagd_code_special(-a.d);
    cagd_trace_pause();
    if (a.q.at != NULL && a.f.at != NULL)
        v.q = cagd_neg_q(a.q);
    cagd_trace_resume();
    if (a.q.at != NULL && a.f.at == NULL)
        v.q = cagd_neg_q(a.q);
    if (a.i.at != NULL)
        v.i = cagd_neg_i(a.i);
    if (a.f.at != NULL)
        v.f = cagd_neg_f(a.f);
    v.d = -a.d;
    v.shares = 0;
    if (rounding()) {
        cagd_code_shared(&v, a, -1, (cagd_code_value){.d = 0}, 0, 0);
        cagd_code_note_made(&v, 'n', a, a);
    }
    note_result(v);
    return v;
}

static cagd_code_value power(cagd_code_value a, unsigned long n)
{
    cagd_code_value v = cagd_code_integer(1);
    for (int any = 0; n > 0; n >>= 1) {
        if (n & 1) {
            v = any ? cagd_code_product(v, a) : a;
            any = 1;
        }
        if (n > 1)
            a = cagd_code_product(a, a);
        if (a.q.at != NULL)
            cagd_code_bound_bits(a.q);
    }
    return v;
}

double cagd_code_power(double a, int32_t n)
{
    cagd_code_value v = power(cagd_code_value_of(a), n < 0 ? 0 - (unsigned long)(long)n : (unsigned long)n);
    return cagd_code_number(n < 0 ? cagd_code_quotient(cagd_code_integer(1), v) : v);
}

double cagd_code_add(double a, double b)
{
    operation = __builtin_return_address(0);
    return cagd_code_number(cagd_code_sum(cagd_code_value_of(a), cagd_code_value_of(b)));
}
double cagd_code_sub(double a, double b)
{
    operation = __builtin_return_address(0);
    return cagd_code_number(cagd_code_difference(cagd_code_value_of(a), cagd_code_value_of(b)));
}
double cagd_code_mul(double a, double b)
{
    operation = __builtin_return_address(0);
    return cagd_code_number(cagd_code_product(cagd_code_value_of(a), cagd_code_value_of(b)));
}
double cagd_code_div(double a, double b)
{
    operation = __builtin_return_address(0);
    return cagd_code_number(cagd_code_quotient(cagd_code_value_of(a), cagd_code_value_of(b)));
}
double cagd_code_neg(double a)
{
    operation = __builtin_return_address(0);
    return cagd_code_number(cagd_code_negative(cagd_code_value_of(a)));
}

/* ---- order ------------------------------------------------------------------------------------------- */

static int relation_of(int sign) { return sign == 0 ? SAME : sign > 0 ? GREATER : LESS; }

static int relation_of_doubles(double a, double b)
{
    return a == b ? SAME : a > b ? GREATER : a < b ? LESS : UNORDERED;
}

void cagd_code_follow(long outcome)
{
    unsigned long long *path = &cagd_code_machine.outcome->path;
    *path = (*path ^ ((unsigned long long)outcome + 1)) * 0x100000001B3u;
    *path = (*path ^ (unsigned long long)(cagd_code_at ? cagd_code_at->line : 0)) * 0x100000001B3u;
}

static int is_name(const char *text, size_t length)
{
    for (size_t k = 0; k < length; k++)
        if (!isalnum((unsigned char)text[k]) && strchr("_[]", text[k]) == NULL)
            return 0;
    return length > 0 && isalpha((unsigned char)*text);
}

/* "a-b" and "-b+a", where a and b are names: written into the two sides; whether it is so. */
static int is_difference_of_names(const char *text, const char **left, const char **right)
{
    size_t minus = *text == '-', first = strcspn(text + minus, "+-*/^()"), second = strlen(text + minus + first);
    char sign = text[minus + first];
    if (second < 2 || sign != (minus ? '+' : '-') || !is_name(text + minus, first) ||
        !is_name(text + minus + first + 1, second - 1))
        return 0;
    char *a = cagd_region_bytes(first + 1);
    cagd_code_check_faults();
    memcpy(a, text + minus, first);
    a[first] = 0;
    *left = minus ? text + minus + first + 1 : a;
    *right = minus ? a : text + minus + first + 1;
    return 1;
}

/* Of the same sign as f, whose denominator is not 0. */
static const char *polynomial_of_sign(cagd_num_f f)
{
    cagd_num_f top = cagd_numerator_f(f), bottom = cagd_denominator_f(f);
    int sign = cagd_is_constant_f(bottom, NULL) ? GREATER : cagd_code_signs_here(bottom) & ~SAME;
    return cagd_to_string_f(sign == GREATER ? top : sign == LESS ? cagd_neg_f(top) : cagd_mul_f(top, bottom));
}

/* The condition that the relation is one of `holding`, each condition once. */
static void note_condition(cagd_code_value a, cagd_code_value b, cagd_num_f difference, int holding)
{
    static const char *const signs[] = {"", "=", ">", ">=", "<", "<=", "!="};
    struct cagd_code_outcome *o = cagd_code_machine.outcome;
    const char *left = cagd_code_field_text(a), *right = cagd_code_field_text(b), *text = cagd_to_string_f(difference);
    struct cagd_code_condition **last = &o->conditions;
    if (strlen(left) + strlen(right) > MOST_IN_CONDITION)
        left = "(a long expression)", right = "(another)";
    is_difference_of_names(text, &left, &right);
    cagd_code_know_sign(difference, holding);
    const char *opposite = cagd_to_string_f(cagd_neg_f(difference));
    const char *polynomial = polynomial_of_sign(difference);
    if (strlen(text) > MOST_IN_CONDITION)
        text = opposite = "";
    for (; *last != NULL; last = &(*last)->next)
        if (strcmp((*last)->relation, signs[holding]) == 0 && strcmp((*last)->left, left) == 0 &&
            strcmp((*last)->right, right) == 0)
            return;
    struct cagd_code_condition *c = cagd_code_room(sizeof *c);
    *c = (struct cagd_code_condition){.left = cagd_code_keep(left),
                                      .relation = signs[holding],
                                      .right = cagd_code_keep(right),
                                      .difference = cagd_code_keep(text),
                                      .opposite = cagd_code_keep(opposite),
                                      .polynomial =
                                          strlen(polynomial) > MOST_IN_POLYNOMIAL ? "" : cagd_code_keep(polynomial),
                                      .holding = holding,
                                      .given = cagd_code_machine.given};
    if (cagd_code_at != NULL)
        c->place = (struct cagd_code_place){cagd_code_keep(cagd_code_at->file), cagd_code_keep(cagd_code_at->function),
                                            cagd_code_at->line};
    *last = c;
}

/* At the point. */
static int decide(cagd_code_value a, cagd_code_value b)
{
    if (a.q.at != NULL && b.q.at != NULL && cagd_code_machine.job->numbers != CAGD_CODE_INTERVAL)
        return relation_of(cagd_compare_q(a.q, b.q));
    int sign = cagd_sign_i(cagd_sub_i(cagd_code_interval(a), cagd_code_interval(b)));
    if (sign == 0)
        cagd_code_stop(CAGD_CODE_REFUSED, "an enclosure does not decide a comparison");
    return relation_of(sign);
}

int cagd_code_relation(cagd_code_value a, cagd_code_value b, int predicate)
{
    struct cagd_code_outcome *o = cagd_code_machine.outcome;
    int relation;
    if (a.special || b.special) {
        relation = relation_of_doubles(a.special ? a.d : 0, b.special ? b.d : 0);
    } else if (rounding()) {
        relation = relation_of_doubles(a.d, b.d);
        if (a.q.at != NULL && b.q.at != NULL && relation_of(cagd_compare_q(a.q, b.q)) != relation) {
            int exact = relation_of(cagd_compare_q(a.q, b.q));
            if (((exact & predicate) != 0) != ((relation & predicate) != 0) && o->decided_otherwise++ == 0)
                o->turned = (struct cagd_code_place){cagd_code_keep(cagd_code_at->file),
                                                     cagd_code_keep(cagd_code_at->function), cagd_code_at->line};
        }
    } else if (a.f.at != NULL || b.f.at != NULL) {
        cagd_num_f difference = cagd_sub_f(cagd_code_function(a), cagd_code_function(b));
        cagd_code_check_faults();
        if (cagd_code_vanishes(difference)) {
            relation = SAME;
        } else {
            relation = decide(a, b);
            int asked = predicate & 7;
            int holding = relation & asked ? asked : 7 & ~asked;
            if (cagd_trace_noting())
                cagd_trace_relation("order", cagd_node_of_f(difference), -1,
                                    (relation == GREATER) - (relation == LESS));
            cagd_trace_pause();
            if (!cagd_is_constant_f(difference, NULL) && holding != 7 &&
                (cagd_code_signs_here(difference) & ~holding) != 0)
                note_condition(a, b, difference, holding);
            cagd_trace_resume();
        }
    } else {
        relation = decide(a, b);
    }
    if (!cagd_code_machine.given)
        cagd_code_follow((relation & predicate) != 0);
    return relation;
}

int cagd_code_sign(cagd_code_value a)
{
    if (a.special)
        return (a.d > 0) - (a.d < 0);
    if (cagd_code_relation(a, cagd_code_integer(0), LESS) == LESS)
        return -1;
    return cagd_code_relation(a, cagd_code_integer(0), GREATER) == GREATER;
}

int32_t cagd_code_compare(double a, double b, int32_t predicate)
{
    return (cagd_code_relation(cagd_code_value_of(a), cagd_code_value_of(b), predicate) & predicate) != 0;
}

int64_t cagd_code_sign_bits(double a)
{
    uint64_t bits;
    memcpy(&bits, &a, sizeof bits);
    if (!cagd_code_is_one(bits) && (a == 0 || !isfinite(a)))
        return -(int64_t)(bits >> 63);
    cagd_code_value v = cagd_code_value_of(a);
    return cagd_code_relation(v, cagd_code_integer(0), LESS) == LESS ? -1 : 0;
}

int64_t cagd_code_size_bits(double a, int32_t bits)
{
    cagd_code_value v = cagd_code_value_of(a);
    double size = v.special ? fabs(v.d) : 1;
    float single = (float)size;
    int64_t wide;
    int32_t narrow;
    memcpy(&wide, &size, sizeof wide);
    memcpy(&narrow, &single, sizeof narrow);
    return bits == 32 ? narrow : wide;
}

int32_t cagd_code_class(double a, int32_t classes)
{
    /* signaling NaN, quiet NaN, -inf, -normal, -subnormal, -0, 0, subnormal, normal, inf: 1, 2, 4, ..., 512 */
    cagd_code_value v = cagd_code_value_of(a);
    if (v.special)
        return (classes & (isnan(v.d) ? 3 : v.d < 0 ? 4 : 512)) != 0;
    int finite = classes & 504;
    if (finite == 0 || finite == 504)
        return finite != 0;
    int sign = cagd_code_sign(v);
    return (classes & (sign < 0 ? 8 : sign == 0 ? 96 : 256)) != 0;
}

/* ---- whole numbers ------------------------------------------------------------------------------------- */

double cagd_code_from_unsigned(uint64_t n)
{
    if (n <= (uint64_t)1 << 53)
        return (double)n;
    cagd_num_q q = cagd_add_q(cagd_mul_q(cagd_from_int_q((long)(n >> 32)), cagd_from_int_q((long)1 << 32)),
                              cagd_from_int_q((long)(n & 0xFFFFFFFF)));
    cagd_code_value v = cagd_code_constant(q);
    if (rounding())
        cagd_code_shared(&v, v, 0, v, 0, cagd_to_double_q(cagd_sub_q(cagd_from_double_q(v.d), q)));
    return cagd_code_number(v);
}

double cagd_code_from_signed(int64_t n)
{
    if (n >= 0)
        return cagd_code_from_unsigned((uint64_t)n);
    return cagd_code_neg(cagd_code_from_unsigned(0 - (uint64_t)n));
}

/* n with the rounding `how` of q. */
static cagd_num_q whole_of(cagd_num_q q, enum cagd_code_rounding how)
{
    mpq_t n, half;
    mpq_inits(n, half, NULL);
    mpz_srcptr p = mpq_numref(q.at), d = mpq_denref(q.at);
    switch (how) {
    case CAGD_CODE_TRUNC:
        mpz_tdiv_q(mpq_numref(n), p, d);
        break;
    case CAGD_CODE_FLOOR:
        mpz_fdiv_q(mpq_numref(n), p, d);
        break;
    case CAGD_CODE_CEIL:
        mpz_cdiv_q(mpq_numref(n), p, d);
        break;
    default: /* floor(|q| + 1/2), with the sign of q; of two that are equally near the even one */
        mpq_set_ui(half, 1, 2);
        mpq_abs(n, q.at);
        mpq_add(half, half, n);
        mpz_fdiv_q(mpq_numref(n), mpq_numref(half), mpq_denref(half));
        if (how == CAGD_CODE_EVEN && mpz_cmp_ui(mpq_denref(half), 1) == 0 && mpz_odd_p(mpq_numref(n)))
            mpz_sub_ui(mpq_numref(n), mpq_numref(n), 1);
        mpz_set_ui(mpq_denref(n), 1);
        if (mpq_sgn(q.at) < 0)
            mpq_neg(n, n);
    }
    mpz_set_ui(mpq_denref(n), 1);
    cagd_num_q result = cagd_from_mpq_q(n);
    mpq_clears(n, half, NULL);
    return result;
}

/* a >= low (or > low), and a <= high (or < high): as conditions; they are true. */
static void between(cagd_code_value a, cagd_num_q low, int low_open, cagd_num_q high, int high_open)
{
    cagd_code_relation(a, cagd_code_constant(low), low_open ? GREATER : GREATER | SAME);
    cagd_code_relation(a, cagd_code_constant(high), high_open ? LESS : LESS | SAME);
}

cagd_code_value cagd_code_whole(cagd_code_value a, enum cagd_code_rounding how)
{
    if (a.special)
        return a;
    if (rounding()) {
        double d = how == CAGD_CODE_TRUNC   ? trunc(a.d)
                   : how == CAGD_CODE_FLOOR ? floor(a.d)
                   : how == CAGD_CODE_CEIL  ? ceil(a.d)
                   : how == CAGD_CODE_ROUND ? round(a.d)
                                            : rint(a.d);
        cagd_code_value v =
            a.q.at != NULL ? cagd_code_constant(whole_of(a.q, how)) : cagd_code_constant(cagd_from_double_q(d));
        cagd_code_shared(&v, v, 0, v, 0, d - v.d);
        v.d = d;
        return v;
    }
    if (a.q.at == NULL || cagd_code_machine.job->numbers == CAGD_CODE_INTERVAL) {
        cagd_num_i i = cagd_code_interval(a);
        cagd_num_q low = whole_of(cagd_from_double_q(cagd_lower_i(i)), how);
        cagd_num_q high = whole_of(cagd_from_double_q(cagd_upper_i(i)), how);
        if (!cagd_equal_q(low, high))
            cagd_code_stop(CAGD_CODE_REFUSED, "an enclosure does not decide to which integer a number is rounded");
        return cagd_code_constant(low);
    }
    cagd_num_q n = whole_of(a.q, how);
    cagd_code_value whole = cagd_code_constant(n);
    cagd_code_follow(mpz_get_si(mpq_numref(n.at)));
    if (a.f.at == NULL)
        return whole;
    int *line = &cagd_code_machine.outcome->whole_line;
    if (*line == 0 && cagd_code_at != NULL)
        *line = (int)cagd_code_at->line;
    cagd_num_q one = cagd_from_int_q(1), half = cagd_from_ratio_q(1, 2);
    int sign = cagd_sign_q(n);
    switch (how) {
    case CAGD_CODE_FLOOR:
        between(a, n, 0, cagd_add_q(n, one), 1);
        break;
    case CAGD_CODE_CEIL:
        between(a, cagd_sub_q(n, one), 1, n, 0);
        break;
    case CAGD_CODE_TRUNC:
        between(a, sign > 0 ? n : cagd_sub_q(n, one), sign <= 0, sign < 0 ? n : cagd_add_q(n, one), sign >= 0);
        break;
    default: /* the ends of the range of n are n's own where the run shows it, which is all that is said of them */
        between(a, cagd_sub_q(n, half), cagd_compare_q(a.q, cagd_sub_q(n, half)) != 0, cagd_add_q(n, half),
                cagd_compare_q(a.q, cagd_add_q(n, half)) != 0);
    }
    return whole;
}

int64_t cagd_code_to_integer(double a, int32_t bits, int32_t is_signed)
{
    cagd_code_value v = cagd_code_value_of(a);
    if (v.special)
        cagd_code_stop(CAGD_CODE_REFUSED, "an infinity or a NaN as an integer");
    v = cagd_code_whole(v, CAGD_CODE_TRUNC);
    mpz_t n, least, most;
    mpz_inits(n, least, most, NULL);
    mpz_set_q(n, rounding() ? cagd_from_double_q(v.d).at : v.q.at);
    mpz_setbit(most, (mp_bitcnt_t)(is_signed ? bits - 1 : bits));
    if (is_signed)
        mpz_neg(least, most);
    if (mpz_cmp(n, least) < 0 || mpz_cmp(n, most) >= 0)
        cagd_code_stop(CAGD_CODE_REFUSED, "a number outside the range of %s integer of %d bits",
                       is_signed ? "a signed" : "an unsigned", (int)bits);
    uint64_t magnitude = 0;
    mpz_export(&magnitude, NULL, -1, sizeof magnitude, 0, 0, n);
    int negative = mpz_sgn(n) < 0;
    mpz_clears(n, least, most, NULL);
    return (int64_t)(negative ? 0 - magnitude : magnitude);
}

void cagd_code_refuse(const char *what) { cagd_code_stop(CAGD_CODE_REFUSED, "%s", what); }

void cagd_code_look(const char *p, int32_t size, int32_t object)
{
    uint64_t word;
    const char *start = p - (uintptr_t)p % 8;
    memcpy(&word, size == 8 ? p : start, sizeof word);
    int in_high_half = p - start >= 4;
    uint32_t half;
    if (cagd_code_is_one(word) && (size == 8 || in_high_half || !object))
        cagd_code_stop(CAGD_CODE_REFUSED, "the bits of a number");
    if (size == 4) {
        memcpy(&half, p, sizeof half);
        if (cagd_code_is_single(half))
            cagd_code_stop(CAGD_CODE_REFUSED, "the bits of a number");
    }
}
