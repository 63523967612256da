/* rank.h -- what a triangle R says about its unknowns: rank, generalised inverse, flat directions (秩、广义逆). */
#ifndef CAGD_FIT_RANK_H
#define CAGD_FIT_RANK_H

/* The singular values of R with columns scaled to length 1, columns with fixed[k] != 0 taken as zero.  Those below
 * u sqrt(n) (rows + roundings) times the largest count as 0: the entries of the Jacobian suffer so many `roundings`
 * of relative size u, its reduction as many as it has rows. */
typedef struct fit_rank {
    int n, rank, flat; /* flat: columns that are not fixed, less the rank                             */
    double smallest;   /* below this a singular value counts as 0                                      */
    double *scale;     /* length of each column, 1 for one of length 0                                */
    double *U, *s, *V; /* of the scaled R, by rows                                                     */
} fit_rank;

/* Singular values below this part of the largest one count as 0. */
double fit_rank_threshold(int n, int rows, int roundings);

/* W = R^-1, R a triangle, n^2 numbers by rows; returns 0, and W is of no use, where R may lose a rank by the measure above: with
 * columns scaled to length 1, R D^-1, its largest singular value is at most sqrt(n), and its smallest one at least
 * 1/|D R^-1|, Frobenius's norm. */
int fit_rank_inverse(int n, int rows, int roundings, const double R[], int stride, double W[]);

/* covariance[n n] = (A^T A)^-1 by that inverse, of the triangle that A is made into, in a fraction of the time of singular values;
 * returns 0, and nothing is done, where it may lose a rank, and -1 when there is no memory. */
int fit_rank_regular(int n, int rows, int roundings, const double A[], int stride, double covariance[]);

/* Returns 0 when there is no memory. */
int fit_rank_of(int n, int rows, int roundings, const double R[], int stride, const int fixed[], fit_rank *rank);
void fit_rank_free(fit_rank *rank);

/* covariance[n n] = (R^T R)^+ in scaled columns; flat_directions[flat n], orthonormal; determined[k] = 1 where no
 * flat direction moves unknown k and it is not fixed. */
void fit_rank_report(const fit_rank *rank, const int fixed[], double covariance[], double flat_directions[],
                     int determined[]);
#endif
