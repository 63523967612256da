/* bspline.tmpl.h -- B-splines (B 样条)   s(t) = sum_{i=0}^{n-1} c_i N_{i,p}(t)   of degree p over knots u.
 *
 * Shapes.  n points, coordinate c of point i is c[i*dim + c]; n+p+1 knots u_0 <= u_1 <= ... <= u_{n+p}
 * (节点) of multiplicity at most p+1.  0 <= p <= MAX_DEGREE, p < n, 1 <= dim <= MAX_DIM.  The domain is
 * [u_p, u_n].  In books that number from 1 and speak of the order k: p = k-1, u_{i-1} = t_i, c_{i-1} = r_i.
 *
 * Spans.  A span is an index mu, p <= mu <= n-1, with u_mu < u_{mu+1}.  It says which polynomial segment
 * of s is meant: on it only c_{mu-p}, ..., c_mu count, and no divisor below is 0.  t may then be any number;
 * outside [u_mu, u_{mu+1}] the segment is continued as the polynomial that it is.  So a value from the left at
 * a knot is that of the span on the left.  Which span contains t is decided outside (core/kernels/span.h for binary64,
 * exact/span.h for rationals).
 *
 * Curves.  Kernels that make another curve of a whole one take the curve s, a struct G(spline) of degree p, count n, dim, knots u
 * and points c; those that compute a segment take it, a struct G(curve_span) s of degree p, dim, knots u, mu and points c; those
 * that read no points take the degree, the knots and the span.
 *
 * Results do not overlap arguments unless said.
 * Source: de-boor-1978, ch. IX to XI; ramshaw-1989. */
#include "core/number/limits.h"

#include "core/number/generic_on.h"

/* One level of the recursion of de Boor and Cox at t, in place: the k values N_{i,k-1}(t), i = mu-k+1, ..., mu,
 * become the k+1 values N_{i,k}(t), i = mu-k, ..., mu:
 *     N_{i,k} = (t - u_i)/(u_{i+k} - u_i) N_{i,k-1} + (u_{i+k+1} - t)/(u_{i+k+1} - u_{i+1}) N_{i+1,k-1}. */
KERNEL void G(bspline_basis_level)(int k, const num u[], int mu, num t, num N[])
{
    num carry = from_int(0);
    for (int m = 0; m < k; m++) {
        int i = mu - k + 1 + m; /* N[m] is N_{i,k-1}; it goes to N_{i-1,k} and to N_{i,k} */
        num share = div(N[m], sub(u[i + k], u[i]));
        N[m] = add(carry, mul(sub(u[i + k], t), share));
        carry = mul(sub(t, u[i]), share);
    }
    N[k] = carry;
}

/* The derivative of the same recursion, in place: from values of degree k-1 to those of
 *     N_{i,k}' = k (N_{i,k-1}/(u_{i+k} - u_i) - N_{i+1,k-1}/(u_{i+k+1} - u_{i+1})). */
KERNEL void G(bspline_basis_derivative_level)(int k, const num u[], int mu, num N[])
{
    num carry = from_int(0);
    for (int m = 0; m < k; m++) {
        int i = mu - k + 1 + m;
        num share = mul(from_int(k), div(N[m], sub(u[i + k], u[i])));
        N[m] = sub(carry, share);
        carry = share;
    }
    N[k] = carry;
}

/* N[m] = N_{mu-p+m,p}(t), m = 0, ..., p: the B-splines that do not vanish on the span. */
KERNEL void G(bspline_basis)(int p, const num u[restrict], int mu, num t, num N[restrict])
{
    N[0] = from_int(1);
    for (int k = 1; k <= p; k++)
        G(bspline_basis_level)(k, u, mu, t, N);
}

/* Row k of D, k = 0, ..., r, holds the p+1 derivatives of order k: D[k(p+1) + m] = N_{mu-p+m,p}^(k)(t). */
KERNEL void G(bspline_basis_derivatives)(int p, const num u[restrict], int mu, num t, int r, num D[restrict])
{
    for (int k = 0; k <= r; k++) {
        num *row = D + k * (p + 1);
        for (int m = 0; m <= p; m++)
            row[m] = from_int(0);
        if (k > p)
            continue;
        G(bspline_basis)(p - k, u, mu, t, row);
        for (int q = p - k + 1; q <= p; q++)
            G(bspline_basis_derivative_level)(q, u, mu, row);
    }
}

/* Discrete B-splines (离散 B 样条): a[m] = alpha_{mu-p+m}(j), m = 0, ..., p, where x_0, ..., x_{p-1} are the knots
 * v_{j+1}, ..., v_{j+p} of a refinement v of u and [v_j, v_{j+1}) lies in the span: point j over v is
 * sum_i alpha_i(j) c_i.  The recursion of de Boor and Cox, level k at x_{k-1}; the order of x does not matter. */
KERNEL void G(bspline_discrete)(int p, const num u[], int mu, const num x[restrict], num a[restrict])
{
    a[0] = from_int(1);
    for (int k = 1; k <= p; k++)
        G(bspline_basis_level)(k, u, mu, x[k - 1], a);
}

/* Level r of de Boor's triangle at t, 1 <= r <= p, in place: the p+2-r points d_i^{r-1}, i = mu-p+r-1, ..., mu,
 * become the p+1-r points d_i^r = (1-a) d_{i-1}^{r-1} + a d_i^{r-1}, a = (t - u_i)/(u_{i+p+1-r} - u_i),
 * i = mu-p+r, ..., mu.  The last point stays as it was.  The points of s are not read. */
KERNEL void G(bspline_deboor_level)(struct G(curve_span) s, int r, num d[], num t)
{
    const num *u = s.knots;
    for (int m = 0; m <= s.degree - r; m++) {
        int i = s.mu - s.degree + r + m, far = i + s.degree + 1 - r;
        num length = sub(u[far], u[i]), a = div(sub(t, u[i]), length), b = div(sub(u[far], t), length);
        for (int c = 0; c < s.dim; c++)
            d[m * s.dim + c] = add(mul(b, d[m * s.dim + c]), mul(a, d[(m + 1) * s.dim + c]));
    }
}

/* The polar form (极形式) of the segment, out = f[x_0, ..., x_{p-1}]: symmetric, affine in each x, and
 * f[t, ..., t] = s(t).  Level r of de Boor's triangle at x_{r-1}. */
KERNEL void G(bspline_blossom)(struct G(curve_span) s, const num x[restrict], num out[restrict])
{
    const num *c = s.points + (s.mu - s.degree) * s.dim;
    num w[(MAX_DEGREE + 1) * MAX_DIM];
    for (int m = 0; m < (s.degree + 1) * s.dim; m++)
        w[m] = c[m];
    for (int r = 1; r <= s.degree; r++)
        G(bspline_deboor_level)(s, r, w, x[r - 1]);
    for (int k = 0; k < s.dim; k++)
        out[k] = w[k];
}

/* out = s(t), by de Boor's algorithm. */
KERNEL void G(bspline_deboor)(struct G(curve_span) s, num t, num out[restrict])
{
    num x[MAX_DEGREE + 1];
    for (int r = 0; r < s.degree; r++)
        x[r] = t;
    G(bspline_blossom)(s, x, out);
}

/* The points of the derivative on a span, in place: d_i, i = mu-p, ..., mu, become the p points
 *     p (d_i - d_{i-1})/(u_{i+p} - u_i), i = mu-p+1, ..., mu,
 * of a spline of degree p-1 over the same knots.  The last point stays as it was; nothing happens for p = 0. */
KERNEL void G(bspline_hodograph)(int p, int dim, const num u[], int mu, num d[])
{
    for (int m = 0; m < p; m++) {
        int i = mu - p + 1 + m;
        num factor = div(from_int(p), sub(u[i + p], u[i]));
        for (int c = 0; c < dim; c++)
            d[m * dim + c] = mul(factor, sub(d[(m + 1) * dim + c], d[m * dim + c]));
    }
}

/* Row k of out, k = 0, ..., r, is the k-th derivative of s at t; zero for k > p. */
KERNEL void G(bspline_derivatives)(struct G(curve_span) s, num t, int r, num out[restrict])
{
    int p = s.degree, dim = s.dim;
    const num *c = s.points + (s.mu - p) * dim;
    num w[(MAX_DEGREE + 1) * MAX_DIM];
    for (int m = 0; m < (p + 1) * dim; m++)
        w[m] = c[m];
    for (int k = 0; k <= r; k++) {
        if (k <= p)
            G(bspline_deboor)(G(span_alone)(p - k, dim, s.knots, s.mu, w), t, out + k * dim);
        else
            for (int m = 0; m < dim; m++)
                out[k * dim + m] = from_int(0);
        G(bspline_hodograph)(p - k, dim, s.knots, s.mu, w);
    }
}

/* The n-1 points e_i = p (c_{i+1} - c_i)/(u_{i+p+1} - u_{i+1}) of the derivative of s, a spline of degree p-1
 * over u_1, ..., u_{n+p-1}, p >= 1.  UNDEFINED where p+1 knots u_{i+1}, ..., u_{i+p+1} are one. */
KERNEL void G(bspline_difference)(int n, int p, int dim, const num u[restrict], const num c[restrict], num e[restrict])
{
    for (int i = 0; i < n - 1; i++) {
        num factor = div(from_int(p), sub(u[i + p + 1], u[i + 1]));
        for (int k = 0; k < dim; k++)
            e[i * dim + k] = mul(factor, sub(c[(i + 1) * dim + k], c[i * dim + k]));
    }
}

/* The Greville abscissa (Greville 横坐标) of point i, (u_{i+1} + ... + u_{i+p})/p, p >= 1: the coefficient of
 * N_{i,p} in the spline s(t) = t. */
KERNEL num G(bspline_greville)(int p, const num u[], int i)
{
    num sum = u[i + 1];
    for (int k = 2; k <= p; k++)
        sum = add(sum, u[i + k]);
    return div(sum, from_int(p));
}

/* Boehm's insertion of one knot x, u_mu <= x < u_{mu+1}: n+2+p knots v and n+1 points d of the same spline,
 *     d_i = c_i for i <= mu-p,   (1-a) c_{i-1} + a c_i with a = (x - u_i)/(u_{i+p} - u_i) for mu-p < i <= mu,
 *     c_{i-1} for i > mu. */
KERNEL void G(bspline_insert)(const struct G(spline) * curve, int mu, num x, num v[restrict], num d[restrict])
{
    int n = curve->count, p = curve->degree, dim = curve->dim;
    const num *u = curve->knots, *c = curve->points;
    num w[(MAX_DEGREE + 1) * MAX_DIM];
    for (int i = 0; i <= n + p + 1; i++)
        v[i] = i <= mu ? u[i] : i == mu + 1 ? x : u[i - 1];
    for (int m = 0; m < (p + 1) * dim; m++)
        w[m] = c[(mu - p) * dim + m];
    if (p > 0)
        G(bspline_deboor_level)(G(span_of_curve)(curve, mu), 1, w, x);
    for (int i = 0; i <= n; i++)
        for (int k = 0; k < dim; k++)
            d[i * dim + k] = i <= mu - p ? c[i * dim + k]
                             : i <= mu   ? w[(i - mu + p - 1) * dim + k]
                                         : c[(i - 1) * dim + k];
}

/* The inverse: takes out the knot u_r, p < r < n, u_r < u_{r+1}, of multiplicity s, 1 <= s <= p+1.  v: n+p knots,
 * b: n-1 points, so that inserting u_r again gives c with the exception of one equation; defect[dim] is what
 * that equation lacks.  The knot is removable (可消去), the spline of b and v is s, if and only if defect = 0.
 * The equations c_i = (1-a_i) b_{i-1} + a_i b_i are solved from both ends, as far as they reach. */
KERNEL void G(bspline_remove)(const struct G(spline) * curve, int r, int s, num v[restrict], num b[restrict],
                              num defect[restrict])
{
    int n = curve->count, p = curve->degree, dim = curve->dim;
    const num *u = curve->knots, *c = curve->points;
    int mu = r - 1, low = mu - p + 1, high = mu - s + 1; /* equations low, ..., high; mu is the span of u_r in v */
    for (int i = 0; i < n + p; i++)
        v[i] = u[i <= mu ? i : i + 1];
    for (int i = 0; i < n - 1; i++)
        for (int k = 0; k < dim; k++)
            b[i * dim + k] = c[(i < high ? i : i + 1) * dim + k];
    while (low < high) {
        num length = sub(v[low + p], v[low]), from_left = sub(u[r], v[low]), to_right = sub(v[low + p], u[r]);
        for (int k = 0; k < dim; k++) /* b_low from equation low */
            b[low * dim + k] =
                div(sub(mul(length, c[low * dim + k]), mul(to_right, b[(low - 1) * dim + k])), from_left);
        if (++low == high)
            break;
        length = sub(v[high + p], v[high]), from_left = sub(u[r], v[high]), to_right = sub(v[high + p], u[r]);
        for (int k = 0; k < dim; k++) /* b_{high-1} from equation high */
            b[(high - 1) * dim + k] =
                div(sub(mul(length, c[high * dim + k]), mul(from_left, b[high * dim + k])), to_right);
        high--;
    }
    if (s == p + 1) { /* no equation: c_{mu-p} and c_{mu-p+1} are both b_{mu-p} */
        for (int k = 0; k < dim; k++)
            defect[k] = sub(c[(mu - p) * dim + k], c[(mu - p + 1) * dim + k]);
        return;
    }
    num length = sub(v[low + p], v[low]), a = div(sub(u[r], v[low]), length), a1 = div(sub(v[low + p], u[r]), length);
    for (int k = 0; k < dim; k++)
        defect[k] = sub(c[low * dim + k], add(mul(a1, b[(low - 1) * dim + k]), mul(a, b[low * dim + k])));
}

/* The m points of the same spline over a refinement v of u (m+p+1 knots, every knot of u with at least its
 * multiplicity): the Oslo algorithm, d_j = f[v_{j+1}, ..., v_{j+p}].  span[j] is a span of u that contains a non-empty
 * interval [v_l, v_{l+1}] with j <= l <= j+p. */
KERNEL void G(bspline_refine)(const struct G(spline) * s, int m, const num v[restrict], const int span[restrict],
                              num d[restrict])
{
    for (int j = 0; j < m; j++)
        G(bspline_blossom)(G(span_of_curve)(s, span[j]), v + j + 1, d + j * s->dim);
}

/* The m points of the same spline in degree p+1 <= MAX_DEGREE over v, in which every knot of u in the domain has
 * at least one more than its multiplicity (m+p+2 knots):
 *     d_j = 1/(p+1) sum_{k=1}^{p+1} f[v_{j+1}, ..., v_{j+p+1} without v_{j+k}].
 * span[j] as above, with j <= l <= j+p+1. */
KERNEL void G(bspline_elevate)(const struct G(spline) * s, int m, const num v[restrict], const int span[restrict],
                               num d[restrict])
{
    int p = s->degree, dim = s->dim;
    num x[MAX_DEGREE], part[MAX_DIM], share = from_ratio(1, p + 1);
    for (int j = 0; j < m; j++) {
        for (int k = 0; k < dim; k++)
            d[j * dim + k] = from_int(0);
        for (int left_out = 0; left_out <= p; left_out++) {
            for (int r = 0; r < p; r++)
                x[r] = v[j + 1 + (r < left_out ? r : r + 1)];
            G(bspline_blossom)(G(span_of_curve)(s, span[j]), x, part);
            for (int k = 0; k < dim; k++)
                d[j * dim + k] = add(d[j * dim + k], mul(share, part[k]));
        }
    }
}

/* The p+1 Bézier points of the segment over [u_mu, u_{mu+1}]: b_i = f[u_mu, ..., u_mu, u_{mu+1}, ..., u_{mu+1}]
 * with i arguments u_{mu+1}.  De Boor's triangle at u_mu leaves the points of the segment over the knots u_mu, p+1 times, and
 * u_{mu+1}, ..., u_{mu+p}; the b_i are the first points of the levels of the triangle of these at u_{mu+1}. */
KERNEL void G(bspline_to_bezier)(struct G(curve_span) s, num b[restrict])
{
    int p = s.degree, dim = s.dim;
    num d[(MAX_DEGREE + 1) * MAX_DIM], knots[2 * MAX_DEGREE + 1], from = s.knots[s.mu], to = s.knots[s.mu + 1];
    for (int m = 0; m < (p + 1) * dim; m++)
        d[m] = s.points[(s.mu - p) * dim + m];
    for (int r = 1; r <= p; r++)
        G(bspline_deboor_level)(s, r, d, from);
    for (int i = 0; i <= 2 * p; i++)
        knots[i] = i <= p ? from : s.knots[s.mu + i - p];
    for (int r = 0; r <= p; r++) {
        if (r > 0)
            G(bspline_deboor_level)(G(on_span)(p, dim, knots, p, d), r, d, to);
        for (int k = 0; k < dim; k++)
            b[r * dim + k] = d[k];
    }
}

/* The way back: the point that belongs to the knots x_0, ..., x_{p-1} when the segment over [from, to] has the Bézier
 * points b: its polar form there.  UNDEFINED for from = to. */
KERNEL void G(bspline_point_of_bezier)(int p, int dim, const num b[restrict], num from, num to, const num x[restrict],
                                       num out[restrict])
{
    num local[MAX_DEGREE + 1], length = sub(to, from);
    for (int r = 0; r < p; r++)
        local[r] = div(sub(x[r], from), length);
    G(bezier_blossom)(p, dim, b, local, out);
}

/* The m points, in degree p-1 over v (m+p knots), of a spline that is of this degree: point j is the polar form at
 * v_{j+1}, ..., v_{j+p-1} of the segment span[j], reduced by bezier_reduce; span[j] as above, with j <= l < j+p.
 * p >= 1.  Whether the spline is of degree p-1 is decided by elevating the result: it is if and only if that
 * gives c again. */
KERNEL void G(bspline_reduce)(const struct G(spline) * s, int m, const num v[restrict], const int span[restrict],
                              num d[restrict])
{
    int p = s->degree, dim = s->dim;
    const num *u = s->knots;
    num b[(MAX_DEGREE + 1) * MAX_DIM], lower[(MAX_DEGREE + 1) * MAX_DIM], defect[MAX_DIM];
    for (int j = 0; j < m; j++) {
        G(bspline_to_bezier)(G(span_of_curve)(s, span[j]), b);
        G(bezier_reduce)(p, dim, b, lower, defect);
        G(bspline_point_of_bezier)(p - 1, dim, lower, u[span[j]], u[span[j] + 1], v + j + 1, d + j * dim);
    }
}

/* The two parts of s at t, u_mu <= t < u_{mu+1}, where t has the multiplicity s in u, 0 <= s <= p+1; each part
 * ends in t with multiplicity p+1.
 *     left:  mu-s+1 points over u_0, ..., u_{mu-s}, t, ..., t    (none if that is not positive)
 *     right: n-mu+p points over t, ..., t, u_{mu+1}, ..., u_{n+p}
 * The new points are the two sides of de Boor's triangle at t. */
KERNEL void G(bspline_split)(const struct G(spline) * curve, int mu, int s, num t, num left_knots[restrict],
                             num left[restrict], num right_knots[restrict], num right[restrict])
{
    int n = curve->count, p = curve->degree, dim = curve->dim;
    const num *u = curve->knots, *c = curve->points;
    num w[(MAX_DEGREE + 1) * MAX_DIM];
    int lefts = mu - s + 1, rights = n - mu + p;
    for (int i = 0; i < lefts + p + 1; i++)
        left_knots[i] = i < lefts ? u[i] : t;
    for (int i = 0; i < rights + p + 1; i++)
        right_knots[i] = i <= p ? t : u[mu + i - p];
    for (int m = 0; m < lefts * dim && m < (mu - p) * dim; m++)
        left[m] = c[m];
    for (int m = 0; m < (n - mu) * dim; m++)
        right[p * dim + m] = c[mu * dim + m];
    for (int m = 0; m < (p + 1) * dim; m++)
        w[m] = c[(mu - p) * dim + m];
    for (int r = 0; r <= p; r++) {
        if (r > 0)
            G(bspline_deboor_level)(G(span_of_curve)(curve, mu), r, w, t);
        for (int k = 0; k < dim; k++) {
            if (mu - p + r < lefts)
                left[(mu - p + r) * dim + k] = w[k];
            right[(p - r) * dim + k] = w[(p - r) * dim + k];
        }
    }
}

/* A periodic spline (周期 B 样条) as an ordinary one: m points c_0, ..., c_{m-1} and the m+1 knots u_0, ..., u_m of
 * one period become m+p points d and m+2p+1 knots v whose domain is the period; 0 <= p <= m. */
KERNEL void G(bspline_periodic)(int m, int p, int dim, const num u[restrict], const num c[restrict], num v[restrict],
                                num d[restrict])
{
    num period = sub(u[m], u[0]);
    for (int i = 0; i <= m; i++)
        v[p + i] = u[i];
    for (int i = 1; i <= p; i++) {
        v[p - i] = sub(u[m - i], period);
        v[p + m + i] = add(u[i], period);
    }
    for (int i = 0; i < m + p; i++)
        for (int k = 0; k < dim; k++)
            d[i * dim + k] = c[i % m * dim + k];
}
#include "core/number/generic_off.h"
