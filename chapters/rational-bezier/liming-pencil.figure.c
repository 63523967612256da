/* liming-pencil.figure.c -- drawings for liming-pencil.claims.h. */
#include "chapters/rational-bezier/conic-figures.h"

/* The member of lambda is the rational quadratic of weights 1, w, 1 with lambda = 1/(4 w^2 + 1). */
FIGURE(limings_pencil)
{
    svg *s = svg_new("limings_pencil", "Liming's pencil",
                     "Conics that touch the line l1 in R0 and the line l2 in R2.  Inside the triangle, with the minus "
                     "sign, λ grows from 0 at R1 to 1 at the chord; λ = 1/5 is the parabola.  The other arcs of the "
                     "same conics lie outside.");
    num_q R[6] = {q(0), q(0), q(2), q(5), q(7), q(1)}, shoulder[2];
    static const struct {
        int m, n;
        const char *lambda;
    } member[] = {{2, 1, "λ=1/17"}, {1, 1, "λ=1/5"}, {1, 2, "λ=1/2"}, {1, 4, "λ=4/5"}};
    svg_panel(s, svg_integer_window(-2, -3, 9, 6), 560, 0,
              "$(1-λ)l_1l_2+λl_3^2=0$ for four values of $λ$,\nthe lines written as determinants of their points");
    svg_area(s, 3, R, SVG_FILL);
    svg_line(s, svg_pair(R), svg_pair(R + 2), SVG_POLYGON);
    svg_line(s, svg_pair(R + 4), svg_pair(R + 2), SVG_POLYGON);
    svg_line(s, svg_pair(R), svg_pair(R + 4), SVG_MUTED);
    for (int k = 0; k < 4; k++) {
        num_q w[3] = {q(1), r(member[k].m, member[k].n), q(1)}, other[3] = {q(1), r(-member[k].m, member[k].n), q(1)};
        svg_rational(s, 2, R, w, k == 1 ? SVG_CURVE : SVG_CURVE_2);
        svg_rational(s, 2, R, other, SVG_FAMILY);
        conic_shoulder_point_q(R, w, shoulder);
        svg_label(s, svg_pair(shoulder), k == 3 ? SVG_S : SVG_NE, SVG_POINT, member[k].lambda);
    }
    put_triangle(s, R, SVG_NW, SVG_N, SVG_NE);
    svg_label(s, (svg_point){r(4, 5), q(2)}, SVG_W, SVG_POLYGON, "l_1");
    svg_label(s, (svg_point){r(11, 2), r(11, 5)}, SVG_NE, SVG_POLYGON, "l_2");
    svg_label(s, (svg_point){r(-7, 5), r(-1, 5)}, SVG_S, SVG_MUTED, "l_3");
    svg_legend_line(s, SVG_CURVE, "the parabola inside the triangle");
    svg_legend_line(s, SVG_CURVE_2, "other arcs inside the triangle, $0<λ<1$");
    svg_legend_line(s, SVG_FAMILY, "the rest of the same conics");
    return s;
}
