/* patterns.h -- knots of every pattern of multiplicities, by program, and B-splines as polynomials of an interval.
 *
 * The places of definition.h are doubled here: an existing knot has an even place, and an odd place is free for a knot
 * that is put into the interval on its left.  An interval is named by the place at its left end, so that everything of
 * definition.h works unchanged.  Nothing here uses a kernel.  Included after definition.h. */
#include "chapters/judge/elementary.h"

#include "chapters/judge/claims_on.h"

enum { HIGHEST = 16 }; /* degree */
enum { LENGTHS = 1, INTEGERS };

/* A knot vector (节点矢量) of n points of degree p: which of the count = n+p+1 knots are equal is known by their places.  A
 * curve over it is made in the call by over(&K, dim, c). */
struct G(knot_vector) {
    int kind; /* 0: all distinct knots are variables of the field for p <= 4.  LENGTHS: the knots are x_0, x_0 + h_1,
                        x_0 + h_1 + h_2, ... with positive variables h, for statements about signs, which are read off
                        coefficients.  INTEGERS: they are 0, 1, 3, 6, 10, ..., for higher degrees                  */
    int p, n, count;
    num u[MOST_KNOTS];
    int place[MOST_KNOTS];
};

/* The spline over the knot vector K of the points c of dim coordinates. */
#define over(K, dim, c) spline((K)->p, (K)->n, (dim), (K)->u, (c))

/* The kind of knots that K has in degree p: in the field INTEGERS in the place of variables for p > 4. */
static inline int G(kind_for)(const struct G(knot_vector) * K, int p)
{
    return FIELD && p > 4 && K->kind == 0 ? INTEGERS : K->kind;
}

/* Fills K from a pattern; returns whether it is good for degree p: no multiplicity above p+1, and a domain. */
static inline int G(knots_good)(trial *T, int p, const char *pattern, struct G(knot_vector) * K)
{
    int kind = G(kind_for)(K, p);
    K->p = p;
    if (kind == LENGTHS || kind == INTEGERS) {
        num x = kind == LENGTHS ? unknown(T, "x", 0) : from_int(0);
        K->count = 0;
        for (int i = 0; pattern[i] != '\0'; i++) {
            if (i > 0)
                x = add(x, kind == LENGTHS ? positive(T, "h", i) : from_int(i));
            for (int times = pattern[i] - '0'; times > 0; times--, K->count++)
                K->u[K->count] = x, K->place[K->count] = i;
        }
    } else {
        K->count = G(knots_of_pattern)(T, pattern, K->u, K->place);
    }
    K->n = K->count - p - 1;
    for (int i = 0; i < K->count; i++)
        K->place[i] *= 2;
    if (K->n <= p || K->place[p] >= K->place[K->n])
        return 0;
    for (int i = 0; i < K->n; i++)
        if (K->place[i] == K->place[i + p + 1])
            return 0;
    return 1;
}

/* Pattern `bits` of the 2^{count-1} patterns of count knots: knot i+1 differs from knot i if bit i is set. */
static inline void G(pattern_of_bits)(int count, int bits, char pattern[])
{
    int length = 0;
    pattern[0] = '1';
    for (int i = 0; i + 1 < count; i++)
        if (bits >> i & 1)
            pattern[++length] = '1';
        else
            pattern[length]++;
    pattern[length + 1] = '\0';
}

/* The pattern with which a loop goes on after k: in the field the next one, so that all are met; where random instances are
 * taken anyway, a random one of the next ones. */
static inline int G(next_pattern)(trial *T, int p, int k)
{
#if FIELD
    (void)T, (void)p;
    return k;
#else
    return k == 0 ? pick(T, 0, p / 2) : k + (p > 0 ? pick(T, 6, 30) : 0);
#endif
}

/* One segment of degree p, n = p+1, whose only interval is [u_p, u_{p+1}].  It depends on the p knots on either side of the
 * interval; u_0 and u_{2p+1} belong to factors of B-splines of lower degree that vanish there.  Pattern number k.  For
 * p <= 3 all 4^{p-1} patterns of those 2p knots, the outer two being others, except that the first pattern has clamped
 * ends; for p > 3 simple knots, clamped ends, and every multiplicity j of u_p with p+2-j of u_{p+1}, the other knots simple.
 * Returns the number of the next pattern, 0 after the last.  The loop over all of them:
 *     for (int k = G(segment_knots)(T, p, 0, &K); k > 0; k = G(segment_knots)(T, p, k, &K))                     */
static inline int G(segment_knots)(trial *T, int p, int k, struct G(knot_vector) * K)
{
    char pattern[MOST_KNOTS];
    k = G(next_pattern)(T, p, k);
    if (p <= 3) {
        int side = p > 0 ? p - 1 : 0, left = k & ((1 << side) - 1), right = k >> side, outer = k > 0;
        if (k >= 1 << 2 * side)
            return 0;
        if (p == 0)
            G(pattern_of_bits)(2, 1, pattern);
        else
            G(pattern_of_bits)(2 * p + 2, outer | left << 1 | 1 << p | right << (p + 1) | outer << 2 * p, pattern);
    } else {
        int left = k <= p ? k + 1 : k == p + 1 ? 1 : p + 1, right = k <= p ? p + 1 - k : left, at = 0;
        if (k > p + 2)
            return 0;
        for (int i = 0; i < p + 1 - left; i++)
            pattern[at++] = '1';
        pattern[at++] = (char)('0' + left);
        pattern[at++] = (char)('0' + right);
        for (int i = 0; i < p + 1 - right; i++)
            pattern[at++] = '1';
        pattern[at] = '\0';
    }
    (void)G(knots_good)(T, p, pattern, K);
    return k + 1;
}

/* Several segments: an inner knot of every multiplicity 0, ..., p+1 between ends that are simple, clamped, and clamped and
 * double; for p <= 2 then also all patterns of 2p+3 knots that are good for degree p.  Over integers
 * only simple and clamped ends.  Used as segment_knots. */
static inline int G(several_knots)(trial *T, int p, int k, struct G(knot_vector) * K)
{
    char pattern[MOST_KNOTS];
    k = G(next_pattern)(T, p, k);
    int inner = (k + 1) % (p + 2), ends = k / (p + 2), at = 0;
    if (G(kind_for)(K, p) == INTEGERS && ends > 1)
        return 0;
    if (ends > 2) {
        for (int bits = k - 3 * (p + 2); p <= 2 && bits < 1 << (2 * p + 2); bits++) {
            G(pattern_of_bits)(2 * p + 3, bits, pattern);
            if (G(knots_good)(T, p, pattern, K))
                return 3 * (p + 2) + bits + 1;
        }
        return 0;
    }
    if (ends == 0)
        for (int i = 0; i <= p; i++)
            pattern[at++] = '1';
    else
        pattern[at++] = (char)('1' + p);
    if (inner > 0)
        pattern[at++] = (char)('0' + inner);
    if (ends == 1)
        pattern[at++] = (char)('1' + p);
    else
        for (int i = 0, two = ends == 2 && p > 0; i <= p; i += 1 + two, two = 0)
            pattern[at++] = (char)('1' + two);
    pattern[at] = '\0';
    (void)G(knots_good)(T, p, pattern, K);
    return k + 1;
}

/* N[i(p+1) + k]: the coefficient of (t-a)^k in the polynomial that N_{i,p} is on an interval, i = 0, ..., count-p-2.
 * The recursion of de Boor and Cox, 0/0 being 0, with polynomials in the place of values, for every index.  What is 0
 * because both of its parts are is not computed: some[i] says that N_i is not. */
static inline void G(basis_powers)(int p, int count, const num u[], const int place[], int interval, num a, num N[])
{
    num next[HIGHEST + 1], zero = from_int(0), one = from_int(1);
    int some[MOST_KNOTS];
    for (int i = 0; i + 1 < count; i++) {
        some[i] = place[i] <= interval && interval < place[i + 1];
        for (int k = 0; k <= p; k++)
            N[i * (p + 1) + k] = k == 0 && some[i] ? one : zero;
    }
    for (int q = 1; q <= p; q++)
        for (int i = 0; i + q + 1 < count; i++) {
            const num *left = N + i * (p + 1), *right = left + p + 1;
            int from_left = some[i] && place[i] < place[i + q];
            int from_right = some[i + 1] && place[i + 1] < place[i + q + 1];
            some[i] = from_left || from_right;
            for (int k = 0; k <= q; k++)
                next[k] = zero;
            if (from_left) { /* (t - u_i) / (u_{i+q} - u_i) times N_{i,q-1} */
                num length = sub(u[i + q], u[i]), distance = sub(a, u[i]);
                for (int k = 0; k <= q; k++)
                    next[k] = div(add(mul(distance, left[k]), k > 0 ? left[k - 1] : zero), length);
            }
            if (from_right) { /* (u_{i+q+1} - t) / (u_{i+q+1} - u_{i+1}) times N_{i+1,q-1} */
                num length = sub(u[i + q + 1], u[i + 1]), distance = sub(u[i + q + 1], a);
                for (int k = 0; k <= q; k++)
                    next[k] = add(next[k], div(sub(mul(distance, right[k]), k > 0 ? right[k - 1] : zero), length));
            }
            for (int k = 0; k <= q; k++)
                N[i * (p + 1) + k] = next[k];
        }
}

/* s[k]: the coefficient of (t-a)^k of coordinate c of the spline of the points on an interval: all n terms. */
static inline void G(spline_powers)(int n, int p, int dim, const num u[], const int place[], const num points[], int c,
                                    int interval, num a, num s[])
{
    num N[MOST_KNOTS * (HIGHEST + 1)];
    G(basis_powers)(p, n + p + 1, u, place, interval, a, N);
    for (int k = 0; k <= p; k++) {
        s[k] = from_int(0);
        for (int i = 0; i < n; i++)
            s[k] = add(s[k], mul(points[i * dim + c], N[i * (p + 1) + k]));
    }
}

/* r! times the coefficient of (t-a)^r: the r-th derivative at a; 0 for r > p. */
static inline num G(derivative_of_powers)(int p, const num s[], int r)
{
    num value = r > p ? from_int(0) : s[r];
    for (int k = 2; k <= r; k++)
        value = mul(from_int(k), value);
    return value;
}

/* sum_k s_k (t-a)^k */
static inline num G(value_of_powers)(int p, const num s[], num a, num t)
{
    num sum = s[p];
    for (int k = p - 1; k >= 0; k--)
        sum = add(mul(sum, sub(t, a)), s[k]);
    return sum;
}

/* The polar form of sum_k s_k (t-a)^k as a polynomial of degree p: sum_k s_k e_k/C(p,k), e_k being the elementary
 * symmetric polynomials of x_0 - a, ..., x_{p-1} - a. */
static inline num G(polar_of_powers)(int p, const num s[], num a, const num x[])
{
    num e[HIGHEST + 1], sum = s[0], choose = from_int(1);
    for (int k = 0; k <= p; k++)
        e[k] = from_int(k == 0);
    for (int i = 0; i < p; i++)
        for (int k = i + 1; k > 0; k--)
            e[k] = add(e[k], mul(sub(x[i], a), e[k - 1]));
    for (int k = 1; k <= p; k++) {
        choose = mul(choose, from_ratio(p + 1 - k, k));
        sum = add(sum, div(mul(s[k], e[k]), choose));
    }
    return sum;
}

/* n points of dim <= 3 coordinates, every one free. */
static inline void G(free_control_points)(trial *T, int n, int dim, num c[])
{
    static const char *const name[] = {"y", "z", "w"};
    for (int i = 0; i < n; i++)
        for (int k = 0; k < dim; k++)
            c[i * dim + k] = unknown(T, name[k], i);
}

/* L: the knots of K and one more, x, at a place; an odd place is the interval on its left.  L may be K. */
static inline void G(put_knot)(const struct G(knot_vector) * K, int place, num x, struct G(knot_vector) * L)
{
    struct G(knot_vector) old = *K;
    int at = 0;
    while (at < old.count && old.place[at] <= place)
        at++;
    *L = old;
    L->n++;
    L->count++;
    for (int i = at; i < L->count; i++) {
        L->u[i] = i == at ? x : old.u[i - 1];
        L->place[i] = i == at ? place : old.place[i - 1];
    }
}

/* A number of the interval of a span: in the field a variable, which may be any number. */
static inline num G(in_interval)(trial *T, const struct G(knot_vector) * K, int mu, const char *name)
{
#if FIELD
    (void)K, (void)mu;
    return parameter(T, name);
#else
    return add(K->u[mu], mul(inside(T, name), sub(K->u[mu + 1], K->u[mu])));
#endif
}

/* A knot for a place: in an interval a number of it, elsewhere the knot that is there. */
static inline num G(knot_for)(trial *T, const struct G(knot_vector) * K, int place, const char *name)
{
    int mu = G(span_of_interval)(K->count, K->place, place);
    return place % 2 == 0 ? K->u[mu] : G(in_interval)(T, K, mu, name);
}

/* How many knots have this place. */
static inline int G(multiplicity_at)(const struct G(knot_vector) * K, int place)
{
    int many = 0;
    for (int i = 0; i < K->count; i++)
        many += K->place[i] == place;
    return many;
}

/* For each of the m points of degree q over v, a span of K that contains a non-empty interval [v_l, v_{l+1}] of the domain,
 * j <= l <= j+q: for the first such l, or for the last.  Returns whether every point has one. */
static inline int G(spans_over)(const struct G(knot_vector) * K, int m, int q, const int place[], int last, int span[])
{
    for (int j = 0; j < m; j++) {
        int found = 0;
        for (int l = j > q ? j : q; l <= j + q && l < m; l++)
            if (place[l] < place[l + 1] && (last || !found)) {
                span[j] = G(span_of_interval)(K->count, K->place, place[l]);
                found = 1;
            }
        if (!found)
            return 0;
    }
    return 1;
}

/* Compare: the spline of the points d over L, of degree q >= p, is the spline of the free points c over K, of degree p, on
 * every interval of L in its domain: their coefficients in powers of t minus the knot on the left.  In the field the c are
 * variables, and the comparison is made for the coefficient of each of them, after d was seen to be linear in them. */
static inline void G(same_spline)(trial *T, int dim, const struct G(knot_vector) * K, const num c[],
                                  const struct G(knot_vector) * L, const num d[])
{
    int p = K->p, q = L->p;
    num N[MOST_KNOTS * (HIGHEST + 1)], M[MOST_KNOTS * (HIGHEST + 1)];
#if FIELD
    num share[MOST_KNOTS * MOST_KNOTS];
    for (int j = 0; j < L->n; j++)
        for (int e = 0; e < dim; e++) {
            num sum = from_int(0);
            for (int i = 0; i < K->n; i++) {
                num part = derivative_f(d[j * dim + e], c[i * dim + e]);
                if (e == 0)
                    share[j * K->n + i] = part;
                same(T, part, share[j * K->n + i]);
                sum = add(sum, mul(part, c[i * dim + e]));
            }
            same(T, d[j * dim + e], sum);
        }
#endif
    for (int mu = q; mu < L->n; mu++) {
        int interval = L->place[mu];
        if (interval == L->place[mu + 1])
            continue;
        G(basis_powers)(p, K->count, K->u, K->place, interval, L->u[mu], N);
        G(basis_powers)(q, L->count, L->u, L->place, interval, L->u[mu], M);
#if FIELD
        for (int i = 0; i < K->n; i++)
            for (int r = 0; r <= q; r++) {
                num sum = from_int(0);
                for (int j = 0; j < L->n; j++)
                    if (!is_zero_f(share[j * K->n + i]))
                        sum = add(sum, mul(share[j * K->n + i], M[j * (q + 1) + r]));
                same(T, sum, r <= p ? N[i * (p + 1) + r] : from_int(0));
            }
#else
        for (int e = 0; e < dim; e++)
            for (int r = 0; r <= q; r++) {
                num before = from_int(0), after = before;
                for (int i = 0; i < K->n && r <= p; i++)
                    before = add(before, mul(c[i * dim + e], N[i * (p + 1) + r]));
                for (int j = 0; j < L->n; j++)
                    after = add(after, mul(d[j * dim + e], M[j * (q + 1) + r]));
                same(T, after, before);
            }
#endif
    }
}
#include "chapters/judge/claims_off.h"
