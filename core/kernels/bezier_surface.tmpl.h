/* bezier_surface.tmpl.h -- tensor product Bézier surfaces (张量积 Bézier 曲面)
 *
 *     P(u, w) = sum_{i=0}^n sum_{j=0}^m B_i^n(u) B_j^m(w) P_ij.
 *
 * 0 <= n, m <= MAX_DEGREE, 1 <= dim <= MAX_DIM, any u and w.  The net (控制网格) is stored row by row: coordinate c of P_ij
 * is P[(i*(m+1) + j)*dim + c], so row i is the polygon of a curve in w.  Results do not overlap arguments.
 * Stands on bezier.tmpl.h and differential.tmpl.h.
 * Source: farin-2002, ch. 14 and 15. */
#include "core/number/generic_on.h"

/* The net with the parameters exchanged: Q_ji = P_ij, m+1 rows of n+1 points, so that Q(w, u) = P(u, w). */
KERNEL void G(bezier_surface_transpose)(struct G(net) net, num Q[restrict])
{
    int n = net.n, m = net.m, dim = net.dim;
    const num *P = net.points;
    for (int i = 0; i <= n; i++)
        for (int j = 0; j <= m; j++)
            for (int c = 0; c < dim; c++)
                Q[(j * (n + 1) + i) * dim + c] = P[(i * (m + 1) + j) * dim + c];
}

/* The m+1 points b_j = sum_i B_i^n(u) P_ij of the parameter line (等参线) w -> P(u, w), a curve of degree m. */
KERNEL void G(bezier_surface_line)(struct G(net) net, num u, num b[restrict])
{
    int n = net.n, m = net.m, dim = net.dim;
    const num *P = net.points;
    num column[(MAX_DEGREE + 1) * MAX_DIM];
    for (int j = 0; j <= m; j++) {
        for (int i = 0; i <= n; i++)
            for (int c = 0; c < dim; c++)
                column[i * dim + c] = P[(i * (m + 1) + j) * dim + c];
        G(bezier_casteljau)(n, dim, column, u, b + j * dim);
    }
}

/* out = P(u, w). */
KERNEL void G(bezier_surface_point)(struct G(net) net, num u, num w, num out[restrict])
{
    num line[(MAX_DEGREE + 1) * MAX_DIM];
    G(bezier_surface_line)(net, u, line);
    G(bezier_casteljau)(net.m, net.dim, line, w, out);
}

/* All partial derivatives (偏导矢) of orders k = 0, ..., r in u and l = 0, ..., s in w at (u, w), r <= MAX_DEGREE:
 * out[(k*(s+1) + l)*dim + c]; zero for k > n and for l > m. */
KERNEL void G(bezier_surface_derivatives)(struct G(net) net, num u, num w, int r, int s, num out[restrict])
{
    int n = net.n, m = net.m, dim = net.dim;
    const num *P = net.points;
    num edge[(MAX_DEGREE + 1) * MAX_DIM], column[(MAX_DEGREE + 1) * MAX_DIM], D[(MAX_DEGREE + 1) * MAX_DIM];
    for (int l = 0; l <= s; l++) {
        for (int i = 0; i <= n; i++) { /* the derivative of order l of row i at w */
            for (int c = 0; c < dim; c++)
                column[i * dim + c] = from_int(0);
            if (l <= m) {
                G(bezier_differences)(m, dim, P + i * (m + 1) * dim, l, edge);
                G(bezier_casteljau)(m - l, dim, edge, w, column + i * dim);
            }
        }
        G(bezier_derivatives)(n, dim, column, u, r, D);
        for (int k = 0; k <= r; k++)
            for (int c = 0; c < dim; c++)
                out[(k * (s + 1) + l) * dim + c] = D[k * dim + c];
    }
}

/* out = P_u x P_w at (u, w), a normal of a surface in space (法矢), not of length 1: the net has dim = 3.  It is 0 where
 * P_u and P_w are parallel, although there may be a tangent plane. */
KERNEL void G(bezier_surface_normal)(struct G(net) net, num u, num w, num out[restrict])
{
    num D[4 * 3];
    G(bezier_surface_derivatives)(net, u, w, 1, 1, D);
    G(cross3)(D + 2 * 3, D + 3, out);
}

/* The net of the piece over [u0, u1] x [w0, w1], of the same degrees, over the unit square.  Any ends, in any order. */
KERNEL void G(bezier_surface_part)(struct G(net) net, num u0, num u1, num w0, num w1, num out[restrict])
{
    int n = net.n, m = net.m, dim = net.dim;
    const num *P = net.points;
    num column[(MAX_DEGREE + 1) * MAX_DIM], piece[(MAX_DEGREE + 1) * MAX_DIM];
    for (int i = 0; i <= n; i++)
        G(bezier_on_interval)(m, dim, P + i * (m + 1) * dim, w0, w1, out + i * (m + 1) * dim);
    for (int j = 0; j <= m; j++) {
        for (int i = 0; i <= n; i++)
            for (int c = 0; c < dim; c++)
                column[i * dim + c] = out[(i * (m + 1) + j) * dim + c];
        G(bezier_on_interval)(n, dim, column, u0, u1, piece);
        for (int i = 0; i <= n; i++)
            for (int c = 0; c < dim; c++)
                out[(i * (m + 1) + j) * dim + c] = piece[i * dim + c];
    }
}
#include "core/number/generic_off.h"
