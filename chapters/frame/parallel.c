#include "chapters/frame/parallel.h"

#include "exact/number/region.h"

#include <pthread.h>
#include <stdlib.h>

struct queue {
    pthread_mutex_t lock;
    int next, count;
    void (*work)(void *, int);
    void *context;
};

static void *take_turns(void *arg)
{
    struct queue *q = arg;
    for (;;) {
        pthread_mutex_lock(&q->lock);
        int k = q->next < q->count ? q->next++ : -1;
        pthread_mutex_unlock(&q->lock);
        if (k < 0)
            break;
        q->work(q->context, k);
    }
    exact_thread_end();
    return NULL;
}

void in_parallel(int jobs, int count, void (*work)(void *context, int k), void *context)
{
    struct queue q = {.count = count, .work = work, .context = context};
    int threads = jobs < 1 ? 1 : jobs < count ? jobs : count, started = 0;
    pthread_t *thread = calloc((size_t)threads + 1, sizeof *thread);
    if (thread == NULL)
        abort();
    pthread_mutex_init(&q.lock, NULL);
    while (started < threads && pthread_create(&thread[started], NULL, take_turns, &q) == 0)
        started++;
    if (started == 0)
        take_turns(&q);
    for (int k = 0; k < started; k++)
        pthread_join(thread[k], NULL);
    pthread_mutex_destroy(&q.lock);
    free(thread);
}
