#include "exact/decide/total_positivity.h"

#include "exact/decide/resultant.h"
#include "exact/words.h"

/* An integer matrix, its rows and columns positive multiples of the given ones: that changes the
 * sign of no minor.  Entry (i,j) is a[i * down + j * right], so that a transpose is a view. */
struct matrix {
    int rows, columns, down, right;
    mpz_t *a;
};

static mpz_ptr entry(struct matrix m, int i, int j) { return m.a[i * m.down + j * m.right]; }

static struct matrix transpose(struct matrix m) { return (struct matrix){m.columns, m.rows, m.right, m.down, m.a}; }

static struct matrix integer_matrix(int rows, int columns, const num_q A[])
{
    struct matrix m = {rows, columns, columns, 1, cagd_region_array(rows, columns, sizeof(mpz_t))};
    if (m.a == NULL)
        return (struct matrix){0};
    mpz_t common;
    mpz_init(common);
    for (int i = 0; i < rows; i++) {
        mpz_set_ui(common, 1);
        for (int j = 0; j < columns; j++)
            mpz_lcm(common, common, mpq_denref(A[i * columns + j].at));
        for (int j = 0; j < columns; j++) {
            mpq_srcptr q = A[i * columns + j].at;
            mpz_init(entry(m, i, j));
            mpz_divexact(entry(m, i, j), common, mpq_denref(q));
            mpz_mul(entry(m, i, j), entry(m, i, j), mpq_numref(q));
        }
    }
    mpz_clear(common);
    return m;
}
static void clear_matrix(struct matrix m)
{
    for (int i = 0; i < m.rows; i++)
        for (int j = 0; j < m.columns; j++)
            mpz_clear(entry(m, i, j));
}

static int row_is_zero(struct matrix m, int i, int from)
{
    int zero = 1;
    for (int j = from; j < m.columns; j++)
        zero &= mpz_sgn(entry(m, i, j)) == 0;
    return zero;
}

/* Rows k, k+1, ... without the zero ones, seen from column k on; the others sink to the end. */
static void drop_zero_rows(struct matrix *m, int k)
{
    int kept = k;
    for (int i = k; i < m->rows; i++)
        if (!row_is_zero(*m, i, k)) {
            for (int j = k; j < m->columns && kept < i; j++)
                mpz_swap(entry(*m, kept, j), entry(*m, i, j));
            kept++;
        }
    m->rows = kept;
}

/* Row i := a_(i-1)k row_i - a_ik row_(i-1), freed of common factors, from column k on. */
static void neville_step(struct matrix m, int i, int k)
{
    mpz_t factor, content;
    mpz_init_set(factor, entry(m, i, k));
    mpz_init(content);
    for (int j = k; j < m.columns; j++) {
        mpz_mul(entry(m, i, j), entry(m, i, j), entry(m, i - 1, k));
        mpz_submul(entry(m, i, j), factor, entry(m, i - 1, j));
        mpz_gcd(content, content, entry(m, i, j));
    }
    for (int j = k; j < m.columns && mpz_sgn(content) != 0; j++)
        mpz_divexact(entry(m, i, j), entry(m, i, j), content);
    mpz_clear(factor), mpz_clear(content);
}

/* Column k below row k becomes 0.  In a totally nonnegative matrix without zero rows the column has
 * no negative entry, and a positive one only under positive ones: from a_ik = 0 < a_(i+1)k follows
 * a_ij = 0 for all j, by the minors of these two rows.  Whitney: the step keeps total nonnegativity;
 * it is undone by adding nonnegative multiples of neighbours, so it keeps its absence too. */
static int reduce_column(struct matrix m, int k)
{
    int above = 1;
    for (int i = k; i < m.rows; i++) {
        int s = mpz_sgn(entry(m, i, k));
        if (s < 0 || s > above)
            return 0;
        above = s;
    }
    for (int i = m.rows - 1; i > k; i--)
        if (mpz_sgn(entry(m, i, k)) > 0)
            neville_step(m, i, k);
    return 1;
}

/* When row k and column k are reduced, what is left is a block of its own, one smaller. */
int cagd_is_totally_nonnegative(int rows, int columns, const num_q A[])
{
    region_mark mark = region_open();
    struct matrix whole = integer_matrix(rows, columns, A), m = whole;
    int good = 1;
    for (int k = 0; good && k < m.rows && k < m.columns; k++) {
        struct matrix t = transpose(m);
        drop_zero_rows(&t, k);
        m = transpose(t);
        drop_zero_rows(&m, k);
        if (k < m.rows && k < m.columns)
            good = reduce_column(m, k) && reduce_column(transpose(m), k);
    }
    clear_matrix(whole);
    region_drop(mark);
    return good;
}

/* After step k the entry (i,j), i, j >= k, is the minor M_k(i,j) of rows i-k .. i and columns
 * 0 .. k-1, j; by Sylvester's identity
 *
 *     M_(k+1)(i,j) M_(k-1)(i-1,k-1) = M_k(i,j) M_k(i-1,k) - M_k(i-1,j) M_k(i,k),
 *
 * where M_(k-1)(i-1,k-1), the minor of rows i-k .. i-1 and columns 0 .. k-1, has been found positive. */
static int consecutive_minors_positive(struct matrix m)
{
    mpz_t *divisor = cagd_region_array(1, m.rows, sizeof *divisor), product;
    if (divisor == NULL)
        return 0;
    int good = 1;
    mpz_init(product);
    for (int i = 0; i < m.rows; i++)
        mpz_init_set_ui(divisor[i], 1);
    for (int k = 0; k < m.rows && k < m.columns; k++) {
        for (int i = k; i < m.rows; i++)
            good &= mpz_sgn(entry(m, i, k)) > 0;
        if (!good)
            break;
        for (int i = m.rows - 1; i > k; i--) {
            for (int j = k + 1; j < m.columns; j++) {
                mpz_mul(product, entry(m, i, j), entry(m, i - 1, k));
                mpz_submul(product, entry(m, i - 1, j), entry(m, i, k));
                mpz_divexact(entry(m, i, j), product, divisor[i - 1]);
            }
            mpz_set(divisor[i], entry(m, i, k));
        }
    }
    for (int i = 0; i < m.rows; i++)
        mpz_clear(divisor[i]);
    mpz_clear(product);
    return good;
}

int cagd_is_totally_positive(int rows, int columns, const num_q A[])
{
    region_mark mark = region_open();
    struct matrix m = integer_matrix(rows, columns, A), copy = integer_matrix(rows, columns, A);
    int good = consecutive_minors_positive(m) && consecutive_minors_positive(transpose(copy));
    clear_matrix(m), clear_matrix(copy);
    region_drop(mark);
    return good;
}

/* The next choice of r out of 0 .. n-1 in lexicographic order; 0 after the last. */
static int next_choice(int r, int n, int choice[])
{
    int k = r - 1;
    while (k >= 0 && choice[k] == n - r + k)
        k--;
    if (k < 0)
        return 0;
    choice[k]++;
    for (; k + 1 < r; k++)
        choice[k + 1] = choice[k] + 1;
    return 1;
}
static void first_choice(int r, int choice[])
{
    for (int k = 0; k < r; k++)
        choice[k] = k;
}

static num_q minor_value(int order, int columns, const num_q A[], const int row[], const int column[], num_q B[])
{
    for (int i = 0; i < order; i++)
        for (int j = 0; j < order; j++)
            B[i * order + j] = A[row[i] * columns + column[j]];
    return cagd_pivoted_determinant_q(order, B);
}

int cagd_all_minors_nonnegative(int rows, int columns, const num_q A[], int strict, struct cagd_minor *worst)
{
    int most = rows < columns ? rows : columns;
    int *row = cagd_region_array(1, most, sizeof *row), *column = cagd_region_array(1, most, sizeof *column);
    num_q *B = cagd_region_array(most, most, sizeof *B);
    if (row == NULL || column == NULL || B == NULL)
        return 0;
    for (int order = 1; order <= most; order++) {
        first_choice(order, row);
        do {
            first_choice(order, column);
            do {
                region_mark m = region_open();
                num_q value = minor_value(order, columns, A, row, column, B);
                if (cagd_sign_q(value) < (strict != 0)) {
                    if (worst != NULL)
                        *worst = (struct cagd_minor){order, row, column, value};
                    return 0;
                }
                region_drop(m);
            } while (next_choice(order, columns, column));
        } while (next_choice(order, rows, row));
    }
    return 1;
}
