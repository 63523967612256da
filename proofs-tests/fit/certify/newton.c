/* newton.c -- the arrow of the Newton matrix: feet eliminated, step, iteration. */
#include "proofs-tests/fit/certify/newton.h"

#include "proofs-tests/fit/certify/feet.h"
#include "proofs-tests/fit/certify/jacobian.h"

#include <stdio.h>
#include <stdlib.h>

enum { SMALL = 133, ITERATIONS = 200 }; /* 2^-133 < 1e-40 */

int solve(int n, num *A, int columns, num *b)
{
    int positive = 1;
    for (int k = 0; k < n; k++) {
        if (mpfr_sgn(A[k * n + k]) <= 0)
            positive = 0;
        for (int i = k + 1; i < n; i++) {
            size_t mark = used;
            num f = quo(A[i * n + k], A[k * n + k]);
            for (int j = k; j < n; j++)
                set(A[i * n + j], sub(A[i * n + j], mul(f, A[k * n + j])));
            for (int j = 0; j < columns; j++)
                set(b[i * columns + j], sub(b[i * columns + j], mul(f, b[k * columns + j])));
            used = mark;
        }
    }
    for (int k = n - 1; k >= 0; k--)
        for (int j = 0; j < columns; j++) {
            size_t mark = used;
            num s = b[k * columns + j];
            for (int i = k + 1; i < n; i++)
                s = sub(s, mul(A[k * n + i], b[i * columns + j]));
            set(b[k * columns + j], quo(s, A[k * n + k]));
            used = mark;
        }
    return positive;
}

/* Gradient and Newton matrix of point i in the n varied unknowns and, as number n, the foot. */
static void derivatives(int i, num *b[3], num *g, num *H)
{
    int n = problem.n, e = n + 1;
    num f[MOST + 1], before[MOST + 1], here = phi(moved[0], b[0], i);
    for (int k = 0; k <= n; k++) {
        f[k] = k < n ? phi(moved[1 + k], b[0], i) : phi(moved[0], b[1], i);
        before[k] = k < n ? phi(moved[1 + n + k], b[0], i) : phi(moved[0], b[2], i);
        g[k] = power2(sub(f[k], before[k]), -STEP - 1);
        H[k * e + k] = power2(sub(add(f[k], before[k]), power2(here, 1)), -2 * STEP);
        for (int l = 0; l < k; l++) {
            num both = k < n ? phi(moved[pair(k, l)], b[0], i) : phi(moved[1 + l], b[1], i);
            H[k * e + l] = H[l * e + k] = power2(sub(add(both, here), add(f[k], f[l])), -2 * STEP);
        }
    }
}

/* The system with the feet eliminated: S (n by n), r (n); per point the row (H_t1 ... H_tn, g_t, H_tt). */
num *S;
static num *r, *arrow;

num reduce(void)
{
    int n = problem.n;
    num *b[3], largest = fresh(), h = power2(real(1), STEP);
    set(largest, real(0));
    for (int k = 0; k < 3; k++)
        b[k] = several(problem.count);
    move_curves();
    for (int k = 0; k < n * n; k++)
        set(S[k], real(0));
    num *total = several(n);
    for (int k = 0; k < n; k++)
        set(r[k], real(0)), set(total[k], real(0));
    for (int i = 0; i < problem.N; i++) {
        size_t mark = used;
        num g[MOST + 1], H[(MOST + 1) * (MOST + 1)], *row = arrow + (size_t)i * (size_t)(n + 2);
        basis(found.foot[i], b[0]), basis(add(found.foot[i], h), b[1]), basis(sub(found.foot[i], h), b[2]);
        derivatives(i, b, g, H);
        num d = H[(n + 1) * (n + 1) - 1];
        if (!found.at_end[i] && mpfr_sgn(d) <= 0)
            stop("the foot of point %d is no minimum", i + 1);
        if (!found.at_end[i] && less(largest, size(g[n])))
            set(largest, size(g[n]));
        for (int k = 0; k < n; k++) {
            num b_k = H[n * (n + 1) + k];
            increase(total[k], g[k]);
            increase(r[k], found.at_end[i] ? g[k] : sub(g[k], quo(mul(b_k, g[n]), d)));
            for (int l = 0; l < n; l++) {
                num h_kl = H[k * (n + 1) + l];
                increase(S[k * n + l], found.at_end[i] ? h_kl : sub(h_kl, quo(mul(b_k, H[n * (n + 1) + l]), d)));
            }
            set(row[k], b_k);
        }
        set(row[n], g[n]), set(row[n + 1], d);
        used = mark;
    }
    for (int k = 0; k < n; k++)
        if (less(largest, size(total[k])))
            set(largest, size(total[k]));
    return largest;
}

/* One step: theta from value, and t from foot as the linear system has it, with the matrix M, its diagonal made
 * larger by the factor 1+damping; 0 if it is not positive. */
static int step(num *M, num damping, num *A, num *x, num *theta, num *t)
{
    int n = problem.n;
    size_t mark = used;
    for (int k = 0; k < n * n; k++)
        set(A[k], k % (n + 1) == 0 ? mul(add(real(1), damping), M[k]) : M[k]);
    for (int k = 0; k < n; k++)
        set(x[k], r[k]);
    int positive = solve(n, A, 1, x);
    for (int k = 0; k < problem.m; k++)
        set(theta[k], found.value[k]);
    for (int k = 0; k < n; k++)
        set(theta[problem.varied[k]], sub(found.value[problem.varied[k]], x[k]));
    for (int i = 0; i < problem.N; i++) {
        size_t inner = used;
        num *row = arrow + (size_t)i * (size_t)(n + 2), s = row[n];
        for (int k = 0; k < n; k++)
            s = sub(s, mul(row[k], x[k]));
        set(t[i], found.at_end[i] ? found.foot[i] : sub(found.foot[i], quo(s, row[n + 1])));
        used = inner;
    }
    used = mark;
    return positive;
}

/* Newton's method, and where its step is none or does not decrease the cost, damped Gauss-Newton; the number of
 * iterations. */
int minimise(void)
{
    int N = problem.N, n = problem.n;
    num *theta = numbers((size_t)problem.m), *t = numbers((size_t)N), *A = numbers((size_t)(n * n)),
        *x = numbers((size_t)n);
    num *G = numbers((size_t)(n * n)), damping = numbers(1)[0];
    set(damping, real(0x1p-20));
    num *curve = numbers((size_t)(problem.count * (problem.dim + 1)));
    int *end = malloc((size_t)N * sizeof *end);
    S = numbers((size_t)(n * n)), r = numbers((size_t)n), arrow = numbers((size_t)N * (size_t)(n + 2));
    for (int iteration = 0; iteration < ITERATIONS; iteration++) {
        size_t mark = used;
        num largest = reduce(), F = cost(found.value, found.foot);
        if (getenv("CERTIFY_TABLE") != NULL)
            mpfr_printf("%3d %.20Re %.3Re %.2Re\n", iteration, F, largest, damping);
        if (less(largest, power2(real(1), -SMALL))) {
            set(found.gradient, largest);
            if (!step(S, real(0), A, x, theta, t))
                stop("the stationary point is no strict minimum");
            used = mark;
            free(end);
            return iteration;
        }
        for (int damped = -1;; damped++) {
            if (damped > 40)
                stop("no step decreases the cost");
            size_t inner = used;
            if (damped == 0)
                gauss_newton(G, NULL, 1);
            int good = step(damped < 0 ? S : G, damped < 0 ? real(0) : power2(damping, 4 * damped), A, x, theta, t);
            curve_of(theta, curve);
            for (int i = 0; i < N && good; i++)
                good = settle(curve, i, t[i], &end[i]);
            if (good) { /* near the minimum rounding decides: a step that changes less than that is taken */
                num now = cost(theta, t);
                good = !less(F, now) || less(sub(now, F), power2(add(F, power2(real(1), -300)), -300));
            }
            used = inner;
            if (good && damped >= 0)
                set(damping, power2(damping, 4 * damped - 3));
            if (good)
                break;
        }
        for (int k = 0; k < problem.m; k++)
            set(found.value[k], theta[k]);
        for (int i = 0; i < N; i++)
            set(found.foot[i], t[i]), found.at_end[i] = end[i];
        used = mark;
    }
    stop("no convergence");
    return 0;
}
