/* curve_json.c -- curves and numbers as files have them. */
#include "cli/curve_json.h"
#include "cli/command.h"
#include "core/number/limits.h"
#include "exact/words.h"

#include <errno.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

enum { MOST_POINTS = 100000 };
static const size_t MOST_BYTES = (size_t)1 << 29; /* of a file */

/* What is read, as far as it is read, and what is wrong with it. */
struct reading {
    int degree, count, dim;
    num_q *knots, *points, *weights;
    struct input_error *error;
};

/* Notes the error; -1. */
static int refuse(const struct reading *r, const char *place, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
static int refuse(const struct reading *r, const char *place, const char *format, ...)
{
    va_list list;
    va_start(list, format);
    input_refuse(r->error, place, format, list);
    va_end(list);
    return -1;
}

/* The place of element i: "points[3]". */
struct element {
    char text[48];
};
static struct element element(const char *field, int i)
{
    struct element e;
    snprintf(e.text, sizeof e.text, "%s[%d]", field, i);
    return e;
}

static num_q *numbers(int count) { return region_bytes((size_t)count * sizeof(num_q)); }

/* What is expected of a text that is no number; of one whose exponent is too large for it, that. */
static const char *number_wanted(const char *text)
{
    const char *exponent = text != NULL ? strpbrk(text, text[strcspn(text, "xX")] != '\0' ? "pP" : "eE") : NULL;
    if (exponent != NULL && strtol(exponent + 1, NULL, 10) == 0)
        exponent = NULL;
    return exponent != NULL ? "an exponent between -99999 and 99999"
                            : "a number, or a string such as \"3/7\", \"0.1\" or \"0x1.8p-3\"";
}

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
static int read_numbers(const struct reading *r, const char *field, const json_t *array, int count, num_q **out)
{
    if (!json_is_array(array))
        return refuse(r, field, "expected an array of numbers");
    int given = (int)json_array_size(array);
    if (count != 0 && given != count)
        return refuse(r, field, "%d given, expected %d", given, count);
    *out = numbers(given);
    if (*out == NULL)
        return refuse(r, field, "%s", cagd_status_text(CAGD_NO_MEMORY));
    for (int i = 0; i < given; i++)
        if (read_number(json_array_get(array, (size_t)i), &(*out)[i]) != 0)
            return refuse(r, element(field, i).text, "expected %s",
                          number_wanted(json_string_value(json_array_get(array, (size_t)i))));
    return 0;
}

static int read_points(struct reading *r, const json_t *array)
{
    if (!json_is_array(array) || json_array_size(array) == 0)
        return refuse(r, "points", "expected an array of points, each an array of 1 to %d numbers", MAX_DIM - 1);
    if (json_array_size(array) > MOST_POINTS)
        return refuse(r, "points", "%zu given, expected at most %d", json_array_size(array), MOST_POINTS);
    r->count = (int)json_array_size(array);
    r->dim = (int)json_array_size(json_array_get(array, 0));
    if (r->dim < 1 || r->dim > MAX_DIM - 1)
        return refuse(r, "points[0]", "expected an array of 1 to %d numbers", MAX_DIM - 1);
    r->points = numbers(r->count * r->dim);
    if (r->points == NULL)
        return refuse(r, "points", "%s", cagd_status_text(CAGD_NO_MEMORY));
    for (int i = 0; i < r->count; i++) {
        num_q *point;
        if (read_numbers(r, element("points", i).text, json_array_get(array, (size_t)i), r->dim, &point) != 0)
            return -1;
        memcpy(r->points + i * r->dim, point, (size_t)r->dim * sizeof *point);
    }
    return 0;
}

/* The degree, given as such or as the order, which is one more. */
static int read_degree(struct reading *r, const json_t *document)
{
    const json_t *degree = json_object_get(document, "degree"), *order = json_object_get(document, "order");
    if (degree == NULL && order == NULL) {
        if (json_object_get(document, "knots") != NULL)
            return refuse(r, "degree", "missing; expected a whole number from 0 to %d (or \"order\", one more)",
                          MAX_DEGREE);
        r->degree = r->count - 1;
    } else {
        int low = degree != NULL ? 0 : 1;
        const json_t *given = degree != NULL ? degree : order;
        if (!json_is_integer(given) || json_integer_value(given) < low || json_integer_value(given) > MAX_DEGREE + low)
            return refuse(r, degree != NULL ? "degree" : "order", "expected a whole number from %d to %d", low,
                          MAX_DEGREE + low);
        r->degree = (int)json_integer_value(given) - low;
        if (degree != NULL && order != NULL && json_integer_value(order) != r->degree + 1)
            return refuse(r, "order", "expected degree + 1 = %d", r->degree + 1);
    }
    if (r->degree > MAX_DEGREE)
        return refuse(r, "degree", "%d, expected at most %d", r->degree, MAX_DEGREE);
    return 0;
}

/* *c: the curve that was read, if it is one. */
static int check_curve(const struct reading *r, cagd_spline_q *c)
{
    int where;
    *c = (cagd_spline_q){r->degree, r->count, r->dim, r->knots, r->points, r->weights};
    cagd_status status = cagd_spline_check_q(c, &where);
    const char *knot = where >= 0 ? to_string_q(c->knots[where]) : "";
    switch (status) {
    case CAGD_OK:
        return 0;
    case CAGD_COUNT:
        return refuse(r, "points", "%d given; a curve of degree %d has at least %d", c->count, c->degree,
                      c->degree + 1);
    case CAGD_KNOTS_DECREASE:
        return refuse(r, element("knots", where).text, "%s is smaller than the knot before it, %s", knot,
                      to_string_q(c->knots[where - 1]));
    case CAGD_KNOTS_MULTIPLE:
        return refuse(r, element("knots", where).text, "%s is given more than %d times, which degree %d does not allow",
                      knot, c->degree + 1, c->degree);
    case CAGD_KNOTS_EMPTY:
        return refuse(r, "knots", "the domain, from knots[%d] to knots[%d], is empty: both are %s", c->degree, c->count,
                      knot);
    default:
        return refuse(r, "", "%s", cagd_status_text(status));
    }
}

static int read_document(struct reading *r, const json_t *document, cagd_spline_q *c)
{
    static const char *const kinds[] = {"bezier", "rational-bezier", "bspline", "nurbs"};
    static const char *const fields[] = {"kind", "degree", "order", "points", "weights", "knots", "name", "schema"};
    if (!json_is_object(document))
        return refuse(r, "", "expected an object {\"kind\": ..., \"degree\": ..., \"points\": ..., ...}");
    const char *key;
    json_t *value;
    json_object_foreach((json_t *)document, key, value)
    {
        int known = 0;
        for (size_t k = 0; k < sizeof fields / sizeof *fields; k++)
            known |= strcmp(key, fields[k]) == 0;
        if (!known)
            return refuse(r, key, "there is no such field; expected kind, degree or order, points, weights, knots");
    }
    const char *kind = json_string_value(json_object_get(document, "kind"));
    int k = 0;
    while (k < 4 && (kind == NULL || strcmp(kind, kinds[k]) != 0))
        k++;
    if (k == 4)
        return refuse(r, "kind", "expected \"bezier\", \"rational-bezier\", \"bspline\" or \"nurbs\"");
    int rational = k % 2, spline = k / 2;
    const json_t *weights = json_object_get(document, "weights"), *knots = json_object_get(document, "knots");
    if (rational != (weights != NULL))
        return refuse(r, "weights", "%s a curve of kind \"%s\"",
                      rational ? "missing, expected for" : "not expected for", kind);
    if (spline != (knots != NULL))
        return refuse(r, "knots", "%s a curve of kind \"%s\"", spline ? "missing, expected for" : "not expected for",
                      kind);
    if (read_points(r, json_object_get(document, "points")) != 0 || read_degree(r, document) != 0)
        return -1;
    if (!spline && r->count != r->degree + 1)
        return refuse(r, "points", "%d given; a Bézier curve of degree %d has %d", r->count, r->degree, r->degree + 1);
    if (rational && read_numbers(r, "weights", weights, r->count, &r->weights) != 0)
        return -1;
    if (!spline) {
        r->knots = numbers(2 * r->count);
        if (r->knots == NULL)
            return refuse(r, "knots", "%s", cagd_status_text(CAGD_NO_MEMORY));
        for (int i = 0; i < 2 * r->count; i++)
            r->knots[i] = from_int_q(i >= r->count);
        return check_curve(r, c);
    }
    if (json_is_array(knots) && (int)json_array_size(knots) != r->count + r->degree + 1)
        return refuse(r, "knots", "%zu given, expected %d (%d points + degree %d + 1)", json_array_size(knots),
                      r->count + r->degree + 1, r->count, r->degree);
    if (read_numbers(r, "knots", knots, 0, &r->knots) != 0)
        return -1;
    return check_curve(r, c);
}

/* All bytes of the file, which the caller frees; NULL and the error when it cannot be read. */
static char *read_file(const struct reading *r, const char *path, size_t *length)
{
    FILE *file = open_input(path, "a curve", r->error);
    if (file == NULL)
        return NULL;
    char *text = NULL;
    size_t room = 0, had = 0, got;
    do {
        room = room == 0 ? 1 << 16 : 2 * room;
        char *more = realloc(text, room + 1);
        if (more == NULL)
            abort();
        text = more;
        got = fread(text + had, 1, room - had, file);
        had += got;
    } while (had == room && room < MOST_BYTES);
    int bad = ferror(file), cause = errno;
    if (file != stdin)
        fclose(file);
    if (bad || had == room) {
        free(text);
        if (bad)
            refuse(r, "", "%s", strerror(cause));
        else
            refuse(r, "", "more than %zu bytes, the largest size that is read; expected the file of a curve",
                   MOST_BYTES);
        return NULL;
    }
    text[had] = '\0';
    *length = had;
    return text;
}

/* What is wrong with a text that is no JSON, in the words of people who write curves. */
static int refuse_syntax(const struct reading *r, const char *text, const json_error_t *syntax)
{
    char place[48] = "";
    if (strspn(text, " \t\r\n") == strlen(text))
        return refuse(r, "", "it is empty; expected an object {\"kind\": ..., \"degree\": ..., \"points\": ..., ...}");
    if (syntax->line > 0)
        snprintf(place, sizeof place, "line %d, column %d", syntax->line, syntax->column);
    if (json_error_code(syntax) == json_error_numeric_overflow)
        return refuse(r, place, "%s; a number that binary64 does not hold is written in quotes, such as \"1e400\"",
                      syntax->text);
    if (json_error_code(syntax) == json_error_invalid_utf8)
        return refuse(r, place, "%s; expected JSON, in UTF-8", syntax->text);
    return refuse(r, place, "%s", syntax->text);
}

int read_curve(const char *path, cagd_spline_q *c, struct input_error *error)
{
    static const char mark[] = "\xEF\xBB\xBF"; /* of UTF-8, which editors put at the beginning */
    struct reading r = {.error = error};
    size_t length;
    json_error_t syntax;
    char *text = read_file(&r, path, &length);
    if (text == NULL)
        return -1;
    size_t skipped = length >= 3 && memcmp(text, mark, 3) == 0 ? 3 : 0;
    json_t *document = json_loadb(text + skipped, length - skipped, JSON_REJECT_DUPLICATES, &syntax);
    int result = document != NULL ? read_document(&r, document, c) : refuse_syntax(&r, text + skipped, &syntax);
    free(text);
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

int is_bezier(const cagd_spline_q *c)
{
    int so = c->count == c->degree + 1;
    for (int i = 0; so && i < 2 * c->count; i++)
        so = cagd_equal_q(c->knots[i], from_int_q(i >= c->count));
    return so;
}

json_t *curve_json(const cagd_spline_q *c)
{
    static const char *const kinds[] = {"bspline", "nurbs", "bezier", "rational-bezier"};
    int bezier = is_bezier(c);
    json_t *points = json_array();
    for (int i = 0; i < c->count; i++)
        json_array_append_new(points, numbers_json(c->dim, c->points + i * c->dim));
    json_t *document = json_pack("{s:s, s:i, s:o}", "kind", kinds[2 * bezier + (c->weights != NULL)], "degree",
                                 c->degree, "points", points);
    if (c->weights != NULL)
        json_object_set_new(document, "weights", numbers_json(c->count, c->weights));
    if (!bezier)
        json_object_set_new(document, "knots", numbers_json(c->count + c->degree + 1, c->knots));
    return document;
}

num_q exact_number(struct argp_state *state, const char *option, const char *text)
{
    unsigned before = region_faults;
    num_q a = from_string_q(text);
    if (region_faults != before)
        refuse_call(state->name,
                    "%s takes a number such as 3/7, 0.1 or 0x1.8p-3, with an exponent up to 99999, not '%s'", option,
                    text);
    return a;
}
