/* cagd_exactly.h -- other people's C and C++ called from a program, over exact numbers: load, set, call, get.
 *
 *     struct cagd_exactly_code code = {.source = "curves.c",
 *                                      .declare = "double casteljau(int n, const double *p, double t);",
 *                                      .input = "p[3]; t",
 *                                      .call = "double R = casteljau(2, p, t);",
 *                                      .output = "R"};
 *     struct cagd_exactly *x = cagd_exactly_load(&code, sizeof message, message);
 *     cagd_exactly_set(x, "p", 3, (const char *[]){"0", "1", "1/3"});
 *     cagd_exactly_set(x, "t", 1, (const char *[]){"2/7"});
 *     if (cagd_exactly_call(x, CAGD_EXACTLY_RATIONAL) == CAGD_EXACTLY_DONE)
 *         puts(cagd_exactly_get(x, "R"));
 *
 * The code is compiled by the program cagd-compile-exactly and runs in a process of its own.  No call knows anything of those before it: code
 * that remembers something, or a call that does not end well, costs the next call a new process; else one process serves many
 * calls in rationals.  Texts that are returned live until the next call or until the code is freed. */
#ifndef CAGD_EXACTLY_H
#define CAGD_EXACTLY_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* As the keys of a block of `cagd exactly` are; several files, flags or outputs are separated by blanks, and declarations, statements and
 * preconditions may have several lines.  NULL: none.  source, call and output are needed. */
struct cagd_exactly_code {
    const char *source, *flags, *include, *declare, *input, *where, *call, *output;
};

enum cagd_exactly_numbers {
    CAGD_EXACTLY_RATIONAL, /* fractions; a root that is none is an interval                              */
    CAGD_EXACTLY_FIELD,    /* rational functions of the inputs; comparisons are decided at the values   */
    CAGD_EXACTLY_INTERVAL, /* enclosures                                                                 */
    CAGD_EXACTLY_ROUNDING  /* binary64 beside the exact number                                           */
};

enum cagd_exactly_end {
    CAGD_EXACTLY_DONE,
    CAGD_EXACTLY_OUTSIDE,   /* a precondition is not true, or a value was not set                            */
    CAGD_EXACTLY_UNDEFINED, /* the code divides by zero, or the like                                     */
    CAGD_EXACTLY_REFUSED,   /* something cannot be carried, or memory is used that is not the array's    */
    CAGD_EXACTLY_BOUND,     /* memory, time or the size of a number                                       */
    CAGD_EXACTLY_CRASHED
};

struct cagd_exactly;

/* The code, compiled; NULL and one line of at most `room` bytes.  cagd-compile-exactly is the one that the variable
 * CAGD_COMPILE_EXACTLY of the environment names, else the one beside this program, else the first in PATH. */
struct cagd_exactly *cagd_exactly_load(const struct cagd_exactly_code *code, size_t room, char message[]);
void cagd_exactly_free(struct cagd_exactly *x); /* NULL: nothing */

/* The values of an input, count numbers as texts: "3/7", "-2", "0.1" (a tenth).  0, or -1 when there is no such input of so many, or one
 * is no number. */
int cagd_exactly_set(struct cagd_exactly *x, const char *name, int count, const char *const value[]);

enum cagd_exactly_end cagd_exactly_call(struct cagd_exactly *x, enum cagd_exactly_numbers numbers);

/* Of an output of the last call, "R" or "R[2]": its value, "3/7"; in the field the function at the values; NULL when there is none. */
const char *cagd_exactly_get(const struct cagd_exactly *x, const char *name);
const char *cagd_exactly_function(const struct cagd_exactly *x, const char *name); /* in the field: "p[0]*t+3"      */
double cagd_exactly_computed(const struct cagd_exactly *x,
                             const char *name);                           /* with rounding; NaN when there is none */
double cagd_exactly_ulps(const struct cagd_exactly *x, const char *name); /* of the exact value it is wrong by      */
/* The k-th comparison that the last call made on the inputs, in the field: "t < k[3]"; NULL behind the last. */
const char *cagd_exactly_condition(const struct cagd_exactly *x, int k);
const char *
cagd_exactly_message(const struct cagd_exactly *x); /* why the last call did not end well, with the line; or "" */

#ifdef __cplusplus
}
#endif
#endif
