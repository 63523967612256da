/* Numbers that are not rational, in intervals. */
#include <math.h>

/* = math.sqrt(2) */
double e_root(void) { return sqrt(2); }
/* = math.sqrt(2) + math.sqrt(3) */
double e_sum_of_roots(void) { return sqrt(2) + sqrt(3); }
/* = math.sin(1) */
double e_sine(void) { return sin(1); }
/* = math.exp(1/3) */
double e_exponential(void) { return exp(1.0 / 3); }
/* = math.atan(1/3) */
double e_arc(void) { return atan(1.0 / 3); }
/* = 3 * math.log(7) */
double e_logarithm(void) { double x = log(7); return x > 1 ? 3 * x : 0; }
/* = math.acos(0.5) * math.sqrt(5) */
double e_acos(void) { return acos(0.5) * sqrt(5); }
/* = 2 ** (1/3) */
double e_cube_root(void) { return cbrt(2); }
/* = math.tan(1) */
double e_tangent(void) { return tan(1); }
/* = math.asin(1/3) */
double e_asin(void) { return asin(1.0 / 3); }
/* = math.expm1(1/3) */
double e_expm1(void) { return expm1(1.0 / 3); }
/* = math.log1p(1/3) */
double e_log1p(void) { return log1p(1.0 / 3); }
/* = math.sinh(1) */
double e_sinh(void) { return sinh(1); }
/* = math.cosh(1) */
double e_cosh(void) { return cosh(1); }
/* = math.tanh(1) */
double e_tanh(void) { return tanh(1); }
/* = 2 ** (1/3) */
double e_exp2(void) { return exp2(1.0 / 3); }
/* = math.atan2(2, 3) */
double e_atan2(void) { return atan2(2, 3); }
/* = -math.sqrt(2) * math.sqrt(3) / math.sqrt(5) */
double e_negative(void) { double x = -sqrt(2); return x * sqrt(3) / sqrt(5); }
/* = math.sqrt(2) + 7 */
double e_whole_part_of_an_enclosure(void) { return sqrt(2) + floor(sqrt(55)); }
static double third(int n) { double e = 1.0 / 3; while (n-- > 0) e /= 2; return e; }
/* ! an enclosure does not decide a comparison */
double e_acos_next_to_1(void) { double e = third(190), a = acos(1 - e), r = a * a / (2 * e), near = ldexp(1, -132); return r > 1 + near || r < 1 - near; }
/* ! an enclosure does not decide a comparison */
double e_asin_next_to_1(void) { double e = third(310), a = 2 * asin(1) - 2 * asin(1 - e); return a * a / (8 * e) < 0.9995; }
