#include "core/api/cagd.h"

const char *cagd_status_text(cagd_status status)
{
    switch (status) {
    case CAGD_OK:
        return "no error";
    case CAGD_NULL:
        return "a pointer is NULL";
    case CAGD_NO_MEMORY:
        return "there is not enough memory";
    case CAGD_DEGREE:
        return "the degree is out of range";
    case CAGD_DIMENSION:
        return "the dimension is out of range";
    case CAGD_ORDER:
        return "the order of derivation is out of range";
    case CAGD_COUNT:
        return "a spline needs more points than its degree, and an array no fewer than 0";
    case CAGD_NOT_FINITE:
        return "an argument is infinite or not a number";
    case CAGD_SIGN:
        return "an argument has a sign, or is a zero, that is excluded";
    case CAGD_OUTSIDE_DOMAIN:
        return "a parameter lies outside the domain of the spline";
    case CAGD_KNOTS_DECREASE:
        return "a knot is smaller than the one before it";
    case CAGD_KNOTS_MULTIPLE:
        return "a knot is repeated more than degree + 1 times";
    case CAGD_KNOTS_EMPTY:
        return "the domain of the spline is empty";
    case CAGD_UNDEFINED:
        return "the value is undefined: a divisor is zero";
    case CAGD_OVERFLOW:
        return "a result is too large or too small for binary64";
    case CAGD_NO_KNOT:
        return "there is no such knot inside the domain";
    case CAGD_CHANGES:
        return "the curve would be another one";
    case CAGD_BAD_DATA:
        return "a coordinate is not finite, a standard deviation is not positive, or the dimension is not 2 or 3";
    case CAGD_BAD_OPTION:
        return "an option is outside its range";
    case CAGD_BAD_CURVE:
        return "the initial curve or the knots are not those of a clamped, continuous curve with positive weights";
    case CAGD_TOO_FEW:
        return "there are fewer equations than unknowns";
    case CAGD_ALL_EQUAL:
        return "all points are equal";
    case CAGD_STATUSES:
        break;
    }
    return "unknown status";
}

const char *cagd_version(void) { return CAGD_VERSION; }
