/* memory.c -- memory of the rewritten code: filled with what is recognised as never computed, with a margin behind it. */
#include "exact/code/value.h"

#include <malloc.h>
#include <stdlib.h>
#include <string.h>

enum { MARGIN = 32, MARGIN_BYTE = 0xFE, NEVER_FILLED = 0xAA };

void *cagd_code_lib_malloc(size_t n);
void *cagd_code_lib_realloc(void *p, size_t n);
void *cagd_code_lib_aligned_alloc(size_t alignment, size_t n);
void *cagd_code_lib__Znwm(size_t n);
void *cagd_code_lib__Znam(size_t n);
int cagd_code_lib_memcmp(const void *a, const void *b, size_t n);

/* From byte `from` on: n - from bytes of no contents, and the rest margin. */
static void *filled(void *p, size_t from, size_t n)
{
    if (p == NULL)
        return NULL;
    size_t size = malloc_usable_size(p);
    if (from < n)
        memset((char *)p + from, NEVER_FILLED, n - from);
    memset((char *)p + n, MARGIN_BYTE, size - n);
    return p;
}

static int too_large(size_t n) { return n > (size_t)-1 - MARGIN; }

void *cagd_code_lib_malloc(size_t n) { return too_large(n) ? NULL : filled(malloc(n + MARGIN), 0, n); }

/* Behind the old end there is margin, which is no contents either. */
void *cagd_code_lib_realloc(void *p, size_t n)
{
    size_t had = p != NULL ? malloc_usable_size(p) : 0;
    return too_large(n) ? NULL : filled(realloc(p, n + MARGIN), had < n ? had : n, n);
}

void *cagd_code_lib_aligned_alloc(size_t alignment, size_t n)
{
    if (too_large(n + alignment))
        return NULL;
    return filled(aligned_alloc(alignment, (n + MARGIN + alignment - 1) / alignment * alignment), 0, n);
}

static void *needed(size_t n)
{
    void *p = cagd_code_lib_malloc(n);
    if (p == NULL)
        cagd_code_stop(CAGD_CODE_BOUND, "no memory for operator new");
    return p;
}
void *cagd_code_lib__Znwm(size_t n) { return needed(n); }
void *cagd_code_lib__Znam(size_t n) { return needed(n); }

/* Bytes of numbers are not compared: the same number can be there in two ways. */
int cagd_code_lib_memcmp(const void *a, const void *b, size_t n)
{
    const void *const side[2] = {a, b};
    for (int k = 0; k < 2; k++)
        for (size_t at = 0; at + 8 <= n; at += 4) {
            uint64_t word;
            memcpy(&word, (const char *)side[k] + at, sizeof word);
            if (cagd_code_is_one(word))
                cagd_code_stop(CAGD_CODE_REFUSED, "memcmp of numbers");
        }
    return memcmp(a, b, n);
}
