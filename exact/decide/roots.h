/* roots.h -- real roots of a polynomial over Q, by Descartes' rule of signs in the Bernstein basis.
 *
 * Over an interval a polynomial has at most as many roots inside as its Bernstein coefficients have
 * changes of sign, and as many modulo 2; so 0 and 1 decide, and de Casteljau's algorithm at 1/2
 * subdivides what they do not.  A squarefree polynomial is decided after finitely many steps.
 * Source: lane-riesenfeld-1981; eigenwillig-sharma-yap-2006, for the end of the
 * subdivision, a theorem of Obreschkoff. */
#ifndef CAGD_ROOTS_H
#define CAGD_ROOTS_H

#include "exact/number/polynomial.h"

/* [a,b], (a,b), (a,b], [a,b).  For a = b the interval is {a} if CAGD_CLOSED and otherwise empty. */
enum cagd_ends { CAGD_CLOSED, CAGD_OPEN, CAGD_OPEN_LEFT, CAGD_OPEN_RIGHT };

struct cagd_root_count {
    int distinct;  /* different roots in the interval                                            */
    int counted;   /* the same, each as often as its multiplicity                                */
    int crossings; /* different roots of odd multiplicity in (a,b): there the sign changes       */
    int touches;   /* different roots of even multiplicity in (a,b): there it does not           */
};

/* UNDEFINED for p = 0 (every number is a root) and for a > b. */
struct cagd_root_count cagd_count_roots(cagd_poly p, cagd_num_q a, cagd_num_q b, enum cagd_ends ends);

/* The same over the real line, (a, infinity), (-infinity, b).  UNDEFINED for p = 0. */
struct cagd_root_count cagd_count_roots_line(cagd_poly p);
struct cagd_root_count cagd_count_roots_above(cagd_poly p, cagd_num_q a);
struct cagd_root_count cagd_count_roots_below(cagd_poly p, cagd_num_q b);

/* A power B of two such that -B < x < B for every root x of p, the complex ones included.
 * UNDEFINED for p = 0.  Source: fujiwara-1916. */
cagd_num_q cagd_root_bound(cagd_poly p);

/* One real root: the number lo = hi, or the only root of the squarefree polynomial `factor` in the
 * open interval (lo,hi).  The ends of that interval may be roots themselves, other ones. */
struct cagd_root {
    cagd_num_q lo, hi;
    int multiplicity; /* in the polynomial that was asked about, a multiple of factor            */
    cagd_poly factor;
};

/* The different roots in [a,b] in increasing order, in disjoint intervals; the first `room` of them
 * go to out.  Returns how many there are.  UNDEFINED for p = 0 and for a > b. */
int cagd_isolate_roots(cagd_poly p, cagd_num_q a, cagd_num_q b, struct cagd_root out[], int room);

/* The same root with hi - lo <= width, by bisection.  UNDEFINED unless width > 0. */
struct cagd_root cagd_refine_root(struct cagd_root r, cagd_num_q width);

/* The simplest rational between a and b: a < x < b, the denominator being least, and then the numerator. */
cagd_num_q cagd_simplest_between(cagd_num_q a, cagd_num_q b);
#endif
