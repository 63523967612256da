/* resultant.tmpl.h -- the two matrices, and what is read from them; for the number types q and f.
 * G(is_zero) decides what the division needs to know. */
#include "core/number/generic_on.h"

void G(sylvester_matrix)(int m, const num a[], int n, const num b[], num S[])
{
    int size = m + n;
    for (int i = 0; i < size; i++)
        for (int j = 0; j < size; j++) {
            int first = i < n, degree = first ? m : n, k = j - (first ? i : i - n);
            S[i * size + j] = k < 0 || k > degree ? from_int(0) : first ? a[degree - k] : b[degree - k];
        }
}

/* B_ij = sum over k of a_(j+k+1) b_(i-k) - a_(i-k) b_(j+k+1), 0 <= k <= i, j + k + 1 <= m. */
void G(bezout_matrix)(int m, const num a[], int n, const num b[], num B[])
{
    for (int i = 0; i < m; i++)
        for (int j = 0; j < m; j++) {
            num sum = from_int(0);
            for (int low = i, high = j + 1; low >= 0 && high <= m; low--, high++) {
                if (low <= n)
                    sum = add(sum, mul(a[high], b[low]));
                if (high <= n)
                    sum = sub(sum, mul(a[low], b[high]));
            }
            B[i * m + j] = sum;
        }
}

num G(resultant_sylvester)(int m, const num a[], int n, const num b[])
{
    num *S = cagd_region_array((long)m + n, (long)m + n, sizeof *S);
    if (S == NULL)
        return from_int(0);
    G(sylvester_matrix)(m, a, n, b, S);
    return G(pivoted_determinant)(m + n, S);
}

/* Res(q, p) = (-1)^(mn) Res(p, q) puts the higher degree first. */
num G(resultant_bezout)(int m, const num a[], int n, const num b[])
{
    if (m < n) {
        num swapped = G(resultant_bezout)(n, b, m, a);
        return m % 2 == 0 || n % 2 == 0 ? swapped : neg(swapped);
    }
    num *B = cagd_region_array(m, m, sizeof *B);
    if (B == NULL)
        return from_int(0);
    G(bezout_matrix)(m, a, n, b, B);
    num r = G(pivoted_determinant)(m, B);
    for (int k = n; k < m; k++)
        r = div(r, a[m]);
    return m % 4 < 2 ? r : neg(r);
}
#include "core/number/generic_off.h"
