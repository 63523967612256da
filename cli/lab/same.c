/* same.c -- rational functions as texts: whether two are the same where others are 0; see lab.h. */
#include "cli/lab/lab.h"
#include "exact/code/polyhedron.h"
#include "exact/number/field.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_TEXT = 1 << 20, MOST_DEPTH = 60, MOST_POWER = 200, MOST_FACTORS = 16 };

/* ---- texts --------------------------------------------------------------------------------------------------- */

struct reading {
    const char *at;
    int depth, wrong;
};

static cagd_num_f sum(struct reading *r);

static cagd_num_f atom(struct reading *r)
{
    char name[CAGD_FIELD_MAX_NAME + 1];
    cagd_num_f value = cagd_from_int_f(0);
    size_t length;
    r->at += strspn(r->at, " ");
    if (*r->at == '(' && r->depth < MOST_DEPTH) {
        r->at++;
        r->depth++;
        value = sum(r);
        r->depth--;
        r->wrong |= *r->at != ')';
        r->at += *r->at == ')';
    } else if (isalpha((unsigned char)*r->at)) {
        length = strspn(r->at, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789");
        length += r->at[length] == '[' ? strcspn(r->at + length, "]") + 1 : 0;
        r->wrong |= length >= sizeof name;
        snprintf(name, sizeof name, "%.*s", (int)length, r->at);
        r->at += r->wrong ? 0 : length;
        value = cagd_variable_f(name);
    } else {
        length = strspn(r->at, "0123456789");
        char *digits = strndup(r->at, length);
        r->wrong |= length == 0 || digits == NULL;
        if (!r->wrong)
            value = cagd_from_rational_f(cagd_from_string_q(digits));
        r->at += length;
        free(digits);
    }
    r->at += strspn(r->at, " ");
    return value;
}

static cagd_num_f power(struct reading *r)
{
    cagd_num_f base = atom(r), value = base;
    if (r->wrong || *r->at != '^')
        return base;
    char *end;
    long n = strtol(r->at + 1, &end, 10);
    r->wrong |= end == r->at + 1 || n < 1 || n > MOST_POWER;
    r->at = end + strspn(end, " ");
    for (long k = 1; k < n && !r->wrong; k++)
        value = cagd_mul_f(value, base);
    return value;
}

static cagd_num_f product(struct reading *r)
{
    cagd_num_f value = power(r);
    while (!r->wrong && (*r->at == '*' || *r->at == '/')) {
        int is_times = *r->at++ == '*';
        cagd_num_f next = power(r);
        r->wrong |= !is_times && cagd_is_zero_f(next);
        if (!r->wrong)
            value = is_times ? cagd_mul_f(value, next) : cagd_div_f(value, next);
    }
    return value;
}

static cagd_num_f sum(struct reading *r)
{
    r->at += strspn(r->at, " ");
    int minus = *r->at == '-';
    r->at += minus || *r->at == '+';
    cagd_num_f value = product(r);
    if (minus)
        value = cagd_neg_f(value);
    while (!r->wrong && (*r->at == '+' || *r->at == '-')) {
        int is_plus = *r->at++ == '+';
        cagd_num_f next = product(r);
        value = is_plus ? cagd_add_f(value, next) : cagd_sub_f(value, next);
    }
    return value;
}

/* The function; 0 where the text is not understood.  In a field that is open. */
static int read_function(const char *text, cagd_num_f *f)
{
    struct reading r = {text, 0, 0};
    if (*text == 0 || strlen(text) > MOST_TEXT)
        return 0;
    *f = sum(&r);
    return !r.wrong && *r.at == 0 && cagd_region_faults == 0;
}

/* The variables of the field that is open; how many. */
static int variables(cagd_num_f v[CAGD_FIELD_MAX_VARIABLES])
{
    int count = 0;
    for (const char *at = cagd_field_variables(); *at != 0 && count < CAGD_FIELD_MAX_VARIABLES;) {
        char name[CAGD_FIELD_MAX_NAME + 1];
        size_t length = strcspn(at, " ");
        snprintf(name, sizeof name, "%.*s", (int)length, at);
        v[count++] = cagd_variable_f(name);
        at += length + strspn(at + length, " ");
    }
    return count;
}

/* ---- where others are 0 -------------------------------------------------------------------------------------- */

/* A variable that the equation e = 0 gives as a function x of the others: e = c (variable - x) with a number c that is not 0.  Whether
 * there is one. */
static int solve(cagd_num_f e, cagd_num_f *variable, cagd_num_f *x)
{
    cagd_num_f v[CAGD_FIELD_MAX_VARIABLES];
    const int count = variables(v);
    for (int k = 0; k < count; k++) {
        if (!cagd_has_degrees_f(e, v[k], 1, 0) || !cagd_is_constant_f(cagd_coefficient_f(e, v[k], 1), NULL))
            continue;
        *variable = v[k];
        *x = cagd_sub_f(v[k], cagd_div_f(e, cagd_coefficient_f(e, v[k], 1)));
        return 1;
    }
    return 0;
}

/* Whether f is a multiple of the polynomial e, so that it is 0 wherever e is and f has a value. */
static int vanishes_with(cagd_num_f f, cagd_num_f e)
{
    return cagd_is_zero_f(f) || cagd_is_constant_f(cagd_denominator_f(cagd_div_f(cagd_numerator_f(f), e)), NULL);
}

/* Polynomials: those that are 0, and those that are not. */
struct conditions {
    int zeros, others;
    cagd_num_f zero[LAB_MOST_COMPARED], other[LAB_MOST_COMPARED];
};

static int vanishes_where(cagd_num_f f, struct conditions c);

/* A zero polynomial is put aside, with the variable that it gives in all others. */
static int vanishes_behind(cagd_num_f f, struct conditions c, int k, cagd_num_f variable, cagd_num_f x)
{
    c.zero[k] = c.zero[--c.zeros];
    for (int j = 0; j < c.zeros; j++)
        c.zero[j] = cagd_substitute_f(c.zero[j], variable, x);
    for (int j = 0; j < c.others; j++)
        c.other[j] = cagd_substitute_f(c.other[j], variable, x);
    return vanishes_where(cagd_substitute_f(f, variable, x), c);
}

/* One of the factors of a polynomial is 0, and none of which it is known that it is not.  -1 where it has no factors to tell apart. */
static int vanishes_by_factors(cagd_num_f f, const struct conditions *c, int k)
{
    cagd_num_f v[CAGD_FIELD_MAX_VARIABLES], factor[MOST_FACTORS];
    int power[MOST_FACTORS], factors = 0, all = 1;
    const int count = variables(v);
    for (int i = 0; i < count && factors < 2; i++)
        factors = cagd_factors_f(c->zero[k], v[i], MOST_FACTORS, factor, power);
    if (factors < 2)
        return -1;
    cagd_num_f rest = c->zero[k];
    for (int i = 0; i < factors; i++)
        for (int j = 0; j < power[i]; j++)
            rest = cagd_div_f(rest, factor[i]);
    if (!cagd_is_constant_f(rest, NULL))
        return -1;
    for (int i = 0; i < factors && all; i++) {
        struct conditions one = *c;
        int excluded = 0;
        for (int j = 0; j < c->others && !excluded; j++)
            excluded = !cagd_is_zero_f(c->other[j]) && vanishes_with(c->other[j], factor[i]);
        one.zero[k] = factor[i];
        all = excluded || vanishes_where(f, one);
    }
    return all;
}

/* A polynomial that gives a variable as a function of the others is used so; else f is a multiple of one, or of its factors. */
static int vanishes_where(cagd_num_f f, struct conditions c)
{
    cagd_num_f variable, x;
    for (int k = 0; k < c.zeros; k++) {
        if (cagd_is_zero_f(c.zero[k]))
            c.zero[k--] = c.zero[--c.zeros];
        else if (vanishes_with(f, c.zero[k]))
            return 1;
        else if (solve(c.zero[k], &variable, &x))
            return vanishes_behind(f, c, k, variable, x);
    }
    for (int k = 0; k < c.zeros; k++) {
        int all = vanishes_by_factors(f, &c, k);
        if (all >= 0)
            return all;
    }
    return cagd_is_zero_f(f);
}

/* What is 0, and what is not: f <= 0 and -f <= 0 are one equation.  Of a text that is not understood nothing is concluded. */
static struct conditions conditions_of(const struct lab_compared *compared)
{
    struct conditions c = {0, 0, {{NULL}}, {{NULL}}};
    cagd_num_f f[LAB_MOST_COMPARED];
    int holding[LAB_MOST_COMPARED], count = 0;
    for (int k = 0; k < compared->count; k++) {
        const int read = read_function(compared->polynomial[k], &f[count]);
        int at = 0;
        cagd_region_faults = 0;
        if (!read)
            continue;
        const cagd_num_f opposite = cagd_neg_f(f[count]);
        while (at < count && !cagd_equal_f(f[at], f[count]) && !cagd_equal_f(f[at], opposite))
            at++;
        if (at == count)
            holding[at] = CAGD_CODE_ZERO | CAGD_CODE_ABOVE | CAGD_CODE_BELOW;
        const int same = at == count || cagd_equal_f(f[at], f[count]);
        holding[at] &= same ? compared->holding[k] : cagd_code_turned(compared->holding[k]);
        count += at == count;
    }
    for (int k = 0; k < count; k++)
        if (holding[k] == CAGD_CODE_ZERO)
            c.zero[c.zeros++] = f[k];
        else if ((holding[k] & CAGD_CODE_ZERO) == 0)
            c.other[c.others++] = f[k];
    return c;
}

int lab_same_where(const char *a, const char *b, const struct lab_compared *compared)
{
    cagd_region_mark mark = cagd_region_open();
    cagd_num_f x, y;
    cagd_field_open(CAGD_FIELD_MAX_VARIABLES);
    const int same = read_function(a, &x) && read_function(b, &y) &&
                     vanishes_where(cagd_sub_f(x, y), conditions_of(compared)) && cagd_region_faults == 0;
    cagd_region_faults = 0;
    cagd_region_drop(mark);
    return same;
}

/* The one variable of a polynomial; 0 where there is none, or more. */
static int only_variable(cagd_num_f f, cagd_num_f *variable)
{
    cagd_num_f v[CAGD_FIELD_MAX_VARIABLES];
    const int count = variables(v);
    int found = 0;
    for (int k = 0; k < count; k++)
        if (cagd_degree_f(f, v[k]) > 0) {
            *variable = v[k];
            found++;
        }
    return found == 1;
}

int lab_is_zero_at_no_fraction(const char *polynomial)
{
    cagd_region_mark mark = cagd_region_open();
    cagd_num_f f, x, factor[MOST_FACTORS];
    int power[MOST_FACTORS], none = 0;
    cagd_field_open(CAGD_FIELD_MAX_VARIABLES);
    if (read_function(polynomial, &f) && only_variable(f, &x)) {
        int factors = cagd_factors_f(f, x, MOST_FACTORS, factor, power);
        none = factors > 0;
        for (int k = 0; k < factors; k++)
            none = none && cagd_degree_f(factor[k], x) > 1;
        none = none && cagd_region_faults == 0;
    }
    cagd_region_faults = 0;
    cagd_region_drop(mark);
    return none;
}
