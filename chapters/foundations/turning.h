/* turning.h -- the matrices by which a point is turned again and again, a row times a matrix at every step.
 *
 * A 2 x 2 matrix is M = (M_0 M_1; M_2 M_3).  Generic text, for the sections on the three ways to make a circle. */
#include "chapters/foundations/definition.h"

#include "chapters/judge/claims_on.h"

/* out = [x y] M, the row v = [x y] times the matrix M */
static inline void G(row_times)(const num v[restrict], const num M[restrict], num out[restrict])
{
    for (int j = 0; j < 2; j++)
        out[j] = add(mul(v[0], M[j]), mul(v[1], M[2 + j]));
}

/* The rotation by an angle with these cosine and sine, formula (1-3-2):  (cos sin; -sin cos) */
static inline void G(rotation)(struct G(turn) angle, num M[])
{
    M[0] = M[3] = angle.cos;
    M[1] = angle.sin;
    M[2] = neg(angle.sin);
}

/* The tangent of half the sum of two angles, from the tangents a and b of their halves:  (a + b)/(1 - ab) */
static inline num G(half_of_sum)(num a, num b) { return div(add(a, b), sub(from_int(1), mul(a, b))); }

/* v becomes v M^n, by n steps. */
static inline void G(steps)(int n, const num M[], num v[])
{
    num next[2];
    for (int k = 0; k < n; k++) {
        G(row_times)(v, M, next);
        v[0] = next[0], v[1] = next[1];
    }
}

/* The first way, simplified, formula (1-3-5):  (1 epsilon; -epsilon 1) */
static inline void G(small_step)(num epsilon, num M[])
{
    M[0] = M[3] = from_int(1);
    M[1] = epsilon;
    M[2] = neg(epsilon);
}

/* The second way:  (1 epsilon; -epsilon 1 - epsilon^2) */
static inline void G(second_step)(num epsilon, num M[])
{
    G(small_step)(epsilon, M);
    M[3] = sub(from_int(1), mul(epsilon, epsilon));
}
#include "chapters/judge/claims_off.h"
