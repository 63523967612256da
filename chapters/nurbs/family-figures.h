/* family-figures.h -- what the drawings of the families of lower order have in common. */
#ifndef CAGD_NURBS_FAMILY_FIGURES_H
#define CAGD_NURBS_FAMILY_FIGURES_H

#include "chapters/judge/figure.h"
#include "exact/record/number.h"
#include "figures/words.h"

enum { KNOTS = 24, POINTS = 12 };

/* A plane curve of degree p: n points, homogeneous, over n+p+1 knots. */
struct nurbs {
    int n, p;
    num_q u[KNOTS], H[3 * POINTS];
};

/* From whole numbers: the knots, and (x, y, w) of each point, x and y over `unit`. */
static inline struct nurbs nurbs_of(int n, int p, const int knot[], const int point[], int unit)
{
    struct nurbs c = {.n = n, .p = p};
    for (int i = 0; i <= n + p; i++)
        c.u[i] = q(knot[i]);
    for (int i = 0; i < n; i++) {
        int w = point[3 * i + 2];
        c.H[3 * i] = r((long)w * point[3 * i], unit);
        c.H[3 * i + 1] = r((long)w * point[3 * i + 1], unit);
        c.H[3 * i + 2] = q(w);
    }
    return c;
}

/* The point of a polynomial of degree p that belongs to p knots: its polar form, by sums over subsets. */
static inline num_q polar_value(int p, const int power[], const num_q x[])
{
    num_q e[POINTS] = {q(1)}, sum = q(0);
    for (int m = 1; m <= p; m++)
        e[m] = q(0);
    for (int k = 0; k < p; k++)
        for (int m = k + 1; m >= 1; m--)
            e[m] = add_q(e[m], mul_q(x[k], e[m - 1]));
    for (int m = 0; m <= p; m++)
        sum = add_q(sum, mul_q(r(power[m], binomial(p, m)), e[m]));
    return sum;
}

/* One span [-s, s], mu = p, of uniform knots, on which the curve is the pair of polynomials, weights 1. */
static inline struct nurbs one_span(int p, int s, const int x[], const int y[])
{
    struct nurbs c = {.n = p + 1, .p = p};
    for (int i = 0; i < 2 * p + 2; i++)
        c.u[i] = q(s * (2 * (i - p) - 1));
    for (int i = 0; i <= p; i++) {
        c.H[3 * i] = polar_value(p, x, c.u + i + 1);
        c.H[3 * i + 1] = polar_value(p, y, c.u + i + 1);
        c.H[3 * i + 2] = q(1);
    }
    return c;
}

/* The Bézier points and weights of the member tau of level r on the span mu, of degree p-r. */
static inline void member_as_bezier(const struct nurbs *c, int mu, int level, num_q tau, num_q R[], num_q w[])
{
    num_q d[3 * POINTS], b[3 * POINTS], x[POINTS];
    int p = c->p, degree = p - level;
    for (int m = 0; m < 3 * (p + 1); m++)
        d[m] = c->H[3 * (mu - p) + m];
    for (int k = 1; k <= level; k++)
        bspline_deboor_level_q(on_span_q(p, 3, c->u, mu, NULL), k, d, tau);
    for (int i = 0; i <= degree; i++) {
        for (int k = 0; k < degree; k++)
            x[k] = c->u[k < degree - i ? mu : mu + 1];
        bspline_blossom_q(span_alone_q(degree, 3, c->u, mu, d), x, b + 3 * i);
    }
    rational_dehomogenize_q(degree, 2, b, R, w);
}

static inline void put_member(svg *s, const struct nurbs *c, int mu, int level, num_q tau, enum svg_role role)
{
    num_q R[2 * POINTS], w[POINTS];
    member_as_bezier(c, mu, level, tau, R, w);
    svg_rational(s, c->p - level, R, w, role);
}

/* Member after member of one span, `pieces`+1 of them. */
static inline void put_family(svg *s, const struct nurbs *c, int mu, int level, int pieces)
{
    num_q length = sub_q(c->u[mu + 1], c->u[mu]);
    for (int k = 0; k <= pieces; k++)
        put_member(s, c, mu, level, add_q(c->u[mu], mul_q(r(k, pieces), length)), SVG_FAMILY);
}

/* All segments of the curve. */
static inline void put_curve(svg *s, const struct nurbs *c, enum svg_role role)
{
    for (int mu = c->p; mu < c->n; mu++)
        if (!equal_q(c->u[mu], c->u[mu + 1]))
            put_member(s, c, mu, 0, c->u[mu], role);
}

static inline svg_point point_of(const struct nurbs *c, int mu, num_q t)
{
    num_q P[3], R[2], w[1];
    bspline_deboor_q(on_span_q(c->p, 3, c->u, mu, c->H), t, P);
    rational_dehomogenize_q(0, 2, P, R, w);
    return svg_pair(R);
}

static inline void put_polygon(svg *s, const struct nurbs *c, const char *letter)
{
    num_q R[2 * POINTS], w[POINTS];
    rational_dehomogenize_q(c->n - 1, 2, c->H, R, w);
    if (letter != NULL)
        svg_control_polygon(s, c->n - 1, R, letter);
    else
        svg_polyline(s, c->n, R, SVG_POLYGON);
}
#endif
