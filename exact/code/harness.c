/* harness.c -- reads the blocks; see harness.h. */
#include "exact/code/harness.h"

#include "exact/code/formula.h"
#include "exact/number/field.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_COUNT = 1000 };

static int wrong(struct cagd_code_harness_error *error, int line, const char *format, ...)
{
    va_list list;
    va_start(list, format);
    vsnprintf(error->cause, sizeof error->cause, format, list);
    va_end(list);
    for (char *at = error->cause; *at != 0; at++) /* of an entry that goes on in the next line, too, one line is told */
        if (*at == '\n')
            *at = ' ';
    error->line = line;
    return -1;
}

/* ---- texts --------------------------------------------------------------------------------------------- */

static char *copied(const char *start, size_t length)
{
    char *text = malloc(length + 1);
    if (text == NULL)
        abort();
    memcpy(text, start, length);
    text[length] = 0;
    return text;
}

static char *joined(const char *first, const char *second)
{
    size_t length = strlen(first);
    char *text = malloc(length + strlen(second) + 1);
    if (text == NULL)
        abort();
    memcpy(text, first, length);
    strcpy(text + length, second);
    return text;
}

/* Without blanks at the ends. */
char *cagd_code_trimmed(const char *start, size_t length)
{
    while (length > 0 && isspace((unsigned char)*start))
        start++, length--;
    while (length > 0 && isspace((unsigned char)start[length - 1]))
        length--;
    return copied(start, length);
}

static int read_name(const char **at, char name[CAGD_CODE_MOST_NAME + 1])
{
    int n = 0;
    while (isspace((unsigned char)**at))
        ++*at;
    if (!isalpha((unsigned char)**at) && **at != '_')
        return -1;
    while (isalnum((unsigned char)**at) || **at == '_') {
        if (n == CAGD_CODE_MOST_NAME)
            return -1;
        name[n++] = *(*at)++;
    }
    name[n] = 0;
    return 0;
}

/* "[12]", or nothing, which is 0. */
static int read_count(const char **at, int *count)
{
    *count = 0;
    if (**at != '[')
        return 0;
    char *end;
    long n = strtol(*at + 1, &end, 10);
    if (*end != ']' || n < 1 || n > MOST_COUNT)
        return -1;
    *at = end + 1;
    *count = (int)n;
    return 0;
}

/* ---- inputs -------------------------------------------------------------------------------------------- */

int cagd_code_is_number(const char *text)
{
    cagd_region_mark mark = cagd_region_open();
    unsigned faults = cagd_region_faults;
    cagd_region_faults = 0;
    cagd_from_string_q(text);
    int good = cagd_region_faults == 0;
    cagd_region_faults = faults;
    cagd_region_drop(mark);
    return good;
}

static int read_values(struct cagd_code_asked_input *in, const char *at, int line,
                       struct cagd_code_harness_error *error)
{
    int wanted = in->count > 0 ? in->count : 1;
    in->shape = CAGD_CODE_FIXED;
    in->value = calloc((size_t)wanted, sizeof *in->value);
    if (in->value == NULL)
        abort();
    for (int k = 0;; k++) {
        at += strspn(at, " \t,");
        size_t length = strcspn(at, " \t,");
        if (length == 0)
            return k == wanted ? 0 : wrong(error, line, "%s has %d values; %d were expected", in->name, k, wanted);
        if (k == wanted)
            return wrong(error, line, "%s has more values than the %d expected", in->name, wanted);
        in->value[k] = copied(at, length);
        if (!cagd_code_is_number(in->value[k]))
            return wrong(error, line, "\"%s\" is no number; one like 3, -3/7 or 0.35 was expected", in->value[k]);
        at += length;
    }
}

/* A number, or an earlier input. */
static int is_end(const struct cagd_code_harness *h, const char *text)
{
    char name[CAGD_CODE_MOST_NAME + 1];
    const char *at = text;
    if (cagd_code_is_number(text))
        return 1;
    if (read_name(&at, name) != 0)
        return 0;
    for (int k = 0; k < h->inputs - 1; k++) /* the last one is that whose range it is */
        if (strcmp(h->input[k].name, name) == 0) {
            if (h->input[k].count == 0)
                return *at == 0;
            char *end;
            long index = *at == '[' && isdigit((unsigned char)at[1]) ? strtol(at + 1, &end, 10) : -1;
            return index >= 0 && index < h->input[k].count && strcmp(end, "]") == 0;
        }
    return 0;
}

static int read_range(const struct cagd_code_harness *h, struct cagd_code_asked_input *in, const char *at, int line,
                      struct cagd_code_harness_error *error)
{
    const char *comma = strchr(at, ','), *end = at + strlen(at) - 1;
    in->shape = CAGD_CODE_BETWEEN;
    if ((*at != '[' && *at != '(') || comma == NULL || (*end != ']' && *end != ')'))
        return wrong(error, line, "a range like [0, 1] or (a, b) was expected after \"in\"");
    in->open_low = *at == '(';
    in->open_high = *end == ')';
    in->low = cagd_code_trimmed(at + 1, (size_t)(comma - at - 1));
    in->high = cagd_code_trimmed(comma + 1, (size_t)(end - comma - 1));
    const char *const side[2] = {in->low, in->high};
    for (int k = 0; k < 2; k++)
        if (!is_end(h, side[k]))
            return wrong(error, line, "\"%s\" is no end of a range: a number or an earlier input was expected",
                         side[k]);
    return 0;
}

static int is_input(const struct cagd_code_harness *h, const char *name)
{
    for (int k = 0; k < h->inputs; k++)
        if (strcmp(h->input[k].name, name) == 0)
            return 1;
    return 0;
}

static int read_input(struct cagd_code_harness *h, const char *item, int line, struct cagd_code_harness_error *error)
{
    if (h->inputs == CAGD_CODE_MOST_IN_HARNESS)
        return wrong(error, line, "more than %d inputs", CAGD_CODE_MOST_IN_HARNESS);
    struct cagd_code_asked_input *in = &h->input[h->inputs];
    *in = (struct cagd_code_asked_input){.count = 0};
    const char *at = item;
    if (read_name(&at, in->name) != 0)
        return wrong(error, line, "\"%s\": a name of at most %d letters was expected", item, CAGD_CODE_MOST_NAME);
    if (read_count(&at, &in->count) != 0)
        return wrong(error, line, "%s: a number of elements from 1 to %d was expected", in->name, MOST_COUNT);
    if (is_input(h, in->name))
        return wrong(error, line, "%s is an input already", in->name);
    h->inputs++; /* from here on freed with the rest */
    at += strspn(at, " \t");
    int status = 0;
    if (*at == 0)
        in->shape = CAGD_CODE_ANY;
    else if (*at == '=')
        status = read_values(in, at + 1, line, error);
    else if (strcmp(at, "increasing") == 0 && in->count > 0)
        in->shape = CAGD_CODE_INCREASING;
    else if (strcmp(at, "nondecreasing") == 0 && in->count > 0)
        in->shape = CAGD_CODE_NONDECREASING;
    else if (strncmp(at, "in ", 3) == 0)
        status = read_range(h, in, at + 3 + strspn(at + 3, " \t"), line, error);
    else if (*at == '>' && strcmp(at + 1 + strspn(at + 1, " \t"), "0") == 0)
        in->shape = CAGD_CODE_POSITIVE;
    else
        status = wrong(error, line,
                       "%s: \"%s\" is not known; nothing, \"= values\", \"> 0\", \"in [a, b]\", or for an array "
                       "\"increasing\" or \"nondecreasing\" was expected",
                       in->name, at);
    return status;
}

/* ---- blocks ----------------------------------------------------------------------------------------------- */

static int add_line(struct cagd_code_lines *l, char *text, int number, struct cagd_code_harness_error *error)
{
    if (l->count == CAGD_CODE_MOST_IN_HARNESS) {
        free(text);
        return wrong(error, number, "more than %d lines of one key", CAGD_CODE_MOST_IN_HARNESS);
    }
    l->number[l->count] = number;
    l->text[l->count++] = text;
    return 0;
}

/* "FILE:LINE = expression" or "FILE:LINE[COUNT] = array". */
static int is_known(const char *text)
{
    const char *at = strchr(text, ':');
    int count;
    if (at == NULL || at == text || !isdigit((unsigned char)at[1]))
        return 0;
    at += 1 + strspn(at + 1, "0123456789");
    return read_count(&at, &count) == 0 && at[strspn(at, " \t")] == '=';
}

int cagd_code_is_array(const char *text, long *count)
{
    const char *bracket = strrchr(text, '[');
    char *end;
    *count = bracket != NULL ? strtol(bracket + 1, &end, 10) : 1;
    return bracket != NULL && strcmp(end, "]") == 0 && strcspn(text, "[.->(") == (size_t)(bracket - text);
}

/* What is compared or told of an array is some of it: of nothing everything would be proved. */
static int check_elements(const char *text, size_t length, int line, struct cagd_code_harness_error *error)
{
    char *name = cagd_code_trimmed(text, length);
    long count;
    int status =
        cagd_code_is_array(name, &count) && count < 1
            ? wrong(error, line,
                    "%s: an array was expected with the number of its elements, at least 1; one element is (%s)", name,
                    name)
            : 0;
    free(name);
    return status;
}

static int take_entry(struct cagd_code_harness *h, const char *key, const char *text, int line,
                      struct cagd_code_harness_error *error)
{
    const struct {
        const char *key;
        struct cagd_code_lines *lines;
    } lists[] = {{"source", &h->source}, {"include", &h->include}, {"declare", &h->declare}, {"where", &h->where},
                 {"call", &h->call},     {"output", &h->output},   {"expect", &h->expect},   {"known", &h->known},
                 {"let", &h->let},       {"printed", &h->printed}};
    for (size_t k = 0; k < sizeof lists / sizeof *lists; k++)
        if (strcmp(key, lists[k].key) == 0) {
            if (lists[k].lines == &h->expect && strchr(text, '=') == NULL)
                return wrong(error, line, "\"NAME = what it should be\" was expected");
            if (lists[k].lines == &h->known) {
                h->notes_stores = 1;
                if (!is_known(text))
                    return wrong(error, line,
                                 "\"FILE:LINE = what that line puts into a variable\", or \"FILE:LINE[COUNT] = "
                                 "array\", was expected");
            }
            if ((lists[k].lines == &h->expect || lists[k].lines == &h->output) &&
                check_elements(text, strcspn(text, "="), line, error) != 0)
                return -1;
            return add_line(lists[k].lines, copied(text, strlen(text)), line, error);
        }
    if (strcmp(key, "flag") == 0) {
        for (size_t length; text += strspn(text, " \t"), (length = strcspn(text, " \t")) > 0; text += length)
            if (add_line(&h->flag, copied(text, length), line, error) != 0)
                return -1;
        return 0;
    }
    if (strcmp(key, "use") == 0) /* in its place among the others */
        return add_line(&h->let, joined(":use: ", text), line, error);
    if (strcmp(key, "for") == 0) {
        char *before = h->ranges;
        char *with_comma = *before != 0 ? joined(before, ", ") : copied("", 0);
        h->ranges = joined(with_comma, text);
        free(before);
        free(with_comma);
        return 0;
    }
    if (strcmp(key, "input") == 0) {
        for (;;) {
            size_t length = strcspn(text, ";");
            char *item = cagd_code_trimmed(text, length);
            int status = *item == 0 ? 0 : read_input(h, item, line, error);
            free(item);
            if (status != 0 || text[length] == 0)
                return status;
            text += length + 1;
        }
    }
    if (strcmp(key, "title") == 0) {
        free(h->title);
        h->title = copied(text, strlen(text));
        return 0;
    }
    if (strcmp(key, "points") == 0) {
        char *end;
        long n = strtol(text, &end, 10);
        if (*end != 0 || n < 1 || n > 100000)
            return wrong(error, line, "a number of points from 1 to 100000 was expected");
        h->points = (int)n;
        return 0;
    }
    if (strcmp(key, "roots") == 0) {
        h->refuse_roots = strcmp(text, "refuse") == 0;
        h->enclose_roots = strcmp(text, "enclose") == 0;
        return h->refuse_roots || h->enclose_roots ? 0 : wrong(error, line, "\"refuse\" or \"enclose\" was expected");
    }
    if (strcmp(key, "memcpy") == 0) {
        h->memcpy_moves = strcmp(text, "moves") == 0;
        return h->memcpy_moves ? 0 : wrong(error, line, "\"moves\" was expected");
    }
    return wrong(error, line,
                 "there is no key \"%s\"; source, flag, include, declare, input, where, call, output, expect, printed, "
                 "let, use, "
                 "for, known, points, roots, memcpy and title are known",
                 key);
}

int cagd_code_output_name(const char *text, char name[CAGD_CODE_MOST_NAME + 1], int *count)
{
    const char *at = text;
    return read_name(&at, name) == 0 && read_count(&at, count) == 0 && *at == 0;
}

/* Whether an output is in the formula. */
static int has_output(const struct cagd_code_harness *h, const struct cagd_code_formulas *f, const cagd_tree *t)
{
    char name[CAGD_CODE_MOST_NAME + 1];
    int count;
    for (int k = 0; k < h->output.count; k++)
        if (cagd_code_output_name(h->output.text[k], name, &count) && !is_input(h, name) &&
            cagd_code_formula_has(f, t, name, count))
            return 1;
    return 0;
}

/* What the driver will read. */
static int check_formulas(const struct cagd_code_harness *h, struct cagd_code_harness_error *error)
{
    cagd_region_mark mark = cagd_region_open();
    struct cagd_code_formulas f = {.message = ""};
    char name[CAGD_CODE_MOST_NAME + 1];
    int count, bad = 0;
    for (int k = 0; k < h->inputs; k++)
        cagd_code_formula_name(&f, h->input[k].name, h->input[k].count);
    for (int k = 0; k < h->output.count; k++)
        if (cagd_code_output_name(h->output.text[k], name, &count))
            cagd_code_formula_name(&f, name, count);
    for (int k = 0; k < h->let.count && bad == 0; k++)
        if (cagd_code_formula_let(&f, h->let.text[k]) != 0)
            bad = wrong(error, h->let.number[k], "%s", f.message);
    for (int k = 0; k < h->printed.count && bad == 0; k++) {
        struct cagd_code_formulas one = f;
        const cagd_tree *t = cagd_code_formula_read(&one, h->printed.text[k], h->ranges);
        if (t == NULL)
            bad = wrong(error, h->printed.number[k], "%s", one.message);
        else if (!has_output(h, &one, t))
            bad = wrong(error, h->printed.number[k],
                        "\"%s\" has none of the outputs in it, so that it says nothing of the code (a name that is an "
                        "input, too, is the input)",
                        h->printed.text[k]);
    }
    cagd_region_drop(mark);
    return bad;
}

static int finish(const struct cagd_code_harness *h, struct cagd_code_harness_error *error)
{
    if (h->call.count == 0)
        return wrong(error, h->line, "%s: there is no :call:", h->name);
    if (h->expect.count + h->output.count == 0)
        return wrong(error, h->line, "%s: there is neither :expect: nor :output:", h->name);
    if (h->printed.count == 0 && (h->let.count > 0 || *h->ranges != 0))
        return wrong(error, h->let.count > 0 ? h->let.number[0] : h->line,
                     "%s: there is no :printed: of which something is said", h->name);
    if (check_formulas(h, error) != 0)
        return -1;
    if (cagd_code_variables(h) > CAGD_FIELD_MAX_VARIABLES - 8)
        return wrong(error, h->line, "%s: more than %d variables", h->name, CAGD_FIELD_MAX_VARIABLES - 8);
    return 0;
}

/* The entry that has been gathered so far, if any, is taken; `entry` is ":key: text". */
static int flush_entry(struct cagd_code_harness *h, char **entry, int line, struct cagd_code_harness_error *error)
{
    if (*entry == NULL)
        return 0;
    char *end = strchr(*entry + 1, ':');
    int status = -1;
    if (end == NULL) {
        wrong(error, line, "\":key: text\" was expected");
    } else {
        char *key = copied(*entry + 1, (size_t)(end - *entry - 1)), *text = cagd_code_trimmed(end + 1, strlen(end + 1));
        status = take_entry(h, key, text, line, error);
        free(key);
        free(text);
    }
    free(*entry);
    *entry = NULL;
    return status;
}

struct cagd_code_harness *cagd_code_read_harness(const char *text, struct cagd_code_harness_error *error)
{
    static const char opening[] = ":::{exactly}";
    struct cagd_code_harness *first = NULL, **last = &first, *h = NULL;
    char *entry = NULL;
    int number = 0, begun = 0;
    while (*text != 0) {
        size_t length = strcspn(text, "\n");
        char *line = copied(text, length);
        number++;
        text += length + (text[length] == '\n');
        if (h == NULL && strncmp(line, opening, sizeof opening - 1) == 0) {
            h = *last = calloc(1, sizeof *h);
            if (h == NULL)
                abort();
            last = &h->next;
            h->line = number;
            h->points = 20;
            h->ranges = copied("", 0);
            h->name = cagd_code_trimmed(line + sizeof opening - 1, strlen(line) - (sizeof opening - 1));
            if (*h->name == 0 && wrong(error, number, "the block has no name") != 0)
                goto failed;
        } else if (h != NULL && strncmp(line, ":::", 3) == 0) {
            if (flush_entry(h, &entry, begun, error) != 0 || finish(h, error) != 0)
                goto failed;
            h = NULL;
        } else if (h != NULL && *line == ':') {
            if (flush_entry(h, &entry, begun, error) != 0)
                goto failed;
            entry = copied(line, strlen(line));
            begun = number;
        } else if (h != NULL && entry != NULL && (*line == ' ' || *line == '\t')) {
            size_t had = strlen(entry);
            entry = realloc(entry, had + strlen(line) + 2);
            if (entry == NULL)
                abort();
            entry[had] = '\n';
            strcpy(entry + had + 1, line);
        } else if (h != NULL && *line != 0) {
            wrong(error, number, "\":key: text\" or the end of the block, \":::\", was expected");
            goto failed;
        }
        free(line);
        continue;
    failed:
        free(line);
        free(entry);
        cagd_code_harness_free(first);
        return NULL;
    }
    if (h != NULL)
        wrong(error, h->line, "%s: the block does not end", h->name);
    else if (first == NULL)
        wrong(error, number, "no block is in it; expected one that begins with :::{exactly} NAME");
    if (h != NULL) {
        free(entry);
        cagd_code_harness_free(first);
        return NULL;
    }
    return first;
}

static void free_lines(struct cagd_code_lines *l)
{
    for (int k = 0; k < l->count; k++)
        free(l->text[k]);
}

void cagd_code_harness_free(struct cagd_code_harness *h)
{
    while (h != NULL) {
        struct cagd_code_harness *next = h->next;
        struct cagd_code_lines *lists[] = {&h->source, &h->flag,   &h->include, &h->declare, &h->where,  &h->call,
                                           &h->output, &h->expect, &h->known,   &h->let,     &h->printed};
        for (size_t k = 0; k < sizeof lists / sizeof *lists; k++)
            free_lines(lists[k]);
        for (int k = 0; k < h->inputs; k++) {
            struct cagd_code_asked_input *in = &h->input[k];
            for (int j = 0; in->value != NULL && j < (in->count > 0 ? in->count : 1); j++)
                free(in->value[j]);
            free(in->value);
            free(in->low);
            free(in->high);
        }
        free(h->name);
        free(h->title);
        free(h->ranges);
        free(h);
        h = next;
    }
}

int cagd_code_variables(const struct cagd_code_harness *h)
{
    int variables = 0;
    for (int k = 0; k < h->inputs; k++)
        if (h->input[k].shape != CAGD_CODE_FIXED)
            variables += h->input[k].count > 0 ? h->input[k].count : 1;
    return variables;
}
