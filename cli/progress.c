/* progress.c -- how far a long computation is, on a terminal. */
#include "cli/progress.h"
#include "cli/terminal.h"

#include <stdio.h>

/* run_options.progress */
static void show_progress(void *context, int done, int total, const char *name)
{
    (void)context;
    enum { WIDTH = 24, MOST = 100 };
    int filled = done * WIDTH / total;
    char count[32];
    int counted = snprintf(count, sizeof count, "] %d/%d ", done, total);
    fprintf(stderr, "\r\x1b[K[");
    for (int k = 0; k < WIDTH; k++)
        fputs(k < filled ? "=" : " ", stderr);
    fputs(count, stderr);
    int room = message_width(MOST) - 1 - (1 + WIDTH + counted) - 4; /* the last column stays free; " ..." takes 4 */
    if (room > 0)
        put_clipped(stderr, name, room);
    fflush(stderr);
}

void end_progress(void)
{
    if (is_terminal(stderr))
        fputs("\r\x1b[K", stderr);
}

claim_result *judge_with_progress(const claim *const list[], int count, int jobs, int deep)
{
    run_options options = {.jobs = jobs, .deep = deep, .progress = is_terminal(stderr) ? show_progress : NULL};
    claim_result *results = judge_claims(list, count, &options);
    end_progress();
    return results;
}
