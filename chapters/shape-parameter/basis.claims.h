/*
# The eight functions (带参数的基函数)

Every function of the family is a linear factor times $s^{7-i}t^i$, $s=1-t$; it is written here as
$(\nu_is+\varphi_it)s^{7-i}t^i$, so that $\nu_i$ is its factor at $t=0$ and $\varphi_i$ at $t=1$.  Between these two
the factor takes every value in between and no other: on this simple remark most of the section rests.  In the
Bernstein basis of degree 8 function $i$ has the two coefficients $\nu_i/\binom8i$ and $\varphi_i/\binom8{i+1}$.
*/
#include "exact/record/resultant.h"
#include "exact/record/roots.h"

#include "chapters/shape-parameter/definition.h"

#include "chapters/judge/claims_on.h"

/*
:::{statement} deng-zhang-2022:def-2.1
:title: The eight functions with the parameter beta
:zh: 带参数 β 的基函数的定义
:printed: For $t\in[0,1]$, $\beta\in R$ the polynomials in $t$
  $B_{0,7}(t)=(1-\beta t)(1-t)^7$, $B_{1,7}(t)=(7+\beta-5\beta t)(1-t)^6t$, $B_{2,7}(t)=(21+4\beta-9\beta t)(1-t)^5t^2$,
  $B_{3,7}(t)=(35+5\beta-9\beta t)(1-t)^4t^3$, $B_{4,7}(t)=(35+\beta t)(1-t)^3t^4$, $B_{5,7}(t)=(21-5\beta+9\beta t)(1-t)^2t^5$,
  $B_{6,7}(t)=(7-4\beta+5\beta t)(1-t)t^6$, $B_{7,7}(t)=(1-\beta+\beta t)t^7$ are called the basis functions with the parameter $\beta$, where $-7\le\beta\le1$.
:definition: yes
:checked-by: printed_kernel_is_formula_one
:meant: the end of the definition, which is narrower than its beginning, $\beta\in R$ | The range is $-7\le\beta\le1$.
:figure: eight_functions

Outside of what is quoted these functions
are written $\hat B_i$, to be told from the corrected ones, $B_{i,7}$ or $B_{i,n}$.
:::
*/

static num G(any_beta)(trial *T) { return unknown(T, "beta", 0); }

/*
Two kernels follow, one for what is printed and one for what was meant.  That the two differ can be seen before any
property is looked at.  Write the factors of (1) as $\nu_i=\binom7i+b_i\beta$ and $\varphi_i=\binom7i+(b_i+c_i)\beta$,
where $b_i$ and $c_i$ are the printed numbers before $\beta$ and $\beta t$.  Mirror images need $b_i=b_{7-i}+c_{7-i}$, and
the sum 1 needs $b_{i-1}+c_{i-1}+b_i=0$.  Go through the eight lines with a pencil: both rules hold but next to $i=3$ and
$i=4$, and there both ask for $c_3=-5$ and $c_4=5$, where $-9$ and $1$ are printed.

:::{claim} printed_kernel_is_formula_one
:title: The kernel computes the eight printed functions
:zh: 核函数即式 (1)
:given: any $\beta$ and $t$
:then: `shape_basis_printed` gives the eight functions, and `shape_factors_printed` the values $\nu_i$, $\varphi_i$ of their
  linear factors at $t=0$ and $t=1$
:method: The eight formulas written out one by one, $\beta$ and $t$ variables.
:degrees: 7..7
:defines: shape_basis_printed shape_factors_printed
:control: $-\beta$ in the place of $\beta$
:::
*/
CLAIM(printed_kernel_is_formula_one)
{
    num beta = G(any_beta)(T), t = parameter(T, "t"), s = sub(from_int(1), t), B[8], near[8], far[8];
    num given = fault(T, beta, neg(beta));
    G(shape_basis_printed)(given, t, B);
    G(shape_factors_printed)(given, near, far);
    for (int i = 0; i <= 7; i++) {
        about(T, "the function");
        same(T, B[i], G(printed)(i, beta, t));
        about(T, "its linear factor");
        num factor = add(mul(near[i], s), mul(far[i], t));
        same(T, mul(factor, G(product_of_powers)(7 - i, i, t)), G(printed)(i, beta, t));
    }
}

/*
:::{claim} corrected_kernel_is_its_formula
:title: The kernel computes the corrected functions
:zh: 核函数即修正后的基函数
:given: any $\beta$ and $t$
:then: `shape_basis` gives $B_{i,n}$, and `shape_factors` the $\nu_i$, $\varphi_i$ with
  $B_{i,n}=(\nu_i(1-t)+\varphi_it)(1-t)^{n-i}t^i$
:method: The formula with binomial coefficients from factorials, $\beta$ and $t$ variables.
:degrees: 2..9 sampled 16
:defines: shape_basis shape_factors
:control: $-\beta$ in the place of $\beta$
:::
*/
CLAIM(corrected_kernel_is_its_formula)
{
    int n = T->degree;
    num beta = G(any_beta)(T), t = parameter(T, "t"), s = sub(from_int(1), t);
    num B[MAX_DEGREE + 1], near[MAX_DEGREE + 1], far[MAX_DEGREE + 1], given = fault(T, beta, neg(beta));
    G(shape_basis)(n, given, t, B);
    G(shape_factors)(n, given, near, far);
    for (int i = 0; i <= n; i++) {
        num value = G(corrected)(n, i, beta, t), factor = add(mul(near[i], s), mul(far[i], t));
        about(T, "the function");
        same(T, B[i], value);
        about(T, "its linear factor");
        same(T, mul(factor, G(product_of_powers)(n - i, i, t)), value);
    }
}

/*
:::{statement} deng-zhang-2022:sec-2-properties
:title: The eight functions have the properties that follow
:zh: 上述基函数具有以下性质
:printed: the functions above have the following properties: 2.1 to 2.7
:refuted-by: printed_functions_do_not_sum_to_one printed_middle_functions_are_no_mirror_images third_function_is_negative
  second_function_decreases
:class: false
:corrected: with $B_3=(35+5\beta-5\beta t)(1-t)^4t^3$ and $B_4=(35+5\beta t)(1-t)^3t^4$, two digits, the other six as printed,
  the properties 2.2, 2.3 and 2.4 hold for every $\beta$, and so does 2.7, which is about $\beta=0$ alone (2.4 and 2.7 with their indices corrected);
  2.1 and 2.5 hold for $-\frac{21}4\le\beta\le1$; 2.6 does not hold.  With the other six as printed these two functions are the only ones that
  are mirror images with linear factors and make the sum 1
:corrected-by: two_digits_are_corrected mirror_images_with_sum_one_are_unique corrected_functions_sum_to_one
  corrected_functions_are_mirror_images functions_vanish_to_their_orders_at_the_ends beta_zero_gives_bernstein_polynomials
  nonnegative_exactly_in_the_range derivative_of_a_function_factors quadratic_factor_changes_its_sign_once
  each_function_rises_then_falls first_function_falls_and_last_rises signs_of_the_slopes
:confirmed-by: corrected_kernel_is_its_formula
:figure: eight_functions
:striking: 7

Elsewhere these functions are called the corrected ones.  In degree $n$ they are
$B_{i,n}=\binom nis^{n-i}t^i+\beta(a_is^{n+1-i}t^i-a_{i+1}s^{n-i}t^{i+1})$ with $s=1-t$ and
$a_i=\binom{n-2}{i-1}-\binom{n-2}{i-2}$.
:::

The first claim writes the correction out.  The second says that there is no other: leave
six of the functions as they are printed, let the other two be any mirror images with linear factors, and the sum 1 alone
fixes them.

:::{claim} two_digits_are_corrected
:title: The corrected functions of degree seven are the printed ones but for two digits
:zh: 修正只涉及两处数字
:given: any $\beta$ and $t$
:then: $B_{i,7}=\hat B_i$ for $i\ne3,4$, and $B_{3,7}=(35+5\beta-5\beta t)(1-t)^4t^3$,
  $B_{4,7}=(35+5\beta t)(1-t)^3t^4$; $\nu_i$ and $\varphi_i$ are the values of the linear factors at $t=0$ and $t=1$
:method: The kernels of the functions and of the factors against the formulas, $\beta$ and $t$ variables.
:degrees: 7..7
:control: the printed digit 9 in $B_3$
:::
*/
CLAIM(two_digits_are_corrected)
{
    num beta = G(any_beta)(T), t = parameter(T, "t"), s = sub(from_int(1), t), B[8], near[8], far[8];
    G(shape_basis)(7, beta, t, B);
    G(shape_factors)(7, beta, near, far);
    for (int i = 0; i <= 7; i++) {
        num factor = G(printed_factor)(i, beta, t);
        if (i == 3)
            factor = G(three_terms)(35, 5, fault(T, -5, -9), beta, t);
        if (i == 4)
            factor = G(three_terms)(35, 0, 5, beta, t);
        about(T, "the function");
        same(T, B[i], mul(factor, G(product_of_powers)(7 - i, i, t)));
        about(T, "its linear factor");
        same(T, add(mul(near[i], s), mul(far[i], t)), factor);
    }
}

/*
:::{claim} mirror_images_with_sum_one_are_unique
:title: For mirror images with linear factors the sum 1 leaves the two corrected functions
:zh: 修正的唯一性
:given: any $\beta$, and $B_3=(xs+yt)s^4t^3$, $B_4=(ys+xt)s^3t^4$ with any $x$ and $y$, $s=1-t$, the other six functions as
  printed
:then: the sum of the eight functions is $1+(x-35-5\beta)(s^5t^3+s^3t^5)+(2y-70)s^4t^4$; so it is 1 for all $t$ only for
  $x=35+5\beta$, $y=35$
:method: $\beta$, $t$, $x$ and $y$ are variables.  $s^5t^3$, $s^4t^4$, $s^3t^5$ are multiples of three Bernstein polynomials of degree 8, which are
  linearly independent.
:degrees: 7..7
:over: x y: linear factor
:control: the sum without the factor 2
:::
*/
CLAIM(mirror_images_with_sum_one_are_unique)
{
    num beta = G(any_beta)(T), t = parameter(T, "t"), s = sub(from_int(1), t), B[8], sum = from_int(0);
    num x = unknown(T, "x", 0), y = unknown(T, "y", 0);
    G(functions_of)(1, 7, beta, t, B);
    B[3] = mul(add(mul(x, s), mul(y, t)), G(product_of_powers)(4, 3, t));
    B[4] = mul(add(mul(y, s), mul(x, t)), G(product_of_powers)(3, 4, t));
    for (int i = 0; i <= 7; i++)
        sum = add(sum, B[i]);
    /* Σ B_i = 1 + (x - 35 - 5β)(s⁵t³ + s³t⁵) + (2y - 70) s⁴t⁴ */
    num outer = sub(sub(x, from_int(35)), mul(from_int(5), beta));
    num inner = sub(mul(from_int(fault(T, 2, 1)), y), from_int(70));
    num rest = add(mul(outer, add(G(product_of_powers)(5, 3, t), G(product_of_powers)(3, 5, t))),
                   mul(inner, G(product_of_powers)(4, 4, t)));
    same(T, sum, add(from_int(1), rest));
}

/*
## What the words say

The text calls the eight functions polynomials of degree eight, and a basis (基函数).  Both are statements, and both have their
exceptions within the printed range of $\beta$.  The degree is read off the coefficient of $t^8$, which is a multiple of
$\beta$.

:::{statement} deng-zhang-2022:def-2.1-degree
:title: The functions are polynomials of degree eight
:zh: 八次多项式
:printed: a set of polynomial basis functions of degree eight with the shape parameter $\beta$ is given (abstract, introduction and summary)
:holds-by: leading_coefficients_are_multiples_of_beta
:hypothesis: degree_falls_for_beta_zero | $\beta\ne0$; for $\beta=0$ the degree of the first function is 7
:figure: beta_zero

The degree is the exponent of the highest power of $t$.  At most 8 it is for every $\beta$, 0 among them: a linear factor stands before powers of $1-t$
and $t$ whose exponents have the sum 7.
:::

:::{claim} leading_coefficients_are_multiples_of_beta
:title: The coefficient of the eighth power is beta times a whole number that is not 0
:zh: t^8 的系数
:data: c, printed functions = -1 -5 -9 -9 1 9 5 1; c, corrected functions = -1 -5 -9 -5 5 9 5 1
:given: any $\beta$; $c_i$, the number before $\beta t$ in the linear factor of function $i$, printed or corrected
:then: the coefficient of $t^8$ in function $i$ is $(-1)^{7-i}c_i\beta$, and no $c_i$ is 0
:method: The Bernstein coefficients from the kernel, taken to powers of $t$ by `bernstein_to_power`.
:degrees: 7..7
:control: the sign left out
:::
*/
CLAIM(leading_coefficients_are_multiples_of_beta)
{
    num beta = G(any_beta)(T), E[9 * 8], column[9], c[2][8];
    given_points(T, "c, corrected functions", 8, 1, c[0]);
    given_points(T, "c, printed functions", 8, 1, c[1]);
    for (int printed_ones = 0; printed_ones <= 1; printed_ones++) {
        G(matrix_of)(printed_ones, 7, beta, E);
        for (int i = 0; i <= 7; i++) {
            for (int k = 0; k <= 8; k++)
                column[k] = E[k * 8 + i];
            G(bernstein_to_power)(8, column, column);
            int sign = fault(T, (7 - i) % 2 == 0 ? 1 : -1, 1);
            /* (-1)^{7-i} c_i β */
            about(T, "the coefficient");
            same(T, column[8], mul(mul(from_int(sign), c[printed_ones][i]), beta));
            about(T, "the square of the number");
            G(must_be_positive)(T, mul(c[printed_ones][i], c[printed_ones][i]));
        }
    }
}

#if RATIONAL
/*
:::{claim} degree_falls_for_beta_zero
:title: For beta = 0 the first function has degree seven
:zh: β=0 时首个函数的次数为七
:kind: counterexample
:data: β = 0
:instead: β = 1
:result: B_0(t) = "-t^7 + 7*t^6 - 21*t^5 + 35*t^4 - 35*t^3 + 21*t^2 - 7*t + 1"; degree of B_0 = 7
:given: this $\beta$, and the first function $\hat B_0$
:then: its degree is one less than the text says
:method: The degree of the exact polynomial.
:control: a $\beta$ that is not zero
:::
*/
CLAIM(degree_falls_for_beta_zero)
{
    poly B = G(function)(1, 7, 0, given(T, "β"));
    found_text(T, "B_0(t)", poly_to_string(B, "t"));
    found_whole(T, "degree of B_0", poly_degree(B));
    about(T, "the degree is 8");
    agree(T, poly_degree(B) == 8);
}

/*
Independence (线性无关) takes more.  The $9\times8$ matrix of Bernstein coefficients has entries $\nu_i$ in row $i$ and
$\varphi_i$ in the row below, up to positive numbers, and nothing else.  Leave out row $r$, and what remains falls into two
triangles; so the nine minors are the products $\nu_0\cdots\nu_{r-1}\varphi_r\cdots\varphi_7$.  All nine vanish together
only when some $\nu_i$ and some $\varphi_j$ with $j\ge i$ are 0 for one $\beta$.  That $\nu_1$ and $\varphi_6$ vanish
together gives the one exception, $\nu_2$ and $\varphi_5$ give the other.

:::{statement} deng-zhang-2022:def-2.1-basis
:title: The functions are a basis
:zh: 基函数的线性无关性
:printed: the polynomials (1) are called basis functions with the parameter $\beta$, where $-7\le\beta\le1$
:holds-by: functions_are_independent_but_for_two_values inversions_of_two_diagonals_meet_a_zero
:hypothesis: two_functions_coincide | $\beta\ne-7$
:hypothesis: a_combination_vanishes | $\beta\ne-\frac{21}4$
:meant: the name, basis functions (基函数), which is all that is printed | The eight functions are linearly independent, a basis of the space that they span.
:figure: dependent_functions

A basis of all polynomials of degree at most 8 has nine functions, so that these eight are none.
:::

:::{claim} functions_are_independent_but_for_two_values
:title: The functions are linearly independent unless beta is -7 or -21/4
:zh: 线性无关的充要条件
:kind: decision
:data: β = -7 -21/4; k, corrected functions = 0 0 -1 27/5 -27/5 1 0 0
:result: rank, corrected functions = 7 7; rank, printed functions = 7 7; changes of sign of k = 3
:given: all complex $\beta$, the printed and the corrected functions; for the second value of $\beta$ coefficients $k$
:then: the nine determinants of the largest order of the matrix of Bernstein coefficients vanish together exactly for
  two values of $\beta$; for these the rank is that of seven functions; for the second the combinations of the corrected functions that are 0
  are the multiples of $\sum k_iB_i$, whose coefficients change their sign three times
:method: The determinant without row $r$ is, up to positive numbers, the polynomial
  $\nu_0\cdots\nu_{r-1}\varphi_r\cdots\varphi_7$ in $\beta$, since the rows before $r$ leave a lower and those after it an
  upper triangle (`inversions_of_two_diagonals_meet_a_zero`).  The greatest common divisor of the nine is computed; its squarefree part
  has these two roots and no other.  The two ranks by elimination; rank 7 leaves the multiples of one combination, and $\sum k_iB_i$ is the zero polynomial.
:degrees: 7..7
:scope: every complex β
:control: only the last two of the determinants
:::
*/
CLAIM(functions_are_independent_but_for_two_values)
{
    static const char *const rank_of[] = {"rank, corrected functions", "rank, printed functions"};
    num value[2];
    given_points(T, "β", 2, 1, value);
    poly expected = poly_mul(poly_from_q(2, (num[]){neg(value[0]), from_int(1)}),
                             poly_from_q(2, (num[]){neg(value[1]), from_int(1)}));
    for (int printed_ones = 0; printed_ones <= 1; printed_ones++) {
        poly near[8], far[8], divisor = poly_constant(from_int(0)), factor[8], product = poly_constant(from_int(1));
        int multiplicity[8];
        G(factors_in_beta)(printed_ones, 7, near, far);
        for (int r = fault(T, 0, 7); r <= 8; r++) {
            poly determinant = poly_constant(from_int(1));
            for (int i = 0; i <= 7; i++)
                determinant = poly_mul(determinant, i < r ? near[i] : far[i]);
            divisor = poly_gcd(divisor, determinant);
        }
        int factors = poly_squarefree(divisor, factor, multiplicity);
        for (int k = 0; k < factors; k++)
            product = poly_mul(product, factor[k]);
        agree(T, poly_equal(product, expected));
        num rank[2];
        for (int k = 0; k < 2; k++) {
            num E[9 * 8];
            G(matrix_of)(printed_ones, 7, value[k], E);
            rank[k] = from_int(G(rank)(9, 8, E));
            agree(T, equal_q(rank[k], from_int(7)));
        }
        found_points(T, rank_of[printed_ones], 2, 1, rank);
    }
    num k[8];
    given_points(T, "k, corrected functions", 8, 1, k);
    int changes = G(sign_changes)(7, k);
    agree(T, poly_is_zero(G(combination)(0, 7, value[1], k)));
    found_whole(T, "changes of sign of k", changes);
    agree(T, changes == 3);
}

/* Whether sum k_i B_i is the zero polynomial for the printed and for the corrected functions, the eight k given for each. */
static int G(combinations_vanish)(trial *T, num beta)
{
    num printed[8], corrected[8];
    given_points(T, "k, printed functions", 8, 1, printed);
    given_points(T, "k, corrected functions", 8, 1, corrected);
    poly of_printed = G(combination)(1, 7, beta, printed), of_corrected = G(combination)(0, 7, beta, corrected);
    found_text(T, "combination, printed", poly_to_string(of_printed, "t"));
    found_text(T, "combination, corrected", poly_to_string(of_corrected, "t"));
    return poly_is_zero(of_printed) && poly_is_zero(of_corrected);
}

/*
:::{claim} a_combination_vanishes
:title: At beta = -21/4 a combination of four functions is zero
:zh: β=-21/4 时四个函数线性相关
:kind: counterexample
:data: β = -21/4; k, printed functions = 0 0 -25/136 135/136 -27/17 1 0 0; k, corrected functions = 0 0 -1 27/5 -27/5 1 0 0
:instead: β = -5
:result: combination, printed = "0"; combination, corrected = "0"
:given: this $\beta$, and coefficients $k$ for the printed and for the corrected functions
:then: $\sum k_iB_i$ is the zero polynomial, for both
:method: The nine Bernstein coefficients of the combination are computed exactly.
:control: a $\beta$ inside the true range
:::
*/
CLAIM(a_combination_vanishes)
{
    int both_vanish = G(combinations_vanish)(T, given(T, "β"));
    about(T, "one of the combinations is not 0");
    refute(T, both_vanish);
}

/*
:::{claim} two_functions_coincide
:title: At beta = -7 the printed functions are linearly dependent, and two of the corrected ones are the same
:zh: β=-7 时函数线性相关，修正后 B_3=B_4
:kind: counterexample
:data: β = -7; k, printed functions = 0 0 0 50/9 -10 5 1 0; k, corrected functions = 0 0 0 1 -1 0 0 0
:instead: β = -6
:result: combination, printed = "0"; combination, corrected = "0";
  B_3, corrected = "35*t^8 - 140*t^7 + 210*t^6 - 140*t^5 + 35*t^4";
  B_4, corrected = "35*t^8 - 140*t^7 + 210*t^6 - 140*t^5 + 35*t^4"
:given: this $\beta$, and coefficients $k$ for the printed and for the corrected functions
:then: $\sum k_iB_i$ is the zero polynomial, for both; for the corrected functions it is the difference of $B_3$ and $B_4$
:method: The nine Bernstein coefficients of the combination are computed exactly.
:control: another $\beta$ below the true range
:::
*/
CLAIM(two_functions_coincide)
{
    num beta = given(T, "β");
    int both_vanish = G(combinations_vanish)(T, beta);
    found_text(T, "B_3, corrected", poly_to_string(G(function)(0, 7, 3, beta), "t"));
    found_text(T, "B_4, corrected", poly_to_string(G(function)(0, 7, 4, beta), "t"));
    about(T, "one of the combinations is not 0");
    refute(T, both_vanish);
}
#endif

/*
## Sum one (权性)

Row $k$ of the matrix has the sum $(\varphi_{k-1}+\nu_k)/\binom8k$, and the functions add up to 1 exactly when all nine sums
are 1.  With the printed numbers two are not.  Both differ from 1 by $-4\beta$ over the binomial coefficient, which leaves
$-4\beta(s^4t^4+s^3t^5)=-4\beta s^3t^4$ for the sum of the functions.  This error is small, which may be why it stayed in
print; but the whole geometry of the curve rests on the sum, and the next section meets it again and again.

:::{statement} deng-zhang-2022:property-2.2
:title: The functions add up to one
:zh: 权性，式 (3)
:printed: \sum_{i=0}^7B_{i,7}(t)\equiv1
:refuted-by: printed_functions_do_not_sum_to_one
:class: misprint
:corrected: the printed functions add up to $1-4\beta(1-t)^3t^4$, which is 1 for all $t$ only if $\beta=0$; the corrected
  functions (`sec-2-properties`) add up to 1 for every $\beta$ and $t$
:corrected-by: printed_sum_in_closed_form corrected_functions_sum_to_one
:figure: eight_functions
:::
*/

#if RATIONAL
/*
:::{claim} printed_functions_do_not_sum_to_one
:title: The printed functions do not add up to one
:zh: 式 (1) 之和不为一
:kind: counterexample
:data: β = -1; t = 1/2
:result: B(t) = 3/256 17/256 43/256 69/256 69/256 43/256 17/256 3/256; sum = 33/32
:given: the value of $\beta$ for which figure 1 is drawn, and the middle of the interval
:then: the sum of the eight printed functions is greater than 1
:method: The eight formulas are evaluated and added.
:control: the corrected functions
:::
*/
CLAIM(printed_functions_do_not_sum_to_one)
{
    num beta = given(T, "β"), t = given(T, "t"), B[8], sum = from_int(0);
    G(functions_of)(fault(T, 0, 1), 7, beta, t, B);
    for (int i = 0; i <= 7; i++)
        sum = add(sum, B[i]);
    found_points(T, "B(t)", 8, 1, B);
    found(T, "sum", sum);
    about(T, "the sum of the functions and 1");
    same(T, sum, from_int(1));
}
#endif

/*
:::{claim} printed_sum_in_closed_form
:title: The sum of the printed functions
:zh: 式 (1) 各函数之和
:given: any $\beta$ and $t$
:then: $\sum\hat B_i(t)=1-4\beta(1-t)^3t^4$
:method: Both sides are one polynomial in $\beta$ and $t$.
:degrees: 7..7
:control: the exponents 3 and 4 exchanged
:::
*/
CLAIM(printed_sum_in_closed_form)
{
    num beta = G(any_beta)(T), t = parameter(T, "t"), B[8], sum = from_int(0);
    G(functions_of)(1, 7, beta, t, B);
    for (int i = 0; i <= 7; i++)
        sum = add(sum, B[i]);
    num product = G(product_of_powers)(fault(T, 3, 4), fault(T, 4, 3), t);
    /* Σ B̂_i = 1 - 4β (1-t)³ t⁴ */
    same(T, sum, sub(from_int(1), mul(from_int(4), mul(beta, product))));
}

/*
:::{claim} corrected_functions_sum_to_one
:title: The corrected functions add up to one
:zh: 修正后的权性
:given: any $\beta$ and $t$
:then: $\sum B_{i,n}(t)=1$
:method: The kernel's functions are added, $\beta$ and $t$ variables.
:degrees: 2..10 sampled 20
:control: the first function left out
:::
*/
CLAIM(corrected_functions_sum_to_one)
{
    int n = T->degree;
    num beta = G(any_beta)(T), t = parameter(T, "t"), B[MAX_DEGREE + 1], sum = from_int(0);
    G(shape_basis)(n, beta, t, B);
    for (int i = fault(T, 0, 1); i <= n; i++)
        sum = add(sum, B[i]);
    same(T, sum, from_int(1));
}

/*
## Symmetry (对称性)

Of the four equations (4) the first three survive.  Whoever wants to test the fourth should not choose $t=\frac12$: the
difference of its sides has the factor $1-2t$, and in the middle of the interval everything looks right.

:::{statement} deng-zhang-2022:property-2.3
:title: The functions are mirror images of each other
:zh: 对称性，式 (4)
:printed: $B_{0,7}(1-t)=B_{7,7}(t)$, $B_{1,7}(1-t)=B_{6,7}(t)$, $B_{2,7}(1-t)=B_{5,7}(t)$, $B_{3,7}(1-t)=B_{4,7}(t)$
:refuted-by: printed_middle_functions_are_no_mirror_images
:class: misprint
:corrected: for $i=0,1,2$ as printed; for the printed $\hat B_3$ and $\hat B_4$ it is $\hat B_3(1-t)-\hat B_4(t)=-4\beta(1-2t)(1-t)^3t^4$, so that the fourth equation holds for
  all $t$ only if $\beta=0$; the corrected functions (`sec-2-properties`) have all four for every $\beta$
:corrected-by: printed_outer_functions_are_mirror_images corrected_functions_are_mirror_images
:figure: eight_functions
:::
*/

#if RATIONAL
/*
:::{claim} printed_middle_functions_are_no_mirror_images
:title: The fourth and fifth printed function are not mirror images
:zh: 式 (4) 第四式不成立
:kind: counterexample
:data: β = -1; t = 1/4
:result: B_3(1-t) = 3969/65536; B_4(t) = 3753/65536
:given: $\beta$ and $t$
:then: $\hat B_3(1-t)\ne\hat B_4(t)$
:method: Both values of the printed formulas.
:control: the corrected functions
:::
*/
CLAIM(printed_middle_functions_are_no_mirror_images)
{
    num beta = given(T, "β"), t = given(T, "t"), left[8], right[8];
    int printed_ones = fault(T, 0, 1);
    G(functions_of)(printed_ones, 7, beta, sub(from_int(1), t), left);
    G(functions_of)(printed_ones, 7, beta, t, right);
    found(T, "B_3(1-t)", left[3]);
    found(T, "B_4(t)", right[4]);
    about(T, "B_3(1-t) and B_4(t)");
    same(T, left[3], right[4]);
}
#endif

/*
:::{claim} printed_outer_functions_are_mirror_images
:title: Six of the printed functions are mirror images, the other two differ by a product
:zh: 式 (1) 的对称性
:given: any $\beta$ and $t$
:then: $\hat B_i(1-t)=\hat B_{7-i}(t)$ for $i=0,1,2$, and $\hat B_3(1-t)-\hat B_4(t)=-4\beta(1-2t)(1-t)^3t^4$
:method: The formulas at $1-t$ and at $t$, both variables.
:degrees: 7..7
:control: $1-2t$ replaced by $1-t$
:::
*/
CLAIM(printed_outer_functions_are_mirror_images)
{
    num beta = G(any_beta)(T), t = parameter(T, "t"), s = sub(from_int(1), t), left[8], right[8];
    G(functions_of)(1, 7, beta, s, left);
    G(functions_of)(1, 7, beta, t, right);
    for (int i = 0; i <= 2; i++)
        same(T, left[i], right[7 - i]);
    num middle = fault(T, sub(s, t), s);
    /* B̂_3(1-t) - B̂_4(t) = -4β (1-2t)(1-t)³ t⁴ */
    num product = mul(mul(from_int(-4), mul(beta, middle)), G(product_of_powers)(3, 4, t));
    same(T, sub(left[3], right[4]), product);
}

/*
:::{claim} corrected_functions_are_mirror_images
:title: The corrected functions are mirror images of each other
:zh: 修正后的对称性
:given: any $\beta$ and $t$
:then: $B_{i,n}(1-t)=B_{n-i,n}(t)$ for all $i$
:method: The kernel at $1-t$ and at $t$, $\beta$ and $t$ variables.
:degrees: 2..9 sampled 16
:control: $-\beta$ on the right
:::
*/
CLAIM(corrected_functions_are_mirror_images)
{
    int n = T->degree;
    num beta = G(any_beta)(T), t = parameter(T, "t"), left[MAX_DEGREE + 1], right[MAX_DEGREE + 1];
    G(shape_basis)(n, beta, sub(from_int(1), t), left);
    G(shape_basis)(n, fault(T, beta, neg(beta)), t, right);
    for (int i = 0; i <= n; i++)
        same(T, left[i], right[n - i]);
}

/*
## At the ends (端点性质)

Function $i$ has the factor $t^i$ and the factor $(1-t)^{n-i}$, whatever $\beta$ is; this is all of (5) to (8).

:::{statement} deng-zhang-2022:property-2.4-5
:title: The first function is one at the beginning
:zh: 式 (5)
:printed: B_{0,7}(0)=1
:holds-by: functions_vanish_to_their_orders_at_the_ends
:figure: eight_functions
:::
*/

/* The derivatives of order 0, ..., r of function i at `at`. */
static void G(function_derivatives)(int printed_ones, int n, int i, num beta, num at, int r, num D[])
{
    num E[(MAX_DEGREE + 1) * MAX_DEGREE], column[MAX_DEGREE + 1];
    G(matrix_of)(printed_ones, n, beta, E);
    for (int k = 0; k <= n + 1; k++)
        column[k] = E[k * (n + 1) + i];
    G(bezier_derivatives)(n + 1, 1, column, at, r, D);
}

/*
:::{claim} functions_vanish_to_their_orders_at_the_ends
:title: Function i vanishes at least i-fold at 0 and (7-i)-fold at 1
:zh: 端点处的零点重数
:given: any $\beta$, printed and corrected functions, $i=0,\dots,7$
:then: the derivatives of orders $0,\dots,i-1$ vanish at $t=0$, those of orders $0,\dots,6-i$ at $t=1$;
    function 0 is 1 at $t=0$, function 7 at $t=1$
:method: The derivatives of the polynomial whose Bernstein coefficients the kernel gives, $\beta$ a variable.
:degrees: 7..7
:control: the orders at 1 reach one too far
:::
*/
CLAIM(functions_vanish_to_their_orders_at_the_ends)
{
    num beta = G(any_beta)(T), D[10], zero = from_int(0), one = from_int(1);
    for (int printed_ones = 0; printed_ones <= 1; printed_ones++)
        for (int i = 0; i <= 7; i++) {
            G(function_derivatives)(printed_ones, 7, i, beta, zero, 8, D);
            about(T, "at t = 0");
            for (int k = 0; k < i; k++)
                vanishes(T, D[k]);
            if (i == 0)
                same(T, D[0], one);
            G(function_derivatives)(printed_ones, 7, i, beta, one, 8, D);
            about(T, "at t = 1");
            for (int k = 0; k < fault(T, 7 - i, 8 - i); k++)
                vanishes(T, D[k]);
            if (i == 7)
                same(T, D[0], one);
        }
}

/*
:::{statement} deng-zhang-2022:property-2.4-6
:title: Values and derivatives that vanish at the beginning
:zh: 式 (6)
:printed: $B_{i,7}(0)=0$ for $i=1,\dots,7$; $B_{i,7}'(0)=0$ for $i=2,\dots,7$; $B_{j,j}^{(k)}(0)=0$ for
  $2\le k<j\le7$
:holds-by: functions_vanish_to_their_orders_at_the_ends
:meant: definition 2.1, which has no functions but $B_{0,7},\dots,B_{7,7}$ | $B_{3,3},B_{4,4},\dots$, from the second derivative on, are $B_{3,7},B_{4,7},\dots$.
:reading: functions_of_lower_degree_vanish_at_the_beginning | $B_{j,j}$ to the letter, the last of the functions $B_{i,j}$ of the
  family in degree $j$, $3\le j\le7$, or of those of Bernstein: then, too, $B_{j,j}^{(k)}(0)=0$ for $2\le k<j$
:figure: eight_functions
:::

:::{claim} functions_of_lower_degree_vanish_at_the_beginning
:title: The last function of any degree vanishes to its order at the beginning
:zh: B_{j,j} 在 t=0 的零点重数
:given: any $\beta$, the functions $B_{n,n}$ of the family and $B_n^n$ of Bernstein
:then: all their derivatives of orders $0,\dots,n-1$ vanish at $t=0$
:method: The derivatives of the polynomials by their Bernstein coefficients, $\beta$ a variable.
:degrees: 2..9
:control: the order $n$ as well
:::
*/
CLAIM(functions_of_lower_degree_vanish_at_the_beginning)
{
    int n = T->degree;
    num D[MAX_DEGREE + 1];
    for (int bernstein_too = 0; bernstein_too <= 1; bernstein_too++) {
        num beta = bernstein_too ? from_int(0) : G(any_beta)(T);
        G(function_derivatives)(0, n, n, beta, from_int(0), n, D);
        for (int k = 0; k < fault(T, n, n + 1); k++)
            vanishes(T, D[k]);
    }
}

/*
:::{statement} deng-zhang-2022:property-2.4-7
:title: The last function is one at the end
:zh: 式 (7)
:printed: B_{7,7}(1)=1
:holds-by: functions_vanish_to_their_orders_at_the_ends
:figure: eight_functions
:::

:::{statement} deng-zhang-2022:property-2.4-8
:title: Values and derivatives that vanish at the end
:zh: 式 (8)
:printed: $B_{j,7}(1)=0$ for $j\le6$; $B_{5,7}'(1)=0$, and $B_{j,5}'(1)=0$ for $j\le4$; $B_{j,7}''(1)=0$ for $j\le4$;
  $B_{j,5}'''(1)=0$ for $j\le3$; $B_{j,7}^{(k)}(1)=0$ for $j\le6-k$, $k=4,5,6$
:refuted-by: derivative_of_degree_five_does_not_vanish
:class: misprint
:corrected: for the printed functions $\hat B_j$, and for the corrected ones (`sec-2-properties`), $\hat B_j^{(k)}(1)=0$ for $k+j\le6$: the index 5 of $B_{4,5}$ and the others is 7
:corrected-by: functions_vanish_to_their_orders_at_the_ends
:figure: degree_five_at_the_end

To the letter $B_{4,5}$ is a function of the family in degree five, whose formula is in the remarks of `sec-2-properties`, or that of Bernstein; the
counterexample has both.
:::
*/

#if RATIONAL
/*
The lists (6) and (8) are both printed with second indices of other degrees.  In (6) no harm is done, because the last
function of any degree $j$ has the factor $t^j$.  In (8) the same slip puts too few factors $1-t$ before a derivative.

:::{claim} derivative_of_degree_five_does_not_vanish
:title: In degree five the derivative of the last but one function at 1 is not zero
:zh: B'_{4,5}(1)≠0
:kind: counterexample
:data: n = 5; i = 4; β = -1 0
:instead: n = 7
:result: B_{i,n}'(1) = -4 -5
:given: the last but one function $B_{i,n}$ of degree five for two values of $\beta$, the second of which gives that of
  Bernstein
:then: $B_{i,n}'(1)\ne0$ for both
:method: The derivatives at 1 of the polynomials are computed exactly.
:control: the function of the same index in degree seven
:::
*/
CLAIM(derivative_of_degree_five_does_not_vanish)
{
    int n = given_whole(T, "n"), i = given_whole(T, "i"), vanishing = 0;
    num beta[2], slope[2];
    given_points(T, "β", 2, 1, beta);
    for (int k = 0; k < 2; k++) {
        num D[2];
        G(function_derivatives)(0, n, i, beta[k], from_int(1), 1, D);
        slope[k] = D[1];
        vanishing += is_zero_q(slope[k]);
    }
    found_points(T, "B_{i,n}'(1)", 2, 1, slope);
    about(T, "whether one of the derivatives at 1 is 0");
    agree(T, vanishing > 0);
}
#endif

/*
## The Bernstein polynomials among them

:::{statement} deng-zhang-2022:property-2.7
:title: For beta = 0 the functions are the Bernstein polynomials
:zh: β=0 时退化为 Bernstein 基，式 (9)
:printed: for $\beta=0$ and every $i=0,\dots,7$: $B_{0,7}(t)=B_i^7(t)$
:refuted-by: first_function_is_not_every_bernstein_polynomial
:class: misprint
:corrected: for $\beta=0$, $B_{i,7}(t)=B_i^7(t)$: the index 0 on the left is $i$; so for the functions $\hat B_i$ that are printed and for the corrected ones (`sec-2-properties`)
:corrected-by: beta_zero_gives_bernstein_polynomials
:figure: beta_zero
:degree: 7
:::

:::{statement} deng-zhang-2022:property-2.7-extension
:title: The functions extend the Bernstein polynomials of degree seven
:zh: 七次 Bernstein 基函数的拓展
:printed: property 2.7 says that the functions of (1) are an extension of the Bernstein basis of degree seven (the extension also in the abstract)
:holds-by: beta_zero_gives_bernstein_polynomials
:meant: its words "for every $i=0,\dots,7$" | Property 2.7 is $B_{i,7}(t)=B_i^7(t)$ for $\beta=0$; the index 0 printed in (9) is $i$.
:figure: beta_zero
:degree: 7
:::
*/

#if RATIONAL
/*
:::{claim} first_function_is_not_every_bernstein_polynomial
:title: For beta = 0 the first function is not the second Bernstein polynomial
:zh: 式 (9) 的下标误印
:kind: counterexample
:data: β = 0; i = 1; t = 1/2
:result: left side of (9) = 1/128; right side of (9) = 7/128
:given: $\beta$, for which formula (9) is printed, an index $i$ and a parameter $t$
:then: $B_{0,7}(t)$, on the left of the formula, is not $B_i^7(t)$, on the right
:method: Both values, the second by the kernel of the Bernstein basis.
:control: $B_{i,7}(t)$ on the left
:::
*/
CLAIM(first_function_is_not_every_bernstein_polynomial)
{
    num beta = given(T, "β"), B[8], b[8];
    int i = given_whole(T, "i");
    num t = given(T, "t");
    G(functions_of)(1, 7, beta, t, B);
    G(bernstein_basis)(7, t, b);
    num left = B[fault(T, i, 0)];
    found(T, "left side of (9)", left);
    found(T, "right side of (9)", b[i]);
    about(T, "the left and the right side of (9) for this i");
    same(T, left, b[i]);
}
#endif

/*
:::{claim} beta_zero_gives_bernstein_polynomials
:title: For beta = 0 function i is the Bernstein polynomial i
:zh: β=0 时 B_{i,n}=B_i^n
:given: any $t$, every $i$
:then: $B_{i,n}=B_i^n$ for $\beta=0$; for $n=7$ also $\hat B_i=B_i^7$
:method: The kernel, and the eight printed formulas, against binomial coefficients and powers, at a variable $t$.
:degrees: 2..9 sampled 16
:control: $\beta=1$
:::
*/
CLAIM(beta_zero_gives_bernstein_polynomials)
{
    int n = T->degree;
    num beta = from_int(fault(T, 0, 1)), t = parameter(T, "t"), B[MAX_DEGREE + 1];
    G(shape_basis)(n, beta, t, B);
    for (int i = 0; i <= n; i++)
        same(T, B[i], mul(G(choose)(n, i), G(product_of_powers)(n - i, i, t)));
    if (n == 7) {
        G(functions_of)(1, 7, beta, t, B);
        for (int i = 0; i <= n; i++)
            same(T, B[i], mul(G(choose)(n, i), G(product_of_powers)(n - i, i, t)));
    }
}

/*
:::{statement} deng-zhang-2022:fig-1
:title: The picture of the eight functions for beta = -1
:zh: 图 1
:printed: figure 1 shows the eight functions for $\beta=-1$
:degree: 7
:reading: that the eight functions drawn are those of (1) as printed, or the corrected ones (`sec-2-properties`): the figure is not in the text that
  was examined, so that nothing is there to be decided
:reading: printed_sum_in_closed_form | that the eight functions of the figure, if they are those of (1) as printed, have the sum $1+4(1-t)^3t^4$
:reading: corrected_functions_sum_to_one | that the eight functions of the figure, if they are the corrected ones (`sec-2-properties`), have the sum 1
:figure: eight_functions
:::
*/
#include "chapters/judge/claims_off.h"
