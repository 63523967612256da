/* Functions of the variables x and y, at x = 2/3, y = -5/7.  "~ EXPRESSION": in Python, of x and y; "| CONDITION": one of those told; "| A | B |": all of them, in their order. */
#include <math.h>
#include <stdio.h>
#include <string.h>

double input_x(void);
double input_y(void);

/* ~ (x + y) ** 3 */
double f_power(void) { double s = input_x() + input_y(); return s * s * s; }
/* ~ (x - y) / (x + y) */
double f_quotient(void) { double x = input_x(), y = input_y(); return (x - y) / (x + y); }
/* ~ x + y */
double f_cancelled(void) { double x = input_x(), y = input_y(); return (x * x - y * y) / (x - y); }
/* ~ -y | y < 0 */
double f_fabs(void) { return fabs(input_y()); }
/* ~ x | x > 0 */
double f_branch(void) { double x = input_x(); if (x > 0) return x; return -x; }
/* ~ x | x > y */
double f_fmax(void) { return fmax(input_x(), input_y()); }
/* ~ x - y | y < x */
double f_swap(void) { double a = input_x(), b = input_y(); if (b < a) { double t = a; a = b; b = t; } return b - a; }
/* ~ y | x-y >= 1/1000000000 */
double f_tolerance(void) { double x = input_x(), y = input_y(); return fabs(x - y) < 1.0 / 1000000000 ? x : y; }
/* ~ 0 | x < 1 */
double f_floor(void) { return floor(input_x()); }
/* ~ -1 * x | y < -1/2 */
double f_round(void) { return round(input_y()) * input_x(); }
/* ~ 0 * x | y > -1 */
double f_int(void) { return (int)input_y() * input_x(); }
/* ~ x * x */
double f_equal_needs_no_condition(void) { double x = input_x(); return x * x == pow(x, 2) ? pow(x, 2) : 0; }
/* ~ x ** 5 / y ** 3 */
double f_pow(void) { return pow(input_x(), 5) * pow(input_y(), -3); }
/* ~ x + 1 | x+1 >= 0 */
double f_root_of_a_square(void) { double x = input_x(); return sqrt(x * x + 2 * x + 1); }
/* ~ x * x + 1 */
double f_root_squared(void) { double r = sqrt(input_x() * input_x() + 1), z = r * r; return z == input_x() * input_x() + 1 ? input_x() * input_x() + 1 : 0; }
/* ~ 1 */
double f_circle(void) { double s = sin(input_x()), c = cos(input_x()), z = s * s + c * c; return z == 1 ? 1 : 0; }
/* ~ 0 */
double f_a_root_is_not_the_sine(void) { double s = sin(input_y()), c = cos(input_y()); return sqrt(1 - c * c) == s; }
/* ~ 1 */
double f_a_root_is_itself(void) { double a = sqrt(input_x() + 3), b = sqrt(3 + input_x()); return a == b; }
/* ~ x - y */
double f_float(void) { float a = input_x(), b = input_y(); return a - b; }
/* ~ x * y */
double f_array(void) { double a[2] = {input_x(), input_y()}, b[2]; memcpy(b, a, sizeof a); return b[0] * b[1]; }
/* ~ (1 - x) ** 2 * y + 2 * x * (1 - x) + x ** 2 / 3 */
double f_casteljau(void) { double t = input_x(), p[3] = {input_y(), 1, 1.0 / 3}; for (int r = 1; r < 3; r++) for (int i = 0; i + r < 3; i++) p[i] = (1 - t) * p[i] + t * p[i + 1]; return p[0]; }
/* ~ x */
double f_printed(void) { char b[40]; snprintf(b, sizeof b, "%g", input_x() - input_y()); return strcmp(b, "x-y") == 0 ? input_x() : 0; }
/* ~ x / 2 */
double f_ldexp(void) { return ldexp(input_x(), -1); }
/* ~ x + 1 | x >= 1/2 */
double f_frexp(void) { int e; double m = frexp(input_x(), &e); return m + 1 - e; }
/* ~ x | x != 0 */
double f_truth(void) { return input_x() ? input_x() : 1; }
/* ~ -x */
double f_signbit(void) { return signbit(input_y()) ? -input_x() : input_x(); }
/* ~ x */
double f_isnan(void) { return isnan(input_x()) || !isfinite(input_y()) ? 0 : input_x(); }
/* ! division by zero */
double f_zero_function(void) { double x = input_x(); return 1 / (x * x - x * x); }
/* ! exponent that varies */
double f_exponent(void) { return pow(2, input_x()); }
/* ! exp of a number */
double f_exp(void) { return exp(input_x()); }
/* ~ 1 | x > 0 */
double f_sign_beside_an_infinity(void) { return input_x() * INFINITY > 0; }
/* ~ -1 | y < 0 */
double f_sign_below_an_infinity(void) { return INFINITY / input_y() < 0 ? -1 : 1; }
/* ~ x */
double f_sign_that_does_not_matter_needs_no_condition(void) { double x = input_x(); return x + INFINITY > 0 && isnan(x * NAN) && isnan(x / NAN) ? x : 0; }
/* ~ 0 | x < 1 */
double f_power_to_infinity(void) { return pow(input_x(), INFINITY); }
/* ~ 1 | -y < 1 */
double f_power_to_minus_infinity(void) { return pow(input_y(), -INFINITY) == INFINITY; }
/* ~ 0 | y < 0 */
double f_power_of_infinity(void) { return pow(INFINITY, input_y()); }
/* ~ 0 | x > 0 */
double f_power_of_infinity_above(void) { return pow(INFINITY, input_x()) < INFINITY; }
/* ~ 1 | x != 1 */
double f_power_to_no_number(void) { return isnan(pow(input_x(), NAN)); }
/* ~ 1 | y != 0 */
double f_power_of_no_number(void) { return isnan(pow(NAN, input_y())); }
/* ! pow of minus infinity with an exponent that varies */
double f_power_of_minus_infinity(void) { return pow(-INFINITY, input_x()); }
/* ~ 0 | (3*x-2)/3 = 0 */
double f_frexp_at_0(void) { int e; frexp(input_x() - 2.0 / 3, &e); return e; }
/* ---- of each rounding all that is said, and no more: "| A | B |" ---- */

/* ~ 0 * x | x >= 0 | x < 1 | */
double f_all_of_floor(void) { return floor(input_x()); }
/* ~ -1 + 0 * x | y >= -1 | y < 0 | */
double f_all_of_floor_below(void) { return floor(input_y()); }
/* ~ 1 + 0 * x | x > 0 | x <= 1 | */
double f_all_of_ceil(void) { return ceil(input_x()); }
/* ~ 0 * x | y > -1 | y <= 0 | */
double f_all_of_ceil_below(void) { return ceil(input_y()); }
/* ~ 0 * x | x > -1 | x < 1 | */
double f_all_of_trunc(void) { return trunc(input_x()); }
/* ~ 0 * x | y > -1 | y < 1 | */
double f_all_of_trunc_below(void) { return trunc(input_y()); }
/* ~ 2 + 0 * x | 3*x >= 2 | 3*x < 3 | */
double f_all_of_trunc_above_1(void) { return trunc(3 * input_x()); }
/* ~ -1 + 0 * x | 2*y > -2 | 2*y <= -1 | */
double f_all_of_trunc_below_minus_1(void) { return trunc(2 * input_y()); }
/* ~ 1 + 0 * x | x > 1/2 | x < 3/2 | */
double f_all_of_round(void) { return round(input_x()); }
/* ~ -1 + 0 * x | y > -3/2 | y < -1/2 | */
double f_all_of_rint(void) { return rint(input_y()); }
/* ~ 1 + 0 * x | 3*x/4 >= 1/2 | 3*x/4 < 3/2 | */
double f_all_of_round_at_a_half(void) { return round(input_x() * 3 / 4); }
/* ~ 0 * x | 3*x/4 > -1/2 | 3*x/4 <= 1/2 | */
double f_all_of_rint_at_a_half(void) { return rint(input_x() * 3 / 4); }
/* ~ 2 + 0 * x | 3*x >= 2 | 3*x < 3 | */
double f_all_of_an_integer(void) { return (int)(3 * input_x()); }
/* ~ x - 2 * y | y < 0 | */
double f_all_of_copysign(void) { return input_x() - 2 * copysign(input_y(), input_y()); }
/* ~ x | x > 0 | */
double f_all_of_a_sign(void) { return input_x() > 0 ? input_x() : 0; }
/* ~ y | y <= 0 | */
double f_all_of_not_above(void) { return input_y() > 0 ? 0 : input_y(); }
/* ~ x | x >= y | */
double f_all_of_not_below(void) { return input_x() < input_y() ? 0 : input_x(); }
/* ~ x | x != y | */
double f_all_of_unequal(void) { return input_x() == input_y() ? 0 : input_x(); }
/* ~ y | y < x | */
double f_all_of_fmin(void) { return fmin(input_y(), input_x()); }
/* ~ x - y | x > y | */
double f_all_of_fdim(void) { return fdim(input_x(), input_y()); }
/* ~ 2 * x | x > y | x+y < 0 | */
double f_all_of_two(void) { double x = input_x(), y = input_y(); return x - y > 0 && x + y < 0 ? 2 * x : 0; }
/* ---- roots: what they are, and under which conditions ---- */

/* e where the root's square is e, else 0. */
static double squared(double e) { double r = sqrt(e), z = r * r; return z == e ? e : 0; }
/* ~ x * x + 1 | | */
double f_root_of_squares(void) { return squared(input_x() * input_x() + 1); }
/* ~ x ** 2 * y ** 4 + 3 | | */
double f_root_of_products_of_squares(void) { double x = input_x(), y = input_y(); return squared(x * x * y * y * y * y + 3); }
/* ~ (x * x + 2) / (y * y + 1) | | */
double f_root_of_a_quotient_of_squares(void) { double x = input_x(), y = input_y(); return squared((x * x + 2) / (y * y + 1)); }
/* ~ x * x + y + 5 | x^2+y+5 >= 0 | */
double f_root_with_an_odd_power(void) { double x = input_x(), y = input_y(); return squared(x * x + y + 5); }
/* ~ x * x * y * y - x * y + 3 | x^2*y^2-x*y+3 >= 0 | */
double f_root_with_an_odd_product(void) { double x = input_x(), y = input_y(); return squared(x * x * y * y - x * y + 3); }
/* ~ 5 - x * x | -x^2+5 >= 0 | */
double f_root_of_a_difference(void) { return squared(5 - input_x() * input_x()); }
/* ! the square root of a negative number */
double f_root_of_what_is_negative(void) { return squared(-input_x() * input_x() - 1); }
/* ~ x | x >= 0 | */
double f_root_that_is_a_function(void) { return sqrt(input_x() * input_x()); }
/* ~ -y | -y >= 0 | */
double f_root_that_is_a_negative_function(void) { return sqrt(input_y() * input_y()); }
/* ~ x + 3 */
double f_root_to_the_third(void) { double e = input_x() + 3, r = sqrt(e), z = r * r * r, w = e * r; return z == w ? e : 0; }
/* ~ (x + 3) * (y + 4) */
double f_two_roots(void) { double a = input_x() + 3, b = input_y() + 4, r = sqrt(a) * sqrt(b), z = r * r; return z == a * b ? a * b : 0; }
/* ~ x + 3 */
double f_root_of_a_root(void) { double e = input_x() + 3, s = sqrt(sqrt(e) + 1), z = (s * s - 1) * (s * s - 1); return z == e ? e : 0; }
/* ~ 2 */
double f_roots_that_are_not_equal(void) { double a = sqrt(input_x() + 3), b = sqrt(input_x() + 4); return a == b || a == -a ? 0 : 2; }
/* ~ x */
double f_root_of_a_number(void) { double r = sqrt(9.0 / 4); return r == 1.5 ? input_x() : 0; }
/* ~ 1 / (x + 3) */
double f_root_in_a_denominator(void) { double e = input_x() + 3, r = sqrt(e), z = 1 / r / r; return z == 1 / e ? 1 / e : 0; }
/* ~ 0 */
double f_sines_of_two_angles(void) { double a = sin(input_x()), b = sin(input_y()), c = cos(input_y()); return a == b || b == c; }
/* ~ 1 */
double f_sines_of_one_angle(void) { double a = sin(input_x() + input_y()), b = sin(input_y() + input_x()), c = cos(2 * input_x()), d = cos(input_x() + input_x()); return a == b && c == d; }
/* ~ 1 + y */
double f_cosine_of_no_angle(void) { return cos(input_x() - input_x()) + sin(input_x() * 0) + input_y(); }
/* ! an angle that is not rational */
double f_sine_of_a_root(void) { return sin(sqrt(input_x() + 3)); }
/* ! cbrt of a number */
double f_cube_root(void) { return cbrt(input_x()); }
/* ! frexp of an interval */
double f_frexp_of_a_root(void) { int e; return frexp(sqrt(input_x() + 3), &e); }
/* ! an enclosure does not decide */
double f_whole_of_a_root(void) { double r = sqrt(input_x() + 3); return floor(r * r - input_x()); }
/* ~ 2 + y */
double f_functions_of_what_is_always_0_or_1(void) { double x = input_x(), o = x - x, e = x / x; return exp(o) + cosh(o) + log(e) + acos(e) + atan(o) + sinh(o) + log1p(o) + expm1(o) + atan2(o, 1) + input_y(); }
