/* conic-figures.h -- what the drawings of the sections on conics share. */
#ifndef CAGD_CONIC_FIGURES_H
#define CAGD_CONIC_FIGURES_H

#include "chapters/judge/figure.h"
#include "figures/words.h"

/* The legs R_0 R_1 and R_1 R_2 with the three points, labelled on the given sides. */
static inline void put_triangle(svg *s, const num_q R[], enum svg_direction at_0, enum svg_direction at_1,
                                enum svg_direction at_2)
{
    const enum svg_direction side[3] = {at_0, at_1, at_2};
    svg_control_polygon_towards(s, 2, R, "R", side);
}

/* a + share (b - a) */
static inline svg_point between(const num_q a[], const num_q b[], num_q share)
{
    return (svg_point){add_q(a[0], mul_q(share, sub_q(b[0], a[0]))), add_q(a[1], mul_q(share, sub_q(b[1], a[1])))};
}
#endif
