#define _GNU_SOURCE 1 /* fopencookie; as -D_GNU_SOURCE says it, where a target does */
#include "chapters/judge/memory_text.h"

#include <stdlib.h>
#include <string.h>
#include <sys/types.h>

/* The text so far.  A stream of open_memstream loses letters without an error where it finds no memory; this one ends the program. */
struct growing {
    char **text;
    size_t *size, room;
};

static ssize_t put(void *cookie, const char *bytes, size_t count)
{
    struct growing *g = cookie;
    size_t used = *g->size + count;
    if (used + 1 > g->room) {
        size_t room = 2 * used + 64;
        char *larger = realloc(*g->text, room);
        if (larger == NULL)
            abort();
        *g->text = larger, g->room = room;
    }
    memcpy(*g->text + *g->size, bytes, count);
    (*g->text)[used] = '\0';
    *g->size = used;
    return (ssize_t)count;
}

/* Where it is: at the end of what was put. */
static int tell(void *cookie, off64_t *place, int from)
{
    struct growing *g = cookie;
    if (from != SEEK_CUR || *place != 0)
        return -1;
    *place = (off64_t)*g->size;
    return 0;
}

static int end(void *cookie)
{
    free(cookie);
    return 0;
}

FILE *text_open(char **text, size_t *size)
{
    struct growing *g = malloc(sizeof *g);
    *text = calloc(1, 1), *size = 0;
    if (g == NULL || *text == NULL)
        abort();
    *g = (struct growing){text, size, 1};
    FILE *stream = fopencookie(g, "w", (cookie_io_functions_t){.write = put, .seek = tell, .close = end});
    if (stream == NULL)
        abort();
    return stream;
}

void text_close(FILE *stream, char *const *text)
{
    int whole = fflush(stream) == 0 && !ferror(stream);
    if (fclose(stream) != 0 || !whole || *text == NULL)
        abort();
}
