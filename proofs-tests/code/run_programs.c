/* run_programs.c -- runs functions of an object of cagd-compile-exactly, one after another, and prints what they put out.
 *
 *     run_programs rational|enclose|ordered|field|interval|rounding OBJECT.so NAME...
 *
 * A line for each: "NAME: VALUE; VALUE...", or "NAME! MESSAGE (FUNCTION:LINE)".  In the field x and y are variables, at 2/3 and
 * -5/7; elsewhere they are these numbers.  ordered: rational, where addresses of different
 * objects have no order. */
#include "exact/code/run.h"

#include <stdio.h>
#include <string.h>

int main(int argc, char **argv)
{
    static const char *const words[] = {"rational", "field", "interval", "rounding"};
    static const char *const x[] = {"2/3"}, *const y[] = {"-5/7"};
    static const struct cagd_code_input inputs[] = {{"x", 0, x, NULL, 1}, {"y", 0, y, NULL, 1}};
    char message[400];
    if (argc < 3)
        return 2;
    struct cagd_code_job job = {.inputs = 2,
                                .input = inputs,
                                .most_seconds = 20,
                                .most_megabytes = 1024,
                                .most_values = 1 << 20,
                                .enclose = strcmp(argv[1], "enclose") == 0,
                                .one_object = strcmp(argv[1], "ordered") == 0};
    for (int k = 0; k < 4; k++)
        if (strcmp(argv[1], words[k]) == 0)
            job.numbers = (enum cagd_code_numbers)k;
    struct cagd_code_program *p = cagd_code_load(argv[2], sizeof message, message);
    if (p == NULL) {
        fprintf(stderr, "%s\n", message);
        return 2;
    }
    for (int k = 3; k < argc; k++) {
        job.entry = argv[k];
        struct cagd_code_outcome *o = cagd_code_run(p, &job);
        if (o == NULL)
            return 2;
        printf("%s", argv[k]);
        if (o->end != CAGD_CODE_FINISHED)
            printf("! %s (%s:%d)", o->message, o->function, o->line);
        else
            for (struct cagd_code_result *r = o->results; r != NULL; r = r->next)
                printf("%s%s", r == o->results ? ": " : "; ", r->got_field != NULL ? r->got_field : r->got);
        if (o->end == CAGD_CODE_FINISHED && job.numbers == CAGD_CODE_ROUNDING && o->results != NULL)
            printf(" computed %.17g ulps %.6g", o->results->computed, o->results->ulps);
        if (o->end == CAGD_CODE_FINISHED)
            for (struct cagd_code_condition *c = o->conditions; c != NULL; c = c->next)
                printf(" | %s %s %s", c->left, c->relation, c->right);
        putchar('\n');
        cagd_code_outcome_free(o);
    }
    cagd_code_unload(p);
    return 0;
}
