#include "cli/manifest.h"

#include "cli/output.h"

#include <jansson.h>
#include <stdio.h>
#include <stdlib.h>

/* How many cases ran and how many values were compared in each number type, and what the certificate has of them. */
static json_t *of_claim(const claim_result *r, const struct recorded *recorded)
{
    json_t *types = json_array(), *cases = json_array();
    for (number_type t = 0; t < NUMBER_TYPES; t++)
        if (r->by[t].ran)
            json_array_append_new(types, json_pack("{s:s, s:i, s:i, s:i, s:i}", "type", number_type_name[t], "cases",
                                                   r->by[t].cases, "compared", r->by[t].compared, "degree_low",
                                                   r->by[t].degree_low, "degree_high", r->by[t].degree_high));
    for (int k = 0; k < recorded->count; k++) {
        const struct recorded_case *x = &recorded->cases[k];
        json_array_append_new(cases, json_pack("{s:s, s:i, s:i, s:i, s:i, s:i, s:i}", "type", number_type_name[x->type],
                                               "degree", x->degree, "inputs", x->inputs, "nodes", x->nodes, "compared",
                                               x->compared, "of_the_same", x->of_the_same, "facts", x->facts));
    }
    return json_pack("{s:s, s:s, s:o, s:o, s:s}", "claim", r->claim->name, "kind", kind_name[r->claim->kind], "types",
                     types, "certificate", cases, "sha256", recorded->digest);
}

static json_t *of_statement(const statement_result *r)
{
    const statement *s = r->statement;
    json_t *links = json_array();
    for (const statement_link *link = s->links; link->claim != NULL || link->text != NULL; link++)
        json_array_append_new(links, json_pack("{s:s, s:s*, s:s*, s:s*}", "role", role_key[link->role], "claim",
                                               link->claim, "place", link->place, "text", link->text));
    char digest[DIGEST], *text = certificate_of_statement(r);
    digest_of_text(text, digest);
    free(text);
    return json_pack("{s:s, s:b, s:s, s:s*, s:o, s:s}", "statement", s->id, "definition", s->is_definition, "printed",
                     s->printed, "corrected", s->corrected, "links", links, "sha256", digest);
}

int write_manifest(const cagd_register *r, const char *folder, const claim_result *results, int count,
                   const struct recorded *recorded)
{
    json_t *claims = json_array(), *statements = json_array();
    for (int k = 0; k < count; k++)
        json_array_append_new(claims, of_claim(&results[k], &recorded[k]));
    for (const statement *s = r->statements; s->id != NULL; s++) {
        statement_result derived = derive(s, results, count);
        if (derived.verdict != VERDICT_OPEN)
            json_array_append_new(statements, of_statement(&derived));
        free_statement_result(&derived);
    }
    json_t *manifest =
        json_pack("{s:s, s:o, s:o}", "schema", "cagd-manifest-1", "claims", claims, "statements", statements);
    char path[4096], *text = json_dumps(manifest, JSON_INDENT(1));
    json_decref(manifest);
    if (text == NULL)
        abort();
    snprintf(path, sizeof path, "%s/manifest.json", folder);
    int bad = write_text_file(path, text);
    free(text);
    return bad;
}
