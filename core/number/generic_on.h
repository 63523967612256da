/* generic_on.h -- open a generic section: text that is written once and means every number type.
 *
 * Before such text is included, G says how names are completed:
 *
 *     #define G(name) name##_q        d binary64        m binary64 with a running error bound
 *     #include "core/kernels/kernels.tmpl.h"  q rationals       i intervals
 *     #undef G                        f rational functions in named variables
 *
 * Inside the section the plain words below mean num_q, add_q, ... and G(name) names the instance.
 * Values are immutable: no operation writes to its operands, so operands cannot alias results.
 * Two numbers are never compared here; what depends on an order is decided outside, exactly.
 * generic_off.h closes the section.
 *
 * A kernel begins with the word KERNEL.  It is an inline function wherever its text is included, unless the file that
 * includes it says otherwise; prototypes.cmake finds the kernels by this word. */
#ifndef G
#error "define G(name) as name##_SUFFIX before including generic text"
#endif

#ifndef KERNEL
#define KERNEL static inline
#endif

/* A curve as an argument: p, n, dim, knots, points, and weights (kernels/spline_type.tmpl.h). */
#define spline(p, n, dim, u, c)   (&(const struct G(spline)){(p), (n), (dim), (u), (c), NULL})
#define nurbs(p, n, dim, u, R, w) (&(const struct G(spline)){(p), (n), (dim), (u), (R), (w)})

#define num        G(num)
#define add        G(add)        /* a + b                                                        */
#define sub        G(sub)        /* a - b                                                        */
#define mul        G(mul)        /* a b                                                          */
#define div        G(div)        /* a / b; UNDEFINED when b is 0                                 */
#define neg        G(neg)        /* -a                                                           */
#define from_int   G(from_int)   /* the image of an integer                                      */
#define from_ratio G(from_ratio) /* the image of m/n, n != 0                                     */
#define root       G(root)       /* root(n, a): the n-th root of a, >= 0 where that has a        */
                                 /* meaning; UNABLE where the field has no such element          */
