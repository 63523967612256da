#include "cli/certify.h"

#include "cli/digest.h"
#include "cli/output.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int certify_begin(struct certifying *c, const char *folder, const char *part)
{
    const char *const parts[] = {"claims", part};
    *c = (struct certifying){folder, part, json_array(), json_array()};
    for (int k = 0; k < 2; k++) {
        char path[4096];
        snprintf(path, sizeof path, "%s/%s", folder, parts[k]);
        if (make_folder(path) != 0)
            return -1;
    }
    return 0;
}

static int is_taken(const struct certifying *c, const char *name)
{
    for (size_t k = 0; k < json_array_size(c->claims); k++) {
        const json_t *claim = json_object_get(json_array_get(c->claims, k), "claim");
        if (strcmp(json_string_value(claim), name) == 0)
            return 1;
    }
    return 0;
}

/* Where it is taken, with the first number behind it, from that of the claim on, for which it is not. */
void certified_name(const struct certifying *c, const char *name, char text[CERTIFIED_NAME])
{
    enum { LONGEST = 200 };
    size_t n = 0;
    for (; n < LONGEST && name[n] != '\0'; n++)
        text[n] = isalnum((unsigned char)name[n]) || (n > 0 && strchr("-_.", name[n]) != NULL) ? name[n] : '-';
    text[n] = '\0';
    for (size_t number = json_array_size(c->claims) + 1; is_taken(c, text); number++)
        snprintf(text + n, CERTIFIED_NAME - n, "-%zu", number);
}

/* FOLDER/PART/NAME.json; its digest. */
static int write_json(const struct certifying *c, const char *part, const char *name, json_t *document,
                      char digest[DIGEST])
{
    char path[4096], *text = json_dumps(document, JSON_COMPACT);
    json_decref(document);
    if (text == NULL)
        abort();
    snprintf(path, sizeof path, "%s/%s%s%s.json", c->folder, part, *part != 0 ? "/" : "", name);
    digest_of_text(text, digest);
    int bad = write_text_file(path, text);
    free(text);
    return bad;
}

json_t *certified_case(const char *type, int number, const char *const trace[3], json_t **listed)
{
    json_t *inputs = json_loads(trace[0], 0, NULL), *nodes = json_loads(trace[1], 0, NULL),
           *steps = json_loads(trace[2], 0, NULL), *step;
    size_t k;
    int facts = 0, of_the_same = 0;
    json_array_foreach(steps, k, step)
    {
        json_t *same = json_object_get(step, "same");
        facts += json_object_get(step, "fact") != NULL;
        if (same != NULL)
            of_the_same += json_equal(json_array_get(nodes, (size_t)json_integer_value(json_array_get(same, 0))),
                                      json_array_get(nodes, (size_t)json_integer_value(json_array_get(same, 1))));
    }
    *listed = json_pack("{s:s, s:i, s:I, s:I, s:I, s:i, s:i}", "type", type, "degree", number, "inputs",
                        (json_int_t)json_array_size(inputs), "nodes", (json_int_t)json_array_size(nodes), "compared",
                        (json_int_t)json_array_size(steps) - facts, "of_the_same", of_the_same, "facts", facts);
    return json_pack("{s:s, s:i, s:o, s:o, s:o}", "type", type, "degree", number, "inputs", inputs, "nodes", nodes,
                     "steps", steps);
}

/* A way as a case, and what the manifest says of it; NULL where its operations were not noted. */
static json_t *case_of(const struct cagd_code_outcome *o, int number, json_t **listed)
{
    if (o->end != CAGD_CODE_FINISHED || o->trace[2] == NULL)
        return NULL;
    return certified_case("field", number, o->trace, listed);
}

int certify_statement(struct certifying *c, const struct certified *s)
{
    char digest[DIGEST], name[400];
    int holds = strcmp(s->outcome, "holds") == 0;
    int bad = write_json(c, "claims", s->name,
                         json_pack("{s:s, s:s, s:s, s:s, s:s, s:b, s:o}", "schema", "cagd-certificate-1", "claim",
                                   s->name, "kind", s->kind, "outcome", s->outcome, "evidence", s->evidence, "argued",
                                   0, "cases", s->cases),
                         digest);
    json_t *types = json_pack("[{s:s, s:I, s:I, s:i, s:I}]", "type", s->type, "cases", s->number, "compared",
                              s->compared, "degree_low", 0, "degree_high", s->number - 1);
    json_array_append_new(c->claims, json_pack("{s:s, s:s, s:o, s:o, s:s}", "claim", s->name, "kind", s->kind, "types",
                                               types, "certificate", s->listed, "sha256", digest));
    json_t *links = json_pack("[{s:s, s:s}]", "role", holds ? "holds-by" : "refuted-by", "claim", s->name);
    snprintf(name, sizeof name, "%s:%s", c->part, s->name);
    bad =
        bad || write_json(c, c->part, s->name,
                          json_pack("{s:s, s:s, s:b, s:s, s:s, s:O}", "schema", "cagd-certificate-1", "statement", name,
                                    "definition", 0, "verdict", s->outcome, "evidence", s->evidence, "links", links),
                          digest) != 0;
    json_array_append_new(c->statements, json_pack("{s:s, s:b, s:s, s:o, s:s}", "statement", name, "definition", 0,
                                                   "printed", s->printed, "links", links, "sha256", digest));
    return bad ? -1 : 0;
}

/* What the block asks, as the manifest prints it. */
static char *printed(const struct cagd_code_harness *h, const struct cagd_code_verdict *v)
{
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    if (out == NULL)
        abort();
    for (int k = 0; k < h->expect.count; k++)
        fprintf(out, "%s%s", k > 0 ? "; " : "", h->expect.text[k]);
    for (int k = 0; k < h->printed.count; k++)
        fprintf(out, "%s%s", h->expect.count + k > 0 ? "; " : "", h->printed.text[k]);
    if (h->ranges[0] != 0)
        fprintf(out, ", %s", h->ranges);
    for (int k = 0; k < h->let.count; k++)
        fprintf(out, "%s%s", k > 0 ? "; " : ", where ", h->let.text[k]);
    fprintf(out, " on %s%d ways through the code", v->exhaustive ? "all " : "", v->paths);
    for (int k = 0; k < v->paths; k++) {
        fprintf(out, "; way %d:", k);
        for (const struct cagd_code_condition *c = v->path[k].field->conditions; c != NULL; c = c->next)
            if (c->given || !c->implied)
                fprintf(out, " %s %s %s,", c->left, c->relation, c->right);
    }
    if (fclose(out) != 0)
        abort();
    return text;
}

int certify_block(struct certifying *c, const struct cagd_code_program *p, const struct cagd_code_harness *h,
                  const struct cagd_code_verdict *v)
{
    if (v->word != CAGD_CODE_PROVED)
        return 0;
    json_t *cases = json_array(), *listed = json_array();
    json_int_t compared = 0;
    for (int k = 0; k < v->paths; k++)
        for (const struct cagd_code_result *r = v->path[k].field->results; r != NULL; r = r->next)
            compared += r->wanted != NULL;
    for (int k = 0; k < v->paths; k++) {
        struct cagd_code_outcome *o = cagd_code_certify(p, h, &v->path[k]);
        json_t *row = NULL, *one = case_of(o, k, &row);
        cagd_code_outcome_free(o);
        if (one == NULL) { /* all ways, or no certificate */
            json_array_clear(cases);
            json_array_clear(listed);
            break;
        }
        json_array_append_new(cases, one);
        json_array_append_new(listed, row);
    }
    char *text = printed(h, v), name[CERTIFIED_NAME];
    certified_name(c, h->name, name);
    struct certified proved = {name, text, "identity", "holds", "proved", cases, listed, compared, v->paths, "field"};
    int bad = certify_statement(c, &proved);
    free(text);
    return bad;
}

int certify_end(struct certifying *c)
{
    char digest[DIGEST];
    return write_json(
        c, "", "manifest",
        json_pack("{s:s, s:o, s:o}", "schema", "cagd-manifest-1", "claims", c->claims, "statements", c->statements),
        digest);
}
