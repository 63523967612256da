/* judge_bodies.tmpl.h -- bodies of hand-made claims, once for each number type. */
#include "chapters/judge/claims_on.h"

/* (x+y)^2 = x^2 + 2 x y + y^2; the fault is 3 for 2. */
static inline void G(square_of_sum)(trial *T)
{
    num x = unknown(T, "x", 0), y = unknown(T, "y", 0), s = add(x, y);
    num middle = mul(from_int(T->planted ? 3 : 2), mul(x, y));
    show(T, "x", x);
    same(T, mul(s, s), add(add(mul(x, x), middle), mul(y, y)));
}

/* (1+t)^n by multiplication and by recursion: visits its degree. */
static inline void G(power_of_degree)(trial *T)
{
    num t = parameter(T, "t"), a = add(from_int(1), t), p = from_int(1), q = from_int(1);
    for (int k = 0; k < T->degree; k++) {
        p = mul(p, a);
        q = add(q, mul(t, q));
    }
    same(T, T->planted ? add(p, t) : p, q);
}

/* False: x + 1 = x. */
static inline void G(one_is_zero)(trial *T)
{
    num x = unknown(T, "x", 0);
    about(T, "x + 1 and x");
    same(T, add(x, from_int(1)), x);
    about(T, "x + 2 and x");
    same(T, add(x, from_int(2)), x);
}

/* 1 = 2, unless planted: what a counterexample shows, with a control that holds. */
static inline void G(one_is_two)(trial *T) { same(T, from_int(1), from_int(T->planted ? 1 : 2)); }

static inline void G(nothing)(trial *T) { (void)T; }

static inline void G(control_passes)(trial *T)
{
    num x = unknown(T, "x", 0);
    same(T, x, x);
}

/* Holds; the control compares nothing. */
static inline void G(control_is_empty)(trial *T)
{
    if (!T->planted)
        agree(T, 1);
}

/* Holds; the control divides by zero and is wrong besides. */
static inline void G(control_divides_by_zero)(trial *T)
{
    if (T->planted)
        (void)div(from_int(1), from_int(0));
    agree(T, !T->planted);
}

static inline void G(divides_by_zero)(trial *T)
{
    agree(T, !T->planted);
    (void)div(from_int(1), sub(from_int(2), from_int(2)));
}

/* Planted: 0 = 0.  Otherwise 1/0, and a comparison that holds. */
static inline void G(fails_by_division_only)(trial *T)
{
    if (!T->planted)
        (void)div(from_int(1), from_int(0));
    agree(T, 1);
}

/* Two comparisons after the fault. */
static inline void G(unable)(trial *T)
{
    region_faults |= FAULT_UNABLE;
    same(T, from_int(1), from_int(2));
    agree(T, !T->planted);
}

/* 1 = 2; the control is unable to say anything. */
static inline void G(control_is_unable)(trial *T)
{
    if (T->planted)
        region_faults |= FAULT_UNABLE;
    same(T, from_int(1), from_int(2));
}

/* False before the fault. */
static inline void G(false_then_unable)(trial *T)
{
    agree(T, 0);
    region_faults |= FAULT_UNABLE;
}

/* Sum of count variables minus themselves; shows before it grows crowded. */
static inline void G(cancel)(trial *T, int count)
{
    num sum = from_int(0);
    show_text(T, "count", "%d", count);
    for (int k = 0; k < count; k++)
        sum = add(sum, unknown(T, "x", k));
    for (int k = 0; k < count; k++)
        sum = sub(sum, unknown(T, "x", k));
    (void)sum;
#if FIELD
    same(T, T->planted ? from_int(1) : sum, from_int(0));
#else
    agree(T, !T->planted);
#endif
}
static inline void G(forty_variables)(trial *T) { G(cancel)(T, 40); }
static inline void G(too_many_variables)(trial *T) { G(cancel)(T, FIELD_MAX_VARIABLES + 1); }

/* As many variables as the degree, x_0 taken to be positive: in degree 3 numbers stand in their places. */
static inline void G(numbers_above_two)(trial *T)
{
    num sum = from_int(1), first = T->degree > 2 ? from_int(1) : positive(T, "x", 0);
    for (int k = 1; k < T->degree && T->degree <= 2; k++)
        sum = add(sum, unknown(T, "y", k));
    nonnegative(T, T->planted ? neg(first) : first);
    same(T, sub(sum, sum), from_int(0));
}

/* a + w/(1+w) s, of one sign; planted: its negative */
static inline void G(positive_sum)(trial *T)
{
    num a = unknown(T, "a", 0), w = positive(T, "w", 3), t = parameter(T, "t");
    same(T, mul(a, t), mul(t, a));
    num value = add(inside(T, "s"), div(w, add(from_int(1), w)));
    nonnegative(T, T->planted ? neg(value) : value);
    nonnegative(T, from_int(0));
}

/* w - 1/1024, of either sign in the field; w >= 1/8 elsewhere */
static inline void G(sign_is_open)(trial *T)
{
    num w = positive(T, "w", 0);
    nonnegative(T, sub(w, from_ratio(T->planted ? 8 : 1, T->planted ? 1 : 1024)));
}

static inline void G(exhibits)(trial *T)
{
    num R[] = {from_int(1), from_ratio(1, 2), from_int(-3), from_ratio(3, 4)};
    show(T, "half", R[1]);
    show_points(T, "R", 2, 2, R);
    show_points(T, "w", 3, 1, R);
    show_text(T, "words", "%s %d", "number", 7);
    agree(T, !T->planted);
}
#include "chapters/judge/claims_off.h"
