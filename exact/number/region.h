/* region.h -- where the values of the exact number types live.
 *
 * An operation returns a pointer to a fresh, immutable value.  Values are never freed one by one: a
 * computation opens a region, computes, and drops the whole region.  Slots of rationals and
 * intervals keep their limbs, so a warm region allocates nothing.  Each thread has its own region. */
#ifndef CAGD_REGION_H
#define CAGD_REGION_H

#include <stddef.h>

/* What the slots hold. */
enum cagd_slot_kind { SLOT_RATIONAL, SLOT_INTERVAL, SLOT_FIELD, SLOT_POLYNOMIAL, SLOT_KINDS };

typedef struct cagd_region_mark {
    size_t used[SLOT_KINDS], bytes, large;
} cagd_region_mark;

cagd_region_mark cagd_region_open(void);
void cagd_region_drop(cagd_region_mark m); /* every value of this thread made since m is dead             */
void cagd_region_free_all(void);           /* gives the region's memory back                              */
void cagd_thread_end(void);                /* the same, the field closed and the caches of MPFR and FLINT
                                    freed: a thread that used exact/ calls it as its last act   */

void *cagd_region_slot(enum cagd_slot_kind kind); /* a fresh, initialised slot                                */
void *cagd_region_bytes(size_t n);                /* n bytes, aligned for any object; lives as long as a slot */

/* Operations return values, so they report trouble here: bits that stay set until the reader clears
 * them.  Undefined, unable and false are three answers.  The value returned along with a fault is a
 * placeholder and means nothing. */
enum {
    CAGD_FAULT_UNDEFINED = 1, /* no such value: division by zero                                       */
    CAGD_FAULT_UNABLE = 2,    /* a value may exist; it is not computed here                            */
    CAGD_FAULT_CROWDED = 4,   /* more named variables than the context has: run again in a larger one  */
    CAGD_FAULT_MEMORY = 8     /* there was no memory for it                                            */
};
extern _Thread_local unsigned cagd_region_faults;
#endif
