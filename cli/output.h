/* output.h -- files that are either whole or not there. */
#ifndef CAGD_OUTPUT_H
#define CAGD_OUTPUT_H

#include <stdio.h>

/* Output goes to a temporary file beside `path`, renamed when it is whole.  NULL and a line on
 * stderr when it cannot be written. */
struct output;
struct output *output_open(const char *path);
FILE *output_stream(struct output *o);
/* Puts the file in its place and frees `o`.  This and the next two: 0, or -1 and a line on stderr. */
int output_close(struct output *o);
int write_text_file(const char *path, const char *text);
int make_folder(const char *path); /* with its parents */
#endif
