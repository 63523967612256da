#include "exact/expression/induction.h"

#include "exact/expression/depends.h"
#include "exact/expression/radical.h"
#include "exact/words.h"

#include <stdio.h>
#include <string.h>

enum { FURTHEST = 1000, MOST_SHIFT = 20, MOST_BY = 4 };

static num_f plus(num_f a, long m) { return add_f(a, from_int_f(m)); }

/* Whether what is summed has n in it besides its own letter: by name, or in a letter that stands for a function of n. */
static int depends_on_n(const cagd_search *s, const cagd_tree *term, const char *letter, const cagd_frame *f)
{
    for (int m = 0; m < s->c.count; m++)
        if (!s->c.binding[m].value.rational && equal_f(s->c.binding[m].value.f, s->n) &&
            cagd_depends_on(s->c.scope, term, s->c.binding[m].key))
            return 1;
    for (; f != NULL; f = f->next)
        if (strcmp(f->head, letter) != 0 && !f->value.rational && cagd_tree_has(term, f->head) &&
            (degree_f(f->value.f, s->n) > 0 || denominator_degree_f(f->value.f, s->n) > 0))
            return 1;
    return 0;
}

/* The term for that k. */
static int term_at(cagd_search *s, const cagd_tree *t, const cagd_frame *f, num_f k, num_f *out)
{
    cagd_frame inner = {t->head, cagd_value_f(k), f};
    return cagd_closed(s, t->at[2], &inner, out);
}

int cagd_sum_to_n(cagd_search *s, const cagd_tree *t, const cagd_frame *f, num_f *out)
{
    int p, c, is_sum = t->kind == CAGD_SUM_OVER;
    num_f first, last, one;
    num_q number;
    if (t->count != 3 || !cagd_value_in(s, t->at[0], f, &first) || !cagd_value_in(s, t->at[1], f, &last) ||
        !is_constant_f(first, &number) || !cagd_is_whole_q(number) ||
        mpz_cmpabs_ui(mpq_numref(number.at), FURTHEST) > 0 || !cagd_linear_with_n(s, last, &p, &c) || p < 1 ||
        p > MOST_BY || c > MOST_SHIFT || c < -MOST_SHIFT || depends_on_n(s, t->at[2], t->head, f))
        return 0;
    long low = mpz_get_si(mpq_numref(number.at)), shortest = (long)p * s->from + (c < 0 ? c : 0);
    if (shortest < low - 1) /* over nothing: no smaller sum is had by taking terms away */
        return 0;
    cagd_growth g = {
        is_sum ? CAGD_OF_SUM : CAGD_OF_PRODUCT, p, from_int_f(1), low, t, {0}, from_int_f(1), from_int_f(0)};
    num_f end = mul_f(from_int_f(p), s->n);
    for (int i = 1; i <= p; i++) {
        if (!term_at(s, t, f, plus(end, i), &one))
            return 0;
        if (is_sum)
            g.plus = add_f(g.plus, one);
        else
            g.times = mul_f(g.times, one);
    }
    if (!cagd_growth_variable(s, g, out))
        return 0;
    for (int i = 0; i < (c < 0 ? -c : c); i++) { /* further terms, or fewer */
        if (!term_at(s, t, f, plus(end, c < 0 ? -i : i + 1), &one))
            return 0;
        *out = is_sum ? (c < 0 ? sub_f(*out, one) : add_f(*out, one)) : (c < 0 ? div_f(*out, one) : mul_f(*out, one));
    }
    return region_faults == 0;
}

/* a(n+1): every variable becomes what it is there. */
static num_f next(const cagd_search *s, num_f a)
{
    num_f here[CAGD_MOST_GROWTHS];
    for (int i = 0; i < s->growths; i++) { /* all at once: a rule has other variables */
        char name[16];
        snprintf(name, sizeof name, "z%d", i);
        here[i] = variable_f(name);
        a = substitute_f(a, s->growth[i].w, here[i]);
    }
    a = substitute_f(a, s->n, plus(s->n, 1));
    for (int i = 0; i < s->growths; i++) {
        const cagd_growth *g = &s->growth[i];
        a = substitute_f(a, here[i], add_f(mul_f(g->times, g->w), g->plus));
    }
    return a;
}

/* The same value with w^2 = 1 for w = (-1)^n in the numerator. */
static num_f reduced(const cagd_search *s, num_f a)
{
    num_f p = cagd_numerator_f(a), below = cagd_denominator_f(a);
    for (int i = 0; i < s->growths; i++) {
        cagd_square_root sign = {s->growth[i].w, from_int_f(1)};
        if (s->growth[i].kind == CAGD_OF_POWER && equal_f(s->growth[i].base, from_int_f(-1)))
            p = cagd_without_powers(p, 1, &sign);
    }
    return div_f(p, below);
}

/* Whether some letter for a power, factorial, sum or product is in it: a rational function of n alone that is not 0 is no number 0 for all n. */
static int has_growth(const cagd_search *s, num_f a)
{
    for (int i = 0; i < s->growths; i++)
        if (degree_f(a, s->growth[i].w) > 0)
            return 1;
    return 0;
}

int cagd_vanishes_by_induction(const cagd_search *s, num_f E, num_f *N, num_f *r)
{
    if (!cagd_is_defined_for_every(s, E))
        return 0;
    num_f here = cagd_numerator_f(reduced(s, E)), there = reduced(s, next(s, here));
    if (region_faults != 0 || !has_growth(s, here))
        return 0;
    *N = here, *r = div_f(there, here);
    return cagd_is_defined_for_every(s, *r) && region_faults == 0;
}
