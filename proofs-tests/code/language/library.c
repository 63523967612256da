/* The C library by name. */
#include <complex.h>
#include <errno.h>
#include <fenv.h>
#include <math.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* = F(1, 3) */
double l_fabs(void) { return fabs(-1.0 / 3); }
/* = -7 */
double l_floor(void) { return floor(-20.0 / 3); }
/* = -6 */
double l_ceil(void) { return ceil(-20.0 / 3); }
/* = -6 */
double l_trunc(void) { return trunc(-20.0 / 3); }
/* = -4 */
double l_round(void) { return round(-7.0 / 2); }
/* = 2 */
double l_rint_to_even(void) { return rint(5.0 / 2); }
/* = 4 */
double l_nearbyint(void) { return nearbyint(7.0 / 2); }
/* = 3 */
double l_lround(void) { return lround(5.0 / 2); }
/* = 2 */
double l_lrint(void) { return lrint(5.0 / 2); }
/* = F(1, 3) */
double l_fmin(void) { return fmin(1.0 / 3, 1.0 / 2); }
/* = F(1, 2) */
double l_fmax(void) { return fmax(fmax(1.0 / 3, NAN), 1.0 / 2); }
/* = F(1, 6) */
double l_fdim(void) { return fdim(1.0 / 2, 1.0 / 3) + fdim(0, 1); }
/* = -F(1, 3) */
double l_copysign(void) { return copysign(1.0 / 3, -2); }
/* = F(1, 3) * F(1, 5) + F(1, 7) */
double l_fma(void) { return fma(1.0 / 3, 1.0 / 5, 1.0 / 7); }
/* = F(1, 3) * 2 ** 70 */
double l_ldexp(void) { return ldexp(1.0 / 3, 70); }
/* = F(1, 3) / 8 */
double l_scalbn(void) { return scalbn(1.0 / 3, -3); }
/* = F(2, 3) + 100 * -1 */
double l_frexp(void) { int e; double m = frexp(1.0 / 3, &e); return m + 100 * e; }
/* = F(1, 2) + 100 * 4 */
double l_frexp_of_a_power(void) { int e; double m = frexp(8, &e); return m + 100 * e; }
/* = -F(2, 3) + 100 * -6 */
double l_modf(void) { double w, f = modf(-20.0 / 3, &w); return f + 100 * w; }
/* = F(2, 3) */
double l_fmod(void) { return fmod(20.0 / 3, 2); }
/* = -F(1, 3) */
double l_remainder(void) { return remainder(17.0 / 3, 2); }
/* = F(2, 3) ** 7 */
double l_pow(void) { return pow(2.0 / 3, 7); }
/* = F(3, 2) ** 3 */
double l_pow_negative(void) { return pow(2.0 / 3, -3); }
/* = 1 */
double l_pow_zero(void) { return pow(2.0 / 3, 0); }
/* = F(2, 3) */
double l_pow_half(void) { return pow(4.0 / 9, 0.5); }
/* = F(3, 7) */
double l_sqrt(void) { return sqrt(9.0 / 49); }
/* = F(3, 7) */
double l_sqrtf(void) { return sqrtf(9.0f / 49); }
/* = -F(3, 7) */
double l_cbrt(void) { return cbrt(-27.0 / 343); }
/* = F(5, 12) */
double l_hypot(void) { return hypot(1.0 / 4, 1.0 / 3); }
/* = 1 */
double l_exp_of_zero(void) { return exp(1.0 / 3 - 2.0 / 6); }
/* = 0 */
double l_log_of_one(void) { return log(3 * (1.0 / 3)); }
/* = F(1, 1024) */
double l_exp2(void) { return exp2(-10); }
/* = -10 */
double l_log2(void) { return log2(1.0 / 1024); }
/* = 3 */
double l_log10(void) { return log10(1000); }
/* = 1 */
double l_sin_and_cos_of_zero(void) { return sin(0) + cos(0); }
/* = 0 */
double l_atan2_of_zero(void) { return atan2(0, 1.0 / 3); }
/* = F(1, 3) ** 2 */
double l_pointer_to_a_library_function(void) { double (*f)(double) = fabs; double x = f(-1.0 / 3); return x * x; }
/* = F(1, 3) */
double l_fabsf(void) { return fabsf(-1.0f / 3); }
/* = 6 */
double l_floorf(void) { return floorf(20.0f / 3); }
/* = F(1, 5) */
double l_fminf(void) { return fminf(1.0f / 5, 1.0f / 3); }
/* = 1 */
double l_snprintf(void) { char b[40]; snprintf(b, sizeof b, "%g %5d|%-6s|%c", 1.0 / 3, 42, "ab", 'x'); return strcmp(b, "1/3    42|ab    |x") == 0; }
/* = 1 */
double l_sprintf_width(void) { char b[40]; sprintf(b, "[%8.3f][%-6g]", 1.0 / 7, 2.0 / 3); return strcmp(b, "[     1/7][2/3   ]") == 0; }
/* = 1 */
double l_printf_of_integers(void) { char b[60]; snprintf(b, sizeof b, "%ld %llu %zu %x %%", -5l, 7ull, (size_t)9, 255u); return strcmp(b, "-5 7 9 ff %") == 0; }
/* = 1 */
double l_printf_of_zeros(void) { char b[40]; snprintf(b, sizeof b, "%05d %04x %03ld", 42, 255u, -7l); return strcmp(b, "00042 00ff -07") == 0; }
/* = 5 + 100 * 3 + 10000 * 7 */
double l_printf_counts(void) { char b[40]; FILE *f = tmpfile(); int n = fprintf(f, "%d%s", 12, "abc"); fclose(f); return n + 100 * snprintf(b, sizeof b, "%g", 1.0 / 3) + 10000 * snprintf(b, 3, "%s", "seventh"); }
/* = 1 */
double l_printf_star(void) { char b[40]; snprintf(b, sizeof b, "%*d %s", 5, 3, "y"); return strcmp(b, "    3 y") == 0; }
/* = 1 */
double l_printf_infinity(void) { char b[40]; snprintf(b, sizeof b, "%g", -INFINITY); return strcmp(b, "-inf") == 0; }
/* = F(0.1) */
double l_strtod(void) { return strtod("0.1", NULL); }
/* = F(5, 2) */
double l_atof(void) { return atof("2.5"); }
/* = F(7, 4) */
double l_sscanf(void) { double x; return sscanf("1.75", "%lf", &x) == 1 ? x : 0; }
/* = 3 */
double l_abs(void) { return abs(-3); }
/* = 1 */
double l_memcmp_of_texts(void) { return memcmp("abcdefgh", "abcdefgh", 8) == 0; }
/* = F(2, 3) */
double l_builtin(void) { return __builtin_fabs(-2.0 / 3); }
/* = 2 */
double l_strings(void) { char b[20]; strcpy(b, "a"); strcat(b, "b"); return strlen(b); }
void sincos(double, double *, double *);
int __isnan(double), __isinf(double), __finite(double), __signbit(double), finite(double);
double roundeven(double);
/* = 10 */
double l_sincos(void) { double s, c; sincos(0, &s, &c); return s + 10 * c; }
/* = 1 + 10 + 100 + 1000 + 10000 */
double l_what_is_no_number(void) { double n = NAN; return (isnan)(n) + 10 * __isnan(n) + 100 * !(isnan)(1.0) + 1000 * !(isinf)(n) + 10000 * !finite(n); }
/* = 1 - 10 + 100 + 1000 */
double l_what_is_infinite(void) { double x = INFINITY; return (isinf)(x) + 10 * __isinf(-x) + 100 * __finite(2) + 1000 * (__signbit(-2) != 0); }
/* = 1 + 2 + 4 + 8 + 16 + 32 */
double l_with_an_infinity(void)
{
    volatile double x = INFINITY;
    return (x + 1 > 5) + 2 * (-x < 0) + 4 * (1 / x == 0) + 8 * (x - 1 == x) + 16 * (x * 2 == x) + 32 * (fabs(-x) == x);
}
/* = 3 - 4 */
double l_llround(void) { return llround(5.0 / 2) + llround(-7.0 / 2); }
/* = 2 - 4 */
double l_llrint(void) { return llrint(5.0 / 2) + llrint(-7.0 / 2); }
/* = 2 - 4 */
double l_roundeven(void) { return roundeven(5.0 / 2) + roundeven(-7.0 / 2); }
/* = F(3, 8) + F(1, 4) */
double l_fmaf(void) { return fmaf(0.75f, 0.5f, 0.25f); }
/* = 6 */
double l_ldexpf(void) { return ldexpf(0.75f, 3); }
/* = F(1, 3) - 10 * F(1, 5) */
double l_conj(void) { double _Complex z = __builtin_complex(1.0 / 3, 1.0 / 5); z = __builtin_conj(z); return __real__ z + 10 * __imag__ z; }
/* = 7 */
double l_posix_memalign(void) { void *p = NULL; int bad = posix_memalign(&p, 3, 8), good = posix_memalign(&p, 64, 8); double r = (bad != 0) + 2 * (good == 0) + 4 * ((unsigned long)p % 64 == 0); free(p); return r; }
/* = 1 */
double l_prints(void) { printf("%d numbers, the first %g, at %p\n", 2, 1.0 / 3, NULL); fprintf(stderr, "%g\n", 0.5); return 1; }
/* = F(20, 3) + F(-1, 7) */
double l_rest_of_what_an_infinity_divides(void) { return fmod(20.0 / 3, INFINITY) + remainder(-1.0 / 7, -INFINITY); }
/* = 1 */
double l_modf_of_an_infinity(void) { double w, f = modf(-INFINITY, &w); return f + (w < 0 && isinf(w)); }
/* = 11 */
double l_fdim_of_no_number(void) { return (isnan(fdim(NAN, 1.0 / 3)) != 0) + 10 * (isnan(fdim(1.0 / 3, NAN)) != 0); }
/* = 1 + 2 + 4 + 8 + 16 + 32 */
double l_no_number_beside_another(void)
{
    volatile double none = NAN, x = 1.0 / 3;
    return (isnan(atan2(0, none)) != 0) + 2 * (isnan(atan2(none, x)) != 0) + 4 * (hypot(none, -INFINITY) == INFINITY) + 8 * (pow(1, none) == 1) +
           16 * (pow(none, 0) == 1) + 32 * (isnan(pow(none, x)) && isnan(pow(x, none)) && isnan(hypot(none, x)));
}
/* = 1 + 2 + 4 + 8 + 16 + 32 + 64 */
double l_powers_beside_an_infinity(void)
{
    volatile double x = INFINITY, near = 1 - 1.0 / 1000000000 / 1000000000;
    return (pow(near, x) == 0) + 2 * (pow(-near, -x) == x) + 4 * (pow(-1, x) == 1) + 8 * (pow(1 / near, x) == x) + 16 * (pow(-x, 3) == -x) +
           32 * (pow(-x, 4) == x && pow(-x, 1.0 / 3) == x) + 64 * (pow(x, -1.0 / 3) == 0 && pow(-x, -3) == 0);
}
double llvm_minimum(double, double) __asm__("llvm.minimum.f64"), llvm_maximum(double, double) __asm__("llvm.maximum.f64");
float llvm_minimumf(float, float) __asm__("llvm.minimum.f32");
/* = 1 + 2 + 4 + 8 + 16 */
double l_minimum_passes_on_what_is_no_number(void)
{
    volatile double none = NAN, x = 1.0 / 3, y = 1.0 / 5;
    return (isnan(llvm_minimum(none, x)) != 0) + 2 * (isnan(llvm_maximum(x, none)) != 0) + 4 * (isnan(llvm_minimumf(x, none)) != 0) +
           8 * (llvm_minimum(x, y) == y && llvm_minimum(y, x) == y) + 16 * (llvm_maximum(x, y) == x && llvm_maximum(y, x) == x);
}
/* = 1 + 2 + 4 + 8 + 16 */
double l_minimum_knows_a_negative_zero(void)
{
    volatile double negative = -0.0, positive = 0.0;
    return !!signbit(llvm_minimum(negative, positive)) + 2 * !!signbit(llvm_minimum(positive, negative)) + 4 * !signbit(llvm_maximum(negative, positive)) +
           8 * !signbit(llvm_maximum(positive, negative)) + 16 * (llvm_minimum(negative, -1) == -1 && llvm_maximum(1, negative) == 1);
}
/* ---- each function on both sides of 0, at whole numbers and halves, and where it is exact ---- */

/* = sum((k + 20) * math.floor(F(k, 4)) for k in range(-14, 15)) */
double l_floors(void) { double s = 0; for (int k = -14; k < 15; k++) s += (k + 20) * floor(k / 4.0); return s; }
/* = sum((k + 20) * math.ceil(F(k, 4)) for k in range(-14, 15)) */
double l_ceils(void) { double s = 0; for (int k = -14; k < 15; k++) s += (k + 20) * ceil(k / 4.0); return s; }
/* = sum((k + 20) * math.trunc(F(k, 4)) for k in range(-14, 15)) */
double l_truncs(void) { double s = 0; for (int k = -14; k < 15; k++) s += (k + 20) * trunc(k / 4.0); return s; }
/* = sum((k + 20) * (1 if k > 0 else -1) * math.floor(abs(F(k, 4)) + F(1, 2)) for k in range(-14, 15)) */
double l_rounds(void) { double s = 0; for (int k = -14; k < 15; k++) s += (k + 20) * round(k / 4.0); return s; }
/* = sum((k + 20) * round(F(k, 4)) for k in range(-14, 15)) */
double l_rints(void) { double s = 0; for (int k = -14; k < 15; k++) s += (k + 20) * rint(k / 4.0); return s; }
/* = sum((k + 20) * round(F(k, 4)) for k in range(-14, 15)) */
double l_nearbyints(void) { double s = 0; for (int k = -14; k < 15; k++) s += (k + 20) * nearbyint(k / 4.0); return s; }
/* = sum((k + 20) * round(F(k, 4)) for k in range(-14, 15)) */
double l_roundevens(void) { double s = 0; for (int k = -14; k < 15; k++) s += (k + 20) * roundeven(k / 4.0); return s; }
/* = sum((k + 20) * (1 if k > 0 else -1) * math.floor(abs(F(k, 4)) + F(1, 2)) * 2 for k in range(-14, 15)) */
double l_lrounds(void) { double s = 0; for (int k = -14; k < 15; k++) s += (k + 20) * (double)(lround(k / 4.0) + llround(k / 4.0)); return s; }
/* = sum((k + 20) * round(F(k, 4)) * 2 for k in range(-14, 15)) */
double l_lrints(void) { double s = 0; for (int k = -14; k < 15; k++) s += (k + 20) * (double)(lrint(k / 4.0) + llrint(k / 4.0)); return s; }
/* ! range of a signed integer of 64 bits */
double l_lround_of_what_is_too_large(void) { return (double)lround(0x1p63); }
/* = sum(3 ** (k + 7) * math.fmod(k, 2) + 5 ** (k + 7) * math.fmod(k, -2) for k in range(-7, 8)) */
double l_fmods(void) { double s = 0; for (int k = -7; k < 8; k++) s += pow(3, k + 7) * fmod(k, 2) + pow(5, k + 7) * fmod(k, -2); return s; }
/* = sum(3 ** (k + 7) * int(math.remainder(k, 2)) + 5 ** (k + 7) * int(math.remainder(k, -4)) for k in range(-7, 8)) */
double l_remainders(void) { double s = 0; for (int k = -7; k < 8; k++) s += pow(3, k + 7) * remainder(k, 2) + pow(5, k + 7) * remainder(k, -4); return s; }
/* ! a division by zero */
double l_fmod_by_zero(void) { return fmod(1.0 / 3, 0); }
/* = 1 + 2 + 4 */
double l_rest_of_an_infinity(void) { return !!isnan(fmod(INFINITY, 2)) + 2 * !!isnan(remainder(-INFINITY, 1.0 / 3)) + 4 * !!isnan(fmod(1.0 / 3, NAN)); }
/* = F(1, 3) + 10 * F(1, 3) + 100 * F(1, 3) + 1000 * F(1, 3) */
double l_least_and_greatest_beside_no_number(void) { double x = 1.0 / 3; return fmin(NAN, x) + 10 * fmin(x, NAN) + 100 * fmax(NAN, x) + 1000 * fmax(x, NAN); }
/* = 1 + 2 */
double l_least_and_greatest_of_no_numbers(void) { return !!isnan(fmin(NAN, NAN)) + 2 * !!isnan(fmax(NAN, NAN)); }
/* = F(-1, 2) + 10 * F(-1, 3) + 100 * F(-1, 2) + 1000 * F(1, 3) */
double l_least_and_greatest_either_way(void) { double a = -1.0 / 2, b = 1.0 / 3; return fmin(a, b) + 10 * fmax(a, -b) + 100 * fmin(-b, a) + 1000 * fmax(b, a); }
/* = F(1, 3) + 1 */
double l_least_and_greatest_beside_an_infinity(void) { double x = 1.0 / 3; return fmin(INFINITY, x) + (fmax(x, INFINITY) > 1e300) + 10 * fmax(-INFINITY, x) - 10 * x; }
/* = F(5, 6) */
double l_fdim_either_way(void) { return fdim(1.0 / 3, -1.0 / 2) + 10 * fdim(-1.0 / 2, 1.0 / 3) + 100 * fdim(1.0 / 3, 1.0 / 3) + 1000 * fdim(-INFINITY, 2); }
/* = F(1, 3) - 10 * F(1, 3) + 100 * F(1, 3) - 1000 * F(1, 3) */
double l_copysigns(void) { double x = 1.0 / 3; return copysign(-x, 2) + 10 * copysign(x, -0.0) + 100 * copysign(-x, 0) + 1000 * copysign(-x, -x); }
/* = -F(1, 3) + 10 + 100 */
double l_copysign_and_infinities(void) { return copysign(1.0 / 3, -INFINITY) + 10 * (copysign(INFINITY, -1.0 / 3) < 0) + 100 * (copysign(-INFINITY, 1.0 / 3) > 0); }
/* = F(8, 27) + 10 * F(9, 4) */
double l_powers_of_floats(void) { return powf(2.0f / 3, 3) + 10 * powf(3, 2) / 4; }
/* = F(2, 3) - 10 * F(5, 3) + 100 * F(1, 6) + 1000 * F(5, 3) */
double l_two_floats(void) { return fmodf(20.0f / 3, 2) + 10 * copysignf(5.0f / 3, -2) + 100 * fdimf(1.0f / 2, 1.0f / 3) + 1000 * (fmaxf(5.0f / 3, 1) + atan2f(0, 2)); }
/* = F(-1, 3) + 10 * F(5, 12) + 100 * F(-1, 2) */
double l_more_floats(void) { return remainderf(17.0f / 3, 2) + 10 * hypotf(1.0f / 4, 1.0f / 3) + 100 * fminf(1.0f / 3, -1.0f / 2); }
/* = -F(8, 27) + 10 * F(9, 16) + 100 + 1000 + 10000 */
double l_powers(void) { return pow(-2.0 / 3, 3) + 10 * pow(-4.0 / 3, -2) + 100 * pow(1, 1.0 / 3) + 1000 * pow(0, 0) + 10000 * pow(NAN, 0); }
/* ! a division by zero */
double l_negative_power_of_zero(void) { return pow(0, -1); }
/* ! neither whole nor 1/2 */
double l_power_of_minus_a_half(void) { return pow(4.0 / 9, -0.5); }
/* ! neither whole nor 1/2 */
double l_power_of_three_halves(void) { return pow(4.0 / 9, 1.5); }
/* = 5 + 10 + 100 + 1000 */
double l_hypots(void) { return hypot(-3, -4) + 10 * isinf(hypot(-INFINITY, 1.0 / 3)) + 100 * isinf(hypot(1.0 / 3, INFINITY)) + 1000 * isinf(hypot(NAN, -INFINITY)); }
/* ! atan2 outside the right half-plane */
double l_atan2_above_the_origin(void) { return atan2(1.0 / 3, 0); }
/* ! atan2 outside the right half-plane */
double l_atan2_to_the_left(void) { return atan2(0, -1.0 / 3); }
/* = 0 */
double l_functions_that_are_0_at_0(void) { double x = 1.0 / 3 - 2.0 / 6; return expm1(x) + log1p(x) + tan(x) + asin(x) + atan(x) + sinh(x) + tanh(x) + sin(x) + cbrt(x) + sqrt(x); }
/* = 1 + 10 + 100 + 1000 */
double l_functions_that_are_1_at_0(void) { double x = 1.0 / 3 - 2.0 / 6; return cosh(x) + 10 * cos(x) + 100 * exp(x) + 1000 * exp2(x); }
/* = 0 */
double l_functions_that_are_0_at_1(void) { double x = 1.0 / 3 * 3; return acos(x) + log(x) + log2(x) + log10(x); }
/* ! acos of a number for which it is not rational */
double l_acos_of_0(void) { return acos(0); }
/* ! log1p of a number for which it is not rational */
double l_log1p_of_1(void) { return log1p(1); }
/* ! log2 of a number for which it is not rational */
double l_log2_of_6(void) { return log2(6); }
/* ! log10 of a number for which it is not rational */
double l_log10_of_8(void) { return log10(8); }
/* ! log2 of a number for which it is not rational */
double l_log2_of_0(void) { return log2(0); }
/* ! exp2 of a number for which it is not rational */
double l_exp2_of_a_third(void) { return exp2(1.0 / 3); }
/* ! cbrt of a number for which it is not rational */
double l_cbrt_of_4(void) { return cbrt(4); }
/* = 8 + 10 * F(1, 2) + 100 * 5 + 1000 * -3 */
double l_powers_and_logarithms(void) { return exp2(3) + 10 * exp2(-1) + 100 * log2(32) + 1000 * log10(1.0 / 1000); }
/* = F(3, 2) - 10 * F(1, 2) */
double l_cube_roots(void) { return cbrt(27.0 / 8) + 10 * cbrt(-1.0 / 8); }
/* = 1 + 10 + 100 + 1000 + 10000 */
double l_functions_of_infinities(void) { return (exp(-INFINITY) == 0) + 10 * (tanh(INFINITY) == 1) + 100 * (log(INFINITY) == INFINITY) + 1000 * (cbrt(-INFINITY) < 0) + 10000 * !!isnan(sin(INFINITY)); }
/* ! atan of an infinity */
double l_atan_of_an_infinity(void) { return atan(INFINITY); }
/* = F(32, 3) + 10 * F(-3, 8) + 100 * F(1, 3) + 1000 */
double l_scales(void) { return scalbln(1.0 / 3, 5l) + 10 * ldexpf(-3.0f, -3) + 100 * scalbn(1.0 / 3, 0) + 1000 * ldexp(ldexp(1, 100000), -100000); }
/* ! a power of two beyond 2^100000 */
double l_scale_that_is_too_large(void) { return ldexp(1, 100001); }
/* ! a power of two beyond 2^100000 */
double l_scale_that_is_too_small(void) { return scalbln(1, -100001); }
static double parts(double x) { int e = 7; double m = frexp(x, &e); return m + 100 * e; }
/* = F(1, 2) - 100 + 1000 * (F(-3, 4) + 200) + 10 ** 6 * (F(2, 3) + 100) + 10 ** 9 * (F(1, 2) + 100) */
double l_parts_of_numbers(void) { return parts(1.0 / 4) + 1000 * parts(-3) + 1e6 * parts(4.0 / 3) + 1e9 * parts(1); }
/* = 0 */
double l_parts_of_zero(void) { return parts(1.0 / 3 - 2.0 / 6); }
static double cut(double x) { double w = 7, f = modf(x, &w); return f + 100 * w; }
/* = F(2, 3) + 600 + 10 ** 4 * 500 + 10 ** 8 * F(1, 2) */
double l_whole_parts(void) { return cut(20.0 / 3) + 1e4 * cut(5) + 1e8 * cut(1.0 / 2); }
/* = 1 + 10 */
double l_whole_part_of_no_number(void) { double w = 7, f = modf(NAN, &w); return !!isnan(f) + 10 * !!isnan(w); }
/* = F(1, 15) - F(1, 7) + 10 * (F(-1, 15) + F(1, 7)) */
double l_fma_with_signs(void) { return fma(1.0 / 3, 1.0 / 5, -1.0 / 7) + 10 * fma(1.0 / 3, -1.0 / 5, 1.0 / 7); }
/* = 1 + 10 + 100 */
double l_fma_with_infinities(void) { return isinf(fma(INFINITY, 2, 1)) + 10 * !!isnan(fma(INFINITY, 2, -INFINITY)) + 100 * isinf(fma(1, 2, INFINITY)); }
/* = 3 + 10 * 2 - 100 * 2 + 1000 * 0 + 10000 * -1 */
double l_exponents(void) { return logb(8) + 10 * ilogb(-5) + 100 * logb(1.0 / 4) + 1000 * ilogb(1) + 10000 * logbf(2.0f / 3); }
/* ! the exponent of 0 or of what is no number */
double l_exponent_of_an_infinity(void) { return ilogb(INFINITY); }
/* = 0 */
double l_rounding_to_the_nearest_is_no_other(void) { return fesetround(FE_TONEAREST); }
/* ! another direction of rounding */
double l_rounding_towards_0(void) { return fesetround(FE_TOWARDZERO); }
/* = 1 + 10 + 100 + 1000 + 10000 */
double l_what_is_no_infinity(void) { return ((isinf)(1.0 / 3) == 0) + 10 * ((isnan)(INFINITY) == 0) + 100 * (finite(1.0 / 3) != 0) + 1000 * (__finite(NAN) == 0) + 10000 * (__finite(-INFINITY) == 0); }
/* = 1 + 10 + 100 + 1000 + 10000 */
double l_what_is_below_zero(void) { return (__signbit(2) == 0) + 10 * (__signbit(-0.0) != 0) + 100 * (__signbit(-INFINITY) != 0) + 1000 * (__signbit(INFINITY) == 0) + 10000 * (__isnan(1.0 / 3) == 0); }
static double both(double complex z) { return creal(z) + 100 * cimag(z); }
static double both_f(float complex z) { return crealf(z) + 100 * cimagf(z); }
/* = -F(1, 3) - 100 * F(1, 5) + 10 ** 4 * (F(1, 3) + 100 * F(1, 5)) */
double l_conjugates(void) { double complex z = __builtin_complex(1.0 / 3, 1.0 / 5); return both(-z) + 1e4 * both(conj(conj(z))); }
/* = F(1, 3) - 100 * F(1, 5) + 10 ** 4 * (F(1, 3) - 100 * F(1, 5)) */
double l_one_conjugate(void) { return both(conj(__builtin_complex(1.0 / 3, 1.0 / 5))) + 1e4 * both_f(conjf(__builtin_complex(1.0f / 3, 1.0f / 5))); }
/* = F(5, 3) + F(10, 3) */
double l_amounts_of_complex_numbers(void) { return cabs(__builtin_complex(-1.0, 4.0 / 3)) + cabsf(__builtin_complex(2.0f, -8.0f / 3)); }
/* = F(1, 21) - F(1, 55) + 100 * (F(1, 33) + F(1, 35)) */
double l_product_of_complex_numbers(void) { double complex a = __builtin_complex(1.0 / 3, 1.0 / 5), b = __builtin_complex(1.0 / 7, 1.0 / 11); return both(a * b); }
/* = (F(1, 21) + F(1, 55) + 100 * (F(1, 35) - F(1, 33))) / (F(1, 49) + F(1, 121)) */
double l_quotient_of_complex_numbers(void) { double complex a = __builtin_complex(1.0 / 3, 1.0 / 5), b = __builtin_complex(1.0 / 7, 1.0 / 11); return both(a / b); }
/* = F(1, 21) - F(1, 55) + 100 * (F(1, 33) + F(1, 35)) */
double l_product_of_complex_floats(void) { float complex a = __builtin_complex(1.0f / 3, 1.0f / 5), b = __builtin_complex(1.0f / 7, 1.0f / 11); return both_f(a * b); }
/* = (F(1, 21) + F(1, 55) + 100 * (F(1, 35) - F(1, 33))) / (F(1, 49) + F(1, 121)) */
double l_quotient_of_complex_floats(void) { float complex a = __builtin_complex(1.0f / 3, 1.0f / 5), b = __builtin_complex(1.0f / 7, 1.0f / 11); return both_f(a / b); }
/* = 2 + 100 + 10 ** 4 * (2 - 100) + 10 ** 8 * (1 + 200) + 10 ** 12 * 200 + 10 ** 16 * F(3, 2) */
double l_roots_of_complex_numbers(void) { return both(csqrt(__builtin_complex(3.0, 4.0))) + 1e4 * both(csqrt(__builtin_complex(3.0, -4.0))) + 1e8 * both(csqrt(__builtin_complex(-3.0, 4.0))) + 1e12 * both(csqrt(__builtin_complex(-4.0, 0.0))) + 1e16 * both(csqrt(__builtin_complex(9.0 / 4, 0.0))); }

/* ---- texts ---- */

static double printed(const char *wanted, const char *format, ...)
{
    char text[300], other[300];
    va_list list, again;
    va_start(list, format);
    va_copy(again, list);
    int n = vsnprintf(text, sizeof text, format, list), m = vsprintf(other, format, again);
    va_end(list);
    va_end(again);
    return strcmp(text, wanted) == 0 && strcmp(other, wanted) == 0 && n == (int)strlen(wanted) && m == n;
}
/* = 7 */
double l_conversions_of_numbers(void)
{
    double x = -1.0 / 3;
    return printed("-1/3 -1/3 -1/3 -1/3 -1/3 -1/3 -1/3 -1/3", "%a %A %e %E %f %F %g %G", x, x, x, x, x, x, x, x) +
           2 * printed("[    -1/3][-1/3    ][-1/3][-1/3]", "[%8.3f][%-8e][%.17g][%2g]", x, x, x, x) +
           4 * printed("[    -1/3][-1/3    ]", "[%*.*f][%-*g]", 8, 3, x, 8, x);
}
/* = 3 */
double l_conversions_of_infinities(void) { return printed("[    inf][-inf   ][nan]", "[%7g][%-7f][%e]", INFINITY, -INFINITY, NAN) + 2 * printed("INF", "%G", INFINITY); }
/* = 7 */
double l_conversions_of_integers(void)
{
    return printed("-5 -6 -7 -8 9 10 11 12", "%hhd %hd %d %ld %lld %jd %zd %td", -5, -6, -7, -8l, 9ll, (intmax_t)10, (size_t)11, (ptrdiff_t)12) +
           2 * printed("4294967291 377 ff FF 0xff +3  3", "%u %o %x %X %#x %+d % d", -5, 255, 255, 255, 255, 3, 3) +
           4 * printed("-9223372036854775807 18446744073709551615 7", "%ld %llu %i", INT64_MIN + 1, UINT64_MAX, 7);
}
/* = 7 */
double l_conversions_of_texts(void) { return printed("[ab][   ab][ab   ][a]%[x][  x]", "[%s][%5s][%-5s][%.1s]%%[%c][%3c]", "ab", "ab", "ab", "ab", 'x', 'x') + 2 * printed("", "") + 4 * printed("[-5   ][    7]", "[%*d][%*d]", -5, -5, 5, 7); }
/* = 1 */
double l_long_texts(void)
{
    char wanted[300] = "", format[] = "%s%g,%g,%g,%g,%g,%g,%g,%g,%g,%g;%s";
    for (int k = 0; k < 40; k++)
        strcat(wanted, "ab");
    char ab[100];
    strcpy(ab, wanted);
    for (int k = 1; k <= 10; k++)
        sprintf(wanted + strlen(wanted), "1/%d%c", k + 1, k < 10 ? ',' : ';');
    strcat(wanted, ab);
    return printed(wanted, format, ab, 1.0 / 2, 1.0 / 3, 1.0 / 4, 1.0 / 5, 1.0 / 6, 1.0 / 7, 1.0 / 8, 1.0 / 9, 1.0 / 10, 1.0 / 11, ab);
}
/* = 7 + 10 * 7 + 100 * 7 + 1000 * 7 */
double l_texts_that_have_no_room(void)
{
    char a[9] = "????????", b[9] = "????????", c[9] = "????????", d[9] = "????????", e[9] = "????????";
    int n = snprintf(a, 3, "%s", "seventh"), m = snprintf(b, 0, "%s", "seventh"), l = snprintf(c, 7, "%s", "seventh"), k = snprintf(d, 8, "%s", "seventh");
    int good = snprintf(e, 1, "%s", "seventh") == 7 && e[0] == 0 && e[1] == '?' && strcmp(a, "se") == 0 && a[3] == '?' && b[0] == '?' && strcmp(c, "sevent") == 0 && c[7] == '?' && strcmp(d, "seventh") == 0;
    return good ? n + 10 * m + 100 * l + 1000 * k : 0;
}
static int all_of(FILE *f, const char *format, ...) { va_list list; va_start(list, format); int n = vfprintf(f, format, list); va_end(list); return n; }
static int to_output(const char *format, ...) { va_list list; va_start(list, format); int n = vprintf(format, list); va_end(list); return n; }
/* = 8 + 10 * 3 + 100 * 4 + 1000 * 5 */
double l_counts_of_what_is_printed(void)
{
    char text[20] = "";
    FILE *f = tmpfile();
    int n = all_of(f, "%g and %d", 1.0 / 3, 7) - 2;
    rewind(f);
    char *got = fgets(text, sizeof text, f);
    fclose(f);
    return got != NULL && strcmp(text, "1/3 and 7") == 0 ? n + 1 + 10 * printf("%g", 1.0 / 7) + 100 * sprintf(text, "%g", -1.0 / 7) + 1000 * to_output("%d,%g", 1, 1.0 / 3) : 0;
}
/* The number, and 100 times how far the text was read. */
static double read_from(const char *text) { char *end; double x = strtod(text, &end); return x + 100 * (double)(end - text); }
static double read_float(const char *text) { char *end; float x = strtof(text, &end); return x + 100 * (double)(end - text); }
/* = F(1, 3) + 300 + 1000 * (F(-22, 7) + 700) + 10 ** 6 * (F(5, 2) + 400) */
double l_fractions_that_are_read(void) { return read_from("1/3") + 1000 * read_from(" \t-22/7/2") + 1e6 * read_from("+5/2x"); }
/* = 1 + 100 + 1000 * (1 + 100) + 10 ** 6 * (F(1, 4) + 400) + 10 ** 9 * (16 + 400) + 10 ** 12 * 0 */
double l_what_is_read_and_is_no_fraction(void) { return read_from("1/x") + 1000 * read_from("1 /3") + 1e6 * read_from("0.25/3") + 1e9 * read_from("0x10/3") + 1e12 * read_from("/3"); }
/* = F(1, 3) + 300 + 1000 * (F(1, 4) + 400) + 10 ** 6 * (F(-12, 5) + 500) + 10 ** 9 * 101 */
double l_floats_that_are_read(void) { return read_float("1/3") + 1000 * read_float("0.25/3") + 1e6 * read_float("-12/5.") + 1e9 * read_float("1/"); }
/* ! a division by zero */
double l_fraction_of_zero(void) { return strtod("1/0", NULL); }
/* ! scanf of a fraction */
double l_scanf_of_a_fraction_behind_an_integer(void) { int n; double x; return sscanf("7 1/3", "%d %lf", &n, &x); }
/* ! scanf of a fraction */
double l_scanf_of_a_fraction_before_an_integer(void) { int n; float x; return sscanf("1/3 7", "%f %d", &x, &n); }
/* = 1 + 10 * 2 + 100 */
double l_scanf_of_no_fraction(void) { int n = 0, m = 0; double x = 0; char s[9]; return sscanf("1/3", "%d", &n) + 10 * sscanf("a/b 0.5", "%s %lf", s, &x) + 100 * (n == 1 && x == 0.5 && m == 0); }
/* = 2 + 10 * 12 + 100 * 5 */
double l_fscanf_of_a_date(void) { FILE *f = tmpfile(); int d, m; fputs("12/5", f); rewind(f); int n = fscanf(f, "%d", &d) + fscanf(f, "/%d", &m); fclose(f); return n + 10 * d + 100 * m; }
/* = F(1, 2) + F(1, 4) */
double l_fscanf_of_two(void) { FILE *f = tmpfile(); double x, y; fputs("0.5 0.25", f); rewind(f); int n = fscanf(f, "%lf", &x) + fscanf(f, "%lf", &y); fclose(f); return n == 2 ? x + y : 0; }

/* ---- memory ---- */

/* = 1 + 2 + 4 + 8 + 16 + 32 */
double l_memory_that_there_is_not(void)
{
    double *kept = malloc(8), *p = kept;
    *kept = 1.0 / 3;
    int is_none = malloc(SIZE_MAX - 100) == NULL, all = calloc(SIZE_MAX / 8 + 2, 8) == NULL, again = realloc(kept, SIZE_MAX / 2) == NULL;
    int array = reallocarray(kept, SIZE_MAX / 8 + 2, 8) == NULL, odd = aligned_alloc(24, 48) == NULL && aligned_alloc(4, 16) == NULL;
    void *other = kept;
    int codes = posix_memalign(&other, 24, 8) == EINVAL && posix_memalign(&other, 4, 8) == EINVAL && posix_memalign(&other, 16, SIZE_MAX / 2) == ENOMEM && other == kept;
    return *p * 3 == 1 ? is_none + 2 * all + 4 * again + 8 * array + 16 * odd + 32 * codes : 0;
}
/* = 1 + 2 + 4 + 8 */
double l_memory_is_aligned(void)
{
    void *p;
    int good = posix_memalign(&p, 128, 8) == 0 && (uintptr_t)p % 128 == 0;
    return good + 2 * ((uintptr_t)aligned_alloc(256, 512) % 256 == 0) + 4 * ((uintptr_t)valloc(8) % 4096 == 0) + 8 * ((uintptr_t)aligned_alloc(8, 8) % 8 == 0);
}
/* = 15 */
double l_memory_of_realloc(void)
{
    int *p = realloc(NULL, 3 * sizeof *p), s = 0;
    for (int k = 0; k < 3; k++)
        p[k] = k + 4;
    p = realloc(p, 1000 * sizeof *p);
    for (int k = 0; k < 3; k++)
        s += p[k];
    p = realloc(p, 2 * sizeof *p);
    free(NULL);
    return p[0] == 4 && p[1] == 5 ? s : 0;
}
/* ! given back */
double l_memory_before_realloc(void) { double *p = malloc(8), *q; *p = 1; q = realloc(p, 80); return *p + *q; }
/* ! 0 bytes behind the end */
double l_memory_of_no_bytes(void) { char *p = malloc(0); return *p; }
/* ! 0 bytes behind the end */
double l_behind_memory_of_calloc(void) { double *p = calloc(3, 8); return p[3] + 1; }
/* = 0 */
double l_memory_of_calloc_is_0(void) { double *p = calloc(3, 8); int *q = calloc(5, 4); return p[0] + p[1] + p[2] + q[0] + q[4]; }
/* = 1 + 2 + 4 + 8 + 16 + 32 */
double l_memory_that_is_compared(void)
{
    extern int bcmp(const void *, const void *, size_t);
    return (memcmp("abc", "abd", 3) < 0) + 2 * (memcmp("abd", "abc", 3) > 0) + 4 * (memcmp("abc", "abd", 2) == 0) + 8 * (memcmp("abc", "abd", 0) == 0) + 16 * (bcmp("abc", "abd", 3) != 0) + 32 * (bcmp("abc", "abc", 4) == 0);
}
/* ! memcmp of numbers */
double l_numbers_that_are_compared_second(void) { double x[2] = {1.0 / 3, 1}; long n[2] = {0, 0}; return memcmp(n, x, sizeof n); }
/* ! memcmp of numbers */
double l_last_number_that_is_compared(void) { float x[3] = {1, 1, 1.0f / 3}; int n[3] = {0, 0, 0}; return memcmp(x, n, sizeof n); }
/* ! outside an array */
double l_compared_behind(void) { char *p = calloc(3, 1), q[8] = ""; return memcmp(p, q, 4); }
/* ! outside an array */
double l_second_compared_behind(void) { char *p = calloc(3, 1), q[8] = ""; return memcmp(q, p, 4); }
/* = 1 + 2 + 4 */
double l_what_copies_return(void) { double a[4] = {1, 2, 3, 4}, b[4]; return (memcpy(b, a, 16) == b) + 2 * (memmove(a + 1, a, 16) == a + 1) + 4 * (memset(b, 0, 8) == b); }
/* = 1 + 2 * 10 + 2 * 100 + 3 * 1000 */
double l_moved_up_and_down(void) { double a[4] = {1, 2, 3, 4}; memmove(a + 2, a + 1, 16); memmove(a, a, 8); return a[0] + 10 * a[1] + 100 * a[2] + 1000 * a[3]; }
/* ! memcpy of 24 bytes to 16 bytes behind, which overlap */
double l_copied_up_over_itself(void) { double *a = calloc(5, 8); memcpy(a + 2, a, 24); return a[0]; }
/* ! memcpy of 24 bytes to 8 bytes before, which overlap */
double l_copied_down_over_itself(void) { double *a = calloc(5, 8); memcpy(a, a + 1, 24); return a[0]; }
/* = 1 */
double l_copied_side_by_side(void) { double a[4] = {1, 2, 3, 4}; memcpy(a + 2, a, 16); memcpy(a, a, 16); memcpy(a, a + 1, 0); return a[2]; }
