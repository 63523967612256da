/* dxf.c -- the points of a polyline in DXF, or points on their own: pairs of lines, a code and a value. */
#include "cli/fit/reader.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum kind { OTHER, LIGHT, HEAVY, VERTEX, POINT };

struct dxf {
    struct reader *r;
    struct points *p;
    struct strokes strokes;
    enum kind kind;
    int in_entities, dim; /* dim: asked for, or 0                                   */
    int open, closed;     /* a vertex that waits for its other coordinates          */
    int line;             /* where it began                                         */
    double at[3];
    int arcs, singles;
};

/* A line without blanks around it, ended by a zero byte; NULL at the end. */
static char *next_value(struct reader *r)
{
    if (r->next >= r->end)
        return NULL;
    char *s = r->next, *stop = s + strcspn(s, "\r\n");
    r->start = s;
    r->line++;
    r->next = stop + (stop[0] == '\r' && stop[1] == '\n') + (stop < r->end);
    *stop = '\0';
    while (stop > s && (stop[-1] == ' ' || stop[-1] == '\t'))
        *--stop = '\0';
    return s + strspn(s, " \t");
}

static int put(struct dxf *d)
{
    if (!d->open)
        return 0;
    d->open = 0;
    return add_to_stroke(&d->strokes, d->p, d->at, 0, d->line) == 0 ? 0 : refuse(d->r, NULL, "memory is short");
}

/* The end of a polyline. */
static int finish(struct dxf *d)
{
    int closed = d->closed;
    d->closed = 0;
    if (put(d) != 0 || (closed && close_stroke(&d->strokes, d->p) != 0))
        return -1;
    return 0;
}

/* The beginning of an entity. */
static int begin(struct dxf *d, const char *name)
{
    int vertex = strcmp(name, "VERTEX") == 0;
    if (vertex && d->kind != HEAVY && d->kind != VERTEX)
        return refuse(d->r, name, "a VERTEX stands outside of a POLYLINE");
    if (vertex ? put(d) != 0 : finish(d) != 0)
        return -1;
    d->kind = strcmp(name, "LWPOLYLINE") == 0 ? LIGHT
              : strcmp(name, "POLYLINE") == 0 ? HEAVY
              : vertex                        ? VERTEX
              : strcmp(name, "POINT") == 0    ? POINT
                                              : OTHER;
    if (d->kind == LIGHT || d->kind == HEAVY || (d->kind == POINT && d->singles++ == 0))
        begin_stroke(&d->strokes);
    if (d->kind == VERTEX || d->kind == POINT) {
        d->open = 1;
        d->line = d->r->line;
        memset(d->at, 0, sizeof d->at);
    }
    return 0;
}

static int number(struct dxf *d, const char *text, double *x)
{
    char *end;
    *x = strtod(text, &end);
    if (end == text || *end != '\0' || !isfinite(*x))
        return refuse(d->r, text, "'%.40s' is not a number", text);
    return 0;
}

/* One pair inside of an entity. */
static int take(struct dxf *d, int code, const char *text)
{
    double x;
    if (d->kind == OTHER || (code != 10 && code != 20 && code != 30 && code != 42 && code != 70))
        return 0;
    if (number(d, text, &x) != 0)
        return -1;
    if (code == 42)
        d->arcs += x != 0 && d->kind != HEAVY;
    if (code == 70 && (d->kind == LIGHT || d->kind == HEAVY)) {
        int flags = x >= 0 && x < 1 << 15 ? (int)x : 0;
        d->closed = flags & 1;
        if (d->kind == HEAVY && flags & 8 && d->dim == 0 && d->p->count == 0)
            d->p->dim = 3;
    }
    if (d->kind == LIGHT && code == 10) {
        if (put(d) != 0)
            return -1;
        d->open = 1;
        d->line = d->r->line;
        memset(d->at, 0, sizeof d->at);
    }
    if (d->open && code <= 30)
        d->at[code / 10 - 1] = x;
    return 0;
}

int read_dxf(struct reader *r, const struct columns *asked, struct points *p)
{
    struct dxf d = {.r = r, .p = p, .dim = asked->dim};
    char *name, *value, *end;
    int section = 0;
    p->format = "DXF";
    p->dim = asked->dim == 3 ? 3 : 2;
    if (asked->sigma != NULL)
        return refuse(r, NULL, "--sigma-column %s: DXF has no columns", asked->sigma);
    while ((name = next_value(r)) != NULL) {
        long code = strtol(name, &end, 10);
        if (end == name || *end != '\0')
            return refuse(r, name, "'%.40s' is not the code of a pair", name);
        if ((value = next_value(r)) == NULL)
            return refuse(r, NULL, "the text ends inside of a pair");
        if (code == 0 && strcmp(value, "EOF") == 0)
            break;
        if (code == 999) /* a comment, which may stand between the pairs of a name */
            continue;
        if (code == 2 && section)
            d.in_entities = strcmp(value, "ENTITIES") == 0;
        section = code == 0 && strcmp(value, "SECTION") == 0;
        if (d.in_entities && (code == 0 ? begin(&d, value) : take(&d, (int)code, value)) != 0)
            return -1;
        if (code == 0 && strcmp(value, "ENDSEC") == 0)
            d.in_entities = 0;
    }
    if (finish(&d) != 0 || only_stroke(r, &d.strokes, "polyline") != 0)
        return -1;
    if (d.arcs > 0)
        note_of(p, "%d of the pieces of the polyline have a bulge: of these arcs only the ends are taken", d.arcs);
    return 0;
}
