/* ledger.c -- cagd ledger: every statement of the sources with its verdict. */
#include "chapters/judge/memory_text.h"
#include "cli/commands.h"
#include "cli/layout.h"
#include "cli/output.h"
#include "cli/progress.h"
#include "cli/report.h"
#include "cli/terminal.h"
#include "cli/tex.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct arguments {
    struct asked asked;
    int summary, striking;
};

static error_t parse(int key, char *arg, struct argp_state *state)
{
    struct arguments *a = state->input;
    switch (key) {
    case 's':
        a->summary = 1;
        break;
    case 'k':
        a->striking = whole_number(state, "--striking", arg, 1, 100);
        break;
    case ARGP_KEY_END:
        if (a->asked.json + a->summary + (a->striking > 0) > 1)
            refuse_call(state->name, "one form at a time: --json, --summary or --striking?");
        break;
    default:
        return ARGP_ERR_UNKNOWN;
    }
    return 0;
}

static enum style style_of(verdict v)
{
    static const enum style by[] = {GOOD, WARN, BAD, WARN, BAD, DIM};
    return by[v];
}

static void print_rows(FILE *out, const statement_result *list, int count)
{
    int width = 0;
    for (int k = 0; k < count; k++)
        if ((int)strlen(list[k].statement->id) > width)
            width = (int)strlen(list[k].statement->id);
    for (int k = 0; k < count; k++) {
        const statement_result *r = &list[k];
        put_padded(out, r->statement->id, width + 2);
        fputs(style(out, style_of(r->verdict)), out);
        put_padded(out, verdict_name[r->verdict], 12);
        fputs(style(out, PLAIN), out);
        put_padded(out, r->verdict == VERDICT_FAILS ? r->statement->class : evidence_name[r->as_printed.evidence], 20);
        fprintf(out, "%s\n", r->statement->title);
    }
}

/* Counts of verdicts by source key. */
struct tally {
    char source[32];
    int verdict[VERDICTS];
    int total;
};
/* Into an array that has an entry for each statement, and so for each source. */
static int tally_statements(const statement_result *list, int count, struct tally tally[])
{
    int sources = 0;
    for (int k = 0; k < count; k++) {
        char key[32];
        snprintf(key, sizeof key, "%.*s", (int)strcspn(list[k].statement->id, ":"), list[k].statement->id);
        int s = 0;
        while (s < sources && strcmp(tally[s].source, key) != 0)
            s++;
        if (s == sources)
            memcpy(tally[sources++].source, key, sizeof key);
        tally[s].verdict[list[k].verdict]++;
        tally[s].total++;
    }
    return sources;
}

static void print_tally(FILE *out, const statement_result *list, int count)
{
    struct tally *t = calloc((size_t)count + 1, sizeof *t);
    if (t == NULL)
        abort();
    int sources = tally_statements(list, count, t);
    fprintf(out, "%-18s %10s %6s %12s %6s %10s %5s %11s\n", "source", "statements", "hold", "conditional", "fail",
            "undecided", "open", "definitions");
    for (int k = 0; k < sources; k++)
        fprintf(out, "%-18s %10d %6d %12d %6d %10d %5d %11d\n", t[k].source, t[k].total, t[k].verdict[VERDICT_HOLDS],
                t[k].verdict[VERDICT_CONDITIONAL], t[k].verdict[VERDICT_FAILS], t[k].verdict[VERDICT_UNDECIDED],
                t[k].verdict[VERDICT_OPEN], t[k].verdict[VERDICT_DEFINITION]);
    free(t);
}

static int is_among(const char *const ids[], const statement *s)
{
    for (int k = 0; ids != NULL && ids[k] != NULL; k++)
        if (strcmp(ids[k], s->id) == 0)
            return 1;
    return 0;
}

/* Whether the formula of the statement is read from its print as well. */
static int is_read_from_print(const cagd_register *reg, const statement *s) { return is_among(reg->printed, s); }

static void print_read(FILE *out, const cagd_register *reg, const statement_result *list, int count)
{
    int read = 0, every = 0;
    if (reg->printed == NULL)
        return;
    for (int k = 0; k < count; k++) {
        read += is_read_from_print(reg, list[k].statement);
        every += is_among(reg->for_every, list[k].statement);
    }
    fprintf(out,
            "\n%d of %d statements are read from their print as well, chapters/*/print*.md, which cagd check decides\n",
            read, count);
    if (every > 0)
        fprintf(out, "of these a sum for every n, by creative telescoping: %d\n", every);
}

/* "R = (0,0) (1,2) (2,0); w = 1 0 1 gives R''(0) = (4,0)": the data of a claim and what comes out of them. */
static void put_data(FILE *out, const claim *c)
{
    static const enum data_place places[] = {IN_DATA, IN_RESULT};
    for (int p = 0; p < 2; p++) {
        int first = 1;
        for (const datum *d = c->data; d != NULL && d->name != NULL; d++)
            if (d->place == places[p]) {
                fprintf(out, "%s%s = %s", !first ? "; " : p == 0 ? "" : " gives ", d->name, d->text);
                first = 0;
            }
    }
}

/* Striking statements carry a rank, which two may share: the id and what is false, then the counterexample in numbers. */
static void print_striking(FILE *out, const statement_result *list, int count, int wanted)
{
    int last = 0, shown = 0;
    for (int k = 0; k < count; k++)
        last = list[k].statement->striking > last ? list[k].statement->striking : last;
    for (int rank = 1; rank <= last; rank++)
        for (int k = 0; k < count; k++)
            if (list[k].statement->striking == rank && list[k].verdict == VERDICT_FAILS && shown < wanted) {
                const claim *c = list[k].refuted_by->claim;
                char *then = tex_to_text(c->then, 1), *numbers = NULL;
                size_t size;
                FILE *text = text_open(&numbers, &size);
                put_data(text, c);
                text_close(text, &numbers);
                fprintf(out, "  %s  %s\n", list[k].statement->id, list[k].statement->title);
                put_paragraph(out, numbers, 6, page_width(92));
                put_paragraph(out, then, 6, page_width(92));
                free(then), free(numbers);
                shown++;
            }
}

/* The verdicts of the statements; the caller frees. */
static statement_result *derive_all(const statement *const list[], int count, const claim_result *results, int claims)
{
    statement_result *derived = calloc((size_t)count + 1, sizeof *derived);
    if (derived == NULL)
        abort();
    for (int k = 0; k < count; k++)
        derived[k] = derive(list[k], results, claims);
    return derived;
}

static void free_all(statement_result *list, int count)
{
    for (int k = 0; k < count; k++)
        free_statement_result(&list[k]);
    free(list);
}

static json_t *ledger_json(const cagd_register *reg, const statement_result *list, int statements,
                           const claim_result *results, int claims)
{
    json_t *rows = json_array();
    for (int k = 0; k < statements; k++) {
        json_t *row = statement_json(&list[k], results, claims);
        if (reg->printed != NULL)
            json_object_set_new(row, "read_from_print", json_boolean(is_read_from_print(reg, list[k].statement)));
        json_array_append_new(rows, row);
    }
    return json_pack("{s:s, s:o}", "schema", "cagd-ledger-1", "statements", rows);
}

static const char *const report_names[] = {"ledger.txt", "summary.txt", "striking.txt", "ledger.json"};
enum { REPORTS = sizeof report_names / sizeof *report_names };

int promise_report(const char *folder)
{
    int code = EXIT_AS_EXPECTED;
    for (int k = 0; k < REPORTS && code == EXIT_AS_EXPECTED; k++) {
        char path[4096];
        snprintf(path, sizeof path, "%s/%s", folder, report_names[k]);
        code = output_promise("report", path);
    }
    return code;
}

int write_report(const cagd_register *r, const char *folder, const claim_result *results, int claims)
{
    const struct patterns everything = {0};
    int statements, bad = make_folder(folder) != 0;
    const statement **all = matching_statements(r, &everything, &statements);
    statement_result *list = derive_all(all, statements, results, claims);
    for (int k = 0; k < REPORTS && !bad; k++) {
        char path[4096];
        snprintf(path, sizeof path, "%s/%s", folder, report_names[k]);
        struct output *o = output_open(path);
        if (o == NULL) {
            bad = 1;
            break;
        }
        FILE *out = output_stream(o);
        json_t *document = k == 3 ? ledger_json(r, list, statements, results, claims) : NULL;
        if (k == 0)
            print_rows(out, list, statements);
        else if (k == 1)
            print_tally(out, list, statements);
        else if (k == 2)
            print_striking(out, list, statements, 3);
        else
            json_dumpf(document, out, JSON_INDENT(2));
        json_decref(document);
        bad = output_close(o) != 0;
    }
    int wrong = 0;
    for (int k = 0; k < statements; k++)
        wrong += !list[k].as_expected;
    free_all(list, statements);
    free(all);
    return bad ? -1 : wrong;
}

static int run(const struct call *call)
{
    struct arguments a = {0};
    parse_arguments(call, &a.asked);
    if (!all_match(call->reg, &a.asked.patterns, STATEMENTS))
        return EXIT_USAGE;
    int statements, claims, wrong = 0;
    const statement **list = matching_statements(call->reg, &a.asked.patterns, &statements);
    const claim **needed = claims_of(call->reg, list, statements, &claims);
    claim_result *results = judge_with_progress(needed, claims, a.asked.jobs, 0);
    statement_result *derived = derive_all(list, statements, results, claims);
    for (int k = 0; k < statements; k++)
        wrong += !derived[k].as_expected;
    int code = wrong > 0 ? EXIT_NOT_AS_EXPECTED : EXIT_AS_EXPECTED;
    if (a.asked.json) {
        print_json(ledger_json(call->reg, derived, statements, results, claims));
    } else if (a.striking > 0) {
        print_striking(stdout, derived, statements, a.striking);
    } else {
        if (!a.summary) {
            print_rows(stdout, derived, statements);
            putchar('\n');
        }
        print_tally(stdout, derived, statements);
        print_read(stdout, call->reg, derived, statements);
    }
    free_all(derived, statements);
    free_results(results, claims);
    free(needed);
    free(list);
    return code;
}

static const struct argp_option options[] = {
    {"summary", 's', 0, 0, "Only the counts by source and verdict", 0},
    {"striking", 'k', "N", 0, "Only the N most striking false statements, one a line", 0},
    {0}};

const struct command command_ledger = {
    .name = "ledger",
    .summary = "every statement of the sources with its verdict",
    .example = "  cagd ledger 'wang-ch3:*'         the statements of one source\n",
    .usage = "[PATTERN...]",
    .text = "Prints every statement of the sources with its verdict, decided anew.\n\n"
            "Examples:\n"
            "  cagd ledger --summary\n"
            "  cagd ledger 'wang-ch3:*'\n"
            "  cagd ledger --json\n"
            "\vAll forms of the ledger at once, from a run that decides everything: cagd verify --report DIR.",
    .arguments = CLAIM_NAMES,
    .shared = TAKES_JSON | TAKES_JOBS,
    .options = options,
    .parse = parse,
    .run = run,
};
