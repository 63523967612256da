#include "cli/check/certificate.h"

#include "chapters/judge/memory_text.h"
#include "cli/check/verdict.h"
#include "exact/expression/certify.h"
#include "exact/words.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The cases, as they come. */
struct cases {
    const char *type;
    json_t *list, *listed;
    json_int_t compared;
};

/* Whether node k is made of values whose making was not noted, which recheck.py takes as told: told[] says it of the nodes before. */
static int is_told(const json_t *node, size_t k, const char told[])
{
    const char *op = json_string_value(json_array_get(node, 0));
    int is = op == NULL || strcmp(op, "f") == 0;
    if (!is && strcmp(op, "x") != 0 && strcmp(op, "c") != 0)
        for (size_t m = 1; m < json_array_size(node); m++)
            if ((size_t)json_integer_value(json_array_get(node, m)) < k)
                is |= told[json_integer_value(json_array_get(node, m))];
    return is;
}

/* Whether of each comparison one side is made of inputs and constants alone, so that the other is checked also where it is a derivative,
 * an integral or a value at a place, of which what came out is told and not how; and of a sum for every n its first values.  A number
 * that is told says nothing. */
static int says_enough(const json_t *one)
{
    const json_t *nodes = json_object_get(one, "nodes"), *steps = json_object_get(one, "steps"), *node, *step;
    size_t k;
    char *told = region_bytes(json_array_size(nodes) + 1);
    if (told == NULL)
        return 0;
    json_array_foreach(nodes, k, node)
    {
        if (strcmp(json_string_value(json_array_get(node, 0)), "o") == 0)
            return 0;
        told[k] = (char)is_told(node, k, told);
    }
    json_array_foreach(steps, k, step)
    {
        const json_t *sides = json_object_get(step, "same"), *side;
        int alone = json_object_get(step, "parameter") != NULL; /* differences, each of another relation */
        size_t m, of_told = 0;
        sides = sides != NULL ? sides : json_object_get(step, "of");
        json_array_foreach(sides, m, side) of_told += told[json_integer_value(side)] != 0;
        if (of_told > 0 && (alone || of_told == json_array_size(sides)))
            return 0;
        const json_t *rows = json_object_get(step, "left"), *row;
        json_array_foreach(rows, m, row) if (told[json_integer_value(row)]) return 0;
    }
    return json_array_size(steps) > 0;
}

static int take(void *data, const char *inputs, const char *nodes, const char *steps)
{
    struct cases *c = data;
    json_t *row,
        *one = certified_case(c->type, (int)json_array_size(c->list), (const char *[]){inputs, nodes, steps}, &row);
    int enough = says_enough(one);
    c->compared += json_integer_value(json_object_get(row, "compared"));
    json_array_append_new(c->list, one);
    json_array_append_new(c->listed, row);
    return enough;
}

/* The name of its certificate. */
static const char *file_name(const struct certifying *c, const char *name)
{
    char *text = region_bytes(CERTIFIED_NAME);
    if (text != NULL)
        certified_name(c, name, text);
    return text;
}

static void drop_cases(struct cases *c)
{
    json_decref(c->list);
    json_decref(c->listed);
}

/* "\sum_i B_i = 1; every $n = 1$ to $12$", or the numbers for which it fails. */
static char *printed(const struct document *d, const struct formula *s, const cagd_finding *f)
{
    char *text = NULL;
    size_t room;
    FILE *out = text_open(&text, &room);
    fputs(s->printed, out);
    if (f->answer == CAGD_HOLDS) {
        const char *scope = scope_of_finding(d, s, f);
        fprintf(out, "%s%s", scope[0] != '\0' ? " for " : "", scope);
    }
    for (int k = 0; f->answer == CAGD_FAILS && k < f->given; k++)
        fprintf(out, "%s%s = %s", k == 0 ? "; fails for " : ", ", f->example[k].name, value_text(&f->example[k]));
    text_close(out, &text);
    return text;
}

int certify_formula(struct certifying *c, const struct document *d, const struct formula *s, const cagd_finding *f,
                    const char **name)
{
    int fails = f->answer == CAGD_FAILS, proved = f->strength == CAGD_BY_IDENTITY;
    struct cases all = {fails ? "rational" : "field", json_array(), json_array(), 0};
    char *text = printed(d, s, f); /* the texts of what was found are in an older field */
    *name = file_name(c, s->name);
    if (*name == NULL || text == NULL)
        abort();
    int bad = 0;
    if (cagd_certify(&s->scope, s->tree, f, s->seconds, take, &all)) {
        struct certified one = {.name = *name,
                                .printed = text,
                                .kind = fails    ? "counterexample"
                                        : proved ? "identity"
                                                 : "decision",
                                .outcome = fails ? "fails" : "holds",
                                .evidence = !fails && proved ? "proved" : "decided",
                                .cases = all.list,
                                .listed = all.listed,
                                .compared = all.compared,
                                .number = (json_int_t)json_array_size(all.list),
                                .type = all.type};
        bad = certify_statement(c, &one);
    } else {
        *name = NULL;
        drop_cases(&all);
    }
    free(text);
    return bad;
}

int certify_values(struct certifying *c, const struct formula *s, const cagd_found *f, const char **name)
{
    struct cases all = {"field", json_array(), json_array(), 0};
    char *text = NULL; /* the texts of what was found are in an older field */
    size_t room;
    FILE *out = text_open(&text, &room);
    fprintf(out, "%s holds for %s, and for no other", s->printed, values_of(s, f));
    text_close(out, &text);
    *name = file_name(c, s->name);
    if (*name == NULL)
        abort();
    int bad = 0;
    if (f->known && cagd_certify_found(&s->scope, s->tree, s->find, s->seconds, take, &all)) {
        struct certified one = {.name = *name,
                                .printed = text,
                                .kind = "decision",
                                .outcome = "holds",
                                .evidence = "decided",
                                .cases = all.list,
                                .listed = all.listed,
                                .compared = all.compared,
                                .number = (json_int_t)json_array_size(all.list),
                                .type = all.type};
        bad = certify_statement(c, &one);
    } else {
        *name = NULL;
        drop_cases(&all);
    }
    free(text);
    return bad;
}
