/* polynomial.h -- polynomials in one variable over Q.
 *
 * A poly names an immutable value that lives until its region is dropped; the coefficients of a
 * polynomial that was given are kept exactly, nothing is rounded.  Degrees fit in an int. */
#ifndef CAGD_POLYNOMIAL_H
#define CAGD_POLYNOMIAL_H

#include "exact/number/field.h"
#include "exact/number/rational.h"

typedef struct poly {
    const struct polynomial *at;
} poly;

poly poly_from_q(int len, const num_q c[]);       /* sum c[k] t^k, 0 <= k < len; len = 0 gives 0     */
poly poly_from_bernstein(int n, const num_q b[]); /* sum b[i] B_i^n(t), 0 <= i <= n, over [0,1]     */
poly poly_constant(num_q c);
poly poly_variable(void);

/* a = numerator/denominator in lowest terms as a rational function of one variable of the field.
 * UNDEFINED when `variable` is not a variable, UNABLE when another one occurs in a. */
void poly_from_field(num_f a, num_f variable, poly *numerator, poly *denominator);

int poly_degree(poly p);               /* -1 for the zero polynomial                               */
num_q poly_coefficient(poly p, int k); /* of t^k, k >= 0; zero beyond the degree                   */
int poly_is_zero(poly p);
int poly_equal(poly p, poly q);

poly poly_add(poly p, poly q);
poly poly_sub(poly p, poly q);
poly poly_mul(poly p, poly q);
poly poly_neg(poly p);
poly poly_scale(poly p, num_q c);
poly poly_derivative(poly p);
num_q poly_value(poly p, num_q t);
poly poly_compose(poly p, poly q); /* p(q(t))                                                       */

/* p = q quotient + remainder with deg remainder < deg q.  UNDEFINED for q = 0. */
poly poly_quotient(poly p, poly q);
poly poly_remainder(poly p, poly q);
int poly_divides(poly d, poly p); /* p is a multiple of d; 0 divides 0 alone                        */
poly poly_gcd(poly p, poly q);    /* the monic one; 0 for p = q = 0                                 */

/* p = c factor[0]^multiplicity[0] factor[1]^multiplicity[1] ..., c rational, the factors monic,
 * squarefree, coprime in pairs and not constant, the multiplicities increasing.  Returns how many
 * there are, never more than deg p; both arrays have that much room.  UNDEFINED for p = 0.
 * Source: D. Y. Y. Yun, On square-free decomposition algorithms, SYMSAC 1976. */
int poly_squarefree(poly p, poly factor[], int multiplicity[]);

/* out[0..n] with p(a + (b - a) t) = sum out[i] B_i^n(t).  UNDEFINED when n < deg p. */
void poly_to_bernstein(poly p, int n, num_q a, num_q b, num_q out[]);

int trace_polynomial(poly p); /* its node in the open trace (trace.h), made if there is none           */

const char *poly_to_string(poly p, const char *variable); /* "t^2 - 1/3*t + 1"; in the region        */
#endif
