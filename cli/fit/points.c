/* points.c -- a file of points: its text, what kind of file it is, and what is kept of it. */
#include "cli/fit/points.h"
#include "cli/fit/reader.h"

#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

static const size_t MOST_BYTES = (size_t)1 << 29; /* of a file */

/* ---- places and errors --------------------------------------------------------------------------- */

/* The character of the line that `at` points to, from 1: bytes that begin no character of UTF-8 do not count. */
static int column_of(const struct reader *r, const char *at)
{
    int column = 1;
    for (const char *s = r->start; s < at; s++)
        column += ((unsigned char)*s & 0xc0) != 0x80;
    return column;
}

int refuse(const struct reader *r, const char *at, const char *format, ...)
{
    char place[64] = "";
    va_list list;
    if (r->line > 0 && at != NULL)
        snprintf(place, sizeof place, "line %d, column %d", r->line, column_of(r, at));
    else if (r->line > 0)
        snprintf(place, sizeof place, "line %d", r->line);
    va_start(list, format);
    input_refuse(r->error, place, format, list);
    va_end(list);
    return -1;
}

void go_to(struct reader *r, const char *at)
{
    if (r->line == 0)
        r->line = 1, r->start = r->next;
    for (const char *s = r->start; s < at; s++)
        if (*s == '\n' || (*s == '\r' && s[1] != '\n'))
            r->line++, r->start = (char *)s + 1;
}

/* ---- what is kept -------------------------------------------------------------------------------- */

int add_point(struct points *p, const double at[], double sigma, int line)
{
    if (p->count == p->room) {
        if (p->room > INT_MAX / 8)
            return -1;
        p->room = p->room == 0 ? 1024 : 2 * p->room;
        size_t n = (size_t)p->room;
        double *more = realloc(p->at, n * (size_t)p->dim * sizeof *more);
        p->at = more != NULL ? more : p->at;
        double *sigmas = realloc(p->sigma, n * sizeof *sigmas);
        p->sigma = sigmas != NULL ? sigmas : p->sigma;
        int *lines = realloc(p->line, n * sizeof *lines);
        p->line = lines != NULL ? lines : p->line;
        if (more == NULL || sigmas == NULL || lines == NULL)
            return -1;
    }
    memcpy(p->at + (size_t)p->count * (size_t)p->dim, at, (size_t)p->dim * sizeof *at);
    p->sigma[p->count] = sigma;
    p->line[p->count++] = line;
    return 0;
}

void note_of(struct points *p, const char *format, ...)
{
    va_list list;
    if (p->notes == MOST_NOTES)
        return;
    va_start(list, format);
    int length = vasprintf(&p->note[p->notes], format, list);
    va_end(list);
    for (int k = 0; k < length; k++) /* what a file says may be anything */
        if ((unsigned char)p->note[p->notes][k] < ' ' || p->note[p->notes][k] == '\x7f')
            p->note[p->notes][k] = ' ';
    p->notes += length >= 0;
}

void begin_stroke(struct strokes *s)
{
    s->count++;
    if (s->count <= MOST_STROKES)
        s->points[s->count - 1] = 0;
}

int add_to_stroke(struct strokes *s, struct points *p, const double at[], double sigma, int line)
{
    if (s->count <= MOST_STROKES)
        s->points[s->count - 1]++;
    return s->count > 1 ? 0 : add_point(p, at, sigma, line);
}

int is_same_point(const struct points *p, int i, int j)
{
    int same = 1;
    for (int c = 0; c < p->dim; c++)
        same &= p->at[i * p->dim + c] == p->at[j * p->dim + c];
    return same;
}

int close_stroke(struct strokes *s, struct points *p)
{
    if (s->count > 1 || p->count < 2)
        return 0;
    if (is_same_point(p, 0, p->count - 1))
        return 0;
    double first[3] = {0};
    memcpy(first, p->at, (size_t)p->dim * sizeof *first);
    return add_to_stroke(s, p, first, p->sigma[0], p->line[0]);
}

int only_stroke(struct reader *r, const struct strokes *s, const char *what)
{
    char counts[160] = "";
    r->line = 0;
    if (s->count == 0 || (s->count == 1 && s->points[0] == 0))
        return refuse(r, NULL, "there is no %s of points in it", what);
    if (s->count == 1)
        return 0;
    int shown = s->count < MOST_STROKES ? s->count : MOST_STROKES;
    for (int k = 0; k < shown; k++)
        snprintf(counts + strlen(counts), sizeof counts - strlen(counts), "%s%d", k > 0 ? ", " : "", s->points[k]);
    return refuse(r, NULL, "there are %d %ss in it, of %s%s points; expected one", s->count, what, counts,
                  shown < s->count ? ", ..." : "");
}

/* ---- the file ------------------------------------------------------------------------------------ */

/* The whole file, ended by a zero byte.  NULL and the error when it cannot be read, or has no end. */
static char *read_all(const char *path, size_t *length, const struct reader *r)
{
    struct input_error error;
    FILE *file = open_input(path, "the points", &error);
    if (file == NULL) {
        refuse(r, NULL, "%s", error.cause);
        return NULL;
    }
    size_t room = 1 << 16, used = 0, got;
    char *text = malloc(room);
    while (text != NULL && used <= MOST_BYTES && (got = fread(text + used, 1, room - used - 1, file)) > 0)
        if ((used += got) == room - 1) {
            char *more = realloc(text, room *= 2);
            if (more == NULL)
                free(text);
            text = more;
        }
    int trouble = text == NULL ? ENOMEM : ferror(file) ? errno : 0;
    if (file != stdin)
        fclose(file);
    if (trouble != 0 || used > MOST_BYTES) {
        free(text);
        if (trouble != 0)
            refuse(r, NULL, "%s", strerror(trouble));
        else
            refuse(r, NULL, "more than %zu bytes, the largest size that is read; divide it", MOST_BYTES);
        return NULL;
    }
    text[used] = '\0';
    *length = used;
    return text;
}

/* A text in bytes, without a mark at its beginning. */
static int check_text(struct reader *r)
{
    size_t length = (size_t)(r->end - r->next);
    if (length >= 2 && (memcmp(r->next, "\xff\xfe", 2) == 0 || memcmp(r->next, "\xfe\xff", 2) == 0))
        return refuse(r, NULL, "the text is in UTF-16, expected UTF-8");
    if (memchr(r->next, '\0', length) != NULL)
        return refuse(r, NULL, "there is a zero byte in it, expected a text");
    if (length >= 3 && memcmp(r->next, "\xef\xbb\xbf", 3) == 0)
        r->next += 3;
    return 0;
}

/* Whether some tag of the text begins so. */
static int has_tag(const char *text, const char *name)
{
    size_t n = strlen(name);
    for (const char *s = text; (s = strchr(s, '<')) != NULL; s++)
        if (strncasecmp(s + 1, name, n) == 0)
            return 1;
    return 0;
}

/* Whether the text begins with the pair 0, SECTION of a DXF file, perhaps after comments, the pairs 999. */
static int is_dxf(const char *s)
{
    int code, length = 0; /* 0 where no line ends behind the number */
    while (sscanf(s, "%d%*[\r\n]%n", &code, &length) == 1 && code == 999 && length > 0) {
        s += length;
        length = 0;
        s += strcspn(s, "\r\n");
        s += strspn(s, "\r\n");
    }
    char word[16];
    return sscanf(s, "%d %15s", &code, word) == 2 && code == 0 && strcmp(word, "SECTION") == 0;
}

static int read_format(struct reader *r, const struct columns *asked, struct points *p)
{
    const char *first = r->next + strspn(r->next, " \t\r\n");
    if (*first == '[' || *first == '{')
        return read_json_points(r, asked, p);
    if (*first == '<' && has_tag(r->next, "gpx"))
        return read_gpx(r, asked, p);
    if (*first == '<' && has_tag(r->next, "svg"))
        return read_svg(r, asked, p);
    if (*first == '<')
        return refuse(r, NULL, "the tags are neither those of GPX nor of SVG");
    if (is_dxf(first))
        return read_dxf(r, asked, p);
    return read_table(r, asked, p);
}

int read_points(const char *path, const struct columns *asked, struct points *p, struct input_error *error)
{
    size_t length;
    struct reader r = {.error = error};
    *p = (struct points){.format = "table"};
    char *text = read_all(path, &length, &r);
    if (text == NULL)
        return -1;
    r.next = text;
    r.end = text + length;
    int bad = check_text(&r) != 0 || read_format(&r, asked, p) != 0;
    free(text);
    if (bad) {
        free_points(p);
        return -1;
    }
    if (!p->has_sigma) {
        free(p->sigma);
        p->sigma = NULL;
    }
    return 0;
}

void free_points(struct points *p)
{
    for (int k = 0; k < p->notes; k++)
        free(p->note[k]);
    free(p->at);
    free(p->sigma);
    free(p->line);
    *p = (struct points){0};
}
