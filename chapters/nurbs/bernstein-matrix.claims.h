/*
# The matrix of the Bernstein basis (Bernstein 基的系数矩阵)

Between two knots of multiplicity $k$ the B-splines are the Bernstein polynomials, whose matrix every student can
write down by expanding $(1-t)^{k-1-i}$.  The source obtains it from its general formulas, by way of the coefficients
$\omega_{i,k}$ of Marsden's identity; the printed result has its indices exchanged and a quotient for a product.
*/
#include "chapters/nurbs/spans.h"

#include "chapters/judge/claims_on.h"

enum { CELLS = LARGEST_ORDER * LARGEST_ORDER };

/*
With $k$ knots 0 and $k$ knots 1, numbered from 0, the span is $[t_{k-1},t_k)=[0,1)$, $r=k-1$, and $i=0,\dots,k-1$.

:::{statement} wang-ch4:bernstein-omega
:title: Marsden's coefficients for the knots of Bernstein
:zh: Bernstein 节点的 ω
:printed: for $T=\{0,0,\dots,0,1,1,\dots,1\}$, by (4.4.14): $\omega_{i,k}(x)=x^{k-1-i}(x-1)^i$, $i=0,1,\dots,k-1$
:holds-by: bernstein_knots_in_every_order bernstein_knots_of_every_function
:confirmed-by: bernstein_coefficients_and_g
:needs: bernstein_knots_from_one_shift_the_index | the span printed with it, $[t_{k-1},t_k)=[0,1)$ | the knots are numbered
  from 0, $t_0=\dots=t_{k-1}=0$; the points of (4.1.1) are numbered from 1
:figure: bernstein_matrix

How often each of the two numbers stands in $T$ is not printed; here it is $k$ times, which are the $2k$ knots of the functions $i=0,\dots,k-1$.  The first and the last of them
stand in none of the formulas.
:::

:::{statement} wang-ch4:bernstein-g
:title: The matrix G for the knots of Bernstein
:zh: Bernstein 情形的矩阵 G
:printed: for $T=\{0,0,\dots,0,1,1,\dots,1\}$, by (4.4.18), (4.4.19): $g_{ji}=0$ $(i<j)$, $g_{ji}=\binom ij\Big/\binom{k-1}j$ $(i\ge j)$, $i,j=0,1,\dots,k-1$
:holds-by: coefficients_of_marsden_in_every_order bernstein_knots_of_every_function
  symmetric_functions_of_zeros_and_ones
:confirmed-by: bernstein_coefficients_and_g
:needs: bernstein_knots_from_one_shift_the_index | the matrix and the span printed with it, $\mathbf G_{k-1,k,T}$ and $[t_{k-1},t_k)=[0,1)$ | the knots are numbered
  from 0, $t_0=\dots=t_{k-1}=0$
:figure: bernstein_matrix
:::

:::{statement} wang-ch4:bernstein-g-triangular
:title: G is upper triangular
:zh: G 为上三角阵
:printed: for $T=\{0,0,\dots,0,1,1,\dots,1\}$, by (4.4.18), (4.4.19), $\mathbf G_{k-1,k,T}$ is upper triangular
:holds-by: coefficients_of_marsden_in_every_order bernstein_knots_of_every_function
  symmetric_functions_of_zeros_and_ones
:confirmed-by: bernstein_coefficients_and_g
:figure: bernstein_matrix

$\mathbf G$ has $g_{ji}$ in row $j$ and column $i$, and $g_{ji}=0$ for $i<j$, see `bernstein-g`.  Another numbering of the knots around the span $[0,1)$ changes the
indices of the columns, and not their order.
:::
*/

/* B_i^n(t) = C(n,i) (1-t)^{n-i} t^i */
static num G(bernstein_value)(int n, int i, num t)
{
    return mul(G(choose)(n, i), mul(G(power)(sub(from_int(1), t), n - i), G(power)(t, i)));
}

static struct G(span) G(bernstein_span)(int k) { return G(span_of_pattern)(k, 0, (num[]){from_int(0), from_int(1)}); }

/*
For these knots $\omega_{i,k}$ has only the zeros 0 and 1, and $G$ is a triangular matrix of quotients of binomial
coefficients: it takes the Bernstein basis to the powers.

:::{claim} bernstein_knots_in_every_order
:title: Marsden's coefficients for the knots of Bernstein, in every order
:zh: Bernstein 节点的 ω(任意阶数)
:types: field rational
:given: $i,m\ge0$, $k=i+2+m$, the knots $t_0=\dots=t_{k-1}=0$, $t_k=\dots=t_{2k-1}=1$; the common factor $q$ of $\omega_{i,k}$ and
  $\omega_{i+1,k}$; $x$
:let: $P=x^{k-2-i}(x-1)^i$
:then: $t_{i+1}=0$ and $t_{i+k}=1$, since $k-1-(i+1)=m\ge0$, $i+k\ge k$ and $2k-1-(i+k)=m+1>0$; so $\omega_{i,k}=q\,(x-0)$, $\omega_{i+1,k}=q\,(x-1)$, and with
  $q=P$ they are $x^{k-1-i}(x-1)^i$ and $x^{k-2-i}(x-1)^{i+1}$
:method: The step of an induction on $i$; $\omega_{0,k}$ is the product of $k-1$ factors $x$, by `bernstein_knots_of_every_function` for $i=0$.
:degrees: all
:over: x; k: -; i m q P: -
:control: $t_{i+k}=0$
:::
*/
CLAIM(bernstein_knots_in_every_order)
{
    num i = whole(T, "i", 0, 9), m = whole(T, "m", 0, 9), one = from_int(1), zero = from_int(0), x = unknown(T, "x", 0);
    num k = add(add(i, m), from_int(2)), last = sub(add(k, k), one), P = unknown(T, "P", 0);
    about(T, "the places of the two knots");
    same(T, sub(sub(k, one), add(i, one)), m);
    same(T, sub(add(i, k), k), i);
    same(T, sub(last, add(i, k)), add(m, one));
    about(T, "from one coefficient to the next"); /* P x^a (x-1)^b: one x less, one x - 1 more */
    num here = mul(P, sub(x, zero)), next = mul(P, sub(x, fault(T, one, zero)));
    same(T, mul(here, sub(x, one)), mul(next, x));
}

/*
:::{claim} bernstein_knots_of_every_function
:title: The knots inside the support of each function, for the knots of Bernstein
:zh: Bernstein 情形各基函数的内节点
:types: field rational
:given: $i,m\ge0$, $k=i+1+m$, the knots $t_0=\dots=t_{k-1}=0$, $t_k=\dots=t_{2k-1}=1$
:then: of the knots $t_{i+1},\dots,t_{i+k-1}$ those to $t_{k-1}$ are $0$, which are $k-1-i=m$, and those from $t_k$ are $1$, which are $i$
:method: The numbers of indices from $i+1$ to $k-1$ and from $k$ to $i+k-1$.
:degrees: all
:over: k i m: -
:control: the indices to $i+k$
:::
*/
CLAIM(bernstein_knots_of_every_function)
{
    num i = whole(T, "i", 0, 9), m = whole(T, "m", 0, 9), one = from_int(1), k = add(add(i, m), one);
    num last = fault(T, sub(add(i, k), one), add(i, k));
    about(T, "the number of zeros");
    same(T, sub(k, add(i, one)), m);
    about(T, "the number of ones");
    same(T, sub(add(last, one), k), i);
}

/*
:::{claim} symmetric_functions_of_zeros_and_ones
:title: The symmetric functions of zeros and ones
:zh: 由 0 与 1 组成的数组的对称函数
:types: field rational
:given: symmetric functions $S_j=\mathrm{Sym}_j$ and $S_{j-1}$ of some numbers; integers $j,h\ge1$
:let: $c=\binom{j+h-1}j$, so that $\binom{j+h-1}{j-1}=c\frac jh$ and $\binom{j+h}j=c\frac{j+h}h$
:then: one number $0$ more leaves $\mathrm{Sym}_j$ what it is, and one number $1$ more makes $\binom{j+h-1}j$ of it $\binom{j+h}j$
:method: It is $S_j+bS_{j-1}$ for $b=0$ and $b=1$, so that of $k-1-i$ numbers $0$ and $i$ numbers $1$ it is $\binom ij$, which is $0$ for $i<j$: of
  no numbers $\mathrm{Sym}_0=1$ and the others are $0$; a sum of zeros is $0$; of $j$ numbers $1$, where $S_j=0$ and $S_{j-1}=1$, it is $0+1=\binom jj$; and $\mathrm{Sym}_0$ is
  always $1$.
:degrees: all
:over: j h c S#: -
:control: $\binom{j+h-1}{j-1}=c\frac{j+1}h$
:::
*/
CLAIM(symmetric_functions_of_zeros_and_ones)
{
    num one = from_int(1), zero = from_int(0);
    num j = whole(T, "j", 1, 9), h = whole(T, "h", 1, 9), c = unknown(T, "c", 0);
    num S[2] = {unknown(T, "S", 0), unknown(T, "S", 1)};
    about(T, "no numbers"); /* the coefficients of the product of no factors */
    same(T, G(choose)(0, 0), G(power)(S[0], 0));
    same(T, G(choose)(0, 1), zero);
    about(T, "as many numbers as factors");
    same(T, add(zero, mul(one, one)), G(choose)(1, 1));
    about(T, "one number more");
    same(T, add(S[0], mul(zero, S[1])), S[0]);
    same(T, add(c, mul(one, div(mul(c, fault(T, j, add(j, one))), h))), div(mul(c, add(j, h)), h));
}

/*
:::{claim} bernstein_coefficients_and_g
:title: Marsden's coefficients and G for the knots of Bernstein
:zh: Bernstein 节点的 ω 与 G
:given: orders $k$, $x$ variable
:then: $\omega_{i,k}(x)=x^{k-1-i}(x-1)^i$, and $g_{ji}$ is as printed, 0 below the diagonal
:method: The kernels `marsden_coefficients` and `marsden_matrix` at these knots.
:degrees: 0..7 sampled 8
:over: x
:control: rows and columns of $G$ exchanged
:::
*/
CLAIM(bernstein_coefficients_and_g)
{
    int k = T->degree + 1;
    struct G(span) S = G(bernstein_span)(k);
    num x = unknown(T, "x", 0), w[LARGEST_ORDER], g[CELLS];
    G(marsden_coefficients)(k - 1, S.t, S.r, x, w);
    G(marsden_matrix)(k - 1, S.t, S.r, g);
    for (int i = 0; i < k; i++) {
        about(T, "omega");
        /* ω_i,k(x) = x^(k-1-i) (x - 1)^i */
        same(T, w[i], mul(G(power)(x, k - 1 - i), G(power)(sub(x, from_int(1)), i)));
        about(T, "G");
        for (int j = 0; j < k; j++) {
            num printed = i < j ? from_int(0) : div(G(choose)(i, j), G(choose)(k - 1, j));
            same(T, fault(T, g[j * k + i], g[i * k + j]), printed);
        }
    }
}

#if RATIONAL
/*
:::{claim} bernstein_knots_from_one_shift_the_index
:title: With functions numbered from 1 the formulas for omega, G and the B-splines are shifted
:zh: 若下标从 1 起则 ω、G 与基函数错位
:kind: counterexample
:given: $k=2$, the knots $t_1,\dots,t_4$, whose functions are $N_{1,2}$ and $N_{2,2}$; $i$ and $x$, and a $t$ of $[t_2,t_3)$
:data: t_1, ..., t_4 = 0 0 1 1; i = 1; x = 2; t = 1/4
:then: $\omega_{1,2}(x)=x-t_2$, the formula gives $x^{1-i}(x-1)^i$, which is another number; $g_{1i}=t_2$ is not $\binom i1\big/\binom11$; and $N_{1,2}(t)=1-t$ is not $B_1^1(t)=t$
:result: ω_i,2(x) = 2; the formula = 1; g_1i = 0; its formula = 1; N_i,2(t) = 3/4; B_i^1(t) = 1/4
:method: The product of its definition, the entry of `marsden_matrix` and the B-spline by its definition, against the formulas.
:control: the knots $t_0,\dots,t_3$
:::
*/
CLAIM(bernstein_knots_from_one_shift_the_index)
{
    num t[4], w[2], g[4];
    given_points(T, "t_1, ..., t_4", 4, 1, t);
    int i = given_whole(T, "i"), first = fault(T, 0, 1);
    num x = given(T, "x"), formula = mul(G(power)(x, 1 - i), G(power)(sub(x, from_int(1)), i));
    G(marsden_coefficients)(1, t, 1, x, w);
    G(marsden_matrix)(1, t, 1, g);
    num entry = g[2 + i - first], quotient = div(G(choose)(i, 1), G(choose)(1, 1)), at = given(T, "t");
    struct G(span) S = G(span_of_pattern)(2, 0, (num[]){t[0], t[2]});
    num value = G(basis_value)(&S, i - first, 2, at), bernstein = G(bernstein_value)(1, i, at);
    found(T, "ω_i,2(x)", w[i - first]);
    found(T, "the formula", formula);
    found(T, "g_1i", entry);
    found(T, "its formula", quotient);
    found(T, "N_i,2(t)", value);
    found(T, "B_i^1(t)", bernstein);
    about(T, "ω_1,2(x), and the formula");
    same(T, w[i - first], formula);
    about(T, "g_1i, and its formula");
    same(T, entry, quotient);
    about(T, "N_1,2(t), and B_1^1(t)");
    same(T, value, bernstein);
}
#endif

/*
:::{statement} wang-ch4:bernstein-matrix
:title: The coefficient matrix for the knots of Bernstein
:zh: Bernstein 情形的系数矩阵
:printed: for $T=\{0,0,\dots,0,1,1,\dots,1\}$, by (4.4.17), on the interval $[t_{k-1},t_k)=[0,1)$ the elements of $\mathbf A_{r,k,T}$ are $a_{ji}=0$ $(i<j)$, $a_{ji}=(-1)^{i+j}\binom{k-1}i\Big/\binom ij$ $(i\ge j)$,
  $i,j=0,1,\dots,k-1$
:class: misprint
:refuted-by: printed_bernstein_matrix_is_transposed printed_bernstein_quotient_fails
:corrected: a_{ji}=0\ (j<i),\quad a_{ji}=(-1)^{i+j}\binom{k-1}j\binom ji\ (j\ge i)
:corrected-by: bernstein_functions_in_every_order outer_functions_are_made_of_outer_ones
  bernstein_powers_in_every_degree
:confirmed-by: bernstein_matrix_is_the_matrix
:needs: polynomial_of_a_span_ends_with_it | the line itself: on $[t_{k-1},t_k)=[0,1)$ | $t$ lies in the span
:needs: bernstein_knots_from_one_shift_the_index | the line itself: $[t_{k-1},t_k)=[0,1)$ | the knots are numbered
  from 0, $t_0=\dots=t_{k-1}=0$; the example is of the functions, whose coefficients the elements are
:striking: 10
:figure: bernstein_matrix

Two faults: the two indices are exchanged, so that the matrix is triangular on the wrong side, and the two binomial
coefficients are divided and not multiplied.  To mend one of them is not enough.
:::
*/

/*
The matrix of the Bernstein polynomials is triangular and has products of the binomial coefficients with alternating signs.
On which side, one sees from the polynomials: $B_i^{k-1}$ is divisible by $t^i$, so column $i$ begins with $i$ zeros.

:::{claim} bernstein_functions_in_every_order
:title: From one order to the next, for the knots of Bernstein
:zh: Bernstein 情形的递推(任意阶数)
:types: field
:given: the knots $t_0=\dots=t_{k-1}=0$, $t_k=\dots=t_{2k-1}=1$, the span $[t_{k-1},t_k)$; integers $j,h\ge1$, $n=j+h$; the order $m=n+1\le k$ and $i=k-m+j$; $t$
:let: $c=\binom{n-1}j$, so that $\binom{n-1}{j-1}=c\frac jh$ and $\binom nj=c\frac{j+h}h$; $U=t^{j-1}(1-t)^{h-1}$
:then: (1) $k-1-(i+1)=h-1\ge0$ and $(i+m-1)-k=j-1\ge0$, so that $t_i=t_{i+1}=0$ and $t_{i+m-1}=t_{i+m}=1$, and $N_{i,m}(t)=\frac{t-0}{1-0}N_{i,m-1}(t)+\frac{1-t}{1-0}N_{i+1,m-1}(t)$;
  (2) of these two, number $j-1$ and number $j$ of their order, $t\cdot c\frac jhU(1-t)+(1-t)\cdot c\,Ut=c\frac{j+h}hUt(1-t)$, which is $B_j^n(t)$ from $B_{j-1}^{n-1}(t)$ and $B_j^{n-1}(t)$
:method: The step of an induction on $m$ for $N_{k-m+j,m}=B_j^{m-1}$ on the span, $j=0,\dots,m-1$; for $m=k$ it is $N_{j,k}=B_j^{k-1}$.  For $j=0$ the first and for $j=n$ the second
  of the two functions vanishes on the span (`outer_functions_are_made_of_outer_ones`), and $(1-t)(1-t)^{n-1}$ and $t\cdot t^{n-1}$ are left.  $N_{k-1,1}=1=B_0^0$.
:degrees: all
:scope: the knots of Bernstein
:over: t; k j h c U: -
:control: the two fractions exchanged
:::
*/
#if FIELD
CLAIM(bernstein_functions_in_every_order)
{
    num j = whole(T, "j", 1, 9), h = whole(T, "h", 1, 9), k = whole(T, "k", 20, 30), one = from_int(1),
        zero = from_int(0);
    num n = add(j, h), m = add(n, one), i = add(sub(k, m), j);
    about(T, "the places of the knots");
    same(T, sub(sub(k, one), add(i, one)), sub(h, one));
    same(T, sub(sub(add(i, m), one), k), sub(j, one));
    num t = parameter(T, "t"), c = unknown(T, "c", 0), U = unknown(T, "U", 0), fall = sub(one, t);
    num first = mul(mul(div(mul(c, j), h), U), fall), second = mul(mul(c, U), t); /* B_{j-1}^{n-1}, B_j^{n-1} */
    num rise = div(sub(t, zero), sub(one, zero)), other = div(fall, sub(one, zero));
    about(T, "from one order to the next");
    same(T, add(mul(fault(T, rise, other), first), mul(fault(T, other, rise), second)),
         mul(div(mul(c, n), h), mul(U, mul(t, fall))));
}
#endif

/*
:::{claim} bernstein_powers_in_every_degree
:title: The Bernstein polynomials in powers of t, whatever the degree
:zh: Bernstein 基按 t 的幂展开(任意次数)
:types: field
:given: integers $i,d,e\ge0$, $j=i+d$, $n=i+d+e$; integers $g,h\ge1$, $m=g+h-1$, $\sigma=(-1)^g$
:harmless: $i,d,e\ge0$ | these are all $i\le j\le n$
:let: $A=i!$, $D=d!$, $E=e!$, $J=j!$, $M=(d+e)!$, $N=n!$, so that $\binom ni=\frac N{AM}$, $\binom{n-i}d=\frac M{DE}$, $\binom nj=\frac N{JE}$, $\binom ji=\frac J{AD}$;
  $c=\binom mg$, so that $\binom m{g-1}=c\frac gh$ and $\binom{m+1}g=c\frac{g+h}h$
:then: (1) $(1-t)\bigl(\dots-\sigma c\frac gh\,t^{g-1}+\sigma c\,t^g\dots\bigr)$ has at $t^g$ the factor $\sigma c\frac{g+h}h$; (2)
  $\binom ni\binom{n-i}d=\binom nj\binom ji$, and the exponents $d$ and $i+j$ of $-1$ differ by $2i$
:method: (1) is the step of an induction on $m$ for $(1-t)^m=\sum_g(-1)^g\binom mgt^g$, in which all letters are variables; at $t^0$ it is $1$, at $t^{m+1}$ it is $-(-1)^m$, and
  $(1-t)^0=1$.  So $\binom ni(1-t)^{n-i}t^i$ has at $t^{i+d}$ the factor $(-1)^d\binom ni\binom{n-i}d$, and nothing before $t^i$; (2) is that this is $(-1)^{i+j}\binom nj\binom ji$.
:degrees: all
:over: g h c i d: -; A D E J M N: -
:control: $-c\frac gh$ for $c\frac gh$ in (1)
:::
*/
#if FIELD
CLAIM(bernstein_powers_in_every_degree)
{
    num g = whole(T, "g", 1, 9), h = whole(T, "h", 1, 9), c = unknown(T, "c", 0), two = from_int(2);
    for (int odd = 0; odd <= 1; odd++) {
        num sigma = from_int(odd ? -1 : 1), before = mul(neg(sigma), div(mul(c, g), h));
        about(T, "one factor more"); /* 1 times the one coefficient, -1 times the one before */
        same(T, sub(mul(sigma, c), fault(T, before, neg(before))), mul(sigma, div(mul(c, add(g, h)), h)));
    }
    num A = unknown(T, "A", 0), D = unknown(T, "D", 0), E = unknown(T, "E", 0), J = unknown(T, "J", 0);
    num M = unknown(T, "M", 0), N = unknown(T, "N", 0), i = whole(T, "i", 0, 9), d = whole(T, "d", 0, 9);
    about(T, "the binomial coefficients");
    same(T, mul(div(N, mul(A, M)), div(M, mul(D, E))), mul(div(N, mul(J, E)), div(J, mul(A, D))));
    about(T, "the exponent of -1");
    same(T, sub(add(i, add(i, d)), d), mul(two, i));
}
#endif

/*

:::{claim} bernstein_matrix_is_the_matrix
:title: The corrected entries are those of the coefficient matrix
:zh: 改正后的 Bernstein 系数矩阵
:given: orders $k$, $k$ knots $0$ and $k$ knots $1$, $t$ variable
:then: `bernstein_matrix` has the entries $(-1)^{i+j}\binom{k-1}j\binom ji$ for $j\ge i$ and $0$ for $j<i$; its columns are $\binom{k-1}i(1-t)^{k-1-i}t^i$ in powers of $t$, which
  is $N_{i,k}(t)$ on $[0,1)$; and the matrix is that of (4.4.17) at these knots
:method: The kernel against the Bernstein polynomials and the B-splines by their definition at a variable $t$, and against `bspline_matrix_by_marsden`.
:degrees: 0..7 sampled 8
:defines: bernstein_matrix
:control: the matrix transposed
:::
*/
CLAIM(bernstein_matrix_is_the_matrix)
{
    int k = T->degree + 1;
    struct G(span) S = G(bernstein_span)(k);
    num A[CELLS], B[CELLS], t = parameter(T, "t");
    G(bernstein_matrix)(k - 1, A);
    G(bspline_matrix_by_marsden)(k - 1, S.t, S.r, B);
    for (int i = 0; i < k; i++) {
        num sum = from_int(0);
        for (int j = 0; j < k; j++) {
            num a = fault(T, A[j * k + i], A[i * k + j]);
            about(T, "the entry by its formula");
            same(T, a, j < i ? from_int(0) : G(signed_by)(i + j, mul(G(choose)(k - 1, j), G(choose)(j, i))));
            about(T, "the entry from Marsden's identity");
            same(T, a, B[j * k + i]);
            sum = add(sum, mul(a, G(power)(t, j)));
        }
        about(T, "the Bernstein polynomial");
        same(T, sum, G(bernstein_value)(k - 1, i, t));
        about(T, "the B-spline");
        same(T, sum, G(basis_value)(&S, i, k, t));
    }
}

#if RATIONAL
/* Column i of the printed matrix at t, with none, one or both of its faults mended. */
static num G(printed_bernstein)(int k, int i, int indices_right, int product_right, num t)
{
    num sum = from_int(0);
    for (int j = 0; j < k; j++) {
        int a = indices_right ? j : i, b = indices_right ? i : j; /* printed: a = i, b = j */
        if (a < b)
            continue;
        num front = G(choose)(k - 1, a), other = G(choose)(a, b);
        sum = add(sum, mul(G(signed_by)(i + j, product_right ? mul(front, other) : div(front, other)), G(power)(t, j)));
    }
    return sum;
}

/*
The printed matrix has two faults.  For $k=2$ all quotients are also products, and the exchange of the indices is seen
alone; for $k=3$, with the indices put right, the quotients are.

:::{claim} printed_bernstein_matrix_is_transposed
:title: The printed matrix has its indices exchanged
:zh: 印出的矩阵行列互换
:kind: counterexample
:given: $k$, for which each quotient is equal to the product, $i$ and $t$
:data: k = 2; i = 0; t = 1/2
:then: the sum of the printed column is not $B_i^{k-1}(t)$
:result: the sum of the printed column = 1; B_i(t) = 1/2
:method: The sum of the printed column at $t$.
:control: the indices exchanged
:::
*/
CLAIM(printed_bernstein_matrix_is_transposed)
{
    int k = given_whole(T, "k"), i = given_whole(T, "i");
    num t = given(T, "t"), sum = G(printed_bernstein)(k, i, fault(T, 1, 0), 0, t),
        value = G(bernstein_value)(k - 1, i, t);
    found(T, "the sum of the printed column", sum);
    found(T, "B_i(t)", value);
    about(T, "the sum of the printed column, and B_i(t)");
    same(T, sum, value);
}

/*
:::{claim} printed_bernstein_quotient_fails
:title: With the indices put right the quotient is still wrong
:zh: 下标改正后商式仍有误
:kind: counterexample
:given: $k$, $i$ and $t$, the indices of the printed formula exchanged
:data: k = 3; i = 1; t = 1/2
:then: the sum of the column with the quotients is not $B_i^{k-1}(t)$
:result: the sum of the column with the quotients = 7/8; B_i(t) = 1/2
:method: The sum of the column at $t$.
:control: the product of the binomial coefficients
:::
*/
CLAIM(printed_bernstein_quotient_fails)
{
    int k = given_whole(T, "k"), i = given_whole(T, "i");
    num t = given(T, "t"), sum = G(printed_bernstein)(k, i, 1, fault(T, 1, 0), t),
        value = G(bernstein_value)(k - 1, i, t);
    found(T, "the sum of the column with the quotients", sum);
    found(T, "B_i(t)", value);
    about(T, "the sum of the column with the quotients, and B_i(t)");
    same(T, sum, value);
}
#endif

/*
:::{statement} wang-ch4:bernstein-basis
:title: The B-splines are then the Bernstein polynomials
:zh: 退化为 Bernstein 基
:printed: for $T=\{0,0,\dots,0,1,1,\dots,1\}$, compared with (1.6.9), the B-splines degenerate to the Bernstein polynomials, $N_{i,k}(t)=B_i^{k-1}(t)$, $t\in[t_{k-1},t_k)=[0,1)$, $i=0,1,\dots,k-1$
:holds-by: bernstein_functions_in_every_order outer_functions_are_made_of_outer_ones
:confirmed-by: bsplines_are_bernstein_polynomials
:needs: polynomial_of_a_span_ends_with_it | the line itself: $t\in[t_{k-1},t_k)=[0,1)$ | $t$ lies in the span
:needs: bernstein_knots_from_one_shift_the_index | the line itself: $[t_{k-1},t_k)=[0,1)$ | the knots are numbered
  from 0, $t_0=\dots=t_{k-1}=0$
:figure: bernstein_matrix

(1.6.9) is in a chapter that is not at hand; the functions themselves are compared.
:::

:::{claim} bsplines_are_bernstein_polynomials
:title: The B-splines of these knots are the Bernstein polynomials
:zh: B 样条基退化为 Bernstein 基
:given: orders $k$, $k$ knots $0$ and $k$ knots $1$, $t$ variable
:then: $N_{i,k}(t)=\binom{k-1}i(1-t)^{k-1-i}t^i$ on $[0,1)$
:method: The B-splines by their definition.
:degrees: 0..7 sampled 8
:control: the functions in the opposite order
:::
*/
CLAIM(bsplines_are_bernstein_polynomials)
{
    int k = T->degree + 1;
    struct G(span) S = G(bernstein_span)(k);
    num t = parameter(T, "t");
    for (int i = 0; i < k; i++)
        same(T, G(basis_value)(&S, fault(T, i, k - 1 - i), k, t), G(bernstein_value)(k - 1, i, t));
}

/*
:::{statement} wang-ch4:bernstein-basis-sum
:title: The Bernstein polynomials from the printed matrix
:zh: 由印出的矩阵得到的和式
:printed: for $T=\{0,0,\dots,0,1,1,\dots,1\}$: $N_{i,k}(t)=\sum_{j=0}^{k-1}a_{ji}t^j=B_i^{k-1}(t)$, $t\in[t_{k-1},t_k)=[0,1)$, $i=0,1,\dots,k-1$
:class: misprint
:refuted-by: printed_bernstein_matrix_is_transposed
:meant: the line before it, which gives the $a_{ji}$ of these knots, and from which it is concluded | The $a_{ji}$ are the printed ones, see `bernstein-matrix`.
:reading: bernstein_functions_in_every_order | the $a_{ji}$ are the entries of the coefficient matrix as they are, whatever is printed, the knots are numbered from 0, and $t$ is in the span
:reading-with: outer_functions_are_made_of_outer_ones bernstein_powers_in_every_degree
:corrected: true for the entries $a_{ji}=(-1)^{i+j}\binom{k-1}j\binom ji$, not for the printed ones
:corrected-by: bernstein_functions_in_every_order outer_functions_are_made_of_outer_ones
  bernstein_powers_in_every_degree
:confirmed-by: bernstein_matrix_is_the_matrix
:needs: polynomial_of_a_span_ends_with_it | the line itself: $t\in[t_{k-1},t_k)=[0,1)$ | $t$ lies in the span
:needs: bernstein_knots_from_one_shift_the_index | the line itself: $[t_{k-1},t_k)=[0,1)$ | the knots are numbered
  from 0, $t_0=\dots=t_{k-1}=0$
:figure: bernstein_matrix
:::

## The greatest order (最高阶)

The kernels have workspaces of a fixed size, so there is a greatest order, far beyond what a formula is used for.  The
claims of these sections stop at small orders; at the greatest one the kernels are compared with each other.
*/

#if RATIONAL
/*
:::{claim} matrices_agree_at_the_greatest_order
:title: At the greatest order of the kernels their matrices agree
:zh: 各算法在最高阶处一致
:kind: decision
:given: the greatest order $k$ that the kernels take; the knots $0,1,\dots,2k-1$; $k$ knots 0 and $k$ knots 1; double
  knots left of the span and triple ones right of it
:then: `bspline_matrix_by_differences` gives the matrix of `bspline_matrix` for all three, `bspline_matrix_simple` and
  `bspline_matrix_uniform` for the first, `bernstein_matrix` for the second; `marsden_determinant` is the determinant of
  `marsden_matrix`
:result: k = 23
:method: All entries are compared.
:scope: the stated knots
:control: the entries in the opposite order
:::
*/
CLAIM(matrices_agree_at_the_greatest_order)
{
    enum { p = MAX_ORDER - 2, k = p + 1 };
    found_whole(T, "k", k);
    for (int kind = 0; kind < 3; kind++) {
        num u[2 * k], A[k * k], B[k * k], others[3][k * k];
        int group[2 * k], count = 0;
        for (int m = 0; m < 2 * k; m++) {
            group[m] = kind == 0 ? m : kind == 1 ? m >= k : m < k ? m / 2 : k + (m - k) / 3;
            u[m] = from_int(group[m]);
        }
        G(bspline_matrix)(p, u, p, A);
        G(marsden_matrix)(p, u, p, B);
        about(T, "the determinant");
        same(T, G(determinant)(k, B), G(marsden_determinant)(p, u, p));
        G(bspline_matrix_by_differences)(p, u, group, p, others[count++]);
        if (kind == 0) {
            G(bspline_matrix_simple)(p, u, p, others[count++]);
            G(bspline_matrix_uniform)(p, others[count++]);
        }
        if (kind == 1)
            G(bernstein_matrix)(p, others[count++]);
        about(T, "the matrices");
        for (int c = 0; c < count; c++)
            for (int m = 0; m < k * k; m++)
                same(T, others[c][fault(T, m, k * k - 1 - m)], A[m]);
    }
}
#endif

#include "chapters/judge/claims_off.h"
