/* number.c -- the numbers and where they are kept. */
#include "proofs-tests/fit/certify/number.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

void stop(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    fputs("certify: ", stderr);
    vfprintf(stderr, format, arguments);
    fputc('\n', stderr);
    va_end(arguments);
    exit(1);
}

num *numbers(size_t count)
{
    num *a = malloc(count * sizeof *a);
    mpfr_t *m = malloc(count * sizeof *m);
    if (a == NULL || m == NULL)
        stop("no memory");
    for (size_t k = 0; k < count; k++) {
        mpfr_init2(m[k], BITS);
        mpfr_set_zero(m[k], 1);
        a[k] = m[k];
    }
    return a;
}

enum { POOL = 1 << 14 };
static num *pool;
size_t used;

num fresh(void)
{
    if (pool == NULL)
        pool = numbers(POOL);
    if (used == POOL)
        stop("more numbers in one expression than expected");
    return pool[used++];
}

num *several(int k)
{
    size_t first = used;
    for (; k > 0; k--)
        fresh();
    return pool + first;
}

#define BINARY(name, function)                                                                                         \
    num name(num a, num b)                                                                                             \
    {                                                                                                                  \
        num r = fresh();                                                                                               \
        function(r, a, b, MPFR_RNDN);                                                                                  \
        return r;                                                                                                      \
    }
#define UNARY(name, function)                                                                                          \
    num name(num a)                                                                                                    \
    {                                                                                                                  \
        num r = fresh();                                                                                               \
        function(r, a, MPFR_RNDN);                                                                                     \
        return r;                                                                                                      \
    }
BINARY(add, mpfr_add)
BINARY(sub, mpfr_sub)
BINARY(mul, mpfr_mul)
BINARY(quo, mpfr_div)
UNARY(root, mpfr_sqrt)
UNARY(size, mpfr_abs)
UNARY(logarithm, mpfr_log)
UNARY(exponential, mpfr_exp)

num real(double x)
{
    num r = fresh();
    mpfr_set_d(r, x, MPFR_RNDN);
    return r;
}

num power2(num a, long e)
{
    num r = fresh();
    mpfr_mul_2si(r, a, e, MPFR_RNDN);
    return r;
}

void set(num a, num b) { mpfr_set(a, b, MPFR_RNDN); }
void increase(num a, num b) { mpfr_add(a, a, b, MPFR_RNDN); }
int less(num a, num b) { return mpfr_less_p(a, b); }
