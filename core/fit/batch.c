#include "core/fit/batch.h"

#include <float.h>
#include <math.h>
#include <stddef.h>

enum { LANES = FIT_BATCH, LOOKS = 5 };

typedef double lanes[LANES];

/* The homogeneous curve H of degree 2 or 3 at all t: D = C, C', C'', two coordinates each; as in foot.tmpl.h. */
static inline void derivatives(const fit_curve *curve, const int p, const lanes t, lanes D[6])
{
    const double *H = curve->bezier;
    const double start = curve->knots[p], end = curve->knots[p + 1], inverse = curve->inverse[0];
    const double first = p * inverse, second = (p - 1) * inverse * first;
    lanes A[3], A1[3], A2[3];
    for (int j = 0; j < 3; j++)
        for (int l = 0; l < LANES; l++) {
            double s = (t[l] - start) * inverse, r = (end - t[l]) * inverse, b[3];
            for (int m = 0; m < 3; m++)
                b[m] = p == 2 ? H[3 * m + j] : r * H[3 * m + j] + s * H[3 * m + 3 + j];
            double l0 = r * b[0] + s * b[1], l1 = r * b[1] + s * b[2];
            A[j][l] = r * l0 + s * l1;
            A1[j][l] = first * (l1 - l0);
            A2[j][l] = second * (b[2] - 2 * b[1] + b[0]);
        }
    for (int l = 0; l < LANES; l++)
        A[2][l] = 1 / A[2][l];
    for (int j = 0; j < 2; j++)
        for (int l = 0; l < LANES; l++) {
            double w = A[2][l], C = A[j][l] * w, C1 = (A1[j][l] - A1[2][l] * C) * w;
            D[j][l] = C;
            D[2 + j][l] = C1;
            D[4 + j][l] = (A2[j][l] - 2 * A1[2][l] * C1 - A2[2][l] * C) * w;
        }
}

/* Newton's steps for all feet together; as in foot.tmpl.h, but a step that fails there gives up here. */
static inline int feet(const fit_curve *curve, const int p, double limit, lanes Q[2], lanes t, lanes D[6])
{
    const double start = curve->knots[p], end = curve->knots[p + 1], length = end - start;
    int found[LANES] = {0}, left = LANES;
    lanes blur;
    for (int l = 0; l < LANES; l++)
        blur[l] = (2 * p + 2) * DBL_EPSILON * fmax(1, fmax(fabs(Q[0][l]), fabs(Q[1][l])));
    for (int looks = 0; left > 0 && looks < LOOKS; looks++) {
        lanes E[6], slope, step, square, along, across, exact;
        derivatives(curve, p, t, E);
        for (int l = 0; l < LANES; l++) {
            double x = E[0][l] - Q[0][l], y = E[1][l] - Q[1][l], f = x * E[2][l] + y * E[3][l];
            square[l] = E[2][l] * E[2][l] + E[3][l] * E[3][l];
            slope[l] = square[l] + (x * E[4][l] + y * E[5][l]);
            step[l] = -f / slope[l];
            along[l] = step[l] * step[l] * square[l] * square[l];
            across[l] = step[l] * step[l] * square[l] * (E[4][l] * E[4][l] + E[5][l] * E[5][l]);
            exact[l] = f * f - blur[l] * blur[l] * square[l];
        }
        for (int l = 0; l < LANES; l++) {
            if (found[l])
                continue;
            double next = t[l] + step[l], part = slope[l] < square[l] ? slope[l] : square[l];
            double allowed = limit * limit * part * part;
            int inside = start < next && next < end;
            if (!(slope[l] > 0 && square[l] > 0) || (!(exact[l] <= 0) && !inside))
                return 0;
            if (!(exact[l] <= 0) && !(along[l] <= allowed * length * length && across[l] <= allowed)) {
                t[l] = next;
                continue;
            }
            double h = exact[l] <= 0 ? 0 : step[l];
            for (int j = 0; j < 2; j++) {
                D[j][l] = E[j][l] + h * (E[2 + j][l] + h / 2 * E[4 + j][l]);
                D[2 + j][l] = E[2 + j][l] + h * E[4 + j][l];
                D[4 + j][l] = E[4 + j][l];
            }
            t[l] += h;
            found[l] = 1;
            left--;
        }
    }
    return left == 0;
}

/* N_m/(sum N w) and its derivative; as in fit_curve_shares. */
static inline void shares(const fit_curve *curve, const int p, const lanes t, lanes N[4], lanes N1[4])
{
    const double start = curve->knots[p], end = curve->knots[p + 1], inverse = curve->inverse[0], factor = p * inverse;
    const double *w = curve->weights;
    lanes b[3], total = {0}, slope = {0};
    for (int l = 0; l < LANES; l++) {
        double s = (t[l] - start) * inverse, r = (end - t[l]) * inverse;
        b[0][l] = p == 2 ? r : r * r;
        b[1][l] = p == 2 ? s : 2 * s * r;
        b[2][l] = s * s;
    }
    for (int m = 0; m <= p; m++)
        for (int l = 0; l < LANES; l++) {
            double s = (t[l] - start) * inverse, r = (end - t[l]) * inverse;
            double before = m > 0 ? b[m - 1][l] : 0, here = m < p ? b[m][l] : 0;
            N[m][l] = r * here + s * before;
            N1[m][l] = factor * (before - here);
            total[l] += N[m][l] * w[m];
            slope[l] += N1[m][l] * w[m];
        }
    for (int m = 0; m <= p; m++)
        for (int l = 0; l < LANES; l++) {
            N[m][l] /= total[l];
            N1[m][l] = (N1[m][l] - N[m][l] * slope[l]) / total[l];
        }
}

/* As point_rows and point_curvature in objective.c. */
static inline void rows(fit_objective *o, const int p, int i, lanes Q[2], const lanes t, lanes D[6], int newton,
                        double loss[])
{
    const fit_problem *problem = o->problem;
    const double *precision = problem->precision + i;
    lanes N[4], N1[4], n[2], left, r[2], f, kappa, slide, scale;
    shares(o->curve, p, t, N, N1);
    for (int l = 0; l < LANES; l++) {
        double speed = D[2][l] * D[2][l] + D[3][l] * D[3][l], length = 1 / sqrt(speed);
        n[0][l] = -D[3][l] * length;
        n[1][l] = D[2][l] * length;
        r[0][l] = D[0][l] - Q[0][l];
        r[1][l] = D[1][l] - Q[1][l];
        left[l] = -(n[0][l] * r[0][l] + n[1][l] * r[1][l]) * precision[l];
        loss[l] = left[l] * left[l];
        double bend = r[0][l] * D[4][l] + r[1][l] * D[5][l];
        slide[l] = r[0][l] * D[2][l] + r[1][l] * D[3][l];
        scale[l] = -precision[l] * precision[l];
        f[l] = scale[l] / (speed + bend); /* positive, or there would be no foot */
        kappa[l] = bend / speed;
    }
    const cagd_fit_unknown *slot = problem->slot, *end = slot + problem->first[1];
    int stride, pairs_stride = 0;
    double *row = fit_reduction_rows(o->rows, 0, LANES, &stride), *x = NULL, *y = NULL;
    if (newton) {
        x = fit_curvature_pairs(o->second, 0, 4 * LANES, &pairs_stride);
        y = x + problem->first[1] * pairs_stride;
    }
    for (const cagd_fit_unknown *u = slot; u < end; u++, row += stride) {
        const double *M = N[u->index], *M1 = N1[u->index], *B = o->base->points + 2 * u->index;
        lanes along, off, across;
        for (int l = 0; l < LANES; l++) {
            double v0 = u->is_weight ? B[0] - D[0][l] : u->coordinate == 0,
                   v1 = u->is_weight ? B[1] - D[1][l] : u->coordinate == 1;
            across[l] = n[0][l] * v0 + n[1][l] * v1;
            along[l] = D[2][l] * v0 + D[3][l] * v1;
            off[l] = r[0][l] * v0 + r[1][l] * v1;
            row[l] = -precision[l] * M[l] * across[l];
        }
        if (!newton)
            continue;
        for (int l = 0; l < LANES; l++) {
            double fixed = u->is_weight ? M[l] : 0, tau = M[l] * along[l], rho = M1[l] * off[l] - fixed * slide[l],
                   hold = M[l] * off[l];
            x[l] = f[l] * rho, y[l] = rho + tau;
            x[LANES + l] = f[l] * tau, y[LANES + l] = rho - kappa[l] * tau;
            x[2 * LANES + l] = scale[l] * hold, y[2 * LANES + l] = fixed;
            x[3 * LANES + l] = scale[l] * fixed, y[3 * LANES + l] = hold;
        }
        x += pairs_stride, y += pairs_stride;
    }
    for (int l = 0; l < LANES; l++)
        row[l] = left[l];
}

static inline int batch(fit_objective *o, const int p, int i, int newton, double loss[])
{
    lanes Q[2], t, D[6];
    for (int l = 0; l < LANES; l++) {
        t[l] = o->feet[i + l];
        for (int c = 0; c < 2; c++)
            Q[c][l] = o->problem->Q[2 * (i + l) + c];
    }
    if (!feet(o->curve, p, o->limit, Q, t, D))
        return 0;
    for (int l = 0; l < LANES; l++)
        o->new_feet[i + l] = t[l];
    rows(o, p, i, Q, t, D, newton, loss);
    return 1;
}

int fit_batch(fit_objective *o, int i, int weighted, double loss[])
{
    const fit_problem *p = o->problem;
    if (p->dim != 2 || p->count != p->degree + 1 || p->loss != CAGD_FIT_SQUARES || i + LANES > p->points)
        return 0;
    int newton = weighted && o->newton;
    return p->degree == 2 ? batch(o, 2, i, newton, loss) : p->degree == 3 ? batch(o, 3, i, newton, loss) : 0;
}
