/* terminal.h -- widths and colours. */
#ifndef CAGD_TERMINAL_H
#define CAGD_TERMINAL_H

#include <stdio.h>

enum style { PLAIN, BOLD, DIM, GOOD, BAD, WARN };
/* The escape sequence for the style, or "" unless the stream is a terminal without NO_COLOR. */
const char *style(FILE *stream, enum style s);
int is_terminal(FILE *stream);
/* The width of what is printed: that of the terminal, or what COLUMNS says, but `most` at most, and where neither says
 * anything. */
int page_width(int most);
int message_width(int most);                              /* the same of what goes to stderr      */
const char *end_of_character(const char *utf8);           /* behind the first character           */
int columns_of(const char *utf8);                         /* printed width of a text              */
int columns_between(const char *utf8, const char *end);   /* and of the part of it before `end`   */
void put_padded(FILE *out, const char *utf8, int width);  /* text and blanks up to the width      */
void put_clipped(FILE *out, const char *utf8, int width); /* as much as fits, and " ..." if cut   */
#endif
