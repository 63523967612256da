/* select.c -- which claims, statements and figures are meant by patterns and ids. */
#include "cli/select.h"
#include "cli/names.h"

#include <ctype.h>
#include <fnmatch.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

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

size_t table_length(const char *id)
{
    const char *row = strstr(id, "-row-");
    return row != NULL ? (size_t)(row - id) : 0;
}

int id_matches(const char *pattern, const char *id)
{
    const char *colon = strchr(id, ':');
    size_t table = table_length(id);
    return fnmatch(pattern, id, 0) == 0 || (colon != NULL && is_glob(pattern) && fnmatch(pattern, colon + 1, 0) == 0) ||
           (table > 0 && strlen(pattern) == table && strncmp(pattern, id, table) == 0);
}

static int any_id(const struct patterns *p, const char *id)
{
    for (int k = 0; k < p->count; k++)
        if (id_matches(p->at[k], id))
            return 1;
    return 0;
}

int is_glob(const char *text) { return strpbrk(text, "*?[") != NULL; }

/* Letters compare whatever their case is; a word of other letters may begin anywhere. */
int is_in_title(const char *text, const char *title, const char *title_zh)
{
    enum { SHORTEST = 3 }; /* bytes: one Chinese character */
    size_t length = strlen(text);
    if (length < SHORTEST || is_glob(text))
        return 0;
    for (const char *at = title; at != NULL && *at != '\0'; at++)
        if (strncasecmp(at, text, length) == 0 && (at == title || !isalnum((unsigned char)at[-1])))
            return 1;
    return title_zh != NULL && strstr(title_zh, text) != NULL;
}

static int any_title(const struct patterns *p, const char *title, const char *title_zh)
{
    for (int k = 0; k < p->count; k++)
        if (is_in_title(p->at[k], title, title_zh))
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
    if (p->count == 0 || any_name(p, c) || any_title(p, c->title, c->title_zh))
        return 1;
    for (const statement *s = r->statements; s->id != NULL; s++)
        if (names(s, c->name) && any_id(p, s->id))
            return 1;
    return 0;
}

static int statement_matches(const cagd_register *r, const statement *s, const struct patterns *p)
{
    if (p->count == 0 || any_id(p, s->id) || any_title(p, s->title, s->title_zh))
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
        if (count > 0)
            continue;
        const char *meant = name_meant_by(r, p->at[k], kind);
        if (meant == NULL)
            return 0;
        p->at[k] = (char *)meant;
    }
    return 1;
}
