/* print.c -- printf and its like for the rewritten code: a number is printed as the exact value that it has. */
#include "exact/code/value.h"

#include <dlfcn.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int cagd_code_lib_printf(const char *format, ...);
int cagd_code_lib_fprintf(FILE *out, const char *format, ...);
int cagd_code_lib_sprintf(char *out, const char *format, ...);
int cagd_code_lib_snprintf(char *out, size_t room, const char *format, ...);
int cagd_code_lib_vprintf(const char *format, va_list list);
int cagd_code_lib_vfprintf(FILE *out, const char *format, va_list list);
int cagd_code_lib_vsprintf(char *out, const char *format, va_list list);
int cagd_code_lib_vsnprintf(char *out, size_t room, const char *format, va_list list);
void *cagd_code_lib__ZNSolsEd(void *stream, double x);
void *cagd_code_lib__ZNSo9_M_insertIdEERSoT_(void *stream, double x);
void *cagd_code_lib__ZNSolsEf(void *stream, float x);

struct text {
    char *bytes;
    size_t size, room;
};

static void put(struct text *t, const char *bytes, size_t count)
{
    if (t->size + count + 1 > t->room) {
        t->room = 2 * (t->size + count + 1);
        t->bytes = realloc(t->bytes, t->room);
        if (t->bytes == NULL)
            cagd_code_stop(CAGD_CODE_BOUND, "no memory for what is printed");
    }
    memcpy(t->bytes + t->size, bytes, count);
    t->size += count;
    t->bytes[t->size] = 0;
}

/* What snprintf makes of one conversion and its argument, which is evaluated twice. */
#define PUT(format, argument)                                                                                          \
    do {                                                                                                               \
        int count_ = snprintf(NULL, 0, format, argument);                                                              \
        char *made_ = count_ < 0 ? NULL : malloc((size_t)count_ + 1);                                                  \
        if (made_ == NULL)                                                                                             \
            cagd_code_stop(CAGD_CODE_REFUSED, "a text that cannot be printed");                                        \
        snprintf(made_, (size_t)count_ + 1, format, argument);                                                         \
        put(t, made_, (size_t)count_);                                                                                 \
        free(made_);                                                                                                   \
    } while (0)

/* The value, in the width of the conversion; its precision is of no use to an exact number. */
static void put_number(struct text *t, const char *conversion, double x)
{
    cagd_code_value v = cagd_code_value_of(x);
    if (v.special || cagd_code_machine.job->numbers == CAGD_CODE_ROUNDING) {
        PUT(conversion, v.d);
        return;
    }
    char format[80];
    size_t n = strcspn(conversion + 1, "0123456789.aAeEfFgG"), kept = 1;
    format[0] = '%';
    if (memchr(conversion, '-', n + 1) != NULL)
        format[kept++] = '-';
    for (const char *at = conversion + 1 + n; *at >= '0' && *at <= '9'; at++)
        format[kept++] = *at;
    format[kept++] = 's';
    format[kept] = 0;
    PUT(format, cagd_code_field_text(v));
}

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wformat-nonliteral"
static void make(struct text *t, const char *format, va_list list)
{
    put(t, "", 0);
    while (*format != 0) {
        size_t plain = strcspn(format, "%");
        put(t, format, plain);
        format += plain;
        if (*format == 0)
            break;
        if (format[1] == '%') {
            put(t, "%", 1);
            format += 2;
            continue;
        }
        char c[80] = "%";
        size_t n = 1;
        for (format++; *format != 0 && strchr("#0- +'.123456789*", *format) && n < 40; format++) {
            if (*format == '*') {
                n += (size_t)snprintf(c + n, 12, "%d", va_arg(list, int));
            } else {
                c[n++] = *format;
            }
        }
        char length = 0;
        size_t before = n;
        for (; *format != 0 && strchr("hlLqjzt", *format) && n < 60; format++) {
            length = *format;
            c[n++] = *format;
        }
        char kind = *format;
        if (kind == 0 || strchr("$n", kind) != NULL)
            cagd_code_stop(CAGD_CODE_REFUSED, "printf with a conversion that is not carried");
        format++;
        if (strchr("aAeEfFgG", kind) != NULL) { /* of a long double too: here it is a double */
            c[before] = kind;
            c[before + 1] = 0;
            put_number(t, c, va_arg(list, double));
            continue;
        }
        c[n] = kind;
        c[n + 1] = 0;
        if (kind == 's') {
            const char *string = va_arg(list, const char *);
            PUT(c, string);
        } else if (kind == 'p') {
            void *pointer = va_arg(list, void *);
            PUT(c, pointer);
        } else if (kind == 'c' || length == 0 || length == 'h') {
            int small = va_arg(list, int);
            PUT(c, small);
        } else { /* l, ll, q, j, z, t: all of 64 bits */
            long large = va_arg(list, long);
            PUT(c, large);
        }
    }
}
#pragma GCC diagnostic pop

int cagd_code_lib_vfprintf(FILE *out, const char *format, va_list list)
{
    struct text t = {NULL, 0, 0};
    make(&t, format, list);
    fwrite(t.bytes, 1, t.size, out);
    free(t.bytes);
    return (int)t.size;
}

int cagd_code_lib_vsnprintf(char *out, size_t room, const char *format, va_list list)
{
    struct text t = {NULL, 0, 0};
    make(&t, format, list);
    if (room > 0) {
        size_t kept = t.size < room ? t.size : room - 1;
        memcpy(out, t.bytes, kept);
        out[kept] = 0;
    }
    free(t.bytes);
    return (int)t.size;
}

int cagd_code_lib_vprintf(const char *format, va_list list) { return cagd_code_lib_vfprintf(stdout, format, list); }
int cagd_code_lib_vsprintf(char *out, const char *format, va_list list)
{
    return cagd_code_lib_vsnprintf(out, PTRDIFF_MAX, format, list);
}

#define WITH_LIST(call)                                                                                                \
    va_list list;                                                                                                      \
    va_start(list, format);                                                                                            \
    int count = call;                                                                                                  \
    va_end(list);                                                                                                      \
    return count
int cagd_code_lib_printf(const char *format, ...) { WITH_LIST(cagd_code_lib_vprintf(format, list)); }
int cagd_code_lib_fprintf(FILE *out, const char *format, ...) { WITH_LIST(cagd_code_lib_vfprintf(out, format, list)); }
int cagd_code_lib_sprintf(char *out, const char *format, ...) { WITH_LIST(cagd_code_lib_vsprintf(out, format, list)); }
int cagd_code_lib_snprintf(char *out, size_t room, const char *format, ...)
{
    WITH_LIST(cagd_code_lib_vsnprintf(out, room, format, list));
}

/* std::ostream << double, by way of << const char *, which the C++ library of the rewritten code has. */
void *cagd_code_lib__ZNSolsEd(void *stream, double x)
{
    void *(*insert)(void *, const char *);
    void *symbol = dlsym(cagd_code_machine.object, "_ZStlsISt11char_traitsIcEERSt13basic_ostreamIcT_ES5_PKc");
    struct text t = {NULL, 0, 0};
    if (symbol == NULL)
        cagd_code_stop(CAGD_CODE_REFUSED, "the function std::ostream::operator<<(double)");
    memcpy(&insert, &symbol, sizeof insert);
    put_number(&t, "%g", x);
    stream = insert(stream, t.bytes);
    free(t.bytes);
    return stream;
}
void *cagd_code_lib__ZNSo9_M_insertIdEERSoT_(void *stream, double x) { return cagd_code_lib__ZNSolsEd(stream, x); }
void *cagd_code_lib__ZNSolsEf(void *stream, float x) { return cagd_code_lib__ZNSolsEd(stream, cagd_code_widen(x)); }
