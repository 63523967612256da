/* resultant.h -- resultants by Sylvester's and by Bezout's matrix, and determinants with pivoting.
 *
 * For p = a_m t^m + ... + a_0 and q = b_n t^n + ... + b_0, m, n being what the caller says,
 *
 *     Res(p, q) = a_m^n b_n^m product (alpha_i - beta_j)        (a_m, b_n != 0),
 *
 * alpha_i and beta_j the roots.  It is 0 exactly when p and q have a common factor or a_m = b_n = 0.
 * Matrices are row by row in one array.  Arrays of coefficients begin with the constant one.
 * Source: sylvester-1840; bezout-1779; cox-little-oshea-2005, 3.1; bareiss-1968. */
#ifndef CAGD_RESULTANT_H
#define CAGD_RESULTANT_H

#include "exact/number/polynomial.h"

/* det A for n x n; 1 for n = 0.  _q: fraction-free elimination over the integers.  _f: the same rule
 * in the field, where the divisions are exact as well. */
cagd_num_q cagd_pivoted_determinant_q(int n, const cagd_num_q A[]);
cagd_num_f cagd_pivoted_determinant_f(int n, const cagd_num_f A[]);

/* (m + n) x (m + n): n rows a_m ... a_0, each shifted by one place, then m rows b_n ... b_0. */
void cagd_sylvester_matrix_q(int m, const cagd_num_q a[], int n, const cagd_num_q b[], cagd_num_q S[]);
void cagd_sylvester_matrix_f(int m, const cagd_num_f a[], int n, const cagd_num_f b[], cagd_num_f S[]);

/* m x m for m >= n: (p(x) q(y) - p(y) q(x)) / (x - y) = sum B_ij x^i y^j. */
void cagd_bezout_matrix_q(int m, const cagd_num_q a[], int n, const cagd_num_q b[], cagd_num_q B[]);
void cagd_bezout_matrix_f(int m, const cagd_num_f a[], int n, const cagd_num_f b[], cagd_num_f B[]);

/* Res(p, q) from either matrix.  det B = (-1)^(m(m-1)/2) a_m^(m-n) Res(p, q) for m >= n, so that
 * Bezout's way is UNDEFINED when m != n and the leading coefficient of the higher degree is 0. */
cagd_num_q cagd_resultant_sylvester_q(int m, const cagd_num_q a[], int n, const cagd_num_q b[]);
cagd_num_f cagd_resultant_sylvester_f(int m, const cagd_num_f a[], int n, const cagd_num_f b[]);
cagd_num_q cagd_resultant_bezout_q(int m, const cagd_num_q a[], int n, const cagd_num_q b[]);
cagd_num_f cagd_resultant_bezout_f(int m, const cagd_num_f a[], int n, const cagd_num_f b[]);

/* The resultant of two elements of the field as polynomials in one of its variables, m and n their degrees
 * in it.  UNDEFINED when one of them is 0 or has the variable in its denominator. */
cagd_num_f cagd_resultant_by_f(cagd_num_f p, cagd_num_f q, cagd_num_f variable);

/* The same for polynomials, m and n their degrees.  UNDEFINED when one of them is 0. */
cagd_num_q cagd_poly_resultant_sylvester(cagd_poly p, cagd_poly q);
cagd_num_q cagd_poly_resultant_bezout(cagd_poly p, cagd_poly q);
#endif
