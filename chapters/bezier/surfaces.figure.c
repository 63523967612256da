/* Figures of the section on surfaces. */
#include "chapters/judge/figure.h"
#include "figures/words.h"

/* A parallel projection: x to the right, y into the page, z up. */
static svg_point seen(const num_q X[])
{
    return at(add_q(X[0], mul_q(r(9, 20), X[1])), add_q(mul_q(r(11, 20), X[2]), mul_q(r(13, 20), X[1])));
}

/* The polygon or the curve of count points of space. */
static void put_line(svg *s, int count, const num_q X[], int curve, enum svg_role role)
{
    num_q flat[2 * (MAX_DEGREE + 1)];
    for (int k = 0; k < count; k++) {
        svg_point p = seen(X + 3 * k);
        flat[2 * k] = p.x, flat[2 * k + 1] = p.y;
    }
    if (curve)
        svg_bezier(s, count - 1, flat, role);
    else
        svg_polyline(s, count, flat, role);
}

/* The rows and columns of the net, or the parameter lines of the surface. */
static void put_surface(svg *s, int n, int m, const num_q P[], int lines, enum svg_role border, enum svg_role inner)
{
    num_q Q[3 * 64], b[3 * 16];
    bezier_surface_transpose_q(net_q(n, m, 3, P), Q);
    for (int k = 0; k <= lines; k++) {
        enum svg_role role = k == 0 || k == lines ? border : inner;
        bezier_surface_line_q(net_q(n, m, 3, P), r(k, lines), b);
        put_line(s, m + 1, b, 1, role);
        bezier_surface_line_q(net_q(m, n, 3, Q), r(k, lines), b);
        put_line(s, n + 1, b, 1, role);
    }
}

static void put_net(svg *s, int n, int m, const num_q P[])
{
    num_q Q[3 * 64];
    bezier_surface_transpose_q(net_q(n, m, 3, P), Q);
    for (int i = 0; i <= n; i++)
        put_line(s, m + 1, P + 3 * i * (m + 1), 0, SVG_POLYGON);
    for (int j = 0; j <= m; j++)
        put_line(s, n + 1, Q + 3 * j * (n + 1), 0, SVG_POLYGON);
    for (int k = 0; k < (n + 1) * (m + 1); k++)
        svg_mark(s, seen(P + 3 * k), SVG_POLYGON, SVG_USUAL);
}

/* A short arrow along the normal; `share` of its length. */
static void put_normal(svg *s, int n, int m, const num_q P[], num_q u, num_q w, num_q share, enum svg_role role)
{
    num_q X[3], N[3], end[3];
    bezier_surface_point_q(net_q(n, m, 3, P), u, w, X);
    bezier_surface_normal_q(net_q(n, m, 3, P), u, w, N);
    for (int c = 0; c < 3; c++)
        end[c] = add_q(X[c], mul_q(share, N[c]));
    svg_arrow(s, seen(X), seen(end), role);
}

FIGURE(bezier_patch)
{
    svg *s = svg_new("bezier_patch", "A net, its surface, and normals",
                     "A net of four by three points with the surface of degree 3 in u and 2 in w, by its parameter "
                     "lines, and its normals at nine points.");
    static const int height[12] = {0, 1, 0, 2, 4, 1, 1, 3, 2, -1, 1, 0};
    num_q P[36];
    for (int i = 0; i <= 3; i++)
        for (int j = 0; j <= 2; j++) {
            num_q *p = P + 3 * (3 * i + j);
            p[0] = q(2 * i), p[1] = q(3 * j), p[2] = q(height[3 * i + j]);
        }
    for (int panel = 0; panel < 2; panel++) {
        svg_panel(s, window(r(-1, 2), q(-1), q(9), q(6)), 350, 0, panel ? "lines, and $P_u×P_w$" : "the net");
        put_surface(s, 3, 2, P, 8, SVG_CURVE, SVG_FAMILY);
        if (panel == 0) /* the net is above the surface, and so in front of it */
            put_net(s, 3, 2, P);
        for (int k = 0; k < 9 && panel == 1; k++)
            put_normal(s, 3, 2, P, r(k / 3 + 1, 4), r(k % 3 + 1, 4), r(1, 30), SVG_RIGHT);
    }
    svg_legend_line(s, SVG_CURVE, "borders");
    svg_legend_line(s, SVG_FAMILY, "parameter lines");
    svg_legend_line(s, SVG_RIGHT, "normals");
    return s;
}

FIGURE(collapsed_border)
{
    svg *s =
        svg_new("collapsed_border", "A border of one point",
                "A plane triangle as a surface of degrees 1 and 1, one of whose borders is a point.  The lengths of "
                "P_u x P_w go to 0 towards that point.");
    static const int from[12] = {0, 0, 0, 0, 0, 0, 3, 0, 0, 0, 3, 0};
    num_q P[12];
    integers(12, from, P);
    svg_panel(s, window(r(-1, 2), r(-1, 2), r(7, 2), q(3)), 380, 0, "$P_{00}=P_{01}$: the normals $P_u×P_w$");
    put_surface(s, 1, 1, P, 6, SVG_CURVE, SVG_FAMILY);
    for (int k = 1; k <= 4; k++)
        put_normal(s, 1, 1, P, r(k, 4), r(1, 2), r(1, 5), SVG_RIGHT);
    svg_mark(s, seen(P), SVG_WRONG, SVG_USUAL);
    svg_legend_line(s, SVG_CURVE, "borders");
    svg_legend_line(s, SVG_RIGHT, "normals");
    svg_legend_mark(s, SVG_WRONG, SVG_USUAL, "the normal is 0");
    return s;
}
