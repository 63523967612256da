/* slots.h -- what the region must know of each kind of value.  Only region.c and the number types
 * include this file. */
#ifndef CAGD_SLOTS_H
#define CAGD_SLOTS_H

#include "exact/number/region.h"

enum cagd_slot_kind { SLOT_RATIONAL, SLOT_INTERVAL, SLOT_FIELD, SLOT_POLYNOMIAL, SLOT_KINDS };

struct cagd_slot_ops {
    size_t size;
    void (*init)(void *);
    void (*clear)(void *);
    int reusable; /* a dropped slot keeps its memory for the next value */
};
extern const struct cagd_slot_ops cagd_slot_ops[SLOT_KINDS];

void *cagd_region_slot(enum cagd_slot_kind kind); /* a fresh, initialised slot */
#endif
