/* Figures of the section on surfaces in a frame of curves. */
#include "chapters/hermite-coons/drawing.h"

/* One line of the surface over the unit square, u or w fixed. */
struct isoline {
    num_q fixed;
    int along_w, whole; /* whole: without the surface of the corners it is the sum of the ruled ones */
};

static num_q arch(num_q t) { return mul_q(t, sub_q(q(1), t)); }

static svg_point seen(num_q u, num_q w, num_q z) { return at(add_q(u, div_q(w, q(2))), add_q(mul_q(r(2, 5), w), z)); }

/* The frame: P(u,0) = 1/2 + 2u(1-u), P(0,w) = 1/2 + 3w(1-w)/2, P(u,1) = P(1,w) = 1/2.  The sum of the ruled surfaces is
 * 1/2 too high on every border. */
static svg_point surface(num_q t, const void *data)
{
    const struct isoline *line = data;
    num_q u = line->along_w ? line->fixed : t, w = line->along_w ? t : line->fixed, one = q(1), lift = r(1, 2);
    num_q a[2] = {sub_q(one, u), u}, b[2] = {sub_q(one, w), w}, M[4], z;
    num_q A[2] = {add_q(lift, mul_q(r(3, 2), arch(w))), lift}, B[2] = {add_q(lift, mul_q(q(2), arch(u))), lift};
    for (int i = 0; i < 4; i++)
        M[i] = line->whole ? lift : q(0);
    coons_patch_q(2, 1, a, b, A, B, M, &z);
    return seen(u, w, z);
}

FIGURE(boolean_sum)
{
    svg *s = svg_new("boolean_sum", "The sum of two ruled surfaces, and the patch",
                     "Left, the sum of the ruled surfaces lies above the frame by the surface of the corners; right, "
                     "without that surface the borders are the frame.");
    for (int panel = 0; panel < 2; panel++) {
        svg_panel(s, window(r(-1, 10), r(2, 5), r(8, 5), r(39, 20)), 300, 0,
                  panel ? "$P_1+P_2-P_3$" : "$P_1+P_2$ and the frame");
        for (int k = 0; k <= 8; k++)
            for (int along = 0; along < 2; along++) {
                struct isoline line = {r(k, 8), along, panel};
                svg_plot(s, surface, &line, q(0), q(1), 8, k % 8 == 0 && panel == 0 ? SVG_CURVE_2 : SVG_FAMILY);
                line.whole = 1;
                if (k % 8 == 0)
                    svg_plot(s, surface, &line, q(0), q(1), 8, SVG_CURVE);
            }
    }
    svg_legend_line(s, SVG_CURVE, "the frame");
    svg_legend_line(s, SVG_CURVE_2, "the borders of $P_1+P_2$");
    return s;
}

FIGURE(two_twists)
{
    svg *s = svg_new("two_twists", "Two twists at one corner",
                     "The derivative across the border u = 0 is asked to be 0, that across w = 0 to be q10, whose "
                     "derivative at the corner is 1.  With the twist 0 in M the first is missed, with the twist 1 the "
                     "second.");
    for (int twist = 0; twist < 2; twist++) {
        svg_panel(s, window(q(0), q(0), q(1), r(1, 5)), 280, 180,
                  twist ? "the derivative across $w=0$,\n$P_w(u,0)$" : "the derivative across $u=0$,\n$P_u(0,w)$");
        svg_heading(s, SVG_POINT, twist ? "the twist in $M$ is 1" : "the twist in $M$ is 0");
        svg_axes(s, q(1), r(1, 10), twist ? "u" : "w", NULL);
        num_q bump[4] = {q(0), q(0), q(1), q(0)}, none[4] = {q(0), q(0), q(0), q(0)};
        put_hermite_graph(s, q(0), q(1), twist ? bump : none, SVG_CURVE);
        put_hermite_graph(s, q(0), q(1), twist ? none : bump, SVG_WRONG);
        svg_label(s, at(r(1, 3), r(4, 27)), SVG_N, twist ? SVG_CURVE : SVG_WRONG, "q_{10}");
        svg_label(s, at(r(1, 3), q(0)), SVG_N, twist ? SVG_WRONG : SVG_CURVE, "0");
    }
    svg_legend_line(s, SVG_CURVE, "asked for");
    svg_legend_line(s, SVG_WRONG, "what the patch has");
    return s;
}
