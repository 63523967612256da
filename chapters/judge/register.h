/* register.h -- what can be judged: claims, statements, and where they stand.
 *
 * weave writes one register from the chapter files; another one can be made by hand, or while the program runs.  Whatever
 * judges, lists or shows is given a register. */
#ifndef CAGD_REGISTER_H
#define CAGD_REGISTER_H

#include "chapters/judge/claim.h"
#include "chapters/judge/figure.h"

typedef struct chapter {
    const char *name, *title;
} chapter;

/* A text whose statements are decided; `key` stands before the colon of their ids.  No field is NULL; the empty text where
 * nothing is known. */
typedef struct source {
    const char *key, *author, *title, *title_zh, *year, *publisher, *part,
        *letter; /* letter: of degrees; k: of orders */
} source;

/* The data of a claim's block, for the figures: also of a claim without a body in the number types that are compiled in. */
typedef struct block_data {
    const char *claim;
    const datum *data;
} block_data;

/* Each array ends with an entry of NULL name, id, key or claim. */
typedef struct cagd_register {
    const claim *claims;
    const statement *statements;
    const chapter *chapters;
    const figure *figures;
    const source *sources;
    const block_data *data;
    const char *const
        *printed; /* ids of the statements whose formulas are read from their print, too, in the files print*.md of
                                   the chapters; with NULL at the end, or NULL where none are known */
    const char *const *for_every; /* of these the ids of those whose sums are read for every n; likewise */
} cagd_register;
#endif
