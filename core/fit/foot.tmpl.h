/* foot.tmpl.h -- derivatives and feet, compiled once for every shape of curve: DIM and DEGREE are constants, or are
 * read from `curve`; NAME completes the names.  With constants the loops are unrolled, which makes them several times
 * faster. */

/* De Casteljau's triangle at s, broken off where the last three, two and one points give the derivatives:
 *     A'' = p (p-1) (b_2 - 2 b_1 + b_0),   A' = p (l_1 - l_0),   A = (1-s) l_0 + s l_1,   l_i = (1-s) b_i + s b_{i+1},
 * and C = A/w, C' = (A' - w' C)/w, C'' = (A'' - 2 w' C' - w'' C)/w; of order 0 only C, of order 2 all of them. */
INLINE void NAME(casteljau)(const fit_curve *curve, const int order, double t, double D[])
{
    const int dim = DIM, p = DEGREE, h = dim + 1, k = curve->pieces == 1 ? 0 : fit_curve_piece(curve, t),
              mu = curve->span[k];
    const double inverse = curve->inverse[k], s = (t - curve->spline.knots[mu]) * inverse,
                 r = (curve->spline.knots[mu + 1] - t) * inverse;
    const double first = p * inverse, second = (p - 1) * inverse * first;
    const double *H = curve->bezier + k * (p + 1) * h;
    double b[(MAX_DEGREE + 1) * MAX_DIM], A[MAX_DIM], A1[MAX_DIM], A2[MAX_DIM];
    if (p > 2) { /* the first level reads what the others change */
        for (int m = 0; m < p * h; m++)
            b[m] = r * H[m] + s * H[m + h];
        for (int n = p - 1; n > 2; n--)
            for (int m = 0; m < n * h; m++)
                b[m] = r * b[m] + s * b[m + h];
        H = b;
    }
    for (int j = 0; j < h; j++) {
        double l0 = r * H[j] + s * H[h + j];
        if (p == 1) {
            A[j] = l0;
            A1[j] = first * (H[h + j] - H[j]);
            A2[j] = 0;
            continue;
        }
        double l1 = r * H[h + j] + s * H[2 * h + j];
        A[j] = r * l0 + s * l1;
        A1[j] = first * (l1 - l0);
        A2[j] = second * (H[2 * h + j] - 2 * H[h + j] + H[j]);
    }
    double w = 1 / A[dim], w1 = A1[dim], w2 = A2[dim];
    for (int j = 0; j < dim; j++) {
        double C = A[j] * w, C1 = (A1[j] - w1 * C) * w;
        D[j] = C;
        if (order == 0)
            continue;
        D[dim + j] = C1;
        D[2 * dim + j] = (A2[j] - 2 * w1 * C1 - w2 * C) * w;
    }
}

static void NAME(derivatives)(const fit_curve *curve, double t, double D[]) { NAME(casteljau)(curve, 2, t, D); }
static void NAME(point)(const fit_curve *curve, double t, double P[]) { NAME(casteljau)(curve, 0, t, P); }

/* Newton's method for f(t) = (C - Q) C' = 0 between low and high, f(low) < 0 < f(high) as far as f is known there;
 * nothing is known at the ends of the domain before they are tried.  A step that leaves this interval, or where f' =
 * C' C' + (C - Q) C'' is not positive, is replaced by the foot on the tangent, f' = C' C'; when this too leaves it,
 * an end of the domain that was not tried is, or the middle.
 *
 * A step that is shorter than `limit` times the length on which the curve changes, |C'|/|C''| or the domain, is the
 * last: the curve there is Taylor's polynomial, and Newton's method squares the error.  With FOOT_EXACT as limit this
 * polynomial is the curve, up to rounding. */
static fit_foot_kind NAME(newton)(const fit_curve *curve, const double q[], double limit, double *t, double D[])
{
    const int dim = DIM, degree = DEGREE;
    int low_known = 0, high_known = 0;
    const double start = fit_curve_start(curve), end = fit_curve_end(curve);
    double low = start, high = end, x = *t;
    const double *D1 = D + dim, *D2 = D + 2 * dim;
    double size = 1; /* of the curve, in working coordinates, and of q */
    for (int c = 0; c < dim; c++)
        size = fabs(q[c]) > size ? fabs(q[c]) : size;
    const double error = (2 * degree + 2) * DBL_EPSILON * size; /* what rounding makes of C - Q */
    for (int looks = 1;; looks++) {
        double off[3];
        NAME(derivatives)(curve, x, D);
        for (int c = 0; c < dim; c++)
            off[c] = D[c] - q[c];
        double f = inner(dim, off, D1), square = inner(dim, D1, D1), slope = square + inner(dim, off, D2);
        *t = x;
        if (!isfinite(slope + f)) /* the curve has overflowed; so will the cost */
            return FOOT_AT_CORNER;
        if (f * f <= error * error * square)
            return square > 0 ? FOOT_ORTHOGONAL : FOOT_AT_CORNER;
        if (f < 0)
            low = x, low_known = 1;
        else
            high = x, high_known = 1;
        if (low == high) /* what is beyond the end, f/|C'|, may be too short to change the squared distance */
            return f * f <= DBL_EPSILON / 2 * square * inner(dim, off, off) ? FOOT_ORTHOGONAL : FOOT_AT_END;
        double middle = low + (high - low) / 2;
        if (low_known && high_known && !(low < middle && middle < high)) /* two neighbours among the numbers */
            return slope > 0 && fabs(f) <= error * sqrt(square) + slope * (high - low) ? FOOT_ORTHOGONAL
                                                                                       : FOOT_AT_CORNER;
        double next = slope > 0 ? x - f / slope : low;
        if (slope > 0 && next == x) /* there is no number between x and the foot */
            return FOOT_ORTHOGONAL;
        int newton = low < next && next < high;
        if (!newton)
            next = x - f / square;
        if (!(low < next && next < high) || (looks > 16 && looks % 2 == 0 && low_known && high_known)) {
            next = f < 0 && !high_known ? end : f > 0 && !low_known ? start : middle;
            newton = 0;
        }
        double step = next - x, bend = inner(dim, D2, D2), length = end - start;
        double part = slope < square ? slope : square; /* Newton's method is slower where slope is small */
        if (newton && step * step * square * square <= limit * limit * length * length * part * part &&
            step * step * bend * square <= limit * limit * part * part &&
            (curve->pieces == 1 || fit_curve_piece(curve, x) == fit_curve_piece(curve, next))) {
            *t = next;
            for (int c = 0; c < dim; c++) {
                D[c] += step * (D[dim + c] + step / 2 * D[2 * dim + c]);
                D[dim + c] += step * D[2 * dim + c];
            }
            return FOOT_ORTHOGONAL;
        }
        x = next;
    }
}
