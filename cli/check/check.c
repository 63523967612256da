/* check.c -- cagd check: decides the formulas of a file. */
#include "cli/check/sheet.h"
#include "cli/check/verdict.h"
#include "cli/commands.h"
#include "cli/input.h"
#include "cli/output.h"
#include "cli/report.h"
#include "exact/words.h"

#include <stdio.h>

static int is_as_expected(const struct formula *s, const cagd_finding *f)
{
    return s->expected == EXPECT_NOTHING ? f->answer == CAGD_HOLDS : (int)s->expected == (int)f->answer;
}

/* One statement: its page or its entry of the list, which may be NULL; whether it is as expected. */
static int check_one(const struct document *d, const struct formula *s, json_t *list)
{
    cagd_finding found;
    cagd_check(&s->scope, s->tree, s->seconds, &found);
    if (found.answer == CAGD_HOLDS)
        cagd_check_changes(&s->scope, s->tree, s->seconds / 10, &found);
    if (list != NULL)
        json_array_append_new(list, finding_json(d, s, &found));
    else
        print_finding_page(d, s, &found);
    return is_as_expected(s, &found);
}

/* One that asks for values: it is as expected when they were found. */
static int find_one(const struct document *d, const struct formula *s, json_t *list)
{
    cagd_found *found = region_bytes(sizeof *found);
    if (found == NULL)
        return 0;
    cagd_find(&s->scope, s->tree, s->find, s->seconds, found);
    if (list != NULL)
        json_array_append_new(list, found_json(s, found));
    else
        print_found_page(d, s, found);
    return found->known;
}

struct arguments {
    struct asked asked;
    int basis;
    const char *picture;
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
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

/* The sheets of the bases; whether all of it was decided. */
static int check_sheets(const struct arguments *a, const struct document *d, int behind, json_t *list, int *code)
{
    int good = 1;
    svg *picture = a->picture != NULL
                       ? svg_new("basis", "The functions of a basis", "The functions for some values of the parameter.")
                       : NULL;
    for (int k = 0; k < d->sheets; k++) {
        region_mark mark = region_open();
        if (list == NULL && (behind || k > 0))
            puts("\n");
        good &= check_sheet(d, &d->sheet[k], list, picture);
        region_drop(mark);
    }
    if (picture != NULL) {
        const char *text = svg_text(picture);
        if (text == NULL || write_text_file(a->picture, text) != 0) {
            if (text == NULL)
                fprintf(stderr, "cagd: the picture cannot be drawn: %s\n", svg_failed(picture));
            *code = EXIT_INTERNAL;
        }
        svg_free(picture);
    }
    return good;
}

static int check(const cagd_register *reg, const struct arguments *a)
{
    struct document d;
    int good = 1, code = EXIT_AS_EXPECTED;
    if (read_document(reg, a->asked.path, &d) != 0)
        return EXIT_USAGE;
    if ((a->basis || a->picture != NULL) && d.sheets == 0) {
        fprintf(stderr, "cagd: %s: has no block :::{basis} NAME\n", name_of_input(a->asked.path));
        return EXIT_USAGE;
    }
    json_t *list = a->asked.json ? json_array() : NULL, *sheets = a->asked.json ? json_array() : NULL;
    int count = a->basis ? 0 : d.count;
    for (int k = 0; k < count; k++) {
        const struct formula *s = &d.formula[k];
        region_mark mark = region_open();
        if (list == NULL && k > 0)
            puts("\n");
        good &= (s->find != NULL ? find_one : check_one)(&d, s, list);
        region_drop(mark);
    }
    good &= check_sheets(a, &d, count > 0, sheets, &code);
    if (a->asked.json)
        print_json(json_pack("{s:s, s:s, s:b, s:o, s:o}", "schema", "cagd-check-1", "file", a->asked.path,
                             "as_expected", good, "statements", list, "bases", sheets));
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
     "or with conditions behind a comma; a variable, \\omega_i \\in \\mathbb{R} or -1 \\le \\lambda < 1; and 0/0 = 0. "
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
     "exact range of the parameter. A block ends with a line of three colons. "
     "The "
     "file - is standard input."},
    {0}};

static const struct argp_option options[] = {
    {"basis", 'b', 0, 0, "The sheets of the bases alone, without the statements", 0},
    {"svg", 's', "FILE", 0, "Draw the functions of the bases", 0},
    {0}};

const struct command command_check = {
    .name = "check",
    .summary = "the formulas of a file, as printed: proved, refuted, or neither",
    .example = "  cagd check paper.md              formulas of one's own, in TeX\n",
    .usage = "FILE",
    .text = "Decides formulas that are written down as they are printed, in TeX.\n\n"
            "Examples:\n"
            "  cagd check paper.md\n"
            "  cagd check --json paper.md\n"
            "  cagd check --basis basis.md      all that is asked of a basis, with exact ranges of its parameter\n"
            "\vA file is Markdown, with blocks\n\n"
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
