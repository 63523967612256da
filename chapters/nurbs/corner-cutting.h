/* corner-cutting.h -- the insertion of one knot into a NURBS curve as section 4.2 of wang-ch4 prints it.
 *
 * Indices are those of the source: knots t[1], t[2], ..., points r_1, ..., r_n and weights w[1], ..., w[n]; the places of
 * index 0 are unused, so that t + 1, w + 1 and r + dim are what the kernels take.  Generic text, for the sections on
 * the shape of NURBS curves; it shares nothing with the kernels. */
#include "chapters/judge/claims_on.h"

/* alpha_i for t_mu < tau <= t_{mu+1}: 1 for i <= mu-k+1, 0 for i >= mu+1, and between these
 * (tau - t_i)/(t_{i+k-1} - t_i). */
static inline num G(printed_alpha)(int k, int mu, const num t[], num tau, int i)
{
    if (i <= mu - k + 1)
        return from_int(1);
    if (i >= mu + 1)
        return from_int(0);
    return div(sub(tau, t[i]), sub(t[i + k - 1], t[i]));
}

/* s_i = alpha_i w_i / ((1 - alpha_i) w_{i-1} + alpha_i w_i); the denominator is the new weight. */
static inline num G(printed_ratio)(num alpha, num before, num here, num *weight)
{
    num right = mul(alpha, here);
    *weight = add(mul(sub(from_int(1), alpha), before), right);
    return div(right, *weight);
}

/* The n+1 points S_i = (1 - s_i) r_{i-1} + s_i r_i with their weights z_i, and the knots v.  There is no r_0: for
 * t_k <= tau <= t_{n+1}, t_1 < tau the factor of r_0 is 0 and that of r_{n+1} too. */
static inline void G(printed_insertion)(int n, int k, int dim, const num t[], int mu, num tau, const num r[],
                                        const num w[], num v[], num S[], num z[])
{
    for (int i = 1; i <= n + k + 1; i++)
        v[i] = i <= mu ? t[i] : i == mu + 1 ? tau : t[i - 1];
    for (int i = 1; i <= n + 1; i++) {
        int from = i == 1 || i <= mu - k + 1 ? i : i >= mu + 1 ? i - 1 : 0;
        z[i] = w[from > 0 ? from : i];
        for (int c = 0; c < dim; c++)
            S[i * dim + c] = r[(from > 0 ? from : i) * dim + c];
        if (from > 0)
            continue;
        num s = G(printed_ratio)(G(printed_alpha)(k, mu, t, tau, i), w[i - 1], w[i], &z[i]);
        for (int c = 0; c < dim; c++)
            S[i * dim + c] = add(mul(sub(from_int(1), s), r[(i - 1) * dim + c]), mul(s, r[i * dim + c]));
    }
}
#include "chapters/judge/claims_off.h"
