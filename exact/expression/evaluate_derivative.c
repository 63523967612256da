/* evaluate_derivative.c -- derivatives, values at a place, integrals. */
#include "exact/expression/angle.h"
#include "exact/expression/evaluator.h"
#include "exact/expression/tie.h"
#include "exact/words.h"

#include <stdio.h>
#include <string.h>

/* The binding whose variable the value is; NULL if it is none. */
static const cagd_binding *plain_variable(const cagd_context *c, cagd_value a)
{
    for (int k = 0; k < c->count && !a.rational; k++)
        if (c->binding[k].unknown && cagd_equal_f(c->binding[k].value.f, a.f))
            return &c->binding[k];
    return NULL;
}

/* A variable that occurs nowhere else, with the bounds of a where a is a variable: near a on that side, or there. */
static num_f fresh(cagd_context *c, cagd_value a, int side)
{
    char name[16];
    const cagd_binding *same = plain_variable(c, a);
    snprintf(name, sizeof name, "d'%d", c->fresh++); /* no name of C: those of a way may be variables, too */
    num_f x = variable_f(name);
    cagd_binding kept = same != NULL ? *same : (cagd_binding){0};
    kept.key = "", kept.value = (cagd_value){.f = x}, kept.unknown = 1;
    kept.number = cagd_field_variable_f(x);
    kept.near = 1, kept.side = side, kept.place = a;
    if (c->count == CAGD_MOST_UNKNOWNS)
        region_faults |= FAULT_UNABLE;
    else
        c->binding[c->count++] = kept;
    return x;
}

/* The fresh variable of binding k is no more. */
static void forget(cagd_context *c, int k)
{
    c->fresh--;
    if (k + 1 == c->count)
        c->count = k;
    else if (k < c->count)
        c->binding[k] = (cagd_binding){.key = "", .value = cagd_value_int(0)};
}

/* The k-th derivative of F by x, at x = a. */
static cagd_value derived(cagd_context *c, const cagd_tree *t, cagd_value F, num_f x, long k, cagd_value a)
{
    num_f g = cagd_in_field(F);
    if (k < 0 || k > CAGD_MOST_POWER)
        return cagd_fail(c, t, FAULT_UNABLE, "the order of a derivative is a whole number, at least 0");
    for (; k > 0 && region_faults == 0; k--)
        g = derivative_f(g, x);
    if (region_faults == 0)
        g = substitute_f(g, x, cagd_in_field(a));
    if (region_faults != 0)
        return cagd_divides_by_0(c, t);
    return cagd_value_f(g);
}

long cagd_order_of(cagd_context *c, const cagd_tree *t, const cagd_tree *order, const cagd_frame *f)
{
    long k = -1;
    cagd_value n = cagd_evaluate_in(c, order, f);
    if (!cagd_value_is_whole(n, &k) && region_faults == 0)
        cagd_fail(c, t, FAULT_UNABLE, "the order of a derivative is a whole number");
    return k;
}

/* The value of t when the letter is x, inside what is evaluated and in the definitions that it uses. */
static cagd_value with_letter(cagd_context *c, const cagd_tree *t, const char *letter, cagd_value x,
                              const cagd_frame *f)
{
    cagd_frame inner = {letter, x, f};
    for (const cagd_frame *g = f; g != NULL; g = g->next) /* a letter of this definition alone */
        if (strcmp(g->head, letter) == 0)
            return cagd_evaluate_in(c, t, &inner);
    int known = c->count;
    if (known == CAGD_MOST_UNKNOWNS)
        return cagd_fail(c, t, FAULT_UNABLE, "too many variables");
    c->binding[c->count++] = (cagd_binding){.key = letter, .value = inner.value, .is_letter = 1};
    cagd_value F = cagd_evaluate_in(c, t, &inner);
    if (known + 1 == c->count)
        c->count = known;
    else
        c->binding[known] = (cagd_binding){.key = "", .value = cagd_value_int(0)};
    return F;
}

/* The argument as an angle, which lives in the region. */
static cagd_value as_angle(const cagd_tree *t, const cagd_frame *f)
{
    struct cagd_angle *a = region_bytes(sizeof *a);
    cagd_value v = cagd_value_int(0);
    if (a != NULL)
        *a = (struct cagd_angle){t, f, cagd_value_int(0), cagd_value_int(0)};
    v.angle = a;
    return v;
}

void cagd_arguments_of(cagd_context *c, const cagd_tree *t, const cagd_definition *d, const cagd_frame *f,
                       cagd_value value[])
{
    for (int k = 0; k < d->left->count; k++) { /* arguments that are left out are the letters of the definition */
        const cagd_tree *argument = k < t->count ? t->at[k] : d->left->at[k];
        value[k] = cagd_is_angle_argument(c, d, k) ? as_angle(argument, f) : cagd_evaluate_in(c, argument, f);
    }
}

/* The value at a of the name t with those arguments but the first, or of the body as a function of the letter of t. */
static cagd_value value_at(cagd_context *c, const cagd_tree *t, const cagd_tree *body, cagd_value value[], cagd_value a,
                           const cagd_frame *f)
{
    if (body != NULL)
        return with_letter(c, body, t->head, a, f);
    value[t->lower + t->upper] = a;
    return cagd_defined_value(c, t, value, f);
}

/* The value where the angle is moved by another, of which x is the tangent; *y, which is 0 unless it is asked for, is that as a number. */
static num_f moved_by_angle(cagd_context *c, const cagd_tree *t, const cagd_tree *body, cagd_value value[],
                            const struct cagd_angle *at, num_f x, cagd_value *y, const cagd_frame *f)
{
    cagd_value moved = cagd_value_int(0);
    struct cagd_angle by = {at->tree, at->frame, {.f = x}, *y};
    const char *trouble = c->trouble;
    const cagd_tree *where = c->where;
    c->asks_for_number = 0;
    moved.angle = &by;
    num_f g = cagd_in_field(value_at(c, t, body, value, moved, f));
    if (!c->asks_for_number || !y->rational || region_faults != FAULT_UNABLE)
        return g;
    c->asks_for_number = 0, region_faults = 0, c->trouble = trouble, c->where = where; /* once more, with y */
    int known = c->count;
    *y = by.moved = (cagd_value){.f = fresh(c, cagd_value_int(0), 1)};
    g = cagd_in_field(region_faults == 0 ? value_at(c, t, body, value, moved, f) : cagd_value_int(0));
    forget(c, known);
    return g;
}

/* The k-th derivative of the name t by its first argument, or of the body by the letter of t, an angle: it is moved by another, which
 * is 0 then. */
cagd_value cagd_derivative_by_angle(cagd_context *c, const cagd_tree *t, const cagd_tree *body, cagd_value value[],
                                    long k, const struct cagd_angle *at, const cagd_frame *f)
{
    cagd_value zero = cagd_value_int(0), here = zero, y = zero;
    if (k < 0 || k > CAGD_MOST_POWER)
        return cagd_fail(c, t, FAULT_UNABLE, "the order of a derivative is a whole number, at least 0");
    int known = c->count, before = c->met_joint;
    c->met_joint = 0;
    num_f x = fresh(c, zero, 1);
    if (!at->tangent.rational && region_faults == 0) /* a derivative within another */
        return cagd_fail(c, t, FAULT_UNABLE, "derivatives by angles within one another");
    here.angle = at;
    num_f g = region_faults == 0 ? moved_by_angle(c, t, body, value, at, x, &y, f) : from_int_f(0);
    forget(c, known);
    if (c->met_joint && region_faults == 0)
        return cagd_fail(c, t, FAULT_UNABLE, "a derivative by an angle at a joint");
    c->met_joint = before;
    for (; k > 0 && region_faults == 0; k--) {
        num_f by_number = y.rational ? from_int_f(0) : derivative_f(g, y.f);
        g = add_f(cagd_by_angle_f(c, g, x), by_number);
    }
    if (region_faults == 0)
        g = substitute_f(g, x, from_int_f(0));
    if (region_faults == 0 && !y.rational)
        g = substitute_f(g, y.f, from_int_f(0));
    if (region_faults == 0 && body != NULL) /* where there is no value there is no derivative */
        cagd_evaluate_in(c, body, f);
    else if (region_faults == 0)
        value_at(c, t, NULL, value, here, f);
    return region_faults != 0 ? cagd_divides_by_0(c, t) : cagd_value_f(g);
}

/* The k-th derivative at a, from one side: of the name t by its first argument, value[] being all of them, or of the body by the letter of
 * t.  lower[j], j <= k, are those of lower order, and 0 is the value. */
static cagd_value derivative_from(cagd_context *c, const cagd_tree *t, const cagd_tree *body, cagd_value value[],
                                  long k, cagd_value a, int side, cagd_value lower[], const cagd_frame *f)
{
    int known = c->count;
    num_f x = fresh(c, a, side);
    cagd_value F = region_faults == 0 ? value_at(c, t, body, value, (cagd_value){.f = x}, f) : a;
    forget(c, known);
    for (long j = 0; lower != NULL && j <= k && region_faults == 0; j++)
        lower[j] = derived(c, t, F, x, j, a);
    return region_faults != 0 ? F : derived(c, t, F, x, k, a);
}

/* Whether there was no value because no definition fits on that side; then that is forgotten. */
static int ends_here(cagd_context *c)
{
    if (region_faults != FAULT_UNDEFINED || !c->fits_none || !c->met_joint)
        return 0;
    region_faults = 0;
    c->trouble = NULL, c->where = NULL;
    return 1;
}

/* Whether the value at a is there, and that one. */
static int is_value_at(cagd_context *c, const cagd_tree *t, const cagd_tree *body, cagd_value value[], cagd_value a,
                       cagd_value limit, const cagd_frame *f)
{
    cagd_value there = value_at(c, t, body, value, a, f);
    return region_faults == 0 && cagd_equal_here(c, there, limit);
}

/* The derivative; at a joint of pieces it is there if those of both sides are equal, and the lower ones, too, and the value there is
 * theirs; where the definitions end, it is that of the side on which they fit, if the function has a value there, to which it tends. */
cagd_value cagd_derivative_of(cagd_context *c, const cagd_tree *t, const cagd_tree *body, cagd_value value[], long k,
                              cagd_value a, const cagd_frame *f)
{
    enum { MOST_AT_JOINTS = 20 };
    cagd_value above[MOST_AT_JOINTS + 1], below[MOST_AT_JOINTS + 1];
    int before = c->met_joint, fitted = c->fits_none, divided = c->divided_beside,
        is_listed = k >= 0 && k <= MOST_AT_JOINTS;
    c->met_joint = c->fits_none = c->divided_beside = 0;
    cagd_value r = derivative_from(c, t, body, value, k, a, 1, is_listed ? above : NULL, f);
    int ends_above = is_listed && ends_here(c), ends_below = 0;
    if (c->met_joint && region_faults == 0) {
        if (k > MOST_AT_JOINTS)
            return cagd_fail(c, t, FAULT_UNABLE, "a derivative of high order at a joint");
        c->fits_none = 0;
        cagd_value other = derivative_from(c, t, body, value, k, a, -1, below, f);
        ends_below = !ends_above && ends_here(c);
        r = ends_above ? other : r;
        for (long j = 0; j <= k && region_faults == 0 && !ends_above && !ends_below; j++)
            if (!cagd_equal_here(c, above[j], below[j]))
                cagd_fail(c, t, FAULT_UNDEFINED, "no derivative at a joint");
        if (region_faults == 0 && !ends_above && !ends_below && !is_value_at(c, t, body, value, a, above[0], f))
            cagd_fail(c, t, FAULT_UNDEFINED, "no derivative at a joint");
    }
    if (region_faults == 0 && (ends_above || ends_below)) {
        if (!is_value_at(c, t, body, value, a, ends_above ? below[0] : above[0], f))
            cagd_fail(c, t, FAULT_UNDEFINED, "no derivative where the definitions end");
        c->one_sided = 1;
    } else if (region_faults == 0 && !c->met_joint && c->divided_beside) {
        value_at(c, t, body, value, a, f); /* where there is no value there is no derivative */
    }
    c->met_joint |= before, c->fits_none |= fitted, c->divided_beside |= divided;
    return r;
}

/* d^k a / dw_j^k for a name with an index. */
static cagd_value derivative_by_name(cagd_context *c, const cagd_tree *t, const cagd_frame *f)
{
    char key[96];
    long order = cagd_order_of(c, t, t->at[1], f);
    cagd_value at = cagd_name_value(c, t->at[2], f);
    cagd_tree *by = cagd_tree_new(CAGD_DERIVATIVE, t->from, t->to, 2);
    if (by == NULL || region_faults != 0 || !cagd_key_of(c, t->at[2], f, key, sizeof key))
        return at;
    by->head = cagd_text_of(key, (int)strlen(key)), by->at[0] = t->at[0], by->at[1] = t->at[1];
    return by->head != NULL ? cagd_derivative_of(c, by, t->at[0], NULL, order, at, f) : at;
}

/* A name in t that was given a value with that letter in it, y = x, for which it is not known whether it is put in before or after; with `declared`, one that was
 * declared before.  NULL where there is none. */
static const cagd_tree *given_by(const cagd_scope *scope, const cagd_tree *t, const char *letter, int declared)
{
    const cagd_definition *d = t->kind == CAGD_NAME && t->count == 0 ? cagd_defined(scope, t->head) : NULL;
    if (d != NULL && d->left->count == 0 && d->body != NULL && strcmp(t->head, letter) != 0 &&
        (!declared || cagd_declared(scope, t->head) != NULL) && cagd_tree_has(d->body, letter))
        return t;
    const cagd_tree *found = NULL;
    for (int k = 0; k < t->count && found == NULL; k++)
        found = given_by(scope, t->at[k], letter, declared);
    return found;
}

/* d^k a / dx^k for a letter x that has a value here. */
cagd_value cagd_derivative_value(cagd_context *c, const cagd_tree *t, const cagd_frame *f)
{
    cagd_tree letter = {.kind = CAGD_NAME, .head = t->head, .from = t->from, .to = t->to};
    if (t->count > 2)
        return derivative_by_name(c, t, f);
    if (t->order > 0 && given_by(c->scope, t->at[0], t->head, 0) != NULL)
        return cagd_fail(c, given_by(c->scope, t->at[0], t->head, 0), FAULT_UNABLE,
                         "is its value put in before the partial derivative is taken, or after it?");
    long order = cagd_order_of(c, t, t->at[1], f);
    if (region_faults == 0 && cagd_is_angle_in(c, t->at[0], t->head)) {
        struct cagd_angle here = {&letter, f, cagd_value_int(0), cagd_value_int(0)};
        return cagd_derivative_by_angle(c, &letter, t->at[0], NULL, order, &here, f);
    }
    cagd_value at = cagd_name_value(c, &letter, f);
    if (region_faults != 0)
        return at;
    if (cagd_defined(c->scope, t->head) != NULL)
        return cagd_fail(c, t, FAULT_UNABLE, "a derivative by what was given a value");
    return cagd_derivative_of(c, t, t->at[0], NULL, order, at, f);
}

cagd_value cagd_place_value(cagd_context *c, const cagd_tree *t, const cagd_frame *f)
{
    if (cagd_is_angle_in(c, t->at[0], t->head))
        return with_letter(c, t->at[0], t->head, as_angle(t->at[1], f), f);
    cagd_value place = cagd_evaluate_in(c, t->at[1], f);
    int known = c->count;
    num_f x = fresh(c, place, 0);
    cagd_value F = with_letter(c, t->at[0], t->head, (cagd_value){.f = x}, f);
    forget(c, known);
    return region_faults != 0 ? F : derived(c, t, F, x, 0, place);
}

cagd_value cagd_integral_value(cagd_context *c, const cagd_tree *t, const cagd_frame *f)
{
    cagd_value low = cagd_evaluate_in(c, t->at[0], f), high = cagd_evaluate_in(c, t->at[1], f), sum = cagd_value_int(0);
    int known = c->count;
    const cagd_tree *given = cagd_declared(c->scope, t->head) != NULL ? given_by(c->scope, t->at[2], t->head, 1) : NULL;
    if (given != NULL)
        return cagd_fail(c, given, FAULT_UNABLE,
                         "it was given by the letter of the integral, which is another one inside");
    num_f x = fresh(c, sum, 0);
    if (region_faults == 0)
        c->binding[c->count - 1].near = 0; /* it is anywhere between the ends */
    num_f F = cagd_in_field(with_letter(c, t->at[2], t->head, (cagd_value){.f = x}, f));
    forget(c, known);
    if (region_faults == FAULT_UNABLE) /* whatever it was: for one value of the letter it would be known */
        c->trouble = "an integral of what has pieces, or of no polynomial", c->where = t;
    if (region_faults != 0)
        return sum;
    if (cagd_denominator_degree_f(F, x) > 0)
        return cagd_fail(c, t, FAULT_UNABLE, "only polynomials are integrated");
    cagd_value of_low = low, of_high = high;
    for (int k = 0; k <= cagd_degree_f(F, x); k++) {
        cagd_value part = cagd_value_mul(cagd_value_f(cagd_coefficient_f(F, x, k)), cagd_value_sub(of_high, of_low));
        sum = cagd_value_add(sum, cagd_value_div(part, cagd_value_int(k + 1)));
        of_low = cagd_value_mul(of_low, low), of_high = cagd_value_mul(of_high, high);
    }
    return sum;
}
