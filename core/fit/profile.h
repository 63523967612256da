/* profile.h -- intervals by the profile of the cost (轮廓似然), where those of the linear model cannot be relied on.
 *
 * An interval value +- q error takes the cost for a quadratic function of the unknowns.  For phi = c . theta, an unknown or
 * the logarithm of an invariant, let F(v) be the smallest cost of the curves with phi = v, a minimum under one condition.
 * The interval by the profile is
 *
 *     { v : 2 (F(v) - F) <= q^2 scale_squared },
 *
 * which is value +- q error when the cost is quadratic.
 *
 * Which is taken.  At the ends of the linear interval, reached in the direction in which the quadratic function is smallest, the
 * cost has grown by r times what that function says.  Of a normal number 2.5 % lie beyond q, and beyond q sqrt(r) between 1.5 and
 * 3.5 % for 0.85 <= r <= 1.23: inside of these bounds, at both ends, the linear interval covers 93 to 97 % as it should.  Of many points r
 * and the profile are found with means, which have the same cost about the minimum.  Outside of the bounds the profile is sought; where it does not come to its level, or the curve has more than MOST_UNKNOWNS unknowns, there is no
 * interval.  Of a curve of several segments the profile is not followed: a spline whose points can slide along it has costs
 * whose curvature changes from draw to draw, and where its profile was found it covered 87 to 93 % only (coverage_of_choices.c).  For
 * the same reason its r may be near 1 by chance: of intervals that one draw in six had, 88 % covered.  With d from the minimum to an
 * end of the linear interval, b_i = e_i(theta + d) + e_i(theta - d) - 2 e_i(theta) of the scaled distances e_i, and errors s,
 * the mean of r at both ends is 1 + sum e_i b_i/|J d|^2 + ..., which scatters by at most s |b|/|J d|^2 from draw to draw.  Where that is larger than 0.12,
 * r would be below 0.85 in a tenth of the draws, and there is no interval in any.
 * Where the options ask for no intervals, and with a smoothing term, whose bias is in no error, all are NOT_SOUGHT.
 *
 * Nothing is done, and all intervals are linear, for a robust loss, whose covariance is not from the cost; with free
 * directions or unknowns on bounds; and for points on the curve.
 * Source: bates-watts-1988, 6. */
#ifndef CAGD_FIT_PROFILE_H
#define CAGD_FIT_PROFILE_H

#include "core/fit/minimum.h"

/* Fills interval_by and interval, arrays that are there already, from the statistics, which are there, too.  Returns 0 when there is
 * no memory. */
int fit_profile(const fit_problem *problem, const fit_minimum *minimum, cagd_fit_result *result);
#endif
