/* cubic.h -- a cubic by its ends, and how a plane cubic turns.
 *
 * Coefficients are c = (D, C, B, A) of P = A t^3 + B t^2 + C t + D.  Generic text, for the sections on the shapes of cubics. */
#include "chapters/foundations/definition.h"

#if RATIONAL
#include "exact/record/polynomial.h"
#endif

#include "chapters/judge/claims_on.h"

enum { dim = 2, space = 3 };

/* The cubic from Q_0 to Q_1 with the derivatives V_0 and V_1 at its ends, each with dims coordinates:
 *     D = Q_0,  C = V_0,  B = 3 (Q_1 - Q_0) - 2 V_0 - V_1,  A = 2 (Q_0 - Q_1) + V_0 + V_1. */
static inline void G(cubic_of_ends)(int dims, const num Q[], const num V[], num c[])
{
    for (int j = 0; j < dims; j++) {
        num q0 = Q[j], q1 = Q[dims + j], v0 = V[j], v1 = V[dims + j], edge = sub(q1, q0);
        c[j] = q0;
        c[dims + j] = v0;
        c[2 * dims + j] = sub(mul(from_int(3), edge), add(add(v0, v0), v1));
        c[3 * dims + j] = sub(add(v0, v1), add(edge, edge));
    }
}

#if RATIONAL
/* P' x P'' of a plane cubic with the coefficients c, by the kernels. */
static inline poly turning_of(const num c[])
{
    num m[3], f[3];
    G(cubic_minors)(c, m);
    G(cubic_inflection_polynomial)(m, f);
    return poly_from_q(3, f);
}
#endif
#include "chapters/judge/claims_off.h"
