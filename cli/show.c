/* show.c -- cagd show: one statement or one claim as a page. */
#include "cli/commands.h"
#include "cli/names.h"
#include "cli/page.h"
#include "cli/progress.h"
#include "cli/refuse.h"
#include "cli/report.h"
#include "cli/terminal.h"

#include <fnmatch.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct arguments {
    struct asked asked;
    int numbers;
};

static error_t parse(int key, char *arg, struct argp_state *state)
{
    (void)arg;
    struct arguments *arguments = state->input;
    const struct asked *a = &arguments->asked;
    if (key == 'n') {
        arguments->numbers = 1;
        return 0;
    }
    if (key != ARGP_KEY_END)
        return ARGP_ERR_UNKNOWN;
    if (a->patterns.count == 0)
        refuse_call(state->name, "which id? for example wang-ch3:thm-3.3.2");
    if (a->patterns.count > 1 && a->json)
        refuse_call(state->name, "--json shows one id at a time, not also '%s'", a->patterns.at[1]);
    return 0;
}

/* What an id names: a statement; or a claim, with or without its chapter; or the table whose entries are the statements
 * ID-row-ROW-COLUMN.  At most one of them is not NULL. */
struct entry {
    const statement *statement;
    const claim *claim;
    const char *table;
};

static int is_of_table(const statement *s, const char *id)
{
    size_t n = strlen(id);
    return n > 0 && table_length(s->id) == n && strncmp(s->id, id, n) == 0;
}

static struct entry entry_of(const cagd_register *r, const char *id)
{
    for (const statement *s = r->statements; s->id != NULL; s++)
        if (strcmp(s->id, id) == 0)
            return (struct entry){.statement = s};
    for (const statement *s = r->statements; s->id != NULL; s++)
        if (is_of_table(s, id))
            return (struct entry){.table = id};
    const char *bare = strchr(id, '.') != NULL && strchr(id, ':') == NULL ? strchr(id, '.') + 1 : id;
    for (const claim *c = r->claims; c->name != NULL; c++)
        if (strcmp(c->name, bare) == 0)
            return (struct entry){.claim = c};
    return (struct entry){0};
}

static int is_nothing(struct entry e) { return e.statement == NULL && e.claim == NULL && e.table == NULL; }

/* The statements of a table, in the order of the register.  The caller frees the list. */
static const statement **rows_of(const cagd_register *r, const char *table, int *count)
{
    *count = 0;
    for (const statement *s = r->statements; s->id != NULL; s++)
        *count += is_of_table(s, table);
    const statement **list = calloc((size_t)*count + 1, sizeof *list);
    if (list == NULL)
        abort();
    int k = 0;
    for (const statement *s = r->statements; s->id != NULL; s++)
        if (is_of_table(s, table))
            list[k++] = s;
    return list;
}

/* The claims that an entry names, in the order of the register. */
static const claim **claims_of_entry(const cagd_register *r, struct entry e, int *count)
{
    if (e.statement != NULL)
        return claims_of(r, &e.statement, 1, count);
    if (e.table != NULL) {
        int rows;
        const statement **list = rows_of(r, e.table, &rows);
        const claim **claims = claims_of(r, list, rows, count);
        free(list);
        return claims;
    }
    const claim **one = calloc(1, sizeof *one);
    if (one == NULL)
        abort();
    one[0] = e.claim;
    *count = 1;
    return one;
}

/* A printed table on one page. */
static int show_table(const cagd_register *reg, const char *table, const claim_result *results, int count, int json)
{
    int rows, good = 1;
    const statement **list = rows_of(reg, table, &rows);
    statement_result *derived = calloc((size_t)rows, sizeof *derived);
    if (derived == NULL)
        abort();
    json_t *entries = json_array();
    for (int k = 0; k < rows; k++) {
        derived[k] = derive(list[k], results, count);
        good &= derived[k].as_expected;
        if (json)
            json_array_append_new(entries, statement_json(&derived[k], results, count));
    }
    if (json)
        print_json(json_pack("{s:s, s:s, s:O}", "schema", "cagd-table-1", "table", table, "statements", entries));
    else
        print_table(reg, table, derived, rows);
    json_decref(entries);
    for (int k = 0; k < rows; k++)
        free_statement_result(&derived[k]);
    free(derived), free(list);
    return good;
}

/* One page, from results among which those of its claims are.  Returns whether it is as expected. */
static int show_entry(const cagd_register *reg, struct entry e, const claim_result *all, int judged,
                      const struct arguments *how)
{
    int count;
    const claim **list = claims_of_entry(reg, e, &count);
    claim_result *results = calloc((size_t)count + 1, sizeof *results); /* a definition may have no claim */
    if (results == NULL)
        abort();
    for (int k = 0; k < count; k++)
        results[k] = *result_of(list[k]->name, all, judged);
    int good = results[0].as_expected;
    if (e.table != NULL) {
        good = show_table(reg, e.table, results, count, how->asked.json);
    } else if (e.statement != NULL) {
        statement_result r = derive(e.statement, results, count);
        good = r.as_expected;
        if (how->asked.json)
            print_json(
                json_pack("{s:s, s:o}", "schema", "cagd-statement-1", "statement", statement_json(&r, results, count)));
        else
            print_statement(reg, &r, results, count, how->numbers);
        free_statement_result(&r);
    } else if (how->asked.json) {
        print_json(json_pack("{s:s, s:o}", "schema", "cagd-claim-1", "claim", claim_json(&results[0])));
    } else {
        print_claim(reg, &results[0]);
    }
    free(results);
    free(list);
    return good;
}

/* What is to be shown, in order. */
struct entries {
    struct entry *at;
    int count;
};

static void add(struct entries *list, struct entry e)
{
    list->at = realloc(list->at, (size_t)(list->count + 1) * sizeof *list->at);
    if (list->at == NULL)
        abort();
    list->at[list->count++] = e;
}

/* The statements whose ids match, with or without their source, and the claims whose names do. */
static void add_matching(const cagd_register *r, const char *glob, struct entries *list)
{
    for (const statement *s = r->statements; s->id != NULL; s++)
        if (id_matches(glob, s->id))
            add(list, (struct entry){.statement = s});
    for (const claim *c = r->claims; c->name != NULL; c++) {
        char full[256];
        snprintf(full, sizeof full, "%s.%s", c->chapter, c->name);
        if (fnmatch(glob, c->name, 0) == 0 || fnmatch(glob, full, 0) == 0)
            add(list, (struct entry){.claim = c});
    }
}

/* What the texts name: ids, globs, and names that are spelled otherwise.  0, or -1 and a line on stderr. */
static int find_entries(const cagd_register *r, const struct asked *a, struct entries *list)
{
    for (int k = 0; k < a->patterns.count; k++) {
        int before = list->count;
        const char *text = a->patterns.at[k];
        struct entry e = entry_of(r, text);
        if (!is_nothing(e))
            add(list, e);
        else if (is_glob(text))
            add_matching(r, text, list);
        if (list->count > before)
            continue;
        const char *meant = name_meant_by(r, text, STATEMENTS);
        if (meant == NULL)
            return -1;
        add(list, entry_of(r, meant));
    }
    if (a->json && list->count > 1) {
        refuse_line("--json shows one id at a time, and '%s' matches %d", a->patterns.at[0], list->count);
        return -1;
    }
    return 0;
}

static int run(const struct call *call)
{
    struct arguments arguments = {0};
    parse_arguments(call, &arguments.asked);
    const struct asked a = arguments.asked;
    int every = 0, judged = 0, good = 1;
    const cagd_register *r = call->reg;
    struct entries entries = {0};
    if (find_entries(r, &a, &entries) != 0) {
        free(entries.at);
        return EXIT_USAGE;
    }
    while (r->claims[every].name != NULL)
        every++;
    char *wanted = calloc((size_t)every + 1, 1);
    const claim **list = calloc((size_t)every + 1, sizeof *list);
    if (wanted == NULL || list == NULL)
        abort();
    for (int k = 0; k < entries.count; k++) {
        int count;
        const claim **its = claims_of_entry(r, entries.at[k], &count);
        for (int m = 0; m < count; m++)
            wanted[its[m] - r->claims] = 1;
        free(its);
    }
    for (int m = 0; m < every; m++)
        if (wanted[m])
            list[judged++] = &r->claims[m];
    claim_result *results = judge_with_progress(list, judged, a.jobs, 0);
    for (int k = 0; k < entries.count; k++) {
        if (k > 0)
            puts("\n");
        good &= show_entry(r, entries.at[k], results, judged, &arguments);
    }
    free_results(results, judged);
    free(wanted), free(list), free(entries.at);
    return good ? EXIT_AS_EXPECTED : EXIT_NOT_AS_EXPECTED;
}

static const struct argp_option options[] = {{"numbers", 'n', 0, 0, "Also what each claim did in every number type", 0},
                                             {0}};

const struct command command_show = {
    .name = "show",
    .summary = "one claim or ledger entry in full, with its counterexample",
    .example = "  cagd show wang-ch3:thm-3.3.2     a statement, its verdict and why\n",
    .usage = "ID...",
    .text = "Shows statements of a source, or claims, in full: a page each.\n\n"
            "Examples:\n"
            "  cagd show wang-ch3:thm-3.3.2\n"
            "  cagd show --numbers wang-ch3:3.2.8\n"
            "  cagd show elevation_keeps_rational_curve\n"
            "  cagd show thm-3.3.2                    the end of an id, where only one ends so\n"
            "  cagd show 定理3.3.2                    as the book calls it\n"
            "  cagd show 'thm-3.2.*'                  one page after another\n"
            "  cagd show slides-ch4:table-bezier      a printed table, all entries on one page\n",
    .arguments = CLAIM_NAMES,
    .shared = TAKES_JSON | TAKES_JOBS,
    .options = options,
    .parse = parse,
    .run = run,
};
