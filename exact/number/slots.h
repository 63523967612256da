/* slots.h -- what the region must know of each kind of value.  Only region.c and the number types
 * include this file. */
#ifndef CAGD_SLOTS_H
#define CAGD_SLOTS_H

#include "exact/number/region.h"

struct cagd_slot_ops {
    size_t size;
    void (*init)(void *);
    void (*clear)(void *);
    int reusable; /* a dropped slot keeps its memory for the next value */
};
extern const struct cagd_slot_ops cagd_slot_ops[SLOT_KINDS];
#endif
