#include "exact/record/trace.h"

#include "exact/number/region.h"
#include "exact/words.h"

#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

_Thread_local struct cagd_trace *cagd_tracing;

struct text {
    char *at;
    size_t length, room;
};

/* Which node a slot holds: open addressing by the address, as many slots as the nodes ask for. */
struct place {
    const void *slot;
    int node;
};

enum { MOST_VARIABLES = 128, LONGEST_NAME = 16 };

struct cagd_trace {
    char variable[MOST_VARIABLES][LONGEST_NAME];
    int node_of_variable[MOST_VARIABLES], variables;
    struct text inputs, nodes, steps;
    struct place *place;
    size_t places, taken, most, count;
    int paused, gave_up, input_count;
};

/* There is room for n more bytes and the 0 at the end. */
static void make_room(struct text *t, size_t n)
{
    if (t->length + n < t->room)
        return;
    t->room = 2 * t->room + n + 256;
    t->at = realloc(t->at, t->room);
    if (t->at == NULL)
        abort();
}

static void put(struct text *t, const char *format, ...) __attribute__((format(printf, 2, 3)));
static void put(struct text *t, const char *format, ...)
{
    make_room(t, 0);
    for (int n = 0;; make_room(t, (size_t)n)) {
        va_list list;
        va_start(list, format);
        n = vsnprintf(t->at + t->length, t->room - t->length, format, list);
        va_end(list);
        if (t->length + (size_t)n < t->room) {
            t->length += (size_t)n;
            return;
        }
    }
}

/* Nodes are written by the million, so without format. */
static void put_word(struct text *t, const char *word)
{
    size_t n = strlen(word);
    make_room(t, n);
    memcpy(t->at + t->length, word, n + 1);
    t->length += n;
}
static void put_index(struct text *t, int k)
{
    char digits[16], *at = digits + sizeof digits - 1;
    *at = '\0';
    do
        *--at = (char)('0' + k % 10);
    while ((k /= 10) > 0);
    put_word(t, at);
}

/* A comma unless something was just opened. */
static void separate(struct text *t)
{
    char last = t->length > 0 ? t->at[t->length - 1] : '[';
    if (last != '[' && last != '{' && last != ':')
        put_word(t, ",");
}

static void put_value(struct text *t, mpq_srcptr x)
{
    if (x == NULL) {
        put(t, "null");
        return;
    }
    put_word(t, "\"");
    make_room(t, mpz_sizeinbase(mpq_numref(x), 10) + mpz_sizeinbase(mpq_denref(x), 10) + 3);
    mpq_get_str(t->at + t->length, 10, x);
    t->length += strlen(t->at + t->length);
    put_word(t, "\"");
}

void cagd_trace_open(size_t most)
{
    cagd_tracing = calloc(1, sizeof *cagd_tracing);
    if (cagd_tracing == NULL)
        abort();
    cagd_tracing->most = most;
    cagd_tracing->places = 1024;
    cagd_tracing->place = calloc(cagd_tracing->places, sizeof *cagd_tracing->place);
    if (cagd_tracing->place == NULL)
        abort();
    put(&cagd_tracing->inputs, "[");
    put(&cagd_tracing->nodes, "[");
    put(&cagd_tracing->steps, "[");
}

void cagd_trace_close(void)
{
    free(cagd_tracing->inputs.at);
    free(cagd_tracing->nodes.at);
    free(cagd_tracing->steps.at);
    free(cagd_tracing->place);
    free(cagd_tracing);
    cagd_tracing = NULL;
}

void cagd_trace_again(void)
{
    if (cagd_tracing == NULL)
        return;
    size_t most = cagd_tracing->most;
    cagd_trace_close();
    cagd_trace_open(most);
}

static const char *finished(struct text *t)
{
    if (cagd_tracing->gave_up)
        return NULL;
    if (t->at[t->length - 1] != '\n')
        put(t, "]\n");
    return t->at;
}
const char *cagd_trace_inputs(void) { return finished(&cagd_tracing->inputs); }
const char *cagd_trace_nodes(void) { return finished(&cagd_tracing->nodes); }
const char *cagd_trace_steps(void) { return finished(&cagd_tracing->steps); }

/* ---- nodes ------------------------------------------------------------------------------------ */

static struct place *find(struct place *table, size_t size, const void *slot)
{
    size_t k = (size_t)(((uintptr_t)slot >> 4) * 0x9e3779b97f4a7c15u) & (size - 1);
    while (table[k].slot != NULL && table[k].slot != slot)
        k = (k + 1) & (size - 1);
    return &table[k];
}

static void hold(const void *slot, int node)
{
    struct cagd_trace *T = cagd_tracing;
    if (2 * T->taken >= T->places) {
        struct place *larger = calloc(2 * T->places, sizeof *larger);
        if (larger == NULL)
            abort();
        for (size_t k = 0; k < T->places; k++)
            if (T->place[k].slot != NULL)
                *find(larger, 2 * T->places, T->place[k].slot) = T->place[k];
        free(T->place);
        T->place = larger;
        T->places *= 2;
    }
    struct place *p = find(T->place, T->places, slot);
    T->taken += p->slot == NULL;
    *p = (struct place){slot, node};
}

void cagd_trace_pause(void)
{
    if (cagd_tracing != NULL)
        cagd_tracing->paused++;
}
void cagd_trace_resume(void)
{
    if (cagd_tracing != NULL)
        cagd_tracing->paused--;
}
int cagd_trace_is_noting(void) { return cagd_tracing->paused == 0 && !cagd_tracing->gave_up; }

void cagd_trace_fresh(const void *slot)
{
    struct place *p = find(cagd_tracing->place, cagd_tracing->places, slot);
    if (p->slot != NULL)
        p->node = -1;
}

int cagd_trace_known(const void *slot)
{
    struct place *p = find(cagd_tracing->place, cagd_tracing->places, slot);
    return p->slot != NULL ? p->node : -1;
}

/* Begins a node for the slot, whose arguments the caller puts, and its bracket; 0 when there are too many.  The rest of
 * the computation is of no use then, and the fault lets the field hurry to its end. */
static int begin_node(const void *slot, const char *op)
{
    if (cagd_tracing->gave_up || cagd_tracing->count >= cagd_tracing->most) {
        cagd_tracing->gave_up = 1;
        region_faults |= FAULT_UNABLE;
        return 0;
    }
    separate(&cagd_tracing->nodes);
    put_word(&cagd_tracing->nodes, "[\"");
    put_word(&cagd_tracing->nodes, op);
    put_word(&cagd_tracing->nodes, "\"");
    hold(slot, (int)cagd_tracing->count++);
    return 1;
}

void cagd_trace_node(const void *slot, const char *op, int count, const int argument[])
{
    if (!begin_node(slot, op))
        return;
    for (int k = 0; k < count; k++) {
        put_word(&cagd_tracing->nodes, ",");
        put_index(&cagd_tracing->nodes, argument[k]);
    }
    put_word(&cagd_tracing->nodes, "]");
}

void cagd_trace_literal(const void *slot, const char *op, int count, mpq_srcptr (*get)(const void *list, int k),
                        const void *list)
{
    if (!begin_node(slot, op))
        return;
    for (int k = 0; k < count; k++) {
        put_word(&cagd_tracing->nodes, ",");
        put_value(&cagd_tracing->nodes, get(list, k));
    }
    put_word(&cagd_tracing->nodes, "]");
}

static mpq_srcptr itself(const void *number, int k)
{
    (void)k;
    return number;
}

int cagd_trace_number(mpq_srcptr a)
{
    int node = cagd_trace_known(a);
    if (node < 0) {
        cagd_trace_literal(a, "o", 1, itself, a);
        node = cagd_trace_known(a);
    }
    return node;
}

void cagd_trace_alias(const void *slot, int node) { hold(slot, node); }

void cagd_trace_text(const void *slot, const char *op, const char *text)
{
    if (begin_node(slot, op))
        put(&cagd_tracing->nodes, ",\"%s\"]", text);
}

/* The next input, without its value and bracket. */
static void begin_input(const void *slot, const char *name, int index)
{
    cagd_trace_node(slot, "x", 1, &cagd_tracing->input_count);
    cagd_tracing->input_count++;
    separate(&cagd_tracing->inputs);
    put(&cagd_tracing->inputs, "[\"%s", name);
    if (index >= 0)
        put(&cagd_tracing->inputs, "%d", index);
    put(&cagd_tracing->inputs, "\",");
}

void cagd_trace_input(mpq_srcptr r, const char *name, int index)
{
    begin_input(r, name, index);
    put_value(&cagd_tracing->inputs, r);
    put(&cagd_tracing->inputs, "]");
}

/* Any positive value will do; those of splitmix64 have no relations that one would think of. */
void cagd_trace_variable(const void *slot, const char *name)
{
    int v = 0;
    while (v < cagd_tracing->variables && strcmp(cagd_tracing->variable[v], name) != 0)
        v++;
    if (v < cagd_tracing->variables) {
        hold(slot, cagd_tracing->node_of_variable[v]);
        return;
    }
    if (v == MOST_VARIABLES || strlen(name) >= LONGEST_NAME) {
        cagd_tracing->gave_up = 1;
        return;
    }
    begin_input(slot, name, -1);
    uint64_t z = (uint64_t)(v + 1) * 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    put(&cagd_tracing->inputs, "\"%d/%d\"]", (int)(z % 997) + 1, (int)((z >> 20) % 89) + 11);
    strcpy(cagd_tracing->variable[v], name);
    cagd_tracing->node_of_variable[cagd_tracing->variables++] = cagd_trace_known(slot);
}

/* ---- steps ------------------------------------------------------------------------------------ */

static const char *truth(int condition) { return condition ? "true" : "false"; }

void cagd_trace_same(int i, int j, int equal)
{
    separate(&cagd_tracing->steps);
    put(&cagd_tracing->steps, "{\"same\":[%d,%d],\"equal\":%s}", i, j, truth(equal));
}

void cagd_trace_agree(int condition)
{
    separate(&cagd_tracing->steps);
    put(&cagd_tracing->steps, "{\"agree\":%s}", truth(condition));
}

void cagd_trace_nonnegative(int i, int good, const char *text, int sign)
{
    separate(&cagd_tracing->steps);
    put(&cagd_tracing->steps, "{\"nonnegative\":%d,\"good\":%s", i, truth(good));
    if (text != NULL)
        put(&cagd_tracing->steps, ",\"text\":\"%s\",\"sign\":%d", text, sign);
    put(&cagd_tracing->steps, "}");
}

void cagd_trace_relation(const char *kind, int i, int j, int is)
{
    separate(&cagd_tracing->steps);
    put(&cagd_tracing->steps, "{\"fact\":\"%s\",\"of\":[%d,%d],\"is\":%d}", kind, i, j, is);
}
void cagd_trace_order(mpq_srcptr a, mpq_srcptr b, int order)
{
    int i = cagd_trace_number(a), j = b != NULL ? cagd_trace_number(b) : -1;
    cagd_trace_relation("order", i, j, (order > 0) - (order < 0));
}
void cagd_trace_equal(mpq_srcptr a, mpq_srcptr b, int equal)
{
    int i = cagd_trace_number(a), j = b != NULL ? cagd_trace_number(b) : -1;
    cagd_trace_relation("equal", i, j, equal != 0);
}

int cagd_trace_fact(const char *kind)
{
    if (!cagd_trace_noting())
        return 0;
    separate(&cagd_tracing->steps);
    put(&cagd_tracing->steps, "{\"fact\":\"%s\"", kind);
    return 1;
}
void cagd_trace_put(const char *field, int x) { put(&cagd_tracing->steps, ",\"%s\":%d", field, x); }
void cagd_trace_put_list(const char *field, int count, const int x[])
{
    put(&cagd_tracing->steps, ",\"%s\":[", field);
    for (int k = 0; k < count; k++)
        put(&cagd_tracing->steps, k > 0 ? ",%d" : "%d", x[k]);
    put(&cagd_tracing->steps, "]");
}
void cagd_trace_fact_end(void) { put(&cagd_tracing->steps, "}"); }
