/* shown.c -- what a claim shows: numbers under their names, and what was compared. */
#include "cli/shown.h"
#include "chapters/judge/memory_text.h"

#include "cli/layout.h"
#include "cli/prose.h"
#include "cli/report.h"
#include "cli/terminal.h"
#include "cli/tex.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The value shown under a name; NULL where none is. */
static const char *value_of(const exhibit *shown, int count, const char *name)
{
    for (int k = 0; k < count; k++)
        if (strcmp(shown[k].name, name) == 0)
            return shown[k].value;
    return NULL;
}

/* What was compared is told as a sentence, not in the list of the numbers. */
static int is_of_comparison(const char *name)
{
    return strcmp(name, "compared") == 0 || strcmp(name, "left") == 0 || strcmp(name, "right") == 0 ||
           strcmp(name, "negative") == 0;
}

/* "What fails: the point is in the hull", also of "whether the point is in the hull". */
static void put_condition(FILE *out, const char *what)
{
    static const char whether[] = "whether ";
    fputs("What fails: ", out);
    for (const char *at = what; *at != '\0';) {
        int is_word = (at == what || at[-1] == ' ') && strncmp(at, whether, sizeof whether - 1) == 0;
        if (is_word)
            at += sizeof whether - 1;
        else
            fputc(*at++, out);
    }
}

/* "Compared: y and x³ of the point: -4/625 and 8/15625 are not equal."; of a condition: "What fails: the point is in the hull." */
static void print_comparison(const exhibit *shown, int count)
{
    const char *what = value_of(shown, count, "compared"), *left = value_of(shown, count, "left"),
               *right = value_of(shown, count, "right"), *negative = value_of(shown, count, "negative");
    char *sentence = NULL;
    size_t room;
    FILE *out = text_open(&sentence, &room);
    int found = (left != NULL && right != NULL) || negative != NULL;
    if (what != NULL && found)
        fprintf(out, "Compared: %s", what);
    else if (what != NULL)
        put_condition(out, what);
    if (left != NULL && right != NULL)
        fprintf(out, "%s%s and %s are not equal", what != NULL ? ": " : "", left, right);
    else if (negative != NULL)
        fprintf(out, "%s%s is negative", what != NULL ? ": " : "", negative);
    text_close(out, &sentence);
    if (sentence[0] != '\0') {
        char *plain = tex_to_layout(sentence, 1), *whole = malloc(strlen(plain) + 2);
        if (whole == NULL)
            abort();
        sprintf(whole, "%s.", plain);
        paragraph(whole, INDENT);
        free(plain), free(whole);
    }
    free(sentence);
}

/* The numbers, a line each. */
static void print_values(const exhibit *shown, int count, int indent)
{
    int width = 0;
    for (int k = 0; k < count; k++) {
        int columns = columns_of(shown[k].name);
        if (!is_of_comparison(shown[k].name) && columns > width && columns <= page_width(WIDEST) / 3)
            width = columns;
    }
    for (int k = 0; k < count; k++) {
        if (is_of_comparison(shown[k].name))
            continue;
        put_value(stdout, shown[k].name, shown[k].value, indent, width, page_width(WIDEST));
    }
}

/* The numbers, and what was compared. */
static void print_shown(const exhibit *shown, int count)
{
    print_values(shown, count, INDENT);
    print_comparison(shown, count);
}

void print_numbers(const claim_result *r, int indent)
{
    const type_result *b = speaking_type(r);
    if (b != NULL)
        print_values(b->shown, b->exhibits, indent);
}

static void print_exhibits(const claim_result *r)
{
    const type_result *b = speaking_type(r);
    if (b != NULL)
        print_shown(b->shown, b->exhibits);
}

void print_sentence(const claim *c, int indent)
{
    enum { OF_LABEL = 7 };
    hanging("given", c->given, OF_LABEL, indent);
    hanging("let", c->let, OF_LABEL, indent);
    hanging("then", c->then, OF_LABEL, indent);
}

void print_counterexample(const claim_result *r)
{
    print_sentence(r->claim, INDENT);
    print_exhibits(r);
}

void print_failure(const claim_result *r)
{
    const type_result *b = speaking_type(r);
    if (b != NULL && b->exhibits > 0) {
        heading("What it shows");
        print_exhibits(r);
    }
    if (r->witnesses > 0) {
        heading("A small instance at which it fails");
        print_shown(r->witness, r->witnesses);
    }
}
