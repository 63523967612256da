/* latex.c -- the displayed formulas of a LaTeX source, one line each, without what is there for the page. */
#include "exact/expression/latex.h"
#include "exact/words.h"

#include <ctype.h>
#include <string.h>

enum { LONGEST_NAME = 40, MOST_NESTED = 64, LONGEST_LABEL = 120, LONGEST_GROUP = 1000, LONGEST_SKIP = 40 };

/* The rows of an environment are formulas of their own, or one formula, or the cases of what stands in the group behind its name. */
enum rows { NO_FORMULA, ONE, EACH, CASES };

/* clang-format off */
static const struct {
    const char *name;
    enum rows rows;
    int arguments; /* groups behind its name */
} environments[] = {
    {"equation", ONE, 0}, {"displaymath", ONE, 0}, {"multline", ONE, 0}, {"dmath", ONE, 0}, {"align", EACH, 0},
    {"gather", EACH, 0}, {"eqnarray", EACH, 0}, {"flalign", EACH, 0}, {"alignat", EACH, 1}, {"dgroup", EACH, 0},
    {"IEEEeqnarray", EACH, 1}, {"xalignat", EACH, 1}, {"xxalignat", EACH, 1}, {"numcases", CASES, 1}, {"subnumcases", CASES, 1}};

/* Formulas may stand in these, but they are not read. */
static const char *const not_read[] = {"empheq", "darray", "mathpar"};

/* Inside of a formula these set it on several lines.  Where they stand at its beginning they are kept, as its rows (read_rows.h), but for the last one; elsewhere they
 * mean nothing. */
static const char *const settings[] = {"split", "aligned", "gathered", "alignedat", "multlined"};

/* For the page, with a group behind it, which is left out with it; without one; and what stands for it. */
static const char *const with_a_group[] = {"\\hspace", "\\vspace", "\\phantom", "\\vphantom", "\\hphantom", "\\mspace",
                                           "\\color", "\\intertext", "\\shortintertext", "\\raisetag"};
static const char *const alone[] = {"\\allowdisplaybreaks", "\\displaybreak", "\\hfill", "\\strut", "\\mathstrut", "\\notag",
                                    "\\nonumber", "\\centering", "\\small", "\\ensuremath", "\\relax", "\\protect", "\\/",
                                    "\\bigskip", "\\medskip", "\\noindent", "\\scriptstyle", "\\IEEEnonumber", "\\IEEEyesnumber",
                                    "\\IEEEyessubnumber", "\\IEEEeqnarraynumspace"};
static const struct {
    const char *written, *means;
    int defines; /* the relation says what the left side means */
} other_words[] = {{"\\hbox", "\\text", 0}, {"\\textnormal", "\\text", 0}, {"\\textit", "\\text", 0}, {"\\coloneqq", "=", 1},
                   {"\\coloneq", "=", 1}, {"\\triangleq", "=", 1}, {"\\lVert", "\\|", 0}, {"\\rVert", "\\|", 0},
                   {"\\Vert", "\\|", 0}, {"\\mid", "|", 0}};
/* clang-format on */

/* How far the reader of the source is. */
struct source {
    const cagd_latex_text *in;
    cagd_latex *out;
    cagd_latex_note waiting[CAGD_LATEX_MOST_NOTES]; /* comments in front of the next environment, in out->text */
    int waits, waiting_at;
};

/* A row that is being read: its formula goes to out->text when it ends. */
struct row {
    cagd_latex_text text;
    const char *label, *tag;
    cagd_latex_note note[CAGD_LATEX_MOST_NOTES];
    int notes, at, is_definition;
    int columns, has_own_column; /* columns: so many & outside of all; before the first one something stands */
};

static int is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

/* ---- words --------------------------------------------------------------------------------------------- */

static int begins(const cagd_latex_text *t, int k, const char *word)
{
    int n = (int)strlen(word);
    return t->size - k >= n && memcmp(t->bytes + k, word, (size_t)n) == 0;
}

/* Behind the command or the byte at k. */
static int behind_word(const cagd_latex_text *t, int k)
{
    if (t->bytes[k] != '\\' || k + 1 == t->size)
        return k + 1;
    int end = k + 1;
    while (end < t->size && isalpha((unsigned char)t->bytes[end]))
        end++;
    return end > k + 1 ? end : k + 2;
}

static int is_word(const cagd_latex_text *t, int a, int b, const char *word)
{
    return b - a == (int)strlen(word) && memcmp(t->bytes + a, word, (size_t)(b - a)) == 0;
}

static int is_one_of(const cagd_latex_text *t, int a, int b, const char *const list[], size_t count)
{
    for (size_t k = 0; k < count; k++)
        if (is_word(t, a, b, list[k]))
            return 1;
    return 0;
}
#define IS_ONE_OF(t, a, b, list) is_one_of(t, a, b, list, sizeof list / sizeof *list)

static int behind_blanks(const cagd_latex_text *t, int k)
{
    while (k < t->size && is_blank(t->bytes[k]))
        k++;
    return k;
}

/* {text} behind blanks at k: its bytes to a..b, and what is behind it; k where there is none, or none that ends before `stop`, or one that is
 * longer than what is meant for the page, a label or a skip. */
static int group(const cagd_latex_text *t, int k, int stop, char open, char close, int *a, int *b)
{
    int at = behind_blanks(t, k), depth = 0;
    *a = *b = at;
    if (at >= stop || t->bytes[at] != open)
        return k;
    stop = stop - at > LONGEST_GROUP ? at + LONGEST_GROUP : stop;
    for (int m = at; m < stop; m = behind_word(t, m)) {
        depth += (t->bytes[m] == open) - (t->bytes[m] == close);
        if (depth == 0) {
            *a = at + 1, *b = m;
            return m + 1;
        }
    }
    return k;
}

/* \begin{name} or \end{name} at k: the name without a star to name[], and what is behind it; k where it is another thing. */
static int environment(const cagd_latex_text *t, int k, const char *word, char name[LONGEST_NAME])
{
    int a, b, at = begins(t, k, word) ? k + (int)strlen(word) : k;
    int end =
        at > k ? group(t, at, t->size < at + LONGEST_NAME + 2 ? t->size : at + LONGEST_NAME + 2, '{', '}', &a, &b) : k;
    if (end <= at || b - a >= LONGEST_NAME)
        return k;
    b -= b > a && t->bytes[b - 1] == '*';
    memcpy(name, t->bytes + a, (size_t)(b - a));
    name[b - a] = '\0';
    return end;
}

static int number_of_environment(const char *name)
{
    for (size_t k = 0; k < sizeof environments / sizeof *environments; k++)
        if (strcmp(environments[k].name, name) == 0)
            return (int)k;
    return -1;
}

static int is_setting(const char *name)
{
    for (size_t k = 0; k < sizeof settings / sizeof *settings; k++)
        if (strcmp(settings[k], name) == 0)
            return 1;
    return 0;
}

/* The byte of the source that byte k comes from. */
static int place_of(const cagd_latex_text *t, int k) { return k < t->size ? t->from[k] : 0; }

/* ---- what comments say --------------------------------------------------------------------------------- */

/* The comment at k: its words, and a blank, go to the text that comes out; what is behind it. */
static int read_note(struct source *s, int k, cagd_latex_note *note)
{
    const cagd_latex_text *t = s->in;
    cagd_latex_text *out = &s->out->text;
    int end = k;
    while (end < t->size && t->bytes[end] != '\n')
        end++;
    for (k++; k < end && t->bytes[k] != ':'; k++)
        ;
    k = k < end ? k + 1 : end;
    while (k < end && is_blank(t->bytes[k]))
        k++;
    int stop = end;
    while (stop > k && is_blank(t->bytes[stop - 1]))
        stop--;
    note->from = out->size;
    for (int m = k; m < stop; m++)
        cagd_latex_put(out, t->bytes[m], t->from[m]);
    note->to = out->size;
    cagd_latex_put(out, '\n', t->from[stop > 0 ? stop - 1 : 0]);
    return end;
}

static void add_item(cagd_latex *out, cagd_latex_item item)
{
    if (out->items == out->item_room) {
        int room = out->item_room > 0 ? 2 * out->item_room : 32;
        cagd_latex_item *more = cagd_region_array(room, 1, sizeof *more);
        if (more == NULL)
            return;
        if (out->items > 0)
            memcpy(more, out->item, (size_t)out->items * sizeof *more);
        out->item = more, out->item_room = room;
    }
    out->item[out->items++] = item;
}

/* A line of a block of meanings stands for itself; 0 where the comment is another one. */
static int is_let(struct source *s, const cagd_latex_note *note)
{
    const cagd_latex_text *t = &s->out->text;
    if (!begins(t, note->from, "let") || note->to - note->from < 3 ||
        (note->to - note->from > 3 && !is_blank(t->bytes[note->from + 3])))
        return 0;
    int from = note->from + 3;
    while (from < note->to && is_blank(t->bytes[from]))
        from++;
    add_item(s->out, (cagd_latex_item){.is_let = 1, .from = from, .to = note->to, .at = place_of(t, note->from)});
    return 1;
}

static void keep_note(struct source *s, cagd_latex_note list[], int *count, cagd_latex_note note)
{
    const cagd_latex_text *t = &s->out->text;
    if (*count < CAGD_LATEX_MOST_NOTES)
        list[(*count)++] = note;
    else
        cagd_latex_refuse(s->out, place_of(t, note.from), place_of(t, note.from) + 1,
                          "more than 16 comments for one formula");
}

/* Comments that nothing came behind to which they could belong. */
static void refuse_notes(struct source *s, const cagd_latex_note list[], int count)
{
    for (int k = 0; k < count; k++) {
        int at = place_of(&s->out->text, list[k].from);
        cagd_latex_refuse(s->out, at, at + 1, "no formula follows for which this could be said");
    }
}

static void forget_notes(struct source *s)
{
    refuse_notes(s, s->waiting, s->waits);
    s->waits = 0;
}

/* ---- rows ---------------------------------------------------------------------------------------------- */

/* Whether the formula goes on with a relation or a sign: then it is no formula of its own. */
static int goes_on(const cagd_latex_text *t)
{
    static const char *const signs[] = {"=",          "<",          ">",       "+",      "-",       "\\le", "\\leq",
                                        "\\ge",       "\\geq",      "\\equiv", "\\cdot", "\\times", "\\ne", "\\neq",
                                        "\\leqslant", "\\geqslant", "\\qquad", "\\quad", "/",       "≤",    "≥"};
    int k = behind_blanks(t, 0);
    if (k == t->size)
        return 0;
    int end = behind_word(t, k);
    while (end < t->size && ((unsigned char)t->bytes[end] & 0xC0) == 0x80)
        end++;
    return IS_ONE_OF(t, k, end, signs);
}

static int is_empty(const cagd_latex_text *t) { return behind_blanks(t, 0) == t->size; }

/* The row, with the notes of all rows of its environment, becomes a formula; commas and periods at its end belong to the sentence. */
static void end_formula(struct source *s, struct row *r)
{
    cagd_latex_text *out = &s->out->text, *t = &r->text;
    int from = behind_blanks(t, 0), to = t->size;
    while (to > from && (is_blank(t->bytes[to - 1]) ||
                         (strchr(",.;", t->bytes[to - 1]) != NULL && (to - from < 2 || t->bytes[to - 2] != '\\'))))
        to--;
    cagd_latex_item item = {.is_definition = r->is_definition,
                            .from = out->size,
                            .at = from < t->size ? t->from[from] : r->at,
                            .name = r->label != NULL ? r->label : r->tag,
                            .notes = r->notes};
    memcpy(item.note, r->note, sizeof item.note);
    for (int k = from; k < to; k++)
        cagd_latex_put(out, t->bytes[k], t->from[k]);
    item.to = out->size;
    cagd_latex_put(out, '\n', item.at);
    if (to > from)
        add_item(s->out, item);
    for (int k = 0; k < r->notes && to == from; k++) {
        int at = place_of(out, r->note[k].from);
        cagd_latex_refuse(s->out, at, at + 1, "the row that this is said of has no formula");
    }
}

/* Whether the row is a formula though it begins with a sign: -x &= 0, and where it and the one before have labels of their own. */
static int is_signed_formula(const struct row *before, const struct row *r)
{
    const cagd_latex_text *t = &r->text;
    const int k = behind_blanks(t, 0);
    int has_relation = 0;
    if (k == t->size || (t->bytes[k] != '+' && t->bytes[k] != '-'))
        return 0;
    for (int m = k, next; m < t->size && !has_relation; m = next) {
        static const char *const words[] = {"\\le", "\\leq", "\\ge", "\\geq", "\\ne", "\\neq", "\\equiv"};
        next = behind_word(t, m);
        has_relation = strchr("=<>", t->bytes[m]) != NULL || IS_ONE_OF(t, m, next, words);
    }
    return has_relation && (r->columns > 0 ? r->has_own_column : before->label != NULL && r->label != NULL);
}

/* A row ended: it goes on with the one before, or that one is a formula. */
static void end_row(struct source *s, struct row *before, int *has_before, struct row *r, int at)
{
    if (*has_before && (is_empty(&r->text) || (goes_on(&r->text) && !is_signed_formula(before, r)))) {
        if (before->label != NULL && r->label != NULL)
            cagd_latex_remark(s->out, r->at, r->at + 1,
                              "this row goes on with the formula before it: its label names none");
        for (int k = 0; k < r->text.size; k++)
            cagd_latex_put(&before->text, r->text.bytes[k], r->text.from[k]);
        before->label = before->label != NULL ? before->label : r->label;
        before->tag = before->tag != NULL ? before->tag : r->tag;
        before->is_definition |= r->is_definition;
        for (int k = 0; k < r->notes; k++)
            keep_note(s, before->note, &before->notes, r->note[k]);
    } else {
        if (*has_before)
            end_formula(s, before);
        *before = *r;
        *has_before = 1;
    }
    *r = (struct row){.at = at};
}

static void put_word(struct row *r, const char *word, int from)
{
    if (isalpha((unsigned char)word[0]))
        cagd_latex_put(&r->text, ' ', from);
    for (; *word != '\0'; word++)
        cagd_latex_put(&r->text, *word, from);
}

/* A label is one line of letters. */
static const char *label_of(const cagd_latex_text *t, int a, int b)
{
    while (a < b && is_blank(t->bytes[a]))
        a++;
    while (b > a && is_blank(t->bytes[b - 1]))
        b--;
    char *text = region_bytes((size_t)(b - a) + 1);
    for (int k = a; text != NULL && k < b; k++)
        text[k - a] = is_blank(t->bytes[k]) ? ' ' : t->bytes[k];
    if (text == NULL || a == b || b - a > LONGEST_LABEL)
        return NULL;
    text[b - a] = '\0';
    return text;
}

/* The word at a..b of a formula, if it is one that is not simply copied: what is behind it and what it takes, else a. */
static int special_word(struct source *s, struct row *r, int a, int b, int stop)
{
    const cagd_latex_text *t = s->in;
    int from, to, end;
    if (is_word(t, a, b, "\\label")) {
        end = group(t, b, stop, '{', '}', &from, &to);
        r->label = end > b && r->label == NULL ? label_of(t, from, to) : r->label;
        return end;
    }
    if (is_word(t, a, b, "\\tag")) {
        b += b < stop && t->bytes[b] == '*';
        end = group(t, b, stop, '{', '}', &from, &to);
        r->tag = end > b && r->tag == NULL ? label_of(t, from, to) : r->tag;
        return end;
    }
    if (IS_ONE_OF(t, a, b, with_a_group))
        return group(t, b + (b < stop && t->bytes[b] == '*'), stop, '{', '}', &from, &to);
    if (IS_ONE_OF(t, a, b, alone))
        return b;
    if (is_word(t, a, b, "\\overset") || is_word(t, a, b, "\\stackrel")) { /* \overset{\text{def}}{=} */
        end = group(t, b, stop, '{', '}', &from, &to);
        for (int k = from; k + 3 <= to; k++)
            r->is_definition |= begins(t, k, "def");
        return end;
    }
    for (size_t k = 0; k < sizeof other_words / sizeof *other_words; k++)
        if (is_word(t, a, b, other_words[k].written)) {
            put_word(r, other_words[k].means, t->from[a]);
            r->is_definition |= other_words[k].defines;
            return b;
        }
    return a;
}

static int is_empty(const cagd_latex_text *t);

/* What is kept is in inside[] with a sign before its name, so that it is no setting. */
static void keep_inside(char inside[LONGEST_NAME])
{
    memmove(inside + 1, inside, LONGEST_NAME - 2);
    inside[0] = '=', inside[LONGEST_NAME - 1] = '\0';
}

/* \begin{split} and \end{split} inside of a formula are passed over, others kept; what encloses what follows is in inside[]. */
static int inner_environment(const cagd_latex_text *t, int k, struct row *r, char inside[][LONGEST_NAME], int *depth)
{
    char name[LONGEST_NAME];
    int a, b, end = environment(t, k, "\\begin", name);
    if (end > k && *depth < MOST_NESTED) {
        memcpy(inside[(*depth)++], name, sizeof name);
        if (!is_setting(name))
            return k;
        if (*depth == 1 && is_empty(&r->text) && strcmp(name, "multlined") != 0) {
            keep_inside(inside[0]);
            for (int m = k; m < end; m++)
                cagd_latex_put(&r->text, t->bytes[m], t->from[m]);
            return group(t, end, t->size, '[', ']', &a, &b);
        }
        end = group(t, end, t->size, '[', ']', &a, &b);
        return strcmp(name, "alignedat") == 0 ? group(t, end, t->size, '{', '}', &a, &b) : end;
    }
    end = environment(t, k, "\\end", name);
    if (end <= k || *depth == 0)
        return k;
    --*depth;
    return is_setting(inside[*depth]) ? end : k;
}

/* The brace around such an environment, \left\{ and \right.: behind it; k where there is none. */
static int behind_brace_of_rows(const cagd_latex_text *t, int k)
{
    static const char *const left = "\\left\\{", *const right = "\\right.";
    char name[LONGEST_NAME];
    int at = begins(t, k, left) ? k + (int)strlen(left) : k;
    while (at > k && at < t->size && is_blank(t->bytes[at]))
        at++;
    if (at > k && environment(t, at, "\\begin", name) > at && is_setting(name))
        return at;
    for (at = begins(t, k, right) ? k : 0; at > 0 && is_blank(t->bytes[at - 1]);)
        at--;
    while (at > 0 && t->bytes[at] != '\\')
        at--;
    return begins(t, k, right) && environment(t, at, "\\end", name) > at && is_setting(name) ? k + (int)strlen(right)
                                                                                             : k;
}

/* Behind the end of a row at k: \\, \\*, \\[2pt]. */
static int behind_break(const cagd_latex_text *t, int k, int stop)
{
    int a, b;
    k += 2;
    k += k < stop && t->bytes[k] == '*';
    return k < stop && t->bytes[k] == '['
               ? group(t, k, stop < k + LONGEST_SKIP ? stop : k + LONGEST_SKIP, '[', ']', &a, &b)
               : k;
}

/* A comment in a row: of the row that just ended, if it stands on the line of its end. */
static int note_in_row(struct source *s, int k, int ended_at, struct row *before, int has_before, struct row *r)
{
    cagd_latex_note note;
    int same_line = has_before && ended_at >= 0;
    for (int m = ended_at; same_line && m < k; m++)
        same_line = s->in->bytes[m] == ' ' || s->in->bytes[m] == '\t';
    int end = read_note(s, k, &note);
    if (!is_let(s, &note))
        keep_note(s, same_line ? before->note : r->note, same_line ? &before->notes : &r->notes, note);
    return end;
}

/* {} and {=}, which are there for the space around them: behind them; k where it is another thing. */
static int behind_small_group(const cagd_latex_text *t, int k, int stop)
{
    if (t->bytes[k] != '{' || k + 1 >= stop)
        return k;
    if (t->bytes[k + 1] == '}')
        return k + 2;
    return k + 2 < stop && strchr("=<>+-", t->bytes[k + 1]) != NULL && t->bytes[k + 2] == '}' ? k + 3 : k;
}

/* Whether what begins at k, {=} or a sign, a relation or a space, goes on with the row before it. */
static int goes_on_with_row(const cagd_latex_text *t, int k, int stop)
{
    static const char *const words[] = {
        "\\quad",     "\\qquad",  "\\text",  "\\mbox",  "\\le",         "\\leq",     "\\ge",       "\\geq",
        "\\ne",       "\\neq",    "\\equiv", "\\times", "\\cdot",       "\\hspace",  "\\phantom",  "\\hphantom",
        "\\dots",     "\\ldots",  "\\cdots", "\\iff",   "\\Rightarrow", "\\implies", "\\coloneqq", "\\leqslant",
        "\\geqslant", "\\approx", "\\qquad", "\\,",     "\\;",          "\\ "};
    int next = behind_word(t, k);
    if (k >= stop || strchr("+-=<>,;/*:.", t->bytes[k]) != NULL)
        return 1;
    for (size_t m = 0; m < sizeof words / sizeof *words; m++)
        if (is_word(t, k, next, words[m]))
            return 1;
    return t->bytes[k] == '{' && k + 1 < stop && strchr("}=<>+-", t->bytes[k + 1]) != NULL;
}

/* Whether a formula of its own begins at k, behind the end of a row: it has a relation, before which no comma, text or & stands, but for the & right before it.  `leads`:
 * the rows of this environment begin with &. */
static int begins_formula(const cagd_latex_text *t, int k, int stop, int leads)
{
    static const char *const relations[] = {"\\le",  "\\leq",   "\\ge",       "\\geq",      "\\ne",
                                            "\\neq", "\\equiv", "\\leqslant", "\\geqslant", "\\coloneqq"};
    int depth = 0, behind_sign = 0;
    while (k < stop && is_blank(t->bytes[k]))
        k++;
    if (k < stop && t->bytes[k] == '&' && !leads)
        return 0;
    for (k += k < stop && t->bytes[k] == '&'; k < stop && is_blank(t->bytes[k]);)
        k++;
    if (goes_on_with_row(t, k, stop))
        return 0;
    for (int next; k < stop; k = next) {
        next = behind_word(t, k);
        char c = t->bytes[k];
        int is_relation = strchr("=<>", c) != NULL;
        for (size_t m = 0; m < sizeof relations / sizeof *relations; m++)
            is_relation |= is_word(t, k, next, relations[m]);
        if (is_word(t, k, next, "\\end") || (depth == 0 && is_word(t, k, next, "\\\\")))
            return 0;
        depth += (strchr("({[", c) != NULL) - (strchr(")}]", c) != NULL);
        if (depth == 0 && is_relation)
            return 1;
        if (depth == 0 && (c == ',' || is_word(t, k, next, "\\text") || is_word(t, k, next, "\\mbox") ||
                           (behind_sign && !is_blank(c))))
            return 0;
        behind_sign = depth == 0 && (c == '&' || (behind_sign && is_blank(c)));
    }
    return 0;
}

/* Whether the formula so far is whole: its brackets are closed, and neither a comma nor a sign stands at its end. */
static int is_whole_formula(const cagd_latex_text *t)
{
    int depth = 0, end = t->size, has_relation = 0;
    for (int k = 0; k < t->size; k++) {
        depth += (strchr("({[", t->bytes[k]) != NULL) - (strchr(")}]", t->bytes[k]) != NULL);
        has_relation |= strchr("=<>", t->bytes[k]) != NULL ||
                        (t->bytes[k] == '\\' && k + 1 < t->size && strchr("lgn", t->bytes[k + 1]) != NULL);
    }
    while (end > 0 && is_blank(t->bytes[end - 1]))
        end--;
    return depth == 0 && has_relation && end > 0 && strchr(",;+-=<>*/", t->bytes[end - 1]) == NULL;
}

/* Comments at k, on the line on which the environment begins: they belong to all of its rows.  What is behind them. */
static int notes_of_all(struct source *s, int k, int stop, cagd_latex_note shared[], int *shares)
{
    const cagd_latex_text *t = s->in;
    int at = k;
    while (at < stop && (t->bytes[at] == ' ' || t->bytes[at] == '\t'))
        at++;
    if (at == stop || t->bytes[at] != '%')
        return k;
    cagd_latex_note note;
    int end = read_note(s, at, &note);
    if (!is_let(s, &note))
        keep_note(s, shared, shares, note);
    return end;
}

/* The body of an environment, in[k..stop). */
static void read_body(struct source *s, int k, int stop, enum rows rows)
{
    const cagd_latex_text *t = s->in;
    char inside[MOST_NESTED][LONGEST_NAME];
    struct row before = {0}, r = {.at = k < t->size ? t->from[k] : 0};
    int depth = 0, braces = 0, has_before = 0, ended_at = -1, leads = 0;
    cagd_latex_note shared[CAGD_LATEX_MOST_NOTES];
    int shares = s->waits, first = s->out->items;
    memcpy(shared, s->waiting, sizeof shared);
    s->waits = 0;
    k = rows == EACH ? notes_of_all(s, k, stop, shared, &shares) : k;
    while (k < stop && region_faults == 0) {
        int next = behind_word(t, k), set = depth == 0 || is_setting(inside[depth - 1]);
        char c = t->bytes[k];
        if (c == '%') {
            k = note_in_row(s, k, ended_at, &before, has_before, &r);
            continue;
        }
        if (c == '\\' && next == k + 2 && t->bytes[k + 1] == '\\' && set && braces == 0) {
            k = ended_at = behind_break(t, k, stop);
            if (depth == 0 && rows == EACH)
                end_row(s, &before, &has_before, &r, k < t->size ? t->from[k] : r.at);
            else {
                if (depth > 0 && is_whole_formula(&r.text) && begins_formula(t, k, stop, leads)) {
                    while (is_blank(r.text.bytes[r.text.size - 1]))
                        r.text.size--;
                    cagd_latex_put(&r.text, ',', t->from[k - 1]);
                }
                cagd_latex_put(&r.text, ' ', t->from[k - 1]);
            }
            continue;
        }
        braces += (c == '{') - (c == '}');
        if (c == '&' && depth == 0 && r.columns++ == 0)
            r.has_own_column = !is_empty(&r.text);
        int outside = depth;
        int end = c == '\\' && next > k + 2 ? inner_environment(t, k, &r, inside, &depth) : k;
        if (end == k && c == '\\')
            end = behind_brace_of_rows(t, k);
        if (end == k && c == '\\')
            end = special_word(s, &r, k, next, stop);
        if (end > k) {
            cagd_latex_put(&r.text, ' ', t->from[k]);
            k = end;
            if (depth > outside) {
                for (leads = k; leads < stop && is_blank(t->bytes[leads]);)
                    leads++;
                leads = leads < stop && t->bytes[leads] == '&';
            }
        } else if ((end = behind_small_group(t, k, stop)) > k) {
            cagd_latex_put(&r.text, ' ', t->from[k]);
            if (end > k + 2)
                cagd_latex_put(&r.text, t->bytes[k + 1], t->from[k + 1]);
            braces--;
            k = end;
        } else if (c == ':' && next < stop && t->bytes[next] == '=') {
            r.is_definition = 1;
            k = next;
        } else {
            for (int m = k; m < next && m < stop; m++)
                cagd_latex_put(&r.text, is_blank(t->bytes[m]) || (c == '&' && set) ? ' ' : t->bytes[m], t->from[m]);
            k = next;
        }
    }
    end_row(s, &before, &has_before, &r, 0);
    end_formula(s, &before);
    int count = 0;
    for (int m = first; m < s->out->items; m++) { /* what was said in front of it is said of each formula */
        count += !s->out->item[m].is_let;
        for (int j = 0; j < shares && !s->out->item[m].is_let; j++)
            keep_note(s, s->out->item[m].note, &s->out->item[m].notes, shared[j]);
    }
    if (count == 0)
        refuse_notes(s, shared, shares);
}

/* ---- the source ---------------------------------------------------------------------------------------- */

/* Where the word that ends a formula stands, from k on; -1 where it does not. */
static int end_of_formula(const cagd_latex_text *t, int k, const char *close, const char *name)
{
    for (char other[LONGEST_NAME]; k < t->size; k = behind_word(t, k)) {
        if (t->bytes[k] == '%')
            while (k + 1 < t->size && t->bytes[k + 1] != '\n')
                k++;
        else if (name == NULL ? begins(t, k, close) : environment(t, k, "\\end", other) > k && strcmp(other, name) == 0)
            return k;
    }
    return -1;
}

/* A comment on the line on which an environment ends, whose formulas begin with number `first`: it belongs to each of them. */
static int note_behind(struct source *s, int k, int first)
{
    cagd_latex_note note;
    int end = read_note(s, k, &note), count = 0;
    if (is_let(s, &note))
        return end;
    for (int m = first; m < s->out->items; m++)
        if (!s->out->item[m].is_let)
            keep_note(s, s->out->item[m].note, &s->out->item[m].notes, note), count++;
    if (count == 0)
        refuse_notes(s, &note, 1);
    return end;
}

/* The bytes a..b to the text, and a word; where the word comes from is where the bytes begin. */
static void put_between(cagd_latex_text *out, const cagd_latex_text *t, int a, int b, const char *word, int from)
{
    for (int k = a; k < b; k++)
        cagd_latex_put(out, t->bytes[k], t->from[k]);
    for (; *word != '\0'; word++)
        cagd_latex_put(out, *word, from);
}

/* \begin{numcases}{|x| =} x & if $x \ge 0$ \\ ... \end{numcases}: |x| = \begin{cases} x & \text{if } x \ge 0 \\ ... \end{cases}; the left side is
 * at left..left_end, the rows at k..stop, and what stands behind & is text with formulas between dollar signs. */
static void read_cases(struct source *s, int left, int left_end, int k, int stop)
{
    const cagd_latex_text *t = s->in;
    cagd_latex_text all = {0};
    int from = place_of(t, left), behind_sign = 0, is_formula = 1, has_text = 0, a, b;
    put_between(&all, t, left, left_end, "\\begin{cases} ", from);
    while (k < stop) {
        int next = behind_word(t, k), is_break = is_word(t, k, next, "\\\\"), is_comment = t->bytes[k] == '%';
        while (is_comment && next < stop && t->bytes[next - 1] != '\n')
            next++;
        if (is_word(t, k, next, "\\label") && group(t, next, stop, '{', '}', &a, &b) > next)
            next = group(t, next, stop, '{', '}', &a, &b);
        int words = behind_sign && !is_formula && t->bytes[k] != '$' && t->bytes[k] != '\\' && !is_comment &&
                    (isalpha((unsigned char)t->bytes[k]) ||
                     (has_text && !is_blank(t->bytes[k]))); /* no text begins with a comma */
        if (words && !has_text)
            put_between(&all, t, k, k, "\\text{", t->from[k]), has_text = 1;
        if (!words && has_text && !is_blank(t->bytes[k]))
            put_between(&all, t, k, k, "} ", t->from[k]), has_text = 0;
        if (t->bytes[k] == '$')
            is_formula = !is_formula;
        else
            put_between(&all, t, k, next, "", 0);
        if (t->bytes[k] == '&')
            behind_sign = 1, is_formula = 0;
        if (is_break)
            behind_sign = 0, is_formula = 1;
        k = next;
    }
    put_between(&all, t, 0, 0, has_text ? "} \\end{cases}" : " \\end{cases}", from);
    s->in = &all;
    read_body(s, 0, all.size, ONE);
    s->in = t;
}

/* Names the bytes a..b of the text, wherever in the source they come from: a command puts its arguments in any order. */
static void refuse_bytes(struct source *s, int a, int b, const char *message)
{
    int from = s->in->from[a], to = from;
    for (int k = a; k < b; k++) {
        from = s->in->from[k] < from ? s->in->from[k] : from;
        to = s->in->from[k] > to ? s->in->from[k] : to;
    }
    cagd_latex_refuse(s->out, from, to + 1, message);
}

/* The formula whose beginning is at..k; what is behind it. */
static int read_formula(struct source *s, int at, int k, const char *close, const char *name, enum rows rows, int left,
                        int left_end)
{
    const cagd_latex_text *t = s->in;
    char text[LONGEST_NAME];
    int stop = end_of_formula(t, k, close, name);
    if (stop < 0) {
        refuse_bytes(s, at, k,
                     name != NULL      ? "this environment does not end: expected its \\end"
                     : close[0] == '$' ? "this formula does not end: expected $$"
                                       : "this formula does not end: expected \\]");
        s->waits = 0;
        return t->size;
    }
    int first = s->out->items;
    if (rows == CASES)
        read_cases(s, left, left_end, k, stop);
    else
        read_body(s, k, stop, rows);
    int end = name != NULL ? environment(t, stop, "\\end", text) : stop + (int)strlen(close), note = end;
    while (note < t->size && (t->bytes[note] == ' ' || t->bytes[note] == '\t'))
        note++;
    return note < t->size && t->bytes[note] == '%' ? note_behind(s, note, first) : end;
}

/* $...$ inside of a text is no formula of its own: behind it. */
static int behind_inline(const cagd_latex_text *t, int k)
{
    for (int m = k + 1; m < t->size; m = behind_word(t, m)) {
        if (t->bytes[m] == '$')
            return m + 1;
        if (t->bytes[m] == '\n' && m + 1 < t->size && t->bytes[m + 1] == '\n') /* a paragraph ends it */
            break;
    }
    return k + 1;
}

/* What stands at k of the source; what is behind it. */
static int read_next(struct source *s, int k)
{
    const cagd_latex_text *t = s->in;
    char name[LONGEST_NAME];
    cagd_latex_note note;
    if (t->bytes[k] == '%') {
        int end = read_note(s, k, &note);
        if (!is_let(s, &note))
            keep_note(s, s->waiting, &s->waits, note);
        return end;
    }
    if (is_blank(t->bytes[k]))
        return k + 1;
    int behind = environment(t, k, "\\begin", name), a = 0, b = 0,
        which = behind > k ? number_of_environment(name) : -1;
    if (which >= 0) {
        if (environments[which].arguments > 0)
            behind = group(t, group(t, behind, t->size, '[', ']', &a, &b), t->size, '{', '}', &a, &b);
        return read_formula(s, k, behind, NULL, environments[which].name, environments[which].rows, a, b);
    }
    for (size_t m = 0; behind > k && m < sizeof not_read / sizeof *not_read; m++)
        if (strcmp(name, not_read[m]) == 0)
            cagd_latex_remark(s->out, t->from[k], t->from[behind - 1] + 1, "formulas in this environment are not read");
    if (begins(t, k, "\\["))
        return read_formula(s, k, k + 2, "\\]", NULL, ONE, 0, 0);
    if (begins(t, k, "$$"))
        return read_formula(s, k, k + 2, "$$", NULL, ONE, 0, 0);
    if (behind > k && strcmp(name, "subequations") == 0)
        return behind;
    forget_notes(s);
    int end = behind_word(t, k), from, to;
    if ((is_word(t, k, end, "\\input") || is_word(t, k, end, "\\include")) &&
        group(t, end, t->size, '{', '}', &from, &to) > end)
        cagd_latex_remark(s->out, t->from[k], t->from[to] + 1,
                          "this file is not read: its commands and formulas are not known here");
    return t->bytes[k] == '$' ? behind_inline(t, k) : behind_word(t, k);
}

void cagd_read_latex(const char *source, int size, cagd_latex *out)
{
    cagd_latex_text in = {0};
    *out = (cagd_latex){0};
    cagd_expand_latex(source, size, &in, out);
    struct source s = {.in = &in, .out = out};
    for (int k = 0; k < in.size && region_faults == 0;)
        k = read_next(&s, k);
    forget_notes(&s);
}
