/* coons.tmpl.h -- surfaces that fill a frame of curves (Coons 曲面).
 *
 * 1 <= dim <= MAX_DIM; coordinate c of datum i is data[i*dim + c], and of entry (i, j) of an m x m matrix
 * data[(i*m + j)*dim + c].  Results do not overlap arguments.
 * Stands on hermite.tmpl.h.
 * Source: slides-ch4, section 3. */
#include "core/number/limits.h"

#include "core/number/generic_on.h"

/* The point at (u, w) of the patch of m data across and m data along, by m blending functions in each direction:
 *     out = sum_i a_i A_i + sum_j B_j b_j - sum_ij a_i M_ij b_j.
 * a and b hold the values of the functions at u and at w; A_i the data at w: P(0,w), P(1,w), for m = 4 also
 * P_u(0,w), P_u(1,w); B_j those at u: P(u,0), P(u,1), P_w(u,0), P_w(u,1); M_ij what A_i and B_j have in common at a
 * corner.  With derivatives of a and of B with respect to u it is a derivative of the patch, and so for w. */
KERNEL void G(coons_patch)(int m, int dim, const num a[], const num b[], const num A[], const num B[], const num M[],
                           num out[restrict])
{
    for (int c = 0; c < dim; c++) {
        num sum = from_int(0);
        for (int i = 0; i < m; i++) {
            num rest = A[i * dim + c];
            for (int j = 0; j < m; j++)
                rest = sub(rest, mul(M[(i * m + j) * dim + c], b[j]));
            sum = add(sum, add(mul(a[i], rest), mul(B[i * dim + c], b[i])));
        }
        out[c] = sum;
    }
}

/* out = the derivative of order r in u and s in w, r and s at most 3, of the bicubic patch over the unit square
 * sum_ij q_i(u) M_ij q_j(w), where q_0, ..., q_3 are the functions of hermite_blending over [0, 1].  M is the 4 x 4
 * matrix of the corners: M_ij = P, P_w in columns 0-1, 2-3 at w = 0, 1, and P, P_u in rows 0-1, 2-3 at u = 0, 1. */
KERNEL void G(hermite_tensor)(int dim, const num M[restrict], num u, num w, int r, int s, num out[restrict])
{
    num p[16], q[16], zero = from_int(0), one = from_int(1);
    G(hermite_blending)(zero, one, u, r, p);
    G(hermite_blending)(zero, one, w, s, q);
    for (int c = 0; c < dim; c++) {
        out[c] = zero;
        for (int i = 0; i < 4; i++)
            for (int j = 0; j < 4; j++)
                out[c] = add(out[c], mul(mul(p[4 * r + i], q[4 * s + j]), M[(4 * i + j) * dim + c]));
    }
}
#include "core/number/generic_off.h"
