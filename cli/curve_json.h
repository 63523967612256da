/* curve_json.h -- curves and numbers as files have them. */
#ifndef CAGD_CURVE_JSON_H
#define CAGD_CURVE_JSON_H

#include "cli/input.h"
#include "exact/curve/spline.h"
#include "exact/words.h"

#include <argp.h>
#include <jansson.h>

/* Reads {"kind": ..., "degree" or "order": ..., "points": ..., "weights": ..., "knots": ...} from the file, "-" for
 * standard input, and checks it: a Bézier, rational Bézier, B-spline or NURBS curve, exactly as the file says it.  A Bézier
 * curve is a spline of one span over 0, ..., 0, 1, ..., 1.  0 and *c, which lives in the region; otherwise -1 and *error. */
int read_curve(const char *path, cagd_spline_q *c, struct input_error *error);
/* The same format, a curve of one span over 0 and 1 as a Bézier curve; whole numbers as such, other rationals as strings. */
json_t *curve_json(const cagd_spline_q *c);
json_t *number_json(num_q a);
int is_bezier(const cagd_spline_q *c); /* whether it is one of those: its knots are 0, ..., 0, 1, ..., 1 */
/* The exact value of an option; one line and EXIT_USAGE when it is not a number. */
num_q exact_number(struct argp_state *state, const char *option, const char *text);
#endif
