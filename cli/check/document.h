/* document.h -- a file of formulas: Markdown, with blocks that say what names mean and what is stated.
 *
 *     :::{let}                                   :::{statement} partition
 *     B_i^n(t) = \binom{n}{i} t^i (1-t)^{n-i}    :printed: \sum_{i=0}^n B_i^n(t) = 1
 *     -1 \le \lambda \le 1                       :for: n = 1..12
 *     :::                                        :::
 *
 * A block knows what the blocks above it said.  A line that begins with a blank goes on with the line before it. */
#ifndef CAGD_CLI_CHECK_DOCUMENT_H
#define CAGD_CLI_CHECK_DOCUMENT_H

#include "exact/expression/read.h"

enum { MOST_STATEMENTS = 1000 };

/* What a file says is to come out, where it says so. */
enum expected { EXPECT_HOLDS, EXPECT_FAILS, EXPECT_UNDECIDED, EXPECT_NOTHING };
extern const char *const expected_name[];

struct formula {
    const char *name, *printed; /* as it is written, TeX                             */
    int line, at;               /* of the block; the byte where the formula begins   */
    enum expected expected;
    const char *find; /* the name for whose values the statement is asked, or NULL */
    double seconds;
    cagd_scope scope; /* with what :for: says */
    const cagd_tree *tree;
};

struct document {
    const char *path, *text;
    int size, complaints;
    cagd_scope scope;
    struct formula *formula;
    int count;
};

/* Reads the file; "-" is standard input.  Whatever is wrong goes to stderr, each with file, line, column and a caret below it:
 * their number.  All is in the region. */
int read_document(const char *path, struct document *d);

/* Line and column of a byte, from 1; columns count characters. */
void place_of(const struct document *d, int at, int *line, int *column);
#endif
