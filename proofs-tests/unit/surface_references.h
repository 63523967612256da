/* surface_references.h -- what the kernels on surfaces and on given values and derivatives compute, in powers and by
 * determinants; a part of kernel_references.h. */

/* ## Tensor product surfaces, row by row in powers of w and then in powers of u */

/* Coordinate `at` of the derivative of orders k and l at (u, w) of the net P. */
static num surface_at(int n, int m, int dim, const num P[], int at, int k, int l, num u, num w)
{
    num column[MAX_DEGREE + 1], c[MAX_DEGREE + 1];
    for (int i = 0; i <= n; i++) {
        powers_of(m, dim, P + i * (m + 1) * dim, at, c);
        column[i] = derivative_at(m, c, l, w);
    }
    powers_of(n, 1, column, 0, c);
    return derivative_at(n, c, k, u);
}
/* Column j of the net. */
static void column_of(int n, int m, int dim, const num P[], int j, num column[])
{
    for (int i = 0; i <= n; i++)
        for (int at = 0; at < dim; at++)
            column[i * dim + at] = P[(i * (m + 1) + j) * dim + at];
}
REFERENCE(bezier_surface_transpose)
{
    int m = other_degree_q(D), size = (D->n + 1) * D->dim;
    for (int j = 0; j <= m; j++)
        column_of(D->n, m, D->dim, D->x, j, out + j * size);
}
REFERENCE(bezier_surface_line)
{
    int m = other_degree_q(D);
    num column[(MAX_DEGREE + 1) * MAX_DIM], c[MAX_DEGREE + 1];
    for (int j = 0; j <= m; j++) {
        column_of(D->n, m, D->dim, D->x, j, column);
        for (int at = 0; at < D->dim; at++) {
            powers_of(D->n, D->dim, column, at, c);
            out[j * D->dim + at] = derivative_at(D->n, c, 0, D->t);
        }
    }
}
REFERENCE(bezier_surface_point)
{
    for (int at = 0; at < D->dim; at++)
        out[at] = surface_at(D->n, other_degree_q(D), D->dim, D->x, at, 0, 0, D->t, D->u);
}
REFERENCE(bezier_surface_derivatives)
{
    for (int k = 0; k <= D->r; k++)
        for (int l = 0; l <= 3; l++)
            for (int at = 0; at < D->dim; at++)
                out[(k * 4 + l) * D->dim + at] =
                    surface_at(D->n, other_degree_q(D), D->dim, D->x, at, k, l, D->t, D->u);
}
/* The minors of the two tangents. */
REFERENCE(bezier_surface_normal)
{
    for (int at = 0; at < 3; at++) {
        num tangents[4];
        for (int k = 0; k < 4; k++)
            tangents[k] = surface_at(D->n, other_degree_q(D), 3, D->x, (at + 1 + k % 2) % 3, k < 2, k >= 2, D->t, D->u);
        out[at] = eliminate(2, tangents);
    }
}
REFERENCE(bezier_surface_part)
{
    int n = degree_of_part_q(D), m = other_degree_q(D), dim = D->dim;
    num column[(MAX_DEGREE + 1) * MAX_DIM], piece[(MAX_DEGREE + 1) * MAX_DIM], row[(MAX_DEGREE + 1) * MAX_DIM];
    for (int j = 0; j <= m; j++) {
        column_of(n, m, dim, D->x, j, column);
        on_interval(n, dim, column, D->t, D->u, piece);
        for (int i = 0; i <= n; i++)
            for (int at = 0; at < dim; at++)
                out[(i * (m + 1) + j) * dim + at] = piece[i * dim + at];
    }
    for (int i = 0; i <= n; i++) {
        for (int k = 0; k < (m + 1) * dim; k++)
            row[k] = out[i * (m + 1) * dim + k];
        on_interval(m, dim, row, from_ratio(1, 4), D->t, out + i * (m + 1) * dim);
    }
}

/* ## Values and derivatives, in powers of t - t_0 */

/* The derivative of order k at t of the cubic with the data p(t0), p(t0 + h), p'(t0), p'(t0 + h). */
static num cubic_with_data(const num data[4], num t0, num h, int k, num t)
{
    num chord = div(sub(data[1], data[0]), h), sum = add(data[2], data[3]), c[4] = {data[0], data[2]};
    c[2] = div(sub(mul(from_int(3), chord), add(data[2], sum)), h);
    c[3] = div(sub(sum, mul(from_int(2), chord)), mul(h, h));
    return derivative_at(3, c, k, sub(t, t0));
}
REFERENCE(hermite_blending)
{
    for (int k = 0; k <= D->r; k++)
        for (int i = 0; i < 4; i++) {
            num unit[4] = {from_int(i == 0), from_int(i == 1), from_int(i == 2), from_int(i == 3)};
            out[4 * k + i] = cubic_with_data(unit, D->x[0], length_q(D), k, D->t);
        }
}
REFERENCE(hermite_cubic)
{
    for (int k = 0; k <= D->r; k++)
        for (int at = 0; at < D->dim; at++) {
            num data[4];
            for (int i = 0; i < 4; i++)
                data[i] = D->x[1 + i * D->dim + at];
            out[k * D->dim + at] = cubic_with_data(data, D->x[0], length_q(D), k, D->t);
        }
}
/* A row of powers at one of the nodes is replaced by that of t. */
REFERENCE(lagrange_blending)
{
    int n = D->n <= 7 ? D->n : 7;
    num tau[8], V[64], W[64];
    different_nodes_q(D, n + 1, tau);
    for (int k = 0; k < (n + 1) * (n + 1); k++)
        V[k] = power(tau[k / (n + 1)], k % (n + 1));
    for (int i = 0; i <= n; i++) {
        for (int k = 0; k < (n + 1) * (n + 1); k++)
            W[k] = k / (n + 1) == i ? power(D->t, k % (n + 1)) : V[k];
        out[i] = div(eliminate(n + 1, W), eliminate(n + 1, V));
    }
}
/* Cramer's rule for the conditions, one a row. */
REFERENCE(hermite_interpolant)
{
    int l[3], count = three_multiplicities_q(D, l), row = 0;
    num tau[3], V[64], W[64];
    different_nodes_q(D, 3, tau);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < l[i]; j++, row++)
            for (int k = 0; k < count; k++) {
                num unit[8];
                for (int m = 0; m < count; m++)
                    unit[m] = from_int(m == k);
                V[row * count + k] = derivative_at(count - 1, unit, j, tau[i]);
            }
    for (int k = 0; k < count; k++) {
        for (int m = 0; m < count * count; m++)
            W[m] = m % count == k ? D->x[1 + m / count] : V[m];
        out[k] = div(eliminate(count, W), eliminate(count, V));
    }
}

/* ## Surfaces in a frame */

REFERENCE(coons_patch)
{
    int m = D->r % 2 == 0 ? 2 : 4, dim = D->dim;
    for (int at = 0; at < dim; at++) {
        num across = from_int(0), along = from_int(0), corners = from_int(0);
        for (int i = 0; i < m; i++) {
            across = add(across, mul(D->x[i], D->x[8 + i * dim + at]));
            along = add(along, mul(D->x[4 + i], D->x[20 + i * dim + at]));
            for (int j = 0; j < m; j++)
                corners = add(corners, mul(mul(D->x[i], D->x[4 + j]), D->x[32 + (i * m + j) * dim + at]));
        }
        out[at] = sub(add(across, along), corners);
    }
}
REFERENCE(hermite_tensor)
{
    num zero = from_int(0), one = from_int(1);
    for (int at = 0; at < D->dim; at++) {
        num column[4];
        for (int i = 0; i < 4; i++) {
            num row[4];
            for (int j = 0; j < 4; j++)
                row[j] = D->x[(4 * i + j) * D->dim + at];
            column[i] = cubic_with_data(row, zero, one, D->n % 4, D->u);
        }
        out[at] = cubic_with_data(column, zero, one, D->r % 4, D->t);
    }
}
