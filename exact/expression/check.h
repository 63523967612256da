/* check.h -- a statement, read into a tree, is decided: proved, refuted by an example, or neither.
 *
 * It is looked at for every choice of its whole numbers.  An equality is decided in the field, where it holds for all values of
 * the other names at once, and refuted by small rationals, with which both sides are computed again; an inequality is
 * decided where the names have bounds (sign.h).  Where a case of a definition changes within the bounds, the parts and the
 * number between them are looked at one by one. */
#ifndef CAGD_CHECK_H
#define CAGD_CHECK_H

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
    cagd_given example[CAGD_MOST_UNKNOWNS];
    cagd_num_q left, right;
    cagd_relation relation; /* the one that does not hold between left and right                       */
    const cagd_tree *of_left, *of_right;

    /* Of the first case that is not decided: why, and at which part of which formula; empty or NULL where nothing is known. */
    const char *why;
    const cagd_tree *where;

    /* The names that stand for all numbers, or all within their bounds; the bounds are used by `bounded` statements alone. */
    int names, bounded;
    const char *name[CAGD_MOST_UNKNOWNS];
    int for_every; /* it was proved for every number of a range without end: the first ones, and by `every`  */
    cagd_every every;
    int changes, noticed; /* ways in which the statement was changed (change.h), and how many of them fail      */
    int says_nothing;     /* it holds however it is changed, or by its form alone (vacuous.h)                  */
    int leaves_out_poles; /* said of where both sides are defined: there are values where one is not     */
    cagd_sums_met sums;   /* those without terms are over nothing in every case                             */
    int one_sided;        /* derivatives were taken at the end of where a function is defined, from inside */
} cagd_finding;

/* The statement, within so many seconds.  The field is opened anew: no element of an earlier one may be alive.  What is found
 * lives in the region. */
void cagd_check(const cagd_scope *scope, const cagd_tree *statement, double seconds, cagd_finding *out);

/* What was found, once more, with its operations noted as exact/record/trace.h has them: each case of equalities that hold, or the
 * example with its two sides.  The texts of one case; 0 ends it. */
typedef int cagd_take_case(void *data, const char *inputs, const char *nodes, const char *steps);
/* 1; 0 where a certificate does not say it all: inequalities whose box would be cut into too many parts, or whose names are tied to one
 * another; cases that were cut into parts, implications, and values whose making is not noted on either side, such as two
 * derivatives.  The field is opened anew. */
int cagd_certify(const cagd_scope *scope, const cagd_tree *statement, const cagd_finding *found, double seconds,
                 cagd_take_case *take, void *data);

/* A statement that holds is changed in many ways, for so many seconds; what becomes of it is noted in *out. */
void cagd_check_changes(const cagd_scope *scope, const cagd_tree *statement, double seconds, cagd_finding *out);

/* For which values of the parameter, a declared name without indices, the statement holds for all other names within their bounds: each case
 * of the whole numbers gives constraints of one other name at most.  In `cells` the numbers where it begins or ceases to hold are
 * among others; breaking[k] has the whole numbers of the case that breaks cell k first.  With `poles`, a number for which a divisor is 0
 * whatever the other names are is none for which it holds. */
typedef struct cagd_found {
    int known; /* 0: not found, and `why` says what was in the way */
    const char *why;
    const cagd_tree *where;
    long cases;
    cagd_side_of_box domain;
    cagd_cells cells;
    int wholes;
    const char *name_of_witness[CAGD_MOST_CUTS + 1]; /* of which name cells.witness is a value, or NULL */
    cagd_given breaking[CAGD_MOST_CUTS + 1][8];
} cagd_found;
void cagd_find(const cagd_scope *scope, const cagd_tree *statement, const char *parameter, int poles, double seconds,
               cagd_found *out);

/* Whether the name occurs in the statement, or in the definitions that it uses. */
int cagd_depends_on(const cagd_scope *scope, const cagd_tree *statement, const char *head);
/* The whole numbers that the statement depends on, in the order in which they were declared; their number. */
int cagd_whole_numbers(const cagd_scope *scope, const cagd_tree *statement, const cagd_variable *list[], int room);
#endif
