/* meeting.h -- how a plane curve of the family and its polygon meet a straight line, for the claims whose data are a curve and a
 * line.
 *
 * Generic text, after exact/record/crossings.h and definition.h; for rationals only. */
#include "chapters/judge/claims_on.h"

#if RATIONAL
/* side[i] = u . (X_i - Q) for n+1 points X */
static inline void G(sides)(int n, const num X[], const num Q[], const num u[], num side[])
{
    for (int i = 0; i <= n; i++) {
        num w[dim] = {sub(X[i * dim], Q[0]), sub(X[i * dim + 1], Q[1])};
        side[i] = G(dot)(dim, u, w);
    }
}

/* The line through the point Q with the normal vector u, from the data of the claim. */
static inline struct cagd_line G(given_line)(trial *T)
{
    num Q[dim], u[dim];
    given_points(T, "Q", 1, dim, Q);
    given_points(T, "u", 1, dim, u);
    return (struct cagd_line){u[0], u[1], neg(G(dot)(dim, u, Q))};
}

/* How the curve of eight points, printed or corrected functions, meets the line. */
static inline struct cagd_curve_meets_line G(curve_meets)(int printed_ones, const num P[], num beta, struct cagd_line L)
{
    num points[9 * dim], w[9];
    for (int k = 0; k <= 8; k++)
        w[k] = from_int(1);
    G(bezier_points_of)(printed_ones, 7, dim, P, beta, points);
    return curve_meets_line(8, points, w, L);
}

/* A curve of the family, its polygon, and how both meet a line; side[i] = u . (P_i - Q). */
struct G(meeting) {
    num beta, P[8 * dim], side[8];
    struct cagd_curve_meets_line curve;
    struct cagd_polygon_meets_line polygon;
};

/* That of the data of the claim: β, eight points P, the point Q and the normal vector u. */
static inline struct G(meeting) G(given_meeting)(trial *T, int printed_ones)
{
    struct G(meeting) m = {.beta = given(T, "β")};
    given_points(T, "P", 8, dim, m.P);
    struct cagd_line L = G(given_line)(T);
    for (int i = 0; i <= 7; i++)
        m.side[i] = add(add(mul(L.a, m.P[i * dim]), mul(L.b, m.P[i * dim + 1])), L.c);
    m.curve = G(curve_meets)(printed_ones, m.P, m.beta, L);
    m.polygon = polygon_meets_line(7, m.P, L);
    return m;
}
#endif
#include "chapters/judge/claims_off.h"
