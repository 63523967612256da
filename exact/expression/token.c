#include "exact/expression/token.h"

#include "exact/words.h"

#include <ctype.h>
#include <string.h>

/* What is written in several ways, and its one word; "" where it is no token. */
/* clang-format off */
static const struct {
    const char *written, *word;
} same[] = {
    {"\\leq", "\\le"}, {"\\geq", "\\ge"}, {"\\neq", "\\ne"}, {"\\leqslant", "\\le"}, {"\\geqslant", "\\ge"},
    {"\\lt", "<"}, {"\\gt", ">"}, {"\\equiv", "="}, {"\\ldots", "\\dots"}, {"\\cdots", "\\dots"}, {"\\dotsc", "\\dots"},
    {"\\dotsb", "\\dots"}, {"\\dfrac", "\\frac"}, {"\\tfrac", "\\frac"}, {"\\dbinom", "\\binom"}, {"\\tbinom", "\\binom"},
    {"\\cdot", "*"}, {"\\ast", "*"}, {"\\star", "*"}, {"\\lVert", "\\|"}, {"\\rVert", "\\|"}, {"\\Vert", "\\|"}, {"\\lvert", "|"}, {"\\rvert", "|"}, {"\\vert", "|"},
    {"\\varepsilon", "\\epsilon"}, {"\\widehat", "\\hat"}, {"\\widetilde", "\\tilde"}, {"\\overline", "\\bar"},
    {"\\colon", ":"}, {"\\lbrace", "\\{"}, {"\\rbrace", "\\}"}, {"\\lbrack", "["}, {"\\rbrack", "]"}, {"\\wedge", "\\land"},
    {"\\left", ""}, {"\\right", ""}, {"\\big", ""}, {"\\Big", ""}, {"\\bigg", ""}, {"\\Bigg", ""}, {"\\bigl", ""},
    {"\\bigr", ""}, {"\\Bigl", ""}, {"\\Bigr", ""}, {"\\biggl", ""}, {"\\biggr", ""}, {"\\Biggl", ""}, {"\\Biggr", ""},
    {"\\middle", ""}, {"\\displaystyle", ""}, {"\\textstyle", ""}, {"\\limits", ""}, {"\\nolimits", ""}, {"\\quad", ""},
    {"\\qquad", ""}, {"\\nonumber", ""}, {"\\notag", ""},
    {"\\,", ""}, {"\\;", ""}, {"\\:", ""}, {"\\!", ""}, {"\\ ", ""}, {"\\>", ""}, {"~", ""},
    {"−", "-"}, {"·", "*"}, {"×", "\\times"}, {"≤", "\\le"}, {"≥", "\\ge"}, {"≠", "\\ne"}, {"≡", "="}, {"…", "\\dots"},
    {"∑", "\\sum"}, {"∏", "\\prod"}, {"′", "'"}, {"∞", "\\infty"}, {"∈", "\\in"}, {"ℝ", "\\R"}, {"⇒", "\\Rightarrow"},
    {"\\implies", "\\Rightarrow"}, {"\\Longrightarrow", "\\Rightarrow"}, {"\\impliedby", "\\Leftarrow"},
    {"\\Longleftarrow", "\\Leftarrow"}, {"⇐", "\\Leftarrow"}, {"\\Leftrightarrow", "\\iff"},
    {"\\Longleftrightarrow", "\\iff"}, {"⇔", "\\iff"}, {"\\vee", "\\lor"}, {"∨", "\\lor"}, {"∧", "\\land"},
    {"\\lnot", "\\neg"}, {"¬", "\\neg"}, {"∀", "\\forall"}, {"∃", "\\exists"}};

static const struct {
    const char *command, *letter;
} greek[] = {
    {"\\alpha", "α"}, {"\\beta", "β"}, {"\\gamma", "γ"}, {"\\delta", "δ"}, {"\\epsilon", "ε"}, {"\\zeta", "ζ"},
    {"\\eta", "η"}, {"\\theta", "θ"}, {"\\iota", "ι"}, {"\\kappa", "κ"}, {"\\lambda", "λ"}, {"\\mu", "μ"}, {"\\nu", "ν"},
    {"\\xi", "ξ"}, {"\\pi", "π"}, {"\\rho", "ρ"}, {"\\sigma", "σ"}, {"\\tau", "τ"}, {"\\upsilon", "υ"}, {"\\phi", "φ"},
    {"\\chi", "χ"}, {"\\psi", "ψ"}, {"\\omega", "ω"}, {"\\Gamma", "Γ"}, {"\\Delta", "Δ"}, {"\\Theta", "Θ"},
    {"\\Lambda", "Λ"}, {"\\Xi", "Ξ"}, {"\\Pi", "Π"}, {"\\Sigma", "Σ"}, {"\\Phi", "Φ"}, {"\\Psi", "Ψ"},
    {"\\Omega", "Ω"}, {"\\varphi", "ϕ"}, {"\\vartheta", "ϑ"}, {"\\ell", "ℓ"}};
/* clang-format on */

enum { SAME = sizeof same / sizeof *same, GREEK = sizeof greek / sizeof *greek };

int cagd_is_greek(const char *command)
{
    for (int k = 0; k < GREEK; k++)
        if (strcmp(greek[k].command, command) == 0)
            return 1;
    return 0;
}

enum { MOST_BARS = 16, FARTHEST_BAR = 4000 };

static int is(const char *s, int n, const char *word)
{
    int k = 0;
    while (k < n && word[k] != '\0' && word[k] == s[k])
        k++;
    return k == n && word[k] == '\0';
}

/* The bytes of the token at s, at most n: a command with its letters, or one character. */
static int length_at(const char *s, int n)
{
    if (s[0] == '\\') {
        int k = 1;
        while (k < n && isalpha((unsigned char)s[k]))
            k++;
        return k > 1 ? k : n > 1 ? 2 : 1;
    }
    int k = 1, most = (unsigned char)s[0] < 0x80 ? 1 : 4;
    while (k < n && k < most && ((unsigned char)s[k] & 0xC0) == 0x80)
        k++;
    return k;
}

static int digits_at(const char *s, int n)
{
    int k = 0;
    while (k < n && isdigit((unsigned char)s[k]))
        k++;
    if (k + 1 < n && s[k] == '.' && isdigit((unsigned char)s[k + 1]))
        for (k++; k < n && isdigit((unsigned char)s[k]); k++)
            ;
    return k;
}

/* Whether s[0..n) is in one of the tables, and what it is there.  A byte alone is in none, but for ~. */
static int is_known(const char *s, int n, cagd_token *t)
{
    for (int k = 0; k < SAME && (n > 1 || s[0] == '~'); k++)
        if (is(s, n, same[k].written)) {
            t->word = same[k].word;
            t->kind = t->word[0] == '\\' && isalpha((unsigned char)t->word[1]) ? CAGD_TOKEN_WORD : CAGD_TOKEN_SIGN;
            for (int g = 0; g < GREEK; g++)
                t->kind = strcmp(greek[g].command, t->word) == 0 ? CAGD_TOKEN_LETTER : t->kind;
            return 1;
        }
    for (int k = 0; k < GREEK && n > 1; k++)
        if (is(s, n, greek[k].command) || is(s, n, greek[k].letter)) {
            t->word = greek[k].command;
            t->kind = CAGD_TOKEN_LETTER;
            return 1;
        }
    return 0;
}

/* The token that s[0..n) is, n being its length; 0 where it is none that could stand in a formula. */
static int recognise(const char *s, int n, cagd_token *t)
{
    if (is_known(s, n, t))
        return 1;
    t->word = cagd_text_of(s, n);
    t->kind = s[0] == '\\' && isalpha((unsigned char)s[n - 1]) ? CAGD_TOKEN_WORD
              : isalpha((unsigned char)s[0])                   ? CAGD_TOKEN_LETTER
                                                               : CAGD_TOKEN_SIGN;
    if (t->word == NULL)
        return 0;
    return t->kind != CAGD_TOKEN_SIGN || (n == 1 && strchr("+-*/^_!,;:|=<>&'(){}[].", s[0]) != NULL) ||
           (n == 2 && strchr("\\{}|", s[1]) != NULL);
}

/* The bar of \left. ... \right|_{t=a}, whose \left. ends at `at`; -1 where it is another bracket, or far. */
static int bar_behind(const char *text, int at, int to)
{
    static const char *const left = "\\left", *const right = "\\right";
    int n = (int)strlen(left), m = (int)strlen(right), depth = 1;
    for (int stop = to - at > FARTHEST_BAR ? at + FARTHEST_BAR : to; at + m < stop; at++) {
        depth += memcmp(text + at, left, (size_t)n) == 0 && !isalpha((unsigned char)text[at + n]);
        if (memcmp(text + at, right, (size_t)m) != 0 || isalpha((unsigned char)text[at + m]) || --depth > 0)
            continue;
        for (at += m; at + 1 < stop && isspace((unsigned char)text[at]);)
            at++;
        int below = at + 1;
        while (below < stop && isspace((unsigned char)text[below]))
            below++;
        return at < stop && text[at] == '|' && below < stop && text[below] == '_' ? at : -1;
    }
    return -1;
}

cagd_token *cagd_tokens(const char *text, int from, int to, cagd_reading_error *error)
{
    int count = 0, room = (to - from < CAGD_MOST_TOKENS ? to - from : CAGD_MOST_TOKENS) + 1;
    cagd_token *list = cagd_region_array(room, 1, sizeof *list);
    int bar[MOST_BARS], bars = 0; /* that end what \left. begins */
    for (int at = from; list != NULL && at < to;) {
        const char *s = text + at;
        int n = to - at;
        if (isspace((unsigned char)s[0])) {
            at++;
            continue;
        }
        if (s[0] == '%') {
            while (at < to && text[at] != '\n')
                at++;
            continue;
        }
        cagd_token t = {.from = at};
        int digits = digits_at(s, n);
        if (digits > 0) {
            t.kind = CAGD_TOKEN_NUMBER, t.word = cagd_text_of(s, digits), t.to = at + digits;
            if (t.word == NULL)
                break;
        } else if (n > 1 && s[0] == '.' && s[1] == '.') {
            t.kind = CAGD_TOKEN_WORD, t.word = "\\dots", t.to = at + (n > 2 && s[2] == '.' ? 3 : 2);
        } else {
            int length = length_at(s, n);
            t.to = at + length;
            if (!recognise(s, length, &t)) {
                cagd_refuse_reading(error, at, t.to, "'%.*s' does not stand in a formula", length > 16 ? 16 : length,
                                    s);
                return NULL;
            }
        }
        at = t.to;
        if (at < to && text[at] == '.' && is(s, t.to - t.from, "\\right"))
            at++;
        if (at < to && text[at] == '.' && is(s, t.to - t.from, "\\left")) { /* a bracket that is none, or up to a bar */
            int end = bars < MOST_BARS ? bar_behind(text, at + 1, to) : -1;
            at++;
            if (end >= 0) {
                bar[bars++] = end;
                t.kind = CAGD_TOKEN_SIGN, t.word = "\\left.", t.to = at;
            }
        }
        for (int k = 0; k < bars; k++)
            t.word = bar[k] == t.from ? "\\right|" : t.word;
        if (t.word[0] == '\0')
            continue;
        if (count == room - 1) {
            cagd_refuse_reading(error, t.from, t.to, "the formula is longer than %d signs", CAGD_MOST_TOKENS);
            return NULL;
        }
        list[count++] = t;
    }
    if (list == NULL || region_faults & FAULT_MEMORY) {
        cagd_refuse_reading(error, from, to, "there is no memory for the formula");
        return NULL;
    }
    list[count] = (cagd_token){.kind = CAGD_TOKEN_END, .word = "", .from = to, .to = to};
    return list;
}
