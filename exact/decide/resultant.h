/* resultant.h -- resultants by Sylvester's and by Bezout's matrix, and determinants with pivoting.
 *
 * For p = a_m t^m + ... + a_0 and q = b_n t^n + ... + b_0, m, n being what the caller says,
 *
 *     Res(p, q) = a_m^n b_n^m product (alpha_i - beta_j)        (a_m, b_n != 0),
 *
 * alpha_i and beta_j the roots.  It is 0 exactly when p and q have a common factor or a_m = b_n = 0.
 * Matrices are row by row in one array.  Arrays of coefficients begin with the constant one.
 * Source: J. J. Sylvester 1840, E. Bezout 1779; D. Cox, J. Little, D. O'Shea, Using Algebraic
 * Geometry, 3.1; E. H. Bareiss, Math. Comp. 22 (1968). */
#ifndef CAGD_RESULTANT_H
#define CAGD_RESULTANT_H

#include "exact/decide/polynomial.h"

/* det A for n x n; 1 for n = 0.  _q: fraction-free elimination over the integers.  _f: the same rule
 * in the field, where the divisions are exact as well. */
num_q pivoted_determinant_q(int n, const num_q A[]);
num_f pivoted_determinant_f(int n, const num_f A[]);

/* (m + n) x (m + n): n rows a_m ... a_0, each shifted by one place, then m rows b_n ... b_0. */
void sylvester_matrix_q(int m, const num_q a[], int n, const num_q b[], num_q S[]);
void sylvester_matrix_f(int m, const num_f a[], int n, const num_f b[], num_f S[]);

/* m x m for m >= n: (p(x) q(y) - p(y) q(x)) / (x - y) = sum B_ij x^i y^j. */
void bezout_matrix_q(int m, const num_q a[], int n, const num_q b[], num_q B[]);
void bezout_matrix_f(int m, const num_f a[], int n, const num_f b[], num_f B[]);

/* Res(p, q) from either matrix.  det B = (-1)^(m(m-1)/2) a_m^(m-n) Res(p, q) for m >= n, so that
 * Bezout's way is UNDEFINED when m != n and the leading coefficient of the higher degree is 0. */
num_q resultant_sylvester_q(int m, const num_q a[], int n, const num_q b[]);
num_f resultant_sylvester_f(int m, const num_f a[], int n, const num_f b[]);
num_q resultant_bezout_q(int m, const num_q a[], int n, const num_q b[]);
num_f resultant_bezout_f(int m, const num_f a[], int n, const num_f b[]);

/* The resultant of two elements of the field as polynomials in one of its variables, m and n their degrees
 * in it.  UNDEFINED when one of them is 0 or has the variable in its denominator. */
num_f resultant_by_f(num_f p, num_f q, num_f variable);

/* The same for polynomials, m and n their degrees.  UNDEFINED when one of them is 0. */
num_q poly_resultant_sylvester(poly p, poly q);
num_q poly_resultant_bezout(poly p, poly q);
#endif
