/* fuzz_latex.c -- LaTeX sources: whatever is in them, every byte that is read comes from a byte of the source, formulas lie within
 * the text and have no line ends; and their blocks are read without end of neither memory nor time. */
#include "proofs-tests/fuzz/file.h"

#include "cli/check/paper.h"
#include "exact/expression/latex.h"
#include "exact/words.h"

#include <string.h>

static void look_at_bytes(const cagd_latex_text *t, int from, int to, int size)
{
    if (from < 0 || from > to || to > t->size)
        abort();
    for (int k = from; k < to; k++)
        if (t->from[k] < 0 || t->from[k] >= size || t->bytes[k] == '\n')
            abort();
}

static void look(const cagd_latex *l, int size)
{
    for (int k = 0; k < l->items; k++) {
        const cagd_latex_item *f = &l->item[k];
        look_at_bytes(&l->text, f->from, f->to, size);
        for (int m = 0; m < f->notes; m++)
            look_at_bytes(&l->text, f->note[m].from, f->note[m].to, size);
        if (f->at < 0 || f->at > size)
            abort();
    }
    for (int k = 0; k < l->troubles; k++)
        if (l->trouble[k].from < 0 || l->trouble[k].from >= l->trouble[k].to || l->trouble[k].to > size + 1)
            abort();
}

/* The blocks, as cagd check makes and reads them. */
static void read_blocks_of(const uint8_t *data, size_t size)
{
    struct document d;
    read_document(NULL, file_of("fuzz.tex", data, size), &d);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (size > 4000)
        return -1;
    cagd_latex l;
    region_faults = 0;
    region_mark mark = region_open();
    cagd_read_latex((const char *)data, (int)size, &l);
    look(&l, (int)size);
    if (size > 0 && data[0] % 4 == 0)
        read_blocks_of(data, size);
    region_drop(mark);
    return 0;
}
