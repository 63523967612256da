/* progress.c -- how far a long computation is, on a terminal. */
#include "cli/progress.h"
#include "cli/terminal.h"

#include <stdio.h>

/* run_options.progress */
static void show_progress(void *context, int done, int total, const char *name)
{
    (void)context;
    enum { WIDTH = 24 };
    int filled = done * WIDTH / total;
    fprintf(stderr, "\r\x1b[K[");
    for (int k = 0; k < WIDTH; k++)
        fputs(k < filled ? "=" : " ", stderr);
    fprintf(stderr, "] %d/%d %.50s", done, total, name);
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
