/* convexity.h -- what the three sections on the convexity of NURBS curves share: knots, points and weights with the
 * indices of the source, from 1, their places, and the curves that are tried.  Generic text, and for rationals decisions. */
#include "chapters/nurbs/corner-cutting.h"
#include "chapters/nurbs/definition.h"

#include <stdio.h>
#include <string.h>

#if RATIONAL
#include "exact/record/hull.h"
#include "exact/record/polynomial.h"
#include "exact/record/sign.h"
#endif

#include "chapters/judge/claims_on.h"

enum { MOST_POINTS = 40, MOST_COORDINATES = 3 * (MOST_POINTS + 1) };

/* The knots of a pattern, numbered from 1: t, and place with four times the number of the distinct knot, so that new
 * knots inside interval j have the places 4j+1, 4j+2, 4j+3. */
struct G(knot_vector) {
    int count, place[MOST_KNOTS];
    num t[MOST_KNOTS];
};

static inline struct G(knot_vector) G(pattern)(trial *T, const char *pattern)
{
    struct G(knot_vector) K;
    K.count = G(knots_of_pattern)(T, pattern, K.t + 1, K.place + 1);
    for (int i = 1; i <= K.count; i++)
        K.place[i] *= 4;
    return K;
}

/* In the field above order 5: 0, 1, 3, 6, 10, ... in the place of the variables; places are multiples of 4. */
static inline void G(numbers_for_knots)(int k, struct G(knot_vector) * K)
{
    for (int i = 1; FIELD && k > 5 && i <= K->count; i++)
        K->t[i] = from_int(K->place[i] / 4 * (K->place[i] / 4 + 1) / 2);
}

/* Patterns of knots, numbered from 0: 2k+1 simple knots; both ends k-fold, and an m-fold knot between, m = 1, ..., k; up to order
 * ALL_PATTERNS then all of 2k+1 knots, no one more than k-fold, with t_k < t_{n+1}.  Returns the next number; 0 when there is no
 * pattern of this number. */
enum { ALL_PATTERNS = 4 };
static inline int G(pattern_of_insertion)(int k, int number, char pattern[MOST_KNOTS])
{
    int all = 1 << 2 * k;
    if (number > 0 && number <= k) {
        snprintf(pattern, MOST_KNOTS, "%d%d%d", k, number, k);
        return number + 1;
    }
    /* bit i: whether knot i+2 differs from knot i+1 */
    for (int bits = number == 0 ? all - 1 : number - k - 1; bits < all && (number == 0 || k <= ALL_PATTERNS); bits++) {
        int at = 0, most = '1';
        memset(pattern, 0, MOST_KNOTS);
        pattern[0] = '1';
        for (int i = 0; i < 2 * k; i++) {
            at += bits >> i & 1;
            pattern[at] = (char)(pattern[at] == 0 ? '1' : pattern[at] + 1);
            most = pattern[at] > most ? pattern[at] : most;
        }
        if (most <= '0' + k && (bits >> (k - 1) & 3) != 0)
            return number == 0 ? 1 : bits + k + 2;
    }
    return 0;
}

/* mu with t_mu < tau <= t_{mu+1}, and 0 if tau <= t_1. */
static inline int G(left_of)(const struct G(knot_vector) * K, int place)
{
    int mu = 0;
    while (mu < K->count && K->place[mu + 1] < place)
        mu++;
    return mu;
}

/* The knot at a place that has one; else a number of the interval, every name another number.  What is proved about two
 * numbers of one interval is an identity, so that their order does not matter to it. */
static inline num G(number_at)(trial *T, const struct G(knot_vector) * K, int place, const char *name)
{
    for (int i = 1; i <= K->count; i++)
        if (K->place[i] == place)
            return K->t[i];
#if FIELD
    return parameter(T, name);
#else
    int mu = G(left_of)(K, place);
    num share = inside(T, name);
    return add(K->t[mu], mul(share, sub(K->t[mu + 1], K->t[mu])));
#endif
}

/* The printed insertion of the number at a place, with that place. */
static inline void G(insert_at)(int n, int k, int dim, const struct G(knot_vector) * K, int place, num tau,
                                const num r[], const num w[], struct G(knot_vector) * V, num S[], num z[])
{
    int mu = G(left_of)(K, place);
    V->count = K->count + 1;
    for (int i = 1; i <= V->count; i++)
        V->place[i] = i <= mu ? K->place[i] : i == mu + 1 ? place : K->place[i - 1];
    G(printed_insertion)(n, k, dim, K->t, mu, tau, r, w, V->t, S, z);
}

static inline void G(equal_weights)(int n, num w[])
{
    for (int i = 1; i <= n; i++)
        w[i] = from_int(1);
}

#if RATIONAL
/* R: the n points of the plane with whole coordinates. */
static inline void points_of(int n, const long point[], num_q R[])
{
    for (int i = 0; i < 2 * n; i++)
        R[i] = from_int_q(point[i]);
}

/* mu with t_mu < tau <= t_{mu+1}, and 0 if tau <= t_1. */
static inline int place_of(int count, const num_q t[], num_q tau)
{
    int mu = 0;
    while (mu < count && compare_q(t[mu + 1], tau) < 0)
        mu++;
    return mu;
}

/* The span, counted from 0, of a parameter of the domain t_k, ..., t_{n+1}. */
static inline int span_of(int n, int k, const num_q t[], num_q x)
{
    int j = k;
    while (j < n && (compare_q(t[j + 1], x) <= 0 || compare_q(t[j], t[j + 1]) == 0))
        j++;
    return j - 1;
}

/* The knots T, points r and weights w of the block, numbered from 1. */
static inline void given_curve(trial *T, int n, int k, num_q t[], num_q r[], num_q w[])
{
    given_points_q(T, "T", n + k, 1, t + 1);
    given_points_q(T, "r", n, 2, r + 2);
    given_points_q(T, "w", n, 1, w + 1);
}

/* Curves with convex polygons, counterclockwise. */
static const struct {
    int k, n;
    long point[2 * 7], knot[11];
} convex_curve[] = {
    {2, 4, {0, 0, 1, 0, 1, 1, 0, 1}, {0, 0, 1, 2, 3, 3}},
    {3, 4, {0, 0, 2, 0, 1, 2, 0, 0}, {0, 0, 0, 1, 2, 2, 2}},
    {3, 5, {0, 0, 3, 0, 4, 2, 2, 4, 0, 2}, {0, 1, 2, 3, 4, 5, 6, 7}},
    {3, 5, {0, 0, 3, 0, 4, 2, 2, 4, 0, 2}, {0, 0, 0, 1, 1, 3, 3, 3}},
    {4, 5, {0, 0, 4, 0, 5, 3, 2, 5, 0, 1}, {0, 1, 2, 4, 5, 6, 8, 9, 10}},
    {4, 6, {0, 0, 2, 0, 4, 0, 4, 0, 4, 3, 0, 4}, {0, 0, 0, 0, 1, 2, 3, 3, 3, 3}},
    {4, 7, {1, 0, 3, 0, 5, 1, 6, 3, 5, 5, 3, 6, 1, 5}, {0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2}},
};
enum { CONVEX_CURVES = sizeof convex_curve / sizeof *convex_curve, WEIGHTS = 4 };

/* Weight i, from 1: all equal, in turn, growing, small inside. */
static inline num_q family_weight(int family, int n, int i)
{
    long power = 1;
    for (int j = 1; j < i; j++)
        power *= 10;
    num_q weight[WEIGHTS] = {from_int_q(1), from_int_q(i % 2 == 1 ? 1000 : 1), from_int_q(power),
                             from_ratio_q(1, i == 1 || i == n ? 1 : 1000)};
    return weight[family];
}

/* Curve number `example` with the weights of a family: knots t, points r and weights w, numbered from 1. */
static inline void designed_curve_of(int example, int family, num_q t[], num_q r[], num_q w[])
{
    int n = convex_curve[example].n, k = convex_curve[example].k;
    points_of(n, convex_curve[example].point, r + 2);
    for (int i = 1; i <= n; i++)
        w[i] = family_weight(family, n, i);
    for (int i = 1; i <= n + k; i++)
        t[i] = from_int_q(convex_curve[example].knot[i - 1]);
}
#endif

#include "chapters/judge/claims_off.h"
