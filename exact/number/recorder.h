/* recorder.h -- who listens to the arithmetic (only for exact/number and exact/record).
 *
 * While a thread has a recorder, every operation on rationals, polynomials and rational functions tells it what was made of
 * what.  Of the recorder the arithmetic knows what stands here and no more; exact/record/trace.c is the one there is.  Without
 * one an operation costs a comparison.  A value is named by the slot in which it lives; what was noted of it is its node. */
#ifndef CAGD_RECORDER_H
#define CAGD_RECORDER_H

#include "exact/number/field.h"
#include "exact/number/polynomial.h"
#include "exact/number/rational.h"
#include "exact/number/slots.h"

struct cagd_recorder {
    int noting;                      /* 0: values come and go, and nothing is noted                           */
    void (*fresh)(const void *slot); /* the slot is about to get a value; told also when nothing is noted     */
    int (*known)(const void *slot);  /* the node of its value, or -1; the rest is told only while noting      */
    void (*alias)(const void *slot, int node); /* the slot holds the value of that node                        */
    void (*node)(const void *slot, const char *op, int count, const int argument[]); /* nodes and integers     */
    void (*literal)(const void *slot, const char *op, int count, const cagd_num_q value[]);
    void (*text)(const void *slot, const char *op, const char *text);
    void (*variable)(const void *slot, const char *name); /* an input, the same one for the same name          */
};
extern _Thread_local struct cagd_recorder *cagd_recorder; /* of this thread; NULL: nobody listens              */

static inline int cagd_noting(void) { return cagd_recorder != NULL && cagd_recorder->noting; }

/* A slot that is about to get a value. */
void *cagd_fresh_slot(enum cagd_slot_kind kind);

/* The node of a value, made as that of a number, function or polynomial whose making was not noted if there is none.  Only
 * while noting. */
int cagd_node_of_q(cagd_num_q a);
int cagd_node_of_f(cagd_num_f a);
int cagd_node_of_poly(cagd_poly p);
#endif
