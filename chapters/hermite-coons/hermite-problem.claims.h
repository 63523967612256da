/*
# Any number of values and derivatives (一般 Hermite 插值问题)
*/
#include "chapters/hermite-coons/definition.h"

#include "chapters/judge/claims_on.h"

/*
A polynomial of degree $N$ has $N+1$ coefficients, and so many numbers can be prescribed: values at different nodes, and at each node
derivatives up to some order without a gap.  Whether there is a solution is a question of linear algebra, and one answer
serves for existence and uniqueness, the system being square.

:::{statement} slides-ch4:2-hermite-problem
:title: The polynomial with given values and derivatives
:zh: 一般 Hermite 插值问题
:printed: A polynomial $P(t)$ of degree $N=m_0+m_1+\dots+m_k-1$ is to be determined, with $P^{(j)}(t_i)=f^{(j)}(t_i)$, $i=0,1,\dots,k$,
  $j=0,1,\dots,m_i-1$.
:holds-by: one_more_datum_determines_one_more_coefficient a_factor_raises_the_order_of_a_zero
:confirmed-by: hermite_interpolant_exists_and_is_unique
:hypothesis: straight_data_have_no_cubic | the degree is at most $N$: of degree exactly $N$ there may be none
:needs: equal_nodes_have_no_interpolant | the words: at $k+1$ points $t_i$ (在 $k+1$ 个点 $t_i$ 处) | the $k+1$ points $t_i$ are different
:figure: hermite_blending_functions
:::

:::{statement} slides-ch4:2-general-degree
:title: In general the interpolating polynomial is of a high degree
:zh: 一般 Hermite 插值多项式次数较高
:printed: for the general problem the interpolating polynomial is in general of a rather high degree, and inconvenient to use
:reading: one_more_datum_determines_one_more_coefficient | over different nodes the degree of the polynomial is one less than the number of the data, unless the
  polynomial of the other data has the last datum already
:reading-with: a_factor_raises_the_order_of_a_zero
:confirmed-by: hermite_interpolant_exists_and_is_unique
:reading: which degree is high, and what inconvenient: the slides do not say, so that nothing is there to be decided
:figure: hermite_blending_functions
:::
*/

/*
:::{claim} hermite_interpolant_exists_and_is_unique
:title: Values and derivatives at different nodes determine one polynomial
:zh: Hermite 插值多项式存在且唯一
:given: different nodes with multiplicities of the sum $N+1$, all $2^N$ ways to choose them in the field, random ones elsewhere
:then: from the values and derivatives of any polynomial of degree at most $N$ the kernel `hermite_interpolant` gives its
  coefficients back; hence to any data there is exactly one polynomial of degree at most $N$
:method: Nodes and coefficients are variables; the data are the derivatives of the power form.  The map from $N+1$ coefficients
  to $N+1$ data is linear and has a left inverse, so it is one to one, and being square, it is onto.
:degrees: N = 0..6 sampled 10
:over: t#: different nodes; c#: coefficients
:defines: hermite_interpolant
:control: the last datum replaced by 0
:::
*/
/* Pattern number m of `count` nodes: bit a says that node a+1 differs from node a.  Returns how many different ones. */
static int G(multiplicities)(int count, int m, int l[])
{
    int d = 0;
    l[0] = 1;
    for (int a = 0; a + 1 < count; a++) {
        if (m >> a & 1)
            l[++d] = 0;
        l[d]++;
    }
    return d + 1;
}

CLAIM(hermite_interpolant_exists_and_is_unique)
{
    int N = T->degree, l[MAX_ORDER];
    num tau[MAX_ORDER], f[MAX_ORDER], c[MAX_ORDER];
    struct G(poly) p = G(free_poly)(T, "c", N);
    int patterns = FIELD ? 1 << N : 1;
    for (int m = 0; m < patterns; m++) {
        int d = G(multiplicities)(N + 1, FIELD ? m : pick(T, 0, (1 << N) - 1), l), place = 0;
        G(different_nodes)(T, d, tau);
        for (int i = 0; i < d; i++)
            for (int j = 0; j < l[i]; j++)
                f[place++] = G(at)(p, j, tau[i]);
        f[N] = fault(T, f[N], from_int(0));
        G(hermite_interpolant)(d, l, tau, f, c);
        for (int k = 0; k <= N; k++)
            same(T, c[k], p.c[k]);
    }
}

/*
:::{claim} one_more_datum_determines_one_more_coefficient
:title: With one datum more a polynomial of one degree more has one coefficient more, and one only
:zh: 每增一个型值恰确定一个新系数
:given: the first $M$ data, and one more, $f$; a polynomial $p$ of degree less than $M$ with the first data, and the value $p'$ of the next datum for $p$; a polynomial
  $\omega$ of degree $M$ for which the first data are 0 and the next one is $w\ne0$; any coefficient $e$
:harmless: $w\ne0$ | it is $j!$ times a product of differences of different nodes
:then: for $p+e\,\omega$ the next datum is $f+w\,(e-c)$ with $c=\frac{f-p'}w$: it is right for $e=c$, and for no other $e$
:method: An identity, everything a variable; then induction over the data.  $\omega$ is the product of the factors $t-t_i$, each as often as data of the
  node $t_i$ are among the first; with $j$ factors of the next node, by `a_factor_raises_the_order_of_a_zero`, the derivatives of $\omega$ there
  are 0 below the order $j$, and that of order $j$ is $j!$ times the product of the other factors, which is not 0 when the nodes are different.
  The products for $M=0,\dots,N$ have the degrees $0,\dots,N$, so that every polynomial of degree at most $N$ is a sum of their multiples.
:scope: every N
:over: f#: data; p e w: -
:control: $c$ with the other sign
:::
*/
CLAIM(one_more_datum_determines_one_more_coefficient)
{
    num f = unknown(T, "f", 0), p = unknown(T, "p", 0), e = unknown(T, "e", 0), w = positive(T, "w", 0);
    num c = div(fault(T, sub(f, p), sub(p, f)), w);
    about(T, "the next datum with the coefficient c");
    same(T, add(p, mul(c, w)), f);
    about(T, "the next datum with any coefficient");
    same(T, add(p, mul(e, w)), add(f, mul(w, sub(e, c))));
}

#if RATIONAL
/*
:::{claim} equal_nodes_have_no_interpolant
:title: At equal nodes the conditions contradict each other
:zh: 节点相同则无解
:kind: counterexample
:data: t = 0 0
:instead: t = 0 1
:result: the determinant = 0
:given: two nodes $t$ that are equal, one value at each; lines $c_0+c_1t$
:then: the determinant of the conditions is 0: if the two values are equal, all lines through one point satisfy both, and if not, no line does
:method: The determinant of the system with the rows $(1,t_i)$; that it is not 0 is refuted.
:control: different nodes
:::
*/
CLAIM(equal_nodes_have_no_interpolant)
{
    num t[2];
    given_points(T, "t", 2, 1, t);
    num determinant = sub(t[1], t[0]);
    found(T, "the determinant", determinant);
    refute(T, is_zero_q(determinant));
}

/*
:::{claim} two_equal_nodes_of_four_have_no_cubic
:title: With two equal nodes among four the conditions contradict each other
:zh: 四节点中有两个相同则无解
:kind: counterexample
:data: t = 0 1 2 0
:instead: t = 0 1 2 3
:result: the determinant = 0
:given: four nodes $t$, two of which are equal, one value at each; cubics $c_0+c_1t+c_2t^2+c_3t^3$
:then: the determinant of the conditions is 0: if the two values are equal, infinitely many cubics satisfy all four, and if not, none does
:method: The determinant of the system with the rows $(1,t_i,t_i^2,t_i^3)$; that it is not 0 is refuted.
:control: four different nodes
:::
*/
CLAIM(two_equal_nodes_of_four_have_no_cubic)
{
    num t[4], rows[16];
    given_points(T, "t", 4, 1, t);
    for (int j = 0; j < 16; j++)
        rows[j] = j % 4 == 0 ? from_int(1) : mul(rows[j - 1], t[j / 4]);
    num determinant = determinant_q(4, rows);
    found(T, "the determinant", determinant);
    refute(T, is_zero_q(determinant));
}

/*
:::{claim} equal_ends_have_no_cubic
:title: With equal ends the four conditions of the cubic contradict each other
:zh: 端点相同时三次 Hermite 问题无解
:kind: counterexample
:data: t = 0 0
:instead: t = 0 1
:result: the determinant = 0
:given: two ends $t_0$, $t_1$ that are equal, and cubics with a value and a derivative at each
:then: the determinant of the four conditions is 0: if the values and the derivatives are equal, infinitely many cubics satisfy them, and if not, none
  does
:method: The determinant of the system whose rows are the powers of $t_i$ and their derivatives; that it is not 0 is refuted.
:control: different ends
:::
*/
CLAIM(equal_ends_have_no_cubic)
{
    num t[2], rows[16];
    given_points(T, "t", 2, 1, t);
    for (int i = 0; i < 2; i++) {
        num power[4] = {from_int(1), t[i], mul(t[i], t[i]), mul(t[i], mul(t[i], t[i]))};
        for (int k = 0; k < 4; k++) {
            rows[8 * i + k] = power[k];
            rows[8 * i + 4 + k] = k > 0 ? mul(from_int(k), power[k - 1]) : from_int(0);
        }
    }
    num determinant = determinant_q(4, rows);
    found(T, "the determinant", determinant);
    refute(T, is_zero_q(determinant));
}

/*
:::{claim} straight_data_have_no_cubic
:title: The data of a line have no interpolant of degree 3
:zh: 直线数据的插值多项式次数低于三
:kind: counterexample
:data: t = 0 1; f = 0 1; f' = 1 1; N = 3
:instead: f' = 1 2
:result: c = 0 1 0 0
:given: $k=1$, $m_0=m_1=2$, so that $N$ is as given; the values $f$ and derivatives $f'$ of $f(t)=t$ at the two nodes
:then: of the coefficients $c_0,\dots,c_N$ of the only polynomial of degree at most $N$ with these data the last is 0: its degree is 1
:method: The kernel's coefficients; it gives the only polynomial of degree at most $N$.  That the last one is not 0 is refuted.
:control: another derivative at $t_1$
:::
*/
CLAIM(straight_data_have_no_cubic)
{
    int l[2] = {2, 2};
    num t[2], f[2], slope[2], c[4];
    given_points(T, "t", 2, 1, t);
    given_points(T, "f", 2, 1, f);
    given_points(T, "f'", 2, 1, slope);
    hermite_interpolant_q(2, l, t, (num[]){f[0], slope[0], f[1], slope[1]}, c);
    found_points(T, "c", 4, 1, c);
    refute(T, is_zero_q(c[given_whole(T, "N")]));
}
#endif

#include "chapters/judge/claims_off.h"
