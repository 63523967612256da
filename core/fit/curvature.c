#include "core/fit/curvature.h"

#include "core/fit/wide.h"

#include <stdlib.h>
#include <string.h>

enum { PAIRS = 128 }; /* added up at once, a multiple of WIDE_SUMS */

/* The unknowns of a piece: rows of PAIRS numbers, those of all x, then those of all y; and the sum so far, above the
 * diagonal. */
typedef struct block {
    int unknowns, pairs;
    double *pair, *sum;
} block;

struct fit_curvature {
    const fit_support *support;
    block *piece;
    double *matrix;
};

void fit_curvature_free(fit_curvature *c)
{
    if (c == NULL)
        return;
    for (int k = 0; c->piece != NULL && k < c->support->pieces; k++) {
        free(c->piece[k].pair);
        free(c->piece[k].sum);
    }
    free(c->piece);
    free(c->matrix);
    free(c);
}

fit_curvature *fit_curvature_new(const fit_support *support)
{
    fit_curvature *c = calloc(1, sizeof *c);
    if (c == NULL)
        return NULL;
    const size_t unknowns = (size_t)support->unknowns;
    const int *first = support->first;
    c->support = support;
    c->piece = calloc((size_t)support->pieces, sizeof *c->piece);
    c->matrix = malloc(unknowns * unknowns * sizeof *c->matrix);
    int good = c->piece && c->matrix;
    for (int k = 0; good && k < support->pieces; k++) {
        size_t n = (size_t)(first[k + 1] - first[k]);
        c->piece[k].unknowns = (int)n;
        c->piece[k].pair = aligned_alloc(WIDE_SUMS * sizeof(double), (2 * n + 1) * PAIRS * sizeof *c->piece[k].pair);
        c->piece[k].sum = malloc((n * n + 1) * sizeof *c->piece[k].sum);
        good = c->piece[k].pair && c->piece[k].sum;
    }
    if (!good) {
        fit_curvature_free(c);
        return NULL;
    }
    fit_curvature_clear(c);
    return c;
}

void fit_curvature_clear(fit_curvature *c)
{
    for (int k = 0; k < c->support->pieces; k++) {
        block *b = &c->piece[k];
        memset(b->sum, 0, (size_t)b->unknowns * (size_t)b->unknowns * sizeof *b->sum);
        b->pairs = 0;
    }
}

WIDE static void add_up(block *b)
{
    int n = b->unknowns, pairs = (b->pairs + WIDE_SUMS - 1) / WIDE_SUMS * WIDE_SUMS;
    for (int j = 0; j < 2 * n; j++)
        for (int i = b->pairs; i < pairs; i++)
            b->pair[j * PAIRS + i] = 0;
    for (int j = 0; j < n; j++)
        for (int k = j; k < n; k++)
            b->sum[j * n + k] += wide_dot(pairs, b->pair + j * PAIRS, b->pair + (n + k) * PAIRS);
    b->pairs = 0;
}

double *fit_curvature_pairs(fit_curvature *c, int piece, int count, int *stride)
{
    block *b = &c->piece[piece];
    if (b->pairs + count > PAIRS)
        add_up(b);
    *stride = PAIRS;
    b->pairs += count;
    return b->pair + b->pairs - count;
}

double *fit_curvature_matrix(fit_curvature *c)
{
    const fit_support *support = c->support;
    int n = support->unknowns;
    memset(c->matrix, 0, (size_t)n * (size_t)n * sizeof *c->matrix);
    for (int piece = 0; piece < c->support->pieces; piece++) {
        block *b = &c->piece[piece];
        const int *unknown = support->unknown + support->first[piece];
        add_up(b);
        for (int j = 0; j < b->unknowns; j++)
            for (int k = j; k < b->unknowns; k++)
                c->matrix[unknown[j] * n + unknown[k]] += b->sum[j * b->unknowns + k];
    }
    for (int j = 0; j < n; j++)
        for (int k = 0; k < j; k++)
            c->matrix[j * n + k] = c->matrix[k * n + j];
    return c->matrix;
}
