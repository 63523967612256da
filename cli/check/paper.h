/* paper.h -- LaTeX sources: a document of their own, or where a file of formulas takes its formulas from.
 *
 * A source becomes the blocks of a document (document.h): a comment "% cagd: let ..." and a formula that defines become blocks of
 * meanings, a formula with a label or comments becomes a statement.  Comments begin with
 *
 *     statement NAME, for, find, expected, seconds, title, without    as the lines of a block of a statement
 *     definition                                                      the formula says what its left side means
 *     skip                                                            the formula is not read
 *
 * A labelled formula without a comment is tried: where it cannot be read it is left out, and that is told. */
#ifndef CAGD_CLI_CHECK_PAPER_H
#define CAGD_CLI_CHECK_PAPER_H

#include "cli/check/document.h"

/* Whether it is a LaTeX source: by its name, or where it has none by what it contains. */
int is_paper(const char *path, const char *text, int size);

/* The document's text, which is a LaTeX source, is replaced by its blocks. */
void put_paper(struct document *d);

/* "paper.tex eq:label", in text[from..to): the formula of that label is put behind the document's text, at *begin..*end; the file is looked
 * for beside the document.  0 and a complaint where there is none. */
int put_from_paper(struct document *d, int from, int to, int *begin, int *end);

/* What is wrong with the command of the author at that byte of the source; NULL where nothing is. */
const char *trouble_of_command(const struct document *d, const char *source, int at);
#endif
