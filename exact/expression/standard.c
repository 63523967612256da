#include "exact/expression/standard.h"

#include "exact/number/memory.h"
#include "exact/words.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum { MOST_LETTERS = 4, MOST_SOURCES = 2, LONGEST = 80, LARGEST = 4096 };

/* In the lines #1, #2, ... are the letters of the name, @ is the name with them, @{a}{b}{c} with others, $1{a} and $2{a} are the
 * points, weights or knots, and % is a letter that occurs nowhere else. */
struct standard {
    const char *name, *example;
    int indices, arguments; /* of the name                                   */
    const char *word[MOST_SOURCES];
    int knots; /* which of the words has them, from 1; 0: none     */
    const char *lines;
};

static const struct standard standards[] = {
    {"bernstein", "B_i^n(t)", 2, 1, {0}, 0, "@ = \\binom{#2}{#1} #3^{#1} (1-#3)^{#2-#1}\n"},
    {"bspline",
     "N_i^p(t) over u_i",
     2,
     1,
     {"over"},
     1,
     "@{#1}{0}{#3} = \\begin{cases} 1 & $1{#1} \\le #3 < $1{#1+1} \\\\ 0 & \\text{otherwise} \\end{cases}\n"
     "@ = \\begin{cases} \\frac{#3-$1{#1}}{$1{#1+#2}-$1{#1}} @{#1}{#2-1}{#3} & $1{#1} < $1{#1+#2} \\\\ 0 & "
     "\\text{otherwise} \\end{cases} + "
     "\\begin{cases} \\frac{$1{#1+#2+1}-#3}{$1{#1+#2+1}-$1{#1+1}} @{#1+1}{#2-1}{#3} & $1{#1+1} < $1{#1+#2+1} \\\\ 0 & "
     "\\text{otherwise} \\end{cases}\n"},
    {"bspline-order",
     "N_i^k(t) over u_i",
     2,
     1,
     {"over"},
     1,
     "@{#1}{1}{#3} = \\begin{cases} 1 & $1{#1} \\le #3 < $1{#1+1} \\\\ 0 & \\text{otherwise} \\end{cases}\n"
     "@ = \\begin{cases} \\frac{#3-$1{#1}}{$1{#1+#2-1}-$1{#1}} @{#1}{#2-1}{#3} & $1{#1} < $1{#1+#2-1} \\\\ 0 & "
     "\\text{otherwise} \\end{cases} + "
     "\\begin{cases} \\frac{$1{#1+#2}-#3}{$1{#1+#2}-$1{#1+1}} @{#1+1}{#2-1}{#3} & $1{#1+1} < $1{#1+#2} \\\\ 0 & "
     "\\text{otherwise} \\end{cases}\n"},
    {"de-casteljau",
     "P_i^r(t) of P_i",
     2,
     1,
     {"of"},
     0,
     "@{#1}{0}{#3} = $1{#1}\n"
     "@ = (1-#3) @{#1}{#2-1}{#3} + #3 @{#1+1}{#2-1}{#3}\n"},
    {"de-boor",
     "d_i^{p,r}(t) of d_i over u_i",
     3,
     1,
     {"of", "over"},
     2,
     "@{#1}{#2}{0}{#4} = $1{#1}\n"
     "@ = \\frac{$2{#1+#2+1-#3}-#4}{$2{#1+#2+1-#3}-$2{#1}} @{#1-1}{#2}{#3-1}{#4} + "
     "\\frac{#4-$2{#1}}{$2{#1+#2+1-#3}-$2{#1}} @{#1}{#2}{#3-1}{#4}\n"},
    {"bezier", "P^n(t) of P_i", 1, 1, {"of"}, 0, "@ = \\sum_{%=0}^{#1} \\binom{#1}{%} #2^{%} (1-#2)^{#1-%} $1{%}\n"},
    {"rational-bezier",
     "R^n(t) of P_i with \\omega_i",
     1,
     1,
     {"of", "with"},
     0,
     "@ = \\frac{\\sum_{%=0}^{#1} \\binom{#1}{%} #2^{%} (1-#2)^{#1-%} $2{%} $1{%}}"
     "{\\sum_{%=0}^{#1} \\binom{#1}{%} #2^{%} (1-#2)^{#1-%} $2{%}}\n"},
    {"cubic-hermite",
     "H_i(t)",
     1,
     1,
     {0},
     0,
     "@{0}{#2} = (1-#2)^2 (1+2#2)\n@{1}{#2} = #2^2 (3-2#2)\n@{2}{#2} = #2 (1-#2)^2\n@{3}{#2} = -#2^2 (1-#2)\n"},
    {"kronecker", "\\delta_{ij}", 2, 0, {0}, 0, "@{#1}{#1} = 1\n@ = 0\n"},
};
enum { STANDARDS = sizeof standards / sizeof *standards };

/* A piece of the line. */
struct piece {
    const char *at;
    int length;
};

/* B_i^{[n]}(t): the head, and its letters; each after the group in which it stands: '_', '^', '[' for brackets above, or '('. */
struct shape {
    struct piece head, letter[2 * MOST_LETTERS];
    char group[2 * MOST_LETTERS];
    int count;
};

static void *refuse(char message[CAGD_STANDARD_MESSAGE], const char *format, ...) __attribute__((format(printf, 2, 3)));
static void *refuse(char message[CAGD_STANDARD_MESSAGE], const char *format, ...)
{
    va_list list;
    va_start(list, format);
    vsnprintf(message, CAGD_STANDARD_MESSAGE, format, list);
    va_end(list);
    return NULL;
}

static struct piece stripped(struct piece p)
{
    while (p.length > 0 && isspace((unsigned char)*p.at))
        p.at++, p.length--;
    while (p.length > 0 && isspace((unsigned char)p.at[p.length - 1]))
        p.length--;
    return p;
}

/* The end of the group that begins at k: of a bracket, a command, or a character. */
static int end_of_group(struct piece p, int k)
{
    int depth = 0, from = k;
    if (p.at[k] == '\\') {
        for (k++; k < p.length && isalpha((unsigned char)p.at[k]); k++)
            ;
        return k > from + 1 ? k : k + 1;
    }
    for (; k < p.length; k++) {
        depth += (strchr("({[", p.at[k]) != NULL) - (strchr(")}]", p.at[k]) != NULL);
        if (depth <= 0)
            return k + 1;
    }
    return -1;
}

/* The letters of a group, with commas between. */
static int add_letters(struct shape *s, char group, struct piece inside)
{
    inside = stripped(inside);
    if (group == '^' && inside.length > 2 && inside.at[0] == '[' && inside.at[inside.length - 1] == ']')
        inside = (struct piece){inside.at + 1, inside.length - 2}, group = '[';
    for (int from = 0, k = 0; k <= inside.length; k++)
        if (k == inside.length || inside.at[k] == ',') {
            struct piece one = stripped((struct piece){inside.at + from, k - from});
            if (one.length == 0 || one.length > LONGEST || s->count == MOST_LETTERS)
                return 0;
            s->group[s->count] = group, s->letter[s->count++] = one;
            from = k + 1;
        }
    return 1;
}

/* The parts of a name; 0 where it is none. */
static int shape_of(struct piece p, struct shape *s)
{
    int k = 0;
    *s = (struct shape){0};
    p = stripped(p);
    while (k < p.length && strchr("_^(", p.at[k]) == NULL) {
        int end = end_of_group(p, k);
        if (end < 0 || end > p.length)
            return 0;
        k = end;
    }
    s->head = stripped((struct piece){p.at, k});
    while (k < p.length) {
        char group = p.at[k];
        int from = group == '(' ? k : k + 1;
        while (from < p.length && p.at[from] == ' ')
            from++;
        int end = from < p.length && strchr("_^(", group) != NULL ? end_of_group(p, from) : -1;
        int bracket = end > 0 && (p.at[from] == '{' || p.at[from] == '(');
        if (end < 0 || end > p.length ||
            !add_letters(s, group, (struct piece){p.at + from + bracket, end - from - 2 * bracket}))
            return 0;
        for (k = end; k < p.length && p.at[k] == ' '; k++)
            ;
    }
    return s->head.length > 0 && s->head.length <= LONGEST;
}

/* Two letters side by side, \delta_{ij}, where two are wanted. */
static void part_letters(struct shape *s, const struct standard *of)
{
    if (s->count != 1 || of->indices != 2 || of->arguments != 0 || s->letter[0].length != 2)
        return;
    s->group[1] = s->group[0], s->count = 2;
    s->letter[1] = (struct piece){s->letter[0].at + 1, 1}, s->letter[0].length = 1;
}

/* Below before above before in brackets, where they stand above and then below. */
static void sort_by_place(struct shape *s)
{
    for (int k = 1; k < s->count; k++)
        for (int m = k; m > 0 && s->group[m] == '_' && s->group[m - 1] != '_'; m--) {
            struct piece letter = s->letter[m];
            char group = s->group[m];
            s->letter[m] = s->letter[m - 1], s->group[m] = s->group[m - 1];
            s->letter[m - 1] = letter, s->group[m - 1] = group;
        }
}

/* Text that grows up to LARGEST. */
struct text {
    char *at;
    int length;
};
static void put(struct text *t, const char *s, int n)
{
    if (t->length + n < LARGEST)
        memcpy(t->at + t->length, s, (size_t)n), t->length += n;
    t->at[t->length] = '\0';
}
static void put_piece(struct text *t, struct piece p) { put(t, p.at, p.length); }

/* The name with these in the places of its letters. */
static void put_name(struct text *t, const struct shape *s, const struct piece value[])
{
    put_piece(t, s->head);
    for (int k = 0; k < s->count; k++) {
        char group = s->group[k];
        int first = k == 0 || s->group[k - 1] != group, last = k + 1 == s->count || s->group[k + 1] != group;
        put(t,
            !first         ? ","
            : group == '_' ? "_{"
            : group == '^' ? "^{"
            : group == '[' ? "^{["
                           : "(",
            first && group == '['   ? 3
            : first && group != '(' ? 2
                                    : 1);
        put_piece(t, value[k]);
        if (last)
            put(t, group == '[' ? "]}" : group == '(' ? ")" : "}", group == '[' ? 2 : 1);
    }
}

/* A letter that is none of those. */
static struct piece another_letter(const struct shape *s)
{
    static const char letters[] = "jklm";
    for (int k = 0; letters[k] != '\0'; k++) {
        int taken = 0;
        for (int m = 0; m < s->count; m++)
            taken |= s->letter[m].length == 1 && *s->letter[m].at == letters[k];
        if (!taken)
            return (struct piece){letters + k, 1};
    }
    return (struct piece){letters, 1};
}

/* Lines with what stands for the marks in them. */
static void put_lines(struct text *t, const char *lines, const struct shape *name, const struct shape source[],
                      struct piece letter)
{
    for (const char *c = lines; *c != '\0'; c++) {
        if (*c == '#') {
            put_piece(t, name->letter[*++c - '1']);
        } else if (*c == '%') {
            put_piece(t, letter);
        } else if (*c == '@' && c[1] != '{') {
            put_name(t, name, name->letter);
        } else if (*c == '@' || *c == '$') {
            const struct shape *of = *c == '@' ? name : &source[*++c - '1'];
            struct text inner[MOST_LETTERS];
            struct piece value[MOST_LETTERS];
            char room[MOST_LETTERS][LARGEST], marks[LONGEST];
            for (int k = 0; k < of->count; k++) {
                size_t n = strcspn(++c + 1, "}");
                snprintf(marks, sizeof marks, "%.*s", (int)n, c + 1);
                inner[k] = (struct text){room[k], 0};
                put_lines(&inner[k], marks, name, source, letter);
                value[k] = (struct piece){room[k], inner[k].length};
                c += n + 1;
            }
            put_name(t, of, value);
        } else {
            put(t, c, 1);
        }
    }
}

/* Where the word stands by itself, from `from` on; -1 where it does not. */
static int find_word(struct piece p, const char *word, int from)
{
    int n = (int)strlen(word);
    for (int k = from; k + n < p.length; k++)
        if (k > 0 && p.at[k - 1] == ' ' && memcmp(p.at + k, word, (size_t)n) == 0 && p.at[k + n] == ' ')
            return k;
    return -1;
}

static const struct standard *standard_named(struct piece word)
{
    for (int k = 0; k < STANDARDS; k++)
        if ((int)strlen(standards[k].name) == word.length &&
            memcmp(standards[k].name, word.at, (size_t)word.length) == 0)
            return &standards[k];
    return NULL;
}

/* Whether anything with that head was said: "u_" where it has an index. */
static int is_known(const cagd_scope *scope, const struct shape *s)
{
    char head[LONGEST + 2];
    snprintf(head, sizeof head, "%.*s_", s->head.length, s->head.at);
    return cagd_declared(scope, head) != NULL || cagd_defined(scope, head) != NULL;
}

const char *cagd_standard(const cagd_scope *scope, const char *line, int length, char message[CAGD_STANDARD_MESSAGE])
{
    struct piece all = stripped((struct piece){line, length});
    int end = 0;
    while (end < all.length && !isspace((unsigned char)all.at[end]))
        end++;
    const struct standard *s = standard_named((struct piece){all.at, end});
    if (s == NULL) {
        struct text names = {region_bytes(LARGEST), 0};
        for (int k = 0; names.at != NULL && k < STANDARDS; k++)
            put(&names, standards[k].name, (int)strlen(standards[k].name)),
                put(&names, ", ", k + 1 < STANDARDS ? 2 : 0);
        return refuse(message, "no function has the name '%.*s'; there are %s", end < 30 ? end : 30, all.at,
                      names.at != NULL ? names.at : "");
    }
    struct piece rest = {all.at + end, all.length - end};
    struct shape name, source[MOST_SOURCES] = {0};
    int at[MOST_SOURCES + 1], sources = 0, good = 1;
    for (int from = 0; sources < MOST_SOURCES && s->word[sources] != NULL && good; sources++) {
        at[sources] = from = find_word(rest, s->word[sources], from);
        good = from >= 0;
    }
    if (good) {
        at[sources] = rest.length;
        good = shape_of((struct piece){rest.at, at[0]}, &name);
        part_letters(&name, s);
    }
    for (int k = 0; k < sources && good; k++) {
        int begin = at[k] + (int)strlen(s->word[k]);
        good = shape_of((struct piece){rest.at + begin, at[k + 1] - begin}, &source[k]) && source[k].count == 1 &&
               source[k].group[0] == '_';
    }
    int arguments = 0;
    for (int k = 0; good && k < name.count; k++)
        arguments += name.group[k] == '(';
    if (!good || arguments != s->arguments || name.count != s->indices + s->arguments)
        return refuse(message, "expected it as in '%s %s'", s->name, s->example);
    for (int k = 0; k < name.count; k++)
        for (int m = 0; m < k; m++)
            if (name.letter[m].length == name.letter[k].length &&
                memcmp(name.letter[m].at, name.letter[k].at, (size_t)name.letter[k].length) == 0)
                return refuse(message, "the letter %.*s stands there twice", name.letter[k].length, name.letter[k].at);
    sort_by_place(&name);
    struct text out = {region_bytes(LARGEST), 0};
    if (out.at == NULL)
        return refuse(message, "there is no memory for it");
    if (s->knots > 0 && !is_known(scope, &source[s->knots - 1]))
        put_lines(&out,
                  s->knots == 1 ? "$1{i} \\in \\mathbb{R}\n$1{i} \\le $1{i+1}\n"
                                : "$2{i} \\in \\mathbb{R}\n$2{i} \\le $2{i+1}\n",
                  &name, source, name.head);
    put_lines(&out, s->lines, &name, source, another_letter(&name));
    return out.at;
}
