/* scope.h -- for which cases something was decided: a set of cases, told by what it asks of a case.
 *
 * "n = 1 to 6; the distinct knots variables; all points and positive weights, every t": the numbers n are in a range, the phrase
 * is true, and the data are whatever they are, the weights as long as they are positive.  What needs several claims was
 * decided for the cases that all of them were decided for: for the intersection of their scopes.
 *
 * Of two phrases one may be the narrower: the option `within` of a chapter's letters says of which, "simple knots | every
 * pattern of the knots", or "* | all coefficients" of one that leaves nothing out.  The narrower one is left.  Where each of two claims has a phrase with which the other one's cannot
 * be compared, they are about different things, steps of a proof for instance, and their scopes are apart: the degree
 * alone is common to them, and every step is told with its own; up to three of their phrases stand beside it in brackets.
 * So are one instance and a range of cases; and more than four kinds of data of which no claim has all are told as far as several
 * claims have them.
 *
 * What a claim takes for granted of its data, its option `where` ("the weights are not 0"), is part of its scope like everything
 * else: what needs several claims holds where all their conditions do.  A condition sets no two claims apart.
 *
 * The degree has one range, whatever letter it has: a source of letter k counts orders, which are one more.  Another letter
 * of the option `degrees` is a number of its own. */
#ifndef CAGD_SCOPE_H
#define CAGD_SCOPE_H

#include "chapters/judge/run.h"

enum { WITHOUT_END = 1 << 30 };

typedef struct whole_range {
    char letter[16]; /* empty: the degree */
    int low, high;   /* high may be WITHOUT_END */
} whole_range;

/* Data that may have any value, or any positive one. */
typedef struct quantity {
    char *noun;         /* "points", "t"; NULL: those that the claim does not name */
    int many, positive; /* many: "all points", else "every t"                      */
    int claims;         /* how many claims have it                                 */
} quantity;

typedef struct phrases {
    char **at;
    int count;
} phrases;

typedef struct scope {
    whole_range *range;
    quantity *data;
    phrases said, where; /* of which cases, and under which conditions on the data         */
    int ranges, kinds;
    int instances; /* random instances; 0 where nothing was sampled                          */
    int apart;     /* of several claims, about different things                                 */
    int mixed;     /* of several claims, each of which has data that another one has not        */
    const char
        *within; /* "narrow | wide; narrow | wide": which phrases are narrower, as the chapters declare; or NULL */
} scope;

/* Of a claim: made from what was run in the type that gives the claim its evidence. */
scope scope_of(const claim_result *r);
/* Adds to *s what `other` asks: *s is then their intersection.  That of no scope at all is all cases: (scope){0}. */
void meet_scope(scope *s, const scope *other);
/* Adds a condition on the data, of a hypothesis for instance; NULL and "" are none. */
void add_condition(scope *s, const char *condition);
/* Leaves out what may be anything and is called by a letter that is none of a statement, "t beta x": it is a letter of a claim, and
 * says nothing to the reader. */
void leave_letters(scope *s, const char *letters);
/* Of several degrees leaves that one. */
void keep_degree(scope *s, int degree);
/* Whether no case is in it. */
int is_empty_scope(const scope *s);
/* In words, with that letter or word for the degree: "k" and "order" stand for the order.  The caller frees. */
char *scope_words(const scope *s, const char *letter);
void free_scope(scope *s);
#endif
