/* read_rows.c -- formulas below one another, at the beginning of what is read: their environment is opened, and commas are put between them.
 *
 *     \left\{ \begin{array}{l} b_0(t) = 1 - t, \\ b_1(t) = t \end{array} \right.       \begin{cases} x = 1 \\ y = 2 \end{cases}
 *     \begin{aligned} f(t) &= t^2 \\ &= t \cdot t \\ g(t) &= 1 \end{aligned}
 *
 * Rows of values with conditions are no formulas: \begin{cases} x & x \ge 0 \\ -x & x < 0 \end{cases}. */
#include "exact/expression/reader.h"
#include "exact/words.h"

#include <string.h>

static int is_word(const cagd_token *t, const char *word) { return strcmp(t->word, word) == 0; }

static int is_relation(const cagd_token *t)
{
    static const char *const words[] = {"=", ":=", "\\ne", "<", "\\le", ">", "\\ge"};
    for (size_t k = 0; k < sizeof words / sizeof *words; k++)
        if (is_word(t, words[k]))
            return 1;
    return 0;
}

static int change_of_brackets(const cagd_token *t)
{
    return is_word(t, "(") + is_word(t, "[") - is_word(t, ")") - is_word(t, "]");
}
static int change_of_groups(const cagd_token *t)
{
    return is_word(t, "{") + is_word(t, "\\begin") - is_word(t, "}") - is_word(t, "\\end");
}
static int change_of_depth(const cagd_token *t) { return change_of_brackets(t) + change_of_groups(t); }

/* Whether what stands before goes on behind it: a sign, a relation, or a comma. */
static int ends_open(const cagd_token *t)
{
    static const char *const signs[] = {",", ";", "+", "-", "*", "\\times", "/", "\\dots", "\\Rightarrow", "\\iff"};
    for (size_t k = 0; k < sizeof signs / sizeof *signs; k++)
        if (is_word(t, signs[k]))
            return 1;
    return is_relation(t);
}

/* Behind the group at t, {aligned} or {ll}; its letters go to `name`. */
static const cagd_token *behind_group(const cagd_token *t, char *name, size_t room)
{
    size_t n = 0;
    if (!is_word(t, "{"))
        return t;
    for (t++; t->kind != CAGD_TOKEN_END && !is_word(t, "}"); t++)
        if (n + 1 < room)
            name[n++] = t->word[0];
    name[n] = '\0';
    return t->kind == CAGD_TOKEN_END ? t : t + 1;
}

/* Whether the row at t, up to `stop`, has a relation, with no comma, text or & before it, but for an & right before it, or at the beginning. */
static int is_formula(const cagd_token *t, const cagd_token *stop)
{
    int depth = 0;
    t += is_word(t, "&");
    for (; t < stop && !is_word(t, "\\\\"); depth += change_of_depth(t), t++) {
        if (depth > 0)
            continue;
        if (is_relation(t) || (is_word(t, "&") && is_relation(t + 1)))
            return 1;
        if (is_word(t, "&") || is_word(t, ",") || is_word(t, "\\text"))
            return 0;
    }
    return 0;
}

/* Whether a round bracket with a relation in it stands at t: (x \ge 0). */
static int is_condition(const cagd_token *t)
{
    int depth = is_word(t, "(");
    for (t += depth; depth > 0 && t->kind != CAGD_TOKEN_END; depth += change_of_depth(t), t++)
        if (depth == 1 && is_relation(t))
            return 1;
    return 0;
}

/* Whether the row at t, up to `stop`, begins with + or - and has a relation: a formula of its own where that stands behind an &, -x &= 0, and unclear
 * without one; behind a formula without a relation, and where the & stands before the sign, it goes on. */
enum signed_row { NO_SIGNED_ROW, SIGNED_FORMULA, UNCLEAR_SIGN };
static enum signed_row of_signed_row(const cagd_token *t, const cagd_token *stop)
{
    if ((!is_word(t, "+") && !is_word(t, "-")) || !is_formula(t, stop))
        return NO_SIGNED_ROW;
    while (!is_relation(t) && !is_word(t, "&"))
        t++;
    return is_word(t, "&") ? SIGNED_FORMULA : UNCLEAR_SIGN;
}

/* Whether the row at t begins with a sign, a relation or a word that goes on with what is before it. */
static int goes_on_by_sign(const cagd_token *t)
{
    static const char *const signs[] = {"+",     "-", "*",     "\\times", "/", "\\text", "\\Rightarrow",
                                        "\\iff", ",", "\\dots"};
    while (is_word(t, "&"))
        t++;
    for (size_t k = 0; k < sizeof signs / sizeof *signs; k++)
        if (is_word(t, signs[k]))
            return 1;
    return is_relation(t);
}

/* Whether the row at t goes on with the formula before it. */
static int goes_on(const cagd_token *t, const cagd_token *stop, const cagd_token *first)
{
    return (is_word(t, "&") && !is_word(first, "&")) || /* at the place of the relation */
           goes_on_by_sign(t) || !is_formula(t, stop);
}

/* The end of the environment whose rows begin at t. */
static const cagd_token *end_of_rows(const cagd_token *t)
{
    for (int depth = 0; t->kind != CAGD_TOKEN_END; t++) {
        if (depth == 0 && is_word(t, "\\end"))
            return t;
        depth += is_word(t, "\\begin") - is_word(t, "\\end");
    }
    return t;
}

/* Whether the & at s begins a column of its own behind a formula: x^2 = x & x \ge 0. */
static int is_other_column(const cagd_token *s, const cagd_token *end, const cagd_token *before)
{
    return !ends_open(before) && s + 1 < end && !is_word(s + 1, "\\\\") && !is_word(s + 1, "&") &&
           !goes_on_by_sign(s + 1) && !is_condition(s + 1);
}

/* The rows from `first` to `end` go to `to` with commas between; what is behind them comes out.  A row that neither has a relation nor begins with a sign,
 * and a column behind a formula, are left as they are, and refused where they are read: they would be factors. */
static cagd_token *put_rows(cagd_token *to, const cagd_token *start, const cagd_token *first, const cagd_token *end,
                            int is_environment)
{
    int groups = 0, brackets = 0, related = 0; /* related: the row has a relation */
    for (const cagd_token *s = first; s < end; s++) {
        int is_break = groups == 0 && is_word(s, "\\\\");
        int is_row = is_break && brackets == 0 && s + 1 < end && to > start;
        enum signed_row sign = is_row && related ? of_signed_row(s + 1, end) : NO_SIGNED_ROW;
        int begins = is_row && (sign == SIGNED_FORMULA || !goes_on(s + 1, end, first));
        if (begins && !ends_open(to - 1))
            *to++ = (cagd_token){CAGD_TOKEN_ROW, ",", s->from, s->to};
        if (is_break && brackets == 0 && to > start && is_word(to - 1, ";"))
            to[-1].word = ",";
        if (begins && is_word(to - 1, ","))
            to[-1].kind = CAGD_TOKEN_ROW, related = 0;
        int stays = is_break && !(is_environment && s + 1 == end) && !(to > start && is_word(to - 1, ",")) &&
                    (!goes_on_by_sign(s + 1) || sign == UNCLEAR_SIGN) &&
                    !(is_environment && (brackets > 0 || to == start || ends_open(to - 1) || is_condition(s + 1)));
        int is_column = groups == 0 && is_word(s, "&");
        stays |= is_column && is_environment && related && brackets == 0 && to > start &&
                 !(s > first && is_word(s - 1, "\\\\")) && is_other_column(s, end, to - 1);
        if ((is_break || is_column) && !stays)
            continue;
        related |= groups == 0 && brackets == 0 && is_relation(s);
        groups += change_of_groups(s), brackets += change_of_brackets(s);
        *to++ = *s;
    }
    return to;
}

/* Whether a row ends outside of all groups, and another one follows. */
static int has_rows(const cagd_token *t)
{
    for (int depth = 0; t->kind != CAGD_TOKEN_END; t++) {
        depth += change_of_groups(t);
        if (depth == 0 && is_word(t, "\\\\") && t[1].kind != CAGD_TOKEN_END)
            return 1;
    }
    return 0;
}

/* Whether a word or an arrow stands in some row, of which it is not said that it reaches over all of them. */
static int has_connective(const cagd_token *t, const cagd_token *end)
{
    static const char *const words[] = {"\\text", "\\Rightarrow", "\\iff", "\\lor", "\\forall", "\\exists", "\\neg"};
    for (int depth = 0; t < end; depth += change_of_depth(t), t++)
        for (size_t k = 0; depth == 0 && k < sizeof words / sizeof *words; k++)
            if (is_word(t, words[k]))
                return 1;
    return 0;
}

/* What stands behind the rows is of all of them: where one has a word or an arrow of its own, their end is left there, and refused. */
static cagd_token *close_rows(cagd_token list[], cagd_token *to, const cagd_token *behind, const cagd_token *end,
                              int has_own)
{
    while (is_word(behind, ".") || is_word(behind, ","))
        behind++;
    if (behind->kind == CAGD_TOKEN_END)
        return to;
    if (has_own)
        *to++ = *end;
    for (cagd_token *t = list; t < to; t++)
        if (t->kind == CAGD_TOKEN_ROW)
            t->kind = CAGD_TOKEN_SIGN;
    return to;
}

void cagd_open_rows(cagd_token list[])
{
    static const char *const names[] = {"cases",     "dcases",   "rcases",   "array",    "aligned",
                                        "alignedat", "split",    "gathered", "equation", "align",
                                        "eqnarray",  "multline", "gather",   "flalign",  "alignat"};
    enum { OF_VALUES = 4 };
    char name[16] = "", columns[16];
    cagd_token *t = list;
    int brace = is_word(t, "\\{"), which = -1;
    t += brace;
    const cagd_token *first = is_word(t, "\\begin") ? behind_group(t + 1, name, sizeof name) : t;
    size_t n = strlen(name);
    name[n > 0 && name[n - 1] == '*' ? n - 1 : n] = '\0';
    for (int k = 0; k < (int)(sizeof names / sizeof *names); k++)
        which = strcmp(names[k], name) == 0 ? k : which;
    if (strcmp(name, "array") == 0 || strcmp(name, "alignedat") == 0 || strcmp(name, "alignat") == 0)
        first = behind_group(first, columns, sizeof columns);
    const cagd_token *end = which >= 0 ? end_of_rows(first) : NULL;
    if (end == NULL || end->kind == CAGD_TOKEN_END || ((which < OF_VALUES || brace) && !is_formula(first, end))) {
        for (end = list; end->kind != CAGD_TOKEN_END;)
            end++;
        if (has_rows(list))
            *put_rows(list, list, list, end, 0) = *end;
        return;
    }
    const int has_own = has_connective(first, end);
    const cagd_token last = *end;
    cagd_token *to = put_rows(list, list, first, end, 1);
    const cagd_token *behind = behind_group(end + 1, columns, sizeof columns);
    behind += !brace && is_word(behind, "\\}"); /* \left. ... \right\} */
    to = close_rows(list, to, behind, &last, has_own);
    while (behind->kind != CAGD_TOKEN_END)
        *to++ = *behind++;
    *to = *behind;
}

/* ---- rows that are read apart ---------------------------------------------------------------------------- */

/* Whether a break of a row stands right before the token. */
static int is_behind_break(const cagd_reader *r, const cagd_token *first, const cagd_token *t)
{
    for (int k = t > first ? t[-1].to : t->from; k + 1 < t->from; k++)
        if (r->text[k] == '\\' && r->text[k + 1] == '\\')
            return 1;
    return 0;
}

/* The first sign or word of the row at t that reaches beyond a relation: an arrow, "or", a quantifier, "for"; those that begin a row of their own, with
 * `alone`, or the others; NULL where there is none. */
static const cagd_token *reaching(const cagd_reader *r, const cagd_token *t, int alone)
{
    static const char *const words[] = {"\\lor", "\\Rightarrow", "\\Leftarrow", "\\iff", "\\forall", "\\exists"};
    const cagd_token *first = r->token;
    cagd_reader at = *r;
    for (at.token = t; at.token->kind != CAGD_TOKEN_END && at.token->kind != CAGD_TOKEN_ROW;) {
        const cagd_token *here = at.token;
        const char *said = cagd_read_words(&at);
        int is = said != NULL && strncmp(said, "and", 3) != 0 && strspn(said, " ,.;~") < strlen(said);
        for (size_t k = 0; k < sizeof words / sizeof *words; k++)
            is |= strcmp(here->word, words[k]) == 0;
        if (is && is_behind_break(r, first, here) == alone && (!alone || here > t))
            return here;
        at.token += said == NULL;
    }
    return NULL;
}

/* Whether a condition in brackets, or with \in, stands behind the beginning of the row at t. */
static int has_condition(const cagd_token *t)
{
    const cagd_token *first = t;
    for (int groups = 0; t->kind != CAGD_TOKEN_END && t->kind != CAGD_TOKEN_ROW; groups += change_of_groups(t), t++)
        if (groups == 0 && t > first && (is_word(t, "\\in") || is_word(t, "\\notin") || is_condition(t)))
            return 1;
    return 0;
}

static const cagd_token *end_of_row(const cagd_token *t)
{
    while (t->kind != CAGD_TOKEN_END && t->kind != CAGD_TOKEN_ROW)
        t++;
    return t;
}

/* The row from t to `end`, to be read as if it stood alone. */
static int open_row(const cagd_reader *r, const cagd_token *t, const cagd_token *end, cagd_reader *row)
{
    cagd_token *own = cagd_region_array((int)(end - t) + CAGD_TOKENS_AHEAD, 1, sizeof *own);
    if (own == NULL)
        return 0;
    memcpy(own, t, (size_t)(end - t) * sizeof *own);
    for (int k = 0; k < CAGD_TOKENS_AHEAD; k++)
        own[end - t + k] = (cagd_token){CAGD_TOKEN_END, "", end->from, end->to};
    *row = *r;
    row->token = own;
    return 1;
}

int cagd_are_read_apart(const cagd_reader *r)
{
    const cagd_token *t = r->token, *end = end_of_row(t);
    cagd_reader row;
    int is = 0;
    for (; end->kind == CAGD_TOKEN_ROW || (t != r->token && t->kind != CAGD_TOKEN_END); t = end, end = end_of_row(t)) {
        is |= reaching(r, t, 0) != NULL || has_condition(t) || (open_row(r, t, end, &row) && cagd_row_has_range(&row));
        end += end->kind == CAGD_TOKEN_ROW;
    }
    return is;
}

const cagd_tree *cagd_read_rows_apart(cagd_reader *r)
{
    const cagd_tree *list[CAGD_MOST_CHILDREN];
    const cagd_token *t = r->token, *unclear;
    int count = 0, from = t->from;
    for (const cagd_token *end; t != NULL; t = end->kind == CAGD_TOKEN_ROW ? end + 1 : NULL) {
        end = end_of_row(t);
        unclear = reaching(r, t, 1);
        if (end->kind == CAGD_TOKEN_ROW && (strcmp(t->word, "\\forall") == 0 || strcmp(t->word, "\\exists") == 0))
            unclear = t;
        if (unclear != NULL) {
            r->token = unclear;
            return cagd_refuse_token(
                r, "does this reach over its own row, or over others, too? write a statement for each");
        }
        cagd_reader row;
        if (!open_row(r, t, end, &row))
            return cagd_refuse_token(r, "there is no memory for the formula");
        const cagd_tree *said = reaching(r, t, 0) != NULL ? cagd_read_for_all_numbers(&row) : cagd_read_row(&row);
        if (said == NULL || !cagd_at_the_end(&row))
            return NULL;
        r->nodes = row.nodes;
        const cagd_tree *const *parts = said->kind == CAGD_ALL ? said->at : &said;
        int several = said->kind == CAGD_ALL ? said->count : 1;
        if (count + several > CAGD_MOST_CHILDREN)
            return cagd_refuse_token(r, "more than %d conditions", CAGD_MOST_CHILDREN);
        for (int k = 0; k < several; k++)
            list[count++] = parts[k];
    }
    while (r->token->kind != CAGD_TOKEN_END)
        r->token++;
    cagd_tree *all = count > 1 ? (cagd_tree *)cagd_new_of(r, CAGD_ALL, from, count, list) : NULL;
    if (all != NULL)
        all->asked = ~1ull;
    return count == 1 ? list[0] : all;
}
