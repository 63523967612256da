/* clock.h -- the time for budgets and progress; no result depends on it but by being cut off. */
#ifndef CAGD_CLOCK_H
#define CAGD_CLOCK_H

#include <time.h>

/* Seconds from some moment on, on a clock that is never set back. */
static inline double cagd_seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec; /* 1e-9: seconds a nanosecond */
}
#endif
