/* driver.c -- the C that calls what is handed in; see lab.h. */
#include "cli/lab/lab.h"

#include "exact/code/driver.h"

#include <stdlib.h>
#include <string.h>

/* The driver of one case, whose function becomes lab_body_K; behind the call the inputs are told once more: they stay what
 * they were. */
static void write_case(const struct lab_case *c, FILE *out)
{
    static const char entry[] = "void cagd_code_entry(void)\n{";
    char *text = NULL;
    size_t size;
    FILE *whole = open_memstream(&text, &size);
    cagd_code_write_driver(c->h, LAB_DRIVER, whole);
    fclose(whole);
    char *at = strstr(text, entry), *end = strrchr(text, '}');
    if (at == NULL || end == NULL)
        abort();
    fprintf(out, "%.*sstatic void lab_body_%d(void)\n{%.*s", (int)(at - text), text, c->number,
            (int)(end - at - (ptrdiff_t)strlen(entry)), at + strlen(entry));
    for (int k = 0; k < c->h->inputs; k++) {
        const struct cagd_code_asked_input *in = &c->h->input[k];
        if (in->count > 0)
            fprintf(out, "    cagd_code_output(\"%s\", %d, %s);\n", in->name, in->count, in->name);
    }
    fputs("}\n", out);
    free(text);
}

int lab_write_driver(const struct lab *lab, const char *path)
{
    FILE *out = fopen(path, "w");
    if (out == NULL)
        return -1;
    for (int k = 0; k < lab->cases; k++)
        write_case(&lab->at[k], out);
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
