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
/* ---- an argument that is an interval itself; where values are too large; functions on both sides of 0 ---- */

/* = math.sin(math.sqrt(2)) */
double e_sine_of_a_root(void) { return sin(sqrt(2)); }
/* = math.cos(math.sqrt(2)) */
double e_cosine_of_a_root(void) { return cos(sqrt(2)); }
/* = math.cos(1) */
double e_cosine(void) { return cos(1); }
/* = math.exp(math.sqrt(2)) */
double e_exponential_of_a_root(void) { return exp(sqrt(2)); }
/* = math.atan(-math.sqrt(2)) */
double e_arc_of_a_root(void) { return atan(-sqrt(2)); }
/* = math.acos(math.sqrt(2) / 2) */
double e_falling_function_of_a_root(void) { return acos(sqrt(2) / 2); }
/* = 2 ** (1/6) */
double e_cube_root_of_a_root(void) { return cbrt(sqrt(2)); }
/* = -(2 ** (1/3)) */
double e_negative_cube_root(void) { return cbrt(-2); }
/* = math.log2(6) + math.log10(2) */
double e_logarithms(void) { return log2(6) + log10(2); }
/* = math.log2(math.sqrt(3)) - math.log10(math.sqrt(3)) */
double e_logarithms_of_a_root(void) { return log2(sqrt(3)) - log10(sqrt(3)); }
/* ! tan of an interval */
double e_tangent_of_a_root(void) { return tan(sqrt(2)); }
/* ! cosh of an interval */
double e_cosh_of_a_root(void) { return cosh(sqrt(2)); }
/* = math.sqrt(2 + math.sqrt(2)) */
double e_root_of_a_root(void) { return sqrt(2 + sqrt(2)); }
/* ! the square root of a negative number */
double e_root_of_a_negative_root(void) { return sqrt(-sqrt(2)); }
/* = math.hypot(1, 1) + math.hypot(-1, 2) */
double e_hypot(void) { return hypot(1, 1) + hypot(-1, 2); }
/* = math.sqrt(2) + 10 * math.sqrt(3) */
double e_absolute_values(void) { return fabs(-sqrt(2)) + 10 * fabs(sqrt(3)); }
/* = math.sqrt(3) + 10 * math.sqrt(2) */
double e_greatest_and_least(void) { double a = sqrt(2), b = sqrt(3); return fmax(a, b) + 10 * fmin(b, a); }
/* = math.atan2(-2, 3) + 10 * math.atan2(1, math.sqrt(2)) */
double e_atan2_below_and_of_a_root(void) { return atan2(-2, 3) + 10 * atan2(1, sqrt(2)); }
/* ! atan2 outside the right half-plane */
double e_atan2_to_the_left(void) { return atan2(2, -3); }
/* = math.exp(69) */
double e_large_exponential(void) { return exp(69); }
/* ! exp where its value is too large, too small or not there */
double e_exponential_that_is_too_large(void) { return exp(70); }
/* = math.exp(-69) */
double e_small_exponential(void) { return exp(-69); }
/* ! exp where its value is too large, too small or not there */
double e_exponential_that_is_too_small(void) { return exp(-71); }
/* ! log where its value is too large, too small or not there */
double e_logarithm_of_0(void) { return log(0); }
/* ! log2 where its value is too large, too small or not there */
double e_logarithm_of_a_negative(void) { return log2(-1); }
/* ! asin where its value is too large, too small or not there */
double e_asin_beyond_1(void) { return asin(2); }
/* = math.sin(2.0 ** 63) */
double e_sine_of_a_large_number(void) { return sin(0x1p63); }
/* ! sin of a number beyond 2^64 */
double e_sine_of_too_large_a_number(void) { return sin(0x1p64); }
/* = 8 + 10 * 5 + 100 * math.sqrt(2) */
double e_exact_ones_stay_exact(void) { return exp2(3) + 10 * log2(32) + 100 * sqrt(2) * cos(0) + sin(0) + atan2(0, 1); }
/* = 2 + 10 * -1 + 100 * -2 + 1000 * 1 + 0 * math.sqrt(2) */
double e_rounded_roots(void) { double r = sqrt(2); return ceil(r) + 10 * round(-r) + 100 * floor(-r) + 1000 * rint(r) + 0.0 * trunc(-r) + r - r; }
/* ! an enclosure does not decide to which integer a number is rounded */
double e_rounded_at_an_integer(void) { return floor(sqrt(2) * sqrt(2)); }
/* ! an enclosure does not decide to which integer a number is rounded */
double e_cut_at_an_integer(void) { return (int)(sqrt(3) * sqrt(3)); }
/* ! frexp of an interval */
double e_frexp(void) { int e; return frexp(sqrt(2), &e); }
/* ! pow with an exponent that varies */
double e_exponent(void) { return pow(2, sqrt(2)); }
/* = 2 * math.sqrt(2) */
double e_power_of_a_root(void) { return pow(sqrt(2), 3); }
/* ! an enclosure does not decide a comparison */
double e_logb(void) { return logb(sqrt(2) - sqrt(2)); }
/* The same angle in two ways, of which each enclosure has its own ends: that of its sine has to have both. */
/* ! an enclosure does not decide a comparison */
double e_sine_of_45_in_two_ways(void) { double x = sin(sqrt(4050)), y = sin(45 * sqrt(2)); return x < y || x > y; }
/* ! an enclosure does not decide a comparison */
double e_sine_of_85_in_two_ways(void) { double x = sin(sqrt(14450)), y = sin(85 * sqrt(2)); return x < y || x > y; }
/* ! an enclosure does not decide a comparison */
double e_cosine_of_45_in_two_ways(void) { double x = cos(sqrt(4050)), y = cos(45 * sqrt(2)); return x < y || x > y; }
/* ! an enclosure does not decide a comparison */
double e_cosine_of_85_in_two_ways(void) { double x = cos(sqrt(14450)), y = cos(85 * sqrt(2)); return x < y || x > y; }
