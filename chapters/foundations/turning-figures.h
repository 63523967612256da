/* turning-figures.h -- points that are turned again and again, for the drawings. */
#include "chapters/foundations/figures.h"

/* P M^n with exact steps, as pairs; M = (M_0 M_1; M_2 M_3). */
static inline void orbit(int n, const num_q M[], num_q P[])
{
    for (int k = 0; k < n; k++)
        for (int j = 0; j < 2; j++)
            P[2 * k + 2 + j] = add_q(mul_q(P[2 * k], M[j]), mul_q(P[2 * k + 1], M[2 + j]));
}

/* The rotation with the tangent a of half its angle, the first and the second way with the step e. */
static inline void generator(int way, num_q e, num_q M[])
{
    num_q one = q(1), ee = mul_q(e, e), below = add_q(one, ee);
    M[0] = M[3] = way == 0 ? div_q(sub_q(one, ee), below) : one;
    M[1] = way == 0 ? div_q(mul_q(q(2), e), below) : e;
    M[2] = neg_q(M[1]);
    if (way == 2)
        M[3] = sub_q(one, ee);
}
