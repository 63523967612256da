/* Figures of the section on the worked table. */
#include "chapters/bezier/printed-table.h"
#include "chapters/judge/figure.h"
#include "figures/words.h"

FIGURE(worked_table)
{
    svg *s = svg_new("worked_table", "The points of the table and the curve",
                     "The cubic of the example with its points at the seven parameters and the printed points; right, "
                     "how far each printed coordinate is from the exact one, in thousandths.");
    num_q b[8], P[2];
    integers(8, printed_points, b);
    svg_panel(s, window(r(1, 2), r(1, 2), r(9, 2), r(7, 2)), 380, 0, "the curve of the table");
    svg_control_polygon(s, 3, b, "P");
    svg_bezier(s, 3, b, SVG_CURVE);
    for (int k = 0; k < 7; k++) {
        decasteljau_q(3, 2, b, from_string_q(printed_table[k].t), P);
        svg_mark(s, svg_pair(P), SVG_CURVE, SVG_USUAL);
        svg_mark(s, at(from_string_q(printed_table[k].point[0]), from_string_q(printed_table[k].point[1])), SVG_WRONG,
                 SVG_USUAL);
    }
    svg_panel(s, window(q(-1), q(-16), q(7), q(12)), 300, 240,
              "printed less exact, in thousandths,\nfor $t=0,0.15,...,1$");
    svg_axes(s, q(0), q(5), NULL, NULL);
    for (int k = 0; k < 7; k++) {
        decasteljau_q(3, 2, b, from_string_q(printed_table[k].t), P);
        for (int c = 0; c < 2; c++) {
            num_q gap = mul_q(q(1000), sub_q(from_string_q(printed_table[k].point[c]), P[c]));
            num_q x = add_q(q(k), c ? r(1, 8) : r(-1, 8));
            svg_segment(s, at(x, q(0)), at(x, gap), SVG_FAMILY);
            svg_mark(s, at(x, gap), c ? SVG_CURVE_2 : SVG_CURVE, SVG_USUAL);
        }
    }
    svg_legend_mark(s, SVG_CURVE, SVG_USUAL, "points of the curve; right, $x$");
    svg_legend_mark(s, SVG_CURVE_2, SVG_USUAL, "right, $y$");
    svg_legend_mark(s, SVG_WRONG, SVG_USUAL, "printed points");
    return s;
}
