#include "core/fit/reduction.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ROWS = 32 }; /* taken in at once */

/* Columns one after the other, each with the places of the triangle first and those of new rows behind. */
typedef struct triangle {
    int columns, rows; /* rows: new ones */
    double *a;
} triangle;

struct fit_reduction {
    int unknowns, sides, pieces;
    int *first, *reach;
    triangle *piece, all;
    double *by_rows;
};

static int stride_of(const triangle *t) { return t->columns + ROWS; }

static int triangle_new(triangle *t, int columns)
{
    t->columns = columns;
    t->a = calloc((size_t)columns * (size_t)(columns + ROWS), sizeof *t->a);
    return t->a != NULL;
}

/* Eight sums at a time, which the compiler keeps in vectors; n is a multiple of 8, rows that are not there being 0. */
static inline double dot(int n, const double a[restrict], const double b[restrict])
{
    double s[8] = {0};
    for (int i = 0; i < n; i += 8)
        for (int k = 0; k < 8; k++)
            s[k] += a[i + k] * b[i + k];
    return ((s[0] + s[1]) + (s[2] + s[3])) + ((s[4] + s[5]) + (s[6] + s[7]));
}

/* Householder's reflections of the new rows into the triangle: column k has the vector (a_kk + sign |.|, new rows). */
static void absorb(triangle *t)
{
    int n = t->columns, stride = stride_of(t), rows = (t->rows + 7) / 8 * 8;
    for (int k = 0; k < n; k++)
        for (int i = t->rows; i < rows; i++)
            t->a[k * stride + n + i] = 0;
    for (int k = 0; k < n; k++) {
        double *v = t->a + k * stride, *tail = v + n, square = dot(rows, tail, tail);
        if (square == 0)
            continue;
        double length = sqrt(v[k] * v[k] + square), head = v[k] > 0 ? v[k] + length : v[k] - length;
        double factor = 2 / (head * head + square);
        for (int j = k + 1; j < n; j++) {
            double *w = t->a + j * stride, *end = w + n;
            double share = factor * (head * w[k] + dot(rows, tail, end));
            w[k] -= share * head;
            for (int i = 0; i < rows; i++)
                end[i] -= share * tail[i];
        }
        v[k] = v[k] > 0 ? -length : length;
    }
    t->rows = 0;
}

static double *next_row(triangle *t)
{
    if (t->rows == ROWS)
        absorb(t);
    return t->a + t->columns + t->rows++;
}

void fit_reduction_free(fit_reduction *r)
{
    if (r == NULL)
        return;
    for (int k = 0; r->piece != NULL && k < r->pieces; k++)
        free(r->piece[k].a);
    free(r->piece);
    free(r->all.a);
    free(r->first);
    free(r->reach);
    free(r->by_rows);
    free(r);
}

fit_reduction *fit_reduction_new(int unknowns, int sides, int pieces, const int first[], const int reach[])
{
    fit_reduction *r = calloc(1, sizeof *r);
    if (r == NULL)
        return NULL;
    size_t n = (size_t)(unknowns + sides), k = (size_t)pieces, reaches = (size_t)first[pieces];
    r->unknowns = unknowns, r->sides = sides, r->pieces = pieces;
    r->first = malloc((k + 1) * sizeof *first);
    r->reach = malloc((reaches + 1) * sizeof *reach);
    r->piece = calloc(k, sizeof *r->piece);
    r->by_rows = malloc(n * n * sizeof *r->by_rows);
    int good = r->first && r->reach && r->piece && r->by_rows && triangle_new(&r->all, unknowns + sides);
    for (int i = 0; good && i < pieces; i++)
        good = triangle_new(&r->piece[i], first[i + 1] - first[i] + sides);
    if (!good) {
        fit_reduction_free(r);
        return NULL;
    }
    memcpy(r->first, first, (k + 1) * sizeof *first);
    memcpy(r->reach, reach, reaches * sizeof *reach);
    return r;
}

static void clear(triangle *t)
{
    memset(t->a, 0, (size_t)t->columns * (size_t)stride_of(t) * sizeof *t->a);
    t->rows = 0;
}

void fit_reduction_clear(fit_reduction *r)
{
    for (int k = 0; k < r->pieces; k++)
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
    return t->a + t->columns + t->rows - count;
}

const double *fit_reduction_triangle(fit_reduction *r)
{
    int n = r->unknowns + r->sides, stride = stride_of(&r->all);
    clear(&r->all);
    for (int k = 0; k < r->pieces; k++) {
        triangle *t = &r->piece[k];
        const int *reach = r->reach + r->first[k];
        int own = t->columns - r->sides;
        absorb(t);
        for (int i = 0; i < t->columns; i++) {
            double *row = next_row(&r->all);
            for (int j = 0; j < n; j++)
                row[j * stride] = 0;
            for (int j = i; j < t->columns; j++)
                row[(j < own ? reach[j] : r->unknowns + j - own) * stride] = t->a[j * stride_of(t) + i];
        }
    }
    absorb(&r->all);
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++)
            r->by_rows[i * n + j] = i <= j ? r->all.a[j * stride + i] : 0;
    return r->by_rows;
}
