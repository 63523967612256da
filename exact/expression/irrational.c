#include "exact/expression/irrational.h"

#include "exact/expression/sign.h"
#include "exact/expression/tie.h"
#include "exact/words.h"

enum { ROUNDS = 8 };

static cagd_side_of_box side_of(const cagd_binding *b)
{
    return (cagd_side_of_box){b->value.f, b->has_low, b->has_high, b->low_open, b->high_open, b->low, b->high};
}

/* Whether all that is known of the names are roots and bounds that are numbers; how many roots there are, and the binding of the last. */
static int has_bounds_alone(const cagd_context *c, int *roots, int *root)
{
    *root = -1, *roots = 0;
    for (int k = 0; k < c->count; k++) {
        const cagd_binding *b = &c->binding[k];
        const cagd_variable *v = b->variable;
        if (b->solved || b->is_root_end[0] || b->is_root_end[1])
            return 0;
        if (b->unknown && v != NULL && ((v->low != NULL && !b->has_low) || (v->high != NULL && !b->has_high)))
            return 0;
        *root = b->has_root ? k : *root;
        *roots += b->has_root;
    }
    for (int k = 0; k < c->scope->condition_count; k++)
        if (c->scope->conditions[k]->kind == CAGD_EVERY_INDEX)
            return 0;
    return c->limits == 0 && c->missing == 0;
}

int cagd_find_sides(const cagd_context *c, const cagd_tree *t, int k, cagd_relation_sides *s)
{
    cagd_context *again = region_bytes(sizeof *again);
    if (again == NULL)
        return 0;
    *again = *c;
    again->divisor = s->divisor, again->most_divisors = CAGD_MOST_DIVISORS_OF_SIDES, again->divisors = 0;
    cagd_value d = cagd_value_sub(cagd_evaluate(again, t->at[k]), cagd_evaluate(again, t->at[k + 1]));
    s->divisors = again->divisors, s->relation = t->relation[k];
    if (region_faults != 0 || s->divisors == CAGD_MOST_DIVISORS_OF_SIDES || again->count != c->count)
        return 0;
    num_f f = cagd_in_field(cagd_at_roots(c, d));
    s->n = cagd_numerator_f(f), s->m = cagd_denominator_f(f);
    return region_faults == 0;
}

/* p as a polynomial in x alone, the other names having values. */
static poly at_values(const cagd_context *c, num_f p, int x, const num_q value[])
{
    poly numerator, denominator;
    for (int k = 0; k < c->count; k++)
        if (k != x && c->binding[k].unknown)
            p = substitute_f(p, c->binding[k].value.f, from_rational_f(value[k]));
    cagd_poly_from_field(cagd_numerator_f(p), c->binding[x].value.f, &numerator, &denominator);
    return numerator;
}

/* The sign of p at the root of an irreducible polynomial. */
static int sign_at(poly p, struct cagd_root r)
{
    if (cagd_poly_is_zero(p) || cagd_poly_divides(r.factor, p))
        return 0;
    while (region_faults == 0 && cagd_count_roots(p, r.lo, r.hi, CAGD_CLOSED).distinct > 0)
        r = cagd_refine_root(r, div_q(sub_q(r.hi, r.lo), from_int_q(2)));
    return cagd_sign_q(cagd_poly_value(p, r.lo));
}

/* Whether both sides are defined at the root, and the relation is false. */
static int is_false_at(const cagd_context *c, const cagd_relation_sides *s, struct cagd_root r,
                       cagd_irrational_example *e)
{
    int below = sign_at(at_values(c, s->m, e->of, e->value), r);
    for (int i = 0; i < s->divisors; i++)
        if (sign_at(at_values(c, s->divisor[i], e->of, e->value), r) == 0 || region_faults != 0)
            return 0;
    e->root = r;
    e->order = below * sign_at(at_values(c, s->n, e->of, e->value), r);
    return below != 0 && region_faults == 0 && !cagd_relation_holds(e->order, s->relation);
}

/* At a root of the numerator, within the bounds of the name, that is no rational number. */
static int at_zero(const cagd_context *c, const cagd_relation_sides *s, cagd_irrational_example *e)
{
    num_f x = c->binding[e->of].value.f, p = s->n, factor[CAGD_MOST_ROOTS];
    int power[CAGD_MOST_ROOTS];
    cagd_side_of_box side = side_of(&c->binding[e->of]);
    for (int k = 0; k < c->count; k++)
        if (k != e->of && c->binding[k].unknown)
            p = substitute_f(p, c->binding[k].value.f, from_rational_f(e->value[k]));
    int factors = cagd_degree_f(p, x) > 0 ? cagd_factors_f(p, x, CAGD_MOST_ROOTS, factor, power) : 0;
    for (int i = 0; i < factors && region_faults == 0; i++) {
        poly f, one;
        struct cagd_root root[CAGD_MOST_ROOTS];
        cagd_poly_from_field(factor[i], x, &f, &one);
        if (cagd_poly_degree(f) < 2 || cagd_poly_degree(f) > CAGD_MOST_ROOTS)
            continue;
        num_q far = cagd_root_bound(f), low = side.has_low ? side.low : neg_q(far),
              high = side.has_high ? side.high : far;
        int count = cagd_compare_q(low, high) < 0 ? cagd_isolate_roots(f, low, high, root, CAGD_MOST_ROOTS) : 0;
        for (int k = 0; k < count && region_faults == 0; k++)
            if (is_false_at(c, s, root[k], e))
                return 1;
    }
    return 0;
}

/* The sign of p for all roots within the bounds that they have, the other names having values; 0 where it has several. */
static int sign_within_bounds(const cagd_context *c, num_f p, const num_q value[])
{
    cagd_side_of_box side[CAGD_MOST_ROOTS];
    num_q point[CAGD_MOST_ROOTS];
    int count = 0, unused;
    for (int k = 0; k < c->count; k++) {
        const cagd_binding *b = &c->binding[k];
        if (b->has_root && count < CAGD_MOST_ROOTS)
            side[count++] = side_of(b);
        else if (b->unknown)
            p = substitute_f(p, b->value.f, from_rational_f(value[k]));
    }
    p = mul_f(cagd_numerator_f(p), cagd_denominator_f(p));
    for (int sign = 1; sign >= -1 && region_faults == 0; sign -= 2)
        if (cagd_positive_in_box(sign > 0 ? p : neg_f(p), 1, count, side, point, &unused) == CAGD_HOLDS)
            return sign;
    return 0;
}

/* The same where there are several roots, and their bounds tell enough. */
static int is_false_within_bounds(const cagd_context *c, const cagd_relation_sides *s, cagd_irrational_example *e)
{
    e->of = -1;
    e->order = sign_within_bounds(c, div_f(s->n, s->m), e->value);
    for (int i = 0; i < s->divisors; i++)
        if (sign_within_bounds(c, s->divisor[i], e->value) == 0)
            return 0;
    return e->order != 0 && region_faults == 0 && !cagd_relation_holds(e->order, s->relation);
}

void cagd_choose_numbers(const cagd_context *c, int round, num_q value[])
{
    static const int simple[][2] = {{0, 1}, {1, 1}, {2, 1}, {-1, 1}, {1, 2}, {3, 1}, {-2, 1}, {1, 3}};
    enum { SIMPLE = sizeof simple / sizeof *simple };
    for (int k = 0; k < c->count; k++) {
        if (!c->binding[k].unknown)
            continue;
        cagd_side_of_box side = side_of(&c->binding[k]);
        const int *q = simple[(round + (round > 0) * k) % SIMPLE];
        value[k] = from_ratio_q(q[0], q[1]);
        if (!cagd_is_inside(&side, value[k]))
            value[k] = cagd_inside(&side);
    }
}

const struct cagd_root *cagd_told_root(struct cagd_root r)
{
    struct cagd_root *kept = region_bytes(sizeof *kept);
    num_q near = from_ratio_q(1, 50);
    r = cagd_refine_root(r, near);
    num_q lo = cagd_simplest_between(sub_q(r.lo, near), r.lo), hi = cagd_simplest_between(r.hi, add_q(r.hi, near));
    if (cagd_count_roots(r.factor, lo, hi, CAGD_CLOSED).distinct == 1)
        r.lo = lo, r.hi = hi;
    if (kept != NULL)
        *kept = r;
    return kept;
}

int cagd_find_irrational_example(const cagd_context *c, const cagd_tree *t, int k, cagd_irrational_example *out)
{
    cagd_relation_sides *s = region_bytes(sizeof *s);
    int root, roots;
    if (s == NULL || k < 0 || c->mixes_angles || region_faults != 0 || !has_bounds_alone(c, &roots, &root) ||
        !cagd_find_sides(c, t, k, s)) {
        region_faults &= FAULT_MEMORY | FAULT_CROWDED;
        return 0;
    }
    int found = 0;
    for (int round = 0; round < ROUNDS && !found; round++) {
        cagd_choose_numbers(c, round, out->value);
        found = roots > 1 && is_false_within_bounds(c, s, out);
        for (int x = 0; x < c->count && !found && roots < 2; x++) {
            out->of = x;
            if (root >= 0 ? x == root : c->binding[x].unknown && cagd_degree_f(s->n, c->binding[x].value.f) > 1)
                found = root >= 0 ? is_false_at(c, s, c->binding[root].root, out) : at_zero(c, s, out);
            region_faults &= FAULT_MEMORY | FAULT_CROWDED; /* a divisor that is 0 for these numbers */
        }
    }
    return found && region_faults == 0;
}
