/* layout.h -- paragraphs of text and formulas, filled to a width; a matrix takes as many lines as it has rows.
 *
 * In the text a matrix is MATRIX, its bracket ( [ | or {, its cells divided by NEXT_CELL and its rows by NEXT_ROW, and
 * MATRIX_END: tex_to_layout (cli/tex.h) makes such text.  TIE is a blank at which no line ends. */
#ifndef CAGD_LAYOUT_H
#define CAGD_LAYOUT_H

#include <stdio.h>

enum { MATRIX = 1, NEXT_CELL = 2, NEXT_ROW = 3, MATRIX_END = 4, TIE = 5 };

/* Words separated by blanks, each line behind `indent` blanks and up to the column `width`; a CJK character may be
 * followed by a break.  A matrix that is wider than a line, or stands in another one, is written in one line. */
void put_paragraph(FILE *out, const char *utf8, int indent, int width);
/* The same behind what already stands in the first line, up to the column `indent`. */
void put_hanging(FILE *out, const char *utf8, int indent, int width);
/* "name   = value": the name takes `columns`, the value has its further lines below its first one, or, where that would be in
 * the right half of the page, all of them below the name.  No line ends within the parentheses of a point. */
void put_value(FILE *out, const char *name, const char *value, int indent, int columns, int width);
/* The same text with every matrix in one line, as (a, b; c, d).  The caller frees. */
char *in_one_line(const char *text);
#endif
