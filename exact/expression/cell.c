#include "exact/expression/cell.h"

#include "exact/decide/simplex.h"
#include "exact/expression/order.h"
#include "exact/expression/suppose.h"
#include "exact/words.h"

#include <stdio.h>
#include <string.h>

enum { MOST_FACTORS = 60 };

/* ---- linear forms -------------------------------------------------------------------------------------- */

int cagd_is_linear(num_f a)
{
    struct cagd_linear form;
    region_mark mark = region_open();
    int is = cagd_linear_f(a, &form);
    region_drop(mark);
    return is && region_faults == 0;
}

/* The coefficient of a name in a linear form. */
static num_q coefficient_of(const struct cagd_linear *form, const cagd_binding *b)
{
    for (int k = 0; k < form->count; k++)
        if (form->variable[k] == b->number)
            return form->coefficient[k];
    return from_int_q(0);
}

static int has_name(const struct cagd_linear *form, const cagd_binding *b)
{
    for (int k = 0; k < form->count; k++)
        if (form->variable[k] == b->number)
            return b->unknown;
    return 0;
}

/* ---- what becomes known -------------------------------------------------------------------------------- */

static int depends(num_f f, num_f x) { return cagd_degree_f(f, x) > 0 || cagd_denominator_degree_f(f, x) > 0; }

static void forget_signs(cagd_context *c) { c->memos = 0; }

/* x > r, x >= r, x < r, x <= r for the name alone. */
static void narrow(cagd_context *c, cagd_binding *b, int above, num_q r, int strict)
{
    int is_new = above ? !b->has_low : !b->has_high;
    int order = is_new ? 1 : above ? cagd_compare_q(r, b->low) : cagd_compare_q(b->high, r);
    if (order < 0 || (order == 0 && !strict))
        return;
    if (above)
        b->has_low = 1, b->low = r, b->low_open = strict;
    else
        b->has_high = 1, b->high = r, b->high_open = strict;
    order = b->has_low && b->has_high ? cagd_compare_q(b->low, b->high) : -1;
    c->is_empty |= order > 0 || (order == 0 && (b->low_open || b->high_open));
}

int cagd_limit_cell(cagd_context *c, num_f form, int strict)
{
    struct cagd_linear at;
    if (!cagd_linear_f(form, &at))
        return 0;
    forget_signs(c);
    if (at.count == 0) {
        c->is_empty |= strict ? cagd_sign_q(at.constant) <= 0 : cagd_sign_q(at.constant) < 0;
        return 1;
    }
    for (int k = 0; k < c->count && at.count == 1; k++)
        if (has_name(&at, &c->binding[k])) {
            num_q p = at.coefficient[0];
            narrow(c, &c->binding[k], cagd_sign_q(p) > 0, neg_q(div_q(at.constant, p)), strict);
            return 1;
        }
    if (c->limits == CAGD_MOST_LIMITS)
        return 0;
    c->limit[c->limits++] = (cagd_limit){form, strict, at};
    return 1;
}

int cagd_becomes_in_cell(cagd_context *c, cagd_binding *b, num_f value)
{
    num_f x = b->value.f;
    cagd_binding known = *b;
    int count = c->limits, good = 1;
    b->unknown = 0, b->solved = 1, b->value = cagd_value_f(value);
    forget_signs(c);
    for (int k = 0; k < c->count; k++) {
        cagd_binding *other = &c->binding[k];
        if (!other->unknown && !other->value.rational && depends(other->value.f, x))
            other->value = cagd_value_f(substitute_f(other->value.f, x, value));
    }
    c->limits = 0;
    for (int k = 0; k < count; k++) /* none is written before it was read */
        good &= cagd_limit_cell(c, substitute_f(c->limit[k].form, x, value), c->limit[k].strict);
    if (known.has_low)
        good &= cagd_limit_cell(c, sub_f(value, from_rational_f(known.low)), known.low_open);
    if (known.has_high)
        good &= cagd_limit_cell(c, sub_f(from_rational_f(known.high), value), known.high_open);
    return good && region_faults == 0;
}

int cagd_solve_in_cell(cagd_context *c, num_f form)
{
    struct cagd_linear at;
    if (!cagd_linear_f(form, &at))
        return 0;
    forget_signs(c);
    if (at.count == 0) {
        c->is_empty |= cagd_sign_q(at.constant) != 0;
        return 1;
    }
    cagd_binding *best = NULL;
    int best_bounds = 0;
    for (int k = 0; k < c->count; k++) { /* the last one with the fewest bounds */
        cagd_binding *b = &c->binding[k];
        int bounds = b->has_low + b->has_high;
        if (b->key[0] != '\0' && has_name(&at, b) && (best == NULL || bounds <= best_bounds))
            best = b, best_bounds = bounds;
    }
    if (best == NULL)
        return 0;
    num_f x = best->value.f;
    return cagd_becomes_in_cell(c, best, sub_f(x, div_f(form, from_rational_f(coefficient_of(&at, best)))));
}

int cagd_cut_cell(cagd_context *c, const cagd_cut *cut)
{
    num_f form = from_rational_f(cut->constant);
    for (int k = 0; k < cut->count; k++) {
        const cagd_cut_term *t = &cut->term[k];
        cagd_value x = cagd_value_of_key(c, t->key, t->variable);
        form = add_f(form, mul_f(from_rational_f(t->coefficient), cagd_in_field(x)));
    }
    if (region_faults != 0)
        return 0;
    return cut->sign == 0 ? cagd_solve_in_cell(c, form) : cagd_limit_cell(c, cut->sign > 0 ? form : neg_f(form), 1);
}

/* ---- whether it is empty ------------------------------------------------------------------------------- */

/* All that is known, as forms that are homogeneous in 1 and the names: of[i] is the binding of coordinate i >= 1.  There is room for two
 * more. */
struct system {
    int names, count, of[CAGD_MOST_UNKNOWNS + 1];
    num_q *form;
    int *strict;
};

static void add_form(const cagd_context *c, struct system *s, const struct cagd_linear *form, int minus, int strict)
{
    num_q *at = s->form + (ptrdiff_t)s->count * (s->names + 1);
    at[0] = minus ? neg_q(form->constant) : form->constant;
    for (int i = 1; i <= s->names; i++) {
        num_q q = coefficient_of(form, &c->binding[s->of[i]]);
        at[i] = minus ? neg_q(q) : q;
    }
    s->strict[s->count++] = strict;
}

/* Marks all names of a form if one of them is marked; whether one more is. */
static int spread(const cagd_context *c, const struct cagd_linear *form, int marked[])
{
    int some = 0, more = 0;
    for (int k = 0; k < c->count; k++)
        some |= marked[k] && has_name(form, &c->binding[k]);
    for (int k = 0; some && k < c->count; k++)
        if (!marked[k] && has_name(form, &c->binding[k]))
            more = marked[k] = 1;
    return more;
}

/* What is known of the names in the form, and of those that are tied to them; of all names where there is no form. */
static int known_of(const cagd_context *c, const struct cagd_linear *form, struct system *s)
{
    int marked[CAGD_MOST_UNKNOWNS] = {0};
    for (int k = 0; k < c->count; k++)
        marked[k] = c->binding[k].unknown && (form == NULL || has_name(form, &c->binding[k]));
    for (int more = form != NULL; more;) {
        more = 0;
        for (int m = 0; m < c->limits; m++)
            more |= spread(c, &c->limit[m].at, marked);
    }
    *s = (struct system){0};
    for (int k = 0; k < c->count; k++)
        if (marked[k])
            s->of[++s->names] = k;
    int room = 1 + c->limits + 2 * s->names + 2;
    s->form = cagd_region_array(room, s->names + 1, sizeof *s->form);
    s->strict = cagd_region_array(room, 1, sizeof *s->strict);
    if (s->form == NULL || s->strict == NULL)
        return 0;
    struct cagd_linear one = {.constant = from_int_q(1)};
    add_form(c, s, &one, 0, 1);
    for (int m = 0; m < c->limits; m++) {
        int k = 0;
        while (k < c->count && !has_name(&c->limit[m].at, &c->binding[k]))
            k++;
        if (k < c->count && marked[k])
            add_form(c, s, &c->limit[m].at, 0, c->limit[m].strict);
    }
    for (int i = 1; i <= s->names; i++) {
        const cagd_binding *b = &c->binding[s->of[i]];
        num_q plus = from_int_q(1);
        struct cagd_linear bound = {1, &b->number, &plus, from_int_q(0)};
        bound.constant = b->has_low ? neg_q(b->low) : bound.constant;
        if (b->has_low)
            add_form(c, s, &bound, 0, b->low_open);
        bound.constant = b->has_high ? neg_q(b->high) : bound.constant;
        if (b->has_high)
            add_form(c, s, &bound, 1, b->high_open);
    }
    return region_faults == 0;
}

/* Whether all variables of the form are names without values: of any other nothing is known. */
static int is_of_names(const cagd_context *c, const struct cagd_linear *form)
{
    int names = 0;
    for (int k = 0; k < c->count; k++)
        names += has_name(form, &c->binding[k]);
    return names == form->count;
}

static int is_solvable(const struct system *s)
{
    return cagd_inequalities(s->names + 1, s->count, s->form, s->strict).solvable;
}

int cagd_cell_is_empty(cagd_context *c)
{
    struct system s;
    region_mark mark = region_open();
    if (!c->is_empty && c->limits > 0 && known_of(c, NULL, &s))
        c->is_empty = !is_solvable(&s) && region_faults == 0;
    region_drop(mark);
    return c->is_empty;
}

int cagd_point_of_cell(cagd_context *c, num_q value[])
{
    struct system s;
    if (c->is_empty || !known_of(c, NULL, &s))
        return 0;
    struct cagd_inequalities found = cagd_inequalities(s.names + 1, s.count, s.form, s.strict);
    if (!found.solvable || region_faults != 0)
        return 0;
    for (int i = 1; i <= s.names; i++)
        value[s.of[i]] = div_q(found.point[i], found.point[0]);
    return 1;
}

/* ---- signs --------------------------------------------------------------------------------------------- */

static unsigned sign_of_number(num_q q)
{
    int sign = cagd_sign_q(q);
    return sign > 0 ? CAGD_CAN_BE_POSITIVE : sign < 0 ? CAGD_CAN_BE_NEGATIVE : CAGD_CAN_BE_ZERO;
}

unsigned cagd_signs_of_form(cagd_context *c, num_f form)
{
    struct cagd_linear at;
    struct system s;
    unsigned signs = CAGD_ANY_SIGN;
    for (int k = 0; k < c->memos; k++)
        if (equal_f(c->memo[k].form, form))
            return c->memo[k].signs;
    region_mark mark = region_open();
    if (cagd_linear_f(form, &at) && is_of_names(c, &at) && known_of(c, &at, &s)) {
        int known = s.count;
        signs = 0;
        add_form(c, &s, &at, 0, 1);
        signs |= is_solvable(&s) ? CAGD_CAN_BE_POSITIVE : 0;
        s.count = known;
        add_form(c, &s, &at, 1, 1);
        signs |= is_solvable(&s) ? CAGD_CAN_BE_NEGATIVE : 0;
        s.strict[s.count - 1] = 0;
        add_form(c, &s, &at, 0, 0);
        signs |= is_solvable(&s) ? CAGD_CAN_BE_ZERO : 0;
    }
    region_drop(mark);
    if (region_faults != 0)
        return CAGD_ANY_SIGN;
    if (c->memos < CAGD_MOST_MEMOS)
        c->memo[c->memos++] = (cagd_memo){form, signs};
    return signs;
}

static unsigned minus(unsigned signs)
{
    return (signs & CAGD_CAN_BE_ZERO) | (signs & CAGD_CAN_BE_POSITIVE ? CAGD_CAN_BE_NEGATIVE : 0) |
           (signs & CAGD_CAN_BE_NEGATIVE ? CAGD_CAN_BE_POSITIVE : 0);
}

static unsigned product(unsigned a, unsigned b)
{
    unsigned zero = (a | b) & CAGD_CAN_BE_ZERO, signs = 0;
    if (b & CAGD_CAN_BE_POSITIVE)
        signs |= a & ~(unsigned)CAGD_CAN_BE_ZERO;
    if (b & CAGD_CAN_BE_NEGATIVE)
        signs |= minus(a) & ~(unsigned)CAGD_CAN_BE_ZERO;
    return signs | zero;
}

static int is_one_sign(unsigned signs)
{
    return signs == CAGD_CAN_BE_NEGATIVE || signs == CAGD_CAN_BE_ZERO || signs == CAGD_CAN_BE_POSITIVE;
}

/* The form changes its sign in the cell: that is noted, if it is the first, and all its names are names of the page. */
static void note(cagd_context *c, num_f form)
{
    struct cagd_linear at;
    if (c->split != NULL || c->has_cut || !cagd_linear_f(form, &at))
        return;
    cagd_cut_term *term = cagd_region_array(at.count, 1, sizeof *term);
    int count = 0;
    for (int k = 0; k < c->count && term != NULL; k++) {
        const cagd_binding *b = &c->binding[k];
        if (has_name(&at, b))
            term[count++] = (cagd_cut_term){b->key, b->variable, coefficient_of(&at, b)};
        if (has_name(&at, b) && (b->key[0] == '\0' || b->has_root))
            return;
    }
    if (count < at.count || count == 0)
        return;
    if (count == 1)
        c->split = term[0].key, c->split_at = neg_q(div_q(at.constant, term[0].coefficient));
    else
        c->cut = (cagd_cut){count, term, at.constant, 0}, c->has_cut = 1;
}

/* The signs of an irreducible polynomial. */
static unsigned signs_of_factor(cagd_context *c, num_f p)
{
    unsigned signs = CAGD_ANY_SIGN;
    if (cagd_is_linear(p)) {
        signs = cagd_signs_of_form(c, p);
        if (!is_one_sign(signs))
            note(c, p);
        return signs;
    }
    for (int sign = 1; sign >= -1 && region_faults == 0; sign -= 2)
        if (cagd_is_positive_in_cell(c, sign > 0 ? p : neg_f(p), 1))
            return sign > 0 ? CAGD_CAN_BE_POSITIVE : CAGD_CAN_BE_NEGATIVE;
    return signs;
}

/* The product of the signs of the irreducible factors of the polynomial p; one that changes its sign is noted. */
static unsigned signs_of_polynomial(cagd_context *c, num_f p, int as_divisor)
{
    unsigned signs = CAGD_CAN_BE_POSITIVE;
    num_q rest;
    if (cagd_is_linear(p)) {
        signs = signs_of_factor(c, p);
        return as_divisor ? signs & ~(unsigned)CAGD_CAN_BE_ZERO : signs;
    }
    for (int k = 0; k < c->count && region_faults == 0; k++) {
        num_f factor[MOST_FACTORS], x = c->binding[k].value.f;
        int power[MOST_FACTORS];
        int count =
            c->binding[k].unknown && cagd_degree_f(p, x) > 0 ? cagd_factors_f(p, x, MOST_FACTORS, factor, power) : 0;
        if (count < 0)
            return CAGD_ANY_SIGN;
        for (int i = 0; i < count; i++) {
            unsigned one = signs_of_factor(c, factor[i]);
            if (power[i] % 2 == 0)
                one = product(one, one) &
                      (one & CAGD_CAN_BE_ZERO ? CAGD_CAN_BE_ZERO | CAGD_CAN_BE_POSITIVE : CAGD_CAN_BE_POSITIVE);
            signs = product(signs, as_divisor ? one & ~(unsigned)CAGD_CAN_BE_ZERO : one);
            for (int e = 0; e < power[i]; e++)
                p = div_f(p, factor[i]);
        }
    }
    if (!is_constant_f(p, &rest) || region_faults != 0)
        return CAGD_ANY_SIGN;
    return cagd_sign_q(rest) < 0 ? minus(signs) : signs;
}

/* The variables that stand at a place have its value. */
static cagd_value settled(const cagd_context *c, cagd_value d)
{
    for (int k = c->count - 1; k >= 0; k--) {
        const cagd_binding *b = &c->binding[k];
        if (b->near && b->unknown && b->side == 0 && !d.rational && depends(d.f, b->value.f))
            d = cagd_value_f(substitute_f(d.f, b->value.f, cagd_in_field(b->place)));
    }
    return d;
}

/* Near the place, where it is 0, f has the sign of its first derivative there that is not 0, on that side. */
static unsigned signs_beside(cagd_context *c, num_f f, const cagd_binding *b, num_f place)
{
    unsigned turned = b->side < 0 ? CAGD_CAN_BE_NEGATIVE : CAGD_CAN_BE_POSITIVE, side = CAGD_CAN_BE_POSITIVE;
    c->met_joint = 1;
    for (int most = cagd_degree_f(f, b->value.f); most > 0 && region_faults == 0; most--) {
        f = derivative_f(f, b->value.f);
        side = product(side, turned);
        cagd_value there = cagd_value_f(substitute_f(f, b->value.f, place));
        if (!cagd_is_zero_here(c, there))
            return product(side, cagd_signs(c, there));
    }
    return CAGD_ANY_SIGN;
}

int cagd_is_beside(const cagd_context *c, cagd_value d)
{
    for (int k = 0; k < c->count; k++) {
        const cagd_binding *b = &c->binding[k];
        if (b->near && b->unknown && !d.rational && depends(d.f, b->value.f))
            return 1;
    }
    return 0;
}

cagd_value cagd_at_places(const cagd_context *c, cagd_value d)
{
    for (int k = c->count - 1; k >= 0 && region_faults == 0 && cagd_is_beside(c, d); k--) {
        const cagd_binding *b = &c->binding[k];
        if (b->near && b->unknown && depends(d.f, b->value.f))
            d = cagd_value_f(substitute_f(d.f, b->value.f, cagd_in_field(b->place)));
    }
    return d;
}

/* On the way. */
static unsigned sign_here(const cagd_context *c, num_f f)
{
    if (c->way->holds(f, CAGD_EQUAL))
        return CAGD_CAN_BE_ZERO;
    return c->way->holds(f, CAGD_GREATER) ? CAGD_CAN_BE_POSITIVE : CAGD_CAN_BE_NEGATIVE;
}

unsigned cagd_signs(cagd_context *c, cagd_value d)
{
    cagd_suppose_for_names(c);
    int is_beside = 0;
    d = settled(c, d);
    for (int k = c->count - 1; k >= 0 && region_faults == 0 && !d.rational; k--) {
        const cagd_binding *b = &c->binding[k];
        if (!b->near || !b->unknown || b->side == 0 || !depends(d.f, b->value.f))
            continue;
        num_f place = cagd_in_field(settled(c, b->place));
        num_f f = mul_f(cagd_numerator_f(d.f), cagd_denominator_f(d.f));
        cagd_value there = cagd_value_f(substitute_f(f, b->value.f, place));
        if (cagd_is_zero_here(c, there))
            return signs_beside(c, f, b, place);
        d = there, is_beside = 1;
    }
    if (d.rational || region_faults != 0)
        return region_faults != 0 ? CAGD_ANY_SIGN : sign_of_number(d.q);
    if (c->way != NULL)
        return sign_here(c, d.f);
    unsigned above = signs_of_polynomial(c, cagd_numerator_f(d.f), 0),
             below = signs_of_polynomial(c, cagd_denominator_f(d.f), 1);
    /* where it can be 0 at the place, what it is beside that is another matter there */
    return is_beside && (above & CAGD_CAN_BE_ZERO) && above != CAGD_CAN_BE_ZERO && (c->split != NULL || c->has_cut)
               ? CAGD_ANY_SIGN
               : product(above, below);
}

int cagd_divides(cagd_context *c, cagd_value d)
{
    if (d.rational)
        return cagd_sign_q(d.q) != 0;
    int is_first = c->split == NULL && !c->has_cut;
    int can_be_zero = (cagd_signs(c, d) & CAGD_CAN_BE_ZERO) != 0, is_noted = c->split != NULL || c->has_cut;
    if (!can_be_zero && is_first)
        c->split = NULL, c->has_cut = 0;
    if (can_be_zero && !is_noted)
        c->omits_poles = 1;
    return !can_be_zero || !is_noted;
}

int cagd_has_equality(cagd_context *c)
{
    for (int m = 0; m < c->limits && region_faults == 0; m++)
        if (!c->limit[m].strict && cagd_signs_of_form(c, c->limit[m].form) == CAGD_CAN_BE_ZERO) {
            note(c, c->limit[m].form);
            return c->has_cut;
        }
    return 0;
}
