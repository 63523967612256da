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

/* Whether the row at t goes on with the formula before it. */
static int goes_on(const cagd_token *t, const cagd_token *stop, const cagd_token *first)
{
    static const char *const signs[] = {"+",     "-", "*",     "\\times", "/", "\\text", "\\Rightarrow",
                                        "\\iff", ",", "\\dots"};
    int is_behind_sign = is_word(t, "&");
    if (is_behind_sign && !is_word(first, "&")) /* at the place of the relation */
        return 1;
    t += is_behind_sign;
    for (size_t k = 0; k < sizeof signs / sizeof *signs; k++)
        if (is_word(t, signs[k]))
            return 1;
    return is_relation(t) || !is_formula(t, stop);
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

void cagd_open_rows(cagd_token list[])
{
    static const char *const names[] = {"cases",   "dcases",    "rcases", "array",
                                        "aligned", "alignedat", "split",  "gathered"};
    enum { OF_VALUES = 4 };
    char name[16] = "", columns[16];
    cagd_token *t = list, *to = list;
    int brace = is_word(t, "\\{"), which = -1, groups = 0, brackets = 0;
    t += brace;
    if (!is_word(t, "\\begin"))
        return;
    const cagd_token *first = behind_group(t + 1, name, sizeof name);
    for (int k = 0; k < (int)(sizeof names / sizeof *names); k++)
        which = strcmp(names[k], name) == 0 ? k : which;
    int is_array = which >= 0 && strcmp(name, "array") == 0;
    if (which < 0 || (is_array && !brace))
        return;
    if (is_array || strcmp(name, "alignedat") == 0)
        first = behind_group(first, columns, sizeof columns);
    const cagd_token *end = end_of_rows(first);
    if (end->kind == CAGD_TOKEN_END || (which < OF_VALUES && !is_formula(first, end)))
        return;
    for (const cagd_token *s = first; s < end; s++) {
        int is_break = groups == 0 && is_word(s, "\\\\");
        if (is_break && brackets == 0 && s + 1 < end && to > list && !ends_open(to - 1) && !goes_on(s + 1, end, first))
            *to++ = (cagd_token){CAGD_TOKEN_SIGN, ",", s->from, s->to};
        if (is_break && brackets == 0 && to > list && is_word(to - 1, ";"))
            to[-1].word = ",";
        if (is_break || (groups == 0 && is_word(s, "&")))
            continue;
        groups += change_of_groups(s), brackets += change_of_brackets(s);
        *to++ = *s;
    }
    const cagd_token *behind = behind_group(end + 1, columns, sizeof columns);
    while (behind->kind != CAGD_TOKEN_END)
        *to++ = *behind++;
    *to = *behind;
}
