#include "chapters/judge/figure.h"
#include "exact/kernels_q.h"
#include "figures/svg.h"

enum { QUARTIC = 4 };

static void quartic(num_q b[])
{
    static const int at[] = {0, 0, 1, 7, 6, -3, 7, 8, 12, 3};
    for (int m = 0; m < 2 * (QUARTIC + 1); m++)
        b[m] = from_int_q(at[m]);
}

static svg_window standard_window(void) { return svg_integer_window(-1, -4, 13, 9); }

/* The polygons of the 2^depth parts. */
static void halves(svg *s, const num_q b[], int depth, enum svg_role role)
{
    num_q left[2 * (QUARTIC + 1)], right[2 * (QUARTIC + 1)];
    if (depth == 0) {
        svg_polyline(s, QUARTIC + 1, b, role);
        for (int i = 0; i <= QUARTIC; i++)
            svg_mark(s, svg_pair(b + 2 * i), role, SVG_USUAL);
        return;
    }
    bezier_split_q(QUARTIC, 2, b, from_ratio_q(1, 2), left, right);
    halves(s, left, depth - 1, role);
    halves(s, right, depth - 1, role);
}

FIGURE(polygons_converge)
{
    num_q b[2 * (QUARTIC + 1)], e[2][2 * (MAX_DEGREE + 2)];
    svg *s = svg_new(
        "polygons_converge", "Elevation and subdivision",
        "Left: the polygons of a quartic in the degrees 4, 6, 10 and 20. Right: its polygon and those of its halves "
        "and quarters. Both tend to the curve, the second much faster.");
    quartic(b);
    svg_panel(s, standard_window(), 330, 0, "elevated to the degrees $N=6,10,20$:\ndistance of order $1/N$");
    for (int m = 0; m < 2 * (QUARTIC + 1); m++)
        e[0][m] = b[m];
    svg_bezier(s, QUARTIC, b, SVG_CURVE);
    svg_polyline(s, QUARTIC + 1, b, SVG_POLYGON);
    for (int i = 0; i <= QUARTIC; i++)
        svg_mark(s, svg_pair(b + 2 * i), SVG_POLYGON, SVG_USUAL);
    for (int N = QUARTIC, now = 0; N < 20; N++, now = 1 - now) {
        bezier_elevate_q(N, 2, e[now], e[1 - now]);
        if (N + 1 == 6 || N + 1 == 10 || N + 1 == 20) {
            svg_polyline(s, N + 2, e[1 - now], SVG_FAMILY);
            for (int i = 0; i <= N + 1; i++)
                svg_mark(s, svg_pair(e[1 - now] + 2 * i), SVG_FAMILY, SVG_USUAL);
        }
    }
    svg_panel(s, standard_window(), 330, 0, "split in halves and in quarters:\neach step divides the bound by 4");
    svg_bezier(s, QUARTIC, b, SVG_CURVE);
    halves(s, b, 0, SVG_POLYGON);
    halves(s, b, 1, SVG_FAMILY);
    halves(s, b, 2, SVG_FAMILY);
    return s;
}
