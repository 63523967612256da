/* feet.c -- feet by sampling, bisection and Newton, with every derivative a quotient of differences. */
#include "proofs-tests/fit/certify/feet.h"

#include <math.h>
#include <stdlib.h>

enum { SAMPLES = 800 }; /* of a span */

/* 1 if the distance grows into the domain, from its end t. */
static int stays_at_end(num *curve, int i, num t)
{
    size_t mark = used;
    num *b = several(problem.count);
    num inside = add(t, power2(real(mpfr_equal_p(t, problem.knot[problem.p]) ? 1 : -1), STEP));
    basis(t, b);
    num here = phi(curve, b, i);
    basis(inside, b);
    int stays = !less(phi(curve, b, i), here);
    used = mark;
    return stays;
}

/* The derivative of phi by t, and the second one. */
static void by_foot(num *curve, int i, num t, num *first, num *second)
{
    num *b = several(problem.count), h = power2(real(1), STEP);
    basis(t, b);
    num here = phi(curve, b, i);
    basis(add(t, h), b);
    num after = phi(curve, b, i);
    basis(sub(t, h), b);
    num before = phi(curve, b, i);
    *first = power2(sub(after, before), -STEP - 1);
    *second = power2(sub(add(after, before), power2(here, 1)), -2 * STEP);
}

int settle(num *curve, int i, num t, int *end)
{
    int p = problem.p, count = problem.count;
    size_t mark = used;
    *end = 0;
    for (int k = 0; k < 60; k++, used = mark) {
        int start = !less(problem.knot[p], t), stop_here = !less(t, problem.knot[count]);
        if (start || stop_here) {
            set(t, problem.knot[start ? p : count]);
            *end = stays_at_end(curve, i, t);
            if (*end) {
                used = mark;
                return 1;
            }
            set(t, add(t, power2(sub(problem.knot[start ? p + 1 : count - 1], t), -20)));
        }
        num first, second;
        by_foot(curve, i, t, &first, &second);
        if (mpfr_sgn(second) <= 0)
            break;
        num moves = quo(first, second);
        set(t, sub(t, moves));
        if (less(size(moves), power2(real(1), -140)) && less(problem.knot[p], t) && less(t, problem.knot[count])) {
            used = mark;
            return 1;
        }
    }
    used = mark;
    return 0;
}

void find_feet(num *curve)
{
    int p = problem.p, dim = problem.dim, count = problem.count;
    int total = 0;
    num *t = numbers((size_t)(count - p) * SAMPLES + 1), *b = numbers((size_t)count);
    double *x = malloc(((size_t)(count - p) * SAMPLES + 1) * (size_t)dim * sizeof *x);
    for (int s = p; s < count; s++)
        for (int k = 0; k < SAMPLES + (s == count - 1); k++, total++) {
            size_t mark = used;
            double ratio = exp2(40.0 * k / SAMPLES - 20); /* closer together near the ends of a span */
            set(t[total],
                add(problem.knot[s], mul(sub(problem.knot[s + 1], problem.knot[s]), real(ratio / (1 + ratio)))));
            if (k % SAMPLES == 0)
                set(t[total], problem.knot[s + (k > 0)]);
            num r[3];
            basis(t[total], b);
            residual(curve, b, 0, r);
            for (int c = 0; c < dim; c++)
                x[total * dim + c] = mpfr_get_d(sub(real(problem.Q[c]), r[c]), MPFR_RNDN);
            used = mark;
        }
    for (int i = 0; i < problem.N; i++) {
        size_t mark = used;
        int k = 0;
        double nearest = INFINITY;
        for (int j = 0; j < total; j++) {
            double d = 0;
            for (int c = 0; c < dim; c++)
                d += (x[j * dim + c] - problem.Q[i * dim + c]) * (x[j * dim + c] - problem.Q[i * dim + c]);
            if (d < nearest)
                nearest = d, k = j;
        }
        found.at_end[i] = (k == 0 || k == total - 1) && stays_at_end(curve, i, t[k]);
        set(found.foot[i], t[k]);
        num a = real(0), c = real(0);
        set(a, t[k > 0 ? k - 1 : 0]), set(c, t[k < total - 1 ? k + 1 : k]);
        size_t inner = used;
        for (int step = 0; step < 100 && !found.at_end[i]; step++, used = inner) {
            num first, second;
            if (mpfr_equal_p(found.foot[i], a) || mpfr_equal_p(found.foot[i], c)) /* only the first time, at an end */
                set(found.foot[i], power2(add(a, c), -1));
            by_foot(curve, i, found.foot[i], &first, &second);
            set(mpfr_sgn(first) > 0 ? c : a, found.foot[i]);
            num next = mpfr_sgn(second) > 0 ? sub(found.foot[i], quo(first, second)) : a;
            if (!less(a, next) || !less(next, c))
                next = power2(add(a, c), -1);
            num moved = size(sub(next, found.foot[i]));
            set(found.foot[i], next);
            if (less(moved, power2(real(1), -80)))
                break;
        }
        used = mark;
        if (!settle(curve, i, found.foot[i], &found.at_end[i]))
            stop("point %d has no foot", i + 1);
    }
    free(x); /* the numbers stay until the process ends */
}
