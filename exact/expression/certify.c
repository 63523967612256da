#include "exact/expression/certify.h"

#include "core/clock.h"
#include "exact/expression/cases.h"
#include "exact/expression/depends.h"
#include "exact/expression/positive.h"
#include "exact/number/recorder.h"
#include "exact/record/trace.h"
#include "exact/words.h"

#include <stdio.h>

enum { MOST_NOTED = 200000 };

/* The node of a value. */
static int node_of(cagd_value a) { return a.rational ? cagd_node_of_q(a.q) : cagd_node_of_f(a.f); }

/* That a relation b holds in the box of the names; 0 where that is not noted. */
static int note_inequality(const cagd_context *c, cagd_relation relation, cagd_value a, cagd_value b)
{
    cagd_side_of_box side[CAGD_MOST_UNKNOWNS];
    int of[CAGD_MOST_UNKNOWNS], count = cagd_sides_of_known(c, side, of), noted = 0;
    int less = relation == CAGD_LESS || relation == CAGD_LESS_OR_EQUAL;
    int strict = relation != CAGD_LESS_OR_EQUAL && relation != CAGD_GREATER_OR_EQUAL;
    for (int turned = 0; turned <= (relation == CAGD_NOT_EQUAL) && !noted; turned++)
        noted =
            cagd_note_sign_in_box(less != turned ? cagd_value_sub(b, a) : cagd_value_sub(a, b), strict, count, side);
    if (noted)
        cagd_trace_agree(1, strict ? "is_positive_in_box(difference)" : "is_nonnegative_in_box(difference)");
    return noted;
}

/* What is compared, as a step of the certificate; an identity stands for itself where no name is a function of others. */
void cagd_note_step(cagd_run *r, const cagd_context *c, cagd_relation relation, cagd_value a, cagd_value b)
{
    for (int m = 0; m < c->count; m++)
        r->unnoted |= (c->binding[m].solved && !c->binding[m].is_tied) || c->binding[m].has_root;
    r->unnoted |= relation != CAGD_EQUAL && (c->limits > 0 || !note_inequality(c, relation, a, b));
    if (!r->unnoted && relation == CAGD_EQUAL)
        cagd_trace_same(node_of(a), node_of(b), 1);
}

/* ---- a statement once more ------------------------------------------------------------------------------- */

/* Whether the name of the example runs over whole numbers: those are no inputs, for the program depends on them. */
static int is_whole_number(const cagd_scope *scope, const char *name)
{
    const cagd_variable *v = cagd_declared(scope, name);
    return v != NULL && v->whole;
}

static int certify_cases(const cagd_scope *scope, const cagd_tree *statement, double seconds, cagd_take_case *take,
                         void *data)
{
    cagd_finding *f = region_bytes(sizeof *f);
    cagd_run r = {
        .scope = scope, .statement = statement, .out = f, .until = cagd_seconds() + seconds, .taken = CAGD_FIRST_CASES};
    r.take = take, r.data = data;
    r.wholes = cagd_whole_numbers(scope, statement, r.whole, CAGD_MOST_WHOLE);
    long low;
    if (f == NULL || r.wholes < 0)
        return 0;
    *f = (cagd_finding){0};
    field_open(CAGD_FIELD_MAX_VARIABLES);
    cagd_trace_open(MOST_NOTED);
    cagd_decide_cases(&r, 0);
    int good = region_faults == 0 && !r.unnoted && !f->out_of_time && !f->has_example && f->undecided == 0;
    if (good && cagd_has_no_end(&r)) { /* one case more, which stands for all others */
        cagd_trace_again();
        good = cagd_has_one_number(&r, &low) &&
               cagd_note_for_every(scope, statement, r.whole[0], low, CAGD_FIRST_CASES) && cagd_give_case(&r);
    }
    cagd_trace_close();
    region_faults &= FAULT_MEMORY;
    return good;
}

/* The two sides at the example, and that their order is not the one that is printed. */
static int certify_example(const cagd_scope *scope, const cagd_finding *found, cagd_take_case *take, void *data)
{
    static const char *const printed[] = {NULL, "!=", "<", "<=", ">", ">="};
    cagd_context *c = region_bytes(sizeof *c);
    if (c == NULL || !found->has_example || found->has_root || found->of_left == NULL)
        return 0;
    *c = (cagd_context){.scope = scope, .in_field = 1, .steps = CAGD_USUAL_STEPS};
    c->whole_angles = found->whole_angles;
    field_open(CAGD_FIELD_ROOM);
    cagd_trace_open(MOST_NOTED);
    for (int k = 0; k < found->given; k++) {
        cagd_value value = cagd_value_constant(found->example[k].value);
        char name[16];
        snprintf(name, sizeof name, "v%d", k);
        if (!is_whole_number(scope, found->example[k].name))
            cagd_trace_input(value.q, name, -1);
        cagd_bind(c, found->example[k].name, value);
    }
    cagd_value a = cagd_evaluate(c, found->of_left), b = cagd_evaluate(c, found->of_right);
    int good = region_faults == 0 && a.rational && b.rational && cagd_equal_q(a.q, found->left) &&
               cagd_equal_q(b.q, found->right);
    if (good && found->relation == CAGD_EQUAL)
        cagd_trace_same(node_of(a), node_of(b), 0);
    if (good && found->relation != CAGD_EQUAL) {
        char formula[64];
        snprintf(formula, sizeof formula, "compare_q(left, right) %s 0", printed[found->relation]);
        cagd_trace_relation("order", node_of(a), node_of(b), cagd_compare_q(a.q, b.q));
        cagd_trace_agree(0, formula);
    }
    const char *inputs = cagd_trace_inputs(), *nodes = cagd_trace_nodes(), *steps = cagd_trace_steps();
    good = good && region_faults == 0 && inputs != NULL && nodes != NULL && steps != NULL &&
           take(data, inputs, nodes, steps);
    cagd_trace_close();
    region_faults &= FAULT_MEMORY;
    return good;
}

int cagd_certify(const cagd_scope *scope, const cagd_tree *statement, const cagd_finding *found, double seconds,
                 cagd_take_case *take, void *data)
{
    return found->answer == CAGD_FAILS   ? certify_example(scope, found, take, data)
           : found->answer == CAGD_HOLDS ? certify_cases(scope, statement, seconds, take, data)
                                         : 0;
}
