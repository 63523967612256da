#include "chapters/judge/figure_data.h"
#include "chapters/rational-bezier/implicit-figures.h"

FIGURE(implicit_points)
{
    svg *s =
        svg_new("implicit_points", "Points with a common root that are not on the curve",
                "Left the segment from (0, 0) to (1, 0) on its line: the point (2, 0) belongs to u = -1/2.  Right the "
                "cubic (t², t³ + t): the polynomial vanishes on the whole cubic, of which the curve is an arc, and at "
                "the isolated point (-1, 0), which belongs to t = ±i.");
    num_q segment[4], R[8], w[4];
    data_of("common_root_of_a_point_off_the_arc", "R", 2, 2, segment);
    data_of("common_root_of_an_isolated_point", "R", 4, 2, R);
    data_of("common_root_of_an_isolated_point", "ω", 4, 1, w);
    svg_panel(s, window(r(-3, 4), r(-3, 4), r(11, 4), r(3, 4)), 340, 0, "$n=1$: $F=y$ up to a factor");
    svg_line(s, svg_at(0, 0), svg_at(1, 0), SVG_CURVE_2);
    svg_bezier(s, 1, segment, SVG_CURVE);
    svg_mark(s, svg_at(0, 0), SVG_CURVE, SVG_USUAL);
    svg_mark(s, svg_at(1, 0), SVG_CURVE, SVG_USUAL);
    svg_label(s, svg_at(0, 0), SVG_N, SVG_CURVE, "R_0");
    svg_label(s, svg_at(1, 0), SVG_N, SVG_CURVE, "R_1");
    svg_mark(s, svg_at(2, 0), SVG_WRONG, SVG_USUAL);
    svg_label(s, svg_at(2, 0), SVG_N, SVG_WRONG, "u=-1/2");
    struct implicit_curve F = {3, R, w};
    svg_panel(s, window(r(-5, 2), r(-9, 4), r(5, 2), r(9, 4)), 300, 0, "$n=3$: $F=y^2-x(x+1)^2$ up to a factor");
    svg_implicit(s, determinant_at, &F, 160, SVG_CURVE_2);
    svg_bezier(s, 3, R, SVG_CURVE);
    svg_mark(s, svg_at(-1, 0), SVG_WRONG, SVG_USUAL);
    svg_label(s, svg_at(-1, 0), SVG_S, SVG_WRONG, "t=±i");
    svg_label(s, svg_at(0, 0), SVG_W, SVG_CURVE, "R_0");
    svg_label(s, svg_at(1, 2), SVG_SE, SVG_CURVE, "R_3");
    svg_mark(s, svg_at(0, 0), SVG_CURVE, SVG_USUAL);
    svg_mark(s, svg_at(1, 2), SVG_CURVE, SVG_USUAL);
    svg_legend_line(s, SVG_CURVE, "the curve, $0≤u≤∞$");
    svg_legend_line(s, SVG_CURVE_2, "$F=0$");
    svg_legend_mark(s, SVG_WRONG, SVG_USUAL, "common root, not on the curve");
    return s;
}

FIGURE(implicit_elevation)
{
    svg *s = svg_new("implicit_elevation", "Degree elevation destroys the implicit equation",
                     "The same arc of a parabola with three and with four control points, all weights 1.  With three "
                     "points the determinant vanishes on the parabola; with four it vanishes everywhere.");
    num_q R[6], w[3], Re[8], we[4];
    data_of("elevated_curve_has_no_equation", "R", 3, 2, R);
    data_of("elevated_curve_has_no_equation", "ω", 3, 1, w);
    struct implicit_curve F = {2, R, w};
    rational_elevate_q(2, 2, R, w, Re, we);
    svg_window view = window(r(-1, 2), r(-3, 10), r(13, 10), r(13, 10));
    svg_panel(s, view, 320, 0, "$n=2$: $F=x^2-y$");
    svg_heading(s, SVG_RIGHT, "an equation");
    svg_frame(s);
    svg_implicit(s, determinant_at, &F, 120, SVG_CURVE_2);
    svg_control_polygon(s, 2, R, "R");
    svg_bezier(s, 2, R, SVG_CURVE);
    svg_panel(s, view, 320, 0, "$n=3$: $F=0$ for all $x$ and $y$");
    svg_heading(s, SVG_WRONG, "no equation");
    svg_frame(s);
    num_q all[8] = {view.x0, view.y0, view.x1, view.y0, view.x1, view.y1, view.x0, view.y1};
    svg_area(s, 4, all, SVG_WRONG);
    svg_control_polygon(s, 3, Re, "R");
    svg_bezier(s, 3, Re, SVG_CURVE);
    svg_legend_line(s, SVG_CURVE, "the curve");
    svg_legend_line(s, SVG_CURVE_2, "$F=0$");
    svg_legend_area(s, SVG_WRONG, "$F=0$ everywhere");
    return s;
}

FIGURE(implicit_shadow)
{
    svg *s = svg_new("implicit_shadow", "In space the equation is that of a cylinder",
                     "The cubic (t, t², t³ + t) seen along y and along z.  The determinant formed from x and z "
                     "vanishes at the point "
                     "(1/2, 0, 5/8) as at the point (1/2, 1/4, 5/8) of the curve: seen along y the two are one.");
    num_q R[12], xz[8], xy[8], w[4];
    data_of("space_curve_and_its_shadow", "R", 4, 3, R);
    data_of("space_curve_and_its_shadow", "ω", 4, 1, w);
    for (int i = 0; i < 4; i++) {
        xz[2 * i] = xy[2 * i] = R[3 * i];
        xy[2 * i + 1] = R[3 * i + 1];
        xz[2 * i + 1] = R[3 * i + 2];
    }
    struct implicit_curve F = {3, xz, w};
    svg_panel(s, window(r(-1, 4), r(-1, 4), r(5, 4), r(9, 4)), 250, 0, "seen along $y$: $F(x,z)=0$ in both points");
    svg_axes(s, r(1, 2), r(1, 2), "x", "z");
    svg_implicit(s, determinant_at, &F, 160, SVG_CURVE_2);
    svg_bezier(s, 3, xz, SVG_CURVE);
    svg_mark(s, at(r(1, 2), r(5, 8)), SVG_WRONG, SVG_USUAL);
    svg_panel(s, window(r(-1, 4), r(-1, 2), r(5, 4), r(5, 4)), 330, 0,
              "seen along $z$, with $F(x,5/8)=0$:\none of them is beside the curve");
    svg_axes(s, r(1, 2), r(1, 2), "x", "y");
    svg_bezier(s, 3, xy, SVG_CURVE);
    svg_line(s, at(r(1, 2), q(0)), at(r(1, 2), q(1)), SVG_CURVE_2);
    svg_mark(s, at(r(1, 2), r(1, 4)), SVG_RIGHT, SVG_USUAL);
    svg_mark(s, at(r(1, 2), q(0)), SVG_WRONG, SVG_USUAL);
    svg_legend_line(s, SVG_CURVE, "the curve");
    svg_legend_line(s, SVG_CURVE_2, "$F=0$");
    svg_legend_mark(s, SVG_RIGHT, SVG_USUAL, "$y=1/4$, on the curve");
    svg_legend_mark(s, SVG_WRONG, SVG_USUAL, "$y=0$, not on it");
    return s;
}
