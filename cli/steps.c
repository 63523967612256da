/* steps.c -- the steps that decide a statement: claims, arguments in words, cited theorems. */
#include "cli/steps.h"
#include "chapters/judge/memory_text.h"

#include "cli/prose.h"
#include "cli/shown.h"
#include "cli/terminal.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The steps that lead to a finding: of how many, which one is told, and where its text stands. */
struct steps {
    const statement *statement;
    role role; /* of the claims among them */
    const finding *together;
    int all, told, indent;
};

enum { OF_NUMBER = 4 };

static int is_step(const struct steps *at, const statement_link *l)
{
    return (l->role == at->role && l->claim != NULL) || l->role == ARGUED || l->role == CITES;
}

/* "2   The derivative of the product": a step has a number where there are more. */
static void begin_step(struct steps *at, const char *title)
{
    char number[16];
    putchar('\n');
    snprintf(number, sizeof number, "%d", ++at->told);
    fputs(style(stdout, BOLD), stdout);
    hanging(at->all > 1 ? number : "", title, at->indent - INDENT, INDENT);
    fputs(style(stdout, PLAIN), stdout);
}

/* "An identity, proved for n = 1 to 6."; "A decision for n = 3."; nothing of a step that is the only one, and so was told. */
static void print_kind(const struct steps *at, claim_kind kind, const char *known)
{
    static const char *const kinds[KINDS] = {"an identity", "a decision", "a counterexample"};
    const char *decided = evidence_name[DECIDED];
    size_t n = strlen(decided);
    char *text = NULL;
    if (at->all == 1 && known[0] == '\0')
        return;
    int is_told = kind == DECISION && strncmp(known, decided, n) == 0;
    if (asprintf(&text, "%s%s%s", kinds[kind], known[0] == '\0' || is_told ? "" : ", ", known + (is_told ? n : 0)) < 0)
        abort();
    clause(text, at->indent);
    free(text);
}

/* Whether a step is known in the same words as all together, which may have further conditions behind ", where". */
static int is_the_same(const char *words, const char *all)
{
    static const char more[] = ", where ";
    size_t n = 0;
    while (words[n] != '\0' && words[n] == all[n])
        n++;
    return words[n] == '\0' && (all[n] == '\0' || strncmp(all + n, more, sizeof more - 1) == 0);
}

/* The number of the step in which the claim of this name of n letters is told, 0 where it is no step here. */
static int number_of_step(const struct steps *at, const char *name, size_t n)
{
    int number = 0;
    for (const statement_link *l = at->statement->links; l->claim != NULL || l->text != NULL; l++)
        if (l->role == at->role && l->claim != NULL && ++number > 0 && strlen(l->claim) == n && strncmp(l->claim, name, n) == 0)
            return number;
    return 0;
}

/* The words of a step; where they name the claim of another one, as `claim`, it is called "step 2". */
static void step_prose(const struct steps *at, const char *label, const char *words)
{
    char *text = NULL;
    size_t room;
    FILE *out = text_open(&text, &room);
    for (const char *p = words; *p != '\0';) {
        size_t n = *p == '`' ? strcspn(p + 1, "`") : 0;
        int number = n > 0 && at->all > 1 ? number_of_step(at, p + 1, n) : 0;
        if (number > 0)
            fprintf(out, "step %d", number);
        else
            fputc(*p, out);
        p += number > 0 ? n + 2 : 1;
    }
    text_close(out, &text);
    if (label[0] != '\0')
        labelled(label, text, at->indent);
    else
        prose(text, at->indent);
    free(text);
}

/* What the claim computes, and why that suffices; how it is known, where that is not what is said of all steps together. */
static void print_computed_step(struct steps *at, const claim_result *c)
{
    finding alone = finding_of(c, at->statement->letter);
    char *words = finding_words(&alone), *all = finding_words(at->together);
    begin_step(at, c->claim->title);
    print_kind(at, c->claim->kind, is_the_same(words, all) ? "" : words);
    print_sentence(c->claim, at->indent);
    step_prose(at, "", c->claim->method);
    step_prose(at, "An argument:", c->claim->argued);
    if (strstr(words, "the stated ") != NULL) /* the page is to state it */
        print_numbers(c, at->indent);
    free(words), free(all), free_finding(&alone);
}

/* An argument, with the cases that it adds, or a cited theorem, with its place. */
static void print_step_in_words(struct steps *at, const statement_link *l)
{
    char *title = NULL;
    const char *what = l->role == CITES ? "Cited" : l->place[0] != '\0' ? "An argument for" : "An argument";
    if (asprintf(&title, "%s%s%s", what, l->place[0] == '\0' ? "" : l->role == CITES ? ": " : " ", l->place) < 0)
        abort();
    begin_step(at, title);
    step_prose(at, "", l->text);
    free(title);
}

/* First what was computed, then words. */
void print_steps(const statement *s, role wanted, const finding *together, int with_words, const claim_result *results,
                 int count)
{
    struct steps at = {.statement = s, .role = wanted, .together = together};
    for (const statement_link *l = s->links; l->claim != NULL || l->text != NULL; l++)
        at.all += is_step(&at, l) && (l->role == wanted || with_words);
    at.indent = at.all > 1 ? INDENT + OF_NUMBER : INDENT;
    for (int words = 0; words <= with_words; words++)
        for (const statement_link *l = s->links; l->claim != NULL || l->text != NULL; l++) {
            const claim_result *c = l->role == wanted && l->claim != NULL ? result_of(l->claim, results, count) : NULL;
            if (!words && c != NULL)
                print_computed_step(&at, c);
            else if (words && (l->role == ARGUED || l->role == CITES))
                print_step_in_words(&at, l);
        }
}

void print_deciders(const statement *s, role wanted, const claim_result *results, int count)
{
    static const char *const one[] = {"an identity", "a decision", "a counterexample", "an argument in words",
                                      "a citation"};
    static const char *const more[] = {"identities", "decisions", "counterexamples", "arguments in words",
                                       "citations"};
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
    FILE *out = text_open(&text, &room);
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
    const char *verb = wanted == CHECKED_BY ? "check" : "decide";
    fprintf(out, " %s%s", verb, all == 1 ? "s it" : " it together");
    text_close(out, &text);
    clause(text, INDENT);
    free(text);
}
