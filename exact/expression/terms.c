#include "exact/expression/terms.h"

#include "exact/expression/cell.h"
#include "exact/words.h"

#include <stdio.h>
#include <string.h>

enum { MOST_DEPTH = 60, MOST_POWER = 60, FURTHEST = 3000 };

static num_f plus(num_f a, long m) { return add_f(a, from_int_f(m)); }

/* A variable of the field of which bounds may be known. */
static void variable_of(cagd_context *c, const char *key, num_f x)
{
    cagd_binding *b = cagd_bind(c, key, (cagd_value){.f = x});
    b->unknown = 1, b->number = field_variable_f(x);
}

void cagd_search_begin(cagd_search *s, const cagd_scope *scope, const char *n, int from)
{
    *s = (cagd_search){.c = {.scope = scope, .in_field = 1, .steps = 100 * CAGD_USUAL_STEPS}, .from = from};
    s->n = variable_f("vn"), s->k = variable_f("vk"), s->j = variable_f("vj");
    s->c.whole[0] = s->n, s->c.whole[1] = s->k, s->c.whole[2] = s->j, s->c.wholes = 3;
    s->c.divisor = s->divisor, s->c.most_divisors = CAGD_MOST_DIVISORS;
    variable_of(&s->c, n, s->n);
    variable_of(&s->c, "", s->k);
    cagd_limit_cell(&s->c, plus(s->n, -from), 0);
}

const char *cagd_in_letters(const cagd_search *s, num_f a, const char *n, const char *k)
{
    const char *text = cagd_to_string_f(a);
    size_t room = 8 * strlen(text) + 64, used = 0;
    char *out = region_bytes(room);
    for (const char *p = text; out != NULL && *p != '\0' && used + 64 < room;) {
        const char *word = NULL;
        size_t length = 0;
        if (strncmp(p, "vn", 2) == 0)
            word = n, length = 2;
        else if (strncmp(p, "vk", 2) == 0)
            word = k, length = 2;
        else if (p[0] == 'v') {
            length = 1 + strspn(p + 1, "0123456789");
            for (int m = 0; m < s->c.count; m++) {
                char name[16];
                snprintf(name, sizeof name, "v%d", m);
                if (strlen(name) == length && strncmp(name, p, length) == 0)
                    word = s->c.binding[m].key;
            }
        }
        if (word == NULL) {
            out[used++] = *p++;
            continue;
        }
        used += (size_t)snprintf(out + used, room - used, "%.60s", word);
        p += length;
    }
    if (out != NULL)
        out[used] = '\0';
    return out != NULL ? out : "";
}

cagd_range cagd_range_to_n(long low, long last) { return (cagd_range){0, 1, low, last}; }

static num_f multiple_of_n(const cagd_search *s, int by, long more) { return plus(mul_f(from_int_f(by), s->n), more); }

int cagd_take_within(cagd_search *s, const cagd_tree *t, const cagd_frame *f, cagd_range range, cagd_product *out)
{
    cagd_limit_cell(&s->c, sub_f(multiple_of_n(s, range.by, range.last), s->k), 0);
    cagd_limit_cell(&s->c, sub_f(s->k, multiple_of_n(s, range.low_by, range.low)), 0);
    int good = cagd_take(s, t, f, 1, out);
    cagd_binding *k = cagd_binding_of(&s->c, "");
    k->has_low = s->c.limits = s->c.memos = s->c.is_empty = 0;
    return good;
}

num_f cagd_power_f(num_f a, int e)
{
    num_f r = from_int_f(1);
    for (int i = 0; i < (e < 0 ? -e : e); i++)
        r = mul_f(r, a);
    return e < 0 ? div_f(from_int_f(1), r) : r;
}

/* With k counted from its first value, and N the last one: 0 <= k <= N, n = (N - length)/by. */
int cagd_divides_in_range(const cagd_search *s, num_f a, cagd_range range)
{
    int by = range.by - range.low_by;
    long length = range.last - range.low, from = by * (long)s->from + length;
    num_f p = cagd_denominator_f(a);
    if (by < 1 || (from > FURTHEST && degree_f(p, s->k) > 0))
        return 0;
    if (degree_f(p, s->k) == 0)
        return cagd_is_never_zero(p, s->n, s->k, s->from);
    p = substitute_f(p, s->k, add_f(s->k, multiple_of_n(s, range.low_by, range.low)));
    p = substitute_f(p, s->n, div_f(plus(s->n, -length), from_int_f(by)));
    return cagd_is_never_zero(cagd_numerator_f(p), s->n, s->k, (int)(from > 0 ? from : 0));
}

int cagd_divisors_are_not_zero(cagd_search *s, cagd_range range)
{
    int good = 1;
    for (int i = 0; i < s->c.divisors && good; i++)
        good = !cagd_is_zero_f(s->divisor[i]) && cagd_divides_in_range(s, div_f(from_int_f(1), s->divisor[i]), range);
    s->c.divisors = 0;
    return good;
}

int cagd_value_in(cagd_search *s, const cagd_tree *t, const cagd_frame *f, num_f *out)
{
    cagd_value v = cagd_evaluate_in(&s->c, t, f);
    if (region_faults == 0) {
        *out = cagd_in_field(v);
        return 1;
    }
    region_faults &= FAULT_MEMORY | FAULT_CROWDED;
    s->c.trouble = s->c.split = NULL, s->c.has_cut = 0;
    return 0;
}

int cagd_linear_in(cagd_search *s, num_f v, int *p, int *q, num_f *c)
{
    num_f variable[] = {s->n, s->k};
    int *slope[] = {p, q};
    *c = v;
    for (int i = 0; i < 2; i++) {
        num_q d;
        if (!is_constant_f(derivative_f(v, variable[i]), &d) || !cagd_is_whole_q(d) ||
            !mpz_fits_sint_p(mpq_numref(d.at)))
            return 0;
        *slope[i] = (int)mpz_get_si(mpq_numref(d.at));
        if (*slope[i] > MOST_POWER || *slope[i] < -MOST_POWER)
            return 0;
        *c = sub_f(*c, mul_f(from_int_f(*slope[i]), variable[i]));
    }
    return 1;
}

static int take_factorial(cagd_search *s, num_f a, int e, cagd_product *out)
{
    int p, q;
    num_f c;
    if (!cagd_linear_in(s, a, &p, &q, &c))
        return 0;
    out->ratio = cagd_term_times_factorial(out->ratio, s->n, s->k, p, q, c, e);
    return 1;
}

static int take_power(cagd_search *s, const cagd_tree *t, const cagd_frame *f, int e, cagd_product *out)
{
    num_f exponent, base, c;
    num_q whole;
    int p, q;
    if (!cagd_value_in(s, t->at[1], f, &exponent))
        return 0;
    if (is_constant_f(exponent, &whole))
        return cagd_is_whole_q(whole) && mpz_cmpabs_ui(mpq_numref(whole.at), MOST_POWER) < 0 &&
               cagd_take(s, t->at[0], f, e * (int)mpz_get_si(mpq_numref(whole.at)), out);
    if (!cagd_value_in(s, t->at[0], f, &base) || !cagd_linear_in(s, exponent, &p, &q, &c) ||
        !is_constant_f(c, &whole) || !cagd_is_whole_q(whole) || cagd_is_zero_f(base) || degree_f(base, s->n) > 0 ||
        degree_f(base, s->k) > 0 || denominator_degree_f(base, s->n) > 0 || denominator_degree_f(base, s->k) > 0)
        return 0;
    out->ratio = cagd_term_times_power(out->ratio, base, e * p, e * q);
    return 1;
}

/* ---- products over a range ------------------------------------------------------------------------------ */

enum { MOST_FACTORS = 24 };

/* Whether the linear form in n and k is at least 0 for all n and k that are looked at. */
static int is_never_negative(cagd_search *s, num_f a)
{
    unsigned signs = cagd_signs_of_form(&s->c, a);
    s->c.split = NULL, s->c.has_cut = 0;
    return region_faults == 0 && (signs & CAGD_CAN_BE_NEGATIVE) == 0;
}

/* The factor f^e of the terms of a product over j = low, ..., high: with f = c j + r and r/c = p n + q k + d, it is the e-th power of
 * c^(high - low + 1) (high + r/c)!/(low - 1 + r/c)!. */
static int take_factor(cagd_search *s, num_f f, int e, num_f low, num_f high, cagd_product *out)
{
    num_f j = s->j, c = coefficient_f(f, j, 1), shift, d;
    num_q whole;
    int p, q;
    if (degree_f(f, j) != 1 || degree_f(c, s->n) > 0 || degree_f(c, s->k) > 0)
        return 0;
    shift = div_f(coefficient_f(f, j, 0), c);
    const num_f end[] = {add_f(high, shift), plus(add_f(low, shift), -1)};
    for (int i = 0; i < 2; i++) {
        if (!cagd_linear_in(s, end[i], &p, &q, &d))
            return 0;
        out->ratio = cagd_term_times_factorial(out->ratio, s->n, s->k, p, q, d, i == 0 ? e : -e);
    }
    if (!cagd_linear_in(s, plus(sub_f(high, low), 1), &p, &q, &d) || !is_constant_f(d, &whole) ||
        !cagd_is_whole_q(whole))
        return 0;
    out->ratio = cagd_term_times_power(out->ratio, cagd_power_f(c, e), p, q);
    return region_faults == 0;
}

/* prod_{j=low}^{high} f(j), a polynomial in j with factors of degree 1; the range is not less than empty, where it would be no ratio of
 * factorials. */
static int take_product(cagd_search *s, const cagd_tree *t, const cagd_frame *f, int e, cagd_product *out)
{
    num_f low, high, body, factor[MOST_FACTORS];
    num_q whole;
    int power[MOST_FACTORS], p, q, divisors = s->c.divisors;
    cagd_frame inner = {t->head, {.f = s->j}, f};
    if (t->count != 3 || !cagd_value_in(s, t->at[0], f, &low) || !cagd_value_in(s, t->at[1], f, &high) ||
        !cagd_value_in(s, t->at[2], &inner, &body) || s->c.divisors > divisors ||
        !is_constant_f(cagd_denominator_f(body), NULL) || !is_never_negative(s, plus(sub_f(high, low), 1)))
        return 0;
    int count = cagd_factors_f(body, s->j, MOST_FACTORS, factor, power);
    for (int i = 0; i < count; i++) {
        if (!take_factor(s, factor[i], e * power[i], low, high, out))
            return 0;
        body = div_f(body, cagd_power_f(factor[i], power[i]));
    }
    num_f length = plus(sub_f(high, low), 1), d; /* what is left is free of j */
    if (count < 0 || cagd_is_zero_f(body) || degree_f(body, s->n) > 0 || degree_f(body, s->k) > 0 ||
        !cagd_linear_in(s, length, &p, &q, &d) || !is_constant_f(d, &whole) || !cagd_is_whole_q(whole))
        return 0;
    out->ratio = cagd_term_times_power(out->ratio, cagd_power_f(body, e), p, q);
    return region_faults == 0;
}

const cagd_tree *cagd_called_body(cagd_search *s, const cagd_tree *t, const cagd_frame *f, cagd_frame room[],
                                  const cagd_frame **inner)
{
    const cagd_definition *d = cagd_defined(s->c.scope, t->head);
    cagd_value value[CAGD_MOST_CHILDREN];
    *inner = NULL;
    if (d == NULL || t->order > 0 || t->times != NULL)
        return NULL;
    cagd_arguments_of(&s->c, t, d, f, value);
    const cagd_tree *body = region_faults == 0 ? cagd_body_of(&s->c, t, value, room, inner) : NULL;
    region_faults &= FAULT_MEMORY | FAULT_CROWDED;
    return body;
}

static int take_name(cagd_search *s, const cagd_tree *t, const cagd_frame *f, int e, cagd_product *out)
{
    cagd_frame room[CAGD_MOST_CHILDREN];
    const cagd_frame *inner;
    const cagd_tree *body = cagd_called_body(s, t, f, room, &inner);
    return body != NULL && cagd_take(s, body, inner, e, out);
}

int cagd_take(cagd_search *s, const cagd_tree *t, const cagd_frame *f, int e, cagd_product *out)
{
    num_f v, a, b;
    if (s->depth == MOST_DEPTH || e > MOST_POWER || e < -MOST_POWER)
        return 0;
    if (cagd_value_in(s, t, f, &v)) {
        if (cagd_is_zero_f(v) || (e < 0 && s->c.divisors == CAGD_MOST_DIVISORS))
            return 0;
        if (e < 0)
            s->divisor[s->c.divisors++] = v;
        num_f r = cagd_power_f(v, e);
        out->rational = mul_f(out->rational, r);
        out->ratio = cagd_term_times_rational(out->ratio, s->n, s->k, r);
        return region_faults == 0;
    }
    int good = 0;
    s->depth++;
    switch (t->kind) {
    case CAGD_PRODUCT:
        good = 1;
        for (int i = 0; i < t->count && good; i++)
            good = cagd_take(s, t->at[i], f, e, out);
        break;
    case CAGD_NEGATIVE:
        out->rational = e % 2 ? neg_f(out->rational) : out->rational;
        good = cagd_take(s, t->at[0], f, e, out);
        break;
    case CAGD_QUOTIENT:
        good = cagd_take(s, t->at[0], f, e, out) && cagd_take(s, t->at[1], f, -e, out);
        break;
    case CAGD_POWER:
        good = take_power(s, t, f, e, out);
        break;
    case CAGD_FACTORIAL:
        good = cagd_value_in(s, t->at[0], f, &a) && take_factorial(s, a, e, out);
        break;
    case CAGD_BINOMIAL:
        good = cagd_value_in(s, t->at[0], f, &a) && cagd_value_in(s, t->at[1], f, &b) && take_factorial(s, a, e, out) &&
               take_factorial(s, b, -e, out) && take_factorial(s, sub_f(a, b), -e, out);
        break;
    case CAGD_PRODUCT_OVER:
        good = take_product(s, t, f, e, out);
        break;
    case CAGD_NAME:
        good = take_name(s, t, f, e, out);
        break;
    default:
        break;
    }
    s->depth--;
    return good && region_faults == 0;
}
