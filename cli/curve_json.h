/* curve_json.h -- curves and numbers as files have them. */
#ifndef CAGD_CURVE_JSON_H
#define CAGD_CURVE_JSON_H

#include "exact/number/rational.h"
#include "exact/words.h"

#include <argp.h>
#include <jansson.h>

/* A Bézier, rational Bézier, B-spline or NURBS curve, exactly as a file says it.  A Bézier curve is a spline of one
 * span over 0, ..., 0, 1, ..., 1.  Shapes as in core/kernels/bspline.tmpl.h; weights NULL: none.  Lives in the region. */
struct curve {
    int degree, count, dim;
    num_q *knots, *points, *weights;
};

/* Reads {"kind": ..., "degree" or "order": ..., "points": ..., "weights": ..., "knots": ...} from the file, "-" for
 * standard input, and checks it.  0 on success; otherwise -1 and one line on stderr that says what, where, and what was
 * expected. */
int read_curve(const char *path, struct curve *c);
json_t *
curve_json(const struct curve *c); /* the same format; whole numbers as such, other rationals as strings       */
json_t *number_json(num_q a);
/* The exact value of an option; one line and EXIT_USAGE when it is not a number. */
num_q exact_number(struct argp_state *state, const char *option, const char *text);
#endif
