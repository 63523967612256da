/* parallel.h -- independent pieces of work on several threads. */
#ifndef CAGD_PARALLEL_H
#define CAGD_PARALLEL_H

/* work(context, k) once for every k = 0 ... count - 1, each on one of at most `jobs` threads, begun in this order; returns
 * when all are done.  What a piece leaves in the region or in the state of its thread is gone then.  A system that starts no
 * thread has the pieces done by the caller's own, which therefore has no field open. */
void cagd_in_parallel(int jobs, int count, void (*work)(void *context, int k), void *context);
#endif
