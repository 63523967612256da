/* junit.c -- results as JUnit XML. */
#include "cli/junit.h"
#include "chapters/judge/memory_text.h"
#include "cli/output.h"
#include "cli/report.h"
#include "cli/xml.h"

#include <stdio.h>
#include <stdlib.h>

static double seconds_of(const claim_result *r)
{
    double sum = 0;
    for (number_type t = 0; t < NUMBER_TYPES; t++)
        sum += r->by[t].seconds;
    return sum;
}

struct junit {
    FILE *cases;
    char *text;
    size_t room;
    int count, failures;
    double seconds;
};

struct junit *junit_new(void)
{
    struct junit *j = calloc(1, sizeof *j);
    if (j == NULL)
        abort();
    j->cases = text_open(&j->text, &j->room);
    return j;
}

void junit_add(struct junit *j, const char *group, const char *name, double seconds, const char *failure,
               const char *text)
{
    j->count++;
    j->seconds += seconds;
    fputs("  <testcase classname=\"", j->cases);
    put_xml(j->cases, group);
    fputs("\" name=\"", j->cases);
    put_xml(j->cases, name);
    fprintf(j->cases, "\" time=\"%.3f\"", seconds);
    if (failure == NULL) {
        fputs("/>\n", j->cases);
        return;
    }
    j->failures++;
    fputs(">\n    <failure message=\"", j->cases);
    put_xml(j->cases, failure);
    fputs("\">", j->cases);
    put_xml(j->cases, text);
    fputs("</failure>\n  </testcase>\n", j->cases);
}

int junit_write(struct junit *j, const char *suite, const char *path)
{
    text_close(j->cases, &j->text);
    struct output *o = output_open(path);
    int bad = o == NULL ? -1 : 0;
    if (o != NULL) {
        FILE *out = output_stream(o);
        fprintf(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
        fprintf(out, "<testsuite name=\"%s\" tests=\"%d\" failures=\"%d\" errors=\"0\" time=\"%.3f\">\n", suite,
                j->count, j->failures, j->seconds);
        fputs(j->text, out);
        fputs("</testsuite>\n", out);
        bad = output_close(o);
    }
    free(j->text);
    free(j);
    return bad;
}

/* What a claim shows that is not as expected, in one line. */
static char *line_of_failure(const claim_result *r)
{
    const type_result *b = speaking_type(r);
    char *line = exhibits_line(r), *small = line_of_exhibits(r->witness, r->witnesses), *text = NULL;
    size_t room;
    FILE *out = text_open(&text, &room);
    fputs(line, out);
    if (b != NULL)
        fprintf(out, "%sseed %016llx", line[0] != '\0' ? "; " : "", (unsigned long long)b->seed);
    fprintf(out, "%s%s", small[0] != '\0' ? "; small instance: " : "", small);
    text_close(out, &text);
    free(line), free(small);
    return text;
}

int write_junit(const char *path, const claim_result *results, int count)
{
    struct junit *j = junit_new();
    for (int k = 0; k < count; k++) {
        const claim_result *r = &results[k];
        char *failure = not_expected(r), *text = r->as_expected ? NULL : line_of_failure(r);
        junit_add(j, r->claim->chapter, r->claim->name, seconds_of(r), r->as_expected ? NULL : failure, text);
        free(failure);
        free(text);
    }
    return junit_write(j, "cagd verify", path);
}
