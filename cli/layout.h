/* layout.h -- paragraphs of text and formulas, filled to a width; a matrix takes as many lines as it has rows.
 *
 * In the text a matrix is MATRIX, its bracket ( [ | or {, or ROWS for formulas below one another, its cells divided by
 * NEXT_CELL and its rows by NEXT_ROW, and MATRIX_END: tex_to_layout (cli/tex.h) makes such text.  TIE is a blank at which
 * no line ends. */
#ifndef CAGD_LAYOUT_H
#define CAGD_LAYOUT_H

#include <stdio.h>

enum { MATRIX = 1, NEXT_CELL = 2, NEXT_ROW = 3, MATRIX_END = 4, TIE = 5, ROWS = 6 };

/* Words separated by blanks, each line behind `indent` blanks and up to the column `width`; a CJK character may be
 * followed by a break.  A matrix that is wider than a line, or stands in another one, is written in one line. */
void put_paragraph(FILE *out, const char *utf8, int indent, int width);
/* The same behind `used` columns of the first line that are printed already. */
void put_behind(FILE *out, const char *utf8, int used, int indent, int width);
/* "name   = value": a name of at most `columns` takes so many, and the value has its further lines below its first one.  No
 * line ends within the parentheses of a point. */
void put_value(FILE *out, const char *name, const char *value, int indent, int columns, int width);
/* The same text with every matrix in one line, as (a, b; c, d).  The caller frees. */
char *in_one_line(const char *text);
#endif
