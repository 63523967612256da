#include "cli/check/document.h"

#include "chapters/judge/register.h"
#include "cli/check/paper.h"
#include "cli/input.h"
#include "cli/refuse.h"
#include "cli/terminal.h"
#include "exact/expression/bounds.h"
#include "exact/expression/evaluate.h"
#include "exact/expression/standard.h"
#include "exact/words.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_COMPLAINTS = 20, WIDEST = 100, LONGEST_SHOWN = 4000, MESSAGE = 400 };
static const double usual_seconds = 10;

const char *const expected_name[] = {"holds", "fails", "undecided"};

/* ---- complaints ---------------------------------------------------------------------------------------- */

static int is_character(const char *s) { return ((unsigned char)*s & 0xC0) != 0x80; }

void count_lines(const struct document *d, const char *text, int at, int *line, int *column)
{
    struct place p = *d->last_place;
    if (p.text != text || p.at > at)
        p = (struct place){text, 0, 1, 1};
    for (; p.at < at; p.at++) {
        p.column += is_character(text + p.at);
        if (text[p.at] == '\n')
            p.line++, p.column = 1;
    }
    *line = p.line, *column = p.column;
    if (text != d->text || at <= d->size) /* what is behind the file's own text changes */
        *d->last_place = p;
}

/* The chunk that the byte is of; NULL where it stands where it comes from. */
static const struct chunk *chunk_at(const struct document *d, int at)
{
    for (int k = 0; k < d->chunks; k++)
        if (d->chunk[k].at <= at && at < d->chunk[k].to)
            return &d->chunk[k];
    return NULL;
}

/* What is meant by a byte of a chunk, and by the end of bytes. */
static int source_of(const struct chunk *c, int at) { return c->from[at - c->at]; }
static int source_end(const struct chunk *c, int from, int to)
{
    int end = to > from && to <= c->to ? source_of(c, to - 1) + 1 : 0, begin = source_of(c, from);
    return end > begin ? end : begin + 1;
}

const char *place_of(const struct document *d, int at, int *line, int *column)
{
    const struct chunk *c = chunk_at(d, at);
    count_lines(d, c != NULL ? c->source : d->text, c != NULL ? source_of(c, at) : at, line, column);
    return c != NULL ? c->path : d->path;
}

/* A piece of a line with blanks for tabs and for what else takes no column. */
static const char *with_blanks(const char *text, int length)
{
    char *copy = region_bytes((size_t)length + 1);
    for (int k = 0; copy != NULL && k < length; k++)
        copy[k] = iscntrl((unsigned char)text[k]) ? ' ' : text[k];
    if (copy != NULL)
        copy[length] = '\0';
    return copy;
}

/* Of a line that people write: of a wide one the columns about the bytes, between dots; and a caret under the bytes. */
static void show_place(const char *text, int size, int from, int to)
{
    static const char dots[] = "…";
    int begin = from, end = from;
    while (begin > 0 && text[begin - 1] != '\n')
        begin--;
    while (end < size && text[end] != '\n')
        end++;
    const char *whole = end - begin <= LONGEST_SHOWN ? with_blanks(text + begin, end - begin) : NULL;
    if (whole == NULL)
        return;
    const char *left = whole, *right = whole + (end - begin), *mark = whole + (from - begin);
    while (columns_between(left, right) > WIDEST && columns_between(left, mark) > WIDEST / 2)
        do
            left++;
        while (!is_character(left));
    while (columns_between(left, right) > WIDEST)
        do
            right--;
        while (!is_character(right));
    const char *before = left > whole ? dots : "", *behind = right < whole + (end - begin) ? dots : "";
    fprintf(stderr, "  %s%.*s%s\n  ", before, (int)(right - left), left, behind);
    for (int k = columns_of(before) + columns_between(left, mark); k > 0; k--)
        fputc(' ', stderr);
    fputc('^', stderr);
    for (int k = from + 1; k < to && k < end && k < begin + (int)(right - whole); k++)
        if (is_character(text + k))
            fputc('~', stderr);
    fputc('\n', stderr);
}

static void tell_in(const struct document *d, const char *path, const char *text, int size, int from, int to,
                    const char *message)
{
    int line, column;
    count_lines(d, text, from, &line, &column);
    refuse_line("%s:%d:%d: %s", name_of_input(path), line, column, message);
    show_place(text, size, from, to);
}

static void tell(struct document *d, int from, int to, const char *message)
{
    const struct chunk *c = chunk_at(d, from < to || from == 0 ? from : from - 1);
    if (c != NULL) { /* the end of a formula is behind its last byte */
        int at = from < to ? source_of(c, from) : source_of(c, from > c->at ? from - 1 : from) + 1;
        tell_in(d, c->path, c->source, c->size, at, from < to ? source_end(c, from, to) : at + 1, message);
    } else if (from >= d->size && d->size > 0) { /* of the ledger */
        int line, column;
        count_lines(d, d->text, from, &line, &column);
        refuse_line("%s: %s, column %d: %s", name_of_input(d->path), d->entry, column, message);
        show_place(d->text, d->used, from, to);
    } else {
        tell_in(d, d->path, d->text, d->used, from, to, message);
    }
}

/* Whether there is room for one more complaint, and its message. */
static int compose(struct document *d, char message[MESSAGE], const char *format, va_list list)
{
    if (++d->complaints > MOST_COMPLAINTS)
        return 0;
    vsnprintf(message, MESSAGE, format, list);
    return 1;
}

void complain(struct document *d, int from, int to, const char *format, ...)
{
    char message[MESSAGE];
    va_list list;
    va_start(list, format);
    if (compose(d, message, format, list))
        tell(d, from, to, message);
    va_end(list);
}

void complain_in(struct document *d, const char *path, const char *text, int size, int from, int to, const char *format,
                 ...)
{
    char message[MESSAGE];
    va_list list;
    va_start(list, format);
    if (compose(d, message, format, list))
        tell_in(d, path, text, size, from, to, message);
    va_end(list);
}

/* In a LaTeX source comments take the place of blocks. */
static const char *in_words_of_paper(const struct document *d, const cagd_reading_error *e, const char *message)
{
    static const char begin[] = "; a line '", end[] = "' in a let block makes it a variable";
    static const char whole[] = "' in a let block makes it a whole number", range[] = "; ':for: ";
    const char *line = strstr(message, begin), *stop = line != NULL ? strstr(line, end) : NULL;
    const char *behind = line != NULL ? strstr(line, whole) : NULL, *numbers = strstr(message, range);
    char text[MESSAGE];
    if (chunk_at(d, e->from) != NULL && (behind != NULL || numbers != NULL)) {
        const char *at = behind != NULL ? line : numbers;
        snprintf(text, sizeof text, "%.*s; '%% cagd: %s %.*s", (int)(at - message), message,
                 behind != NULL ? "let" : "for",
                 (int)((behind != NULL ? behind : message + strlen(message)) - at) -
                     (int)(behind != NULL ? strlen(begin) : strlen(range)),
                 at + (behind != NULL ? strlen(begin) : strlen(range)));
        if (behind != NULL)
            snprintf(text + strlen(text), sizeof text - strlen(text), "' makes it a whole number");
        return cagd_text_of(text, (int)strlen(text));
    }
    if (chunk_at(d, e->from) == NULL || stop == NULL)
        return message;
    int n =
        snprintf(text, sizeof text,
                 "%.*s; '%% cagd: let %.*s' makes it a variable, '%% cagd: definition' says that a formula defines it",
                 (int)(line - message), message, (int)(stop - line - (int)strlen(begin)), line + strlen(begin));
    return n < MESSAGE ? cagd_text_of(text, n) : message;
}

void remark_in(struct document *d, const char *path, const char *text, int size, int from, int to, const char *message)
{
    tell_in(d, path, text, size, from, to, message);
}

/* What was not read; a command whose expansion does not end is no name that is not known. */
static const char *message_of(const struct document *d, const cagd_reading_error *e)
{
    const struct chunk *c = chunk_at(d, e->from);
    const char *better = c != NULL ? trouble_of_command(d, c->source, source_of(c, e->from)) : NULL;
    return better != NULL ? better : in_words_of_paper(d, e, cagd_text_of(e->message, (int)strlen(e->message)));
}

/* The letter at `at` with what is above it, up to its indices and arguments, \bar{P} of \bar{P}_i = ...: its length. */
static int length_of_head(const char *text, int from, int to)
{
    int depth = 0, at = from;
    for (; at < to && (depth > 0 || strchr("_^('=, \n", text[at]) == NULL); at++)
        depth += (text[at] == '{') - (text[at] == '}');
    return at - from;
}

/* Whether the name was to be defined by a line that could not be read: that line was told, and is what is to be mended. */
static int is_of_failed(const struct document *d, const cagd_reading_error *e)
{
    if (strstr(e->message, " is not defined") == NULL && strstr(e->message, " is no function with arguments") == NULL)
        return 0;
    for (int k = 0; k < d->faileds; k++) {
        const char *head = d->failed[k];
        const int n = (int)strlen(head);
        if (strncmp(e->message, head, (size_t)n) == 0 && strchr("_^(' ", e->message[n]) != NULL)
            return 1;
    }
    return 0;
}

static void complain_of_reading(struct document *d, const cagd_reading_error *e)
{
    if (is_of_failed(d, e))
        d->complaints++;
    else
        complain(d, e->from, e->to, "%s", message_of(d, e));
}

static void complain_of_definition(struct document *d, int from, int to, const cagd_reading_error *e)
{
    complain_of_reading(d, e);
    const char *head = cagd_text_of(d->text + from, length_of_head(d->text, from, to));
    if (head != NULL && head[0] != '\0' && d->faileds < MOST_WAITING)
        d->failed[d->faileds++] = head;
}

/* A formula that nobody asked for: told, and not counted as a complaint. */
static void leave_out(struct document *d, const char *name, int head, const cagd_reading_error *e)
{
    char message[MESSAGE];
    struct left_out *l = &d->left_out[d->left_outs];
    if (d->left_outs == MOST_STATEMENTS)
        return;
    d->left_outs++;
    *l = (struct left_out){.name = name, .message = message_of(d, e)};
    place_of(d, e->from < e->to ? e->from : head, &l->line, &l->column);
    snprintf(message, sizeof message, "%s is left out: %s", name, l->message);
    tell(d, e->from, e->to, message);
}

/* ---- lines --------------------------------------------------------------------------------------------- */

/* The end of the line at `at`, and where the next begins. */
static int end_of_line(const struct document *d, int at)
{
    const char *end = memchr(d->text + at, '\n', (size_t)(d->size - at));
    return end != NULL ? (int)(end - d->text) : d->size;
}
static int next_line(const struct document *d, int at)
{
    int end = end_of_line(d, at);
    return end < d->size ? end + 1 : end;
}

static int begins(const struct document *d, int at, const char *word)
{
    int n = (int)strlen(word);
    return d->size - at >= n && memcmp(d->text + at, word, (size_t)n) == 0;
}

/* Which of the words stands at `at`, or ends at `at`. */
static int starts_with_one_of(const struct document *d, int at, const char *const words[])
{
    for (int k = 0; words[k] != NULL; k++)
        if (begins(d, at, words[k]))
            return 1;
    return 0;
}
static int ends_with_one_of(const struct document *d, int from, int at, const char *const words[])
{
    for (int k = 0; words[k] != NULL; k++)
        if (at - (int)strlen(words[k]) >= from && begins(d, at - (int)strlen(words[k]), words[k]))
            return 1;
    return 0;
}

/* What of a formula is open behind its first lines. */
struct opened {
    int groups, environments, dollars;
};

static void count_opened(const struct document *d, int from, int to, struct opened *o)
{
    for (int k = from; k < to; k++) {
        const int is_command = d->text[k] == '\\', is_display = begins(d, k, "$$");
        o->environments +=
            begins(d, k, "\\begin{") - begins(d, k, "\\end{") + begins(d, k, "\\[") - begins(d, k, "\\]");
        o->dollars += is_display;
        o->groups += (d->text[k] == '{') - (d->text[k] == '}');
        k += is_command || is_display; /* behind \\{, too */
    }
}

/* Whether the line at `next` goes on with the entry that begins at `at` and has come to `end`: it is indented; what is open goes on, and what ends or goes
 * on with a sign; a formula that is printed, and what it is said for, end with an empty line or another field. */
static int goes_on(const struct document *d, int at, int end, int next, const struct opened *o)
{
    static const char *const fields[] = {":printed:", ":for:", NULL};
    static const char *const ends[] = {"=",    "+",     "-",      "<",       ">", "&",      "\\\\",    "\\le", "\\leq",
                                       "\\ge", "\\geq", "\\cdot", "\\times", ",", "\\quad", "\\qquad", NULL};
    static const char *const begin[] = {"=",      "+",       "<",      ">",       "&",       ")",
                                        "]",      "}",       "\\le ",  "\\leq",   "\\ge ",   "\\geq",
                                        "\\cdot", "\\times", "\\quad", "\\qquad", "\\right", NULL};
    if (d->text[next] == ' ' || d->text[next] == '\t')
        return 1;
    if (isspace((unsigned char)d->text[next]) || d->text[next] == ':')
        return 0;
    if (d->text[at] == ':')
        return starts_with_one_of(d, at, fields);
    return o->groups > 0 || o->environments > 0 || o->dollars % 2 != 0 || ends_with_one_of(d, at, end, ends) ||
           starts_with_one_of(d, next, begin);
}

/* The end of what begins in the line at `at`: of the last line that goes on with it, blanks at the end left out. */
static int end_of_entry(const struct document *d, int at, int stop)
{
    struct opened o = {0};
    int end = at;
    for (int k = at, to; k == at || k < stop; k = next_line(d, k)) {
        if (k > at && (end == at || !goes_on(d, at, end, k, &o)))
            break;
        to = end_of_line(d, k);
        count_opened(d, k, to, &o);
        while (to > k && isspace((unsigned char)d->text[to - 1]))
            to--;
        end = to > k ? to : end;
    }
    return end;
}

/* Whether a dollar sign stands outside of groups; in \text{if $x > 0$} it belongs to the text. */
static int has_dollar(const char *text, int length)
{
    for (int k = 0, depth = 0; k < length; k++) {
        depth += (text[k] == '{') - (text[k] == '}');
        if (text[k] == '$' && depth == 0)
            return 1;
    }
    return 0;
}

/* Without blanks and dollar signs around. */
static void strip(const struct document *d, int *from, int *to)
{
    while (*from < *to && isspace((unsigned char)d->text[*from]))
        ++*from;
    while (*to > *from && isspace((unsigned char)d->text[*to - 1]))
        --*to;
    if (*to - *from >= 4 && strncmp(d->text + *from, "$$", 2) == 0 && strncmp(d->text + *to - 2, "$$", 2) == 0)
        ++*from, --*to; /* as displayed */
    if (*to - *from >= 4 && d->text[*from] == '\\' && d->text[*to - 2] == '\\' &&
        ((d->text[*from + 1] == '(' && d->text[*to - 1] == ')') ||
         (d->text[*from + 1] == '[' && d->text[*to - 1] == ']')))
        *from += 2, *to -= 2; /* \( \) and \[ \] */
    if (*to - *from >= 2 && d->text[*from] == '$' && d->text[*to - 1] == '$' &&
        !has_dollar(d->text + *from + 1, *to - *from - 2))
        ++*from, --*to;
}

/* The next line that is not empty and where its entry ends; 0 at the end of the block. */
static int next_entry(const struct document *d, int *at, int stop, int *end)
{
    while (*at < stop && end_of_entry(d, *at, next_line(d, *at)) <= *at)
        *at = next_line(d, *at);
    if (*at >= stop)
        return 0;
    *end = end_of_entry(d, *at, stop);
    return 1;
}

static int behind(const struct document *d, int end) { return next_line(d, end); }

/* ---- blocks -------------------------------------------------------------------------------------------- */

/* ":key: value": 1, and where the value is. */
static int field(const struct document *d, int at, int end, const char *key, int *from, int *to)
{
    int n = (int)strlen(key);
    if (d->text[at] != ':' || !begins(d, at + 1, key) || at + n + 1 >= end || d->text[at + n + 1] != ':')
        return 0;
    *from = at + n + 2, *to = end;
    strip(d, from, to);
    return 1;
}

/* In a block each of the fields has one value: a second one is refused, for one of the two would not be read.  So is a second formula, which
 * :printed: and :from: are. */
static void refuse_second_fields(struct document *d, int at, int stop)
{
    enum { FORMULA };
    static const char *const key[] = {"printed", "for", "find", "expected", "seconds", "part", "functions", "at"};
    enum { KEYS = sizeof key / sizeof *key };
    int seen[KEYS] = {0}, from, to;
    for (int end; next_entry(d, &at, stop, &end); at = behind(d, end))
        for (int k = 0; k < KEYS; k++) {
            if (!field(d, at, end, key[k], &from, &to) && !(k == FORMULA && field(d, at, end, "from", &from, &to)))
                continue;
            int again = seen[k]++ > 0;
            if (again && k == FORMULA)
                complain(d, at, from, "a second formula of this statement: each has a block of its own");
            else if (again)
                complain(d, at, from, "a second line :%s: of this block: expected one, with all that it says", key[k]);
        }
}

/* A function that every text has, under the letters of this one: the lines that it stands for are read. */
static void read_use(struct document *d, int from, int to)
{
    char message[CAGD_STANDARD_MESSAGE];
    const char *line = cagd_standard(&d->scope, d->text + from, to - from, message);
    if (line == NULL)
        complain(d, from, to, "%s", message);
    while (line != NULL && *line != '\0') {
        cagd_reading_error error;
        int length = (int)strcspn(line, "\n"), begin = d->used;
        if (!put_in_document(d, line, length) || !put_in_document(d, "\n", 1)) {
            complain(d, from, to, "there is no room for more");
            return;
        }
        if (!cagd_read_definition(&d->scope, d->text, begin, begin + length, &error)) {
            for (char *c = error.message; *c != '\0'; c++) /* the letter over which is summed is none of the line's */
                if (c[0] == '_' && c[1] != '\0' && strchr("jklm", c[1]) != NULL && c[2] == ' ')
                    c[1] = 'i';
            complain(d, from, to, "%s", error.message);
            return;
        }
        line += length + 1;
    }
}

/* Whether every line of the block can be read in its order, as far as that is asked of lines by themselves: not of :use: and :from:. */
static int is_in_order(const struct document *d, int at, int stop)
{
    cagd_scope scope = d->scope;
    cagd_reading_error error;
    for (int end; next_entry(d, &at, stop, &end); at = behind(d, end)) {
        int from = at, to = end;
        strip(d, &from, &to);
        if (d->text[at] == ':' || !cagd_read_definition(&scope, d->text, from, to, &error))
            return d->text[at] == ':';
    }
    return 1;
}

/* ---- definitions that wait ------------------------------------------------------------------------------- */

/* Whether a line that waits defines the same name: of several definitions the first that fits is taken, so that they keep their order. */
static int is_of_one_that_waits(const struct document *d, int from, int to)
{
    for (int k = 0; k < d->waits; k++)
        if (cagd_define_same(&d->scope, d->text, from, to, d->waiting[k].from, d->waiting[k].to))
            return 1;
    return 0;
}

static void complain_of_waiting(struct document *d)
{
    for (int k = 0; k < d->waits; k++) {
        struct waiting *w = &d->waiting[k];
        if (cagd_read_definition(&d->scope, d->text, w->from, w->to, &w->error))
            continue; /* it had waited for an earlier one of its name */
        if (w->left_out != NULL)
            leave_out(d, w->left_out, w->from, &w->error);
        else
            complain_of_definition(d, w->from, w->to, &w->error);
    }
    d->waits = 0;
}

/* Those that can be read by now. */
static void read_waiting(struct document *d)
{
    for (int k = 0; k < d->waits; k++) {
        struct waiting w = d->waiting[k];
        cagd_reading_error error;
        int others = d->waits;
        d->waits = k; /* those before it */
        int stays =
            is_of_one_that_waits(d, w.from, w.to) || !cagd_read_definition(&d->scope, d->text, w.from, w.to, &error);
        d->waits = others;
        if (stays)
            continue;
        memmove(d->waiting + k, d->waiting + k + 1, (size_t)(--d->waits - k) * sizeof *d->waiting);
        k = -1; /* one may wait for another one */
    }
}

/* The definition; where a name in it is not defined it waits. */
static void read_or_wait(struct document *d, int from, int to, const char *left_out)
{
    cagd_reading_error error = {0};
    if (!is_of_one_that_waits(d, from, to) && cagd_read_definition(&d->scope, d->text, from, to, &error)) {
        read_waiting(d);
        return;
    }
    if (error.message[0] != '\0' && strstr(error.message, " is not defined") == NULL)
        complain_of_waiting(d); /* in their order */
    if ((error.message[0] == '\0' || strstr(error.message, " is not defined") != NULL) && d->waits < MOST_WAITING)
        d->waiting[d->waits++] = (struct waiting){from, to, left_out, {0}};
    else if (left_out != NULL)
        leave_out(d, left_out, from, &error);
    else
        complain_of_definition(d, from, to, &error);
}

/* In papers the bounds of a parameter stand behind the formulas: where a line has a name that a line behind it declares, such lines are read
 * first. */
static void read_let(struct document *d, int at, int stop)
{
    int first = !is_in_order(d, at, stop), begin = at;
    d->scope.in_block = 1, d->scope.block = d->scope.variables;
    for (int end; first && next_entry(d, &at, stop, &end); at = behind(d, end)) {
        int from = at, to = end;
        strip(d, &from, &to);
        cagd_read_declaration(&d->scope, d->text, from, to);
    }
    at = begin;
    for (int end; next_entry(d, &at, stop, &end); at = behind(d, end)) {
        int from = at, to = end, a, b;
        strip(d, &from, &to);
        if (field(d, at, end, "use", &a, &b)) {
            read_use(d, a, b);
            read_waiting(d);
            continue;
        }
        if (field(d, at, end, "from", &a, &b) && !put_from_paper(d, a, b, &from, &to))
            continue;
        read_or_wait(d, from, to, NULL);
    }
    d->scope.in_block = 0;
}

/* A formula that defines what it has on its left side, though nobody said that it is to be read. */
static void read_defined(struct document *d, int head, int at, int stop)
{
    int from = at, to = end_of_entry(d, at, stop), name = head + (int)strlen(":::{defined}"),
        name_end = end_of_line(d, head);
    strip(d, &name, &name_end);
    read_or_wait(d, from, to, cagd_text_of(d->text + name, name_end - name));
}

static void read_expected(struct document *d, struct formula *f, int from, int to)
{
    for (int k = 0; k < EXPECT_NOTHING; k++)
        if (to - from == (int)strlen(expected_name[k]) && begins(d, from, expected_name[k])) {
            f->expected = (enum expected)k;
            return;
        }
    complain(d, from, to, "expected holds, fails or undecided, not '%.*s'", to - from > 20 ? 20 : to - from,
             d->text + from);
}

static double seconds_of(struct document *d, int from, int to)
{
    const char *text = cagd_text_of(d->text + from, to - from);
    char *end;
    double seconds = text != NULL ? strtod(text, &end) : 0;
    if (text == NULL || *end != '\0' || !(seconds > 0 && seconds <= 3600))
        complain(d, from, to, "expected the seconds that it may take, at most 3600");
    return seconds;
}

/* A name without indices that stands for all numbers, or for those within its bounds. */
static const char *parameter_named(struct document *d, const cagd_scope *scope, int from, int to)
{
    cagd_reading_error error;
    const cagd_tree *t = cagd_read_value(scope, d->text, from, to, &error);
    if (t == NULL) {
        complain_of_reading(d, &error);
        return NULL;
    }
    const cagd_variable *v = t->head != NULL ? cagd_declared(scope, t->head) : NULL;
    if (t->kind != CAGD_NAME || t->count > 0 || (v != NULL && v->whole) || cagd_defined(scope, t->head) != NULL)
        complain(d, from, to, "expected the name of a variable, without indices");
    return t->head;
}

/* A name of which all values are asked for is no whole number, where it is an index, either. */
static void be_real(cagd_scope *scope, const char *head)
{
    const cagd_variable *v = cagd_declared(scope, head);
    cagd_variable real = v != NULL ? *v : (cagd_variable){0};
    real.real = 1;
    if (v != NULL && !v->whole)
        cagd_declare(scope, real);
}

/* ---- what the ledger has as printed -------------------------------------------------------------------- */

/* Text behind the text of the file, where formulas of the ledger are read; 0 where there is no room. */
int put_in_document(struct document *d, const char *text, int length)
{
    if (d->used + length > 2 * LARGEST_FILE)
        return 0;
    if (length > 0)
        memcpy(d->room + d->used, text, (size_t)length);
    d->used += length;
    return 1;
}

/* The formulas of an entry: all of it, or the k-th between dollar signs; its length, or -1. */
static int formula_of(const char *printed, int k, const char **begin)
{
    const char *dollar = strchr(printed, '$');
    if (dollar == NULL) {
        *begin = printed;
        return k == 1 ? (int)strlen(printed) : -1;
    }
    for (int count = 1; dollar != NULL; count++) {
        const char *end = strchr(dollar + 1, '$');
        if (end == NULL)
            return -1;
        if (count == k) {
            *begin = dollar + 1;
            return (int)(end - dollar - 1);
        }
        dollar = strchr(end + 1, '$');
    }
    return -1;
}

/* The formulas whose numbers stand in text[from..to), with commas between. */
static int put_parts(struct document *d, const char *printed, int from, int to)
{
    int first = 1;
    while (from < to || first) {
        const char *begin;
        char *end;
        long k = from < to ? strtol(d->text + from, &end, 10) : 1;
        int length = k > 0 ? formula_of(printed, (int)k, &begin) : -1;
        if (length < 0 || (!first && !put_in_document(d, ", \\quad ", 8)) || !put_in_document(d, begin, length))
            return 0;
        first = 0;
        from = from < to ? (int)(end - d->text) : to;
        while (from < to && (d->text[from] == ',' || isspace((unsigned char)d->text[from])))
            from++;
    }
    return 1;
}

/* The piece text[from..to) is taken out of what was put since `start`; 0 where it is not there. */
static int take_out(struct document *d, int start, int from, int to)
{
    int length = to - from;
    for (int k = start; k + length <= d->used; k++)
        if (memcmp(d->room + k, d->text + from, (size_t)length) == 0) {
            memmove(d->room + k, d->room + k + length, (size_t)(d->used - k - length));
            d->used -= length;
            return 1;
        }
    return 0;
}

/* Whether it is "i = 0, 1, ..." or "i = 0..3": more than one number behind the sign of equality. */
static int is_list(const char *text, int from, int to)
{
    const char *equal = memchr(text + from, '=', (size_t)(to - from));
    for (const char *p = equal; p != NULL && p + 1 < text + to; p++)
        if (*p == ',' || (p[0] == '.' && p[1] == '.'))
            return 1;
    return 0;
}

/* The byte behind blanks and what is written for one. */
static int behind_spaces(const char *text, int at, int to)
{
    static const char *const spaces[] = {" ", "\n", "\\ ", "\\,", "\\;", "\\:", "\\!", "~", "\\quad", "\\qquad"};
    for (int more = 1; more;) {
        more = 0;
        for (size_t k = 0; k < sizeof spaces / sizeof *spaces; k++) {
            int n = (int)strlen(spaces[k]);
            if (to - at >= n && strncmp(text + at, spaces[k], (size_t)n) == 0 &&
                !(n > 2 && at + n < to && isalpha((unsigned char)text[at + n])))
                at += n, more = 1;
        }
    }
    return at;
}

/* Whether a letter, "=" and a list of numbers stand there: i = 0, 1, 2. */
static int is_list_of_letter(const char *text, int from, int to)
{
    int at = behind_spaces(text, from, to), letter = at;
    at += at < to && text[at] == '\\';
    while (at < to && isalpha((unsigned char)text[at]))
        at++;
    if (at == letter || (text[letter] != '\\' && at > letter + 1))
        return 0;
    at = behind_spaces(text, at, to);
    return at < to && text[at] == '=' && is_list(text, at, to);
}

/* The bracket that begins at `at` ends at the end. */
static int is_last_bracket(const char *text, int at, int to)
{
    int depth = 0;
    for (; at < to; at++) {
        depth += (text[at] == '(') - (text[at] == ')');
        if (depth == 0)
            break;
    }
    return at == to - 1;
}

/* Whether the words are "and" alone, behind which something else is said. */
static int is_and_alone(const char *words)
{
    words += strspn(words, " ,~\\");
    return strncmp(words, "and", 3) == 0 && words[3 + strspn(words + 3, " ,~\\")] == '}';
}

/* Where ranges can begin at `at`, outside of brackets: behind a comma, at words, behind a wide space before a list, in brackets behind a wide space or with a
 * list in them; their end goes to *to.  -1 where they cannot. */
static int ranges_at(const char *text, int from, int at, int *to)
{
    static const char *const words[] = {"\\text{", "\\mbox{", "\\hbox{", "\\textrm{", "\\textnormal{", "\\forall"};
    if (text[at] == ',')
        return at + 1;
    for (size_t k = 0; k < sizeof words / sizeof *words && at > from; k++)
        if (strncmp(text + at, words[k], strlen(words[k])) == 0 && !is_and_alone(text + at + strlen(words[k])))
            return at;
    if (at > from && (strncmp(text + at, "\\quad", 5) == 0 || strncmp(text + at, "\\qquad", 6) == 0) &&
        is_list_of_letter(text, at, *to))
        return behind_spaces(text, at, *to);
    int k = at;
    while (k > from && text[k - 1] == ' ')
        k--;
    if (text[at] != '(' || text[*to - 1] != ')' || at == from)
        return -1;
    if (!(k - from >= 5 && strncmp(text + k - 4, "quad", 4) == 0) &&
        !(is_list_of_letter(text, at + 1, *to - 1) && is_last_bracket(text, at, *to)))
        return -1;
    --*to;
    return at + 1;
}

/* A formula and what stands behind it. */
struct behind {
    const struct document *d;
    const cagd_scope *scope, *known; /* before what stands behind it was read, and with that */
    int from, at, begin,
        stop; /* the formula, from `from` to `at`, and what stands behind it, from `begin` to `stop`, in the text */
};

/* Whether words say, from where it begins up to that byte, that what follows is supposed. */
static int is_supposed_by_words(const struct behind *b, int upto)
{
    static const char *const words[] = {"if", "when", "whenever", "for", "where", "with", "provided", "as long as"};
    for (int at = b->begin; at < upto; at++) {
        const char *open = b->d->text[at] == '{' && at > b->from ? b->d->text + at + 1 : NULL;
        while (open != NULL && (*open == ' ' || *open == ','))
            open++;
        for (size_t k = 0; open != NULL && k < sizeof words / sizeof *words; k++)
            if (strncmp(open, words[k], strlen(words[k])) == 0 && !isalpha((unsigned char)open[strlen(words[k])]))
                return 1;
    }
    return 0;
}

/* Relations of names without meaning, and no equality. */
static int is_order_of_names(const cagd_scope *scope, const cagd_tree *t)
{
    int is = t->kind == CAGD_RELATION && cagd_is_of_plain_names(scope, t);
    for (int k = 0; is && k + 1 < t->count; k++)
        is = t->relation[k] != CAGD_EQUAL;
    return is;
}

/* What stands there and can be said as well as supposed: no bounds of variables, no values, no knots in their order; NULL where there is none. */
static const cagd_tree *unclear_condition(const struct behind *b)
{
    for (int k = b->scope->condition_count; k < b->known->condition_count; k++) {
        const cagd_tree *t = b->known->conditions[k];
        int every = t->kind == CAGD_EVERY_INDEX || t->kind == CAGD_FOR_ALL,
            is = every ? is_order_of_names(b->scope, t->at[t->count - 1]) : cagd_is_range_of_name(b->scope, t, NULL);
        if (!is && !is_supposed_by_words(b, t->from))
            return t;
    }
    for (const cagd_definition *d = b->known->definitions; d != NULL; d = d->next) {
        int is_new = d->left->from >= b->begin && d->left->to <= b->stop;
        if (is_new && d->body != NULL && d->left->arguments == 0 && cagd_declared(b->scope, d->left->head) != NULL &&
            !cagd_is_constant(b->known, d->body) && !is_supposed_by_words(b, d->left->from))
            return d->left;
    }
    return NULL;
}

/* A whole number with an end whose range stands there. */
static int is_range_there(const struct behind *b, const cagd_variable *v)
{
    return v->whole && v->high != NULL && cagd_declared(b->scope, v->head) == NULL &&
           cagd_declared(b->known, v->head) == v;
}

/* Whether anything there, besides the ranges, has that letter as an index. */
static int is_letter_of_conditions(const struct behind *b, const char *letter)
{
    int is = 0;
    for (int k = b->scope->condition_count; k < b->known->condition_count && !is; k++)
        is = cagd_tree_has(b->known->conditions[k], letter);
    for (const cagd_definition *d = b->known->definitions; d != NULL && !is; d = d->next)
        is = d->left->from >= b->begin && d->left->to <= b->stop && cagd_tree_has(d->left, letter);
    for (const cagd_variable *v = b->known->variables; v != NULL && v != b->scope->variables && !is; v = v->next)
        is = !v->whole &&
             ((v->left != NULL && cagd_tree_has(v->left, letter)) ||
              (v->low != NULL && cagd_tree_has(v->low, letter)) || (v->high != NULL && cagd_tree_has(v->high, letter)));
    return is;
}

/* The scope before, with the ranges that stand there and are not those of `letter`, and with the values. */
static cagd_scope without_range_of(const struct behind *b, const char *const letter[], int letters)
{
    enum { MOST = 32 };
    const cagd_variable *list[MOST];
    int count = 0;
    cagd_scope scope = *b->scope;
    scope.definitions = b->known->definitions;
    for (const cagd_variable *v = b->known->variables; v != NULL && v != b->scope->variables && count < MOST;
         v = v->next) {
        int is_left_out = !v->whole;
        for (int k = 0; k < letters; k++)
            is_left_out |= strcmp(v->head, letter[k]) == 0;
        if (!is_left_out)
            list[count++] = v;
    }
    while (count > 0)
        cagd_declare(&scope, *list[--count]);
    return scope;
}

/* The formula t before ranges and what is supposed: what of it is about letters that stand there alone is supposed for all of them.  NULL where the letters of the
 * formula stand in what is supposed by "if", which is to be read with them. */
static const cagd_tree *with_what_is_supposed(const struct behind *b, const cagd_tree *t, cagd_scope *scope)
{
    static const char *const ifs[] = {"{if",       "{ if",       "{when",     "{ when",
                                      "{provided", "{ provided", "{whenever", "{ whenever"};
    const char *own[CAGD_MOST_INDICES];
    int count = 0, by_if = 0;
    for (size_t k = 0; k < sizeof ifs / sizeof *ifs; k++)
        for (int at = b->begin; at < b->stop && at < b->begin + 10; at++)
            by_if |= strncmp(b->d->text + at, ifs[k], strlen(ifs[k])) == 0;
    *scope = *b->known;
    for (const cagd_variable *v = b->known->variables; v != NULL && v != b->scope->variables; v = v->next) {
        cagd_reading_error unused;
        if (!is_range_there(b, v) || !is_letter_of_conditions(b, v->head))
            continue;
        cagd_scope other = without_range_of(b, &v->head, 1);
        if (cagd_read_statement(&other, b->d->text, b->from, b->at, &unused) == NULL) {
            if (by_if)
                return NULL;
            continue;
        }
        if (count < CAGD_MOST_INDICES)
            own[count++] = v->head;
    }
    if (count == 0)
        return t;
    cagd_reading_error unused = {0};
    cagd_scope other = without_range_of(b, own, count);
    other.definitions = b->scope->definitions;
    const cagd_tree *said = cagd_read_statement(&other, b->d->text, b->from, b->at, &unused),
                    *supposed = cagd_read_supposed(&other, b->d->text, b->begin, b->stop, &unused);
    cagd_tree *both = cagd_tree_new(CAGD_IMPLIES, b->from, b->stop, 2);
    if (said == NULL || supposed == NULL || both == NULL || said->kind == CAGD_IMPLIES)
        return t;
    both->at[0] = supposed, both->at[1] = said;
    *scope = other;
    return both;
}

/* A formula with its ranges and a second one behind them, b_i(0) = 0, i = 1, 2, b_i(1) = 1, i = 0, 1: it is asked what is meant, if so many tries find it. */
static void ask_for_second(const struct document *d, const cagd_scope *scope, int from, int at, int begin, int stop,
                           int *tries, cagd_reading_error *asked)
{
    int depth = 0;
    for (int k = begin; k < stop; k++) {
        cagd_scope known = *scope;
        cagd_reading_error unused;
        int to = stop, next = depth == 0 ? ranges_at(d->text, begin, k, &to) : -1;
        if (next < 0 && depth == 0 && k > begin && strncmp(d->text + k, "\\quad", 5) == 0)
            next = k;
        if (next < 0 && depth == 0 && k > begin && strncmp(d->text + k, "\\qquad", 6) == 0)
            next = k;
        depth += (strchr("({[", d->text[k]) != NULL) - (strchr(")}]", d->text[k]) != NULL);
        if (next < 0 || !is_list_of_letter(d->text, begin, k) || --*tries < 0 ||
            !cagd_read_ranges(&known, d->text, begin, k, &unused) ||
            cagd_read_statement(&known, d->text, from, at, &unused) == NULL)
            continue;
        next = behind_spaces(d->text, next, stop);
        if (d->text[next] == ',' || isdigit((unsigned char)d->text[next]) ||
            strncmp(d->text + next, "\\text", 5) == 0 || cagd_read_ranges(&known, d->text, next, stop, &unused))
            continue;
        cagd_refuse_reading(asked, next, stop, "%s", CAGD_SAID_OR_SUPPOSED);
        return;
    }
}

/* Where, behind a relation, words stand a second time that say for what a formula is meant; -1 where they do not. */
static int second_words(const char *text, int from, int to)
{
    int depth = 0, formulas = 0;
    for (int k = from; k < to; k++) {
        if (depth == 0 && k > from && strncmp(text + k, "\\text{", 6) == 0 && formulas > 0) {
            const int word = behind_spaces(text, k + 6, to);
            if (strncmp(text + word, "for", 3) == 0 || strncmp(text + word, "if", 2) == 0 ||
                strncmp(text + word, "when", 4) == 0)
                return k;
        }
        depth += (strchr("({[", text[k]) != NULL) - (strchr(")}]", text[k]) != NULL);
        formulas += depth == 0 && text[k] == '=';
    }
    return -1;
}

/* A formula with ranges behind it, as papers print it, "b_i \ge 0, \quad i = 0, 1, \dots, n": they become known in the scope.  What is
 * before them needs them, or they are no relation.  NULL where it cannot be read so; with such a list of numbers *error is what is wrong before it, or behind it. */
static const cagd_tree *with_ranges_behind(const struct document *d, cagd_scope *scope, int from, int to,
                                           cagd_reading_error *error)
{
    enum { MOST_TRIES = 60, MOST_PLACES = 40 };
    int depth = 0, environments = 0, tries = MOST_TRIES, places = 0;
    cagd_reading_error asked = {0};
    while (to > from && strchr(" \n.,;", d->text[to - 1]) != NULL)
        to--;
    for (int at = from; at < to; at++) {
        cagd_reading_error unused;
        cagd_scope known = *scope, other;
        int stop = to, begin = depth == 0 ? ranges_at(d->text, from, at, &stop) : -1;
        environments += (strncmp(d->text + at, "\\begin{", 7) == 0) - (strncmp(d->text + at, "\\end{", 5) == 0);
        depth += (strchr("({[", d->text[at]) != NULL) - (strchr(")}]", d->text[at]) != NULL);
        if (begin < 0 || begin >= stop)
            continue;
        if (++places > MOST_PLACES) /* no formula has so many */
            break;
        if (!is_list(d->text, begin, stop) && cagd_read_statement(scope, d->text, from, at, &unused) != NULL)
            continue;
        const int second = second_words(d->text, begin, stop);
        if (second > begin) {
            if (asked.message[0] == '\0')
                cagd_refuse_reading(&asked, second, stop,
                                    "of which formula is this said? write a statement for each of them");
            continue;
        }
        if (!cagd_read_ranges(&known, d->text, begin, stop, &unused)) {
            if ((unused.of_list || (unused.of_words && environments == 0)) && asked.message[0] == '\0')
                asked = unused;
            if (asked.message[0] == '\0')
                ask_for_second(d, scope, from, at, begin, stop, &tries, &asked);
            continue;
        }
        cagd_reading_error before = {0};
        const cagd_tree *t = cagd_read_statement(&known, d->text, from, at, &before);
        struct behind b = {d, scope, &known, from, at, begin, stop};
        const cagd_tree *unclear = t != NULL ? unclear_condition(&b) : NULL;
        if (unclear != NULL) {
            if (asked.message[0] == '\0')
                cagd_refuse_reading(&asked, unclear->from, unclear->to, "%s", CAGD_SAID_OR_SUPPOSED);
            continue;
        }
        if (t != NULL && (t = with_what_is_supposed(&b, t, &other)) != NULL) {
            *scope = other;
            return t;
        }
        if (is_list(d->text, begin, stop) && before.message[0] != '\0')
            *error = before;
    }
    if (asked.message[0] != '\0')
        *error = asked;
    return NULL;
}

/* In the block of an entry the lines that say how its print is read; where the formula is that comes out. */
static void read_print(struct document *d, struct formula *f, int head, int at, int stop, int *printed,
                       int *printed_end)
{
    int from = 0, to = 0, part = 0, part_end = 0, first = at;
    for (int k = 0; d->reg != NULL && d->reg->statements[k].id != NULL; k++)
        if (strcmp(d->reg->statements[k].id, f->name) == 0)
            f->entry = &d->reg->statements[k];
    if (f->entry == NULL) {
        complain(d, head, end_of_line(d, head), "no entry of the ledger has the name %s", f->name);
        return;
    }
    *printed = d->used;
    for (int end; next_entry(d, &at, stop, &end); at = behind(d, end))
        if (field(d, at, end, "part", &from, &to))
            part = from, part_end = to;
        else if (field(d, at, end, "before", &from, &to))
            put_in_document(d, d->text + from, to - from);
    int start = d->used;
    if (!put_parts(d, f->entry->printed, part, part_end))
        complain(d, head, end_of_line(d, head), "%s has no formula of that number", f->name);
    at = first;
    for (int end; next_entry(d, &at, stop, &end); at = behind(d, end))
        if (field(d, at, end, "without", &from, &to) && !take_out(d, start, from, to))
            complain(d, from, to, "that does not stand in %s", f->name);
    *printed_end = d->used;
    put_in_document(d, "\n", 1);
}

static void read_statement(struct document *d, const char *kind, int head, int at, int stop)
{
    int is_printed = strcmp(kind, ":::{printed}") == 0, is_tried = strcmp(kind, ":::{equation}") == 0;
    struct formula *f = &d->formula[d->count];
    int column, from = 0, to = 0, printed = 0, printed_end = 0, ranges = 0, ranges_end = 0, complaints = d->complaints;
    int find = 0, find_end = 0;
    int name = head + (int)strlen(kind), name_end = end_of_entry(d, head, next_line(d, head)), inside = at;
    *f = (struct formula){.expected = EXPECT_NOTHING, .seconds = usual_seconds};
    if (d->count == MOST_STATEMENTS) {
        complain(d, head, head + 1, "more than %d statements", MOST_STATEMENTS);
        return;
    }
    strip(d, &name, &name_end);
    place_of(d, head, &f->line, &column);
    f->name = cagd_text_of(d->text + name, name_end - name);
    if (name == name_end)
        complain(d, head, end_of_line(d, head), "a statement without a name");
    refuse_second_fields(d, at, stop);
    if (is_printed)
        read_print(d, f, head, inside, stop, &printed, &printed_end);
    for (int end; next_entry(d, &at, stop, &end); at = behind(d, end)) {
        if (is_printed && (field(d, at, end, "part", &from, &to) || field(d, at, end, "before", &from, &to) ||
                           field(d, at, end, "without", &from, &to)))
            continue;
        if (!is_printed && field(d, at, end, "printed", &from, &to))
            printed = from, printed_end = to;
        else if (!is_printed && field(d, at, end, "from", &from, &to))
            put_from_paper(d, from, to, &printed, &printed_end);
        else if (field(d, at, end, "for", &from, &to))
            ranges = from, ranges_end = to;
        else if (field(d, at, end, "find", &from, &to))
            find = from, find_end = to;
        else if (field(d, at, end, "expected", &from, &to))
            read_expected(d, f, from, to);
        else if (field(d, at, end, "seconds", &from, &to))
            f->seconds = seconds_of(d, from, to);
        else if (d->text[at] == ':' && !field(d, at, end, "source", &from, &to) &&
                 !field(d, at, end, "title", &from, &to))
            complain(d, at, at + 1,
                     "expected :printed:, :from:, :for:, :find:, :title:, :source:, :expected: or :seconds:");
    }
    if (printed_end == printed && d->complaints == complaints)
        complain(d, head, end_of_line(d, head), "a statement without a formula: expected a line :printed: ...");
    cagd_reading_error error;
    f->scope = d->scope;
    if (ranges_end > ranges && !cagd_read_ranges(&f->scope, d->text, ranges, ranges_end, &error))
        complain_of_reading(d, &error);
    if (find_end > find)
        f->find = parameter_named(d, &f->scope, find, find_end);
    if (f->find != NULL)
        be_real(&f->scope, f->find);
    if (d->complaints > complaints)
        return;
    f->at = printed;
    f->printed = cagd_text_of(d->text + printed, printed_end - printed);
    for (const statement_link *l = f->entry != NULL && f->expected == EXPECT_NOTHING ? f->entry->links : NULL;
         l != NULL && (l->claim != NULL || l->text != NULL); l++)
        if (l->role == REFUTED_BY)
            f->expected = EXPECT_FAILS;
    d->entry = f->name;
    f->tree = cagd_read_statement(&f->scope, d->text, printed, printed_end, &error);
    if (f->tree == NULL)
        f->tree = with_ranges_behind(d, &f->scope, printed, printed_end, &error);
    if (f->tree != NULL)
        error = (cagd_reading_error){0};
    if (f->tree != NULL && cagd_make_indices_whole(&f->scope, f->tree, &error))
        d->count++;
    else if (is_tried)
        leave_out(d, f->name, printed, &error);
    else
        complain_of_reading(d, &error);
    const cagd_variable *of;
    const cagd_tree *unknown = f->tree != NULL ? cagd_unknown_in_bounds(&f->scope, f->tree, &of) : NULL;
    if (unknown != NULL)
        complain(d, printed, printed_end,
                 "the bounds of %s have %s, which has no value here: expected, for instance, :for: %s = 1..4",
                 of->left != NULL ? cagd_text_of(d->text + of->left->from, of->left->to - of->left->from) : of->head,
                 unknown->head, unknown->head);
}

/* The value of a number, or of an end of a range. */
static int number_of(const cagd_scope *scope, const cagd_tree *t, cagd_num_q *out)
{
    cagd_context *c = region_bytes(sizeof *c);
    if (c == NULL || t == NULL)
        return 0;
    *c = (cagd_context){.scope = scope, .steps = CAGD_USUAL_STEPS};
    cagd_value v = cagd_evaluate(c, t);
    int good = region_faults == 0 && v.rational;
    region_faults &= FAULT_MEMORY;
    *out = v.q;
    return good;
}

static int whole_of(const cagd_scope *scope, const cagd_tree *t, long *out)
{
    cagd_num_q q;
    return number_of(scope, t, &q) && cagd_value_is_whole(cagd_value_q(q), out);
}

/* The lower index that is a letter and has no value, as n has behind n = 3; NULL where there is none, or a second one. */
static const cagd_tree *running_index(const cagd_scope *scope, const cagd_tree *t)
{
    const cagd_tree *found = NULL;
    for (int k = 0; k < t->lower; k++)
        if (t->at[k]->kind == CAGD_NAME &&
            (cagd_declared(scope, t->at[k]->head) != NULL || cagd_defined(scope, t->at[k]->head) == NULL)) {
            if (found != NULL || t->at[k]->count > 0)
                return NULL;
            found = t->at[k];
        }
    return found;
}

/* The functions: a name with a lower index that is a letter and runs over whole numbers, and an argument, a letter; others may stand
 * beside the index if they are numbers, and behind the argument. */
static void read_functions(struct document *d, struct sheet *s, int from, int to)
{
    cagd_reading_error error;
    const cagd_tree *t = s->tree = cagd_read_value(&s->scope, d->text, from, to, &error);
    if (t == NULL) {
        complain_of_reading(d, &error);
        return;
    }
    const cagd_tree *index = t->kind == CAGD_NAME ? running_index(&s->scope, t) : NULL;
    const int place = t->kind == CAGD_NAME && t->arguments > 0 ? cagd_basis_argument(t, s->find) : -1;
    const cagd_tree *argument = place >= 0 ? t->at[place] : NULL;
    if (index == NULL || argument == NULL || index->kind != CAGD_NAME || argument->kind != CAGD_NAME || t->order > 0) {
        complain(
            d, from, to,
            "expected functions with one index and an argument, such as b_i(t), other indices being numbers, as n is "
            "behind n = 3");
        return;
    }
    const cagd_variable *v = cagd_declared(&s->scope, index->head);
    s->index = index->head, s->argument = argument->head;
    s->index_from = index->from - from, s->index_to = index->to - from;
    s->argument_from = argument->from - from, s->argument_to = argument->to - from;
    s->functions = cagd_text_of(d->text + from, to - from);
    if (v == NULL || !v->whole || v->step > 1 || v->listed != NULL || !whole_of(&s->scope, v->low, &s->first) ||
        !whole_of(&s->scope, v->high, &s->last))
        complain(d, from, to, "the range of the index is not known: expected, for instance, :for: %s = 0..3", s->index);
    else if (s->last <= s->first || s->last - s->first >= CAGD_MOST_FUNCTIONS)
        complain(d, from, to, "expected 2 to %d functions", CAGD_MOST_FUNCTIONS);
}

/* The values of the parameter in the picture, with commas between. */
static void read_shown(struct document *d, struct sheet *s, int from, int to)
{
    while (from < to) {
        const char *comma = memchr(d->text + from, ',', (size_t)(to - from));
        int end = comma != NULL ? (int)(comma - d->text) : to, next = end + 1;
        cagd_reading_error error;
        strip(d, &from, &end);
        const cagd_tree *t = cagd_read_value(&s->scope, d->text, from, end, &error);
        if (t == NULL)
            complain_of_reading(d, &error);
        else if (s->shown_count == MOST_SHOWN || !number_of(&s->scope, t, &s->shown[s->shown_count++]))
            complain(d, from, end, "expected at most %d numbers with commas between", MOST_SHOWN);
        from = next;
    }
}

static void read_sheet(struct document *d, int head, int at, int stop)
{
    struct sheet *s = &d->sheet[d->sheets];
    enum { FUNCTIONS, FOR, FIND, AT, KEYS };
    static const char *const key[] = {"functions", "for", "find", "at"};
    int column, from[KEYS] = {0}, to[KEYS] = {0}, complaints = d->complaints;
    int name = head + (int)strlen(":::{basis}"), name_end = end_of_entry(d, head, next_line(d, head));
    *s = (struct sheet){.seconds = usual_seconds};
    if (d->sheets == MOST_SHEETS) {
        complain(d, head, head + 1, "more than %d bases", MOST_SHEETS);
        return;
    }
    strip(d, &name, &name_end);
    place_of(d, head, &s->line, &column);
    s->name = cagd_text_of(d->text + name, name_end - name);
    if (name == name_end)
        complain(d, head, end_of_line(d, head), "a basis without a name");
    refuse_second_fields(d, at, stop);
    for (int end; next_entry(d, &at, stop, &end); at = behind(d, end)) {
        int known = d->text[at] != ':', a, b;
        for (int k = 0; k < KEYS; k++)
            known |= field(d, at, end, key[k], &from[k], &to[k]);
        if (field(d, at, end, "seconds", &a, &b))
            known = 1, s->seconds = seconds_of(d, a, b);
        if (!known && !field(d, at, end, "source", &a, &b) && !field(d, at, end, "title", &a, &b))
            complain(d, at, at + 1, "expected :functions:, :for:, :find:, :at:, :title:, :source: or :seconds:");
    }
    cagd_reading_error error;
    s->scope = d->scope;
    if (to[FUNCTIONS] == from[FUNCTIONS] && d->complaints == complaints)
        complain(d, head, end_of_line(d, head), "a basis without functions: expected a line :functions: b_i(t)");
    if (to[FOR] > from[FOR] && !cagd_read_ranges(&s->scope, d->text, from[FOR], to[FOR], &error))
        complain_of_reading(d, &error);
    if (to[FIND] > from[FIND])
        s->find = parameter_named(d, &s->scope, from[FIND], to[FIND]);
    if (d->complaints == complaints)
        read_functions(d, s, from[FUNCTIONS], to[FUNCTIONS]);
    if (d->complaints == complaints)
        read_shown(d, s, from[AT], to[AT]);
    d->sheets += d->complaints == complaints;
}

/* The line of three colons that ends the block. */
static int end_of_block(const struct document *d, int at)
{
    while (at < d->size && !(begins(d, at, ":::") && end_of_entry(d, at, next_line(d, at)) == at + 3))
        at = next_line(d, at);
    return at;
}

static void read_blocks(struct document *d)
{
    for (int at = 0; at < d->size; at = next_line(d, at)) {
        if (!begins(d, at, ":::"))
            continue;
        int inside = next_line(d, at), stop = end_of_block(d, inside);
        if (stop == d->size) {
            complain(d, at, end_of_line(d, at), "the block does not end: expected a line ':::'");
            return;
        }
        if (!begins(d, at, ":::{let}") && !begins(d, at, ":::{defined}") && !begins(d, at, ":::{equation}"))
            complain_of_waiting(d);
        if (begins(d, at, ":::{let}"))
            read_let(d, inside, stop);
        else if (begins(d, at, ":::{statement}"))
            read_statement(d, ":::{statement}", at, inside, stop);
        else if (begins(d, at, ":::{printed}"))
            read_statement(d, ":::{printed}", at, inside, stop);
        else if (d->chunks > 0 && begins(d, at, ":::{equation}"))
            read_statement(d, ":::{equation}", at, inside, stop);
        else if (d->chunks > 0 && begins(d, at, ":::{defined}"))
            read_defined(d, at, inside, stop);
        else if (begins(d, at, ":::{basis}"))
            read_sheet(d, at, inside, stop);
        else
            complain(d, at, end_of_line(d, at), "expected :::{let}, :::{statement} NAME or :::{basis} NAME");
        at = stop;
    }
    complain_of_waiting(d);
}

/* ---- the file ------------------------------------------------------------------------------------------ */

static int refuse_file(const char *path, const char *why)
{
    refuse_line("%s: %s", name_of_input(path), why);
    return -1;
}

int read_whole_file(const char *path, char **text)
{
    struct input_error error;
    FILE *in = open_input(path, "formulas", &error);
    if (in == NULL)
        return refuse_file(path, error.cause);
    *text = region_bytes(2 * LARGEST_FILE);
    size_t size = *text != NULL ? fread(*text, 1, LARGEST_FILE + 1, in) : 0;
    int bad = ferror(in);
    if (in != stdin)
        fclose(in);
    if (*text == NULL)
        abort();
    if (bad)
        return refuse_file(path, "cannot be read to its end; expected the file of formulas");
    if (size > LARGEST_FILE)
        return refuse_file(path, "is larger than 4 MB, the largest size that is read; divide it");
    if (memchr(*text, '\0', size) != NULL)
        return refuse_file(path, "is no text, there is a zero byte in it; expected Markdown or LaTeX");
    if (size >= 3 && memcmp(*text, "\xEF\xBB\xBF", 3) == 0) /* the mark of UTF-8 */
        memmove(*text, *text + 3, size -= 3);
    return (int)size;
}

int read_document(const cagd_register *reg, const char *path, struct document *d)
{
    *d = (struct document){.reg = reg, .path = path};
    char *text;
    int size = read_whole_file(path, &text);
    if (size < 0)
        return 1;
    d->formula = cagd_region_array(MOST_STATEMENTS + 1, 1, sizeof *d->formula);
    d->sheet = cagd_region_array(MOST_SHEETS + 1, 1, sizeof *d->sheet);
    d->chunk = cagd_region_array(MOST_CHUNKS, 1, sizeof *d->chunk);
    d->left_out = cagd_region_array(MOST_STATEMENTS, 1, sizeof *d->left_out);
    d->last_place = region_bytes(sizeof *d->last_place);
    if (d->last_place == NULL || d->formula == NULL || d->sheet == NULL || d->chunk == NULL || d->left_out == NULL)
        abort();
    *d->last_place = (struct place){0};
    d->text = d->room = text, d->size = d->used = size;
    if (is_paper(path, text, size))
        put_paper(d);
    put_in_document(d, "\n", 1);
    if (d->complaints == 0)
        read_blocks(d);
    if (d->complaints == 0 && d->count == 0 && d->sheets == 0)
        return -refuse_file(path, d->papers == NULL
                                      ? "has no statement: expected a block :::{statement} NAME or :::{basis} NAME"
                                  : d->left_outs > 0 ? "has no formula that could be read"
                                                     : "has no formula with a \\label, or with a comment % cagd: ...");
    if (d->complaints > MOST_COMPLAINTS)
        refuse_line("%s: and %d more", name_of_input(path), d->complaints - MOST_COMPLAINTS);
    return d->complaints;
}
