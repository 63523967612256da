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

/* An angle by the direction (p, q) of its half, p and q not both 0: the tangent of the half is q/p, and p = 0 is the angle pi. */
struct G(half) {
    num p, q;
};
static inline struct G(half) G(free_half)(trial *T, const char *name)
{
    return (struct G(half)){unknown(T, name, 0), unknown(T, name, 1)};
}

/* Its cosine and sine:  (p^2 - q^2)/(p^2 + q^2),  2 p q/(p^2 + q^2) */
static inline struct G(turn) G(turn_of)(struct G(half) h)
{
    num pp = mul(h.p, h.p), qq = mul(h.q, h.q), whole_square = add(pp, qq), pq = mul(h.p, h.q);
    return (struct G(turn)){div(sub(pp, qq), whole_square), div(add(pq, pq), whole_square)};
}

/* The half of the sum of two angles:  (p p' - q q', p q' + q p'), of the tangent (q/p + q'/p')/(1 - (q/p)(q'/p')) */
static inline struct G(half) G(sum_of)(struct G(half) g, struct G(half) h)
{
    return (struct G(half)){sub(mul(g.p, h.p), mul(g.q, h.q)), add(mul(g.p, h.q), mul(g.q, h.p))};
}

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
