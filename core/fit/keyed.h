/* keyed.h -- points sorted by a number, such as their foot parameter; equal numbers keep the order of the points. */
#ifndef CAGD_FIT_KEYED_H
#define CAGD_FIT_KEYED_H

typedef struct keyed {
    double key;
    int index; /* of the point */
} keyed;

/* For qsort: by key, then by index. */
int fit_by_key(const void *a, const void *b);
#endif
