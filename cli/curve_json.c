/* curve_json.c -- curves and numbers as files have them. */
#include "cli/curve_json.h"
#include "core/number/limits.h"
#include "exact/span.h"
#include "exact/words.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_POINTS = 100000 };

static int refuse(const char *path, const char *format, ...) __attribute__((format(printf, 2, 3)));
static int refuse(const char *path, const char *format, ...)
{
    va_list list;
    fprintf(stderr, "cagd: %s: ", strcmp(path, "-") == 0 ? "standard input" : path);
    va_start(list, format);
    vfprintf(stderr, format, list);
    va_end(list);
    fputs("\n", stderr);
    return -1;
}

static num_q *numbers(int count) { return region_bytes((size_t)count * sizeof(num_q)); }

/* A JSON number is the binary64 it denotes; a string is the rational it writes. */
static int read_number(const json_t *value, num_q *out)
{
    unsigned before = region_faults;
    if (json_is_number(value))
        *out = from_double_q(json_number_value(value));
    else if (json_is_string(value))
        *out = from_string_q(json_string_value(value));
    else
        return -1;
    int good = region_faults == before;
    region_faults = before;
    return good ? 0 : -1;
}

/* An array of exactly `count` numbers, or of any positive number of them for count 0. */
static int read_numbers(const char *path, const char *field, const json_t *array, int count, num_q **out)
{
    if (!json_is_array(array))
        return refuse(path, "%s: expected an array of numbers", field);
    int given = (int)json_array_size(array);
    if (count != 0 && given != count)
        return refuse(path, "%s: %d given, expected %d", field, given, count);
    *out = numbers(given);
    for (int i = 0; i < given; i++)
        if (read_number(json_array_get(array, (size_t)i), &(*out)[i]) != 0)
            return refuse(path, "%s[%d]: expected a number, or a string such as \"3/7\", \"0.1\" or \"0x1.8p-3\"",
                          field, i);
    return 0;
}

static int read_points(const char *path, const json_t *array, struct curve *c)
{
    if (!json_is_array(array) || json_array_size(array) == 0)
        return refuse(path, "points: expected an array of points, each an array of 1 to %d numbers", MAX_DIM - 1);
    if (json_array_size(array) > MOST_POINTS)
        return refuse(path, "points: %zu given, expected at most %d", json_array_size(array), MOST_POINTS);
    c->count = (int)json_array_size(array);
    c->dim = (int)json_array_size(json_array_get(array, 0));
    if (c->dim < 1 || c->dim > MAX_DIM - 1)
        return refuse(path, "points[0]: expected an array of 1 to %d numbers", MAX_DIM - 1);
    c->points = numbers(c->count * c->dim);
    for (int i = 0; i < c->count; i++) {
        char field[32];
        num_q *point;
        snprintf(field, sizeof field, "points[%d]", i);
        if (read_numbers(path, field, json_array_get(array, (size_t)i), c->dim, &point) != 0)
            return -1;
        memcpy(c->points + i * c->dim, point, (size_t)c->dim * sizeof *point);
    }
    return 0;
}

/* The degree, given as such or as the order, which is one more. */
static int read_degree(const char *path, const json_t *document, struct curve *c)
{
    const json_t *degree = json_object_get(document, "degree"), *order = json_object_get(document, "order");
    if (degree == NULL && order == NULL) {
        if (json_object_get(document, "knots") != NULL)
            return refuse(path, "degree: missing; expected a whole number from 0 to %d (or \"order\", one more)",
                          MAX_DEGREE);
        c->degree = c->count - 1;
    } else {
        const char *field = degree != NULL ? "degree" : "order";
        int low = degree != NULL ? 0 : 1;
        const json_t *given = degree != NULL ? degree : order;
        if (!json_is_integer(given) || json_integer_value(given) < low || json_integer_value(given) > MAX_DEGREE + low)
            return refuse(path, "%s: expected a whole number from %d to %d", field, low, MAX_DEGREE + low);
        c->degree = (int)json_integer_value(given) - low;
        if (degree != NULL && order != NULL && json_integer_value(order) != c->degree + 1)
            return refuse(path, "order: expected degree + 1 = %d", c->degree + 1);
    }
    if (c->degree > MAX_DEGREE)
        return refuse(path, "degree: %d, expected at most %d", c->degree, MAX_DEGREE);
    return 0;
}

static int check_knots_of(const char *path, const struct curve *c)
{
    int where;
    knot_fault fault = check_knots_q(c->count, c->degree, c->knots, &where);
    const char *knot = to_string_q(c->knots[where]);
    switch (fault) {
    case KNOTS_GOOD:
        return 0;
    case KNOTS_TOO_FEW:
        return refuse(path, "points: %d given; a curve of degree %d has at least %d", c->count, c->degree,
                      c->degree + 1);
    case KNOTS_DECREASE:
        return refuse(path, "knots[%d]: %s is smaller than the knot before it, %s", where, knot,
                      to_string_q(c->knots[where - 1]));
    case KNOTS_TOO_MULTIPLE:
        return refuse(path, "knots[%d]: %s is given more than %d times, which degree %d does not allow", where, knot,
                      c->degree + 1, c->degree);
    case KNOTS_NO_DOMAIN:
        return refuse(path, "knots: the domain, from knots[%d] to knots[%d], is empty: both are %s", c->degree,
                      c->count, knot);
    }
    return -1;
}

static int read_document(const char *path, const json_t *document, struct curve *c)
{
    static const char *const kinds[] = {"bezier", "rational-bezier", "bspline", "nurbs"};
    static const char *const fields[] = {"kind", "degree", "order", "points", "weights", "knots", "name", "schema"};
    if (!json_is_object(document))
        return refuse(path, "expected an object {\"kind\": ..., \"degree\": ..., \"points\": ..., ...}");
    const char *key;
    json_t *value;
    json_object_foreach((json_t *)document, key, value)
    {
        int known = 0;
        for (size_t k = 0; k < sizeof fields / sizeof *fields; k++)
            known |= strcmp(key, fields[k]) == 0;
        if (!known)
            return refuse(path, "%s: there is no such field; expected kind, degree or order, points, weights, knots",
                          key);
    }
    const char *kind = json_string_value(json_object_get(document, "kind"));
    int k = 0;
    while (k < 4 && (kind == NULL || strcmp(kind, kinds[k]) != 0))
        k++;
    if (k == 4)
        return refuse(path, "kind: expected \"bezier\", \"rational-bezier\", \"bspline\" or \"nurbs\"");
    int rational = k % 2, spline = k / 2;
    const json_t *weights = json_object_get(document, "weights"), *knots = json_object_get(document, "knots");
    if (rational != (weights != NULL))
        return refuse(path, "weights: %s a curve of kind \"%s\"",
                      rational ? "missing, expected for" : "not expected for", kind);
    if (spline != (knots != NULL))
        return refuse(path, "knots: %s a curve of kind \"%s\"", spline ? "missing, expected for" : "not expected for",
                      kind);
    if (read_points(path, json_object_get(document, "points"), c) != 0 || read_degree(path, document, c) != 0)
        return -1;
    if (!spline && c->count != c->degree + 1)
        return refuse(path, "points: %d given; a Bézier curve of degree %d has %d", c->count, c->degree, c->degree + 1);
    c->weights = NULL;
    if (rational && read_numbers(path, "weights", weights, c->count, &c->weights) != 0)
        return -1;
    if (!spline) {
        c->knots = numbers(2 * c->count);
        for (int i = 0; i < 2 * c->count; i++)
            c->knots[i] = from_int_q(i >= c->count);
        return 0;
    }
    if (json_is_array(knots) && (int)json_array_size(knots) != c->count + c->degree + 1)
        return refuse(path, "knots: %zu given, expected %d (%d points + degree %d + 1)", json_array_size(knots),
                      c->count + c->degree + 1, c->count, c->degree);
    if (read_numbers(path, "knots", knots, 0, &c->knots) != 0)
        return -1;
    return check_knots_of(path, c);
}

int read_curve(const char *path, struct curve *c)
{
    json_error_t error;
    json_t *document = strcmp(path, "-") == 0 ? json_loadf(stdin, JSON_REJECT_DUPLICATES, &error)
                                              : json_load_file(path, JSON_REJECT_DUPLICATES, &error);
    if (document == NULL)
        return error.line > 0 ? refuse(path, "line %d, column %d: %s", error.line, error.column, error.text)
                              : refuse(path, "%s", error.text);
    int result = read_document(path, document, c);
    json_decref(document);
    return result;
}

json_t *number_json(num_q a)
{
    const long most = 1L << 53; /* what binary64 holds exactly */
    if (mpz_cmp_ui(mpq_denref(a.at), 1) == 0 && mpz_cmpabs_ui(mpq_numref(a.at), (unsigned long)most) <= 0)
        return json_integer(mpz_get_si(mpq_numref(a.at)));
    return json_string(to_string_q(a));
}

static json_t *numbers_json(int count, const num_q x[])
{
    json_t *array = json_array();
    for (int i = 0; i < count; i++)
        json_array_append_new(array, number_json(x[i]));
    return array;
}

json_t *curve_json(const struct curve *c)
{
    json_t *points = json_array();
    for (int i = 0; i < c->count; i++)
        json_array_append_new(points, numbers_json(c->dim, c->points + i * c->dim));
    json_t *document = json_pack("{s:s, s:i, s:o}", "kind", c->weights != NULL ? "nurbs" : "bspline", "degree",
                                 c->degree, "points", points);
    if (c->weights != NULL)
        json_object_set_new(document, "weights", numbers_json(c->count, c->weights));
    json_object_set_new(document, "knots", numbers_json(c->count + c->degree + 1, c->knots));
    return document;
}

num_q exact_number(struct argp_state *state, const char *option, const char *text)
{
    unsigned before = region_faults;
    num_q a = from_string_q(text);
    if (region_faults != before)
        argp_error(state, "%s takes a number such as 3/7, 0.1 or 0x1.8p-3, not '%s'", option, text);
    return a;
}
