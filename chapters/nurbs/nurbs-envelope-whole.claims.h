/*
# The envelope of the whole curve (整条曲线的包络)

So far $t$ and $\tau$ were in one span, where every step of the recursion is a mean.  If the family is taken for the
whole domain, (4.1.3) is asked for points far from the span of $\tau$, and there it extrapolates: a factor is negative,
and a positive weight may become 0 or negative on a higher level.  What is said about the envelope stays true, span by
span; what has to be asked is whether the members exist.
*/
#include "chapters/nurbs/family.h"

#include "chapters/judge/claims_on.h"

/*
:::{statement} wang-ch4:thm-4.3.1-whole
:title: The whole curve is an envelope of the families with all points
:zh: 整条曲线的包络
:printed: for the whole curve $\mathbf r(t)$, $t_k\le t\le t_{n+1}$, it is enough to put $t,\tau\in[t_k,t_{n+1}]$ in (4.1.3) and (4.1.4), to take $[t_k,t_{n+1}]$ as the domain
  in (4.3.2) and (4.3.3) and to let the sums of (4.3.3) run from $r+1$ to $n$; the same conclusion holds
:holds-by: whole_member_is_polar_on_every_span member_of_span_touches_curve envelope_condition_holds_on_the_diagonal
:confirmed-by: equal_weights_stay_equal_for_the_whole_curve
:hypothesis: extrapolated_weight_vanishes | $w_i^{[\rho]}(\tau)\ne0$ for all $\tau$ and $i=\rho+1,\dots,n$ with $\rho=r$;
  outside its own span the recursion extrapolates, and a point of the member may not exist although all weights are positive
:hypothesis: extrapolated_member_has_a_pole | $w_i^{[\rho]}(\tau)\ne0$ for all $\tau$ and $i=\rho+1,\dots,n$ with $\rho=r$;
  where for one $\tau$ a weight is 0, for another one it is negative, and a denominator of (4.3.3) may vanish
:hypothesis: lower_level_lacks_a_point | with $\rho=1,\dots,r-1$ as well: (4.1.4) asks for their points; or the products
  $w_i^{[\rho]}\mathbf r_i^{[\rho]}$ are computed by (4.1.3)
:hypothesis: high_knot_leaves_a_point_undefined | $t_i<t_{i+k-r}$ for $i=r+1,\dots,n$, or the terms with $t_i=t_{i+k-r}$
  are left out: their $N_{i,k-r}$ is 0; else (4.1.3) divides by 0
:hypothesis: span_member_shrinks_at_a_cusp | $\mathbf r'\ne0$
:meant: the closed domain $[t_k,t_{n+1}]$ and "the same conclusion", that of theorem 4.3.1 | At $t_{n+1}$ the limit from the left, as `def-4.1.1-interval`
  says; and that the curve is an envelope, touched by a member in each of its points.
:reading: whole_member_ends_in_no_interval | at $t=t_{n+1}=\dots=t_{n+k-r}$ by the letter of the half-open intervals: (4.3.3) is
  $0/0$ there
:figure: nurbs_envelope_whole

On the span of $t$ the member $\tau$ is the polar form of *that* segment, continued to a $\tau$ of another span.  On
the span of $\tau$ it is the member of that span, so it touches the curve there.  Each $w_i^{[r]}$ whose $N_{i,k-r}$ is not
0 on the domain is positive on a span of it, as are all weights of levels on their own span; if it is 0 for no $\tau$, it is positive for all, and no denominator
vanishes.  For equal weights the hypotheses on the weights are fulfilled
(`equal_weights_stay_equal_for_the_whole_curve`).
:::
*/

/* The level r of (4.1.3) for all indices, in place: h_i, i = 0, ..., n-1, in the numbering from 0, become the h_i of
 * i = r, ..., n-1; those below stay.  Where a divisor is 0 there is no result, and none is asked for (h_i is set to 0). */
static void G(whole_level)(int n, int p, const num u[], const int place[], int r, num h[], num tau)
{
    for (int i = n - 1; i >= r; i--) {
        int far = i + p + 1 - r;
        if (place[i] == place[far]) {
            h[i] = from_int(0);
            continue;
        }
        num length = sub(u[far], u[i]);
        h[i] = add(mul(div(sub(tau, u[i]), length), h[i]), mul(div(sub(u[far], tau), length), h[i - 1]));
    }
}

/*
What the printed sum means for $t$ and $\tau$ in different spans is again said by the polar form: on the span of $t$
the member is made of the polynomials of this span, continued to $\tau$.  Neighbouring points of a level are then
shared by the pieces of the member, and where an index has $t_i=t_{i+k-r}$ no piece asks for its point.

:::{claim} whole_member_is_polar_on_every_span
:title: On every span the whole member is the polar form of the segment of that span
:zh: 整条族曲线在每一段上都是该段的极形式
:given: order $k$; points with weights over simple knots, and over knots one of which, inside, is double, $(k-1)$-fold or
  $k$-fold; any $\tau$, $t$ in each span; $r=1,\dots,k-2$
:then: $\sum_{i=r+1}^nN_{i,k-r}(t)\,w_i^{[r]}(\tau)\,(r_i^{[r]}(\tau),1)=f[\tau^r,t^{k-1-r}]$ with the polar form $f$
  of the segment that contains $t$
:method: The recursion (4.1.3) for all indices $i=r+1,\dots,n$, by its letter, in homogeneous coordinates, without the
  $i$ with $t_i=t_{i+k-r}$; the sum of the other terms by the recursion of de Boor and Cox as it is defined; the right
  side by the kernel.
:degrees: 2..6 sampled 6
:scope: simple knots, or one inner knot double, (k-1)-fold or k-fold; the distinct knots variables up to order 5, numbers above
:argued: every order and all knots | On the span of $t$ the $w_i^{[r]}(r_i^{[r]},1)$ whose $N_{i,k-r}(t)$ is not 0 are made by (4.1.3) of the points of this span alone, and
  $f$ is affine in each argument, so that they are $f[\tau^r,t_{i+1},\dots,t_{i+k-1-r}]$, for any $\tau$.
:control: the polar form of the first segment for every span
:::
*/
CLAIM(whole_member_is_polar_on_every_span)
{
    int p = T->degree;
    for (int kind = 0; kind < 4; kind++) {
        char pattern[MOST_KNOTS] = {0};
        int many = kind < 2 ? kind + 1 : p + kind - 2, n = kind < 2 ? p + 3 : p + many + 1;
        for (int i = 0; i < n + p + 2 - many; i++)
            pattern[i] = (char)('0' + (i == p + 1 ? many : 1));
        num u[MOST_KNOTS], H[2 * MOST_KNOTS], h[2][MOST_KNOTS], t = parameter(T, "t"), tau = parameter(T, "s");
        int place[MOST_KNOTS], count = G(knots_of_pattern)(T, pattern, u, place);
        G(numbers_above)(4, p, count, place, u);
        for (int m = 0; m < 2 * n; m++) {
            H[m] = unknown(T, "H", m);
            h[m % 2][m / 2] = H[m];
        }
        for (int r = 1; r <= p - 1; r++) {
            for (int c = 0; c < 2; c++)
                G(whole_level)(n, p, u, place, r, h[c], tau);
            for (int interval = place[p]; interval < place[n]; interval++) {
                int mu = G(span_of_interval)(count, place, fault(T, interval, place[p]));
                num x[MAX_DEGREE], f[2];
                for (int k = 0; k < p; k++)
                    x[k] = k < r ? tau : t;
                G(bspline_blossom)(G(on_span)(p, 2, u, mu, H), x, f);
                for (int c = 0; c < 2; c++) {
                    num sum = from_int(0);
                    for (int i = r; i < n; i++)
                        if (place[i] < place[i + p + 1 - r])
                            sum = add(sum, mul(h[c][i], G(cox_de_boor)(p - r, u, place, i, interval, t)));
                    same(T, sum, f[c]);
                }
            }
        }
    }
}

/*
:::{claim} equal_weights_stay_equal_for_the_whole_curve
:title: With equal weights all weights of all levels and all denominators of members are that weight
:zh: 权相等时各层权与族曲线分母恒为该权
:given: one weight $w$ for all points over simple knots, and over knots one of which, inside, is double, $(k-1)$-fold or
  $k$-fold; any $\tau$, $t$ in each span; $r=1,\dots,k-2$
:then: $w_i^{[r]}(\tau)=w$ for $i=r+1,\dots,n$, but for the $i$ with $t_i=t_{i+k-r}$, and $\sum_{i=r+1}^nN_{i,k-r}(t)\,w_i^{[r]}(\tau)=w$
:method: (4.1.3) for all indices by its letter, the sum by the recursion of de Boor and Cox as it is defined.
:degrees: 2..6 sampled 6
:scope: simple knots, or one inner knot double, (k-1)-fold or k-fold; the distinct knots variables up to order 5, numbers above
:over: w: common weight
:argued: every order and all knots | The two factors of (4.1.3) add up to 1, and so do the $N_{i,k-r}(t)$ on the domain.
:control: the first weight doubled
:::
*/
CLAIM(equal_weights_stay_equal_for_the_whole_curve)
{
    int p = T->degree;
    num t = parameter(T, "t"), tau = parameter(T, "s"), w = positive(T, "w", 0);
    for (int kind = 0; kind < 4; kind++) {
        char pattern[MOST_KNOTS] = {0};
        int many = kind < 2 ? kind + 1 : p + kind - 2, n = kind < 2 ? p + 3 : p + many + 1;
        for (int i = 0; i < n + p + 2 - many; i++)
            pattern[i] = (char)('0' + (i == p + 1 ? many : 1));
        num u[MOST_KNOTS], h[MOST_KNOTS];
        int place[MOST_KNOTS], count = G(knots_of_pattern)(T, pattern, u, place);
        G(numbers_above)(4, p, count, place, u);
        for (int i = 0; i < n; i++)
            h[i] = fault(T, w, i == 0 ? add(w, w) : w);
        for (int r = 1; r <= p - 1; r++) {
            G(whole_level)(n, p, u, place, r, h, tau);
            about(T, "the weights of the level");
            for (int i = r; i < n; i++)
                if (place[i] < place[i + p + 1 - r])
                    same(T, h[i], w);
            about(T, "the denominator of the member");
            for (int interval = place[p]; interval < place[n]; interval++) {
                num sum = from_int(0);
                for (int i = r; i < n; i++)
                    if (place[i] < place[i + p + 1 - r])
                        sum = add(sum, mul(h[i], G(cox_de_boor)(p - r, u, place, i, interval, t)));
                same(T, sum, w);
            }
        }
    }
}

#if RATIONAL
/*
Now the exceptions, each with positive weights.  In the first the last weight is large enough for the extrapolation to
reach 0 exactly at the start of the domain.  In the second this happens on a level below the one that is asked for,
and is hidden again one level later.

:::{claim} extrapolated_weight_vanishes
:title: With positive weights a point of a member of the whole curve may be missing
:zh: 权全为正时整条曲线的族曲线也可能缺控制顶点
:kind: counterexample
:given: a quadratic curve of four points with the positive weights $w_i$ over the simple knots $t_i$, of two spans;
  $r=1$, and $\tau=t_3$, the start of the domain
:data: t_i = 1 2 3 4 5 6 7; w_i = 1 1 1 3; τ = 3
:instead: w_i = 1 1 1 2
:then: $w_4^{[1]}(\tau)=\frac{\tau-t_4}{t_6-t_4}w_4+\frac{t_6-\tau}{t_6-t_4}w_3=0$, so that $\mathbf r_4^{[1]}(\tau)$
  is not defined; it is a point of the member on $[t_4,t_5]$
:result: weights of level 1 = 1 1 0
:method: (4.1.3) for all indices, exactly; that no weight is 0 is what is compared.
:control: a smaller last weight
:::
*/
CLAIM(extrapolated_weight_vanishes)
{
    num u[7], w[4];
    int place[7];
    given_points(T, "t_i", 7, 1, u);
    given_points(T, "w_i", 4, 1, w);
    num tau = given(T, "τ");
    G(places_of)(7, u, place);
    G(whole_level)(4, 2, u, place, 1, w, tau);
    found_points(T, "weights of level 1", 3, 1, w + 1);
    about(T, "the weights of level 1 are not 0");
    refute(T, is_zero_q(w[1]) || is_zero_q(w[2]) || is_zero_q(w[3]));
}

/*
:::{claim} lower_level_lacks_a_point
:title: A point of a lower level may be missing although no weight of the level vanishes
:zh: 本层权均不为零时低层仍可能缺控制顶点
:kind: counterexample
:given: a cubic curve of five points with the positive weights $w_i$ over the simple knots $t_i$, of two spans; $r=2$,
  and $\tau=t_4$, the start of the domain
:data: t_i = 1 2 3 4 5 6 7 8 9; w_i = 1 1 1 1 4; τ = 4
:instead: w_i = 1 1 1 1 2
:then: no weight of level 2 is 0, but $w_5^{[1]}(\tau)=0$: $\mathbf r_5^{[1]}(\tau)$ is not defined, and $\mathbf
  r_5^{[2]}(\tau)$ is a mean of it and $\mathbf r_4^{[1]}(\tau)$
:result: weights of level 1 = 1 1 1 0; weights of level 2 = 1 1 3/2
:method: (4.1.3) for all indices, exactly; that with the weights of level 2 those of level 1 are not 0 is what is
  compared.
:control: a smaller last weight
:::
*/
CLAIM(lower_level_lacks_a_point)
{
    num u[9], w[5];
    int place[9], level_two = 1, level_one = 1; /* no weight of the level is 0 */
    given_points(T, "t_i", 9, 1, u);
    given_points(T, "w_i", 5, 1, w);
    num tau = given(T, "τ");
    G(places_of)(9, u, place);
    G(whole_level)(5, 3, u, place, 1, w, tau);
    found_points(T, "weights of level 1", 4, 1, w + 1);
    for (int i = 1; i < 5; i++)
        level_one &= !is_zero_q(w[i]);
    G(whole_level)(5, 3, u, place, 2, w, tau);
    found_points(T, "weights of level 2", 3, 1, w + 2);
    for (int i = 2; i < 5; i++)
        level_two &= !is_zero_q(w[i]);
    about(T, "the weights of level 2 not being 0, those of level 1 are not 0");
    refute(T, level_two && !level_one);
}

/*
The other exceptions are about divisions.  At the right end of a clamped curve no half-open interval contains $t$;
between weights of different sign a denominator may vanish in the middle of a span; at a multiple knot the recursion
itself divides by 0.

:::{claim} whole_member_ends_in_no_interval
:title: At the end of a clamped curve numerator and denominator of a member are 0
:zh: 端点为重节点时族曲线在右端为 0/0
:kind: counterexample
:given: a clamped cubic curve of five points with equal weights over the knots $t_i$, and one knot more; $r=1$, and
  $t=\tau=t_{n+1}$, which lies in $[t_9,t_{10})$ and in no interval before
:data: t_i = 0 0 0 0 1 2 2 2 2 3; t = 2
:then: $\sum_{i=2}^5N_{i,3}(t)w_i^{[1]}(\tau)=0$
:result: weights of level 1 = 1 1 1 1; denominator at t = 0
:method: Both recursions by their letter, for the interval that contains $t$.
:control: the interval before, which is the limit from the left
:::
*/
CLAIM(whole_member_ends_in_no_interval)
{
    num u[10], w[5], sum = from_int(0);
    int place[10];
    given_points(T, "t_i", 10, 1, u);
    num t = given(T, "t");
    G(places_of)(10, u, place);
    int interval = G(interval_of)(10, u, place, t), before = interval - 1;
    for (int i = 0; i < 5; i++)
        w[i] = from_int(1);
    G(whole_level)(5, 3, u, place, 1, w, t);
    for (int i = 1; i < 5; i++)
        sum = add(sum, mul(w[i], G(cox_de_boor)(2, u, place, i, fault(T, before, interval), t)));
    found_points(T, "weights of level 1", 4, 1, w + 1);
    found(T, "denominator at t", sum);
    about(T, "the denominator of the member is not 0");
    refute(T, is_zero_q(sum));
}

/*
:::{claim} extrapolated_member_has_a_pole
:title: With positive weights a member of the whole curve may run to infinity
:zh: 权全为正时整条曲线的族曲线也可能有极点
:kind: counterexample
:given: a quadratic curve of four points with the positive weights $w_i$ over the simple knots $t_i$, of two spans;
  $r=1$, $\tau=t_3$, and a $t$ of the last span; another parameter $\sigma$ of the domain
:data: t_i = 1 2 3 4 5 6 7; w_i = 1 1 1 5; τ = 3; t = 9/2; σ = 7/2
:instead: w_i = 1 1 1 2
:then: no weight of level 1 is 0 for this $\tau$, but $\sum_{i=2}^4N_{i,2}(t)w_i^{[1]}(\tau)=0$; $w_4^{[1]}$, negative here, is 0 at $\sigma$
:result: weights of level 1 = 1 1 -1; denominator = 0; weights of level 1 at σ = 1 1 0
:method: The weights of level 1 by (4.1.3), their sum with the B-splines of order 2; compared with 0.
:control: a smaller last weight
:::
*/
CLAIM(extrapolated_member_has_a_pole)
{
    num u[7], w[4], v[4], sum = from_int(0);
    int place[7];
    given_points(T, "t_i", 7, 1, u);
    given_points(T, "w_i", 4, 1, w);
    num tau = given(T, "τ"), t = given(T, "t");
    G(places_of)(7, u, place);
    for (int i = 0; i < 4; i++)
        v[i] = w[i];
    G(whole_level)(4, 2, u, place, 1, w, tau);
    G(whole_level)(4, 2, u, place, 1, v, given(T, "σ"));
    for (int i = 1; i < 4; i++)
        sum = add(sum, mul(w[i], G(cox_de_boor)(1, u, place, i, G(interval_of)(7, u, place, t), t)));
    found_points(T, "weights of level 1", 3, 1, w + 1);
    found(T, "denominator", sum);
    found_points(T, "weights of level 1 at σ", 3, 1, v + 1);
    about(T, "the denominator of the member is not 0");
    refute(T, is_zero_q(sum));
}

/*
:::{claim} high_knot_leaves_a_point_undefined
:title: At a knot of multiplicity k-r+1 the recursion for all indices divides by 0
:zh: 内节点重数达 k-r+1 时递推分母为零
:kind: counterexample
:given: a clamped curve of order $k$, two segments, with $n$ points and the knots $t_i$; $r$; a $\tau$ of the second
  segment
:data: k = 4; n = 7; t_i = 0 0 0 0 1 1 1 2 2 2 2; r = 2; τ = 3/2
:instead: n = 6; t_i = 0 0 0 0 1 1 2 2 2 2
:then: $t_{i+k-r}-t_i=0$ for an index $i$ of $r+1,\dots,n$, and at $\tau$ the numerator of the printed coefficient of
  $w_i^{[r-1]}$ is not 0
:result: number of divisors that are 0 = 1; i = 5; τ - t_i = 1/2
:method: All divisors of (4.1.3) for $i=r+1,\dots,n$ are computed; that none is 0 is what is compared.
:control: the inner knot double
:::
*/
CLAIM(high_knot_leaves_a_point_undefined)
{
    enum { MOST = 11 };
    int k = given_whole(T, "k"), n = given_whole(T, "n"), zeros = 0, index = 0;
    num t[MOST + 1], numerator = from_int(0);
    given_points(T, "t_i", n + k, 1, t + 1);
    int r = given_whole(T, "r");
    num tau = given(T, "τ");
    for (int i = r + 1; i <= n; i++)
        if (equal_q(t[i + k - r], t[i])) {
            zeros++;
            index = i;
            numerator = sub(tau, t[i]);
        }
    found_whole(T, "number of divisors that are 0", zeros);
    found_whole(T, "i", index);
    found(T, "τ - t_i", numerator);
    about(T, "no divisor t_{i+k-r} - t_i is 0, or no numerator is left");
    refute(T, zeros > 0 && !is_zero_q(numerator));
}
#endif

#include "chapters/judge/claims_off.h"
