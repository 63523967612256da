#include "exact/expression/closed.h"

#include "exact/expression/induction.h"
#include "exact/words.h"

#include <stdio.h>
#include <stdlib.h>

enum { MOST_DEPTH = 60, MOST_SHIFT = 60, MOST_FACTORS = 64, FURTHEST = 1000, LARGEST = 1000000, MOST_POLYNOMIAL = 40 };

static num_f plus(num_f a, long m) { return add_f(a, from_int_f(m)); }

/* ---- b^n and (p n)! -------------------------------------------------------------------------------------- */

static int is_same(const cagd_growth *a, const cagd_growth *b)
{
    return a->kind == b->kind && a->by == b->by && a->low == b->low && cagd_equal_f(a->base, b->base) &&
           cagd_equal_f(a->times, b->times) && cagd_equal_f(a->plus, b->plus);
}

int cagd_growth_variable(cagd_search *s, cagd_growth growth, num_f *w)
{
    char name[16];
    for (int i = 0; i < s->growths; i++)
        if (is_same(&s->growth[i], &growth)) {
            *w = s->growth[i].w;
            return 1;
        }
    if (s->growths == CAGD_MOST_GROWTHS)
        return 0;
    snprintf(name, sizeof name, "w%d", s->growths);
    growth.w = *w = variable_f(name);
    s->growth[s->growths++] = growth;
    return region_faults == 0;
}

/* (p n)!, (p n + p)! = (p n)! (p n + 1) ... (p n + p). */
static int factorial_variable(cagd_search *s, int p, num_f *w)
{
    cagd_growth g = {CAGD_OF_FACTORIAL, p, from_int_f(1), 0, NULL, {0}, from_int_f(1), from_int_f(0)};
    for (int i = 1; i <= p; i++)
        g.times = mul_f(g.times, plus(mul_f(from_int_f(p), s->n), i));
    return cagd_growth_variable(s, g, w);
}

int cagd_linear_with_n(cagd_search *s, num_f v, int *p, int *c)
{
    int q;
    num_f rest;
    num_q whole;
    if (!cagd_linear_in(s, v, p, &q, &rest) || q != 0 || !is_constant_f(rest, &whole) || !cagd_is_whole_q(whole) ||
        mpz_cmpabs_ui(mpq_numref(whole.at), MOST_SHIFT) > 0)
        return 0;
    *c = (int)mpz_get_si(mpq_numref(whole.at));
    return 1;
}

/* (p n + c)! = (p n)! (p n + 1) ... (p n + c), and for c < 0 (p n)! over p n (p n - 1) ... (p n + c + 1). */
static int factorial(cagd_search *s, num_f v, num_f *out)
{
    int p, c;
    if (!cagd_linear_with_n(s, v, &p, &c) || p <= 0 || !factorial_variable(s, p, out))
        return 0;
    num_f pn = mul_f(from_int_f(p), s->n);
    for (int i = 1; i <= c; i++)
        *out = mul_f(*out, plus(pn, i));
    for (int i = 0; i < -c; i++)
        *out = div_f(*out, plus(pn, -i));
    return 1;
}

/* Whether a = p n + c is at least 0 for every n. */
static int is_never_negative(cagd_search *s, num_f a)
{
    int p, c;
    return cagd_linear_with_n(s, a, &p, &c) && p >= 0 && p * s->from + c >= 0;
}

/* C(a,b) for a whole number b, or a - b where a is not negative, which makes it C(a,a-b); otherwise of factorials. */
static int binomial(cagd_search *s, num_f a, num_f b, num_f *out)
{
    num_q lower;
    num_f other = sub_f(a, b), x, y, z;
    if (is_constant_f(b, &lower) || (is_constant_f(other, &lower) && is_never_negative(s, a))) {
        long m = cagd_is_whole_q(lower) && mpz_cmpabs_ui(mpq_numref(lower.at), MOST_SHIFT) <= 0
                     ? mpz_get_si(mpq_numref(lower.at))
                     : -1;
        *out = from_int_f(1);
        for (long i = 0; i < m; i++)
            *out = mul_f(*out, div_f(plus(a, -i), from_int_f(i + 1)));
        if (cagd_is_whole_q(lower) && mpq_sgn(lower.at) < 0 && is_never_negative(s, a)) /* C(a,-m) = C(a,a+m) = 0 */
            *out = from_int_f(0), m = 0;
        return m >= 0;
    }
    if (!factorial(s, a, &x) || !factorial(s, b, &y) || !factorial(s, other, &z))
        return 0;
    *out = div_f(x, mul_f(y, z));
    return 1;
}

/* b^(p n + c) = w^p b^c. */
static int power_of(cagd_search *s, num_f b, int p, int c, num_f *out)
{
    num_f w;
    if (cagd_is_zero_f(b) || degree_f(b, s->n) > 0 || denominator_degree_f(b, s->n) > 0 ||
        !cagd_growth_variable(s, (cagd_growth){CAGD_OF_POWER, 1, b, 0, NULL, {0}, b, from_int_f(0)}, &w))
        return 0;
    *out = mul_f(*out, mul_f(cagd_power_f(w, p), cagd_power_f(b, c)));
    return 1;
}

/* The same for a whole number b > 0, prime by prime, so that 4^n is 2^n 2^n. */
static int power_of_number(cagd_search *s, mpz_srcptr b, int p, int c, num_f *out)
{
    if (!mpz_fits_slong_p(b) || mpz_cmp_si(b, LARGEST) > 0)
        return 0;
    long rest = mpz_get_si(b);
    for (long prime = 2; rest > 1; prime += prime * prime > rest ? rest - prime : 1)
        for (; rest % prime == 0; rest /= prime)
            if (!power_of(s, from_int_f(prime), p, c, out))
                return 0;
    return 1;
}

/* Products, quotients and numbers factor by factor. */
static int power(cagd_search *s, const cagd_tree *base, const cagd_frame *f, int p, int c, num_f *out)
{
    num_f b;
    num_q number;
    if (base->kind == CAGD_PRODUCT || base->kind == CAGD_QUOTIENT) {
        for (int i = 0; i < base->count; i++) {
            int up = base->kind == CAGD_QUOTIENT && i == 1 ? -1 : 1;
            if (!power(s, base->at[i], f, up * p, up * c, out))
                return 0;
        }
        return 1;
    }
    if (!cagd_value_in(s, base, f, &b))
        return 0;
    if (!is_constant_f(b, &number))
        return power_of(s, b, p, c, out);
    num_q size = mpq_sgn(number.at) < 0 ? neg_q(number) : number;
    return mpq_sgn(number.at) != 0 && (mpq_sgn(number.at) > 0 || power_of(s, from_int_f(-1), p, c, out)) &&
           power_of_number(s, mpq_numref(size.at), p, c, out) && power_of_number(s, mpq_denref(size.at), -p, -c, out);
}

/* [e]_q = (q^e - 1)/(q - 1) for a name q and e = p n + c that is never negative: what is equal for all other q is equal for q = 1, too, both being
 * polynomials there. */
static int q_number(cagd_search *s, num_f e, const cagd_tree *q, const cagd_frame *f, num_f *out)
{
    int p, c;
    num_f base;
    if (!is_never_negative(s, e) || !cagd_linear_with_n(s, e, &p, &c) || !cagd_value_in(s, q, f, &base) ||
        is_constant_f(base, NULL))
        return 0;
    *out = from_int_f(1);
    if (p == 0)
        *out = cagd_power_f(base, c);
    else if (!power_of(s, base, p, c, out))
        return 0;
    *out = div_f(plus(*out, -1), plus(base, -1));
    return region_faults == 0;
}

/* ---- where it is defined ----------------------------------------------------------------------------------- */

int cagd_is_defined_for_every(const cagd_search *s, num_f value)
{
    num_f p = cagd_denominator_f(value), factor[MOST_FACTORS];
    int exponent[MOST_FACTORS];
    for (int i = 0; i < s->growths; i++) { /* powers and factorials alone are not 0 */
        int count = cagd_factors_f(p, s->growth[i].w, MOST_FACTORS, factor, exponent);
        for (int m = 0; m < count; m++) {
            if (s->growth[i].kind > CAGD_OF_FACTORIAL || !is_constant_f(div_f(factor[m], s->growth[i].w), NULL))
                return 0;
            p = div_f(p, cagd_power_f(factor[m], exponent[m]));
        }
        if (count < 0)
            return 0;
    }
    return region_faults == 0 && cagd_is_never_zero(p, s->n, s->k, s->from);
}

/* ---- values ------------------------------------------------------------------------------------------------ */

/* F(high+1) from F(high), as of a binomial coefficient that is 0 there: for high >= low. */
static int last_by_ratio(cagd_search *s, const cagd_tree *term, cagd_frame *inner, num_f high,
                         const cagd_product *terms, num_f *out)
{
    inner->value = cagd_value_f(high);
    if (!cagd_closed(s, term, inner, out))
        return 0;
    *out = mul_f(*out, substitute_f(terms->ratio.by_k, s->k, high));
    return region_faults == 0;
}

/* Of a polynomial F in k the G with G(k+1) - G(k) = F(k), G(0) = 0: by the differences of F at 0, F = sum_j D_j C(k,j) and G = sum_j D_j C(k,j+1). */
static num_f sum_of_polynomial(num_f F, num_f k, int degree)
{
    num_f value[MOST_POLYNOMIAL + 1], binomial = k, G = from_int_f(0);
    for (int j = 0; j <= degree; j++)
        value[j] = substitute_f(F, k, from_int_f(j));
    for (int j = 0; j <= degree; j++) {
        G = add_f(G, mul_f(value[0], binomial));
        binomial = div_f(mul_f(binomial, plus(k, -(j + 1))), from_int_f(j + 2));
        for (int i = 0; i < degree - j; i++)
            value[i] = sub_f(value[i + 1], value[i]);
    }
    return G;
}

/* The sum from `begin` to high, whose terms are a polynomial in k. */
static int of_polynomial(cagd_search *s, const cagd_tree *t, const cagd_frame *inner, cagd_range range, num_f high,
                         num_f *out)
{
    num_f F;
    if (!cagd_value_in(s, t->at[2], inner, &F) || denominator_degree_f(F, s->k) > 0 ||
        degree_f(F, s->k) > MOST_POLYNOMIAL || !cagd_divisors_are_not_zero(s, range))
        return 0;
    const num_f G = sum_of_polynomial(F, s->k, cagd_is_zero_f(F) ? 0 : degree_f(F, s->k)), next = plus(s->k, 1);
    if (region_faults != 0 || !cagd_equal_f(sub_f(substitute_f(G, s->k, next), G), F))
        return 0;
    *out = sub_f(substitute_f(G, s->k, plus(high, 1)), substitute_f(G, s->k, from_int_f(range.low)));
    s->closed[s->closed_sums++] = (cagd_closed_sum){t->head, from_int_f(1), G, 1};
    return region_faults == 0;
}

static int of_sum(cagd_search *s, const cagd_tree *t, const cagd_frame *f, num_f *out)
{
    num_f low, high, F;
    num_q first, last;
    cagd_product terms = {cagd_term_one(), from_int_f(1)};
    cagd_telescoper T;
    if (t->count != 3 || s->closed_sums == CAGD_MOST_CLOSED || !cagd_value_in(s, t->at[0], f, &low) ||
        !cagd_value_in(s, t->at[1], f, &high) || !is_constant_f(low, &first) ||
        !is_constant_f(sub_f(high, s->n), &last) || !cagd_is_whole_q(first) || !cagd_is_whole_q(last) ||
        mpz_cmpabs_ui(mpq_numref(first.at), FURTHEST) > 0 || mpz_cmpabs_ui(mpq_numref(last.at), FURTHEST) > 0)
        return 0;
    long begin = mpz_get_si(mpq_numref(first.at)), end = mpz_get_si(mpq_numref(last.at));
    cagd_frame inner = {t->head, {.f = s->k}, f};
    if (s->from + end + 1 >= begin && of_polynomial(s, t, &inner, cagd_range_to_n(begin, end), high, out))
        return 1;
    region_faults &= FAULT_MEMORY | FAULT_CROWDED;
    if (s->from + end + 1 < begin || !cagd_take_within(s, t->at[2], &inner, cagd_range_to_n(begin, end), &terms) ||
        !cagd_divisors_are_not_zero(s, cagd_range_to_n(begin, end)))
        return 0;
    while (begin < FURTHEST && cagd_is_zero_f(substitute_f(terms.rational, s->k, from_int_f(begin))) &&
           region_faults == 0)
        begin++; /* terms that are 0, so that the ratios of the others are defined */
    if (s->from + end + 1 < begin || !cagd_telescope(terms.ratio, s->n, s->k, 0, &T) ||
        !cagd_telescoper_holds(terms.ratio, s->n, s->k, &T) ||
        !cagd_divides_in_range(s, T.R, cagd_range_to_n(begin, end + 1)) ||
        !cagd_divides_in_range(s, terms.ratio.by_k, cagd_range_to_n(begin, end)) ||
        !cagd_is_never_zero(T.a[0], s->n, s->k, s->from))
        return 0;
    /* G(high+1) - G(begin). */
    const num_f at[] = {from_int_f(begin), plus(high, 1)};
    num_f G[2];
    for (int i = 0; i < 2; i++) {
        inner.value = cagd_value_f(at[i]);
        if (!cagd_closed(s, t->at[2], &inner, &F) && (i == 0 || !last_by_ratio(s, t->at[2], &inner, high, &terms, &F)))
            return 0;
        G[i] = mul_f(substitute_f(T.R, s->k, at[i]), F);
    }
    *out = div_f(sub_f(G[1], G[0]), T.a[0]);
    s->closed[s->closed_sums++] = (cagd_closed_sum){t->head, T.a[0], T.R, 0};
    return region_faults == 0;
}

static int of_name(cagd_search *s, const cagd_tree *t, const cagd_frame *f, num_f *out)
{
    cagd_frame room[CAGD_MOST_CHILDREN];
    const cagd_frame *inner;
    const cagd_tree *body = cagd_called_body(s, t, f, room, &inner);
    return body != NULL && cagd_closed(s, body, inner, out);
}

static int of_parts(cagd_search *s, const cagd_tree *t, const cagd_frame *f, num_f *out)
{
    num_f a;
    *out = from_int_f(t->kind == CAGD_SUM || t->kind == CAGD_NEGATIVE ? 0 : 1);
    for (int i = 0; i < t->count; i++) {
        if (!cagd_closed(s, t->at[i], f, &a) ||
            (t->kind == CAGD_QUOTIENT && i == 1 && !cagd_is_defined_for_every(s, div_f(from_int_f(1), a))))
            return 0;
        *out = t->kind == CAGD_SUM                  ? add_f(*out, a)
               : t->kind == CAGD_NEGATIVE           ? sub_f(*out, a)
               : t->kind == CAGD_QUOTIENT && i == 1 ? div_f(*out, a)
                                                    : mul_f(*out, a);
    }
    return region_faults == 0;
}

int cagd_closed(cagd_search *s, const cagd_tree *t, const cagd_frame *f, num_f *out)
{
    num_f a, b;
    int p, c;
    if (s->depth == MOST_DEPTH)
        return 0;
    if (cagd_value_in(s, t, f, out))
        return cagd_divisors_are_not_zero(s, cagd_range_to_n(0, 0)) && cagd_is_defined_for_every(s, *out);
    int good = 0;
    s->depth++;
    switch (t->kind) {
    case CAGD_SUM:
    case CAGD_PRODUCT:
    case CAGD_NEGATIVE:
    case CAGD_QUOTIENT:
        good = of_parts(s, t, f, out);
        break;
    case CAGD_POWER:
        *out = from_int_f(1);
        if (!cagd_value_in(s, t->at[1], f, &a) || !cagd_linear_with_n(s, a, &p, &c))
            break;
        good = p != 0 ? power(s, t->at[0], f, p, c, out) : cagd_closed(s, t->at[0], f, &b);
        *out = p == 0 && good ? cagd_power_f(b, c) : *out;
        break;
    case CAGD_FACTORIAL:
        good = cagd_value_in(s, t->at[0], f, &a) && factorial(s, a, out);
        break;
    case CAGD_BINOMIAL:
        good = cagd_value_in(s, t->at[0], f, &a) && cagd_value_in(s, t->at[1], f, &b) && binomial(s, a, b, out);
        break;
    case CAGD_Q_NUMBER:
        good = cagd_value_in(s, t->at[0], f, &a) && q_number(s, a, t->at[1], f, out);
        break;
    case CAGD_SUM_OVER:
        good = of_sum(s, t, f, out) || cagd_sum_to_n(s, t, f, out);
        break;
    case CAGD_PRODUCT_OVER:
        good = cagd_sum_to_n(s, t, f, out);
        break;
    case CAGD_NAME:
        good = of_name(s, t, f, out);
        break;
    default:
        break;
    }
    s->depth--;
    good = good && region_faults == 0 && cagd_is_defined_for_every(s, *out);
    region_faults &= FAULT_MEMORY | FAULT_CROWDED;
    return good;
}

int cagd_equal_closed(const cagd_search *s, num_f a, num_f b)
{
    num_f difference = sub_f(a, b);
    for (int i = 0; i < s->growths; i++)
        if (s->growth[i].kind == CAGD_OF_POWER && cagd_equal_f(s->growth[i].base, from_int_f(-1)))
            return cagd_is_zero_f(substitute_f(difference, s->growth[i].w, from_int_f(1))) &&
                   cagd_is_zero_f(substitute_f(difference, s->growth[i].w, from_int_f(-1)));
    return cagd_is_zero_f(difference);
}
