/* conics.h -- what the sections on conics share: the other sides of their claims, written out and
 * without kernels, and the frame of a triangle.  Generic text, included after exact/decide/roots.h and claims_on.h.
 *
 * Coordinates in the frame of a triangle R_0 R_1 R_2 are x and y with
 *     R = R_1 + x (R_0 - R_1) + y (R_2 - R_1). */

/* A x^2 + 2B xy + C y^2 + 2D x + 2E y + F, term by term. */
static inline num G(form)(const num S[], num x, num y)
{
    num two = from_int(2), sum = mul(S[0], mul(x, x));
    sum = add(sum, mul(mul(two, S[1]), mul(x, y)));
    sum = add(sum, mul(S[2], mul(y, y)));
    sum = add(sum, mul(mul(two, S[3]), x));
    sum = add(sum, mul(mul(two, S[4]), y));
    return add(sum, S[5]);
}

/* a x + b y + c */
static inline num G(on_line)(const num l[], num x, num y) { return add(add(mul(l[0], x), mul(l[1], y)), l[2]); }

/* (a - o) x (b - o) */
static inline num G(area)(const num o[], const num a[], const num b[])
{
    return sub(mul(sub(a[0], o[0]), sub(b[1], o[1])), mul(sub(a[1], o[1]), sub(b[0], o[0])));
}

/* P has the coordinates x and y in the frame of R. */
static inline void G(point_in_frame)(const num R[], num x, num y, num P[])
{
    for (int c = 0; c < 2; c++)
        P[c] = add(R[2 + c], add(mul(x, sub(R[c], R[2 + c])), mul(y, sub(R[4 + c], R[2 + c]))));
}

/* S = (1-lambda) x y + sign lambda (x + y - 1)^2, formula (3.1.4). */
static inline void G(frame_conic)(num lambda, int sign, num S[])
{
    num m = mul(from_int(sign), lambda);
    S[0] = S[2] = S[5] = m;
    S[1] = add(mul(from_ratio(1, 2), sub(from_int(1), lambda)), m);
    S[3] = S[4] = neg(m);
}

/* The lambda of the conic (3.1.4) of the given sign through (x, y). */
static inline num G(lambda_at)(num x, num y, int sign)
{
    num s = sub(add(x, y), from_int(1)), xy = mul(x, y);
    return div(xy, sub(xy, mul(from_int(sign), mul(s, s))));
}

/* The tangent of S at (x, y) meets Y = 0 in (*X, 0) and X = 0 in (0, *Y). */
static inline void G(tangent_cuts)(const num S[], num x, num y, num *X, num *Y)
{
    num g[2];
    G(conic_gradient)(S, x, y, g);
    *X = add(x, div(mul(y, g[1]), g[0]));
    *Y = add(y, div(mul(x, g[0]), g[1]));
}

/* Six coordinates, or six coefficients. */
static inline void G(six)(trial *T, const char *name, num S[])
{
    for (int k = 0; k < 6; k++)
        S[k] = unknown(T, name, k);
}

static inline void G(three_weights)(trial *T, num w[])
{
    for (int i = 0; i < 3; i++)
        w[i] = positive(T, "w", i);
}

/* Weights whose outer ones are squares: w = (a^2, w_1, c^2). */
static inline void G(square_ends)(trial *T, num *a, num *c, num w[])
{
    *a = positive(T, "a", 0);
    *c = positive(T, "c", 0);
    w[0] = mul(*a, *a);
    w[1] = positive(T, "w", 1);
    w[2] = mul(*c, *c);
}

#if RATIONAL
/* The number of lambda for which (1-lambda) S1 + lambda S2 is a multiple of M as far as the
 * coefficients i and j go: the zeros of a determinant that is affine in lambda. */
static inline int members_like(const num S1[], const num S2[], const num M[], int i, int j)
{
    num at[2] = {sub(mul(S1[i], M[j]), mul(S1[j], M[i])), sub(mul(S2[i], M[j]), mul(S2[j], M[i]))};
    return count_roots_line(poly_from_bernstein(1, at)).distinct;
}

/* The signed ratios of the frame at (x, y) on the conic of lambda and sign. */
static inline void ratios(num lambda, int sign, num x, num y, num g[])
{
    num S[6], X, Y, one = from_int(1);
    G(frame_conic)(lambda, sign, S);
    G(tangent_cuts)(S, x, y, &X, &Y);
    g[0] = div(X, sub(one, X));
    g[1] = div(Y, sub(one, Y));
}

/* |a| */
static inline num length(num a) { return sign_q(a) < 0 ? neg(a) : a; }
#endif
