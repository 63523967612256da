/*
# Equidistant knots (等距节点)

With $t_i=i$ the products of (4.4.23) are factorials.  The source derives the matrix by a chain of four sums: the knots put in, then
$i=r-k+1+s$, then $v=l-r-1$, then $l=s-v$.  Each step is decided for every order; so the matrix is.
*/
#include "chapters/nurbs/simple-knots.h"

#include "chapters/judge/claims_on.h"

enum { CELLS = LARGEST_ORDER * LARGEST_ORDER };

/*
:::{statement} wang-ch4:uniform-wlog
:title: Equidistant knots may be taken as the integers
:zh: 等距时不妨设 t_i=i
:printed: when the knots of $T$ are equidistant, one may put $t_i=i$
:holds-by: simple_function_in_every_order binomial_theorem_in_every_degree equidistant_knots_make_factorials
:confirmed-by: uniform_matrix_is_the_matrix coefficient_matrix_is_affinely_invariant
:figure: uniform_matrices

The knots are $a+hi$, and the matrix is that of $a=0$, $h=1$: in (4.4.23), put right as in `formula-4.4.23`, neither $a$ nor $h$ is left.
:::

:::{claim} equidistant_knots_make_factorials
:title: With equidistant knots the products of (4.4.23) are factorials
:zh: 等距时 (4.4.23) 中的乘积为阶乘
:types: field
:given: the knots $t_i=a+hi$; integers $k$, $r$, $i$, $l$ and $m$; of (4.4.23) with the factors $t_l-t_\alpha$ and the exponent $k-1-j$ the term of $l$
:let: $U=h^j$, $V=h^{k-1-j}$, so that $h^k=hUV$; $\sigma=(-1)^j$, $\rho=(-1)^{i+k-l}$; $A=(l-i)!$, $B=(i+k-l)!$, $W=(l-r)^{k-1-j}$
:then: (1) $t_l-t_{l-m}=hm$ and $t_l-t_{l+m}=-hm$, of which the product has those with $m=1,\dots,l-i$ and $m=1,\dots,i+k-l$, $k$ in number, so that it is
  $hUV\rho AB$; (2) the others are $t_{i+k}-t_i=hk$, $(t_r-t_{r+1})^j=\sigma U$ and $(t_l-t_r)^{k-1-j}=VW$; (3) of all,
  $\frac{hk\cdot\sigma U\cdot VW}{hUV\rho AB}=k\,\frac{\sigma\rho W}{AB}$, and $\sigma\rho$ is $(-1)^{j+k+l-i}$
:method: Identities in all these letters.  The binomial coefficient stands in both.  So neither $a$ nor $h$ stands in (4.4.23), which is the first sum with the exponent $k-1-j$.
:degrees: all
:scope: equidistant knots
:over: a: first knot; h: gap; k r i l m j: -; U V A B W: -
:control: $t_{l+m}-t_l=hm$ in the product
:::
*/
#if FIELD
CLAIM(equidistant_knots_make_factorials)
{
    num a = unknown(T, "a", 0), h = positive(T, "h", 0), one = from_int(1), two = from_int(2);
    num k = whole(T, "k", 2, 9), r = whole(T, "r", 0, 9), i = whole(T, "i", 0, 9), l = whole(T, "l", 0, 9);
    num m = whole(T, "m", 1, 9), j = whole(T, "j", 0, 9), knot = add(a, mul(h, l));
    num A = unknown(T, "A", 0), B = unknown(T, "B", 0), U = unknown(T, "U", 0), V = unknown(T, "V", 0),
        W = unknown(T, "W", 0);
    about(T, "the factors");
    same(T, sub(knot, add(a, mul(h, sub(l, m)))), mul(h, m));
    num behind = add(a, mul(h, add(l, m)));
    same(T, fault(T, sub(knot, behind), sub(behind, knot)), neg(mul(h, m)));
    same(T, sub(knot, add(a, mul(h, r))), mul(h, sub(l, r)));
    same(T, sub(add(a, mul(h, add(i, k))), add(a, mul(h, i))), mul(h, k));
    same(T, sub(add(a, mul(h, r)), add(a, mul(h, add(r, one)))), neg(h));
    about(T, "their number");
    same(T, add(sub(l, i), sub(add(i, k), l)), k);
    about(T, "the term");
    for (int odd = 0; odd < 4; odd++) { /* σ and ρ */
        num sigma = from_int(odd & 1 ? -1 : 1), rho = from_int(odd & 2 ? -1 : 1);
        num above = mul(mul(mul(h, k), mul(sigma, U)), mul(V, W)), below = mul(mul(h, mul(U, V)), mul(rho, mul(A, B)));
        same(T, div(above, below), mul(k, div(mul(mul(sigma, rho), W), mul(A, B))));
    }
    about(T, "the exponent of -1"); /* j+k+l-i, and j with i+k-l */
    same(T, sub(add(add(j, k), sub(l, i)), add(j, sub(add(i, k), l))), mul(two, sub(l, i)));
}
#endif

/*
:::{claim} uniform_matrix_is_the_matrix
:title: The formula for equidistant knots gives the coefficient matrix
:zh: 等距节点系数矩阵公式
:given: orders $k$, the knots $t_i=a+hi$ with variables $a$ and $h$, $u$ variable
:then: the columns of the matrix of the sums $(-1)^j\frac{\binom{k-1}j}{(k-1)!}\sum_{l=0}^i(-1)^l\binom kl(i-l+1)^{k-1-j}$, in which neither $a$ nor $h$ stands, are the $N_{i,k}$ in powers of $u$, and
  `bspline_matrix_uniform` has these entries
:method: The sums by their letter against the kernel, and in powers of a variable $u$ against the definition of the B-splines.
:degrees: 0..6 sampled 8
:over: a: first knot; h: gap
:defines: bspline_matrix_uniform
:control: the columns in the opposite order
:::
*/
/* The printed entry of row j and column i of the matrix of equidistant knots. */
static num G(printed_uniform)(int k, int j, int i)
{
    num sum = from_int(0);
    for (int l = 0; l <= i; l++)
        sum = add(sum, G(signed_by)(l, mul(G(choose)(k, l), G(power)(from_int(i - l + 1), k - 1 - j))));
    return G(signed_by)(j, mul(div(G(choose)(k - 1, j), G(factorial)(k - 1)), sum));
}

CLAIM(uniform_matrix_is_the_matrix)
{
    int k = T->degree + 1;
    struct G(span) S = {.k = k, .r = k - 1};
    num A[CELLS], u = parameter(T, "u"), a = unknown(T, "a", 0), h = positive(T, "h", 0);
    for (int m = 0; m < 2 * k; m++) {
        S.t[m] = add(a, mul(from_int(m), h));
        S.group[m] = m;
    }
    G(bspline_matrix_uniform)(k - 1, A);
    about(T, "the sums by their letter and the kernel's");
    for (int m = 0; m < k * k; m++)
        same(T, G(printed_uniform)(k, m / k, m % k), A[m]);
    about(T, "the powers of u and the B-spline");
    for (int i = 0; i < k; i++)
        same(T, G(column_value)(k, A, fault(T, i, k - 1 - i), u), G(basis_value)(&S, i, k, G(at_parameter)(&S, u)));
}

/*
:::{statement} wang-ch4:uniform-start
:title: The chain begins with formula 4.4.23
:zh: 推导以 (4.4.23) 为起点
:printed: with $t_i=i$ formula (4.4.23) becomes the first sum of the chain, $a_{ji}=\binom{k-1}jk\sum_{l=r+1}^{i+k}\frac{(-1)^{j+k+l-i}(l-r)^{k-l-j}}{(l-i)!\,(i+k-l)!}$
:class: invalid-proof
:refuted-by: uniform_chain_does_not_follow
:corrected: it follows from (4.4.23) with the factors $t_l-t_\alpha$ and, in both, the exponent $k-1-j$
:corrected-by: equidistant_knots_make_factorials
:confirmed-by: corrected_entry_becomes_the_first_sum uniform_chain_gives_the_matrix
:figure: simple_knots_sign

It is the sign alone that breaks the step, for odd $k$: each of the $k$ factors $t_\alpha-t_l$ is the negative of $t_l-t_\alpha$.  The letter $l$ in the exponents stands in both.
:::
*/

/* (a)^exponent for any integer exponent. */
static num G(any_power)(int a, int exponent)
{
    num size = G(power)(from_int(a), exponent < 0 ? -exponent : exponent);
    return exponent < 0 ? div(from_int(1), size) : size;
}

/* The four sums.  `one` stands where the source has the letter l for the digit 1 in the exponent: 1, or 0 for the
 * letter; in line 3, where it is no variable of the sum, the value of the letter. */
static num G(uniform_line)(int line, int k, int r, int i, int j, int one)
{
    int s = i - r + k - 1;
    num sum = from_int(0), front = mul(G(choose)(k - 1, j), from_int(k));
    if (line == 1)
        for (int l = r + 1; l <= i + k; l++) {
            num below = mul(G(factorial)(l - i), G(factorial)(i + k - l));
            sum = add(sum, G(signed_by)(j + k + l - i, div(G(any_power)(l - r, k - (one ? 1 : l) - j), below)));
        }
    if (line == 2)
        for (int l = r + 1; l <= r + 1 + s; l++) {
            num below = mul(G(factorial)(l + k - r - 1 - s), G(factorial)(one ? r + s + 1 - l : r + s + l - l));
            sum = add(sum, G(signed_by)(l + r + s + 1 + j, div(G(any_power)(l - r, k - 1 - j), below)));
        }
    if (line == 3)
        for (int v = 0; v <= s; v++) {
            num below = mul(G(factorial)(v + k - s), G(factorial)(s - v));
            sum = add(sum, G(signed_by)(v + s + j, div(G(any_power)(v + 1, k - one - j), below)));
        }
    if (line == 4)
        for (int l = 0; l <= s; l++) {
            num below = mul(G(factorial)(k - l), G(factorial)(l));
            sum = add(sum, G(signed_by)(l + j, div(G(any_power)(s - l + 1, k - (one ? 1 : l) - j), below)));
        }
    return mul(front, sum);
}

/*
:::{claim} corrected_entry_becomes_the_first_sum
:title: Formula 4.4.23, its factors put right, becomes the first sum
:zh: 改正后的 (4.4.23) 化为第一式
:given: orders $k$, the knots $t_{r-k+1},\dots,t_{r+k}$, which are $a,a+1,\dots,a+2k-1$ with a variable $a$
:then: for all $i$ and $j$ the sum (4.4.23) with the factors $t_l-t_\alpha$ and the exponent $k-1-j$ is the first sum with this exponent
:method: Both sums by their letter.  In the first sum only differences of $l$, $i$ and $r$ stand, so that $r$ may be taken as $k-1$.
:degrees: 0..6 sampled 8
:over: a: first knot
:control: the factors $t_\alpha-t_l$
:::
*/
CLAIM(corrected_entry_becomes_the_first_sum)
{
    int k = T->degree + 1;
    struct G(span) S = {.k = k, .r = k - 1};
    num a = unknown(T, "a", 0);
    for (int m = 0; m < 2 * k; m++) {
        S.t[m] = add(a, from_int(m));
        S.group[m] = m;
    }
    for (int j = 0; j < k; j++)
        for (int i = 0; i < k; i++)
            same(T, G(printed_entry)(&S, i, j, 0, fault(T, 0, 1)), G(uniform_line)(1, k, S.r, i, j, 1));
}

#if RATIONAL
/* The 2k equidistant knots of the span [r, r+1), and the place of i among their functions. */
static struct G(span) G(uniform_span)(int k, int r)
{
    struct G(span) S = {.k = k, .r = k - 1};
    for (int m = 0; m < 2 * k; m++) {
        S.t[m] = from_int(r - k + 1 + m);
        S.group[m] = m;
    }
    return S;
}

/*
Each of the four sums is computed twice, with the digit and with the letter.  With the digit all four are the entries
of the matrix.  The sign with which the chain begins is the right one, so it does not come from the printed (4.4.23).

:::{claim} uniform_chain_gives_the_matrix
:title: The four sums, with the digit 1, are the entries of the matrix
:zh: 改正后四式均为矩阵元素
:kind: decision
:given: the orders $k$, $r=0$ and $r=k+2$, the knots $t_i=i$
:then: for all $i$ and $j$ the four sums are $a_{ji}$, the first also when it is computed from (4.4.23) with the factors
  $t_l-t_\alpha$
:method: Every sum by its letter, with the digit 1 where the letter $l$ stands for it; the degree below is $k-1$.
:degrees: 0..8
:scope: r = 0 and r = k+2
:control: the sign $(-1)^s$ left out of the third sum
:::
*/
CLAIM(uniform_chain_gives_the_matrix)
{
    int k = T->degree + 1;
    num A[CELLS];
    G(bspline_matrix_uniform)(k - 1, A);
    for (int r = 0; r <= k + 2; r += k + 2) {
        struct G(span) S = G(uniform_span)(k, r);
        for (int j = 0; j < k; j++)
            for (int s = 0; s < k; s++) {
                agree(T, equal_q(G(printed_entry)(&S, s, j, 0, 0), A[j * k + s]));
                for (int line = 1; line <= 4; line++) {
                    num sum = G(uniform_line)(line, k, r, r - k + 1 + s, j, 1);
                    if (T->faulty && line == 3)
                        sum = G(signed_by)(s, sum);
                    agree(T, equal_q(sum, A[j * k + s]));
                }
            }
    }
}

/*
The last sum knows nothing of $r$, and each term of the others is one of its terms, whatever $r$ is.

:::{claim} last_sum_gives_the_uniform_matrix
:title: The fourth sum, with the digit 1, is the entry of the matrix
:zh: 第四式即矩阵元素
:kind: decision
:given: the orders $k$
:then: for all $s$ and $j$ the fourth sum with the exponent $k-1-j$ is the entry of row $j$ and column $s$ of the kernel's matrix; $r$ is in neither
:method: The sum by its letter, with the digit 1 where the letter $l$ stands for it; that the kernel's matrix is that of equidistant knots is
  `uniform_matrix_is_the_matrix`.
:degrees: 0..8
:control: the sign $(-1)^{s+1}$ put before the sum
:::
*/
CLAIM(last_sum_gives_the_uniform_matrix)
{
    int k = T->degree + 1;
    num A[CELLS];
    G(bspline_matrix_uniform)(k - 1, A);
    for (int j = 0; j < k; j++)
        for (int s = 0; s < k; s++) {
            num sum = G(uniform_line)(4, k, k - 1, s, j, 1);
            agree(T, equal_q(fault(T, sum, G(signed_by)(s + 1, sum)), A[j * k + s]));
        }
}

/*
:::{claim} uniform_chain_does_not_follow
:title: From the printed formula 4.4.23 the first sum does not follow
:zh: 由印出的 (4.4.23) 推不出第一式
:kind: counterexample
:given: $t_i=i$; the order $k$, the span $[t_r,t_{r+1})$ and the entry $a_{ji}$
:data: k = 3; r = 2; i = 1; j = 0
:then: (4.4.23) gives the negative of the first sum of the chain, with the printed exponents $k-l-j$ in both and with $k-1-j$ in both
:result: (4.4.23) = 5/4; the first sum = -5/4; with k-1-j: (4.4.23) = -1/2; with k-1-j: the first sum = 1/2
:method: Both by their letter.
:control: the factors $t_l-t_\alpha$ in (4.4.23)
:::
*/
CLAIM(uniform_chain_does_not_follow)
{
    int k = given_whole(T, "k"), r = given_whole(T, "r"), i = given_whole(T, "i"), j = given_whole(T, "j");
    struct G(span) S = G(uniform_span)(k, r);
    static const char *const name[][2] = {{"(4.4.23)", "the first sum"},
                                          {"with k-1-j: (4.4.23)", "with k-1-j: the first sum"}};
    for (int digit = 0; digit <= 1; digit++) { /* the letter l in the exponents, then 1; r is k-1 */
        num entry = G(printed_entry)(&S, i - r + k - 1, j, !digit, fault(T, 0, 1)),
            sum = G(uniform_line)(1, k, r, i, j, digit);
        found(T, name[digit][0], entry);
        found(T, name[digit][1], sum);
        about(T, "(4.4.23), and the first sum of the chain");
        same(T, entry, sum);
    }
}

/*
:::{statement} wang-ch4:uniform-line-1
:title: First sum: the knots put in
:zh: 等距情形第一式
:printed: when the knots are equidistant, $a_{ji}=\binom{k-1}jk\sum_{l=r+1}^{i+k}\frac{(-1)^{j+k+l-i}(l-r)^{k-l-j}}{(l-i)!\,(i+k-l)!}$, $i=r-k+1,r-k+2,\dots,r$; $j=0,1,\dots,k-1$
:class: misprint
:refuted-by: uniform_letter_one_fails
:corrected: the exponent is $k-1-j$; everything else is right
:corrected-by: simple_function_in_every_order binomial_theorem_in_every_degree equidistant_knots_make_factorials
:confirmed-by: uniform_chain_gives_the_matrix last_sum_gives_the_uniform_matrix
:needs: polynomial_of_a_span_ends_with_it | (4.4.11), whose coefficients they are: $t\in[t_r,t_{r+1})$ | $t$ lies in the span
:figure: uniform_letter
:::
*/

/* The order, the span, the function and the power of one entry a_{ji} of the matrix of equidistant knots, from a block. */
struct indices {
    int k, r, i, j;
};
static struct indices given_indices(trial *T)
{
    struct indices at;
    at.k = given_whole(T, "k");
    at.r = given_whole(T, "r");
    at.i = given_whole(T, "i");
    at.j = given_whole(T, "j");
    return at;
}

static num G(uniform_entry)(struct indices at)
{
    num A[CELLS];
    G(bspline_matrix_uniform)(at.k - 1, A);
    return A[at.j * at.k + at.i - at.r + at.k - 1];
}

/* Compare: the printed sum of a line, whose name is given, with the entry of the matrix.  `letter`: what stands for the digit 1
 * in the exponent, as `uniform_line` takes it. */
static void G(compare_line)(trial *T, const char *name, int line, int letter, struct indices at)
{
    num sum = G(uniform_line)(line, at.k, at.r, at.i, at.j, fault(T, 1, letter));
    found(T, name, sum);
    same(T, sum, G(uniform_entry)(at));
}

/*
With the letter the sums differ from the entries already for the smallest orders, and each in its own way; for every
sum one entry is enough.

:::{claim} uniform_letter_one_fails
:title: The exponent k-l-j of the first sum is wrong
:zh: 第一式中指数 k-l-j 有误
:kind: counterexample
:given: $t_i=i$; the order $k$, the span $[t_r,t_{r+1})$ and the entry $a_{ji}$
:data: k = 2; r = 1; i = 1; j = 0
:then: $a_{ji}=0$; the first sum, of which one exponent is 0 and the other negative, is not 0
:result: the first sum = -3/2; a_ji = 0
:method: The sum by its letter.
:control: the exponent $k-1-j$
:::
*/
CLAIM(uniform_letter_one_fails)
{
    struct indices at = given_indices(T);
    about(T, "the first sum, and a_ji");
    G(compare_line)(T, "the first sum", 1, 0, at);
    found(T, "a_ji", G(uniform_entry)(at));
}

/*
:::{statement} wang-ch4:uniform-line-2
:title: Second sum: i = r-k+1+s
:zh: 等距情形第二式
:printed: when the knots are equidistant, $a_{ji}=\dots=\binom{k-1}jk(-1)^j\sum_{l=r+1}^{r+l+s}\frac{(-1)^{l+r+s+1}(l-r)^{k-l-j}}{(l+k-r-1-s)!\,(r+s+l-l)!}$ with $i=r-k+1+s$, $i=r-k+1,r-k+2,\dots,r$; $j=0,1,\dots,k-1$
:class: misprint
:refuted-by: uniform_letter_in_factorial_fails
:corrected: the upper limit is $r+1+s$, the exponent $k-1-j$ and the last factorial $(r+s+1-l)!$: three letters $l$ for the
  digit 1
:corrected-by: simple_function_in_every_order binomial_theorem_in_every_degree equidistant_knots_make_factorials
  uniform_terms_pass_into_one_another
:confirmed-by: uniform_chain_gives_the_matrix last_sum_gives_the_uniform_matrix
:needs: polynomial_of_a_span_ends_with_it | (4.4.11), whose coefficients they are: $t\in[t_r,t_{r+1})$ | $t$ lies in the span
:figure: uniform_letter

With $l$ in its own upper limit the sum has no meaning; with the limit and the exponent put right the factorial is still wrong.
:::

:::{claim} uniform_letter_in_factorial_fails
:title: The factorial (r+s+l-l)! of the second sum is wrong
:zh: 第二式中阶乘 (r+s+l-l)! 有误
:kind: counterexample
:given: $t_i=i$; the order $k$, the span $[t_r,t_{r+1})$ and the entry $a_{ji}$, so that $s=i-r+k-1=0$; the upper limit and the exponent taken with the digit 1
:data: k = 1; r = 2; i = 2; j = 0
:then: the only term of the second sum has $(r+s)!$ in the place of $0!$, so that it is not $a_{ji}$
:result: the second sum = 1/2; a_ji = 1
:method: The sum by its letter but for limit and exponent, which have to be read with the digit to have a meaning.
:control: $(r+s+1-l)!$
:::
*/
CLAIM(uniform_letter_in_factorial_fails)
{
    struct indices at = given_indices(T);
    about(T, "the second sum, and a_ji");
    G(compare_line)(T, "the second sum", 2, 0, at);
    found(T, "a_ji", G(uniform_entry)(at));
}

/*
:::{statement} wang-ch4:uniform-line-3
:title: Third sum: v = l-r-1
:zh: 等距情形第三式
:printed: when the knots are equidistant, $a_{ji}=\dots=\binom{k-1}jk(-1)^j\sum_{v=0}^s\frac{(-1)^{v+s}(v+1)^{k-l-j}}{(v+k-s)!\,(s-v)!}$ with $i=r-k+1+s$, $i=r-k+1,r-k+2,\dots,r$; $j=0,1,\dots,k-1$
:class: misprint
:refuted-by: uniform_letter_is_free_in_the_third_sum
:corrected: the exponent is $k-1-j$
:corrected-by: simple_function_in_every_order binomial_theorem_in_every_degree equidistant_knots_make_factorials
  uniform_terms_pass_into_one_another
:confirmed-by: uniform_chain_gives_the_matrix last_sum_gives_the_uniform_matrix
:needs: polynomial_of_a_span_ends_with_it | (4.4.11), whose coefficients they are: $t\in[t_r,t_{r+1})$ | $t$ lies in the span
:figure: uniform_letter

By the letter the sum has no value: $l$, the variable of the second sum, is bound nowhere here.  In the example it is $a_{ji}$ with $l=1$, and not with $l=2$.
:::

:::{claim} uniform_letter_is_free_in_the_third_sum
:title: In the third sum the letter l is free, and with l = 2 it is no entry of the matrix
:zh: 第三式中的字母 l 无所指
:kind: counterexample
:given: $t_i=i$; the order $k$, the span $[t_r,t_{r+1})$ and the entry $a_{ji}$, so that $s=i-r+k-1=1$; a value for $l$, to which the line gives none
:data: k = 2; r = 1; i = 1; j = 0; l = 2
:then: $a_{ji}=0$; the third sum with this $l$ is not 0, and with $l=1$ it is 0
:result: the third sum = -1; a_ji = 0
:method: The sum by its letter, $l$ being a number.
:control: $l=1$, the exponent $k-1-j$
:::
*/
CLAIM(uniform_letter_is_free_in_the_third_sum)
{
    struct indices at = given_indices(T);
    about(T, "the third sum, and a_ji");
    G(compare_line)(T, "the third sum", 3, given_whole(T, "l"), at);
    found(T, "a_ji", G(uniform_entry)(at));
}

/*
:::{statement} wang-ch4:uniform-line-4
:title: Fourth sum: l = s-v
:zh: 等距情形第四式
:printed: when the knots are equidistant, $a_{ji}=\dots=\binom{k-1}jk(-1)^j\sum_{l=0}^s\frac{(-1)^l(s-l+1)^{k-l-j}}{(k-l)!\,l!}$ with $i=r-k+1+s$, $i=r-k+1,r-k+2,\dots,r$; $j=0,1,\dots,k-1$
:class: misprint
:refuted-by: uniform_letter_in_last_sum_fails
:corrected: the exponent is $k-1-j$
:corrected-by: simple_function_in_every_order binomial_theorem_in_every_degree equidistant_knots_make_factorials
  uniform_terms_pass_into_one_another
:confirmed-by: uniform_chain_gives_the_matrix last_sum_gives_the_uniform_matrix
:needs: polynomial_of_a_span_ends_with_it | (4.4.11), whose coefficients they are: $t\in[t_r,t_{r+1})$ | $t$ lies in the span
:figure: uniform_letter
:::

:::{claim} uniform_letter_in_last_sum_fails
:title: The exponent k-l-j of the fourth sum is wrong
:zh: 第四式中指数 k-l-j 有误
:kind: counterexample
:given: $t_i=i$; the order $k$, the span $[t_r,t_{r+1})$ and the entry $a_{ji}$, so that $s=i-r+k-1=1$
:data: k = 2; r = 1; i = 1; j = 0
:then: $a_{ji}=0$; the fourth sum with the exponents $k-l-j$ is not 0
:result: the fourth sum = 2; a_ji = 0
:method: The sum by its letter.
:control: the exponent $k-1-j$
:::
*/
CLAIM(uniform_letter_in_last_sum_fails)
{
    struct indices at = given_indices(T);
    about(T, "the fourth sum, and a_ji");
    G(compare_line)(T, "the fourth sum", 4, 0, at);
    found(T, "a_ji", G(uniform_entry)(at));
}
#endif

/*
:::{statement} wang-ch4:uniform-substitutions
:title: The three substitutions
:zh: 三次变量替换
:printed: changing the variables in (4.4.23), one puts in turn $i=r-k+1+s$, $v=l-r-1$, $l=s-v$
:holds-by: uniform_terms_pass_into_one_another
:confirmed-by: uniform_chain_gives_the_matrix
:meant: the words in turn (依次) | The last $l$ is a new one, $r+1+s$ minus the old.
:figure: uniform_matrices

Each term of a sum is one of the next where the digit 1 stands for the letter $l$ that is printed in the exponents.
:::

:::{claim} uniform_terms_pass_into_one_another
:title: Each substitution takes every term of a sum to a term of the next
:zh: 三次替换逐项成立
:given: $k$, $r$, $s$ and $v$, variables; $i=r-k+1+s$, $l=r+1+v$ for the old $l$, $s-v$ for the new one
:then: base, factorials and exponents of the term $l$ of the first sum are those of the term $l$ of the second, $v$ of the third and $s-v$ of the fourth, and the exponents of $-1$ differ by even
  numbers; the terms $l=r+1,\dots,i+k$ are $l=r+1,\dots,r+1+s$, then $v=0,\dots,s$, then $s,\dots,0$
:method: Identities in the four letters, factor by factor, the digit 1 where the letter $l$ stands for it.  The factor $(-1)^j$, the binomial coefficient, $k$ and the exponent $k-1-j$ stand in
  all four.
:degrees: all
:over: r s v: -; k: -
:control: $i=r-k+s$
:::
*/
CLAIM(uniform_terms_pass_into_one_another)
{
    num k = whole(T, "k", 9, 20), r = whole(T, "r", 0, 30), s = whole(T, "s", 4, 8), v = whole(T, "v", 0, 3);
    num one = from_int(1), two = from_int(2), i = add(sub(add(r, s), k), fault(T, one, from_int(0)));
    num l = add(add(r, one), v), fourth = sub(s, v);
    about(T, "the base");
    same(T, sub(l, r), add(v, one));
    same(T, add(v, one), add(sub(s, fourth), one));
    about(T, "the first factorial");
    same(T, sub(l, i), sub(sub(sub(add(l, k), r), one), s));
    same(T, sub(l, i), sub(add(v, k), s));
    same(T, sub(l, i), sub(k, fourth));
    about(T, "the second factorial");
    same(T, sub(add(i, k), l), sub(add(add(r, s), one), l));
    same(T, sub(add(i, k), l), fourth);
    about(T, "the exponents of -1"); /* j+k+l-i, then j and l+r+s+1, v+s, l */
    num sign[] = {sub(add(k, l), i), add(add(add(l, r), s), one), add(v, s), fourth};
    same(T, sub(sign[0], sign[1]), mul(two, sub(sub(sub(k, r), s), one)));
    same(T, sub(sign[1], sign[2]), mul(two, add(r, one)));
    same(T, sub(sign[2], sign[3]), mul(two, v));
    about(T, "the last term");
    same(T, add(i, k), add(add(r, one), s));
}

/*

:::{statement} wang-ch4:uniform-matrix
:title: The coefficient matrix of equidistant knots
:zh: 等距节点的系数矩阵
:printed: simplified and rearranged, for equidistant knots, on the interval $[t_r,t_{r+1})=[r,r+1)$ the elements of $\mathbf A_{r,t,T}$ are
  $a_{j,r-k+1+i}=(-1)^j\frac{\binom{k-1}j}{(k-1)!}\sum_{l=0}^i(-1)^l\binom kl(i-l+1)^{k-1-j}$, $i,j=0,1,\dots,k-1$
:holds-by: simple_function_in_every_order binomial_theorem_in_every_degree equidistant_knots_make_factorials
  uniform_terms_pass_into_one_another fourth_sum_is_the_printed_one
:confirmed-by: uniform_matrix_is_the_matrix
:needs: polynomial_of_a_span_ends_with_it | the line itself: on $[t_r,t_{r+1})=[r,r+1)$ | $t$ lies in the span
:meant: (4.4.3), whose indices are $r,k,T$ | The matrix is $\mathbf A_{r,k,T}$, see `notation-4.4`.
:figure: uniform_matrices

Here the exponent is printed right.  The first two steps are (4.4.23) put right, see `formula-4.4.23`, the third makes the first sum of it, the others lead over the fourth to what is printed.
:::

:::{statement} wang-ch4:uniform-matrix-independent
:title: The matrix is the same on every span
:zh: 与 r 无关
:printed: when the knots are equidistant, the elements of the coefficient matrix on $[r,r+1)$ do not depend on $r$
:holds-by: simple_function_in_every_order binomial_theorem_in_every_degree equidistant_knots_make_factorials
  uniform_terms_pass_into_one_another fourth_sum_is_the_printed_one
:confirmed-by: uniform_matrix_is_the_matrix coefficient_matrix_is_affinely_invariant
:needs: polynomial_of_a_span_ends_with_it | the line itself: on $[r,r+1)$ | $t$ lies in the span; in the example, at a $t$ of $[1,2)$, the only element is 1
  for $r=1$, and for $r=0$ it would be 0
:figure: uniform_matrices

In $a_{j,r-k+1+i}$, $i,j=0,\dots,k-1$, $r$ numbers the columns alone.  Another $r$ is another first knot: around $[r,r+1)$ it is $r-k+1$.
:::

:::{claim} fourth_sum_is_the_printed_one
:title: The fourth sum, with the digit 1, is the printed entry
:zh: 第四式化为印出的元素
:types: field
:given: a term $l$ of the fourth sum, with the exponent $k-1-j$
:let: $A=l!$, $B=(k-l)!$, $C=(k-1)!$, so that $k!=kC$ and $\binom kl=\frac{kC}{AB}$; $N=\binom{k-1}j$
:then: $N\,k\,\frac1{BA}=\frac NC\binom kl$; the sign and the power stand in both
:method: An identity in the five letters; $s$ is the $i$ of the printed entry.
:degrees: all
:over: k A B C N: -
:control: $k!=(k-1)C$
:::
*/
#if FIELD
CLAIM(fourth_sum_is_the_printed_one)
{
    num k = whole(T, "k", 2, 9), one = from_int(1), N = unknown(T, "N", 0);
    num A = unknown(T, "A", 0), B = unknown(T, "B", 0), C = unknown(T, "C", 0);
    num choose = div(mul(fault(T, k, sub(k, one)), C), mul(A, B));
    same(T, mul(mul(N, k), div(one, mul(B, A))), mul(div(N, C), choose));
}
#endif

#include "chapters/judge/claims_off.h"
