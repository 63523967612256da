/* cubic-figures.h -- a cubic by the lengths of its tangents, for the drawings. */
#include "chapters/foundations/figures.h"

/* D, C, B, A of the cubic of the triangle (0,0), M, (1,0) with M = (1/2, height) and the lengths alpha, beta. */
static inline void cubic_of_triangle(num_q height, num_q alpha, num_q beta, num_q c[])
{
    num_q half = r(1, 2), two = q(2), V[4];
    V[0] = mul_q(mul_q(two, alpha), half);
    V[1] = mul_q(mul_q(two, alpha), height);
    V[2] = mul_q(mul_q(two, beta), half);
    V[3] = neg_q(mul_q(mul_q(two, beta), height));
    for (int j = 0; j < 2; j++) {
        num_q edge = q(j == 0);
        c[j] = q(0);
        c[2 + j] = V[j];
        c[4 + j] = sub_q(mul_q(q(3), edge), add_q(add_q(V[j], V[j]), V[2 + j]));
        c[6 + j] = sub_q(add_q(V[j], V[2 + j]), add_q(edge, edge));
    }
}
