/* reading.h -- what is wrong with a formula: where, what, and what would be understood. */
#ifndef CAGD_READING_H
#define CAGD_READING_H

#include "exact/number/rational.h"

typedef struct cagd_reading_error {
    int from, to; /* the bytes of the text that are meant */
    int of_list;  /* wrong in a list of numbers, which can be nothing else */
    int of_words; /* words that are not understood before a range          */
    char message[240];
} cagd_reading_error;

/* Notes the error unless one is noted; 0, as a reader returns it. */
int cagd_refuse_reading(cagd_reading_error *error, int from, int to, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/* The text s[0..n) with a 0 behind it; in the region.  NULL, and MEMORY, when there is no room. */
const char *cagd_text_of(const char *s, int n);
#endif
