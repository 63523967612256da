#include "chapters/judge/figure.h"
#include "exact/kernels_q.h"
#include "exact/record/crossings.h"
#include "figures/svg.h"

#include <stdio.h>

/* Two lines cross the polygon three times each; the curve, three times and once. */
FIGURE(line_and_polygon)
{
    enum { n = 3 };
    static const int at[] = {0, 0, 2, 8, 8, -5, 10, 3};
    num_q b[2 * (n + 1)], w[n + 1];
    svg *s =
        svg_new("line_and_polygon", "A line crosses the curve no more often than the polygon",
                "A cubic and its polygon, with two lines that cross the polygon three times each; one of them crosses "
                "the curve three times, the other once.");
    for (int m = 0; m < 2 * (n + 1); m++)
        b[m] = from_int_q(at[m]);
    for (int i = 0; i <= n; i++)
        w[i] = from_int_q(1);
    static const int through[2][2] = {{1, 2}, {6, -3}}; /* the ordinates of the line at x = 0 and x = 10 */
    for (int k = 0; k < 2; k++) {
        num_q slope = from_ratio_q(through[k][1] - through[k][0], 10), shift = from_int_q(through[k][0]);
        struct cagd_line line = {slope, from_int_q(-1), shift};
        char words[160];
        snprintf(words, sizeof words, "crossings of the line with the polygon: %d,\nwith the curve: %d",
                 polygon_crossings(n, b, line), curve_meets_line(n, b, w, line).crossings);
        svg_panel(s, svg_integer_window(-1, -6, 11, 9), 320, 0, words);
        svg_bezier(s, n, b, SVG_CURVE);
        svg_control_polygon(s, n, b, "b");
        svg_line(s, (svg_point){from_int_q(0), shift}, svg_at(10, through[k][1]), SVG_RIGHT);
    }
    return s;
}
