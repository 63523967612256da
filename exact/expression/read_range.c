/* read_range.c -- for what a statement is said: the bounds, values, sets and lists of names. */
#include "exact/expression/depends.h"
#include "exact/expression/reader.h"
#include "exact/words.h"

#include <stdio.h>
#include <string.h>

cagd_place cagd_here(const cagd_reader *r) { return (cagd_place){r->token, r->depth}; }

int cagd_back(cagd_reader *r, cagd_place p)
{
    r->token = p.token, r->depth = p.depth;
    *r->error = (cagd_reading_error){0};
    return 0;
}

/* Whether the name stands for one alone, as \omega_3; \omega_i stands for all. */
static int is_one_of_many(const cagd_tree *name)
{
    long index;
    for (int k = 0; k < name->count; k++)
        if (!cagd_is_whole_in_long(name->at[k], &index))
            return 0;
    return name->count > 0 && name->arguments == 0;
}

/* The name under which the declaration of one alone is kept. */
static const char *key_of_one(const cagd_tree *name)
{
    char key[96];
    long index[2 * CAGD_MOST_INDICES];
    for (int k = 0; k < name->count; k++)
        if (!cagd_is_whole_in_long(name->at[k], &index[k]))
            return NULL;
    return cagd_put_key(key, sizeof key, name, index) < (int)sizeof key ? cagd_text_of(key, (int)strlen(key)) : NULL;
}

static int declare(cagd_reader *r, cagd_scope *scope, const cagd_tree *name, cagd_variable v)
{
    const cagd_variable *same = cagd_declared(scope, name->head);
    if (v.whole && same != NULL && same->whole && same->low->from == v.low->from && v.low->to > v.low->from)
        return 1; /* it was read before what stands before it */
    v.head = name->head, v.lower = name->lower, v.upper = name->upper, v.left = name;
    if (name->arguments > 0 || name->order > 0)
        return cagd_refuse_tree(r, name, "a variable has no arguments: define the function") != NULL;
    const cagd_definition *function = v.whole ? cagd_defined(scope, name->head) : NULL;
    if (function != NULL && function->left->arguments > 0)
        return cagd_refuse_tree(r, name, "%s is a function: take another letter for what runs over whole numbers",
                                name->head) != NULL;
    if (v.whole && name->count > 0)
        return cagd_refuse_tree(r, name, "what runs over whole numbers has no indices") != NULL;
    return cagd_declare(scope, v);
}

/* The declaration of that name: where it is one of many, its own, which begins as that of all. */
static int declaration_of(const cagd_scope *scope, const cagd_tree *name, cagd_variable *v)
{
    const cagd_variable *all = cagd_declared(scope, name->head), *own = NULL;
    const char *key = is_one_of_many(name) ? key_of_one(name) : NULL;
    for (const cagd_variable *w = scope->variables; key != NULL && w != all && own == NULL; w = w->next)
        own = strcmp(w->head, key) == 0 ? w : NULL;
    *v = own != NULL ? *own : all != NULL ? *all : (cagd_variable){0};
    if (key != NULL)
        v->head = key, v->lower = v->upper = 0, v->left = name;
    return own != NULL || all != NULL;
}

/* The first of the variables that is one of those called `name`, before what was declared at `end`; NULL if there is none. */
static const cagd_variable *one_of_those(const cagd_scope *scope, const cagd_tree *name, const cagd_variable *end)
{
    for (const cagd_variable *v = scope->variables; v != NULL && v != end; v = v->next)
        if (v->left != NULL && strcmp(v->left->head, name->head) == 0 && strcmp(v->head, name->head) != 0)
            return v;
    return NULL;
}

/* A number of components, rows or columns. */
static int extent(cagd_reader *r, int *value)
{
    const char *digit = r->token->word;
    if (r->token->kind != CAGD_TOKEN_NUMBER || digit[1] != '\0' || digit[0] < '2' || digit[0] > '8')
        return cagd_refuse_token(r, "vectors have 2 to 8 components, not %s", cagd_name_of_next(r)) != NULL;
    *value = digit[0] - '0';
    r->token++;
    return 1;
}

/* Behind \mathbb{R}: ^3 where the variable is a vector, ^{2 \times 3} where it is a matrix. */
static int dimension(cagd_reader *r, cagd_variable *v)
{
    int columns = 0;
    if (!cagd_pass(r, "^"))
        return 1;
    int braces = cagd_pass(r, "{");
    if (!extent(r, &v->dimension) || (braces && cagd_pass(r, "\\times") && !extent(r, &columns)))
        return 0;
    v->dimension += CAGD_MATRIX * columns;
    return !braces || cagd_expect(r, "}", "the dimension");
}

/* ^+, ^*, ^{+}: of whole numbers those from 1 on. */
static int is_positive(const cagd_token *t)
{
    if (strcmp(t->word, "^") != 0)
        return 0;
    int braces = strcmp(t[1].word, "{") == 0;
    const char *sign = t[1 + braces].word;
    return (strcmp(sign, "+") == 0 || strcmp(sign, "*") == 0) && (!braces || strcmp(t[3].word, "}") == 0);
}

/* The variable runs over the numbers of the list. */
static void take_list(cagd_variable *v, const cagd_list *list)
{
    v->whole = 1, v->low = list->low, v->high = list->high, v->step = list->step;
    v->listed = list->listed, v->listed_count = list->count;
}

/* ℕ, or \{0, \dots, n\}. */
static int whole_numbers(cagd_reader *r, cagd_variable *v)
{
    v->whole = 1, v->real = 0;
    v->low = cagd_tree_number(0, r->token->from, r->token->to);
    if (cagd_pass(r, "\\N"))
        return 1;
    r->token++;
    cagd_list list;
    int is_list = cagd_read_list(r, "n", &list);
    if (is_list < 0)
        return 0;
    if (!is_list && !cagd_next_is(r, "\\}"))
        return cagd_refuse_token(r, "expected whole numbers, such as \\{0, 1, 2\\} or \\{0, \\dots, n\\}") != NULL;
    take_list(v, is_list ? &list : &(cagd_list){.low = list.low, .high = list.low, .step = 1});
    return cagd_expect(r, "\\}", "the numbers");
}

/* Behind \in: \mathbb{R}, \mathbb{N}, \mathbb{Z}^+, [a,b], (a,b), \{0, \dots, n\}. */
static int set(cagd_reader *r, cagd_variable *v)
{
    v->real = 1;
    if (cagd_pass(r, "\\R"))
        return dimension(r, v);
    if (cagd_next_is(r, "\\N") || cagd_next_is(r, "\\{"))
        return whole_numbers(r, v);
    if (cagd_pass(r, "\\mathbb")) {
        int braces = cagd_pass(r, "{");
        const cagd_token *letter = r->token;
        if (!cagd_next_is(r, "R") && !cagd_next_is(r, "N") &&
            !(cagd_next_is(r, "Z") && r->token[1].kind != CAGD_TOKEN_END && is_positive(r->token + 1 + braces)))
            return cagd_refuse_token(r, "expected \\mathbb{R} or \\mathbb{N}; whole numbers are n = 1..12") != NULL;
        v->whole = letter->word[0] != 'R', v->real = !v->whole;
        r->token++;
        if (braces && !cagd_expect(r, "}", "the set"))
            return 0;
        if (!v->whole)
            return dimension(r, v);
        int from_1 = is_positive(r->token);
        r->token += !from_1 ? 0 : strcmp(r->token[1].word, "{") == 0 ? 4 : 2;
        if (!from_1 && cagd_pass(r, "_") && !cagd_expect(r, "0", "the set"))
            return 0;
        v->low = cagd_tree_number(from_1, letter->from, letter->to);
        return 1;
    }
    v->low_open = cagd_next_is(r, "(");
    if (!cagd_pass(r, "(") && !cagd_pass(r, "["))
        return cagd_refuse_token(r, "expected \\mathbb{R} or an interval [a, b], not %s", cagd_name_of_next(r)) != NULL;
    v->low = cagd_read_sum(r);
    if (v->low == NULL || !cagd_expect(r, ",", "the end of the interval"))
        return 0;
    if (!cagd_pass(r, "\\infty") && (v->high = cagd_read_sum(r)) == NULL)
        return 0;
    v->high_open = cagd_next_is(r, ")");
    return cagd_pass(r, ")") || cagd_expect(r, "]", "the interval");
}

/* The letters of the indices of a name, NULL for none, are known: its bounds may have them. */
static void bind_letters(cagd_reader *r, const cagd_tree *name, struct cagd_bound room[])
{
    for (int k = 0, used = 0; name != NULL && k < name->lower + name->upper; k++)
        if (name->at[k]->kind == CAGD_NAME && name->at[k]->count == 0) {
            room[used] = (struct cagd_bound){name->at[k]->head, r->bound, 0};
            r->bound = &room[used++];
        }
}

/* The bounds of one of many. */
static int declare_one(cagd_scope *scope, const cagd_tree *name, cagd_variable bounds)
{
    cagd_variable one;
    declaration_of(scope, name, &one);
    one.low = bounds.low, one.high = bounds.high, one.low_open = bounds.low_open, one.high_open = bounds.high_open;
    return one.head != NULL && cagd_declare(scope, one);
}

/* \omega_n = 1, a_n \ge 0: where nothing is said of n it can be one of them or all; so of a_n = 2^n where n is a range.  `value`: NULL for bounds. */
int cagd_refuse_degree(cagd_reader *r, const cagd_scope *scope, const cagd_tree *name, const cagd_tree *value)
{
    for (int k = 0; k < name->lower + name->upper; k++) {
        const cagd_tree *t = name->at[k];
        if (t->kind != CAGD_NAME || t->count > 0 || !cagd_is_called_as_last(t->head) ||
            cagd_has_value(scope, t->head) || cagd_is_label(scope, t->head))
            continue;
        int is_range = cagd_is_last_index(scope, t->head), has_letter = value != NULL && cagd_tree_has(value, t->head);
        if (is_range != has_letter)
            continue;
        return cagd_refuse_tree(
                   r, name, "is it said of all %s, or of that with the index %s alone? write %s_i for all of them%s%s",
                   cagd_spelled(name->head), t->head, cagd_text_of(name->head, (int)strcspn(name->head, "_")),
                   is_range ? ", or its value for each number" : ", or first the range of ",
                   is_range ? "" : t->head) == NULL;
    }
    return 0;
}

/* Whether the name is all of those that are called so, and no certain one, as \omega_3, \omega_{i+1}, or \omega_n where n = 1, 2, 3. */
static int is_each(const cagd_scope *scope, const cagd_tree *name)
{
    for (int k = 0; k < name->count; k++) {
        const cagd_tree *t = name->at[k];
        const cagd_definition *d = t->kind == CAGD_NAME ? cagd_defined(scope, t->head) : NULL;
        if (t->kind != CAGD_NAME || t->count > 0 || (d != NULL && d->left->count == 0) ||
            cagd_is_last_index(scope, t->head) || cagd_same_index(name, k) >= 0)
            return 0;
        for (const cagd_variable *v = scope->variables; v != NULL; v = v->next)
            if (v->whole && v->high != NULL && strcmp(v->head, t->head) != 0 && cagd_tree_has(v->high, t->head) &&
                cagd_declared(scope, t->head) != NULL)
                return 0;
    }
    return 1;
}

/* a_{ii} \ge 0 is said of some. */
static int refuse_equal_indices(cagd_reader *r, const cagd_tree *name)
{
    for (int k = 0; k < name->lower + name->upper; k++)
        if (name->at[k]->kind == CAGD_NAME && cagd_same_index(name, k) >= 0)
            return cagd_refuse_tree(r, name, "bounds where two indices are the same: write those of each alone") ==
                   NULL;
    return 0;
}

/* low <= a_n <= high, one of them: supposed. */
static int suppose_between(cagd_reader *r, cagd_scope *scope, const cagd_tree *name, const cagd_variable *v)
{
    const cagd_relation up[2] = {v->low_open ? CAGD_LESS : CAGD_LESS_OR_EQUAL,
                                 v->high_open ? CAGD_LESS : CAGD_LESS_OR_EQUAL};
    const cagd_tree *list[3] = {v->low, name, v->high};
    if (cagd_declared(scope, name->head) == NULL && !declare(r, scope, name, (cagd_variable){0}))
        return 0;
    const cagd_tree *t = cagd_relate(r, name->from, v->high != NULL ? 3 : 2, list, up);
    return t != NULL && cagd_suppose(scope, t);
}

/* x, y, P_i \in SET, or P_0, P_1, \dots, P_n \in SET.  -1: it is no such thing; then *listed is what was wrong behind a comma.  A number that has bounds by
 * this list, which began with the scope `began`, keeps them. */
/* Whether it was declared in this list of ranges, or in an earlier line of this block of meanings: what was declared before it is replaced. */
static int is_of_this_place(const cagd_scope *scope, const cagd_scope *began, const cagd_variable *declared)
{
    for (const cagd_variable *v = scope->in_block ? scope->block : began->variables; v != NULL; v = v->next)
        if (v == declared)
            return 0;
    return 1;
}

static int elements(cagd_reader *r, cagd_scope *scope, const cagd_scope *began, cagd_reading_error *listed)
{
    const cagd_tree *name[CAGD_MOST_CHILDREN];
    cagd_place start = cagd_here(r);
    int count = 0;
    do {
        if (count > 0 && cagd_pass(r, "\\dots") && !cagd_pass(r, ","))
            return cagd_back(r, start) - 1;
        if (count == CAGD_MOST_CHILDREN || (name[count++] = cagd_read_declared_name(r)) == NULL) {
            if (count > 1 && !cagd_begins_name(r))
                cagd_refuse_token(r, "expected a name, not %s", cagd_name_of_next(r));
            *listed = count > 1 ? *r->error : (cagd_reading_error){0};
            return cagd_back(r, start) - 1;
        }
    } while (cagd_pass(r, ","));
    if (!cagd_pass(r, "\\in"))
        return cagd_back(r, start) - 1;
    cagd_variable v = {0};
    struct cagd_bound room[2 * CAGD_MOST_INDICES];
    const struct cagd_bound *outside = r->bound;
    const char *words = cagd_read_words(r);
    if (words != NULL && strcmp(words, "labels") == 0) {
        for (int k = 0; k < count; k++)
            if (name[k]->count > 0 ? cagd_refuse_tree(r, name[k], "a label is a letter") == NULL
                                   : !cagd_label(scope, name[k]))
                return 0;
        return 1;
    }
    bind_letters(r, count == 1 ? name[0] : NULL, room);
    int read = set(r, &v);
    r->bound = outside;
    for (int k = 0; k < count && read; k++) {
        const cagd_variable *before = cagd_declared(scope, name[k]->head);
        cagd_variable w = v;
        const int is_of_here = before != NULL && is_of_this_place(scope, began, before);
        if (v.low != NULL && !v.whole && name[k]->count == 0 && is_of_here && !before->whole &&
            ((before->low != NULL && before->low->from != v.low->from) ||
             (before->low == NULL && before->high != NULL)))
            return cagd_refuse_tree(r, name[k], "%s has bounds already: write one range for it",
                                    cagd_spelled(name[k]->head)) != NULL;
        if (v.low != NULL && !v.whole && is_one_of_many(name[k])) {
            if ((before == NULL && !declare(r, scope, name[k], (cagd_variable){0})) || !declare_one(scope, name[k], v))
                return 0;
            continue;
        }
        if (v.low != NULL && !v.whole && name[k]->count > 0 &&
            (cagd_refuse_degree(r, scope, name[k], NULL) || refuse_equal_indices(r, name[k])))
            return 0;
        if (v.low != NULL && !v.whole && name[k]->count > 0 && !is_each(scope, name[k])) {
            if (!suppose_between(r, scope, name[k], &v))
                return 0;
            continue;
        }
        if (v.whole && before != NULL && before->low != NULL) /* n \ge 1, n \in \mathbb{N} */
            w = *before, w.whole = 1, w.real = 0;
        if (v.real && v.low == NULL && v.high == NULL && v.dimension == 0 && before != NULL && !before->whole &&
            is_of_here) /* 0 \le x \le 1, x \in \mathbb{R} */
            w = *before, w.real = 1;
        if (!declare(r, scope, name[k], w))
            return 0;
    }
    return read;
}

int cagd_begins_range(const cagd_token *t)
{
    return t->kind == CAGD_TOKEN_LETTER &&
           (strcmp(t[1].word, "=") == 0 || (strcmp(t[1].word, "\\in") == 0 && strcmp(t[2].word, "\\{") == 0));
}

int cagd_read_index_range(cagd_reader *r, cagd_list *list)
{
    cagd_place start = cagd_here(r);
    if (!cagd_begins_range(r->token))
        return 0;
    const char *letter = r->token->word;
    int is_set = strcmp(r->token[1].word, "\\in") == 0;
    r->token += 2 + is_set;
    if (cagd_read_list(r, letter, list) <= 0 || list->high == NULL || (is_set && !cagd_pass(r, "\\}")))
        return cagd_back(r, start);
    return 1;
}

/* Where a range of that letter stands ahead, behind a comma or words; NULL where it does not. */
static const cagd_token *range_ahead(const cagd_reader *r, const char *letter)
{
    int depth = 0;
    for (const cagd_token *t = r->token; t->kind != CAGD_TOKEN_END; t++) {
        depth += (strchr("({[", t->word[0]) != NULL) - (strchr(")}]", t->word[0]) != NULL);
        if (depth == 0 && t > r->token && strchr(",;}", t[-1].word[0]) != NULL && cagd_begins_range(t) &&
            strcmp(t->word, letter) == 0)
            return t;
    }
    return NULL;
}

/* Letters whose ranges stand ahead are known, though they are not read yet; their number. */
static int bind_ranges_ahead(cagd_reader *r, struct cagd_bound room[CAGD_MOST_CHILDREN])
{
    int used = 0, depth = 0;
    for (const cagd_token *t = r->token; t->kind != CAGD_TOKEN_END && used < CAGD_MOST_CHILDREN; t++) {
        depth += (strchr("({[", t->word[0]) != NULL) - (strchr(")}]", t->word[0]) != NULL);
        if (depth == 0 && t > r->token && strchr(",;}", t[-1].word[0]) != NULL && cagd_begins_range(t) &&
            !cagd_is_known(r, t->word)) {
            room[used] = (struct cagd_bound){t->word, r->bound, 0};
            r->bound = &room[used++];
        }
    }
    return used;
}

/* The range that this list has of the letter, before what is read or behind it; 0 where it has none with an end. */
static int range_in_list(cagd_reader *r, const cagd_scope *before, const char *letter, cagd_list *list)
{
    const cagd_variable *v = cagd_declared(r->scope, letter);
    cagd_place start = cagd_here(r);
    if (v != NULL && v->whole && cagd_declared(before, letter) != v) {
        *list = (cagd_list){v->low, v->high, v->step > 1 ? v->step : 1, v->listed, v->listed_count, 1};
        return v->high != NULL && !v->low_open && !v->high_open;
    }
    const cagd_token *ahead = v == NULL && !cagd_is_known(r, letter) ? range_ahead(r, letter) : NULL;
    if (ahead == NULL)
        return 0;
    struct cagd_bound room[CAGD_MOST_CHILDREN];
    const struct cagd_bound *outside = r->bound;
    bind_ranges_ahead(r, room);
    r->token = ahead;
    int is = cagd_read_index_range(r, list);
    r->bound = outside;
    cagd_back(r, start);
    return is;
}

/* \lambda_i = -\lambda_{n+1-i}, which defines nothing: it is supposed for every i. */
static int suppose_for_every(cagd_reader *r, cagd_scope *scope, const cagd_tree *name, const cagd_tree *value)
{
    static const cagd_relation equal[] = {CAGD_EQUAL};
    const cagd_tree *letter = NULL;
    for (int k = 0; k < name->lower + name->upper; k++) {
        if (name->at[k]->kind == CAGD_NUMBER)
            continue;
        if (letter != NULL)
            return cagd_refuse_tree(r, name,
                                    "a condition for every index has one letter: write it behind the formula") != NULL;
        letter = name->at[k];
    }
    if (cagd_declared(scope, name->head) == NULL)
        return cagd_refuse_tree(r, name, "%s is defined by itself", cagd_spelled(name->head)) != NULL;
    const cagd_tree *t = cagd_relate(r, name->from, 2, (const cagd_tree *[]){name, value}, equal);
    cagd_tree *every = t != NULL && letter != NULL ? cagd_new(r, CAGD_EVERY_INDEX, t->from, 1) : NULL;
    if (every != NULL)
        every->head = letter->head, every->at[0] = t, every->to = t->to;
    return t != NULL && (letter == NULL || every != NULL) && cagd_suppose(scope, letter != NULL ? every : t);
}

/* i = 0, \dots, n; i = 0, 1, 2; i = 0(1)n; or n = 3, which is a definition.  -1: it is no such thing. */
static int numbers(cagd_reader *r, cagd_scope *scope)
{
    cagd_place start = cagd_here(r);
    cagd_variable v = {0};
    const cagd_tree *name = cagd_read_declared_name(r);
    if (name == NULL || !cagd_pass(r, "="))
        return cagd_back(r, start) - 1;
    cagd_list list;
    struct cagd_bound room[2 * CAGD_MOST_INDICES];
    const struct cagd_bound *outside = r->bound;
    bind_letters(r, name, room);
    int is_list = cagd_read_list(r, name->head, &list);
    r->bound = outside;
    if (is_list < 0)
        return 0;
    take_list(&v, &list);
    if (is_list)
        return declare(r, scope, name, v);
    for (const cagd_definition *same = scope->definitions; same != NULL; same = same->next)
        if (strcmp(same->left->head, name->head) == 0 && same->body != NULL && same->body->from == v.low->from &&
            same->left->from == name->from && same->left->to == name->to)
            return 1; /* it was read before what stands before it */
    if (cagd_refuse_values(r, name->head))
        return 0;
    if (name->count > 0 && name->arguments == 0 && cagd_tree_has(v.low, name->head))
        return suppose_for_every(r, scope, name, v.low);
    const cagd_tree *given = NULL;
    if (!cagd_is_left_side(r, name, 0) || cagd_refuse_degree(r, scope, name, v.low) ||
        (name = cagd_with_given_indices(r, scope, name, &given)) == NULL)
        return 0;
    cagd_definition *d = cagd_define(scope, name);
    if (d == NULL)
        return 0;
    d->body = v.low, d->dimension = v.low->dimension, d->when = given;
    const cagd_variable *had = name->count == 0 ? cagd_declared(scope, name->head) : NULL;
    if (had == NULL || had->whole || (had->low == NULL && had->high == NULL))
        return 1;
    const cagd_relation up[] = {had->low_open ? CAGD_LESS : CAGD_LESS_OR_EQUAL,
                                had->high_open ? CAGD_LESS : CAGD_LESS_OR_EQUAL};
    const cagd_tree *const ends[] = {had->low, name, had->high}; /* its bounds are those of its value */
    const int first = had->low == NULL;
    const cagd_tree *said = cagd_relate(r, name->from, first || had->high == NULL ? 2 : 3, ends + first, up + first);
    return said != NULL && cagd_suppose(scope, said);
}

/* The end of what comes next, if it is a range of an index, j = 0, 1, \dots, i - 1, or a chain with a name without indices in it, u_i \le u < u_{i+1}: both may have
 * letters whose ranges stand ahead.  Otherwise its beginning. */
static const cagd_token *end_of_item(cagd_reader *r)
{
    cagd_place start = cagd_here(r);
    struct cagd_bound room[CAGD_MOST_CHILDREN];
    const struct cagd_bound *outside = r->bound;
    cagd_list list;
    const cagd_token *end = start.token;
    cagd_relation relation;
    int used, depth = 0, alone = 0;
    used = bind_ranges_ahead(r, room);
    if (used > 0 && cagd_read_index_range(r, &list)) {
        end = r->token;
    } else if (used > 0 && !cagd_begins_range(start.token)) {
        for (int begins = 1; r->token->kind != CAGD_TOKEN_END; r->token++) {
            const cagd_token *t = r->token;
            depth += (strchr("({[", t->word[0]) != NULL) - (strchr(")}]", t->word[0]) != NULL);
            if (depth == 0 && strchr(",;", t->word[0]) != NULL)
                break;
            cagd_reader behind = *r;
            behind.token = t + 1;
            alone |= begins && depth == 0 && t->kind == CAGD_TOKEN_LETTER &&
                     (cagd_relation_next(&behind, &relation) || strchr(",;", t[1].word[0]) != NULL);
            begins = depth == 0 && cagd_relation_next(r, &relation);
        }
        end = alone ? r->token : start.token;
    }
    r->bound = outside;
    cagd_back(r, start);
    return end;
}

static int elements(cagd_reader *r, cagd_scope *scope, const cagd_scope *began, cagd_reading_error *listed);

/* Letters of the range or chain that comes next, whose own ranges stand behind it, j = 0, 1, \dots, i - 1, i = 1, 2, \dots, n: these are read before it. */
static void declare_ahead(cagd_reader *r, cagd_scope *scope, const cagd_scope *before, int depth)
{
    cagd_place start = cagd_here(r);
    const cagd_token *end = depth < CAGD_MOST_INDICES ? end_of_item(r) : start.token;
    for (const cagd_token *t = start.token; t < end; t++) {
        const cagd_token *ahead =
            t->kind == CAGD_TOKEN_LETTER && !cagd_is_known(r, t->word) ? range_ahead(r, t->word) : NULL;
        if (ahead == NULL || ahead < end)
            continue;
        cagd_scope as_it_was = *scope;
        cagd_reading_error listed;
        r->token = ahead;
        declare_ahead(r, scope, before, depth + 1);
        if ((strcmp(ahead[1].word, "\\in") == 0 ? elements(r, scope, before, &listed) : numbers(r, scope)) <= 0)
            *scope = as_it_was;
        cagd_back(r, start);
    }
}

/* Whether the token is an index, or in one: b_n, b_{i,n}. */
static int is_in_index(const cagd_token *first, const cagd_token *t)
{
    int depth = 0;
    for (; t > first; t--) {
        int opens = depth == 0 && t - 1 > first && strcmp(t[-1].word, "{") == 0;
        depth += (strcmp(t[-1].word, "}") == 0) - (strcmp(t[-1].word, "{") == 0 && depth > 0);
        if (depth == 0 && strcmp(t[opens ? -2 : -1].word, "_") == 0 && (opens || t[-1].word[0] == '_'))
            return t - opens > first;
        if (depth == 0 && !opens && strchr("=<>", t[-1].word[0]) != NULL)
            return 0;
    }
    return 0;
}

/* \omega_n = 1, n = 2: what is said of a letter that is an index here, and has one value or is called as last indices are, is read first, as if it stood
 * first. */
static void declare_degrees_ahead(cagd_reader *r, cagd_scope *scope, const cagd_scope *before)
{
    cagd_place start = cagd_here(r);
    for (const cagd_token *t = start.token; t->kind != CAGD_TOKEN_END; t++) {
        const cagd_token *ahead =
            t->kind == CAGD_TOKEN_LETTER && !cagd_is_known(r, t->word) && is_in_index(start.token, t)
                ? range_ahead(r, t->word)
                : NULL;
        if (ahead == NULL)
            continue;
        cagd_scope as_it_was = *scope;
        cagd_reading_error listed;
        cagd_list list;
        struct cagd_bound room[CAGD_MOST_CHILDREN];
        const struct cagd_bound *outside = r->bound;
        bind_ranges_ahead(r, room);
        r->token = ahead;
        int is_list = cagd_read_index_range(r, &list);
        r->bound = outside;
        cagd_back(r, (cagd_place){ahead, start.depth});
        if (is_list && !cagd_is_called_as_last(t->word)) {
            cagd_back(r, start);
            continue;
        }
        declare_ahead(r, scope, before, 0);
        if ((strcmp(ahead[1].word, "\\in") == 0 ? elements(r, scope, before, &listed) : numbers(r, scope)) <= 0)
            *scope = as_it_was;
        cagd_back(r, start);
    }
}

struct piece {
    const cagd_tree *tree;
    int alone; /* a name that is no whole number and nothing defined: 1; a whole number: -1; w_{i,0}, some of the names of a kind: 0 */
};

/* w_0 is one of the w_i: what is said of it is not said of the others. */
static int has_number(const cagd_tree *name)
{
    for (int k = 0; k < name->lower + name->upper; k++)
        if (name->at[k]->kind == CAGD_NUMBER)
            return 1;
    return 0;
}

/* A member of a chain of relations: a name by itself, which need not be known, or a value. */
static int piece(cagd_reader *r, struct piece *p)
{
    cagd_place start = cagd_here(r);
    cagd_relation relation;
    const cagd_tree *name = cagd_read_declared_name(r);
    if (name != NULL && name->arguments == 0 &&
        (cagd_relation_next(r, &relation) || cagd_next_is(r, ",") || r->token->kind == CAGD_TOKEN_END)) {
        const cagd_variable *v = cagd_declared(r->scope, name->head);
        int is_pi = v == NULL && strcmp(name->head, "\\pi") == 0, is_letter = cagd_is_bound(r, name->head);
        *p = (struct piece){name, is_pi || is_letter || cagd_defined(r->scope, name->head) != NULL ? 0
                                  : v != NULL && v->whole                                          ? -1
                                                                                                   : 1};
        return 1;
    }
    cagd_back(r, start);
    r->supposing++;
    *p = (struct piece){cagd_read_sum(r), 0};
    r->supposing--;
    return p->tree != NULL;
}

/* The indices of the variable are called as in the name; in a bound that it had before, and that is none of these pieces, too. */
static void take_letters(cagd_variable *v, const cagd_tree *name, const struct piece p[], int count)
{
    const cagd_tree **bound[2] = {&v->low, &v->high}, *left = v->left;
    v->left = name;
    for (int m = 0; m < 2; m++) {
        int is_new = 0;
        for (int k = 0; k < count; k++)
            is_new |= p[k].tree == *bound[m];
        for (int k = 0; left != NULL && k < left->lower + left->upper && !is_new; k++)
            if (left->at[k]->kind == CAGD_NAME)
                *bound[m] = cagd_tree_with(*bound[m], left->at[k]->head, name->at[k]);
    }
}

static int is_less(cagd_relation a) { return a == CAGD_LESS || a == CAGD_LESS_OR_EQUAL; }
static int is_greater(cagd_relation a) { return a == CAGD_GREATER || a == CAGD_GREATER_OR_EQUAL; }
static int is_strict(cagd_relation a) { return a == CAGD_LESS || a == CAGD_GREATER; }

/* Whether a bound says all that another one says, which may be NULL: of numbers, those are compared. */
static int is_tighter(const cagd_tree *bound, int strict, const cagd_tree *before, int up)
{
    if (before == NULL)
        return 1;
    cagd_num_q a, b;
    if (!cagd_is_plain_number(bound, &a) || !cagd_is_plain_number(before, &b))
        return 0;
    int order = cagd_compare_q(a, b);
    return (up ? order > 0 : order < 0) || (order == 0 && strict);
}

/* A name in an index that means nothing, and is not called `besides`; NULL where there is none. */
static const cagd_tree *letter_without_meaning(const cagd_reader *r, const cagd_tree *t, const char *besides,
                                               int in_index)
{
    if (t->kind == CAGD_NAME && t->count == 0)
        return in_index && !cagd_is_known(r, t->head) && !cagd_is_label(r->scope, t->head) &&
                       (besides == NULL || strcmp(besides, t->head) != 0)
                   ? t
                   : NULL;
    const cagd_tree *found = NULL;
    for (int k = 0; k < t->count && found == NULL; k++)
        found =
            letter_without_meaning(r, t->at[k], besides, in_index || (t->kind == CAGD_NAME && k < t->lower + t->upper));
    return found;
}

/* Where something is said of that letter that is no list of its numbers: i \ge 1, 1 \le i \le n, i \ne 0; NULL where nothing is. */
static const cagd_token *said_of_letter(const cagd_reader *r, const char *letter)
{
    cagd_relation relation;
    int depth = 0, behind_relation = 0;
    for (cagd_reader at = *r; at.token->kind != CAGD_TOKEN_END; at.token++) {
        const cagd_token *t = at.token;
        depth += (strchr("({[", t->word[0]) != NULL) - (strchr(")}]", t->word[0]) != NULL);
        cagd_reader next = at;
        next.token++;
        if (depth == 0 && strcmp(t->word, letter) == 0 && (t == r->token || strcmp(t[-1].word, "_") != 0) &&
            (behind_relation || cagd_relation_next(&next, &relation) || strcmp(t[1].word, "\\in") == 0 ||
             strcmp(t[1].word, "\\notin") == 0))
            return t;
        behind_relation = cagd_relation_next(&at, &relation);
    }
    return NULL;
}

/* u_i \le u_{i+1}, the letter i meaning nothing: for every index. */
static const cagd_tree *for_every_index(cagd_reader *r, const cagd_scope *before, const cagd_tree *t)
{
    cagd_list list;
    const cagd_tree *letter = letter_without_meaning(r, t, NULL, 0);
    const cagd_tree *other = letter != NULL ? letter_without_meaning(r, t, letter->head, 0) : NULL;
    if (letter == NULL)
        return t;
    if (other != NULL)
        return cagd_refuse_tree(r, other, "a condition for every index has one letter: %s or %s", letter->head,
                                other->head);
    if (range_in_list(r, before, letter->head, &list)) {
        cagd_tree *all = (cagd_tree *)cagd_over_list(r, CAGD_FOR_ALL, t->from, letter->head, &list, t);
        if (all != NULL)
            all->to = t->to;
        return all;
    }
    const cagd_token *said = said_of_letter(r, letter->head);
    if (said != NULL) {
        r->token = said;
        return cagd_refuse_token(r, "for which %s is this supposed? write a list behind it, such as %s = 1, \\dots, 4",
                                 letter->head, letter->head);
    }
    cagd_tree *every = cagd_new(r, CAGD_EVERY_INDEX, t->from, 1);
    if (every != NULL)
        every->head = letter->head, every->at[0] = t, every->to = t->to;
    return every;
}

/* The name whose bounds the chain that comes next tells, if it has indices: the first member that is a name by itself. */
static const cagd_tree *name_ahead(cagd_reader *r)
{
    cagd_place start = cagd_here(r);
    cagd_relation relation;
    const cagd_tree *found = NULL;
    for (int depth = 0, begins = 1; found == NULL && r->token->kind != CAGD_TOKEN_END; r->token++) {
        cagd_place at = cagd_here(r);
        const char word = r->token->word[0];
        if (begins && depth == 0 && (found = cagd_read_declared_name(r)) != NULL &&
            (found->count == 0 || found->arguments > 0 ||
             !(cagd_relation_next(r, &relation) || cagd_next_is(r, ",") || r->token->kind == CAGD_TOKEN_END)))
            found = NULL;
        cagd_back(r, at);
        begins = cagd_relation_next(r, &relation);
        depth += (strchr("({[", word) != NULL) - (strchr(")}]", word) != NULL);
        if (depth == 0 && (word == ',' || word == ';'))
            break;
    }
    cagd_back(r, start);
    return found;
}

/* Bounds of \lambda_i may have n, the range of which is told later, behind them or for a statement: a letter that last indices are called, or that
 * has a range ahead. */
static void bind_degrees(cagd_reader *r, struct cagd_bound room[CAGD_MOST_CHILDREN])
{
    int used = bind_ranges_ahead(r, room), depth = 0;
    for (const cagd_token *t = r->token; t->kind != CAGD_TOKEN_END && used < CAGD_MOST_CHILDREN; t++) {
        depth += (strchr("({[", t->word[0]) != NULL) - (strchr(")}]", t->word[0]) != NULL);
        if (depth == 0 && strchr(",;", t->word[0]) != NULL)
            break;
        if (t->kind == CAGD_TOKEN_LETTER && t->word[1] == '\0' && strchr("nmNM", t->word[0]) != NULL &&
            !cagd_is_known(r, t->word)) {
            room[used] = (struct cagd_bound){t->word, r->bound, 0};
            r->bound = &room[used++];
        }
    }
}

/* -1 \le \lambda < 1: bounds of the only variable, or else a condition.  What was said before this list of ranges, in `before`, of a
 * variable that is no whole number is replaced; what this list says itself holds as well. */
static int chain(cagd_reader *r, cagd_scope *scope, const cagd_scope *before)
{
    struct piece p[CAGD_MOST_INDICES];
    cagd_relation relation[CAGD_MOST_INDICES];
    int count = 0, alone = 0, whole = 0, which = 0, from = r->token->from, up = 1, down = 1, some_index = 0;
    struct cagd_bound room[2 * CAGD_MOST_INDICES];
    const struct cagd_bound *outside = r->bound;
    struct cagd_bound degree[CAGD_MOST_CHILDREN];
    const cagd_tree *name = name_ahead(r);
    bind_letters(r, name, room);
    if (name != NULL)
        bind_degrees(r, degree);
    do {
        if (count == CAGD_MOST_INDICES)
            return cagd_refuse_token(r, "more than %d relations", CAGD_MOST_INDICES - 1) != NULL;
        if (count > 0 && cagd_next_is(r, "\\dots"))
            cagd_refuse_token(r, "what is left out? of every index it is said as u_i \\le u_{i+1}");
        if ((count > 0 && cagd_next_is(r, "\\dots")) || !piece(r, &p[count])) {
            r->bound = outside;
            return 0;
        }
        which = p[count].alone > 0 || (p[count].alone < 0 && alone == 0) ? count : which;
        alone += p[count].alone > 0;
        whole += p[count].alone < 0;
    } while (cagd_relation_next(r, &relation[count++]) && r->token++);
    r->bound = outside;
    if (count == 1)
        return cagd_refuse_token(r, "expected a range or a condition, not %s", cagd_name_of_next(r)) != NULL;
    if (cagd_changes_direction(relation, count - 1))
        return cagd_refuse_token(r, "a chain with < and >: put a comma between two ranges") != NULL;
    for (int k = 0; k < count; k++) {
        const cagd_tree *t = p[k].tree;
        int is_name = p[k].alone > 0 || (t->kind == CAGD_NAME && has_number(t) && cagd_defined(scope, t->head) == NULL);
        if (is_name && cagd_declared(scope, t->head) == NULL && !declare(r, scope, t, (cagd_variable){0}))
            return 0;
        some_index |= p[k].alone == 0 && letter_without_meaning(r, p[k].tree, NULL, 0) != NULL;
        up &= k + 1 == count || is_less(relation[k]);
        down &= k + 1 == count || is_greater(relation[k]);
    }
    if (alone == 1 && refuse_equal_indices(r, p[which].tree))
        return 0;
    if (!some_index && (alone == 1 || (alone == 0 && whole == 1)) && count <= 3 && (up || down) &&
        (count == 2 || which == 1) && (is_one_of_many(p[which].tree) || is_each(scope, p[which].tree))) {
        if (cagd_refuse_degree(r, scope, p[which].tree, NULL))
            return 0;
        cagd_variable v, was;
        cagd_scope place = *before;
        place.variables = scope->in_block ? scope->block : before->variables;
        const cagd_variable *old = declaration_of(&place, p[which].tree, &was) ? &was : NULL;
        declaration_of(scope, p[which].tree, &v);
        const cagd_variable *one =
            is_one_of_many(p[which].tree) ? NULL : one_of_those(scope, p[which].tree, before->variables);
        if (one != NULL)
            return cagd_refuse_tree(r, p[which].tree, "bounds of all of them stand before those of %s alone",
                                    one->head) != NULL;
        if (v.left != NULL && (v.left->lower != p[which].tree->lower || v.left->upper != p[which].tree->upper))
            return cagd_refuse_tree(r, p[which].tree, "%s had other indices before", p[which].tree->head) != NULL;
        int replaces = v.head != NULL && v.step <= 1 && v.listed == NULL;
        for (int k = 0; k < count; k++) {
            if (k == which)
                continue;
            int strict = is_strict(relation[k < which ? k : which]), below = (k < which) == up;
            const cagd_tree *bound = below ? v.low : v.high;
            int is_replaced = (!v.whole && old != NULL && bound == (below ? old->low : old->high)) ||
                              (bound != NULL && bound->from == p[k].tree->from);
            replaces &= is_replaced || is_tighter(p[k].tree, strict, bound, below);
            if (below)
                v.low = p[k].tree, v.low_open = strict;
            else
                v.high = p[k].tree, v.high_open = strict;
        }
        if (replaces) {
            take_letters(&v, p[which].tree, p, count);
            return cagd_declare(scope, v);
        }
    }
    const cagd_tree *list[CAGD_MOST_INDICES];
    for (int k = 0; k < count; k++)
        list[k] = p[k].tree;
    const cagd_tree *t = cagd_relate(r, from, count, list, relation);
    return t != NULL && (t = for_every_index(r, before, t)) != NULL && cagd_suppose(scope, t);
}

/* The words before a range, of which "even" and "odd" say something of its letter: 1, and -1, 1 in *parity, or 0; 0 and the error where other words stand there. */
static int pass_words_before(cagd_reader *r, int *parity)
{
    *parity = 0;
    for (;;) {
        const cagd_token *here = r->token;
        const char *words = cagd_read_words(r);
        if (words == NULL && !cagd_pass(r, "\\forall"))
            return 1;
        if (words == NULL)
            continue;
        if (!cagd_are_words_of_range(words)) {
            r->token = here;
            return cagd_refuse_words(r, words) != NULL;
        }
        *parity = cagd_parity_of_words(words) != 0 ? cagd_parity_of_words(words) : *parity;
    }
}

/* That letter, which has its range, is even or odd. */
struct parity {
    const cagd_token *letter;
    int parity, from, to;
};
static int suppose_parity(cagd_reader *r, cagd_scope *scope, struct parity p)
{
    const cagd_token *here = r->token;
    r->token = p.letter != NULL ? p.letter : here;
    cagd_tree *t = (cagd_tree *)cagd_is_of_parity(r, p.parity);
    if (t == NULL)
        return 0;
    r->token = here;
    t->from = p.from, t->to = p.to;
    return cagd_suppose(scope, t);
}

/* x \ge 0 \text{ if } y \ge 0: bounds that hold under a condition are none; behind a range, n = 1, 2 \text{ if } y \ge 0, all of it is supposed. */
static int refuse_condition_of_bounds(cagd_reader *r, const cagd_token *item)
{
    static const char *const words[] = {"if", "when", "provided", "as long as"};
    const cagd_token *here = r->token;
    const char *said = item != NULL && !cagd_begins_range(item) ? cagd_read_words(r) : NULL;
    r->token = here;
    for (size_t k = 0; said != NULL && k < sizeof words / sizeof *words; k++)
        if (strncmp(said + strspn(said, " ~"), words[k], strlen(words[k])) == 0)
            return cagd_refuse_token(
                       r,
                       "is what stands before '%s' supposed under that condition alone, or both? write 'and', or "
                       "the condition in the formula",
                       said) == NULL;
    return 0;
}

static int ends_range(const cagd_token *t) { return t->kind == CAGD_TOKEN_END || strchr(",;.", t->word[0]) != NULL; }

int cagd_read_list_of_ranges(cagd_reader *r, cagd_scope *scope, const cagd_scope *before)
{
    const cagd_token *first = NULL, *last;
    struct parity said[CAGD_MOST_INDICES];
    int parities = 0;
    do {
        cagd_reading_error listed = {0};
        int from = r->token->from;
        int parity, is_alone;
        if (refuse_condition_of_bounds(r, first) || !pass_words_before(r, &parity))
            return 0;
        int behind = parity != 0 && ends_range(r->token);
        last = first, first = r->token;
        if (parity == 0 && cagd_next_is_parity(r)) {
            r->token++;
            parity = cagd_parity_of_words(cagd_read_words(r));
            is_alone = 1;
        } else {
            is_alone = parity != 0 && first->kind == CAGD_TOKEN_LETTER && ends_range(first + 1);
            r->token += is_alone;
        }
        if (parity != 0) { /* n = 1..8 \text{ even}, n \text{ even}, \text{even } n */
            if (parities == CAGD_MOST_INDICES)
                return cagd_refuse_token(r, "more than %d numbers that are even or odd", CAGD_MOST_INDICES) != NULL;
            said[parities++] = behind ? (struct parity){last, parity, last != NULL ? last->from : from, r->token[-1].to}
                                      : (struct parity){first, parity, from, is_alone ? r->token[-1].to : first->to};
            if (behind || is_alone)
                continue;
        }
        cagd_share_value(r);
        declare_degrees_ahead(r, scope, before);
        declare_ahead(r, scope, before, 0);
        int done = elements(r, scope, before, &listed);
        if (done < 0)
            done = numbers(r, scope);
        if (done < 0)
            done = cagd_share_bounds(r) && chain(r, scope, before);
        if (!done && listed.from > r->error->from)
            *r->error = listed;
        if (!done)
            return 0;
    } while (cagd_pass(r, ",") || cagd_pass(r, ";") || cagd_next_is(r, "\\text"));
    for (int k = 0; k < parities; k++)
        if (!suppose_parity(r, scope, said[k]))
            return 0;
    return cagd_restrict_to_ranges(r, scope, before);
}

int cagd_read_ranges(cagd_scope *scope, const char *text, int from, int to, cagd_reading_error *error)
{
    cagd_reader r;
    cagd_scope before = *scope;
    if (!cagd_reader_open(&r, scope, text, from, to, error))
        return 0;
    int good = cagd_read_list_of_ranges(&r, scope, &before);
    if (good && r.token->kind != CAGD_TOKEN_END)
        good = cagd_refuse_token(&r, "expected a comma or the end, not %s", cagd_name_of_next(&r)) != NULL;
    if (!good)
        *scope = before;
    return good;
}
