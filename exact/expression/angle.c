#include "exact/expression/angle.h"

#include "exact/expression/angle_bounds.h"
#include "exact/words.h"

#include <stdio.h>
#include <string.h>

enum { MOST_MULTIPLE = 1000, DEEPEST = 12, TWELFTHS = 12, MOST_MET = 64 };

/* The cosine and the sine of an angle. */
struct turn {
    cagd_value cosine, sine;
};

static const struct turn *none(void)
{
    static _Thread_local struct turn zero;
    zero = (struct turn){cagd_value_int(1), cagd_value_int(0)};
    return &zero;
}

static struct turn turned(struct turn a, struct turn b)
{
    return (struct turn){cagd_value_sub(cagd_value_mul(a.cosine, b.cosine), cagd_value_mul(a.sine, b.sine)),
                         cagd_value_add(cagd_value_mul(a.sine, b.cosine), cagd_value_mul(a.cosine, b.sine))};
}

static struct turn several(struct turn a, long times)
{
    struct turn sum = *none();
    if (times < 0)
        a.sine = cagd_value_sub(cagd_value_int(0), a.sine);
    for (long k = 0; k < (times < 0 ? -times : times); k++)
        sum = turned(sum, a);
    return sum;
}

/* So many times an angle; or, of what is a number, so many times \pi times it: t is 2/\pi of the angle \pi t/2. */
struct amount {
    num_q times;
    int of_pi;
};

static int is_pi(const cagd_scope *scope, const cagd_tree *t)
{
    return t->kind == CAGD_NAME && t->count == 0 && strcmp(t->head, CAGD_PI) == 0 &&
           cagd_defined(scope, t->head) == NULL && cagd_declared(scope, t->head) == NULL;
}

static void refuse(cagd_context *c, const cagd_tree *t)
{
    cagd_fail(c, t, FAULT_UNABLE, "an angle is a sum of names, of halves of names, and of multiples of \\pi/12");
}

/* ---- multiples of pi ----------------------------------------------------------------------------------- */

/* The square root of a whole number. */
static cagd_value root_of(cagd_context *c, const cagd_tree *t, long m)
{
    cagd_tree *root = cagd_tree_new(CAGD_ROOT, t->from, t->to, 2);
    const cagd_tree *number = cagd_tree_number(m, t->from, t->to), *two = cagd_tree_number(2, t->from, t->to);
    if (root == NULL || number == NULL || two == NULL)
        return cagd_value_int(0);
    root->at[0] = number, root->at[1] = two;
    return cagd_evaluate(c, root);
}

/* m pi/12 = m (pi/3 - pi/4). */
static struct turn turned_by_pi(cagd_context *c, const cagd_tree *t, num_q times)
{
    long m;
    cagd_value half = cagd_value_q(from_ratio_q(1, 2)), zero = cagd_value_int(0), one = cagd_value_int(1);
    if (!cagd_value_is_whole(cagd_value_q(mul_q(times, from_int_q(TWELFTHS))), &m) || m > MOST_MULTIPLE * TWELFTHS ||
        m < -MOST_MULTIPLE * TWELFTHS) {
        refuse(c, t);
        return *none();
    }
    m = (m % (2 * TWELFTHS) + 2 * TWELFTHS) % (2 * TWELFTHS);
    struct turn quarter = {zero, one}, sum = several(quarter, m / 6);
    m %= 6;
    struct turn third = {half, zero}, eighth = {zero, zero};
    if (m % 3 != 0)
        third.sine = cagd_value_mul(half, root_of(c, t, 3));
    if (m % 2 != 0)
        eighth.cosine = eighth.sine = cagd_value_mul(half, root_of(c, t, 2));
    if (m == 3)
        return turned(sum, eighth);
    if (m % 2 == 0)
        return m == 0 ? sum : turned(sum, m == 4 ? third : turned(quarter, several(third, -1)));
    return turned(sum,
                  m == 1 ? turned(third, several(eighth, -1)) : turned(eighth, turned(quarter, several(third, -1))));
}

int cagd_multiple_of_pi(const cagd_scope *scope, const cagd_tree *t, num_q *times)
{
    num_q one;
    if (is_pi(scope, t)) {
        *times = from_int_q(1);
        return 1;
    }
    switch (t->kind) {
    case CAGD_NUMBER:
        *times = t->number;
        return cagd_is_zero_q(t->number);
    case CAGD_NEGATIVE:
        if (!cagd_multiple_of_pi(scope, t->at[0], times))
            return 0;
        *times = neg_q(*times);
        return 1;
    case CAGD_SUM:
        *times = from_int_q(0);
        for (int k = 0; k < t->count; k++) {
            if (!cagd_multiple_of_pi(scope, t->at[k], &one))
                return 0;
            *times = add_q(*times, one);
        }
        return 1;
    case CAGD_PRODUCT:
    case CAGD_QUOTIENT: {
        int by = t->kind == CAGD_QUOTIENT;
        if (t->count != 2 || t->at[by]->kind != CAGD_NUMBER || !cagd_multiple_of_pi(scope, t->at[!by], times) ||
            (by && cagd_is_zero_q(t->at[1]->number)))
            return 0;
        *times = by ? div_q(*times, t->at[1]->number) : mul_q(*times, t->at[0]->number);
        return 1;
    }
    default:
        return 0;
    }
}

/* ---- one angle ----------------------------------------------------------------------------------------- */

/* Where the angle is the one from which x counts: so many times a quarter of the way around before it. */
static int text_of_base(const cagd_context *c, const char *angle, int quarters, char text[], int room)
{
    static const char *const by_half[] = {"", "-\\pi/2", "-\\pi", "-3\\pi/2", "-2\\pi"}, *const by_whole[] = {
                                                                                             "", "-\\pi", "-2\\pi",
                                                                                             "-3\\pi", "-4\\pi"};
    const char *behind = (c->whole_angles ? by_half : by_whole)[quarters];
    return snprintf(text, (size_t)room, quarters == 0 ? "%s%s" : "(%s%s)", angle, behind) < room;
}

static int key_of_turned(const cagd_context *c, const char *angle, int quarters, char key[], int room)
{
    char text[112];
    return text_of_base(c, angle, quarters, text, sizeof text) &&
           snprintf(key, (size_t)room, "\\tan(%s/%d)", text, cagd_share_of_angle(c)) < room;
}

int cagd_key_of_tangent(const cagd_context *c, const char *angle, char key[], int room)
{
    return key_of_turned(c, angle, 0, key, room);
}

/* The name of the cosine of 2 phi, which is -1 where there is no x. */
static int key_of_cosine(const cagd_context *c, const char *angle, int quarters, char key[], int room)
{
    char text[112];
    return text_of_base(c, angle, quarters, text, sizeof text) &&
           snprintf(key, (size_t)room, c->whole_angles ? "\\cos(%s)" : "\\cos(%s/2)", text) < room;
}

/* ---- sine and cosine ------------------------------------------------------------------------------------- */

/* The angle without x is looked at apart, by the name of its cosine. */
static void set_apart(cagd_context *c, const char *cosine)
{
    if (c->aparts == CAGD_MOST_APART)
        region_faults |= FAULT_UNABLE;
    else
        c->apart[c->aparts++] =
            (cagd_apart){{cagd_text_of(cosine, (int)strlen(cosine))}, {NULL}, {cagd_from_int_q(-1)}, 1};
}

static struct turn of_tangent(cagd_value x)
{
    cagd_value square = cagd_value_mul(x, x), one = cagd_value_int(1), below = cagd_value_add(one, square);
    return (struct turn){cagd_value_div(cagd_value_sub(one, square), below),
                         cagd_value_div(cagd_value_add(x, x), below)};
}

static struct turn turned_by_quarters(struct turn a, int quarters)
{
    if (quarters == 0)
        return a;
    struct turn quarter = {cagd_value_int(0), cagd_value_int(1)};
    return turned(several(quarter, quarters), a);
}

/* So many times \pi, where the tree stands; NULL without memory. */
static const cagd_tree *multiple_of_pi(num_q times, const cagd_tree *place)
{
    cagd_tree *number = cagd_tree_number(0, place->from, place->to),
              *pi = cagd_tree_new(CAGD_NAME, place->from, place->to, 0),
              *t = cagd_tree_new(CAGD_PRODUCT, place->from, place->to, 2);
    if (number == NULL || pi == NULL || t == NULL)
        return NULL;
    number->number = times, pi->head = CAGD_PI;
    t->at[0] = number, t->at[1] = pi;
    return t;
}

/* The bound of a number, times \pi; where it is no number, the bound itself, which is no multiple of \pi then. */
static const cagd_tree *times_pi(cagd_context *c, const cagd_tree *bound)
{
    cagd_value v = bound != NULL ? cagd_evaluate(c, bound) : cagd_value_int(0);
    if (bound == NULL || region_faults != 0 || !v.rational)
        return bound;
    const cagd_tree *t = multiple_of_pi(v.q, bound);
    return t != NULL ? t : bound;
}

num_q cagd_below_pi(void) { return from_ratio_q(103993, 33102); }
num_q cagd_above_pi(void) { return from_ratio_q(104348, 33215); }

static int has_name(const cagd_tree *t)
{
    int has = t->kind == CAGD_NAME;
    for (int k = 0; k < t->count && !has; k++)
        has = has_name(t->at[k]);
    return has;
}

/* A multiple of \pi that is no less than the end (up), or no greater: the end itself, or the next multiple of \pi/12 beyond a number; 0 where it is
 * neither. */
static int multiple_beyond(cagd_context *c, const cagd_tree *end, int up, num_q *times)
{
    if (end == NULL || cagd_multiple_of_pi(c->scope, end, times))
        return end != NULL;
    cagd_value r = has_name(end) ? (cagd_value){0} : cagd_evaluate(c, end);
    if (region_faults != 0 || !r.rational)
        return 0;
    num_q twelfths = mul_q(up ? neg_q(r.q) : r.q, from_int_q(TWELFTHS)); /* over \pi, and rounded away */
    twelfths = cagd_floor_q(div_q(twelfths, cagd_sign_q(twelfths) > 0 ? cagd_above_pi() : cagd_below_pi()));
    *times = div_q(up ? neg_q(twelfths) : twelfths, from_int_q(TWELFTHS));
    return 1;
}

/* The declaration with multiples of \pi for bounds, which are no tighter; without bounds where there are none. */
static cagd_variable with_wider_bounds(cagd_context *c, const cagd_variable *v)
{
    cagd_variable wider = *v;
    const cagd_tree *end[2] = {v->low, v->high};
    for (int k = 0; k < 2; k++) {
        num_q times;
        end[k] = multiple_beyond(c, end[k], k, &times) ? multiple_of_pi(times, end[k]) : NULL;
    }
    int known = end[0] != NULL && end[1] != NULL;
    wider.low = known ? end[0] : NULL, wider.high = known ? end[1] : NULL;
    wider.low_open &= known, wider.high_open &= known;
    return wider;
}

/* Whether the name is an angle elsewhere, and \pi times it here; or the other way. */
static int is_other_angle(const cagd_context *c, const char *key, int of_pi)
{
    for (int k = 0; k < c->count; k++)
        if (c->binding[k].angle != NULL && strcmp(c->binding[k].angle, key) == 0 && c->binding[k].of_pi != of_pi)
            return 1;
    return 0;
}

/* 2 phi for the angle of that name, or \pi times it, declared by v. */
static struct turn twice_phi(cagd_context *c, const cagd_tree *t, const char *name, int of_pi, const cagd_variable *v)
{
    char key[104], tangent[140], cosine[140];
    int has_apart;
    const cagd_binding *number = cagd_binding_of(c, name);
    if (is_other_angle(c, name, of_pi) || (number != NULL && number->is_letter)) {
        cagd_fail(c, t, FAULT_UNABLE,
                  number != NULL ? "an angle at a place that is a number" : "an angle that is \\pi times itself, too");
        return *none();
    }
    c->mixes_angles |= number != NULL;
    snprintf(key, sizeof key, "%s%s", of_pi ? "\\pi " : "", name);
    cagd_variable turned = *v;
    if (of_pi) {
        turned.low = times_pi(c, v->low), turned.high = times_pi(c, v->high);
        v = &turned;
    }
    cagd_way_around w = cagd_way_of_angle(c, v);
    if (!w.known && !of_pi) { /* its bounds are those of a number */
        c->mixes_angles = 1;
        cagd_value_of_key(c, name, v);
        turned = with_wider_bounds(c, v);
        v = &turned;
        w = cagd_way_of_angle(c, v);
    }
    if (!key_of_turned(c, key, w.quarters, tangent, sizeof tangent) ||
        !key_of_cosine(c, key, w.quarters, cosine, sizeof cosine))
        return *none();
    c->angles++;
    cagd_binding *apart = cagd_binding_of(c, cosine);
    if (apart != NULL) /* where there is no x */
        apart->angle = cagd_text_of(name, (int)strlen(name)), apart->of_pi = of_pi;
    if (apart != NULL)
        return turned_by_quarters((struct turn){cagd_value_int(-1), cagd_value_int(0)}, w.quarters);
    cagd_value x = cagd_value_of_key(c, tangent, NULL);
    cagd_binding *b = region_faults == 0 ? cagd_binding_of(c, tangent) : NULL;
    if (b != NULL && b->angle == NULL) {
        b->angle = cagd_text_of(name, (int)strlen(name)), b->turned = w.quarters, b->of_pi = of_pi;
        if (!cagd_bound_angle(c, v, b, &w, &has_apart))
            cagd_fail(c, t, FAULT_UNABLE, "bounds of an angle that are no multiples of \\pi/12");
        else if (has_apart)
            set_apart(c, cosine);
    }
    return turned_by_quarters(of_tangent(x), w.quarters);
}

/* ---- sums of angles ------------------------------------------------------------------------------------ */

static void add_angle(cagd_context *c, const cagd_tree *t, struct amount much, const cagd_frame *f, struct turn *sum);

/* What the letter stands for, if it is an angle. */
static const struct cagd_angle *angle_of_letter(cagd_context *c, const cagd_tree *t, const cagd_frame *f,
                                                int *is_letter)
{
    *is_letter = 0;
    for (; f != NULL && t->count == 0; f = f->next)
        if (strcmp(f->head, t->head) == 0) {
            *is_letter = 1;
            return f->value.angle;
        }
    const cagd_binding *b = t->count == 0 ? cagd_binding_of(c, t->head) : NULL;
    return b != NULL ? b->value.angle : NULL;
}

/* So many times a whole, or half, of the angle of that name. */
static void add_multiple(cagd_context *c, const cagd_tree *t, num_q times, struct turn unit, struct turn *sum)
{
    long units;
    if (!cagd_value_is_whole(cagd_value_q(mul_q(times, from_ratio_q(cagd_share_of_angle(c), 2))), &units) ||
        units > MOST_MULTIPLE || units < -MOST_MULTIPLE)
        refuse(c, t);
    else if (region_faults == 0)
        *sum = turned(*sum, several(unit, units));
}

/* What stands for the letter t.  In it the letter is what it was outside, a name of the page for instance. */
static void add_argument(cagd_context *c, const cagd_tree *t, struct amount much, const struct cagd_angle *a,
                         struct turn *sum)
{
    const cagd_binding *b = cagd_binding_of(c, t->head);
    int own = b != NULL && b->value.angle == a ? (int)(b - c->binding) : -1;
    const char *key = own >= 0 ? b->key : NULL;
    if (own >= 0)
        c->binding[own].key = "";
    add_angle(c, a->tree, much, a->frame, sum);
    if (own >= 0)
        c->binding[own].key = key;
    if (!a->tangent.rational && much.of_pi)
        cagd_fail(c, t, FAULT_UNABLE,
                  "a derivative by what is a number, with \\pi in an angle: it has \\pi as a factor");
    else if (!a->tangent.rational)
        add_multiple(c, t, much.times, of_tangent(a->tangent), sum);
}

static void add_named(cagd_context *c, const cagd_tree *t, struct amount much, const cagd_frame *f, struct turn *sum)
{
    char key[96];
    int is_letter;
    const struct cagd_angle *a = angle_of_letter(c, t, f, &is_letter);
    if (a != NULL) {
        add_argument(c, t, much, a, sum);
        return;
    }
    if (!is_letter && !much.of_pi && is_pi(c->scope, t)) {
        *sum = turned(*sum, turned_by_pi(c, t, much.times));
        return;
    }
    const cagd_variable any = {.head = t->head};
    const cagd_variable *v = is_letter ? NULL : cagd_declaration_of(c, t, f, key, sizeof key);
    if (v == NULL && !is_letter && t->count == 0) /* a letter of definitions alone: any angle */
        v = &any;
    if (v == NULL)
        refuse(c, t);
    else if (region_faults == 0)
        add_multiple(c, t, much.times, twice_phi(c, t, key, much.of_pi, v), sum);
}

/* A name without arguments that is defined: what it is defined to be. */
static void add_defined(cagd_context *c, const cagd_tree *t, struct amount much, const cagd_frame *f, struct turn *sum)
{
    const cagd_definition *d = cagd_defined(c->scope, t->head);
    cagd_value value[CAGD_MOST_CHILDREN];
    cagd_frame room[CAGD_MOST_CHILDREN];
    const cagd_frame *inner;
    if (t->order > 0 || t->times != NULL || c->depth >= MOST_MULTIPLE) {
        refuse(c, t);
        return;
    }
    cagd_arguments_of(c, t, d, f, value);
    const cagd_tree *body = region_faults == 0 ? cagd_body_of(c, t, value, room, &inner) : NULL;
    if (region_faults == 0 && body == NULL)
        refuse(c, t);
    c->depth++;
    if (region_faults == 0)
        add_angle(c, body, much, inner, sum);
    c->depth--;
}

/* The factor but the last times \pi, and the last: \pi t/2.  A last factor \pi is an angle by itself. */
static void add_product(cagd_context *c, const cagd_tree *t, struct amount much, const cagd_frame *f, struct turn *sum)
{
    num_q of_pi;
    for (int k = 0; k + 1 < t->count && region_faults == 0; k++) {
        if (!much.of_pi && cagd_multiple_of_pi(c->scope, t->at[k], &of_pi) && cagd_sign_q(of_pi) != 0) {
            much.times = mul_q(much.times, of_pi), much.of_pi = 1;
            continue;
        }
        cagd_value factor = cagd_evaluate_in(c, t->at[k], f);
        if (region_faults == 0 && factor.rational)
            much.times = mul_q(much.times, factor.q);
        else
            refuse(c, t);
    }
    add_angle(c, t->at[t->count - 1], much, f, sum);
}

/* The angle t, so many times, is added to *sum. */
static void add_angle(cagd_context *c, const cagd_tree *t, struct amount much, const cagd_frame *f, struct turn *sum)
{
    int is_letter = 0;
    if (region_faults != 0)
        return;
    if (t->kind == CAGD_SUM) {
        for (int k = 0; k < t->count; k++)
            add_angle(c, t->at[k], much, f, sum);
    } else if (t->kind == CAGD_NEGATIVE) {
        much.times = neg_q(much.times);
        add_angle(c, t->at[0], much, f, sum);
    } else if (t->kind == CAGD_NUMBER && (much.of_pi || cagd_is_zero_q(t->number))) {
        *sum = turned(*sum, turned_by_pi(c, t, mul_q(much.times, t->number)));
    } else if (t->kind == CAGD_QUOTIENT) {
        cagd_value divisor = cagd_evaluate_in(c, t->at[1], f);
        if (region_faults == 0 && (!divisor.rational || cagd_sign_q(divisor.q) == 0)) {
            refuse(c, t);
        } else if (region_faults == 0) {
            much.times = div_q(much.times, divisor.q);
            add_angle(c, t->at[0], much, f, sum);
        }
    } else if (t->kind == CAGD_PRODUCT && t->count > 0) { /* 2 j \pi */
        add_product(c, t, much, f, sum);
    } else if (t->kind == CAGD_NAME &&
               (angle_of_letter(c, t, f, &is_letter) != NULL || is_letter || cagd_defined(c->scope, t->head) == NULL)) {
        add_named(c, t, much, f, sum);
    } else if (t->kind == CAGD_NAME) {
        add_defined(c, t, much, f, sum);
    } else {
        refuse(c, t);
    }
}

cagd_value cagd_circular(cagd_context *c, const cagd_tree *t, const cagd_frame *f)
{
    struct turn sum = *none();
    add_angle(c, t->at[0], (struct amount){from_int_q(1), 0}, f, &sum);
    return t->kind == CAGD_COSINE ? sum.cosine : sum.sine;
}

/* ---- where angles are ---------------------------------------------------------------------------------- */

static int is_circular(const cagd_tree *t) { return t->kind == CAGD_SINE || t->kind == CAGD_COSINE; }

/* Multiples of pi are none. */
static int has_quotient(const cagd_scope *scope, const cagd_tree *t)
{
    num_q times;
    if (cagd_multiple_of_pi(scope, t, &times))
        return 0;
    if (t->kind == CAGD_QUOTIENT || (t->kind == CAGD_NUMBER && !cagd_is_whole_q(t->number)))
        return 1;
    for (int k = 0; k < t->count; k++)
        if (has_quotient(scope, t->at[k]) || (cagd_multiple_of_pi(scope, t->at[k], &times) && !cagd_is_whole_q(times) &&
                                              t->kind == CAGD_PRODUCT)) /* \frac{\pi}{2} t */
            return 1;
    return 0;
}

static int has_circular(const cagd_tree *t)
{
    if (is_circular(t))
        return 1;
    for (int k = 0; k < t->count; k++)
        if (has_circular(t->at[k]))
            return 1;
    return 0;
}

/* What a walk through a formula and the definitions that it uses has met. */
struct walk {
    const cagd_scope *scope;
    int count;
    const char *met[MOST_MET];
};

/* Whether halves of angles are in the formula, in an argument, which may be an angle, or in what it calls. */
static int meets_half(struct walk *w, const cagd_tree *t)
{
    if (is_circular(t) && has_quotient(w->scope, t->at[0]))
        return 1;
    for (int k = 0; k < t->count; k++)
        if ((t->kind == CAGD_NAME && k >= t->lower + t->upper && has_quotient(w->scope, t->at[k])) ||
            meets_half(w, t->at[k]))
            return 1;
    if (t->kind != CAGD_NAME || cagd_defined(w->scope, t->head) == NULL)
        return 0;
    for (int k = 0; k < w->count; k++)
        if (strcmp(w->met[k], t->head) == 0)
            return 0;
    if (w->count == MOST_MET)
        return 1; /* as if there were: that is the finer of both */
    w->met[w->count++] = t->head;
    for (const cagd_definition *d = w->scope->definitions; d != NULL; d = d->next)
        if (strcmp(d->left->head, t->head) == 0 &&
            (meets_half(w, d->body) || (d->left->count == 0 && has_quotient(w->scope, d->body))))
            return 1;
    return 0;
}

int cagd_has_half_angles(const cagd_scope *scope, const cagd_tree *statement)
{
    struct walk w = {.scope = scope};
    int has = meets_half(&w, statement);
    for (int k = 0; k < scope->condition_count && !has; k++)
        has = meets_half(&w, scope->conditions[k]);
    return has;
}

static int is_angle_in(const cagd_scope *scope, const cagd_tree *t, const char *letter, int depth);

static int is_angle_argument(const cagd_scope *scope, const char *head, int k, int depth)
{
    int is = 0;
    for (const cagd_definition *d = scope->definitions; d != NULL; d = d->next) {
        if (strcmp(d->left->head, head) != 0)
            continue;
        if (k >= d->left->count || k < d->left->lower + d->left->upper || d->left->at[k]->kind != CAGD_NAME ||
            cagd_same_index(d->left, k) >= 0)
            return 0;
        is |= is_angle_in(scope, d->body, d->left->at[k]->head, depth + 1);
    }
    return is;
}

static int is_angle_in(const cagd_scope *scope, const cagd_tree *t, const char *letter, int depth)
{
    if (depth > DEEPEST)
        return 0;
    if (is_circular(t) && cagd_tree_has(t->at[0], letter))
        return 1;
    const cagd_definition *d = t->kind == CAGD_NAME ? cagd_defined(scope, t->head) : NULL;
    if (d != NULL)
        for (int k = d->left->lower + d->left->upper; k < d->left->count; k++) {
            const cagd_tree *argument = k < t->count ? t->at[k] : d->left->at[k];
            if (cagd_tree_has(argument, letter) && is_angle_argument(scope, t->head, k, depth))
                return 1;
        }
    if (d != NULL && !cagd_tree_has(d->left, letter) && is_angle_in(scope, d->body, letter, depth + 1))
        return 1; /* the body has the letter itself */
    for (int k = 0; k < t->count; k++)
        if (is_angle_in(scope, t->at[k], letter, depth))
            return 1;
    return 0;
}

/* Whether there are sines and cosines in the definitions: most have none. */
static int knows_angles(cagd_context *c)
{
    enum { NOT_KNOWN, NO, YES };
    if (c->knows_angles == NOT_KNOWN) {
        c->knows_angles = NO;
        for (const cagd_definition *d = c->scope->definitions; d != NULL; d = d->next)
            if (has_circular(d->body))
                c->knows_angles = YES;
    }
    return c->knows_angles == YES;
}

int cagd_is_angle_argument(cagd_context *c, const cagd_definition *d, int k)
{
    return knows_angles(c) && is_angle_argument(c->scope, d->left->head, k, 0);
}

int cagd_is_angle_in(cagd_context *c, const cagd_tree *t, const char *letter)
{
    return (has_circular(t) || knows_angles(c)) && is_angle_in(c->scope, t, letter, 0);
}

/* ---- derivatives --------------------------------------------------------------------------------------- */

num_f cagd_by_angle_f(const cagd_context *c, num_f g, num_f x)
{
    num_f speed = div_f(add_f(from_int_f(1), mul_f(x, x)), from_int_f(cagd_share_of_angle(c)));
    return mul_f(derivative_f(g, x), speed);
}
