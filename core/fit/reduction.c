#include "core/fit/reduction.h"

#include "core/fit/wide.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ROWS = 128 }; /* taken in at once */

/* Columns one after the other, each with the new rows first and the places of the triangle behind. */
typedef struct triangle {
    int columns, rows; /* rows: new ones */
    double *a;
    int *filled; /* of that of all: 1 where the new rows have numbers other than 0 in a column; NULL: everywhere */
} triangle;

struct fit_reduction {
    const fit_support *support;
    int sides;
    triangle *piece, all;
    double *by_rows;
};

static int stride_of(const triangle *t) { return ROWS + (t->columns + WIDE_SUMS - 1) / WIDE_SUMS * WIDE_SUMS; }

static int triangle_new(triangle *t, int columns)
{
    t->columns = columns;
    size_t size = (size_t)columns * (size_t)stride_of(t) * sizeof *t->a;
    t->a = aligned_alloc(WIDE_SUMS * sizeof *t->a, size);
    if (t->a != NULL)
        memset(t->a, 0, size);
    return t->a != NULL;
}

/* Householder's reflections of the new rows into the triangle: column k has the vector (a_kk + sign |.|, new rows).  Columns in
 * which a reflection has nothing to change, as most of them in a spline of many pieces, are passed over. */
WIDE static void absorb(triangle *t)
{
    int n = t->columns, stride = stride_of(t), rows = (t->rows + WIDE_SUMS - 1) / WIDE_SUMS * WIDE_SUMS;
    for (int k = 0; k < n; k++)
        for (int i = t->rows; i < rows && t->filled == NULL; i++)
            t->a[k * stride + i] = 0;
    for (int k = 0; k < n; k++) {
        if (t->filled != NULL && !t->filled[k])
            continue;
        double *column = t->a + k * stride, at = column[ROWS + k];
        const double square = wide_dot(rows, column, column);
        if (square == 0)
            continue;
        const double length = sqrt(at * at + square), head = at > 0 ? at + length : at - length;
        const double factor = 2 / (head * head + square);
        for (int j = k + 1; j < n; j++) {
            double *w = t->a + j * stride;
            if (t->filled != NULL && !t->filled[j] && w[ROWS + k] == 0)
                continue;
            if (t->filled != NULL)
                t->filled[j] = 1;
            const double share = factor * (head * w[ROWS + k] + wide_dot(rows, column, w));
            w[ROWS + k] -= share * head;
            wide_subtract(rows, share, column, w);
        }
        column[ROWS + k] = at > 0 ? -length : length;
    }
    for (int k = 0; k < n && t->filled != NULL; k++)
        if (t->filled[k]) {
            memset(t->a + k * stride, 0, (size_t)rows * sizeof *t->a);
            t->filled[k] = 0;
        }
    t->rows = 0;
}

static double *next_row(triangle *t)
{
    if (t->rows == ROWS)
        absorb(t);
    return t->a + t->rows++;
}

void fit_reduction_free(fit_reduction *r)
{
    if (r == NULL)
        return;
    for (int k = 0; r->piece != NULL && k < r->support->pieces; k++)
        free(r->piece[k].a);
    free(r->piece);
    free(r->all.a);
    free(r->all.filled);
    free(r->by_rows);
    free(r);
}

fit_reduction *fit_reduction_new(const fit_support *support, int sides)
{
    fit_reduction *r = calloc(1, sizeof *r);
    if (r == NULL)
        return NULL;
    const int columns = support->unknowns + sides, *first = support->first;
    r->support = support, r->sides = sides;
    r->piece = calloc((size_t)support->pieces, sizeof *r->piece);
    r->by_rows = malloc((size_t)columns * (size_t)columns * sizeof *r->by_rows);
    r->all.filled = calloc((size_t)columns, sizeof *r->all.filled);
    int good = r->piece && r->by_rows && r->all.filled && triangle_new(&r->all, columns);
    for (int k = 0; good && k < support->pieces; k++)
        good = triangle_new(&r->piece[k], first[k + 1] - first[k] + sides);
    if (!good) {
        fit_reduction_free(r);
        return NULL;
    }
    return r;
}

static void clear(triangle *t)
{
    const int stride = stride_of(t);
    for (int k = 0; k < t->columns; k++)
        memset(t->a + k * stride + ROWS, 0, (size_t)(stride - ROWS) * sizeof *t->a);
    t->rows = 0;
}

void fit_reduction_clear(fit_reduction *r)
{
    for (int k = 0; k < r->support->pieces; k++)
        clear(&r->piece[k]);
}

double *fit_reduction_row(fit_reduction *r, int piece, int *stride)
{
    *stride = stride_of(&r->piece[piece]);
    return next_row(&r->piece[piece]);
}

double *fit_reduction_rows(fit_reduction *r, int piece, int count, int *stride)
{
    triangle *t = &r->piece[piece];
    if (t->rows + count > ROWS)
        absorb(t);
    *stride = stride_of(t);
    t->rows += count;
    return t->a + t->rows - count;
}

/* Takes the triangle of piece k into that of all. */
static void join(fit_reduction *r, int k)
{
    const fit_support *support = r->support;
    const int stride = stride_of(&r->all), *unknown = support->unknown + support->first[k];
    triangle *t = &r->piece[k];
    const int own = t->columns - r->sides;
    absorb(t);
    for (int i = 0; i < t->columns; i++) {
        double *row = next_row(&r->all);
        for (int j = i; j < t->columns; j++) {
            const int column = j < own ? unknown[j] : support->unknowns + j - own;
            row[column * stride] = t->a[j * stride_of(t) + ROWS + i];
            r->all.filled[column] = 1;
        }
    }
}

const double *fit_reduction_triangle(fit_reduction *r)
{
    const int n = r->support->unknowns + r->sides, alone = r->support->pieces == 1;
    triangle *t = alone ? &r->piece[0] : &r->all; /* that of the only piece is that of all */
    const int stride = stride_of(t);
    if (!alone)
        clear(t);
    for (int k = 0; k < r->support->pieces && !alone; k++)
        join(r, k);
    absorb(t);
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++)
            r->by_rows[i * n + j] = i <= j ? t->a[j * stride + ROWS + i] : 0;
    return r->by_rows;
}
