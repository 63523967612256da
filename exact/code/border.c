/* border.c -- see border.h. */
#include "exact/code/border.h"

#include "exact/decide/roots.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_POWER = 1000, MOST_DEGREE = 64, MOST_ROOT_BITS = 256, NEAR_BITS = 40 };

/* A rational function of the one name that is a variable: all others have their values. */
struct fraction {
    cagd_poly n, d;
};

/* What is read, and what the names in it mean. */
struct reading {
    const char *at, *name;
    const struct cagd_code_point *point;
    int wrong;
};

static struct fraction constant(cagd_num_q q)
{
    return (struct fraction){cagd_poly_constant(q), cagd_poly_constant(cagd_from_int_q(1))};
}

static void look_at_degree(struct reading *r, struct fraction f)
{
    r->wrong |= cagd_poly_degree(f.n) > MOST_DEGREE || cagd_poly_degree(f.d) > MOST_DEGREE;
}

static struct fraction sum(struct reading *r);

static void skip(struct reading *r)
{
    while (*r->at == ' ')
        r->at++;
}

/* "p[2]", where elements that are equal have one name, or "t". */
static struct fraction named(struct reading *r)
{
    size_t length = 0;
    while (isalnum((unsigned char)r->at[length]) || r->at[length] == '_')
        length++;
    size_t whole = length + (r->at[length] == '[' ? strcspn(r->at + length, "]") + 1 : 0);
    const char *start = r->at;
    r->at += whole;
    if (r->name != NULL && strlen(r->name) == whole && strncmp(r->name, start, whole) == 0)
        return (struct fraction){cagd_poly_variable(), cagd_poly_constant(cagd_from_int_q(1))};
    for (int k = 0; k < r->point->inputs; k++) {
        const struct cagd_code_input *in = &r->point->input[k];
        if (strlen(in->name) != length || strncmp(in->name, start, length) != 0)
            continue;
        long index = whole > length ? strtol(start + length + 1, NULL, 10) : 0;
        if (index < (in->count > 0 ? in->count : 1))
            return constant(cagd_from_string_q(in->value[index]));
    }
    r->wrong = 1;
    return constant(cagd_from_int_q(0));
}

static struct fraction atom(struct reading *r)
{
    skip(r);
    if (*r->at == '(') {
        r->at++;
        struct fraction value = sum(r);
        skip(r);
        r->wrong |= *r->at != ')';
        r->at += *r->at == ')';
        return value;
    }
    if (isalpha((unsigned char)*r->at))
        return named(r);
    size_t digits = strspn(r->at, "0123456789");
    char *text = strndup(r->at, digits);
    if (text == NULL)
        abort();
    cagd_num_q value = cagd_from_string_q(digits > 0 ? text : "0");
    r->wrong |= digits == 0;
    r->at += digits;
    free(text);
    return constant(value);
}

static struct fraction times(struct reading *r, struct fraction a, struct fraction b)
{
    struct fraction value = {cagd_poly_mul(a.n, b.n), cagd_poly_mul(a.d, b.d)};
    look_at_degree(r, value);
    return value;
}

static struct fraction power(struct reading *r)
{
    struct fraction base = atom(r), value = base;
    skip(r);
    if (*r->at != '^')
        return base;
    char *end;
    long n = strtol(r->at + 1, &end, 10);
    r->wrong |= end == r->at + 1 || n < 1 || n > MOST_POWER;
    r->at = end;
    for (long k = 1; k < n && !r->wrong; k++)
        value = times(r, value, base);
    return value;
}

static struct fraction product(struct reading *r)
{
    struct fraction value = power(r);
    for (skip(r); *r->at == '*' || *r->at == '/'; skip(r)) {
        int is_times = *r->at++ == '*';
        struct fraction next = power(r);
        if (!is_times && cagd_poly_is_zero(next.n))
            r->wrong = 1;
        else
            value = times(r, value, is_times ? next : (struct fraction){next.d, next.n});
    }
    return value;
}

static struct fraction plus(struct reading *r, struct fraction a, struct fraction b)
{
    struct fraction value = cagd_poly_equal(a.d, b.d)
                                ? (struct fraction){cagd_poly_add(a.n, b.n), a.d}
                                : (struct fraction){cagd_poly_add(cagd_poly_mul(a.n, b.d), cagd_poly_mul(b.n, a.d)),
                                                    cagd_poly_mul(a.d, b.d)};
    look_at_degree(r, value);
    return value;
}

static struct fraction minus(struct fraction a) { return (struct fraction){cagd_poly_neg(a.n), a.d}; }

static struct fraction sum(struct reading *r)
{
    skip(r);
    int is_minus = *r->at == '-';
    r->at += is_minus || *r->at == '+';
    struct fraction value = product(r);
    if (is_minus)
        value = minus(value);
    for (skip(r); *r->at == '+' || *r->at == '-'; skip(r)) {
        int is_plus = *r->at++ == '+';
        struct fraction next = product(r);
        value = plus(r, value, is_plus ? next : minus(next));
    }
    return value;
}

/* Whether the expression is understood. */
static int read_whole(const char *expression, const struct cagd_code_point *p, const char *name, struct fraction *value)
{
    struct reading r = {.at = expression, .name = name, .point = p};
    *value = sum(&r);
    return !r.wrong && *r.at == 0;
}

/* {NULL} where it has no value. */
cagd_num_q cagd_code_evaluate(const char *expression, const struct cagd_code_point *p, const char *name,
                              cagd_num_q instead)
{
    struct fraction value;
    int known = read_whole(expression, p, name, &value);
    cagd_num_q below = known ? cagd_poly_value(value.d, instead) : cagd_from_int_q(0);
    return cagd_is_zero_q(below) ? (cagd_num_q){NULL} : cagd_div_q(cagd_poly_value(value.n, instead), below);
}

/* ---- zeros ------------------------------------------------------------------------------------------------- */

static cagd_num_q middle(cagd_num_q a, cagd_num_q b) { return cagd_mul_q(cagd_add_q(a, b), cagd_from_ratio_q(1, 2)); }

/* The number with the smallest denominator in [lo, hi], by continued fractions. */
static cagd_num_q simplest(cagd_num_q lo, cagd_num_q hi)
{
    cagd_num_q whole = cagd_floor_q(lo), one = cagd_from_int_q(1);
    if (cagd_equal_q(whole, lo))
        return whole;
    if (cagd_compare_q(cagd_floor_q(hi), lo) > 0)
        return cagd_add_q(whole, one);
    return cagd_add_q(whole, cagd_div_q(one, simplest(cagd_div_q(one, cagd_sub_q(hi, whole)),
                                                      cagd_div_q(one, cagd_sub_q(lo, whole)))));
}

/* 2^-bits */
static cagd_num_q small(long bits)
{
    cagd_num_q half = cagd_from_ratio_q(1, 2), value = cagd_from_int_q(1);
    for (long k = 0; k < bits; k++)
        value = cagd_mul_q(value, half);
    return value;
}

/* The denominator of a rational zero divides the first coefficient when all are whole: how many bits that has. */
static long bits_of_denominators(cagd_poly p)
{
    mpz_t common, first;
    mpz_init_set_ui(common, 1);
    mpz_init(first);
    int degree = cagd_poly_degree(p);
    for (int k = 0; k <= degree; k++)
        mpz_lcm(common, common, mpq_denref(cagd_poly_coefficient(p, k).at));
    cagd_num_q leading = cagd_poly_coefficient(p, degree);
    mpz_mul(first, common, mpq_numref(leading.at));
    mpz_divexact(first, first, mpq_denref(leading.at));
    long bits = (long)mpz_sizeinbase(first, 2);
    mpz_clear(common);
    mpz_clear(first);
    return bits;
}

/* Narrow, and the number itself where that is rational. */
static struct cagd_root narrowed(struct cagd_root r)
{
    long bits = bits_of_denominators(r.factor);
    r = cagd_refine_root(r, small(NEAR_BITS));
    if (cagd_equal_q(r.lo, r.hi))
        return r;
    struct cagd_root fine = bits <= MOST_ROOT_BITS ? cagd_refine_root(r, small(2 * bits + 1)) : r;
    cagd_num_q guess = simplest(fine.lo, fine.hi);
    if (cagd_is_zero_q(cagd_poly_value(fine.factor, guess)) &&
        (cagd_compare_q(fine.lo, guess) < 0 || cagd_equal_q(fine.lo, fine.hi)) && cagd_compare_q(guess, fine.hi) < 0)
        fine.lo = fine.hi = guess;
    return fine;
}

/* The different real zeros of p in increasing order, at most CAGD_CODE_MOST_ZEROS; neighbours have room between them. */
static int zeros_of(cagd_poly p, struct cagd_root root[])
{
    if (cagd_poly_degree(p) < 1)
        return 0;
    cagd_num_q bound = cagd_root_bound(p);
    int count = cagd_isolate_roots(p, cagd_neg_q(bound), bound, root, CAGD_CODE_MOST_ZEROS);
    count = count < CAGD_CODE_MOST_ZEROS ? count : CAGD_CODE_MOST_ZEROS;
    for (int k = 0; k < count; k++)
        root[k] = narrowed(root[k]);
    for (int k = 0; k + 1 < count; k++)
        for (long bits = NEAR_BITS; cagd_compare_q(root[k].hi, root[k + 1].lo) >= 0; bits *= 2) {
            root[k] = cagd_refine_root(root[k], small(bits));
            root[k + 1] = cagd_refine_root(root[k + 1], small(bits));
        }
    return count;
}

/* ---- borders ----------------------------------------------------------------------------------------------- */

static void put(struct cagd_code_border *b, cagd_num_q x) { b->at[b->values++] = x; }

/* Around zero k of so many: itself, near it where no other zero is nearer, and between it and the next, or far. */
static void put_around(struct cagd_code_border *b, const struct cagd_root root[], int k, int count)
{
    cagd_num_q one = cagd_from_int_q(1), near = small(NEAR_BITS);
    cagd_num_q before = k > 0 ? middle(root[k - 1].hi, root[k].lo) : cagd_sub_q(root[k].lo, one);
    cagd_num_q behind = k + 1 < count ? middle(root[k].hi, root[k + 1].lo) : cagd_add_q(root[k].hi, one);
    cagd_num_q low = cagd_sub_q(root[k].lo, near), high = cagd_add_q(root[k].hi, near);
    if (cagd_equal_q(root[k].lo, root[k].hi))
        put(b, root[k].lo);
    if (cagd_compare_q(low, before) > 0)
        put(b, low);
    if (cagd_compare_q(high, behind) < 0)
        put(b, high);
    if (k == 0)
        put(b, before);
    put(b, behind);
}

/* Where |f| is least among the places at which f' = 0; such a place may be irrational, and then it is taken from very near. */
static cagd_num_q least_of(struct fraction f)
{
    struct cagd_root root[CAGD_CODE_MOST_ZEROS];
    cagd_poly slope =
        cagd_poly_sub(cagd_poly_mul(cagd_poly_derivative(f.n), f.d), cagd_poly_mul(f.n, cagd_poly_derivative(f.d)));
    cagd_num_q best = {NULL}, amount = {NULL};
    int count = zeros_of(slope, root);
    for (int k = 0; k < count; k++) {
        cagd_num_q x = middle(root[k].lo, root[k].hi), below = cagd_poly_value(f.d, x);
        if (cagd_is_zero_q(below))
            continue;
        cagd_num_q value = cagd_div_q(cagd_poly_value(f.n, x), below);
        value = cagd_sign_q(value) < 0 ? cagd_neg_q(value) : value;
        if (best.at == NULL || cagd_compare_q(value, amount) < 0)
            best = x, amount = value;
    }
    return best;
}

struct cagd_code_border cagd_code_border(const char *difference, const struct cagd_code_point *p, int input,
                                         int element)
{
    char name[64];
    struct cagd_code_border b = {0};
    struct cagd_root root[CAGD_CODE_MOST_ZEROS];
    struct fraction f;
    if (p->input[input].count > 0)
        snprintf(name, sizeof name, "%s[%d]", p->input[input].name, element);
    else
        snprintf(name, sizeof name, "%s", p->input[input].name);
    if (strstr(difference, name) == NULL || !read_whole(difference, p, name, &f))
        return b;
    cagd_poly both = cagd_poly_mul(f.n, f.d);
    if (cagd_poly_degree(both) < 1)
        return b;
    b.varies = 1;
    b.zeros = zeros_of(both, root);
    for (int k = 0; k < b.zeros; k++) {
        b.rational += cagd_equal_q(root[k].lo, root[k].hi);
        put_around(&b, root, k, b.zeros);
    }
    b.least = least_of(f);
    return b;
}
