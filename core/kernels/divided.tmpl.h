/* divided.tmpl.h -- divided differences (差商) with repeated nodes (重节点).
 *
 * The nodes are d >= 1 different numbers tau[0], ..., tau[d-1]; node i has the multiplicity (重数)
 * l[i] >= 1, and l[0] + ... + l[d-1] = n+1 <= MAX_ORDER.  Which nodes coincide is said by l alone.
 * What belongs to derivative j at node i, 0 <= j < l[i], stands in place
 *
 *     b(i,j) = l[0] + ... + l[i-1] + j,
 *
 * so the values of a function are f[b(i,j)] = f^(j)(tau_i).  UNDEFINED when two of the tau are equal.
 * Results do not overlap arguments.
 * Source: wang-ch4, 4.4.1; de-boor-1978, ch. I. */
#include "core/number/binomial.h"

#include "core/number/generic_on.h"

/* The divided difference [t_0, ..., t_n] f over all n+1 nodes: the leading coefficient of the polynomial
 * of degree <= n with the values f.  By the table
 *     [t_m, ..., t_{m+s}] f = ([t_{m+1}, ..., t_{m+s}] f - [t_m, ..., t_{m+s-1}] f) / (t_{m+s} - t_m),
 * and f^(s)(t_m) / s! where t_m = ... = t_{m+s}. */
KERNEL num G(divided_difference)(int d, const int l[], const num tau[], const num f[])
{
    num D[MAX_ORDER], factorial = from_int(1);
    int node[MAX_ORDER], first[MAX_ORDER], count = 0;
    for (int i = 0; i < d; i++) {
        first[i] = count;
        for (int j = 0; j < l[i]; j++)
            node[count++] = i;
    }
    for (int m = 0; m < count; m++)
        D[m] = f[first[node[m]]];
    for (int s = 1; s < count; s++) {
        factorial = mul(factorial, from_int(s));
        for (int m = 0; m + s < count; m++) {
            int a = node[m], b = node[m + s];
            D[m] = a == b ? div(f[first[a] + s], factorial) : div(sub(D[m + 1], D[m]), sub(tau[b], tau[a]));
        }
    }
    return D[0];
}

/* The confluent Vandermonde matrix (合流 Vandermonde 矩阵) H, (n+1) x (n+1), row by row: row b(i,j) has the
 * j-th derivatives of 1, t, ..., t^n at tau_i,  c!/(c-j)! tau_i^{c-j} in column c, 0 for c < j (formula 4.4.6,
 * its factorials put right). */
KERNEL void G(confluent_vandermonde)(int d, const int l[restrict], const num tau[restrict], num H[restrict])
{
    int columns = 0, row = 0;
    for (int i = 0; i < d; i++)
        columns += l[i];
    for (int i = 0; i < d; i++)
        for (int j = 0; j < l[i]; j++, row++) {
            num *h = H + row * columns;
            h[0] = from_int(j == 0);
            for (int c = 1; c < columns; c++)
                h[c] = j == 0 ? mul(h[c - 1], tau[i]) : mul(from_int(c), h[c - 1 - columns]);
        }
}

/* Its determinant: the product of (tau_j - tau_i)^{l_i l_j}, i < j, and of the factorials 0!, ..., (l_i - 1)!. */
KERNEL num G(confluent_vandermonde_determinant)(int d, const int l[], const num tau[])
{
    num product = from_int(1);
    for (int i = 0; i < d; i++) {
        for (int j = i + 1; j < d; j++)
            for (int m = 0; m < l[i] * l[j]; m++)
                product = mul(product, sub(tau[j], tau[i]));
        for (int j = 2; j < l[i]; j++) /* j stands in the l_i - j factorials j!, ..., (l_i - 1)! */
            for (int m = j; m < l[i]; m++)
                product = mul(product, from_int(j));
    }
    return product;
}

/* The weights alpha[b(i,j)] with  [t_0, ..., t_n] f = sum alpha_{ij} f^(j)(tau_i)  for every f (lemma 4.4.1), in
 * O(n^2) divisions: alpha_{ij} = c_{l_i - 1 - j} / j!  where c_0 + c_1 y + ... is the power series of the
 * product of (tau_i + y - tau_m)^{-l_m} over all m other than i. */
KERNEL void G(divided_weights)(int d, const int l[restrict], const num tau[restrict], num alpha[restrict])
{
    for (int i = 0; i < d; alpha += l[i], i++) {
        num c[MAX_ORDER], factorial = from_int(1);
        for (int s = 0; s < l[i]; s++)
            c[s] = from_int(s == 0);
        for (int m = 0; m < d; m++) {
            if (m == i)
                continue;
            num gap = sub(tau[i], tau[m]);
            for (int power = 0; power < l[m]; power++) {
                c[0] = div(c[0], gap);
                for (int s = 1; s < l[i]; s++)
                    c[s] = div(sub(c[s], c[s - 1]), gap);
            }
        }
        for (int j = 0; j < l[i]; j++) {
            alpha[j] = div(c[l[i] - 1 - j], factorial);
            factorial = mul(factorial, from_int(j + 1));
        }
    }
}
#include "core/number/generic_off.h"
