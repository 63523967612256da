/* read_functional.c -- functions of functions, K(f) = \int_0^1 f(t) dt: where they are used their definition is put in. */
#include "exact/expression/reader.h"
#include "exact/words.h"

#include <string.h>

/* ---- which arguments are functions ------------------------------------------------------------------------- */

/* The bracket that begins at t: its end; how many arguments stand in it, and whether they are what needs no bracket as a factor: a name, a number, k/n. */
static const cagd_token *bracket(const cagd_token *t, int *arguments, int *plain)
{
    int depth = 0, operators = 0;
    *arguments = 1;
    for (; t->kind != CAGD_TOKEN_END; t++) {
        depth += (strchr("({[", t->word[0]) != NULL) - (strchr(")}]", t->word[0]) != NULL);
        *arguments += depth == 1 && (t->word[0] == ',' || t->word[0] == ';');
        operators += depth == 1 && (t->word[0] == '+' || t->word[0] == '-' || t->word[0] == '*');
        if (depth == 0)
            break;
    }
    *plain = operators == 0;
    return t;
}

int cagd_arity_of_argument(const cagd_reader *r, const char *letter)
{
    static const char *const of_functions[] = {"f", "g", "F", "G", "\\varphi", "\\psi", NULL};
    int arity = 0, all_plain = 1, usual = 0;
    for (int k = 0; of_functions[k] != NULL; k++)
        usual |= strcmp(letter, of_functions[k]) == 0;
    for (const cagd_token *t = r->token; t->kind != CAGD_TOKEN_END; t++) {
        const cagd_token *next = t + 1;
        int arguments, plain;
        if (strcmp(t->word, letter) != 0 || strcmp(next->word, "_") == 0)
            continue;
        while (strcmp(next->word, "'") == 0)
            next++;
        if (strcmp(next->word, "(") != 0) { /* handed on, K(f), or a number */
            if (strcmp(t[-1].word, "(") != 0 || strchr("),;", next->word[0]) == NULL)
                return 0;
            continue;
        }
        bracket(next, &arguments, &plain);
        if (arity != 0 && arguments != arity)
            return 0;
        arity = arguments, all_plain &= plain;
    }
    return all_plain || usual ? arity : 0;
}

/* ---- the definition put in ----------------------------------------------------------------------------------- */

struct change {
    cagd_reader *r;
    const cagd_tree *left, *const *given; /* for each child of the left side what stands for it */
    unsigned functions;
    int nodes;
};

/* Whether the node binds its head. */
static int binds(const cagd_tree *t)
{
    switch (t->kind) {
    case CAGD_SUM_OVER:
    case CAGD_PRODUCT_OVER:
    case CAGD_MAXIMUM_OVER:
    case CAGD_MINIMUM_OVER:
    case CAGD_DERIVATIVE:
    case CAGD_INTEGRAL:
    case CAGD_AT:
    case CAGD_EVERY_INDEX:
    case CAGD_FOR_ALL:
    case CAGD_EXISTS:
        return t->head != NULL;
    default:
        return 0;
    }
}

/* The first letter that the body binds and that something given has, or that stands on the left for something else; NULL where there is none. */
static const char *caught(const struct change *c, const cagd_tree *t)
{
    const char *found = NULL;
    if (binds(t))
        for (int k = 0; k < c->left->count && found == NULL; k++) {
            int is_itself = strcmp(c->left->at[k]->head, t->head) == 0;
            const cagd_tree *g = c->given[k];
            if (g != NULL && is_itself != (cagd_tree_has(g, t->head) && (!is_itself || g->count == 0)))
                found = t->head;
        }
    if (found == NULL && t->times != NULL)
        found = caught(c, t->times);
    for (int k = 0; k < t->count && found == NULL; k++)
        found = caught(c, t->at[k]);
    return found;
}

static const cagd_tree *changed(struct change *c, const cagd_tree *t);

/* f(x), f standing for the function g, or for a number. */
static const cagd_tree *value_of(struct change *c, const cagd_tree *t, const cagd_tree *g)
{
    if (g->kind == CAGD_NUMBER)
        return t->order > 0 ? cagd_tree_number(0, t->from, t->to) : g;
    int indices = g->lower + g->upper;
    cagd_tree *copy = cagd_new(c->r, CAGD_NAME, t->from, indices + t->arguments);
    if (copy == NULL)
        return NULL;
    const cagd_tree **at = copy->at;
    *copy = *t, copy->at = at, copy->count = indices + t->arguments;
    copy->head = g->head, copy->lower = g->lower, copy->upper = g->upper, copy->order = t->order + g->order;
    copy->before_semicolon = t->arguments;
    for (int k = 0; k < indices; k++)
        at[k] = g->at[k];
    for (int k = 0; k < t->arguments; k++)
        if ((at[indices + k] = changed(c, t->at[k])) == NULL)
            return NULL;
    return copy;
}

static const cagd_tree *changed(struct change *c, const cagd_tree *t)
{
    for (int k = 0; t->kind == CAGD_NAME && k < c->left->count; k++)
        if (c->given[k] != NULL && strcmp(c->left->at[k]->head, t->head) == 0) {
            if ((c->functions >> k & 1) && t->arguments > 0)
                return value_of(c, t, c->given[k]);
            if (t->count == 0)
                return c->given[k];
        }
    cagd_tree *copy = cagd_new(c->r, t->kind, t->from, t->count);
    if (copy == NULL)
        return NULL;
    const cagd_tree **at = copy->at;
    *copy = *t, copy->at = at;
    for (int k = 0; k < t->count; k++)
        if ((at[k] = changed(c, t->at[k])) == NULL)
            return NULL;
    if (t->times != NULL && (copy->times = changed(c, t->times)) == NULL)
        return NULL;
    return copy;
}

/* -3, 1/2: a number that is written with signs, as one node; t itself where it is none. */
static const cagd_tree *as_number(const cagd_tree *t)
{
    if ((t->kind != CAGD_NEGATIVE && t->kind != CAGD_QUOTIENT) || t->count < 1 || t->count > 2)
        return t;
    const cagd_tree *part[2] = {as_number(t->at[0]), t->count == 2 ? as_number(t->at[1]) : NULL};
    int is = part[0]->kind == CAGD_NUMBER && (t->kind == CAGD_NEGATIVE ? t->count == 1 : t->count == 2) &&
             (part[1] == NULL || (part[1]->kind == CAGD_NUMBER && !cagd_is_zero_q(part[1]->number)));
    cagd_tree *copy = is ? cagd_tree_new(CAGD_NUMBER, t->from, t->to, 0) : NULL;
    if (copy == NULL)
        return t;
    copy->number = part[1] == NULL ? cagd_neg_q(part[0]->number) : cagd_div_q(part[0]->number, part[1]->number);
    return copy;
}

/* Whether it can stand for a function of so many arguments. */
static int is_function_of(cagd_reader *r, const cagd_tree *t, int arity)
{
    if (t->kind == CAGD_NUMBER)
        return 1;
    if (!cagd_is_bare_function(r, t) || t->times != NULL || t->dimension > 0)
        return 0;
    for (const struct cagd_bound *b = r->bound; b != NULL; b = b->next)
        if (strcmp(b->head, t->head) == 0)
            return b->arity == arity;
    const cagd_definition *d = cagd_defined(r->scope, t->head);
    return d->functions == 0 && d->left->before_semicolon <= arity && arity <= d->left->arguments;
}

const cagd_tree *cagd_put_in_functional(cagd_reader *r, const cagd_definition *d, const cagd_tree *t)
{
    const cagd_tree *given[CAGD_MOST_CHILDREN] = {0};
    const char *name = cagd_spelled(t->head);
    if (d->body == NULL)
        return cagd_refuse_tree(r, t, "%s, which is of functions, is defined by itself", name);
    if (t->arguments == 0)
        return cagd_refuse_tree(r, t, "%s was defined of a function: write which, %s(f)", name, name);
    if (t->order > 0 || t->times != NULL)
        return cagd_refuse_tree(r, t, "%s is of functions: write its derivative as \\frac{d}{dx}", name);
    for (int k = 0; k < t->count; k++) {
        int is_function = d->functions >> k & 1;
        given[k] = is_function ? as_number(t->at[k]) : t->at[k];
        if (is_function && !is_function_of(r, given[k], d->arity))
            return cagd_refuse_tree(
                r, t->at[k],
                "%s of %s is a function: write the name of one of %d argument%s, such as e_1 behind "
                "e_i(t) = t^i, or a number",
                d->left->at[k]->head, name, d->arity, d->arity == 1 ? "" : "s");
        if (!is_function && cagd_is_bare_function(r, t->at[k]))
            return cagd_refuse_tree(r, t->at[k], "%s of %s is a number, and no function", d->left->at[k]->head, name);
    }
    struct change c = {.r = r, .left = d->left, .given = given, .functions = d->functions};
    const char *letter = caught(&c, d->body);
    if (letter == NULL && d->when != NULL)
        letter = caught(&c, d->when);
    if (letter != NULL)
        return cagd_refuse_tree(r, t, "%s is bound in the definition of %s: take another letter here", letter, name);
    const cagd_tree *body = changed(&c, d->body), *when = body != NULL && d->when != NULL ? changed(&c, d->when) : NULL;
    if (body != NULL && when != NULL)
        return cagd_new_of(r, CAGD_CASES, t->from, 2, (const cagd_tree *[]){body, when});
    cagd_tree *copy = body != NULL && d->when == NULL ? cagd_new(r, body->kind, t->from, body->count) : NULL;
    if (copy == NULL)
        return NULL;
    const cagd_tree **at = copy->at;
    *copy = *body, copy->at = at, copy->from = t->from, copy->to = t->to;
    for (int k = 0; k < body->count; k++)
        at[k] = body->at[k];
    return copy;
}
