#include "exact/expression/find.h"

#include "core/clock.h"
#include "exact/expression/angle.h"
#include "exact/expression/cases.h"
#include "exact/expression/clauses.h"
#include "exact/expression/depends.h"
#include "exact/words.h"

enum { MOST_CONSTRAINTS = 200 };

/* What the cases ask of a parameter. */
struct cagd_collection {
    int poles; /* numbers for which a divisor of a side is 0 are none of those that are looked for */
    cagd_constraint constraint[MOST_CONSTRAINTS];
    const char *other[MOST_CONSTRAINTS]; /* the name of its other variable */
    cagd_given chosen[MOST_CONSTRAINTS][CAGD_MOST_WHOLE];
    int count;
    cagd_side_of_box domain;
};

/* One more constraint, with the case that it comes from. */
static void collect(cagd_run *r, cagd_constraint one, const char *other)
{
    struct cagd_collection *into = r->into;
    for (int m = 0; m < r->wholes; m++)
        into->chosen[into->count][m] = r->chosen[m];
    into->constraint[into->count] = one;
    into->other[into->count++] = other;
}

/* Whether all that is known of the names in p, and of the parameter, are their bounds. */
static int has_bounds_alone(const cagd_context *c, num_f p, const cagd_binding *parameter)
{
    for (int m = 0; m < c->count; m++) {
        const cagd_binding *b = &c->binding[m];
        const cagd_variable *v = b->variable;
        if (!b->unknown || (b != parameter && degree_f(p, b->value.f) < 1))
            continue;
        if (b->has_root || (v != NULL && ((v->low != NULL && !b->has_low) || (v->high != NULL && !b->has_high))))
            return 0;
        for (int i = 0; i < c->limits; i++)
            if (degree_f(c->limit[i].form, b->value.f) > 0)
                return 0;
    }
    return c->missing == 0 && !c->loose;
}

/* The polynomial whose roots are the values of the parameter for which p is 0 whatever the other names are, to the square; *is, whether there are any. */
static cagd_constraint not_at_poles(num_f p, const cagd_binding *parameter, int *is)
{
    num_f poles = cagd_factor_of_parameter(p, parameter->value.f);
    *is = !is_constant_f(poles, NULL);
    return (cagd_constraint){
        .p = mul_f(poles, poles), .demand = CAGD_MORE_THAN_ZERO, .t = {.variable = parameter->value.f}};
}

/* Such a value is none of those that are looked for. */
static void collect_poles(cagd_run *r, num_f p, const cagd_binding *parameter)
{
    int is;
    cagd_constraint one = not_at_poles(p, parameter, &is);
    if (is && r->into->count < MOST_CONSTRAINTS)
        collect(r, one, NULL);
}

/* d >= 0, d > 0, d = 0, or d \ne 0 as a constraint, its other variable being left out; wherever d is defined. */
static cagd_constraint constraint_of(cagd_relation relation, num_f d)
{
    num_f n = cagd_numerator_f(d);
    return (cagd_constraint){.p = relation == CAGD_EQUAL       ? n
                                  : relation == CAGD_NOT_EQUAL ? mul_f(n, n)
                                                               : mul_f(n, cagd_denominator_f(d)),
                             .demand = relation == CAGD_EQUAL ? CAGD_ZERO
                                       : relation == CAGD_LESS_OR_EQUAL || relation == CAGD_GREATER_OR_EQUAL
                                           ? CAGD_AT_LEAST_ZERO
                                           : CAGD_MORE_THAN_ZERO};
}

/* The name besides the parameter on which the constraint depends becomes its other variable, *other; 0, and why, where there are several, or where more is
 * known of them than bounds.  Where `alone`, an equality may have any names. */
static int find_other(cagd_run *r, cagd_context *c, int alone, cagd_constraint *one, const cagd_binding **other)
{
    const cagd_binding *parameter = cagd_binding_of(c, r->parameter);
    cagd_side_of_box side[CAGD_MOST_UNKNOWNS];
    int of[CAGD_MOST_UNKNOWNS], count = cagd_sides_of_known(c, side, of);
    *other = NULL;
    if (!has_bounds_alone(c, one->p, parameter)) {
        cagd_note_undecided(r, c, "a condition or a bound that is not understood with :find:");
        return 0;
    }
    for (int m = 0; m < count; m++) {
        const cagd_binding *b = &c->binding[of[m]];
        if (b == parameter) {
            r->into->domain = side[m];
        } else if (degree_f(one->p, side[m].variable) > 0 && !(alone && one->demand == CAGD_ZERO)) {
            if (*other != NULL) {
                cagd_note_undecided(r, c, "an inequality of more than one name besides the parameter");
                return 0;
            }
            one->t = side[m];
            *other = b;
        }
    }
    if (*other == NULL)
        one->t.variable = parameter->value.f;
    return 1;
}

/* The constraint, or its variable is beyond an end that is a root. */
static void collect_outside(cagd_run *r, const cagd_binding *other, cagd_constraint one)
{
    num_f inside;
    for (int k = 0; k < 2 && other != NULL; k++)
        if (cagd_end_of_angle(other, k, &inside))
            collect(r,
                    (cagd_constraint){.p = neg_f(inside),
                                      .demand = other->root_end_open[k] ? CAGD_AT_LEAST_ZERO : CAGD_MORE_THAN_ZERO,
                                      .t = one.t,
                                      .or_next = 1},
                    other->key);
    collect(r, one, other != NULL ? other->key : NULL);
}

/* Its value must not be a pole of d or of a divisor. */
cagd_answer cagd_collected(cagd_run *r, cagd_context *c, cagd_relation relation, cagd_value d)
{
    struct cagd_collection *into = r->into;
    const cagd_binding *parameter = cagd_binding_of(c, r->parameter);
    const cagd_binding *other;
    r->out->comparisons++;
    if (into->count + 3 + c->divisors >= MOST_CONSTRAINTS)
        return cagd_note_undecided(r, c, "too many cases");
    num_f f = cagd_in_field(d);
    cagd_constraint one = constraint_of(relation, f);
    if (!find_other(r, c, 1, &one, &other))
        return CAGD_UNDECIDED;
    collect_outside(r, other, one);
    if (relation != CAGD_EQUAL)
        collect_poles(r, cagd_denominator_f(f), parameter);
    for (int i = 0; into->poles && i < c->divisors; i++)
        collect_poles(r, c->divisor[i], parameter);
    return CAGD_HOLDS;
}

/* ---- clauses ------------------------------------------------------------------------------------------- */

/* A relation of a clause, and that the parameter is none of its poles. */
struct literal {
    cagd_constraint one, defined;
    const cagd_binding *other;
    int has_poles;
};

/* Whether a denominator is never 0, unless for values of the parameter. */
static int is_denominator_of_parameter(const cagd_context *c, num_f m, const cagd_binding *parameter)
{
    cagd_side_of_box side[CAGD_MOST_UNKNOWNS];
    num_q point[CAGD_MOST_UNKNOWNS];
    int of[CAGD_MOST_UNKNOWNS], count = cagd_sides_of_known(c, side, of), unused;
    num_f rest = m, factor = cagd_factor_of_parameter(rest, parameter->value.f);
    while (!is_constant_f(factor, NULL) && region_faults == 0) {
        rest = div_f(rest, factor);
        factor = cagd_factor_of_parameter(rest, parameter->value.f);
    }
    return cagd_positive_in_box(rest, 1, count, side, point, &unused) == CAGD_HOLDS ||
           cagd_positive_in_box(neg_f(rest), 1, count, side, point, &unused) == CAGD_HOLDS;
}

static int read_literal(cagd_run *r, cagd_context *c, const cagd_tree *t, struct literal *out)
{
    cagd_relation relation = t->relation[0];
    int less = relation == CAGD_LESS || relation == CAGD_LESS_OR_EQUAL;
    c->divisors = 0; /* what it divides by is noted anew */
    cagd_value a = cagd_evaluate(c, t->at[0]), b = cagd_evaluate(c, t->at[1]);
    const cagd_binding *parameter = cagd_binding_of(c, r->parameter);
    if (region_faults != 0)
        return 0;
    num_f f = cagd_in_field(less ? cagd_value_sub(b, a) : cagd_value_sub(a, b)), poles = cagd_denominator_f(f);
    out->one = constraint_of(relation, f);
    for (int i = 0; r->into->poles && i < c->divisors; i++)
        poles = mul_f(poles, cagd_numerator_f(c->divisor[i]));
    out->defined = not_at_poles(poles, parameter, &out->has_poles);
    if (!find_other(r, c, 0, &out->one, &out->other))
        return 0;
    if (!is_denominator_of_parameter(c, poles, parameter)) {
        cagd_note_undecided(r, c, "a divisor that may be 0, in an alternative");
        return 0;
    }
    return region_faults == 0;
}

cagd_answer cagd_collect_clause(cagd_run *r, cagd_context *c, const cagd_tree *t)
{
    struct cagd_collection *into = r->into;
    struct literal literal[CAGD_MOST_LITERALS];
    int with_poles = 0, place[CAGD_MOST_LITERALS];
    for (int k = 0; k < t->count; k++) {
        if (!read_literal(r, c, t->at[k], &literal[k]))
            return CAGD_UNDECIDED;
        place[k] = literal[k].has_poles ? with_poles++ : -1;
    }
    if (into->count + 3 * (t->count << with_poles) >= MOST_CONSTRAINTS)
        return cagd_note_undecided(r, c, "too many cases");
    r->out->comparisons++;
    for (int choice = 0; choice < 1 << with_poles; choice++) /* each literal is "true and defined" */
        for (int k = 0; k < t->count; k++) {
            int defined = place[k] >= 0 && (choice >> place[k] & 1);
            cagd_constraint one = defined ? literal[k].defined : literal[k].one;
            one.or_next = k + 1 < t->count;
            collect_outside(r, defined ? NULL : literal[k].other, one);
        }
    return CAGD_HOLDS;
}

/* ---- the range of the parameter ------------------------------------------------------------------------ */

void cagd_find(const cagd_scope *scope, const cagd_tree *statement, const char *parameter, int poles, double seconds,
               cagd_found *out)
{
    cagd_finding *f = region_bytes(sizeof *f);
    struct cagd_collection *into = region_bytes(sizeof *into);
    *out = (cagd_found){.why = "there was no memory for it"};
    if (f == NULL || into == NULL)
        return;
    *f = (cagd_finding){0};
    *into = (struct cagd_collection){.poles = poles};
    const cagd_tree *clauses = cagd_in_clauses(statement);
    if (clauses != NULL &&
        !cagd_has_squared_roots(statement)) /* otherwise what is not understood is told where it is met */
        statement = clauses;
    cagd_run r = {.scope = scope,
                  .statement = statement,
                  .out = f,
                  .until = cagd_seconds() + seconds,
                  .taken = CAGD_FIRST_CASES,
                  .parameter = parameter,
                  .into = into};
    r.wholes = cagd_whole_numbers(scope, statement, r.whole, CAGD_MOST_WHOLE);
    field_open(CAGD_FIELD_ROOM);
    if (r.wholes >= 0)
        cagd_decide_cases(&r, 0);
    out->cases = f->cases, out->why = f->why, out->where = f->where, out->wholes = r.wholes;
    out->domain = into->domain;
    if (f->out_of_time)
        out->why = "the time was over";
    else if (r.wholes < 0 || cagd_has_no_end(&r))
        out->why = "a range without end";
    else if (into->count == 0 && out->why == NULL)
        out->why = "the statement does not depend on the parameter, or there is no case";
    else if (out->why == NULL && region_faults == 0)
        out->known = cagd_cells_of(into->count, into->constraint, &into->domain, &out->cells);
    if (!out->known && out->why == NULL)
        out->why = "too many numbers where it may change, or too many variables";
    region_faults = 0;
    for (int k = 0; out->known && k <= out->cells.count; k++) {
        int broken = out->cells.broken[k];
        out->name_of_witness[k] = into->other[broken];
        for (int m = 0; m < r.wholes; m++)
            out->breaking[k][m] = into->chosen[broken][m];
    }
}
