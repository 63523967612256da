/*
# Total positivity and sign changes (全正性与变差缩减)

Let $0<t_0<t_1<\dots<t_m<1$.  In the matrix with the entries $B_j^n(t_i)$ every minor is positive.  That is the reason
why a Bernstein polynomial has no more roots in $(0,1)$ than its coefficients have changes of sign, and why a Bézier
curve crosses a line no more often than its polygon does.
*/
#include "chapters/bezier/definition.h"

#if RATIONAL
#include "exact/record/total_positivity.h"

#include "exact/record/crossings.h"
#include "exact/record/roots.h"
#include "exact/record/sturm.h"
#endif

#include "chapters/judge/claims_on.h"

/*
## The minors

The parameter $t=\frac s{1+s}$ runs through $(0,1)$ as $s$ runs through the positive numbers, in the same order, and
$(1+s)^nB_j^n(t)=\binom njs^j$.  Increasing parameters are written as partial sums of positive variables,
$s_i=x_0+\dots+x_i$: what is proved for all positive $x$ holds for all increasing parameters.

The largest of the minors comes first, because it has a closed form: it is Vandermonde's determinant in disguise, times binomial
coefficients.  At increasing parameters its sign can be read off.

:::{claim} bernstein_collocation_determinant
:title: The determinant of the values at n+1 parameters
:zh: 配置矩阵的行列式
:given: any $t_0,\dots,t_n$
:then: $\det\bigl(B_j^n(t_i)\bigr)_{i,j=0}^n=\prod_{j=0}^n\binom nj\ \prod_{i<k}(t_k-t_i)$
:method: The determinant of the kernel's values, without division, against the product, in variables $t_i$.  So values at
  $n+1$ different parameters determine the coefficients.
:degrees: 0..5 sampled 8
:over: t#: parameter values
:control: one binomial coefficient left out of the product
:::
*/
CLAIM(bernstein_collocation_determinant)
{
    int n = T->degree;
    num t[MAX_DEGREE + 1], M[MAX_ORDER * MAX_ORDER], product = from_int(1);
    for (int i = 0; i <= n; i++) {
        t[i] = unknown(T, "t", i);
        G(bernstein_basis)(n, t[i], M + i * (n + 1));
        if (fault(T, 1, i != 1))
            product = mul(product, G(choose)(n, i));
        for (int k = 0; k < i; k++)
            product = mul(product, sub(t[i], t[k]));
    }
    same(T, G(determinant)(n + 1, M), product);
}

#if FIELD || RATIONAL
/* count positive numbers in increasing order: the partial sums of positive variables. */
static void G(increasing)(trial *T, int count, num s[])
{
    for (int i = 0; i < count; i++)
        s[i] = i == 0 ? positive(T, "x", 0) : add(s[i - 1], positive(T, "x", i));
}
#endif

#if FIELD
/* The rows of values of all B_j^n at s/(1+s), each multiplied by (1+s)^n > 0: polynomials in s. */
static void G(scaled_values)(int n, num s, num row[])
{
    num one = from_int(1), scale = G(power)(add(one, s), n);
    G(bernstein_basis)(n, div(s, add(one, s)), row);
    for (int j = 0; j <= n; j++)
        row[j] = mul(scale, row[j]);
}

/*
:::{claim} bernstein_collocation_is_totally_positive
:title: Every minor of the values at increasing parameters is positive
:zh: Bernstein 配置矩阵的全正性
:given: parameters $0<t_0<\dots<t_m<1$, $t_i=\frac{s_i}{1+s_i}$, $s_i=x_0+\dots+x_i$, all $x_i>0$; any $m$
:then: every minor of $\bigl(B_j^n(t_i)\bigr)$ is positive
:method: A minor of order $k$ sees only $k$ of the parameters, and they are any $k$ increasing ones; so for every choice
  of $k$ columns one determinant, with $k$ variable parameters, stands for all choices of rows.  In the field it is a
  polynomial in the $x_i$ with positive coefficients only, after each row was multiplied by $(1+s_i)^n>0$.  In rationals
  the matrix of $n+2$ parameters goes through the elimination of `total_positivity.h`, which knows nothing of this.  By
  continuity no minor is negative when parameters coincide or reach $0$ and $1$.
:types: field rational
:degrees: 1..5 sampled 12
:scope: increasing parameter values in (0, 1)
:over: x#: -
:control: the first two parameters exchanged
:::
*/
CLAIM(bernstein_collocation_is_totally_positive)
{
    int n = T->degree;
    num s[MAX_ORDER], rows[MAX_ORDER * MAX_ORDER], M[MAX_ORDER * MAX_ORDER];
    G(increasing)(T, n + 1, s);
    if (T->faulty) {
        num first = s[0];
        s[0] = s[1], s[1] = first;
    }
    for (int i = 0; i <= n; i++)
        G(scaled_values)(n, s[i], rows + i * (n + 1));
    for (int columns = 1; columns < 1 << (n + 1); columns++) {
        int order = 0;
        for (int j = 0; j <= n; j++)
            order += columns >> j & 1;
        for (int i = 0; i < order; i++)
            for (int j = 0, at = 0; j <= n; j++)
                if (columns >> j & 1)
                    M[i * order + at++] = rows[i * (n + 1) + j];
        G(must_be_positive)(T, G(determinant)(order, M));
    }
}
#elif RATIONAL
CLAIM(bernstein_collocation_is_totally_positive)
{
    int n = T->degree;
    num s[MAX_DEGREE + 2], M[(MAX_DEGREE + 2) * (MAX_DEGREE + 1)];
    G(increasing)(T, n + 2, s);
    if (T->faulty) {
        num first = s[0];
        s[0] = s[1], s[1] = first;
    }
    for (int i = 0; i <= n + 1; i++)
        G(bernstein_basis)(n, div(s[i], add(from_int(1), s[i])), M + i * (n + 1));
    agree(T, is_totally_positive(n + 2, n + 1, M));
}
#endif

/*
## From minors to roots

Let $b_0,\dots,b_n$ have $p$ changes of sign.  They fall into $p+1$ blocks of neighbours, in each of which no two have
opposite signs and one is not $0$; from block to block the sign alternates.  Put $g_j=|b_j|$, and let column $k$ of a
matrix be $\sum_{j\in\text{block }k}g_jB_j^n$ at increasing parameters $t_0,\dots,t_p$.  If the polynomial had these
$p+1$ roots, the matrix would send the vector of the signs, $(1,-1,1,\dots)$, to $0$.  It cannot: its determinant is
positive.
*/

#if FIELD
/*
:::{claim} blocks_of_coefficients_are_independent
:title: A polynomial with p changes of sign does not vanish at p+1 parameters
:zh: 系数有 p 次变号时,(0,1) 内至多 p 个不同的根
:given: a decomposition of $0,\dots,n$ into consecutive blocks $0,\dots,p$, positive $g_0,\dots,g_n$, and
  $0<t_0<\dots<t_p<1$
:let: $V$ the number of changes of sign, where zeros are left out
:then: $\det\Bigl(\sum_{j\in\text{block }k}g_jB_j^n(t_i)\Bigr)_{i,k=0}^p>0$; hence $\sum b_iB_i^n$ has at most $V(b)$ different
  roots in $(0,1)$, unless it is $0$
:method: For each of the $2^n$ decompositions the determinant is a polynomial in the $g_j$ and the $x_i$, after each row was
  multiplied by $(1+s_i)^n>0$; all its coefficients are positive.  By the columns it is the sum, over the choices of one
  $j$ from each block, of $\prod g_j$ times a minor; so it stays positive when some of the $g_j$ are $0$, one in each
  block being left.
:types: field
:degrees: 1..4
:scope: increasing parameter values in (0, 1); all coefficients
:where: the factors $g_i$ are positive
:over: x#: -; g#: -
:control: the first two parameters exchanged
:::
*/
CLAIM(blocks_of_coefficients_are_independent)
{
    int n = T->degree;
    num s[MAX_ORDER], g[MAX_ORDER], rows[MAX_ORDER * MAX_ORDER], M[MAX_ORDER * MAX_ORDER];
    G(increasing)(T, n + 1, s);
    if (T->faulty) {
        num first = s[0];
        s[0] = s[1], s[1] = first;
    }
    for (int i = 0; i <= n; i++) {
        G(scaled_values)(n, s[i], rows + i * (n + 1));
        g[i] = positive(T, "g", i);
    }
    for (int cuts = 0; cuts < 1 << n; cuts++) { /* bit j: a new block begins after j */
        int blocks = 1;
        for (int j = 0; j < n; j++)
            blocks += cuts >> j & 1;
        for (int i = 0; i < blocks; i++)
            for (int j = 0, k = 0; j <= n; j++) {
                num part = mul(g[j], rows[i * (n + 1) + j]);
                int begins = j == 0 || (cuts >> (j - 1) & 1);
                k += begins && j > 0;
                M[i * blocks + k] = begins ? part : add(M[i * blocks + k], part);
            }
        G(must_be_positive)(T, G(determinant)(blocks, M));
    }
}
#endif

#if RATIONAL
static int G(sign_changes)(int count, const num b[])
{
    int changes = 0, last = 0;
    for (int i = 0; i < count; i++) {
        int sign = sign_q(b[i]);
        changes += sign * last < 0;
        last = sign != 0 ? sign : last;
    }
    return changes;
}

/*
Roots may also be counted with their multiplicity, and for every degree.  This is Descartes' rule of signs for the powers of
$s=\frac t{1-t}$, whose coefficients $\binom nib_i$ have the signs of the $b_i$: a root $r>0$ is a factor $s-r$, and each
such factor adds at least one change of sign to the coefficients.  Along the coefficients only the signs of the last few
matter, so that an automaton with a handful of states reads sequences of every length.

:::{claim} linear_factor_adds_a_change_of_sign
:title: A factor s - r with r > 0 adds at least one change of sign; so roots are at most changes of sign, for every degree
:zh: 因子 s-r 至少增加一次变号;笛卡尔符号法则(任意次)
:kind: decision
:given: a polynomial $q\ne0$ of any degree, $r>0$, and $p=(s-r)\,q$, so that $p_k=q_{k-1}-rq_k$
:let: $V$ the number of changes of sign, where zeros are left out
:then: $V(p)\ge V(q)+1$; hence a polynomial has at most as many positive roots, each as often as its multiplicity, as its
  coefficients have changes of sign, and $\sum b_iB_i^n$, not all $b_i=0$, has at most $V(b)$ roots in $(0,1)$ so counted
:method: The sign of $p_k$ depends on those of $q_{k-1}$ and $q_k$, and where these are equal and not 0 it may be any: the
  ratios $\frac12,1,2$ of $rq_k$ and $q_{k-1}$ give every sign that can occur.  A state is the sign of $q_{k-1}$, the last signs of
  $q$ and of $p$ that are not 0, and $V(p)-V(q)$, cut off above; from the first coefficient on all states are visited, and at the end
  the difference is at least 1.  Then induction over the roots, and $(1+s)^n\sum b_iB_i^n(t)=\sum\binom nib_is^i$ for $t=\frac s{1+s}$.
:degrees: all
:scope: all coefficients
:where: the polynomial whose roots are counted is not $0$
:control: the factor $s+r$
:::
*/
enum { LEAST = -3, MOST = 2, DIFFERENCES = MOST - LEAST + 1 };

/* What is known of q and p up to a coefficient: signs as -1, 0, 1. */
struct reading {
    int before, last_of_q, last_of_p, difference; /* difference: V(p) - V(q), at most MOST */
};

static int index_of(struct reading s)
{
    return ((s.before + 1) * 9 + (s.last_of_q + 1) * 3 + s.last_of_p + 1) * DIFFERENCES + s.difference - LEAST;
}

/* The reading after one more coefficient of q with this sign, when that of p has that sign. */
static struct reading read_on(struct reading s, int of_q, int of_p)
{
    s.difference += (of_p * s.last_of_p < 0) - (of_q * s.last_of_q < 0);
    s.difference = s.difference > MOST ? MOST : s.difference;
    s.last_of_q = of_q != 0 ? of_q : s.last_of_q;
    s.last_of_p = of_p != 0 ? of_p : s.last_of_p;
    s.before = of_q;
    return s;
}

CLAIM(linear_factor_adds_a_change_of_sign)
{
    int seen[27 * DIFFERENCES] = {0}, count = 1;
    struct reading waiting[27 * DIFFERENCES] = {{0, 0, 0, 0}};
    seen[index_of(waiting[0])] = 1;
    for (int k = 0; k < count; k++)
        for (int of_q = -1; of_q <= 1; of_q++)
            for (int ratio = -1; ratio <= 1; ratio++) {
                num r = ratio < 0 ? from_ratio(1, 2) : from_int(1 + ratio), moved = mul(r, from_int(of_q));
                struct reading s = waiting[k];
                int of_p = sign_q(fault(T, sub(from_int(s.before), moved), add(from_int(s.before), moved)));
                s = read_on(s, of_q, of_p);
                if (of_q == 0 && waiting[k].before != 0) /* p_{m+1} = q_m: q may have ended with that coefficient */
                    agree(T, s.difference >= 1);
                agree(T, s.difference > LEAST);
                if (s.difference > LEAST && !seen[index_of(s)]) {
                    seen[index_of(s)] = 1;
                    waiting[count++] = s;
                }
            }
}

/*
The number of roots, counted so, differs from the number of changes by an even number.  For small degrees all patterns of signs
are tried, with few sizes.

:::{claim} roots_are_at_most_sign_changes
:title: Roots in (0,1), with multiplicity, against changes of sign
:zh: 开区间内的根数(计重数)不超过系数变号数
:kind: decision
:data: sizes = 7 1 9 2 8 3 5; N = 6
:given: every pattern of the signs $-1,0,1$ of the coefficients $b_0,\dots,b_n$, not all $0$, with the sizes $1,\dots,1$ and, for
  $n\le N$, with the sizes that are given and their reverse
:let: $V$ the number of changes of sign, where zeros are left out
:then: the number of roots of $\sum b_iB_i^n$ in $(0,1)$, each as often as its multiplicity, is at most $V(b)$ and differs from
  it by an even number; the different ones are as many as Sturm's theorem counts
:method: Of $b$ and $-b$ one is taken.  Each polynomial's roots are counted exactly, by subdivision and by Sturm's chain; the parity holds also where end
  coefficients vanish, because $t$ or $1-t$ is then a factor, and dividing by it
  changes neither number.  For other sizes and every $n$ it is Descartes' rule.
:degrees: 0..8
:scope: all $3^{n+1}-1$ patterns of signs, up to $n=6$ with three choices of sizes, for $n=7,8$ with one
:control: the roots counted in $[0,1]$
:::
*/
CLAIM(roots_are_at_most_sign_changes)
{
    enum { SIZES = 7 };
    int n = T->degree, patterns = 1;
    num b[MAX_DEGREE + 1], size[SIZES], zero = from_int(0), one = from_int(1);
    given_points(T, "sizes", SIZES, 1, size);
    int most = given_whole(T, "N");
    for (int i = 0; i <= n; i++)
        patterns *= 3;
    for (int sizes = 0; sizes < (n <= most ? 3 : 1); sizes++)
        for (int pattern = patterns / 2 + 1; pattern < patterns; pattern++) { /* before: 0, and those of -b */
            for (int i = 0, rest = pattern; i <= n; i++, rest /= 3)
                b[i] = mul(from_int(rest % 3 - 1), sizes == 0 ? one : size[sizes == 1 ? i : n - i]);
            poly p = poly_from_bernstein(n, b);
            struct cagd_root_count open = count_roots(p, zero, one, OPEN);
            int counted = fault(T, open.counted, count_roots(p, zero, one, CLOSED).counted);
            int spare = G(sign_changes)(n + 1, b) - counted;
            agree(T, spare >= 0 && spare % 2 == 0);
            int at_one = is_zero_q(poly_value(p, one)); /* Sturm counts in (0,1] */
            agree(T, sturm_count(p, zero, one) - at_one == open.distinct);
        }
}

/*
A line $ax+by+c=0$ turns this into the statement on curves: along the curve $ax+by+c$ is the polynomial with the
coefficients $ax_i+by_i+c$, whose signs say on which side the points of the polygon are.

It is crossings that are counted, not points in common: where a line touches the curve, or the polygon lies on it for a while, nothing
changes sign.  A textbook that says "intersections" means these.

:::{claim} line_crosses_curve_at_most_as_often_as_polygon
:title: A line crosses the curve no more often than the polygon
:zh: 变差缩减性:直线与曲线的交点数不多于与控制多边形的交点数
:given: points $b_0,\dots,b_n$ of the plane and a line, at random
:then: the line crosses the curve over $(0,1)$ at most as often as it crosses the open polygon
:method: Both numbers are counted exactly.  With `blocks_of_coefficients_are_independent` for the coefficients
  $ax_i+by_i+c$ it is proved for the degrees stated there; this run is on the curves themselves, up to a larger degree.
:types: rational
:degrees: 1..9
:control: the polygon without its inner points
:::
*/
CLAIM(line_crosses_curve_at_most_as_often_as_polygon)
{
    int n = T->degree;
    num b[(MAX_DEGREE + 1) * 2], w[MAX_DEGREE + 1], ends[4];
    G(free_points)(T, n, 2, b);
    for (int i = 0; i <= n; i++) {
        w[i] = from_int(1);
        b[2 * i + 1] = div(b[2 * i + 1], from_int(8)); /* flat, so that lines often cross */
    }
    struct cagd_line line = {unknown(T, "line", 0), unknown(T, "line", 1), div(unknown(T, "line", 2), from_int(4))};
    int of_curve = curve_meets_line(n, b, w, line).crossings;
    ends[0] = b[0], ends[1] = b[1], ends[2] = b[2 * n], ends[3] = b[2 * n + 1];
    agree(T, of_curve <= fault(T, polygon_crossings(n, b, line), polygon_crossings(1, ends, line)));
}
#endif

/*
## Another way: cutting corners

The polygons of subdivision and of elevation arise by putting weighted averages of neighbours between them and then
leaving out points.  Neither can make a new change of sign, whatever the degree; and the polygons converge to the
curve.
*/

#if RATIONAL
/*
:::{claim} averages_between_neighbours_keep_sign_changes
:title: An average put between two neighbours does not change the number of sign changes; leaving out a number cannot raise it
:zh: 插入邻项平均不改变变号数,删去一项不增加变号数
:kind: decision
:given: a sequence $\dots,p,a,b,s,\dots$ and $c=(1-\lambda)a+\lambda b$, $0\le\lambda\le1$
:harmless: $0\le\lambda\le1$ | a point between two neighbours is such a mean
:let: $V$ the number of changes of sign, where zeros are left out
:then: $V(\dots,p,a,c,b,s,\dots)=V(\dots,p,a,b,s,\dots)\ge V(\dots,p,a,s,\dots)$
:method: $V$ depends on signs only, and of what stands before $a$ and after $b$ only on the nearest sign that is not $0$, or
  on there being none: $81$ cases for $p$, $a$, $b$, $s\in\{-1,0,1\}$.  For given signs of $a$ and $b$ the values
  $\lambda=0,\frac14,\frac12,\frac34,1$ give $c$ every sign it can have.  So it holds for sequences of every length and all $\lambda$ of $[0,1]$.
:degrees: all
:control: the average extrapolated, $\lambda=2$ as well
:::
*/
CLAIM(averages_between_neighbours_keep_sign_changes)
{
    for (int pattern = 0; pattern < 81; pattern++) {
        num p = from_int(pattern % 3 - 1), a = from_int(pattern / 3 % 3 - 1);
        num b = from_int(pattern / 9 % 3 - 1), s = from_int(pattern / 27 - 1);
        num before[] = {p, a, b, s}, shorter[] = {p, a, s};
        int changes = G(sign_changes)(4, before);
        for (int quarter = 0; quarter <= fault(T, 4, 8); quarter++) {
            num c = add(a, mul(from_ratio(quarter, 4), sub(b, a))), after[] = {p, a, c, b, s};
            agree(T, G(sign_changes)(5, after) == changes);
        }
        agree(T, G(sign_changes)(3, shorter) <= changes);
    }
}
#endif

#if FIELD || RATIONAL
/*
The matrices of these steps are totally nonnegative too: no minor is negative.

:::{claim} split_matrix_is_totally_nonnegative
:title: The matrix of subdivision has no negative minor
:zh: 分割矩阵的全正性
:given: $t=\frac s{1+s}$, $s>0$: any $t\in(0,1)$
:then: the $(2n+1)\times(n+1)$ matrix that sends $b_0,\dots,b_n$ to the points $b_0^0,\dots,b_0^n=b_0^n,\dots,b_n^0$ of
  the two parts has no negative minor
:method: The columns are `bezier_split` of unit vectors.  In the field every minor, times a power of $1+s$, is a polynomial
  with no negative coefficient; in rationals the elimination of `total_positivity.h` decides the matrix at random $t$.
:types: field rational
:degrees: 1..4 sampled 12
:scope: 0 < t < 1
:harmless: $s>0$ | it is $0<t<1$
:over: s: -
:control: the first two rows exchanged
:::
*/
static void G(split_matrix)(int n, num t, num scale, int exchanged, num M[])
{
    num unit[MAX_DEGREE + 1], left[MAX_DEGREE + 1], right[MAX_DEGREE + 1];
    for (int j = 0; j <= n; j++) {
        for (int i = 0; i <= n; i++)
            unit[i] = from_int(i == j);
        G(bezier_split)(n, 1, unit, t, left, right);
        for (int i = 0; i <= 2 * n; i++) {
            int row = exchanged && i < 2 ? 1 - i : i;
            M[row * (n + 1) + j] = mul(scale, i <= n ? left[i] : right[i - n]);
        }
    }
}
#endif

#if FIELD
CLAIM(split_matrix_is_totally_nonnegative)
{
    int n = T->degree, rows = 2 * n + 1;
    num s = positive(T, "s", 0), u = add(from_int(1), s);
    num A[(2 * MAX_ORDER + 1) * (MAX_ORDER + 1)], M[MAX_ORDER * MAX_ORDER];
    G(split_matrix)(n, div(s, u), G(power)(u, n), fault(T, 0, 1), A);
    for (int r = 1; r < 1 << rows; r++)
        for (int c = 1; c < 1 << (n + 1); c++) {
            int order = 0, width = 0, m = 0;
            for (int i = 0; i < rows; i++)
                order += r >> i & 1;
            for (int j = 0; j <= n; j++)
                width += c >> j & 1;
            if (order != width)
                continue;
            for (int i = 0; i < rows; i++)
                for (int j = 0; j <= n; j++)
                    if ((r >> i & 1) && (c >> j & 1))
                        M[m++] = A[i * (n + 1) + j];
            nonnegative(T, G(determinant)(order, M));
        }
}
#elif RATIONAL
CLAIM(split_matrix_is_totally_nonnegative)
{
    int n = T->degree;
    num A[(2 * MAX_DEGREE + 1) * (MAX_DEGREE + 1)];
    G(split_matrix)(n, inside(T, "s"), from_int(1), fault(T, 0, 1), A);
    agree(T, is_totally_nonnegative(2 * n + 1, n + 1, A));
}

/*
The same is true of elevation, for a simpler reason: its matrix has two diagonals.

:::{claim} elevation_matrix_is_totally_nonnegative
:title: The elevation matrix has no negative minor
:zh: 升阶矩阵的全正性
:kind: decision
:given: the elevation matrix of degree $n$
:then: it has no negative minor
:method: The elimination of `total_positivity.h` on the kernel's matrix, and for $n\le5$ every minor.  Its only entries are
  on two neighbouring diagonals; a minor of such a matrix is a product of entries, or $0$.
:degrees: 0..20
:control: the first two rows exchanged
:::
*/
CLAIM(elevation_matrix_is_totally_nonnegative)
{
    int n = T->degree;
    num E[(MAX_DEGREE + 2) * (MAX_DEGREE + 1)];
    G(bernstein_elevation_matrix)(n, E);
    if (T->faulty)
        for (int j = 0; j <= n; j++) {
            num first = E[j];
            E[j] = E[n + 1 + j], E[n + 1 + j] = first;
        }
    agree(T, is_totally_nonnegative(n + 2, n + 1, E));
    if (n <= 5)
        agree(T, all_minors_nonnegative(n + 2, n + 1, E, 0, NULL));
}
#endif

#include "chapters/judge/claims_off.h"
