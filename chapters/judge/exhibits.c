/* exhibits.c -- what a case shows: named values, as people read them. */
#include "chapters/judge/exhibits.h"
#include "chapters/judge/memory_text.h"

#include "chapters/judge/words.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void add_exhibit(trial *T, const char *name, char *value)
{
    exhibit *more = realloc(T->shown, (size_t)(T->exhibits + 1) * sizeof *more);
    char *copy = strdup(name);
    if (more == NULL || copy == NULL || value == NULL)
        abort();
    T->shown = more;
    T->shown[T->exhibits++] = (exhibit){copy, value};
}

void show_text(trial *T, const char *name, const char *format, ...)
{
    va_list list;
    va_start(list, format);
    int length = vsnprintf(NULL, 0, format, list);
    va_end(list);
    char *value = malloc((size_t)length + 1);
    if (value == NULL)
        abort();
    va_start(list, format);
    vsnprintf(value, (size_t)length + 1, format, list);
    va_end(list);
    add_exhibit(T, name, value);
}

const char *text_q(num_q a) { return to_string_q(a); }
const char *text_i(num_i a)
{
    char *text = region_bytes(80);
    snprintf(text, 80, "[%.17g, %.17g]", lower_i(a), upper_i(a));
    return text;
}
const char *text_m(num_m a)
{
    char *text = region_bytes(40);
    snprintf(text, 40, "%.17g", a.v);
    return text;
}
/* A long formula is cut: an exhibit is for reading. */
const char *text_f(num_f a)
{
    enum { LONGEST = 400 };
    const char *whole = to_string_f(a);
    if (strlen(whole) <= LONGEST)
        return whole;
    char *text = region_bytes(LONGEST + 8);
    snprintf(text, LONGEST + 8, "%.*s ...", LONGEST, whole);
    return text;
}

/* count rows of dim numbers, as (0, 0) (1/2, 1), or as 1, 2, 3 where dim is 1. */
void show_written(trial *T, const char *name, int count, int dim, const char *const number[])
{
    char *text = NULL;
    size_t size;
    FILE *out = text_open(&text, &size);
    for (int k = 0; k < count * dim; k++)
        if (dim == 1)
            fprintf(out, "%s%s", k > 0 ? ", " : "", number[k]);
        else
            fprintf(out, "%s%s%s", k % dim == 0 ? (k > 0 ? " (" : "(") : ", ", number[k],
                    k % dim == dim - 1 ? ")" : "");
    text_close(out, &text);
    show_text(T, name, "%s", text);
    free(text);
}

#define SHOWN(S)                                                                                                       \
    void show_##S(trial *T, const char *name, num_##S a) { show_text(T, name, "%s", text_##S(a)); }                    \
    void show_points_##S(trial *T, const char *name, int count, int dim, const num_##S R[])                            \
    {                                                                                                                  \
        const char **number = region_bytes((size_t)(count * dim) * sizeof *number);                                    \
        for (int k = 0; k < count * dim; k++)                                                                          \
            number[k] = text_##S(R[k]);                                                                                \
        show_written(T, name, count, dim, number);                                                                     \
    }
SHOWN(f)
SHOWN(q)
SHOWN(i)
SHOWN(m)
