/* kernel_references.h -- what the kernels compute, from definitions, in rationals.
 *
 * Polynomials are taken apart into powers of t, determinants are eliminated, conics are interpolated
 * from six values: nothing here follows the kernels' recurrences, and nothing is fast. */
#define G(name) name##_q
#include "core/number/generic_on.h"

#define REFERENCE(name) static void reference_##name(const struct data_q *D, num out[])

/* ## Polynomials in powers */

static num choose(int n, int k)
{
    mpq_t c;
    mpq_init(c);
    if (0 <= k && k <= n)
        mpz_bin_uiui(mpq_numref(c), (unsigned long)n, (unsigned long)k);
    num value = from_mpq_q(c);
    mpq_clear(c);
    return value;
}
static num power(num a, int k)
{
    num p = from_int(1);
    while (k-- > 0)
        p = mul(p, a);
    return p;
}
/* B_i^n(t) by its definition */
static num basis(int n, int i, num t) { return mul(choose(n, i), mul(power(sub(from_int(1), t), n - i), power(t, i))); }
/* c_k = sum_i b_i C(n,i) C(n-i,k-i) (-1)^{k-i}, coordinate `at` of points of dim coordinates */
static void powers_of(int n, int dim, const num b[], int at, num c[])
{
    for (int k = 0; k <= n; k++) {
        c[k] = from_int(0);
        for (int i = 0; i <= k; i++) {
            num term = mul(b[i * dim + at], mul(choose(n, i), choose(n - i, k - i)));
            c[k] = (k - i) % 2 == 0 ? add(c[k], term) : sub(c[k], term);
        }
    }
}
/* t^k = sum_i C(i,k)/C(n,k) B_i^n(t) */
static void points_of(int n, int dim, const num c[], int at, num b[])
{
    for (int i = 0; i <= n; i++) {
        b[i * dim + at] = from_int(0);
        for (int k = 0; k <= i; k++)
            b[i * dim + at] = add(b[i * dim + at], mul(c[k], div(choose(i, k), choose(n, k))));
    }
}
/* d_j: the coefficients of c(u + h s) in powers of s, by the binomial theorem */
static void compose(int n, const num c[], num u, num h, num d[])
{
    num power_of_u[MAX_DEGREE + 1];
    for (int k = 0; k <= n; k++)
        power_of_u[k] = power(u, k);
    for (int j = 0; j <= n; j++) {
        d[j] = from_int(0);
        for (int k = j; k <= n; k++)
            d[j] = add(d[j], mul(c[k], mul(choose(k, j), power_of_u[k - j])));
        d[j] = mul(d[j], power(h, j));
    }
}
static num factorial(int k) { return k == 0 ? from_int(1) : mul(from_int(k), factorial(k - 1)); }

/* sum c_k t^k, differentiated r times: sum c_k k!/(k-r)! t^{k-r} */
static num derivative_at(int n, const num c[], int r, num t)
{
    num sum = from_int(0);
    for (int k = r; k <= n; k++)
        sum = add(sum, mul(c[k], mul(mul(choose(k, r), factorial(r)), power(t, k - r))));
    return sum;
}

/* The points of the curve from u to v. */
static void on_interval(int n, int dim, const num b[], num u, num v, num out[])
{
    num c[MAX_DEGREE + 1], d[MAX_DEGREE + 1];
    for (int at = 0; at < dim; at++) {
        powers_of(n, dim, b, at, c);
        compose(n, c, u, sub(v, u), d);
        points_of(n, dim, d, at, out);
    }
}
/* The points of the curve in degree n + 1. */
static void elevated(int n, int dim, const num b[], num out[])
{
    num c[MAX_DEGREE + 2];
    for (int at = 0; at < dim; at++) {
        powers_of(n, dim, b, at, c);
        c[n + 1] = from_int(0);
        points_of(n + 1, dim, c, at, out);
    }
}

REFERENCE(bernstein_basis)
{
    for (int i = 0; i <= D->n; i++)
        out[i] = basis(D->n, i, D->t);
}
REFERENCE(bernstein_derivatives)
{
    num unit[MAX_DEGREE + 1], c[MAX_DEGREE + 1];
    for (int i = 0; i <= D->n; i++) {
        for (int j = 0; j <= D->n; j++)
            unit[j] = from_int(i == j);
        powers_of(D->n, 1, unit, 0, c);
        for (int k = 0; k <= D->r; k++)
            out[k * (D->n + 1) + i] = derivative_at(D->n, c, k, D->t);
    }
}
REFERENCE(bernstein_product)
{
    int n = D->n, m = n + D->r <= MAX_DEGREE ? D->r : 0;
    num a[MAX_DEGREE + 1], b[MAX_DEGREE + 1], c[MAX_DEGREE + 1];
    powers_of(n, 1, D->x, 0, a);
    powers_of(m, 1, D->x + n + 1, 0, b);
    for (int k = 0; k <= n + m; k++) {
        c[k] = from_int(0);
        for (int i = 0; i <= n; i++)
            if (0 <= k - i && k - i <= m)
                c[k] = add(c[k], mul(a[i], b[k - i]));
    }
    points_of(n + m, 1, c, 0, out);
}
REFERENCE(bernstein_elevation_matrix)
{
    num unit[MAX_DEGREE + 1], column[MAX_DEGREE + 2];
    for (int j = 0; j <= D->n; j++) {
        for (int i = 0; i <= D->n; i++)
            unit[i] = from_int(i == j);
        elevated(D->n, 1, unit, column);
        for (int i = 0; i <= D->n + 1; i++)
            out[i * (D->n + 1) + j] = column[i];
    }
}
REFERENCE(bernstein_to_power) { powers_of(D->n, 1, D->x, 0, out); }
REFERENCE(bernstein_from_power) { points_of(D->n, 1, D->x, 0, out); }
REFERENCE(bernstein_on_interval)
{
    num a = D->x[0], h = length_q(D); /* f over [a, a+h] */
    on_interval(D->n, 1, D->x + 1, div(sub(D->t, a), h), div(sub(D->u, a), h), out);
}

/* ## Bézier curves */

REFERENCE(bezier_casteljau)
{
    for (int at = 0; at < D->dim; at++) {
        out[at] = from_int(0);
        for (int i = 0; i <= D->n; i++)
            out[at] = add(out[at], mul(basis(D->n, i, D->t), D->x[i * D->dim + at]));
    }
}
REFERENCE(bezier_horner) { reference_bezier_casteljau(D, out); }

REFERENCE(bezier_differences)
{
    int n = D->n, r = D->r % (n + 1);
    num c[MAX_DEGREE + 1];
    for (int at = 0; at < D->dim; at++) {
        powers_of(n, D->dim, D->x, at, c);
        for (int k = 0; k <= n - r; k++)
            c[k] = mul(c[k + r], div(factorial(k + r), factorial(k)));
        points_of(n - r, D->dim, c, at, out);
    }
}
REFERENCE(bezier_derivatives)
{
    num c[MAX_DEGREE + 1];
    for (int at = 0; at < D->dim; at++) {
        powers_of(D->n, D->dim, D->x, at, c);
        for (int k = 0; k <= D->r; k++)
            out[k * D->dim + at] = derivative_at(D->n, c, k, D->t);
    }
}
REFERENCE(bezier_split)
{
    on_interval(D->n, D->dim, D->x, from_int(0), D->t, out);
    on_interval(D->n, D->dim, D->x, D->t, from_int(1), out + (D->n + 1) * D->dim);
}
REFERENCE(bezier_elevate) { elevated(D->n, D->dim, D->x, out); }

/* The polar form of t^k is the k-th elementary symmetric polynomial of the arguments over C(n,k). */
REFERENCE(bezier_blossom)
{
    num c[MAX_DEGREE + 1], e[MAX_DEGREE + 1] = {from_int(1)};
    for (int k = 1; k <= D->n; k++) {
        e[k] = from_int(0);
        for (int j = k; j > 0; j--)
            e[j] = add(e[j], mul(D->w[k - 1], e[j - 1]));
    }
    for (int at = 0; at < D->dim; at++) {
        powers_of(D->n, D->dim, D->x, at, c);
        out[at] = from_int(0);
        for (int k = 0; k <= D->n; k++)
            out[at] = add(out[at], mul(c[k], div(e[k], choose(D->n, k))));
    }
}
REFERENCE(bezier_on_interval) { on_interval(D->n, D->dim, D->x, D->t, D->u, out); }

/* ## Rational Bézier curves */

/* Coordinate `at` of the curve w R of degree n in powers; at = dim is the weight. */
static void numerator(const struct data_q *D, int n, int at, num c[])
{
    num b[MAX_DEGREE + 1];
    for (int i = 0; i <= n; i++)
        b[i] = at < D->dim ? mul(D->w[i], D->x[i * D->dim + at]) : D->w[i];
    powers_of(n, 1, b, 0, c);
}
/* Points and weights from coordinates over the weight, each given by its n+1 Bernstein coefficients. */
static void divide(const struct data_q *D, int n, int at, const num coordinate[], const num weight[], num out[])
{
    for (int i = 0; i <= n; i++) {
        out[i * D->dim + at] = div(coordinate[i], weight[i]);
        out[(n + 1) * D->dim + i] = weight[i];
    }
}
static void rational_on_interval(const struct data_q *D, num u, num v, num out[])
{
    num b[MAX_DEGREE + 1], coordinate[MAX_DEGREE + 1], weight[MAX_DEGREE + 1];
    on_interval(D->n, 1, D->w, u, v, weight);
    for (int at = 0; at < D->dim; at++) {
        for (int i = 0; i <= D->n; i++)
            b[i] = mul(D->w[i], D->x[i * D->dim + at]);
        on_interval(D->n, 1, b, u, v, coordinate);
        divide(D, D->n, at, coordinate, weight, out);
    }
}
/* The first r+1 Taylor coefficients of the quotient of two power series, a(s)/b(s). */
static void series_quotient(int r, const num a[], const num b[], num q[])
{
    for (int k = 0; k <= r; k++) {
        q[k] = a[k];
        for (int j = 0; j < k; j++)
            q[k] = sub(q[k], mul(q[j], b[k - j]));
        q[k] = div(q[k], b[0]);
    }
}
static void rational_taylor(const struct data_q *D, int n, int r, int at, num q[])
{
    num c[MAX_DEGREE + 1], a[MAX_DEGREE + 6], b[MAX_DEGREE + 6];
    for (int k = n + 1; k <= r; k++)
        a[k] = b[k] = from_int(0);
    numerator(D, n, at, c);
    compose(n, c, D->t, from_int(1), a);
    numerator(D, n, D->dim, c);
    compose(n, c, D->t, from_int(1), b);
    series_quotient(r, a, b, q);
}

REFERENCE(rational_homogenize)
{
    for (int i = 0; i <= D->n; i++)
        for (int at = 0; at <= D->dim; at++)
            out[i * (D->dim + 1) + at] = at == D->dim ? D->w[i] : mul(D->x[i * D->dim + at], D->w[i]);
}
REFERENCE(rational_dehomogenize)
{
    for (int i = 0; i <= D->n; i++) {
        num weight = D->x[i * (D->dim + 1) + D->dim];
        for (int at = 0; at < D->dim; at++)
            out[i * D->dim + at] = div(D->x[i * (D->dim + 1) + at], weight);
        out[(D->n + 1) * D->dim + i] = weight;
    }
}
REFERENCE(rational_weight)
{
    out[0] = from_int(0);
    for (int i = 0; i <= D->n; i++)
        out[0] = add(out[0], mul(basis(D->n, i, D->t), D->w[i]));
}
REFERENCE(rational_point)
{
    num weight;
    reference_rational_weight(D, &weight);
    for (int at = 0; at < D->dim; at++) {
        out[at] = from_int(0);
        for (int i = 0; i <= D->n; i++)
            out[at] = add(out[at], mul(mul(basis(D->n, i, D->t), D->w[i]), D->x[i * D->dim + at]));
        out[at] = div(out[at], weight);
    }
}
REFERENCE(rational_derivatives)
{
    num q[MAX_DEGREE + 6];
    for (int at = 0; at < D->dim; at++) {
        rational_taylor(D, D->n, D->r, at, q);
        for (int k = 0; k <= D->r; k++)
            out[k * D->dim + at] = mul(factorial(k), q[k]);
    }
}
/* Level r is a Bernstein sum of degree r over the points i, ..., i+r. */
REFERENCE(rational_casteljau)
{
    int r = D->r % (D->n + 1), n = D->n - r;
    num coordinate[MAX_DEGREE + 1], weight[MAX_DEGREE + 1];
    for (int at = 0; at < D->dim; at++) {
        for (int i = 0; i <= n; i++) {
            coordinate[i] = weight[i] = from_int(0);
            for (int j = 0; j <= r; j++) {
                num share = mul(basis(r, j, D->t), D->w[i + j]);
                weight[i] = add(weight[i], share);
                coordinate[i] = add(coordinate[i], mul(share, D->x[(i + j) * D->dim + at]));
            }
        }
        divide(D, n, at, coordinate, weight, out);
    }
}
REFERENCE(rational_split)
{
    rational_on_interval(D, from_int(0), D->t, out);
    rational_on_interval(D, D->t, from_int(1), out + (D->n + 1) * (D->dim + 1));
}
REFERENCE(rational_elevate)
{
    int n = D->n < MAX_DEGREE ? D->n : MAX_DEGREE - 1;
    num c[MAX_DEGREE + 1], coordinate[MAX_DEGREE + 1], weight[MAX_DEGREE + 1];
    c[n + 1] = from_int(0);
    numerator(D, n, D->dim, c);
    points_of(n + 1, 1, c, 0, weight);
    for (int at = 0; at < D->dim; at++) {
        numerator(D, n, at, c);
        points_of(n + 1, 1, c, 0, coordinate);
        divide(D, n + 1, at, coordinate, weight, out);
    }
}
REFERENCE(rational_reparametrize)
{
    for (int i = 0; i <= D->n; i++)
        out[i] = mul(D->w[i], mul(power(D->x[0], i), power(D->x[1], D->n - i)));
}
REFERENCE(rational_invariants)
{
    for (int i = 1; i < D->n; i++)
        out[i - 1] = div(power(D->w[i], 2), mul(D->w[i - 1], D->w[i + 1]));
}
/* The root of a square of rationals, by integers. */
static num square_root(num a)
{
    mpq_t r;
    mpq_init(r);
    mpz_sqrt(mpq_numref(r), mpq_numref(a.at));
    mpz_sqrt(mpq_denref(r), mpq_denref(a.at));
    num value = from_mpq_q(r);
    mpq_clear(r);
    return value;
}
REFERENCE(conic_standard_weight) { out[0] = div(D->w[1], mul(square_root(D->w[0]), square_root(D->w[2]))); }
REFERENCE(rational_standard_form)
{
    out[0] = out[2] = from_int(1);
    reference_conic_standard_weight(D, out + 1);
}

/* ## Determinants: elimination with pivots */

static num eliminate(int n, const num M[])
{
    num A[2 * MAX_ORDER * MAX_ORDER], det = from_int(1);
    for (int m = 0; m < n * n; m++)
        A[m] = M[m];
    for (int k = 0; k < n; k++) {
        int pivot = k;
        while (pivot < n && cagd_is_zero_q(A[pivot * n + k]))
            pivot++;
        if (pivot == n)
            return from_int(0);
        for (int j = 0; j < n && pivot != k; j++) {
            num held = A[k * n + j];
            A[k * n + j] = A[pivot * n + j];
            A[pivot * n + j] = neg(held);
        }
        det = mul(det, A[k * n + k]);
        for (int i = k + 1; i < n; i++) {
            num ratio = div(A[i * n + k], A[k * n + k]);
            for (int j = k; j < n; j++)
                A[i * n + j] = sub(A[i * n + j], mul(ratio, A[k * n + j]));
        }
    }
    return det;
}
REFERENCE(determinant) { out[0] = eliminate(matrix_order(D->n), D->x); }

/* Row i of the upper block is z^{n-1-i} a(z), row i of the lower one z^{m-1-i} b(z), in powers of z. */
REFERENCE(sylvester)
{
    int order = matrix_order(D->n), m = (order + 1) / 2, n = order - m;
    for (int k = 0; k < order * order; k++)
        out[k] = from_int(0);
    for (int i = 0; i < n; i++)
        for (int k = 0; k <= m; k++)
            out[i * order + i + k] = D->x[k];
    for (int i = 0; i < m; i++)
        for (int k = 0; k <= n; k++)
            out[(n + i) * order + i + k] = D->x[m + 1 + k];
}
/* (x^p y^q - x^q y^p)/(x - y) = the sum of x^i y^j with i + j = p + q - 1 and q <= i, j < p, for p > q. */
REFERENCE(bezout)
{
    int n = matrix_order(D->n);
    const num *a = D->x, *b = D->x + n + 1;
    for (int k = 0; k < n * n; k++)
        out[k] = from_int(0);
    for (int p = 1; p <= n; p++)
        for (int q = 0; q < p; q++) {
            num minor = sub(mul(a[n - p], b[n - q]), mul(a[n - q], b[n - p]));
            for (int i = q; i < p; i++) {
                num *entry = &out[(n - 1 - i) * n + (n - 1 - (p + q - 1 - i))];
                *entry = add(*entry, minor);
            }
        }
}
/* a_0^n b_0^m prod (alpha_i - beta_j) */
static num resultant_of_roots(int m, num a, const num alpha[], int n, num b, const num beta[])
{
    num product = mul(power(a, n), power(b, m));
    for (int i = 0; i < m; i++)
        for (int j = 0; j < n; j++)
            product = mul(product, sub(alpha[i], beta[j]));
    return product;
}
REFERENCE(resultant)
{
    int order = matrix_order(D->n), m = (order + 1) / 2;
    out[0] = resultant_of_roots(m, D->w[0], D->x, order - m, D->w[1], D->x + m);
}
REFERENCE(bezout_resultant)
{
    int n = matrix_order(D->n) / 2 + 1;
    out[0] = resultant_of_roots(n, D->w[0], D->x, n, D->w[1], D->x + n);
}
static void coordinate_less(const struct data_q *D, int n, int axis, num x, num a[])
{
    for (int i = 0; i <= n; i++)
        a[i] = mul(choose(n, i), sub(mul(D->w[i], D->x[2 * i + axis]), mul(D->w[i], x)));
}
REFERENCE(implicit_coefficients) { coordinate_less(D, D->n, 1, D->t, out); }

/* The determinant (3.4.1), entry by entry, by elimination. */
REFERENCE(implicit_value)
{
    int n = (matrix_order(D->n) + 1) / 2;
    num a[MAX_ORDER + 1], b[MAX_ORDER + 1], M[MAX_ORDER * MAX_ORDER];
    coordinate_less(D, n, 0, D->t, a);
    coordinate_less(D, n, 1, D->x[2 * n + 2], b);
    for (int k = 0; k < 4 * n * n; k++)
        M[k] = from_int(0);
    for (int i = 0; i < n; i++)
        for (int k = 0; k <= n; k++) {
            M[i * 2 * n + i + k] = a[k];
            M[(n + i) * 2 * n + i + k] = b[k];
        }
    out[0] = eliminate(2 * n, M);
}

/* ## Vectors, curvature, torsion */

REFERENCE(dot)
{
    out[0] = from_int(0);
    for (int c = 0; c < D->dim; c++)
        out[0] = add(out[0], mul(D->x[c], D->x[D->dim + c]));
}
static num product_of(int dim, const num a[], const num b[])
{
    struct data_q pair = {.dim = dim};
    num x[2 * MAX_DIM], value;
    for (int c = 0; c < dim; c++) {
        x[c] = a[c];
        x[dim + c] = b[c];
    }
    pair.x = x;
    reference_dot(&pair, &value);
    return value;
}
REFERENCE(norm_squared) { out[0] = product_of(D->dim, D->x, D->x); }
REFERENCE(cross2) { out[0] = eliminate(2, D->x); }
REFERENCE(det3) { out[0] = eliminate(3, D->x); }

/* (a x b) . e = det(a, b, e) for each unit vector e */
REFERENCE(cross3)
{
    for (int c = 0; c < 3; c++) {
        num M[9];
        for (int m = 0; m < 9; m++)
            M[m] = m < 6 ? D->x[m] : from_int(m - 6 == c);
        out[c] = eliminate(3, M);
    }
}
static num gram_determinant(int dim, const num a[], const num b[])
{
    num M[4] = {product_of(dim, a, a), product_of(dim, a, b), product_of(dim, a, b), product_of(dim, b, b)};
    return eliminate(2, M);
}
static num curvature_squared_of(int dim, const num d1[], const num d2[])
{
    return div(gram_determinant(dim, d1, d2), power(product_of(dim, d1, d1), 3));
}
/* (d1, d2, d3) over Gram's determinant of d1 and d2 */
static num torsion_of(const num d[]) { return div(eliminate(3, d), gram_determinant(3, d, d + 3)); }

REFERENCE(gram) { out[0] = gram_determinant(D->dim, D->x, D->x + D->dim); }
REFERENCE(curvature_squared) { out[0] = curvature_squared_of(D->dim, D->x, D->x + D->dim); }
REFERENCE(torsion) { out[0] = torsion_of(D->x); }

/* The part of d2 across d1 has length |3b|, and |d1| = |3a|. */
REFERENCE(curvature)
{
    num k = div(D->x[1], mul(from_int(3), power(D->x[0], 2)));
    out[0] = cagd_sign_q(k) < 0 ? neg(k) : k;
}
/* The part of d2 to the left of d1 has length 5b, and |d1| = 5a. */
REFERENCE(signed_curvature) { out[0] = div(D->x[1], mul(from_int(5), power(D->w[0], 2))); }

/* The first three derivatives of a curve of space, row by row. */
static void space_derivatives(const struct data_q *D, int n, num d[])
{
    struct data_q space = *D;
    num q[MAX_DEGREE + 6];
    space.dim = 3;
    for (int at = 0; at < 3; at++) {
        rational_taylor(&space, n, 3, at, q);
        for (int k = 1; k <= 3; k++)
            d[(k - 1) * 3 + at] = mul(factorial(k), q[k]);
    }
}
REFERENCE(rational_curvature_squared)
{
    num d[9];
    space_derivatives(D, D->n + (D->n == 1), d);
    out[0] = curvature_squared_of(3, d, d + 3);
}
REFERENCE(rational_torsion)
{
    num d[9];
    space_derivatives(D, D->n < 3 ? 3 : D->n, d);
    out[0] = torsion_of(d);
}

/* ## Conics: interpolation of a quadratic function of the plane */

typedef num plane_function(const struct data_q *D, num x, num y);

static void interpolate(plane_function *f, const struct data_q *D, num S[])
{
    num zero = from_int(0), one = from_int(1), minus = from_int(-1), half = from_ratio(1, 2);
    num right = f(D, one, zero), left = f(D, minus, zero), up = f(D, zero, one), down = f(D, zero, minus);
    num corner = f(D, one, one);
    S[5] = f(D, zero, zero);
    S[0] = sub(mul(half, add(right, left)), S[5]);
    S[2] = sub(mul(half, add(up, down)), S[5]);
    S[3] = mul(from_ratio(1, 4), sub(right, left));
    S[4] = mul(from_ratio(1, 4), sub(up, down));
    S[1] = mul(half, sub(add(corner, S[5]), add(right, up)));
}
static num on_line(const num l[], num x, num y) { return add(add(mul(l[0], x), mul(l[1], y)), l[2]); }

/* sum over the six monomials x^i y^j */
static num on_conic(const num S[], num x, num y)
{
    num two = from_int(2), sum = S[5];
    sum = add(sum, mul(S[0], power(x, 2)));
    sum = add(sum, mul(two, mul(S[1], mul(x, y))));
    sum = add(sum, mul(S[2], power(y, 2)));
    sum = add(sum, mul(two, mul(S[3], x)));
    return add(sum, mul(two, mul(S[4], y)));
}
static num two_lines(const struct data_q *D, num x, num y) { return mul(on_line(D->x, x, y), on_line(D->x + 3, x, y)); }
static num pencil(const struct data_q *D, num x, num y)
{
    return add(mul(sub(from_int(1), D->t), on_conic(D->x, x, y)), mul(D->t, on_conic(D->x + 6, x, y)));
}
static num three_lines(const struct data_q *D, num x, num y)
{
    num chord = mul(D->t, power(on_line(D->x + 6, x, y), 2));
    return add(mul(sub(from_int(1), D->t), two_lines(D, x, y)), chord);
}
/* The resultant of formula 3.4.1 with the entries 3.4.2, over 4 w_0 w_2. */
static num resultant_form(const struct data_q *D, num x, num y)
{
    num M[16];
    for (int k = 0; k < 16; k++)
        M[k] = from_int(0);
    for (int i = 0; i <= 2; i++) {
        num weight = mul(choose(2, i), D->w[i]);
        M[0 + i] = M[4 + 1 + i] = mul(weight, sub(D->x[2 * i], x));
        M[8 + i] = M[12 + 1 + i] = mul(weight, sub(D->x[2 * i + 1], y));
    }
    return div(eliminate(4, M), mul(from_int(4), mul(D->w[0], D->w[2])));
}
REFERENCE(line_pair) { interpolate(two_lines, D, out); }
REFERENCE(conic_pencil) { interpolate(pencil, D, out); }
REFERENCE(conic_liming) { interpolate(three_lines, D, out); }
REFERENCE(conic_of_bezier) { interpolate(resultant_form, D, out); }

/* det [p 1; q 1; X 1] is l(X): its coefficients are its values at the unit vectors. */
REFERENCE(line_through)
{
    num one = from_int(1);
    for (int c = 0; c < 3; c++) {
        num M[9] = {D->x[0], D->x[1], one, D->x[2], D->x[3], one, from_int(c == 0), from_int(c == 1), from_int(c == 2)};
        out[c] = eliminate(3, M);
    }
}
REFERENCE(conic_value) { out[0] = on_conic(D->x, D->x[6], D->x[7]); }

/* A central difference is exact on quadratics. */
REFERENCE(conic_gradient)
{
    num x = D->x[6], y = D->x[7], half = from_ratio(1, 2), one = from_int(1);
    out[0] = mul(half, sub(on_conic(D->x, add(x, one), y), on_conic(D->x, sub(x, one), y)));
    out[1] = mul(half, sub(on_conic(D->x, x, add(y, one)), on_conic(D->x, x, sub(y, one))));
}
REFERENCE(conic_delta)
{
    num M[4] = {D->x[0], D->x[1], D->x[1], D->x[2]};
    out[0] = eliminate(2, M);
}
REFERENCE(conic_determinant)
{
    const num *S = D->x;
    num M[9] = {S[0], S[1], S[3], S[1], S[2], S[4], S[3], S[4], S[5]};
    out[0] = eliminate(3, M);
}
/* The point at 1/2 of the curve with the weights 1, omega, 1. */
REFERENCE(conic_shoulder_point)
{
    num w[3];
    reference_rational_standard_form(D, w);
    struct data_q standard = {.n = 2, .dim = 2, .x = D->x, .w = w, .t = from_ratio(1, 2)};
    reference_rational_point(&standard, out);
}
/* 1 - sin^2 */
REFERENCE(circular_arc_invariant)
{
    num l = power(D->x[0], 2), h = power(D->x[1], 2);
    out[0] = sub(from_int(1), div(h, add(l, h)));
}
/* (p^2 - q^2)^2 + (2pq)^2 = (p^2 + q^2)^2 */
REFERENCE(circular_arc_weights)
{
    num q = power(D->w[0], 2), p = power(add(D->w[0], D->w[1]), 2);
    out[0] = out[2] = from_int(1);
    out[1] = div(sub(p, q), add(p, q));
}
/* The centre c solves (R_1 - R_0).(c - R_0) = 0 and (R_1 - R_2).(c - R_2) = 0, by Cramer's rule. */
REFERENCE(circular_arc_circle)
{
    num R[6], a[2], b[2];
    isosceles_q(D->x, D->x + 2, D->w[0], R);
    for (int c = 0; c < 2; c++) {
        a[c] = sub(R[2 + c], R[c]);
        b[c] = sub(R[2 + c], R[4 + c]);
    }
    num p = product_of(2, a, R), q = product_of(2, b, R + 4);
    num M[4] = {a[0], a[1], b[0], b[1]}, first[4] = {p, a[1], q, b[1]}, second[4] = {a[0], p, b[0], q};
    out[0] = div(eliminate(2, first), eliminate(2, M));
    out[1] = div(eliminate(2, second), eliminate(2, M));
    num radius[2] = {sub(out[0], R[0]), sub(out[1], R[1])};
    out[2] = product_of(2, radius, radius);
}

/* ## Curves in powers */

/* The coefficients of coordinate `at` of a curve in powers. */
static void coordinate_of(int n, int dim, const num x[], int at, num c[])
{
    for (int k = 0; k <= n; k++)
        c[k] = x[k * dim + at];
}
REFERENCE(power_point)
{
    num c[MAX_DEGREE + 1];
    for (int at = 0; at < D->dim; at++) {
        coordinate_of(D->n, D->dim, D->x, at, c);
        out[at] = derivative_at(D->n, c, 0, D->t);
    }
}
REFERENCE(power_hodograph)
{
    for (int k = 0; k <= D->n; k++)
        for (int at = 0; at < D->dim; at++)
            out[k * D->dim + at] = k < D->n ? mul(from_int(k + 1), D->x[(k + 1) * D->dim + at]) : D->x[k * D->dim + at];
}
REFERENCE(power_derivatives)
{
    num c[MAX_DEGREE + 1];
    for (int at = 0; at < D->dim; at++) {
        coordinate_of(D->n, D->dim, D->x, at, c);
        for (int k = 0; k <= D->r; k++)
            out[k * D->dim + at] = derivative_at(D->n, c, k, D->t);
    }
}
/* The alternating sum of the values at 0, delta, ..., k delta. */
REFERENCE(power_differences)
{
    int n = degree_of_table_q(D);
    num c[MAX_DEGREE + 1];
    for (int at = 0; at < D->dim; at++) {
        coordinate_of(n, D->dim, D->x, at, c);
        for (int k = 0; k <= n; k++) {
            num sum = from_int(0);
            for (int i = 0; i <= k; i++) {
                num term = mul(choose(k, i), derivative_at(n, c, 0, mul(from_int(i), D->t)));
                sum = (k - i) % 2 == 0 ? add(sum, term) : sub(sum, term);
            }
            out[k * D->dim + at] = sum;
        }
    }
}
/* After r steps row k is the sum of C(r, i) step^i times row k + i. */
static void stepped(const struct data_q *D, num step, num out[])
{
    int n = degree_of_table_q(D);
    for (int k = 0; k <= n; k++)
        for (int at = 0; at < D->dim; at++) {
            num sum = from_int(0);
            for (int i = 0; i <= D->r && k + i <= n; i++)
                sum = add(sum, mul(mul(choose(D->r, i), power(step, i)), D->x[(k + i) * D->dim + at]));
            out[k * D->dim + at] = sum;
        }
}
REFERENCE(power_difference_step) { stepped(D, from_int(1), out); }
REFERENCE(power_scaled_difference_step) { stepped(D, D->t, out); }
REFERENCE(power_on_interval)
{
    num c[MAX_DEGREE + 1], d[MAX_DEGREE + 1];
    for (int at = 0; at < D->dim; at++) {
        coordinate_of(D->n, D->dim, D->x, at, c);
        compose(D->n, c, D->t, sub(D->u, D->t), d);
        for (int k = 0; k <= D->n; k++)
            out[k * D->dim + at] = d[k];
    }
}

/* ## Plane cubics */

REFERENCE(cubic_minors)
{
    num AB[4] = {D->x[6], D->x[7], D->x[4], D->x[5]}, AC[4] = {D->x[6], D->x[7], D->x[2], D->x[3]};
    out[0] = eliminate(2, AB);
    out[1] = eliminate(2, AC);
    out[2] = neg(eliminate(2, D->x + 2)); /* B x C, where x has C before B */
}
/* P' x P'' at 0, 1 and -1 gives its three coefficients. */
REFERENCE(cubic_inflection_polynomial)
{
    num c[2][4], value[3];
    for (int j = 0; j < 2; j++)
        coordinate_of(3, 2, D->x, j, c[j]);
    for (int i = 0; i < 3; i++) {
        num t = from_int(i == 2 ? -1 : i), d[4];
        for (int k = 0; k < 4; k++)
            d[k] = derivative_at(3, c[k % 2], 1 + k / 2, t);
        value[i] = eliminate(2, d);
    }
    num half = from_ratio(1, 2);
    out[0] = value[0];
    out[1] = mul(half, sub(value[1], value[2]));
    out[2] = sub(mul(half, add(value[1], value[2])), value[0]);
}
/* A twelfth of the discriminant of P' x P''. */
REFERENCE(cubic_delta)
{
    num f[3];
    reference_cubic_inflection_polynomial(D, f);
    out[0] = div(sub(mul(f[1], f[1]), mul(from_int(4), mul(f[0], f[2]))), from_int(12));
}
/* a^2 times the polynomial with the sum -b/a and the product b^2/a^2 - c/a of its roots. */
REFERENCE(cubic_double_point_polynomial)
{
    num m[3];
    reference_cubic_minors(D, m);
    num p = div(m[1], m[0]), square = power(m[0], 2);
    out[2] = square;
    out[1] = mul(square, p);
    out[0] = mul(square, sub(mul(p, p), div(m[2], m[0])));
}
REFERENCE(cubic_double_point)
{
    out[0] = D->x[0];
    out[1] = D->x[1];
}

/* ## The family with a shape parameter, in powers of t */

static num shape_shift(int n, int i) { return sub(choose(n - 2, i - 1), choose(n - 2, i - 2)); }

/* The coefficient of t^k in (1-t)^a t^b. */
static num in_product(int a, int b, int k)
{
    num c = choose(a, k - b);
    return (k - b) % 2 == 0 ? c : neg(c);
}
/* ... in C(n,i) s^{n-i} t^i + beta (a_i s^{n+1-i} t^i - a_{i+1} s^{n-i} t^{i+1}). */
static num in_shape_function(int n, int i, num beta, int k)
{
    num slope = sub(mul(shape_shift(n, i), in_product(n + 1 - i, i, k)),
                    mul(shape_shift(n, i + 1), in_product(n - i, i + 1, k)));
    return add(mul(choose(n, i), in_product(n - i, i, k)), mul(beta, slope));
}
/* Formula (1), line by line: the numbers a, b, c of a + b beta + c beta t. */
static num in_printed_function(int i, num beta, int k)
{
    static const int a[] = {1, 7, 21, 35, 35, 21, 7, 1}, b[] = {0, 1, 4, 5, 0, -5, -4, -1};
    static const int c[] = {-1, -5, -9, -9, 1, 9, 5, 1};
    num constant = add(from_int(a[i]), mul(from_int(b[i]), beta)), linear = mul(from_int(c[i]), beta);
    return add(mul(constant, in_product(7 - i, i, k)), mul(linear, in_product(7 - i, i, k - 1)));
}
/* c_0, ..., c_{n+1} of the curve's coordinate `at`; the printed functions for n = 0. */
static void shape_powers(int n, int dim, const num P[], num beta, int at, num c[])
{
    int last = n == 0 ? 7 : n;
    for (int k = 0; k <= last + 1; k++) {
        c[k] = from_int(0);
        for (int i = 0; i <= last; i++) {
            num part = n == 0 ? in_printed_function(i, beta, k) : in_shape_function(n, i, beta, k);
            c[k] = add(c[k], mul(P[i * dim + at], part));
        }
    }
}
static void shape_functions(int n, num beta, num t, num out[])
{
    int last = n == 0 ? 7 : n;
    for (int i = 0; i <= last; i++) {
        num c[MAX_DEGREE + 2];
        for (int k = 0; k <= last + 1; k++)
            c[k] = n == 0 ? in_printed_function(i, beta, k) : in_shape_function(n, i, beta, k);
        out[i] = derivative_at(last + 1, c, 0, t);
    }
}
REFERENCE(shape_factors)
{
    int n = shape_degree_q(D->n);
    for (int i = 0; i <= n; i++) {
        out[i] = add(choose(n, i), mul(shape_shift(n, i), D->x[0]));
        out[n + 1 + i] = sub(choose(n, i), mul(shape_shift(n, i + 1), D->x[0]));
    }
}
REFERENCE(shape_factors_printed)
{
    for (int i = 0; i <= 7; i++) {
        num first = in_printed_function(i, D->x[0], i), next = in_printed_function(i, D->x[0], i + 1);
        out[i] = first;
        out[8 + i] = add(first, add(next, mul(from_int(7 - i), first)));
    }
}
REFERENCE(shape_basis) { shape_functions(shape_degree_q(D->n), D->x[0], D->t, out); }
REFERENCE(shape_basis_printed) { shape_functions(0, D->x[0], D->t, out); }
/* Column i: the coefficients of (near_i s + far_i t) s^{n-i} t^i in the Bernstein basis, from its powers. */
REFERENCE(shape_matrix)
{
    int n = shape_degree_q(D->n);
    for (int i = 0; i <= n; i++) {
        num c[MAX_DEGREE + 2], b[MAX_DEGREE + 2];
        for (int k = 0; k <= n + 1; k++)
            c[k] = add(mul(D->x[i], in_product(n + 1 - i, i, k)), mul(D->x[n + 1 + i], in_product(n - i, i + 1, k)));
        points_of(n + 1, 1, c, 0, b);
        for (int k = 0; k <= n + 1; k++)
            out[k * (n + 1) + i] = b[k];
    }
}
REFERENCE(shape_bezier_points)
{
    int n = shape_degree_q(D->n);
    num c[MAX_DEGREE + 2];
    for (int at = 0; at < D->dim; at++) {
        shape_powers(n, D->dim, D->x + 1, D->x[0], at, c);
        points_of(n + 1, D->dim, c, at, out);
    }
}
static void shape_values(int n, const struct data_q *D, int r, num out[])
{
    num c[MAX_DEGREE + 2];
    for (int k = 0; k <= r; k++)
        for (int at = 0; at < D->dim; at++) {
            shape_powers(n, D->dim, D->x + 1, D->x[0], at, c);
            out[k * D->dim + at] = derivative_at((n == 0 ? 7 : n) + 1, c, k, D->t);
        }
}
REFERENCE(shape_point) { shape_values(shape_degree_q(D->n), D, 0, out); }
REFERENCE(shape_point_printed) { shape_values(0, D, 0, out); }
REFERENCE(shape_derivatives) { shape_values(shape_degree_q(D->n), D, D->r, out); }
REFERENCE(shape_surface_point)
{
    num B[4], C[3];
    shape_functions(3, D->x[0], D->t, B);
    shape_functions(2, D->x[1], D->u, C);
    for (int at = 0; at < D->dim; at++) {
        out[at] = from_int(0);
        for (int i = 0; i <= 3; i++)
            for (int j = 0; j <= 2; j++)
                out[at] = add(out[at], mul(D->x[2 + (i * 3 + j) * D->dim + at], mul(B[i], C[j])));
    }
}

#include "proofs-tests/unit/spline_references.h"
#include "proofs-tests/unit/matrix_references.h"
#include "proofs-tests/unit/surface_references.h"

typedef void reference(const struct data_q *D, num out[]);
#define ENTRY(name) reference_##name,
static reference *const references[] = {ALL_KERNELS(ENTRY)};
#undef ENTRY
#undef REFERENCE
#include "core/number/generic_off.h"
#undef G
