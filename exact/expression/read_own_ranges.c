/* read_own_ranges.c -- ranges of indices that are those of a part alone: of what is supposed, "if a_j = 0 for j = 1, 2", and of a row.
 *
 *     \Delta_j \ge 0, \quad j = 1, \dots, n \Rightarrow ...       \begin{aligned} a_i &= 1, \quad 0 \le i \le n \\ b_i &= 2, \quad 1 \le i \le n \end{aligned} */
#include "exact/expression/reader.h"
#include "exact/words.h"

#include <ctype.h>
#include <string.h>

/* Whether a text says this and nothing else; commas around it, and how it begins, do not count. */
int cagd_is_said(const char *text, const char *words)
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

/* The token that ends what is supposed and begins at r->token. */
const cagd_token *cagd_end_of_supposed(const cagd_reader *r)
{
    static const char *const ends[] = {"then", "implies",      "implies that",     "if and only if",
                                       "iff",  "exactly when", "is equivalent to", "if",
                                       "when", "whenever"};
    cagd_reader at = *r;
    int depth = 0; /* of round brackets */
    while (at.token->kind != CAGD_TOKEN_END) {
        const cagd_token *here = at.token;
        depth += cagd_next_is(&at, "(") - cagd_next_is(&at, ")");
        const char *said = cagd_read_words(&at);
        for (size_t k = 0; said != NULL && depth <= 0 && here > r->token && k < sizeof ends / sizeof *ends; k++)
            if (cagd_is_said(said, ends[k]))
                return here;
        if (said == NULL && depth <= 0 &&
            (cagd_next_is(&at, "\\Rightarrow") || cagd_next_is(&at, "\\Leftarrow") || cagd_next_is(&at, "\\iff") ||
             cagd_next_is(&at, "\\forall") || cagd_next_is(&at, "\\exists")))
            return here;
        at.token += said == NULL;
    }
    return at.token;
}

/* Where what stands before the range at t begins, a comma, words, a bracket or a wide space, and *close, whether a bracket has to end behind it; NULL
 * where a range cannot begin. */
static const cagd_token *before_range(const cagd_reader *r, const cagd_token *first, const cagd_token *t, int *close)
{
    *close = 0;
    if (t == first)
        return t;
    if (strchr(",;", t[-1].word[0]) != NULL)
        return t - 1;
    if (strcmp(t[-1].word, "(") == 0) {
        *close = 1, t--;
        return t > first && strchr(",;", t[-1].word[0]) != NULL ? t - 1 : t;
    }
    if (strcmp(t[-1].word, "}") == 0) { /* \text{ for } */
        static const char *const words[] = {"for",  "for all", "for each", "for every", "for any",    "where",
                                            "with", "and",     "and for",  "and all",   "and for all"};
        cagd_reader at = *r;
        for (at.token = t - 1; at.token > first && at.token[0].word[0] != '\\'; at.token--)
            ;
        const cagd_token *begin = at.token;
        const char *said = cagd_read_words(&at);
        for (size_t k = 0; said != NULL && at.token == t && k < sizeof words / sizeof *words; k++)
            if (cagd_is_said(said, words[k]))
                return begin > first && strchr(",;", begin[-1].word[0]) != NULL ? begin - 1 : begin;
    }
    int at = t->from;
    while (at > 0 && r->text[at - 1] == ' ')
        at--;
    return at >= 4 && memcmp(r->text + at - 4, "quad", 4) == 0 ? t : NULL;
}

/* Whether the letter stands from `first` to `end`, but not from `low` to `high`. */
static int is_besides(const char *letter, const cagd_token *first, const cagd_token *end, const cagd_token *low,
                      const cagd_token *high)
{
    for (const cagd_token *t = first; t < end; t++)
        if ((t < low || t >= high) && t->kind == CAGD_TOKEN_LETTER && strcmp(t->word, letter) == 0)
            return 1;
    return 0;
}

/* The tokens without those from `from` to `to`, r->token being the first. */
static const cagd_token *without(cagd_reader *r, const cagd_token *from, const cagd_token *to)
{
    const cagd_token *end = to;
    while (end->kind != CAGD_TOKEN_END)
        end++;
    long before = from - r->token, behind = end - to + 1;
    cagd_token *list = cagd_region_array((int)(before + behind), 1, sizeof *list);
    if (list == NULL)
        return NULL;
    for (long k = 0; k < before + behind; k++)
        list[k] = k < before ? r->token[k] : to[k - before];
    return list;
}

/* Whether the token stands in a bracket that begins from `first` on. */
static int is_inside(const cagd_token *first, const cagd_token *token)
{
    int depth = 0;
    for (const cagd_token *t = first; t < token; t++)
        depth += (strcmp(t->word, "(") == 0) - (strcmp(t->word, ")") == 0);
    return depth > 0;
}

/* Whether there is another connective than "and" from `first` to `last`: what is said for all in a bracket is said so of that alone. */
static int has_other_connective(const cagd_reader *r, const cagd_token *first, const cagd_token *last)
{
    static const char *const others[] = {"\\lor", "\\neg", "\\Rightarrow", "\\Leftarrow", "\\iff", "\\exists"};
    cagd_reader at = *r;
    for (at.token = first; at.token < last;) {
        for (size_t k = 0; k < sizeof others / sizeof *others; k++)
            if (cagd_next_is(&at, others[k]))
                return 1;
        const char *said = cagd_read_words(&at);
        if (said != NULL && !cagd_are_words_of_range(said))
            return 1;
        at.token += said == NULL;
    }
    return 0;
}

/* The first range of an index that stands in what is supposed, from `low` to `high`, and is about another part of it; its letter means nothing else, or, with
 * `known`, is a whole number that was declared.  NULL where there is none. */
static const cagd_token *range_within(cagd_reader *r, int known, cagd_list *list, const cagd_token **from,
                                      const cagd_token **to)
{
    const cagd_token *first = r->token, *last = cagd_end_of_supposed(r);
    for (const cagd_token *t = first; t < last; t++) {
        int close;
        const cagd_variable *v = t->kind == CAGD_TOKEN_LETTER ? cagd_declared(r->scope, t->word) : NULL;
        if (!cagd_begins_range(t) || (cagd_is_known(r, t->word) && !(known && v != NULL && v->whole)) ||
            (*from = before_range(r, first, t, &close)) == NULL)
            continue;
        struct cagd_bound room[CAGD_MOST_INDICES];
        const struct cagd_bound *outside = r->bound;
        int used = 0;
        for (const cagd_token *m = first; m < last && used < CAGD_MOST_INDICES; m++) /* they may have one another */
            if (m != t && cagd_begins_range(m) && !cagd_is_known(r, m->word)) {
                room[used] = (struct cagd_bound){m->word, r->bound, 0};
                r->bound = &room[used++];
            }
        r->token = t;
        int is = cagd_read_index_range(r, list);
        *to = r->token;
        r->token = first, r->bound = outside;
        if (!is || (close && strcmp((*to)->word, ")") != 0))
            continue;
        *to += close;
        if (*from == first && strchr(",;", (*to)->word[0]) != NULL && (*to)->kind != CAGD_TOKEN_END)
            ++*to;
        if (v == NULL && !is_besides(t->word, first, last, *from, *to))
            continue;
        if (is_inside(first, *from) && has_other_connective(r, first, last)) {
            r->token = t;
            cagd_refuse_token(
                r,
                "is the range of %s that of the bracket alone, or of all that is supposed? write \\forall %s "
                "\\in \\{...\\}: before what it is of",
                t->word, t->word);
            return NULL;
        }
        return t;
    }
    return NULL;
}

/* Takes the ranges out of what is supposed and comes next; their letters are known from here on. */
int cagd_take_ranges(cagd_reader *r, int known, cagd_own_ranges *own)
{
    cagd_list range;
    const cagd_token *from, *to, *t;
    own->count = 0;
    while (own->count < CAGD_MOST_INDICES && (t = range_within(r, known, &range, &from, &to)) != NULL) {
        const cagd_variable *v = cagd_declared(r->scope, t->word);
        const cagd_token *list = without(r, from, to);
        if (list == NULL)
            return 0;
        r->token = list;
        if (v != NULL && v->whole)
            continue;
        own->letter[own->count] = (struct cagd_bound){t->word, r->bound, 0};
        own->list[own->count] = range;
        r->bound = &own->letter[own->count++];
    }
    return r->error->message[0] == '\0';
}

enum { MOST_WRITTEN_OUT = 12 };

/* t for all numbers of the range; where its ends are numbers, not many, one behind another. */
static const cagd_tree *for_all_of(cagd_reader *r, const cagd_tree *t, const char *letter, const cagd_list *range)
{
    const cagd_tree *list[MOST_WRITTEN_OUT], *low = range->low, *high = range->high;
    long first, last;
    if (range->count == 0 && range->step == 1 && low->kind == CAGD_NUMBER && high->kind == CAGD_NUMBER &&
        cagd_is_whole_in_long(low, &first) && cagd_is_whole_in_long(high, &last)) {
        if (first <= last && (unsigned long)last - (unsigned long)first < MOST_WRITTEN_OUT) {
            for (long k = first; k <= last; k++)
                list[k - first] = cagd_tree_with(t, letter, cagd_tree_number(k, low->from, low->to));
            return first == last ? list[0] : cagd_new_of(r, CAGD_ALL, t->from, (int)(last - first) + 1, list);
        }
    }
    return cagd_over_list(r, CAGD_FOR_ALL, t->from, letter, range, t);
}

/* What was supposed, for all of its own ranges: each of its parts for those whose letters it has, the ends of which may have other letters. */
const cagd_tree *cagd_for_own_ranges(cagd_reader *r, const cagd_tree *t, const cagd_own_ranges *own)
{
    if (t == NULL || own->count == 0)
        return t;
    if (t->kind == CAGD_ALL) {
        const cagd_tree *list[CAGD_MOST_CHILDREN];
        int count = 0;
        for (int k = 0; k < t->count; k++) {
            const cagd_tree *one = cagd_for_own_ranges(r, t->at[k], own);
            const cagd_tree *const *parts = one != NULL && one->kind == CAGD_ALL ? one->at : &one;
            int several = one != NULL && one->kind == CAGD_ALL ? one->count : 1;
            if (one == NULL || count + several > CAGD_MOST_CHILDREN)
                return one == NULL ? NULL : cagd_refuse_tree(r, t, "more than %d conditions", CAGD_MOST_CHILDREN);
            for (int m = 0; m < several; m++)
                list[count++] = parts[m];
        }
        return cagd_new_of(r, CAGD_ALL, t->from, count, list);
    }
    int is_done[CAGD_MOST_INDICES] = {0};
    for (int more = 1;
         more && t != NULL;) { /* those in the ends of which another letter is stand inside of that one's */
        more = 0;
        for (int k = 0; k < own->count && t != NULL; k++) {
            int waits = is_done[k] || !cagd_tree_has(t, own->letter[k].head);
            for (int m = 0; m < own->count && !waits; m++)
                waits = m != k && !is_done[m] && cagd_tree_has(t, own->letter[m].head) &&
                        (cagd_tree_has(own->list[m].low, own->letter[k].head) ||
                         cagd_tree_has(own->list[m].high, own->letter[k].head));
            if (waits)
                continue;
            is_done[k] = more = 1;
            t = for_all_of(r, t, own->letter[k].head, &own->list[k]);
        }
    }
    return t;
}

/* ---- of a row ------------------------------------------------------------------------------------------ */

/* < or \le comes next, and is passed; by how much the number behind it is at least more. */
static int pass_less(cagd_reader *r, long *more)
{
    cagd_relation relation;
    if (!cagd_relation_next(r, &relation) || (relation != CAGD_LESS && relation != CAGD_LESS_OR_EQUAL))
        return 0;
    *more = relation == CAGD_LESS;
    r->token++;
    return 1;
}

static const cagd_tree *moved(cagd_reader *r, const cagd_tree *t, long by)
{
    return by == 0 ? t
                   : cagd_new_of(r, CAGD_SUM, t->from, 2, (const cagd_tree *[]){t, cagd_tree_number(by, t->to, t->to)});
}

/* At t stands 0 \le i \le n, with a letter for whole numbers that means nothing else: its list, and where it ends. */
static const char *chain_of_index(const cagd_reader *r, const cagd_token *t, cagd_list *list, const cagd_token **to)
{
    cagd_reading_error none = {0};
    cagd_reader at = *r;
    long below, above;
    at.error = &none, at.looking = 1, at.token = t;
    const cagd_tree *low = cagd_read_sum(&at);
    const char *letter =
        low != NULL && pass_less(&at, &below) && at.token->kind == CAGD_TOKEN_LETTER ? at.token->word : NULL;
    if (letter == NULL || cagd_is_known(r, letter) || !cagd_is_usual_index(letter))
        return NULL;
    at.token++;
    const cagd_tree *high = pass_less(&at, &above) ? cagd_read_sum(&at) : NULL;
    if (high == NULL)
        return NULL;
    *list = (cagd_list){.low = moved(&at, low, below), .high = moved(&at, high, -above), .step = 1};
    *to = at.token;
    return list->low != NULL && list->high != NULL ? letter : NULL;
}

/* The first range of an index behind what the row says; its letter, or NULL. */
static const char *range_behind(const cagd_reader *r, cagd_list *list, const cagd_token **from, const cagd_token **to)
{
    const cagd_token *first = r->token, *end = first;
    while (end->kind != CAGD_TOKEN_END)
        end++;
    for (const cagd_token *t = first + 1; t < end; t++) {
        int close;
        if ((*from = before_range(r, first, t, &close)) == NULL || close)
            continue;
        const char *letter = NULL;
        if (cagd_begins_range(t) && !cagd_is_known(r, t->word)) {
            cagd_reading_error none = {0};
            cagd_reader at = *r;
            at.error = &none, at.token = t;
            letter = cagd_read_index_range(&at, list) ? t->word : NULL;
            *to = at.token;
        } else {
            letter = chain_of_index(r, t, list, to);
        }
        if (letter != NULL && is_besides(letter, first, end, *from, *to))
            return letter;
    }
    return NULL;
}

/* Whether t is of whole numbers that were declared, and numbers; the last letter of them. */
static int is_of_whole_letters(const cagd_reader *r, const cagd_tree *t, const char **letter)
{
    const cagd_variable *v = t->kind == CAGD_NAME ? cagd_declared(r->scope, t->head) : NULL;
    int is = t->kind == CAGD_NUMBER || t->kind == CAGD_SUM || t->kind == CAGD_PRODUCT || t->kind == CAGD_NEGATIVE ||
             t->kind == CAGD_RELATION || (v != NULL && v->whole && t->count == 0);
    if (v != NULL)
        *letter = t->head;
    for (int k = 0; k < t->count && is; k++)
        is = is_of_whole_letters(r, t->at[k], letter);
    return is;
}

/* i = 0, \dots, n of a declared i, the list being passed: 0 \le i \le n. */
static const cagd_tree *within(cagd_reader *r, const cagd_token *t, const cagd_list *list)
{
    static const cagd_relation at_most[] = {CAGD_LESS_OR_EQUAL, CAGD_LESS_OR_EQUAL};
    cagd_tree *name = cagd_new(r, CAGD_NAME, t->from, 0);
    if (name == NULL || list->step != 1 || list->count > 0)
        return NULL;
    name->head = t->word;
    cagd_tree *all = cagd_new_of(r, CAGD_RELATION, t->from, 3, (const cagd_tree *[]){list->low, name, list->high});
    if (all != NULL)
        all->relation = at_most;
    return all;
}

/* The first condition on declared whole numbers behind what the row says, i \ge 1, which is of that row; NULL where there is none. */
static const cagd_tree *condition_behind(const cagd_reader *r, const cagd_token **from, const cagd_token **to)
{
    const cagd_token *first = r->token, *end = first;
    while (end->kind != CAGD_TOKEN_END)
        end++;
    for (const cagd_token *t = first + 1; t < end; t++) {
        int close;
        cagd_reading_error none = {0};
        cagd_reader at = *r;
        cagd_list list;
        if ((*from = before_range(r, first, t, &close)) == NULL)
            continue;
        at.error = &none, at.looking = 1, at.token = t;
        const cagd_tree *said = cagd_begins_range(t) && cagd_read_index_range(&at, &list) ? within(&at, t, &list)
                                                                                          : cagd_read_relations(&at);
        const char *letter = NULL;
        if (said == NULL || !is_of_whole_letters(r, said, &letter) || letter == NULL ||
            (close && strcmp(at.token->word, ")") != 0))
            continue;
        *to = at.token + close;
        if (((*to)->kind == CAGD_TOKEN_END || strchr(",;.", (*to)->word[0]) != NULL) &&
            is_besides(letter, first, end, *from, *to))
            return said;
    }
    return NULL;
}

int cagd_row_has_range(const cagd_reader *r)
{
    cagd_list list;
    const cagd_token *from, *to;
    return range_behind(r, &list, &from, &to) != NULL || condition_behind(r, &from, &to) != NULL;
}

const cagd_tree *cagd_read_row(cagd_reader *r)
{
    cagd_own_ranges own = {.count = 0};
    const struct cagd_bound *outside = r->bound;
    const cagd_token *from, *to;
    cagd_list list;
    for (const char *letter; own.count < CAGD_MOST_INDICES && (letter = range_behind(r, &list, &from, &to)) != NULL;) {
        const cagd_token *rest = without(r, from, to);
        if (rest == NULL)
            return NULL;
        r->token = rest;
        own.letter[own.count] = (struct cagd_bound){letter, r->bound, 0};
        own.list[own.count] = list;
        r->bound = &own.letter[own.count++];
    }
    const cagd_tree *condition = condition_behind(r, &from, &to);
    if (condition != NULL && (r->token = without(r, from, to)) == NULL)
        return NULL;
    const cagd_tree *t = cagd_read_for_all_numbers(r);
    if (t != NULL && condition != NULL)
        t = cagd_new_of(r, CAGD_IMPLIES, t->from, 2, (const cagd_tree *[]){condition, t});
    t = cagd_for_own_ranges(r, t, &own);
    r->bound = outside;
    return t;
}
