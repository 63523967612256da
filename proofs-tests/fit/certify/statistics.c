/* statistics.c -- covariance, its scale, its rank, and what rounding makes of them. */
#include "proofs-tests/fit/certify/statistics.h"

#include "proofs-tests/fit/certify/feet.h"
#include "proofs-tests/fit/certify/jacobian.h"
#include "proofs-tests/fit/certify/newton.h"

#include <stdlib.h>

void invariant_form(int j, int v[MOST])
{
    for (int k = 0; k < problem.n; k++) {
        int apart = abs(problem.unknown[problem.varied[k]].index - j);
        v[k] = !problem.unknown[problem.varied[k]].is_weight ? 0 : apart == 0 ? 2 : apart == 1 ? -1 : 0;
    }
}
int invariants(void) { return problem.count == problem.p + 1 && problem.p > 1 ? problem.p - 1 : 0; }

/* Whether point i is an end of the curve that is not free, and hence no measurement. */
static int is_given_end(int i)
{
    int first = 1, last = 1;
    for (int k = 0; k < problem.m; k++)
        if (!problem.unknown[k].is_weight && problem.unknown[k].index == 0)
            return 0;
    for (int c = 0; c < problem.dim; c++) {
        double x = problem.Q[i * problem.dim + c];
        first &= mpfr_cmp_d(problem.points[c], x) == 0;
        last &= mpfr_cmp_d(problem.points[(problem.count - 1) * problem.dim + c], x) == 0;
    }
    return first || last;
}

int measurements(void)
{
    int N = problem.N;
    for (int i = 0; i < problem.N; i++)
        N -= is_given_end(i);
    return N;
}

num scale_squared(void)
{
    int N = measurements(), dim = problem.dim, n = problem.n;
    num d = real(N * (dim - 1) - n), sum = real(0), mean = real(0), squared = real(0), *b = several(problem.count);
    for (int i = 0; i < problem.N; i++) {
        if (is_given_end(i))
            continue;
        size_t mark = used;
        num rest[3], x = real(0), first, second, s = real(problem.sigma[i]);
        basis(found.foot[i], b);
        residual(moved[0], b, i, rest);
        for (int c = 0; c < dim; c++)
            increase(x, mul(rest[c], rest[c]));
        x = quo(x, mul(s, s));
        loss_derivatives(x, &first, &second);
        num m_i = add(first, quo(power2(mul(x, second), 1), real(dim - 1)));
        increase(sum, mul(mul(first, first), x)), increase(mean, m_i), increase(squared, mul(m_i, m_i));
        used = mark;
    }
    if (problem.loss == SQUARES)
        return problem.known_sigma ? real(1) : quo(sum, d);
    mean = quo(mean, real(N));
    num ratio = quo(sub(quo(squared, real(N)), mul(mean, mean)), mul(mean, mean));
    num K = add(real(1), mul(quo(real(n), real(N * (dim - 1))), ratio));
    return quo(mul(mul(K, K), quo(sum, d)), mul(mean, mean));
}

/* Standard errors: of the n unknowns, then of the logarithms of the invariants.  With rounding not NULL also what
 * relative errors of the derivatives of eps = 1 make of each: |C| E^T E |C| / C on the diagonal, halved for the root
 * and doubled for the two factors. */
static void standard_errors(num *result, num *rounding)
{
    int n = problem.n;
    static num *A, *B, *C;
    if (A == NULL)
        A = numbers((size_t)(n * n)), B = numbers((size_t)(n * n)), C = numbers((size_t)(n * n));
    size_t mark = used;
    move_curves();
    gauss_newton(A, B, 0);
    for (int k = 0; k < n * n; k++)
        set(C[k], real(k % (n + 1) == 0));
    solve(n, A, n, C);
    num scaled = scale_squared();
    for (int f = 0; f < n + invariants(); f++) {
        size_t inner = used;
        int v[MOST] = {0};
        num variance = real(0), wrong = real(0), *Cv = several(n);
        if (f < n)
            v[f] = 1;
        else
            invariant_form(f - n + 1, v);
        for (int k = 0; k < n; k++) {
            num size_k = real(0), row = real(0);
            for (int l = 0; l < n; l++) {
                increase(row, mul(C[k * n + l], real(v[l])));
                increase(size_k, mul(size(C[k * n + l]), real(abs(v[l]))));
            }
            increase(variance, mul(real(v[k]), row));
            set(Cv[k], size_k);
        }
        for (int k = 0; k < n; k++)
            for (int l = 0; l < n; l++)
                increase(wrong, mul(mul(Cv[k], Cv[l]), B[k * n + l]));
        set(result[f], root(mul(scaled, variance)));
        if (rounding != NULL)
            set(rounding[f], mpfr_zero_p(variance) ? real(0) : mul(result[f], quo(wrong, variance)));
        used = inner;
    }
    used = mark;
}

/* How many pivots of J^T J vanish.  Where the whole curve has a cusp, inside the domain or not, displacements phi C'
 * along the curve are regular for a phi with a pole there: J has one more direction in which no point moves off the
 * curve, yet the cost is not flat. */
static int missing_rank(void)
{
    int n = problem.n;
    num *A = numbers((size_t)(n * n)), *diagonal = numbers((size_t)n), *none = numbers((size_t)n);
    int missing = 0;
    move_curves();
    gauss_newton(A, NULL, 0);
    for (int k = 0; k < n; k++)
        set(diagonal[k], A[k * n + k]);
    solve(n, A, 1, none);
    for (int k = 0; k < n; k++)
        missing += !less(power2(diagonal[k], STEP), A[k * n + k]);
    return missing;
}

struct statistics statistics_of_minimum(void)
{
    int N = problem.N, count = problem.count, n = problem.n;
    struct statistics s = {0};
    num *inverse = numbers((size_t)(n * n)), *beside = numbers(2 * MOST), step_size = power2(real(1), -64);
    s.condition = numbers((size_t)n), s.spread = numbers((size_t)n);
    s.error = numbers(2 * MOST), s.error_condition = numbers(2 * MOST);
    s.cost_condition = numbers(1)[0], s.cost_floor = numbers(1)[0], s.squares = numbers(1)[0], s.chi = numbers(1)[0];
    for (int k = 0; k < n; k++)
        set(inverse[k * n + k], real(1));
    reduce(), solve(n, S, n, inverse);
    for (int k = 0; k < n; k++)
        set(s.spread[k], root(inverse[k * n + k]));
    num *b[3] = {several(count), several(count), several(count)};
    for (int i = 0; i < problem.N; i++) {
        if (is_given_end(i))
            continue;
        size_t mark = used;
        num rest[3], J[MOST][3], E[MOST], length = real(0), deviation = real(problem.sigma[i]);
        num unit = quo(problem.largest_coordinate, deviation);
        jacobian(i, b, rest, J, E);
        for (int c = 0; c < problem.dim; c++)
            increase(length, mul(rest[c], rest[c]));
        increase(s.chi, length), increase(s.squares, mul(length, mul(deviation, deviation)));
        length = root(length);
        increase(s.cost_condition, mul(length, unit)), increase(s.cost_floor, mul(unit, unit));
        for (int k = 0; k < n; k++) {
            for (int c = 0; c < problem.dim; c++) {
                num G = real(0);
                for (int l = 0; l < n; l++)
                    increase(G, mul(inverse[k * n + l], J[l][c]));
                increase(s.condition[k], mul(size(G), unit));
            }
            for (int l = 0; l < n; l++)
                increase(s.condition[k], mul(mul(size(inverse[k * n + l]), E[l]), length));
        }
        used = mark;
    }
    s.missing = missing_rank();
    if (s.missing > 0)
        return s;
    standard_errors(s.error, s.error_condition);
    num *here = numbers((size_t)N);
    for (int i = 0; i < N; i++)
        set(here[i], found.foot[i]);
    for (int l = 0; l < n; l++) { /* the feet follow */
        size_t mark = used;
        num was = real(0);
        set(was, found.value[problem.varied[l]]);
        set(found.value[problem.varied[l]], add(was, step_size));
        move_curves();
        for (int i = 0; i < N; i++)
            if (!settle(moved[0], i, found.foot[i], &found.at_end[i]))
                stop("point %d loses its foot", i + 1);
        standard_errors(beside, NULL);
        for (int f = 0; f < n + invariants(); f++)
            increase(s.error_condition[f], mul(quo(size(sub(beside[f], s.error[f])), step_size), s.condition[l]));
        set(found.value[problem.varied[l]], was);
        for (int i = 0; i < N; i++)
            set(found.foot[i], here[i]);
        used = mark;
    }
    move_curves();
    return s;
}
