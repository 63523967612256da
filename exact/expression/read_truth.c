/* read_truth.c -- implications, "or", "not", and quantifiers over finitely many whole numbers.
 *
 *     \forall i \in \{0, \dots, n\}: ...      \exists i = 0..n: ...
 *     A \Rightarrow B      A \iff B      B \text{ if } A      A \lor B      \neg (A)
 *
 * A comma between conditions is "and", and binds closer than these. */
#include "exact/expression/reader.h"
#include "exact/words.h"

#include <ctype.h>
#include <string.h>

enum { MOST_NAMES = 2 * CAGD_MOST_INDICES };

/* Whether a text says this and nothing else; commas around it, and how it begins, do not count. */
static int is_said(const char *text, const char *words)
{
    while (*text == ',' || *text == ' ')
        text++;
    size_t n = strlen(words);
    if (tolower((unsigned char)text[0]) != words[0] || strncmp(text + 1, words + 1, n - 1) != 0)
        return 0;
    for (text += n; *text == ',' || *text == ' ' || *text == ':';)
        text++;
    return *text == '\0';
}

/* Whether these words come next, as text; then they are passed. */
static int pass_words(cagd_reader *r, const char *const words[])
{
    const cagd_token *here = r->token;
    const char *said = cagd_read_words(r);
    for (int k = 0; said != NULL && words[k] != NULL; k++)
        if (is_said(said, words[k]))
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
    if (cagd_next_is_member(r))
        return cagd_read_members(r);
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
    *high = *low;
    while (cagd_pass(r, ",") && !cagd_next_is(r, "\\dots")) { /* 0, 1, \dots, n, or 0, 1, 2 */
        const cagd_tree *before = *high;
        *high = cagd_read_sum(r);
        if (*high == NULL)
            return 0;
        if (before->kind != CAGD_NUMBER || (*high)->kind != CAGD_NUMBER ||
            !cagd_equal_q((*high)->number, add_q(before->number, from_int_q(1))))
            before = NULL;
        if (before == NULL && !cagd_next_is(r, ","))
            return cagd_refuse_tree(r, *high, "expected whole numbers one behind another, such as 0, 1, 2") != NULL;
    }
    if (braces ? cagd_pass(r, "\\}") : *high != *low && cagd_next_is(r, ":"))
        return 1;
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
    struct cagd_bound bound = {head, r->bound, 0};
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

/* \mathbb{R}, passed. */
static int pass_all_numbers(cagd_reader *r)
{
    const cagd_token *t = r->token;
    int braces = strcmp(t[1].word, "{") == 0;
    if (cagd_pass(r, "\\R"))
        return 1;
    if (strcmp(t->word, "\\mathbb") != 0 || strcmp(t[1 + braces].word, "R") != 0 ||
        (braces && strcmp(t[3].word, "}") != 0))
        return 0;
    r->token += 2 + 2 * braces;
    return 1;
}

/* Names and nothing else up to the end, "x, y", or "x, y \in \mathbb{R}": said of all of them, which is said already. */
static int only_names(cagd_reader *r)
{
    const cagd_token *here = r->token;
    do {
        if (!cagd_begins_name(r) || cagd_read_name(r) == NULL)
            break;
        const cagd_token *in = r->token;
        if (cagd_pass(r, "\\in") && !pass_all_numbers(r))
            r->token = in;
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
    int depth = 0, open = strcmp(t->word, "(") == 0; /* (x, y) \in, and not (x \in */
    for (;
         t->kind != CAGD_TOKEN_END && (depth > 0 || (strcmp(t->word, "\\in") != 0 && strcmp(t->word, "\\notin") != 0));
         t++) {
        cagd_relation relation;
        cagd_reader at = *r;
        at.token = t;
        depth += (strcmp(t->word, "{") == 0) - (strcmp(t->word, "}") == 0);
        open &= strcmp(t->word, ")") != 0;
        int bracket = strcmp(t->word, ")") == 0 || (strcmp(t->word, "(") == 0 && t == r->token);
        if (depth == 0 && !bracket && (cagd_relation_next(&at, &relation) || strchr("+-*/([", t->word[0]) != NULL))
            return 0;
    }
    return t->kind != CAGD_TOKEN_END && !open && (cagd_begins_name(r) || cagd_next_is(r, "("));
}

/* \forall and names that have a meaning already. */
int cagd_forall_of_names(const cagd_reader *r)
{
    cagd_reader at = *r;
    cagd_reading_error none = {0};
    at.error = &none;
    if (!cagd_pass(&at, "\\forall") || !cagd_begins_name(&at))
        return 0;
    const cagd_tree *name = cagd_read_name(&at);
    const cagd_variable *v = name != NULL ? cagd_declared(r->scope, name->head) : NULL;
    return v != NULL && !v->whole;
}

/* Names up to a colon, or up to \in \mathbb{R}: passed with it. */
static int pass_all_numbers_named(cagd_reader *r)
{
    const cagd_token *here = r->token;
    do
        if (!cagd_begins_name(r) || cagd_read_name(r) == NULL)
            break;
    while (cagd_pass(r, ","));
    if (r->error->message[0] == '\0' && (cagd_next_is(r, ":") || (cagd_pass(r, "\\in") && pass_all_numbers(r))))
        return 1;
    r->token = here;
    *r->error = (cagd_reading_error){0};
    return 0;
}

/* [a, b], and with round brackets an end that does not belong to it. */
static int read_interval(cagd_reader *r, const cagd_tree *end[2], cagd_relation relation[2])
{
    int open = cagd_pass(r, "(");
    if (!open && !cagd_pass(r, "["))
        return cagd_refuse_token(r, "expected an interval such as [0,1]; other sets stand in :for:") != NULL;
    int no_low = open && cagd_next_is(r, "-") && strcmp(r->token[1].word, "\\infty") == 0;
    r->token += 2 * no_low;
    end[0] = no_low ? NULL : cagd_read_sum(r);
    if ((end[0] == NULL && !no_low) || !cagd_expect(r, ",", "the low end"))
        return 0;
    int no_high = cagd_next_is(r, "\\infty") || (cagd_next_is(r, "+") && strcmp(r->token[1].word, "\\infty") == 0);
    r->token += no_high ? 1 + cagd_next_is(r, "+") : 0;
    end[1] = no_high ? NULL : cagd_read_sum(r);
    int open_above = (end[1] != NULL || no_high) && cagd_pass(r, ")");
    relation[0] = open ? CAGD_LESS : CAGD_LESS_OR_EQUAL;
    relation[1] = open_above ? CAGD_LESS : CAGD_LESS_OR_EQUAL;
    if (no_low && no_high)
        return cagd_refuse_token(r, "an interval without ends says nothing") != NULL;
    return open_above || ((end[1] != NULL || no_high) && cagd_expect(r, no_high ? ")" : "]", "the high end"));
}

/* low <= name <= high, of the ends that there are. */
static const cagd_tree *between(cagd_reader *r, int from, const cagd_tree *const end[2], const cagd_tree *name,
                                const cagd_relation relation[2])
{
    if (end[0] == NULL)
        return cagd_relate(r, from, 2, (const cagd_tree *[]){name, end[1]}, relation + 1);
    return cagd_relate(r, from, end[1] != NULL ? 3 : 2, (const cagd_tree *[]){end[0], name, end[1]}, relation);
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
    return (!*bracket || cagd_expect(r, ")", "the names")) &&
           (cagd_next_is(r, "\\notin") || cagd_expect(r, "\\in", "the names"));
}

/* The comma, or "and", before more names and \in, if such come next. */
static int pass_to_member(cagd_reader *r)
{
    static const char *const and[] = {"and", NULL};
    const cagd_token *here = r->token;
    if ((cagd_pass(r, ",") || cagd_pass(r, "\\land") || pass_words(r, and)) && cagd_next_is_member(r))
        return 1;
    r->token = here;
    return 0;
}

/* x \in [a, b], x, y \in (a, b), (x, y) \in [a, b] \times [c, d], (x, y) \in [a, b]^2: a \le x \le b and so on. */
const cagd_tree *cagd_read_members(cagd_reader *r)
{
    const cagd_tree *name[MOST_NAMES], *list[CAGD_MOST_CHILDREN], *end[2];
    cagd_relation relation[2];
    int from = r->token->from, count = 0, names, bracket;
    do {
        if (!read_names(r, name, &names, &bracket))
            return NULL;
        int outside = cagd_pass(r, "\\notin");
        if (!read_interval(r, end, relation))
            return NULL;
        if (outside && names > 1)
            return cagd_refuse_token(r, "one name stands before \\notin");
        int same = !bracket || names == 1 || cagd_pass(r, "^"); /* one interval for all */
        if (bracket && names > 1 && same && (r->token->word[0] != '0' + names || r->token++->word[1] != '\0'))
            return cagd_refuse_token(r, "expected ^%d for %d names", names, names);
        for (int k = 0; k < names; k++) {
            if (!same && k > 0 && (!cagd_expect(r, "\\times", "the interval") || !read_interval(r, end, relation)))
                return NULL;
            if (count == CAGD_MOST_CHILDREN)
                return cagd_refuse_token(r, "more than %d conditions", CAGD_MOST_CHILDREN);
            list[count] = between(r, from, end, name[k], relation);
            if (outside)
                list[count] = cagd_new_of(r, CAGD_NOT, from, 1, &list[count]);
            if (list[count++] == NULL)
                return NULL;
        }
    } while (pass_to_member(r));
    return count == 1 ? list[0] : cagd_new_of(r, CAGD_ALL, from, count, list);
}

/* What follows is what is supposed: "if", \forall of names that have a meaning, a bracket with a relation in it, names and \in. */
static int pass_supposed(cagd_reader *r)
{
    static const char *const words[] = {"if",         "when",     "whenever",      "for",      "for all", "for every",
                                        "for any",    "for each", "provided that", "provided", "where",   "with",
                                        "as long as", NULL};
    const cagd_token *here = r->token;
    cagd_pass(r, ",");
    if (pass_words(r, words) || cagd_pass(r, "\\forall") || cagd_next_is_member(r) || cagd_is_truth_in_brackets(r))
        return 1;
    r->token = here;
    return cagd_pass(r, "\\Leftarrow");
}

/* What is supposed, behind what passes it; a round bracket around it is passed. */
static const cagd_tree *supposed(cagd_reader *r)
{
    const cagd_token *here = r->token;
    int bracket = cagd_is_truth_in_brackets(r) && cagd_next_is(r, "(");
    r->token += bracket;
    if (cagd_next_is_member(r) && bracket) {
        const cagd_tree *t = cagd_read_members(r);
        return t != NULL && cagd_expect(r, ")", "the bracket") ? t : NULL;
    }
    r->token = here;
    return cagd_next_is_member(r) ? cagd_read_members(r) : cagd_read_alternatives(r);
}

/* Dots that leave members of a chain out, between `first` and here: of what is supposed every one is needed. */
static int refuse_dots(cagd_reader *r, const cagd_token *first)
{
    if (r->left_out == NULL || r->left_out < first || r->left_out >= r->token)
        return 0;
    r->token = r->left_out;
    cagd_refuse_token(
        r, "what is left out? the ends of the chain do not say it: write \\forall k \\in \\{0, \\dots, n-1\\}: ...");
    return 1;
}

const cagd_tree *cagd_read_truth(cagd_reader *r)
{
    static const char *const if_words[] = {"if", "when", "whenever", "suppose", "suppose that", NULL};
    static const char *const then_words[] = {"then", "implies", "implies that", NULL};
    static const char *const iff_words[] = {"if and only if", "iff", "exactly when", "is equivalent to", NULL};
    const cagd_token *first = r->token, *second;
    int from = first->from, begins_with_if = pass_words(r, if_words);
    if (cagd_next_is(r, "\\forall") || cagd_next_is(r, "\\exists"))
        return quantified(r);
    const cagd_tree *a = cagd_read_alternatives(r), *b = a;
    if (a == NULL)
        return NULL;
    second = r->token;
    cagd_pass(r, ",");
    int implies = pass_words(r, then_words);
    if (!implies)
        r->token = second;
    implies |= cagd_pass(r, "\\Rightarrow");
    if (begins_with_if && !implies)
        return cagd_refuse_token(r, "expected \\text{then} behind what is supposed, not %s", cagd_name_of_next(r));
    int iff = !implies && (cagd_pass(r, "\\iff") || pass_words(r, iff_words)),
        implied = !implies && !iff && pass_supposed(r);
    if (!implies && !iff && !implied)
        return a;
    if (implied && only_names(r))
        return a;
    if ((implies || iff) && refuse_dots(r, first))
        return NULL;
    second = r->token;
    b = implies                  ? cagd_read_truth(r)
        : implied                ? supposed(r)
        : cagd_next_is_member(r) ? cagd_read_members(r)
                                 : cagd_read_alternatives(r);
    if (b == NULL || (!implies && refuse_dots(r, second)))
        return NULL;
    const cagd_tree *pair[2] = {implied ? b : a, implied ? a : b};
    return cagd_new_of(r, iff ? CAGD_IFF : CAGD_IMPLIES, from, 2, pair);
}

/* \forall x, y: A, \forall t \in [0,1]: A, the names having a meaning and A being all that follows: A for all of them, or with that supposed. */
const cagd_tree *cagd_read_for_all_numbers(cagd_reader *r)
{
    const cagd_tree *said[CAGD_MOST_INDICES + 1];
    int count = 0, from = r->token->from;
    while (cagd_forall_of_names(r)) {
        cagd_pass(r, "\\forall");
        if (count == CAGD_MOST_INDICES)
            return cagd_refuse_token(r, "more than %d quantifiers", CAGD_MOST_INDICES);
        if (pass_all_numbers_named(r))
            ;
        else if ((said[count++] = cagd_read_members(r)) == NULL)
            return NULL;
        if (!cagd_pass(r, ":") && !cagd_pass(r, ","))
            cagd_pass(r, ";");
    }
    const cagd_tree *a = cagd_read_truth(r);
    if (a == NULL || count == 0)
        return a;
    if (a->kind == CAGD_IMPLIES)
        said[count++] = a->at[0], a = a->at[1];
    const cagd_tree *all = count > 1 ? cagd_new_of(r, CAGD_ALL, from, count, said) : said[0];
    return cagd_new_of(r, CAGD_IMPLIES, from, 2, (const cagd_tree *[]){all, a});
}
