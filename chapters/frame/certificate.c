#include "chapters/frame/certificate.h"

#include "chapters/frame/case.h"
#include "exact/trace.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_NODES = 8000 };

static const char *const kind_name[] = {"identity", "decision", "counterexample"};
static const char *const role_name[] = {"holds-by", "refuted-by", "corrected-by", "hypothesis",
                                        "needs",    "reading",    "checked-by"};

/* One case, recorded.  In the field only the signs of coefficients are of interest, `steps` alone is written.  Returns
 * whether the program was short enough. */
static int record(FILE *out, const claim *c, number_type type, int k)
{
    struct plan plan = {c, type, 0};
    trace_open(MOST_NODES);
    trial T = run_case(&plan, k, 0, NULL, NULL);
    forget_exhibits(T.shown, T.exhibits);
    int whole = trace_nodes() != NULL;
    if (whole && type == FIELD_TYPE)
        fprintf(out, ",\n\"field_steps\":%s", trace_steps());
    else if (whole)
        fprintf(out, "{\"degree\":%d,\n\"inputs\":%s,\"nodes\":%s,\"steps\":%s", T.degree, trace_inputs(),
                trace_nodes(), trace_steps());
    trace_close();
    return whole;
}

static int record_case(FILE *out, const claim *c, int k)
{
    if (!record(out, c, RATIONAL_TYPE, k))
        return 0;
    if (c->body[FIELD_TYPE] != NULL)
        record(out, c, FIELD_TYPE, k);
    fputs("}", out);
    return 1;
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
    if (c->body[RATIONAL_TYPE] != NULL) {
        int k = c->degree_high - c->degree_low;
        while (k >= 0 && !record_case(out, c, k))
            k--;
        if (k > 0) {
            fputs(",\n", out);
            record_case(out, c, 0);
        }
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
        fprintf(out, "%s{\"role\":\"%s\"", first ? "" : ",\n", role_name[link->role]);
        if (link->claim != NULL)
            fprintf(out, ",\"claim\":\"%s\"", link->claim);
        fputs("}", out);
        first = 0;
    }
    fputs("]}\n", out);
    fclose(out);
    return text;
}
