/* layout.c -- paragraphs of text and formulas. */
#include "cli/layout.h"
#include "chapters/judge/memory_text.h"

#include "cli/terminal.h"

#include <stdlib.h>
#include <string.h>

enum { MOST = 16 }; /* rows and columns of a matrix that is laid out, words of a line by tens */

static void *must(void *p)
{
    if (p == NULL)
        abort();
    return p;
}

/* ---- matrices in one line ------------------------------------------------------------------------ */

static const char *closing(char bracket)
{
    return bracket == '(' ? ")" : bracket == '[' ? "]" : bracket == '|' ? "|" : "";
}

char *in_one_line(const char *text)
{
    char *line = NULL, open[MOST + 1] = {0};
    size_t room;
    int depth = 0;
    FILE *out = text_open(&line, &room);
    for (const char *s = text; *s != '\0'; s++) {
        if (*s == MATRIX && s[1] != '\0' && depth < MOST)
            open[++depth] = *++s, fputs(*s != ROWS ? (char[]){*s, '\0'} : "", out);
        else if (*s == MATRIX_END)
            fputs(depth > 0 ? closing(open[depth--]) : "", out);
        else if (*s == NEXT_CELL || *s == NEXT_ROW)
            fputs(*s == NEXT_ROW ? "; " : open[depth] != ROWS ? ", " : " ", out);
        else
            fputc(*s == TIE ? ' ' : *s, out);
    }
    text_close(out, &line);
    return line;
}

/* ---- a matrix -------------------------------------------------------------------------------------- */

struct matrix {
    char bracket;
    int rows, columns, width[MOST];
    char *cell[MOST][MOST];
};

/* The end of the matrix that begins at s, behind its MATRIX_END. */
static const char *end_of_matrix(const char *s)
{
    int depth = 0;
    do {
        depth += (*s == MATRIX) - (*s == MATRIX_END);
        s++;
    } while (*s != '\0' && depth > 0);
    return s;
}

static void free_matrix(struct matrix *m)
{
    for (int i = 0; i < m->rows; i++)
        for (int j = 0; j < m->columns; j++)
            free(m->cell[i][j]);
}

/* Reads it; returns whether it is small enough to be laid out. */
static int read_matrix(const char *s, struct matrix *m)
{
    *m = (struct matrix){.bracket = s[1], .rows = 1};
    const char *end = end_of_matrix(s) - 1;
    int i = 0, j = 0, fits = 1;
    for (const char *cell = s + 2, *at = cell; fits && at <= end; at++) {
        if (at < end && *at == MATRIX) {
            at = end_of_matrix(at) - 1;
        } else if (at == end || *at == NEXT_CELL || *at == NEXT_ROW) {
            char *raw = must(strndup(cell, (size_t)(at - cell)));
            m->cell[i][j] = in_one_line(raw + strspn(raw, " "));
            free(raw);
            for (size_t n = strlen(m->cell[i][j]); n > 0 && m->cell[i][j][n - 1] == ' ';)
                m->cell[i][j][--n] = '\0';
            int wide = columns_of(m->cell[i][j]);
            m->width[j] = wide > m->width[j] ? wide : m->width[j];
            j++;
            m->columns = j > m->columns ? j : m->columns;
            m->rows = i + 1;
            if (at < end && *at == NEXT_ROW)
                i++, j = 0;
            fits = i < MOST && j < MOST;
            cell = at + 1;
        }
    }
    return fits;
}

/* The blanks before a column: of rows one before the relation, as in a = b. */
static int before_column(const struct matrix *m, int j)
{
    return j == 0 ? 0 : m->bracket == ROWS && j % 2 == 1 ? 1 : 2;
}

static int matrix_columns(const struct matrix *m)
{
    int columns = m->bracket == ROWS ? 0 : m->bracket == '{' ? 2 : 4; /* the brackets, and a blank beside each */
    for (int j = 0; j < m->columns; j++)
        columns += m->width[j] + before_column(m, j);
    return columns;
}

/* The bracket in one of the rows: whole, or its first, middle or last part. */
static const char *bracket_in_row(char bracket, int left, int row, int rows)
{
    static const struct {
        char bracket;
        const char *left[4], *right[4];
    } parts[] = {{'(', {"(", "⎛", "⎜", "⎝"}, {")", "⎞", "⎟", "⎠"}},
                 {'[', {"[", "⎡", "⎢", "⎣"}, {"]", "⎤", "⎥", "⎦"}},
                 {'|', {"│", "│", "│", "│"}, {"│", "│", "│", "│"}},
                 {'{', {"{", "⎧", "⎨", "⎩"}, {"", "", "", ""}}};
    int part = rows == 1 ? 0 : row == 0 ? 1 : row == rows - 1 ? 3 : 2;
    for (size_t k = 0; k < sizeof parts / sizeof *parts; k++)
        if (parts[k].bracket == bracket)
            return left ? parts[k].left[part] : parts[k].right[part];
    return "";
}

/* Numbers and formulas stand in the middle of their columns, the cases of a function at the left, formulas below one another at their relations. */
static void put_row(FILE *out, const struct matrix *m, int row)
{
    if (m->bracket != ROWS)
        fprintf(out, "%s ", bracket_in_row(m->bracket, 1, row, m->rows));
    for (int j = 0; j < m->columns; j++) {
        const char *cell = m->cell[row][j] != NULL ? m->cell[row][j] : "";
        const int room = m->width[j] - columns_of(cell);
        int before = m->bracket == '{' ? 0 : m->bracket != ROWS ? room / 2 : j % 2 == 0 && m->columns > 1 ? room : 0;
        fprintf(out, "%*s", before_column(m, j) + before, "");
        put_padded(out, cell, m->width[j] - before);
    }
    if (m->bracket != '{' && m->bracket != ROWS)
        fprintf(out, " %s", bracket_in_row(m->bracket, 0, row, m->rows));
}

/* ---- a word: text and matrices without a blank between ------------------------------------------- */

struct word {
    const char *at, *end;
    int columns, glued; /* glued: no blank before it                  */
    int above, below;   /* how many lines it needs beside its own one */
};

static const char *end_of_text(const char *s, const char *end)
{
    while (s < end && *s != MATRIX)
        s++;
    return s;
}

/* Returns whether all of its matrices can be laid out. */
static int measure(struct word *w)
{
    int fits = 1;
    w->columns = w->above = w->below = 0;
    for (const char *s = w->at; s < w->end;) {
        if (*s == MATRIX) {
            struct matrix m;
            fits &= read_matrix(s, &m);
            w->columns += matrix_columns(&m);
            w->above = (m.rows - 1) / 2 > w->above ? (m.rows - 1) / 2 : w->above;
            w->below = m.rows / 2 > w->below ? m.rows / 2 : w->below;
            free_matrix(&m);
            s = end_of_matrix(s);
        } else {
            const char *end = end_of_text(s, w->end);
            w->columns += columns_between(s, end);
            s = end;
        }
    }
    return fits;
}

/* What of the word is in a line, counted from its own: text in line 0.  *blanks are pending before. */
static void put_word(FILE *out, const struct word *w, int line, int *blanks)
{
    *blanks += !w->glued;
    for (const char *s = w->at; s < w->end;) {
        const char *end = *s == MATRIX ? end_of_matrix(s) : end_of_text(s, w->end);
        struct matrix m = {0};
        if (*s == MATRIX)
            (void)read_matrix(s, &m);
        int row = line + (m.rows - 1) / 2;
        if (*s == MATRIX && row >= 0 && row < m.rows) {
            fprintf(out, "%*s", *blanks, "");
            put_row(out, &m, row);
            *blanks = 0;
        } else if (*s == MATRIX) {
            *blanks += matrix_columns(&m);
        } else if (line == 0) {
            fprintf(out, "%*s", *blanks, "");
            for (const char *c = s; c < end; c++)
                fputc(*c == TIE ? ' ' : *c, out);
            *blanks = 0;
        } else {
            *blanks += columns_between(s, end);
        }
        free_matrix(&m);
        s = end;
    }
}

/* ---- lines ----------------------------------------------------------------------------------------- */

/* `used` columns of the first line are taken already; the others begin behind `indent` blanks. */
struct line {
    struct word *word;
    int count, columns, used, indent;
};

static int room_in(const struct line *l, int width) { return width - (l->used > 0 ? l->used : l->indent); }

static void put_line(FILE *out, struct line *l)
{
    int above = 0, below = 0;
    struct word *last = l->count > 0 ? &l->word[l->count - 1] : NULL;
    while (last != NULL && last->end > last->at && last->end[-1] == TIE)
        last->end--;
    for (int k = 0; k < l->count; k++) {
        above = l->word[k].above > above ? l->word[k].above : above;
        below = l->word[k].below > below ? l->word[k].below : below;
    }
    for (int at = -above; at <= below && l->count > 0; at++) {
        int blanks = l->used == 0 ? l->indent : at == -above ? 0 : l->used; /* of the first line l->used are printed */
        for (int k = 0; k < l->count; k++)
            put_word(out, &l->word[k], at, &blanks);
        fputc('\n', out);
    }
    l->count = l->columns = l->used = 0;
}

/* The next word of the text from s on; at == end where there is none. */
static struct word next_word(const char *s, const char *begin)
{
    s += strspn(s, " \n");
    struct word w = {.at = s, .glued = s > begin && s[-1] != ' ' && s[-1] != '\n'};
    while (*s != '\0' && *s != ' ' && *s != '\n') {
        if (*s == MATRIX) {
            s = end_of_matrix(s);
            continue;
        }
        const char *next = end_of_character(s);
        int is_wide = columns_between(s, next) == 2;
        s = next;
        if (is_wide)
            break;
    }
    w.end = s;
    return w;
}

static void fill(FILE *out, const char *text, struct line l, int width)
{
    int room = 0, printed = 0;
    for (struct word w = next_word(text, text); w.at < w.end; w = next_word(w.end, text)) {
        int fits = measure(&w), has_matrix = memchr(w.at, MATRIX, (size_t)(w.end - w.at)) != NULL;
        if (has_matrix && (!fits || w.columns > width - l.indent)) {
            char *raw = must(strndup(w.at, (size_t)(w.end - w.at))), *flat = in_one_line(raw);
            put_line(out, &l);
            put_paragraph(out, flat, l.indent, width);
            printed = 1;
            free(raw), free(flat);
            continue;
        }
        int full = l.count > 0 && l.columns + !w.glued + w.columns > room_in(&l, width);
        if (full || (l.used > 0 && (w.above > 0 || w.columns > room_in(&l, width)))) {
            if (l.count == 0)
                fputc('\n', out);
            put_line(out, &l), printed = 1;
        }
        if (l.count == room)
            l.word = must(realloc(l.word, (size_t)(room += MOST) * sizeof *l.word));
        w.glued |= l.count == 0;
        l.columns += !w.glued + w.columns;
        l.word[l.count++] = w;
    }
    if (l.count > 0)
        put_line(out, &l);
    else if (!printed)
        fputc('\n', out);
    free(l.word);
}

void put_paragraph(FILE *out, const char *text, int indent, int width)
{
    fill(out, text, (struct line){.indent = indent}, width);
}

void put_behind(FILE *out, const char *text, int used, int indent, int width)
{
    fill(out, text, (struct line){.used = used, .indent = indent}, width);
}

void put_value(FILE *out, const char *name, const char *value, int indent, int columns, int width)
{
    char *tied = must(strdup(value));
    int depth = 0, own = columns_of(name);
    for (char *c = tied; *c != '\0'; c++) {
        depth += (*c == '(') - (*c == ')');
        *c = (char)(*c == ' ' && depth == 1 ? TIE : *c);
    }
    if (indent + own + 3 > width) { /* a name that is a sentence */
        put_paragraph(out, name, indent, width);
        put_paragraph(out, tied, 2 * indent, width);
    } else {
        fprintf(out, "%*s", indent, "");
        put_padded(out, name, columns);
        fputs(" = ", out);
        int first = indent + (own > columns ? own : columns) + 3;
        put_behind(out, tied, first, own > columns ? 2 * indent : first, width);
    }
    free(tied);
}
