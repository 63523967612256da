/* exactly.c -- cagd exactly: other people's code, executed in exact arithmetic. */
#include "cli/commands.h"
#include "cli/input.h"
#include "cli/layout.h"
#include "cli/output.h"
#include "cli/report.h"
#include "cli/terminal.h"
#include "exact/code/build.h"
#include "exact/code/decide.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { MOST_BYTES = 1 << 22, MOST_SHOWN_PATHS = 4, MOST_SHOWN = 12, MOST_TEXT = 200, WIDTH = 100 };

struct arguments {
    struct asked asked;
    const char *only, *junit;
    int points, rounding;
};

static error_t parse(int key, char *arg, struct argp_state *state)
{
    struct arguments *a = state->input;
    switch (key) {
    case 'n':
        a->only = arg;
        return 0;
    case 'p':
        a->points = whole_number(state, "--points", arg, 1, 100000);
        return 0;
    case 'r':
        a->rounding = arg != NULL ? whole_number(state, "--rounding", arg, 1, 1000000) : 400;
        return 0;
    case 'u':
        a->junit = arg;
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static const char *const words[] = {"proved", "sampled", "enclosed", "differs", "undecided", "computed"};

static int is_expected(const struct cagd_code_verdict *v)
{
    return v->word != CAGD_CODE_DIFFERS && v->word != CAGD_CODE_UNDECIDED;
}

/* The file, whole; NULL and a line on stderr. */
static char *read_all(const char *path)
{
    FILE *file = strcmp(path, "-") == 0 ? stdin : fopen(path, "r");
    char *text = malloc(MOST_BYTES + 1);
    if (text == NULL)
        abort();
    size_t size = file != NULL ? fread(text, 1, MOST_BYTES + 1, file) : 0;
    struct input_error error = {"", ""};
    if (file == NULL || ferror(file))
        snprintf(error.cause, sizeof error.cause, "cannot be read");
    else if (size > MOST_BYTES)
        snprintf(error.cause, sizeof error.cause, "more than %d bytes", MOST_BYTES);
    else if (memchr(text, '\0', size) != NULL)
        snprintf(error.cause, sizeof error.cause, "is no text");
    if (file != NULL && file != stdin)
        fclose(file);
    if (error.cause[0] != 0) {
        report_input_error(path, &error);
        free(text);
        return NULL;
    }
    text[size] = 0;
    return text;
}

/* The program that compiles: beside this one. */
static void find_compiler(size_t room, char path[])
{
    static const char name[] = "cagd-compile-exactly";
    ssize_t length = readlink("/proc/self/exe", path, room - sizeof name - 1);
    while (length > 0 && path[length - 1] != '/')
        length--;
    strcpy(path + (length > 0 ? length : 0), name);
}

/* ---- text ------------------------------------------------------------------------------------------------- */

static void print_row(const char *name, const char *text)
{
    printf("  %-16s  ", name);
    if ((int)strlen(text) < WIDTH - 20) {
        puts(text);
        return;
    }
    putchar('\n');
    put_paragraph(stdout, text, 4, WIDTH);
}

static const char *clipped(const char *text) { return strlen(text) <= MOST_TEXT ? text : "(long)"; }

static void print_point(const struct cagd_code_point *p)
{
    for (int i = 0; i < p->inputs; i++) {
        char line[4000];
        size_t at = 0;
        line[0] = 0;
        for (int j = 0; j < (p->input[i].count > 0 ? p->input[i].count : 1) && at < sizeof line; j++)
            at += (size_t)snprintf(line + at, sizeof line - at, "%s%s", j > 0 ? ", " : "", p->input[i].value[j]);
        print_row(p->input[i].name, line);
    }
}

static void print_results(const struct cagd_code_outcome *o)
{
    int shown = 0;
    for (const struct cagd_code_result *r = o->results; r != NULL; r = r->next) {
        char line[2 * MOST_TEXT + 100];
        if (r->wanted != NULL && r->same != CAGD_CODE_DIFFERENT)
            continue;
        if (shown++ == MOST_SHOWN) {
            puts("  ...");
            break;
        }
        if (r->wanted != NULL)
            snprintf(line, sizeof line, "%s; expected %s", clipped(r->got), clipped(r->wanted));
        else
            snprintf(line, sizeof line, "%s", clipped(r->got));
        print_row(r->name, line);
    }
}

/* The conditions of a path, those that are not implied, in one line. */
static void print_conditions(const struct cagd_code_outcome *o)
{
    char line[8000] = "";
    size_t at = 0;
    for (const struct cagd_code_condition *c = o->conditions; c != NULL && at < sizeof line; c = c->next)
        if (!c->given && !c->implied) {
            at += (size_t)snprintf(line + at, sizeof line - at, "%s%s %s %s", at > 0 ? ", " : "", clipped(c->left),
                                   c->relation, clipped(c->right));
        }
    print_row("where", at > 0 ? line : "(always)");
    at = 0;
    for (const char *d = o->denominators; d != NULL && *d != 0 && at < sizeof line;) {
        size_t length = strcspn(d, "\n");
        at += (size_t)snprintf(line + at, sizeof line - at, "%s%.*s != 0", at > 0 ? ", " : "", (int)length, d);
        d += length + 1;
    }
    if (at > 0)
        print_row("and", line);
}

static void print_rounding(const struct cagd_code_verdict *v)
{
    printf("\nIn binary64, at %ld points\n", v->rounded);
    if (v->turned > 0)
        printf("  rounding turned %ld comparisons, the first at %s\n", v->turned, v->turned_at);
    for (int k = 0; k < v->worsts; k++) {
        const struct cagd_code_worst *w = &v->worst[k];
        if (w->point == NULL)
            continue;
        printf("  %-16s  %.3g ulps of the exact value at worst", w->name, w->ulps);
        if (w->line[0] != 0)
            printf("; %.0f %% of what was rounded there arises at %s", 100 * w->part, w->line);
        puts("");
    }
}

static void print_verdict(const struct cagd_code_harness *h, const struct cagd_code_verdict *v)
{
    printf("%s%s%s", style(stdout, BOLD), h->name, style(stdout, PLAIN));
    printf("%s%s\n", h->title != NULL ? "  " : "", h->title != NULL ? h->title : "");
    enum style colour = is_expected(v) ? GOOD : BAD;
    printf("%s%s%s", style(stdout, colour), words[v->word], style(stdout, PLAIN));
    switch (v->word) {
    case CAGD_CODE_PROVED:
        printf(": equal for all values of the variables, ");
        if (v->paths == 1)
            printf("on the one way through the code that all %ld points took\n", v->points);
        else
            printf("on each of the %d ways through the code that %ld points took\n", v->paths, v->points);
        break;
    case CAGD_CODE_SAMPLED:
        printf(": equal at all %ld points tried", v->points);
        printf(v->paths > 0 ? "; in the field proved on %d of the %d ways that they took\n" : "\n", v->proved,
               v->paths);
        break;
    case CAGD_CODE_ENCLOSED:
        printf(": not different at any of %ld points, where some results are intervals\n", v->points);
        break;
    case CAGD_CODE_DIFFERS:
        puts(": an input for which the results are not equal");
        break;
    case CAGD_CODE_UNDECIDED:
        puts(v->message[0] != 0 ? "" : ": no answer");
        break;
    case CAGD_CODE_COMPUTED:
        printf(" at %ld points\n", v->points);
        break;
    }
    if (v->patterns > 1)
        printf("equal neighbours: %ld of %ld patterns met\n", v->seen, v->patterns);
    if (v->message[0] != 0)
        print_row("because", v->message);
    if (v->word == CAGD_CODE_DIFFERS || v->word == CAGD_CODE_UNDECIDED || v->word == CAGD_CODE_COMPUTED) {
        if (v->point != NULL) {
            print_point(v->point);
            print_results(v->outcome);
        }
    }
    if (v->hole != NULL && v->word != CAGD_CODE_UNDECIDED) {
        print_row("no value", v->hole_message);
        print_point(v->hole);
    }
    int shown = 0;
    for (int k = 0; k < v->paths && v->word != CAGD_CODE_DIFFERS; k++) {
        const struct cagd_code_path *path = &v->path[k];
        if (path->field == NULL || path->field->end != CAGD_CODE_FINISHED)
            continue;
        if (v->word == CAGD_CODE_COMPUTED)
            for (const struct cagd_code_result *r = path->field->results; r != NULL && shown < MOST_SHOWN_PATHS;
                 r = r->next)
                if (r->wanted == NULL)
                    print_row(r->name, clipped(r->got_field));
        if (!path->proved)
            continue;
        if (shown++ == MOST_SHOWN_PATHS) {
            printf("  and %d other ways; --json lists them all\n", v->proved - MOST_SHOWN_PATHS);
            break;
        }
        print_conditions(path->field);
    }
    if (v->rounded > 0)
        print_rounding(v);
}

/* ---- JSON -------------------------------------------------------------------------------------------------- */

static json_t *point_json(const struct cagd_code_point *p)
{
    json_t *object = json_object();
    for (int i = 0; i < p->inputs; i++) {
        json_t *values = json_array();
        for (int j = 0; j < (p->input[i].count > 0 ? p->input[i].count : 1); j++)
            json_array_append_new(values, json_string(p->input[i].value[j]));
        json_object_set_new(object, p->input[i].name, values);
    }
    return object;
}

static json_t *results_json(const struct cagd_code_outcome *o)
{
    static const char *const answers[] = {"equal", "different", "unknown"};
    json_t *array = json_array();
    for (const struct cagd_code_result *r = o->results; r != NULL; r = r->next) {
        json_t *row = json_pack("{s:s, s:s}", "name", r->name, "value", r->got);
        if (r->wanted != NULL) {
            json_object_set_new(row, "expected", json_string(r->wanted));
            json_object_set_new(row, "answer", json_string(answers[r->same]));
        }
        if (r->got_field != NULL)
            json_object_set_new(row, "function", json_string(r->got_field));
        json_array_append_new(array, row);
    }
    return array;
}

static json_t *path_json(const struct cagd_code_path *path)
{
    json_t *row = json_pack("{s:b, s:o}", "proved", path->proved, "point", point_json(path->point));
    json_t *conditions = json_array(), *denominators = json_array();
    for (const struct cagd_code_condition *c = path->field != NULL ? path->field->conditions : NULL; c != NULL;
         c = c->next)
        json_array_append_new(conditions,
                              json_pack("{s:s, s:s, s:s, s:b, s:b, s:s, s:i}", "left", c->left, "relation", c->relation,
                                        "right", c->right, "precondition", c->given, "implied", c->implied, "file",
                                        c->place.file ? c->place.file : "", "line", (int)c->place.line));
    for (const char *d = path->field != NULL ? path->field->denominators : NULL; d != NULL && *d != 0;) {
        const char *end = strchr(d, '\n');
        json_array_append_new(denominators, json_stringn(d, (size_t)(end - d)));
        d = end + 1;
    }
    json_object_set_new(row, "conditions", conditions);
    json_object_set_new(row, "not_zero", denominators);
    return row;
}

static json_t *verdict_json(const struct cagd_code_harness *h, const struct cagd_code_verdict *v)
{
    json_t *row = json_pack("{s:s, s:s, s:s, s:I, s:I, s:i, s:i}", "name", h->name, "title", h->title ? h->title : "",
                            "verdict", words[v->word], "points", (json_int_t)v->points, "outside",
                            (json_int_t)v->outside, "paths", v->paths, "paths_proved", v->proved);
    if (v->message[0] != 0)
        json_object_set_new(row, "because", json_string(v->message));
    if (v->patterns > 1)
        json_object_set_new(row, "patterns",
                            json_pack("{s:I, s:I}", "all", (json_int_t)v->patterns, "met", (json_int_t)v->seen));
    if (v->hole != NULL)
        json_object_set_new(row, "no_value",
                            json_pack("{s:I, s:s, s:o}", "points", (json_int_t)v->undefined, "because", v->hole_message,
                                      "point", point_json(v->hole)));
    if (v->point != NULL) {
        json_object_set_new(row, "point", point_json(v->point));
        json_object_set_new(row, "results", results_json(v->outcome));
    }
    json_t *paths = json_array(), *worst = json_array();
    for (int k = 0; k < v->paths; k++)
        json_array_append_new(paths, path_json(&v->path[k]));
    json_object_set_new(row, "ways", paths);
    for (int k = 0; k < v->worsts; k++) {
        const struct cagd_code_worst *w = &v->worst[k];
        if (w->point == NULL)
            continue;
        json_t *one = json_pack("{s:s, s:s, s:f, s:o}", "name", w->name, "line", w->line, "part", w->part, "point",
                                point_json(w->point));
        json_object_set_new(one, "ulps", isfinite(w->ulps) ? json_real(w->ulps) : json_null());
        json_array_append_new(worst, one);
    }
    if (v->rounded > 0)
        json_object_set_new(row, "rounding",
                            json_pack("{s:I, s:I, s:o}", "points", (json_int_t)v->rounded, "turned",
                                      (json_int_t)v->turned, "worst", worst));
    else
        json_decref(worst);
    return row;
}

/* ---- the command -------------------------------------------------------------------------------------------- */

static int answer(const struct arguments *a, const struct cagd_code_harness *h, json_t *list, int *expected)
{
    char message[600], compiler[4200];
    find_compiler(sizeof compiler, compiler);
    struct cagd_code_program *p = cagd_code_build(h, a->asked.path, compiler, sizeof message, message);
    if (p == NULL) {
        fprintf(stderr, "cagd: %s: line %d: %s: %s\n", name_of_input(a->asked.path), h->line, h->name, message);
        return EXIT_USAGE;
    }
    struct cagd_code_verdict *v = cagd_code_decide(p, h, a->points > 0 ? a->points : h->points, a->rounding);
    *expected += is_expected(v);
    if (list != NULL)
        json_array_append_new(list, verdict_json(h, v));
    if (!a->asked.json)
        print_verdict(h, v);
    cagd_code_verdict_free(v);
    cagd_code_unload(p);
    return EXIT_AS_EXPECTED;
}

/* The verdicts as JUnit XML: a case for each block. */
static int write_cases(const char *path, json_t *list, int failures)
{
    struct output *o = output_open(path);
    if (o == NULL)
        return -1;
    FILE *out = output_stream(o);
    size_t k;
    json_t *row;
    fprintf(
        out,
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"cagd exactly\" tests=\"%zu\" failures=\"%d\">\n",
        json_array_size(list), failures);
    json_array_foreach(list, k, row)
    {
        const char *word = json_string_value(json_object_get(row, "verdict"));
        int failed = strcmp(word, "differs") == 0 || strcmp(word, "undecided") == 0;
        fprintf(out, "  <testcase classname=\"exactly\" name=\"%s\"", json_string_value(json_object_get(row, "name")));
        fprintf(out, failed ? "><failure message=\"%s\"/></testcase>\n" : "/>\n", word);
    }
    fputs("</testsuite>\n", out);
    return output_close(o);
}

static int run(const struct call *call)
{
    struct arguments a = {.only = NULL};
    parse_arguments(call, &a.asked);
    char *text = read_all(a.asked.path);
    if (text == NULL)
        return EXIT_USAGE;
    struct cagd_code_harness_error error;
    struct cagd_code_harness *all = cagd_code_read_harness(text, &error);
    free(text);
    if (all == NULL) {
        struct input_error wrong;
        snprintf(wrong.place, sizeof wrong.place, "line %d", error.line);
        snprintf(wrong.cause, sizeof wrong.cause, "%s", error.cause);
        report_input_error(a.asked.path, &wrong);
        return EXIT_USAGE;
    }
    json_t *list = json_array();
    int answered = 0, expected = 0, code = EXIT_AS_EXPECTED;
    for (const struct cagd_code_harness *h = all; h != NULL && code == EXIT_AS_EXPECTED; h = h->next) {
        if (a.only != NULL && strcmp(a.only, h->name) != 0)
            continue;
        if (answered++ > 0 && !a.asked.json)
            puts("");
        code = answer(&a, h, list, &expected);
    }
    if (answered == 0) {
        fprintf(stderr, "cagd: %s: no block is named '%s'\n", name_of_input(a.asked.path), a.only);
        code = EXIT_USAGE;
    }
    if (code == EXIT_AS_EXPECTED && a.junit != NULL && write_cases(a.junit, list, answered - expected) != 0)
        code = EXIT_USAGE;
    if (code == EXIT_AS_EXPECTED && a.asked.json)
        print_json_exactly(json_pack("{s:s, s:O}", "schema", "cagd-exactly-1", "blocks", list));
    json_decref(list);
    cagd_code_harness_free(all);
    return code != EXIT_AS_EXPECTED ? code : expected == answered ? EXIT_AS_EXPECTED : EXIT_NOT_AS_EXPECTED;
}

static const struct argp_option options[] = {
    {"only", 'n', "NAME", 0, "The block of that name alone", 0},
    {"points", 'p', "N", 0, "Run the code at so many points (default: as the block says, else 20)", 0},
    {"rounding", 'r', "N", OPTION_ARG_OPTIONAL, "Search for the largest error in binary64, at N points (400)", 0},
    {"junit", 'u', "FILE", 0, "Write the verdicts as JUnit XML", 0},
    {0}};

const struct command command_exactly = {
    .name = "exactly",
    .summary = "code in C or C++, executed in exact arithmetic and compared with what it should compute",
    .example = "  cagd exactly HARNESS.md           your own C, run exactly and in the field: proved, or an input "
               "where it errs\n",
    .usage = "HARNESS.md",
    .text =
        "Runs the C or C++ that the blocks of HARNESS.md name in exact arithmetic, and compares what it computes with "
        "what "
        "is expected. No letter of the code is changed: every operation on floating-point numbers is made one on "
        "rationals, or on rational functions of the inputs. Equal there is equal for all inputs that take the same way "
        "through the code; the comparisons that the code made are told as conditions.\n\n"
        "The code is compiled and run, in a process with bounds on memory and time but with your rights.\n\n"
        "Examples:\n"
        "  cagd exactly casteljau.md\n"
        "  cagd exactly casteljau.md --rounding\n"
        "  cagd exactly casteljau.md --only casteljau_is_bernstein --json\n",
    .arguments = FILE_NAME,
    .file = "blocks that say what is asked",
    .shared = TAKES_JSON,
    .options = options,
    .parse = parse,
    .run = run,
};
