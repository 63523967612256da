/* numbers.c -- answers that are files of numbers and formulas; see lab.h.
 *
 *     # what is wrong
 *     counterexample = -7, 1/10
 *     corrected(t) = \frac{189}{4} t^3 (1-t)^5
 *
 * A line is a name and its numbers, or a function with a formula as cagd check reads it.  Each becomes a function in C, which writes the
 * numbers to an array or computes the formula: what is asked of it is then decided as of any answer. */
#include "cli/lab/lab.h"
#include "exact/expression/evaluate.h"
#include "exact/expression/read.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_NUMBERS = 64, MOST_DIGITS = 15, MOST_NAME = 40, MOST_LETTERS = 6, MOST_FORMULA = 2000 };

int lab_is_numbers(const struct lab *lab, const char *object)
{
    return strcmp(lab->language, "numbers") == 0 && strcmp(object, "reference.so") != 0;
}

/* The place in a line, and what is wrong with it. */
struct line {
    const char *at;
    long number, digits; /* of the line; of all numbers that were read */
    char cause[LAB_CAUSE];
};

static int wrong(struct line *l, const char *what)
{
    if (l->cause[0] == 0)
        snprintf(l->cause, sizeof l->cause, "line %ld: %s", l->number, what);
    return -1;
}

static void skip(struct line *l) { l->at += strspn(l->at, " \t"); }

static int pass(struct line *l, char c)
{
    skip(l);
    int there = *l->at == c;
    l->at += there;
    return there;
}

/* A word of letters, digits and low lines; its length. */
static size_t word(struct line *l)
{
    skip(l);
    size_t n = 0;
    while (isalnum((unsigned char)l->at[n]) || l->at[n] == '_')
        n++;
    return isalpha((unsigned char)*l->at) && n < MOST_NAME ? n : 0;
}

static int put_whole(struct line *l, FILE *out)
{
    size_t n = strspn(l->at, "0123456789");
    if (n == 0 || n > MOST_DIGITS)
        return wrong(l,
                     n == 0 ? "a number such as 3, -13/2 was expected" : "a number of at most 15 digits was expected");
    fprintf(out, "%.*s.0", (int)n, l->at);
    l->digits += (long)n;
    l->at += n;
    return 0;
}

/* "-7, 1/10" */
static int put_numbers(struct line *l, FILE *out)
{
    int count = 0;
    do {
        if (count == MOST_NUMBERS)
            return wrong(l, "fewer numbers were expected");
        fprintf(out, "    x[%d] = ", count);
        if (pass(l, '-'))
            fputs("-", out);
        skip(l);
        if (put_whole(l, out) != 0)
            return -1;
        fputs(";\n", out);
        if (pass(l, '/')) {
            skip(l);
            if (strtoull(l->at, NULL, 10) == 0)
                return wrong(l, "a denominator that is not 0 was expected");
            fprintf(out, "    x[%d] /= ", count);
            if (put_whole(l, out) != 0)
                return -1;
            fputs(";\n", out);
        }
        count++;
    } while (pass(l, ','));
    skip(l);
    return *l->at == 0 ? 0 : wrong(l, "numbers with commas between were expected");
}

/* The formula in these letters, "t, s". */
static int put_formula(struct line *l, const char *letters, FILE *out)
{
    char ranges[200];
    cagd_scope scope = {0};
    cagd_reading_error error = {0};
    size_t size = strlen(l->at);
    int status = -1;
    cagd_region_mark mark = cagd_region_open();
    snprintf(ranges, sizeof ranges, "%s \\in \\mathbb{R}", letters);
    cagd_context *c = calloc(1, sizeof *c);
    const cagd_tree *tree = NULL;
    if (c == NULL)
        abort();
    if (size > MOST_FORMULA)
        wrong(l, "a shorter formula was expected");
    else if (cagd_read_ranges(&scope, ranges, 0, (int)strlen(ranges), &error) == 0 ||
             (tree = cagd_read_value(&scope, l->at, 0, (int)size, &error)) == NULL)
        wrong(l, error.message);
    if (tree != NULL) {
        *c = (cagd_context){.scope = &scope, .in_field = 1, .steps = CAGD_USUAL_STEPS};
        cagd_field_open(MOST_LETTERS);
        cagd_region_faults = 0;
        cagd_value value = cagd_evaluate(c, tree);
        if (cagd_region_faults != 0)
            wrong(l, c->trouble != NULL ? c->trouble : "the formula has no value");
        for (int k = 0; k < c->count; k++) /* the names that the field has for the letters */
            if (c->binding[k].unknown)
                fprintf(out, "    double v%d = %s;\n", c->binding[k].number, c->binding[k].key);
        fputs("    return ", out);
        const char *why = NULL;
        if (cagd_region_faults == 0)
            why = lab_put_function(cagd_to_string_f(cagd_in_field(value)), out);
        if (why != NULL)
            wrong(l, why);
        else if (cagd_region_faults == 0)
            status = 0;
        cagd_region_faults = 0;
    }
    free(c);
    cagd_region_drop(mark);
    return status;
}

/* "name = numbers" or "name(t, s) = formula". */
static int put_line(struct line *l, FILE *out)
{
    size_t n = word(l), count = 0;
    const char *name = l->at;
    char letters[100] = "";
    if (n == 0 || strncmp(name, "cagd_", 5) == 0 || strncmp(name, "lab_", 4) == 0)
        return wrong(l, "\"name = numbers\" or \"name(t) = formula\" was expected");
    l->at += n;
    if (!pass(l, '(')) {
        fprintf(out, "void %.*s(double *x)\n{\n", (int)n, name);
        if (!pass(l, '='))
            return wrong(l, "= was expected behind the name");
        int status = put_numbers(l, out);
        fputs("}\n", out);
        return status;
    }
    fprintf(out, "double %.*s(", (int)n, name);
    do {
        if (!isalpha((unsigned char)*(skip(l), l->at)) || count == MOST_LETTERS)
            return wrong(l, "letters with commas between were expected in brackets");
        snprintf(letters + strlen(letters), sizeof letters - strlen(letters), "%s%c", count > 0 ? ", " : "", *l->at);
        fprintf(out, "%sdouble %c", count++ > 0 ? ", " : "", *l->at++);
    } while (pass(l, ','));
    if (!pass(l, ')') || !pass(l, '='))
        return wrong(l, ") = was expected behind the letters");
    skip(l);
    fputs(")\n{\n", out);
    int status = put_formula(l, letters, out);
    fputs(";\n}\n", out);
    return status;
}

char *lab_numbers_as_c(const char *source, char **cause, long *digits)
{
    char *text = NULL, *copy = strdup(source), *rest = copy;
    size_t size;
    struct line l = {0};
    FILE *out = open_memstream(&text, &size);
    if (copy == NULL || out == NULL)
        abort();
    for (char *row; l.cause[0] == 0 && (row = strsep(&rest, "\n")) != NULL;) {
        l.number++;
        row[strcspn(row, "#\r")] = 0;
        l.at = row + strspn(row, " \t");
        if (*l.at != 0)
            put_line(&l, out);
    }
    fclose(out);
    free(copy);
    *digits = l.digits;
    *cause = l.cause[0] != 0 ? strdup(l.cause) : NULL;
    if (*cause == NULL)
        return text;
    free(text);
    return NULL;
}

json_t *lab_inspect_numbers(const char *source)
{
    char *cause = NULL, text[100];
    long digits;
    free(lab_numbers_as_c(source, &cause, &digits));
    json_t *seen = json_pack("{s:[]}", "notes");
    if (cause != NULL) {
        json_object_set_new(seen, "compiler", json_string(cause));
    } else {
        snprintf(text, sizeof text, "the numbers of this file have %ld digits together", digits);
        json_array_append_new(json_object_get(seen, "notes"), json_pack("{s:i, s:s}", "line", 0, "text", text));
    }
    free(cause);
    return seen;
}
