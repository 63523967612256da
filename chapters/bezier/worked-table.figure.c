/* Figures of the section on the worked table. */
#include "chapters/judge/figure.h"
#include "chapters/judge/figure_data.h"
#include "figures/words.h"

#include <stdio.h>

/* The claims that have in their data what is printed in a row: the parameter, x, y. */
static const char *const printed_in[7][3] = {
    {"table_row_of_start", "table_row_of_start", "table_row_of_start"},
    {"table_row_of_fifteen_hundredths", "table_misses_the_first_x", "table_row_of_fifteen_hundredths"},
    {"table_row_of_thirty_five_hundredths", "table_misses_the_second_x", "table_misses_the_second_y"},
    {"table_row_of_middle", "table_row_of_middle", "table_row_of_middle"},
    {"table_row_of_sixty_five_hundredths", "table_misses_the_third_x", "table_row_of_sixty_five_hundredths"},
    {"table_row_of_eighty_five_hundredths", "table_misses_the_fourth_x", "table_misses_the_fourth_y"},
    {"table_row_of_end", "table_row_of_end", "table_row_of_end"},
};

FIGURE(worked_table)
{
    svg *s = svg_new("worked_table", "The points of the table and the curve",
                     "The cubic of the example with its points at the seven parameters and the printed points; right, "
                     "how far each printed coordinate is from the exact one, in thousandths.");
    num_q b[8], P[7][2], t[7], printed[7][2];
    data_of(printed_in[0][0], "P", 4, 2, b);
    for (int k = 0; k < 7; k++) {
        data_of(printed_in[k][0], "t", 1, 1, &t[k]);
        data_of(printed_in[k][1], "x", 1, 1, &printed[k][0]);
        data_of(printed_in[k][2], "y", 1, 1, &printed[k][1]);
        bezier_casteljau_q(3, 2, b, t[k], P[k]);
    }
    svg_panel(s, window(r(1, 2), r(1, 2), r(9, 2), r(7, 2)), 380, 0, "the curve of the table");
    svg_control_polygon(s, 3, b, "P");
    svg_bezier(s, 3, b, SVG_CURVE);
    for (int k = 0; k < 7; k++)
        svg_mark(s, svg_pair(printed[k]), SVG_WRONG, SVG_USUAL);
    svg_panel(s, window(r(-1, 4), q(-18), q(7), q(14)), 340, 260, "printed minus exact, in thousandths");
    svg_axes(s, q(0), q(5), "t", NULL);
    for (int k = 0; k < 7; k++) {
        char name[16];
        snprintf(name, sizeof name, "%.4g", cagd_to_double_q(t[k]));
        svg_note(s, at(q(k), q(-16)), SVG_S, SVG_AXIS, name);
        for (int c = 0; c < 2; c++) {
            num_q gap = mul_q(q(1000), sub_q(printed[k][c], P[k][c]));
            num_q x = add_q(q(k), c ? r(1, 8) : r(-1, 8));
            svg_segment(s, at(x, q(0)), at(x, gap), SVG_FAMILY);
            svg_mark(s, at(x, gap), c ? SVG_CURVE_2 : SVG_CURVE, SVG_USUAL);
        }
    }
    svg_legend_mark(s, SVG_WRONG, SVG_USUAL, "printed points");
    svg_legend_mark(s, SVG_CURVE, SVG_USUAL, "error of $x$");
    svg_legend_mark(s, SVG_CURVE_2, SVG_USUAL, "error of $y$");
    return s;
}
