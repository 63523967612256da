/* page.c -- one statement or one claim as a page. */
#include "cli/page.h"
#include "chapters/judge/memory_text.h"

#include "cli/layout.h"
#include "cli/prose.h"
#include "cli/readings.h"
#include "cli/report.h"
#include "cli/shown.h"
#include "cli/steps.h"
#include "cli/terminal.h"
#include "cli/tex.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A paragraph of the page; \5 is a TIE. */
__attribute__((format(printf, 1, 2))) static void put_formatted(const char *format, ...)
{
    char *text;
    size_t size;
    FILE *out = text_open(&text, &size);
    va_list arguments;
    va_start(arguments, format);
    vfprintf(out, format, arguments);
    va_end(arguments);
    text_close(out, &text);
    put_paragraph(stdout, text, 0, page_width(WIDEST));
    free(text);
}

/* The first lines of a page: a title in both languages, an id and where it stands. */
static void title(const char *english, const char *chinese, const char *id, const char *file, int line)
{
    fputs(style(stdout, BOLD), stdout);
    put_formatted("%s\5 %s", english, chinese);
    fputs(style(stdout, PLAIN), stdout);
    put_formatted("%s\5 (%s:%d)", id, file, line);
}

/* Whether it is a text, and not the word for none. */
static int is_known(const char *text) { return text[0] != '\0' && strcmp(text, "unknown") != 0; }

/* The text that the statement is from: "Wang Guojin et al.: 计算机辅助几何设计 (...), chapter 3, 2001". */
static void print_source_of(const cagd_register *reg, const statement *s)
{
    size_t length = strcspn(s->id, ":");
    const source *k = reg->sources;
    while (k->key != NULL && (strlen(k->key) != length || strncmp(k->key, s->id, length) != 0))
        k++;
    if (k->key == NULL)
        return;
    int first = (int)strcspn(k->author, ",("), many = k->author[first] == ',', named = is_known(k->author);
    int chinese = k->title_zh[0] != '\0', dated = is_known(k->year);
    char text[1024];
    const char *between = k->part[0] != '\0' ? ", " : "";
    snprintf(text, sizeof text, "%.*s%s%s%s%s%s%s%s%s%s",
             !named                    ? 0
             : k->author[first] == '(' ? first - 1
                                       : first,
             k->author,
             !named ? ""
             : many ? " et al.: "
                    : ": ",
             chinese ? k->title_zh : k->title, chinese ? " (" : "", chinese ? k->title : "", chinese ? ")" : "",
             between, k->part, dated ? ", " : "", dated ? k->year : "");
    put_paragraph(stdout, text, 0, page_width(WIDEST));
}

/* Whether the text refers to the source, as [KEY] or among others as [KEY; KEY]. */
static int refers_to(const char *text, const char *key)
{
    for (const char *at = strchr(text, '['); at != NULL; at = strchr(at + 1, '[')) {
        const char *end = strchr(at, ']');
        if (end == NULL)
            return 0;
        for (const char *found = strstr(at, key); found != NULL && found < end; found = strstr(found + 1, key))
            if ((found[-1] == '[' || found[-1] == ' ') && strchr(";]", found[strlen(key)]) != NULL)
                return 1;
    }
    return 0;
}

/* What the note and the methods of the claims refer to. */
static void print_literature(const cagd_register *reg, const char *note, const statement_link *links,
                             const claim_result *results, int count)
{
    int first = 1;
    for (const source *s = reg->sources; s->key != NULL; s++) {
        int wanted = refers_to(note, s->key);
        for (const statement_link *l = links; l != NULL && (l->claim != NULL || l->text != NULL); l++)
            wanted |= l->role == CITES && refers_to(l->place, s->key); /* which has a place */
        for (int k = 0; k < count; k++)
            wanted |= refers_to(results[k].claim->method, s->key);
        if (wanted && first)
            heading("Literature");
        if (wanted) {
            char line[1024];
            const int named = is_known(s->author), published = is_known(s->publisher), dated = is_known(s->year);
            snprintf(line, sizeof line, "%s  %s%s%s%s%s%s%s", s->key, named ? s->author : "", named ? ": " : "",
                     s->title, published ? ", " : "", published ? s->publisher : "", dated ? ", " : "",
                     dated ? s->year : "");
            paragraph(line, INDENT);
            first = 0;
        }
    }
}

static void print_type_line(const claim_result *r, number_type t)
{
    const type_result *b = &r->by[t];
    char *text = NULL;
    size_t room;
    FILE *out = text_open(&text, &room);
    fprintf(out, "%s in %d case%s, %d comparison%s",
            t == INTERVAL_TYPE && b->outcome == UNDECIDED ? "not refuted" : outcome_name[b->outcome], b->cases,
            b->cases == 1 ? "" : "s", b->compared, b->compared == 1 ? "" : "s");
    if (t == DOUBLE_TYPE && r->claim->kind == IDENTITY)
        fprintf(out, "; largest error %.2g of its bound", b->worst);
    if (t == INTERVAL_TYPE)
        fprintf(out, "; widest enclosure %.1e", b->worst);
    fprintf(out, "; control %s", b->control_caught ? "caught" : "NOT CAUGHT");
    text_close(out, &text);
    enum { TYPE_WIDTH = 10 };
    printf("%*s", INDENT + 2, "");
    put_padded(stdout, number_type_name[t], TYPE_WIDTH);
    put_behind(stdout, text, INDENT + 2 + TYPE_WIDTH, INDENT + 2 + TYPE_WIDTH, page_width(WIDEST));
    free(text);
}

static void print_claim_lines(const claim_result *r)
{
    printf("%*s%s%s%s:\n", INDENT, "", style(stdout, BOLD), r->claim->name, style(stdout, PLAIN));
    put_paragraph(stdout, r->claim->title, INDENT + 2, page_width(WIDEST));
    for (number_type t = 0; t < NUMBER_TYPES; t++)
        if (r->by[t].ran)
            print_type_line(r, t);
}

/* What the claim does for a statement that names it. */
static const char *const role_words[] = {
    [HOLDS_BY] = "decides",      [CONFIRMED_BY] = "confirms", [REFUTED_BY] = "refutes",
    [CORRECTED_BY] = "corrects", [CHECKED_BY] = "checks",     [HYPOTHESIS] = "a hypothesis of",
    [NEEDS] = "a hypothesis of", [READING] = "a reading of",  [READING_WITH] = "a reading of"};

void print_claim(const cagd_register *reg, const claim_result *r)
{
    const claim *c = r->claim;
    char name[256];
    snprintf(name, sizeof name, "%s.%s", c->chapter, c->name);
    title(c->title, c->title_zh, name, c->file, c->line);
    heading(c->kind == COUNTEREXAMPLE ? "Counterexample" : "Claim");
    hanging("Given", c->given, 7, INDENT);
    hanging("let", c->let, 7, INDENT);
    hanging("then", c->then, 7, INDENT);
    heading("Method");
    prose(c->method, INDENT);
    labelled("Control:", c->control, INDENT);
    heading("Result");
    printf("%*s%s%s\n", INDENT, "", evidence_name[r->evidence],
           c->kind == COUNTEREXAMPLE && r->as_expected ? ": a counterexample" : "");
    if (r->scope[0] != '\0')
        labelled("for", r->scope, INDENT);
    print_claim_lines(r);
    print_failure(r);
    int first = 1;
    for (const statement *s = reg->statements; s->id != NULL; s++)
        for (const statement_link *l = s->links; l->claim != NULL || l->text != NULL; l++)
            if (l->claim != NULL && strcmp(l->claim, c->name) == 0) {
                if (first)
                    heading("For");
                first = 0;
                printf("%*s", INDENT, "");
                put_padded(stdout, role_words[l->role], 17);
                char decided[512];
                snprintf(decided, sizeof decided, "%s\5 %s", s->id, s->title);
                put_behind(stdout, decided, INDENT + 17, INDENT + 17, page_width(WIDEST));
                break;
            }
    print_literature(reg, "", NULL, r, 1);
}

static const char *class_words(const char *class)
{
    return strcmp(class, "misprint") == 0             ? "a misprint"
           : strcmp(class, "false") == 0              ? "false"
           : strcmp(class, "missing-hypothesis") == 0 ? "a hypothesis is missing"
           : strcmp(class, "invalid-proof") == 0      ? "the step does not follow"
                                                      : "";
}

/* Hypotheses, whether the source states them or not, each with what goes wrong without it, as far as that was shown. */
static void print_hypotheses(const statement *s, const claim_result *results, int count)
{
    for (const statement_link *l = s->links; l->claim != NULL || l->text != NULL; l++) {
        if (l->role != HYPOTHESIS && l->role != NEEDS)
            continue;
        heading(l->role == NEEDS ? "A stated hypothesis that is needed" : "Hypothesis to be added");
        prose(l->text, INDENT);
        if (l->role == NEEDS && l->place != NULL)
            labelled("stated in", l->place, INDENT);
        const claim_result *c = l->claim != NULL ? result_of(l->claim, results, count) : NULL;
        if (c != NULL && c->as_expected) {
            paragraph("Without it:", INDENT);
            print_counterexample(c);
        }
    }
}

static void print_counterexamples(const statement *s, const claim_result *results, int count)
{
    int number = 0;
    for (const statement_link *l = s->links; l->claim != NULL || l->text != NULL; l++) {
        const claim_result *c = l->role == REFUTED_BY ? result_of(l->claim, results, count) : NULL;
        if (c == NULL || !c->as_expected)
            continue;
        heading(number++ == 0 ? "Counterexample" : "Another counterexample");
        print_counterexample(c);
    }
}

static void print_finding(const char *before, const finding *f)
{
    char *words = finding_words(f), *plain = tex_to_text(words, 1), *whole = NULL;
    size_t room;
    FILE *out = text_open(&whole, &room);
    fprintf(out, "%s%s%s.", before, words[0] != '\0' ? ": " : "", plain);
    text_close(out, &whole);
    paragraph(whole, INDENT);
    free(words), free(plain), free(whole);
}

static void print_verdict(const statement_result *r, const claim_result *results, int count)
{
    static const char *const words[] = {"It holds as printed", "It holds under more hypotheses",
                                        "It fails as printed", "",
                                        "It is open",          "A definition"};
    heading("Verdict");
    if (r->verdict == VERDICT_FAILS)
        printf("%*s%s: %s (%s).\n", INDENT, "", words[r->verdict], class_words(r->statement->class),
               evidence_name[r->as_printed.evidence]);
    else if (r->verdict == VERDICT_UNDECIDED)
        print_undecided(r->statement, results, count);
    else if (r->verdict == VERDICT_DEFINITION && r->as_printed.evidence != NO_EVIDENCE)
        print_finding("A definition, with what is checked of it", &r->as_printed);
    else
        print_finding(words[r->verdict], &r->as_printed);
    labelled(r->verdict == VERDICT_DEFINITION ? "An example:" : "One instance is enough:", r->statement->example,
             INDENT);
}

/* Claims that did not do what they should: while there is one, the verdict is not that of the statement. */
static void print_unexpected(const claim_result *results, int count)
{
    for (int k = 0; k < count; k++)
        if (!results[k].as_expected) {
            heading("Not as expected");
            print_claim_lines(&results[k]);
            print_failure(&results[k]);
        }
}

void print_statement(const cagd_register *reg, const statement_result *r, const claim_result *results, int count,
                     int numbers)
{
    const statement *s = r->statement;
    role deciding = s->is_definition ? CHECKED_BY : HOLDS_BY;
    title(s->title, s->title_zh, s->id, s->file, s->line);
    print_source_of(reg, s);
    heading("Printed");
    formula(s->printed, INDENT);
    print_verdict(r, results, count);
    print_unexpected(results, count);
    print_hypotheses(s, results, count);
    print_meant(s);
    if (has_reading(s)) {
        heading("Ways to read it");
        print_readings(s, results, count);
    }
    print_deciding_claims(s, results, count);
    print_failing_readings(s, results, count);
    print_counterexamples(s, results, count);
    int says_why = r->verdict != VERDICT_FAILS && r->as_printed.evidence != NO_EVIDENCE;
    if (says_why) {
        heading(s->is_definition ? "What is checked" : "Why");
        print_deciders(s, deciding, results, count);
        print_steps(s, deciding, &r->as_printed, 1, results, count);
    }
    if (s->corrected[0] != '\0') {
        heading("Corrected");
        formula(s->corrected, INDENT);
        print_finding("It holds", &r->as_corrected);
        print_deciders(s, CORRECTED_BY, results, count);
        print_steps(s, CORRECTED_BY, &r->as_corrected, !says_why, results, count);
    }
    if (s->note[0] != '\0') {
        heading("Remarks");
        prose(s->note, INDENT);
    }
    if (numbers) {
        heading("Claims");
        for (int k = 0; k < count; k++)
            print_claim_lines(&results[k]);
    }
    if (s->figure[0] != '\0') {
        heading("Figure");
        printf("%*sfigures/gallery/%s.svg\n", INDENT, "", s->figure);
    }
    print_literature(reg, s->note, s->links, results, count);
}

/* What is added to an entry of a table, below it. */
static void print_addition(const char *before, const char *tex, int indent)
{
    char *plain = tex_to_layout(tex, strchr(tex, '$') != NULL), *whole = malloc(strlen(plain) + strlen(before) + 1);
    if (whole == NULL)
        abort();
    sprintf(whole, "%s%s", before, plain);
    put_paragraph(stdout, whole, indent, page_width(WIDEST));
    free(plain), free(whole);
}

void print_table(const cagd_register *reg, const char *id, const statement_result *entries, int count)
{
    int width = 0, of[VERDICTS] = {0};
    for (int k = 0; k < count; k++) {
        int columns = columns_of(verdict_name[entries[k].verdict]);
        width = columns > width ? columns : width;
        of[entries[k].verdict]++;
    }
    char text[128];
    snprintf(text, sizeof text, "A table of %d entries", count);
    title(text, "", id, entries[0].statement->file, entries[0].statement->line);
    print_source_of(reg, entries[0].statement);
    const char *between = "";
    printf("%*s", INDENT, "");
    for (verdict v = 0; v < VERDICTS; v++)
        if (of[v] > 0)
            printf("%s%s: %d", between, verdict_name[v], of[v]), between = ", ";
    puts("\n");
    for (int k = 0; k < count; k++) {
        const statement *s = entries[k].statement;
        const char *told = verdict_name[entries[k].verdict];
        char *plain = tex_to_layout(s->printed, strchr(s->printed, '$') != NULL);
        int indent = INDENT + width + 2;
        printf("%*s", INDENT, "");
        put_padded(stdout, told, width + 2);
        put_behind(stdout, plain, indent, indent, page_width(WIDEST));
        free(plain);
        if (s->corrected[0] != '\0')
            print_addition(entries[k].verdict == VERDICT_FAILS ? "right: " : "", s->corrected, indent);
        for (const statement_link *l = s->links; l->claim != NULL || l->text != NULL; l++)
            if (l->role == HYPOTHESIS)
                print_addition("if ", l->text, indent);
    }
    printf("\nEach entry has a page of its own: cagd show %s\n", entries[0].statement->id);
}
