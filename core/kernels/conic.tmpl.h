/* conic.tmpl.h -- conics (圆锥曲线) of the plane, implicit and as rational quadratics.
 *
 *     S(x, y) = A x^2 + 2B xy + C y^2 + 2D x + 2E y + F     is S[6] = (A, B, C, D, E, F),
 *     l(x, y) = a x + b y + c                               is l[3] = (a, b, c);
 *
 * both count only up to a factor as curves, but the functions below return these very polynomials.
 * A rational quadratic has points R[6] = (x_0, y_0, x_1, y_1, x_2, y_2) and weights w[3].
 * Results do not overlap arguments.
 * Source: wang-ch3, 3.1 and 3.5. */
#include "core/number/generic_on.h"

/* The line through p and q: l(X) = det(p, q, X), positive to the left of the way from p to q. */
KERNEL void G(line_through)(const num p[restrict], const num q[restrict], num l[restrict])
{
    l[0] = sub(p[1], q[1]);
    l[1] = sub(q[0], p[0]);
    l[2] = sub(mul(p[0], q[1]), mul(p[1], q[0]));
}

/* S = l1 l2, the conic that consists of two lines; l1 and l2 may be the same. */
KERNEL void G(line_pair)(const num l1[], const num l2[], num S[])
{
    num half = from_ratio(1, 2);
    S[0] = mul(l1[0], l2[0]);
    S[1] = mul(half, add(mul(l1[0], l2[1]), mul(l1[1], l2[0])));
    S[2] = mul(l1[1], l2[1]);
    S[3] = mul(half, add(mul(l1[0], l2[2]), mul(l1[2], l2[0])));
    S[4] = mul(half, add(mul(l1[1], l2[2]), mul(l1[2], l2[1])));
    S[5] = mul(l1[2], l2[2]);
}

/* S = (1-lambda) S1 + lambda S2, the pencil of conics through the common points (formula 3.1.2). */
KERNEL void G(conic_pencil)(num lambda, const num S1[restrict], const num S2[restrict], num S[restrict])
{
    num mu = sub(from_int(1), lambda);
    for (int i = 0; i < 6; i++)
        S[i] = add(mul(mu, S1[i]), mul(lambda, S2[i]));
}

/* Liming's pencil S = (1-lambda) l1 l2 + lambda l3^2: conics that touch l1 and l2 where l3 meets them
 * (formula 3.1.3). */
KERNEL void G(conic_liming)(num lambda, const num l1[restrict], const num l2[restrict], const num l3[restrict],
                            num S[restrict])
{
    num tangents[6], chord[6];
    G(line_pair)(l1, l2, tangents);
    G(line_pair)(l3, l3, chord);
    G(conic_pencil)(lambda, tangents, chord, S);
}

/* S(x, y) */
KERNEL num G(conic_value)(const num S[], num x, num y)
{
    num two = from_int(2);
    num row_x = add(add(mul(S[0], x), mul(two, mul(S[1], y))), mul(two, S[3]));
    num row_y = add(mul(S[2], y), mul(two, S[4]));
    return add(add(mul(row_x, x), mul(row_y, y)), S[5]);
}

/* g = (S_x, S_y) = 2 (A x + B y + D, B x + C y + E). */
KERNEL void G(conic_gradient)(const num S[restrict], num x, num y, num g[restrict])
{
    num two = from_int(2);
    g[0] = mul(two, add(add(mul(S[0], x), mul(S[1], y)), S[3]));
    g[1] = mul(two, add(add(mul(S[1], x), mul(S[2], y)), S[4]));
}

/* AC - B^2: positive for ellipses, zero for parabolas, negative for hyperbolas. */
KERNEL num G(conic_delta)(const num S[]) { return sub(mul(S[0], S[2]), mul(S[1], S[1])); }

/* det [A B D; B C E; D E F]: zero when the conic is degenerate. */
KERNEL num G(conic_determinant)(const num S[])
{
    num a = sub(mul(S[2], S[5]), mul(S[4], S[4]));
    num b = sub(mul(S[1], S[5]), mul(S[4], S[3]));
    num d = sub(mul(S[1], S[4]), mul(S[2], S[3]));
    return add(sub(mul(S[0], a), mul(S[1], b)), mul(S[3], d));
}

/* The implicit form of the rational quadratic (R, w).  In barycentric coordinates of the triangle
 *     tau_0 : tau_1 : tau_2 = w_0 (1-t)^2 : 2 w_1 t (1-t) : w_2 t^2,
 * hence w_0 w_2 tau_1^2 = 4 w_1^2 tau_0 tau_2 on the curve.  With the lines l_0 = R_1 R_2,
 * l_1 = R_2 R_0, l_2 = R_0 R_1, each tau_i times twice the area of the triangle, it is
 *     S = w_0 w_2 l_1^2 / 4 - w_1^2 l_0 l_2,
 * a conic of Liming's pencil; in the frame of formula 3.5.4 these are the coefficients printed there.
 * When the triangle is flat, S is a multiple of the square of its line, or 0. */
KERNEL void G(conic_of_bezier)(const num R[restrict], const num w[restrict], num S[restrict])
{
    num l0[3], l1[3], l2[3], chord[6], tangents[6];
    G(line_through)(R + 2, R + 4, l0);
    G(line_through)(R + 4, R, l1);
    G(line_through)(R, R + 2, l2);
    G(line_pair)(l1, l1, chord);
    G(line_pair)(l0, l2, tangents);
    num outer = mul(from_ratio(1, 4), mul(w[0], w[2])), inner = mul(w[1], w[1]);
    for (int i = 0; i < 6; i++)
        S[i] = sub(mul(outer, chord[i]), mul(inner, tangents[i]));
}

/* omega = w_1 / sqrt(w_0 w_2), for w_0, w_2 > 0 the middle weight of the standard form (formula 3.5.2); for w_0, w_2 < 0 that is
 * -omega.  UNDEFINED when w_0 w_2 = 0; UNABLE when it has no root. */
KERNEL num G(conic_standard_weight)(const num w[]) { return div(w[1], root(2, mul(w[0], w[2]))); }

/* The shoulder point (肩点) for w_0, w_2 > 0, parameter 1/2 of the standard form, on the median through R_1 (corollary 3.5.1):
 *     out = (R_0 + 2 omega R_1 + R_2) / (2 (1 + omega)),   omega != -1. */
KERNEL void G(conic_shoulder_point)(const num R[restrict], const num w[restrict], num out[restrict])
{
    num omega = G(conic_standard_weight)(w), two = from_int(2);
    num total = mul(two, add(from_int(1), omega));
    for (int c = 0; c < 2; c++)
        out[c] = div(add(add(R[c], mul(two, mul(omega, R[2 + c]))), R[4 + c]), total);
}

/* cos^2 theta = w_1^2 / (w_0 w_2) of the circular arc with chord 2l and apex at height h over the
 * middle of the chord: l^2 / (l^2 + h^2); 2 theta is the angle of the arc (theorem 3.5.2). */
KERNEL num G(circular_arc_invariant)(num l, num h)
{
    num ll = mul(l, l);
    return div(ll, add(ll, mul(h, h)));
}

/* Its weights in standard form, w = (1, cos theta, 1), l > 0.  UNABLE where l^2 + h^2 has no root. */
KERNEL void G(circular_arc_weights)(num l, num h, num w[])
{
    w[0] = w[2] = from_int(1);
    w[1] = div(l, root(2, add(mul(l, l), mul(h, h))));
}

/* The circle that touches R_0 R_1 in R_0 and R_2 R_1 in R_2, for |R_0 R_1| = |R_2 R_1|: its centre,
 * and as value its squared radius.  With M the middle of the chord, l = |R_0 M| and h = |M R_1|,
 *     centre = M - l^2/h^2 (R_1 - M),   radius^2 = l^2 + l^4/h^2 = (l / sin theta)^2.
 * UNDEFINED for h = 0. */
KERNEL num G(circular_arc_circle)(const num R[restrict], num centre[restrict])
{
    num half = from_ratio(1, 2), ll = from_int(0), hh = from_int(0), up[2];
    for (int c = 0; c < 2; c++) {
        num chord = mul(half, sub(R[4 + c], R[c]));
        centre[c] = mul(half, add(R[c], R[4 + c]));
        up[c] = sub(R[2 + c], centre[c]);
        ll = add(ll, mul(chord, chord));
        hh = add(hh, mul(up[c], up[c]));
    }
    num ratio = div(ll, hh);
    for (int c = 0; c < 2; c++)
        centre[c] = sub(centre[c], mul(ratio, up[c]));
    return add(ll, mul(ll, ratio));
}
#include "core/number/generic_off.h"
