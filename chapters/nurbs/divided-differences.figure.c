/* divided-differences.figure.c -- drawings for divided-differences.claims.h. */
#include "chapters/nurbs/matrix-figures.h"

/* The printed matrix of (4.4.6): only the last entry of the last row of each node is another one. */
FIGURE(confluent_row)
{
    static const int l[2] = {2, 2};
    num_q tau[2] = {q(1), q(2)}, H[16], printed[16];
    svg *s =
        svg_new("confluent_row", "The last row of each node",
                "Two matrices of the osculation at two double nodes, 1 and 2.  In the right one the last entries of "
                "the rows of derivatives are 3 and 12; in the printed one they are 6 and 24.");
    confluent_vandermonde_q(2, l, tau, H);
    for (int m = 0; m < 16; m++)
        printed[m] = H[m];
    for (int i = 0; i < 2; i++) /* k!/(k-l-1)! tau^(k-l+1) with k = 3, l = 2 */
        printed[(2 * i + 1) * 4 + 3] = mul_q(q(6), mul_q(tau[i], tau[i]));
    put_matrix(s, 4, printed, 62, "printed: $k!/(k-l_i-1)!$ in the last column\nof the second and of the fourth row");
    svg_heading(s, SVG_WRONG, "$3!/0! \\ τ_i^2$");
    put_matrix(s, 4, H, 62, "rows: $1,t,t^2,t^3$ and their derivatives\nat $τ_1=1$ and at $τ_2=2$");
    svg_heading(s, SVG_RIGHT, "$3!/2! \\ τ_i^2$");
    return s;
}

static svg_point bell(num_q t, const void *data)
{
    (void)data;
    return at(t, div_q(q(2), add_q(q(1), mul_q(t, t))));
}

/* The polynomial of degree 4 that osculates 2/(1+t^2) at -1 twice, at 1/2, and at 2 twice. */
FIGURE(osculating_polynomial)
{
    enum { d = 3, k = 4 };
    static const int l[d] = {2, 1, 2};
    num_q tau[d] = {q(-1), r(1, 2), q(2)}, c[k + 1], f[k + 1], rest[k + 1];
    svg *s =
        svg_new("osculating_polynomial", "The divided difference is a leading coefficient",
                "The function 2/(1+t²) and the polynomial of degree 4 that has its values at -1, 1/2 and 2 and its "
                "derivatives at -1 and at 2.  The leading coefficient of the polynomial is the divided difference.");
    for (int i = 0, row = 0; i < d; i++) {
        num_q below = add_q(q(1), mul_q(tau[i], tau[i]));
        f[row++] = div_q(q(2), below);
        if (l[i] == 2)
            f[row++] = div_q(mul_q(q(-4), tau[i]), mul_q(below, below));
    }
    /* From the highest coefficient down: each is a divided difference over the first nodes of what is left. */
    static const int nodes[k + 1][d] = {{1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 1, 1}, {2, 1, 2}};
    for (int j = k; j >= 0; j--) {
        int used = nodes[j][1] == 0 ? 1 : nodes[j][2] == 0 ? 2 : 3;
        for (int i = 0, row = 0, mine = 0; i < d; i++)
            for (int m = 0; m < l[i]; m++, row++) {
                num_q value = f[row];
                for (int a = j + 1; a <= k; a++) {
                    num_q term = m == 0 ? q(1) : q(a);
                    for (int b = 0; b < a - m; b++)
                        term = mul_q(term, tau[i]);
                    value = sub_q(value, mul_q(c[a], term));
                }
                if (m < nodes[j][i])
                    rest[mine++] = value;
            }
        c[j] = divided_difference_q(used, nodes[j], tau, rest);
    }
    svg_panel(s, window(r(-7, 4), r(-1, 2), r(11, 4), r(11, 4)), 420, 0, "$c_4=[-1,-1,1/2,2,2]f$");
    svg_axes(s, q(1), q(1), "t", NULL);
    svg_plot(s, bell, NULL, r(-7, 4), r(11, 4), 24, SVG_CURVE_2);
    num_q moved[k + 1]; /* the same in powers of u = (t-a)/(b-a), a = -7/4, b = 11/4 */
    for (int j = 0; j <= k; j++) {
        moved[j] = q(0);
        for (int a = j; a <= k; a++) {
            num_q term = mul_q(q(binomial(a, j)), c[a]);
            for (int b = 0; b < a; b++)
                term = mul_q(term, b < j ? r(9, 2) : r(-7, 4));
            moved[j] = add_q(moved[j], term);
        }
    }
    put_polynomial(s, k, moved, r(-7, 4), r(11, 4), SVG_CURVE);
    for (int i = 0; i < d; i++) {
        svg_mark(s, bell(tau[i], NULL), SVG_POINT, l[i] == 2 ? SVG_DISC : SVG_RING);
        svg_label(s, bell(tau[i], NULL), i == 0 ? SVG_NW : SVG_NE, SVG_POINT, i == 0 ? "τ_1" : i == 1 ? "τ_2" : "τ_3");
    }
    svg_frame(s);
    svg_legend_line(s, SVG_CURVE_2, "$f(t)=2/(1+t^2)$");
    svg_legend_line(s, SVG_CURVE, "the polynomial of degree 4");
    svg_legend_mark(s, SVG_POINT, SVG_DISC, "double node");
    svg_legend_mark(s, SVG_POINT, SVG_RING, "simple node");
    return s;
}
