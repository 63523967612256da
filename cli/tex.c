/* tex.c -- formulas for a terminal. */
#include "cli/tex.h"

#include "cli/layout.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

/* A growing string. */
struct text {
    char *at;
    size_t used, room, begun; /* begun: where the formula begins                                 */
    int tight;                /* inside an index or an exponent                                  */
    int big;                  /* a sum or product sign was the last symbol: room after it        */
    int low;                  /* an index or exponent in the letters of the line was the last symbol */
};

static void put(struct text *t, const char *s, size_t n)
{
    if (t->used + n + 1 > t->room) {
        t->room = 2 * (t->used + n + 1);
        char *more = realloc(t->at, t->room);
        if (more == NULL)
            abort();
        t->at = more;
    }
    memcpy(t->at + t->used, s, n);
    t->used += n;
    t->at[t->used] = '\0';
}
static void puts_(struct text *t, const char *s) { put(t, s, strlen(s)); }

static int ends_with_blank(const struct text *t) { return t->used > 0 && t->at[t->used - 1] == ' '; }

/* Between the cells and rows of a matrix, or a comma and a semicolon where there is none. */
static void put_division(struct text *t, char mark)
{
    int depth = 0;
    for (size_t k = 0; k < t->used; k++)
        depth += (t->at[k] == MATRIX) - (t->at[k] == MATRIX_END);
    if (depth > 0)
        put(t, &mark, 1);
    else
        puts_(t, mark == NEXT_CELL ? ", " : "; ");
}

/* A relation or a binary sign stands between blanks; not in indices, where room is short. */
static void put_relation(struct text *t, const char *s)
{
    puts_(t, t->tight || ends_with_blank(t) || t->used == 0 ? "" : " ");
    puts_(t, s);
    puts_(t, t->tight ? "" : " ");
}

/* clang-format off */
static const struct {
    const char *word, *text;
} symbols[] = {
    {"alpha", "α"}, {"beta", "β"}, {"gamma", "γ"}, {"delta", "δ"}, {"epsilon", "ε"}, {"varepsilon", "ε"},
    {"theta", "θ"}, {"kappa", "κ"}, {"lambda", "λ"}, {"mu", "μ"}, {"nu", "ν"}, {"xi", "ξ"}, {"pi", "π"},
    {"rho", "ρ"}, {"sigma", "σ"}, {"tau", "τ"}, {"phi", "φ"}, {"varphi", "φ"}, {"chi", "χ"}, {"psi", "ψ"},
    {"omega", "ω"}, {"eta", "η"}, {"zeta", "ζ"}, {"Gamma", "Γ"}, {"Delta", "Δ"}, {"Lambda", "Λ"}, {"Phi", "Φ"},
    {"Psi", "Ψ"}, {"Omega", "Ω"}, {"Sigma", "Σ"}, {"Pi", "Π"}, {"ell", "ℓ"}, {"infty", "∞"}, {"partial", "∂"},
    {"nabla", "∇"}, {"Re", "ℜ"}, {"cdot", "·"}, {"times", "×"}, {"pm", "±"}, {"mp", "∓"}, {"le", "≤"}, {"leq", "≤"},
    {"ge", "≥"}, {"geq", "≥"}, {"leqslant", "≤"}, {"geqslant", "≥"}, {"ne", "≠"}, {"neq", "≠"}, {"equiv", "≡"}, {"approx", "≈"}, {"sim", "∼"},
    {"in", "∈"}, {"notin", "∉"}, {"subset", "⊂"}, {"subseteq", "⊆"}, {"supseteq", "⊇"}, {"cup", "∪"},
    {"cap", "∩"}, {"bigcap", "⋂"}, {"bigcup", "⋃"}, {"to", "→"}, {"mapsto", "↦"}, {"Rightarrow", "⇒"}, {"Leftrightarrow", "⇔"}, {"iff", "⇔"},
    {"forall", "∀"}, {"exists", "∃"}, {"dots", "…"}, {"ldots", "…"}, {"cdots", "⋯"}, {"vdots", "⋮"},
    {"ddots", "⋱"}, {"sum", "∑"}, {"prod", "∏"}, {"int", "∫"}, {"parallel", "∥"}, {"perp", "⊥"},
    {"angle", "∠"}, {"triangle", "△"}, {"circ", "∘"}, {"oplus", "⊕"}, {"emptyset", "∅"}, {"mid", "|"},
    {"Vert", "‖"}, {"vert", "|"}, {"lVert", "‖"}, {"rVert", "‖"}, {"lvert", "|"}, {"rvert", "|"},
    {"langle", "⟨"}, {"rangle", "⟩"}, {"lfloor", "⌊"}, {"rfloor", "⌋"}, {"lceil", "⌈"}, {"rceil", "⌉"},
    {"prime", "′"}, {"quad", "  "}, {"qquad", "    "}, {"setminus", "∖"}, {"colon", ":"}, {"land", "∧"},
    {"lor", "∨"}, {"neg", "¬"}, {"ll", "≪"}, {"gg", "≫"}, {"max", "max"}, {"min", "min"}, {"sin", "sin"},
    {"cos", "cos"}, {"tan", "tan"}, {"sec", "sec"}, {"arctan", "arctan"}, {"iota", "ι"}, {"csc", "csc"}, {"det", "det"}, {"lim", "lim"}, {"deg", "deg"}, {"ln", "ln"},
    {"log", "log"}, {"exp", "exp"}, {"sup", "sup"}, {"inf", "inf"}, {"arcsin", "arcsin"}, {"arccos", "arccos"},
    {"left", ""}, {"right", ""}, {"big", ""}, {"Big", ""}, {"bigl", ""}, {"bigr", ""}, {"Bigl", ""}, {"Bigr", ""},
    {"Longrightarrow", "⇒"}, {"implies", "⇒"}, {"impliedby", "⇐"}, {"Longleftarrow", "⇐"}, {"Leftarrow", "⇐"},
    {"bigm", " "}, {"Bigm", " "}, {"hline", ""}, {"lbrace", "{"}, {"rbrace", "}"}, {"biggl", ""}, {"biggr", ""}, {"bigg", ""}, {"rm", ""}, {"bf", ""}, {"it", ""}, {"cal", ""}, {"sf", ""}, {"notag", ""}, {"nonumber", ""},
    {"displaystyle", ""}, {"limits", ""}, {"nolimits", ""}, {"textstyle", ""}, {"Re", "Re"}, {"bot", "⊥"},
    {"longrightarrow", "⟶"}, {"rightarrow", "→"}, {"star", "*"}, {"ast", "*"}, {"Longleftrightarrow", "⟺"}};

/* Commands that only change the type face, or put something over a letter after it. */
static const struct {
    const char *word, *after;
} faces[] = {{"mathbf", ""}, {"boldsymbol", ""}, {"mathrm", ""}, {"mathit", ""}, {"text", ""}, {"mathcal", ""},
             {"mathfrak", ""}, {"operatorname", ""}, {"bm", ""}, {"pmb", ""}, {"mathsf", ""}, {"mathscr", ""}, {"mathtt", ""},
             {"mbox", ""}, {"hbox", ""}, {"textrm", ""}, {"textnormal", ""}, {"textup", ""}, {"substack", ""}, {"textbf", ""}, {"mathbb", ""}, {"emph", ""}, {"textit", ""},
             {"hat", "\xCC\x82"}, {"widehat", "\xCC\x82"}, {"bar", "\xCC\x84"}, {"overline", "\xCC\x84"},
             {"tilde", "\xCC\x83"}, {"widetilde", "\xCC\x83"}, {"dddot", "\xE2\x83\x9B"}, {"dot", "\xCC\x87"}, {"ddot", "\xCC\x88"},
             {"vec", "\xE2\x83\x97"}, {"underline", "\xCC\xB2"}};
/* clang-format on */

static int is_relation(const char *text)
{
    static const char *const relations[] = {"≤", "≥", "≠", "≡", "≈", "∼", "∈", "∉", "⊂", "⊆", "⊇", "→", "↦", "⇒",
                                            "⇔", "⇐", "⟶", "⟺", "±", "∓", "×", "∥", "⊥", "∪", "∩", "⊕", "≪", "≫"};
    for (size_t k = 0; k < sizeof relations / sizeof *relations; k++)
        if (strcmp(relations[k], text) == 0)
            return 1;
    return 0;
}

static const char *formula(const char *s, struct text *out, char stop);
static int is_binary(const struct text *t);

/* The next group: {...} or one token, rendered. */
static const char *group(const char *s, struct text *out)
{
    while (*s == ' ')
        s++;
    if (*s == '{')
        return formula(s + 1, out, '}');
    if (*s == '\\') {
        const char *e = s + 1;
        while (isalpha((unsigned char)*e))
            e++;
        char one[64] = {0};
        size_t n = (size_t)(e - s) < sizeof one - 1 ? (size_t)(e - s) : sizeof one - 1;
        memcpy(one, s, n);
        formula(one, out, '\0');
        return e;
    }
    size_t n = *s == '\0' ? 0 : 1;
    while (n > 0 && ((unsigned char)s[n] & 0xC0) == 0x80)
        n++;
    put(out, s, n);
    return s + n;
}

/* The three bytes at s as a string: most relations are one such character. */
static const char *copied(const char *s)
{
    static _Thread_local char three[4];
    memcpy(three, s, 3);
    return three;
}

/* Whether a rendered numerator or exponent can stand without parentheses. */
static int is_simple(const char *s)
{
    int depth = 0;
    for (const char *p = s; *p; p++) {
        if (depth == 0 && *p == '(' && p > s && p[-1] == ')')
            return 0;
        if (*p == '(' || *p == '[' || *p == '{')
            depth++;
        else if (*p == ')' || *p == ']' || *p == '}')
            depth--;
        else if (depth == 0 && (*p == '+' || *p == ' ' || *p == '/' || *p == ',' || *p == '=' ||
                                strncmp(p, "−", 3) == 0 || strncmp(p, "·", 2) == 0))
            return 0;
    }
    return 1;
}

static void put_wrapped(struct text *out, const char *s)
{
    int simple = is_simple(s[0] == '-' ? s + 1 : s);
    puts_(out, simple ? "" : "(");
    puts_(out, s);
    puts_(out, simple ? "" : ")");
}

static const struct {
    char c;
    const char *up, *down;
} small[] = {{'0', "⁰", "₀"}, {'1', "¹", "₁"},  {'2', "²", "₂"},  {'3', "³", "₃"}, {'4', "⁴", "₄"}, {'5', "⁵", "₅"},
             {'6', "⁶", "₆"}, {'7', "⁷", "₇"},  {'8', "⁸", "₈"},  {'9', "⁹", "₉"}, {'+', "⁺", "₊"}, {'=', "⁼", "₌"},
             {'(', "⁽", "₍"}, {')', "⁾", "₎"},  {'n', "ⁿ", NULL}, {'i', "ⁱ", "ᵢ"}, {'j', "ʲ", "ⱼ"}, {'k', "ᵏ", "ₖ"},
             {'r', "ʳ", "ᵣ"}, {'t', "ᵗ", "ₜ"},  {'m', "ᵐ", "ₘ"},  {'h', "ʰ", "ₕ"}, {'l', "ˡ", "ₗ"}, {'s', "ˢ", "ₛ"},
             {'p', "ᵖ", "ₚ"}, {'n', NULL, "ₙ"}, {'*', "*", NULL}, {'a', "ᵃ", "ₐ"}, {'x', "ˣ", "ₓ"}, {'\'', "′", NULL}};

static size_t character(const char *s)
{
    size_t n = *s != '\0';
    while (((unsigned char)s[n] & 0xC0) == 0x80)
        n++;
    return n;
}

/* Whether the character at s belongs to the one before it: an index, an exponent, a prime, a factorial. */
static int is_attached(const char *s)
{
    static const char *const others[] = {"⁻", "₋", "′", "*", "!"};
    for (size_t k = 0; k < sizeof others / sizeof *others; k++)
        if (strncmp(s, others[k], strlen(others[k])) == 0)
            return 1;
    for (size_t k = 0; k < sizeof small / sizeof *small; k++)
        if ((small[k].up != NULL && strncmp(s, small[k].up, strlen(small[k].up)) == 0) ||
            (small[k].down != NULL && strncmp(s, small[k].down, strlen(small[k].down)) == 0))
            return 1;
    return 0;
}

/* Whether s is one factor, a number, a symbol, a norm or a group in parentheses, with a root and what is attached
 * to it: then it can stand below a fraction's stroke as it is. */
static int is_one_factor(const char *s)
{
    int factors = 0;
    while (*s != '\0' && factors < 2) {
        if (is_attached(s) || strncmp(s, "√", 3) == 0) {
            s += character(s);
            continue;
        }
        factors++;
        if (isdigit((unsigned char)*s)) {
            s += strspn(s, "0123456789");
        } else if (*s == '(') {
            int depth = 1;
            for (s++; *s != '\0' && depth > 0; s++)
                depth += (*s == '(') - (*s == ')');
        } else if (strncmp(s, "‖", 3) == 0 && strstr(s + 3, "‖") != NULL) {
            s = strstr(s + 3, "‖") + 3;
        } else {
            s += character(s);
        }
    }
    return factors == 1;
}

/* Whether ^ or _ is to reach over all of the text: one letter, a Latin word, and what has parentheses stand for themselves. */
static int is_one_script(const char *s)
{
    const char *p = s;
    while (isalpha((unsigned char)*p))
        p++;
    return *p == '\0' || s[character(s)] == '\0' || !is_simple(s) || s[0] == '(' || s[0] == '[';
}

/* Raised or lowered letters where Unicode has all of them; otherwise ^(...) or _(...). */
static void put_script(struct text *out, const char *s, int up)
{
    struct text t = {0};
    puts_(&t, "");
    const char *p = s;
    while (*p != '\0') {
        const char *glyph = NULL;
        size_t n = 1;
        if (strncmp(p, "−", 3) == 0) {
            glyph = up ? "⁻" : "₋";
            n = 3;
        } else if (strncmp(p, "′", 3) == 0) {
            glyph = up ? "′" : NULL;
            n = 3;
        } else {
            for (size_t k = 0; k < sizeof small / sizeof *small && glyph == NULL; k++)
                if (small[k].c == *p)
                    glyph = up ? small[k].up : small[k].down;
        }
        if (glyph == NULL)
            break;
        puts_(&t, glyph);
        p += n;
    }
    if (*p == '\0') {
        puts_(out, t.at);
    } else {
        int one = is_one_script(s);
        puts_(out, up ? "^" : "_");
        puts_(out, one ? "" : "(");
        one ? put_wrapped(out, s) : puts_(out, s);
        puts_(out, one ? "" : ")");
        out->low = out->at[out->used - 1] != ')';
    }
    free(t.at);
}

static struct text render_group(const char **s, int tight)
{
    struct text t = {.tight = tight};
    puts_(&t, "");
    *s = group(*s, &t);
    return t;
}

/* Whether s goes on with a factor, so that a fraction before it wants a dot between. */
static int begins_factor(const char *s)
{
    static const char *const factors[] = {"frac",  "omega",  "mathbf", "binom", "left", "sum",        "sqrt", "hat",
                                          "alpha", "lambda", "beta",   "tau",   "prod", "boldsymbol", "det"};
    if (isalnum((unsigned char)*s) || *s == '(')
        return 1;
    for (size_t k = 0; *s == '\\' && k < sizeof factors / sizeof *factors; k++)
        if (strncmp(s + 1, factors[k], strlen(factors[k])) == 0)
            return 1;
    return 0;
}

/* One character and its indices. */
static int is_one_symbol(const char *s)
{
    size_t n = *s != '\0';
    while (((unsigned char)s[n] & 0xC0) == 0x80)
        n++;
    for (; s[n] != '\0'; n += 3)
        if (strncmp(s + n, "\xE2\x82", 2) != 0)
            return strspn(s, "0123456789") == strlen(s);
    return 1;
}

/* Whether a function without brackets is the last word, sin or sin²: a fraction behind it is its argument. */
static int is_behind_function(const struct text *t)
{
    static const char *const names[] = {"sin", "cos", "tan", "cot", "sec", "csc", "exp", "ln", "log"};
    size_t end = t->used;
    while (end > 0 && (t->at[end - 1] == ' ' || (unsigned char)t->at[end - 1] >= 0x80))
        end--; /* blanks and what is raised */
    for (size_t k = 0; k < sizeof names / sizeof *names; k++) {
        const size_t n = strlen(names[k]);
        if (end >= n && strncmp(t->at + end - n, names[k], n) == 0 &&
            (end == n || !isalpha((unsigned char)t->at[end - n - 1])))
            return 1;
    }
    return 0;
}

static int is_sum(const char *word)
{
    return strcmp(word, "sum") == 0 || strcmp(word, "prod") == 0 || strncmp(word, "bigc", 4) == 0;
}

/* Whether what stands below and above a sign is to be kept apart from what follows. */
static int has_limits(const char *word)
{
    return is_sum(word) || strcmp(word, "lim") == 0 || strcmp(word, "max") == 0 || strcmp(word, "min") == 0;
}

/* The bytes of the sign of a differential at s, d or ∂; 0 where there is none. */
static size_t differential(const char *s)
{
    return s[0] == 'd' ? 1 : strncmp(s, "∂", strlen("∂")) == 0 ? strlen("∂") : 0;
}

/* Behind the end of a row: the star and the space to the next one belong to it, \\*, \\[3mm]. */
static const char *behind_break(const char *s)
{
    s += *s == '*';
    if (*s != '[')
        return s;
    const char *unit = s + 1 + strspn(s + 1, "0123456789.,+- ");
    size_t n = *unit == '\\' ? 1 + strcspn(unit + 1, "\\] ") : 2;
    int is_length =
        n == 2 ? unit > s + 1 && isalpha((unsigned char)unit[0]) && isalpha((unsigned char)unit[1])
               : strncmp(unit, "\\jot", n) == 0 ||
                     (n > 6 && (strncmp(unit + n - 4, "skip", 4) == 0 || strncmp(unit + n - 6, "amount", 6) == 0));
    unit += is_length ? n + strspn(unit + n, " ") : 0;
    return is_length && *unit == ']' ? unit + 1 : s;
}

/* Whether formulas stand below one another in the environment, without brackets. */
static int has_rows(const char *environment)
{
    static const char *const names[] = {"align", "equation", "gather", "split", "multline", "eqnarray", "flalign"};
    for (size_t k = 0; k < sizeof names / sizeof *names; k++)
        if (strncmp(environment, names[k], strlen(names[k])) == 0)
            return 1;
    return 0;
}

/* Behind the columns of an array, [c]{ll}. */
static const char *behind_columns(const char *s)
{
    int depth = 0;
    if (*s == '[' && strchr(s, ']') != NULL)
        s = strchr(s, ']') + 1;
    if (*s != '{')
        return s;
    do {
        depth += (*s == '{') - (*s == '}');
        s++;
    } while (*s != '\0' && depth > 0);
    return s;
}

/* \word at s (behind the backslash). */
static const char *command(const char *s, struct text *out)
{
    const char *e = s;
    while (isalpha((unsigned char)*e))
        e++;
    size_t n = (size_t)(e - s);
    if (n == 0) { /* \, \; \{ \\ ... */
        if (*s == '\\')
            return put_division(out, NEXT_ROW), behind_break(s + 1);
        if (*s == '{' || *s == '}' || *s == '|' || *s == '%' || *s == '&')
            *s == '|' ? puts_(out, "‖") : put(out, s, 1);
        else if (*s == ',' || *s == ';' || *s == ' ' || *s == ':')
            puts_(out, " ");
        return *s == '\0' ? s : s + 1;
    }
    while (*e == ' ')
        e++;
    if ((n == 4 && strncmp(s, "frac", 4) == 0) ||
        (n == 5 && (strncmp(s, "tfrac", 5) == 0 || strncmp(s, "dfrac", 5) == 0))) {
        struct text a = render_group(&e, out->tight), b = render_group(&e, out->tight);
        size_t sign = differential(a.at), behind = sign > 0 && is_attached(a.at + sign) ? character(a.at + sign) : 0;
        int is_derivative = sign > 0 && a.at[sign + behind] == '\0' && differential(b.at) == sign && is_simple(b.at);
        const int of_function =
            sign > 0 && !is_derivative && differential(b.at) == sign && is_simple(a.at) && is_simple(b.at);
        is_derivative |= of_function;
        const int is_argument = !is_derivative && is_behind_function(out);
        const char before = out->used > 0 ? out->at[out->used - 1] : ' ';
        if (!is_derivative && (isalnum((unsigned char)before) || before == ')' || before == ']'))
            puts_(out, " · "); /* 2\\frac12 is no 21/2 */
        puts_(out, is_argument ? "(" : "");
        put_wrapped(out, a.at);
        puts_(out, is_derivative || is_one_factor(b.at) ? "/" : "/(");
        puts_(out, b.at);
        puts_(out, is_derivative || is_one_factor(b.at) ? "" : ")");
        puts_(out, is_argument ? ")" : "");
        if (!is_argument && begins_factor(e + strspn(e, " ")) && !(of_function && *e == '(')) {
            puts_(out, is_derivative ? " " : " · ");
            e += strspn(e, " ");
        }
        free(a.at), free(b.at);
        return e;
    }
    if (n == 2 && strncmp(s, "cr", 2) == 0) {
        put_division(out, NEXT_ROW);
        return e;
    }
    if ((n == 5 && strncmp(s, "binom", 5) == 0)) {
        struct text a = render_group(&e, out->tight), b = render_group(&e, out->tight);
        puts_(out, "C("), puts_(out, a.at), puts_(out, ", "), puts_(out, b.at), puts_(out, ")");
        free(a.at), free(b.at);
        return e;
    }
    if (n == 4 && strncmp(s, "sqrt", 4) == 0) {
        if (*e == '[') {
            const char *close = strchr(e, ']');
            struct text index = {0};
            puts_(&index, "");
            put(&index, e + 1, close != NULL ? (size_t)(close - e - 1) : 0);
            put_script(out, index.at, 1);
            free(index.at);
            e = close != NULL ? close + 1 : e + 1;
        }
        struct text a = render_group(&e, out->tight);
        puts_(out, "√");
        puts_(out, is_one_symbol(a.at) ? "" : "(");
        puts_(out, a.at);
        puts_(out, is_one_symbol(a.at) ? "" : ")");
        free(a.at);
        return e;
    }
    if ((n == 5 && strncmp(s, "begin", 5) == 0) || (n == 3 && strncmp(s, "end", 3) == 0)) {
        struct text a = render_group(&e, out->tight);
        char bracket = strcmp(a.at, "cases") == 0 ? '{'
                       : has_rows(a.at)           ? ROWS
                       : a.at[0] == 'v'           ? '|'
                       : a.at[0] == 'b'           ? '['
                                                  : '(';
        if (s[0] == 'b' && strcmp(a.at, "array") == 0)
            e = behind_columns(e);
        put(out, s[0] == 'b' ? (char[]){MATRIX, bracket} : (char[]){MATRIX_END}, s[0] == 'b' ? 2 : 1);
        free(a.at);
        return e;
    }
    if (*e == '.' && ((n == 4 && strncmp(s, "left", 4) == 0) || (n == 5 && strncmp(s, "right", 5) == 0)))
        return e + 1; /* no bracket */
    static const char *const hidden[] = {"noalign", "phantom", "hphantom", "vphantom", "hspace", "vspace"};
    for (size_t k = 0; k < sizeof hidden / sizeof *hidden; k++)
        if (strlen(hidden[k]) == n && strncmp(hidden[k], s, n) == 0) {
            struct text a = render_group(&e, out->tight);
            free(a.at);
            return e;
        }
    for (size_t k = 0; k < sizeof faces / sizeof *faces; k++)
        if (strlen(faces[k].word) == n && strncmp(faces[k].word, s, n) == 0) {
            e = group(e, out);
            puts_(out, faces[k].after);
            return e;
        }
    for (size_t k = 0; k < sizeof symbols / sizeof *symbols; k++)
        if (strlen(symbols[k].word) == n && strncmp(symbols[k].word, s, n) == 0) {
            out->big = has_limits(symbols[k].word) && (*e == '_' || *e == '^' || is_sum(symbols[k].word));
            int is_sign = strcmp(symbols[k].word, "pm") == 0 || strcmp(symbols[k].word, "mp") == 0;
            if (is_relation(symbols[k].text) && (!is_sign || is_binary(out))) {
                put_relation(out, symbols[k].text);
            } else if (strcmp(symbols[k].word, symbols[k].text) == 0) { /* sin, det, ...: a word of its own */
                puts_(out, out->used > 0 && isalnum((unsigned char)out->at[out->used - 1]) ? " " : "");
                puts_(out, symbols[k].text);
                puts_(out, *e == '\\' || isalnum((unsigned char)*e) ? " " : "");
            } else {
                puts_(out, symbols[k].text);
            }
            return e;
        }
    put(out, s, n);
    return e;
}

/* A sign is binary behind an operand of its formula. */
static int is_binary(const struct text *t)
{
    size_t n = t->used;
    while (n > t->begun && t->at[n - 1] == ' ')
        n--;
    return n > t->begun && strchr("([{=<>,|;/\2\3", t->at[n - 1]) == NULL &&
           !(n >= 3 && is_relation(copied(t->at + n - 3)));
}

/* Whether s goes on with a letter or a number: Latin, Greek, or in another type face. */
static int begins_letter(const char *s)
{
    if (*s != '\\')
        return isalnum((unsigned char)*s);
    size_t n = 0;
    while (isalpha((unsigned char)s[1 + n]))
        n++;
    for (size_t k = 0; k < sizeof symbols / sizeof *symbols; k++)
        if (strlen(symbols[k].word) == n && strncmp(symbols[k].word, s + 1, n) == 0)
            return ((unsigned char)symbols[k].text[0] & 0xFE) == 0xCE; /* the Greek letters of Unicode */
    return begins_factor(s);
}

/* In "a \choose b}" the word between a and b, with its length; NULL where there is none. */
static const char *infix_of(const char *s, size_t *length)
{
    static const char *const words[] = {"\\choose", "\\brack", "\\over"};
    for (int depth = 0; *s != '\0' && (depth > 0 || *s != '}'); s++) {
        depth += (*s == '{') - (*s == '}');
        for (size_t k = 0; depth == 0 && k < sizeof words / sizeof *words; k++) {
            *length = strlen(words[k]);
            if (strncmp(s, words[k], *length) == 0 && !isalpha((unsigned char)s[*length]))
                return s;
        }
    }
    return NULL;
}

/* {a \choose b}, {a \brack b}, {a \over b}: C(a, b), [a, b], a/b. */
static const char *infix(const char *s, const char *word, size_t length, struct text *out)
{
    struct text a = {.tight = out->tight}, b = {.tight = out->tight};
    char *left = strndup(s, (size_t)(word - s));
    puts_(&a, ""), puts_(&b, "");
    if (left != NULL)
        formula(left, &a, '\0');
    s = word + length;
    while (*s == ' ')
        s++;
    s = formula(s, &b, '}');
    while (a.used > 0 && a.at[a.used - 1] == ' ')
        a.at[--a.used] = '\0';
    if (word[1] == 'o') {
        put_wrapped(out, a.at);
        puts_(out, is_one_factor(b.at) ? "/" : "/("), puts_(out, b.at), puts_(out, is_one_factor(b.at) ? "" : ")");
    } else {
        puts_(out, word[1] == 'c' ? "C(" : "["), puts_(out, a.at), puts_(out, ", "), puts_(out, b.at);
        puts_(out, word[1] == 'c' ? ")" : "]");
    }
    free(left), free(a.at), free(b.at);
    return s;
}

static const char *formula(const char *s, struct text *out, char stop)
{
    size_t length;
    const char *word;
    while (*s != '\0' && *s != stop) {
        if (out->low && !out->tight && begins_letter(s))
            puts_(out, " ");
        out->low = 0;
        if (out->big && *s != '_' && *s != '^') {
            puts_(out, " ");
            out->big = 0;
        }
        if (*s == '\\') {
            s = command(s + 1, out);
        } else if (*s == '^' || *s == '_') {
            int up = *s++ == '^';
            struct text t = render_group(&s, 1);
            put_script(out, t.at, up);
            free(t.at);
        } else if (*s == '{' && (word = infix_of(s + 1, &length)) != NULL) {
            s = infix(s + 1, word, length, out);
        } else if (*s == '{') {
            s = formula(s + 1, out, '}');
        } else if (*s == '=' || *s == '<' || *s == '>') {
            put_relation(out, *s == '=' ? "=" : *s == '<' ? "<" : ">"), s++;
        } else if ((*s == '-' || *s == '+') && is_binary(out) && strchr(")],", s[1]) == NULL) {
            put_relation(out, *s++ == '-' ? "−" : "+");
        } else if (*s == '-') { /* of one number, or of a limit from one side as in r(t−) */
            puts_(out, "−"), s++;
        } else if (isspace((unsigned char)*s)) {
            puts_(out, ends_with_blank(out) ? "" : " "), s++;
        } else if (*s == '\'') {
            puts_(out, "′"), s++;
        } else if (*s == '$') { /* around a formula in a text */
            s++;
        } else if (*s == '~') {
            puts_(out, " "), s++;
        } else if (*s == '&') {
            put_division(out, NEXT_CELL), s++;
        } else if (*s == '}') {
            s++;
        } else {
            put(out, s++, 1);
        }
    }
    return *s == '\0' ? s : s + 1;
}

/* No line ends in parentheses as short as those of (1 − t). */
static void tie_short_groups(char *text)
{
    enum { SHORT = 20 };
    for (char *open = strchr(text, '('); open != NULL; open = strchr(open + 1, '(')) {
        size_t n = strcspn(open + 1, "()");
        if (open[1 + n] != ')' || n > SHORT)
            continue;
        for (char *c = open; c < open + n; c++)
            *c = (char)(*c == ' ' ? TIE : *c);
    }
}

char *tex_to_layout(const char *tex, int mixed)
{
    struct text out = {0};
    puts_(&out, "");
    const char *s = tex;
    if (!mixed) {
        formula(s, &out, '\0');
        tie_short_groups(out.at);
        return out.at;
    }
    while (*s != '\0') {
        if (*s == '$') {
            const char *close = strchr(s + 1, '$');
            struct text inner = {0};
            puts_(&inner, "");
            put(&inner, s + 1, close != NULL ? (size_t)(close - s - 1) : strlen(s + 1));
            out.begun = out.used;
            formula(inner.at, &out, '\0');
            out.low = 0;
            free(inner.at);
            s = close != NULL ? close + 1 : s + strlen(s);
        } else {
            put(&out, s++, 1);
        }
    }
    tie_short_groups(out.at);
    return out.at;
}

char *tex_to_text(const char *tex, int mixed)
{
    char *laid_out = tex_to_layout(tex, mixed), *text = in_one_line(laid_out);
    free(laid_out);
    return text;
}
