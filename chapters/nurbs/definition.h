/* definition.h -- what B-splines are, as directly as it can be written: the other side of the claims.
 *
 * Which knots coincide is a pattern, a string of multiplicities: "3112" means x_0, x_0, x_0, x_1, x_2, x_3, x_3 with
 * x_0 < x_1 < x_2 < x_3.  place[i] says which of the distinct values knot i has, so that everything which depends on the
 * order of knots depends on integers: the text runs in the field with the x_i as variables.  An interval is named by
 * the number of the distinct knot at its left end.  Nothing here uses a kernel. */
#include "chapters/judge/claims_on.h"

enum { MOST_KNOTS = 48 };

/* Fills the distinct knots x_0 < x_1 < ... and from them u and place; returns how many knots the pattern has.  In the
 * field the x_i are variables. */
static inline int G(knots_of_pattern)(trial *T, const char *pattern, num u[], int place[])
{
    int count = 0;
    num x = unknown(T, "x", 0);
    for (int i = 0; pattern[i] != '\0'; i++) {
#if FIELD
        x = unknown(T, "x", i);
#else
        x = i > 0 ? add(x, positive(T, "h", i)) : x;
#endif
        for (int times = pattern[i] - '0'; times > 0; times--, count++) {
            u[count] = x;
            place[count] = i;
        }
    }
    return count;
}

/* In the field above degree `highest`: the knots 0, 1, 3, 6, 10, ... in the place of the variables. */
static inline void G(numbers_above)(int highest, int p, int count, const int place[], num u[])
{
    for (int i = 0; FIELD && p > highest && i < count; i++)
        u[i] = from_int(place[i] * (place[i] + 1) / 2);
}

/* The span of an interval: the last knot at its left end. */
static inline int G(span_of_interval)(int count, const int place[], int interval)
{
    int mu = -1;
    for (int i = 0; i < count; i++)
        if (place[i] <= interval)
            mu = i;
    return mu;
}

/* N_{i,p}(t) for t in an interval, by the recursion of de Boor and Cox as it is defined, 0/0 being 0:
 *     N_{i,0} = 1 on [u_i, u_{i+1}) and 0 elsewhere,
 *     N_{i,p} = (t - u_i)/(u_{i+p} - u_i) N_{i,p-1} + (u_{i+p+1} - t)/(u_{i+p+1} - u_{i+1}) N_{i+1,p-1}. */
static inline num G(cox_de_boor)(int p, const num u[], const int place[], int i, int interval, num t)
{
    num N[MAX_DEGREE + 1]; /* N[m] is N_{i+m,q}(t); every value is computed once, and none whose both parts are 0 */
    int some[MAX_DEGREE + 1];
    for (int m = 0; m <= p; m++) {
        some[m] = place[i + m] <= interval && interval < place[i + m + 1];
        N[m] = from_int(some[m]);
    }
    for (int q = 1; q <= p; q++)
        for (int m = 0; m <= p - q; m++) {
            int first = i + m, last = first + q;
            int from_left = some[m] && place[first] < place[last];
            int from_right = some[m + 1] && place[first + 1] < place[last + 1];
            num value = from_int(0);
            if (from_left)
                value = mul(div(sub(t, u[first]), sub(u[last], u[first])), N[m]);
            if (from_right)
                value = add(value, mul(div(sub(u[last + 1], t), sub(u[last + 1], u[first + 1])), N[m + 1]));
            N[m] = value;
            some[m] = from_left || from_right;
        }
    return N[0];
}

/* Coordinate c of s(t) = sum_{i=0}^{n-1} c_i N_{i,p}(t) for t in an interval: all n terms, none left out. */
static inline num G(spline_value)(int n, int p, int dim, const num u[], const int place[], const num points[], int c,
                                  int interval, num t)
{
    num sum = from_int(0);
    for (int i = 0; i < n; i++)
        sum = add(sum, mul(points[i * dim + c], G(cox_de_boor)(p, u, place, i, interval, t)));
    return sum;
}

#if FIELD || RATIONAL
/* The knots of that name in the block, with their places: the number of the distinct value, from 0. */
static inline void G(given_knots)(trial *T, const char *name, int count, num u[], int place[])
{
    given_points(T, name, count, 1, u);
    for (int i = 0; i < count; i++)
        place[i] = i == 0 ? 0 : place[i - 1] + !G(equal)(u[i], u[i - 1]);
}
#endif

#if RATIONAL
/* The interval that begins at t or contains it: the place of the last knot that is not greater than t; -1 if there is none. */
static inline int G(interval_after)(int count, const num u[], const int place[], num t)
{
    int interval = -1;
    for (int i = 0; i < count && compare_q(u[i], t) <= 0; i++)
        interval = place[i];
    return interval;
}

/* The interval that ends in t or contains it: the place of the last knot less than t; -1 if there is none. */
static inline int G(interval_before)(int count, const num u[], const int place[], num t)
{
    int interval = -1;
    for (int i = 0; i < count && compare_q(u[i], t) < 0; i++)
        interval = place[i];
    return interval;
}
#endif
#include "chapters/judge/claims_off.h"
