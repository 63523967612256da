/* The C library by name. */
#include <math.h>
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
/* = 1 */
double l_sincos(void) { double s, c; sincos(0, &s, &c); return s + c; }
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
