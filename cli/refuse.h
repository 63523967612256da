/* refuse.h -- what a call, a file or a place that is refused is told: one line. */
#ifndef CAGD_REFUSE_H
#define CAGD_REFUSE_H

#include <stdio.h>

/* One line on stderr, "cagd: " and the text; what is refused, where, and what to do.  A character that would break the line, as a
 * name may have one, is printed as '?'. */
void refuse_line(const char *format, ...) __attribute__((format(printf, 1, 2)));
/* The same, of parts: what is written to the stream, which this opens, is the text when it is put. */
struct refusal {
    FILE *to;
    char *text;
    size_t size;
};
void refusal_begin(struct refusal *r);
void refusal_put(struct refusal *r);
/* One line on stderr that begins with the name of the command as it was called, "cagd curve", and ends with where its help is; then
 * the program ends with EXIT_USAGE. */
_Noreturn void refuse_call(const char *name, const char *format, ...) __attribute__((format(printf, 2, 3)));
#endif
