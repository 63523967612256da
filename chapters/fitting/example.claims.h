/*
# An exact example (一个精确的例子)

On the circle of radius 65 there are many points with integer coordinates, because 65 is the product of two primes that are sums of squares.  A quarter of
the circle about the origin is a conic with weights $1,1,2$, and the points on it have rational parameters $t=\frac y{65+x}$.  Now measure eight of them twice,
once too near to the centre and once too far from it, by the same share of the radius: sixteen points with rational feet, whose residuals cancel.
Everything that a program computes with them can be compared with fractions.
*/
#include "chapters/judge/claims_on.h"

#if RATIONAL
#include "chapters/fitting/circle.h"

/* The example from the data of the claim. */
static struct circle_example given_circle(trial *T)
{
    struct circle_example E;
    given_points(T, "R", 3, 2, E.R);
    given_points(T, "ω", 3, 1, E.w);
    given_points(T, "places", PAIRS, 2, E.place);
    E.share = given(T, "share");
    put_pairs(&E);
    return E;
}

/*
Two points of a pair have the same foot and opposite residuals: so they pull on the curve with opposite forces at one place, and the circle is in
equilibrium.  That it is a minimum and not a saddle is decided by the signs of three minors.

:::{claim} pairs_about_a_circle_have_the_circle_as_minimum
:title: The circle between the pairs is a strict local minimum, exactly
:zh: 成对点的最小二乘解恰为该圆
:kind: decision
:data: R = (65,0) (65,65) (0,65); ω = 1 1 2; places = (63,16) (60,25) (56,33) (52,39) (39,52) (33,56) (25,60) (16,63); share = 1/16
:data: factor = 1
:instead: factor = 18/17
:result: F = 4225/32
:result: Hessian = (1486336/1625,47972816/1795625,47972816/1795625) (47972816/1795625,186104/215475,83712176/116715625) (47972816/1795625,83712176/116715625,186104/215475)
:given: the quarter circle with points $R$ and weights $\omega$, at each of the places a pair of points, nearer to the centre and farther from it by
  the share; unknowns $\lambda_1$, $x_1$, $y_1$, the ends given
:then: at the circle $D_i\cdot C'=0$ and $\varphi'>0$ for all $i$, the gradient of $F$ is $0$, and its Hessian, $A-B\Delta^{-1}B^T$, is positive definite
:method: Everything in rationals: the feet, the sums of the gradient, and the three leading minors of the Hessian, which are positive.
:control: the last point is moved away from the centre by the factor that is given
:::
*/
CLAIM(pairs_about_a_circle_have_the_circle_as_minimum)
{
    struct circle_example E = given_circle(T);
    num gradient[UNKNOWNS], H[UNKNOWNS * UNKNOWNS], gauss[UNKNOWNS * UNKNOWNS], F = from_int(0);
    num factor = given(T, "factor");
    for (int c = 0; c < 2; c++)
        E.Q[4 * PAIRS - 2 + c] = mul(E.Q[4 * PAIRS - 2 + c], factor);
    for (int i = 0; i < 2 * PAIRS; i++) {
        struct circle_view v = view_of_circle(&E, E.t[i]);
        num D[2] = {sub(v.C[0], E.Q[2 * i]), sub(v.C[1], E.Q[2 * i + 1])};
        about(T, "the foot");
        vanishes(T, G(dot)(2, D, v.C1)); /* D . C' */
        /* phi' = |C'|^2 + D . C'' */
        agree(T, compare_q(add(G(dot)(2, v.C1, v.C1), G(dot)(2, D, v.C2)), from_int(0)) > 0);
        F = add(F, mul(from_ratio(1, 2), G(dot)(2, D, D)));
    }
    derivatives_of_circle(&E, gradient, H, gauss);
    found(T, "F", F);
    found_points(T, "Hessian", UNKNOWNS, UNKNOWNS, H);
    about(T, "the gradient");
    for (int a = 0; a < UNKNOWNS; a++)
        vanishes(T, gradient[a]);
    about(T, "the leading minors");
    for (int k = 1; k <= UNKNOWNS; k++) {
        num M[9];
        for (int m = 0; m < k * k; m++)
            M[m] = H[m / k * UNKNOWNS + m % k];
        agree(T, compare_q(G(determinant)(k, M), from_int(0)) > 0);
    }
}

/*
It is often done with given parameters in the place of feet, evenly spaced or by the lengths of chords, since then only a linear
system is left.  That answers another question.

:::{claim} given_parameters_find_the_same_curve
:title: Least squares at given parameters find another curve
:zh: 给定参数的最小二乘不得同一曲线
:kind: counterexample
:data: R = (65,0) (65,65) (0,65); ω = 1 1 2; places = (63,16) (60,25) (56,33) (52,39) (39,52) (33,56) (25,60) (16,63); share = 1/16
:data: t = 1/9 2/9 3/9 4/9 5/9 6/9 7/9 8/9
:instead: t = 1/8 1/5 3/11 1/3 1/2 4/7 2/3 7/9
:result: gradient = -5146773339403023908/10798334083391089 -1344638920422391068/53991670416955445 13981847292735113308/701891715420420785
:given: the quarter circle with points $R$ and weights $\omega$, at each of the places a pair of points, nearer to the centre and farther from it by
  the share, and for each of the pairs one parameter $t$ in the place of its feet, in equal steps
:then: the circle, which goes through the middle of every pair, is not stationary for $\sum_i|Q_i-C(t_i)|^2$
:method: The gradient by $\lambda_1$, $x_1$, $y_1$, exactly; that it is 0 is refuted.
:control: the parameters of the feet
:::
*/
CLAIM(given_parameters_find_the_same_curve)
{
    struct circle_example E = given_circle(T);
    num t[PAIRS], gradient[UNKNOWNS], H[UNKNOWNS * UNKNOWNS], gauss[UNKNOWNS * UNKNOWNS];
    given_points(T, "t", PAIRS, 1, t);
    for (int i = 0; i < 2 * PAIRS; i++)
        E.t[i] = t[i / 2];
    derivatives_of_circle(&E, gradient, H, gauss); /* the gradient is that of the sum at any parameters */
    found_points(T, "gradient", UNKNOWNS, 1, gradient);
    about(T, "the gradient");
    for (int a = 0; a < UNKNOWNS; a++)
        vanishes(T, gradient[a]);
}

/*
What do the points know of the weight?  The matrix $J^TJ$ answers with fractions.  When the middle point may move as well, a change of the weight can nearly be
made up for by moving the point, and the weight becomes much less certain.

:::{claim} free_point_makes_its_weight_less_known
:title: The weight is known less when its point is free
:zh: 控制顶点自由时权的不确定度增大
:kind: decision
:data: R = (65,0) (65,65) (0,65); ω = 1 1 2; places = (63,16) (60,25) (56,33) (52,39) (39,52) (33,56) (25,60) (16,63); share = 1/16
:data: times = 69
:result: variance, the point free = 594737/8028288; variance, the point given = 325/303744
:given: the quarter circle with points $R$ and weights $\omega$, at each of the places a pair of points, nearer to the centre and farther from it by
  the share, and $J^TJ$, $J$ the derivatives across the curve; $K=(J^TJ)^{-1}$
:then: $K\,J^TJ=1$; the variance of $\lambda_1$, in units of that of a residual, is $K_{11}$ when the point $P_1$ is free as well, $1/(J^TJ)_{11}$ when it is
  given, and the first is more than so many times the second as is given
:method: Rationals; on the circle $|C'|$ cancels in $J^TJ$.  The error of $\log I_1=2\lambda_1-\log2$ is twice that of $\lambda_1$.
:control: the entry $(2,2)$ of $K$ doubled
:::
*/
CLAIM(free_point_makes_its_weight_less_known)
{
    struct circle_example E = given_circle(T);
    num gradient[UNKNOWNS], H[UNKNOWNS * UNKNOWNS], A[UNKNOWNS * UNKNOWNS], K[UNKNOWNS * UNKNOWNS];
    num times = given(T, "times");
    derivatives_of_circle(&E, gradient, H, A);
    for (int m = 0; m < UNKNOWNS * UNKNOWNS; m++)
        K[m] = inverse_entry(A, m / UNKNOWNS, m % UNKNOWNS);
    K[4] = fault(T, K[4], add(K[4], K[4]));
    about(T, "the inverse");
    for (int a = 0; a < UNKNOWNS; a++)
        for (int b = 0; b < UNKNOWNS; b++) {
            num sum = from_int(0);
            for (int k = 0; k < UNKNOWNS; k++)
                sum = add(sum, mul(K[a * UNKNOWNS + k], A[k * UNKNOWNS + b]));
            same(T, sum, from_int(a == b));
        }
    num of_free = K[0], of_given = div(from_int(1), A[0]); /* K_11 and 1/(J^T J)_11 */
    found(T, "variance, the point free", of_free);
    found(T, "variance, the point given", of_given);
    about(T, "the variances");
    agree(T, compare_q(of_free, mul(times, of_given)) > 0);
}
#endif

#include "chapters/judge/claims_off.h"
