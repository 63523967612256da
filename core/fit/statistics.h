/* statistics.h -- what the residuals of a fit say about its unknowns.
 *
 * The model.  Every point lies on the curve but for independent errors of one size in all coordinates.  Along the curve
 * an error only moves the foot point; across it there are dim-1 residuals a point, so that the equations are
 * n = N (dim-1) in number, and one more for each foot that is shared with the point before; the points of measured ends have dim residuals each, and then n = N (dim-1) + 2.
 * A point that is a given end of the curve has distance 0 whatever the unknowns are, and no equation: with exact ends n = (N-2) (dim-1).  k is
 * how many unknowns the points determine, which is the rank of the problem, and less with a smoothing term.  d = n - k are its degrees of
 * freedom (自由度), for which k is rounded.
 *
 *     s_i = |Q_i - C(t_i)|^2 / s_i^2   (unknown standard deviations: s_i^2 = 1)
 *     chi_squared          sum_i rho(s_i), which is twice the cost; for squares the sum of the s_i
 *     reduced_chi_squared  chi_squared / d
 *     scale_squared        what (J^T J)^+ is multiplied by to become the covariance:
 *                          1 for squares and given standard deviations; for squares and unknown ones chi_squared / d, the
 *                          estimate of their square; for a robust loss Huber's factor below
 *     aic, bic             given standard deviations    chi_squared + 2 k             chi_squared + k log n
 *                          unknown ones                 n log(chi_squared/n) + 2(k+1)   the same with (k+1) log n
 *                          but for a constant of the points; to be compared among fits of the same points with the same loss
 *     quantile             of the 95 % intervals: normal for squares with given standard deviations, where nothing is
 *                          estimated; otherwise Student's t with d degrees of freedom
 *
 * A robust loss.  Points that do not obey the standard deviations are the reason for it, so these are not believed.
 * The covariance is that of an M-estimate (M 估计): with psi_i = rho'(s_i) times the residual vector, whose matrix of
 * derivatives has the mean diagonal m_i = rho'(s_i) + 2 s_i rho''(s_i)/(dim-1),
 *
 *     scale_squared = K^2 (sum_i rho'(s_i)^2 s_i / d) / M^2,   M = mean of the m_i of points with equations,   K = 1 + (k/n) var(m_i)/M^2, k rounded.
 *
 * This is the sandwich A^{-1} B A^{-1} of the asymptotic theory when the errors are independent of the place on the
 * curve, so that A = M J^T J and B = mean(|psi|^2/(dim-1)) J^T J; the full sandwich with A = sum_i m_i j_i j_i^T
 * would do without that but rests on the few residuals near each place and is too small in small samples.  For
 * squares the formula is chi_squared / d.  Source: huber-1981, 7.6.
 *
 * What cannot be known is NaN: with d = 0 and unknown standard deviations, or where M <= 0. */
#ifndef CAGD_FIT_STATISTICS_H
#define CAGD_FIT_STATISTICS_H

#include "core/fit/cagd_fit.h"

/* k, rounded: so many unknowns degrees_of_freedom is less than the equations; all of them where `effective` is NaN. */
int fit_counted_unknowns(const cagd_fit_result *result);

/* Called at the end of a fit.  Reads the curve, residuals, cost, unknowns, rank, free directions; covariance holds
 * (J^T J)^+, and is multiplied by scale_squared here.  Fills scale_squared, scale_is_given, ends_are_exact,
 * chi_squared, reduced_chi_squared, degrees_of_freedom, aic, bic, quantile; and for a curve of one span of degree >=
 * 2 invariant and invariant_error, arrays of degree-1 that are there already, `invariants` in number: I_j =
 * w_j^2/(w_{j-1} w_{j+1}), with the error I_j times that of log I_j, which is linear in the unknowns; infinite where
 * log I_j changes along a free direction. */
void fit_statistics(const cagd_fit_data *data, const cagd_fit_options *options, cagd_fit_result *result);
#endif
