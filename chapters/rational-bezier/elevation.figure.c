/* Figures of the section on degree elevation. */
#include "chapters/rational-bezier/polygon.h"

/* The polygon of degree N, by homogeneous coordinates: no vertex between needs to exist. */
static struct polygon raised(struct polygon p, int N)
{
    num_q H[3 * (LARGEST + 1)], E[3 * (LARGEST + 1)];
    rational_homogenize_q(p.n, 2, p.R, p.w, H);
    for (int n = p.n; n < N; n++) {
        bezier_elevate_q(n, 3, H, E);
        for (int k = 0; k < 3 * (n + 2); k++)
            H[k] = E[k];
    }
    p.n = N;
    rational_dehomogenize_q(N, 2, H, p.R, p.w);
    return p;
}

static const long arch[] = {0, 0, 1, 4, 5, 4, 6, 0}, arch_weights[] = {1, 1, 3, 1};

FIGURE(elevation_cuts_corners)
{
    svg *s =
        svg_new("elevation_cuts_corners", "Degree elevation cuts corners",
                "A rational cubic with weights 1, 1, 3, 1, its polygon of four points, and the polygon of five points "
                "of the same curve in degree 4, each of whose inner vertices divides an edge of the first.");
    struct polygon p = polygon_of(3, arch, arch_weights), q = raised(p, 4);
    svg_panel(s, svg_integer_window(-1, -1, 7, 5), 480, 0,
              "weights $1, 1, 3, 1$: the new vertices $R'_i$ on the edges\nof the vertex of weight 3 are drawn to it");
    svg_control_polygon(s, p.n, p.R, "R");
    svg_polyline(s, q.n + 1, q.R, SVG_RIGHT);
    svg_rational(s, p.n, p.R, p.w, SVG_CURVE);
    static const char *const name[] = {"", "R'_1", "R'_2", "R'_3", ""};
    static const enum svg_direction side[] = {SVG_HERE, SVG_W, SVG_N, SVG_E, SVG_HERE};
    for (int i = 1; i < q.n; i++) {
        svg_mark(s, svg_pair(q.R + 2 * i), SVG_RIGHT, SVG_USUAL);
        svg_label(s, svg_pair(q.R + 2 * i), side[i], SVG_RIGHT, name[i]);
    }
    svg_legend_line(s, SVG_POLYGON, "polygon, degree 3");
    svg_legend_line(s, SVG_RIGHT, "polygon, degree 4");
    svg_legend_line(s, SVG_CURVE, "the curve of both");
    return s;
}

FIGURE(elevation_converges)
{
    svg *s =
        svg_new("elevation_converges", "The elevated polygons converge to the curve, slowly",
                "The polygons of one rational cubic in the degrees 3, 4, 6, 12 and 32; the last still has a visible "
                "distance from the curve.");
    static const int degree[] = {4, 6, 12};
    struct polygon p = polygon_of(3, arch, arch_weights);
    svg_panel(s, svg_integer_window(-1, -1, 7, 5), 480, 0,
              "degrees 3, 4, 6, 12 and 32: the distance is of order $1/N$");
    for (int k = 0; k < 3; k++) {
        struct polygon q = raised(p, degree[k]);
        svg_polyline(s, q.n + 1, q.R, SVG_FAMILY);
    }
    struct polygon last = raised(p, 32);
    svg_control_polygon(s, p.n, p.R, "R");
    svg_polyline(s, last.n + 1, last.R, SVG_RIGHT);
    svg_rational(s, p.n, p.R, p.w, SVG_CURVE);
    svg_legend_line(s, SVG_POLYGON, "degree 3");
    svg_legend_line(s, SVG_FAMILY, "4, 6, 12");
    svg_legend_line(s, SVG_RIGHT, "32");
    svg_legend_line(s, SVG_CURVE, "the curve");
    return s;
}

FIGURE(elevation_mixed_weights)
{
    svg *s = svg_new(
        "elevation_mixed_weights", "Elevation with weights of both signs",
        "Left: a quadratic with weights 4, -1, 4; the elevated vertices are on the lines of the edges, but outside "
        "the edges. Right: a quadratic with weights 2, -1, 2, whose polygons of degree 3 and 4 have vertices at "
        "infinity, and whose polygon of degree 5 exists.");
    struct polygon p = polygon_of_claim(2, "elevated_vertex_may_leave_the_edge"), q = raised(p, 3);
    svg_panel(s, svg_integer_window(-3, -2, 3, 2), 360, 0,
              "weights $4, -1, 4$: the vertices of degree 3\nare on the lines of the edges, outside them");
    svg_heading(s, SVG_WRONG, "corners are cut");
    draw_triangle(s, p);
    svg_polyline(s, q.n + 1, q.R, SVG_WRONG);
    svg_rational(s, p.n, p.R, p.w, SVG_CURVE);
    svg_label(s, svg_pair(q.R + 2), SVG_W, SVG_WRONG, "R'_1");
    svg_label(s, svg_pair(q.R + 4), SVG_E, SVG_WRONG, "R'_2");
    for (int i = 1; i <= 2; i++)
        svg_mark(s, svg_pair(q.R + 2 * i), SVG_WRONG, SVG_USUAL);
    data_of("elevated_vertex_may_be_at_infinity", "ω", 3, 1, p.w);
    struct polygon r = raised(p, 5), far = raised(p, 12);
    svg_panel(s, svg_integer_window(-4, -4, 4, 2), 360, 0,
              "weights $2, -1, 2$: vertices of degree 3 and 4\nare at infinity; from degree 5 on all exist");
    svg_heading(s, SVG_WRONG, "elevation can be repeated for ever");
    draw_triangle(s, p);
    svg_polyline(s, r.n + 1, r.R, SVG_FAMILY);
    svg_polyline(s, far.n + 1, far.R, SVG_RIGHT);
    svg_rational(s, p.n, p.R, p.w, SVG_CURVE);
    svg_legend_line(s, SVG_CURVE, "curve");
    svg_legend_line(s, SVG_POLYGON, "degree 2");
    svg_legend_line(s, SVG_WRONG, "degree 3");
    svg_legend_line(s, SVG_FAMILY, "degree 5");
    svg_legend_line(s, SVG_RIGHT, "degree 12");
    return s;
}
