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

/* Returns 0 when there is no memory. */
int fit_rank_of(int n, int rows, int roundings, const double R[], int stride, const int fixed[], fit_rank *rank);
void fit_rank_free(fit_rank *rank);

/* covariance[n n] = (R^T R)^+ in scaled columns; flat_directions[flat n], orthonormal; determined[k] = 1 where no
 * flat direction moves unknown k and it is not fixed. */
void fit_rank_report(const fit_rank *rank, const int fixed[], double covariance[], double flat_directions[],
                     int determined[]);
#endif
