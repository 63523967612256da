/* decide.h -- what a harness asks is answered: at points, in the field, and what rounding costs. */
#ifndef CAGD_CODE_DECIDE_H
#define CAGD_CODE_DECIDE_H

#include "exact/code/points.h"

enum cagd_code_word {
    CAGD_CODE_PROVED,    /* equal in the field, under each of the lists of conditions                        */
    CAGD_CODE_SAMPLED,   /* equal at all points that were tried                                              */
    CAGD_CODE_ENCLOSED,  /* never different; some results are known as intervals only                        */
    CAGD_CODE_DIFFERS,   /* a point where a result is another                                                */
    CAGD_CODE_UNDECIDED, /* something could not be carried, or a bound was met                               */
    CAGD_CODE_COMPUTED   /* nothing was expected                                                             */
};

/* One way through the code: a point that goes it, and what the field says there; field: NULL when it was not asked. */
struct cagd_code_path {
    unsigned long long hash;
    struct cagd_code_point *point;
    struct cagd_code_outcome *field;
    int proved;
};

/* The worst of one result in binary64. */
struct cagd_code_worst {
    char name[64], line[300];
    double ulps, part; /* of the error that arises at the line, from 0 to 1 */
    struct cagd_code_point *point;
    double computed;
    char exact[64];
    long by_chance;                               /* points taken by chance, at which the error is a number:     */
    double mean, mean_in_order[CAGD_CODE_ORDERS]; /* its mean there, as the code does its sums and in others */
};

enum { CAGD_CODE_MOST_PATHS = 256, CAGD_CODE_MOST_WORST = 64 };

struct cagd_code_verdict {
    enum cagd_code_word word;
    long points, outside;         /* tried with result; where a precondition is not true */
    long undefined;               /* points where the code divides by zero, or the like               */
    struct cagd_code_point *hole; /* the first of them; NULL: none                                      */
    char hole_message[1000];
    long patterns, seen; /* of equal neighbours, and with how many of them a point was found        */
    int paths, proved;   /* ways through the code that were met; in the field                       */
    int untold;          /* ways beyond those in the list                                           */
    struct cagd_code_path path[CAGD_CODE_MOST_PATHS];
    int exhaustive;  /* no inputs that satisfy the preconditions take another way: proved for all of them */
    int closed;      /* branches that no inputs take, which is proved                                     */
    char open[1000]; /* not exhaustive: a branch of which it is not known, or why                         */
    struct cagd_code_point *point;     /* that differs, or that could not be done, or was computed            */
    struct cagd_code_outcome *outcome; /* of that point                                                  */
    char message[1000];                /* why it is not proved, or not decided; else empty               */
    int worsts;
    long rounded, turned; /* points in binary64; comparisons there that rounding turned                 */
    char turned_at[300];
    char overlapping_at[300]; /* the first memcpy between pieces that overlap, on the ways above; or empty        */
    struct cagd_code_worst worst[CAGD_CODE_MOST_WORST];
};

/* points, at least 1; rounding: how many points in binary64, 0 for none. */
struct cagd_code_verdict *cagd_code_decide(const struct cagd_code_program *p, const struct cagd_code_harness *h,
                                           long points, long rounding);
/* The path once more, with its operations noted (run.h: trace); the caller's. */
struct cagd_code_outcome *cagd_code_certify(const struct cagd_code_program *p, const struct cagd_code_harness *h,
                                            const struct cagd_code_path *path);
/* A verdict that differs, and the same harness built so that its stores are noted: its outcome is told once more with what is apart
 * first (run.h), where what is expected is calculated by code, too. */
void cagd_code_look_apart(const struct cagd_code_program *noting, const struct cagd_code_harness *h,
                          struct cagd_code_verdict *v);
void cagd_code_verdict_free(struct cagd_code_verdict *v);
#endif
