/* points.c -- see points.h. */
#include "exact/code/points.h"

#include "exact/number/rational.h"

#include <stdlib.h>
#include <string.h>

enum { MOST_PATTERNS = 1024 };

static uint64_t next(uint64_t *state)
{
    uint64_t z = *state += 0x9E3779B97F4A7C15u;
    z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9u;
    z = (z ^ z >> 27) * 0x94D049BB133111EBu;
    return z ^ z >> 31;
}

static long below(uint64_t *state, long n) { return (long)(next(state) % (uint64_t)n); }

static char *text_of(cagd_num_q q)
{
    char *text = strdup(cagd_to_string_q(q));
    if (text == NULL)
        abort();
    return text;
}

/* How large numbers get at the k-th point. */
static long size_at(long k) { return k < 60 ? 3 + k / 2 : 33; }

static cagd_num_q any(uint64_t *state, long k, int fine)
{
    enum { FINE = 36 };
    if (fine)
        return cagd_from_ratio_q(below(state, 16l << FINE) - (8l << FINE), 1l << FINE);
    long size = size_at(k);
    return cagd_from_ratio_q(below(state, 2 * size + 1) - size, 1 + below(state, 1 + size / 2));
}

static cagd_num_q positive(uint64_t *state, long k, int fine)
{
    enum { FINE = 40 };
    if (fine)
        return cagd_from_ratio_q(1 + below(state, 4l << FINE), 1l << FINE);
    long size = size_at(k);
    return cagd_from_ratio_q(1 + below(state, size), 1 + below(state, 1 + size / 2));
}

/* Of an earlier input or a number. */
static cagd_num_q end_of(const struct cagd_code_point *p, const char *text)
{
    for (int k = 0; k < p->inputs; k++) {
        size_t n = strlen(p->input[k].name);
        if (strncmp(text, p->input[k].name, n) != 0 || (text[n] != 0 && text[n] != '['))
            continue;
        long index = text[n] == '[' ? strtol(text + n + 1, NULL, 10) : 0;
        return cagd_from_string_q(p->input[k].value[index]);
    }
    return cagd_from_string_q(text);
}

static cagd_num_q between(uint64_t *state, const struct cagd_code_asked_input *in, const struct cagd_code_point *p,
                          long k, int fine)
{
    cagd_num_q low = end_of(p, in->low), high = end_of(p, in->high);
    long chance = below(state, 12);
    if (chance == 0 && !in->open_low)
        return low;
    if (chance == 1 && !in->open_high)
        return high;
    long parts = fine ? 1l << 40 : 2 + below(state, size_at(k));
    return cagd_add_q(low, cagd_mul_q(cagd_sub_q(high, low), cagd_from_ratio_q(1 + below(state, parts - 1), parts)));
}

long cagd_code_patterns(const struct cagd_code_harness *h)
{
    long patterns = 1;
    for (int k = 0; k < h->inputs; k++)
        if (h->input[k].shape == CAGD_CODE_NONDECREASING)
            for (int j = 1; j < h->input[k].count && patterns < MOST_PATTERNS; j++)
                patterns *= 2;
    return patterns;
}

struct cagd_code_point *cagd_code_point_new(const struct cagd_code_harness *h, long k, int fine)
{
    struct cagd_code_point *p = calloc(1, sizeof *p);
    uint64_t state = 0xCBF29CE484222325u;
    if (p == NULL)
        abort();
    for (const char *at = h->name; *at != 0; at++)
        state = (state ^ (unsigned char)*at) * 0x100000001B3u;
    state += (uint64_t)k * 2 + (uint64_t)fine;
    next(&state);
    cagd_region_mark mark = cagd_region_open();
    long pattern = k;
    for (int i = 0; i < h->inputs; i++) {
        const struct cagd_code_asked_input *in = &h->input[i];
        int count = in->count > 0 ? in->count : 1;
        char **value = calloc((size_t)count, sizeof *value);
        int *like = calloc((size_t)count, sizeof *like);
        if (value == NULL || like == NULL)
            abort();
        cagd_num_q x = {NULL};
        for (int j = 0; j < count; j++) {
            like[j] = j;
            switch (in->shape) {
            case CAGD_CODE_FIXED:
                x = cagd_from_string_q(in->value[j]);
                break;
            case CAGD_CODE_ANY:
                x = any(&state, k, fine);
                break;
            case CAGD_CODE_POSITIVE:
                x = positive(&state, k, fine);
                break;
            case CAGD_CODE_BETWEEN:
                x = between(&state, in, p, k, fine);
                break;
            case CAGD_CODE_NONDECREASING:
                if (j > 0) {
                    int equal = pattern % 2 != 0;
                    pattern /= 2;
                    if (equal) {
                        like[j] = like[j - 1];
                        break;
                    }
                }
                /* fallthrough */
            case CAGD_CODE_INCREASING:
                x = j == 0 ? any(&state, k, fine) : cagd_add_q(x, positive(&state, k, fine));
                break;
            }
            value[j] = text_of(x);
        }
        p->input[p->inputs++] = (struct cagd_code_input){in->name, in->count, (const char *const *)value, like,
                                                         in->shape != CAGD_CODE_FIXED};
    }
    cagd_region_drop(mark);
    return p;
}

struct cagd_code_point *cagd_code_point_copy(const struct cagd_code_point *p)
{
    struct cagd_code_point *copy = malloc(sizeof *copy);
    if (copy == NULL)
        abort();
    *copy = *p;
    for (int i = 0; i < p->inputs; i++) {
        int count = p->input[i].count > 0 ? p->input[i].count : 1;
        char **value = calloc((size_t)count, sizeof *value);
        int *like = calloc((size_t)count, sizeof *like);
        if (value == NULL || like == NULL)
            abort();
        for (int j = 0; j < count; j++) {
            like[j] = p->input[i].like[j];
            value[j] = strdup(p->input[i].value[j]);
            if (value[j] == NULL)
                abort();
        }
        copy->input[i].value = (const char *const *)value;
        copy->input[i].like = like;
    }
    return copy;
}

void cagd_code_point_set(struct cagd_code_point *p, int input, int element, const char *text)
{
    char **value = (char **)(uintptr_t)p->input[input].value;
    char *copy = strdup(text);
    if (copy == NULL)
        abort();
    free(value[element]);
    value[element] = copy;
}

void cagd_code_point_free(struct cagd_code_point *p)
{
    for (int i = 0; p != NULL && i < p->inputs; i++) {
        char **value = (char **)(uintptr_t)p->input[i].value;
        for (int j = 0; j < (p->input[i].count > 0 ? p->input[i].count : 1); j++)
            free(value[j]);
        free(value);
        free((int *)(uintptr_t)p->input[i].like);
    }
    free(p);
}
