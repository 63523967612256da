/* polynomial.h -- what is asked of polynomials (exact/number/polynomial.h), with testimony (number.h). */
#ifndef CAGD_RECORD_POLYNOMIAL_H
#define CAGD_RECORD_POLYNOMIAL_H

#include "exact/number/polynomial.h"

int cagd_testify_poly_degree(cagd_poly p);
int cagd_testify_poly_is_zero(cagd_poly p);
int cagd_testify_poly_equal(cagd_poly p, cagd_poly q);
int cagd_testify_poly_divides(cagd_poly d, cagd_poly p); /* of the remainder it is noted whether it is 0 */

#define poly_degree  cagd_testify_poly_degree
#define poly_is_zero cagd_testify_poly_is_zero
#define poly_equal   cagd_testify_poly_equal
#define poly_divides cagd_testify_poly_divides
#endif
