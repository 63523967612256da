/* text.h -- lines, lists of strings, and complaints.  weave is a program that ends soon: nothing is freed, and out of memory
 * ends it. */
#ifndef CAGD_WEAVE_TEXT_H
#define CAGD_WEAVE_TEXT_H

#include <stddef.h>

/* "file:line: ..." on stderr; counted in `complaints`. */
void complain(const char *file, int line, const char *format, ...) __attribute__((format(printf, 3, 4)));
extern int complaints;

void *must(void *p); /* p, which is not NULL: else the program ends */
char *copy_of(const char *s, size_t n);
char *whole_copy(const char *s);
char *trimmed(char *s);            /* s itself, without the blanks at its ends      */
char *first_clause(const char *s); /* what stands before the first colon, semicolon or full stop in no formula */
char *joined(char *a, char between, const char *b); /* a, a character and b; b alone when a is empty */

struct list {
    char **at;
    int count;
};
/* What stands before the first colon, semicolon or full stop that is in no formula. */
char *first_clause(const char *s);
void append(struct list *l, char *s);
int contains(const struct list *l, const char *s);
struct list lines_of(const char *path); /* empty when the file cannot be read */
#endif
