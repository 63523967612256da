/* lanes.h -- eight numbers at once, of which the compiler makes as many vectors as the processor needs.
 *
 * Arithmetic on `lanes` is that of binary64, lane by lane; a comparison gives a `mask`, of whose lanes all bits are set or none.
 * A function marked WIDE is compiled for several widths of vectors and the program chooses among them when it starts; every one
 * computes the same numbers, since products and sums are rounded one by one. */
#ifndef CAGD_FIT_LANES_H
#define CAGD_FIT_LANES_H

#include <math.h>
#include <string.h>

enum { LANES = 8 };
typedef double lanes __attribute__((vector_size(LANES * sizeof(double))));
typedef long long mask __attribute__((vector_size(LANES * sizeof(double))));

#if defined(__x86_64__) && defined(__ELF__) && defined(__OPTIMIZE__) && !defined(__SANITIZE_ADDRESS__)
#define WIDE __attribute__((target_clones("default", "avx2", "avx512f")))
#else
#define WIDE
#endif
/* What a WIDE function calls has to become a part of it. */
#define INLINE static inline __attribute__((always_inline))

/* Eight neighbours in memory. */
INLINE void lanes_get(lanes *x, const double from[]) { memcpy(x, from, sizeof *x); }
INLINE void lanes_put(double to[], const lanes *x) { memcpy(to, x, sizeof *x); }

/* a where the mask is set, b elsewhere. */
INLINE void lanes_choose(lanes *x, const mask *where, const lanes *a, const lanes *b)
{
    *x = (lanes)(((mask)*a & *where) | ((mask)*b & ~*where));
}

INLINE void lanes_choose_larger(lanes *x, const lanes *a, const lanes *b)
{
    const mask where = (mask)(*a > *b);
    lanes_choose(x, &where, a, b);
}

INLINE void lanes_choose_smaller(lanes *x, const lanes *a, const lanes *b)
{
    const mask where = (mask)(*a < *b);
    lanes_choose(x, &where, a, b);
}

INLINE void lanes_root(lanes *x)
{
    for (int l = 0; l < LANES; l++)
        (*x)[l] = sqrt((*x)[l]);
}

INLINE int mask_any(const mask *m)
{
    long long any = 0;
    for (int l = 0; l < LANES; l++)
        any |= (*m)[l];
    return any != 0;
}

INLINE double lanes_sum(const lanes *x)
{
    return (((*x)[0] + (*x)[4]) + ((*x)[2] + (*x)[6])) + (((*x)[1] + (*x)[5]) + ((*x)[3] + (*x)[7]));
}
#endif
