#include "exact/expression/implied.h"

#include "exact/decide/cylinders.h"
#include "exact/expression/angle.h"
#include "exact/expression/radical.h"
#include "exact/words.h"

enum { MOST_GIVEN = 50, MOST_NAMES = 4 };

/* What is known, and whether that is all. */
struct known {
    cagd_sign_condition given[MOST_GIVEN];
    int count, complete;
};

static unsigned signs_of(cagd_relation relation)
{
    switch (relation) {
    case CAGD_EQUAL:
        return CAGD_IS_ZERO;
    case CAGD_NOT_EQUAL:
        return CAGD_IS_NEGATIVE | CAGD_IS_POSITIVE;
    case CAGD_LESS:
        return CAGD_IS_NEGATIVE;
    case CAGD_LESS_OR_EQUAL:
        return CAGD_IS_NEGATIVE | CAGD_IS_ZERO;
    case CAGD_GREATER:
        return CAGD_IS_POSITIVE;
    default:
        return CAGD_IS_POSITIVE | CAGD_IS_ZERO;
    }
}

static void know(struct known *k, num_f p, unsigned signs)
{
    if (k->count == MOST_GIVEN)
        k->complete = 0;
    else
        k->given[k->count++] = (cagd_sign_condition){p, signs};
}

/* a relation b of two values, as a sign of numerator times denominator; where the latter is 0 the relation is not true, which is left out. */
static void know_relation(struct known *k, cagd_value a, cagd_relation relation, cagd_value b)
{
    num_f d = region_faults == 0 ? sub_f(cagd_in_field(a), cagd_in_field(b)) : a.f;
    if (region_faults == 0) {
        num_f m = cagd_denominator_f(d);
        know(k, mul_f(cagd_numerator_f(d), m), signs_of(relation));
        k->complete &= is_constant_f(m, NULL);
    } else {
        k->complete = 0;
    }
    region_faults &= FAULT_MEMORY | FAULT_CROWDED;
}

static void know_condition(cagd_context *c, const cagd_tree *t, struct known *k)
{
    if (t->kind != CAGD_ALL && t->kind != CAGD_RELATION) {
        k->complete = 0;
        return;
    }
    for (int i = 0; t->kind == CAGD_ALL && i < t->count; i++)
        know_condition(c, t->at[i], k);
    for (int i = 0; t->kind == CAGD_RELATION && i + 1 < t->count; i++) {
        cagd_value a = cagd_evaluate(c, t->at[i]), b = cagd_evaluate(c, t->at[i + 1]);
        know_relation(k, a, t->relation[i], b);
    }
}

static void know_bounds(struct known *k, const cagd_binding *b)
{
    num_f x = b->value.f;
    if (b->has_low)
        know(k, sub_f(x, from_rational_f(b->low)), signs_of(b->low_open ? CAGD_GREATER : CAGD_GREATER_OR_EQUAL));
    if (b->has_high)
        know(k, sub_f(x, from_rational_f(b->high)), signs_of(b->high_open ? CAGD_LESS : CAGD_LESS_OR_EQUAL));
    num_f p;
    for (int end = 0; end < 2; end++)
        if (cagd_end_of_angle(b, end, &p))
            know(k, p, signs_of(b->root_end_open[end] ? CAGD_GREATER : CAGD_GREATER_OR_EQUAL));
    if (!b->has_root)
        return;
    p = from_int_f(0);
    for (int e = cagd_poly_degree(b->root.factor); e >= 0; e--)
        p = add_f(mul_f(p, x), from_rational_f(poly_coefficient(b->root.factor, e)));
    know(k, p, CAGD_IS_ZERO);
}

/* What was declared of the name with ends that are no numbers. */
static void know_declaration(cagd_context *c, const cagd_binding *b, struct known *k)
{
    const cagd_variable *v = b->variable;
    cagd_value x = b->value;
    if (v == NULL || (!b->unknown && !b->solved))
        return;
    if (v->low != NULL)
        know_relation(k, x, v->low_open ? CAGD_GREATER : CAGD_GREATER_OR_EQUAL, cagd_evaluate(c, v->low));
    if (v->high != NULL)
        know_relation(k, x, v->high_open ? CAGD_LESS : CAGD_LESS_OR_EQUAL, cagd_evaluate(c, v->high));
}

static void know_all(cagd_context *c, struct known *k)
{
    k->count = 0, k->complete = 1;
    for (int i = 0; i < c->count; i++) {
        const cagd_binding *b = &c->binding[i];
        if (b->unknown)
            know_bounds(k, b);
        know_declaration(c, b, k);
        k->complete &= !(b->unknown && b->near != 0);
    }
    for (int i = 0; i < c->limits; i++)
        know(k, c->limit[i].form, signs_of(c->limit[i].strict ? CAGD_GREATER : CAGD_GREATER_OR_EQUAL));
    for (int i = 0; i < c->scope->condition_count; i++)
        know_condition(c, c->scope->conditions[i], k);
    if (c->premise != NULL)
        know_condition(c, c->premise, k);
}

/* The names that are tied to those of p by what is known: their bindings; -1 where there are too many. */
static int names_of(const cagd_context *c, num_f p, const struct known *k, int of[])
{
    int is[CAGD_MOST_UNKNOWNS] = {0}, more = 1, count = 0;
    for (int i = 0; i < c->count; i++)
        is[i] = c->binding[i].unknown && degree_f(p, c->binding[i].value.f) > 0;
    while (more) {
        more = 0;
        for (int m = 0; m < k->count; m++) {
            int some = 0;
            for (int i = 0; i < c->count; i++)
                some |= is[i] && degree_f(k->given[m].p, c->binding[i].value.f) > 0;
            for (int i = 0; some && i < c->count; i++)
                if (!is[i] && c->binding[i].unknown && degree_f(k->given[m].p, c->binding[i].value.f) > 0)
                    is[i] = more = 1;
        }
    }
    for (int i = 0; i < c->count; i++)
        if (is[i] && count < MOST_NAMES)
            of[count++] = i;
        else if (is[i])
            return -1;
    return count;
}

/* Only what speaks of these names, or of none; whether that is all. */
static int keep_conditions_of(const cagd_context *c, int names, const int of[], struct known *k)
{
    int kept = 0, all = 1;
    for (int m = 0; m < k->count; m++) {
        int some = is_constant_f(k->given[m].p, NULL);
        for (int i = 0; i < names; i++)
            some |= degree_f(k->given[m].p, c->binding[of[i]].value.f) > 0;
        if (some)
            k->given[kept++] = k->given[m];
        all &= some;
    }
    k->count = kept;
    return all;
}

/* The counterexample, name by name. */
static void tell(const cagd_context *c, const cagd_algebraic_point *at, int names, const int of[],
                 cagd_implied_example *out)
{
    out->rational = 1;
    for (int i = 0; i < c->count; i++) {
        const cagd_binding *b = &c->binding[i];
        cagd_side_of_box s = {b->value.f, b->has_low, b->has_high, b->low_open, b->high_open, b->low, b->high};
        out->root[i] = NULL;
        out->value[i] = b->unknown ? cagd_inside(&s) : from_int_q(0);
    }
    for (int k = 0; k < names && region_faults == 0; k++) {
        struct cagd_root *r = region_bytes(sizeof *r);
        if (r == NULL)
            return;
        *r = cagd_algebraic_coordinate(at, k);
        int is_number = cagd_equal_q(r->lo, r->hi);
        out->value[of[k]] = r->lo, out->root[of[k]] = is_number ? NULL : r;
        out->rational &= is_number;
    }
}

/* Whether every name of the page has its value in such an example: none is a function of others. */
static int is_told(const cagd_context *c)
{
    for (int i = 0; i < c->count; i++)
        if (c->binding[i].solved || (c->binding[i].unknown && c->binding[i].hidden && !c->binding[i].is_number))
            return 0;
    return 1;
}

/* left - right of the relation, in a context of its own; its divisors are known not to be 0. */
static num_f difference(const cagd_context *c, const cagd_tree *t, int k, struct known *known)
{
    cagd_context *own = region_bytes(sizeof *own);
    num_f *divisor = cagd_region_array(MOST_GIVEN, 1, sizeof *divisor);
    if (own == NULL || divisor == NULL)
        return from_int_f(0);
    *own = *c;
    know_all(own, known);
    own->divisor = divisor, own->divisors = 0, own->most_divisors = MOST_GIVEN;
    cagd_value d = cagd_value_sub(cagd_evaluate(own, t->at[k]), cagd_evaluate(own, t->at[k + 1]));
    num_f f = cagd_in_field(d), m = cagd_denominator_f(f);
    for (int i = 0; i < own->divisors && region_faults == 0; i++)
        know(known, cagd_numerator_f(divisor[i]), CAGD_IS_NEGATIVE | CAGD_IS_POSITIVE);
    if (!is_constant_f(m, NULL))
        know(known, m, CAGD_IS_NEGATIVE | CAGD_IS_POSITIVE);
    if (own->count != c->count || known->count == MOST_GIVEN)
        region_faults |= FAULT_UNABLE;
    return f;
}

/* Whether the condition is x^2 = square for a name that is at least 0. */
static int is_square_root(const cagd_context *c, const cagd_sign_condition *condition, cagd_square_root *out)
{
    num_f p = condition->p;
    for (int i = 0; i < c->count && condition->signs == CAGD_IS_ZERO; i++) {
        const cagd_binding *b = &c->binding[i];
        if (!b->unknown || !b->has_low || cagd_sign_q(b->low) < 0 || degree_f(p, b->value.f) != 2)
            continue;
        num_f lead = coefficient_f(p, b->value.f, 2);
        if (!is_constant_f(lead, NULL) || !cagd_is_zero_f(coefficient_f(p, b->value.f, 1)))
            continue;
        *out = (cagd_square_root){b->value.f, neg_f(div_f(coefficient_f(p, b->value.f, 0), lead))};
        return 1;
    }
    return 0;
}

/* Whether p >= 0 for the names with all that is known, by their bounds and the square roots among them. */
static int is_shown_by_squares(const cagd_context *c, const struct known *k, num_f p)
{
    cagd_square_root root[MOST_GIVEN];
    cagd_side_of_box side[CAGD_MOST_UNKNOWNS];
    int roots = 0, sides = 0;
    for (int m = 0; m < k->count; m++) {
        int known = !is_square_root(c, &k->given[m], &root[roots]);
        for (int i = 0; i < roots && !known; i++) /* one of each name */
            known = equal_f(root[i].x, root[roots].x) || degree_f(root[roots].square, root[i].x) > 0;
        roots += !known;
    }
    for (int i = 0; i < c->count; i++) {
        const cagd_binding *b = &c->binding[i];
        if (b->unknown)
            side[sides++] =
                (cagd_side_of_box){b->value.f, b->has_low, b->has_high, b->low_open, b->high_open, b->low, b->high};
    }
    return cagd_is_nonnegative_with_roots(p, roots, root, sides, side);
}

/* The same of a relation that is no strict one. */
static int holds_by_squares(const cagd_context *c, const struct known *k, num_f p, cagd_relation relation)
{
    return relation == CAGD_GREATER_OR_EQUAL ? is_shown_by_squares(c, k, p)
           : relation == CAGD_LESS_OR_EQUAL  ? is_shown_by_squares(c, k, neg_f(p))
                                             : 0;
}

cagd_answer cagd_implied_relation(const cagd_context *c, const cagd_tree *t, int k, double until,
                                  cagd_implied_example *out)
{
    struct known *known = region_bytes(sizeof *known);
    num_f x[MOST_NAMES];
    cagd_algebraic_point at;
    cagd_relation relation = t->relation[k];
    if (known == NULL || region_faults != 0 || c->scope->zero_over_zero)
        return CAGD_UNDECIDED;
    num_f f = difference(c, t, k, known), p = mul_f(cagd_numerator_f(f), cagd_denominator_f(f));
    if (region_faults == 0 && holds_by_squares(c, known, p, relation))
        return CAGD_HOLDS;
    int of[MOST_NAMES], names = region_faults == 0 ? names_of(c, p, known, of) : -1;
    if (names < 1 || region_faults != 0) {
        region_faults &= FAULT_MEMORY | FAULT_CROWDED;
        return CAGD_UNDECIDED;
    }
    for (int i = 0; i < names; i++)
        x[i] = c->binding[of[i]].value.f;
    int complete = keep_conditions_of(c, names, of, known) && known->complete;
    cagd_sign_condition claim = {p, signs_of(relation)};
    enum cagd_implication answer = cagd_implies(known->count, known->given, claim, names, x, until, &at);
    if (answer == CAGD_IMPLIED)
        return CAGD_HOLDS;
    if (answer == CAGD_IMPLICATION_NOT_KNOWN || c->mixes_angles)
        return CAGD_UNDECIDED;
    tell(c, &at, names, of, out);
    out->order = cagd_algebraic_sign(&at, cagd_algebraic_value(&at, p, x));
    int good = region_faults == 0 && (out->rational || (complete && is_told(c)));
    region_faults &= FAULT_MEMORY | FAULT_CROWDED;
    return good ? CAGD_FAILS : CAGD_UNDECIDED;
}
