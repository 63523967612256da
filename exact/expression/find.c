#include "exact/expression/find.h"

#include "core/clock.h"
#include "exact/expression/cases.h"
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

/* A value of the parameter for which the polynomial is 0 whatever the other names are is none of those that are looked for. */
static void collect_poles(cagd_run *r, num_f p, const cagd_binding *parameter)
{
    num_f poles = cagd_factor_of_parameter(p, parameter->value.f);
    if (!is_constant_f(poles, NULL) && r->into->count < MOST_CONSTRAINTS)
        collect(r, (cagd_constraint){mul_f(poles, poles), CAGD_MORE_THAN_ZERO, {.variable = parameter->value.f}}, NULL);
}

/* The relation a >= b, a > b, a = b, or a \ne b as a constraint of the parameter; its value must not be a pole. */
cagd_answer cagd_collected(cagd_run *r, cagd_context *c, cagd_relation relation, cagd_value d)
{
    struct cagd_collection *into = r->into;
    const cagd_binding *parameter = cagd_binding_of(c, r->parameter);
    cagd_side_of_box side[CAGD_MOST_UNKNOWNS];
    int of[CAGD_MOST_UNKNOWNS], count = cagd_sides_of_known(c, side, of);
    r->out->comparisons++;
    if (into->count + 1 + c->divisors >= MOST_CONSTRAINTS)
        return cagd_note_undecided(r, c, "too many cases");
    num_f f = cagd_in_field(d), n = cagd_numerator_f(f),
          p = relation == CAGD_EQUAL       ? n
              : relation == CAGD_NOT_EQUAL ? mul_f(n, n)
                                           : mul_f(n, cagd_denominator_f(f));
    cagd_constraint one = {.p = p,
                           .demand = relation == CAGD_EQUAL ? CAGD_ZERO
                                     : relation == CAGD_LESS_OR_EQUAL || relation == CAGD_GREATER_OR_EQUAL
                                         ? CAGD_AT_LEAST_ZERO
                                         : CAGD_MORE_THAN_ZERO};
    if (!has_bounds_alone(c, p, parameter))
        return cagd_note_undecided(r, c, "a condition or a bound that is not understood with :find:");
    const char *other = NULL;
    for (int m = 0; m < count; m++) {
        const cagd_binding *b = &c->binding[of[m]];
        if (b == parameter) {
            into->domain = side[m];
        } else if (degree_f(p, side[m].variable) > 0 && one.demand != CAGD_ZERO) {
            if (other != NULL)
                return cagd_note_undecided(r, c, "an inequality of more than one name besides the parameter");
            one.t = side[m];
            other = b->key;
        }
    }
    if (other == NULL)
        one.t.variable = parameter->value.f;
    collect(r, one, other);
    if (relation != CAGD_EQUAL)
        collect_poles(r, cagd_denominator_f(f), parameter);
    for (int i = 0; into->poles && i < c->divisors; i++)
        collect_poles(r, c->divisor[i], parameter);
    return CAGD_HOLDS;
}

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
