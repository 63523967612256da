/* The figure of the section on patches from their corners. */
#include "chapters/hermite-coons/drawing.h"

/* Seen obliquely, z drawn twice as high: (x + y/2, 3y/5 + 2z), of the data x, y, z. */
static void project(const num_q P[3], num_q out[2])
{
    out[0] = add_q(P[0], div_q(P[1], q(2)));
    out[1] = add_q(mul_q(r(3, 5), P[1]), mul_q(q(2), P[2]));
}

FIGURE(worked_patch)
{
    svg *s = svg_new("worked_patch", "Two of the readings of the worked patch",
                     "The patch with one of the choices of signs that fit, and with another, in which every derivative "
                     "with respect to w and every twist of x, and the derivatives with respect to w of z, have changed "
                     "their signs.  Heights are drawn twice as large.");
    static const int M[3][16] = {{0, 0, 1, -1, 1, 1, 1, 1, 1, 1, 1, -1, 1, 1, -1, 1},
                                 {0, 1, 1, 1, 0, 1, 1, 1, 1, 1, 1, -1, -1, -1, -1, 1},
                                 {0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, -1, 0, 0, -1, 1}};
    for (int reading = 0; reading < 2; reading++) {
        num_q corners[48];
        for (int i = 0; i < 16; i++)
            for (int c = 0; c < 3; c++) {
                int turned = reading == 1 && i % 4 >= 2 && (c == 0 || (c == 2 && i / 4 < 2));
                corners[3 * i + c] = r((turned ? -3 : 3) * M[c][i], 4);
            }
        svg_panel(s, window(r(-1, 4), r(-1, 4), r(5, 4), r(7, 8)), 340, 0,
                  reading ? "another choice" : "one choice of signs");
        for (int k = 0; k <= 8; k++)
            for (int direction = 0; direction < 2; direction++) {
                num_q data[8], fixed = r(k, 8), P[3];
                for (int m = 0; m < 4; m++) { /* the value at 0 and 1, then the derivative */
                    num_q u = direction ? fixed : q(m % 2), w = direction ? q(m % 2) : fixed;
                    hermite_tensor_q(3, corners, u, w, direction ? 0 : m / 2, direction ? m / 2 : 0, P);
                    project(P, data + 2 * m);
                }
                put_hermite(s, data, k % 8 == 0 ? SVG_CURVE : SVG_FAMILY);
            }
        static const char *const name[4] = {"P_0", "P_1", "P_2", "P_3"};
        static const enum svg_direction beside[2][4] = {{SVG_SW, SVG_NW, SVG_SE, SVG_NE},
                                                        {SVG_SE, SVG_S, SVG_SE, SVG_E}};
        for (int k = 0; k < 4; k++) {
            num_q P[3], seen[2];
            hermite_tensor_q(3, corners, q(k / 2), q(k % 2), 0, 0, P);
            project(P, seen);
            svg_mark(s, svg_pair(seen), SVG_POINT, SVG_USUAL);
            svg_label(s, svg_pair(seen), beside[reading][k], SVG_POINT, name[k]);
        }
    }
    return s;
}
