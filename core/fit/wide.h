/* wide.h -- vectors of the processor's width for the loops that take most of the time.
 *
 * A static function marked WIDE is compiled for several processors, and the program chooses among them when it starts.  All
 * of them compute the same numbers: sums are made of WIDE_SUMS sums side by side, and every product and sum is
 * rounded by itself. */
#ifndef CAGD_FIT_WIDE_H
#define CAGD_FIT_WIDE_H

#include <stdlib.h> /* says whether the C library is glibc, which can choose among functions */
#include <string.h>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define FIT_NARROW /* a sanitizer is not ready yet when the program chooses */
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define FIT_NARROW
#endif
#endif
#if defined(__x86_64__) && defined(__GLIBC__) && defined(__OPTIMIZE__) && !defined(FIT_NARROW)
#define FIT_WIDER
#define WIDE __attribute__((target_clones("default", "avx2", "avx512f")))
#else
#define WIDE
#endif
/* What such a function calls has to become a part of it. */
#define INLINE static inline __attribute__((always_inline))

enum { WIDE_SUMS = 8 };

/* Half of the sums. */
typedef double wide_half __attribute__((vector_size(WIDE_SUMS / 2 * sizeof(double))));

INLINE void wide_get(wide_half *x, const double from[]) { memcpy(x, from, sizeof *x); }

/* a . b; n is a multiple of WIDE_SUMS. */
INLINE double wide_dot(int n, const double a[restrict], const double b[restrict])
{
    wide_half s = {0}, t = {0}, x, y;
    for (int i = 0; i < n; i += WIDE_SUMS) {
        wide_get(&x, a + i), wide_get(&y, b + i);
        s += x * y;
        wide_get(&x, a + i + WIDE_SUMS / 2), wide_get(&y, b + i + WIDE_SUMS / 2);
        t += x * y;
    }
    return ((s[0] + s[1]) + (s[2] + s[3])) + ((t[0] + t[1]) + (t[2] + t[3]));
}

/* b becomes b - share a. */
INLINE void wide_subtract(int n, double share, const double a[restrict], double b[restrict])
{
    wide_half x, y;
    for (int i = 0; i < n; i += WIDE_SUMS / 2) {
        wide_get(&x, a + i), wide_get(&y, b + i);
        y -= share * x;
        memcpy(b + i, &y, sizeof y);
    }
}
#endif
