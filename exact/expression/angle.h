/* angle.h -- sines and cosines of angles (角).
 *
 * An angle is a name; with phi half of it, or a quarter where halves of angles come up, all its sines and cosines are rational functions
 * of x = tan phi, and so are those of sums of angles and of multiples of pi/12.  The angle for which there is no x is looked at apart.
 * An argument of a definition in which its letter stands in angles is one itself: what it is, is asked for where it is used.
 * Bounds of angles are multiples of pi; where x is no rational number there its bound is a root, and rational numbers beyond it are the bounds
 * that everything else knows: what holds between those, holds; what fails is looked at once more.  The derivative by the angle is
 * (1 + x^2) d/dx times phi's share in it.
 *
 * An angle that is a number, too, as in t - \sin t, or whose bounds are numbers, is two variables, and \pi as a number is one: what holds for all
 * values of them holds.  What does not is looked at with one value for both (enclosed.h). */
#ifndef CAGD_ANGLE_H
#define CAGD_ANGLE_H

#include "exact/expression/evaluate.h"

/* \sin a, \cos a. */
cagd_value cagd_circular(cagd_context *c, const cagd_tree *t, const cagd_frame *f);

/* Numbers between which \pi is: convergents of its continued fraction. */
cagd_num_q cagd_below_pi(void);
cagd_num_q cagd_above_pi(void);

/* Whether halves of angles are in the statement, or in any definition: then x is the tangent of a quarter. */
int cagd_has_half_angles(const cagd_scope *scope, const cagd_tree *statement);
/* Whether the tree is a multiple of \pi by a rational number, 0 for instance, and which. */
int cagd_multiple_of_pi(const cagd_scope *scope, const cagd_tree *t, cagd_num_q *times);
/* The name of x for that angle, "\tan(\theta/2)"; whether there was room. */
int cagd_key_of_tangent(const cagd_context *c, const char *angle, char key[], int room);

/* Whether the lower end of x, for k = 1 the upper one, is a root: then *p is a polynomial that is positive inside, 0 there and negative outside, within the rational
 * bounds.  And whether a number within those is inside, for x or what is no tangent. */
int cagd_end_of_angle(const cagd_binding *b, int k, cagd_num_f *p);
int cagd_is_within_angle(const cagd_binding *b, cagd_num_q x);

/* Whether argument k of the name that d and others define is an angle: in some of them its letter stands in a sine or cosine. */
int cagd_is_angle_argument(cagd_context *c, const cagd_definition *d, int k);
/* Whether the letter stands in a sine or cosine of the tree, or of what it calls. */
int cagd_is_angle_in(cagd_context *c, const cagd_tree *t, const char *letter);

/* The derivative by the angle whose x is a variable. */
cagd_num_f cagd_by_angle_f(const cagd_context *c, cagd_num_f g, cagd_num_f x);
#endif
