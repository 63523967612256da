#include "chapters/judge/certificate.h"

#include "chapters/judge/case.h"
#include "exact/record/trace.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_NODES = 8000, MOST_AT_ALL = 100000 }; /* the second where no case has fewer than the first */

/* Case k, recorded behind `before`, unless its program is too long. */
static int record(FILE *out, const char *before, const claim *c, number_type type, int k, size_t most)
{
    struct plan plan = {c, type, 0};
    cagd_trace_open(most);
    trial T = run_case(&plan, k, 0, NULL, NULL);
    forget_exhibits(T.shown, T.exhibits);
    int whole = cagd_trace_nodes() != NULL;
    if (whole)
        fprintf(out, "%s{\"type\":\"%s\",\"degree\":%d,\n\"inputs\":%s,\"nodes\":%s,\"steps\":%s}", before,
                number_type_name[type], T.degree, cagd_trace_inputs(), cagd_trace_nodes(), cagd_trace_steps());
    cagd_trace_close();
    return whole;
}

char *certificate_of_claim(const claim_result *r)
{
    const claim *c = r->claim;
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    if (out == NULL)
        abort();
    fprintf(out,
            "{\"schema\":\"cagd-certificate-1\",\n\"claim\":\"%s\",\n\"kind\":\"%s\",\n\"outcome\":\"%s\","
            "\n\"evidence\":\"%s\",\n"
            "\"cases\":[",
            c->name, kind_name[c->kind], outcome_name[r->outcome], evidence_name[r->evidence]);
    /* What is proved is proved in the field. */
    number_type type = r->evidence == PROVED || c->body[RATIONAL_TYPE] == NULL ? FIELD_TYPE : RATIONAL_TYPE;
    if (c->body[type] != NULL) {
        int k = c->degree_high - c->degree_low;
        while (k >= 0 && !record(out, "", c, type, k, MOST_NODES))
            k--;
        if (k != 0)
            record(out, k > 0 ? ",\n" : "", c, type, 0, k < 0 ? MOST_AT_ALL : MOST_NODES);
    }
    fputs("]}\n", out);
    fclose(out);
    return text;
}

char *certificate_of_statement(const statement_result *r)
{
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    if (out == NULL)
        abort();
    fprintf(out,
            "{\"schema\":\"cagd-certificate-1\",\n\"statement\":\"%s\",\n\"definition\":%s,\n\"verdict\":\"%s\",\n"
            "\"evidence\":\"%s\",\n\"links\":[",
            r->statement->id, r->statement->is_definition ? "true" : "false", verdict_name[r->verdict],
            evidence_name[r->evidence]);
    int first = 1;
    for (const statement_link *link = r->statement->links; link->claim != NULL || link->text != NULL; link++) {
        fprintf(out, "%s{\"role\":\"%s\"", first ? "" : ",\n", role_key[link->role]);
        if (link->claim != NULL)
            fprintf(out, ",\"claim\":\"%s\"", link->claim);
        fputs("}", out);
        first = 0;
    }
    fputs("]}\n", out);
    fclose(out);
    return text;
}
