/* refuse.c -- what a call, a file or a place that is refused is told: one line. */
#include "cli/refuse.h"
#include "chapters/judge/memory_text.h"
#include "cli/command.h"

#include <limits.h>
#include <stdarg.h>
#include <stdlib.h>

/* Needs no memory, for there may be none; two paths find room. */
enum { LONGEST = 2 * PATH_MAX + 1024 };

static void put_line(const char *name, const char *format, va_list list, const char *end)
{
    char text[LONGEST];
    vsnprintf(text, sizeof text, format, list);
    for (char *c = text; *c != '\0'; c++)
        if ((unsigned char)*c < ' ' || *c == '\x7f')
            *c = '?';
    fprintf(stderr, "%s: %s%s\n", name, text, end);
}

void refuse_line(const char *format, ...)
{
    va_list list;
    va_start(list, format);
    put_line("cagd", format, list, "");
    va_end(list);
}

void refusal_begin(struct refusal *r) { r->to = text_open(&r->text, &r->size); }

void refusal_put(struct refusal *r)
{
    text_close(r->to, &r->text);
    refuse_line("%s", r->text);
    free(r->text);
}

void refuse_call(const char *name, const char *format, ...)
{
    char end[LONGEST];
    snprintf(end, sizeof end, " (%s --help)", name);
    va_list list;
    va_start(list, format);
    put_line(name, format, list, end);
    va_end(list);
    exit(EXIT_USAGE);
}
