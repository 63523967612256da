/* memory.c -- how the program ends where it cannot go on. */
#include "cli/memory.h"

#include "cli/command.h"
#include "cli/output.h"
#include "exact/number/region.h"

#include <jansson.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static void (*forget)(void);

void also_forget(void (*what)(void)) { forget = what; }

/* Nothing that is not allowed in a handler. */
static _Noreturn void stop(const char *line)
{
    ssize_t unseen = write(STDERR_FILENO, line, strlen(line));
    (void)unseen;
    output_forget();
    if (forget != NULL)
        forget();
    _exit(EXIT_INTERNAL);
}

void no_memory(void) { stop("cagd: there is not enough memory\n"); }

static void on_abort(int number)
{
    (void)number;
    stop("cagd: stopped: there is not enough memory, or something is wrong inside\n");
}

static void *new_for_json(size_t size)
{
    void *block = malloc(size);
    if (block == NULL)
        no_memory();
    return block;
}

void memory_begin(void)
{
    signal(SIGABRT, on_abort);
    cagd_without_memory(no_memory);
    json_set_alloc_funcs(new_for_json, free);
}
