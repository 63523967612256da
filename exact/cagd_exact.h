/* cagd_exact.h -- exact numbers for computer-aided geometric design, and decisions made with them.
 *
 *     cagd_num_q   rationals (GMP)                      cagd_num_f   rational functions in named variables (FLINT)
 *     cagd_num_i   intervals rounded outwards (MPFR)    cagd_poly    polynomials in one variable with rational coefficients
 *
 * Decisions: real roots counted and isolated, the sign of a polynomial on an interval, hulls and convexity with certificates, how
 * curves and polygons meet a line, minors and total positivity, determinants and resultants; and the exact curve.
 *
 * Values.  A value is a small struct, given and returned by value; it names something immutable, so results never overlap with
 * operands.  What it names lives in the region of the thread that made it, until that region is dropped to a mark made before:
 *
 *     cagd_region_mark mark = cagd_region_open();
 *     cagd_num_q third = cagd_from_ratio_q(1, 3);
 *     puts(cagd_to_string_q(cagd_add_q(third, third)));
 *     cagd_region_drop(mark);
 *
 * Nothing is freed one by one.  Strings, and arrays within results, live in the region too.
 *
 * Arguments.  No pointer may be NULL unless it says so, but an array of no elements may.  Arrays belong to the caller, have the
 * number of elements that the comment says, are only read unless they are called out, and those that are written overlap with
 * no other.  Counts, degrees and indices are not negative where nothing is said.
 *
 * Faults.  A function that has no answer sets bits of cagd_region_faults, and returns a placeholder that means nothing:
 * UNDEFINED, there is none; UNABLE, there may be one, which is not computed; CROWDED, more variables than the field was opened
 * for; MEMORY.  The bits stay until the caller clears them; so a computation runs to its end, and is asked once whether it went well.
 * While a bit is set rational functions are not computed any more.
 *
 * Threads.  Region, precision, faults and field are of the thread; threads do not wait for one another.  A value is used
 * in the thread that made it, or read in others while that thread does nothing with its region.  A thread that used
 * the library calls cagd_thread_end as its last act.
 *
 * Limits.  Degrees and counts are ints, and all that they imply has to fit in memory, or MEMORY is set: a matrix has fewer than
 * 2^31 entries.  A field has at most CAGD_FIELD_MAX_VARIABLES variables with names of at most CAGD_FIELD_MAX_NAME bytes;
 * numbers are read from at most 100 000 digits and with exponents of at most 99 999; precision is at most 2^24 bits; the exact
 * curve has the limits of cagd.h, CAGD_MAX_DEGREE and CAGD_MAX_DIM.  No input ends the process.  What does end it is an
 * allocation of GMP, MPFR or FLINT that fails, and in this library a number for which there is no place; cagd_without_memory names
 * what is called then.
 *
 * Names end in the type of number: _q, _i, _f. */
#ifndef CAGD_EXACT_H
#define CAGD_EXACT_H

#include "core/api/cagd.h"

#include <gmp.h>
#include <mpfr.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* In this order: each after those that it needs. */
/* clang-format off */
#include "exact/number/region.h"
#include "exact/number/rational.h"
#include "exact/number/interval.h"
#include "exact/number/field.h"
#include "exact/number/polynomial.h"
#include "exact/number/parallel.h"
#include "exact/decide/roots.h"
#include "exact/decide/sign.h"
#include "exact/decide/sturm.h"
#include "exact/decide/hull.h"
#include "exact/decide/linear.h"
#include "exact/decide/crossings.h"
#include "exact/decide/resultant.h"
#include "exact/decide/total_positivity.h"
#include "exact/curve/spline.h"
/* clang-format on */

#ifdef __cplusplus
}
#endif
#endif
