/* number.h -- numbers of 512 bits (MPFR), as values: add(a, mul(b, c)).
 *
 * A number of `numbers` stays until the process ends.  One of the others is gone when `used`, a mark in the pool
 * from which they are taken, is set back to what it was. */
#ifndef CERTIFY_NUMBER_H
#define CERTIFY_NUMBER_H

#include <mpfr.h>
#include <stddef.h>

enum { BITS = 512, STEP = -128 }; /* 2^STEP is the step of the quotients of differences */

typedef mpfr_ptr num;

/* A line on stderr, and the process ends with 1. */
_Noreturn void stop(const char *format, ...) __attribute__((format(printf, 1, 2)));

num *numbers(size_t count); /* zeros that stay */

extern size_t used;
num fresh(void);
num *several(int k);

num add(num a, num b);
num sub(num a, num b);
num mul(num a, num b);
num quo(num a, num b);
num root(num a);
num size(num a);
num logarithm(num a);
num exponential(num a);
num real(double x);
num power2(num a, long e); /* a 2^e */

void set(num a, num b);
void increase(num a, num b);
int less(num a, num b);
#endif
