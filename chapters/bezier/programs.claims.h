/*
# Two programs (绘制 Bézier 曲线的程序)

The slides print two functions in C++.  `decas` computes one coordinate of the point at $t$ by the recursion; `bez_to_points`
calls it for the parameters of a step $\frac1{npoints}$.  In the text at hand the signs `<`, the brackets and the last letters
are lost, with everything that stood between a `<` and the next `>`; so the line that fills `R` and the head of the outer
loop are one fragment.  What the rest of the function needs determines them:

    for (i = 0; i <= n; i++) R[i] = P[i];
    for (m = n; m > 0; m--) { ... }

Here the functions are built again, statement by statement, on arrays that notice what is done to them: a place beyond the
end, a value that was never written, an array released in the way of a single number.  (As printed, `decas` is also used
before it is declared, which a compiler does not accept.)

Three questions are different: whether the right number comes out in exact arithmetic; what happens to the memory; and what
happens in binary64, where the parameter is a sum of rounded steps.
*/
#include "chapters/bezier/definition.h"

#include "chapters/judge/claims_on.h"

enum { MOST_PLACES = 80 };

/*
## The right number

:::{statement} slides-ch4:4-program-decas
:title: The function decas computes the point
:zh: 函数 decas 求曲线上一点
:printed: R and Q have $n+1$ numbers; for(i=0;i0;m-): Q[i] = R[i] + t*(R[i+1]-R[i]) for i < m, R[i] = Q[i] for i <= m-1; the
  result is R[0], the value of the curve at $t$
:holds-by: program_computes_the_curve bernstein_recurrence
:argued: every n | One pass of the outer loop is one level of the recursion, which holds for every $n\ge1$; after $n$ passes
  R[0] is the value of the curve.  For $n=0$ no pass is made, and R[0] is P[0].
:hypothesis: difference_loses_the_last_point | the arithmetic is exact: in binary64 the result at $t=1$ need not be the last
  point
:meant: the rest of the function, which needs `R` filled and $m=n$ in the first pass | `for(i=0;i0;m-)` is what is left of two loops: in the first R[i] = P[i] for i from 0 to $n$; the second, in which all that
  follows is done but for the result, is for m from $n$ down to 1.
:figure: last_point_lost

In the text at hand the signs `<` are lost, with what stood between one of them and a sign `>`, and so are brackets and signs `+` of the loops.  `P` is an array of numbers, one coordinate of each point: so the result is one
coordinate of the point.
:::

:::{statement} slides-ch4:4-program-step
:title: The value of a curve of degree n from those of two curves of degree n-1
:zh: 程序注释:n 次曲线由两条 n-1 次曲线线性组合
:printed: the value of a Bézier curve of degree $n$ at $t$ is found by a linear combination of the values of two Bézier curves of degree $n-1$ at $t$
:holds-by: bernstein_recurrence
:confirmed-by: curve_blends_two_curves_of_one_point_less program_computes_the_curve
:figure: two_curves_of_one_point_less

The two curves are those of the first $n$ and of the last $n$ points, the factors $1-t$ and $t$: the coefficients of each point on both sides are those of the
recurrence of the Bernstein polynomials.
:::
*/

/* What has been done to the arrays of a program. */
struct G(memory) {
    int made, released, released_otherwise; /* arrays; the last: as if they were single numbers */
    int too_late;                           /* accesses to, and releases of, what was released */
    int beyond, unwritten;                  /* accesses beyond an end; reads of what was never written */
};
struct G(array) {
    struct G(memory) * memory;
    int size, gone, written[MOST_PLACES], read[MOST_PLACES]; /* released; how often each place */
    num at[MOST_PLACES];
};

static void G(make_array)(struct G(memory) * memory, int size, struct G(array) * A)
{
    *A = (struct G(array)){.memory = memory, .size = size};
    memory->made++;
}

static void G(release_array)(struct G(array) * A, int as_array)
{
    A->memory->too_late += A->gone;
    A->gone = 1;
    A->memory->released++;
    A->memory->released_otherwise += !as_array;
}

static void G(put)(struct G(array) * A, int i, num value)
{
    A->memory->too_late += A->gone;
    if (i < 0 || i >= A->size) {
        A->memory->beyond++;
        return;
    }
    A->written[i]++;
    A->at[i] = value;
}

static num G(get)(struct G(array) * A, int i)
{
    A->memory->too_late += A->gone;
    if (i < 0 || i >= A->size) {
        A->memory->beyond++;
        return from_int(0);
    }
    A->read[i]++;
    A->memory->unwritten += !A->written[i];
    return A->written[i] ? A->at[i] : from_int(0);
}

/* How a program is run: as printed, but for the faults and the corrections that are named here. */
struct G(program) {
    struct G(memory) memory;
    num (*round)(num x); /* after every operation */
    int first;           /* of the inner loop: 0 as printed                             */
    int missing;         /* places that R lacks: 0 as printed                           */
    int missing_of_Q;    /* places that Q lacks: 0 as printed                           */
    int as_array;        /* delete[]: 0 as printed                                      */
    int two_products;    /* (1-t) R_i + t R_{i+1}: 0 as printed                          */
    int by_quotient;     /* t = i/npoints: 0 as printed                                 */
    int early;           /* the step before the point: 0 as printed                     */
};

static inline num G(unrounded)(num x) { return x; }

static num G(decas)(struct G(program) * run, int n, struct G(array) * P, num t)
{
    num (*fl)(num) = run->round, P0;
    struct G(array) R, Q;
    int m, i;
    G(make_array)(&run->memory, n + 1 - run->missing, &R);
    G(make_array)(&run->memory, n + 1 - run->missing_of_Q, &Q);
    for (i = 0; i <= n; i++)
        G(put)(&R, i, G(get)(P, i));
    for (m = n; m > 0; m--) {
        for (i = run->first; i < m; i++) {
            num here = G(get)(&R, i), next = G(get)(&R, i + 1);
            if (run->two_products)
                G(put)(&Q, i, fl(add(fl(mul(fl(sub(from_int(1), t)), here)), fl(mul(t, next)))));
            else
                G(put)(&Q, i, fl(add(here, fl(mul(t, fl(sub(next, here)))))));
        }
        for (i = 0; i <= m - 1; i++)
            G(put)(&R, i, G(get)(&Q, i));
    }
    P0 = G(get)(&R, 0);
    G(release_array)(&R, run->as_array);
    G(release_array)(&Q, run->as_array);
    return P0;
}

/* The array of the points, and an array for results; neither is counted as made by the program. */
static void G(given_array)(struct G(program) * run, int count, const num from[], struct G(array) * A)
{
    *A = (struct G(array)){.memory = &run->memory, .size = count};
    for (int i = 0; i < count && from != NULL; i++)
        G(put)(A, i, from[i]);
}

/* Compare: a count of the memory is what it should be. */
static void G(counted)(trial *T, const char *what, int count, int expected)
{
    about(T, what);
    same(T, from_int(count), from_int(expected));
}

/*
The function keeps one level of the triangle in `R`, computes the next one in `Q` and copies it back.  That the loops never leave the
arrays, and read nothing that was not written, is part of the claim.

:::{claim} program_computes_the_curve
:title: The printed function computes the curve and touches nothing else
:zh: 程序 decas 的正确性
:given: numbers $P_0,\dots,P_n$, any $t$
:then: the result is $\sum_iB_{i,n}(t)P_i$; no place beyond the ends of `P`, `R` and `Q` is read or written, and none is read before it is written
:method: The function as printed, on arrays that count, against the definition; everything a variable.
:degrees: 0..6 sampled 12
:over: x#: points
:control: the inner loop from $i=1$ on
:::
*/
CLAIM(program_computes_the_curve)
{
    int n = T->degree;
    struct G(program) run = {.round = G(unrounded), .first = fault(T, 0, 1)};
    struct G(array) P;
    num b[MAX_DEGREE + 1], t = parameter(T, "t");
    G(free_points)(T, n, 1, b);
    G(given_array)(&run, n + 1, b, &P);
    about(T, "the result");
    same(T, G(decas)(&run, n, &P, t), G(curve)(n, 1, b, 0, t));
    G(counted)(T, "places beyond an end", run.memory.beyond, 0);
    G(counted)(T, "reads of what was not written", run.memory.unwritten, 0);
}

/*
The second function adds a step $\frac1{npoints}$ to the parameter after each point.  In exact arithmetic the last point has the parameter 1.  In binary64 the
step is already rounded, unless npoints is a power of 2, and each sum may have to be rounded again.

:::{statement} slides-ch4:4-program-division
:title: The parameter is divided into npoints equal parts
:zh: 将参数 t 作 npoints 等分
:printed: $delt=1/npoints$, the parameter $t$ is divided into npoints equal parts; $t=0$, and after each point $t=t+delt$
:holds-by: equal_steps_reach_every_part
:confirmed-by: program_ends_at_one_in_exact_arithmetic sum_of_steps_is_seldom_one
:hypothesis: sum_of_steps_misses_one | the arithmetic is exact: in binary64 the last parameter need not be 1
:hypothesis: no_steps_have_no_length | $npoints\ge1$: for $npoints=0$ the step would be $\frac10$
:figure: last_parameter
:striking: 46

The last point has the parameter after npoints steps; the step behind it is not used.  In binary64 other numbers of steps miss 1, too:
`sum_of_steps_is_seldom_one`.
:::

:::{statement} slides-ch4:4-program-all-points
:title: The points one after the other
:zh: 分别求出 npoints+1 个离散点
:printed: for i = 0, ..., npoints the point number i is the value of decas at $t$: npoints+1 points of the curve are found one after the other
:holds-by: program_ends_at_one_in_exact_arithmetic equal_steps_reach_every_part
:argued: every degree and every npoints | Point number $i$ has the parameter $\frac iN$, $N$ being npoints, and is found by a call of decas that knows nothing of the
  others.  One pass of the outer loop of decas is one level of the recursion, which `slides-ch4:4-recursion` proves for every degree from 1 on, so decas computes the point; for degree 0 it makes no pass, and returns the one number of `P`.
:confirmed-by: corrected_program_ends_at_the_last_point program_computes_the_curve
:hypothesis: last_point_of_the_example_is_missed | the arithmetic is exact: in binary64 the last of them need not be the end of
  the curve
:hypothesis: no_steps_have_no_length | $npoints\ge1$: for $npoints=0$ the step would be $\frac10$
:figure: last_parameter

With $t=i/npoints$ and $(1-t)R_i+tR_{i+1}$ the first and the last point are exact in binary64, too, for one cubic and up to 24 steps:
`corrected_program_ends_at_the_last_point`.  One coordinate of each point is found; for a curve in the plane the program runs twice.  As printed `decas` stands behind the
function that calls it, and C++ wants it declared before.  In the
text at hand the signs `<` and `+` of the loop are lost, `for(int i=0;i=npoints;i+)`; that it ends with i = npoints is what the comment beside it says, npoints+1 points.
:::
*/

#if RATIONAL
/*
:::{claim} no_steps_have_no_length
:title: For npoints = 0 there is no step
:zh: npoints=0 时无步长
:kind: counterexample
:data: npoints = 0
:instead: npoints = 1
:given: no steps
:then: the divisor of $delt=1/npoints$ is 0
:method: The divisor; that it is not 0 is refuted.
:control: one step
:::
*/
CLAIM(no_steps_have_no_length)
{
    num npoints = given(T, "npoints");
    about(T, "whether the divisor is not 0");
    refute(T, is_zero_q(npoints));
}
#endif

/* Returns the last parameter. */
static num G(bez_to_points)(struct G(program) * run, int n, int npoints, struct G(array) * P, struct G(array) * points)
{
    num (*fl)(num) = run->round, delt = fl(div(from_int(1), from_int(npoints))), t = from_int(0), last = t;
    if (run->early)
        t = delt;
    for (int i = 0; i <= npoints; i++) {
        if (run->by_quotient)
            t = fl(div(from_int(i), from_int(npoints)));
        last = t;
        G(put)(points, i, G(decas)(run, n, P, t));
        t = fl(add(t, delt));
    }
    return last;
}

/*
:::{claim} equal_steps_reach_every_part
:title: Steps of one N-th from 0 on reach every i/N, and 1 after N of them
:zh: 以 1/N 为步长从 0 出发经 N 步到达 1
:given: any number $N$ of steps, any $i$; the parameter $\frac iN$
:then: one step further it is $\frac{i+1}N$; so it is $\frac iN$ after $i$ steps, and $\frac NN=1$ in the end
:method: An identity in $i$ and $N$; then induction.
:scope: every npoints
:over: i N: -
:control: a step of $\frac1{N+1}$
:::
*/
CLAIM(equal_steps_reach_every_part)
{
    num i = whole(T, "i", 0, 20), N = whole(T, "N", 21, 40), one = from_int(1);
    num step = div(one, fault(T, N, add(N, one)));
    same(T, add(div(i, N), step), div(add(i, one), N));
    same(T, mul(N, step), one);
}

/*
:::{claim} program_ends_at_one_in_exact_arithmetic
:title: In exact arithmetic the points are those of equal steps, from the first point to the last
:zh: 精确运算下离散点的参数为 i/N
:given: a curve of degree $n$ with any points of a line, $N$ steps
:then: the program makes $N+1$ numbers, number $i$ being $P(\frac iN)$; the first is $P_0$, the last $P_n$
:method: The program as printed, against the definition at $\frac iN$, one case for each $N$ and $n$.
:degrees: npoints = 1..6 sampled 12
:data: D = 5
:scope: degree 0 to 5
:over: x#: points
:control: the first step taken before the first point
:::
*/
CLAIM(program_ends_at_one_in_exact_arithmetic)
{
    int steps = T->degree;
    struct G(program) run = {.round = G(unrounded), .early = fault(T, 0, 1)};
    struct G(array) P, points;
    int largest = given_whole(T, "D");
    for (int n = 0; n <= largest; n++) {
        num b[MAX_DEGREE + 1];
        G(free_points)(T, n, 1, b);
        G(given_array)(&run, n + 1, b, &P);
        G(given_array)(&run, steps + 1, NULL, &points);
        about(T, "the last parameter");
        same(T, G(bez_to_points)(&run, n, steps, &P, &points), from_int(1));
        for (int i = 0; i <= steps; i++) {
            about(T, "a point");
            same(T, G(get)(&points, i), G(curve)(n, 1, b, 0, from_ratio(i, steps)));
        }
        about(T, "the ends");
        same(T, G(get)(&points, 0), b[0]);
        same(T, G(get)(&points, steps), b[n]);
    }
}

/*
## Memory

:::{statement} slides-ch4:4-program-control-points
:title: There are n+1 control points
:zh: 控制点个数为 n+1
:printed: P holds the coordinates of the control points, $n+1$ in number
:holds-by: program_stays_in_its_arrays
:argued: every n and every number of steps | The points are read once, P[i] for $i=0,\dots,n$, in each call, and the calls know nothing of one another.
:meant: the $n+1$ places of `R`, and the recursion, which needs every control point | The loop that fills `R` from `P` runs from 0 to $n$: R[i] = P[i].

Each of them is read, and no other.  The loop that reads them is not to be read in the text at hand, where it is one fragment with the head of the outer loop, `for(i=0;i0;m-)`.  What `P` holds is one coordinate of each point, since it is an array of numbers.
:::
*/

#if RATIONAL
/* The program with `steps` steps on given points; returns the last parameter. */
static num drawn(struct program_q *run, int n, const num b[], int steps, int places, struct array_q *points)
{
    struct array_q P;
    given_array_q(run, n + 1, b, &P);
    given_array_q(run, places, NULL, points);
    return bez_to_points_q(run, n, steps, &P, points);
}

/*
:::{claim} program_stays_in_its_arrays
:title: With npoints+1 places and delete[] the program does nothing that it must not
:zh: 更正后的程序内存使用正确
:kind: decision
:data: npoints = 8
:given: a polygon of degree $n$ on a line and npoints steps; an array of npoints+1 places for the points, delete[] for the arrays
:then: nothing is read or written beyond an end, nothing is read before it is written or after it is released; `R` and `Q` are made for each of the
  npoints+1 points, and each is released once in its own way; each of the npoints+1 places for the points is written once, and each of the $n+1$ control points
  is read once for each of these; all this is so with $n$ places for `Q`, too
:method: The program on the arrays that count, and one call of decas alone, which is made for each point.  What it touches depends on $n$ and the number of steps
  only, not on the numbers.
:degrees: 0..24
:scope: 8 steps
:control: R with $n$ places
:::
*/
CLAIM(program_stays_in_its_arrays)
{
    int n = T->degree, steps = given_whole(T, "npoints");
    for (int missing_of_Q = 0; missing_of_Q <= 1; missing_of_Q++) {
        struct program_q run = {
            .round = unrounded_q, .as_array = 1, .missing = fault(T, 0, 1), .missing_of_Q = missing_of_Q};
        struct program_q one_call = run;
        struct array_q P, points;
        num b[MOST_PLACES];
        for (int i = 0; i <= n; i++)
            b[i] = from_int(i * i);
        given_array_q(&one_call, n + 1, b, &P);
        decas_q(&one_call, n, &P, from_ratio(1, 3));
        counted_q(T, "arrays made in one call", one_call.memory.made, 2);
        counted_q(T, "arrays released in one call", one_call.memory.released, 2);
        for (int i = 0; i <= n; i++)
            counted_q(T, "how often a control point is read in one call", P.read[i], 1);
        given_array_q(&run, n + 1, b, &P);
        given_array_q(&run, steps + 1, NULL, &points);
        bez_to_points_q(&run, n, steps, &P, &points);
        counted_q(T, "places beyond an end", run.memory.beyond, 0);
        counted_q(T, "reads of what was not written", run.memory.unwritten, 0);
        counted_q(T, "uses of what was released", run.memory.too_late, 0);
        counted_q(T, "arrays made", run.memory.made, 2 * (steps + 1));
        counted_q(T, "arrays released", run.memory.released, run.memory.made);
        counted_q(T, "arrays released in the wrong way", run.memory.released_otherwise, 0);
        for (int i = 0; i <= steps; i++)
            counted_q(T, "how often the place of a point is written", points.written[i], 1);
        for (int i = 0; i <= n; i++)
            counted_q(T, "how often a control point is read", P.read[i], steps + 1);
    }
}

/*
One comment of the program counts the points as npoints, another as npoints+1.  A loop from 0 to npoints makes npoints+1 of them, and the
difference is one place of memory.

:::{statement} slides-ch4:4-program-points-count
:title: The array of points holds npoints points
:zh: 注释称离散点个数为 npoints
:printed: points is the sequence of points on the curve, npoints in number
:refuted-by: program_writes_one_point_too_many
:class: false
:corrected: The number of points is npoints+1, as another comment of the same program says, and the array needs as many places.
:corrected-by: program_stays_in_its_arrays
:argued: every degree and every number of steps | The loop writes points[i] for $i=0,\dots,$npoints, once each, whatever the points are.
:figure: one_place_too_many
:striking: 47

A caller who takes the comment at its word makes an array with npoints places, and the program writes beyond its end.
:::
*/

/*
:::{claim} program_writes_one_point_too_many
:title: The last point is written beyond the end
:zh: 末点写出数组边界
:kind: counterexample
:data: P = 1 3 3 1; npoints = 4; places = 4
:instead: places = 5
:result: points written = 5; beyond the end = 1
:given: a cubic with the points $P$ of a line, a number of steps, and an array of as many places as the comment says
:then: one point more is written than there are steps, and one beyond the end of the array
:method: The program on the arrays that count; that the number of places beyond the end is 0 is refuted.
:control: one place more
:::
*/
CLAIM(program_writes_one_point_too_many)
{
    struct program_q run = {.round = unrounded_q};
    struct array_q points;
    num P[4];
    given_points(T, "P", 4, 1, P);
    int steps = given_whole(T, "npoints"), written = 0;
    drawn(&run, 3, P, steps, given_whole(T, "places"), &points);
    for (int i = 0; i < points.size; i++)
        written += points.written[i] > 0;
    found_whole(T, "points written", written + run.memory.beyond);
    found_whole(T, "beyond the end", run.memory.beyond);
    counted_q(T, "places beyond the end", run.memory.beyond, 0);
}

/*
:::{statement} slides-ch4:4-program-arrays
:title: The arrays R and Q have n+1 places
:zh: 数组 R、Q 的大小
:printed: R = new double[n+1], Q = new double[n+1]
:holds-by: program_stays_in_its_arrays
:argued: every n and every number of steps | R[i] is filled for $i\le n$, and R[i+1] and Q[i] are used for $i<m\le n$ only, so that no index is greater than $n$; and the calls know nothing of one another.

`R` needs them all.  `Q` would do with $n$ places: Q[n] is never used.  In the text at hand the brackets are lost: it has new double and $n+1$
behind it.
:::

:::{statement} slides-ch4:4-program-delete
:title: The arrays are released
:zh: 释放数组
:printed: delete R; delete Q;
:reading: program_stays_in_its_arrays | if delete[] was printed, and its brackets are lost like all others, the arrays are released as they were made
:reading: program_releases_arrays_as_numbers | if delete was printed, as it stands here, the arrays are released as they were made

In C++ what was made by new[] has to be released by delete[]; with delete the behaviour is undefined.  In the text at hand no square bracket of the
program is left: new double[n+1] is without its brackets as well, so that it does not tell which was printed.
:::

:::{claim} program_releases_arrays_as_numbers
:title: Both arrays are released in the wrong way
:zh: 以 delete 释放数组
:kind: counterexample
:data: P = 1 3 3 1; t = 1/2
:result: released by delete = 2
:given: one call of `decas` as printed, with the points $P$ of a line, at the parameter $t$
:then: both arrays that were made by new[] are released by delete
:method: The program on the arrays that count; that the number is 0 is refuted.
:control: delete[]
:::
*/
CLAIM(program_releases_arrays_as_numbers)
{
    struct program_q run = {.round = unrounded_q, .as_array = fault(T, 1, 0)};
    struct array_q places;
    num P[4];
    given_points(T, "P", 4, 1, P);
    given_array_q(&run, 4, P, &places);
    decas_q(&run, 3, &places, given(T, "t"));
    found_whole(T, "released by delete", run.memory.released_otherwise);
    counted_q(T, "arrays released as if they were numbers", run.memory.released_otherwise, 0);
}
#endif

/*
## Binary64
*/

#if RATIONAL
static num binary64(num x) { return from_double_q(to_double_q(x)); }

static num last_of_steps(int steps)
{
    struct program_q run = {.round = binary64};
    struct array_q points;
    num b[1] = {from_int(1)};
    return drawn(&run, 0, b, steps, steps + 1, &points);
}

/*
Here every operation is carried out exactly and then rounded, as IEEE 754 asks; so what follows is what every computer does that keeps to it.

:::{claim} sum_of_steps_misses_one
:title: Six steps of a sixth do not end at 1
:zh: 六个 1/6 之和在 binary64 中不等于 1
:kind: counterexample
:data: npoints = 6
:instead: npoints = 5
:result: the last parameter = 0x1.fffffffffffffp-1
:given: six steps, every operation rounded to binary64
:then: the last parameter is $1-2^{-53}$, the greatest binary64 below 1
:method: The quotient and the sums in rationals, each rounded to the nearest binary64, ties to even.
:control: five steps
:::
*/
CLAIM(sum_of_steps_misses_one)
{
    num last = last_of_steps(given_whole(T, "npoints"));
    found(T, "the last parameter", last);
    about(T, "the last parameter");
    same(T, last, from_int(1));
}

/*
:::{claim} sum_of_steps_is_seldom_one
:title: For 52 of the first 64 numbers of steps the last parameter is not 1
:zh: 步数不超过 64 时末参数等于 1 的情形
:kind: decision
:data: N = 64; steps = 1 2 3 4 5 8 12 16 17 32 34 64
:instead: steps = 1 2 3 4 5 6 12 16 17 32 34 64
:result: not 1 = 52; less than 1 = 26; greater than 1 = 26
:given: every number of steps up to $N$, every operation rounded to binary64
:then: the last parameter is 1 for the numbers of steps that are listed and for no others; for one half of the others it is less than 1, for
  the other half it is greater
:method: The quotients and the sums in rationals, each rounded to the nearest binary64, ties to even.
:control: 6 listed in the place of 8
:::
*/
CLAIM(sum_of_steps_is_seldom_one)
{
    enum { LISTED = 12 };
    int most = given_whole(T, "N"), below = 0, above = 0, k = 0;
    num exact[LISTED], one = from_int(1);
    given_points(T, "steps", LISTED, 1, exact);
    for (int steps = 1; steps <= most; steps++) {
        num last = last_of_steps(steps);
        int listed = k < LISTED && equal_q(exact[k], from_int(steps));
        k += listed;
        about(T, "whether the last parameter is 1");
        if (listed)
            same(T, last, one);
        else
            agree(T, !equal_q(last, one));
        below += compare_q(last, one) < 0;
        above += compare_q(last, one) > 0;
    }
    found_whole(T, "not 1", below + above);
    found_whole(T, "less than 1", below);
    found_whole(T, "greater than 1", above);
    counted_q(T, "how many are listed", LISTED, most - below - above);
    counted_q(T, "how often less, and how often greater", below, above);
}

/*
:::{claim} last_point_of_the_example_is_missed
:title: Six steps over the curve of the table do not end at its last point
:zh: 算例六等分时末点有误差
:kind: counterexample
:data: P = 1 3 3 1; npoints = 6
:instead: npoints = 5
:result: the last parameter = 0x1.fffffffffffffp-1; the last point = 0x1.0000000000003p0
:given: the second coordinates $P$ of the worked table and six steps, every operation rounded to binary64
:then: the last point is $1+3\cdot2^{-52}$, and not $P_3$
:method: The program with every operation rounded, against $P_3$.
:control: five steps
:::
*/
CLAIM(last_point_of_the_example_is_missed)
{
    struct program_q run = {.round = binary64};
    struct array_q points;
    num P[4];
    given_points(T, "P", 4, 1, P);
    int steps = given_whole(T, "npoints");
    found(T, "the last parameter", drawn(&run, 3, P, steps, steps + 1, &points));
    found(T, "the last point", points.at[steps]);
    about(T, "the last point and P_3");
    same(T, points.at[steps], P[3]);
}

/*
There are two ways to divide an edge, and they are not equally good at its ends.  With $R+t(R'-R)$ one product is saved, but
for $t=1$ the result is $R+(R'-R)$, rounded twice; with $(1-t)R+tR'$ it is $R'$.

:::{claim} difference_loses_the_last_point
:title: At t = 1 the form with one product may lose the last point
:zh: t=1 时 R+t(R'-R) 在 binary64 中可能不等于 R'
:kind: counterexample
:data: P = 1 0x1p-54; t = 1
:result: P_1 - P_0 = -1; P(t) = 0
:given: the segment from $P_0$ to $P_1=2^{-54}$, every operation rounded to binary64
:then: $P_1-P_0$ is rounded to $-1$, and at the end $t=1$ the result is 0
:method: The function with every operation rounded.
:control: $(1-t)P_0+tP_1$
:::
*/
CLAIM(difference_loses_the_last_point)
{
    struct program_q run = {.round = binary64, .two_products = fault(T, 1, 0)};
    struct array_q places;
    num P[2];
    given_points(T, "P", 2, 1, P);
    given_array_q(&run, 2, P, &places);
    num last = decas_q(&run, 1, &places, given(T, "t"));
    found(T, "P_1 - P_0", binary64(sub(P[1], P[0])));
    found(T, "P(t)", last);
    about(T, "the result and P_1");
    same(T, last, P[1]);
}

/*
:::{claim} corrected_program_ends_at_the_last_point
:title: With t = i/npoints and two products the last point is the last point
:zh: 改正后的程序末点精确
:kind: decision
:data: P = 1 1/10 1/3 0x1p-54; N = 24
:given: every number of steps up to $N$, the points $P$ of a line rounded to binary64, every operation rounded
:then: the parameter $\frac i{npoints}$ is 1 for the last $i$, and with $(1-t)R_i+tR_{i+1}$ the last point is $P_3$; the first is $P_0$
:method: At $t=1$ one product is 0 and the other is the number itself, whatever the numbers are, and at $t=0$ likewise: no rounding occurs.
  Computed for the points that are given.
:control: the parameter as a sum of steps
:::
*/
CLAIM(corrected_program_ends_at_the_last_point)
{
    num P[4];
    given_points(T, "P", 4, 1, P);
    int most = given_whole(T, "N");
    for (int i = 0; i <= 3; i++)
        P[i] = binary64(P[i]);
    for (int steps = 1; steps <= most; steps++) {
        struct program_q run = {.round = binary64, .two_products = 1, .by_quotient = fault(T, 1, 0), .as_array = 1};
        struct array_q points;
        num last = drawn(&run, 3, P, steps, steps + 1, &points);
        about(T, "the last parameter");
        same(T, last, from_int(1));
        about(T, "the first point and the last");
        same(T, points.at[0], P[0]);
        same(T, points.at[steps], P[3]);
    }
}
#endif

#include "chapters/judge/claims_off.h"
