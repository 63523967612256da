/* show.c -- cagd show: one statement or one claim as a page. */
#include "chapters/judge/tex.h"
#include "cli/commands.h"
#include "cli/report.h"
#include "cli/terminal.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 92, INDENT = 4 };

static error_t parse(int key, char *arg, struct argp_state *state)
{
    (void)arg;
    const struct asked *a = state->input;
    if (key != ARGP_KEY_END)
        return ARGP_ERR_UNKNOWN;
    if (a->patterns.count == 0)
        argp_error(state, "which id? for example wang-ch3:thm-3.3.2");
    if (a->patterns.count > 1 && a->json)
        argp_error(state, "--json shows one id at a time, not also '%s'", a->patterns.at[1]);
    return 0;
}

static void heading(const char *text) { printf("\n%s%s%s\n", style(stdout, BOLD), text, style(stdout, PLAIN)); }

/* Text with formulas between dollar signs; blank lines separate paragraphs. */
static void prose(const char *text)
{
    for (const char *p = text; *p != '\0';) {
        const char *end = strstr(p, "\n\n");
        size_t n = end != NULL ? (size_t)(end - p) : strlen(p);
        char *paragraph = strndup(p, n), *plain = tex_to_text(paragraph, 1);
        put_paragraph(stdout, plain, INDENT, WIDTH);
        free(plain), free(paragraph);
        p += n;
        if (end != NULL) {
            putchar('\n');
            p += 2;
        }
    }
}

/* A formula in TeX; or a sentence, which has its formulas between dollar signs, or none of the signs of TeX. */
static void formula(const char *tex)
{
    int sentence = strchr(tex, '$') != NULL || strpbrk(tex, "\\_^=") == NULL;
    char *plain = tex_to_text(tex, sentence);
    put_paragraph(stdout, plain, INDENT, WIDTH);
    free(plain);
}

static void labelled(const char *label, const char *text)
{
    if (text[0] == '\0')
        return;
    char *plain = tex_to_text(text, 1), *whole;
    size_t room = strlen(plain) + strlen(label) + 4;
    whole = malloc(room);
    if (whole == NULL)
        abort();
    snprintf(whole, room, "%s  %s", label, plain);
    put_paragraph(stdout, whole, INDENT, WIDTH);
    free(whole), free(plain);
}

static void print_exhibits(const claim_result *r)
{
    const type_result *b = speaking_type(r);
    int width = 0;
    for (int k = 0; b != NULL && k < b->exhibits; k++)
        if (columns_of(b->shown[k].name) > width)
            width = columns_of(b->shown[k].name);
    for (int k = 0; b != NULL && k < b->exhibits; k++) {
        printf("%*s", INDENT, "");
        put_padded(stdout, b->shown[k].name, width);
        printf(" = %s\n", b->shown[k].value);
    }
}

static void print_claim_lines(const claim_result *r)
{
    const claim *c = r->claim;
    printf("%*s%s%s%s: %s\n", INDENT, "", style(stdout, BOLD), c->name, style(stdout, PLAIN), c->title);
    for (number_type t = 0; t < NUMBER_TYPES; t++) {
        const type_result *b = &r->by[t];
        if (!b->ran)
            continue;
        printf("%*s  %-9s %s", INDENT, "", number_type_name[t],
               t == INTERVAL_TYPE && b->outcome == UNDECIDED ? "not refuted" : outcome_name[b->outcome]);
        printf(" in %d case%s, %d comparison%s", b->cases, b->cases == 1 ? "" : "s", b->compared,
               b->compared == 1 ? "" : "s");
        if (t == DOUBLE_TYPE && c->kind == IDENTITY)
            printf("; largest error %.2g of its bound", b->worst);
        if (t == INTERVAL_TYPE)
            printf("; widest enclosure %.1e", b->worst);
        printf("; control %s\n", b->control_caught ? "caught" : "NOT CAUGHT");
    }
}

/* What the claim does for a statement that names it. */
static const char *const role_words[] = {
    [HOLDS_BY] = "decides",           [REFUTED_BY] = "refutes",    [CORRECTED_BY] = "corrects",
    [HYPOTHESIS] = "a hypothesis of", [NEEDS] = "a hypothesis of", [READING] = "a reading of",
    [CHECKED_BY] = "checks"};

static void show_claim(const cagd_register *reg, const claim_result *r)
{
    const claim *c = r->claim;
    printf("%s%s%s  %s\n", style(stdout, BOLD), c->title, style(stdout, PLAIN), c->title_zh);
    printf("%s.%s  (%s:%d)\n", c->chapter, c->name, c->file, c->line);
    heading(c->kind == COUNTEREXAMPLE ? "Counterexample" : "Claim");
    labelled("Given", c->given);
    labelled("let", c->let);
    labelled("then", c->then);
    heading("Method");
    prose(c->method);
    labelled("Control:", c->control);
    heading("Result");
    printf("%*s%s%s\n", INDENT, "", evidence_name[r->evidence],
           c->kind == COUNTEREXAMPLE && r->as_expected ? ": a counterexample" : "");
    if (r->scope[0] != '\0')
        labelled("for", r->scope);
    print_claim_lines(r);
    const type_result *b = speaking_type(r);
    if (b != NULL && b->exhibits > 0) {
        heading("What it shows");
        print_exhibits(r);
    }
    int first = 1;
    for (const statement *s = reg->statements; s->id != NULL; s++)
        for (const statement_link *l = s->links; l->claim != NULL || l->text != NULL; l++)
            if (l->claim != NULL && strcmp(l->claim, c->name) == 0) {
                if (first)
                    heading("For");
                first = 0;
                printf("%*s", INDENT, "");
                put_padded(stdout, role_words[l->role], 17);
                printf("%s  %s\n", s->id, s->title);
                break;
            }
}

/* What the claims of a role compute, and why that suffices. */
static void print_reasons(const statement *s, role wanted, const claim_result *results, int count)
{
    int first = 1;
    for (const statement_link *l = s->links; l->claim != NULL || l->text != NULL; l++) {
        const claim_result *c = l->role == wanted && l->claim != NULL ? result_of(l->claim, results, count) : NULL;
        if (c == NULL)
            continue;
        if (!first)
            putchar('\n');
        first = 0;
        labelled("Given", c->claim->given);
        labelled("let", c->claim->let);
        labelled("then", c->claim->then);
        prose(c->claim->method);
    }
}

static const char *class_words(const char *class)
{
    return strcmp(class, "misprint") == 0             ? "a misprint"
           : strcmp(class, "false") == 0              ? "false"
           : strcmp(class, "missing-hypothesis") == 0 ? "a hypothesis is missing"
           : strcmp(class, "invalid-proof") == 0      ? "the step does not follow"
                                                      : "";
}

/* Whether an earlier link already showed the claim's numbers. */
static int is_shown_above(const statement *s, const statement_link *link)
{
    for (const statement_link *l = s->links; l != link; l++)
        if (l->claim != NULL && strcmp(l->claim, link->claim) == 0)
            return 1;
    return 0;
}

static void show_statement(const statement_result *r, const claim_result *results, int count)
{
    static const char *const words[] = {"It holds as printed", "It holds under more hypotheses",
                                        "It fails as printed", "It can be read in several ways",
                                        "It is open",          "A definition"};
    const statement *s = r->statement;
    printf("%s%s%s  %s\n%s  (%s:%d)\n", style(stdout, BOLD), s->title, style(stdout, PLAIN), s->title_zh, s->id,
           s->file, s->line);
    heading("Printed");
    formula(s->printed);
    heading("Verdict");
    printf("%*s%s", INDENT, "", words[r->verdict]);
    if (r->verdict == VERDICT_FAILS)
        printf(": %s", class_words(s->class));
    if (r->evidence != NO_EVIDENCE)
        printf(" (%s)", evidence_name[r->evidence]);
    puts(".");
    if (r->decided_by != NULL && r->verdict != VERDICT_FAILS) {
        labelled("Scope:", r->decided_by->scope);
        heading("Why");
        print_reasons(s, s->is_definition ? CHECKED_BY : HOLDS_BY, results, count);
    }
    int number = 0;
    for (const statement_link *l = s->links; l->claim != NULL || l->text != NULL; l++) {
        const claim_result *c = l->claim != NULL ? result_of(l->claim, results, count) : NULL;
        if (l->role == REFUTED_BY && c != NULL) {
            heading(number++ == 0 ? "Counterexample" : "Another");
            prose(c->claim->then);
            print_exhibits(c);
        } else if (l->role == HYPOTHESIS || l->role == NEEDS) {
            heading(l->role == NEEDS ? "A stated hypothesis that is needed" : "Hypothesis to be added");
            prose(l->text);
            if (c != NULL) {
                printf("%*sWithout it:\n", INDENT, "");
                print_exhibits(c);
            }
        } else if (l->role == READING) {
            heading("A reading");
            prose(l->text);
            if (c == NULL)
                continue;
            int fails = c->claim->kind == COUNTEREXAMPLE;
            printf("%*sSo read, it %s.\n", INDENT, "", fails ? "fails" : outcome_name[c->outcome]);
            if (fails && !is_shown_above(s, l))
                print_exhibits(c);
        }
    }
    if (s->corrected[0] != '\0') {
        heading("Corrected");
        formula(s->corrected);
        if (r->corrected_by != NULL) {
            char word[16];
            snprintf(word, sizeof word, "%s;", evidence_name[r->corrected_evidence]);
            labelled(word, r->corrected_by->scope);
            putchar('\n');
        }
        print_reasons(s, CORRECTED_BY, results, count);
    }
    if (s->note[0] != '\0') {
        heading("Remarks");
        prose(s->note);
    }
    heading("Claims");
    for (int k = 0; k < count; k++)
        print_claim_lines(&results[k]);
    if (s->figure[0] != '\0') {
        heading("Figure");
        printf("%*sfigures/gallery/%s.svg\n", INDENT, "", s->figure);
    }
}

/* What an id names: a statement, or a claim with or without its chapter; at most one of them is not NULL. */
struct entry {
    const statement *statement;
    const claim *claim;
};
static struct entry entry_of(const cagd_register *r, const char *id)
{
    for (const statement *s = r->statements; s->id != NULL; s++)
        if (strcmp(s->id, id) == 0)
            return (struct entry){s, NULL};
    const char *bare = strchr(id, '.') != NULL && strchr(id, ':') == NULL ? strchr(id, '.') + 1 : id;
    for (const claim *c = r->claims; c->name != NULL; c++)
        if (strcmp(c->name, bare) == 0)
            return (struct entry){NULL, c};
    return (struct entry){NULL, NULL};
}

/* The claims that an entry names, in the order of the register. */
static const claim **claims_of_entry(const cagd_register *r, struct entry e, int *count)
{
    if (e.statement != NULL)
        return claims_of(r, &e.statement, 1, count);
    const claim **one = calloc(1, sizeof *one);
    if (one == NULL)
        abort();
    one[0] = e.claim;
    *count = 1;
    return one;
}

/* One page, from results among which those of its claims are.  Returns whether it is as expected. */
static int show_entry(const cagd_register *reg, struct entry e, const claim_result *all, int judged, int json)
{
    int count;
    const claim **list = claims_of_entry(reg, e, &count);
    claim_result *results = calloc((size_t)count, sizeof *results);
    if (results == NULL)
        abort();
    for (int k = 0; k < count; k++)
        results[k] = *result_of(list[k]->name, all, judged);
    int good = results[0].as_expected;
    if (e.statement != NULL) {
        statement_result r = derive(e.statement, results, count);
        good = r.as_expected;
        if (json)
            print_json(
                json_pack("{s:s, s:o}", "schema", "cagd-statement-1", "statement", statement_json(&r, results, count)));
        else
            show_statement(&r, results, count);
    } else if (json) {
        print_json(json_pack("{s:s, s:o}", "schema", "cagd-claim-1", "claim", claim_json(&results[0])));
    } else {
        show_claim(reg, &results[0]);
    }
    free(results);
    free(list);
    return good;
}

static int run(const struct call *call)
{
    struct asked a = {0};
    parse_arguments(call, &a);
    int every = 0, judged = 0, good = 1;
    const cagd_register *r = call->reg;
    while (r->claims[every].name != NULL)
        every++;
    char *wanted = calloc((size_t)every + 1, 1);
    const claim **list = calloc((size_t)every + 1, sizeof *list);
    if (wanted == NULL || list == NULL)
        abort();
    for (int k = 0; k < a.patterns.count; k++) {
        struct entry e = entry_of(r, a.patterns.at[k]);
        if (e.statement == NULL && e.claim == NULL) {
            complain_about(r, a.patterns.at[k], STATEMENTS);
            free(wanted), free(list);
            return EXIT_USAGE;
        }
        int count;
        const claim **its = claims_of_entry(r, e, &count);
        for (int m = 0; m < count; m++)
            wanted[its[m] - r->claims] = 1;
        free(its);
    }
    for (int m = 0; m < every; m++)
        if (wanted[m])
            list[judged++] = &r->claims[m];
    claim_result *results = judge_with_progress(list, judged, a.jobs, 0);
    for (int k = 0; k < a.patterns.count; k++) {
        if (k > 0)
            puts("\n");
        good &= show_entry(r, entry_of(r, a.patterns.at[k]), results, judged, a.json);
    }
    free_results(results, judged);
    free(wanted), free(list);
    return good ? EXIT_AS_EXPECTED : EXIT_NOT_AS_EXPECTED;
}

const struct command command_show = {
    .name = "show",
    .summary = "one claim or ledger entry in full, with its counterexample",
    .example = "  cagd show wang-ch3:thm-3.3.2     a statement, its verdict and why\n",
    .usage = "ID...",
    .text = "Shows statements of a source, or claims, in full: a page each.\n\n"
            "Examples:\n"
            "  cagd show wang-ch3:thm-3.3.2\n"
            "  cagd show elevation_keeps_rational_curve\n",
    .arguments = CLAIM_NAMES,
    .shared = TAKES_JSON | TAKES_JOBS,
    .parse = parse,
    .run = run,
};
