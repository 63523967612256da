/* figure_data.h -- the data that stand in the block of a claim, for the figures that draw them. */
#ifndef CAGD_FIGURE_DATA_H
#define CAGD_FIGURE_DATA_H

#include "chapters/judge/register.h"
#include "exact/number/rational.h"
#include "exact/words.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

extern const cagd_register compiled_chapters; /* a figure belongs to a chapter that is compiled in */

/* out[0..count*dim): what stands under `name` in the data of the claim, count rows of dim numbers, row after row.  Ends the
 * program where there is no such entry, for then figure and claim have been parted. */
static inline void data_of(const char *claim_name, const char *name, int count, int dim, num_q out[])
{
    for (const block_data *b = compiled_chapters.data; b->claim != NULL; b++)
        for (const datum *d = strcmp(b->claim, claim_name) == 0 ? b->data : NULL; d != NULL && d->name != NULL; d++)
            if (d->place == IN_DATA && strcmp(d->name, name) == 0 && d->rows == count && d->columns == dim) {
                for (int k = 0; k < count * dim; k++)
                    out[k] = from_string_q(d->value[k]);
                return;
            }
    fprintf(stderr, "cagd: no %d x %d numbers %s in the data of %s\n", count, dim, name, claim_name);
    abort();
}
#endif
