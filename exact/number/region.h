/* region.h -- where the values of the exact number types live.
 *
 * An operation returns a pointer to a fresh, immutable value.  Values are never freed one by one: a
 * computation opens a region, computes, and drops the whole region.  Slots of rationals and
 * intervals keep their limbs, so a warm region allocates nothing.  Each thread has its own region, whose
 * values no other thread may use while this one opens, drops or computes. */
#ifndef CAGD_REGION_H
#define CAGD_REGION_H

#include <stddef.h>

/* How far the region of this thread was filled, and its precision.  Marks are dropped in the opposite order of opening. */
typedef struct cagd_region_mark {
    size_t used[4], bytes, large;
    long precision;
} cagd_region_mark;

cagd_region_mark cagd_region_open(void);
void cagd_region_drop(cagd_region_mark m); /* every value of this thread made since m is dead, and the precision is
                                              what it was                                                   */
void cagd_region_free_all(void);           /* drops everything and gives the region's memory back         */
void cagd_thread_end(void);                /* the same, the field closed and the caches of MPFR and FLINT freed:
                                              a thread that used this library calls it as its last act      */

/* What GMP, MPFR, FLINT and the region call where memory is refused.  It must not return.  To be named before the first number is
 * made.  Where nothing is named, room that is refused is the fault MEMORY, and a number without a place ends with abort(). */
void cagd_without_memory(void (*end)(void));

/* Intervals that are made from now on in this region have ends of so many bits: 128 at first, and from 2 to 2^24 as one
 * likes; for another number UNABLE, and the precision stays. */
void cagd_region_set_precision(long bits);
long cagd_region_precision(void);

/* Room, aligned for any object, that lives as long as a value made now: n bytes, or rows x columns elements.  NULL, and MEMORY,
 * when there is none, and for an array also when a number is negative or rows x columns is no int. */
void *cagd_region_bytes(size_t n);
void *cagd_region_array(long rows, long columns, size_t size);

/* Operations return values, so they report trouble here: bits that stay set until the reader clears
 * them.  Undefined, unable and false are three answers.  The value returned along with a fault is a
 * placeholder and means nothing. */
enum {
    CAGD_FAULT_UNDEFINED = 1, /* no such value: division by zero                                       */
    CAGD_FAULT_UNABLE = 2,    /* a value may exist; it is not computed here                            */
    CAGD_FAULT_CROWDED = 4,   /* more named variables than the context has: run again in a larger one  */
    CAGD_FAULT_MEMORY = 8     /* there was no memory for it, or it is larger than an int can say       */
};
#ifdef __cplusplus
extern thread_local unsigned cagd_region_faults;
#else
extern _Thread_local unsigned cagd_region_faults;
#endif
#endif
