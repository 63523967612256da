#include "exact/expression/clauses.h"

#include "exact/words.h"

enum { MOST_CLAUSES = CAGD_MOST_CHILDREN, MOST_STEPS = 400 };

struct clause {
    int count;
    const cagd_tree *literal[CAGD_MOST_LITERALS];
};

/* A conjunction of clauses; `fails`: it is not one that can be written. */
struct form {
    int count, fails;
    struct clause clause[MOST_CLAUSES];
};

static struct form *new_form(void)
{
    struct form *f = region_bytes(sizeof *f);
    if (f != NULL)
        f->count = f->fails = 0;
    return f;
}

/* The clauses of both; each clause of the one together with each of the other. */
static struct form *both(const struct form *a, const struct form *b)
{
    struct form *f = a != NULL && b != NULL ? new_form() : NULL;
    if (f == NULL)
        return NULL;
    f->fails = a->fails || b->fails || a->count + b->count > MOST_CLAUSES;
    for (int i = 0; !f->fails && i < a->count + b->count; i++)
        f->clause[f->count++] = i < a->count ? a->clause[i] : b->clause[i - a->count];
    return f;
}
static struct form *either(const struct form *a, const struct form *b)
{
    struct form *f = a != NULL && b != NULL ? new_form() : NULL;
    if (f == NULL)
        return NULL;
    f->fails = a->fails || b->fails || a->count * b->count > MOST_CLAUSES;
    for (int i = 0; !f->fails && i < a->count * b->count; i++) {
        struct clause *one = &f->clause[f->count++], other = b->clause[i % b->count];
        *one = a->clause[i / b->count]; /* in their order: what was supposed stands first */
        f->fails |= one->count + other.count > CAGD_MOST_LITERALS;
        for (int k = 0; !f->fails && k < other.count; k++)
            one->literal[one->count++] = other.literal[k];
    }
    return f;
}

static struct form *joined(int any, const struct form *a, const struct form *b)
{
    return any ? either(a, b) : both(a, b);
}

/* ---- one relation -------------------------------------------------------------------------------------- */

static cagd_relation opposite(cagd_relation relation)
{
    static const cagd_relation of[] = {
        [CAGD_EQUAL] = CAGD_NOT_EQUAL,       [CAGD_NOT_EQUAL] = CAGD_EQUAL,       [CAGD_LESS] = CAGD_GREATER_OR_EQUAL,
        [CAGD_LESS_OR_EQUAL] = CAGD_GREATER, [CAGD_GREATER] = CAGD_LESS_OR_EQUAL, [CAGD_GREATER_OR_EQUAL] = CAGD_LESS,
    };
    return of[relation];
}

static const cagd_tree *relation_of(const cagd_tree *a, cagd_relation relation, const cagd_tree *b)
{
    cagd_tree *t = cagd_tree_new(CAGD_RELATION, a->from, b->to, 2);
    cagd_relation *which = region_bytes(sizeof *which);
    if (t == NULL || which == NULL)
        return NULL;
    *which = relation;
    t->at[0] = a, t->at[1] = b, t->relation = which;
    return t;
}

static int is_choice(const cagd_tree *t)
{
    return t->kind == CAGD_ABSOLUTE || t->kind == CAGD_MAXIMUM || t->kind == CAGD_MINIMUM;
}

/* The first amount, greatest or least of the tree that has none in it and that does not depend on what the tree binds; NULL where there is none. */
static const cagd_tree *choice_in(const cagd_tree *t)
{
    switch (t->kind) {
    case CAGD_NAME:
        if (t->order > 0 || t->times != NULL)
            return NULL;
        break;
    case CAGD_NUMBER:
    case CAGD_SUM:
    case CAGD_PRODUCT:
    case CAGD_NEGATIVE:
    case CAGD_QUOTIENT:
    case CAGD_POWER:
    case CAGD_RELATION:
    case CAGD_ABSOLUTE:
    case CAGD_MAXIMUM:
    case CAGD_MINIMUM:
        break;
    default:
        return NULL;
    }
    for (int k = 0; k < t->count; k++) {
        const cagd_tree *found = choice_in(t->at[k]);
        if (found != NULL)
            return found;
    }
    return is_choice(t) ? t : NULL;
}

/* The tree with `by` in the place of that node. */
static const cagd_tree *replaced(const cagd_tree *t, const cagd_tree *node, const cagd_tree *by)
{
    if (t == node || t == NULL)
        return t == NULL ? NULL : by;
    cagd_tree *copy = NULL;
    for (int k = 0; k < t->count; k++) {
        const cagd_tree *child = replaced(t->at[k], node, by);
        if (child == t->at[k])
            continue;
        if (copy == NULL) {
            copy = cagd_tree_new(t->kind, t->from, t->to, t->count);
            if (copy == NULL)
                return t;
            const cagd_tree **at = copy->at;
            *copy = *t, copy->at = at;
            for (int m = 0; m < t->count; m++)
                at[m] = t->at[m];
        }
        copy->at[k] = child;
    }
    return copy != NULL ? copy : t;
}

static struct form *of_literal(const cagd_tree *relation)
{
    struct form *f = new_form();
    if (f == NULL || relation == NULL)
        return NULL;
    f->count = 1;
    f->clause[0] = (struct clause){1, {relation}};
    return f;
}

static struct form *of_relation(const cagd_tree *t, int *steps);

/* t with that one of the values of the choice in its place: of an amount those are a and -a. */
static const cagd_tree *with_value(const cagd_tree *t, const cagd_tree *choice, int which)
{
    int amount = choice->kind == CAGD_ABSOLUTE;
    const cagd_tree *a = choice->at[amount ? 0 : which];
    if (!amount || which == 0)
        return replaced(t, choice, a);
    cagd_tree *minus = cagd_tree_new(CAGD_NEGATIVE, a->from, a->to, 1);
    if (minus == NULL)
        return NULL;
    minus->at[0] = a;
    return replaced(t, choice, minus);
}

/* t where that one of the values is the one that is taken, or it is another one. */
static struct form *of_value(const cagd_tree *t, const cagd_tree *choice, int which, int *steps)
{
    int amount = choice->kind == CAGD_ABSOLUTE;
    const cagd_tree *a = choice->at[amount ? 0 : which];
    struct form *f = of_relation(with_value(t, choice, which), steps);
    for (int j = 0; j < (amount ? 1 : choice->count); j++) {
        const cagd_tree *other = amount ? cagd_tree_number(0, a->from, a->to) : choice->at[j];
        int less = amount ? which == 0 : choice->kind == CAGD_MAXIMUM;
        if ((amount || j != which) && other != NULL)
            f = either(of_literal(relation_of(a, less ? CAGD_LESS : CAGD_GREATER, other)), f);
    }
    return f;
}

/* Where a side is the choice itself: 1 if the relation is one with all of its values, -1 if it is one with some of them, 0 where it is neither. */
static int is_bound_of_choice(const cagd_tree *t, const cagd_tree *choice)
{
    int left = t->at[0] == choice, greatest = choice->kind != CAGD_MINIMUM;
    if (left == (t->at[1] == choice) || t->relation[0] == CAGD_EQUAL || t->relation[0] == CAGD_NOT_EQUAL)
        return 0;
    int less = t->relation[0] == CAGD_LESS || t->relation[0] == CAGD_LESS_OR_EQUAL;
    return (less == left) == greatest ? 1 : -1;
}

/* Whether it is the square root of what is no number. */
static int is_root(const cagd_tree *t)
{
    return t->kind == CAGD_ROOT && t->count == 2 && t->at[1]->kind == CAGD_NUMBER &&
           cagd_equal_q(t->at[1]->number, from_int_q(2)) && t->at[0]->kind != CAGD_NUMBER;
}
static int side_with_root(const cagd_tree *t) { return is_root(t->at[0]) ? 0 : is_root(t->at[1]) ? 1 : -1; }

static const cagd_tree *square_of(const cagd_tree *a)
{
    cagd_tree *t = cagd_tree_new(CAGD_POWER, a->from, a->to, 2);
    const cagd_tree *two = cagd_tree_number(2, a->from, a->to);
    if (t == NULL || two == NULL)
        return NULL;
    t->at[0] = a, t->at[1] = two;
    return t;
}

/* sqrt(E) <= R where E >= 0: R >= 0 and E <= R^2; sqrt(E) >= R: R < 0 or E >= R^2; sqrt(E) > R likewise; an equality is R >= 0 and E = R^2. */
static struct form *of_root(const cagd_tree *t, int side, int *steps)
{
    const cagd_tree *E = t->at[side]->at[0], *R = t->at[1 - side], *square = square_of(R),
                    *zero = cagd_tree_number(0, R->from, R->to);
    if (square == NULL || zero == NULL)
        return NULL;
    cagd_relation relation = t->relation[0];
    struct form *defined = of_relation(relation_of(E, CAGD_GREATER_OR_EQUAL, zero), steps);
    struct form *squares =
        of_relation(side == 0 ? relation_of(E, relation, square) : relation_of(square, relation, E), steps);
    int above = side == 0 ? relation == CAGD_GREATER || relation == CAGD_GREATER_OR_EQUAL
                          : relation == CAGD_LESS || relation == CAGD_LESS_OR_EQUAL;
    int either_way = above || relation == CAGD_NOT_EQUAL;
    struct form *sign = of_relation(relation_of(R, either_way ? CAGD_LESS : CAGD_GREATER_OR_EQUAL, zero), steps);
    return both(defined, joined(either_way, sign, squares));
}

/* A relation of two sides. */
static struct form *of_relation(const cagd_tree *t, int *steps)
{
    const cagd_tree *choice = t != NULL ? choice_in(t) : NULL;
    int side = choice == NULL && t != NULL ? side_with_root(t) : -1;
    if (side >= 0)
        return --*steps < 0 ? NULL : of_root(t, side, steps);
    if (choice == NULL)
        return of_literal(t);
    int bound = is_bound_of_choice(t, choice);
    int values = choice->kind == CAGD_ABSOLUTE ? 2 : choice->count;
    struct form *f = new_form();
    for (int which = 0; which < values && f != NULL; which++) {
        if (--*steps < 0)
            f->fails = 1;
        if (f->fails)
            break;
        if (bound == 0) {
            f = both(f, of_value(t, choice, which, steps));
        } else {
            struct form *one = of_relation(with_value(t, choice, which), steps);
            f = which == 0 ? one : joined(bound < 0, f, one);
        }
    }
    return f;
}

/* ---- what is made of relations ------------------------------------------------------------------------- */

static struct form *form_of(const cagd_tree *t, int negated, int *steps);

static struct form *of_chain(const cagd_tree *t, int negated, int *steps)
{
    struct form *f = NULL;
    for (int k = 0; k + 1 < t->count; k++) {
        cagd_relation relation = negated ? opposite(t->relation[k]) : t->relation[k];
        struct form *one = of_relation(relation_of(t->at[k], relation, t->at[k + 1]), steps);
        f = k == 0 ? one : joined(negated, f, one);
    }
    return f;
}

static struct form *of_several(const cagd_tree *t, int any, int negated, int *steps)
{
    struct form *f = NULL;
    for (int k = 0; k < t->count; k++) {
        struct form *one = form_of(t->at[k], negated, steps);
        f = k == 0 ? one : joined(any != negated, f, one);
    }
    return f;
}

static struct form *implication(const cagd_tree *a, const cagd_tree *b, int negated, int *steps)
{
    return joined(!negated, form_of(a, !negated, steps), form_of(b, negated, steps));
}

static struct form *form_of(const cagd_tree *t, int negated, int *steps)
{
    struct form *other;
    switch (t->kind) {
    case CAGD_RELATION:
        return of_chain(t, negated, steps);
    case CAGD_ALL:
    case CAGD_ANY:
        return of_several(t, t->kind == CAGD_ANY, negated, steps);
    case CAGD_NOT:
        return form_of(t->at[0], !negated, steps);
    case CAGD_IMPLIES:
        return implication(t->at[0], t->at[1], negated, steps);
    case CAGD_IFF:
        return joined(negated, implication(t->at[0], t->at[1], negated, steps),
                      implication(t->at[1], t->at[0], negated, steps));
    default:
        other = new_form();
        if (other != NULL)
            other->fails = 1;
        return other;
    }
}

/* "(not a, not b, ...) => z" for the clause a, b, ..., z. */
static const cagd_tree *implication_tree(const cagd_tree *of, const struct clause *c)
{
    int last = c->count - 1;
    cagd_tree *t = cagd_tree_new(CAGD_IMPLIES, of->from, of->to, 2),
              *all = cagd_tree_new(CAGD_ALL, of->from, of->to, last);
    if (last == 0 || t == NULL || all == NULL)
        return last == 0 ? c->literal[0] : NULL;
    for (int k = 0; k < last; k++) {
        const cagd_tree *one = c->literal[k];
        all->at[k] = relation_of(one->at[0], opposite(one->relation[0]), one->at[1]);
        if (all->at[k] == NULL)
            return NULL;
    }
    t->at[0] = last == 1 ? all->at[0] : all, t->at[1] = c->literal[last];
    return t;
}

static const cagd_tree *clause_tree(const cagd_tree *of, const struct clause *c)
{
    cagd_tree *t = c->count > 1 ? cagd_tree_new(CAGD_ANY, of->from, of->to, c->count) : NULL;
    for (int k = 0; t != NULL && k < c->count; k++)
        t->at[k] = c->literal[k];
    return c->count == 1 ? c->literal[0] : t;
}

/* Relations without choices, or several of them. */
static int is_plain(const cagd_tree *t)
{
    int plain = t->kind == CAGD_ALL || (t->kind == CAGD_RELATION && choice_in(t) == NULL);
    for (int k = 0; t->kind == CAGD_RELATION && k < t->count; k++)
        plain &= !is_root(t->at[k]);
    for (int k = 0; t->kind == CAGD_ALL && k < t->count; k++)
        plain &= is_plain(t->at[k]);
    return plain;
}

static const cagd_tree *rewritten(const cagd_tree *statement,
                                  const cagd_tree *(*of_clause)(const cagd_tree *of, const struct clause *c))
{
    int steps = MOST_STEPS;
    if (is_plain(statement))
        return statement;
    struct form *f = form_of(statement, 0, &steps);
    if (f == NULL || f->fails || f->count == 0)
        return NULL;
    cagd_tree *all = cagd_tree_new(CAGD_ALL, statement->from, statement->to, f->count);
    for (int k = 0; all != NULL && k < f->count; k++) {
        all->at[k] = of_clause(statement, &f->clause[k]);
        if (all->at[k] == NULL)
            return NULL;
    }
    return all;
}

const cagd_tree *cagd_in_clauses(const cagd_tree *statement) { return rewritten(statement, clause_tree); }
const cagd_tree *cagd_in_implications(const cagd_tree *statement) { return rewritten(statement, implication_tree); }

int cagd_has_squared_roots(const cagd_tree *t)
{
    int has = is_root(t);
    for (int k = 0; k < t->count && !has; k++)
        has = cagd_has_squared_roots(t->at[k]);
    return has;
}
