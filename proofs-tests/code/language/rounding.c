/* What binary64 makes of it: "ulps EXPRESSION" is the computed value, in Python's floats; the exact one is checked apart. */
#include <math.h>

/* # 1/3 + 1/3 */
double n_sum(void) { return 1.0 / 3 + 1.0 / 3; }
/* # 0.1 + 0.2 - 0.3 */
double n_cancellation(void) { double x = 0.1; return x + 0.2 - 0.3; }
/* # sum(0.1 for k in range(10)) */
double n_loop(void) { double s = 0; for (int i = 0; i < 10; i++) s += 0.1; return s; }
/* # (1e16 + 1.0) - 1e16 */
double n_absorbed(void) { double x = 1e16; return x + 1.0 - x; }
/* # math.sqrt(2.0) * math.sqrt(2.0) */
double n_root(void) { return sqrt(2.0) * sqrt(2.0); }
/* # 1/3 * 3 */
double n_product(void) { double x = 1.0 / 3; return x * 3; }
/* # struct.unpack("f", struct.pack("f", 1/3))[0] */
double n_float(void) { float x = 1.0 / 3; return x; }
/* # math.sin(1.0) + math.exp(0.5) */
double n_functions(void) { return sin(1.0) + exp(0.5); }
/* # float(2**53 + 1) */
double n_from_integer(void) { long n = (1l << 53) + 1; return n; }
/* # float(int(0.1 * 3 / 0.3 * 1e16)) */
double n_to_integer(void) { return (long)(0.1 * 3 / 0.3 * 1e16); }
/* # math.fmod(16/3, 0.7) */
double n_fmod(void) { return fmod(16.0 / 3, 0.7); }
/* # math.remainder(17/3, 2.0) */
double n_remainder(void) { return remainder(17.0 / 3, 2); }
/* # float(F(0.1) * 10 - 1) */
double n_fma(void) { return fma(0.1, 10, -1); }
/* # -(0.1 + 0.2) */
double n_negative(void) { double x = 0.1; return -(x + 0.2); }
/* # 4.0 + 3.0 + 3.0 */
double n_whole(void) { return ceil(10.0 / 3) + round(5.0 / 2) + floor(10.0 / 3); }
/* # 2.0 + 3.0 */
double n_even_and_cut(void) { return rint(5.0 / 2) + trunc(10.0 / 3); }
/* # math.log2(1/49*49) */
double n_logarithm_of_what_should_be_1(void) { double x = 1.0 / 49 * 49; return log2(x); }
/* # math.log(1/49*49) */
double n_natural_logarithm_of_what_should_be_1(void) { double x = 1.0 / 49 * 49; return log(x); }
/* # 2.0 ** (1/49*49) */
double n_power_of_what_should_be_1(void) { double x = 1.0 / 49 * 49; return exp2(x); }
/* # math.cbrt(math.prod([1/49*49] * 8)) */
double n_cube_root_of_what_should_be_1(void) { double x = 1.0 / 49 * 49, p = 1; for (int k = 0; k < 8; k++) p *= x; return cbrt(p); }
/* ! pow with an exponent that was rounded */
double n_rounded_exponent(void) { double x = 1.0 / 49 * 49; return pow(3, x); }
/* # math.pow(1/49*49, 3) */
double n_power_of_a_rounded_one(void) { double x = 1.0 / 49 * 49; return pow(x, 3); }
