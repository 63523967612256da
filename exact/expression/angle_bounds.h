/* angle_bounds.h -- bounds of an angle as bounds of x, the tangent of its half or quarter (only for angle.c).
 *
 * An end is a multiple of pi; its tangent is -1, 0, 1, or a root of Im (1 + i x)^q.  The polynomial of such a root tells on which side of it x is as
 * long as no other of its roots is near: where one is within the bounds, x is looked at on both sides of a number between them.  A range that reaches
 * beyond the angle for which there is no x is what is above its first end or below its second one: two parts, too. */
#ifndef CAGD_ANGLE_BOUNDS_H
#define CAGD_ANGLE_BOUNDS_H

#include "exact/expression/evaluate.h"

/* From where to where an angle goes, as multiples of pi behind the one from which x counts; `quarters` is that one.  With `known` = 0 the bounds are
 * not such multiples; `all` means that it goes all around, or has no bounds; `wraps`, that it goes from the first end to where there is no x, and from
 * there to the second one. */
typedef struct cagd_way_around {
    int known, all, is_empty, quarters, wraps;
    cagd_num_q end[2];
} cagd_way_around;

/* phi is the angle over so much. */
int cagd_share_of_angle(const cagd_context *c);
cagd_way_around cagd_way_of_angle(const cagd_context *c, const cagd_variable *v);
/* Bounds of the angle as bounds of x; *has_apart: whether the angle without x is within them.  0 where that cannot be said; then a number at which x is
 * to be split may be noted in the context. */
int cagd_bound_angle(cagd_context *c, const cagd_variable *v, cagd_binding *b, const cagd_way_around *w,
                     int *has_apart);
#endif
