/* Operations, conversions and comparisons.  "= EXPRESSION": what Python makes of it, with Fraction as F. */
#include <math.h>
#include <stdint.h>

/* = F(1, 3) */
double a_quotient(void) { return 1.0 / 3; }
/* = F(1, 3) + F(1, 7) - F(2, 11) */
double a_sum(void) { return 1.0 / 3 + 1.0 / 7 - 2.0 / 11; }
/* = F(2, 3) * F(5, 7) / F(11, 13) */
double a_product(void) { return 2.0 / 3 * (5.0 / 7) / (11.0 / 13); }
/* = -F(1, 3) */
double a_negation(void) { double x = 1.0 / 3; return -x; }
/* = F(0.1) + F(0.2) */
double a_literal_is_its_binary64(void) { return 0.1 + 0.2; }
/* = F(1, 10) + F(2, 10) */
double a_quotient_of_literals(void) { return 1.0 / 10 + 2.0 / 10; }
/* = 1 */
double a_tenth_ten_times(void) { double s = 0; for (int i = 0; i < 10; i++) s += 1.0 / 10; return s; }
/* = sum(F(1, k) for k in range(1, 41)) */
double a_harmonic_sum(void) { double s = 0; for (int k = 1; k <= 40; k++) s += 1.0 / k; return s; }
/* = F(1, 3) + 10**20 - 10**20 */
double a_nothing_is_absorbed(void) { return 1.0 / 3 + 1e20 - 1e20; }
/* = 1 + F(2)**-60 */
double a_small_bit_is_kept(void) { return 1 + 1.0 / (1l << 60); }
/* = F(7, 2) */
double a_compound_assignment(void) { double x = 1; x += 6; x *= 3; x /= 6; return x; }
/* = 4 */
double a_increment(void) { double x = 2; x++; ++x; return x; }
/* = F(1, 3) - 1 */
double a_decrement(void) { double x = 1.0 / 3; x--; return x; }
/* = 5 */
double a_conditional(void) { double x = 1.0 / 3; return x < 0.5 ? 5 : 7; }
/* = 1 */
double a_third_times_three(void) { return 1.0 / 3 * 3 == 1; }
/* = 1 */
double a_less(void) { return 1.0 / 3 < 1.0 / 3 + 1e-300; }
/* = 1 */
double a_greater_or_equal(void) { return 2.0 / 6 >= 1.0 / 3; }
/* = 1 */
double a_not_equal(void) { return 0.1 + 0.2 != 3.0 / 10; }
/* = 2 */
double a_truth_of_a_number(void) { double x = 1.0 / 3 - 2.0 / 6, y = 1e-300; return (x ? 1 : 0) + (y ? 2 : 0); }
/* = 1 */
double a_not(void) { double x = 1.0 / 3 - 2.0 / 6; return !x; }
/* = 3 */
double a_logical_operators(void) { double x = 1.0 / 3; return (x > 0 && x < 1) + 2 * (x < 0 || x > 0.25); }
/* = 1 */
double a_bool(void) { double x = 1.0 / 3; _Bool b = x; return b; }
/* = 6 */
double a_truncation(void) { return (int)(20.0 / 3); }
/* = -6 */
double a_truncation_below_zero(void) { return (int)(-20.0 / 3); }
/* = 200 */
double a_to_unsigned_char(void) { return (unsigned char)(401.0 / 2); }
/* = 2**63 + 2**62 */
double a_to_unsigned_long(void) { return (uint64_t)(3.0 * (1ul << 62)); }
/* = -(2**63) */
double a_to_long(void) { return (int64_t)(-2.0 * (1l << 62)); }
/* = -7 */
double a_to_short(void) { return (short)(-22.0 / 3); }
/* = 2**53 + 1 */
double a_from_long(void) { long n = (1l << 53) + 1; return n; }
/* = 2**64 - 1 */
double a_from_unsigned_long(void) { return ~0ul; }
/* = -(2**63) */
double a_from_least_long(void) { return INT64_MIN; }
/* = -5 */
double a_from_signed_char(void) { signed char c = -5; return c; }
/* = F(1, 3) */
double a_float(void) { float x = 1.0f / 3; return x; }
/* = F(1, 3) * F(2, 7) - F(1, 5) */
double a_float_arithmetic(void) { float x = 1.0f / 3, y = 2.0f / 7; return x * y - 1.0f / 5; }
/* = F(1, 3) */
double a_double_to_float_and_back(void) { double x = 1.0 / 3; float y = (float)x; return y; }
/* = -F(2, 9) */
double a_float_negation(void) { float x = 2.0f / 9; return -x; }
/* = 3 */
double a_float_to_int(void) { float x = 10.0f / 3; return (int)x; }
/* = 1 */
double a_float_comparison(void) { float x = 1.0f / 3, y = 2.0f / 6; return x == y; }
/* = 16777217 */
double a_float_from_int(void) { float x = 16777217; return x; }
/* = F(3) ** 60 / F(2) ** 90 */
double a_large_power(void) { double p = 1; for (int i = 0; i < 60; i++) p *= 3; for (int i = 0; i < 90; i++) p /= 2; return p; }
/* = 1 */
double a_infinity(void) { return INFINITY > 1.0 / 3; }
/* = 2 */
double a_infinity_as_start(void) { double best = INFINITY, x[3] = {5, 2, 7}; for (int i = 0; i < 3; i++) if (x[i] < best) best = x[i]; return best; }
/* = 4 */
double a_nan(void) { double x = NAN; return (x == x) + 4 * (x != x); }
/* = 1 */
double a_huge_val(void) { return isinf(HUGE_VAL); }
/* = 1 */
double a_isfinite(void) { return isfinite(1.0 / 3) && !isfinite(INFINITY) && !isfinite(NAN); }
/* = 2 */
double a_isnan(void) { return isnan(1.0 / 3) + 2 * !!isnan(NAN); }
/* = 1 */
double a_isnormal(void) { return isnormal(1.0 / 3); }
/* = 5 */
double a_signbit(void) { return !!signbit(-1.0 / 3) + 2 * !!signbit(1.0 / 3) + 4 * !!signbit(-0.0); }
/* = 1 */
double a_isless(void) { return isless(1.0 / 3, 1.0 / 2) && !isgreater(1.0 / 3, 1.0 / 2); }
/* = 1 */
double a_islessgreater(void) { return islessgreater(1.0 / 3, 1.0 / 2); }
/* = 1 */
double a_isunordered(void) { return isunordered(NAN, 1) && !isunordered(1.0 / 3, 1); }
/* = 4 */
double a_fpclassify(void) { return fpclassify(1.0 / 3) == FP_NORMAL ? 4 : 0; }
/* = F(1, 7) */
double a_comma(void) { double x = 1; return x = x / 7, x; }
/* = F(22, 7) */
double a_shadowed(void) { double x = 22; { double y = 7; x = x / y; } return x; }
/* = F(5, 3) */
double a_switch(void) { double x = 5.0 / 3; switch ((int)x) { case 0: return 0; case 1: return x; default: return 2; } }
/* = F(6, 13) */
double a_goto(void) { double s = 0; int i = 0;
again: s += 1.0 / 13; if (++i < 6) goto again; return s; }
/* = F(1, 2) ** 10 */
double a_do_while(void) { double x = 1; int n = 0; do x /= 2; while (++n < 10); return x; }
/* = 7 */
double a_bits_of_integers_are_free(void) { unsigned x = 0x7ff00000u; int n = 0; for (; x; x &= x - 1) n++; return n - 4; }
/* = F(10) ** 400 */
double a_beyond_binary64(void) { double x = 1e200; x = 1; for (int i = 0; i < 400; i++) x *= 10; return x; }
/* = F(1, 10) ** 400 */
double a_below_binary64(void) { double x = 1; for (int i = 0; i < 400; i++) x /= 10; return x; }
