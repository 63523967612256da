/* harness.h -- what is asked about a piece of code: a block in Markdown beside it.
 *
 *     :::{exactly} casteljau_is_bernstein
 *     :title: de Casteljau's algorithm computes the Bernstein form
 *     :source: casteljau.c
 *     :declare: double casteljau(int n, const double *p, double t);
 *     :input: p[4]; t in [0, 1]
 *     :call: double R = casteljau(3, p, t);
 *     :expect: R = (1-t)*(1-t)*(1-t)*p[0] + 3*t*(1-t)*(1-t)*p[1] + 3*t*t*(1-t)*p[2] + t*t*t*p[3]
 *     :::
 *
 * source   C, C++, bitcode or an archive of it, from the folder of the file; repeatable
 * flag     of clang, for the sources: -I and -D and the like; separated by blanks
 * include, declare   what the calls need; repeatable
 * input    NAME or NAME[COUNT]: variables; then "= 1 2/3 5" fixed values; "> 0"; "in [0, 1]", "in (a, b)", whose ends are numbers
 *          or earlier inputs, "t" or "k[3]"; "increasing"; "nondecreasing": all patterns of equal neighbours are tried
 * where    a precondition, in C; repeatable
 * call     statements in C, with the inputs as double variables and arrays; repeatable
 * output   "R" or "R[3]": told
 * expect   "R = expression in C", or "R[3] = W", where W is an array
 * printed  an equation between inputs and outputs in the language of cagd check (formula.h), "R_j = \sum_{i=0}^3 B_i^3(t) p_i"; repeatable
 * let, use what other names in these formulas mean, as there: "B_i^n(t) = ...", "bernstein B_i^n(t)"; repeatable
 * for      the ranges of their whole numbers, "j = 0..2"; repeatable
 * known    "curves.c:12 = expression in C": the first number that this line puts into a variable, or "curves.c:12[6] = W": the first six of
 *          them, W being an array of the calls; compared like what is expected, so that it is seen where a calculation goes wrong first
 * points   how many are tried; 20 when absent
 * roots    of what is one that is not rational?  "refuse": it ends the run; "enclose": an interval, and no proof in the field;
 *          else a variable of its own in the field, whose square is known, and an interval at points
 * memcpy   "moves": between pieces of memory that overlap, which C leaves undefined, it does what memmove does, and that is told;
 *          without it such a call is refused
 *
 * A line that begins with a blank continues the one before. */
#ifndef CAGD_CODE_HARNESS_H
#define CAGD_CODE_HARNESS_H

#include <stddef.h>
#include <stdio.h>

enum cagd_code_shape {
    CAGD_CODE_ANY,
    CAGD_CODE_FIXED,
    CAGD_CODE_POSITIVE,
    CAGD_CODE_BETWEEN,
    CAGD_CODE_INCREASING,
    CAGD_CODE_NONDECREASING
};

enum { CAGD_CODE_MOST_IN_HARNESS = 64, CAGD_CODE_MOST_NAME = 11 };

struct cagd_code_asked_input {
    char name[CAGD_CODE_MOST_NAME + 1];
    int count; /* 0: a number alone */
    enum cagd_code_shape shape;
    char **value;     /* fixed: as texts, count or 1 of them                                         */
    char *low, *high; /* between: a number, "t" or "k[3]"                                            */
    int open_low, open_high;
};

/* Lines of one key, with the number of the first. */
struct cagd_code_lines {
    int count, number[CAGD_CODE_MOST_IN_HARNESS];
    char *text[CAGD_CODE_MOST_IN_HARNESS];
};

struct cagd_code_harness {
    struct cagd_code_harness *next;
    char *name, *title; /* title: NULL when there is none */
    int line, points, refuse_roots, enclose_roots, memcpy_moves;
    int notes_stores; /* the program can tell which numbers its lines put into variables: where some are known */
    struct cagd_code_lines source, flag, include, declare, where, call, output, expect, known, let, printed;
    char *ranges; /* for all formulas, with commas between; or "" */
    int inputs;
    struct cagd_code_asked_input input[CAGD_CODE_MOST_IN_HARNESS];
};

struct cagd_code_harness_error {
    int line;
    char cause[300];
};

/* The blocks of a text in their order; NULL and an error when one is wrong or there is none. */
struct cagd_code_harness *cagd_code_read_harness(const char *text, struct cagd_code_harness_error *error);
void cagd_code_harness_free(struct cagd_code_harness *h);

/* The name of an output "R[3]" or "R", whose count is 0; of an expression, which has none, 0. */
int cagd_code_output_name(const char *text, char name[CAGD_CODE_MOST_NAME + 1], int *count);
/* Whether a text is "R[3]", an array with so many elements; R[k], (R[3]) and s.R[3] are one number. */
int cagd_code_is_array(const char *text, long *count);
/* Without blanks at the ends; the caller frees it. */
char *cagd_code_trimmed(const char *start, size_t length);

/* Whether a text is a number: "3", "-3/7", "0.35". */
int cagd_code_is_number(const char *text);

/* How many variables the inputs are. */
int cagd_code_variables(const struct cagd_code_harness *h);
#endif
