#include "chapters/rational-bezier/plane-figures.h"

/* The arc of degree n <= 4 whose points and weights a claim has in its data. */
static void put_arc(svg *s, int n, const char *claim_name, const char *points, const char *weights)
{
    num_q R[10], w[5];
    data_of(claim_name, points, n + 1, 2, R);
    data_of(claim_name, weights, n + 1, 1, w);
    svg_rational(s, n, R, w, SVG_CURVE);
}

FIGURE(genus_zero)
{
    svg *s = svg_new(
        "genus_zero", "Curves of genus 0 with nodes and cusps",
        "The nodal cubic, the cuspidal cubic, the lemniscate and the cardioid.  Each carries the rational Bézier "
        "arc of the parameters from 0 to 1; the marked points are the real singular points.  The lemniscate and "
        "the cardioid have two more, imaginary and at infinity.");
    static const char claim_name[] = "curves_that_fit_the_theorem";
    static const struct {
        const char *name, *points, *weights;
        int terms, n;
        const char *caption;
    } curves[4] = {
        {"nodal cubic", "R, nodal cubic", "ω, nodal cubic", 3, 3, "$y^2=x^2(x+1)$\n$g=1-1$: a node"},
        {"cuspidal cubic", "R, cuspidal cubic", "ω, cuspidal cubic", 2, 3, "$y^2=x^3$\n$g=1-1$: a cusp"},
        {"lemniscate", "R, lemniscate", "ω, lemniscate", 5, 4,
         "$(x^2+y^2)^2=x^2-y^2$\n$g=3-3$: nodes here and at $(1:±i:0)$"},
        {"cardioid", "R, cardioid", "ω, cardioid", 6, 4,
         "$(x^2+y^2)^2+4x(x^2+y^2)=4y^2$\n$g=3-3$: cusps here and at $(1:±i:0)$"},
    };
    for (int k = 0; k < 4; k++) {
        svg_window view = k == 0   ? window(r(-3, 2), r(-3, 2), r(3, 2), r(3, 2))
                          : k == 1 ? window(q(-1), r(-3, 2), q(2), r(3, 2))
                          : k == 2 ? window(r(-5, 4), r(-5, 4), r(5, 4), r(5, 4))
                                   : window(r(-9, 2), r(-11, 4), q(1), r(11, 4));
        svg_panel(s, view, 230, 0, curves[k].caption);
        svg_frame(s);
        struct terms F = terms_of(claim_name, curves[k].name, curves[k].terms);
        svg_implicit(s, value_of, &F, 160, SVG_CURVE_2);
        put_arc(s, curves[k].n, claim_name, curves[k].points, curves[k].weights);
        svg_mark(s, svg_at(0, 0), SVG_RIGHT, SVG_USUAL);
    }
    svg_legend_line(s, SVG_CURVE, "a rational Bézier arc");
    svg_legend_line(s, SVG_CURVE_2, "the algebraic curve");
    svg_legend_mark(s, SVG_RIGHT, SVG_USUAL, "a double point, $δ=1$");
    return s;
}

FIGURE(genus_extra)
{
    svg *s = svg_new(
        "genus_extra", "Curves for which the count is wrong",
        "A cubic with a line, counted 0 and not rational; a quartic with a triple point, counted 3 and "
        "rational; a quartic with a higher cusp, counted 2 and rational; the cubic y = x³, whose cusp is at infinity.");
    static const struct {
        const char *claim_name, *name;
        int terms, n; /* n = 0: there is no arc */
        const char *heading, *caption;
    } curves[4] = {
        {"reducible_curve_with_count_zero", "cubic", 3, 0, "$g=0$, not rational", "$y(y^2-x^3+x)=0$"},
        {"rational_quartic_with_a_triple_point", "α, i, j", 3, 4, "$g=3$, rational", "$y^3-3x^2y+x^4=0$"},
        {"rational_quartic_with_a_higher_cusp", "α, i, j", 4, 4, "$g=2$, rational", "$(y-x^2)^2=xy^3$"},
        {"cuspidal_cubic_at_infinity", "α, i, j", 2, 3, "$g=1$, rational", "$y=x^3$, only finite\npoints counted"},
    };
    for (int k = 0; k < 4; k++) {
        svg_window view = k == 0   ? window(q(-2), q(-2), q(2), q(2))
                          : k == 1 ? window(r(-5, 2), r(-5, 2), r(5, 2), r(5, 2))
                          : k == 2 ? window(r(-1, 4), r(-1, 4), r(5, 4), r(5, 4))
                                   : window(r(-3, 2), r(-3, 2), r(3, 2), r(3, 2));
        svg_panel(s, view, 230, 0, curves[k].caption);
        svg_heading(s, SVG_WRONG, curves[k].heading);
        svg_frame(s);
        struct terms F = terms_of(curves[k].claim_name, curves[k].name, curves[k].terms);
        if (k == 0) /* times y */
            for (int i = 0; i < F.count; i++)
                F.term[3 * i + 2] = add_q(F.term[3 * i + 2], q(1));
        svg_implicit(s, value_of, &F, 160, SVG_CURVE_2);
        if (curves[k].n > 0)
            put_arc(s, curves[k].n, curves[k].claim_name, "R", "ω");
        for (int x = -1; x <= 1 && k < 3; x++)
            if (k == 0 || x == 0)
                svg_mark(s, svg_at(x, 0), SVG_WRONG, SVG_USUAL);
    }
    svg_legend_line(s, SVG_CURVE, "a rational Bézier arc");
    svg_legend_line(s, SVG_CURVE_2, "the algebraic curve");
    svg_legend_mark(s, SVG_WRONG, SVG_USUAL, "a finite singular point");
    return s;
}
