/* memory.c -- memory of the rewritten code: filled with what is recognised as never computed, an object with margins. */
#include "exact/code/objects.h"
#include "exact/code/value.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    LEAST_MARGIN = 64,
    MOST_MARGIN = 4096,
    MARGIN_BYTE = 0xFE,
    NEVER_FILLED = 0xAA,
    USUAL_ALIGNMENT = 16,
    PAGE = 4096
};

void *cagd_code_lib_malloc(size_t n);
void *cagd_code_lib_calloc(size_t count, size_t n);
void *cagd_code_lib_realloc(void *p, size_t n);
void *cagd_code_lib_aligned_alloc(size_t alignment, size_t n);
int cagd_code_lib_posix_memalign(void **p, size_t alignment, size_t n);
void cagd_code_lib_free(void *p);
void *cagd_code_lib__Znwm(size_t n);
void *cagd_code_lib__Znam(size_t n);
void cagd_code_lib__ZdlPv(void *p);
void cagd_code_lib__ZdaPv(void *p);
void cagd_code_lib__ZdlPvm(void *p, size_t n);
void cagd_code_lib__ZdaPvm(void *p, size_t n);
int cagd_code_lib_memcmp(const void *a, const void *b, size_t n);
void *cagd_code_lib_memcpy(void *to, const void *from, size_t n);
void *cagd_code_lib_memmove(void *to, const void *from, size_t n);
void *cagd_code_lib_memset(void *to, int byte, size_t n);
void *cagd_code_lib_reallocarray(void *p, size_t count, size_t n);
void *cagd_code_lib_memalign(size_t alignment, size_t n);
void *cagd_code_lib_valloc(size_t n);
void *cagd_code_lib_pvalloc(size_t n);
int cagd_code_lib_bcmp(const void *a, const void *b, size_t n);
size_t cagd_code_lib__ZSt11_Hash_bytesPKvmm(const void *bytes, size_t n, size_t seed);
void *cagd_code_lib__ZnwmSt11align_val_t(size_t n, size_t alignment);
void *cagd_code_lib__ZnamSt11align_val_t(size_t n, size_t alignment);
void *cagd_code_lib__ZnwmRKSt9nothrow_t(size_t n, const void *t);
void *cagd_code_lib__ZnamRKSt9nothrow_t(size_t n, const void *t);
void *cagd_code_lib__ZnwmSt11align_val_tRKSt9nothrow_t(size_t n, size_t alignment, const void *t);
void *cagd_code_lib__ZnamSt11align_val_tRKSt9nothrow_t(size_t n, size_t alignment, const void *t);
void cagd_code_lib__ZdlPvSt11align_val_t(void *p, size_t a);
void cagd_code_lib__ZdaPvSt11align_val_t(void *p, size_t a);
void cagd_code_lib__ZdlPvmSt11align_val_t(void *p, size_t n, size_t a);
void cagd_code_lib__ZdaPvmSt11align_val_t(void *p, size_t n, size_t a);
void cagd_code_lib__ZdlPvRKSt9nothrow_t(void *p, const void *t);
void cagd_code_lib__ZdaPvRKSt9nothrow_t(void *p, const void *t);

/* As wide as the memory itself, within bounds: who walks in rows takes the last step that far beyond the end. */
static size_t margin_of(size_t n, size_t alignment)
{
    size_t margin = n < LEAST_MARGIN ? LEAST_MARGIN : n > MOST_MARGIN ? MOST_MARGIN : n;
    return (margin + alignment - 1) / alignment * alignment;
}

static void *made(size_t n, size_t alignment, int content)
{
    size_t margin = margin_of(n, alignment);
    if (n > (size_t)-1 / 2 - 2 * margin)
        return NULL;
    char *all = aligned_alloc(alignment, (n + 2 * margin + alignment - 1) / alignment * alignment);
    if (all == NULL)
        return NULL;
    memset(all, MARGIN_BYTE, margin);
    memset(all + margin, content, n);
    memset(all + margin + n, MARGIN_BYTE, margin);
    cagd_code_object(all + margin, n, margin, margin, NULL, CAGD_CODE_MEMORY);
    return all + margin;
}

static void release(const char *start, size_t before) { free((char *)(uintptr_t)start - before); }

void *cagd_code_lib_malloc(size_t n) { return made(n, USUAL_ALIGNMENT, NEVER_FILLED); }

void *cagd_code_lib_calloc(size_t count, size_t n)
{
    return count != 0 && n > (size_t)-1 / count ? NULL : made(count * n, USUAL_ALIGNMENT, 0);
}

void cagd_code_lib_free(void *p)
{
    size_t size;
    if (p == NULL)
        return;
    if (cagd_code_memory_at(p, &size))
        cagd_code_memory_dies(p, release);
    else
        free(p); /* of the libraries */
}

void *cagd_code_lib_realloc(void *p, size_t n)
{
    size_t had;
    if (p == NULL)
        return cagd_code_lib_malloc(n);
    if (!cagd_code_memory_at(p, &had))
        return realloc(p, n);
    void *new = cagd_code_lib_malloc(n);
    if (new != NULL) {
        memcpy(new, p, had < n ? had : n);
        cagd_code_memory_dies(p, release);
    }
    return new;
}

static int is_alignment(size_t n) { return n >= sizeof(void *) && (n & (n - 1)) == 0; }

void *cagd_code_lib_aligned_alloc(size_t alignment, size_t n)
{
    return is_alignment(alignment) ? made(n, alignment, NEVER_FILLED) : NULL;
}

int cagd_code_lib_posix_memalign(void **p, size_t alignment, size_t n)
{
    if (!is_alignment(alignment))
        return EINVAL;
    void *new = made(n, alignment, NEVER_FILLED);
    if (new == NULL)
        return ENOMEM;
    *p = new;
    return 0;
}

void *cagd_code_lib_memalign(size_t alignment, size_t n) { return cagd_code_lib_aligned_alloc(alignment, n); }
void *cagd_code_lib_valloc(size_t n) { return made(n, PAGE, NEVER_FILLED); }
void *cagd_code_lib_pvalloc(size_t n) { return made((n + PAGE - 1) / PAGE * PAGE, PAGE, NEVER_FILLED); }
void *cagd_code_lib_reallocarray(void *p, size_t count, size_t n)
{
    return count != 0 && n > (size_t)-1 / count ? NULL : cagd_code_lib_realloc(p, count * n);
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
void cagd_code_lib__ZdlPv(void *p) { cagd_code_lib_free(p); }
void cagd_code_lib__ZdaPv(void *p) { cagd_code_lib_free(p); }
void cagd_code_lib__ZdlPvm(void *p, size_t n)
{
    (void)n;
    cagd_code_lib_free(p);
}
void cagd_code_lib__ZdaPvm(void *p, size_t n)
{
    (void)n;
    cagd_code_lib_free(p);
}

/* The forms of new and delete with an alignment, and with std::nothrow. */
static void *aligned(size_t n, size_t alignment)
{
    void *p = made(n, alignment < USUAL_ALIGNMENT ? USUAL_ALIGNMENT : alignment, NEVER_FILLED);
    if (p == NULL)
        cagd_code_stop(CAGD_CODE_BOUND, "no memory for operator new");
    return p;
}
#define NOTHING(x) (void)(x)
void *cagd_code_lib__ZnwmSt11align_val_t(size_t n, size_t alignment) { return aligned(n, alignment); }
void *cagd_code_lib__ZnamSt11align_val_t(size_t n, size_t alignment) { return aligned(n, alignment); }
void *cagd_code_lib__ZnwmRKSt9nothrow_t(size_t n, const void *t) { return NOTHING(t), cagd_code_lib_malloc(n); }
void *cagd_code_lib__ZnamRKSt9nothrow_t(size_t n, const void *t) { return NOTHING(t), cagd_code_lib_malloc(n); }
void *cagd_code_lib__ZnwmSt11align_val_tRKSt9nothrow_t(size_t n, size_t alignment, const void *t)
{
    return NOTHING(t), aligned(n, alignment);
}
void *cagd_code_lib__ZnamSt11align_val_tRKSt9nothrow_t(size_t n, size_t alignment, const void *t)
{
    return NOTHING(t), aligned(n, alignment);
}
void cagd_code_lib__ZdlPvSt11align_val_t(void *p, size_t a) { NOTHING(a), cagd_code_lib_free(p); }
void cagd_code_lib__ZdaPvSt11align_val_t(void *p, size_t a) { NOTHING(a), cagd_code_lib_free(p); }
void cagd_code_lib__ZdlPvmSt11align_val_t(void *p, size_t n, size_t a)
{
    NOTHING(n), NOTHING(a), cagd_code_lib_free(p);
}
void cagd_code_lib__ZdaPvmSt11align_val_t(void *p, size_t n, size_t a)
{
    NOTHING(n), NOTHING(a), cagd_code_lib_free(p);
}
void cagd_code_lib__ZdlPvRKSt9nothrow_t(void *p, const void *t) { NOTHING(t), cagd_code_lib_free(p); }
void cagd_code_lib__ZdaPvRKSt9nothrow_t(void *p, const void *t) { NOTHING(t), cagd_code_lib_free(p); }

/* Of equal pieces LLVM promises that they may be copied, and clang makes such copies of structures by itself. */
void cagd_code_apart(const char *to, const char *from, int64_t bytes)
{
    struct cagd_code_outcome *o = cagd_code_machine.outcome;
    uintptr_t a = (uintptr_t)to, b = (uintptr_t)from;
    if (a == b || bytes <= 0 || (a < b ? b - a : a - b) >= (uintptr_t)bytes)
        return;
    if (!cagd_code_machine.job->memcpy_moves)
        cagd_code_stop(CAGD_CODE_REFUSED, "memcpy of %zu bytes to %zu bytes %s, which overlap", (size_t)bytes,
                       (size_t)(a < b ? b - a : a - b), a < b ? "before" : "behind");
    if (o->overlapping++ == 0 && cagd_code_at != NULL)
        snprintf(o->overlapping_at, sizeof o->overlapping_at, "%s:%d", cagd_code_at->file, (int)cagd_code_at->line);
}

void *cagd_code_lib_memcpy(void *to, const void *from, size_t n)
{
    cagd_code_apart(to, from, (int64_t)n);
    return cagd_code_lib_memmove(to, from, n);
}
void *cagd_code_lib_memmove(void *to, const void *from, size_t n)
{
    cagd_code_reach(from, (int64_t)n, 0);
    cagd_code_reach(to, (int64_t)n, 1);
    return memmove(to, from, n);
}
void *cagd_code_lib_memset(void *to, int byte, size_t n)
{
    cagd_code_reach(to, (int64_t)n, 1);
    return memset(to, byte, n);
}

/* Bytes of numbers are not looked at: the same number can be there in two ways. */
static void look_for_numbers(const void *bytes, size_t n, const char *what)
{
    cagd_code_reach(bytes, (int64_t)n, 0);
    for (size_t at = 0; at + 4 <= n; at += 4) {
        uint64_t word = 0;
        uint32_t half;
        memcpy(&word, (const char *)bytes + at, at + 8 <= n ? 8 : 4);
        memcpy(&half, (const char *)bytes + at, sizeof half);
        if (cagd_code_is_one(word) || cagd_code_is_single(half))
            cagd_code_stop(CAGD_CODE_REFUSED, "%s of numbers", what);
    }
}

int cagd_code_lib_memcmp(const void *a, const void *b, size_t n)
{
    look_for_numbers(a, n, "memcmp");
    look_for_numbers(b, n, "memcmp");
    return memcmp(a, b, n);
}
int cagd_code_lib_bcmp(const void *a, const void *b, size_t n) { return cagd_code_lib_memcmp(a, b, n); }

/* What std::hash calls: that of texts and integers may be any. */
size_t cagd_code_lib__ZSt11_Hash_bytesPKvmm(const void *bytes, size_t n, size_t seed)
{
    const unsigned char *at = bytes;
    look_for_numbers(bytes, n, "std::hash");
    size_t hash = seed ^ 0xCBF29CE484222325u;
    for (size_t k = 0; k < n; k++)
        hash = (hash ^ at[k]) * 0x100000001B3u;
    return hash;
}
