#include "exact/curve/spline.h"

#include "exact/decide/sign.h"
#include "exact/kernels_q.h"
#include "exact/span.h"

#include "core/require.h"

#define is_zero_q cagd_is_zero_q /* decided, and noted nowhere */
static inline int is_number_q(num_q a)
{
    (void)a;
    return 1;
}
#define G(name) name##_q
#include "core/spline.tmpl.h"
#undef G

/* *room: in the region for `count` points of degree p.  NO_MEMORY when there is none. */
static cagd_status room_for(const cagd_spline_q *s, int p, int count, struct spline_room_q *room, int *where)
{
    size_t size = sizeof(num_q), points = (size_t)count;
    *where = -1;
    *room = (struct spline_room_q){.knots = region_bytes((points + (size_t)p + 1) * size),
                                   .points = region_bytes(points * (size_t)s->dim * size),
                                   .weights = s->weights != NULL ? region_bytes(points * size) : NULL};
    int found = room->knots != NULL && room->points != NULL && (s->weights == NULL || room->weights != NULL);
    return found ? CAGD_OK : CAGD_NO_MEMORY;
}

/* *result: the curve in the room, if it was made. */
static cagd_status made(cagd_status status, const cagd_spline_q *s, int p, int count, const struct spline_room_q *room,
                        cagd_spline_q *result)
{
    if (status == CAGD_OK)
        *result = (cagd_spline_q){p, count, s->dim, room->knots, room->points, room->weights};
    return status;
}

cagd_status cagd_spline_check_q(const cagd_spline_q *s, int *where)
{
    *where = -1;
    REQUIRE(0 <= s->degree && s->degree <= MAX_DEGREE, CAGD_DEGREE);
    REQUIRE(1 <= s->dim && s->dim < MAX_DIM, CAGD_DIMENSION);
    cagd_status status = check_knots_q(s->count, s->degree, s->knots, where);
    if (status == CAGD_OK || status == CAGD_COUNT)
        *where = -1;
    return status;
}

cagd_status cagd_spline_derivatives_q(const cagd_spline_q *s, num_q t, cagd_side side, int order, num_q *derivatives)
{
    int mu;
    REQUIRE(0 <= order && order <= MAX_DEGREE, CAGD_ORDER);
    cagd_status status = spline_span_q(s, t, side, &mu);
    return status == CAGD_OK ? spline_derivatives_q(s, mu, t, order, derivatives) : status;
}

cagd_status cagd_spline_curvature_squared_q(const cagd_spline_q *s, num_q t, cagd_side side, num_q *curvature_squared)
{
    num_q D[3 * MAX_DIM];
    REQUIRE(s->dim > 1, CAGD_DIMENSION);
    cagd_status status = cagd_spline_derivatives_q(s, t, side, 2, D);
    REQUIRE(status == CAGD_OK, status);
    REQUIRE(!is_zero_q(norm_squared_q(s->dim, D + s->dim)), CAGD_UNDEFINED);
    *curvature_squared = curvature_squared_q(s->dim, D + s->dim, D + 2 * s->dim);
    return CAGD_OK;
}

cagd_status cagd_spline_turn_q(const cagd_spline_q *s, num_q t, cagd_side side, int *turn)
{
    num_q D[3 * MAX_DIM];
    REQUIRE(s->dim == 2, CAGD_DIMENSION);
    cagd_status status = cagd_spline_derivatives_q(s, t, side, 2, D);
    REQUIRE(status == CAGD_OK, status);
    REQUIRE(!is_zero_q(norm_squared_q(2, D + 2)), CAGD_UNDEFINED);
    *turn = cagd_sign_q(cross2_q(D + 2, D + 4));
    return CAGD_OK;
}

cagd_status cagd_spline_torsion_q(const cagd_spline_q *s, num_q t, cagd_side side, num_q *torsion)
{
    num_q D[4 * MAX_DIM];
    REQUIRE(s->dim == 3, CAGD_DIMENSION);
    cagd_status status = cagd_spline_derivatives_q(s, t, side, 3, D);
    REQUIRE(status == CAGD_OK, status);
    REQUIRE(!is_zero_q(gram_q(3, D + 3, D + 6)), CAGD_UNDEFINED);
    *torsion = torsion_q(D + 3, D + 6, D + 9);
    return CAGD_OK;
}

int cagd_spline_has_poles_q(const cagd_spline_q *s)
{
    if (s->weights == NULL)
        return 0;
    for (int mu = s->degree; mu < s->count; mu++) {
        num_q b[MAX_DEGREE + 1];
        if (!before_q(s->knots[mu], s->knots[mu + 1]))
            continue;
        region_mark mark = region_open(); /* dropped once a segment */
        bspline_to_bezier_q(on_span_q(s->degree, 1, s->knots, mu, s->weights), b);
        enum cagd_sign_pattern sign =
            cagd_sign_on(poly_from_bernstein(s->degree, b), from_int_q(0), from_int_q(1), CLOSED);
        region_drop(mark);
        if (sign != SIGN_POSITIVE && sign != SIGN_NEGATIVE)
            return 1;
    }
    return 0;
}

cagd_status cagd_spline_insert_q(const cagd_spline_q *s, num_q x, cagd_spline_q *result, int *where)
{
    struct spline_room_q room;
    cagd_status found = room_for(s, s->degree, s->count + 1, &room, where);
    REQUIRE(found == CAGD_OK, found);
    return made(spline_insert_q(s, x, &room, where), s, s->degree, s->count + 1, &room, result);
}

cagd_status cagd_spline_remove_q(const cagd_spline_q *s, num_q x, cagd_spline_q *result, int *where)
{
    struct spline_room_q room;
    cagd_status found = room_for(s, s->degree, s->count - 1, &room, where);
    REQUIRE(found == CAGD_OK, found);
    return made(spline_remove_q(s, x, &room, where), s, s->degree, s->count - 1, &room, result);
}

/* Points that outlive a region, which is dropped once a segment: what a segment leaves behind would be a thousand times them. */
enum { MOST_KEPT = (MAX_DEGREE + 2) * MAX_DIM };
struct kept {
    mpq_t at[MOST_KEPT];
    int count;
};

static void keep(struct kept *k, int count, const num_q x[])
{
    for (int m = 0; m < count; m++, k->count++) {
        mpq_init(k->at[k->count]);
        mpq_set(k->at[k->count], x[m].at);
    }
}

/* The numbers that were kept, in the region that is open now. */
static void take_back(struct kept *k, num_q x[])
{
    for (int m = 0; m < k->count; m++) {
        x[m] = cagd_from_mpq_q(k->at[m]);
        mpq_clear(k->at[m]);
    }
    k->count = 0;
}

/* Points j, j+1, ... of the curve in degree p+1, as far as they are those of the segment of span mu, at most p+2: how many.
 * Point j is the polar form of its segment at v_{j+1}, ..., v_{j+p+1}, from the Bézier points of the segment, which are computed
 * once.  In binary64 this would lose digits, and so spline_elevate takes the mean of p+1 polar forms in degree p; here it
 * only takes less time, p of p^3 for a point. */
static int elevate_segment(const cagd_spline_q *s, int mu, int j, int count, const num_q knots[], num_q P[])
{
    struct kept kept = {.count = 0};
    num_q H[(MAX_DEGREE + 1) * MAX_DIM], B[(MAX_DEGREE + 1) * MAX_DIM], E[(MAX_DEGREE + 2) * MAX_DIM];
    int p = s->degree, made = 0;
    region_mark mark = region_open();
    int dim = spline_points_of_span_q(s, mu, H);
    bspline_to_bezier_q(span_alone_q(p, dim, s->knots, mu, H), B);
    bezier_elevate_q(p, dim, B, E);
    do {
        bspline_point_of_bezier_q(p + 1, dim, E, s->knots[mu], s->knots[mu + 1], knots + j + made + 1, P);
        keep(&kept, dim, P);
        made++;
    } while (made < p + 2 && j + made < count &&
             span_of_point_q(s->count, p, s->knots, count, p + 1, knots, j + made) == mu);
    region_drop(mark);
    take_back(&kept, P);
    return made;
}

static cagd_status elevate(const cagd_spline_q *s, int count, const struct spline_room_q *room, int *where)
{
    num_q P[MOST_KEPT];
    raised_knots_q(s->count, s->degree, s->knots, room->knots);
    for (int j = 0, made; j < count; j += made) {
        int mu = span_of_point_q(s->count, s->degree, s->knots, count, s->degree + 1, room->knots, j);
        made = elevate_segment(s, mu, j, count, room->knots, P);
        cagd_status status = spline_put_q(s, j, made, P, room, where);
        if (status != CAGD_OK)
            return status;
    }
    return spline_result_q(s, count, room, where);
}

cagd_status cagd_spline_elevate_q(const cagd_spline_q *s, cagd_spline_q *result, int *where)
{
    *where = -1;
    REQUIRE(s->degree < MAX_DEGREE, CAGD_DEGREE);
    int count = spline_elevated_count_q(s);
    struct spline_room_q room;
    cagd_status found = room_for(s, s->degree + 1, count, &room, where);
    REQUIRE(found == CAGD_OK, found);
    return made(elevate(s, count, &room, where), s, s->degree + 1, count, &room, result);
}

cagd_status cagd_spline_reduce_q(const cagd_spline_q *s, cagd_spline_q *result, int *where)
{
    *where = -1;
    REQUIRE(s->degree > 0, CAGD_DEGREE);
    int count = spline_reduced_count_q(s);
    struct spline_room_q room;
    cagd_status found = room_for(s, s->degree - 1, count, &room, where);
    REQUIRE(found == CAGD_OK, found);
    return made(spline_reduce_q(s, &room, where), s, s->degree - 1, count, &room, result);
}

cagd_status cagd_spline_split_q(const cagd_spline_q *s, num_q t, cagd_spline_q *left, cagd_spline_q *right, int *where)
{
    int lefts, rights;
    *where = -1;
    cagd_status status = spline_split_counts_q(s, t, &lefts, &rights);
    REQUIRE(status == CAGD_OK, status);
    struct spline_room_q at_left, at_right;
    status = room_for(s, s->degree, lefts, &at_left, where);
    REQUIRE(status == CAGD_OK, status);
    status = room_for(s, s->degree, rights, &at_right, where);
    REQUIRE(status == CAGD_OK, status);
    status = spline_split_q(s, t, &at_left, &at_right, where);
    made(status, s, s->degree, lefts, &at_left, left);
    return made(status, s, s->degree, rights, &at_right, right);
}

cagd_status cagd_spline_segment_q(const cagd_spline_q *s, int span, cagd_spline_q *segment, int *where)
{
    int p = s->degree;
    struct spline_room_q room;
    cagd_status found = room_for(s, p, p + 1, &room, where);
    REQUIRE(found == CAGD_OK, found);
    cagd_status status = spline_bezier_q(s, span, &room, where);
    for (int i = 0; i < 2 * p + 2 && status == CAGD_OK; i++)
        room.knots[i] = s->knots[i <= p ? span : span + 1];
    return made(status, s, p, p + 1, &room, segment);
}
