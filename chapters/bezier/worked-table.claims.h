/*
# A worked table (Bézier 曲线算例的数表)

The slides compute seven points of the cubic with $P_0=(1,1)$, $P_1=(2,3)$, $P_2=(4,3)$, $P_3=(3,1)$, and print in a table the
parameter, the four functions $(1-t)^3$, $3t(1-t)^2$, $3t^2(1-t)$, $t^3$, and the point.  The functions are printed with three
digits, or with two that count, the points with up to four digits after the point.  A number is right here when the exact
value, rounded to as many digits as are printed, is that number: when the two are at most half a unit of the last printed
digit apart.  In the first row, the middle one and the last nothing has to be rounded, and a number is right when it is the exact value.
The slides name no rule; where it matters whether a five is rounded up we say so.

All twenty-eight values of the functions are right.  Of the fourteen coordinates six are wrong, and one, $y(0.65)$, is right unless
fives are rounded up.  Two of the six are what the rounded functions give, whose sum is not 1; the other four are neither that nor
the exact value.  The points have the heights 1, 3, 3, 1, so the curve has $y(t)=y(1-t)$: the column of $y$ contradicts itself
twice.
*/
#include "chapters/bezier/definition.h"

#include "chapters/judge/claims_on.h"

enum { dim = 2, ROWS = 7 };

/*
## The numbers, row by row

The table is read row by row.  In each row the four functions come first, then the point; a claim takes all numbers of a row that are
right, and every number that is wrong has a claim of its own.  At the ends there is nothing to round.

:::{statement} slides-ch4:table-bezier-row-0-basis
:title: The four functions at t = 0
:zh: t=0 处的四个基函数值
:printed: $t=0$: $(1-t)^3=1$, $3t(1-t)^2=0$, $3t^2(1-t)=0$, $t^3=0$
:holds-by: table_row_of_start
:figure: worked_table
:::

:::{statement} slides-ch4:table-bezier-row-0-x
:title: The first coordinate at t = 0
:zh: t=0 处的横坐标
:printed: x(0)=1
:holds-by: table_row_of_start
:figure: worked_table
:::

:::{statement} slides-ch4:table-bezier-row-0-y
:title: The second coordinate at t = 0
:zh: t=0 处的纵坐标
:printed: y(0)=1
:holds-by: table_row_of_start
:figure: worked_table
:::
*/

#if RATIONAL
/* One unit of the last digit of a decimal that does not end in 0: of 1, 1/10, 1/100, ... the first of which it is a multiple. */
static num last_unit(num decimal)
{
    num unit = from_int(1);
    while (!is_whole_q(div(decimal, unit)))
        unit = div(unit, from_int(10));
    return unit;
}

/* Compare: the printed number is the exact value, rounded; with `more` units added to its last digit. */
static void is_rounded(trial *T, num printed, int more, num exact)
{
    num unit = last_unit(printed), half = div(unit, from_int(2));
    num gap = sub(add(printed, mul(from_int(more), unit)), exact);
    nonnegative(T, sub(half, gap));
    nonnegative(T, add(half, gap));
}

/* Compare the functions B that are printed in the row of t, and y if it is asked for: rounded. */
static void right_numbers(trial *T, int y)
{
    num P[4 * dim], B[4];
    given_points(T, "P", 4, dim, P);
    num t = given(T, "t");
    given_points(T, "B", 4, 1, B);
    for (int i = 0; i <= 3; i++) {
        about(T, "a function");
        is_rounded(T, B[i], fault(T, 0, i == 0), G(basis)(3, i, t));
    }
    if (y) {
        about(T, "a coordinate");
        is_rounded(T, given(T, "y"), 0, G(curve)(3, dim, P, 1, t));
    }
}

/* Compare all that is printed in the row of t, where nothing is rounded. */
static void exact_numbers(trial *T)
{
    num P[4 * dim], B[4], t = given(T, "t");
    given_points(T, "P", 4, dim, P);
    given_points(T, "B", 4, 1, B);
    for (int i = 0; i <= 3; i++) {
        about(T, "a function");
        same(T, fault(T, B[i], i == 0 ? add(B[i], last_unit(B[i])) : B[i]), G(basis)(3, i, t));
    }
    for (int c = 0; c < dim; c++) {
        about(T, "a coordinate");
        same(T, given(T, c == 0 ? "x" : "y"), G(curve)(3, dim, P, c, t));
    }
}

/*
:::{claim} table_row_of_start
:title: The row of t = 0, its right numbers
:zh: 表中 t=0 行的正确数字
:kind: decision
:data: P = (1,1) (2,3) (4,3) (3,1); t = 0; B = 1 0 0 0; x = 1; y = 1
:given: the cubic with the points $P$, a parameter $t$, and what is printed in its row: the values $B$ of the four functions and $x$ and $y$
:then: each is the exact value
:method: The exact value, and the printed one as the decimal it is; they are equal.
:control: one unit more in the last digit of the first function
:::
*/
CLAIM(table_row_of_start) { exact_numbers(T); }

/*
:::{statement} slides-ch4:table-bezier-row-0.15-basis
:title: The four functions at t = 0.15
:zh: t=0.15 处的四个基函数值
:printed: $t=0.15$: $(1-t)^3=0.614$, $3t(1-t)^2=0.325$, $3t^2(1-t)=0.0574$, $t^3=0.0034$
:holds-by: table_row_of_fifteen_hundredths
:meant: the digits of these numbers, three or two significant ones | Each number is the value of the function, rounded to the digits that are printed.
:figure: worked_table
:::

:::{claim} table_row_of_fifteen_hundredths
:title: The row of t = 0.15, its right numbers
:zh: 表中 t=0.15 行的正确数字
:kind: decision
:data: P = (1,1) (2,3) (4,3) (3,1); t = 0.15; B = 0.614 0.325 0.0574 0.0034; y = 1.765
:given: the cubic with the points $P$, a parameter $t$, and what is printed in its row: the values $B$ of the four functions and $y$
:then: each is the exact value, rounded to the digits that are printed
:method: The exact value, and the printed one as the decimal it is; their distance is at most half a unit of the last printed digit.
:control: one unit more in the last digit of the first function
:::
*/
CLAIM(table_row_of_fifteen_hundredths) { right_numbers(T, 1); }

/*
:::{statement} slides-ch4:table-bezier-row-0.15-x
:title: The first coordinate at t = 0.15
:zh: t=0.15 处的横坐标
:printed: x(0.15)=1.5058
:refuted-by: table_misses_the_first_x
:class: misprint
:corrected: x(0.15)=1.504
:corrected-by: exact_values_of_the_table
:confirmed-by: rounded_factors_of_the_table
:figure: worked_table

The sum with the rounded factors of this row is 1.5038: the third digit after the point is wrong in either way to compute it.
:::
*/

/* Compare the coordinate that is printed in the row of t, "x" or "y", with the exact one. */
static void wrong_number(trial *T, const char *coordinate)
{
    num P[4 * dim];
    given_points(T, "P", 4, dim, P);
    num t = given(T, "t"), printed = given(T, coordinate), exact = G(curve)(3, dim, P, *coordinate == 'y', t);
    found(T, *coordinate == 'y' ? "y(t)" : "x(t)", exact);
    about(T, "half a unit of the last digit less the distance from the exact value");
    is_rounded(T, printed, 0, exact);
}

/*
:::{claim} table_misses_the_first_x
:title: The first coordinate at t = 0.15 is printed wrong
:zh: t=0.15 处横坐标有误
:kind: counterexample
:data: P = (1,1) (2,3) (4,3) (3,1); t = 0.15; x = 1.5058
:instead: x = 1.504
:result: x(t) = 1.504
:given: the cubic with the points $P$, a parameter $t$, and the $x$ that is printed in the row of $t$
:then: the exact $x(t)$ is another number, and $x$ is not what it is rounded to
:method: The exact value, and the printed one as the decimal it is; that their distance is at most half a unit of the last printed digit is
  refuted.
:control: the exact value in the place of the printed one
:::
*/
CLAIM(table_misses_the_first_x) { wrong_number(T, "x"); }

/*
Are the exact values themselves decimals?  The parameters are twentieths, and the points integers: so the values are finite decimals, and no
question of rounding arises for them.

:::{claim} exact_values_of_the_table
:title: The seven points, exactly
:zh: 数表各点的精确值
:kind: decision
:data: P = (1,1) (2,3) (4,3) (3,1); t = 0 0.15 0.35 0.5 0.65 0.85 1; C = (1,1) (1.504,1.765) (2.246,2.365) (2.75,2.5) (3.119,2.365) (3.261,1.765) (3,1)
:instead: C = (1,1) (1.504,1.765) (2.246,2.365) (2.75,2.5) (3.119,2.365) (3.261,1.75) (3,1)
:given: the cubic with the points $P$, and the seven parameters $t$ of the table
:then: its points at these parameters are the finite decimals $C$
:method: By the kernel, and by the sum from the definition.
:control: the last $y$ but one is the printed one
:::
*/
CLAIM(exact_values_of_the_table)
{
    num P[4 * dim], t[ROWS], C[ROWS * dim], at[dim];
    given_points(T, "P", 4, dim, P);
    given_points(T, "t", ROWS, 1, t);
    given_points(T, "C", ROWS, dim, C);
    for (int row = 0; row < ROWS; row++) {
        G(bezier_casteljau)(3, dim, P, t[row], at);
        for (int c = 0; c < dim; c++) {
            same(T, at[c], C[row * dim + c]);
            same(T, at[c], G(curve)(3, dim, P, c, t[row]));
        }
    }
}

/*
:::{statement} slides-ch4:table-bezier-row-0.15-y
:title: The second coordinate at t = 0.15
:zh: t=0.15 处的纵坐标
:printed: y(0.15)=1.765
:holds-by: table_row_of_fifteen_hundredths
:meant: the head of the column, $P(t)$ | The number is the value of the curve, rounded to the digits that are printed.
:figure: worked_table
:::

:::{statement} slides-ch4:table-bezier-row-0.35-basis
:title: The four functions at t = 0.35
:zh: t=0.35 处的四个基函数值
:printed: $t=0.35$: $(1-t)^3=0.275$, $3t(1-t)^2=0.444$, $3t^2(1-t)=0.239$, $t^3=0.043$
:holds-by: table_row_of_thirty_five_hundredths
:meant: the digits of these numbers, three or two significant ones | Each number is the value of the function, rounded to the digits that are printed.
:figure: worked_table
:::

:::{claim} table_row_of_thirty_five_hundredths
:title: The row of t = 0.35, its right numbers
:zh: 表中 t=0.35 行的正确数字
:kind: decision
:data: P = (1,1) (2,3) (4,3) (3,1); t = 0.35; B = 0.275 0.444 0.239 0.043
:given: the cubic with the points $P$, a parameter $t$, and what is printed in its row: the values $B$ of the four functions
:then: each is the exact value, rounded to the digits that are printed
:method: The exact value, and the printed one as the decimal it is; their distance is at most half a unit of the last printed digit.
:control: one unit more in the last digit of the first function
:::
*/
CLAIM(table_row_of_thirty_five_hundredths) { right_numbers(T, 0); }

/*
:::{statement} slides-ch4:table-bezier-row-0.35-x
:title: The first coordinate at t = 0.35
:zh: t=0.35 处的横坐标
:printed: x(0.35)=2.248
:refuted-by: table_misses_the_second_x
:class: false
:corrected: x(0.35)=2.246
:corrected-by: exact_values_of_the_table
:meant: the head of the column, $P(t)$ | The number is the value of the curve, rounded to the digits that are printed.
:reading: table_misses_the_second_x | the number is the value of the curve, rounded to its digits
:reading: rounded_factors_of_the_table | the number is the sum of the points with the rounded functions of the same row as factors
:figure: worked_table

It is what the rounded functions of the row give as factors, whose sum is 1.001.
:::

:::{claim} table_misses_the_second_x
:title: The first coordinate at t = 0.35 is printed wrong
:zh: t=0.35 处横坐标有误
:kind: counterexample
:data: P = (1,1) (2,3) (4,3) (3,1); t = 0.35; x = 2.248
:instead: x = 2.246
:result: x(t) = 2.246
:given: the cubic with the points $P$, a parameter $t$, and the $x$ that is printed in the row of $t$
:then: the exact $x(t)$ is another number, and $x$ is not what it is rounded to
:method: The exact value, and the printed one as the decimal it is; that their distance is at most half a unit of the last printed digit is
  refuted.
:control: the exact value in the place of the printed one
:::
*/
CLAIM(table_misses_the_second_x) { wrong_number(T, "x"); }

/*
Where does a wrong number come from?  One guess can be tested: that the points were computed from the rounded functions of the same row.
Their sum is not 1, so the point may move by more than a unit of its last digit.  It explains two of the six, and no more.

:::{claim} rounded_factors_of_the_table
:title: What the rounded functions of each row give
:zh: 用表中舍入后的基函数值所得的点
:kind: decision
:data: P = (1,1) (2,3) (4,3) (3,1); B(0) = 1 0 0 0; B(0.15) = 0.614 0.325 0.0574 0.0034; B(0.35) = 0.275 0.444 0.239 0.043; B(0.5) = 0.125 0.375 0.375 0.125
:data: sum = 1 0.9998 1.001 1; C = (1,1) (1.5038,1.7646) (2.248,2.367) (2.75,2.5) (3.122,2.367) (3.2602,1.7646) (3,1)
:instead: C = (1,1) (1.5038,1.7646) (2.248,2.376) (2.75,2.5) (3.122,2.367) (3.2602,1.7646) (3,1)
:given: the points $P$ and the printed values $B$ of the functions, as the decimals they are, in the first four rows of the table; the other
  three rows have those of the first three backwards
:then: their sum is 1 in the first row, the middle one and the last, and nowhere else; the seven points with these factors are $C$
:method: The sums, exactly.
:control: in the third point the two last digits have changed places, as printed
:::
*/
CLAIM(rounded_factors_of_the_table)
{
    static const char *const name[] = {"B(0)", "B(0.15)", "B(0.35)", "B(0.5)"};
    enum { half = ROWS / 2 };
    num P[4 * dim], B[half + 1][4], stated[half + 1], C[ROWS * dim];
    given_points(T, "P", 4, dim, P);
    for (int row = 0; row <= half; row++)
        given_points(T, name[row], 4, 1, B[row]);
    given_points(T, "sum", half + 1, 1, stated);
    given_points(T, "C", ROWS, dim, C);
    for (int row = 0; row < ROWS; row++) {
        int backwards = row > half, from = backwards ? ROWS - 1 - row : row;
        num sum = from_int(0), at[dim] = {from_int(0), from_int(0)};
        for (int i = 0; i <= 3; i++) {
            num factor = B[from][backwards ? 3 - i : i];
            sum = add(sum, factor);
            for (int c = 0; c < dim; c++)
                at[c] = add(at[c], mul(factor, P[i * dim + c]));
        }
        about(T, "the sum of the functions");
        same(T, sum, stated[from]);
        about(T, "the point");
        for (int c = 0; c < dim; c++)
            same(T, at[c], C[row * dim + c]);
    }
}

/*
:::{statement} slides-ch4:table-bezier-row-0.35-y
:title: The second coordinate at t = 0.35
:zh: t=0.35 处的纵坐标
:printed: y(0.35)=2.376
:refuted-by: table_misses_the_second_y
:class: misprint
:corrected: y(0.35)=2.365
:corrected-by: exact_values_of_the_table
:confirmed-by: rounded_factors_of_the_table heights_of_the_example_are_symmetric
:figure: worked_table

The sum with the rounded factors is 2.367, the printed number but for the order of its last two digits.  The points have the heights 1, 3, 3, 1, so
$y(0.35)=y(0.65)$; the table has 2.376 and 2.36.
:::

:::{claim} table_misses_the_second_y
:title: The second coordinate at t = 0.35 is printed wrong
:zh: t=0.35 处纵坐标有误
:kind: counterexample
:data: P = (1,1) (2,3) (4,3) (3,1); t = 0.35; y = 2.376
:instead: y = 2.365
:result: y(t) = 2.365
:given: the cubic with the points $P$, a parameter $t$, and the $y$ that is printed in the row of $t$
:then: the exact $y(t)$ is another number, and $y$ is not what it is rounded to
:method: The exact value, and the printed one as the decimal it is; that their distance is at most half a unit of the last printed digit is
  refuted.
:control: the exact value in the place of the printed one
:::
*/
CLAIM(table_misses_the_second_y) { wrong_number(T, "y"); }

/*
:::{statement} slides-ch4:table-bezier-row-0.5-basis
:title: The four functions at t = 0.5
:zh: t=0.5 处的四个基函数值
:printed: $t=0.5$: $(1-t)^3=0.125$, $3t(1-t)^2=0.375$, $3t^2(1-t)=0.375$, $t^3=0.125$
:holds-by: table_row_of_middle
:figure: worked_table
:::

:::{statement} slides-ch4:table-bezier-row-0.5-x
:title: The first coordinate at t = 0.5
:zh: t=0.5 处的横坐标
:printed: x(0.5)=2.75
:holds-by: table_row_of_middle
:figure: worked_table
:::

:::{statement} slides-ch4:table-bezier-row-0.5-y
:title: The second coordinate at t = 0.5
:zh: t=0.5 处的纵坐标
:printed: y(0.5)=2.5
:holds-by: table_row_of_middle
:figure: worked_table
:::

:::{claim} table_row_of_middle
:title: The row of t = 0.5, its right numbers
:zh: 表中 t=0.5 行的正确数字
:kind: decision
:data: P = (1,1) (2,3) (4,3) (3,1); t = 0.5; B = 0.125 0.375 0.375 0.125; x = 2.75; y = 2.5
:given: the cubic with the points $P$, a parameter $t$, and what is printed in its row: the values $B$ of the four functions and $x$ and $y$
:then: each is the exact value
:method: The exact value, and the printed one as the decimal it is; they are equal.
:control: one unit more in the last digit of the first function
:::
*/
CLAIM(table_row_of_middle) { exact_numbers(T); }

/*
:::{statement} slides-ch4:table-bezier-row-0.65-basis
:title: The four functions at t = 0.65
:zh: t=0.65 处的四个基函数值
:printed: $t=0.65$: $(1-t)^3=0.043$, $3t(1-t)^2=0.239$, $3t^2(1-t)=0.444$, $t^3=0.275$
:holds-by: table_row_of_sixty_five_hundredths
:meant: the digits of these numbers, three or two significant ones | Each number is the value of the function, rounded to the digits that are printed.
:figure: worked_table
:::

:::{claim} table_row_of_sixty_five_hundredths
:title: The row of t = 0.65, its right numbers
:zh: 表中 t=0.65 行的正确数字
:kind: decision
:data: P = (1,1) (2,3) (4,3) (3,1); t = 0.65; B = 0.043 0.239 0.444 0.275; y = 2.36
:given: the cubic with the points $P$, a parameter $t$, and what is printed in its row: the values $B$ of the four functions and $y$
:then: each is the exact value, rounded to the digits that are printed
:method: The exact value, and the printed one as the decimal it is; their distance is at most half a unit of the last printed digit.
:control: one unit more in the last digit of the first function
:::
*/
CLAIM(table_row_of_sixty_five_hundredths) { right_numbers(T, 1); }

/*
:::{statement} slides-ch4:table-bezier-row-0.65-x
:title: The first coordinate at t = 0.65
:zh: t=0.65 处的横坐标
:printed: x(0.65)=3.122
:refuted-by: table_misses_the_third_x
:class: false
:corrected: x(0.65)=3.119
:corrected-by: exact_values_of_the_table
:meant: the head of the column, $P(t)$ | The number is the value of the curve, rounded to the digits that are printed.
:reading: table_misses_the_third_x | the number is the value of the curve, rounded to its digits
:reading: rounded_factors_of_the_table | the number is the sum of the points with the rounded functions of the same row as factors
:figure: worked_table

It is what the rounded functions of the row give as factors.
:::

:::{claim} table_misses_the_third_x
:title: The first coordinate at t = 0.65 is printed wrong
:zh: t=0.65 处横坐标有误
:kind: counterexample
:data: P = (1,1) (2,3) (4,3) (3,1); t = 0.65; x = 3.122
:instead: x = 3.119
:result: x(t) = 3.119
:given: the cubic with the points $P$, a parameter $t$, and the $x$ that is printed in the row of $t$
:then: the exact $x(t)$ is another number, and $x$ is not what it is rounded to
:method: The exact value, and the printed one as the decimal it is; that their distance is at most half a unit of the last printed digit is
  refuted.
:control: the exact value in the place of the printed one
:::
*/
CLAIM(table_misses_the_third_x) { wrong_number(T, "x"); }

/*
:::{statement} slides-ch4:table-bezier-row-0.65-y
:title: The second coordinate at t = 0.65
:zh: t=0.65 处的纵坐标
:printed: y(0.65)=2.36
:holds-by: table_row_of_sixty_five_hundredths
:meant: the head of the column, $P(t)$ | The number is the value of the curve, rounded to the digits that are printed.
:confirmed-by: exact_values_of_the_table rounded_factors_of_the_table
:hypothesis: five_rounded_up_gives_another_digit | a five is not rounded up: 四舍五入 gives 2.37
:figure: worked_table

The value is 2.365, exactly between 2.36 and 2.37.  It becomes 2.36 when it is rounded to the even digit; cut off it becomes 2.36, too, but the functions of the table are
rounded and not cut off.  The sum with the rounded factors, which for $x(0.65)$ is the printed number, is 2.367 here: it becomes 2.36 only when it is cut off.
:::

One number is right or not by the rule of rounding that is taken, because the exact value lies exactly between two candidates.

:::{claim} five_rounded_up_gives_another_digit
:title: With fives rounded up 2.365 is not 2.36
:zh: 四舍五入时 2.365 不为 2.36
:kind: counterexample
:data: P = (1,1) (2,3) (4,3) (3,1); t = 0.65; y = 2.36
:instead: y = 2.37
:result: y(t) = 2.365; left above = 0; left below = 0.01
:given: the cubic with the points $P$, a parameter $t$, and the $y$ that is printed in the row of $t$
:let: $e$ is one unit of the last digit of $y$, and a number is rounded to $y$, fives up, when it is at least $y-\frac e2$ and less than $y+\frac e2$
:then: the exact $y(t)$ is $y+\frac e2$: nothing is left above it, where something has to be
:method: What is left above the exact value is $y+\frac e2-y(t)$, and below it $y(t)-(y-\frac e2)$; both signs, exactly.
:control: the next number of as many digits
:::
*/
CLAIM(five_rounded_up_gives_another_digit)
{
    num P[4 * dim];
    given_points(T, "P", 4, dim, P);
    num t = given(T, "t"), y = given(T, "y"), half = div(last_unit(y), from_int(2));
    num exact = G(curve)(3, dim, P, 1, t), above = sub(add(y, half), exact), below = sub(exact, sub(y, half));
    found(T, "y(t)", exact);
    found(T, "left above", above);
    found(T, "left below", below);
    about(T, "whether y is the exact value, rounded with fives up");
    agree(T, sign_q(above) > 0 && sign_q(below) >= 0);
}
#endif

/*
The heights of the points are the same from both ends, and this is a check that a reader can do in the head: the second half of the column
of $y$ must be the first half backwards.  It fails in two rows of the table.

:::{claim} heights_of_the_example_are_symmetric
:title: The heights of the example are the same at t and at 1 - t
:zh: 算例中纵坐标关于 t=1/2 对称
:data: y = 1 3 3 1
:instead: y = 1 3 3 2
:given: the second coordinates $y$ of the points of the table, any $t$
:then: $y(t)=y(1-t)=y_0+3(y_1-y_0)\,t(1-t)$
:method: By the kernel at a variable $t$.
:control: the last of them is another
:::
*/
CLAIM(heights_of_the_example_are_symmetric)
{
    num t = parameter(T, "t"), s = sub(from_int(1), t), y[4], here, there;
    given_points(T, "y", 4, 1, y);
    G(bezier_casteljau)(3, 1, y, t, &here);
    G(bezier_casteljau)(3, 1, y, s, &there);
    same(T, here, there);
    same(T, here, add(y[0], mul(mul(from_int(3), sub(y[1], y[0])), mul(t, s))));
}

/*
:::{statement} slides-ch4:table-bezier-row-0.85-basis
:title: The four functions at t = 0.85
:zh: t=0.85 处的四个基函数值
:printed: $t=0.85$: $(1-t)^3=0.0034$, $3t(1-t)^2=0.0574$, $3t^2(1-t)=0.325$, $t^3=0.614$
:holds-by: table_row_of_eighty_five_hundredths
:meant: the digits of these numbers, three or two significant ones | Each number is the value of the function, rounded to the digits that are printed.
:figure: worked_table
:::
*/

#if RATIONAL
/*
:::{claim} table_row_of_eighty_five_hundredths
:title: The row of t = 0.85, its right numbers
:zh: 表中 t=0.85 行的正确数字
:kind: decision
:data: P = (1,1) (2,3) (4,3) (3,1); t = 0.85; B = 0.0034 0.0574 0.325 0.614
:given: the cubic with the points $P$, a parameter $t$, and what is printed in its row: the values $B$ of the four functions
:then: each is the exact value, rounded to the digits that are printed
:method: The exact value, and the printed one as the decimal it is; their distance is at most half a unit of the last printed digit.
:control: one unit more in the last digit of the first function
:::
*/
CLAIM(table_row_of_eighty_five_hundredths) { right_numbers(T, 0); }

/*
:::{statement} slides-ch4:table-bezier-row-0.85-x
:title: The first coordinate at t = 0.85
:zh: t=0.85 处的横坐标
:printed: x(0.85)=3.248
:refuted-by: table_misses_the_fourth_x
:class: misprint
:corrected: x(0.85)=3.261
:corrected-by: exact_values_of_the_table
:confirmed-by: rounded_factors_of_the_table
:figure: worked_table

The sum with the rounded factors is 3.2602.  The digits after the point are those that are printed for $x(0.35)$.
:::

:::{claim} table_misses_the_fourth_x
:title: The first coordinate at t = 0.85 is printed wrong
:zh: t=0.85 处横坐标有误
:kind: counterexample
:data: P = (1,1) (2,3) (4,3) (3,1); t = 0.85; x = 3.248
:instead: x = 3.261
:result: x(t) = 3.261
:given: the cubic with the points $P$, a parameter $t$, and the $x$ that is printed in the row of $t$
:then: the exact $x(t)$ is another number, and $x$ is not what it is rounded to
:method: The exact value, and the printed one as the decimal it is; that their distance is at most half a unit of the last printed digit is
  refuted.
:control: the exact value in the place of the printed one
:::
*/
CLAIM(table_misses_the_fourth_x) { wrong_number(T, "x"); }

/*
:::{statement} slides-ch4:table-bezier-row-0.85-y
:title: The second coordinate at t = 0.85
:zh: t=0.85 处的纵坐标
:printed: y(0.85)=1.75
:refuted-by: table_misses_the_fourth_y
:class: misprint
:corrected: y(0.85)=1.765
:corrected-by: exact_values_of_the_table
:confirmed-by: rounded_factors_of_the_table heights_of_the_example_are_symmetric
:figure: worked_table

The sum with the rounded factors is 1.7646.  The table has the right value, 1.765, in the row of $t=0.15$, and $y(0.85)=y(0.15)$.
:::

:::{claim} table_misses_the_fourth_y
:title: The second coordinate at t = 0.85 is printed wrong
:zh: t=0.85 处纵坐标有误
:kind: counterexample
:data: P = (1,1) (2,3) (4,3) (3,1); t = 0.85; y = 1.75
:instead: y = 1.765
:result: y(t) = 1.765
:given: the cubic with the points $P$, a parameter $t$, and the $y$ that is printed in the row of $t$
:then: the exact $y(t)$ is another number, and $y$ is not what it is rounded to
:method: The exact value, and the printed one as the decimal it is; that their distance is at most half a unit of the last printed digit is
  refuted.
:control: the exact value in the place of the printed one
:::
*/
CLAIM(table_misses_the_fourth_y) { wrong_number(T, "y"); }

/*
:::{statement} slides-ch4:table-bezier-row-1-basis
:title: The four functions at t = 1
:zh: t=1 处的四个基函数值
:printed: $t=1$: $(1-t)^3=0$, $3t(1-t)^2=0$, $3t^2(1-t)=0$, $t^3=1$
:holds-by: table_row_of_end
:figure: worked_table
:::

:::{statement} slides-ch4:table-bezier-row-1-x
:title: The first coordinate at t = 1
:zh: t=1 处的横坐标
:printed: x(1)=3
:holds-by: table_row_of_end
:figure: worked_table
:::

:::{statement} slides-ch4:table-bezier-row-1-y
:title: The second coordinate at t = 1
:zh: t=1 处的纵坐标
:printed: y(1)=1
:holds-by: table_row_of_end
:figure: worked_table
:::

:::{claim} table_row_of_end
:title: The row of t = 1, its right numbers
:zh: 表中 t=1 行的正确数字
:kind: decision
:data: P = (1,1) (2,3) (4,3) (3,1); t = 1; B = 0 0 0 1; x = 3; y = 1
:given: the cubic with the points $P$, a parameter $t$, and what is printed in its row: the values $B$ of the four functions and $x$ and $y$
:then: each is the exact value
:method: The exact value, and the printed one as the decimal it is; they are equal.
:control: one unit more in the last digit of the first function
:::
*/
CLAIM(table_row_of_end) { exact_numbers(T); }
#endif

#include "chapters/judge/claims_off.h"
