/* prove.c -- whether a lab is well made: what a student begins with can be judged, right solutions pass, wrong ones get their verdict, every
 * requirement catches one. */
#include "cli/commands.h"
#include "cli/lab/lab.h"
#include "cli/refuse.h"
#include "cli/report.h"
#include "core/clock.h"

#include <dirent.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

struct proof {
    struct lab_bench *bench;
    const struct lab *lab;
    json_t *rows;
    char caught[2000]; /* requirements that some wrong solution fails, each between blanks */
    int bad;
};

static const char *member(const json_t *row, const char *key)
{
    const char *text = json_string_value(json_object_get(row, key));
    return text != NULL ? text : "";
}

/* The requirements without full points, with blanks between; and the name of the first hint. */
static void failed_in(const json_t *result, char failed[400], const char **hint)
{
    size_t k;
    const json_t *row;
    failed[0] = 0;
    *hint = "";
    json_array_foreach(json_object_get(result, "requirements"), k, row)
    {
        if (json_equal(json_object_get(row, "points"), json_object_get(row, "of")))
            continue;
        snprintf(failed + strlen(failed), 400 - strlen(failed), "%s%s", failed[0] != 0 ? " " : "", member(row, "name"));
        if (**hint == 0)
            *hint = member(json_object_get(row, "hint"), "name");
    }
}

static void tell(struct proof *p, const char *name, const char *kind, double seconds, const char *what,
                 const json_t *result)
{
    printf("  %-34s %-6s %5.2f s  %s\n", name, kind, seconds, *what != 0 ? what : "as it should be");
    p->bad += *what != 0;
    json_array_append_new(p->rows, json_pack("{s:s, s:s, s:f, s:s, s:O}", "name", name, "kind", kind, "seconds",
                                             seconds, "wrong", what, "result", result));
}

/* How the reference failed where it was asked something; "": it did not. */
static const char *failure_of_reference(const json_t *result)
{
    size_t k;
    const json_t *row;
    json_array_foreach(json_object_get(result, "requirements"), k,
                       row) if (*member(row, "reference") != 0) return member(row, "reference");
    return "";
}

static void try_right(struct proof *p, const char *name)
{
    char path[LAB_MOST_PATH + 300], failed[400], what[LAB_CAUSE] = "";
    const char *hint;
    snprintf(path, sizeof path, "%s/%s", p->lab->folder, name);
    char *text = lab_file(path);
    double begun = cagd_seconds();
    json_t *result = text != NULL ? lab_judge(p->bench, text, 0) : json_object();
    failed_in(result, failed, &hint);
    if (text == NULL || failed[0] != 0)
        snprintf(what, sizeof what, "a right solution fails: %s", failed);
    else if (*failure_of_reference(result) != 0)
        snprintf(what, sizeof what, "the reference fails within the inputs: %s", failure_of_reference(result));
    tell(p, name, "right", cagd_seconds() - begun, what, result);
    json_decref(result);
    free(text);
}

/* What a student begins with: it can be judged, and is worth less than half of the points. */
static void try_start(struct proof *p)
{
    char name[40], path[LAB_MOST_PATH + 60], what[LAB_CAUSE] = "";
    snprintf(name, sizeof name, "start%s", strrchr(p->lab->file, '.'));
    snprintf(path, sizeof path, "%s/%s", p->lab->folder, name);
    char *text = lab_file(path);
    double begun = cagd_seconds();
    json_t *result = text != NULL ? lab_judge(p->bench, text, 0) : json_object();
    const char *unread = *member(result, "compiler") != 0 ? member(result, "compiler") : member(result, "refused");
    json_int_t points = json_integer_value(json_object_get(result, "points")),
               of = json_integer_value(json_object_get(result, "of"));
    if (text == NULL)
        snprintf(what, sizeof what, "there is none");
    else if (*unread != 0)
        snprintf(what, sizeof what, "%.500s", unread);
    else if (2 * points >= of)
        snprintf(what, sizeof what, "it has %lld of %lld points already", (long long)points, (long long)of);
    tell(p, name, "start", cagd_seconds() - begun, what, result);
    json_decref(result);
    free(text);
}

/* Whether some text of the result has it. */
static int says(const json_t *result, const char *words)
{
    char *all = json_dumps(result, JSON_COMPACT);
    int said = all != NULL && strstr(all, words) != NULL;
    free(all);
    return said;
}

static void try_wrong(struct proof *p, const json_t *wrong)
{
    char failed[400] = "", what[LAB_CAUSE] = "";
    const char *hint = "", *name = member(wrong, "name"), *fails = lab_text(wrong, "fails");
    char *text = lab_wrong_source(p->lab, wrong, what);
    double begun = cagd_seconds();
    json_t *result = text != NULL ? lab_judge(p->bench, text, 0) : json_object();
    if (text != NULL) {
        failed_in(result, failed, &hint);
        if (strcmp(failed, fails) != 0)
            snprintf(what, sizeof what, "fails \"%s\", where \"%s\" is said", failed, fails);
        else if (*lab_text(wrong, "hint") != 0 && strcmp(hint, name) != 0)
            snprintf(what, sizeof what, "the hint is \"%s\"", hint);
        else if (*lab_text(wrong, "says") != 0 && !says(result, lab_text(wrong, "says")))
            snprintf(what, sizeof what, "does not say \"%s\"", lab_text(wrong, "says"));
        snprintf(p->caught + strlen(p->caught), sizeof p->caught - strlen(p->caught), " %s ", failed);
    }
    tell(p, name, "wrong", cagd_seconds() - begun, what, result);
    json_decref(result);
    free(text);
}

/* A triangle that no right solution computes may be none, and is never told. */
static void tell_uncomputed(struct proof *p)
{
    size_t k;
    const json_t *block;
    json_array_foreach(p->lab->blocks, k, block)
    {
        char line[24];
        snprintf(line, sizeof line, "%d", (int)json_integer_value(json_object_get(block, "line")));
        if (strcmp(member(block, "kind"), "triangle") != 0 || json_object_get(p->bench->whole, line) != NULL)
            continue;
        printf("  %s in line %s: no right solution computes this triangle\n", member(block, "name"), line);
        p->bad++;
    }
}

static int has_formulas(const struct lab *lab)
{
    int has = 0;
    for (int k = 0; k < lab->cases; k++)
        has |= lab->at[k].formula != NULL;
    return has && strcmp(lab->language, "c") == 0;
}

static void try_all(struct proof *p)
{
    char path[LAB_MOST_PATH + 16], name[300], words[100];
    size_t k;
    const json_t *block;
    try_start(p);
    snprintf(path, sizeof path, "%s/right", p->lab->folder);
    DIR *d = opendir(path);
    for (const struct dirent *e; d != NULL && (e = readdir(d)) != NULL;)
        if (*e->d_name != '.') {
            snprintf(name, sizeof name, "right/%s", e->d_name);
            try_right(p, name);
        }
    if (d != NULL)
        closedir(d);
    if (has_formulas(p->lab)) /* then the reference is an answer like others */
        try_right(p, "reference.c");
    json_array_foreach(p->lab->blocks, k, block) if (strcmp(member(block, "kind"), "wrong") == 0) try_wrong(p, block);
    tell_uncomputed(p);
    json_array_foreach(p->lab->blocks, k, block)
    {
        snprintf(words, sizeof words, " %s ", member(block, "name"));
        if (strcmp(member(block, "kind"), "requirement") != 0 || strstr(p->caught, words) != NULL)
            continue;
        printf("  %s: no wrong solution fails this requirement\n", member(block, "name"));
        p->bad++;
    }
}

int lab_test(const char *folder, int as_json)
{
    char cause[LAB_CAUSE] = "";
    struct proof p = {.bench = calloc(1, sizeof *p.bench), .rows = json_array()};
    struct lab *lab = lab_read(folder, "0", cause);
    if (lab == NULL || p.bench == NULL || lab_bench_open(p.bench, lab, 0, cause) != 0) {
        refuse_line("%s: %s", folder, cause);
        lab_free(lab);
        free(p.bench);
        json_decref(p.rows);
        return EXIT_USAGE;
    }
    p.lab = lab;
    p.bench->kept = json_object();
    p.bench->whole = json_object();
    FILE *screen = stdout;
    if (as_json)
        stdout = stderr;
    printf("%s\n", lab->name);
    double begun = cagd_seconds();
    try_all(&p);
    printf("%s: %zu solutions, %d not as they should be, %.1f s\n", lab->name, json_array_size(p.rows), p.bad,
           cagd_seconds() - begun);
    stdout = screen;
    if (as_json)
        print_json(json_pack("{s:s, s:s, s:O}", "schema", "cagd-lab-test-1", "lab", lab->name, "solutions", p.rows));
    lab_bench_close(p.bench);
    free(p.bench);
    json_decref(p.rows);
    lab_free(lab);
    return p.bad == 0 ? EXIT_AS_EXPECTED : EXIT_NOT_AS_EXPECTED;
}
