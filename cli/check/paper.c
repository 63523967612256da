#include "cli/check/paper.h"

#include "exact/expression/latex.h"
#include "exact/words.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LONGEST_PATH = 4096, MOST_NAMED = 3 };

/* What was read, in a list. */
struct paper {
    const char *path, *text;
    int size;
    cagd_latex latex;
    const struct paper *next;
};

/* ---- a source ------------------------------------------------------------------------------------------ */

static int ends_in(const char *path, const char *end)
{
    size_t n = strlen(path), m = strlen(end);
    return n > m && strcmp(path + n - m, end) == 0;
}

static int contains(const char *text, int size, const char *word)
{
    int n = (int)strlen(word);
    for (int k = 0; k + n <= size; k++)
        if (memcmp(text + k, word, (size_t)n) == 0)
            return 1;
    return 0;
}

int is_paper(const char *path, const char *text, int size)
{
    if (strcmp(path, "-") != 0)
        return ends_in(path, ".tex") || ends_in(path, ".ltx");
    return !contains(text, size, ":::") && (contains(text, size, "\\begin{") || contains(text, size, "\\["));
}

static struct paper *add_paper(struct document *d, const char *path, const char *text, int size)
{
    struct paper *p = region_bytes(sizeof *p);
    if (p == NULL)
        abort();
    *p = (struct paper){path, text, size, {{0}, 0, 0, 0, 0, 0, 0}, d->papers};
    d->papers = p;
    cagd_read_latex(text, size, &p->latex);
    for (int k = 0; k < p->latex.troubles; k++) {
        const cagd_latex_trouble *t = &p->latex.trouble[k];
        if (t->is_command)
            continue;
        if (t->is_remark)
            remark_in(d, path, text, size, t->from, t->to, t->message);
        else
            complain_in(d, path, text, size, t->from, t->to, "%s", t->message);
    }
    return p;
}

const char *trouble_of_command(const struct document *d, const char *source, int at)
{
    for (const struct paper *p = d->papers; p != NULL; p = p->next)
        for (int k = 0; p->text == source && k < p->latex.troubles; k++)
            if (p->latex.trouble[k].is_command && p->latex.trouble[k].from == at)
                return p->latex.trouble[k].message;
    return NULL;
}

/* ---- blocks -------------------------------------------------------------------------------------------- */

/* A text of blocks that grows, with what it comes from. */
struct blocks {
    struct document *d;
    const struct paper *paper;
    cagd_latex_text text;
    int at; /* of the source: what is put between comes from there */
};

static void put_word(struct blocks *b, const char *word)
{
    for (; *word != '\0'; word++)
        cagd_latex_put(&b->text, *word, b->at);
}

static void put_bytes(struct blocks *b, int from, int to)
{
    const cagd_latex_text *t = &b->paper->latex.text;
    for (int k = from; k < to; k++)
        cagd_latex_put(&b->text, t->bytes[k], t->from[k]);
}

/* The word that a comment begins with, and where its value begins. */
static int says(const struct paper *p, const cagd_latex_note *note, const char *word, int *value)
{
    const char *s = p->latex.text.bytes + note->from;
    int n = (int)strlen(word), length = note->to - note->from, k = n;
    if (length < n || memcmp(s, word, (size_t)n) != 0 || (length > n && isalpha((unsigned char)s[n])))
        return 0;
    k += k < length && s[k] == ':';
    while (k < length && isspace((unsigned char)s[k]))
        k++;
    *value = note->from + k;
    return 1;
}

/* The comment of that word, of the first one; NULL where there is none. */
static const cagd_latex_note *note_of(const struct paper *p, const cagd_latex_item *f, const char *word, int *value)
{
    for (int k = 0; k < f->notes; k++)
        if (says(p, &f->note[k], word, value))
            return &f->note[k];
    return NULL;
}

static const char *const lines[] = {"find", "expected", "seconds", "title", "source", "without"};
enum { LINES = sizeof lines / sizeof *lines };

/* Every comment begins with a word that is known. */
static void look_at_notes(const struct blocks *b, const cagd_latex_item *f)
{
    static const char *const others[] = {"for", "statement", "definition", "skip"};
    const struct paper *p = b->paper;
    for (int k = 0; k < f->notes; k++) {
        const cagd_latex_note *note = &f->note[k];
        int known = 0, value;
        for (int m = 0; m < LINES; m++)
            known |= says(p, note, lines[m], &value);
        for (size_t m = 0; m < sizeof others / sizeof *others; m++)
            known |= says(p, note, others[m], &value);
        int from = note->from < p->latex.text.size ? p->latex.text.from[note->from] : 0;
        if (!known)
            complain_in(b->d, p->path, p->text, p->size, from, from + note->to - note->from,
                        "expected let, definition, statement, for, find, expected, seconds, title, without or skip "
                        "behind cagd:");
    }
}

static void put_formula(struct blocks *b, const cagd_latex_item *f)
{
    put_bytes(b, f->from, f->to);
    put_word(b, "\n");
}

/* ":for:" with all that comments say of ranges, and the other lines. */
static void put_lines(struct blocks *b, const cagd_latex_item *f)
{
    int value, count = 0;
    for (int k = 0; k < f->notes; k++)
        if (says(b->paper, &f->note[k], "for", &value)) {
            put_word(b, count++ == 0 ? ":for: " : ", ");
            put_bytes(b, value, f->note[k].to);
        }
    put_word(b, count > 0 ? "\n" : "");
    for (int m = 0; m < LINES; m++) {
        const cagd_latex_note *note = note_of(b->paper, f, lines[m], &value);
        if (note == NULL)
            continue;
        put_word(b, ":");
        put_word(b, lines[m]);
        put_word(b, ": ");
        put_bytes(b, value, note->to);
        put_word(b, "\n");
    }
}

/* The name in the comment, or of the label, or else the line. */
static void put_name(struct blocks *b, const cagd_latex_item *f)
{
    int value;
    int at_line, column;
    char line[32];
    const cagd_latex_note *note = note_of(b->paper, f, "statement", &value);
    count_lines(b->d, b->paper->text, f->at, &at_line, &column);
    snprintf(line, sizeof line, "line-%d", at_line);
    if (note != NULL && value < note->to)
        put_bytes(b, value, note->to);
    else
        put_word(b, f->name != NULL ? f->name : line);
    put_word(b, "\n");
}

static void put_item(struct blocks *b, const cagd_latex_item *f)
{
    int value, is_statement = note_of(b->paper, f, "statement", &value) != NULL;
    b->at = f->at;
    look_at_notes(b, f);
    if (note_of(b->paper, f, "skip", &value) != NULL ||
        (f->name == NULL && f->notes == 0 && !f->is_definition && !f->is_let)) {
        b->d->unlabelled += note_of(b->paper, f, "skip", &value) == NULL;
        return;
    }
    if (f->is_let || note_of(b->paper, f, "definition", &value) != NULL) {
        put_word(b, ":::{let}\n");
        put_formula(b, f);
    } else if (f->is_definition && !is_statement) {
        put_word(b, ":::{defined} ");
        put_name(b, f);
        put_formula(b, f);
    } else {
        put_word(b, f->notes > 0 ? ":::{statement} " : ":::{equation} ");
        put_name(b, f);
        put_word(b, ":printed: ");
        put_formula(b, f);
        put_lines(b, f);
    }
    put_word(b, ":::\n");
}

/* Bytes of the document's text that come from a source. */
static int add_chunk(struct document *d, const struct paper *p, int at, int to, const int *from)
{
    if (d->chunks == MOST_CHUNKS)
        return 0;
    d->chunk[d->chunks++] = (struct chunk){at, to, p->path, p->text, p->size, from};
    return 1;
}

void put_paper(struct document *d)
{
    struct paper *p = add_paper(d, d->path, d->text, d->size);
    struct blocks b = {.d = d, .paper = p};
    for (int k = 0; k < p->latex.items && d->complaints == 0; k++)
        put_item(&b, &p->latex.item[k]);
    d->text = d->room = region_bytes(2 * LARGEST_FILE);
    if (d->room == NULL)
        abort();
    d->size = d->used = 0;
    if (!put_in_document(d, b.text.bytes, b.text.size))
        complain_in(d, p->path, p->text, p->size, 0, 1, "with its commands expanded it is larger than 8 MB");
    else if (b.text.size > 0)
        add_chunk(d, p, 0, b.text.size, b.text.from);
    d->size = d->used;
}

/* ---- a formula of a source ----------------------------------------------------------------------------- */

/* The file beside the document, read once; NULL and a complaint where it cannot be read. */
static const struct paper *paper_beside(struct document *d, const char *name, int from, int to)
{
    const char *slash = strrchr(d->path, '/');
    char path[LONGEST_PATH], *text;
    int n = name[0] != '/' && slash != NULL ? (int)(slash - d->path) + 1 : 0;
    snprintf(path, sizeof path, "%.*s%s", n, d->path, name);
    for (const struct paper *p = d->papers; p != NULL; p = p->next)
        if (strcmp(p->path, path) == 0)
            return p;
    if (strcmp(path, "-") == 0 || !ends_in(path, ".tex")) {
        complain(d, from, to, "expected a LaTeX source, such as paper.tex, and a label of it");
        return NULL;
    }
    int size = read_whole_file(path, &text), complaints = d->complaints;
    if (size < 0) {
        complain(d, from, to, "the source is not read");
        return NULL;
    }
    const struct paper *p = add_paper(d, cagd_text_of(path, (int)strlen(path)), text, size);
    return d->complaints == complaints ? p : NULL;
}

/* The labels that there are, the first of them. */
static const char *labels_of(const struct paper *p)
{
    char text[200] = "none";
    int used = 0, count = 0;
    for (int k = 0; k < p->latex.items && count < MOST_NAMED && used < 120; k++)
        if (p->latex.item[k].name != NULL)
            used += snprintf(text + used, sizeof text - (size_t)used, "%s%.30s", count++ > 0 ? ", " : "",
                             p->latex.item[k].name);
    return cagd_text_of(text, (int)strlen(text));
}

int put_from_paper(struct document *d, int from, int to, int *begin, int *end)
{
    int k = to;
    while (k > from && !isspace((unsigned char)d->text[k - 1]))
        k--;
    int file_end = k;
    while (file_end > from && isspace((unsigned char)d->text[file_end - 1]))
        file_end--;
    *begin = *end = d->used;
    if (file_end == from) {
        complain(d, from, to, "expected a LaTeX source, such as paper.tex, and a label of it");
        return 0;
    }
    const struct paper *p = paper_beside(d, cagd_text_of(d->text + from, file_end - from), from, file_end);
    for (int m = 0; p != NULL && m < p->latex.items; m++) {
        const cagd_latex_item *f = &p->latex.item[m];
        if (f->name == NULL || (int)strlen(f->name) != to - k || memcmp(f->name, d->text + k, (size_t)(to - k)) != 0)
            continue;
        if (!put_in_document(d, p->latex.text.bytes + f->from, f->to - f->from) ||
            !add_chunk(d, p, *begin, d->used, p->latex.text.from + f->from)) {
            complain(d, from, to, "too many formulas of other files");
            return 0;
        }
        *end = d->used;
        put_in_document(d, "\n", 1);
        return 1;
    }
    if (p != NULL)
        complain(d, k, to, "%s has no formula of that label; it has %s", p->path, labels_of(p));
    return 0;
}
