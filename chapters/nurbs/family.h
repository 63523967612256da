/* family.h -- the families of curves of lower order that belong to one span of a NURBS curve.
 *
 * Local arrays: the p+1 points R_{mu-p}, ..., R_mu of a span and their weights stand at 0, ..., p; the p+1-r points
 * of level r at 0, ..., p-r.  The member tau of level r is the curve of degree p-r that they have over the same knots
 * and the same span.  Generic text, for the sections on envelopes. */
#include "chapters/nurbs/definition.h"

#include "exact/record/sign.h"

#include "chapters/judge/claims_on.h"

/* The knots of one span mu = p: 2p+2 knots, p+1 points.
 *     shape 0: simple knots;   1: both ends of the span p-fold;   2: its left end double;
 *     from 3 on, in the field and for p <= 3: all 4^{p-1} patterns of the p knots on either side of the span.
 * In the field the distinct knots are variables for p <= 4 and the numbers 0, 1, 3, 6, 10, ... for p > 4. */
enum { KINDS_OF_SPAN = 3 };
static inline int G(shapes)(int p) { return KINDS_OF_SPAN + (FIELD && p > 0 && p <= 3 ? 1 << (2 * p - 2) : 0); }

static inline void G(knots_of_span)(trial *T, int p, int shape, num u[], int place[])
{
    char pattern[MOST_KNOTS + 1] = {0};
    int length = 0;
    if (shape >= KINDS_OF_SPAN) {
        int bits = shape - KINDS_OF_SPAN; /* whether a knot differs from the one before */
        for (int i = 0; i < 2 * p + 2; i++) {
            int within = i > 1 && i < 2 * p + 1 && i != p + 1, grows = within ? bits & 1 : i > 0;
            length += grows;
            pattern[length] = (char)(pattern[length] != 0 ? pattern[length] + 1 : '1');
            bits >>= within;
        }
    } else if (shape == 1) {
        pattern[0] = pattern[3] = '1';
        pattern[1] = pattern[2] = (char)('0' + p);
    } else {
        for (int left = p + 1 - shape; left > 0; left--)
            pattern[length++] = '1';
        if (shape == 2)
            pattern[length++] = '2';
        for (int right = p + 1; right > 0; right--)
            pattern[length++] = '1';
    }
    int count = G(knots_of_pattern)(T, pattern, u, place);
    G(numbers_above)(4, p, count, place, u);
}

/* The same with u_0 = 0 and the positive gaps as data, for questions of sign; in the field they are 1, 2, 3, ... for
 * p > 3. */
static inline void G(gaps_of_span)(trial *T, int p, int shape, num u[])
{
    int place[MOST_KNOTS];
    G(knots_of_span)(T, p, shape, u, place);
    num value = from_int(0);
    for (int i = 0; i < 2 * p + 2; i++) {
        if (i > 0 && place[i] > place[i - 1])
            value = add(value, FIELD && p > 3 ? from_int(place[i]) : positive(T, "g", place[i]));
        u[i] = value;
    }
}

/* p+1 points of dim coordinates and positive weights, everything free. */
static inline void G(free_curve)(trial *T, int p, int dim, num R[], num w[])
{
    static const char *const name[] = {"a", "b", "c"};
    for (int i = 0; i <= p; i++) {
        w[i] = positive(T, "w", i);
        for (int c = 0; c < dim; c++)
            R[i * dim + c] = unknown(T, name[c], i);
    }
}

/* The points and weights of level r at tau, by (4.1.3) and (4.1.4). */
static inline void G(level_of_curve)(int p, int dim, const num u[], int mu, const num R[], const num w[], int r,
                                     num tau, num Rr[], num wr[])
{
    for (int m = 0; m < (p + 1) * dim; m++)
        Rr[m] = R[m];
    for (int i = 0; i <= p; i++)
        wr[i] = w[i];
    for (int level = 1; level <= r; level++)
        G(nurbs_deboor_level)(G(nurbs_on_span)(p, dim, u, mu, NULL, NULL), level, Rr, wr, tau);
}

/* out = sum N_{i,q}(t) w_i (R_i, 1) of a curve of degree q on the span: numerators, then the denominator. */
static inline void G(sums)(int q, int dim, const num u[], int mu, const num R[], const num w[], num t, num out[])
{
    num N[MAX_DEGREE + 1];
    G(bspline_basis)(q, u, mu, t, N);
    for (int c = 0; c <= dim; c++) {
        out[c] = from_int(0);
        for (int m = 0; m <= q; m++) {
            num term = mul(N[m], w[m]);
            out[c] = add(out[c], c < dim ? mul(term, R[m * dim + c]) : term);
        }
    }
}

/* The same sums with the derivatives N_{i,q}' in the place of N_{i,q}. */
static inline void G(derivative_sums)(int q, int dim, const num u[], int mu, const num R[], const num w[], num t,
                                      num out[])
{
    num D[2 * (MAX_DEGREE + 1)];
    G(bspline_basis_derivatives)(q, u, mu, t, 1, D);
    for (int c = 0; c <= dim; c++) {
        out[c] = from_int(0);
        for (int m = 0; m <= q; m++) {
            num term = mul(D[q + 1 + m], w[m]);
            out[c] = add(out[c], c < dim ? mul(term, R[m * dim + c]) : term);
        }
    }
}

/* Row k of out is the k-th derivative at t of the rational curve of degree q on the span, k = 0, ..., order. */
static inline void G(curve_derivatives)(int q, int dim, const num u[], int mu, const num R[], const num w[], num t,
                                        int order, num out[])
{
    num H[(MAX_DEGREE + 1) * MAX_DIM], D[(MAX_DEGREE + 1) * MAX_DIM];
    G(rational_homogenize)(q, dim, R, w, H);
    G(bspline_derivatives)(G(span_alone)(q, dim + 1, u, mu, H), t, order, D);
    G(rational_quotient_derivatives)(dim, D, order, out);
}

/* f(x_1, ..., x_p) of the polynomial sum a_m t^m, m <= p: sum a_m e_m(x)/C(p,m), e_m the elementary symmetric
 * functions. */
static inline num G(polar_of_powers)(int p, const num a[], const num x[])
{
    num e[MAX_DEGREE + 1], value = from_int(0);
    for (int m = 0; m <= p; m++)
        e[m] = from_int(m == 0);
    for (int k = 0; k < p; k++)
        for (int m = k + 1; m >= 1; m--)
            e[m] = add(e[m], mul(x[k], e[m - 1]));
    for (int m = 0; m <= p; m++)
        value = add(value, div(mul(a[m], e[m]), from_int(binomial(p, m))));
    return value;
}

/* The curve a_0 + a_1 t + ... + a_p t^p of dim coordinates on the span mu = p of the 2p+2 knots u, weights 1: its points
 * are the values R_i = f[u_{i+1}, ..., u_{i+p}] of its polar form. */
static inline void G(curve_of_powers)(int p, int dim, const num u[], const num a[], num R[], num w[])
{
    num power[MAX_DEGREE + 1];
    for (int i = 0; i <= p; i++) {
        w[i] = from_int(1);
        for (int c = 0; c < dim; c++) {
            for (int m = 0; m <= p; m++)
                power[m] = a[m * dim + c];
            R[i * dim + c] = G(polar_of_powers)(p, power, u + i + 1);
        }
    }
}

/* The point of the member tau of level r at t, D[0..dim-1], its derivative by t, D[dim..], and by tau, D[2 dim..].
 * The derivative by tau is that of the Bézier curve that the point, in homogeneous coordinates, is in tau. */
static inline void G(family_derivatives)(int p, int dim, const num u[], int mu, const num R[], const num w[], int r,
                                         num tau, num t, num D[])
{
    num Rr[(MAX_DEGREE + 1) * MAX_DIM], wr[MAX_DEGREE + 1], H[(MAX_DEGREE + 1) * MAX_DIM];
    num b[(MAX_DEGREE + 1) * MAX_DIM], x[MAX_DEGREE], E[2 * MAX_DIM], F[2 * MAX_DIM];
    G(level_of_curve)(p, dim, u, mu, R, w, r, tau, Rr, wr);
    G(curve_derivatives)(p - r, dim, u, mu, Rr, wr, t, 1, D);
    G(rational_homogenize)(p, dim, R, w, H);
    num length = sub(u[mu + 1], u[mu]);
    for (int i = 0; i <= r; i++) {
        for (int k = 0; k < p; k++)
            x[k] = k < p - r ? t : u[k < p - i ? mu : mu + 1];
        G(bspline_blossom)(G(span_alone)(p, dim + 1, u, mu, H), x, b + i * (dim + 1));
    }
    G(bezier_derivatives)(r, dim + 1, b, div(sub(tau, u[mu]), length), 1, E);
    G(rational_quotient_derivatives)(dim, E, 1, F);
    for (int c = 0; c < dim; c++)
        D[2 * dim + c] = div(F[dim + c], length);
}

#if RATIONAL
/* Is x'y'' - x''y' > 0 on the closed span mu of the curve of all points c, weights 1? */
static inline int G(turns_left_on_span)(int p, const num u[], int mu, const num c[])
{
    num b[2 * (MAX_DEGREE + 1)], x[2][MAX_DEGREE + 1];
    G(bspline_to_bezier)(G(on_span)(p, 2, u, mu, c), b);
    for (int i = 0; i <= p; i++) {
        x[0][i] = b[2 * i];
        x[1][i] = b[2 * i + 1];
    }
    poly x1 = poly_derivative(poly_from_bernstein(p, x[0])), y1 = poly_derivative(poly_from_bernstein(p, x[1]));
    poly turn = poly_sub(poly_mul(x1, poly_derivative(y1)), poly_mul(y1, poly_derivative(x1)));
    return sign_on(turn, from_int(0), from_int(1), CLOSED) == SIGN_POSITIVE;
}

/* The curve of one span that a block gives by its knots t_i and the vectors a of 1, t, ..., t^p; among the results are its
 * points r_i. */
static inline void G(given_curve_of_powers)(trial *T, int p, int dim, num u[], num R[], num w[])
{
    num a[(MAX_DEGREE + 1) * MAX_DIM];
    given_points(T, "t_i", 2 * p + 2, 1, u);
    given_points(T, "a", p + 1, dim, a);
    G(curve_of_powers)(p, dim, u, a, R, w);
    found_points(T, "r_i", p + 1, dim, R);
}

/* Refutes for the given cubic of the plane that the two points of level 2 differ. */
static inline void G(line_shrinks_to_a_point)(trial *T)
{
    num u[8], R[8], w[4], Rr[4 * 2], wr[4], tau = given(T, "τ");
    G(given_curve_of_powers)(T, 3, 2, u, R, w);
    G(level_of_curve)(3, 2, u, 3, R, w, 2, tau, Rr, wr);
    found_points(T, "the two points of the member", 2, 2, Rr);
    about(T, "the two points of the member differ");
    refute(T, equal_q(Rr[0], Rr[2]) && equal_q(Rr[1], Rr[3]));
}

/* Does a pair (t, tau) of level r on the span mu satisfy the condition of the envelope?  Fills X with the point of the
 * member; among the results are X and its two derivatives, which are then parallel. */
static inline int G(pair_of_the_envelope)(trial *T, int p, int dim, const num u[], int mu, const num R[], const num w[],
                                          int r, num tau, num t, num X[])
{
    num D[9], zero = from_int(0), a[3] = {zero, zero, zero}, b[3] = {zero, zero, zero}, turn[3];
    G(family_derivatives)(p, dim, u, mu, R, w, r, tau, t, D);
    for (int c = 0; c < dim; c++) {
        X[c] = D[c];
        a[c] = D[dim + c];
        b[c] = D[2 * dim + c];
    }
    found_points(T, "point of the member", 1, dim, X);
    found_points(T, "its derivatives by t and τ", 2, dim, D + dim);
    G(cross3)(a, b, turn);
    return is_zero_q(turn[0]) && is_zero_q(turn[1]) && is_zero_q(turn[2]);
}

/* Are t and tau in the span mu, which is closed on the left and open on the right? */
static inline int G(is_pair_of_span)(const num u[], int mu, num t, num tau)
{
    return compare_q(u[mu], t) <= 0 && compare_q(t, u[mu + 1]) < 0 && compare_q(u[mu], tau) <= 0 &&
           compare_q(tau, u[mu + 1]) < 0;
}

/* The same of a pair that has to be in the square of the span. */
static inline int G(pair_in_the_square)(trial *T, int p, int dim, const num u[], int mu, const num R[], const num w[],
                                        int r, num tau, num t, num X[])
{
    return G(pair_of_the_envelope)(T, p, dim, u, mu, R, w, r, tau, t, X) && G(is_pair_of_span)(u, mu, t, tau);
}

/* place[i] is the number of the distinct knot that u_i is, as in a pattern. */
static inline void G(places_of)(int count, const num u[], int place[])
{
    for (int i = 0; i < count; i++)
        place[i] = i == 0 ? 0 : place[i - 1] + !equal_q(u[i], u[i - 1]);
}

/* The interval [x_m, x_{m+1}) of the distinct knots that contains t. */
static inline int G(interval_of)(int count, const num u[], const int place[], num t)
{
    int interval = 0;
    for (int i = 0; i < count; i++)
        if (compare_q(u[i], t) <= 0)
            interval = place[i];
    return interval;
}
#endif
#include "chapters/judge/claims_off.h"
