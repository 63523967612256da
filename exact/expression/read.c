/* read.c -- expressions: sums, products, powers, fractions, sums over an index, cases. */
#include "exact/expression/depends.h"
#include "exact/expression/reader.h"
#include "exact/words.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* ---- tokens and trees ---------------------------------------------------------------------------------- */

int cagd_reader_open(cagd_reader *r, const cagd_scope *scope, const char *text, int from, int to,
                     cagd_reading_error *error)
{
    *error = (cagd_reading_error){0};
    *r = (cagd_reader){.scope = scope, .text = text, .error = error};
    cagd_token *list = cagd_tokens(text, from, to, error);
    if (list != NULL)
        cagd_open_rows(list);
    r->token = list;
    return list != NULL;
}

int cagd_next_is(const cagd_reader *r, const char *word)
{
    return r->token->kind != CAGD_TOKEN_END && strcmp(r->token->word, word) == 0;
}
int cagd_pass(cagd_reader *r, const char *word)
{
    int is = cagd_next_is(r, word);
    r->token += is;
    return is;
}

const char *cagd_name_of_next(const cagd_reader *r)
{
    if (r->token->kind == CAGD_TOKEN_END)
        return "the end";
    int n = r->token->to - r->token->from;
    char text[48];
    snprintf(text, sizeof text, "'%.*s'", n > 40 ? 40 : n, r->text + r->token->from);
    const char *kept = cagd_text_of(text, (int)strlen(text));
    return kept != NULL ? kept : "";
}

cagd_tree *cagd_refuse_token(cagd_reader *r, const char *format, ...)
{
    char message[240];
    va_list list;
    va_start(list, format);
    vsnprintf(message, sizeof message, format, list);
    va_end(list);
    cagd_refuse_reading(r->error, r->token->from, r->token->to, "%s", message);
    return NULL;
}
cagd_tree *cagd_refuse_tree(cagd_reader *r, const cagd_tree *t, const char *format, ...)
{
    char message[240];
    va_list list;
    va_start(list, format);
    vsnprintf(message, sizeof message, format, list);
    va_end(list);
    cagd_refuse_reading(r->error, t->from, t->to, "%s", message);
    return NULL;
}

int cagd_expect(cagd_reader *r, const char *word, const char *after)
{
    if (cagd_pass(r, word))
        return 1;
    return cagd_refuse_token(r, "expected '%s' after %s, not %s", word, after, cagd_name_of_next(r)) != NULL;
}

cagd_tree *cagd_new(cagd_reader *r, cagd_tree_kind kind, int from, int count)
{
    if (++r->nodes > CAGD_MOST_NODES)
        return cagd_refuse_token(r, "the formula has more than %d parts", CAGD_MOST_NODES);
    cagd_tree *t = cagd_tree_new(kind, from, r->token[-1].to, count);
    return t != NULL ? t : cagd_refuse_token(r, "there is no memory for the formula");
}
cagd_tree *cagd_new_of(cagd_reader *r, cagd_tree_kind kind, int from, int count, const cagd_tree *const child[])
{
    for (int k = 0; k < count; k++)
        if (child[k] == NULL)
            return NULL;
    cagd_tree *t = cagd_new(r, kind, from, count);
    for (int k = 0; t != NULL && k < count; k++)
        t->at[k] = child[k];
    return t != NULL ? cagd_with_dimension(r, t) : NULL;
}

/* ---- scripts and arguments ----------------------------------------------------------------------------- */

static const cagd_tree *number(cagd_reader *r)
{
    cagd_tree *t = (r->token++, cagd_new(r, CAGD_NUMBER, r->token[-1].from, 0));
    if (t != NULL)
        t->number = from_string_q(r->token[-1].word);
    if (t != NULL && region_faults != 0) {
        region_faults = 0;
        return cagd_refuse_tree(r, t, "a number of too many digits");
    }
    return t;
}

const cagd_tree *cagd_read_argument(cagd_reader *r, int is_script)
{
    int from = r->token->from;
    if (cagd_pass(r, "{")) {
        const cagd_tree *t = cagd_read_sum(r);
        return t != NULL && cagd_expect(r, "}", "the group") ? t : NULL;
    }
    if (r->token->kind == CAGD_TOKEN_NUMBER) {
        if (strlen(r->token->word) > 1)
            return cagd_refuse_token(r, "TeX takes one digit here: write {%s}", r->token->word);
        return number(r);
    }
    if (r->token->kind == CAGD_TOKEN_LETTER) { /* a letter alone: what follows is not its index */
        const char *head = (r->token++)->word;
        cagd_tree *t = cagd_new(r, CAGD_NAME, from, 0);
        if (t != NULL)
            t->head = head, t->dimension = cagd_is_bound(r, head) ? 0 : cagd_dimension_of(r->scope, head);
        if (t != NULL && !cagd_may_be_unknown(r) && !cagd_is_known(r, head))
            return cagd_complain_of_letter(r, t->from, t->to, head);
        return t;
    }
    if (is_script && r->token->kind != CAGD_TOKEN_WORD)
        return cagd_refuse_token(r, "expected an index or a power, not %s", cagd_name_of_next(r));
    return cagd_read_factor(r);
}

const char *cagd_read_words(cagd_reader *r)
{
    if (!cagd_next_is(r, "\\text"))
        return NULL;
    r->token++;
    if (!cagd_expect(r, "{", "\\text"))
        return "";
    int from = r->token->from;
    while (r->token->kind != CAGD_TOKEN_END && !cagd_next_is(r, "}"))
        r->token++;
    int to = r->token->from;
    while (to > from && strchr(" ~\n", r->text[to - 1]) != NULL)
        to -= to - from > 1 && r->text[to - 2] == '\\' ? 2 : 1;
    const char *words = cagd_text_of(r->text + from, to - from);
    cagd_pass(r, "}");
    return words != NULL ? words : "";
}

enum { MOST_ROWS = 6 };

/* ---- brackets, lists, cases ---------------------------------------------------------------------------- */

static const cagd_tree *bracketed(cagd_reader *r, cagd_tree_kind kind, const char *close, int from)
{
    r->norms += kind == CAGD_NORM, r->amounts += kind == CAGD_ABSOLUTE;
    const cagd_tree *a = cagd_read_sum(r);
    r->norms -= kind == CAGD_NORM, r->amounts -= kind == CAGD_ABSOLUTE;
    if (a != NULL && cagd_is_matrix(a->dimension) && kind == CAGD_ABSOLUTE)
        return cagd_expect(r, close, "the matrix") ? cagd_determinant_of(r, a, from) : NULL;
    if (a != NULL && a->dimension > 0 && kind == CAGD_ABSOLUTE)
        kind = CAGD_NORM;
    return a != NULL && cagd_expect(r, close, "the bracket") ? cagd_new_of(r, kind, from, 1, &a) : NULL;
}

/* (x)_+^p behind the bracket with x, a truncated power: x^p where x is not negative, and else 0. */
static const cagd_tree *truncated(cagd_reader *r, const cagd_tree *x, int from)
{
    const cagd_tree *p = cagd_tree_number(1, from, from), *zero = cagd_tree_number(0, from, from);
    r->token += 2;
    if (cagd_pass(r, "^"))
        p = cagd_read_argument(r, 1);
    const cagd_tree *power = cagd_new_of(r, CAGD_POWER, from, 2, (const cagd_tree *[]){x, p});
    static const cagd_relation relation[] = {CAGD_GREATER_OR_EQUAL};
    cagd_tree *where = cagd_new_of(r, CAGD_RELATION, from, 2, (const cagd_tree *[]){x, zero});
    if (where != NULL)
        where->relation = relation;
    return cagd_new_of(r, CAGD_CASES, from, 3, (const cagd_tree *[]){power, where, zero});
}

/* a b and a - b. */
static const cagd_tree *times(cagd_reader *r, const cagd_tree *a, const cagd_tree *b)
{
    return cagd_new_of(r, CAGD_PRODUCT, r->token[-1].from, 2, (const cagd_tree *[]){a, b});
}
static const cagd_tree *minus(cagd_reader *r, const cagd_tree *a, const cagd_tree *b)
{
    int from = r->token[-1].from;
    b = b != NULL ? cagd_new_of(r, CAGD_NEGATIVE, from, 1, &b) : NULL;
    return cagd_new_of(r, CAGD_SUM, from, 2, (const cagd_tree *[]){a, b});
}

/* "{p,q}" comes next, two numbers: [n]_{p,q} = (p^n - q^n)/(p - q) is p^{n-1} [n]_{q/p}, its factorial p^{n(n-1)/2} [n]_{q/p}!, and the coefficient that of
 * q/p times p^{k(n-k)}. */
static const cagd_tree *with_p_and_q(cagd_reader *r, const cagd_tree *t, int from)
{
    r->token++;
    const cagd_tree *p = cagd_read_sum(r);
    const cagd_tree *q = p != NULL && cagd_expect(r, ",", "p") ? cagd_read_sum(r) : NULL;
    if (q == NULL || !cagd_expect(r, "}", "q"))
        return NULL;
    const cagd_tree *one = cagd_tree_number(1, from, from), *power, *number;
    const cagd_tree *ratio = cagd_new_of(r, CAGD_QUOTIENT, from, 2, (const cagd_tree *[]){q, p});
    if (t->kind == CAGD_BINOMIAL || (t->kind == CAGD_POINT && t->count == 2)) {
        power = times(r, t->at[1], minus(r, t->at[0], t->at[1]));
        number = cagd_new_of(r, CAGD_Q_BINOMIAL, from, 3, (const cagd_tree *[]){t->at[0], t->at[1], ratio});
    } else if (t->dimension > 0) {
        return cagd_refuse_tree(r, t, "an index behind a bracket");
    } else if (cagd_pass(r, "!")) {
        power = cagd_new_of(r, CAGD_QUOTIENT, from, 2,
                            (const cagd_tree *[]){times(r, t, minus(r, t, one)), cagd_tree_number(2, from, from)});
        number = cagd_new_of(r, CAGD_Q_FACTORIAL, from, 2, (const cagd_tree *[]){t, ratio});
    } else {
        power = minus(r, t, one);
        number = cagd_new_of(r, CAGD_Q_NUMBER, from, 2, (const cagd_tree *[]){t, ratio});
    }
    power = cagd_new_of(r, CAGD_POWER, from, 2, (const cagd_tree *[]){p, power});
    return cagd_new_of(r, CAGD_PRODUCT, from, 2, (const cagd_tree *[]){power, number});
}

/* Whether two values in braces come next. */
static int is_pair(const cagd_reader *r)
{
    int depth = 0, commas = 0;
    for (const cagd_token *t = r->token; t->kind != CAGD_TOKEN_END; t++) {
        depth += (strchr("({[", t->word[0]) != NULL) - (strchr(")}]", t->word[0]) != NULL);
        commas += depth == 1 && t->word[0] == ',';
        if (depth == 0)
            break;
    }
    return cagd_next_is(r, "{") && commas == 1;
}

/* t with the q that stands below behind it: [n]_q, [n]_q!, \binom{n}{k}_q; or with p and q. */
static const cagd_tree *with_q(cagd_reader *r, const cagd_tree *t, int from)
{
    if (t == NULL || !cagd_pass(r, "_"))
        return t;
    if (is_pair(r))
        return with_p_and_q(r, t, from);
    const cagd_tree *q = cagd_read_argument(r, 1);
    if (q != NULL && q->kind == CAGD_NUMBER && cagd_next_is(r, "^"))
        return cagd_refuse_token(r,
                                 "a difference of two values, or a power? write it as a difference, or with brackets");
    if (t->kind == CAGD_BINOMIAL || (t->kind == CAGD_POINT && t->count == 2))
        return cagd_new_of(r, CAGD_Q_BINOMIAL, from, 3, (const cagd_tree *[]){t->at[0], t->at[1], q});
    if (t->dimension > 0)
        return cagd_refuse_tree(r, t, "an index behind a bracket");
    cagd_tree_kind kind = cagd_pass(r, "!") ? CAGD_Q_FACTORIAL : CAGD_Q_NUMBER;
    return cagd_new_of(r, kind, from, 2, (const cagd_tree *[]){t, q});
}

/* {a \choose b}, {a \over b}, {a \brack b}_q, a being read. */
static const cagd_tree *with_infix(cagd_reader *r, const cagd_tree *a, int from)
{
    int is_quotient = cagd_next_is(r, "\\over"), has_q = cagd_next_is(r, "\\brack");
    r->token++;
    const cagd_tree *b = cagd_read_sum(r);
    const cagd_tree *t =
        cagd_new_of(r, is_quotient ? CAGD_QUOTIENT : CAGD_BINOMIAL, from, 2, (const cagd_tree *[]){a, b});
    if (t == NULL || !has_q)
        return t;
    if (!cagd_expect(r, "}", "the bracket"))
        return NULL;
    if (!cagd_next_is(r, "_"))
        return cagd_refuse_tree(r, t,
                                "\\brack has several meanings; of Gauss's coefficients q is said: {n \\brack k}_q");
    return with_q(r, t, from);
}

/* Whether \quad or \; stands between tokens from `first` to the next one, outside of brackets. */
static int has_wide_space(const cagd_reader *r, const cagd_token *first)
{
    int depth = 0;
    for (const cagd_token *t = first; t + 1 < r->token; t++) {
        depth += (strchr("([{", t->word[0]) != NULL) - (strchr(")]}", t->word[0]) != NULL);
        for (int k = t->to; depth == 0 && k + 1 < t[1].from; k++)
            if (r->text[k] == '\\' && (r->text[k + 1] == 'q' || r->text[k + 1] == ';'))
                return 1;
    }
    return 0;
}

static const cagd_tree *at_a_place(cagd_reader *r, const cagd_tree *t, int from);

/* (f(t))', the bracket being passed: f'(t), where t is a letter. */
static const cagd_tree *primed_value(cagd_reader *r, const cagd_tree *f)
{
    const cagd_tree *argument = f->at[f->lower + f->upper];
    if (argument->kind != CAGD_NAME || argument->count > 0)
        return cagd_refuse_token(
            r, "a prime stands behind the name, f'(2t), or \\frac{d}{dt} before the bracket: the two are not the same");
    cagd_tree *t = cagd_new(r, CAGD_NAME, f->from, f->count);
    if (t == NULL)
        return NULL;
    const cagd_tree **at = t->at;
    *t = *f;
    t->at = at;
    memcpy(at, f->at, (size_t)f->count * sizeof *at);
    while (cagd_pass(r, "'"))
        t->order++;
    t->to = r->token[-1].to;
    return t;
}

/* Whether "_{t=" or "_{(s,t)=" comes next, behind a bracket. */
static int place_follows(const cagd_reader *r)
{
    const cagd_token *t = r->token;
    if (strcmp(t->word, "_") != 0 || strcmp(t[1].word, "{") != 0)
        return 0;
    return strcmp(t[2].word, "(") == 0 || (t[2].kind == CAGD_TOKEN_LETTER && strcmp(t[3].word, "=") == 0);
}

/* [n], [n-1], [2], [x], which no product needs a bracket for; the next token is the bracket's end. */
static int is_alone_in_brackets(const cagd_reader *r, const cagd_tree *a)
{
    const cagd_token *behind = r->token + 1;
    int has_name = 0;
    if (a->dimension > 0 || !cagd_next_is(r, "]") || strcmp(behind->word, "_") == 0)
        return 0;
    if (a->kind == CAGD_NAME && a->count == 0 && !cagd_is_bare_function(r, a))
        return 1;
    if (a->kind == CAGD_QUOTIENT) /* [n/2] */
        return cagd_is_of_whole_numbers(r, a->at[0], &has_name) && cagd_is_of_whole_numbers(r, a->at[1], &has_name);
    return a->kind != CAGD_PRODUCT && cagd_is_of_whole_numbers(r, a, &has_name);
}

/* (...), [...], {...}: the value itself. */
static const cagd_tree *group(cagd_reader *r, const char *close)
{
    int from = r->token[-1].from;
    const cagd_token *first = r->token;
    r->squares += close[0] == ']';
    const cagd_tree *a = cagd_read_sum(r);
    r->squares -= close[0] == ']';
    if (a != NULL && close[0] == ']' && a->kind != CAGD_MIXED && !(a->kind == CAGD_PRODUCT && a->juxtaposed) &&
        has_wide_space(r, first))
        return cagd_refuse_tree(r, a, "components with space between them: write commas, [1-u, u]");
    if (a != NULL && cagd_next_is(r, ",") && close[0] != '\\' && close[0] != '}')
        return cagd_read_point(r, a, close, from);
    if (a != NULL && close[0] == '}' && cagd_next_is(r, "\\brack"))
        return with_infix(r, a, from);
    if (a != NULL && close[0] == '}' && (cagd_next_is(r, "\\choose") || cagd_next_is(r, "\\over")))
        a = with_infix(r, a, from);
    if (a != NULL && close[0] == ']')
        a = cagd_in_square_brackets(r, a);
    if (a != NULL && close[0] == ']' && is_alone_in_brackets(r, a))
        return cagd_refuse_tree(r, a,
                                "is it a q-number, a whole part or a bracket? write [n]_q, \\lfloor n \\rfloor or (n)");
    if (a == NULL || !cagd_expect(r, close, "the bracket") ||
        (!cagd_is_bare_function(r, a) && cagd_refuse_argument(r, a)))
        return NULL;
    if (close[0] == ')' && cagd_next_is(r, "_") && strcmp(r->token[1].word, "+") == 0)
        return truncated(r, a, from);
    if (close[0] != '}' && place_follows(r))
        return at_a_place(r, a, from);
    if (close[0] == ']' && cagd_next_is(r, "_"))
        return with_q(r, a, from);
    if (close[0] != '}' && a->kind == CAGD_NAME && a->arguments > 0 && cagd_next_is(r, "'"))
        return primed_value(r, a);
    return cagd_read_primed_group(r, a);
}

static const cagd_tree *extremum(cagd_reader *r, cagd_tree_kind kind, int from)
{
    const cagd_tree *list[CAGD_MOST_CHILDREN];
    int count = 0;
    cagd_tree_kind over = kind == CAGD_MAXIMUM ? CAGD_MAXIMUM_OVER : CAGD_MINIMUM_OVER;
    if (cagd_next_is(r, "_"))
        return cagd_read_over(r, over, from);
    const char *close = cagd_pass(r, "(") ? ")" : cagd_pass(r, "\\{") ? "\\}" : NULL;
    if (close == NULL)
        return cagd_refuse_token(r, "expected a list such as (a, b), or a range such as _{0 \\le i \\le n}, not %s",
                                 cagd_name_of_next(r));
    do {
        const cagd_token *dots = r->token;
        if (count == CAGD_MOST_CHILDREN)
            return cagd_refuse_token(r, "a list of more than %d", CAGD_MOST_CHILDREN);
        int start = count, filled = count > 0 && cagd_pass(r, "\\dots") && cagd_pass(r, ",");
        const cagd_tree *next = cagd_read_sum(r);
        if (next != NULL && filled)
            next = cagd_fill_dots(r, over, dots, list, count, next, 0, &start);
        if (next == NULL)
            return NULL;
        list[start] = next, count = start + 1;
    } while (cagd_pass(r, ","));
    return cagd_expect(r, close, "the list") ? cagd_new_of(r, kind, from, count, list) : NULL;
}

static int is_one_of(const char *word, const char *const words[])
{
    for (int k = 0; words[k] != NULL; k++)
        if (strcmp(words[k], word) == 0)
            return 1;
    return 0;
}

int cagd_environment(cagd_reader *r, const char *name)
{
    const cagd_token *t = r->token;
    if (!cagd_pass(r, "{"))
        return 0;
    for (const char *c = name; *c != '\0'; c++, r->token++)
        if (r->token->word[0] != *c || r->token->word[1] != '\0') {
            r->token = t;
            return 0;
        }
    return cagd_pass(r, "}");
}

/* \begin{vmatrix} a & b \\ c & d \end{vmatrix}, the first word being passed. */
static const cagd_tree *determinant(cagd_reader *r, int from)
{
    const cagd_tree *list[CAGD_MOST_CHILDREN];
    int count = 0, rows = 0, in_row = 0;
    do {
        if (cagd_next_is(r, "\\end"))
            break;
        rows++, in_row = 0;
        do {
            if (count == MOST_ROWS * MOST_ROWS)
                return cagd_refuse_token(r, "a determinant of more than %d rows", MOST_ROWS);
            list[count] = cagd_read_sum(r);
            if (list[count++] == NULL)
                return NULL;
            in_row++;
        } while (cagd_pass(r, "&"));
        if (in_row * rows != count)
            return cagd_refuse_token(r, "rows of different lengths");
    } while (cagd_pass(r, "\\\\"));
    if (!cagd_expect(r, "\\end", "the determinant") || !cagd_environment(r, "vmatrix"))
        return cagd_refuse_token(r, "expected \\end{vmatrix}");
    if (rows != in_row || rows > MOST_ROWS)
        return cagd_refuse_token(r, "a determinant has as many columns as rows, at most %d", MOST_ROWS);
    cagd_tree *t = cagd_new_of(r, CAGD_DETERMINANT, from, count, list);
    if (t != NULL)
        t->order = rows;
    return t;
}

/* What encloses cases: {cases}, and behind a brace, \{, rows of other kinds; NULL where there is none. */
static const char *environment_of_cases(cagd_reader *r, int behind_brace)
{
    static const char *const names[] = {"cases", "dcases", "array", "aligned", NULL};
    for (int k = 0; names[k] != NULL && (k < 2 || behind_brace); k++)
        if (cagd_environment(r, names[k]))
            return names[k];
    return NULL;
}

/* Whether a text says one of these; commas and the like around it do not count, nor does how it begins. */
static int says_one_of(const char *text, const char *const words[])
{
    while (*text == ' ' || *text == ',')
        text++;
    size_t n = strlen(text);
    while (n > 0 && strchr(" ,.;:", text[n - 1]) != NULL)
        n--;
    for (int k = 0; words[k] != NULL; k++)
        if (strlen(words[k]) == n &&
            (n == 0 || ((text[0] | ' ') == words[k][0] && memcmp(text + 1, words[k] + 1, n - 1) == 0)))
            return 1;
    return 0;
}

/* What stands at the end of a row besides its value or its condition. */
static void pass_punctuation(cagd_reader *r)
{
    if (!cagd_pass(r, ",") && !cagd_pass(r, ";"))
        cagd_pass(r, ".");
}

/* The cases, the word \begin being passed, and a brace before it or not. */
static const cagd_tree *cases(cagd_reader *r, int behind_brace, int from)
{
    static const char *const otherwise[] = {
        "otherwise", "else", "elsewhere", "in all other cases", "in other cases", "in the other cases", NULL};
    static const char *const when[] = {
        "if",      "for",       "when",     "where",   "whenever", "as", "with", "provided", "provided that",
        "for all", "for every", "for each", "for any", "",         NULL};
    const cagd_tree *list[CAGD_MOST_CHILDREN];
    int count = 0;
    const char *name = environment_of_cases(r, behind_brace);
    if (name != NULL && strcmp(name, "array") == 0 && !cagd_pass_columns(r))
        return NULL;
    if (name == NULL)
        return cagd_refuse_token(r, "of the environments only {cases} and those of matrices are understood here");
    do {
        if (cagd_next_is(r, "\\end"))
            break;
        if (count + 2 > CAGD_MOST_CHILDREN || count % 2 == 1)
            return cagd_refuse_token(r, count % 2 == 1 ? "'otherwise' is the last of the cases" : "too many cases");
        list[count] = cagd_read_sum(r);
        if (list[count++] == NULL)
            return NULL;
        pass_punctuation(r);
        if (cagd_pass(r, "&") && !cagd_pass(r, ","))
            cagd_pass(r, ":");
        if (cagd_next_is(r, "\\\\") || cagd_next_is(r, "\\end"))
            return cagd_refuse_token(r, "expected a condition behind '&', or \\text{otherwise}, not %s",
                                     cagd_name_of_next(r));
        const cagd_token *at = r->token;
        const char *words = cagd_read_words(r);
        if (words != NULL && says_one_of(words, otherwise)) {
            pass_punctuation(r);
            continue;
        }
        if (words != NULL && !says_one_of(words, when)) {
            r->token = at;
            return cagd_refuse_token(r, "'%s' is not understood; expected 'if' or 'otherwise'", words);
        }
        r->lists++, r->premises++;
        list[count] = cagd_next_is_member(r) ? cagd_read_members(r) : cagd_read_alternatives(r);
        r->lists--, r->premises--;
        if (list[count++] == NULL)
            return NULL;
        pass_punctuation(r);
    } while (cagd_pass(r, "\\\\"));
    if (!cagd_expect(r, "\\end", "the cases") || !cagd_environment(r, name))
        return cagd_refuse_token(r, "expected \\end{%s}", name);
    return count > 0 ? cagd_new_of(r, CAGD_CASES, from, count, list) : cagd_refuse_token(r, "cases without a case");
}

/* ---- factors ------------------------------------------------------------------------------------------- */

/* Whether it counts how often an angle is taken: 2, or k - 1 where k is a whole number. */
static int is_count(const cagd_reader *r, const cagd_tree *t)
{
    const cagd_variable *v = t->kind == CAGD_NAME && t->count == 0 ? cagd_declared(r->scope, t->head) : NULL;
    if (t->kind != CAGD_SUM && t->kind != CAGD_NEGATIVE && t->kind != CAGD_PRODUCT && t->kind != CAGD_QUOTIENT)
        return t->kind == CAGD_NUMBER || (v != NULL && v->whole);
    for (int k = 0; k < t->count; k++)
        if (!is_count(r, t->at[k]))
            return 0;
    return 1;
}

/* The angle is one factor, or a multiple of one: \sin 2a, \sin k a. */
static const cagd_tree *angle_of(cagd_reader *r)
{
    int from = r->token->from;
    const cagd_tree *a = cagd_read_factor(r);
    if (a == NULL || !is_count(r, a) || !(cagd_begins_name(r) || cagd_next_is(r, "(")))
        return a;
    const cagd_tree *b = angle_of(r);
    return b != NULL ? cagd_new_of(r, CAGD_PRODUCT, from, 2, (const cagd_tree *[]){a, b}) : NULL;
}

/* Whether it is made of numbers and \pi. */
static int is_turn(const cagd_reader *r, const cagd_tree *t)
{
    if (t->kind == CAGD_NAME && t->count == 0 && strcmp(t->head, "\\pi") == 0)
        return 1;
    for (int k = 0; k < t->count; k++)
        if (!is_turn(r, t->at[k]))
            return 0;
    return t->count > 0 || is_count(r, t);
}

/* A name behind an angle without brackets can belong to the angle, as in \sin a t; 0 where it is refused. */
static int ends_angle(cagd_reader *r, int is_turn)
{
    const cagd_token *here = r->token;
    for (int k = here[-1].to; k < here->from && !is_turn; k++)
        if (r->text[k] == '\\' || r->text[k] == '~') /* a space that is printed parts them */
            return 1;
    if (!(cagd_begins_name(r) || (is_turn && cagd_next_is(r, "("))) ||
        (r->integrals > 0 && cagd_differential(r, here) > 0))
        return 1;
    const cagd_tree *next = cagd_read_factor(r);
    if (next != NULL && next->dimension == 0)
        cagd_refuse_tree(r, next, "part of the angle, or a factor? write brackets, or the factor first");
    r->token = here;
    return next != NULL && next->dimension > 0;
}

/* The sine or cosine of an angle, the tangent s/c or the cotangent c/s. */
static const cagd_tree *function_of_angle(cagd_reader *r, const char *name, const cagd_tree *angle, int from)
{
    const cagd_tree *s = cagd_new_of(r, CAGD_SINE, from, 1, &angle), *c = cagd_new_of(r, CAGD_COSINE, from, 1, &angle);
    if (strcmp(name, "\\sin") == 0 || strcmp(name, "\\cos") == 0)
        return name[1] == 's' ? s : c;
    return cagd_new_of(r, CAGD_QUOTIENT, from, 2,
                       strcmp(name, "\\tan") == 0 ? (const cagd_tree *[]){s, c} : (const cagd_tree *[]){c, s});
}

/* \sin a, \cos^2 a, \tan a, \cot a; the name of the function is passed. */
static const cagd_tree *circular(cagd_reader *r, const char *name, int from)
{
    const cagd_tree *power = NULL;
    if (cagd_pass(r, "^") && (power = cagd_read_argument(r, 1)) == NULL)
        return NULL;
    if (power != NULL && power->kind == CAGD_NEGATIVE)
        return cagd_refuse_tree(r, power, "the inverse function, or 1 over it? write \\frac{1}{...}");
    int is_bare = cagd_begins_name(r) || r->token->kind == CAGD_TOKEN_NUMBER;
    int is_fraction = cagd_next_is(r, "\\frac");
    const cagd_tree *angle = angle_of(r);
    is_fraction = is_fraction && angle != NULL && is_turn(r, angle); /* \sin\frac{\pi}{2}t */
    if (angle != NULL && is_bare && cagd_next_is(r, "/") &&
        (r->token[1].kind == CAGD_TOKEN_NUMBER || cagd_tree_has(angle, "\\pi")))
        return cagd_refuse_token(r, "does the angle end before the stroke, or not? write brackets, or \\frac");
    const cagd_tree *t = angle != NULL && ((!is_bare && !is_fraction) || ends_angle(r, is_fraction))
                             ? function_of_angle(r, name, angle, from)
                             : NULL;
    return t == NULL || power == NULL ? t : cagd_new_of(r, CAGD_POWER, from, 2, (const cagd_tree *[]){t, power});
}

/* Behind \det: a matrix, or (a, b, c), the columns. */
static const cagd_tree *det(cagd_reader *r, int from)
{
    const cagd_token *start = r->token;
    const char *close = cagd_pass(r, "(") ? ")" : cagd_pass(r, "[") ? "]" : NULL;
    const cagd_tree *list[CAGD_MOST_ROWS], *a = NULL;
    int count = 0, depth = r->depth;
    while (close != NULL && count < CAGD_MOST_ROWS && (list[count] = cagd_read_sum(r)) != NULL &&
           list[count++]->dimension > 0 && cagd_pass(r, ","))
        ;
    if (count > 1 && cagd_pass(r, close)) {
        a = cagd_columns_of(r, count, list, from);
    } else if (r->error->message[0] == '\0') {
        r->token = start, r->depth = depth;
        a = cagd_read_factor(r);
    }
    return a != NULL ? cagd_determinant_of(r, a, from) : NULL;
}

/* What begins with \begin, that word being passed. */
static const cagd_tree *block(cagd_reader *r, int from)
{
    if (cagd_environment(r, "vmatrix"))
        return determinant(r, from);
    const char *matrix = cagd_pass_matrix(r);
    const cagd_tree *t = matrix != NULL ? cagd_read_matrix(r, matrix, from) : cases(r, 0, from);
    int has_name = 0;
    int has_q = strcmp(r->token[r->token->kind != CAGD_TOKEN_END && cagd_next_is(r, "]")].word, "_") == 0;
    if (t != NULL && t->kind == CAGD_POINT && t->dimension == 2 && !has_q &&
        cagd_is_of_whole_numbers(r, t->at[0], &has_name) && cagd_is_of_whole_numbers(r, t->at[1], &has_name) &&
        has_name)
        return cagd_refuse_tree(r, t, "a binomial coefficient, or a vector? write \\binom{n}{k}, or (n, k)");
    return t != NULL && t->kind == CAGD_POINT && t->count == 2 ? with_q(r, t, from) : t;
}

/* \langle a, b \rangle, the first word being passed. */
static const cagd_tree *scalar_product(cagd_reader *r)
{
    const cagd_tree *a = cagd_read_sum(r);
    if (a == NULL || (!cagd_next_is(r, "|") && !cagd_expect(r, ",", "the first vector")))
        return NULL;
    cagd_pass(r, "|");
    const cagd_tree *b = cagd_read_sum(r);
    if (b == NULL || !cagd_expect(r, "\\rangle", "the second vector"))
        return NULL;
    if (a->dimension == 0 || b->dimension == 0)
        return cagd_refuse_tree(r, a->dimension == 0 ? a : b, "the scalar product is of two vectors");
    return cagd_vector_product(r, "*", a, b);
}

/* \underbrace{a}_{b}, \overbrace{a}^{b}: a; what stands at the brace is a remark. */
static const cagd_tree *under_a_brace(cagd_reader *r)
{
    const cagd_tree *a = cagd_read_argument(r, 0);
    int depth = 0;
    if (a == NULL || (!cagd_pass(r, "_") && !cagd_pass(r, "^")))
        return a;
    do {
        depth += cagd_next_is(r, "{") - cagd_next_is(r, "}");
        if (r->token->kind == CAGD_TOKEN_END)
            return cagd_refuse_token(r, "expected '}' after the remark, not the end");
        r->token++;
    } while (depth > 0);
    return a;
}

static const cagd_tree *word(cagd_reader *r)
{
    int from = r->token->from;
    const char *w = r->token->word;
    if (strcmp(w, "\\frac") == 0)
        return r->token++, cagd_read_fraction(r, from);
    if (strcmp(w, "\\binom") == 0) {
        r->token++;
        const cagd_tree *a = cagd_read_argument(r, 0), *b = a != NULL ? cagd_read_argument(r, 0) : NULL;
        return with_q(r, cagd_new_of(r, CAGD_BINOMIAL, from, 2, (const cagd_tree *[]){a, b}), from);
    }
    if (strcmp(w, "\\sqrt") == 0)
        return r->token++, cagd_read_root(r, from);
    if (strcmp(w, "\\sum") == 0 || strcmp(w, "\\prod") == 0)
        return r->token++, cagd_read_over(r, w[1] == 's' ? CAGD_SUM_OVER : CAGD_PRODUCT_OVER, from);
    if (strcmp(w, "\\int") == 0)
        return r->token++, cagd_read_integral(r, from);
    if (strcmp(w, "\\max") == 0 || strcmp(w, "\\min") == 0)
        return r->token++, extremum(r, w[2] == 'a' ? CAGD_MAXIMUM : CAGD_MINIMUM, from);
    if (strcmp(w, "\\lfloor") == 0)
        return r->token++, bracketed(r, CAGD_FLOOR, "\\rfloor", from);
    if (strcmp(w, "\\lceil") == 0)
        return r->token++, bracketed(r, CAGD_CEILING, "\\rceil", from);
    if (strcmp(w, "\\begin") == 0)
        return r->token++, block(r, from);
    if (strcmp(w, "\\det") == 0) {
        r->token++;
        return det(r, from);
    }
    static const char *const of_angles[] = {"\\sin", "\\cos", "\\tan", "\\cot", NULL};
    if (is_one_of(w, of_angles))
        return r->token++, circular(r, w, from);
    if (strcmp(w, "\\langle") == 0)
        return r->token++, scalar_product(r);
    if (strcmp(w, "\\underbrace") == 0 || strcmp(w, "\\overbrace") == 0)
        return r->token++, under_a_brace(r);
    static const char *const others[] = {"\\sec",  "\\csc",  "\\exp",    "\\log",    "\\ln",     "\\sinh",
                                         "\\cosh", "\\tanh", "\\arcsin", "\\arccos", "\\arctan", NULL};
    if (is_one_of(w, others))
        return cagd_refuse_token(r, "%s is no rational function: name its value, and say what relation it has", w);
    if (strcmp(w, "\\vdots") == 0 || strcmp(w, "\\ddots") == 0)
        return cagd_refuse_token(r, "what is left out? a matrix is written with all of its entries");
    static const char *const plain[] = {"\\cases", "\\matrix", "\\pmatrix", "\\eqalign", NULL};
    if (is_one_of(w, plain))
        return cagd_refuse_token(r, "of plain TeX: write \\begin{%s} ... \\end{%s}",
                                 strcmp(w, plain[3]) == 0 ? "aligned" : w + 1,
                                 strcmp(w, plain[3]) == 0 ? "aligned" : w + 1);
    if (strcmp(w, "\\dots") == 0)
        return cagd_refuse_token(r, "what is left out? write it with \\sum or \\prod");
    return cagd_refuse_token(r, "%s is not understood", w);
}

/* A letter that has a meaning. */
static const char *known_letter(cagd_reader *r)
{
    const cagd_token *letter = r->token;
    const char *head = cagd_read_head(r);
    if (head == NULL || cagd_is_known(r, head))
        return head;
    r->token = letter;
    return cagd_refuse_token(r, "%s is not defined", head), NULL;
}

/* Names and their values: t = a, s = b, or the point (t, s) = (a, b), where all names get their values at once. */
struct at {
    const char *head[CAGD_MOST_INDICES];
    const cagd_tree *place[CAGD_MOST_INDICES];
    int count, is_point;
};

static int read_places(cagd_reader *r, struct at *a)
{
    do {
        if (a->count == CAGD_MOST_INDICES)
            return cagd_refuse_token(r, "a place of more than %d names", CAGD_MOST_INDICES) != NULL;
        a->head[a->count] = known_letter(r);
        if (a->head[a->count] == NULL || !cagd_expect(r, "=", "the letter"))
            return 0;
        a->place[a->count] = cagd_read_sum(r);
    } while (a->place[a->count++] != NULL && cagd_pass(r, ","));
    return a->place[a->count - 1] != NULL;
}

static int read_point_of_places(cagd_reader *r, struct at *a)
{
    a->is_point = 1;
    do {
        if (a->count == CAGD_MOST_INDICES)
            return cagd_refuse_token(r, "a place of more than %d names", CAGD_MOST_INDICES) != NULL;
        a->head[a->count] = known_letter(r);
    } while (a->head[a->count++] != NULL && cagd_pass(r, ","));
    if (!cagd_expect(r, ")", "the names") || !cagd_expect(r, "=", "the names") || !cagd_expect(r, "(", "the names"))
        return 0;
    for (int k = 0; k < a->count; k++)
        if ((k > 0 && !cagd_expect(r, ",", "the value")) || (a->place[k] = cagd_read_sum(r)) == NULL)
            return 0;
    return cagd_expect(r, ")", "the values");
}

/* The first other name of the place on which value k depends; -1 where there is none. */
static int other_name_in(const cagd_reader *r, const struct at *a, int k)
{
    for (int m = 0; m < a->count; m++)
        if (m != k && cagd_depends_on(r->scope, a->place[k], a->head[m]))
            return m;
    return -1;
}

static void exchange(struct at *a, int j, int k)
{
    const char *head = a->head[j];
    const cagd_tree *place = a->place[j];
    a->head[j] = a->head[k], a->place[j] = a->place[k];
    a->head[k] = head, a->place[k] = place;
}

/* Whether each name has one value, and in the list t = a, s = b, where no bracket says "at once", each value is without the other names. */
static int is_clear(cagd_reader *r, const struct at *a)
{
    for (int k = 0; k < a->count; k++)
        for (int m = 0; m < k; m++)
            if (strcmp(a->head[m], a->head[k]) == 0)
                return cagd_refuse_token(r, "%s has two values at this place", a->head[k]) != NULL;
    for (int k = 0; k < a->count && !a->is_point; k++) {
        int other = other_name_in(r, a, k);
        if (other >= 0)
            return cagd_refuse_token(r,
                                     "the value of %s depends on %s, which has one here, too: at once, or one after "
                                     "another? write a point, (%s, %s) = (a, b), or two places, |_{%s = a}|_{%s = b}",
                                     a->head[k], a->head[other], a->head[k], a->head[other], a->head[k],
                                     a->head[other]) != NULL;
    }
    return 1;
}

/* The names get their values one after another, the last one first: where a value is computed, the names behind its own have theirs already.  So
 * they are put into such an order that no value depends on a name behind its own; where there is none, two depend on one another. */
static int order_places(cagd_reader *r, struct at *a)
{
    for (int k = 0; k < a->count; k++) {
        struct at left = {.count = a->count - k};
        memcpy(left.head, a->head + k, (size_t)left.count * sizeof *left.head);
        memcpy(left.place, a->place + k, (size_t)left.count * sizeof *left.place);
        int next = 0;
        while (next < left.count && other_name_in(r, &left, next) >= 0)
            next++;
        if (next == left.count)
            return cagd_refuse_token(r,
                                     "the values of %s and %s depend on one another at this place: write the value "
                                     "itself, or give the place other letters",
                                     left.head[0], left.head[other_name_in(r, &left, 0)]) != NULL;
        exchange(a, k, k + next);
    }
    return 1;
}

/* The value of t at a place, f|_{x=a}, f|_{x=a, y=b}, f|_{(x,y)=(a,b)}, the bar being passed. */
static const cagd_tree *at_a_place(cagd_reader *r, const cagd_tree *t, int from)
{
    struct at a = {.count = 0};
    if (!cagd_expect(r, "_", "the bar") || !cagd_expect(r, "{", "the bar"))
        return NULL;
    if (!(cagd_pass(r, "(") ? read_point_of_places : read_places)(r, &a) || !is_clear(r, &a) || !order_places(r, &a) ||
        !cagd_expect(r, "}", "the place"))
        return NULL;
    if (cagd_next_is(r, "^"))
        return cagd_refuse_token(r,
                                 "a difference of two values, or a power? write it as a difference, or with brackets");
    for (int k = 0; k < a.count && t != NULL; k++) {
        cagd_tree *value = cagd_new_of(r, CAGD_AT, from, 2, (const cagd_tree *[]){t, a.place[k]});
        if (value != NULL)
            value->head = a.head[k];
        t = value;
    }
    return t;
}

/* "\mathbf{0}" or "\mathbf 0". */
static int vector_0_is_next(const cagd_reader *r)
{
    if (!cagd_next_is(r, "\\mathbf"))
        return 0;
    const cagd_token *next = r->token + 1;
    return strcmp(next[strcmp(next->word, "{") == 0].word, "0") == 0;
}

static const cagd_tree *base(cagd_reader *r)
{
    int from = r->token->from;
    if (vector_0_is_next(r)) {
        r->token++;
        return cagd_read_argument(r, 0);
    }
    if (cagd_begins_name(r))
        return cagd_read_name(r);
    if (r->token->kind == CAGD_TOKEN_NUMBER)
        return number(r);
    if (r->token->kind == CAGD_TOKEN_WORD)
        return word(r);
    if (cagd_pass(r, "\\left.")) { /* all that is up to the bar */
        const cagd_tree *t = cagd_read_sum(r);
        return t != NULL && cagd_expect(r, "\\right|", "the bracket") ? at_a_place(r, t, from) : NULL;
    }
    if (cagd_pass(r, "("))
        return group(r, ")");
    if (cagd_pass(r, "["))
        return group(r, "]");
    if (cagd_pass(r, "{"))
        return group(r, "}");
    if (cagd_next_is(r, "\\{") && strcmp(r->token[1].word, "\\begin") == 0)
        return r->token += 2, cases(r, 1, from);
    if (cagd_pass(r, "\\{"))
        return group(r, "\\}");
    if (cagd_pass(r, "|"))
        return bracketed(r, CAGD_ABSOLUTE, "|", from);
    if (cagd_pass(r, "\\|"))
        return bracketed(r, CAGD_NORM, "\\|", from);
    return cagd_refuse_token(r, "expected a number, a name or a bracket, not %s", cagd_name_of_next(r));
}

/* A number of halves that is not whole, 1/2, -3/2 or \frac12: how many; 0 where it is another power. */
static long halves(const cagd_tree *power)
{
    int minus = power->kind == CAGD_NEGATIVE;
    power = minus ? power->at[0] : power;
    if (power->kind != CAGD_QUOTIENT || power->at[0]->kind != CAGD_NUMBER || power->at[1]->kind != CAGD_NUMBER)
        return 0;
    if (!cagd_equal_q(power->at[1]->number, from_int_q(2)) || !cagd_is_whole_q(power->at[0]->number) ||
        !mpz_fits_sshort_p(mpq_numref(power->at[0]->number.at)))
        return 0;
    long n = mpz_get_si(mpq_numref(power->at[0]->number.at));
    return n % 2 == 0 ? 0 : minus ? -n : n;
}

const cagd_tree *cagd_power_of(cagd_reader *r, const cagd_tree *t, const cagd_tree *power, int from)
{
    long n = t->dimension == 0 ? halves(power) : 0;
    if (cagd_is_matrix(t->dimension))
        return cagd_matrix_power(r, t, power);
    if (t->dimension > 0 && power->kind == CAGD_NUMBER)
        return cagd_refuse_tree(r, t,
                                "a vector has no powers: write \\mathbf{a} \\cdot \\mathbf{a} or \\|\\mathbf{a}\\|^2");
    if (n != 0) { /* a^{3/2} = (\sqrt a)^3 */
        t = cagd_new_of(r, CAGD_ROOT, from, 2, (const cagd_tree *[]){t, cagd_tree_number(2, power->from, power->to)});
        power = cagd_tree_number(n, power->from, power->to);
    }
    return n == 1 ? t : cagd_new_of(r, CAGD_POWER, from, 2, (const cagd_tree *[]){t, power});
}

/* Whether {(j)} comes next: an order of a derivative, and no power. */
static int order_in_brackets_follows(const cagd_reader *r)
{
    const cagd_token *t = r->token + 1;
    int depth = 0;
    if (!cagd_next_is(r, "{") || strcmp(t->word, "(") != 0)
        return 0;
    do
        depth += (strcmp(t->word, "(") == 0) - (strcmp(t->word, ")") == 0);
    while (depth > 0 && (++t)->kind != CAGD_TOKEN_END);
    return depth == 0 && strcmp(t[1].word, "}") == 0;
}

/* {B_i^n}^{(j)}(t): the derivative of that order of the function t, with its arguments, if they follow. */
static const cagd_tree *with_order(cagd_reader *r, const cagd_tree *t)
{
    enum { BRACKETS = 2 };
    r->token += BRACKETS;
    const cagd_tree *order = cagd_read_sum(r);
    if (order == NULL || !cagd_expect(r, ")", "the order of the derivative") || !cagd_expect(r, "}", "the order"))
        return NULL;
    cagd_tree *whole = cagd_new(r, CAGD_NAME, t->from, t->count);
    if (whole == NULL)
        return NULL;
    const cagd_tree **at = whole->at;
    *whole = *t, whole->at = at, whole->times = order, whole->to = r->token[-1].to;
    for (int k = 0; k < t->count; k++)
        at[k] = t->at[k];
    return cagd_read_primed_group(r, whole);
}

/* t with what stands behind ^. */
static const cagd_tree *powered(cagd_reader *r, const cagd_tree *t, int from)
{
    if (t->dimension > 0 && cagd_pass_transposed(r))
        return cagd_transposed(r, t);
    if (cagd_is_bare_function(r, t) && t->times == NULL && order_in_brackets_follows(r))
        return with_order(r, t);
    const cagd_tree *power = cagd_read_argument(r, 1);
    if (power != NULL && cagd_is_bare_function(r, t) && (t = cagd_read_primed_group(r, t)) == NULL) /* {f'}^2(t) */
        return NULL;
    return power != NULL ? cagd_power_of(r, t, power, from) : NULL;
}

const cagd_tree *cagd_read_factor(cagd_reader *r)
{
    int from = r->token->from;
    if (++r->depth > CAGD_MOST_DEPTH)
        return cagd_refuse_token(r, "more than %d levels of brackets", CAGD_MOST_DEPTH);
    const cagd_tree *t = base(r);
    int is_power = 0;
    while (t != NULL) {
        if (cagd_pass(r, "!")) {
            if (cagd_next_is(r, "!"))
                return cagd_refuse_token(r, "the double factorial is not understood; (x!)! has brackets");
            t = cagd_new_of(r, CAGD_FACTORIAL, from, 1, &t);
        } else if (cagd_next_is(r, "^") && is_power) {
            return cagd_refuse_token(r, "two powers: write {a^b}^c or a^{b^c}");
        } else if (cagd_pass(r, "^")) {
            t = powered(r, t, from);
            is_power = 1;
        } else if (cagd_next_is(r, "|") && strcmp(r->token[1].word, "_") == 0) {
            r->token++;
            t = at_a_place(r, t, from);
        } else {
            break;
        }
    }
    r->depth--;
    return t;
}

static int begins_factor(const cagd_reader *r)
{
    static const char *const words[] = {"\\sin",   "\\cos",    "\\tan",        "\\cot",       "\\frac",
                                        "\\binom", "\\sqrt",   "\\sum",        "\\prod",      "\\int",
                                        "\\max",   "\\min",    "\\lfloor",     "\\lceil",     "\\begin",
                                        "\\det",   "\\langle", "\\underbrace", "\\overbrace", NULL};
    if (r->integrals > 0 && cagd_differential(r, r->token) > 0)
        return 0;
    return cagd_begins_name(r) || r->token->kind == CAGD_TOKEN_NUMBER ||
           (r->token->kind == CAGD_TOKEN_WORD && is_one_of(r->token->word, words)) ||
           (cagd_next_is(r, "(") && !cagd_is_truth_in_brackets(r)) || cagd_next_is(r, "[") || cagd_next_is(r, "{") ||
           cagd_next_is(r, "\\{") || cagd_next_is(r, "\\left.") || (r->norms == 0 && cagd_next_is(r, "\\|")) ||
           (r->amounts == 0 && cagd_next_is(r, "|") && strcmp(r->token[1].word, "_") != 0);
}

/* Whether one of these stands between the last token and the next one. */
static int is_behind(const cagd_reader *r, const char *const words[])
{
    for (int k = r->token[-1].to; k < r->token->from; k++)
        for (int m = 0; words[m] != NULL; m++)
            if (strncmp(r->text + k, words[m], strlen(words[m])) == 0)
                return 1;
    return 0;
}

int cagd_is_behind_wide_space(const cagd_reader *r)
{
    static const char *const spaces[] = {"\\quad", "\\qquad", "\\hspace", "\\hskip", "~~", NULL};
    return is_behind(r, spaces);
}

/* A factor that begins a line, or stands behind a space, or behind a number that is no factor, may be the first of another formula: the relation behind
 * it will tell. */
static void note_break(cagd_reader *r, int behind_0_or_1)
{
    static const char *const spaces[] = {"\n", "\\;", "\\ ", "~", NULL};
    if (behind_0_or_1 || is_behind(r, spaces))
        r->broken = r->token, r->broken_depth = r->depth, r->broken_by_sign = 0;
}

/* So may a sign that begins a line, -1 \le x \le 1, if bounds follow. */
static void note_sign(cagd_reader *r)
{
    static const char *const line[] = {"\n", NULL};
    if ((cagd_next_is(r, "-") || cagd_next_is(r, "+")) && is_behind(r, line))
        r->broken = r->token, r->broken_depth = r->depth, r->broken_by_sign = 1;
}

/* Whether another sum or product over that index comes next: what is summed ends before it. */
static int is_sum(const char *word) { return strcmp(word, "\\sum") == 0 || strcmp(word, "\\prod") == 0; }
static int is_over(const cagd_token *t, const char *index)
{
    return index != NULL && strcmp(t[1].word, "_") == 0 && strcmp(t[2].word, "{") == 0 && strcmp(t[3].word, index) == 0;
}

/* Dots between factors, perhaps with a sign of a product before them: not ".." and not those of a range. */
static int dots_between(const cagd_reader *r)
{
    const cagd_token *t = r->token + cagd_next_is(r, "*");
    return r->ends == 0 && strcmp(t->word, "\\dots") == 0 && r->text[t->from] != '.';
}

/* Dots and the last factor come next; of the factors before them *count are left, the last one being what is returned. */
static const cagd_tree *factors_left_out(cagd_reader *r, const cagd_tree *list[], int *count)
{
    int start;
    cagd_pass(r, "*");
    const cagd_token *dots = r->token++;
    cagd_pass(r, "*");
    const cagd_tree *last = cagd_read_factor(r);
    const cagd_tree *t =
        last != NULL ? cagd_fill_dots(r, CAGD_PRODUCT_OVER, dots, list, *count, last, 0, &start) : NULL;
    *count = t != NULL ? start + 1 : 1;
    return t;
}

/* Dots and the last term come next, the sign before the dots being passed, which was a minus or not; likewise. */
static const cagd_tree *terms_left_out(cagd_reader *r, const cagd_tree *list[], int *count, int before)
{
    int start;
    if (cagd_next_is(r, "+") || cagd_next_is(r, "-")) /* a_0 - a_1 + - \dots */
        before = cagd_next_is(r, "-"), r->token++;
    const cagd_token *dots = r->token++;
    int from = r->token->from, minus = cagd_pass(r, "-");
    if (!minus && !cagd_expect(r, "+", "the dots"))
        return NULL;
    const cagd_tree *last = cagd_read_product(r);
    if (last != NULL && minus)
        last = cagd_new_of(r, CAGD_NEGATIVE, from, 1, &last);
    const cagd_tree *t =
        last != NULL ? cagd_fill_dots(r, CAGD_SUM_OVER, dots, list, *count, last, minus != before, &start) : NULL;
    *count = t != NULL ? start + 1 : 1;
    return t;
}

/* F[2] of a function F: of round brackets it would be a value. */
static int may_be_arguments(const cagd_reader *r, const cagd_tree *t)
{
    return cagd_is_bare_function(r, t) && cagd_next_is(r, "[") && !cagd_bracket_has_function(r);
}

/* A product, or what a sum or product over an index is `inside`. */
static int is_0_or_1(const cagd_tree *t)
{
    return t->kind == CAGD_NUMBER && (cagd_equal_q(t->number, from_int_q(0)) || cagd_equal_q(t->number, from_int_q(1)));
}

const cagd_tree *cagd_read_product_in(cagd_reader *r, cagd_tree_kind inside, const char *index)
{
    const cagd_tree *list[CAGD_MOST_CHILDREN];
    int count = 0, from = r->token->from, juxtaposed = 1, is_cross = 0;
    list[count++] = cagd_read_factor(r);
    while (list[count - 1] != NULL) {
        if (may_be_arguments(r, list[count - 1]))
            return cagd_refuse_token(r, "arguments of %s, or a factor? write round brackets, or \\cdot between",
                                     cagd_spelled(list[count - 1]->head));
        if ((list[count - 1]->kind == CAGD_DERIVATIVE ||
             (list[count - 1]->kind == CAGD_NAME && list[count - 1]->order > 0 && list[count - 1]->arguments > 0)) &&
            cagd_next_is(r, "(") && r->token[1].kind == CAGD_TOKEN_NUMBER && strcmp(r->token[2].word, ")") == 0)
            return cagd_refuse_token(
                r, "is the number where the derivative is taken, or a factor? write f'(2), |_{t=2}, or \\cdot");
        if (is_cross && cagd_next_is(r, "\\times"))
            return cagd_refuse_token(
                r, "a \\times b \\times c is (a \\times b) \\times c or a \\times (b \\times c): write brackets");
        const char *sign = cagd_next_is(r, "\\times") ? "\\times" : "*";
        if (dots_between(r)) {
            const cagd_tree *all = factors_left_out(r, list, &count);
            list[count - 1] = all;
            continue;
        }
        if (cagd_next_is(r, "/") && is_sum(r->token[1].word) && is_over(r->token + 1, index))
            break; /* a sum over i by another one */
        int dot = cagd_pass(r, sign), stroke = !dot && cagd_pass(r, "/");
        if (!dot && !stroke && (!begins_factor(r) || (r->squares == 0 && cagd_is_behind_wide_space(r))))
            break;
        if (!dot && !stroke)
            note_break(r, count == 1 && is_0_or_1(list[0]));
        if (is_sum(r->token->word) && is_over(r->token, index) && !dot && !stroke)
            break;
        if (cagd_next_is(r, "\\prod") && inside == CAGD_PRODUCT_OVER)
            return cagd_refuse_token(r, "is the second product inside the first? write brackets");
        juxtaposed &= !dot && !stroke;
        if (stroke) {
            const cagd_tree *above = count > 1 ? cagd_new_of(r, CAGD_PRODUCT, from, count, list) : list[0];
            const cagd_tree *under = cagd_read_factor(r);
            if (under != NULL && begins_factor(r))
                return cagd_refuse_token(r, "a/b c is (a/b) c or a/(b c): write \\frac or brackets");
            list[0] = cagd_new_of(r, CAGD_QUOTIENT, from, 2, (const cagd_tree *[]){above, under});
            count = 1;
            continue;
        }
        if (!dot && r->token->kind == CAGD_TOKEN_NUMBER && list[count - 1]->kind == CAGD_NUMBER)
            return cagd_refuse_token(r, "two numbers side by side");
        if (count == CAGD_MOST_CHILDREN)
            return cagd_refuse_token(r, "more than %d factors", CAGD_MOST_CHILDREN);
        list[count] = cagd_read_factor(r);
        if (dot && sign[0] == '*' && list[count] != NULL && list[count]->dimension > 0 && cagd_pass(r, "\\times")) {
            const cagd_tree *third = cagd_read_factor(r); /* a . b x c */
            list[count] = third != NULL ? cagd_vector_product(r, "\\times", list[count], third) : NULL;
            is_cross = 1;
        }
        if (dot && list[count] != NULL && list[count]->dimension > 0 && list[count - 1]->dimension > 0) {
            for (int k = 0; k + 1 < count; k++)
                if (cagd_is_matrix(list[k]->dimension) && !cagd_is_matrix(list[count - 1]->dimension))
                    return cagd_refuse_tree(r, list[count], "a matrix and two vectors: write brackets");
            list[count - 1] = cagd_vector_product(r, sign, list[count - 1], list[count]);
            is_cross |= list[count - 1] != NULL && list[count - 1]->kind == CAGD_CROSS;
            continue;
        }
        count++;
    }
    if (list[count - 1] == NULL || count == 1)
        return list[count - 1];
    cagd_tree *t = cagd_new_of(r, CAGD_PRODUCT, from, count, list);
    if (t != NULL)
        t->juxtaposed = juxtaposed;
    return t;
}

const cagd_tree *cagd_read_product(cagd_reader *r) { return cagd_read_product_in(r, CAGD_PRODUCT, NULL); }

const cagd_tree *cagd_read_sum(cagd_reader *r)
{
    const cagd_tree *list[CAGD_MOST_CHILDREN];
    int count = 0, from = r->token->from, begin = from, minus = cagd_pass(r, "-");
    if (++r->depth > CAGD_MOST_DEPTH)
        return cagd_refuse_token(r, "more than %d levels of brackets", CAGD_MOST_DEPTH);
    if (!minus)
        cagd_pass(r, "+");
    for (;;) {
        const cagd_tree *t = cagd_read_product(r);
        if (t != NULL && minus)
            t = cagd_new_of(r, CAGD_NEGATIVE, begin, 1, &t);
        if (t == NULL)
            return NULL;
        if (count == CAGD_MOST_CHILDREN) { /* the sum so far is one of its terms */
            list[0] = cagd_new_of(r, CAGD_SUM, from, count, list);
            count = 1;
        }
        list[count++] = t;
        begin = r->token->from;
        note_sign(r);
        minus = cagd_pass(r, "-");
        if (!minus && !cagd_pass(r, "+"))
            break;
        int more = cagd_next_is(r, "+") || cagd_next_is(r, "-");
        if (strcmp(r->token[more].word, "\\dots") == 0) {
            const cagd_tree *all = terms_left_out(r, list, &count, minus);
            if (all == NULL)
                return NULL;
            list[count - 1] = all;
            begin = r->token->from;
            minus = cagd_pass(r, "-");
            if (!minus && !cagd_pass(r, "+"))
                break;
        }
    }
    r->depth--;
    return count == 1 ? list[0] : cagd_new_of(r, CAGD_SUM, from, count, list);
}

/* ---- relations ----------------------------------------------------------------------------------------- */

int cagd_relation_next(const cagd_reader *r, cagd_relation *relation)
{
    static const char *const words[] = {"=", "\\ne", "<", "\\le", ">", "\\ge"};
    for (int k = 0; k < 6; k++)
        if (cagd_next_is(r, words[k])) {
            *relation = (cagd_relation)k;
            return 1;
        }
    return 0;
}

int cagd_changes_direction(const cagd_relation relation[], int count)
{
    int less = 0, greater = 0;
    for (int k = 0; k < count; k++) {
        less |= relation[k] == CAGD_LESS || relation[k] == CAGD_LESS_OR_EQUAL;
        greater |= relation[k] == CAGD_GREATER || relation[k] == CAGD_GREATER_OR_EQUAL;
    }
    return less && greater;
}

/* The & and the breaks of lines before a relation. */
static void pass_alignment(cagd_reader *r)
{
    const cagd_token *t = r->token;
    cagd_relation relation;
    while (cagd_next_is(r, "&") || cagd_next_is(r, "\\\\"))
        r->token++;
    if (!cagd_relation_next(r, &relation))
        r->token = t;
}

/* What is left out of a chain, "\dots =": between equal relations, or before the first.  Whether it was passed. */
static int pass_dots(cagd_reader *r, int count, const cagd_relation before[])
{
    cagd_relation next;
    const cagd_token *t = r->token;
    if (cagd_pass(r, "\\dots") && cagd_relation_next(r, &next) && (count == 0 || next == before[count - 1])) {
        r->token++;
        return 1;
    }
    r->token = t;
    return 0;
}

/* "< \infty" at the end of a chain, or "-\infty <" at its beginning, which say nothing: passed. */
static int pass_infinity(cagd_reader *r, int is_first)
{
    const cagd_token *t = r->token;
    cagd_relation relation;
    int minus = cagd_pass(r, "-");
    if (!minus)
        cagd_pass(r, "+");
    if (cagd_pass(r, "\\infty") && minus == is_first &&
        (!is_first || (cagd_relation_next(r, &relation) && relation == CAGD_LESS && r->token++)))
        return 1;
    r->token = t;
    return 0;
}

/* The members of a chain so far, of which those before `begin` are in the conditions: dots, what they leave out, made these. */
struct chain {
    const cagd_tree *member[CAGD_MOST_CHILDREN], *said[CAGD_MOST_CHILDREN];
    cagd_relation relation[CAGD_MOST_CHILDREN];
    int count, begin, says;
};

static int add_said(cagd_reader *r, struct chain *c, const cagd_tree *t)
{
    if (t != NULL && c->says == CAGD_MOST_CHILDREN)
        return cagd_refuse_token(r, "more than %d relations", CAGD_MOST_CHILDREN - 1) != NULL;
    if (t != NULL)
        c->said[c->says++] = t;
    return t != NULL;
}

/* The members from `begin` to `end` are a chain without dots. */
static int close_chain(cagd_reader *r, struct chain *c, int end)
{
    if (end == c->begin)
        return 1;
    return add_said(
        r, c,
        cagd_relate(r, c->member[c->begin]->from, end - c->begin + 1, c->member + c->begin, c->relation + c->begin));
}

/* The last member stands behind dots, and before them those with the same relation between. */
static int fill_chain(cagd_reader *r, struct chain *c, const cagd_token *dots)
{
    int last = c->count - 1, first = last - 1, start;
    while (first > c->begin && c->relation[first - 1] == c->relation[last - 1])
        first--;
    const cagd_tree *between = last > c->begin ? cagd_fill_chain(r, c->member + first, last - first, c->member[last],
                                                                 c->relation[last - 1], &start)
                                               : NULL;
    if (between == NULL) {
        r->left_out = dots;
        return r->error->message[0] == '\0';
    }
    if (!close_chain(r, c, first + start) || !add_said(r, c, between))
        return 0;
    c->begin = last;
    return 1;
}

const cagd_tree *cagd_read_relations(cagd_reader *r)
{
    struct chain c = {.count = 0};
    int from = r->token->from;
    pass_infinity(r, 1);
    do {
        const cagd_token *dots;
        if (c.count == CAGD_MOST_CHILDREN)
            return cagd_refuse_token(r, "more than %d relations", CAGD_MOST_CHILDREN - 1);
        cagd_pass(r, "&");
        if (c.count > 1 && c.relation[c.count - 1] == CAGD_LESS && pass_infinity(r, 0))
            break;
        dots = r->token;
        int has_dots = pass_dots(r, c.count, c.relation);
        r->broken = NULL;
        c.member[c.count] = cagd_read_sum(r);
        if (c.member[c.count++] == NULL || (has_dots && !fill_chain(r, &c, dots)))
            return NULL;
        pass_alignment(r);
        cagd_relation next;
        if (c.count > 1 && r->broken != NULL && r->broken_depth == r->depth + 1 && cagd_relation_next(r, &next) &&
            (!r->broken_by_sign || (next != CAGD_EQUAL && c.relation[c.count - 2] == CAGD_EQUAL))) {
            r->token = r->broken;
            return cagd_refuse_token(r, "does another formula begin here? write a comma before it, or \\cdot");
        }
    } while (cagd_relation_next(r, &c.relation[c.count - 1]) && r->token++);
    if (cagd_changes_direction(c.relation, c.count - 1))
        return cagd_refuse_token(r, "a chain with < and >: write two relations");
    if (c.count == 1 && cagd_next_is(r, ":="))
        return cagd_refuse_token(r, "':=' says what a name means: write it in a let block, or = here");
    if (c.count == 1)
        return cagd_refuse_token(r, "expected a relation, = or <, not %s", cagd_name_of_next(r));
    if (c.says == 0)
        return cagd_relate(r, from, c.count, c.member, c.relation);
    if (!close_chain(r, &c, c.count - 1))
        return NULL;
    return c.says == 1 ? c.said[0] : cagd_new_of(r, CAGD_ALL, from, c.says, c.said);
}

/* Whether another condition begins behind a wide space, as behind a comma. */
static int goes_on_behind_space(const cagd_reader *r)
{
    return r->token->kind != CAGD_TOKEN_END && cagd_is_behind_wide_space(r) &&
           (begins_factor(r) || cagd_next_is(r, "-")) && !cagd_is_truth_in_brackets(r);
}

const cagd_tree *cagd_read_conditions(cagd_reader *r)
{
    const cagd_tree *list[CAGD_MOST_CHILDREN];
    int count = 0, from = r->token->from, more, by_sign = 1, by_word = 0, behind_row = 0,
        comma = -1; /* by_sign: by \land alone */
    unsigned long long asked = 0;
    do {
        const cagd_tree *t = cagd_share_bounds(r) ? cagd_read_condition(r) : NULL;
        if (t == NULL)
            return NULL;
        const cagd_tree *const *conditions = t->kind == CAGD_ALL ? t->at : &t; /* of vectors one for each component */
        int several = t->kind == CAGD_ALL ? t->count : 1;
        if (count + several > CAGD_MOST_CHILDREN)
            return cagd_refuse_token(r, "more than %d conditions", CAGD_MOST_CHILDREN);
        for (int k = 0; k < several; k++) {
            asked |= by_word ? 1ull << count : 0;
            list[count++] = conditions[k];
        }
        const cagd_token *here = r->token;
        int by_space = goes_on_behind_space(r);
        more = by_space || cagd_pass(r, ",") || cagd_pass(r, ";") || cagd_pass(r, "\\land");
        const char *words = cagd_read_words(r);
        behind_row |= here->kind == CAGD_TOKEN_ROW;
        by_word = words != NULL || here->word[0] == ';' || behind_row;
        if (words != NULL &&
            (strcmp(words, "and") == 0 || strcmp(words, "and all") == 0 || strcmp(words, "and for all") == 0))
            more = 1;
        else if (words != NULL)
            r->token = here, more = 0;
        if (more && (cagd_next_is_member(r) || cagd_forall_of_names(r) ||
                     (r->premises == 0 && cagd_next_is_parity(r)) || cagd_next_is_other_definition(r) ||
                     r->token->kind == CAGD_TOKEN_END || cagd_next_is(r, "\\\\") || cagd_next_is(r, "\\end")))
            more = 0;
        by_sign &= !more || strcmp(here->word, "\\land") == 0;
        if (more && comma < 0 && (by_space || strchr(",;", here->word[0]) != NULL))
            comma = here->from;
    } while (more);
    cagd_tree *all = count > 1 ? (cagd_tree *)cagd_new_of(r, CAGD_ALL, from, count, list) : NULL;
    if (all != NULL)
        all->juxtaposed = by_sign, all->asked = asked;
    r->comma = comma;
    return count == 1 ? list[0] : all;
}

int cagd_at_the_end(cagd_reader *r)
{
    if (r->token->kind == CAGD_TOKEN_SIGN && strcmp(r->token->word, ".") == 0)
        r->token++;
    if (r->token->kind == CAGD_TOKEN_END)
        return 1;
    const cagd_token *here = r->token;
    const char *words = cagd_read_words(r);
    r->token = here;
    if (words != NULL && words[0] != '\0' && !cagd_are_words_of_range(words))
        return cagd_refuse_words(r, words) != NULL;
    if (cagd_next_is(r, "\\\\"))
        return cagd_refuse_token(r,
                                 "a row is a formula of its own, with a relation, or goes on with one: expected that "
                                 "behind \\\\") != NULL;
    if (cagd_next_is(r, "&"))
        return cagd_refuse_token(r, "is what stands behind '&' a condition, or another formula? write \\text{for} or a "
                                    "comma") != NULL;
    if (cagd_next_is(r, "\\end"))
        return cagd_refuse_token(r,
                                 "is what stands behind the rows of all of them? a row has a word or an arrow of its "
                                 "own: write brackets") != NULL;
    return cagd_refuse_token(r, "expected the end of the formula, not %s", cagd_name_of_next(r)) != NULL;
}

const cagd_tree *cagd_read_value(const cagd_scope *scope, const char *text, int from, int to, cagd_reading_error *error)
{
    cagd_reader r;
    if (!cagd_reader_open(&r, scope, text, from, to, error))
        return NULL;
    const cagd_tree *t = cagd_read_sum(&r);
    return t != NULL && cagd_at_the_end(&r) ? t : NULL;
}

const cagd_tree *cagd_read_statement(const cagd_scope *scope, const char *text, int from, int to,
                                     cagd_reading_error *error)
{
    cagd_reader r;
    if (!cagd_reader_open(&r, scope, text, from, to, error))
        return NULL;
    if (cagd_are_read_apart(&r))
        return cagd_read_rows_apart(&r);
    const cagd_tree *t = cagd_read_for_all_numbers(&r);
    return t != NULL && cagd_at_the_end(&r) ? t : NULL;
}
