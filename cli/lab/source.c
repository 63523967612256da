/* source.c -- the text of an answer in C before it is compiled; see lab.h.
 *
 * What is looked at has to be what is compiled, in every build. So the text is expanded once, with the headers of standard C and no other
 * file, and what comes out is what all later steps read: no macro tells one build from another. That an answer cannot pretend to
 * be a header of the system rests on its directives: none of them but those of the list below, so that the line markers are the compiler's. */
#include "cli/lab/lab.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

/* ---- directives ------------------------------------------------------------------------------------------- */

/* The text as the compiler's first phases leave it: no line is continued; `line` tells where each character stands. */
struct logical {
    char *text;
    long *line;
    size_t length;
};

/* How long "\", blanks and the end of a line are at this place; 0: that does not stand here. */
static size_t continued(const char *at)
{
    if (*at != '\\')
        return 0;
    size_t blanks = 1 + strspn(at + 1, " \t\v\f");
    if (at[blanks] == '\r' && at[blanks + 1] == '\n')
        return blanks + 2;
    return at[blanks] == '\n' || at[blanks] == '\r' ? blanks + 1 : 0;
}

static struct logical logical_of(const char *source)
{
    size_t room = strlen(source) + 1;
    struct logical s = {malloc(room), malloc(room * sizeof(long)), 0};
    long line = 1;
    if (s.text == NULL || s.line == NULL)
        abort();
    for (const char *at = source; *at != 0;) {
        size_t skipped = continued(at);
        if (skipped > 0) {
            line++;
            at += skipped;
            continue;
        }
        s.line[s.length] = line;
        s.text[s.length++] = *at == '\r' ? '\n' : *at;
        line += *at == '\n';
        at++;
    }
    s.text[s.length] = 0;
    s.line[s.length] = line;
    return s;
}

static int is_in(const char *const *list, const char *word, size_t length)
{
    for (; *list != NULL; list++)
        if (strlen(*list) == length && strncmp(*list, word, length) == 0)
            return 1;
    return 0;
}

static size_t word_at(const char *at)
{
    size_t length = 0;
    while (isalnum((unsigned char)at[length]) || at[length] == '_' || at[length] == '$')
        length++;
    return length;
}

/* Behind blanks and comments of the same line; NULL when a comment does not end there. */
static const char *behind_blanks(const char *at)
{
    for (;;) {
        at += strspn(at, " \t\v\f");
        if (strncmp(at, "/*", 2) != 0)
            return at;
        const char *end = strstr(at + 2, "*/");
        if (end == NULL || memchr(at, '\n', (size_t)(end - at)) != NULL)
            return NULL;
        at = end + 2;
    }
}

/* What is wrong with the directive that begins behind its "#"; NULL: nothing. */
static const char *wrong_directive(const char *at)
{
    static const char *const directives[] = {"include", "define", "undef", "if",    "ifdef",  "ifndef",
                                             "elif",    "else",   "endif", "error", "pragma", NULL};
    static const char *const headers[] = {
        "assert.h", "complex.h",     "ctype.h",    "errno.h",  "fenv.h",    "float.h",  "inttypes.h", "iso646.h",
        "limits.h", "math.h",        "stdalign.h", "stdarg.h", "stdbool.h", "stddef.h", "stdint.h",   "stdio.h",
        "stdlib.h", "stdnoreturn.h", "string.h",   "tgmath.h", "time.h",    NULL};
    static const char comment[] = "a comment that begins in a line with # has to end in it";
    const char *end = at + strcspn(at, "\n");
    for (const char *open = at; (open = strstr(open, "/*")) != NULL && open < end;) {
        const char *close = strstr(open + 2, "*/");
        if (close == NULL || close > end)
            return comment;
        open = close + 2;
    }
    if (memmem(at, (size_t)(end - at), "__has_", 6) != NULL)
        return "what is there, and what the compiler can do, is not asked in an assignment";
    const char *word = behind_blanks(at);
    if (word == NULL)
        return comment;
    size_t length = word_at(word);
    if (length == 0 && (*word == '\n' || *word == 0))
        return NULL;
    if (length == 0 || !is_in(directives, word, length))
        return "a directive that is no part of an assignment";
    const char *rest = behind_blanks(word + length);
    if (rest == NULL)
        return comment;
    if (length == 6 && strncmp(word, "pragma", 6) == 0 && strncmp(rest, "STDC ", 5) != 0)
        return "a pragma is no part of an assignment";
    if (length == 7 && strncmp(word, "include", 7) == 0 &&
        (*rest != '<' || !is_in(headers, rest + 1, strcspn(rest + 1, ">\n"))))
        return "only the headers of standard C are included in an assignment";
    return NULL;
}

/* Behind a text or a character in quotes, which ends with its line at the latest. */
static const char *behind_quotes(const char *at)
{
    char quote = *at++;
    while (*at != 0 && *at != quote && *at != '\n')
        at += *at == '\\' && at[1] != 0 && at[1] != '\n' ? 2 : 1;
    return at + (*at == quote);
}

/* What is wrong with a directive of the text, with its line; NULL: nothing. */
static const char *wrong_in(const struct logical *s, long *line)
{
    int first = 1; /* nothing but blanks stood in this line; what is no ASCII may be a blank */
    for (const char *at = s->text; *at != 0;) {
        if (first && (*at == '#' || strncmp(at, "%:", 2) == 0)) {
            const char *wrong = wrong_directive(at + (*at == '#' ? 1 : 2));
            *line = s->line[at - s->text];
            if (wrong != NULL)
                return wrong;
            at += strcspn(at, "\n");
        } else if (strncmp(at, "//", 2) == 0) {
            at += strcspn(at, "\n");
        } else if (strncmp(at, "/*", 2) == 0) {
            const char *end = strstr(at + 2, "*/");
            for (const char *k = at; k < end; k++)
                first |= *k == '\n';
            at = end != NULL ? end + 2 : at + strlen(at);
        } else if (*at == '"' || *at == '\'') {
            at = behind_quotes(at);
            first = 0;
        } else {
            first = *at == '\n' || (first && (isspace((unsigned char)*at) || (unsigned char)*at >= 0x80));
            at++;
        }
    }
    return NULL;
}

/* ---- the expanded text -------------------------------------------------------------------------------------- */

/* Reserved names that the macros of the standard headers, or plain C, bring with them. */
static int is_plain(const char *word, size_t length)
{
    static const char *const names[] = {"__func__",
                                        "__FUNCTION__",
                                        "__PRETTY_FUNCTION__",
                                        "__extension__",
                                        "__restrict",
                                        "__restrict__",
                                        "__inline",
                                        "__inline__",
                                        "__const",
                                        "__const__",
                                        "__volatile__",
                                        "__typeof__",
                                        "__typeof",
                                        "__alignof__",
                                        "__signed__",
                                        "__complex__",
                                        "__real__",
                                        "__imag__",
                                        "__assert_fail",
                                        "__isnan",
                                        "__isnanf",
                                        "__isinf",
                                        "__isinff",
                                        "__finite",
                                        "__finitef",
                                        "__signbit",
                                        "__signbitf",
                                        "__fpclassify",
                                        "__fpclassifyf",
                                        "__errno_location",
                                        "__ctype_b_loc",
                                        NULL};
    static const char *const builtins[] = {
        "huge_val",    "huge_valf",   "huge_vall",     "inf",         "inff",
        "infl",        "nan",         "nanf",          "nanl",        "isnan",
        "isinf",       "isinf_sign",  "isfinite",      "isnormal",    "fpclassify",
        "signbit",     "signbitf",    "signbitl",      "isgreater",   "isgreaterequal",
        "isless",      "islessequal", "islessgreater", "isunordered", "offsetof",
        "va_start",    "va_end",      "va_arg",        "va_copy",     "va_list",
        "expect",      "constant_p",  "complex",       "alloca",      "types_compatible_p",
        "choose_expr", NULL};
    if (length > 10 && strncmp(word, "__builtin_", 10) == 0)
        return is_in(builtins, word + 10, length - 10);
    return is_in(names, word, length);
}

/* What is wrong with the words of a line, up to `end`. */
static int wrong_words(const char *at, const char *end, char text[LAB_CAUSE])
{
    while (at < end) {
        if (*at == '"' || *at == '\'') {
            at = behind_quotes(at);
            continue;
        }
        size_t length = word_at(at);
        int asm_word = length == 3 && strncmp(at, "asm", 3) == 0;
        if (asm_word || (length > 5 && strncmp(at, "__asm", 5) == 0))
            return snprintf(text, LAB_CAUSE, "assembly is no part of an assignment");
        if (length > 10 && strncmp(at, "__attribute", 11) == 0)
            return snprintf(text, LAB_CAUSE, "an attribute is no part of an assignment");
        if (length > 2 && strncmp(at, "__", 2) == 0 && !is_plain(at, length))
            return snprintf(text, LAB_CAUSE, "%.*s is no part of an assignment", (int)(length < 60 ? length : 60), at);
        at += length > 0 ? length : 1;
    }
    return 0;
}

/* Where a line marker, "# 12 "name" ...", says that the next line stands: whether in the answer. */
static int is_of_answer(const struct lab *lab, const char *marker, long *line)
{
    char *end;
    *line = strtol(marker + 2, &end, 10);
    size_t length = strlen(lab->file);
    return strncmp(end, " \"", 2) == 0 && strncmp(end + 2, lab->file, length) == 0 && end[2 + length] == '"';
}

/* Whether something of the answer's lines is wrong, with its cause. */
static int wrong_expansion(const struct lab *lab, const char *expanded, char cause[LAB_CAUSE])
{
    char text[LAB_CAUSE] = "";
    long line = 0;
    int ours = 0;
    for (const char *row = expanded; *row != 0;) {
        const char *end = row + strcspn(row, "\n"), *first = row + strspn(row, " \t\v\f");
        if (row[0] == '#' && row[1] == ' ' && isdigit((unsigned char)row[2])) {
            ours = is_of_answer(lab, row, &line);
            line--;
        } else if (ours && (*first == '#' || strncmp(first, "%:", 2) == 0)) {
            if (strncmp(row, "#pragma STDC ", 13) != 0)
                snprintf(text, sizeof text, "a pragma, or what becomes a directive, is no part of an assignment");
        } else if (ours) {
            wrong_words(row, end, text);
        }
        if (text[0] != 0) {
            snprintf(cause, LAB_CAUSE, "line %ld: %.500s", line, text);
            return 1;
        }
        line++;
        row = end + (*end == '\n');
    }
    return 0;
}

char *lab_wrong_directive(const char *source)
{
    struct logical s = logical_of(source);
    long line = 0;
    const char *wrong = wrong_in(&s, &line);
    char *cause = NULL;
    if (wrong != NULL && asprintf(&cause, "line %ld: %s", line, wrong) < 0)
        abort();
    free(s.text);
    free(s.line);
    return cause;
}

char *lab_wrong_expansion(const struct lab *lab, const char *expanded)
{
    char cause[LAB_CAUSE];
    return wrong_expansion(lab, expanded, cause) ? strdup(cause) : NULL;
}
