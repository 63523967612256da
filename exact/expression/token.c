#include "exact/expression/token.h"

#include "exact/words.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

/* What is written in several ways, and its one word; "" where it is no token. */
/* clang-format off */
static const struct {
    const char *written, *word;
} same[] = {
    {"\\leq", "\\le"}, {"\\geq", "\\ge"}, {"\\neq", "\\ne"}, {"\\leqslant", "\\le"}, {"\\geqslant", "\\ge"},
    {"\\leqq", "\\le"}, {"\\geqq", "\\ge"}, {"\\nless", "\\ge"}, {"\\ngtr", "\\le"}, {"\\nleq", ">"}, {"\\ngeq", "<"},
    {"\\coloneqq", ":="}, {"\\coloneq", ":="}, {"\\triangleq", ":="},
    {"\\lt", "<"}, {"\\gt", ">"}, {"\\equiv", "="}, {"\\ldots", "\\dots"}, {"\\cdots", "\\dots"}, {"\\dotsc", "\\dots"},
    {"\\dotsb", "\\dots"}, {"\\dotsm", "\\dots"}, {"\\dotso", "\\dots"}, {"\\dfrac", "\\frac"}, {"\\tfrac", "\\frac"},
    {"\\cfrac", "\\frac"}, {"\\nicefrac", "\\frac"}, {"\\sfrac", "\\frac"}, {"\\dbinom", "\\binom"}, {"\\tbinom", "\\binom"},
    {"\\cdot", "*"}, {"\\cdotp", "*"}, {"\\ast", "*"}, {"\\star", "*"}, {"\\lVert", "\\|"}, {"\\rVert", "\\|"}, {"\\Vert", "\\|"}, {"\\lvert", "|"}, {"\\rvert", "|"}, {"\\vert", "|"},
    {"\\varepsilon", "\\epsilon"}, {"\\widehat", "\\hat"}, {"\\widetilde", "\\tilde"}, {"\\overline", "\\bar"},
    {"\\colon", ":"}, {"\\lbrace", "\\{"}, {"\\rbrace", "\\}"}, {"\\lbrack", "["}, {"\\rbrack", "]"}, {"\\wedge", "\\land"},
    {"\\left", ""}, {"\\right", ""}, {"\\big", ""}, {"\\Big", ""}, {"\\bigg", ""}, {"\\Bigg", ""}, {"\\bigl", ""},
    {"\\bigr", ""}, {"\\Bigl", ""}, {"\\Bigr", ""}, {"\\biggl", ""}, {"\\biggr", ""}, {"\\Biggl", ""}, {"\\Biggr", ""},
    {"\\bigm", ""}, {"\\Bigm", ""}, {"\\biggm", ""}, {"\\Biggm", ""}, {"\\mleft", ""}, {"\\mright", ""}, {"\\displaylimits", ""},
    {"\\scriptstyle", ""}, {"\\thinspace", ""}, {"\\negthinspace", ""}, {"\\medspace", ""}, {"\\thickspace", ""}, {"\\enspace", ""},
    {"\\enskip", ""}, {"\\hfill", ""}, {"\\strut", ""}, {"\\mathstrut", ""}, {"\\relax", ""}, {"\\boxed", ""}, {"\\ensuremath", ""},
    {"\\middle", ""}, {"\\displaystyle", ""}, {"\\textstyle", ""}, {"\\limits", ""}, {"\\nolimits", ""}, {"\\quad", ""},
    {"\\qquad", ""}, {"\\nonumber", ""}, {"\\notag", ""}, {"\\cr", "\\\\"}, {"\\tabularnewline", "\\\\"}, {"\\hline", ""}, {"\\smallskip", ""}, {"\\medskip", ""}, {"\\bigskip", ""},
    {"\\mbox", "\\text"}, {"\\hbox", "\\text"}, {"\\textrm", "\\text"}, {"\\textnormal", "\\text"}, {"\\textup", "\\text"}, {"\\textit", "\\text"},
    {"\\,", ""}, {"\\;", ""}, {"\\:", ""}, {"\\!", ""}, {"\\ ", ""}, {"\\>", ""}, {"~", ""},
    {"\u00a0", ""}, {"\u2002", ""}, {"\u2003", ""}, {"\u2009", ""}, {"\u200a", ""}, {"\u202f", ""}, {"\u3000", ""},
    {"⩽", "\\le"}, {"⩾", "\\ge"}, {"≦", "\\le"}, {"≧", "\\ge"}, {"⋅", "*"}, {"∗", "*"}, {"⋯", "\\dots"}, {"⟹", "\\Rightarrow"},
    {"⟸", "\\Leftarrow"}, {"⟺", "\\iff"}, {"∫", "\\int"}, {"∂", "\\partial"}, {"√", "\\sqrt"}, {"⌊", "\\lfloor"}, {"⌋", "\\rfloor"},
    {"⌈", "\\lceil"}, {"⌉", "\\rceil"}, {"‖", "\\|"}, {"⟨", "\\langle"}, {"⟩", "\\rangle"}, {"∉", "\\notin"}, {"ℕ", "\\N"},
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

enum { MOST_BARS = 16, FARTHEST_BAR = 4000, LONGEST_SCRIPT = 40 };

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

/* Letters and digits that stand above or below the line: what they are on the line. */
static const struct {
    const char *written, *word;
    char script;
} scripts[] = {{"⁰", "0", '^'}, {"¹", "1", '^'}, {"²", "2", '^'}, {"³", "3", '^'}, {"⁴", "4", '^'}, {"⁵", "5", '^'},
               {"⁶", "6", '^'}, {"⁷", "7", '^'}, {"⁸", "8", '^'}, {"⁹", "9", '^'}, {"⁺", "+", '^'}, {"⁻", "-", '^'},
               {"ⁱ", "i", '^'}, {"ʲ", "j", '^'}, {"ᵏ", "k", '^'}, {"ᵐ", "m", '^'}, {"ⁿ", "n", '^'}, {"ᵖ", "p", '^'},
               {"ʳ", "r", '^'}, {"₀", "0", '_'}, {"₁", "1", '_'}, {"₂", "2", '_'}, {"₃", "3", '_'}, {"₄", "4", '_'},
               {"₅", "5", '_'}, {"₆", "6", '_'}, {"₇", "7", '_'}, {"₈", "8", '_'}, {"₉", "9", '_'}, {"₊", "+", '_'},
               {"₋", "-", '_'}, {"ᵢ", "i", '_'}, {"ⱼ", "j", '_'}, {"ₖ", "k", '_'}, {"ₘ", "m", '_'}, {"ₙ", "n", '_'},
               {"ₚ", "p", '_'}};
enum { SCRIPTS = sizeof scripts / sizeof *scripts };

/* The number of what stands above or below the line at s, -1 where it is nothing of that. */
static int script_at(const char *s, int n)
{
    for (int k = 0; k < SCRIPTS && (unsigned char)s[0] >= 0x80; k++)
        if (is(s, length_at(s, n), scripts[k].written))
            return k;
    return -1;
}

/* Scripts of one kind side by side are one group: xᵢ₊₁ is x_{i+1}.  The tokens go to list[*count], ...; what is behind them comes out. */
static int read_scripts(const char *text, int at, int to, cagd_token list[], int *count)
{
    int which = script_at(text + at, to - at), from = at;
    char script = scripts[which].script;
    list[(*count)++] =
        (cagd_token){CAGD_TOKEN_SIGN, script == '^' ? "^" : "_", from, from + length_at(text + at, to - at)};
    cagd_token *open = &list[(*count)++];
    while (at < to && (which = script_at(text + at, to - at)) >= 0 && scripts[which].script == script) {
        int end = at + length_at(text + at, to - at);
        const char *word = scripts[which].word;
        cagd_token *last = &list[*count - 1];
        if (last > open && isdigit((unsigned char)word[0]) && last->kind == CAGD_TOKEN_NUMBER) { /* x₁₂ */
            char digits[24];
            snprintf(digits, sizeof digits, "%.20s%s", last->word, word);
            last->word = cagd_text_of(digits, (int)strlen(digits)), last->to = end;
        } else {
            list[(*count)++] = (cagd_token){isdigit((unsigned char)word[0])   ? CAGD_TOKEN_NUMBER
                                            : isalpha((unsigned char)word[0]) ? CAGD_TOKEN_LETTER
                                                                              : CAGD_TOKEN_SIGN,
                                            word, at, end};
        }
        at = end;
    }
    *open = (cagd_token){CAGD_TOKEN_SIGN, "{", from, from};
    list[(*count)++] = (cagd_token){CAGD_TOKEN_SIGN, "}", at, at};
    return at;
}

/* For the page, with a group behind it that means nothing; and what sets a group above the sign behind it, \stackrel{(1)}{=}. */
static const char *const without_meaning[] = {"\\hspace",   "\\vspace",  "\\mspace",  "\\phantom", "\\vphantom",
                                              "\\hphantom", "\\label",   "\\tag",     "\\noalign", "\\color",
                                              "\\stackrel", "\\overset", "\\underset"};

/* Behind the group of such a word s[0..n), which ends at `at`; `at` where there is none. */
static int behind_meaningless(const char *text, const char *s, int n, int at, int to)
{
    int depth = 0, is_one = 0, k = at;
    for (size_t m = 0; m < sizeof without_meaning / sizeof *without_meaning; m++)
        is_one |= is(s, n, without_meaning[m]);
    k += is_one && k < to && text[k] == '*';
    while (is_one && k < to && isspace((unsigned char)text[k]))
        k++;
    if (!is_one || k == to || text[k] != '{')
        return at;
    for (; k < to; k++) {
        depth += (text[k] == '{') - (text[k] == '}');
        if (depth == 0)
            return k + 1;
    }
    return at;
}

/* The end of a length of TeX at `at`, 3mm, -.5ex, 2\jot; `at` where there is none. */
static int behind_length(const char *text, int at, int to)
{
    static const char *const units[] = {"pt", "mm", "cm", "in", "ex", "em", "bp", "pc", "dd", "cc", "sp", "mu", "px"},
                             *const lengths[] = {
                                 "\\jot",           "\\baselineskip",  "\\normalbaselineskip", "\\smallskipamount",
                                 "\\medskipamount", "\\bigskipamount", "\\lineskip",           "\\parskip"};
    int k = at, digits = 0;
    while (k < to && (text[k] == '-' || text[k] == '+' || isspace((unsigned char)text[k])))
        k++;
    for (; k < to && (isdigit((unsigned char)text[k]) || text[k] == '.' || text[k] == ','); k++)
        digits += isdigit((unsigned char)text[k]) != 0;
    while (k < to && isspace((unsigned char)text[k]))
        k++;
    for (size_t m = 0; k < to && text[k] == '\\' && m < sizeof lengths / sizeof *lengths; m++)
        if (is(text + k, length_at(text + k, to - k), lengths[m]))
            return k + (int)strlen(lengths[m]);
    for (size_t m = 0; digits > 0 && m < sizeof units / sizeof *units; m++)
        if (k + 2 <= to && memcmp(text + k, units[m], 2) == 0)
            return k + 2;
    return at;
}

/* Behind the end of a row \\, which ends at `at`: the star and the space to the next row belong to it, \\*, \\[3mm].  -1 and the error where a blank before
 * the bracket leaves open what it is. */
static int behind_break(const char *text, int at, int to, cagd_reading_error *error)
{
    int k = at + (at < to && text[at] == '*'), open, end;
    at = k;
    while (k < to && isspace((unsigned char)text[k]))
        k++;
    if (k == to || text[k] != '[')
        return at;
    open = k;
    end = behind_length(text, k + 1, to);
    for (k = end; k < to && isspace((unsigned char)text[k]);)
        k++;
    if (end == open + 1 || k == to || text[k] != ']')
        return at;
    if (open > at) {
        cagd_refuse_reading(
            error, open, k + 1,
            "the space between two rows, or a factor? write \\\\%.*s, or round brackets around the factor",
            k + 1 - open > 20 ? 20 : k + 1 - open, text + open);
        return -1;
    }
    return k + 1;
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

/* ---- what is one word though it is written with several ------------------------------------------------- */

/* {=}, which is there for the space around it; \not=; {\bf P}, which is \mathbf{P}; \mathrm{sin}, \operatorname{sin}. */
/* clang-format off */
static const struct {
    const char *written, *word;
} relations[] = {{"=", "\\ne"}, {"<", "\\ge"}, {">", "\\le"}, {"\\le", ">"}, {"\\ge", "<"}, {"\\ne", "="}, {"\\in", "\\notin"}},
  fonts[] = {{"\\bf", "\\mathbf"}, {"\\rm", "\\mathrm"}, {"\\it", "\\mathit"}, {"\\cal", "\\mathcal"}, {"\\sf", "\\mathsf"},
             {"\\bfseries", "\\mathbf"}},
  functions[] = {{"sin", "\\sin"}, {"cos", "\\cos"}, {"tan", "\\tan"}, {"cot", "\\cot"}, {"det", "\\det"}, {"max", "\\max"}, {"min", "\\min"}};
/* clang-format on */

static const char *relation_not(const char *word)
{
    for (size_t k = 0; k < sizeof relations / sizeof *relations; k++)
        if (strcmp(relations[k].written, word) == 0)
            return relations[k].word;
    return NULL;
}

static const char *font_of(const char *word)
{
    for (size_t k = 0; k < sizeof fonts / sizeof *fonts; k++)
        if (strcmp(fonts[k].written, word) == 0)
            return fonts[k].word;
    return NULL;
}

/* The function whose letters stand in braces at t; behind the brace something follows, so that it is no label, as in P_{\mathrm{min}}. */
static const char *function_in_braces(const cagd_token *t)
{
    for (size_t k = 0; k < sizeof functions / sizeof *functions; k++) {
        const char *c = functions[k].written;
        const cagd_token *s = t + 1;
        while (*c != '\0' && s->word[0] == *c && s->word[1] == '\0')
            c++, s++;
        if (*c == '\0' && strcmp(s->word, "}") == 0 && s[1].kind != CAGD_TOKEN_END && strcmp(s[1].word, "}") != 0)
            return functions[k].word;
    }
    return NULL;
}

/* Whether {} behind it is there for the space. */
static int stands_before_space(const char *word)
{
    static const char *const words[] = {"=", "<", ">", "\\le", "\\ge", "\\ne", ":=", "+", "-", "&", "\\\\", ","};
    for (size_t k = 0; k < sizeof words / sizeof *words; k++)
        if (strcmp(words[k], word) == 0)
            return 1;
    return 0;
}

static void simplify(cagd_token list[], int *count)
{
    enum { OF_FUNCTION = 6 }; /* \mathrm { s i n } */
    int to = 0;
    for (int k = 0; k <= *count; k++, to++) {
        const char *word;
        while (k + 1 < *count && strcmp(list[k].word, "{") == 0 && strcmp(list[k + 1].word, "}") == 0 &&
               (to == 0 || stands_before_space(list[to - 1].word)))
            k += 2;
        list[to] = list[k];
        if (k + 2 <= *count && strcmp(list[k].word, "{") == 0 && relation_not(list[k + 1].word) != NULL &&
            strcmp(list[k + 2].word, "}") == 0) {
            list[to] = list[k + 1];
            k += 2;
        } else if (strcmp(list[k].word, "\\not") == 0 && (word = relation_not(list[k + 1].word)) != NULL) {
            list[to] =
                (cagd_token){word[0] == '\\' ? CAGD_TOKEN_WORD : CAGD_TOKEN_SIGN, word, list[k].from, list[k + 1].to};
            k++;
        } else if (strcmp(list[k].word, "{") == 0 && (word = font_of(list[k + 1].word)) != NULL) {
            list[to] = (cagd_token){CAGD_TOKEN_WORD, word, list[k].from, list[k + 1].to};
            list[++to] = (cagd_token){CAGD_TOKEN_SIGN, "{", list[k].from, list[k + 1].to};
            k++;
        } else if (k + OF_FUNCTION <= *count && (k == 0 || strchr("_^", list[k - 1].word[0]) == NULL) &&
                   (strcmp(list[k].word, "\\mathrm") == 0 || strcmp(list[k].word, "\\operatorname") == 0) &&
                   strcmp(list[k + 1].word, "{") == 0 && (word = function_in_braces(list + k + 1)) != NULL) {
            list[to] = (cagd_token){CAGD_TOKEN_WORD, word, list[k].from, list[k + OF_FUNCTION - 1].to};
            k += OF_FUNCTION - 1;
        }
    }
    *count = to - 1;
}

/* Words of a piece of text in which formulas stand between dollar signs, as tokens of \text{...}; commas and the like at its beginning by themselves. */
static void put_words(const char *text, int from, int to, cagd_token list[], int *count)
{
    while (to > from && (isspace((unsigned char)text[to - 1]) || text[to - 1] == '~'))
        to--;
    for (; from < to && (isspace((unsigned char)text[from]) || strchr(",;.~", text[from]) != NULL); from++)
        if (strchr(",;.", text[from]) != NULL && *count < CAGD_MOST_TOKENS)
            list[(*count)++] = (cagd_token){CAGD_TOKEN_SIGN, cagd_text_of(text + from, 1), from, from + 1};
    const char *words = cagd_text_of(text + from, to - from);
    if (from == to || words == NULL || *count + 4 > CAGD_MOST_TOKENS)
        return;
    list[(*count)++] = (cagd_token){CAGD_TOKEN_WORD, "\\text", from, to};
    list[(*count)++] = (cagd_token){CAGD_TOKEN_SIGN, "{", from, to};
    list[(*count)++] = (cagd_token){CAGD_TOKEN_WORD, words, from, to};
    list[(*count)++] = (cagd_token){CAGD_TOKEN_SIGN, "}", to, to};
}

/* The end of the group of a text, which begins behind `at` with a brace, if there are dollar signs in it; -1 where there are none. */
static int end_of_text_with_formulas(const char *text, int at, int to)
{
    int depth = 0, has = 0;
    while (at < to && isspace((unsigned char)text[at]))
        at++;
    for (int k = at; k < to && text[at] == '{'; k++) {
        k += text[k] == '\\';
        depth += (text[k] == '{') - (text[k] == '}');
        has |= text[k] == '$';
        if (depth == 0)
            return has ? k : -1;
    }
    return -1;
}

/* Behind the columns of an array at `at`, {ll}, [c]{@{}l@{\quad}p{2cm}|}; -1 where it is no such thing. */
static int behind_columns(const char *text, int at, int to)
{
    int k = at, depth = 0;
    while (k < to && isspace((unsigned char)text[k]))
        k++;
    if (k + 2 < to && text[k] == '[' && text[k + 2] == ']')
        k += 3;
    while (k < to && isspace((unsigned char)text[k]))
        k++;
    if (k == to || text[k] != '{')
        return -1;
    for (k++; k < to && text[k] != '}'; k++) {
        if (strchr("lcr| *\n", text[k]) != NULL)
            continue;
        if (strchr("@!><pmb", text[k]) == NULL && text[k] != '{')
            return -1;
        for (k += text[k] != '{'; k < to; k++) {
            depth += (text[k] == '{') - (text[k] == '}');
            if (depth == 0)
                break;
        }
        if (k == to || text[k] != '}')
            return -1;
    }
    return k < to ? k + 1 : -1;
}

/* Whether the tokens end with \begin{array}. */
static int ends_with_array(const cagd_token list[], int count)
{
    static const char *const words[] = {"\\begin", "{", "a", "r", "r", "a", "y", "}"};
    enum { WORDS = sizeof words / sizeof *words };
    for (int k = 0; k < WORDS && count >= WORDS; k++)
        if (strcmp(list[count - WORDS + k].word, words[k]) != 0)
            return 0;
    return count >= WORDS;
}

/* \mathrm{otherwise}, {\rm if}: words, and no name. */
static void read_roman_words(cagd_token list[], int count)
{
    static const char *const words[] = {"if",    "otherwise", "else", "elsewhere", "for",  "when",
                                        "where", "and",       "or",   "then",      "even", "odd"};
    for (int k = 0; k + 2 < count; k++) {
        char said[16];
        int n = 0, m = k + 2,
            is_index =
                k > 0 && (strchr("_^", list[k - 1].word[0]) != NULL ||
                          (k > 1 && strcmp(list[k - 1].word, "{") == 0 && strchr("_^", list[k - 2].word[0]) != NULL));
        if ((strcmp(list[k].word, "\\mathrm") != 0 && strcmp(list[k].word, "\\mathit") != 0 &&
             strcmp(list[k].word, "\\operatorname") != 0) ||
            strcmp(list[k + 1].word, "{") != 0 || is_index)
            continue;
        for (; m < count && list[m].kind == CAGD_TOKEN_LETTER && n + 1 < (int)sizeof said; m++)
            said[n++] = list[m].word[0];
        said[n] = '\0';
        m += m < count && strchr(",.;", list[m].word[0]) != NULL;
        for (size_t w = 0; w < sizeof words / sizeof *words && m < count && strcmp(list[m].word, "}") == 0; w++)
            if (strcmp(words[w], said) == 0)
                list[k].word = "\\text";
    }
}

cagd_token *cagd_tokens(const char *text, int from, int to, cagd_reading_error *error)
{
    int count = 0, room = 2 * (to - from < CAGD_MOST_TOKENS ? to - from : CAGD_MOST_TOKENS) + 2 * LONGEST_SCRIPT + CAGD_TOKENS_AHEAD;
    cagd_token *list = cagd_region_array(room, 1, sizeof *list);
    int bar[MOST_BARS], bars = 0; /* that end what \left. begins */
    int text_end = -1;            /* of a text in which formulas stand between dollar signs */
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
        if (at == text_end) {
            text_end = -1, at++;
            continue;
        }
        if (text_end >= 0 && s[0] == '$') { /* behind a formula of the text */
            int stop = at + 1;
            while (stop < text_end && text[stop] != '$')
                stop++;
            put_words(text, at + 1, stop, list, &count);
            at = stop + (stop < text_end);
            continue;
        }
        if (script_at(s, n) >= 0 && count < CAGD_MOST_TOKENS) {
            at = read_scripts(text, at, n < LONGEST_SCRIPT ? to : at + LONGEST_SCRIPT, list, &count);
            continue;
        }
        cagd_token t = {.from = at};
        int digits = digits_at(s, n);
        if (digits > 0) {
            t.kind = CAGD_TOKEN_NUMBER, t.word = cagd_text_of(s, digits), t.to = at + digits;
            if (t.word == NULL)
                break;
        } else if (n > 1 && s[0] == ':' && s[1] == '=') {
            t.kind = CAGD_TOKEN_SIGN, t.word = ":=", t.to = at + 2;
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
        int behind = behind_meaningless(text, s, t.to - t.from, at, to);
        if (strcmp(t.word, "\\text") == 0 && text_end < 0 &&
            (text_end = end_of_text_with_formulas(text, at, to)) >= 0) {
            int begin = at, stop;
            while (text[begin] != '{')
                begin++;
            for (stop = begin + 1; text[stop] != '$'; stop++)
                ;
            put_words(text, begin + 1, stop, list, &count);
            at = stop + 1;
            continue;
        }
        if (strcmp(t.word, "\\\\") == 0 && (at = t.to = behind_break(text, at, to, error)) < 0)
            return NULL;
        behind = behind > at ? behind : at;
        if (t.word[0] == '\0' || behind > at) {
            at = behind;
            continue;
        }
        if (count >= CAGD_MOST_TOKENS) {
            cagd_refuse_reading(error, t.from, t.to, "the formula is longer than %d signs", CAGD_MOST_TOKENS);
            return NULL;
        }
        list[count++] = t;
        int columns = t.word[0] == '}' && ends_with_array(list, count) ? behind_columns(text, at, to) : -1;
        if (columns >= 0 && count + 2 < CAGD_MOST_TOKENS) {
            list[count++] = (cagd_token){CAGD_TOKEN_SIGN, "{", at, columns};
            list[count++] = (cagd_token){CAGD_TOKEN_SIGN, "}", columns, columns};
            at = columns;
        }
    }
    if (list == NULL || region_faults & FAULT_MEMORY) {
        cagd_refuse_reading(error, from, to, "there is no memory for the formula");
        return NULL;
    }
    list[count] = (cagd_token){.kind = CAGD_TOKEN_END, .word = "", .from = to, .to = to};
    simplify(list, &count);
    read_roman_words(list, count);
    for (int k = 1; k < CAGD_TOKENS_AHEAD; k++)
        list[count + k] = list[count];
    return list;
}
