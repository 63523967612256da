#include "exact/expression/sides.h"

#include "exact/words.h"

#include <string.h>

/* A context in which the names have the values of the example, that one the value x; NULL without memory. */
static cagd_context *at_example(const cagd_scope *scope, const cagd_finding *f, int name, num_q x)
{
    cagd_context *c = region_bytes(sizeof *c);
    if (c == NULL)
        return NULL;
    *c = (cagd_context){.scope = scope, .in_field = 1, .steps = CAGD_USUAL_STEPS}; /* in the field what is derived is */
    c->whole_angles = f->whole_angles;
    for (int k = 0; k < f->given; k++)
        cagd_bind(c, f->example[k].name, cagd_value_q(k == name ? x : f->example[k].value));
    return c;
}

int cagd_sides_at(const cagd_scope *scope, const cagd_finding *f, int name, num_q x, num_q *left, num_q *right)
{
    cagd_context *c = at_example(scope, f, name, x);
    if (c == NULL || region_faults != 0)
        return 0;
    cagd_value a = cagd_evaluate(c, f->of_left), b = cagd_evaluate(c, f->of_right);
    int good = region_faults == 0 && a.rational && b.rational;
    region_faults &= FAULT_MEMORY;
    *left = a.q, *right = b.q;
    return good;
}

/* The declaration of a name such as "t" or "\omega_3". */
static const cagd_variable *declaration_of(const cagd_scope *scope, const char *name)
{
    const cagd_variable *alone = cagd_declared_alone(scope, name);
    if (alone != NULL)
        return alone;
    for (const cagd_variable *v = scope->variables; v != NULL; v = v->next) {
        size_t n = strlen(v->head);
        if (strncmp(name, v->head, n) == 0 && (name[n] == '\0' || (n > 0 && v->head[n - 1] == '_') || name[n] == '^') &&
            v->key == NULL)
            return v;
    }
    return NULL;
}

/* The bound as a number; 0 where there is none. */
static int bound_of(const cagd_scope *scope, const cagd_finding *f, const cagd_tree *end, num_q *value)
{
    cagd_context *c = end != NULL ? at_example(scope, f, -1, from_int_q(0)) : NULL;
    if (c == NULL)
        return 0;
    cagd_value v = cagd_evaluate(c, end);
    int good = region_faults == 0 && v.rational;
    region_faults &= FAULT_MEMORY;
    *value = v.q;
    return good;
}

/* Whether a side has another value for another value of that name within its range. */
static int depends(const cagd_scope *scope, const cagd_finding *f, int name, num_q low, num_q high)
{
    enum { PLACES = 5 };
    num_q left, right;
    for (int k = 1; k < PLACES; k++) {
        num_q x = add_q(low, mul_q(sub_q(high, low), from_ratio_q(k, PLACES)));
        if (cagd_sides_at(scope, f, name, x, &left, &right) &&
            (!cagd_equal_q(left, f->left) || !cagd_equal_q(right, f->right)))
            return 1;
    }
    return 0;
}

int cagd_free_name(const cagd_scope *scope, const cagd_finding *f, num_q *low, num_q *high)
{
    int best = -1, best_bounds = -1;
    for (int k = 0; k < f->given && f->of_left != NULL; k++) {
        const cagd_variable *v = declaration_of(scope, f->example[k].name);
        num_q two = from_int_q(2), a = sub_q(f->example[k].value, two), b = add_q(f->example[k].value, two);
        if (v != NULL && v->whole)
            continue;
        int bounds = 0;
        if (v != NULL)
            bounds = bound_of(scope, f, v->low, &a) + bound_of(scope, f, v->high, &b);
        if (cagd_compare_q(a, f->example[k].value) > 0 || cagd_compare_q(b, f->example[k].value) < 0 ||
            cagd_compare_q(a, b) >= 0 || bounds <= best_bounds || !depends(scope, f, k, a, b))
            continue;
        best = k, best_bounds = bounds, *low = a, *high = b;
    }
    return best;
}
