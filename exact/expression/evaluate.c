#include "exact/expression/evaluate.h"

#include "core/clock.h"
#include "exact/expression/angle.h"
#include "exact/expression/cell.h"
#include "exact/expression/evaluator.h"
#include "exact/expression/tie.h"
#include "exact/words.h"

#include <stdio.h>
#include <string.h>

enum { STEPS_BETWEEN_LOOKS = 64 }; /* at the clock */
enum { MOST_CALLS = 300, MOST_TERMS = 20000 };

typedef cagd_frame frame;

static cagd_value evaluate(cagd_context *c, const cagd_tree *t, const frame *f);
static int truth(cagd_context *c, const cagd_tree *t, const frame *f);

cagd_value cagd_fail(cagd_context *c, const cagd_tree *t, unsigned fault, const char *why)
{
    if (c->trouble == NULL && region_faults == 0)
        c->trouble = why, c->where = t;
    if (region_faults == 0)
        c->undefined_otherwise = fault == FAULT_UNDEFINED;
    region_faults |= fault;
    return cagd_value_int(0);
}

cagd_value cagd_divides_by_0(cagd_context *c, const cagd_tree *t)
{
    int first = region_faults == 0, alone = first || (region_faults == FAULT_UNDEFINED && !c->undefined_otherwise);
    if (c->passes_divisions && alone) {
        region_faults = 0;
        return cagd_value_int(0);
    }
    cagd_fail(c, t, FAULT_UNDEFINED, "a division by 0");
    if (first)
        c->undefined_otherwise = 0;
    return cagd_value_int(0);
}

/* ---- divisors ------------------------------------------------------------------------------------------ */

/* 0 where there is no room for it.  A variable that is near a place is no name of anybody's: what is divided by is meant there. */
int cagd_note_divisor(cagd_context *c, cagd_value b)
{
    c->divided_beside |= !b.rational && cagd_is_beside(c, b);
    if (c->way != NULL || c->tells_poles)
        b = cagd_at_places(c, b);
    if (c->divisor == NULL || b.rational)
        return 1;
    for (int i = 0; i < c->divisors; i++)
        if (equal_f(c->divisor[i], b.f))
            return 1;
    c->omits_poles |= c->tells_poles && c->divisors == c->most_divisors;
    if (c->divisors == c->most_divisors)
        return c->tells_poles;
    c->divisor[c->divisors++] = b.f;
    return 1;
}

/* Whether it is 0: of names near a root that is a matter of their polynomials. */
int cagd_is_zero_at_roots(const cagd_context *c, cagd_value b)
{
    int near = 0;
    for (int k = 0; k < c->count && !b.rational; k++)
        near |= c->binding[k].has_root && c->binding[k].unknown;
    return cagd_value_is_zero(near ? cagd_at_roots(c, b) : b);
}

/* ---- names --------------------------------------------------------------------------------------------- */

cagd_binding *cagd_binding_of(cagd_context *c, const char *key)
{
    for (int k = c->count - 1; k >= 0; k--) /* the last one: a letter may have another value for a while */
        if (strcmp(c->binding[k].key, key) == 0)
            return &c->binding[k];
    return NULL;
}

cagd_binding *cagd_bind(cagd_context *c, const char *key, cagd_value value)
{
    cagd_binding *b = cagd_binding_of(c, key);
    if (b == NULL) {
        if (c->count == CAGD_MOST_UNKNOWNS)
            return NULL;
        b = &c->binding[c->count++];
    }
    *b = (cagd_binding){.key = key, .value = value};
    return b;
}

/* The bounds of a variable where they are numbers. */
static void find_bounds(cagd_context *c, cagd_binding *b)
{
    const cagd_variable *v = b->variable;
    const cagd_tree *end[2] = {v != NULL ? v->low : NULL, v != NULL ? v->high : NULL};
    for (int k = 0; k < 2; k++) {
        cagd_value x = end[k] != NULL ? evaluate(c, end[k], NULL) : cagd_value_int(0);
        if (end[k] == NULL || region_faults != 0)
            continue;
        if (!x.rational) { /* known of two names together */
            num_f above = k == 0 ? sub_f(b->value.f, x.f) : sub_f(x.f, b->value.f);
            cagd_limit_cell(c, above, k == 0 ? v->low_open : v->high_open);
            continue;
        }
        if (k == 0)
            b->has_low = 1, b->low = x.q, b->low_open = v->low_open;
        else
            b->has_high = 1, b->high = x.q, b->high_open = v->high_open;
    }
    for (int k = 0; k < c->pieces; k++) {
        const cagd_piece *p = &c->piece[k];
        if (strcmp(p->key, b->key) != 0)
            continue;
        if (p->below)
            b->has_high = 1, b->high = p->at, b->high_open = 1;
        else
            b->has_low = 1, b->low = p->at, b->low_open = 1;
    }
}

/* A name without a value: the way has one, or it becomes a variable of the field. */
static cagd_value unknown(cagd_context *c, const cagd_tree *t, const char *key, const cagd_variable *v)
{
    cagd_value of_way;
    if (c->way != NULL && c->way->name(key, &of_way))
        return of_way;
    if (!c->in_field)
        return cagd_fail(c, t, FAULT_UNABLE, "a name without a value");
    char name[16];
    snprintf(name, sizeof name, "v%d", c->count);
    key = cagd_text_of(key, (int)strlen(key));
    cagd_binding *b = key != NULL ? cagd_bind(c, key, cagd_value_int(0)) : NULL;
    if (b == NULL)
        return cagd_fail(c, t, FAULT_UNABLE, "too many variables");
    num_f x = variable_f(name);
    b->value = (cagd_value){.f = x};
    b->unknown = 1, b->number = cagd_field_variable_f(x);
    b->variable = v;
    find_bounds(c, b);
    return b->value;
}

cagd_value cagd_value_of_key(cagd_context *c, const char *key, const cagd_variable *v)
{
    const cagd_binding *b = cagd_binding_of(c, key);
    cagd_tree none = {.kind = CAGD_NAME};
    return b != NULL ? b->value : unknown(c, &none, key, v);
}

/* "\omega_3^{2}": the name with the values of its indices, which go to index[]. */
static int key_and_indices(cagd_context *c, const cagd_tree *t, const cagd_frame *f, char key[], int room, long index[])
{
    for (int k = 0; k < t->lower + t->upper; k++) {
        cagd_value v = evaluate(c, t->at[k], f);
        if (region_faults != 0 || !cagd_value_is_whole(v, &index[k])) {
            cagd_fail(c, t->at[k], FAULT_UNABLE, "an index that is no whole number");
            return 0;
        }
    }
    int used = cagd_put_key(key, room, t, index);
    if (used >= room)
        cagd_fail(c, t, FAULT_UNABLE, "a name that is too long");
    return used < room;
}

int cagd_key_of(cagd_context *c, const cagd_tree *t, const cagd_frame *f, char key[], int room)
{
    long index[2 * CAGD_MOST_INDICES];
    return key_and_indices(c, t, f, key, room, index);
}

/* "(\mathbf{a}_1)_x": of a vector the component that is asked for. */
static int key_of_component(cagd_context *c, const cagd_tree *t, char key[], int room)
{
    static const char *const of_space[] = {"x", "y", "z"};
    const cagd_variable *v = cagd_declared(c->scope, t->head);
    if (v == NULL || v->dimension == 0)
        return 1;
    if (c->component == 0)
        return cagd_fail(c, t, FAULT_UNABLE, "a vector where a number is expected"), 0;
    char whole[96];
    int k = c->component, used, columns = cagd_columns(v->dimension);
    if (columns > 1)
        used = snprintf(whole, sizeof whole, "(%s)_{%d%d}", key, (k - 1) / columns + 1, (k - 1) % columns + 1);
    else
        used = v->dimension <= 3 ? snprintf(whole, sizeof whole, "(%s)_%s", key, of_space[k - 1])
                                 : snprintf(whole, sizeof whole, "(%s)_%d", key, k);
    if (used >= room)
        return cagd_fail(c, t, FAULT_UNABLE, "a name that is too long"), 0;
    memcpy(key, whole, (size_t)used + 1);
    return 1;
}

/* The value of a letter; that of an argument that is an angle is asked for as a number here. */
static cagd_value of_letter(cagd_context *c, const cagd_tree *t, cagd_value value)
{
    if (value.angle == NULL)
        return value;
    if (!value.angle->tangent.rational && value.angle->moved.rational) {
        c->asks_for_number = 1;
        return cagd_fail(c, t, FAULT_UNABLE, "an angle that is a number, too");
    }
    const cagd_binding *own = cagd_binding_of(c, t->head);
    int k = own != NULL && own->value.angle == value.angle ? (int)(own - c->binding) : -1;
    const char *key = k >= 0 ? own->key : NULL;
    if (k >= 0) /* in it the letter is what it was outside */
        c->binding[k].key = "";
    cagd_value number = evaluate(c, value.angle->tree, value.angle->frame);
    if (k >= 0)
        c->binding[k].key = key;
    return cagd_value_add(number, value.angle->moved);
}

/* \pi as a number: a variable between two numbers. */
static cagd_value pi(cagd_context *c)
{
    cagd_value x = cagd_value_of_key(c, CAGD_PI, NULL);
    cagd_binding *b = region_faults == 0 ? cagd_binding_of(c, CAGD_PI) : NULL;
    c->mixes_angles = 1;
    if (b != NULL && b->unknown && !b->has_low) {
        b->has_low = b->has_high = b->low_open = b->high_open = b->hidden = b->is_number = 1;
        b->low = cagd_below_pi(), b->high = cagd_above_pi();
    }
    return x;
}

/* Whether the declaration says anything of the name with these indices; where that depends on names without values there is none. */
static int is_for_indices(void *data, const cagd_variable *v, const long index[])
{
    cagd_context *c = data;
    frame room[2 * CAGD_MOST_INDICES];
    const frame *f = NULL;
    if (v->when == NULL || v->left == NULL)
        return 1;
    for (int k = 0; k < v->left->lower + v->left->upper; k++)
        if (v->left->at[k]->kind == CAGD_NAME) {
            room[k] = (frame){v->left->at[k]->head, cagd_value_int(index[k]), f};
            f = &room[k];
        }
    int is = truth(c, v->when, f);
    if (is < 0 && region_faults == 0)
        cagd_fail(c, v->left, FAULT_UNABLE, "of which indices bounds are depends on variables");
    return is > 0;
}

const cagd_variable *cagd_declaration_of(cagd_context *c, const cagd_tree *t, const cagd_frame *f, char key[], int room)
{
    long index[2 * CAGD_MOST_INDICES];
    if (!key_and_indices(c, t, f, key, room, index))
        return NULL;
    return cagd_declared_for(c->scope, t, key, index, is_for_indices, c);
}

/* A name that no definition fits, or that has none. */
static cagd_value variable(cagd_context *c, const cagd_tree *t, const frame *f)
{
    char key[96];
    long index[2 * CAGD_MOST_INDICES];
    if (!key_and_indices(c, t, f, key, sizeof key, index))
        return cagd_value_int(0);
    if (!key_of_component(c, t, key, sizeof key))
        return cagd_value_int(0);
    const cagd_binding *b = cagd_binding_of(c, key);
    if (b != NULL)
        return of_letter(c, t, b->value);
    for (int k = 0; k < c->count; k++)
        c->mixes_angles |= c->binding[k].angle != NULL && strcmp(c->binding[k].angle, key) == 0;
    if (strcmp(key, CAGD_PI) == 0 && cagd_declared(c->scope, t->head) == NULL)
        return pi(c);
    const cagd_variable *declared = cagd_declared_for(c->scope, t, key, index, is_for_indices, c);
    return region_faults == 0 ? unknown(c, t, key, declared) : cagd_value_int(0);
}

/* ---- definitions --------------------------------------------------------------------------------------- */

/* The frame in which the left side has these values; its nodes are `room`.  0 where it does not fit; -1 where that depends on
 * variables. */
static int match(cagd_context *c, const cagd_definition *d, const cagd_value value[], frame room[], const frame **out)
{
    const frame *f = NULL;
    for (int k = 0; k < d->left->count; k++) {
        const cagd_tree *pattern = d->left->at[k];
        int same = cagd_same_index(d->left, k);
        if (same >= 0 && !(value[k].rational && value[same].rational)) {
            if (!cagd_equal_f(cagd_in_field(value[k]), cagd_in_field(value[same])))
                return -1;
        } else if (same >= 0) {
            if (!cagd_equal_q(value[k].q, value[same].q))
                return 0;
        } else if (pattern->kind == CAGD_NUMBER) {
            if (!value[k].rational)
                return -1;
            if (!cagd_equal_q(pattern->number, value[k].q))
                return 0;
        } else {
            room[k] = (frame){pattern->head, value[k], f};
            f = &room[k];
        }
    }
    *out = f;
    return d->when == NULL ? 1 : truth(c, d->when, f);
}

const cagd_tree *cagd_body_of(cagd_context *c, const cagd_tree *t, const cagd_value value[], cagd_frame room[],
                              const cagd_frame **inner)
{
    for (const cagd_definition *d = c->scope->definitions; d != NULL; d = d->next) {
        if (strcmp(d->left->head, t->head) != 0)
            continue;
        int fits = match(c, d, value, room, inner);
        if (region_faults == 0 && fits < 0)
            cagd_fail(c, t, FAULT_UNABLE, "which definition fits depends on variables");
        if (region_faults != 0)
            return NULL;
        if (fits)
            return d->body;
    }
    return NULL;
}

/* Whether a name that stands for many numbers is in the value. */
static int has_name(const cagd_context *c, cagd_value value)
{
    for (int m = 0; m < c->count && !value.rational; m++) {
        const cagd_binding *b = &c->binding[m];
        if (b->unknown && !b->hidden && b->key[0] != '\0' &&
            (degree_f(value.f, b->value.f) > 0 || denominator_degree_f(value.f, b->value.f) > 0))
            return 1;
    }
    return 0;
}

/* "no definition fits with i = -1": the letters are those of the first definition; numbers that are long, or none, are left out. */
static const char *why_none_fits(const cagd_context *c, const cagd_tree *t, const cagd_value value[])
{
    static const char words[] = "no definition fits",
                      everywhere[] = "it is not defined everywhere: ':for: ...' with the condition of its definition "
                                     "says that it is meant there";
    const cagd_definition *d = cagd_defined(c->scope, t->head);
    char text[120];
    int used = snprintf(text, sizeof text, "%s", words), told = 0, is_conditional = 0;
    for (; d != NULL && strcmp(d->left->head, t->head) == 0 && told == 0; d = d->next)
        for (int k = 0; k < d->left->count && used < 80; k++) {
            is_conditional |= d->when != NULL && has_name(c, cagd_at_places(c, value[k]));
            char number[24];
            int length = value[k].rational && d->left->at[k]->kind == CAGD_NAME && strlen(d->left->at[k]->head) < 12
                             ? gmp_snprintf(number, sizeof number, "%Qd", value[k].q.at)
                             : 0;
            if (length > 0 && length < 20)
                used += snprintf(text + used, sizeof text - (size_t)used, "%s %s = %s", told++ == 0 ? " with" : ",",
                                 d->left->at[k]->head, number);
        }
    const char *kept = told > 0 ? cagd_text_of(text, used) : NULL;
    return kept != NULL ? kept : is_conditional ? everywhere : words;
}

/* The value of the definitions of that name for these indices and arguments. */
cagd_value cagd_defined_value(cagd_context *c, const cagd_tree *t, const cagd_value value[], const frame *caller)
{
    frame room[CAGD_MOST_CHILDREN];
    const frame *f;
    const cagd_tree *body = cagd_body_of(c, t, value, room, &f);
    if (region_faults != 0)
        return cagd_value_int(0);
    if (body == NULL && cagd_declared(c->scope, t->head) != NULL)
        return variable(c, t, caller);
    if (body == NULL) {
        c->fits_none = 1;
        return cagd_fail(c, t, FAULT_UNDEFINED, why_none_fits(c, t, value));
    }
    if (c->depth == MOST_CALLS)
        return cagd_fail(c, t, FAULT_UNABLE, "definitions that use one another without end");
    c->depth++;
    cagd_value result = evaluate(c, body, f);
    c->depth--;
    return result;
}

cagd_value cagd_name_value(cagd_context *c, const cagd_tree *t, const frame *f)
{
    if (t->count == 0)
        for (const frame *g = f; g != NULL; g = g->next)
            if (strcmp(g->head, t->head) == 0)
                return of_letter(c, t, g->value);
    const cagd_definition *d = cagd_defined(c->scope, t->head);
    if (d == NULL)
        return variable(c, t, f);
    cagd_value value[CAGD_MOST_CHILDREN];
    cagd_arguments_of(c, t, d, f, value);
    long order = t->order;
    if (t->times != NULL)
        order += cagd_order_of(c, t, t->times, f);
    if (region_faults != 0)
        return cagd_value_int(0);
    if (order == 0)
        return cagd_defined_value(c, t, value, f);
    if (value[t->lower + t->upper].angle != NULL)
        return cagd_derivative_by_angle(c, t, NULL, value, order, value[t->lower + t->upper].angle, f);
    return cagd_derivative_of(c, t, NULL, value, order, value[t->lower + t->upper], f);
}

/* ---- comparisons --------------------------------------------------------------------------------------- */

int cagd_relation_holds(int sign, cagd_relation relation)
{
    switch (relation) {
    case CAGD_EQUAL:
        return sign == 0;
    case CAGD_NOT_EQUAL:
        return sign != 0;
    case CAGD_LESS:
        return sign < 0;
    case CAGD_LESS_OR_EQUAL:
        return sign <= 0;
    case CAGD_GREATER:
        return sign > 0;
    default:
        return sign >= 0;
    }
}

/* Whether the relation holds for all of the signs: 1; for none: 0; otherwise -1. */
static int holds_for_signs(unsigned signs, cagd_relation relation)
{
    int some = 0, all = 1;
    for (int sign = -1; sign <= 1; sign++)
        if (signs >> (sign + 1) & 1) {
            some |= cagd_relation_holds(sign, relation);
            all &= cagd_relation_holds(sign, relation);
        }
    return all ? 1 : some ? -1 : 0;
}

int cagd_is_zero_here(cagd_context *c, cagd_value d)
{
    return cagd_value_is_zero(d) || (c->way != NULL && !d.rational && c->way->holds(d.f, CAGD_EQUAL));
}

int cagd_equal_here(cagd_context *c, cagd_value a, cagd_value b)
{
    if (c->way != NULL && !(a.rational && b.rational))
        return c->way->equal(cagd_in_field(a), cagd_in_field(b));
    return cagd_value_is_zero(cagd_value_sub(a, b));
}

int cagd_compare_values(cagd_context *c, cagd_value a, cagd_relation relation, cagd_value b)
{
    cagd_value d = cagd_value_sub(a, b);
    if (region_faults != 0)
        return -1;
    if (c->way != NULL && !d.rational && !cagd_is_beside(c, d))
        return c->way->holds(d.f, relation);
    int is_first = c->split == NULL && !c->has_cut;
    int is = holds_for_signs(cagd_signs(c, d), relation);
    c->used_bounds |= !d.rational;
    if (is >= 0 && is_first) /* a sign that changes does not matter */
        c->split = NULL, c->has_cut = 0;
    return region_faults != 0 ? -1 : is;
}

static int chain(cagd_context *c, const cagd_tree *t, const frame *f)
{
    int result = 1;
    cagd_value left = evaluate(c, t->at[0], f);
    for (int k = 0; k + 1 < t->count && region_faults == 0 && result != 0; k++) {
        cagd_value right = evaluate(c, t->at[k + 1], f);
        int one = cagd_compare_values(c, left, t->relation[k], right);
        result = one == 0 ? 0 : one < 0 ? -1 : result;
        left = right;
    }
    return result;
}

/* All of them, or (`any`) one at least: the first that decides ends it. */
static int several(cagd_context *c, const cagd_tree *t, int any, const frame *f)
{
    int result = !any;
    for (int k = 0; k < t->count && result != any; k++) {
        int one = truth(c, t->at[k], f);
        result = one == any ? any : one < 0 ? -1 : result;
    }
    return result;
}

/* For all, or (`any`) for one at least, of the numbers of a range. */
static int quantified(cagd_context *c, const cagd_tree *t, int any, const frame *f)
{
    long low, high;
    cagd_value first = evaluate(c, t->at[0], f), last = evaluate(c, t->at[1], f);
    int result = !any;
    if (region_faults != 0 || !cagd_value_is_whole(first, &low) || !cagd_value_is_whole(last, &high) ||
        high - low > MOST_TERMS)
        return cagd_fail(c, t, FAULT_UNABLE, "a range that does not end at whole numbers"), -1;
    for (long k = low; k <= high && region_faults == 0 && result != any; k++) {
        frame inner = {t->head, cagd_value_int(k), f};
        int one = truth(c, t->at[2], &inner);
        result = one == any ? any : one < 0 ? -1 : result;
    }
    cagd_note_sum(&c->sums, t, high >= low);
    return result;
}

static int connected(cagd_context *c, const cagd_tree *t, const frame *f)
{
    int a = truth(c, t->at[0], f), b;
    switch (t->kind) {
    case CAGD_NOT:
        return a < 0 ? -1 : !a;
    case CAGD_IMPLIES:
        b = a == 0 ? 1 : truth(c, t->at[1], f);
        return b == 1 || a == 1 ? b : -1;
    default:
        b = truth(c, t->at[1], f);
        return a < 0 || b < 0 ? -1 : a == b;
    }
}

static int truth(cagd_context *c, const cagd_tree *t, const frame *f)
{
    int result, is_first = c->split == NULL && !c->has_cut && c->trouble == NULL;
    switch (t->kind) {
    case CAGD_RELATION:
        result = chain(c, t, f);
        break;
    case CAGD_ALL:
    case CAGD_ANY:
        result = several(c, t, t->kind == CAGD_ANY, f);
        break;
    case CAGD_FOR_ALL:
    case CAGD_EXISTS:
        result = quantified(c, t, t->kind == CAGD_EXISTS, f);
        break;
    case CAGD_NOT:
    case CAGD_IMPLIES:
    case CAGD_IFF:
        result = connected(c, t, f);
        break;
    default:
        return -1;
    }
    if (region_faults != 0)
        return -1;
    if (result < 0)
        cagd_fail(c, t, 0, "a condition that depends on variables");
    else if (is_first) /* what a part of it depends on does not matter */
        c->split = NULL, c->has_cut = 0, c->trouble = NULL;
    return result;
}

/* ---- the other operations ------------------------------------------------------------------------------ */

/* Of the list the greatest or the least; of a number its amount, for the list a, -a. */
static cagd_value extremum(cagd_context *c, const cagd_tree *t, const frame *f, cagd_relation better)
{
    cagd_value best = evaluate(c, t->at[0], f);
    int amount = t->kind == CAGD_ABSOLUTE;
    for (int k = amount ? 0 : 1; k < t->count && region_faults == 0; k++) {
        cagd_value next = amount ? cagd_value_sub(cagd_value_int(0), best) : evaluate(c, t->at[k], f);
        int is = region_faults == 0 ? cagd_compare_values(c, next, better, best) : 0;
        if (is < 0)
            return cagd_fail(c, t, FAULT_UNABLE, "which is larger depends on variables");
        best = is ? next : best;
    }
    return best;
}

/* Whether it is a sum of whole multiples of variables that stand for whole numbers, and of a whole number. */
static int is_whole_form(const cagd_context *c, num_f rest)
{
    num_q number;
    for (int k = 0; k < c->wholes; k++) {
        if (!is_constant_f(derivative_f(rest, c->whole[k]), &number) || !cagd_is_whole_q(number))
            return 0;
        rest = sub_f(rest, mul_f(cagd_from_rational_f(number), c->whole[k]));
    }
    return c->wholes > 0 && is_constant_f(rest, &number) && cagd_is_whole_q(number);
}

static cagd_value rounded(cagd_context *c, const cagd_tree *t, const frame *f)
{
    cagd_value a = evaluate(c, t->at[0], f);
    if (region_faults != 0)
        return a;
    if (!a.rational && is_whole_form(c, a.f))
        return a;
    if (!a.rational)
        return cagd_fail(c, t, FAULT_UNABLE, "a rounded number that depends on variables");
    return cagd_value_constant(t->kind == CAGD_FLOOR ? cagd_floor_q(a.q) : neg_q(cagd_floor_q(neg_q(a.q))));
}

/* The greater or the smaller one of the values before and the next, the `count`-th. */
static cagd_value better_of(cagd_context *c, const cagd_tree *t, cagd_value before, cagd_value next, int count)
{
    if (region_faults != 0 || count == 1)
        return next;
    int is = cagd_compare_values(c, next, t->kind == CAGD_MAXIMUM_OVER ? CAGD_GREATER : CAGD_LESS, before);
    return is < 0 ? cagd_fail(c, t, FAULT_UNABLE, "which is larger depends on variables") : is ? next : before;
}

void cagd_note_sum(cagd_sums_met *met, const cagd_tree *sum, int has_terms)
{
    int k = 0;
    while (k < met->count && met->sum[k] != sum)
        k++;
    if (k == met->count && k < CAGD_MOST_SUMS)
        met->sum[met->count] = sum, met->had_terms[met->count++] = 0;
    if (k < CAGD_MOST_SUMS)
        met->had_terms[k] |= has_terms;
}

static cagd_value over(cagd_context *c, const cagd_tree *t, const frame *f)
{
    long low, high;
    cagd_value first = evaluate(c, t->at[0], f), last = evaluate(c, t->at[1], f);
    cagd_value r = cagd_value_int(t->kind == CAGD_PRODUCT_OVER ? 1 : 0);
    int is_extremum = t->kind == CAGD_MAXIMUM_OVER || t->kind == CAGD_MINIMUM_OVER, count = 0;
    if (region_faults != 0)
        return r;
    if (!cagd_value_is_whole(first, &low) || !cagd_value_is_whole(last, &high))
        return cagd_fail(
            c, t, FAULT_UNABLE,
            "a sum runs between whole numbers: n \\ge 1 says nothing of that, n = 1.. or n \\in \\mathbb{N} does");
    if (high - low > MOST_TERMS)
        return cagd_fail(c, t, FAULT_UNABLE, "a sum of too many terms");
    for (long k = low; k <= high && region_faults == 0; k++) {
        frame inner = {t->head, cagd_value_int(k), f};
        int counted = 1;
        for (int m = 3; m < t->count && counted == 1; m++)
            counted = truth(c, t->at[m], &inner);
        if (counted < 0)
            return cagd_fail(c, t, FAULT_UNABLE, "a condition that depends on variables");
        if (!counted)
            continue;
        cagd_value term = evaluate(c, t->at[2], &inner);
        count++;
        r = is_extremum                ? better_of(c, t, r, term, count)
            : t->kind == CAGD_SUM_OVER ? cagd_value_add(r, term)
                                       : cagd_value_mul(r, term);
    }
    if (is_extremum && count == 0 && region_faults == 0)
        return cagd_fail(c, t, FAULT_UNDEFINED, "the greatest or smallest of nothing");
    cagd_note_sum(&c->sums, t, count > 0);
    return r;
}

static cagd_value cases(cagd_context *c, const cagd_tree *t, const frame *f)
{
    for (int k = 0; k < t->count; k += 2) {
        int is = k + 1 < t->count ? truth(c, t->at[k + 1], f) : 1;
        if (region_faults != 0)
            return cagd_value_int(0);
        if (is < 0)
            return cagd_fail(c, t, FAULT_UNABLE, "a condition that depends on variables");
        if (is)
            return evaluate(c, t->at[k], f);
    }
    c->fits_none = 1;
    return cagd_fail(c, t, FAULT_UNDEFINED, "none of the cases");
}

static cagd_value quotient(cagd_context *c, const cagd_tree *t, const frame *f)
{
    cagd_value a = evaluate(c, t->at[0], f), b = evaluate(c, t->at[1], f);
    if (region_faults != 0)
        return a;
    if (c->scope->zero_over_zero && c->way != NULL && cagd_is_zero_here(c, b))
        b = cagd_value_int(0);
    if (c->scope->zero_over_zero && cagd_is_zero_at_roots(c, b) &&
        (cagd_is_zero_at_roots(c, a) || cagd_equal_here(c, a, cagd_value_int(0))))
        return cagd_value_int(0);
    if (c->scope->zero_over_zero && c->way == NULL && !b.rational && !cagd_divides(c, b))
        return cagd_fail(c, t, FAULT_UNABLE, "a divisor that can be 0");
    if (!cagd_note_divisor(c, b))
        return cagd_fail(c, t, FAULT_UNABLE, "too many divisors");
    return cagd_is_zero_at_roots(c, b) ? cagd_divides_by_0(c, t) : cagd_value_div(a, b);
}

/* Whether t, of which the value was just asked for, has none because of divisions by 0 alone: with 0 in their place it has one.  Then it is
 * as if it had not been asked for; else what is wrong besides is known. */
static int is_divided_by_0_alone(cagd_context *c, const cagd_tree *t, const frame *f, const char *trouble,
                                 const cagd_tree *where)
{
    if (region_faults != FAULT_UNDEFINED || c->undefined_otherwise || c->passes_divisions)
        return 0;
    region_faults = 0, c->trouble = trouble, c->where = where;
    c->passes_divisions = 1;
    evaluate(c, t, f);
    c->passes_divisions = 0;
    return region_faults == 0;
}

/* With 0/0 = 0 said, a factor that is divided by 0 is not asked for beside another that is 0; one that is undefined for another reason is. */
static cagd_value product(cagd_context *c, const cagd_tree *t, const frame *f)
{
    cagd_value r = cagd_value_int(1);
    const char *trouble = c->trouble;
    const cagd_tree *where = c->where, *divided = NULL;
    for (int k = 0; k < t->count; k++) {
        c->undefined_otherwise = 0;
        cagd_value x = evaluate(c, t->at[k], f);
        const cagd_tree *failed = c->where;
        if (region_faults != 0 && c->scope->zero_over_zero && is_divided_by_0_alone(c, t->at[k], f, trouble, where)) {
            divided = divided != NULL ? divided : failed;
            continue;
        }
        if (region_faults != 0)
            return x;
        r = cagd_value_mul(r, x);
    }
    if (divided != NULL && !cagd_equal_here(c, r, cagd_value_int(0)))
        return cagd_divides_by_0(c, divided);
    return r;
}

static cagd_value evaluate(cagd_context *c, const cagd_tree *t, const frame *f)
{
    if (region_faults != 0)
        return cagd_value_int(0);
    if (--c->steps < 0)
        return cagd_fail(c, t, FAULT_UNABLE, "more steps than are given to one case");
    if (c->until > 0 && c->steps % STEPS_BETWEEN_LOOKS == 0 && cagd_seconds() > c->until)
        return cagd_fail(c, t, FAULT_UNABLE, "the time was over");
    cagd_value r;
    switch (t->kind) {
    case CAGD_NUMBER:
        return cagd_value_constant(t->number);
    case CAGD_NAME:
        return cagd_name_value(c, t, f);
    case CAGD_SUM:
        r = cagd_value_int(0);
        for (int k = 0; k < t->count; k++)
            r = cagd_value_add(r, evaluate(c, t->at[k], f));
        return r;
    case CAGD_PRODUCT:
        return product(c, t, f);
    case CAGD_NEGATIVE:
        return cagd_value_sub(cagd_value_int(0), evaluate(c, t->at[0], f));
    case CAGD_QUOTIENT:
        return quotient(c, t, f);
    case CAGD_POWER:
        return cagd_power_value(c, t, f);
    case CAGD_FACTORIAL:
        return cagd_factorial_value(c, t, f);
    case CAGD_BINOMIAL:
        return cagd_binomial_value(c, t, f);
    case CAGD_Q_NUMBER:
    case CAGD_Q_FACTORIAL:
        return cagd_q_value(c, t, f);
    case CAGD_Q_BINOMIAL:
        return cagd_q_binomial_value(c, t, f);
    case CAGD_ROOT:
        return cagd_root_value(c, t, f);
    case CAGD_ABSOLUTE:
    case CAGD_MAXIMUM:
        return extremum(c, t, f, CAGD_GREATER);
    case CAGD_MINIMUM:
        return extremum(c, t, f, CAGD_LESS);
    case CAGD_FLOOR:
    case CAGD_CEILING:
        return rounded(c, t, f);
    case CAGD_SUM_OVER:
    case CAGD_PRODUCT_OVER:
    case CAGD_MAXIMUM_OVER:
    case CAGD_MINIMUM_OVER:
        return over(c, t, f);
    case CAGD_DERIVATIVE:
        return cagd_derivative_value(c, t, f);
    case CAGD_INTEGRAL:
        return cagd_integral_value(c, t, f);
    case CAGD_AT:
        return cagd_place_value(c, t, f);
    case CAGD_CASES:
        return cases(c, t, f);
    case CAGD_POINT:
    case CAGD_CROSS:
        return cagd_vector_value(c, t, f);
    case CAGD_MATRIX_PRODUCT:
    case CAGD_TRANSPOSED:
    case CAGD_INVERSE:
        return cagd_matrix_value(c, t, f);
    case CAGD_COMPONENT:
        return cagd_component_value(c, t->at[0], t->order, f);
    case CAGD_DOT:
        return cagd_dot_value(c, t->at[0], t->at[1], f);
    case CAGD_MIXED:
        return cagd_mixed_value(c, t, f);
    case CAGD_DETERMINANT:
        return cagd_determinant_value(c, t, f);
    case CAGD_COSINE:
    case CAGD_SINE:
        return cagd_circular(c, t, f);
    case CAGD_NORM:
        return cagd_root_of_value(c, t, cagd_dot_value(c, t->at[0], t->at[0], f), 2);
    default:
        return cagd_fail(c, t, FAULT_UNABLE, "a relation is no value");
    }
}

cagd_value cagd_evaluate(cagd_context *c, const cagd_tree *t) { return evaluate(c, t, NULL); }
cagd_value cagd_evaluate_in(cagd_context *c, const cagd_tree *t, const cagd_frame *f) { return evaluate(c, t, f); }
int cagd_truth(cagd_context *c, const cagd_tree *t) { return truth(c, t, NULL); }
int cagd_truth_in(cagd_context *c, const cagd_tree *t, const cagd_frame *f) { return truth(c, t, f); }
