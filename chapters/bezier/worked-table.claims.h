/*
# A worked table (Bézier 曲线算例的数表)

The slides compute seven points of the cubic with $P_0=(1,1)$, $P_1=(2,3)$, $P_2=(4,3)$, $P_3=(3,1)$, and print in a table the
parameter, the four functions $(1-t)^3$, $3t(1-t)^2$, $3t^2(1-t)$, $t^3$, and the point.  The functions are printed with three
digits, or with two that count, the points with up to four digits after the point.  A number is right here when the exact
value, rounded to as many digits as are printed, is that number: when the two are at most half a unit of the last printed
digit apart.  The slides name no rule; where it matters whether a five is rounded up we say so.

All twenty-eight values of the functions are right.  Of the fourteen coordinates six are wrong, and one, $y(0.65)$, is right unless
fives are rounded up.  Two of the six are what the rounded functions give, whose sum is not 1; the other four are neither that nor
the exact value.  The points have the
heights 1, 3, 3, 1, so the curve has $y(t)=y(1-t)$: the column of $y$ contradicts itself twice.
*/
#include "chapters/bezier/definition.h"
#include "chapters/bezier/printed-table.h"

#include <string.h>

#include "chapters/judge/claims_on.h"

enum { dim = 2 };

/*
## The numbers, row by row

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
/* Coordinate c of the point, as the sum of the definition. */
static num exact_coordinate(int row, int c)
{
    num sum = from_int(0), t = from_string_q(printed_table[row].t);
    for (int i = 0; i <= 3; i++)
        sum = add(sum, mul(from_int(printed_points[i * dim + c]), G(basis)(3, i, t)));
    return sum;
}

/* One unit of the last printed digit. */
static num last_unit(const char *printed)
{
    num unit = from_int(1);
    const char *point = strchr(printed, '.');
    for (const char *digit = point == NULL ? "" : point + 1; *digit != '\0'; digit++)
        unit = div(unit, from_int(10));
    return unit;
}

/* Compare: the printed number, and `more` units of its last digit, is the exact value, rounded. */
static void is_rounded(trial *T, const char *printed, int more, num exact)
{
    num unit = last_unit(printed), half = div(unit, from_int(2));
    num gap = sub(add(from_string_q(printed), mul(from_int(more), unit)), exact);
    nonnegative(T, sub(half, gap));
    nonnegative(T, add(half, gap));
}

static void right_numbers(trial *T, int row, int x, int y)
{
    const int asked[2] = {x, y};
    for (int i = 0; i <= 3; i++) {
        about(T, "a function");
        is_rounded(T, printed_table[row].basis[i], fault(T, 0, i == 0),
                   G(basis)(3, i, from_string_q(printed_table[row].t)));
    }
    for (int c = 0; c < dim; c++)
        if (asked[c]) {
            about(T, "a coordinate");
            is_rounded(T, printed_table[row].point[c], 0, exact_coordinate(row, c));
        }
}

/*
:::{claim} table_row_of_start
:title: The row of t = 0, its right numbers
:zh: 表中 t=0 行的正确数字
:kind: decision
:given: the points of the table, $t=0$; the printed values of the four functions and $x$ and $y$
:then: each is the exact value, rounded to the digits that are printed
:method: The exact value, and the printed one as the decimal it is; their distance is at most half a unit of the last printed digit.
:control: one unit more in the last digit of the first function
:::
*/
CLAIM(table_row_of_start) { right_numbers(T, 0, 1, 1); }

/*
:::{statement} slides-ch4:table-bezier-row-0.15-basis
:title: The four functions at t = 0.15
:zh: t=0.15 处的四个基函数值
:printed: $t=0.15$: $(1-t)^3=0.614$, $3t(1-t)^2=0.325$, $3t^2(1-t)=0.0574$, $t^3=0.0034$
:holds-by: table_row_of_fifteen_hundredths
:figure: worked_table
:::

:::{claim} table_row_of_fifteen_hundredths
:title: The row of t = 0.15, its right numbers
:zh: 表中 t=0.15 行的正确数字
:kind: decision
:given: the points of the table, $t=0.15$; the printed values of the four functions and $y$
:then: each is the exact value, rounded to the digits that are printed
:method: The exact value, and the printed one as the decimal it is; their distance is at most half a unit of the last printed digit.
:control: one unit more in the last digit of the first function
:::
*/
CLAIM(table_row_of_fifteen_hundredths) { right_numbers(T, 1, 0, 1); }

/*
:::{statement} slides-ch4:table-bezier-row-0.15-x
:title: The first coordinate at t = 0.15
:zh: t=0.15 处的横坐标
:printed: x(0.15)=1.5058
:refuted-by: table_misses_the_first_x
:class: misprint
:corrected: x(0.15)=1.504
:corrected-by: exact_values_of_the_table
:figure: worked_table

The sum with the rounded factors of this row is 1.5038: the third digit after the point is wrong in either way to compute it.
:::
*/

static void wrong_number(trial *T, int row, int c, const char *right)
{
    num exact = exact_coordinate(row, c);
    show_text(T, "t", "%s", printed_table[row].t);
    show_text(T, "printed", "%s", printed_table[row].point[c]);
    show_text(T, "exact", "%s", right);
    show(T, "exact, as a fraction", exact);
    about(T, "the distance from the exact value, and half a unit of the last digit");
    is_rounded(T, fault(T, right, printed_table[row].point[c]), 0, exact);
}

/*
:::{claim} table_misses_the_first_x
:title: The first coordinate at t = 0.15 is printed wrong
:zh: t=0.15 处横坐标有误
:kind: counterexample
:given: the points of the table, $t=0.15$; the printed $x=1.5058$
:then: the exact value is $1.504$
:method: The exact value, and the printed one as the decimal it is; their distance is at most half a unit of the last printed digit.
:control: $1.504$
:::
*/
CLAIM(table_misses_the_first_x) { wrong_number(T, 1, 0, "1.504"); }

/*
:::{claim} exact_values_of_the_table
:title: The seven points, exactly
:zh: 数表各点的精确值
:kind: decision
:given: the points of the table and its seven parameters
:then: the points are $(1,1)$, $(1.504,1.765)$, $(2.246,2.365)$, $(2.75,2.5)$, $(3.119,2.365)$, $(3.261,1.765)$, $(3,1)$, as finite decimals
:method: By the kernel, and by the sum from the definition.
:control: $y(0.85)=1.75$, as printed
:::
*/
CLAIM(exact_values_of_the_table)
{
    static const char *const exact[7][2] = {{"1", "1"},         {"1.504", "1.765"}, {"2.246", "2.365"}, {"2.75", "2.5"},
                                            {"3.119", "2.365"}, {"3.261", "1.765"}, {"3", "1"}};
    num b[8], P[dim];
    for (int m = 0; m < 8; m++)
        b[m] = from_int(printed_points[m]);
    for (int row = 0; row < 7; row++) {
        G(decasteljau)(3, dim, b, from_string_q(printed_table[row].t), P);
        for (int c = 0; c < dim; c++) {
            const char *value =
                fault(T, exact[row][c], row == 5 && c == 1 ? printed_table[row].point[c] : exact[row][c]);
            same(T, P[c], from_string_q(value));
            same(T, P[c], exact_coordinate(row, c));
        }
    }
}

/*
:::{statement} slides-ch4:table-bezier-row-0.15-y
:title: The second coordinate at t = 0.15
:zh: t=0.15 处的纵坐标
:printed: y(0.15)=1.765
:holds-by: table_row_of_fifteen_hundredths
:figure: worked_table
:::

:::{statement} slides-ch4:table-bezier-row-0.35-basis
:title: The four functions at t = 0.35
:zh: t=0.35 处的四个基函数值
:printed: $t=0.35$: $(1-t)^3=0.275$, $3t(1-t)^2=0.444$, $3t^2(1-t)=0.239$, $t^3=0.043$
:holds-by: table_row_of_thirty_five_hundredths
:figure: worked_table
:::

:::{claim} table_row_of_thirty_five_hundredths
:title: The row of t = 0.35, its right numbers
:zh: 表中 t=0.35 行的正确数字
:kind: decision
:given: the points of the table, $t=0.35$; the printed values of the four functions
:then: each is the exact value, rounded to the digits that are printed
:method: The exact value, and the printed one as the decimal it is; their distance is at most half a unit of the last printed digit.
:control: one unit more in the last digit of the first function
:::
*/
CLAIM(table_row_of_thirty_five_hundredths) { right_numbers(T, 2, 0, 0); }

/*
:::{statement} slides-ch4:table-bezier-row-0.35-x
:title: The first coordinate at t = 0.35
:zh: t=0.35 处的横坐标
:printed: x(0.35)=2.248
:refuted-by: table_misses_the_second_x
:class: false
:corrected: x(0.35)=2.246
:corrected-by: exact_values_of_the_table
:reading: rounded_factors_of_the_table | the sum with the rounded factors of the same row: true
:figure: worked_table

It is what the rounded factors of the row give, whose sum is 1.001; three digits after the point are more than they carry.
:::

:::{claim} table_misses_the_second_x
:title: The first coordinate at t = 0.35 is printed wrong
:zh: t=0.35 处横坐标有误
:kind: counterexample
:given: the points of the table, $t=0.35$; the printed $x=2.248$
:then: the exact value is $2.246$
:method: The exact value, and the printed one as the decimal it is; their distance is at most half a unit of the last printed digit.
:control: $2.246$
:::
*/
CLAIM(table_misses_the_second_x) { wrong_number(T, 2, 0, "2.246"); }

/*
:::{claim} rounded_factors_of_the_table
:title: What the rounded functions of each row give
:zh: 用表中舍入后的基函数值所得的点
:kind: decision
:given: the printed values of the functions, as the decimals they are
:then: in the rows of $t=0.15,0.35,0.65,0.85$ their sums are $0.9998$, $1.001$, $1.001$, $0.9998$, and the points $(1.5038,1.7646)$,
  $(2.248,2.367)$, $(3.122,2.367)$, $(3.2602,1.7646)$; the other rows are exact
:method: The sums, exactly.
:control: $(2.248,2.376)$ in the row of $t=0.35$, as printed
:::
*/
CLAIM(rounded_factors_of_the_table)
{
    static const char *const sums[7] = {"1", "0.9998", "1.001", "1", "1.001", "0.9998", "1"};
    static const char *const points[7][2] = {{"1", "1"},      {"1.5038", "1.7646"}, {"2.248", "2.367"},
                                             {"2.75", "2.5"}, {"3.122", "2.367"},   {"3.2602", "1.7646"},
                                             {"3", "1"}};
    for (int row = 0; row < 7; row++) {
        num total = from_int(0), P[dim] = {from_int(0), from_int(0)};
        for (int i = 0; i <= 3; i++) {
            num factor = from_string_q(printed_table[row].basis[i]);
            total = add(total, factor);
            for (int c = 0; c < dim; c++)
                P[c] = add(P[c], mul(factor, from_int(printed_points[i * dim + c])));
        }
        about(T, "the sum of the functions");
        same(T, total, from_string_q(sums[row]));
        about(T, "the point");
        for (int c = 0; c < dim; c++) {
            const char *value =
                fault(T, points[row][c], row == 2 && c == 1 ? printed_table[row].point[c] : points[row][c]);
            same(T, P[c], from_string_q(value));
        }
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
:figure: worked_table

The sum with the rounded factors is 2.367: two digits have changed places.  The points have the heights 1, 3, 3, 1, so $y(0.35)=y(0.65)$, which the table denies as well.
:::

:::{claim} table_misses_the_second_y
:title: The second coordinate at t = 0.35 is printed wrong
:zh: t=0.35 处纵坐标有误
:kind: counterexample
:given: the points of the table, $t=0.35$; the printed $y=2.376$
:then: the exact value is $2.365$
:method: The exact value, and the printed one as the decimal it is; their distance is at most half a unit of the last printed digit.
:control: $2.365$
:::
*/
CLAIM(table_misses_the_second_y) { wrong_number(T, 2, 1, "2.365"); }

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
:given: the points of the table, $t=0.5$; the printed values of the four functions and $x$ and $y$
:then: each is the exact value, rounded to the digits that are printed
:method: The exact value, and the printed one as the decimal it is; their distance is at most half a unit of the last printed digit.
:control: one unit more in the last digit of the first function
:::
*/
CLAIM(table_row_of_middle) { right_numbers(T, 3, 1, 1); }

/*
:::{statement} slides-ch4:table-bezier-row-0.65-basis
:title: The four functions at t = 0.65
:zh: t=0.65 处的四个基函数值
:printed: $t=0.65$: $(1-t)^3=0.043$, $3t(1-t)^2=0.239$, $3t^2(1-t)=0.444$, $t^3=0.275$
:holds-by: table_row_of_sixty_five_hundredths
:figure: worked_table
:::

:::{claim} table_row_of_sixty_five_hundredths
:title: The row of t = 0.65, its right numbers
:zh: 表中 t=0.65 行的正确数字
:kind: decision
:given: the points of the table, $t=0.65$; the printed values of the four functions and $y$
:then: each is the exact value, rounded to the digits that are printed
:method: The exact value, and the printed one as the decimal it is; their distance is at most half a unit of the last printed digit.
:control: one unit more in the last digit of the first function
:::
*/
CLAIM(table_row_of_sixty_five_hundredths) { right_numbers(T, 4, 0, 1); }

/*
:::{statement} slides-ch4:table-bezier-row-0.65-x
:title: The first coordinate at t = 0.65
:zh: t=0.65 处的横坐标
:printed: x(0.65)=3.122
:refuted-by: table_misses_the_third_x
:class: false
:corrected: x(0.65)=3.119
:corrected-by: exact_values_of_the_table
:reading: rounded_factors_of_the_table | the sum with the rounded factors of the same row: true
:figure: worked_table

It is what the rounded factors of the row give.
:::

:::{claim} table_misses_the_third_x
:title: The first coordinate at t = 0.65 is printed wrong
:zh: t=0.65 处横坐标有误
:kind: counterexample
:given: the points of the table, $t=0.65$; the printed $x=3.122$
:then: the exact value is $3.119$
:method: The exact value, and the printed one as the decimal it is; their distance is at most half a unit of the last printed digit.
:control: $3.119$
:::
*/
CLAIM(table_misses_the_third_x) { wrong_number(T, 4, 0, "3.119"); }

/*
:::{statement} slides-ch4:table-bezier-row-0.65-y
:title: The second coordinate at t = 0.65
:zh: t=0.65 处的纵坐标
:printed: y(0.65)=2.36
:holds-by: table_row_of_sixty_five_hundredths
:hypothesis: five_rounded_up_gives_another_digit | a five is not rounded up: 四舍五入 gives 2.37
:figure: worked_table

The value is 2.365, exactly between 2.36 and 2.37: rounded to the even digit, or cut off.  The sum with the rounded factors is 2.367.  A last
digit, 5, may also have been left out, as the 6 in the next row.
:::

:::{claim} five_rounded_up_gives_another_digit
:title: With fives rounded up 2.365 is not 2.36
:zh: 四舍五入时 2.365 不为 2.36
:kind: counterexample
:given: the exact $y(0.65)=2.365$ and the printed 2.36
:then: $y$ is rounded to $r$, fives up, when $r-\frac12$ unit $\le y<r+\frac12$ unit of the last digit; for $r=2.36$ the second is an equality
:method: Both signs, exactly.
:control: 2.37
:::
*/
CLAIM(five_rounded_up_gives_another_digit)
{
    const char *rounded = fault(T, "2.37", printed_table[4].point[1]);
    num exact = exact_coordinate(4, 1), half = div(last_unit(rounded), from_int(2));
    show_text(T, "rounded", "%s", rounded);
    show(T, "exact", exact);
    num above = sub(add(from_string_q(rounded), half), exact), below = sub(exact, sub(from_string_q(rounded), half));
    show(T, "what is left to half a unit", above);
    about(T, "whether it is rounded, fives up");
    agree(T, sign_q(above) > 0 && sign_q(below) >= 0);
}
#endif

/*
:::{claim} heights_of_the_example_are_symmetric
:title: The heights of the example are the same at t and at 1 - t
:zh: 算例中纵坐标关于 t=1/2 对称
:given: the second coordinates 1, 3, 3, 1, any $t$
:then: $y(t)=y(1-t)=1+6t-6t^2$
:method: By the kernel at a variable $t$.
:control: the second coordinates 1, 3, 3, 2
:::
*/
CLAIM(heights_of_the_example_are_symmetric)
{
    num t = parameter(T, "t"), s = sub(from_int(1), t), three = from_int(3), here, there;
    num y[4] = {from_int(1), three, three, from_int(fault(T, 1, 2))};
    G(decasteljau)(3, 1, y, t, &here);
    G(decasteljau)(3, 1, y, s, &there);
    same(T, here, there);
    same(T, here, add(from_int(1), mul(from_int(6), mul(t, s))));
}

/*
:::{statement} slides-ch4:table-bezier-row-0.85-basis
:title: The four functions at t = 0.85
:zh: t=0.85 处的四个基函数值
:printed: $t=0.85$: $(1-t)^3=0.0034$, $3t(1-t)^2=0.0574$, $3t^2(1-t)=0.325$, $t^3=0.614$
:holds-by: table_row_of_eighty_five_hundredths
:figure: worked_table
:::
*/

#if RATIONAL
/*
:::{claim} table_row_of_eighty_five_hundredths
:title: The row of t = 0.85, its right numbers
:zh: 表中 t=0.85 行的正确数字
:kind: decision
:given: the points of the table, $t=0.85$; the printed values of the four functions
:then: each is the exact value, rounded to the digits that are printed
:method: The exact value, and the printed one as the decimal it is; their distance is at most half a unit of the last printed digit.
:control: one unit more in the last digit of the first function
:::
*/
CLAIM(table_row_of_eighty_five_hundredths) { right_numbers(T, 5, 0, 0); }

/*
:::{statement} slides-ch4:table-bezier-row-0.85-x
:title: The first coordinate at t = 0.85
:zh: t=0.85 处的横坐标
:printed: x(0.85)=3.248
:refuted-by: table_misses_the_fourth_x
:class: misprint
:corrected: x(0.85)=3.261
:corrected-by: exact_values_of_the_table
:figure: worked_table

The sum with the rounded factors is 3.2602; nothing near leads to 3.248, whose digits after the point are those of $x(0.35)$ in the same column.
:::

:::{claim} table_misses_the_fourth_x
:title: The first coordinate at t = 0.85 is printed wrong
:zh: t=0.85 处横坐标有误
:kind: counterexample
:given: the points of the table, $t=0.85$; the printed $x=3.248$
:then: the exact value is $3.261$
:method: The exact value, and the printed one as the decimal it is; their distance is at most half a unit of the last printed digit.
:control: $3.261$
:::
*/
CLAIM(table_misses_the_fourth_x) { wrong_number(T, 5, 0, "3.261"); }

/*
:::{statement} slides-ch4:table-bezier-row-0.85-y
:title: The second coordinate at t = 0.85
:zh: t=0.85 处的纵坐标
:printed: y(0.85)=1.75
:refuted-by: table_misses_the_fourth_y
:class: misprint
:corrected: y(0.85)=1.765
:corrected-by: exact_values_of_the_table
:figure: worked_table

The sum with the rounded factors is 1.7646.  The table has the right value, 1.765, in the row of $t=0.15$, and $y(0.85)=y(0.15)$: a digit, 6, is left out.
To two digits after the point it is 1.76 or 1.77; by no rule of rounding, nor cut off, is it 1.75.
:::

:::{claim} table_misses_the_fourth_y
:title: The second coordinate at t = 0.85 is printed wrong
:zh: t=0.85 处纵坐标有误
:kind: counterexample
:given: the points of the table, $t=0.85$; the printed $y=1.75$
:then: the exact value is $1.765$
:method: The exact value, and the printed one as the decimal it is; their distance is at most half a unit of the last printed digit.
:control: $1.765$
:::
*/
CLAIM(table_misses_the_fourth_y) { wrong_number(T, 5, 1, "1.765"); }

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
:given: the points of the table, $t=1$; the printed values of the four functions and $x$ and $y$
:then: each is the exact value, rounded to the digits that are printed
:method: The exact value, and the printed one as the decimal it is; their distance is at most half a unit of the last printed digit.
:control: one unit more in the last digit of the first function
:::
*/
CLAIM(table_row_of_end) { right_numbers(T, 6, 1, 1); }
#endif

#include "chapters/judge/claims_off.h"
