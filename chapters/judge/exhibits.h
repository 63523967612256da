/* exhibits.h -- numbers as they are shown. */
#ifndef CAGD_EXHIBITS_H
#define CAGD_EXHIBITS_H

#include "chapters/judge/claim.h"
#include "core/number/num_measured.h"
#include "exact/number/field.h"
#include "exact/number/interval.h"
#include "exact/number/rational.h"
#include "exact/words.h"

/* The number as text, which lives in the region: a rational as 3/7, an interval by its ends, a rational function by its
 * formula, cut where it is too long to be read. */
const char *text_f(num_f a);
const char *text_q(num_q a);
const char *text_i(num_i a);
const char *text_m(num_m a);

/* Exhibit count rows of dim numbers that are texts already. */
void show_written(trial *T, const char *name, int count, int dim, const char *const number[]);
#endif
