/* select.c -- which claims, statements and figures are meant by patterns and ids. */
#include "cli/select.h"

#include "chapters/chapters.h"

#include <fnmatch.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void *must(void *p)
{
    if (p == NULL)
        abort();
    return p;
}

static int any(const struct patterns *p, const char *text)
{
    for (int k = 0; k < p->count; k++)
        if (fnmatch(p->at[k], text, 0) == 0)
            return 1;
    return 0;
}

static int names(const statement *s, const char *claim_name)
{
    for (const statement_link *l = s->links; l->claim != NULL || l->text != NULL; l++)
        if (l->claim != NULL && strcmp(l->claim, claim_name) == 0)
            return 1;
    return 0;
}

/* By its name, or by chapter.name. */
static int any_name(const struct patterns *p, const claim *c)
{
    char full[256];
    snprintf(full, sizeof full, "%s.%s", c->chapter, c->name);
    return any(p, c->name) || any(p, full);
}

int claim_matches(const claim *c, const struct patterns *p)
{
    if (p->count == 0 || any_name(p, c))
        return 1;
    for (const statement *s = all_statements; s->id != NULL; s++)
        if (names(s, c->name) && any(p, s->id))
            return 1;
    return 0;
}

int statement_matches(const statement *s, const struct patterns *p)
{
    if (p->count == 0 || any(p, s->id))
        return 1;
    for (const claim *c = all_claims; c->name != NULL; c++)
        if (names(s, c->name) && any_name(p, c))
            return 1;
    return 0;
}

const claim **matching_claims(const struct patterns *p, int *count)
{
    int n = 0;
    while (all_claims[n].name != NULL)
        n++;
    const claim **list = must(calloc((size_t)n + 1, sizeof *list));
    *count = 0;
    for (int k = 0; k < n; k++)
        if (claim_matches(&all_claims[k], p))
            list[(*count)++] = &all_claims[k];
    return list;
}

const statement **matching_statements(const struct patterns *p, int *count)
{
    int n = 0;
    while (all_statements[n].id != NULL)
        n++;
    const statement **list = must(calloc((size_t)n + 1, sizeof *list));
    *count = 0;
    for (int k = 0; k < n; k++)
        if (statement_matches(&all_statements[k], p))
            list[(*count)++] = &all_statements[k];
    return list;
}

const claim **claims_of(const statement *const list[], int statements, int *count)
{
    int n = 0;
    while (all_claims[n].name != NULL)
        n++;
    const claim **claims = must(calloc((size_t)n + 1, sizeof *claims));
    *count = 0;
    for (int k = 0; k < n; k++)
        for (int j = 0; j < statements; j++)
            if (names(list[j], all_claims[k].name)) {
                claims[(*count)++] = &all_claims[k];
                break;
            }
    return claims;
}

/* ---- nearest ids --------------------------------------------------------------------------------- */

/* Levenshtein's distance. */
static int distance(const char *a, const char *b)
{
    size_t m = strlen(b);
    int *row = must(calloc(m + 1, sizeof *row));
    for (size_t j = 0; j <= m; j++)
        row[j] = (int)j;
    for (size_t i = 1; a[i - 1] != '\0'; i++) {
        int diagonal = row[0];
        row[0] = (int)i;
        for (size_t j = 1; j <= m; j++) {
            int change = diagonal + (a[i - 1] != b[j - 1]);
            diagonal = row[j];
            int smallest = row[j] + 1 < row[j - 1] + 1 ? row[j] + 1 : row[j - 1] + 1;
            row[j] = change < smallest ? change : smallest;
        }
    }
    int d = row[m];
    free(row);
    return d;
}

enum { NEAREST = 3, LONGEST = 255 };
struct near {
    const char *id[NEAREST];
    int distance[NEAREST];
};

/* An id that contains the word counts as near; among equals, the one that begins alike is nearer. */
static void consider(struct near *n, const char *wanted, const char *id)
{
    int alike = 0, letters = strstr(id, wanted) != NULL ? 1 : distance(wanted, id);
    while (alike < LONGEST && wanted[alike] != '\0' && wanted[alike] == id[alike])
        alike++;
    int d = letters * (LONGEST + 1) - alike;
    for (int k = 0; k < NEAREST; k++)
        if (n->id[k] == NULL || d < n->distance[k]) {
            for (int j = NEAREST - 1; j > k; j--)
                n->id[j] = n->id[j - 1], n->distance[j] = n->distance[j - 1];
            n->id[k] = id, n->distance[k] = d;
            return;
        }
}

void complain_about(const char *wanted, enum kind_of_name kind)
{
    struct near n = {{0}, {0}};
    for (const statement *s = all_statements; kind != FIGURES && s->id != NULL; s++)
        consider(&n, wanted, s->id);
    for (const claim *c = all_claims; kind != FIGURES && c->name != NULL; c++)
        consider(&n, wanted, c->name);
    for (const figure *f = all_figures; kind == FIGURES && f->name != NULL; f++)
        consider(&n, wanted, f->name);
    fprintf(stderr, "cagd: no %s is called '%s'; the nearest:", kind == FIGURES ? "figure" : "statement or claim",
            wanted);
    for (int k = 0; k < NEAREST && n.id[k] != NULL; k++)
        fprintf(stderr, "%s %s", k > 0 ? "," : "", n.id[k]);
    fputs("\n", stderr);
}

int all_match_claims(const struct patterns *p)
{
    for (int k = 0; k < p->count; k++) {
        struct patterns one = {p->at + k, 1};
        int found = 0;
        for (const claim *c = all_claims; c->name != NULL && !found; c++)
            found = claim_matches(c, &one);
        if (!found) {
            complain_about(p->at[k], STATEMENTS_AND_CLAIMS);
            return 0;
        }
    }
    return 1;
}

int all_match_statements(const struct patterns *p)
{
    for (int k = 0; k < p->count; k++) {
        struct patterns one = {p->at + k, 1};
        int found = 0;
        for (const statement *s = all_statements; s->id != NULL && !found; s++)
            found = statement_matches(s, &one);
        if (!found) {
            complain_about(p->at[k], STATEMENTS_AND_CLAIMS);
            return 0;
        }
    }
    return 1;
}
