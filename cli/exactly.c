/* exactly.c -- cagd exactly: other people's code, executed in exact arithmetic. */
#include "chapters/judge/memory_text.h"
#include "cli/certify.h"
#include "cli/commands.h"
#include "cli/input.h"
#include "cli/junit.h"
#include "cli/layout.h"
#include "cli/memory.h"
#include "cli/output.h"
#include "cli/point_json.h"
#include "cli/refuse.h"
#include "cli/report.h"
#include "cli/terminal.h"
#include "exact/code/build.h"
#include "exact/code/decide.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { MOST_BYTES = 1 << 22, MOST_SHOWN_PATHS = 4, MOST_SHOWN = 12, MOST_TEXT = 200, WIDEST_LINE = 100 };

struct arguments {
    struct asked asked;
    const char *only, *junit, *certificates;
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
    case 'c':
        a->certificates = arg;
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
    struct input_error error;
    FILE *file = open_input(path, "blocks, as in 'cagd help exactly'", &error);
    if (file == NULL) {
        report_input_error(path, &error);
        return NULL;
    }
    char *text = malloc(MOST_BYTES + 1);
    if (text == NULL)
        abort();
    size_t size = fread(text, 1, MOST_BYTES + 1, file);
    if (ferror(file))
        snprintf(error.cause, sizeof error.cause, "cannot be read to its end: %s", strerror(errno));
    else if (size > MOST_BYTES)
        snprintf(error.cause, sizeof error.cause, "more than %d bytes, the largest size that is read; divide it",
                 MOST_BYTES);
    else if (memchr(text, '\0', size) != NULL)
        snprintf(error.cause, sizeof error.cause, "is no text, there is a zero byte in it; expected Markdown");
    if (file != stdin)
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
    int width = page_width(WIDEST_LINE);
    if ((int)strlen(text) < width - 20) {
        puts(text);
        return;
    }
    putchar('\n');
    put_paragraph(stdout, text, 4, width);
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

/* Of the intermediate values that are known the first that is another; NULL: none. */
static const struct cagd_code_result *first_wrong(const struct cagd_code_outcome *o)
{
    const struct cagd_code_result *first = NULL;
    for (const struct cagd_code_result *r = o->results; r != NULL; r = r->next)
        if (r->stored > 0 && r->same == CAGD_CODE_DIFFERENT && (first == NULL || r->stored < first->stored))
            first = r;
    return first;
}

/* Where the calculation goes wrong first, as far as intermediate values are known; and where it goes another way than one that is right,
 * which need not be wrong. */
static void print_first(const struct cagd_code_outcome *o)
{
    const struct cagd_code_result *wrong = first_wrong(o);
    const struct cagd_code_apart *a = o->apart;
    char line[4 * MOST_TEXT + 500];
    if (wrong != NULL) {
        snprintf(line, sizeof line, "%s%s%s is %s; known is %s", wrong->variable, *wrong->variable != 0 ? " at " : "",
                 wrong->name, clipped(wrong->got), clipped(wrong->wanted));
        print_row("first wrong", line);
    } else if (a != NULL) {
        snprintf(line, sizeof line, "%s, number %ld that it gets: %s at %s; %s at %s", a->name, a->time,
                 clipped(a->got), a->place, clipped(a->other_got), a->other_place);
        print_row("first apart", line);
    }
}

/* Whether an output is among what is told to differ. */
static int is_told_again(const struct cagd_code_result *output)
{
    for (const struct cagd_code_result *r = output->next; r != NULL && output->wanted == NULL; r = r->next)
        if (r->same == CAGD_CODE_DIFFERENT && r->wanted != NULL && strcmp(r->name, output->name) == 0)
            return 1;
    return 0;
}

static void print_results(const struct cagd_code_outcome *o)
{
    int shown = 0;
    for (const struct cagd_code_result *r = o->results; r != NULL; r = r->next) {
        char line[2 * MOST_TEXT + 100];
        if (is_told_again(r))
            continue;
        if (r->wanted != NULL && (r->same != CAGD_CODE_DIFFERENT || r->stored > 0))
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

static const char *const order_keys[CAGD_CODE_ORDERS] = {"smallest_first", "largest_first", "in_halves"};

/* Whether the same sums in another order would lose less: a tenth at least, at points taken by chance. */
static void print_orders(const struct cagd_code_worst *w)
{
    static const char *const orders[CAGD_CODE_ORDERS] = {"from the smallest term up", "from the largest term down",
                                                         "in halves"};
    char line[300];
    int best = 0;
    if (w->by_chance == 0)
        return;
    for (int k = 1; k < CAGD_CODE_ORDERS; k++)
        if (w->mean_in_order[k] < w->mean_in_order[best])
            best = k;
    if (w->mean_in_order[best] < 0.9 * w->mean)
        snprintf(line, sizeof line, "%.3g ulps; %.3g with sums %s", w->mean, w->mean_in_order[best], orders[best]);
    else
        snprintf(line, sizeof line, "%.3g ulps; sums in other orders lose not a tenth less", w->mean);
    print_row("on average", line);
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
        print_orders(w);
    }
}

static int has_preconditions(const struct cagd_code_harness *h)
{
    int any = h->where.count > 0;
    for (int k = 0; k < h->inputs; k++)
        any = any || (h->input[k].shape != CAGD_CODE_ANY && h->input[k].shape != CAGD_CODE_FIXED);
    return any;
}

/* For which inputs it is proved: all, or those that take the ways that were met. */
static void print_scope(const struct cagd_code_harness *h, const struct cagd_code_verdict *v)
{
    char line[1200];
    int divides = v->undefined > 0;
    for (int k = 0; k < v->paths; k++)
        divides = divides || (v->path[k].field->denominators != NULL && v->path[k].field->denominators[0] != 0);
    printf(": equal for all values of the variables%s", has_preconditions(h) ? " that satisfy the preconditions" : "");
    puts(v->exhaustive ? "" : ", on each way that was met");
    if (divides)
        print_row("as far as", h->printed.count > 0 ? "the code and the formula have values there"
                                                   : "the code has a value there");
    snprintf(line, sizeof line, "%d through the code%s", v->paths, v->exhaustive ? ", and there are no others" : "");
    print_row("ways", line);
    if (v->exhaustive)
        return;
    snprintf(line, sizeof line, "it is not known whether inputs take another one, at the branch %s", v->open);
    print_row("open", line);
}

static void print_verdict(const struct cagd_code_harness *h, const struct cagd_code_verdict *v)
{
    printf("%s%s%s", style(stdout, BOLD), h->name, style(stdout, PLAIN));
    printf("%s%s\n", h->title != NULL ? "  " : "", h->title != NULL ? h->title : "");
    enum style colour = is_expected(v) ? GOOD : BAD;
    printf("%s%s%s", style(stdout, colour), words[v->word], style(stdout, PLAIN));
    switch (v->word) {
    case CAGD_CODE_PROVED:
        print_scope(h, v);
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
    if (v->overlapping_at[0] != 0) {
        char line[500];
        snprintf(line, sizeof line, "memcpy does what memmove does between pieces that overlap, first at %s",
                 v->overlapping_at);
        print_row("as far as", line);
    }
    if (v->message[0] != 0)
        print_row("because", v->message);
    if (v->word == CAGD_CODE_DIFFERS || v->word == CAGD_CODE_UNDECIDED || v->word == CAGD_CODE_COMPUTED) {
        if (v->point != NULL) {
            print_point(v->point);
            print_results(v->outcome);
            print_first(v->outcome);
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

static void set_first(json_t *row, const struct cagd_code_outcome *o)
{
    const struct cagd_code_result *wrong = first_wrong(o);
    const struct cagd_code_apart *a = o->apart;
    if (wrong != NULL)
        json_object_set_new(row, "first_wrong",
                            json_pack("{s:s, s:s, s:s, s:s}", "place", wrong->name, "variable", wrong->variable,
                                      "value", wrong->got, "known", wrong->wanted));
    else if (a != NULL)
        json_object_set_new(row, "first_apart",
                            json_pack("{s:s, s:I, s:s, s:s, s:s, s:s}", "variable", a->name, "time",
                                      (json_int_t)a->time, "place", a->place, "value", a->got, "other_place",
                                      a->other_place, "other_value", a->other_got));
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
    if (v->word == CAGD_CODE_PROVED) {
        json_object_set_new(row, "exhaustive", json_boolean(v->exhaustive));
        json_object_set_new(row, "branches_that_no_inputs_take", json_integer(v->closed));
        if (!v->exhaustive)
            json_object_set_new(row, "open", json_string(v->open));
    }
    if (v->overlapping_at[0] != 0)
        json_object_set_new(row, "memcpy_overlaps", json_string(v->overlapping_at));
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
        set_first(row, v->outcome);
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
        if (w->by_chance > 0) {
            json_t *orders = json_object();
            for (int j = 0; j < CAGD_CODE_ORDERS; j++)
                json_object_set_new(orders, order_keys[j], json_real(w->mean_in_order[j]));
            json_object_set_new(one, "mean",
                                json_pack("{s:I, s:f, s:o}", "points", (json_int_t)w->by_chance, "as_written", w->mean,
                                          "other_orders", orders));
        }
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

static int answer(const struct arguments *a, const struct cagd_code_harness *h, json_t *list,
                  struct certifying *certificates, int *expected)
{
    char message[600], compiler[4200];
    find_compiler(sizeof compiler, compiler);
    also_forget(cagd_code_build_forget);
    struct cagd_code_program *p = cagd_code_build(h, a->asked.path, compiler, sizeof message, message);
    if (p == NULL) {
        refuse_line("%s: line %d: %s: %s", name_of_input(a->asked.path), h->line, h->name, message);
        return EXIT_USAGE;
    }
    struct cagd_code_verdict *v = cagd_code_decide(p, h, a->points > 0 ? a->points : h->points, a->rounding);
    *expected += is_expected(v);
    if (v->word == CAGD_CODE_DIFFERS && !h->notes_stores) {
        struct cagd_code_harness noting = *h;
        noting.notes_stores = 1;
        struct cagd_code_program *again = cagd_code_build(&noting, a->asked.path, compiler, sizeof message, message);
        if (again != NULL)
            cagd_code_look_apart(again, h, v);
        cagd_code_unload(again);
    }
    if (list != NULL)
        json_array_append_new(list, verdict_json(h, v));
    if (!a->asked.json)
        print_verdict(h, v);
    int bad = a->certificates != NULL && certify_block(certificates, p, h, v) != 0;
    cagd_code_verdict_free(v);
    cagd_code_unload(p);
    return bad ? EXIT_INTERNAL : EXIT_AS_EXPECTED;
}

/* The inputs at which a block fails, what came out there, and the cause, in one line.  The caller frees it. */
static char *line_of_failure(json_t *row)
{
    json_t *point = json_object_get(row, "point"), *results = json_object_get(row, "results");
    const char *because = json_string_value(json_object_get(row, "because")), *name, *between = "";
    json_t *values, *one;
    size_t room, k;
    char *text = NULL;
    FILE *out = text_open(&text, &room);
    json_object_foreach(point, name, values)
    {
        fprintf(out, "%s%s = ", between, name);
        json_array_foreach(values, k, one) fprintf(out, "%s%s", k > 0 ? ", " : "", json_string_value(one));
        between = "; ";
    }
    json_array_foreach(results, k, one)
    {
        const char *answer = json_string_value(json_object_get(one, "answer"));
        if (answer == NULL || strcmp(answer, "different") != 0)
            continue;
        fprintf(out, "%s%s = %s, expected %s", between, json_string_value(json_object_get(one, "name")),
                json_string_value(json_object_get(one, "value")), json_string_value(json_object_get(one, "expected")));
        between = "; ";
    }
    if (because != NULL)
        fprintf(out, "%s%s", between, because);
    text_close(out, &text);
    return text;
}

/* The verdicts as JUnit XML: a case for each block. */
static int write_cases(const char *path, const json_t *list)
{
    struct junit *j = junit_new();
    size_t k;
    json_t *row;
    json_array_foreach(list, k, row)
    {
        const char *word = json_string_value(json_object_get(row, "verdict"));
        int failed = strcmp(word, "differs") == 0 || strcmp(word, "undecided") == 0;
        char *text = failed ? line_of_failure(row) : NULL, failure[64];
        snprintf(failure, sizeof failure, "%s, expected otherwise", word);
        junit_add(j, "exactly", json_string_value(json_object_get(row, "name")), 0, failed ? failure : NULL, text);
        free(text);
    }
    return junit_write(j, "cagd exactly", path);
}

/* The sources that the blocks name are read: nothing is written over them. */
static int spare_sources(const struct arguments *a, const struct cagd_code_harness *all)
{
    const char *slash = strrchr(a->asked.path, '/');
    int folder = slash != NULL ? (int)(slash + 1 - a->asked.path) : 0;
    for (const struct cagd_code_harness *h = all; h != NULL; h = h->next)
        for (int k = 0; k < h->source.count; k++) {
            const char *name = h->source.text[k];
            char path[4200];
            snprintf(path, sizeof path, "%.*s%s", name[0] == '/' ? 0 : folder, a->asked.path, name);
            if (output_spare(path) != EXIT_AS_EXPECTED)
                return EXIT_USAGE;
        }
    return EXIT_AS_EXPECTED;
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
        snprintf(wrong.place, sizeof wrong.place, "line %d", error.line > 0 ? error.line : 1);
        snprintf(wrong.cause, sizeof wrong.cause, "%s", error.cause);
        report_input_error(a.asked.path, &wrong);
        return EXIT_USAGE;
    }
    json_t *list = json_array();
    int answered = 0, expected = 0, code = spare_sources(&a, all);
    struct certifying certificates;
    if (code == EXIT_AS_EXPECTED && a.certificates != NULL &&
        certify_begin(&certificates, a.certificates, "exactly") != 0)
        code = EXIT_INTERNAL;
    for (const struct cagd_code_harness *h = all; h != NULL && code == EXIT_AS_EXPECTED; h = h->next) {
        if (a.only != NULL && strcmp(a.only, h->name) != 0)
            continue;
        if (answered++ > 0 && !a.asked.json)
            puts("");
        code = answer(&a, h, list, &certificates, &expected);
    }
    if (code == EXIT_AS_EXPECTED && answered == 0) {
        refuse_line("%s: no block is named '%s'", name_of_input(a.asked.path), a.only);
        code = EXIT_USAGE;
    }
    if (code == EXIT_AS_EXPECTED && a.certificates != NULL && certify_end(&certificates) != 0)
        code = EXIT_INTERNAL;
    if (code == EXIT_AS_EXPECTED && a.junit != NULL && write_cases(a.junit, list) != 0)
        code = EXIT_INTERNAL;
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
    {"certificates", 'c', "DIR", 0, "Write what is proved as certificates that recheck.py takes", 0},
    {"junit", 'u', "FILE", 0, "Write the verdicts as JUnit XML", 0},
    {0}};

const struct command command_exactly = {
    .name = "exactly",
    .summary = "code in C or C++, executed in exact arithmetic and compared with what it should compute",
    .example = "  cagd exactly harness.md          your own C, run exactly and on variables\n",
    .usage = "HARNESS.md",
    .text =
        "Runs the C or C++ that the blocks of HARNESS.md name in exact arithmetic, and compares what it computes with "
        "what is expected: other code, a formula as 'cagd check' reads it, or a kernel of this project. No letter of the code is changed: every operation on floating-point numbers is made one on "
        "rationals, or on rational functions of the inputs. Equal there is equal for all inputs that take the same way "
        "through the code; the comparisons that the code made are told as conditions.\n\n"
        "The code is compiled and run, in a process with bounds on memory and time but with your rights.\n\n"
        "Examples:\n"
        "  cagd exactly casteljau.md\n"
        "  cagd exactly casteljau.md --rounding\n"
        "  cagd exactly casteljau.md --certificates build/certificates\n"
        "  cagd exactly casteljau.md --only casteljau_is_bernstein --json\n",
    .arguments = FILE_NAME,
    .file = "blocks that say what is asked",
    .shared = TAKES_JSON,
    .options = options,
    .parse = parse,
    .run = run,
};
