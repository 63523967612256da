/*
# The polygons converge to the curve (割角多边形的收敛)

A piece that is cut again and again has more and more points near the curve, so it is natural to ask whether the polygons
converge, and how fast.  In homogeneous coordinates the answer is that of polynomial curves: second differences shrink with
the square of the length of the interval, and they bound the distance of the polygon from its curve.  What is new is the
projection to points of space, which divides by weights; it does no harm as long as these stay away from 0.
*/
#include "chapters/judge/elementary.h"

#include "chapters/judge/claims_on.h"

/*
:::{statement} wang-ch3:rem-3.3.1-uniform
:title: The polygons of repeated cutting converge uniformly to the curve
:zh: 离散割角多边形序列一致收敛到原曲线
:printed: In the same way it can be proved that the sequence of the cut polygons of a subdivided rational Bézier curve converges uniformly to the
  curve.
:holds-by: differences_over_a_part_are_means bernstein_sum_of_powers_is_a_power polygon_and_curve_are_near_the_chord
  near_homogeneous_points_are_near cut_coefficients_are_convex weighted_points_are_cut_like_the_weights
  triangle_of_powers_consists_of_powers change_of_parameter_acts_on_one_factor
:confirmed-by: second_differences_shrink_quadratically quarter_circle_error_is_quartered
:hypothesis: crowded_cuts_do_not_converge | the length of the longest piece, in the parameter, tends to 0: as at a fixed ratio; with a new ratio in every step a piece
  may stay long for ever
:needs: linear_weights_of_both_signs_have_a_pole | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the
  weights are positive
:argued: | By theorem 3.3.1 the polygons, in homogeneous coordinates, are those of the pieces of one polynomial curve.  Let a piece have the parameter length $h$.  Its homogeneous second differences are at most $h^2M$, $M$ being the
largest of the curve itself; polygon and curve are then at most $\frac{n^2}4h^2M$ apart, at equal parameters, where $\sum B_k^n(t)\frac kn=t$ is (6) of
`change_of_parameter_acts_on_one_factor` with the differences $\frac1n,0,0,\dots$; and as
no weight falls below the least $\omega_i$, the projection to points of space multiplies this by a constant; the image of a homogeneous
edge is the edge of the polygon, run through at another speed.  At a fixed ratio $\lambda$ the longest piece after $k$ steps has the length $\max(\lambda,1-\lambda)^k$, which tends to 0.
:figure: cut_polygons_converge

Cut in the middle, the error of a quarter circle is divided by 4 in each of the steps computed (`quarter_circle_error_is_quartered`).
:::

:::{claim} second_differences_shrink_quadratically
:title: Over an interval of length h second differences shrink with the square of h
:zh: 二阶差分按区间长度平方缩小
:given: a polynomial with Bernstein coefficients $b_0,\dots,b_n$ over $[0,1]$, and those over $[u,v]$, $0<u,v<1$
:then: $\Delta^2b_i^{[u,v]}=(v-u)^2\sum_j\beta_{ij}\Delta^2b_j$ with $\beta_{ij}\ge0$, $\sum_j\beta_{ij}=1$
:method: The coefficients over $[u,v]$ are values of the polar form.  $\beta_{ij}$ is the polar form of the
  polynomial with coefficients $0,\dots,1,\dots,0$ of degree $n-2$ at $n-2-i$ arguments $u$ and $i$ arguments $v$;
  with $u=r/(1+r)$, $v=s/(1+s)$ its coefficients are nonnegative.  So
  $\max|\Delta^2b^{[u,v]}|\le(v-u)^2\max|\Delta^2b|$.
:degrees: 2..6 sampled 10
:scope: 0 < u,v < 1
:over: b#: coefficients; r s: -
:control: $v-u$ for $(v-u)^2$
:::
*/
CLAIM(second_differences_shrink_quadratically)
{
    int n = T->degree;
    num b[MAX_DEGREE + 1], d[MAX_DEGREE + 1], piece[MAX_DEGREE + 1], at[MAX_DEGREE], u = inside(T, "r"),
                                                                                     v = inside(T, "s");
    num h = sub(v, u), scale = fault(T, mul(h, h), h);
    for (int i = 0; i <= n; i++)
        b[i] = unknown(T, "b", i);
    for (int j = 0; j <= n - 2; j++)
        d[j] = add(sub(b[j], add(b[j + 1], b[j + 1])), b[j + 2]);
    G(bezier_on_interval)(n, 1, b, u, v, piece);
    for (int i = 0; i <= n - 2; i++) {
        num sum = from_int(0), total = from_int(0);
        for (int k = 0; k < n - 2; k++)
            at[k] = k < i ? v : u;
        for (int j = 0; j <= n - 2; j++) {
            num e[MAX_DEGREE + 1], beta;
            for (int k = 0; k <= n - 2; k++)
                e[k] = from_int(k == j);
            G(bezier_blossom)(n - 2, 1, e, at, &beta);
            nonnegative(T, beta);
            total = add(total, beta);
            sum = add(sum, mul(beta, d[j]));
        }
        same(T, total, from_int(1));
        /* Δ²b_i over [u, v] is (v - u)² Σ_j β_ij Δ²b_j */
        same(T, add(sub(piece[i], add(piece[i + 1], piece[i + 1])), piece[i + 2]), mul(scale, sum));
    }
}

/*
Second differences, in turn, bound the distance.  When they are all 0 the points lie evenly on the chord.  In general
summation by parts, done with a function $g$ that is straight but for one corner at $k$, gives the distance of the
point $b_k$ from the chord as a sum of second differences with coefficients of one sign.  The degree enters as a
variable, so one computation serves every $n$.

:::{claim} polygon_and_curve_are_near_the_chord
:title: A polygon is as near to its chord as its second differences are small
:zh: 控制多边形与弦之距由二阶差分界定
:given: variables $n,j,k$, and $b_0,b_1$, $b_{n-1},b_n$, $b_{j-1},b_j,b_{j+1}$ of a polygon
:let: $\Delta^2b_{j-1}=b_{j+1}-2b_j+b_{j-1}$, and so for $g$; $g_j=j(n-k)/n$ for $j\le k$ and $g_j=k(n-j)/n$ for $j\ge k$; $T_j=g_jb_{j+1}-g_{j+1}b_j$
:then: $g_j\Delta^2b_{j-1}-b_j\Delta^2g_{j-1}=T_j-T_{j-1}$, for any $g$; $T_{n-1}-T_0=\frac{n-k}nb_0+\frac knb_n$;
  $\Delta^2g_{j-1}$ is $0$ for $j\ne k$ and $-1$ for $j=k$; $\sum_{0<j<n}g_j=\frac{k(n-k)}2\le\frac{n^2}8$
:method: Each is computed from the formulas of $g$ at the neighbouring indices.  Added up over $0<j<n$ the first
  three give $b_k-\bigl(\frac{n-k}nb_0+\frac knb_n\bigr)=-\sum_{0<j<n}g_j\,\Delta^2b_{j-1}$ for
  all $0<k<n$, all $g_j\ge0$: the points of a polygon are at most $\frac{n^2}8\max|\Delta^2b|$ away from the chord
  at the parameters $k/n$, hence so are the polygon, by linear interpolation, and the curve, being $\sum
  B_k^n(t)b_k$ with $\sum B_k^n(t)\frac kn=t$.  Polygon and curve are at most $\frac{n^2}4\max|\Delta^2b|$ apart.
:degrees: all from 1
:over: b#: points; n j k g#: -
:control: $g_j=j(n-k)$ for $j\le k$
:::
*/
/* g_j by the formula for j <= k, times n in the control, or by that for j >= k. */
static num G(green)(const trial *T, num n, num k, num j, int below)
{
    num product = below ? mul(j, sub(n, k)) : mul(k, sub(n, j));
    return fault(T, div(product, n), below ? product : div(product, n));
}

CLAIM(polygon_and_curve_are_near_the_chord)
{
    num n = positive(T, "n", 0), j = positive(T, "j", 0), k = positive(T, "k", 0), b[7], g[3];
    num zero = from_int(0), one = from_int(1), two = from_int(2);
    for (int i = 0; i < 7; i++) /* b_0, b_1, b_{n-1}, b_n and then b_{j-1}, b_j, b_{j+1} */
        b[i] = unknown(T, "b", i);
    for (int i = 0; i < 3; i++) /* g_{j-1}, g_j, g_{j+1} */
        g[i] = unknown(T, "g", i);
    about(T, "summation by parts");
    num bend_b = sub(add(b[4], b[6]), mul(two, b[5])), bend_g = sub(add(g[0], g[2]), mul(two, g[1]));
    num step = sub(sub(mul(g[1], b[6]), mul(g[2], b[5])), sub(mul(g[0], b[5]), mul(g[1], b[4])));
    /* g_j Δ²b_{j-1} - b_j Δ²g_{j-1} = T_j - T_{j-1} */
    same(T, sub(mul(g[1], bend_b), mul(b[5], bend_g)), step);
    about(T, "the second differences beside the corner");
    for (int below = 0; below < 2; below++) {
        num low = G(green)(T, n, k, sub(j, one), below), high = G(green)(T, n, k, add(j, one), below);
        same(T, add(low, high), mul(two, G(green)(T, n, k, j, below)));
    }
    about(T, "the two formulas and the second difference at the corner");
    num corner = G(green)(T, n, k, k, 1), low = G(green)(T, n, k, sub(k, one), 1);
    same(T, corner, G(green)(T, n, k, k, 0));
    /* Δ²g_{k-1} = -1 */
    same(T, sub(add(low, G(green)(T, n, k, add(k, one), 0)), mul(two, corner)), neg(one));
    about(T, "the ends and the chord");
    num first = sub(mul(G(green)(T, n, k, zero, 1), b[1]), mul(G(green)(T, n, k, one, 1), b[0]));
    num last = sub(mul(G(green)(T, n, k, sub(n, one), 0), b[3]), mul(G(green)(T, n, k, n, 0), b[2]));
    /* T_{n-1} - T_0 = ((n-k) b_0 + k b_n)/n */
    same(T, sub(last, first), div(add(mul(sub(n, k), b[0]), mul(k, b[3])), n));
    about(T, "the sum of g: its first and last value, of as many as there are, on each side of the corner");
    num rest = sub(n, k), half = from_ratio(1, 2);
    num below = mul(mul(half, k), add(G(green)(T, n, k, one, 1), corner));
    num above =
        mul(mul(half, sub(rest, one)), add(G(green)(T, n, k, add(k, one), 0), G(green)(T, n, k, sub(n, one), 0)));
    /* Σ g_j = k (n-k)/2 */
    same(T, add(below, above), mul(half, mul(k, rest)));
    about(T, "the largest sum");
    num offset = sub(n, add(k, k));
    /* n²/8 - k (n-k)/2 = (n - 2k)²/8 */
    same(T, sub(div(mul(n, n), from_int(8)), add(below, above)), div(mul(offset, offset), from_int(8)));
}

/*
So far the distances are those of homogeneous points, the weight being one of the coordinates.  The last step goes
down to the points of space.

:::{claim} near_homogeneous_points_are_near
:title: Homogeneous points that are near, with weights kept from 0, have near images
:zh: 齐次点相近则投影点相近
:given: homogeneous points $(P,w)$, $(Q,v)$ of weights $w,v\ne0$
:where: no weight is 0
:then: $\frac Pw-\frac Qv=\frac1w\Bigl((P-Q)-\frac Qv(w-v)\Bigr)$
:method: An identity.  So the distance of the images is at most $(\|P-Q\|+\|Q/v\||w-v|)/w$: with $w$ at least the
  least weight and $Q/v$ in the convex hull of the points, a constant times the distance of the homogeneous points.
:over: v#: weights
:control: $P/w$ for $Q/v$ on the right
:degrees: all
:::
*/
CLAIM(near_homogeneous_points_are_near)
{
    num P = unknown(T, "P", 0), Q = unknown(T, "Q", 0), w = positive(T, "w", 0), v = positive(T, "v", 0);
    num image = fault(T, div(Q, v), div(P, w));
    /* P/w - Q/v = ((P - Q) - (Q/v)(w - v))/w */
    same(T, sub(div(P, w), div(Q, v)), div(sub(sub(P, Q), mul(image, sub(w, v))), w));
}

#if RATIONAL
/*
That the order $h^2$ cannot be improved is seen on the circle, where the errors of the vertices are rational numbers
and can be followed exactly.

:::{claim} quarter_circle_error_is_quartered
:title: The polygons of a quarter circle, cut in the middle: each cut divides the error by 4
:zh: 四分之一圆反复中点离散:误差恰为 4^{-k}
:kind: decision
:data: R = (1,0) (1,1) (0,1); ω = 1 1 2; λ = 1/2; q = 4
:instead: λ = 1/4
:result: errors = 1 1/4 1/16 1/64 1/256 1/1024 1/4096
:given: the quarter circle with points $R$ and weights $\omega$, whose pieces are all cut at $\lambda$, again and again
:then: the largest $|\|V\|^2-1|$ over all vertices $V$ of the polygons is 1 at first, and each of the cuts listed divides it by $q$
:method: All pieces are computed exactly, $2^k$ of them after $k$ cuts.
:control: every piece cut nearer to its first end
:::
*/
/* The largest | |V|^2 - 1 | over the vertices, after k further cuts of the quadratic (R, w). */
static num G(largest_circle_error)(int k, const num R[], const num w[], num lambda)
{
    num worst = from_int(0), P[2][6], v[2][3];
    if (k == 0) {
        for (int i = 0; i <= 2; i++) {
            num e = sub(G(norm_squared)(2, R + 2 * i), from_int(1)), size = sign_q(e) < 0 ? neg(e) : e;
            worst = compare_q(size, worst) > 0 ? size : worst;
        }
        return worst;
    }
    G(rational_split)(2, 2, R, w, lambda, P[0], v[0], P[1], v[1]);
    for (int half = 0; half < 2; half++) {
        num e = G(largest_circle_error)(k - 1, P[half], v[half], lambda);
        worst = compare_q(e, worst) > 0 ? e : worst;
    }
    return worst;
}

CLAIM(quarter_circle_error_is_quartered)
{
    enum { CUTS = 6 };
    num R[6], w[3], error[CUTS + 1];
    given_points(T, "R", 3, 2, R);
    given_points(T, "ω", 3, 1, w);
    num lambda = given(T, "λ"), q = given(T, "q");
    for (int k = 0; k <= CUTS; k++)
        error[k] = G(largest_circle_error)(k, R, w, lambda);
    found_points(T, "errors", CUTS + 1, 1, error);
    same(T, error[0], from_int(1));
    for (int k = 1; k <= CUTS; k++)
        same(T, mul(q, error[k]), error[k - 1]);
}
#endif

/*
Two hypotheses stand behind the printed sentence.  The first is not said: the pieces have to become short, all of them; that each step
cuts every piece is not enough, if the ratios may change.  The second is that of the whole chapter: the weights are positive, so that those of the
pieces stay away from 0.

:::{claim} crowded_cuts_do_not_converge
:title: Cuts that crowd one end leave a piece of length above 1/2 for ever
:zh: 分割点聚于一端时多边形不收敛
:given: the parabola $(t,t^2)$ over $[0,1]$, all pieces cut at $\lambda_k=2^{-k-1}$ in step $k=1,2,\dots$; the last
  piece, of length $h_k$; $y=2^{-k-1}$, written as $\frac1{4+s}$
:then: $h_k\ge\frac12+2^{-k-1}$ for every $k$; the middle vertex of a piece of length $h$ lies $h^2/4$ below the
  parabola: there is always a vertex more than $\frac1{16}$ below the curve
:method: $h_1=\frac34$.  With $y=2^{-k-1}$, the step $h_{k+1}=h_k(1-\frac y2)$ and the identity $(\frac12+y)(1-\frac
  y2)-(\frac12+\frac y2)=\frac{y(1-2y)}4$, whose right side is nonnegative for $0<y\le\frac14$ ($y=1/(4+s)$,
  $s\ge0$), give the bound by induction.  The piece over $[u,u+h]$ is computed with $u$ and $h$ variable.
:scope: every number of steps
:over: s: -; u h: interval
:control: $\lambda_k=\frac12$ in the step
:::
*/
CLAIM(crowded_cuts_do_not_converge)
{
    num one = from_int(1), half = from_ratio(1, 2), s = positive(T, "s", ALONE), y = div(one, add(from_int(4), s));
    num factor = fault(T, sub(one, mul(half, y)), half);
    num margin = sub(mul(add(half, y), factor), add(half, mul(half, y)));
    /* (1/2 + y)(1 - y/2) - (1/2 + y/2) = y (1 - 2y)/4 */
    same(T, margin, div(mul(y, sub(one, add(y, y))), from_int(4)));
    show(T, "y", y);
    show(T, "new length less 1/2 + y/2, at least", margin);
    nonnegative(T, margin);
    same(T, sub(one, from_ratio(1, 4)), add(half, from_ratio(1, 4)));

    num zero = from_int(0), P[] = {zero, zero, half, zero, one, one}, piece[6];
    num u = parameter(T, "u"), h = parameter(T, "h");
    G(bezier_on_interval)(2, 2, P, u, add(u, h), piece);
    /* the parabola is h²/4 above the middle vertex: x_1² - y_1 = h²/4 */
    same(T, sub(mul(piece[2], piece[2]), piece[3]), div(mul(h, h), from_int(4)));
}

/*
:::{claim} linear_weights_of_both_signs_have_a_pole
:title: With weights of both signs the denominator of a segment vanishes
:zh: 异号权时一次曲线的分母有零点
:given: $n=1$, weights $p$ and $-q$, $p,q>0$
:then: $\omega(t)=0$ at $t=p/(p+q)$, which is in $(0,1)$
:method: Computed as rational functions of $p$ and $q$.
:scope: n = 1
:over: p q: weights
:control: the weight $+q$
:::
*/
CLAIM(linear_weights_of_both_signs_have_a_pole)
{
    num p = positive(T, "p", ALONE), q = positive(T, "q", ALONE), w[] = {p, fault(T, neg(q), q)}, t = div(p, add(p, q));
    show_points(T, "ω", 2, 1, w);
    show(T, "t", t);
    G(must_be_positive)(T, t);
    G(must_be_positive)(T, sub(from_int(1), t));
    vanishes(T, G(rational_weight)(1, w, t));
}

#include "chapters/judge/claims_off.h"
