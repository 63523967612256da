/* parallel.h -- independent pieces of work on several threads. */
#ifndef CAGD_PARALLEL_H
#define CAGD_PARALLEL_H

/* work(context, k) once for every k = 0 ... count - 1, each on one of `jobs` threads, begun in this order.  What a piece
 * leaves in the region or in the state of its thread is gone when this returns. */
void in_parallel(int jobs, int count, void (*work)(void *context, int k), void *context);
#endif
