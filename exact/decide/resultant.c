#include "exact/decide/resultant.h"

#include "exact/decide/with.h"

#include "exact/words.h"

/* Row r times the least common denominator of its entries, in integers. */
static void clear_denominators(int n, const num_q row[], mpz_t out[], mpz_t common)
{
    mpz_set_ui(common, 1);
    for (int j = 0; j < n; j++)
        mpz_lcm(common, common, mpq_denref(row[j].at));
    for (int j = 0; j < n; j++) {
        mpz_divexact(out[j], common, mpq_denref(row[j].at));
        mpz_mul(out[j], out[j], mpq_numref(row[j].at));
    }
}

/* Bareiss: after step k every entry a_ij, i, j > k, is the minor of rows 0..k, i and columns 0..k, j,
 * so that division by the pivot of the step before is exact and the last entry is the determinant. */
num_q cagd_pivoted_determinant_q(int n, const num_q A[])
{
    mpz_t *a = cagd_region_array(n, n, sizeof *a), before, common, product;
    if (a == NULL)
        return from_int_q(0);
    mpq_t det;
    mpq_init(det);
    mpz_init_set_ui(before, 1), mpz_init(common), mpz_init(product);
    for (int i = 0; i < n * n; i++)
        mpz_init(a[i]);
    mpz_ptr denominator = mpq_denref(det);
    for (int i = 0; i < n; i++) {
        clear_denominators(n, A + (ptrdiff_t)i * n, a + (ptrdiff_t)i * n, common);
        mpz_mul(denominator, denominator, common);
    }
    int sign = 1;
    for (int k = 0; k < n && sign != 0; k++) {
        int p = k;
        while (p < n && mpz_sgn(a[p * n + k]) == 0)
            p++;
        if (p == n) {
            sign = 0;
        } else if (p != k) {
            sign = -sign;
            for (int j = k; j < n; j++)
                mpz_swap(a[p * n + j], a[k * n + j]);
        }
        for (int i = k + 1; i < n && sign != 0; i++)
            for (int j = k + 1; j < n; j++) {
                mpz_mul(product, a[i * n + j], a[k * n + k]);
                mpz_submul(product, a[i * n + k], a[k * n + j]);
                mpz_divexact(a[i * n + j], product, before);
            }
        mpz_set(before, a[k * n + k]);
    }
    mpz_mul_si(mpq_numref(det), before, sign);
    mpq_canonicalize(det);
    num_q value = from_mpq_q(det);
    for (int i = 0; i < n * n; i++)
        mpz_clear(a[i]);
    mpz_clear(before), mpz_clear(common), mpz_clear(product), mpq_clear(det);
    return value;
}

num_f cagd_pivoted_determinant_with_f(int (*is_zero)(num_f), int n, const num_f A[])
{
    num_f *a = cagd_region_array(n, n, sizeof *a), before = from_int_f(1);
    if (a == NULL)
        return before;
    for (int i = 0; i < n * n; i++)
        a[i] = A[i];
    int negative = 0;
    for (int k = 0; k < n; k++) {
        int p = k;
        while (p < n && is_zero(a[p * n + k]))
            p++;
        if (p == n)
            return from_int_f(0);
        if (p != k) {
            negative = !negative;
            for (int j = k; j < n; j++) {
                num_f swapped = a[p * n + j];
                a[p * n + j] = a[k * n + j];
                a[k * n + j] = swapped;
            }
        }
        for (int i = k + 1; i < n; i++)
            for (int j = k + 1; j < n; j++) {
                num_f minor = sub_f(mul_f(a[i * n + j], a[k * n + k]), mul_f(a[i * n + k], a[k * n + j]));
                a[i * n + j] = div_f(minor, before);
            }
        before = a[k * n + k];
    }
    return negative ? neg_f(before) : before;
}
num_f cagd_pivoted_determinant_f(int n, const num_f A[])
{
    return cagd_pivoted_determinant_with_f(cagd_is_zero_f, n, A);
}

#define G(name) cagd_##name##_q
#include "exact/decide/resultant.tmpl.h"
#undef G
#define G(name) cagd_##name##_f
#include "exact/decide/resultant.tmpl.h"
#undef G

num_f cagd_resultant_with_f(num_f (*determinant)(int, const num_f[]), num_f p, num_f q, num_f variable)
{
    int m = degree_f(p, variable), n = degree_f(q, variable);
    if (m < 0 || n < 0) {
        region_faults |= FAULT_UNDEFINED;
        return from_int_f(0);
    }
    num_f *a = cagd_region_array(1, m + 1L, sizeof *a), *b = cagd_region_array(1, n + 1L, sizeof *b);
    num_f *S = cagd_region_array((long)m + n, (long)m + n, sizeof *S);
    if (a == NULL || b == NULL || S == NULL)
        return from_int_f(0);
    for (int k = 0; k <= m; k++)
        a[k] = coefficient_f(p, variable, k);
    for (int k = 0; k <= n; k++)
        b[k] = coefficient_f(q, variable, k);
    sylvester_matrix_f(m, a, n, b, S);
    return determinant(m + n, S);
}
num_f cagd_resultant_by_f(num_f p, num_f q, num_f variable)
{
    return cagd_resultant_with_f(cagd_pivoted_determinant_f, p, q, variable);
}

typedef num_q resultant_of_arrays(int, const num_q[], int, const num_q[]);
static num_q poly_resultant(resultant_of_arrays *resultant, poly p, poly q)
{
    int m = cagd_poly_degree(p), n = cagd_poly_degree(q);
    if (m < 0 || n < 0) {
        region_faults |= FAULT_UNDEFINED;
        return from_int_q(0);
    }
    num_q *a = cagd_region_array(1, m + 1L, sizeof *a), *b = cagd_region_array(1, n + 1L, sizeof *b);
    if (a == NULL || b == NULL)
        return from_int_q(0);
    for (int k = 0; k <= m; k++)
        a[k] = poly_coefficient(p, k);
    for (int k = 0; k <= n; k++)
        b[k] = poly_coefficient(q, k);
    return resultant(m, a, n, b);
}
num_q cagd_poly_resultant_sylvester(poly p, poly q) { return poly_resultant(cagd_resultant_sylvester_q, p, q); }
num_q cagd_poly_resultant_bezout(poly p, poly q) { return poly_resultant(cagd_resultant_bezout_q, p, q); }
