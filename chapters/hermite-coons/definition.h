/* definition.h -- polynomials by their coefficients: the other side of this chapter's comparisons.
 *
 * A polynomial is what has coefficients, is added, multiplied and differentiated term by term, and is evaluated by
 * powers.  No kernel is used.  Generic text, for the sections of this chapter. */
#include "chapters/judge/claims_on.h"

enum { MOST_COEFFICIENTS = 24 };

/* c[0] + c[1] t + ... + c[n] t^n */
struct G(poly) {
    int n;
    num c[MOST_COEFFICIENTS];
};

static inline struct G(poly) G(constant)(num a) { return (struct G(poly)){0, {a}}; }

/* (t - a) / (b - a) */
static inline struct G(poly) G(linear)(num a, num b)
{
    num length = sub(b, a);
    return (struct G(poly)){1, {div(neg(a), length), div(from_int(1), length)}};
}

static inline struct G(poly) G(times)(struct G(poly) a, struct G(poly) b)
{
    struct G(poly) product = {.n = a.n + b.n};
    for (int k = 0; k <= product.n; k++)
        product.c[k] = from_int(0);
    for (int i = 0; i <= a.n; i++)
        for (int j = 0; j <= b.n; j++)
            product.c[i + j] = add(product.c[i + j], mul(a.c[i], b.c[j]));
    return product;
}

static inline struct G(poly) G(plus)(struct G(poly) a, struct G(poly) b)
{
    struct G(poly) sum = {.n = a.n > b.n ? a.n : b.n};
    for (int k = 0; k <= sum.n; k++)
        sum.c[k] = add(k <= a.n ? a.c[k] : from_int(0), k <= b.n ? b.c[k] : from_int(0));
    return sum;
}

/* The derivative of order r at t: the sum of k (k-1) ... (k-r+1) c_k t^{k-r}. */
static inline num G(at)(struct G(poly) p, int r, num t)
{
    num sum = from_int(0);
    for (int k = r; k <= p.n; k++) {
        num term = p.c[k];
        for (int i = 0; i < r; i++)
            term = mul(term, from_int(k - i));
        for (int i = 0; i < k - r; i++)
            term = mul(term, t);
        sum = add(sum, term);
    }
    return sum;
}

/* A polynomial of degree n with free coefficients. */
static inline struct G(poly) G(free_poly)(trial *T, const char *name, int n)
{
    struct G(poly) p = {.n = n};
    for (int k = 0; k <= n; k++)
        p.c[k] = unknown(T, name, k);
    return p;
}

/* The four functions as they are printed over [t0, t1], index 0 to 3 for g_00, g_01, h_00, h_01:
 *     g_00 = (1 - 2 (t-t0)/(t0-t1)) ((t-t1)/(t0-t1))^2,    g_01 = (1 - 2 (t-t1)/(t1-t0)) ((t-t0)/(t1-t0))^2,
 *     h_00 = (t-t0)/(t1-t0) ((t-t1)/(t0-t1))^2,            h_01 = (t-t1)/(t1-t0) ((t-t0)/(t1-t0))^2. */
static inline struct G(poly) G(printed_blending)(num t0, num t1, int which)
{
    struct G(poly) up = G(linear)(t0, t1), down = G(linear)(t1, t0), two = G(constant)(from_int(2));
    struct G(poly) near = which % 2 == 0 ? up : down, far = which % 2 == 0 ? down : up;
    struct G(poly) minus = G(constant)(from_int(-1)), back = G(times)(minus, near); /* over the opposite difference */
    struct G(poly) bracket = G(plus)(G(constant)(from_int(1)), G(times)(minus, G(times)(two, back)));
    struct G(poly) factor = which < 2 ? bracket : which == 2 ? near : back;
    return G(times)(factor, G(times)(far, far));
}

/* What is multiplied by datum number `which` in the printed sum: with a derivative h and the length t1 - t0. */
static inline struct G(poly) G(printed_term)(num t0, num t1, int which)
{
    struct G(poly) g = G(printed_blending)(t0, t1, which);
    return which < 2 ? g : G(times)(g, G(constant)(sub(t1, t0)));
}

/* Entry (i, j) of the printed matrix: coefficient of u^{3-i} in q_00, q_01, q_10, q_11. */
static inline int G(printed_matrix)(int i, int j)
{
    static const int H[4][4] = {{2, -2, 1, 1}, {-3, 3, -2, -1}, {0, 0, 1, 0}, {1, 0, 0, 0}};
    return H[i][j];
}

static inline void G(different_nodes)(trial *T, int d, num tau[])
{
    tau[0] = unknown(T, "t", 0);
    for (int i = 1; i < d; i++)
#if FIELD
        tau[i] = unknown(T, "t", i);
#else
        tau[i] = add(tau[i - 1], positive(T, "h", i));
#endif
}

/* t0, and t1 greater than it. */
static inline void G(interval)(trial *T, num *t0, num *t1)
{
    *t0 = unknown(T, "t", 0);
    *t1 = add(*t0, positive(T, "h", 0));
}

static inline void G(four_data)(trial *T, num data[4])
{
    for (int i = 0; i < 4; i++)
        data[i] = unknown(T, "f", i);
}

/* Compare: p has the four data. */
static inline void G(osculates)(trial *T, struct G(poly) p, num t0, num t1, const num data[4])
{
    static const char *const name[4] = {"P(t_0)", "P(t_1)", "P'(t_0)", "P'(t_1)"};
    for (int i = 0; i < 4; i++) {
        about(T, name[i]);
        same(T, G(at)(p, i / 2, i % 2 == 0 ? t0 : t1), data[i]);
    }
}
#include "chapters/judge/claims_off.h"
