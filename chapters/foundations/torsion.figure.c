/* Figures of the section on torsion. */
#include "chapters/foundations/figures.h"

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
