/*
# The order of contact with the members (切触阶)

Two plane curves with a common point have contact of order $k$ there when, after a change of the parameter of one,
their derivatives up to order $k$ agree; as graphs $y(x)$ over the common tangent, when their Taylor coefficients
agree up to order $k$.  The printed claim is order $n-r$.  In truth the order does not depend on $r$: it is that of
the curve and its own tangent line, so 1 wherever the curvature is not 0.

Let $p_k=p(c^{n-k},\delta^k)$.  Then $P(c+h)=\sum_k\binom nkh^kp_k$ and the member of level $r$ is, with the same
vectors, $P^{[n-r]}(c+h,c)=\sum_k\binom{n-r}kh^kp_k$.  So everything about the contact follows from the two rows of
binomial coefficients.
*/
#include "exact/record/sign.h"

#include "chapters/judge/elementary.h"
#include "chapters/rational-bezier/free-curve.h"
#include "chapters/rational-bezier/polar-form.h"

#include "chapters/judge/claims_on.h"

/*
:::{statement} wang-ch3:thm-3.3.2-contact
:title: The curve and the member have contact of order n-r
:zh: 曲线与族曲线在接触点 n-r 阶切触
:printed: The curve $\mathbf R(t)$ and the curve of the above family have contact of order $n-r$ at the point of contact $c=t$.
:meant: the usual sense of contact of order $m$ | After a change of parameter the derivatives up to the order $m$ agree.
:class: false
:refuted-by: cubic_member_has_other_curvature
:reading: member_runs_slower_than_the_curve | equal derivatives in $t$; already of the first ones the ratio is $(n-r)/n$
:reading: cubic_member_has_other_curvature | equal derivatives after a change of parameter, the usual meaning; in the example, with
  $n-r=2$, the second ones are not
:reading: cubic_member_meets_the_curve_twice | $n-r+1$ coincident intersections; in the example there are two
:reading: quartic_member_meets_the_curve_twice | $n-r$ coincident intersections, as some count; in the example there are two
  for either level
:reading: weighted_member_has_other_directions | parallel derivatives up to order $n-r$; so they are for equal weights,
  whose derivatives are the homogeneous ones (by the step of the correction on the members and the curve at the contact; run for $n\le6$, too), but not for the others of the example
:reading: members_are_flatter_powers | the same osculating line, plane, ... up to dimension $n-r$, for all weights,
  which in the plane says nothing from dimension 2 on | Since a homogeneous factor $D(c+h)$ is $D(c)+h\delta$, the homogeneous derivatives of order $k\le n-r$ of member and curve are
  $\frac{(n-r)!}{(n-r-k)!}$ and $\frac{n!}{(n-k)!}$ times one vector; the factors are not 0, so the derivatives of the member span what those of the curve do.
:reading-with: triangle_of_powers_consists_of_powers bernstein_sum_of_powers_is_a_power cut_coefficients_are_convex
:corrected: at $t=c$ with $\mathbf R'(c)\ne0$ the contact has for every $r=1,\dots,n-1$ the order of contact of $\mathbf R$
  with its tangent: it is 1 where the curvature $\kappa$ of $\mathbf R$ is not 0, and there, with the curvature $\kappa^{[n-r]}$ of the member,
  $\frac{\kappa^{[n-r]}}{\kappa}=\frac{n(n-r-1)}{(n-r)(n-1)}<1$
:corrected-by: member_is_flatter_by_a_fixed_ratio member_is_flatter_in_every_order members_are_flatter_powers
  triangle_of_powers_consists_of_powers bernstein_sum_of_powers_is_a_power cut_coefficients_are_convex
:confirmed-by: expansion_about_the_contact osculating_flats_agree unweighted_derivatives_are_parallel curvature_of_the_member
:needs: member_may_lose_a_point | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the weights are
  positive; else (3.3.3) may give no point, and no member with it
:needs: cut_outside_can_fail | the formula (3.3.4): $a\le c\le b$ | $a\le c\le b$: outside a weight of the triangle may vanish, as $\omega_1^1$ in the example, whatever the other weights are
:figure: envelope_contact
:striking: 1

For $r=n-1$ the member is the tangent line and the printed order 1 is right where $\kappa\ne0$.  The ratio holds in
space as well as in the plane.
:::

:::{claim} expansion_about_the_contact
:title: Curve and member have one Taylor expansion up to the binomial coefficients
:zh: 曲线与族曲线的展开只差二项式系数
:given: any homogeneous coordinate of the points $H_0,\dots,H_n$, any $c$ and $h$, every $r=0,\dots,n$
:let: $p_k=p(c^{n-k},\delta^k)$
:then: $p(c^r,(c+h)^{n-r})=\sum_{k=0}^{n-r}\binom{n-r}kh^kp_k$
:method: The left side by the polar form, $p_k$ as the derivative of order $k$ of the curve at $c$ divided by
  $n!/(n-k)!$.  For every $n$: expand $(c+h)^{n-r}$ in the symmetric form.
:degrees: 1..6 sampled 12
:over: H#: points; c; h
:control: $\binom nk$ in the place of $\binom{n-r}k$
:::
*/
CLAIM(expansion_about_the_contact)
{
    int n = T->degree;
    num H[MAX_DEGREE + 1], D[MAX_DEGREE + 1], c = parameter(T, "c"), h = unknown(T, "h", 0);
    for (int i = 0; i <= n; i++)
        H[i] = unknown(T, "H", i);
    G(bezier_derivatives)(n, 1, H, c, n, D);
    for (int r = 0; r <= n; r++) {
        num left, right = from_int(0), power = from_int(1), falling = from_int(1);
        G(polar)(n, 1, H, r, c, n - r, add(c, h), c, c, &left);
        for (int k = 0; k <= n - r; k++) {
            long choose = binomial(fault(T, n - r, n), k);
            right = add(right, mul(mul(from_int(choose), power), div(D[k], falling)));
            power = mul(power, h);
            falling = mul(falling, from_int(n - k));
        }
        /* p(c^r, (c+h)^{n-r}) = Σ C(n-r,k) h^k p_k, where p_k = P^{(k)}(c) (n-k)!/n! */
        same(T, left, right);
    }
}

/*
:::{claim} member_is_flatter_by_a_fixed_ratio
:title: The curvatures of member and curve have the ratio n(n-r-1)/((n-r)(n-1)), in any dimension
:zh: 曲率比为 n(n-r-1)/((n-r)(n-1))
:given: the homogeneous curve $\sum\binom nkh^kp_k$ and the member $\sum\binom mkh^kp_k$ about the contact, to second order, with weights $w_0\ne0$, $w_1$, $w_2$ and one coordinate of
  $p_0,p_1,p_2$; any $n$ and $m=n-r$; two vectors $X,Y$ of space
:where: $\omega(c)\ne0$
:then: $R_m'=\frac mnR'$ and $R_m''=\frac{m(m-1)}{n(n-1)}R''+\mu R'$ with one $\mu$ for all coordinates; and
  $\kappa^2$ of $(aX,bY+\mu X)$ is $(b/a^2)^2$ times that of $(X,Y)$, which for these $a,b$ gives the ratio;
  $m(n-1)-n(m-1)=n-m=r$
:method: All in the field with $n$ and $m$ variables; the derivatives by Leibniz' rule, $\kappa^2$ by the kernel in the
  plane and in space.  The ratio is less than 1 because $r\ge1$.
:degrees: all
:over: n m X# Y# mu: -; p#: points
:control: the ratio $\frac{n-r-1}{n-1}$
:::
*/
CLAIM(member_is_flatter_by_a_fixed_ratio)
{
    num n = parameter(T, "n"), m = parameter(T, "m"), one = from_int(1), two = from_int(2);
    num w[3], p[3], degree[2] = {n, m}, R1[2], R2[2];
    for (int k = 0; k < 3; k++) {
        w[k] = positive(T, "w", k);
        p[k] = unknown(T, "p", k);
    }
    for (int j = 0; j < 2; j++) { /* derivatives of the quotient of P = p_0 + d h p_1 + d(d-1)/2 h^2 p_2 + ... */
        num d = degree[j], second = mul(d, sub(d, one)), R = div(p[0], w[0]);
        R1[j] = div(sub(mul(d, p[1]), mul(mul(d, w[1]), R)), w[0]);
        num rest = sub(mul(second, p[2]), mul(mul(second, w[2]), R));
        R2[j] = div(sub(rest, mul(mul(two, mul(d, w[1])), R1[j])), w[0]);
    }
    num a = div(m, n), b = div(mul(m, sub(m, one)), mul(n, sub(n, one)));
    num mu = mul(div(mul(two, w[1]), w[0]), sub(div(mul(m, sub(m, one)), sub(n, one)), div(mul(m, m), n)));
    about(T, "the first derivatives");
    /* R_m' = m/n R' */
    same(T, R1[1], mul(a, R1[0]));
    about(T, "the second derivatives");
    /* R_m'' = m (m-1)/(n (n-1)) R'' + μ R' */
    same(T, R2[1], add(mul(b, R2[0]), mul(mu, R1[0])));

    about(T, "how much the ratio is less than 1");
    /* m (n-1) - n (m-1) = n - m */
    same(T, sub(mul(m, sub(n, one)), mul(n, sub(m, one))), sub(n, m));
    num ratio = fault(T, mul(div(n, m), div(sub(m, one), sub(n, one))), div(sub(m, one), sub(n, one)));
    for (int dim = 2; dim <= 3; dim++) {
        num X[3], Y[3], aX[3], bY[3], nu = unknown(T, "mu", 0);
        for (int k = 0; k < dim; k++) {
            X[k] = positive(T, "X", k);
            Y[k] = unknown(T, "Y", k);
            aX[k] = mul(a, X[k]);
            bY[k] = add(mul(b, Y[k]), mul(nu, X[k]));
        }
        about(T, "the squares of the curvatures");
        /* κ_m/κ = n (m-1)/(m (n-1)) */
        same(T, G(curvature_squared)(dim, aX, bY), mul(mul(ratio, ratio), G(curvature_squared)(dim, X, Y)));
    }
}

/*
:::{claim} member_is_flatter_in_every_order
:title: The first coefficient off the tangent is smaller for the member than for the curve
:zh: 离开切线的首项系数，族曲线严格较小
:given: $P=\sum\binom nkh^kp_k$ and the member $\sum\binom mkh^kp_k$, $m=n-r$, in the basis $p_0,p_1,e$ where $p_k$
  is the first vector outside the span of $p_0,p_1$: as graphs $y=\frac{\binom nk}{n^k}x^k+\dots$ and
  $y=\frac{\binom mk}{m^k}x^k+\dots$
:then: $\binom nk/n^k=\frac1{k!}\prod_{j<k}(1-\frac jn)$ for every $k$, and $(1-\frac jn)-(1-\frac
  jm)=\frac{jr}{mn}\ge0$
:method: $\binom n{k+1}=\binom nk\frac{n-k}{k+1}$ gives $\binom n{k+1}/n^{k+1}=\frac1{k+1}(1-\frac kn)\binom nk/n^k$,
  the step of an induction on $k$, with $k$, $n$, $\binom nk$ and $n^k$ variables; it begins with $\binom n0/n^0=1$,
  and the first orders are written out as well.  In the second identity $m$, $n$ and $j$ are variables; $n=m+r$ with
  $m,r,j>0$ for the sign, strict for $r>0$.  The first factor with $j=1$ is strictly smaller for $m$; the others, for
  $m\ge k$, are positive and not larger, and for $m<k$ the member's coefficient is 0.  So the coefficients of $x^k$
  differ and those before agree: order exactly $k-1$.
:degrees: all
:over: m j k c N r: -
:control: $n-1$ in the place of $n$ in the products
:::
*/
CLAIM(member_is_flatter_in_every_order)
{
    num m = positive(T, "m", 0), r = positive(T, "r", 0), n = add(m, r), one = from_int(1);
    for (int k = 2; k <= 6; k++) {
        num choose = one, product = one, power = one;
        for (int j = 0; j < k; j++) {
            choose = mul(choose, div(sub(n, from_int(j)), from_int(j + 1)));
            product = mul(product, div(sub(one, div(from_int(j), fault(T, n, sub(n, one)))), from_int(j + 1)));
            power = mul(power, n);
        }
        about(T, "C(n,k)/n^k as a product");
        /* C(n,k)/n^k = 1/k! (1 - 1/n) ... (1 - (k-1)/n) */
        same(T, div(choose, power), product);
    }
    num k = whole(T, "k", 2, 9), c = unknown(T, "c", 0), power = positive(T, "N", 0), next = add(k, one);
    about(T, "from k to k + 1");
    same(T, div(div(mul(c, sub(n, k)), next), mul(power, n)), div(mul(sub(one, div(k, n)), div(c, power)), next));
    num j = positive(T, "j", 0), gap = div(mul(j, r), mul(m, n));
    about(T, "one factor of the products");
    /* (1 - j/n) - (1 - j/m) = j r/(m n) */
    same(T, sub(sub(one, div(j, n)), sub(one, div(j, m))), gap);
    G(must_be_positive)(T, gap);
}

#if !FIELD
/*
:::{claim} curvature_of_the_member
:title: The ratio of the curvatures, measured on curves of the plane and of space
:zh: 曲率比的直接计算
:types: rational interval double
:given: weights and points of the plane and of space, $n\ge2$, any $c$, every $r=1,\dots,n-1$
:then: $((n-r)(n-1))^2\,\kappa_{n-r}^2(c)=(n(n-r-1))^2\,\kappa^2(c)$
:method: The second way: the recursion (3.3.2), (3.3.3) for the control points of the member, and the curvatures of both
  curves by the kernel.
:degrees: 2..6 sampled 10
:control: the ratio $\frac{n-r-1}{n-1}$
:::
*/
CLAIM(curvature_of_the_member)
{
    int n = T->degree;
    for (int dim = 2; dim <= 3; dim++)
        for (int r = 1; r < n; r++) {
            num R[3 * MAX_DEGREE + 3], w[MAX_DEGREE + 1], Rr[3 * MAX_DEGREE + 3], wr[MAX_DEGREE + 1];
            num c = parameter(T, "c");
            G(free_curve)(T, n, dim, R, w);
            G(rational_casteljau)(n, dim, R, w, c, r, Rr, wr);
            num left = G(rational_curvature_squared)(n - r, dim, Rr, wr, c);
            num right = G(rational_curvature_squared)(n, dim, R, w, c);
            int p = fault(T, n - r, 1) * (n - 1), q = fault(T, n, 1) * (n - r - 1);
            same(T, mul(from_int((long)p * p), left), mul(from_int((long)q * q), right));
        }
}
#endif

/*
Where may the order $n-r$ come from?  Up to the derivatives of that order member and curve do have much in common:
their homogeneous derivatives are parallel, and with equal weights so are the derivatives themselves.  But for contact
a change of parameter has to make them equal, and it multiplies the second derivative, up to multiples of the first,
by the square of the factor of the first.  Here the factors are $\frac{n-r}n$ and $\frac{(n-r)(n-r-1)}{n(n-1)}$, of
which the second is smaller than the square.

:::{claim} unweighted_derivatives_are_parallel
:title: With equal weights the derivatives of member and curve are parallel in every order
:zh: 权相等时各阶导矢平行
:given: $n\ge1$, points, equal weights, any $c$, every $r=0,\dots,n$ and $k=0,\dots,n-r$
:then: $\frac{n!}{(n-k)!}\,\partial_t^kR^{[n-r]}(c,c)=\frac{(n-r)!}{(n-r-k)!}\,R^{(k)}(c)$
:method: The member by the recursion, the derivatives by those of Bézier curves; one coordinate.
:degrees: 1..6 sampled 12
:over: c
:control: the factors left out
:::
*/
CLAIM(unweighted_derivatives_are_parallel)
{
    int n = T->degree;
    num R[MAX_DEGREE + 1], w[MAX_DEGREE + 1], D[MAX_DEGREE + 1], c = parameter(T, "c");
    for (int i = 0; i <= n; i++) {
        R[i] = unknown(T, "R", i);
        w[i] = from_int(1);
    }
    G(rational_derivatives)(n, 1, R, w, c, n, D);
    for (int r = 0; r <= n; r++) {
        num Rr[MAX_DEGREE + 1], wr[MAX_DEGREE + 1], E[MAX_DEGREE + 1];
        G(rational_casteljau)(n, 1, R, w, c, r, Rr, wr);
        G(rational_derivatives)(n - r, 1, Rr, wr, c, n - r, E);
        for (int k = 0; k <= n - r; k++) {
            long p = fault(T, G(falling_factorial)(n, k), 1), q = fault(T, G(falling_factorial)(n - r, k), 1);
            same(T, mul(from_int(p), E[k]), mul(from_int(q), D[k]));
        }
    }
}

/*
:::{claim} osculating_flats_agree
:title: The homogeneous derivatives of member and curve are parallel: their osculating flats agree
:zh: 齐次导矢平行，密切空间重合
:given: weights and points, any $c$, every $r=0,\dots,n$ and $k=0,\dots,n-r$
:then: $\frac{n!}{(n-k)!}\,\partial_t^kP^{[n-r]}(c,c)=\frac{(n-r)!}{(n-r-k)!}\,P^{(k)}(c)$ for the coordinate and
  for the weight
:method: The member's points and weights by the recursion (3.3.2), (3.3.3); one coordinate.  The factors are not 0, so
  $P,\dots,P^{(k)}$ and the member's derivatives span the same spaces, and the flats of $R$ in them are the same.
:degrees: 1..6 sampled 10
:over: c
:control: the weights of the member taken as 1
:::
*/
CLAIM(osculating_flats_agree)
{
    int n = T->degree;
    num R[MAX_DEGREE + 1], w[MAX_DEGREE + 1], H[2 * MAX_DEGREE + 2], D[2 * MAX_DEGREE + 2], c = parameter(T, "c");
    G(free_curve)(T, n, 1, R, w);
    G(rational_homogenize)(n, 1, R, w, H);
    G(bezier_derivatives)(n, 2, H, c, n, D);
    for (int r = 0; r <= n; r++) {
        num Rr[MAX_DEGREE + 1], wr[MAX_DEGREE + 1], Hr[2 * MAX_DEGREE + 2], E[2 * MAX_DEGREE + 2];
        G(rational_casteljau)(n, 1, R, w, c, r, Rr, wr);
        for (int i = 0; T->faulty && i <= n - r; i++)
            wr[i] = from_int(1);
        G(rational_homogenize)(n - r, 1, Rr, wr, Hr);
        G(bezier_derivatives)(n - r, 2, Hr, c, n - r, E);
        for (int k = 0; k < 2 * (n - r + 1); k++)
            same(T, mul(from_int(G(falling_factorial)(n, k / 2)), E[k]),
                 mul(from_int(G(falling_factorial)(n - r, k / 2)), D[k]));
    }
}

#if RATIONAL
/* The data R, ω and c of a claim on a plane curve of degree n <= 3, with points and weights of the member c of level 1. */
struct G(contact) {
    num R[8], w[4], c, member[6], v[3];
};
static struct G(contact) G(given_contact)(trial *T, int n)
{
    struct G(contact) k;
    given_points(T, "R", n + 1, 2, k.R);
    given_points(T, "ω", n + 1, 1, k.w);
    k.c = given(T, "c");
    G(rational_casteljau)(n, 2, k.R, k.w, k.c, 1, k.member, k.v);
    return k;
}

/*
Each way to understand contact of order $n-r$ now gets its example.

:::{claim} cubic_member_has_other_curvature
:title: The cubic and its quadratic member do not osculate
:zh: 三次曲线与其二次族曲线不密切
:kind: counterexample
:data: R = (0,0) (1/3,0) (2/3,0) (1,1); ω = 1 1 1 1; c = 1
:result: the member's points = (1/3,0) (2/3,0) (1,1); κ² of the curve = 9/250; κ² of the member = 81/4000
:given: the points $R$ of the cubic $(\tau,\tau^3)$ on $[0,1]$, equal weights, and the end $c$; $r=1$, so that the
  member is a quadratic, $n-r=2$
:then: $\kappa^2$ of the curve and of the member differ, so that the contact is not of order 2
:method: The curvatures at the common point are computed exactly.
:control: the curvature of the member multiplied by $\frac{(n-r)(n-1)}{n(n-r-1)}$
:::
*/
CLAIM(cubic_member_has_other_curvature)
{
    enum { n = 3, r = 1 };
    struct G(contact) k = G(given_contact)(T, n);
    num ratio = fault(T, from_ratio((n - r) * (n - 1), n * (n - r - 1)), from_int(1));
    num curve = G(rational_curvature_squared)(n, 2, k.R, k.w, k.c);
    num member = G(rational_curvature_squared)(n - r, 2, k.member, k.v, k.c);
    found_points(T, "the member's points", n - r + 1, 2, k.member);
    found(T, "κ² of the curve", curve);
    found(T, "κ² of the member", member);
    about(T, "the squared curvature, left of the curve, right of the member");
    same(T, curve, mul(mul(ratio, ratio), member));
}

/*
:::{claim} member_runs_slower_than_the_curve
:title: The derivative of the member at the contact is not that of the curve
:zh: 接触点处族曲线的导矢不等于曲线的导矢
:kind: counterexample
:data: R = (0,0) (1,2) (2,0); ω = 1 1 1; c = 1/2
:result: R' of the curve = (2,0); R' of the member = (1,0)
:given: $n=2$, the points $R$ of a parabola, equal weights, the parameter $c$ in the middle, and $r=1$
:then: the derivatives of curve and member at $t=c$ are parallel and not equal
:method: Both are computed exactly; their first coordinates are compared.
:control: the factor $n/(n-r)$ supplied
:::
*/
CLAIM(member_runs_slower_than_the_curve)
{
    enum { n = 2, r = 1 };
    struct G(contact) k = G(given_contact)(T, n);
    num D[4], E[4];
    G(rational_derivatives)(n, 2, k.R, k.w, k.c, 1, D);
    G(rational_derivatives)(n - r, 2, k.member, k.v, k.c, 1, E);
    found_points(T, "R' of the curve", 1, 2, D + 2);
    found_points(T, "R' of the member", 1, 2, E + 2);
    about(T, "the first coordinates of the derivatives");
    same(T, D[2], fault(T, mul(from_ratio(n, n - r), E[2]), E[2]));
}

/* How often τ = c is a root of the equation of the member c of level r of the curve (R, 1) when the point R(τ) is put into
 * it; that polynomial in τ is the result of the given name. */
static int G(multiplicity_of_the_contact)(trial *T, int n, const num R[], int r, num c, const char *name)
{
    num w[MAX_DEGREE + 1], Rr[2 * MAX_DEGREE + 2], wr[MAX_DEGREE + 1];
    for (int i = 0; i <= n; i++)
        w[i] = from_int(1);
    G(rational_casteljau)(n, 2, R, w, c, r, Rr, wr);
    poly value = poly_constant(from_int(0)), linear = poly_sub(poly_variable(), poly_constant(c));
    int degree = n * (n - r), multiplicity = 0;
    for (int k = 0; k <= degree; k++) { /* Lagrange's interpolation at τ = 0, ..., degree */
        num point[2];
        G(rational_point)(n, 2, R, w, from_int(k), point);
        poly basis = poly_constant(G(implicit_value)(n - r, Rr, wr, point[0], point[1]));
        for (int j = 0; j <= degree; j++)
            if (j != k)
                basis = poly_mul(basis, poly_from_q(2, (num[]){from_ratio(-j, k - j), from_ratio(1, k - j)}));
        value = poly_add(value, basis);
    }
    found_text(T, name, poly_to_string(value, "τ"));
    for (; poly_degree(value) > 0 && poly_divides(linear, value); multiplicity++)
        value = poly_quotient(value, linear);
    return multiplicity;
}

/*
:::{claim} cubic_member_meets_the_curve_twice
:title: At the contact the cubic and its member have two coincident intersections, not three
:zh: 接触点处的交点重数为二
:kind: counterexample
:data: R = (0,0) (1/3,0) (2/3,0) (1,1); c = 1/2; r = 1
:result: f(τ) = "-2/9*τ^3 + 1/4*τ^2 - 1/12*τ + 1/144"; multiplicity = 2
:given: the points $R$ of $(\tau,\tau^3)$ on $[0,1]$ with equal weights, the parameter $c$ in the middle, and the level $r$
:let: $f(\tau)$ be the left side of the equation of the member, with the point of the curve inserted
:then: $f$ has $\tau=c$ as a root of multiplicity 2, which is less than $n-r+1$
:method: The equation is the determinant (3.4.1) of the member's control points; its value on the curve is a polynomial
  of degree at most $n(n-r)$, found from one value more; the multiplicity is the number of times $\tau-c$ divides it.
:control: the multiplicity 2
:::
*/
CLAIM(cubic_member_meets_the_curve_twice)
{
    enum { n = 3 };
    num R[2 * n + 2];
    given_points(T, "R", n + 1, 2, R);
    num c = given(T, "c");
    int r = given_whole(T, "r"), multiplicity = G(multiplicity_of_the_contact)(T, n, R, r, c, "f(τ)");
    found_whole(T, "multiplicity", multiplicity);
    about(T, "the multiplicity is n-r+1");
    agree(T, multiplicity == fault(T, 2, n - r + 1));
}

/*
:::{claim} quartic_member_meets_the_curve_twice
:title: At the contact the quartic has two coincident intersections with its members of degree 3 and 1
:zh: 四次曲线与其三次、一次族曲线的接触重数均为二
:kind: counterexample
:data: R = (0,0) (1/4,0) (1/2,0) (3/4,0) (1,1); c = 1/2; r = 1 3
:result: f(τ) = "27/256*τ^4 - 1/8*τ^3 + 3/64*τ^2 - 3/512*τ + 1/4096"; g(τ) = "1/4*τ^4 - 1/8*τ + 3/64"; multiplicities = 2 2
:given: the points $R$ of $(\tau,\tau^4)$ on $[0,1]$ with equal weights, the parameter $c$ in the middle, and two levels $r$
:let: $f(\tau)$ and $g(\tau)$ be the left sides of the equations of the two members, with the point of the curve inserted
:then: both have $\tau=c$ as a root of multiplicity 2, which is not $n-r$
:method: The equation is the determinant (3.4.1) of the member's control points; the multiplicity is the number of times $\tau-c$ divides its
  value on the curve.
:control: the multiplicity 2
:::
*/
CLAIM(quartic_member_meets_the_curve_twice)
{
    enum { n = 4 };
    static const char *const name[2] = {"f(τ)", "g(τ)"};
    num R[2 * n + 2], level[2], found[2];
    given_points(T, "R", n + 1, 2, R);
    num c = given(T, "c");
    given_points(T, "r", 2, 1, level);
    int as_printed = 0;
    for (int k = 0; k < 2; k++) {
        int r = (int)to_double_q(level[k]), multiplicity = G(multiplicity_of_the_contact)(T, n, R, r, c, name[k]);
        found[k] = from_int(multiplicity);
        as_printed += multiplicity == fault(T, 2, n - r);
    }
    found_points(T, "multiplicities", 2, 1, found);
    about(T, "whether one of the two multiplicities is n-r");
    agree(T, as_printed > 0);
}

/*
:::{claim} weighted_member_has_other_directions
:title: With weights the second derivatives of curve and member need not be parallel
:zh: 有权时二阶导矢不平行
:kind: counterexample
:data: R = (0,0) (1,0) (1,1) (0,1); ω = 1 2 1 1; c = 0
:instead: ω = 1 1 1 1
:result: R'' of the curve = (-54,6); R'' of the member = (-22,2); determinant = 24
:given: four points $R$, weights $\omega$ that are not equal, the first parameter $c$, and $r=1$
:then: $R''(c)\times\partial_t^2R^{[n-r]}(c,c)\ne0$
:method: Both derivatives are computed exactly.
:control: equal weights
:::
*/
CLAIM(weighted_member_has_other_directions)
{
    enum { n = 3, r = 1 };
    struct G(contact) k = G(given_contact)(T, n);
    num D[6], E[6];
    G(rational_derivatives)(n, 2, k.R, k.w, k.c, 2, D);
    G(rational_derivatives)(n - r, 2, k.member, k.v, k.c, 2, E);
    num determinant = G(cross2)(D + 4, E + 4);
    found_points(T, "R'' of the curve", 1, 2, D + 4);
    found_points(T, "R'' of the member", 1, 2, E + 4);
    found(T, "determinant", determinant);
    about(T, "the determinant of the two second derivatives");
    vanishes(T, determinant);
}
#endif

#include "chapters/judge/claims_off.h"
