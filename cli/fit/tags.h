/* tags.h -- the tags of an XML text, one after the other: enough of XML for tracks and drawings. */
#ifndef CAGD_CLI_FIT_TAGS_H
#define CAGD_CLI_FIT_TAGS_H

#include "cli/fit/reader.h"

#include <stddef.h>

struct tag {
    const char *name, *attributes, *end; /* end: its '>' */
    size_t length;                       /* of the name */
    int closes;                          /* </name>     */
};

/* The next tag that is no comment, declaration or character data, and the place in the text behind it; 0 at the end. */
int next_tag(struct reader *r, struct tag *t);
int is_tag(const struct tag *t, const char *name); /* whatever its prefix is */

/* The value of the attribute, from *value to the returned place; NULL where there is none. */
const char *tag_attribute(const struct tag *t, const char *name, const char **value);

/* A number at *s, which is moved behind it; 0 if there is none, or one beyond the range of numbers. */
int read_number(const char **s, const char *end, double *x);
#endif
