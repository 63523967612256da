#include "exact/record/trace.h"

#include "exact/number/memory.h"
#include "exact/number/recorder.h"
#include "exact/words.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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
    struct cagd_recorder recorder; /* what the arithmetic sees of it */
    char variable[MOST_VARIABLES][LONGEST_NAME];
    int node_of_variable[MOST_VARIABLES], variables;
    struct text inputs, nodes, steps;
    struct place *place;
    size_t places, taken, most, count;
    int paused, gave_up, input_count, facts; /* facts: since the last step that is none */
    num_q (*value_of)(const char *name);     /* NULL: variables have any values         */
};

static _Thread_local struct cagd_trace *tracing; /* NULL when no trace is open in this thread */

/* Whether anything is to be noted has changed. */
static void listen(void) { tracing->recorder.noting = tracing->paused == 0 && !tracing->gave_up; }
static void give_up(unsigned fault)
{
    if (fault == FAULT_MEMORY)
        cagd_memory_is_refused();
    tracing->gave_up = 1;
    region_faults |= fault;
    listen();
}

/* Is there room for n more bytes and the 0 at the end?  Without memory the trace gives up. */
static int make_room(struct text *t, size_t n)
{
    if (t->length + n < t->room)
        return 1;
    size_t room = 2 * t->room + n + 256;
    char *at = realloc(t->at, room);
    if (at == NULL) {
        give_up(FAULT_MEMORY);
        return 0;
    }
    t->at = at;
    t->room = room;
    return 1;
}

static void put(struct text *t, const char *format, ...) __attribute__((format(printf, 2, 3)));
static void put(struct text *t, const char *format, ...)
{
    for (int n = 0; make_room(t, (size_t)n);) {
        va_list list;
        va_start(list, format);
        n = vsnprintf(t->at + t->length, t->room - t->length, format, list);
        va_end(list);
        if (n < 0)
            return;
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
    if (!make_room(t, n))
        return;
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

static void put_value(struct text *t, num_q x)
{
    if (!make_room(t, mpz_sizeinbase(mpq_numref(x.at), 10) + mpz_sizeinbase(mpq_denref(x.at), 10) + 5))
        return;
    t->at[t->length++] = '"';
    mpq_get_str(t->at + t->length, 10, x.at);
    t->length += strlen(t->at + t->length);
    put_word(t, "\"");
}

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
    struct cagd_trace *T = tracing;
    if (2 * T->taken >= T->places) {
        struct place *larger = calloc(2 * T->places, sizeof *larger);
        if (larger == NULL) {
            give_up(FAULT_MEMORY);
            return;
        }
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

static void forget(const void *slot)
{
    struct place *p = find(tracing->place, tracing->places, slot);
    if (p->slot != NULL)
        p->node = -1;
}

static int known(const void *slot)
{
    struct place *p = find(tracing->place, tracing->places, slot);
    return p->slot != NULL ? p->node : -1;
}

/* Begins a node for the slot, whose arguments the caller puts, and its bracket; 0 when there are too many.  The rest of
 * the computation is of no use then, and the fault lets the field hurry to its end. */
static int begin_node(const void *slot, const char *op)
{
    if (tracing->gave_up || tracing->count >= tracing->most) {
        give_up(FAULT_UNABLE);
        return 0;
    }
    separate(&tracing->nodes);
    put_word(&tracing->nodes, "[\"");
    put_word(&tracing->nodes, op);
    put_word(&tracing->nodes, "\"");
    hold(slot, (int)tracing->count++);
    return 1;
}

static void note_node(const void *slot, const char *op, int count, const int argument[])
{
    if (!begin_node(slot, op))
        return;
    for (int k = 0; k < count; k++) {
        put_word(&tracing->nodes, ",");
        put_index(&tracing->nodes, argument[k]);
    }
    put_word(&tracing->nodes, "]");
}

static void note_literal(const void *slot, const char *op, int count, const num_q value[])
{
    if (!begin_node(slot, op))
        return;
    for (int k = 0; k < count; k++) {
        put_word(&tracing->nodes, ",");
        put_value(&tracing->nodes, value[k]);
    }
    put_word(&tracing->nodes, "]");
}

static void note_alias(const void *slot, int node) { hold(slot, node); }

static void note_text(const void *slot, const char *op, const char *text)
{
    if (begin_node(slot, op))
        put(&tracing->nodes, ",\"%s\"]", text);
}

/* The next input, without its value and bracket. */
static void begin_input(const void *slot, const char *name, int index)
{
    note_node(slot, "x", 1, &tracing->input_count);
    tracing->input_count++;
    separate(&tracing->inputs);
    put(&tracing->inputs, "[\"%s", name);
    if (index >= 0)
        put(&tracing->inputs, "%d", index);
    put(&tracing->inputs, "\",");
}

void cagd_trace_input(num_q a, const char *name, int index)
{
    begin_input(a.at, name, index);
    put_value(&tracing->inputs, a);
    put(&tracing->inputs, "]");
}

void cagd_trace_values(num_q (*value_of)(const char *name))
{
    if (tracing != NULL)
        tracing->value_of = value_of;
}

/* Any positive value will do, where none is said; those of splitmix64 have no relations that one would think of. */
static void note_variable(const void *slot, const char *name)
{
    int v = 0;
    while (v < tracing->variables && strcmp(tracing->variable[v], name) != 0)
        v++;
    if (v < tracing->variables) {
        hold(slot, tracing->node_of_variable[v]);
        return;
    }
    if (v == MOST_VARIABLES || strlen(name) >= LONGEST_NAME) {
        give_up(0);
        return;
    }
    begin_input(slot, name, -1);
    num_q value = tracing->value_of != NULL ? tracing->value_of(name) : (num_q){NULL};
    if (value.at != NULL) {
        put_value(&tracing->inputs, value);
        put_word(&tracing->inputs, "]");
        strcpy(tracing->variable[v], name);
        tracing->node_of_variable[tracing->variables++] = known(slot);
        return;
    }
    uint64_t z = (uint64_t)(v + 1) * 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    put(&tracing->inputs, "\"%d/%d\"]", (int)(z % 997) + 1, (int)((z >> 20) % 89) + 11);
    strcpy(tracing->variable[v], name);
    tracing->node_of_variable[tracing->variables++] = known(slot);
}

/* ---- opened and closed ------------------------------------------------------------------------ */

void cagd_trace_open(size_t most)
{
    enum { PLACES = 1024 };
    struct cagd_trace *T = calloc(1, sizeof *T);
    struct place *place = calloc(PLACES, sizeof *place);
    if (T == NULL || place == NULL) {
        free(T);
        free(place);
        cagd_memory_is_refused();
        region_faults |= FAULT_MEMORY;
        return;
    }
    T->recorder =
        (struct cagd_recorder){1, forget, known, note_alias, note_node, note_literal, note_text, note_variable};
    T->most = most;
    T->places = PLACES;
    T->place = place;
    tracing = T;
    cagd_recorder = &T->recorder;
    put(&T->inputs, "[");
    put(&T->nodes, "[");
    put(&T->steps, "[");
}

void cagd_trace_close(void)
{
    if (tracing == NULL)
        return;
    free(tracing->inputs.at);
    free(tracing->nodes.at);
    free(tracing->steps.at);
    free(tracing->place);
    free(tracing);
    tracing = NULL;
    cagd_recorder = NULL;
}

void cagd_trace_again(void)
{
    if (tracing == NULL)
        return;
    size_t most = tracing->most;
    num_q (*value_of)(const char *) = tracing->value_of;
    cagd_trace_close();
    cagd_trace_open(most);
    if (tracing != NULL)
        tracing->value_of = value_of;
}

static const char *finished(struct text *t)
{
    if (tracing->gave_up)
        return NULL;
    if (t->at[t->length - 1] != '\n')
        put(t, "]\n");
    return tracing->gave_up ? NULL : t->at;
}
const char *cagd_trace_inputs(void) { return tracing == NULL ? NULL : finished(&tracing->inputs); }
const char *cagd_trace_nodes(void) { return tracing == NULL ? NULL : finished(&tracing->nodes); }
const char *cagd_trace_steps(void) { return tracing == NULL ? NULL : finished(&tracing->steps); }

void cagd_trace_pause(void)
{
    if (tracing != NULL) {
        tracing->paused++;
        listen();
    }
}
void cagd_trace_resume(void)
{
    if (tracing != NULL) {
        tracing->paused--;
        listen();
    }
}
int cagd_trace_noting(void) { return cagd_noting(); }

/* ---- steps ------------------------------------------------------------------------------------ */

static const char *truth(int condition) { return condition ? "true" : "false"; }

/* A step that is no fact, or one that is. */
static void begin_step(int is_fact)
{
    separate(&tracing->steps);
    tracing->facts = is_fact ? tracing->facts + 1 : 0;
}

void cagd_trace_same(int i, int j, int equal)
{
    begin_step(0);
    put(&tracing->steps, "{\"same\":[%d,%d],\"equal\":%s}", i, j, truth(equal));
}

/* Blanks and line breaks of the source become one blank. */
static void put_formula(struct text *t, const char *formula)
{
    put_word(t, ",\"formula\":\"");
    for (const char *s = formula; *s != '\0'; s++) {
        char escaped[3] = {'\\', *s, '\0'};
        if (isgraph((unsigned char)*s) || (unsigned char)*s > 127)
            put_word(t, *s == '"' || *s == '\\' ? escaped : escaped + 1);
        else if (s[1] != '\0' && !isspace((unsigned char)s[1]))
            put_word(t, " ");
    }
    put_word(t, "\"");
}

void cagd_trace_agree(int condition, const char *formula)
{
    int facts = tracing->facts;
    begin_step(0);
    put(&tracing->steps, "{\"agree\":%s", truth(condition));
    if (facts > 0 && formula != NULL)
        put_formula(&tracing->steps, formula);
    put(&tracing->steps, "}");
}

void cagd_trace_nonnegative(int i, int good, const char *text, int sign)
{
    begin_step(0);
    put(&tracing->steps, "{\"nonnegative\":%d,\"good\":%s", i, truth(good));
    if (text != NULL)
        put(&tracing->steps, ",\"text\":\"%s\",\"sign\":%d", text, sign);
    put(&tracing->steps, "}");
}

void cagd_trace_relation(const char *kind, int i, int j, int is)
{
    begin_step(1);
    put(&tracing->steps, "{\"fact\":\"%s\",\"of\":[%d,%d],\"is\":%d}", kind, i, j, is);
}
int cagd_trace_fact(const char *kind)
{
    if (!cagd_trace_noting())
        return 0;
    begin_step(1);
    put(&tracing->steps, "{\"fact\":\"%s\"", kind);
    return 1;
}
void cagd_trace_put(const char *field, int x) { put(&tracing->steps, ",\"%s\":%d", field, x); }
void cagd_trace_put_list(const char *field, int count, const int x[])
{
    put(&tracing->steps, ",\"%s\":[", field);
    for (int k = 0; k < count; k++)
        put(&tracing->steps, k > 0 ? ",%d" : "%d", x[k]);
    put(&tracing->steps, "]");
}
void cagd_trace_fact_end(void) { put(&tracing->steps, "}"); }

void cagd_trace_put_numbers(const char *field, int count, const num_q x[])
{
    int *node = count == 0 || x != NULL ? cagd_region_array(1, count, sizeof *node) : NULL;
    if (node == NULL) {
        give_up(FAULT_MEMORY);
        return;
    }
    for (int k = 0; k < count; k++)
        node[k] = cagd_node_of_q(x[k]);
    cagd_trace_put_list(field, count, node);
}
