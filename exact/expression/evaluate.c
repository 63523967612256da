#include "exact/expression/evaluate.h"

#include "core/clock.h"
#include "exact/expression/angle.h"
#include "exact/expression/cell.h"
#include "exact/expression/tie.h"
#include "exact/words.h"

#include <stdio.h>
#include <string.h>

enum { STEPS_BETWEEN_LOOKS = 64 }; /* at the clock */
enum { MOST_CALLS = 300, MOST_POWER = 1000, MOST_FACTORIAL = 1000, MOST_TERMS = 20000, MOST_Q = 100 };

typedef cagd_frame frame;

static cagd_value evaluate(cagd_context *c, const cagd_tree *t, const frame *f);
static int truth(cagd_context *c, const cagd_tree *t, const frame *f);

cagd_value cagd_fail(cagd_context *c, const cagd_tree *t, unsigned fault, const char *why)
{
    if (c->trouble == NULL && region_faults == 0)
        c->trouble = why, c->where = t;
    region_faults |= fault;
    return cagd_value_int(0);
}

/* ---- divisors ------------------------------------------------------------------------------------------ */

/* 0 where there is no room for it.  A variable that is near a place is no name of anybody's: what is divided by is meant there. */
static int note_divisor(cagd_context *c, cagd_value b)
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
static int is_zero(const cagd_context *c, cagd_value b)
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
    if (!value.angle->tangent.rational)
        return cagd_fail(c, t, FAULT_UNABLE, "an angle that is a number, too");
    return evaluate(c, value.angle->tree, value.angle->frame);
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
        if (c->binding[k].angle != NULL && strcmp(c->binding[k].angle, key) == 0)
            return cagd_fail(c, t, FAULT_UNABLE, "an angle that is a number, too");
    if (strcmp(key, "\\pi") == 0 && cagd_declared(c->scope, t->head) == NULL)
        return cagd_fail(c, t, FAULT_UNABLE, "\\pi is no rational number: it stands in angles, and in their bounds");
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

/* "no definition fits with i = -1": the letters are those of the first definition; numbers that are long, or none, are left out. */
static const char *why_none_fits(const cagd_context *c, const cagd_tree *t, const cagd_value value[])
{
    static const char words[] = "no definition fits";
    const cagd_definition *d = cagd_defined(c->scope, t->head);
    char text[120];
    int used = snprintf(text, sizeof text, "%s", words), told = 0;
    for (; d != NULL && strcmp(d->left->head, t->head) == 0 && told == 0; d = d->next)
        for (int k = 0; k < d->left->count && used < 80; k++) {
            char number[24];
            int length = value[k].rational && d->left->at[k]->kind == CAGD_NAME && strlen(d->left->at[k]->head) < 12
                             ? gmp_snprintf(number, sizeof number, "%Qd", value[k].q.at)
                             : 0;
            if (length > 0 && length < 20)
                used += snprintf(text + used, sizeof text - (size_t)used, "%s %s = %s", told++ == 0 ? " with" : ",",
                                 d->left->at[k]->head, number);
        }
    const char *kept = told > 0 ? cagd_text_of(text, used) : NULL;
    return kept != NULL ? kept : words;
}

/* The value of the definitions of that name for these indices and arguments. */
static cagd_value apply(cagd_context *c, const cagd_tree *t, const cagd_value value[], const frame *caller)
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
    if (k < 0 || k > MOST_POWER)
        return cagd_fail(c, t, FAULT_UNABLE, "the order of a derivative is a whole number, at least 0");
    for (; k > 0 && region_faults == 0; k--)
        g = derivative_f(g, x);
    if (region_faults == 0)
        g = substitute_f(g, x, cagd_in_field(a));
    if (region_faults != 0)
        return cagd_fail(c, t, FAULT_UNDEFINED, "a division by 0");
    return cagd_value_f(g);
}

static long order_of(cagd_context *c, const cagd_tree *t, const cagd_tree *order, const frame *f)
{
    long k = -1;
    cagd_value n = evaluate(c, order, f);
    if (!cagd_value_is_whole(n, &k) && region_faults == 0)
        cagd_fail(c, t, FAULT_UNABLE, "the order of a derivative is a whole number");
    return k;
}

static cagd_value with_letter(cagd_context *c, const cagd_tree *t, const char *letter, cagd_value x, const frame *f);

/* The argument as an angle, which lives in the region. */
static cagd_value as_angle(const cagd_tree *t, const frame *f)
{
    struct cagd_angle *a = region_bytes(sizeof *a);
    cagd_value v = cagd_value_int(0);
    if (a != NULL)
        *a = (struct cagd_angle){t, f, cagd_value_int(0)};
    v.angle = a;
    return v;
}

void cagd_arguments_of(cagd_context *c, const cagd_tree *t, const cagd_definition *d, const cagd_frame *f,
                       cagd_value value[])
{
    for (int k = 0; k < d->left->count; k++) { /* arguments that are left out are the letters of the definition */
        const cagd_tree *argument = k < t->count ? t->at[k] : d->left->at[k];
        value[k] = cagd_is_angle_argument(c, d, k) ? as_angle(argument, f) : evaluate(c, argument, f);
    }
}

/* The value at a of the name t with those arguments but the first, or of the body as a function of the letter of t. */
static cagd_value value_at(cagd_context *c, const cagd_tree *t, const cagd_tree *body, cagd_value value[], cagd_value a,
                           const frame *f)
{
    if (body != NULL)
        return with_letter(c, body, t->head, a, f);
    value[t->lower + t->upper] = a;
    return apply(c, t, value, f);
}

/* The k-th derivative of the name t by its first argument, or of the body by the letter of t, an angle: it is moved by another, which
 * is 0 then. */
static cagd_value derivative_by_angle(cagd_context *c, const cagd_tree *t, const cagd_tree *body, cagd_value value[],
                                      long k, const struct cagd_angle *at, const frame *f)
{
    cagd_value zero = cagd_value_int(0), here = zero, moved = zero;
    if (k < 0 || k > MOST_POWER)
        return cagd_fail(c, t, FAULT_UNABLE, "the order of a derivative is a whole number, at least 0");
    int known = c->count, before = c->met_joint;
    c->met_joint = 0;
    num_f x = fresh(c, zero, 1);
    struct cagd_angle by = {at->tree, at->frame, {.f = x}};
    if (!at->tangent.rational && region_faults == 0) /* a derivative within another */
        return cagd_fail(c, t, FAULT_UNABLE, "derivatives by angles within one another");
    moved.angle = &by, here.angle = at;
    num_f g = cagd_in_field(region_faults == 0 ? value_at(c, t, body, value, moved, f) : zero);
    forget(c, known);
    if (c->met_joint && region_faults == 0)
        return cagd_fail(c, t, FAULT_UNABLE, "a derivative by an angle at a joint");
    c->met_joint = before;
    for (; k > 0 && region_faults == 0; k--)
        g = cagd_by_angle_f(c, g, x);
    if (region_faults == 0)
        g = substitute_f(g, x, from_int_f(0));
    if (region_faults == 0 && body != NULL) /* where there is no value there is no derivative */
        evaluate(c, body, f);
    else if (region_faults == 0)
        value_at(c, t, NULL, value, here, f);
    return region_faults != 0 ? cagd_fail(c, t, FAULT_UNDEFINED, "a division by 0") : cagd_value_f(g);
}

/* The k-th derivative at a, from one side: of the name t by its first argument, value[] being all of them, or of the body by the letter of
 * t.  lower[j], j <= k, are those of lower order, and 0 is the value. */
static cagd_value derivative_from(cagd_context *c, const cagd_tree *t, const cagd_tree *body, cagd_value value[],
                                  long k, cagd_value a, int side, cagd_value lower[], const frame *f)
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
                       cagd_value limit, const frame *f)
{
    cagd_value there = value_at(c, t, body, value, a, f);
    return region_faults == 0 && cagd_equal_here(c, there, limit);
}

/* The derivative; at a joint of pieces it is there if those of both sides are equal, and the lower ones, too, and the value there is
 * theirs; where the definitions end, it is that of the side on which they fit, if the function has a value there, to which it tends. */
static cagd_value derivative_at(cagd_context *c, const cagd_tree *t, const cagd_tree *body, cagd_value value[], long k,
                                cagd_value a, const frame *f)
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

static cagd_value name(cagd_context *c, const cagd_tree *t, const frame *f)
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
        order += order_of(c, t, t->times, f);
    if (region_faults != 0)
        return cagd_value_int(0);
    if (order == 0)
        return apply(c, t, value, f);
    if (value[t->lower + t->upper].angle != NULL)
        return derivative_by_angle(c, t, NULL, value, order, value[t->lower + t->upper].angle, f);
    return derivative_at(c, t, NULL, value, order, value[t->lower + t->upper], f);
}

/* The value of t when the letter is x, inside what is evaluated and in the definitions that it uses. */
static cagd_value with_letter(cagd_context *c, const cagd_tree *t, const char *letter, cagd_value x, const frame *f)
{
    frame inner = {letter, x, f};
    for (const frame *g = f; g != NULL; g = g->next) /* a letter of this definition alone */
        if (strcmp(g->head, letter) == 0)
            return evaluate(c, t, &inner);
    int known = c->count;
    if (known == CAGD_MOST_UNKNOWNS)
        return cagd_fail(c, t, FAULT_UNABLE, "too many variables");
    c->binding[c->count++] = (cagd_binding){.key = letter, .value = inner.value};
    cagd_value F = evaluate(c, t, &inner);
    if (known + 1 == c->count)
        c->count = known;
    else
        c->binding[known] = (cagd_binding){.key = "", .value = cagd_value_int(0)};
    return F;
}

/* d^k a / dw_j^k for a name with an index. */
static cagd_value derivative_by_name(cagd_context *c, const cagd_tree *t, const frame *f)
{
    char key[96];
    long order = order_of(c, t, t->at[1], f);
    cagd_value at = name(c, t->at[2], f);
    cagd_tree *by = cagd_tree_new(CAGD_DERIVATIVE, t->from, t->to, 2);
    if (by == NULL || region_faults != 0 || !cagd_key_of(c, t->at[2], f, key, sizeof key))
        return at;
    by->head = cagd_text_of(key, (int)strlen(key)), by->at[0] = t->at[0], by->at[1] = t->at[1];
    return by->head != NULL ? derivative_at(c, by, t->at[0], NULL, order, at, f) : at;
}

/* d^k a / dx^k for a letter x that has a value here. */
static cagd_value derivative(cagd_context *c, const cagd_tree *t, const frame *f)
{
    cagd_tree letter = {.kind = CAGD_NAME, .head = t->head, .from = t->from, .to = t->to};
    if (t->count > 2)
        return derivative_by_name(c, t, f);
    long order = order_of(c, t, t->at[1], f);
    if (region_faults == 0 && cagd_is_angle_in(c, t->at[0], t->head)) {
        struct cagd_angle here = {&letter, f, cagd_value_int(0)};
        return derivative_by_angle(c, &letter, t->at[0], NULL, order, &here, f);
    }
    cagd_value at = name(c, &letter, f);
    if (region_faults != 0)
        return at;
    if (cagd_defined(c->scope, t->head) != NULL)
        return cagd_fail(c, t, FAULT_UNABLE, "a derivative by what was given a value");
    return derivative_at(c, t, t->at[0], NULL, order, at, f);
}

static cagd_value at_a_place(cagd_context *c, const cagd_tree *t, const frame *f)
{
    if (cagd_is_angle_in(c, t->at[0], t->head))
        return with_letter(c, t->at[0], t->head, as_angle(t->at[1], f), f);
    cagd_value place = evaluate(c, t->at[1], f);
    int known = c->count;
    num_f x = fresh(c, place, 0);
    cagd_value F = with_letter(c, t->at[0], t->head, (cagd_value){.f = x}, f);
    forget(c, known);
    return region_faults != 0 ? F : derived(c, t, F, x, 0, place);
}

static cagd_value integral(cagd_context *c, const cagd_tree *t, const frame *f)
{
    cagd_value low = evaluate(c, t->at[0], f), high = evaluate(c, t->at[1], f), sum = cagd_value_int(0);
    int known = c->count;
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

/* ---- vectors ------------------------------------------------------------------------------------------- */

/* The component k of a vector, from 0, whichever is asked for here. */
static cagd_value component(cagd_context *c, const cagd_tree *t, int k, const frame *f)
{
    int asked = c->component;
    c->component = k + 1;
    cagd_value r = evaluate(c, t, f);
    c->component = asked;
    return r;
}

static cagd_value dot(cagd_context *c, const cagd_tree *a, const cagd_tree *b, const frame *f)
{
    cagd_value r = cagd_value_int(0);
    for (int k = 0; k < a->dimension; k++)
        r = cagd_value_add(r, cagd_value_mul(component(c, a, k, f), component(c, b, k, f)));
    return r;
}

/* The component k of a x b. */
static cagd_value cross(cagd_context *c, const cagd_tree *a, const cagd_tree *b, int k, const frame *f)
{
    int i = (k + 1) % 3, j = (k + 2) % 3;
    return cagd_value_sub(cagd_value_mul(component(c, a, i, f), component(c, b, j, f)),
                          cagd_value_mul(component(c, a, j, f), component(c, b, i, f)));
}

/* (a, b, c) = (a x b) . c */
static cagd_value mixed(cagd_context *c, const cagd_tree *t, const frame *f)
{
    cagd_value r = cagd_value_int(0);
    for (int k = 0; k < 3; k++)
        r = cagd_value_add(r, cagd_value_mul(cross(c, t->at[0], t->at[1], k, f), component(c, t->at[2], k, f)));
    return r;
}

static cagd_value of_component(cagd_context *c, const cagd_tree *t, const frame *f)
{
    if (c->component == 0)
        return cagd_fail(c, t, FAULT_UNABLE, "a vector where a number is expected");
    return t->kind == CAGD_POINT ? evaluate(c, t->at[c->component - 1], f)
                                 : cross(c, t->at[0], t->at[1], c->component - 1, f);
}

/* The determinant of the rows from `row` on without the columns used: by its first row (Laplace). */
static cagd_value minor(const cagd_value entry[], int rows, int row, unsigned used)
{
    cagd_value r = cagd_value_int(row == rows);
    for (int k = 0, sign = 1; k < rows && row < rows; k++) {
        if (used >> k & 1)
            continue;
        cagd_value a = entry[row * rows + k];
        if (!cagd_value_is_zero(a)) {
            cagd_value term = cagd_value_mul(a, minor(entry, rows, row + 1, used | 1u << k));
            r = sign > 0 ? cagd_value_add(r, term) : cagd_value_sub(r, term);
        }
        sign = -sign;
    }
    return r;
}

static cagd_value determinant(cagd_context *c, const cagd_tree *t, const frame *f)
{
    cagd_value entry[CAGD_MOST_CHILDREN];
    for (int k = 0; k < t->count; k++)
        entry[k] = evaluate(c, t->at[k], f);
    return region_faults != 0 ? cagd_value_int(0) : minor(entry, t->order, 0, 0);
}

/* An entry of the inverse: the minor without its column and row, with its sign, by the determinant. */
static cagd_value inverse(cagd_context *c, const cagd_tree *t, int row, int column, const frame *f)
{
    cagd_value entry[CAGD_MOST_CHILDREN], rest[CAGD_MOST_CHILDREN];
    int n = cagd_rows(t->dimension), count = 0;
    for (int k = 0; k < n * n; k++)
        entry[k] = component(c, t->at[0], k, f);
    if (region_faults != 0)
        return cagd_value_int(0);
    for (int k = 0; k < n * n; k++)
        if (k / n != column && k % n != row)
            rest[count++] = entry[k];
    cagd_value whole = minor(entry, n, 0, 0), part = minor(rest, n - 1, 0, 0);
    if (is_zero(c, whole))
        return cagd_fail(c, t, FAULT_UNDEFINED, "the inverse of a matrix whose determinant is 0");
    if (!note_divisor(c, whole))
        return cagd_fail(c, t, FAULT_UNABLE, "too many divisors");
    if ((row + column) % 2 != 0)
        part = cagd_value_sub(cagd_value_int(0), part);
    return cagd_value_div(part, whole);
}

/* The entry of a matrix that is asked for: of a product, of one transposed, of an inverse, by its minors. */
static cagd_value of_matrix(cagd_context *c, const cagd_tree *t, const frame *f)
{
    if (c->component == 0 && t->dimension > 0)
        return cagd_fail(c, t, FAULT_UNABLE, "a matrix where a number is expected");
    int k = t->dimension > 0 ? c->component - 1 : 0, columns = cagd_columns(t->dimension);
    int row = k / columns, column = k % columns;
    if (t->kind == CAGD_TRANSPOSED)
        return component(c, t->at[0], column * cagd_columns(t->at[0]->dimension) + row, f);
    if (t->kind == CAGD_INVERSE)
        return inverse(c, t, row, column, f);
    cagd_value sum = cagd_value_int(0);
    for (int m = 0; m < t->order && region_faults == 0; m++) {
        int behind = m * cagd_columns(t->at[1]->dimension) + column;
        sum = cagd_value_add(
            sum, cagd_value_mul(component(c, t->at[0], row * t->order + m, f), component(c, t->at[1], behind, f)));
    }
    return sum;
}

/* ---- powers and the like ------------------------------------------------------------------------------- */

static cagd_value power(cagd_context *c, const cagd_tree *t, const frame *f)
{
    long e;
    cagd_value exponent = evaluate(c, t->at[1], f), r = cagd_value_int(1), base;
    if (t->at[0]->kind == CAGD_NORM && cagd_value_is_whole(exponent, &e) && e % 2 == 0) { /* no root is needed */
        base = dot(c, t->at[0]->at[0], t->at[0]->at[0], f);
        exponent = cagd_value_int(e / 2);
    } else {
        base = evaluate(c, t->at[0], f);
    }
    if (region_faults != 0)
        return r;
    if (!cagd_value_is_whole(exponent, &e) || e > MOST_POWER || e < -MOST_POWER)
        return cagd_fail(c, t->at[1], FAULT_UNABLE, "an exponent is a whole number, at most 1000");
    if (e < 0 && is_zero(c, base))
        return cagd_fail(c, t, FAULT_UNDEFINED, "a division by 0");
    if (e < 0 && !note_divisor(c, base))
        return cagd_fail(c, t, FAULT_UNABLE, "too many divisors");
    for (long m = e < 0 ? -e : e; m > 0; m /= 2) {
        if (m % 2 == 1)
            r = cagd_value_mul(r, base);
        if (m > 1)
            base = cagd_value_mul(base, base);
    }
    return e < 0 ? cagd_value_div(cagd_value_int(1), r) : r;
}

static cagd_value factorial(cagd_context *c, const cagd_tree *t, const frame *f)
{
    long m;
    cagd_value a = evaluate(c, t->at[0], f), r = cagd_value_int(1);
    if (region_faults != 0)
        return r;
    if (!cagd_value_is_whole(a, &m) || m > MOST_FACTORIAL)
        return cagd_fail(c, t, FAULT_UNABLE, "a factorial is of a whole number, at most 1000");
    if (m < 0)
        return cagd_fail(c, t, FAULT_UNDEFINED, "the factorial of a negative number");
    for (long k = 2; k <= m; k++)
        r = cagd_value_mul(r, cagd_value_int(k));
    return r;
}

static cagd_value binomial(cagd_context *c, const cagd_tree *t, const frame *f)
{
    long b;
    cagd_value a = evaluate(c, t->at[0], f), below = evaluate(c, t->at[1], f), r = cagd_value_int(1);
    if (region_faults != 0)
        return r;
    if (!cagd_value_is_whole(below, &b) || b > MOST_FACTORIAL)
        return cagd_fail(c, t, FAULT_UNABLE, "below in a binomial coefficient stands a whole number, at most 1000");
    if (b < 0)
        return cagd_value_int(0);
    for (long k = 0; k < b && !cagd_value_is_zero(r); k++)
        r = cagd_value_div(cagd_value_mul(r, cagd_value_sub(a, cagd_value_int(k))), cagd_value_int(k + 1));
    return r;
}

/* ---- q-numbers ----------------------------------------------------------------------------------------- */

/* The whole number that child k of t is, from 0 to MOST_Q; -1 where it is none. */
static long count_of(cagd_context *c, const cagd_tree *t, int k, const frame *f)
{
    long n = -1;
    cagd_value v = evaluate(c, t->at[k], f);
    if (region_faults == 0 && (!cagd_value_is_whole(v, &n) || n > MOST_Q || n < -MOST_Q))
        cagd_fail(c, t->at[k], FAULT_UNABLE, "q-numbers are of whole numbers, at most 100");
    return n;
}

/* 1 + q + ... + q^(n-1). */
static cagd_value q_number(long n, cagd_value q)
{
    cagd_value sum = cagd_value_int(0);
    for (long k = 0; k < n; k++)
        sum = cagd_value_add(cagd_value_mul(sum, q), cagd_value_int(1));
    return sum;
}

/* The q-number of n, or the q-factorial: polynomials in q, so q = 1 is no exception. */
static cagd_value of_q(cagd_context *c, const cagd_tree *t, const frame *f)
{
    long n = count_of(c, t, 0, f);
    cagd_value q = evaluate(c, t->at[1], f), product = cagd_value_int(1);
    if (region_faults != 0)
        return q;
    if (n < 0)
        return cagd_fail(c, t, FAULT_UNABLE, "a q-number of a negative number");
    if (t->kind == CAGD_Q_NUMBER)
        return q_number(n, q);
    for (long k = 2; k <= n; k++)
        product = cagd_value_mul(product, q_number(k, q));
    return product;
}

/* By the rule [n, k] = [n-1, k-1] + q^k [n-1, k]; 0 for k < 0 and k > n. */
static cagd_value q_binomial(cagd_context *c, const cagd_tree *t, const frame *f)
{
    long n = count_of(c, t, 0, f), k = count_of(c, t, 1, f);
    cagd_value q = evaluate(c, t->at[2], f), row[MOST_Q + 1];
    if (region_faults != 0)
        return q;
    if (n < 0)
        return cagd_fail(c, t, FAULT_UNABLE, "a q-binomial coefficient of a negative number");
    if (k < 0 || k > n)
        return cagd_value_int(0);
    for (long j = 0; j <= k; j++)
        row[j] = cagd_value_int(j == 0);
    for (long m = 1; m <= n && region_faults == 0; m++) {
        cagd_value before = row[0], power = cagd_value_int(1);
        for (long j = 1; j <= k && j <= m; j++) {
            cagd_value above = row[j];
            power = cagd_value_mul(power, q);
            row[j] = cagd_value_add(before, cagd_value_mul(power, above));
            before = above;
        }
    }
    return row[k];
}

/* ---- roots --------------------------------------------------------------------------------------------- */

/* a = s^2 m with a whole m in which no square of a number up to 1000 is left. */
static num_q without_squares(num_q a, num_q *s)
{
    enum { LARGEST_SQUARE = 1000 };
    mpz_t m;
    mpq_t r;
    mpz_init(m), mpq_init(r);
    mpz_mul(m, mpq_numref(a.at), mpq_denref(a.at)); /* p/q = pq/q^2 */
    mpz_set_ui(mpq_numref(r), 1), mpz_set(mpq_denref(r), mpq_denref(a.at));
    for (unsigned long d = 2; d <= LARGEST_SQUARE; d++)
        while (mpz_divisible_ui_p(m, d * d)) {
            mpz_divexact_ui(m, m, d * d);
            mpz_mul_ui(mpq_numref(r), mpq_numref(r), d);
        }
    mpq_canonicalize(r);
    *s = cagd_from_mpq_q(r);
    mpq_set_z(r, m);
    num_q rest = cagd_from_mpq_q(r);
    mpz_clear(m), mpq_clear(r);
    return rest;
}

/* sqrt(a) for a number a > 0 that is no square: a variable near the root of x^2 - m, times a number (tie.h). */
static cagd_value root_of_number(cagd_context *c, const cagd_tree *t, num_q a)
{
    num_q times, m = without_squares(a, &times), c0[3] = {neg_q(m), cagd_from_int_q(0), cagd_from_int_q(1)};
    char key[120];
    if (snprintf(key, sizeof key, "\\sqrt{%s}", to_string_q(m)) >= (int)sizeof key)
        return cagd_fail(c, t, FAULT_UNABLE, "a root of a number that is too long");
    cagd_value x = cagd_value_of_key(c, key, NULL);
    cagd_binding *b = region_faults == 0 ? cagd_binding_of(c, key) : NULL;
    if (b == NULL)
        return x;
    if (!b->has_root)
        cagd_make_root(b, cagd_poly_from_q(3, c0));
    return cagd_value_mul(cagd_value_q(times), x);
}

/* The root that is not negative, if n is even: of a square of a function it is the function or its negative, by its sign. */
static cagd_value root_of(cagd_context *c, const cagd_tree *t, cagd_value a, long n)
{
    if (region_faults != 0)
        return a;
    cagd_value r = a.rational ? cagd_value_q(root_q((int)n, a.q)) : cagd_value_f(cagd_root_f((int)n, a.f));
    if (region_faults != 0) {
        region_faults &= FAULT_MEMORY | FAULT_CROWDED;
        if (region_faults == 0 && n == 2 && a.rational && cagd_sign_q(a.q) > 0 && c->has_roots)
            return root_of_number(c, t, a.q);
        c->met_root = 1;
        return cagd_fail(c, t, FAULT_UNABLE,
                         n % 2 == 0 && a.rational && cagd_sign_q(a.q) < 0
                             ? "the root of a negative number"
                             : "a root that is no rational function: write a name, r^2 = ..., r \\ge 0 in :for:");
    }
    int positive = a.rational || n % 2 == 1 ? 1 : cagd_compare_values(c, r, CAGD_GREATER_OR_EQUAL, cagd_value_int(0));
    if (positive < 0)
        return cagd_fail(c, t, FAULT_UNABLE, "a root whose sign depends on variables");
    return positive ? r : cagd_value_sub(cagd_value_int(0), r);
}

static cagd_value root(cagd_context *c, const cagd_tree *t, const frame *f)
{
    long n;
    cagd_value a = evaluate(c, t->at[0], f), index = evaluate(c, t->at[1], f);
    if (region_faults != 0)
        return a;
    if (!cagd_value_is_whole(index, &n) || n < 1 || n > MOST_POWER)
        return cagd_fail(c, t, FAULT_UNABLE, "a root is the n-th for a whole number n");
    return root_of(c, t, a, n);
}

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
    if (c->scope->zero_over_zero && is_zero(c, b) && (is_zero(c, a) || cagd_equal_here(c, a, cagd_value_int(0))))
        return cagd_value_int(0);
    if (c->scope->zero_over_zero && c->way == NULL && !b.rational && !cagd_divides(c, b))
        return cagd_fail(c, t, FAULT_UNABLE, "a divisor that can be 0");
    if (!note_divisor(c, b))
        return cagd_fail(c, t, FAULT_UNABLE, "too many divisors");
    return is_zero(c, b) ? cagd_fail(c, t, FAULT_UNDEFINED, "a division by 0") : cagd_value_div(a, b);
}

/* With 0/0 = 0 said, a factor that is divided by 0 is not asked for beside another that is 0. */
static cagd_value product(cagd_context *c, const cagd_tree *t, const frame *f)
{
    cagd_value r = cagd_value_int(1);
    unsigned faults = 0;
    const char *trouble = c->trouble;
    for (int k = 0; k < t->count; k++) {
        cagd_value x = evaluate(c, t->at[k], f);
        if (region_faults == FAULT_UNDEFINED && c->scope->zero_over_zero) {
            faults |= region_faults;
            region_faults = 0;
            continue;
        }
        if (region_faults != 0)
            return x;
        r = cagd_value_mul(r, x);
    }
    if (faults != 0 && cagd_equal_here(c, r, cagd_value_int(0)))
        c->trouble = trouble;
    else
        region_faults |= faults;
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
        return name(c, t, f);
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
        return power(c, t, f);
    case CAGD_FACTORIAL:
        return factorial(c, t, f);
    case CAGD_BINOMIAL:
        return binomial(c, t, f);
    case CAGD_Q_NUMBER:
    case CAGD_Q_FACTORIAL:
        return of_q(c, t, f);
    case CAGD_Q_BINOMIAL:
        return q_binomial(c, t, f);
    case CAGD_ROOT:
        return root(c, t, f);
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
        return derivative(c, t, f);
    case CAGD_INTEGRAL:
        return integral(c, t, f);
    case CAGD_AT:
        return at_a_place(c, t, f);
    case CAGD_CASES:
        return cases(c, t, f);
    case CAGD_POINT:
    case CAGD_CROSS:
        return of_component(c, t, f);
    case CAGD_MATRIX_PRODUCT:
    case CAGD_TRANSPOSED:
    case CAGD_INVERSE:
        return of_matrix(c, t, f);
    case CAGD_COMPONENT:
        return component(c, t->at[0], t->order, f);
    case CAGD_DOT:
        return dot(c, t->at[0], t->at[1], f);
    case CAGD_MIXED:
        return mixed(c, t, f);
    case CAGD_DETERMINANT:
        return determinant(c, t, f);
    case CAGD_COSINE:
    case CAGD_SINE:
        return cagd_circular(c, t, f);
    case CAGD_NORM:
        return root_of(c, t, dot(c, t->at[0], t->at[0], f), 2);
    default:
        return cagd_fail(c, t, FAULT_UNABLE, "a relation is no value");
    }
}

cagd_value cagd_evaluate(cagd_context *c, const cagd_tree *t) { return evaluate(c, t, NULL); }
cagd_value cagd_evaluate_in(cagd_context *c, const cagd_tree *t, const cagd_frame *f) { return evaluate(c, t, f); }
int cagd_truth(cagd_context *c, const cagd_tree *t) { return truth(c, t, NULL); }
int cagd_truth_in(cagd_context *c, const cagd_tree *t, const cagd_frame *f) { return truth(c, t, f); }
