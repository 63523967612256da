/* thread_end.h -- what a thread that used exact numbers does last. */
#ifndef CAGD_THREAD_END_H
#define CAGD_THREAD_END_H

/* Gives back the thread's region, its field, and the caches of MPFR and FLINT. */
void exact_thread_end(void);
#endif
