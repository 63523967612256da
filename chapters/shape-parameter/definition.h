/* definition.h -- the functions of this chapter as their formulas say, for the other side of its comparisons.
 *
 * Nothing here follows the kernels: powers are repeated products, binomial coefficients come from factorials, and
 * the eight printed formulas are written out one by one. */
#if RATIONAL
#include "exact/record/sign.h"
#endif

#include "chapters/judge/elementary.h"

#include "chapters/judge/claims_on.h"

/* (1-t)^a t^b */
static inline num G(product_of_powers)(int a, int b, num t)
{
    return mul(G(power)(sub(from_int(1), t), a), G(power)(t, b));
}

/* a + b beta + c beta t */
static inline num G(three_terms)(int a, int b, int c, num beta, num t)
{
    return add(from_int(a), mul(beta, add(from_int(b), mul(from_int(c), t))));
}

/* The linear factor of function i of formula (1), to the letter, and the function. */
static inline num G(printed_factor)(int i, num beta, num t)
{
    switch (i) {
    case 0:
        return G(three_terms)(1, 0, -1, beta, t);
    case 1:
        return G(three_terms)(7, 1, -5, beta, t);
    case 2:
        return G(three_terms)(21, 4, -9, beta, t);
    case 3:
        return G(three_terms)(35, 5, -9, beta, t);
    case 4:
        return G(three_terms)(35, 0, 1, beta, t);
    case 5:
        return G(three_terms)(21, -5, 9, beta, t);
    case 6:
        return G(three_terms)(7, -4, 5, beta, t);
    default:
        return G(three_terms)(1, -1, 1, beta, t);
    }
}
static inline num G(printed)(int i, num beta, num t)
{
    return mul(G(printed_factor)(i, beta, t), G(product_of_powers)(7 - i, i, t));
}

/* a_i = C(n-2,i-1) - C(n-2,i-2) */
static inline num G(shift)(int n, int i) { return sub(G(choose)(n - 2, i - 1), G(choose)(n - 2, i - 2)); }

/* B_{i,n} = C(n,i) s^{n-i} t^i + beta (a_i s^{n+1-i} t^i - a_{i+1} s^{n-i} t^{i+1}) */
static inline num G(corrected)(int n, int i, num beta, num t)
{
    num first = mul(G(shift)(n, i), G(product_of_powers)(n + 1 - i, i, t));
    num second = mul(G(shift)(n, i + 1), G(product_of_powers)(n - i, i + 1, t));
    return add(mul(G(choose)(n, i), G(product_of_powers)(n - i, i, t)), mul(beta, sub(first, second)));
}

/* Coordinate c of the curve of the points P at t. */
static inline num G(corrected_curve)(int n, int dim, const num P[], int c, num beta, num t)
{
    num sum = from_int(0);
    for (int i = 0; i <= n; i++)
        sum = add(sum, mul(P[i * dim + c], G(corrected)(n, i, beta, t)));
    return sum;
}
static inline num G(printed_curve)(int dim, const num P[], int c, num beta, num t)
{
    num sum = from_int(0);
    for (int i = 0; i <= 7; i++)
        sum = add(sum, mul(P[i * dim + c], G(printed)(i, beta, t)));
    return sum;
}

/* What follows is of the printed functions (n = 7), by the letter of formula (1), or of the corrected ones, by the kernels: the
 * factors at t = 0 and t = 1 and the Bernstein coefficients of degree n+1. */
static inline void G(factors_of)(int printed_ones, int n, num beta, num near[], num far[])
{
    if (!printed_ones)
        G(shape_factors)(n, beta, near, far);
    for (int i = 0; printed_ones && i <= 7; i++) {
        near[i] = G(printed_factor)(i, beta, from_int(0));
        far[i] = G(printed_factor)(i, beta, from_int(1));
    }
}
static inline void G(matrix_of)(int printed_ones, int n, num beta, num E[])
{
    num near[MAX_DEGREE + 1], far[MAX_DEGREE + 1];
    G(factors_of)(printed_ones, n, beta, near, far);
    G(shape_matrix)(n, near, far, E);
}

/* The values of the n+1 functions at t. */
static inline void G(functions_of)(int printed_ones, int n, num beta, num t, num B[])
{
    if (!printed_ones)
        G(shape_basis)(n, beta, t, B);
    for (int i = 0; printed_ones && i <= 7; i++)
        B[i] = G(printed)(i, beta, t);
}

/* The point of the curve of P at t, dim coordinates. */
static inline void G(curve_point)(int printed_ones, int n, int dim, const num P[], num beta, num t, num at[])
{
    if (!printed_ones)
        G(shape_point)(n, dim, P, beta, t, at);
    for (int c = 0; printed_ones && c < dim; c++)
        at[c] = G(printed_curve)(dim, P, c, beta, t);
}

/* The n+2 Bézier points of degree n+1 of the curve of P, dim coordinates, from the matrix. */
static inline void G(bezier_points_of)(int printed_ones, int n, int dim, const num P[], num beta, num Q[])
{
    num E[(MAX_DEGREE + 1) * MAX_DEGREE];
    G(matrix_of)(printed_ones, n, beta, E);
    for (int k = 0; k <= n + 1; k++)
        for (int c = 0; c < dim; c++) {
            Q[k * dim + c] = from_int(0);
            for (int i = 0; i <= n; i++)
                Q[k * dim + c] = add(Q[k * dim + c], mul(E[k * (n + 1) + i], P[i * dim + c]));
        }
}
#if RATIONAL
/* The factors as polynomials in beta: they are linear, so two values give them. */
static inline void G(factors_in_beta)(int printed_ones, int n, poly near[], poly far[])
{
    num at_0[2][MAX_DEGREE + 1], at_1[2][MAX_DEGREE + 1];
    G(factors_of)(printed_ones, n, from_int(0), at_0[0], at_0[1]);
    G(factors_of)(printed_ones, n, from_int(1), at_1[0], at_1[1]);
    for (int i = 0; i <= n; i++) {
        near[i] = poly_from_q(2, (num[]){at_0[0][i], sub(at_1[0][i], at_0[0][i])});
        far[i] = poly_from_q(2, (num[]){at_0[1][i], sub(at_1[1][i], at_0[1][i])});
    }
}

/* Function i of degree n as a polynomial in t, by its Bernstein coefficients of degree n+1. */
static inline poly G(function)(int printed_ones, int n, int i, num beta)
{
    num E[(MAX_DEGREE + 1) * MAX_DEGREE], column[MAX_DEGREE + 1];
    G(matrix_of)(printed_ones, n, beta, E);
    for (int k = 0; k <= n + 1; k++)
        column[k] = E[k * (n + 1) + i];
    return poly_from_bernstein(n + 1, column);
}

/* sum_i k_i B_i as a polynomial in t. */
static inline poly G(combination)(int printed_ones, int n, num beta, const num k[])
{
    num c[MAX_DEGREE + 1];
    G(bezier_points_of)(printed_ones, n, 1, k, beta, c);
    return poly_from_bernstein(n + 1, c);
}

/* The rank of a matrix, row by row, which is overwritten. */
static inline int G(rank)(int rows, int columns, num M[])
{
    int rank = 0;
    for (int c = 0; c < columns && rank < rows; c++) {
        int pivot = rank;
        while (pivot < rows && is_zero_q(M[pivot * columns + c]))
            pivot++;
        if (pivot == rows)
            continue;
        for (int j = c; j < columns; j++) {
            num kept = M[pivot * columns + j];
            M[pivot * columns + j] = M[rank * columns + j], M[rank * columns + j] = kept;
        }
        for (int r = rank + 1; r < rows; r++) {
            if (is_zero_q(M[r * columns + c]))
                continue;
            num factor = div(M[r * columns + c], M[rank * columns + c]);
            for (int j = c; j < columns; j++)
                if (!is_zero_q(M[rank * columns + j]))
                    M[r * columns + j] = sub(M[r * columns + j], mul(factor, M[rank * columns + j]));
        }
        rank++;
    }
    return rank;
}

/* The matrix of the functions for beta = 0 and what is added to it for each unit of beta. */
static inline void G(matrix_in_beta)(int printed_ones, num E[9 * 8], num D[9 * 8])
{
    G(matrix_of)(printed_ones, 7, from_int(0), E);
    G(matrix_of)(printed_ones, 7, from_int(1), D);
    for (int m = 0; m < 9 * 8; m++)
        D[m] = sub(D[m], E[m]);
}

/* V(k_0, ..., k_n): changes of sign, zeros skipped. */
static inline int G(sign_changes)(int n, const num k[])
{
    int changes = 0, last = 0;
    for (int i = 0; i <= n; i++)
        if (!is_zero_q(k[i])) {
            changes += last * sign_q(k[i]) < 0;
            last = sign_q(k[i]);
        }
    return changes;
}
#endif

enum { dim = 2 }; /* the plane: every formula is taken coordinate by coordinate */
#include "chapters/judge/claims_off.h"
