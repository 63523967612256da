/* test_total_positivity.c -- elimination against all minors. */
#include "unit_exact.h"

#include "exact/decide/total_positivity.h"
#include "exact/words.h"

#include "core/number/binomial.h"

#include <limits.h>

static num_q q(long m) { return from_int_q(m); }

/* C = A B, A is l x m, B is m x n. */
static void product(int l, int m, int n, const num_q A[], const num_q B[], num_q C[])
{
    for (int i = 0; i < l; i++)
        for (int j = 0; j < n; j++) {
            C[i * n + j] = q(0);
            for (int k = 0; k < m; k++)
                C[i * n + j] = add_q(C[i * n + j], mul_q(A[i * m + k], B[k * n + j]));
        }
}

/* Products of bidiagonal matrices with entries >= 0 are totally nonnegative (Cauchy and Binet), and
 * so are their submatrices; zeros on the diagonal make them singular. */
static void random_nonnegative(int n, int least, num_q A[])
{
    num_q factor[36], old[36];
    for (int i = 0; i < n * n; i++)
        A[i] = q(i % (n + 1) == 0);
    for (int f = 0; f < 2 * n; f++) {
        for (int i = 0; i < n; i++)
            for (int j = 0; j < n; j++) {
                int on = i == j || (f % 2 ? i == j + 1 : j == i + 1);
                factor[i * n + j] = on ? from_ratio_q(random_int(least, 3), random_int(1, 3)) : q(0);
                old[i * n + j] = A[i * n + j];
            }
        product(n, n, n, old, factor, A);
    }
}

static int sign_of(int negative) { return negative ? -1 : 1; }

static void assert_is_definition(int rows, int columns, const num_q A[], int met[2])
{
    int nonnegative = cagd_all_minors_nonnegative(rows, columns, A, 0, NULL);
    int positive = cagd_all_minors_nonnegative(rows, columns, A, 1, NULL);
    assert_int_equal(cagd_is_totally_nonnegative(rows, columns, A), nonnegative);
    assert_int_equal(cagd_is_totally_positive(rows, columns, A), positive);
    met[0] += nonnegative;
    met[1] += positive;
}

static void small_matrices_with_many_zeros(void **state)
{
    (void)state;
    int met[2] = {0};
    for (int k = 0; k < 6000; k++) {
        region_mark m = region_open();
        int rows = random_int(1, 4), columns = random_int(1, 4), most = random_int(1, 3);
        num_q A[16];
        for (int i = 0; i < rows * columns; i++)
            A[i] = q(random_int(0, most) * sign_of(random_int(0, 99) == 0));
        assert_is_definition(rows, columns, A, met);
        region_drop(m);
    }
    assert_true(met[0] > 500 && met[1] > 100);
}

static void products_of_bidiagonal_matrices(void **state)
{
    (void)state;
    int met[2] = {0}, spoiled = 0;
    for (int k = 0; k < 400; k++) {
        region_mark m = region_open();
        int n = random_int(2, 5), rows = random_int(1, n);
        num_q A[36];
        random_nonnegative(n, k % 2, A);
        assert_true(cagd_is_totally_nonnegative(n, n, A));
        assert_is_definition(rows, n, A, met);
        int place = random_int(0, n * n - 1); /* and one entry a little different */
        A[place] = add_q(A[place], from_ratio_q(random_int(-2, 2), 5));
        int before = met[0];
        assert_is_definition(n, n, A, met);
        spoiled += met[0] == before;
        region_drop(m);
    }
    assert_true(met[1] > 50 && spoiled > 50);
}

/* B_j^n at increasing parameters: positive inside (0,1), nonnegative with both ends. */
static void collocation_of_the_bernstein_basis(void **state)
{
    (void)state;
    int n = 5, met[2] = {0};
    for (int ends = 0; ends < 2; ends++) {
        num_q A[36];
        for (int i = 0; i <= n; i++) {
            num_q t = ends ? from_ratio_q(i, n) : from_ratio_q(2 * i + 1, 2 * n + 2), u = sub_q(q(1), t);
            for (int j = 0; j <= n; j++) {
                num_q b = q(binomial(n, j));
                for (int k = 0; k < n; k++)
                    b = mul_q(b, k < j ? t : u);
                A[i * (n + 1) + j] = b;
            }
        }
        assert_is_definition(n + 1, n + 1, A, met);
        assert_true(cagd_is_totally_nonnegative(n + 1, n + 1, A));
        assert_int_equal(cagd_is_totally_positive(n + 1, n + 1, A), !ends);
        for (int j = 0; j <= n; j++) { /* two rows exchanged */
            num_q swapped = A[j];
            A[j] = A[n + 1 + j];
            A[n + 1 + j] = swapped;
        }
        assert_false(cagd_is_totally_nonnegative(n + 1, n + 1, A));
    }
}

static void the_worst_minor_is_shown(void **state)
{
    (void)state;
    num_q A[9] = {q(1), q(1), q(0), q(1), q(1), q(1), q(0), q(1), q(1)}; /* det = -1, all else >= 0 */
    struct cagd_minor worst;
    assert_false(cagd_all_minors_nonnegative(3, 3, A, 0, &worst));
    assert_int_equal(worst.order, 3);
    assert_true(cagd_equal_q(worst.value, q(-1)));
    assert_int_equal(worst.row[2], 2);
    assert_false(cagd_all_minors_nonnegative(3, 3, A, 1, &worst));
    assert_int_equal(worst.order, 1);
    assert_int_equal(worst.row[0], 0);
    assert_int_equal(worst.column[0], 2);
    assert_true(cagd_is_zero_q(worst.value));
}

/* `strict` is a truth value: every number but 0 asks for the same. */
static void strict_is_yes_or_no(void **state)
{
    (void)state;
    static const int yes[] = {1, 2, -1, INT_MAX, INT_MIN};
    num_q one[1] = {q(1)}, zero[1] = {q(0)};
    for (size_t k = 0; k < sizeof yes / sizeof yes[0]; k++) {
        assert_true(cagd_all_minors_nonnegative(1, 1, one, yes[k], NULL));
        assert_false(cagd_all_minors_nonnegative(1, 1, zero, yes[k], NULL));
    }
    assert_true(cagd_all_minors_nonnegative(1, 1, zero, 0, NULL));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        unit(small_matrices_with_many_zeros),
        unit(products_of_bidiagonal_matrices),
        unit(collocation_of_the_bernstein_basis),
        unit(the_worst_minor_is_shown),
        unit(strict_is_yes_or_no),
    };
    return run_unit_tests(tests);
}
