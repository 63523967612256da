#include "exact/number/memory.h"

#include "exact/number/region.h"

#include <flint/flint.h>
#include <gmp.h>
#include <stdio.h>
#include <stdlib.h>

static void (*named_end)(void);

void cagd_memory_is_refused(void)
{
    if (named_end != NULL)
        named_end();
}

void cagd_no_memory(void)
{
    cagd_memory_is_refused();
    fputs("cagd: no memory for a number\n", stderr);
    abort();
}

static void *checked(void *block, size_t size)
{
    if (block == NULL && size > 0)
        cagd_no_memory();
    return block;
}

static void *flint_new(size_t size) { return checked(malloc(size), size); }
static void *flint_zeros(size_t count, size_t size) { return checked(calloc(count, size), count != 0 ? size : 0); }
static void *flint_longer(void *block, size_t size) { return checked(realloc(block, size), size); }

static void *gmp_longer(void *block, size_t was, size_t size)
{
    (void)was;
    return flint_longer(block, size);
}
static void gmp_free(void *block, size_t size)
{
    (void)size;
    free(block);
}

void cagd_without_memory(void (*end)(void))
{
    named_end = end;
    mp_set_memory_functions(flint_new, gmp_longer, gmp_free); /* MPFR takes its memory from GMP */
    __flint_set_memory_functions(flint_new, flint_zeros, flint_longer, free);
}
