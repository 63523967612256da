#include "chapters/weave/text.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int complaints;

void complain(const char *file, int line, const char *format, ...)
{
    va_list list;
    va_start(list, format);
    fprintf(stderr, "%s:%d: ", file, line);
    vfprintf(stderr, format, list);
    fputc('\n', stderr);
    va_end(list);
    complaints++;
}

void *must(void *p)
{
    if (p == NULL) {
        fputs("weave: out of memory\n", stderr);
        exit(3);
    }
    return p;
}

char *copy_of(const char *s, size_t n)
{
    char *r = must(malloc(n + 1));
    memcpy(r, s, n);
    r[n] = '\0';
    return r;
}

char *whole_copy(const char *s) { return copy_of(s, strlen(s)); }

char *trimmed(char *s)
{
    size_t blanks = 0, n = strlen(s);
    while (isspace((unsigned char)s[blanks]))
        blanks++;
    n -= blanks;
    memmove(s, s + blanks, n + 1);
    while (n > 0 && isspace((unsigned char)s[n - 1]))
        s[--n] = '\0';
    return s;
}

char *joined(char *a, char between, const char *b)
{
    size_t n = strlen(a), m = strlen(b);
    char *r = must(malloc(n + m + 2));
    memcpy(r, a, n);
    if (n > 0)
        r[n++] = between;
    memcpy(r + n, b, m + 1);
    free(a);
    return r;
}

char *first_clause(const char *s)
{
    size_t n = 0;
    for (int in_formula = 0; s[n] != '\0'; n++) {
        in_formula ^= s[n] == '$';
        int is_end = s[n + 1] == '\0' || isspace((unsigned char)s[n + 1]);
        if (!in_formula && is_end && strchr(":;.", s[n]) != NULL)
            break;
    }
    return copy_of(s, n);
}

void append(struct list *l, char *s)
{
    l->at = must(realloc(l->at, (size_t)(l->count + 1) * sizeof *l->at));
    l->at[l->count++] = s;
}

int contains(const struct list *l, const char *s)
{
    for (int k = 0; k < l->count; k++)
        if (strcmp(l->at[k], s) == 0)
            return 1;
    return 0;
}

struct list lines_of(const char *path)
{
    struct list l = {0};
    FILE *f = fopen(path, "r");
    if (f == NULL)
        return l;
    char *line = NULL;
    size_t room = 0;
    for (ssize_t n; (n = getline(&line, &room, f)) >= 0;)
        append(&l, copy_of(line, (size_t)(n > 0 && line[n - 1] == '\n' ? n - 1 : n)));
    free(line);
    fclose(f);
    return l;
}
