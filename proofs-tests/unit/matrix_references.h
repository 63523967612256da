/* matrix_references.h -- what the kernels on divided differences and coefficient matrices compute; a part of
 * kernel_references.h.
 *
 * Interpolation is a linear system, a B-spline is the polynomial whose polar form is 1 at its own knots and 0 at those of
 * its neighbours, a symmetric function is a sum over subsets. */

/* Row b(i,j): the j-th derivatives of 1, t, ..., t^n at tau_i. */
static void osculation(const struct nodes_q *S, num H[])
{
    for (int i = 0, row = 0; i < S->d; i++)
        for (int j = 0; j < S->l[i]; j++, row++)
            for (int c = 0; c <= S->n; c++)
                H[row * (S->n + 1) + c] =
                    c < j ? from_int(0) : mul(div(factorial(c), factorial(c - j)), power(S->tau[i], c - j));
}
REFERENCE(confluent_vandermonde)
{
    struct nodes_q S = nodes_of_q(D);
    osculation(&S, out);
}
REFERENCE(confluent_vandermonde_determinant)
{
    num H[64];
    struct nodes_q S = nodes_of_q(D);
    osculation(&S, H);
    out[0] = eliminate(S.n + 1, H);
}
REFERENCE(divided_difference)
{
    num H[64], a[8];
    struct nodes_q S = nodes_of_q(D);
    osculation(&S, H);
    solve(S.n + 1, H, D->x + 1, a);
    out[0] = a[S.n];
}
/* The weights give 0 for 1, ..., t^{n-1} and 1 for t^n. */
REFERENCE(divided_weights)
{
    num H[64], transposed[64], right[8];
    struct nodes_q S = nodes_of_q(D);
    int k = S.n + 1;
    osculation(&S, H);
    for (int m = 0; m < k * k; m++)
        transposed[m] = H[m % k * k + m / k];
    for (int m = 0; m < k; m++)
        right[m] = from_int(m == S.n);
    solve(k, transposed, right, out);
}

/* Column c of the coefficient matrix, the rows `step` numbers apart. */
static void matrix_column(const struct knotted_q *S, int c, int step, num out[])
{
    num unit[8], a[8], b[8];
    for (int m = 0; m <= S->p; m++)
        unit[m] = from_int(m == c);
    segment_of(S, unit, a);
    compose(S->p, a, S->u[S->mu], sub(S->u[S->mu + 1], S->u[S->mu]), b);
    for (int j = 0; j <= S->p; j++)
        out[j * step] = b[j];
}
static void matrix_of(const struct knotted_q *S, num out[])
{
    for (int c = 0; c <= S->p; c++)
        matrix_column(S, c, S->p + 1, out + c);
}
static void matrix_of_data(const struct data_q *D, num out[])
{
    struct knotted_q S = knotted_of_q(D);
    matrix_of(&S, out);
}
REFERENCE(bspline_matrix) { matrix_of_data(D, out); }
REFERENCE(bspline_matrix_by_differences) { matrix_of_data(D, out); }
REFERENCE(bspline_matrix_by_marsden) { matrix_of_data(D, out); }
REFERENCE(bspline_matrix_simple)
{
    struct knotted_q S = simple_knotted_of_q(D);
    matrix_of(&S, out);
}
REFERENCE(bspline_matrix_uniform)
{
    struct knotted_q S = {.p = D->n < 6 ? D->n : 6};
    S.mu = S.p;
    for (int i = 0; i < 2 * S.p + 2; i++)
        S.u[i] = from_int(i);
    matrix_of(&S, out);
}
REFERENCE(bspline_column_by_differences)
{
    struct knotted_q S = knotted_of_q(D);
    matrix_column(&S, S.p - D->r % (S.p + 1), 1, out);
}
REFERENCE(bernstein_matrix)
{
    int p = D->n < 8 ? D->n : 8;
    num unit[9], c[9];
    for (int i = 0; i <= p; i++) {
        for (int m = 0; m <= p; m++)
            unit[m] = from_int(m == i);
        powers_of(p, 1, unit, 0, c);
        for (int k = 0; k <= p; k++)
            out[k * (p + 1) + i] = c[k];
    }
}

/* The sum of the products of j of the numbers x_0, ..., x_{n-1}, over all subsets. */
static num sum_over_subsets(int n, int j, const num x[])
{
    num sum = from_int(0);
    for (int subset = 0; subset < 1 << n; subset++) {
        num product = from_int(1);
        int size = 0;
        for (int i = 0; i < n; i++)
            if (subset >> i & 1)
                product = mul(product, x[i]), size++;
        if (size == j)
            sum = add(sum, product);
    }
    return sum;
}
REFERENCE(elementary_symmetric)
{
    int n = D->n < 7 ? D->n : 7;
    for (int j = 0; j <= n; j++)
        out[j] = sum_over_subsets(n, j, D->x);
}
REFERENCE(marsden_matrix)
{
    struct knotted_q S = knotted_of_q(D);
    for (int j = 0; j <= S.p; j++)
        for (int c = 0; c <= S.p; c++)
            out[j * (S.p + 1) + c] = div(sum_over_subsets(S.p, j, S.u + S.mu - S.p + c + 1), choose(S.p, j));
}
REFERENCE(marsden_determinant)
{
    num M[64];
    struct knotted_q S = knotted_of_q(D);
    reference_marsden_matrix(D, M);
    out[0] = eliminate(S.p + 1, M);
}
/* The polar forms of (x - t)^p. */
REFERENCE(marsden_coefficients)
{
    struct knotted_q S = knotted_of_q(D);
    num a[8];
    for (int k = 0; k <= S.p; k++) {
        a[k] = mul(choose(S.p, k), power(D->x[1], S.p - k));
        a[k] = k % 2 == 0 ? a[k] : neg(a[k]);
    }
    for (int c = 0; c <= S.p; c++)
        out[c] = polar(S.p, a, S.u + S.mu - S.p + c + 1);
}
/* The determinant with the column replaced by the unit vector of the row. */
REFERENCE(cofactor)
{
    num M[36];
    int n = D->n < 6 ? D->n : 6;
    for (int m = 0; m < n * n; m++)
        M[m] = m % n == D->dim % n ? from_int(m / n == D->r % n) : D->x[m];
    out[0] = eliminate(n, M);
}
