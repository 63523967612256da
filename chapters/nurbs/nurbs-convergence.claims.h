/*
# The polygons converge (离散曲线收敛到 NURBS 曲线)

Insert more and more knots: do the polygons tend to the curve?  They do if the knots become dense, the ends of the polygon are those
of the curve and the curve does not jump, and then with the square of the largest gap; an explicit bound is proved here.
*/
#include "chapters/nurbs/definition.h"
#include "chapters/nurbs/discrete.h"

#include "exact/record/sign.h"

#include "chapters/judge/claims_on.h"

/*
:::{statement} wang-ch4:cor-4.1.1
:title: There is a growing sequence of knots for which the polygons converge to the curve
:zh: 推论 4.1.1:存在递增节点集序列使多边形收敛到曲线
:printed: There is a sequence of sets of knots $\{T_m'\}$, $T_m'\subseteq T_{m+1}'$, $m=1,2,\dots$, with
  $\lim_{m\to\infty}\Gamma_k^{(T)}(T_m')=r_k(t)$ (4.1.10)
:holds-by: greville_abscissae_are_the_identity basis_is_a_partition_of_unity greville_defect_is_a_variance
  gaps_bound_the_defect second_differences_are_averaged quotient_is_near_if_the_spline_is
:hypothesis: simple_start_keeps_the_first_vertex | $t_2=t_k$: so the polygon begins with the curve; otherwise $r_1$ may keep its distance, and where $t_1<t_{k+1}$ it is a
  vertex of every polygon, whatever is inserted, as of the $\alpha_{i,k}(1)$ only $\alpha_{1,k}(1)$ is not $0$
:hypothesis: idle_start_keeps_the_first_vertex | $t_k<t_{k+1}$: otherwise $r_1$, which then has no share in the curve, may keep its distance, too
:hypothesis: simple_end_keeps_the_last_vertex | the knots $t_{n+1},\dots,t_{n+k-1}$ are equal: so the polygon ends with the curve; otherwise $r_n$ may keep its distance, and where $t_n<t_{n+k}$ it is a
  vertex of every polygon, as of the $\alpha_{i,k}(j)$ of the last point $j$ only $\alpha_{n,k}(j)$ is not $0$
:hypothesis: idle_end_keeps_the_last_vertex | the interval $[t_n,t_{n+1})$ is not empty: otherwise $r_n$, which then has no share in the curve, may keep its distance, too
:hypothesis: polygons_keep_the_edge_over_a_jump | no knot inside the domain is $k$-fold or more, or the points there coincide: otherwise every
  polygon, whatever is inserted, keeps the edge over which the curve jumps
:needs: negative_weight_makes_a_pole | definition 4.1.1: $w_i>0$ | the weights are positive
:meant: definition 4.1.1, which says what the polygon is | The whole polygon, so that its ends count, too.
:reading: first_vertex_stays_off_the_curve | the whole polygon, over any knots
:reading: polygon_is_within_the_bound_of_the_spline | the part of the polygon over the domain, over knots that are at most $(k-2)$-fold inside: it is near
  the spline, with a bound by the points of $f''$
:argued: | A function with a convex polygon lies above it, by Jensen's inequality; so the distance of a spline from its polygon is at most
  that of the parabola with the second derivative $M$.  By the identities that is at most $\frac k{24}h^2M$, the same $M$ serves for
  all refinements.  Let $T_m'$ be the knots that halve every gap $m$ times: they are nested, and $h_m\to0$.  At a $(k-1)$-fold knot, and at one of more where the points coincide, the polygon
  passes through the curve, and either side is treated alone.  The knots inserted before $t_2$ or behind $t_{n+k-1}$ only repeat $r_1$ and $r_n$.
:figure: nurbs_polygons_converge
:striking: 42

For $k=2$ there is nothing to be decided: under these hypotheses the curve is its polygon, and with knots inserted inside the domain every refined polygon is the same polyline.
:::

:::{statement} wang-ch4:remark-4.1.1-convergence
:title: Discrete rational B-spline curves must converge to the NURBS curve
:zh: 有理离散 B 样条曲线必收敛到 NURBS 曲线
:printed: We can also infer that rational discrete B-spline curves necessarily converge to the NURBS curve
:holds-by: greville_abscissae_are_the_identity basis_is_a_partition_of_unity greville_defect_is_a_variance
  gaps_bound_the_defect second_differences_are_averaged quotient_is_near_if_the_spline_is
:needs: negative_weight_makes_a_pole | definition 4.1.1: $w_i>0$ | the weights are positive
:hypothesis: knot_at_an_outer_end_has_no_shares | the knots of the $T_m'$ are in $(t_1,t_{n+k})$, or at $t_1$ where $t_1=t_k$: for (4.1.6)
:hypothesis: knots_on_one_side_do_not_converge | the knots become dense in the domain, the largest gap $h_m\to0$
:hypothesis: simple_start_keeps_the_first_vertex | $t_2=t_k$: so the polygon begins with the curve
:hypothesis: idle_start_keeps_the_first_vertex | $t_k<t_{k+1}$: so $r_1$ has a share in the curve
:hypothesis: simple_end_keeps_the_last_vertex | the knots $t_{n+1},\dots,t_{n+k-1}$ are equal: so the polygon ends with the curve
:hypothesis: idle_end_keeps_the_last_vertex | the interval $[t_n,t_{n+1})$ is not empty: so $r_n$ has a share in the curve
:hypothesis: polygons_keep_the_edge_over_a_jump | no knot inside the domain is $k$-fold or more, or the points there coincide
:meant: definition 4.1.1, which says what the polygon is, and section 2.10 | The whole polygon, so that its ends count, too; the $\alpha$ of (4.1.6) with intervals
  closed on the left, see `formula-4.1.6`.
:reading: first_vertex_stays_off_the_curve | the whole polygon, over any knots
:reading: polygon_is_within_the_bound_of_the_spline | the part of the polygon over the domain, over knots that are at most $(k-2)$-fold inside: it is near
  the spline, with a bound by the points of $f''$
:argued: | A function with a convex polygon lies above it, by Jensen's inequality; so the distance of a spline from its polygon is at most
  that of the parabola with the second derivative $M$.  By the identities that is at most $\frac k{24}h^2M$, the same $M$ serves for
  all refinements, and $h_m\to0$.  At a $(k-1)$-fold knot, and at one of more where the points coincide, the polygon passes through the curve, and either
  side is treated alone.  Knots inserted before $t_2$ or behind $t_{n+k-1}$ only repeat $r_1$ and $r_n$.
:figure: no_convergence
:::

## One vertex (单个顶点)

A vertex is a value of the polar form, $d_j=f[x_1,\dots,x_p]$, where $p=k-1$ and $x_1\le\dots\le x_p$ are the knots between its ends.
It belongs over the Greville abscissa $\xi_j=\frac1p(x_1+\dots+x_p)$, and the polygon as a function, $d(\xi_j)=d_j$ and linear between, is
to be compared with $f$.  For straight lines both agree.  For a parabola the defect is a variance.
*/

/* The sum of the squares of all differences of p numbers. */
static num G(squares_of_differences)(int p, const num x[])
{
    num sum = from_int(0);
    for (int j = 1; j < p; j++)
        for (int i = 0; i < j; i++) {
            num gap = sub(x[j], x[i]);
            sum = add(sum, mul(gap, gap));
        }
    return sum;
}

/*
:::{claim} greville_defect_is_a_variance
:title: The vertex of a parabola lies below it by the variance of its knots
:zh: 抛物线的顶点偏差为节点的方差
:given: $p\ge2$ knots $x_1,\dots,x_p$, variables; $f(t)=\frac12t^2$ and $f(t)=t$
:let: $\xi$ their mean
:then: for $f=\frac12t^2$: $\;f(\xi)-f[x_1,\dots,x_p]=\frac1{2p(p-1)}\sum_i(x_i-\xi)^2=\frac1{2p^2(p-1)}\sum_{i<j}(x_i-x_j)^2$; for $f=t$
  the difference is $0$
:method: The polar form by the kernel, of the segment over $[0,1]$ with Bézier points, here in degree $p$ for both functions.
:degrees: 2..6 sampled 9
:control: $p^2$ in the place of $p(p-1)$
:::
*/
CLAIM(greville_defect_is_a_variance)
{
    int p = T->degree;
    num x[MAX_DEGREE], line[MAX_DEGREE + 1], parabola[MAX_DEGREE + 1], value, mean = from_int(0), spread = from_int(0);
    for (int i = 0; i < p; i++) {
        x[i] = unknown(T, "x", i);
        mean = add(mean, div(x[i], from_int(p)));
    }
    for (int i = 0; i < p; i++) {
        num gap = sub(x[i], mean);
        spread = add(spread, mul(gap, gap));
    }
    for (int i = 0; i <= p; i++) { /* the Bézier points of t and of t^2/2 */
        line[i] = from_ratio(i, p);
        parabola[i] = from_ratio(i * (i - 1), 2 * p * (p - 1));
    }
    about(T, "the line");
    G(bezier_blossom)(p, 1, line, x, &value);
    same(T, value, mean);
    about(T, "the parabola");
    G(bezier_blossom)(p, 1, parabola, x, &value);
    num defect = sub(div(mul(mean, mean), from_int(2)), value);
    same(T, defect, div(spread, from_int(fault(T, 2 * p * (p - 1), 2 * p * p))));
    same(T, defect, div(G(squares_of_differences)(p, x), from_int(2 * p * p * (p - 1))));
}

/*
A variance of $p$ numbers that lie close together is small. The largest that gaps of at most $h$ allow is that of equal gaps,
since every difference $|x_i-x_j|$ is then as large as it can be; and for equal gaps the sum of the squares is a polynomial in
$p$.

:::{claim} gaps_bound_the_defect
:title: With gaps at most h the defect is at most (k/24) h²
:zh: 节点间距不超过 h 时偏差不超过 k h²/24
:given: $p\ge2$, a variable; and $p$ knots $x_1\le\dots\le x_p$ with gaps $g_i=h-e_i$, $0\le e_i\le h$
:let: $V_p=\sum_{i<j}(i-j)^2$
:then: $V_p=\frac{p^2(p^2-1)}{12}$ for every $p$, so that for equal gaps $h$ the defect $\frac{V_ph^2}{2p^2(p-1)}$ is $\frac{p+1}{24}h^2$; with smaller gaps
  it is not larger
:method: $V_1=0$ and $V_{p+1}-V_p=\sum_{d=1}^pd^2=\frac{p(p+1)(2p+1)}6$: induction on $p$, an identity in $p$.  For the gaps
  $|x_i-x_j|\le|i-j|\,h$ term by term, $p\le7$: signs are read off coefficients.
:degrees: all
:argued: smaller gaps in every degree | $|x_i-x_j|\le|i-j|h$ term by term
:over: p h: -; s#: gaps within the bound
:control: $p^2-1$ replaced by $p^2+1$
:::
*/
CLAIM(gaps_bound_the_defect)
{
    num p = whole(T, "p", 2, 60), one = from_int(1), six = from_int(6), twelve = from_int(12);
    num next = add(p, one), shift = fault(T, neg(one), one);
    /* V_p = p² (p² - 1)/12, and V_{p+1} - V_p = p (p+1) (2p+1)/6 */
    num V = div(mul(mul(p, p), add(mul(p, p), shift)), twelve);
    num W = div(mul(mul(next, next), add(mul(next, next), shift)), twelve);
    about(T, "from p to p+1");
    same(T, sub(W, V), div(mul(mul(p, next), add(add(p, p), one)), six));
    about(T, "the defect for gaps h"); /* V_p h² / (2 p² (p-1)) = (p+1)/24 h² */
    num h = positive(T, "h", 0);
    same(T, div(mul(V, mul(h, h)), mul(add(p, p), mul(p, sub(p, one)))), div(mul(next, mul(h, h)), from_int(24)));
    for (int points = 2; points <= 7; points++) {
        num x[7], y[7];
        x[0] = y[0] = from_int(0);
        for (int i = 1; i < points; i++) { /* the gap h s/(1+s), smaller than h */
            num s = positive(T, "s", i);
            x[i] = add(x[i - 1], mul(h, div(s, add(s, one))));
            y[i] = add(y[i - 1], h);
        }
        about(T, "smaller gaps, term by term");
        for (int j = 1; j < points; j++)
            for (int i = 0; i < j; i++) {
                num small = sub(x[j], x[i]), large = sub(y[j], y[i]);
                nonnegative(T, sub(mul(large, large), mul(small, small)));
            }
        num equal = div(G(squares_of_differences)(points, y), mul(h, h));
        about(T, "the sum for equal gaps");
        same(T, equal, from_ratio(points * points * (points * points - 1), 12));
    }
}

/*
## Any spline (任意样条)

A polygon with nonnegative second differences is convex, and a spline lies above its convex polygon: $f(t)=\sum N_i(t)\,d(\xi_i)\ge
d(\sum N_i(t)\,\xi_i)=d(t)$, by Jensen's inequality, as $\sum N_i\xi_i=t$.  So if the points $c_i''$ of $f''$ are at most $M$ in absolute
value, then $\frac M2t^2\pm f$ lie above their polygons, and

$$|f(t)-d(t)|\ \le\ M\max_j\frac1{2p(p-1)}\sum_i(x_{j,i}-\xi_j)^2\ \le\ \frac{k}{24}\,h^2M .$$

The bound is attained by the parabola with equal gaps: the order is two, exactly.
*/

#if RATIONAL
/* The polynomial that the spline with points c is on a span. */
static poly G(segment)(int p, const num u[], int mu, const num c[])
{
    num b[MAX_DEGREE + 1], local[] = {neg(u[mu]), from_int(1)};
    G(bspline_to_bezier)(G(on_span)(p, 1, u, mu, c), b);
    poly s = poly_scale(poly_from_q(2, local), div(from_int(1), sub(u[mu + 1], u[mu])));
    return poly_compose(poly_from_bernstein(p, b), s);
}

/*
:::{claim} polygon_is_within_the_bound_of_the_spline
:title: The distance of a spline from its polygon, with the exact constant
:zh: 样条与其控制多边形的距离
:given: a spline $f$ of degree $p=k-1$ with any points, over patterns of knots of multiplicity at most $k-2$ inside, with increasing random values; $x_{j,1},\dots,x_{j,p}$ the knots
  between the ends of $N_j$, $\xi_j$ their mean; $d(t)$ the polygon as a function, point $j$ over $\xi_j$
:where: the knots inside are at most $(k-2)$-fold
:harmless: increasing random values | knots increase
:let: $c''$ the points of $f''$, $\delta_j=\frac1{2p(p-1)}\sum_i(x_{j,i}-\xi_j)^2$
:then: $\sum_iN_i\xi_i=t$; and $f-d=\sum_ib_i\,c_i''$ with $b_i\ge0$ on the domain and $\sum_ib_i=\frac{t^2}2-d_{t^2/2}$, which is at most
  $\max_j\delta_j$; hence $|f-d|\le\max|c_i''|\max_j\delta_j$
:method: Instances.  The equality is linear in the points: $b_i$ is
  $f-d$ for the spline with $c_i''=1$ and all others 0.  On every interval between neighbouring knots and Greville abscissae both are
  polynomials; the inequalities are decided by their signs on the closed interval.
:types: rational
:degrees: 2..5
:control: $\delta_j$ halved
:::
*/
/* f - d between the Greville abscissae of c_i and c_{i+1}, where d is the line through the two. */
static poly G(minus_chord)(poly f, const num xi[], const num c[], int i)
{
    num slope = div(sub(c[i + 1], c[i]), sub(xi[i + 1], xi[i]));
    num line[] = {sub(c[i], mul(slope, xi[i])), slope};
    return poly_sub(f, poly_from_q(2, line));
}

/* The points of the spline with the second derivative e_0, ..., e_{n-3}: e_i = (p-1)(g_{i+1} - g_i)/(u_{i+p+1} - u_{i+2}),
 * g_i = p (c_{i+1} - c_i)/(u_{i+p+1} - u_{i+1}); c_0 = g_0 = 0. */
static void G(integrated_twice)(int n, int p, const num u[], const num e[], num c[])
{
    num g[MOST_KNOTS];
    g[0] = c[0] = from_int(0);
    for (int i = 0; i < n - 2; i++)
        g[i + 1] = add(g[i], div(mul(e[i], sub(u[i + p + 1], u[i + 2])), from_int(p - 1)));
    for (int i = 0; i < n - 1; i++)
        c[i + 1] = add(c[i], div(mul(g[i], sub(u[i + p + 1], u[i + 1])), from_int(p)));
}

CLAIM(polygon_is_within_the_bound_of_the_spline)
{
    static const char *const kinds[][3] = {
        {"31113", "211112", NULL}, {"41214", "3113", NULL}, {"51315", "411124", NULL}, {"61416", NULL}};
    int p = T->degree, place[MOST_KNOTS];
    num x[MOST_KNOTS], u[MOST_KNOTS], xi[MOST_KNOTS], e[MOST_KNOTS], c[MOST_KNOTS], parabola[MOST_KNOTS];
    for (int k = 0; kinds[p - 2][k] != NULL; k++) {
        G(increasing_knots)(T, (int)strlen(kinds[p - 2][k]), 6, x);
        int count = G(knots_at)(kinds[p - 2][k], x, u, place), n = count - p - 1;
        num largest = from_int(0);
        for (int i = 0; i < n; i++) {
            num spread = from_int(0);
            xi[i] = G(bspline_greville)(p, u, i);
            for (int l = 1; l <= p; l++)
                spread = add(spread, mul(sub(u[i + l], xi[i]), sub(u[i + l], xi[i])));
            spread = div(spread, from_int(fault(T, 2, 4) * p * (p - 1)));
            largest = sign_q(sub(spread, largest)) > 0 ? spread : largest;
            e[i] = from_int(1);
        }
        G(integrated_twice)(n, p, u, e, parabola);
        for (int mu = p; mu < n; mu++) {
            if (place[mu] == place[mu + 1])
                continue;
            poly whole_defect = G(segment)(p, u, mu, parabola);
            about(T, "sum of N_i xi_i = t");
            agree(T, poly_equal(G(segment)(p, u, mu, xi), poly_variable()));
            for (int i = 0; i + 1 < n; i++) { /* the part of the span between two Greville abscissae */
                num low = sign_q(sub(u[mu], xi[i])) > 0 ? u[mu] : xi[i];
                num high = sign_q(sub(u[mu + 1], xi[i + 1])) < 0 ? u[mu + 1] : xi[i + 1];
                if (sign_q(sub(high, low)) <= 0)
                    continue;
                poly all = G(minus_chord)(whole_defect, xi, parabola, i), sum = poly_constant(from_int(0));
                for (int unit = 0; unit < n - 2; unit++) {
                    for (int l = 0; l < n - 2; l++)
                        e[l] = from_int(l == unit);
                    G(integrated_twice)(n, p, u, e, c);
                    poly b = G(minus_chord)(G(segment)(p, u, mu, c), xi, c, i);
                    about(T, "b_i >= 0");
                    agree(T, is_nonnegative_on(b, low, high));
                    sum = poly_add(sum, b);
                }
                about(T, "the sum of the b_i");
                agree(T, poly_equal(sum, all));
                about(T, "the bound");
                agree(T, is_nonnegative_on(poly_sub(poly_constant(largest), all), low, high));
            }
        }
    }
}
#endif

/*
The bound has the points of the second derivative in it, and these change with every knot. If they grew, nothing would be gained.
But they are the points of a spline themselves, and insertion makes means of them; so the $M$ of the first polygon serves for all.

:::{claim} second_differences_are_averaged
:title: Inserting a knot averages the points of the second derivative
:zh: 嵌入节点使二阶导数的控制点作凸组合
:given: a spline $f$ of degree $p=k-1$, positive gaps of the knots, points $c_i$; simple knots, or ends of multiplicity $k$ and a knot between of any multiplicity $m=1,\dots,k-2$; one knot put into an
  interval of the domain, or for $m<k-2$ the knot between once more
:then: the points of $f''$ after the insertion are those that the insertion into the spline $f''$ of degree $p-2$ gives: each is
  $(1-a)c_{i-1}''+a\,c_i''$ with $0\le a\le1$; so $\max|c_i''|$ does not grow
:method: The kernels for differences and insertion, in both orders; the coefficients by their signs.
:degrees: 2..6 sampled 8
:scope: one knot put into simple knots, or into clamped ones with a knot of every multiplicity below k-1 between
:over: s: ratio in which the new knot divides its interval
:control: the difference taken once only after the insertion, with the spline $f'$
:::
*/
/* The points of f'' by both ways; the new knot is knot mu, if it is not inside the interval that begins with it. */
static void G(compare_second_differences)(trial *T, int n, const num u[], int mu, int inner)
{
    int p = T->degree;
    num c[MOST_KNOTS], v[MOST_KNOTS], d[MOST_KNOTS], e[MOST_KNOTS], after[MOST_KNOTS];
    num before[MOST_KNOTS], y[MOST_KNOTS], inserted[MOST_KNOTS], one = from_int(1), knot = u[mu];
    for (int i = 0; i < n; i++)
        c[i] = unknown(T, "c", i);
    if (inner)
        knot = add(knot, mul(sub(u[mu + 1], u[mu]), inside(T, "s")));
    G(bspline_insert)(spline(p, n, 1, u, c), mu, knot, v, d);
    G(bspline_difference)(n + 1, p, 1, v, d, e);
    G(bspline_difference)(n, p - 1, 1, v + 1, e, after);
    G(bspline_difference)(n, p, 1, u, c, e);
    G(bspline_difference)(n - 1, p - 1, 1, u + 1, e, before);
    for (int i = 0; i < n - 2; i++)
        before[i] = fault(T, before[i], e[i]);
    G(bspline_insert)(spline(p - 2, n - 2, 1, u + 2, before), mu - 2, knot, y, inserted);
    for (int i = 0; i < n - 1; i++) {
        about(T, "the points of the second derivative");
        same(T, after[i], inserted[i]);
        if (mu - 2 - (p - 2) < i && i <= mu - 2) {
            num a = div(sub(knot, u[i + 2]), sub(u[i + p], u[i + 2]));
            about(T, "a mean");
            nonnegative(T, a);
            nonnegative(T, sub(one, a));
            same(T, after[i], add(mul(sub(one, a), before[i - 1]), mul(a, before[i])));
        }
    }
}

CLAIM(second_differences_are_averaged)
{
    int p = T->degree, place[MOST_KNOTS];
    num x[MOST_KNOTS], u[MOST_KNOTS];
    G(increasing_knots)(T, 2 * p + 3, 6, u);
    G(compare_second_differences)(T, p + 2, u, p, 1);
    G(increasing_knots)(T, 3, 6, x);
    for (int m = 1; m < p; m++) {
        const char pattern[] = {(char)('1' + p), (char)('0' + m), (char)('1' + p), '\0'};
        (void)G(knots_at)(pattern, x, u, place);
        G(compare_second_differences)(T, p + 1 + m, u, p, 1);
        G(compare_second_differences)(T, p + 1 + m, u, p + m, 1);
        if (m < p - 1)
            G(compare_second_differences)(T, p + 1 + m, u, p + m, 0);
    }
}

/*
:::{claim} halving_the_gaps_divides_the_bound_by_four
:title: The parabola with equal gaps attains the bound at every step of halving
:zh: 抛物线达到上界,误差每次减为四分之一
:given: $f=\frac12t^2$, equal gaps $h$, then $\frac h2$, both variable; a vertex $d_j$ with simple knots, $\xi_j$ their mean; order $k$
:then: $f(\xi_j)-d_j=\frac k{24}h^2$, and with the gaps halved a quarter of it: the order of convergence is 2 and not higher
:method: The polar form by the kernel.
:degrees: 2..6 sampled 9
:over: h: gap; x: -
:control: one half for a quarter
:::
*/
CLAIM(halving_the_gaps_divides_the_bound_by_four)
{
    int p = T->degree;
    num h = positive(T, "h", 0), x0 = unknown(T, "x", 0), defect[2], parabola[MAX_DEGREE + 1];
    for (int i = 0; i <= p; i++)
        parabola[i] = from_ratio(i * (i - 1), 2 * p * (p - 1));
    for (int step = 0; step < 2; step++) {
        num x[MAX_DEGREE], mean = from_int(0), value, gap = step == 0 ? h : div(h, from_int(2));
        for (int i = 0; i < p; i++) {
            x[i] = add(x0, mul(from_int(i), gap));
            mean = add(mean, div(x[i], from_int(p)));
        }
        G(bezier_blossom)(p, 1, parabola, x, &value);
        defect[step] = sub(div(mul(mean, mean), from_int(2)), value);
    }
    same(T, defect[0], mul(from_ratio(p + 1, 24), mul(h, h)));
    same(T, defect[1], div(defect[0], from_int(fault(T, 4, 2))));
}

/*
The rational curve is a central projection, and a projection may stretch distances. By how much depends on the least weight:
numerator and denominator of the polygon both are near those of the curve, and the denominator stays away from $0$.

:::{claim} quotient_is_near_if_the_spline_is
:title: The distance of a rational curve from its polygon
:zh: 有理曲线与其多边形的距离
:given: $X$ and $w$ at $t$ for the curve; $X-E$ and $w-e$ for the polygon in homogeneous coordinates
:let: $M_X$, $M_w$ the largest absolute values of the points of $X''$ and of $w''$, $h$ the largest gap of the knots; $r=\frac Xw$, $\rho=\frac{X-E}{w-e}$, a point of the polygon in space
:then: $r-\rho=\frac{E-\rho\,e}w$; with $|E|\le\frac k{24}h^2M_X$, $|e|\le\frac k{24}h^2M_w$ and $w\ge\min w_i$ the distance is at most
  $\frac k{24}h^2\,(M_X+\max|r_i|M_w)/\min w_i$
:method: An identity of the four variables.  The projection maps the segments of the homogeneous polygon onto those of the polygon, whose
  points are means of its vertices.
:over: X# E#: points; w# e#: weights
:control: $r$ in the place of $\rho$ on the right
:::
*/
CLAIM(quotient_is_near_if_the_spline_is)
{
    num X = unknown(T, "X", 0), w = positive(T, "w", 0), E = unknown(T, "E", 0), e = unknown(T, "e", 0);
    num r = div(X, w), rho = div(sub(X, E), sub(w, e));
    same(T, sub(r, rho), div(sub(E, mul(fault(T, rho, r), e)), w)); /* r - ρ = (E - ρ e)/w */
}

/*
## What goes wrong (反例)
*/

#if RATIONAL
/* The refinement of the knots u, `count` of them, that halves every gap m times. */
static void G(halve_gaps)(int p, int count, const num u[], int m, struct G(refinement) * r)
{
    num added[MOST_KNOTS];
    int more = 0, parts = 1 << m;
    for (int i = 0; i + 1 < count; i++)
        for (int l = 1; l < parts && !equal_q(u[i], u[i + 1]); l++)
            added[more++] = add(u[i], mul(from_ratio(l, parts), sub(u[i + 1], u[i])));
    G(refine_knots)(p, count, u, more, added, r);
}

/*
Each of the hypotheses is now left out in turn: that the polygon begins and ends with the curve, that the knots become
dense, and that the curve does not jump. In all of them the polygon keeps a vertex or an edge for good, however many knots are
inserted.

:::{claim} first_vertex_stays_off_the_curve
:title: Over simple knots the first vertex of every polygon stays where it is
:zh: 单节点时首顶点始终不动
:kind: counterexample
:given: a quadratic segment of the points $r$ and weights $w$ over the simple knots $T$; $T_m'$ halves every gap $m$ times, $m=1,\dots,M$
:data: T = -2 -1 0 1 2 3; r = (0,0) (1,2) (2,0); w = 1 1 1; M = 3
:instead: T = -2 0 0 1 1 3
:then: the first vertex is $r_1$ for each of these $m$, while the curve, in the hull of its Bézier points $b$, is to the right of $b_0$
:result: b = (1/2,1) (1,2) (3/2,1); the first vertex = (0,0)
:method: (4.1.6) by its letter.  If the polygons tended to
  the curve, their first vertices would come near it.  For every $T'$: of the $\alpha_{i,k}(1)$ only $\alpha_{1,k}(1)$ is not $0$,
  as only $N_{1,k}$ begins in $t_1$, so that $r_1$ stays.
:control: twofold knots at the ends of the domain
:::
*/
CLAIM(first_vertex_stays_off_the_curve)
{
    enum { p = 2, n = 3, count = n + p + 1, dim = 2 };
    num u[count], R[n * dim], w[n], bezier[n * dim], S[dim], z[1];
    given_points(T, "T", count, 1, u);
    given_points(T, "r", n, dim, R);
    given_points(T, "w", n, 1, w);
    int most = given_whole(T, "M"), near = 0;
    G(bspline_to_bezier)(G(on_span)(p, dim, u, p, R), bezier);
    for (int m = 1; m <= most; m++) {
        struct G(refinement) r;
        G(halve_gaps)(p, count, u, m, &r);
        G(refined_by_definition)(n, p, dim, r.u, r.place, R, w, 1, r.v, r.at, S, z);
        near += sign_q(sub(S[0], bezier[0])) >= 0;
    }
    found_points(T, "b", n, dim, bezier);
    found_points(T, "the first vertex", 1, dim, S);
    about(T, "whether the first vertex is not left of the curve, for one of the refinements");
    agree(T, near > 0);
}

/*
One end that is not that of the curve is enough, whatever the other is.

:::{claim} simple_start_keeps_the_first_vertex
:title: Where the domain begins with a simple knot the first vertex of every polygon stays where it is
:zh: 左端为单节点时首顶点始终不动
:kind: counterexample
:given: a quadratic segment of the points $r$ and weights $w$ over the knots $T$, with $t_2<t_3$ and $t_4=t_5$, so that the polygon ends with the
  curve; $T_m'$ halves every gap $m$ times, $m=1,\dots,M$
:data: T = -2 -1 0 1 1 3; r = (0,0) (1,2) (2,0); w = 1 1 1; M = 3
:instead: T = -2 0 0 1 1 3
:then: the first vertex is $r_1$ for each of these $m$, while the curve, in the hull of its Bézier points $b$, is not to the left of $b_0$
:result: b = (1/2,1) (1,2) (2,0); the vertex = (0,0)
:method: (4.1.6) by its letter.  For every $T'$: of the $\alpha_{i,k}(1)$ only $\alpha_{1,k}(1)$ is not $0$.
:control: a twofold knot at the beginning of the domain, too
:::
*/
/* Whether the first or the last vertex of one of the refinements is not outside the strip of the Bézier points of the first or the
 * last segment of the given curve of n points. */
static int G(end_vertex_comes_near)(trial *T, int n, int last)
{
    enum { p = 2, dim = 2 };
    num u[MOST_KNOTS], R[dim * MOST_KNOTS], w[MOST_KNOTS], bezier[dim * (p + 1)], S[dim * MOST_KNOTS], z[MOST_KNOTS];
    const num *vertex = S;
    int count = n + p + 1, mu = last ? n - 1 : p;
    given_points(T, "T", count, 1, u);
    given_points(T, "r", n, dim, R);
    given_points(T, "w", n, 1, w);
    int most = given_whole(T, "M"), near = 0;
    while (equal_q(u[mu], u[mu + 1]))
        mu += last ? -1 : 1;
    G(bspline_to_bezier)(G(on_span)(p, dim, u, mu, R), bezier);
    for (int m = 1; m <= most; m++) {
        struct G(refinement) r;
        G(halve_gaps)(p, count, u, m, &r);
        G(refined_by_definition)(n, p, dim, r.u, r.place, R, w, r.m, r.v, r.at, S, z);
        vertex = S + (last ? dim * (r.m - 1) : 0);
        int side = sign_q(sub(vertex[0], bezier[last ? dim * p : 0]));
        near += last ? side <= 0 : side >= 0;
    }
    found_points(T, "b", p + 1, dim, bezier);
    found_points(T, "the vertex", 1, dim, vertex);
    about(T, last ? "whether the last vertex is not right of the curve, for one of the refinements"
                  : "whether the first vertex is not left of the curve, for one of the refinements");
    return near > 0;
}

CLAIM(simple_start_keeps_the_first_vertex) { agree(T, G(end_vertex_comes_near)(T, 3, 0)); }

/*
:::{claim} simple_end_keeps_the_last_vertex
:title: Where the domain ends with a simple knot the last vertex of every polygon stays where it is
:zh: 右端为单节点时末顶点始终不动
:kind: counterexample
:given: a quadratic segment of the points $r$ and weights $w$ over the knots $T$, with $t_2=t_3$ and $t_4<t_5$, so that the polygon begins with the
  curve; $T_m'$ halves every gap $m$ times, $m=1,\dots,M$
:data: T = -2 0 0 1 2 3; r = (0,0) (1,2) (2,0); w = 1 1 1; M = 3
:instead: T = -2 0 0 1 1 3
:then: the last vertex is $r_3$ for each of these $m$, while the curve, in the hull of its Bézier points $b$, is not to the right of $b_2$
:result: b = (0,0) (1,2) (3/2,1); the vertex = (2,0)
:method: (4.1.6) by its letter.  For every $T'$: of the $\alpha_{i,k}(j)$ of the last point only $\alpha_{n,k}(j)$ is not $0$.
:control: a twofold knot at the end of the domain, too
:::
*/
CLAIM(simple_end_keeps_the_last_vertex) { agree(T, G(end_vertex_comes_near)(T, 3, 1)); }

/*
A point without a share in the curve is a vertex all the same.

:::{claim} idle_start_keeps_the_first_vertex
:title: Where the knot at which the domain begins is repeated inside, the first vertex may stay off the curve
:zh: 左端节点在域内重复时首顶点可始终不动
:kind: counterexample
:given: a quadratic segment of the points $r$ and weights $w$ over the knots $T$, with $t_2=t_3=t_4$, whose domain is $[t_3,t_5]$ and whose polygon is convex and ends with
  the curve; $T_m'$ halves every gap $m$ times, $m=1,\dots,M$
:data: T = -1 0 0 0 1 1 1; r = (-1,-3) (0,0) (1,2) (2,0); w = 1 1 1 1; M = 3
:instead: T = -1 0 0 1/2 1 1 1
:then: the first vertex is $r_1$ for each of these $m$, while the curve, in the hull of its Bézier points $b$, is not to the left of $b_0$
:result: b = (0,0) (1,2) (2,0); the vertex = (-1,-3)
:method: (4.1.6) by its letter.
:control: the last of the three equal knots moved to the right
:::
*/
CLAIM(idle_start_keeps_the_first_vertex) { agree(T, G(end_vertex_comes_near)(T, 4, 0)); }

/*
:::{claim} idle_end_keeps_the_last_vertex
:title: Where the knot at which the domain ends is repeated inside, the last vertex may stay off the curve
:zh: 右端节点在域内重复时末顶点可始终不动
:kind: counterexample
:given: a quadratic segment of the points $r$ and weights $w$ over the knots $T$, with $t_4=t_5=t_6$, whose domain is $[t_3,t_5]$ and whose polygon is convex and begins with
  the curve; $T_m'$ halves every gap $m$ times, $m=1,\dots,M$
:data: T = 0 0 0 1 1 1 2; r = (0,0) (1,2) (2,0) (3,-3); w = 1 1 1 1; M = 3
:instead: T = 0 0 0 1/2 1 1 2
:then: the last vertex is $r_4$ for each of these $m$, while the curve, in the hull of its Bézier points $b$, is not to the right of $b_2$
:result: b = (0,0) (1,2) (2,0); the vertex = (3,-3)
:method: (4.1.6) by its letter.
:control: the first of the three equal knots moved to the left
:::
*/
CLAIM(idle_end_keeps_the_last_vertex) { agree(T, G(end_vertex_comes_near)(T, 4, 1)); }

/*
:::{claim} knots_on_one_side_do_not_converge
:title: Knots that stay on one side leave the other corner as it is
:zh: 节点只在一侧加密时另一侧的角不变
:kind: counterexample
:given: a quadratic curve of two segments, of the points $r$ and weights $w$ over the knots $T$; knots $T'$ that all are in the first; numbers
  $c<d$
:data: T = 0 0 0 1 2 2 2; r = (0,0) (0,2) (2,2) (2,0); w = 1 1 1 1; T' = 1/8 1/4 3/8 1/2 5/8 3/4 7/8; c = 10/3; d = 11/3
:instead: T' = 1/4 1/2 3/4 9/8 5/4 3/2 7/4
:then: the vertex $r_3$ stays, the last but one of the new polygon $r'$, and has $x+y>d$, while the whole curve has $x+y\le c$
:result: r' = (0,0) (0,1/4) (1/32,11/16) (3/32,17/16) (3/16,11/8) (5/16,13/8) (15/32,29/16) (21/32,31/16) (7/8,2) (2,2) (2,0)
:method: The insertions by the kernel; the inequality on the curve by the signs of its two segments.  A vertex with $x+y>d$ is not
  near the curve.  No knot in the first interval changes $r_3=f[t_4,t_5]$.
:control: knots in both segments
:::
*/
CLAIM(knots_on_one_side_do_not_converge)
{
    enum { p = 2, n = 4, count = n + p + 1, more = 7, dim = 2 };
    num u[2][count + more], R[2][(n + more) * dim], w[2][n + more], added[more], sums[n];
    given_points(T, "T", count, 1, u[0]);
    given_points(T, "r", n, dim, R[0]);
    given_points(T, "w", n, 1, w[0]);
    given_points(T, "T'", more, 1, added);
    num most_on_the_curve = given(T, "c"), most = given(T, "d");
    for (int i = 0; i < n; i++)
        sums[i] = add(R[0][dim * i], R[0][dim * i + 1]);
    int below = 1, now = 0;
    for (int mu = p; mu < n; mu++) {
        poly room = poly_sub(poly_constant(most_on_the_curve), G(segment)(p, u[0], mu, sums));
        below &= is_nonnegative_on(room, u[0][mu], u[0][mu + 1]);
    }
    for (int i = 0; i < more; i++, now = 1 - now) {
        int next = 1 - now, mu = p;
        while (compare_q(u[now][mu + 1], added[i]) <= 0)
            mu++;
        G(nurbs_insert)(nurbs(p, n + i, dim, u[now], R[now], w[now]), mu, added[i], u[next], R[next], w[next]);
    }
    found_points(T, "r'", n + more, dim, R[now]);
    about(T, "the curve having x + y <= c, every vertex has x + y <= d");
    for (int i = 0; i < n + more; i++)
        refute(T, below && sign_q(sub(most, add(R[now][dim * i], R[now][dim * i + 1]))) < 0);
}

/*
:::{claim} polygons_keep_the_edge_over_a_jump
:title: Over a k-fold knot every polygon keeps the edge that joins the two parts of the curve
:zh: k 重节点处多边形始终保留连接两段的边
:kind: counterexample
:given: a quadratic curve of two segments, of the points $r$ and weights $w$ over the knots $T$, whose inner knot is threefold; $T_m'$ halves
  every gap $m$ times, $m=1,\dots,M$
:data: T = 0 0 0 1 1 1 2 2 2; r = (0,0) (1,-1) (2,0) (2,1) (1,2) (0,1); w = 1 1 1 1 1 1; M = 3
:instead: T = 0 0 0 1 1 3/2 2 2 2
:then: every $\Gamma_k^{(T)}(T_m')$ has the edge from $r_3$ to $r_4$, while the curve has $y\le0$ on the first segment and $y\ge1$ on
  the second: the middle of the edge, with $y$ halfway between, stays at a distance from it
:result: the first polygon = (0,0) (1/2,-1/2) (3/2,-1/2) (2,0) (2,1) (3/2,3/2) (1/2,3/2) (0,1)
:method: (4.1.6) by its letter; the curve lies in the hulls of its Bézier points.  For every $T'$: the last point that the knots up to
  the inner one have is $r_3$, the first of the others $r_4$; that knot inserted again repeats one of them.
:control: the last of the three equal knots moved to the right
:::
*/
CLAIM(polygons_keep_the_edge_over_a_jump)
{
    enum { p = 2, n = 6, count = n + p + 1, dim = 2 };
    num u[count], R[n * dim], w[n], b[(p + 1) * dim], S[dim * MOST_KNOTS], z[MOST_KNOTS], one = from_int(1);
    int place[count], apart = 1, kept = 0;
    G(given_knots)(T, "T", count, u, place);
    given_points(T, "r", n, dim, R);
    given_points(T, "w", n, 1, w);
    int most = given_whole(T, "M");
    for (int mu = p; mu < n; mu++)
        if (place[mu] < place[mu + 1]) {
            G(bspline_to_bezier)(G(on_span)(p, dim, u, mu, R), b);
            for (int i = 0; i <= p; i++)
                apart &= mu == p ? sign_q(b[dim * i + 1]) <= 0 : sign_q(sub(b[dim * i + 1], one)) >= 0;
        }
    for (int m = 1; m <= most; m++) {
        struct G(refinement) r;
        int edges = 0;
        G(halve_gaps)(p, count, u, m, &r);
        G(refined_by_definition)(n, p, dim, r.u, r.place, R, w, r.m, r.v, r.at, S, z);
        for (int j = 0; j + 1 < r.m; j++) {
            int is_edge = 1;
            for (int c = 0; c < 2 * dim; c++) /* r_3 and r_4 are points 2 and 3 */
                is_edge &= equal_q(S[j * dim + c], R[2 * dim + c]);
            edges += is_edge;
        }
        kept += edges == 1;
        if (m == 1)
            found_points(T, "the first polygon", r.m, dim, S);
    }
    about(T, "the curve having no point between y = 0 and y = 1, the edge from r_3 to r_4 goes away");
    refute(T, apart && kept >= most);
}
#endif

#include "chapters/judge/claims_off.h"
