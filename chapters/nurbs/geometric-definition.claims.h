/*
# The geometric definition of a NURBS curve (NURBS 曲线的几何定义)

The section ends with a definition that is to replace the recursion of de Boor and Cox: a polygon, with weights and
knots, is the curve of order 2; the curve of order $k$ is the envelope of the polygons of level $k-2$, one for each
$\tau$ of the whole domain.  As a way to describe the curve it is right, with conditions; as a definition it would
need the envelope to exist and to be unique.  Both were seen to need hypotheses on one span; that now $t$ and $\tau$
may be in different spans adds another: the leg of span $j$ in the polygon of $\tau$ is the tangent at $\tau$ of the
*continued* segment $j$. An inflection of the continuation, although it is not on the curve, is enough for a second
envelope.
*/
#include "chapters/nurbs/family.h"

#include "chapters/judge/elementary.h"

#include "chapters/judge/claims_on.h"

/*
:::{statement} wang-ch4:def-4.3.1-polygon
:title: The polygon is the curve of order 2
:zh: 控制多边形即二阶 NURBS 曲线
:printed: for $\{\mathbf r_i\}_{i=1}^n\in\Re^3$, $\{w_i\}_{i=1}^n\in\Re$, $w_i>0$, and a nonuniform partition $T=\{t_j\}_{j=-\infty}^\infty$ of the $t$-axis, $t_j\le t_{j+1}$, the
  polygon $\mathbf r_1\mathbf r_2\cdots\mathbf r_n$ is called the
  NURBS curve $\mathbf r(t)$, $t_2\le t\le t_{n+1}$, of order 2 (degree 1) of the knot vector $T$ with the control points $\{\mathbf r_i\}_{i=1}^n$ and the weights
  $\{w_i\}_{i=1}^n$; its segments are the straight segments $\mathbf r_{j-1}\mathbf r_j$
:definition: yes
:checked-by: leg_of_every_polygon_is_the_curve_of_order_two outer_functions_are_made_of_outer_ones legs_are_run_through
:confirmed-by: polygon_is_the_curve_of_order_two
:hypothesis: double_knot_skips_a_leg | $t_2<t_3<\dots<t_{n+1}$; where two of these knots are one the curve jumps over
  a leg of the polygon
:figure: nurbs_polygons

With $t_2<t_3<\dots<t_{n+1}$ the curve of order 2 runs through the legs, from $\mathbf r_1$ at $t_2$ to $\mathbf
r_n$ at $t_{n+1}$.
:::

:::{statement} wang-ch4:def-4.3.1-segment
:title: The equation of a leg
:zh: 每一段的方程
:printed: \mathbf r(t)=\frac{(t_{j+1}-t)w_{j-1}\mathbf r_{j-1}+(t-t_j)w_j\mathbf
  r_j}{(t_{j+1}-t)w_{j-1}+(t-t_j)w_j},\quad t_j\le t<t_{j+1},\ j=2,3,\dots,n
:holds-by: leg_of_every_polygon_is_the_curve_of_order_two outer_functions_are_made_of_outer_ones
:confirmed-by: polygon_is_the_curve_of_order_two
:figure: nurbs_polygons
:::

:::{claim} leg_of_every_polygon_is_the_curve_of_order_two
:title: On a span the sum is the printed leg, however many points there are
:zh: 任意顶点数时二阶曲线的每一段
:given: a span that is not empty and the three knots at either end of it, in every pattern; weights and points; any $t$
:where: $w(t)\ne0$
:then: of the four functions of order 2 that these knots have the two outer ones are 0 on the span, and the sum of all is the printed quotient of the
  two points between
:method: The sums by the recursion of de Boor and Cox as it is defined.  Every other function of order 2 is made from two functions of order 1
  of other spans, which are 0 on this one (`outer_functions_are_made_of_outer_ones`); so the number of points does not matter.
:degrees: 1..1
:scope: every pattern of the knots around a span
:control: the weights of the two points exchanged
:::
*/
CLAIM(leg_of_every_polygon_is_the_curve_of_order_two)
{
    static const char *const patterns[] = {"111111", "11112", "11121", "1113", "12111", "1212", "1221", "123",
                                           "21111",  "2112",  "2121",  "213",  "3111",  "312",  "321",  "33"};
    int place[MOST_KNOTS], n = 4, j = 2; /* t_j = u[2], the points of the span R[1] and R[2] */
    num u[MOST_KNOTS], R[8], w[8], H[8], t = parameter(T, "t"), zero = from_int(0);
    G(free_curve)(T, n - 1, 1, R, w);
    for (int i = 0; i < n; i++)
        H[i] = mul(w[i], R[i]);
    for (int kind = 0; kind < 16; kind++) {
        G(knots_of_pattern)(T, patterns[kind], u, place);
        about(T, "the outer functions");
        same(T, G(cox_de_boor)(1, u, place, j - 2, place[j], t), zero);
        same(T, G(cox_de_boor)(1, u, place, j + 1, place[j], t), zero);
        num left = mul(sub(u[j + 1], t), w[fault(T, 1, 2)]), right = mul(sub(t, u[j]), w[fault(T, 2, 1)]);
        num above = G(spline_value)(n, 1, 1, u, place, H, 0, place[j], t);
        about(T, "the leg");
        same(T, div(above, G(spline_value)(n, 1, 1, u, place, w, 0, place[j], t)),
             div(add(mul(left, R[1]), mul(right, R[2])), add(left, right)));
    }
}

/*
:::{claim} polygon_is_the_curve_of_order_two
:title: The sum over all points is the printed leg on every span
:zh: 二阶曲线的每一段
:given: $n=5$ points with weights; seven simple knots, and double knots inside, at one end, at the other and at both, and inside and at one end;
  every span that is not empty; any $t$
:then: $\sum_{i=1}^nN_{i,2}(t)w_ir_i/\sum_{i=1}^nN_{i,2}(t)w_i$ is the printed quotient, $j=2,\dots,n$
:method: The sums by the recursion of de Boor and Cox as it is defined, with all indices; one coordinate, everything a
  variable.
:scope: k = 2 with five points; simple knots and five patterns with double ones
:where: $w(t)\ne0$
:control: the weights of the two points exchanged
:::
*/
CLAIM(polygon_is_the_curve_of_order_two)
{
    static const char *const kinds[] = {"1111111", "112111", "211111", "111112", "21112", "2122"};
    int n = 5;
    num u[MOST_KNOTS], R[8], w[8], H[8], t = parameter(T, "t");
    int place[MOST_KNOTS];
    G(free_curve)(T, n - 1, 1, R, w);
    for (int i = 0; i < n; i++)
        H[i] = mul(w[i], R[i]);
    for (int kind = 0; kind < 6; kind++) {
        G(knots_of_pattern)(T, kinds[kind], u, place);
        for (int j = 2; j <= n; j++) { /* t_j = u[j-1], r_j = R[j-1] */
            if (place[j - 1] == place[j])
                continue;
            num up = sub(t, u[j - 1]), down = sub(u[j], t);
            num left = mul(down, w[fault(T, j - 2, j - 1)]), right = mul(up, w[fault(T, j - 1, j - 2)]);
            num leg = div(add(mul(left, R[j - 2]), mul(right, R[j - 1])), add(left, right));
            num above = G(spline_value)(n, 1, 1, u, place, H, 0, place[j - 1], t);
            same(T, div(above, G(spline_value)(n, 1, 1, u, place, w, 0, place[j - 1], t)), leg);
        }
    }
}

#if FIELD || RATIONAL
/*
That the sum of order 2 is the polygon means two things: on every span it is the quotient of the two ends, and this
quotient runs through the leg once, forwards.  For positive weights it does, at a speed that depends on them.

:::{claim} legs_are_run_through
:title: A leg is run through from one end to the other
:zh: 每段从一端到另一端单调
:given: $w_{j-1},w_j>0$ and $t=(t_j+t_{j+1}x)/(1+x)$, $x\ge0$
:then: the leg at $t$ is $r_{j-1}+\lambda(r_j-r_{j-1})$ with $\lambda=\frac{xw_j}{w_{j-1}+xw_j}$, which is 0 for $x=0$, increases strictly and is below 1;
  at $t=t_{j+1}$ the quotient of the leg is $r_j$
:method: An identity for $x=0$ and for $x>0$; $\lambda(x+h)-\lambda(x)>0$ for $h>0$ by the signs of the coefficients;
  $1-\lambda=\frac{w_{j-1}}{w_{j-1}+xw_j}$; and the end of the leg, which is a continuous function of $t$ on the closed span.
:types: field rational
:over: x h: ratio in which t divides its span; u: knot; g: length of the span
:control: $\lambda=\frac{x}{1+x}$, as if the weights were equal
:::
*/
CLAIM(legs_are_run_through)
{
    num a = unknown(T, "a", 0), b = unknown(T, "a", 1), v = positive(T, "w", 0), w = positive(T, "w", 1),
        one = from_int(1);
    num h = positive(T, "h", 0), u = unknown(T, "u", 0), length = positive(T, "g", 0);
    for (int begun = 0; begun <= 1; begun++) {
        num x = begun ? positive(T, "x", 0) : from_int(0), more = add(x, h);
        num t = div(add(u, mul(x, add(u, length))), add(one, x));
        num left = mul(sub(add(u, length), t), v), right = mul(sub(t, u), w);
        num leg = div(add(mul(left, a), mul(right, b)), add(left, right));
        num lambda = div(mul(x, w), add(v, mul(x, w))), later = div(mul(more, w), add(v, mul(more, w)));
        num share = fault(T, lambda, div(x, add(one, x)));
        about(T, "the leg");
        /* leg = r_j-1 + λ (r_j - r_j-1) */
        same(T, leg, add(a, mul(share, sub(b, a))));
        about(T, "the growth of λ");
        G(must_be_positive)(T, sub(later, lambda));
        about(T, "what is missing to 1");
        same(T, sub(one, lambda), div(v, add(v, mul(x, w))));
    }
    /* at t = t_j+1, the first factor being 0: leg = r_j */
    num end = add(u, length), first = mul(sub(end, end), v), last = mul(sub(end, u), w);
    about(T, "the end of the leg");
    same(T, div(add(mul(first, a), mul(last, b)), add(first, last)), b);
}
#endif

#if RATIONAL
/*
The definition allows equal knots.  Then a span is empty, and with it the leg that belongs to it: the points at its
ends are reached, one from each side, and nothing between.

:::{claim} double_knot_skips_a_leg
:title: Where two knots are one the curve of order 2 jumps over a leg
:zh: 重节点处二阶曲线跳过一条边
:kind: counterexample
:given: a curve of order 2 with four points $r_i$, equal weights and the knots $t_i$, of which $t_3=t_4$
:data: t_i = 0 1 2 2 3 4; r_i = (0,0) (1,1) (2,1) (3,0)
:instead: t_i = 0 1 3/2 2 3 4
:then: the middle of the leg $r_2r_3$ is not on the curve
:result: middle of the leg = (3/2,1); points of the curve with its abscissa = 0
:method: On each of the two spans that are not empty the parameters of the points with the abscissa of this middle are
  counted, with both ends; that there is one is what is compared.
:control: simple knots
:::
*/
CLAIM(double_knot_skips_a_leg)
{
    num u[6], R[8], x[4], middle[2];
    int points = 0;
    given_points(T, "t_i", 6, 1, u);
    given_points(T, "r_i", 4, 2, R);
    for (int c = 0; c < 2; c++)
        middle[c] = div(add(R[2 + c], R[4 + c]), from_int(2));
    for (int i = 0; i < 4; i++)
        x[i] = sub(R[2 * i], middle[0]);
    for (int mu = 1; mu < 4; mu++) {
        num b[2];
        if (equal_q(u[mu], u[mu + 1]))
            continue;
        G(bspline_to_bezier)(G(on_span)(1, 1, u, mu, x), b);
        points += count_roots(poly_from_bernstein(1, b), from_int(0), from_int(1), CLOSED).distinct;
    }
    found_points(T, "middle of the leg", 1, 2, middle);
    found_whole(T, "points of the curve with its abscissa", points);
    about(T, "the middle of the leg is on the curve");
    agree(T, points > 0);
}

/*
:::{statement} wang-ch4:def-4.3.1-sum
:title: The polygon as one sum
:zh: 多边形的统一表示
:printed: \mathbf r(t)=\sum_{i=1}^nN_{i,2}(t)w_i\mathbf r_i\Big/\sum_{i=1}^nN_{i,2}(t)w_i,\quad t_2\le t\le t_{n+1}
:holds-by: leg_of_every_polygon_is_the_curve_of_order_two outer_functions_are_made_of_outer_ones
:confirmed-by: polygon_is_the_curve_of_order_two
:meant: the range $t_2\le t\le t_{n+1}$, which is printed closed | At its end the limit from the left, as `def-4.1.1-interval` says once for all
  curves.
:reading: polygon_end_belongs_to_no_interval | at $t=t_{n+1}=t_{n+2}$ by the letter of the half-open intervals: the sum is
  $0/0$ there, and the polygon lacks $\mathbf r_n$
:figure: nurbs_polygons

Where two of the knots $t_2,\dots,t_{n+1}$ are one the curve of this sum lacks a leg of the polygon, see `def-4.3.1-polygon`.
:::

:::{claim} polygon_end_belongs_to_no_interval
:title: At a double right end the sum of order 2 is 0/0
:zh: 右端二重时二阶曲线终点无定义
:kind: counterexample
:given: $k=n=2$, the clamped knots $t_i$ and one more; $t=t_{n+1}$, which lies in $[t_4,t_5)$ and in no interval
  before
:data: t_i = 0 0 1 1 2; t = 1
:instead: t_i = 0 0 1 2 2
:then: $\sum_{i=1}^2N_{i,2}(t)=0$
:result: the sum = 0
:method: The recursion by its letter for the interval that contains $t$.
:control: a simple knot at the right end
:::
*/
CLAIM(polygon_end_belongs_to_no_interval)
{
    int place[5];
    num u[5], sum = from_int(0);
    given_points(T, "t_i", 5, 1, u);
    num t = given(T, "t");
    G(places_of)(5, u, place);
    for (int i = 0; i < 2; i++)
        sum = add(sum, G(cox_de_boor)(1, u, place, i, G(interval_of)(5, u, place, t), t));
    found(T, "the sum", sum);
    about(T, "the sum of both functions at t, and 1");
    same(T, sum, from_int(1));
}

/*
:::{statement} wang-ch4:def-4.3.1-index
:title: The indices of the recursion
:zh: 递推的下标范围
:printed: for every fixed $t=\tau\in[t_k,t_{n+1}]$ compute recursively by (4.1.3), (4.1.4), for $r=1,2,\dots,k-2$, $w_i^{[r]}(\tau)$, $\mathbf r_i^{[r]}(\tau)$, $i=2,3,\dots,n$
:class: misprint
:refuted-by: recursion_asks_for_a_point_that_is_missing
:corrected: $i=r+1,r+2,\dots,n$
:corrected-by: whole_member_is_polar_on_every_span
:hypothesis: extrapolated_weight_vanishes | $w_i^{[\rho]}(\tau)\ne0$ for $\rho=1,\dots,r$ and $i=\rho+1,\dots,n$: also with the right range of $i$ the recursion may lack a point although
  all weights are positive
:hypothesis: high_knot_leaves_a_point_undefined | the terms with $t_i=t_{i+k-r}$ are left out: also with the right range of $i$ (4.1.3) divides by 0 there
:figure: recursion_indices

For $r=1$ it is right; from $r=2$ on $\mathbf r_2^{[2]}$ needs $\mathbf r_1^{[1]}$ and that $\mathbf r_0$, which does
not exist.
:::

The range of the index is the same on all levels in the print.  A point of level $r$ is made of $r+1$ control points,
the first of which has the index $i-r$; so a fixed lower bound asks for points before the first one as soon as $r$ is
2.

:::{claim} recursion_asks_for_a_point_that_is_missing
:title: With i = 2, ..., n on every level the recursion asks for the point 0
:zh: 按 i=2,...,n 递推需要不存在的顶点 r_0
:kind: counterexample
:given: $k$ and $n$; $r=1,\dots,k-2$, $i=2,\dots,n$, as printed
:data: k = 4; n = 4
:then: some $r_i^{[r]}$ depends by (4.1.4) on a point with an index below 1
:result: r = 2; i = 2; least index of a point = 0
:method: By (4.1.4) $r_i^{[r]}$ depends on the points $i-r,\dots,i$ of level 0; the least index is compared with 1.
:control: $i=r+1,\dots,n$
:::
*/
CLAIM(recursion_asks_for_a_point_that_is_missing)
{
    int k = given_whole(T, "k"), n = given_whole(T, "n"), least = n, at_level = 0, at_index = 0;
    for (int r = 1; r <= k - 2; r++)
        for (int i = fault(T, r + 1, 2); i <= n; i++) {
            int index = i;
            for (int level = r; level >= 1; level--) /* the left one of the two points of the level before */
                index--;
            if (index < least) {
                least = index;
                at_level = r;
                at_index = i;
            }
        }
    found_whole(T, "r", at_level);
    found_whole(T, "i", at_index);
    found_whole(T, "least index of a point", least);
    about(T, "every point that the recursion asks for exists");
    agree(T, least >= 1);
}
#endif

/*
:::{statement} wang-ch4:def-4.3.1-family
:title: The family of polygons
:zh: 二阶 NURBS 曲线族
:printed: then make the family of NURBS curves of order 2, for $\tau\in[t_k,t_{n+1}]$,
  $\mathbf r^{[2]}(t,\tau)=\sum_{i=k-1}^nN_{i,2}(t)w_i^{[k-2]}(\tau)\mathbf
  r_i^{[k-2]}(\tau)\Big/\sum_{i=k-1}^nN_{i,2}(t)w_i^{[k-2]}(\tau)$
:definition: yes
:checked-by: whole_member_is_polar_on_every_span legs_are_tangents_of_the_continued_segments
:confirmed-by: extrapolated_members_keep_positive_weights_inside
:hypothesis: extrapolated_weight_vanishes | no $w_i^{[k-2]}(\tau)$, $i=k-1,\dots,n$, vanishes for $\tau\in[t_k,t_{n+1}]$
:hypothesis: extrapolated_member_has_a_pole | no $w_i^{[k-2]}(\tau)$, $i=k-1,\dots,n$, vanishes for $\tau\in[t_k,t_{n+1}]$;
  where for one $\tau$ a weight is 0, for another one it is negative, and the denominator may vanish
:hypothesis: lower_level_lacks_a_point | no $w_i^{[r]}(\tau)$, $i=r+1,\dots,n$, of the levels $r=1,\dots,k-3$ vanishes there
:hypothesis: high_knot_leaves_a_point_undefined | $t_i<t_{i+2}$ for $i=k-1,\dots,n$, or on every level $r$ the terms with $t_i=t_{i+k-r}$ are left
  out: their $N_{i,k-r}$ is 0
:figure: nurbs_polygons

Values at $t_{n+1}$ are limits from the left, see `def-4.1.1-interval`.  That no weight of the level is 0 for any $\tau$ makes positive those whose $N_{i,2}$ is not 0 on the
domain, each being positive on a span of it (`extrapolated_members_keep_positive_weights_inside`), and then no denominator vanishes.
:::

In the polygon of $\tau$ only one leg belongs to the span of $\tau$.  What are the others?  By the polar form the leg
over the span of $t$ is a piece of the tangent, at $\tau$, of the polynomials of *that* span.  On a drawing one sees
it by continuing each segment beyond its knots.

:::{claim} legs_are_tangents_of_the_continued_segments
:title: The leg over a span is a piece of the tangent at τ of the segment of that span, continued to τ
:zh: 各段直线是该段延拓后在 τ 处的切线
:given: order $k$; homogeneous points over simple knots, and over knots one of which, inside, is double, $(k-1)$-fold or $k$-fold; any $\tau$ and $t$; every
  span; $r=k-2$
:then: $\sum_{i=k-1}^nN_{i,2}(t)\,w_i^{[k-2]}(\tau)(r_i^{[k-2]}(\tau),1)=P_j(\tau)+\frac{t-\tau}{k-1}P_j'(\tau)$ with
  the polynomials $P_j$ of the span of $t$
:method: The levels by the recursion for all indices, by its letter, without the $i$ with $t_i=t_{i+k-r}$; the sum of the other terms by the recursion of de Boor
  and Cox as it is defined; the right side by the kernel of derivatives, whose parameter is any number.  So for every $t$ of the
  span the derivatives by $t$ and by $\tau$ are those of the tangents of one curve.
:degrees: 2..6 sampled 6
:scope: simple knots, or one inner knot double, (k-1)-fold or k-fold; the distinct knots variables up to order 5, numbers above
:control: the segment of the first span for every span
:::
*/
CLAIM(legs_are_tangents_of_the_continued_segments)
{
    int p = T->degree;
    num t = parameter(T, "t"), tau = parameter(T, "s");
    for (int kind = 0; kind < 4; kind++) {
        char pattern[MOST_KNOTS] = {0};
        int many = kind < 2 ? kind + 1 : p + kind - 2, n = kind < 2 ? p + 3 : p + many + 1;
        for (int i = 0; i < n + p + 2 - many; i++)
            pattern[i] = (char)('0' + (i == p + 1 ? many : 1));
        num u[MOST_KNOTS], H[2 * MOST_KNOTS], h[2][MOST_KNOTS];
        int place[MOST_KNOTS], count = G(knots_of_pattern)(T, pattern, u, place);
        G(numbers_above)(4, p, count, place, u);
        for (int m = 0; m < 2 * n; m++) {
            H[m] = unknown(T, "H", m);
            h[m % 2][m / 2] = H[m];
        }
        for (int c = 0; c < 2; c++)
            for (int r = 1; r <= p - 1; r++)
                for (int i = n - 1; i >= r; i--) { /* (4.1.3) for i = r+1, ..., n */
                    num length = sub(u[i + p + 1 - r], u[i]);
                    if (place[i] < place[i + p + 1 - r])
                        h[c][i] = add(mul(div(sub(tau, u[i]), length), h[c][i]),
                                      mul(div(sub(u[i + p + 1 - r], tau), length), h[c][i - 1]));
                }
        for (int interval = place[p]; interval < place[n]; interval++) {
            int mu = G(span_of_interval)(count, place, fault(T, interval, place[p]));
            num D[4], step = mul(sub(t, tau), from_ratio(1, p));
            G(bspline_derivatives)(G(on_span)(p, 2, u, mu, H), tau, 1, D);
            for (int c = 0; c < 2; c++) {
                num sum = from_int(0);
                for (int i = p - 1; i < n; i++)
                    if (place[i] < place[i + 2])
                        sum = add(sum, mul(h[c][i], G(cox_de_boor)(1, u, place, i, interval, t)));
                /* Σ N_i,2(t) w_i[k-2](τ) (r_i[k-2](τ), 1) = P_j(τ) + (t - τ)/(k-1) P_j'(τ) */
                same(T, sum, add(D[c], mul(step, D[2 + c])));
            }
        }
    }
}

/*
:::{statement} wang-ch4:def-4.3.1-exists-unique
:title: The definition rests on existence and uniqueness
:zh: 因为包络存在且唯一
:printed: since the envelope exists and is unique, intuitive geometric definitions of NURBS curves can be given by different kinds of envelopes; one, based on corollary 4.3.1, is
  listed here
:class: false
:refuted-by: convex_quartic_of_span_has_second_envelope extrapolated_weight_vanishes
:reading: convex_quartic_of_span_has_second_envelope | unique on every span for every $r$
:reading: convex_polygon_has_a_stationary_leg | the only joint solution for the family of the definition: a leg
  of one of the polygons is another
:reading: extrapolated_weight_vanishes | existence for every family that is used: not for that of the definition,
  with positive weights
:meant: theorems 4.3.1 to 4.3.3, which it sums up | All three: for every $r$, for all joint solutions, for every
  family.
:corrected: where the members exist and $\mathbf r'\ne0$, the curve is among the envelopes, as the points with $\tau=t$
:corrected-by: member_of_span_touches_curve envelope_condition_holds_on_the_diagonal whole_member_is_polar_on_every_span
:figure: nurbs_polygons_extra
:::
*/

#if RATIONAL
/*
So the inflections of the continued segments count.  To find a counterexample among convex curves one joins two cubics
with a common second derivative at the knot, of which the second has its inflection where the first one is in force.

:::{claim} convex_polygon_has_a_stationary_leg
:title: A convex curve with a strictly convex control polygon, and a leg all of whose points satisfy the condition
:zh: 控制多边形严格凸的曲线,其多边形族有满足包络条件的整条边
:kind: counterexample
:given: a cubic curve of two segments over the knots $t_i$, weights 1, by the vectors of $1,s,s^2,s^3$ with $s=t-c$;
  they are $(s,1-6s+12s^2)$ and $(s,8s^3)$; the inflection $s=0$ of the second polynomial belongs to the parameter
  $\tau=c$ of the first span; a $t$ of the second span
:data: t_i = 1 2 3 4 5 6 7 8 9; c = 9/2; first segment = (0,1) (1,-6) (0,12) (0,0); second segment = (0,0) (1,0) (0,0)
  (0,8); t = 11/2; τ = 9/2
:instead: τ = 11/2
:then: every corner of the control polygon is a strict left turn and $\mathbf r'\times\mathbf r''>0$ on both closed
  spans; with this $\tau$ the condition of the envelope is satisfied at every $t$ of the second span, and the point of the given $t$ is not on the curve
:result: r_i = (-3/2,33) (-1/2,3) (1/2,-3) (3/2,15) (5/2,105); ends of the leg where the condition is satisfied = (5) (6); point of the member = (1/3,0); its
  derivatives by t and τ = (1/3,0) (2/3,0); point of the curve with its abscissa = (1/3,1/3)
:method: The points are values of the polar forms; the two polar forms are found to agree for the three points that
  both segments use.  The signs are decided: of the determinants of neighbouring edges, and of polynomials.  Then the
  condition by the family of the second span: with weights 1 the leg has a constant derivative by $t$, and that by $\tau$ is linear in $t$, so that the condition is
  satisfied on the whole leg if it is at both ends; then the ordinate of the point is compared with that of the curve at its
  abscissa $x$, at $t=x+c$.
:control: $\tau=t$
:::
*/
CLAIM(convex_polygon_has_a_stationary_leg)
{
    num u[9], segment[2][8], R[10], w[5], X[2], D[6], x[3], power[4], ends[2], at[2];
    int agrees = 1, convex = 1, satisfied = 0;
    given_points(T, "t_i", 9, 1, u);
    num c = given(T, "c");
    given_points(T, "first segment", 4, 2, segment[0]);
    given_points(T, "second segment", 4, 2, segment[1]);
    num t = given(T, "t"), tau = given(T, "τ");
    for (int i = 0; i < 5; i++) {
        for (int m = 0; m < 3; m++)
            x[m] = sub(u[i + 1 + m], c);
        w[i] = from_int(1);
        for (int d = 0; d < 2; d++) {
            num value[2];
            for (int s = 0; s < 2; s++) {
                for (int m = 0; m < 4; m++)
                    power[m] = segment[s][2 * m + d];
                value[s] = G(polar_of_powers)(3, power, x);
            }
            R[2 * i + d] = value[i < 4 ? 0 : 1];
            agrees &= i == 0 || i == 4 || equal_q(value[0], value[1]);
        }
    }
    for (int i = 0; i + 2 < 5; i++) {
        num a[2] = {sub(R[2 * i + 2], R[2 * i]), sub(R[2 * i + 3], R[2 * i + 1])};
        num b[2] = {sub(R[2 * i + 4], R[2 * i + 2]), sub(R[2 * i + 5], R[2 * i + 3])};
        convex &= sign_q(G(cross2)(a, b)) > 0;
    }
    convex &= G(turns_left_on_span)(3, u, 3, R) && G(turns_left_on_span)(3, u, 4, R);
    found_points(T, "r_i", 5, 2, R);
    for (int end = 4; end <= 5; end++) {
        G(family_derivatives)(3, 2, u, 4, R + 2, w + 1, 2, tau, u[end], D);
        if (is_zero_q(G(cross2)(D + 2, D + 4)))
            ends[satisfied++] = u[end];
    }
    found_points(T, "ends of the leg where the condition is satisfied", satisfied, 1, ends);
    if (!G(pair_of_the_envelope)(T, 3, 2, u, 4, R + 2, w + 1, 2, tau, t, X) || !agrees || !convex)
        return;
    num place = add(X[0], c);
    G(bspline_deboor)(G(on_span)(3, 2, u, compare_q(place, u[4]) < 0 ? 3 : 4, R), place, at);
    found_points(T, "point of the curve with its abscissa", 1, 2, at);
    about(T, "the ordinates of the point and of the curve at its abscissa");
    same(T, X[1], at[1]);
}
#endif

/*
:::{statement} wang-ch4:def-4.3.1
:title: The curve as the envelope of its polygons
:zh: NURBS 曲线的几何定义
:printed: for points $\mathbf r_i$ of space, weights $w_i>0$ and a partition $T$, $t_j\le t_{j+1}$: for every fixed value $t=\tau\in[t_k,t_{n+1}]$ compute by (4.1.3), (4.1.4), for $r=1,2,\dots,k-2$, the $w_i^{[r]}(\tau)$,
  $\mathbf r_i^{[r]}(\tau)$; then make the family of the curves $\mathbf r^{[2]}(t,\tau)$ of order 2; its
  envelope is the NURBS curve of order $k$ (degree $k-1$) of $T$, $\{\mathbf r_i\}$, $\{w_i\}$, written (4.1.2)
:class: missing-hypothesis
:refuted-by: extrapolated_weight_vanishes convex_polygon_has_a_stationary_leg
:reading: extrapolated_weight_vanishes | as a construction, for every $\tau$: the polygon of some $\tau$ may not
  exist, although the weights are positive
:reading: convex_polygon_has_a_stationary_leg | the envelope as the set of all joint solutions, which is the notion of
  the section: more than the curve, even for a strictly convex control polygon
:reading: legs_are_tangents_of_the_continued_segments | the envelope as a curve that touches a varying polygon in each
  of its points: where the polygons exist it is the curve alone, unless a segment is straight or a point | With $\tau\ne t$
  the condition holds for finitely many $\tau$ only, zeros of $\mathbf r'\times\mathbf r''$ or of $w$ of the continued segments; on a
  curve that touches a varying polygon $\tau$ runs through intervals.
:reading-with: first_level_condition_factors
:meant: the words "for every", and the section, by which the envelope is all joint solutions | The first and the
  second together: every $\tau$ has its polygon, and all joint solutions are points of the curve.
:corrected: if the polygons are defined and $\mathbf r'\ne0$, the curve is an envelope of them.  Of the pairs $(t,\tau)$ of the whole square, $t_k\le t,\tau\le t_{n+1}$, for which
  the segment of the span of $t$, continued to $\tau$, has $w(\tau)\ne0$, the two derivatives are parallel where $\tau=t$ and where that segment has $\mathbf r'\times\mathbf r''=0$
  at $\tau$, and nowhere else; with $k=3$ no pair is of the second kind if no three neighbouring points are on a line
:corrected-by: legs_are_tangents_of_the_continued_segments quadratic_legs_have_one_envelope first_level_condition_factors
  divisors_contain_the_span
:argued: every k and all knots | In the polar form of a segment (4.1.3) puts $\tau$ for one argument, in each of which the form is affine, and at the two points of a leg it divides by
  no 0 (`divisors_contain_the_span`).  So the leg over the span of $P_j$ goes from $P_j[\tau,\dots,\tau,t_j]$ to $P_j[\tau,\dots,\tau,t_{j+1}]$, along the tangent at $\tau$.
:confirmed-by: whole_member_is_polar_on_every_span
:figure: nurbs_polygons_extra

A curve of order 2 is a polygon, see `def-4.3.1-polygon`.  In `first_level_condition_factors` the curve is taken at $t$ and the point of the tangent is told by $\tau$; here it is the other way round, so that $t$ and $\tau$ are to be
exchanged there.
:::

For quadratic curves nothing of the kind can happen: a parabola or another conic has no inflection, however far it is
continued. The determinant that decides is a constant, the area of the triangle of the three points over differences
of knots.

:::{claim} quadratic_legs_have_one_envelope
:title: For k = 3 a segment turns unless three neighbouring points are on a line
:zh: k=3 时仅当三点共线包络条件才处处成立
:given: $k=3$; a span with every pattern of the knots around it, the distinct knots variables; three points with weights, any two coordinates of them; any $\tau$
:let: $P=(\mathbf p,w)$, the segment in homogeneous coordinates
:then:
  $\det(P,P',P'')(\tau)=\frac{4\,w_{j-2}w_{j-1}w_j\;(r_{j-1}-r_{j-2})\times(r_j-r_{j-2})}{(t_{j+1}-t_{j-1})(t_{j+2}-t_j)(t_{j+1}-t_j)}$,
  a constant
:method: The left side by the derivatives of the segment; everything a variable.  $w^3\,\mathbf r'\times\mathbf r''=\det(P,P',P'')$ by the quotient
  rule, for any $P$.  The coordinates are any two, so in space each component of $\mathbf r'\times\mathbf r''$ is such a determinant over $w^3$, and those
  of $(r_{j-1}-r_{j-2})\times(r_j-r_{j-2})$ are not all 0 if the points are not on a line: then $\mathbf r'\times\mathbf r''$ is $0$ for no $\tau$,
  inside the span or not.
:over: f# g# h#: derivatives of numerator and denominator
:where: $w(\tau)\ne0$
:scope: every pattern of the knots around a span
:control: the factor 2
:::
*/
CLAIM(quadratic_legs_have_one_envelope)
{
    num u[MOST_KNOTS], R[6], w[3], H[9], D[9], a[2], b[2], tau = parameter(T, "s");
    int place[MOST_KNOTS];
    G(free_curve)(T, 2, 2, R, w);
    G(rational_homogenize)(2, 2, R, w, H);
    for (int c = 0; c < 2; c++) {
        a[c] = sub(R[2 + c], R[c]);
        b[c] = sub(R[4 + c], R[c]);
    }
    num turn = mul(mul(w[0], mul(w[1], w[2])), G(cross2)(a, b)), P[9], quotient[6];
    static const char *const derivative[] = {"f", "g", "h"};
    for (int i = 0; i < 9; i++) /* P, P', P'' of any curve, the weight last and not 0 */
        P[i] = i == 2 ? positive(T, "f", 2) : unknown(T, derivative[i / 3], i % 3);
    G(rational_quotient_derivatives)(2, P, 2, quotient);
    about(T, "r' x r'' and the determinant");
    same(T, mul(mul(P[2], mul(P[2], P[2])), G(cross2)(quotient + 2, quotient + 4)), G(det3)(P, P + 3, P + 6));
    about(T, "the determinant");
    for (int shape = 0; shape < G(shapes)(2); shape++) {
        G(knots_of_span)(T, 2, shape, u, place);
        G(bspline_derivatives)(G(span_alone)(2, 3, u, 2, H), tau, 2, D);
        num lengths = mul(mul(sub(u[3], u[1]), sub(u[4], u[2])), sub(u[3], u[2]));
        /* det(P, P', P'') = 4 w_j-2 w_j-1 w_j (r_j-1 - r_j-2) × (r_j - r_j-2) / ((t_j+1 - t_j-1)(t_j+2 - t_j)(t_j+1 - t_j)) */
        same(T, G(det3)(D, D + 3, D + 6), mul(from_int(fault(T, 4, 2)), div(turn, lengths)));
    }
}

#include "chapters/judge/claims_off.h"
