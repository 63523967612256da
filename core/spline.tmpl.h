/* spline.tmpl.h -- one curve, and what is done with it as a whole, once for every number type that has an order.
 *
 *     s(t) = sum N_{i,p}(t) R_i,   or with weights   R(t) = sum N_{i,p}(t) w_i R_i / w(t),   w(t) = sum N_{i,p}(t) w_i.
 *
 * struct G(spline) is {degree p, count n, dim; knots, points, weights}, of the shapes of bspline.tmpl.h and nurbs.tmpl.h;
 * weights NULL: a B-spline curve.  A Bézier curve is the spline of one span over 0, ..., 0, 1, ..., 1.  What depends on an
 * order is decided here, spans and multiplicities among it; the kernels compute.  Whoever includes this text has defined
 *
 *     struct G(spline)      for binary64 the cagd_spline of cagd.h
 *     G(before)(a, b)       whether a < b, and the rules of span.tmpl.h
 *     G(is_zero)(a)         whether a = 0
 *     G(is_number)(a)       whether a is a number: in binary64, neither infinite nor NaN
 *
 * Every function but the checks takes for granted that the curve is good, and says by a cagd_status whether there is such a
 * result.  Nothing is written for a status of the arguments (OUTSIDE_DOMAIN, KNOTS_MULTIPLE, NO_KNOT, DEGREE); after
 * UNDEFINED and OVERFLOW results have no meaning, and *where is the index of the point of the result that has the weight 0.
 * Results go into arrays of the caller, which do not overlap the curve. */
#include "core/number/generic_on.h"

/* Room for a curve: knots, points, and weights where the curve has any. */
struct G(spline_room) {
    num *knots, *points, *weights;
};

/* ---- spans ---------------------------------------------------------------------------------------- */

/* *mu: the span of t, at a knot the one on the given side.  OUTSIDE_DOMAIN for t outside. */
KERNEL cagd_status G(spline_span)(const struct G(spline) * s, num t, cagd_side side, int *mu)
{
    int found = side == CAGD_LEFT ? G(find_span_left)(s->count, s->degree, s->knots, t)
                                  : G(find_span)(s->count, s->degree, s->knots, t);
    if (found < 0)
        return CAGD_OUTSIDE_DOMAIN;
    *mu = found;
    return CAGD_OK;
}

/* How often t is a knot. */
KERNEL int G(spline_multiplicity)(const struct G(spline) * s, num t)
{
    return G(multiplicity)(s->count + s->degree + 1, s->knots, t);
}

/* Whether u_p < t < u_n. */
KERNEL int G(spline_inside)(const struct G(spline) * s, num t)
{
    return G(before)(s->knots[s->degree], t) && G(before)(t, s->knots[s->count]);
}

/* H: the p+1 points that count on a span, homogeneous where there are weights, else as they are.  Returns their dimension.
 * With the knots from u_{mu-p} on they are a spline of one span, which has the number p. */
KERNEL int G(spline_points_of_span)(const struct G(spline) * s, int mu, num H[])
{
    int p = s->degree, dim = s->dim;
    if (s->weights != NULL) {
        G(nurbs_homogenize)(G(span_of_curve)(s, mu), H);
        return dim + 1;
    }
    for (int m = 0; m < (p + 1) * dim; m++)
        H[m] = s->points[(mu - p) * dim + m];
    return dim;
}

/* ---- results -------------------------------------------------------------------------------------- */

/* `count` computed points H into the room, from point `at` on: affine, with their weights, where the curve has any. */
KERNEL cagd_status G(spline_put)(const struct G(spline) * s, int at, int count, const num H[],
                                 const struct G(spline_room) * room, int *where)
{
    int dim = s->dim;
    for (int i = 0; i < count && s->weights != NULL; i++)
        if (G(is_zero)(H[i * (dim + 1) + dim])) {
            *where = at + i;
            return CAGD_UNDEFINED;
        }
    if (s->weights != NULL)
        G(rational_dehomogenize)(count - 1, dim, H, room->points + at * dim, room->weights + at);
    else
        for (int m = 0; m < count * dim; m++)
            room->points[at * dim + m] = H[m];
    return CAGD_OK;
}

/* `count` points and weights of the curve as they are, from point `from` of the curve to point `at` of the room. */
KERNEL void G(spline_copy)(const struct G(spline) * s, int from, int at, int count, const struct G(spline_room) * room)
{
    for (int m = 0; m < count * s->dim; m++)
        room->points[at * s->dim + m] = s->points[from * s->dim + m];
    for (int i = 0; i < count && s->weights != NULL; i++)
        room->weights[at + i] = s->weights[from + i];
}

/* Whether a result of `count` points is one: no weight is 0, and all are numbers. */
KERNEL cagd_status G(spline_result)(const struct G(spline) * s, int count, const struct G(spline_room) * room,
                                    int *where)
{
    for (int i = 0; i < count && s->weights != NULL; i++) {
        *where = i;
        if (G(is_zero)(room->weights[i]))
            return CAGD_UNDEFINED;
        if (!G(is_number)(room->weights[i]))
            return CAGD_OVERFLOW;
    }
    for (int m = 0; m < count * s->dim; m++) {
        *where = m / s->dim;
        if (!G(is_number)(room->points[m]))
            return CAGD_OVERFLOW;
    }
    *where = -1;
    return CAGD_OK;
}

/* ---- values --------------------------------------------------------------------------------------- */

/* Row k of out is the k-th derivative at t of the segment of mu, k = 0, ..., r, r <= MAX_DEGREE.  UNDEFINED where w(t) is 0. */
KERNEL cagd_status G(spline_derivatives)(const struct G(spline) * s, int mu, num t, int r, num out[restrict])
{
    num H[(MAX_DEGREE + 1) * MAX_DIM], D[(MAX_DEGREE + 1) * MAX_DIM];
    if (s->weights == NULL) {
        G(bspline_derivatives)(G(span_of_curve)(s, mu), t, r, out);
    } else {
        G(spline_points_of_span)(s, mu, H);
        G(bspline_derivatives)(G(span_alone)(s->degree, s->dim + 1, s->knots, mu, H), t, r, D);
        if (G(is_zero)(D[s->dim]))
            return CAGD_UNDEFINED;
        if (!G(is_number)(D[s->dim]))
            return CAGD_OVERFLOW;
        G(rational_quotient_derivatives)(s->dim, D, r, out);
    }
    for (int m = 0; m < (r + 1) * s->dim; m++)
        if (!G(is_number)(out[m]))
            return CAGD_OVERFLOW;
    return CAGD_OK;
}

/* ---- the same curve otherwise ----------------------------------------------------------------------- */

/* One knot x more, u_p <= x < u_n: n+1 points (Boehm).  OUTSIDE_DOMAIN; KNOTS_MULTIPLE when x is a knot p+1 times. */
KERNEL cagd_status G(spline_insert)(const struct G(spline) * s, num x, const struct G(spline_room) * room, int *where)
{
    int n = s->count, p = s->degree, mu = G(find_span)(n, p, s->knots, x);
    num w[MAX_DEGREE + 1];
    *where = -1;
    if (mu < 0 || !G(before)(x, s->knots[n]))
        return CAGD_OUTSIDE_DOMAIN;
    if (G(spline_multiplicity)(s, x) > p)
        return CAGD_KNOTS_MULTIPLE;
    if (s->weights == NULL) {
        G(bspline_insert)(s, mu, x, room->knots, room->points);
        return G(spline_result)(s, n + 1, room, where);
    }
    for (int m = 0; m <= p; m++)
        w[m] = s->weights[mu - p + m];
    if (p > 0)
        G(bspline_deboor_level)(G(span_alone)(p, 1, s->knots, mu, w), 1, w, x);
    for (int m = 0; m < p; m++)
        if (G(is_zero)(w[m])) {
            *where = mu - p + 1 + m;
            return CAGD_UNDEFINED;
        }
    G(nurbs_insert)(s, mu, x, room->knots, room->points, room->weights);
    return G(spline_result)(s, n + 1, room, where);
}

/* One copy of the inner knot x less: n-1 points.  NO_KNOT when x is no knot inside the domain; CHANGES when that is another
 * curve, decided exactly: in a type that rounds it says nothing. */
KERNEL cagd_status G(spline_remove)(const struct G(spline) * s, num x, const struct G(spline_room) * room, int *where)
{
    int n = s->count, p = s->degree, times = G(spline_multiplicity)(s, x);
    num H[(MAX_DEGREE + 2) * MAX_DIM], b[(MAX_DEGREE + 1) * MAX_DIM], v[2 * MAX_DEGREE + 2], defect[MAX_DIM];
    *where = -1;
    if (times == 0 || !G(spline_inside)(s, x))
        return CAGD_NO_KNOT;
    /* Points mu-p, ..., mu+1 and their knots by themselves, mu+1 being the last knot x; the rest is copied. */
    int r = G(find_span)(n, p, s->knots, x), first = r - 1 - p, dim = s->dim + (s->weights != NULL);
    if (s->weights != NULL)
        G(rational_homogenize)(p + 1, s->dim, s->points + first * s->dim, s->weights + first, H);
    else
        for (int m = 0; m < (p + 2) * dim; m++)
            H[m] = s->points[first * dim + m];
    G(bspline_remove)(spline(p, p + 2, dim, s->knots + first, H), p + 1, times, v, b, defect);
    for (int k = 0; k < dim; k++)
        if (!G(is_zero)(defect[k]))
            return CAGD_CHANGES;
    for (int i = 0; i < n + p; i++)
        room->knots[i] = s->knots[i < r ? i : i + 1];
    G(spline_copy)(s, 0, 0, first, room);
    cagd_status status = G(spline_put)(s, first, p + 1, b, room, where);
    if (status != CAGD_OK)
        return status;
    G(spline_copy)(s, r + 1, r, n - r - 1, room);
    return G(spline_result)(s, n - 1, room, where);
}

/* How many points the curve has in degree p+1. */
KERNEL int G(spline_elevated_count)(const struct G(spline) * s)
{
    return G(raised_knots)(s->count, s->degree, s->knots, NULL);
}

/* The curve in degree p+1: as many points as spline_elevated_count says.  DEGREE for p = MAX_DEGREE. */
KERNEL cagd_status G(spline_elevate)(const struct G(spline) * s, const struct G(spline_room) * room, int *where)
{
    num H[(MAX_DEGREE + 1) * MAX_DIM], P[MAX_DIM];
    int n = s->count, p = s->degree;
    *where = -1;
    if (p >= MAX_DEGREE)
        return CAGD_DEGREE;
    int count = G(raised_knots)(n, p, s->knots, room->knots);
    for (int j = 0; j < count; j++) {
        int mu = G(span_of_point)(n, p, s->knots, count, p + 1, room->knots, j),
            dim = G(spline_points_of_span)(s, mu, H);
        G(bspline_elevate)(spline(p, p + 1, dim, s->knots + mu - p, H), 1, room->knots + j, &p, P);
        cagd_status status = G(spline_put)(s, j, 1, P, room, where);
        if (status != CAGD_OK)
            return status;
    }
    return G(spline_result)(s, count, room, where);
}

/* How many points the curve has in degree p-1, if it is of that degree. */
KERNEL int G(spline_reduced_count)(const struct G(spline) * s)
{
    return G(lowered_knots)(s->count, s->degree, s->knots, NULL);
}

/* The curve in degree p-1: as many points as spline_reduced_count says.  DEGREE for p = 0.  Possible if and only if every
 * segment is of the lower degree: its continuity at the knots is then what the lowered multiplicities ask for.  Otherwise
 * CHANGES, and *where is a span whose segment is not.  Decided exactly, as removal is. */
KERNEL cagd_status G(spline_reduce)(const struct G(spline) * s, const struct G(spline_room) * room, int *where)
{
    num H[(MAX_DEGREE + 1) * MAX_DIM], b[(MAX_DEGREE + 1) * MAX_DIM], lower[(MAX_DEGREE + 1) * MAX_DIM],
        defect[MAX_DIM], P[MAX_DIM];
    int n = s->count, p = s->degree;
    *where = -1;
    if (p == 0)
        return CAGD_DEGREE;
    for (int mu = p; mu < n; mu++) {
        if (!G(before)(s->knots[mu], s->knots[mu + 1]))
            continue;
        int dim = G(spline_points_of_span)(s, mu, H);
        G(bspline_to_bezier)(G(span_alone)(p, dim, s->knots, mu, H), b);
        G(bezier_reduce)(p, dim, b, lower, defect);
        for (int k = 0; k < dim; k++)
            if (!G(is_zero)(defect[k])) {
                *where = mu;
                return CAGD_CHANGES;
            }
    }
    int count = G(lowered_knots)(n, p, s->knots, room->knots);
    for (int j = 0; j < count; j++) {
        int mu = G(span_of_point)(n, p, s->knots, count, p - 1, room->knots, j),
            dim = G(spline_points_of_span)(s, mu, H);
        G(bspline_reduce)(spline(p, p + 1, dim, s->knots + mu - p, H), 1, room->knots + j, &p, P);
        cagd_status status = G(spline_put)(s, j, 1, P, room, where);
        if (status != CAGD_OK)
            return status;
    }
    return G(spline_result)(s, count, room, where);
}

/* How many points the parts on the left and on the right of t have, u_p < t < u_n.  OUTSIDE_DOMAIN. */
KERNEL cagd_status G(spline_split_counts)(const struct G(spline) * s, num t, int *left, int *right)
{
    if (!G(spline_inside)(s, t))
        return CAGD_OUTSIDE_DOMAIN;
    int mu = G(find_span)(s->count, s->degree, s->knots, t);
    *left = mu - G(spline_multiplicity)(s, t) + 1;
    *right = s->count - mu + s->degree;
    return CAGD_OK;
}

/* The two parts, in each of which t is a knot p+1 times; counts as spline_split_counts says.  *where is an index in the
 * part that has the weight 0. */
KERNEL cagd_status G(spline_split)(const struct G(spline) * s, num t, const struct G(spline_room) * left,
                                   const struct G(spline_room) * right, int *where)
{
    num H[(MAX_DEGREE + 1) * MAX_DIM], L[(MAX_DEGREE + 1) * MAX_DIM], Q[(MAX_DEGREE + 1) * MAX_DIM],
        ends[2 * (2 * MAX_DEGREE + 2)];
    int lefts, rights, n = s->count, p = s->degree;
    *where = -1;
    cagd_status status = G(spline_split_counts)(s, t, &lefts, &rights);
    if (status != CAGD_OK)
        return status;
    /* The span by itself: its knots u_{mu-p}, ..., u_{mu+p+1} and p+1 points are split; the rest is copied. */
    int mu = n + p - rights, first = mu - p, dim = G(spline_points_of_span)(s, mu, H);
    G(bspline_split)
    (spline(p, p + 1, dim, s->knots + first, H), p, mu + 1 - lefts, t, ends, L, ends + 2 * MAX_DEGREE + 2, Q);
    G(spline_copy)(s, 0, 0, first, left); /* no knot is there more than p+1 times: lefts >= first */
    if (lefts > first)
        status = G(spline_put)(s, first, lefts - first, L, left, where);
    if (status == CAGD_OK)
        status = G(spline_put)(s, 0, p + 1, Q, right, where);
    if (status != CAGD_OK)
        return status;
    G(spline_copy)(s, mu + 1, p + 1, rights - p - 1, right);
    for (int i = 0; i < lefts + p + 1; i++)
        left->knots[i] = i < lefts ? s->knots[i] : t;
    for (int i = 0; i < rights + p + 1; i++)
        right->knots[i] = i <= p ? t : s->knots[mu + i - p];
    status = G(spline_result)(s, lefts, left, where);
    return status == CAGD_OK ? G(spline_result)(s, rights, right, where) : status;
}

/* The p+1 Bézier points of the segment of mu and their weights: the curve over [u_mu, u_{mu+1}] over the unit interval.
 * OUTSIDE_DOMAIN unless mu is a span. */
KERNEL cagd_status G(spline_bezier)(const struct G(spline) * s, int mu, const struct G(spline_room) * room, int *where)
{
    num H[(MAX_DEGREE + 1) * MAX_DIM], B[(MAX_DEGREE + 1) * MAX_DIM];
    int p = s->degree;
    *where = -1;
    if (mu < p || mu >= s->count || !G(before)(s->knots[mu], s->knots[mu + 1]))
        return CAGD_OUTSIDE_DOMAIN;
    int dim = G(spline_points_of_span)(s, mu, H);
    G(bspline_to_bezier)(G(span_alone)(p, dim, s->knots, mu, H), B);
    cagd_status status = G(spline_put)(s, 0, p + 1, B, room, where);
    return status == CAGD_OK ? G(spline_result)(s, p + 1, room, where) : status;
}
#include "core/number/generic_off.h"
