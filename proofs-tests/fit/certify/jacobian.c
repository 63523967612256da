/* jacobian.c -- moved curves; residuals and the Gauss-Newton matrix. */
#include "proofs-tests/fit/certify/jacobian.h"

#include <stdlib.h>
#include <string.h>

num **moved;

int pair(int k, int l) { return 1 + 2 * problem.n + (k < l ? l * (l - 1) / 2 + k : k * (k - 1) / 2 + l); }

void move_curves(void)
{
    int n = problem.n;
    if (moved == NULL) {
        moved = malloc((size_t)(1 + 2 * n + n * n) * sizeof *moved);
        for (int k = 0; k < 1 + 2 * n + n * (n - 1) / 2; k++)
            moved[k] = numbers((size_t)problem.count * (size_t)(problem.dim + 1));
    }
    size_t mark = used;
    num theta[MOST], h = power2(real(1), STEP);
    memcpy(theta, found.value, (size_t)problem.m * sizeof *theta);
    curve_of(theta, moved[0]);
    for (int k = 0; k < n; k++) {
        int a = problem.varied[k];
        theta[a] = sub(found.value[a], h), curve_of(theta, moved[1 + n + k]);
        theta[a] = add(found.value[a], h), curve_of(theta, moved[1 + k]);
        for (int l = 0; l < k; l++) {
            int c = problem.varied[l];
            theta[c] = add(found.value[c], h), curve_of(theta, moved[pair(k, l)]);
            theta[c] = found.value[c];
        }
        theta[a] = found.value[a];
    }
    used = mark;
}

void jacobian(int i, num *b[3], num rest[3], num J[MOST][3], num E[MOST])
{
    int dim = problem.dim, n = problem.n;
    num whole[MOST][3];
    num T[3], plus[3], minus[3], TT = real(0), s = real(problem.sigma[i]), h = power2(real(1), STEP);
    basis(found.foot[i], b[0]), basis(add(found.foot[i], h), b[1]), basis(sub(found.foot[i], h), b[2]);
    residual(moved[0], b[0], i, rest), residual(moved[0], b[1], i, plus), residual(moved[0], b[2], i, minus);
    for (int c = 0; c < dim; c++) {
        rest[c] = quo(rest[c], s);
        T[c] = power2(sub(minus[c], plus[c]), -STEP - 1);
        increase(TT, mul(T[c], T[c]));
    }
    for (int k = 0; k < n; k++) {
        num along = real(0);
        residual(moved[1 + k], b[0], i, plus), residual(moved[1 + n + k], b[0], i, minus);
        for (int c = 0; c < dim; c++) {
            whole[k][c] = quo(power2(sub(minus[c], plus[c]), -STEP - 1), s);
            increase(along, quo(mul(whole[k][c], T[c]), TT));
        }
        E[k] = real(0);
        for (int c = 0; c < dim; c++) {
            J[k][c] = found.at_end[i] ? whole[k][c] : sub(whole[k][c], mul(along, T[c]));
            increase(E[k], mul(whole[k][c], whole[k][c]));
        }
        num turned = quo(mul(real(2 * problem.p), problem.largest_coordinate), mul(problem.smallest_span, root(TT)));
        E[k] = mul(root(E[k]), add(real(1), turned));
        if (problem.unknown[problem.varied[k]].is_weight)
            increase(E[k], quo(problem.largest_coordinate, s));
    }
}

void loss_derivatives(num x, num *first, num *second)
{
    num aa = real(problem.scale);
    aa = mul(aa, aa);
    *first = real(1), *second = real(0);
    if (problem.loss == HUBER && less(aa, x)) {
        *first = root(quo(aa, x));
        *second = power2(quo(*first, mul(real(-1), x)), -1);
    } else if (problem.loss == CAUCHY) {
        *first = quo(aa, add(aa, x));
        *second = quo(mul(*first, *first), mul(real(-1), aa));
    }
}

void gauss_newton(num *A, num *B, int robust)
{
    int count = problem.count, n = problem.n;
    num *b[3] = {several(count), several(count), several(count)};
    for (int k = 0; k < n * n; k++) {
        set(A[k], real(0));
        if (B != NULL)
            set(B[k], real(0));
    }
    for (int i = 0; i < problem.N; i++) {
        size_t mark = used;
        num rest[3], J[MOST][3], E[MOST], x = real(0), share = real(1), second;
        jacobian(i, b, rest, J, E);
        for (int c = 0; c < problem.dim; c++)
            increase(x, mul(rest[c], rest[c]));
        if (robust)
            loss_derivatives(x, &share, &second);
        for (int k = 0; k < n; k++)
            for (int l = 0; l < n; l++) {
                for (int c = 0; c < problem.dim; c++)
                    increase(A[k * n + l], mul(share, mul(J[k][c], J[l][c])));
                if (B != NULL)
                    increase(B[k * n + l], mul(E[k], E[l]));
            }
        used = mark;
    }
}
