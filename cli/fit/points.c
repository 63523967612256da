#include "cli/fit/points.h"

#include <ctype.h>
#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum { MOST_FIELDS = 256, MOST_SHOWN = 40 };
enum role { X, Y, Z, SIGMA, ROLES };
static const char *const role_name[ROLES] = {"x", "y", "z", "sigma"};

/* A piece of the file, without the quotes around it. */
struct field {
    char *at;
    size_t length;
    int quoted;
};

struct reader {
    struct input_error *error;
    char *next, *end;  /* what is still to be read               */
    char *start;       /* the line read last                     */
    int line;          /* its number                             */
    char separator;    /* ';', '\t', ',', ' '; 0: not known yet  */
    int comma, point;  /* lines of the first decimal comma and of the first decimal point; 0: none     */
    int column[ROLES]; /* where each is, from 0; -1: nowhere                                          */
    int fields;        /* of every line                                                               */
    int dim;
};

/* The character of the line that `at` points to, from 1: bytes that begin no character of UTF-8 do not count. */
static int column_of(const struct reader *r, const char *at)
{
    int column = 1;
    for (const char *s = r->start; s < at; s++)
        column += ((unsigned char)*s & 0xc0) != 0x80;
    return column;
}

/* Notes the error: in the line read last, at the character that `at` points to unless it is NULL; -1. */
static int refuse(const struct reader *r, const char *at, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
static int refuse(const struct reader *r, const char *at, const char *format, ...)
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

/* ---- the file ------------------------------------------------------------------------------------ */

/* The whole file, ended by a zero byte.  NULL and errno when it cannot be read. */
static char *read_all(const char *path, size_t *length)
{
    FILE *file = strcmp(path, "-") == 0 ? stdin : fopen(path, "rb");
    if (file == NULL)
        return NULL;
    size_t room = 1 << 16, used = 0, got;
    char *text = malloc(room);
    while (text != NULL && (got = fread(text + used, 1, room - used - 1, file)) > 0)
        if ((used += got) == room - 1) {
            char *more = realloc(text, room *= 2);
            if (more == NULL)
                free(text);
            text = more;
        }
    int trouble = text == NULL ? ENOMEM : ferror(file) ? errno : 0;
    if (file != stdin)
        fclose(file);
    if (trouble != 0) {
        free(text);
        errno = trouble;
        return NULL;
    }
    text[used] = '\0';
    *length = used;
    return text;
}

static int is_blank(char c) { return c == ' ' || c == '\t' || c == '\f' || c == '\v'; }

/* The next line that says something, without blanks around it and ended by a zero byte; NULL at the end. */
static char *next_line(struct reader *r)
{
    while (r->next < r->end) {
        char *line = r->next, *stop = line;
        while (stop < r->end && *stop != '\n' && *stop != '\r')
            stop++;
        r->start = line;
        r->next = stop + (stop + 1 < r->end && stop[0] == '\r' && stop[1] == '\n') + 1;
        r->line++;
        while (stop > line && is_blank(stop[-1]))
            stop--;
        *stop = '\0';
        while (line < stop && is_blank(*line))
            line++;
        if (line < stop && *line != '#')
            return line;
    }
    return NULL;
}

/* ---- fields -------------------------------------------------------------------------------------- */

/* The field that begins at s; returns where it ends, or NULL when a quote is not closed. */
static char *one_field(char *s, const char *separators, struct field *f)
{
    f->quoted = *s == '"';
    if (!f->quoted) {
        f->at = s;
        s += strcspn(s, separators);
        for (f->length = (size_t)(s - f->at); f->length > 0 && is_blank(f->at[f->length - 1]);)
            f->length--;
        return s;
    }
    char *to = f->at = ++s; /* a doubled quote is one quote */
    for (; *s != '\0' && !(*s == '"' && s[1] != '"'); s++)
        *to++ = *(s += *s == '"');
    f->length = (size_t)(to - f->at);
    while (f->length > 0 && is_blank(*f->at))
        f->at++, f->length--;
    while (f->length > 0 && is_blank(f->at[f->length - 1]))
        f->length--;
    return *s == '"' ? s + 1 : NULL;
}

/* The fields of a line; -1 and the error when a quote is not closed or something follows it. */
static int fields_of(const struct reader *r, char *line, struct field *field)
{
    const char one[] = {r->separator, '\0'};
    int runs = r->separator == ' ' || r->separator == '\t', count = 0;
    const char *separators = runs ? r->separator == ' ' ? " \t\f\v" : "\t" : one;
    for (char *s = line; *s != '\0'; count++) {
        struct field f;
        while (is_blank(*s) && strchr(separators, *s) == NULL)
            s++;
        if ((s = one_field(s, separators, &f)) == NULL)
            return refuse(r, NULL, "a quote is opened and not closed");
        while (is_blank(*s) && strchr(separators, *s) == NULL)
            s++;
        if (*s != '\0' && strchr(separators, *s) == NULL)
            return refuse(r, s, "expected a separator after the closing quote, not '%.*s'", MOST_SHOWN, s);
        s += *s != '\0';
        while (runs && *s != '\0' && strchr(separators, *s) != NULL)
            s++;
        if (count < MOST_FIELDS)
            field[count] = f;
    }
    if (count > MOST_FIELDS)
        return refuse(r, NULL, "%d fields, expected at most %d", count, MOST_FIELDS);
    return count;
}

/* What the line is separated by: 0 when it has one field only. */
static char separator_of(const char *line)
{
    int quoted = 0, semicolon = 0, tab = 0, comma = 0, blank = 0;
    for (const char *s = line; *s != '\0'; s++) {
        quoted ^= *s == '"';
        if (quoted)
            continue;
        semicolon |= *s == ';';
        tab |= *s == '\t';
        comma |= *s == ',';
        if (*s == ' ' && s > line && s[-1] != ',' && s[-1] != ' ')
            blank |= s[strspn(s, " ")] != ',';
    }
    return semicolon ? ';' : tab ? '\t' : blank ? ' ' : comma ? ',' : '\0';
}

enum number { NUMBER, NO_NUMBER, TWO_MARKS, NOT_FINITE, TOO_LARGE };

/* The number that the field is.  The program keeps the C locale for numbers, in which strtod takes the decimal point and
 * rounds correctly. */
static enum number number_of(struct reader *r, const struct field *f, double *value)
{
    char *stop = f->at + f->length, *end;
    if (f->length == 0)
        return NO_NUMBER;
    char *comma = r->separator != ',' || f->quoted ? memchr(f->at, ',', f->length) : NULL;
    char *point = memchr(f->at, '.', f->length);
    if (comma != NULL &&
        (point != NULL || comma == f->at || !isdigit((unsigned char)comma[-1]) || !isdigit((unsigned char)comma[1])))
        return NO_NUMBER;
    char after = *stop;
    *stop = '\0';
    if (comma != NULL)
        *comma = '.';
    errno = 0;
    *value = strtod(f->at, &end);
    if (comma != NULL)
        *comma = ',';
    *stop = after;
    if (end != stop)
        return NO_NUMBER;
    if (!isfinite(*value))
        return errno == ERANGE ? TOO_LARGE : NOT_FINITE;
    int *mark = comma != NULL ? &r->comma : point != NULL ? &r->point : NULL;
    if (mark != NULL && *mark == 0)
        *mark = r->line;
    return r->comma != 0 && r->point != 0 ? TWO_MARKS : NUMBER;
}

/* Whether some piece of the line is a number, however its fields are separated. */
static int has_number(const char *line)
{
    for (const char *s = line; *(s += strspn(s, " \t,;\"\f\v")) != '\0';) {
        size_t length = strcspn(s, " \t,;\"\f\v");
        char *end;
        strtod(s, &end);
        if (end > s && end == s + length)
            return 1;
        s += length;
    }
    return 0;
}

/* ---- columns ------------------------------------------------------------------------------------- */

/* Whether the field is this name, perhaps with a unit after it. */
static int is_called(const struct field *f, const char *name)
{
    size_t n = strlen(name);
    return f->length >= n && strncasecmp(f->at, name, n) == 0 && (f->length == n || strchr(" \t[(/", f->at[n]) != NULL);
}

static int role_of(const struct field *f)
{
    static const char *const sigmas[] = {"sigma", "s", "sd", "std", "stddev", "σ"};
    for (int k = X; k <= Z; k++)
        if (is_called(f, role_name[k]))
            return k;
    for (size_t k = 0; k < sizeof sigmas / sizeof *sigmas; k++)
        if (is_called(f, sigmas[k]))
            return SIGMA;
    return ROLES;
}

static int is_whole(const struct field *f, const char *name)
{
    return strlen(name) == f->length && strncasecmp(f->at, name, f->length) == 0;
}

/* The column that --sigma-column means, from 0. */
static int asked_sigma(const struct reader *r, const char *asked, const struct field *names, int *column)
{
    char *end;
    long number = strtol(asked, &end, 10);
    if (*asked != '\0' && *end == '\0') {
        if (number < 1 || number > r->fields)
            return refuse(r, NULL, "--sigma-column %s: there are %d columns", asked, r->fields);
        *column = (int)number - 1;
        return 0;
    }
    for (int k = 0; names != NULL && k < r->fields; k++)
        if (is_whole(&names[k], asked) || is_called(&names[k], asked)) {
            *column = k;
            return 0;
        }
    return refuse(r, NULL, "--sigma-column %s: no column is called so%s", asked,
                  names == NULL ? "; there are no names, expected a number from 1" : "");
}

/* Columns by their names.  1 when the names say nothing. */
static int columns_by_name(struct reader *r, const struct columns *asked, const struct field *names)
{
    for (int k = 0; k < r->fields; k++) {
        int role = role_of(&names[k]);
        if (role == ROLES || (role == SIGMA && asked->sigma != NULL))
            continue;
        if (r->column[role] >= 0)
            return refuse(r, NULL, "two columns are called %s", role_name[role]);
        r->column[role] = k;
    }
    if (r->column[X] < 0 && r->column[Y] < 0) {
        for (int k = 0; k < ROLES; k++)
            r->column[k] = -1;
        return 1;
    }
    for (int k = X; k <= Y; k++)
        if (r->column[k] < 0)
            return refuse(r, NULL, "no column is called %s", role_name[k]);
    if (asked->dim == 3 && r->column[Z] < 0)
        return refuse(r, NULL, "--dim 3: no column is called z");
    if (asked->dim == 2)
        r->column[Z] = -1;
    return 0;
}

/* Columns in their order: coordinates, then the standard deviation, which may have been named already. */
static int columns_by_order(struct reader *r, const struct columns *asked)
{
    int known = r->column[SIGMA] >= 0, others = r->fields - known;
    int dim = asked->dim != 0 ? asked->dim : known ? others : r->fields == 3 ? 0 : r->fields == 4 ? 3 : r->fields;
    if (dim == 0)
        return refuse(r, NULL,
                      "three columns without names can be x y z or x y sigma; say which by --dim 3 or --dim 2");
    if (dim < 2 || dim > 3 || others < dim || others > dim + !known)
        return refuse(r, NULL,
                      asked->dim != 0 ? "%d column%s, expected %d coordinates and perhaps a standard deviation"
                                      : "%d column%s without names x and y, expected 2 or 3 coordinates and perhaps a "
                                        "standard deviation",
                      r->fields, r->fields == 1 ? "" : "s", dim);
    for (int k = 0, at = 0; k < dim; k++, at++)
        r->column[k] = at += at == r->column[SIGMA];
    if (!known && others == dim + 1)
        r->column[SIGMA] = dim;
    return 0;
}

/* From the first line, or from names.  0, or -1 and the error. */
static int find_columns(struct reader *r, const struct columns *asked, const struct field *names, int fields)
{
    r->fields = fields;
    for (int k = 0; k < ROLES; k++)
        r->column[k] = -1;
    int by_name = names == NULL ? 1 : columns_by_name(r, asked, names);
    if (by_name < 0)
        return -1;
    if (asked->sigma != NULL && asked_sigma(r, asked->sigma, names, &r->column[SIGMA]) != 0)
        return -1;
    for (int k = X; k <= Z; k++)
        if (r->column[SIGMA] >= 0 && r->column[k] == r->column[SIGMA])
            return refuse(r, NULL, "--sigma-column %s: that is the column of %s", asked->sigma, role_name[k]);
    if (by_name == 1 && columns_by_order(r, asked) != 0)
        return -1;
    r->dim = r->column[Z] >= 0 ? 3 : 2;
    return 0;
}

/* ---- the points ---------------------------------------------------------------------------------- */

static int grow(struct points *p, int *room)
{
    if (p->count < *room)
        return 0;
    if (*room > INT_MAX / 8)
        return -1;
    *room = *room == 0 ? 1024 : 2 * *room;
    size_t n = (size_t)*room;
    double *at = realloc(p->at, n * (size_t)p->dim * sizeof *at);
    p->at = at != NULL ? at : p->at;
    double *sigma = realloc(p->sigma, n * sizeof *sigma);
    p->sigma = sigma != NULL ? sigma : p->sigma;
    int *line = realloc(p->line, n * sizeof *line);
    p->line = line != NULL ? line : p->line;
    return at != NULL && sigma != NULL && line != NULL ? 0 : -1;
}

static int read_value(struct reader *r, const struct field *f, enum role role, double *value)
{
    int shown = f->length < MOST_SHOWN ? (int)f->length : MOST_SHOWN;
    switch (number_of(r, f, value)) {
    case NO_NUMBER:
        if (f->length == 0)
            return refuse(r, f->at, "%s is missing, expected a number", role_name[role]);
        return refuse(r, f->at, "%s: '%.*s' is not a number", role_name[role], shown, f->at);
    case NOT_FINITE:
        return refuse(r, f->at, "%s is %.*s, expected a finite number", role_name[role], shown, f->at);
    case TOO_LARGE:
        return refuse(r, f->at, "%s: '%.*s' is larger than any binary64 number", role_name[role], shown, f->at);
    case TWO_MARKS:
        return refuse(r, f->at, "%s: '%.*s' has a decimal %s, line %d a decimal %s; expected one of them throughout",
                      role_name[role], shown, f->at, r->comma == r->line ? "comma" : "point",
                      r->comma < r->point ? r->comma : r->point, r->comma == r->line ? "point" : "comma");
    case NUMBER:
        break;
    }
    if (role == SIGMA && *value <= 0)
        return refuse(r, f->at, "sigma is %.*s, expected a standard deviation > 0", shown, f->at);
    return 0;
}

static int read_row(struct reader *r, const struct field *field, int fields, struct points *p, int *room)
{
    if (fields != r->fields)
        return refuse(r, NULL, "%d field%s, expected %d", fields, fields == 1 ? "" : "s", r->fields);
    if (grow(p, room) != 0)
        return refuse(r, NULL, "memory is short");
    for (int k = X; k <= Z; k++)
        if (r->column[k] >= 0 && read_value(r, &field[r->column[k]], (enum role)k, &p->at[p->count * p->dim + k]) != 0)
            return -1;
    if (r->column[SIGMA] >= 0 && read_value(r, &field[r->column[SIGMA]], SIGMA, &p->sigma[p->count]) != 0)
        return -1;
    p->line[p->count++] = r->line;
    return 0;
}

/* Columns from the names, in a line that was read before this one. */
static int read_names(struct reader *r, const struct columns *asked, char *text, char *start, int line)
{
    struct field field[MOST_FIELDS];
    struct reader here = *r;
    r->line = line, r->start = start;
    int fields = fields_of(r, text, field);
    if (fields < 0 || find_columns(r, asked, field, fields) != 0)
        return -1;
    r->line = here.line, r->start = here.start;
    return 0;
}

static int read_rows(struct reader *r, const struct columns *asked, struct points *p)
{
    struct field field[MOST_FIELDS];
    int room = 0, line_of_names = 0;
    char *names = NULL, *start_of_names = NULL;
    for (char *line; (line = next_line(r)) != NULL;) {
        if (names == NULL && r->fields == 0 && !has_number(line)) {
            names = line; /* its separator is that of the numbers */
            line_of_names = r->line;
            start_of_names = r->start;
            continue;
        }
        if (r->separator == 0 && (r->separator = separator_of(line)) == 0)
            r->separator = ' ';
        int first = r->fields == 0;
        if (first && names != NULL && read_names(r, asked, names, start_of_names, line_of_names) != 0)
            return -1;
        int fields = fields_of(r, line, field);
        if (fields < 0 || (first && names == NULL && find_columns(r, asked, NULL, fields) != 0))
            return -1;
        p->dim = r->dim;
        if (read_row(r, field, fields, p, &room) != 0)
            return -1;
    }
    if (p->count == 0) {
        r->line = 0;
        return refuse(r, NULL, "there are no points in it; expected a line for each, such as 1.5, 2.25");
    }
    return 0;
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

int read_points(const char *path, const struct columns *asked, struct points *p, struct input_error *error)
{
    size_t length;
    struct reader r = {.error = error};
    *p = (struct points){0};
    char *text = read_all(path, &length);
    if (text == NULL)
        return refuse(&r, NULL, "%s", strerror(errno));
    r.next = text;
    r.end = text + length;
    int bad = check_text(&r) != 0 || read_rows(&r, asked, p) != 0;
    free(text);
    if (bad) {
        free_points(p);
        return -1;
    }
    if (r.column[SIGMA] < 0) {
        free(p->sigma);
        p->sigma = NULL;
    }
    return 0;
}

void free_points(struct points *p)
{
    free(p->at);
    free(p->sigma);
    free(p->line);
    *p = (struct points){0};
}
