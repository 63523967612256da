/* The figure of the page on the table of contents. */
#include "chapters/foundations/figures.h"
#include "chapters/foundations/pages.h"

FIGURE(pages_of_the_sections)
{
    svg *s = svg_new("pages_of_the_sections", "The pages of the sections of chapters 1, 2 and 9",
                     "The pages on which the sections begin, in their order.  For section 9-2 a page behind that of "
                     "section 9-3 is printed, for chapter 2 a page before that of its first section.");
    num_q P[2 * 19], Q[2 * 7];
    int count = 0;
    for (int c = 0; c < 2; c++)
        for (int k = 0; section_page[c][k] != 0; k++, count++)
            P[2 * count] = q(count + 1), P[2 * count + 1] = q(section_page[c][k]);
    for (int k = 0; k < 7; k++)
        Q[2 * k] = q(k + 1), Q[2 * k + 1] = q(section_page[CHAPTERS - 1][k]);
    svg_panel(s, window(q(0), q(0), q(20), q(56)), 340, 260, "sections 1-1 to 1-9 and 2-1 to 2-10");
    svg_axes(s, q(0), q(10), NULL, "page");
    svg_polyline(s, 19, P, SVG_MUTED);
    for (int k = 0; k < 19; k++)
        svg_mark(s, svg_pair(P + 2 * k), k < 9 ? SVG_CURVE : SVG_CURVE_2, SVG_USUAL);
    svg_mark(s, svg_at(10, 23), SVG_WRONG, SVG_USUAL);
    svg_note(s, svg_at(10, 23), SVG_SE, SVG_WRONG, "chapter 2: page 23");
    svg_note(s, svg_at(10, 25), SVG_NW, SVG_CURVE_2, "2-1: page 25");
    svg_panel(s, window(q(0), q(222), q(8), q(250)), 260, 260, "sections 9-1 to 9-7");
    svg_axes(s, q(0), q(5), NULL, "page");
    svg_polyline(s, 7, Q, SVG_MUTED);
    for (int k = 0; k < 7; k++)
        svg_mark(s, svg_pair(Q + 2 * k), k == 1 ? SVG_WRONG : SVG_CURVE, SVG_USUAL);
    svg_note(s, svg_pair(Q + 2), SVG_N, SVG_WRONG, "9-2: page 237");
    svg_note(s, svg_pair(Q + 4), SVG_SE, SVG_CURVE, "9-3: page 234");
    return s;
}
