/* levels.c -- the triangles behind an assignment, and how far an answer comes in them; see lab.h.
 *
 * A block
 *     :::{triangle} b_$i^$r
 *     :in: point left
 *     :for: r = 1..n, i = 0..n-r
 *     :value: point($r, p + $i, t)
 * has the points of level r, by functions of the reference, for the requirements that it names; a point of several numbers has as many
 * values.  A point is computed by an answer where all its numbers are among the results of its operations.  This is asked
 * for inputs of many digits, at which no two functions are equal by chance; a number that is an input, 0 or 1 need not be computed.
 * Where no single operation of the source gives two points, the answer goes another way than the triangle, and nothing is told. */
#include "cli/lab/lab.h"

#include <stdlib.h>
#include <string.h>

static const char *member(const json_t *row, const char *key)
{
    const char *text = json_string_value(json_object_get(row, key));
    return text != NULL ? text : "";
}

static int whole(const json_t *row, const char *key) { return (int)json_integer_value(json_object_get(row, key)); }

/* ---- the points ------------------------------------------------------------------------------------------- */

/* A triangle whose points are being added to a case. */
struct adding {
    struct lab_case *c;
    const json_t *block;
    int triangle, known; /* letters of the case: the next one is the level */
};

static int add_point(void *what, const struct lab_letters *l)
{
    const struct adding *a = what;
    char *name = lab_put_numbers(member(a->block, "name"), l);
    json_t *values = json_array();
    size_t k;
    const json_t *value;
    int status = name != NULL && l->count > a->known && json_object_get(a->block, "value") != NULL ? 0 : -1;
    json_array_foreach(json_object_get(a->block, "value"), k, value)
    {
        char *formula = lab_put_numbers(json_string_value(value), l);
        if (formula == NULL || json_array_append_new(values, json_string(formula)) != 0)
            status = -1;
        free(formula);
    }
    if (status == 0)
        json_array_append_new(a->c->points, json_pack("{s:i, s:O, s:i, s:s, s:O}", "triangle", a->triangle, "line",
                                                      json_object_get(a->block, "line"), "level",
                                                      (int)l->value[a->known], "name", name, "value", values));
    json_decref(values);
    free(name);
    return status;
}

int lab_read_levels(const struct lab *lab, struct lab_case *c, const struct lab_letters *l, char cause[LAB_CAUSE])
{
    struct adding a = {.c = c, .known = l->count};
    size_t k;
    c->points = json_array();
    json_array_foreach(lab->blocks, k, a.block)
    {
        struct lab_letters letters = *l;
        if (strcmp(member(a.block, "kind"), "triangle") != 0 ||
            !lab_lists(lab_text(a.block, "in"), member(c->requirement, "name")))
            continue;
        if (lab_each(lab_text(a.block, "for"), &letters, add_point, &a) != 0) {
            snprintf(cause, LAB_CAUSE,
                     "the triangle %s: \":for: r = 1..n, i = 0..n-r\" and a :value: in these letters were expected",
                     member(a.block, "name"));
            return -1;
        }
        a.triangle++;
    }
    return 0;
}

/* All numbers of all points as one array, which is put out. */
static void write_points(const struct lab_case *c, FILE *out)
{
    size_t k, j;
    const json_t *point, *value;
    long count = 0;
    fputs("    const double lab_points[] = {", out);
    json_array_foreach(c->points, k, point) json_array_foreach(json_object_get(point, "value"), j, value)
    {
        fprintf(out, "%s%s", count > 0 ? ", " : "", json_string_value(value));
        count++;
    }
    fprintf(out, "};\n    cagd_code_output(\"level\", %ld, lab_points);\n", count);
}

void lab_write_levels(const struct lab *lab, FILE *out)
{
    for (int k = 0; k < lab->cases; k++) {
        const struct lab_case *c = &lab->at[k];
        struct cagd_code_harness inputs = *c->h; /* alone: nothing is called or put out but the points */
        char name[40], *tail = NULL;
        size_t size;
        if (json_array_size(c->points) == 0)
            continue;
        inputs.call.count = inputs.output.count = 0;
        FILE *points = open_memstream(&tail, &size);
        write_points(c, points);
        fclose(points);
        snprintf(name, sizeof name, "lab_levels_%d", k);
        fprintf(out, "\nvoid %s(void);\n", name);
        lab_write_body(&inputs, name, tail, out);
        free(tail);
    }
}

/* ---- what is computed ------------------------------------------------------------------------------------------ */

/* A run in which results were noted, and the numbers of the points there. */
struct view {
    const struct lab_case *c;
    const struct cagd_code_point *at;
    const json_t *computed, *levels; /* [value, line, which operation]; results */
};

static const char *value_at(const struct view *v, size_t index)
{
    return json_string_value(json_array_get(json_array_get(v->computed, index), 0));
}

static json_int_t line_at(const struct view *v, size_t index)
{
    return json_integer_value(json_array_get(json_array_get(v->computed, index), 1));
}

/* Whether two results are those of one operation in the source. */
static int is_same_place(const struct view *v, size_t a, size_t b)
{
    return line_at(v, a) == line_at(v, b) && json_equal(json_array_get(json_array_get(v->computed, a), 2),
                                                        json_array_get(json_array_get(v->computed, b), 2));
}

static int is_first_of_place(const struct view *v, size_t index)
{
    for (size_t k = 0; k < index; k++)
        if (is_same_place(v, k, index))
            return 0;
    return 1;
}

/* The j-th number of a point, whose first is result `first`. */
static const char *number_of(const struct view *v, size_t first, size_t j)
{
    return member(json_array_get(v->levels, first + j), "got");
}

static int is_plain(const struct view *v, const char *number)
{
    if (strcmp(number, "0") == 0 || strcmp(number, "1") == 0)
        return 1;
    for (int i = 0; i < v->at->inputs; i++)
        for (int j = 0; j < (v->at->input[i].count > 0 ? v->at->input[i].count : 1); j++)
            if (strcmp(v->at->input[i].value[j], number) == 0)
                return 1;
    return 0;
}

/* Whether the number is computed. */
static int is_there(const struct view *v, const char *number)
{
    for (size_t k = 0; k < json_array_size(v->computed); k++)
        if (strcmp(value_at(v, k), number) == 0)
            return 1;
    return 0;
}

static size_t numbers_of(const json_t *point) { return json_array_size(json_object_get(point, "value")); }

/* Of a point whose first number is result `first`: whether it is computed.  telling: is it by a number that is not plain? */
static int is_computed(const struct view *v, const json_t *point, size_t first, int *telling)
{
    *telling = 0;
    for (size_t j = 0; j < numbers_of(point); j++) {
        const char *number = number_of(v, first, j);
        if (is_plain(v, number))
            continue;
        if (!is_there(v, number))
            return 0;
        *telling = 1;
    }
    return 1;
}

/* ---- one triangle ------------------------------------------------------------------------------------------------ */

/* The points of the triangle in their order, up to the first that is not computed. */
static struct lab_reached reach_one(const struct view *v, int triangle)
{
    struct lab_reached r = {triangle, 0, 0, -1, -1, 0, 0};
    size_t k, first = 0;
    const json_t *point;
    int level = 0, telling;
    json_array_foreach(v->c->points, k, point)
    {
        size_t here = first;
        first += numbers_of(point);
        if (whole(point, "triangle") != triangle)
            continue;
        if (level != 0 && whole(point, "level") != level) {
            r.levels++;
            r.points = 0;
        }
        level = whole(point, "level");
        if (!is_computed(v, point, here, &telling)) {
            r.missing = (int)k;
            break;
        }
        r.points++;
        r.told += telling;
    }
    return r;
}

/* The number is one of the triangle and stands there by no chance. */
static int is_point(const struct view *v, int triangle, const char *number)
{
    size_t k, first = 0;
    const json_t *point;
    if (is_plain(v, number))
        return 0;
    json_array_foreach(v->c->points, k, point)
    {
        for (size_t j = 0; whole(point, "triangle") == triangle && j < numbers_of(point); j++)
            if (strcmp(number_of(v, first, j), number) == 0)
                return 1;
        first += numbers_of(point);
    }
    return 0;
}

/* How many different numbers of the triangle the operation of result `index` gives, of which that is the first. */
static int points_from(const struct view *v, int triangle, size_t index)
{
    json_t *met = json_object();
    for (size_t k = index; k < json_array_size(v->computed); k++)
        if (is_same_place(v, k, index) && is_point(v, triangle, value_at(v, k)))
            json_object_set_new(met, value_at(v, k), json_true());
    int count = (int)json_object_size(met);
    json_decref(met);
    return count;
}

/* The operation that completes points: that which gives most of them, two at least, and of several the last one.  The index of its
 * first result, or -1. */
static long completing(const struct view *v, int triangle)
{
    long most = 2, at = -1;
    for (size_t k = 0; k < json_array_size(v->computed); k++) {
        int points = is_first_of_place(v, k) ? points_from(v, triangle, k) : 0;
        if (points >= most)
            most = points, at = (long)k;
    }
    return at;
}

/* The first result of that operation which is none of the triangle: its index, or -1. */
static int first_other(const struct view *v, int triangle)
{
    long at = completing(v, triangle);
    for (size_t k = 0; at >= 0 && k < json_array_size(v->computed); k++)
        if (is_same_place(v, k, (size_t)at) && !is_plain(v, value_at(v, k)) && !is_point(v, triangle, value_at(v, k)))
            return (int)k;
    return -1;
}

struct lab_reached lab_reach(const struct lab_case *c, const struct cagd_code_point *p, const json_t *got,
                             const json_t *levels, json_t *whole_ones)
{
    const struct view v = {c, p, json_object_get(got, "computed"), json_object_get(levels, "results")};
    struct lab_reached best = {-1, 0, 0, -1, -1, 0, 0};
    int triangles = 0;
    size_t k;
    const json_t *point;
    char line[24];
    json_array_foreach(c->points, k, point)
    {
        if (v.computed == NULL || whole(point, "triangle") != triangles) /* the first point of the next one */
            continue;
        struct lab_reached r = reach_one(&v, triangles++);
        if (r.told < 2 || completing(&v, r.triangle) <
                              0) /* one number alone tells nothing, nor do numbers from places of their own */
            r.triangle = -1;
        snprintf(line, sizeof line, "%d", whole(point, "line"));
        if (whole_ones != NULL && r.triangle >= 0 && r.missing < 0)
            json_object_set_new(whole_ones, line, json_true());
        if (r.triangle >= 0 && (best.triangle < 0 || (best.missing >= 0 && r.missing < 0) || r.levels > best.levels ||
                                (r.levels == best.levels && r.points > best.points)))
            best = r;
        else if (best.triangle < 0 && r.told > 0)
            best.told = r.told;
    }
    if (best.triangle >= 0 && best.missing >= 0)
        best.instead = first_other(&v, best.triangle);
    best.results = json_array_size(v.computed);
    return best;
}

/* ---- in words ------------------------------------------------------------------------------------------------------ */

/* "levels 1 to 3 are computed, and the first 2 points of level 4" */
static int tell_levels(const struct lab_case *c, const struct lab_reached *r, char *text, size_t room)
{
    int next = whole(json_array_get(c->points, (size_t)r->missing), "level"), used = 0;
    const char *also = r->levels > 0 ? ", and " : "";
    if (r->levels == 1)
        used = snprintf(text, room, "level %d is computed", next - 1);
    else if (r->levels > 1)
        used = snprintf(text, room, "levels %d to %d are computed", next - r->levels, next - 1);
    if (r->points == 1)
        used += snprintf(text + used, room - (size_t)used, "%sthe first point of level %d", also, next);
    else if (r->points > 1)
        used += snprintf(text + used, room - (size_t)used, "%sthe first %d points of level %d", also, r->points, next);
    if (r->levels == 0)
        used += snprintf(text + used, room - (size_t)used, " are computed");
    return used;
}

/* The numbers of the point: " = (1/2, 3)". */
static int tell_numbers(const struct view *v, size_t first, size_t count, const char *before, char *text, size_t room)
{
    int used = snprintf(text, room, "%s%s", before, count > 1 ? "(" : "");
    for (size_t j = 0; j < count && (size_t)used < room; j++)
        used += snprintf(text + used, room - (size_t)used, "%s%.60s", j > 0 ? ", " : "", number_of(v, first, j));
    if (count > 1 && (size_t)used < room)
        used += snprintf(text + used, room - (size_t)used, ")");
    return used;
}

/* "p = 3, -5; t = 1/2" */
static int tell_inputs(const struct cagd_code_point *p, char *text, size_t room)
{
    int used = 0;
    for (int i = 0; i < p->inputs; i++)
        for (int j = 0; j < (p->input[i].count > 0 ? p->input[i].count : 1) && (size_t)used < room; j++) {
            const char *before = j > 0 ? ", " : i > 0 ? "; " : "";
            used += snprintf(text + used, room - (size_t)used, "%s%s%s%.40s", before, j > 0 ? "" : p->input[i].name,
                             j > 0 ? "" : " = ", p->input[i].value[j]);
        }
    return used;
}

int lab_tell_reached(const struct lab_case *c, const struct lab_reached *r, const struct cagd_code_point *here,
                     int names_inputs, const json_t *got, const json_t *levels, char text[LAB_CAUSE])
{
    const struct view v = {c, here, json_object_get(got, "computed"), json_object_get(levels, "results")};
    const size_t room = LAB_CAUSE;
    if (r->missing < 0) {
        snprintf(text, room, "the whole triangle is computed: what is wrong is what becomes of it");
        return 1;
    }
    int is_so = here != NULL && v.computed != NULL && reach_one(&v, r->triangle).missing == r->missing;
    const json_t *point = json_array_get(c->points, (size_t)r->missing);
    size_t first = 0, used = (size_t)tell_levels(c, r, text, room);
    for (int k = 0; k < r->missing; k++)
        first += numbers_of(json_array_get(c->points, (size_t)k));
    used += (size_t)snprintf(text + used, room - used, "; %.60s", member(point, "name"));
    if (!is_so || names_inputs)
        used += (size_t)snprintf(text + used, room - used, " is not");
    if (!is_so)
        return 0;
    if (names_inputs) {
        used += (size_t)snprintf(text + used, room - used, ": for ");
        used += (size_t)tell_inputs(here, text + used, 200);
        used += (size_t)snprintf(text + used, room - used, " it");
    }
    used += (size_t)tell_numbers(&v, first, numbers_of(point), names_inputs ? " is " : " = ", text + used, 150);
    if (!names_inputs)
        used += (size_t)snprintf(text + used, room - used, " is not");
    if (r->instead >= 0 && r->results == json_array_size(v.computed)) /* the same operations */
        snprintf(text + used, room - used, "; the first other number from the same place, line %d, is %.60s",
                 (int)line_at(&v, (size_t)r->instead), value_at(&v, (size_t)r->instead));
    return 1;
}
