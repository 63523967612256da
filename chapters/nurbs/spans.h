/* spans.h -- the knots of one span, or of one function, in every order of coincidence, and the B-splines there by definition.
 *
 * The other side of the comparisons in the sections on coefficient matrices.  The notation is the source's: the
 * order k, the span [t_r, t_{r+1}), the functions N_{i,k} of t_i, ..., t_{i+k} with i = r-k+1, ..., r.  The 2k
 * knots that these functions have are numbered from 0, so r = k-1.  A pattern says which of them coincide.  Generic
 * text. */
#include "chapters/nurbs/definition.h"

#include "chapters/judge/elementary.h"

#include "chapters/judge/claims_on.h"

enum { LARGEST_ORDER = 9 };

struct G(span) {
    int k, r;                     /* the order; the span is [t_r, t_{r+1}), r = k-1              */
    num t[2 * LARGEST_ORDER];     /* the knots                                                    */
    int group[2 * LARGEST_ORDER]; /* group[a] = group[b] just when t[a] = t[b]; nondecreasing     */
};

/* a for even n, -a for odd n */
static inline num G(signed_by)(int n, num a) { return n % 2 == 0 ? a : neg(a); }

/* Increasing numbers: variables of the field, which have no order; elsewhere sums of positive data. */
static inline void G(increasing)(trial *T, int count, num x[])
{
    for (int m = 0; m < count; m++)
#if FIELD
        x[m] = unknown(T, "t", m);
#else
        x[m] = m == 0 ? unknown(T, "t", 0) : add(x[m - 1], positive(T, "t", m));
#endif
}

/* How many patterns the 2k knots around a span have: t_r < t_{r+1}, and each other step may be 0 or not. */
static inline int G(patterns)(int k) { return 1 << (2 * k - 2); }

/* The knots of pattern number m, 0 <= m < patterns(k), from the increasing numbers x.  The last pattern has 2k
 * different knots, pattern 0 is that of Bernstein: k knots x_0 and k knots x_1. */
static inline struct G(span) G(span_of_pattern)(int k, int m, const num x[])
{
    struct G(span) S = {.k = k, .r = k - 1};
    S.t[0] = x[0];
    S.group[0] = 0;
    for (int a = 1; a < 2 * k; a++) {
        int grows = a == k;
        if (!grows) {
            grows = m & 1;
            m >>= 1;
        }
        S.group[a] = S.group[a - 1] + grows;
        S.t[a] = x[S.group[a]];
    }
    return S;
}

/* How many patterns a case goes through: all of them up to the given order, else `few`. */
static inline int G(pattern_count)(int k, int all_up_to, int few) { return k <= all_up_to ? G(patterns)(k) : few; }

/* Number m of these patterns.  Beyond the order up to which all are visited the field takes the most and the least
 * coincident one, the other types take random ones. */
static inline int G(which_pattern)(trial *T, int k, int all_up_to, int m)
{
    if (k <= all_up_to)
        return m;
    int last = G(patterns)(k) - 1;
    return FIELD ? (m % 2 == 0 ? last : 0) : pick(T, 0, last);
}

static inline struct G(span) G(simple_span)(trial *T, int k)
{
    num x[2 * LARGEST_ORDER];
    G(increasing)(T, 2 * k, x);
    return G(span_of_pattern)(k, G(patterns)(k) - 1, x);
}

/* N_{i,m}(x) of order m on the span, a polynomial of x, by the definition. */
static inline num G(basis_value)(const struct G(span) * S, int i, int m, num x)
{
    return G(cox_de_boor)(m - 1, S->t, S->group, i, S->group[S->r], x);
}

/* t = t_r + u (t_{r+1} - t_r) */
static inline num G(at_parameter)(const struct G(span) * S, num u)
{
    return add(S->t[S->r], mul(u, sub(S->t[S->r + 1], S->t[S->r])));
}

/* The sum of a_{ji} u^j over the rows j of column c of the k x k matrix A. */
static inline num G(column_value)(int k, const num A[], int c, num u)
{
    num sum = from_int(0);
    for (int j = 0; j < k; j++)
        sum = add(sum, mul(A[j * k + c], G(power)(u, j)));
    return sum;
}

/* c (c-1) ... (c-j+1) x^{c-j}: the j-th derivative of x^c */
static inline num G(power_derivative)(int c, int j, num x)
{
    if (j > c)
        return from_int(0);
    num product = G(power)(x, c - j);
    for (int m = 0; m < j; m++)
        product = mul(product, from_int(c - m));
    return product;
}

/* The matrix H(T; 1, t, ..., t^k) by its definition: for each of the d nodes the rows of the derivatives
 * of order 0, ..., l_i - 1. */
static inline void G(osculation_matrix)(int d, const int l[], int k, const num tau[], num H[])
{
    for (int i = 0, row = 0; i < d; i++)
        for (int j = 0; j < l[i]; j++, row++)
            for (int c = 0; c <= k; c++)
                H[row * (k + 1) + c] = G(power_derivative)(c, j, tau[i]);
}

/* The determinant of an n x n matrix as the sum over all permutations: (-1)^{inversions} times the product. */
static inline num G(leibniz)(int n, int row, unsigned used, const num M[])
{
    if (row == n)
        return from_int(1);
    num sum = from_int(0);
    for (int c = 0, free_before = 0; c < n; c++)
        if (!(used >> c & 1))
            sum = add(sum, G(signed_by)(free_before++, mul(M[row * n + c], G(leibniz)(n, row + 1, used | 1u << c, M))));
    return sum;
}
/* The k+1 knots of one function, pattern m of 2^k, numbered from 0, with the span after group g, so that the span is
 * that of the last knot of group g and i = 0. */
static inline struct G(span) G(span_of_function)(int k, int m, int g, const num x[])
{
    struct G(span) S = {.k = k, .r = 0};
    for (int a = 0, group = 0; a <= k; a++) {
        S.group[a] = group;
        S.t[a] = x[group];
        if (group == g)
            S.r = a;
        group += m >> a & 1;
    }
    return S;
}

/* The knots of one function as nodes: d different ones with multiplicities, and which are right of t_r. */
struct G(nodes) {
    int d, l[LARGEST_ORDER + 1], right[LARGEST_ORDER + 1];
    num tau[LARGEST_ORDER + 1];
};
static inline struct G(nodes) G(nodes_of)(const struct G(span) * S)
{
    struct G(nodes) n = {.d = 0};
    for (int a = 0; a <= S->k; a++) {
        if (a == 0 || S->group[a] != S->group[a - 1]) {
            n.tau[n.d] = S->t[a];
            n.right[n.d] = S->group[a] > S->group[S->r];
            n.l[n.d++] = 0;
        }
        n.l[n.d - 1]++;
    }
    return n;
}

/* The weights (4.4.8), (4.4.9): cofactors of the last column of the matrix of derivatives over the product
 * that is its determinant. */
static inline void G(cofactor_weights)(const struct G(nodes) * n, int k, num alpha[][LARGEST_ORDER + 1])
{
    num H[(LARGEST_ORDER + 1) * (LARGEST_ORDER + 1)];
    G(osculation_matrix)(n->d, n->l, k, n->tau, H);
    num det = G(confluent_vandermonde_determinant)(n->d, n->l, n->tau);
    for (int i = 0, row = 0; i < n->d; i++)
        for (int j = 0; j < n->l[i]; j++, row++)
            alpha[i][j] = div(G(cofactor)(k + 1, H, row, k), det);
}

/* The cases of the claims on columns: all patterns and spans up to the order 5, else a few random patterns. */
static inline int G(function_patterns)(int k) { return k <= (FIELD ? 5 : 3) ? 1 << k : 3; }
static inline int G(function_pattern)(trial *T, int k, int m)
{
    return k <= (FIELD ? 5 : 3) ? m : pick(T, 1, (1 << k) - 1);
}
#include "chapters/judge/claims_off.h"
