/* verify.c -- cagd verify: decides claims, and prints or writes what came out. */
#include "chapters/judge/certificate.h"
#include "cli/commands.h"
#include "cli/manifest.h"
#include "cli/output.h"
#include "cli/progress.h"
#include "cli/report.h"
#include "cli/screen.h"
#include "cli/terminal.h"
#include "cli/tex.h"
#include "exact/number/parallel.h"
#include "exact/number/region.h"
#include "exact/words.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

struct arguments {
    struct asked asked;
    int tap, deep, shard, shards;
    const char *junit, *certificates, *report;
};

static error_t parse(int key, char *arg, struct argp_state *state)
{
    struct arguments *a = state->input;
    switch (key) {
    case 'T':
        a->tap = 1;
        break;
    case 'D':
        a->deep = 1;
        break;
    case 'U':
        a->junit = arg;
        break;
    case 'C':
        a->certificates = arg;
        break;
    case 'R':
        a->report = arg;
        break;
    case 'S': {
        char *slash = strchr(arg, '/');
        if (slash == NULL)
            refuse_call(state->name, "--shard takes K/N, such as 1/4, not '%s'", arg);
        *slash = '\0';
        a->shards = whole_number(state, "--shard K/N: N", slash + 1, 1, 1000);
        a->shard = whole_number(state, "--shard K/N: K", arg, 1, a->shards);
        break;
    }
    case ARGP_KEY_END:
        if (a->report != NULL && (a->asked.patterns.count > 0 || a->shards > 1))
            refuse_call(state->name, "--report is about every statement: it takes no PATTERN and no --shard");
        if (a->asked.json && a->tap)
            refuse_call(state->name, "one format at a time: --json or --tap?");
        break;
    default:
        return ARGP_ERR_UNKNOWN;
    }
    return 0;
}

static void put_exhibits(const exhibit *shown, int count, int indent)
{
    enum { MOST = 300 };
    for (int k = 0; k < count; k++) {
        printf("%*s%s = ", indent, "", shown[k].name);
        put_clipped(stdout, shown[k].value, MOST);
        putchar('\n');
    }
}

/* What a claim shows that is not as expected, a line each: the case and the two sides; and a small instance, if one was found. */
static void put_witness(const claim_result *r)
{
    enum { INDENT = 7 };
    const type_result *b = speaking_type(r);
    if (b != NULL)
        put_exhibits(b->shown, b->exhibits, INDENT);
    if (r->witnesses > 0)
        printf("%*ssmall instance:\n", INDENT, "");
    put_exhibits(r->witness, r->witnesses, INDENT + 2);
}

/* The evidence with what supports it, as in "proved  n = 1 to 6; every value of t w_0 ...". */
static void put_row(const claim_result *r, int name_width)
{
    const char *mark = !r->as_expected ? "!!" : r->claim->kind == COUNTEREXAMPLE ? "✗" : "✓";
    enum style colour = !r->as_expected ? BAD : r->claim->kind == COUNTEREXAMPLE ? WARN : GOOD;
    printf("  %s%s%s ", style(stdout, colour), mark, style(stdout, PLAIN));
    put_padded(stdout, r->claim->name, name_width + 1);
    put_padded(stdout, r->as_expected && r->claim->kind == COUNTEREXAMPLE ? "refutes" : evidence_name[r->evidence], 10);
    char types[8] = "", *at = types;
    for (number_type t = 0; t < NUMBER_TYPES; t++)
        *at++ = r->by[t].ran ? "fqid"[t] : '-';
    *at = '\0';
    printf("%s  ", types);
    if (!r->as_expected) {
        for (number_type t = 0; t < NUMBER_TYPES; t++)
            if (r->by[t].ran)
                printf("%s: %s%s  ", number_type_name[t], outcome_name[r->by[t].outcome],
                       r->by[t].control_caught ? "" : ", its control was not caught");
        const type_result *b = speaking_type(r);
        printf("seed %016llx", b != NULL ? (unsigned long long)b->seed : 0);
    } else {
        char *scope = tex_to_text(r->scope, 1);
        fputs(scope, stdout);
        free(scope);
        if (r->by[DOUBLE_TYPE].ran && r->claim->kind == IDENTITY)
            printf("%s  [double: %.2g of the bound]%s", style(stdout, DIM), r->by[DOUBLE_TYPE].worst,
                   style(stdout, PLAIN));
    }
    putchar('\n');
    if (!r->as_expected)
        put_witness(r);
}

static void print_table(const claim_result *results, int count)
{
    int width = 0;
    for (int k = 0; k < count; k++)
        if ((int)strlen(results[k].claim->name) > width)
            width = (int)strlen(results[k].claim->name);
    const char *file = "";
    for (int k = 0; k < count; k++) {
        if (strcmp(file, results[k].claim->file) != 0) {
            file = results[k].claim->file;
            const char *base = strrchr(file, '/');
            printf("%s%s%s: %.*s%s\n", k > 0 ? "\n" : "", style(stdout, BOLD), results[k].claim->chapter,
                   (int)strcspn(base + 1, "."), base + 1, style(stdout, PLAIN));
        }
        put_row(&results[k], width);
    }
    int by_evidence[PROVED + 1] = {0}, counterexamples = 0, wrong = 0, compared = 0, controls = 0, runs = 0;
    for (int k = 0; k < count; k++) {
        const claim_result *r = &results[k];
        if (r->as_expected && r->claim->kind == COUNTEREXAMPLE)
            counterexamples++;
        else if (r->as_expected)
            by_evidence[r->evidence]++;
        else
            wrong++;
        for (number_type t = 0; t < NUMBER_TYPES; t++) {
            compared += r->by[t].compared;
            runs += r->by[t].ran;
            controls += r->by[t].ran && r->by[t].control_caught;
        }
    }
    printf("\n%d claims: %d proved, %d decided, %d argued, %d sampled, %d counterexamples, %d not as expected\n", count,
           by_evidence[PROVED], by_evidence[DECIDED], by_evidence[BY_ARGUMENT],
           by_evidence[SAMPLED] + by_evidence[MEASURED] + by_evidence[ENCLOSED], counterexamples, wrong);
    printf("%d comparisons in %d runs; %d of %d controls caught\n", compared, runs, controls, runs);
}

/* A text between double quotes, as YAML and JSON have it. */
static void put_quoted(const char *text)
{
    json_t *string = json_string(text);
    char *quoted = string != NULL ? json_dumps(string, JSON_ENCODE_ANY) : NULL;
    fputs(quoted != NULL ? quoted : "\"\"", stdout);
    free(quoted);
    json_decref(string);
}

static void put_tap_exhibits(const char *key, const exhibit *shown, int count)
{
    if (count > 0)
        printf("  %s:\n", key);
    for (int k = 0; k < count; k++) {
        fputs("    - ", stdout);
        put_quoted(shown[k].name);
        fputs(": ", stdout);
        put_quoted(shown[k].value);
        putchar('\n');
    }
}

/* The block of YAML that the protocol has for what is said of a test that failed. */
static void put_tap_witness(const claim_result *r)
{
    const type_result *b = speaking_type(r);
    if (b == NULL)
        return;
    char *message = not_expected(r);
    fputs("  ---\n  message: ", stdout);
    put_quoted(message);
    printf("\n  seed: \"%016llx\"\n", (unsigned long long)b->seed);
    free(message);
    put_tap_exhibits("data", b->shown, b->exhibits);
    put_tap_exhibits("small_instance", r->witness, r->witnesses);
    puts("  ...");
}

static void print_tap(const claim_result *results, int count)
{
    screen_leaves_lines();
    printf("TAP version 13\n1..%d\n", count);
    for (int k = 0; k < count; k++) {
        const claim_result *r = &results[k];
        printf("%s %d - %s.%s", r->as_expected ? "ok" : "not ok", k + 1, r->claim->chapter, r->claim->name);
        if (r->as_expected) {
            printf(" # %s; %s\n", evidence_name[r->evidence], r->scope);
        } else {
            putchar('\n');
            put_tap_witness(r);
        }
    }
}

/* The certificates of claims that are yet to be written, on several threads. */
struct certificates {
    const char *folder;
    const claim_result *results;
    struct recorded *recorded;
    atomic_int bad;
    int unwritten;
};

static void write_certificate(void *context, int k)
{
    struct certificates *c = context;
    if (c->bad)
        return; /* nobody reads what is not complete */
    char path[4096], *text = certificate_of_claim(&c->results[k], &c->recorded[k].count, c->recorded[k].cases);
    snprintf(path, sizeof path, "%s/claims/%s.json", c->folder, c->results[k].claim->name);
    digest_of_text(text, c->recorded[k].digest);
    if (write_text_in_turn(path, text, &c->unwritten) != 0)
        c->bad = 1;
    free(text);
}

/* DIR/claims/NAME.json for every claim, DIR/KEY/PLACE.json for every statement that they decide, and DIR/manifest.json, which says
 * what they certify. */
static int write_certificates(const cagd_register *r, const char *folder, const claim_result *results, int count,
                              int jobs)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/claims", folder);
    if (make_folder(path) != 0)
        return -1;
    struct certificates c = {
        .folder = folder, .results = results, .recorded = calloc((size_t)count + 1, sizeof *c.recorded)};
    if (c.recorded == NULL)
        abort();
    cagd_in_parallel(jobs, count, write_certificate, &c);
    int bad = c.bad != 0 || write_manifest(r, folder, results, count, c.recorded) != 0;
    free(c.recorded);
    for (const statement *s = r->statements; s->id != NULL && !bad; s++) {
        statement_result derived = derive(s, results, count);
        size_t key = strcspn(s->id, ":");
        if (derived.verdict == VERDICT_OPEN) {
            free_statement_result(&derived);
            continue;
        }
        snprintf(path, sizeof path, "%s/%.*s", folder, (int)key, s->id);
        bad = make_folder(path) != 0;
        char *text = certificate_of_statement(&derived);
        snprintf(path, sizeof path, "%s/%.*s/%s.json", folder, (int)key, s->id, s->id + key + 1);
        bad = bad || write_text_file(path, text) != 0;
        free(text);
        free_statement_result(&derived);
    }
    return bad ? -1 : 0;
}

/* That the files in the folders can be written, those that always have the same names, and are not those of other options. */
static int promise_folders(const struct arguments *a)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/manifest.json", a->certificates != NULL ? a->certificates : "");
    int code = a->certificates != NULL ? output_promise("certificates", path) : EXIT_AS_EXPECTED;
    return code == EXIT_AS_EXPECTED && a->report != NULL ? promise_report(a->report) : code;
}

static int run(const struct call *call)
{
    struct arguments a = {.shards = 1, .shard = 1};
    parse_arguments(call, &a.asked);
    if (promise_folders(&a) != EXIT_AS_EXPECTED)
        return EXIT_USAGE;
    if (!all_match(call->reg, &a.asked.patterns, CLAIMS))
        return EXIT_USAGE;
    int count, kept = 0;
    const claim **list = matching_claims(call->reg, &a.asked.patterns, &count);
    for (int k = 0; k < count; k++)
        if (k % a.shards == a.shard - 1)
            list[kept++] = list[k];
    count = kept;
    claim_result *results = judge_with_progress(list, count, a.asked.jobs, a.deep);
    int wrong = 0;
    for (int k = 0; k < count; k++)
        wrong += !results[k].as_expected;
    if (a.asked.json) {
        json_t *claims = json_array();
        for (int k = 0; k < count; k++)
            json_array_append_new(claims, claim_json(&results[k]));
        print_json(json_pack("{s:s, s:i, s:i, s:o}", "schema", "cagd-verify-1", "claims_run", count, "not_as_expected",
                             wrong, "claims", claims));
    } else if (a.tap) {
        print_tap(results, count);
    } else {
        print_table(results, count);
    }
    int code = wrong > 0 ? EXIT_NOT_AS_EXPECTED : EXIT_AS_EXPECTED;
    if (a.junit != NULL && write_junit(a.junit, results, count) != 0)
        code = EXIT_INTERNAL;
    if (a.certificates != NULL && write_certificates(call->reg, a.certificates, results, count, a.asked.jobs) != 0)
        code = EXIT_INTERNAL;
    int statements = a.report != NULL ? write_report(call->reg, a.report, results, count) : 0;
    if (statements != 0 && code != EXIT_INTERNAL)
        code = statements < 0 ? EXIT_INTERNAL : EXIT_NOT_AS_EXPECTED;
    cagd_thread_end();
    free_results(results, count);
    free(list);
    return code;
}

static const struct argp_option options[] = {
    {"tap", 'T', 0, 0, "Print the results in the Test Anything Protocol", 0},
    {"junit", 'U', "FILE", 0, "Also write the results to FILE as JUnit XML", 0},
    {"certificates", 'C', "DIR", 0, "Also write the evidence to DIR, for proofs-tests/recheck.py", 0},
    {"report", 'R', "DIR", 0, "Also write the ledger to DIR: every statement of the sources, as text and as JSON", 0},
    {"deep", 'D', 0, 0, "Many more random instances", 0},
    {"shard", 'S', "K/N", 0, "Only the K-th of N parts of the claims", 0},
    {0}};

const struct command command_verify = {
    .name = "verify",
    .summary = "decide claims and print a table of the verdicts",
    .example = "  cagd verify                      decide every claim\n"
               "  cagd verify 'rational-bezier.*'  decide the claims of one chapter\n",
    .usage = "[PATTERN...]",
    .text =
        "Decides claims and prints a table of the verdicts.\n\n"
        "Examples:\n"
        "  cagd verify                      every claim\n"
        "  cagd verify 'rational-bezier.*'  one chapter\n"
        "  cagd verify 'wang-ch3:3.2.4-*'   the claims that decide one formula\n"
        "  cagd verify --json --jobs 2      for a program\n"
        "\vA PATTERN is a shell glob over claim names, chapter.name, or statement ids, or a word of a title, English "
        "or Chinese.  The letters f q i d say in "
        "which numbers a claim was run: rational functions, rationals, intervals, binary64.  A counterexample, marked "
        "✗, refutes what is printed, a reading of it, or what is left of it without a hypothesis; 'cagd ledger' says "
        "which.  Exit status 1 when a verdict is not as expected.",
    .arguments = CLAIM_NAMES,
    .shared = TAKES_JSON | TAKES_JOBS,
    .options = options,
    .parse = parse,
    .run = run,
};
