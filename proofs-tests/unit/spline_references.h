/* spline_references.h -- what the kernels on B-splines compute; a part of kernel_references.h.
 *
 * A segment is the one polynomial whose polar form at the consecutive knots u_{i+1}, ..., u_{i+p} has the values c_i: its
 * powers of t are the solution of a linear system.  No recursion of de Boor and Cox. */

/* e_k of the numbers x_0, ..., x_{p-1} over C(p,k), k = 0, ..., p. */
static void symmetric_means(int p, const num x[], num e[])
{
    for (int k = 0; k <= p; k++)
        e[k] = from_int(k == 0);
    for (int i = 0; i < p; i++)
        for (int k = i + 1; k > 0; k--)
            e[k] = add(e[k], mul(x[i], e[k - 1]));
    for (int k = 0; k <= p; k++)
        e[k] = div(e[k], choose(p, k));
}
static num polar(int p, const num a[], const num x[])
{
    num e[MAX_DEGREE + 1], sum = from_int(0);
    symmetric_means(p, x, e);
    for (int k = 0; k <= p; k++)
        sum = add(sum, mul(a[k], e[k]));
    return sum;
}
/* Cramer's rule for n unknowns. */
static void solve(int n, const num M[], const num right[], num a[])
{
    num N[MAX_ORDER * MAX_ORDER], det = eliminate(n, M);
    for (int k = 0; k < n; k++) {
        for (int i = 0; i < n * n; i++)
            N[i] = i % n == k ? right[i / n] : M[i];
        a[k] = div(eliminate(n, N), det);
    }
}
/* The segment of span mu with the coefficients c_{mu-p}, ..., c_mu, in powers of t. */
static void segment_of(const struct knotted_q *S, const num c[], num a[])
{
    num M[MAX_ORDER * MAX_ORDER];
    for (int i = 0; i <= S->p; i++)
        symmetric_means(S->p, S->u + S->mu - S->p + i + 1, M + i * (S->p + 1));
    solve(S->p + 1, M, c, a);
}
/* Coordinate `at` of it; at = dim is the weight, times_weight multiplies the points by their weights. */
static void spline_coordinate(const struct data_q *D, const struct knotted_q *S, int dim, int at, int times_weight,
                              num a[])
{
    num c[8];
    for (int i = 0; i <= S->p; i++) {
        int from = S->mu - S->p + i;
        c[i] = at == dim ? D->w[from] : D->x[from * dim + at];
        if (times_weight && at < dim)
            c[i] = mul(c[i], D->w[from]);
    }
    segment_of(S, c, a);
}

REFERENCE(bezier_reduce)
{
    int n = D->n, middle = n / 2;
    num c[MAX_DEGREE + 1], low[MAX_DEGREE + 1];
    for (int at = 0; at < D->dim; at++) { /* the polynomial without the part c_n t^n, but for the middle coefficient */
        powers_of(n, D->dim, D->x, at, c);
        num defect = div(c[n], choose(n, middle));
        out[n * D->dim + at] = (n - middle) % 2 == 0 ? defect : neg(defect);
        num e[(MAX_DEGREE + 1)];
        for (int i = 0; i <= n; i++)
            e[i] = D->x[i * D->dim + at];
        e[middle] = sub(e[middle], out[n * D->dim + at]);
        powers_of(n, 1, e, 0, low);
        points_of(n - 1, D->dim, low, at, out);
    }
}
REFERENCE(bspline_basis)
{
    struct knotted_q S = knotted_of_q(D);
    num c[8], a[8];
    for (int m = 0; m <= S.p; m++) {
        for (int i = 0; i <= S.p; i++)
            c[i] = from_int(i == m);
        segment_of(&S, c, a);
        out[m] = derivative_at(S.p, a, 0, S.t);
    }
}
REFERENCE(bspline_basis_derivatives)
{
    struct knotted_q S = knotted_of_q(D);
    num c[8], a[8];
    for (int m = 0; m <= S.p; m++) {
        for (int i = 0; i <= S.p; i++)
            c[i] = from_int(i == m);
        segment_of(&S, c, a);
        for (int r = 0; r <= D->r; r++)
            out[r * (S.p + 1) + m] = derivative_at(S.p, a, r, S.t);
    }
}
REFERENCE(bspline_discrete)
{
    struct knotted_q S = knotted_of_q(D);
    num c[8], a[8];
    for (int m = 0; m <= S.p; m++) {
        for (int i = 0; i <= S.p; i++)
            c[i] = from_int(i == m);
        segment_of(&S, c, a);
        out[m] = polar(S.p, a, D->x);
    }
}
REFERENCE(bspline_blossom)
{
    struct knotted_q S = knotted_of_q(D);
    num a[8];
    for (int at = 0; at < D->dim; at++) {
        spline_coordinate(D, &S, D->dim, at, 0, a);
        out[at] = polar(S.p, a, D->w);
    }
}
REFERENCE(bspline_derivatives)
{
    struct knotted_q S = knotted_of_q(D);
    num a[8];
    for (int at = 0; at < D->dim; at++) {
        spline_coordinate(D, &S, D->dim, at, 0, a);
        for (int r = 0; r <= D->r; r++)
            out[r * D->dim + at] = derivative_at(S.p, a, r, S.t);
    }
}
REFERENCE(bspline_deboor)
{
    struct data_q E = *D;
    num rows[6 * MAX_DIM];
    reference_bspline_derivatives(&E, rows);
    for (int at = 0; at < D->dim; at++)
        out[at] = rows[at];
}
REFERENCE(bspline_difference)
{
    struct knotted_q S = knotted_of_q(D);
    num a[8];
    if (D->r % 2 == 1 && S.p == 1) {
        out[0] = from_int(0);
        return;
    }
    for (int at = 0; at < D->dim; at++) {
        spline_coordinate(D, &S, D->dim, at, 0, a);
        out[at] = derivative_at(S.p, a, 1, S.t);
    }
}
REFERENCE(bspline_greville)
{
    struct knotted_q S = knotted_of_q(D);
    num e[8];
    for (int i = 0; i < S.n; i++) {
        symmetric_means(S.p, S.u + i + 1, e);
        out[i] = e[1];
    }
}
/* Point j, of the knots v_{j+1}, ..., v_{j+p}, is c_at where these are knots u_{at+1}, ..., and a value of the polar form where
 * t is among them. */
static void new_points(const struct data_q *D, const struct knotted_q *S, const num v[], int times, num out[])
{
    num a[8];
    for (int j = 0; j < S->n + times; j++)
        for (int at = 0; at < D->dim; at++) {
            spline_coordinate(D, S, D->dim, at, 0, a);
            out[j * D->dim + at] = j + S->p <= S->mu    ? D->x[j * D->dim + at]
                                   : j >= S->mu + times ? D->x[(j - times) * D->dim + at]
                                                        : polar(S->p, a, v + j + 1);
        }
}
REFERENCE(bspline_insert)
{
    struct knotted_q S = knotted_of_q(D);
    for (int i = 0; i <= S.n + S.p + 1; i++)
        out[i] = i <= S.mu ? S.u[i] : i == S.mu + 1 ? S.t : S.u[i - 1];
    new_points(D, &S, out, 1, out + S.n + S.p + 2);
}
REFERENCE(bspline_remove)
{
    struct knotted_q S = knotted_of_q(D);
    int knots = S.n + S.p + 1;
    for (int i = 0; i < knots + (S.n + 1) * D->dim; i++)
        out[i] = i < knots ? S.u[i] : i < knots + S.n * D->dim ? D->x[i - knots] : from_int(0);
}
REFERENCE(bspline_refine)
{
    struct knotted_q S = knotted_of_q(D);
    num v[32];
    int span[32];
    refined_knots_q(&S, v, span);
    new_points(D, &S, v, 2, out);
}
REFERENCE(bspline_elevate) { reference_bspline_deboor(D, out); }
REFERENCE(bspline_reduce)
{
    struct knotted_q S = knotted_of_q(D);
    for (int i = 0; i < S.n * D->dim; i++)
        out[i] = D->x[i];
}
REFERENCE(bspline_to_bezier)
{
    struct knotted_q S = knotted_of_q(D);
    num a[8], local[8];
    for (int at = 0; at < D->dim; at++) {
        spline_coordinate(D, &S, D->dim, at, 0, a);
        compose(S.p, a, S.u[S.mu], sub(S.u[S.mu + 1], S.u[S.mu]), local);
        points_of(S.p, D->dim, local, at, out);
    }
}
REFERENCE(bspline_point_of_bezier)
{
    int p = D->n < 7 ? D->n : 7;
    num c[8], a[8], length = length_q(D);
    for (int at = 0; at < D->dim; at++) { /* in powers of (t - x_0)/w_0, then in powers of t */
        powers_of(p, D->dim, D->x, at, c);
        compose(p, c, neg(div(D->x[0], length)), div(from_int(1), length), a);
        out[at] = polar(p, a, D->w);
    }
}
REFERENCE(bspline_split)
{
    struct knotted_q S = knotted_of_q(D);
    num a[8], v[32];
    int lefts = S.mu + 1, rights = S.n - S.mu + S.p;
    for (int at = 0; at < D->dim; at++) {
        spline_coordinate(D, &S, D->dim, at, 0, a);
        for (int i = 0; i < lefts + S.p + 1; i++)
            v[i] = i < lefts ? S.u[i] : S.t;
        for (int i = 0; i < lefts; i++)
            out[i * D->dim + at] = i + S.p <= S.mu ? D->x[i * D->dim + at] : polar(S.p, a, v + i + 1);
        for (int i = 0; i < rights + S.p + 1; i++)
            v[i] = i <= S.p ? S.t : S.u[S.mu + i - S.p];
        for (int i = 0; i < rights; i++)
            out[(lefts + i) * D->dim + at] = i >= S.p ? D->x[(S.mu - S.p + i) * D->dim + at] : polar(S.p, a, v + i + 1);
    }
}
REFERENCE(bspline_periodic)
{
    struct knotted_q S = knotted_of_q(D);
    int m = S.n;
    num period = sub(S.u[m], S.u[0]);
    for (int j = -S.p; j <= m + S.p; j++) { /* j = k + around m, 0 <= k < m */
        int around = j < 0 ? -1 : j / m, k = j - around * m;
        out[j + S.p] = add(S.u[k], mul(from_int(around), period));
    }
    for (int i = 0; i < m + S.p; i++)
        for (int at = 0; at < D->dim; at++)
            out[m + 2 * S.p + 1 + i * D->dim + at] = D->x[(i < m ? i : i - m) * D->dim + at];
}

/* The first rows Taylor coefficients at t of coordinate `at` of the NURBS curve. */
static void nurbs_taylor(const struct data_q *D, const struct knotted_q *S, int dim, int rows, int at, num q[])
{
    num c[8], a[16], b[16];
    for (int k = 0; k < 16; k++)
        a[k] = b[k] = from_int(0);
    spline_coordinate(D, S, dim, at, 1, c);
    compose(S->p, c, S->t, from_int(1), a);
    spline_coordinate(D, S, dim, dim, 0, c);
    compose(S->p, c, S->t, from_int(1), b);
    series_quotient(rows - 1, a, b, q);
}
REFERENCE(nurbs_weight)
{
    struct knotted_q S = knotted_of_q(D);
    num a[8];
    spline_coordinate(D, &S, D->dim, D->dim, 0, a);
    out[0] = derivative_at(S.p, a, 0, S.t);
}
REFERENCE(nurbs_point)
{
    struct knotted_q S = knotted_of_q(D);
    for (int at = 0; at < D->dim; at++)
        nurbs_taylor(D, &S, D->dim, 1, at, out + at);
}
REFERENCE(nurbs_deboor) { reference_nurbs_point(D, out); }
REFERENCE(nurbs_derivatives)
{
    struct knotted_q S = knotted_of_q(D);
    num q[16];
    for (int at = 0; at < D->dim; at++) {
        nurbs_taylor(D, &S, D->dim, D->r + 1, at, q);
        for (int k = 0; k <= D->r; k++)
            out[k * D->dim + at] = mul(factorial(k), q[k]);
    }
}
/* Derivatives 1, 2, 3 of the curve in space, row by row. */
static void nurbs_moving_frame(const struct data_q *D, const struct knotted_q *S, num d[3][3])
{
    num q[16];
    for (int at = 0; at < 3; at++) {
        nurbs_taylor(D, S, 3, 4, at, q);
        for (int k = 1; k <= 3; k++)
            d[k - 1][at] = mul(factorial(k), q[k]);
    }
}
/* |a x b|^2 as the sum of its three squares. */
static num squared_area(const num a[3], const num b[3])
{
    num sum = from_int(0);
    for (int c = 0; c < 3; c++) {
        num minor = sub(mul(a[(c + 1) % 3], b[(c + 2) % 3]), mul(a[(c + 2) % 3], b[(c + 1) % 3]));
        sum = add(sum, power(minor, 2));
    }
    return sum;
}
REFERENCE(nurbs_curvature_squared)
{
    struct knotted_q S = knotted_of_q(D);
    num d[3][3], speed = from_int(0);
    nurbs_moving_frame(D, &S, d);
    for (int c = 0; c < 3; c++)
        speed = add(speed, power(d[0][c], 2));
    out[0] = div(squared_area(d[0], d[1]), power(speed, 3));
}
REFERENCE(nurbs_torsion)
{
    struct data_q E = *D;
    E.n = D->n < 3 ? 3 : D->n;
    struct knotted_q S = knotted_of_q(&E);
    num d[3][3];
    nurbs_moving_frame(D, &S, d);
    out[0] = div(eliminate(3, &d[0][0]), squared_area(d[0], d[1]));
}
REFERENCE(nurbs_insert)
{
    struct knotted_q S = knotted_of_q(D);
    num a[8], v[32];
    for (int i = 0; i <= S.n + S.p + 1; i++)
        v[i] = i <= S.mu ? S.u[i] : i == S.mu + 1 ? S.t : S.u[i - 1];
    for (int j = 0; j <= S.n; j++) {
        int kept = j + S.p <= S.mu ? j : j > S.mu ? j - 1 : -1;
        spline_coordinate(D, &S, D->dim, D->dim, 0, a);
        num weight = kept >= 0 ? D->w[kept] : polar(S.p, a, v + j + 1);
        out[(S.n + 1) * D->dim + j] = weight;
        for (int at = 0; at < D->dim; at++) {
            spline_coordinate(D, &S, D->dim, at, 1, a);
            out[j * D->dim + at] = kept >= 0 ? D->x[kept * D->dim + at] : div(polar(S.p, a, v + j + 1), weight);
        }
    }
}
/* Six Taylor coefficients at t of w_m N_m, m = 0, ..., p, and of their sum w. */
static void weighted_basis(const struct data_q *D, const struct knotted_q *S, num term[][16], num w[16])
{
    num c[8], a[8];
    for (int k = 0; k < 16; k++)
        w[k] = from_int(0);
    for (int m = 0; m <= S->p; m++) {
        for (int k = 0; k < 16; k++)
            term[m][k] = from_int(0);
        for (int i = 0; i <= S->p; i++)
            c[i] = i == m ? D->w[S->mu - S->p + i] : from_int(0);
        segment_of(S, c, a);
        compose(S->p, a, S->t, from_int(1), term[m]);
        for (int k = 0; k < 6; k++)
            w[k] = add(w[k], term[m][k]);
    }
}
/* Six coefficients of the product of two series. */
static void series_product(const num a[], const num b[], num c[])
{
    for (int k = 0; k < 6; k++) {
        c[k] = from_int(0);
        for (int j = 0; j <= k; j++)
            c[k] = add(c[k], mul(a[j], b[k - j]));
    }
}
REFERENCE(nurbs_basis)
{
    struct knotted_q S = knotted_of_q(D);
    num term[8][16], w[16], q[16];
    weighted_basis(D, &S, term, w);
    for (int m = 0; m <= S.p; m++) {
        series_quotient(D->r, term[m], w, q);
        for (int k = 0; k <= D->r; k++)
            out[k * (S.p + 1) + m] = mul(factorial(k), q[k]);
    }
}
/* The quotient rule for w_m N_m / w: w_k d/dw_k of it. */
REFERENCE(nurbs_basis_by_weights)
{
    struct knotted_q S = knotted_of_q(D);
    num term[8][16], w[16];
    weighted_basis(D, &S, term, w);
    for (int m = 0; m <= S.p; m++)
        for (int k = 0; k <= S.p; k++) {
            num above = m == k ? mul(term[m][0], w[0]) : from_int(0);
            above = sub(above, mul(term[m][0], term[k][0]));
            out[m * (S.p + 1) + k] = div(above, mul(w[0], w[0]));
        }
}
/* The quotient rule for A/w, A = sum w_m N_m P_m, as series: (A_m w - A w_m)/w^2 with A_m = w_m N_m P_m. */
REFERENCE(nurbs_by_weights)
{
    struct knotted_q S = knotted_of_q(D);
    num term[8][16], w[16], A[16], own[16], one[16], two[16], below[16], q[16];
    weighted_basis(D, &S, term, w);
    series_product(w, w, below);
    for (int at = 0; at < D->dim; at++) {
        const num *x = D->x + (S.mu - S.p) * D->dim + at;
        for (int k = 0; k < 6; k++) {
            A[k] = from_int(0);
            for (int m = 0; m <= S.p; m++)
                A[k] = add(A[k], mul(term[m][k], x[m * D->dim]));
        }
        for (int m = 0; m <= S.p; m++) {
            for (int k = 0; k < 6; k++)
                own[k] = mul(term[m][k], x[m * D->dim]);
            series_product(own, w, one);
            series_product(A, term[m], two);
            for (int k = 0; k < 6; k++)
                one[k] = sub(one[k], two[k]);
            series_quotient(D->r, one, below, q);
            for (int k = 0; k <= D->r; k++)
                out[(k * (S.p + 1) + m) * D->dim + at] = mul(factorial(k), q[k]);
        }
    }
}
/* The same twice: A_mk/w - (A_m w_k + A_k w_m + A w_mk)/w^2 + 2 A w_m w_k/w^3. */
REFERENCE(nurbs_by_two_weights)
{
    struct knotted_q S = knotted_of_q(D);
    num term[8][16], w[16];
    weighted_basis(D, &S, term, w);
    for (int at = 0; at < D->dim; at++) {
        const num *x = D->x + (S.mu - S.p) * D->dim + at;
        num A = from_int(0), part[8];
        for (int m = 0; m <= S.p; m++) {
            part[m] = mul(term[m][0], x[m * D->dim]);
            A = add(A, part[m]);
        }
        for (int m = 0; m <= S.p; m++)
            for (int k = 0; k <= S.p; k++) {
                num zero = from_int(0), first = m == k ? part[m] : zero, weight = m == k ? term[m][0] : zero;
                num second = add(add(mul(part[m], term[k][0]), mul(part[k], term[m][0])), mul(A, weight));
                num third = mul(mul(from_int(2), A), mul(term[m][0], term[k][0]));
                out[(m * (S.p + 1) + k) * D->dim + at] =
                    add(sub(div(first, w[0]), div(second, power(w[0], 2))), div(third, power(w[0], 3)));
            }
    }
}
