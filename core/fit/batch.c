#include "core/fit/batch.h"

#include <float.h>
#include <math.h>

enum { LOOKS = 5 };

/* The homogeneous curve H of degree 2 or 3 at all t: D = C, C', C'', two coordinates each; as in foot.tmpl.h. */
INLINE void derivatives(const fit_curve *curve, const int p, const lanes *t, lanes D[6])
{
    const double *H = curve->bezier, inverse = curve->inverse[0];
    const double first = p * inverse, second = (p - 1) * inverse * first;
    const lanes s = (*t - curve->knots[p]) * inverse, r = (curve->knots[p + 1] - *t) * inverse;
    lanes A[3], A1[3], A2[3];
    for (int j = 0; j < 3; j++) {
        lanes b[3];
        for (int m = 0; m < 3; m++)
            b[m] = p == 2 ? (lanes){0} + H[3 * m + j] : r * H[3 * m + j] + s * H[3 * m + 3 + j];
        const lanes l0 = r * b[0] + s * b[1], l1 = r * b[1] + s * b[2];
        A[j] = r * l0 + s * l1;
        A1[j] = first * (l1 - l0);
        A2[j] = second * (b[2] - 2 * b[1] + b[0]);
    }
    const lanes w = 1 / A[2];
    for (int j = 0; j < 2; j++) {
        D[j] = A[j] * w;
        D[2 + j] = (A1[j] - A1[2] * D[j]) * w;
        D[4 + j] = (A2[j] - 2 * A1[2] * D[2 + j] - A2[2] * D[j]) * w;
    }
}

/* Newton's steps for all feet together; as in foot.tmpl.h, but a step that fails there gives up here.  What is compared lies in arrays,
 * since compilers make better vectors of such loops than of compared vectors. */
INLINE int feet(const fit_curve *curve, const int p, double limit, const lanes Q[2], lanes *t, lanes D[6])
{
    const double start = curve->knots[p], end = curve->knots[p + 1], length = end - start;
    double square[LANES], slope[LANES], next[LANES], along[LANES], across[LANES], left[LANES], blur[LANES], step[LANES];
    long long found[LANES] = {0}, last[LANES];
    lanes_put(along, &Q[0]), lanes_put(across, &Q[1]);
    for (int l = 0; l < LANES; l++) {
        double x = fabs(along[l]), y = fabs(across[l]), size = x > y ? x : y;
        blur[l] = (2 * p + 2) * DBL_EPSILON * (size > 1 ? size : 1);
    }
    for (int j = 0; j < 6; j++)
        D[j] = (lanes){0};
    for (int looks = 0; looks < LOOKS; looks++) {
        lanes E[6], h;
        derivatives(curve, p, t, E);
        const lanes x = E[0] - Q[0], y = E[1] - Q[1], f = x * E[2] + y * E[3];
        const lanes speed = E[2] * E[2] + E[3] * E[3], bend = E[4] * E[4] + E[5] * E[5];
        const lanes fall = speed + (x * E[4] + y * E[5]), way = -f / fall, moved = way * way * speed;
        const lanes to = *t + way, first = moved * speed, second = moved * bend, missing = f * f;
        lanes_put(square, &speed), lanes_put(slope, &fall), lanes_put(step, &way), lanes_put(next, &to);
        lanes_put(along, &first), lanes_put(across, &second), lanes_put(left, &missing);
        long long lost = 0, open = 0;
        for (int l = 0; l < LANES; l++) {
            const double part = slope[l] < square[l] ? slope[l] : square[l], allowed = limit * limit * part * part;
            const long long exact = left[l] <= blur[l] * blur[l] * square[l],
                            inside = (start < next[l]) & (next[l] < end);
            const long long regular = (slope[l] > 0) & (square[l] > 0);
            const long long near = (along[l] <= allowed * length * length) & (across[l] <= allowed);
            lost |= (1 - found[l]) & (1 - (regular & (exact | inside)));
            last[l] = (1 - found[l]) & (exact | near);
            step[l] = exact | found[l] ? 0 : step[l];
            found[l] |= exact | near;
            open |= 1 - found[l];
        }
        if (lost)
            return 0;
        mask ends;
        for (int l = 0; l < LANES; l++)
            ends[l] = -last[l];
        lanes_get(&h, step);
        for (int j = 0; j < 2; j++) {
            const lanes C = E[j] + h * (E[2 + j] + h / 2 * E[4 + j]), C1 = E[2 + j] + h * E[4 + j];
            lanes_choose(&D[j], &ends, &C, &D[j]);
            lanes_choose(&D[2 + j], &ends, &C1, &D[2 + j]);
            lanes_choose(&D[4 + j], &ends, &E[4 + j], &D[4 + j]);
        }
        *t += h;
        if (!open)
            return 1;
    }
    return 0;
}

/* N_m/(sum N w) and its derivative; as in fit_curve_shares. */
INLINE void shares(const fit_curve *curve, const int p, const lanes *t, lanes N[4], lanes N1[4])
{
    const double inverse = curve->inverse[0], factor = p * inverse, *w = curve->weights;
    const lanes s = (*t - curve->knots[p]) * inverse, r = (curve->knots[p + 1] - *t) * inverse;
    const lanes b[3] = {p == 2 ? r : r * r, p == 2 ? s : 2 * s * r, s * s};
    lanes total = {0}, slope = {0};
    for (int m = 0; m <= p; m++) {
        const lanes before = m > 0 ? b[m - 1] : (lanes){0}, here = m < p ? b[m] : (lanes){0};
        N[m] = r * here + s * before;
        N1[m] = factor * (before - here);
        total += N[m] * w[m];
        slope += N1[m] * w[m];
    }
    total = 1 / total;
    slope *= total;
    for (int m = 0; m <= p; m++) {
        N[m] *= total;
        N1[m] = N1[m] * total - N[m] * slope;
    }
}

/* As point_rows and point_curvature in objective.c. */
INLINE void rows(fit_objective *o, const int p, int i, const lanes Q[2], const lanes *t, const lanes D[6], int newton,
                 double loss[])
{
    const fit_problem *problem = o->problem;
    lanes precision, N[4], N1[4];
    lanes_get(&precision, problem->precision + i);
    shares(o->curve, p, t, N, N1);
    const lanes r[2] = {D[0] - Q[0], D[1] - Q[1]}, speed = D[2] * D[2] + D[3] * D[3];
    lanes length = speed;
    lanes_root(&length);
    const lanes n[2] = {-D[3] / length, D[2] / length};
    const lanes left = -(n[0] * r[0] + n[1] * r[1]) * precision, square = left * left;
    const lanes bend = r[0] * D[4] + r[1] * D[5], slide = r[0] * D[2] + r[1] * D[3];
    const lanes scale = -precision * precision, kappa = bend / speed;
    const lanes f = scale / (speed + bend); /* positive, or there would be no foot */
    lanes_put(loss, &square);
    const cagd_fit_unknown *slot = problem->slot, *end = slot + problem->first[1];
    int stride, pairs_stride = 0;
    double *row = fit_reduction_rows(o->rows, 0, LANES, &stride), *x = NULL, *y = NULL;
    if (newton) {
        x = fit_curvature_pairs(o->second, 0, 4 * LANES, &pairs_stride);
        y = x + problem->first[1] * pairs_stride;
    }
    for (const cagd_fit_unknown *u = slot; u < end; u++, row += stride) {
        const lanes M = N[u->index], M1 = N1[u->index];
        const double *B = o->base->points + 2 * u->index;
        lanes across = n[u->coordinate], along = D[2 + u->coordinate], off = r[u->coordinate], fixed = {0};
        if (u->is_weight) {
            const lanes v0 = B[0] - D[0], v1 = B[1] - D[1];
            across = n[0] * v0 + n[1] * v1;
            along = D[2] * v0 + D[3] * v1;
            off = r[0] * v0 + r[1] * v1;
            fixed = M;
        }
        const lanes entry = -precision * M * across;
        lanes_put(row, &entry);
        if (!newton)
            continue;
        const lanes tau = M * along, rho = M1 * off - fixed * slide, hold = M * off;
        const lanes pair[8] = {f * rho,   f * tau,           scale * hold, scale * fixed,
                               rho + tau, rho - kappa * tau, fixed,        hold};
        for (int k = 0; k < 4; k++) {
            lanes_put(x + k * LANES, &pair[k]);
            lanes_put(y + k * LANES, &pair[4 + k]);
        }
        x += pairs_stride, y += pairs_stride;
    }
    lanes_put(row, &left);
}

INLINE int batch(fit_objective *o, const int p, int i, int newton, double loss[])
{
    lanes Q[2], t, D[6];
    lanes_get(&t, o->feet + i);
    for (int l = 0; l < LANES; l++)
        for (int c = 0; c < 2; c++)
            Q[c][l] = o->problem->Q[2 * (i + l) + c];
    if (!feet(o->curve, p, o->limit, Q, &t, D))
        return 0;
    lanes_put(o->new_feet + i, &t);
    rows(o, p, i, Q, &t, D, newton, loss);
    return 1;
}

WIDE int fit_batch(fit_objective *o, int i, int weighted, double loss[])
{
    const fit_problem *p = o->problem;
    if (p->dim != 2 || p->count != p->degree + 1 || p->loss != CAGD_FIT_SQUARES || i + LANES > p->points)
        return 0;
    int newton = weighted && o->newton;
    return p->degree == 2 ? batch(o, 2, i, newton, loss) : p->degree == 3 ? batch(o, 3, i, newton, loss) : 0;
}
