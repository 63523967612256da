/* read_truth.c -- implications, "or", "not", and quantifiers over finitely many whole numbers.
 *
 *     \forall i \in \{0, \dots, n\}: ...      \exists i = 0..n: ...
 *     A \Rightarrow B      A \iff B      B \text{ if } A      A \lor B      \neg (A)
 *
 * A comma between conditions is "and", and binds closer than these. */
#include "exact/expression/reader.h"
#include "exact/words.h"

#include <string.h>

enum { MOST_NAMES = 2 * CAGD_MOST_INDICES };

/* Whether these words come next, as text; then they are passed. */
static int pass_words(cagd_reader *r, const char *const words[])
{
    const cagd_token *here = r->token;
    const char *said = cagd_read_words(r);
    for (int k = 0; said != NULL && words[k] != NULL; k++)
        if (strcmp(said, words[k]) == 0)
            return 1;
    r->token = here;
    return 0;
}

/* Whether "or" and the like come anywhere behind: what is in brackets is meant as a truth. */
static int has_connective(const cagd_token *t)
{
    static const char *const words[] = {"\\lor",       "\\land", "\\neg",    "\\Rightarrow",
                                        "\\Leftarrow", "\\iff",  "\\forall", "\\exists"};
    for (; t->kind != CAGD_TOKEN_END; t++)
        for (size_t k = 0; k < sizeof words / sizeof *words; k++)
            if (strcmp(t->word, words[k]) == 0)
                return 1;
    return 0;
}

const cagd_tree *cagd_read_condition(cagd_reader *r)
{
    int from = r->token->from, depth = r->depth;
    const cagd_token *here = r->token;
    if (cagd_pass(r, "\\neg")) {
        const cagd_tree *a = cagd_read_condition(r);
        return a != NULL ? cagd_new_of(r, CAGD_NOT, from, 1, &a) : NULL;
    }
    if (cagd_next_is(r, "\\forall") || cagd_next_is(r, "\\exists"))
        return cagd_read_truth(r);
    const cagd_tree *t = cagd_read_relations(r);
    if (t != NULL || strcmp(here->word, "(") != 0)
        return t;
    cagd_reading_error first = *r->error; /* a truth in brackets, or what was wrong at first */
    r->token = here + 1, r->depth = depth;
    *r->error = (cagd_reading_error){0};
    if (++r->depth > CAGD_MOST_DEPTH)
        return cagd_refuse_token(r, "more than %d levels of brackets", CAGD_MOST_DEPTH);
    t = cagd_read_truth(r);
    r->depth--;
    if (t == NULL || !cagd_pass(r, ")")) {
        if (t != NULL)
            cagd_refuse_token(r, "expected ')' after the bracket, not %s", cagd_name_of_next(r));
        if (!has_connective(here))
            *r->error = first;
        return NULL;
    }
    return t;
}

const cagd_tree *cagd_read_alternatives(cagd_reader *r)
{
    static const char *const words[] = {"or", NULL};
    const cagd_tree *list[CAGD_MOST_CHILDREN];
    int count = 0, from = r->token->from;
    do {
        if (count == CAGD_MOST_CHILDREN)
            return cagd_refuse_token(r, "more than %d conditions", CAGD_MOST_CHILDREN);
        list[count++] = cagd_read_conditions(r);
    } while (list[count - 1] != NULL && (cagd_pass(r, "\\lor") || pass_words(r, words)));
    if (list[count - 1] == NULL || count == 1)
        return list[count - 1];
    return cagd_new_of(r, CAGD_ANY, from, count, list);
}

/* Behind the letter of a quantifier: \in \{low, \dots, high\}, = low..high. */
static int finite_range(cagd_reader *r, const cagd_tree **low, const cagd_tree **high)
{
    int braces = 0;
    if (cagd_pass(r, "\\in"))
        braces = cagd_expect(r, "\\{", "\\in") ? 1 : -1;
    else if (!cagd_expect(r, "=", "the letter of a quantifier"))
        braces = -1;
    r->ends++;
    *low = braces >= 0 ? cagd_read_sum(r) : NULL;
    r->ends--;
    if (*low == NULL)
        return 0;
    while (cagd_pass(r, ",") && !cagd_next_is(r, "\\dots")) /* 0, 1, \dots, n */
        if (cagd_read_sum(r) == NULL)
            return 0;
    if (!cagd_expect(r, "\\dots", "the first number"))
        return 0;
    cagd_pass(r, ",");
    *high = cagd_read_sum(r);
    return *high != NULL && (!braces || cagd_expect(r, "\\}", "the last number"));
}

/* Whether names and an interval come next, t \in [0,1]. */
static int is_interval_ahead(const cagd_reader *r)
{
    const cagd_token *t = r->token;
    while (t->kind != CAGD_TOKEN_END && strcmp(t->word, "\\in") != 0 && strcmp(t->word, ":") != 0)
        t++;
    return cagd_next_is_member(r) && strcmp(t->word, "\\in") == 0 && (t[1].word[0] == '[' || t[1].word[0] == '(');
}

static const cagd_tree *quantified(cagd_reader *r)
{
    int from = r->token->from;
    cagd_tree_kind kind = cagd_next_is(r, "\\forall") ? CAGD_FOR_ALL : CAGD_EXISTS;
    const cagd_tree *low, *high;
    r->token++;
    if (++r->depth > CAGD_MOST_DEPTH)
        return cagd_refuse_token(r, "more than %d levels of brackets", CAGD_MOST_DEPTH);
    if (kind == CAGD_FOR_ALL && is_interval_ahead(r)) { /* what is said of a variable is said of all its values */
        const cagd_tree *within = cagd_read_members(r);
        if (!cagd_pass(r, ":") && !cagd_pass(r, ","))
            cagd_pass(r, ";");
        const cagd_tree *said = within != NULL ? cagd_read_truth(r) : NULL;
        r->depth--;
        return said != NULL ? cagd_new_of(r, CAGD_IMPLIES, from, 2, (const cagd_tree *[]){within, said}) : NULL;
    }
    if (r->token->kind != CAGD_TOKEN_LETTER)
        return cagd_refuse_token(r, "expected a letter, not %s", cagd_name_of_next(r));
    const char *head = (r->token++)->word;
    if (!finite_range(r, &low, &high))
        return NULL;
    if (!cagd_pass(r, ":") && !cagd_pass(r, ","))
        cagd_pass(r, ";");
    struct cagd_bound bound = {head, r->bound};
    r->bound = &bound;
    const cagd_tree *body = cagd_read_truth(r);
    r->bound = bound.next;
    r->depth--;
    if (body == NULL)
        return NULL;
    cagd_tree *t = cagd_new_of(r, kind, from, 3, (const cagd_tree *[]){low, high, body});
    if (t != NULL)
        t->head = head;
    return t;
}

/* Names and nothing else up to the end, "x, y": said of all of them, which is said already. */
static int only_names(cagd_reader *r)
{
    const cagd_token *here = r->token;
    do {
        if (!cagd_begins_name(r) || cagd_read_name(r) == NULL)
            break;
        if (r->token->kind == CAGD_TOKEN_END || (strcmp(r->token->word, ".") == 0))
            return 1;
    } while (cagd_pass(r, ","));
    r->token = here;
    *r->error = (cagd_reading_error){0};
    return 0;
}

int cagd_next_is_member(const cagd_reader *r)
{
    const cagd_token *t = r->token;
    int depth = 0;
    for (; t->kind != CAGD_TOKEN_END && (depth > 0 || strcmp(t->word, "\\in") != 0); t++) {
        cagd_relation relation;
        cagd_reader at = *r;
        at.token = t;
        depth += (strcmp(t->word, "{") == 0) - (strcmp(t->word, "}") == 0);
        int bracket = strcmp(t->word, ")") == 0 || (strcmp(t->word, "(") == 0 && t == r->token);
        if (depth == 0 && !bracket && (cagd_relation_next(&at, &relation) || strchr("+-*/([", t->word[0]) != NULL))
            return 0;
    }
    return t->kind != CAGD_TOKEN_END && (cagd_begins_name(r) || cagd_next_is(r, "("));
}

/* [a, b], and with round brackets an end that does not belong to it. */
static int read_interval(cagd_reader *r, const cagd_tree *end[2], cagd_relation relation[2])
{
    int open = cagd_pass(r, "(");
    if (!open && !cagd_pass(r, "["))
        return cagd_refuse_token(r, "expected an interval such as [0,1]; other sets stand in :for:") != NULL;
    end[0] = cagd_read_sum(r);
    if (end[0] == NULL || !cagd_expect(r, ",", "the low end"))
        return 0;
    end[1] = cagd_read_sum(r);
    int open_above = end[1] != NULL && cagd_pass(r, ")");
    relation[0] = open ? CAGD_LESS : CAGD_LESS_OR_EQUAL;
    relation[1] = open_above ? CAGD_LESS : CAGD_LESS_OR_EQUAL;
    return end[1] != NULL && (open_above || cagd_expect(r, "]", "the high end"));
}

/* The names before \in, in brackets or not. */
static int read_names(cagd_reader *r, const cagd_tree *name[], int *names, int *bracket)
{
    *names = 0, *bracket = cagd_pass(r, "(");
    do {
        if (*names == MOST_NAMES)
            return cagd_refuse_token(r, "too many names before \\in") != NULL;
        name[*names] = cagd_read_name(r);
        if (name[(*names)++] == NULL)
            return 0;
    } while (cagd_pass(r, ","));
    return (!*bracket || cagd_expect(r, ")", "the names")) && cagd_expect(r, "\\in", "the names");
}

/* x \in [a, b], x, y \in (a, b), (x, y) \in [a, b] \times [c, d], (x, y) \in [a, b]^2: a \le x \le b and so on. */
const cagd_tree *cagd_read_members(cagd_reader *r)
{
    static const char *const and[] = {"and", NULL};
    const cagd_tree *name[MOST_NAMES], *list[CAGD_MOST_CHILDREN], *end[2];
    cagd_relation relation[2];
    int from = r->token->from, count = 0, names, bracket;
    do {
        if (!read_names(r, name, &names, &bracket) || !read_interval(r, end, relation))
            return NULL;
        int same = !bracket || names == 1 || cagd_pass(r, "^"); /* one interval for all */
        if (bracket && names > 1 && same && (r->token->word[0] != '0' + names || r->token++->word[1] != '\0'))
            return cagd_refuse_token(r, "expected ^%d for %d names", names, names);
        for (int k = 0; k < names; k++) {
            if (!same && k > 0 && (!cagd_expect(r, "\\times", "the interval") || !read_interval(r, end, relation)))
                return NULL;
            if (count == CAGD_MOST_CHILDREN)
                return cagd_refuse_token(r, "more than %d conditions", CAGD_MOST_CHILDREN);
            list[count] = cagd_relate(r, from, 3, (const cagd_tree *[]){end[0], name[k], end[1]}, relation);
            if (list[count++] == NULL)
                return NULL;
        }
    } while ((cagd_pass(r, ",") || cagd_pass(r, "\\land") || pass_words(r, and)) && cagd_next_is_member(r));
    return count == 1 ? list[0] : cagd_new_of(r, CAGD_ALL, from, count, list);
}

const cagd_tree *cagd_read_truth(cagd_reader *r)
{
    static const char *const if_words[] = {"if", "when", "whenever", "for", "for all", "for every", NULL};
    int from = r->token->from;
    if (cagd_next_is(r, "\\forall") || cagd_next_is(r, "\\exists"))
        return quantified(r);
    const cagd_tree *a = cagd_read_alternatives(r), *b = a;
    if (a == NULL)
        return NULL;
    int implies = cagd_pass(r, "\\Rightarrow"), iff = !implies && cagd_pass(r, "\\iff"),
        implied = !implies && !iff &&
                  (cagd_pass(r, "\\Leftarrow") || (cagd_pass(r, ","), pass_words(r, if_words)) ||
                   cagd_pass(r, "\\forall") || cagd_next_is_member(r));
    if (!implies && !iff && !implied)
        return a;
    if (implied && only_names(r))
        return a;
    b = implies ? cagd_read_truth(r) : cagd_next_is_member(r) ? cagd_read_members(r) : cagd_read_alternatives(r);
    if (b == NULL)
        return NULL;
    const cagd_tree *pair[2] = {implied ? b : a, implied ? a : b};
    return cagd_new_of(r, iff ? CAGD_IFF : CAGD_IMPLIES, from, 2, pair);
}
