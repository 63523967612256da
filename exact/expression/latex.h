/* latex.h -- a LaTeX source: its displayed formulas, with the commands of the author expanded, and what comments say of them.
 *
 *     % cagd: let 0 \le t \le 1                     a line of a block :::{let}
 *     \begin{equation}\label{eq:sum}                a formula, of the name eq:sum
 *       \sum_{i=0}^n \B{i}{n}(t) = 1
 *       % cagd: for n = 1..6                        what is said of it
 *     \end{equation}
 *
 * A comment belongs to the formula in which it stands, in an environment of several rows to its row, also behind the \\ that ends
 * it; on the line on which the environment begins or ends, to all of its rows; one that stands alone, to the environment that comes next.  Every byte of what is read knows the byte of the source it comes
 * from; what a command of the author stands for comes from where the command was called. */
#ifndef CAGD_LATEX_H
#define CAGD_LATEX_H

#include "exact/expression/reading.h"

/* A text that grows, in the region, and for each of its bytes the byte of the source that it comes from. */
typedef struct cagd_latex_text {
    char *bytes;
    int *from;
    int size, room;
} cagd_latex_text;

/* What a comment says: its text behind "cagd:". */
typedef struct cagd_latex_note {
    int from, to; /* bytes of the text; at `from` a word begins */
} cagd_latex_note;

enum { CAGD_LATEX_MOST_NOTES = 16 };

/* A formula, with \label, & and \\ taken out and on one line, or a comment "cagd: let ...". */
typedef struct cagd_latex_item {
    int is_let, is_definition; /* is_definition: it has := or the like, which became = */
    int from, to;              /* bytes of the text                                    */
    int at;                    /* the byte of the source where it begins               */
    const char *name;          /* of its \label, or else of its \tag; NULL without one */
    cagd_latex_note note[CAGD_LATEX_MOST_NOTES];
    int notes;
} cagd_latex_item;

/* What is wrong in the source itself: where, and what. */
typedef struct cagd_latex_trouble {
    int from, to; /* bytes of the source */
    const char *message;
    int is_command; /* a command of the author, which matters where a formula has it, only */
    int is_remark;  /* what is not read, and is none of what was asked for                 */
} cagd_latex_trouble;

typedef struct cagd_latex {
    cagd_latex_text text;
    cagd_latex_item *item;
    int items, item_room;
    cagd_latex_trouble *trouble;
    int troubles, trouble_room;
} cagd_latex;

/* More than this an expansion does not grow to: 8 MB, and less for the fuzzers, whose small inputs reach it. */
#ifdef CAGD_SMALL_LIMITS
enum { CAGD_LATEX_LARGEST = 1 << 14 };
#else
enum { CAGD_LATEX_LARGEST = 1 << 23 };
#endif

/* The formulas of source[0..size).  All is in the region; where there is no memory, the fault MEMORY. */
void cagd_read_latex(const char *source, int size, cagd_latex *out);

/* The source without comments, but for those that begin with "cagd:", and without what is verbatim, the commands of the author
 * expanded; for latex.c and its tests.  What does not end is left as it stands, and is a trouble. */
void cagd_expand_latex(const char *source, int size, cagd_latex_text *out, cagd_latex *troubles);

/* One more byte; one more trouble, or remark. */
void cagd_latex_put(cagd_latex_text *out, char byte, int from);
void cagd_latex_refuse(cagd_latex *out, int from, int to, const char *message);
void cagd_latex_remark(cagd_latex *out, int from, int to, const char *message);
#endif
