/* algebraic.h -- points whose coordinates are real algebraic numbers (实代数点).
 *
 * All coordinates are polynomials over Q in one number theta, the real root of an irreducible polynomial m with leading coefficient 1 in an interval: the point is
 * over the field K = Q(theta), whose elements are polynomials modulo m.  Zero is the zero polynomial; the sign of any other element is
 * that of its values between rational numbers so near to theta that it has no root there.  A root of a polynomial over K makes a
 * larger field, of which theta' = eta + c theta is a primitive element for all but finitely many c (本原元定理).  Source: cohen-1993,
 * 3.6.2, 4.2; cox-little-oshea-2005, 3.1. */
#ifndef CAGD_ALGEBRAIC_H
#define CAGD_ALGEBRAIC_H

#include "exact/decide/roots.h"

enum { CAGD_MOST_COORDINATES = 8, CAGD_MOST_OVER_K = 24 };

typedef struct cagd_algebraic_point {
    struct cagd_root theta; /* the only root of theta.factor = m between its ends; of degree 1 where K = Q */
    int count;
    cagd_poly coordinate[CAGD_MOST_COORDINATES]; /* in theta, reduced modulo m                              */
} cagd_algebraic_point;

/* No coordinates, K = Q. */
cagd_algebraic_point cagd_algebraic_origin(void);

/* The value of the polynomial p of the field in x[0], ..., x[count-1], as an element of K. */
cagd_poly cagd_algebraic_value(const cagd_algebraic_point *a, cagd_num_f p, const cagd_num_f x[]);
/* The sign of that element: -1, 0, 1. */
int cagd_algebraic_sign(const cagd_algebraic_point *a, cagd_poly element);

/* sum c[k] y^k over K, of degree `degree`, -1 for 0: p as a polynomial in y = x[count]; UNABLE for more than CAGD_MOST_OVER_K. */
typedef struct cagd_over_k {
    int degree;
    cagd_poly c[CAGD_MOST_OVER_K + 1];
} cagd_over_k;
cagd_over_k cagd_algebraic_polynomial(const cagd_algebraic_point *a, cagd_num_f p, const cagd_num_f x[]);

/* A real root: the number lo = hi, or the only root of *of, squarefree, in the open interval (lo,hi). */
typedef struct cagd_root_over_k {
    cagd_num_q lo, hi;
    const cagd_over_k *of;
} cagd_root_over_k;

/* The different real roots of all polynomials that are not 0, increasing, with room between neighbours, to out[]; their number, or -1
 * where there are more than `room` or the degrees are too high. */
int cagd_roots_over_k(const cagd_algebraic_point *a, int count, const cagd_over_k p[], int room,
                      cagd_root_over_k out[]);

/* The point with one coordinate more: a number, or a root, for which `carrier` is any variable of the field.  UNABLE where the degree of K would be
 * too high. */
cagd_algebraic_point cagd_algebraic_with_number(const cagd_algebraic_point *a, cagd_num_q y);
cagd_algebraic_point cagd_algebraic_with_root(const cagd_algebraic_point *a, const cagd_root_over_k *r,
                                              cagd_num_f carrier);

/* A coordinate as a root of its minimal polynomial; lo = hi where it is a rational number. */
struct cagd_root cagd_algebraic_coordinate(const cagd_algebraic_point *a, int k);
#endif
