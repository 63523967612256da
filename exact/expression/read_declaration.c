/* read_declaration.c -- lines that say what names mean, and for what a statement is said. */
#include "exact/expression/reader.h"
#include "exact/words.h"

#include <stdio.h>
#include <string.h>

/* Tries that fail leave no trace. */
struct place {
    const cagd_token *token;
    int depth;
};
static struct place here(const cagd_reader *r) { return (struct place){r->token, r->depth}; }
static int back(cagd_reader *r, struct place p)
{
    r->token = p.token, r->depth = p.depth;
    *r->error = (cagd_reading_error){0};
    return 0;
}

/* A name as it is declared: its indices are letters or numbers. */
static const cagd_tree *declared_name(cagd_reader *r)
{
    if (!cagd_begins_name(r))
        return NULL;
    r->declaring = 1;
    const cagd_tree *t = cagd_read_name(r);
    r->declaring = 0;
    return t != NULL && t->kind == CAGD_NAME ? t : NULL;
}

/* ---- definitions --------------------------------------------------------------------------------------- */

/* Whether it fits whatever is given, so that nothing behind it is ever taken. */
static int fits_always(const cagd_definition *d)
{
    for (int k = 0; k < d->left->count; k++)
        if (d->left->at[k]->kind == CAGD_NUMBER || cagd_same_index(d->left, k) >= 0)
            return 0;
    return d->when == NULL;
}

/* Whether it fits wherever a definition of `left` would, which is then never taken: Q_0(t) and Q_0(s). */
static int takes_all_of(const cagd_definition *d, const cagd_tree *left)
{
    if (d->when != NULL || d->left->count != left->count || d->left->lower != left->lower)
        return 0;
    for (int k = 0; k < left->count; k++) {
        const cagd_tree *a = d->left->at[k], *b = left->at[k];
        if (cagd_same_index(d->left, k) >= 0 || (a->kind == CAGD_NUMBER && !cagd_tree_equal(a, b)))
            return 0;
    }
    return 1;
}

/* Letters and numbers; a letter stands there twice where indices are equal, as in b_{n,n}(t), if `may_repeat`, and else once.  Arguments are
 * letters.  As often as the same name was defined with. */
static int is_left_side(cagd_reader *r, const cagd_tree *left, int may_repeat)
{
    for (int k = 0; k < left->count; k++) {
        const cagd_tree *t = left->at[k];
        int letter = t->kind == CAGD_NAME && t->count == 0, index = k < left->lower + left->upper;
        if (!letter && !(index && t->kind == CAGD_NUMBER))
            return cagd_refuse_tree(r, t, "on the left of a definition %s",
                                    index ? "an index is a letter or a number" : "an argument is a letter") != NULL;
        for (int m = 0; letter && !(index && may_repeat) && m < k; m++)
            if (left->at[m]->kind == CAGD_NAME && strcmp(left->at[m]->head, t->head) == 0)
                return cagd_refuse_tree(r, t,
                                        "the letter %s stands there twice: take another one, and say where they are "
                                        "equal behind \\quad",
                                        t->head) != NULL;
    }
    if (left->upper > 0 && left->lower + left->arguments == 0)
        return cagd_refuse_tree(r, left, "a power is no name: define %s", cagd_spelled(left->head)) != NULL;
    for (const cagd_definition *d = r->scope->definitions; d != NULL; d = d->next)
        if (strcmp(d->left->head, left->head) == 0 && fits_always(d))
            return cagd_refuse_tree(r, left, "%s was defined already, for all indices and arguments",
                                    cagd_spelled(left->head)) != NULL;
        else if (strcmp(d->left->head, left->head) == 0 && takes_all_of(d, left))
            return cagd_refuse_tree(r, left, "it was defined already, so that this line would mean nothing") != NULL;
    const cagd_definition *d = cagd_defined(r->scope, left->head);
    if (d != NULL &&
        (d->left->lower != left->lower || d->left->upper != left->upper || d->left->arguments != left->arguments))
        return cagd_refuse_tree(r, left, "%s was defined with %d lower, %d upper indices and %d arguments",
                                cagd_spelled(left->head), d->left->lower, d->left->upper, d->left->arguments) != NULL;
    return 1;
}

/* "=", or ":=". */
static int is_equal_sign(const cagd_token *t) { return strcmp(t->word, "=") == 0 || strcmp(t->word, ":=") == 0; }

/* Whether a function with its arguments and "=" come next: another definition. */
static int next_definition(const cagd_reader *r)
{
    const cagd_token *t = r->token;
    int depth = 0, has_arguments = 0;
    if (!cagd_begins_name(r))
        return 0;
    for (; t->kind != CAGD_TOKEN_END && (depth > 0 || strchr("=<>,:", t->word[0]) == NULL); t++) {
        depth += (strchr("({[", t->word[0]) != NULL) - (strchr(")}]", t->word[0]) != NULL);
        has_arguments |= strcmp(t->word, "(") == 0;
    }
    return has_arguments && is_equal_sign(t) && strcmp(t[-1].word, ")") == 0;
}

/* i = 0, 1, \dots, n as a condition: 0 \le i \le n. */
static const cagd_tree *index_range(cagd_reader *r)
{
    static const cagd_relation between[2] = {CAGD_LESS_OR_EQUAL, CAGD_LESS_OR_EQUAL};
    const cagd_token *t = r->token;
    while (t->kind != CAGD_TOKEN_END && strcmp(t->word, "\\dots") != 0)
        t++;
    if (r->token->kind != CAGD_TOKEN_LETTER || strcmp(r->token[1].word, "=") != 0 || t->kind == CAGD_TOKEN_END)
        return NULL;
    const cagd_tree *name = cagd_read_name(r), *high = NULL;
    cagd_pass(r, "=");
    r->ends++;
    const cagd_tree *low = name != NULL ? cagd_read_sum(r) : NULL;
    r->ends--;
    while (low != NULL && cagd_pass(r, ",") && !cagd_next_is(r, "\\dots"))
        if (cagd_read_sum(r) == NULL)
            return NULL;
    if (low != NULL && cagd_expect(r, "\\dots", "the first numbers")) {
        cagd_pass(r, ",");
        high = cagd_read_sum(r);
    }
    return high != NULL ? cagd_relate(r, name->from, 3, (const cagd_tree *[]){low, name, high}, between) : NULL;
}

/* What stands behind the comma of a definition: conditions, ranges of indices and intervals, with commas between. */
static const cagd_tree *condition(cagd_reader *r)
{
    const cagd_tree *first = cagd_next_is_member(r) ? cagd_read_members(r) : index_range(r);
    if (first == NULL)
        return r->error->message[0] == '\0' ? cagd_read_alternatives(r) : NULL;
    if (!(cagd_pass(r, ",") || cagd_pass(r, ";")) || r->token->kind == CAGD_TOKEN_END)
        return first;
    const cagd_tree *more = condition(r);
    return cagd_new_of(r, CAGD_ALL, first->from, 2, (const cagd_tree *[]){first, more});
}

static int definition(cagd_reader *r, cagd_scope *scope);

/* The right side of a definition, in which the arguments of the left side are known, and what stands behind it. */
static int right_side(cagd_reader *r, cagd_scope *scope, const cagd_tree *left)
{
    struct cagd_bound bound[CAGD_MOST_CHILDREN];
    const struct cagd_bound *outside = r->bound;
    for (int k = 0; k < left->count; k++)
        if (left->at[k]->kind == CAGD_NAME) {
            bound[k] = (struct cagd_bound){left->at[k]->head, r->bound};
            r->bound = &bound[k];
        }
    cagd_definition *d = cagd_define(scope, left);
    const cagd_tree *body = d != NULL ? cagd_read_sum(r) : NULL;
    int read = body != NULL;
    if (read) {
        d->body = body, d->dimension = body->dimension;
        int bracket = cagd_is_truth_in_brackets(r); /* f(t) = t^2 \quad (0 \le t \le 1) */
        if (cagd_pass(r, ",") || cagd_next_is(r, "\\text") || bracket) {
            cagd_read_words(r);
            bracket = cagd_is_truth_in_brackets(r) && cagd_pass(r, "(");
            read = r->token->kind == CAGD_TOKEN_END || next_definition(r) ||
                   ((d->when = condition(r)) != NULL && (!bracket || cagd_expect(r, ")", "the condition")));
        }
    }
    r->bound = outside;
    return read;
}

static int definition(cagd_reader *r, cagd_scope *scope)
{
    r->declaring = 1;
    const cagd_tree *left = cagd_read_name(r);
    r->declaring = 0;
    if (left == NULL)
        return 0;
    if (left->kind != CAGD_NAME)
        return cagd_refuse_tree(r, left, "the left side of a definition is a name with its indices and arguments") !=
               NULL;
    if (!is_left_side(r, left, 1) || (!cagd_pass(r, ":=") && !cagd_expect(r, "=", "the left side")))
        return 0;
    if (!right_side(r, scope, left))
        return 0;
    return !next_definition(r) || definition(r, scope);
}

static int is_zero_over_zero(const cagd_token *t)
{
    static const char *const written[][8] = {
        {"0", "/", "0", NULL}, {"\\frac", "{", "0", "}", "{", "0", "}", NULL}, {"\\frac", "00", NULL}};
    for (int k = 0; k < 3; k++) {
        int m = 0;
        while (written[k][m] != NULL && strcmp(t[m].word, written[k][m]) == 0)
            m++;
        if (written[k][m] == NULL && is_equal_sign(t + m) && strcmp(t[m + 1].word, "0") == 0) /* words may follow */
            return t[m + 2].kind == CAGD_TOKEN_END || strchr(".,;", t[m + 2].word[0]) != NULL ||
                   strcmp(t[m + 2].word, "\\text") == 0;
    }
    return 0;
}

/* Whether the line is "name = ...", and no range: the first relation that stands in no bracket. */
static int is_definition(const cagd_token *t)
{
    const cagd_token *first = t;
    int depth = 0;
    for (; t->kind != CAGD_TOKEN_END; t++) {
        depth += (strchr("({[", t->word[0]) != NULL) - (strchr(")}]", t->word[0]) != NULL);
        if (depth == 0 &&
            (strcmp(t->word, "\\in") == 0 || strchr("<>", t->word[0]) != NULL || strcmp(t->word, "\\le") == 0 ||
             strcmp(t->word, "\\ge") == 0 || strcmp(t->word, "\\ne") == 0))
            return 0;
        if (depth == 0 && is_equal_sign(t))
            break;
    }
    if (t > first + 1 || strcmp(t->word, ":=") == 0) /* the name of a range is a letter */
        return 1;
    for (int inner = 0; t->kind != CAGD_TOKEN_END; t++) {
        inner += (strchr("({[", t->word[0]) != NULL) - (strchr(")}]", t->word[0]) != NULL);
        if (inner == 0 && strcmp(t->word, "\\dots") == 0)
            return strchr("+-*", t[-1].word[0]) != NULL; /* or what is left out of a sum or product */
    }
    return 1;
}

static int ranges(cagd_reader *r, cagd_scope *scope, const cagd_scope *before);

/* Whether a \quad ends before the token. */
static int is_behind_quad(const cagd_reader *r, const cagd_token *t)
{
    int at = t->from;
    while (at > 0 && r->text[at - 1] == ' ')
        at--;
    return at >= 4 && memcmp(r->text + at - 4, "quad", 4) == 0;
}

/* \quad (n \ge 3) at the end of a definition is read as \quad, n \ge 3. */
static void open_last_bracket(const cagd_reader *r)
{
    int depth = 0, relations = 0;
    cagd_token *first = (cagd_token *)r->token, *last = first, *t; /* they are this reader's own */
    while (last->kind != CAGD_TOKEN_END)
        last++;
    if (last == first || strcmp((--last)->word, ")") != 0)
        return;
    for (t = last; t > first; t--) {
        depth += (strchr(")}]", t->word[0]) != NULL) - (strchr("({[", t->word[0]) != NULL);
        if (depth == 0)
            break;
        cagd_reader here = *r;
        cagd_relation relation;
        here.token = t;
        relations += depth == 1 && (cagd_relation_next(&here, &relation) || cagd_next_is(&here, "\\in"));
    }
    if (t == first || relations == 0 || !is_behind_quad(r, t))
        return;
    t->word = ",", last->kind = CAGD_TOKEN_END;
}

/* \begin{cases} b_0(t) = ..., \\ b_1(t) = ... \end{cases} with nothing before it: each row a definition, with an END behind it: their number; 1 for another line. */
static int open_cases(cagd_reader *r)
{
    enum { AROUND = 4 };                                    /* \begin { cases } */
    cagd_token *t = (cagd_token *)r->token, *end = t, *out; /* they are this reader's own */
    while (end->kind != CAGD_TOKEN_END)
        end++;
    if (end - t < 2 * AROUND || strcmp(t->word, "\\begin") != 0)
        return 1;
    cagd_reader at = *r;
    at.token = t + 1;
    if (!cagd_environment(&at, "cases"))
        return 1;
    int rows = 1;
    long around = at.token - t;
    at.token = end - around + 1;
    if (strcmp(end[-around].word, "\\end") != 0 || !cagd_environment(&at, "cases") || at.token != end)
        return 1;
    out = t;
    for (const cagd_token *k = t + around; k < end - around; k++) {
        int is_break = strcmp(k->word, "\\\\") == 0;
        if (strcmp(k->word, "&") == 0)
            continue;
        if (is_break && out > t && strchr(",;.", out[-1].word[0]) != NULL)
            out--;
        *out = *k;
        out->kind = is_break ? CAGD_TOKEN_END : k->kind;
        rows += is_break;
        out++;
    }
    *out = *end;
    return rows - (out > t && out[-1].kind == CAGD_TOKEN_END);
}

int cagd_read_definition(cagd_scope *scope, const char *text, int from, int to, cagd_reading_error *error)
{
    cagd_reader r;
    cagd_scope before = *scope;
    if (!cagd_reader_open(&r, scope, text, from, to, error))
        return 0;
    if (is_zero_over_zero(r.token)) {
        scope->zero_over_zero = 1;
        return 1;
    }
    int rows = open_cases(&r);
    if (is_definition(r.token))
        open_last_bracket(&r);
    int good = is_definition(r.token) ? definition(&r, scope) : ranges(&r, scope, &before);
    for (; rows > 1 && good; rows--) {
        cagd_pass(&r, ",");
        good = r.token->kind == CAGD_TOKEN_END
                   ? (r.token++, definition(&r, scope))
                   : cagd_refuse_token(&r, "expected the end of the row, not %s", cagd_name_of_next(&r)) != NULL;
    }
    if (good && (cagd_pass(&r, "."), r.token->kind != CAGD_TOKEN_END))
        good = cagd_refuse_token(&r, "expected the end of the line, not %s", cagd_name_of_next(&r)) != NULL;
    if (!good)
        *scope = before;
    return good;
}

/* ---- ranges -------------------------------------------------------------------------------------------- */

/* Whether the name stands for one alone, as \omega_3; \omega_i stands for all. */
static int is_one_of_many(const cagd_tree *name)
{
    for (int k = 0; k < name->count; k++)
        if (name->at[k]->kind != CAGD_NUMBER || !cagd_is_whole_q(name->at[k]->number))
            return 0;
    return name->count > 0 && name->arguments == 0;
}

/* The name under which the declaration of one alone is kept. */
static const char *key_of_one(const cagd_tree *name)
{
    char key[96];
    long index[2 * CAGD_MOST_INDICES];
    for (int k = 0; k < name->count; k++)
        index[k] = mpz_get_si(mpq_numref(name->at[k]->number.at));
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

static int dots(cagd_reader *r, const cagd_tree **high);
static const cagd_tree *listed(cagd_reader *r, const cagd_tree *first);

/* ℕ, or \{0, \dots, n\}. */
static int whole_numbers(cagd_reader *r, cagd_variable *v)
{
    v->whole = 1;
    v->low = cagd_tree_number(0, r->token->from, r->token->to);
    if (cagd_pass(r, "\\N"))
        return 1;
    r->token++;
    r->ends++;
    v->low = cagd_read_sum(r);
    r->ends--;
    if (v->low == NULL)
        return 0;
    int has_dots = dots(r, &v->high);
    if (has_dots == 0)
        v->high = listed(r, v->low);
    if (has_dots >= 0 && v->high == NULL)
        return cagd_refuse_token(
                   r, "expected whole numbers one behind another, such as \\{0, 1, 2\\} or \\{0, \\dots, n\\}") != NULL;
    return has_dots >= 0 && cagd_expect(r, "\\}", "the numbers");
}

/* Behind \in: \mathbb{R}, \mathbb{N}, \mathbb{Z}^+, [a,b], (a,b), \{0, \dots, n\}. */
static int set(cagd_reader *r, cagd_variable *v)
{
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
        v->whole = letter->word[0] != 'R';
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
            room[used] = (struct cagd_bound){name->at[k]->head, r->bound};
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

/* x, y, P_i \in SET, or P_0, P_1, \dots, P_n \in SET.  -1: it is no such thing; then *listed is what was wrong behind a comma. */
static int elements(cagd_reader *r, cagd_scope *scope, cagd_reading_error *listed)
{
    const cagd_tree *name[CAGD_MOST_CHILDREN];
    struct place start = here(r);
    int count = 0;
    do {
        if (count > 0 && cagd_pass(r, "\\dots") && !cagd_pass(r, ","))
            return back(r, start) - 1;
        if (count == CAGD_MOST_CHILDREN || (name[count++] = declared_name(r)) == NULL) {
            if (count > 1 && !cagd_begins_name(r))
                cagd_refuse_token(r, "expected a name, not %s", cagd_name_of_next(r));
            *listed = count > 1 ? *r->error : (cagd_reading_error){0};
            return back(r, start) - 1;
        }
    } while (cagd_pass(r, ","));
    if (!cagd_pass(r, "\\in"))
        return back(r, start) - 1;
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
        if (v.low != NULL && !v.whole && is_one_of_many(name[k])) {
            if ((before == NULL && !declare(r, scope, name[k], (cagd_variable){0})) || !declare_one(scope, name[k], v))
                return 0;
            continue;
        }
        if (v.whole && before != NULL && before->low != NULL) /* n \ge 1, n \in \mathbb{N} */
            w = *before, w.whole = 1;
        if (!declare(r, scope, name[k], w))
            return 0;
    }
    return read;
}

/* Behind the first number of a range: "..n", ", 2, \dots, n", ", \dots"; the last number, or NULL in *high where there is none.
 * 0: there are no dots, and nothing was passed; -1: an error. */
static int dots(cagd_reader *r, const cagd_tree **high)
{
    struct place start = here(r);
    *high = NULL;
    int comma = cagd_pass(r, ",");
    for (int k = 0; comma && k < 3 && !cagd_next_is(r, "\\dots"); k++)
        if (cagd_read_sum(r) == NULL || !cagd_pass(r, ","))
            return back(r, start);
    if (!cagd_pass(r, "\\dots"))
        return back(r, start);
    struct place behind = here(r);
    cagd_relation relation;
    comma = cagd_pass(r, ",");
    if (cagd_pass(r, "\\infty"))
        return 1;
    if (r->token->kind == CAGD_TOKEN_END)
        return r->token = behind.token, 1;
    *high = cagd_read_sum(r);
    if (*high == NULL && !comma)
        return -1;
    if (*high == NULL || cagd_relation_next(r, &relation) || cagd_next_is(r, "\\in"))
        *high = NULL, back(r, behind);
    return 1;
}

/* What may stand behind the last number of a list. */
static int ends_list(const cagd_token *t)
{
    static const char *const words[] = {",",      ";",      ")",        "\\}",          ".",    ":",
                                        "\\text", "\\mbox", "\\textrm", "\\Rightarrow", "\\iff"};
    int is = t->kind == CAGD_TOKEN_END;
    for (size_t k = 0; k < sizeof words / sizeof *words && !is; k++)
        is = strcmp(t->word, words[k]) == 0;
    return is;
}

/* ", 1, 2, 3" behind the number 0: the last of them, each one more than the one before; NULL where there are none. */
static const cagd_tree *listed(cagd_reader *r, const cagd_tree *first)
{
    const cagd_tree *last = NULL;
    long before =
        first->kind == CAGD_NUMBER && cagd_is_whole_q(first->number) ? mpz_get_si(mpq_numref(first->number.at)) : -1;
    for (; before >= 0 && before < CAGD_MOST_NODES && cagd_next_is(r, ",") && r->token[1].kind == CAGD_TOKEN_NUMBER;
         before++) {
        const cagd_token *t = r->token + 1;
        char next[24];
        snprintf(next, sizeof next, "%ld", before + 1);
        if (strcmp(t->word, next) != 0 || !ends_list(t + 1))
            break;
        r->token += 2;
        last = cagd_tree_number(before + 1, t->from, t->to);
    }
    return last;
}

/* 0(1)n, the whole numbers from 0 to n. */
enum { STEPS = 4 };
static int steps_of_one(const cagd_token *t)
{
    return (t->kind == CAGD_TOKEN_NUMBER || t->kind == CAGD_TOKEN_LETTER) && strcmp(t[1].word, "(") == 0 &&
           strcmp(t[2].word, "1") == 0 && strcmp(t[STEPS - 1].word, ")") == 0 &&
           (t[STEPS].kind == CAGD_TOKEN_NUMBER || t[STEPS].kind == CAGD_TOKEN_LETTER);
}
static const cagd_tree *lowest(cagd_reader *r, const cagd_token *t)
{
    const cagd_token *here = r->token;
    r->token = t;
    const cagd_tree *low = cagd_read_argument(r, 1);
    r->token = here;
    return low;
}

/* Behind the name of a range and "=": 0, \dots, n; 0, 1, 2; 0(1)n; or 3, which is no range.  Whether it is one; -1: an error. */
static int range_of(cagd_reader *r, cagd_variable *v)
{
    const cagd_token *low = r->token;
    r->ends++;
    *v = (cagd_variable){.whole = 1, .low = cagd_read_sum(r)};
    r->ends--;
    if (v->low == NULL)
        return -1;
    if (steps_of_one(low)) { /* i = 0(1)n */
        r->token = low + STEPS;
        v->low = lowest(r, low);
        v->high = cagd_read_sum(r);
        return v->low != NULL && v->high != NULL ? 1 : -1;
    }
    int has_dots = dots(r, &v->high);
    if (has_dots == 0)
        v->high = listed(r, v->low);
    return has_dots != 0 ? has_dots : v->high != NULL;
}

int cagd_begins_range(const cagd_token *t)
{
    return t->kind == CAGD_TOKEN_LETTER &&
           (strcmp(t[1].word, "=") == 0 || (strcmp(t[1].word, "\\in") == 0 && strcmp(t[2].word, "\\{") == 0));
}

int cagd_read_index_range(cagd_reader *r, const cagd_tree **low, const cagd_tree **high)
{
    struct place start = here(r);
    cagd_variable v = {0};
    if (!cagd_begins_range(r->token))
        return 0;
    int is_set = strcmp(r->token[1].word, "\\in") == 0;
    r->token += 2;
    if ((is_set ? whole_numbers(r, &v) : range_of(r, &v)) <= 0 || v.high == NULL)
        return back(r, start);
    *low = v.low, *high = v.high;
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
            room[used] = (struct cagd_bound){t->word, r->bound};
            r->bound = &room[used++];
        }
    }
    return used;
}

/* The range that this list has of the letter, before what is read or behind it; 0 where it has none with an end. */
static int range_in_list(cagd_reader *r, const cagd_scope *before, const char *letter, const cagd_tree **low,
                         const cagd_tree **high)
{
    const cagd_variable *v = cagd_declared(r->scope, letter);
    struct place start = here(r);
    if (v != NULL && v->whole && cagd_declared(before, letter) != v) {
        *low = v->low, *high = v->high;
        return v->high != NULL && !v->low_open && !v->high_open;
    }
    const cagd_token *ahead = v == NULL && !cagd_is_known(r, letter) ? range_ahead(r, letter) : NULL;
    if (ahead == NULL)
        return 0;
    struct cagd_bound room[CAGD_MOST_CHILDREN];
    const struct cagd_bound *outside = r->bound;
    bind_ranges_ahead(r, room);
    r->token = ahead;
    int is = cagd_read_index_range(r, low, high);
    r->bound = outside;
    back(r, start);
    return is;
}

/* a_j = 0, j = 1, 2: the condition that the indices, letters, are within the ranges that the list has of them; NULL where it has none. */
static const cagd_tree *within_ranges(cagd_reader *r, const cagd_scope *before, const cagd_tree *name)
{
    static const cagd_relation between[2] = {CAGD_LESS_OR_EQUAL, CAGD_LESS_OR_EQUAL};
    const cagd_tree *when = NULL, *low, *high;
    for (int k = 0; k < name->lower + name->upper; k++)
        if (name->at[k]->kind == CAGD_NAME && name->at[k]->count == 0 &&
            range_in_list(r, before, name->at[k]->head, &low, &high)) {
            const cagd_tree *one =
                cagd_relate(r, name->from, 3, (const cagd_tree *[]){low, name->at[k], high}, between);
            when = when == NULL ? one : cagd_new_of(r, CAGD_ALL, name->from, 2, (const cagd_tree *[]){when, one});
        }
    return when;
}

/* i = 0, \dots, n; i = 0, 1, 2; i = 0(1)n; or n = 3, which is a definition.  -1: it is no such thing. */
static int numbers(cagd_reader *r, cagd_scope *scope, const cagd_scope *before)
{
    struct place start = here(r);
    cagd_variable v;
    const cagd_tree *name = declared_name(r);
    if (name == NULL || !cagd_pass(r, "="))
        return back(r, start) - 1;
    int is_range = range_of(r, &v);
    if (is_range < 0)
        return 0;
    if (is_range)
        return declare(r, scope, name, v);
    for (const cagd_definition *same = scope->definitions; same != NULL; same = same->next)
        if (strcmp(same->left->head, name->head) == 0 && same->body != NULL && same->body->from == v.low->from &&
            same->left->from == name->from && same->left->to == name->to)
            return 1; /* it was read before what stands before it */
    if (!is_left_side(r, name, 0))
        return 0;
    cagd_definition *d = cagd_define(scope, name);
    if (d != NULL)
        d->body = v.low, d->when = within_ranges(r, before, name);
    return d != NULL;
}

/* The end of what comes next, if it is a range of an index, j = 0, 1, \dots, i - 1, or a chain with a name without indices in it, u_i \le u < u_{i+1}: both may have
 * letters whose ranges stand ahead.  Otherwise its beginning. */
static const cagd_token *end_of_item(cagd_reader *r)
{
    struct place start = here(r);
    struct cagd_bound room[CAGD_MOST_CHILDREN];
    const struct cagd_bound *outside = r->bound;
    const cagd_tree *low, *high;
    const cagd_token *end = start.token;
    cagd_relation relation;
    int used, depth = 0, alone = 0;
    used = bind_ranges_ahead(r, room);
    if (used > 0 && cagd_read_index_range(r, &low, &high)) {
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
    back(r, start);
    return end;
}

static int elements(cagd_reader *r, cagd_scope *scope, cagd_reading_error *listed);

/* Letters of the range or chain that comes next, whose own ranges stand behind it, j = 0, 1, \dots, i - 1, i = 1, 2, \dots, n: these are read before it. */
static void declare_ahead(cagd_reader *r, cagd_scope *scope, const cagd_scope *before, int depth)
{
    struct place start = here(r);
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
        if ((strcmp(ahead[1].word, "\\in") == 0 ? elements(r, scope, &listed) : numbers(r, scope, before)) <= 0)
            *scope = as_it_was;
        back(r, start);
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
    struct place start = here(r);
    cagd_relation relation;
    const cagd_tree *name = declared_name(r);
    if (name != NULL && name->arguments == 0 &&
        (cagd_relation_next(r, &relation) || cagd_next_is(r, ",") || r->token->kind == CAGD_TOKEN_END)) {
        const cagd_variable *v = cagd_declared(r->scope, name->head);
        int is_pi = v == NULL && strcmp(name->head, "\\pi") == 0, is_letter = cagd_is_bound(r, name->head);
        *p = (struct piece){name, is_pi || is_letter || cagd_defined(r->scope, name->head) != NULL ? 0
                                  : v != NULL && v->whole                                          ? -1
                                                                                                   : 1};
        return 1;
    }
    back(r, start);
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
    if (bound->kind != CAGD_NUMBER || before->kind != CAGD_NUMBER)
        return 0;
    int order = cagd_compare_q(bound->number, before->number);
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

/* u_i \le u_{i+1}, the letter i meaning nothing: for every index. */
static const cagd_tree *for_every_index(cagd_reader *r, const cagd_scope *before, const cagd_tree *t)
{
    const cagd_tree *low, *high;
    const cagd_tree *letter = letter_without_meaning(r, t, NULL, 0);
    const cagd_tree *other = letter != NULL ? letter_without_meaning(r, t, letter->head, 0) : NULL;
    if (letter == NULL)
        return t;
    if (other != NULL)
        return cagd_refuse_tree(r, other, "a condition for every index has one letter: %s or %s", letter->head,
                                other->head);
    if (range_in_list(r, before, letter->head, &low, &high)) {
        cagd_tree *all = cagd_new_of(r, CAGD_FOR_ALL, t->from, 3, (const cagd_tree *[]){low, high, t});
        if (all != NULL)
            all->head = letter->head, all->to = t->to;
        return all;
    }
    cagd_tree *every = cagd_new(r, CAGD_EVERY_INDEX, t->from, 1);
    if (every != NULL)
        every->head = letter->head, every->at[0] = t, every->to = t->to;
    return every;
}

/* The name whose bounds the chain that comes next tells, if it has indices: the first member that is a name by itself. */
static const cagd_tree *name_ahead(cagd_reader *r)
{
    struct place start = here(r);
    cagd_relation relation;
    const cagd_tree *found = NULL;
    for (int depth = 0, begins = 1; found == NULL && r->token->kind != CAGD_TOKEN_END; r->token++) {
        struct place at = here(r);
        const char word = r->token->word[0];
        if (begins && depth == 0 && (found = declared_name(r)) != NULL &&
            (found->count == 0 || found->arguments > 0 ||
             !(cagd_relation_next(r, &relation) || cagd_next_is(r, ",") || r->token->kind == CAGD_TOKEN_END)))
            found = NULL;
        back(r, at);
        begins = cagd_relation_next(r, &relation);
        depth += (strchr("({[", word) != NULL) - (strchr(")}]", word) != NULL);
        if (depth == 0 && (word == ',' || word == ';'))
            break;
    }
    back(r, start);
    return found;
}

/* Whether the letter, a whole number, is called as last indices are and running ones are not. */
static int is_last_index(const cagd_scope *scope, const char *letter)
{
    const cagd_variable *v = cagd_declared(scope, letter);
    return v != NULL && v->whole && letter[1] == '\0' && strchr("nmNM", letter[0]) != NULL;
}

/* Whether the name is all of those that are called so, and no certain one, as \omega_3, \omega_{i+1}, or \omega_n where n = 1, 2, 3. */
static int is_each(const cagd_scope *scope, const cagd_tree *name)
{
    for (int k = 0; k < name->count; k++) {
        const cagd_tree *t = name->at[k];
        const cagd_definition *d = t->kind == CAGD_NAME ? cagd_defined(scope, t->head) : NULL;
        if (t->kind != CAGD_NAME || t->count > 0 || (d != NULL && d->left->count == 0) || is_last_index(scope, t->head))
            return 0;
        for (const cagd_variable *v = scope->variables; v != NULL; v = v->next)
            if (v->whole && v->high != NULL && strcmp(v->head, t->head) != 0 && cagd_tree_has(v->high, t->head) &&
                cagd_declared(scope, t->head) != NULL)
                return 0;
    }
    return 1;
}

static int is_whole_number(const cagd_tree *t) { return t->kind == CAGD_NUMBER && cagd_is_whole_q(t->number); }

/* Bounds of a_j for j = 1, 2 are not those of a_3. */
static void restrict_bounds(cagd_reader *r, const cagd_scope *before, cagd_variable *v)
{
    const cagd_tree *left = v->left, *low, *high;
    v->some = left->lower == 1 && left->upper == 0 && left->at[0]->kind == CAGD_NAME && left->at[0]->count == 0 &&
              range_in_list(r, before, left->at[0]->head, &low, &high) && is_whole_number(low) && is_whole_number(high);
    if (v->some)
        v->first = mpz_get_si(mpq_numref(low->number.at)), v->last = mpz_get_si(mpq_numref(high->number.at));
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
            room[used] = (struct cagd_bound){t->word, r->bound};
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
    if (!some_index && (alone == 1 || (alone == 0 && whole == 1)) && count <= 3 && (up || down) &&
        (count == 2 || which == 1) && (is_one_of_many(p[which].tree) || is_each(scope, p[which].tree))) {
        cagd_variable v, was;
        const cagd_variable *old = declaration_of(before, p[which].tree, &was) ? &was : NULL;
        declaration_of(scope, p[which].tree, &v);
        const cagd_variable *one =
            is_one_of_many(p[which].tree) ? NULL : one_of_those(scope, p[which].tree, before->variables);
        if (one != NULL)
            return cagd_refuse_tree(r, p[which].tree, "bounds of all of them stand before those of %s alone",
                                    one->head) != NULL;
        if (v.left != NULL && (v.left->lower != p[which].tree->lower || v.left->upper != p[which].tree->upper))
            return cagd_refuse_tree(r, p[which].tree, "%s had other indices before", p[which].tree->head) != NULL;
        int replaces = v.head != NULL;
        for (int k = 0; k < count; k++) {
            if (k == which)
                continue;
            int strict = is_strict(relation[k < which ? k : which]), below = (k < which) == up;
            const cagd_tree *bound = below ? v.low : v.high;
            int is_replaced = !v.whole && old != NULL && bound == (below ? old->low : old->high);
            replaces &= is_replaced || is_tighter(p[k].tree, strict, bound, below);
            if (below)
                v.low = p[k].tree, v.low_open = strict;
            else
                v.high = p[k].tree, v.high_open = strict;
        }
        if (replaces) {
            take_letters(&v, p[which].tree, p, count);
            restrict_bounds(r, before, &v);
            return cagd_declare(scope, v);
        }
    }
    const cagd_tree *list[CAGD_MOST_INDICES];
    for (int k = 0; k < count; k++)
        list[k] = p[k].tree;
    const cagd_tree *t = cagd_relate(r, from, count, list, relation);
    return t != NULL && (t = for_every_index(r, before, t)) != NULL && cagd_suppose(scope, t);
}

static int ranges(cagd_reader *r, cagd_scope *scope, const cagd_scope *before)
{
    do {
        cagd_reading_error listed = {0};
        while (cagd_read_words(r) != NULL || cagd_pass(r, "\\forall"))
            ;
        cagd_share_value(r);
        declare_ahead(r, scope, before, 0);
        int done = elements(r, scope, &listed);
        if (done < 0)
            done = numbers(r, scope, before);
        if (done < 0)
            done = cagd_share_bounds(r) && chain(r, scope, before);
        if (!done && listed.from > r->error->from)
            *r->error = listed;
        if (!done)
            return 0;
    } while (cagd_pass(r, ",") || cagd_pass(r, ";") || cagd_next_is(r, "\\text"));
    return 1;
}

int cagd_read_ranges(cagd_scope *scope, const char *text, int from, int to, cagd_reading_error *error)
{
    cagd_reader r;
    cagd_scope before = *scope;
    if (!cagd_reader_open(&r, scope, text, from, to, error))
        return 0;
    int good = ranges(&r, scope, &before);
    if (good && r.token->kind != CAGD_TOKEN_END)
        good = cagd_refuse_token(&r, "expected a comma or the end, not %s", cagd_name_of_next(&r)) != NULL;
    if (!good)
        *scope = before;
    return good;
}

/* Whether the bound has no names but \pi and those of the indices. */
static int is_of_numbers(const cagd_tree *t, const cagd_tree *left)
{
    if (t == NULL)
        return 1;
    for (int k = 0; t->kind == CAGD_NAME && left != NULL && k < left->count; k++)
        if (left->at[k]->kind == CAGD_NAME && strcmp(left->at[k]->head, t->head) == 0)
            return 1;
    for (int k = 0; k < t->count; k++)
        if (!is_of_numbers(t->at[k], left))
            return 0;
    return t->kind != CAGD_NAME || strcmp(t->head, "\\pi") == 0;
}

int cagd_read_declaration(cagd_scope *scope, const char *text, int from, int to)
{
    cagd_reader r;
    cagd_reading_error error;
    cagd_scope before = *scope;
    if (!cagd_reader_open(&r, scope, text, from, to, &error))
        return 0;
    int good = !is_definition(r.token) && ranges(&r, scope, &before) &&
               scope->condition_count == before.condition_count && scope->definitions == before.definitions &&
               scope->label_count == before.label_count;
    for (const cagd_variable *v = scope->variables; good && v != before.variables; v = v->next)
        good = !v->whole && is_of_numbers(v->low, v->left) && is_of_numbers(v->high, v->left);
    if (!good)
        *scope = before;
    return good;
}
