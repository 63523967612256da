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

/* A claim that is not as expected decides nothing. */
static enum reading_state state_by(const claim_result *c)
{
    return c == NULL || !c->as_expected       ? READING_OPEN
           : c->claim->kind == COUNTEREXAMPLE ? READING_FALSE
                                              : READING_TRUE;
}

/* What the claim of a reading says of it, as long as all that stand with it are as expected. */
static enum reading_state state_of(const statement_link *reading, const claim_result *results, int count)
{
    for (const statement_link *l = reading + 1; l->role == READING_WITH && l->claim != NULL; l++)
        if (state_by(result_of(l->claim, results, count)) == READING_OPEN)
            return READING_OPEN;
    return state_by(reading->claim != NULL ? result_of(reading->claim, results, count) : NULL);
}

/* How a reading is known, in the words of a verdict, with an argument beside its claims or without.  The caller frees. */
static char *known_of_reading(const statement *s, const statement_link *reading, const claim_result *results, int count)
{
    const claim_result *c = reading->claim != NULL ? result_of(reading->claim, results, count) : NULL;
    char *text = NULL;
    const enum reading_state state = state_of(reading, results, count);
    if (c == NULL || state == READING_OPEN) {
        text = strdup("not decided");
        if (text == NULL)
            abort();
        return text;
    }
    if (state == READING_FALSE) {
        if (asprintf(&text, "%s by a counterexample", evidence_name[c->evidence]) < 0)
            abort();
        return text;
    }
    finding f = finding_of_reading(s, reading, results, count);
    f.evidence = reading->place != NULL && f.evidence > BY_ARGUMENT ? BY_ARGUMENT : f.evidence;
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
        char *known = known_of_reading(s, l, results, count), *plain = tex_to_layout(l->text, 1),
             *how = tex_to_layout(known, 1);
        printf("%*s%2d  %-7s", INDENT, "", ++number, told[state_of(l, results, count)]);
        put_behind(stdout, plain, INDENT + 11, INDENT + 11, page_width(WIDEST));
        put_paragraph(stdout, how, INDENT + 11, page_width(WIDEST));
        if (l->place != NULL)
            labelled("An argument:", l->place, INDENT + 11);
        free(plain), free(known), free(how);
    }
}

/* Where `end`, a sign and the blank behind it, first stands in the text outside of formulas and parentheses; NULL: nowhere. */
static const char *first_outside(const char *text, const char *end)
{
    int formula = 0, depth = 0;
    for (const char *at = text; *at != '\0'; at++) {
        formula ^= *at == '$';
        depth += !formula && *at == '(' ? 1 : !formula && *at == ')' ? -1 : 0;
        if (!formula && depth == 0 && strncmp(at, end, strlen(end)) == 0)
            return at;
    }
    return NULL;
}

/* What a reading says, without what is said of it: its words before a colon, or a semicolon, or the end of a sentence. */
static void put_in_short(FILE *out, const char *text)
{
    static const char *const ends[] = {": ", "; ", ". "};
    const char *end = NULL;
    for (int k = 0; k < 3 && end == NULL; k++)
        end = first_outside(text, ends[k]);
    size_t length = end != NULL ? (size_t)(end - text) : strlen(text);
    while (length > 0 && text[length - 1] == '.')
        length--;
    fprintf(out, "%.*s", (int)length, text);
}

/* "False: the one in short (2); the other (3). ", the readings of one state with their numbers; nothing where none is. */
static void put_readings_in(FILE *out, const statement *s, enum reading_state wanted, const claim_result *results,
                            int count)
{
    static const char *const told[READING_STATES] = {"True", "False", "Not decided"};
    int put = 0, number = 0;
    for (const statement_link *l = s->links; l->claim != NULL || l->text != NULL; l++) {
        if (l->role != READING)
            continue;
        number++;
        if (state_of(l, results, count) != wanted)
            continue;
        fprintf(out, "%s%s", put > 0 ? "; " : told[wanted], put > 0 ? "" : ": ");
        put_in_short(out, l->text);
        fprintf(out, " (%d)", number);
        put++;
    }
    fputs(put > 0 ? ". " : "", out);
}

void print_undecided(const statement *s, const claim_result *results, int count)
{
    char *text = NULL;
    size_t room;
    FILE *out = text_open(&text, &room);
    for (enum reading_state k = 0; k < READING_STATES; k++)
        put_readings_in(out, s, k, results, count);
    text_close(out, &text);
    text[strlen(text) - 1] = '\0'; /* the last blank: there is a reading, or the statement would be open */
    prose(text, INDENT);
    free(text);
}

int has_reading(const statement *s)
{
    const statement_link *l = s->links;
    while ((l->claim != NULL || l->text != NULL) && l->role != READING)
        l++;
    return l->claim != NULL || l->text != NULL;
}

/* Whether the steps of the page tell what the claim does. */
static int is_a_step(const statement *s, const char *name)
{
    for (const statement_link *l = s->links; l->claim != NULL || l->text != NULL; l++)
        if ((l->role == HOLDS_BY || l->role == CHECKED_BY || l->role == CORRECTED_BY) && l->claim != NULL &&
            strcmp(l->claim, name) == 0)
            return 1;
    return 0;
}

void print_deciding_claims(const statement *s, const claim_result *results, int count)
{
    int number = 0, headed = 0;
    for (const statement_link *l = s->links; l->claim != NULL || l->text != NULL; l++) {
        if (l->role != READING && l->role != READING_WITH)
            continue;
        number += l->role == READING;
        const claim_result *c = l->claim != NULL ? result_of(l->claim, results, count) : NULL;
        if (state_by(c) != READING_TRUE || is_shown_above(s, l) || is_a_step(s, l->claim))
            continue;
        char text[64];
        snprintf(text, sizeof text, "What decides reading %d", number);
        if (headed != number)
            heading(text);
        else
            putchar('\n');
        headed = number;
        prose(c->claim->title, INDENT);
        print_sentence(c->claim, INDENT);
        prose(c->claim->method, INDENT);
        labelled("An argument:", c->claim->argued, INDENT);
        print_numbers(c, INDENT);
    }
}

void print_failing_readings(const statement *s, const claim_result *results, int count)
{
    int number = 0;
    for (const statement_link *l = s->links; l->claim != NULL || l->text != NULL; l++) {
        if (l->role != READING)
            continue;
        const claim_result *c = l->claim != NULL ? result_of(l->claim, results, count) : NULL;
        if (state_by(c) == READING_FALSE && !is_shown_above(s, l)) {
            char text[64];
            snprintf(text, sizeof text, "Counterexample to reading %d", number + 1);
            heading(text);
            print_counterexample(c);
        }
        number++;
    }
}
