/* matrix-figures.h -- what the drawings of coefficient matrices and of B-splines in powers have in common. */
#ifndef CAGD_MATRIX_FIGURES_H
#define CAGD_MATRIX_FIGURES_H

#include "chapters/judge/figure.h"
#include "figures/words.h"

enum { MOST_ENTRIES = 64 };

/* A panel with the k x k matrix A, in cells of the given width. */
static inline void put_matrix(svg *s, int k, const num_q A[], int cell, const char *caption)
{
    svg_panel(s, svg_integer_window(0, 0, k, k), cell * k, 0, caption);
    svg_heat(s, k, k, A);
}

/* The graph over [a, b] of c_0 + c_1 u + ... + c_p u^p with u = (t-a)/(b-a), p >= 1. */
static inline void put_polynomial(svg *s, int p, const num_q c[], num_q a, num_q b, enum svg_role role)
{
    num_q y[MOST_ENTRIES], P[2 * MOST_ENTRIES];
    bernstein_from_power_q(p, c, y);
    for (int i = 0; i <= p; i++) {
        P[2 * i] = add_q(a, mul_q(r(i, p), sub_q(b, a)));
        P[2 * i + 1] = y[i];
    }
    svg_bezier(s, p, P, role);
}

/* out = column c of the (p+1) x (p+1) matrix A times a factor. */
static inline void column_of(int p, const num_q A[], int c, num_q factor, num_q out[])
{
    for (int j = 0; j <= p; j++)
        out[j] = mul_q(factor, A[j * (p + 1) + c]);
}
#endif
