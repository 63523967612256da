/*
# The table in a machine (规格化差分与舍入)

In a word of fixed length the small differences lose their digits first.  The source divides them by the powers of the
step, which makes them as large as the coefficients, and begins the table with the coefficients themselves.
*/
#include "chapters/foundations/definition.h"

#if RATIONAL
/* The kernels in binary64 beside the rational ones. */
#undef G
#include "core/kernels/kernels_d.h"
#define G(name) name##_q
#endif

#include "chapters/judge/claims_on.h"

/*
:::{statement} hu-1987:1-4-small-differences
:title: The differences after the third are small
:zh: 高阶差分已相当小
:printed: For $\delta=1/2^8$ the differences after $\Delta^3P_0$ have in fact become rather small.
:holds-by: third_difference_loses_three_bytes
:meant: the next sentence, which takes $1/\delta$, $1/\delta^2$ and $1/\delta^3$ times the differences, which are then
  of the size of the coefficients | Against the coefficients of the curve these differences are small, the third as well.
:reading: third_difference_loses_three_bytes | the differences of order 4 and more are small: they are 0
:reading: third_difference_loses_three_bytes | the differences from the third on are small against the coefficients: $\Delta^3P_0=6A/2^{24}$, and the further ones are 0
:reading: third_difference_exceeds_the_first | the differences from the third on are small against those before the third
:figure: forward_differences
:::

:::{claim} third_difference_loses_three_bytes
:title: The size of the differences for the step 1/256
:zh: 步长 1/256 时各阶差分的大小
:given: $P(t)=At^3+Bt^2+Ct+D$, $\delta=\frac1n$ with $n=2^m=256$, any coefficients
:data: n = 256; m = 8
:instead: n = 128
:then: $\Delta^3P_0$ is six times $A/2^{3m}$; the difference of order 4 is 0 at every $t$, and so are those of higher order, which are its differences
:method: The third difference by the kernel; the fourth from the five points at $t,t+\delta,\dots$ by subtractions; everything but the step a variable.
:scope: δ = 1/256
:over: c#: coefficients; t: -
:control: twice the step
:::
*/
CLAIM(third_difference_loses_three_bytes)
{
    num c[4], d[4], delta = div(from_int(1), given(T, "n")), scale = from_ratio(1, 1L << 3 * given_whole(T, "m"));
    num t = parameter(T, "t"), values[5];
    for (int k = 0; k < 4; k++)
        c[k] = unknown(T, "c", k);
    G(power_differences)(3, 1, c, delta, d);
    about(T, "the third difference");
    same(T, d[3], mul(c[3], mul(from_int(6), scale))); /* Δ³P_0 = 6 A δ³ */
    for (int i = 0; i < 5; i++)
        values[i] = G(power_sum)(3, 1, c, 0, add(t, mul(from_int(i), delta)));
    for (int k = 1; k < 5; k++)
        for (int i = 0; i < 5 - k; i++)
            values[i] = sub(values[i + 1], values[i]);
    about(T, "the fourth difference");
    vanishes(T, values[0]);
}

#if RATIONAL
/*
:::{claim} third_difference_exceeds_the_first
:title: The third difference is six times the first
:zh: 三阶差分为一阶差分的六倍
:kind: counterexample
:given: the cubic $P(t)=\sum_kc_kt^k$, that is with the coefficients $c$ from $D$ to $A$, and $\delta$; the differences at $t=0$
:data: c = 0 0 0 1; δ = 1/256
:instead: c = 0 1 0 1
:then: $\Delta^3P_0$ is larger than $\Delta P_0$
:result: P_0, ΔP_0, Δ²P_0, Δ³P_0 = 0 1/16777216 3/8388608 3/8388608; Δ³P_0 / ΔP_0 = 6
:method: The table by the kernel; that the third is less than the first is refuted.
:control: a cubic with a linear term
:::
*/
CLAIM(third_difference_exceeds_the_first)
{
    num c[4], d[4];
    given_points(T, "c", 4, 1, c);
    G(power_differences)(3, 1, c, given(T, "δ"), d);
    found_points(T, "P_0, ΔP_0, Δ²P_0, Δ³P_0", 4, 1, d);
    found(T, "Δ³P_0 / ΔP_0", div(d[3], d[1]));
    about(T, "whether the third difference is less than the first");
    agree(T, compare_q(d[3], d[1]) < 0);
}
#endif

/*
Small compared with what?  With the coefficients, the third difference is small as the cube of the step.  With the other
differences it need not be: for $t^3$ it is larger than the first.  What matters to a machine is the comparison with the
coefficients, and it suggests to keep $\frac1{\delta^k}\cdot\Delta^kP$ instead.

:::{statement} hu-1987:1-4-4
:title: The step of the scaled table
:zh: 规格化差分的递推
:printed: $P_1=P_0+\delta\bigl(\frac1\delta\cdot\Delta P_0\bigr)$, $\frac1\delta\cdot\Delta P_1=\frac1\delta\cdot\Delta
  P_0+\delta\bigl(\frac1{\delta^2}\cdot\Delta^2P_0\bigr)$, $\frac1{\delta^2}\cdot\Delta^2P_1=\frac1{\delta^2}\cdot\Delta^2P_0+\delta\bigl(\frac1{\delta^3}\cdot\Delta^3P_0\bigr)$,
  $\frac1{\delta^3}\cdot\Delta^3P_1=\frac1{\delta^3}\cdot\Delta^3P_0$
:holds-by: printed_divided_lines_step_a_cubic
:confirmed-by: step_takes_differences_to_the_next_place
:meant: the words before, by which additions lead from $t=0$ to $\delta,2\delta,\dots$ one after the other | $P_1,\Delta P_1,\Delta^2P_1,\Delta^3P_1$ are the differences at
  $t=\delta$, not at the $t=i\delta$ that is printed for them.
:figure: forward_differences
:::

:::{statement} hu-1987:1-4-5
:title: The table to begin with
:zh: 初始差分矩阵
:printed: \begin{bmatrix}P_0\\\frac1\delta\cdot\Delta
  P_0\\\frac1{\delta^2}\cdot\Delta^2P_0\\\frac1{\delta^3}\cdot\Delta^3P_0\end{bmatrix}=\begin{bmatrix}D\\A\delta^2+B\delta+C\\6A\delta+2B\\6A\end{bmatrix}
:holds-by: scaled_table_is_as_printed
:figure: forward_differences
:::

:::{claim} scaled_table_is_as_printed
:title: The rows of the table to begin with
:zh: 初始差分
:given: the cubic $P(t)=At^3+Bt^2+Ct+D$ with any $A,B,C,D$ in space, any $\delta\ne0$
:where: $\delta\ne0$
:then: $P_0$, $\frac1\delta\cdot\Delta P_0$, $\frac1{\delta^2}\cdot\Delta^2P_0$, $\frac1{\delta^3}\cdot\Delta^3P_0$ are $D$, $A\delta^2+B\delta+C$, $6A\delta+2B$, $6A$, and $P_0,\dots,\Delta^3P_0$ are
  the rows of `power_differences`
:method: Differences of differences from $P(0),P(\delta),P(2\delta),P(3\delta)$, by the definition, against the printed expressions and the kernel, everything a variable.
:over: x# y# z#: coefficients; d: δ
:control: $3A$ in the last row
:::
*/
CLAIM(scaled_table_is_as_printed)
{
    enum { space = 3 };
    num c[4 * space], d[4 * space], delta = positive(T, "d", 0);
    G(free_points)(T, 3, space, c);
    G(power_differences)(3, space, c, delta, d);
    for (int j = 0; j < space; j++) {
        num D = c[j], C = c[space + j], B = c[2 * space + j], A = c[3 * space + j], six_A = mul(from_int(6), A);
        num rows[4] = {D, add(add(mul(A, mul(delta, delta)), mul(B, delta)), C),
                       add(mul(six_A, delta), mul(from_int(2), B)), fault(T, six_A, mul(from_int(3), A))};
        num at[4], power = from_int(1); /* Δ^k P at 0, δ, 2δ, ... */
        for (int i = 0; i <= 3; i++)
            at[i] = G(power_sum)(3, space, c, j, mul(from_int(i), delta));
        for (int k = 0; k <= 3; k++, power = mul(power, delta)) {
            about(T, "the rows as printed");
            same(T, div(at[0], power), rows[k]);
            about(T, "the rows of the kernel");
            same(T, d[k * space + j], at[0]);
            for (int i = 0; i < 3 - k; i++)
                at[i] = sub(at[i + 1], at[i]);
        }
    }
}

/*
The word matrix is used for two things here.  One is the first column of the table, four rows with as many entries as
there are coordinates; the other is the step, which multiplies such a column and is square.  The number $4\times3$
belongs to the first, the formulas that stand above the sentence to the second.

:::{statement} hu-1987:1-4-difference-matrix
:title: The matrix of differences
:zh: 差分矩阵
:printed: Written as a matrix, the formulas above give the $4\times3$ matrix of differences (1-4-5).
:holds-by: scaled_table_is_as_printed
:confirmed-by: step_multiplies_by_a_square_matrix
:meant: the formula (1-4-5) that follows, and the number $4\times3$ | The formulas above are those of the differences, at $t=0$ and divided by the powers of
  $\delta$; each difference is a row with the three coordinates of space.
:figure: forward_differences

The step (1-4-4), which stands above the sentence, has a matrix as well, with four rows and four columns:
`step_multiplies_by_a_square_matrix`.
:::

:::{claim} step_multiplies_by_a_square_matrix
:title: The step of the scaled table is a matrix with four rows and four columns
:zh: 差分递推的方阵
:given: any four rows $d_0,\dots,d_3$ with three coordinates, any $\delta$
:then: `power_scaled_difference_step` multiplies them from the left by the matrix with 1 in the diagonal and $\delta$ to the right of it
:method: The kernel against the product of the matrices, everything a variable.
:over: x# y# z#: rows; d: δ
:control: $\delta$ to the left of the diagonal
:::
*/
CLAIM(step_multiplies_by_a_square_matrix)
{
    enum { space = 3 };
    num d[4 * space], next[4 * space], delta = parameter(T, "d");
    G(free_points)(T, 3, space, d);
    for (int k = 0; k < 4; k++)
        for (int j = 0; j < space; j++) {
            num sum = from_int(0);
            for (int i = 0; i < 4; i++) {
                num entry = i == k ? from_int(1) : i == fault(T, k + 1, k - 1) ? delta : from_int(0);
                sum = add(sum, mul(entry, d[i * space + j]));
            }
            next[k * space + j] = sum;
        }
    G(power_scaled_difference_step)(3, space, delta, d);
    for (int m = 0; m < 4 * space; m++)
        same(T, d[m], next[m]);
}

/*
:::{statement} hu-1987:1-4-fast
:title: With powers of two the points are computed at high speed
:zh: 步长为 2 的幂时高速计算
:printed: With $\delta=1/2^m$, $m$ a positive whole number, the points of the curve are computed at high speed by the formulas above, (1-4-4).
:holds-by: step_costs_additions_only table_costs_shifts_and_additions rows_by_shifts_are_the_table printed_divided_lines_step_a_cubic
  step_takes_differences_to_the_next_place table_after_any_number_of_steps table_is_whole_in_units_of_the_cube
:confirmed-by: stepping_reaches_the_other_end stepping_is_exact_for_short_coefficients
:meant: the sentence before the differences of (1-4-1), by which shifts and additions are enough, and thereby (从而) the speed is high | High speed is: with shifts and additions
  in the place of products.
:hypothesis: short_words_lose_the_end | the machine's words are long enough: a shift that drops bits is no product, and the curve would be another one.  With $3m$ binary
  places behind the point more than the coefficients have, and room before it, they hold every row exactly.  Words with 8 places may lose the end.
:figure: stepping_and_rounding
:::

## What rounding does to the table

A step has no multiplication, but every point inherits the errors of all points before it.  With $\delta=2^{-m}$ there
may be none: the numbers that occur have $3m$ binary places more than the coefficients.  With $\delta=1/n$ for other
$n$, the differences are rounded before the first step, and an error of $\Delta^3P_0$ is multiplied by $\binom n3$ on
the way.  How large it is depends on how the table is begun: differences of rounded points inherit the roundoff of the
points, and the rows of (1-4-5) only that of their own, small, size.

:::{claim} table_is_whole_in_units_of_the_cube
:title: The table of a cubic has 3m binary places more than its coefficients, and needs no more
:zh: 差分表比系数多 3m 位
:given: $\delta=\frac1N$, any $N>0$, such as $N=2^m$; any coefficients of degree 3
:then: $N^3$ times the four rows are $N^3D$, $A+BN+CN^2$, $6A+2BN$ and $6A$; so where the coefficients are whole in units of $2^{-b}$ the rows are whole in
  units of $2^{-b-3m}$, and remain so, as only sums are formed; the rows of (1-4-4) are these times $1$, $N$, $N^2$ and $N^3$, and so are whole in these
  units, too
:method: The kernel's table, everything a variable; the polynomials in $N$ have whole coefficients.
:over: N: -; x#: coefficients
:control: $N^2$ in the place of $N^3$
:::
*/
CLAIM(table_is_whole_in_units_of_the_cube)
{
    num c[4], d[4], N = positive(T, "N", 0), NN = mul(N, N), cube = mul(NN, fault(T, N, from_int(1)));
    G(free_points)(T, 3, 1, c);
    G(power_differences)(3, 1, c, div(from_int(1), N), d);
    num six_A = mul(from_int(6), c[3]);
    num rows[4] = {mul(cube, c[0]), add(add(c[3], mul(c[2], N)), mul(c[1], NN)),
                   add(six_A, mul(from_int(2), mul(c[2], N))), six_A};
    for (int k = 0; k < 4; k++)
        same(T, mul(cube, d[k]), rows[k]);
}

/*
:::{claim} stepping_reaches_the_other_end
:title: After as many steps as there are pieces the table is at the other end
:zh: 差分法到达终点
:given: any coefficients of degree 3, $\delta=2^{-m}$, $2^m$ steps; $m$ is the degree
:then: the first row is $P(1)=A+B+C+D$
:method: The table and its steps; in binary64 within the running error bound.
:degrees: m = 1..6 sampled 8
:over: x#: coefficients
:control: one step less
:::
*/
CLAIM(stepping_reaches_the_other_end)
{
    int pieces = 1 << T->degree;
    num c[4], d[4], end = from_int(0);
    G(free_points)(T, 3, 1, c);
    for (int k = 0; k < 4; k++)
        end = add(end, c[k]);
    G(power_differences)(3, 1, c, from_ratio(1, pieces), d);
    for (int k = 0; k < fault(T, pieces, pieces - 1); k++)
        G(power_difference_step)(3, 1, d);
    same(T, d[0], end);
}

#if RATIONAL
/*
:::{claim} stepping_is_exact_for_short_coefficients
:title: For short coefficients and a power of two of steps binary64 steps without any error
:zh: 短系数时双精度差分无误差
:types: rational
:given: $N$ random cubics with coefficients of $b$ binary places in $[-1,1]$, $\delta=\frac1n$, $n$ steps
:data: N = 3; b = 20; n = 256
:instead: n = 255
:then: every one of the $n+1$ points of each by `power_difference_step` in binary64 is the exact value
:method: The kernel in binary64 and in rationals; the values are compared as rationals.
:control: a number of steps that is no power of two
:::
*/
CLAIM(stepping_is_exact_for_short_coefficients)
{
    int cubics = given_whole(T, "N"), bits = given_whole(T, "b"), pieces = given_whole(T, "n");
    num scale = G(power)(from_int(2), bits);
    for (int cubic = 0; cubic < cubics; cubic++) {
        num c[4], d[4];
        double rounded[4], steps[4];
        int short_ones = 1;
        for (int k = 0; k < 4; k++) {
            c[k] = unknown(T, "c", k);
            short_ones = short_ones && is_whole_q(mul(scale, c[k]));
            rounded[k] = to_double_q(c[k]);
        }
        agree(T, short_ones);
        G(power_differences)(3, 1, c, from_ratio(1, pieces), d);
        power_differences_d(3, 1, rounded, 1.0 / pieces, steps);
        for (int i = 0; i <= pieces; i++) {
            agree(T, equal_q(from_double_q(steps[0]), d[0]));
            G(power_difference_step)(3, 1, d);
            power_difference_step_d(3, 1, steps);
        }
    }
}
#endif

/*
:::{claim} errors_of_the_table_grow_with_the_cube
:title: An error of the third difference grows with the cube of the number of steps
:zh: 三阶差分的误差按三次增长
:given: errors $e_0,e_1,e_2,e_3$ in the four rows, $n$ steps
:then: the error of the point is $e_0+ne_1+\binom n2e_2+\binom n3e_3$
:method: The table is linear: the kernel on the errors alone, $n$ steps, against the sum.
:degrees: 1..24
:over: e#: errors
:control: $\binom n3$ left out
:::
*/
CLAIM(errors_of_the_table_grow_with_the_cube)
{
    int n = T->degree;
    num e[4], sum = from_int(0);
    for (int k = 0; k < 4; k++) {
        e[k] = unknown(T, "e", k);
        int counted_in = fault(T, k <= n, k <= n && k != 3);
        sum = add(sum, mul(from_int(counted_in ? binomial(n, k) : 0), e[k]));
    }
    for (int k = 0; k < n; k++)
        G(power_difference_step)(3, 1, e);
    same(T, e[0], sum);
}

#if RATIONAL
/*
:::{claim} stepping_loses_what_horner_keeps
:title: A table begun with rounded points loses many digits that one begun with the coefficients keeps
:zh: 差分表的舍入误差取决于起始方式
:kind: decision
:given: the cubic with the coefficients $c$, from $D$ to $A$; $\delta=\frac1n$, $n$ steps in binary64; the table begun with the
  differences of the first four points, and with (1-4-5); two bounds
:data: c = 1 0 0 1; n = 1000; many = 10000000; few = 1000
:instead: n = 1024
:then: in units of the roundoff $2^{-53}$ the last point has an error of more than many the first way, of less than few the second way, and
  none by Horner's rule
:result: error by points = 409928008; error by coefficients = 36; error by Horner's rule = 0
:method: The kernels in binary64, compared exactly as rationals with $P(1)$.
:control: a power of two, where all are exact
:::
*/
/* |value - exact| in units of 2^-53 */
static num units_of_error(double value, num exact)
{
    num gap = sub(from_double_q(value), exact);
    return mul(sign_q(gap) < 0 ? neg(gap) : gap, from_double_q(0x1p53));
}

CLAIM(stepping_loses_what_horner_keeps)
{
    num coefficient[4];
    given_points(T, "c", 4, 1, coefficient);
    int pieces = given_whole(T, "n");
    num many = given(T, "many"), few = given(T, "few"), exact = G(power_sum)(3, 1, coefficient, 0, from_int(1));
    double c[4], delta = 1.0 / pieces, points[4], end, scale = 1;
    for (int k = 0; k < 4; k++)
        c[k] = to_double_q(coefficient[k]);
    double table[4] = {c[0], c[1] + (c[2] + c[3] * delta) * delta, 6 * c[3] * delta + 2 * c[2], 6 * c[3]};
    power_differences_d(3, 1, c, delta, points);
    for (int k = 0; k <= 3; k++, scale *= delta)
        table[k] *= scale;
    for (int k = 0; k < pieces; k++) {
        power_difference_step_d(3, 1, points);
        power_difference_step_d(3, 1, table);
    }
    power_point_d(3, 1, c, 1, &end);
    num by_points = units_of_error(points[0], exact), by_table = units_of_error(table[0], exact);
    num by_horner = units_of_error(end, exact);
    found(T, "error by points", by_points);
    found(T, "error by coefficients", by_table);
    found(T, "error by Horner's rule", by_horner);
    agree(T, compare_q(by_points, many) > 0);
    agree(T, compare_q(by_table, few) < 0);
    agree(T, is_zero_q(by_horner));
}

/*
:::{claim} short_words_lose_the_end
:title: Words of 8 binary places never leave the first point
:zh: 字长不足时停在起点
:kind: counterexample
:given: the cubic $P(t)=\sum_kc_kt^k$, that is with the coefficients $c$ from $D$ to $A$; the table (1-4-5), and $n$ steps (1-4-4) with $\delta=\frac1n$; of every
  row, and of every product with $\delta$, so many binary places are kept as `places` says, and the rest is cut off
:data: c = 0 0 0 1/8; δ = 1/256; places = 8; n = 256
:instead: places = 27
:then: the rows $\frac1\delta\cdot\Delta P_0$ and $\frac1{\delta^2}\cdot\Delta^2P_0$ are cut to 0, and so is every product with $\delta$: the last point is $P(0)$ in the place of $P(1)$
:result: table, cut = 0 0 0 3/4; last point = 0; P(1) = 1/8
:method: The table by the kernel, divided by the powers of $\delta$ and cut; then the four lines of (1-4-4), with each product cut.
:control: places enough to hold every row
:::
*/
/* a >= 0 with all binary places after the first `places` cut off */
static num cut(num a, int places)
{
    mpz_t whole_part;
    mpz_init(whole_part);
    num unit = from_ratio(1, 1L << places), scaled = div(a, unit);
    mpz_fdiv_q(whole_part, mpq_numref(scaled.at), mpq_denref(scaled.at));
    num kept = mul(from_int(mpz_get_si(whole_part)), unit);
    mpz_clear(whole_part);
    return kept;
}

CLAIM(short_words_lose_the_end)
{
    num c[4], d[4];
    given_points(T, "c", 4, 1, c);
    num delta = given(T, "δ"), end = G(power_sum)(3, 1, c, 0, from_int(1));
    int places = given_whole(T, "places"), steps = given_whole(T, "n");
    num power = from_int(1);
    G(power_differences)(3, 1, c, delta, d);
    for (int k = 0; k < 4; k++, power = mul(power, delta))
        d[k] = cut(div(d[k], power), places);
    found_points(T, "table, cut", 4, 1, d);
    for (int i = 0; i < steps; i++)
        for (int k = 0; k < 3; k++) /* Δ^k P_1/δ^k = Δ^k P_0/δ^k + δ (Δ^{k+1} P_0/δ^{k+1}) */
            d[k] = add(d[k], cut(mul(delta, d[k + 1]), places));
    found(T, "last point", d[0]);
    found(T, "P(1)", end);
    about(T, "the last point, and P(1)");
    same(T, d[0], end);
}
#endif

#include "chapters/judge/claims_off.h"
