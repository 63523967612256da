/* page.c -- one statement or one claim as a page. */
#include "cli/page.h"

#include "cli/layout.h"
#include "cli/report.h"
#include "cli/terminal.h"
#include "cli/tex.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDEST = 92, INDENT = 4 };

static void paragraph(const char *text) { put_paragraph(stdout, text, INDENT, page_width(WIDEST)); }

/* The first lines of a page: a title in both languages, an id and where it stands. */
static void title(const char *english, const char *chinese, const char *id, const char *file, int line)
{
    char *text = malloc(strlen(english) + strlen(chinese) + strlen(id) + strlen(file) + 32);
    if (text == NULL)
        abort();
    fputs(style(stdout, BOLD), stdout);
    sprintf(text, "%s\5 %s", english, chinese);
    put_paragraph(stdout, text, 0, page_width(WIDEST));
    fputs(style(stdout, PLAIN), stdout);
    sprintf(text, "%s\5 (%s:%d)", id, file, line);
    put_paragraph(stdout, text, 0, page_width(WIDEST));
    free(text);
}

static void heading(const char *text) { printf("\n%s%s%s\n", style(stdout, BOLD), text, style(stdout, PLAIN)); }

/* Text with formulas between dollar signs; blank lines separate paragraphs. */
static void prose(const char *text)
{
    for (const char *p = text; *p != '\0';) {
        const char *end = strstr(p, "\n\n");
        size_t n = end != NULL ? (size_t)(end - p) : strlen(p);
        char *raw = strndup(p, n), *plain = tex_to_layout(raw, 1);
        paragraph(plain);
        free(plain), free(raw);
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
    char *plain = tex_to_layout(tex, sentence);
    paragraph(plain);
    free(plain);
}

static void labelled(const char *label, const char *text)
{
    if (text[0] == '\0')
        return;
    char *plain = tex_to_layout(text, 1), *whole;
    size_t room = strlen(plain) + strlen(label) + 4;
    whole = malloc(room);
    if (whole == NULL)
        abort();
    snprintf(whole, room, "%s  %s", label, plain);
    paragraph(whole);
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
    int first = (int)strcspn(k->author, ",("), many = k->author[first] == ',',
        named = strcmp(k->author, "unknown") != 0;
    int chinese = k->title_zh[0] != '\0', dated = strcmp(k->year, "unknown") != 0;
    char text[1024];
    snprintf(text, sizeof text, "%.*s%s%s%s%s%s, %s%s%s",
             !named                    ? 0
             : k->author[first] == '(' ? first - 1
                                       : first,
             k->author,
             !named ? ""
             : many ? " et al.: "
                    : ": ",
             chinese ? k->title_zh : k->title, chinese ? " (" : "", chinese ? k->title : "", chinese ? ")" : "",
             k->part, dated ? ", " : "", dated ? k->year : "");
    put_paragraph(stdout, text, 0, page_width(WIDEST));
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
            paragraph(line);
            first = 0;
        }
    }
}

/* The value shown under a name; NULL where none is. */
static const char *value_of(const type_result *b, const char *name)
{
    for (int k = 0; k < b->exhibits; k++)
        if (strcmp(b->shown[k].name, name) == 0)
            return b->shown[k].value;
    return NULL;
}

/* What was compared is told as a sentence, not in the list of the numbers. */
static int is_of_comparison(const char *name)
{
    return strcmp(name, "compared") == 0 || strcmp(name, "left") == 0 || strcmp(name, "right") == 0 ||
           strcmp(name, "negative") == 0;
}

/* "Compared were y and x³ of the point: -4/625 and 8/15625 are not equal." */
static void print_comparison(const type_result *b)
{
    const char *what = value_of(b, "compared"), *left = value_of(b, "left"), *right = value_of(b, "right"),
               *negative = value_of(b, "negative");
    char *sentence = NULL;
    size_t room;
    FILE *out = open_memstream(&sentence, &room);
    if (out == NULL)
        abort();
    if (what != NULL)
        fprintf(out, "Compared: %s", what);
    if (left != NULL && right != NULL)
        fprintf(out, "%s%s and %s are not equal", what != NULL ? ": " : "", left, right);
    else if (negative != NULL)
        fprintf(out, "%s%s is negative", what != NULL ? ": " : "", negative);
    fclose(out);
    if (sentence[0] != '\0') {
        char *plain = tex_to_layout(sentence, 1), *whole = malloc(strlen(plain) + 2);
        if (whole == NULL)
            abort();
        sprintf(whole, "%s.", plain);
        paragraph(whole);
        free(plain), free(whole);
    }
    free(sentence);
}

static void print_exhibits(const claim_result *r)
{
    const type_result *b = speaking_type(r);
    int width = 0;
    for (int k = 0; b != NULL && k < b->exhibits; k++) {
        int columns = columns_of(b->shown[k].name);
        if (!is_of_comparison(b->shown[k].name) && columns > width && columns <= page_width(WIDEST) / 3)
            width = columns;
    }
    for (int k = 0; b != NULL && k < b->exhibits; k++) {
        if (is_of_comparison(b->shown[k].name))
            continue;
        put_value(stdout, b->shown[k].name, b->shown[k].value, INDENT, width, page_width(WIDEST));
    }
    if (b != NULL)
        print_comparison(b);
}

static void print_type_line(const claim_result *r, number_type t)
{
    const type_result *b = &r->by[t];
    char *text = NULL;
    size_t room;
    FILE *out = open_memstream(&text, &room);
    if (out == NULL)
        abort();
    fprintf(out, "%s in %d case%s, %d comparison%s",
            t == INTERVAL_TYPE && b->outcome == UNDECIDED ? "not refuted" : outcome_name[b->outcome], b->cases,
            b->cases == 1 ? "" : "s", b->compared, b->compared == 1 ? "" : "s");
    if (t == DOUBLE_TYPE && r->claim->kind == IDENTITY)
        fprintf(out, "; largest error %.2g of its bound", b->worst);
    if (t == INTERVAL_TYPE)
        fprintf(out, "; widest enclosure %.1e", b->worst);
    fprintf(out, "; control %s", b->control_caught ? "caught" : "NOT CAUGHT");
    fclose(out);
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
    [HOLDS_BY] = "decides",  [CONFIRMED_BY] = "confirms",      [REFUTED_BY] = "refutes",    [CORRECTED_BY] = "corrects",
    [CHECKED_BY] = "checks", [HYPOTHESIS] = "a hypothesis of", [NEEDS] = "a hypothesis of", [READING] = "a reading of"};

void print_claim(const cagd_register *reg, const claim_result *r)
{
    const claim *c = r->claim;
    char name[256];
    snprintf(name, sizeof name, "%s.%s", c->chapter, c->name);
    title(c->title, c->title_zh, name, c->file, c->line);
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
                char decided[512];
                snprintf(decided, sizeof decided, "%s\5 %s", s->id, s->title);
                put_behind(stdout, decided, INDENT + 17, INDENT + 17, page_width(WIDEST));
                break;
            }
    print_literature(reg, "", r, 1);
}

/* A line "Proved for n = 1 to 6.": what is known of a step. */
static void print_known(const char *words)
{
    char *sentence = malloc(strlen(words) + 2);
    if (sentence == NULL)
        abort();
    sprintf(sentence, "%s.", words);
    sentence[0] = (char)(sentence[0] >= 'a' && sentence[0] <= 'z' ? sentence[0] - 'a' + 'A' : sentence[0]);
    char *plain = tex_to_text(sentence, 1);
    paragraph(plain);
    free(plain), free(sentence);
}

/* The steps that lead to a finding: of how many, which one is told. */
struct steps {
    const statement *statement;
    role role; /* of the claims among them */
    const finding *together;
    int all, told;
};

static int is_step(const struct steps *at, const statement_link *l)
{
    return (l->role == at->role && l->claim != NULL) || l->role == ARGUED || l->role == CITES;
}

/* "2 identity  The derivative of the product": a step has a number where there are more. */
static void begin_step(struct steps *at, const char *kind, const char *title)
{
    char what[64];
    if (at->told++ > 0)
        putchar('\n');
    snprintf(what, sizeof what, "%d %s", at->told, kind);
    labelled(at->all > 1 ? what : kind, title);
}

/* What the claim computes, and why that suffices; how it is known, where that is not what is said of all steps together. */
static void print_computed_step(struct steps *at, const claim_result *c)
{
    finding alone = finding_of(c, at->statement->letter);
    char *words = finding_words(&alone), *all = finding_words(at->together);
    begin_step(at, kind_name[c->claim->kind], c->claim->title);
    if (strcmp(words, all) != 0)
        print_known(words);
    labelled("given", c->claim->given);
    labelled("let", c->claim->let);
    labelled("then", c->claim->then);
    prose(c->claim->method);
    labelled("argument", c->claim->argued);
    free(words), free(all), free_finding(&alone);
}

/* An argument, with the cases that it adds, or a cited theorem, with its place. */
static void print_step_in_words(struct steps *at, const statement_link *l)
{
    char title[512] = "";
    if (l->place[0] != '\0')
        snprintf(title, sizeof title, "%s%s", l->role == ARGUED ? "for " : "", l->place);
    if (title[0] != '\0') {
        begin_step(at, l->role == ARGUED ? "argument" : "cited", title);
        prose(l->text);
    } else {
        begin_step(at, l->role == ARGUED ? "argument" : "cited", l->text);
    }
}

/* First what was computed, then words. */
static void print_steps(const statement *s, role wanted, const finding *together, int with_words,
                        const claim_result *results, int count)
{
    struct steps at = {.statement = s, .role = wanted, .together = together};
    for (const statement_link *l = s->links; l->claim != NULL || l->text != NULL; l++)
        at.all += is_step(&at, l) && (l->role == wanted || with_words);
    for (int words = 0; words <= with_words; words++)
        for (const statement_link *l = s->links; l->claim != NULL || l->text != NULL; l++) {
            const claim_result *c = l->role == wanted && l->claim != NULL ? result_of(l->claim, results, count) : NULL;
            if (!words && c != NULL)
                print_computed_step(&at, c);
            else if (words && (l->role == ARGUED || l->role == CITES))
                print_step_in_words(&at, l);
        }
}

/* "Two identities and an argument in words decide it together." */
static void print_deciders(const statement *s, role wanted, const claim_result *results, int count)
{
    static const char *const one[] = {"an identity", "a decision", "a counterexample", "an argument in words",
                                      "a cited theorem"};
    static const char *const more[] = {"identities", "decisions", "counterexamples", "arguments in words",
                                       "cited theorems"};
    static const char *const number[] = {"two", "three", "four", "five", "six", "seven", "eight", "nine"};
    enum { PARTS = KINDS + 2 };
    int of[PARTS] = {0}, parts = 0, all = 0, put = 0;
    for (const statement_link *l = s->links; l->claim != NULL || l->text != NULL; l++) {
        const claim_result *c = l->role == wanted && l->claim != NULL ? result_of(l->claim, results, count) : NULL;
        if (c != NULL) {
            of[c->claim->kind]++;
            of[KINDS] += c->claim->argued[0] != '\0';
        }
        of[KINDS] += l->role == ARGUED;
        of[KINDS + 1] += l->role == CITES;
    }
    for (int k = 0; k < PARTS; k++)
        parts += of[k] > 0, all += of[k];
    if (all == 0)
        return;
    char *text = NULL;
    size_t room;
    FILE *out = open_memstream(&text, &room);
    if (out == NULL)
        abort();
    for (int k = 0; k < PARTS; k++) {
        if (of[k] == 0)
            continue;
        fputs(put == 0 ? "" : put + 1 == parts ? " and " : ", ", out);
        if (of[k] == 1)
            fputs(one[k], out);
        else if (of[k] <= 9)
            fprintf(out, "%s %s", number[of[k] - 2], more[k]);
        else
            fprintf(out, "%d %s", of[k], more[k]);
        put++;
    }
    fputs(all == 1 ? " decides it." : " decide it together.", out);
    fclose(out);
    text[0] = (char)(text[0] >= 'a' && text[0] <= 'z' ? text[0] - 'a' + 'A' : text[0]);
    paragraph(text);
    free(text);
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

/* Hypotheses, whether the source states them or not, each with what goes wrong without it. */
static void print_hypotheses(const statement *s, const claim_result *results, int count)
{
    for (const statement_link *l = s->links; l->claim != NULL || l->text != NULL; l++) {
        if (l->role != HYPOTHESIS && l->role != NEEDS)
            continue;
        heading(l->role == NEEDS ? "A stated hypothesis that is needed" : "Hypothesis to be added");
        prose(l->text);
        if (l->role == NEEDS && l->place != NULL)
            labelled("stated in", l->place);
        const claim_result *c = l->claim != NULL ? result_of(l->claim, results, count) : NULL;
        if (c != NULL) {
            printf("%*sWithout it:\n", INDENT, "");
            print_exhibits(c);
        }
    }
}

/* Which of several readings the text itself has, and by what one knows. */
static void print_meant(const statement *s)
{
    for (const statement_link *l = s->links; l->claim != NULL || l->text != NULL; l++)
        if (l->role == MEANT) {
            heading("What is meant");
            prose(l->text);
            labelled("by", l->place);
        }
}

enum reading_state { READING_TRUE, READING_FALSE, READING_OPEN, READING_STATES };

static enum reading_state state_of(const claim_result *c)
{
    return c == NULL ? READING_OPEN : c->claim->kind == COUNTEREXAMPLE ? READING_FALSE : READING_TRUE;
}

/* How a reading is known, in the words of a verdict.  The caller frees. */
static char *known_of_reading(const statement *s, const claim_result *c)
{
    char *text = NULL;
    if (c == NULL)
        return strdup("not decided");
    if (state_of(c) == READING_FALSE) {
        if (asprintf(&text, "%s by a counterexample", evidence_name[c->evidence]) < 0)
            abort();
        return text;
    }
    finding f = finding_of(c, s->letter);
    text = finding_words(&f);
    free_finding(&f);
    return text;
}

/* The ways to read it, with their numbers: behind what is known of it, how. */
static void print_readings(const statement *s, const claim_result *results, int count)
{
    static const char *const told[READING_STATES] = {"true", "false", "open"};
    int number = 0;
    for (const statement_link *l = s->links; l->claim != NULL || l->text != NULL; l++) {
        if (l->role != READING)
            continue;
        const claim_result *c = l->claim != NULL ? result_of(l->claim, results, count) : NULL;
        char *known = known_of_reading(s, c), *plain = tex_to_layout(l->text, 1), *how = tex_to_layout(known, 1);
        printf("%*s%2d  %-7s", INDENT, "", ++number, told[state_of(c)]);
        put_behind(stdout, plain, INDENT + 11, INDENT + 11, page_width(WIDEST));
        put_paragraph(stdout, how, INDENT + 11, page_width(WIDEST));
        free(plain), free(known), free(how);
    }
}

/* "1, 3 and 4 are true": the readings of one state. */
static void put_readings_in(FILE *out, const statement *s, enum reading_state wanted, const claim_result *results,
                            int count)
{
    static const char *const told[READING_STATES] = {"true", "false", "not decided"};
    int all = 0, put = 0, number = 0;
    for (int pass = 0; pass < 2; pass++, number = 0)
        for (const statement_link *l = s->links; l->claim != NULL || l->text != NULL; l++) {
            if (l->role != READING)
                continue;
            number++;
            if (state_of(l->claim != NULL ? result_of(l->claim, results, count) : NULL) != wanted)
                continue;
            if (pass == 0)
                all++;
            else
                fprintf(out, "%s%d", put == 0 ? "" : put + 1 == all ? " and " : ", ", number), put++;
        }
    if (all > 0)
        fprintf(out, " %s %s", all == 1 ? "is" : "are", told[wanted]);
}

/* "It can be read in three ways: 1 and 2 are true, 3 is false." */
static void print_undecided(const statement *s, const claim_result *results, int count)
{
    static const char *const number[] = {"one way", "two ways", "three ways", "four ways", "five ways", "six ways"};
    int of[READING_STATES] = {0}, all = 0;
    for (const statement_link *l = s->links; l->claim != NULL || l->text != NULL; l++)
        if (l->role == READING) {
            of[state_of(l->claim != NULL ? result_of(l->claim, results, count) : NULL)]++;
            all++;
        }
    char *text = NULL;
    size_t room;
    FILE *out = open_memstream(&text, &room);
    if (out == NULL)
        abort();
    fputs("It can be read in ", out);
    if (all >= 1 && all <= 6)
        fputs(number[all - 1], out);
    else
        fprintf(out, "%d ways", all);
    const char *between = ": ";
    for (enum reading_state k = 0; k < READING_STATES; k++)
        if (of[k] > 0) {
            fputs(between, out);
            put_readings_in(out, s, k, results, count);
            between = ", ";
        }
    fputs(".", out);
    fclose(out);
    paragraph(text);
    free(text);
}

static int has_reading(const statement *s)
{
    const statement_link *l = s->links;
    while ((l->claim != NULL || l->text != NULL) && l->role != READING)
        l++;
    return l->claim != NULL || l->text != NULL;
}

/* The numbers that show of a reading that it fails. */
static void print_failing_readings(const statement *s, const claim_result *results, int count)
{
    int number = 0;
    for (const statement_link *l = s->links; l->claim != NULL || l->text != NULL; l++) {
        if (l->role != READING)
            continue;
        const claim_result *c = l->claim != NULL ? result_of(l->claim, results, count) : NULL;
        if (c != NULL && c->claim->kind == COUNTEREXAMPLE && !is_shown_above(s, l)) {
            char text[64];
            snprintf(text, sizeof text, "Counterexample to reading %d", number + 1);
            heading(text);
            prose(c->claim->then);
            print_exhibits(c);
        }
        number++;
    }
}

static void print_counterexamples(const statement *s, const claim_result *results, int count)
{
    int number = 0;
    for (const statement_link *l = s->links; l->claim != NULL || l->text != NULL; l++) {
        const claim_result *c = l->role == REFUTED_BY ? result_of(l->claim, results, count) : NULL;
        if (c == NULL)
            continue;
        heading(number++ == 0 ? "Counterexample" : "Another");
        prose(c->claim->then);
        print_exhibits(c);
    }
}

static void print_finding(const char *before, const finding *f)
{
    char *words = finding_words(f), *plain = tex_to_text(words, 1), *whole = NULL;
    size_t room;
    FILE *out = open_memstream(&whole, &room);
    if (out == NULL)
        abort();
    fprintf(out, "%s%s%s.", before, words[0] != '\0' ? ": " : "", plain);
    fclose(out);
    paragraph(whole);
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
    else
        print_finding(words[r->verdict], &r->as_printed);
    labelled("An example:", r->statement->example);
}

void print_statement(const cagd_register *reg, const statement_result *r, const claim_result *results, int count,
                     int numbers)
{
    const statement *s = r->statement;
    role deciding = s->is_definition ? CHECKED_BY : HOLDS_BY;
    title(s->title, s->title_zh, s->id, s->file, s->line);
    print_source_of(reg, s);
    heading("Printed");
    formula(s->printed);
    print_verdict(r, results, count);
    print_hypotheses(s, results, count);
    print_meant(s);
    if (has_reading(s)) {
        heading("Ways to read it");
        print_readings(s, results, count);
    }
    print_failing_readings(s, results, count);
    print_counterexamples(s, results, count);
    if (r->verdict != VERDICT_FAILS && r->as_printed.evidence != NO_EVIDENCE) {
        heading("Why");
        print_deciders(s, deciding, results, count);
        putchar('\n');
        print_steps(s, deciding, &r->as_printed, 1, results, count);
    }
    if (s->corrected[0] != '\0') {
        heading("Corrected");
        formula(s->corrected);
        print_finding("It holds", &r->as_corrected);
        print_deciders(s, CORRECTED_BY, results, count);
        putchar('\n');
        print_steps(s, CORRECTED_BY, &r->as_corrected, r->verdict == VERDICT_FAILS, results, count);
    }
    if (s->note[0] != '\0') {
        heading("Remarks");
        prose(s->note);
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
    print_literature(reg, s->note, results, count);
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
