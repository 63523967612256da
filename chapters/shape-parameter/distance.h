/* distance.h -- how far a plane curve of the family is from its polygon, decided exactly.
 *
 * Generic text, after exact/record/hull.h and definition.h; what decides is for rationals only. */
#include "chapters/judge/claims_on.h"

#if RATIONAL
/* A plane curve: the polynomials of its coordinates. */
struct G(path) {
    poly x, y;
};

static inline struct G(path) G(path_in)(int printed_ones, int n, const num P[], num beta)
{
    num Q[(MAX_DEGREE + 1) * dim], x[MAX_DEGREE + 1], y[MAX_DEGREE + 1];
    G(bezier_points_of)(printed_ones, n, dim, P, beta, Q);
    for (int k = 0; k <= n + 1; k++)
        x[k] = Q[k * dim], y[k] = Q[k * dim + 1];
    return (struct G(path)){poly_from_bernstein(n + 1, x), poly_from_bernstein(n + 1, y)};
}

/* a x(t) + b y(t) + c */
static inline poly G(along)(struct G(path) q, num a, num b, num c)
{
    return poly_add(poly_add(poly_scale(q.x, a), poly_scale(q.y, b)), poly_constant(c));
}

/* Is every point of [a,b] nearer than r to some edge, one edge for the whole interval and the foot on it? */
static inline int G(near_one_edge)(struct G(path) q, int n, const num P[], num r_squared, num a, num b)
{
    for (int i = 0; i < n; i++) {
        const num *A = P + i * dim, *B = A + dim;
        num d[dim] = {sub(B[0], A[0]), sub(B[1], A[1])}, size = G(norm_squared)(dim, d);
        if (is_zero_q(size))
            continue;
        poly foot = G(along)(q, d[0], d[1], neg(G(dot)(dim, d, A)));
        poly across = G(along)(q, neg(d[1]), d[0], neg(G(cross2)(d, A)));
        poly gap = poly_sub(poly_constant(mul(r_squared, size)), poly_mul(across, across));
        if (is_nonnegative_on(foot, a, b) && is_nonnegative_on(poly_sub(poly_constant(size), foot), a, b) &&
            sign_on(gap, a, b, CLOSED) == SIGN_POSITIVE)
            return 1;
    }
    return 0;
}

/* The same piece by piece; `cuts` halvings at most. */
static inline int G(nearer_than)(struct G(path) q, int n, const num P[], num r_squared, num a, num b, int cuts)
{
    if (G(near_one_edge)(q, n, P, r_squared, a, b))
        return 1;
    num middle = div(add(a, b), from_int(2));
    return cuts > 0 && G(nearer_than)(q, n, P, r_squared, a, middle, cuts - 1) &&
           G(nearer_than)(q, n, P, r_squared, middle, b, cuts - 1);
}

/* The squared distance of a point from the polygon. */
static inline num G(distance_squared)(int n, const num P[], const num X[])
{
    num best = from_int(0);
    for (int i = 0; i < n; i++) {
        const num *A = P + i * dim;
        num d[dim] = {sub(A[dim], A[0]), sub(A[dim + 1], A[1])}, w[dim] = {sub(X[0], A[0]), sub(X[1], A[1])};
        num size = G(norm_squared)(dim, d), foot = G(dot)(dim, d, w), gap[dim];
        num u = is_zero_q(size) || sign_q(foot) < 0 ? from_int(0)
                : compare_q(foot, size) > 0         ? from_int(1)
                                                    : div(foot, size);
        for (int c = 0; c < dim; c++)
            gap[c] = sub(w[c], mul(u, d[c]));
        num value = G(norm_squared)(dim, gap);
        if (i == 0 || compare_q(value, best) < 0)
            best = value;
    }
    return best;
}

/* A parameter of a point of the curve that is farther than r from the polygon, the first of 1/64, ..., 63/64; 0 if none is. */
static inline num G(parameter_farther_than)(int printed_ones, int n, const num P[], num beta, num r_squared)
{
    for (int m = 1; m < 64; m++) {
        num X[dim], t = from_ratio(m, 64);
        G(curve_point)(printed_ones, n, dim, P, beta, t, X);
        if (compare_q(G(distance_squared)(n, P, X), r_squared) > 0)
            return t;
    }
    return from_int(0);
}

/* Is the point X farther than r from the whole curve? */
static inline int G(curve_stays_away)(struct G(path) q, const num X[], num r_squared)
{
    poly x = poly_sub(q.x, poly_constant(X[0])), y = poly_sub(q.y, poly_constant(X[1]));
    poly gap = poly_sub(poly_add(poly_mul(x, x), poly_mul(y, y)), poly_constant(r_squared));
    return sign_on(gap, from_int(0), from_int(1), CLOSED) == SIGN_POSITIVE;
}

/* How many of the points P_0, ..., P_n are farther than R from the curve? */
static inline int G(points_far_from_the_curve)(int printed_ones, int n, const num P[], num beta, num R_squared)
{
    struct G(path) q = G(path_in)(printed_ones, n, P, beta);
    int far = 0;
    for (int i = 0; i <= n; i++)
        far += G(curve_stays_away)(q, P + i * dim, R_squared);
    return far;
}

/* Takes the n+1 points P, two values β and the square r² of a distance from the data of the claim.  Whether the curve of β_0 stays
 * nearer than r to the polygon and that of β_1 does not; with the corrected functions and, for n = 7, with the printed ones as
 * well.  Compares, as a result, for each family the parameter of a point that is farther. */
static inline int G(one_is_farther)(trial *T, int n, num P[], num beta[2])
{
    given_points(T, "P", n + 1, dim, P);
    given_points(T, "β", 2, 1, beta);
    num r_squared = given(T, "r²"), t[2];
    int families = n == 7 ? 2 : 1, farther = 0;
    for (int printed_ones = 0; printed_ones < families; printed_ones++) {
        struct G(path) near = G(path_in)(printed_ones, n, P, beta[0]);
        t[printed_ones] = G(parameter_farther_than)(printed_ones, n, P, beta[1], r_squared);
        farther += !is_zero_q(t[printed_ones]) && G(nearer_than)(near, n, P, r_squared, from_int(0), from_int(1), 9);
    }
    found_points(T, "t of a farther point", families, 1, t);
    return farther == families;
}

/* Refutes, for the data of the claim, that the polygon is not convex or that the curve of β_1 is not farther than that of β_0. */
static inline void G(refute_closer_to_a_convex_polygon)(trial *T, int n)
{
    num P[8 * dim], beta[2];
    int farther = G(one_is_farther)(T, n, P, beta);
    about(T, "the polygon is not convex, or the curve of the second beta is not farther");
    refute(T, polygon_is_convex(n, P, 1, NULL) && farther);
}
#endif
#include "chapters/judge/claims_off.h"
