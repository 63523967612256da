/* counted.h -- the kernels for curves in powers once more, in the number type that counts.
 *
 * For the sections of this chapter that say what a point costs; rationals only. */
#include "chapters/judge/counting.h"

#undef G
#define G(name) name##_c
#include "core/kernels/power.tmpl.h"
#undef G
#define G(name) name##_q

static const num_c some_number = {0};
