#include "exact/number/region.h"

#include "exact/number/guard.h"
#include "exact/number/memory.h"
#include "exact/number/slots.h"
#include "exact/words.h"

#include <limits.h>
#include <stdint.h>
#include <stdlib.h>

enum { CHUNK = 1024, PAGE = 1 << 16, USUAL_PRECISION = 128, MOST_PRECISION = 1 << 24 };

/* One growing sequence of slots of one kind: chunk c holds slots c*CHUNK ... c*CHUNK + CHUNK - 1. */
struct pool {
    char **chunk;
    size_t chunks, used, made;
};

_Thread_local unsigned region_faults;
_Static_assert(sizeof((region_mark){0}.used) == SLOT_KINDS * sizeof(size_t), "a mark has a count for each kind");
static _Thread_local struct pool pools[SLOT_KINDS];
static _Thread_local struct pool pages; /* used counts bytes, the unused ends of pages included */
static _Thread_local struct pool large; /* blocks that do not fit in a page, one chunk each     */

static _Thread_local long precision = USUAL_PRECISION;

long cagd_region_precision(void) { return precision; }
void cagd_region_set_precision(long bits)
{
    if (2 <= bits && bits <= MOST_PRECISION)
        precision = bits;
    else
        region_faults |= FAULT_UNABLE;
}

/* The pool has one chunk more; NULL, and MEMORY, when there is no memory for it. */
static char *one_more_chunk(struct pool *pool, size_t bytes)
{
    char **longer = realloc(pool->chunk, (pool->chunks + 1) * sizeof *longer);
    pool->chunk = longer != NULL ? longer : pool->chunk;
    char *chunk = longer != NULL ? malloc(bytes) : NULL;
    if (chunk == NULL) {
        cagd_memory_is_refused();
        region_faults |= FAULT_MEMORY;
        return NULL;
    }
    return pool->chunk[pool->chunks++] = chunk;
}

static void *slot_at(enum cagd_slot_kind kind, size_t k)
{
    return pools[kind].chunk[k / CHUNK] + k % CHUNK * cagd_slot_ops[kind].size;
}

void *cagd_region_slot(enum cagd_slot_kind kind)
{
    struct pool *pool = &pools[kind];
    if (pool->used == pool->made) {
        if (pool->made == pool->chunks * CHUNK && one_more_chunk(pool, CHUNK * cagd_slot_ops[kind].size) == NULL)
            cagd_no_memory(); /* a number without a place has no value to go on with */
        cagd_slot_ops[kind].init(slot_at(kind, pool->made++));
    }
    return slot_at(kind, pool->used++);
}

static char *place_in_pages(size_t at) { return pages.chunk[at / PAGE] + at % PAGE; }

/* There is one page more, whose bytes are no block's yet. */
static int one_more_page(void)
{
    char *page = one_more_chunk(&pages, PAGE);
    if (page != NULL)
        cagd_forbid(page, PAGE);
    return page != NULL;
}

/* A request that does not fit in the current page starts a new one; a large one has its own chunk. */
void *cagd_region_bytes(size_t n)
{
    if (n > SIZE_MAX - 16 - CAGD_GAP) {
        region_faults |= FAULT_MEMORY;
        return NULL;
    }
    size_t taken = (n == 0 ? 16 : (n + 15) & ~(size_t)15) + CAGD_GAP;
    if (taken > PAGE)
        return one_more_chunk(&large, n);
    size_t start = pages.used % PAGE + taken > PAGE ? (pages.used / PAGE + 1) * PAGE : pages.used;
    while (pages.chunks * PAGE < start + taken)
        if (!one_more_page())
            return NULL;
    pages.used = start + taken;
    cagd_allow(place_in_pages(start), n);
    return place_in_pages(start);
}

void *cagd_region_array(long rows, long columns, size_t size)
{
    if (rows < 0 || columns < 0 || rows > INT_MAX || columns > INT_MAX || (columns > 0 && rows > INT_MAX / columns) ||
        (size_t)(rows * columns) > SIZE_MAX / size) {
        region_faults |= FAULT_MEMORY;
        return NULL;
    }
    return cagd_region_bytes((size_t)(rows * columns) * size);
}

region_mark cagd_region_open(void)
{
    region_mark m = {.bytes = pages.used, .large = large.chunks, .precision = precision};
    for (enum cagd_slot_kind kind = 0; kind < SLOT_KINDS; kind++)
        m.used[kind] = pools[kind].used;
    return m;
}

void cagd_region_drop(region_mark m)
{
    for (enum cagd_slot_kind kind = 0; kind < SLOT_KINDS; kind++) {
        struct pool *pool = &pools[kind];
        pool->used = m.used[kind];
        if (!cagd_slot_ops[kind].reusable)
            while (pool->made > pool->used)
                cagd_slot_ops[kind].clear(slot_at(kind, --pool->made));
    }
    for (size_t at = m.bytes; at < pages.used; at = (at / PAGE + 1) * PAGE)
        cagd_forbid(place_in_pages(at), PAGE - at % PAGE);
    pages.used = m.bytes;
    precision = m.precision;
    while (large.chunks > m.large)
        free(large.chunk[--large.chunks]);
}

static void free_chunks(struct pool *pool)
{
    for (size_t c = 0; c < pool->chunks; c++)
        free(pool->chunk[c]);
    free(pool->chunk);
    *pool = (struct pool){0};
}

void cagd_region_free_all(void)
{
    region_drop((region_mark){.precision = USUAL_PRECISION});
    for (enum cagd_slot_kind kind = 0; kind < SLOT_KINDS; kind++) {
        struct pool *pool = &pools[kind];
        while (pool->made > 0)
            cagd_slot_ops[kind].clear(slot_at(kind, --pool->made));
        free_chunks(pool);
    }
    free_chunks(&pages);
    free_chunks(&large);
}
