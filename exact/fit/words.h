/* words.h -- short words for the intervals of this folder, besides those of exact/words.h. */
#ifndef CAGD_EXACT_FIT_WORDS_H
#define CAGD_EXACT_FIT_WORDS_H

#include "exact/number/interval.h"
#include "exact/words.h"

#define square_i      cagd_square_i
#define inner_i       cagd_inner_i
#define from_double_i cagd_from_double_i
#define between_i     cagd_between_i
#define around_i      cagd_around_i
#define exp_around_i  cagd_exp_around_i
#define hull_i        cagd_hull_i
#define nearest_in_i  cagd_nearest_in_i
#define size_i        cagd_size_i
#endif
