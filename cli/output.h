/* output.h -- files that are either whole or not there. */
#ifndef CAGD_OUTPUT_H
#define CAGD_OUTPUT_H

#include <stdio.h>

/* Output goes to a temporary file beside `path`, renamed when it is whole.  NULL and a line on
 * stderr when it cannot be written. */
struct output;
struct output *output_open(const char *path);
FILE *output_stream(struct output *o);
int output_close(struct output *o); /* 0 when the file is in place                                 */
int write_text_file(const char *path, const char *text);
int make_folder(const char *path); /* with its parents; 0 on success                              */
#endif
