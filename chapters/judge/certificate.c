#include "chapters/judge/certificate.h"

#include "chapters/judge/case.h"
#include "chapters/judge/memory_text.h"
#include "exact/record/trace.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_NODES = 8000, MOST_AT_ALL = 100000 }; /* the second where no case has fewer than the first */

/* The lists in a list, [[...],[...]]: their number, and where they begin if `at` is not NULL. */
static int lists_in(const char *text, const char **at)
{
    int count = 0, depth = 0, quoted = 0;
    for (; *text != '\0'; text++) {
        quoted ^= *text == '"'; /* no text of a trace has a quotation mark in it */
        if (*text == '[' && !quoted && ++depth == 2) {
            if (at != NULL)
                at[count] = text;
            count++;
        }
        depth -= *text == ']' && !quoted;
    }
    return count;
}

/* How many steps {"same":[i,j],...} compare a node with itself or with one of the same text. */
static int comparisons_of_the_same(const char *nodes, const char *steps)
{
    static const char step[] = "{\"same\":[";
    const char **at = calloc((size_t)lists_in(nodes, NULL) + 1, sizeof *at);
    int count = 0;
    if (at == NULL)
        abort();
    lists_in(nodes, at);
    for (const char *s = strstr(steps, step); s != NULL; s = strstr(s + 1, step)) {
        char *end;
        long i = strtol(s + sizeof step - 1, &end, 10), j = strtol(end + 1, NULL, 10);
        size_t length = strcspn(at[i], "]");
        count += strncmp(at[i], at[j], length + 1) == 0;
    }
    free(at);
    return count;
}

static int facts_in(const char *steps)
{
    int count = 0;
    for (const char *s = steps; (s = strstr(s, "{\"fact\":")) != NULL; s++)
        count++;
    return count;
}

/* Case k, recorded behind `before`, unless its program is too long. */
static int record(FILE *out, const char *before, const claim *c, number_type type, int k, size_t most,
                  struct recorded_case *recorded)
{
    struct plan plan = {c, type, 0, NULL};
    cagd_trace_open(most);
    trial T = run_case(&plan, k, 0, NULL, NULL);
    forget_exhibits(T.shown, T.exhibits);
    int whole = cagd_trace_nodes() != NULL;
    if (whole) {
        const char *nodes = cagd_trace_nodes();
        *recorded = (struct recorded_case){
            .type = type,
            .degree = T.degree,
            .inputs = lists_in(cagd_trace_inputs(), NULL),
            .nodes = lists_in(nodes, NULL),
            .compared = T.compared,
            .of_the_same = comparisons_of_the_same(nodes, cagd_trace_steps()),
            .facts = facts_in(cagd_trace_steps()),
        };
        fprintf(out, "%s{\"type\":\"%s\",\"degree\":%d,\n\"inputs\":%s,\"nodes\":%s,\"steps\":%s}", before,
                number_type_name[type], T.degree, cagd_trace_inputs(), cagd_trace_nodes(), cagd_trace_steps());
    }
    cagd_trace_close();
    return whole;
}

char *certificate_of_claim(const claim_result *r, int *count, struct recorded_case recorded[MOST_RECORDED])
{
    const claim *c = r->claim;
    char *text = NULL;
    size_t size;
    FILE *out = text_open(&text, &size);
    fprintf(out,
            "{\"schema\":\"cagd-certificate-1\",\n\"claim\":\"%s\",\n\"kind\":\"%s\",\n\"outcome\":\"%s\","
            "\n\"evidence\":\"%s\",\n\"argued\":%s,\n"
            "\"cases\":[",
            c->name, kind_name[c->kind], outcome_name[r->outcome], evidence_name[r->computed],
            r->evidence == BY_ARGUMENT ? "true" : "false");
    /* What is proved is proved in the field. */
    int in_field = c->body[FIELD_TYPE] != NULL && c->kind == IDENTITY;
    number_type type = in_field || c->body[RATIONAL_TYPE] == NULL ? FIELD_TYPE : RATIONAL_TYPE;
    *count = 0;
    if (c->body[type] != NULL) {
        int k = c->degree_high - c->degree_low;
        while (k >= 0 && !record(out, "", c, type, k, MOST_NODES, recorded))
            k--;
        *count = k >= 0;
        if (k != 0)
            *count += record(out, k > 0 ? ",\n" : "", c, type, 0, k < 0 ? MOST_AT_ALL : MOST_NODES, recorded + *count);
    }
    fputs("]}\n", out);
    text_close(out, &text);
    return text;
}

char *certificate_of_statement(const statement_result *r)
{
    char *text = NULL;
    size_t size;
    FILE *out = text_open(&text, &size);
    fprintf(out,
            "{\"schema\":\"cagd-certificate-1\",\n\"statement\":\"%s\",\n\"definition\":%s,\n\"verdict\":\"%s\",\n"
            "\"evidence\":\"%s\",\n\"links\":[",
            r->statement->id, r->statement->is_definition ? "true" : "false", verdict_name[r->verdict],
            evidence_name[r->as_printed.evidence]);
    int first = 1;
    for (const statement_link *link = r->statement->links; link->claim != NULL || link->text != NULL; link++) {
        fprintf(out, "%s{\"role\":\"%s\"", first ? "" : ",\n", role_key[link->role]);
        if (link->claim != NULL)
            fprintf(out, ",\"claim\":\"%s\"", link->claim);
        if (link->role == ARGUED)
            fprintf(out, ",\"adds_cases\":%s", link->place[0] != '\0' ? "true" : "false");
        fputs("}", out);
        first = 0;
    }
    fputs("]}\n", out);
    text_close(out, &text);
    return text;
}
