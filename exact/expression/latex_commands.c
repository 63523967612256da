/* latex_commands.c -- \newcommand, \def and their like, and what they stand for. */
#include "exact/expression/latex.h"
#include "exact/words.h"

#include <ctype.h>
#include <string.h>

enum {
    SHELVES = 1024,
    MOST_PARAMETERS = 9,
    MOST_DEPTH = 40,
#ifdef CAGD_SMALL_LIMITS
    MOST_CALLS = 100,
    MOST_OF_ONE = 1 << 11,
    MOST_WORK = 1 << 17,
#else
    MOST_CALLS = 5000,
    MOST_OF_ONE = 1 << 17,
    MOST_WORK = 1 << 26,
#endif
    EACH_CALL = 20, /* work besides the bytes */
    LONGEST_COMMAND = 200,
    MOST_LEVELS = 1000, /* of braces inside of one another      */
    MOST_ELSES = 100    /* of \iffalse ... \else inside of one another */
};

/* A piece of text: of the source, whose bytes come from where they stand, or of an expansion, where from[] says it. */
struct slice {
    const char *s;
    const int *from; /* NULL: byte k comes from byte offset + k */
    int n, offset;
};

/* \name with so many parameters stands for the body; the first one may be left out, where `optional` is given. */
struct command {
    const char *name;
    int parameters, has_optional, starred; /* starred: a star or an option behind the name is passed over */
    int endless;                           /* a call of it did not end: no other is tried                 */
    struct slice optional, body;
    struct command *next;
};

/* A brace or bracket that is open, and how many arguments are awaited behind its end. */
struct level {
    char close;
    int awaited;
};

struct expansion {
    struct command *shelf[SHELVES];
    struct level level[MOST_LEVELS];
    int levels;
    int awaited;                /* so many arguments of the last \frac or \mathbf are still to come */
    int option;                 /* so many come behind an option, if one stands next: 1 of \sqrt     */
    const char *fi[MOST_ELSES]; /* the \fi behind the \else of an \iffalse: they are passed over     */
    int fis;
    cagd_latex_text *out;
    cagd_latex *troubles;
    int calls, limit; /* of the outermost command: what it called, and how large the text may get */
    int at;           /* where it was called in the source                                       */
    int overflow, in_body, in_note;
    long
        work; /* bytes that were looked through for the ends of groups, or substituted: what is made to take long ends */
};

static int from_of(const struct slice *t, int k) { return t->from != NULL ? t->from[k] : t->offset + k; }

static struct slice part_of(const struct slice *t, int a, int b)
{
    return (struct slice){t->s + a, t->from != NULL ? t->from + a : NULL, b - a, t->offset + a};
}

/* ---- the text that grows ------------------------------------------------------------------------------- */

void cagd_latex_put(cagd_latex_text *out, char byte, int from)
{
    if (out->size == out->room) {
        int room = out->room > 0 ? 2 * out->room : 1 << 6;
        char *bytes = region_bytes((size_t)room);
        int *places = cagd_region_array(room, 1, sizeof *places);
        if (bytes == NULL || places == NULL)
            return;
        if (out->size > 0) {
            memcpy(bytes, out->bytes, (size_t)out->size);
            memcpy(places, out->from, (size_t)out->size * sizeof *places);
        }
        out->bytes = bytes, out->from = places, out->room = room;
    }
    out->bytes[out->size] = byte;
    out->from[out->size++] = from;
}

static void put_slice(cagd_latex_text *out, const struct slice *t, int a, int b)
{
    for (int k = a; k < b; k++)
        cagd_latex_put(out, t->s[k], from_of(t, k));
}

void cagd_latex_refuse(cagd_latex *out, int from, int to, const char *message)
{
    if (out->troubles == out->trouble_room) {
        int room = out->trouble_room > 0 ? 2 * out->trouble_room : 8;
        cagd_latex_trouble *more = cagd_region_array(room, 1, sizeof *more);
        if (more == NULL)
            return;
        if (out->troubles > 0)
            memcpy(more, out->trouble, (size_t)out->troubles * sizeof *more);
        out->trouble = more, out->trouble_room = room;
    }
    out->trouble[out->troubles++] = (cagd_latex_trouble){from, to, message, 0, 0};
}

void cagd_latex_remark(cagd_latex *out, int from, int to, const char *message)
{
    int before = out->troubles;
    cagd_latex_refuse(out, from, to, message);
    if (out->troubles > before)
        out->trouble[before].is_remark = 1;
}

/* ---- where things end ---------------------------------------------------------------------------------- */

static int is_letter(char c) { return isalpha((unsigned char)c) || c == '@'; }
static int is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

/* Behind the comment at k, its end of line and the blanks that the next line begins with. */
static int behind_comment(const struct slice *t, int k)
{
    while (k < t->n && t->s[k] != '\n')
        k++;
    k += k < t->n;
    while (k < t->n && (t->s[k] == ' ' || t->s[k] == '\t'))
        k++;
    return k;
}

static int behind_blanks(const struct slice *t, int k)
{
    while (k < t->n && (is_blank(t->s[k]) || t->s[k] == '%'))
        k = t->s[k] == '%' ? behind_comment(t, k) : k + 1;
    return k;
}

/* Behind the command or the character at k; a command is a backslash with letters, or with one other character. */
static int behind_token(const struct slice *t, int k)
{
    if (t->s[k] != '\\' || k + 1 == t->n) {
        for (k++; k < t->n && ((unsigned char)t->s[k] & 0xC0) == 0x80; k++)
            ;
        return k;
    }
    if (!is_letter(t->s[k + 1]))
        return k + 2;
    for (k++; k < t->n && is_letter(t->s[k]); k++)
        ;
    return k;
}

/* Behind the group that begins at k with `open`; -1 where it does not end. */
static int behind_group(struct expansion *x, const struct slice *t, int k, char open, char close)
{
    int depth = 0;
    while (k < t->n && ++x->work < MOST_WORK) {
        char c = t->s[k];
        if (c == '%') {
            k = behind_comment(t, k);
            continue;
        }
        int next = behind_token(t, k);
        if (open != '{' && c == '{') { /* brackets inside of braces do not count */
            next = behind_group(x, t, k, '{', '}');
            if (next < 0)
                return -1;
        } else {
            depth += (c == open) - (c == close);
        }
        k = next;
        if (depth == 0)
            return k;
    }
    return -1;
}

static int is_word(const struct slice *t, int a, int b, const char *word)
{
    return b - a == (int)strlen(word) && memcmp(t->s + a, word, (size_t)(b - a)) == 0;
}

/* {\name} or \name at k: the name goes to a..b, and what is behind it comes out; -1 where there is none. */
static int name_at(const struct slice *t, int k, int *a, int *b)
{
    k = behind_blanks(t, k);
    int braces = k < t->n && t->s[k] == '{';
    if (braces)
        k = behind_blanks(t, k + 1);
    if (k >= t->n || t->s[k] != '\\')
        return -1;
    *a = k, *b = k = behind_token(t, k);
    if (braces) {
        k = behind_blanks(t, k);
        if (k >= t->n || t->s[k] != '}')
            return -1;
        k++;
    }
    return k;
}

/* {group} or a single token behind blanks: without its braces in *out; what is behind it, or -1. */
static int argument_at(struct expansion *x, const struct slice *t, int k, struct slice *out)
{
    k = behind_blanks(t, k);
    if (k >= t->n || t->s[k] == '}')
        return -1;
    int end = t->s[k] == '{' ? behind_group(x, t, k, '{', '}') : behind_token(t, k);
    if (end > 0)
        *out = t->s[k] == '{' ? part_of(t, k + 1, end - 1) : part_of(t, k, end);
    return end;
}

/* [option] behind blanks, if one stands there. */
static int option_at(struct expansion *x, const struct slice *t, int k, struct slice *out, int *is)
{
    int at = behind_blanks(t, k), end = at < t->n && t->s[at] == '[' ? behind_group(x, t, at, '[', ']') : -1;
    *is = end > 0;
    if (*is)
        *out = part_of(t, at + 1, end - 1);
    return *is ? end : k;
}

/* ---- definitions --------------------------------------------------------------------------------------- */

static struct command **shelf_of(struct expansion *x, const char *name, int n)
{
    unsigned h = 5381;
    for (int k = 0; k < n; k++)
        h = h * 33 + (unsigned char)name[k];
    return &x->shelf[h % SHELVES];
}

static struct command *command_of(struct expansion *x, const struct slice *t, int a, int b)
{
    for (struct command *c = *shelf_of(x, t->s + a, b - a); c != NULL; c = c->next)
        if (is_word(t, a, b, c->name))
            return c;
    return NULL;
}

static void define(struct expansion *x, const struct slice *t, int a, int b, struct command c)
{
    struct command *one = region_bytes(sizeof *one), **shelf = shelf_of(x, t->s + a, b - a);
    c.name = cagd_text_of(t->s + a, b - a);
    if (one == NULL || c.name == NULL)
        return;
    c.next = *shelf;
    *one = c, *shelf = one;
}

static struct slice literally(const char *text, int offset)
{
    int n = (int)strlen(text), *from = cagd_region_array(n + 1, 1, sizeof *from);
    for (int k = 0; from != NULL && k < n; k++)
        from[k] = offset;
    return (struct slice){text, from, from != NULL ? n : 0, 0};
}

/* One behind another. */
static struct slice chained(const struct slice *a, const char *between, const struct slice *b, const char *after)
{
    cagd_latex_text all = {0};
    struct slice first = literally(between, a->n > 0 ? from_of(a, 0) : 0), last = literally(after, first.offset);
    put_slice(&all, a, 0, a->n);
    put_slice(&all, &first, 0, first.n);
    put_slice(&all, b, 0, b->n);
    put_slice(&all, &last, 0, last.n);
    return (struct slice){all.bytes, all.from, all.size, 0};
}

/* \newcommand*{\name}[2][optional]{body}: what is behind it, or -1. */
static int new_command(struct expansion *x, const struct slice *t, int k, int keeps)
{
    int a, b, is;
    struct slice number;
    struct command c = {0};
    k = behind_blanks(t, k);
    k += k < t->n && t->s[k] == '*';
    if ((k = name_at(t, k, &a, &b)) < 0)
        return -1;
    k = option_at(x, t, k, &number, &is);
    c.parameters = is && number.n == 1 && isdigit((unsigned char)number.s[0]) ? number.s[0] - '0' : 0;
    if (is && c.parameters > 0)
        k = option_at(x, t, k, &c.optional, &c.has_optional);
    if ((k = argument_at(x, t, k, &c.body)) >= 0 && !(keeps && command_of(x, t, a, b) != NULL))
        define(x, t, a, b, c);
    return k;
}

/* \def\name#1#2{body}; with anything else between the parameters it is none that is understood, and is passed over. */
static int def(struct expansion *x, const struct slice *t, int k)
{
    int a, b, good = 1;
    struct command c = {0};
    if ((k = name_at(t, k, &a, &b)) < 0)
        return -1;
    while (k < t->n && t->s[k] != '{' && ++x->work < MOST_WORK) {
        if (t->s[k] == '#' && k + 1 < t->n && t->s[k + 1] == '1' + c.parameters && c.parameters < MOST_PARAMETERS)
            c.parameters++, k += 2;
        else
            good &= is_blank(t->s[k]), k = behind_token(t, k);
    }
    if ((k = argument_at(x, t, k, &c.body)) >= 0 && good)
        define(x, t, a, b, c);
    return k;
}

/* \DeclareMathOperator*{\name}{text}: \operatorname{text}. */
static int operator(struct expansion *x, const struct slice *t, int k)
{
    int a, b;
    struct slice text;
    k = behind_blanks(t, k);
    k += k < t->n && t->s[k] == '*';
    if ((k = name_at(t, k, &a, &b)) < 0 || (k = argument_at(x, t, k, &text)) < 0)
        return -1;
    struct slice before = literally("\\operatorname{", from_of(t, a));
    define(x, t, a, b, (struct command){.body = chained(&before, "", &text, "}")});
    return k;
}

/* \DeclarePairedDelimiter{\name}{left}{right}: \name{x} and \name*{x} are left x right. */
static int delimiters(struct expansion *x, const struct slice *t, int k)
{
    int a, b;
    struct slice left, right;
    if ((k = name_at(t, k, &a, &b)) < 0 || (k = argument_at(x, t, k, &left)) < 0 ||
        (k = argument_at(x, t, k, &right)) < 0)
        return -1;
    define(x, t, a, b, (struct command){.parameters = 1, .starred = 1, .body = chained(&left, " #1 ", &right, "")});
    return k;
}

/* \NewDocumentCommand{\name}{m m}{body}, where all parameters are such as have to be given. */
static int document_command(struct expansion *x, const struct slice *t, int k)
{
    int a, b, good = 1;
    struct slice given;
    struct command c = {0};
    if ((k = name_at(t, k, &a, &b)) < 0 || (k = argument_at(x, t, k, &given)) < 0 ||
        (k = argument_at(x, t, k, &c.body)) < 0)
        return -1;
    for (int m = 0; m < given.n; m++) {
        c.parameters += given.s[m] == 'm';
        good &= given.s[m] == 'm' || is_blank(given.s[m]);
    }
    if (good && c.parameters <= MOST_PARAMETERS)
        define(x, t, a, b, c);
    return k;
}

/* \let\name=\other: what \other stands for now. */
static int let(struct expansion *x, const struct slice *t, int k)
{
    int a, b, c, d;
    if ((k = name_at(t, k, &a, &b)) < 0)
        return -1;
    k = behind_blanks(t, k);
    k += k < t->n && t->s[k] == '=';
    if ((k = name_at(t, k, &c, &d)) < 0)
        return -1;
    const struct command *same = command_of(x, t, c, d);
    define(x, t, a, b, same != NULL ? *same : (struct command){.body = part_of(t, c, d)});
    return k;
}

/* A definition at a..b: what is behind it; 0 where it is none, and -1 where it is broken. */
static int definition(struct expansion *x, const struct slice *t, int a, int b)
{
    if (is_word(t, a, b, "\\newcommand") || is_word(t, a, b, "\\renewcommand"))
        return new_command(x, t, b, 0);
    if (is_word(t, a, b, "\\providecommand"))
        return new_command(x, t, b, 1);
    if (is_word(t, a, b, "\\def") || is_word(t, a, b, "\\gdef"))
        return def(x, t, b);
    if (is_word(t, a, b, "\\DeclareMathOperator"))
        return operator(x, t, b);
    if (is_word(t, a, b, "\\DeclarePairedDelimiter"))
        return delimiters(x, t, b);
    if (is_word(t, a, b, "\\NewDocumentCommand") || is_word(t, a, b, "\\RenewDocumentCommand") ||
        is_word(t, a, b, "\\DeclareDocumentCommand"))
        return document_command(x, t, b);
    return is_word(t, a, b, "\\let") ? let(x, t, b) : 0;
}

/* ---- expansion ----------------------------------------------------------------------------------------- */

/* Whether a letter put behind the text would be taken for one of the command that ends it. */
static int ends_in_command(const cagd_latex_text *t)
{
    int k = t->size;
    while (k > 0 && t->size - k <= LONGEST_COMMAND && is_letter(t->bytes[k - 1]))
        k--;
    return k > 0 && k < t->size && t->bytes[k - 1] == '\\';
}

static void put_apart(cagd_latex_text *out, const struct slice *t)
{
    if (t->n > 0 && is_letter(t->s[0]) && ends_in_command(out))
        cagd_latex_put(out, ' ', from_of(t, 0));
    put_slice(out, t, 0, t->n);
}

/* The body with the arguments in their places; what comes from the body, comes from where the command was called. */
static struct slice substituted(const struct command *c, const struct slice argument[], int at)
{
    cagd_latex_text text = {0};
    for (int k = 0; k < c->body.n; k++) {
        int number = c->body.s[k] == '#' && k + 1 < c->body.n ? c->body.s[k + 1] - '1' : -1;
        if (number >= 0 && number < c->parameters)
            put_apart(&text, &argument[number]), k++;
        else if (k > 0 && is_letter(c->body.s[k]) && !is_letter(c->body.s[k - 1]) && c->body.s[k - 1] != '\\' &&
                 ends_in_command(&text))
            cagd_latex_put(&text, ' ', at), cagd_latex_put(&text, c->body.s[k], at);
        else
            cagd_latex_put(&text, c->body.s[k], at);
        if (text.size > MOST_OF_ONE)
            break;
    }
    return (struct slice){text.bytes, text.from, text.size, 0};
}

static void expand(struct expansion *x, const struct slice *t, int depth);

/* The call of c at a..b: what is behind its arguments, or -1 where they are not there, or where it does not end. */
static int call(struct expansion *x, const struct slice *t, const struct command *c, int a, int b, int depth)
{
    struct slice argument[MOST_PARAMETERS], ignored;
    int is = 0, k = b;
    if (c->starred) {
        k += k < t->n && t->s[k] == '*';
        k = option_at(x, t, k, &ignored, &is);
    }
    for (int m = 0; m < c->parameters; m++) {
        argument[m] = c->optional;
        if (m == 0 && c->has_optional)
            k = option_at(x, t, k, &argument[m], &is);
        else if ((k = argument_at(x, t, k, &argument[m])) < 0)
            return -1;
    }
    x->work += c->body.n + EACH_CALL;
    for (int m = 0; m < c->parameters; m++)
        x->work += argument[m].n;
    if (++x->calls > MOST_CALLS || depth == MOST_DEPTH || x->out->size > x->limit || x->work >= MOST_WORK) {
        x->overflow = 1;
        return -1;
    }
    struct slice body = substituted(c, argument, depth == 0 ? from_of(t, a) : x->at);
    expand(x, &body, depth + 1);
    return x->overflow ? -1 : k;
}

/* The call of the source at a..b.  One that does not end is taken back and left as it stands. */
static int outermost(struct expansion *x, const struct slice *t, struct command *c, int a, int b)
{
    int size = x->out->size, k = -1;
    x->calls = 0, x->overflow = c->endless;
    x->at = from_of(t, a);
    x->limit = size + MOST_OF_ONE;
    if (!c->endless)
        k = call(x, t, c, a, b, 0);
    if (k < 0 && x->overflow) {
        x->out->size = size;
        c->endless = 1;
        cagd_latex_refuse(x->troubles, from_of(t, a), from_of(t, b - 1) + 1,
                          "the expansion of this command does not end");
        if (x->troubles->troubles > 0)
            x->troubles->trouble[x->troubles->troubles - 1].is_command = 1;
    }
    x->overflow = 0;
    return k;
}

/* "cagd:" behind the percent sign at k. */
static int is_note(const struct slice *t, int k)
{
    for (k++; k < t->n && (t->s[k] == ' ' || t->s[k] == '\t' || t->s[k] == '%'); k++)
        ;
    return t->n - k >= 5 && memcmp(t->s + k, "cagd:", 5) == 0;
}

/* Behind the end of an environment whose text is no LaTeX, which begins at k; 0 where none begins there. */
static int behind_verbatim(const struct slice *t, int k)
{
    static const char *const names[] = {"verbatim}", "verbatim*}", "Verbatim}",     "lstlisting}",
                                        "minted}",   "comment}",   "filecontents}", "filecontents*}"};
    int n = (int)strlen("\\begin{");
    for (size_t m = 0; m < sizeof names / sizeof *names; m++) {
        int length = (int)strlen(names[m]);
        if (t->n - k < n + length || memcmp(t->s + k + n, names[m], (size_t)length) != 0)
            continue;
        for (int end = k + n + length; end < t->n; end++)
            if (t->n - end >= 5 + length && memcmp(t->s + end, "\\end{", 5) == 0 &&
                memcmp(t->s + end + 5, names[m], (size_t)length) == 0)
                return end + 5 + length;
        return t->n;
    }
    return 0;
}

/* \verb|...|: behind it. */
static int behind_verb(const struct slice *t, int k)
{
    k += k < t->n && t->s[k] == '*';
    const char *end = k < t->n ? memchr(t->s + k + 1, t->s[k], (size_t)(t->n - k - 1)) : NULL;
    return end != NULL ? (int)(end - t->s) + 1 : t->n;
}

/* Whether a conditional of TeX stands at a..b, which ends with \fi.  These begin alike and have no \fi. */
static int is_conditional(const struct slice *t, int a, int b)
{
    static const char *const others[] = {"\\iff",        "\\ifthenelse", "\\ifbool",      "\\iftoggle",
                                         "\\ifdef",      "\\ifundef",    "\\ifblank",     "\\ifstrequal",
                                         "\\ifstrempty", "\\ifdefempty", "\\ifdefstring", "\\ifcsdef"};
    if (b - a <= 3 || memcmp(t->s + a, "\\if", 3) != 0)
        return 0;
    for (size_t k = 0; k < sizeof others / sizeof *others; k++)
        if (is_word(t, a, b, others[k]))
            return 0;
    return 1;
}

/* From k on: the \fi that belongs to what began before k, others being inside, goes to a..b; or the \else before it, where `asked`.  0 where
 * there is none. */
static int end_of_conditional(struct expansion *x, const struct slice *t, int k, int asked, int *a, int *b)
{
    for (int next, depth = 0; k < t->n && ++x->work < MOST_WORK; k = next) {
        next = t->s[k] == '%' ? behind_comment(t, k) : behind_token(t, k);
        int is_fi = is_word(t, k, next, "\\fi");
        if (depth == 0 && (is_fi || (asked && is_word(t, k, next, "\\else")))) {
            *a = k, *b = next;
            return 1;
        }
        depth += is_conditional(t, k, next) - is_fi;
    }
    return 0;
}

/* Behind \iffalse ... \fi, or \iffalse ... \else, of which \iffalse is at a..b.  What stands behind \else is read, and the \fi behind that is
 * passed over. */
static int behind_false(struct expansion *x, const struct slice *t, int a, int b, int depth)
{
    int from, to, fi, behind;
    if (!end_of_conditional(x, t, b, 1, &from, &to)) {
        if (depth == 0)
            cagd_latex_refuse(x->troubles, from_of(t, a), from_of(t, b - 1) + 1,
                              "this \\iffalse does not end: expected \\fi");
        return t->n;
    }
    if (is_word(t, from, to, "\\fi"))
        return to;
    if (!end_of_conditional(x, t, to, 0, &fi, &behind) || x->fis == MOST_ELSES) {
        cagd_latex_refuse(x->troubles, from_of(t, from), from_of(t, to - 1) + 1,
                          x->fis == MOST_ELSES ? "more than 100 \\else inside of one another"
                                               : "this \\else does not end: expected \\fi");
        return t->n;
    }
    x->fi[x->fis++] = t->s + fi;
    return to;
}

/* Whether the \fi at a is one that is passed over. */
static int is_passed_over(struct expansion *x, const struct slice *t, int a)
{
    for (int k = x->fis; k > 0; k--)
        if (x->fi[k - 1] == t->s + a) {
            x->fis = k - 1;
            return 1;
        }
    return 0;
}

/* ---- arguments without braces ------------------------------------------------------------------------------ */

/* How many arguments the command at a..b takes as TeX's macros do: a command of the author that stands there without braces is one argument, whatever it stands
 * for.  0 for others, among them ^ and accents, which take of what it stands for the first token. */
static int arguments_of(const struct slice *t, int a, int b)
{
    static const char *const of_two[] = {"\\frac",  "\\dfrac",  "\\tfrac",  "\\cfrac",   "\\nicefrac", "\\sfrac",
                                         "\\binom", "\\dbinom", "\\tbinom", "\\overset", "\\underset", "\\stackrel"};
    static const char *const of_one[] = {"\\mathbf",     "\\mathrm",    "\\mathit",      "\\mathcal", "\\mathbb",
                                         "\\mathfrak",   "\\mathscr",   "\\mathsf",      "\\mathtt",  "\\bm",
                                         "\\pmb",        "\\text",      "\\boldsymbol",  "\\boxed",   "\\underline",
                                         "\\underbrace", "\\overbrace", "\\operatorname"};
    for (size_t k = 0; k < sizeof of_two / sizeof *of_two; k++)
        if (is_word(t, a, b, of_two[k]))
            return 2;
    for (size_t k = 0; k < sizeof of_one / sizeof *of_one; k++)
        if (is_word(t, a, b, of_one[k]))
            return 1;
    return 0;
}

static void open_level(struct expansion *x, char close, int awaited, int from)
{
    if (x->levels == MOST_LEVELS) {
        cagd_latex_refuse(x->troubles, from, from + 1, "more than 1000 braces inside of one another");
        x->levels = 0;
    }
    x->level[x->levels++] = (struct level){close, awaited};
    x->awaited = x->option = 0;
}

/* With a brace end the brackets inside of it that did not. */
static void close_level(struct expansion *x, char close)
{
    x->awaited = x->option = 0;
    while (x->levels > 0) {
        const struct level *last = &x->level[--x->levels];
        if (last->close == close) {
            x->awaited = last->awaited;
            return;
        }
    }
}

/* What the character that comes out next is to the command whose arguments are awaited. */
static void count_character(struct expansion *x, char c, int from)
{
    if (c == '{') {
        open_level(x, '}', x->awaited > 0 ? x->awaited - 1 : 0, from);
    } else if (c == '[' && x->option > 0) {
        open_level(x, ']', x->option, from);
    } else if (c == '}' || (c == ']' && x->levels > 0 && x->level[x->levels - 1].close == ']')) {
        close_level(x, c);
    } else if (!is_blank(c)) {
        x->awaited -= x->awaited > 0;
        x->option = 0;
    }
}

/* A command of the author where an argument is awaited: \frac\lt2 is \frac{\lt}2.  It gets no arguments of its own there. */
static int call_as_argument(struct expansion *x, const struct slice *t, struct command *c, int a, int b, int depth)
{
    struct slice alone = part_of(t, a, b);
    int from = from_of(t, a), size = x->out->size;
    if (c->parameters > c->has_optional) {
        cagd_latex_refuse(
            x->troubles, from, from_of(t, b - 1) + 1,
            "as an argument this command gets none of its own: expected braces around it and its arguments");
        return -1;
    }
    cagd_latex_put(x->out, '{', from);
    count_character(x, '{', from);
    int end = depth == 0 ? outermost(x, &alone, c, 0, b - a) : call(x, &alone, c, 0, b - a, depth);
    if (end < 0)
        x->out->size = size;
    else
        cagd_latex_put(x->out, '}', from);
    close_level(x, '}');
    return end < 0 ? -1 : b;
}

/* The command at a..b; what is behind it and what it takes. */
static int expand_command(struct expansion *x, const struct slice *t, int a, int b, int depth)
{
    int end = definition(x, t, a, b);
    if (end > 0)
        return end;
    if (is_word(t, a, b, "\\iffalse"))
        return behind_false(x, t, a, b, depth);
    if (is_word(t, a, b, "\\fi") && is_passed_over(x, t, a))
        return b;
    if (depth == 0 && is_word(t, a, b, "\\verb"))
        return behind_verb(t, b);
    if (depth == 0 && is_word(t, a, b, "\\begin") && (end = behind_verbatim(t, a)) > 0)
        return end;
    if (depth == 0 && is_word(t, a, b, "\\begin") && t->n - b >= 10 && memcmp(t->s + b, "{document}", 10) == 0)
        x->in_body = 1;
    if (depth == 0 && is_word(t, a, b, "\\end") && t->n - b >= 10 && memcmp(t->s + b, "{document}", 10) == 0)
        return t->n;
    struct command *c = x->in_body ? command_of(x, t, a, b) : NULL;
    x->option = 0;
    if (c != NULL && x->awaited > 0)
        end = call_as_argument(x, t, c, a, b, depth);
    else
        end = c == NULL ? -1 : depth == 0 ? outermost(x, t, c, a, b) : call(x, t, c, a, b, depth);
    if (end >= 0)
        return end;
    struct slice word = part_of(t, a, b);
    put_apart(x->out, &word);
    int arguments = arguments_of(t, a, b);
    x->awaited = arguments > 0 ? arguments : x->awaited > 0 ? x->awaited - 1 : 0;
    x->option = is_word(t, a, b, "\\sqrt") ? 1 : is_word(t, a, b, "\\cfrac") ? 2 : 0;
    return b;
}

/* What a comment "cagd:" at k says, the commands of the author expanded, on one line; what is behind it.  Within another one, and in what a command stands for,
 * it is as it stands. */
static int expand_note(struct expansion *x, const struct slice *t, int k, int depth)
{
    int end = k, said = k, in_body = x->in_body, size;
    while (end < t->n && t->s[end] != '\n')
        end++;
    if (depth > 0 || x->in_note) {
        put_slice(x->out, t, k, end);
        return end;
    }
    while (t->s[said] != ':')
        said++;
    put_slice(x->out, t, k, said + 1);
    size = x->out->size;
    struct slice words = part_of(t, said + 1, end);
    int awaited = x->awaited, option = x->option, levels = x->levels;
    x->in_body = 1; /* before \begin{document}, too */
    x->in_note = 1;
    x->awaited = x->option = 0;
    expand(x, &words, 0);
    x->in_body = in_body, x->in_note = 0;
    x->awaited = awaited, x->option = option;
    x->levels = levels;
    for (; size < x->out->size; size++)
        if (x->out->bytes[size] == '\n')
            x->out->bytes[size] = ' ';
    return end;
}

static void expand(struct expansion *x, const struct slice *t, int depth)
{
    int apart = 1; /* a letter must not become one of a command before it */
    for (int k = 0, next;
         k < t->n && !x->overflow && x->out->size < CAGD_LATEX_LARGEST && x->work < MOST_WORK && region_faults == 0;
         k = next) {
        next = behind_token(t, k);
        if (t->s[k] == '%' && is_note(t, k)) {
            next = expand_note(x, t, k, depth);
        } else if (t->s[k] == '%') {
            next = behind_comment(t, k);
        } else if (t->s[k] == '\\' && next > k + 1) {
            next = expand_command(x, t, k, next, depth);
            apart = 1;
        } else {
            struct slice token = part_of(t, k, next);
            count_character(x, t->s[k], from_of(t, k));
            if (apart)
                put_apart(x->out, &token);
            else
                put_slice(x->out, t, k, next);
            apart = 0;
        }
    }
}

/* Before \begin{document}, where there is one, commands are defined and none is called. */
void cagd_expand_latex(const char *source, int size, cagd_latex_text *out, cagd_latex *troubles)
{
    struct expansion *x = region_bytes(sizeof *x);
    struct slice all = {source, NULL, size, 0};
    if (x == NULL)
        return;
    memset(x, 0, sizeof *x);
    x->out = out, x->troubles = troubles, x->in_body = 1;
    for (int k = 0; k + 16 <= size && x->in_body; k++)
        x->in_body = memcmp(source + k, "\\begin{document}", 16) != 0;
    expand(x, &all, 0);
    if (x->work >= MOST_WORK)
        cagd_latex_refuse(troubles, 0, 1, "it takes too long to expand its commands");
    if (out->size >= CAGD_LATEX_LARGEST)
        cagd_latex_refuse(troubles, 0, 1, "with its commands expanded it is larger than 8 MB");
}
