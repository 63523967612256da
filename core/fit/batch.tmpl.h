/* batch.tmpl.h -- FIT_BATCH points, LANES at a time in vectors of the compiler's, compiled once for every width: NAME
 * completes the names, TARGET names the processor that has such vectors.  All widths compute the same numbers, since
 * products and sums are rounded one by one. */
#define lanes NAME(lanes)
#define mask  NAME(mask)
typedef double lanes __attribute__((vector_size(LANES * sizeof(double))));
typedef long long mask
    __attribute__((vector_size(LANES * sizeof(double)))); /* of each lane all bits are set, or none */

INLINE void NAME(get)(lanes *x, const double from[]) { memcpy(x, from, sizeof *x); }
INLINE void NAME(put)(double to[], const lanes *x) { memcpy(to, x, sizeof *x); }

/* Where a <= b. */
INLINE mask NAME(at_most)(const lanes *a, const lanes *b)
{
#if LANES > 4 /* gcc takes such vectors apart to compare them, but makes one of this loop */
    double x[LANES], y[LANES];
    long long z[LANES];
    mask m;
    NAME(put)(x, a), NAME(put)(y, b);
    for (int l = 0; l < LANES; l++)
        z[l] = x[l] <= y[l] ? -1 : 0;
    memcpy(&m, z, sizeof m);
    return m;
#else
    return (mask)(*a <= *b);
#endif
}

/* a where the mask is set, b elsewhere. */
INLINE lanes NAME(choose)(const mask *where, const lanes *a, const lanes *b)
{
    return (lanes)(((mask)*a & *where) | ((mask)*b & ~*where));
}

INLINE int NAME(any)(const mask *m)
{
    long long bits[LANES], any = 0;
    memcpy(bits, m, sizeof bits);
    for (int l = 0; l < LANES; l++)
        any |= bits[l];
    return any != 0;
}

/* The homogeneous curve H of degree 2 or 3 at all t: D = C, C', C'', two coordinates each; as in foot.tmpl.h. */
INLINE void NAME(derivatives)(const fit_curve *curve, const int p, const lanes *t, lanes D[6])
{
    const double *H = curve->bezier, inverse = curve->inverse[0];
    const double first = p * inverse, second = (p - 1) * inverse * first;
    const lanes s = (*t - curve->spline.knots[p]) * inverse, r = (curve->spline.knots[p + 1] - *t) * inverse;
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

/* Newton's steps for all feet together; as in foot.tmpl.h, but a step that fails there gives up here. */
INLINE int NAME(feet)(const fit_curve *curve, const int p, double limit, const lanes Q[2], lanes *t, lanes D[6])
{
    const lanes none = {0}, one = none + 1, start = none + curve->spline.knots[p],
                end = none + curve->spline.knots[p + 1];
    const double length = curve->spline.knots[p + 1] - curve->spline.knots[p];
    lanes size = one;
    for (int c = 0; c < 2; c++) {
        const lanes minus = -Q[c];
        mask larger = NAME(at_most)(&size, &Q[c]);
        size = NAME(choose)(&larger, &Q[c], &size);
        larger = NAME(at_most)(&size, &minus);
        size = NAME(choose)(&larger, &minus, &size);
    }
    const lanes error = (2 * p + 2) * DBL_EPSILON * size;
    mask found = {0};
    for (int looks = 0; looks < LOOKS; looks++) {
        lanes E[6];
        NAME(derivatives)(curve, p, t, E);
        const lanes x = E[0] - Q[0], y = E[1] - Q[1], f = x * E[2] + y * E[3], square = E[2] * E[2] + E[3] * E[3];
        const lanes slope = square + (x * E[4] + y * E[5]), step = -f / slope, next = *t + step,
                    moved = step * step * square;
        const lanes along = moved * square, across = moved * (E[4] * E[4] + E[5] * E[5]), missing = f * f;
        const lanes allowed_missing = error * error * square;
        mask where = NAME(at_most)(&slope, &square);
        const lanes part = NAME(choose)(&where, &slope, &square), allowed = limit * limit * part * part;
        const lanes allowed_along = allowed * length * length;
        const mask exact = NAME(at_most)(&missing, &allowed_missing);
        const mask near = NAME(at_most)(&along, &allowed_along) & NAME(at_most)(&across, &allowed);
        /* slope > 0 and square > 0, and start < next < end; nothing of this where there are no numbers */
        const mask regular = ~NAME(at_most)(&part, &none) & NAME(at_most)(&part, &part);
        const mask inside = ~(NAME(at_most)(&next, &start) | NAME(at_most)(&end, &next)) & NAME(at_most)(&next, &next);
        const mask lost = ~found & ~(regular & (exact | inside)), last = ~found & (exact | near), stay = exact | found;
        if (NAME(any)(&lost))
            return 0;
        const lanes h = NAME(choose)(&stay, &none, &step);
        for (int j = 0; j < 2; j++) {
            const lanes C = E[j] + h * (E[2 + j] + h / 2 * E[4 + j]), C1 = E[2 + j] + h * E[4 + j];
            D[j] = looks > 0 ? NAME(choose)(&last, &C, &D[j]) : C; /* where it is not the last, others follow */
            D[2 + j] = looks > 0 ? NAME(choose)(&last, &C1, &D[2 + j]) : C1;
            D[4 + j] = looks > 0 ? NAME(choose)(&last, &E[4 + j], &D[4 + j]) : E[4 + j];
        }
        *t += h;
        found |= last;
        where = ~found;
        if (!NAME(any)(&where))
            return 1;
    }
    return 0;
}

/* N_m/(sum N w) and, for Newton's steps, its derivative; as in fit_curve_shares. */
INLINE void NAME(shares)(const fit_curve *curve, const int p, const int newton, const lanes *t, lanes N[4], lanes N1[4])
{
    const double inverse = curve->inverse[0], factor = p * inverse, *w = curve->weights;
    const lanes s = (*t - curve->spline.knots[p]) * inverse, r = (curve->spline.knots[p + 1] - *t) * inverse;
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
        if (newton)
            N1[m] = N1[m] * total - N[m] * slope;
    }
}

/* The normal n, the distance along it in units of the errors, and the loss, its square. */
INLINE void NAME(distance)(const fit_problem *problem, int i, const lanes Q[2], const lanes D[6], lanes n[2],
                           lanes *left, double loss[])
{
    lanes precision, length;
    NAME(get)(&precision, problem->precision + i);
    const lanes r[2] = {D[0] - Q[0], D[1] - Q[1]}, speed = D[2] * D[2] + D[3] * D[3];
    for (int l = 0; l < LANES; l++)
        length[l] = sqrt(speed[l]);
    n[0] = -D[3] / length, n[1] = D[2] / length;
    *left = -(n[0] * r[0] + n[1] * r[1]) * precision;
    const lanes square = *left * *left;
    NAME(put)(loss, &square);
}

/* As point_rows and, for Newton's steps, point_curvature in objective.c, for the points i, ..., i + LANES - 1; row, x and
 * y: where they are written.  p and newton are constants for the compiler. */
INLINE void NAME(rows)(const fit_objective *o, const int p, const int newton, int i, const lanes Q[2], const lanes *t,
                       const lanes D[6], double *row, int stride, double *x, double *y, int pairs_stride, double loss[])
{
    const fit_problem *problem = o->problem;
    lanes precision, n[2], left, N[4], N1[4];
    NAME(get)(&precision, problem->precision + i);
    NAME(distance)(problem, i, Q, D, n, &left, loss);
    NAME(shares)(o->curve, p, newton, t, N, N1);
    const lanes r[2] = {D[0] - Q[0], D[1] - Q[1]}, speed = D[2] * D[2] + D[3] * D[3];
    const lanes bend = r[0] * D[4] + r[1] * D[5], slide = r[0] * D[2] + r[1] * D[3];
    lanes scale = {0}, kappa = {0}, f = {0};
    if (newton) {
        scale = -precision * precision, kappa = bend / speed;
        f = scale / (speed + bend); /* speed + bend is positive, or there would be no foot */
    }
    const cagd_fit_unknown *local = problem->local, *end = local + problem->support.first[1];
    for (const cagd_fit_unknown *u = local; u < end; u++, row += stride) {
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
        NAME(put)(row, &entry);
        if (!newton)
            continue;
        const lanes tau = M * along, rho = M1 * off - fixed * slide, hold = M * off;
        const lanes x0 = f * rho, x1 = f * tau, x2 = scale * hold, x3 = scale * fixed;
        const lanes y0 = rho + tau, y1 = rho - kappa * tau;
        NAME(put)(x, &x0), NAME(put)(x + FIT_BATCH, &x1);
        NAME(put)(x + 2 * FIT_BATCH, &x2), NAME(put)(x + 3 * FIT_BATCH, &x3);
        NAME(put)(y, &y0), NAME(put)(y + FIT_BATCH, &y1);
        NAME(put)(y + 2 * FIT_BATCH, &fixed), NAME(put)(y + 3 * FIT_BATCH, &hold);
        x += pairs_stride, y += pairs_stride;
    }
    NAME(put)(row, &left);
}

/* The feet of FIT_BATCH points, sought from feet[]; returns 0 where one is not found. */
INLINE int NAME(find)(const fit_problem *problem, const fit_curve *curve, const int p, double limit, int i,
                      const double feet[], lanes Q[][2], lanes t[], lanes D[][6])
{
    for (int g = 0; g < FIT_BATCH / LANES; g++) {
        const double *q = problem->Q + 2 * (i + g * LANES);
        for (int l = 0; l < LANES; l++)
            for (int c = 0; c < 2; c++)
                Q[g][c][l] = q[2 * l + c];
        NAME(get)(&t[g], feet + g * LANES);
        if (!NAME(feet)(curve, p, limit, Q[g], &t[g], D[g]))
            return 0;
    }
    return 1;
}

INLINE int NAME(batch)(fit_objective *o, const int p, const int rows, const int newton, int i, double loss[])
{
    enum { GROUPS = FIT_BATCH / LANES };
    lanes Q[GROUPS][2], t[GROUPS], D[GROUPS][6], n[2], left;
    if (!NAME(find)(o->problem, o->curve, p, o->limit, i, o->feet + i, Q, t, D))
        return 0;
    for (int g = 0; g < GROUPS; g++) {
        NAME(put)(o->new_feet + i + g * LANES, &t[g]);
        if (!rows)
            NAME(distance)(o->problem, i + g * LANES, Q[g], D[g], n, &left, loss + g * LANES);
    }
    if (!rows)
        return 1;
    int stride, pairs_stride = 0;
    double *row = fit_reduction_rows(o->rows, 0, FIT_BATCH, &stride), *x = NULL, *y = NULL;
    if (newton) {
        x = fit_curvature_pairs(o->second, 0, 4 * FIT_BATCH, &pairs_stride);
        y = x + o->problem->support.first[1] * pairs_stride;
    }
    for (int g = 0; g < GROUPS; g++) {
        const int at = g * LANES;
        NAME(rows)
        (o, p, newton, i + at, Q[g], &t[g], D[g], row + at, stride, newton ? x + at : NULL, newton ? y + at : NULL,
         pairs_stride, loss + at);
    }
    return 1;
}

TARGET static int NAME(points)(fit_objective *o, int i, fit_extent extent, double loss[])
{
    const int newton = extent == FIT_ROWS && o->newton;
    if (extent == FIT_COST)
        return o->problem->degree == 2 ? NAME(batch)(o, 2, 0, 0, i, loss) : NAME(batch)(o, 3, 0, 0, i, loss);
    return o->problem->degree == 2 ? newton ? NAME(batch)(o, 2, 1, 1, i, loss) : NAME(batch)(o, 2, 1, 0, i, loss)
           : newton ? NAME(batch)(o, 3, 1, 1, i, loss)
                                   : NAME(batch)(o, 3, 1, 0, i, loss);
}

/* See fit_batch_feet. */
INLINE int NAME(feet_only)(const fit_problem *problem, const fit_curve *curve, const int p, int i, double feet[],
                           double derivatives[][6])
{
    enum { GROUPS = FIT_BATCH / LANES };
    lanes Q[GROUPS][2], t[GROUPS], D[GROUPS][6];
    if (!NAME(find)(problem, curve, p, FOOT_EXACT, i, feet, Q, t, D))
        return 0;
    for (int g = 0; g < GROUPS; g++) {
        NAME(put)(feet + g * LANES, &t[g]);
        for (int l = 0; l < LANES; l++)
            for (int j = 0; j < 6; j++)
                derivatives[g * LANES + l][j] = D[g][j][l];
    }
    return 1;
}

TARGET static int NAME(only_feet)(const fit_problem *problem, const fit_curve *curve, int i, double feet[],
                                  double derivatives[][6])
{
    return problem->degree == 2 ? NAME(feet_only)(problem, curve, 2, i, feet, derivatives)
                                : NAME(feet_only)(problem, curve, 3, i, feet, derivatives);
}
#undef lanes
#undef mask
