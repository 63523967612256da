/*
# Divided differences with repeated nodes (重节点差商)

A B-spline is a divided difference of a truncated power, so a formula for divided differences is a formula for
B-splines.  This section decides the formula that the source uses: the divided difference of order $k$ over nodes
that may coincide, written out with the values of the function and of its derivatives.

The nodes are $\tau_1<\dots<\tau_d$ with the multiplicities (重数) $l_1,\dots,l_d$, together $k+1$.  A set of
multiplicities is a composition of $k+1$, and there are $2^k$ of them: the claims below go through them all, in other
numbers than those of the field beyond $k=4$ through random ones.  The degree that a claim names is $k$.
*/
#include "chapters/nurbs/spans.h"

#include <string.h>

#include "chapters/judge/claims_on.h"

/*
## Osculation (密切)

:::{statement} wang-ch4:def-4.4.2
:title: Two functions osculate on a set of nodes
:zh: 函数在节点向量上密切
:printed: let $T=\{t_i\}_{i=0}^k$ be a knot vector, in which knots may be equal; if the functions $p$ and $q$ have at every knot $t$ of multiplicity $m$ in $T$ equal derivatives
  up to the order $m-1$, that is (4.4.4), then they are said to osculate on the knot vector $T$
:definition: yes
:checked-by: derivative_lowers_the_multiplicity_by_one
:confirmed-by: osculation_is_divisibility
:figure: osculating_polynomial

With $m-1$ as the last order the number of conditions is the number of nodes.  A difference $p-q$ that is the product of all $t-t_i$ times a polynomial fulfils them; at a
node the next derivative, of order $m$, is not 0, unless that polynomial is 0 there (`osculation_is_divisibility`).
:::

:::{statement} wang-ch4:formula-4.4.4
:title: The conditions at one node
:zh: 单个节点处的密切条件
:printed: p^{(j)}(t)=q^{(j)}(t),\quad j=0,1,\dots,m-1
:definition: yes
:checked-by: derivative_lowers_the_multiplicity_by_one
:confirmed-by: osculation_is_divisibility
:figure: osculating_polynomial

In definition 4.4.2 this is asked of $p$ and $q$ at every knot $t$ of $T$; $m$ is its multiplicity.
:::
*/

/* Pattern number m, 0 <= m < 2^k, of k+1 nodes: bit a says that node a+1 is greater than node a.  Returns the
 * number d of groups and their sizes l. */
static int G(composition)(int k, int m, int l[])
{
    int d = 0;
    l[0] = 1;
    for (int a = 0; a < k; a++) {
        if (m >> a & 1)
            l[++d] = 0;
        l[d]++;
    }
    return d + 1;
}

#if FIELD
/*
To osculate is to have common zeros of the difference, counted with multiplicity.  For polynomials this is
divisibility: a multiple of the product of all $t-t_i$ has just so many vanishing
derivatives, and the next one does not vanish.  At one node that is an induction on its multiplicity; for all nodes together it is tried for every set of multiplicities.

:::{claim} derivative_lowers_the_multiplicity_by_one
:title: A derivative lowers the multiplicity of a zero by one
:zh: 求导使零点重数减一
:given: $f(t)=(t-\tau)^mh(t)$ for a node $\tau$ and a multiplicity $m\ge1$; $m$, $\tau$, $t$, the power $P=(t-\tau)^{m-1}$, $h$ and $h'$ at $t$ variables
:then: $f'(t)=(t-\tau)^{m-1}h_1(t)$ with $h_1=m\,h+(t-\tau)h'$, and $h_1(\tau)=m\,h(\tau)$
:method: The product rule with $P'=(m-1)P/(t-\tau)$ against the product.  By induction $f,f',\dots,f^{(m-1)}$ vanish at $\tau$, and $f^{(m)}(\tau)=m!\,h(\tau)$: a difference
  $p-q$ of polynomials has at $\tau$ the derivatives of the orders $0,\dots,m-1$ equal to 0 just when it is divisible by $(t-\tau)^m$.
:types: field
:degrees: multiplicity = all
:over: m t0 x P h#: -
:control: $m+1$ in the place of $m$ in $h_1$
:::
*/
CLAIM(derivative_lowers_the_multiplicity_by_one)
{
    num m = unknown(T, "m", 0), tau = unknown(T, "t", 0), x = unknown(T, "x", 0), P = unknown(T, "P", 0);
    num h = unknown(T, "h", 0), h1 = unknown(T, "h", 1), one = from_int(1), gap = sub(x, tau);
    num slope = div(mul(sub(m, one), P), gap); /* P' */
    /* f = (t-τ) P h */
    num derivative = add(mul(P, h), mul(gap, add(mul(slope, h), mul(P, h1))));
    num quotient = add(mul(fault(T, m, add(m, one)), h), mul(gap, h1));
    about(T, "the derivative");
    same(T, derivative, mul(P, quotient));
    about(T, "the quotient at the node");
    same(T, substitute_f(quotient, x, tau), mul(m, h));
}

/*

:::{claim} osculation_is_divisibility
:title: A multiple of the product of all t - t_i has the derivatives that osculation asks to vanish
:zh: 节点多项式的倍式满足密切条件
:given: every set of multiplicities of $k+1$ nodes, the nodes and $s_0,s_1$ variables, $p-q=(s_0+s_1t)\prod(t-t_i)$
:then: $p^{(j)}(\tau_i)=q^{(j)}(\tau_i)$ for $j<l_i$, and for $j=l_i$ the difference is
  $l_i!\,(s_0+s_1\tau_i)\prod_{m\ne i}(\tau_i-\tau_m)^{l_m}$, which is not 0 unless $s_0+s_1\tau_i$ is
:method: The derivatives are those of the rational function of $t$ in the field.
:types: field
:degrees: k = 0..6
:over: t#: different nodes; s#: coefficients; x: -
:control: the multiplicity of the last node counted as one more
:::
*/
CLAIM(osculation_is_divisibility)
{
    int k = T->degree, l[LARGEST_ORDER];
    num tau[LARGEST_ORDER], t = variable_f("x"), s = add(unknown(T, "s", 0), mul(unknown(T, "s", 1), t));
    G(increasing)(T, k + 1, tau);
    for (int m = 0; m < 1 << k; m++) {
        int d = G(composition)(k, m, l);
        for (int i = 0; i < d; i++) {
            num D = s, first = substitute_f(s, t, tau[i]);
            for (int b = 0; b < d; b++) {
                D = mul(D, G(power)(sub(t, tau[b]), l[b]));
                first = b == i ? first : mul(first, G(power)(sub(tau[i], tau[b]), l[b]));
            }
            about(T, "derivatives that vanish");
            int orders = l[i] + fault(T, 0, i == d - 1);
            for (int j = 0; j < orders; j++, D = derivative_f(D, t))
                vanishes(T, substitute_f(D, t, tau[i]));
            about(T, "the first that does not");
            /* l_i! (s_0 + s_1 τ_i) times the product of (τ_i - τ_m)^l_m over m ≠ i */
            same(T, substitute_f(D, t, tau[i]), mul(G(factorial)(orders), first));
        }
    }
}
#endif

/*
:::{statement} wang-ch4:formula-4.4.5
:title: The nodes grouped by their values
:zh: 节点按重数分组
:printed: suppose $T=\{t_0,t_1,\dots,t_k\}=\{\tau_1,\dots,\tau_1,\dots,\tau_d,\dots,\tau_d\}$, where $\tau_i$ has the multiplicity $l_i>0$, $i=1,2,\dots,d$; $l_1+\dots+l_d=k+1$,
  $\tau_1<\tau_2<\dots<\tau_d$
:definition: yes
:checked-by: compositions_are_all_multiplicities
:figure: osculating_polynomial

In the copy at hand an arrow stands over each group of equal knots; (4.4.10) has braces there.
:::
*/

#if RATIONAL
/*
:::{claim} compositions_are_all_multiplicities
:title: The 2^k compositions of k+1 are the sets of multiplicities
:zh: k+1 的全部有序分拆
:kind: decision
:given: every pattern of equal neighbours among $k+1$ ordered nodes
:then: the groups have positive sizes with the sum $k+1$, and different patterns give different lists of sizes
:method: All patterns are listed and their lists of sizes compared two by two.
:degrees: k = 0..7
:argued: every k | Whether a node differs from the one before is a choice at each of $k$ places, and the sizes of the groups tell the places.
:control: a pattern of $k+1$ bits, where only $k$ count
:::
*/
CLAIM(compositions_are_all_multiplicities)
{
    enum { MOST = 7 };
    int k = T->degree, l[1 << MOST][MOST + 1] = {{0}};
    for (int m = 0; m < 1 << k; m++) {
        int d = G(composition)(k, m << fault(T, 0, k > 0), l[m]), sum = 0, positive_sizes = 1;
        for (int i = 0; i < d; i++) {
            sum += l[m][i];
            positive_sizes &= l[m][i] > 0;
        }
        agree(T, sum == k + 1 && positive_sizes);
        for (int other = 0; other < m; other++)
            agree(T, memcmp(l[m], l[other], sizeof l[m]) != 0);
    }
}
#endif

/*
## The linear system and its determinant

The polynomial $g(t)=c_0+c_1t+\dots+c_kt^k$ that osculates $f$ solves a linear system.  Its matrix has, for the node
$\tau_i$, the rows of the derivatives of order $0,\dots,l_i-1$ of $1,t,\dots,t^k$.

:::{statement} wang-ch4:formula-4.4.6-matrix
:title: The matrix H of the values and derivatives of given functions
:zh: 密切插值矩阵 H
:printed: H(T;f_0,f_1,\dots,f_k)=\begin{pmatrix}f_0(\tau_1)&f_1(\tau_1)&\dots&f_{k-1}(\tau_1)&f_k(\tau_1)\\
  f'_0(\tau_1)&f'_1(\tau_1)&\dots&f'_{k-1}(\tau_1)&f'_k(\tau_1)\\
  \dots&\dots&\dots&\dots&\dots\\
  f_0^{(l_1-1)}(\tau_1)&f_1^{(l_1-1)}(\tau_1)&\dots&f_{k-1}^{(l_1-1)}(\tau_1)&f_k^{(l_1-1)}(\tau_1)\\
  \dots&\dots&\dots&\dots&\dots\\
  f_0(\tau_d)&f_1(\tau_d)&\dots&f_{k-1}(\tau_d)&f_k(\tau_d)\\
  f'_0(\tau_d)&f'_1(\tau_d)&\dots&f'_{k-1}(\tau_d)&f'_k(\tau_d)\\
  \dots&\dots&\dots&\dots&\dots\\
  f_0^{(l_d-1)}(\tau_d)&f_1^{(l_d-1)}(\tau_d)&\dots&f_{k-1}^{(l_d-1)}(\tau_d)&f_k^{(l_d-1)}(\tau_d)\end{pmatrix}
:definition: yes
:checked-by: confluent_vandermonde_holds_derivatives system_says_osculation
:argued: every k | Each differentiation of a power brings its exponent down as a factor and lowers it by one.
:figure: confluent_row

The functions are any; what is checked are the powers, $f_m=t^m$.
:::
*/

/* The patterns a case goes through: all 2^k in the field and up to k = 4, elsewhere `count` random ones. */
static int G(compositions)(int k, int count) { return FIELD || k <= 4 ? 1 << k : count; }
static int G(pattern_number)(trial *T, int k, int m) { return FIELD || k <= 4 ? m : pick(T, 0, (1 << k) - 1); }

/*
The matrix of the powers is a confluent matrix of Vandermonde: rows of values where nodes are simple, and below them
rows of derivatives where they are not.  The kernel that fills it is compared with derivatives taken formally; then it
is seen to say what osculation means.

:::{claim} confluent_vandermonde_holds_derivatives
:title: Row b(i,j) of the kernel has the j-th derivatives of the powers
:zh: 合流 Vandermonde 矩阵的元素
:given: every set of multiplicities of $k+1$ nodes, the nodes variables
:let: $b(i,j)=j+l_1+\dots+l_{i-1}$, rows and columns counted from 0
:then: entry $(b(i,j),m)$ of `confluent_vandermonde` is $\frac{d^j}{dt^j}t^m$ at $\tau_i$; so the last entry of the last row of $\tau_i$ is
  $\frac{k!}{(k-l_i+1)!}\tau_i^{k-l_i+1}$
:method: In the field the other side is the formal derivative, elsewhere the falling factorial times the power.
:degrees: k = 0..5 sampled 8
:over: t#: different nodes; x: -
:defines: confluent_vandermonde
:control: the derivatives at each node taken in the opposite order
:::
*/
CLAIM(confluent_vandermonde_holds_derivatives)
{
    int k = T->degree, l[LARGEST_ORDER];
    num tau[LARGEST_ORDER], H[LARGEST_ORDER * LARGEST_ORDER];
    G(increasing)(T, k + 1, tau);
    for (int count = G(compositions)(k, 6), m = 0; m < count; m++) {
        int d = G(composition)(k, G(pattern_number)(T, k, m), l), row = 0;
        G(confluent_vandermonde)(d, l, tau, H);
        for (int i = 0, last = -1; i < d; i++) {
            num factor = div(G(factorial)(k), G(factorial)(k - l[i] + 1));
            last += l[i];
            about(T, "the last entry of a node");
            same(T, H[last * (k + 1) + k], mul(factor, G(power)(tau[i], k - l[i] + 1)));
        }
        about(T, "the entries");
        for (int i = 0; i < d; i++)
            for (int j = 0; j < l[i]; j++, row++)
                for (int c = 0; c <= k; c++) {
                    int order = fault(T, j, l[i] - 1 - j);
#if FIELD
                    num x = variable_f("x"), D = G(power)(x, c);
                    for (int a = 0; a < order; a++)
                        D = derivative_f(D, x);
                    same(T, H[row * (k + 1) + c], substitute_f(D, x, tau[i]));
#else
                    same(T, H[row * (k + 1) + c], G(power_derivative)(c, order, tau[i]));
#endif
                }
    }
}

#if FIELD
/*
:::{claim} system_says_osculation
:title: The system H c = values says that the polynomial osculates
:zh: 方程组 Hc = 值 即密切条件
:given: every set of multiplicities of $k+1$ nodes, nodes and coefficients $c_0,\dots,c_k$ variables
:let: $b(i,j)=j+l_1+\dots+l_{i-1}$, rows counted from 0
:then: entry $b(i,j)$ of $H(T;1,\dots,t^k)\,c$ is the $j$-th derivative at $\tau_i$ of $c_0+\dots+c_kt^k$
:method: The product with the matrix of the kernel against the derivatives of the polynomial in the field.
:types: field
:degrees: k = 0..6
:over: t#: different nodes; c#: coefficients; x: -
:control: the coefficients $c_0$ and $c_k$ exchanged
:::
*/
CLAIM(system_says_osculation)
{
    int k = T->degree, l[LARGEST_ORDER];
    num tau[LARGEST_ORDER], H[LARGEST_ORDER * LARGEST_ORDER], c[LARGEST_ORDER], x = variable_f("x");
    num g = from_int(0);
    G(increasing)(T, k + 1, tau);
    for (int a = 0; a <= k; a++) {
        c[a] = unknown(T, "c", a);
        g = add(g, mul(unknown(T, "c", fault(T, a, k - a)), G(power)(x, a)));
    }
    for (int m = 0; m < 1 << k; m++) {
        int d = G(composition)(k, m, l), row = 0;
        G(confluent_vandermonde)(d, l, tau, H);
        for (int i = 0; i < d; i++) {
            num D = g;
            for (int j = 0; j < l[i]; j++, row++, D = derivative_f(D, x)) {
                num sum = from_int(0);
                for (int a = 0; a <= k; a++)
                    sum = add(sum, mul(H[row * (k + 1) + a], c[a]));
                same(T, sum, substitute_f(D, x, tau[i]));
            }
        }
    }
}
#endif

/*
:::{statement} wang-ch4:formula-4.4.6
:title: The last row of each node in the matrix
:zh: 方程组 (4.4.6) 中各节点的末行
:printed: in the matrix on the left of (4.4.6), which begins with the rows $1,\tau_1,\tau_1^2,\dots,\tau_1^k$ and $0,1,2\tau_1,\dots,k\tau_1^{k-1}$, the last row of $\tau_1$ is
  $0,0,0,\dots,\frac{k!}{(k-l_1-1)!}\tau_1^{k-l_1+1}$; the first row of $\tau_d$ is $1,\tau_d,\tau_d^2,\dots,\tau_d^k$, the last
  $0,0,0,\dots,\frac{k!}{(k-l_d-1)!}\tau_d^{k-l_d+1}$
:class: misprint
:refuted-by: printed_last_row_has_wrong_factor
:corrected: the last entry is $\frac{k!}{(k-l_i+1)!}\tau_i^{k-l_i+1}$, the derivative of order $l_i-1$ of $t^k$
:corrected-by: confluent_vandermonde_holds_derivatives system_says_osculation
:argued: every k | Each differentiation of a power brings its exponent down as a factor and lowers it by one.
:figure: confluent_row

For $l_i=k$ and $l_i=k+1$ the printed factorial is that of a negative number.  The last row of $\tau_i$ begins with $l_i-1$ zeros, which are three at least, as
printed, from $l_i=4$ on.
:::
*/

#if RATIONAL
/*
Printed matrices show a first row, dots, and a last row, so that a fault in the last row is a fault in all.  Here the
factorial below has to be that of the exponent, as in every derivative of a power; the print lowers it by 2.

:::{claim} printed_last_row_has_wrong_factor
:title: The printed entry of the last row is not the derivative of t^k
:zh: 末行末元素的阶乘印错
:kind: counterexample
:given: a node $\tau_1$ of multiplicity $l_1$, the least for which its last row begins with the three zeros that are printed, and the least $k$ for which the
  printed factorial is not that of a negative number
:data: k = 5; l_1 = 4; τ_1 = 1
:then: the last entry has to be $\frac{k!}{(k-l_1+1)!}\tau_1^{k-l_1+1}$; printed is $\frac{k!}{(k-l_1-1)!}\tau_1^{k-l_1+1}$, which is another number
:result: printed entry = 120; derivative of t^k = 60
:method: The printed entry against the derivative of order $l_1-1$ of $t^k$ at $\tau_1$.
:control: $(k-l_1+1)!$ in the denominator
:::
*/
CLAIM(printed_last_row_has_wrong_factor)
{
    int k = given_whole(T, "k"), l = given_whole(T, "l_1");
    num tau = given(T, "τ_1"), below = G(factorial)(fault(T, k - l + 1, k - l - 1));
    num printed = mul(div(G(factorial)(k), below), G(power)(tau, k - l + 1));
    num derivative = G(power_derivative)(k, l - 1, tau);
    found(T, "printed entry", printed);
    found(T, "derivative of t^k", derivative);
    about(T, "the last entry of the row of f^(l_1 - 1)(τ_1), and the derivative of t^k");
    same(T, printed, derivative);
}
#endif

/*
:::{statement} wang-ch4:formula-4.4.6-right-side
:title: The unknowns and the right side of the system
:zh: 方程组的未知量与右端
:printed: by definition 4.4.2 one has a system of $k+1$ linear equations in the $k+1$ unknowns $c_0,c_1,\dots,c_k$: the matrix times the column
  $(c_0,c_1,c_2,\dots,f^{(l_1-1)}(\tau_1),\dots,f(\tau_d),\dots,f^{(l_d-1)}(\tau_d))^T$
:class: misprint
:refuted-by: mixed_column_is_no_system
:corrected: H(T;1,t,\dots,t^k)\,(c_0,\dots,c_k)^T=(f(\tau_1),\dots,f^{(l_1-1)}(\tau_1),\dots,f^{(l_d-1)}(\tau_d))^T
:corrected-by: system_says_osculation
:argued: every k | A derivative of $c_0+\dots+c_kt^k$ is the sum of those of its terms, which are the entries of a row times the $c_m$.
:figure: osculating_polynomial

No equals sign is printed.  Two columns have run into one, in the copy at hand if not in the book: the unknowns $c_0,\dots,c_k$, which the sentence names, an equals sign, and
the values of $f$ and its derivatives.  With the values of $f$ in the places of $c_3,\dots$ the product need not be the vector of values.
:::
*/

#if RATIONAL
/*
:::{claim} mixed_column_is_no_system
:title: The column as it is printed does not give the values
:zh: 未知量与右端混排不成方程组
:kind: counterexample
:given: $k$ and $k+1$ simple nodes $\tau$, the fewest for which the column has room for all that is printed in it; $f(t)=t^k$, whose polynomial has the
  coefficients $c$
:data: k = 4; τ = -2 -1 0 1 2; c = 0 0 0 0 1
:then: the column $(c_0,c_1,c_2,f(\tau_1),f(\tau_d))$, $d=k+1$, is not mapped to the values of $f$
:result: column = 0 0 0 16 16; H times the column = 128 0 0 32 384; f(τ_i) = 16 1 0 1 16
:method: The product with $H(T;1,t,\dots,t^k)$ is computed.
:control: the column $c$
:::
*/
CLAIM(mixed_column_is_no_system)
{
    enum { MOST = 4 };
    int k = given_whole(T, "k"), l[MOST + 1] = {1, 1, 1, 1, 1};
    num tau[MOST + 1], H[(MOST + 1) * (MOST + 1)], column[MOST + 1], product[MOST + 1], values[MOST + 1];
    given_points(T, "τ", k + 1, 1, tau);
    given_points(T, "c", k + 1, 1, column);
    for (int i = 0; i <= k; i++)
        values[i] = G(power)(tau[i], k);
    column[k - 1] = fault(T, column[k - 1], values[0]);
    column[k] = fault(T, column[k], values[k]);
    G(osculation_matrix)(k + 1, l, k, tau, H);
    for (int i = 0; i <= k; i++) {
        product[i] = from_int(0);
        for (int c = 0; c <= k; c++)
            product[i] = add(product[i], mul(H[i * (k + 1) + c], column[c]));
    }
    found_points(T, "column", k + 1, 1, column);
    found_points(T, "H times the column", k + 1, 1, product);
    found_points(T, "f(τ_i)", k + 1, 1, values);
    about(T, "H times the column, and the values of f");
    for (int i = 0; i <= k; i++)
        same(T, product[i], values[i]);
}
#endif

/*
:::{statement} wang-ch4:formula-4.4.6-is-h
:title: The matrix of the system is H(T; 1, t, ..., t^k)
:zh: 方程组系数矩阵即 H(T;1,t,…,t^k)
:printed: the matrix on the left of (4.4.6) is $H(T;1,t,\dots,t^k)$
:class: misprint
:refuted-by: printed_last_row_has_wrong_factor
:corrected: it is, once the factorials in the last rows of (4.4.6) are put right
:corrected-by: confluent_vandermonde_holds_derivatives
:argued: every k | Each differentiation of a power brings its exponent down as a factor and lowers it by one.
:figure: confluent_row
:::

:::{statement} wang-ch4:formula-4.4.6-determinant
:title: The determinant of the system
:zh: 合流 Vandermonde 行列式
:printed: \det H(T;1,t,\dots,t^k)=\prod_{1\le i<j\le d}(\tau_j-\tau_i)^{l_il_j}\prod_{i=1}^d\prod_{j=0}^{l_i-1}j!
:holds-by: confluent_vandermonde_determinant_is_product derivative_lowers_the_multiplicity_by_one
:argued: every k | Let $\omega$ be the product of $t-t_i$ over all nodes but one $\tau_d$.  It is $t^k$ and lower powers, and may stand for $t^k$ in the last column without a change of the
  determinant.  The entries there are then 0, but $(l_d-1)!\prod_{i<d}(\tau_d-\tau_i)^{l_i}$ in the last row (`derivative_lowers_the_multiplicity_by_one`).  So the determinant is this times that of one node less, and so
  is the product; for $k=0$ both are 1.
:figure: confluent_row
:::
*/

/* The product of the differences and factorials that the source gives for its determinant, factor by factor. */
static num G(printed_determinant)(int d, const int l[], const num tau[])
{
    num product = from_int(1);
    for (int i = 0; i < d; i++)
        for (int j = i + 1; j < d; j++)
            product = mul(product, G(power)(sub(tau[j], tau[i]), l[i] * l[j]));
    for (int i = 0; i < d; i++)
        for (int j = 0; j <= l[i] - 1; j++)
            product = mul(product, G(factorial)(j));
    return product;
}

/*
The determinant is what one expects of Vandermonde, each difference taken as often as there are pairs of nodes, times
factorials from the derivatives.  As the nodes differ it is not 0, and the system has one solution.  This is where
equal nodes have to be counted as one.

:::{claim} confluent_vandermonde_determinant_is_product
:title: The determinant is the product of differences and factorials
:zh: 合流 Vandermonde 行列式公式
:given: every set of multiplicities of $k+1$ nodes, the nodes variables
:then: $\det H(T;1,\dots,t^k)$ is the printed product, and `confluent_vandermonde_determinant` computes it
:method: The determinant of the matrix of derivatives, by sums over all permutations up to $k=3$ and by
  Bird's algorithm, against the product written out factor by factor.
:degrees: k = 0..6 sampled 8
:over: t#: different nodes
:defines: confluent_vandermonde_determinant
:control: the exponents $l_il_j$ taken as 1
:::
*/
CLAIM(confluent_vandermonde_determinant_is_product)
{
    int k = T->degree, l[LARGEST_ORDER];
    num tau[LARGEST_ORDER], H[LARGEST_ORDER * LARGEST_ORDER];
    G(increasing)(T, k + 1, tau);
    for (int count = G(compositions)(k, 3), m = 0; m < count; m++) {
        int d = G(composition)(k, G(pattern_number)(T, k, m), l), ones[LARGEST_ORDER];
        G(osculation_matrix)(d, l, k, tau, H);
        for (int i = 0; i < d; i++)
            ones[i] = fault(T, l[i], 1);
        num det = G(determinant)(k + 1, H);
        about(T, "determinant and printed product");
        same(T, det, G(printed_determinant)(d, ones, tau));
        about(T, "determinant and kernel");
        same(T, det, G(confluent_vandermonde_determinant)(d, ones, tau));
        about(T, "two determinants");
        if (k <= 3)
            same(T, det, G(leibniz)(k + 1, 0, 0, H));
    }
}

/*
:::{statement} wang-ch4:formula-4.4.6-unique
:title: The system has exactly one solution
:zh: 方程组有唯一解
:printed: hence (4.4.6) has exactly one solution
:holds-by: confluent_vandermonde_determinant_is_product system_says_osculation
:argued: every order | The determinant is the product for every $k$ (`formula-4.4.6-determinant`), and the rows say for every $k$ what osculation asks (`formula-4.4.6-right-side`).
:meant: the determinant before it, that of $H(T;1,t,\dots,t^k)$ | (4.4.6) as corrected in `formula-4.4.6` and `formula-4.4.6-right-side`.
:needs: node_listed_twice_makes_h_singular | (4.4.5): $\tau_1<\tau_2<\dots<\tau_d$ | equal nodes are counted by multiplicity: so the $\tau_i$ differ
:figure: osculating_polynomial

The determinant is a product of factorials and differences, none of them 0.  The order that is told is $k$, that of the divided difference.
:::
*/

#if RATIONAL
/*
:::{claim} node_listed_twice_makes_h_singular
:title: A node listed twice as if it were two makes the system singular
:zh: 相同节点若分列则方程组奇异
:kind: counterexample
:given: $k=1$, the number of nodes that are listed, the list $\tau$ and the multiplicities $l$: twice the same node, each time with multiplicity 1
:data: nodes = 2; τ = 1 1; l = 1 1
:instead: nodes = 1; τ = 1; l = 2
:then: $\det H=0$, and so is the product that is printed for it and in (4.4.9): (4.4.7) and the weights divide by 0
:result: rows of H = (1,1) (1,1); det H = 0; the product = 0
:method: The determinant and the product are computed; that they are not 0 is what is compared.
:control: one node of multiplicity 2
:::
*/
CLAIM(node_listed_twice_makes_h_singular)
{
    int d = given_whole(T, "nodes"), l[2];
    num tau[2], size[2], H[4];
    given_points(T, "τ", d, 1, tau);
    given_points(T, "l", d, 1, size);
    for (int i = 0; i < d; i++)
        l[i] = (int)to_double_q(size[i]);
    G(osculation_matrix)(d, l, 1, tau, H);
    num determinant = G(determinant)(2, H), product = G(printed_determinant)(d, l, tau);
    found_points(T, "rows of H", 2, 2, H);
    found(T, "det H", determinant);
    found(T, "the product", product);
    about(T, "det H or the product is not 0");
    refute(T, is_zero_q(determinant) && is_zero_q(product));
}
#endif

/*
## The divided difference and its weights

:::{statement} wang-ch4:divided-difference-is-leading-coefficient
:title: The divided difference is the leading coefficient of the osculating polynomial
:zh: 广义差商即密切插值多项式的首项系数
:printed: by [14]: if $f(t)$ and the polynomial $g(t)=c_0+c_1t+\dots+c_kt^k$ of degree $k$ osculate on $T$, then the generalised divided difference of $f(t)$ at the knots
  $\{t_0,t_1,\dots,t_k\}$ is $[t_0,t_1,\dots,t_k]f=c_k$
:holds-by: divided_difference_is_leading_coefficient table_step_in_every_order derivative_lowers_the_multiplicity_by_one
:argued: every k | The table goes from one order to the next by `table_step_in_every_order`, and by `derivative_lowers_the_multiplicity_by_one` no second polynomial osculates.
:figure: osculating_polynomial

The left side is the table of divided differences.  $g$ has the degree $k$ at most; $c_k$ may be 0.
:::

A divided difference (差商) is defined by its table, and by Cramer's rule it is a quotient of determinants, since it is
the last unknown of the system.  The lemma of the source expands the upper determinant by its last column.

:::{claim} divided_difference_is_leading_coefficient
:title: The table of divided differences gives the leading coefficient
:zh: 差商表给出首项系数
:given: every set of multiplicities of $k+1$ nodes, the nodes and the coefficients of a polynomial of degree $k$ variables
:then: `divided_difference` of its values and derivatives is $c_k$
:method: The table has nothing of $f$ but its values and derivatives at the nodes, which are those of a $g$ that osculates $f$; so it
  is enough to know the claim for polynomials $g$.
:degrees: k = 0..6 sampled 8
:over: t#: different nodes; c#: coefficients
:defines: divided_difference
:control: $c_0$ on the right
:::
*/
CLAIM(divided_difference_is_leading_coefficient)
{
    int k = T->degree, l[LARGEST_ORDER];
    num tau[LARGEST_ORDER], c[LARGEST_ORDER], f[LARGEST_ORDER];
    G(increasing)(T, k + 1, tau);
    for (int a = 0; a <= k; a++)
        c[a] = unknown(T, "c", a);
    for (int count = G(compositions)(k, 6), m = 0; m < count; m++) {
        int d = G(composition)(k, G(pattern_number)(T, k, m), l), row = 0;
        for (int i = 0; i < d; i++)
            for (int j = 0; j < l[i]; j++, row++) {
                f[row] = from_int(0);
                for (int a = 0; a <= k; a++)
                    f[row] = add(f[row], mul(c[a], G(power_derivative)(a, j, tau[i])));
            }
        same(T, G(divided_difference)(d, l, tau, f), c[fault(T, k, 0)]);
    }
}

/*
What the table does is the same for every order: it makes of two polynomials that osculate on all nodes but one a polynomial that osculates on all.

:::{claim} table_step_in_every_order
:title: From two entries of the table to the next, whatever the order
:zh: 差商表的一步(任意阶数)
:types: field rational
:given: an order $k\ge1$; two different nodes $a=t_0$ and $b=t_k$; a function $f$ and polynomials $g_0=c_0U+r_0$, $g_1=c_1U+r_1$ at $t$, where $U=t^{k-1}$; a function with the
  derivatives $F_{s-1}$, $F_s$, $F_{s+1}$ of orders $s-1$, $s$, $s+1$ at $t$; all variables
:let: $g=\frac{(t-a)g_1-(t-b)g_0}{b-a}$
:then: (1) $f-g=\frac{(t-a)(f-g_1)-(t-b)(f-g_0)}{b-a}$; (2) $g=\frac{c_1-c_0}{b-a}\,tU+\frac{t\,(r_1-r_0)-a\,g_1+b\,g_0}{b-a}$; (3) the derivative of
  $(t-a)F_s+sF_{s-1}$ is $(t-a)F_{s+1}+(s+1)F_s$
:method: By (3) $(t-a)F$ has the derivatives $(t-a)F_s+sF_{s-1}$: at $a$ one more of them vanishes than of $F$, elsewhere as many.  Let $g_0$ osculate $f$ on
  $t_0,\dots,t_{k-1}$ and $g_1$ on $t_1,\dots,t_k$.  By (1) $g$ osculates $f$ on all, as the factors $t-a$ and $t-b$ make up for the node that is missing, and by (2) its coefficient of
  $t^k$ is the entry of the table, if $c_0$ and $c_1$ are the two before.  Where all nodes are one, the entry $f^{(k)}/k!$ is the leading coefficient of the polynomial of Taylor.  No other
  polynomial of degree at most $k$ osculates $f$: the difference of two is divisible by the product of $k+1$ factors (`derivative_lowers_the_multiplicity_by_one`).
:over: t#: different nodes; x f c# r# F# U s: -
:control: $g_0$ and $g_1$ exchanged in $g$
:::
*/
CLAIM(table_step_in_every_order)
{
    num t[2], x = unknown(T, "x", 0), U = unknown(T, "U", 0), f = unknown(T, "f", 0), r[2], c[2], g[2], F[3];
    G(increasing)(T, 2, t);
    for (int m = 0; m < 2; m++) {
        r[m] = unknown(T, "r", m);
        c[m] = unknown(T, "c", m);
        g[m] = add(mul(c[m], U), r[m]);
    }
    num length = sub(t[1], t[0]), up = sub(x, t[0]), down = sub(x, t[1]);
    num both = div(sub(mul(up, g[fault(T, 1, 0)]), mul(down, g[fault(T, 0, 1)])), length);
    about(T, "what is missing to f");
    same(T, sub(f, both), div(sub(mul(up, sub(f, g[1])), mul(down, sub(f, g[0]))), length));
    about(T, "the highest power");
    num rest = add(sub(mul(x, sub(r[1], r[0])), mul(t[0], g[1])), mul(t[1], g[0]));
    same(T, both, add(mul(div(sub(c[1], c[0]), length), mul(x, U)), div(rest, length)));
    num s = whole(T, "s", 0, 9);
    for (int m = 0; m < 3; m++)
        F[m] = unknown(T, "F", m);
    about(T, "one derivative more"); /* (up F_s)' + s F_s, as up' = 1 */
    same(T, add(add(F[1], mul(up, F[2])), mul(s, F[1])), add(mul(up, F[2]), mul(add(s, from_int(1)), F[1])));
}

/*
:::{statement} wang-ch4:formula-4.4.7
:title: The divided difference as a quotient of determinants
:zh: 差商的行列式之比表示
:printed: [t_0,t_1,\dots,t_k]f=c_k=\det H(T;1,t,\dots,t^{k-1},f)/\det H(T;1,t,\dots,t^k)
:holds-by: cramers_rule_gives_divided_difference divided_difference_is_leading_coefficient
:argued: every k | The difference is $c_k$ for every $k$ (`divided-difference-is-leading-coefficient`).  $f$ and $g$ have the same data, so the last column of the upper determinant is the sum of $c_m$ times the columns of the powers.  A column that is there twice adds
  nothing, and the determinant is $c_k$ times the lower one, which is not 0 (`formula-4.4.6-determinant`).
:needs: node_listed_twice_makes_h_singular | (4.4.5): $\tau_1<\tau_2<\dots<\tau_d$ | equal nodes are counted by multiplicity: so the $\tau_i$ differ
:::

:::{claim} cramers_rule_gives_divided_difference
:title: The quotient of the determinants is the divided difference
:zh: Cramer 法则给出差商
:given: every set of multiplicities of $k+1$ nodes, the nodes and the $k+1$ values and derivatives of $f$ variables
:then: $\det H(T;1,\dots,t^{k-1},f)/\det H(T;1,\dots,t^k)$ is the divided difference of the table
:method: Both determinants are computed from the matrices.
:degrees: k = 0..5 sampled 7
:over: t#: different nodes; f#: data of the function
:control: $f$ in the first column, in the place of the powers $t^0$
:::
*/
CLAIM(cramers_rule_gives_divided_difference)
{
    int k = T->degree, l[LARGEST_ORDER];
    num tau[LARGEST_ORDER], H[LARGEST_ORDER * LARGEST_ORDER], f[LARGEST_ORDER];
    G(increasing)(T, k + 1, tau);
    for (int a = 0; a <= k; a++)
        f[a] = unknown(T, "f", a);
    for (int count = G(compositions)(k, 3), m = 0; m < count; m++) {
        int d = G(composition)(k, G(pattern_number)(T, k, m), l);
        G(osculation_matrix)(d, l, k, tau, H);
        num below = G(determinant)(k + 1, H);
        for (int row = 0; row <= k; row++)
            H[row * (k + 1) + fault(T, k, 0)] = f[row];
        /* det H(T; 1, ..., t^k-1, f) / det H(T; 1, ..., t^k) = [t_0, ..., t_k]f */
        same(T, div(G(determinant)(k + 1, H), below), G(divided_difference)(d, l, tau, f));
    }
}

/*
:::{statement} wang-ch4:lemma-4.4.1
:title: The divided difference as a sum over values and derivatives
:zh: 引理 4.4.1 差商的显式表示
:printed: the divided difference of order $k$ of a function $f$ on the knot vector $T$ of (4.4.5) is explicitly
  $[t_0,t_1,\dots,t_k]f=\sum_{i=1}^d\sum_{j=0}^{l_i-1}\alpha_{ij}(T)f^{(j)}(\tau_i)$, with the $\alpha_{ij}(T)$ of (4.4.9)
:holds-by: printed_weights_give_divided_difference
:argued: every k | The upper determinant of (4.4.7), which is true for every $k$, expanded by its last column: in row $b(i,j)$, counted from 0, stands $f^{(j)}(\tau_i)$, and the cofactors there
  do not contain $f$; the lower one is the product (`formula-4.4.6-determinant`).
:needs: node_listed_twice_makes_h_singular | (4.4.5): $\tau_1<\tau_2<\dots<\tau_d$ | equal nodes are counted by multiplicity: so the $\tau_i$ differ
:figure: osculating_polynomial
:::
*/

/* Formula (4.4.9), the sets counted from 0: the number of derivative j of node i. */
static int G(printed_place)(int i, int j, const int l[])
{
    int b = j;
    for (int c = 0; c <= i - 1; c++)
        b += l[c];
    return b;
}

/* The printed weights; shift = 1 takes the elements of the last column as counted from 1. */
static void G(printed_weights)(int d, const int l[], int k, const num tau[], int shift, int minors, num alpha[])
{
    num H[LARGEST_ORDER * LARGEST_ORDER], below = G(printed_determinant)(d, l, tau);
    G(osculation_matrix)(d, l, k, tau, H);
    for (int i = 0, row = 0; i < d; i++)
        for (int j = 0; j < l[i]; j++, row++) {
            int b = G(printed_place)(i, j, l) - shift;
            num beta = b >= 0 ? G(cofactor)(k + 1, H, b, k) : from_int(0);
            alpha[row] = div(minors ? G(signed_by)(b + k, beta) : beta, below);
        }
}

/*
Thus the weights are cofactors (代数余子式) over the determinant, and the only difficulty is to say which place of the
column belongs to which derivative: $b(i,j)$ counts the rows, from 0.

:::{claim} printed_weights_give_divided_difference
:title: The printed weights are those of the kernel, and they give the divided difference
:zh: 按 (4.4.8)、(4.4.9) 计算的差商
:given: every set of multiplicities of $k+1$ nodes, the nodes and the values and derivatives of $f$ variables
:let: $\beta_b$ the cofactor of element $b$ of the last column of $H(T;1,\dots,t^k)$, $b=0,\dots,k$
:then: $\alpha_{ij}=\beta_{b(i,j)}/\det$, with the product and the $b(i,j)$ of (4.4.9), is
  what `divided_weights` computes from power series, and $\sum\alpha_{ij}f^{(j)}(\tau_i)=[t_0,\dots,t_k]f$
:method: The cofactors are determinants of order $k$ of the matrix of derivatives.
:degrees: k = 0..5 sampled 7
:over: t#: different nodes; f#: data of the function
:defines: divided_weights
:control: minors in the place of cofactors
:::
*/
CLAIM(printed_weights_give_divided_difference)
{
    int k = T->degree, l[LARGEST_ORDER];
    num tau[LARGEST_ORDER], alpha[LARGEST_ORDER], weight[LARGEST_ORDER], f[LARGEST_ORDER];
    G(increasing)(T, k + 1, tau);
    for (int a = 0; a <= k; a++)
        f[a] = unknown(T, "f", a);
    for (int count = G(compositions)(k, 2), m = 0; m < count; m++) {
        int d = G(composition)(k, G(pattern_number)(T, k, m), l);
        num sum = from_int(0);
        G(printed_weights)(d, l, k, tau, 0, fault(T, 0, 1), alpha);
        G(divided_weights)(d, l, tau, weight);
        about(T, "printed weights and the kernel's");
        for (int b = 0; b <= k; b++) {
            same(T, alpha[b], weight[b]);
            sum = add(sum, mul(alpha[b], f[b]));
        }
        about(T, "their sum and the divided difference");
        /* Σ α_ij f^(j)(τ_i) = [t_0, ..., t_k]f */
        same(T, sum, G(divided_difference)(d, l, tau, f));
    }
}

/*
:::{statement} wang-ch4:formula-4.4.8
:title: The divided difference as a sum over the data
:zh: (4.4.8) 差商的求和式
:printed: [t_0,t_1,\dots,t_k]f=\sum_{i=1}^d\sum_{j=0}^{l_i-1}\alpha_{ij}(T)f^{(j)}(\tau_i)
:holds-by: printed_weights_give_divided_difference
:argued: every k | The upper determinant of (4.4.7), which is true for every $k$, expanded by its last column: in row $b(i,j)$, counted from 0, stands $f^{(j)}(\tau_i)$, and the cofactors there
  do not contain $f$; the lower one is the product (`formula-4.4.6-determinant`).
:needs: node_listed_twice_makes_h_singular | (4.4.5): $\tau_1<\tau_2<\dots<\tau_d$ | equal nodes are counted by multiplicity: so the $\tau_i$ differ
:figure: osculating_polynomial

The sum is that of `lemma-4.4.1`, and the number (4.4.8) stands at it.
:::
*/

#if RATIONAL
/*
:::{claim} places_count_the_rows
:title: b(i,j) runs through 0, ..., k in the order of the rows
:zh: b(i,j) 依次取 0,…,k
:kind: decision
:given: every set of multiplicities of $k+1$ nodes
:then: the printed $b(i,j)$ is the number of the row of $f^{(j)}(\tau_i)$, counted from 0
:method: The rows are counted one by one.
:degrees: k = 0..7
:argued: every k | Before the rows of node $i$ stand those of the nodes $1,\dots,i-1$, $l_c$ of each.
:control: $b(i,j)=j$ for all $i$
:::
*/
CLAIM(places_count_the_rows)
{
    int k = T->degree;
    for (int m = 0; m < 1 << k; m++) {
        int l[LARGEST_ORDER], d = G(composition)(k, m, l), row = 0;
        for (int i = 0; i < d; i++)
            for (int j = 0; j < l[i]; j++, row++)
                agree(T, fault(T, G(printed_place)(i, j, l), j) == row);
    }
}

/*
:::{statement} wang-ch4:lemma-4.4.1-step
:title: From the quotient of determinants to the lemma
:zh: 引理 4.4.1 的推导
:printed: expanding the determinant in the numerator of (4.4.7) by its last column gives lemma 4.4.1
:holds-by: cramers_rule_gives_divided_difference printed_weights_give_divided_difference confluent_vandermonde_determinant_is_product
:argued: every order | The upper determinant of (4.4.7), which is true for every $k$, expanded by its last column: in row $b(i,j)$, counted from 0, stands $f^{(j)}(\tau_i)$, and the cofactors there
  do not contain $f$; the lower one is the product (`formula-4.4.6-determinant`).
:needs: node_listed_twice_makes_h_singular | (4.4.5): $\tau_1<\tau_2<\dots<\tau_d$ | equal nodes are counted by multiplicity: so the $\tau_i$ differ

The order that is told is $k$, that of the divided difference.
:::

:::{statement} wang-ch4:formula-4.4.9
:title: The weights as cofactors
:zh: 系数 α_ij 由代数余子式给出
:printed: $\alpha_{ij}(T)=\beta_{b(i,j)}\Big/\Big(\prod_{1\le u<v\le d}(\tau_v-\tau_u)^{l_ul_v}\prod_{u=1}^d
  \prod_{v=0}^{l_u-1}v!\Big)$, where $\beta_i$ $(i=0,1,\dots,k)$ is the cofactor of element $i$ of the last column of $H(T;1,t,\dots,t^k)$
:holds-by: printed_weights_give_divided_difference
:argued: every k | The upper determinant of (4.4.7), which is true for every $k$, expanded by its last column: in row $b(i,j)$, counted from 0, stands $f^{(j)}(\tau_i)$, and the cofactors there
  do not contain $f$; the lower one is the product (`formula-4.4.6-determinant`).
:needs: node_listed_twice_makes_h_singular | (4.4.5): $\tau_1<\tau_2<\dots<\tau_d$ | equal nodes are counted by multiplicity: so the $\tau_i$ differ
:meant: the words behind the formula: $\beta_i$ $(i=0,1,\dots,k)$ | The elements of the last column are counted from 0.
:reading: counting_from_one_shifts_the_weights | with the elements of the last column counted from 1, so that $\beta_1$ belongs to the first, the $\alpha_{ij}(T)$ are the weights of
  (4.4.8)

The formula for $\alpha_{ij}(T)$ is printed twice.
:::

:::{claim} counting_from_one_shifts_the_weights
:title: With the elements of the column counted from 1 the weights belong to other places
:zh: 若从 1 起数则系数错位
:kind: counterexample
:given: $k=1$, two nodes $\tau$ and the values $f$ there
:data: τ = 0 1; f = 1 0
:then: with the cofactor of the first element for $\beta_1$, and 0 for $\beta_0$, which then belongs to no element, the weights have another sum with the
  values of $f$ than $[\tau_1,\tau_2]f$
:result: weights = 0 -1; the sum with these weights = 0; the divided difference = -1
:method: The weights are computed with the places shifted by one.
:control: the places counted from 0
:::
*/
CLAIM(counting_from_one_shifts_the_weights)
{
    int l[2] = {1, 1};
    num tau[2], f[2], alpha[2];
    given_points(T, "τ", 2, 1, tau);
    given_points(T, "f", 2, 1, f);
    G(printed_weights)(2, l, 1, tau, fault(T, 0, 1), 0, alpha);
    num sum = add(mul(alpha[0], f[0]), mul(alpha[1], f[1])), difference = G(divided_difference)(2, l, tau, f);
    found_points(T, "weights", 2, 1, alpha);
    found(T, "the sum with these weights", sum);
    found(T, "the divided difference", difference);
    about(T, "the sum with these weights, and the divided difference");
    same(T, sum, difference);
}
#endif

/*
:::{statement} wang-ch4:formula-4.4.9-index
:title: The place of a derivative in the column
:zh: 行标 b(i,j)
:printed: b(i,j)=j\ (i=1),\quad b(i,j)=j+\sum_{c=1}^{i-1}l_c\ (i>1),\quad i=1,2,\dots,d;\ j=0,1,\dots,l_i-1
:holds-by: printed_weights_give_divided_difference
:argued: every order | The upper determinant of (4.4.7), which is true for every $k$, expanded by its last column: in row $b(i,j)$, counted from 0, stands $f^{(j)}(\tau_i)$, and the cofactors there
  do not contain $f$; the lower one is the product (`formula-4.4.6-determinant`).
:confirmed-by: places_count_the_rows

The places are the numbers $0,\dots,k$, each once.  The order that is told is $k$, that of the divided difference.
:::

:::{statement} wang-ch4:lemma-4.4.1-independent
:title: The weights depend on the nodes, not on the function
:zh: 系数依赖于节点而与 f 无关
:printed: \alpha_{ii}(T)\ \text{depends on }T\text{ and not on }f
:holds-by: printed_weights_give_divided_difference weights_are_the_only_ones
:argued: every order | The lemma is true for every $k$, and data of which one is 1 and the others are 0 give the weights one by one.
:needs: node_listed_twice_makes_h_singular | (4.4.5): $\tau_1<\tau_2<\dots<\tau_d$ | equal nodes are counted by multiplicity: so the $\tau_i$ differ
:meant: (4.4.9), whose numbers are the $\alpha_{ij}(T)$ | All $\alpha_{ij}(T)$, of which the indices are printed $ii$, see `notation-4.4`.

Only nodes and multiplicities enter the cofactors, and because the values of $f$ are free no other weights give the divided difference of every $f$.  The order that is told is $k$, that of the divided difference.
:::

That the weights do not depend on $f$ can be read off.  That they are the only ones that serve for all $f$ follows
from trying functions with a single datum that is not 0.

:::{claim} weights_are_the_only_ones
:title: Other weights give another functional
:zh: 系数的唯一性
:given: every set of multiplicities of $k+1$ nodes, arbitrary numbers $\gamma_{ij}$
:then: for the $f$ whose only nonzero datum is $f^{(j)}(\tau_i)=1$ the sum with $\gamma$ is $\gamma_{ij}$ and the
  divided difference is $\alpha_{ij}$; so the sums agree for all $f$ only when $\gamma=\alpha$
:method: The table of divided differences on each unit vector of data against the weights of the kernel.
:degrees: k = 0..6 sampled 8
:over: t#: different nodes
:control: the data of the neighbouring unit vector
:::
*/
CLAIM(weights_are_the_only_ones)
{
    int k = T->degree, l[LARGEST_ORDER];
    num tau[LARGEST_ORDER], alpha[LARGEST_ORDER], f[LARGEST_ORDER];
    G(increasing)(T, k + 1, tau);
    for (int count = G(compositions)(k, 3), m = 0; m < count; m++) {
        int d = G(composition)(k, G(pattern_number)(T, k, m), l);
        G(divided_weights)(d, l, tau, alpha);
        for (int b = 0; b <= k; b++) {
            for (int a = 0; a <= k; a++)
                f[a] = from_int(a == fault(T, b, (b + 1) % (k + 1)));
            same(T, G(divided_difference)(d, l, tau, f), alpha[b]);
        }
    }
}

#include "chapters/judge/claims_off.h"
