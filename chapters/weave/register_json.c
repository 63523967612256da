/* register_json.c -- the register as JSON: what the tests, the planter of faults and the book read.
 *
 *     {"schema": "cagd-register-1", "lists": {...}, "chapters": [...], "sources": [...], "figures": [...],
 *      "statements": [{"id", "chapter", "file", "line", "options": [[key, value], ...], "note"}, ...],
 *      "claims": [{"name", "chapter", "file", "line", "body": line, "kind", "types": [...], "options": [[key, value], ...],
 *                  "data": [{"place", "name", "rows", "columns", "values"}, ...]}, ...]} */
#include "chapters/weave/book.h"

#include <jansson.h>
#include <stdio.h>
#include <string.h>

static json_t *strings(const struct list *l)
{
    json_t *a = json_array();
    for (int k = 0; k < l->count; k++)
        json_array_append_new(a, json_string(l->at[k]));
    return a;
}

static json_t *options_json(const struct block *b)
{
    json_t *a = json_array();
    for (int k = 0; k < b->options; k++)
        json_array_append_new(a, json_pack("[s, s]", b->option[k].key, b->option[k].value));
    return a;
}

static json_t *data_json(const struct block *b)
{
#define KEY(tag, key) key,
    static const char *const places[] = {DATA_LIST(KEY)};
#undef KEY
    json_t *a = json_array();
    for (int k = 0; k < b->entries; k++) {
        const struct entry *e = &b->entry[k];
        json_array_append_new(a, json_pack("{s:s, s:s, s:i, s:i, s:o}", "place", places[e->place], "name", e->name,
                                           "rows", e->rows, "columns", e->columns, "values", strings(&e->values)));
    }
    return a;
}

#define NAME(tag, name, suffix, kernels) #name,
#define KIND(tag, name)                  name,
#define ROLE(tag, key, form)             key,
#define CLASS(name)                      name,
static const char *const type_names[] = {NUMBER_TYPE_LIST(NAME)};
static const char *const kind_names[] = {KIND_LIST(KIND)};

static json_t *claim_json(const struct book *book, const struct block *b)
{
    int body = 0;
    json_t *types = json_array();
    for (int k = 0; k < book->bodies; k++)
        if (strcmp(book->body[k].name, b->name) == 0)
            body = book->body[k].line;
    for (number_type t = 0; t < NUMBER_TYPES; t++)
        if (has_type(book, b, t))
            json_array_append_new(types, json_string(type_names[t]));
    return json_pack("{s:s, s:s, s:s, s:i, s:i, s:i, s:s, s:o, s:o, s:o}", "name", b->name, "chapter", b->chapter,
                     "file", b->file, "line", b->line, "end", b->end, "body", body, "kind",
                     kind_of(b) < KINDS ? kind_names[kind_of(b)] : "", "types", types, "options", options_json(b),
                     "data", data_json(b));
}

static json_t *other_json(const struct block *b, const char *name)
{
    return json_pack("{s:s, s:s, s:s, s:i, s:o, s:s}", name, b->name, "chapter", b->chapter, "file", b->file, "line",
                     b->line, "options", options_json(b), "note", b->note);
}

static json_t *words(int count, const char *const word[])
{
    json_t *a = json_array();
    for (int k = 0; k < count; k++)
        json_array_append_new(a, json_string(word[k]));
    return a;
}

static json_t *lists_json(void)
{
    static const char *const roles[] = {ROLE_LIST(ROLE)}, *const classes[] = {CLASS_LIST(CLASS)};
    return json_pack("{s:o, s:o, s:o, s:o}", "types", words(NUMBER_TYPES, type_names), "kinds",
                     words(KINDS, kind_names), "roles", words(ROLES, roles), "classes",
                     words(sizeof classes / sizeof *classes, classes));
}

int write_register_json(const struct book *book, const char *path)
{
    json_t *chapters = json_array(), *claims = json_array(), *statements = json_array(), *sources = json_array();
    for (int k = 0; k < book->chapters.count; k++)
        json_array_append_new(chapters,
                              json_pack("{s:s, s:s}", "name", book->chapters.at[k], "title", book->titles.at[k]));
    for (int k = 0; k < book->blocks; k++) {
        const struct block *b = &book->block[k];
        if (b->kind == CLAIM_BLOCK)
            json_array_append_new(claims, claim_json(book, b));
        else if (b->kind == STATEMENT_BLOCK)
            json_array_append_new(statements, other_json(b, "id"));
        else if (b->kind == SOURCE_BLOCK)
            json_array_append_new(sources, other_json(b, "key"));
    }
    json_t *whole = json_pack("{s:s, s:o, s:o, s:o, s:o, s:o, s:o}", "schema", "cagd-register-1", "lists", lists_json(),
                              "chapters", chapters, "sources", sources, "figures", strings(&book->figures),
                              "statements", statements, "claims", claims);
    int bad = whole == NULL || json_dump_file(whole, path, JSON_INDENT(1)) != 0;
    json_decref(whole);
    if (bad)
        fprintf(stderr, "%s: cannot be written\n", path);
    return bad ? -1 : 0;
}
