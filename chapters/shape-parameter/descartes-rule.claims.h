/*
# The rule of Descartes (笛卡尔符号法则)

The source proves property 3.6 in two steps, of which the first is a rule of signs: $f=\sum k_iB_i$ has no more roots in
$(0,1)$ than $k_0,\dots,k_7$ has changes of sign.  In the true range this is a consequence of total positivity, as the
section before explains.  Here the source's own argument is followed line by line.

It looks at the two ends.  There $f$ has the values $k_0$ and $k_7$, and when both are known and not 0, they tell whether
the number of roots, each counted with its multiplicity, is even or odd.  This is all that they tell.  Parity excludes one
root more than there are changes of sign; it can never exclude two more.  And when $k_7=0$, it says nothing.  Both gaps can
be entered at $\beta=-7$: there $B_2$ is negative near $t=0$ and $B_5$ near $t=1$, and a large $k_2$ makes $f$ negative although its
coefficients are positive.  That the argument nowhere uses the range of $\beta$ could have been a warning.
*/
#include "exact/record/roots.h"

#include "chapters/shape-parameter/definition.h"

#include "chapters/judge/claims_on.h"

/*
:::{statement} deng-zhang-2022:property-3.6-SA
:title: Roots in (0,1) and changes of sign
:zh: 根的个数与变号数，式 (13)、(14)、(16)、(17)
:printed: $f(t)=\sum_{i=0}^7k_iB_{i,7}(t)$ for the functions (13) and constants (14); Zeros$(0,1)\{f(t)\}$ is the number of roots of $f$ in the interval
  $(0,1)$, $SA(k_0,\dots,k_7)$ the number of changes of sign of the sequence (14)
:definition: yes
:checked-by: combination_begins_and_ends_with_its_coefficients
:confirmed-by: functions_are_independent_but_for_two_values

The zero function has no number of roots: $f$ is zero for $k=0$, and for some $k\ne0$ when $\beta$ is $-7$ or $-\frac{21}4$.
Whether a root counts as often as its multiplicity, and whether zeros are left out of the sequence, is not said; the claims on (15) count with the
multiplicity and leave zeros out.

The number of roots is called Zeros in (15) and Zero in (20), and the rule of signs 符号法制 once and 符号法则 afterwards.
:::
*/

#if FIELD || RATIONAL
/*
:::{claim} combination_begins_and_ends_with_its_coefficients
:title: A combination of the functions has its first and its last coefficient as values at the ends
:zh: 组合函数的端点值为首末系数
:given: any $k_0,\dots,k_7$ and $\beta$; printed and corrected functions
:then: $f(0)=k_0$, $f(1)=k_7$
:method: The kernels at the two integers, everything a variable.
:types: field rational
:degrees: 7..7
:over: k#: coefficients
:control: the last two coefficients exchanged
:::
*/
CLAIM(combination_begins_and_ends_with_its_coefficients)
{
    num k[8], B[8], beta = unknown(T, "beta", 0);
    for (int i = 0; i <= 7; i++)
        k[i] = unknown(T, "k", i);
    for (int printed_ones = 0; printed_ones <= 1; printed_ones++)
        for (int end = 0; end <= 1; end++) {
            num sum = from_int(0);
            G(functions_of)(printed_ones, 7, beta, from_int(end), B);
            for (int i = 0; i <= 7; i++)
                sum = add(sum, mul(k[fault(T, i, i >= 6 ? 13 - i : i)], B[i]));
            same(T, sum, k[end ? 7 : 0]);
        }
}

/*
:::{claim} roots_inside_tell_the_signs_at_the_ends
:title: An even number of roots in (0,1) leaves equal signs at the ends, an odd number different ones
:zh: (0,1) 内根的个数的奇偶性决定两端的符号
:given: a polynomial $f=(t-r_1)\cdots(t-r_m)\,g$ with the roots $r_i$ in $(0,1)$, each as often as its multiplicity, $m=1,\dots,8$; $f$ of a degree of at most 8,
  $f(0),f(1)\ne0$; $g$ has the values $a$ and $b$ at $0$ and $1$, of one sign, since it has no root in $[0,1]$
:harmless: $f(0),f(1)\ne0$ | the signs at the ends are what is compared, and 0 has none
:then: $(-1)^mf(0)f(1)=ab\,r_1(1-r_1)\cdots r_m(1-r_m)>0$
:method: $r_i=s_i/(1+s_i)$ with $s_i>0$ a variable, $a$ and $b$ positive variables; with $-g$ both change their signs.
:types: field rational
:scope: polynomials of degree at most 8
:over: s# a b: -
:control: $(-1)^{m+1}$
:::
*/
CLAIM(roots_inside_tell_the_signs_at_the_ends)
{
    num one = from_int(1), a = positive(T, "a", 0), b = positive(T, "b", 0), at_0 = a, at_1 = b;
    for (int m = 1; m <= 8; m++) {
        num s = positive(T, "s", m), r = div(s, add(one, s));
        at_0 = mul(at_0, neg(r)), at_1 = mul(at_1, sub(one, r));
        num product = mul(at_0, at_1);
        G(must_be_positive)(T, (m + fault(T, 0, 1)) % 2 == 0 ? product : neg(product));
    }
}
#endif

#if RATIONAL
/*
In the two claims above everything is a variable.  The next counts the roots of instances, in which the signs alternate as
they do in the case that the source treats first.

:::{claim} parity_of_the_roots
:title: The number of roots is even or odd as the ends have equal or different signs
:zh: 根的个数的奇偶性
:given: random $k$ with $k_0>0$ and alternating signs, random $\beta$ from $-7$ to 7; corrected functions
:then: $f(0)=k_0$, $f(1)=k_7$, the number of roots of $f$ in $(0,1)$, each counted as often as its multiplicity, is odd and at
  most 7
:method: The roots of the exact polynomial are counted.
:types: rational
:control: the last sign is changed
:::
*/
CLAIM(parity_of_the_roots)
{
    num k[8], beta = unknown(T, "beta", 0), size;
    for (int i = 0; i <= 7; i++) {
        size = positive(T, "k", i);
        k[i] = fault(T, i % 2 == 0, i % 2 == 0 || i == 7) ? size : neg(size);
    }
    poly f = G(combination)(0, 7, mul(from_int(7), beta), k);
    struct cagd_root_count roots = count_roots(f, from_int(0), from_int(1), OPEN);
    same(T, poly_value(f, from_int(0)), k[0]);
    same(T, poly_value(f, from_int(1)), k[7]);
    agree(T, roots.counted % 2 == 1 && roots.counted <= 7);
}

/*
:::{statement} deng-zhang-2022:eq-15
:title: The rule of Descartes for the eight functions
:zh: 笛卡尔符号法则，式 (15)
:printed: these functions fully obey the rule of signs of Descartes on $(0,1)$, that is, for the following sequence of constants, (14),
  Zeros$(0,1)\{\sum_{i=0}^7k_iB_{i,7}(t)\}\le SA(k_0,\dots,k_7)$
  (definition 2.1: $-7\le\beta\le1$)
:refuted-by: positive_coefficients_with_two_roots a_combination_vanishes
:class: false
:corrected: for the printed functions and for the corrected ones (`sec-2-properties`): true for all $k\ne0$ exactly if $-\frac{21}4<\beta\le1$; at
  $\beta=-\frac{21}4$ true unless $f$ is the zero function, which it is for some $k\ne0$
:corrected-by: totally_positive_exactly_in_the_range inversions_of_two_diagonals_meet_a_zero
  averages_between_neighbours_keep_sign_changes linear_factor_adds_a_change_of_sign
  functions_are_independent_but_for_two_values third_function_has_a_zero_for_every_smaller_beta
  first_function_has_a_zero_for_every_larger_beta
:confirmed-by: roots_are_at_most_sign_changes
:figure: crossings_off_the_polygon

With two neighbours $k_{i-1},k_i$ each Bernstein coefficient of $\sum k_iB_i$ is a multiple of an average of the two, not a negative one, where the entries of the
matrix are not negative: so the coefficients have no more changes of sign than $k$, and the roots in $(0,1)$ are no more than these.  With
$k=0$ every $t$ is a root.
:::
*/

/* f = sum k_i B_i, printed functions, for β and k from the data of the claim. */
static poly G(given_combination)(trial *T, num k[])
{
    num beta = given(T, "β");
    given_points(T, "k", 8, 1, k);
    return G(combination)(1, 7, beta, k);
}

/* Whether f has no more roots in (0,1) than k has changes of sign, SA; both numbers are results. */
static int G(no_more_roots_than_changes)(trial *T, poly f, const num k[])
{
    struct cagd_root_count roots = count_roots(f, from_int(0), from_int(1), OPEN);
    int changes = G(sign_changes)(7, k);
    found_whole(T, "roots in (0,1)", roots.distinct);
    found_whole(T, "SA", changes);
    return roots.counted <= changes;
}

/*
:::{claim} positive_coefficients_with_two_roots
:title: At beta = -7 positive coefficients give two roots
:zh: β=-7 时正系数组合有两个根
:kind: counterexample
:data: β = -7; k = 1 1 200 1 1 1 1 1
:instead: β = -21/4
:result: roots in (0,1) = 2; SA = 0
:given: the left end of the printed range, and positive coefficients $k$, of which $k_2$ is large; printed functions
:then: there is no change of sign in $k$, and $f=\sum k_i\hat B_i$ has roots in $(0,1)$
:method: The roots of the exact polynomial are counted.
:control: the left end of the true range
:::
*/
CLAIM(positive_coefficients_with_two_roots)
{
    num k[8];
    poly f = G(given_combination)(T, k);
    int no_more = G(no_more_roots_than_changes)(T, f, k);
    about(T, "there are no more roots than changes of sign");
    agree(T, no_more);
}

/*
:::{statement} deng-zhang-2022:property-3.6-wlog
:title: Without loss of generality the first coefficient is positive
:zh: 不妨设 k_0>0
:printed: without loss of generality $k_0>0$; then $SA$ is one of $7,6,5,4,3,2,1,0$
:refuted-by: no_sign_makes_the_first_coefficient_positive
:class: invalid-proof
:corrected: for $k\ne0$ the first $k_i$ that is not 0 may be taken positive; for $-\frac{21}4<\beta\le1$ the sum has the
  sign of this $k_i$ for small $t>0$, and in the same way that of the last one near $t=1$; for $k_0>0$ $SA$ is one of $7,6,5,4,3,2,1,0$, and each of them is possible
:corrected-by: first_coefficient_gives_the_sign seven_changes_end_below_zero
:confirmed-by: corrected_functions_are_mirror_images
:figure: zero_at_the_beginning

With the corrected functions (`sec-2-properties`) $f(1-t)$ is the sum of the coefficients backwards, so that the last one could be taken for the first; it may be 0, too.
:::

A sum whose first and last coefficient are 0 is not covered by the words "without loss of generality".  It takes little to cover it:
near $t=0$ the sum has the sign of the first coefficient that is not 0, provided that the $\nu_i$ are positive, and here the
range of $\beta$ comes in.

:::{claim} no_sign_makes_the_first_coefficient_positive
:title: When the first and the last coefficient are 0 neither k nor -k begins with a positive number, forwards or backwards
:zh: k_0=k_7=0 时不能假设 k_0>0
:kind: counterexample
:data: k = 0 -1 1 1 1 1 1 0
:instead: k = -1 -1 1 1 1 1 1 0
:result: SA = 1
:given: coefficients $k$ that begin and end with 0
:then: the first and the last coefficients of $k$ and of $-k$ are 0, although the sign changes
:method: The four signs; that one of them is positive is refuted.
:control: a negative first coefficient
:::
*/
CLAIM(no_sign_makes_the_first_coefficient_positive)
{
    num k[8];
    given_points(T, "k", 8, 1, k);
    found_whole(T, "SA", G(sign_changes)(7, k));
    int positive_ones = 0;
    for (int i = 0; i <= 7; i += 7)
        positive_ones += (sign_q(k[i]) > 0) + (sign_q(neg(k[i])) > 0);
    about(T, "one of k_0, -k_0, k_7, -k_7 is positive");
    refute(T, positive_ones == 0);
}

/*
:::{claim} first_coefficient_gives_the_sign
:title: Near the beginning the sum has the sign of its first coefficient that is not 0
:zh: t→0+ 时组合函数的符号由首个非零系数决定
:kind: decision
:data: range of β = -21/4 1
:given: $-\frac{21}4<\beta\le1$, printed and corrected functions $B_i=(\nu_i(1-t)+\varphi_it)(1-t)^{7-i}t^i$; $f=\sum_ik_iB_i$
:then: $\nu_0,\dots,\nu_6>0$, $\nu_7\ge0$ and $\varphi_7>0$; so $f=t^i(k_i\nu_i+\dots)$, $i$ the first with
  $k_i\ne0$, has the sign of $k_i$ for small $t>0$, and everywhere in $(0,1)$ where it is the last $i$, too; likewise $\varphi_1,\dots,\varphi_7>0$,
  $\varphi_0\ge0$ and $\nu_0>0$ for the other end
:method: The signs of linear polynomials in $\beta$ on the interval.
:degrees: 7..7
:scope: −21/4 < β ≤ 1
:control: the interval with its left end
:::
*/
CLAIM(first_coefficient_gives_the_sign)
{
    enum cagd_ends ends = fault(T, OPEN_LEFT, CLOSED);
    num range[2];
    given_points(T, "range of β", 2, 1, range);
    num low = range[0], high = range[1];
    for (int printed_ones = 0; printed_ones <= 1; printed_ones++) {
        poly near[8], far[8];
        G(factors_in_beta)(printed_ones, 7, near, far);
        for (int i = 0; i <= 6; i++)
            agree(T, sign_on(near[i], low, high, ends) == SIGN_POSITIVE &&
                         sign_on(far[7 - i], low, high, ends) == SIGN_POSITIVE);
        agree(T, is_nonnegative_on(near[7], low, high) && is_nonnegative_on(far[0], low, high));
    }
}

/*
:::{claim} seven_changes_end_below_zero
:title: When eight numbers of which the first is positive change their sign seven times the last is negative
:zh: k_0>0 且变号七次时 k_7<0
:kind: decision
:given: all sequences of eight signs $-1,0,1$ that begin with 1
:then: the sign changes from 0 to 7 times, and each of these numbers occurs; where it changes seven times, the last is $-1$; where it changes $m$ times
  and the last is not 0, the last is $(-1)^m$
:method: All are counted through.
:degrees: 7..7
:control: those with six changes
:::
*/
CLAIM(seven_changes_end_below_zero)
{
    int found_some = 0, how_often[8] = {0};
    for (int code = 0; code < 2187; code++) {
        num k[8] = {from_int(1)};
        for (int i = 1, rest = code; i <= 7; i++, rest /= 3)
            k[i] = from_int(rest % 3 - 1);
        int changes = G(sign_changes)(7, k);
        agree(T, 0 <= changes && changes <= 7);
        how_often[changes]++;
        agree(T, is_zero_q(k[7]) || (sign_q(k[7]) > 0) == (changes % 2 == 0));
        if (changes != fault(T, 7, 6))
            continue;
        found_some = 1;
        agree(T, sign_q(k[7]) < 0);
    }
    agree(T, found_some);
    for (int changes = 0; changes <= 7; changes++)
        agree(T, how_often[changes] > 0);
}

/*
:::{statement} deng-zhang-2022:property-3.6-case-1
:title: Seven changes of sign: at most seven roots
:zh: 情形 1
:printed: for $k_0>0$ and $SA=7$ one has by a lemma $k_7<0$; $f$ is continuous on $[0,1]$, $f(0)=k_0$, $f(1)=k_7$; with eight roots in $(0,1)$ it would be
  $f(1)=k_7>0$, a contradiction, so that (15) holds
:holds-by: combination_begins_and_ends_with_its_coefficients roots_inside_tell_the_signs_at_the_ends seven_changes_end_below_zero
:confirmed-by: parity_of_the_roots
:figure: roots_at_minus_seven

The lemma that is cited for $k_7<0$ is not in the text.  More than eight roots $f$ has not: as $f(0)=k_0>0$ it is not the zero polynomial, and its degree is at most 8.
:::

:::{statement} deng-zhang-2022:property-3.6-case-2
:title: The cases of six to one changes of sign by the same method
:zh: 情形 2
:printed: for $SA=6,5,4,3,2,1$ it is proved by the same method (definition 2.1: $-7\le\beta\le1$)
:refuted-by: one_change_of_sign_and_three_roots one_change_of_sign_and_two_roots
:class: invalid-proof
:corrected: the method, the signs at the ends, excludes $SA+1$ roots counted with multiplicity when $k_7\ne0$, not $SA+2$;
  when $k_7=0$ it excludes nothing; for $k_0>0$ and $-\frac{21}4\le\beta\le1$ the conclusion is true by total positivity
:corrected-by: combination_begins_and_ends_with_its_coefficients roots_inside_tell_the_signs_at_the_ends seven_changes_end_below_zero
  totally_positive_exactly_in_the_range inversions_of_two_diagonals_meet_a_zero averages_between_neighbours_keep_sign_changes linear_factor_adds_a_change_of_sign
:confirmed-by: roots_are_at_most_sign_changes
:figure: roots_at_minus_seven

With $k_0,k_7\ne0$ the number of roots, counted with multiplicity, is even or odd as $SA$ is, so that it is not $SA+1$.  Since $f(0)=k_0>0$,
$f$ is not the zero function.
:::

The two counterexamples enter the two gaps.  In the first the signs at the ends differ, and an odd number of roots is
allowed: three as well as one.  In the second $f(1)=0$.

:::{claim} one_change_of_sign_and_three_roots
:title: At beta = -7 one change of sign gives three roots
:zh: β=-7 时一次变号而有三个根
:kind: counterexample
:data: β = -7; k = 1 1 200 1 1 1 1 -1
:instead: β = -21/4
:result: roots in (0,1) = 3; SA = 1
:given: the left end of the printed range, and coefficients $k$ with $k_0>0>k_7$; printed functions
:then: $f=\sum k_i\hat B_i$ has more roots in $(0,1)$ than $k$ has changes of sign, by two
:method: The roots of the exact polynomial are counted.
:control: the left end of the true range
:::
*/
CLAIM(one_change_of_sign_and_three_roots)
{
    num k[8];
    poly f = G(given_combination)(T, k);
    int no_more = G(no_more_roots_than_changes)(T, f, k);
    about(T, "there are no more roots than changes of sign");
    agree(T, no_more);
}

/*
:::{claim} one_change_of_sign_and_two_roots
:title: At beta = -7 one change of sign gives two roots when the last coefficient is 0
:zh: β=-7、k_7=0 时一次变号而有两个根
:kind: counterexample
:data: β = -7; k = 1 1 1 1 1 -10 -1 0
:instead: β = -21/4
:result: roots in (0,1) = 2; SA = 1; f(t)/(t-1)² = "630*t^6 - 638*t^5 + 33*t^4 + 4*t^3 + 3*t^2 + 2*t + 1"
:given: the left end of the printed range, and coefficients $k$ with $k_0>0$ and $k_7=0$; printed functions
:then: $f=\sum k_i\hat B_i$ has a double root at 1 and, in $(0,1)$, more roots than $k$ has changes of sign
:method: The roots of the exact polynomial are counted, and it is divided by $(t-1)^2$.
:control: the left end of the true range
:::
*/
CLAIM(one_change_of_sign_and_two_roots)
{
    num k[8], one = from_int(1);
    poly f = G(given_combination)(T, k), double_root = poly_from_q(3, (num[]){one, from_int(-2), one});
    int no_more = G(no_more_roots_than_changes)(T, f, k);
    int divides = poly_divides(double_root, f);
    found_text(T, "f(t)/(t-1)²", divides ? poly_to_string(poly_quotient(f, double_root), "t") : "no polynomial");
    about(T, "there are no more roots than changes of sign");
    agree(T, no_more);
}
#endif

/*
:::{statement} deng-zhang-2022:property-3.6-case-0
:title: No change of sign: obviously no root
:zh: 情形 SA=0
:printed: for $SA=0$ the inequality is obvious (definition 2.1: $-7\le\beta\le1$)
:refuted-by: positive_coefficients_with_two_roots
:class: false
:corrected: for $k\ne0$ obvious where the functions are positive in $(0,1)$, which is for $-\frac{21}4\le\beta\le1$
:corrected-by: nonnegative_exactly_in_the_range each_function_rises_then_falls first_function_falls_and_last_rises
:figure: roots_at_minus_seven

No function is 0 in $(0,1)$ there: $\nu_i,\varphi_i\ge0$ are not both 0 for $0<i<7$, $B_0$ falls from 1 to 0, and $B_7$ is its mirror image.  With $k=0$ every $t$ is a
root, although there is no change of sign.
:::
*/

#include "chapters/judge/claims_off.h"
