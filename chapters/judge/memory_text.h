/* memory_text.h -- a text that is written like a file: whole, or the process ends with abort(), for without memory it would be cut
 * off and nobody would see it. */
#ifndef CAGD_MEMORY_TEXT_H
#define CAGD_MEMORY_TEXT_H

#include <stdio.h>

/* What is written to the stream becomes *text, ended by a zero byte, when the stream is closed; the caller frees it. */
FILE *text_open(char **text, size_t *size);
void text_close(FILE *stream, char *const *text);
#endif
