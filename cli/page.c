/* page.c -- one statement or one claim as a page. */
#include "cli/page.h"

#include "chapters/judge/tex.h"
#include "cli/report.h"
#include "cli/terminal.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 92, INDENT = 4 };

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

/* The text that the statement is from: "Wang Guojin et al.: 计算机辅助几何设计 (...), chapter 3, 2001". */
static void print_source_of(const cagd_register *reg, const statement *s)
{
    size_t length = strcspn(s->id, ":");
    const source *k = reg->sources;
    while (k->key != NULL && (strlen(k->key) != length || strncmp(k->key, s->id, length) != 0))
        k++;
    if (k->key == NULL)
        return;
    int first = (int)strcspn(k->author, ",("), many = k->author[first] == ',';
    if (strcmp(k->author, "unknown") != 0)
        printf("%.*s%s: ", k->author[first] == '(' ? first - 1 : first, k->author, many ? " et al." : "");
    if (k->title_zh[0] != '\0')
        printf("%s (%s)", k->title_zh, k->title);
    else
        fputs(k->title, stdout);
    printf(", %s", k->part);
    if (strcmp(k->year, "unknown") != 0)
        printf(", %s", k->year);
    putchar('\n');
}

/* Whether the text refers to the source, as [KEY] or among others as [KEY; KEY]. */
static int refers_to(const char *text, const char *key)
{
    for (const char *at = strchr(text, '['); at != NULL; at = strchr(at + 1, '[')) {
        const char *found = strstr(at, key), *end = strchr(at, ']');
        if (found != NULL && end != NULL && found < end && (found[-1] == '[' || found[-1] == ' '))
            return 1;
    }
    return 0;
}

/* What the note and the methods of the claims refer to. */
static void print_literature(const cagd_register *reg, const char *note, const claim_result *results, int count)
{
    int first = 1;
    for (const source *s = reg->sources; s->key != NULL; s++) {
        int wanted = refers_to(note, s->key);
        for (int k = 0; k < count; k++)
            wanted |= refers_to(results[k].claim->method, s->key);
        if (wanted && first)
            heading("Literature");
        if (wanted) {
            char line[1024];
            snprintf(line, sizeof line, "%s  %s: %s, %s, %s", s->key, s->author, s->title, s->publisher, s->year);
            put_paragraph(stdout, line, INDENT, WIDTH);
            first = 0;
        }
    }
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

void print_claim(const cagd_register *reg, const claim_result *r)
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
    print_literature(reg, "", r, 1);
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

void print_statement(const cagd_register *reg, const statement_result *r, const claim_result *results, int count)
{
    static const char *const words[] = {"It holds as printed", "It holds under more hypotheses",
                                        "It fails as printed", "It can be read in several ways",
                                        "It is open",          "A definition"};
    const statement *s = r->statement;
    printf("%s%s%s  %s\n%s  (%s:%d)\n", style(stdout, BOLD), s->title, style(stdout, PLAIN), s->title_zh, s->id,
           s->file, s->line);
    print_source_of(reg, s);
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
    print_literature(reg, s->note, results, count);
}
