/* finding.h -- what is found of a statement. */
#ifndef CAGD_EXPRESSION_FINDING_H
#define CAGD_EXPRESSION_FINDING_H

#include "exact/expression/every.h"
#include "exact/expression/sign.h"

/* How strong the answer is: an identity of rational functions, or finitely many exact decisions. */
typedef enum cagd_strength { CAGD_BY_NOTHING, CAGD_BY_DECISION, CAGD_BY_IDENTITY } cagd_strength;

/* A name and its value in an example, a number or a root that is none: both live in the region. */
typedef struct cagd_given {
    const char *name;
    cagd_num_q value;
    const struct cagd_root *root; /* NULL, or what the value is instead */
} cagd_given;

typedef struct cagd_finding {
    cagd_answer answer;
    cagd_strength strength;
    long cases, failing, undecided; /* choices of the whole numbers; how many of them fail, or are not decided  */
    int whole_angles; /* the tangents among the names are those of halves, not of quarters (angle.h)      */
    long pieces, comparisons;
    int first_alone; /* of a range without end the first cases hold, and of the others nothing is known */
    int out_of_time; /* not all cases were reached                                              */

    /* The first case that fails.  Where one of its numbers is a root, the sides are not computed, and `order` is the sign of left -
     * right. */
    int has_example, given, has_root, order;
    int is_enclosed; /* they were enclosed, and are near these (enclosed.h) */
    double near_left, near_right;
    cagd_given example[CAGD_MOST_UNKNOWNS];
    cagd_num_q left, right;
    cagd_relation relation; /* the one that does not hold between left and right                       */
    const cagd_tree *of_left, *of_right;

    /* Of the first case that is not decided: why, and at which part of which formula; empty or NULL where nothing is known. */
    const char *why;
    const cagd_tree *where;
    const cagd_tree *supposed; /* NULL, or ranges behind the formula, which count as supposed */

    /* The names that stand for all numbers, or all within their bounds; the bounds are used by `bounded` statements alone. */
    int names, bounded;
    const char *name[CAGD_MOST_UNKNOWNS];
    int for_every; /* it was proved for every number of a range without end: the first ones, and by `every`  */
    cagd_every every;
    int changes, noticed,
        open; /* ways in which the statement was changed (change.h), how many of them fail, and how many are not decided */
    int says_nothing;     /* it holds however it is changed, or by its form alone (vacuous.h)                  */
    int leaves_out_poles; /* said of where both sides are defined: there are values where one is not     */
    cagd_sums_met sums;   /* those without terms are over nothing in every case                             */
    int one_sided;        /* derivatives were taken at the end of where a function is defined, from inside */
} cagd_finding;
#endif
