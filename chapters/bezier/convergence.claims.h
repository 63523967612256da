/*
# The polygons converge (控制多边形的收敛)

Elevated again and again, and subdivided again and again, the polygon tends to the curve.  Both follow from what one
can say exactly: where the elevated points are, and how far the curve is from its polygon.
*/
#include "chapters/bezier/definition.h"

#if RATIONAL
#include "exact/record/sign.h"
#endif

#include "chapters/judge/claims_on.h"

/*
## Elevation

After elevation from degree $n$ to degree $N$ the new points have a closed form; the weight of $b_j$ in $b_i^{(N)}$ is a
probability of drawing without replacement.  Below $[x]_k=x(x-1)\cdots(x-k+1)$.
*/

/* x (x-1) ... (x-k+1) */
static num G(falling)(num x, int k)
{
    num product = from_int(1);
    for (int m = 0; m < k; m++)
        product = mul(product, sub(x, from_int(m)));
    return product;
}

/* The weight of b_j in point i of degree N. */
static num G(elevation_weight)(int n, int j, num i, num N, int of_powers)
{
    num rest = sub(N, i), above = of_powers ? G(power)(rest, n - j) : G(falling)(rest, n - j);
    return div(mul(G(choose)(n, j), mul(G(falling)(i, j), above)), G(falling)(N, n));
}

/*
Imagine an urn with $N$ balls of which $i$ are black, and draw $n$ of them without putting any back: $w_j(i,N)$ is the probability of
$j$ black ones.  With more and more balls it no longer matters whether they are put back, and the probabilities become those of
Bernstein.  That is the convergence; the formulas below say it without the urn.

:::{claim} elevated_points_in_closed_form
:title: The points after any number of elevations
:zh: 多次升阶后的控制顶点
:given: $n$, $j\le n$; any $N\ge n$ and any $i$, both variables
:let: $w_j(i,N)=\binom nj\,[i]_j\,[N-i]_{n-j}\,/\,[N]_n$ with $[x]_k=x(x-1)\cdots(x-k+1)$
:then: $b_i^{(N)}=\sum_{j=0}^nw_j(i,N)\,b_j$, $i=0,\dots,N$, are the points of the curve in degree $N$
:method: $w_j(i,n)$ is $1$ for $i=j$ and $0$ otherwise, and with $i$ and $N$ variables
  $w_j(i,N+1)=\frac i{N+1}w_j(i-1,N)+(1-\frac i{N+1})w_j(i,N)$ in the field, which is one elevation: induction on
  $N$.  `bezier_elevate`, three times over, is compared with it as well.
:degrees: 0..6 sampled 9
:over: N; i; x#: points
:control: $[N-i]_{n-j}$ taken as $(N-i)^{n-j}$
:::
*/
CLAIM(elevated_points_in_closed_form)
{
    int n = T->degree;
    num one = from_int(1), N = whole(T, "N", 30, 50), i = whole(T, "i", 0, 29), next = add(N, one);
    num share = div(i, next);
    for (int j = 0; j <= n; j++) {
        about(T, "degree n");
        for (int k = 0; k <= n; k++)
            same(T, G(elevation_weight)(n, j, from_int(k), from_int(n), fault(T, 0, 1)), from_int(k == j));
        about(T, "from N to N+1");
        num moved = mul(share, G(elevation_weight)(n, j, sub(i, one), N, fault(T, 0, 1)));
        num kept = mul(sub(one, share), G(elevation_weight)(n, j, i, N, fault(T, 0, 1)));
        same(T, G(elevation_weight)(n, j, i, next, fault(T, 0, 1)), add(moved, kept));
    }
    num b[MAX_DEGREE + 1], points[2][MAX_DEGREE + 1];
    G(free_points)(T, n, 1, b);
    for (int k = 0; k <= n; k++)
        points[0][k] = b[k];
    for (int step = 0; step < 3; step++)
        G(bezier_elevate)(n + step, 1, points[step % 2], points[1 - step % 2]);
    about(T, "the kernel");
    for (int k = 0; k <= n + 3; k++) {
        num sum = from_int(0);
        for (int j = 0; j <= n; j++)
            sum = add(sum, mul(G(elevation_weight)(n, j, from_int(k), from_int(n + 3), fault(T, 0, 1)), b[j]));
        same(T, points[1][k], sum);
    }
}

#if FIELD
/*
:::{claim} elevated_polygons_converge_to_curve
:title: The elevated polygons converge to the curve
:zh: 升阶所得多边形序列收敛于曲线
:given: $i=xN$, $N=\frac1h$
:then: $w_j(i,N)=\binom nj\prod_{k<j}(x-kh)\prod_{k<n-j}(1-x-kh)\,/\,\prod_{k<n}(1-kh)$, and for $h=0$ this is
  $B_j^n(x)$; hence $b_i^{(N)}-b(\tfrac iN)\to0$ as $N\to\infty$, uniformly in $i$, at least as fast as $\frac1N$
:method: Equalities in the field, $x$ and $h$ variables.  The difference $w_j-B_j^n(x)$, divided by $h$ and multiplied by $\prod_{k<n}(1-kh)$, is a
  polynomial in $x$ and $h$, so that it is bounded for $0\le x\le1$, $0\le h\le\frac1{2n}$, where the product is at least $2^{-n}$; and between its
  vertices, whose distances tend to $0$, the polygon is linear.
:types: field
:degrees: 1..6
:scope: 0 ≤ t ≤ 1, N ≥ 2n
:over: x h: -
:control: $h=\frac1{2n}$ put in the place of $h=0$
:::
*/
CLAIM(elevated_polygons_converge_to_curve)
{
    int n = T->degree;
    num one = from_int(1), x = parameter(T, "x"), h = parameter(T, "h");
    for (int j = 0; j <= n; j++) {
        num weight = G(elevation_weight)(n, j, div(x, h), div(one, h), 0), product = G(choose)(n, j);
        for (int k = 0; k < j; k++)
            product = mul(product, sub(x, mul(from_int(k), h)));
        for (int k = 0; k < n - j; k++)
            product = mul(product, sub(sub(one, x), mul(from_int(k), h)));
        num below = one;
        for (int k = 0; k < n; k++)
            below = mul(below, sub(one, mul(from_int(k), h)));
        product = div(product, below);
        about(T, "the weight");
        same(T, weight, product);
        about(T, "its limit");
        num limit = fault(T, from_int(0), from_ratio(1, 2 * n));
        same(T, substitute_f(weight, h, limit), G(basis)(n, j, x));
        num quotient = mul(div(sub(weight, G(basis)(n, j, x)), h), below);
        about(T, "whether the difference, over h and times the denominator, is a polynomial");
        agree(T, denominator_degree_f(quotient, h) == 0 && denominator_degree_f(quotient, x) == 0);
    }
}
#endif

/*
## Subdivision

The distance of a curve from its polygon is governed by the second differences of the points, and a split at $t$
multiplies these by $t^2$ and $(1-t)^2$ at most.

:::{claim} split_shrinks_second_differences
:title: The second differences of the two parts
:zh: 分割后的二阶差分
:given: numbers $b_0,\dots,b_n$, any $t$
:then: the points $\ell_k$ of the part over $[0,t]$ and $r_i$ of the part over $[t,1]$ have
  $\Delta^2\ell_k=t^2\sum_{j=0}^kB_j^k(t)\,\Delta^2b_j$ and
  $\Delta^2r_i=(1-t)^2\sum_{j=0}^{n-2-i}B_j^{n-2-i}(t)\,\Delta^2b_{i+j}$: averages of the old ones, times
  $t^2$ and $(1-t)^2$
:method: The polygons by the kernel, the right sides from the definition, everything a variable.
:degrees: 2..6 sampled 12
:over: x#: coefficients
:control: $t^2$ taken as $t$
:::
*/
CLAIM(split_shrinks_second_differences)
{
    int n = T->degree;
    num b[MAX_DEGREE + 1], left[MAX_DEGREE + 1], right[MAX_DEGREE + 1], D[MAX_DEGREE + 1];
    num t = parameter(T, "t"), s = sub(from_int(1), t);
    G(free_points)(T, n, 1, b);
    G(bezier_split)(n, 1, b, t, left, right);
    for (int j = 0; j <= n - 2; j++)
        D[j] = G(difference)(1, b, 0, j, 2);
    for (int k = 0; k <= n - 2; k++) {
        num average = G(curve)(k, 1, D, 0, t);
        about(T, "the part over [0,t]");
        /* Delta^2 l_k = t^2 sum_j B_j^k(t) Delta^2 b_j */
        same(T, G(difference)(1, left, 0, k, 2), mul(fault(T, mul(t, t), t), average));
        average = G(curve)(n - 2 - k, 1, D + k, 0, t);
        about(T, "the part over [t,1]");
        /* Delta^2 r_k = (1-t)^2 sum_j B_j^{n-2-k}(t) Delta^2 b_{k+j} */
        same(T, G(difference)(1, right, 0, k, 2), mul(mul(s, s), average));
    }
}

#if RATIONAL
/*
What remains is to bound the distance by the second differences.  The bound must not depend on the points, so it is read off a
formula: the distance is a sum of second differences whose coefficients are not negative and whose sum is small.

:::{claim} curve_stays_near_polygon
:title: How far a curve is from its polygon
:zh: 曲线与控制多边形之距离
:kind: decision
:given: numbers $b_0,\dots,b_n$; $p(t)$, the polygon as a function: $p(\frac in)=b_i$, linear between
:let: $a_j(t)=\sum_i(i-j-1)_+B_i^n(t)-(nt-j-1)_+$, $x_+=\max(x,0)$
:then: $b(t)-p(t)=\sum_{j=0}^{n-2}a_j(t)\,\Delta^2b_j$ with $a_j\ge0$ and
  $\sum_ja_j\le\frac{\lfloor n/2\rfloor\lceil n/2\rceil}{2n}$ on $[0,1]$; so $|b-p|$ is at most this number times the
  largest $|\Delta^2b_j|$
:method: On each of the $n$ intervals all terms are polynomials.  The equality is linear in the $b_i$ and is decided for
  the $n+1$ unit vectors; the inequalities by the signs of the polynomials on the closed interval.  Cf.
  [nairn-peters-lutterkort-1999].
:degrees: 2..9
:control: the bound taken as $\frac{\lfloor n/2\rfloor^2}{2n}$
:::
*/
/* max(nt - knot, 0) on the interval [m/n, (m+1)/n], where it is linear. */
static poly G(kink)(int n, int knot, int m)
{
    num c[] = {from_int(-knot), from_int(n)};
    return m >= knot ? poly_from_q(2, c) : poly_constant(from_int(0));
}

CLAIM(curve_stays_near_polygon)
{
    int n = T->degree, half = n / 2;
    poly a[MAX_DEGREE], lifted[MAX_DEGREE];
    num f[MAX_DEGREE + 1], bound = from_ratio(half * fault(T, n - half, half), 2 * n);
    for (int j = 0; j <= n - 2; j++) {
        for (int i = 0; i <= n; i++)
            f[i] = from_int(i > j + 1 ? i - j - 1 : 0);
        lifted[j] = poly_from_bernstein(n, f);
    }
    for (int m = 0; m < n; m++) { /* on [m/n, (m+1)/n] */
        num low = from_ratio(m, n), high = from_ratio(m + 1, n);
        poly sum = poly_constant(from_int(0));
        for (int j = 0; j <= n - 2; j++) {
            a[j] = poly_sub(lifted[j], G(kink)(n, j + 1, m));
            sum = poly_add(sum, a[j]);
            enum cagd_sign_pattern sign = sign_on(a[j], low, high, CLOSED);
            agree(T, sign == SIGN_POSITIVE || sign == SIGN_NONNEGATIVE);
        }
        enum cagd_sign_pattern sign = sign_on(poly_sub(poly_constant(bound), sum), low, high, CLOSED);
        agree(T, sign == SIGN_POSITIVE || sign == SIGN_NONNEGATIVE);
        for (int unit = 0; unit <= n; unit++) {
            for (int i = 0; i <= n; i++)
                f[i] = from_int(i == unit);
            poly right = poly_constant(from_int(0));
            for (int j = 0; j <= n - 2; j++)
                right = poly_add(right, poly_scale(a[j], G(difference)(1, f, 0, j, 2)));
            /* p = b_m (m+1 - nt) + b_{m+1} (nt - m) */
            num line[] = {sub(mul(f[m], from_int(m + 1)), mul(f[m + 1], from_int(m))),
                          mul(from_int(n), sub(f[m + 1], f[m]))};
            poly gap = poly_sub(poly_from_bernstein(n, f), poly_from_q(2, line));
            agree(T, poly_equal(gap, right));
        }
    }
}
#endif

/*
Split at $\frac12$, $k$ times: the second differences of each of the $2^k$ parts are at most $4^{-k}$ times the largest of the
first polygon, and so are the distances of curve and polygons, up to the factor of the last claim.  They converge uniformly.
*/
#include "chapters/judge/claims_off.h"
