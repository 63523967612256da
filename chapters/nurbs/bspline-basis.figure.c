#include "chapters/nurbs/bspline-figures.h"
#include "exact/record/number.h"

FIGURE(bspline_supports)
{
    enum { p = 2, n = 6 };
    static const int knot[n + p + 1] = {0, 1, 3, 4, 6, 7, 9, 10, 11};
    num_q u[n + p + 1];
    integers(n + p + 1, knot, u);
    svg *s = svg_new(
        "bspline_supports", "B-splines, their supports and the Greville abscissae",
        "Six quadratic B-splines over simple knots; under each a bar from its first to its last knot, and on the bar "
        "its Greville abscissa. The domain, where they sum to one, is shaded.");
    svg_panel(s, (svg_window){from_int_q(0), from_ratio_q(-11, 10), from_int_q(11), from_int_q(1)}, 640, 320,
              "$N_{i,2}$ over the knots $u_0, ..., u_8$. Each lives on three intervals; the bars are the supports, the "
              "rings\n"
              "on them the Greville abscissae. Shaded: the domain $[u_2, u_6]$, where the sum is 1.");
    num_q domain[8] = {u[p], from_int_q(0), u[n], from_int_q(0), u[n], from_int_q(1), u[p], from_int_q(1)};
    svg_area(s, 4, domain, SVG_FILL);
    svg_segment(s, svg_at(0, 0), svg_at(11, 0), SVG_AXIS);
    for (int i = 0; i <= n + p; i++) {
        char name[8];
        snprintf(name, sizeof name, "u_%d", i);
        svg_mark(s, (svg_point){u[i], from_int_q(0)}, SVG_POINT, SVG_DISC);
        svg_label(s, (svg_point){u[i], from_int_q(0)}, SVG_S, SVG_POINT, name);
    }
    for (int i = 0; i < n; i++) {
        enum svg_role role = i % 2 == 0 ? SVG_CURVE : SVG_CURVE_2;
        num_q level = from_ratio_q(-(30 + 13 * i), 100), xi = bspline_greville_q(p, u, i), N[p + 1], height;
        char name[8];
        snprintf(name, sizeof name, "N_%d", i);
        draw_basis_function(s, p, u + i, from_int_q(1), role);
        /* the value in the middle interval, where the label stands */
        num_q middle = mul_q(from_ratio_q(1, 2), add_q(u[i + 1], u[i + 2]));
        int mu = i + 1;
        if (mu >= p && mu < n) {
            bspline_basis_q(p, u, mu, middle, N);
            height = N[i - mu + p];
            svg_label(s, (svg_point){middle, height}, SVG_N, role, name);
        } else {
            svg_label(s, (svg_point){middle, from_ratio_q(i == 0 ? 32 : 39, 50)}, SVG_N, role, name);
        }
        svg_segment(s, (svg_point){u[i], level}, (svg_point){u[i + p + 1], level}, role);
        svg_mark(s, (svg_point){xi, level}, role, SVG_RING);
    }
    return s;
}

FIGURE(bspline_multiple_knot)
{
    enum { p = 3 };
    svg *s =
        svg_new("bspline_multiple_knot", "B-splines at a multiple knot",
                "The cubic B-splines over clamped knots with an inner knot of multiplicity 1, 2, 3: with every further "
                "coincidence the functions that see all of it lose one derivative there.");
    for (int m = 1; m <= p; m++) {
        int n = p + 1 + m;
        num_q u[MOST_DRAWN], c[MOST_DRAWN];
        char words[96];
        static const char *const what[] = {"", "second derivatives agree", "first derivatives agree", "values agree"};
        for (int i = 0; i < n + p + 1; i++)
            u[i] = from_int_q(i <= p ? 0 : i <= p + m ? 2 : 4);
        snprintf(words, sizeof words, "$m = %d$: %s", m, what[m]);
        svg_panel(s, svg_integer_window(0, 0, 4, 1), 230, 190, words);
        svg_axes(s, from_int_q(2), from_ratio_q(1, 2), "t", NULL);
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++)
                c[j] = from_int_q(i == j);
            draw_spline_function(s, n, p, u, c, i == p ? SVG_CURVE : i % 2 == 0 ? SVG_POLYGON : SVG_CURVE_2);
        }
        svg_segment(s, svg_at(2, 0), svg_at(2, 1), SVG_MUTED);
    }
    svg_legend_line(s, SVG_CURVE, "$N_3$");
    return s;
}

/* The same knots; four sites each, of which one set leaves a B-spline without its site. */
FIGURE(schoenberg_whitney)
{
    enum { p = 2, n = 4 };
    static const int knot[n + p + 1] = {0, 0, 0, 2, 4, 4, 4}, site[2][n] = {{1, 5, 11, 15}, {9, 11, 13, 15}};
    num_q u[n + p + 1], c[n];
    integers(n + p + 1, knot, u);
    svg *s = svg_new("schoenberg_whitney", "Sites at which interpolation is possible",
                     "Four quadratic B-splines; on the left each is positive at its site, on the right the first one "
                     "vanishes at its.");
    for (int k = 0; k < 2; k++) {
        svg_panel(s, svg_integer_window(0, 0, 4, 1), 320, 200,
                  k == 0 ? "$N_i(x_i) > 0$ for all $i$:\none solution for any values"
                         : "$N_0(x_0) = 0$: the determinant is 0");
        svg_heading(s, k == 0 ? SVG_RIGHT : SVG_WRONG, k == 0 ? "solvable" : "not solvable");
        svg_axes(s, from_int_q(2), from_ratio_q(1, 2), "t", NULL);
        for (int i = 0; i < n; i++) {
            num_q x = from_ratio_q(site[k][i], 4);
            for (int j = 0; j < n; j++)
                c[j] = from_int_q(i == j);
            enum svg_role role = i % 2 == 0 ? SVG_CURVE : SVG_CURVE_2;
            char name[8];
            snprintf(name, sizeof name, "x_%d", i);
            draw_spline_function(s, n, p, u, c, role);
            num_q height = spline_value(n, p, u, c, x);
            svg_segment(s, (svg_point){x, from_int_q(0)}, (svg_point){x, height}, SVG_MUTED);
            svg_mark(s, (svg_point){x, height}, is_zero_q(height) ? SVG_WRONG : role, SVG_USUAL);
            svg_label(s, (svg_point){x, height},
                      i == 0 && k == 0 ? SVG_NE
                      : i == 3         ? SVG_NW
                                       : SVG_N,
                      is_zero_q(height) ? SVG_WRONG : role, name);
        }
    }
    return s;
}
