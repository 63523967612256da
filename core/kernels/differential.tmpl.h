/* differential.tmpl.h -- curvature and torsion (曲率, 挠率), from derivatives d1, d2, d3 at a point.
 *
 * Vectors are arrays of dim numbers, 1 <= dim <= MAX_DIM.  Curvature is UNDEFINED where d1 = 0,
 * torsion where d1 x d2 = 0.
 * Source: wang-ch3, property 3.2.4; farin-2002, ch. 10 and 12. */
#include "core/number/limits.h"

#include "core/number/generic_on.h"

/* a . b */
KERNEL num G(dot)(int dim, const num a[], const num b[])
{
    num sum = mul(a[0], b[0]);
    for (int c = 1; c < dim; c++)
        sum = add(sum, mul(a[c], b[c]));
    return sum;
}

/* |a|^2 */
KERNEL num G(norm_squared)(int dim, const num a[]) { return G(dot)(dim, a, a); }

/* a_0 b_1 - a_1 b_0, the determinant of two vectors of the plane. */
KERNEL num G(cross2)(const num a[], const num b[]) { return sub(mul(a[0], b[1]), mul(a[1], b[0])); }

/* out = a x b in space. */
KERNEL void G(cross3)(const num a[restrict], const num b[restrict], num out[restrict])
{
    for (int c = 0; c < 3; c++) {
        int i = (c + 1) % 3, j = (c + 2) % 3;
        out[c] = sub(mul(a[i], b[j]), mul(a[j], b[i]));
    }
}

/* (a, b, c) = a . (b x c), the mixed product of three vectors of space. */
KERNEL num G(det3)(const num a[], const num b[], const num c[])
{
    num n[3];
    G(cross3)(b, c, n);
    return G(dot)(3, a, n);
}

/* |a|^2 |b|^2 - (a.b)^2, Gram's determinant: the squared area of the parallelogram, in any dimension.
 * As Lagrange's sum of squares, sum_{i<j} (a_i b_j - a_j b_i)^2, which rounding cannot make negative. */
KERNEL num G(gram)(int dim, const num a[], const num b[])
{
    num sum = from_int(0);
    for (int j = 1; j < dim; j++)
        for (int i = 0; i < j; i++) {
            num minor = sub(mul(a[i], b[j]), mul(a[j], b[i]));
            sum = add(sum, mul(minor, minor));
        }
    return sum;
}

/* k^2 = (|d1|^2 |d2|^2 - (d1.d2)^2) / |d1|^6, dim >= 2. */
KERNEL num G(curvature_squared)(int dim, const num d1[], const num d2[])
{
    num g = G(norm_squared)(dim, d1);
    return div(G(gram)(dim, d1, d2), mul(g, mul(g, g)));
}

/* k >= 0, dim >= 2.  UNABLE where k^2 has no root. */
KERNEL num G(curvature)(int dim, const num d1[], const num d2[]) { return root(2, G(curvature_squared)(dim, d1, d2)); }

/* The curvature of a plane curve with its sign, cross2(d1, d2) / |d1|^3: positive in a left turn.
 * UNABLE where |d1|^2 has no root. */
KERNEL num G(signed_curvature)(const num d1[], const num d2[])
{
    num g = G(norm_squared)(2, d1);
    return div(G(cross2)(d1, d2), mul(g, root(2, g)));
}

/* tau = (d1 x d2) . d3 / |d1 x d2|^2, in space. */
KERNEL num G(torsion)(const num d1[], const num d2[], const num d3[])
{
    num n[3];
    G(cross3)(d1, d2, n);
    return div(G(dot)(3, n, d3), G(norm_squared)(3, n));
}

/* The squared curvature of the rational Bézier curve (R, w) at t, 2 <= dim < MAX_DIM. */
KERNEL num G(rational_curvature_squared)(int n, int dim, const num R[], const num w[], num t)
{
    num D[3 * MAX_DIM];
    G(rational_derivatives)(n, dim, R, w, t, 2, D);
    return G(curvature_squared)(dim, D + dim, D + 2 * dim);
}

/* The torsion of the rational Bézier curve (R, w) of space at t. */
KERNEL num G(rational_torsion)(int n, const num R[], const num w[], num t)
{
    num D[4 * 3];
    G(rational_derivatives)(n, 3, R, w, t, 3, D);
    return G(torsion)(D + 3, D + 6, D + 9);
}
#include "core/number/generic_off.h"
