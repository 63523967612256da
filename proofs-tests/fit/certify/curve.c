/* curve.c -- basis, curve, cost. */
#include "proofs-tests/fit/certify/curve.h"

#include <math.h>

void curve_of(num *theta, num *curve)
{
    int dim = problem.dim, count = problem.count;
    size_t mark = used;
    num w[MOST], P[MOST][3];
    for (int j = 0; j < count; j++) {
        w[j] = problem.weight[j];
        for (int c = 0; c < dim; c++)
            P[j][c] = problem.points[j * dim + c];
    }
    for (int k = 0; k < problem.m; k++)
        if (problem.unknown[k].is_weight)
            w[problem.unknown[k].index] = exponential(theta[k]);
        else
            P[problem.unknown[k].index][problem.unknown[k].coordinate] = theta[k];
    for (int j = 0; j < count; j++) {
        set(curve[j], w[j]);
        for (int c = 0; c < dim; c++)
            set(curve[count + j * dim + c], mul(w[j], P[j][c]));
    }
    used = mark;
}

void basis(num t, num *b)
{
    int p = problem.p, count = problem.count;
    size_t mark = used;
    int s = p;
    while (s < count - 1 && !less(t, problem.knot[s + 1]))
        s++;
    num row[MOST];
    for (int j = 0; j <= count + p; j++)
        row[j] = real(j == s);
    for (int d = 1; d <= p; d++)
        for (int j = s - d; j <= s; j++) {
            num left = quo(mul(sub(t, problem.knot[j]), row[j]), sub(problem.knot[j + d], problem.knot[j]));
            num right = quo(mul(sub(problem.knot[j + d + 1], t), row[j + 1]),
                            sub(problem.knot[j + d + 1], problem.knot[j + 1]));
            row[j] = j == s ? left : j == s - d ? right : add(left, right);
        }
    for (int j = 0; j < count; j++)
        set(b[j], row[j]);
    used = mark;
}

void residual(num *curve, num *b, int i, num *r)
{
    int dim = problem.dim;
    num w = real(0), x[3] = {real(0), real(0), real(0)};
    for (int j = 0; j < problem.count; j++) {
        if (mpfr_zero_p(b[j]))
            continue;
        increase(w, mul(b[j], curve[j]));
        for (int c = 0; c < dim; c++)
            increase(x[c], mul(b[j], curve[problem.count + j * dim + c]));
    }
    for (int c = 0; c < dim; c++)
        r[c] = sub(real(problem.Q[i * dim + c]), quo(x[c], w));
}

num phi(num *curve, num *b, int i)
{
    num r[3], x = real(0), s = real(problem.sigma[i]), a = real(problem.scale);
    residual(curve, b, i, r);
    for (int c = 0; c < problem.dim; c++)
        increase(x, mul(r[c], r[c]));
    x = quo(x, mul(s, s));
    if (problem.loss == HUBER && less(mul(a, a), x))
        x = sub(mul(power2(a, 1), root(x)), mul(a, a));
    else if (problem.loss == CAUCHY)
        x = mul(mul(a, a), logarithm(add(real(1), quo(x, mul(a, a)))));
    return power2(x, -1);
}

num cost(num *theta, num *t)
{
    static num *curve, *b;
    if (curve == NULL)
        curve = numbers((size_t)problem.count * 4), b = numbers((size_t)problem.count);
    num F = fresh();
    set(F, real(0));
    curve_of(theta, curve);
    for (int i = 0; i < problem.N; i++) {
        size_t mark = used;
        basis(t[i], b);
        increase(F, phi(curve, b, i));
        used = mark;
    }
    return F;
}
