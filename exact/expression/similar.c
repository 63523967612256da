#include "exact/expression/similar.h"

#include "exact/expression/cell.h"
#include "exact/words.h"

#include <stdio.h>
#include <string.h>

enum { MOST_CLASSES = 24, MOST_DEPTH = 60, MOST_SHIFT = 60, MOST_FACTORS = 32, MOST_TERMS = 40, LARGEST = 1000000 };

static num_f plus(num_f a, long m) { return add_f(a, from_int_f(m)); }
static int depends(num_f a, num_f x) { return degree_f(a, x) > 0 || denominator_degree_f(a, x) > 0; }

/* Terms that are similar.  Binomial coefficients C(upper + c, lower + d) are multiples of w = C(upper + top, lower + right), with `right` the greatest d
 * and top - right the greatest c - d; factorials (upper + c)! of w = (upper + top)!, `top` the least c; powers of w = base^letter. */
typedef enum kind_of_class { OF_BINOMIALS, OF_FACTORIALS, OF_POWERS } kind_of_class;
typedef struct similar_class {
    kind_of_class kind;
    num_f upper, lower, base, w;
    long top, right, ahead; /* ahead: the greatest c - d */
    int letter;
    int never_zero;
} similar_class;

struct letter {
    num_f x, low, high;
    int has_high;
};

/* `counting`: the first time, when only the shifts c and d are looked at. */
typedef struct similar {
    cagd_search s;
    struct letter letter[CAGD_MOST_LETTERS];
    int letters;
    similar_class of[MOST_CLASSES];
    int classes;
    int counting, by_factorials;
    cagd_every *told;
} similar;

/* ---- linear forms in the whole numbers -------------------------------------------------------------------- */

/* v as sum p_m x_m + c with whole p_m and c. */
static int split(const similar *s, num_f v, int p[], long *c)
{
    num_q number;
    for (int m = 0; m < s->letters; m++) {
        if (!is_constant_f(derivative_f(v, s->letter[m].x), &number) || !cagd_is_whole_q(number) ||
            mpz_cmpabs_ui(mpq_numref(number.at), MOST_SHIFT) > 0)
            return 0;
        p[m] = (int)mpz_get_si(mpq_numref(number.at));
        v = sub_f(v, mul_f(from_int_f(p[m]), s->letter[m].x));
    }
    if (!is_constant_f(v, &number) || !cagd_is_whole_q(number) || mpz_cmpabs_ui(mpq_numref(number.at), LARGEST) > 0)
        return 0;
    *c = mpz_get_si(mpq_numref(number.at));
    return 1;
}

/* Whether the form is >= bound for all choices: each number in turn, from the last one on, goes to the end of its range where the form is less. */
static int is_at_least(const similar *s, num_f form, long bound)
{
    num_q number;
    for (int m = s->letters - 1; m >= 0; m--) {
        const struct letter *l = &s->letter[m];
        if (!is_constant_f(derivative_f(form, l->x), &number))
            return 0;
        const int up = mpq_sgn(number.at) > 0;
        if (!up && mpq_sgn(number.at) < 0 && !l->has_high)
            return 0;
        form = substitute_f(form, l->x, up || !l->has_high ? l->low : l->high);
    }
    return is_constant_f(form, &number) && mpq_sgn(sub_q(number, from_int_q(bound)).at) >= 0;
}

static int is_free_of_letters(const similar *s, num_f a)
{
    for (int m = 0; m < s->letters; m++)
        if (depends(a, s->letter[m].x))
            return 0;
    return 1;
}

/* Whether the polynomial p in the numbers and names is the function 0 for no choice: its factors are free of the numbers, or linear in them alone and of
 * one sign. */
static int is_zero_for_no_choice(const similar *s, num_f p)
{
    num_f factor[MOST_FACTORS];
    int power[MOST_FACTORS], unused[CAGD_MOST_LETTERS];
    long c;
    for (int m = 0; m < s->letters; m++) {
        int count = cagd_factors_f(p, s->letter[m].x, MOST_FACTORS, factor, power);
        for (int i = 0; i < count; i++) {
            if (!split(s, factor[i], unused, &c) ||
                (!is_at_least(s, factor[i], 1) && !is_at_least(s, neg_f(factor[i]), 1)))
                return 0;
            p = div_f(p, cagd_power_f(factor[i], power[i]));
        }
        if (count < 0)
            return 0;
    }
    return region_faults == 0 && !cagd_is_zero_f(p) && is_free_of_letters(s, p);
}

/* The same of a value with the variables of classes, which are not 0 themselves where that is known. */
static int divides(const similar *s, num_f value)
{
    num_f p = cagd_numerator_f(value), factor[MOST_FACTORS];
    int power[MOST_FACTORS];
    for (int i = 0; i < s->classes; i++) {
        const similar_class *class = &s->of[i];
        int count = cagd_factors_f(p, class->w, MOST_FACTORS, factor, power);
        for (int m = 0; m < count; m++) {
            if (!class->never_zero || !is_constant_f(div_f(factor[m], class->w), NULL))
                return 0;
            p = div_f(p, cagd_power_f(factor[m], power[m]));
        }
        if (count < 0)
            return 0;
    }
    return is_zero_for_no_choice(s, p);
}

/* ---- classes ---------------------------------------------------------------------------------------------- */

static similar_class *new_class(similar *s, similar_class class)
{
    char name[16];
    if (s->classes == MOST_CLASSES)
        return NULL;
    snprintf(name, sizeof name, "w%d", s->classes);
    class.w = variable_f(name);
    s->of[s->classes] = class;
    return &s->of[s->classes++];
}

enum { ROOM = 200 };

/* A product of linear forms over another one, as it is told. */
typedef struct quotient {
    num_f value;
    char over[ROOM], under[ROOM];
    int overs, unders;
} quotient;

static void write_factor(char text[ROOM], int *count, const char *form)
{
    const size_t used = strlen(text);
    const int alone = strpbrk(form, "+-*") == NULL;
    snprintf(text + used, ROOM - used, "%s%s%s%s", *count > 0 && alone ? " " : "", alone ? "" : "(", form,
             alone ? "" : ")");
    ++*count;
}

/* Times the form, or by `up` = -1 divided by it. */
static void times(const similar *s, quotient *q, num_f form, int up)
{
    q->value = up > 0 ? mul_f(q->value, form) : div_f(q->value, form);
    write_factor(up > 0 ? q->over : q->under, up > 0 ? &q->overs : &q->unders, cagd_in_letters(&s->s, form, "", ""));
}

/* What was rewritten is told once. */
static void tell(similar *s, const char *from, const quotient *factor, const char *to)
{
    cagd_every *e = s->told;
    if (s->counting || e->rewritten == CAGD_MOST_REWRITTEN || factor->overs + factor->unders == 0)
        return;
    for (int i = 0; i < e->rewritten; i++)
        if (strcmp(e->rewriting[i].from, from) == 0)
            return;
    char text[2 * ROOM + 8];
    snprintf(text, sizeof text,
             factor->unders == 0   ? "%s"
             : factor->unders == 1 ? "%s/%s"
                                   : "%s/(%s)",
             factor->overs == 0 ? "1" : factor->over, factor->under);
    e->rewriting[e->rewritten++] =
        (struct cagd_rewriting){cagd_text_of(from, (int)strlen(from)), cagd_text_of(text, (int)strlen(text)),
                                cagd_text_of(to, (int)strlen(to))};
}

/* (upper + c)! */
static int factorial(similar *s, num_f form, num_f *out)
{
    int p[CAGD_MOST_LETTERS];
    long c;
    similar_class *class = NULL;
    if (!split(s, form, p, &c) || !is_at_least(s, form, 0))
        return 0;
    const num_f upper = plus(form, -c);
    if (cagd_is_zero_f(upper)) { /* a number */
        *out = from_int_f(1);
        for (long i = 2; i <= c && c <= MOST_SHIFT; i++)
            *out = mul_f(*out, from_int_f(i));
        return c <= MOST_SHIFT;
    }
    for (int i = 0; i < s->classes && class == NULL; i++)
        if (s->of[i].kind == OF_FACTORIALS && cagd_equal_f(s->of[i].upper, upper))
            class = &s->of[i];
    if (class == NULL)
        class = new_class(s, (similar_class){.kind = OF_FACTORIALS, .upper = upper, .top = c, .never_zero = 1});
    if (class == NULL)
        return 0;
    if (s->counting)
        class->top = c < class->top ? c : class->top;
    if (c - class->top > MOST_SHIFT)
        return 0;
    quotient factor = {from_int_f(1), "", "", 0, 0};
    for (long i = class->top + 1; i <= c; i++)
        times(s, &factor, plus(upper, i), 1);
    char from[ROOM], to[ROOM];
    snprintf(from, sizeof from, "(%s)!", cagd_in_letters(&s->s, form, "", ""));
    snprintf(to, sizeof to, "(%s)!", cagd_in_letters(&s->s, plus(upper, class->top), "", ""));
    tell(s, from, &factor, to);
    *out = mul_f(factor.value, class->w);
    return region_faults == 0;
}

/* C(a,m) for a number m. */
static int few_of(num_f a, long m, num_f *out)
{
    *out = from_int_f(m < 0 ? 0 : 1);
    for (long i = 0; i < m && m <= MOST_SHIFT; i++)
        *out = mul_f(*out, div_f(plus(a, -i), from_int_f(i + 1)));
    return m <= MOST_SHIFT;
}

/* C(upper + c, lower + d); C(N,K) = C(N,N-K) where a class of these is there already. */
static similar_class *class_of_binomial(similar *s, num_f upper, long c, num_f *lower, long *d)
{
    const num_f mirrored = sub_f(upper, *lower);
    for (int swap = 0; swap < 2; swap++)
        for (int i = 0; i < s->classes; i++) {
            similar_class *class = &s->of[i];
            if (class->kind != OF_BINOMIALS || !cagd_equal_f(class->upper, upper) ||
                !cagd_equal_f(class->lower, swap ? mirrored : *lower))
                continue;
            if (swap)
                *lower = mirrored, *d = c - *d;
            return class;
        }
    return new_class(
        s, (similar_class){.kind = OF_BINOMIALS, .upper = upper, .lower = *lower, .right = *d, .ahead = c - *d});
}

static void write_binomial(const similar *s, num_f N, num_f K, char text[ROOM])
{
    snprintf(text, ROOM, "C(%s, %s)", cagd_in_letters(&s->s, N, "", ""), cagd_in_letters(&s->s, K, "", ""));
}

static int binomial(similar *s, num_f N, num_f K, num_f *out)
{
    int p[CAGD_MOST_LETTERS];
    long c, d;
    num_q number;
    if (is_constant_f(K, &number))
        return split(s, K, p, &d) && few_of(N, d, out);
    if (!split(s, N, p, &c) || !split(s, K, p, &d) || !is_at_least(s, N, 0))
        return 0;
    if (is_constant_f(sub_f(N, K), NULL))
        return few_of(N, c - d, out);
    const int inside = is_at_least(s, K, 0) && is_at_least(s, sub_f(N, K), 0);
    if (s->by_factorials) {
        num_f over, under, rest;
        if (!inside || !factorial(s, N, &over) || !factorial(s, K, &under) || !factorial(s, sub_f(N, K), &rest))
            return 0;
        *out = div_f(over, mul_f(under, rest));
        return region_faults == 0;
    }
    const num_f upper = plus(N, -c);
    num_f lower = plus(K, -d);
    quotient factor = {from_int_f(1), "", "", 0, 0};
    similar_class *class = class_of_binomial(s, upper, c, &lower, &d);
    if (class == NULL)
        return 0;
    if (s->counting) {
        class->right = d > class->right ? d : class->right;
        class->ahead = c - d > class->ahead ? c - d : class->ahead;
    }
    class->never_zero |= inside;
    const long aslant = class->right - d, straight = class->ahead - (c - d);
    if (aslant > MOST_SHIFT || straight > MOST_SHIFT)
        return 0;
    num_f above = plus(upper, c), below = plus(lower, d);
    for (long i = 1; i <= aslant; i++)
        times(s, &factor, plus(below, i), 1), times(s, &factor, plus(above, i), -1);
    above = plus(above, aslant), below = plus(below, aslant);
    for (long i = 1; i <= straight; i++)
        times(s, &factor, plus(sub_f(above, below), i), 1), times(s, &factor, plus(above, i), -1);
    char from[ROOM], to[ROOM];
    write_binomial(s, N, K, from);
    write_binomial(s, plus(above, straight), below, to);
    tell(s, from, &factor, to);
    *out = mul_f(factor.value, class->w);
    return region_faults == 0;
}

/* b^e for an irreducible b, or a prime number, or -1. */
static int power_of(similar *s, num_f b, const int p[], long c, num_f *out)
{
    if (c > MOST_SHIFT || c < -MOST_SHIFT)
        return 0;
    *out = mul_f(*out, cagd_power_f(b, (int)c));
    for (int m = 0; m < s->letters; m++) {
        similar_class *class = NULL;
        for (int i = 0; i < s->classes && class == NULL; i++)
            if (s->of[i].kind == OF_POWERS && s->of[i].letter == m && cagd_equal_f(s->of[i].base, b))
                class = &s->of[i];
        if (p[m] != 0 && class == NULL)
            class = new_class(s, (similar_class){.kind = OF_POWERS, .base = b, .letter = m, .never_zero = 1});
        if (p[m] != 0 && class == NULL)
            return 0;
        *out = p[m] != 0 ? mul_f(*out, cagd_power_f(class->w, p[m])) : *out;
    }
    return region_faults == 0;
}

static int power_of_number(similar *s, mpz_srcptr b, const int p[], long c, num_f *out)
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

/* The numerator, or by `up` = -1 the denominator, factor by factor. */
static int power_of_polynomial(similar *s, num_f b, int up, const int exponent[], long c, num_f *out)
{
    int p[CAGD_MOST_LETTERS], power[MOST_FACTORS], q[CAGD_MOST_LETTERS];
    num_f factor[MOST_FACTORS];
    num_q number;
    for (int m = 0; m < s->letters; m++)
        p[m] = up * exponent[m];
    for (int k = 0; k < s->s.c.count; k++) {
        if (!s->s.c.binding[k].unknown)
            continue;
        int count = cagd_factors_f(b, s->s.c.binding[k].value.f, MOST_FACTORS, factor, power);
        for (int i = 0; i < count; i++) {
            for (int m = 0; m < s->letters; m++)
                q[m] = power[i] * p[m];
            if (!power_of(s, factor[i], q, up * power[i] * c, out))
                return 0;
            b = div_f(b, cagd_power_f(factor[i], power[i]));
        }
        if (count < 0)
            return 0;
    }
    if (!is_constant_f(b, &number) || mpq_sgn(number.at) == 0)
        return 0;
    const num_q size = mpq_sgn(number.at) < 0 ? neg_q(number) : number;
    for (int m = 0; m < s->letters; m++)
        q[m] = -p[m];
    return (mpq_sgn(number.at) > 0 || power_of(s, from_int_f(-1), p, up * c, out)) &&
           power_of_number(s, mpq_numref(size.at), p, up * c, out) &&
           power_of_number(s, mpq_denref(size.at), q, -up * c, out);
}

/* ---- values ----------------------------------------------------------------------------------------------- */

static int value_of(similar *s, const cagd_tree *t, const cagd_frame *f, num_f *out);

static int of_power(similar *s, const cagd_tree *t, const cagd_frame *f, num_f *out)
{
    int p[CAGD_MOST_LETTERS], fixed = 1;
    long c;
    num_f exponent, base;
    if (!cagd_value_in(&s->s, t->at[1], f, &exponent) || !split(s, exponent, p, &c) || !value_of(s, t->at[0], f, &base))
        return 0;
    for (int m = 0; m < s->letters; m++)
        fixed &= p[m] == 0;
    if (fixed) {
        if (c > MOST_SHIFT || c < -MOST_SHIFT || (c < 0 && !s->counting && !divides(s, base)))
            return 0;
        *out = cagd_power_f(base, (int)c);
        return region_faults == 0;
    }
    for (int i = 0; i < s->classes; i++)
        if (depends(base, s->of[i].w))
            return 0;
    *out = from_int_f(1);
    return is_free_of_letters(s, base) && power_of_polynomial(s, cagd_numerator_f(base), 1, p, c, out) &&
           power_of_polynomial(s, cagd_denominator_f(base), -1, p, c, out);
}

/* d/dx, the powers b^N with it: d/dx b^N = N b'/b b^N. */
static num_f derived(const similar *s, num_f v, num_f x)
{
    num_f d = derivative_f(v, x);
    for (int i = 0; i < s->classes; i++) {
        const similar_class *class = &s->of[i];
        if (class->kind == OF_POWERS && depends(class->base, x) && depends(v, class->w))
            d = add_f(d, mul_f(mul_f(derivative_f(v, class->w), class->w),
                               mul_f(s->letter[class->letter].x, div_f(derivative_f(class->base, x), class->base))));
    }
    return d;
}

/* How often is derived; -1 where that is no number. */
static long order_of(similar *s, const cagd_tree *order, const cagd_frame *f)
{
    num_f v;
    num_q number;
    int good = cagd_value_in(&s->s, order, f, &v) && is_constant_f(v, &number) && cagd_is_whole_q(number) &&
               mpq_sgn(number.at) >= 0 && mpz_cmp_si(mpq_numref(number.at), MOST_SHIFT) <= 0;
    return good ? mpz_get_si(mpq_numref(number.at)) : -1;
}

/* Whether x is a name of the page, by which can be derived: none of the numbers. */
static int is_name(const similar *s, num_f x)
{
    int is = 0;
    for (int k = s->letters; k < s->s.c.count; k++)
        is |= s->s.c.binding[k].unknown && cagd_equal_f(s->s.c.binding[k].value.f, x);
    return is;
}

/* f(x), f''(x), d^2/dx^2 ... */
static int of_derivative(similar *s, const cagd_tree *t, const cagd_frame *f, num_f *out)
{
    num_f x;
    long order;
    cagd_tree plain = *t;
    const cagd_tree letter = {.kind = CAGD_NAME, .head = t->head, .from = t->from, .to = t->to}, *by = &letter;
    if (t->kind == CAGD_NAME) {
        const int at = t->lower + t->upper;
        order = t->times != NULL ? order_of(s, t->times, f) : t->order;
        if (order < 0 || t->count <= at)
            return 0;
        plain.order = 0, plain.times = NULL, by = t->at[at];
    } else if (t->count == 2)
        order = order_of(s, t->at[1], f);
    else
        return 0;
    if (order < 0 || !cagd_value_in(&s->s, by, f, &x) || !is_name(s, x) ||
        !value_of(s, t->kind == CAGD_NAME ? &plain : t->at[0], f, out))
        return 0;
    for (; order > 0 && region_faults == 0; order--)
        *out = derived(s, *out, x);
    return region_faults == 0;
}

static int of_name(similar *s, const cagd_tree *t, const cagd_frame *f, num_f *out)
{
    cagd_frame room[CAGD_MOST_CHILDREN];
    const cagd_frame *inner;
    if (t->order > 0 || t->times != NULL)
        return of_derivative(s, t, f, out);
    const cagd_tree *body = cagd_called_body(&s->s, t, f, room, &inner);
    return body != NULL && value_of(s, body, inner, out);
}

/* A sum or product of few terms. */
static int of_few(similar *s, const cagd_tree *t, const cagd_frame *f, num_f *out)
{
    num_f low, high, length, one;
    num_q number;
    if (t->count != 3 || !cagd_value_in(&s->s, t->at[0], f, &low) || !cagd_value_in(&s->s, t->at[1], f, &high))
        return 0;
    length = sub_f(high, low);
    if (!is_constant_f(length, &number) || !cagd_is_whole_q(number) ||
        mpz_cmp_si(mpq_numref(number.at), MOST_TERMS) >= 0)
        return 0;
    const long last = mpz_get_si(mpq_numref(number.at));
    *out = from_int_f(t->kind == CAGD_SUM_OVER ? 0 : 1);
    for (long i = 0; i <= last; i++) {
        cagd_frame inner = {t->head, cagd_value_f(plus(low, i)), f};
        if (!value_of(s, t->at[2], &inner, &one))
            return 0;
        *out = t->kind == CAGD_SUM_OVER ? add_f(*out, one) : mul_f(*out, one);
    }
    return region_faults == 0;
}

static int of_parts(similar *s, const cagd_tree *t, const cagd_frame *f, num_f *out)
{
    num_f a;
    *out = from_int_f(t->kind == CAGD_SUM || t->kind == CAGD_NEGATIVE ? 0 : 1);
    for (int i = 0; i < t->count; i++) {
        const int divisor = t->kind == CAGD_QUOTIENT && i == 1;
        if (!value_of(s, t->at[i], f, &a) || (divisor && (cagd_is_zero_f(a) || (!s->counting && !divides(s, a)))))
            return 0;
        *out = t->kind == CAGD_SUM        ? add_f(*out, a)
               : t->kind == CAGD_NEGATIVE ? sub_f(*out, a)
               : divisor                  ? div_f(*out, a)
                                          : mul_f(*out, a);
    }
    return region_faults == 0;
}

/* The value of t as a rational function, if it is one without classes, whose divisors are not 0. */
static int plain_value(similar *s, const cagd_tree *t, const cagd_frame *f, num_f *out)
{
    s->s.c.divisors = 0;
    int is = cagd_value_in(&s->s, t, f, out);
    for (int i = 0; is && i < s->s.c.divisors; i++)
        is = is_zero_for_no_choice(s, cagd_numerator_f(s->s.divisor[i])) &&
             !cagd_is_zero_f(cagd_denominator_f(s->s.divisor[i]));
    is = is && s->s.c.divisors < CAGD_MOST_DIVISORS;
    s->s.c.divisors = 0;
    return is;
}

static int value_of(similar *s, const cagd_tree *t, const cagd_frame *f, num_f *out)
{
    num_f a, b;
    if (s->s.depth == MOST_DEPTH || --s->s.c.steps < 0)
        return 0;
    if (plain_value(s, t, f, out))
        return 1;
    int good = 0;
    s->s.depth++;
    switch (t->kind) {
    case CAGD_SUM:
    case CAGD_PRODUCT:
    case CAGD_NEGATIVE:
    case CAGD_QUOTIENT:
        good = of_parts(s, t, f, out);
        break;
    case CAGD_POWER:
        good = of_power(s, t, f, out);
        break;
    case CAGD_FACTORIAL:
        good = cagd_value_in(&s->s, t->at[0], f, &a) && factorial(s, a, out);
        break;
    case CAGD_BINOMIAL:
        good = cagd_value_in(&s->s, t->at[0], f, &a) && cagd_value_in(&s->s, t->at[1], f, &b) && binomial(s, a, b, out);
        break;
    case CAGD_SUM_OVER:
    case CAGD_PRODUCT_OVER:
        good = of_few(s, t, f, out);
        break;
    case CAGD_DERIVATIVE:
        good = of_derivative(s, t, f, out);
        break;
    case CAGD_NAME:
        good = of_name(s, t, f, out);
        break;
    default:
        break;
    }
    s->s.depth--;
    good = good && region_faults == 0;
    region_faults &= FAULT_MEMORY | FAULT_CROWDED;
    return good;
}

/* ---- statements ------------------------------------------------------------------------------------------- */

/* Ends that are open are moved to the next whole number. */
static int know_letter(similar *s, const cagd_variable *v)
{
    struct letter *l = &s->letter[s->letters];
    cagd_context *c = &s->s.c;
    char name[16];
    int p[CAGD_MOST_LETTERS];
    long constant;
    if (v->listed != NULL || v->low == NULL || !cagd_value_in(&s->s, v->low, NULL, &l->low) ||
        (v->high != NULL && !cagd_value_in(&s->s, v->high, NULL, &l->high)))
        return 0;
    l->has_high = v->high != NULL;
    l->low = plus(l->low, v->low_open);
    if (l->has_high)
        l->high = plus(l->high, -v->high_open);
    if (!split(s, l->low, p, &constant) || (l->has_high && !split(s, l->high, p, &constant)))
        return 0;
    snprintf(name, sizeof name, "v%d", s->letters);
    l->x = variable_f(name);
    cagd_binding *b = cagd_bind(c, v->head, (cagd_value){.f = l->x});
    b->unknown = 1, b->number = field_variable_f(l->x);
    c->whole[s->letters++] = l->x, c->wholes = s->letters;
    cagd_limit_cell(c, sub_f(l->x, l->low), 0);
    if (l->has_high)
        cagd_limit_cell(c, sub_f(l->high, l->x), 0);
    return region_faults == 0;
}

static int know_letters(similar *s, const cagd_scope *scope, const cagd_variable *const list[], int count)
{
    s->s = (cagd_search){.c = {.scope = scope, .in_field = 1, .steps = 100 * CAGD_USUAL_STEPS}};
    s->s.c.divisor = s->s.divisor, s->s.c.most_divisors = CAGD_MOST_DIVISORS;
    s->letters = 0;
    for (int m = 0; m < count; m++)
        if (!know_letter(s, list[m]))
            return 0;
    return 1;
}

/* Whether a is 0, with (-1)^N, whose square is 1, of either sign. */
static int vanishes(const similar *s, num_f a, int from)
{
    while (from < s->classes && !(s->of[from].kind == OF_POWERS && cagd_equal_f(s->of[from].base, from_int_f(-1))))
        from++;
    if (from == s->classes)
        return cagd_is_zero_f(a) && region_faults == 0;
    return vanishes(s, substitute_f(a, s->of[from].w, from_int_f(1)), from + 1) &&
           vanishes(s, substitute_f(a, s->of[from].w, from_int_f(-1)), from + 1);
}

/* All sides of the chain, twice: when their shifts are known they are multiples of the same terms. */
static int sides_are_equal(similar *s, const cagd_tree *t)
{
    num_f before = from_int_f(0), value;
    for (s->counting = 1; s->counting >= 0; s->counting--)
        for (int i = 0; i < t->count; i++, before = value) {
            if (t->at[i]->dimension != 0 || !value_of(s, t->at[i], NULL, &value) ||
                (i > 0 && t->relation[i - 1] != CAGD_EQUAL) ||
                (i > 0 && !s->counting && !vanishes(s, sub_f(before, value), 0)))
                return 0;
        }
    return 1;
}

static int holds(similar *s, const cagd_scope *scope, const cagd_tree *t, const cagd_variable *const list[], int count)
{
    int good = t->kind == CAGD_RELATION || t->kind == CAGD_ALL;
    for (int i = 0; t->kind == CAGD_ALL && i < t->count && good; i++)
        good = holds(s, scope, t->at[i], list, count);
    if (t->kind != CAGD_RELATION)
        return good;
    const int told = s->told->rewritten;
    for (s->by_factorials = 0; s->by_factorials < 2; s->by_factorials++) {
        s->classes = 0, s->told->rewritten = told;
        if (know_letters(s, scope, list, count) && sides_are_equal(s, t)) {
            s->told->by_factorials |= s->by_factorials;
            return 1;
        }
        region_faults &= FAULT_MEMORY | FAULT_CROWDED;
    }
    return 0;
}

int cagd_holds_for_every_choice(const cagd_scope *scope, const cagd_tree *statement, const cagd_variable *const list[],
                                int count, cagd_every *out)
{
    similar *s = region_bytes(sizeof *s);
    if (s == NULL || count < 1 || count > CAGD_MOST_LETTERS)
        return 0;
    *out = (cagd_every){.similar = 1, .n = "", .k = "", .R = ""};
    *s = (similar){.told = out};
    return holds(s, scope, statement, list, count) && region_faults == 0;
}
