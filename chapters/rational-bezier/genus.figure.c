#include "chapters/rational-bezier/plane-figures.h"

/* The arc with numerators X, Y and weights w, all times one factor. */
static void put_arc(svg *s, int n, const int X[], const int Y[], const int w[])
{
    num_q R[10], weight[5];
    for (int i = 0; i <= n; i++) {
        R[2 * i] = r(X[i], w[i]);
        R[2 * i + 1] = r(Y[i], w[i]);
        weight[i] = q(w[i]);
    }
    svg_rational(s, n, R, weight, SVG_CURVE);
}

FIGURE(genus_zero)
{
    svg *s = svg_new(
        "genus_zero", "Curves of genus 0 with nodes and cusps",
        "The nodal cubic, the cuspidal cubic, the lemniscate and the cardioid.  Each carries the rational Bézier "
        "arc of the parameters from 0 to 1; the marked points are the real singular points.  The lemniscate and "
        "the cardioid have two more, imaginary and at infinity.");
    static const struct {
        struct terms F;
        int n, X[5], Y[5], w[5];
        const char *caption;
    } curves[4] = {
        {{3, {{1, 0, 2}, {-1, 3, 0}, {-1, 2, 0}}},
         3,
         {-3, -3, -2, 0},
         {0, -1, -2, 0},
         {3, 3, 3, 3},
         "$y^2=x^2(x+1)$\n$g=1-1$: a node"},
        {{2, {{1, 0, 2}, {-1, 3, 0}}}, 3, {0, 0, 1, 3}, {0, 0, 0, 3}, {3, 3, 3, 3}, "$y^2=x^3$\n$g=1-1$: a cusp"},
        {{5, {{1, 4, 0}, {2, 2, 2}, {1, 0, 4}, {-1, 2, 0}, {1, 0, 2}}},
         4,
         {0, 1, 2, 4, 8},
         {0, 1, 2, 2, 0},
         {4, 4, 4, 4, 8},
         "$(x^2+y^2)^2=x^2-y^2$\n$g=3-3$: nodes here and at $(1:±i:0)$"},
        {{6, {{1, 4, 0}, {2, 2, 2}, {1, 0, 4}, {4, 3, 0}, {4, 1, 2}, {-4, 0, 2}}},
         4,
         {0, 0, 2, 6, 0},
         {0, 0, 0, 6, 24},
         {3, 3, 4, 6, 12},
         "$(x^2+y^2)^2+4x(x^2+y^2)=4y^2$\n$g=3-3$: cusps here and at $(1:±i:0)$"},
    };
    for (int k = 0; k < 4; k++) {
        svg_window view = k == 0   ? window(r(-3, 2), r(-3, 2), r(3, 2), r(3, 2))
                          : k == 1 ? window(q(-1), r(-3, 2), q(2), r(3, 2))
                          : k == 2 ? window(r(-5, 4), r(-5, 4), r(5, 4), r(5, 4))
                                   : window(r(-9, 2), r(-11, 4), q(1), r(11, 4));
        svg_panel(s, view, 230, 0, curves[k].caption);
        svg_frame(s);
        svg_implicit(s, value_of, &curves[k].F, 160, SVG_CURVE_2);
        put_arc(s, curves[k].n, curves[k].X, curves[k].Y, curves[k].w);
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
        struct terms F;
        int n, X[5], Y[5], w[5];
        const char *heading, *caption;
    } curves[4] = {
        {{3, {{1, 0, 3}, {-1, 3, 1}, {1, 1, 1}}}, 0, {0}, {0}, {0}, "$g=0$, not rational", "$y(y^2-x^3+x)=0$"},
        {{3, {{1, 0, 3}, {-3, 2, 1}, {1, 4, 0}}},
         4,
         {0, 3, 6, 8, 8},
         {0, 0, 2, 6, 8},
         {4, 4, 4, 4, 4},
         "$g=3$, rational",
         "$y^3-3x^2y+x^4=0$"},
        {{4, {{1, 0, 2}, {-2, 2, 1}, {1, 4, 0}, {-1, 1, 3}}},
         4,
         {0, 0, 2, 6, 12},
         {0, 0, 0, 0, 12},
         {12, 12, 12, 15, 24},
         "$g=2$, rational",
         "$(y-x^2)^2=xy^3$"},
        {{2, {{1, 0, 1}, {-1, 3, 0}}},
         3,
         {0, 1, 2, 3},
         {0, 0, 0, 3},
         {3, 3, 3, 3},
         "$g=1$, rational",
         "$y=x^3$, only finite\npoints counted"},
    };
    for (int k = 0; k < 4; k++) {
        svg_window view = k == 0   ? window(q(-2), q(-2), q(2), q(2))
                          : k == 1 ? window(r(-5, 2), r(-5, 2), r(5, 2), r(5, 2))
                          : k == 2 ? window(r(-1, 4), r(-1, 4), r(5, 4), r(5, 4))
                                   : window(r(-3, 2), r(-3, 2), r(3, 2), r(3, 2));
        svg_panel(s, view, 230, 0, curves[k].caption);
        svg_heading(s, SVG_WRONG, curves[k].heading);
        svg_frame(s);
        svg_implicit(s, value_of, &curves[k].F, 160, SVG_CURVE_2);
        if (curves[k].n > 0)
            put_arc(s, curves[k].n, curves[k].X, curves[k].Y, curves[k].w);
        for (int x = -1; x <= 1 && k < 3; x++)
            if (k == 0 || x == 0)
                svg_mark(s, svg_at(x, 0), SVG_WRONG, SVG_USUAL);
    }
    svg_legend_line(s, SVG_CURVE, "a rational Bézier arc");
    svg_legend_line(s, SVG_CURVE_2, "the algebraic curve");
    svg_legend_mark(s, SVG_WRONG, SVG_USUAL, "a finite singular point");
    return s;
}
