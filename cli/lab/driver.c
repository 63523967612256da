/* driver.c -- the C that calls what is handed in; see lab.h. */
#include "cli/lab/lab.h"

#include "exact/code/driver.h"

#include <stdlib.h>
#include <string.h>

void lab_write_body(const struct cagd_code_harness *h, const char *name, const char *tail, FILE *out)
{
    static const char entry[] = "void cagd_code_entry(void)\n{";
    char *text = NULL;
    size_t size;
    FILE *whole = open_memstream(&text, &size);
    cagd_code_write_driver(h, LAB_DRIVER, whole);
    fclose(whole);
    char *at = strstr(text, entry), *end = strrchr(text, '}');
    if (at == NULL || end == NULL)
        abort();
    fprintf(out, "%.*svoid %s(void)\n{%.*s%s}\n", (int)(at - text), text, name,
            (int)(end - at - (ptrdiff_t)strlen(entry)), at + strlen(entry), tail);
    free(text);
}

void lab_write_case(const struct lab_case *c, const struct cagd_code_harness *h, const char *name, FILE *out)
{
    char *tail = NULL;
    size_t size;
    FILE *inputs = open_memstream(&tail, &size);
    for (int k = 0; k < c->h->inputs; k++) {
        const struct cagd_code_asked_input *in = &c->h->input[k];
        if (in->count > 0)
            fprintf(inputs, "    cagd_code_output(\"%s\", %d, %s);\n", in->name, in->count, in->name);
    }
    fclose(inputs);
    lab_write_body(h, name, tail, out);
    free(tail);
}

int lab_write_driver(const struct lab *lab, const char *path)
{
    FILE *out = fopen(path, "w");
    if (out == NULL)
        return -1;
    for (int k = 0; k < lab->cases; k++) {
        char name[40];
        snprintf(name, sizeof name, "lab_body_%d", k);
        fprintf(out, "static void %s(void);\n", name);
        lab_write_case(&lab->at[k], lab->at[k].h, name, out);
    }
    for (int k = 0; k < lab->cases; k++)
        fprintf(out,
                "void lab_entry_%d(void);\nvoid lab_entry_%d(void) { lab_body_%d(); }\nvoid lab_again_%d(void);\n"
                "void lab_again_%d(void) { lab_body_%d(); lab_body_%d(); lab_body_%d(); }\n",
                k, k, k, k, k, lab->at[k].earlier, k, k);
    fputs("#ifdef LAB_NATIVE\nvoid (*const lab_table[])(void) = {", out);
    for (int k = 0; k < lab->cases; k++)
        fprintf(out, "lab_entry_%d, ", k);
    fputs("};\n#endif\n", out);
    return fclose(out);
}
