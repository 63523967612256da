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

#include "exact/expression/basis.h"
#include "exact/expression/read.h"

struct cagd_register;
struct statement;
/* The fuzzers are compiled with smaller limits, which their small inputs reach. */
#ifdef CAGD_SMALL_LIMITS
enum { MOST_STATEMENTS = 6, MOST_SHEETS = 2, MOST_CHUNKS = 4, LARGEST_FILE = 2000 };
#else
enum { MOST_STATEMENTS = 1000, MOST_SHEETS = 100, MOST_CHUNKS = 1000, LARGEST_FILE = 1 << 22 };
#endif
enum { MOST_SHOWN = 3 };

/* What a file says is to come out, where it says so. */
enum expected { EXPECT_HOLDS, EXPECT_FAILS, EXPECT_UNDECIDED, EXPECT_NOTHING };
extern const char *const expected_name[];

/* Text that is read, and comes from another place than it stands at: byte k from byte from[k] of the source. */
struct chunk {
    int at, to; /* bytes of the document's text */
    const char *path, *source;
    int size; /* of the source */
    const int *from;
};

/* A labelled formula of a LaTeX source that nobody asked for, and that could not be read. */
struct left_out {
    const char *name, *message;
    int line, column;
};

/* The last place whose line was asked for: the next one is mostly behind it. */
struct place {
    const char *text;
    int at, line, column;
};

struct formula {
    const char *name, *printed;    /* as it is written, TeX                             */
    const struct statement *entry; /* of the ledger, whose print it is; or NULL         */
    int line, at;                  /* of the block; the byte where the formula begins   */
    enum expected expected;
    const char *find; /* the name for whose values the statement is asked, or NULL */
    double seconds;
    cagd_scope scope; /* with what :for: says */
    const cagd_tree *tree;
};

/* Functions about which everything is asked that bases are asked about:
 *
 *     :::{basis} corrected
 *     :functions: \hat B_i(t)
 *     :for: i = 0..7, 0 \le t \le 1
 *     :find: \beta                        the parameter, if there is one
 *     :at: -21/4, 0, 1                     its values in the picture, if they are given
 *     ::: */
struct sheet {
    const char *name, *functions; /* as they are written, TeX                                          */
    int line, index_from, index_to, argument_from, argument_to; /* where in `functions` these stand     */
    const char *index, *argument, *find;
    long first, last;
    double seconds;
    cagd_scope scope;
    const cagd_tree *tree; /* of the functions                                                          */
    cagd_num_q shown[MOST_SHOWN];
    int shown_count;
};

/* A formula of the ledger, read from what the ledger has as printed; it is expected to fail where the ledger refutes it:
 *
 *     :::{printed} wang-ch4:formula-4.4.22
 *     :for: k = 1..5, r = k, j = 0..k-1
 *     :part: 2                             of several formulas between dollar signs the second; "1, 3": both
 *     :without: \text{all }x               a piece that is left out, which has to be there
 *     :before: f =                         what is put before it
 *     ::: */

/* A definition with a name in it that is not known yet: it waits for one behind it, up to the next statement. */
enum { MOST_WAITING = 40 };
struct waiting {
    int from, to;
    const char *left_out;     /* NULL, or the name under which it is left out: nobody said that it is to be read */
    cagd_reading_error error; /* where it is given up */
};

struct document {
    const struct cagd_register *reg; /* NULL: no ledger */
    const char *path, *text;
    char *room; /* the text, and behind it formulas of the ledger */
    int size, used, complaints;
    const char *entry; /* of the ledger, that is being read */
    struct place *last_place;
    struct chunk *chunk;
    int chunks;
    const struct paper *papers; /* the LaTeX sources that were read */
    struct left_out *left_out;
    int left_outs;
    int unlabelled; /* displayed formulas of a paper without a label, which nobody asked for */
    struct waiting waiting[MOST_WAITING];
    int waits;
    const char *failed[MOST_WAITING]; /* what lines would have defined that were not understood */
    int faileds;
    cagd_scope scope;
    struct formula *formula;
    struct sheet *sheet;
    int count, sheets;
};

/* Reads the file; "-" is standard input.  Whatever is wrong goes to stderr, each with file, line, column and a caret below it:
 * their number.  All is in the region. */
int read_document(const struct cagd_register *reg, const char *path, struct document *d);

/* Line and column of a byte, from 1, in the file that it comes from, which comes out; columns count characters. */
const char *place_of(const struct document *d, int at, int *line, int *column);

/* The same of byte `at` of any text. */
void count_lines(const struct document *d, const char *text, int at, int *line, int *column);

/* The line on stderr, the line of the file if it is not too long, and a caret under what is meant; counted. */
void complain(struct document *d, int from, int to, const char *format, ...) __attribute__((format(printf, 4, 5)));
/* The same of bytes of a file of that name and text. */
void complain_in(struct document *d, const char *path, const char *text, int size, int from, int to, const char *format,
                 ...) __attribute__((format(printf, 7, 8)));

/* The same, and not counted. */
void remark_in(struct document *d, const char *path, const char *text, int size, int from, int to, const char *message);

/* Text behind what the document has; 0 where there is no room.  The whole of a file in the region, "-" being standard input: its size, or
 * -1 and the line on stderr. */
int put_in_document(struct document *d, const char *text, int length);
int read_whole_file(const char *path, char **text);
#endif
