#include "exact/expression/order.h"

#include "exact/decide/simplex.h"
#include "exact/expression/cell.h"
#include "exact/words.h"

#include <string.h>

/* Coordinates of the cell: the variable of every name that has none is a form in those of increments. */
struct coordinates {
    int count;
    cagd_side_of_box side[CAGD_MOST_UNKNOWNS]; /* of binding of[k], or of the increment that stands for it */
    int of[CAGD_MOST_UNKNOWNS];
    num_f by[CAGD_MOST_UNKNOWNS]; /* the name by the coordinates                                    */
    num_f p;                      /* what is asked for, likewise                                    */
    int is_increment[CAGD_MOST_UNKNOWNS];
    cagd_limit limit[CAGD_MOST_LIMITS]; /* in the coordinates */
    int limits;
    int leaves_out; /* some limit is not among the bounds: their box is larger than the cell */
};

static cagd_side_of_box side_of(const cagd_binding *b)
{
    return (cagd_side_of_box){b->value.f, b->has_low, b->has_high, b->low_open, b->high_open, b->low, b->high};
}

/* The limit k follows from the others. */
static int follows(cagd_context *c, int k)
{
    cagd_limit one = c->limit[k];
    c->limit[k] = c->limit[--c->limits];
    c->memos = 0;
    unsigned signs = cagd_signs_of_form(c, one.form);
    if (!(signs & CAGD_CAN_BE_NEGATIVE) && !(one.strict && (signs & CAGD_CAN_BE_ZERO)))
        return 1;
    c->limits++;
    c->limit[c->limits - 1] = c->limit[k];
    c->limit[k] = one;
    return 0;
}

static void add(cagd_context *c, num_f form, int strict)
{
    cagd_limit *l = &c->limit[c->limits];
    *l = (cagd_limit){.form = form, .strict = strict};
    c->limits += cagd_linear_f(form, &l->at);
}

/* Bounds of names that are tied to others are limits like others, too. */
static void bounds_to_limits(cagd_context *c)
{
    int limits = c->limits;
    for (int k = 0; k < c->count; k++) {
        cagd_binding *b = &c->binding[k];
        int tied = 0;
        for (int m = 0; m < limits && b->unknown; m++)
            tied |= cagd_degree_f(c->limit[m].form, b->value.f) > 0;
        if (!tied || c->limits + 2 > CAGD_MOST_LIMITS)
            continue;
        if (b->has_low)
            add(c, sub_f(b->value.f, from_rational_f(b->low)), b->low_open);
        if (b->has_high)
            add(c, sub_f(from_rational_f(b->high), b->value.f), b->high_open);
        b->has_low = b->has_high = 0;
    }
}

/* The limits of which none follows from the others. */
static void begin(const cagd_context *c, num_f p, struct coordinates *x)
{
    cagd_context *copy = region_bytes(sizeof *copy);
    *x = (struct coordinates){.p = p};
    if (copy == NULL)
        return;
    *copy = *c;
    bounds_to_limits(copy);
    for (int k = 0; k < copy->count; k++)
        if (copy->binding[k].unknown) {
            x->of[x->count] = k;
            x->by[x->count] = copy->binding[k].value.f;
            x->side[x->count++] = side_of(&copy->binding[k]);
        }
    for (int k = copy->limits - 1; k >= 0; k--)
        follows(copy, k);
    memcpy(x->limit, copy->limit, sizeof x->limit);
    x->limits = copy->limits;
}

static void replace(struct coordinates *x, int k, num_f value)
{
    num_f variable = x->side[k].variable;
    x->p = substitute_f(x->p, variable, value);
    for (int m = 0; m < x->count; m++)
        x->by[m] = substitute_f(x->by[m], variable, value);
    for (int m = 0; m < x->limits; m++)
        x->limit[m].form = substitute_f(x->limit[m].form, variable, value);
}

/* The coordinate in the form that may become an increment: without bounds, or else with bounds that become limits; -1 where there is none.
 * An increment stays what it is. */
static int pivot_of(const struct coordinates *x, num_f form)
{
    int best = -1, best_bounds = 3;
    for (int k = 0; k < x->count; k++) {
        int bounds = x->side[k].has_low + x->side[k].has_high;
        if (!x->is_increment[k] && bounds < best_bounds && cagd_degree_f(form, x->side[k].variable) == 1)
            best = k, best_bounds = bounds;
    }
    return best;
}

/* The names in the form. */
static int names_in(const struct coordinates *x, num_f form)
{
    int count = 0;
    for (int k = 0; k < x->count; k++)
        count += cagd_degree_f(form, x->side[k].variable) > 0;
    return count;
}

static void add_limit(struct coordinates *x, num_f form, int strict)
{
    if (x->limits == CAGD_MOST_LIMITS)
        x->leaves_out = 1;
    else
        x->limit[x->limits++] = (cagd_limit){.form = form, .strict = strict};
}

/* form > 0 becomes y > 0 for the new coordinate y = form, in the place of x_k; its variable is that of x_k. */
static void take(struct coordinates *x, int k, cagd_limit limit)
{
    num_f variable = x->side[k].variable;
    num_f p = cagd_coefficient_f(limit.form, variable, 1);
    cagd_side_of_box before = x->side[k];
    x->is_increment[k] = 1;
    num_f value = div_f(sub_f(variable, sub_f(limit.form, mul_f(p, variable))), p);
    x->side[k] = (cagd_side_of_box){.variable = variable, .has_low = 1, .low_open = limit.strict, .low = from_int_q(0)};
    replace(x, k, value);
    if (before.has_low)
        add_limit(x, sub_f(value, from_rational_f(before.low)), before.low_open);
    if (before.has_high)
        add_limit(x, sub_f(from_rational_f(before.high), value), before.high_open);
}

/* a x + b > 0 for a single coordinate x is a bound of it.  There is no other one on that side: of the two one would follow. */
static void bound(struct coordinates *x, cagd_limit limit)
{
    num_q a = from_int_q(0), b = a;
    int k = 0;
    while (cagd_degree_f(limit.form, x->side[k].variable) < 1)
        k++;
    cagd_side_of_box *s = &x->side[k];
    is_constant_f(cagd_coefficient_f(limit.form, s->variable, 1), &a);
    is_constant_f(cagd_coefficient_f(limit.form, s->variable, 0), &b);
    num_q r = neg_q(div_q(b, a));
    if (cagd_sign_q(a) > 0)
        s->has_low = 1, s->low = r, s->low_open = limit.strict;
    else
        s->has_high = 1, s->high = r, s->high_open = limit.strict;
}

/* Limits of one name first: they are bounds.  Of the others each makes an increment. */
static void find_coordinates(const cagd_context *c, num_f p, struct coordinates *x)
{
    begin(c, p, x);
    int is_bound[CAGD_MOST_LIMITS] = {0};
    for (int k = 0; k < x->limits; k++) {
        is_bound[k] = names_in(x, x->limit[k].form) == 1;
        if (is_bound[k])
            bound(x, x->limit[k]);
    }
    for (int next = 0; next < x->limits && region_faults == 0; next++) {
        cagd_limit limit = x->limit[next];
        int names = is_bound[next] ? 0 : names_in(x, limit.form);
        int k = names > 1 ? pivot_of(x, limit.form) : -1;
        if (names == 1)
            bound(x, limit);
        else if (k >= 0)
            take(x, k, limit);
        else
            x->leaves_out |= names > 1;
    }
}

/* By the bounds of single names alone. */
static int is_positive_in_bounds(const cagd_context *c, num_f p, int strict)
{
    cagd_side_of_box side[CAGD_MOST_UNKNOWNS];
    num_q point[CAGD_MOST_UNKNOWNS];
    int count = 0, rational;
    for (int k = 0; k < c->count; k++)
        if (c->binding[k].unknown)
            side[count++] = side_of(&c->binding[k]);
    return cagd_positive_in_box(p, strict, count, side, point, &rational) == CAGD_HOLDS;
}

cagd_answer cagd_positive_in_cell(const cagd_context *c, num_f p, int strict, num_q value[], int *rational)
{
    struct coordinates *x = region_bytes(sizeof *x);
    num_q point[CAGD_MOST_UNKNOWNS];
    if (x == NULL)
        return CAGD_UNDECIDED;
    find_coordinates(c, p, x);
    if (region_faults != 0)
        return CAGD_UNDECIDED;
    cagd_answer answer = cagd_positive_in_box(x->p, strict, x->count, x->side, point, rational);
    if (answer != CAGD_HOLDS && x->leaves_out && is_positive_in_bounds(c, p, strict))
        return CAGD_HOLDS;
    for (int m = 0; answer == CAGD_FAILS && *rational && m < x->count; m++) {
        num_f at = x->by[m];
        for (int k = 0; k < x->count; k++)
            at = substitute_f(at, x->side[k].variable, from_rational_f(point[k]));
        value[x->of[m]] = from_int_q(0);
        is_constant_f(at, &value[x->of[m]]);
    }
    return answer;
}

int cagd_is_positive_in_cell(const cagd_context *c, num_f p, int strict)
{
    num_q value[CAGD_MOST_UNKNOWNS];
    int rational;
    return cagd_positive_in_cell(c, p, strict, value, &rational) == CAGD_HOLDS;
}
