/* page.c -- a result as one screen of text; see lab.h. */
#include "cli/lab/lab.h"
#include "cli/layout.h"
#include "cli/terminal.h"

#include <string.h>

enum { MOST_WIDTH = 100, NAME = 14, INDENT = 16 };

static const char *member(const json_t *row, const char *key)
{
    const char *text = json_string_value(json_object_get(row, key));
    return text != NULL ? text : "";
}

static void print_named(const char *name, const char *text)
{
    int used = printf("%*s%-8s ", INDENT, "", name);
    put_behind(stdout, text, used, used, page_width(MOST_WIDTH));
}

/* "n = 1   p = 0, 1   t = 1/2" */
static void print_inputs(const json_t *row)
{
    const char *name, *where = member(row, "case");
    const json_t *values, *value;
    size_t k;
    if (*where != 0)
        print_named("for", where);
    json_object_foreach((json_t *)(uintptr_t)json_object_get(row, "inputs"), name, values)
    {
        char line[2000] = "";
        size_t at = 0;
        json_array_foreach(values, k, value) if (at < sizeof line) at +=
            (size_t)snprintf(line + at, sizeof line - at, "%s%s", k > 0 ? ", " : "", json_string_value(value));
        print_named(name, line);
    }
}

static void print_requirement(const json_t *row)
{
    const char *verdict = member(row, "verdict");
    int right = json_equal(json_object_get(row, "points"), json_object_get(row, "of"));
    size_t k;
    const json_t *one, *hint = json_object_get(row, "hint");
    printf("  %s", style(stdout, BOLD));
    put_padded(stdout, member(row, "name"), NAME - 2);
    int points =
        printf("%s  %2d of %2d  ", style(stdout, PLAIN), (int)json_integer_value(json_object_get(row, "points")),
               (int)json_integer_value(json_object_get(row, "of"))) -
        (int)strlen(style(stdout, PLAIN));
    put_behind(stdout, member(row, "title"), NAME + points, NAME + points, page_width(MOST_WIDTH));
    int used = printf("%*s", INDENT, "");
    fputs(style(stdout, right ? GOOD : BAD), stdout);
    char text[1000];
    long line = (long)json_integer_value(json_object_get(row, "line"));
    int told = strstr(member(row, "text"), "in line") != NULL;
    snprintf(text, sizeof text, "%s%s%.700s", right ? "" : verdict, right || *member(row, "text") == 0 ? "" : ": ",
             member(row, "text"));
    if (line > 0 && !told)
        snprintf(text + strlen(text), sizeof text - strlen(text), ", in line %ld", line);
    put_behind(stdout, text, used, INDENT, page_width(MOST_WIDTH));
    fputs(style(stdout, PLAIN), stdout);
    print_inputs(row);
    if (*member(row, "because") != 0)
        print_named("because", member(row, "because"));
    json_array_foreach(json_object_get(row, "differences"), k, one)
    {
        char both[700];
        snprintf(both, sizeof both, "%.300s; expected %.300s", member(one, "got"), member(one, "expected"));
        print_named(member(one, "name"), both);
    }
    if (*member(row, "levels") != 0)
        print_named("levels", member(row, "levels"));
    if (hint != NULL) {
        print_named("hint", member(hint, "text"));
        if (*member(hint, "zh") != 0)
            print_named("", member(hint, "zh"));
    }
}

void lab_print(const struct lab *lab, const json_t *result)
{
    size_t k;
    const json_t *row, *measured = json_object_get(result, "measured");
    const char *compiler = member(result, "compiler"), *refused = member(result, "refused");
    printf("%s%s%s  ", style(stdout, BOLD), lab->name, style(stdout, PLAIN));
    int name = (int)strlen(lab->name) + 2;
    put_behind(stdout, member(result, "title"), name, name, page_width(MOST_WIDTH));
    int all = json_equal(json_object_get(result, "points"), json_object_get(result, "of"));
    if (*compiler != 0)
        printf("%sit does not compile%s\n%s\n", style(stdout, BAD), style(stdout, PLAIN), compiler);
    else if (*refused != 0)
        printf("%sit was not run%s: %s\n", style(stdout, BAD), style(stdout, PLAIN), refused);
    else
        json_array_foreach(json_object_get(result, "requirements"), k, row) print_requirement(row);
    json_array_foreach(json_object_get(result, "notes"), k,
                       row) if (!all || strstr(member(row, "text"), "division") == NULL)
    {
        int line = (int)json_integer_value(json_object_get(row, "line"));
        int used = line > 0 ? printf("  line %d: ", line) : printf("  ");
        put_behind(stdout, member(row, "text"), used, 4, page_width(MOST_WIDTH));
    }
    if (measured != NULL) {
        char text[300];
        snprintf(text, sizeof text,
                 "%s at %d points that were drawn: %.3g ulps from the exact value at worst, the best known %.3g; %d "
                 "operations, the best known "
                 "%d%s%.100s",
                 json_is_true(json_object_get(measured, "stable")) ? "stable" : "not stable",
                 (int)json_integer_value(json_object_get(measured, "points")),
                 json_real_value(json_object_get(measured, "ulps")),
                 json_real_value(json_object_get(measured, "best_ulps")),
                 (int)json_integer_value(json_object_get(measured, "operations")),
                 (int)json_integer_value(json_object_get(measured, "best_operations")),
                 *member(measured, "case") != 0 ? " for " : "", member(measured, "case"));
        int used = printf("  %-*s", INDENT - 2, "binary64");
        put_behind(stdout, text, used, INDENT, page_width(MOST_WIDTH));
    }
    printf("%s%d of %d points%s\n", style(stdout, all ? GOOD : PLAIN),
           (int)json_integer_value(json_object_get(result, "points")),
           (int)json_integer_value(json_object_get(result, "of")), style(stdout, PLAIN));
}
