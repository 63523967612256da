/* read_truth.c -- implications, "or", "not", and quantifiers over finitely many whole numbers.
 *
 *     \forall i \in \{0, \dots, n\}: ...      \exists i = 0..n: ...
 *     A \Rightarrow B      A \iff B      B \text{ if } A      A \lor B      \neg (A)
 *
 * A comma between conditions is "and", and binds closer than these. */
#include "exact/expression/bounds.h"
#include "exact/expression/reader.h"
#include "exact/words.h"

#include <ctype.h>
#include <string.h>

enum { MOST_NAMES = 2 * CAGD_MOST_INDICES };

/* Whether these words come next, as text; then they are passed. */
static int pass_words(cagd_reader *r, const char *const words[])
{
    const cagd_token *here = r->token;
    const char *said = cagd_read_words(r);
    for (int k = 0; said != NULL && words[k] != NULL; k++)
        if (cagd_is_said(said, words[k]))
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

/* A variable stands for all of its numbers, and \forall t \in [0,1]: A is read as t \in [0,1] \Rightarrow A for all t: so it says the same where it
 * stands at the top, in a conjunct, or in a conclusion whose premise has no t.  Under "not" and "or", in a premise and beside \iff it does not,
 * \neg (\forall t: A(t)) being other than \forall t: \neg A(t).  Whether such a quantifier was read from byte `from` on: then an error there. */
static int refuse_ranged(cagd_reader *r, int from, const char *where)
{
    if (r->ranged == NULL || r->ranged->from < from || r->ranged->from >= r->token->from)
        return 0;
    r->token = r->ranged;
    cagd_refuse_token(r,
                      "what is said for all numbers of an interval stands %s: it would be read as said of each number "
                      "alone, and not of "
                      "all of them together; such a quantifier stands around the whole statement, or in its conclusion",
                      where);
    return 1;
}

const cagd_tree *cagd_read_condition(cagd_reader *r)
{
    int from = r->token->from, depth = r->depth;
    const cagd_token *here = r->token;
    if (cagd_pass(r, "\\neg")) {
        const cagd_tree *a = cagd_read_condition(r);
        return a != NULL && !refuse_ranged(r, from, "behind \\neg") ? cagd_new_of(r, CAGD_NOT, from, 1, &a) : NULL;
    }
    if (cagd_next_is(r, "\\forall") || cagd_next_is(r, "\\exists"))
        return cagd_read_truth(r);
    if (cagd_next_is_member(r))
        return cagd_read_members(r);
    if (cagd_next_is_parity(r))
        return cagd_read_parity(r);
    const cagd_tree *t = r->lists > 0 ? cagd_read_list_condition(r) : NULL;
    if (t == NULL && r->error->message[0] == '\0')
        t = cagd_read_relations(r);
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
    int count = 0, from = r->token->from, comma = -1;
    const cagd_token *first = r->token;
    do {
        if (count == CAGD_MOST_CHILDREN)
            return cagd_refuse_token(r, "more than %d conditions", CAGD_MOST_CHILDREN);
        list[count++] = cagd_read_conditions(r);
        comma = comma < 0 ? r->comma : comma;
    } while (list[count - 1] != NULL && (cagd_pass(r, "\\lor") || pass_words(r, words)));
    if (list[count - 1] == NULL || count == 1)
        return list[count - 1];
    if (comma >= 0) {
        for (r->token = first; r->token->from < comma && r->token->kind != CAGD_TOKEN_END;)
            r->token++;
        return cagd_refuse_token(
            r, "a comma beside \"or\": (A, B) \\lor C, or A, (B \\lor C)? write the brackets, or \\land");
    }
    r->comma = -1;
    if (refuse_ranged(r, from, "beside \"or\""))
        return NULL;
    return cagd_new_of(r, CAGD_ANY, from, count, list);
}

/* Behind the letter of a quantifier: \in \{low, \dots, high\}, = low..high, \in \{0, 2, 4\}. */
static int finite_range(cagd_reader *r, const char *letter, cagd_list *list)
{
    int braces = 0;
    if (cagd_pass(r, "\\in"))
        braces = cagd_expect(r, "\\{", "\\in") ? 1 : -1;
    else if (!cagd_expect(r, "=", "the letter of a quantifier"))
        braces = -1;
    int is_list = braces >= 0 ? cagd_read_list(r, letter, list) : -1;
    if (is_list == 0 && !braces)
        return cagd_expect(r, "\\dots", "the first number");
    if (is_list == 0)
        list->high = list->low;
    if (is_list > 0 && list->high == NULL)
        return cagd_refuse_tree(r, list->low, "a quantifier goes over finitely many whole numbers") != NULL;
    return is_list >= 0 && (!braces || cagd_expect(r, "\\}", "the last number"));
}

const cagd_tree *cagd_over_list(cagd_reader *r, cagd_tree_kind kind, int from, const char *letter,
                                const cagd_list *list, const cagd_tree *body)
{
    const cagd_tree *one[CAGD_MOST_CHILDREN], *low = list->low, *high = list->high;
    for (int k = 0; k < list->count; k++)
        one[k] = cagd_tree_with(body, letter, list->listed[k]);
    if (list->count > 0) { /* what one formula says of several numbers: no part of it is supposed for the others */
        cagd_tree *all =
            (cagd_tree *)cagd_new_of(r, kind == CAGD_FOR_ALL ? CAGD_ALL : CAGD_ANY, from, list->count, one);
        if (all != NULL)
            all->juxtaposed = 1;
        return all;
    }
    if (list->step > 1) { /* low + step * k for k = 0, ..., (high - low)/step, the letter being k */
        cagd_tree *k = cagd_new(r, CAGD_NAME, from, 0);
        const cagd_tree *step = cagd_tree_number(list->step, from, low->to),
                        *minus = cagd_new_of(r, CAGD_NEGATIVE, from, 1, &low);
        if (k == NULL)
            return NULL;
        k->head = letter;
        const cagd_tree *steps = cagd_new_of(r, CAGD_PRODUCT, from, 2, (const cagd_tree *[]){step, k});
        const cagd_tree *member = cagd_new_of(r, CAGD_SUM, from, 2, (const cagd_tree *[]){low, steps});
        const cagd_tree *length = cagd_new_of(r, CAGD_SUM, from, 2, (const cagd_tree *[]){high, minus});
        body = member != NULL ? cagd_tree_with(body, letter, member) : NULL;
        low = cagd_tree_number(0, from, low->to);
        high = cagd_new_of(r, CAGD_QUOTIENT, from, 2, (const cagd_tree *[]){length, step});
    }
    cagd_tree *t = cagd_new_of(r, kind, from, 3, (const cagd_tree *[]){low, high, body});
    if (t != NULL)
        t->head = letter;
    return t;
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
    const cagd_token *sign = r->token;
    cagd_tree_kind kind = cagd_next_is(r, "\\forall") ? CAGD_FOR_ALL : CAGD_EXISTS;
    cagd_list list;
    r->token++;
    if (++r->depth > CAGD_MOST_DEPTH)
        return cagd_refuse_token(r, "more than %d levels of brackets", CAGD_MOST_DEPTH);
    if (kind == CAGD_FOR_ALL && is_interval_ahead(r)) { /* what is said of a variable is said of all its values */
        const cagd_tree *within = cagd_read_members(r);
        if (!cagd_pass(r, ":") && !cagd_pass(r, ","))
            cagd_pass(r, ";");
        const cagd_tree *said = within != NULL ? cagd_read_truth(r) : NULL;
        r->depth--, r->ranged = sign;
        return said != NULL ? cagd_new_of(r, CAGD_IMPLIES, from, 2, (const cagd_tree *[]){within, said}) : NULL;
    }
    if (r->token->kind != CAGD_TOKEN_LETTER)
        return cagd_refuse_token(r, "expected a letter, not %s", cagd_name_of_next(r));
    const char *head = (r->token++)->word;
    if (!finite_range(r, head, &list))
        return NULL;
    if (!cagd_pass(r, ":") && !cagd_pass(r, ","))
        cagd_pass(r, ";");
    struct cagd_bound bound = {head, r->bound, 0};
    r->bound = &bound;
    const cagd_tree *body = cagd_read_truth(r);
    r->bound = bound.next;
    r->depth--;
    if (body != NULL && kind == CAGD_EXISTS && refuse_ranged(r, from, "behind \\exists"))
        return NULL;
    return body != NULL ? cagd_over_list(r, kind, from, head, &list, body) : NULL;
}

/* \mathbb{R}, passed. */
static int pass_all_numbers(cagd_reader *r)
{
    const cagd_token *t = r->token;
    if (cagd_pass(r, "\\R"))
        return 1;
    if (strcmp(t->word, "\\mathbb") != 0)
        return 0;
    const int braces = strcmp(t[1].word, "{") == 0;
    if (strcmp(t[1 + braces].word, "R") != 0 || (braces && strcmp(t[3].word, "}") != 0))
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
    const cagd_variable *bounded = NULL;
    do {
        const cagd_tree *name = cagd_begins_name(r) ? cagd_read_name(r) : NULL;
        const cagd_variable *v = name != NULL ? cagd_declared(r->scope, name->head) : NULL;
        if (name == NULL)
            break;
        bounded = v != NULL && (v->low != NULL || v->high != NULL) ? v : bounded;
    } while (cagd_pass(r, ","));
    if (r->error->message[0] == '\0' && cagd_next_is(r, ":"))
        return 1;
    if (r->error->message[0] == '\0' && cagd_pass(r, "\\in") && pass_all_numbers(r)) {
        if (bounded == NULL)
            return 1;
        r->token = here;
        return cagd_refuse_token(r, "%s has bounds already: write \\forall %s: for these, or \\in \\mathbb{R} in :for:",
                                 cagd_spelled(bounded->head), cagd_spelled(bounded->head)) != NULL;
    }
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
        int begin = r->token->from;
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
            list[count] = between(r, begin, end, name[k], relation);
            if (outside)
                list[count] = cagd_new_of(r, CAGD_NOT, begin, 1, &list[count]);
            if (list[count++] == NULL)
                return NULL;
        }
    } while (pass_to_member(r));
    return count == 1 ? list[0] : cagd_new_of(r, CAGD_ALL, from, count, list);
}

/* Whether "for even", "for all odd" and the like come next, with a letter behind them. */
static int even_or_odd_follows(cagd_reader *r, const char *const words[])
{
    const cagd_token *here = r->token;
    const char *said = cagd_read_words(r);
    int is = said != NULL && cagd_parity_of_words(said) != 0 && r->token->kind == CAGD_TOKEN_LETTER,
        n = is ? (int)strlen(said) : 0;
    while (n > 0 && said[n - 1] != ' ')
        n--;
    const char *before = is ? cagd_text_of(said, n > 0 ? n - 1 : 0) : NULL;
    int is_known = before != NULL && before[0] == '\0';
    for (int k = 0; before != NULL && words[k] != NULL; k++)
        is_known |= cagd_is_said(before, words[k]);
    r->token = here;
    return is_known;
}

/* ---- what is supposed ------------------------------------------------------------------------------------ */

/* How what is supposed begins: with "for" and what may be a list of ranges, with "if", or with no word. */
enum supposing { NOT_SUPPOSED, FOR_RANGES, BY_A_WORD, WITHOUT_WORD };

/* What follows is what is supposed: "if", \forall of names that have a meaning, a bracket with a relation in it, names and \in. */
static enum supposing pass_supposed(cagd_reader *r)
{
    static const char *const ranges[] = {"for", "for all", "for every", "for any", "for each", NULL};
    static const char *const words[] = {"if",   "when",       "whenever", "provided that", "provided", "where",
                                        "with", "as long as", NULL};
    const cagd_token *here = r->token;
    cagd_pass(r, ",");
    if (cagd_next_is_parity(r) || even_or_odd_follows(r, ranges) || even_or_odd_follows(r, words))
        return BY_A_WORD;
    if (pass_words(r, ranges) || cagd_pass(r, "\\forall"))
        return FOR_RANGES;
    if (pass_words(r, words))
        return BY_A_WORD;
    if (cagd_next_is_member(r) || cagd_is_truth_in_brackets(r))
        return WITHOUT_WORD;
    r->token = here;
    return cagd_pass(r, "\\Leftarrow") ? BY_A_WORD : NOT_SUPPOSED;
}

/* Behind a range, without "if", nobody knows whether another relation is said or supposed; bounds of variables are supposed. */
static int is_unclear(cagd_reader *r, const cagd_tree *t, int is_first, int behind_range, enum supposing how)
{
    int is = !is_first && behind_range && t->kind == CAGD_RELATION && !cagd_is_range_of_name(r->scope, t, NULL) &&
             (how == WITHOUT_WORD || (how == FOR_RANGES && !cagd_is_of_plain_names(r->scope, t)));
    return is && cagd_refuse_tree(r, t, CAGD_SAID_OR_SUPPOSED) == NULL;
}

/* The comma, or "and", behind a part of what is supposed, if another part comes next. */
static int pass_to_part(cagd_reader *r)
{
    static const char *const and[] = {"and", "and all", "and for all", NULL};
    static const char *const no_part[] = {"\\text", "\\mbox", "\\textrm", "\\Rightarrow", "\\iff", "\\forall", "\\\\",
                                          "\\end",  ".",      ")"};
    const cagd_token *here = r->token;
    int is = cagd_pass(r, ",") || cagd_pass(r, ";") || cagd_pass(r, "\\land") || pass_words(r, and);
    for (size_t k = 0; k < sizeof no_part / sizeof *no_part && is; k++)
        is = r->token->kind != CAGD_TOKEN_END && !cagd_next_is(r, no_part[k]);
    if (!is)
        r->token = here;
    return is;
}

/* What is supposed, parts with commas between, each names and \in, or conditions. */
static const cagd_tree *parts_supposed(cagd_reader *r, enum supposing how)
{
    const cagd_tree *list[CAGD_MOST_CHILDREN];
    int count = 0, from = r->token->from, behind_range = 0;
    do {
        int member = cagd_next_is_member(r);
        r->premises++;
        const cagd_tree *t = member ? cagd_read_members(r) : cagd_read_alternatives(r);
        r->premises--;
        if (t == NULL)
            return NULL;
        const cagd_tree *const *parts = t->kind == CAGD_ALL ? t->at : &t;
        int several = t->kind == CAGD_ALL ? t->count : 1;
        if (count + several > CAGD_MOST_CHILDREN)
            return cagd_refuse_token(r, "more than %d conditions", CAGD_MOST_CHILDREN);
        for (int k = 0; k < several; k++) {
            if (!member && is_unclear(r, parts[k], count == 0, behind_range, how))
                return NULL;
            behind_range |= member || cagd_is_range_of_name(r->scope, parts[k], NULL) ||
                            (how == FOR_RANGES && cagd_is_of_plain_names(r->scope, parts[k]));
            list[count++] = parts[k];
        }
    } while (cagd_next_is_member(r) || pass_to_part(r));
    return count == 1 ? list[0] : cagd_new_of(r, CAGD_ALL, from, count, list);
}

/* What is supposed, behind what passes it; a round bracket around it is passed. */
static const cagd_tree *supposed_as_it_stands(cagd_reader *r, enum supposing how)
{
    const cagd_token *here = r->token;
    const char *said = cagd_read_words(r);
    if (said != NULL) { /* for even n, for odd n \ge 3 */
        cagd_relation relation;
        int parity = cagd_parity_of_words(said);
        const cagd_tree *both[2] = {parity != 0 ? cagd_is_of_parity(r, parity) : NULL, NULL};
        const cagd_token *letter = r->token;
        if (parity == 0)
            r->token = here, cagd_refuse_token(r, "'%s' is not understood here", said);
        if (both[0] == NULL)
            return NULL;
        r->token++;
        if (!cagd_relation_next(r, &relation))
            return both[0];
        r->token = letter;
        both[1] = cagd_read_alternatives(r);
        return cagd_new_of(r, CAGD_ALL, here->from, 2, both);
    }
    int depth = r->depth;
    if (cagd_is_truth_in_brackets(r) && cagd_pass(r, "(")) {
        const cagd_tree *t = parts_supposed(r, how);
        if (t != NULL && cagd_pass(r, ")") &&
            (r->token->kind == CAGD_TOKEN_END || strchr(".,;", r->token->word[0]) != NULL))
            return t;
        if (t == NULL && strcmp(r->error->message, CAGD_SAID_OR_SUPPOSED) == 0)
            return NULL;
        r->token = here, r->depth = depth;
        *r->error = (cagd_reading_error){0};
    }
    return parts_supposed(r, how);
}

static const cagd_tree *supposed(cagd_reader *r, enum supposing how)
{
    cagd_own_ranges own;
    const struct cagd_bound *outside = r->bound;
    const cagd_tree *t =
        cagd_take_ranges(r, 0, &own) ? cagd_for_own_ranges(r, supposed_as_it_stands(r, how), &own) : NULL;
    r->bound = outside;
    return t;
}

/* The right side of \iff behind the left one: ranges of letters that stand in it alone, a = 0 \iff a_j = 0, j = 1, 2, are its own. */
static const cagd_tree *right_side(cagd_reader *r, const cagd_tree *left)
{
    cagd_own_ranges own;
    const struct cagd_bound *outside = r->bound;
    const cagd_token *here = r->token;
    if (!cagd_take_ranges(r, 0, &own))
        return NULL;
    for (int k = 0; k < own.count; k++)
        if (cagd_tree_has(left, own.letter[k].head))
            own.count = 0, r->token = here, r->bound = outside;
    const cagd_tree *t = cagd_for_own_ranges(r, cagd_read_alternatives(r), &own);
    r->bound = outside;
    return t;
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

/* Whether a name that a quantifier over real numbers takes from `first` on, \forall x, y \in [0,1], stands in the premise, too: it is another x there. */
static int refuse_taken_name(cagd_reader *r, const cagd_token *first, const cagd_tree *premise)
{
    for (const cagd_token *t = first; t < r->token; t++) {
        cagd_reader at = *r;
        const cagd_tree *name[MOST_NAMES];
        int names, bracket;
        cagd_reading_error none = {0};
        at.error = &none, at.token = t + 1;
        if (strcmp(t->word, "\\forall") != 0 || !is_interval_ahead(&at) || !read_names(&at, name, &names, &bracket))
            continue;
        for (int k = 0; k < names; k++)
            if (cagd_tree_has(premise, name[k]->head)) {
                r->token = t;
                cagd_refuse_token(r, "%s stands in what is supposed, too: take another letter behind \\forall",
                                  cagd_spelled(name[k]->head));
                return 1;
            }
    }
    return 0;
}

/* A \Rightarrow B, C \Rightarrow D: nobody knows whether C is said with B, or supposed for D. */
static int refuse_two_arrows(cagd_reader *r, const cagd_token *first)
{
    const cagd_token *comma = NULL;
    int depth = 0;
    for (const cagd_token *t = first; t < r->token; t++) {
        depth += (strchr("({[", t->word[0]) != NULL || strcmp(t->word, "\\{") == 0) -
                 (strchr(")}]", t->word[0]) != NULL || strcmp(t->word, "\\}") == 0);
        if (depth == 0 && (strcmp(t->word, ",") == 0 || strcmp(t->word, ";") == 0))
            comma = t;
        int arrow = strcmp(t->word, "\\Rightarrow") == 0 || strcmp(t->word, "\\iff") == 0 ||
                    strcmp(t->word, "\\Leftarrow") == 0;
        if (depth == 0 && comma == NULL && arrow) {
            r->token = t;
            cagd_refuse_token(
                r, "two arrows: A \\Rightarrow (B \\Rightarrow C), or A \\Rightarrow B and B \\Rightarrow C? "
                   "write the brackets");
            return 1;
        }
        if (depth == 0 && arrow) {
            r->token = comma;
            cagd_refuse_token(
                r, "a comma between two implications: (A \\Rightarrow B), (C \\Rightarrow D), or A \\Rightarrow "
                   "((B, C) \\Rightarrow D)? write the brackets");
            return 1;
        }
    }
    return 0;
}

/* Whether what comes next is supposed, and what is said stands behind it. */
static int is_supposed_first(const cagd_reader *r)
{
    static const char *const words[] = {"then", "implies", "implies that", NULL};
    cagd_reader at = *r;
    at.token = cagd_end_of_supposed(r);
    return cagd_next_is(&at, "\\Rightarrow") || pass_words(&at, words);
}

const cagd_tree *cagd_read_truth(cagd_reader *r)
{
    static const char *const if_words[] = {"if", "when", "whenever", "suppose", "suppose that", NULL};
    static const char *const then_words[] = {"then", "implies", "implies that", NULL};
    static const char *const iff_words[] = {"if and only if", "iff", "exactly when", "is equivalent to", NULL};
    const cagd_token *first = r->token, *second;
    enum supposing how = NOT_SUPPOSED;
    int from = first->from, begins_with_if = pass_words(r, if_words);
    if (cagd_next_is(r, "\\forall") || cagd_next_is(r, "\\exists"))
        return quantified(r);
    cagd_own_ranges own = {.count = 0};
    const struct cagd_bound *outside = r->bound;
    int begins = begins_with_if || is_supposed_first(r);
    if (begins && !cagd_take_ranges(r, 0, &own))
        return NULL;
    first = r->token;
    const cagd_tree *a =
                        begins ? cagd_for_own_ranges(r, parts_supposed(r, BY_A_WORD), &own) : cagd_read_alternatives(r),
                    *b = a;
    r->bound = outside;
    if (a == NULL)
        return NULL;
    second = r->token;
    int comma = r->comma;
    cagd_pass(r, ",");
    int implies = pass_words(r, then_words);
    if (!implies)
        r->token = second;
    implies |= cagd_pass(r, "\\Rightarrow");
    if (begins_with_if && !implies)
        return cagd_refuse_token(r, "expected \\text{then} behind what is supposed, not %s", cagd_name_of_next(r));
    int iff = !implies && (cagd_pass(r, "\\iff") || pass_words(r, iff_words)),
        implied = !implies && !iff && (how = pass_supposed(r)) != NOT_SUPPOSED;
    r->comma = comma;
    if (!implies && !iff && !implied)
        return a;
    if ((implies || iff) && refuse_ranged(r, from, implies ? "in a premise" : "beside \\iff"))
        return NULL;
    int of_all = implied && how == FOR_RANGES;
    const cagd_token *sign = second;
    if (implied && only_names(r))
        return a;
    if ((implies || iff) && refuse_dots(r, first))
        return NULL;
    second = r->token;
    b = implies                  ? cagd_read_truth(r)
        : implied                ? supposed(r, how)
        : cagd_next_is_member(r) ? cagd_read_members(r)
                                 : right_side(r, a);
    for (int k = 0; b == NULL && k < own.count; k++) /* a_j = 0, j = 1, 2 \Rightarrow b_j = 0 */
        for (const cagd_token *t = second; t->kind != CAGD_TOKEN_END; t++)
            if (t->from == r->error->from && strcmp(t->word, own.letter[k].head) == 0) {
                *r->error = (cagd_reading_error){0}, r->token = t;
                return cagd_refuse_token(
                    r, "is the range of %s that of what is supposed alone? write it behind all, or in :for:", t->word);
            }
    if (b == NULL || (!implies && refuse_dots(r, second)) ||
        (implies && (refuse_taken_name(r, second, a) || refuse_two_arrows(r, second))) ||
        (implied && refuse_ranged(r, second->from, "in what is supposed")) ||
        (iff && refuse_ranged(r, from, "beside \\iff")))
        return NULL;
    if (of_all)
        r->ranged = sign;
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

const cagd_tree *cagd_read_supposed(const cagd_scope *scope, const char *text, int from, int to,
                                    cagd_reading_error *error)
{
    cagd_reader r;
    cagd_own_ranges own;
    if (!cagd_reader_open(&r, scope, text, from, to, error))
        return NULL;
    enum supposing how = pass_supposed(&r);
    if (!cagd_take_ranges(&r, 1, &own) || r.token->kind == CAGD_TOKEN_END)
        return NULL;
    const cagd_tree *t =
        cagd_for_own_ranges(&r, supposed_as_it_stands(&r, how == NOT_SUPPOSED ? WITHOUT_WORD : how), &own);
    cagd_pass(&r, ".");
    if (t != NULL && r.token->kind != CAGD_TOKEN_END)
        return cagd_refuse_token(&r, "expected the end of the formula, not %s", cagd_name_of_next(&r));
    return t;
}
