/* cubic_shape.tmpl.h -- inflections, cusp and loop of a plane cubic (平面参数三次曲线的拐点, 尖点, 二重点)
 *
 *     P(t) = A t^3 + B t^2 + C t + D,   a = A x B,   b = A x C,   c = B x C   (determinants of the plane).
 *
 * A cubic is the array D, C, B, A of four points of the plane, as in power.tmpl.h; D does not matter.
 *     P' x P'' = -2 (3 a t^2 + 3 b t + c),   delta = 3 b^2 - 4 a c.
 * For a != 0: delta > 0 two inflections, delta = 0 a cusp, delta < 0 a double point with two real parameters.
 * Source: hu-1987, 1-4; stone-derose-1989. */
#include "core/number/generic_on.h"

/* m = (a, b, c). */
KERNEL void G(cubic_minors)(const num P[restrict], num m[restrict])
{
    m[0] = G(cross2)(P + 6, P + 4);
    m[1] = G(cross2)(P + 6, P + 2);
    m[2] = G(cross2)(P + 4, P + 2);
}

/* f, the three coefficients of P' x P'' = f_0 + f_1 t + f_2 t^2, from m = (a, b, c). */
KERNEL void G(cubic_inflection_polynomial)(const num m[restrict], num f[restrict])
{
    f[0] = mul(from_int(-2), m[2]);
    f[1] = mul(from_int(-6), m[1]);
    f[2] = mul(from_int(-6), m[0]);
}

/* delta = 3 b^2 - 4 a c, from m = (a, b, c). */
KERNEL num G(cubic_delta)(const num m[])
{
    return sub(mul(from_int(3), mul(m[1], m[1])), mul(from_int(4), mul(m[0], m[2])));
}

/* g, the three coefficients of g_0 + g_1 t + g_2 t^2 = a^2 t^2 + a b t + b^2 - a c, from m = (a, b, c): for a != 0 its
 * roots are the two parameters of the double point, both at the cusp when delta = 0. */
KERNEL void G(cubic_double_point_polynomial)(const num m[restrict], num g[restrict])
{
    g[0] = sub(mul(m[1], m[1]), mul(m[0], m[2]));
    g[1] = mul(m[0], m[1]);
    g[2] = mul(m[0], m[0]);
}

/* out, the double point itself.  UNDEFINED for a = 0. */
KERNEL void G(cubic_double_point)(const num P[restrict], const num m[restrict], num out[restrict])
{
    num p = neg(div(m[1], m[0])), q = sub(mul(p, p), div(m[2], m[0])); /* s + t and s t */
    for (int j = 0; j < 2; j++) { /* P = P_0 + q-multiple of the quotient by t^2 - p t + q */
        num rest = add(mul(p, P[6 + j]), P[4 + j]);
        out[j] = sub(P[j], mul(q, rest));
    }
}
#include "core/number/generic_off.h"
