/* objects.c -- see objects.h. */
#include "exact/code/objects.h"

#include "exact/code/value.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* low <= start <= end <= high: the object, and its margins. */
struct object {
    uintptr_t low, start, end, high;
    const char *name;
    const struct cagd_code_place *place;
    enum cagd_code_life life;
    int dead;
};

/* Objects by their addresses, those of functions apart: they come and go with the stack. */
struct list {
    struct object **at;
    size_t count, room;
};
static struct list lasting, local;
static size_t dead_count, dead_bytes;
enum { MOST_DEAD = 1 << 14, MOST_DEAD_BYTES = 1 << 28 };

static void *needed(void *room)
{
    if (room == NULL)
        cagd_code_stop(CAGD_CODE_BOUND, "no memory to know which memory is used");
    return room;
}

/* How many objects of the list begin at or before the address, their margins included. */
static size_t up_to(const struct list *l, uintptr_t address)
{
    size_t low = 0, high = l->count;
    while (low < high) {
        size_t middle = (low + high) / 2;
        if (l->at[middle]->low <= address)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

static struct object *found_in(const struct list *l, uintptr_t address)
{
    size_t k = up_to(l, address);
    return k > 0 && address < l->at[k - 1]->high ? l->at[k - 1] : NULL;
}

static void put_in(struct list *l, struct object *o)
{
    if (l->count == l->room) {
        l->room = 2 * l->room + 64;
        l->at = needed(realloc(l->at, l->room * sizeof(struct object *)));
    }
    size_t k = up_to(l, o->low);
    memmove(l->at + k + 1, l->at + k, (l->count - k) * sizeof(struct object *));
    l->at[k] = o;
    l->count++;
}

static void take_out(struct list *l, size_t k)
{
    free(l->at[k]);
    memmove(l->at + k, l->at + k + 1, (l->count - k - 1) * sizeof(struct object *));
    l->count--;
}

/* ---- the stack ------------------------------------------------------------------------------------------ */

/* The stack grows downwards: what lies below the frame of a function that is called now belonged to functions that have returned,
 * or were left by longjmp or an exception.  The list begins with the lowest. */
static void forget_what_returned(uintptr_t frame)
{
    size_t gone = 0;
    while (gone < local.count && local.at[gone]->high <= frame)
        free(local.at[gone++]);
    if (gone > 0) {
        local.count -= gone;
        memmove(local.at, local.at + gone, local.count * sizeof(struct object *));
    }
}

/* An array of variable length whose block begins again lies where it lay before. */
static void forget_what_lay_there(const struct object *o)
{
    for (size_t k = up_to(&local, o->high); k > 0 && local.at[k - 1]->high > o->low; k--)
        if (local.at[k - 1]->low < o->high)
            take_out(&local, k - 1);
}

#define FRAME ((uintptr_t)__builtin_frame_address(0))

/* ---- addresses outside of all objects ------------------------------------------------------------------------ */

/* Each with the beginning of the object from which it was computed: open addressing. */
struct stray {
    uintptr_t address, start;
};
static struct stray *strays;
static size_t stray_room, stray_count;

static struct stray *stray_of(struct stray *table, size_t room, uintptr_t address)
{
    size_t k = (size_t)(address * 0x9E3779B97F4A7C15u >> 20) & (room - 1);
    while (table[k].address != 0 && table[k].address != address)
        k = (k + 1) & (room - 1);
    return &table[k];
}

static struct object *of_address(uintptr_t address)
{
    struct object *o = found_in(&local, address);
    return o != NULL ? o : found_in(&lasting, address);
}

static struct object *owner_of(uintptr_t address)
{
    struct object *o = of_address(address);
    if (o != NULL || stray_count == 0)
        return o;
    const struct stray *s = stray_of(strays, stray_room, address);
    o = s->address != 0 ? of_address(s->start) : NULL;
    return o != NULL && o->start == s->start ? o : NULL;
}

static void grow_strays(void)
{
    size_t room = stray_room > 0 ? 2 * stray_room : 1024;
    struct stray *table = needed(calloc(room, sizeof *table));
    for (size_t k = 0; k < stray_room; k++)
        if (strays[k].address != 0)
            *stray_of(table, room, strays[k].address) = strays[k];
    free(strays);
    strays = table;
    stray_room = room;
}

/* ---- what is said -------------------------------------------------------------------------------------------- */

/* "8 bytes before the beginning of x, which has 32 bytes". */
static void describe(const struct object *o, uintptr_t address, size_t bytes, size_t room, char text[])
{
    char what[400];
    if (o->name != NULL && *o->name != 0)
        snprintf(what, sizeof what, "%s", o->name);
    else if (o->place != NULL)
        snprintf(what, sizeof what, "%s of %s:%d", o->life == CAGD_CODE_MEMORY ? "the memory" : "a variable",
                 o->place->file, (int)o->place->line);
    else
        snprintf(what, sizeof what, "%s", o->life == CAGD_CODE_MEMORY ? "memory" : "a variable");
    size_t size = o->end - o->start;
    if (address < o->start)
        snprintf(text, room, "%zu bytes before the beginning of %s, which has %zu bytes", (size_t)(o->start - address),
                 what, size);
    else if (address >= o->end)
        snprintf(text, room, "%zu bytes behind the end of %s, which has %zu bytes", (size_t)(address - o->end), what,
                 size);
    else
        snprintf(text, room, "%zu bytes from byte %zu of %s on, which has %zu bytes", bytes,
                 (size_t)(address - o->start), what, size);
}

/* "point.calls.2", as clang calls the variable calls of the function point, is calls. */
static void keep_name(const struct object *o, int line)
{
    struct cagd_code_outcome *out = cagd_code_machine.outcome;
    char name[200];
    if (out->kept[0] != 0 || o->name == NULL)
        return;
    snprintf(name, sizeof name, "%s", o->name);
    char *dot = strrchr(name, '.');
    if (dot != NULL && dot[1 + strspn(dot + 1, "0123456789")] == 0)
        *dot = 0;
    dot = strrchr(name, '.');
    snprintf(out->kept, sizeof out->kept, "%.99s", dot != NULL ? dot + 1 : name);
    out->kept_line = line;
}

void cagd_code_reach(const char *p, int64_t bytes, int32_t writes)
{
    uintptr_t address = (uintptr_t)p;
    forget_what_returned(FRAME);
    if (bytes <= 0 || p == NULL)
        return;
    const struct object *o = owner_of(address);
    if (o != NULL && !o->dead && o->start <= address && (uintptr_t)bytes <= o->end - address && address <= o->end) {
        if (writes && o->life == CAGD_CODE_GLOBAL && cagd_code_machine.entered)
            keep_name(o, cagd_code_at != NULL ? (int)cagd_code_at->line : 0);
        return;
    }
    const char *begin = writes ? "something is put" : "a value from";
    char text[600];
    if (o == NULL) {
        enum { STACK = 1 << 22 };
        if (address < FRAME && address > FRAME - STACK)
            cagd_code_stop(CAGD_CODE_REFUSED, "%s a variable of a function that has returned",
                           writes ? "something is put into" : "a value from");
        return; /* memory of the libraries */
    }
    describe(o, address, (size_t)bytes, sizeof text, text);
    if (o->dead)
        cagd_code_stop(CAGD_CODE_REFUSED, "%s memory that was given back: %s", writes ? "something is put into" : begin,
                       text);
    cagd_code_stop(CAGD_CODE_REFUSED, "%s outside an array: %s", begin, text);
}

void cagd_code_step(const char *from, const char *to)
{
    uintptr_t a = (uintptr_t)from, b = (uintptr_t)to;
    forget_what_returned(FRAME);
    if (a == b || from == NULL)
        return;
    const struct object *o = owner_of(a);
    if (o != NULL && o->low <= b && b < o->high)
        return;
    const struct object *there = of_address(b);
    if (there != NULL) {
        char text[600];
        if (o != NULL)
            describe(o, b, 0, sizeof text, text);
        cagd_code_stop(CAGD_CODE_REFUSED, "an address far outside an array: %s",
                       o != NULL ? text : "computed from one that is in none");
    }
    if (2 * stray_count >= stray_room)
        grow_strays();
    struct stray *s = stray_of(strays, stray_room, b);
    if (o == NULL) { /* of the libraries' memory: if somebody else was there, it is no more */
        if (s->address != 0)
            s->start = 0;
        return;
    }
    const struct object *other = s->address != 0 ? of_address(s->start) : NULL;
    if (other != NULL && other != o && other->start == s->start)
        cagd_code_stop(CAGD_CODE_REFUSED, "an address far outside of two arrays");
    stray_count += s->address == 0;
    *s = (struct stray){b, o->start};
}

void cagd_code_together(const char *a, const char *b)
{
    if (cagd_code_machine.job->one_object && a != NULL && b != NULL && a != b &&
        owner_of((uintptr_t)a) != owner_of((uintptr_t)b))
        cagd_code_stop(CAGD_CODE_REFUSED, "addresses of different arrays are compared, which C does not define");
}

void cagd_code_index(int64_t index, int64_t count, int32_t is_used)
{
    if (index < 0 || index > count || (is_used && index == count))
        cagd_code_stop(CAGD_CODE_REFUSED, "a value from outside an array: element %ld of %ld", (long)index,
                       (long)count);
}

/* ---- objects ------------------------------------------------------------------------------------------------- */

void cagd_code_object(const char *start, size_t size, size_t before, size_t behind, const char *name,
                      enum cagd_code_life life)
{
    struct object *o = needed(malloc(sizeof *o));
    uintptr_t at = (uintptr_t)start;
    *o = (struct object){at - before, at, at + size, at + size + behind, name, cagd_code_at, life, 0};
    if (life == CAGD_CODE_LOCAL) {
        forget_what_returned(FRAME);
        forget_what_lay_there(o);
    }
    put_in(life == CAGD_CODE_LOCAL ? &local : &lasting, o);
}

void cagd_code_local(const char *p, int64_t size, int64_t margin, const char *name)
{
    cagd_code_object(p, (size_t)size, (size_t)margin, (size_t)margin, name, CAGD_CODE_LOCAL);
}

void cagd_code_global(const char *p, int64_t size, int64_t margin, const char *name)
{
    cagd_code_object(p, (size_t)size, (size_t)margin, (size_t)margin, name, CAGD_CODE_GLOBAL);
}

int cagd_code_memory_at(const char *start, size_t *size)
{
    const struct object *o = found_in(&lasting, (uintptr_t)start);
    if (o == NULL || o->life != CAGD_CODE_MEMORY)
        return 0;
    if (o->dead)
        cagd_code_stop(CAGD_CODE_REFUSED, "memory that was given back is given back again");
    if (o->start != (uintptr_t)start)
        cagd_code_stop(CAGD_CODE_REFUSED, "memory is given back that does not begin there");
    *size = o->end - o->start;
    return 1;
}

size_t cagd_code_memory_count(void)
{
    size_t count = 0;
    for (size_t k = 0; k < lasting.count; k++)
        count += lasting.at[k]->life == CAGD_CODE_MEMORY;
    return count;
}

void cagd_code_memory_dies(const char *start, void (*release)(const char *start, size_t before))
{
    struct object *o = found_in(&lasting, (uintptr_t)start);
    if (o == NULL)
        return;
    o->dead = 1;
    dead_count++;
    dead_bytes += o->high - o->low;
    if (dead_count < MOST_DEAD && dead_bytes < MOST_DEAD_BYTES)
        return;
    size_t kept = 0;
    for (size_t k = 0; k < lasting.count; k++) {
        struct object *each = lasting.at[k];
        if (each->dead) {
            release((const char *)each->start, each->start - each->low);
            free(each);
        } else {
            lasting.at[kept++] = each;
        }
    }
    lasting.count = kept;
    dead_count = dead_bytes = 0;
}

/* ---- variables of static storage ------------------------------------------------------------------------------- */

/* What they were, one behind the other, up to so many bytes. */
enum { MOST_WATCHED = 1 << 24 };
static char *watched;

static size_t watched_bytes(void)
{
    size_t bytes = 0;
    for (size_t k = 0; k < lasting.count && bytes <= MOST_WATCHED; k++)
        bytes += lasting.at[k]->life == CAGD_CODE_GLOBAL ? lasting.at[k]->end - lasting.at[k]->start : 0;
    return bytes;
}

void cagd_code_watch_globals(void)
{
    size_t bytes = watched_bytes(), at = 0;
    cagd_code_machine.entered = 1;
    if (bytes == 0 || bytes > MOST_WATCHED || (watched = malloc(bytes)) == NULL)
        return;
    for (size_t k = 0; k < lasting.count; k++) {
        const struct object *o = lasting.at[k];
        if (o->life != CAGD_CODE_GLOBAL)
            continue;
        memcpy(watched + at, (const void *)o->start, o->end - o->start);
        at += o->end - o->start;
    }
}

void cagd_code_compare_globals(void)
{
    size_t at = 0;
    for (size_t k = 0; k < lasting.count; k++) {
        const struct object *o = lasting.at[k];
        if (o->life != CAGD_CODE_GLOBAL)
            continue;
        if (watched == NULL || memcmp(watched + at, (const void *)o->start, o->end - o->start) != 0)
            keep_name(o, 0); /* so much that it was not noted is not looked through */
        at += o->end - o->start;
    }
}
