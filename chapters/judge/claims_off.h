/* claims_off.h -- close the text opened by claims_on.h. */
#undef unknown
#undef positive
#undef parameter
#undef whole
#undef inside
#undef same
#undef vanishes
#undef nonnegative
#undef show
#undef show_points
#undef given
#undef given_points
#undef found
#undef found_points
#include "core/number/generic_off.h"
