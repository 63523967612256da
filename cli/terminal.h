/* terminal.h -- widths and colours. */
#ifndef CAGD_TERMINAL_H
#define CAGD_TERMINAL_H

#include <stdio.h>

enum style { PLAIN, BOLD, DIM, GOOD, BAD, WARN };
/* The escape sequence for the style, or "" unless the stream is a terminal without NO_COLOR. */
const char *style(FILE *stream, enum style s);
int is_terminal(FILE *stream);
int columns_of(const char *utf8);                                       /* printed width of a text              */
void put_padded(FILE *out, const char *utf8, int width);                /* text and blanks up to the width      */
void put_clipped(FILE *out, const char *utf8, int width);               /* as much as fits, and " ..." if cut   */
void put_paragraph(FILE *out, const char *utf8, int indent, int width); /* filled lines            */
#endif
