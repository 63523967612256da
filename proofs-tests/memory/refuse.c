/* refuse.c -- preloaded: memory that is refused.  Counted are the requests from the beginning of main on.
 *
 *   REFUSE_LIST=FILE    nothing is refused; the number of each request whose callers, the FRAMES innermost ones, were not seen before
 *                       is a line of FILE, and the number of all requests the last one
 *   REFUSE=K,TELL       request K is refused, and the file TELL is made;  REFUSE=K+,TELL: and all requests after it
 *
 * A program that this one starts is left alone: the names are taken out of the environment. */
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdatomic.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <unwind.h>

enum { FRAMES = 12, ROOM = 1 << 16, INFINITE = -1 };

/* What glibc's own names lead to. */
void *__libc_malloc(size_t size);
void *__libc_calloc(size_t count, size_t size);
void *__libc_realloc(void *block, size_t size);
void *__libc_memalign(size_t alignment, size_t size);
typedef int program(int, char **, char **);
int __libc_start_main(program *start, int count, char **argument, void (*init)(void), void (*fini)(void),
                      void (*unload)(void), void *stack_end);

static atomic_long asked;
static long refused_from, refused_to; /* 0: none */
static int list = -1, begun;
static char tell[512];
static uint64_t seen[ROOM];
static _Thread_local int within;

struct walk {
    uint64_t hash;
    int left;
};
static _Unwind_Reason_Code step(struct _Unwind_Context *context, void *of)
{
    struct walk *w = of;
    w->hash = (w->hash ^ (uint64_t)_Unwind_GetIP(context)) * 0x100000001b3u;
    return --w->left > 0 ? _URC_NO_REASON : _URC_END_OF_STACK;
}

/* Whether these callers ask for the first time. */
static int is_new(void)
{
    struct walk w = {0xcbf29ce484222325u, FRAMES};
    _Unwind_Backtrace(step, &w);
    for (uint64_t at = w.hash % ROOM;; at = (at + 1) % ROOM) {
        if (seen[at] == w.hash)
            return 0;
        if (seen[at] == 0) {
            seen[at] = w.hash;
            return 1;
        }
    }
}

static int refuses(void)
{
    if (!begun || within)
        return 0;
    long number = ++asked;
    if (list >= 0) {
        within = 1;
        if (is_new())
            dprintf(list, "%ld\n", number);
        within = 0;
        return 0;
    }
    if (refused_from == 0 || number < refused_from || (refused_to != INFINITE && number > refused_to))
        return 0;
    if (number == refused_from)
        close(open(tell, O_WRONLY | O_CREAT | O_CLOEXEC, 0666));
    errno = ENOMEM;
    return 1;
}

void *malloc(size_t size) { return refuses() ? NULL : __libc_malloc(size); }
void *calloc(size_t count, size_t size) { return refuses() ? NULL : __libc_calloc(count, size); }
void *realloc(void *block, size_t size) { return refuses() ? NULL : __libc_realloc(block, size); }
void *memalign(size_t alignment, size_t size) { return refuses() ? NULL : __libc_memalign(alignment, size); }
void *aligned_alloc(size_t alignment, size_t size) { return refuses() ? NULL : __libc_memalign(alignment, size); }
int posix_memalign(void **block, size_t alignment, size_t size)
{
    if (refuses())
        return ENOMEM;
    *block = __libc_memalign(alignment, size);
    return *block != NULL ? 0 : ENOMEM;
}

static program *main_of_program;

static void last_line(void)
{
    begun = 0;
    dprintf(list, "%ld\n", (long)asked);
}

static int begin(int count, char **argument, char **environment)
{
    const char *of_list = getenv("REFUSE_LIST"), *refuse = getenv("REFUSE"),
               *comma = refuse != NULL ? strchr(refuse, ',') : NULL;
    if (comma != NULL) {
        refused_from = atol(refuse);
        refused_to = comma[-1] == '+' ? INFINITE : refused_from;
        strncpy(tell, comma + 1, sizeof tell - 1);
    }
    if (of_list != NULL) {
        list = open(of_list, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
        atexit(last_line);
    }
    unsetenv("REFUSE"), unsetenv("REFUSE_LIST"), unsetenv("LD_PRELOAD");
    begun = 1;
    return main_of_program(count, argument, environment);
}

int __libc_start_main(program *start, int count, char **argument, void (*init)(void), void (*fini)(void),
                      void (*unload)(void), void *stack_end)
{
    int (*real)(program *, int, char **, void (*)(void), void (*)(void), void (*)(void), void *);
    void *symbol = dlsym(RTLD_NEXT, "__libc_start_main");
    memcpy(&real, &symbol, sizeof real);
    main_of_program = start;
    return real(begin, count, argument, init, fini, unload, stack_end);
}
