/*
# A curve as a function of what is fitted (曲线对权与控制顶点的导数)

On a span a NURBS curve is $C=\sum_{m=0}^pR_mP_m$ with the rational basis $R_m=w_mN_m/\sum_kw_kN_k$.  In the points it is
linear, so that $\partial C/\partial P_m=R_m$ times the unit vectors.  Weights must stay positive; they are fitted as logarithms,
$w_m=e^{\lambda_m}$, and $\partial/\partial\lambda_m=w_m\,\partial/\partial w_m$: no logarithm is ever computed.
*/
#include "chapters/fitting/definition.h"

#include "chapters/judge/claims_on.h"

enum { rows = 3 };

/*
## The rational basis
*/

/* What the derivatives are compared on: a segment, its weights and points of one coordinate, for every formula is taken coordinate by
 * coordinate; and w_m N_m, w, w C as power series at t. */
struct G(segment) {
    int p;
    num u[2 * MOST_POINTS], w[MOST_POINTS], z[MOST_POINTS], P[MOST_POINTS], t; /* z: the weights for the kernel */
    num own[MOST_POINTS * rows], weight[rows], above[rows];
};

static void G(free_segment)(trial *T, int clamped, struct G(segment) * S)
{
    int p = S->p = T->degree, place[2 * MOST_POINTS];
    num N[MOST_POINTS * rows];
    G(segment_knots)(T, p, clamped, S->u, place);
    S->t = G(in_segment)(T, p, S->u);
    G(basis_series)(p, S->u, place, S->t, rows, N);
    for (int r = 0; r < rows; r++)
        S->weight[r] = S->above[r] = from_int(0);
    for (int m = 0; m <= p; m++) {
        S->w[m] = positive(T, "w", m);
        S->P[m] = unknown(T, "y", m);
        for (int r = 0; r < rows; r++) {
            num own = S->own[m * rows + r] = mul(S->w[m], N[m * rows + r]);
            S->weight[r] = add(S->weight[r], own);
            S->above[r] = add(S->above[r], mul(own, S->P[m]));
        }
    }
    for (int m = 0; m <= p; m++)
        S->z[m] = S->w[fault(T, m, p - m)];
}

/*
At each $t$ the curve is an average of its points, and $R_m$ is the share of $P_m$.  To check the kernel the numerator and the denominator are written as
power series at $t$, by a recursion that shares nothing with it.

:::{claim} rational_basis_is_the_weighted_share
:title: The rational basis and its derivatives by the parameter
:zh: 有理基及其导数
:given: a segment of degree $p$, clamped or with simple knots; in the field these are variables for $p=1$, and $0,1,3,7,\dots$ for $p>1$; weights; any $t$
:then: `nurbs_basis` gives $R_m=w_mN_m/w$, $w=\sum_kw_kN_k$, and its first two derivatives by $t$
:method: The kernel against the quotient of power series in the parameter, whose numerator and denominator come from the recursion of
  de Boor and Cox by its letter.
:degrees: 1..2 sampled 6
:scope: clamped or simple knots, numbers in the ratio 0, 1, 3, 7 for n > 1
:over: y#: points; x#: knots
:defines: nurbs_basis
:control: the weights taken backwards
:::
*/
CLAIM(rational_basis_is_the_weighted_share)
{
    struct G(segment) S;
    num R[rows * MOST_POINTS], q[rows];
    for (int clamped = 0; clamped < 2; clamped++) {
        G(free_segment)(T, clamped, &S);
        G(nurbs_basis)(G(nurbs_on_span)(S.p, 0, S.u, S.p, NULL, S.z), S.t, rows - 1, R);
        for (int m = 0; m <= S.p; m++) {
            G(series_quotient)(rows, S.own + m * rows, S.weight, q);
            for (int r = 0; r < rows; r++)
                same(T, R[r * (S.p + 1) + m], r < 2 ? q[r] : mul(from_int(2), q[r]));
        }
    }
}

/*
## Derivatives by the weights

Raise one weight a little: the curve moves towards the point of that weight, by an amount that is proportional to its share and to the distance.  Everything
a fit knows about weights is in this one formula.

:::{claim} derivative_by_a_weight_points_to_its_point
:title: The derivative by the logarithm of a weight points from the curve to the point of that weight
:zh: 对权的导数指向相应控制顶点
:given: a segment of degree $p$, clamped or with simple knots; in the field these are variables for $p=1$, and $0,1,3,7,\dots$ for $p>1$; weights, points, any $t$
:then: $\partial C/\partial\lambda_m=R_m(P_m-C)$; `nurbs_by_weights` gives it with its first two derivatives by $t$
:method: In the field $w_m\,\partial/\partial w_m$ of the quotient $\sum w_kN_kP_k/\sum w_kN_k$, its coefficients in a power series at $t$ being
  differentiated as rational functions; in the other number types the quotient rule for the series.
:degrees: 1..2 sampled 6
:scope: clamped or simple knots, numbers in the ratio 0, 1, 3, 7 for n > 1
:over: y#: points; x#: knots
:defines: nurbs_by_weights
:control: the weights taken backwards, and the direction from the point to the curve
:::
*/
/* Two derivations of one series: the coefficients of dC/dlambda_m at t. */
static void G(series_by_weight)(const struct G(segment) * S, int m, num out[])
{
#if FIELD
    num q[rows];
    G(series_quotient)(rows, S->above, S->weight, q);
    for (int r = 0; r < rows; r++)
        out[r] = mul(S->w[m], derivative_f(q[r], S->w[m]));
#else
    num one[rows], two[rows], square[rows];
    G(series_product)(rows, S->own + m * rows, S->weight, one);
    G(series_product)(rows, S->own + m * rows, S->above, two);
    for (int r = 0; r < rows; r++)
        one[r] = sub(mul(S->P[m], one[r]), two[r]);
    G(series_product)(rows, S->weight, S->weight, square);
    G(series_quotient)(rows, one, square, out);
#endif
}

CLAIM(derivative_by_a_weight_points_to_its_point)
{
    struct G(segment) S;
    num out[rows * MOST_POINTS], q[rows];
    for (int clamped = 0; clamped < 2; clamped++) {
        G(free_segment)(T, clamped, &S);
        num C = div(S.above[0], S.weight[0]);
        G(nurbs_by_weights)(G(nurbs_on_span)(S.p, 1, S.u, S.p, S.P, S.z), S.t, rows - 1, out);
        for (int m = 0; m <= S.p; m++) {
            G(series_by_weight)(&S, m, q);
            about(T, "the direction");
            same(T, q[0], mul(div(S.own[m * rows], S.weight[0]), fault(T, sub(S.P[m], C), sub(C, S.P[m]))));
            about(T, "the kernel");
            for (int r = 0; r < rows; r++)
                same(T, out[r * (S.p + 1) + m], r < 2 ? q[r] : mul(from_int(2), q[r]));
        }
    }
}

/*
The basis itself changes with the weights as probabilities do that are proportional to weights: the matrix of its derivatives is a covariance matrix.
That its rows have the sum 0 says that a common factor of the weights changes nothing.

:::{claim} mixed_derivatives_are_a_covariance
:title: The derivatives of the basis by the weights, which are the mixed derivatives by weights and points
:zh: 有理基对权的导数(混合导数)
:given: a segment of degree $p$, clamped or with simple knots; in the field these are variables for $p=1$, and $0,1,3,7,\dots$ for $p>1$; weights, any $t$
:then: `nurbs_basis_by_weights` gives $\partial R_m/\partial\lambda_k=R_m(\delta_{mk}-R_k)$, the covariance matrix of one draw among the $m$ with the
  probabilities $R_m$: symmetric, with row sums 0
:method: In the field the quotient is differentiated; in the other number types by the quotient rule.
:degrees: 1..3 sampled 8
:scope: clamped or simple knots, numbers in the ratio 0, 1, 3, 7 for n > 1
:over: y#: points; x#: knots
:defines: nurbs_basis_by_weights
:control: the weights taken backwards, the mirrored entry with the other sign, the row sum 1
:::
*/
CLAIM(mixed_derivatives_are_a_covariance)
{
    struct G(segment) S;
    num out[MOST_POINTS * MOST_POINTS];
    for (int clamped = 0; clamped < 2; clamped++) {
        G(free_segment)(T, clamped, &S);
        int p = S.p;
        G(nurbs_basis_by_weights)(G(nurbs_on_span)(p, 0, S.u, p, NULL, S.z), S.t, out);
        for (int m = 0; m <= p; m++) {
            num row = from_int(fault(T, 0, 1));
            for (int k = 0; k <= p; k++) {
#if FIELD
                num value = mul(S.w[k], derivative_f(div(S.own[m * rows], S.weight[0]), S.w[k]));
#else
                num above = m == k ? mul(S.own[m * rows], S.weight[0]) : from_int(0);
                above = sub(above, mul(S.own[m * rows], S.own[k * rows]));
                num value = div(above, mul(S.weight[0], S.weight[0]));
#endif
                about(T, "the derivative");
                same(T, out[m * (p + 1) + k], value);
                num mirrored = out[k * (p + 1) + m];
                about(T, "symmetry");
                if (k > m)
                    same(T, out[m * (p + 1) + k], fault(T, mirrored, neg(mirrored)));
                row = add(row, value);
            }
            about(T, "the row sum");
            vanishes(T, row);
        }
    }
}

/*
Newton's method needs second derivatives as well.  They follow from the formula for the first, which contains the curve itself.

:::{claim} second_derivatives_by_two_weights
:title: The second derivatives by two weights
:zh: 对两个权的二阶导数
:given: a segment of degree $p$, clamped or with simple knots; in the field these are variables for $p=1$, and $0,1,3,7,\dots$ for $p>1$; weights, points, any $t$
:then: `nurbs_by_two_weights` gives
  $\frac{\partial^2C}{\partial\lambda_m\partial\lambda_k}=\delta_{mk}R_m(P_m-C)-R_mR_k\bigl((P_m-C)+(P_k-C)\bigr)$
:method: In the field the quotient is differentiated twice; in the other number types the quotient rule is taken twice,
  $\frac{A_{mk}}w-\frac{A_mw_k+A_kw_m+Aw_{mk}}{w^2}+\frac{2Aw_mw_k}{w^3}$.
:degrees: 1..2 sampled 8
:scope: clamped or simple knots, numbers in the ratio 0, 1, 3, 7 for n > 1
:over: y#: points; x#: knots
:defines: nurbs_by_two_weights
:control: the weights taken backwards
:::
*/
CLAIM(second_derivatives_by_two_weights)
{
    struct G(segment) S;
    num out[MOST_POINTS * MOST_POINTS];
    for (int clamped = 0; clamped < 2; clamped++) {
        G(free_segment)(T, clamped, &S);
        int p = S.p;
        num A = S.above[0], w = S.weight[0];
        G(nurbs_by_two_weights)(G(nurbs_on_span)(p, 1, S.u, p, S.P, S.z), S.t, out);
        for (int m = 0; m <= p; m++)
            for (int k = 0; k <= p; k++) {
#if FIELD
                num first = mul(S.w[m], derivative_f(div(A, w), S.w[m]));
                same(T, out[m * (p + 1) + k], mul(S.w[k], derivative_f(first, S.w[k])));
#else
                num wm = S.own[m * rows], wk = S.own[k * rows], wmk = m == k ? wm : from_int(0);
                num Am = mul(wm, S.P[m]), Ak = mul(wk, S.P[k]), Amk = mul(wmk, S.P[m]);
                num second = add(add(mul(Am, wk), mul(Ak, wm)), mul(A, wmk));
                num third = mul(mul(from_int(2), A), mul(wm, wk)), ww = mul(w, w);
                num value = add(sub(div(Amk, w), div(second, ww)), div(third, mul(ww, w)));
                same(T, out[m * (p + 1) + k], value);
#endif
            }
    }
}
#include "chapters/judge/claims_off.h"
