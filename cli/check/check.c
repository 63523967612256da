/* check.c -- cagd check: decides the formulas of a file. */
#include "exact/expression/check.h"
#include "chapters/judge/memory_text.h"
#include "cli/check/certificate.h"
#include "cli/check/counterexample.h"
#include "cli/check/sheet.h"
#include "cli/check/verdict.h"
#include "cli/commands.h"
#include "cli/input.h"
#include "cli/junit.h"
#include "cli/output.h"
#include "cli/refuse.h"
#include "cli/report.h"
#include "core/clock.h"
#include "exact/words.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>


static int is_as_expected(const struct formula *s, const cagd_finding *f)
{
    return s->expected == EXPECT_NOTHING ? f->answer == CAGD_HOLDS : (int)s->expected == (int)f->answer;
}

/* Where what was found goes: onto pages, or into a list of JSON; and into a file of JUnit, or NULL. */
struct report {
    json_t *list;
    struct junit *junit;
    const char *path;                /* of the file of formulas */
    struct certifying *certificates; /* or NULL */
    int certified, *code;
    svg *picture; /* or NULL */
    int panels;   /* in it */
};

/* "t = 1/10; b = -243/5000 < 0", or why nothing was decided: from the entry of the list. */
static char *text_of_failure(const json_t *entry)
{
    const json_t *example = json_object_get(entry, "counterexample"), *value;
    const char *reason = json_string_value(json_object_get(entry, "reason"));
    char *text = NULL;
    size_t room, k;
    FILE *out = text_open(&text, &room);
    if (reason != NULL)
        fputs(reason, out);
    json_array_foreach(json_object_get(example, "values"), k, value)
        fprintf(out, "%s%s = %s", k > 0 ? "; " : "", json_string_value(json_object_get(value, "name")),
                json_string_value(json_object_get(value, "value")));
    const char *order = json_string_value(json_object_get(example, "left_is")); /* where a number is a root */
    if (order != NULL)
        fprintf(out, "; the left side is %s the right one", order);
    else if (json_is_string(json_object_get(example, "left")))
        fprintf(out, "; left = %s; right = %s", json_string_value(json_object_get(example, "left")),
                json_string_value(json_object_get(example, "right")));
    else if (json_is_object(example)) /* no two sides: "there is", "for all" */
        fprintf(out, "%sit is false", json_array_size(json_object_get(example, "values")) > 0 ? "; " : "");
    text_close(out, &text);
    return text;
}

/* Puts the entry of the statement into the list and the file, where there are any; it is given away. */
static void put_entry(const struct report *to, json_t *entry, const char *name, double start, const char *failure)
{
    if (to->junit != NULL) {
        char *text = text_of_failure(entry);
        junit_add(to->junit, to->path, name, cagd_seconds() - start, failure, text);
        free(text);
    }
    if (to->list != NULL)
        json_array_append(to->list, entry);
    json_decref(entry);
}

/* One statement; whether it is as expected. */
static int check_one(const struct document *d, const struct formula *s, struct report *to)
{
    cagd_finding found;
    double start = cagd_seconds();
    cagd_check(&s->scope, s->tree, s->seconds, &found);
    if (found.answer == CAGD_HOLDS)
        cagd_check_changes(&s->scope, s->tree, s->seconds / 10, &found);
    int good = is_as_expected(s, &found);
    char failure[64];
    snprintf(failure, sizeof failure, "%s, expected %s", verdict_of(&found),
             expected_name[s->expected == EXPECT_NOTHING ? EXPECT_HOLDS : s->expected]);
    json_t *entry = finding_json(d, s, &found);
    if (to->list == NULL)
        print_finding_page(d, s, &found);
    if (to->certificates != NULL && *to->code == EXIT_AS_EXPECTED) { /* where one could not be written, no others are */
        const char *name;
        if (certify_formula(to->certificates, d, s, &found, &name) != 0)
            *to->code = EXIT_INTERNAL;
        to->certified += name != NULL;
        json_object_set_new(entry, "certificate", name != NULL ? json_string(name) : json_null());
    }
    put_entry(to, entry, s->name, start, good ? NULL : failure);
    if (to->picture != NULL && found.answer == CAGD_FAILS && svg_panels_left(to->picture) > 0)
        to->panels += draw_counterexample(to->picture, s, &found, to->panels);
    return good;
}

/* One that asks for values: it is as expected when they were found. */
static int find_one(const struct document *d, const struct formula *s, struct report *to)
{
    cagd_found *found = region_bytes(sizeof *found);
    double start = cagd_seconds();
    if (found == NULL)
        return 0;
    cagd_find(&s->scope, s->tree, s->find, 1, s->seconds, found);
    json_t *entry = found_json(s, found);
    if (to->list == NULL)
        print_found_page(d, s, found);
    if (to->certificates != NULL && *to->code == EXIT_AS_EXPECTED) {
        const char *name;
        if (certify_values(to->certificates, s, found, &name) != 0)
            *to->code = EXIT_INTERNAL;
        to->certified += name != NULL;
        json_object_set_new(entry, "certificate", name != NULL ? json_string(name) : json_null());
    }
    put_entry(to, entry, s->name, start, found->known ? NULL : "undecided, expected its values");
    return found->known;
}

struct arguments {
    struct asked asked;
    int basis;
    const char *picture, *junit, *certificates;
};

static error_t parse(int key, char *arg, struct argp_state *state)
{
    struct arguments *a = state->input;
    switch (key) {
    case 'b':
        a->basis = 1;
        return 0;
    case 's':
        a->picture = arg;
        return 0;
    case 'u':
        a->junit = arg;
        return 0;
    case 'c':
        a->certificates = arg;
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

/* The sheets of the bases; whether all of it was decided. */
static int check_sheets(const struct document *d, int behind, const struct report *to)
{
    json_t *list = to->list;
    int good = 1;
    for (int k = 0; k < d->sheets; k++) {
        region_mark mark = region_open();
        if (list == NULL && (behind || k > 0))
            puts("\n");
        double start = cagd_seconds();
        int all = check_sheet(d, &d->sheet[k], list, to->picture);
        if (to->junit != NULL)
            junit_add(to->junit, to->path, d->sheet[k].name, cagd_seconds() - start,
                      all ? NULL : "undecided, expected an answer to everything", "");
        good &= all;
        region_drop(mark);
    }
    return good;
}

/* The picture goes to its file, and is no more. */
static void write_picture(const char *path, const struct document *d, struct report *to)
{
    const char *text = NULL;
    if (to->panels > 0)
        draw_legend_of_counterexamples(to->picture);
    if (to->panels == 0 && d->sheets == 0)
        refuse_line("%s: no counterexample has a name over which it could be drawn", name_of_input(d->path));
    else if ((text = svg_text(to->picture)) == NULL)
        refuse_line("the picture cannot be drawn: %s", svg_failed(to->picture));
    if ((to->panels > 0 || d->sheets > 0) && (text == NULL || write_text_file(path, text) != 0))
        *to->code = EXIT_INTERNAL;
    svg_free(to->picture);
}

/* What nobody asked for and could not be read: a list on the page, or what comes out for JSON. */
static json_t *tell_left_out(const struct document *d, int as_json)
{
    json_t *list = as_json ? json_array() : NULL;
    if (!as_json && d->left_outs > 0)
        printf("\n\nLeft out, for they could not be read: %d labelled formula%s\n", d->left_outs,
               d->left_outs == 1 ? "" : "s");
    for (int k = 0; k < d->left_outs; k++) {
        const struct left_out *l = &d->left_out[k];
        if (as_json)
            json_array_append_new(list, json_pack("{s:s, s:i, s:i, s:s}", "name", l->name, "line", l->line, "column",
                                                  l->column, "reason", l->message));
        else
            printf("    %s  (%s:%d)\n", l->name, name_of_input(d->path), l->line);
    }
    if (!as_json && d->unlabelled > 0)
        printf("\n\nNot read, for they have no label: %d displayed formula%s\n", d->unlabelled,
               d->unlabelled == 1 ? "" : "s");
    return list;
}

static int check(const cagd_register *reg, const struct arguments *a)
{
    struct document d;
    int good = 1, code = EXIT_AS_EXPECTED;
    if (read_document(reg, a->asked.path, &d) != 0)
        return EXIT_USAGE;
    if (a->basis && d.sheets == 0) {
        refuse_line("%s: has no block :::{basis} NAME", name_of_input(a->asked.path));
        return EXIT_USAGE;
    }
    json_t *list = a->asked.json ? json_array() : NULL, *sheets = a->asked.json ? json_array() : NULL;
    struct certifying certificates;
    if (a->certificates != NULL && certify_begin(&certificates, a->certificates, "check") != 0)
        return EXIT_INTERNAL;
    struct report to = {list,
                        a->junit != NULL ? junit_new() : NULL,
                        a->asked.path,
                        a->certificates != NULL ? &certificates : NULL,
                        0,
                        &code,
                        NULL,
                        0};
    if (a->picture != NULL && d.sheets > 0)
        to.picture = svg_new("basis", "The functions of a basis", "The functions for some values of the parameter.");
    else if (a->picture != NULL)
        to.picture = svg_new("counterexamples", "Counterexamples",
                             "Both sides of each statement that fails, and a place where they are not as printed.");
    int count = a->basis ? 0 : d.count;
    for (int k = 0; k < count; k++) {
        const struct formula *s = &d.formula[k];
        region_mark mark = region_open();
        if (list == NULL && k > 0)
            puts("\n");
        good &= (s->find != NULL ? find_one : check_one)(&d, s, &to);
        region_drop(mark);
    }
    to.list = sheets;
    int uncertified = code;
    good &= check_sheets(&d, count > 0, &to);
    if (a->picture != NULL)
        write_picture(a->picture, &d, &to);
    good &= d.left_outs == 0;
    json_t *left_out = tell_left_out(&d, a->asked.json);
    if (a->certificates != NULL && uncertified == EXIT_AS_EXPECTED && certify_end(&certificates) != 0)
        uncertified = code = EXIT_INTERNAL;
    if (a->certificates != NULL && uncertified == EXIT_AS_EXPECTED && !a->asked.json)
        printf("\n\nCertificates of %d of %d statement%s in %s\n", to.certified, count, count == 1 ? "" : "s",
               a->certificates);
    if (to.junit != NULL && junit_write(to.junit, "cagd check", a->junit) != 0)
        code = EXIT_INTERNAL;
    if (a->asked.json)
        print_json(json_pack("{s:s, s:s, s:b, s:o, s:o, s:o, s:i}", "schema", "cagd-check-1", "file", a->asked.path,
                             "as_expected", good, "statements", list, "bases", sheets, "left_out", left_out,
                             "without_label", d.unlabelled));
    return code != EXIT_AS_EXPECTED ? code : good ? EXIT_AS_EXPECTED : EXIT_NOT_AS_EXPECTED;
}

static int run(const struct call *call)
{
    struct arguments a = {.basis = 0};
    region_mark mark = region_open();
    parse_arguments(call, &a.asked);
    int code = check(call->reg, &a);
    region_drop(mark);
    cagd_thread_end();
    return code;
}

static const struct topic topics[] = {
    {"FORMULAS",
     "A file of formulas is Markdown. A block :::{let} says what names mean, one line each: a definition such as "
     "B_i^n(t) = \\binom{n}{i} t^i (1-t)^{n-i}, of which there may be several for one name, with numbers among the "
     "indices "
     "or with conditions behind a comma; a variable, \\omega_i \\in \\mathbb{R} or -1 \\le \\lambda < 1; 0/0 = 0; and "
     ":use: bernstein B_i^n(t), a function that every text has. "
     "A "
     "block :::{statement} NAME has :printed:, relations in TeX as they stand in the paper; :for:, ranges of whole "
     "numbers "
     "(n = 1..12), bounds of other names (0 \\le t \\le 1) and conditions (x \\ne y); and, if wanted, :expected: "
     "holds, "
     "fails or undecided, :seconds:, of which there are 10 otherwise, and :find: \\lambda, which asks for which values "
     "of that name the statement holds. A block :::{basis} NAME has :functions: b_i(t), :for: the "
     "ranges of index and argument, :find: the parameter, if there is one, and :at: its values in the picture; it is "
     "answered with "
     "what is asked of every basis: independence, sum 1, signs, symmetry, values at the ends, total positivity, each "
     "with the "
     "exact range of the parameter. A block ends with a line of three colons. A LaTeX source, NAME.tex, has its "
     "labelled formulas taken, with what comments say of them: % cagd: let LINE; for RANGES, find, expected, seconds, "
     "title "
     "as the lines of a statement; statement NAME; definition; skip. In Markdown, :from: paper.tex LABEL stands for "
     ":printed:. "
     "The "
     "file - is standard input."},
    {0}};

static const struct argp_option options[] = {
    {"basis", 'b', 0, 0, "The sheets of the bases alone, without the statements", 0},
    {"svg", 's', "FILE", 0, "Draw the counterexamples, and the functions of the bases", 0},
    {"junit", 'u', "FILE", 0, "Also write the results to FILE as JUnit XML", 0},
    {"certificates", 'c', "DIR", 0, "Write what was found as certificates that recheck.py takes", 0},
    {0}};

const struct command command_check = {
    .name = "check",
    .summary = "the formulas of a file, as printed: proved, refuted, or neither",
    .example = "  cagd check paper.md              formulas of one's own, in TeX\n",
    .usage = "FILE",
    .text = "Decides formulas that are written down as they are printed, in TeX.\n\n"
            "Examples:\n"
            "  cagd check paper.md\n"
            "  cagd check paper.tex             the labelled formulas of a LaTeX source\n"
            "  cagd check --json paper.md\n"
            "  cagd check --basis basis.md      what is asked of a basis, with exact ranges\n"
            "\vA file is a LaTeX source, or Markdown with blocks\n\n"
            "  :::{let}\n"
            "  B_i^n(t) = \\binom{n}{i} t^i (1-t)^{n-i}\n"
            "  :::\n\n"
            "  :::{statement} sum\n"
            "  :printed: \\sum_{i=0}^{n} B_i^n(t) = 1\n"
            "  :for: n = 1..12\n"
            "  :::\n\n"
            "  :::{basis} mine\n"
            "  :functions: b_i(t)\n"
            "  :for: i = 0..3, 0 \\le t \\le 1\n"
            "  :find: \\lambda\n"
            "  :::\n\n"
            "Exit status: 0 every statement holds, or is what it says with :expected:, and all about the "
            "bases is decided; 1 something is not; 2 the file cannot be "
            "read, and then nothing is decided.",
    .arguments = FILE_NAME,
    .file = "formulas",
    .shared = TAKES_JSON,
    .options = options,
    .parse = parse,
    .topics = topics,
    .run = run,
};
