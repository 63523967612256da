/* Figures of the section on the shapes of a cubic. */
#include "chapters/foundations/figures.h"
#include "exact/record/number.h"

/* D, C, B, A of the cubic of the triangle (0,0), M, (1,0) with M = (1/2, height) and the lengths alpha, beta. */
static void cubic_of_triangle(num_q height, num_q alpha, num_q beta, num_q c[])
{
    num_q half = r(1, 2), two = q(2), V[4];
    V[0] = mul_q(mul_q(two, alpha), half);
    V[1] = mul_q(mul_q(two, alpha), height);
    V[2] = mul_q(mul_q(two, beta), half);
    V[3] = neg_q(mul_q(mul_q(two, beta), height));
    for (int j = 0; j < 2; j++) {
        num_q edge = q(j == 0);
        c[j] = q(0);
        c[2 + j] = V[j];
        c[4 + j] = sub_q(mul_q(q(3), edge), add_q(add_q(V[j], V[j]), V[2 + j]));
        c[6 + j] = sub_q(add_q(V[j], V[2 + j]), add_q(edge, edge));
    }
}

FIGURE(lengths_of_the_tangents)
{
    svg *s = svg_new("lengths_of_the_tangents", "The lengths of the tangents change the shape",
                     "Cubics with the same ends and the same directions of the tangents, and with tangents of five "
                     "lengths; the parabola "
                     "is one of them.  The tangents of the longest are drawn.");
    svg_panel(s, window(r(-1, 5), r(-1, 10), r(6, 5), r(9, 10)), 480, 0, "$\\α=\\β=1/2, 1, 3/2, 2, 3$");
    for (int k = 0; k < 5; k++) {
        static const int halves[5] = {1, 2, 3, 4, 6};
        num_q c[8], length = r(halves[k], 2);
        cubic_of_triangle(r(3, 5), length, length, c);
        put_power_curve(s, 3, c, q(0), q(1), k == 1 ? SVG_CURVE_2 : k == 4 ? SVG_CURVE : SVG_FAMILY);
    }
    svg_polyline(s, 3, (num_q[]){q(0), q(0), r(1, 2), r(3, 5), q(1), q(0)}, SVG_MUTED);
    static const char *const names[3] = {"Q_0", "M", "Q_1"};
    for (int k = 0; k < 3; k++) {
        svg_point P = at(r(k, 2), k == 1 ? r(3, 5) : q(0));
        svg_mark(s, P, SVG_POINT, SVG_USUAL);
        svg_label(s, P, k == 0 ? SVG_W : k == 1 ? SVG_S : SVG_E, SVG_POINT, names[k]);
    }
    svg_legend_line(s, SVG_CURVE_2, "$α=β=1$, a parabola");
    svg_legend_line(s, SVG_CURVE, "$α=β=3$, a cusp");
    svg_legend_line(s, SVG_FAMILY, "other lengths");
    return s;
}

FIGURE(exchanged_lengths)
{
    svg *s = svg_new("exchanged_lengths", "Two lengths exchanged: the same shape",
                     "A cubic with the tangents (1, 1) and (2, 2) at its ends, and one with (2, 2) and (1, 1): each is "
                     "the other, turned by two right angles about the middle of the chord.");
    static const int coefficients[2][8] = {{0, 0, 1, 1, -1, -4, 1, 3}, {0, 0, 2, 2, -2, -5, 1, 3}};
    static const enum svg_role roles[2] = {SVG_CURVE, SVG_CURVE_2};
    svg_panel(s, window(r(-1, 10), r(-3, 10), r(11, 10), r(3, 10)), 480, 0, "");
    svg_segment(s, svg_at(0, 0), svg_at(1, 0), SVG_MUTED);
    for (int k = 0; k < 2; k++) {
        num_q c[8];
        integers(8, coefficients[k], c);
        put_power_curve(s, 3, c, q(0), q(1), roles[k]);
        svg_mark(s, svg_at(k, 0), SVG_POINT, SVG_USUAL);
        svg_label(s, svg_at(k, 0), k ? SVG_E : SVG_W, SVG_POINT, k ? "Q_1" : "Q_0");
    }
    svg_mark(s, at(r(1, 2), q(0)), SVG_MUTED, SVG_USUAL);
    svg_legend_line(s, SVG_CURVE, "tangents $(1,1)$, $(2,2)$");
    svg_legend_line(s, SVG_CURVE_2, "tangents $(2,2)$, $(1,1)$");
    return s;
}

/* The turning at the ends, up to a positive factor, and the cusps: 3 - 2y, 3 - 2x, (x-2)(y-2) - 1. */
static num_q one_inflection(svg_point P, const void *data)
{
    (void)data;
    return neg_q(mul_q(sub_q(q(3), mul_q(q(2), P.x)), sub_q(q(3), mul_q(q(2), P.y))));
}
static num_q branch(svg_point P, const void *data)
{
    (void)data;
    return sub_q(mul_q(sub_q(P.x, q(2)), sub_q(P.y, q(2))), q(1));
}
static num_q loop(svg_point P, const void *data)
{
    num_q value = branch(P, data);
    return compare_q(P.x, q(2)) > 0 ? value : neg_q(mul_q(value, value));
}
static num_q cusp(svg_point P, const void *data) { return compare_q(P.x, q(2)) > 0 ? branch(P, data) : q(-1); }

FIGURE(forms_of_a_cubic)
{
    svg *s = svg_new(
        "forms_of_a_cubic", "What a cubic does, by the lengths of its tangents",
        "The plane of the lengths alpha and beta of the tangents, in units in which 1, 1 is the parabola.  Below 3/2 "
        "in both "
        "no inflection; one above and one below, one inflection; both above, two inflections until the branch of the "
        "hyperbola (alpha-2)(beta-2)=1 of the cusps, and a loop beyond it.  Beside it a curve of every part.");
    svg_panel(s, window(q(0), q(0), q(5), q(5)), 360, 0, "the plane of the lengths");
    svg_axes(s, q(1), q(1), "α", "β");
    svg_region(s, one_inflection, NULL, 100, SVG_FILL);
    svg_region(s, loop, NULL, 100, SVG_RIGHT);
    svg_segment(s, at(r(3, 2), q(0)), at(r(3, 2), q(5)), SVG_MUTED);
    svg_segment(s, at(q(0), r(3, 2)), at(q(5), r(3, 2)), SVG_MUTED);
    svg_implicit(s, cusp, NULL, 100, SVG_WRONG);
    svg_mark(s, svg_at(1, 1), SVG_POINT, SVG_USUAL);
    svg_note(s, svg_at(1, 1), SVG_NW, SVG_POINT, "parabola");
    static const int lengths[5][2] = {{1, 1}, {1, 3}, {2, 2}, {3, 3}, {4, 4}};
    static const char *const places[5] = {"0", "1", "2", "cusp", "loop"};
    svg_note(s, at(r(3, 4), r(1, 4)), SVG_HERE, SVG_POINT, "none");
    svg_note(s, at(r(3, 4), q(3)), SVG_HERE, SVG_POINT, "one");
    svg_note(s, at(q(3), r(3, 4)), SVG_HERE, SVG_POINT, "one");
    svg_note(s, at(q(2), q(2)), SVG_HERE, SVG_POINT, "two");
    svg_note(s, at(q(4), q(4)), SVG_HERE, SVG_POINT, "loop");
    svg_panel(s, window(r(-1, 4), r(-1, 8), r(5, 4), r(27, 8)), 260, 360, "$(α,β)=(1,1),(1,3),(2,2),(3,3),(4,4)$");
    for (int k = 0; k < 5; k++) {
        num_q c[8];
        cubic_of_triangle(r(1, 3), q(lengths[k][0]), q(lengths[k][1]), c);
        c[1] = k < 3 ? r(30 - 4 * k, 10) : r(54 - 13 * k, 10);
        put_power_curve(s, 3, c, q(0), q(1), SVG_CURVE);
        svg_note(s, at(q(1), c[1]), SVG_E, SVG_POINT, places[k]);
    }
    svg_legend_area(s, SVG_FILL, "one inflection");
    svg_legend_area(s, SVG_RIGHT, "a loop");
    svg_legend_line(s, SVG_WRONG, "cusps");
    return s;
}

/* (t, torsion) and the printed quotient of (3t, 3t^2, 2t^3): 2/(3(1+2t^2)^2), and with the third power of the speed. */
static svg_point torsion_at(num_q t, const void *data)
{
    num_q c[12], D[12];
    for (int k = 0; k <= 3; k++)
        for (int j = 0; j < 3; j++)
            c[3 * k + j] = q(k == j + 1 ? (j == 2 ? 2 : 3) : 0);
    power_derivatives_q(3, 3, c, t, 3, D);
    num_q value = torsion_q(D + 3, D + 6, D + 9), speed = add_q(q(3), mul_q(q(6), mul_q(t, t)));
    if (data != NULL)
        value = mul_q(value, mul_q(speed, mul_q(speed, speed)));
    return at(t, value);
}

FIGURE(torsion_and_the_speed)
{
    static const int printed = 1;
    svg *s = svg_new("torsion_and_the_speed", "The torsion, and the quotient with the third power of the speed",
                     "The twisted cubic (3t, 3t squared, 2t cubed) on [0, 1]: its torsion falls from 2/3 to 2/27, the "
                     "printed quotient "
                     "with the third power of the speed rises from 18 to 54.");
    svg_panel(s, window(q(0), q(0), q(1), q(1)), 240, 240, "the torsion");
    svg_axes(s, r(1, 2), r(1, 2), "t", "τ");
    svg_plot(s, torsion_at, NULL, q(0), q(1), 48, SVG_RIGHT);
    svg_panel(s, window(q(0), q(0), q(1), q(60)), 240, 240, "the printed quotient");
    svg_axes(s, r(1, 2), q(20), "t", NULL);
    svg_plot(s, torsion_at, &printed, q(0), q(1), 48, SVG_WRONG);
    svg_legend_line(s, SVG_RIGHT, "below $s'^6K^2$");
    svg_legend_line(s, SVG_WRONG, "below $s'^3K^2$");
    return s;
}

/* (t, K) of (3t, 3t^2, 2t^3) with the speed 3 + 6t^2 below, or, as printed, with the length 3t + 2t^3. */
static svg_point curvature_at(num_q t, const void *data)
{
    num_q tt = mul_q(t, t), top = mul_q(q(18), add_q(q(1), mul_q(q(2), tt)));
    num_q below = data != NULL ? mul_q(t, add_q(q(3), mul_q(q(2), tt))) : add_q(q(3), mul_q(q(6), tt));
    return at(t, div_q(top, mul_q(below, mul_q(below, below))));
}

FIGURE(curvature_and_the_speed)
{
    static const int printed = 1;
    svg *s =
        svg_new("curvature_and_the_speed", "The curvature, and the quotient with the length of the arc",
                "The twisted cubic (3t, 3t squared, 2t cubed) on [0, 1]: its curvature falls from 2/3 to 2/27.  The "
                "printed quotient, with the length of the arc from t = 0 in the place of the speed, falls from "
                "infinity to 54/125.");
    svg_panel(s, window(q(0), q(0), q(1), q(2)), 420, 260, NULL);
    svg_axes(s, r(1, 4), r(1, 2), "t", "K");
    svg_plot(s, curvature_at, NULL, q(0), q(1), 48, SVG_RIGHT);
    svg_plot(s, curvature_at, &printed, r(1, 4), q(1), 48, SVG_WRONG);
    svg_mark(s, at(q(1), r(2, 27)), SVG_RIGHT, SVG_USUAL);
    svg_label(s, at(q(1), r(2, 27)), SVG_N, SVG_RIGHT, "2/27");
    svg_mark(s, at(q(1), r(54, 125)), SVG_WRONG, SVG_USUAL);
    svg_label(s, at(q(1), r(54, 125)), SVG_E, SVG_WRONG, "54/125");
    svg_legend_line(s, SVG_RIGHT, "with the speed");
    svg_legend_line(s, SVG_WRONG, "with the length of the arc");
    return s;
}

FIGURE(ends_with_lost_letters)
{
    svg *s = svg_new("ends_with_lost_letters", "The coefficients of a cubic with points that have got dots",
                     "The data 0 and 1 with the tangents 1 belong to the straight graph.  With the printed A the curve "
                     "ends at 3, with the printed B at -2, and with the printed D it begins at 1.");
    static const int coefficients[4][4] = {{0, 1, 0, 0}, {0, 1, 0, 2}, {0, 1, -3, 0}, {1, 1, 0, 0}};
    svg_panel(s, window(r(-1, 8), r(-9, 4), r(9, 8), r(13, 4)), 280, 320, "$Q_0=0$, $Q_1=1$, both tangents 1");
    svg_axes(s, q(1), q(1), "t", NULL);
    for (int k = 3; k >= 0; k--) {
        num_q c[8];
        for (int m = 0; m < 4; m++)
            c[2 * m] = q(m == 1), c[2 * m + 1] = q(coefficients[k][m]);
        put_power_curve(s, 3, c, q(0), q(1), k ? SVG_WRONG : SVG_RIGHT);
    }
    svg_mark(s, svg_at(0, 0), SVG_POINT, SVG_USUAL);
    svg_mark(s, svg_at(1, 1), SVG_POINT, SVG_USUAL);
    svg_label(s, svg_at(0, 0), SVG_SW, SVG_POINT, "Q_0");
    svg_label(s, svg_at(1, 1), SVG_E, SVG_POINT, "Q_1");
    static const int ends[3][2] = {{1, 3}, {1, -2}, {0, 1}};
    static const char *const names[3] = {"A", "B", "D"};
    for (int k = 0; k < 3; k++) {
        svg_mark(s, svg_at(ends[k][0], ends[k][1]), SVG_WRONG, SVG_USUAL);
        svg_label(s, svg_at(ends[k][0], ends[k][1]), k == 2 ? SVG_W : SVG_E, SVG_WRONG, names[k]);
    }
    svg_legend_line(s, SVG_RIGHT, "corrected");
    svg_legend_line(s, SVG_WRONG, "$A$, $B$ or $D$ as printed");
    return s;
}

/* (t, torsion) of (t, t^2, t^3): 12 over the square of the vector product. */
static svg_point torsion_of_powers(num_q t, const void *data)
{
    num_q tt = mul_q(t, t), square = mul_q(q(36), mul_q(tt, tt));
    (void)data;
    return at(t, div_q(q(12), add_q(square, add_q(mul_q(q(36), tt), q(4)))));
}

FIGURE(derivatives_with_lost_dots)
{
    svg *s =
        svg_new("derivatives_with_lost_dots", "A second derivative in the place of the third",
                "Left the second derivative of t squared, which is 2, and 6A, which is 0.  Right the torsion of (t, "
                "t squared, t cubed), which is 3 at t = 0, and the quotient with the second derivative twice, which "
                "is 0 everywhere.");
    for (int panel = 0; panel < 2; panel++) {
        svg_panel(s, window(q(0), r(-1, 4), q(1), q(panel ? 3 : 2)), 240, 220, panel ? "the torsion" : "$P(t)=t^2$");
        svg_axes(s, q(1), q(1), "t", NULL);
        if (panel)
            svg_plot(s, torsion_of_powers, NULL, q(0), q(1), 48, SVG_RIGHT);
        else
            svg_segment(s, svg_at(0, 2), svg_at(1, 2), SVG_RIGHT);
        svg_segment(s, svg_at(0, 0), svg_at(1, 0), SVG_WRONG);
    }
    svg_legend_line(s, SVG_RIGHT, "$P''$, and the torsion");
    svg_legend_line(s, SVG_WRONG, "$6A$, and twice $P''$");
    return s;
}

FIGURE(determinants_of_the_derivatives)
{
    svg *s =
        svg_new("determinants_of_the_derivatives", "The determinant of the three derivatives, and two misprints",
                "For A = (1,0,1), B = (0,1,0), C = (0,0,1) the determinant is -12 for every t.  With t in the place "
                "of t squared in one entry it is 36(t squared - t) - 12, and with two equal rows it is 0.");
    svg_panel(s, window(q(0), q(-24), q(2), q(60)), 420, 260, NULL);
    svg_axes(s, r(1, 2), q(20), "t", NULL);
    const int coefficients[6] = {0, -12, 1, -36, 0, 36};
    num_q c[6];
    integers(6, coefficients, c);
    put_power_curve(s, 2, c, q(0), q(2), SVG_WRONG);
    svg_segment(s, svg_at(0, 0), svg_at(2, 0), SVG_CURVE_2);
    svg_segment(s, svg_at(0, -12), svg_at(2, -12), SVG_RIGHT);
    svg_mark(s, svg_at(2, 60), SVG_WRONG, SVG_USUAL);
    svg_label(s, svg_at(2, 60), SVG_W, SVG_WRONG, "60");
    svg_legend_line(s, SVG_RIGHT, "$-12(A,B,C)$");
    svg_legend_line(s, SVG_WRONG, "with the printed entry");
    svg_legend_line(s, SVG_CURVE_2, "with two equal rows");
    return s;
}

/* x to the right, y to the back, z upwards. */
static void project(const num_q X[], num_q out[])
{
    out[0] = add_q(X[0], mul_q(r(2, 5), X[1]));
    out[1] = add_q(X[2], mul_q(r(1, 4), X[1]));
}

/* The cubic with the coefficients D, C, B, A in space, t from -1 to 1. */
static void put_space_cubic(svg *s, const num_q c[], enum svg_role role)
{
    num_q seen[8];
    for (int k = 0; k < 4; k++)
        project(c + 3 * k, seen + 2 * k);
    put_power_curve(s, 3, seen, q(-1), q(1), role);
}

FIGURE(plane_cubics)
{
    svg *s =
        svg_new("plane_cubics", "A cubic in a plane, and one in none",
                "Left, the cubic (t, t³, (t + t³)/2), whose determinant (A, B, C) is 0, in the shaded plane.  Right, "
                "the cubic (t, t², t³) with the determinant -1, and its shadow in the plane of its tangent and its "
                "second derivative at t = 0: it passes through this plane.");
    for (int twisted = 0; twisted <= 1; twisted++) {
        num_q c[12], shadow[12], corner[8];
        for (int m = 0; m < 12; m++)
            c[m] = q(0);
        c[3] = q(1); /* C */
        if (twisted) {
            c[7] = c[11] = q(1); /* B, A */
        } else {
            c[5] = c[11] = r(1, 2);
            c[10] = q(1);
        }
        for (int m = 0; m < 12; m++)
            shadow[m] = m % 3 == 2 ? q(0) : c[m];
        for (int k = 0; k < 4; k++) {
            num_q x = q(k == 1 || k == 2 ? 1 : -1), y = q(k < 2 ? -1 : 1);
            project((num_q[]){x, y, twisted ? q(0) : div_q(add_q(x, y), q(2))}, corner + 2 * k);
        }
        svg_panel(s, window(r(-3, 2), r(-3, 2), r(3, 2), r(3, 2)), 300, 0,
                  twisted ? "$(t,t^2,t^3)$: $(A,B,C)=-1$" : "$(t,t^3,(t+t^3)/2)$: $(A,B,C)=0$");
        svg_area(s, 4, corner, SVG_FILL);
        if (twisted)
            put_space_cubic(s, shadow, SVG_MUTED);
        put_space_cubic(s, c, SVG_CURVE);
    }
    svg_legend_line(s, SVG_CURVE, "the cubic");
    svg_legend_area(s, SVG_FILL, "a plane");
    svg_legend_line(s, SVG_MUTED, "its shadow");
    return s;
}
