/* circle.h -- the worked example, in rationals: a quarter of a circle about the origin with eight pairs of points.
 *
 * The conic over (r,0), (r,r), (0,r) with weights 1, 1, 2 is (x, y) = r (1-t^2, 2t)/(1+t^2), hence t = y/(r+x) on it.  The pairs
 * lie at rational points of the circle, nearer to the centre and farther from it by a share of the radius. */
#include "exact/kernels_q.h"

enum { PAIRS = 8, UNKNOWNS = 3 }; /* lambda_1, x_1, y_1 */

struct circle_example {
    num_q R[6], w[3], place[2 * PAIRS], share; /* points and weights; the points of the circle        */
    num_q Q[4 * PAIRS];                        /* points 2k and 2k+1 are a pair                       */
    num_q t[2 * PAIRS];                        /* their feet                                          */
};

/* The pairs and their feet from R, w, place and share. */
static void put_pairs(struct circle_example *E)
{
    num_q one = from_int_q(1), radius = E->R[0];
    for (int i = 0; i < 2 * PAIRS; i++) {
        const num_q *at = E->place + i / 2 * 2;
        for (int c = 0; c < 2; c++)
            E->Q[2 * i + c] = mul_q(at[c], i % 2 == 0 ? sub_q(one, E->share) : add_q(one, E->share));
        E->t[i] = div_q(at[1], add_q(radius, at[0]));
    }
}

/* What the curve is at a parameter: C, C', C'' and the derivatives by lambda_1, x_1, y_1, and those of C'. */
struct circle_view {
    num_q C[2], C1[2], C2[2], by[UNKNOWNS][2], by1[UNKNOWNS][2], twice[2], mixed; /* twice: by lambda_1 twice;
                                                                          mixed: by lambda_1 and a coordinate */
};

static struct circle_view view_of_circle(const struct circle_example *E, num_q t)
{
    struct circle_view v;
    num_q zero = from_int_q(0), one = from_int_q(1), u[] = {zero, zero, zero, one, one, one};
    num_q D[6], L[12], LL[18], B[6], BL[9];
    rational_derivatives_q(2, 2, E->R, E->w, t, 2, D);
    nurbs_basis_q(nurbs_on_span_q(2, 0, u, 2, NULL, E->w), t, 1, B);
    nurbs_basis_by_weights_q(nurbs_on_span_q(2, 0, u, 2, NULL, E->w), t, BL);
    nurbs_by_weights_q(nurbs_on_span_q(2, 2, u, 2, E->R, E->w), t, 1, L);
    nurbs_by_two_weights_q(nurbs_on_span_q(2, 2, u, 2, E->R, E->w), t, LL);
    for (int c = 0; c < 2; c++) {
        v.C[c] = D[c], v.C1[c] = D[2 + c], v.C2[c] = D[4 + c];
        v.by[0][c] = L[2 + c], v.by1[0][c] = L[6 + 2 + c], v.twice[c] = LL[8 + c];
        for (int e = 0; e < 2; e++) {
            v.by[1 + e][c] = c == e ? B[1] : zero;
            v.by1[1 + e][c] = c == e ? B[3 + 1] : zero;
        }
    }
    v.mixed = BL[4];
    return v;
}

/* Gradient and Hessian of F = 1/2 sum |C - Q|^2 with the feet eliminated, and the matrix J^T J of the derivatives across the
 * curve; UNKNOWNS and UNKNOWNS^2 numbers.  The t are the feet. */
static void derivatives_of_circle(const struct circle_example *E, num_q gradient[], num_q hessian[], num_q gauss[])
{
    for (int m = 0; m < UNKNOWNS * UNKNOWNS; m++)
        hessian[m] = gauss[m] = gradient[m % UNKNOWNS] = from_int_q(0);
    for (int i = 0; i < 2 * PAIRS; i++) {
        struct circle_view v = view_of_circle(E, E->t[i]);
        num_q D[2] = {sub_q(v.C[0], E->Q[2 * i]), sub_q(v.C[1], E->Q[2 * i + 1])}, turn[UNKNOWNS];
        num_q speed = dot_q(2, v.C1, v.C1), slope = add_q(speed, dot_q(2, D, v.C2));
        for (int a = 0; a < UNKNOWNS; a++) {
            gradient[a] = add_q(gradient[a], dot_q(2, D, v.by[a]));
            turn[a] = add_q(dot_q(2, v.by[a], v.C1), dot_q(2, D, v.by1[a]));
        }
        for (int a = 0; a < UNKNOWNS; a++)
            for (int b = 0; b < UNKNOWNS; b++) {
                num_q *H = &hessian[a * UNKNOWNS + b], *G = &gauss[a * UNKNOWNS + b];
                num_q second = a == 0 && b == 0   ? dot_q(2, D, v.twice)
                               : a == 0 || b == 0 ? mul_q(v.mixed, D[a + b - 1])
                                                  : from_int_q(0);
                num_q part = add_q(dot_q(2, v.by[a], v.by[b]), second);
                *H = add_q(*H, sub_q(part, div_q(mul_q(turn[a], turn[b]), slope)));
                *G = add_q(*G, div_q(mul_q(cross2_q(v.C1, v.by[a]), cross2_q(v.C1, v.by[b])), speed));
            }
    }
}

/* Entry (a, b) of the inverse of a symmetric 3 by 3 matrix. */
static num_q inverse_entry(const num_q M[], int a, int b)
{
    int r = (b + 1) % 3, s = (b + 2) % 3, p = (a + 1) % 3, q = (a + 2) % 3;
    num_q minor = sub_q(mul_q(M[r * 3 + p], M[s * 3 + q]), mul_q(M[r * 3 + q], M[s * 3 + p]));
    return div_q(minor, determinant_q(3, M));
}
