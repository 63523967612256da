/* fuzz_formula.c -- files of formulas: what is read has trees whose parts are places of the file, and of one file in 64
 * the values in small cases are found, or are not, without end of neither memory nor time. */
#include "proofs-tests/fuzz/file.h"

#include "cli/check/document.h"
#include "exact/expression/evaluate.h"
#include "exact/words.h"

#include <string.h>

static void look(const cagd_tree *t, int size, int depth)
{
    if (t->from < 0 || t->to > size || t->from > t->to || depth > 4 * CAGD_MOST_DEPTH)
        abort();
    for (int k = 0; k < t->count; k++)
        look(t->at[k], size, depth + 1);
}

static void compute(const struct formula *f, int in_field)
{
    static cagd_context c;
    const cagd_tree *t = f->tree->kind == CAGD_ALL ? f->tree->at[0] : f->tree;
    c = (cagd_context){.scope = &f->scope, .in_field = in_field, .steps = 300};
    for (const cagd_variable *v = f->scope.variables; v != NULL && !c.count; v = v->next)
        if (v->whole)
            cagd_bind(&c, v->head, cagd_value_int(2));
    for (int k = 0; k < t->count && region_faults == 0; k++)
        cagd_evaluate(&c, t->at[k]);
    region_faults = 0;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (size > LARGEST_FILE + 100)
        return -1;
    struct document d;
    region_faults = 0;
    region_mark mark = region_open();
    int complaints = read_document(NULL, file_of("fuzz.md", data, size), &d);
    if (complaints != 0 && d.complaints > complaints)
        abort();
    for (int k = 0; complaints == 0 && k < d.count; k++)
        look(d.formula[k].tree, d.size, 0);
    if (is_one_of_64(data, size)) {
        field_open(12);
        for (int k = 0; complaints == 0 && k < d.count && k < 4; k++)
            compute(&d.formula[k], k % 2);
        field_close();
    }
    region_drop(mark);
    return 0;
}
