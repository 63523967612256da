/* junit.c -- results as JUnit XML. */
#include "cli/output.h"
#include "cli/report.h"

#include <stdio.h>
#include <stdlib.h>

static void put_xml(FILE *out, const char *s)
{
    for (; *s != '\0'; s++)
        switch (*s) {
        case '<':
            fputs("&lt;", out);
            break;
        case '>':
            fputs("&gt;", out);
            break;
        case '&':
            fputs("&amp;", out);
            break;
        case '"':
            fputs("&quot;", out);
            break;
        default:
            fputc(*s, out);
        }
}

static double seconds_of(const claim_result *r)
{
    double sum = 0;
    for (number_type t = 0; t < NUMBER_TYPES; t++)
        sum += r->by[t].seconds;
    return sum;
}

int write_junit(const char *path, const claim_result *results, int count)
{
    struct output *o = output_open(path);
    if (o == NULL)
        return -1;
    FILE *out = output_stream(o);
    int failures = 0;
    double total = 0;
    for (int k = 0; k < count; k++) {
        failures += !results[k].as_expected;
        total += seconds_of(&results[k]);
    }
    fprintf(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    fprintf(out, "<testsuite name=\"cagd verify\" tests=\"%d\" failures=\"%d\" errors=\"0\" time=\"%.3f\">\n", count,
            failures, total);
    for (int k = 0; k < count; k++) {
        const claim_result *r = &results[k];
        fprintf(out, "  <testcase classname=\"%s\" name=\"%s\" time=\"%.3f\"", r->claim->chapter, r->claim->name,
                seconds_of(r));
        if (r->as_expected) {
            fputs("/>\n", out);
            continue;
        }
        char *line = exhibits_line(r);
        const type_result *b = speaking_type(r);
        fprintf(out, ">\n    <failure message=\"%s, expected otherwise\">", outcome_name[r->outcome]);
        put_xml(out, line);
        if (b != NULL)
            fprintf(out, "%sseed %016llx", line[0] != '\0' ? "; " : "", (unsigned long long)b->seed);
        char *small = line_of_exhibits(r->witness, r->witnesses);
        fputs(small[0] != '\0' ? "; small instance: " : "", out);
        put_xml(out, small);
        fputs("</failure>\n  </testcase>\n", out);
        free(line), free(small);
    }
    fputs("</testsuite>\n", out);
    return output_close(o);
}
