/* point_json.h -- the inputs of code that is run exactly, as JSON. */
#ifndef CAGD_POINT_JSON_H
#define CAGD_POINT_JSON_H

#include "exact/code/points.h"

#include <jansson.h>

/* {name: [text of a rational, ...]} in the order of the inputs; a single number is a list of one.  The caller owns it. */
json_t *point_json(const struct cagd_code_point *p);
#endif
