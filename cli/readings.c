/* readings.c -- the ways to read a statement, what is known of each, and which one is meant. */
#include "cli/readings.h"
#include "chapters/judge/memory_text.h"

#include "cli/layout.h"
#include "cli/prose.h"
#include "cli/shown.h"
#include "cli/terminal.h"
#include "cli/tex.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Whether an earlier link already showed the claim's numbers. */
static int is_shown_above(const statement *s, const statement_link *link)
{
    for (const statement_link *l = s->links; l != link; l++)
        if (l->claim != NULL && strcmp(l->claim, link->claim) == 0)
            return 1;
    return 0;
}

void print_meant(const statement *s)
{
    for (const statement_link *l = s->links; l->claim != NULL || l->text != NULL; l++)
        if (l->role == MEANT) {
            heading("What is meant");
            prose(l->text, INDENT);
            labelled("Known by", l->place, INDENT);
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
    if (c == NULL) {
        text = strdup("not decided");
        if (text == NULL)
            abort();
        return text;
    }
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

void print_readings(const statement *s, const claim_result *results, int count)
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

void print_undecided(const statement *s, const claim_result *results, int count)
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
    FILE *out = text_open(&text, &room);
    fputs("It can be read in ", out);
    if (all >= 1 && all <= 6)
        fputs(number[all - 1], out);
    else
        fprintf(out, "%d ways", all);
    const char *between = ": ";
    for (enum reading_state k = 0; k < READING_STATES && all > 1; k++)
        if (of[k] > 0) {
            fputs(between, out);
            put_readings_in(out, s, k, results, count);
            between = ", ";
        }
    if (all == 1)
        fprintf(out, ", which is %s", of[READING_TRUE] ? "true" : of[READING_FALSE] ? "false" : "not decided");
    fputs(".", out);
    text_close(out, &text);
    paragraph(text, INDENT);
    free(text);
}

int has_reading(const statement *s)
{
    const statement_link *l = s->links;
    while ((l->claim != NULL || l->text != NULL) && l->role != READING)
        l++;
    return l->claim != NULL || l->text != NULL;
}

void print_failing_readings(const statement *s, const claim_result *results, int count)
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
            prose(c->claim->then, INDENT);
            print_exhibits(c);
        }
        number++;
    }
}
