/* certify.c -- the certified answers of the fit (参考解), by another way than the fit's.
 *
 *     certify PROBLEM.json ...        adds the object "certified" to each file; the points stand beside it
 *
 * Numbers have 512 bits (MPFR).  All unknowns, the foot points among them, are varied together by Newton's method from
 * the true curve, and the only formulas below are that of the curve and that of the cost:
 *
 *     phi(theta, t) = rho(|Q - C(t; theta)|^2 / s^2) / 2.
 *
 * Every derivative is a quotient of differences with the step h = 2^-128, hence right to a relative 2^-256
 * (first ones, central) or 2^-128 (second ones, which steer the iteration and condition numbers alone).  As a foot is coupled to the
 * curve and to no other foot, the Newton matrix is an arrow, and the feet are eliminated one by one; after a step each
 * goes on by itself to where its distance is stationary.
 * The iteration ends when no component of the gradient exceeds 1e-40; the point found is a strict minimum when
 * all pivots are positive, which is checked. */
#include <jansson.h>
#include <math.h>
#include <mpfr.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { BITS = 512, STEP = -128, SAMPLES = 800, SMALL = 133, MOST = 32, ITERATIONS = 200 }; /* 2^-133 < 1e-40 */

typedef mpfr_ptr num;

static void stop(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    fputs("certify: ", stderr);
    vfprintf(stderr, format, arguments);
    fputc('\n', stderr);
    va_end(arguments);
    exit(1);
}

/* Numbers that stay, and numbers that are gone when `used` is set back. */
static num *numbers(size_t count)
{
    num *a = malloc(count * sizeof *a);
    mpfr_t *m = malloc(count * sizeof *m);
    if (a == NULL || m == NULL)
        stop("no memory");
    for (size_t k = 0; k < count; k++) {
        mpfr_init2(m[k], BITS);
        mpfr_set_zero(m[k], 1);
        a[k] = m[k];
    }
    return a;
}
static num *pool;
static size_t used;
enum { POOL = 1 << 14 };
static num fresh(void)
{
    if (used == POOL)
        stop("more numbers in one expression than expected");
    return pool[used++];
}
static num *several(int k)
{
    num *a = pool + used;
    for (; k > 0; k--)
        fresh();
    return a;
}
#define BINARY(name, function)                                                                                         \
    static num name(num a, num b)                                                                                      \
    {                                                                                                                  \
        num r = fresh();                                                                                               \
        function(r, a, b, MPFR_RNDN);                                                                                  \
        return r;                                                                                                      \
    }
#define UNARY(name, function)                                                                                          \
    static num name(num a)                                                                                             \
    {                                                                                                                  \
        num r = fresh();                                                                                               \
        function(r, a, MPFR_RNDN);                                                                                     \
        return r;                                                                                                      \
    }
BINARY(add, mpfr_add)
BINARY(sub, mpfr_sub)
BINARY(mul, mpfr_mul)
BINARY(quo, mpfr_div)
UNARY(root, mpfr_sqrt)
UNARY(size, mpfr_abs)
UNARY(logarithm, mpfr_log)
UNARY(exponential, mpfr_exp)
static num real(double x)
{
    num r = fresh();
    mpfr_set_d(r, x, MPFR_RNDN);
    return r;
}
static num power2(num a, long e)
{
    num r = fresh();
    mpfr_mul_2si(r, a, e, MPFR_RNDN);
    return r;
}
static void set(num a, num b) { mpfr_set(a, b, MPFR_RNDN); }
static void increase(num a, num b) { mpfr_add(a, a, b, MPFR_RNDN); }
static int less(num a, num b) { return mpfr_less_p(a, b); }

/* The problem. */
static int p, count, dim, N;
static double *Q, *sigma; /* the points; their deviations, 1 where none are given */
static int known_sigma;
static num *knot;
enum { SQUARES, HUBER, CAUCHY } loss;
static double scale, low, high;

/* The unknowns: logarithm of a weight, or a coordinate of a point; those that are held are not varied. */
static struct {
    int is_weight, index, coordinate;
} unknown[MOST];
static int m, held[MOST], at_bound[MOST];
static num *value, *weight, *points; /* of the unknowns; of the curve before the unknowns are put in */

/* A curve: w_j and, behind them, w_j P_j. */
static void curve_of(num *theta, num *curve)
{
    size_t mark = used;
    num w[MOST], P[MOST][3];
    for (int j = 0; j < count; j++) {
        w[j] = weight[j];
        for (int c = 0; c < dim; c++)
            P[j][c] = points[j * dim + c];
    }
    for (int k = 0; k < m; k++)
        if (unknown[k].is_weight)
            w[unknown[k].index] = exponential(theta[k]);
        else
            P[unknown[k].index][unknown[k].coordinate] = theta[k];
    for (int j = 0; j < count; j++) {
        set(curve[j], w[j]);
        for (int c = 0; c < dim; c++)
            set(curve[count + j * dim + c], mul(w[j], P[j][c]));
    }
    used = mark;
}

/* N_{j,p}(t), j = 0 ... count-1, by the recursion that defines them, on the span that holds t. */
static void basis(num t, num *b)
{
    size_t mark = used;
    int s = p;
    while (s < count - 1 && !less(t, knot[s + 1]))
        s++;
    num row[MOST];
    for (int j = 0; j <= count + p; j++)
        row[j] = real(j == s);
    for (int d = 1; d <= p; d++)
        for (int j = s - d; j <= s; j++) {
            num left = quo(mul(sub(t, knot[j]), row[j]), sub(knot[j + d], knot[j]));
            num right = quo(mul(sub(knot[j + d + 1], t), row[j + 1]), sub(knot[j + d + 1], knot[j + 1]));
            row[j] = j == s ? left : j == s - d ? right : add(left, right);
        }
    for (int j = 0; j < count; j++)
        set(b[j], row[j]);
    used = mark;
}

/* Q_i - C: coordinates into r. */
static void residual(num *curve, num *b, int i, num *r)
{
    num w = real(0), x[3] = {real(0), real(0), real(0)};
    for (int j = 0; j < count; j++) {
        if (mpfr_zero_p(b[j]))
            continue;
        increase(w, mul(b[j], curve[j]));
        for (int c = 0; c < dim; c++)
            increase(x[c], mul(b[j], curve[count + j * dim + c]));
    }
    for (int c = 0; c < dim; c++)
        r[c] = sub(real(Q[i * dim + c]), quo(x[c], w));
}

static num phi(num *curve, num *b, int i)
{
    num r[3], x = real(0), s = real(sigma[i]), a = real(scale);
    residual(curve, b, i, r);
    for (int c = 0; c < dim; c++)
        increase(x, mul(r[c], r[c]));
    x = quo(x, mul(s, s));
    if (loss == HUBER && less(mul(a, a), x))
        x = sub(mul(power2(a, 1), root(x)), mul(a, a));
    else if (loss == CAUCHY)
        x = mul(mul(a, a), logarithm(add(real(1), quo(x, mul(a, a)))));
    return power2(x, -1);
}

static num *foot;
static int *at_end;
/* 1 if the distance grows into the domain, from its end t. */
static int stays_at_end(num *curve, int i, num t)
{
    size_t mark = used;
    num *b = several(count);
    num inside = add(t, power2(real(mpfr_equal_p(t, knot[p]) ? 1 : -1), STEP));
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
    num *b = several(count), h = power2(real(1), STEP);
    basis(t, b);
    num here = phi(curve, b, i);
    basis(add(t, h), b);
    num after = phi(curve, b, i);
    basis(sub(t, h), b);
    num before = phi(curve, b, i);
    *first = power2(sub(after, before), -STEP - 1);
    *second = power2(sub(add(after, before), power2(here, 1)), -2 * STEP);
}

/* The foot near t, by Newton's method; *end: whether it is an end of the domain.  0 if it is not found. */
static int settle(num *curve, int i, num t, int *end)
{
    size_t mark = used;
    *end = 0;
    for (int k = 0; k < 60; k++, used = mark) {
        int start = !less(knot[p], t), stop_here = !less(t, knot[count]);
        if (start || stop_here) {
            set(t, knot[start ? p : count]);
            *end = stays_at_end(curve, i, t);
            if (*end) {
                used = mark;
                return 1;
            }
            set(t, add(t, power2(sub(knot[start ? p + 1 : count - 1], t), -20)));
        }
        num first, second;
        by_foot(curve, i, t, &first, &second);
        if (mpfr_sgn(second) <= 0)
            break;
        num moves = quo(first, second);
        set(t, sub(t, moves));
        if (less(size(moves), power2(real(1), -140)) && less(knot[p], t) && less(t, knot[count])) {
            used = mark;
            return 1;
        }
    }
    used = mark;
    return 0;
}

/* The nearest foot of every point: the nearest of many samples, then Newton between its neighbours, else bisection. */
static void find_feet(num *curve)
{
    int total = 0;
    num *t = numbers((size_t)(count - p) * SAMPLES + 1), *b = numbers((size_t)count);
    double *x = malloc(((size_t)(count - p) * SAMPLES + 1) * (size_t)dim * sizeof *x);
    for (int s = p; s < count; s++)
        for (int k = 0; k < SAMPLES + (s == count - 1); k++, total++) {
            size_t mark = used;
            double ratio = exp2(40.0 * k / SAMPLES - 20); /* closer together near the ends of a span */
            set(t[total], add(knot[s], mul(sub(knot[s + 1], knot[s]), real(ratio / (1 + ratio)))));
            if (k % SAMPLES == 0)
                set(t[total], knot[s + (k > 0)]);
            num r[3];
            basis(t[total], b);
            residual(curve, b, 0, r);
            for (int c = 0; c < dim; c++)
                x[total * dim + c] = mpfr_get_d(sub(real(Q[c]), r[c]), MPFR_RNDN);
            used = mark;
        }
    for (int i = 0; i < N; i++) {
        size_t mark = used;
        int k = 0;
        double nearest = INFINITY;
        for (int j = 0; j < total; j++) {
            double d = 0;
            for (int c = 0; c < dim; c++)
                d += (x[j * dim + c] - Q[i * dim + c]) * (x[j * dim + c] - Q[i * dim + c]);
            if (d < nearest)
                nearest = d, k = j;
        }
        at_end[i] = (k == 0 || k == total - 1) && stays_at_end(curve, i, t[k]);
        set(foot[i], t[k]);
        num a = real(0), c = real(0);
        set(a, t[k > 0 ? k - 1 : 0]), set(c, t[k < total - 1 ? k + 1 : k]);
        size_t inner = used;
        for (int step = 0; step < 100 && !at_end[i]; step++, used = inner) {
            num first, second;
            if (mpfr_equal_p(foot[i], a) || mpfr_equal_p(foot[i], c)) /* only the first time, at an end */
                set(foot[i], power2(add(a, c), -1));
            by_foot(curve, i, foot[i], &first, &second);
            set(mpfr_sgn(first) > 0 ? c : a, foot[i]);
            num next = mpfr_sgn(second) > 0 ? sub(foot[i], quo(first, second)) : a;
            if (!less(a, next) || !less(next, c))
                next = power2(add(a, c), -1);
            num moved = size(sub(next, foot[i]));
            set(foot[i], next);
            if (less(moved, power2(real(1), -80)))
                break;
        }
        used = mark;
        if (!settle(curve, i, foot[i], &at_end[i]))
            stop("point %d has no foot", i + 1);
    }
    free(x); /* the numbers stay until the process ends */
}

/* Solves A x = b, A symmetric, n by n, for several right-hand sides, the columns of b, which become the solutions;
 * by elimination without exchanges.  1 if all pivots are positive. */
static int solve(int n, num *A, int columns, num *b)
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

static num cost(num *theta, num *t)
{
    static num *curve, *b;
    if (curve == NULL)
        curve = numbers((size_t)count * 4), b = numbers((size_t)count);
    num F = fresh();
    set(F, real(0));
    curve_of(theta, curve);
    for (int i = 0; i < N; i++) {
        size_t mark = used;
        basis(t[i], b);
        increase(F, phi(curve, b, i));
        used = mark;
    }
    return F;
}

/* The varied unknowns by number, and the curves with one or two of them moved by h. */
static int varied[MOST], n;
static num **moved; /* [0] none, [1+k] + in k, [1+n+k] - in k, then + in k and in l for k < l */
static int pair(int k, int l) { return 1 + 2 * n + (k < l ? l * (l - 1) / 2 + k : k * (k - 1) / 2 + l); }
static void move_curves(void)
{
    if (moved == NULL) {
        moved = malloc((size_t)(1 + 2 * n + n * n) * sizeof *moved);
        for (int k = 0; k < 1 + 2 * n + n * (n - 1) / 2; k++)
            moved[k] = numbers((size_t)count * (size_t)(dim + 1));
    }
    size_t mark = used;
    num theta[MOST], h = power2(real(1), STEP);
    memcpy(theta, value, (size_t)m * sizeof *theta);
    curve_of(theta, moved[0]);
    for (int k = 0; k < n; k++) {
        int a = varied[k];
        theta[a] = sub(value[a], h), curve_of(theta, moved[1 + n + k]);
        theta[a] = add(value[a], h), curve_of(theta, moved[1 + k]);
        for (int l = 0; l < k; l++) {
            int c = varied[l];
            theta[c] = add(value[c], h), curve_of(theta, moved[pair(k, l)]);
            theta[c] = value[c];
        }
        theta[a] = value[a];
    }
    used = mark;
}

/* Gradient and Newton matrix of point i in the n varied unknowns and, as number n, the foot. */
static void derivatives(int i, num *b[3], num *g, num *H)
{
    int e = n + 1;
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
static num *S, *r, *arrow;
static num reduce(void)
{
    num *b[3], largest = fresh(), h = power2(real(1), STEP);
    set(largest, real(0));
    for (int k = 0; k < 3; k++)
        b[k] = several(count);
    move_curves();
    for (int k = 0; k < n * n; k++)
        set(S[k], real(0));
    num *total = several(n);
    for (int k = 0; k < n; k++)
        set(r[k], real(0)), set(total[k], real(0));
    for (int i = 0; i < N; i++) {
        size_t mark = used;
        num g[MOST + 1], H[(MOST + 1) * (MOST + 1)], *row = arrow + (size_t)i * (size_t)(n + 2);
        basis(foot[i], b[0]), basis(add(foot[i], h), b[1]), basis(sub(foot[i], h), b[2]);
        derivatives(i, b, g, H);
        num d = H[(n + 1) * (n + 1) - 1];
        if (!at_end[i] && mpfr_sgn(d) <= 0)
            stop("the foot of point %d is no minimum", i + 1);
        if (!at_end[i] && less(largest, size(g[n])))
            set(largest, size(g[n]));
        for (int k = 0; k < n; k++) {
            num b_k = H[n * (n + 1) + k];
            increase(total[k], g[k]);
            increase(r[k], at_end[i] ? g[k] : sub(g[k], quo(mul(b_k, g[n]), d)));
            for (int l = 0; l < n; l++) {
                num h_kl = H[k * (n + 1) + l];
                increase(S[k * n + l], at_end[i] ? h_kl : sub(h_kl, quo(mul(b_k, H[n * (n + 1) + l]), d)));
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

/* What the residual of point i, divided by s_i, does when the unknowns move: rest, and in J the derivatives without their part along
 * the curve, for the foot follows.  E bounds how wrong each derivative may be when computed with relative errors of eps = 1:
 * |dC/d theta| and, for a weight, where points are subtracted, M; and the tangent turned by 2 p M/(smallest span |C'|). */
static num largest_coordinate, smallest_span;
static void jacobian(int i, num *b[3], num rest[3], num J[MOST][3], num E[MOST])
{
    num whole[MOST][3];
    num T[3], plus[3], minus[3], TT = real(0), s = real(sigma[i]), h = power2(real(1), STEP);
    basis(foot[i], b[0]), basis(add(foot[i], h), b[1]), basis(sub(foot[i], h), b[2]);
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
            J[k][c] = at_end[i] ? whole[k][c] : sub(whole[k][c], mul(along, T[c]));
            increase(E[k], mul(whole[k][c], whole[k][c]));
        }
        num turned = quo(mul(real(2 * p), largest_coordinate), mul(smallest_span, root(TT)));
        E[k] = mul(root(E[k]), add(real(1), turned));
        if (unknown[varied[k]].is_weight)
            increase(E[k], quo(largest_coordinate, s));
    }
}

/* rho', rho'' at x. */
static void loss_derivatives(num x, num *first, num *second)
{
    num aa = real(scale);
    aa = mul(aa, aa);
    *first = real(1), *second = real(0);
    if (loss == HUBER && less(aa, x)) {
        *first = root(quo(aa, x));
        *second = power2(quo(*first, mul(real(-1), x)), -1);
    } else if (loss == CAUCHY) {
        *first = quo(aa, add(aa, x));
        *second = quo(mul(*first, *first), mul(real(-1), aa));
    }
}

/* A = J^T J, each point counted rho'(x) times, x its squared distance, or once if not robust; B, unless it is NULL, = E^T E. */
static void gauss_newton(num *A, num *B, int robust)
{
    num *b[3] = {several(count), several(count), several(count)};
    for (int k = 0; k < n * n; k++) {
        set(A[k], real(0));
        if (B != NULL)
            set(B[k], real(0));
    }
    for (int i = 0; i < N; i++) {
        size_t mark = used;
        num rest[3], J[MOST][3], E[MOST], x = real(0), share = real(1), second;
        jacobian(i, b, rest, J, E);
        for (int c = 0; c < dim; c++)
            increase(x, mul(rest[c], rest[c]));
        if (robust)
            loss_derivatives(x, &share, &second);
        for (int k = 0; k < n; k++)
            for (int l = 0; l < n; l++) {
                for (int c = 0; c < dim; c++)
                    increase(A[k * n + l], mul(share, mul(J[k][c], J[l][c])));
                if (B != NULL)
                    increase(B[k * n + l], mul(E[k], E[l]));
            }
        used = mark;
    }
}

/* One step: theta from value, and t from foot as the linear system has it, with the matrix M, its diagonal made larger by
 * the factor 1+damping; 0 if it is not positive. */
static int step(num *M, num damping, num *A, num *x, num *theta, num *t)
{
    size_t mark = used;
    for (int k = 0; k < n * n; k++)
        set(A[k], k % (n + 1) == 0 ? mul(add(real(1), damping), M[k]) : M[k]);
    for (int k = 0; k < n; k++)
        set(x[k], r[k]);
    int positive = solve(n, A, 1, x);
    for (int k = 0; k < m; k++)
        set(theta[k], value[k]);
    for (int k = 0; k < n; k++)
        set(theta[varied[k]], sub(value[varied[k]], x[k]));
    for (int i = 0; i < N; i++) {
        size_t inner = used;
        num *row = arrow + (size_t)i * (size_t)(n + 2), s = row[n];
        for (int k = 0; k < n; k++)
            s = sub(s, mul(row[k], x[k]));
        set(t[i], at_end[i] ? foot[i] : sub(foot[i], quo(s, row[n + 1])));
        used = inner;
    }
    used = mark;
    return positive;
}

/* Newton's method, and where its step is none or does not decrease the cost, damped Gauss-Newton; the number of iterations. */
static num gradient;
static int minimise(void)
{
    num *theta = numbers((size_t)m), *t = numbers((size_t)N), *A = numbers((size_t)(n * n)), *x = numbers((size_t)n);
    num *G = numbers((size_t)(n * n)), damping = numbers(1)[0];
    set(damping, real(0x1p-20));
    num *curve = numbers((size_t)(count * (dim + 1)));
    int *end = malloc((size_t)N * sizeof *end);
    S = numbers((size_t)(n * n)), r = numbers((size_t)n), arrow = numbers((size_t)N * (size_t)(n + 2));
    for (int iteration = 0; iteration < ITERATIONS; iteration++) {
        size_t mark = used;
        num largest = reduce(), F = cost(value, foot);
        if (getenv("CERTIFY_TABLE") != NULL)
            mpfr_printf("%3d %.20Re %.3Re %.2Re\n", iteration, F, largest, damping);
        if (less(largest, power2(real(1), -SMALL))) {
            set(gradient, largest);
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
        for (int k = 0; k < m; k++)
            set(value[k], theta[k]);
        for (int i = 0; i < N; i++)
            set(foot[i], t[i]), at_end[i] = end[i];
        used = mark;
    }
    stop("no convergence");
    return 0;
}

/* log I_j = log of w_j^2/(w_{j-1} w_{j+1}) as a linear form in the varied unknowns. */
static void invariant_form(int j, int v[MOST])
{
    for (int k = 0; k < n; k++) {
        int apart = abs(unknown[varied[k]].index - j);
        v[k] = !unknown[varied[k]].is_weight ? 0 : apart == 0 ? 2 : apart == 1 ? -1 : 0;
    }
}
static int invariants(void) { return count == p + 1 && p > 1 ? p - 1 : 0; }

/* What the covariance (J^T J)^-1 is multiplied by: 1 or chi^2/d; for a robust loss Huber's factor, as core/fit/statistics.h has it. */
static num scale_squared(void)
{
    num d = real(N * (dim - 1) - n), sum = real(0), mean = real(0), squared = real(0), *b = several(count);
    for (int i = 0; i < N; i++) {
        size_t mark = used;
        num rest[3], x = real(0), first, second, s = real(sigma[i]);
        basis(foot[i], b);
        residual(moved[0], b, i, rest);
        for (int c = 0; c < dim; c++)
            increase(x, mul(rest[c], rest[c]));
        x = quo(x, mul(s, s));
        loss_derivatives(x, &first, &second);
        num m_i = add(first, quo(power2(mul(x, second), 1), real(dim - 1)));
        increase(sum, mul(mul(first, first), x)), increase(mean, m_i), increase(squared, mul(m_i, m_i));
        used = mark;
    }
    if (loss == SQUARES)
        return known_sigma ? real(1) : quo(sum, d);
    mean = quo(mean, real(N));
    num ratio = quo(sub(quo(squared, real(N)), mul(mean, mean)), mul(mean, mean));
    num K = add(real(1), mul(quo(real(n), real(N * (dim - 1))), ratio));
    return quo(mul(mul(K, K), quo(sum, d)), mul(mean, mean));
}

/* Standard errors: of the n unknowns, then of the logarithms of the invariants.  With rounding not NULL also what relative errors of the
 * derivatives of eps = 1 make of each: |C| E^T E |C| / C on the diagonal, halved for the root and doubled for the two factors. */
static void standard_errors(num *result, num *rounding)
{
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

/* How many pivots of J^T J vanish.  Where the whole curve has a cusp, inside the domain or not, displacements phi C' along the curve are
 * regular for a phi with a pole there: J has one more direction in which no point moves off the curve, yet the cost is not flat. */
static int missing_rank(void)
{
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

/* How far the answer may move when every residual is wrong by eps times the largest coordinate M and every derivative by eps E:
 *     |d theta_j| <= eps condition_j,  condition_j = sum_i |(S^-1 J_i)_j| M/s_i + (|S^-1| E_i)_j |r_i|,
 *     |d F|       <= eps cost_condition + eps^2 cost_floor/2 = eps sum_i |r_i| M/s_i + eps^2/2 sum_i (M/s_i)^2,
 * S the reduced Newton matrix.  Where the cost is larger than at the minimum by dF, theta_j is off by at most sqrt(2 dF) spread_j, spread_j the
 * root of (S^-1)_jj.  And the standard errors by what the derivatives make of them, and by moving with theta. */
static num *condition, *spread, *error_of, *error_condition, cost_condition, cost_floor, squares, chi;
static int missing;
static void statistics(void)
{
    num *inverse = numbers((size_t)(n * n)), *beside = numbers(2 * MOST), step_size = power2(real(1), -64);
    condition = numbers((size_t)n), spread = numbers((size_t)n), error_of = numbers(2 * MOST),
    error_condition = numbers(2 * MOST);
    for (int k = 0; k < n; k++)
        set(inverse[k * n + k], real(1));
    reduce(), solve(n, S, n, inverse);
    for (int k = 0; k < n; k++)
        set(spread[k], root(inverse[k * n + k]));
    num *b[3] = {several(count), several(count), several(count)};
    for (int i = 0; i < N; i++) {
        size_t mark = used;
        num rest[3], J[MOST][3], E[MOST], length = real(0), s = real(sigma[i]), unit = quo(largest_coordinate, s);
        jacobian(i, b, rest, J, E);
        for (int c = 0; c < dim; c++)
            increase(length, mul(rest[c], rest[c]));
        increase(chi, length), increase(squares, mul(length, mul(s, s)));
        length = root(length);
        increase(cost_condition, mul(length, unit)), increase(cost_floor, mul(unit, unit));
        for (int k = 0; k < n; k++) {
            for (int c = 0; c < dim; c++) {
                num G = real(0);
                for (int l = 0; l < n; l++)
                    increase(G, mul(inverse[k * n + l], J[l][c]));
                increase(condition[k], mul(size(G), unit));
            }
            for (int l = 0; l < n; l++)
                increase(condition[k], mul(mul(size(inverse[k * n + l]), E[l]), length));
        }
        used = mark;
    }
    missing = missing_rank();
    if (missing > 0)
        return;
    standard_errors(error_of, error_condition);
    num *here = numbers((size_t)N);
    for (int i = 0; i < N; i++)
        set(here[i], foot[i]);
    for (int l = 0; l < n; l++) { /* the feet follow */
        size_t mark = used;
        num was = real(0);
        set(was, value[varied[l]]);
        set(value[varied[l]], add(was, step_size));
        move_curves();
        for (int i = 0; i < N; i++)
            if (!settle(moved[0], i, foot[i], &at_end[i]))
                stop("point %d loses its foot", i + 1);
        standard_errors(beside, NULL);
        for (int f = 0; f < n + invariants(); f++)
            increase(error_condition[f], mul(quo(size(sub(beside[f], error_of[f])), step_size), condition[l]));
        set(value[varied[l]], was);
        for (int i = 0; i < N; i++)
            set(foot[i], here[i]);
        used = mark;
    }
    move_curves();
}

/* The files. */
static double entry(const json_t *a, size_t k) { return json_number_value(json_array_get(a, k)); }
static void fraction(num a, const json_t *entry_text)
{
    mpq_t q;
    mpq_init(q);
    if (mpq_set_str(q, json_string_value(entry_text), 10) != 0)
        stop("the true curve has an entry that is no rational number");
    mpfr_set_q(a, q, MPFR_RNDN);
    mpq_clear(q);
}

static void read_points(const char *path)
{
    FILE *file = fopen(path, "r");
    char line[1024];
    int room = 0;
    if (file == NULL)
        stop("%s: cannot be read", path);
    while (fgets(line, sizeof line, file) != NULL) {
        if (line[0] == '#')
            continue;
        if (line[0] == 'x') { /* the header */
            dim = strstr(line, "z") != NULL ? 3 : 2, known_sigma = strstr(line, "sigma") != NULL;
            continue;
        }
        if (N == room) {
            room = 2 * room + 64;
            Q = realloc(Q, (size_t)(room * dim) * sizeof *Q), sigma = realloc(sigma, (size_t)room * sizeof *sigma);
        }
        char *at = line;
        for (int c = 0; c < dim + known_sigma; c++) {
            double x = strtod(at, &at);
            if (*at != (c < dim + known_sigma - 1 ? ',' : '\n'))
                stop("%s: row %d is not as expected", path, N + 1);
            at++;
            *(c < dim ? &Q[N * dim + c] : &sigma[N]) = x;
        }
        if (!known_sigma)
            sigma[N] = 1;
        N++;
    }
    fclose(file);
}

static int listed(const json_t *list, const char *word)
{
    for (size_t k = 0; k < json_array_size(list); k++)
        if (strcmp(json_string_value(json_array_get(list, k)), word) == 0)
            return 1;
    return 0;
}

static void hold(int is_weight, int index, int coordinate)
{
    for (int k = 0; k < m; k++)
        if (unknown[k].is_weight == is_weight && unknown[k].index == index && unknown[k].coordinate == coordinate)
            held[k] = 1;
}

static void read_problem(json_t *file)
{
    const json_t *options = json_object_get(file, "options"), *truth = json_object_get(file, "truth"), *knots, *word,
                 *start = json_object_get(options, "initial"), *free_ones = json_object_get(options, "free"), *pins;
    p = (int)json_integer_value(json_object_get(options, "degree"));
    count = (int)json_array_size(json_object_get(truth, "weights"));
    knots = json_object_get(options, "knots");
    weight = numbers((size_t)count), points = numbers((size_t)(count * dim));
    knot = numbers((size_t)(count + p + 1)), value = numbers(MOST);
    for (int j = 0; j <= count + p; j++)
        mpfr_set_d(knot[j], knots != NULL ? entry(knots, (size_t)j) : j > p, MPFR_RNDN);
    int fixed_ends = !listed(free_ones, "ends"), fixed_inner = !listed(free_ones, "inner"), last = count - 1;
    for (int j = 0; j < count; j++) {
        fraction(weight[j], json_array_get(json_object_get(truth, "weights"), (size_t)j));
        for (int c = 0; c < dim; c++) {
            const json_t *P = json_array_get(json_object_get(truth, "points"), (size_t)j);
            fraction(points[j * dim + c], json_array_get(P, (size_t)c));
            int fixed = j == 0 || j == last ? fixed_ends : fixed_inner;
            if (fixed && start != NULL)
                mpfr_set_d(points[j * dim + c],
                           entry(json_array_get(json_object_get(start, "points"), (size_t)j), (size_t)c), MPFR_RNDN);
            else if (fixed)
                mpfr_set_d(points[j * dim + c], Q[(j == 0 ? 0 : N - 1) * dim + c], MPFR_RNDN);
            if (!fixed) {
                unknown[m].index = j, unknown[m].coordinate = c;
                set(value[m++], points[j * dim + c]);
            }
        }
    }
    const json_t *bounds = json_object_get(options, "weights-between");
    low = bounds != NULL ? entry(bounds, 0) : 0, high = bounds != NULL ? entry(bounds, 1) : INFINITY;
    for (int j = 1; j < (count == p + 1 ? last : count) && listed(free_ones, "weights"); j++) {
        double w = mpfr_get_d(weight[j], MPFR_RNDN), bound = w < low ? low : w > high ? high : w;
        if (w != bound) {
            at_bound[m] = held[m] = 1;
            mpfr_set_d(weight[j], bound, MPFR_RNDN);
        }
        unknown[m].is_weight = 1, unknown[m].index = j;
        size_t mark = used;
        set(value[m++], logarithm(weight[j]));
        used = mark;
    }
    if ((word = json_object_get(options, "loss")) != NULL)
        loss = strcmp(json_string_value(word), "huber") == 0 ? HUBER : CAUCHY;
    scale = loss == SQUARES ? 1 : json_number_value(json_object_get(options, "scale"));
    if ((pins = json_object_get(file, "hold")) != NULL) /* coordinates of ends that slide */
        for (size_t k = 0; k < json_array_size(pins); k++)
            hold(0, (int)json_integer_value(json_array_get(json_array_get(pins, k), 0)),
                 (int)json_integer_value(json_array_get(json_array_get(pins, k), 1)));
    for (int k = 0; k < m; k++)
        if (!held[k])
            varied[n++] = k;
    foot = numbers((size_t)N), at_end = calloc((size_t)N, sizeof *at_end), gradient = numbers(1)[0];
    cost_condition = numbers(1)[0], cost_floor = numbers(1)[0], squares = numbers(1)[0], chi = numbers(1)[0];
    largest_coordinate = numbers(1)[0], smallest_span = numbers(1)[0];
    double most = 0;
    for (int k = 0; k < N * dim; k++)
        most = fmax(most, fabs(Q[k]));
    for (int j = 0; j < count * dim; j++)
        most = fmax(most, fabs(mpfr_get_d(points[j], MPFR_RNDA)));
    mpfr_set_d(largest_coordinate, most, MPFR_RNDN);
    mpfr_sub(smallest_span, knot[count], knot[p], MPFR_RNDN);
    for (int s = p; s < count; s++) {
        size_t mark = used;
        if (less(sub(knot[s + 1], knot[s]), smallest_span))
            set(smallest_span, sub(knot[s + 1], knot[s]));
        used = mark;
    }
}

static json_t *text(num a, int digits)
{
    char *s;
    mpfr_asprintf(&s, "%.*Re", digits - 1, a);
    json_t *result = json_string(s);
    mpfr_free_str(s);
    return result;
}

/* A weight on its bound: the cost must fall beyond it. */
static void check_bounds(void)
{
    for (int k = 0; k < m; k++)
        if (at_bound[k]) {
            size_t mark = used;
            num theta[MOST], here = cost(value, foot);
            memcpy(theta, value, (size_t)m * sizeof *theta);
            int above = mpfr_get_d(value[k], MPFR_RNDN) > 0;
            theta[k] = add(value[k], power2(real(above ? 1 : -1), STEP));
            if (!less(cost(theta, foot), here))
                stop("the bound of a weight does not bind");
            used = mark;
        }
}

static json_t *answer(int iterations)
{
    enum { DIGITS = 20, FEW = 4 };
    json_t *a = json_object(), *list, *row;
    int dof = N * (dim - 1) - n + missing, ends = 0, slides = 0;
    for (int k = 0; k < m; k++)
        slides |= held[k] && !at_bound[k];
    for (int i = 0; i < N; i++)
        ends += at_end[i];
    json_object_set_new(a, "bits", json_integer(BITS));
    json_object_set_new(a, "iterations", json_integer(iterations));
    json_object_set_new(a, "gradient", text(gradient, 2));
    json_object_set_new(a, "count", json_integer(N));
    json_object_set_new(a, "feet_at_end", json_integer(ends));
    json_object_set_new(a, "unknowns", json_integer(m));
    json_object_set_new(a, "rank", json_integer(n - missing));
    json_object_set_new(a, "degrees_of_freedom", json_integer(dof));
    json_object_set_new(a, "cost", text(cost(value, foot), DIGITS));
    json_object_set_new(a, "cost_condition", text(cost_condition, FEW));
    json_object_set_new(a, "cost_floor", text(cost_floor, FEW));
    json_object_set_new(a, "largest_coordinate", text(largest_coordinate, DIGITS));
    json_object_set_new(a, "rms", text(root(quo(squares, real(N))), DIGITS));
    if (missing == 0)
        json_object_set_new(a, "scale_squared", text(scale_squared(), DIGITS));
    if (slides) /* only the cost is the same for all curves that are slid */
        return a;
    num *curve = numbers((size_t)(count * (dim + 1)));
    curve_of(value, curve);
    json_object_set_new(a, "weights", list = json_array());
    for (int j = 0; j < count; j++)
        json_array_append_new(list, text(curve[j], DIGITS));
    json_object_set_new(a, "points", list = json_array());
    for (int j = 0; j < count; j++) {
        json_array_append_new(list, row = json_array());
        for (int c = 0; c < dim; c++)
            json_array_append_new(row, text(quo(curve[count + j * dim + c], curve[j]), DIGITS));
    }
    json_t *estimates;
    json_object_set_new(a, "estimates", estimates = json_array());
    for (int k = 0; k < n; k++) {
        int u = varied[k];
        json_array_append_new(estimates, row = json_object());
        json_object_set_new(row, unknown[u].is_weight ? "log-weight" : "point", json_integer(unknown[u].index));
        if (!unknown[u].is_weight)
            json_object_set_new(row, "coordinate", json_integer(unknown[u].coordinate));
        json_object_set_new(row, "value", text(value[u], DIGITS));
        json_object_set_new(row, "condition", text(condition[k], FEW));
        json_object_set_new(row, "spread", text(spread[k], FEW));
        if (missing == 0) {
            json_object_set_new(row, "standard_error", text(error_of[k], DIGITS));
            json_object_set_new(row, "standard_error_condition", text(error_condition[k], FEW));
        }
    }
    if (invariants() == 0)
        return a;
    json_object_set_new(a, "invariants", list = json_array());
    for (int j = 1; j <= invariants(); j++) {
        num I = quo(mul(curve[j], curve[j]), mul(curve[j - 1], curve[j + 1])), moves = real(0);
        int v[MOST], f = n + j - 1;
        invariant_form(j, v);
        for (int k = 0; k < n; k++)
            increase(moves, mul(real(abs(v[k])), condition[k]));
        json_array_append_new(list, row = json_object());
        json_object_set_new(row, "value", text(I, DIGITS));
        json_object_set_new(row, "condition", text(mul(I, moves), FEW));
        if (missing > 0)
            continue;
        json_object_set_new(row, "standard_error", text(mul(I, error_of[f]), DIGITS));
        json_object_set_new(row, "standard_error_condition",
                            text(mul(I, add(error_condition[f], mul(error_of[f], moves))), FEW));
    }
    return a;
}

static void certify(const char *path)
{
    json_error_t error;
    json_t *file = json_load_file(path, 0, &error);
    if (file == NULL)
        stop("%s: %s", path, error.text);
    const char *data = json_string_value(json_object_get(file, "data")), *slash = strrchr(path, '/');
    char beside[4096];
    snprintf(beside, sizeof beside, "%.*s%s", slash != NULL ? (int)(slash - path) + 1 : 0, path, data);
    read_points(beside);
    read_problem(file);
    num *curve = numbers((size_t)(count * (dim + 1)));
    curve_of(value, curve);
    find_feet(curve);
    int iterations = minimise();
    statistics();
    check_bounds();
    json_object_set_new(file, "certified", answer(iterations));
    if (json_dump_file(file, path, JSON_INDENT(1)) != 0)
        stop("%s: cannot be written", path);
    json_decref(file);
}

int main(int argc, char **argv)
{
    if (argc != 2) {
        fprintf(stderr, "usage: certify PROBLEM.json\n");
        return 2;
    }
    pool = numbers(POOL);
    certify(argv[1]);
    return 0;
}
