/* svg.h -- a canvas for mathematical figures, drawn from exact values.
 *
 * A figure is a row of panels, or several rows.  A panel shows a window of the plane, given in rationals; what is
 * drawn goes to the panel opened last.  Every coordinate is computed exactly and rounded once, to
 * 1/100 of an output unit (half away from zero; one unit is one CSS pixel at natural size), and is
 * printed from that integer: the bytes are the same on every machine.
 *
 *     svg *s = svg_new("parabola", "A parabola", "The parabola y = x² with its control polygon.");
 *     svg_panel(s, svg_integer_window(-2, -2, 2, 2), 360, 0, NULL);
 *     num_q one = from_int_q(1), R[] = {neg_q(one), one, from_int_q(0), neg_q(one), one, one};
 *     svg_control_polygon(s, 2, R, "R");
 *     svg_bezier(s, 2, R, SVG_CURVE);
 *     svg_write(s, "parabola.svg");
 *     const char *trouble = svg_failed(s);
 *     svg_free(s);
 *
 * Trouble sticks: the first failure is kept, every later call does nothing, and svg_failed says what
 * it was.  Every function accepts s == NULL, which is the canvas that could not be made.  Strings
 * are UTF-8, are copied, and may hold any character; bytes that XML cannot hold become U+FFFD.
 *
 * A role is what a thing is in the figure, and fixes colour, line width, dashes and the usual shape
 * of its points, so that no distinction rests on colour alone.  A host page may override the colours
 * by setting the CSS variables --curve, --curve-2, ..., --paper on elements of the class cagd.
 *
 * Curves, lines and shaded regions end at the window.  Points, arrows, axes and words may stand
 * over its edge; the figure grows around them.  Words lie over points, points over curves, curves
 * over axes and grid; within each of these layers the order is that of the calls. */
#ifndef CAGD_SVG_H
#define CAGD_SVG_H

#include "exact/number/rational.h"
#include "exact/words.h"

typedef struct svg svg;

typedef struct svg_point {
    num_q x, y;
} svg_point;

/* The rectangle x0 <= x <= x1, y0 <= y <= y1, with x0 < x1 and y0 < y1. */
typedef struct svg_window {
    num_q x0, y0, x1, y1;
} svg_window;

static inline svg_point svg_at(long x, long y) { return (svg_point){from_int_q(x), from_int_q(y)}; }
static inline svg_point svg_pair(const num_q P[]) { return (svg_point){P[0], P[1]}; }
static inline svg_window svg_integer_window(long x0, long y0, long x1, long y1)
{
    return (svg_window){from_int_q(x0), from_int_q(y0), from_int_q(x1), from_int_q(y1)};
}

enum svg_role {
    SVG_CURVE,   /* the curve the figure is about: thick, solid; disc                          */
    SVG_CURVE_2, /* the curve it is compared with: long dashes; square                         */
    SVG_POLYGON, /* control polygons: thin, solid; ring                                        */
    SVG_FAMILY,  /* the many members of a family: hairlines; small disc                        */
    SVG_POINT,   /* points and vectors in the colour of the text; disc                         */
    SVG_WRONG,   /* what a false statement claims: short dashes, hatching; cross               */
    SVG_RIGHT,   /* what is true in its place: thick, solid; diamond                           */
    SVG_MUTED,   /* auxiliary lines: dotted; ring                                              */
    SVG_AXIS,    /* axes, frames                                                               */
    SVG_FILL,    /* shading without a meaning of its own: hulls, regions                       */
    SVG_ROLES
};
enum svg_shape { SVG_USUAL, SVG_DISC, SVG_RING, SVG_SQUARE, SVG_DIAMOND, SVG_CROSS }; /* usual: the role's */
enum svg_direction { SVG_N, SVG_NE, SVG_E, SVG_SE, SVG_S, SVG_SW, SVG_W, SVG_NW, SVG_HERE };
enum svg_anchor { SVG_START, SVG_MIDDLE, SVG_END };

/* ---- The figure ------------------------------------------------------------------------------- */

/* name: letters, digits, '-' and '_', beginning with a letter; it prefixes the ids, so it is to be unique
 * in a page.  title stands above the panels; it is read aloud, as the description is, which is not shown.  NULL when memory is
 * short. */
svg *svg_new(const char *name, const char *title, const char *description);
void svg_free(svg *s);

/* NULL while all is well, otherwise one line that says what went wrong first; never owned. */
const char *svg_failed(const svg *s);

/* The document; NULL after a failure.  Belongs to s and lives until the next call on s. */
const char *svg_text(svg *s);

/* Writes the document beside path under a temporary name and renames it: path holds either the
 * whole figure or what it held before. */
void svg_write(svg *s, const char *path);

/* How many pairs of words overlap, by the usual widths of letters: 0 in a finished figure. */
int svg_overlaps(const svg *s);

/* ---- Panels ----------------------------------------------------------------------------------- */

/* Opens a panel, right of the others, whose window is `width` units wide.  With height 0 both axes
 * have one scale; otherwise the window is stretched to that height, for graphs of functions.
 * caption (prose, may be NULL; '\n' breaks the line) stands below. */
void svg_panel(svg *s, svg_window window, int width, int height, const char *caption);

/* How many panels more there can be. */
int svg_panels_left(const svg *s);

/* The next panel begins a new row, below those before; the first windows of the rows are level at the left. */
void svg_row(svg *s);

/* A heading above the panel (prose), with a cross for SVG_WRONG and a tick for SVG_RIGHT. */
void svg_heading(svg *s, enum svg_role role, const char *markup);

void svg_frame(svg *s);                    /* the border of the window                        */
void svg_grid(svg *s, num_q dx, num_q dy); /* lines at the multiples of dx and of dy          */

/* Both axes, through 0 where the window contains it and along its left or lower edge where not.  The
 * ticks stand outside the window, where no curve runs, below it and to its left, at the multiples of dx
 * and dy (0: none), labelled by exact decimals, or by fractions where there are none.  The names are
 * mathematics and may be NULL. */
void svg_axes(svg *s, num_q dx, num_q dy, const char *x_name, const char *y_name);

/* The same ticks around a frame, without axes, as graphs of measurements have them. */
void svg_scales(svg *s, num_q dx, num_q dy, const char *x_name, const char *y_name);

/* ---- Words ------------------------------------------------------------------------------------
 *
 * Markup: $ changes between prose and mathematics.  In mathematics letters are italic, - is a minus
 * sign, ' a prime, and _ and ^ take the next character or {group} down or up: R_i^{[2]}(t,c).
 * A backslash sets the next character as it is, and upright. */

/* A label (begins in mathematics) beside the point `at`, in the given direction from it. */
void svg_label(svg *s, svg_point at, enum svg_direction towards, enum svg_role role, const char *markup);

/* A remark (begins in prose), smaller. */
void svg_note(svg *s, svg_point at, enum svg_direction towards, enum svg_role role, const char *markup);

/* Where a label is to stand clear: points with coordinates point[2 i], point[2 i + 1] in the window, whose marks no letter may touch, and
 * places of lines, which it should not. */
typedef struct svg_crowd {
    int points, places;
    const double *point, *place;
} svg_crowd;

/* A label or a remark beside `at`, inside the window, over no point of the crowd and no other words: in the given direction, or in another one,
 * or farther away.  0, and nothing is put, where there is no room.  From a remark that stands as near to another point of the crowd
 * a hairline leads to its own. */
int svg_label_clear(svg *s, svg_point at, enum svg_direction towards, const svg_crowd *crowd, enum svg_role role,
                    const char *markup);
int svg_note_clear(svg *s, svg_point at, enum svg_direction towards, const svg_crowd *crowd, enum svg_role role,
                   const char *markup);

/* A label whose baseline stands right hundredths of an em to the right of, and up above, `at`. */
void svg_label_at(svg *s, svg_point at, enum svg_anchor anchor, int right, int up, enum svg_role role,
                  const char *markup);

/* The direction, among the eight, nearest to that of to - from; SVG_N when they coincide. */
enum svg_direction svg_direction_of(svg_point from, svg_point to);

/* Entries of the legend, below the panels, in the order of the calls: a line, a point, a shaded box. */
void svg_legend_line(svg *s, enum svg_role role, const char *markup);
void svg_legend_mark(svg *s, enum svg_role role, enum svg_shape shape, const char *markup);
/* A dot as those of a cloud of that diameter. */
void svg_legend_dot(svg *s, enum svg_role role, int diameter, const char *markup);
void svg_legend_area(svg *s, enum svg_role role, const char *markup);

/* ---- Points and lines -------------------------------------------------------------------------
 *
 * An array of points holds pairs x, y, one after the other, as the kernels have them; point i is
 * P[2 i], P[2 i + 1].  No argument is kept. */

void svg_mark(svg *s, svg_point at, enum svg_role role, enum svg_shape shape);
/* Translucent dots of that diameter, in hundredths of a unit, under all lines: for many points. */
void svg_cloud(svg *s, int count, const num_q P[], int diameter, enum svg_role role);
void svg_segment(svg *s, svg_point a, svg_point b, enum svg_role role);
void svg_line(svg *s, svg_point a, svg_point b, enum svg_role role); /* the whole line, a != b   */
void svg_arrow(svg *s, svg_point tail, svg_point head, enum svg_role role);
void svg_polyline(svg *s, int count, const num_q P[], enum svg_role role);
void svg_area(svg *s, int count, const num_q P[], enum svg_role role); /* even-odd, translucent */
void svg_circle(svg *s, svg_point centre, num_q radius, enum svg_role role);

/* The polygon R_0 ... R_n with its points, labelled letter_0, ..., letter_n on the outer side. */
void svg_control_polygon(svg *s, int degree, const num_q R[], const char *letter);
/* The same with the labels where towards[0], ..., towards[degree] say. */
void svg_control_polygon_towards(svg *s, int degree, const num_q R[], const char *letter,
                                 const enum svg_direction towards[]);

/* The matrix m, row after row, as tinted cells: cell (i, j) is the square j <= x <= j + 1,
 * rows - 1 - i <= y <= rows - i.  The tint grows with |m| / max |m|; negative entries have the
 * colour of SVG_CURVE_2 and, where the entry is not printed because the cell is too small, a bar. */
void svg_heat(svg *s, int rows, int columns, const num_q m[]);

/* ---- Curves -----------------------------------------------------------------------------------
 *
 * What SVG has, it draws: polynomial curves of degree <= 3.  Other curves become polylines within
 * the tolerance. */

/* The tolerance in output units, > 0; 1/20 at first. */
void svg_tolerance(svg *s, num_q units);

/* The Bézier curve of degree 1 <= degree <= MAX_DEGREE, 0 <= t <= 1. */
void svg_bezier(svg *s, int degree, const num_q R[], enum svg_role role);

/* The rational Bézier curve of weights w of any sign, 0 <= t <= 1: every point of the curve in the
 * window is within the tolerance of the polyline and conversely, before rounding.  Where the
 * denominator vanishes the curve is left open.  The weights (-1)^i w_i give the rest of the curve. */
void svg_rational(svg *s, int degree, const num_q R[], const num_q w[], enum svg_role role);

/* The point of parameter t; raising FAULT_UNDEFINED in region_faults says that there is none. */
typedef svg_point svg_curve(num_q t, const void *data);

/* The curve over t0 <= t <= t1: cut into equal pieces, and each piece in two until its middle point is
 * within the tolerance of its chord.  A jump is left open.  What happens between the sampled
 * parameters is not seen: take enough pieces. */
void svg_plot(svg *s, svg_curve *curve, const void *data, num_q t0, num_q t1, int pieces, enum svg_role role);

/* A function on the plane; only its sign is used. */
typedef num_q svg_field(svg_point at, const void *data);

/* The curve F = 0 where F changes sign, on a grid of about `cells` cells along the longer side of the
 * window, 1 <= cells <= 512: the crossings of the grid lines are found by exact signs to 1/100 unit.
 * A cell entered by four branches is drawn as a crossing. */
void svg_implicit(svg *s, svg_field *F, const void *data, int cells, enum svg_role role);

/* The region F > 0 of the window, shaded; the same grid. */
void svg_region(svg *s, svg_field *F, const void *data, int cells, enum svg_role role);

#endif
