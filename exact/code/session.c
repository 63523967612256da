/* session.c -- the program cagd-exactly-session: the functions of cagd_exactly.h as lines, for other languages.
 *
 *     source TEXT, flags TEXT, include TEXT, declare TEXT, input TEXT, where TEXT, call TEXT, output TEXT
 *                                     a part of the code; what was said of it before goes on with a new line
 *     load                            "ok", or "error MESSAGE"
 *     set NAME VALUE...               "ok", or "error MESSAGE"
 *     run rational|field|interval|rounding      "ok", or "END MESSAGE", END being outside, undefined, refused, bound or crashed
 *     get NAME...                     "value TEXT", with tabulators between the texts, or "error ..."
 *     function NAME..., computed NAME..., ulps NAME..., condition K      the same
 *
 * Each line is answered by one, but those that are parts of the code. */
#include "exact/code/exactly.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_VALUES = 1000 };

static struct cagd_exactly_code code;
static struct cagd_exactly *loaded;

static void add_part(const char **part, const char *text)
{
    size_t had = *part != NULL ? strlen(*part) : 0, size = had + strlen(text) + 2;
    char *all = malloc(size);
    if (all == NULL)
        exit(3);
    snprintf(all, size, "%s%s%s", had > 0 ? *part : "", had > 0 ? "\n" : "", text);
    *part = all;
}

static int take_part(const char *key, const char *text)
{
    const struct {
        const char *key, **part;
    } parts[] = {{"source", &code.source},   {"flags", &code.flags},  {"include", &code.include},
                 {"declare", &code.declare}, {"input", &code.input},  {"where", &code.where},
                 {"call", &code.call},       {"output", &code.output}};
    for (size_t k = 0; k < sizeof parts / sizeof *parts; k++)
        if (strcmp(key, parts[k].key) == 0) {
            add_part(parts[k].part, text);
            return 1;
        }
    return 0;
}

static void load(void)
{
    char message[1000];
    cagd_exactly_free(loaded);
    loaded = cagd_exactly_load(&code, sizeof message, message);
    printf(loaded != NULL ? "ok\n" : "error %s\n", message);
}

static void set(char *text)
{
    const char *value[MOST_VALUES];
    int count = 0;
    const char *name = strtok(text, " ");
    for (char *word; name != NULL && count < MOST_VALUES && (word = strtok(NULL, " ")) != NULL;)
        value[count++] = word;
    puts(name != NULL && cagd_exactly_set(loaded, name, count, value) == 0
             ? "ok"
             : "error there is no such input of so many numbers, or one is no number");
}

static void run(const char *word)
{
    static const char *const words[] = {"rational", "field", "interval", "rounding"};
    static const char *const ends[] = {"ok", "outside", "undefined", "refused", "bound", "crashed"};
    for (int k = 0; k < 4; k++)
        if (strcmp(word, words[k]) == 0) {
            enum cagd_exactly_end end = cagd_exactly_call(loaded, (enum cagd_exactly_numbers)k);
            printf("%s%s%s\n", ends[end], end != CAGD_EXACTLY_DONE ? " " : "", cagd_exactly_message(loaded));
            return;
        }
    puts("error rational, field, interval or rounding was expected");
}

/* What was asked of the last call; NULL where there is none.  A text of ours lives until the next. */
static const char *told(const char *key, const char *name)
{
    static char number[40];
    if (strcmp(key, "get") == 0)
        return cagd_exactly_get(loaded, name);
    if (strcmp(key, "function") == 0)
        return cagd_exactly_function(loaded, name);
    if (strcmp(key, "condition") == 0)
        return cagd_exactly_condition(loaded, atoi(name));
    if (strcmp(key, "computed") != 0 && strcmp(key, "ulps") != 0)
        return NULL;
    double x = strcmp(key, "ulps") == 0 ? cagd_exactly_ulps(loaded, name) : cagd_exactly_computed(loaded, name);
    snprintf(number, sizeof number, "%.17g", x);
    return number;
}

static void get(const char *key, char *names)
{
    char *answer = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&answer, &size);
    if (out == NULL)
        exit(3);
    const char *between = "", *text = NULL;
    for (char *name = strtok(names, " "); name != NULL; name = strtok(NULL, " ")) {
        text = told(key, name);
        if (text == NULL)
            break;
        fprintf(out, "%s%s", between, text);
        between = "\t";
    }
    if (fclose(out) != 0)
        exit(3);
    printf(text != NULL ? "value %s\n" : "error there is none\n", answer);
    free(answer);
}

int main(void)
{
    char *line = NULL;
    size_t room = 0;
    while (getline(&line, &room, stdin) > 0) {
        line[strcspn(line, "\n")] = 0;
        char *text = strchr(line, ' ');
        if (text != NULL)
            *text++ = 0;
        else
            text = line + strlen(line);
        if (!take_part(line, text)) {
            if (strcmp(line, "load") == 0)
                load();
            else if (loaded == NULL)
                puts("error nothing is loaded");
            else if (strcmp(line, "set") == 0)
                set(text);
            else if (strcmp(line, "run") == 0)
                run(text);
            else
                get(line, text);
            fflush(stdout);
        }
    }
    cagd_exactly_free(loaded);
    free(line);
    return 0;
}
