/* What people write in C beyond what the other files here have: complex numbers, vectors, extensions of compilers, storage of every kind, bits,
 * and functions of the library; what is not carried is refused by name. */
#include <complex.h>
#include <ctype.h>
#include <fenv.h>
#include <limits.h>
#include <math.h>
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <wchar.h>
/* = 1 */
double z_csqrt(void) { double _Complex z = 9.0 / 4 * -1; return cimag(csqrt(z)) == 1.5; }
/* = F(1,3) */
double z_csqrt_real(void) { double _Complex z = 1.0 / 9; return creal(csqrt(z)); }
/* ! the function cpow */
double z_cpow(void) { double _Complex z = 1.0 / 3; return creal(cpow(z, 1)); }
/* ! the function cexp */
double z_cexp(void) { return creal(cexp(0)) / 3; }
/* = F(4,9) */
double z_float_complex(void) { float _Complex z = 2.0f / 3 * I; z *= z; return -crealf(z); }
/* = F(1,3) */
double z_complex_div_real(void) { double _Complex z = (1 + 2 * I) / 3; return creal(z); }
/* ! the function cproj */
double z_cproj(void) { double _Complex z = (1 + 2 * I) / 3; return cimag(cproj(z)); }
/* = F(5,9) */
double z_norm(void) { double _Complex z = (1 + 2 * I) / 3; return creal(z * conj(z)); }
struct pair { double x, y; };
/* ! the function __atomic_store, which is not in the sources */
double z_atomic_struct(void) { static _Atomic struct pair p; struct pair q = {1.0 / 3, 2}; atomic_store(&p, q); struct pair r = atomic_load(&p); return r.x; }
/* = F(1,3) */
double z_atomic_exchange_float(void) { _Atomic float p = 1.0f / 3; return atomic_exchange(&p, 2.0f); }
typedef double v4 __attribute__((vector_size(32)));
typedef long l4 __attribute__((vector_size(32)));
typedef float f4 __attribute__((vector_size(16)));
/* = F(3,7) */
double z_shuffle(void) { v4 a = {1 / 7.0, 2 / 7.0, 3 / 7.0, 4 / 7.0}; v4 b = __builtin_shufflevector(a, a, 2, 1, 0, 3); return b[0]; }
/* = 3 */
double z_convertvector(void) { v4 a = {7 / 2.0, 2 / 7.0, 3 / 7.0, 4 / 7.0}; l4 b = __builtin_convertvector(a, l4); return b[0]; }
/* = F(7,2) */
double z_select_by_mask(void) { v4 a = {7 / 2.0, 2 / 7.0, 3 / 7.0, 4 / 7.0}, b = {1, 1, 1, 1}; l4 m = a > b; return m[0] == -1 ? a[0] : b[0]; }
/* = F(2,7) */
double z_dynamic_lane(void) { v4 a = {7 / 2.0, 2 / 7.0, 3 / 7.0, 4 / 7.0}; volatile int k = 1; return a[k]; }
/* = F(2,7) */
double z_vector_memory(void) { double m[4] = {7 / 2.0, 2 / 7.0, 3 / 7.0, 4 / 7.0}; v4 a; memcpy(&a, m, sizeof a); v4 *p = &a; return (*p)[1]; }
/* ! bits */
double z_mask_and(void) { v4 a = {7 / 2.0, 2, 3, 4}; l4 m = (l4)a & (l4){-1, 0, 0, 0}; return ((v4)m)[0]; }
/* = 3 */
double z_switch_on_floor(void) { switch ((int)floor(11.0 / 3)) { case 3: return 3; default: return 0; } }
/* = F(1,3) */
double z_words_swapped_back(void) { double x = 1.0 / 3, y; uint32_t w[2]; memcpy(w, &x, 8); uint32_t v[2] = {w[0], w[1]}; memcpy(&y, v, 8); return y; }
/* = F(1,3) */
double z_bytes_by_loop(void) { double x = 1.0 / 3, y; for (size_t i = 0; i < sizeof x; i++) ((char *)&y)[i] = ((const char *)&x)[i]; return y; }
/* = F(1,3) */
double z_swap_bytes_generic(void) { double a = 1, b = 1.0 / 3; char *p = (char *)&a, *q = (char *)&b; for (int i = 0; i < 8; i++) { char c = p[i]; p[i] = q[i]; q[i] = c; } return a; }
/* ! bits */
double z_negate_by_xor(void) { union { double d; uint64_t u; } v = {1.0 / 3}; v.u ^= 1ull << 63; return v.d; }
/* ! bits */
double z_fast_root(void) { float x = 2.0f / 3; int32_t i; memcpy(&i, &x, 4); i = 0x5f3759df - (i >> 1); memcpy(&x, &i, 4); return x; }
/* ! bits */
double z_exponent_by_shift(void) { double x = 1.0 / 3; uint64_t u; memcpy(&u, &x, 8); return (double)((u >> 52) & 0x7ff); }
/* ! bits */
double z_equal_by_bits(void) { double x = 1.0 / 3, y = 2.0 / 6; uint64_t u, v; memcpy(&u, &x, 8); memcpy(&v, &y, 8); return u == v; }
/* ! memcmp of numbers */
double z_memcmp_equal(void) { double x[2] = {1.0 / 3, 1}, y[2] = {2.0 / 6, 1}; return memcmp(x, y, sizeof x) == 0; }
/* ! bits */
double z_hash(void) { double x = 1.0 / 3; unsigned h = 0; const unsigned char *p = (const unsigned char *)&x; for (int i = 0; i < 8; i++) h = h * 31 + p[i]; return h; }
/* = F(2,3) */
double z_statement_expression(void) { double x = ({ double y = 1.0 / 3; y * 2; }); return x; }
/* = F(1,3) */
double z_computed_goto(void) { static void *at[] = {&&one, &&two}; volatile int k = 1; goto *at[k]; one: return 1; two: return 1.0 / 3; }
/* = F(1,3) */
double z_case_range(void) { switch (5) { case 1 ... 7: return 1.0 / 3; } return 0; }
/* = F(1,3) */
double z_elvis(void) { double x = 1.0 / 3; return x ?: 7; }
/* = F(1,3) */
double z_typeof(void) { __typeof__(1.0) x = 1; return x / 3; }
/* = F(1,3) */
double z_builtins(void) { return __builtin_expect(1, 1) ? __builtin_fabs(-1.0 / 3) : __builtin_inf(); }
/* = F(4,3) */
double z_cleanup(void) { double s = 0; { double x = 1.0 / 3; s = x; } return s + 1; }
/* = F(1,3) */
double z_zero_array(void) { struct z { int n; double a[0]; }; struct z *p = malloc(sizeof *p + 2 * sizeof(double)); p->a[1] = 1.0 / 3; return p->a[1]; }
#pragma pack(push, 1)
struct odd { char c; double x; float y; };
#pragma pack(pop)
/* = F(1,3) + F(1,7) */
double z_packed_array(void) { struct odd o[3] = {{'a', 1.0 / 3, 1}, {'b', 1.0 / 7, 2}}; double s = 0; for (int i = 0; i < 3; i++) s += o[i].x; return s; }
/* = 0 */
double z_memset_zero(void) { double a[3]; memset(a, 0, sizeof a); return a[2]; }
/* ! never computed */
double z_bit_pattern_of_ones(void) { double a[3]; memset(a, 0xff, sizeof a); return a[2] + 1; }
/* = 2 */
double z_fegetround(void) { return fegetround() == FE_TONEAREST ? 2 : 0; }
/* ! another direction of rounding */
double z_fesetround(void) { fesetround(FE_UPWARD); double x = 1.0 / 3; return x; }
/* = 1 */
double z_fetestexcept(void) { feclearexcept(FE_ALL_EXCEPT); return fetestexcept(FE_DIVBYZERO) == 0; }
/* = -2 */
double z_ilogb(void) { return ilogb(1.0 / 3); }
/* = -2 */
double z_logb(void) { return logb(1.0 / 3); }
/* ! the function nextafter */
double z_nextafter(void) { return nextafter(1.0 / 3, 1); }
/* ! the function erf */
double z_erf(void) { return erf(1.0 / 3); }
/* ! the function drand48 */
double z_drand48(void) { return drand48(); }
/* = F(1,3) */
double z_strtold(void) { return strtod("0.25", 0) + 1.0 / 3 - 0.25; }
/* ! the function remquo */
double z_remquo(void) { int q; double r = remquo(8.0 / 3, 1, &q); return q == 3 ? r : 9; }
/* = F(1,3) */
double z_fmaxf(void) { return fmaxf(1.0f / 3, 0.25f); }
/* = 5 */
double z_isgreater(void) { double x = 1.0 / 3; return isgreater(x, 0.3) && islessequal(x, 0.5) && !isunordered(x, 1) ? 5 : 0; }
/* = 3 */
double z_countdown(void) { int n = 0; for (double x = 1; x > 0; x -= 1.0 / 3) n++; return n; }
/* = F(-2,3) */
double z_decrement(void) { double x = 1.0 / 3; --x; return x; }
/* = F(16, 3) */
double z_difftime(void) { return difftime(7, 2) + 1.0 / 3; }
/* = F(1, 9) + 10 * 9 */
double z_powi(void) { return __builtin_powi(1.0 / 3, 2) + 10 * __builtin_powi(1.0 / 3, -2); }
/* = 1 */
double z_bool(void) { _Bool b = 1.0 / 3; return b; }
/* ! outside the range of a signed integer of 8 bits */
double z_char_out_of_range(void) { double x = 1000.0 / 3; signed char c = x; return c; }
/* ! an integer of more than 64 bits */
double z_int128(void) { __int128 n = 1.0 / 3 * 9; return (double)n; }
/* ! 128 bits */
double z_float128(void) { __float128 q = 1.0 / 3; return (double)(q * 3); }
/* ! 16 bits */
double z_half(void) { __fp16 h = 1.0f / 3; return h; }
struct mixed { float x; int n; };
static struct mixed twice_mixed(struct mixed m) { m.x *= 2; m.n++; return m; }
/* = F(2,3) + 8 */
double z_float_and_int_by_value(void) { struct mixed m = twice_mixed((struct mixed){1.0f / 3, 7}); return m.x + m.n; }
struct three { float a, b, c; };
static struct three turned(struct three t) { return (struct three){t.c, t.a, t.b}; }
/* = F(1,3) */
double z_three_floats_by_value(void) { return turned((struct three){1, 2, 1.0f / 3}).a; }
struct dc { double x; char c; };
static struct dc same(struct dc d) { return d; }
/* = F(1,3) + 7 */
double z_double_and_char_by_value(void) { struct dc d = same((struct dc){1.0 / 3, 7}); return d.x + d.c; }
union either { double d; long n; };
static union either keep(union either e) { return e; }
/* = F(1,3) */
double z_union_by_value(void) { return keep((union either){1.0 / 3}).d; }
static double va_struct(int n, ...) { va_list l; va_start(l, n); double s = 0; for (int i = 0; i < n; i++) { struct dc d = va_arg(l, struct dc); s += d.x * d.c; } va_end(l); return s; }
/* = F(1,3) * 2 + F(1,7) * 3 */
double z_variable_structs(void) { return va_struct(2, (struct dc){1.0 / 3, 2}, (struct dc){1.0 / 7, 3}); }
static double many(double a, double b, double c, double d, double e, double f, double g, double h, double i, double j) { return a + 10 * j + i * h; }
/* = F(1,3) + F(10,7) + 4 */
double z_many_parameters(void) { return many(1.0 / 3, 0, 0, 0, 0, 0, 0, 2, 2, 1.0 / 7); }
static double sum_vla(int n, int m, double a[n][m]) { double s = 0; for (int i = 0; i < n; i++) for (int j = 0; j < m; j++) s += a[i][j]; return s + sizeof(a[0]) / sizeof(double); }
/* = 2 + F(15,7) */
double z_vla_parameter(void) { int n = 3; double a[n][2]; for (int i = 0; i < 6; i++) a[i / 2][i % 2] = i / 7.0; return sum_vla(n, 2, a); }
/* = F(1,3) */
double z_vla_pointer(void) { int n = 4; double (*p)[n] = malloc(sizeof(double[2][n])); p[1][3] = 1.0 / 3; return p[1][3]; }
static jmp_buf back;
static volatile double kept;
static void leap(double x) { kept = x; longjmp(back, 2); }
/* = F(1,3) + 2 */
double z_longjmp_global(void) { int n = setjmp(back); if (n == 0) leap(1.0 / 3); return kept + n; }
static int count;
static void handler(int s) { (void)s; count++; }
/* = F(1,3) + 1 */
double z_signal(void) { signal(SIGUSR1, handler); raise(SIGUSR1); return count + 1.0 / 3; }
static _Thread_local double own[2] = {0.5};
/* = F(5,6) */
double z_thread_local_array(void) { own[1] = 1.0 / 3; return own[0] + own[1]; }
/* = F(1,3) */
double z_once(void) { static atomic_flag f = ATOMIC_FLAG_INIT; return atomic_flag_test_and_set(&f) ? 0 : 1.0 / 3; }
/* = F(1,3) */
double z_open_memstream(void) { char *t; size_t n; FILE *f = open_memstream(&t, &n); fprintf(f, "%.3f|%g", 1.0 / 3, 0.5); fclose(f); int ok = strcmp(t, "1/3|1/2") == 0; return ok ? 1.0 / 3 : n; }
/* = F(5,4) */
double z_read_file(void) { FILE *f = tmpfile(); fputs("1.25 7", f); rewind(f); double x; int n; int r = fscanf(f, "%lf %d", &x, &n); return r == 2 && n == 7 ? x : 0; }
/* = F(1,3) */
double z_fwrite(void) { FILE *f = tmpfile(); double x = 1.0 / 3, y = 0; fwrite(&x, sizeof x, 1, f); rewind(f); size_t n = fread(&y, sizeof y, 1, f); return n ? y : 0; }
/* = F(1,4) + F(1,3) */
double z_strtof(void) { return strtof("0.25x", 0) + 1.0 / 3; }
static double integrate(double (*f)(double, void *), void *data) { return (f(0, data) + 4 * f(0.5, data) + f(1, data)) / 6; }
static double square_scaled(double x, void *data) { return x * x * *(double *)data; }
/* = F(1,9) */
double z_callback_data(void) { double s = 1.0 / 3; return integrate(square_scaled, &s); }
static int by_x(const void *a, const void *b) { const struct pair *p = a, *q = b; return (p->x > q->x) - (p->x < q->x); }
/* = F(1,7) */
double z_qsort_structs(void) { struct pair p[20]; for (int i = 0; i < 20; i++) p[i] = (struct pair){(double)((i * 7) % 20 + 1) / 7, i}; qsort(p, 20, sizeof *p, by_x); return p[0].x; }
/* = 1 */
double z_lfind(void) { double a[3] = {1.0 / 3, 2, 3}; return (double)(a[0] == 2.0 / 6); }
/* = F(1,3) */
double z_reallocarray(void) { double *p = reallocarray(0, 3, sizeof *p); p[2] = 1.0 / 3; p = reallocarray(p, 30, sizeof *p); return p[2]; }
/* ! never computed */
double z_reallocarray_never(void) { double *p = reallocarray(0, 3, sizeof *p); p[2] = 1.0 / 3; p = reallocarray(p, 30, sizeof *p); return p[20] + 1; }
/* ! never computed */
double z_valloc(void) { double *p = valloc(64); return p[2] + 1; }
/* = F(1,3) */
double z_pvalloc(void) { extern void *pvalloc(size_t); char *p = pvalloc(5000); memset(p, 1, 8192); return p[8191] == 1 && ((uintptr_t)p & 4095) == 0 ? 1.0 / 3 : 0; }
/* ! behind the end of */
double z_pvalloc_behind(void) { extern void *pvalloc(size_t); char *p = pvalloc(5000); p[8192] = 1; return p[8192]; }
/* ! never computed */
double z_memalign(void) { extern void *memalign(size_t, size_t); double *p = memalign(64, 64); return p[2] + 1; }
/* = F(1,3) */
double z_strdup(void) { char *s = strdup("0.25"); double x = atof(s); free(s); return x + 1.0 / 3 - 0.25; }
/* = F(1,3) */
double z_getline(void) { FILE *f = tmpfile(); fputs("hello\n", f); rewind(f); char *l = 0; size_t n = 0; ssize_t r = getline(&l, &n, f); free(l); return r == 6 ? 1.0 / 3 : 0; }
/* = F(1,3) */
double z_clock(void) { return time(0) > 0 ? 1.0 / 3 : 0; }
/* = F(1,3) */
double z_ternary_lvalue(void) { double a = 1, b = 2; *(a < b ? &a : &b) = 1.0 / 3; return a; }
/* = 6 */
double z_popcount(void) { return __builtin_popcount(63); }
/* = F(1,3) */
double z_overflow(void) { int r; return __builtin_mul_overflow(INT_MAX, 2, &r) ? 1.0 / 3 : 0; }
/* ! long double */
double z_long_double_literal(void) { return (double)(1.0L / 3); }
/* ! long double */
double z_long_double_print(void) { char t[50]; snprintf(t, 50, "%Lf", 1.0L); return t[0] - '0'; }
/* ! the function sqrtl */
double z_long_double_sqrt(void) { return (double)sqrtl(4.0L); }
/* = F(1,3) */
double z_printed_and_read(void) { char t[99]; snprintf(t, 99, " %.17g", 1.0 / 3); char *e; double x = strtod(t, &e); return *e == 0 ? x : 9; }
/* = F(-22,7) + F(1,4) */
double z_atof_of_a_fraction(void) { return atof("-22/7 m") + atof("0.25/2"); }
/* = F(1,3) */
double z_strtof_of_a_fraction(void) { return strtof("1/3", 0); }
/* ! scanf of a fraction */
double z_sscanf_of_a_fraction(void) { char t[99]; double x; snprintf(t, 99, "%g", 1.0 / 3); return sscanf(t, "%lf", &x) + x; }
/* = F(1,3) + 12 */
double z_sscanf_of_a_date(void) { int d, m; sscanf("12/05", "%d/%d", &d, &m); return d + 1.0 / 3; }
/* ! scanf of a fraction */
double z_fscanf_of_a_fraction(void) { FILE *f = tmpfile(); double x; fprintf(f, "%g\n", 1.0 / 3); rewind(f); return fscanf(f, "%lf", &x) + x; }
/* ! memcmp of numbers */
double z_bcmp(void) { extern int bcmp(const void *, const void *, size_t); float a[2] = {1.0f / 3, 1}, b[2] = {2.0f / 6, 1}; return bcmp(a, b, sizeof a); }
/* = 3 */
double z_memcmp_of_integers(void) { int a[3] = {1, 2, 3}, b[3] = {1, 2, 3}; return memcmp(a, b, sizeof a) == 0 ? 3 : 0; }
/* ! malloc_usable_size */
double z_usable(void) { extern size_t malloc_usable_size(void *); double *p = malloc(20); return malloc_usable_size(p); }
/* ! outside an array */
double z_behind_reallocarray(void) { double *p = reallocarray(0, 3, sizeof *p); return p[3] + 1; }
/* ! the exponent of 0 */
double z_logb_of_zero(void) { double x = 0; return logb(x); }
/* = F(-1,3) */
double z_csqrt_below_the_axis(void) { double _Complex z = -1.0 / 9 - 0.0 * I, w = (-1 - 2 * I) * (-1 - 2 * I) / 9; return cimag(csqrt(w)) < 0 ? creal(w) : -cimag(csqrt(w)) / 2 + 0 * creal(z); }
