/* json_points.c -- points in JSON: an array of points, points with names, arrays of coordinates, GeoJSON. */
#include "cli/fit/reader.h"

#include <jansson.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* The lines of points of a document: arrays of arrays of numbers, or of objects with x and y. */
struct found {
    json_t *lines;   /* an array of them                                */
    json_t *singles; /* GeoJSON points on their own, which are one line */
    int geojson;
};

static int is_number_array(const json_t *j)
{
    size_t k;
    json_t *one;
    int good = json_array_size(j) > 0;
    json_array_foreach(j, k, one) good = good && json_is_number(one);
    return good;
}

static void add_line(struct found *f, json_t *line) { json_array_append(f->lines, line); }

/* The value as an array of lines, so many arrays deep. */
static void add_lines(struct found *f, json_t *value, int depth)
{
    size_t k;
    json_t *one;
    if (depth == 0)
        add_line(f, value);
    else
        json_array_foreach(value, k, one) add_lines(f, one, depth - 1);
}

static void find_geojson(struct found *f, const json_t *object, int depth)
{
    static const struct {
        const char *type;
        int arrays; /* around its lines */
    } geometry[] = {{"LineString", 0}, {"MultiPoint", 0}, {"Polygon", 1}, {"MultiLineString", 1}, {"MultiPolygon", 2}};
    static const char *const inside[] = {"features", "geometries"};
    enum { DEEPEST = 16 };
    const char *type = json_string_value(json_object_get(object, "type"));
    json_t *coordinates = json_object_get(object, "coordinates"), *one;
    if (depth > DEEPEST)
        return;
    for (size_t k = 0; type != NULL && k < sizeof geometry / sizeof *geometry; k++)
        if (strcmp(type, geometry[k].type) == 0)
            add_lines(f, coordinates, geometry[k].arrays);
    if (type != NULL && strcmp(type, "Point") == 0)
        json_array_append(f->singles, coordinates);
    for (size_t k = 0, i; k < 2; k++)
        json_array_foreach(json_object_get(object, inside[k]), i, one) find_geojson(f, one, depth + 1);
    if (json_is_object(json_object_get(object, "geometry")))
        find_geojson(f, json_object_get(object, "geometry"), depth + 1);
}

static const json_t *named(const json_t *object, const char *name)
{
    const char capital[] = {(char)(name[0] - 'a' + 'A'), '\0'};
    const json_t *value = json_object_get(object, name);
    return value != NULL || strlen(name) != 1 ? value : json_object_get(object, capital);
}

/* {"x": [...], "y": [...]} as an array of points with names; NULL where the arrays are not alike. */
static json_t *zipped(const json_t *object, const char *sigma)
{
    const char *const name[] = {"x", "y", "z", sigma};
    size_t n = json_array_size(named(object, "x"));
    json_t *line = json_array();
    for (size_t i = 0; i < n; i++) {
        json_t *point = json_object();
        for (size_t k = 0; k < 4; k++)
            if (json_is_array(named(object, name[k])))
                json_object_set(point, name[k], json_array_get(named(object, name[k]), i));
        json_array_append_new(line, point);
    }
    for (size_t k = 0; k < 4; k++)
        if (json_is_array(named(object, name[k])) && json_array_size(named(object, name[k])) != n) {
            json_decref(line);
            return NULL;
        }
    return line;
}

/* The lines of one document. */
static int find_lines(struct reader *r, json_t *document, const char *sigma, struct found *f)
{
    if (json_is_object(document) && json_is_string(json_object_get(document, "type"))) {
        f->geojson = 1;
        find_geojson(f, document, 0);
    } else if (json_is_object(document) && json_is_array(named(document, "x"))) {
        json_t *line = zipped(document, sigma);
        if (line == NULL)
            return refuse(r, NULL, "the arrays of coordinates have different lengths");
        add_line(f, line);
        json_decref(line);
    } else if (json_is_object(document) && json_is_array(json_object_get(document, "points"))) {
        add_line(f, json_object_get(document, "points"));
    } else if (json_is_array(document) && !is_number_array(document)) {
        add_line(f, document);
    } else {
        json_array_append(f->singles, document); /* one point a document */
    }
    return 0;
}

/* All documents of the text, of which there may be one a line. */
static int find_all(struct reader *r, const char *sigma, struct found *f)
{
    for (const char *s = r->next; *(s += strspn(s, " \t\r\n\x1e")) != '\0';) {
        json_error_t error;
        json_t *document = json_loads(s, JSON_DISABLE_EOF_CHECK, &error);
        if (document == NULL) {
            go_to(r, s);
            r->line += error.line > 0 ? error.line - 1 : 0;
            return refuse(r, NULL, "JSON: %s%s", error.text,
                          json_error_code(&error) == json_error_numeric_overflow ? "; expected numbers up to 1.7e308"
                                                                                 : "");
        }
        int code = find_lines(r, document, sigma, f);
        json_decref(document);
        if (code != 0)
            return -1;
        s += error.position;
    }
    if (json_array_size(f->singles) > 0)
        json_array_append(f->lines, f->singles);
    return 0;
}

/* The lines of the text in which the points begin: arrays of numbers, or objects in which the first key is x.  Their
 * number; `line` may be NULL. */
static int lines_of_points(const char *text, int line[])
{
    int count = 0, at = 1;
    for (const char *s = text; *s != '\0'; s++) {
        at += *s == '\n';
        if (*s == '"')
            for (s++; *s != '"' && *s != '\0'; s++)
                s += *s == '\\' && s[1] != '\0';
        if (*s == '\0')
            break;
        if (*s != '[' && *s != '{')
            continue;
        const char *next = s + 1 + strspn(s + 1, " \t\r\n");
        if (*s == '[' ? strspn(next, "-0123456789") > 0 : strncasecmp(next, "\"x\"", 3) == 0) {
            if (line != NULL)
                line[count] = at;
            count++;
        }
    }
    return count;
}

/* What the numbers of a point are: coordinates, and the index of its standard deviation, or -1. */
struct shape {
    int numbers, dim, sigma;
};

static int shape_of_array(struct reader *r, const struct columns *asked, const struct found *f, const json_t *first,
                          struct points *p, struct shape *s)
{
    int n = (int)json_array_size(first);
    *s = (struct shape){n, asked->dim, -1};
    if (asked->sigma != NULL) {
        char *end;
        long k = strtol(asked->sigma, &end, 10);
        if (*end != '\0' || k < 1 || k > n)
            return refuse(r, NULL, "--sigma-column %s: the points have no names, expected a number from 1 to %d",
                          asked->sigma, n);
        s->sigma = (int)k - 1;
    }
    if (s->dim == 0 && f->geojson) {
        s->dim = 2;
        if (n > 2)
            note_of(p, "the third number of a position, its height, is passed over");
    }
    if (s->dim == 0 && n == 3 && s->sigma < 0)
        return refuse(r, NULL, "three numbers a point can be x y z or x y sigma; say which by --dim 3 or --dim 2");
    if (s->dim == 0)
        s->dim = n - (s->sigma >= 0) == 2 ? 2 : 3;
    if (!f->geojson && s->sigma < 0 && n == s->dim + 1)
        s->sigma = s->dim;
    if (n < s->dim + (s->sigma >= 0 && s->sigma < s->dim) || n > s->dim + 1)
        return refuse(r, NULL, "point 1 has %d number%s, expected %d coordinates and perhaps a standard deviation", n,
                      n == 1 ? "" : "s", s->dim);
    return 0;
}

/* The value of the point in place k of its shape: x, y, z, sigma. */
static const json_t *value_of(const json_t *point, const struct shape *s, int k, const char *sigma)
{
    static const char *const name[] = {"x", "y", "z"};
    if (json_is_object(point))
        return named(point, k < 3 ? name[k] : sigma);
    size_t at = k == 3 ? (size_t)s->sigma : (size_t)(k + (s->sigma >= 0 && k >= s->sigma));
    return json_array_get(point, at);
}

/* Point i of the line. */
static int take_point(struct reader *r, const struct shape *s, const json_t *point, int i, const char *sigma, int line,
                      struct points *p)
{
    static const char *const name[] = {"x", "y", "z", "sigma"};
    double at[4] = {0};
    if (json_is_array(point) && json_array_size(point) != (size_t)s->numbers)
        return refuse(r, NULL, "point %d has %zu numbers, expected %d as the first one has", i + 1,
                      json_array_size(point), s->numbers);
    for (int k = 0; k < 4; k++) {
        if (k == 3 ? s->sigma < 0 : k >= s->dim)
            continue;
        const json_t *value = value_of(point, s, k, sigma);
        if (!json_is_number(value))
            return refuse(r, NULL, "point %d: %s is %s", i + 1, name[k], value == NULL ? "missing" : "not a number");
        at[k] = json_number_value(value);
        if (!isfinite(at[k]))
            return refuse(r, NULL, "point %d: %s is larger than any binary64 number", i + 1, name[k]);
    }
    if (s->sigma >= 0 && at[3] <= 0)
        return refuse(r, NULL, "point %d: sigma is %g, expected a standard deviation > 0", i + 1, at[3]);
    return add_point(p, at, at[3], line) == 0 ? 0 : refuse(r, NULL, "memory is short");
}

static int take_line(struct reader *r, const struct columns *asked, const struct found *f, const json_t *line,
                     struct points *p)
{
    const char *sigma = asked->sigma != NULL ? asked->sigma : "sigma";
    const json_t *first = json_array_get(line, 0);
    struct shape s = {0, 0, -1};
    int count = (int)json_array_size(line);
    r->line = 0;
    if (count == 0)
        return refuse(r, NULL, "there are no points in it");
    if (json_is_object(first)) {
        s.dim = asked->dim != 0 ? asked->dim : named(first, "z") != NULL ? 3 : 2;
        s.sigma = asked->sigma != NULL || named(first, sigma) != NULL ? 0 : -1;
    } else if (!is_number_array(first)) {
        return refuse(r, NULL, "point 1 is neither an array of numbers nor an object with x and y");
    } else if (shape_of_array(r, asked, f, first, p, &s) != 0) {
        return -1;
    }
    p->dim = s.dim;
    p->has_sigma = s.sigma >= 0;
    int known = lines_of_points(r->next, NULL) == count, *lines = calloc((size_t)count, sizeof *lines), code = 0;
    if (lines == NULL)
        return refuse(r, NULL, "memory is short");
    if (known)
        lines_of_points(r->next, lines);
    for (int i = 0; i < count && code == 0; i++)
        code = take_point(r, &s, json_array_get(line, (size_t)i), i, sigma, known ? lines[i] : 1, p);
    free(lines);
    return code;
}

int read_json_points(struct reader *r, const struct columns *asked, struct points *p)
{
    struct found f = {json_array(), json_array(), 0};
    struct strokes strokes = {0};
    size_t k;
    json_t *line;
    int code = find_all(r, asked->sigma != NULL ? asked->sigma : "sigma", &f);
    json_array_foreach(f.lines, k, line) if (strokes.count++ < MOST_STROKES) strokes.points[strokes.count - 1] =
        (int)json_array_size(line);
    p->format = f.geojson ? "GeoJSON" : "JSON";
    if (code == 0)
        code = only_stroke(r, &strokes, "line");
    if (code == 0)
        code = take_line(r, asked, &f, json_array_get(f.lines, 0), p);
    if (code == 0 && f.geojson)
        note_of(p, "longitude and latitude are taken as they are, as coordinates of a plane");
    json_decref(f.lines);
    json_decref(f.singles);
    return code;
}
