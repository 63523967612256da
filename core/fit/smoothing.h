/* smoothing.h -- the smoothing term of a spline as rows of a least-squares problem (光顺项).
 *
 * lambda/2 integral |S''(u)|^2 du, S = sum N_j P_j and u = (t - start)/(end - start) from 0 to 1.  Over a piece S'' is a polynomial of degree
 * p-2, so that p-1 nodes of Gauss and Legendre integrate its square without error.  Node g of weight W gives one row a
 * coordinate,
 *
 *     sqrt(lambda W) sum_m N_m''(u_g) P_m,
 *
 * which depends on the points of its piece alone, as those of measured points do. */
#ifndef CAGD_FIT_SMOOTHING_H
#define CAGD_FIT_SMOOTHING_H

#include "core/fit/problem.h"

/* How many nodes a piece has: 0 without a smoothing term. */
int fit_smoothing_nodes(const fit_problem *problem);

/* row[m] = sqrt(lambda W) N_m'' at node g of the piece of the curve, m = 0, ..., p. */
void fit_smoothing_row(const fit_problem *problem, const fit_curve *curve, int piece, int g, double row[]);

/* The coordinate c of that sum for the points of the curve. */
double fit_smoothing_residual(const fit_problem *problem, const fit_curve *curve, int piece, const double row[], int c);

/* The square of all rows together: lambda times the integral. */
double fit_smoothing_square(const fit_problem *problem, const fit_curve *curve);

/* The number of unknowns that the points determine, tr H^-1 J^T J with H = J^T J + K, and with `sandwich` H^-1 J^T J H^-1 in
 * the place of J^T J: `normal` and `smooth` are J^T J and K by the unknowns, n x n; H, n x n, is overwritten.  NaN where H is not positive
 * definite. */
double fit_smoothing_sandwich(int n, double normal[], const double smooth[], double H[], int sandwich);
#endif
