/* picture.h -- what the parts of the picture of a fit share: a view, two coordinates of points and curve in one scale. */
#ifndef CAGD_CLI_FIT_PICTURE_H
#define CAGD_CLI_FIT_PICTURE_H

#include "cli/fit/fit.h"
#include "figures/svg.h"

/* An interval of the line, and the step of its ticks; from 10^exponent times what the numbers are. */
struct scale {
    double low, high;
    num_q step;
};

struct view {
    const struct fit *f;
    int a, b;          /* the coordinates that are shown        */
    double base[2];    /* what is subtracted from them          */
    int power;         /* and what is left is divided by 10^power */
    struct scale x, y; /* in numbers as shown                   */
};

/* Where a control point that the window does not show is marked. */
struct beyond {
    double at[2];        /* on the border, in numbers as shown                  */
    double direction[2]; /* from there to the point, of the window's longer side */
};

/* ---- view.c ------------------------------------------------------------------------------------------ */

/* The power of ten by which numbers of this size are divided to be read without many zeros. */
int power_of(double size);
/* x 10^-e exactly, x a binary64. */
num_q scaled(double x, int e);

/* Coordinates a and b: points and feet; and the control points unless the window would become more than twice as large.  In the shape of a panel of
 * that width. */
struct view view_of(const struct fit *f, int a, int b, int width);

/* A length; the point with these coordinates from the origin, NULL: from 0; control point j, and whether the window shows it. */
num_q shown(const struct view *v, double x);
svg_point shown_from(const struct view *v, const double origin[], const double P[]);
svg_point control_point(const struct view *v, int j);
int inside(const struct view *v, int j);
/* Whether there are control points that it does not show. */
int any_beyond(const struct view *v);

/* The ray to control point j from the middle of its neighbours that are shown, or of the window, and where it leaves the window. */
struct beyond beyond_border(const struct view *v, int j);

/* ---- polygon.c --------------------------------------------------------------------------------------- */

/* The control polygon, with names where there are few points: they stand over no point and no line. */
void draw_polygon(svg *s, const struct view *v);
#endif
