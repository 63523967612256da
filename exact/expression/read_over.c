/* read_over.c -- fractions and derivatives, sums and products over an index, integrals. */
#include "exact/expression/depends.h"
#include "exact/expression/reader.h"
#include "exact/words.h"

#include <stdio.h>
#include <string.h>

/* ---- fractions and derivatives ------------------------------------------------------------------------- */

int cagd_differential(const cagd_reader *r, const cagd_token *t)
{
    if (strcmp(t->word, "\\partial") == 0)
        return 1;
    if (strcmp(t->word, "d") == 0)
        return !cagd_is_known(r, "d");
    int upright = strcmp(t->word, "\\mathrm") == 0 || strcmp(t->word, "\\operatorname") == 0 ||
                  strcmp(t->word, "\\text") == 0 || strcmp(t->word, "\\textrm") == 0;
    if (!upright)
        return 0;
    if (strcmp(t[1].word, "d") == 0)
        return 1 + 1;
    return strcmp(t[1].word, "{") == 0 && strcmp(t[2].word, "d") == 0 && strcmp(t[3].word, "}") == 0 ? 4 : 0;
}

/* A letter by which there is a derivative, or a name with a lower index; and how often, NULL: once. */
struct by {
    const char *head;
    const cagd_tree *name, *order;
};

/* What stands behind the sign of a differential: w, w_1, w^2, w_1^2. */
static int by_what(cagd_reader *r, struct by *by)
{
    char text[80];
    const cagd_token *first = r->token;
    *by = (struct by){.head = cagd_read_head(r)};
    if (by->head == NULL)
        return 0;
    if (cagd_pass(r, "_")) {
        const cagd_tree *index = cagd_read_argument(r, 1);
        if (index == NULL)
            return 0;
        int n = snprintf(text, sizeof text, "%s_", by->head);
        by->head = n < (int)sizeof text ? cagd_text_of(text, n) : by->head;
        const cagd_variable *v = cagd_declared(r->scope, by->head);
        cagd_tree *name = cagd_new_of(r, CAGD_NAME, first->from, 1, &index);
        if (name == NULL)
            return 0;
        if (v == NULL || v->lower != 1 || v->upper > 0 || v->dimension > 0)
            return cagd_refuse_tree(r, name, "%s was not declared with one index", cagd_spelled(by->head)) != NULL;
        name->head = by->head, name->lower = 1;
        by->name = name;
    } else if (!cagd_is_known(r, by->head)) {
        r->token = first;
        return cagd_refuse_token(r, "%s is not defined", by->head) != NULL;
    }
    return !cagd_pass(r, "^") || (by->order = cagd_read_argument(r, 1)) != NULL;
}

/* The definition of a function without its arguments; NULL of anything else. */
static const cagd_definition *bare_function(const cagd_reader *r, const cagd_tree *t)
{
    return cagd_is_bare_function(r, t) ? cagd_defined(r->scope, t->head) : NULL;
}

/* Whether t changes with the letter: it has it, by itself or in a definition, or a function of it without its arguments. */
static int is_changed_by(const cagd_reader *r, const cagd_tree *t, const char *letter)
{
    const cagd_definition *d = bare_function(r, t);
    if (d != NULL && cagd_tree_has(d->left, letter))
        return 1;
    for (int k = 0; k < t->count; k++)
        if (is_changed_by(r, t->at[k], letter))
            return 1;
    return cagd_tree_has(t, letter) || cagd_depends_on(r->scope, t, letter);
}

static int has_function(const cagd_reader *r, const cagd_tree *t)
{
    const cagd_definition *d = t->kind == CAGD_NAME ? cagd_defined(r->scope, t->head) : NULL;
    int has = d != NULL && d->left->arguments > 0;
    for (int k = 0; k < t->count && !has; k++)
        has = has_function(r, t->at[k]);
    return has;
}

/* \frac{d}{dt} f(0), which is 0: nobody writes that of a function. */
static int refuse_constant(cagd_reader *r, const cagd_tree *body, struct by by)
{
    if (by.name != NULL || is_changed_by(r, body, by.head) || !has_function(r, body))
        return 0;
    cagd_refuse_tree(
        r, body,
        "this does not change with %s, so its derivative is 0: is the value of the derivative meant? write f'(0), or "
        "\\left. \\frac{d}{d%s} f(%s) \\right|_{%s=0}",
        cagd_spelled(by.head), by.head, by.head, by.head);
    return 1;
}

/* \frac{d^2 f}{dt^2}(0), the fraction being passed: f''(0). */
static const cagd_tree *derivative_at(cagd_reader *r, const cagd_tree *body, struct by by)
{
    const cagd_definition *d = body != NULL && cagd_next_is(r, "(") ? bare_function(r, body) : NULL;
    const cagd_tree *argument = d != NULL ? d->left->at[d->left->lower + d->left->upper] : NULL;
    long order = 1;
    if (argument == NULL || (d->left->arguments > 1 && d->left->before_semicolon != 1) || argument->kind != CAGD_NAME ||
        strcmp(argument->head, by.head) != 0 ||
        (by.order != NULL &&
         (by.order->kind != CAGD_NUMBER || !cagd_is_whole_in_long(by.order, &order) || order > 100)))
        return NULL;
    cagd_tree *f = cagd_new_of(r, CAGD_NAME, body->from, body->count, body->at);
    if (f == NULL)
        return NULL;
    const cagd_tree **at = f->at;
    *f = *body;
    f->at = at, f->order += (int)order;
    return cagd_read_primed_group(r, f);
}

/* Whether everything from `first` up to the next token stands in one pair of brackets. */
static int is_in_brackets(const cagd_reader *r, const cagd_token *first)
{
    int depth = 0;
    for (const cagd_token *t = first; t < r->token; t++) {
        const char last = t->word[strlen(t->word) - 1];
        depth += (strchr("([{", last) != NULL) - (strchr(")]}", last) != NULL);
        if (depth == 0)
            return t > first && t + 1 == r->token;
    }
    return 0;
}

static int has_letter(const cagd_reader *r, const cagd_tree *t, const char *letter)
{
    return cagd_tree_has(t, letter) || cagd_depends_on(r->scope, t, letter);
}

static int has_tree(const cagd_tree *t, const cagd_tree *part)
{
    int has = cagd_tree_equal(t, part);
    for (int k = 0; k < t->count && !has; k++)
        has = has_tree(t->at[k], part);
    return has;
}

/* Whether t changes with the letter, or the name with an index, that stands below. */
static int depends_on_what(const cagd_reader *r, const cagd_tree *t, const struct by *by)
{
    if (by->name == NULL)
        return has_letter(r, t, by->head);
    int is = has_tree(t, by->name) ||
             (t->kind == CAGD_NAME && cagd_defined(r->scope, t->head) != NULL && has_letter(r, t, by->head));
    for (int k = 0; k < t->count && !is; k++)
        is = depends_on_what(r, t->at[k], by);
    return is;
}

/* d/dt f(t) g(t), of which nobody knows whether g is derived; the first token of the product being `first`. */
static int refuse_second_factor(cagd_reader *r, const cagd_token *first, const cagd_tree *body, const struct by by[],
                                int count)
{
    int found = 0;
    if (body == NULL || is_in_brackets(r, first) || (body->count > 0 && body->at[body->count - 1]->kind == CAGD_AT) ||
        (body->kind != CAGD_PRODUCT && body->kind != CAGD_DOT && body->kind != CAGD_CROSS))
        return 0;
    for (int k = 0; k < body->count; k++) {
        int has = 0;
        for (int m = 0; m < count; m++)
            has |= depends_on_what(r, body->at[k], &by[m]);
        if (has && found++ > 0)
            return cagd_refuse_tree(r, body->at[k],
                                    "is this factor derived as well, or does it stand behind the derivative? write "
                                    "brackets") == NULL;
    }
    return 0;
}

static const cagd_tree *derivative_of(cagd_reader *r, int from, const cagd_tree *body, struct by by)
{
    if (body != NULL && refuse_constant(r, body, by))
        return NULL;
    cagd_tree *t =
        cagd_new_of(r, CAGD_DERIVATIVE, from, by.name != NULL ? 3 : 2, (const cagd_tree *[]){body, by.order, by.name});
    if (t != NULL)
        t->head = by.head;
    return t;
}

/* \partial^3 f / \partial s^2 \partial t, the first letter below being passed: one derivative of another. */
static const cagd_tree *mixed_derivative(cagd_reader *r, int from, const cagd_tree *order, const cagd_tree *body,
                                         struct by first)
{
    struct by by[CAGD_MOST_INDICES] = {first};
    int count = 1, all = 0, sign;
    enum { MOST_ORDER = 1000 };
    while ((sign = cagd_differential(r, r->token)) > 0) {
        if (count == CAGD_MOST_INDICES)
            return cagd_refuse_token(r, "a derivative by more than %d letters", CAGD_MOST_INDICES);
        r->token += sign;
        if (!by_what(r, &by[count++]))
            return NULL;
    }
    for (int k = 0; k < count; k++) {
        if (by[k].order == NULL)
            by[k].order = cagd_tree_number(1, from, from);
        long one;
        if (by[k].order == NULL || by[k].order->kind != CAGD_NUMBER)
            return cagd_refuse_token(r, "the orders of a mixed derivative are numbers");
        if (!cagd_is_whole_in_long(by[k].order, &one) || one < 0 || one > MOST_ORDER)
            return cagd_refuse_token(r, "the orders of a mixed derivative are whole numbers up to %d", MOST_ORDER);
        all += (int)one;
    }
    if (order == NULL || order->kind != CAGD_NUMBER || !cagd_equal_q(order->number, from_int_q(all)))
        return cagd_refuse_token(r, "the orders above and below are not the same");
    if (!cagd_expect(r, "}", "the derivative") || (body != NULL && cagd_refuse_argument(r, body)))
        return NULL;
    const cagd_token *start = r->token;
    if (body == NULL && refuse_second_factor(r, start, body = cagd_read_product(r), by, count))
        return NULL;
    while (body != NULL && count > 0)
        body = derivative_of(r, from, body, by[--count]);
    return body;
}

/* Of d/dt f(t)|_{t=a}, read as the derivative of f(a), the value at a of the derivative of f(t), which is meant; so of several places,
 * |_{s=a, t=b}.  `t` is the derivative. */
static const cagd_tree *value_behind(cagd_reader *r, cagd_tree *t)
{
    const cagd_tree *place[CAGD_MOST_INDICES], *last = t != NULL ? t->at[0] : NULL;
    int places = 0, is_product = last != NULL && last->kind == CAGD_PRODUCT;
    if (is_product)
        last = last->at[last->count - 1];
    for (; last != NULL && last->kind == CAGD_AT && places < CAGD_MOST_INDICES; last = last->at[0])
        place[places++] = last;
    if (places == 0)
        return t;
    if (is_product)
        return cagd_refuse_tree(
            r, place[0],
            "the value at a place of the derivative, or of its last factor: put what has it between "
            "\\left. and \\right|");
    t->at[0] = last;
    const cagd_tree *value = t;
    while (value != NULL && places-- > 0) {
        cagd_tree *at = cagd_new_of(r, CAGD_AT, t->from, 2, (const cagd_tree *[]){value, place[places]->at[1]});
        if (at != NULL)
            at->head = place[places]->head;
        value = at;
    }
    return value;
}

/* d^k f / d t^k, the brace of the numerator being passed, if it has braces; the body f may follow the fraction. */
static const cagd_tree *derivative(cagd_reader *r, int from, int braces)
{
    const int is_partial = cagd_next_is(r, "\\partial");
    r->token += cagd_differential(r, r->token);
    const cagd_tree *order = NULL, *body = NULL;
    if (cagd_pass(r, "^") && (order = cagd_read_argument(r, 1)) == NULL)
        return NULL;
    if (braces && !cagd_next_is(r, "}") && (body = cagd_read_sum(r)) == NULL)
        return NULL;
    if ((braces && !cagd_expect(r, "}", "the numerator")) || !cagd_expect(r, "{", "the numerator"))
        return NULL;
    int sign = cagd_differential(r, r->token);
    if (sign == 0)
        return cagd_refuse_token(r, "expected d and a letter below the derivative, not %s", cagd_name_of_next(r));
    r->token += sign;
    struct by by;
    if (!by_what(r, &by))
        return NULL;
    if (cagd_differential(r, r->token) > 0)
        return mixed_derivative(r, from, order, body, by);
    if ((order == NULL) != (by.order == NULL) || (order != NULL && !cagd_tree_equal(order, by.order)))
        return cagd_refuse_token(r, "the orders above and below are not the same");
    if (!cagd_expect(r, "}", "the derivative"))
        return NULL;
    const cagd_tree *value = derivative_at(r, body, by);
    if (value != NULL || r->error->message[0] != '\0')
        return value;
    if (body != NULL && cagd_refuse_argument(r, body))
        return NULL;
    int follows = body == NULL;
    const cagd_token *start = r->token;
    if (follows && refuse_second_factor(r, start, body = cagd_read_product(r), &by, 1))
        return NULL;
    if (by.order == NULL)
        by.order = cagd_tree_number(1, from, from);
    cagd_tree *t = (cagd_tree *)derivative_of(r, from, body, by);
    if (t != NULL)
        t->order = is_partial;
    return follows && by.name == NULL ? value_behind(r, t) : t;
}

const cagd_tree *cagd_read_fraction(cagd_reader *r, int from)
{
    if (cagd_next_is(r, "{") && cagd_differential(r, r->token + 1) > 0) {
        const cagd_token *second = r->token;
        for (int depth = 0; second->kind != CAGD_TOKEN_END; second++) {
            depth += (strcmp(second->word, "{") == 0) - (strcmp(second->word, "}") == 0);
            if (depth == 0)
                break;
        }
        if (second->kind != CAGD_TOKEN_END && strcmp(second[1].word, "{") == 0 &&
            cagd_differential(r, second + 2) > 0) {
            r->token++;
            return derivative(r, from, 1);
        }
    }
    if (cagd_next_is(r, "\\partial") && strcmp(r->token[1].word, "{") == 0 && cagd_differential(r, r->token + 2) > 0)
        return derivative(r, from, 0);                                        /* \frac\partial{\partial t} */
    if (r->token->kind == CAGD_TOKEN_NUMBER && strlen(r->token->word) == 2) { /* \frac12 */
        const char *digits = (r->token++)->word;
        const cagd_tree *half[2];
        for (int k = 0; k < 2; k++) {
            if (digits[k] < '0' || digits[k] > '9')
                return cagd_refuse_token(r, "write \\frac{...}{...}");
            half[k] = cagd_tree_number(digits[k] - '0', from, r->token[-1].to);
        }
        return cagd_new_of(r, CAGD_QUOTIENT, from, 2, half);
    }
    const cagd_tree *a = cagd_read_argument(r, 0), *b = a != NULL ? cagd_read_argument(r, 0) : NULL;
    return cagd_new_of(r, CAGD_QUOTIENT, from, 2, (const cagd_tree *[]){a, b});
}

const cagd_tree *cagd_read_root(cagd_reader *r, int from)
{
    const cagd_tree *n = NULL;
    if (cagd_pass(r, "[")) {
        n = cagd_read_sum(r);
        if (n == NULL || !cagd_expect(r, "]", "the root"))
            return NULL;
    }
    const cagd_tree *a = cagd_read_argument(r, 0);
    if (n == NULL)
        n = cagd_tree_number(2, from, from);
    return cagd_new_of(r, CAGD_ROOT, from, 2, (const cagd_tree *[]){a, n});
}

/* ---- sums and products over an index ------------------------------------------------------------------- */

/* The letter of an index, which has to be new. */
static const char *index_letter(cagd_reader *r)
{
    const cagd_token *t = r->token;
    const char *head = cagd_read_head(r);
    if (head != NULL &&
        (cagd_is_bound(r, head) || cagd_declared(r->scope, head) != NULL || cagd_defined(r->scope, head) != NULL)) {
        r->token = t;
        return cagd_refuse_token(r, "the index %s has a meaning already: take another letter", head), NULL;
    }
    return head;
}

enum { MOST_CONDITIONS = 6 };

/* The indices, the first outside; each runs from its low to its high end, in which those before it may stand.  The high end of all is
 * `end` where they have none of their own. */
struct range {
    int count;
    const char *head[CAGD_MOST_INDICES];
    const cagd_tree *low[CAGD_MOST_INDICES], *high[CAGD_MOST_INDICES], *end;
    const cagd_tree *condition[MOST_CONDITIONS];
    int conditions, between; /* between: written as low \le i \le high */
    struct cagd_bound bound[CAGD_MOST_INDICES];
};

static void bind_all(cagd_reader *r, struct range *a)
{
    for (int k = 0; k < a->count; k++) {
        a->bound[k] = (struct cagd_bound){a->head[k], r->bound, 0};
        r->bound = &a->bound[k];
    }
}

/* One more index, which has to be another one. */
static int add_index(cagd_reader *r, struct range *a)
{
    if (a->count == CAGD_MOST_INDICES)
        return cagd_refuse_token(r, "more than %d indices", CAGD_MOST_INDICES) != NULL;
    const char *head = index_letter(r);
    for (int k = 0; k < a->count && head != NULL; k++)
        if (strcmp(head, a->head[k]) == 0)
            return cagd_refuse_token(r, "the index %s is there twice", head) != NULL;
    if (head != NULL)
        a->head[a->count++] = head;
    return head != NULL;
}

/* i=0, or i,j=0. */
static int from_one_end(cagd_reader *r, struct range *a)
{
    do
        if (!add_index(r, a))
            return 0;
    while (cagd_pass(r, ","));
    if (!cagd_expect(r, "=", "the index"))
        return 0;
    cagd_list list;
    int is_list = cagd_read_list(r, a->head[0], &list);
    for (int k = 0; k < a->count; k++)
        a->low[k] = list.low;
    if (is_list > 0 && (list.count > 0 || list.step > 1))
        return cagd_refuse_tree(r, list.high,
                                "the index of a sum or product runs through all whole numbers between its ends: write "
                                "k = 0, and what stands for %s by k",
                                a->head[0]) != NULL;
    if (is_list > 0 && list.high == NULL)
        return cagd_refuse_tree(r, list.low, "a sum or product without an end") != NULL;
    a->end = is_list > 0 ? list.high : NULL;
    return is_list >= 0;
}

/* The next token is < or \le, and is passed; whether it is <. */
static int pass_less(cagd_reader *r, int *strict)
{
    cagd_relation relation;
    if (!cagd_relation_next(r, &relation) || (relation != CAGD_LESS_OR_EQUAL && relation != CAGD_LESS))
        return cagd_refuse_token(r, "expected a range such as {i=0}, {0 \\le i \\le n} or {i+j=n}") != NULL;
    *strict = relation == CAGD_LESS;
    r->token++;
    return 1;
}

/* end + by, if there is a by. */
static const cagd_tree *moved(cagd_reader *r, const cagd_tree *end, long by)
{
    if (end == NULL || by == 0)
        return end;
    return cagd_new_of(r, CAGD_SUM, end->from, 2, (const cagd_tree *[]){end, cagd_tree_number(by, end->to, end->to)});
}

/* A name that the text has elsewhere: its place is that of what was read last. */
static const cagd_tree *name_of_index(cagd_reader *r, const char *head)
{
    cagd_tree *t = cagd_new(r, CAGD_NAME, r->token[-1].from, 0);
    if (t != NULL)
        t->head = head;
    return t;
}

/* 0 \le i \le n, 0 \le i < j \le n, 0 \le i, j \le n. */
static int between_ends(cagd_reader *r, struct range *a)
{
    int strict, first = 1;
    a->between = 1;
    const cagd_tree *low = cagd_read_sum(r);
    if (low == NULL || !pass_less(r, &strict))
        return 0;
    low = moved(r, low, strict);
    do {
        do {
            if (!add_index(r, a))
                return 0;
            a->low[a->count - 1] = low;
        } while (cagd_pass(r, ","));
        if (low == NULL || !pass_less(r, &strict))
            return 0;
        first = a->count;
        low = moved(r, name_of_index(r, a->head[first - 1]), strict);
    } while (r->token->kind == CAGD_TOKEN_LETTER && !cagd_is_known(r, r->token->word) &&
             strcmp(r->token->word, a->head[first - 1]) != 0 &&
             (strcmp(r->token[1].word, "<") == 0 || strcmp(r->token[1].word, "\\le") == 0));
    a->end = moved(r, cagd_read_sum(r), strict ? -1 : 0);
    return a->end != NULL;
}

/* How many letters stand here with + between and a relation behind them, as in i+j=n; 0 where they do not. */
static int letters_of_amount(const cagd_reader *r)
{
    int count = 1;
    const cagd_token *t = r->token;
    for (; t->kind == CAGD_TOKEN_LETTER && strcmp(t[1].word, "+") == 0; t += 2)
        count++;
    return count > 1 && t->kind == CAGD_TOKEN_LETTER &&
                   (strcmp(t[1].word, "=") == 0 || strcmp(t[1].word, "<") == 0 || strcmp(t[1].word, "\\le") == 0)
               ? count
               : 0;
}

/* i + j = n, i + j + k \le n, all at least 0: the ends are n, n - i, n - i - j, and with = the last one has this value alone. */
static int of_one_amount(cagd_reader *r, struct range *a)
{
    do
        if (!add_index(r, a))
            return 0;
    while (cagd_pass(r, "+"));
    int strict = 0, equal = cagd_pass(r, "="), from = r->token->from;
    if (!equal && !pass_less(r, &strict))
        return 0;
    const cagd_tree *rest = moved(r, cagd_read_sum(r), strict ? -1 : 0);
    for (int k = 0; k < a->count && rest != NULL; k++) {
        a->low[k] = cagd_tree_number(0, from, from), a->high[k] = rest;
        if (equal && k + 1 == a->count) { /* where n - i - j is below 0 there is none */
            a->low[k] = cagd_new_of(r, CAGD_MAXIMUM, from, 2, (const cagd_tree *[]){a->low[k], rest});
            continue;
        }
        const cagd_tree *index = name_of_index(r, a->head[k]);
        const cagd_tree *minus = cagd_new_of(r, CAGD_NEGATIVE, from, 1, &index);
        rest = cagd_new_of(r, CAGD_SUM, from, 2, (const cagd_tree *[]){rest, minus});
    }
    return rest != NULL && a->low[a->count - 1] != NULL;
}

/* One condition; i, j \ge 0 is one of each. */
static int read_condition(cagd_reader *r, struct range *a)
{
    const char *other[CAGD_MOST_INDICES];
    int others = 0;
    while (r->token->kind == CAGD_TOKEN_LETTER && strcmp(r->token[1].word, ",") == 0 &&
           cagd_is_bound(r, r->token->word) && others < CAGD_MOST_INDICES) {
        other[others++] = r->token->word;
        r->token += 2;
    }
    const cagd_tree *said = cagd_read_relations(r);
    for (int k = -1; said != NULL && k < others; k++) {
        if (a->conditions == MOST_CONDITIONS)
            return cagd_refuse_token(r, "more than %d conditions", MOST_CONDITIONS) != NULL;
        const cagd_tree *condition = said;
        if (k >= 0) {
            cagd_tree *copy = said->kind == CAGD_RELATION ? cagd_new(r, CAGD_RELATION, said->from, said->count) : NULL;
            if (copy == NULL)
                return cagd_refuse_tree(r, said, "expected a condition such as i, j \\ge 0") != NULL;
            for (int m = 0; m < said->count; m++)
                copy->at[m] = m > 0 ? said->at[m] : name_of_index(r, other[k]);
            copy->relation = said->relation;
            condition = copy;
        }
        a->condition[a->conditions++] = condition;
    }
    return said != NULL;
}

/* What stands below: i=0, or 0 \le i \le n, or i+j=n, and conditions behind commas, or below one another. */
static int below(cagd_reader *r, struct range *a)
{
    static const char *const expected = "expected a range such as {i=0}, {0 \\le i \\le n} or {i+j=n}";
    if (!cagd_pass(r, "{"))
        return cagd_refuse_token(r, "%s, not %s", expected, cagd_name_of_next(r)) != NULL;
    int stack = cagd_pass(r, "\\substack");
    if (stack && !cagd_expect(r, "{", "\\substack"))
        return 0;
    int pair = r->token->kind == CAGD_TOKEN_LETTER && strcmp(r->token[1].word, ",") == 0 &&
               r->token[2].kind == CAGD_TOKEN_LETTER;
    int one_end = pair || (cagd_begins_name(r) && strcmp(r->token[1].word, "=") == 0);
    if (!one_end && letters_of_amount(r) == 0 &&
        (cagd_next_is(r, "|") || (r->token->kind == CAGD_TOKEN_LETTER && !cagd_is_known(r, r->token->word))))
        return cagd_refuse_token(r, "%s", expected) != NULL;
    if (!(one_end ? from_one_end : letters_of_amount(r) > 0 ? of_one_amount : between_ends)(r, a))
        return 0;
    const struct cagd_bound *outside = r->bound;
    int read = 1;
    bind_all(r, a);
    while (read && (cagd_pass(r, ",") || (stack && cagd_pass(r, "\\\\"))))
        read = read_condition(r, a);
    r->bound = outside; /* what cannot be read may be read otherwise, without these */
    return read && (!stack || cagd_expect(r, "}", "the range")) && cagd_expect(r, "}", "the range");
}

/* _{t \in [0,1]}, _{0 \le t \le 1} for a letter that has a meaning. */
static int is_over_a_number(const cagd_reader *r)
{
    int is = 0;
    for (const cagd_token *t = r->token; t->kind != CAGD_TOKEN_END && strcmp(t->word, "}") != 0; t++)
        is |= strcmp(t->word, "\\in") == 0 ||
              (t > r->token && t->kind == CAGD_TOKEN_LETTER && strcmp(t[-1].word, "\\le") == 0 &&
               strcmp(t[1].word, "\\le") == 0 && cagd_is_known(r, t->word));
    return is;
}

/* Whether the letter is an index of a name, or stands in one. */
static int is_index_of_name(const cagd_tree *t, const char *letter)
{
    for (int k = 0; k < t->count; k++)
        if ((t->kind == CAGD_NAME && k < t->lower + t->upper && cagd_tree_has(t->at[k], letter)) ||
            is_index_of_name(t->at[k], letter))
            return 1;
    return 0;
}

/* Behind the factors with the index of a product, or of a greatest value, may stand others, which nobody knows to be inside or behind it. */
static int refuse_factor_behind(cagd_reader *r, const cagd_token *first, const cagd_tree *body, const struct range *a,
                                const char *sign)
{
    int last = -1;
    if (body->kind != CAGD_PRODUCT || is_in_brackets(r, first))
        return 0;
    for (int k = 0; k < body->count; k++)
        for (int m = 0; m < a->count; m++)
            if (has_letter(r, body->at[k], a->head[m]))
                last = k;
    return last >= 0 && last + 1 < body->count &&
           cagd_refuse_tree(r, body->at[last + 1], "does this stand inside the %s, or behind it? write brackets",
                            sign) == NULL;
}

static const cagd_tree *over_one(cagd_reader *r, cagd_tree_kind kind, int from, const char *head,
                                 const cagd_tree *const ends[2], const cagd_tree *body, int conditions,
                                 const cagd_tree *const condition[])
{
    cagd_tree *t = cagd_new(r, kind, from, 3 + conditions);
    if (t == NULL)
        return NULL;
    t->head = head;
    t->at[0] = ends[0], t->at[1] = ends[1], t->at[2] = body;
    for (int k = 0; k < conditions; k++)
        t->at[3 + k] = condition[k];
    return cagd_with_dimension(r, t);
}

const cagd_tree *cagd_read_over(cagd_reader *r, cagd_tree_kind kind, int from)
{
    struct range a = {0};
    int is_extremum = kind == CAGD_MAXIMUM_OVER || kind == CAGD_MINIMUM_OVER;
    const char *sign = kind == CAGD_SUM_OVER       ? "sum"
                       : kind == CAGD_PRODUCT_OVER ? "product"
                                                   : "greatest or smallest value";
    const cagd_token *start = r->token;
    const cagd_tree *above = NULL;
    if (cagd_pass(r, "^") && (above = cagd_read_argument(r, 1)) == NULL) /* \sum^n_{i=0} */
        return NULL;
    if (!cagd_pass(r, "_")) {
        r->token = start;
        return cagd_refuse_token(r, "over what is the %s? expected _{i=0}^{n}", sign);
    }
    if (is_extremum && is_over_a_number(r))
        return cagd_refuse_token(
            r, "the greatest value for all of a variable is not computed: say f(t) \\le c for all, and where f(t) = c");
    if (!below(r, &a))
        return NULL;
    if (above != NULL && (a.end != NULL || a.high[0] != NULL))
        return cagd_refuse_tree(r, above, "the range below has its upper end already");
    if (above != NULL) {
        a.end = above;
    } else if (a.end == NULL && a.high[0] == NULL) {
        if (!cagd_pass(r, "^"))
            return cagd_refuse_token(r, "up to what is the %s? expected ^{n}", sign);
        a.end = cagd_read_argument(r, 1);
        if (a.end == NULL)
            return NULL;
    }
    const struct cagd_bound *outside = r->bound;
    bind_all(r, &a);
    const cagd_token *first = r->token;
    const cagd_tree *body = cagd_read_product_in(r, kind, a.head[0]);
    r->bound = outside;
    if (body != NULL && kind != CAGD_SUM_OVER && refuse_factor_behind(r, first, body, &a, sign))
        return NULL;
    for (int k = 0; k < a.count && body != NULL && is_extremum && a.between; k++)
        if (!cagd_is_usual_index(a.head[k]) && !is_index_of_name(body, a.head[k])) {
            r->token = start;
            return cagd_refuse_token(
                r,
                "is %s a whole number here? of all real ones no greatest value is computed: say "
                "f(%s) \\le c for all, and where f(%s) = c; for whole numbers write %s = 0 below and "
                "the last one above",
                a.head[k], a.head[k], a.head[k], a.head[k]);
        }
    int conditions = a.conditions; /* they are of all indices, and stand with the innermost */
    for (int k = a.count - 1; k >= 0 && body != NULL; k--, conditions = 0)
        body =
            over_one(r, kind, from, a.head[k], (const cagd_tree *[]){a.low[k], a.high[k] != NULL ? a.high[k] : a.end},
                     body, conditions, a.condition);
    return body;
}

const cagd_tree *cagd_read_integral(cagd_reader *r, int from)
{
    const cagd_tree *low = NULL, *high = NULL;
    for (int k = 0; k < 2; k++)
        if (cagd_pass(r, "_"))
            low = cagd_read_argument(r, 1);
        else if (cagd_pass(r, "^"))
            high = cagd_read_argument(r, 1);
    if (low == NULL || high == NULL)
        return cagd_refuse_token(r, "from where to where is the integral? expected \\int_a^b ... dt");
    /* The letter of the variable stands behind the integrand, and has to be known in it; integrals inside have their own. */
    const cagd_token *end = r->token;
    for (int inside = 0; end->kind != CAGD_TOKEN_END; end++) {
        int ends = cagd_differential(r, end) > 0 && end[cagd_differential(r, end)].kind == CAGD_TOKEN_LETTER;
        inside += strcmp(end->word, "\\int") == 0;
        if (ends && inside-- == 0)
            break;
    }
    if (end->kind == CAGD_TOKEN_END)
        return cagd_refuse_token(r, "by what is the integral? expected d and a letter at its end");
    struct cagd_bound bound = {end[cagd_differential(r, end)].word, r->bound, 0};
    r->bound = &bound;
    r->integrals++;
    const cagd_tree *body =
        r->token == end ? cagd_tree_number(1, end->from, end->to) : cagd_read_sum(r); /* \int_0^1 dt */
    r->integrals--;
    r->bound = bound.next;
    if (body == NULL)
        return NULL;
    if (cagd_differential(r, r->token) == 0 || r->token != end)
        return cagd_refuse_token(r, "expected d%s at the end of the integral, not %s", bound.head,
                                 cagd_name_of_next(r));
    r->token += cagd_differential(r, r->token) + 1;
    cagd_tree *t = cagd_new_of(r, CAGD_INTEGRAL, from, 3, (const cagd_tree *[]){low, high, body});
    if (t != NULL)
        t->head = bound.head;
    return t;
}
