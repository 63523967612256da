/* polynomial.h -- polynomials in one variable over Q.
 *
 * A cagd_poly names an immutable value that lives until its region is dropped; the coefficients of a
 * polynomial that was given are kept exactly, nothing is rounded.  Degrees fit in an int. */
#ifndef CAGD_POLYNOMIAL_H
#define CAGD_POLYNOMIAL_H

#include "exact/number/field.h"
#include "exact/number/rational.h"

typedef struct cagd_poly {
    const struct cagd_polynomial *at;
} cagd_poly;

cagd_poly cagd_poly_from_q(int len, const cagd_num_q c[]);       /* sum c[k] t^k, 0 <= k < len; len = 0 gives 0     */
cagd_poly cagd_poly_from_bernstein(int n, const cagd_num_q b[]); /* sum b[i] B_i^n(t), 0 <= i <= n, over [0,1]     */
cagd_poly cagd_poly_constant(cagd_num_q c);
cagd_poly cagd_poly_variable(void);

/* a = numerator/denominator in lowest terms as a rational function of one variable of the field.
 * UNDEFINED when `variable` is not a variable, UNABLE when another one occurs in a. */
void cagd_poly_from_field(cagd_num_f a, cagd_num_f variable, cagd_poly *numerator, cagd_poly *denominator);

int cagd_poly_degree(cagd_poly p);                    /* -1 for the zero polynomial                               */
cagd_num_q cagd_poly_coefficient(cagd_poly p, int k); /* of t^k, k >= 0; zero beyond the degree                   */
int cagd_poly_is_zero(cagd_poly p);
int cagd_poly_equal(cagd_poly p, cagd_poly q);

cagd_poly cagd_poly_add(cagd_poly p, cagd_poly q);
cagd_poly cagd_poly_sub(cagd_poly p, cagd_poly q);
cagd_poly cagd_poly_mul(cagd_poly p, cagd_poly q);
cagd_poly cagd_poly_neg(cagd_poly p);
cagd_poly cagd_poly_scale(cagd_poly p, cagd_num_q c);
cagd_poly cagd_poly_derivative(cagd_poly p);
cagd_num_q cagd_poly_value(cagd_poly p, cagd_num_q t);
cagd_poly cagd_poly_compose(cagd_poly p, cagd_poly q); /* p(q(t)); MEMORY when its degree does not fit       */

/* p = q quotient + remainder with deg remainder < deg q.  UNDEFINED for q = 0. */
cagd_poly cagd_poly_quotient(cagd_poly p, cagd_poly q);
cagd_poly cagd_poly_remainder(cagd_poly p, cagd_poly q);
int cagd_poly_divides(cagd_poly d, cagd_poly p);   /* p is a multiple of d; 0 divides 0 alone                        */
cagd_poly cagd_poly_gcd(cagd_poly p, cagd_poly q); /* the monic one; 0 for p = q = 0                                 */

/* p = c factor[0]^multiplicity[0] factor[1]^multiplicity[1] ..., c rational, the factors monic,
 * squarefree, coprime in pairs and not constant, the multiplicities increasing.  Returns how many
 * there are, never more than deg p; both arrays have that much room.  UNDEFINED for p = 0.
 * Source: yun-1976. */
int cagd_poly_squarefree(cagd_poly p, cagd_poly factor[], int multiplicity[]);

/* The multiple of p whose coefficients are whole numbers without a common divisor, the leading one positive; 0 for p = 0. */
cagd_poly cagd_poly_primitive(cagd_poly p);

/* out[0..n] with p(a + (b - a) t) = sum out[i] B_i^n(t).  UNDEFINED when n < deg p. */
void cagd_poly_to_bernstein(cagd_poly p, int n, cagd_num_q a, cagd_num_q b, cagd_num_q out[]);

const char *cagd_poly_to_string(cagd_poly p, const char *variable); /* "t^2 - 1/3*t + 1"; in the region        */
#endif
