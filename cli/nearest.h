/* nearest.h -- of the names that there are, those that are spelled nearly like a text. */
#ifndef CAGD_NEAREST_H
#define CAGD_NEAREST_H

#include <stdio.h>

enum { NEAREST_NAMES = 3 };
/* Begun as {.text = TEXT}; name[k] is NULL where fewer were near. */
struct nearest {
    const char *text, *name[NEAREST_NAMES];
    int distance[NEAREST_NAMES];
};

/* Near is what contains the text, or differs from it, or without its source, in a quarter of the letters at most and in
 * one more; among equals, what begins alike is nearer. */
void consider_name(struct nearest *n, const char *name);
/* "the nearest: json, junit", with `before` in front of every name; nothing where none is near. */
void put_nearest(FILE *out, const struct nearest *n, const char *before);
#endif
