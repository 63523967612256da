/* discrete.h -- knots over one list of values, NURBS curves and discrete B-splines as they are defined.
 *
 * Stands after definition.h.  Two knot vectors, of which one refines the other, are patterns over the same
 * distinct values x_0 < x_1 < ...: "30103" are the knots x_0, x_0, x_0, x_2, x_4, x_4, x_4, and "01010" are x_1 and x_3.
 * Their sum, digit by digit, is the union with multiplicities, T + T'.  Places are numbers of these
 * values, so that places of knots of different vectors can be compared.  Nothing here uses a kernel. */
#include <string.h>

#include "chapters/judge/elementary.h"

#include "chapters/judge/claims_on.h"

/* The distinct values of a pattern: increasing numbers; in the field variables for the degrees up to `highest`, and the
 * numbers 0, 1, 3, 6, 10, ... above. */
static inline void G(distinct_knots)(trial *T, int count, int highest, num x[])
{
    int numbers = FIELD && T->degree > highest;
    x[0] = numbers ? from_int(0) : unknown(T, "x", 0);
    for (int i = 1; i < count; i++)
        if (numbers)
            x[i] = from_int(i * (i + 1) / 2);
        else
            x[i] = FIELD ? unknown(T, "x", i) : add(x[i - 1], positive(T, "h", i));
}

/* Simple knots, of which each is one distinct value. */
static inline void G(simple_knots)(trial *T, int count, int highest, num u[], int place[])
{
    G(distinct_knots)(T, count, highest, u);
    for (int i = 0; i < count; i++)
        place[i] = i;
}

/* Such knots as sums of positive gaps h_1, h_2, ... from x_0 = 0, so that a sign can be read off; B-splines depend on
 * differences of knots and parameter alone.  In the field the gaps are variables for the degrees up to `highest`, and
 * 1, 2, 3, ... above. */
static inline void G(increasing_knots)(trial *T, int count, int highest, num x[])
{
    x[0] = from_int(0);
    for (int i = 1; i < count; i++)
        x[i] = add(x[i - 1], FIELD && T->degree > highest ? from_int(i) : positive(T, "h", i));
}

/* The knots of a pattern over the values x, and their places; returns how many there are. */
static inline int G(knots_at)(const char *pattern, const num x[], num u[], int place[])
{
    int count = 0;
    for (int i = 0; pattern[i] != '\0'; i++)
        for (int times = pattern[i] - '0'; times > 0; times--, count++) {
            u[count] = x[i];
            place[count] = i;
        }
    return count;
}

/* The pattern of the union with multiplicities (T ⊕ T'). */
static inline void G(union_of_patterns)(const char *a, const char *b, char sum[])
{
    int i = 0;
    for (; a[i] != '\0'; i++)
        sum[i] = (char)(a[i] + b[i] - '0');
    sum[i] = '\0';
}

/* Knots u of n points, count of them, and their refinement v of m points; the distinct values x of both, where a pattern says
 * which occur, and the places of u and v among them. */
struct G(refinement) {
    int n, m, count, place[MOST_KNOTS], at[MOST_KNOTS];
    num x[MOST_KNOTS], u[MOST_KNOTS], v[MOST_KNOTS];
};

/* The refinement of the pattern T by the pattern T', over the values r->x. */
static inline void G(refine_pair)(const char *old, const char *new, int p, struct G(refinement) * r)
{
    char sum[MOST_KNOTS];
    G(union_of_patterns)(old, new, sum);
    r->count = G(knots_at)(old, r->x, r->u, r->place);
    r->n = r->count - p - 1;
    r->m = G(knots_at)(sum, r->x, r->v, r->at) - p - 1;
}

#if RATIONAL
/* The refinement of the knots u, `count` of them, by `more` knots; both are given in increasing order. */
static inline void G(refine_knots)(int p, int count, const num u[], int more, const num added[],
                                   struct G(refinement) * r)
{
    r->count = count, r->n = count - p - 1, r->m = r->n + more;
    for (int i = 0, old = 0, new = 0; i < count + more; i++) {
        int take_new = old == count || (new < more &&compare_q(added[new], u[old]) < 0);
        r->v[i] = take_new ? added[new] : u[old];
        r->at[i] = i == 0 ? 0 : r->at[i - 1] + !equal_q(r->v[i], r->v[i - 1]);
        if (take_new)
            new ++;
        else
            r->u[old] = u[old], r->place[old] = r->at[i], old++;
    }
}

/* The refinement of the knots T of the block, `count` of them, by its `more` knots T'. */
static inline void G(given_refinement)(trial *T, int p, int count, int more, struct G(refinement) * r)
{
    num u[MOST_KNOTS], added[MOST_KNOTS];
    given_points(T, "T", count, 1, u);
    given_points(T, "T'", more, 1, added);
    G(refine_knots)(p, count, u, more, added, r);
}
#endif

/* n points of dim coordinates and n positive weights. */
static inline void G(weighted_points)(trial *T, int n, int dim, num R[], num w[])
{
    static const char *const axis[] = {"a", "b", "c"};
    for (int i = 0; i < n; i++) {
        w[i] = positive(T, "w", i);
        for (int c = 0; c < dim; c++)
            R[i * dim + c] = unknown(T, axis[c], i);
    }
}

/* Formula (4.1.2) with the values N of the B-splines, every term of both sums: out, dim coordinates; returns the
 * denominator. */
static inline num G(nurbs_of_basis)(int n, int dim, const num N[], const num R[], const num w[], num out[])
{
    num total = from_int(0);
    for (int c = 0; c < dim; c++)
        out[c] = from_int(0);
    for (int i = 0; i < n; i++) {
        num share = mul(N[i], w[i]);
        total = add(total, share);
        for (int c = 0; c < dim; c++)
            out[c] = add(out[c], mul(share, R[i * dim + c]));
    }
    for (int c = 0; c < dim; c++)
        out[c] = div(out[c], total);
    return total;
}

/* The same for t in an interval. */
static inline num G(nurbs_by_definition)(int n, int p, int dim, const num u[], const int place[], const num R[],
                                         const num w[], int interval, num t, num out[])
{
    num N[MOST_KNOTS];
    for (int i = 0; i < n; i++)
        N[i] = G(cox_de_boor)(p, u, place, i, interval, t);
    return G(nurbs_of_basis)(n, dim, N, R, w, out);
}

/* The discrete B-spline alpha_{i,p}(j) of the knots u and their refinement v, by its recursion, 0/0 being 0:
 *     alpha_{i,0}(j) = 1 if u_i <= v_j < u_{i+1}, and 0 otherwise,
 *     alpha_{i,p}(j) = (v_{j+p} - u_i)/(u_{i+p} - u_i) alpha_{i,p-1}(j)
 *                    + (u_{i+p+1} - v_{j+p})/(u_{i+p+1} - u_{i+1}) alpha_{i+1,p-1}(j). */
static inline num G(alpha)(int p, const num u[], const int place[], const num v[], const int at[], int i, int j)
{
    num a[MAX_DEGREE + 1]; /* a[m] is alpha_{i+m,q}(j); every value is computed once, and none whose both parts are 0 */
    int some[MAX_DEGREE + 1];
    for (int m = 0; m <= p; m++) {
        some[m] = place[i + m] <= at[j] && at[j] < place[i + m + 1];
        a[m] = from_int(some[m]);
    }
    for (int q = 1; q <= p; q++)
        for (int m = 0; m <= p - q; m++) {
            int first = i + m, last = first + q;
            int from_left = some[m] && place[first] < place[last];
            int from_right = some[m + 1] && place[first + 1] < place[last + 1];
            num value = from_int(0);
            if (from_left)
                value = mul(div(sub(v[j + q], u[first]), sub(u[last], u[first])), a[m]);
            if (from_right)
                value = add(value, mul(div(sub(u[last + 1], v[j + q]), sub(u[last + 1], u[first + 1])), a[m + 1]));
            a[m] = value;
            some[m] = from_left || from_right;
        }
    return a[0];
}

/* Formula (4.1.6): the m points S and weights z over the refinement v of the knots u of n points. */
static inline void G(refined_by_definition)(int n, int p, int dim, const num u[], const int place[], const num R[],
                                            const num w[], int m, const num v[], const int at[], num S[], num z[])
{
    for (int j = 0; j < m; j++) {
        z[j] = from_int(0);
        for (int c = 0; c < dim; c++)
            S[j * dim + c] = from_int(0);
        for (int i = 0; i < n; i++) {
            num share = mul(G(alpha)(p, u, place, v, at, i, j), w[i]);
            z[j] = add(z[j], share);
            for (int c = 0; c < dim; c++)
                S[j * dim + c] = add(S[j * dim + c], mul(share, R[i * dim + c]));
        }
        for (int c = 0; c < dim; c++)
            S[j * dim + c] = div(S[j * dim + c], z[j]);
    }
}
#include "chapters/judge/claims_off.h"
