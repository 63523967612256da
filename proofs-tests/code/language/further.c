/* What C has that no other file here uses: initialisers, qualifiers, tables, the rarer operators and library functions. */
#include <assert.h>
#include <errno.h>
#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdalign.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <tgmath.h>

/* = F(3, 16) */
double g_hexadecimal_literal(void) { return 0x1.8p-3; }
/* = F(1, 3) + 8 */
double g_aligned(void) { alignas(64) double x[2] = {1.0 / 3, 1}; return x[0] + (double)(((size_t)x % 64 == 0) ? alignof(double) : 0); }
_Static_assert(sizeof(double) == 8, "a double has 64 bits");
enum rule { MIDPOINT = 1, SIMPSON = 4 };
/* = F(4, 3) */
double g_enumeration(void) { enum rule r = SIMPSON; return r / 3.0; }
struct tagged { enum { SCALAR, PAIR } kind; union { double x; struct { double a, b; }; }; };
static double value_of(const struct tagged *t) { switch (t->kind) { case SCALAR: return t->x; case PAIR: return t->a * t->b; } return 0; }
/* = F(1, 3) + F(2, 35) */
double g_anonymous_members(void) { struct tagged s = {.kind = SCALAR, .x = 1.0 / 3}, p = {.kind = PAIR, .a = 1.0 / 5, .b = 2.0 / 7}; return value_of(&s) + value_of(&p); }
static double trace(int n, double m[n][n]) { double s = 0; for (int i = 0; i < n; i++) s += m[i][i]; return s; }
/* = F(1, 3) + F(5, 3) + F(9, 3) */
double g_matrix_of_variable_size(void) { double m[3][3]; for (int i = 0; i < 9; i++) m[i / 3][i % 3] = (i + 1) / 3.0; return trace(3, m); }
static double first(const double p[static 2]) { return p[0] - p[1]; }
/* = F(1, 3) - F(1, 7) */
double g_static_parameter(void) { double p[2] = {1.0 / 3, 1.0 / 7}; return first(p); }
static double twice(double x) { return x + x; }
static double half(double x) { return x / 2; }
static double (*const steps[])(double) = {twice, half, half};
/* = F(1, 6) */
double g_table_of_functions(void) { double x = 1.0 / 3; for (size_t k = 0; k < sizeof steps / sizeof *steps; k++) x = steps[k](x); return x; }
static double (*chosen(int n))(double) { return n > 0 ? twice : half; }
/* = F(2, 3) + F(1, 6) */
double g_function_that_returns_one(void) { return chosen(1)(1.0 / 3) + chosen(-1)(1.0 / 3); }
static double weighed(int n, va_list list) { va_list again; double s = 0, t = 0; va_copy(again, list); for (int i = 0; i < n; i++) s += va_arg(list, double);
    for (int i = 0; i < n; i++) t += (i + 1) * va_arg(again, double); va_end(again); return s * t; }
static double weigh(int n, ...) { va_list list; va_start(list, n); double s = weighed(n, list); va_end(list); return s; }
/* = (F(1, 3) + F(1, 5)) * (F(1, 3) + F(2, 5)) */
double g_arguments_read_twice(void) { return weigh(2, 1.0 / 3, 1.0 / 5); }
static struct tagged sent(int n, ...) { va_list list; va_start(list, n); struct tagged t = va_arg(list, struct tagged); va_end(list); return t; }
/* = F(2, 35) */
double g_structure_as_variable_argument(void) { struct tagged p = {.kind = PAIR, .a = 1.0 / 5, .b = 2.0 / 7}; struct tagged q = sent(1, p); return value_of(&q); }
static inline double squared(double x) { return x * x; }
/* = F(1, 9) */
double g_inline(void) { return squared(1.0 / 3); }
static const double table[] = {[3] = 0.5, [1] = 0.25, 2};
/* = F(1, 4) + 2 + F(1, 2) + 4 */
double g_designated_elements(void) { return table[1] + table[2] + table[3] + (double)(sizeof table / sizeof *table); }
/* = F(1, 3) + 8 */
double g_offset(void) { struct tagged t = {.kind = SCALAR, .x = 1.0 / 3}; double x; memcpy(&x, (char *)&t + offsetof(struct tagged, x), sizeof x); return x + (double)offsetof(struct tagged, x); }
static double below(jmp_buf back, int n, double *x) { *x += 1.0 / 3; if (n == 0) longjmp(back, 7); return below(back, n - 1, x); }
/* = 7 + F(4, 3) */
double g_longjmp_through_frames(void) { jmp_buf back; double x = 0; int n = setjmp(back); return n == 0 ? below(back, 3, &x) : n + x; }
static _Atomic(double) sum;
/* = F(1, 3) - F(1, 5) */
double g_atomic_operations(void) { atomic_init(&sum, 0); sum += 1.0 / 3; sum -= 1.0 / 5; return atomic_load(&sum); }
/* = F(2, 21) */
double g_atomic_product_and_quotient(void) { _Atomic double a = 1.0 / 3; a *= 2.0; a /= 7.0; return a; }
/* = F(1, 7) */
double g_atomic_compare_exchange(void) { _Atomic double a = 1.0 / 3; double had = a; return atomic_compare_exchange_strong(&a, &had, 1.0 / 7) ? a : 0; }
/* = 3 + F(1, 3) */
double g_atomic_counter_beside(void) { atomic_int n = 0; double x = 1.0 / 3; for (int i = 0; i < 3; i++) atomic_fetch_add(&n, 1); return n + x; }
/* = F(1, 3) */
double g_assertion(void) { double x = 1.0 / 3; assert(x * 3 == 1); return x; }
/* = F(2, 3) */
double g_type_generic(void) { double x = -2.0 / 3; return fabs(x); }
/* = 2 + F(1, 3) */
double g_fall_through(void) { double s = 1.0 / 3; switch (2) { case 2: s += 1; __attribute__((fallthrough)); case 3: s += 1; break; case 4: s = 0; } return s; }
/* = F(2, 3) */
double g_select_of_addresses(void) { double a = 1.0 / 3, b = 2.0 / 3; double *p = a < b ? &b : &a; return *p; }
/* = F(3, 7) */
double g_chosen_by_integer(void) { volatile int n = 1; double s = n ? 3.0 / 7 : 1.0 / 7; return s; }
/* = F(1, 3) */
double g_epsilon(void) { double x = 1.0 / 3; return 1 + DBL_EPSILON > 1 && DBL_MIN > 0 ? x : 0; }
/* = 5 + F(1, 2) */
double g_compound_assignments_of_integers(void) { int n = 3; n *= 1.5; n += 1.9; return n + 0.5; }
/* = F(1, 3) + F(2, 3) */
double g_array_of_structures_copied(void) { struct point { double x, y; } a[2] = {{1.0 / 3, 1}, {2.0 / 3, 2}}, b[2]; memcpy(b, a, sizeof a); return b[0].x + b[1].x; }
/* = F(10, 3) */
double g_pointer_differences(void) { double a[12]; for (int i = 0; i < 12; i++) a[i] = i / 3.0; double *p = a, *q = &a[10]; return p[q - p]; }
/* = F(5, 9) */
double g_comma_in_loops(void) { double s = 0; int i, j; for (i = 0, j = 5; i < j; i++, j--) s += j / 27.0 + i / 9.0 * 0; return s * 5 / 4; }
/* = F(1, 3) */
double g_errno(void) { errno = 0; double x = 1.0 / 3; return errno == 0 ? x : 0; }
/* = F(7, 3) */
double g_negative_index(void) { double a[9]; for (int i = 0; i < 9; i++) a[i] = i / 3.0; const double *p = a + 8; return p[-1]; }
/* ! which overlap */
double g_structure_assigned_over_itself(void)
{
    struct three { double x[3]; };
    double *p = calloc(4, sizeof *p);
    *(struct three *)p = *(struct three *)(p + 1); // here
    return p[0];
}
/* = F(1, 3) */
double g_structure_assigned_to_itself(void) { struct three { double x[3]; } s = {{1.0 / 3, 1, 2}}, *p = &s; s = *p; return s.x[0]; }
