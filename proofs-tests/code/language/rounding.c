/* What binary64 makes of it: "# EXPRESSION" is the computed value, in Python's floats; "# EXPRESSION ; EXACT" has the exact one beside it. */
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
/* ---- the error in ulps of what is exact, too ---- */

/* # 1/3 + 1/7 ; F(1, 3) + F(1, 7) */
double n_sum_of_quotients(void) { return 1.0 / 3 + 1.0 / 7; }
/* # 1/3 - 1/7 ; F(1, 3) - F(1, 7) */
double n_difference(void) { return 1.0 / 3 - 1.0 / 7; }
/* # 1/3 * (1/7) ; F(1, 21) */
double n_product_of_quotients(void) { return 1.0 / 3 * (1.0 / 7); }
/* # (1/3) / (1/7) ; F(7, 3) */
double n_quotient_of_quotients(void) { return 1.0 / 3 / (1.0 / 7); }
/* # math.sqrt(1/49) ; F(1, 7) */
double n_root_of_a_quotient(void) { return sqrt(1.0 / 49); }
/* # struct.unpack("f", struct.pack("f", 1/3))[0] * 2 ; F(2, 3) */
double n_float_and_its_double(void) { float x = 1.0 / 3; return 2 * x; }
/* # float(2**62 + 1) - 2.0**62 ; 1 */
double n_integer_less_a_power(void) { unsigned long n = (1ul << 62) + 1; return n - 0x1p62; }
/* # float(-(2**62 + 1)) ; -(2**62 + 1) */
double n_negative_integer(void) { long n = -(1l << 62) - 1; return n; }
/* # abs(-1/3) ; F(1, 3) */
double n_amount(void) { return fabs(-1.0 / 3); }
/* # -1/3 ; F(-1, 3) */
double n_with_a_sign(void) { return copysign(1.0 / 3, -1); }
/* # max(1/3, 1/7) + 10 * min(1/3, 1/7) ; F(1, 3) + 10 * F(1, 7) */
double n_greatest_and_least(void) { return fmax(1.0 / 7, 1.0 / 3) + 10 * fmin(1.0 / 3, 1.0 / 7); }
/* # 1/3 * 2.0**40 ; F(2**40, 3) */
double n_scaled(void) { return ldexp(1.0 / 3, 40); }
/* # math.fmod(16/3, 5/7) ; F(16, 3) % F(5, 7) */
double n_fmod_of_quotients(void) { return fmod(16.0 / 3, 5.0 / 7); }
/* # math.remainder(16/3, 5/7) ; F(16, 3) - 7 * F(5, 7) */
double n_remainder_of_quotients(void) { return remainder(16.0 / 3, 5.0 / 7); }
/* # float(F(1/3) * F(1/7) - F(1/21)) ; 0 */
double n_fma_of_quotients(void) { return fma(1.0 / 3, 1.0 / 7, -1.0 / 21); }
/* # float(F(1/3) * F(1/7) + F(1/11)) ; F(1, 21) + F(1, 11) */
double n_fma_that_is_no_zero(void) { return fma(1.0 / 3, 1.0 / 7, 1.0 / 11); }
/* # math.cbrt(1/343) ; F(1, 7) */
double n_cube_root(void) { return cbrt(1.0 / 343); }
/* # math.floor(49 * (1/49)) ; 1 */
double n_floor_of_what_should_be_1(void) { double x = 1.0 / 49 * 49; return floor(x); }
/* # math.trunc(49 * (1/49)) ; 1 */
double n_trunc_of_what_should_be_1(void) { double x = 1.0 / 49 * 49; return trunc(x); }
/* # math.ceil(3 * 1.1) ; 4 */
double n_ceil_of_a_product(void) { double x = 1.1; return ceil(x * 3); }
/* # 2.0 ; 2 */
double n_round_to_even(void) { return rint(5.0 / 2); }
/* # 3.0 ; 3 */
double n_round_away(void) { return round(5.0 / 2); }
/* # int(49 * (1/49)) ; 0 */
double n_integer_below_what_should_be_1(void) { double x = 1.0 / 49 * 49; return (int)x; }
/* # math.exp(0) ; 1 */
double n_exponential_of_0(void) { return exp(1.0 / 3 - 1.0 / 3); }
/* # 1/3 * ((1/3 * (1/3)) * (1/3 * (1/3))) ; F(1, 243) */
double n_fifth_power(void) { double x = 1.0 / 3, y = x * x; y *= y; return x * y; }
