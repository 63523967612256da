#include "exact/number/parallel.h"

#include "exact/number/field.h"
#include "exact/number/region.h"

#include <pthread.h>
#include <stdlib.h>

struct queue {
    pthread_mutex_t lock;
    int next, count;
    void (*work)(void *, int);
    void *context;
};

static void take_turns(struct queue *q)
{
    for (;;) {
        pthread_mutex_lock(&q->lock);
        int k = q->next < q->count ? q->next++ : -1;
        pthread_mutex_unlock(&q->lock);
        if (k < 0)
            return;
        q->work(q->context, k);
    }
}
static void *in_thread(void *queue)
{
    take_turns(queue);
    cagd_thread_end();
    return NULL;
}

void cagd_in_parallel(int jobs, int count, void (*work)(void *context, int k), void *context)
{
    if (count < 1)
        return;
    struct queue q = {.count = count, .work = work, .context = context};
    int threads = jobs < 1 ? 1 : jobs < count ? jobs : count, started = 0;
    pthread_t *thread = calloc((size_t)threads + 1, sizeof *thread);
    pthread_mutex_init(&q.lock, NULL);
    while (thread != NULL && started < threads && pthread_create(&thread[started], NULL, in_thread, &q) == 0)
        started++;
    if (started == 0) {
        const unsigned faults = cagd_region_faults;
        cagd_region_mark mark = cagd_region_open();
        take_turns(&q);
        cagd_region_drop(mark);
        cagd_field_close();
        cagd_region_faults = faults;
    }
    for (int k = 0; k < started; k++)
        pthread_join(thread[k], NULL);
    pthread_mutex_destroy(&q.lock);
    free(thread);
}
