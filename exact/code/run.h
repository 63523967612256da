/* run.h -- rewritten code is run: in a process of its own, with bounds, and what it did is told. */
#ifndef CAGD_CODE_RUN_H
#define CAGD_CODE_RUN_H

#include "exact/code/machine.h"

#include <stddef.h>

enum cagd_code_numbers { CAGD_CODE_RATIONAL, CAGD_CODE_FIELD, CAGD_CODE_INTERVAL, CAGD_CODE_ROUNDING };

/* Inputs of one name; values are texts of rationals.  In the field those that are `variable` are variables, named "p[2]", or "t"
 * where count is 0, which stands for a single number; the value is the point's. */
struct cagd_code_input {
    const char *name;
    int count;
    const char *const *value;
    const int *like; /* element k is the variable of element like[k] <= k; NULL: each its own */
    int variable;
};

struct cagd_code_job {
    const char *entry; /* the function void entry(void) that is run            */
    enum cagd_code_numbers numbers;
    int certify; /* in the field: note the operations, for others to do them again */
    int enclose; /* a root or an exponential that is no rational: an interval (rationals only); else refused */
    int no_root_variables; /* in the field such a root is refused: it is wanted as an interval          */
    int memcpy_moves;      /* memcpy between pieces that overlap does what memmove does; else it is refused */
    int one_object;        /* addresses of different objects are not ordered, and not taken from one another: refused */
    int note_results;      /* in rationals: what each operation comes to is told                          */
    int inputs;
    const struct cagd_code_input *input;
    long most_values, most_bits, most_seconds, most_megabytes; /* 0: as usual                      */
    int print;                                                 /* its standard output is ours, else standard error */
    void (*before)(void); /* called in the process of the code before anything of it is there: what it may do is bounded
                             further; NULL: nothing                                                       */
};

enum cagd_code_end {
    CAGD_CODE_FINISHED,
    CAGD_CODE_OUTSIDE,   /* a precondition is not true of these inputs                       */
    CAGD_CODE_UNDEFINED, /* there is no value: a division by zero, the root of a negative number */
    CAGD_CODE_REFUSED,   /* something cannot be carried                                      */
    CAGD_CODE_BOUND,     /* memory, time or the size of a number                              */
    CAGD_CODE_CRASHED    /* a signal                                                          */
};

/* A comparison that depends on the variables: the code ran under "left relation right". */
struct cagd_code_condition {
    struct cagd_code_condition *next;
    const char *left, *relation, *right, *difference, *opposite; /* left - right, right - left as texts, or ""    */
    const char *polynomial; /* of the sign of left - right, with whole coefficients, or ""; that sign is one of */
    int holding;            /* the sum of 1 for 0, 2 for 1, 4 for -1                                            */
    int given;              /* of a precondition                                         */
    int implied;            /* by the preconditions: nothing that need be said           */
    struct cagd_code_place place;
};

/* Orders in which a run with rounding does its sums once more. */
enum cagd_code_order { CAGD_CODE_SMALLEST_FIRST, CAGD_CODE_LARGEST_FIRST, CAGD_CODE_IN_HALVES, CAGD_CODE_ORDERS };

/* One number that was put out, or compared with one that was wanted. */
enum cagd_code_answer { CAGD_CODE_EQUAL, CAGD_CODE_DIFFERENT, CAGD_CODE_UNKNOWN };
struct cagd_code_result {
    struct cagd_code_result *next;
    const char *name;                     /* "R[2]"                                                             */
    const char *got, *wanted;             /* at the point; wanted: NULL for an output                          */
    const char *got_field, *wanted_field; /* in the field, else NULL                                           */
    enum cagd_code_answer same;           /* in the field: as functions                                        */
    double computed, ulps;                /* with rounding: the binary64, and its error in ulps of the exact value */
    double in_order[CAGD_CODE_ORDERS];    /* with rounding: the error in ulps with the sums in another order    */
    const char *worst_line;               /* "file:line" where most of the error arises, or NULL               */
    double worst_part;                    /* that line's part of the sum of the amounts, 0 to 1                */
    long stored;                          /* a known intermediate value: the which number stored it was; else 0 */
    const char *variable;                 /* and into what, or ""                                              */
};

/* The first number that a variable does not get in two versions of a calculation: its `time`-th, by line `place` and `other_place`. */
struct cagd_code_apart {
    const char *name;
    long time;
    const char *place, *other_place, *got, *other_got;
};

/* What an operation came to, in their order. */
struct cagd_code_computed {
    struct cagd_code_computed *next;
    const char *value, *file;
    int line;
    unsigned long long operation; /* the same for results of one operation in the code */
};

struct cagd_code_outcome {
    enum cagd_code_end end;
    char message[400];
    char file[300], function[200];
    int line; /* 0: unknown                                                                           */
    struct cagd_code_result *results;
    struct cagd_code_condition *conditions; /* each once                                             */
    const char *denominators;               /* what is divided by, a line each; NULL: nothing that varies */
    const char *trace[3];                   /* certified: inputs, nodes and steps, as trace.h has them; else NULL   */
    unsigned long long path;                /* two runs that decided alike have the same              */
    long operations, decided_otherwise;     /* the latter: comparisons that rounding turned           */
    struct cagd_code_place turned;          /* the first of them                                      */
    long overlapping;                       /* calls of memcpy between pieces that overlap                     */
    const struct cagd_code_apart *apart;    /* where stores were noted; else, or where nothing is apart, NULL    */
    char overlapping_at[300];               /* "file:line" of the first of them                                */
    struct cagd_code_computed
        *computed;  /* where results were noted, all of them; else, or where there are too many, NULL */
    char kept[100]; /* the first variable of static storage that is put into, or ""    */
    int whole_line;                         /* the first that makes a whole number of what varies, or 0                   */
    int kept_line;  /* where; 0: a function of the library did it                      */
};

struct cagd_code_program;
/* NULL, and a message of at most `room` bytes, when it cannot be loaded. */
struct cagd_code_program *cagd_code_load(const char *path, size_t room, char message[]);
void cagd_code_unload(struct cagd_code_program *p);
/* In the process of the code: the descriptor from which it is loaded. */
int cagd_code_descriptor(void);

/* Runs it.  The outcome is the caller's, to be given back; NULL without memory. */
struct cagd_code_outcome *cagd_code_run(const struct cagd_code_program *p, const struct cagd_code_job *job);
void cagd_code_outcome_free(struct cagd_code_outcome *o);
#endif
