/* drawings.c -- points of a GPX track, and of a path, polyline or polygon in SVG. */
#include "cli/fit/tags.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static int short_of_memory(const struct reader *r) { return refuse(r, NULL, "memory is short"); }

/* ---- GPX ----------------------------------------------------------------------------------------- */

static int angle_of(struct reader *r, const struct tag *t, const char *name, double most, double *x)
{
    const char *value, *stop = tag_attribute(t, name, &value), *s = value;
    if (stop == NULL || !read_number(&s, stop, x) || s + strspn(s, " ") < stop || fabs(*x) > most)
        return refuse(r, t->name, "%s of a point is missing, or no number of degrees up to %g", name, most);
    return 0;
}

/* The height of the point whose tag was read last, before the next point. */
static int height_of(struct reader *r, double *x)
{
    struct reader ahead = *r;
    struct tag t;
    while (next_tag(&ahead, &t) && !(t.closes && (is_tag(&t, "trkpt") || is_tag(&t, "rtept"))))
        if (is_tag(&t, "ele") && !t.closes) {
            const char *s = ahead.next + strspn(ahead.next, " \t\r\n");
            if (read_number(&s, s + strcspn(s, "<"), x))
                return 0;
        }
    return refuse(r, NULL, "--dim 3: the point has no height");
}

/* Degrees become metres east and north of the middle, in the plane that touches the ellipsoid there: its radii of
 * curvature are N = a/(1 - e^2 sin^2)^(1/2) across the meridian and M = N^3 (1 - e^2)/a^2 along it. */
static void flatten(struct points *p)
{
    const double a = 6378137, f = 1 / 298.257223563, degree = acos(-1) / 180, e2 = f * (2 - f);
    double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL}, middle[2];
    for (int i = 0; i < p->count; i++) {
        double *at = p->at + i * p->dim;
        at[0] -= 360 * rint((at[0] - p->at[0]) / 360); /* across the meridian of 180 degrees */
        for (int c = 0; c < 2; c++)
            low[c] = fmin(low[c], at[c]), high[c] = fmax(high[c], at[c]);
    }
    for (int c = 0; c < 2; c++)
        middle[c] = rint(1e4 * (low[c] + high[c]) / 2) / 1e4;
    double s = sin(middle[1] * degree), N = a / sqrt(1 - e2 * s * s), M = N * N * N * (1 - e2) / (a * a);
    for (int i = 0; i < p->count; i++) {
        double *at = p->at + i * p->dim;
        at[0] = N * cos(middle[1] * degree) * (at[0] - middle[0]) * degree;
        at[1] = M * (at[1] - middle[1]) * degree;
    }
    note_of(p, "degrees became metres east and north of %.4f, %.4f (longitude, latitude; WGS 84)", middle[0],
            middle[1]);
}

int read_gpx(struct reader *r, const struct columns *asked, struct points *p)
{
    struct strokes s = {0};
    struct tag t;
    int segments = 0, filled = 0;
    p->format = "GPX";
    p->dim = asked->dim == 3 ? 3 : 2;
    if (asked->sigma != NULL)
        return refuse(r, NULL, "--sigma-column %s: GPX has no columns", asked->sigma);
    while (next_tag(r, &t)) {
        double at[3] = {0};
        if (!t.closes && (is_tag(&t, "trk") || is_tag(&t, "rte")))
            begin_stroke(&s);
        if (!t.closes && is_tag(&t, "trkseg"))
            filled = 0;
        if (t.closes || !(is_tag(&t, "trkpt") || is_tag(&t, "rtept")))
            continue;
        if (s.count == 0)
            return refuse(r, NULL, "a point of a track stands outside all tracks");
        if (angle_of(r, &t, "lon", 360, &at[0]) != 0 || angle_of(r, &t, "lat", 90, &at[1]) != 0 ||
            (p->dim == 3 && height_of(r, &at[2]) != 0))
            return -1;
        segments += !filled && s.count == 1;
        filled = 1;
        if (add_to_stroke(&s, p, at, 0, r->line) != 0)
            return short_of_memory(r);
    }
    if (only_stroke(r, &s, "track") != 0)
        return -1;
    flatten(p);
    if (segments > 1)
        note_of(p, "the %d pieces of the track are joined", segments);
    return 0;
}

/* ---- SVG ----------------------------------------------------------------------------------------- */

struct drawing {
    struct reader *r;
    struct points *p;
    struct strokes strokes;
    double at[2], start[2]; /* where the pen is; where the line began */
    int curved;             /* pieces that are no straight lines      */
};

/* The separators between numbers: blanks, and one comma. */
static const char *past_separator(const char *s)
{
    s += strspn(s, " \t\r\n");
    s += *s == ',';
    return s + strspn(s, " \t\r\n");
}

static int put(struct drawing *d, double x, double y)
{
    d->at[0] = x, d->at[1] = y;
    return add_to_stroke(&d->strokes, d->p, d->at, 0, d->r->line) == 0 ? 0 : short_of_memory(d->r);
}

static int is_drawing_letter(char c) { return c != '\0' && strchr("MmLlHhVvCcSsQqTtAaZz", c) != NULL; }

/* So many numbers of an instruction; the flags of an arc are one digit each. */
static int read_numbers(const char **s, const char *end, char kind, int count, double v[])
{
    for (int k = 0; k < count; k++) {
        *s = past_separator(*s);
        if (kind == 'A' && (k == 3 || k == 4)) {
            if (**s != '0' && **s != '1')
                return 0;
            v[k] = *(*s)++ - '0';
        } else if (!read_number(s, end, &v[k])) {
            return 0;
        }
    }
    return 1;
}

/* One instruction with its numbers: the pen goes to the last two of them. */
static int obey(struct drawing *d, char letter, char kind, int count, const double v[])
{
    double x = d->at[0], y = d->at[1], relative = letter >= 'a' ? 1 : 0;
    if (kind == 'H')
        x = relative * x + v[0];
    else if (kind == 'V')
        y = relative * y + v[0];
    else
        x = relative * x + v[count - 2], y = relative * y + v[count - 1];
    d->curved += strchr("CSQTA", kind) != NULL && d->strokes.count == 1;
    if (kind == 'M') {
        d->start[0] = x, d->start[1] = y;
        begin_stroke(&d->strokes);
    }
    return put(d, x, y);
}

/* Of pieces that are curves only the ends are points of it that stand there. */
static int read_path(struct drawing *d, const char *s, const char *end)
{
    static const char kinds[] = "MLHVCSQTAZ";
    static const int numbers[] = {2, 2, 1, 1, 6, 4, 4, 2, 7, 0};
    char letter = '\0';
    for (s = past_separator(s); s < end; s = past_separator(s)) {
        go_to(d->r, s);
        int again = !is_drawing_letter(*s);
        if (!again)
            letter = *s++;
        else if (letter == 'M' || letter == 'm')
            letter--; /* further pairs of a move are lines: L, l */
        char kind = letter >= 'a' ? (char)(letter - 'a' + 'A') : letter;
        double v[7];
        if (letter == '\0' || (again && kind == 'Z') || (d->strokes.count == 0 && kind != 'M'))
            return refuse(d->r, s, "a path that does not begin with M");
        int count = numbers[strchr(kinds, kind) - kinds];
        if (!read_numbers(&s, end, kind, count, v))
            return refuse(d->r, s < end ? s : NULL, "expected a number of the path");
        if (kind == 'Z') {
            if (close_stroke(&d->strokes, d->p) != 0)
                return short_of_memory(d->r);
            memcpy(d->at, d->start, sizeof d->at);
        } else if (obey(d, letter, kind, count, v) != 0)
            return -1;
    }
    return 0;
}

static int read_pairs(struct drawing *d, const char *s, const char *end)
{
    double v[2];
    begin_stroke(&d->strokes);
    for (s = past_separator(s); s < end; s = past_separator(s)) {
        go_to(d->r, s);
        if (!read_numbers(&s, end, 'L', 2, v))
            return refuse(d->r, s, "expected a pair of numbers");
        if (put(d, v[0], v[1]) != 0)
            return -1;
    }
    return 0;
}

int read_svg(struct reader *r, const struct columns *asked, struct points *p)
{
    struct drawing d = {.r = r, .p = p};
    struct tag t;
    const char *value, *stop;
    int moved = 0;
    p->format = "SVG";
    p->dim = 2;
    if (asked->dim == 3 || asked->sigma != NULL)
        return refuse(r, NULL, "%s: SVG has points x y", asked->dim == 3 ? "--dim 3" : "--sigma-column");
    while (next_tag(r, &t)) {
        int path = is_tag(&t, "path"), polygon = is_tag(&t, "polygon"), polyline = is_tag(&t, "polyline");
        moved |= !t.closes && tag_attribute(&t, "transform", &value) != NULL;
        if (t.closes || !(path || polygon || polyline) ||
            (stop = tag_attribute(&t, path ? "d" : "points", &value)) == NULL)
            continue;
        if ((path ? read_path(&d, value, stop) : read_pairs(&d, value, stop)) != 0)
            return -1;
        if (polygon && close_stroke(&d.strokes, p) != 0)
            return short_of_memory(r);
    }
    if (only_stroke(r, &d.strokes, "path") != 0)
        return -1;
    note_of(p, "y is that of the drawing, which points down");
    if (d.curved > 0)
        note_of(p, "of %d curved piece%s of the path only the ends are taken", d.curved, d.curved == 1 ? "" : "s");
    if (moved)
        note_of(p, "transformations are not applied");
    return 0;
}
