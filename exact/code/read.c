/* read.c -- numbers from texts.  As everywhere, "0.1" is the binary64 that the C library makes of it; "1/3", as print.c writes it, is that
 * fraction, so that what was printed is what is read. */
#include "exact/code/value.h"

#include <ctype.h>
#include <dlfcn.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

double cagd_code_lib_strtod(const char *text, char **end);
float cagd_code_lib_strtof(const char *text, char **end);
double cagd_code_lib_atof(const char *text);
int cagd_code_lib___isoc99_sscanf(const char *text, const char *format, ...);
int cagd_code_lib___isoc99_fscanf(FILE *in, const char *format, ...);
int cagd_code_lib___isoc99_scanf(const char *format, ...);
int cagd_code_lib_sscanf(const char *text, const char *format, ...);
int cagd_code_lib_fscanf(FILE *in, const char *format, ...);
int cagd_code_lib_scanf(const char *format, ...);
void *cagd_code_lib__ZNSirsERd(void *stream, double *x);
void *cagd_code_lib__ZNSirsERf(void *stream, float *x);

/* ---- one number ----------------------------------------------------------------------------------------------- */

/* "-12/5": from the text up to `end` only digits, with a sign perhaps, and behind it "/" and a digit. */
static int is_fraction(const char *text, const char *end)
{
    while (isspace((unsigned char)*text))
        text++;
    text += *text == '-' || *text == '+';
    for (const char *at = text; at < end; at++)
        if (!isdigit((unsigned char)*at))
            return 0;
    return end > text && end[0] == '/' && isdigit((unsigned char)end[1]);
}

static double fraction(const char *text, size_t length)
{
    char *copy = strndup(text, length);
    if (copy == NULL)
        cagd_code_stop(CAGD_CODE_BOUND, "no memory for a number");
    cagd_num_q q = cagd_from_string_q(copy + strspn(copy, " \t\n\v\f\r+"));
    free(copy);
    cagd_code_check_faults();
    return cagd_code_number(cagd_code_constant(q));
}

double cagd_code_lib_strtod(const char *text, char **end)
{
    char *behind;
    double x = strtod(text, &behind);
    if (is_fraction(text, behind)) {
        for (behind++; isdigit((unsigned char)*behind);)
            behind++;
        x = fraction(text, (size_t)(behind - text));
    }
    if (end != NULL)
        *end = behind;
    return x;
}

float cagd_code_lib_strtof(const char *text, char **end)
{
    char *behind;
    float x = strtof(text, &behind);
    if (is_fraction(text, behind))
        return cagd_code_narrow(cagd_code_lib_strtod(text, end));
    if (end != NULL)
        *end = behind;
    return x;
}

double cagd_code_lib_atof(const char *text) { return cagd_code_lib_strtod(text, NULL); }

/* ---- scanf ------------------------------------------------------------------------------------------------------ */

/* Whether the format asks for numbers that float; last: at its end. */
static int asks_for_numbers(const char *format, int last)
{
    int asks = 0;
    for (const char *at = format; (at = strchr(at, '%')) != NULL;) {
        at += 1 + strspn(at + 1, "*0123456789lLhmjzt");
        int floats = *at != 0 && strchr("aefgAEFG", *at) != NULL;
        at += *at != 0;
        asks = floats && (!last || *at == 0) ? 1 : last ? 0 : asks;
    }
    return asks;
}

static void refuse_fraction(void) { cagd_code_stop(CAGD_CODE_REFUSED, "scanf of a fraction"); }

static int scan_text(const char *text, const char *format, va_list list)
{
    if (asks_for_numbers(format, 0) && strchr(format, '/') == NULL)
        for (const char *at = text; (at = strchr(at, '/')) != NULL; at++)
            if (at > text && isdigit((unsigned char)at[-1]) && isdigit((unsigned char)at[1]))
                refuse_fraction();
    return vsscanf(text, format, list);
}

static int scan_file(FILE *in, const char *format, va_list list)
{
    int found = vfscanf(in, format, list);
    if (found > 0 && asks_for_numbers(format, 1)) {
        int next = getc(in);
        if (next == '/')
            refuse_fraction();
        if (next != EOF)
            ungetc(next, in);
    }
    return found;
}

#define WITH_LIST(call)                                                                                                \
    va_list list;                                                                                                      \
    va_start(list, format);                                                                                            \
    int count = call;                                                                                                  \
    va_end(list);                                                                                                      \
    return count
int cagd_code_lib_sscanf(const char *text, const char *format, ...) { WITH_LIST(scan_text(text, format, list)); }
int cagd_code_lib_fscanf(FILE *in, const char *format, ...) { WITH_LIST(scan_file(in, format, list)); }
int cagd_code_lib_scanf(const char *format, ...) { WITH_LIST(scan_file(stdin, format, list)); }
int cagd_code_lib___isoc99_sscanf(const char *text, const char *format, ...)
{
    WITH_LIST(scan_text(text, format, list));
}
int cagd_code_lib___isoc99_fscanf(FILE *in, const char *format, ...) { WITH_LIST(scan_file(in, format, list)); }
int cagd_code_lib___isoc99_scanf(const char *format, ...) { WITH_LIST(scan_file(stdin, format, list)); }

/* ---- std::istream ------------------------------------------------------------------------------------------------ */

static void *function_of_cpp(const char *name)
{
    void *symbol = dlsym(cagd_code_machine.object, name);
    if (symbol == NULL)
        cagd_code_stop(CAGD_CODE_REFUSED, "the function std::istream::operator>>(double)");
    return symbol;
}

/* Whether something is left to be read: std::ios is a virtual base, whose distance stands before the table. */
static int is_good(void *stream)
{
    int (*good)(const void *);
    const char *table;
    ptrdiff_t distance;
    void *symbol = function_of_cpp("_ZNKSt9basic_iosIcSt11char_traitsIcEE4goodEv");
    memcpy(&good, &symbol, sizeof good);
    memcpy(&table, stream, sizeof table);
    memcpy(&distance, table - 3 * sizeof distance, sizeof distance);
    return good((char *)stream + distance) & 1; /* a bool fills one byte */
}

/* What stands behind a whole number that was read: NULL, or the rest of the fraction, which the caller frees. */
static char *rest_of_fraction(void *stream)
{
    int (*peek)(void *), (*get)(void *);
    void *symbols[2] = {function_of_cpp("_ZNSi4peekEv"), function_of_cpp("_ZNSi3getEv")};
    memcpy(&peek, &symbols[0], sizeof peek);
    memcpy(&get, &symbols[1], sizeof get);
    if (!is_good(stream) || peek(stream) != '/')
        return NULL;
    char *rest = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&rest, &size);
    if (out == NULL)
        cagd_code_stop(CAGD_CODE_BOUND, "no memory for a number");
    do
        fputc(get(stream), out);
    while (is_good(stream) && isdigit(peek(stream)));
    fclose(out);
    return rest;
}

/* x was read from the stream; the fraction that it is the numerator of, or x. */
static double completed(void *stream, double x)
{
    enum { MOST = 9007199254740992 >> 32 };
    char *rest = rest_of_fraction(stream), whole[400];
    if (rest == NULL)
        return x;
    if (x != (double)(int64_t)x || x >= (double)MOST * 4294967296.0 || x <= -(double)MOST * 4294967296.0 ||
        rest[1] == 0)
        cagd_code_stop(CAGD_CODE_REFUSED,
                       "a fraction whose numerator is no whole number below 2^53 is read from a stream");
    snprintf(whole, sizeof whole, "%.0f%.300s", x, rest);
    free(rest);
    return fraction(whole, strlen(whole));
}

void *cagd_code_lib__ZNSirsERd(void *stream, double *x)
{
    void *(*extract)(void *, double *), *symbol = function_of_cpp("_ZNSirsERd");
    memcpy(&extract, &symbol, sizeof extract);
    extract(stream, x);
    *x = completed(stream, *x);
    return stream;
}

void *cagd_code_lib__ZNSirsERf(void *stream, float *x)
{
    void *(*extract)(void *, float *), *symbol = function_of_cpp("_ZNSirsERf");
    memcpy(&extract, &symbol, sizeof extract);
    extract(stream, x);
    double all = completed(stream, (double)*x);
    if (all != (double)*x)
        *x = cagd_code_narrow(all);
    return stream;
}
