/* select.c -- which claims, statements and figures are meant by patterns and ids. */
#include "cli/select.h"

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

static int claim_matches(const cagd_register *r, const claim *c, const struct patterns *p)
{
    if (p->count == 0 || any_name(p, c))
        return 1;
    for (const statement *s = r->statements; s->id != NULL; s++)
        if (names(s, c->name) && any(p, s->id))
            return 1;
    return 0;
}

static int statement_matches(const cagd_register *r, const statement *s, const struct patterns *p)
{
    if (p->count == 0 || any(p, s->id))
        return 1;
    for (const claim *c = r->claims; c->name != NULL; c++)
        if (names(s, c->name) && any_name(p, c))
            return 1;
    return 0;
}

static size_t count_claims(const cagd_register *r)
{
    size_t n = 0;
    while (r->claims[n].name != NULL)
        n++;
    return n;
}

const claim **matching_claims(const cagd_register *r, const struct patterns *p, int *count)
{
    const claim **list = must(calloc(count_claims(r) + 1, sizeof *list));
    *count = 0;
    for (const claim *c = r->claims; c->name != NULL; c++)
        if (claim_matches(r, c, p))
            list[(*count)++] = c;
    return list;
}

const statement **matching_statements(const cagd_register *r, const struct patterns *p, int *count)
{
    size_t n = 0;
    while (r->statements[n].id != NULL)
        n++;
    const statement **list = must(calloc(n + 1, sizeof *list));
    *count = 0;
    for (const statement *s = r->statements; s->id != NULL; s++)
        if (statement_matches(r, s, p))
            list[(*count)++] = s;
    return list;
}

const figure **matching_figures(const cagd_register *r, const struct patterns *p, int *count)
{
    size_t n = 0;
    while (r->figures[n].name != NULL)
        n++;
    const figure **list = must(calloc(n + 1, sizeof *list));
    *count = 0;
    for (const figure *f = r->figures; f->name != NULL; f++)
        if (p->count == 0 || any(p, f->name))
            list[(*count)++] = f;
    return list;
}

const claim **claims_of(const cagd_register *r, const statement *const list[], int statements, int *count)
{
    const claim **claims = must(calloc(count_claims(r) + 1, sizeof *claims));
    *count = 0;
    for (const claim *c = r->claims; c->name != NULL; c++)
        for (int j = 0; j < statements; j++)
            if (names(list[j], c->name)) {
                claims[(*count)++] = c;
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

void complain_about(const cagd_register *r, const char *wanted, enum kind_of_name kind)
{
    struct near n = {{0}, {0}};
    for (const statement *s = r->statements; kind != FIGURES && s->id != NULL; s++)
        consider(&n, wanted, s->id);
    for (const claim *c = r->claims; kind != FIGURES && c->name != NULL; c++)
        consider(&n, wanted, c->name);
    for (const figure *f = r->figures; kind == FIGURES && f->name != NULL; f++)
        consider(&n, wanted, f->name);
    fprintf(stderr, "cagd: no %s is called '%s'; the nearest:", kind == FIGURES ? "figure" : "statement or claim",
            wanted);
    for (int k = 0; k < NEAREST && n.id[k] != NULL; k++)
        fprintf(stderr, "%s %s", k > 0 ? "," : "", n.id[k]);
    fputs("\n", stderr);
}

int all_match(const cagd_register *r, const struct patterns *p, enum kind_of_name kind)
{
    for (int k = 0; k < p->count; k++) {
        const struct patterns one = {p->at + k, 1};
        int count;
        if (kind == CLAIMS)
            free(matching_claims(r, &one, &count));
        else if (kind == STATEMENTS)
            free(matching_statements(r, &one, &count));
        else
            free(matching_figures(r, &one, &count));
        if (count == 0) {
            complain_about(r, p->at[k], kind);
            return 0;
        }
    }
    return 1;
}
